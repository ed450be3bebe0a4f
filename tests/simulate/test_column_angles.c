// The angle between a dyad's columns: its rate and acceleration are its derivatives by time, for every kind of dyad.
#include "simulate/crossing.h"
#include "solve/machine.h"
#include "solve/state.h"

// The columns of a dyad where the input has moved on for the time t at a constant acceleration.
static YkDirection columns_at(const Machine *m, size_t block, YkMotion from, double t)
{
    double a = from.acceleration;
    yk_state_set_input(m->state, 0,
                       (YkMotion){from.position + t * (from.velocity + 0.5 * a * t), from.velocity + a * t, a});
    assert_int_equal(yk_state_solve(m->state), YK_OK);
    YkRun run = yk_state_run(m->state, &m->state->space);
    return yk_between_columns(&run, &m->mech->blocks[block]);
}

static void check_block(const char *file, size_t block)
{
    const double h = 1e-4;
    Machine m = machine_load(file);
    double at = yk_state_input(m.state, 0).position;
    for (int k = 0; k < 12; k++) {
        YkMotion from = {at + 0.05 * k, 1.5 - 0.3 * k, 2 - 0.7 * k};
        YkDirection after = columns_at(&m, block, from, h), before = columns_at(&m, block, from, -h),
                    here = columns_at(&m, block, from, 0);
        double most = 1 + fabs(here.acceleration);
        CHECK_NEAR(yk_nearest_turn(after.angle - before.angle, 0) / (2 * h), here.rate, 1e-6 * most);
        CHECK_NEAR((after.rate - before.rate) / (2 * h), here.acceleration, 1e-6 * most);
    }
    machine_free(&m);
}

static void test_rates_are_derivatives(void **unused)
{
    (void)unused;
    static const char *const files[] = {"four-bar",
                                        "slider-crank",
                                        "inverted-slider-crank",
                                        "offset-slider-crank",
                                        "drag-link",
                                        "oscillating-cylinder",
                                        "klann",
                                        "quick-return",
                                        "marghitu",
                                        "whitworth-kg"};
    for (size_t k = 0; k < sizeof files / sizeof *files; k++) {
        Machine m = machine_load(files[k]);
        for (size_t b = 0; b < m.mech->block_count; b++)
            if (yk_has_columns(&m.mech->blocks[b])) check_block(files[k], b);
        machine_free(&m);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_rates_are_derivatives)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
