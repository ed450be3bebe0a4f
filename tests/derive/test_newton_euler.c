// Newton-Euler in symbols against the numeric engine: equations, count, matrix form.
#include "forces_check.h"

static size_t equations_seen, poses_seen, counted;

static void check_at_poses(Machine *m, const char *name)
{
    check_section_at_poses(m, "newton-euler", name, &equations_seen, &poses_seen);
}

static void every_equation_holds_with_the_engines_accelerations_and_reactions(void **state)
{
    (void)state;
    each_example(check_at_poses);
    assert_true(equations_seen > 2000);
    assert_true(poses_seen > 150);
}

static void compare_counts(const char *name, YkEquationCount a, YkEquationCount b)
{
    if (a.force == b.force && a.moment == b.moment && a.acceleration == b.acceleration &&
        a.unknown_reactions == b.unknown_reactions && a.unknown_accelerations == b.unknown_accelerations &&
        a.unknown_efforts == b.unknown_efforts)
        return;
    print_error("%s: %zu + %zu + %zu, %zu + %zu + %zu against %zu + %zu + %zu, %zu + %zu + %zu\n", name, a.force,
                a.moment, a.acceleration, a.unknown_reactions, a.unknown_accelerations, a.unknown_efforts, b.force,
                b.moment, b.acceleration, b.unknown_reactions, b.unknown_accelerations, b.unknown_efforts);
    fail();
}

// The engine's count takes two equations for every loop: right where a pin closes it.
static bool is_closed_by_pins(const Machine *m)
{
    for (size_t k = 0; k < m->mech->loop_count; k++) {
        YkPartKind kind = m->model->joints[m->mech->loops[k].joint].kind;
        if (kind != YK_PIN && kind != YK_SLIDE) return false;
        if (kind == YK_SLIDE && !yk_derive_loops(m->d)[k].angle) return false;
    }
    return true;
}

static void check_count(Machine *m, const char *name)
{
    const YkDeriveForces *f = forces_of(m);
    if (!is_closed_by_pins(m)) return;
    YkDynamics *dynamics = dynamics_of(m);
    compare_counts(name, yk_derive_count(f, false), yk_dynamics_count(dynamics));
    for (size_t i = 0; i < yk_input_count(m->mech); i++) yk_dynamics_prescribe(dynamics, i, true);
    compare_counts(name, yk_derive_count(f, true), yk_dynamics_count(dynamics));
    counted++;
    yk_dynamics_free(dynamics);
    // The system has as many rows and unknowns.
    YkEquationCount c = yk_derive_count(f, false);
    YkDeriveSystem system;
    assert_true(yk_derive_system(f, &system));
    assert_int_equal(system.row_count, c.force + c.moment + c.acceleration);
    assert_int_equal(system.unknown_count, c.unknown_reactions + c.unknown_accelerations + c.unknown_efforts);
}

static void the_count_is_the_numeric_engines(void **state)
{
    (void)state;
    each_example(check_count);
    assert_true(counted > 35);
}

static void the_toggle_linkage_has_twenty_equations_and_twenty_unknowns(void **state)
{
    (void)state;
    Machine m = example("toggle");
    write_section(&m, "newton-euler");
    check_says(&m, "12 force + 4 moment + 4 acceleration = 20 equations; 15 reactions + 5 accelerations + 0 efforts = "
                   "20 unknowns");
    check_says(&m, "15 reactions + 4 accelerations + 1 efforts = 20 unknowns");
    check_says(&m, "All forces on slider meet in one point");
    machine_end(&m);
}

static void a_redundant_machine_is_told_to_have_more_unknowns_than_equations(void **state)
{
    (void)state;
    Machine m = example("doubled-guide");
    write_section(&m, "newton-euler");
    check_says(&m, "unknowns more than equations");
    machine_end(&m);
}

static void vector_equations_name_arms_and_forces(void **state)
{
    (void)state;
    Machine m = example("double-pendulum");
    write_section(&m, "newton-euler");
    check_says(&m, "F_01 - F_12 + W_link1 = m1 a^{C1}");
    check_says(&m, "p^{O/C1} x F_01 - p^{A/C1} x F_12 + M_theta1 - M_theta2 = I1 alpha_link1");
    check_says(&m, "p^{A/C2} x F_12 + M_theta2 = I2 alpha_link2");
    check_says(&m,
               "moments about O:  -m1 lc1 g sin(theta1) + tau1 - tau2 - l1 F12x cos(theta1) - l1 F12y sin(theta1) = "
               "(I1 + m1 lc1^2) theta1''");
    machine_end(&m);
}

// Gauss, with the values of the pose.
static void solve_system(Machine *m, const YkDeriveForces *f, const YkDeriveSystem *system, double *x)
{
    size_t n = system->row_count;
    assert_int_equal(n, system->unknown_count);
    double *A = calloc(n * (n + 1), sizeof *A);
    const YkPoisson **entries = calloc(n, sizeof *entries);
    assert_true(A && entries);
    for (size_t i = 0; i < n; i++) {
        A[i * (n + 1) + n] = at_pose(m, yk_derive_system_row(f, system, i, entries));
        for (size_t k = 0; k < n; k++) A[i * (n + 1) + k] = at_pose(m, entries[k]);
    }
    free(entries);
    for (size_t p = 0; p < n; p++) {
        size_t best = p;
        for (size_t i = p; i < n; i++)
            if (fabs(A[i * (n + 1) + p]) > fabs(A[best * (n + 1) + p])) best = i;
        assert_true(fabs(A[best * (n + 1) + p]) > 1e-12);
        for (size_t k = 0; k <= n; k++) {
            double held = A[p * (n + 1) + k];
            A[p * (n + 1) + k] = A[best * (n + 1) + k];
            A[best * (n + 1) + k] = held;
        }
        for (size_t i = 0; i < n; i++) {
            double factor = i == p ? 0 : A[i * (n + 1) + p] / A[p * (n + 1) + p];
            for (size_t k = p; k <= n; k++) A[i * (n + 1) + k] -= factor * A[p * (n + 1) + k];
        }
    }
    for (size_t i = 0; i < n; i++) x[i] = A[i * (n + 1) + n] / A[i * (n + 1) + i];
    free(A);
}

static void check_solution(const char *name, bool start)
{
    Machine m = example(name);
    const YkDeriveForces *f = forces_of(&m);
    YkDynamics *dynamics = dynamics_of(&m);
    YkDeriveSystem system;
    assert_true(yk_derive_system(f, &system));
    yk_state_set_time(m.state, 0, NULL);
    assert_true(yk_state_assemble(m.state) >= 0);
    if (!start) assert_true(random_pose(&m, true) && random_pose(&m, false));
    assert_true(take_forces(&m, dynamics, YK_METHOD_REDUCED));
    double *x = calloc(system.unknown_count + 1, sizeof *x), most = 1;
    solve_system(&m, f, &system, x);
    for (size_t k = 0; k < system.unknown_count; k++) most = fmax(most, fabs(x[k]));
    for (size_t k = 0; k < system.unknown_count; k++) CHECK_NEAR(x[k], m.values[system.unknowns[k]], 1e-9 * most);
    free(x);
    yk_dynamics_free(dynamics);
    machine_end(&m);
}

static void the_matrix_form_solves_for_the_engines_accelerations_and_reactions(void **state)
{
    (void)state;
    static const char *const names[] = {"double-pendulum",     "toggle",           "cart-pendulum",
                                        "five-bar-motors",     "torsion-spring",   "crank-press",
                                        "spring-slider-crank", "watt-with-masses", "rocking-four-bar"};
    for (size_t k = 0; k < sizeof names / sizeof *names; k++) {
        check_solution(names[k], true);
        check_solution(names[k], false);
    }
}

// The printed solution of this problem has b with the wrong sign; these are the accelerations of the right one.
static void the_double_pendulum_is_a_six_by_six_system_with_the_right_b(void **state)
{
    (void)state;
    Machine m = example("double-pendulum");
    const YkDeriveForces *f = forces_of(&m);
    YkDeriveSystem system;
    double x[6];
    assert_true(yk_derive_system(f, &system));
    assert_int_equal(system.row_count, 6);
    static const char *const unknowns[] = {"F01x", "F01y", "F12x", "F12y", "theta1''", "theta2''"};
    assert_int_equal(system.unknown_count, 6);
    for (size_t k = 0; k < 6; k++) assert_string_equal(yk_ring_symbol_name(m.d->ring, system.unknowns[k]), unknowns[k]);
    const YkPoisson *entries[6];
    check_element(&m, yk_derive_system_row(f, &system, 1, entries), "m1*lc1*cos(theta1)*theta1'^2 + m1*g");
    check_element(&m, yk_derive_system_row(f, &system, 5, entries), "-tau2");
    assert_non_null(yk_derive_system_row(f, &system, 2, entries));
    check_element(&m, entries[2], "-(l1 - lc1)*cos(theta1)");
    yk_state_set_time(m.state, 0, NULL);
    assert_true(yk_state_assemble(m.state) >= 0);
    take_values(&m); // no forces: they are what is sought
    solve_system(&m, f, &system, x);
    CHECK_NEAR(x[4], -9.55276, 5e-6);
    CHECK_NEAR(x[5], -7.09408, 5e-6);
    machine_end(&m);
}

// The trivial moment of a guide that turns is not zero: it is put in where it acts on.
static void a_block_on_a_turning_lever_passes_its_moment_on(void **state)
{
    (void)state;
    Machine m = machine_of("parameters: {a: 1, l: 0.4, m: 2, I: 0.3}\n"
                           "bodies:\n"
                           "  ground: {points: {P: [0, a], O: [0, 0]}}\n"
                           "  crank: {points: {P: [0, 0], A: [l, 0]}, mass: 1, inertia: 0.1, center: [l/2, 0]}\n"
                           "  lever: {points: {O: [0, 0]}, mass: 1, inertia: 0.2, center: [0.3, 0]}\n"
                           "  block: {points: {A: [0, 0]}, mass: m, inertia: I}\n"
                           "joints:\n"
                           "  P: {pin: [ground, crank], angle: theta1}\n"
                           "  O: {pin: [ground, lever], angle: theta2}\n"
                           "  S: {slide: [lever, block], along: x, distance: d}\n"
                           "  A: {pin: [crank, block]}\n"
                           "start: {theta1: 0.5, theta1.rate: 1, theta2: 1.3, d: 1.2}\n");
    const YkDeriveForces *f = forces_of(&m);
    assert_true(f->bodies[3].is_trivial);
    YkDeriveSystem system;
    YkDynamics *dynamics = dynamics_of(&m);
    assert_true(yk_derive_system(f, &system));
    assert_int_equal(system.row_count, system.unknown_count);
    assert_true(random_pose(&m, true));
    assert_true(take_forces(&m, dynamics, YK_METHOD_NEWTON_EULER));
    double x[32];
    solve_system(&m, f, &system, x);
    for (size_t k = 0; k < system.unknown_count; k++) CHECK_NEAR(x[k], m.values[system.unknowns[k]], 1e-9);
    YkReaction guide = yk_dynamics_reaction(dynamics, 2);
    CHECK_NEAR(guide.moment, 0.3 * m.values[m.d->bodies[3].acceleration], 1e-10);
    yk_dynamics_free(dynamics);
    machine_end(&m);
}

static void printed_equations_read_back_identical(void **state)
{
    (void)state;
    assert_true(check_section_reads_back("newton-euler") > 1500);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_equation_holds_with_the_engines_accelerations_and_reactions),
        cmocka_unit_test(the_count_is_the_numeric_engines),
        cmocka_unit_test(the_toggle_linkage_has_twenty_equations_and_twenty_unknowns),
        cmocka_unit_test(a_redundant_machine_is_told_to_have_more_unknowns_than_equations),
        cmocka_unit_test(vector_equations_name_arms_and_forces),
        cmocka_unit_test(the_matrix_form_solves_for_the_engines_accelerations_and_reactions),
        cmocka_unit_test(the_double_pendulum_is_a_six_by_six_system_with_the_right_b),
        cmocka_unit_test(a_block_on_a_turning_lever_passes_its_moment_on),
        cmocka_unit_test(printed_equations_read_back_identical),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
