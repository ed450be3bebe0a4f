// What equations share changes no verdict, and is forgotten when the machine moves elsewhere.
#include "derive/derive_check.h"
#include "interposed.h"

static const char *const equations[] = {
    "a*cos(theta2) + b*cos(coupler.angle) = d + c*cos(theta4)",
    "a*cos(theta2) - b*cos(coupler.angle) = d + c*cos(theta4)",
    "theta4 = theta2", // of the parallelogram, that its bonds prove
    "gamma = -theta2",
    "gamma = theta2",
    "sin(5/3*theta2) = sin(theta2)", // an angle of its own: a new symbol
    "a*sin(theta2) + b*sin(coupler.angle) = c*sin(theta4)",
    "sqrt(b)*theta2' = sqrt(b)*coupler.rate - sqrt(b)*gamma'", // a root of its own
    "coupler.P.x = a*cos(theta2) + b/2*cos(coupler.angle) - b/4*sin(coupler.angle)",
    "theta2'^2 + gamma'^2 = (theta2' + gamma')^2",
    "theta2'' + gamma'' = coupler.accel",
};
enum { EQUATIONS = sizeof equations / sizeof *equations };

static const char four_bar[] = "parameters: {a: 40 mm, b: %s, c: %s, d: 100 mm}\n"
                               "bodies:\n"
                               "  ground:  {points: {O2: [0, 0], O4: [d, 0]}}\n"
                               "  crank:   {points: {O2: [0, 0], A: [a, 0]}}\n"
                               "  coupler: {points: {A: [0, 0], B: [b, 0], P: [b/2, b/4]}}\n"
                               "  rocker:  {points: {O4: [0, 0], B: [c, 0]}}\n"
                               "joints:\n"
                               "  O2: {pin: [ground, crank], angle: theta2}\n"
                               "  A:  {pin: [crank, coupler], angle: gamma}\n"
                               "  O4: {pin: [ground, rocker], angle: theta4}\n"
                               "  B:  {pin: [coupler, rocker]}\n"
                               "drives: {theta2: 40 deg + 6 rad/s * t}\n"
                               "start: {gamma: %s deg, theta4: %s deg}\n";

typedef struct Shape {
    const char *b, *c, *gamma, *theta4;
} Shape;
static const Shape shapes[] = {{"120 mm", "80 mm", "-20", "57"}, {"d", "a", "-40", "40"}};

static Machine machine_of_shape(const Shape *shape)
{
    char text[2000];
    snprintf(text, sizeof text, four_bar, shape->b, shape->c, shape->gamma, shape->theta4);
    return machine_of(text);
}

static void check_same(const YkCheckVerdict *together, const YkCheckVerdict *alone, const char *equation)
{
    bool same = together->kind == alone->kind && together->is_identity == alone->is_identity &&
                together->poses == alone->poses && together->machines == alone->machines &&
                together->machine_poses == alone->machine_poses && !together->slip == !alone->slip &&
                (!alone->slip || strcmp(together->slip, alone->slip) == 0);
    if (same) return;
    print_error("%s: %d, alone %d; %s\n", equation, (int)together->kind, (int)alone->kind,
                together->slip ? together->slip : "-");
    fail();
}

static void equations_of_one_derivation_are_judged_as_each_alone(void **state)
{
    (void)state;
    size_t kinds[YK_CHECK_UNREADABLE + 1] = {0};
    for (size_t s = 0; s < sizeof shapes / sizeof *shapes; s++) {
        Machine m = machine_of_shape(&shapes[s]);
        for (size_t k = 0; k < 2 * EQUATIONS; k++) { // to and fro: the order matters as little
            const char *equation = equations[k < EQUATIONS ? k : 2 * EQUATIONS - 1 - k];
            Machine other = machine_of_shape(&shapes[s]);
            YkCheckVerdict together = verdict_on(&m, equation), alone = verdict_on(&other, equation);
            check_same(&together, &alone, equation);
            kinds[together.kind]++;
            machine_end(&other);
        }
        machine_end(&m);
    }
    assert_true(kinds[YK_CHECK_TRUE] > 16 && kinds[YK_CHECK_FALSE] > 8 && kinds[YK_CHECK_UNREADABLE] == 0);
}

static void a_machine_that_was_moved_is_asked_where_it_is(void **state)
{
    (void)state;
    Machine m = machine_of_shape(&shapes[0]);
    const char *equation = "a*cos(theta2) = b*cos(gamma)";
    for (int k = 0; k < 3; k++) {
        double angle = 0.7 + 0.2 * k;
        assert_true(yk_state_assemble(m.state) >= 0);
        yk_state_set_input(m.state, 0, (YkMotion){angle, 1, 0});
        assert_true(yk_state_solve(m.state) >= 0);
        YkCheckVerdict verdict =
            yk_derive_check(m.d, m.state, NULL, equation, strlen(equation), (YkPlace){1, 1, 0}, m.problems);
        assert_int_equal(verdict.kind, YK_CHECK_FALSE);
        assert_true(fabs(verdict.shown.positions[0].position - angle) < 1e-12);
        assert_true(fabs(verdict.shown.left - 0.04 * cos(angle)) < 1e-12);
    }
    machine_end(&m);
}

static void any_one_failure_is_survived(void **state)
{
    (void)state;
    skip_unless_interposed();
    Machine m = machine_of_shape(&shapes[1]);
    assert_true(yk_state_assemble(m.state) >= 0);
    YkState *start = yk_state_new(m.mech);
    yk_state_copy(start, m.state);
    const char *equation = "theta4 + gamma = 0*a"; // machines, bonds and points
    YkCheckKind kind = YK_CHECK_UNDECIDED;
    long before = live;
    for (long k = 0, is_past = 0; !is_past; k += k < 200 ? 1 : 7) {
        yk_state_copy(m.state, start);
        countdown = k;
        YkDerivation *d = yk_derivation_new(m.model, m.mech, NULL);
        if (d) kind = yk_derive_check(d, m.state, NULL, equation, strlen(equation), (YkPlace){1, 1, 0}, NULL).kind;
        yk_derivation_free(d);
        is_past = countdown >= 0;
        countdown = -1;
        assert_int_equal(live, before);
    }
    assert_int_equal(kind, YK_CHECK_TRUE);
    yk_state_free(start);
    machine_end(&m);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(equations_of_one_derivation_are_judged_as_each_alone),
        cmocka_unit_test(a_machine_that_was_moved_is_asked_where_it_is),
        cmocka_unit_test(any_one_failure_is_survived),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
