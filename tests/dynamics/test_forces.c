// Reactions, efforts and sums: every body balances, power is the rate of energy, the frame bears the machine.
#include "rig.h"

static void every_body_balances(void **unused)
{
    (void)unused;
    uint64_t seed = 11;
    for (size_t k = 0; k < RIG_EXAMPLES; k++) {
        Rig rig = rig_of_example(rig_examples[k]);
        for (int way = 0; way < 2; way++) {
            if (!rig_shake(&rig, &seed)) continue;
            assert_true(yk_dynamics_solve(rig.dynamics, rig.state, (YkMethod)way) >= 0);
            for (size_t b = 1; b < rig.model->body_count; b++)
                assert_true(yk_dynamics_balance(rig.dynamics, b).residual <= 1e-11);
        }
        rig_free(&rig);
    }
}

// What the machine exerts on its frame is the weight less the momentum's rate, external forces aside.
static void the_frame_carries_weight_less_inertia(void **unused)
{
    (void)unused;
    uint64_t seed = 12;
    Rig rig = rig_of_example("toggle");
    assert_true(rig_shake(&rig, &seed));
    assert_true(yk_dynamics_solve(rig.dynamics, rig.state, YK_METHOD_REDUCED) >= 0);
    double sum[2] = {0, 0};
    for (size_t b = 1; b < rig.model->body_count; b++) {
        const YkBody *body = &rig.model->bodies[b];
        YkBodyMotion m = yk_body_motion(rig.mech, &rig.state->space, b);
        sum[0] += body->mass * (rig.model->gravity.x - m.acceleration.x);
        sum[1] += body->mass * (rig.model->gravity.y - m.acceleration.y);
    }
    YkWrench shaking = yk_dynamics_shaking(rig.dynamics);
    for (int axis = 0; axis < 2; axis++)
        CHECK_NEAR(shaking.force[axis], sum[axis], 1e-11 * rig.dynamics->largest_force);
    rig_free(&rig);
}

static double energy_after(Rig *rig, double dt)
{
    YkMotion kept[16];
    for (size_t i = 0; i < rig->mech->input_count; i++) {
        YkMotion m = kept[i] = yk_state_input(rig->state, i);
        m.position += dt * (m.velocity + 0.5 * dt * m.acceleration);
        m.velocity += dt * m.acceleration;
        yk_state_set_input(rig->state, i, m);
    }
    assert_true(yk_state_solve(rig->state) >= 0);
    YkEnergy e = yk_dynamics_energy_at(rig->dynamics, rig->state);
    for (size_t i = 0; i < rig->mech->input_count; i++) yk_state_set_input(rig->state, i, kept[i]);
    return e.kinetic + e.potential;
}

// dE/dt along the motion that the inputs' rates and accelerations begin: central differences of eighth order.
static double energy_slope(Rig *rig)
{
    static const double weight[] = {4.0 / 5, -1.0 / 5, 4.0 / 105, -1.0 / 280};
    double fastest = 1, slope = 0;
    for (size_t b = 1; b < rig->model->body_count; b++)
        fastest = fmax(fastest, fabs(yk_body_motion(rig->mech, &rig->state->space, b).w));
    double h = 2e-3 / fastest;
    for (int p = 1; p <= 4; p++) slope += weight[p - 1] / h * (energy_after(rig, p * h) - energy_after(rig, -p * h));
    return slope;
}

// Inverse dynamics by the power balance: sum of effort times rate is the rate of kinetic and potential energy, less
// what the other loads deliver.
static void efforts_balance_power(void **unused)
{
    (void)unused;
    uint64_t seed = 13;
    for (size_t k = 0; k < RIG_EXAMPLES; k++) {
        Rig rig = rig_of_example(rig_examples[k]);
        for (size_t i = 0; i < rig.mech->input_count; i++) yk_dynamics_prescribe(rig.dynamics, i, true);
        if (rig.mech->input_count <= 16 && rig_shake(&rig, &seed)) {
            double slope = energy_slope(&rig);
            assert_true(yk_dynamics_solve(rig.dynamics, rig.state, YK_METHOD_REDUCED) >= 0);
            double power = 0, size = fabs(slope);
            for (size_t i = 0; i < rig.mech->input_count; i++) {
                power += rig.dynamics->drive[i] * yk_state_input(rig.state, i).velocity;
                size += fabs(rig.dynamics->drive[i] * yk_state_input(rig.state, i).velocity);
            }
            for (size_t n = 0; n < rig.dynamics->loads->item_count; n++) power += rig.dynamics->power[n];
            CHECK_NEAR(power, slope, 1e-10 * size);
        }
        rig_free(&rig);
    }
}

// Forward dynamics, then the accelerations found prescribed: no drive has anything to do.
static void inverse_undoes_forward(void **unused)
{
    (void)unused;
    uint64_t seed = 14;
    for (size_t k = 0; k < RIG_EXAMPLES; k++) {
        Rig rig = rig_of_example(rig_examples[k]);
        if (rig_shake(&rig, &seed)) {
            assert_true(yk_dynamics_solve(rig.dynamics, rig.state, YK_METHOD_REDUCED) >= 0);
            bool was_free[64];
            for (size_t i = 0; i < rig.mech->input_count; i++) {
                was_free[i] = !yk_dynamics_is_prescribed(rig.dynamics, i);
                yk_dynamics_prescribe(rig.dynamics, i, true);
            }
            assert_true(yk_dynamics_solve(rig.dynamics, rig.state, YK_METHOD_REDUCED) >= 0);
            for (size_t i = 0; i < rig.mech->input_count; i++)
                if (was_free[i]) CHECK_NEAR(rig.dynamics->drive[i], 0, 1e-10 * fmax(1, rig.dynamics->largest_force));
        }
        rig_free(&rig);
    }
}

static void a_hanging_weight_pulls_its_pin(void **unused)
{
    (void)unused;
    Rig rig = rig_of_text("gravity: [0, -10]\nbodies:\n  ground: {points: {O: [0, 0]}}\n  bob: {points: {O: [0, 0]}, "
                          "mass: 2, center: [0, -1]}\n"
                          "joints:\n  O: {pin: [ground, bob], angle: x}\n");
    assert_true(yk_dynamics_solve(rig.dynamics, rig.state, YK_METHOD_REDUCED) >= 0);
    YkReaction r = yk_dynamics_reaction(rig.dynamics, 0);
    CHECK_NEAR(r.force[0], 0, 1e-13);
    CHECK_NEAR(r.force[1], 20, 1e-12);
    YkWrench frame = yk_dynamics_shaking(rig.dynamics);
    CHECK_NEAR(frame.force[1], -20, 1e-12);
    CHECK_NEAR(yk_dynamics_energy(rig.dynamics).potential, -20, 1e-12);
    CHECK_NEAR(yk_dynamics_channel(rig.dynamics, rig.state, rig_channel(rig.mech, "O.force")), 20, 1e-12);
    rig_free(&rig);
}

static void the_toggle_has_twenty_equations(void **unused)
{
    (void)unused;
    Rig rig = rig_of_example("toggle");
    YkEquationCount c = yk_dynamics_count(rig.dynamics);
    assert_int_equal(c.force, 12);
    assert_int_equal(c.moment, 4);
    assert_int_equal(c.acceleration, 4);
    assert_int_equal(c.unknown_reactions, 15);
    assert_int_equal(c.unknown_accelerations, 5);
    assert_int_equal(c.unknown_efforts, 0);
    rig_free(&rig);
}

// A slot closes its loop by one equation, a mesh brings a force and an equation: as many equations as unknowns
// everywhere.
static void every_count_balances(void **unused)
{
    (void)unused;
    static const char *const names[] = {"scotch-yoke",     "crank-slotted-lever", "toggle",
                                        "epicyclic-drive", "swing-cam",           "watt-with-masses"};
    for (size_t k = 0; k < sizeof names / sizeof *names; k++) {
        Rig rig = rig_of_example(names[k]);
        YkEquationCount c = yk_dynamics_count(rig.dynamics);
        assert_true(c.acceleration > 0);
        assert_int_equal(c.force + c.moment + c.acceleration,
                         c.unknown_reactions + c.unknown_accelerations + c.unknown_efforts);
        rig_free(&rig);
    }
}

// The follower's law is s = 5 mm (1 - cos x): without weight and spring the cam would have to pull it where its
// acceleration along its line is negative, whichever way the line points.
static void a_contact_pulls_where_the_follower_is_slowed(void **unused)
{
    (void)unused;
    static const char *const faces[] = {"face: flat", "roller: 6 mm", "roller: 6 mm, groove: true"};
    for (int k = 0; k < 24; k++) {
        char text[1000];
        double line = 0.26 + 0.7853981633974483 * (k / 3);
        snprintf(text, sizeof text,
                 "laws:\n  lift: {period: 2*pi, segments: [{formula: {to: 2*pi, s: 5 mm*(1 - cos(x))}}]}\n"
                 "cams:\n  c: {cam: shaft, follower: tappet, law: lift, base: 40 mm, %s}\n"
                 "bodies: {shaft: {}, tappet: {mass: 3}}\njoints:\n  K: {pin: [ground, shaft], angle: q}\n"
                 "  T: {slide: [ground, tappet], along: %.17g rad, distance: s}\ndrives: {q: 10 rad/s * t}\n",
                 faces[k % 3], line);
        Rig rig = rig_of_text(text);
        for (int turn = 0; turn < 16; turn++) {
            double x = 0.3 + 0.39269908169872414 * turn, accel = 100 * 0.005 * cos(x);
            yk_state_set_input(rig.state, 0, (YkMotion){x, 10, 0});
            assert_int_equal(yk_dynamics_solve(rig.dynamics, rig.state, (YkMethod)(turn & 1)), YK_OK);
            YkReaction r = yk_dynamics_contact(rig.dynamics, 0);
            CHECK_NEAR(fabs(r.force[0] * cos(line) + r.force[1] * sin(line)), 3 * fabs(accel), 1e-12);
            assert_int_equal(yk_dynamics_contact_pulls(rig.dynamics, 0), accel < 0 && k % 3 != 2);
        }
        rig_free(&rig);
    }
}

// Only a coordinate that is driven, or along which an effort acts, has an effort.
static void only_drives_and_efforts_have_efforts(void **unused)
{
    (void)unused;
    Rig rig = rig_of_text("bodies: {a: {mass: 1}, b: {mass: 2}, c: {mass: 3}}\njoints:\n"
                          "  A: {slide: [ground, a], along: x, distance: x, friction: {viscous: 2}}\n"
                          "  B: {slide: [ground, b], along: x, distance: y}\n"
                          "  C: {slide: [ground, c], along: x, distance: z}\n"
                          "drives: {z: 2 m/s * t}\nefforts: {y: 4 N}\n");
    size_t x = yk_coordinate_find(rig.mech, "x"), y = yk_coordinate_find(rig.mech, "y"),
           z = yk_coordinate_find(rig.mech, "z");
    assert_true(yk_dynamics_solve(rig.dynamics, rig.state, YK_METHOD_REDUCED) >= 0);
    assert_false(yk_dynamics_has_effort(rig.dynamics, x)); // friction is none
    assert_true(yk_dynamics_has_effort(rig.dynamics, y));
    assert_true(yk_dynamics_has_effort(rig.dynamics, z));
    CHECK_NEAR(yk_dynamics_effort(rig.dynamics, x), 0, 0);
    CHECK_NEAR(yk_dynamics_effort(rig.dynamics, y), 4, 0);
    rig_free(&rig);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_count_balances),
        cmocka_unit_test(every_body_balances),
        cmocka_unit_test(the_frame_carries_weight_less_inertia),
        cmocka_unit_test(efforts_balance_power),
        cmocka_unit_test(inverse_undoes_forward),
        cmocka_unit_test(a_hanging_weight_pulls_its_pin),
        cmocka_unit_test(the_toggle_has_twenty_equations),
        cmocka_unit_test(a_contact_pulls_where_the_follower_is_slowed),
        cmocka_unit_test(only_drives_and_efforts_have_efforts),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
