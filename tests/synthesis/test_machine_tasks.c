// The tasks of examples/tasks that vary a machine: what the best candidate's file does is measured by sweeps of it and
// compared with closed forms, with geometry, and with the work that it does.
#include "synthesis/answer.h"
#include "base/vec.h"

enum { CHANNELS = 6, STEPS = 720 };

typedef struct Driven {
    Standing machine;
    YkSweep *sweep;
} Driven;

// Solves a task of the examples, and drives the best candidate's file over a range.
static Driven best_of(const char *task, const char *const *names, double from, double to)
{
    char path[300];
    snprintf(path, sizeof path, "%s/examples/tasks/%s.yaml", YOKE_ROOT, task);
    YkProblems *problems = yk_problems_new();
    Answer a = {.task = yk_task_load(path, problems)};
    if (a.task) a.synthesis = yk_synthesis_run(a.task, NULL, problems);
    if (!a.synthesis) print_error("%s", yk_problems_text(problems, 0));
    assert_non_null(a.synthesis);
    assert_true(yk_synthesis_count(a.synthesis) > 0);
    Driven d = {.machine = standing(yk_synthesis_candidate(a.synthesis, 0).model)};
    answer_free(&a);
    YkChannel channel[CHANNELS];
    YkSweepOptions options = yk_default_sweep_options();
    YkDynamics *dynamics = yk_dynamics_new(d.machine.mech, NULL);
    size_t count = 0;
    for (; names[count]; count++)
        assert_int_equal(yk_channel_parse(d.machine.mech, names[count], &channel[count], problems), YK_OK);
    YkMotion start = yk_state_input(d.machine.state, 0);
    start.position = from;
    assert_true(yk_state_move_to(d.machine.state, &start, NULL, NULL) >= 0);
    yk_dynamics_prescribe(dynamics, 0, true);
    options.coordinate = (int)yk_input_coordinate(d.machine.mech, 0);
    options.from = from;
    options.to = to;
    options.steps = STEPS;
    options.dynamics = dynamics;
    d.sweep = yk_sweep_run(d.machine.state, &options, channel, count, problems);
    assert_true(d.sweep && yk_sweep_status(d.sweep) >= 0);
    assert_int_equal(yk_sweep_row_count(d.sweep), STEPS + 1);
    yk_dynamics_free(dynamics);
    yk_problems_free(problems);
    return d;
}

static void driven_free(Driven *d)
{
    yk_sweep_free(d->sweep);
    standing_free(&d->machine);
}

// The least and the largest value of a channel in a part of the range.
static void extent(const Driven *d, size_t channel, double from, double to, double *low, double *high)
{
    *low = INFINITY;
    *high = -INFINITY;
    for (size_t r = 0; r <= STEPS; r++) {
        double part = (double)r / STEPS, value = yk_sweep_value(d->sweep, r, channel);
        if (part < from - 1e-12 || part > to + 1e-12) continue;
        *low = fmin(*low, value);
        *high = fmax(*high, value);
    }
}

// How far the point of Hoeken's linkage (links 2, 1, 2.5) strays over half a turn, over its stroke.
static double hoeken(void)
{
    double low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY};
    for (int k = 0; k <= STEPS; k++) {
        double theta = YK_PI / 2 + YK_PI * k / STEPS, dx = 2 - cos(theta), dy = -sin(theta);
        double lift = sqrt(2.5 * 2.5 / (dx * dx + dy * dy) - 0.25);
        double at[2] = {cos(theta) + dx - 2 * lift * dy, sin(theta) + dy + 2 * lift * dx};
        for (int i = 0; i < 2; i++) {
            low[i] = fmin(low[i], at[i]);
            high[i] = fmax(high[i], at[i]);
        }
    }
    return (high[1] - low[1]) / (high[0] - low[0]);
}

static void a_line_from_random_starts_is_straighter_than_hoekens(void **state)
{
    (void)state;
    check_without_sanitizers();
    static const char *const names[] = {"coupler.P.x", "coupler.P.y", "B.transmission", NULL};
    double low[3], high[3];
    Driven d = best_of("straight-line-from-anywhere", names, YK_PI / 2, 3 * YK_PI / 2);
    for (size_t c = 0; c < 3; c++) extent(&d, c, 0, 1, &low[c], &high[c]);
    assert_true(high[0] - low[0] >= 4);
    assert_true((high[1] - low[1]) / (high[0] - low[0]) <= hoeken());
    assert_true((high[1] - low[1]) / (high[0] - low[0]) <= 2e-3);
    assert_true(low[2] > 35 * YK_PI / 180);
    driven_free(&d);
}

static void a_foot_has_a_flat_stride_and_the_lift_that_is_asked(void **state)
{
    (void)state;
    static const char *const names[] = {"leg.foot.x", "leg.foot.y", NULL};
    static const double wanted[5][2] = {{-65, -90}, {-45, -90}, {-25, -90}, {-8, -90}, {-34, -70}};
    double low, high, left = INFINITY, right = -INFINITY;
    Driven d = best_of("jansen-stride", names, 0, 2 * YK_PI);
    extent(&d, 1, 0, 1, &low, &high);
    assert_true(low > -0.0905 && high < -0.069);
    for (size_t k = 0; k < 5; k++) {
        double nearest = INFINITY;
        for (size_t r = 0; r <= STEPS; r++)
            nearest = fmin(nearest, hypot(yk_sweep_value(d.sweep, r, 0) - wanted[k][0] * 1e-3,
                                          yk_sweep_value(d.sweep, r, 1) - wanted[k][1] * 1e-3));
        assert_true(nearest < 0.5e-3);
    }
    for (size_t r = 0; r <= STEPS; r++) {
        if (yk_sweep_value(d.sweep, r, 1) > -0.0895) continue; // on the ground, to half a millimetre
        left = fmin(left, yk_sweep_value(d.sweep, r, 0));
        right = fmax(right, yk_sweep_value(d.sweep, r, 0));
    }
    assert_true(right - left > 0.055);
    driven_free(&d);
}

static void outputs_rest_and_swing(void **state)
{
    (void)state;
    check_without_sanitizers();
    static const char *const names[] = {"psi", "B.transmission", "D.transmission", NULL};
    static const struct {
        const char *task;
        double rest, miss, least; // deg
    } cases[] = {{"dwell-stephenson", 100, 0.5, 30}, {"dwell-watt", 90, 2, 20}};
    for (size_t k = 0; k < 2; k++) {
        const double degree = YK_PI / 180;
        double low, high;
        Driven d = best_of(cases[k].task, names, 0, 2 * YK_PI);
        extent(&d, 0, 150. / 360, 250. / 360, &low, &high);
        CHECK_NEAR(low, cases[k].rest * degree, cases[k].miss * degree);
        CHECK_NEAR(high, cases[k].rest * degree, cases[k].miss * degree);
        extent(&d, 0, 0, 1, &low, &high);
        assert_true(high > (cases[k].rest + 25) * degree);
        for (size_t c = 1; c < 3; c++) {
            extent(&d, c, 0, 1, &low, &high);
            assert_true(low > (c == 1 ? 30 : cases[k].least) * degree);
        }
        driven_free(&d);
    }
}

// The torque on the boom is the slope of the energy and of the work on the load, over the angle.
static void a_load_stays_level_with_little_torque(void **state)
{
    (void)state;
    check_without_sanitizers();
    static const char *const names[] = {"jib.tip.y", "theta.effort", "jib.tip.x", "energy", NULL};
    double low, high, step = YK_PI / 6 / STEPS;
    Driven d = best_of("level-luffing", names, YK_PI / 4, YK_PI * 5 / 12);
    extent(&d, 0, 0, 1, &low, &high);
    assert_true(low > 14.9 && high < 15.1);
    extent(&d, 1, 0, 1, &low, &high);
    assert_true(fmax(fabs(low), fabs(high)) < 0.3e6); // the load alone, straight from the boom's end: over 1.2e6 N m
    extent(&d, 2, 0, 1, &low, &high);
    assert_true(low < 8 && high > 14);
    for (size_t r = 2; r + 2 <= STEPS; r++) {
        double rise[2];
        for (size_t k = 1; k <= 2; k++) {
            double energy = yk_sweep_value(d.sweep, r + k, 3) - yk_sweep_value(d.sweep, r - k, 3);
            rise[k - 1] = energy + 1e5 * (yk_sweep_value(d.sweep, r + k, 0) - yk_sweep_value(d.sweep, r - k, 0));
        }
        CHECK_NEAR(yk_sweep_value(d.sweep, r, 1), (8 * rise[0] - rise[1]) / (12 * step), 0.01);
    }
    driven_free(&d);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_line_from_random_starts_is_straighter_than_hoekens),
        cmocka_unit_test(a_foot_has_a_flat_stride_and_the_lift_that_is_asked),
        cmocka_unit_test(outputs_rest_and_swing),
        cmocka_unit_test(a_load_stays_level_with_little_torque),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
