// Tasks of the gallery in which one value is replaced by something else.
#include "../mutilate.h"

static bool reads(const char *text, const char *path, YkProblems *problems)
{
    YkTask *task = yk_task_parse(text, strlen(text), path, problems);
    bool good = task != NULL;
    yk_task_free(task);
    return good;
}

static void a_task_with_one_wrong_value_is_refused_with_words_or_taken(void **state)
{
    (void)state;
    static const char *const files[] = {"arc-at-angles",
                                        "dwell-watt",
                                        "evened-sine",
                                        "five-positions",
                                        "level-luffing",
                                        "linked-flaps",
                                        "logarithm",
                                        "passing-on",
                                        "oval",
                                        "power-function",
                                        "quick-rocker",
                                        "quick-slider",
                                        "straight-line-machine",
                                        "metering-pump",
                                        "tray",
                                        "two-positions"};
    assert_true(mutilate("tasks/", files, sizeof files / sizeof *files, 7, reads) > 500);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_task_with_one_wrong_value_is_refused_with_words_or_taken),
    };
    start_counting();
    return cmocka_run_group_tests(tests, NULL, NULL);
}
