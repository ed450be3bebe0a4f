// The examples in other units (tests/similar.h): forces, efforts and energies are similar, in every number.
#include "../similar.h"

static const int units[][3] = {{3, 0, 0}, {0, -7, 0}, {-5, 4, 3}};

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

static void check_file(const char *file)
{
    for (size_t k = 0; k < sizeof units / sizeof *units; k++) {
        similar_set(0, 0, 0);
        Similar a = similar_load(file, NULL);
        similar_set(units[k][0], units[k][1], units[k][2]);
        Similar b = similar_load(file, NULL);
        if (a.mech) {
            YkStatus one = yk_state_assemble(a.state);
            SIMILAR_EQUAL(file, yk_state_assemble(b.state), one);
            for (int step = 0; one >= 0 && step < 3; step++) check_pose(&a, &b, 0.01 * step);
        }
        similar_free(&a);
        similar_free(&b);
    }
}

static void test_forces_of_every_example_in_other_units(void **unused)
{
    (void)unused;
    similar_each_example(check_file);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_forces_of_every_example_in_other_units),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
