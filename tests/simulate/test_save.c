// Simulations saved and restored at random instants go on with the same bits as if they had never been saved; bytes
// that are not a simulation of this machine are refused.
#include "base/archive.h"
#include "../parallelogram.h"
#include "run.h"

#define SLIDE_FIRST                                                                                                    \
    "bodies:\n  ground: {points: {O: [0, 0]}}\n"                                                                       \
    "  crank: {points: {O: [0, 0], A: [0.1, 0]}, mass: 2, inertia: 0.01, center: [0, 0]}\n"                            \
    "  rod: {points: {A: [0, 0], B: [0.3, 0]}, mass: 0.5, rod: [A, B]}\n  piston: {points: {B: [0, 0]}, mass: 1}\n"    \
    "joints:\n  R: {slide: [ground, piston], along: x, distance: d}\n  O: {pin: [ground, crank], angle: q}\n"          \
    "  B: {pin: [piston, rod], angle: p}\n  A: {pin: [crank, rod]}\n"                                                  \
    "start: {d: 0.33, q: 60 deg, p: 160 deg, q.rate: 20 rad/s}\n"
#define BUTTERFLY                                                                                                      \
    "bodies:\n"                                                                                                        \
    "  ground: {points: {P: [3, 0], L: [0, 0], R: [7, 0]}}\n"                                                          \
    "  left: {points: {L: [0, 0], LC: [0.4, 1.5]}, mass: 1, inertia: 0.5, center: [0, 0]}\n"                           \
    "  right: {points: {R: [7, 0], RD: [6.6, 2]}, mass: 1, inertia: 0.5, center: [7, 0]}\n"                            \
    "  wing: {points: {P: [3, 0], PC: [2, 1.5], PD: [4.5, 1.2]}, mass: 1, inertia: 0.5, center: [3, 0]}\n"             \
    "  barC: {points: {PC: [2, 1.5], CW: [1.8, 2.8]}, mass: 1, inertia: 0.5, center: [2, 1.5]}\n"                      \
    "  barD: {points: {PD: [4.5, 1.2], DW: [4.9, 2.9]}, mass: 1, inertia: 0.5, center: [4.5, 1.2]}\n"                  \
    "  wingC: {points: {LC: [0.4, 1.5], CW: [1.8, 2.8], T: [3.2, 4]}, mass: 1, inertia: 0.5, center: [0.4, 1.5]}\n"    \
    "  wingD: {points: {RD: [6.6, 2], DW: [4.9, 2.9], T: [3.2, 4]}, mass: 1, inertia: 0.5, center: [6.6, 2]}\n"        \
    "joints:\n"                                                                                                        \
    "  L: {pin: [ground, left], angle: lambda}\n"                                                                      \
    "  LC: {pin: [left, wingC], angle: gamma}\n"                                                                       \
    "  R: {pin: [ground, right], angle: rho}\n"                                                                        \
    "  RD: {pin: [right, wingD], angle: delta}\n"                                                                      \
    "  P: {pin: [ground, wing], angle: omega}\n"                                                                       \
    "  PC: {pin: [wing, barC], angle: sigma}\n"                                                                        \
    "  PD: {pin: [wing, barD], angle: tau}\n"                                                                          \
    "  CW: {pin: [barC, wingC]}\n"                                                                                     \
    "  DW: {pin: [barD, wingD]}\n"                                                                                     \
    "  T: {pin: [wingC, wingD]}\n"                                                                                     \
    "start: {lambda: 0, lambda.rate: 0.1 rad/s, gamma: 0, rho: 0, delta: 0, omega: 0, sigma: 0, tau: 0}\n"
#define BLOCK                                                                                                          \
    "bodies:\n  ground: {points: {O: [0, 0]}}\n  block: {points: {P: [0, 0]}, mass: 2}\n"                              \
    "joints:\n  R: {slide: [ground, block], along: x, distance: x}\n"

// Two discs, which stand alike.
#define DISCS                                                                                                          \
    "laws:\n  slow: {table: [[0, 0], [1, 1]]}\n  fast: {table: [[0, 0], [1, 2]]}\n"                                    \
    "bodies:\n  ground: {points: {A: [0, 0], B: [1, 0]}}\n"                                                            \
    "  p: {points: {A: [0, 0], P: [0.1, 0]}, mass: 1, inertia: 0.3, center: [0, 0]}\n"                                 \
    "  q: {points: {B: [0, 0], P: [0.1, 0]}, mass: 1, inertia: 0.3, center: [0, 0]}\n"                                 \
    "joints:\n  A: {pin: [ground, p], angle: x}\n  B: {pin: [ground, q], angle: y}\nstart: {x: 0}\n"
#define CAM                                                                                                            \
    "laws:\n  up: {period: 360 deg, segments: [{rise: {to: 180 deg, by: 0.02, law: cycloidal}},\n"                     \
    "    {fall: {to: 360 deg, by: 0.02, law: cycloidal}}]}\n"                                                          \
    "bodies: {shaft: {inertia: 0.1}, tappet: {mass: 0.3}}\njoints:\n  K: {pin: [ground, shaft], angle: x}\n"           \
    "  T: {slide: [ground, tappet], along: y, distance: s}\nstart: {x: 0}\n"

// Everything that a host can ask must be equal.
static void check_same(YkSimulation *a, YkSimulation *b)
{
    const YkMechanism *mech = yk_state_mechanism(yk_simulation_state(a));
    assert_true(yk_simulation_time(a) == yk_simulation_time(b));
    for (size_t c = 0; c < yk_coordinate_count(mech); c++) {
        YkMotion x = yk_state_coordinate(yk_simulation_state(a), c), y = yk_state_coordinate(yk_simulation_state(b), c);
        assert_memory_equal(&x, &y, sizeof x);
    }
    for (size_t k = 0; k < yk_simulation_work_count(a); k++)
        assert_true(yk_simulation_work(a, k) == yk_simulation_work(b, k));
    size_t count = yk_simulation_happening_count(a);
    assert_int_equal(count, yk_simulation_happening_count(b));
    for (size_t k = 0; k < count; k++) {
        YkHappening x = yk_simulation_happening(a, k), y = yk_simulation_happening(b, k);
        assert_true(x.kind == y.kind && x.time == y.time && x.value == y.value && strcmp(x.name, y.name) == 0);
    }
    YkSimulationSummary s = yk_simulation_summary(a), t = yk_simulation_summary(b);
    assert_true(s.steps == t.steps && s.evaluations == t.evaluations && s.recoordinations == t.recoordinations);
    assert_true(s.energy_error == t.energy_error && s.energy_end == t.energy_end);
}

static void push_at_random(YkSimulation *sim, uint64_t *seed)
{
    size_t bodies = yk_model_body_count(yk_mechanism_model(yk_state_mechanism(yk_simulation_state(sim))));
    YkPull pull = {.body = 1 + (size_t)(check_random(seed) % (bodies - 1)), .stiffness = 2, .damping = 0.1};
    for (int k = 0; k < 2; k++) pull.target[k] = check_uniform(seed, -1, 1);
    assert_int_equal(yk_simulation_act_pull(sim, 0, check_random(seed) % 4 ? &pull : NULL), YK_OK);
}

// sim goes on untouched; `fresh` was restored from it, `clone` cloned.
static void save_at_random(Run *run, Run *fresh, double span, uint64_t *seed)
{
    double t = 0;
    for (int k = 0; k < 6; k++) {
        t += check_uniform(seed, 0, 0.3) * span;
        if (run->sim && check_random(seed) % 2 == 0 && k > 0) push_at_random(run->sim, seed);
        assert_int_equal(yk_simulation_advance(run->sim, t), YK_OK);
        if (check_random(seed) % 3 == 0) push_at_random(run->sim, seed); // set, and not taken yet
        size_t count = yk_simulation_save(run->sim, NULL, 0);
        unsigned char *bytes = malloc(count);
        assert_int_equal(yk_simulation_save(run->sim, bytes, count - 1), count);
        assert_int_equal(yk_simulation_save(run->sim, bytes, count), count);
        assert_int_equal(yk_simulation_restore(fresh->sim, bytes, count), YK_OK);
        free(bytes);
        YkSimulation *clone = yk_simulation_clone(run->sim);
        assert_non_null(clone);
        check_same(run->sim, fresh->sim);
        double ahead = t;
        for (int row = 0; row < 4; row++) {
            ahead += check_uniform(seed, 0, 0.1) * span;
            assert_int_equal(yk_simulation_advance(clone, ahead), YK_OK);
            assert_int_equal(yk_simulation_advance(fresh->sim, ahead), YK_OK);
            assert_int_equal(yk_simulation_advance(run->sim, ahead), YK_OK);
            check_same(run->sim, fresh->sim);
            check_same(run->sim, clone);
        }
        YkChannel effort = {.kind = YK_CHANNEL_FORCE_X};
        YkSimulation *third = yk_simulation_clone(fresh->sim); // forces before and after a copy
        double x = yk_simulation_channel(fresh->sim, effort), y = yk_simulation_channel(third, effort);
        assert_true(x == y || (isnan(x) && isnan(y)));
        yk_simulation_free(third);
        yk_simulation_free(clone);
        t = ahead;
    }
}

static void check_machine(const char *example, const char *text, double span)
{
    uint64_t seed = 20260;
    for (int k = 0; k < 3 * (int)check_cases(2); k++) { // each integrator
        YkSimulationOptions options = run_options(1e-8);
        options.integrator = (YkIntegrator)(k % 3);
        options.step = span * 1e-3;
        options.horizon = k % 2 ? 100 * span : 0;
        options.pulls = 1;
        Run run = text ? run_of_text(text, options) : run_of_example(example, options);
        Run fresh = text ? run_of_text(text, options) : run_of_example(example, options);
        if (k % 4 == 1) yk_simulation_advance(fresh.sim, 0.1 * span); // it need not stand at the start
        save_at_random(&run, &fresh, span, &seed);
        run_free(&run);
        run_free(&fresh);
    }
}

static void what_is_restored_goes_on_with_the_same_bits(void **unused)
{
    (void)unused;
    check_machine("bouncing-block", NULL, 1);        // stops
    check_machine("rough-block", NULL, 0.5);         // dry friction
    check_machine("shaking-table", NULL, 1);         // ... under a drive
    check_machine("crank-press", NULL, 0.3);         // stops of a linkage
    check_machine("double-pendulum", NULL, 1);       // an open tree
    check_machine("spring-slider-crank", NULL, 0.5); // a loop
    check_machine("butterfly", BUTTERFLY, 0.5);      // a group
    check_machine("andrews", NULL, 0.003);           // loops within loops
    check_machine("gas-engine", NULL, 0.3);          // laws and springs
    check_machine("slides", SLIDE_FIRST, 0.5);       // other coordinates on the way
}

// Not in the fixed steps of RK4, which does not look for change points.
static void change_points_are_passed_after_a_restore(void **unused)
{
    (void)unused;
    uint64_t seed = 7;
    for (int k = 0; k < 20; k++) {
        YkSimulationOptions options = run_options(1e-9);
        options.horizon = k % 2 ? 100 : 0;
        Run run = run_of_example("n-four-bar", options), fresh = run_of_example("n-four-bar", options);
        double t = check_uniform(&seed, 0, 3);
        assert_int_equal(yk_simulation_advance(run.sim, t), YK_OK);
        YkSimulation *clone = yk_simulation_clone(run.sim);
        for (int row = 0; row < 10; row++) {
            assert_int_equal(yk_simulation_advance(run.sim, t += 0.2), YK_OK);
            assert_int_equal(yk_simulation_advance(clone, t), YK_OK);
            check_same(run.sim, clone);
        }
        assert_true(yk_simulation_happening_count(clone) > 0);
        yk_simulation_free(clone);
        run_free(&run);
        run_free(&fresh);
    }
}

// Exactly there only the motion that led to it tells on which branch the machine goes on.
static void a_driven_machine_saved_at_a_change_point_goes_on(void **unused)
{
    (void)unused;
    static const char *const laws[] = {"1 - t/(1 s)", "(1 - t/(1 s))^2", "(1 - t/(1 s))^3",
                                       "(1 - t/(1 s))*(t/(1 s) - 2)"};
    static const double times[] = {0.75, 1, 1.5, 2, 2.25, 3};
    for (size_t k = 0; k < sizeof laws / sizeof *laws; k++) {
        char text[1024];
        snprintf(text, sizeof text,
                 "bodies:\n"
                 "  ground:  {points: {O2: [0, 0], O4: [4, 0]}}\n"
                 "  crank:   {points: {O2: [0, 0], A: [2, 0]}, mass: 1, inertia: 1, center: [0, 0]}\n"
                 "  coupler: {points: {A: [0, 0], B: [4, 0]}}\n"
                 "  rocker:  {points: {O4: [0, 0], B: [2, 0]}}\n" PARALLELOGRAM_JOINTS
                 "drives: {theta2: '1 rad*(%s)'}\nstart: {theta3: %d rad, theta4: %d rad}\n",
                 laws[k], k == 3 ? 2 : -1, k == 3 ? -2 : 1);
        Run run = run_of_text(text, run_options(1e-9));
        YkSimulation *clone = yk_simulation_clone(run.sim);
        for (size_t row = 0; row < sizeof times / sizeof *times; row++) {
            assert_int_equal(yk_simulation_advance(run.sim, times[row]), YK_OK);
            assert_int_equal(yk_simulation_advance(clone, times[row]), YK_OK);
            check_same(run.sim, clone);
            CHECK_NEAR(run_value(&run, "theta4"), run_value(&run, "theta2"), 1e-7);
            yk_simulation_free(clone);
            clone = yk_simulation_clone(run.sim);
            assert_non_null(clone);
        }
        yk_simulation_free(clone);
        run_free(&run);
    }
}

static bool brake(void *context, YkSimulation *sim, double time)
{
    (void)time;
    ++*(size_t *)context;
    YkMotion x = yk_state_coordinate(yk_simulation_state(sim), 0);
    return yk_simulation_act_effort(sim, 0, 1 - 3 * x.position - x.velocity) == YK_OK;
}

static void a_control_goes_on_after_a_restore(void **unused)
{
    (void)unused;
    size_t calls = 0, other_calls = 0;
    Run run = run_of_text(BLOCK, run_options(1e-9)), fresh = run_of_text(BLOCK, run_options(1e-9));
    assert_int_equal(yk_simulation_set_effort(run.sim, "x", 0), YK_OK);
    assert_int_equal(yk_simulation_set_control(run.sim, 0.03, brake, &calls), YK_OK);
    assert_int_equal(yk_simulation_set_control(fresh.sim, 1, brake, &other_calls), YK_OK);
    assert_int_equal(yk_simulation_advance(run.sim, 0.5), YK_OK);
    unsigned char bytes[20000];
    size_t count = yk_simulation_save(run.sim, bytes, sizeof bytes), before = calls;
    assert_true(count <= sizeof bytes);
    assert_int_equal(yk_simulation_restore(fresh.sim, bytes, count), YK_OK);
    assert_int_equal(yk_simulation_advance(run.sim, 2), YK_OK);
    assert_int_equal(yk_simulation_advance(fresh.sim, 2), YK_OK);
    check_same(run.sim, fresh.sim);
    assert_int_equal(calls - before, other_calls);
    assert_int_equal(yk_simulation_sample_count(run.sim), yk_simulation_sample_count(fresh.sim));
    run_free(&run);
    run_free(&fresh);
}

static void damaged_bytes_are_refused(void **unused)
{
    (void)unused;
    Run run = run_of_example("bouncing-block", run_options(1e-9)),
        fresh = run_of_example("bouncing-block", run_options(1e-9));
    assert_int_equal(yk_simulation_advance(run.sim, 0.7), YK_OK);
    unsigned char bytes[20000];
    size_t count = yk_simulation_save(run.sim, bytes, sizeof bytes);
    assert_true(count > 1000 && count < sizeof bytes);
    for (size_t k = 0; k < count; k++) {
        unsigned char flip = (unsigned char)(1u << k % 8);
        bytes[k] ^= flip;
        assert_int_equal(yk_simulation_restore(fresh.sim, bytes, count), YK_BAD_ARGUMENT);
        bytes[k] ^= flip;
        assert_int_equal(yk_simulation_restore(fresh.sim, bytes, k), YK_BAD_ARGUMENT); // cut off
    }
    assert_true(yk_simulation_time(fresh.sim) == 0); // nothing has changed
    assert_int_equal(yk_simulation_restore(fresh.sim, bytes, count), YK_OK);
    check_same(run.sim, fresh.sim);
    run_free(&run);
    run_free(&fresh);
}

// Any bytes with a sum that fits: refused or taken, never read beyond.
static void forged_bytes_do_no_harm(void **unused)
{
    (void)unused;
    uint64_t seed = 3;
    Run run = run_of_example("rough-block", run_options(1e-9)),
        fresh = run_of_example("rough-block", run_options(1e-9));
    assert_int_equal(yk_simulation_advance(run.sim, 0.2), YK_OK);
    unsigned char bytes[20000], forged[20000];
    size_t count = yk_simulation_save(run.sim, bytes, sizeof bytes), refused = 0;
    assert_true(count < sizeof bytes);
    for (size_t k = 32; k + 8 < count; k++) {
        memcpy(forged, bytes, count);
        forged[k] = (unsigned char)check_random(&seed);
        uint64_t sum = yk_archive_sum(forged, count - 8);
        for (int j = 0; j < 8; j++) forged[count - 8 + (size_t)j] = (unsigned char)(sum >> 8 * j);
        YkStatus status = yk_simulation_restore(fresh.sim, forged, count);
        refused += status != YK_OK;
        assert_true(status == YK_OK || status == YK_BAD_ARGUMENT || status == YK_NO_MEMORY);
    }
    assert_true(refused > 100 && refused < count);
    run_free(&run);
    run_free(&fresh);
}

static void another_machine_is_refused(void **unused)
{
    (void)unused;
    Run run = run_of_text(BLOCK, run_options(1e-9));
    size_t count = yk_simulation_save(run.sim, NULL, 0);
    unsigned char *bytes = malloc(count);
    yk_simulation_save(run.sim, bytes, count);
    const char *others[] = {
        BLOCK "gravity: [1, 0]\n",
        BLOCK "efforts: {x: 1 N}\n",
        BLOCK "stops: {x: [-1, 2]}\n",
        SLIDE_FIRST,
    };
    for (size_t k = 0; k < sizeof others / sizeof *others; k++) {
        Run other = run_of_text(others[k], run_options(1e-9));
        assert_int_equal(yk_simulation_restore(other.sim, bytes, count), YK_BAD_MODEL);
        run_free(&other);
    }
    free(bytes);
    run_free(&run);
}

// They differ in one entry each, and often in no number.
static void a_machine_that_differs_in_anything_is_refused(void **unused)
{
    (void)unused;
    static const char *const pairs[][2] = {
        {DISCS "belts: {b: {between: [p, q], radii: [0.1, 0.1]}}\n",
         DISCS "belts: {b: {between: [p, q], radii: [0.1, 0.1], crossed: true}}\n"},
        {DISCS "belts: {b: {between: [p, q], radii: [0.1, 0.1]}}\n",
         DISCS "belts: {b: {between: [q, p], radii: [0.1, 0.1]}}\n"},
        {DISCS "gears: {m: {mesh: [p, q], teeth: [20, 20]}}\n", DISCS "gears: {m: {mesh: [q, p], teeth: [20, 20]}}\n"},
        {DISCS "stops: {x: [-1, 2]}\n", DISCS "stops: {y: [-1, 2]}\n"},
        {DISCS "springs: {s: {along: x, stiffness: 1}}\n", DISCS "springs: {s: {along: y, stiffness: 1}}\n"},
        {DISCS "springs: {s: {between: [ground.A, p.P], stiffness: 1}}\n",
         DISCS "springs: {s: {between: [ground.A, q.P], stiffness: 1}}\n"},
        {DISCS "forces: {f: {body: p, at: P, value: [0, 1]}}\n",
         DISCS "forces: {f: {body: p, at: P, value: [0, 1], axes: body}}\n"},
        {DISCS "efforts: {x: {law: slow, of: t * 1 rad/s}}\n", DISCS "efforts: {x: {law: fast, of: t * 1 rad/s}}\n"},
        {DISCS "drives: {x: {law: slow, of: t}}\n", DISCS "drives: {x: {law: fast, of: t}}\n"},
        {CAM "cams: {c: {cam: shaft, follower: tappet, law: up, face: knife, base: 0.1}}\n",
         CAM "cams: {c: {cam: shaft, follower: tappet, law: up, face: flat, base: 0.1}}\n"},
        {BLOCK, "bodies:\n  ground: {points: {O: [0, 0]}}\n  block: {points: {P: [0, 0]}, mass: 2}\n"
                "joints:\n  R: {slide: [ground, block], along: x, distance: y}\n"}, // names alone
        {BLOCK, "bodies:\n  ground: {points: {O: [0, 0]}}\n  blocs: {points: {P: [0, 0]}, mass: 2}\n"
                "joints:\n  R: {slide: [ground, blocs], along: x, distance: x}\n"},
        {BLOCK, "bodies:\n  ground: {points: {O: [0, 0]}}\n  clock: {points: {P: [0, 0]}, mass: 2}\n"
                "joints:\n  R: {slide: [ground, clock], along: x, distance: x}\n"},
        {BLOCK, "bodies:\n  ground: {points: {O: [0, 0]}}\n  block: {points: {P: [0, 1]}, mass: 2}\n"
                "joints:\n  R: {slide: [ground, block], along: x, distance: x}\n"},
    };
    for (size_t k = 0; k < sizeof pairs / sizeof *pairs; k++) {
        Run run = run_of_text(pairs[k][0], run_options(1e-9)), other = run_of_text(pairs[k][1], run_options(1e-9));
        unsigned char bytes[20000];
        size_t count = yk_simulation_save(run.sim, bytes, sizeof bytes);
        assert_true(count <= sizeof bytes);
        YkStatus status = yk_simulation_restore(other.sim, bytes, count);
        if (status != YK_BAD_MODEL) print_error("taken:\n%s... by\n%s", pairs[k][0], pairs[k][1]);
        assert_int_equal(status, YK_BAD_MODEL);
        assert_int_equal(yk_simulation_restore(run.sim, bytes, count), YK_OK);
        run_free(&run);
        run_free(&other);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_is_restored_goes_on_with_the_same_bits),
        cmocka_unit_test(change_points_are_passed_after_a_restore),
        cmocka_unit_test(a_driven_machine_saved_at_a_change_point_goes_on),
        cmocka_unit_test(a_control_goes_on_after_a_restore),
        cmocka_unit_test(damaged_bytes_are_refused),
        cmocka_unit_test(forged_bytes_do_no_harm),
        cmocka_unit_test(another_machine_is_refused),
        cmocka_unit_test(a_machine_that_differs_in_anything_is_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
