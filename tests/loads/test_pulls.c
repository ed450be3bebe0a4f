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

// Springs tell the arguments of their laws at the present pose, whatever forces were computed before.
static void laws_of_springs_are_asked_at_the_pose(void **unused)
{
    (void)unused;
    Rig rig = rig_with("  s: {between: [lever.T, crank.A], force: {law: line, of: length - 0.3 m}}\n"
                       "  t: {along: d, force: {law: line, of: 2 * length + 1 m}}\n");
    size_t T = yk_model_find_point(rig.model, "lever.T"), A = yk_model_find_point(rig.model, "crank.A");
    for (int turn = 0; turn < 6; turn++) {
        yk_state_set_input(rig.state, 0, (YkMotion){0.5 + 0.2 * turn, 1, 0});
        assert_int_equal(yk_state_solve(rig.state), YK_OK);
        YkPointMotion a = yk_state_point(rig.state, T), b = yk_state_point(rig.state, A);
        const double due[] = {hypot(a.position[0] - b.position[0], a.position[1] - b.position[1]) - 0.3,
                              2 * yk_state_coordinate(rig.state, yk_coordinate_find(rig.mech, "d")).position + 1};
        for (size_t k = 0; k < 2; k++) {
            YkLoads *loads = rig.dynamics->loads;
            CHECK_NEAR(yk_loads_law_argument(loads, rig.state, &rig.state->space, k, 0), due[k], 1e-13);
        }
        move(&rig, -0.3 * turn, 2); // another pose, whose values stay behind
    }
    rig_free(&rig);
}

// Efforts between bodies without mass pass through them as through bodies of all but none.
static void bodies_without_mass_pass_efforts_on(void **unused)
{
    (void)unused;
    static const char *const joints[] = {"[crank, coupler]", "[coupler, crank]"};
    for (int way = 0; way < 2; way++) {
        Rig rigs[2];
        for (int k = 0; k < 2; k++) {
            char text[1500];
            const char *mass = k ? ", mass: 1e-9, inertia: 1e-9" : "";
            snprintf(
                text, sizeof text,
                "bodies:\n  ground: {points: {O: [0, 0], Q: [2, 0]}}\n  crank: {points: {O: [0, 0], A: [0.7, 0]}%s}\n"
                "  coupler: {points: {A: [0, 0], B: [2.1, 0]}%s}\n"
                "  rocker: {points: {Q: [0, 0], B: [1.8, 0]}, mass: 2, center: [1, 0.1], inertia: 0.3}\njoints:\n"
                "  Q: {pin: [ground, rocker], angle: v}\n  O: {pin: [ground, crank], angle: q}\n"
                "  A: {pin: %s, angle: u}\n  B: {pin: [coupler, rocker]}\n"
                "efforts: {u: 3 N*m}\nstart: {v: 1.8, q: 1.8, u: %s}\n",
                mass, mass, joints[way], way ? "0.4" : "-0.4");
            rigs[k] = rig_of_text(text);
            assert_int_equal(yk_dynamics_solve(rigs[k].dynamics, rigs[k].state, YK_METHOD_REDUCED), YK_OK);
        }
        static const char *const names[] = {"v.accel", "A.force.x", "A.force.y", "O.force.x", "O.force.y", "Q.force.x"};
        for (size_t n = 0; n < sizeof names / sizeof *names; n++) {
            double due = value_at(&rigs[1], names[n]);
            CHECK_NEAR(value_at(&rigs[0], names[n]), due, 1e-6 * (1 + fabs(due)));
            assert_true(fabs(due) > 1e-3);
        }
        for (int k = 0; k < 2; k++) rig_free(&rigs[k]);
    }
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

// One of three efforts has a value from 1 s on: before, that one is named, and what it gives, and to whom, after.
static void the_effort_without_a_value_is_named(void **unused)
{
    (void)unused;
    static const char *const formulas[] = {"4 N", "2 N * sqrt(t/(1 s) - 1)", "3 N"};
    for (int k = 0; k < 3; k++) {
        char text[1000];
        snprintf(text, sizeof text,
                 "bodies: {a: {mass: 1}, b: {mass: 2}, c: {mass: 3}}\njoints:\n"
                 "  A: {slide: [ground, a], along: x, distance: x}\n  B: {slide: [ground, b], along: x, distance: y}\n"
                 "  C: {slide: [ground, c], along: x, distance: z}\nefforts: {x: \"%s\", y: \"%s\", z: \"%s\"}\n",
                 formulas[(k + 1) % 3], formulas[(k + 2) % 3], formulas[k]);
        Rig rig = rig_of_text(text);
        const double rate[3] = {5, 6, 7}, due[3] = {4, 2 * sqrt(4), 3};
        double effort[3], power[3];
        size_t culprit = 9;
        assert_false(yk_loads_efforts(rig.dynamics->loads, rig.state, rate, effort, power, &culprit));
        assert_int_equal((culprit + (size_t)k + 1) % 3, 1); // the second formula's place
        rig.state->time = 5;
        assert_true(yk_loads_efforts(rig.dynamics->loads, rig.state, rate, effort, power, &culprit));
        for (int i = 0; i < 3; i++) {
            double own = due[(k + 1 + i) % 3];
            CHECK_NEAR(effort[i], own, 1e-14);
            CHECK_NEAR(power[i], own * rate[i], 1e-13);
        }
        rig_free(&rig);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_straight_law_is_a_spring),
        cmocka_unit_test(a_law_of_the_length_does_the_work_that_it_stores),
        cmocka_unit_test(ends_that_meet_have_no_rate),
        cmocka_unit_test(laws_of_springs_are_asked_at_the_pose),
        cmocka_unit_test(bodies_without_mass_pass_efforts_on),
        cmocka_unit_test(inputs_without_efforts_have_none),
        cmocka_unit_test(the_effort_without_a_value_is_named),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
