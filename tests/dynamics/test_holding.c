// Efforts that hold a machine at rest under dry friction: closed forms, every combination of frictions, and motion.
#include "dynamics/holding.h"
#include "rig.h"
#include "simulate/run.h"

static YkEffortRange range_of(const Rig *rig, const char *name)
{
    return yk_dynamics_effort_range(rig->dynamics, yk_coordinate_find(rig->mech, name));
}

static double effort_of(const Rig *rig, const char *name)
{
    return yk_dynamics_effort(rig->dynamics, yk_coordinate_find(rig->mech, name));
}

#define INCLINE                                                                                                        \
    "gravity: [0, -10]\nbodies:\n  ground: {points: {O: [0, 0]}}\n  b: {points: {P: [0, 0]}, mass: 2}\njoints:\n"      \
    "  S: {slide: [ground, b], along: 0.5 rad, distance: d, friction: {coulomb: 0.3}}\n"

// m g (sin a -+ mu cos a); once it begins to move, or moves, only one end is left.
static void a_block_on_an_incline_is_held_by_a_range(void **unused)
{
    (void)unused;
    double weight = 20 * sin(0.5), most = 0.3 * 20 * cos(0.5);
    for (int method = 0; method < 2; method++) {
        Rig rig = rig_of_text(INCLINE "drives: {d: 0 m}\n");
        assert_int_equal(yk_dynamics_solve(rig.dynamics, rig.state, (YkMethod)method), YK_OK);
        YkEffortRange range = range_of(&rig, "d");
        assert_true(range.is_known && !range.is_single && yk_dynamics_is_held_by_friction(rig.dynamics));
        CHECK_NEAR(range.low, weight - most, 1e-12);
        CHECK_NEAR(range.high, weight + most, 1e-12);
        CHECK_NEAR(effort_of(&rig, "d"), weight, 1e-12);
        assert_true(isnan(yk_dynamics_channel(rig.dynamics, rig.state, rig_channel(rig.mech, "d.effort"))));
        CHECK_NEAR(yk_dynamics_channel(rig.dynamics, rig.state, rig_channel(rig.mech, "d.effort.from")), range.low, 0);
        CHECK_NEAR(yk_dynamics_channel(rig.dynamics, rig.state, rig_channel(rig.mech, "d.effort.to")), range.high, 0);
        static const double motions[][2] = {{0, 0.7}, {0, -0.7}, {1e-9, 0}, {-1e-9, 0}}; // rate, acceleration
        for (int k = 0; k < 4; k++) {
            yk_state_set_input(rig.state, 0, (YkMotion){0, motions[k][0], motions[k][1]});
            assert_int_equal(yk_dynamics_solve(rig.dynamics, rig.state, (YkMethod)method), YK_OK);
            assert_true(range_of(&rig, "d").is_single && !yk_dynamics_is_held_by_friction(rig.dynamics));
            CHECK_NEAR(effort_of(&rig, "d"), 2 * motions[k][1] + weight + (k % 2 ? -most : most), 1e-12);
        }
        rig_free(&rig);
    }
}

// Free, it stays where its effort is in that range, and moves off with what is left over beyond it.
static void a_free_block_sticks_or_slips(void **unused)
{
    (void)unused;
    double weight = 20 * sin(0.5), most = 0.3 * 20 * cos(0.5);
    for (int method = 0; method < 2; method++)
        for (int k = -3; k <= 3; k++) {
            Rig rig = rig_of_text(INCLINE);
            double beyond = 0.5 * k * most, slip = fabs(beyond) > most ? beyond - copysign(most, beyond) : 0;
            yk_dynamics_set_effort(rig.dynamics, 0, weight + beyond);
            assert_int_equal(yk_dynamics_solve(rig.dynamics, rig.state, (YkMethod)method), YK_OK);
            CHECK_NEAR(yk_state_coordinate(rig.state, 0).acceleration, slip / 2, 1e-12);
            assert_true(yk_dynamics_reaction(rig.dynamics, 0).is_determinate); // its one friction is what is missing
            assert_false(yk_dynamics_is_held_by_friction(rig.dynamics));
            CHECK_NEAR(yk_dynamics_balance(rig.dynamics, 1).residual, 0, 1e-13);
            rig_free(&rig);
        }
}

// An actuator from the origin pushes a block of weight W along a guide at y = 1, from below, at x: f = -e x/r and
// N = W - e/r, so -mu W r/(x - mu) <= e <= mu W r/(x + mu). Where x < mu it jams: no pull moves it.
static void a_guide_jams_within_its_cone(void **unused)
{
    (void)unused;
    static const double places[] = {1.5, 0.8, 0.6, 0.4, 0.1};
    for (int k = 0; k < 5; k++) {
        char text[1000];
        double x = places[k], r = sqrt(x * x + 1), mu = 0.5, W = 30;
        snprintf(text, sizeof text,
                 "gravity: [0, -10]\nbodies:\n  ground: {points: {O: [0, 0], G: [0, 1]}}\n  a: {points: {O: [0, 0]}}\n"
                 "  b: {points: {P: [0, 0]}}\n  c: {points: {P: [0, 0]}, mass: 3}\njoints:\n"
                 "  O: {pin: [ground, a], angle: q}\n  S: {slide: [a, b], along: x, distance: s}\n  P: {pin: [b, c]}\n"
                 "  G: {slide: [ground, c], along: x, from: G, distance: x, friction: {coulomb: %g}}\n"
                 "drives: {s: %.17g m}\nstart: {q: %.17g, x: %.17g}\n",
                 mu, r, atan2(1, x), x);
        Rig rig = rig_of_text(text);
        assert_int_equal(yk_dynamics_solve(rig.dynamics, rig.state, YK_METHOD_REDUCED), YK_OK);
        YkEffortRange range = range_of(&rig, "s");
        assert_true(range.is_known);
        CHECK_NEAR(range.high, mu * W * r / (x + mu), 1e-9);
        if (x > mu)
            CHECK_NEAR(range.low, -mu * W * r / (x - mu), 1e-7);
        else
            assert_true(range.low == -HUGE_VAL);
        rig_free(&rig);
    }
}

// A slab (2 kg) that already slides on the ground, a block (3 kg) at rest on it, and beside them a block (5 kg) at rest
// on an incline: the slab's friction is a load for what stands on it, and nothing to the third.
static void one_joint_slides_while_others_stand(void **unused)
{
    (void)unused;
    const double g = 10, m = 2, n = 3, under = 0.1, over = 0.4, slope = 0.4 * 5 * g * cos(0.3),
                 weight = 5 * g * sin(0.3);
    for (int method = 0; method < 2; method++) {
        Rig rig = rig_of_text(
            "gravity: [0, -10]\nbodies:\n  ground: {points: {O: [0, 0]}}\n  slab: {points: {P: [0, 0]}, mass: 2}\n"
            "  block: {points: {P: [0, 0]}, mass: 3}\n  other: {points: {P: [0, 0]}, mass: 5}\njoints:\n"
            "  U: {slide: [ground, slab], along: x, distance: x, friction: {coulomb: 0.1}}\n"
            "  V: {slide: [slab, block], along: x, distance: y, friction: {coulomb: 0.4}}\n"
            "  W: {slide: [ground, other], along: 0.3 rad, distance: z, friction: {coulomb: 0.4}}\n"
            "drives: {z: 0 m}\nstart: {x.rate: 1}\n");
        size_t x = yk_coordinate_find(rig.mech, "x"), y = yk_coordinate_find(rig.mech, "y"), input = 0;
        while (yk_input_coordinate(rig.mech, input) != x) input++;
        for (int k = -12; k <= 12; k++) { // no solution may depend on the one before
            double way = k & 1 ? 1 : -1, effort = 5 * k, sliding = -way * under * (m + n) * g;
            double together = (effort + sliding) / (m + n);
            bool slips = fabs(together) > over * g;
            double drag = copysign(over * n * g, together), a = slips ? (effort + sliding - drag) / m : together;
            yk_state_set_input(rig.state, input, (YkMotion){0, way, 0});
            yk_dynamics_set_effort(rig.dynamics, x, effort);
            assert_int_equal(yk_dynamics_solve(rig.dynamics, rig.state, (YkMethod)method), YK_OK);
            CHECK_NEAR(yk_state_coordinate(rig.state, x).acceleration, a, 1e-10);
            CHECK_NEAR(yk_state_coordinate(rig.state, y).acceleration, slips ? drag / n - a : 0, 1e-10);
            YkEffortRange range = range_of(&rig, "z");
            assert_true(range.is_known && !range.is_single);
            CHECK_NEAR(range.low, weight - slope, 1e-10);
            CHECK_NEAR(range.high, weight + slope, 1e-10);
        }
        rig_free(&rig);
    }
}

#define PIN(R) "friction: {coulomb: 0.15, radius: " #R " m}"
#define PRESS                                                                                                          \
    "gravity: [0, -9.81]\nbodies:\n  ground: {points: {O: [0, 0]}}\n"                                                  \
    "  crank: {points: {O: [0, 0], A: [0.05, 0]}, mass: 6, center: [0.02, 0.01], inertia: 0.3}\n"                      \
    "  rod: {points: {A: [0, 0], B: [0.3, 0]}, mass: 1.5, center: [0.11, 0], inertia: 0.015}\n"                        \
    "  ram: {points: {B: [0, 0]}, mass: 4}\njoints:\n  O: {pin: [ground, crank], angle: theta, " PIN(                  \
        0.02) "}\n"                                                                                                    \
              "  A: {pin: [crank, rod], angle: psi, " PIN(0.02) "}\n  B: {pin: [rod, ram], " PIN(                      \
                  0.01) "}\n"                                                                                          \
                        "  R: {slide: [ground, ram], along: y, distance: h, friction: {coulomb: 0.12}}\n"              \
                        "efforts: {h: 80 N}\nstart: {theta: 120 deg, psi: -210 deg, h: -0.25}\n"
#define FIVE_BAR                                                                                                       \
    "gravity: [0, -10]\nbodies:\n  ground: {points: {O: [0, 0], Q: [0.5, 0]}}\n"                                       \
    "  a: {points: {O: [0, 0], A: [0.3, 0]}, mass: 2, rod: [O, A]}\n"                                                  \
    "  b: {points: {A: [0, 0], C: [0.5, 0]}, mass: 3, rod: [A, C]}\n"                                                  \
    "  c: {points: {Q: [0, 0], B: [0.3, 0]}, mass: 2, rod: [Q, B]}\n"                                                  \
    "  d: {points: {B: [0, 0], C: [0.5, 0]}, mass: 1, rod: [B, C]}\n"                                                  \
    "joints:\n  O: {pin: [ground, a], angle: q, " PIN(0.05) "}\n  Q: {pin: [ground, c], angle: p, " PIN(               \
        0.05) "}\n"                                                                                                    \
              "  A: {pin: [a, b], angle: u, " PIN(0.04) "}\n  B: {pin: [c, d], angle: w, " PIN(                        \
                  0.04) "}\n"                                                                                          \
                        "  C: {pin: [b, d], " PIN(0.03) "}\nstart: {q: 110 deg, p: 60 deg, u: -60 deg, w: 60 deg}\n"

// The efforts at all frictions at their limits, in every combination of senses: limits and joint forces are repeated
// until both stand.
static void check_against_all_senses(const char *text, const char *const *names, size_t count, size_t inputs)
{
    Rig rig = rig_of_text(text);
    YkLoads *loads = rig.dynamics->loads;
    double low[2] = {HUGE_VAL, HUGE_VAL}, high[2] = {-HUGE_VAL, -HUGE_VAL};
    for (unsigned senses = 0; senses < 1u << count; senses++) {
        for (int round = 0; round < 200; round++) {
            assert_int_equal(yk_dynamics_solve_once(rig.dynamics, rig.state, YK_METHOD_NEWTON_EULER), YK_OK);
            for (size_t k = 0, j = 0; k < loads->item_count; k++) {
                YkLoadItem *item = &loads->items[k];
                if (item->kind != YK_LOAD_COULOMB) continue;
                item->dry = (senses >> j++ & 1 ? 1 : -1) * yk_dynamics_dry_limit(rig.dynamics, item);
            }
        }
        for (size_t i = 0; i < inputs; i++) {
            double effort = effort_of(&rig, names[i]);
            low[i] = fmin(low[i], effort);
            high[i] = fmax(high[i], effort);
        }
    }
    assert_int_equal(yk_dynamics_solve(rig.dynamics, rig.state, YK_METHOD_REDUCED), YK_OK);
    for (size_t i = 0; i < inputs; i++) {
        YkEffortRange range = range_of(&rig, names[i]);
        assert_true(range.is_known && !range.is_single);
        CHECK_NEAR(range.low, low[i], 1e-10 * (1 + fabs(low[i])));
        CHECK_NEAR(range.high, high[i], 1e-10 * (1 + fabs(high[i])));
        assert_true(effort_of(&rig, names[i]) > range.low && effort_of(&rig, names[i]) < range.high);
    }
    rig_free(&rig);
}

static void the_ends_are_those_of_all_senses_of_friction(void **unused)
{
    (void)unused;
    static const char *const press[] = {"theta"}, *const five[] = {"q", "p"};
    check_against_all_senses(PRESS "drives: {theta: 120 deg}\n", press, 4, 1);
    check_against_all_senses(FIVE_BAR "drives: {q: 110 deg, p: 60 deg}\n", five, 5, 2);
}

// With one drive the ends are the efforts of all but no motion, one way and the other.
static void the_ends_are_those_of_the_slowest_motion(void **unused)
{
    (void)unused;
    Rig rig = rig_of_text(PRESS "drives: {theta: 120 deg}\n");
    assert_int_equal(yk_dynamics_solve(rig.dynamics, rig.state, YK_METHOD_REDUCED), YK_OK);
    YkEffortRange range = range_of(&rig, "theta");
    for (int way = -1; way <= 1; way += 2) {
        yk_state_set_input(rig.state, 0, (YkMotion){yk_state_input(rig.state, 0).position, way * 1e-9, 0});
        assert_int_equal(yk_dynamics_solve(rig.dynamics, rig.state, YK_METHOD_REDUCED), YK_OK);
        CHECK_NEAR(effort_of(&rig, "theta"), way < 0 ? range.low : range.high, 1e-10);
    }
    rig_free(&rig);
}

// Let go under an effort within the range it stays; just outside it moves off, the right way.
static void the_range_is_what_keeps_it_at_rest(void **unused)
{
    (void)unused;
    Rig rig = rig_of_text(PRESS "drives: {theta: 120 deg}\n");
    assert_int_equal(yk_dynamics_solve(rig.dynamics, rig.state, YK_METHOD_REDUCED), YK_OK);
    YkEffortRange range = range_of(&rig, "theta");
    double start = yk_state_input(rig.state, 0).position;
    static const double parts[] = {-0.001, 0.001, 0.1, 0.5, 0.9, 0.999, 1.001};
    for (int k = 0; k < 7; k++) {
        Run run = run_of_text(PRESS, run_options(1e-9));
        double effort = range.low + parts[k] * (range.high - range.low);
        assert_int_equal(yk_simulation_set_effort(run.sim, "theta", effort), YK_OK);
        assert_int_equal(yk_simulation_advance(run.sim, 1), YK_OK);
        double moved = run_value(&run, "theta") - start;
        if (k == 0) assert_true(moved < -1e-5);
        if (k == 6) assert_true(moved > 1e-5);
        if (k > 0 && k < 6) {
            CHECK_NEAR(moved, 0, 1e-12);
            assert_int_equal(yk_simulation_happening_count(run.sim), 0);
        }
        run_free(&run);
    }
    rig_free(&rig);
}

// Motion and rest in one machine: where one drive moves and the other rests, joints that stand hold by a range only
// what depends on them. In a five-bar every joint moves with any drive, so there is one answer.
static void a_machine_that_moves_has_one_answer(void **unused)
{
    (void)unused;
    Rig rig = rig_of_text(FIVE_BAR "drives: {q: 110 deg + 1 rad/s * t, p: 60 deg}\n");
    assert_int_equal(yk_dynamics_solve(rig.dynamics, rig.state, YK_METHOD_REDUCED), YK_OK);
    assert_true(range_of(&rig, "q").is_single);  // no joint that stands turns with it
    assert_false(range_of(&rig, "p").is_single); // its own pin stands
    YkEffortRange range = range_of(&rig, "p");
    CHECK_NEAR(range.high - range.low,
               2 * 0.15 * 0.05 * yk_dynamics_channel(rig.dynamics, rig.state, rig_channel(rig.mech, "Q.force")), 1e-9);
    rig_free(&rig);
}

// Sets all frictions to given shares of their limits, repeatedly until limits and joint forces stand.
static void push_to_shares(Rig *rig, const double *share)
{
    YkLoads *loads = rig->dynamics->loads;
    for (int round = 0; round < 30; round++) {
        assert_int_equal(yk_dynamics_solve_once(rig->dynamics, rig->state, YK_METHOD_NEWTON_EULER), YK_OK);
        for (size_t k = 0, j = 0; k < loads->item_count; k++)
            if (loads->items[k].kind == YK_LOAD_COULOMB)
                loads->items[k].dry = share[j++] * yk_dynamics_dry_limit(rig->dynamics, &loads->items[k]);
    }
}

// One input of a five-bar is driven, the other sticks under an effort. The ends of the first one's range have all
// frictions but one at their limits, and that one so that the second input, driven too, needs just its effort.
static void a_drive_holds_what_sticks_elsewhere(void **unused)
{
    (void)unused;
    Rig both = rig_of_text(FIVE_BAR "drives: {q: 110 deg, p: 60 deg}\n");
    assert_int_equal(yk_dynamics_solve(both.dynamics, both.state, YK_METHOD_REDUCED), YK_OK);
    double borne = 0.4 * range_of(&both, "p").low + 0.6 * range_of(&both, "p").high;
    double low = HUGE_VAL, high = -HUGE_VAL;
    for (unsigned senses = 0; senses < 32; senses++)
        for (size_t open = 0; open < 5; open++) {
            if (senses >> open & 1) continue;
            double share[5], at[2] = {-1, 1}, effort[2];
            for (size_t j = 0; j < 5; j++) share[j] = senses >> j & 1 ? 1 : -1;
            for (int end = 0; end < 2; end++) {
                share[open] = at[end];
                push_to_shares(&both, share);
                effort[end] = effort_of(&both, "p") - borne;
            }
            if (effort[0] * effort[1] > 0) continue;
            for (int step = 0; step < 12; step++) { // almost linear
                double next = at[0] - effort[0] * (at[1] - at[0]) / (effort[1] - effort[0]);
                if (!(fabs(effort[1] - effort[0]) > 1e-11)) break;
                share[open] = next;
                push_to_shares(&both, share);
                at[0] = at[1], effort[0] = effort[1];
                at[1] = next, effort[1] = effort_of(&both, "p") - borne;
            }
            low = fmin(low, effort_of(&both, "q"));
            high = fmax(high, effort_of(&both, "q"));
        }
    rig_free(&both);
    for (int method = 0; method < 2; method++) {
        Rig one = rig_of_text(FIVE_BAR "drives: {q: 110 deg}\n");
        yk_dynamics_set_effort(one.dynamics, yk_coordinate_find(one.mech, "p"), borne);
        assert_int_equal(yk_dynamics_solve(one.dynamics, one.state, (YkMethod)method), YK_OK);
        YkEffortRange range = range_of(&one, "q");
        assert_true(range.is_known && !range.is_single);
        CHECK_NEAR(yk_state_coordinate(one.state, yk_coordinate_find(one.mech, "p")).acceleration, 0, 1e-9);
        CHECK_NEAR(range.low, low, 1e-8 * fabs(low));
        CHECK_NEAR(range.high, high, 1e-8 * fabs(high));
        for (size_t k = 0; k < 5; k++) assert_false(yk_dynamics_reaction(one.dynamics, k).is_determinate);
        rig_free(&one);
    }
}

// One input of a five-bar is driven, the other slips off: all joints slide but the drive's own pin, whose friction
// alone is open. Either input is the driven one.
static void a_drive_holds_while_the_rest_slips(void **unused)
{
    (void)unused;
    static const char *const drives[] = {"drives: {q: 110 deg}\n", "drives: {p: 60 deg}\n"}, *const names[] = {"q",
                                                                                                               "p"};
    for (int which = 0; which < 2; which++)
        for (int way = -1; way <= 1; way += 2) {
            char text[2000];
            snprintf(text, sizeof text, "%s%s", FIVE_BAR, drives[which]);
            Rig rig = rig_of_text(text);
            yk_dynamics_set_effort(rig.dynamics, yk_coordinate_find(rig.mech, names[1 - which]), 60 * way);
            assert_int_equal(yk_dynamics_solve(rig.dynamics, rig.state, YK_METHOD_REDUCED), YK_OK);
            YkEffortRange range = range_of(&rig, names[which]);
            assert_true(range.is_known && !range.is_single);
            double share[5], ends[2];
            for (int32_t j = 0; j < 5; j++)
                share[j] = yk_joint_motion(rig.mech, &rig.state->space, j, false).acceleration > 0 ? -1 : 1;
            for (int end = 0; end < 2; end++) {
                share[which] = end ? 1 : -1; // the joints are O, Q, A, B, C
                push_to_shares(&rig, share);
                ends[end] = effort_of(&rig, names[which]);
            }
            CHECK_NEAR(range.low, fmin(ends[0], ends[1]), 1e-9 * (1 + fabs(ends[0])));
            CHECK_NEAR(range.high, fmax(ends[0], ends[1]), 1e-9 * (1 + fabs(ends[0])));
            rig_free(&rig);
        }
}

// A press that stands free with more frictions than motions, and a block that slides: the block changes nothing for
// the press, nor the press for the block. First comes the block, or the press.
static void what_slides_elsewhere_closes_no_range(void **unused)
{
    (void)unused;
    static const char *const blocks[] = {
        "\n", "  Z: {slide: [ground, block], along: x, distance: z, friction: {coulomb: 0.3}}\n"};
    for (int first = 0; first < 2; first++)
        for (int rate = -1; rate <= 1; rate++) {
            char text[2000];
            snprintf(
                text, sizeof text,
                "gravity: [0, -10]\nbodies:\n  ground: {points: {O: [0, 0]}}\n"
                "  crank: {points: {O: [0, 0], A: [0.05, 0]}, mass: 6, center: [0.02, 0.01], inertia: 0.3}\n"
                "  rod: {points: {A: [0, 0], B: [0.3, 0]}, mass: 1.5, center: [0.11, 0], inertia: 0.015}\n"
                "  ram: {points: {B: [0, 0]}, mass: 4}\n  block: {mass: 2}\njoints:\n%s"
                "  O: {pin: [ground, crank], angle: theta, " PIN(
                    0.2) "}\n"
                         "  A: {pin: [crank, rod], angle: psi, " PIN(0.2) "}\n  B: {pin: [rod, ram], " PIN(
                             0.1) "}\n"
                                  "  R: {slide: [ground, ram], along: x, distance: h, friction: {coulomb: 0.12}}\n%s"
                                  "start: {theta: 120 deg, psi: -130 deg, h: 0.25, z.rate: %d}\n",
                blocks[first], blocks[1 - first], rate);
            Rig rig = rig_of_text(text);
            assert_int_equal(yk_dynamics_solve(rig.dynamics, rig.state, YK_METHOD_REDUCED), YK_OK);
            CHECK_NEAR(yk_state_coordinate(rig.state, yk_coordinate_find(rig.mech, "theta")).acceleration, 0, 1e-9);
            CHECK_NEAR(yk_state_coordinate(rig.state, yk_coordinate_find(rig.mech, "z")).acceleration, -3.0 * rate,
                       1e-12);
            assert_true(yk_dynamics_is_held_by_friction(rig.dynamics));
            for (size_t k = 0; k < rig.model->joint_count; k++)
                assert_int_equal(yk_dynamics_reaction(rig.dynamics, k).is_determinate,
                                 strcmp(rig.model->joints[k].name, "Z") == 0);
            rig_free(&rig);
        }
}

// A press that moves, beside a block that stands: its frictions and accelerations are those of the press by itself,
// found in another way.
static void what_stands_elsewhere_changes_nothing(void **unused)
{
    (void)unused;
    static const char *const blocks[] = {
        "", "  Z: {slide: [ground, block], along: 0.2 rad, distance: z, friction: {coulomb: 0.3}}\n"};
    Rig rig[2];
    for (int which = 0; which < 2; which++) {
        char text[2000];
        snprintf(
            text, sizeof text,
            "gravity: [0, -10]\nbodies:\n  ground: {points: {O: [0, 0]}}\n"
            "  crank: {points: {O: [0, 0], A: [0.05, 0]}, mass: 6, center: [0.02, 0.01], inertia: 0.3}\n"
            "  rod: {points: {A: [0, 0], B: [0.13, 0]}, mass: 1.5, center: [0.04, 0], inertia: 0.015}\n"
            "  ram: {points: {B: [0, 0]}, mass: 4}\n%sjoints:\n  O: {pin: [ground, crank], angle: theta, " PIN(
                0.02) "}\n"
                      "  A: {pin: [crank, rod], angle: psi, " PIN(0.02) "}\n  B: {pin: [rod, ram], " PIN(
                          0.01) "}\n"
                                "  R: {slide: [ground, ram], along: x, distance: h, friction: {coulomb: 0.4}}\n%s"
                                "efforts: {theta: 5 N*m, h: -60 N}\nstart: {theta: 70 deg, psi: -90 deg, h: 0.14}\n",
            which ? "  block: {mass: 2}\n" : "", blocks[which]);
        rig[which] = rig_of_text(text);
    }
    for (int k = 0; k < 24; k++) {
        double theta = 1.2 + 0.25 * k, rate = (k % 2 ? 3 : -3) + 0.1 * k;
        if (fabs(sin(theta)) < 0.15) continue; // at dead points friction may jam it
        for (int which = 0; which < 2; which++) {
            size_t input = 0, coordinate = yk_coordinate_find(rig[which].mech, "theta");
            while (yk_input_coordinate(rig[which].mech, input) != coordinate) input++;
            yk_state_set_input(rig[which].state, input, (YkMotion){theta, rate, 0});
            assert_int_equal(yk_dynamics_solve(rig[which].dynamics, rig[which].state, YK_METHOD_REDUCED), YK_OK);
        }
        CHECK_NEAR(yk_state_coordinate(rig[1].state, yk_coordinate_find(rig[1].mech, "z")).acceleration, 0, 1e-12);
        for (size_t j = 0; j < 4; j++) {
            YkReaction alone = yk_dynamics_reaction(rig[0].dynamics, j),
                       beside = yk_dynamics_reaction(rig[1].dynamics, j);
            double size = rig[0].dynamics->largest_force;
            for (int axis = 0; axis < 2; axis++) CHECK_NEAR(beside.force[axis], alone.force[axis], 1e-9 * size);
        }
        double a = yk_state_coordinate(rig[0].state, yk_coordinate_find(rig[0].mech, "theta")).acceleration;
        CHECK_NEAR(yk_state_coordinate(rig[1].state, yk_coordinate_find(rig[1].mech, "theta")).acceleration, a,
                   1e-9 * fabs(a));
    }
    rig_free(&rig[0]);
    rig_free(&rig[1]);
}

// A plate that a parallelogram carries and guides keep from turning: its pin stands in every pose, but for rounding,
// while all else moves. Its friction costs no effort; what rods and guides bear is open.
static void a_joint_may_stand_while_all_else_moves(void **unused)
{
    (void)unused;
    Rig rig = rig_of_text(
        "gravity: [0, -10]\nbodies:\n  ground: {points: {O: [0, 0], Q: [0.7, 0]}}\n"
        "  a: {points: {O: [0, 0], A: [0.31, 0]}, mass: 2}\n  c: {points: {Q: [0, 0], B: [0.31, 0]}, mass: 2}\n"
        "  b: {points: {A: [0, 0], B: [0.7, 0], T: [0.23, 0.11]}, mass: 3}\n  cross: {mass: 1}\n"
        "  plate: {points: {T: [0, 0]}, mass: 4, center: [0.05, 0.02]}\njoints:\n  O: {pin: [ground, a], angle: q}\n"
        "  Q: {pin: [ground, c], angle: p}\n  A: {pin: [a, b], angle: u}\n  B: {pin: [b, c]}\n"
        "  X: {slide: [ground, cross], along: x, distance: x}\n  Y: {slide: [cross, plate], along: y, distance: y}\n"
        "  T: {pin: [b, plate], " PIN(
            0.05) "}\n"
                  "drives: {q: 50 deg + 3 rad/s * t}\nstart: {p: 50 deg, u: -50 deg, x: 0.4, y: 0.3}\n");
    int rounded = 0;
    for (int k = 0; k < 24; k++) {
        yk_state_set_input(rig.state, 0, (YkMotion){0.9 + 0.04 * k, 3, 0.5});
        assert_int_equal(yk_dynamics_solve(rig.dynamics, rig.state, YK_METHOD_REDUCED), YK_OK);
        rounded += yk_joint_rate(rig.mech, &rig.state->space, 6, false) != 0;
        assert_true(yk_dynamics_is_held_by_friction(rig.dynamics));
        assert_true(range_of(&rig, "q").is_single);
        assert_false(yk_dynamics_reaction(rig.dynamics, 5).is_determinate);
    }
    assert_true(rounded > 0);
    rig_free(&rig);
}

// Where nothing pulls, nothing is borne, and joints with friction need no effort to stay.
static void a_machine_without_loads_stays_by_itself(void **unused)
{
    (void)unused;
    Rig rig = rig_of_text(
        "bodies:\n  ground: {points: {O: [0, 0]}}\n  crank: {points: {O: [0, 0], A: [0.05, 0]}, mass: 6}\n"
        "  rod: {points: {A: [0, 0], B: [0.3, 0]}, mass: 1.5}\n  ram: {points: {B: [0, 0]}, mass: 4}\njoints:\n"
        "  O: {pin: [ground, crank], angle: theta, " PIN(0.02) "}\n  A: {pin: [crank, rod], angle: psi, " PIN(
            0.02) "}\n"
                  "  B: {pin: [rod, ram], " PIN(
                      0.01) "}\n"
                            "  R: {slide: [ground, ram], along: y, distance: h, friction: {coulomb: 0.12}}\n"
                            "drives: {theta: 120 deg}\nstart: {psi: -210 deg, h: -0.25}\n");
    assert_int_equal(yk_dynamics_solve(rig.dynamics, rig.state, YK_METHOD_REDUCED), YK_OK);
    YkEffortRange range = range_of(&rig, "theta");
    assert_true(range.is_known);
    CHECK_NEAR(range.low, 0, 1e-12);
    CHECK_NEAR(range.high, 0, 1e-12);
    CHECK_NEAR(effort_of(&rig, "theta"), 0, 1e-12);
    rig_free(&rig);
}

// With more joints than are looked at, efforts are known only where all of them move.
static void too_many_joints_leave_it_open(void **unused)
{
    (void)unused;
    enum { MANY = 201 };
    static char text[160 * MANY];
    int at = snprintf(text, sizeof text, "gravity: [0, -10]\nbodies:\n");
    for (int k = 0; k < MANY; k++) at += snprintf(text + at, sizeof text - (size_t)at, "  b%d: {mass: 1}\n", k);
    at += snprintf(text + at, sizeof text - (size_t)at, "joints:\n");
    for (int k = 0; k < MANY; k++)
        at += snprintf(text + at, sizeof text - (size_t)at,
                       "  S%d: {slide: [ground, b%d], along: x, distance: s%d, friction: {coulomb: 0.3}}\n", k, k, k);
    snprintf(text + at, sizeof text - (size_t)at, "drives: {s67: 0 m}\n");
    Rig rig = rig_of_text(text);
    for (int resting = -1; resting <= 3; resting++) {
        for (size_t i = 0; i < MANY; i++)
            yk_state_set_input(rig.state, i,
                               (YkMotion){0, (int)yk_input_coordinate(rig.mech, i) == resting * 67 ? 0 : 1, 0});
        assert_int_equal(yk_dynamics_solve(rig.dynamics, rig.state, YK_METHOD_REDUCED), YK_OK);
        bool is_open = resting >= 0 && resting < 3;
        YkEffortRange range = range_of(&rig, "s67");
        assert_int_equal(yk_dynamics_is_held_by_friction(rig.dynamics), is_open);
        assert_int_equal(range.is_known, !is_open);
        assert_int_equal(range.is_single, !is_open);
        if (is_open) assert_true(range.low == -HUGE_VAL && range.high == HUGE_VAL);
        if (!is_open) CHECK_NEAR(range.low, 3, 1e-12);
        CHECK_NEAR(effort_of(&rig, "s67"), resting == 1 ? 0 : 3, 1e-12);
        assert_int_equal(range_of(&rig, "s8").is_single, true); // free: nothing to hold
    }
    rig_free(&rig);
}

// What has no value is said to have none, not to jam.
static void a_load_without_a_value_is_told(void **unused)
{
    (void)unused;
    for (int driven = 0; driven < 2; driven++) {
        Rig rig =
            rig_of_text(driven ? INCLINE "drives: {d: 0 m}\nforces: {push: {body: b, at: P, value: [(1 N*1 s)/t, 0]}}\n"
                               : INCLINE "forces: {push: {body: b, at: P, value: [(1 N*1 s)/t, 0]}}\n");
        assert_int_equal(yk_dynamics_solve(rig.dynamics, rig.state, YK_METHOD_REDUCED), YK_NOT_CONVERGED);
        assert_non_null(strstr(yk_dynamics_report(rig.dynamics)->message, "`push` has no finite value"));
        rig_free(&rig);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_block_on_an_incline_is_held_by_a_range),
        cmocka_unit_test(a_free_block_sticks_or_slips),
        cmocka_unit_test(a_guide_jams_within_its_cone),
        cmocka_unit_test(one_joint_slides_while_others_stand),
        cmocka_unit_test(the_ends_are_those_of_all_senses_of_friction),
        cmocka_unit_test(the_ends_are_those_of_the_slowest_motion),
        cmocka_unit_test(the_range_is_what_keeps_it_at_rest),
        cmocka_unit_test(a_machine_that_moves_has_one_answer),
        cmocka_unit_test(a_drive_holds_what_sticks_elsewhere),
        cmocka_unit_test(a_drive_holds_while_the_rest_slips),
        cmocka_unit_test(what_slides_elsewhere_closes_no_range),
        cmocka_unit_test(what_stands_elsewhere_changes_nothing),
        cmocka_unit_test(a_joint_may_stand_while_all_else_moves),
        cmocka_unit_test(a_machine_without_loads_stays_by_itself),
        cmocka_unit_test(too_many_joints_leave_it_open),
        cmocka_unit_test(a_load_without_a_value_is_told),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
