// Free bodies: names, arms, junctions, loads; with the engine's reactions every body is in balance.
#include "forces_check.h"

static size_t bodies_seen;

// Sums of contacts and of loads, each against the engine's own sums of reactions and loads.
static void compare_balances(Machine *m, const char *name)
{
    const YkDeriveForces *f = forces_of(m);
    YkRing *ring = m->d->ring;
    YkDynamics *dynamics = dynamics_of(m);
    for (int pose = 0; pose < 3; pose++) {
        if (!random_pose(m, pose == 0) || !take_forces(m, dynamics, YK_METHOD_NEWTON_EULER)) continue;
        for (size_t b = 1; b < m->d->model->body_count; b++) {
            YkBalance balance = yk_dynamics_balance(dynamics, b);
            const YkPoisson *zero = yk_ring_rational(ring, 0, 1), *force[2] = {zero, zero}, *moment[2] = {zero, zero};
            for (size_t k = 0; k < f->contact_count; k++) {
                if (f->contacts[k].push.body != (int32_t)b) continue;
                force[0] = yk_ring_add(ring, force[0], f->contacts[k].push.force);
                moment[0] = yk_ring_add(ring, moment[0], yk_derive_moment_of(f, &f->contacts[k].push));
            }
            for (size_t k = 0; k < f->load_count; k++)
                for (size_t p = 0; p < f->loads[k].push_count; p++) {
                    if (f->loads[k].push[p].body != (int32_t)b) continue;
                    force[1] = yk_ring_add(ring, force[1], f->loads[k].push[p].force);
                    moment[1] = yk_ring_add(ring, moment[1], yk_derive_moment_of(f, &f->loads[k].push[p]));
                }
            int32_t planets =
                m->d->model->bodies[b].copies; // the equations have the moments of all, the engine tells one's
            if (planets > 1) balance.reactions.moment *= planets, balance.loads.moment *= planets;
            const YkWrench *engine[2] = {&balance.reactions, &balance.loads};
            double most = 1 + yk_mechanism_size(m->mech);
            for (int k = 0; k < 2; k++)
                most += hypot(engine[k]->force[0], engine[k]->force[1]) + fabs(engine[k]->moment);
            for (int k = 0; k < 2; k++) {
                YkVec value = yk_ring_value(ring, force[k], m->values);
                double error = fmax(fabs(value.x - engine[k]->force[0]), fabs(value.y - engine[k]->force[1]));
                error = fmax(error, fabs(at_pose(m, moment[k]) - engine[k]->moment));
                if (error <= 1e-9 * most) continue;
                print_error("%s, %s: off by %g of %g\n", name, m->d->model->bodies[b].name, error, most);
                fail();
            }
            bodies_seen++;
        }
    }
    yk_dynamics_free(dynamics);
}

static void contacts_and_loads_add_up_to_the_engines(void **state)
{
    (void)state;
    each_example(compare_balances);
    assert_true(bodies_seen > 400);
}

static void forces_are_named_by_the_bodies_that_exert_and_bear_them(void **state)
{
    (void)state;
    Machine m = example("toggle");
    write_section(&m, "free-bodies");
    check_says(&m, "by ground at O1:  F_01 = [ F01x ]");
    check_says(&m, "by link2 at A:  - F_12 = [ -F12x ]");
    check_says(&m, "by the pin J at J:  F_J2 = [ FJ2x ]");
    check_says(&m, "by ground at B:  N_05 = [  0  ]");
    check_says(&m, "by ground at B:  M_05 = M05");
    check_says(&m, "F_J3 + F_J4 + F_J2 = 0");
    check_says(&m, "effort:  M_theta1 = tau");
    check_says(&m, "slider, body 5");
    check_says(&m, "inertia:  - 1/12 m1 l1^2 alpha_link1 = -1/12 m1 l1^2 theta1''");
    machine_end(&m);
}

static void a_pin_of_several_bodies_is_one_massless_junction(void **state)
{
    (void)state;
    Machine m = example("toggle");
    const YkDeriveForces *f = forces_of(&m);
    assert_int_equal(f->junction_count, 1);
    assert_string_equal(f->junctions[0].name, "J");
    assert_int_equal(f->reaction_count, 16); // with the guide's moment
    check_element(&m, yk_ring_real(m.d->ring, f->junctions[0].force), "-FJ2x - FJ3x - FJ4x");
    // What the pins carry: by link3 on link4, and by link2 on link3.
    check_element(&m, yk_ring_real(m.d->ring, f->joint_force[3]), "FJ4x");
    check_element(&m, yk_ring_real(m.d->ring, f->joint_force[4]), "-FJ2x");
    YkDynamics *dynamics = dynamics_of(&m);
    assert_true(random_pose(&m, true) && take_forces(&m, dynamics, YK_METHOD_REDUCED));
    for (size_t j = 3; j < 5; j++) {
        YkReaction r = yk_dynamics_reaction(dynamics, j);
        YkVec value = yk_ring_value(m.d->ring, f->joint_force[j], m.values);
        CHECK_NEAR(value.x, r.force[0], 1e-9 * (1 + fabs(r.force[0])));
        CHECK_NEAR(value.y, r.force[1], 1e-9 * (1 + fabs(r.force[1])));
    }
    yk_dynamics_free(dynamics);
    machine_end(&m);
}

static void pins_at_the_ground_are_no_junction(void **state)
{
    (void)state;
    Machine m = machine_of(
        "bodies: {ground: {points: {O: [0, 0]}}, a: {points: {O: [0, 0]}, mass: 1, center: [1, 0], inertia: 1}, "
        "b: {points: {O: [0, 0]}, mass: 1, center: [1, 0], inertia: 1}}\n"
        "joints: {A: {pin: [ground, a], at: O, angle: q1}, B: {pin: [ground, b], at: O, angle: q2}}\n");
    const YkDeriveForces *f = forces_of(&m);
    assert_int_equal(f->junction_count, 0);
    assert_int_equal(f->reaction_count, 4);
    assert_true(yk_ring_find(m.d->ring, "F01x") >= 0 && yk_ring_find(m.d->ring, "F02y") >= 0);
    machine_end(&m);
}

static void two_joints_between_the_same_bodies_have_forces_of_their_own(void **state)
{
    (void)state;
    Machine m = example("doubled-guide");
    const YkDeriveForces *f = forces_of(&m);
    for (size_t i = 0; i < f->reaction_count; i++)
        for (size_t k = 0; k < i; k++) assert_int_not_equal(f->reactions[i], f->reactions[k]);
    size_t named_by_joint = 0;
    for (size_t k = 0; k < f->contact_count; k++) named_by_joint += strchr(f->contacts[k].between, '_') != NULL;
    assert_int_equal(named_by_joint, 4);
    machine_end(&m);
}

static void beyond_ten_bodies_numbers_stand_apart(void **state)
{
    (void)state;
    YkText text = {0};
    yk_text_puts(&text, "bodies:\n  ground: {points: {P0: [0, 0]}}\n");
    for (int k = 1; k <= 11; k++)
        yk_text_format(&text, "  b%d: {points: {P%d: [0, 0], P%d: [1, 0]}, mass: 1}\n", k, k - 1, k);
    yk_text_puts(&text, "joints:\n  P0: {pin: [ground, b1]}\n");
    for (int k = 1; k < 11; k++) yk_text_format(&text, "  P%d: {pin: [b%d, b%d]}\n", k, k, k + 1);
    Machine m = machine_of(yk_text_get(&text));
    yk_text_free(&text);
    forces_of(&m);
    assert_true(yk_ring_find(m.d->ring, "F_10_11x") >= 0);
    assert_true(yk_ring_find(m.d->ring, "F_0_1y") >= 0);
    machine_end(&m);
}

// A name that the file uses stays the file's.
static void a_parameter_called_as_a_force_keeps_its_name(void **state)
{
    (void)state;
    Machine m = machine_of("parameters: {F01x: 2 kg, tau_q: 3}\n"
                           "bodies: {ground: {}, a: {mass: F01x, center: [tau_q, 0], inertia: 1}}\n"
                           "joints: {A: {pin: [ground, a], angle: q}}\ndrives: {q: 2 rad/s * t}\n");
    const YkDeriveForces *f = forces_of(&m);
    assert_string_equal(yk_ring_symbol_name(m.d->ring, f->reactions[0]), "F01x_");
    assert_string_equal(yk_ring_symbol_name(m.d->ring, f->efforts[0]), "tau_q_");
    check_element(&m, yk_derive_mass(m.d, 1), "F01x");
    machine_end(&m);
}

static const YkDeriveLoad *load_of(const YkDeriveForces *f, YkDeriveLoadKind kind)
{
    for (size_t k = 0; k < f->load_count; k++)
        if (f->loads[k].kind == kind) return &f->loads[k];
    fail();
    return NULL;
}

static void loads_that_are_no_polynomials_are_symbols_with_the_files_values(void **state)
{
    (void)state;
    Machine m = machine_of("parameters: {F: 4 N, w: 3 rad/s, k: 2 N}\n"
                           "bodies: {ground: {}, cart: {points: {P: [0.1, 0.2]}, mass: 2 kg}}\n"
                           "joints: {R: {slide: [ground, cart], along: x, distance: x}}\n"
                           "efforts: {x: F*cos(w*t) - 0.5 N*s/m * x.rate}\n"
                           "forces: {push: {body: cart, at: P, value: [k*exp(x/(1 m)), k*abs(x.rate/(1 m/s))]}}\n"
                           "start: {x: 0.4, x.rate: -1.5}\n");
    const YkDeriveForces *f = forces_of(&m);
    assert_int_equal(f->opaque_count, 3);
    YkDynamics *dynamics = dynamics_of(&m);
    yk_state_set_time(m.state, 0.7, NULL);
    assert_true(yk_state_assemble(m.state) >= 0 && take_forces(&m, dynamics, YK_METHOD_REDUCED));
    CHECK_NEAR(m.values[yk_ring_find(m.d->ring, "F_x")], 4 * cos(2.1) + 0.75, 1e-14);
    CHECK_NEAR(m.values[yk_ring_find(m.d->ring, "pushx")], 2 * exp(0.4), 1e-14);
    CHECK_NEAR(m.values[yk_ring_find(m.d->ring, "pushy")], 3, 1e-14);
    check_vanishes(&m, yk_derive_newton(f, 1), "Newton", 1e-13);
    check_vanishes(&m, yk_derive_euler(f, 1), "Euler", 1e-13);
    check_element(&m, load_of(f, YK_DERIVE_FORCE)->push[0].arm, "1/10 + i/5");
    yk_dynamics_free(dynamics);
    machine_end(&m);
}

static void forces_in_a_bodys_axes_turn_with_it(void **state)
{
    (void)state;
    Machine m =
        machine_of("parameters: {F: 4 N, l: 1}\nbodies: {ground: {}, a: {points: {T: [l, 0]}, mass: 1, inertia: 1}}\n"
                   "joints: {A: {pin: [ground, a], angle: q}}\n"
                   "forces: {thrust: {body: a, at: T, value: [0, F], axes: body}}\n");
    const YkDeriveForces *f = forces_of(&m);
    const YkDeriveLoad *load = load_of(f, YK_DERIVE_FORCE);
    check_element(&m, yk_ring_real(m.d->ring, load->push[0].force), "-F*sin(q)");
    check_element(&m, yk_derive_moment_of(f, &load->push[0]), "F*l");
    machine_end(&m);
}

// Dry friction enters as a symbol that has the engine's value.
static void dry_friction_is_a_symbol_with_the_engines_value(void **state)
{
    (void)state;
    Machine m = example("rough-block");
    const YkDeriveForces *f = forces_of(&m);
    YkDynamics *dynamics = dynamics_of(&m);
    yk_state_set_time(m.state, 0, NULL);
    assert_true(yk_state_assemble(m.state) >= 0);
    yk_state_set_input(m.state, 0, (YkMotion){0.2, -0.5, 0});
    assert_true(take_forces(&m, dynamics, YK_METHOD_REDUCED));
    int32_t friction = load_of(f, YK_DERIVE_DRY)->symbol;
    assert_string_equal(yk_ring_symbol_name(m.d->ring, friction), "R_floor");
    CHECK_NEAR(m.values[friction], 0.3 * 10, 1e-12); // mu m g, against the motion
    check_vanishes(&m, yk_derive_newton(f, 1), "Newton", 1e-13);
    yk_dynamics_free(dynamics);
    machine_end(&m);
}

static YkCheckKind verdict_with_forces(Machine *m, YkDynamics *dynamics, const char *equation)
{
    yk_state_set_time(m->state, 0, NULL);
    assert_true(yk_state_assemble(m->state) >= 0);
    return yk_derive_check(m->d, m->state, dynamics, equation, strlen(equation), (YkPlace){1, 1, 0}, m->problems).kind;
}

// Hand-derived equations with forces are true on the machine, and wrong signs are not.
static void relations_decide_about_equations_with_forces(void **state)
{
    (void)state;
    Machine m = example("double-pendulum");
    YkDynamics *dynamics = dynamics_of(&m);
    forces_of(&m);
    assert_int_equal(m.d->relation_count, 0); // they cost: only on demand
    assert_true(yk_derive_enter_forces(m.d) && yk_derive_enter_forces(m.d));
    assert_int_equal(m.d->relation_count, 6);
    static const char *const right[] = {"F12x = m2*(l1*cos(theta1)*theta1'' - l1*sin(theta1)*theta1'^2) + "
                                        "m2*lc2*(cos(theta1 + theta2)*(theta1'' + theta2'') - sin(theta1 + theta2)*"
                                        "(theta1' + theta2')^2)",
                                        "(I2 + m2*lc2^2)*(theta1'' + theta2'') + m2*l1*lc2*(cos(theta2)*theta1'' + "
                                        "sin(theta2)*theta1'^2) + m2*lc2*g*sin(theta1 + theta2) = tau2"};
    for (size_t k = 0; k < 2; k++) assert_int_equal(verdict_with_forces(&m, dynamics, right[k]), YK_CHECK_TRUE);
    assert_int_equal(verdict_with_forces(&m, dynamics,
                                         "(I2 + m2*lc2^2)*(theta1'' + theta2'') + m2*l1*lc2*(cos(theta2)*theta1'' - "
                                         "sin(theta2)*theta1'^2) + m2*lc2*g*sin(theta1 + theta2) = tau2"),
                     YK_CHECK_FALSE);
    yk_dynamics_free(dynamics);
    machine_end(&m);
}

static void equations_of_a_torsion_spring_are_decided(void **state)
{
    (void)state;
    Machine m = example("torsion-spring");
    YkDynamics *dynamics = dynamics_of(&m);
    assert_true(yk_derive_enter_forces(m.d));
    const char *right = "4.1*theta'' + 10*theta' + 200*theta + 2*9.80665*cos(theta) = 0";
    const char *wrong = "4.1*theta'' - 10*theta' + 200*theta + 2*9.80665*cos(theta) = 0";
    assert_int_equal(verdict_with_forces(&m, dynamics, right), YK_CHECK_TRUE);
    assert_int_equal(verdict_with_forces(&m, dynamics, wrong), YK_CHECK_FALSE);
    yk_dynamics_free(dynamics);
    machine_end(&m);
}

static void printed_forces_read_back_identical(void **state)
{
    (void)state;
    assert_true(check_section_reads_back("free-bodies") > 380);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(contacts_and_loads_add_up_to_the_engines),
        cmocka_unit_test(forces_are_named_by_the_bodies_that_exert_and_bear_them),
        cmocka_unit_test(a_pin_of_several_bodies_is_one_massless_junction),
        cmocka_unit_test(pins_at_the_ground_are_no_junction),
        cmocka_unit_test(two_joints_between_the_same_bodies_have_forces_of_their_own),
        cmocka_unit_test(beyond_ten_bodies_numbers_stand_apart),
        cmocka_unit_test(a_parameter_called_as_a_force_keeps_its_name),
        cmocka_unit_test(loads_that_are_no_polynomials_are_symbols_with_the_files_values),
        cmocka_unit_test(forces_in_a_bodys_axes_turn_with_it),
        cmocka_unit_test(dry_friction_is_a_symbol_with_the_engines_value),
        cmocka_unit_test(relations_decide_about_equations_with_forces),
        cmocka_unit_test(equations_of_a_torsion_spring_are_decided),
        cmocka_unit_test(printed_forces_read_back_identical),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
