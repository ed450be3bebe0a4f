// A plate on three legs whose lengths are driven: one group, whose loops hold driven distances. The plate's own points
// are as far from the legs' feet as the legs are long, with rates and accelerations.
#include "machine.h"

static const char text[] =
    "bodies:\n  ground: {points: {A: [0, 0], B: [4, 0], C: [2.6, 4]}}\n  plate: {points: {D: [0, 0], E: [1, 0], F: "
    "[0.5, "
    "0.9]}}\n"
    "  a: {points: {A: [0, 0]}}\n  b: {points: {B: [0, 0]}}\n  c: {points: {C: [0, 0]}}\n"
    "  d: {points: {D: [0, 0]}}\n  e: {points: {E: [0, 0]}}\n  f: {points: {F: [0, 0]}}\njoints:\n"
    "  A: {pin: [ground, a], angle: ta}\n  B: {pin: [ground, b], angle: tb}\n  C: {pin: [ground, c], angle: tc}\n"
    "  S: {slide: [a, d], along: x, from: A, to: D, distance: la}\n"
    "  T: {slide: [b, e], along: x, from: B, to: E, distance: lb}\n"
    "  U: {slide: [c, f], along: x, from: C, to: F, distance: lc}\n"
    "  D: {pin: [d, plate], angle: phi}\n  E: {pin: [e, plate]}\n  F: {pin: [f, plate]}\n"
    "drives: {la: 2.0518, lb: 2.4349, lc: 2.0311}\nstart: {ta: 0.82, tb: 2.31, tc: -2.25, phi: -0.52}\n";

static void legs_are_as_long_as_they_are_driven(void **unused)
{
    (void)unused;
    static const char *const lengths[] = {"la", "lb", "lc"}, *const ends[] = {"plate.D", "plate.E", "plate.F"};
    static const double own[3] = {2.0518, 2.4349, 2.0311}, foot[3][2] = {{0, 0}, {4, 0}, {2.6, 4}};
    uint64_t seed = 8;
    Machine m = machine_parse(text, true);
    assert_int_equal(yk_input_count(m.mech), 3);
    assert_int_equal(yk_block_info(m.mech, 0).kind, YK_BLOCK_GROUP);
    for (int k = 0; k < 60; k++) {
        for (size_t i = 0; i < 3; i++) {
            double base = own[i] + 0.15 * sin(0.3 * k + (double)i);
            size_t c = yk_input_coordinate(m.mech, i);
            assert_string_equal(yk_coordinate_info(m.mech, c).name, lengths[i]);
            yk_state_set_input(m.state, i, (YkMotion){base, check_uniform(&seed, -1, 1), check_uniform(&seed, -1, 1)});
        }
        assert_int_equal(yk_state_solve(m.state), YK_OK);
        for (size_t i = 0; i < 3; i++) {
            YkMotion l = yk_state_input(m.state, i);
            double x[2][3];
            for (int axis = 0; axis < 2; axis++)
                for (int order = 0; order < 3; order++) {
                    char name[40];
                    static const char *const orders[] = {"", ".rate", ".accel"};
                    snprintf(name, sizeof name, "%s.%c%s", ends[i], axis ? 'y' : 'x', orders[order]);
                    x[axis][order] = machine_ask(&m, name) - (order == 0 ? foot[i][axis] : 0);
                }
            double p = l.position, v = l.velocity, a = l.acceleration;
            CHECK_NEAR(x[0][0] * x[0][0] + x[1][0] * x[1][0], p * p, 1e-12);
            CHECK_NEAR(x[0][0] * x[0][1] + x[1][0] * x[1][1], p * v, 1e-11);
            CHECK_NEAR(x[0][1] * x[0][1] + x[1][1] * x[1][1] + x[0][0] * x[0][2] + x[1][0] * x[1][2], v * v + p * a,
                       1e-10);
        }
        YkResiduals r = yk_state_residuals(m.state);
        CHECK_NEAR(r.position, 0, 1e-12);
        CHECK_NEAR(r.velocity, 0, 1e-11);
        CHECK_NEAR(r.acceleration, 0, 1e-10);
    }
    machine_free(&m);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(legs_are_as_long_as_they_are_driven),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
