// Simulating, finding rest and setting efforts survive the failure of any one allocation, and leave nothing behind.
#include <yoke/yoke.h>
#include "interposed.h"

// Other coordinates on the way, stops, friction, formulas, a drive, a watch: most of what allocates.
static const char crank[] =
    "gravity: [0, -10]\nbodies:\n  ground: {points: {O: [0, 0]}}\n"
    "  crank: {points: {O: [0, 0], A: [0.1, 0]}, mass: 2, inertia: 0.01, center: [0, 0]}\n"
    "  rod: {points: {A: [0, 0], B: [0.3, 0]}, mass: 0.5, rod: [A, B]}\n  piston: {points: {B: [0, 0]}, mass: 1}\n"
    "  arm: {points: {O: [0, 0]}, mass: 1, inertia: 1}\n  hand: {points: {B: [0, 0]}, mass: 1, inertia: 1, center: "
    "[0.1, 0]}\n"
    "joints:\n  R: {slide: [ground, piston], along: x, distance: d}\n  O: {pin: [ground, crank], angle: q}\n"
    "  B: {pin: [piston, rod], angle: p}\n  A: {pin: [crank, rod]}\n"
    "  W: {pin: [ground, arm], angle: w}\n  H: {pin: [piston, hand], at: B, angle: h, friction: {viscous: 0.1 "
    "N*m*s/rad}}\n"
    "drives: {w: 1 rad/s * t}\nefforts: {q: 1 N*m * cos(q)}\nstops: {h: [-1, 1]}\n"
    "start: {d: 0.33, q: 60 deg, p: 160 deg, q.rate: 20 rad/s, h: 0}\n";

// A follower that flies, lands, and is taken off its cam by a stop.
static const char cam[] =
    "gravity: [0, -9.81]\n"
    "laws: {lift: {period: 360 deg, segments: [{formula: {to: 360 deg, s: 12 mm*(1 - cos(x))/2}}]}}\n"
    "cams: {heart: {cam: shaft, follower: tappet, law: lift, roller: 6 mm, base: 30 mm}}\n"
    "bodies: {shaft: {}, tappet: {mass: 0.3 kg}}\n"
    "joints: {K: {pin: [ground, shaft], angle: theta}, T: {slide: [ground, tappet], along: y, distance: s}}\n"
    "drives: {theta: 1 + 300 rad/s * t}\nstops: {s: {between: [1 mm, 1 m]}}\n"
    "springs: {k: {along: s, stiffness: 4000 N/m, length: -20 mm}}\n";

static YkModel *load(const char *text)
{
    YkModel *model = yk_model_parse(text, strlen(text), "test.yaml", NULL, NULL);
    assert_non_null(model);
    return model;
}

// What a host does: acts, copies, goes back to the start. Whatever fails, the simulation stays as it was.
static bool act(YkSimulation *sim)
{
    static unsigned char bytes[100000];
    int w = yk_coordinate_find(yk_state_mechanism(yk_simulation_state(sim)), "w");
    YkPull pull = {.body = 1, .force = {1, 0}};
    bool ok = yk_simulation_act_drive(sim, (size_t)w, 0.1) == YK_OK && yk_simulation_act_pull(sim, 0, &pull) == YK_OK &&
              yk_simulation_step(sim, 0.01) == YK_OK;
    YkSimulation *clone = ok ? yk_simulation_clone(sim) : NULL;
    yk_simulation_free(clone);
    size_t count = yk_simulation_save(sim, bytes, sizeof bytes);
    assert_true(count <= sizeof bytes);
    double before = yk_simulation_time(sim);
    if (ok && clone && yk_simulation_restore(sim, bytes, count) != YK_OK) ok = false;
    assert_true(yk_simulation_time(sim) == before);
    if (ok && clone && yk_simulation_reset(sim) != YK_OK) {
        assert_true(yk_simulation_time(sim) == before);
        ok = false;
    }
    return ok && clone;
}

static bool simulate(const YkModel *model)
{
    YkSimulationOptions o = yk_default_simulation_options();
    o.pulls = 1;
    YkProblems *problems = yk_problems_new();
    YkSimulation *sim = problems ? yk_simulation_new(model, &o, problems) : NULL;
    bool ok = sim && yk_simulation_set_effort(sim, "p", 0.1) == YK_OK;
    YkChannel channel = {.kind = YK_CHANNEL_COORDINATE};
    ok = ok && yk_simulation_watch(sim, "d", channel, 0.3, 0) == YK_OK;
    for (int row = 0; ok && row <= 5; row++) {
        ok = yk_simulation_advance(sim, 0.04 * row) == YK_OK;
        if (ok) yk_simulation_dynamics(sim);
    }
    ok = ok && act(sim);
    if (sim) yk_simulation_summary(sim);
    if (sim && !ok) yk_simulation_advance(sim, 1); // what failed stays failed
    yk_simulation_free(sim);
    yk_problems_free(problems);
    return ok;
}

static bool fly(const YkModel *model)
{
    YkSimulationOptions o = yk_default_simulation_options();
    o.tolerance = 1e-6;
    YkProblems *problems = yk_problems_new();
    YkSimulation *sim = problems ? yk_simulation_new(model, &o, problems) : NULL;
    YkStatus status = sim ? yk_simulation_advance(sim, 0.022) : YK_NO_MEMORY;
    if (countdown < 0 && status != YK_OK) assert_int_equal(status, YK_NO_MEMORY); // never another reason, nor an answer
    assert_true(status != YK_OK || yk_simulation_happening_count(sim) >= 4);
    yk_simulation_free(sim);
    yk_problems_free(problems);
    return status == YK_OK;
}

static bool rest(const YkModel *model)
{
    YkRestOptions o = yk_default_rest_options();
    o.starts = 1;
    YkProblems *problems = yk_problems_new();
    YkRest *found = problems ? yk_rest_find(model, &o, problems) : NULL;
    bool ok = found != NULL;
    yk_rest_free(found);
    yk_problems_free(problems);
    return ok;
}

static void fail_each(const char *text, bool (*use)(const YkModel *))
{
    YkModel *model = load(text);
    long before = live, survived = 0;
    assert_true(use(model));
    for (long k = 0;; k++) {
        countdown = k;
        bool ok = use(model);
        bool is_done = countdown >= 0; // nothing failed
        countdown = -1;
        assert_int_equal(live, before);
        if (is_done) break;
        survived += !ok;
    }
    assert_true(survived > 50);
    yk_model_free(model);
}

static void simulations_survive_every_failed_allocation(void **unused)
{
    (void)unused;
    skip_unless_interposed();
    fail_each(crank, simulate);
}

static void flights_survive_every_failed_allocation(void **unused)
{
    (void)unused;
    skip_unless_interposed();
    fail_each(cam, fly);
}

static void rests_survive_every_failed_allocation(void **unused)
{
    (void)unused;
    skip_unless_interposed();
    fail_each(crank, rest);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(simulations_survive_every_failed_allocation),
        cmocka_unit_test(flights_survive_every_failed_allocation),
        cmocka_unit_test(rests_survive_every_failed_allocation),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
