// Free joints, against the same machine with a slide, a second slide and a pin written out.
#include <stdio.h>
#include "dynamics/rig.h"

#define HEAD                                                                                                           \
    "gravity: [0.4, -9.81]\nbodies:\n  ground: {points: {O: [0.1, 0.2], P: [0, 1], Q: [1, 1.2]}}\n"                    \
    "  arm: {points: {O: [0, 0], K: [0.5, 0.1]}, mass: 1.1, center: [0.2, 0.05], inertia: 0.07}\n"                     \
    "  plate: {points: {A: [-0.3, 0.1], B: [0.3, 0.1], C: [0.05, -0.1]}, mass: 2, center: [0.02, 0.03], inertia: "     \
    "0.1}\n"                                                                                                           \
    "  bob: {points: {B: [0, 0], E: [0, -0.2]}, mass: 0.5, center: [0, -0.2], inertia: 0.01}\n"
#define TAIL                                                                                                           \
    "  B: {pin: [plate, bob], angle: psi}\n"                                                                           \
    "springs:\n  a: {between: [ground.P, plate.A], stiffness: 100, length: 0.2}\n"                                     \
    "  b: {between: [ground.Q, bob.E], stiffness: 80, length: 0.2, damping: 1}\n"                                      \
    "  c: {along: x, stiffness: 30, length: 0.1, damping: 2}\n  d: {along: y, force: 50 N/m^3 * length^3}\n"           \
    "  e: {along: phi, stiffness: 3, damping: 0.2}\n"                                                                  \
    "forces: {F: {body: plate, at: B, value: [3, 2], axes: body}}\n"                                                   \
    "efforts: {x: 3 N - 1 N*s/m * y.rate, y: 2 N * sin(phi), phi: 0.5 N*m * cos(psi)}\n"                               \
    "start: {q: 0.3, q.rate: 0.4, x: 0.5, y: 0.4, phi: 0.2, psi: 0.3, x.rate: 0.3, y.rate: -0.2, phi.rate: 0.7, "      \
    "psi.rate: -1}\n"

// The first body, the second, their points, and the same joint written out.
static const char *const joints[][2] = {
    {"  F: {free: [arm, plate], at: [x, y, phi], from: K, to: C}\n",
     "  F: {slide: [arm, h], along: x, from: K, distance: x}\n  G: {slide: [h, i], along: y, distance: y}\n"
     "  H: {pin: [i, plate], at: C, angle: phi}\n"},
    {"  F: {free: [plate, arm], at: [x, y, phi], from: C, to: K}\n",
     "  F: {slide: [plate, h], along: x, from: C, distance: x}\n  G: {slide: [h, i], along: y, distance: y}\n"
     "  H: {pin: [i, arm], at: K, angle: phi}\n"},
    {"  F: {free: [ground, plate], at: [x, y, phi]}\n",
     "  F: {slide: [ground, h], along: x, distance: x}\n  G: {slide: [h, i], along: y, distance: y}\n"
     "  H: {pin: [i, plate], at: H, angle: phi}\n"}};

static Rig rig_with(size_t kind, bool is_free)
{
    char text[4000];
    static const char *const chains[] = {"  h: {}\n  i: {points: {C: [0, 0]}}\n",
                                         "  h: {}\n  i: {points: {K: [0, 0]}}\n", "  h: {}\n  i: {}\n"};
    const char *joint = joints[kind][!is_free];
    snprintf(text, sizeof text, "%s%sjoints:\n  O: {pin: [ground, arm], angle: q}\n%s%s", HEAD,
             is_free ? "" : chains[kind], joint, TAIL);
    char *at = strstr(text, "at: H, ");
    if (at) memset(at, ' ', 7); // both origins
    return rig_of_text(text);
}

static void check_values(Rig *rig, Rig *chain)
{
    static const char *const names[] = {
        "x",         "y",         "phi",       "psi",       "x.rate",        "q.accel",    "x.accel",
        "y.accel",   "phi.accel", "psi.accel", "plate.B.x", "bob.E.y.accel", "B.force.x",  "B.force.y",
        "O.force.x", "O.force.y", "kinetic",   "potential", "x.effort",      "phi.effort", "shaking.x"};
    for (size_t n = 0; n < sizeof names / sizeof *names; n++) {
        double wanted = yk_dynamics_channel(chain->dynamics, chain->state, rig_channel(chain->mech, names[n]));
        double found = yk_dynamics_channel(rig->dynamics, rig->state, rig_channel(rig->mech, names[n]));
        if (fabs(found - wanted) > 1e-10 * (1 + fabs(wanted))) print_error("%s\n", names[n]);
        CHECK_NEAR(found, wanted, 1e-10 * (1 + fabs(wanted)));
    }
    for (size_t b = 1; b < yk_model_body_count(rig->model); b++)
        CHECK_NEAR(yk_dynamics_balance(rig->dynamics, b).residual, 0, 1e-12);
}

// Both methods; free, and with x driven.
static void a_free_joint_is_two_slides_and_a_pin(void **unused)
{
    (void)unused;
    for (size_t kind = 0; kind < sizeof joints / sizeof *joints; kind++) {
        Rig rig = rig_with(kind, true), chain = rig_with(kind, false);
        assert_int_equal(rig.mech->input_count, 5);
        for (int turn = 0; turn < 6; turn++) {
            YkMethod method = turn % 2 ? YK_METHOD_NEWTON_EULER : YK_METHOD_REDUCED;
            for (int c = 0; c < 2; c++) {
                Rig *r = c ? &chain : &rig;
                const YkTreeCoordinate *x = &r->mech->coordinates[yk_coordinate_find(r->mech, "x")];
                YkMotion m = yk_state_input(r->state, (size_t)x->input);
                yk_state_set_input(r->state, (size_t)x->input, (YkMotion){m.position + 0.1, 0.3 * turn, 0.5});
                yk_dynamics_prescribe(r->dynamics, (size_t)x->input, turn > 3);
                assert_int_equal(yk_state_solve(r->state), YK_OK);
                assert_int_equal(yk_dynamics_solve(r->dynamics, r->state, method), YK_OK);
            }
            check_values(&rig, &chain);
        }
        rig_free(&rig);
        rig_free(&chain);
    }
}

static void nobody_sees_its_carriage(void **unused)
{
    (void)unused;
    Rig rig = rig_with(0, true);
    assert_int_equal(yk_model_body_count(rig.model), 4);
    assert_int_equal(yk_model_joint_count(rig.model), 3);
    assert_string_equal(yk_model_joint_kind(rig.model, 1), "free");
    assert_string_equal(yk_model_body_name(rig.model, yk_model_joint_body(rig.model, 1, 0)), "arm");
    assert_string_equal(yk_model_body_name(rig.model, yk_model_joint_body(rig.model, 1, 1)), "plate");
    static const char *const names[] = {"q", "x", "y", "phi", "psi"}; // in the file's order
    for (size_t c = 0; c < 5; c++) {
        assert_string_equal(yk_coordinate_info(rig.mech, c).name, names[c]);
        assert_int_equal(yk_coordinate_info(rig.mech, c).joint, c == 0 ? 0 : c == 4 ? 2 : 1);
    }
    assert_int_equal(yk_mechanism_freedom(rig.mech).gruebler, 5);
    YkEquationCount count = yk_dynamics_count(rig.dynamics);
    assert_int_equal(count.force + count.moment, 9);
    assert_int_equal(count.unknown_reactions, 4); // of two pins
    assert_int_equal(yk_dynamics_solve(rig.dynamics, rig.state, YK_METHOD_REDUCED), YK_OK);
    YkReaction r = yk_dynamics_reaction(rig.dynamics, 1);
    assert_true(r.by == 1 && r.on == 2 && r.force[0] == 0 && r.force[1] == 0 && r.moment == 0);
    rig_free(&rig);
}

// The angle of the coupler of a four-bar to the ground as the input: the loop of the crank's angle closes.
static void the_angle_of_a_coupler_drives_a_four_bar(void **unused)
{
    (void)unused;
    Rig rig = rig_of_text("bodies:\n  ground: {points: {A0: [0, 0], B0: [4, 0]}}\n"
                          "  crank: {points: {A0: [0, 0], A: [1.5, 0]}, mass: 1, rod: [A0, A]}\n"
                          "  coupler: {points: {A: [0, 0], B: [3.5, 0]}, mass: 2, rod: [A, B]}\n"
                          "  rocker: {points: {B0: [0, 0], B: [3, 0]}, mass: 1, rod: [B0, B]}\njoints:\n"
                          "  F: {free: [ground, coupler], at: [x, y, psi]}\n  A0: {pin: [ground, crank]}\n"
                          "  A: {pin: [crank, coupler]}\n  B0: {pin: [ground, rocker]}\n  B: {pin: [coupler, rocker]}\n"
                          "drives: {psi: 30 deg + 5 deg/s * t}\nstart: {x: 0.8, y: 1.2}\n");
    assert_int_equal(yk_state_solve(rig.state), YK_OK);
    assert_int_equal(yk_dynamics_solve(rig.dynamics, rig.state, YK_METHOD_REDUCED), YK_OK);
    double x = yk_dynamics_channel(rig.dynamics, rig.state, rig_channel(rig.mech, "x"));
    double y = yk_dynamics_channel(rig.dynamics, rig.state, rig_channel(rig.mech, "y"));
    CHECK_NEAR(hypot(x, y), 1.5, 1e-12);
    CHECK_NEAR(hypot(x + 3.5 * cos(YK_PI / 6) - 4, y + 3.5 * sin(YK_PI / 6)), 3, 1e-12);
    double power = yk_dynamics_channel(rig.dynamics, rig.state, rig_channel(rig.mech, "psi.effort")) * YK_PI / 36,
           sum = 0;
    for (size_t b = 1; b < 4; b++) { // what the drive gives is what the masses take up
        const YkBody *body = &rig.model->bodies[b];
        const YkBodyMotion *m = &rig.dynamics->motion[b];
        sum += body->mass * yk_dot(m->velocity, m->acceleration) + body->inertia * m->w * m->a;
    }
    CHECK_NEAR(power, sum, 1e-12);
    rig_free(&rig);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_free_joint_is_two_slides_and_a_pin),
        cmocka_unit_test(nobody_sees_its_carriage),
        cmocka_unit_test(the_angle_of_a_coupler_drives_a_four_bar),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
