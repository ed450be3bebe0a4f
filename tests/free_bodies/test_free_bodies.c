// Reactions, efforts and accelerations against closed forms: pendulums, beams, slider-cranks, slides that turn, guides
// that share a load.
#include "loads_check.h"

static const YkVec down = {0, -9.81};

// --- statics --------------------------------------------------------------------------------------------------------

static void test_a_beam_rests_on_two_supports_by_the_law_of_levers(void **unused)
{
    (void)unused;
    Rig r =
        rig_parse("bodies: {ground: {points: {A: [0, 0], B: [3, 0]}}, beam: {points: {A: [0, 0], B: [3, 0]}, mass: 2, "
                  "center: [1.5, 0], inertia: 1}}\n"
                  "joints: {A: {pin: [ground, beam]}, B: {pin-slot: [ground, beam], at: B, from: B, along: x}}\n");
    load_gravity(&r, down);
    load_force(&r, 1, yk_vec(1, 0), yk_vec(30, -60));
    assert_int_equal(rig_inverse(&r), YK_OK);
    CHECK_VEC(reaction(&r, "A").force, -30, 40 + 9.81, 1e-13);
    CHECK_VEC(reaction(&r, "B").force, 0, 20 + 9.81, 1e-13);
    assert_true(reaction(&r, "A").is_determinate && reaction(&r, "B").is_determinate);
    assert_true(imbalance_of(r.bodies) < 1e-15);
    rig_free(&r);
}

static void test_a_weld_carries_force_and_moment(void **unused)
{
    (void)unused;
    Rig r = rig_parse("bodies: {ground: {points: {W: [1, 1]}}, beam: {points: {W: [0, 0], tip: [2, 0]}}}\n"
                      "joints: {W: {weld: [ground, beam], at: W, turned: 90 deg}}\n");
    load_force(&r, 1, yk_vec(1, 3), yk_vec(5, 7)); // the tip stands 2 m over the weld
    assert_int_equal(rig_inverse(&r), YK_OK);
    CHECK_VEC(reaction(&r, "W").force, -5, -7, 1e-14);
    CHECK_NEAR(reaction(&r, "W").moment, 10, 1e-14);
    rig_free(&r);
}

static void test_a_slide_carries_a_normal_force_a_moment_and_the_effort_along_it(void **unused)
{
    (void)unused;
    Rig r = rig_parse("bodies: {ground: {points: {G: [0, 0]}}, block: {points: {P: [0, 0], Q: [0.2, 0.5]}}}\n"
                      "joints: {S: {slide: [ground, block], along: 30 deg, distance: d}}\n"
                      "start: {d: 2}\n");
    YkVec u = yk_unit(YK_PI / 6), at = yk_add(yk_scale(2, u), yk_vec(0.2, 0.5)), force = yk_vec(3, -8);
    load_force(&r, 1, at, force);
    assert_int_equal(rig_inverse(&r), YK_OK);
    CHECK_NEAR(yk_free_bodies_effort(r.bodies, 0), -yk_dot(force, u), 1e-14);
    CHECK_NEAR(yk_dot(reaction(&r, "S").force, u), 0, 1e-14);
    CHECK_NEAR(yk_dot(reaction(&r, "S").force, yk_quarter(u)), -yk_dot(force, yk_quarter(u)), 1e-14);
    CHECK_NEAR(reaction(&r, "S").moment, -yk_cross(yk_vec(0.2, 0.5), force), 1e-14);
    rig_free(&r);
}

// The moment of a slide on its first body includes the arm of where the contact is.
static void test_the_far_end_of_a_slide_presses_where_the_second_body_is(void **unused)
{
    (void)unused;
    Rig r =
        rig_parse("bodies: {ground: {points: {O: [0, 0]}}, arm: {points: {O: [0, 0]}}, block: {points: {P: [0, 0]}}}\n"
                  "joints: {O: {pin: [ground, arm], angle: q}, S: {slide: [arm, block], along: x, distance: d}}\n"
                  "start: {q: 0, d: 4}\n");
    load_force(&r, 2, yk_vec(4, 0), yk_vec(0, -10));
    assert_int_equal(rig_inverse(&r), YK_OK);
    CHECK_VEC(reaction(&r, "S").force, 0, 10, 1e-14);
    CHECK_VEC(reaction(&r, "O").force, 0, 10, 1e-14);
    CHECK_NEAR(yk_free_bodies_effort(r.bodies, 0), 40, 1e-13);
    CHECK_NEAR(reaction(&r, "S").moment, 0, 1e-14);
    rig_free(&r);
}

// Massless, pushed at the crosshead: the rod is a two-force member, torque = F dx/dtheta.
static void test_a_slider_crank_at_rest_balances_a_push(void **unused)
{
    (void)unused;
    Rig r = rig_of(machine_load("slider-crank"));
    YkMotion q = yk_state_input(r.m.state, 0);
    double F = 1000;
    for (int k = 0; k < 12; k++) {
        rig_move(&r, 0, q.position + 0.5 * k + 0.1, 1, 0);
        size_t ram = r.m.model->body_count - 1;
        YkBodyMotion motion = yk_body_motion(r.m.mech, &r.m.state->space, ram);
        load_clear(&r);
        load_force(&r, ram, motion.at, yk_vec(-F, 0));
        assert_int_equal(rig_inverse(&r), YK_OK);
        CHECK_NEAR(yk_free_bodies_effort(r.bodies, 0), F * motion.velocity.x, 1e-11 * F);
        assert_true(imbalance_of(r.bodies) < 1e-14);
    }
    rig_free(&r);
}

// --- motion ---------------------------------------------------------------------------------------------------------

static void test_the_pin_of_a_pendulum_carries_weight_and_centripetal_force(void **unused)
{
    (void)unused;
    Rig r =
        rig_parse("bodies: {ground: {points: {O: [0, 0]}}, bob: {points: {O: [0, 0]}, mass: 2, center: [0, -0.5]}}\n"
                  "joints: {O: {pin: [ground, bob], angle: q}}\n"
                  "start: {q: 0}\n");
    double m = 2, l = 0.5, g = 9.81, q0 = 1.2;
    for (double q = -1.2; q <= 1.2; q += 0.3) {
        rig_move(&r, 0, q, sqrt(2 * g / l * fmax(0, cos(q) - cos(q0))), 0); // released at q0
        load_clear(&r);
        load_gravity(&r, down);
        assert_int_equal(rig_forward(&r, NULL), YK_OK);
        CHECK_NEAR(r.accelerations[0], -g / l * sin(q), 1e-13);
        double along = m * g * (3 * cos(q) - 2 * cos(q0));
        CHECK_VEC(reaction(&r, "O").force, -along * sin(q), along * cos(q), 1e-12);
        CHECK_NEAR(yk_free_bodies_effort(r.bodies, 0), 0, 0);
        CHECK_NEAR(reaction(&r, "O").moment, 0, 0);
    }
    rig_free(&r);
}

// The double pendulum's equations as every textbook has them, in absolute angles.
static void double_pendulum(const double q[2], const double v[2], double a[2])
{
    const double l1 = 0.5, c1 = 0.35, c2 = 0.3, m1 = 0.5, m2 = 0.4, I1 = 0.025, I2 = 0.02, g = 9.81, T1 = 0.5,
                 T2 = -0.2;
    double p1 = q[0], p2 = q[0] + q[1], w1 = v[0], w2 = v[0] + v[1], s = sin(p1 - p2), c = cos(p1 - p2);
    double M11 = I1 + m1 * c1 * c1 + m2 * l1 * l1, M22 = I2 + m2 * c2 * c2, M12 = m2 * l1 * c2 * c;
    double Q1 = T1 - T2 - m2 * l1 * c2 * s * w2 * w2 - g * (m1 * c1 + m2 * l1) * sin(p1);
    double Q2 = T2 + m2 * l1 * c2 * s * w1 * w1 - g * m2 * c2 * sin(p2);
    double det = M11 * M22 - M12 * M12;
    a[0] = (M22 * Q1 - M12 * Q2) / det;
    a[1] = (M11 * Q2 - M12 * Q1) / det - a[0];
}

static void load_double_pendulum(Rig *r)
{
    load_clear(r);
    load_gravity(r, down);
    load_input(r, 0, 0.5);
    load_input(r, 1, -0.2);
}

static void test_the_double_pendulum_accelerates_as_its_closed_form(void **unused)
{
    (void)unused;
    Rig r = rig_of(machine_load("double-pendulum"));
    load_double_pendulum(&r);
    assert_int_equal(rig_forward(&r, NULL), YK_OK);
    CHECK_NEAR(r.accelerations[0], -9.55276, 5e-6);
    CHECK_NEAR(r.accelerations[1], -7.09408, 5e-6);
    uint64_t seed = 1;
    for (int k = 0; k < 200; k++) {
        double q[2], v[2], a[2];
        for (int i = 0; i < 2; i++) {
            q[i] = check_uniform(&seed, -3, 3);
            v[i] = check_uniform(&seed, -5, 5);
            yk_state_set_input(r.m.state, (size_t)i, (YkMotion){q[i], v[i], 0});
        }
        assert_int_equal(yk_state_solve(r.m.state), YK_OK);
        load_double_pendulum(&r);
        assert_int_equal(rig_forward(&r, NULL), YK_OK);
        double_pendulum(q, v, a);
        double most = fabs(a[0]) + fabs(a[1]) + 10;
        for (int i = 0; i < 2; i++) CHECK_NEAR(r.accelerations[i], a[i], 1e-13 * most);
    }
    rig_free(&r);
}

// On a massless arm that is turned at a given rate and acceleration: r'' = r w^2, and the slide pushes with m (2 r' w +
// r a).
static void test_a_bead_in_a_turning_slot_feels_coriolis(void **unused)
{
    (void)unused;
    Rig r =
        rig_parse("bodies: {ground: {points: {O: [0, 0]}}, rod: {points: {O: [0, 0]}}, bead: {points: {P: [0, 0]}, "
                  "mass: 3, inertia: 1}}\n"
                  "joints: {O: {pin: [ground, rod], angle: q}, S: {pin-slot: [rod, bead], at: P, along: x, distance: "
                  "d, angle: s}}\n"
                  "start: {q: 0.4, d: 2, s: 0}\n");
    double w = 1.5, a = 0.7, d = 2, v = -0.8, m = 3;
    rig_move(&r, 0, 0.4, w, a);
    rig_move(&r, 1, d, v, 0);
    r.is_prescribed[0] = true;
    r.accelerations[0] = a;
    assert_int_equal(rig_forward(&r, NULL), YK_OK);
    CHECK_NEAR(r.accelerations[1], d * w * w, 1e-13);
    CHECK_NEAR(r.accelerations[2], -a, 1e-13); // the bead does not turn with the rod
    YkVec force = yk_scale(m * (2 * v * w + d * a), yk_quarter(yk_unit(0.4)));
    CHECK_VEC(reaction(&r, "S").force, force.x, force.y, 1e-13);
    CHECK_NEAR(yk_free_bodies_effort(r.bodies, 0), d * m * (2 * v * w + d * a), 1e-12);
    rig_free(&r);
}

static void test_a_block_on_a_turning_rod_feels_coriolis(void **unused)
{
    (void)unused;
    Rig r = rig_parse("bodies: {ground: {points: {O: [0, 0]}}, rod: {points: {O: [0, 0]}}, block: {points: {P: [0, "
                      "0]}, mass: 3, inertia: 0.5}}\n"
                      "joints: {O: {pin: [ground, rod], angle: q}, S: {slide: [rod, block], along: x, distance: d}}\n"
                      "start: {q: 0.4, d: 2}\n");
    double w = 1.5, a = 0.7, d = 2, v = -0.8, m = 3;
    rig_move(&r, 0, 0.4, w, a);
    rig_move(&r, 1, d, v, 0);
    r.is_prescribed[0] = true;
    r.accelerations[0] = a;
    assert_int_equal(rig_forward(&r, NULL), YK_OK);
    YkVec u = yk_unit(0.4), n = yk_quarter(u);
    double push = m * (2 * v * w + d * a);
    CHECK_NEAR(r.accelerations[1], d * w * w, 1e-13);
    CHECK_NEAR(r.accelerations[0], a, 0);
    CHECK_NEAR(yk_dot(reaction(&r, "S").force, n), push, 1e-13);
    CHECK_NEAR(yk_dot(reaction(&r, "S").force, u), 0, 1e-13);
    CHECK_NEAR(reaction(&r, "S").moment, 0.5 * a, 1e-13);
    CHECK_NEAR(yk_free_bodies_effort(r.bodies, 0), push * d + 0.5 * a, 1e-12);
    rig_free(&r);
}

// One freedom: virtual power gives the acceleration of the toggle linkage from its kinematics alone.
static void test_the_toggle_linkage_accelerates_as_virtual_power_says(void **unused)
{
    (void)unused;
    Rig r = rig_of(machine_load("toggle"));
    YkMotion start = yk_state_input(r.m.state, 0);
    for (int k = 0; k < 10; k++) {
        rig_move(&r, 0, start.position + 0.1 * (k - 5), 3, 0);
        load_clear(&r);
        load_gravity(&r, down);
        load_input(&r, 0, 2);
        assert_int_equal(rig_forward(&r, NULL), YK_OK);
        double power = 2 * 3.0, mass = 0; // kinetic energy = mass w^2 / 2
        for (size_t b = 1; b < r.m.model->body_count; b++) {
            const YkBody *body = &r.m.model->bodies[b];
            YkBodyMotion p = yk_body_motion(r.m.mech, &r.m.state->space, b);
            mass += (body->mass * yk_dot(p.velocity, p.velocity) + body->inertia * p.w * p.w) / 9;
            power += body->mass * yk_dot(p.velocity, yk_sub(down, p.acceleration)) - body->inertia * p.w * p.a;
        }
        CHECK_NEAR(r.accelerations[0], power / 3 / mass, 1e-11 * (1 + fabs(r.accelerations[0])));
        assert_true(imbalance_of(r.bodies) < 1e-13);
    }
    rig_free(&r);
}

// Andrews' squeezer at its start, with its spring between C and D of K3. Source: Mazzia & Magherini 2008, Test Set for
// IVP Solvers, problem "andrews": accelerations of beta and Theta, the others 0, and the force in the loop's joint E.
static void test_the_squeezer_starts_as_published(void **unused)
{
    (void)unused;
    Rig r = rig_of(machine_load("andrews"));
    size_t K3 = body_named(&r, "K3");
    YkVec C = yk_vec(0.014, 0.072), D = place_of(&r, K3, yk_vec(0.02, -0.018)), CD = yk_sub(D, C);
    double length = yk_norm(CD);
    load_force(&r, K3, D, yk_scale(-4530 * (length - 0.07785) / length, CD));
    load_input(&r, 0, 0.033);
    assert_int_equal(rig_forward(&r, NULL), YK_OK);
    CHECK_NEAR(r.accelerations[0], 14222.4439199541138705911625887, 1e-6);
    rig_accelerate(&r);
    CHECK_NEAR(machine_ask(&r.m, "Theta.accel"), -10666.8329399655854029433719415, 1e-6);
    CHECK_NEAR(machine_ask(&r.m, "gamma.accel"), 0, 1e-5);
    YkVec force = reaction(&r, "E2").force;
    CHECK_NEAR(fabs(force.x), 98.5668703962410896057654982170, 1e-8);
    CHECK_NEAR(fabs(force.y), 6.12268834425566265503114393122, 1e-8);
    rig_free(&r);
}

// --- redundant machines ---------------------------------------------------------------------------------------------

static void test_doubled_guides_carry_half_each_and_say_that_nobody_knows(void **unused)
{
    (void)unused;
    Rig r = rig_of(machine_load("doubled-guide"));
    size_t crosshead = body_named(&r, "crosshead");
    YkBodyMotion at = yk_body_motion(r.m.mech, &r.m.state->space, crosshead);
    load_force(&r, crosshead, at.at, yk_vec(-100, -40));
    assert_int_equal(rig_inverse(&r), YK_REDUNDANT);
    YkJointForce upper = reaction(&r, "upper"), lower = reaction(&r, "lower"), pin = reaction(&r, "B");
    assert_false(upper.is_determinate);
    assert_false(lower.is_determinate);
    assert_true(reaction(&r, "O").is_determinate && reaction(&r, "A").is_determinate && pin.is_determinate);
    CHECK_NEAR(pin.force.x, 100, 1e-12);
    CHECK_NEAR(upper.force.y, lower.force.y, 1e-12);
    CHECK_NEAR(upper.force.y + lower.force.y, 40 - pin.force.y, 1e-12);
    CHECK_NEAR(upper.moment, lower.moment, 1e-12);
    assert_true(imbalance_of(r.bodies) < 1e-14);
    // the crank's torque is that of the single guide
    double torque = yk_free_bodies_effort(r.bodies, 0);
    rig_move(&r, 0, yk_state_input(r.m.state, 0).position, 1, 0);
    at = yk_body_motion(r.m.mech, &r.m.state->space, crosshead);
    CHECK_NEAR(torque, 100 * at.velocity.x, 1e-11);
    rig_free(&r);
}

static void test_a_redundant_machine_falls_as_the_machine_without_what_is_redundant(void **unused)
{
    (void)unused;
    static const char bodies[] =
        "bodies:\n  ground: {points: {O: [0, 0]}}\n  crank: {points: {O: [0, 0], A: [0.1, 0]}, mass: 1, rod: [O, A]}\n"
        "  rod: {points: {A: [0, 0], B: [0.4, 0]}, mass: 2, rod: [A, B]}\n"
        "  ram: {points: {B: [0, 0], C: [0.1, 0]}, mass: 3, center: [0.05, 0.02], inertia: 0.1}\n"
        "joints:\n  O: {pin: [ground, crank], angle: q}\n  A: {pin: [crank, rod], angle: p}\n"
        "  B: {pin: [rod, ram]}\n  R: {slide: [ground, ram], along: x, distance: x}\n";
    char text[2][1200];
    snprintf(text[0], sizeof text[0], "%sstart: {q: 50 deg, q.rate: 3 rad/s, p: -70 deg, x: 0.4}\n", bodies);
    snprintf(text[1], sizeof text[1],
             "%s  S: {slide: [ground, ram], along: x, to: C}\n  T: {slide: [ground, ram], along: x}\n"
             "start: {q: 50 deg, q.rate: 3 rad/s, p: -70 deg, x: 0.4}\n",
             bodies);
    Rig plain = rig_parse(text[0]), doubled = rig_parse(text[1]);
    load_gravity(&plain, down);
    load_gravity(&doubled, down);
    assert_int_equal(rig_forward(&plain, NULL), YK_OK);
    assert_int_equal(rig_forward(&doubled, NULL), YK_REDUNDANT);
    CHECK_NEAR(doubled.accelerations[0], plain.accelerations[0], 1e-12 * fabs(plain.accelerations[0]));
    for (int k = 0; k < 3; k++) {
        const char *name = (const char *[]){"O", "A", "B"}[k];
        YkVec force = reaction(&plain, name).force;
        CHECK_VEC(reaction(&doubled, name).force, force.x, force.y, 1e-11 * yk_norm(force));
        assert_true(reaction(&doubled, name).is_determinate);
    }
    assert_false(reaction(&doubled, "R").is_determinate);
    assert_true(imbalance_of(doubled.bodies) < 1e-12);
    rig_accelerate(&doubled);
    YkJointForce before = reaction(&doubled, "R");
    assert_int_equal(rig_inverse(&doubled), YK_REDUNDANT);
    CHECK_NEAR(reaction(&doubled, "R").force.y, before.force.y, 1e-11 * fabs(before.force.y));
    CHECK_NEAR(reaction(&doubled, "R").moment, before.moment, 1e-11 * (1 + fabs(before.moment)));
    CHECK_NEAR(yk_free_bodies_effort(doubled.bodies, 0), 0, 1e-11);
    rig_free(&plain);
    rig_free(&doubled);
}

// Apart from each other in one file: only the joints of the redundant part are undetermined.
static void test_a_redundant_part_leaves_other_parts_determinate(void **unused)
{
    (void)unused;
    Rig r = rig_parse("bodies:\n  ground: {points: {P: [5, 0], U: [0, 1], L: [0, -1]}}\n"
                      "  block: {points: {U: [0, 1], L: [0, -1]}, mass: 1}\n"
                      "  bob: {points: {P: [0, 0]}, mass: 1, center: [1, 0], inertia: 1}\n"
                      "joints:\n  U: {slide: [ground, block], along: x, from: U, to: U, distance: d}\n"
                      "  L: {slide: [ground, block], along: x, from: L, to: L}\n  P: {pin: [ground, bob], angle: q}\n");
    load_gravity(&r, down);
    assert_int_equal(rig_inverse(&r), YK_REDUNDANT);
    assert_true(reaction(&r, "P").is_determinate);
    assert_false(reaction(&r, "U").is_determinate);
    CHECK_VEC(reaction(&r, "P").force, 0, 9.81, 1e-14);
    CHECK_VEC(reaction(&r, "U").force, 0, 9.81 / 2, 1e-14);
    CHECK_NEAR(yk_free_bodies_effort(r.bodies, 1), 9.81, 1e-14);
    rig_free(&r);
}

// --- where there is no answer ---------------------------------------------------------------------------------------

static void test_a_freedom_without_inertia_is_named(void **unused)
{
    (void)unused;
    Rig r =
        rig_parse("bodies: {ground: {points: {O: [0, 0]}}, a: {points: {O: [0, 0], P: [1, 0]}, mass: 1, center: [1, "
                  "0], inertia: 0}, b: {points: {P: "
                  "[0, 0]}, mass: 1}, c: {points: {O: [0, 0]}, mass: 1, center: [1, 0]}}\n"
                  "joints: {O: {pin: [ground, a], angle: p}, P: {pin: [a, b], angle: q}, Q: {pin: [ground, c], at: O, "
                  "angle: s}}\n"
                  "start: {p: 0.3, q: 0.1, s: 0}\n");
    load_gravity(&r, down);
    int culprit = 7;
    assert_int_equal(rig_forward(&r, &culprit), YK_SINGULAR); // a point mass turns for nothing about itself
    assert_int_equal(culprit, 1);
    CHECK_NEAR(r.accelerations[0], 0, 0);
    CHECK_NEAR(r.accelerations[2], -9.81, 1e-12); // the other part falls as it should
    assert_false(reaction(&r, "P").is_determinate);
    r.is_prescribed[1] = true;
    r.accelerations[1] = 0;
    assert_int_equal(rig_forward(&r, &culprit), YK_OK);
    assert_int_equal(culprit, -1);
    CHECK_NEAR(r.accelerations[0], -9.81 * cos(0.3), 1e-12);
    rig_free(&r);
}

// A flat parallelogram may go either way: its constraints do not determine the accelerations.
static void test_a_change_point_is_singular_and_no_input_is_guilty(void **unused)
{
    (void)unused;
    Rig r =
        rig_parse("bodies:\n  ground: {points: {O: [0, 0], Q: [2, 0]}}\n  a: {points: {O: [0, 0], A: [1, 0]}, mass: 1, "
                  "rod: [O, A]}\n  b: {points: {A: [0, 0], B: [2, 0]}, mass: 1, rod: [A, B]}\n  c: {points: {Q: [0, "
                  "0], B: [1, 0]}, mass: 1, rod: [Q, B]}\n"
                  "joints:\n  O: {pin: [ground, a], angle: p}\n  A: {pin: [a, b], angle: q}\n  Q: {pin: [ground, c], "
                  "angle: s}\n  B: {pin: [b, c]}\n"
                  "start: {p: 0, q: 0, s: 0}\n");
    load_gravity(&r, down);
    int culprit = 7;
    assert_int_equal(rig_forward(&r, &culprit), YK_SINGULAR);
    assert_int_equal(culprit, -1);
    assert_int_equal(rig_inverse(&r), YK_SINGULAR);
    CHECK_VEC(reaction(&r, "A").force, 0, 0, 0);
    rig_free(&r);
}

static void test_a_crank_passes_its_dead_point_forwards_but_its_slide_cannot_drive_it_there(void **unused)
{
    (void)unused;
    static const char text[] =
        "bodies:\n  ground: {points: {O: [0, 0]}}\n  crank: {points: {O: [0, 0], A: [1, 0]}, mass: 1, rod: [O, A]}\n"
        "  rod: {points: {A: [0, 0], B: [3, 0]}, mass: 2, rod: [A, B]}\n  ram: {points: {B: [0, 0]}, "
        "mass: 3}\njoints:\n  O: {pin: [ground, crank], angle: q}\n  A: {pin: [crank, rod], angle: "
        "p}\n  B: {pin: [rod, ram]}\n  R: {slide: [ground, ram], along: x, distance: x}\n";
    char whole[3][900];
    snprintf(whole[0], sizeof whole[0], "%sstart: {q: 0, q.rate: 2, p: 0, x: 4}\n", text);
    snprintf(whole[1], sizeof whole[1], "%sstart: {x: 4, q: 0.1, p: 0}\n", text);
    snprintf(whole[2], sizeof whole[2], "%sstart: {x: 3.9999999999999996, q: 0.1, p: 0}\n", text); // nearly there
    Rig turned = rig_parse(whole[0]), pushed = rig_parse(whole[1]), nearly = rig_parse(whole[2]);
    load_gravity(&turned, down);
    load_gravity(&pushed, down);
    load_gravity(&nearly, down);
    assert_int_equal(rig_forward(&turned, NULL), YK_OK);
    // the crank's inertia about O and the rod's share at A, which turns about B's line: m/3 of each end
    CHECK_NEAR(turned.accelerations[0], -9.81 * (1 * 0.5 + 2 * 0.5) / (1.0 / 3 + 2.0 / 3), 1e-12);
    assert_int_equal(rig_inverse(&pushed), YK_SINGULAR);
    CHECK_NEAR(yk_free_bodies_effort(pushed.bodies, 0), 0, 0);
    assert_int_equal(rig_inverse(&nearly), YK_SINGULAR);
    rig_free(&turned);
    rig_free(&pushed);
    rig_free(&nearly);
}

static void test_without_mass_and_load_nothing_acts(void **unused)
{
    (void)unused;
    Rig r = rig_of(machine_load("jansen"));
    assert_int_equal(rig_inverse(&r), YK_OK);
    for (size_t j = 0; j < r.m.model->joint_count; j++) CHECK_VEC(yk_free_bodies_joint(r.bodies, j).force, 0, 0, 0);
    CHECK_NEAR(yk_free_bodies_effort(r.bodies, 0), 0, 0);
    CHECK_NEAR(imbalance_of(r.bodies), 0, 0);
    rig_free(&r);
    yk_free_bodies_free(NULL);
}

static void test_a_load_that_is_no_number_has_no_answer(void **unused)
{
    (void)unused;
    Rig r = rig_of(machine_load("double-pendulum"));
    load_gravity(&r, yk_vec(NAN, 0));
    assert_int_equal(rig_forward(&r, NULL), YK_SINGULAR);
    assert_int_equal(rig_inverse(&r), YK_SINGULAR);
    for (int i = 0; i < 2; i++) {
        CHECK_NEAR(r.accelerations[i], 0, 0);
        CHECK_NEAR(yk_free_bodies_effort(r.bodies, (size_t)i), 0, 0);
    }
    load_clear(&r);
    load_gravity(&r, down);
    assert_int_equal(rig_forward(&r, NULL), YK_OK);
    rig_free(&r);
}

// A plate that floats: no joint transmits anything, so only its own acceleration tells that a load is no number.
static void test_a_floating_body_under_a_load_that_is_no_number_has_no_answer(void **unused)
{
    (void)unused;
    Rig r = rig_parse("bodies: {ground: {points: {O: [0, 0]}}, plate: {points: {O: [0, 0]}, mass: 2, inertia: 3}}\n"
                      "joints: {F: {free: [ground, plate], at: [x, y, phi]}}\nstart: {x: 0, y: 0, phi: 0}\n");
    load_gravity(&r, yk_vec(NAN, 0));
    assert_int_equal(rig_forward(&r, NULL), YK_SINGULAR);
    for (int i = 0; i < 3; i++) CHECK_NEAR(r.accelerations[i], 0, 0);
    load_clear(&r);
    load_gravity(&r, down);
    assert_int_equal(rig_forward(&r, NULL), YK_OK);
    CHECK_NEAR(r.accelerations[1], -9.81, 1e-14);
    rig_free(&r);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_a_beam_rests_on_two_supports_by_the_law_of_levers),
        cmocka_unit_test(test_a_weld_carries_force_and_moment),
        cmocka_unit_test(test_a_slide_carries_a_normal_force_a_moment_and_the_effort_along_it),
        cmocka_unit_test(test_the_far_end_of_a_slide_presses_where_the_second_body_is),
        cmocka_unit_test(test_a_slider_crank_at_rest_balances_a_push),
        cmocka_unit_test(test_the_pin_of_a_pendulum_carries_weight_and_centripetal_force),
        cmocka_unit_test(test_the_double_pendulum_accelerates_as_its_closed_form),
        cmocka_unit_test(test_a_bead_in_a_turning_slot_feels_coriolis),
        cmocka_unit_test(test_a_block_on_a_turning_rod_feels_coriolis),
        cmocka_unit_test(test_the_toggle_linkage_accelerates_as_virtual_power_says),
        cmocka_unit_test(test_the_squeezer_starts_as_published),
        cmocka_unit_test(test_doubled_guides_carry_half_each_and_say_that_nobody_knows),
        cmocka_unit_test(test_a_redundant_machine_falls_as_the_machine_without_what_is_redundant),
        cmocka_unit_test(test_a_redundant_part_leaves_other_parts_determinate),
        cmocka_unit_test(test_a_freedom_without_inertia_is_named),
        cmocka_unit_test(test_a_change_point_is_singular_and_no_input_is_guilty),
        cmocka_unit_test(test_a_crank_passes_its_dead_point_forwards_but_its_slide_cannot_drive_it_there),
        cmocka_unit_test(test_without_mass_and_load_nothing_acts),
        cmocka_unit_test(test_a_load_that_is_no_number_has_no_answer),
        cmocka_unit_test(test_a_floating_body_under_a_load_that_is_no_number_has_no_answer),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
