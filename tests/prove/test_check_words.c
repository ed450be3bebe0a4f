// The syntax of equations, and the hints for false ones.
#include "verdicts.h"

static YkDynamics *dynamics_of(Machine *m)
{
    YkDynamics *dynamics = yk_dynamics_new(m->mech, m->problems);
    assert_non_null(dynamics);
    return dynamics;
}

static void check_example(const char *name, const Expected *expected, size_t count)
{
    Machine m = example(name);
    check_kinds(&m, expected, count);
    machine_end(&m);
}
#define CHECK_EXAMPLE(name, ...)                                                                                       \
    check_example(name, (const Expected[]){__VA_ARGS__}, sizeof((const Expected[]){__VA_ARGS__}) / sizeof(Expected))

static void numbers_take_units(void **state)
{
    (void)state;
    CHECK_EXAMPLE("quick-return", {"l1 = 750 mm", YK_CHECK_TRUE_HERE}, {"l1 = 750mm", YK_CHECK_TRUE_HERE},
                  {"l1 = 750", YK_CHECK_FALSE}, {"d5 = 1.2 m", YK_CHECK_FALSE},
                  {"sin(theta1 + 90 deg) = cos(theta1)", YK_CHECK_TRUE},
                  {"cos(60 deg - theta1) = cos(theta1)/2 + sqrt(3)/2 sin(theta1)", YK_CHECK_TRUE},
                  {"0.5 m/s*t = 500 mm/s*t", YK_CHECK_TRUE}, {"180 deg = pi", YK_CHECK_TRUE},
                  {"60 rpm = 2 pi rad/s", YK_CHECK_TRUE}, {"1 km/h = 1/3.6 m/s", YK_CHECK_TRUE});
    CHECK_EXAMPLE("double-pendulum", {"tau1 = 0.5 N*m", YK_CHECK_TRUE_HERE}, {"m2 g = 1 N", YK_CHECK_FALSE},
                  {"I1 = 0.025 kg*m^2", YK_CHECK_TRUE_HERE});
}

// With a parameter m, 2 m is twice that; with a coordinate s, rad/s is a unit still.
static void names_of_the_machine_come_before_units(void **state)
{
    (void)state;
    Machine m = machine_of("parameters: {m: 3 kg, l: 2 m}\n"
                           "bodies: {arm: {points: {P: [l, 0]}, mass: m, center: [l, 0], inertia: 0}, ram: {}}\n"
                           "joints:\n"
                           "  O: {pin: [ground, arm], angle: q}\n"
                           "  R: {slide: [ground, ram], along: x, distance: s}\n");
    assert_int_equal(verdict_on(&m, "2 m = 6").kind, YK_CHECK_TRUE_HERE);
    assert_int_equal(verdict_on(&m, "l = 2 m").kind, YK_CHECK_FALSE);
    assert_int_equal(verdict_on(&m, "l = 200 cm").kind, YK_CHECK_TRUE_HERE);
    assert_int_equal(verdict_on(&m, "q' 1 s = 1 rad/s").kind, YK_CHECK_FALSE);
    assert_int_equal(verdict_on(&m, "60 rpm = 2 pi rad/s").kind, YK_CHECK_TRUE);
    machine_end(&m);
}

// Bare numbers take any dimension, as in a file; parameters of which the file does not tell one, too; radians are
// numbers.
static void dimensions_are_compared_where_they_are_known(void **state)
{
    (void)state;
    Machine m = machine_of("parameters: {a: 0.3 m, mw: 3 kg, L: 1.2 m, k: 2, J: 0.1, q0: 30 deg}\n"
                           "gravity: [0, -9.81]\n"
                           "bodies: {arm: {points: {P: [L, 0]}, mass: mw, center: [a, 0], inertia: J}}\n"
                           "joints: {O: {pin: [ground, arm], angle: th}}\n");
    static const struct {
        const char *equation;
        YkCheckKind kind;
    } cases[] = {{"mw = 3 m", YK_CHECK_UNREADABLE},
                 {"a = 0.3 kg + 0 s", YK_CHECK_UNREADABLE},
                 {"arm.P.x = 1.2 s cos(th)", YK_CHECK_UNREADABLE},
                 {"th'' = 2 rad/s", YK_CHECK_UNREADABLE},
                 {"a = 0.3", YK_CHECK_TRUE_HERE},
                 {"a = 300 mm", YK_CHECK_TRUE_HERE},
                 {"a = 0.4", YK_CHECK_FALSE},
                 {"k = 2 m", YK_CHECK_TRUE_HERE},
                 {"J = 0.1 kg*m^2", YK_CHECK_TRUE_HERE},
                 {"J = 0.1 kg*m", YK_CHECK_UNREADABLE},
                 {"q0 = 30 deg", YK_CHECK_TRUE_HERE},
                 {"q0 = 1/6 pi", YK_CHECK_TRUE_HERE},
                 {"1 N*m = 1 kg*m^2/s^2", YK_CHECK_TRUE},
                 {"sqrt(4) a = 0.6 m", YK_CHECK_TRUE_HERE},
                 {"arm.P.x = 1.2 cos(th)", YK_CHECK_TRUE_HERE},
                 {"T = 1/2 (J + mw a^2) th'^2", YK_CHECK_TRUE},
                 {"T = 1/2 (0.1 kg*m^2 + mw a^2) th'^2", YK_CHECK_TRUE_HERE},
                 {"T = 1/2 (0.1 kg*m + mw a^2) th'^2", YK_CHECK_UNREADABLE},
                 // exactly, where both sides are numbers
                 {"L = 1.2000000000001 m", YK_CHECK_FALSE},
                 {"1.2 m = 1.2000000000001 m", YK_CHECK_FALSE},
                 {"q0 = 0.523598775598299", YK_CHECK_FALSE},
                 {"arm.P.x = 1.2000000000001 m cos(th)", YK_CHECK_FALSE},
                 {"L a = 0.36 m^2", YK_CHECK_TRUE_HERE},
                 {"L a = 0.36000000000001 m^2", YK_CHECK_FALSE}};
    for (size_t k = 0; k < sizeof cases / sizeof *cases; k++) {
        YkCheckVerdict verdict = verdict_on(&m, cases[k].equation);
        if (verdict.kind != cases[k].kind) print_error("%s: %d\n", cases[k].equation, (int)verdict.kind);
        assert_int_equal(verdict.kind, cases[k].kind);
    }
    machine_end(&m);
}

static void books_ways_of_writing_are_read(void **state)
{
    (void)state;
    CHECK_EXAMPLE("quick-return", {"sin^2(theta1) + cos^2 (theta1) = 1", YK_CHECK_TRUE},
                  {"theta1**2 = theta1^2", YK_CHECK_TRUE}, {"d3 [1 + 2] == 3 d3", YK_CHECK_TRUE},
                  {"tan^2(theta2) = 1/cos(theta2)^2 - 1", YK_CHECK_TRUE},
                  {"sin(2 (theta1 + theta2)) = 2 sin(theta1 + theta2) cos(theta1 + theta2)", YK_CHECK_TRUE},
                  {"sin(lever.angle) = sin(theta2)", YK_CHECK_TRUE}, {"sqrt(3/4) = sqrt(3)/2", YK_CHECK_TRUE});
}

static void points_are_spoken_of_by_their_names(void **state)
{
    (void)state;
    CHECK_EXAMPLE("quick-return", {"crank.A.x = d3 cos(theta2)", YK_CHECK_TRUE},
                  {"crank.A.x' = -l1 sin(theta1) theta1'", YK_CHECK_TRUE},
                  {"crank.A.y.accel = l1 cos(theta1) theta1'' - l1 sin(theta1) theta1'^2", YK_CHECK_TRUE},
                  {"ram.C.x = coupler.C.x", YK_CHECK_TRUE}, {"ram.C.y = a1", YK_CHECK_FALSE},
                  {"ram.C.y = a1 + a2", YK_CHECK_TRUE});
}

static void energies_balance_what_efforts_do(void **state)
{
    (void)state;
    CHECK_EXAMPLE("double-pendulum", {"T' + V' = tau1 theta1' + tau2 theta2'", YK_CHECK_TRUE},
                  {"energy' = theta1.effort theta1' + theta2.effort theta2'", YK_CHECK_TRUE},
                  {"T' + V' = tau1 theta1'", YK_CHECK_FALSE},
                  {"V = -m1 g lc1 cos(theta1) - m2 g (l1 cos(theta1) + lc2 cos(theta1 + theta2))", YK_CHECK_TRUE},
                  {"T_link1 = 1/2 (I1 + m1 lc1^2) theta1'^2", YK_CHECK_TRUE}, {"T = T_link1 + T_link2", YK_CHECK_TRUE},
                  {"kinetic + potential = T - V", YK_CHECK_FALSE});
    CHECK_EXAMPLE("toggle", {"T' + V' = tau theta1'", YK_CHECK_TRUE}, {"theta1.effort = tau", YK_CHECK_TRUE},
                  {"B.force.x = m5 d5''", YK_CHECK_TRUE}, {"B.force.x = -m5 d5''", YK_CHECK_FALSE},
                  {"R.moment = 0", YK_CHECK_TRUE});
}

// A moment that is rounding alone is measured by the other forces: it is 0.
static void what_is_nothing_but_rounding_is_nothing(void **state)
{
    (void)state;
    CHECK_EXAMPLE("cart-pendulum", {"M01 = 0", YK_CHECK_TRUE}, {"(N01 - F12y)/5 = 19.62/5", YK_CHECK_TRUE},
                  {"(N01 - F12y)/5 = 20/5", YK_CHECK_FALSE});
    // action and reaction
    CHECK_EXAMPLE("cart-pendulum", {"F21x = -F12x", YK_CHECK_TRUE}, {"N10 + N01 = 0", YK_CHECK_TRUE},
                  {"F21y = F12y", YK_CHECK_FALSE}, {"F20x = 0", YK_CHECK_UNREADABLE});
    Machine m = machine_of("parameters: {a: 0.1, b: 0.2, c: 0.3}\n"
                           "bodies: {arm: {points: {P: [a + b + c, 0]}}}\n"
                           "joints: {O: {pin: [ground, arm], angle: q}}\n");
    assert_int_equal(verdict_on(&m, "(a + b - c) = 0").kind, YK_CHECK_TRUE_HERE); // 0.1 + 0.2 - 0.3 = 5.6e-17
    assert_int_equal(verdict_on(&m, "1/(a + b - c + 1) = 1").kind, YK_CHECK_TRUE_HERE);
    assert_int_equal(verdict_on(&m, "(a + b - c) = 1e-8").kind, YK_CHECK_FALSE);
    machine_end(&m);
}

// --- What a false equation is told

static void check_slip(Machine *m, YkDynamics *dynamics, const char *equation, const char *slip)
{
    YkCheckVerdict verdict = forces_verdict(m, dynamics, equation);
    assert_int_equal(verdict.kind, YK_CHECK_FALSE);
    assert_true(verdict.shown.left != verdict.shown.right);
    if (!slip && !verdict.slip) return;
    if (!slip || !verdict.slip || strcmp(slip, verdict.slip) != 0)
        print_error("%s: %s\n", equation, verdict.slip ? verdict.slip : "no slip");
    assert_true(slip && verdict.slip);
    assert_string_equal(verdict.slip, slip);
}

static void slips_of_the_hand_are_named(void **state)
{
    (void)state;
    Machine m = example("quick-return");
    check_slip(&m, NULL, "d3 cos(theta2) = l1 sin(theta1)",
               "with `cos(theta1)` in place of `sin(theta1)` it would be true");
    check_slip(&m, NULL, "d5 = l2 cos(theta2) + l4 cos(theta4)",
               "with `coupler.angle` in place of `theta4`, which is measured from lever, it would be true");
    check_slip(&m, NULL, "d5 = l2 cos(theta2) + l4 cos(theta2 + theta4) + l1", "without `l1` it would be true");
    check_slip(&m, NULL,
               "d3 theta2'' + d3' theta2' = l1 cos(theta1 - theta2) theta1'' - l1 sin(theta1 - theta2) theta1'^2",
               "with twice `d3' theta2'` it would be true");
    check_slip(&m, NULL, "d3^2 = a1^2 + l1^2 + 4 a1 l1 sin(theta1)",
               "with half of `4 a1 l1 sin(theta1)` it would be true");
    check_slip(&m, NULL, "d3 = 2 d5", NULL);
    check_slip(&m, NULL, "0 = 1", NULL);
    machine_end(&m);
}

// Numbers in the file leave only poses to decide, to nine digits: where the false equation passes there, so would any
// slip.
static void no_slip_explains_what_only_exact_arithmetic_sees(void **state)
{
    (void)state;
    Machine m = machine_of("bodies:\n"
                           "  ground: {points: {O: [0, 0]}}\n"
                           "  crank: {points: {O: [0, 0], A: [0.1, 0]}}\n"
                           "  rod: {points: {A: [0, 0], B: [0.3, 0]}}\n"
                           "  piston: {points: {B: [0, 0]}}\n"
                           "joints:\n"
                           "  O: {pin: [ground, crank], angle: th}\n"
                           "  A: {pin: [crank, rod], angle: ph}\n"
                           "  B: {pin: [rod, piston]}\n"
                           "  S: {slide: [ground, piston], along: x, distance: s}\n"
                           "start: {th: 1, ph: -1.3}\n");
    check_slip(&m, NULL, "s = s + 1e-12", NULL);
    check_slip(&m, NULL, "s = s - 1e-10", NULL);
    check_slip(&m, NULL, "s = -0.1*cos(th) + 0.3*cos(th + ph)",
               "with the other sign before `0.1*cos(th)` it would be true with this file's numbers");
    machine_end(&m);
}

static void what_only_drives_make_true_is_told_so(void **state)
{
    (void)state;
    CHECK_EXAMPLE("quick-return", {"theta1' = -0.5 rad/s", YK_CHECK_TRUE_DRIVEN},
                  {"theta1'' = 0", YK_CHECK_TRUE_DRIVEN}, {"theta1 = 30 deg - 0.5 rad/s*t", YK_CHECK_TRUE_DRIVEN},
                  {"d3^2 = a1^2 + l1^2 + 2 a1 l1 sin(30 deg - 0.5 rad/s*t)", YK_CHECK_TRUE_DRIVEN},
                  {"d3^2 = a1^2 + l1^2 + 2 a1 l1 sin(30 deg + 0.5 rad/s*t)", YK_CHECK_FALSE},
                  {"crank.A.x' = 0.5 rad/s l1 sin(theta1)", YK_CHECK_TRUE_DRIVEN},
                  {"d3 theta2' = -0.5 rad/s l1 cos(theta1 - theta2)", YK_CHECK_TRUE_DRIVEN},
                  {"d3 theta2' = 0.5 rad/s l1 cos(theta1 - theta2)", YK_CHECK_FALSE});
    Machine m = example("quick-return");
    check_slip(&m, NULL, "theta1' = 0.5 rad/s", NULL);
    // an equation that speaks of t is shown false at a time
    YkCheckVerdict verdict = verdict_on(&m, "theta1 = 30 deg - 0.4 rad/s*t");
    assert_int_equal(verdict.kind, YK_CHECK_FALSE);
    assert_true(verdict.shown.has_time && verdict.shown.time > 0);
    CHECK_NEAR(verdict.shown.left, YK_PI / 6 - 0.5 * verdict.shown.time, 1e-12);
    CHECK_NEAR(verdict.shown.right, YK_PI / 6 - 0.4 * verdict.shown.time, 1e-12);
    machine_end(&m);
}

// A load that depends on time differs from its value at t = 0.
static void loads_of_the_time_are_asked_at_any_time(void **state)
{
    (void)state;
    Machine m = machine_of("parameters: {I: 2 kg*m^2, M: 3 N*m, w: 5 rad/s}\n"
                           "bodies: {disk: {inertia: I}}\n"
                           "joints: {O: {pin: [ground, disk], angle: q}}\n"
                           "efforts: {q: M*(1 + w*t)}\n");
    YkDynamics *dynamics = dynamics_of(&m);
    assert_int_equal(forces_verdict(&m, dynamics, "I q'' = M").kind, YK_CHECK_FALSE);
    assert_int_equal(forces_verdict(&m, dynamics, "q.effort = M").kind, YK_CHECK_FALSE);
    assert_int_equal(forces_verdict(&m, dynamics, "I q'' = M (1 + w t)").kind, YK_CHECK_TRUE);
    yk_dynamics_free(dynamics);
    machine_end(&m);
}

static void the_pose_tells_what_the_equation_speaks_of(void **state)
{
    (void)state;
    Machine m = example("toggle");
    YkDynamics *dynamics = dynamics_of(&m);
    assert_int_equal(forces_verdict(&m, dynamics, "theta1 = theta2").shown.order, 0);
    assert_int_equal(forces_verdict(&m, dynamics, "theta1' = d5'/l1").shown.order, 1);
    YkCheckVerdict verdict = forces_verdict(&m, dynamics, "2 B.force.x = m5 d5''");
    assert_int_equal(verdict.shown.order, 2);
    assert_non_null(strstr(verdict.shown.forces, "F45x = "));
    CHECK_NEAR(strtod(strstr(verdict.shown.forces, "= ") + 2, NULL), verdict.shown.left / 2, 1e-4);
    yk_dynamics_free(dynamics);
    machine_end(&m);
}

static void what_cannot_be_read_has_a_hint(void **state)
{
    (void)state;
    static const struct {
        const char *equation, *message, *hint;
    } cases[] = {{"d3 cos theta2 = 1", "`(` is expected after `cos`", "write cos(theta2)"},
                 {"theta1dot = 1", "unknown name `theta1dot`", "did you mean `theta1'`?"},
                 {"theta1_ddot = 1", "unknown name `theta1_ddot`", "did you mean `theta1''`?"},
                 {"l_1 = 2", "unknown name `l_1`", "did you mean `l1`?"},
                 {"d3 = sqrt(l1/(a1 + a2))", "the root of a quotient by a sum", "square both sides"},
                 {"d3(0) = 1.5 m", "an equation here is about any pose", "yoke solve --time"},
                 {"dtheta2/dt = 3", "unknown name `dtheta2`", "did you mean `theta2'`?"},
                 {"x_A = l1 cos(theta1)", "unknown name `x_A`", "did you mean `crank.A.x`?"},
                 {"theta2 = atan2(1, 2)", "`atan2` has many values: it cannot be proved", "tangents"},
                 {"sin^-1(theta1) = 1", "a negative power here could be the inverse function", "1/sin(x)"},
                 {"\xce\xb8"
                  "1 = 2",
                  "this sign cannot be used in equations", "names are the file's"},
                 {"l1 = 2 \xc2\xb7 3", "this sign cannot be used in equations", "products `*`"},
                 {"omega = 2", "unknown name `omega`", "theta1.rate"},
                 {"l1 = l2 = 1", "there is a second `=`: one equation at a time", NULL},
                 {"sin(l1) = 0", "an angle is expected here, this is a length", NULL},
                 {"l1 = 2 kg", "the left side is a length, the right side a mass", NULL},
                 {"d5 = 3 m + 2 s", "what stands before is a length, this is a time", NULL},
                 {"theta1' = 2 m/s", "the left side is an angular speed, the right side a speed", NULL},
                 {"F01x = 3 N*m", "the left side is a force, the right side a torque or energy", NULL},
                 {"M05 = 3 N", "the left side is a torque or energy, the right side a force", NULL},
                 {"crank.A.x' = 2 m", "the left side is a speed, the right side a length", NULL},
                 {"T' = 2 J", "the left side is a power, the right side a torque or energy", NULL},
                 {"F_12 = 0", "unknown name `F_12`", "pages print vectors"},
                 {"p^{A/O} = 0", "unknown name `p`", "pages print vectors"}};
    Machine m = example("quick-return");
    for (size_t k = 0; k < sizeof cases / sizeof *cases; k++) {
        YkProblems *problems = yk_problems_new();
        const char *equation = cases[k].equation;
        YkCheckVerdict verdict =
            yk_derive_check(m.d, m.state, NULL, equation, strlen(equation), (YkPlace){1, 1, 0}, problems);
        assert_int_equal(verdict.kind, YK_CHECK_UNREADABLE);
        assert_int_equal(yk_problems_count(problems), 1);
        expect(yk_problems_get(problems, 0)->message, cases[k].message);
        if (cases[k].hint) expect(yk_problems_get(problems, 0)->hint, cases[k].hint);
        yk_problems_free(problems);
    }
    // and the next one is read as if nothing had been
    assert_int_equal(verdict_on(&m, "crank.A.x = l1 cos(theta1)").kind, YK_CHECK_TRUE);
    machine_end(&m);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(numbers_take_units),
        cmocka_unit_test(names_of_the_machine_come_before_units),
        cmocka_unit_test(dimensions_are_compared_where_they_are_known),
        cmocka_unit_test(books_ways_of_writing_are_read),
        cmocka_unit_test(points_are_spoken_of_by_their_names),
        cmocka_unit_test(energies_balance_what_efforts_do),
        cmocka_unit_test(what_is_nothing_but_rounding_is_nothing),
        cmocka_unit_test(slips_of_the_hand_are_named),
        cmocka_unit_test(no_slip_explains_what_only_exact_arithmetic_sees),
        cmocka_unit_test(what_only_drives_make_true_is_told_so),
        cmocka_unit_test(loads_of_the_time_are_asked_at_any_time),
        cmocka_unit_test(the_pose_tells_what_the_equation_speaks_of),
        cmocka_unit_test(what_cannot_be_read_has_a_hint),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
