// Equations as pages print them: values of laws, names of a motion program, influence coefficients, lumped constants,
// motions of drives; and angles that are not multiples of the machine's.
#include "verdicts.h"

// A cycloidal rise of 20 mm over 120 deg, a dwell to 180 deg, back by 3-4-5. A bracket of anything but a place is a
// factor.
static void laws_are_asked_at_a_place(void **state)
{
    (void)state;
    Machine m = machine_of(ROLLER_CAM);
    CHECK_KINDS(&m, IS_HERE("lift (pi) = 1/50"), IS_HERE("lift(2/3 pi) = 20 mm"), IS_HERE("lift (60 deg) = 10 mm"),
                IS_HERE("lift_v (pi/3) = 0.04/(2/3 pi)"), IS_HERE("lift_v (pi) = 0"), IS_HERE("lift_a (pi) = 0"),
                IS_HERE("lift (3/2 pi) = 1/100"), IS("s = lift(theta)"), IS("s' = lift_v(theta) theta'"),
                IS("lift (theta + s) = theta s + s^2"), IS_NOT("lift (pi) = 1/40"), IS_NOT("lift_v (pi/3) = 0"),
                IS_NOT("s = lift(2/3 pi)"));
    machine_end(&m);
}

static void names_of_a_motion_program_hold_in_their_segment(void **state)
{
    (void)state;
    Machine m = machine_of(ROLLER_CAM);
    CHECK_KINDS(&m, IS("h1 = 20 mm"), IS("beta1 = 120 deg"), IS_HERE("s = h1 (u1 - sin(2 pi u1)/(2 pi))"),
                IS_HERE("u1 = theta/beta1"), IS_HERE("lift_v = h1/beta1 (1 - cos(2 pi u1))"),
                IS_HERE("s = h2 (1 - 10 u2^3 + 15 u2^4 - 6 u2^5)"), IS_HERE("u2 = (theta - pi)/pi"),
                IS_NOT("s = h1 u1"), IS_NOT("s = h2 (10 u2^3 - 15 u2^4 + 6 u2^5)"), IS_NOT("u1 = theta/pi"),
                IS("k_s = lift_v"), IS_NOT("k_s = lift_a"), CANNOT("tan(alpha) = 1"));
    YkCheckVerdict verdict = verdict_on(&m, "s = h1 (u1 - sin(2 pi u1)/(2 pi))");
    assert_true(verdict.is_in_segment && verdict.poses >= 8);
    machine_end(&m);
}

// Where no page is asked for them, a machine has no such names; its own come first.
static void a_machines_own_names_come_first(void **state)
{
    (void)state;
    Machine m =
        machine_of("parameters: {p1: 2 m, mu: 3 kg, k_q: 5}\n"
                   "bodies: {arm: {points: {P: [p1, 0]}, mass: mu, center: [p1, 0], inertia: 0}, cart: {mass: mu}}\n"
                   "joints:\n"
                   "  W: {slide: [ground, cart], along: x, distance: x}\n"
                   "  O: {pin: [cart, arm], angle: q}\n");
    CHECK_KINDS(&m, IS_HERE("p1 = 2 m"), IS_HERE("k_q = 5"), IS("L = T - V"), IS("omega_arm = q'"),
                IS("alpha_arm = q''"), IS("T = mu x'^2 + 1/2 mu p1^2 omega_arm^2 - mu p1 sin(q) x' q'"),
                CANNOT("k_x = 1"), CANNOT("h1 = 1"));
    machine_end(&m);
}

static const char crank[] = "parameters: {r: 0.1 m, l: 0.3 m, w: 5 rad/s}\n"
                            "bodies:\n"
                            "  ground: {points: {O: [0, 0]}}\n"
                            "  crank: {points: {O: [0, 0], A: [r, 0]}}\n"
                            "  rod: {points: {A: [0, 0], B: [l, 0]}}\n"
                            "  piston: {points: {B: [0, 0]}}\n"
                            "joints:\n"
                            "  O: {pin: [ground, crank], angle: th}\n"
                            "  A: {pin: [crank, rod], angle: ph}\n"
                            "  B: {pin: [rod, piston]}\n"
                            "  S: {slide: [ground, piston], along: x, distance: s}\n"
                            "drives: {th: 30 deg + w * t}\n"
                            "start: {ph: -60 deg, s: 0.3}\n";

static void what_speaks_of_the_time_is_asked_of_the_drives(void **state)
{
    (void)state;
    Machine m = machine_of(crank);
    CHECK_KINDS(&m, IS_DRIVEN("th = pi/6 + w t"), IS_DRIVEN("th' = w"), IS_DRIVEN("th'' = 0"),
                IS_DRIVEN("crank.A.x = r cos(pi/6 + w t)"),
                IS_DRIVEN("(s - r cos(w t + 30 deg))^2 = l^2 - r^2 sin(30 deg + w t)^2"),
                IS_DRIVEN("crank.A.x'' = -w^2 crank.A.x"), IS_NOT("th = w t"), IS_NOT("th' = 2 w"),
                IS_NOT("crank.A.x = r cos(w t)"), IS("s' = -r sin(th) th' - l sin(th + ph) (th' + ph')"));
    machine_end(&m);
}

// The field knows no sign of a root: poses do.
static void roots_are_tried_at_poses(void **state)
{
    (void)state;
    Machine m = machine_of(crank);
    CHECK_KINDS(&m, IS_HERE("s = r cos(th) + sqrt(l^2 - r^2 sin(th)^2)"),
                IS_NOT("s = r cos(th) - sqrt(l^2 - r^2 sin(th)^2)"), IS_HERE("sqrt(s^2) = s"), IS_NOT("sqrt(s^2) = -s"),
                IS_HERE("sqrt(crank.A.x'^2 + crank.A.y'^2) = r sqrt(th'^2)"),
                IS_NOT("sqrt(crank.A.x'^2 + crank.A.y'^2) = r th' cos(th)"),
                IS("s(t) = r cos(th(t)) + l cos(th(t) + ph(t))"), IS_HERE("cos(th) sqrt(r^2) = r cos(th)"));
    machine_end(&m);
}

static void half_angles_are_read(void **state)
{
    (void)state;
    Machine m = machine_of(crank);
    CHECK_KINDS(&m, IS("tan(th/2) = sin(th)/(1 + cos(th))"), IS("tan(th/2)^2 = (1 - cos(th))/(1 + cos(th))"),
                IS_HERE("2 sin(th/2) cos(th/2) = sin(th)"), IS_HERE("cos(th/2)^2 = (1 + cos(th))/2"),
                IS("cos(ph + th/2) = cos(ph) cos(th/2) - sin(ph) sin(th/2)"),
                IS("sin(th/2 + pi/3 - 2 ph) = sin(th/2) cos(2 ph - pi/3) - cos(th/2) sin(2 ph - pi/3)"),
                IS_NOT("cos(ph + th/2) = cos(ph) cos(th/2) + sin(ph) sin(th/2)"),
                IS_NOT("tan(th/2) = sin(th)/(1 - cos(th))"), IS_NOT("sin(th/2) = sin(th)/2"), CANNOT("sin(r) = 0"),
                CANNOT("sin(w) = 0"));
    machine_end(&m);
}

// A session asks for many: each brings symbols of its own.
static void many_equations_bring_many_angles_and_roots(void **state)
{
    (void)state;
    Machine m = machine_of(crank);
    for (int k = 2; k < 60; k++) {
        char text[200];
        snprintf(text, sizeof text, "cos(th/%d)^2 + sin(th/%d)^2 = 1", k, k);
        assert_int_equal(verdict_on(&m, text).kind, YK_CHECK_TRUE);
        snprintf(text, sizeof text, "sqrt(s^2 + %d) = %d sin(th/%d) + cos(th)", k, k, k + 60);
        assert_int_equal(verdict_on(&m, text).kind, YK_CHECK_FALSE);
        snprintf(text, sizeof text, "sqrt((s + %d)^2) = s + %d", k, k);
        assert_int_equal(verdict_on(&m, text).kind, YK_CHECK_TRUE_HERE);
    }
    assert_int_equal(verdict_on(&m, "s' = -r sin(th) th' - l sin(th + ph) (th' + ph')").kind, YK_CHECK_TRUE);
    machine_end(&m);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(laws_are_asked_at_a_place),
        cmocka_unit_test(names_of_a_motion_program_hold_in_their_segment),
        cmocka_unit_test(a_machines_own_names_come_first),
        cmocka_unit_test(what_speaks_of_the_time_is_asked_of_the_drives),
        cmocka_unit_test(roots_are_tried_at_poses),
        cmocka_unit_test(half_angles_are_read),
        cmocka_unit_test(many_equations_bring_many_angles_and_roots),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
