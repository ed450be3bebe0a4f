// Prints HTML to PDF. The browser needs files: both are in a folder of their own, which is removed afterwards.
#include "write/pdf.h"
#include <dirent.h>
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>
#include "base/problems.h"
#include "write/file.h"
#include "write/process.h"

static const char purpose[] = "printing a page as PDF";

static const char *const browsers[] = {"chromium", "chromium-browser", "google-chrome", "google-chrome-stable",
                                       "chrome"};

static void remove_tree(const char *path)
{
    struct stat about;
    DIR *folder = lstat(path, &about) == 0 && S_ISDIR(about.st_mode) ? opendir(path) : NULL;
    for (struct dirent *entry; folder && (entry = readdir(folder));) {
        if (strcmp(entry->d_name, ".") == 0 || strcmp(entry->d_name, "..") == 0) continue;
        YkText inside = {0};
        yk_text_format(&inside, "%s/%s", path, entry->d_name);
        if (!inside.failed) remove_tree(yk_text_get(&inside));
        yk_text_free(&inside);
    }
    if (folder) closedir(folder);
    remove(path);
}

static bool read_file(const char *path, YkText *text)
{
    FILE *file = fopen(path, "rb");
    char chunk[16384];
    size_t got, before = text->length;
    if (!file && errno == ENOMEM) yk_text_fail(text);
    if (!file) return false;
    while ((got = fread(chunk, 1, sizeof chunk, file)) > 0) yk_text_add(text, chunk, got);
    bool good = !ferror(file) && !text->failed && text->length > before;
    fclose(file);
    return good;
}

// Prints page.html into page.pdf with the first browser that exists.
static bool run(const char *folder, YkProblems *problems)
{
    YkText page = {0}, print = {0}, profile = {0}, said = {0}, nothing = {0};
    YkProblems *own = NULL;
    bool good = false;
    yk_text_format(&page, "file://%s/page.html", folder);
    yk_text_format(&print, "--print-to-pdf=%s/page.pdf", folder);
    yk_text_format(&profile, "--user-data-dir=%s/profile", folder);
    // A browser's own sandbox needs a user other than root.
    const char *words[] = {NULL,
                           "--headless",
                           "--disable-gpu",
                           "--no-first-run",
                           "--disable-background-networking",
                           "--disable-component-update",
                           "--disable-sync",
                           "--disable-extensions",
                           "--no-pdf-header-footer",
                           "--virtual-time-budget=4000",
                           yk_text_get(&profile),
                           yk_text_get(&print),
                           geteuid() == 0 ? "--no-sandbox" : "--disable-default-apps",
                           yk_text_get(&page),
                           NULL};
    for (size_t k = 0; k < sizeof browsers / sizeof *browsers && !good; k++) {
        yk_problems_free(own);
        own = yk_problems_new();
        words[0] = browsers[k];
        good = own && !page.failed && !print.failed && !profile.failed &&
               yk_process_filter(words, purpose, &nothing, &said, own);
        if (own && !good && yk_problems_count(own) > 0 && yk_problems_get(own, 0)->code != YK_CODE_PROGRAM_MISSING)
            break;
    }
    if (!good && own && yk_problems_count(own) > 0 && yk_problems_get(own, 0)->code == YK_CODE_PROGRAM_MISSING) {
        yk_problem(problems, YK_CODE_PROGRAM_MISSING, (YkPlace){0},
                   "%s needs the program `chromium` (or Chrome), which is not on the PATH", purpose);
        yk_problem_hint(problems, "write the page as .html and print it from any browser");
    } else if (!good && own && yk_problems_count(own) > 0 && !yk_problems_ran_out(own)) {
        yk_problem(problems, YK_CODE_PROGRAM_FAILED, (YkPlace){0}, "%s", yk_problems_get(own, 0)->message);
    } else if (!good) {
        yk_problem(problems, YK_CODE_OUT_OF_MEMORY, (YkPlace){0}, "out of memory");
    }
    yk_problems_free(own);
    yk_text_free(&page);
    yk_text_free(&print);
    yk_text_free(&profile);
    yk_text_free(&said);
    return good;
}

bool yk_print_pdf(const char *html, YkText *output, YkProblems *problems)
{
    const char *where = getenv("TMPDIR");
    YkText folder = {0}, path = {0};
    bool good = false;
    yk_text_format(&folder, "%s/yoke.XXXXXX", where && *where ? where : "/tmp");
    if (folder.failed || !mkdtemp(folder.data)) {
        yk_problem(problems, folder.failed ? YK_CODE_OUT_OF_MEMORY : YK_CODE_OUTPUT_FAILED, (YkPlace){0},
                   "cannot make a temporary folder for %s", purpose);
    } else {
        yk_text_format(&path, "%s/page.html", yk_text_get(&folder));
        good = yk_file_write(yk_text_get(&path), html, strlen(html), problems) && run(yk_text_get(&folder), problems);
        yk_text_clear(&path);
        yk_text_format(&path, "%s/page.pdf", yk_text_get(&folder));
        if (good && !read_file(yk_text_get(&path), output)) {
            yk_problem(problems, path.failed || output->failed ? YK_CODE_OUT_OF_MEMORY : YK_CODE_PROGRAM_FAILED,
                       (YkPlace){0}, "%s failed and wrote no page", purpose);
            good = false;
        }
        remove_tree(yk_text_get(&folder));
    }
    yk_text_free(&path);
    yk_text_free(&folder);
    return good;
}
