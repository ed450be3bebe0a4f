// Motion in time against closed forms, laws and published trajectories.
#include "base/vec.h"
#include "run.h"

#define PENDULUM                                                                                                       \
    "gravity: [0, -9.81]\nbodies:\n  ground: {points: {O: [0, 0]}}\n"                                                  \
    "  bob: {points: {O: [0, 0], P: [1, 0]}, mass: 1, center: [1, 0]}\n"                                               \
    "joints:\n  O: {pin: [ground, bob], angle: a}\n"

// IFToMM A1: a point mass let go at (-1, 0). Rows: Jacobi's elliptic functions to 18 digits (validation case IFT-A1).
static void a_pendulum_follows_its_elliptic_function(void **unused)
{
    (void)unused;
    static const double rows[][3] = {{0.5, -0.391048791550546388, -0.920369948785192204},
                                     {1, 0.986291751131875319, -0.165010853125541169},
                                     {5, -0.942305435043757335, -0.334754338414000581},
                                     {10, -0.27508746257611686, -0.961419205099125064}};
    Run run = run_of_text(PENDULUM "start: {a: 180 deg}\n", run_options(1e-12));
    for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
        assert_int_equal(yk_simulation_advance(run.sim, rows[k][0]), YK_OK);
        CHECK_NEAR(run_value(&run, "bob.P.x"), rows[k][1], 1e-10);
        CHECK_NEAR(run_value(&run, "bob.P.y"), rows[k][2], 1e-10);
    }
    assert_true(yk_simulation_summary(run.sim).energy_error < 1e-11);
    run_free(&run);
}

// Every row of this pendulum meets it where it stands still: the error is measured against the energy between them.
static void energy_is_seen_between_rows(void **unused)
{
    (void)unused;
    Run run = run_of_example("two-second-pendulum", run_options(1e-9));
    for (int row = 0; row <= 10; row++) assert_int_equal(yk_simulation_advance(run.sim, row), YK_OK);
    assert_true(fabs(run_value(&run, "kinetic")) < 1e-12);
    assert_true(yk_simulation_summary(run.sim).energy_error < 1e-8);
    run_free(&run);
}

static void energy_stays_for_a_thousand_seconds(void **unused)
{
    (void)unused;
    static const double tolerance[] = {1e-10, 1e-12}, allowed[] = {1e-6, 1e-8};
    for (int k = 0; k < 2; k++) {
        YkSimulationOptions options = run_options(tolerance[k]);
        options.horizon = 1000;
        Run run = run_of_example("double-pendulum", options);
        assert_int_equal(yk_simulation_set_effort(run.sim, "theta1", 0),
                         YK_OK); // constant torques would feed it for ever
        assert_int_equal(yk_simulation_set_effort(run.sim, "theta2", 0), YK_OK);
        for (int row = 1; row <= 100; row++) assert_int_equal(yk_simulation_advance(run.sim, 10.0 * row), YK_OK);
        assert_true(yk_simulation_summary(run.sim).energy_error <= allowed[k]);
        assert_true(yk_simulation_summary(run.sim).energy_error > 0);
        run_free(&run);
    }
}

// Duffing's oscillator: x = A cn(w t, k) returns after 4 K(k)/w; K by the arithmetic-geometric mean. It passes the
// middle with the speed that the work of both springs gives.
static void a_cubic_spring_swings_by_its_elliptic_function(void **unused)
{
    (void)unused;
    static const double amplitude[] = {0.2, 0.1};
    for (int c = 0; c < 2; c++) {
        double A = amplitude[c], square = 20 + 1000 * A * A, a = 1, b = sqrt(1 - 1000 * A * A / (2 * square));
        for (int k = 0; k < 8; k++) {
            double mean = (a + b) / 2;
            b = sqrt(a * b), a = mean;
        }
        double period = 2 * YK_PI / (a * sqrt(square)), middle = -sqrt(20 * A * A + 500 * pow(A, 4));
        char text[400];
        snprintf(text, sizeof text,
                 "bodies:\n  ground: {points: {P: [0, -0.3]}}\n  block: {points: {C: [0, 0]}, mass: 1}\njoints:\n"
                 "  S: {slide: [ground, block], along: y, distance: x}\nsprings:\n"
                 "  a: {between: [ground.P, block.C], force: 20 N/m * (length - 0.3 m)}\n"
                 "  b: {along: x, force: 1000 N/m^3 * length^3}\nstart: {x: %.17g}\n",
                 A);
        Run run = run_of_text(text, run_options(1e-12));
        static const double rows[][2] = {{0.25, 0}, {0.5, -1}, {0.75, 0}, {1, 1}, {5, 1}};
        for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
            assert_int_equal(yk_simulation_advance(run.sim, rows[k][0] * period), YK_OK);
            CHECK_NEAR(run_value(&run, "x"), rows[k][1] * A, 1e-9);
            if (rows[k][1] == 0) CHECK_NEAR(fabs(run_value(&run, "x.rate")), -middle, 1e-9);
        }
        assert_true(yk_simulation_summary(run.sim).energy_error < 1e-9);
        run_free(&run);
    }
}

// All three steppers, with and without a horizon, go the same way.
static void steppers_agree(void **unused)
{
    (void)unused;
    double found[4];
    for (int k = 0; k < 4; k++) {
        YkSimulationOptions options = run_options(k == 1 ? 1e-9 : 1e-12);
        options.integrator = (YkIntegrator)(k % 3);
        options.step = 1e-4;
        options.horizon = k == 3 ? 2 : 0;
        Run run = run_of_example("rocking-four-bar", options);
        for (int row = 1; row <= 10; row++) assert_int_equal(yk_simulation_advance(run.sim, 0.05 * row), YK_OK);
        found[k] = run_value(&run, "theta4");
        run_free(&run);
    }
    for (int k = 1; k < 4; k++) CHECK_NEAR(found[k], found[0], 1e-7);
}

// Without damping, a motion turned round comes back.
static void reversed_motion_comes_back(void **unused)
{
    (void)unused;
    Run there = run_of_example("n-four-bar", run_options(1e-12));
    assert_int_equal(yk_simulation_advance(there.sim, 1.3), YK_OK);
    double angle = run_value(&there, "theta0"), rate = run_value(&there, "theta0.rate");
    YkStartValue values[] = {{"theta0", false, angle}, {"theta1", false, angle}, {"theta2", false, angle},
                             {"psi1", false, -angle},  {"psi2", false, -angle},  {"theta0.rate", true, 0}};
    values[5] = (YkStartValue){"theta0", true, -rate};
    YkSimulationOptions options = run_options(1e-12);
    options.values = values;
    options.value_count = 6;
    Run back = run_of_example("n-four-bar", options);
    assert_int_equal(yk_simulation_advance(back.sim, 1.3), YK_OK);
    CHECK_NEAR(run_value(&back, "theta0"), acos(-1) / 2, 1e-9);
    CHECK_NEAR(run_value(&back, "theta0.rate"), 1, 1e-8);
    run_free(&there);
    run_free(&back);
}

// Andrews' squeezer at 0.03 s: seven angles to 28 digits (validation case AND-1).
static void the_squeezer_reaches_its_reference(void **unused)
{
    (void)unused;
    Run run = run_of_example("andrews", run_options(1e-13));
    assert_int_equal(yk_simulation_advance(run.sim, 0.03), YK_OK);
    CHECK_NEAR(run_value(&run, "beta"), 1.581077119515370709711938730469e+01, 1e-10);
    CHECK_NEAR(run_value(&run, "gamma"), 4.082224011964580485828231960096e-02, 1e-10);
    CHECK_NEAR(run_value(&run, "delta"), 5.244099658799540693716557999470e-01, 1e-10);
    CHECK_NEAR(run_value(&run, "epsilon"), 1.048080741041937873068515471841e+00, 1e-10);
    run_free(&run);
}

static void works_and_energy_balance(void **unused)
{
    (void)unused;
    static const char *const names[] = {"spring-slider-crank", "five-bar-motors", "gas-engine", "car-axis",
                                        "cart-pendulum"};
    for (size_t k = 0; k < sizeof names / sizeof *names; k++) {
        Run run = run_of_example(names[k], run_options(1e-10));
        for (int row = 1; row <= 10; row++) assert_int_equal(yk_simulation_advance(run.sim, 0.1 * row), YK_OK);
        YkSimulationSummary s = yk_simulation_summary(run.sim);
        double works = 0, size = 0;
        for (size_t w = 0; w < yk_simulation_work_count(run.sim); w++) {
            works += yk_simulation_work(run.sim, w);
            size += fabs(yk_simulation_work(run.sim, w));
        }
        assert_true(size > 1e-6 * fabs(s.energy_start));
        CHECK_NEAR(s.energy_end - s.energy_start, works, 1e-7 * (fabs(s.energy_start) + size));
        assert_true(s.energy_error < 1e-7 && s.worst_residual < 1e-12);
        run_free(&run);
    }
}

static void watched_values_are_found(void **unused)
{
    (void)unused;
    Run run = run_of_text(PENDULUM "start: {a: 0}\n", run_options(1e-12));
    YkChannel channel;
    assert_int_equal(yk_channel_parse(yk_state_mechanism(yk_simulation_state(run.sim)), "a", &channel, NULL), YK_OK);
    assert_int_equal(yk_simulation_watch(run.sim, "bottom", channel, -acos(-1) / 2, 0), YK_OK);
    assert_int_equal(yk_simulation_advance(run.sim, 3), YK_OK);
    assert_int_equal(yk_simulation_happening_count(run.sim), 3); // a quarter of the period, then every half
    for (size_t k = 0; k < 3; k++) {
        YkHappening h = yk_simulation_happening(run.sim, k);
        assert_int_equal(h.kind, YK_HAPPENING_CROSSING);
        CHECK_NEAR(h.time, 2.3678419475762374493 * (0.25 + 0.5 * (double)k), 1e-10);
    }
    run_free(&run);
}

static void rates_that_break_the_loops_are_projected(void **unused)
{
    (void)unused;
    YkProblems *problems = yk_problems_new();
    const char *text =
        "bodies:\n  ground: {points: {A: [0, 0], D: [3, 0]}}\n  a: {points: {A: [0, 0], B: [1, 0]}, mass: 1, rod: [A, "
        "B]}\n"
        "  b: {points: {B: [0, 0], C: [3, 0]}, mass: 1, rod: [B, C]}\n  c: {points: {D: [0, 0], C: [2, 0]}, mass: 1, "
        "rod: [D, C]}\n"
        "joints:\n  A: {pin: [ground, a], angle: x}\n  B: {pin: [a, b], angle: y}\n  D: {pin: [ground, c], angle: z}\n"
        "  C: {pin: [b, c]}\nstart: {x: 60 deg, y: -50 deg, z: 80 deg, x.rate: 1, z.rate: 5}\n";
    Run run = run_of_model(yk_model_parse(text, strlen(text), "t.yaml", NULL, problems), problems, run_options(1e-9));
    assert_true(yk_problems_count(problems) > 0);
    assert_non_null(strstr(yk_problems_get(problems, 0)->message, "the loops do not allow"));
    // least squares: the residual is at right angles to what the loops allow
    double x = run_value(&run, "x.rate"), z = run_value(&run, "z.rate");
    CHECK_NEAR((1 - x) * x + (5 - z) * z, 0, 1e-9);
    run_free(&run);
}

static void refuses(const char *text, const char *message)
{
    YkProblems *problems = yk_problems_new();
    YkModel *model = yk_model_parse(text, strlen(text), "t.yaml", NULL, problems);
    assert_non_null(model);
    assert_null(yk_simulation_new(model, NULL, problems));
    bool found = false;
    for (size_t k = 0; k < yk_problems_count(problems); k++)
        found = found || strstr(yk_problems_get(problems, k)->message, message) != NULL;
    assert_true(found);
    yk_model_free(model);
    yk_problems_free(problems);
}

static void bad_starts_are_refused(void **unused)
{
    (void)unused;
    refuses(PENDULUM "start: {a: 180 deg}\nstops: {a: [0, 90 deg]}\n", "outside its stops");
    refuses("units: {angle: deg}\n" PENDULUM "start: {a: 180}\nstops: {a: [0, 90]}\n",
            "starts at 180 deg, outside its stops (0 to 90 deg)"); // in the file's units
    refuses("bodies:\n  ground: {points: {O: [0, 0]}}\n  bob: {points: {O: [0, 0]}}\njoints:\n  O: {pin: [ground, "
            "bob], angle: a}\n",
            "no body has mass");
}

static void the_same_state_every_time(void **unused)
{
    (void)unused;
    double first = 0;
    for (int k = 0; k < 2; k++) {
        Run run = run_of_example("rocking-four-bar", run_options(1e-9));
        assert_int_equal(yk_simulation_advance(run.sim, 1), YK_OK);
        double angle = run_value(&run, "theta4");
        if (k == 0) first = angle;
        assert_true(angle == first); // to the last bit
        run_free(&run);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_pendulum_follows_its_elliptic_function),
        cmocka_unit_test(a_cubic_spring_swings_by_its_elliptic_function),
        cmocka_unit_test(energy_is_seen_between_rows),
        cmocka_unit_test(energy_stays_for_a_thousand_seconds),
        cmocka_unit_test(steppers_agree),
        cmocka_unit_test(reversed_motion_comes_back),
        cmocka_unit_test(the_squeezer_reaches_its_reference),
        cmocka_unit_test(works_and_energy_balance),
        cmocka_unit_test(watched_values_are_found),
        cmocka_unit_test(rates_that_break_the_loops_are_projected),
        cmocka_unit_test(bad_starts_are_refused),
        cmocka_unit_test(the_same_state_every_time),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
