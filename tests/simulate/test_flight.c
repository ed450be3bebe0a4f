// Followers that leave their cams, fly, and land: against the closed forms of the flight and of the impact.
#include "tappet.h"

// A harmonic lift h (1 - cos theta)/2.
static const double h = 0.012, m = 0.3, g = 9.81;

static double lift(double angle)
{
    return h / 2 * (1 - cos(angle));
}

static Run run_of(const char *shaft, const char *rest)
{
    return run_of_tappet("", shaft, rest, 1e-11);
}

static const char *const sprung = "drives: {theta: 300 rad/s * t}\n"
                                  "springs: {k: {along: s, stiffness: 4000 N/m, length: -20 mm}}\n";
static const double c = 4000, p = 0.02, w = 300;

// The flight under the spring from t0 on: a harmonic oscillation about -(p + m g/c).
static double flight(double t0, double t, double *rate)
{
    double o = sqrt(c / m), middle = -(p + m * g / c), s0 = lift(w * t0) - middle, v0 = h / 2 * w * sin(w * t0);
    *rate = v0 * cos(o * (t - t0)) - o * s0 * sin(o * (t - t0));
    return middle + s0 * cos(o * (t - t0)) + v0 / o * sin(o * (t - t0));
}

static double time_of_landing(double t0)
{
    double a = t0 + 1e-3, b = t0 + 0.0125, rate; // in the air at a, in the cam at b
    assert_true(flight(t0, a, &rate) > lift(w * a) && flight(t0, b, &rate) < lift(w * b));
    for (int k = 0; k < 60; k++) {
        double t = 0.5 * (a + b);
        *(flight(t0, t, &rate) > lift(w * t) ? &a : &b) = t;
    }
    return a;
}

static YkHappening happening(Run *run, size_t index, YkHappeningKind kind)
{
    assert_true(index < yk_simulation_happening_count(run->sim));
    YkHappening found = yk_simulation_happening(run->sim, index);
    assert_int_equal(found.kind, kind);
    assert_string_equal(found.name, "heart");
    return found;
}

static size_t index_of_stops(const Run *run)
{
    size_t k = 0;
    while (strcmp(yk_simulation_work_name(run->sim, k), "stops") != 0) k++;
    return k;
}

static void a_flight_follows_its_spring(void **unused)
{
    (void)unused;
    Run run = run_of("", sprung);
    double t0 = acos(-(c * (h / 2 + p) + m * g) / (h / 2 * (m * w * w - c))) / w, t1 = time_of_landing(t0), rate, after;
    for (int k = 1; k < 10; k++) {
        double t = t0 + 0.1 * k * (t1 - t0);
        assert_int_equal(yk_simulation_advance(run.sim, t), YK_OK);
        CHECK_NEAR(run_value(&run, "s"), flight(t0, t, &rate), 1e-11);
        CHECK_NEAR(run_value(&run, "s.rate"), rate, 1e-8);
        CHECK_NEAR(run_value(&run, "heart.force"), 0, 0);
        CHECK_NEAR(run_value(&run, "theta.effort"), 0, 1e-9);
    }
    assert_int_equal(yk_simulation_advance(run.sim, t1 + 1e-4), YK_OK);
    CHECK_NEAR(run_value(&run, "s"), lift(w * (t1 + 1e-4)), 1e-15);
    CHECK_NEAR(happening(&run, 0, YK_HAPPENING_LIFT_OFF).time, t0, 1e-10);
    YkHappening landing = happening(&run, 1, YK_HAPPENING_LANDING);
    flight(t0, t1, &rate);
    after = h / 2 * w * sin(w * t1);
    CHECK_NEAR(landing.time, t1, 1e-10);
    CHECK_NEAR(landing.value, rate - after, 1e-7);
    CHECK_NEAR(yk_simulation_work(run.sim, index_of_stops(&run)), 0.5 * m * (after * after - rate * rate), 1e-7);
    run_free(&run);
}

// The shaft turns freely, J = 2e-4 kg m^2: energy is conserved up to the lift-off, where the lift's acceleration is g,
// and momentum in the impact.
static const double J = 2e-4, E0 = 0.5 * 2e-4 * 60 * 60;

static double rate_at(double angle) // in contact, of the shaft
{
    double slope = h / 2 * sin(angle);
    return sqrt(2 * (E0 - m * g * lift(angle)) / (J + m * slope * slope));
}

static double angle_of_lift_off(void)
{
    double a = 0.5 * acos(-1), b = acos(-1); // the lift speeds up at a, and slows down faster than g at b
    for (int k = 0; k < 60; k++) {
        double angle = 0.5 * (a + b), rate = rate_at(angle);
        *(h / 2 * cos(angle) * rate * rate + g > 0 ? &a : &b) = angle;
    }
    return a;
}

static void a_landing_keeps_the_momentum(void **unused)
{
    (void)unused;
    Run run = run_of("inertia: 200 kg*mm^2", "start: {theta: 0, theta.rate: 60 rad/s}\n");
    double angle = angle_of_lift_off(), rate = rate_at(angle), slope = h / 2 * sin(angle);
    while (yk_simulation_happening_count(run.sim) < 2)
        assert_int_equal(yk_simulation_advance(run.sim, yk_simulation_time(run.sim) + 1e-3), YK_OK);
    YkHappening off = happening(&run, 0, YK_HAPPENING_LIFT_OFF), on = happening(&run, 1, YK_HAPPENING_LANDING);
    CHECK_NEAR(off.value, angle, 1e-8);
    double t = on.time - off.time, at = angle + rate * t, down = slope * rate - g * t, there = h / 2 * sin(at);
    CHECK_NEAR(lift(angle) + slope * rate * t - 0.5 * g * t * t, lift(at), 1e-11);
    CHECK_NEAR(on.value, down - there * rate, 1e-8);
    double lost = 0.5 * on.value * on.value / (1 / m + there * there / J), now = run_value(&run, "theta");
    CHECK_NEAR(yk_simulation_work(run.sim, index_of_stops(&run)), -lost, 1e-10);
    double after = (J * rate + m * there * down) / (J + m * there * there); // by momentum, and energy from there on
    double energy = 0.5 * (J + m * there * there) * after * after + m * g * lift(at), own = h / 2 * sin(now);
    CHECK_NEAR(run_value(&run, "theta.rate"), sqrt(2 * (energy - m * g * lift(now)) / (J + m * own * own)), 1e-7);
    run_free(&run);
}

// Without mass nothing says how the tappet flies: that is told, and the two stay in contact.
static void a_follower_without_mass_stays(void **unused)
{
    (void)unused;
    YkProblems *problems = yk_problems_new();
    const char *text = "laws:\n"
                       "  lift: {period: 360 deg, segments: [{formula: {to: 360 deg, s: 12 mm*(1 - cos(x))/2}}]}\n"
                       "cams:\n"
                       "  heart: {cam: shaft, follower: tappet, law: lift, roller: 6 mm, base: 30 mm}\n"
                       "bodies: {shaft: {inertia: 1e-3 kg*m^2}, tappet: {}}\n"
                       "joints:\n"
                       "  K: {pin: [ground, shaft], angle: theta}\n"
                       "  T: {slide: [ground, tappet], along: y, distance: s}\n"
                       "drives: {theta: 100 rad/s * t}\n"
                       "springs: {k: {along: s, stiffness: 4000 N/m, length: 6 mm}}\n"; // it pulls from 6 mm on
    Run run =
        run_of_model(yk_model_parse(text, strlen(text), "test.yaml", NULL, problems), problems, run_options(1e-10));
    assert_int_equal(yk_simulation_advance(run.sim, 0.06), YK_OK);
    assert_int_equal(yk_simulation_happening_count(run.sim), 2); // once at the start, once in the second turn
    happening(&run, 0, YK_HAPPENING_PULL);
    CHECK_NEAR(run_value(&run, "s"), lift(6), 1e-14);
    run_free(&run);
}

// The valve's seat: the cam goes on down without it, and comes back to it from below.
static void a_stop_takes_the_follower_off(void **unused)
{
    (void)unused;
    Run run = run_of("", "drives: {theta: 90 deg + 40 rad/s * t}\n"
                         "springs: {k: {along: s, stiffness: 4000 N/m, length: -20 mm}}\n"
                         "stops: {s: {between: [3 mm, 1 m]}}\n");
    double pi = acos(-1), seat = (2 * pi - pi / 3 - pi / 2) / 40, back = (2 * pi + pi / 3 - pi / 2) / 40;
    assert_int_equal(yk_simulation_advance(run.sim, 0.5 * (seat + back)), YK_OK);
    CHECK_NEAR(run_value(&run, "s"), 0.003, 1e-14);
    CHECK_NEAR(run_value(&run, "heart.force"), 0, 0);
    assert_int_equal(yk_simulation_advance(run.sim, back + 0.01), YK_OK);
    CHECK_NEAR(run_value(&run, "s"), lift(pi / 2 + 40 * (back + 0.01)), 1e-15);
    assert_int_equal(yk_simulation_happening_count(run.sim), 4);
    CHECK_NEAR(yk_simulation_happening(run.sim, 0).time, seat, 1e-11);
    CHECK_NEAR(happening(&run, 1, YK_HAPPENING_LIFT_OFF).time, seat, 1e-11);
    CHECK_NEAR(happening(&run, 2, YK_HAPPENING_LANDING).time, back, 1e-10);
    assert_int_equal(yk_simulation_happening(run.sim, 3).kind, YK_HAPPENING_RELEASE);
    run_free(&run);
}

// An oscillating follower: the flight is a harmonic oscillation too, whichever way its coordinate counts.
static void a_rocker_flies_outwards(void **unused)
{
    (void)unused;
    for (int mirrored = 0; mirrored < 2; mirrored++) {
        char text[1200];
        const char *side = mirrored ? "-" : "", *other = mirrored ? "" : "-";
        snprintf(text, sizeof text,
                 "laws: {swing: {period: 360 deg, segments: [{formula: {to: 360 deg, s: 0.3 rad*(1 - cos(x))/2}}]}}\n"
                 "cams: {heart: {cam: shaft, follower: rocker, law: swing, roller: 10 mm, base: 45 mm, at: P}}\n"
                 "bodies:\n"
                 "  ground: {points: {O: [0, 0], Q: [%s90 mm, 40 mm]}}\n"
                 "  shaft:  {points: {O: [0, 0]}}\n"
                 "  rocker: {points: {Q: [0, 0], P: [%s90 mm, 15 mm]}, inertia: 1200 kg*mm^2}\n"
                 "joints: {O: {pin: [ground, shaft], angle: theta}, Q: {pin: [%s], angle: phi}}\n"
                 "drives: {theta: 400 rad/s * t}\n"
                 "springs: {k: {along: phi, stiffness: 30 N*m/rad, angle: -0.4 rad}}\n",
                 other, side, mirrored ? "rocker, ground" : "ground, rocker");
        Run run = run_of_text(text, run_options(1e-11));
        double o = sqrt(30 / 1.2e-3), u = 400; // A cos(u t) u^2 + o^2 (A (1 - cos u t) + 0.4) = 0, A = 0.15
        double t0 = acos(-(o * o * 0.55) / (0.15 * (u * u - o * o))) / u, t = t0 + 0.003;
        double start = 0.15 * (1 - cos(u * t0)) + 0.4, rate = 0.15 * u * sin(u * t0);
        assert_int_equal(yk_simulation_advance(run.sim, t), YK_OK);
        CHECK_NEAR(happening(&run, 0, YK_HAPPENING_LIFT_OFF).time, t0, 1e-9);
        CHECK_NEAR(run_value(&run, "phi"), start * cos(o * 0.003) + rate / o * sin(o * 0.003) - 0.4, 1e-9);
        run_free(&run);
    }
}

static void a_flight_is_saved_and_cloned(void **unused)
{
    (void)unused;
    static char bytes[1 << 16];
    Run run = run_of("", sprung), other = run_of("", sprung);
    assert_int_equal(yk_simulation_advance(run.sim, 0.012), YK_OK);
    happening(&run, 0, YK_HAPPENING_LIFT_OFF);
    size_t count = yk_simulation_save(run.sim, bytes, sizeof bytes);
    assert_true(count > 0 && count <= sizeof bytes);
    assert_int_equal(yk_simulation_restore(other.sim, bytes, count), YK_OK);
    assert_int_equal(yk_simulation_advance(run.sim, 0.05), YK_OK);
    assert_int_equal(yk_simulation_advance(other.sim, 0.05), YK_OK);
    assert_int_equal(yk_simulation_happening_count(run.sim), yk_simulation_happening_count(other.sim));
    assert_true(run_value(&run, "s") == run_value(&other, "s"));
    assert_true(run_value(&run, "s.rate") == run_value(&other, "s.rate"));
    assert_int_equal(yk_simulation_reset(other.sim), YK_OK);
    assert_int_equal(yk_simulation_advance(other.sim, 0.05), YK_OK);
    CHECK_NEAR(run_value(&run, "s"), run_value(&other, "s"), 1e-12);
    run_free(&run);
    run_free(&other);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_flight_follows_its_spring),   cmocka_unit_test(a_landing_keeps_the_momentum),
        cmocka_unit_test(a_follower_without_mass_stays), cmocka_unit_test(a_stop_takes_the_follower_off),
        cmocka_unit_test(a_rocker_flies_outwards),       cmocka_unit_test(a_flight_is_saved_and_cloned),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
