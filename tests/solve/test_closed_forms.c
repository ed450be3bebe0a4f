// Machines whose motion a textbook writes down: positions, velocities and accelerations against it, to 1e-12.
#include "machine.h"

enum { POSES = 360 };

// --- slider-crank
// ---------------------------------------------------------------------------------------------------------

// x = r cos + l cos(phi) with sin(phi) = r sin / l and the rates by differentiation; crank rate w, acceleration a.
static void slider_crank(double r, double l, double theta, double w, double a, double *x, double *v, double *acc)
{
    double s = sin(theta), c = cos(theta), root = sqrt(l * l - r * r * s * s);
    double first = -r * s - r * r * s * c / root;
    double u = r * r * s * c, up = r * r * (c * c - s * s); // d(root)/dtheta = -u / root
    double second = -r * c - up / root - u * u / (root * root * root);
    *x = r * c + root;
    *v = first * w;
    *acc = second * w * w + first * a;
}

static void check_slider_crank(const char *file, double r, double l)
{
    Machine m = machine_load(file);
    for (int k = 0; k <= POSES; k++) {
        double theta = 1 + 2 * YK_PI * k / POSES, x, v, a;
        slider_crank(r, l, theta, 3, -2, &x, &v, &a);
        assert_true(machine_solve(&m, theta, 3, -2) >= 0);
        CHECK_NEAR(machine_ask(&m, "x"), x, 1e-12 * x);
        CHECK_NEAR(machine_ask(&m, "x.rate"), v, 1e-12 * 3 * r);
        CHECK_NEAR(machine_ask(&m, "x.accel"), a, 1e-12 * 11 * r);
    }
    machine_free(&m);
}

static void test_the_slider_crank(void **unused)
{
    (void)unused;
    check_slider_crank("slider-crank", 0.15, 0.6);
}

static void test_a_doubled_guide_moves_as_a_single_one(void **unused)
{
    (void)unused;
    check_slider_crank("doubled-guide", 0.1, 0.35);
}

static void test_the_offset_slider_crank(void **unused)
{
    (void)unused;
    static const char model[] = "bodies:\n"
                                "  ground: {points: {O: [0, 0], G: [0, 0.2]}}\n"
                                "  crank:  {points: {O: [0, 0], A: [0.3, 0]}}\n"
                                "  rod:    {points: {A: [0, 0], B: [1, 0]}}\n"
                                "  piston: {points: {B: [0, 0]}}\n"
                                "joints:\n"
                                "  O: {pin: [ground, crank], angle: theta}\n"
                                "  A: {pin: [crank, rod], angle: psi}\n"
                                "  B: {pin: [rod, piston]}\n"
                                "  R: {slide: [ground, piston], along: x, from: G, distance: x}\n"
                                "start: {theta: 1, x: 1, psi: -1}\n";
    Machine m = machine_parse(model, true);
    for (int k = 0; k <= POSES; k++) {
        double theta = 1 + 2 * YK_PI * k / POSES, s = 0.3 * sin(theta) - 0.2;
        assert_true(machine_solve(&m, theta, 1, 0) >= 0);
        CHECK_NEAR(machine_ask(&m, "x"), 0.3 * cos(theta) + sqrt(1 - s * s), 1e-12);
    }
    machine_free(&m);
}

// --- slots and guides
// -------------------------------------------------------------------------------------------------------

static void test_the_scotch_yoke_is_harmonic(void **unused)
{
    (void)unused;
    Machine m = machine_load("scotch-yoke");
    for (int k = 0; k <= POSES; k++) {
        double theta = 2 * YK_PI * k / POSES, w = 12.5, a = 3, r = 0.05;
        assert_true(machine_solve(&m, theta, w, a) >= 0);
        CHECK_NEAR(machine_ask(&m, "x"), r * cos(theta), 1e-12 * r);
        CHECK_NEAR(machine_ask(&m, "x.rate"), -r * w * sin(theta), 1e-12 * r * w);
        CHECK_NEAR(machine_ask(&m, "x.accel"), -r * (w * w * cos(theta) + a * sin(theta)), 1e-12 * r * w * w);
    }
    machine_free(&m);
}

static void test_the_trammel_draws_its_ellipse(void **unused)
{
    (void)unused;
    Machine m = machine_load("elliptic-trammel");
    const double l = 0.3, p = 0.45, w = 2, a = -1;
    for (int k = 0; k <= POSES; k++) {
        double theta = 2 * YK_PI * k / POSES, s = sin(theta), c = cos(theta);
        assert_true(machine_solve(&m, theta, w, a) >= 0);
        double x = machine_ask(&m, "bar.P.x"), y = machine_ask(&m, "bar.P.y");
        CHECK_NEAR(x * x / ((p - l) * (p - l)) + y * y / (p * p), 1, 1e-12);
        CHECK_NEAR(x, (p - l) * c, 1e-12);
        CHECK_NEAR(y, p * s, 1e-12);
        CHECK_NEAR(machine_ask(&m, "bar.P.y.rate"), p * c * w, 1e-12);
        CHECK_NEAR(machine_ask(&m, "bar.P.y.accel"), p * (c * a - s * w * w), 1e-12 * 4);
        CHECK_NEAR(machine_ask(&m, "x"), -l * c, 1e-12);
        CHECK_NEAR(machine_ask(&m, "y"), l * s, 1e-12);
    }
    machine_free(&m);
}

// --- linkages
// -------------------------------------------------------------------------------------------------------------

// K1 cos(theta4) - K2 cos(theta2) + K3 = cos(theta2 - theta4), Freudenstein 1955; and its derivative.
static void test_the_four_bar_obeys_freudensteins_equation(void **unused)
{
    (void)unused;
    Machine m = machine_load("four-bar");
    const double a = 40, b = 120, c = 80, d = 100;
    const double k1 = d / a, k2 = d / c, k3 = (a * a - b * b + c * c + d * d) / (2 * a * c);
    for (int branch = -1; branch <= 1; branch += 2) {
        yk_state_set_branch(m.state, 0, branch);
        for (int k = 0; k <= POSES; k++) {
            double t2 = 2 * YK_PI * k / POSES;
            assert_int_equal(machine_solve(&m, t2, 1, 0), YK_OK);
            double t4 = machine_ask(&m, "theta4"), w4 = machine_ask(&m, "theta4.rate");
            CHECK_NEAR(k1 * cos(t4) - k2 * cos(t2) + k3 - cos(t2 - t4), 0, 1e-12 * k1);
            CHECK_NEAR(-k1 * sin(t4) * w4 + k2 * sin(t2) + sin(t2 - t4) * (1 - w4), 0, 1e-12 * k1 * (1 + fabs(w4)));
        }
    }
    machine_free(&m);
}

static void test_peaucellier_draws_a_straight_line(void **unused)
{
    (void)unused;
    Machine m = machine_load("peaucellier");
    const double line = (9 - 2.25) / 2; // (l^2 - s^2) / (2 r)
    int closed = 0;
    for (int k = 0; k <= POSES; k++) {
        if (machine_solve(&m, -1.4 + 2.8 * k / POSES, 1, 0.5) < 0) continue;
        closed++;
        CHECK_NEAR(machine_ask(&m, "bq.Q.x"), line, 1e-12 * line);
        CHECK_NEAR(machine_ask(&m, "bq.Q.x.rate"), 0, 1e-11);
        CHECK_NEAR(machine_ask(&m, "bq.Q.x.accel"), 0, 1e-10);
        double w = 1, theta = -1.4 + 2.8 * k / POSES; // Q.y = line tan(theta / 2)
        double half = 0.5 * theta, y = line * tan(half), rate = 0.5 * w * line / (cos(half) * cos(half));
        CHECK_NEAR(machine_ask(&m, "bq.Q.y"), y, 1e-11);
        CHECK_NEAR(machine_ask(&m, "bq.Q.y.rate"), rate, 1e-11 * (1 + rate));
    }
    assert_true(closed > POSES / 2);
    machine_free(&m);
}

static void test_the_oscillating_cylinder(void **unused)
{
    (void)unused;
    static const char model[] = "bodies:\n"
                                "  ground: {points: {O: [0, 0], Q: [1, 0]}}\n"
                                "  crank:  {points: {O: [0, 0], A: [0.4, 0]}}\n"
                                "  barrel: {points: {Q: [0, 0]}}\n"
                                "  rod:    {points: {A: [0, 0]}}\n"
                                "joints:\n"
                                "  O: {pin: [ground, crank], angle: theta}\n"
                                "  Q: {pin: [ground, barrel], angle: beta}\n"
                                "  S: {slide: [barrel, rod], along: x, distance: s}\n"
                                "  A: {pin: [crank, rod]}\n"
                                "start: {theta: 1, beta: 150 deg, s: 0.9}\n";
    Machine m = machine_parse(model, true);
    for (int k = 0; k <= POSES; k++) {
        double theta = 1 + 2 * YK_PI * k / POSES, s2 = 1.16 - 0.8 * cos(theta), s = sqrt(s2);
        assert_true(machine_solve(&m, theta, 2, 0) >= 0);
        CHECK_NEAR(machine_ask(&m, "s"), s, 1e-12);
        CHECK_NEAR(machine_ask(&m, "s.rate"), 0.8 * sin(theta) / (2 * s) * 2, 1e-12);
        CHECK_NEAR(angle_between(machine_ask(&m, "beta"), atan2(0.4 * sin(theta), 0.4 * cos(theta) - 1)), 0, 1e-12);
        CHECK_NEAR(machine_ask(&m, "beta.rate"), 2 * 0.4 * (0.4 - cos(theta)) / s2, 1e-12);
    }
    machine_free(&m);
}

static void test_cranks_in_parallel_move_alike(void **unused)
{
    (void)unused;
    Machine m = machine_load("three-crank-parallelogram");
    for (int k = 0; k < 60; k++) { // this branch, away from the change points
        double theta = 0.05 + 3.0 * k / 60;
        assert_true(machine_solve(&m, theta, 1, 2) >= 0);
        CHECK_NEAR(machine_ask(&m, "theta2"), theta, 1e-10);
        CHECK_NEAR(machine_ask(&m, "theta3"), theta, 1e-10);
        CHECK_NEAR(machine_ask(&m, "theta3.rate"), 1, 1e-10);
        CHECK_NEAR(machine_ask(&m, "theta3.accel"), 2, 1e-10);
        CHECK_NEAR(machine_ask(&m, "rod.angle"), 0, 1e-10);
    }
    machine_free(&m);
}

// --- drives between moving bodies
// -------------------------------------------------------------------------------------------

// A triangle's angle between sides a and b over side c, with rate and acceleration from those of c.
static YkMotion opposite_angle(double a, double b, YkMotion c)
{
    double cosine = (a * a + b * b - c.position * c.position) / (2 * a * b), sine = sqrt(1 - cosine * cosine);
    double rate = c.position * c.velocity / (a * b * sine);
    double accel =
        (c.velocity * c.velocity + c.position * c.acceleration) / (a * b * sine) - rate * rate * cosine / sine;
    return (YkMotion){acos(cosine), rate, accel};
}

static void test_the_excavator_follows_its_cylinders(void **unused)
{
    (void)unused;
    Machine m = machine_load("excavator");
    for (int k = 0; k < 100; k++) {
        double t = 0.03 * k;
        assert_int_equal(yk_state_set_time(m.state, t, NULL), YK_OK);
        assert_true(yk_state_solve(m.state) >= 0);
        YkMotion s1 = {1.7 + 0.1 * sin(0.5 * t), 0.05 * cos(0.5 * t), -0.025 * sin(0.5 * t)},
                 s2 = {2.1 - 0.08 * t, -0.08, 0};
        // boom: triangle O (ground), B (ground), C (boom)
        YkMotion at_O = opposite_angle(hypot(0.5, 0.4), hypot(1.5, 0.3), s1);
        double theta1 = atan2(-0.4, 0.5) + at_O.position - atan2(0.3, 1.5);
        // stick: triangle A, D (boom), E (stick)
        YkMotion at_A = opposite_angle(hypot(2.2 - 4, 0.6), hypot(0.6, 0.2), s2);
        double direct = atan2(0.6, 2.2 - 4), theta2 = direct - at_A.position - atan2(0.2, -0.6),
               mirrored = direct + at_A.position - atan2(0.2, -0.6);
        double found = machine_ask(&m, "theta2");
        double sign = fabs(angle_between(found, theta2)) < fabs(angle_between(found, mirrored)) ? -1 : 1;
        CHECK_NEAR(angle_between(machine_ask(&m, "theta1"), theta1), 0, 1e-12);
        CHECK_NEAR(machine_ask(&m, "theta1.rate"), at_O.velocity, 1e-12);
        CHECK_NEAR(machine_ask(&m, "theta1.accel"), at_O.acceleration, 1e-12);
        CHECK_NEAR(angle_between(found, sign < 0 ? theta2 : mirrored), 0, 1e-12);
        CHECK_NEAR(machine_ask(&m, "theta2.rate"), sign * at_A.velocity, 1e-12);
        CHECK_NEAR(machine_ask(&m, "theta2.accel"), sign * at_A.acceleration, 1e-12);
        // the bucket is welded to the stick
        CHECK_NEAR(machine_ask(&m, "bucket.angle"), machine_ask(&m, "theta1") + found - YK_PI / 6, 1e-12);
        double stick = machine_ask(&m, "theta1") + found, boom = machine_ask(&m, "theta1"), bucket = stick - YK_PI / 6;
        CHECK_NEAR(machine_ask(&m, "bucket.tip.x"), 4 * cos(boom) + 2.2 * cos(stick) + 0.9 * cos(bucket), 1e-12);
    }
    machine_free(&m);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_the_slider_crank),
        cmocka_unit_test(test_a_doubled_guide_moves_as_a_single_one),
        cmocka_unit_test(test_the_offset_slider_crank),
        cmocka_unit_test(test_the_scotch_yoke_is_harmonic),
        cmocka_unit_test(test_the_trammel_draws_its_ellipse),
        cmocka_unit_test(test_the_four_bar_obeys_freudensteins_equation),
        cmocka_unit_test(test_peaucellier_draws_a_straight_line),
        cmocka_unit_test(test_the_oscillating_cylinder),
        cmocka_unit_test(test_cranks_in_parallel_move_alike),
        cmocka_unit_test(test_the_excavator_follows_its_cylinders),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
