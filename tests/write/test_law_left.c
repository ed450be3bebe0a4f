// The message about a law whose range is left: whose law it is, its range and the place in the file's units.
#include "check.h"
#include <yoke/yoke.h>
#include "write/law_left.h"

static const char machine[] =
    "units: {length: mm, angle: deg, force: N}\n"
    "laws:\n"
    "  cutting: {table: [[0 mm, 0 N], [120 mm, 500 N]]}\n"
    "  push: {table: [[0 s, 1 N], [2 s, 0 N]]}\n"
    "  lift: {table: [[0 deg, 0 mm], [90 deg, 20 mm]]}\n"
    "  odd: {table: [[0 N, 0 kg/s], [5 N, 3 kg/s]]}\n"
    "bodies: {a: {mass: 1, inertia: 1}}\njoints: {S: {slide: [ground, a], along: x, distance: d5}}\n";

static void check(YkLawLeft left, const char *expected)
{
    YkProblems *problems = yk_problems_new();
    YkModel *model = yk_model_parse(machine, strlen(machine), "test", NULL, problems);
    YkText text = {0};
    if (!model) print_error("%s", yk_problems_text(problems, 0));
    assert_non_null(model);
    yk_law_left_write(&text, model, &left);
    assert_string_equal(yk_text_get(&text), expected);
    yk_text_free(&text);
    yk_model_free(model);
    yk_problems_free(problems);
}

static void it_is_told_in_the_files_units(void **state)
{
    (void)state;
    check((YkLawLeft){.law = "cutting",
                      .user = YK_LAW_USER_EFFORT,
                      .name = "d5",
                      .from = 0,
                      .to = 0.12,
                      .argument = 0.13,
                      .value = 500},
          "the effort of `d5` leaves the range of law `cutting`, 0 mm to 120 mm: at 130 mm it keeps its end value, 500 "
          "N");
    check(
        (YkLawLeft){
            .law = "push", .user = YK_LAW_USER_FORCE, .name = "F", .from = 0, .to = 2, .argument = 2.5, .value = 1e-13},
        "the force `F` leaves the range of law `push`, 0 s to 2 s: at 2.5 s it keeps its end value, 0 N");
    check((YkLawLeft){.law = "lift",
                      .user = YK_LAW_USER_DRIVE,
                      .name = "d5",
                      .from = 0,
                      .to = 1.5707963267948966,
                      .argument = -0.5235987755982988,
                      .value = 0},
          "the drive of `d5` leaves the range of law `lift`, 0 deg to 90 deg: at -30 deg it keeps its end value, 0 mm");
    check(
        (YkLawLeft){
            .law = "odd", .user = YK_LAW_USER_SPRING, .name = "k", .from = 0, .to = 5, .argument = 6, .value = 3},
        "the spring `k` leaves the range of law `odd`, 0 N to 5 N: at 6 N it keeps its end value, 3 (SI)");
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(it_is_told_in_the_files_units)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
