// Springs by laws of their own, against springs of the same stiffness and damping, and against virtual work.
#include <stdio.h>
#include "dynamics/rig.h"

#define LEVER                                                                                                          \
    "gravity: [0, -9.81]\nlaws:\n  line: {table: [[-20 m, -1000], [20 m, 1000]], between: linear}\nbodies:\n"          \
    "  ground: {points: {P: [0, 1], O: [0, 0]}}\n"                                                                     \
    "  crank: {points: {P: [0, 0], A: [0.4, 0]}, mass: 1, inertia: 0.1, center: [0.2, 0]}\n"                           \
    "  block: {points: {A: [0, 0]}, mass: 0.5, inertia: 0.03}\n"                                                       \
    "  lever: {points: {O: [0, 0], T: [0.7, 0.1]}, mass: 1, inertia: 0.2, center: [0.3, 0]}\n"                         \
    "joints:\n  P: {pin: [ground, crank], angle: theta1}\n  A: {pin: [crank, block]}\n"                                \
    "  O: {pin: [ground, lever], angle: theta2}\n  S: {slide: [lever, block], along: x, distance: d}\n"                \
    "start: {theta1: 0.5, theta1.rate: 1, theta2: 1.3}\nsprings:\n"

static Rig rig_with(const char *springs)
{
    char text[2000];
    snprintf(text, sizeof text, LEVER "%s", springs);
    return rig_of_text(text);
}

static double value_at(Rig *rig, const char *name)
{
    return yk_dynamics_channel(rig->dynamics, rig->state, rig_channel(rig->mech, name));
}

static void move(Rig *rig, double angle, double rate)
{
    yk_state_set_input(rig->state, 0, (YkMotion){angle, rate, 0});
    assert_int_equal(yk_state_solve(rig->state), YK_OK);
    assert_int_equal(yk_dynamics_solve(rig->dynamics, rig->state, YK_METHOD_REDUCED), YK_OK);
}

// A force written out pulls as stiffness, free length and damping do: the same accelerations and reactions.
static void a_straight_law_is_a_spring(void **unused)
{
    (void)unused;
    static const char *const pairs[][2] = {
        {"  s: {between: [lever.T, crank.A], stiffness: 50, length: 0.3, damping: 2}\n",
         "  s: {between: [lever.T, crank.A], force: 50 N/m * (length - 0.3 m) + 2 N*s/m * rate}\n"},
        {"  s: {between: [lever.T, crank.A], stiffness: 50, length: 0.3, damping: 2}\n",
         "  s: {between: [lever.T, crank.A], force: {law: line, of: length - 0.3 m}, damping: 2}\n"},
        {"  s: {along: theta2, stiffness: 7, angle: 0.2, damping: 0.5}\n",
         "  s: {along: theta2, torque: 7 N*m * (angle - 0.2 rad) + 0.5 N*m*s * rate}\n"},
        {"  s: {along: d, stiffness: 50, length: 0.2, damping: 3}\n",
         "  s: {along: d, force: {law: line, of: length - 0.2 m}, damping: 3}\n"}};
    for (size_t k = 0; k < sizeof pairs / sizeof *pairs; k++) {
        Rig a = rig_with(pairs[k][0]), b = rig_with(pairs[k][1]);
        for (int turn = 0; turn < 6; turn++) {
            static const char *const names[] = {"theta1.accel", "A.force.x", "S.moment", "O.force.y"};
            move(&a, 0.5 + 0.2 * turn, 1 - turn), move(&b, 0.5 + 0.2 * turn, 1 - turn);
            for (size_t n = 0; n < sizeof names / sizeof *names; n++) {
                double wanted = value_at(&a, names[n]);
                CHECK_NEAR(value_at(&b, names[n]), wanted, 1e-12 * (1 + fabs(wanted)));
            }
        }
        rig_free(&a);
        rig_free(&b);
    }
}

// Returns the effort that holds the crank still at an angle; *length: that of the spring.
static double holding_effort(Rig *rig, double angle, double *length)
{
    yk_dynamics_prescribe(rig->dynamics, 0, true);
    move(rig, angle, 0);
    double x = value_at(rig, "crank.A.x") - value_at(rig, "lever.T.x");
    double y = value_at(rig, "crank.A.y") - value_at(rig, "lever.T.y");
    *length = sqrt(x * x + y * y);
    return value_at(rig, "theta1.effort");
}

// What the drive does on a slow motion is what a spring of k stretch^3 stores, k stretch^4 / 4: the slope of it by
// central differences of the fourth order.
static void a_law_of_the_length_does_the_work_that_it_stores(void **unused)
{
    (void)unused;
    static const double step = 1e-3;
    Rig none = rig_with("  s: {along: theta2, stiffness: 0}\n");
    Rig rig = rig_with("  s: {between: [lever.T, crank.A], force: 900 N/m^3 * (length - 0.3 m)^3}\n");
    for (int k = 0; k < 8; k++) {
        double angle = 0.2 + 0.3 * k, stored[5], length;
        for (int i = -2; i <= 2; i++) {
            holding_effort(&rig, angle + i * step, &length);
            stored[i + 2] = 225 * pow(length - 0.3, 4);
        }
        double slope = (8 * (stored[3] - stored[1]) - (stored[4] - stored[0])) / (12 * step);
        double effort = holding_effort(&rig, angle, &length) - holding_effort(&none, angle, &length);
        CHECK_NEAR(effort, slope, 1e-8 * (1 + fabs(slope)));
        assert_true(fabs(slope) > 1e-3);
    }
    rig_free(&none);
    rig_free(&rig);
}

// A spring whose ends meet has no direction, so that its rate is 0 whatever the ends do.
static void ends_that_meet_have_no_rate(void **unused)
{
    (void)unused;
    static const double places[][2] = {{0, 2}, {0, -3}, {0.5, 2}, {-0.5, 2}};
    Rig rig = rig_of_text("bodies: {ground: {points: {O: [0, 0]}}, b: {points: {P: [0, 0]}, mass: 1}}\njoints:\n"
                          "  S: {slide: [ground, b], along: x, distance: s}\n"
                          "laws: {line: {table: [[-20, -1000], [20, 1000]], between: linear}}\nsprings:\n"
                          "  k: {between: [ground.O, b.P], force: {law: line, of: rate / (1 m/s)}}\n"
                          "  l: {between: [ground.O, b.P], force: {law: line, of: length / (1 m)}}\n");
    YkLoads *loads = rig.dynamics->loads;
    for (size_t k = 0; k < sizeof places / sizeof *places; k++) {
        double s = places[k][0], rate = (s > 0) - (s < 0);
        move(&rig, s, places[k][1]);
        CHECK_NEAR(yk_loads_law_argument(loads, rig.state, &rig.state->space, 0, 0), rate * places[k][1], 1e-15);
        CHECK_NEAR(yk_loads_law_argument(loads, rig.state, &rig.state->space, 1, 0), fabs(s), 1e-15);
    }
    rig_free(&rig);
}

// Inputs without an effort of their own have the effort 0, whatever stood there before.
static void inputs_without_efforts_have_none(void **unused)
{
    (void)unused;
    Rig rig = rig_of_text("bodies: {a: {mass: 1}, b: {mass: 2}, c: {mass: 3}}\njoints:\n"
                          "  A: {slide: [ground, a], along: x, distance: x}\n"
                          "  B: {slide: [ground, b], along: x, distance: y}\n"
                          "  C: {slide: [ground, c], along: x, distance: z}\nefforts: {y: 4 N}\n");
    double effort[3] = {7, 7, 7}, power;
    const double rate[3] = {5, 5, 5};
    size_t culprit, y = yk_coordinate_find(rig.mech, "y");
    assert_true(yk_loads_efforts(rig.dynamics->loads, rig.state, rate, effort, &power, &culprit));
    for (size_t i = 0; i < 3; i++) CHECK_NEAR(effort[i], yk_input_coordinate(rig.mech, i) == y ? 4 : 0, 0);
    CHECK_NEAR(power, 20, 0);
    rig_free(&rig);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_straight_law_is_a_spring),
        cmocka_unit_test(a_law_of_the_length_does_the_work_that_it_stores),
        cmocka_unit_test(ends_that_meet_have_no_rate),
        cmocka_unit_test(inputs_without_efforts_have_none),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
