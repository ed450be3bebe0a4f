// Counterweights: those of Berkof and Lowen for a four-bar, a centre of mass that stands still, and the flywheel.
#include "check.h"
#include <stdlib.h>
#include <yoke/yoke.h>
#include "base/text.h"
#include "loads/loads.h"

typedef struct Machine {
    YkModel *model;
    YkMechanism *mech;
    YkState *state;
} Machine;

static Machine open_text(const char *text)
{
    YkProblems *problems = yk_problems_new();
    Machine m = {.model = yk_model_parse(text, strlen(text), "test.yaml", NULL, problems)};
    m.mech = m.model ? yk_mechanism_compile(m.model, NULL, problems) : NULL;
    if (!m.mech) print_error("%s\n%s", text, yk_problems_text(problems, 0));
    assert_non_null(m.mech);
    m.state = yk_state_new(m.mech);
    assert_int_equal(yk_state_set_time(m.state, 0, NULL), YK_OK);
    assert_true(yk_state_assemble(m.state) >= 0);
    yk_problems_free(problems);
    return m;
}
static void close_machine(Machine *m)
{
    yk_state_free(m->state);
    yk_mechanism_free(m->mech);
    yk_model_free(m->model);
}

// Moves the input by a turn (or less, as told) and returns how far the centre of mass moves, m.
static double wandering(const char *text, double turn)
{
    Machine m = open_text(text);
    YkVec first = {0, 0};
    double worst = 0, start = yk_state_input(m.state, 0).position;
    for (int k = 0; k < 97; k++) {
        YkMotion goal = {.position = start + k * turn / 96};
        assert_true(yk_state_move_to(m.state, &goal, NULL, NULL) >= 0);
        YkVec sum = {0, 0};
        double mass = 0;
        for (size_t b = 1; b < m.model->body_count; b++) {
            YkBodyMotion motion = yk_body_motion(m.mech, &m.state->space, b);
            if (!m.model->bodies[b].has_mass) continue;
            mass += m.model->bodies[b].mass;
            sum = yk_add(sum, yk_scale(m.model->bodies[b].mass, motion.at));
        }
        sum = yk_scale(1 / mass, sum);
        if (k == 0) first = sum;
        worst = fmax(worst, yk_norm(yk_sub(sum, first)));
    }
    close_machine(&m);
    return worst;
}

static const char berkof[] =
    "bodies:\n  ground: {points: {A0: [0, 0], B0: [5.5, 0]}}\n  crank: {points: {A0: [0, 0], A: [2, 0]}}\n"
    "  rod: {points: {A: [0, 0], B: [6, 0]}, mass: 0.02, center: [3*cos(15 deg), 3*sin(15 deg)], inertia: 0.01}\n"
    "  rocker: {points: {B0: [0, 0], B: [3, 0]}}\n"
    "joints:\n  A0: {pin: [ground, crank], angle: theta}\n  A: {pin: [crank, rod], angle: phi}\n"
    "  B0: {pin: [ground, rocker], angle: psi}\n  B: {pin: [rod, rocker]}\n"
    "drives: {theta: 2 rad/s * t}\nstart: {phi: 0.8, psi: 2}\n";

static void a_four_bar_gets_the_counterweights_of_berkof_and_lowen(void **state)
{
    (void)state;
    Machine m = open_text(berkof);
    YkBalancing *b = yk_balancing_new(m.state, NULL, NULL);
    assert_non_null(b);
    assert_true(yk_balancing_is_full(b));
    assert_int_equal(yk_balancing_count(b), 2);
    // r2 = r e^(i 15 deg) in the coupler: m2 a2 - m l |..|: crank: -m (l - r2) a / l, rocker: -m r2 c / l.
    YkVec r = yk_scale(3, yk_unit(15 * YK_PI / 180));
    YkVec crank = yk_scale(-.02 * 2 / 6, yk_sub(yk_vec(6, 0), r)), rocker = yk_scale(-.02 * 3 / 6, r);
    for (size_t k = 0; k < 2; k++) {
        YkCounterweight w = yk_balancing_at(b, k);
        YkVec expected = w.body == 1 ? crank : rocker, own = yk_scale(w.product, yk_unit(w.angle));
        CHECK_NEAR(own.x, expected.x, 1e-14);
        CHECK_NEAR(own.y, expected.y, 1e-14);
        CHECK_NEAR(w.mass * w.radius, w.product, 1e-16);
    }
    assert_true(wandering(berkof, 2 * YK_PI) > 1);
    CHECK_NEAR(wandering(yk_balancing_model(b), 2 * YK_PI), 0, 1e-14);
    assert_true(yk_balancing_before(b).force > .1);
    CHECK_NEAR(yk_balancing_after(b).force, 0, 1e-12);
    yk_balancing_free(b);
    close_machine(&m);
}

// A machine that is turned as a whole is shaken as before, and needs the same counterweights in the axes of its bodies.
static void a_machine_that_is_turned_needs_the_same_counterweights(void **state)
{
    (void)state;
    YkBalancing *upright = NULL;
    for (int k = 0; k < 5; k++) {
        char text[1000];
        double a = 0.5 * YK_PI * k - (k == 4 ? 1 : 0);
        snprintf(text, sizeof text,
                 "bodies:\n  ground: {points: {A0: [0, 0], B0: [5.5*cos(%.17g), 5.5*sin(%.17g)]}}\n"
                 "  crank: {points: {A0: [0, 0], A: [2, 0]}}\n"
                 "  rod: {points: {A: [0, 0], B: [6, 0]}, mass: 0.02, center: [3, 1], inertia: 0.01}\n"
                 "  rocker: {points: {B0: [0, 0], B: [3, 0]}}\n"
                 "joints:\n  A0: {pin: [ground, crank], angle: theta}\n  A: {pin: [crank, rod], angle: phi}\n"
                 "  B0: {pin: [ground, rocker], angle: psi}\n  B: {pin: [rod, rocker]}\n"
                 "drives: {theta: %.17g + 2 rad/s * t}\nstart: {phi: 0.8, psi: %.17g}\n",
                 a, a, a, a + 2);
        Machine m = open_text(text);
        YkBalancing *b = yk_balancing_new(m.state, NULL, NULL);
        assert_non_null(b);
        if (k == 0) upright = b;
        assert_true(yk_balancing_is_full(b));
        assert_int_equal(yk_balancing_count(b), 2);
        for (size_t i = 0; i < 2; i++) {
            YkCounterweight w = yk_balancing_at(b, i), due = yk_balancing_at(upright, i);
            assert_int_equal(w.body, due.body);
            CHECK_NEAR(w.product, due.product, 1e-14);
            CHECK_NEAR(w.angle, due.angle, 1e-12);
        }
        YkShakingPeaks peaks = yk_balancing_before(b), due = yk_balancing_before(upright);
        CHECK_NEAR(peaks.force, due.force, 1e-10 * due.force);
        CHECK_NEAR(peaks.moment, due.moment, 1e-10 * due.moment);
        CHECK_NEAR(peaks.torque, due.torque, 1e-10 * due.torque);
        CHECK_NEAR(yk_balancing_flywheel(b), yk_balancing_flywheel(upright), 1e-9 * yk_balancing_flywheel(upright));
        for (size_t n = 1; n <= YK_SHAKING_ORDERS; n++) {
            YkShakingOrder order = yk_balancing_order(b, n, false), was = yk_balancing_order(upright, n, false);
            CHECK_NEAR(order.with, was.with, 1e-12);
            CHECK_NEAR(order.against, was.against, 1e-12);
            CHECK_NEAR(sin(order.direction - was.direction - a), 0, 1e-8);
        }
        if (k > 0) yk_balancing_free(b);
        close_machine(&m);
    }
    yk_balancing_free(upright);
}

// Lanchester's balancer: the yoke of a crank moves as the sum of two vectors that turn against each other, so a weight
// on the crank and one on a wheel that turns against it take half of it each, whatever the direction of the yoke.
static void wheels_against_each_other_balance_a_scotch_yoke(void **state)
{
    (void)state;
    for (int k = 0; k < 5; k++) {
        char text[1200];
        double way = 45 * k * YK_PI / 180, across = way + YK_PI / 2;
        snprintf(text, sizeof text,
                 "bodies:\n  ground: {points: {O: [0, 0], P: [0.2, 0]}}\n  crank: {points: {O: [0, 0], A: [0.05, 0]}}\n"
                 "  yoke: {points: {S: [0, 0]}, mass: 3}\n  wheel: {points: {P: [0, 0]}}\n"
                 "joints:\n  O: {pin: [ground, crank], angle: theta}\n  P: {pin: [ground, wheel], angle: phi}\n"
                 "  R: {slide: [ground, yoke], along: %.17g rad, distance: x}\n"
                 "  A: {pin-slot: [yoke, crank], at: A, from: S, along: %.17g rad}\n"
                 "gears: {g: {mesh: [crank, wheel], teeth: [40, 40], module: 5 mm}}\n"
                 "drives: {theta: 0.5 + 8 rad/s * t}\nstart: {x: %.17g}\n",
                 way, across, 0.05 * cos(0.5 - way));
        Machine m = open_text(text);
        YkBalancing *b = yk_balancing_new(m.state, NULL, NULL);
        assert_non_null(b);
        CHECK_NEAR(yk_balancing_before(b).force, 3 * 0.05 * 64, 1e-9);
        assert_true(yk_balancing_is_full(b));
        assert_int_equal(yk_balancing_count(b), 2);
        for (size_t i = 0; i < 2; i++) CHECK_NEAR(yk_balancing_at(b, i).product, 3 * 0.05 / 2, 1e-12);
        CHECK_NEAR(yk_balancing_after(b).force, 0, 1e-9);
        yk_balancing_free(b);
        close_machine(&m);
    }
}

static char *read_file(const char *path)
{
    FILE *file = fopen(path, "rb");
    assert_non_null(file);
    char *text = calloc(1, 100000);
    assert_true(fread(text, 1, 99999, file) > 0);
    fclose(file);
    return text;
}

static void a_six_bar_is_balanced_with_counterweights_on_three_bodies_or_more(void **state)
{
    (void)state;
    char *text = read_file(YOKE_ROOT "/examples/watt-with-masses.yaml");
    Machine m = open_text(text);
    YkBalancing *b = yk_balancing_new(m.state, NULL, NULL);
    assert_non_null(b);
    assert_true(yk_balancing_is_full(b));
    assert_true(yk_balancing_count(b) >= 3); // half of the six bodies
    CHECK_NEAR(wandering(yk_balancing_model(b), .08), 0, 1e-11 * yk_mechanism_size(m.mech));
    yk_balancing_free(b);
    close_machine(&m);
    free(text);
}

// Of the piston's acceleration the part that turns with the crank is that of a very long rod: a counterweight on the
// crank makes the mean square of the force least where it balances half of the piston.
static void a_crank_alone_balances_half_of_the_piston(void **state)
{
    (void)state;
    Machine m = open_text("bodies:\n  ground: {points: {O: [0, 0]}}\n"
                          "  crank: {points: {O: [0, 0], A: [.1, 0]}, mass: 1, center: [.04, 0], inertia: 0}\n"
                          "  rod: {points: {A: [0, 0], B: [.25, 0]}}\n  piston: {points: {B: [0, 0]}, mass: 3}\n"
                          "joints:\n  O: {pin: [ground, crank], angle: theta}\n  A: {pin: [crank, rod], angle: phi}\n"
                          "  S: {slide: [ground, piston], along: x, distance: s}\n  B: {pin: [rod, piston]}\n"
                          "drives: {theta: 10 rad/s * t}\nstart: {phi: 0, s: .3}\n");
    YkBalancingOptions options = yk_default_balancing_options();
    options.weight[0] = 1;
    YkBalancing *b = yk_balancing_new(m.state, &options, NULL);
    assert_int_equal(yk_balancing_count(b), 1);
    YkCounterweight w = yk_balancing_at(b, 0);
    CHECK_NEAR(w.product, 1 * .04 + .5 * 3 * .1, 1e-12);
    CHECK_NEAR(fabs(yk_remainder(w.angle, 2 * YK_PI)), YK_PI, 1e-9);
    yk_balancing_free(b);
    close_machine(&m);
}

// The mean squares of force, moment and effort of a four-bar with point masses at (x, y) and (u, v) of crank and
// rocker, as the engine has them.
static void mean_squares(const double p[4], double radius[2], double mean[3])
{
    char text[2000];
    double mass[2] = {yk_hypot(p[0], p[1]) / radius[0] + 1e-12, yk_hypot(p[2], p[3]) / radius[1] + 1e-12};
    snprintf(text, sizeof text,
             "bodies:\n  ground: {points: {A0: [0, 0], B0: [.55, 0]}}\n"
             "  crank: {points: {A0: [0, 0], A: [.2, 0]}, mass: %.17g, center: [%.17g, %.17g], inertia: 0}\n"
             "  rod: {points: {A: [0, 0], B: [.6, 0]}, mass: 2, center: [.3, .05], inertia: .03}\n"
             "  rocker: {points: {B0: [0, 0], B: [.3, 0]}, mass: %.17g, center: [%.17g, %.17g], inertia: 0}\n"
             "joints:\n  A0: {pin: [ground, crank], angle: theta}\n  A: {pin: [crank, rod], angle: phi}\n"
             "  B0: {pin: [ground, rocker], angle: psi}\n  B: {pin: [rod, rocker]}\n"
             "drives: {theta: 2 rad/s * t}\nstart: {phi: 0.8, psi: 2}\n",
             mass[0], p[0] / mass[0], p[1] / mass[0], mass[1], p[2] / mass[1], p[3] / mass[1]);
    Machine m = open_text(text);
    YkDynamics *dynamics = yk_dynamics_new(m.mech, NULL);
    mean[0] = mean[1] = mean[2] = 0;
    for (int k = 0; k < 90; k++) {
        yk_state_set_time(m.state, k * YK_PI / 90, NULL);
        assert_true(yk_state_solve(m.state) >= 0);
        assert_true(yk_dynamics_solve(dynamics, m.state, YK_METHOD_NEWTON_EULER) >= 0);
        YkWrench shaking = yk_dynamics_shaking(dynamics); // about the origin, which is the input's pivot
        double effort = yk_dynamics_effort(dynamics, yk_input_coordinate(m.mech, 0));
        mean[0] += (shaking.force[0] * shaking.force[0] + shaking.force[1] * shaking.force[1]) / 90;
        mean[1] += shaking.moment * shaking.moment / 90;
        mean[2] += effort * effort / 90;
    }
    yk_dynamics_free(dynamics);
    close_machine(&m);
}

// No neighbour of the counterweights has a smaller weighted sum. The moment of the drive acts on the frame as well.
static void a_compromise_is_the_least_in_its_neighbourhood(void **state)
{
    (void)state;
    static const char text[] =
        "bodies:\n  ground: {points: {A0: [0, 0], B0: [.55, 0]}}\n  crank: {points: {A0: [0, 0], A: [.2, 0]}}\n"
        "  rod: {points: {A: [0, 0], B: [.6, 0]}, mass: 2, center: [.3, .05], inertia: .03}\n"
        "  rocker: {points: {B0: [0, 0], B: [.3, 0]}}\n"
        "joints:\n  A0: {pin: [ground, crank], angle: theta}\n  A: {pin: [crank, rod], angle: phi}\n"
        "  B0: {pin: [ground, rocker], angle: psi}\n  B: {pin: [rod, rocker]}\n"
        "drives: {theta: 2 rad/s * t}\nstart: {phi: 0.8, psi: 2}\n";
    static const double weights[][3] = {{1, 1, 0}, {1, 0, 1}, {0.5, 0.3, 2}};
    for (size_t c = 0; c < 3; c++) {
        Machine m = open_text(text);
        YkBalancingOptions options = yk_default_balancing_options();
        options.steps = 90;
        memcpy(options.weight, weights[c], sizeof options.weight);
        YkBalancing *b = yk_balancing_new(m.state, &options, NULL);
        assert_int_equal(yk_balancing_count(b), c == 0 ? 2 : 1); // where the effort counts, none on the rocker
        double p[4] = {0}, radius[2] = {0.1, 0.15}, before[3], mean[3], least = 0;
        mean_squares(p, radius, before);
        for (size_t k = 0; k < yk_balancing_count(b); k++) {
            YkCounterweight w = yk_balancing_at(b, k);
            size_t side = w.body == 1 ? 0 : 1;
            radius[side] = w.radius;
            p[2 * side] = w.product * yk_cos(w.angle);
            p[2 * side + 1] = w.product * yk_sin(w.angle);
        }
        mean_squares(p, radius, mean);
        for (size_t i = 0; i < 3; i++) least += weights[c][i] * mean[i] / before[i];
        assert_true(least < weights[c][0] + weights[c][1] + weights[c][2]);
        for (size_t k = 0; k < 8; k++) {
            double q[4], sum = 0;
            memcpy(q, p, sizeof q);
            q[k / 2] += (k % 2 ? 1e-3 : -1e-3) * yk_hypot(yk_hypot(p[0], p[1]), yk_hypot(p[2], p[3]));
            mean_squares(q, radius, mean);
            for (size_t i = 0; i < 3; i++) sum += weights[c][i] * mean[i] / before[i];
            assert_true(sum > least);
        }
        yk_balancing_free(b);
        close_machine(&m);
    }
}

static const char slider[] =
    "bodies:\n  ground: {points: {O: [0, 0]}}\n  crank: {points: {O: [0, 0], A: [.1, 0]}, mass: 1, center: [.04, 0], "
    "inertia: 0}\n"
    "  rod: {points: {A: [0, 0], B: [.4, 0]}, mass: 2, center: [.15, 0], inertia: .02}\n  piston: {points: {B: [0, "
    "0]}, mass: 3}\n"
    "joints:\n  O: {pin: [ground, crank], angle: theta}\n  A: {pin: [crank, rod], angle: phi}\n"
    "  S: {slide: [ground, piston], along: x, distance: s}\n  B: {pin: [rod, piston]}\n"
    "drives: {theta: 10 rad/s * t}\nstart: {phi: 0, s: .5}\n";

// The rod's counterweight brings the masses of rod and piston to A; that of the crank the whole to O.
static void a_slider_crank_is_balanced_by_its_rod_and_its_crank(void **state)
{
    (void)state;
    Machine m = open_text(slider);
    YkBalancing *b = yk_balancing_new(m.state, NULL, NULL);
    assert_true(yk_balancing_is_full(b));
    assert_int_equal(yk_balancing_count(b), 2);
    double rod = 2 * .15 + 3 * .4, weight = 0, crank = 0;
    for (size_t k = 0; k < 2; k++) {
        YkCounterweight w = yk_balancing_at(b, k);
        CHECK_NEAR(fabs(yk_remainder(w.angle, 2 * YK_PI)), YK_PI, 1e-9);
        if (w.body == 2) {
            CHECK_NEAR(w.product, rod, 1e-12);
            weight = w.mass;
        } else {
            crank = w.product;
        }
    }
    CHECK_NEAR(crank, 1 * .04 + (2 + 3 + weight) * .1, 1e-12);
    CHECK_NEAR(wandering(yk_balancing_model(b), 2 * YK_PI), 0, 1e-13);
    yk_balancing_free(b);
    close_machine(&m);
}

// Khurmi & Gupta 16.13: T = 5000 + 1500 sin(3 theta) N m at 300 rpm swings the energy by 2 * 1500/3 = 1000 J. The
// extremes lie between the poses.
static void a_flywheel_for_a_given_torque_has_six_digits(void **state)
{
    (void)state;
    static const double starts[] = {0, 0.0031, 0.4};
    for (size_t k = 0; k < 3; k++) {
        char text[512];
        snprintf(text, sizeof text,
                 "bodies: {ground: {points: {O: [0, 0]}}, shaft: {points: {O: [0, 0]}, mass: 1, inertia: 1000}}\n"
                 "joints: {O: {pin: [ground, shaft], angle: q}}\nefforts: {q: -5000 N*m - 1500 N*m * sin(3*q)}\n"
                 "drives: {q: %g rad + 300 rpm * t}\n",
                 starts[k]);
        Machine m = open_text(text);
        YkBalancing *b = yk_balancing_new(m.state, NULL, NULL);
        CHECK_NEAR(yk_balancing_flywheel(b) * .05 * 100 * YK_PI * YK_PI, 1000, 1e-3);
        CHECK_NEAR(yk_balancing_before(b).torque, 6500, 1e-8);
        yk_balancing_free(b);
        close_machine(&m);
    }
}

// A crank alone that lifts a weight: T = m g r cos(theta), which swings the energy by 2 m g r.
static void a_flywheel_takes_up_the_torques_energy(void **state)
{
    (void)state;
    Machine m = open_text(
        "gravity: [0, -10]\nbodies: {ground: {points: {O: [0, 0]}}, crank: {points: {O: [0, 0], A: [.5, 0]}, mass: 2, "
        "center: "
        "[.5, 0], inertia: 0}}\njoints: {O: {pin: [ground, crank], angle: theta}}\ndrives: {theta: 3 rad/s * t}\n");
    YkBalancingOptions options = yk_default_balancing_options();
    options.fluctuation = .1;
    YkBalancing *b = yk_balancing_new(m.state, &options, NULL);
    CHECK_NEAR(yk_balancing_flywheel(b), 2 * 2 * 10 * .5 / (.1 * 9), 1e-6);
    CHECK_NEAR(yk_balancing_before(b).torque, 10, 1e-12);
    CHECK_NEAR(yk_balancing_before(b).force, 2 * .5 * 9, 1e-12);
    assert_int_equal(yk_balancing_count(b), 1);
    CHECK_NEAR(yk_balancing_at(b, 0).product, 1, 1e-14);
    CHECK_NEAR(yk_balancing_after(b).torque, 0, 1e-12);
    yk_balancing_free(b);
    close_machine(&m);
}

// In line, all mass in the piston: m r w^2 (cos a + A2 cos 2a - ...) with A2 = L + L^3/4 + 15 L^5/128 + 35 L^7/512 +
// ... of the ratio L = r/l; each order turns half with the crank, half against it. A counterweight on the crank takes
// away the first half.
static void a_slider_cranks_orders_are_told_apart(void **state)
{
    (void)state;
    Machine m = open_text("bodies:\n  ground: {points: {O: [0, 0]}}\n  crank: {points: {O: [0, 0], A: [.1, 0]}}\n"
                          "  rod: {points: {A: [0, 0], B: [.5, 0]}}\n  piston: {points: {B: [0, 0]}, mass: 3}\n"
                          "joints:\n  O: {pin: [ground, crank], angle: theta}\n  A: {pin: [crank, rod], angle: phi}\n"
                          "  S: {slide: [ground, piston], along: 30 deg, distance: s}\n  B: {pin: [rod, piston]}\n"
                          "drives: {theta: 0.4 + 10 rad/s * t}\nstart: {phi: 0, s: .6}\n");
    YkBalancingOptions options = yk_default_balancing_options();
    options.weight[0] = 1;
    YkBalancing *b = yk_balancing_new(m.state, &options, NULL);
    assert_int_equal(yk_balancing_turns(b), 1);
    CHECK_NEAR(yk_balancing_before(b).force, 3 * .1 * 100 * (1 + .2), 1e-11); // at the dead centre, between the poses
    double L = .2, L3 = L * L * L, L5 = L3 * L * L, L7 = L5 * L * L, first = 3 * .1 * 100;
    double second = first * (L + L3 / 4 + 15 * L5 / 128 + 35 * L7 / 512 + 315 * L7 * L * L / 8192);
    double fourth = first * (L3 / 4 + 3 * L5 / 16 + 35 * L7 / 256); // of the next powers, 1e-7 of it
    const double amplitude[] = {first, second, 0, fourth, 0};
    for (size_t n = 1; n <= 5; n++) {
        YkShakingOrder before = yk_balancing_order(b, n, false), after = yk_balancing_order(b, n, true);
        double near = n == 4 ? 1e-4 * fourth : 1e-6;
        CHECK_NEAR(before.with, amplitude[n - 1] / 2, near);
        CHECK_NEAR(before.against, amplitude[n - 1] / 2, near);
        CHECK_NEAR(after.with, n == 1 ? 0 : before.with, 1e-9);
        CHECK_NEAR(after.against, before.against, 1e-9);
        if (amplitude[n - 1] > 0) CHECK_NEAR(yk_sin(before.direction - YK_PI / 6), 0, 1e-9); // along the line
    }
    assert_true(isnan(yk_balancing_order(b, 0, false).with) && isnan(yk_balancing_order(b, 7, false).with));
    options.steps = 1; // so few poses would take the sixth order for the second
    YkBalancing *few = yk_balancing_new(m.state, &options, NULL);
    for (size_t n = 1; n <= YK_SHAKING_ORDERS; n++)
        CHECK_NEAR(yk_balancing_order(few, n, false).with, yk_balancing_order(b, n, false).with, 1e-9);
    yk_balancing_free(few);
    yk_balancing_free(b);
    close_machine(&m);
}

// The energy that swings about the mean of a torque given at equal steps of a cycle, J.
static double swing_of(const double *torque, size_t count, double step)
{
    double mean = 0, energy = 0, low = 0, high = 0;
    for (size_t k = 0; k < count; k++) mean += torque[k] / (double)count;
    for (size_t k = 0; k < count; k++) {
        energy += step * ((torque[k] + torque[(k + 1) % count]) / 2 - mean);
        low = fmin(low, energy);
        high = fmax(high, energy);
    }
    return high - low;
}

// A punch that resists with 3 kN m for a sixth of a turn, as the examples of textbooks have it: a constant motor gives
// its mean all the time, so that the wheel gives back 5/6 of the work, which its own edges round off.
static void a_punch_presss_flywheel_gives_back_five_sixths_of_the_work(void **state)
{
    (void)state;
    Machine m = open_text(
        "laws: {punch: {period: 360 deg, between: linear, table: [[0 deg, 0], [59 deg, 0], [61 deg, -3000 N*m], "
        "[119 deg, -3000 N*m], [121 deg, 0], [359 deg, 0]]}}\n"
        "bodies: {ground: {points: {O: [0, 0]}}, shaft: {points: {O: [0, 0]}, mass: 1, inertia: 1}}\n"
        "joints: {O: {pin: [ground, shaft], angle: theta}}\n"
        "efforts: {theta: {law: punch, of: theta}}\ndrives: {theta: 20 rad/s * t}\n");
    YkBalancingOptions options = yk_default_balancing_options();
    options.fluctuation = 0.1;
    YkBalancing *b = yk_balancing_new(m.state, &options, NULL);
    double work = 3000 * YK_PI / 3, mean = work / (2 * YK_PI);
    // Where the torque lies above its mean: the edges are 2 deg wide, and the mean is a sixth of the top.
    double edge = mean / 3000 * 2 * YK_PI / 180, above = YK_PI / 3 + 2 * YK_PI / 180 - 2 * edge;
    double given = (3000 - mean) * (above + 58 * YK_PI / 180) / 2; // a trapezium
    CHECK_NEAR(yk_balancing_flywheel(b), given / (0.1 * 400), 1e-9);
    CHECK_NEAR(given, work * 5 / 6, 0.02 * work);
    yk_balancing_free(b);
    close_machine(&m);
}

static const double gas[][2] = {{0, -9000},   {15, -16000}, {30, -12000}, {60, -5200},  {90, -2800},
                                {130, -1500}, {180, -300},  {200, -60},   {360, -40},   {380, 60},
                                {540, 50},    {600, -250},  {650, -900},  {690, -3200}, {720, -9000}};

static double gas_force(double degrees)
{
    size_t k = 1;
    degrees -= 720 * floor(degrees / 720);
    while (gas[k][0] < degrees) k++;
    double part = (degrees - gas[k - 1][0]) / (gas[k][0] - gas[k - 1][0]);
    return gas[k - 1][1] + part * (gas[k][1] - gas[k - 1][1]);
}

// Of one cylinder with crank r and rod l: the gas force times dx/dtheta, at the crank's angle from dead centre.
static double gas_torque(double degrees)
{
    const double r = 0.04, l = 0.14, a = degrees * YK_PI / 180, s = r * yk_sin(a), c = r * yk_cos(a);
    return gas_force(degrees) * (-s - s * c / sqrt(l * l - s * s));
}

// Four strokes take two turns. Three cylinders that fire every 240 deg swing much less energy than one.
static void an_engines_flywheel_follows_from_its_table(void **state)
{
    (void)state;
    enum { FINE = 7200 };
    double *torque = calloc(FINE, sizeof *torque), inertia[2];
    for (size_t cylinders = 1; cylinders <= 3; cylinders += 2) {
        YkText text = {0};
        yk_text_puts(&text, "laws:\n  gas: {period: 720 deg, between: linear, table: [");
        for (size_t k = 0; k + 1 < sizeof gas / sizeof *gas; k++)
            yk_text_format(&text, "%s[%e deg, %e N]", k ? ", " : "", gas[k][0], gas[k][1]);
        yk_text_puts(&text, "]}\nbodies:\n  ground: {points: {O: [0, 0]}}\n  crank: {points: {O: [0, 0], A1: [.04, 0], "
                            "A2: [.04*cos(240 deg), .04*sin(240 deg)], A3: [.04*cos(120 deg), .04*sin(120 deg)]}, "
                            "mass: 3, inertia: .1}\n");
        for (size_t k = 1; k <= cylinders; k++)
            yk_text_format(&text,
                           "  rod%z: {points: {A%z: [0, 0], B%z: [.14, 0]}}\n  piston%z: {points: {B%z: [0, 0]}}\n", k,
                           k, k, k, k);
        yk_text_puts(&text, "joints:\n  O: {pin: [ground, crank], angle: theta}\n");
        for (size_t k = 1; k <= cylinders; k++)
            yk_text_format(&text,
                           "  A%z: {pin: [crank, rod%z], angle: p%z}\n  B%z: {pin: [rod%z, piston%z]}\n"
                           "  R%z: {slide: [ground, piston%z], along: x, distance: x%z}\n",
                           k, k, k, k, k, k, k, k, k);
        yk_text_puts(&text, "efforts:\n");
        for (size_t k = 1; k <= cylinders; k++)
            yk_text_format(&text, "  x%z: {law: gas, of: theta + %d deg}\n", k, 240 * (int)(k - 1));
        yk_text_puts(&text, "drives: {theta: 300 rad/s * t}\nstart: {");
        for (size_t k = 1; k <= cylinders; k++)
            yk_text_format(&text, "%sp%z: %e deg, x%z: 0.13", k > 1 ? ", " : "", k,
                           k == 1   ? 0.0
                           : k == 2 ? 135.0
                                    : -135.0,
                           k);
        yk_text_puts(&text, "}\n");
        Machine m = open_text(yk_text_get(&text));
        YkBalancingOptions options = yk_default_balancing_options();
        options.steps = 720;
        YkBalancing *b = yk_balancing_new(m.state, &options, NULL);
        assert_int_equal(yk_balancing_turns(b), 2);
        for (size_t k = 0; k < FINE; k++) {
            torque[k] = 0;
            for (size_t i = 0; i < cylinders; i++) torque[k] += gas_torque((double)k / 10 + 240 * (double)i);
        }
        double swing = swing_of(torque, FINE, YK_PI / 1800);
        inertia[cylinders / 2] = yk_balancing_flywheel(b);
        CHECK_NEAR(yk_balancing_flywheel(b) * 0.05 * 9e4, swing, 1e-3 * swing);
        yk_balancing_free(b);
        close_machine(&m);
        yk_text_free(&text);
    }
    assert_true(inertia[1] < 0.75 * inertia[0]);
    free(torque);
}

// The coupler point of a crank-rocker drives a second dyad: all bodies are pinned to the ground through pins.
static void a_stephenson_six_bar_that_turns_through_is_balanced(void **state)
{
    (void)state;
    static const char text[] =
        "bodies:\n  ground: {points: {O2: [0, 0], O4: [4, 0], O6: [6, 2.5]}}\n"
        "  crank: {points: {O2: [0, 0], A: [1, 0]}, mass: 2, center: [.4, .1], inertia: .2}\n"
        "  coupler: {points: {A: [0, 0], B: [3.5, 0], C: [2, 1.5]}, mass: 5, center: [1.8, .6], inertia: 4}\n"
        "  rocker: {points: {O4: [0, 0], B: [3, 0]}, mass: 3, center: [1.4, -.2], inertia: 2}\n"
        "  link: {points: {C: [0, 0], D: [4.5, 0]}, mass: 4, center: [2.1, .3], inertia: 5}\n"
        "  output: {points: {O6: [0, 0], D: [2.5, 0]}, mass: 2.5, center: [1.1, 0], inertia: 1}\n"
        "joints:\n  O2: {pin: [ground, crank], angle: theta2}\n  A: {pin: [crank, coupler], angle: theta3}\n"
        "  O4: {pin: [ground, rocker], angle: theta4}\n  B: {pin: [coupler, rocker]}\n"
        "  C: {pin: [coupler, link], angle: theta5}\n  O6: {pin: [ground, output], angle: theta6}\n"
        "  D: {pin: [link, output]}\ndrives: {theta2: 60 deg + 60 rpm * t}\n"
        "start: {theta3: -25 deg, theta4: 100 deg, theta5: -15 deg, theta6: 105 deg}\n";
    Machine m = open_text(text);
    YkBalancing *b = yk_balancing_new(m.state, NULL, NULL);
    assert_non_null(b);
    assert_true(yk_balancing_is_full(b));
    assert_true(yk_balancing_count(b) >= 3);
    assert_true(wandering(text, 2 * YK_PI) > .1);
    CHECK_NEAR(wandering(yk_balancing_model(b), 2 * YK_PI), 0, 1e-12);
    CHECK_NEAR(yk_balancing_after(b).force, 0, 1e-9 * yk_balancing_before(b).force);
    yk_balancing_free(b);
    close_machine(&m);
}

static void machines_without_masses_are_refused(void **state)
{
    (void)state;
    YkProblems *problems = yk_problems_new();
    Machine m = open_text("bodies: {crank: {}}\njoints: {O: {pin: [ground, crank], angle: theta}}\n");
    assert_null(yk_balancing_new(m.state, NULL, problems));
    assert_int_equal(yk_problems_get(problems, 0)->code, 849);
    assert_null(yk_balancing_new(NULL, NULL, problems));
    assert_int_equal(yk_balancing_count(NULL), 0);
    assert_null(yk_balancing_model(NULL));
    yk_balancing_free(NULL);
    close_machine(&m);
    yk_problems_free(problems);
}

// 97 and 101 teeth meet as before only after 101 turns, so one turn says nothing of the orders.
static void orders_of_what_never_repeats_are_none(void **state)
{
    (void)state;
    Machine m =
        open_text("bodies:\n  ground: {points: {O: [0, 0], P: [0.198, 0]}}\n"
                  "  crank: {points: {O: [0, 0]}, mass: 1, center: [.1, 0]}\n"
                  "  wheel: {points: {P: [0, 0]}, mass: 2, center: [.1, 0]}\n"
                  "joints:\n  O: {pin: [ground, crank], angle: theta}\n  P: {pin: [ground, wheel], angle: phi}\n"
                  "gears: {G: {mesh: [crank, wheel], teeth: [97, 101], module: 0.002}}\n"
                  "drives: {theta: 0.4 + 10 rad/s * t}\n");
    YkBalancing *b = yk_balancing_new(m.state, NULL, NULL);
    assert_non_null(b);
    assert_int_equal(yk_balancing_turns(b), 0);
    for (size_t n = 1; n <= YK_SHAKING_ORDERS; n++)
        assert_true(isnan(yk_balancing_order(b, n, false).with) && isnan(yk_balancing_order(b, n, true).against));
    yk_balancing_free(b);
    close_machine(&m);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(orders_of_what_never_repeats_are_none),
        cmocka_unit_test(a_crank_alone_balances_half_of_the_piston),
        cmocka_unit_test(a_compromise_is_the_least_in_its_neighbourhood),
        cmocka_unit_test(a_four_bar_gets_the_counterweights_of_berkof_and_lowen),
        cmocka_unit_test(a_machine_that_is_turned_needs_the_same_counterweights),
        cmocka_unit_test(wheels_against_each_other_balance_a_scotch_yoke),
        cmocka_unit_test(a_six_bar_is_balanced_with_counterweights_on_three_bodies_or_more),
        cmocka_unit_test(a_slider_crank_is_balanced_by_its_rod_and_its_crank),
        cmocka_unit_test(a_flywheel_takes_up_the_torques_energy),
        cmocka_unit_test(a_slider_cranks_orders_are_told_apart),
        cmocka_unit_test(a_punch_presss_flywheel_gives_back_five_sixths_of_the_work),
        cmocka_unit_test(an_engines_flywheel_follows_from_its_table),
        cmocka_unit_test(a_stephenson_six_bar_that_turns_through_is_balanced),
        cmocka_unit_test(a_flywheel_for_a_given_torque_has_six_digits),
        cmocka_unit_test(machines_without_masses_are_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
