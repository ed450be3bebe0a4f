// The examples in other units (tests/similar.h): forces, efforts and energies are similar, in every number.
#include "../similar.h"

static const int units[][3] = {{33, 0, 0}, {0, -37, 0}, {-35, 24, 33}};

static void check_method(Similar *a, Similar *b, YkMethod method)
{
    YkStatus one = yk_dynamics_solve(a->dynamics, a->state, method);
    SIMILAR_EQUAL(a->file, yk_dynamics_solve(b->dynamics, b->state, method), one);
    if (one < 0) return;
    similar_check_state(a, b);
    similar_check_forces(a, b);
}

static void check_pose(Similar *a, Similar *b, double time)
{
    YkStatus one = yk_state_set_time(a->state, time, a->problems);
    SIMILAR_EQUAL(a->file, yk_state_set_time(b->state, similar_to(time, YK_QUANTITY_TIME), b->problems), one);
    if (one < 0) return;
    check_method(a, b, YK_METHOD_REDUCED);
    check_method(a, b, YK_METHOD_NEWTON_EULER);
}

static void check_pair(Similar *a, Similar *b, size_t unused)
{
    (void)unused;
    for (int step = 0; step < 3; step++) check_pose(a, b, 0.01 * step);
}

static void test_forces_of_every_example_in_other_units(void **unused)
{
    (void)unused;
    similar_each_pair(units, sizeof units / sizeof *units, check_pair);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_forces_of_every_example_in_other_units),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
