// Three equal cranks and a plate that is not in line. The third crank repeats a constraint, and it determines the
// motion where the dyad of the other two is at its dead point: no pose of the machine is singular. All cranks turn
// alike, the plate does not turn.
#include "../solve/machine.h"
#include <yoke/batch.h>
#include <yoke/dynamics.h>
#include <yoke/move.h>

// The y of the third pins of ground and plate; what is known of the input at the start.
static const char three_cranks[] =
    "parameters: {x: 0.6, y: %g}\n"
    "gravity: [0, -10]\n"
    "bodies:\n"
    "  ground: {points: {A: [0, 0], B: [1, 0], C: [x, y], M: [-0.5, 0]}}\n"
    "  c1: {points: {A: [0, 0], P: [0.4, 0]}, mass: 2, center: [0.2, 0], inertia: 0.05}\n"
    "  c2: {points: {B: [0, 0], Q: [0.4, 0]}}\n"
    "  c3: {points: {C: [0, 0], R: [0.4, 0]}}\n"
    "  plate: {points: {P: [0, 0], Q: [1, 0], R: [x, y]}, mass: 3, center: [0.5, 0.2], inertia: 0.3}\n"
    "  motor: {points: {M: [0, 0]}}\n"
    "joints:\n"
    "  A: {pin: [ground, c1], angle: theta}\n"
    "  B: {pin: [ground, c2], angle: beta}\n"
    "  C: {pin: [ground, c3], angle: gamma}\n"
    "  P: {pin: [c1, plate]}\n"
    "  Q: {pin: [c2, plate]}\n"
    "  R: {pin: [c3, plate]}\n"
    "  M: {pin: [ground, motor], angle: phi}\n"
    "gears:\n"
    "  G: {mesh: [motor, c1], teeth: [20, 40]}\n"
    "start: {beta: 0.8, gamma: 0.8%s}\n";

static Machine open_cranks(double y, bool is_geared)
{
    char text[2000];
    snprintf(text, sizeof text, three_cranks, y, is_geared ? ", phi: -1.6" : ", theta: 0.8");
    Machine m = {.problems = yk_problems_new()};
    m.model = yk_model_parse(text, strlen(text), "cranks.yaml", NULL, m.problems);
    machine_compile(&m, is_geared ? "phi" : "theta");
    assert_true(yk_state_assemble(m.state) >= 0);
    return m;
}

static void check_cranks(const Machine *m, double theta, double rate, double accel)
{
    static const char *const angles[] = {"theta", "beta", "gamma"};
    for (size_t k = 0; k < 3; k++) {
        YkMotion c = yk_state_coordinate(m->state, yk_coordinate_find(m->mech, angles[k]));
        CHECK_NEAR(remainder(c.position - theta, 2 * YK_PI), 0, 1e-9);
        CHECK_NEAR(c.velocity, rate, 1e-9);
        CHECK_NEAR(c.acceleration, accel, 1e-7);
    }
    // The plate: a circle of 0.4 m without a turn.
    CHECK_NEAR(machine_ask(m, "plate.R.x.rate"), -0.4 * rate * sin(theta), 1e-9);
    CHECK_NEAR(machine_ask(m, "plate.R.y.rate"), 0.4 * rate * cos(theta), 1e-9);
    CHECK_NEAR(machine_ask(m, "plate.R.x.accel"), -0.4 * (accel * sin(theta) + rate * rate * cos(theta)), 1e-7);
    CHECK_NEAR(machine_ask(m, "plate.R.y.accel"), 0.4 * (accel * cos(theta) - rate * rate * sin(theta)), 1e-7);
}

// Poses at the dyad's dead points, beside them, and elsewhere, with and without a gear between the input and the crank.
static const double poses[] = {1, 0, -1, 1e-9, 1e-6, -1e-5, YK_PI, 4, YK_PI + 1e-8, 2 * YK_PI, 7, -2 * YK_PI, 0.3};

static void no_pose_is_singular(void **unused)
{
    (void)unused;
    for (int is_geared = 0; is_geared < 2; is_geared++) {
        Machine m = open_cranks(0.8, is_geared);
        double ratio = is_geared ? -2 : 1;
        for (size_t k = 0; k < sizeof poses / sizeof *poses; k++) {
            YkMotion goal = {poses[k] * ratio, 3 * ratio, -2 * ratio};
            YkMove move = {0};
            YkStatus status = yk_state_move_to(m.state, &goal, NULL, &move);
            if (status != YK_REDUNDANT)
                print_error("geared %d k %zu to %g: %d %s\n", is_geared, k, poses[k], status,
                            yk_state_report(m.state)->message);
            assert_int_equal(status, YK_REDUNDANT);
            assert_true(yk_state_has_rates(m.state));
            check_cranks(&m, poses[k], 3, -2);
            assert_int_equal(move.pass_count, 0); // no branch parts from another
            YkResiduals miss = yk_state_residuals(m.state);
            assert_true(miss.position < 1e-11 && miss.velocity < 1e-9 && miss.acceleration < 1e-7);
        }
        machine_free(&m);
    }
}

static void sweeps_have_no_event_there(void **unused)
{
    (void)unused;
    static const double ways[][2] = {{-1, 1}, {0, 2 * YK_PI}, {0, -2 * YK_PI}, {-2.9, 3.5}, {YK_PI, 1}};
    static const char *const of[] = {"beta", "gamma.rate"};
    for (size_t k = 0; k < sizeof ways / sizeof *ways; k++) {
        Machine m = open_cranks(0.8, false);
        YkMotion from = {ways[k][0], 1, 0};
        assert_true(yk_state_move_to(m.state, &from, NULL, NULL) >= 0);
        YkSweep *sweep = machine_sweep(&m, "theta", ways[k][0], ways[k][1], 12, of, 2);
        assert_true(yk_sweep_status(sweep) >= 0);
        assert_int_equal(yk_sweep_event_count(sweep), 0);
        assert_int_equal(yk_sweep_row_count(sweep), 13);
        for (size_t row = 0; row < 13; row++) {
            assert_int_equal(yk_sweep_row_status(sweep, row), YK_REDUNDANT);
            CHECK_NEAR(yk_sweep_value(sweep, row, 0), yk_sweep_at(sweep, row), 1e-9);
            CHECK_NEAR(yk_sweep_value(sweep, row, 1), 1, 1e-9);
        }
        yk_sweep_free(sweep);
        machine_free(&m);
    }
}

// With the plate's pins in one line all cranks are at their dead points together: there the machine is singular, and
// its rates are the limits of the motion.
static void in_line_it_is_singular(void **unused)
{
    (void)unused;
    Machine m = open_cranks(0, false);
    YkMotion goal = {0, 1, 0};
    assert_int_equal(yk_state_move_to(m.state, &goal, NULL, NULL), YK_CHANGE_POINT);
    check_cranks(&m, 0, 1, 0);
    assert_int_equal(yk_state_solve(m.state), YK_SINGULAR); // which tells no more than the pose does
    assert_false(yk_state_has_rates(m.state));
    goal.position = -1;
    YkMove move = {0};
    assert_true(yk_state_move_to(m.state, &goal, NULL, &move) >= 0);
    CHECK_NEAR(machine_ask(&m, "gamma"), -1, 1e-9);
    machine_free(&m);
}

static void lanes_answer_there_too(void **unused)
{
    (void)unused;
    enum { POSES = sizeof poses / sizeof *poses, CHANNELS = 4 };
    static const char *const of[CHANNELS] = {"beta", "gamma.rate", "gamma.accel", "plate.R.y"};
    Machine m = open_cranks(0.8, false);
    YkChannel channels[CHANNELS];
    for (size_t k = 0; k < CHANNELS; k++) channels[k] = machine_channel(&m, of[k]);
    double theta[POSES], rate[POSES], out[CHANNELS][POSES], *outputs[CHANNELS];
    for (size_t k = 0; k < POSES; k++) theta[k] = poses[k], rate[k] = 2;
    for (size_t k = 0; k < CHANNELS; k++) outputs[k] = out[k];
    const double *inputs[3] = {theta, rate, NULL};
    signed char status[POSES];
    YkBatch *batch = yk_batch_new(m.state, channels, CHANNELS);
    assert_non_null(batch);
    (void)yk_batch_run(batch, inputs, outputs, status, POSES);
    size_t found = 0;
    for (size_t k = 0; k < POSES; k++) {
        if (status[k] == YK_LIMIT) continue; // beyond, where the dyad of the start has its other branch
        found += fabs(sin(poses[k])) < 1e-7;
        CHECK_NEAR(remainder(out[0][k] - poses[k], 2 * YK_PI), 0, 1e-9);
        CHECK_NEAR(out[1][k], 2, 1e-9);
        CHECK_NEAR(out[2][k], 0, 1e-7);
        CHECK_NEAR(out[3][k], 0.8 + 0.4 * sin(poses[k]), 1e-9);
    }
    assert_true(found >= 4);
    yk_batch_free(batch);
    machine_free(&m);
}

// Forces at the dead point are those beside it, and both methods agree; the effort is that of virtual work.
static void forces_are_determined(void **unused)
{
    (void)unused;
    Machine m = open_cranks(0.8, false);
    YkDynamics *d = yk_dynamics_new(m.mech, m.problems);
    assert_non_null(d);
    static const double beside[] = {0, 0.1};
    double effort[2][2];
    YkState *copy = yk_state_new(m.mech);
    assert_non_null(copy);
    for (size_t k = 0; k < 2; k++) {
        YkMotion goal = {beside[k], 3, -2};
        yk_dynamics_prescribe(d, 0, true);
        assert_true(yk_state_move_to(m.state, &goal, NULL, NULL) >= 0);
        assert_int_equal(yk_state_copy(copy, m.state), YK_OK);
        for (int way = 0; way < 2; way++) {
            YkStatus status = yk_dynamics_solve(d, m.state, way ? YK_METHOD_NEWTON_EULER : YK_METHOD_REDUCED);
            assert_int_equal(status, YK_REDUNDANT);
            effort[k][way] = yk_dynamics_effort(d, yk_coordinate_find(m.mech, "theta"));
            assert_int_equal(yk_dynamics_solve(d, copy, way ? YK_METHOD_NEWTON_EULER : YK_METHOD_REDUCED),
                             YK_REDUNDANT);
            assert_true(yk_dynamics_effort(d, yk_coordinate_find(m.mech, "theta")) == effort[k][way]);
        }
        // The crank about A: J = 0.05 + 2 (0.2)^2; the plate as a point mass on it.
        double inertia = 0.05 + 2 * 0.04 + 3 * 0.16, weight = 10 * (2 * 0.2 + 3 * 0.4) * cos(beside[k]);
        CHECK_NEAR(effort[k][0], inertia * -2 + weight, 1e-9);
        CHECK_NEAR(effort[k][1], inertia * -2 + weight, 1e-9);
    }
    yk_state_free(copy);
    yk_dynamics_free(d);
    machine_free(&m);
}

// --- a group of the same cranks, which a rod and a slider drive

// The plate turns on three cranks of 1.2 m; the rod of 4 m from its pin D to a slider at x = 1 m, whose y is 5 m - s.
static const char pushed_cranks[] = "bodies:\n"
                                    "  ground: {points: {A: [0, 0], B: [4, 0], C: [2, -1.5], G: [1, 5]}}\n"
                                    "  a: {points: {A: [0, 0], P: [1.2, 0]}}\n"
                                    "  b: {points: {B: [0, 0], Q: [1.2, 0]}}\n"
                                    "  c: {points: {C: [0, 0], R: [1.2, 0]}}\n"
                                    "  plate: {points: {P: [0, 0], Q: [4, 0], R: [2, -1.5], D: [1.5, 0.5]}}\n"
                                    "  rod: {points: {D: [0, 0], E: [4, 0]}}\n"
                                    "  block: {points: {E: [0, 0]}}\n"
                                    "joints:\n"
                                    "  A: {pin: [ground, a], angle: theta}\n"
                                    "  B: {pin: [ground, b], angle: beta}\n"
                                    "  C: {pin: [ground, c], angle: gamma}\n"
                                    "  P: {pin: [a, plate]}\n"
                                    "  Q: {pin: [b, plate]}\n"
                                    "  R: {pin: [c, plate]}\n"
                                    "  D: {pin: [plate, rod], angle: delta}\n"
                                    "  E: {pin: [rod, block]}\n"
                                    "  G: {slide: [block, ground], along: 90 deg, from: E, to: G, distance: s}\n"
                                    "start: {s: -0.5, theta: 1.2, beta: 1.2, gamma: 1.2, delta: 1.8}\n";

// The rod's length tells s of the cranks' angle, and its derivatives.
static double slider_at(double theta, double *slope, double *bend)
{
    double X = 0.5 + 1.2 * cos(theta), Y = 0.5 + 1.2 * sin(theta), h = sqrt(16 - X * X);
    double X1 = -1.2 * sin(theta), X2 = -1.2 * cos(theta), Y1 = 1.2 * cos(theta), Y2 = -1.2 * sin(theta);
    double h1 = -X * X1 / h, h2 = -(X1 * X1 + X * X2 + h1 * h1) / h;
    *slope = -(Y1 + h1);
    *bend = -(Y2 + h2);
    return 5 - (Y + h);
}

// Returns whether the state stands where all cranks have this angle, and their rates follow from the slider's.
static void check_pushed(const Machine *m, double theta, double rate)
{
    static const char *const angles[] = {"theta", "beta", "gamma"};
    double slope, bend;
    slider_at(theta, &slope, &bend);
    for (size_t k = 0; k < 3; k++) {
        YkMotion c = yk_state_coordinate(m->state, yk_coordinate_find(m->mech, angles[k]));
        CHECK_NEAR(c.position, theta, 1e-9);
        CHECK_NEAR(c.velocity, rate / slope, 1e-9);
        CHECK_NEAR(c.acceleration, -bend * (rate / slope) * (rate / slope) / slope, 1e-8);
    }
}

// Where two cranks and the plate are in line, the group's kept loops are singular, and the third crank leads on.
static void groups_go_on_there(void **unused)
{
    (void)unused;
    static const double goals[] = {0.5, 0, -0.4, 1e-9, 1.1, 1e-5, -1e-4, -1e-7, 0, 2e-3, -1.2, 1.3};
    Machine m = machine_parse(pushed_cranks, true);
    double slope, bend;
    for (size_t k = 0; k < sizeof goals / sizeof *goals; k++) {
        YkMotion goal = {slider_at(goals[k], &slope, &bend), 0.1, 0};
        YkMove move = {0};
        YkStatus status = yk_state_move_to(m.state, &goal, NULL, &move);
        if (status != YK_REDUNDANT) print_error("to %g: %s\n", goals[k], yk_state_report(m.state)->message);
        assert_int_equal(status, YK_REDUNDANT);
        assert_true(yk_state_has_rates(m.state));
        assert_int_equal(move.pass_count, 0);
        check_pushed(&m, goals[k], 0.1);
    }
    static const char *const of[] = {"theta", "beta.accel", "gamma.accel"};
    YkSweep *sweep = machine_sweep(&m, "s", slider_at(1.2, &slope, &bend), slider_at(-1.2, &slope, &bend), 50, of, 3);
    assert_int_equal(yk_sweep_status(sweep), YK_OK);
    assert_int_equal(yk_sweep_event_count(sweep), 0);
    for (size_t row = 0; row <= 50; row++) {
        CHECK_NEAR(slider_at(yk_sweep_value(sweep, row, 0), &slope, &bend), yk_sweep_at(sweep, row), 1e-9);
        CHECK_NEAR(yk_sweep_value(sweep, row, 1), yk_sweep_value(sweep, row, 2), 1e-8);
    }
    yk_sweep_free(sweep);
    YkMotion beyond = {slider_at(-1.2, &slope, &bend) + 0.2, 0.1, 0}; // the rod and the cranks are in line before
    assert_int_equal(yk_state_move_to(m.state, &beyond, NULL, NULL), YK_LIMIT);
    machine_free(&m);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(no_pose_is_singular),    cmocka_unit_test(sweeps_have_no_event_there),
        cmocka_unit_test(in_line_it_is_singular), cmocka_unit_test(lanes_answer_there_too),
        cmocka_unit_test(forces_are_determined),  cmocka_unit_test(groups_go_on_there),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
