// Verdicts on equations.
#include "derive/derive_check.h"

static void check_kind(Machine *m, const char *equation, YkCheckKind expected)
{
    YkCheckVerdict verdict = verdict_on(m, equation);
    if (verdict.kind == expected) return;
    print_error("%s: verdict %d, expected %d\n%s", equation, (int)verdict.kind, (int)expected,
                yk_problems_text(m->problems, 0));
    fail();
}

static void right_equations_are_true_for_all_dimensions(void **state)
{
    (void)state;
    static const char *const equations[] = {
        "l1*cos(theta1) - d3*cos(theta2) = 0",
        "a1 + l1*sin(theta1) = d3*sin(theta2)",
        "l2 cos(theta2) + l4 cos(theta2 + theta4) = d5",
        "theta2' = l1 cos(theta1 - theta2) / d3 * theta1'",
        "theta2.rate*d3 = l1*cos(theta1 - theta2)*theta1.rate",
        "d3' = l1 sin(theta2 - theta1) theta1'",
        "d3^2 = a1^2 + l1^2 + 2 a1 l1 sin(theta1)",
        "tan(theta2) = (a1 + l1 sin(theta1)) / (l1 cos(theta1))",
        "d3 theta2'' + 2 d3' theta2' = l1 cos(theta1 - theta2) theta1'' - l1 sin(theta1 - theta2) theta1'^2",
        "d3'' - d3 theta2'^2 = -l1 sin(theta1 - theta2) theta1'' - l1 cos(theta1 - theta2) theta1'^2",
        "coupler.angle' = theta2' + theta4'",
        "l4 cos(coupler.angle) coupler.rate = -l2 cos(theta2) theta2'",
        "block.rate = lever.rate",
    };
    Machine m = example("quick-return");
    for (size_t k = 0; k < sizeof equations / sizeof *equations; k++) check_kind(&m, equations[k], YK_CHECK_TRUE);
    machine_end(&m);
}

static void wrong_equations_are_false_with_a_pose_that_shows_it(void **state)
{
    (void)state;
    static const char *const equations[] = {
        "l1*cos(theta1) + d3*cos(theta2) = 0",
        "l1*sin(theta1) - d3*sin(theta2) = 0",
        "theta2' = l1 sin(theta1 - theta2) / d3 * theta1'",
        "d3' = l1 sin(theta1 - theta2) theta1'",
        "d3 theta2'' = l1 cos(theta1 - theta2) theta1'' - l1 sin(theta1 - theta2) theta1'^2", // without Coriolis
        "d3 theta2'' + d3' theta2' = l1 cos(theta1 - theta2) theta1'' - l1 sin(theta1 - theta2) theta1'^2",
        "theta1 = theta2",
        "l1 = l2",
        "0 = 1",
    };
    Machine m = example("quick-return");
    for (size_t k = 0; k < sizeof equations / sizeof *equations; k++) {
        YkCheckVerdict verdict = verdict_on(&m, equations[k]);
        assert_int_equal(verdict.kind, YK_CHECK_FALSE);
        assert_true(fabs(verdict.shown.left - verdict.shown.right) > 1e-6);
    }
    machine_end(&m);
}

static void a_wrong_sign_is_found(void **state)
{
    (void)state;
    Machine m = example("toggle");
    YkCheckVerdict verdict = verdict_on(&m, "l1*cos(theta1) + l2*cos(theta1 + theta2) = a0x - l3*cos(theta3)");
    assert_int_equal(verdict.kind, YK_CHECK_FALSE);
    assert_non_null(verdict.slip);
    assert_non_null(strstr(verdict.slip, "`l3*cos(theta3)`"));
    verdict = verdict_on(&m, "l1*cos(theta1) = l2*sin(theta2)");
    assert_int_equal(verdict.kind, YK_CHECK_FALSE);
    assert_null(verdict.slip);
    machine_end(&m);
}

static void what_only_these_numbers_make_true_is_told_apart(void **state)
{
    (void)state;
    Machine m = example("quick-return");
    YkCheckVerdict verdict = verdict_on(&m, "l1 = 3/4");
    assert_int_equal(verdict.kind, YK_CHECK_TRUE_HERE);
    assert_true(verdict.is_false_there);
    assert_int_equal(strncmp(verdict.shown.machine, "l1 = ", 5), 0); // no other parameter is named
    CHECK_NEAR(verdict.shown.left, strtod(verdict.shown.machine + 5, NULL), 1e-15);
    CHECK_NEAR(verdict.shown.right, 0.75, 1e-15);
    assert_true(verdict.poses >= 8);
    check_kind(&m, "a1*l1*cos(theta1) = a2*d3*cos(theta2)", YK_CHECK_TRUE_HERE); // a1 = a2 in this file
    machine_end(&m);
}

static void parallel_cranks_turn_together_only_with_these_lengths(void **state)
{
    (void)state;
    Machine m = machine_of("parameters: {a: 1, b: 3}\n"
                           "bodies:\n"
                           "  ground: {points: {O: [0, 0], C: [b, 0]}}\n"
                           "  crank: {points: {O: [0, 0], A: [a, 0]}}\n"
                           "  rod: {points: {A: [0, 0], B: [3, 0]}}\n"
                           "  other: {points: {C: [0, 0], B: [1, 0]}}\n"
                           "joints:\n"
                           "  O: {pin: [ground, crank], angle: t1}\n"
                           "  A: {pin: [crank, rod], angle: t2}\n"
                           "  C: {pin: [ground, other], angle: t3}\n"
                           "  B: {pin: [rod, other]}\n"
                           "start: {t1: 1, t2: -1, t3: 1}\n");
    check_kind(&m, "t1' = t3'", YK_CHECK_TRUE_HERE);
    check_kind(&m, "t1' = -t3'", YK_CHECK_FALSE);
    machine_end(&m);
}

static void identities_need_no_loop(void **state)
{
    (void)state;
    Machine m = example("double-pendulum");
    YkCheckVerdict verdict = verdict_on(&m, "sin(theta1)^2 + cos(theta1)^2 = 1");
    assert_int_equal(verdict.kind, YK_CHECK_TRUE);
    assert_true(verdict.is_identity);
    check_kind(&m, "cos(theta1 + theta2) = cos(theta1)*cos(theta2) - sin(theta1)*sin(theta2)", YK_CHECK_TRUE);
    check_kind(&m, "cos(theta1 + theta2) = cos(theta1)*cos(theta2) + sin(theta1)*sin(theta2)", YK_CHECK_FALSE);
    machine_end(&m);
}

static void four_bars_obey_freudenstein_and_the_ratio_of_the_books(void **state)
{
    (void)state;
    Machine m = example("four-bar");
    check_kind(&m, "c sin(theta4 - coupler.angle) theta4' = a sin(theta2 - coupler.angle) theta2'", YK_CHECK_TRUE);
    check_kind(&m, "c sin(theta4 - coupler.angle) theta4' = -a sin(theta2 - coupler.angle) theta2'", YK_CHECK_FALSE);
    // Freudenstein 1955: K1 cos(theta4) - K2 cos(theta2) + K3 = cos(theta2 - theta4)
    check_kind(&m, "d/a cos(theta4) - d/c cos(theta2) + (a^2 - b^2 + c^2 + d^2)/(2 a c) = cos(theta2 - theta4)",
               YK_CHECK_TRUE);
    check_kind(&m, "d/a cos(theta4) - d/c cos(theta2) + (a^2 + b^2 + c^2 + d^2)/(2 a c) = cos(theta2 - theta4)",
               YK_CHECK_FALSE);
    machine_end(&m);
}

static void parameters_that_follow_from_others_stay_tied_to_them(void **state)
{
    (void)state;
    Machine m = machine_of("parameters: {l: 2, r: l/2, alpha: 30 deg, beta: 2*alpha}\n"
                           "bodies: {arm: {points: {P: [r, 0]}}}\n"
                           "joints: {O: {pin: [ground, arm], angle: q}}\n");
    check_kind(&m, "l = 2 r", YK_CHECK_TRUE);
    check_kind(&m, "cos(beta) = cos(alpha)^2 - sin(alpha)^2", YK_CHECK_TRUE);
    check_kind(&m, "sin(alpha) = 1/2", YK_CHECK_TRUE_HERE);
    machine_end(&m);
}

static void what_cannot_be_read_is_told_with_its_place(void **state)
{
    (void)state;
    static const struct {
        const char *equation;
        uint32_t column;
    } cases[] = {{"l1 = foo", 6},      {"l1", 3}, {"l1 + = 2", 6}, {"(l1 = 2", 1},         {"l1 = 2 )", 8},
                 {"l1^theta1 = 2", 4}, {"", 1},   {"l1 = ", 6},    {"l1 = cos(theta1", 9}, {"l1 = #", 6}};
    Machine m = example("quick-return");
    for (size_t k = 0; k < sizeof cases / sizeof *cases; k++) {
        YkProblems *problems = yk_problems_new();
        YkCheckVerdict verdict = yk_derive_check(m.d, m.state, NULL, cases[k].equation, strlen(cases[k].equation),
                                                 (YkPlace){1, 1, 0}, problems);
        assert_int_equal(verdict.kind, YK_CHECK_UNREADABLE);
        assert_int_equal(yk_problems_count(problems), 1);
        if (yk_problems_get(problems, 0)->place.column != cases[k].column)
            print_error("%s: column %u\n", cases[k].equation, yk_problems_get(problems, 0)->place.column);
        assert_int_equal(yk_problems_get(problems, 0)->place.column, cases[k].column);
        yk_problems_free(problems);
    }
    machine_end(&m);
}

// With forces: the double pendulum's two equations, and one with a term that is missing or turned.
static void equations_of_motion_are_proved_too(void **state)
{
    (void)state;
    static const struct {
        const char *equation;
        YkCheckKind kind;
    } cases[] = {
        {"(I1 + I2 + m1 lc1^2 + m2 (l1^2 + lc2^2) + 2 m2 l1 lc2 cos(theta2)) theta1'' + "
         "(I2 + m2 lc2^2 + m2 l1 lc2 cos(theta2)) theta2'' - m2 l1 lc2 sin(theta2) theta2' (2 theta1' + theta2') + "
         "g ((m1 lc1 + m2 l1) sin(theta1) + m2 lc2 sin(theta1 + theta2)) = tau1",
         YK_CHECK_TRUE},
        {"(I2 + m2 lc2^2 + m2 l1 lc2 cos(theta2)) theta1'' + (I2 + m2 lc2^2) theta2'' + "
         "m2 l1 lc2 sin(theta2) theta1'^2 + g m2 lc2 sin(theta1 + theta2) = tau2",
         YK_CHECK_TRUE},
        {"(I2 + m2 lc2^2 + m2 l1 lc2 cos(theta2)) theta1'' + (I2 + m2 lc2^2) theta2'' - "
         "m2 l1 lc2 sin(theta2) theta1'^2 + g m2 lc2 sin(theta1 + theta2) = tau2",
         YK_CHECK_FALSE},
        {"(m2 lc2^2 + m2 l1 lc2 cos(theta2)) theta1'' + (I2 + m2 lc2^2) theta2'' + "
         "m2 l1 lc2 sin(theta2) theta1'^2 + g m2 lc2 sin(theta1 + theta2) = tau2",
         YK_CHECK_FALSE},
    };
    Machine m = example("double-pendulum");
    YkDynamics *dynamics = yk_dynamics_new(m.mech, m.problems);
    assert_non_null(dynamics);
    for (size_t k = 0; k < sizeof cases / sizeof *cases; k++) {
        yk_state_set_time(m.state, 0, NULL);
        assert_true(yk_state_assemble(m.state) >= 0);
        YkCheckVerdict verdict = yk_derive_check(m.d, m.state, dynamics, cases[k].equation, strlen(cases[k].equation),
                                                 (YkPlace){1, 1, 0}, m.problems);
        assert_int_equal(verdict.kind, cases[k].kind);
    }
    yk_dynamics_free(dynamics);
    machine_end(&m);
}

// At a random point of the motion all loop rows, J q' and J q'' - gamma vanish.
static void visit_point(Machine *m, const char *name)
{
    bool is_possible;
    YkFieldPoint *point = loop_point(m->d, 5, &is_possible);
    if (!point) {
        assert_false(is_possible);
        return;
    }
    const YkDeriveBlocks *blocks = yk_derive_blocks(m->d);
    for (size_t r = 0; r < blocks->row_count; r++) {
        const YkPoisson *value = blocks->rows[r].value;
        for (int order = 0; order < 3; order++) {
            if (yk_ring_field(m->d->ring, value, point, false) != 0)
                print_error("%s: row %zu order %d\n", name, r, order);
            assert_true(yk_ring_field(m->d->ring, value, point, false) == 0);
            value = yk_ring_time_derivative(m->d->ring, value);
        }
    }
    yk_field_point_free(point);
}

static void random_points_lie_on_the_machines_motion(void **state)
{
    (void)state;
    assert_true(each_example(visit_point) > 30);
    bool is_possible;
    Machine m = example("quick-return");
    YkFieldPoint *point = loop_point(m.d, 1, &is_possible);
    assert_non_null(point); // here it must be possible
    yk_field_point_free(point);
    machine_end(&m);
}

static size_t lines_proved;

// Every line of the page that states an equation is true at a random point.
static void check_lines(Machine *m, const char *name)
{
    bool is_possible;
    YkFieldPoint *point = loop_point(m->d, 3, &is_possible);
    assert_non_null(point);
    for (const YkLine *line = m->page.first; line; line = line->next) {
        YkText text = {0};
        bool is_influence =
            line->left && line->solved >= 0 && strncmp(yk_ring_symbol_name(m->d->ring, line->solved), "k_", 2) == 0;
        const YkPoisson *zero = line_vanishes(m->d->ring, line);
        if (!line->left || is_influence) continue;
        assert_non_null(zero);
        if (yk_ring_field(m->d->ring, zero, point, false) != 0) {
            yk_ring_write(m->d->ring, zero, YK_RING_TEXT, YK_RING_TEXTBOOK, &text);
            print_error("%s: %s\n", name, yk_text_get(&text));
            fail();
        }
        yk_text_free(&text);
        lines_proved++;
    }
    yk_field_point_free(point);
}

// Whatever a section prints as a solution must be found true, and false with one sign turned.
static void visit_printed(Machine *m, const char *name)
{
    bool is_possible;
    YkFieldPoint *point = loop_point(m->d, 3, &is_possible);
    if (!point) return;
    yk_field_point_free(point);
    for (size_t k = 0; k <= section_of("velocity"); k++) assert_true(yk_derive_write(m->d, k, &m->page));
    check_lines(m, name);
}

// The forces with their equations, all of them.
static void visit_dynamics(Machine *m, const char *name)
{
    bool is_possible;
    YkFieldPoint *point = loop_point(m->d, 3, &is_possible);
    if (!point) return;
    yk_field_point_free(point);
    for (size_t k = section_of("free-bodies"); k <= section_of("lagrange"); k++)
        assert_true(yk_derive_write(m->d, k, &m->page));
    check_lines(m, name);
}

static void equations_of_forces_are_proved_on_the_loops(void **state)
{
    (void)state;
    assert_true(each_example(visit_dynamics) > 30);
    assert_true(lines_proved > 600);
}

static void what_sections_print_is_proved_on_the_loops(void **state)
{
    (void)state;
    assert_true(each_example(visit_printed) > 30);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(right_equations_are_true_for_all_dimensions),
        cmocka_unit_test(wrong_equations_are_false_with_a_pose_that_shows_it),
        cmocka_unit_test(a_wrong_sign_is_found),
        cmocka_unit_test(what_only_these_numbers_make_true_is_told_apart),
        cmocka_unit_test(parallel_cranks_turn_together_only_with_these_lengths),
        cmocka_unit_test(identities_need_no_loop),
        cmocka_unit_test(four_bars_obey_freudenstein_and_the_ratio_of_the_books),
        cmocka_unit_test(parameters_that_follow_from_others_stay_tied_to_them),
        cmocka_unit_test(what_cannot_be_read_is_told_with_its_place),
        cmocka_unit_test(equations_of_motion_are_proved_too),
        cmocka_unit_test(random_points_lie_on_the_machines_motion),
        cmocka_unit_test(what_sections_print_is_proved_on_the_loops),
        cmocka_unit_test(equations_of_forces_are_proved_on_the_loops),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
