// Files of distributions: what they say, in units and by parameters; what is refused, and where; failed allocations.
#include <unistd.h>
#include "../interposed.h"
#include "base/problems.h"
#include "study_check.h"

static const char model_text[] = "parameters: {a: 40 mm, b: 2*a, phi: 30 deg}\n"
                                 "bodies: {ground: {points: {O: [0, 0]}}, arm: {points: {O: [0, 0], P: [b, 0]}}}\n"
                                 "joints: {O: {pin: [ground, arm], angle: q}}\n";

// Loads a text as a file. The file is gone afterwards.
static YkTolerances *load(const char *text, const YkModel *model, YkProblems *problems)
{
    char path[] = "/tmp/yoke-tolerances-XXXXXX";
    int file = mkstemp(path);
    assert_true(file >= 0 && write(file, text, strlen(text)) == (ssize_t)strlen(text));
    close(file);
    YkTolerances *t = yk_tolerances_load(path, model, problems);
    unlink(path);
    return t;
}

static void test_values_have_units_and_parameters(void **unused)
{
    (void)unused;
    Machine m = machine_parse(model_text, false);
    YkTolerances *t = load("seed: 7\ndesigns: 500\n"
                           "parameters:\n"
                           "  phi: {normal: [30 deg, 0.1 deg], within: [29 deg, 31 deg]}\n"
                           "  a: {uniform: [39 mm, a + 2 mm]}\n"
                           "  b: {tolerance: 0.5 mm}\n",
                           m.model, m.problems);
    assert_non_null(t);
    assert_int_equal(yk_tolerances_seed(t), 7);
    assert_int_equal(yk_tolerances_designs(t), 500);
    assert_int_equal(yk_tolerances_count(t), 3);
    static const char *const names[] = {"phi", "a", "b"}; // as in the file
    const double degree = YK_PI / 180;
    const YkDistribution due[] = {{YK_DISTRIBUTION_NORMAL, 29 * degree, 31 * degree, 30 * degree, 0.1 * degree},
                                  {YK_DISTRIBUTION_UNIFORM, 0.039, 0.042, 0, 0},
                                  {YK_DISTRIBUTION_UNIFORM, 0.0795, 0.0805, 0, 0}};
    for (size_t k = 0; k < 3; k++) {
        YkDistribution d = yk_tolerances_at(t, k);
        assert_string_equal(yk_tolerances_name(t, k), names[k]);
        assert_int_equal(d.kind, due[k].kind);
        CHECK_NEAR(d.low, due[k].low, 1e-15);
        CHECK_NEAR(d.high, due[k].high, 1e-15);
        CHECK_NEAR(d.center, due[k].center, 1e-15);
        CHECK_NEAR(d.spread, due[k].spread, 1e-15);
    }
    assert_null(yk_tolerances_name(t, 3));
    assert_true(isnan(yk_tolerances_at(t, YK_NOT_FOUND).low));
    yk_tolerances_free(t);
    t = load("parameters: {a: {triangular: [39 mm, 41 mm, 42 mm]}, phi: {normal: [0.5 rad, 0.1 rad]}}\n", m.model,
             m.problems);
    assert_non_null(t);
    YkDistribution mode = yk_tolerances_at(t, 0), open = yk_tolerances_at(t, 1);
    assert_true(mode.kind == YK_DISTRIBUTION_TRIANGULAR && open.low == -INFINITY && open.high == INFINITY);
    CHECK_NEAR(mode.low, 0.039, 1e-15);
    CHECK_NEAR(mode.center, 0.041, 1e-15);
    CHECK_NEAR(mode.high, 0.042, 1e-15);
    assert_true(yk_tolerances_seed(t) == 1 && yk_tolerances_designs(t) == 0);
    assert_int_equal(yk_problems_count(m.problems), 0);
    yk_tolerances_free(t);
    yk_tolerances_free(NULL);
    machine_free(&m);
}

static void test_what_is_wrong_is_told_with_its_place(void **unused)
{
    (void)unused;
    static const struct {
        const char *text, *message;
        int line, column;
    } cases[] = {
        {"x: 1\n", "has a section `parameters`", 1, 1},
        {"- a\n", "has a section `parameters`", 1, 1},
        {"parameters: {}\n", "has a section `parameters`", 1, 1},
        {"parameters: [a]\n", "has a section `parameters`", 1, 1},
        {"parameters: {a: {tolerance: 1 mm}}\nsed: 1\n", "no `sed`", 2, 1},
        {"seed: -1\nparameters: {a: {tolerance: 1 mm}}\n", "`seed` is a whole number", 1, 7},
        {"designs: 1.5\nparameters: {a: {tolerance: 1 mm}}\n", "`designs` is a whole number", 1, 10},
        {"designs: [3]\nparameters: {a: {tolerance: 1 mm}}\n", "`designs` is a whole number", 1, 10},
        {"parameters:\n  a: 3 mm\n", "`a` needs a distribution", 2, 6},
        {"parameters:\n  aa: {tolerance: 1 mm}\n", "no parameter `aa`", 2, 3},
        {"parameters:\n  a: {}\n", "needs one of uniform", 2, 6},
        {"parameters:\n  a: {uniform: [1 mm, 2 mm], tolerance: 1 mm}\n", "needs one of uniform", 2, 6},
        {"parameters:\n  a: {uniform: [1 mm, 2 mm], within: [1 mm, 2 mm]}\n", "needs one of uniform", 2, 6},
        {"parameters:\n  a: {uniform: [1 mm, 2 mm], with: 3}\n", "needs one of uniform", 2, 6},
        {"parameters:\n  a: {within: [1 mm, 2 mm]}\n", "needs one of uniform", 2, 6},
        {"parameters:\n  a: {uniform: [1 mm]}\n", "two values are expected", 2, 16},
        {"parameters:\n  a: {uniform: 1 mm}\n", "two values are expected", 2, 16},
        {"parameters:\n  a: {triangular: [1 mm, 2 mm]}\n", "three values are expected", 2, 19},
        {"parameters:\n  a: {normal: [1 mm, 1 mm], within: [0 mm]}\n", "two values are expected", 2, 37},
        {"parameters:\n  a: {uniform: [1 mm, [2 mm]]}\n", "a value is expected", 2, 23},
        {"parameters:\n  a: {tolerance: [1 mm]}\n", "a value is expected", 2, 18},
        {"parameters:\n  a: {uniform: [2 mm, 1 mm]}\n", "makes no sense", 2, 16},
        {"parameters:\n  a: {tolerance: -1 mm}\n", "makes no sense", 2, 18},
        {"parameters:\n  a: {tolerance: 0 mm}\n", "makes no sense", 2, 18},
        {"parameters:\n  a: {normal: [1 mm, 0 mm]}\n", "makes no sense", 2, 15},
        {"parameters:\n  a: {triangular: [1 mm, 5 mm, 2 mm]}\n", "makes no sense", 2, 19},
        {"parameters:\n  a: {tolerance: 1 deg}\n", "angle", 2, 18},
        {"parameters:\n  a: {tolerance: 1 furlong}\n", "`furlong` is not a unit", 2, 18},
    };
    Machine m = machine_parse(model_text, false);
    for (size_t k = 0; k < sizeof cases / sizeof *cases; k++) {
        YkProblems *problems = yk_problems_new();
        YkTolerances *t = load(cases[k].text, m.model, problems);
        const YkProblem *p = yk_problems_count(problems) > 0 ? yk_problems_get(problems, 0) : NULL;
        bool good = !t && p && strstr(p->message, cases[k].message) && (int)p->place.line == cases[k].line &&
                    (int)p->place.column == cases[k].column;
        if (!good)
            print_error("%s: %d:%d %s\n", cases[k].text, p ? (int)p->place.line : 0, p ? (int)p->place.column : 0,
                        p ? p->message : "");
        assert_true(good);
        yk_problems_free(problems);
    }
    YkProblems *problems = yk_problems_new();
    assert_null(yk_tolerances_load("/nowhere/at/all.yaml", m.model, problems));
    assert_int_equal(yk_problems_error_count(problems), 1);
    yk_problems_free(problems);
    machine_free(&m);
}

typedef struct Files {
    char path[40];
    const YkModel *model;
} Files;

static bool read_again(void *context)
{
    const Files *f = context;
    YkProblems *problems = yk_problems_new();
    if (!problems) return false;
    YkTolerances *t = yk_tolerances_load(f->path, f->model, problems);
    bool good = t != NULL;
    if (good) assert_int_equal(yk_tolerances_count(t), 2);
    if (!good) assert_true(yk_problems_error_count(problems) > 0 || yk_problems_ran_out(problems));
    yk_tolerances_free(t);
    yk_problems_free(problems);
    return good;
}

static void test_every_allocation_may_fail(void **unused)
{
    (void)unused;
    skip_unless_interposed();
    static const char text[] = "seed: 3\nparameters: {a: {uniform: [39 mm, a + 1 mm]}, phi: {tolerance: 1 deg}}\n";
    Machine m = machine_parse(model_text, false);
    Files files = {"/tmp/yoke-tolerances-XXXXXX", m.model};
    int file = mkstemp(files.path);
    assert_true(file >= 0 && write(file, text, strlen(text)) == (ssize_t)strlen(text));
    close(file);
    assert_true(read_again(&files));
    for (long k = 0; k == 0 || has_failed; k++) { // but for the buffer of the C library, which reads without one
        long before = live;
        has_failed = false;
        countdown = k;
        bool good = read_again(&files);
        countdown = -1;
        assert_int_equal(live, before);
        assert_true(good || has_failed);
    }
    unlink(files.path);
    machine_free(&m);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_values_have_units_and_parameters),
        cmocka_unit_test(test_what_is_wrong_is_told_with_its_place),
        cmocka_unit_test(test_every_allocation_may_fail),
    };
    start_counting();
    return cmocka_run_group_tests(tests, NULL, NULL);
}
