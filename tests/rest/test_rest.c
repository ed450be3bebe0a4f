// Equilibria and small vibrations against closed forms.
#include "check.h"
#include <yoke/yoke.h>
#include "base/problems.h"
#include "simulate/run.h"

static YkRest *rest_of(const char *text, YkModel **model)
{
    YkProblems *problems = yk_problems_new();
    *model = yk_model_parse(text, strlen(text), "t.yaml", NULL, problems);
    assert_non_null(*model);
    YkRest *rest = yk_rest_find(*model, NULL, problems);
    assert_non_null(rest);
    yk_problems_free(problems);
    return rest;
}

// Two pendulums of unit mass and length: omega^2 = g (2 +- sqrt 2); four equilibria, one stable.
#define DOUBLE                                                                                                         \
    "gravity: [0, -10]\nbodies:\n  ground: {points: {O: [0, 0]}}\n"                                                    \
    "  a: {points: {O: [0, 0], P: [0, -1]}, mass: 1, center: [0, -1]}\n"                                               \
    "  b: {points: {P: [0, 0]}, mass: 1, center: [0, -1]}\njoints:\n  O: {pin: [ground, a], angle: x}\n  P: {pin: "    \
    "[a, b], angle: y}\n"

static void a_double_pendulum_rests_in_four_places(void **unused)
{
    (void)unused;
    YkModel *model;
    YkRest *rest = rest_of(DOUBLE, &model);
    assert_int_equal(yk_rest_count(rest), 4);
    static const double heights[] = {-30, -10, 10, 30};
    for (size_t k = 0; k < 4; k++) {
        CHECK_NEAR(yk_rest_equilibrium(rest, k).potential, heights[k], 1e-9);
        assert_int_equal(yk_rest_equilibrium(rest, k).stability, k == 0 ? YK_STABILITY_STABLE : YK_STABILITY_UNSTABLE);
    }
    CHECK_NEAR(yk_rest_mode(rest, 0, 0).frequency, sqrt(10 * (2 - sqrt(2))), 1e-8);
    CHECK_NEAR(yk_rest_mode(rest, 0, 1).frequency, sqrt(10 * (2 + sqrt(2))), 1e-8);
    const double *M = yk_rest_mass(rest, 0), *K = yk_rest_stiffness(rest, 0);
    static const double mass[] = {5, 2, 2, 1}, stiffness[] = {30, 10, 10, 10}; // in the joint angles
    for (int k = 0; k < 4; k++) {
        CHECK_NEAR(M[k], mass[k], 1e-10);
        CHECK_NEAR(K[k], stiffness[k], 1e-7);
        CHECK_NEAR(yk_rest_damping(rest, 0)[k], 0, 1e-8);
    }
    yk_rest_free(rest);
    yk_model_free(model);
}

// A pendulum of J = 0.26 kg m^2 and m g l = 4.905 N m, with a drag about its pin.
#define DRAGGED(torque)                                                                                                \
    "gravity: [0, -9.81]\nbodies:\n  ground: {points: {O: [0, 0]}}\n"                                                  \
    "  bob: {points: {O: [0, 0]}, mass: 1, center: [0, -0.5], inertia: 0.01}\njoints: {O: {pin: [ground, bob], "       \
    "angle: th}}\nsprings: {d: {along: th, torque: '" torque "'}}\nstart: {th: 5 deg}\n"

static void drags_damp_by_their_slope_at_rest(void **unused)
{
    (void)unused;
    static const struct {
        const char *text;
        double slope, within;
    } drags[] = {{DRAGGED("0.3 N*m*s^2/rad^2 * rate*abs(rate)"), 0, 1e-12},                        // a corner
                 {DRAGGED("0.3 N*m * tanh(rate/(1e-4 rad/s))"), 3000, 1e-6},                       // within 1e-4 rad/s
                 {DRAGGED("0.2 N*m*s/rad * rate + 5 N*m*s^2/rad^2 * rate*abs(rate)"), 0.2, 1e-10}, // both
                 {DRAGGED("0.2 N*m*s/rad * rate - 4 N*m*s^3/rad^3 * rate^3"), 0.2, 1e-10}};
    for (size_t k = 0; k < sizeof drags / sizeof *drags; k++) {
        YkModel *model;
        YkRest *rest = rest_of(drags[k].text, &model);
        assert_int_equal(yk_rest_count(rest), 2);
        double c = yk_rest_damping(rest, 0)[0], half = drags[k].slope / (2 * 0.26), square = half * half - 4.905 / 0.26;
        CHECK_NEAR(c, drags[k].slope, drags[k].within);
        double slowest = square > 0 ? -half + sqrt(square) : -half, found = -HUGE_VAL;
        for (size_t r = 0; r < 2; r++) {
            double real, imaginary;
            yk_rest_root(rest, 0, r, &real, &imaginary);
            found = fmax(found, real);
        }
        CHECK_NEAR(found, slowest, 1e-9);
        yk_rest_free(rest);
        yk_model_free(model);
    }
}

// A block that x^2 + 1 pushes from 1e5 m away: nowhere at rest, though the least force is 1e-10 of the largest; that
// x^2 - 1 pushes: at -1, stable, and at 1.
#define PUSHED(constant)                                                                                               \
    "bodies:\n  ground: {points: {O: [0, 0]}}\n  block: {points: {P: [0, 0]}, mass: 1}\n"                              \
    "joints: {S: {slide: [ground, block], along: x, distance: x}}\n"                                                   \
    "efforts: {x: " constant " N + x^2 * 1 N/m^2}\nstart: {x: 1e5}\n"

static void the_least_force_is_no_equilibrium(void **unused)
{
    (void)unused;
    YkModel *model;
    YkRest *rest = rest_of(PUSHED("1"), &model);
    assert_int_equal(yk_rest_count(rest), 0);
    yk_rest_free(rest);
    yk_model_free(model);
    rest = rest_of(PUSHED("-1"), &model);
    assert_true(yk_rest_count(rest) > 0);
    for (size_t k = 0; k < yk_rest_count(rest); k++) {
        bool is_stable = yk_rest_equilibrium(rest, k).stability == YK_STABILITY_STABLE;
        CHECK_NEAR(yk_rest_stiffness(rest, k)[0], is_stable ? 2 : -2, 1e-3); // by differences of 1e-9 of 1e5 m
    }
    yk_rest_free(rest);
    yk_model_free(model);
}

// Two drives push one after the other, and a spring of 5 m draws the last block to 5 - 1 - 2 from the second.
static void drives_are_held_at_their_start(void **unused)
{
    (void)unused;
    YkModel *model;
    YkRest *rest =
        rest_of("bodies:\n  ground: {points: {O: [0, 0]}}\n  a: {}\n  b: {}\n"
                "  c: {points: {P: [0, 0]}, mass: 2}\njoints:\n"
                "  Z: {slide: [b, c], along: x, distance: z}\n  X: {slide: [ground, a], along: x, distance: x}\n"
                "  Y: {slide: [a, b], along: x, distance: y}\n"
                "springs: {k: {between: [ground.O, c.P], stiffness: 50, length: 5}}\n"
                "drives: {x: 1 m + 3 m/s * t, y: 2 m + 7 m/s * t}\nstart: {z: 1.5}\n",
                &model);
    const YkMechanism *mech = yk_rest_mechanism(rest);
    static const struct {
        const char *name;
        double at;
    } due[] = {{"x", 1}, {"y", 2}, {"z", 2}};
    assert_true(yk_rest_count(rest) > 0);
    for (int k = 0; k < 3; k++) {
        YkMotion q = yk_state_coordinate(yk_rest_state(rest, 0), yk_coordinate_find(mech, due[k].name));
        CHECK_NEAR(q.position, due[k].at, 1e-9);
        assert_true(q.velocity == 0 && q.acceleration == 0);
    }
    CHECK_NEAR(yk_rest_mode(rest, 0, 0).frequency, 5, 1e-7);
    yk_rest_free(rest);
    yk_model_free(model);
}

// A plate on two springs: sideways a pendulum of their length, up and down, and about its centre.
static void a_floating_plate_has_three_small_motions(void **unused)
{
    (void)unused;
    YkModel *model;
    YkRest *rest = rest_of("gravity: [0, -10]\nbodies:\n  ground: {points: {P: [-0.3, 0], Q: [0.3, 0]}}\n"
                           "  plate: {points: {A: [-0.3, 0], B: [0.3, 0]}, mass: 2, inertia: 0.06}\n"
                           "joints: {F: {free: [ground, plate], at: [x, y, phi]}}\nsprings:\n"
                           "  left: {between: [ground.P, plate.A], stiffness: 250, length: 0.21}\n"
                           "  right: {between: [ground.Q, plate.B], stiffness: 250, length: 0.21}\n"
                           "start: {x: 0.02, y: -0.2, phi: 0.1}\n",
                           &model);
    assert_int_equal(yk_rest_equilibrium(rest, 0).stability, YK_STABILITY_STABLE);
    CHECK_NEAR(yk_rest_equilibrium(rest, 0).potential, -20 * 0.25 + 250 * 0.04 * 0.04, 1e-9);
    CHECK_NEAR(yk_rest_mode(rest, 0, 0).frequency, sqrt(10 / 0.25), 1e-7);
    CHECK_NEAR(yk_rest_mode(rest, 0, 1).frequency, sqrt(2 * 250 / 2.), 1e-7);
    CHECK_NEAR(yk_rest_mode(rest, 0, 2).frequency, sqrt(2 * 250 * 0.09 / 0.06), 1e-7);
    yk_rest_free(rest);
    yk_model_free(model);
}

// An elbow of two links of 0.5, almost straight, that a block of mass m stretches along its line: d = cos q. A spring k
// holds q at e, so that omega = sqrt(k/m)/sin e exactly. The limit d = 1 is nearer than the steps of differences would
// be, above all in a machine that a far point makes large.
static void a_toggle_beside_its_limit_has_the_frequency_of_its_closed_form(void **unused)
{
    (void)unused;
    static const double bends[] = {0.3, 0.1, 0.005}, far[] = {0, 5, 30};
    for (size_t k = 0; k < 9; k++) {
        double e = bends[k % 3];
        char text[1024];
        snprintf(text, sizeof text,
                 "bodies:\n  ground: {points: {O: [0, 0], far: [%g, 0]}}\n  a: {points: {O: [0, 0], A: [0.5, 0]}}\n"
                 "  b: {points: {A: [0, 0], B: [0.5, 0]}}\n  s: {points: {B: [0, 0]}, mass: 2}\njoints:\n"
                 "  O: {pin: [ground, a], angle: q}\n  A: {pin: [a, b], angle: p}\n  B: {pin: [b, s]}\n"
                 "  S: {slide: [ground, s], along: x, from: O, to: B, distance: d}\n"
                 "springs: {K: {along: q, stiffness: 3, angle: %g}}\nstart: {d: %.17g, q: %g, p: %g}\n",
                 far[k / 3], e, cos(e + 0.1), e + 0.1, -2 * e - 0.2);
        YkModel *model;
        YkRest *rest = rest_of(text, &model);
        assert_int_equal(yk_rest_count(rest), 1);
        CHECK_NEAR(yk_rest_mode(rest, 0, 0).frequency, sqrt(1.5) / sin(e), 1e-7 / e);
        yk_rest_free(rest);
        yk_model_free(model);
    }
}

// A four-bar's rocker drives a rack: the assemblies that are found may differ by whole turns of the mesh, and each
// keeps its own while others are looked at.
static void every_equilibrium_keeps_its_mesh(void **unused)
{
    (void)unused;
    YkModel *model;
    YkRest *rest = rest_of(
        "gravity: [0, -9.81]\nbodies:\n  ground: {points: {O: [0, 0], C: [0.2, 0.03]}}\n"
        "  crank: {points: {O: [0, 0], A: [0.06, 0]}, mass: 0.8, rod: [O, A]}\n"
        "  rod: {points: {A: [0, 0], B: [0.22, 0]}, mass: 1.5, rod: [A, B]}\n"
        "  bell: {points: {C: [0, 0], B: [0.11, 0]}, mass: 2, rod: [C, B]}\n"
        "  table: {points: {G: [0, 0]}, mass: 6}\njoints:\n  O: {pin: [ground, crank], angle: theta}\n"
        "  A: {pin: [crank, rod], angle: phi}\n  C: {pin: [ground, bell], angle: psi}\n  B: {pin: [rod, bell]}\n"
        "  G: {slide: [ground, table], along: x, distance: s}\nracks: {r: {pinion: bell, rack: table, radius: 0.04}}\n"
        "drives: {theta: 0.5 rad}\nstart: {phi: -0.35, psi: 1.05, s: 0}\n",
        &model);
    size_t psi = yk_coordinate_find(yk_rest_mechanism(rest), "psi"),
           s = yk_coordinate_find(yk_rest_mechanism(rest), "s");
    double least = HUGE_VAL, most = -HUGE_VAL;
    for (size_t round = 0; round < 2; round++)
        for (size_t k = 0; k < yk_rest_count(rest); k++) {
            const YkState *state = yk_rest_state(rest, round == 0 ? k : yk_rest_count(rest) - 1 - k);
            double angle = yk_state_coordinate(state, psi).position;
            CHECK_NEAR(yk_state_coordinate(state, s).position, 0.04 * (angle - 1.05), 1e-12);
            least = fmin(least, angle);
            most = fmax(most, angle);
        }
    assert_true(most - least > 6); // there are some a turn apart
    yk_rest_free(rest);
    yk_model_free(model);
}

static void a_damped_spring_has_its_roots(void **unused)
{
    (void)unused;
    YkModel *model;
    YkRest *rest = rest_of(
        "bodies:\n  b: {points: {P: [0, 0]}, mass: 2}\njoints:\n  s: {slide: [ground, b], along: x, distance: d}\n"
        "springs: {k: {along: d, stiffness: 50, length: 0.3, damping: 4}}\nforces: {F: {body: b, at: P, value: [5, "
        "0]}}\nstart: {d: 0.1}\n",
        &model);
    assert_int_equal(yk_rest_count(rest), 1);
    CHECK_NEAR(yk_state_coordinate(yk_rest_state(rest, 0), 0).position, 0.4, 1e-12);
    CHECK_NEAR(yk_rest_mode(rest, 0, 0).frequency, 5, 1e-9);
    CHECK_NEAR(yk_rest_mode(rest, 0, 0).damping_ratio, 0.2, 1e-9);
    double real, imaginary;
    yk_rest_root(rest, 0, 0, &real, &imaginary);
    CHECK_NEAR(real, -1, 1e-8);
    CHECK_NEAR(fabs(imaginary), sqrt(24), 1e-8);
    yk_rest_free(rest);
    yk_model_free(model);
}

static void a_wheel_is_neutral(void **unused)
{
    (void)unused;
    YkModel *model;
    YkRest *rest = rest_of(
        "gravity: [0, -10]\nbodies:\n  ground: {points: {O: [0, 0]}}\n  w: {points: {O: [0, 0]}, mass: 1, inertia: 1}\n"
        "joints:\n  O: {pin: [ground, w], angle: x}\n",
        &model);
    assert_int_equal(yk_rest_count(rest), 1); // all poses are one continuum
    assert_int_equal(yk_rest_equilibrium(rest, 0).stability, YK_STABILITY_NEUTRAL);
    yk_rest_free(rest);
    yk_model_free(model);
}

// An arm of J = 0.6 kg m^2 that turns under an effort of its angle alone.
#define TURNED_BY(effort)                                                                                              \
    "bodies:\n  ground: {points: {O: [0, 0]}}\n  arm: {points: {O: [0, 0]}, mass: 2, center: [0.5, 0], inertia: "      \
    "0.1}\n"                                                                                                           \
    "joints: {O: {pin: [ground, arm], angle: q}}\nefforts: {q: '" effort "'}\nstart: {q: 0.3}\n"

// Their forces are rounding far from the place where they vanish, and have no slope there, or one at a corner.
static void forces_that_grow_with_a_power_have_one_equilibrium_without_stiffness(void **unused)
{
    (void)unused;
    static const struct {
        const char *text;
        double at;
        YkStability stability;
    } cases[] = {{TURNED_BY("-3 N*m * q*abs(q)"), 0, YK_STABILITY_STABLE},
                 {TURNED_BY("3 N*m * q*abs(q)"), 0, YK_STABILITY_UNSTABLE},
                 {TURNED_BY("-3 N*m * q^3"), 0, YK_STABILITY_STABLE},
                 {TURNED_BY("-3 N*m * (q - 1)^3"), 1, YK_STABILITY_STABLE},
                 {TURNED_BY("-3 N*m * q^5"), 0, YK_STABILITY_STABLE},
                 {TURNED_BY("-3 N*m * q^7"), 0, YK_STABILITY_STABLE},
                 {TURNED_BY("3 N*m * (q - 0.5)^9"), 0.5, YK_STABILITY_UNSTABLE}};
    for (size_t k = 0; k < sizeof cases / sizeof *cases; k++) {
        YkModel *model;
        YkRest *rest = rest_of(cases[k].text, &model);
        assert_int_equal(yk_rest_count(rest), 1);
        YkEquilibrium e = yk_rest_equilibrium(rest, 0);
        CHECK_NEAR(yk_state_coordinate(yk_rest_state(rest, 0), 0).position, cases[k].at, 1e-12);
        assert_int_equal(e.stability, cases[k].stability);
        assert_true(e.is_higher_order && yk_rest_stiffness(rest, 0)[0] == 0 && yk_rest_mode(rest, 0, 0).frequency == 0);
        yk_rest_free(rest);
        yk_model_free(model);
    }
}

// A force that touches zero pushes one way on both sides; it is not taken for the other place at which it vanishes.
static void forces_that_touch_zero_hold_nothing(void **unused)
{
    (void)unused;
    static const double others[] = {0.02, 0.004};
    for (size_t k = 0; k < 2; k++) {
        char text[600];
        snprintf(text, sizeof text, TURNED_BY("-3 N*m * q^2 * (q - %g)"), others[k]);
        YkModel *model;
        YkRest *rest = rest_of(text, &model);
        assert_int_equal(yk_rest_count(rest), 2);
        for (size_t e = 0; e < 2; e++) {
            YkEquilibrium at = yk_rest_equilibrium(rest, e);
            double q = yk_state_coordinate(yk_rest_state(rest, e), 0).position;
            bool touches = at.is_higher_order;
            CHECK_NEAR(q, touches ? 0 : others[k], 1e-9);
            assert_int_equal(at.stability, touches ? YK_STABILITY_UNSTABLE : YK_STABILITY_STABLE);
        }
        assert_true(yk_rest_equilibrium(rest, 0).is_higher_order != yk_rest_equilibrium(rest, 1).is_higher_order);
        yk_rest_free(rest);
        yk_model_free(model);
    }
}

// A weak torsional spring holds a pendulum in several turns; one that turns against gravity alone repeats itself.
static void only_loads_that_repeat_are_searched_whole(void **unused)
{
    (void)unused;
    static const char *const springs[] = {"", "springs: {k: {along: q, stiffness: 0.5 N*m, angle: 0}}\n"};
    for (int k = 0; k < 2; k++) {
        char text[600];
        snprintf(text, sizeof text,
                 "gravity: [0, -9.81]\nbodies:\n  ground: {points: {O: [0, 0]}}\n"
                 "  arm: {points: {O: [0, 0]}, mass: 2, center: [0.5, 0], inertia: 0.1}\n"
                 "joints: {O: {pin: [ground, arm], angle: q}}\n%sstart: {q: 0.3}\n",
                 springs[k]);
        YkModel *model;
        YkRest *rest = rest_of(text, &model);
        assert_int_equal(yk_rest_count(rest), 2);
        assert_true(yk_rest_is_wound(rest) == (k == 1) && yk_rest_is_complete(rest) == (k == 0));
        assert_false(yk_rest_equilibrium(rest, 0).is_higher_order);
        yk_rest_free(rest);
        yk_model_free(model);
    }
}

// A spring without a free length carries an arm in every pose, k a b = m g l: what is left of the forces is rounding,
// also where the arm hangs and no load has a lever, and where the spring pulls with a short one far from the pin.
static void a_balanced_arm_rests_anywhere(void **unused)
{
    (void)unused;
    static const double arms[][3] = {
        {0.17, 0.25, 0.3}, {15.4, 0.6, 1.6}, {2.4, 0.5, 0.0127}, {0.0047, 17.27, 6.59}, {0.093, 0.0071, 0.32}};
    for (size_t k = 0; k < sizeof arms / sizeof *arms; k++) {
        char text[600];
        snprintf(text, sizeof text,
                 "parameters: {a: %g m, b: %g m, l: %g m}\ngravity: [0, -9.81]\n"
                 "bodies:\n  ground: {points: {O: [0, 0], W: [0, a]}}\n"
                 "  arm: {points: {O: [0, 0], Q: [b, 0]}, mass: 2, center: [l, 0], inertia: 0.2 * l^2 * 1 kg}\n"
                 "joints: {O: {pin: [ground, arm], angle: q}}\n"
                 "springs: {k: {between: [ground.W, arm.Q], stiffness: 2 kg * 9.81 m/s^2 * l/(a*b), length: 0}}\n"
                 "start: {q: 0.3}\n",
                 arms[k][0], arms[k][1], arms[k][2]);
        YkModel *model;
        YkRest *rest = rest_of(text, &model);
        assert_int_equal(yk_rest_count(rest), 1);
        assert_int_equal(yk_rest_equilibrium(rest, 0).stability, YK_STABILITY_NEUTRAL);
        CHECK_NEAR(yk_rest_mode(rest, 0, 0).frequency, 0, 0);
        yk_rest_free(rest);
        yk_model_free(model);
    }
}

// An arm between two soft bumpers rests anywhere between them: where it touches one is a pose of these, however the
// bumper's torque grows.
static void the_ends_of_a_gap_are_no_others(void **unused)
{
    (void)unused;
    static const char *const torques[] = {"4 N*m * max(q, 0) + 2 N*m * min(q + 1, 0)",
                                          "4 N*m * max(q, 0)^3 + 2 N*m * min(q + 1, 0)^3", "4 N*m * max(q, 0)^2"};
    for (size_t k = 0; k < sizeof torques / sizeof *torques; k++) {
        for (int start = -1; start <= 1; start += 2) {
            char text[400];
            snprintf(text, sizeof text,
                     "bodies: {ground: {points: {O: [0, 0]}}, arm: {points: {O: [0, 0]}, mass: 1, inertia: 1}}\n"
                     "joints: {O: {pin: [ground, arm], angle: q}}\nsprings: {k: {along: q, torque: '%s'}}\n"
                     "start: {q: %g}\n",
                     torques[k], 0.7 * start);
            YkModel *model;
            YkRest *rest = rest_of(text, &model);
            assert_int_equal(yk_rest_count(rest), 1);
            assert_int_equal(yk_rest_equilibrium(rest, 0).stability, YK_STABILITY_NEUTRAL);
            assert_false(yk_rest_equilibrium(rest, 0).is_higher_order);
            yk_rest_free(rest);
            yk_model_free(model);
        }
    }
}

// A weight on a plane, at the end of a spring: it rests on a circle, and swings across it with w^2 = k/m.
static void a_curved_continuum_is_one_equilibrium(void **unused)
{
    (void)unused;
    YkModel *model;
    YkRest *rest =
        rest_of("bodies:\n  ground: {points: {O: [0, 0]}}\n  a: {}\n  b: {points: {B: [0, 0]}, mass: 2}\n"
                "joints:\n  A: {slide: [ground, a], along: x, distance: x}\n"
                "  B: {slide: [a, b], along: y, distance: y}\n"
                "springs: {k: {between: [ground.O, b.B], stiffness: 50, length: 1}}\nstart: {x: 0.7, y: 0.2}\n",
                &model);
    assert_int_equal(yk_rest_count(rest), 1);
    assert_int_equal(yk_rest_equilibrium(rest, 0).stability, YK_STABILITY_NEUTRAL);
    CHECK_NEAR(yk_rest_mode(rest, 0, 0).frequency, 0, 0);
    CHECK_NEAR(yk_rest_mode(rest, 0, 1).frequency, 5, 1e-6);
    yk_rest_free(rest);
    yk_model_free(model);
}

// A pendulum on a cart: it hangs or stands, wherever the cart is, w^2 = 2 g/l for two equal masses; on a cart that a
// very stiff spring holds, w^2 = g/l.
#define ON_A_CART(springs)                                                                                             \
    "gravity: [0, -10]\nbodies:\n  a: {points: {P: [0, 0]}, mass: 1}\n  b: {points: {P: [0, 0]}, mass: 1, center: "    \
    "[0, -1]}\njoints:\n  A: {slide: [ground, a], along: x, distance: x}\n  B: {pin: [a, b], at: P, angle: "           \
    "th}\n" springs

static void a_pendulum_on_a_cart_hangs_or_stands(void **unused)
{
    (void)unused;
    static const char *const texts[] = {ON_A_CART(""), ON_A_CART("springs: {k: {along: x, stiffness: 1e11}}\n"),
                                        ON_A_CART("springs: {k: {along: x, stiffness: 1e12}}\n")};
    for (size_t k = 0; k < 3; k++) {
        YkModel *model;
        YkRest *rest = rest_of(texts[k], &model);
        assert_int_equal(yk_rest_count(rest), 2);
        static const YkStability hangs[] = {YK_STABILITY_NEUTRAL, YK_STABILITY_STABLE, YK_STABILITY_STABLE};
        double square = k == 0 ? 20 : 10;
        assert_int_equal(yk_rest_equilibrium(rest, 0).stability, hangs[k]);
        CHECK_NEAR(yk_rest_mode(rest, 0, k == 0).frequency, sqrt(square), 1e-5);
        assert_int_equal(yk_rest_equilibrium(rest, 1).stability, YK_STABILITY_UNSTABLE);
        CHECK_NEAR(yk_rest_mode(rest, 1, 0).frequency, -sqrt(square), 1e-5);
        yk_rest_free(rest);
        yk_model_free(model);
    }
}

// Two shafts with a spring and a damper between them: they turn together without force, and against each other with
// 4 (1/2 + 1/3) = w^2.
static void shafts_turn_together_without_force(void **unused)
{
    (void)unused;
    YkModel *model;
    YkRest *rest =
        rest_of("bodies:\n  ground: {points: {O: [0, 0]}}\n  a: {points: {O: [0, 0]}, mass: 1, inertia: 2}\n"
                "  b: {points: {O: [0, 0]}, mass: 1, inertia: 3}\njoints:\n  A: {pin: [ground, a], at: O, angle: x}\n"
                "  B: {pin: [ground, b], at: O, angle: y}\n"
                "springs:\n  k: {along: x, torque: '4 N*m/rad * (x - y) + 0.3 N*m*s/rad * (x.rate - y.rate)'}\n"
                "  c: {along: y, torque: '4 N*m/rad * (y - x) + 0.3 N*m*s/rad * (y.rate - x.rate)'}\n",
                &model);
    assert_int_equal(yk_rest_count(rest), 1);
    assert_int_equal(yk_rest_equilibrium(rest, 0).stability, YK_STABILITY_NEUTRAL);
    CHECK_NEAR(yk_rest_mode(rest, 0, 0).frequency, 0, 0);
    CHECK_NEAR(yk_rest_mode(rest, 0, 1).frequency, sqrt(4 * (1.0 / 2 + 1.0 / 3)), 1e-9);
    int still = 0;
    for (size_t k = 0; k < 4; k++) {
        double real, imaginary;
        yk_rest_root(rest, 0, k, &real, &imaginary);
        still += real == 0 && imaginary == 0;
    }
    assert_int_equal(still, 2);
    yk_rest_free(rest);
    yk_model_free(model);
}

// A weak spring beside a strong damper, or beside a spring a million times as fast, still decides.
static void a_weak_spring_decides_beside_what_is_strong(void **unused)
{
    (void)unused;
    static const struct {
        const char *springs;
        YkStability stability;
    } cases[] = {{"{k: {along: x, stiffness: 1, damping: 1000}, l: {along: y, stiffness: 1}}", YK_STABILITY_STABLE},
                 {"{k: {along: x, stiffness: -1, damping: 1000}, l: {along: y, stiffness: 1}}", YK_STABILITY_UNSTABLE},
                 {"{k: {along: x, stiffness: 1e12}, l: {along: y, stiffness: 1}}", YK_STABILITY_STABLE},
                 {"{k: {along: x, stiffness: 1e12}, l: {along: y, stiffness: -1}}", YK_STABILITY_UNSTABLE},
                 {"{k: {along: x, stiffness: 1e12}, l: {along: y, damping: 1}}", YK_STABILITY_NEUTRAL}};
    for (size_t k = 0; k < sizeof cases / sizeof *cases; k++) {
        char text[600];
        snprintf(text, sizeof text,
                 "bodies: {a: {mass: 1}, b: {mass: 1}}\njoints:\n  A: {slide: [ground, a], along: x, distance: x}\n"
                 "  B: {slide: [ground, b], along: y, distance: y}\nsprings: %s\n",
                 cases[k].springs);
        YkModel *model;
        YkRest *rest = rest_of(text, &model);
        assert_int_equal(yk_rest_count(rest), 1);
        assert_int_equal(yk_rest_equilibrium(rest, 0).stability, cases[k].stability);
        yk_rest_free(rest);
        yk_model_free(model);
    }
}

// A bead on a light arm, held by a spring: where the arm has no length nothing resists its turning. That it has none at
// coordinates of 0 does not matter, nor that the machine starts there.
static void inertia_is_judged_where_the_machine_stands(void **unused)
{
    (void)unused;
    static const char *const starts[] = {"{q: -1, d: 1}", "{q: -1, d: 0}"};
    for (int k = 0; k < 2; k++) {
        char text[800];
        snprintf(text, sizeof text,
                 "gravity: [0, -10]\nbodies:\n  ground: {points: {O: [0, 0]}}\n  arm: {points: {O: [0, 0]}}\n"
                 "  bead: {points: {B: [0, 0]}, mass: 2}\njoints:\n  O: {pin: [ground, arm], angle: q}\n"
                 "  S: {slide: [arm, bead], along: x, distance: d}\n"
                 "springs: {k: {along: d, stiffness: 100, length: 1}}\nstart: %s\n",
                 starts[k]);
        YkModel *model;
        YkRest *rest = rest_of(text, &model);
        assert_int_equal(yk_rest_count(rest), 2); // hanging and standing
        bool hangs = false;
        for (size_t p = 0; p < 2; p++) {
            const YkState *s = yk_rest_state(rest, p);
            double q = yk_state_coordinate(s, 0).position, d = yk_state_coordinate(s, 1).position;
            CHECK_NEAR(cos(q), 0, 1e-9);
            CHECK_NEAR(100 * (d - 1), -20 * sin(q), 1e-7); // the spring carries the weight
            if (fabs(d - 1.2) > 1e-9) continue;
            hangs = true;
            assert_int_equal(yk_rest_equilibrium(rest, p).stability, YK_STABILITY_STABLE);
            CHECK_NEAR(yk_rest_mode(rest, p, 0).frequency, sqrt(10 / 1.2), 1e-7);
            CHECK_NEAR(yk_rest_mode(rest, p, 1).frequency, sqrt(50), 1e-7);
        }
        assert_true(hangs);
        yk_rest_free(rest);
        yk_model_free(model);
    }
}

static void a_freedom_that_never_has_inertia_is_refused(void **unused)
{
    (void)unused;
    const char *text =
        "gravity: [0, -10]\nbodies:\n  ground: {points: {O: [0, 0]}}\n  a: {points: {O: [0, 0]}, mass: 1}\n"
        "joints:\n  O: {pin: [ground, a], angle: q}\n";
    YkProblems *problems = yk_problems_new();
    YkModel *model = yk_model_parse(text, strlen(text), "t.yaml", NULL, problems);
    assert_null(yk_rest_find(model, NULL, problems));
    assert_int_equal(yk_problems_get(problems, 0)->code, YK_CODE_CANNOT_START);
    assert_non_null(strstr(yk_problems_get(problems, 0)->message, "no inertia resists `q`"));
    yk_model_free(model);
    yk_problems_free(problems);
}

// In a loop: small swings last as long as the mode says.
static void a_mode_is_how_it_swings(void **unused)
{
    (void)unused;
    YkProblems *problems = yk_problems_new();
    YkModel *model = yk_model_load(YOKE_ROOT "/examples/toggle.yaml", NULL, problems);
    YkRest *rest = yk_rest_find(model, NULL, problems);
    assert_non_null(rest);
    size_t stable = 0;
    while (stable < yk_rest_count(rest) && yk_rest_equilibrium(rest, stable).stability != YK_STABILITY_STABLE) stable++;
    assert_true(stable < yk_rest_count(rest));
    YkState *s = yk_rest_state(rest, stable);
    YkStartValue values[8];
    size_t n = yk_coordinate_count(yk_rest_mechanism(rest));
    for (size_t c = 0; c < n; c++)
        values[c] = (YkStartValue){yk_coordinate_info(yk_rest_mechanism(rest), c).name, false,
                                   yk_state_coordinate(s, c).position};
    values[n] = (YkStartValue){values[yk_rest_input(rest, 0)].coordinate, true, 1e-6};
    YkSimulationOptions options = run_options(1e-12);
    options.values = values;
    options.value_count = n + 1;
    YkSimulation *sim = yk_simulation_new(model, &options, problems);
    assert_non_null(sim);
    double period = 2 * acos(-1) / yk_rest_mode(rest, stable, 0).frequency;
    assert_int_equal(yk_simulation_advance(sim, period), YK_OK);
    YkMotion back = yk_state_coordinate(yk_simulation_state(sim), yk_rest_input(rest, 0));
    CHECK_NEAR(back.position, values[yk_rest_input(rest, 0)].value, 1e-10);
    CHECK_NEAR(back.velocity, 1e-6, 1e-10);
    yk_simulation_free(sim);
    yk_rest_free(rest);
    yk_model_free(model);
    yk_problems_free(problems);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_double_pendulum_rests_in_four_places),
        cmocka_unit_test(drags_damp_by_their_slope_at_rest),
        cmocka_unit_test(the_least_force_is_no_equilibrium),
        cmocka_unit_test(a_toggle_beside_its_limit_has_the_frequency_of_its_closed_form),
        cmocka_unit_test(drives_are_held_at_their_start),
        cmocka_unit_test(a_floating_plate_has_three_small_motions),
        cmocka_unit_test(every_equilibrium_keeps_its_mesh),
        cmocka_unit_test(a_damped_spring_has_its_roots),
        cmocka_unit_test(a_wheel_is_neutral),
        cmocka_unit_test(forces_that_grow_with_a_power_have_one_equilibrium_without_stiffness),
        cmocka_unit_test(forces_that_touch_zero_hold_nothing),
        cmocka_unit_test(only_loads_that_repeat_are_searched_whole),
        cmocka_unit_test(a_balanced_arm_rests_anywhere),
        cmocka_unit_test(the_ends_of_a_gap_are_no_others),
        cmocka_unit_test(a_curved_continuum_is_one_equilibrium),
        cmocka_unit_test(a_pendulum_on_a_cart_hangs_or_stands),
        cmocka_unit_test(shafts_turn_together_without_force),
        cmocka_unit_test(a_weak_spring_decides_beside_what_is_strong),
        cmocka_unit_test(inertia_is_judged_where_the_machine_stands),
        cmocka_unit_test(a_freedom_that_never_has_inertia_is_refused),
        cmocka_unit_test(a_mode_is_how_it_swings),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
