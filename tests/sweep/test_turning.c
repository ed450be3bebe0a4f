// A piston that is driven just as far as its crank lets it go, and back: there the crank goes on through its dead
// point, with the rate that it has, unless the drive comes to it so gently that the crank stands still. A hair less,
// and the crank turns back.
#include "../solve/machine.h"
#include <yoke/dynamics.h>
#include <yoke/move.h>

static const double R = 0.1, L = 0.25, INERTIA = 0.1, MASS = 2; // of the crank about its pivot, and of the piston

// A piston's way, from the outer dead point inwards, and its rates, by T = t/s.
typedef struct Way {
    double s, v, a;
} Way;

static Way by_cosine(double T)
{
    return (Way){0.1 - 0.1 * cos(2 * T - 2), 0.2 * sin(2 * T - 2), 0.4 * cos(2 * T - 2)};
}

static Way by_square(double T)
{
    double u = T - 1;
    return (Way){0.02 * u * u + 0.004 * u * u * u, 0.04 * u + 0.012 * u * u, 0.04 + 0.024 * u};
}

static Way by_fourth_power(double T)
{
    double u = T - 1;
    return (Way){0.02 * u * u * u * u, 0.08 * u * u * u, 0.24 * u * u};
}

static Way by_short_stroke(double T)
{
    Way w = by_cosine(T);
    return (Way){1e-8 + (1 - 1.5e-7) * w.s, (1 - 1.5e-7) * w.v, (1 - 1.5e-7) * w.a};
}

typedef struct Drive {
    const char *law; // the piston's distance from the outer dead point, m
    Way (*way)(double T);
    double passes[3]; // T at which the crank goes on through a dead point
    bool has_dead_points;
} Drive;

static const Drive drives[] = {
    {"0.1 m - 0.1 m * cos(2*t/(1 s) - 2)", by_cosine, {1, 1 + YK_PI / 2, INFINITY}, true},
    {"0.02 m * (t/(1 s) - 1)^2 + 0.004 m * (t/(1 s) - 1)^3", by_square, {1, INFINITY, INFINITY}, true},
    {"0.02 m * (t/(1 s) - 1)^4", by_fourth_power, {INFINITY, INFINITY, INFINITY}, true},
    {"1e-8 m + (1 - 1.5e-7)*(0.1 m - 0.1 m * cos(2*t/(1 s) - 2))",
     by_short_stroke,
     {INFINITY, INFINITY, INFINITY},
     false},
};
enum { DRIVES = sizeof drives / sizeof *drives, ROWS = 61 };

// The crank's angle and rates from the law of cosines, on the side that it has at T.
static void crank(const Drive *d, double T, double *angle, double *rate, double *accel)
{
    Way w = d->way(T);
    double side = 1, s = R + L - w.s, c = (R * R + s * s - L * L) / (2 * R * s);
    for (size_t k = 0; k < 3; k++)
        if (T > d->passes[k]) side = -side;
    *angle = side * acos(fmin(fmax(c, -1), 1));
    double sine = sin(*angle), cosine = cos(*angle), root = sqrt(L * L - R * R * sine * sine);
    double lever = -R * sine - R * R * sine * cosine / root; // ds/dtheta, and its derivative
    double bend = -R * cosine - R * R * (cosine * cosine - sine * sine) / root -
                  R * R * R * R * sine * sine * cosine * cosine / (root * root * root);
    *rate = -w.v / lever;
    *accel = (-w.a - bend * *rate * *rate) / lever;
}

static Machine slider_crank(const Drive *d)
{
    char text[1200];
    double angle, rate, accel;
    crank(d, 0, &angle, &rate, &accel);
    snprintf(text, sizeof text,
             "bodies:\n"
             "  ground: {points: {O: [0, 0]}}\n"
             "  crank:  {points: {O: [0, 0], A: [0.1, 0]}, mass: 1, inertia: 0.1}\n"
             "  rod:    {points: {A: [0, 0], B: [0.25, 0]}}\n"
             "  piston: {points: {B: [0, 0]}, mass: 2}\n"
             "joints:\n"
             "  O: {pin: [ground, crank], angle: theta}\n"
             "  A: {pin: [crank, rod], angle: phi}\n"
             "  B: {pin: [rod, piston]}\n"
             "  S: {slide: [ground, piston], along: x, distance: s}\n"
             "drives: {s: '0.35 m - (%s)'}\n"
             "start: {theta: %.17g, phi: %.17g}\n",
             d->law, angle, -angle - asin(R / L * sin(angle)));
    return machine_parse(text, true);
}

static double nearest_dead_point(const Drive *d, double T)
{
    double nearest = 1;
    for (int k = 0; d->has_dead_points && k < 2; k++) nearest = fmin(nearest, fabs(T - 1 - k * YK_PI / 2));
    return nearest;
}

// The piston's force does the work that the crank and the piston take up.
static void check_row(const Drive *d, const double *row)
{
    double angle, rate, accel, T = row[0], beside = nearest_dead_point(d, T);
    if (beside < 1e-6) return;
    crank(d, T, &angle, &rate, &accel);
    Way w = d->way(T);
    double power = INERTIA * rate * accel + MASS * w.v * w.a, most = 1 + rate * rate + fabs(accel);
    bool is_good = fabs(remainder(row[1] - angle, 2 * YK_PI)) < 1e-7 && fabs(row[2] - rate) < 1e-6 * most / beside &&
                   (beside < 0.01 || fabs(row[3] - accel) < 1e-6 * most / beside) &&
                   (beside < 0.01 || fabs(-w.v * row[4] - power) < 1e-6 * most);
    if (!is_good)
        print_error("%s at %.17g: %.12g %.12g %.12g %.12g, should be %.12g %.12g %.12g\n", d->law, T, row[1], row[2],
                    row[3], row[4], angle, rate, accel);
    assert_true(is_good);
}

static YkSweep *sweep_with_forces(Machine *m, YkDynamics *dynamics, const double *ends)
{
    static const char *const of[] = {"theta", "theta.rate", "theta.accel", "s.effort"};
    YkSweepOptions options = yk_default_sweep_options();
    YkChannel channels[4];
    for (size_t k = 0; k < 4; k++) channels[k] = machine_channel(m, of[k]);
    options.from = ends[0], options.to = ends[1], options.steps = ROWS - 1, options.dynamics = dynamics;
    YkSweep *sweep = yk_sweep_run(m->state, &options, channels, 4, m->problems);
    assert_non_null(sweep);
    assert_int_equal(yk_sweep_status(sweep), YK_OK);
    return sweep;
}

static void sweeps_go_on_through_dead_points(void **unused)
{
    (void)unused;
    static const double ends[][2] = {{0, 2}, {2, 0}, {0.3, 1}, {1 + 1e-4, 1 - 1e-4}, {0, 2.4}, {2.7, 0.1}};
    for (size_t n = 0; n < DRIVES; n++)
        for (size_t k = 0; k < sizeof ends / sizeof *ends; k++) {
            Machine m = slider_crank(&drives[n]);
            YkDynamics *dynamics = yk_dynamics_new(m.mech, m.problems);
            YkSweep *sweep = sweep_with_forces(&m, dynamics, ends[k]);
            for (size_t row = 0; row < ROWS; row++) check_row(&drives[n], yk_sweep_rows(sweep) + 5 * row);
            size_t passes = 0;
            double low = fmin(ends[k][0], ends[k][1]), high = fmax(ends[k][0], ends[k][1]);
            for (size_t j = 0; j < 3; j++) passes += drives[n].passes[j] >= low && drives[n].passes[j] <= high;
            if (passes > 0 || !drives[n].has_dead_points)
                assert_int_equal(count_events(sweep, YK_EVENT_CHANGE_POINT), passes);
            for (size_t e = 0; e < yk_sweep_event_count(sweep); e++)
                if (yk_sweep_event(sweep, e).kind == YK_EVENT_CHANGE_POINT && passes > 0)
                    assert_true(yk_sweep_event(sweep, e).is_turned);
            yk_sweep_free(sweep);
            yk_dynamics_free(dynamics);
            machine_free(&m);
        }
}

// Exactly there the rate follows from s'' = (d2s/dtheta2) theta'^2.
static void a_move_to_the_dead_point_has_the_rate_there(void **unused)
{
    (void)unused;
    for (size_t n = 0; n < 2; n++) {
        Machine m = slider_crank(&drives[n]);
        assert_int_equal(yk_state_move_time(m.state, 1, NULL, NULL, m.problems), YK_CHANGE_POINT);
        YkMotion theta = yk_state_coordinate(m.state, yk_coordinate_find(m.mech, "theta"));
        CHECK_NEAR(theta.position, 0, 1e-12);
        CHECK_NEAR(theta.velocity, -sqrt(drives[n].way(1).a / (R + R * R / L)), 1e-8);
        assert_true(yk_state_move_time(m.state, 1.5, NULL, NULL, m.problems) >= 0);
        double angle, rate, accel;
        crank(&drives[n], 1.5, &angle, &rate, &accel);
        theta = yk_state_coordinate(m.state, yk_coordinate_find(m.mech, "theta"));
        CHECK_NEAR(theta.position, angle, 1e-11);
        CHECK_NEAR(theta.velocity, rate, 1e-10);
        machine_free(&m);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(sweeps_go_on_through_dead_points),
        cmocka_unit_test(a_move_to_the_dead_point_has_the_rate_there),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
