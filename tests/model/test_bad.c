// Every diagnostic that a file can cause has a small file in tests/bad/ that causes it.
#include <dirent.h>
#include <stdio.h>
#include <stdlib.h>
#include "model/fixture.h"

enum { FILES_MAX = 500 };
static char names[FILES_MAX][300];
static size_t file_count;

static int list_files(void **state)
{
    (void)state;
    DIR *folder = opendir(YOKE_ROOT "/tests/bad");
    if (!folder) return -1;
    for (const struct dirent *entry = readdir(folder); entry && file_count < FILES_MAX; entry = readdir(folder)) {
        if (strstr(entry->d_name, ".yaml")) snprintf(names[file_count++], sizeof names[0], "%s", entry->d_name);
    }
    closedir(folder);
    return file_count > 0 ? 0 : -1;
}

static YkProblems *load(const char *name, int *has_model)
{
    char path[600];
    snprintf(path, sizeof path, YOKE_ROOT "/tests/bad/%s", name);
    YkProblems *problems = yk_problems_new();
    YkModel *model = yk_model_load(path, NULL, problems);
    *has_model = model != NULL;
    yk_model_free(model);
    return problems;
}

// "E0401-unknown-body.yaml": the code, and the severity it must have there.
static void each_file_causes_the_problem_in_its_name_at_a_place(void **state)
{
    (void)state;
    int wrong = 0, has_model = 0;
    for (size_t i = 0; i < file_count; i++) {
        int code = atoi(names[i] + 1);
        YkSeverity severity = names[i][0] == 'E'   ? YK_SEVERITY_ERROR
                              : names[i][0] == 'W' ? YK_SEVERITY_WARNING
                                                   : YK_SEVERITY_NOTE;
        YkProblems *problems = load(names[i], &has_model);
        const YkProblem *problem = fixture_problem(problems, code);
        if (!problem || problem->place.line == 0 || problem->place.column == 0 || problem->severity != severity ||
            has_model != (severity != YK_SEVERITY_ERROR)) {
            print_error("%s:\n%s\n", names[i], yk_problems_text(problems, 0));
            wrong++;
        }
        yk_problems_free(problems);
    }
    assert_int_equal(wrong, 0);
}

// A message is a sentence without a stop; text and explanation exist.
static void each_problem_is_told_in_the_same_form(void **state)
{
    (void)state;
    int wrong = 0, has_model = 0;
    for (size_t i = 0; i < file_count; i++) {
        YkProblems *problems = load(names[i], &has_model);
        for (size_t k = 0; k < yk_problems_count(problems); k++) {
            const YkProblem *problem = yk_problems_get(problems, k);
            size_t length = strlen(problem->message);
            int is_good = length > 0 && problem->message[length - 1] != '.' && !strstr(problem->message, "(null)") &&
                          yk_code_explain(problem->code) && (!problem->hint || problem->hint[0]);
            if (!is_good) print_error("%s: %s\n", names[i], problem->message);
            wrong += !is_good;
        }
        yk_problems_free(problems);
    }
    assert_int_equal(wrong, 0);
}

// No file holds what these speak of: the machine's memory, too many problems, the file system, values from outside,
// and a file of ten million entries.
static const int not_by_a_file[] = {
    YK_CODE_OUT_OF_MEMORY,    YK_CODE_MORE_PROBLEMS,      YK_CODE_FILE_NOT_FOUND,
    YK_CODE_FILE_DIRECTORY,   YK_CODE_FILE_UNREADABLE,    YK_CODE_FILE_TOO_LARGE,
    YK_CODE_UNKNOWN_OVERRIDE, YK_CODE_OVERRIDE_DIMENSION, YK_CODE_TOO_MANY,
    YK_CODE_RING_ANGLE,       YK_CODE_RING_DIVISOR,       YK_CODE_RING_SIZE}; // of equations, not of files

static int has_file(int code)
{
    for (size_t i = 0; i < file_count; i++) {
        if (atoi(names[i] + 1) == code) return 1;
    }
    return 0;
}

static void each_code_of_a_file_has_a_file(void **state)
{
    (void)state;
    int missing = 0;
    for (size_t i = 0; i < yk_code_count(); i++) {
        int code = yk_code_at(i), is_needed = code < 500;
        for (size_t k = 0; k < sizeof not_by_a_file / sizeof *not_by_a_file; k++) {
            if (not_by_a_file[k] == code) is_needed = 0;
        }
        if (is_needed == has_file(code)) continue;
        print_error("E%04d: %s\n", code, is_needed ? "no file in tests/bad causes it" : "a file, but listed without");
        missing++;
    }
    assert_int_equal(missing, 0);
}

// Cut anywhere, a file must be loaded or refused, never more.
static void every_beginning_of_a_bad_file_is_survived(void **state)
{
    (void)state;
    for (size_t i = 0; i < file_count; i++) {
        char path[600], text[2000];
        snprintf(path, sizeof path, YOKE_ROOT "/tests/bad/%s", names[i]);
        FILE *file = fopen(path, "rb");
        assert_non_null(file);
        size_t length = fread(text, 1, sizeof text, file);
        fclose(file);
        for (size_t cut = 0; cut <= length; cut += length > 300 ? 7 : 1) {
            YkProblems *problems = yk_problems_new();
            YkModel *model = yk_model_parse(text, cut, "cut", NULL, problems);
            assert_int_equal(model == NULL, yk_problems_error_count(problems) > 0);
            yk_model_free(model);
            yk_problems_free(problems);
        }
    }
}

// Random damage: bytes replaced, dropped, doubled, or pieces swapped for words of the format.
static size_t damage(char *text, size_t length, uint64_t *seed)
{
    static const char *const words[] = {"{",     "}",      "[",     "]", ": ",   ", ",    "x",     "-1",
                                        "1e9",   "ground", "crank", "O", "rod",  "angle", "theta", "pin",
                                        "slide", "''",     "~",     "0", "mass", ".rate", "t",     "\n"};
    for (int i = 0; i < 3; i++) {
        const char *word = words[check_random(seed) % (sizeof words / sizeof *words)];
        size_t at = check_random(seed) % (length + 1), size = strlen(word), cut = check_random(seed) % 5;
        if (at + cut > length) cut = length - at;
        memmove(text + at + size, text + at + cut, length - at - cut);
        memcpy(text + at, word, size);
        length = length - cut + size;
    }
    return length;
}

static void a_damaged_file_is_loaded_or_refused(void **state)
{
    (void)state;
    static const char sound[] =
        "units: {length: mm}\nparameters: {l: 100, m: 2 kg}\ngravity: [0, -9.81 m/s^2]\nbodies:\n"
        "  ground: {points: {O: [0, 0], Q: [5, 0]}}\n"
        "  crank: {points: {O: [0, 0], A: [l, 0]}, mass: m, rod: [O, A]}\n"
        "  link: {points: {A: [0, 0]}, mass: 1, inertia: 2}\njoints:\n"
        "  O: {pin: [ground, crank], angle: theta}\n  A: {pin: [crank, link], at: A}\n"
        "  S: {pin-slot: [ground, link], at: A, from: Q, along: 30 deg, distance: s, friction: {coulomb: 0.1}}\n"
        "drives: {theta: 2 rad/s * t}\nstart: {s: 3, S.angle.rate: 1}\nefforts: {s: -3 * s}\n"
        "forces: {F: {body: link, at: A, value: [-3 N, 2*s], axes: body, moment: theta.rate}}\n"
        "springs: {k: {between: [ground.Q, crank.A], stiffness: 8 N/m, length: l/2}, c: {along: s, damping: 2}}\n"
        "stops: {theta: [-3, 3], s: {between: [0, 5], restitution: 0.5}}\n";
    for (uint64_t round = 0; round < 3000; round++) {
        char text[sizeof sound + 100];
        uint64_t seed = round;
        memcpy(text, sound, sizeof sound);
        size_t length = damage(text, sizeof sound - 1, &seed);
        YkProblems *problems = yk_problems_new();
        YkModel *model = yk_model_parse(text, length, "damaged", NULL, problems);
        if ((model == NULL) != (yk_problems_error_count(problems) > 0)) print_error("seed %d\n", (int)round);
        assert_int_equal(model == NULL, yk_problems_error_count(problems) > 0);
        assert_non_null(yk_problems_text(problems, 0));
        yk_model_free(model);
        yk_problems_free(problems);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(each_file_causes_the_problem_in_its_name_at_a_place),
        cmocka_unit_test(each_problem_is_told_in_the_same_form),
        cmocka_unit_test(each_code_of_a_file_has_a_file),
        cmocka_unit_test(every_beginning_of_a_bad_file_is_survived),
        cmocka_unit_test(a_damaged_file_is_loaded_or_refused),
    };
    return cmocka_run_group_tests(tests, list_files, NULL);
}
