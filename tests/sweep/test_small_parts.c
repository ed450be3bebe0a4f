// A linkage of some centimetres in a model that is up to 1e5 km wide: it passes its change points like any other. Its
// rack and its piston are driven by lengths, whose way is small compared with the model though the links turn far.
#include "../parallelogram.h"
#include "../solve/machine.h"
#include <yoke/move.h>
#include "base/vec.h"

// Crank and rocker are 2 cm long. The rack turns the crank by d over 1 cm.
static Machine racked(double width, const char *drive)
{
    char text[2048];
    snprintf(text, sizeof text,
             "bodies:\n"
             "  ground:  {points: {O2: [0, 0], O4: [0.04, 0], far: [%g, 0], R: [0, 0.01]}}\n"
             "  crank:   {points: {O2: [0, 0], A: [0.02, 0]}}\n"
             "  coupler: {points: {A: [0, 0], B: [0.04, 0]}}\n"
             "  rocker:  {points: {O4: [0, 0], B: [0.02, 0]}}\n"
             "  rack:    {points: {R: [0, 0]}}\n" PARALLELOGRAM_JOINTS
             "  R: {slide: [ground, rack], along: x, distance: d}\n"
             "racks:\n  G: {rack: rack, pinion: crank, radius: 0.01}\n"
             "drives: {d: '%s'}\nstart: {theta2: 1 rad, theta3: -1 rad, theta4: 1 rad}\n",
             width, drive);
    return machine_parse(text, true);
}

static void check_parallel(const Machine *m, double crank)
{
    CHECK_NEAR(machine_ask(m, "theta2"), crank, 1e-7);
    CHECK_NEAR(machine_ask(m, "theta4"), crank, 1e-6);
}

static const double widths[] = {0.04, 50, 500, 5e3, 1e5, 1e8};

static void test_a_linkage_behind_a_rack_stays_parallel(void **unused)
{
    (void)unused;
    static const char *const of[] = {"theta2", "theta4"};
    static const double ways[] = {0.05, -0.02, 0.2, 0.0314};
    for (size_t k = 0; k < sizeof widths / sizeof *widths; k++) {
        Machine m = racked(widths[k], "0.01 m");
        for (size_t i = 0; i < sizeof ways / sizeof *ways; i++) {
            YkMotion goal = {ways[i], 0.01, 0};
            assert_true(yk_state_move_to(m.state, &goal, NULL, NULL) >= 0);
            check_parallel(&m, ways[i] / 0.01);
        }
        YkSweep *sweep = machine_sweep(&m, "d", -0.15, 0.151, 9, of, 2);
        for (size_t row = 0; row < yk_sweep_row_count(sweep); row++)
            CHECK_NEAR(yk_sweep_value(sweep, row, 1), yk_sweep_value(sweep, row, 0), 1e-6);
        assert_int_equal(yk_sweep_row_count(sweep), 10);
        assert_int_equal(count_events(sweep, YK_EVENT_CHANGE_POINT), 9); // multiples of pi from -4 to 4
        yk_sweep_free(sweep);
        machine_free(&m);
    }
}

static void test_so_it_does_over_time(void **unused)
{
    (void)unused;
    for (size_t k = 0; k < sizeof widths / sizeof *widths; k++) {
        Machine m = racked(widths[k], "0.01 m + 0.06 m * sin(1 rad/s * t)");
        for (int i = 1; i < 12; i++) {
            assert_true(yk_state_move_time(m.state, 1.1 * i, NULL, NULL, m.problems) >= 0);
            check_parallel(&m, 1 + 6 * sin(1.1 * i));
        }
        machine_free(&m);
    }
}

// A slider-crank of equal links, 2 cm, moved by its piston: d = 0.04 cos(theta), and a limit at 4 cm.
static void test_a_piston_keeps_its_branch(void **unused)
{
    (void)unused;
    for (size_t k = 0; k < sizeof widths / sizeof *widths; k++) {
        char text[1024];
        snprintf(text, sizeof text,
                 "bodies:\n"
                 "  ground: {points: {O: [0, 0], far: [%g, 0]}}\n"
                 "  crank: {points: {O: [0, 0], A: [0.02, 0]}}\n"
                 "  rod: {points: {A: [0, 0], B: [0.02, 0]}}\n"
                 "  piston: {points: {B: [0, 0]}}\n"
                 "joints:\n"
                 "  S: {slide: [ground, piston], along: x, distance: d}\n"
                 "  B: {pin: [piston, rod], angle: phi}\n"
                 "  O: {pin: [ground, crank], angle: theta}\n"
                 "  A: {pin: [crank, rod]}\n"
                 "drives: {d: 0.02 m}\nstart: {theta: 60 deg, phi: -60 deg}\n",
                 widths[k]);
        Machine m = machine_parse(text, true);
        static const double ways[] = {0.0399, 0.001, -0.03, -0.0399999, 0.03};
        for (size_t i = 0; i < sizeof ways / sizeof *ways; i++) {
            YkMotion goal = {ways[i], 0.01, 0}, beyond = {0.0401, 0, 0};
            assert_true(yk_state_move_to(m.state, &goal, NULL, NULL) >= 0);
            CHECK_NEAR(cos(machine_ask(&m, "theta")), ways[i] / 0.04, 1e-9);
            assert_true(sin(machine_ask(&m, "theta")) > 0);
            if (i == 0) assert_int_equal(yk_state_move_to(m.state, &beyond, NULL, NULL), YK_LIMIT);
        }
        machine_free(&m);
    }
}

// A lever that slides on a pin which an input moves along a line, with an offset that rounding may have left: it is not
// a short arm.
static void test_an_offset_of_rounding_does_not_shorten_the_steps(void **unused)
{
    (void)unused;
    static const char *const of[] = {"q"};
    static const double offsets[] = {0, 1e-11, 1e-9, 1e-7};
    for (size_t k = 0; k < sizeof offsets / sizeof *offsets; k++) {
        char text[1024];
        snprintf(text, sizeof text,
                 "bodies:\n"
                 "  ground: {points: {O: [0, 0.2], C: [0, 0]}}\n"
                 "  piston: {points: {B: [0, 0]}}\n"
                 "  guide: {points: {B: [0, 0]}}\n"
                 "  lever: {points: {C: [0, 0], L: [0, %g]}}\n"
                 "joints:\n"
                 "  S: {slide: [ground, piston], along: x, from: O, to: B, distance: d}\n"
                 "  C: {pin: [ground, lever], angle: q}\n"
                 "  B: {pin: [piston, guide]}\n"
                 "  L: {slide: [lever, guide], along: x, from: L, to: B, distance: e}\n"
                 "drives: {d: 0.5 m}\nstart: {q: 20 deg, e: 0.54}\n",
                 offsets[k]);
        Machine m = machine_parse(text, true);
        YkSweep *sweep = machine_sweep(&m, "d", -1, 1, 8, of, 1);
        assert_int_equal(yk_sweep_row_count(sweep), 9);
        for (size_t row = 0; row < 9; row++) {
            double d = yk_sweep_at(sweep, row), length = hypot(d, 0.2);
            CHECK_NEAR(yk_sweep_value(sweep, row, 0), atan2(0.2, d) - asin(offsets[k] / length), 1e-12);
        }
        yk_sweep_free(sweep);
        machine_free(&m);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_a_linkage_behind_a_rack_stays_parallel),
                                       cmocka_unit_test(test_so_it_does_over_time),
                                       cmocka_unit_test(test_a_piston_keeps_its_branch),
                                       cmocka_unit_test(test_an_offset_of_rounding_does_not_shorten_the_steps)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
