// Equations of machines whose forces need roots: lengths of springs, the height of a roller.
#include "verdicts.h"

// The roller's height h_cc = sqrt(39/8000) has no value in the prime field: what does not hang on its square is proved
// all the same, and what is an identity by its square is one.
static void a_root_of_a_number_need_not_be_in_the_field(void **state)
{
    (void)state;
    Machine m = machine_of(ROLLER_CAM);
    YkDynamics *dynamics = yk_dynamics_new(m.mech, m.problems);
    check_kind(&m, dynamics, "s = 1", YK_CHECK_FALSE);
    check_kind(&m, dynamics, "s' = lift_v theta'", YK_CHECK_TRUE);
    check_kind(&m, dynamics, "h_cc^2 = 39/8000", YK_CHECK_TRUE);
    check_kind(&m, dynamics, "h_cc^2 = 38/8000", YK_CHECK_FALSE);
    check_kind(&m, dynamics, "(h_cc + s)^2 = 39/8000 + 2 h_cc s + s^2", YK_CHECK_TRUE);
    check_kind(&m, dynamics, "tan(phi12) = (lift_v - 5 mm)/(s + h_cc)", YK_CHECK_TRUE);
    check_kind(&m, dynamics, "tan(phi12) = lift_v/(s + h_cc)", YK_CHECK_FALSE);
    check_kind(&m, dynamics, "N12 cos(phi12) = 1/5 s'' + 981/500 + 800 (s + 0.01)", YK_CHECK_TRUE);
    check_kind(&m, dynamics, "N12 cos(phi12) = 1/5 s'' + 981/500 + 800 s", YK_CHECK_FALSE);
    yk_dynamics_free(dynamics);
    machine_end(&m);
}

// Eight springs: only one point of the field in 256 has all their lengths.
static void many_springs_are_found_together(void **state)
{
    (void)state;
    Machine m =
        machine_of("parameters: {a: 1, b: 0.3, k: 100, m: 2}\n"
                   "bodies:\n"
                   "  ground: {points: {O: [0, 0], G0: [-4, 2], G1: [-3, 3], G2: [-2, 4], G3: [-1, 2], G4: [0, 3], G5: "
                   "[1, 4], G6: [2, 2], G7: [3, 3]}}\n"
                   "  bar: {points: {O: [0, 0], P0: [a, 0*b], P1: [a, 1*b], P2: [a, 2*b], P3: [a, 3*b], P4: [a, 4*b], "
                   "P5: [a, 5*b], P6: [a, 6*b], P7: [a, 7*b]}, mass: m, center: [a, 0], inertia: 0.3}\n"
                   "joints:\n"
                   "  O: {pin: [ground, bar], angle: q}\n"
                   "springs:\n"
                   "  s0: {between: [ground.G0, bar.P0], stiffness: k, length: 0.5 m}\n"
                   "  s1: {between: [ground.G1, bar.P1], stiffness: k, length: 0.5 m}\n"
                   "  s2: {between: [ground.G2, bar.P2], stiffness: k, length: 0.5 m}\n"
                   "  s3: {between: [ground.G3, bar.P3], stiffness: k, length: 0.5 m}\n"
                   "  s4: {between: [ground.G4, bar.P4], stiffness: k, length: 0.5 m}\n"
                   "  s5: {between: [ground.G5, bar.P5], stiffness: k, length: 0.5 m}\n"
                   "  s6: {between: [ground.G6, bar.P6], stiffness: k, length: 0.5 m}\n"
                   "  s7: {between: [ground.G7, bar.P7], stiffness: k, length: 0.5 m}\n"
                   "start: {q: 0.3}\n"
                   "gravity: [0, -9.81]\n");
    YkDynamics *dynamics = yk_dynamics_new(m.mech, m.problems);
    check_kind(&m, dynamics, "T' + V' = 0", YK_CHECK_TRUE);
    check_kind(&m, dynamics, "T' = V'", YK_CHECK_FALSE);
    check_kind(&m, dynamics, "T = 1/2 (3/10 + m a^2) q'^2", YK_CHECK_TRUE);
    yk_dynamics_free(dynamics);
    machine_end(&m);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_root_of_a_number_need_not_be_in_the_field),
        cmocka_unit_test(many_springs_are_found_together),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
