// Lagrange's equations: as in textbooks, the same as Newton-Euler's by proof, and true with the engine's numbers.
#include "derive/forces/lagrange.h"
#include "forces_check.h"

static size_t equations_seen, poses_seen;

static void the_double_pendulum_prints_as_in_the_books(void **state)
{
    (void)state;
    Machine m = example("double-pendulum");
    write_section(&m, "lagrange");
    check_says(&m, "(I1 + I2 + m1 lc1^2 + m2 (l1^2 + lc2^2) + 2 m2 l1 lc2 cos(theta2)) theta1'' + (I2 + m2 lc2^2 + "
                   "m2 l1 lc2 cos(theta2)) theta2'' - m2 l1 lc2 sin(theta2) theta2' (2 theta1' + theta2') + "
                   "g ((m1 lc1 + m2 l1) sin(theta1) + m2 lc2 sin(theta1 + theta2)) = tau1\n");
    check_says(&m, "(I2 + m2 lc2^2 + m2 l1 lc2 cos(theta2)) theta1'' + (I2 + m2 lc2^2) theta2'' + "
                   "m2 l1 lc2 sin(theta2) theta1'^2 + m2 lc2 g sin(theta1 + theta2) = tau2\n");
    check_says(&m, "Proved: both are the same");
    machine_end(&m);
}

// The five constants of the double pendulum are those that an identification finds.
static void lumped_constants_are_the_classical_five(void **state)
{
    (void)state;
    Machine m = example("double-pendulum");
    const YkDeriveForces *f = forces_of(&m);
    write_section(&m, "lagrange");
    static const char *const expected[] = {"I1 + I2 + m1*lc1^2 + m2*(l1^2 + lc2^2)", "I2 + m2*lc2^2",
                                           "(m1*lc1 + m2*l1)*g", "m2*l1*lc2", "m2*lc2*g"};
    size_t count = 0;
    for (const YkDeriveLump *l = f->lumps[0]; l; l = l->next, count++) {
        assert_true(count < 5);
        check_element(&m, l->value, expected[count]);
    }
    assert_int_equal(count, 5);
    check_says(&m, "(p1 + 2 p4 cos(theta2)) theta1'' + (p2 + p4 cos(theta2)) theta2'' - p4 sin(theta2) theta2' "
                   "(2 theta1' + theta2') + p3 sin(theta1) + p5 sin(theta1 + theta2) = tau1\n");
    machine_end(&m);
}

static void lumps_put_back_give_the_equation(void **state)
{
    (void)state;
    for (size_t e = 0; e < PROVED_EXAMPLES; e++) {
        Machine m = example(proved_examples[e]);
        const YkDeriveForces *f = forces_of(&m);
        for (size_t k = 0; k < m.d->coordinate_count; k++) {
            const YkPoisson *left = yk_derive_lagrange_of(f, k).left, *lumped = yk_derive_lumped(f, left);
            YkRingChange changes[64];
            size_t count = 0;
            for (const YkDeriveLump *l = f->lumps[0]; l && count < 64; l = l->next) {
                int32_t first = yk_ring_next_symbol(m.d->ring, l->value, -1);
                bool has_more = yk_ring_terms(l->value) > 1 || yk_ring_next_symbol(m.d->ring, l->value, first) >= 0;
                assert_true(has_more); // a power of one symbol keeps its name
                changes[count++] = (YkRingChange){l->symbol, l->value, NULL};
            }
            assert_true(count < 64);
            assert_true(yk_ring_is_same(yk_ring_substitute(m.d->ring, lumped, changes, count), left));
            assert_true(yk_ring_terms(lumped) <= yk_ring_terms(left));
        }
        machine_end(&m);
    }
}

static void check_methods(Machine *m, const char *name)
{
    const YkDeriveForces *f = forces_of(m);
    for (size_t k = 0; k < m->d->coordinate_count; k++)
        if (!yk_derive_do_methods_agree(f, k)) {
            print_error("%s, %s\n", name, m->d->coordinates[k].name);
            fail();
        }
    assert_true(yk_derivation_is_well(m->d));
}

static void projected_newton_euler_is_lagrange_exactly(void **state)
{
    (void)state;
    assert_true(each_example(check_methods) > 60);
    Machine m = example("excavator"); // rows in the axes of the boom
    write_section(&m, "lagrange");
    check_says(&m, "Proved: with the loops closed both are the same, term by term");
    machine_end(&m);
}

// The proof is not a formality: with another sign of a force it fails.
// What was derived for a body is forgotten with its force.
static void set_force(YkDeriveForces *f, YkDerivePush *push, const YkPoisson *force)
{
    push->force = force;
    f->newton[push->body] = f->euler[push->body] = NULL;
}

static void a_wrong_force_is_no_longer_proved(void **state)
{
    (void)state;
    Machine m = example("toggle");
    YkDeriveForces *f = (YkDeriveForces *)forces_of(&m);
    assert_true(yk_derive_do_methods_agree(f, 0));
    YkDerivePush *push = &f->contacts[3].push; // by link1 on link2, at A, which moves
    assert_int_equal(push->body, 2);
    const YkPoisson *right = push->force;
    set_force(f, push, yk_ring_negate(m.d->ring, right));
    assert_false(yk_derive_do_methods_agree(f, 0));
    set_force(f, push, right);
    assert_true(yk_derive_do_methods_agree(f, 0));
    const YkPoisson **identities = yk_derive_multipliers(f)->identities;
    identities[0] = yk_ring_negate(m.d->ring, identities[0]);
    assert_false(yk_derive_do_methods_agree(f, 0));
    machine_end(&m);
}

static void check_at_poses(Machine *m, const char *name)
{
    check_section_at_poses(m, "lagrange", name, &equations_seen, &poses_seen);
}

static void every_equation_holds_with_the_engines_accelerations_and_multipliers(void **state)
{
    (void)state;
    each_example(check_at_poses);
    assert_true(equations_seen > 1500);
    assert_true(poses_seen > 150);
}

static void multipliers_are_the_forces_of_the_joints_that_close_loops(void **state)
{
    (void)state;
    Machine m = example("toggle");
    const YkDeriveMultipliers *multipliers = yk_derive_multipliers(forces_of(&m));
    YkDynamics *dynamics = dynamics_of(&m);
    assert_true(random_pose(&m, true));
    assert_true(take_forces(&m, dynamics, YK_METHOD_REDUCED));
    assert_int_equal(multipliers->count, 4);
    for (size_t k = 0; k < 4; k++) {
        YkReaction r = yk_dynamics_reaction(dynamics, (size_t)multipliers->joint[k]);
        CHECK_NEAR(m.values[multipliers->symbols[k]], r.force[k % 2], 1e-9 * (1 + fabs(r.force[k % 2])));
    }
    yk_dynamics_free(dynamics);
    machine_end(&m);
}

static void the_mass_matrix_is_symmetric(void **state)
{
    (void)state;
    for (size_t e = 0; e < PROVED_EXAMPLES; e++) {
        Machine m = example(proved_examples[e]);
        const YkDeriveForces *f = forces_of(&m);
        for (size_t i = 0; i < m.d->tree_count; i++)
            for (size_t k = 0; k < i; k++) {
                const YkPoisson *a = yk_derive_lagrange_of(f, i).left, *b = yk_derive_lagrange_of(f, k).left;
                assert_true(yk_ring_is_same(yk_ring_coefficient(m.d->ring, a, m.d->coordinates[k].acceleration, 1),
                                            yk_ring_coefficient(m.d->ring, b, m.d->coordinates[i].acceleration, 1)));
            }
        machine_end(&m);
    }
}

// In the bodies' own angles a chain of n links has few terms; the joints' equations are sums of theirs.
static void a_long_chain_is_shown_in_the_angles_of_its_bodies(void **state)
{
    (void)state;
    YkText text = {0};
    enum { N = 8 };
    yk_text_puts(
        &text,
        "parameters: {l: 1, m: 2, I: 0.1, g: 9.81}\ngravity: [0, -g]\nbodies:\n  ground: {points: {P0: [0, 0]}}\n");
    for (int k = 0; k < N; k++)
        yk_text_format(&text, "  link%d: {points: {P%d: [0, 0], P%d: [l, 0]}, mass: m, center: [l/2, 0], inertia: I}\n",
                       k + 1, k, k + 1);
    yk_text_puts(&text, "joints:\n");
    for (int k = 0; k < N; k++) {
        if (k == 0)
            yk_text_puts(&text, "  P0: {pin: [ground, link1], angle: q1}\n");
        else
            yk_text_format(&text, "  P%d: {pin: [link%d, link%d], angle: q%d}\n", k, k, k + 1, k + 1);
    }
    Machine m = machine_of(yk_text_get(&text));
    yk_text_free(&text);
    const YkDeriveForces *f = forces_of(&m);
    assert_false(yk_derive_shows_joints(m.d));
    write_section(&m, "lagrange");
    check_says(&m, "In the angles of the bodies against the ground");
    size_t own = 0, joint = 0;
    for (size_t k = 0; k < N; k++) {
        own += yk_ring_terms(yk_derive_lagrange(f, k).left);
        joint += yk_ring_terms(yk_derive_lagrange_of(f, k).left);
        assert_true(yk_derive_do_methods_agree(f, k));
    }
    assert_true(own * 4 < joint);
    YkDynamics *dynamics = dynamics_of(&m);
    assert_true(random_pose(&m, true));
    assert_true(take_forces(&m, dynamics, YK_METHOD_REDUCED));
    assert_true(check_page(&m, "chain", 1e-11) >= N);
    for (size_t k = 0; k < N; k++) {
        YkDeriveLagrange sides = yk_derive_lagrange_of(f, k);
        check_vanishes(&m, yk_ring_subtract(m.d->ring, sides.left, sides.right), "chain in joint angles", 1e-11);
    }
    yk_dynamics_free(dynamics);
    machine_end(&m);
}

// A slide that closes a loop has a distance of its own: its equation says that the guide exerts no force along itself.
static void a_closing_slide_has_an_equation_for_its_distance(void **state)
{
    (void)state;
    Machine m = machine_of("parameters: {a: 1, l: 0.4, k: 30, c: 2}\n"
                           "gravity: [0, -9.81]\n"
                           "bodies:\n"
                           "  ground: {points: {P: [0, a], O: [0, 0]}}\n"
                           "  crank: {points: {P: [0, 0], A: [l, 0]}, mass: 1, inertia: 0.1, center: [l/2, 0]}\n"
                           "  block: {points: {A: [0, 0]}, mass: 0.5, inertia: 0.03}\n"
                           "  lever: {points: {O: [0, 0]}, mass: 1, inertia: 0.2, center: [0.3, 0]}\n"
                           "joints:\n"
                           "  P: {pin: [ground, crank], angle: theta1}\n"
                           "  A: {pin: [crank, block], angle: psi}\n"
                           "  O: {pin: [ground, lever], angle: theta2}\n"
                           "  S: {slide: [lever, block], along: x, friction: {viscous: 0.7}}\n"
                           "springs: {spring: {between: [ground.O, crank.A], stiffness: k, length: 0.3, damping: c}}\n"
                           "start: {theta1: 0.5, theta1.rate: 1, theta2: 1.3, psi: 0.8}\n");
    const YkDeriveForces *f = forces_of(&m);
    assert_int_equal(m.d->coordinate_count, m.d->tree_count + 1);
    for (size_t k = 0; k < m.d->coordinate_count; k++) assert_true(yk_derive_do_methods_agree(f, k));
    write_section(&m, "lagrange");
    write_section(&m, "newton-euler");
    YkDynamics *dynamics = dynamics_of(&m);
    for (int k = 0; k < 5; k++) {
        if (!random_pose(&m, k == 0)) continue;
        assert_true(take_forces(&m, dynamics, YK_METHOD_REDUCED));
        assert_true(check_page(&m, "closing slide", 1e-11) > 15);
    }
    yk_dynamics_free(dynamics);
    machine_end(&m);
}

static void printed_equations_read_back_identical(void **state)
{
    (void)state;
    assert_true(check_section_reads_back("lagrange") > 500);
}

static void every_format_prints_the_section(void **state)
{
    (void)state;
    Machine m = example("toggle");
    write_section(&m, "lagrange");
    write_section(&m, "newton-euler");
    write_section(&m, "energy");
    write_section(&m, "free-bodies");
    YkDynamics *dynamics = dynamics_of(&m);
    assert_true(random_pose(&m, true) && take_forces(&m, dynamics, YK_METHOD_REDUCED));
    for (int format = 0; format < YK_PAGE_FORMATS; format++) {
        YkText text = {0};
        assert_true(yk_page_write(&m.page, (YkPageFormat)format, "Toggle", page_values(&m), &text));
        assert_true(text.length > 2000);
        assert_null(strstr(yk_text_get(&text), "(null)"));
        if (format == YK_PAGE_C) assert_non_null(strstr(yk_text_get(&text), "M[0][0] = "));
        yk_text_free(&text);
    }
    yk_dynamics_free(dynamics);
    machine_end(&m);
}

// Its mass matrix is empty, and so a function would have nothing to write.
static void a_machine_without_freedom_has_no_function_for_its_mass_matrix(void **state)
{
    (void)state;
    Machine m = machine_of("bodies:\n  ground: {points: {O: [0, 0]}}\n  plate: {points: {O: [0, 0]}, mass: 1}\n"
                           "joints:\n  W: {weld: [ground, plate]}\n");
    write_section(&m, "lagrange");
    write_section(&m, "energy");
    YkText text = {0};
    assert_true(yk_page_write(&m.page, YK_PAGE_C, "Plate", NULL, &text));
    assert_non_null(strstr(yk_text_get(&text), "machine_energy("));
    assert_null(strstr(yk_text_get(&text), "machine_lagrange("));
    yk_text_free(&text);
    machine_end(&m);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_double_pendulum_prints_as_in_the_books),
        cmocka_unit_test(lumped_constants_are_the_classical_five),
        cmocka_unit_test(lumps_put_back_give_the_equation),
        cmocka_unit_test(projected_newton_euler_is_lagrange_exactly),
        cmocka_unit_test(a_wrong_force_is_no_longer_proved),
        cmocka_unit_test(every_equation_holds_with_the_engines_accelerations_and_multipliers),
        cmocka_unit_test(multipliers_are_the_forces_of_the_joints_that_close_loops),
        cmocka_unit_test(the_mass_matrix_is_symmetric),
        cmocka_unit_test(a_long_chain_is_shown_in_the_angles_of_its_bodies),
        cmocka_unit_test(a_closing_slide_has_an_equation_for_its_distance),
        cmocka_unit_test(printed_equations_read_back_identical),
        cmocka_unit_test(every_format_prints_the_section),
        cmocka_unit_test(a_machine_without_freedom_has_no_function_for_its_mass_matrix),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
