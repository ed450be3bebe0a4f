// Acts of a host on a machine while it moves, against closed forms and against files that say the same.
#include "run.h"

#define BLOCK                                                                                                          \
    "bodies:\n  ground: {points: {O: [0, 0]}}\n  block: {points: {P: [0.1, 0.05]}, mass: 2}\n"                         \
    "joints:\n  R: {slide: [ground, block], along: x, distance: x}\n"
#define ARMS                                                                                                           \
    "gravity: [0, -9.81]\nbodies:\n  ground: {points: {O: [0, 0], S: [1, 0.5]}}\n"                                     \
    "  upper: {points: {O: [0, 0], A: [0.4, 0]}, mass: 1, rod: [O, A]}\n"                                              \
    "  lower: {points: {A: [0, 0], T: [0.3, 0]}, mass: 1, rod: [A, T]}\n"                                              \
    "joints:\n  O: {pin: [ground, upper], angle: a}\n  A: {pin: [upper, lower], angle: b}\n"                           \
    "start: {a: 20 deg, b: -60 deg}\n"

static size_t coordinate(const Run *run, const char *name)
{
    size_t c = yk_coordinate_find(yk_state_mechanism(yk_simulation_state(run->sim)), name);
    assert_true(c != YK_NOT_FOUND);
    return c;
}

static double work_of(const Run *run, const char *name)
{
    for (size_t k = 0; k < yk_simulation_work_count(run->sim); k++)
        if (strcmp(yk_simulation_work_name(run->sim, k), name) == 0) return yk_simulation_work(run->sim, k);
    fail_msg("no work of %s", name);
    return 0;
}

static YkSimulationOptions pulled(double horizon)
{
    YkSimulationOptions options = run_options(1e-11);
    options.pulls = 2;
    options.horizon = horizon;
    return options;
}

// m x'' = k (c - x) - d x': from x, v after a time t.
static void oscillate(double m, double k, double d, double c, double t, double *x, double *v)
{
    double s = d / (2 * m), w = sqrt(k / m - s * s), u = *x - c, b = (*v + s * u) / w, e = exp(-s * t);
    *x = c + e * (u * cos(w * t) + b * sin(w * t));
    *v = -s * (*x - c) + e * w * (b * cos(w * t) - u * sin(w * t));
}

// The mouse jumps in the midst of a step that reaches far beyond.
static void a_pull_is_a_damped_spring_to_a_target(void **unused)
{
    (void)unused;
    static const double targets[] = {0.6, -0.3, 0.2, 0.2, 1};
    Run run = run_of_text(BLOCK, pulled(100));
    double x = 0, v = 0;
    YkPull pull = {.body = 1, .place = {0.1, 0.05}, .stiffness = 50, .damping = 3};
    for (size_t k = 0; k < sizeof targets / sizeof *targets; k++) {
        pull.target[0] = targets[k];
        pull.target[1] = 7; // across the slide: no matter
        assert_int_equal(yk_simulation_act_pull(run.sim, 1, &pull), YK_OK);
        assert_int_equal(yk_simulation_step(run.sim, 0.137), YK_OK);
        oscillate(2, 50, 3, targets[k] - 0.1, 0.137, &x, &v);
        CHECK_NEAR(run_value(&run, "x"), x, 1e-10);
        CHECK_NEAR(run_value(&run, "x.rate"), v, 1e-9);
        CHECK_NEAR(work_of(&run, "pulls"), v * v, 1e-9);
    }
    assert_int_equal(yk_simulation_act_pull(run.sim, 1, NULL), YK_OK);
    assert_int_equal(yk_simulation_step(run.sim, 2), YK_OK);
    CHECK_NEAR(run_value(&run, "x"), x + 2 * v, 1e-9);
    assert_true(yk_simulation_summary(run.sim).energy_error < 1e-10);
    run_free(&run);
}

// A spring of the file with no free length does the same; the reactions are the same too.
static void a_pull_is_the_spring_of_a_file(void **unused)
{
    (void)unused;
    const char *spring = ARMS "springs:\n  s: {between: [ground.S, lower.T], stiffness: 40 N/m, length: 0}\n";
    Run run = run_of_text(ARMS, pulled(0)), other = run_of_text(spring, run_options(1e-11));
    YkPull pull = {.body = 2, .place = {0.3, 0}, .target = {1, 0.5}, .stiffness = 40};
    assert_int_equal(yk_simulation_act_pull(run.sim, 0, &pull), YK_OK);
    for (int k = 0; k <= 20; k++) {
        assert_int_equal(yk_simulation_advance(run.sim, 0.1 * k), YK_OK);
        assert_int_equal(yk_simulation_advance(other.sim, 0.1 * k), YK_OK);
        static const char *const names[] = {"a", "b", "a.rate", "b.rate", "a.accel", "O.force.x", "A.force.y"};
        for (size_t j = 0; j < sizeof names / sizeof *names; j++)
            CHECK_NEAR(run_value(&run, names[j]), run_value(&other, names[j]), 1e-6);
    }
    assert_true(yk_simulation_summary(run.sim).energy_error < 1e-9);
    run_free(&run);
    run_free(&other);
}

// On a closed machine: the force on the rod's point is the file's force, and what it does is its work.
static void a_force_on_a_point_is_the_force_of_a_file(void **unused)
{
    (void)unused;
    const char *machine =
        "bodies:\n  ground: {points: {O: [0, 0]}}\n"
        "  crank: {points: {O: [0, 0], A: [0.1, 0]}, mass: 2, inertia: 0.01, center: [0, 0]}\n"
        "  rod: {points: {A: [0, 0], C: [0.1, 0.1], B: [0.3, 0]}, mass: 0.5, rod: [A, B]}\n"
        "  piston: {points: {B: [0, 0]}, mass: 1}\n"
        "joints:\n  O: {pin: [ground, crank], angle: q}\n  A: {pin: [crank, rod]}\n  B: {pin: [rod, piston]}\n"
        "  R: {slide: [ground, piston], along: x, distance: d}\nstart: {q: 60 deg, d: 0.3}\n";
    char with_force[2000];
    snprintf(with_force, sizeof with_force, "%sforces:\n  f: {body: rod, at: C, value: [3 N, -2 N]}\n", machine);
    Run run = run_of_text(machine, pulled(0)), other = run_of_text(with_force, run_options(1e-11));
    YkPull pull = {.body = 2, .place = {0.1, 0.1}, .force = {3, -2}};
    assert_int_equal(yk_simulation_act_pull(run.sim, 0, &pull), YK_OK);
    for (int k = 0; k <= 20; k++) {
        assert_int_equal(yk_simulation_advance(run.sim, 0.1 * k), YK_OK);
        assert_int_equal(yk_simulation_advance(other.sim, 0.1 * k), YK_OK);
        CHECK_NEAR(run_value(&run, "q"), run_value(&other, "q"), 1e-6);
        CHECK_NEAR(run_value(&run, "q.rate"), run_value(&other, "q.rate"), 1e-5);
        CHECK_NEAR(work_of(&run, "pulls"), work_of(&other, "f"), 1e-7);
    }
    assert_true(yk_simulation_summary(run.sim).energy_error < 1e-8);
    run_free(&run);
    run_free(&other);
}

static void efforts_are_set_while_it_moves(void **unused)
{
    (void)unused;
    Run run = run_of_text(BLOCK, pulled(100));
    assert_int_equal(yk_simulation_set_effort(run.sim, "x", 0), YK_OK);
    double x = 0, v = 0, force[] = {4, -6, 0, 10};
    for (size_t k = 0; k < 4; k++) {
        assert_int_equal(yk_simulation_act_effort(run.sim, coordinate(&run, "x"), force[k]), YK_OK);
        assert_int_equal(yk_simulation_step(run.sim, 0.3), YK_OK);
        x += 0.3 * v + 0.5 * 0.09 * force[k] / 2;
        v += 0.3 * force[k] / 2;
        CHECK_NEAR(run_value(&run, "x"), x, 1e-12);
        CHECK_NEAR(run_value(&run, "x.rate"), v, 1e-12);
    }
    assert_int_equal(yk_simulation_act_effort(run.sim, 99, 1), YK_BAD_ARGUMENT);
    assert_int_equal(yk_simulation_act_effort(run.sim, 0, (double)NAN), YK_BAD_ARGUMENT);
    run_free(&run);
}

#define CART                                                                                                           \
    "gravity: [0, -9.81]\nbodies:\n  ground: {points: {O: [0, 0]}}\n  cart: {points: {P: [0, 0]}, mass: 1}\n"          \
    "  pole: {points: {P: [0, 0], T: [0.5, 0]}, mass: 1, rod: [P, T]}\n"                                               \
    "joints:\n  R: {slide: [ground, cart], along: x, distance: x}\n  P: {pin: [cart, pole], angle: p}\n"               \
    "start: {p: 80 deg}\n"

// A drive that the host takes over goes on as a file's parabola does.
static void a_drive_is_taken_over(void **unused)
{
    (void)unused;
    YkSimulationOptions options = run_options(1e-11), later = run_options(1e-11);
    options.horizon = 10;
    Run run = run_of_text(CART "drives: {x: 0.2 m/s * t}\n", options);
    assert_int_equal(yk_simulation_advance(run.sim, 0.5), YK_OK);
    double p = run_value(&run, "p"), rate = run_value(&run, "p.rate");
    assert_int_equal(yk_simulation_act_drive(run.sim, coordinate(&run, "x"), -1.5), YK_OK);
    assert_int_equal(yk_simulation_act_drive(run.sim, coordinate(&run, "p"), 1), YK_BAD_ARGUMENT); // not driven
    YkStartValue values[] = {{"p", false, p}, {"p.rate", true, rate}};
    values[1].coordinate = "p";
    later.values = values;
    later.value_count = 2;
    Run other = run_of_text(CART "drives: {x: 0.1 m + 0.2 m/s * t - 0.75 m/s^2 * t^2}\n", later);
    for (int k = 0; k <= 10; k++) {
        assert_int_equal(yk_simulation_advance(run.sim, 0.5 + 0.1 * k), YK_OK);
        assert_int_equal(yk_simulation_advance(other.sim, 0.1 * k), YK_OK);
        CHECK_NEAR(run_value(&run, "x"), run_value(&other, "x"), 1e-14);
        CHECK_NEAR(run_value(&run, "x.rate"), run_value(&other, "x.rate"), 1e-14);
        CHECK_NEAR(run_value(&run, "p"), run_value(&other, "p"), 1e-7);
        if (k > 0) CHECK_NEAR(run_value(&run, "x.effort"), run_value(&other, "x.effort"), 1e-5);
    }
    assert_true(yk_simulation_summary(run.sim).energy_error < 1e-8);
    run_free(&run);
    run_free(&other);
}

// --- control --------------------------------------------------------------------------------------

typedef struct Deadbeat {
    size_t calls, last;
    double period, mass;
    double times[100];
} Deadbeat;

// A mass that is held by its effort from sample to sample stands still after two of them.
static bool stop_in_two_samples(void *context, YkSimulation *sim, double time)
{
    Deadbeat *d = context;
    double T = d->period;
    YkMotion x = yk_state_coordinate(yk_simulation_state(sim), 0);
    assert_true(time == yk_simulation_time(sim));
    assert_true(yk_state_time(yk_simulation_state(sim)) == time);
    assert_int_equal(yk_simulation_advance(sim, time + 1), YK_BAD_ARGUMENT);
    d->times[d->calls++] = time;
    assert_int_equal(yk_simulation_act_effort(sim, 0, -d->mass * (x.position / (T * T) + 1.5 * x.velocity / T)), YK_OK);
    return d->calls < d->last;
}

static void a_control_samples_exactly_and_holds(void **unused)
{
    (void)unused;
    YkStartValue values[] = {{"x", false, 0.7}, {"x", true, -2}};
    YkSimulationOptions options = run_options(1e-11);
    options.horizon = 50;
    options.start = 0.3;
    options.values = values;
    options.value_count = 2;
    Run run = run_of_text(BLOCK, options);
    Deadbeat d = {.last = 50, .period = 0.1, .mass = 2};
    assert_int_equal(yk_simulation_set_effort(run.sim, "x", 0), YK_OK);
    assert_int_equal(yk_simulation_set_control(run.sim, 0, stop_in_two_samples, &d), YK_BAD_ARGUMENT);
    assert_int_equal(yk_simulation_set_control(run.sim, 0.1, stop_in_two_samples, &d), YK_OK);
    double rows[] = {0.33, 0.4, 0.45, 0.77, 0.8};
    for (size_t k = 0; k < 5; k++) {
        assert_int_equal(yk_simulation_advance(run.sim, rows[k]), YK_OK);
        assert_true(yk_simulation_time(run.sim) == rows[k]);
        if (rows[k] < 0.5) continue;
        CHECK_NEAR(run_value(&run, "x"), 0, 1e-12);
        CHECK_NEAR(run_value(&run, "x.rate"), 0, 1e-11);
    }
    assert_int_equal(d.calls, 6);
    assert_int_equal(yk_simulation_sample_count(run.sim), 6);
    for (size_t k = 0; k < d.calls; k++) {
        assert_true(d.times[k] == 0.3 + 0.1 * (double)k);
        assert_true(yk_simulation_sample_time(run.sim, k) == d.times[k]);
    }
    d.last = 8; // then it ends the advance at its eighth sample, and again whenever it is asked
    assert_int_equal(yk_simulation_advance(run.sim, 3), YK_OK);
    assert_true(yk_simulation_time(run.sim) == 0.3 + 0.1 * 7);
    run_free(&run);
}

// --- back to the start ----------------------------------------------------------------------------

static void after_a_reset_all_has_the_same_bits(void **unused)
{
    (void)unused;
    Run run = run_of_example("bouncing-block", run_options(1e-9));
    YkChannel height = {0};
    assert_int_equal(yk_channel_parse(yk_state_mechanism(yk_simulation_state(run.sim)), "h", &height, NULL), YK_OK);
    assert_int_equal(yk_simulation_watch(run.sim, "half", height, 0.5, 0), YK_OK);
    double first[20];
    size_t happened = 0;
    for (int round = 0; round < 2; round++) {
        for (int k = 0; k < 20; k++) {
            assert_int_equal(yk_simulation_advance(run.sim, 0.1 * k), YK_OK);
            double h = run_value(&run, "h");
            if (round == 0) first[k] = h;
            assert_memory_equal(&h, &first[k], sizeof h);
        }
        if (round == 0) happened = yk_simulation_happening_count(run.sim);
        assert_int_equal(yk_simulation_happening_count(run.sim), happened);
        assert_true(happened > 4);
        assert_int_equal(yk_simulation_reset(run.sim), YK_OK);
        assert_int_equal(yk_simulation_happening_count(run.sim), 0);
        assert_true(yk_simulation_time(run.sim) == 0);
    }
    run_free(&run);
}

// What was set before the first advance stays; what was set later is gone.
static void a_reset_forgets_what_was_done(void **unused)
{
    (void)unused;
    Run run = run_of_text(BLOCK, pulled(0));
    assert_int_equal(yk_simulation_set_effort(run.sim, "x", 4), YK_OK);
    YkPull pull = {.body = 1, .force = {8, 0}};
    for (int round = 0; round < 2; round++) {
        assert_int_equal(yk_simulation_advance(run.sim, 1), YK_OK);
        CHECK_NEAR(run_value(&run, "x"), 1, 1e-12); // 4 N on 2 kg
        assert_int_equal(yk_simulation_act_effort(run.sim, 0, -9), YK_OK);
        assert_int_equal(yk_simulation_act_pull(run.sim, 0, &pull), YK_OK);
        assert_int_equal(yk_simulation_advance(run.sim, 2), YK_OK);
        CHECK_NEAR(run_value(&run, "x"), 1 + 2 - 0.25, 1e-12);
        assert_int_equal(yk_simulation_reset(run.sim), YK_OK);
    }
    run_free(&run);
}

static void what_is_no_pull_is_refused(void **unused)
{
    (void)unused;
    Run run = run_of_text(BLOCK, pulled(0));
    YkPull good = {.body = 1}, ground = {.body = 0}, none = {.body = 2}, nan = {.body = 1, .stiffness = (double)NAN};
    assert_int_equal(yk_simulation_act_pull(run.sim, 0, &good), YK_OK);
    assert_int_equal(yk_simulation_act_pull(run.sim, 2, &good), YK_BAD_ARGUMENT);
    assert_int_equal(yk_simulation_act_pull(run.sim, 0, &ground), YK_BAD_ARGUMENT);
    assert_int_equal(yk_simulation_act_pull(run.sim, 0, &none), YK_BAD_ARGUMENT);
    assert_int_equal(yk_simulation_act_pull(run.sim, 0, &nan), YK_BAD_ARGUMENT);
    assert_int_equal(yk_simulation_step(run.sim, -1), YK_BAD_ARGUMENT);
    run_free(&run);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_pull_is_a_damped_spring_to_a_target),
        cmocka_unit_test(a_pull_is_the_spring_of_a_file),
        cmocka_unit_test(a_force_on_a_point_is_the_force_of_a_file),
        cmocka_unit_test(efforts_are_set_while_it_moves),
        cmocka_unit_test(a_drive_is_taken_over),
        cmocka_unit_test(a_control_samples_exactly_and_holds),
        cmocka_unit_test(after_a_reset_all_has_the_same_bits),
        cmocka_unit_test(a_reset_forgets_what_was_done),
        cmocka_unit_test(what_is_no_pull_is_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
