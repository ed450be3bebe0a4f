// Tasks in another unit of length (tests/similar.h): the same machines are found, down to the text of their files, in
// which the unit is written.
#include <yoke/synthesis.h>
#include "../similar.h"

typedef struct Answer {
    YkTask *task;
    YkSynthesis *synthesis;
} Answer;

static Answer answer(const char *file, int metre)
{
    char path[512];
    YkProblems *problems = yk_problems_new();
    similar_set(metre, 0, 0);
    snprintf(path, sizeof path, "%s/examples/tasks/%s.yaml", YOKE_ROOT, file);
    Answer a = {.task = yk_task_load(path, problems)};
    if (a.task) a.synthesis = yk_synthesis_run(a.task, NULL, problems);
    if (!a.synthesis) print_error("%s", yk_problems_text(problems, 0));
    assert_non_null(a.synthesis);
    yk_problems_free(problems);
    return a;
}

static void free_answer(Answer *a)
{
    yk_synthesis_free(a->synthesis);
    yk_task_free(a->task);
}

static void check_candidate(const char *file, YkCandidate c, YkCandidate d)
{
    static const YkQuantity LENGTH = YK_QUANTITY_LENGTH;
    SIMILAR_EQUAL(file, c.defect, d.defect);
    assert_string_equal(c.mechanism, d.mechanism);
    SIMILAR_EQUAL(file, c.circuits, d.circuits);
    if (c.file) assert_string_equal(c.file, d.file);
    if (c.model) assert_string_equal(c.model, d.model);
    if (c.type) assert_string_equal(c.type, d.type);
    for (int k = 0; k < 2; k++) {
        similar_check(c.transmission[k], d.transmission[k], YK_QUANTITY_ANGLE, file, "transmission angle");
        similar_check(c.pivots[k][0], d.pivots[k][0], LENGTH, file, "x of a pivot");
        similar_check(c.pivots[k][1], d.pivots[k][1], LENGTH, file, "y of a pivot");
        similar_check(c.point[k], d.point[k], LENGTH, file, "coupler point");
    }
    for (int k = 0; k < 4; k++) similar_check(c.lengths[k], d.lengths[k], LENGTH, file, "length of a link");
}

static void check_task(const char *file, int metre)
{
    Answer one = answer(file, 0), two = answer(file, metre);
    SIMILAR_EQUAL(file, yk_synthesis_count(one.synthesis), yk_synthesis_count(two.synthesis));
    SIMILAR_EQUAL(file, yk_synthesis_defect_count(one.synthesis), yk_synthesis_defect_count(two.synthesis));
    SIMILAR_EQUAL(file, yk_synthesis_is_complete(one.synthesis), yk_synthesis_is_complete(two.synthesis));
    for (size_t k = 0; k < yk_synthesis_count(one.synthesis); k++)
        check_candidate(file, yk_synthesis_candidate(one.synthesis, k), yk_synthesis_candidate(two.synthesis, k));
    for (size_t k = 0; k < yk_synthesis_defect_count(one.synthesis); k++)
        check_candidate(file, yk_synthesis_defect(one.synthesis, k), yk_synthesis_defect(two.synthesis, k));
    free_answer(&one);
    free_answer(&two);
}

static void test_tasks_in_another_unit(void **unused)
{
    (void)unused;
    // A four-bar for a function has no size: its ground is 1 m.
    static const char *const files[] = {"quick-slider", "five-positions", "slider-power",  "quick-rocker",
                                        "tray",         "wiper",          "metering-pump", "four-positions"};
    for (size_t k = 0; k < check_cases(sizeof files / sizeof *files); k++) check_task(files[k], k % 2 ? 33 : -34);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_tasks_in_another_unit)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
