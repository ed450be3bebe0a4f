// Gears, racks, belts and cams as constraints: motion by their ratios and laws, forces by two formulations and by
// power.
#include "rig.h"
#include "meshes.h"
#include "simulate/run.h"

static const char *const machines[] = {GEARED_FIVE_BAR, RACK, CAM, FOLLOW, PLANETARY_SET, PLANETARY_LINKAGE, BELT,
                                       RACK_BACKWARDS,  FLAT};
enum { MACHINES = sizeof machines / sizeof *machines };

static double rate_of(const Rig *rig, const char *name)
{
    return yk_state_channel(rig->state, rig_channel(rig->mech, name));
}

static void the_train_of_the_format(void **unused)
{
    (void)unused;
    Rig rig = rig_of_example("epicyclic");
    const double rpm = 2 * YK_PI / 60;
    assert_int_equal(yk_mechanism_freedom(rig.mech).gruebler, 2);
    CHECK_NEAR(rate_of(&rig, "theta4.rate"), 460.0 / 29 * rpm, 1e-14);
    CHECK_NEAR(rate_of(&rig, "planet.rate"), (20 - 20 * 27.0 / 36) * rpm, 1e-14);
    rig_free(&rig);
}

// After a million turns of the sun the ring is where exact arithmetic has it: 23/58 of the sun's turns beyond whole
// ones.
static void many_turns_stay_exact(void **unused)
{
    (void)unused;
    Rig rig = rig_of_example("epicyclic");
    double turns = 1e6 + 0.25;
    for (size_t i = 0; i < 2; i++) {
        bool is_sun = strcmp(rig.mech->coordinates[rig.mech->inputs[i]].name, "theta1") == 0;
        yk_state_set_input(rig.state, i, (YkMotion){is_sun ? 2 * YK_PI * turns : 0, 0, 0});
    }
    assert_true(yk_state_solve(rig.state) >= 0);
    double ring = -turns * 27 * 24 / (36 * 87); // external, then internal
    double off = rate_of(&rig, "theta4") / (2 * YK_PI) - ring;
    CHECK_NEAR(off - rint(off), 0, 1e-9);
    rig_free(&rig);
}

static void wheels_keep_their_ratio(void **unused)
{
    (void)unused;
    uint64_t seed = 2;
    Rig rig = rig_of_text(GEARED_FIVE_BAR);
    for (int k = 0; k < 20; k++) {
        if (!rig_shake(&rig, &seed)) continue;
        CHECK_NEAR(rate_of(&rig, "t2.rate"), -0.5 * rate_of(&rig, "t1.rate"), 1e-13);
        CHECK_NEAR(rate_of(&rig, "t2.accel"), -0.5 * rate_of(&rig, "t1.accel"), 1e-13);
        CHECK_NEAR(rate_of(&rig, "t1") + 2 * rate_of(&rig, "t2"), (60 + 2 * 100) * YK_PI / 180,
                   1e-12); // phase of `start:`
        assert_true(yk_state_residuals(rig.state).position < 1e-13);
    }
    rig_free(&rig);
}

static void a_pinion_moves_its_rack(void **unused)
{
    (void)unused;
    Rig rig = rig_of_text(RACK);
    assert_true(yk_state_solve(rig.state) >= 0);
    CHECK_NEAR(fabs(rate_of(&rig, "s.rate")), 0.05 * 2, 1e-15);
    // rolling: the pinion's point on the rack below it moves with the rack
    YkBodyMotion p = yk_body_motion(rig.mech, &rig.state->space, 1);
    double speed = p.w * 0.05; // of the lowest point, along x
    CHECK_NEAR(rate_of(&rig, "s.rate"), speed, 1e-14);
    rig_free(&rig);
}

// A cam inside a linkage against the same law driven directly.
static void a_cam_is_its_law(void **unused)
{
    (void)unused;
    Rig cam = rig_of_text(CAM);
    Rig driven = rig_of_text(CAM_PARTS "drives: {s: 20 mm * (1 rad/s * t / (120 deg) - sin(3 rad/s * "
                                       "t)/(2*pi))}\nstart: {th: 0, b: 60 deg, c: 170 deg}\n");
    for (int k = 1; k < 20; k++) {
        double t = 0.1 * k; // as the cam's angle, at unit speed
        yk_state_set_input(cam.state, 0, (YkMotion){t, 1, 0});
        assert_true(yk_state_solve(cam.state) >= 0);
        assert_int_equal(yk_state_set_time(driven.state, t, NULL), YK_OK);
        assert_true(yk_state_solve(driven.state) >= 0);
        static const char *const asked[] = {"s", "s.rate", "s.accel", "c", "c.rate", "c.accel"};
        for (size_t a = 0; a < 6; a++) CHECK_NEAR(rate_of(&cam, asked[a]), rate_of(&driven, asked[a]), 1e-14);
    }
    rig_free(&cam);
    rig_free(&driven);
}

static void forces_by_both_formulations(void **unused)
{
    (void)unused;
    uint64_t seed = 8;
    for (size_t k = 0; k < MACHINES; k++) {
        Rig rig = rig_of_text(machines[k]);
        for (int turn = 0; turn < 10; turn++) {
            if (!rig_shake(&rig, &seed)) continue;
            double found[2][4];
            for (int way = 0; way < 2; way++) {
                assert_true(yk_dynamics_solve(rig.dynamics, rig.state, (YkMethod)way) >= 0);
                for (size_t b = 1; b < rig.model->body_count; b++)
                    assert_true(yk_dynamics_balance(rig.dynamics, b).residual < 1e-11);
                for (size_t i = 0; i < rig.mech->input_count; i++)
                    found[way][i] = yk_state_input(rig.state, i).acceleration;
            }
            for (size_t i = 0; i < rig.mech->input_count; i++)
                CHECK_NEAR(found[0][i], found[1][i], 1e-10 * (1 + fabs(found[0][i])));
        }
        rig_free(&rig);
    }
}

static void add_wrench(YkWrench *sum, YkReaction r, double sign, YkVec about)
{
    YkVec force = {sign * r.force[0], sign * r.force[1]};
    sum->force[0] += force.x;
    sum->force[1] += force.y;
    sum->moment += sign * r.moment + yk_cross(yk_sub(yk_vec(r.at[0], r.at[1]), about), force);
}

// Joints and contacts as they are told, with the places where they act, are all that holds a body; of contacts that are
// couples the bodies that bear them besides are not
// told.
static void told_contacts_are_what_holds_a_body(void **unused)
{
    (void)unused;
    uint64_t seed = 21;
    size_t seen = 0;
    for (size_t k = 0; k < MACHINES; k++) {
        Rig rig = rig_of_text(machines[k]);
        const YkDynamics *d = rig.dynamics;
        bool has_law = rig.mech->relation_count > yk_dynamics_contact_count(d); // its push is told by no contact
        bool solved =
            !has_law && rig_shake(&rig, &seed) && yk_dynamics_solve(rig.dynamics, rig.state, YK_METHOD_REDUCED) >= 0;
        for (size_t b = 1; solved && b < rig.model->body_count; b++) {
            YkVec center = yk_body_motion(rig.mech, &rig.state->space, b).at;
            YkWrench sum = {{0, 0}, 0}, asked = yk_dynamics_balance(d, b).reactions;
            bool is_whole = true;
            for (size_t i = 0; i < rig.model->joint_count + yk_dynamics_contact_count(d); i++) {
                bool is_joint = i < rig.model->joint_count;
                YkReaction r =
                    is_joint ? yk_dynamics_reaction(d, i) : yk_dynamics_contact(d, i - rig.model->joint_count);
                is_whole = is_whole && (is_joint || r.force[0] != 0 || r.force[1] != 0);
                if (r.on == b) add_wrench(&sum, r, 1, center);
                if (r.by == b) add_wrench(&sum, r, -1, center);
            }
            if (!is_whole) continue;
            seen += yk_dynamics_contact_count(d) > 0;
            double largest = fmax(1, d->largest_force);
            CHECK_NEAR(sum.force[0], asked.force[0], 1e-11 * largest);
            CHECK_NEAR(sum.force[1], asked.force[1], 1e-11 * largest);
            CHECK_NEAR(sum.moment, asked.moment, 1e-11 * largest);
        }
        rig_free(&rig);
    }
    assert_true(seen > 10);
}

static void energy_is_kept_through_meshes(void **unused)
{
    (void)unused;
    for (size_t k = 0; k < 5; k++) {
        Run run = run_of_text(machines[k], run_options(1e-10));
        for (int row = 1; row <= 10; row++) assert_int_equal(yk_simulation_advance(run.sim, 0.05 * row), YK_OK);
        YkSimulationSummary s = yk_simulation_summary(run.sim);
        assert_true(s.energy_error < 1e-7 && s.worst_residual < 1e-12);
        run_free(&run);
    }
}

// 0.3 x'' + 0.7 y'' (y/x) ... with y = -0.4 x: (0.3 + 0.7 * 0.16) x'' = 2.
static void meshes_that_need_each_other_are_solved_together(void **unused)
{
    (void)unused;
    Rig rig = rig_of_text(PLANETARY_SET);
    yk_state_set_input(rig.state, 0, (YkMotion){1, 54, 27});
    assert_true(yk_state_solve(rig.state) >= 0);
    CHECK_NEAR(rate_of(&rig, "c.rate"), 20, 1e-13); // 20/(20 + 34)
    CHECK_NEAR(rate_of(&rig, "c.accel"), 10, 1e-13);
    CHECK_NEAR(20 * (54 - 20) + 7 * (rate_of(&rig, "planet.rate") - 20), 0, 1e-11);
    rig_free(&rig);
}

static void a_crossed_belt_turns_backwards(void **unused)
{
    (void)unused;
    Rig rig = rig_of_text(BELT);
    assert_true(yk_dynamics_solve(rig.dynamics, rig.state, YK_METHOD_REDUCED) >= 0);
    CHECK_NEAR(rate_of(&rig, "x.accel"), 2 / (0.3 + 0.7 * 0.16), 1e-13);
    CHECK_NEAR(rate_of(&rig, "y.accel"), -0.4 * 2 / (0.3 + 0.7 * 0.16), 1e-13);
    rig_free(&rig);
}

// Statics of one pair: the torque on the second wheel is that on the first times the ratio; its pins carry the mesh.
static void torque_is_multiplied_by_the_ratio(void **unused)
{
    (void)unused;
    Rig rig = rig_of_text(
        "bodies:\n  ground: {points: {A: [0, 0], B: [0.09, 0]}}\n  p: {points: {A: [0, 0]}, mass: 1, inertia: 1}\n"
        "  q: {points: {B: [0, 0]}, mass: 1, inertia: 1}\njoints:\n  A: {pin: [ground, p], angle: x}\n"
        "  B: {pin: [ground, q], angle: y}\ngears: {g: {mesh: [p, q], teeth: [10, 20]}}\n"
        "efforts: {y: 6}\nstart: {x: 0}\n");
    yk_dynamics_prescribe(rig.dynamics, 0, true);
    assert_true(yk_dynamics_solve(rig.dynamics, rig.state, YK_METHOD_REDUCED) >= 0);
    CHECK_NEAR(yk_dynamics_effort(rig.dynamics, 0), 3, 1e-13); // x = -2 y: the drive holds 6 N m by 3
    YkReaction a = yk_dynamics_reaction(rig.dynamics, 0);
    CHECK_NEAR(fabs(a.force[1]), 3 / 0.03, 1e-10);              // pitch radius 30 mm
    CHECK_NEAR(a.force[0], 100 * tan(20 * YK_PI / 180), 1e-10); // the pin holds it against the flanks' push apart
    YkChannel channel = rig_channel(rig.mech, "g.force");
    CHECK_NEAR(yk_dynamics_channel(rig.dynamics, rig.state, channel), 100 / cos(20 * YK_PI / 180), 1e-10);
    YkReaction g = yk_dynamics_contact(rig.dynamics, 0);
    CHECK_NEAR(g.at[0], 0.03, 1e-13); // the pitch point
    CHECK_NEAR(g.force[0], a.force[0], 1e-10);
    rig_free(&rig);
}

// A rack pushes its pinion the same whichever way its slide is written.
static void a_slide_written_backwards_gives_the_same_forces(void **unused)
{
    (void)unused;
    Rig rig[] = {rig_of_text(RACK), rig_of_text(RACK_BACKWARDS)};
    YkReaction pin[2];
    for (int k = 0; k < 2; k++) {
        assert_true(yk_dynamics_solve(rig[k].dynamics, rig[k].state, YK_METHOD_REDUCED) >= 0);
        pin[k] = yk_dynamics_reaction(rig[k].dynamics, 0);
    }
    assert_true(fabs(pin[0].force[0]) > 0.1);
    for (int k = 0; k < 2; k++) CHECK_NEAR(pin[0].force[k], pin[1].force[k], 1e-10);
    CHECK_NEAR(rate_of(&rig[0], "q.accel"), rate_of(&rig[1], "q.accel"), 1e-10);
    for (int k = 0; k < 2; k++) rig_free(&rig[k]);
}

// A flat face has no side thrust: its force N = m (g + a) lies along the guide, off it by the slope v of the lift.
static void a_flat_face_pushes_along_its_guide(void **unused)
{
    (void)unused;
    Rig rig = rig_of_text("gravity: [0, -10]\n"
                          "laws:\n  lift: {period: 2*pi, segments: [{rise: {to: 2, by: 0.02, law: cycloidal}}, "
                          "{fall: {to: 4, by: 0.02, law: cycloidal}}, {dwell: {to: 2*pi}}]}\n"
                          "bodies: {shaft: {}, tappet: {mass: 0.3}}\n"
                          "joints:\n  K: {pin: [ground, shaft], angle: th}\n"
                          "  T: {slide: [ground, tappet], along: y, distance: s}\n"
                          "cams: {disc: {cam: shaft, follower: tappet, law: lift, face: flat, base: 0.04}}\n"
                          "drives: {th: 0.6 + 5 rad/s * t}\n");
    assert_true(yk_dynamics_solve(rig.dynamics, rig.state, YK_METHOD_REDUCED) >= 0);
    double v = 0.02 / 2 * (1 - cos(YK_PI * 0.6)), N = 0.3 * (10 + rate_of(&rig, "s.accel"));
    YkReaction pin = yk_dynamics_reaction(rig.dynamics, 0), guide = yk_dynamics_reaction(rig.dynamics, 1);
    CHECK_NEAR(guide.force[0], 0, 1e-12);
    CHECK_NEAR(guide.moment, -v * N, 1e-12); // the face is touched at x = v, where the cam rises as fast as the lift
    CHECK_NEAR(pin.force[1], N, 1e-12);
    CHECK_NEAR(yk_dynamics_effort(rig.dynamics, 0), v * N, 1e-12);
    rig_free(&rig);
}

#define TWO_ROLLERS(by)                                                                                                \
    "laws:\n  lift: {period: 2*pi, segments: [{rise: {to: 150 deg, by: " by ", law: cycloidal}}, "                     \
    "{dwell: {to: 200 deg}}, {fall: {to: 330 deg, by: " by ", law: 3-4-5}}, {dwell: {to: 2*pi}}]}\n"                   \
    "bodies:\n  ground: {points: {O: [0, 0], Q: [-90 mm, 20 mm]}}\n  shaft: {mass: 2, inertia: 0.001}\n"

// Of two rollers one bears: the force of the cam is normal to the path of that roller's centre on the cam, and pushes
// it away from the cam's axis; along the follower's freedom it is what accelerates the follower.
static void check_two_rollers(const char *text, bool turns)
{
    Rig rig = rig_of_text(text);
    size_t count[2] = {0, 0};
    yk_dynamics_prescribe(rig.dynamics, 0, true);
    for (int k = 0; k < 36; k++) {
        yk_state_set_input(rig.state, 0, (YkMotion){0.1 + k * YK_PI / 18, 50, 30});
        assert_true(yk_dynamics_solve(rig.dynamics, rig.state, YK_METHOD_REDUCED) >= 0);
        double accel = rate_of(&rig, "q.accel"), need = 2 * accel;
        if (fabs(accel) < 1e-6) continue; // no roller bears
        YkReaction contact = yk_dynamics_contact(rig.dynamics, 0);
        YkBodyMotion cam = yk_body_motion(rig.mech, &rig.state->space, 1);
        YkBodyMotion follower = yk_body_motion(rig.mech, &rig.state->space, 2);
        YkVec at = yk_vec(contact.at[0], contact.at[1]), force = yk_vec(contact.force[0], contact.force[1]);
        YkVec pin = turns ? yk_vec(-0.09, 0.02) : at, freedom = turns ? yk_quarter(yk_sub(at, pin)) : yk_vec(0, 1);
        YkVec own = turns ? yk_scale(follower.w, yk_quarter(yk_sub(at, pin))) : follower.velocity;
        YkVec path = yk_sub(own, yk_scale(cam.w, yk_quarter(at)));
        assert_true(contact.on == 2 && contact.by == 1);
        if (turns) need = 0.001 * accel;
        CHECK_NEAR(yk_dot(force, freedom), need, 1e-12 * (1 + fabs(need)));
        CHECK_NEAR(yk_dot(force, path), 0, 1e-12 * yk_norm(force) * yk_norm(path));
        assert_true(yk_dot(force, at) > 0);
        bool is_second = turns ? yk_norm(yk_sub(at, pin)) < 0.08 : at.y < 0; // arms of 85 and 70 mm
        assert_int_equal(is_second, need < 0);
        count[is_second]++;
    }
    assert_true(count[0] > 8 && count[1] > 8);
    rig_free(&rig);
}

static void of_two_rollers_the_one_that_is_pushed_bears(void **unused)
{
    (void)unused;
    check_two_rollers(
        TWO_ROLLERS("20 mm") "  fol: {mass: 2}\njoints:\n  O: {pin: [ground, shaft], angle: th}\n"
                             "  G: {slide: [ground, fol], along: y, distance: q}\n"
                             "cams: {c: {cam: shaft, follower: fol, law: lift, roller: 8 mm, base: 30 mm, "
                             "offset: 6 mm, conjugate: {roller: 10 mm, span: 90 mm}}}\nstart: {th: 0}\n",
        false);
    check_two_rollers(
        TWO_ROLLERS("15 deg") "  fol: {points: {Q: [0, 0]}, mass: 2, inertia: 0.001}\n"
                              "joints:\n  O: {pin: [ground, shaft], angle: th}\n  Q: {pin: [ground, fol], angle: q}\n"
                              "cams: {c: {cam: shaft, follower: fol, law: lift, roller: 8 mm, base: 30 mm, arm: 85 "
                              "mm, conjugate: {arm: 70 mm, angle: -75 deg}}}\nstart: {th: 0}\n",
        true);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_train_of_the_format),
        cmocka_unit_test(of_two_rollers_the_one_that_is_pushed_bears),
        cmocka_unit_test(many_turns_stay_exact),
        cmocka_unit_test(wheels_keep_their_ratio),
        cmocka_unit_test(a_pinion_moves_its_rack),
        cmocka_unit_test(a_cam_is_its_law),
        cmocka_unit_test(forces_by_both_formulations),
        cmocka_unit_test(told_contacts_are_what_holds_a_body),
        cmocka_unit_test(energy_is_kept_through_meshes),
        cmocka_unit_test(a_crossed_belt_turns_backwards),
        cmocka_unit_test(a_slide_written_backwards_gives_the_same_forces),
        cmocka_unit_test(a_flat_face_pushes_along_its_guide),
        cmocka_unit_test(torque_is_multiplied_by_the_ratio),
        cmocka_unit_test(meshes_that_need_each_other_are_solved_together),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
