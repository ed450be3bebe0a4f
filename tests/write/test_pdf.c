// Pages as PDF, by a stand-in for the browser: what it is given, and that nothing is left behind.
#include "check.h"
#include <dirent.h>
#include <stdlib.h>
#include <sys/stat.h>
#include <unistd.h>
#include "base/codes.h"
#include "write/pdf.h"

typedef struct Place {
    char folder[64], path[80], *old_path;
} Place;

// A folder of our own that is the PATH and the place for temporary files; `script` stands there as chromium.
static Place open_place(const char *script)
{
    Place place = {.folder = "/tmp/yoke-print-XXXXXX"};
    assert_non_null(mkdtemp(place.folder));
    snprintf(place.path, sizeof place.path, "%s/chromium", place.folder);
    if (script) {
        FILE *file = fopen(place.path, "w");
        assert_non_null(file);
        fprintf(file, "#!/bin/sh\n%s\n", script);
        fclose(file);
        assert_int_equal(chmod(place.path, 0755), 0);
    }
    place.old_path = strdup(getenv("PATH"));
    setenv("PATH", place.folder, 1);
    setenv("TMPDIR", place.folder, 1);
    return place;
}

// Everything but the browser is gone again.
static void close_place(Place *place)
{
    size_t left = 0;
    setenv("PATH", place->old_path, 1);
    unsetenv("TMPDIR");
    free(place->old_path);
    unlink(place->path);
    DIR *folder = opendir(place->folder);
    while (readdir(folder)) left++;
    closedir(folder);
    assert_int_equal(left, 2); // . and ..
    rmdir(place->folder);
}

static int print(const char *html, YkText *output)
{
    YkProblems *problems = yk_problems_new();
    bool good = yk_print_pdf(html, output, problems);
    int code = good ? 0 : yk_problems_get(problems, 0)->code;
    assert_int_equal(yk_problems_count(problems), good ? 0 : 1);
    yk_problems_free(problems);
    return code;
}

// The stand-in copies the page that it is told to print, and leaves a profile as browsers do.
static const char copies[] = "for word; do case $word in\n"
                             "--print-to-pdf=*) to=${word#*=} ;;\n"
                             "--user-data-dir=*) /bin/mkdir -p \"${word#*=}/deep\"; : >\"${word#*=}/deep/file\" ;;\n"
                             "file://*) from=${word#file://} ;;\nesac; done\n/bin/cat \"$from\" >\"$to\"";

static void the_page_goes_through_the_browser(void **state)
{
    (void)state;
    Place place = open_place(copies);
    YkText output = {0};
    assert_int_equal(print("<p>page</p>", &output), 0);
    assert_string_equal(yk_text_get(&output), "<p>page</p>");
    yk_text_free(&output);
    close_place(&place);
}

static void a_browser_that_fails_is_told(void **state)
{
    (void)state;
    YkText output = {0};
    Place place = open_place("echo no display >&2; exit 3");
    assert_int_equal(print("<p>page</p>", &output), YK_CODE_PROGRAM_FAILED);
    close_place(&place);
    place = open_place("exit 0"); // reports success, but there is no page
    assert_int_equal(print("<p>page</p>", &output), YK_CODE_PROGRAM_FAILED);
    close_place(&place);
    place = open_place(NULL);
    assert_int_equal(print("<p>page</p>", &output), YK_CODE_PROGRAM_MISSING);
    close_place(&place);
    assert_int_equal(output.length, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_page_goes_through_the_browser),
        cmocka_unit_test(a_browser_that_fails_is_told),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
