// `planets: N`: one planet in the file against the same machine with all N planets as bodies.
#include <stdarg.h>
#include "meshes.h"
#include "rig.h"

enum { TEXT = 8192 };

static const char *plate_of(bool moves)
{
    return moves ? "pin: [ground, plate], angle: a" : "weld: [ground, plate]";
}

// Off centre where the axis moves: without weight and with every mass centred, all is symmetrical.
static const char *center_of(bool moves)
{
    return moves ? "[1 mm, 2 mm]" : "[0, 0]";
}

static void begin(char *text, const char *gravity, bool moves)
{
    snprintf(text, TEXT,
             "gravity: [0, %s]\nparameters: {Zs: 20, Zp: 16, Zr: 52, mod: 2 mm, m: 0.3 kg, r: mod*(Zs + Zp)/2}\n"
             "bodies:\n  ground: {points: {A: [0, 0]}}\n"
             "  plate: {points: {A: [0, 0], O: [0.3, 0.1]}, mass: 2, center: [0.1, 0], inertia: 0.05}\n"
             "  sun: {mass: 0.5, inertia: 0.0002}\n  ring: {mass: 1, inertia: 0.004, center: %s}\n",
             gravity, center_of(moves));
}

static void add(char *text, const char *format, ...)
{
    va_list list;
    size_t length = strlen(text);
    va_start(list, format);
    vsnprintf(text + length, TEXT - length, format, list);
    va_end(list);
    assert_true(strlen(text) < TEXT - 1);
}

static void add_joints(char *text, bool moves)
{
    add(text, "joints:\n  A: {%s}\n  S: {pin: [plate, sun], at: O, angle: s}\n", plate_of(moves));
    add(text, "  C: {pin: [plate, arm], at: O, angle: c}\n  R: {pin: [plate, ring], at: O, angle: q}\n");
}

static const char after[] = "efforts: {s: 0.3, q: -1}\nstart: {c: 0.4, s.rate: 5, c.rate: 3}\n";

// One planet that stands for all.
static Rig shared(int planets, const char *gravity, bool moves)
{
    static char text[TEXT];
    begin(text, gravity, moves);
    add(text, "  arm: {points: {O: [0, 0], P0: [r, 0]}, mass: 0.2, inertia: 0.0003, center: %s}\n", center_of(moves));
    add(text, "  p0: {mass: m, inertia: 0.0001}\n");
    add_joints(text, moves);
    add(text, "  P0: {pin: [arm, p0], angle: p, friction: {viscous: 0.01}}\ngears:\n");
    add(text, "  i0: {mesh: [sun, p0], teeth: [Zs, Zp], module: mod, planets: %d, carrier: arm}\n", planets);
    add(text, "  o0: {mesh: [p0, ring], teeth: [Zp, Zr], module: mod, internal: true, carrier: arm}\n%s", after);
    return rig_of_text(text);
}

// All of them as bodies.
static Rig whole(int planets, const char *gravity, bool moves)
{
    static char text[TEXT];
    begin(text, gravity, moves);
    add(text, "  arm:\n    mass: 0.2\n    inertia: 0.0003\n    center: %s\n    points:\n      O: [0, 0]\n",
        center_of(moves));
    for (int k = 0; k < planets; k++)
        add(text, "      P%d: [r*cos(2*pi*%d/%d), r*sin(2*pi*%d/%d)]\n", k, k, planets, k, planets);
    for (int k = 0; k < planets; k++) add(text, "  p%d: {mass: m, inertia: 0.0001}\n", k);
    add_joints(text, moves);
    for (int k = 0; k < planets; k++) add(text, "  P%d: {pin: [arm, p%d], friction: {viscous: 0.01}}\n", k, k);
    add(text, "gears:\n");
    for (int k = 0; k < planets; k++) {
        add(text, "  i%d: {mesh: [sun, p%d], teeth: [Zs, Zp], module: mod, carrier: arm}\n", k, k);
        add(text, "  o%d: {mesh: [p%d, ring], teeth: [Zp, Zr], module: mod, internal: true, carrier: arm}\n", k, k);
    }
    add(text, "%s", after);
    return rig_of_text(text);
}

static size_t joint_of(const Rig *rig, const char *name)
{
    size_t joint = 0;
    while (strcmp(yk_model_joint_name(rig->model, joint), name) != 0) joint++;
    return joint;
}

static size_t body_of(const Rig *rig, const char *name)
{
    size_t body = 0;
    while (strcmp(yk_model_body_name(rig->model, body), name) != 0) body++;
    return body;
}

static YkReaction reaction(const Rig *rig, const char *name)
{
    return yk_dynamics_reaction(rig->dynamics, joint_of(rig, name));
}

static YkReaction contact(const Rig *rig, const char *name)
{
    for (size_t k = 0; k < yk_dynamics_contact_count(rig->dynamics); k++)
        if (strcmp(yk_dynamics_contact_name(rig->dynamics, k), name) == 0) return yk_dynamics_contact(rig->dynamics, k);
    fail();
    return (YkReaction){0};
}

static void check_same(YkReaction a, YkReaction b, double size)
{
    for (int k = 0; k < 2; k++) CHECK_NEAR(a.force[k], b.force[k], 1e-9 * size);
    for (int k = 0; k < 2; k++) CHECK_NEAR(a.at[k], b.at[k], 1e-12);
    CHECK_NEAR(a.moment, b.moment, 1e-9 * size);
}

// Sets both at the same inputs, given by names: their inputs need not have one order.
static void move_alike(Rig rigs[2], uint64_t *seed)
{
    static const char *const names[] = {"a", "s", "c"};
    for (size_t k = 0; k < 3; k++) {
        YkMotion m = {check_uniform(seed, -3, 3), check_uniform(seed, -8, 8), check_uniform(seed, -40, 40)};
        for (int side = 0; side < 2; side++) {
            const YkMechanism *mech = rigs[side].mech;
            for (size_t i = 0; i < yk_input_count(mech); i++)
                if (strcmp(yk_coordinate_info(mech, yk_input_coordinate(mech, i)).name, names[k]) == 0)
                    yk_state_set_input(rigs[side].state, i, m);
        }
    }
}

static double effort_along(const Rig *rig, const char *name)
{
    YkChannel channel = {0};
    char text[32];
    snprintf(text, sizeof text, "%s.effort", name);
    channel = rig_channel(rig->mech, text);
    return yk_dynamics_channel(rig->dynamics, rig->state, channel);
}

// Every planet's own balance, not that of all of them; both close.
static void check_balances(const Rig *a, const Rig *b, double size)
{
    static const char *const names[] = {"arm", "sun", "ring", "p0"};
    for (size_t n = 0; n < 4; n++) {
        YkBalance of[2];
        for (int side = 0; side < 2; side++) {
            const Rig *rig = side ? b : a;
            of[side] = yk_dynamics_balance(rig->dynamics, body_of(rig, names[n]));
            CHECK_NEAR(of[side].residual, 0, 1e-11);
        }
        for (int k = 0; k < 2; k++) {
            CHECK_NEAR(of[0].loads.force[k], of[1].loads.force[k], 1e-9 * size);
            CHECK_NEAR(of[0].reactions.force[k], of[1].reactions.force[k], 1e-9 * size);
            CHECK_NEAR(of[0].inertia.force[k], of[1].inertia.force[k], 1e-9 * size);
        }
        CHECK_NEAR(of[0].loads.moment, of[1].loads.moment, 1e-9 * size);
        CHECK_NEAR(of[0].reactions.moment, of[1].reactions.moment, 1e-9 * size);
        CHECK_NEAR(of[0].inertia.moment, of[1].inertia.moment, 1e-9 * size);
    }
}

static void prescribe(Rig *rig, bool is)
{
    for (size_t i = 0; i < yk_input_count(rig->mech); i++) yk_dynamics_prescribe(rig->dynamics, i, is);
}

static void check_sums(const Rig *a, const Rig *b, double size)
{
    YkEnergy of[2] = {yk_dynamics_energy(a->dynamics), yk_dynamics_energy(b->dynamics)};
    YkWrench shaking[2] = {yk_dynamics_shaking(a->dynamics), yk_dynamics_shaking(b->dynamics)};
    CHECK_NEAR(of[0].kinetic, of[1].kinetic, 1e-12 * (1 + of[1].kinetic));
    CHECK_NEAR(of[0].potential, of[1].potential, 1e-12 * (1 + fabs(of[1].potential)));
    for (int k = 0; k < 2; k++) CHECK_NEAR(shaking[0].force[k], shaking[1].force[k], 1e-9 * size);
    CHECK_NEAR(shaking[0].moment, shaking[1].moment, 1e-9 * size);
}

// By symmetry all planets carry the same when nothing else acts: the least forces of the redundant machine are those.
static void without_weight_every_force_is_that_of_the_machine_with_all_planets(void **unused)
{
    (void)unused;
    uint64_t seed = 5;
    for (int planets = 2; planets <= 5; planets++) {
        Rig rigs[2] = {shared(planets, "0", false), whole(planets, "0", false)};
        for (int side = 0; side < 2; side++) prescribe(&rigs[side], true);
        for (int turn = 0; turn < 12; turn++) {
            YkMethod method = turn % 2 ? YK_METHOD_NEWTON_EULER : YK_METHOD_REDUCED;
            move_alike(rigs, &seed);
            for (int side = 0; side < 2; side++)
                assert_true(yk_dynamics_solve(rigs[side].dynamics, rigs[side].state, method) >= 0);
            double size = rigs[1].dynamics->largest_force;
            assert_true(size > 1);
            static const char *const joints[] = {"A", "S", "C", "R", "P0"};
            for (size_t k = 0; k < 5; k++)
                check_same(reaction(&rigs[0], joints[k]), reaction(&rigs[1], joints[k]), size);
            check_same(contact(&rigs[0], "i0"), contact(&rigs[1], "i0"), size);
            check_same(contact(&rigs[0], "o0"), contact(&rigs[1], "o0"), size);
            CHECK_NEAR(effort_along(&rigs[0], "s"), effort_along(&rigs[1], "s"), 1e-9 * size);
            CHECK_NEAR(effort_along(&rigs[0], "c"), effort_along(&rigs[1], "c"), 1e-9 * size);
            check_sums(&rigs[0], &rigs[1], size);
            check_balances(&rigs[0], &rigs[1], size);
        }
        for (int side = 0; side < 2; side++) rig_free(&rigs[side]);
    }
}

// Whatever the planets carry each, all of them together do the same.
static void motion_and_sums_are_those_of_all_planets_under_weight_on_an_axis_that_moves(void **unused)
{
    (void)unused;
    uint64_t seed = 7;
    for (int planets = 1; planets <= 4; planets++)
        for (int turn = 0; turn < 10; turn++) {
            Rig rigs[2] = {shared(planets, "-9.81", true), whole(planets, "-9.81", true)};
            YkMethod method = turn % 2 ? YK_METHOD_NEWTON_EULER : YK_METHOD_REDUCED;
            move_alike(rigs, &seed);
            for (int side = 0; side < 2; side++) prescribe(&rigs[side], turn % 3 == 0);
            for (int side = 0; side < 2; side++)
                assert_true(yk_dynamics_solve(rigs[side].dynamics, rigs[side].state, method) >= 0);
            double size = rigs[1].dynamics->largest_force;
            static const char *const rates[] = {"a.accel", "s.accel", "c.accel", "q.accel"};
            for (size_t k = 0; k < 4; k++) {
                double x[2];
                for (int side = 0; side < 2; side++)
                    x[side] = yk_state_channel(rigs[side].state, rig_channel(rigs[side].mech, rates[k]));
                CHECK_NEAR(x[0], x[1], 1e-9 * (1 + fabs(x[1])));
            }
            for (int side = 0; side < 2 && turn % 3 == 0; side++)
                CHECK_NEAR(effort_along(&rigs[side], "s"), effort_along(&rigs[0], "s"), 1e-9 * size);
            check_sums(&rigs[0], &rigs[1], size);
            for (int side = 0; side < 2; side++) rig_free(&rigs[side]);
        }
}

static double body_at(const Rig *rig, size_t body, YkVec *acceleration)
{
    YkBodyMotion m = yk_body_motion(rig->mech, &rig->state->space, body);
    *acceleration = m.acceleration;
    return m.a;
}

// Newton's and Euler's equations of one planet with what is told of it; the sun's bearing has only the sun to carry.
static void one_planet_is_balanced_by_what_is_told_of_it(void **unused)
{
    (void)unused;
    uint64_t seed = 9;
    const double gravity = 9.81, damping = 0.01, z = 16, radius = 2e-3 * z / 2;
    for (int planets = 2; planets <= 4; planets++) {
        Rig rig = shared(planets, "-9.81", true), rigs[2] = {rig, rig};
        prescribe(&rig, true);
        for (int turn = 0; turn < 10; turn++) {
            move_alike(rigs, &seed);
            assert_true(yk_dynamics_solve(rig.dynamics, rig.state, (YkMethod)(turn % 2)) >= 0);
            double size = rig.dynamics->largest_force;
            YkVec a, sun;
            size_t planet = yk_model_find_body(rig.model, "p0"), wheel = yk_model_find_body(rig.model, "sun");
            double spin = body_at(&rig, planet, &a), turns = body_at(&rig, wheel, &sun);
            YkReaction pin = reaction(&rig, "P0"), inner = contact(&rig, "i0"), outer = contact(&rig, "o0"),
                       bearing = reaction(&rig, "S");
            double sum[2], moment = 0;
            for (int k = 0; k < 2; k++) sum[k] = pin.force[k] + inner.force[k] - outer.force[k];
            CHECK_NEAR(sum[0], 0.3 * a.x, 1e-9 * size);
            CHECK_NEAR(sum[1], 0.3 * (a.y + gravity), 1e-9 * size);
            YkVec center = yk_vec(pin.at[0], pin.at[1]);
            moment +=
                yk_cross(yk_sub(yk_vec(inner.at[0], inner.at[1]), center), yk_vec(inner.force[0], inner.force[1]));
            moment -=
                yk_cross(yk_sub(yk_vec(outer.at[0], outer.at[1]), center), yk_vec(outer.force[0], outer.force[1]));
            double rate = yk_state_channel(rig.state, rig_channel(rig.mech, "p.rate"));
            CHECK_NEAR(moment - damping * rate, 1e-4 * spin, 1e-9 * size);
            CHECK_NEAR(yk_norm(yk_sub(yk_vec(inner.at[0], inner.at[1]), center)), radius, 1e-12);
            CHECK_NEAR(bearing.force[0], 0.5 * sun.x, 1e-9 * size); // the teeth around it cancel
            CHECK_NEAR(bearing.force[1], 0.5 * (sun.y + gravity), 1e-9 * size);
            YkVec arm = yk_sub(yk_vec(inner.at[0], inner.at[1]), yk_vec(bearing.at[0], bearing.at[1]));
            double torque = -planets * yk_cross(arm, yk_vec(inner.force[0], inner.force[1]));
            CHECK_NEAR(torque + 0.3 + effort_along(&rig, "s"), 2e-4 * turns, 1e-9 * size);
        }
        rig_free(&rig);
    }
}

static void both_formulations_agree(void **unused)
{
    (void)unused;
    static const char *const machines[] = {PLANETS_ON_PLATE, PLANETS_IN_PAIRS};
    uint64_t seed = 8;
    for (size_t k = 0; k < 2; k++) {
        Rig rig = rig_of_text(machines[k]);
        for (int turn = 0; turn < 10; turn++) {
            double found[2][4];
            assert_true(rig_shake(&rig, &seed));
            for (int way = 0; way < 2; way++) {
                assert_true(yk_dynamics_solve(rig.dynamics, rig.state, (YkMethod)way) >= 0);
                rig_check_balance(&rig, 1e-11, 1, k);
                for (size_t i = 0; i < rig.mech->input_count; i++)
                    found[way][i] = yk_state_input(rig.state, i).acceleration;
            }
            for (size_t i = 0; i < rig.mech->input_count; i++)
                CHECK_NEAR(found[0][i], found[1][i], 1e-10 * (1 + fabs(found[0][i])));
        }
        rig_free(&rig);
    }
}

// Four planets of two kinds: each second planet's pins and teeth carry half of what the pair of one would.
static void planets_that_mesh_with_each_other_share_alike(void **unused)
{
    (void)unused;
    Rig rig = rig_of_text(PLANETS_IN_PAIRS);
    assert_true(yk_dynamics_solve(rig.dynamics, rig.state, YK_METHOD_REDUCED) >= 0);
    double size = rig.dynamics->largest_force;
    static const struct {
        const char *body, *pin;
        double sign, mass;
    } planets[] = {{"first", "P", 1, 0.25}, {"second", "Q", -1, 0.3}};
    for (size_t k = 0; k < 2; k++) {
        YkVec a, sum = {0, 0};
        body_at(&rig, yk_model_find_body(rig.model, planets[k].body), &a);
        YkReaction pin = reaction(&rig, planets[k].pin), mine = contact(&rig, k ? "c" : "a"),
                   mutual = contact(&rig, "b");
        sum = yk_add(sum, yk_scale(planets[k].sign, yk_vec(pin.force[0], pin.force[1])));
        sum = yk_sub(sum, yk_vec(mine.force[0], mine.force[1])); // each is the first of its outer pair
        sum = yk_add(sum, yk_scale(k ? 1 : -1, yk_vec(mutual.force[0], mutual.force[1])));
        CHECK_NEAR(sum.x, planets[k].mass * a.x, 1e-9 * size);
        CHECK_NEAR(sum.y, planets[k].mass * (a.y + 9.81), 1e-9 * size);
    }
    YkReaction sun = reaction(&rig, "S"), ring = reaction(&rig, "R");
    CHECK_NEAR(sun.force[0], 0, 1e-9 * size);
    CHECK_NEAR(sun.force[1], 0.5 * 9.81, 1e-9 * size);
    CHECK_NEAR(hypot(ring.force[0], ring.force[1]), 0, 1e-9 * size);
    assert_true(fabs(ring.moment) > 0.1);
    rig_free(&rig);
}

// The copies' masses follow a parameter in variants as in a file of its own.
static void masses_follow_parameters(void **unused)
{
    (void)unused;
    Rig rig = shared(3, "-9.81", true);
    const YkBody *bodies = rig.model->bodies;
    size_t others = yk_model_find_body(rig.model, "p0_others");
    assert_true(others != YK_NOT_FOUND);
    CHECK_NEAR(bodies[others].mass, 2 * 0.3, 1e-15);
    CHECK_NEAR(bodies[others].center.x, -0.036 * 3 / 2, 1e-15); // from the planet's pin
    CHECK_NEAR(bodies[others].inertia, 0.3 * 0.036 * 0.036 * 1.5, 1e-16);
    CHECK_NEAR(bodies[yk_model_find_body(rig.model, "p0")].inertia, 3 * 1e-4, 1e-18);
    rig_free(&rig);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(without_weight_every_force_is_that_of_the_machine_with_all_planets),
        cmocka_unit_test(motion_and_sums_are_those_of_all_planets_under_weight_on_an_axis_that_moves),
        cmocka_unit_test(one_planet_is_balanced_by_what_is_told_of_it),
        cmocka_unit_test(both_formulations_agree),
        cmocka_unit_test(planets_that_mesh_with_each_other_share_alike),
        cmocka_unit_test(masses_follow_parameters),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
