// Simulations that once went wrong, or easily could: each is small and has a known answer.
#include "run.h"
#include "simulate/simulation.h"

#define LINKAGE(ground, crank, coupler, rocker)                                                                        \
    "bodies:\n  ground: {points: {O: [0, 0], Q: [" ground ", 0]}}\n"                                                   \
    "  crank: {points: {O: [0, 0], A: [" crank ", 0]}, mass: 1, rod: [O, A]}\n"                                        \
    "  coupler: {points: {A: [0, 0], B: [" coupler ", 0]}, mass: 1, rod: [A, B]}\n"                                    \
    "  rocker: {points: {Q: [0, 0], B: [" rocker ", 0]}, mass: 1, rod: [Q, B]}\n"
#define PINS                                                                                                           \
    "joints:\n  O: {pin: [ground, crank], angle: q}\n  A: {pin: [crank, coupler], angle: c}\n"                         \
    "  Q: {pin: [ground, rocker], angle: r}\n  B: {pin: [coupler, rocker]}\n"
#define SLIDE_FIRST                                                                                                    \
    "bodies:\n  ground: {points: {O: [0, 0]}}\n"                                                                       \
    "  crank: {points: {O: [0, 0], A: [0.1, 0]}, mass: 2, inertia: 0.01, center: [0, 0]}\n"                            \
    "  rod: {points: {A: [0, 0], B: [0.3, 0]}, mass: 0.5, rod: [A, B]}\n  piston: {points: {B: [0, 0]}, mass: 1}\n"    \
    "joints:\n  R: {slide: [ground, piston], along: x, distance: d}\n  O: {pin: [ground, crank], angle: q}\n"          \
    "  B: {pin: [piston, rod], angle: p}\n  A: {pin: [crank, rod]}\n"                                                  \
    "start: {d: 0.33, q: 60 deg, p: 160 deg, q.rate: 20 rad/s}\n"

static YkSimulationOptions far_options(double tolerance, double horizon)
{
    YkSimulationOptions o = run_options(tolerance);
    o.horizon = horizon;
    return o;
}

static size_t count_happenings(const Run *run, YkHappeningKind kind)
{
    size_t count = 0;
    for (size_t k = 0; k < yk_simulation_happening_count(run->sim); k++)
        count += yk_simulation_happening(run->sim, k).kind == kind;
    return count;
}

// A step may pass rows and need other coordinates at its end: the rows still come from the step.
static void rows_are_answered_where_coordinates_change(void **unused)
{
    (void)unused;
    Run run = run_of_text(SLIDE_FIRST, far_options(1e-10, 1)), plain = run_of_text(SLIDE_FIRST, run_options(1e-10));
    for (int k = 0; k <= 500; k++) {
        assert_int_equal(yk_simulation_advance(run.sim, k / 500.0), YK_OK);
        assert_int_equal(yk_simulation_advance(plain.sim, k / 500.0), YK_OK);
        CHECK_NEAR(run_value(&run, "q"), run_value(&plain, "q"), 1e-6);
    }
    YkSimulationSummary s = yk_simulation_summary(run.sim);
    assert_true(s.recoordinations >= 1 && s.energy_error < 1e-7);
    run_free(&run);
    run_free(&plain);
}

// Equal links, no force: they fold and unfold at a constant rate. Steps could be as long as one likes, and pass several
// folds.
static void long_steps_do_not_jump_over_folds(void **unused)
{
    (void)unused;
    Run run = run_of_text(LINKAGE("1", "1", "1", "1") PINS "start: {q: 0.8, c: -0.8, r: 0.8, q.rate: 5}\n",
                          far_options(1e-9, 10));
    for (int k = 0; k <= 1000; k++) {
        assert_int_equal(yk_simulation_advance(run.sim, 0.01 * k), YK_OK);
        double q = 0.8 + 0.05 * k;
        CHECK_NEAR(run_value(&run, "q"), q, 1e-7);
        CHECK_NEAR(run_value(&run, "coupler.angle"), 0, 1e-6);
    }
    assert_true(yk_simulation_summary(run.sim).energy_error < 1e-8);
    run_free(&run);
}

// At rest (or all but) beside a change point: it falls through it as the parallelogram that it is.
static void a_machine_may_start_at_rest_beside_a_change_point(void **unused)
{
    (void)unused;
    static const char *const starts[] = {"{q: 1e-6, c: -1e-6, r: 1e-6}", "{q: 1e-3, c: -1e-3, r: 1e-3}",
                                         "{q: 1e-3, c: -1e-3, r: 1e-3, q.rate: 1e-3}", "{q: 3.14, c: -3.14, r: 3.14}"};
    for (size_t k = 0; k < sizeof starts / sizeof *starts; k++) {
        char text[2000];
        snprintf(text, sizeof text, "gravity: [0, -10]\n" LINKAGE("2", "1", "2", "1") PINS "start: %s\n", starts[k]);
        Run run = run_of_text(text, run_options(1e-10));
        for (int row = 0; row <= 40; row++) {
            assert_int_equal(yk_simulation_advance(run.sim, 0.05 * row), YK_OK);
            CHECK_NEAR(run_value(&run, "coupler.angle"), 0, 1e-6);
        }
        assert_true(yk_simulation_summary(run.sim).energy_error < 1e-8);
        run_free(&run);
    }
}

// The blow on one joint strikes another off the stop on which it lay: it flies, and falls back.
static void a_blow_strikes_others_off_their_stops(void **unused)
{
    (void)unused;
    const char *text =
        "bodies:\n  ground: {points: {O: [0, 0]}}\n  one: {points: {O: [0, 0], A: [1, 0]}, mass: 1, rod: [O, A]}\n"
        "  two: {points: {A: [0, 0], B: [1, 0]}, mass: 5, rod: [A, B]}\n"
        "joints:\n  O: {pin: [ground, one], angle: q}\n  A: {pin: [one, two], angle: p}\n"
        "start: {q: 0, p: 90 deg, p.rate: 3}\nefforts: {q: -50}\nstops: {q: [0, 3], p: [-1.5, 2]}\n";
    Run run = run_of_text(text, run_options(1e-10));
    assert_int_equal(yk_simulation_advance(run.sim, 0.15), YK_OK);
    assert_true(run_value(&run, "q") > 1e-4 && run_value(&run, "q.accel") < -1);
    assert_int_equal(yk_simulation_advance(run.sim, 1), YK_OK);
    CHECK_NEAR(run_value(&run, "q"), 0, 1e-9);
    assert_true(count_happenings(&run, YK_HAPPENING_STOP) == 2 && count_happenings(&run, YK_HAPPENING_RELEASE) == 2);
    assert_true(yk_simulation_summary(run.sim).energy_error < 1e-9);
    run_free(&run);
}

static void a_drive_past_a_stop_is_a_limit(void **unused)
{
    (void)unused;
    Run run = run_of_text(LINKAGE("0.4", "0.1", "0.4", "0.3") PINS
                          "drives: {q: 10 rad/s * t}\nstart: {c: 1, r: 1.5}\nstops: {r: [0, 1.9]}\n",
                          run_options(1e-10));
    assert_int_equal(yk_simulation_advance(run.sim, 0.2), YK_OK);
    assert_int_equal(yk_simulation_advance(run.sim, 1), YK_LIMIT);
    assert_non_null(strstr(yk_simulation_report(run.sim)->message, "past its stop"));
    CHECK_NEAR(run_value(&run, "r"), 1.9, 1e-9); // it stands where it went wrong
    CHECK_NEAR(run_value(&run, "q"), 10 * yk_simulation_time(run.sim), 1e-12);
    assert_int_equal(yk_simulation_advance(run.sim, 2), YK_LIMIT); // and stays there
    run_free(&run);
}

static void stops_hit_together_keep_the_energy(void **unused)
{
    (void)unused;
    const char *text =
        "gravity: [0, -10]\nbodies:\n  ground: {points: {O: [0, 0]}}\n  a: {points: {O: [0, 0]}, mass: 1}\n  b: "
        "{points: {O: [0, 0]}, mass: 2}\n"
        "joints:\n  A: {slide: [ground, a], along: y, distance: y}\n  B: {slide: [ground, b], along: y, distance: z}\n"
        "start: {y: 1, z: 1}\nstops: {y: {between: [0, 5], restitution: 1}, z: {between: [0, 5], restitution: 1}}\n";
    Run run = run_of_text(text, run_options(1e-10));
    assert_int_equal(yk_simulation_advance(run.sim, 10), YK_OK);
    CHECK_NEAR(run_value(&run, "y"), run_value(&run, "z"), 1e-9);
    CHECK_NEAR(run_value(&run, "energy"), 30, 1e-8);
    assert_int_equal(yk_simulation_happening_count(run.sim), 22);
    run_free(&run);
}

// All pins of a linkage with one freedom come to rest at one time, and each is told once.
static void a_rough_linkage_sticks_everywhere_at_once(void **unused)
{
    (void)unused;
#define ROUGH "friction: {coulomb: 0.3, radius: 0.03 m}}\n"
    const char *text =
        "gravity: [0, -10]\n" LINKAGE("1", "0.3", "1", "0.6") "joints:\n  O: {pin: [ground, crank], angle: q, " ROUGH
                                                              "  A: {pin: [crank, coupler], angle: c, " ROUGH
                                                              "  Q: {pin: [ground, rocker], angle: r, " ROUGH
                                                              "  B: {pin: [coupler, rocker], " ROUGH
                                                              "start: {q: 1, c: 0, r: 1.5}\n";
    Run run = run_of_text(text, run_options(1e-9));
    assert_int_equal(yk_simulation_advance(run.sim, 6), YK_OK);
    double q = run_value(&run, "q");
    assert_int_equal(yk_simulation_advance(run.sim, 12), YK_OK);
    CHECK_NEAR(run_value(&run, "q"), q, 1e-9);
    CHECK_NEAR(run_value(&run, "q.accel"), 0, 1e-10);
    assert_int_equal(count_happenings(&run, YK_HAPPENING_STICK), 4);
    assert_int_equal(count_happenings(&run, YK_HAPPENING_SLIP), 0);
    assert_true(yk_simulation_summary(run.sim).energy_error < 1e-8);
    run_free(&run);
}

// A guide that a drive moves to and fro rubs all the time: its friction is that of the pose, also behind the dead
// points, where nothing could hold it.
static void a_driven_guide_rubs_behind_its_dead_points(void **unused)
{
    (void)unused;
    const char *text =
        "gravity: [0, -10]\nbodies:\n  ground: {points: {O: [0, 0]}}\n"
        "  crank: {points: {O: [0, 0], A: [0.1, 0]}, mass: 2, inertia: 0.01, center: [0, 0]}\n"
        "  rod: {points: {A: [0, 0], B: [0.3, 0]}, mass: 0.5, rod: [A, B]}\n  piston: {points: {B: [0, 0]}, mass: 1}\n"
        "joints:\n  O: {pin: [ground, crank], angle: q}\n  A: {pin: [crank, rod], angle: p}\n"
        "  B: {pin: [rod, piston], friction: {coulomb: 0.1, radius: 0.01 m}}\n"
        "  R: {slide: [ground, piston], along: x, distance: d, friction: {coulomb: 0.2}}\n"
        "drives: {q: 1 + 8 rad/s * t}\nstart: {p: -0.5, d: 0.33}\n";
    Run run = run_of_text(text, run_options(1e-9));
    YkMechanism *mech = yk_mechanism_compile(run.model, NULL, run.problems);
    YkState *state = yk_state_new(mech);
    YkDynamics *dynamics = yk_dynamics_new(mech, run.problems);
    assert_true(state && dynamics && yk_state_assemble(state) >= 0);
    for (int k = 0; k <= 20; k++) {
        double t = 0.1 * k;
        assert_int_equal(yk_simulation_advance(run.sim, t), YK_OK);
        yk_state_set_input(state, 0, (YkMotion){1 + 8 * t, 8, 0});
        assert_int_equal(yk_dynamics_solve(dynamics, state, YK_METHOD_NEWTON_EULER), YK_OK);
        double effort = yk_dynamics_effort(dynamics, yk_coordinate_find(mech, "q"));
        CHECK_NEAR(run_value(&run, "q.effort"), effort, 1e-9 * (1 + fabs(effort)));
    }
    assert_true(yk_simulation_summary(run.sim).energy_error < 1e-6);
    yk_dynamics_free(dynamics);
    yk_state_free(state);
    yk_mechanism_free(mech);
    run_free(&run);
}

// A load without a value names itself, and the machine stands where it last had one.
static void a_load_that_loses_its_value_is_named(void **unused)
{
    (void)unused;
    static const char *const more[] = {"", "stops: {q: [-5, 5]}\n"}; // the short way of open trees, and the long one
    for (int k = 0; k < 2; k++) {
        char text[600];
        snprintf(
            text, sizeof text,
            "bodies:\n  ground: {points: {O: [0, 0]}}\n  a: {points: {O: [0, 0], A: [1, 0]}, mass: 1, rod: [O, A]}\n"
            "joints:\n  O: {pin: [ground, a], angle: q}\nstart: {q: 0, q.rate: 1}\nefforts: {q: 1 N*m * sqrt(1 - "
            "q)}\n%s",
            more[k]);
        Run run = run_of_text(text, run_options(1e-9));
        assert_int_equal(yk_simulation_advance(run.sim, 2), YK_NOT_CONVERGED);
        assert_non_null(strstr(yk_simulation_report(run.sim)->message, "`q` has no finite value"));
        assert_true(yk_simulation_time(run.sim) > 0.5 && run_value(&run, "q") > 0.99 && run_value(&run, "q") <= 1);
        assert_true(isfinite(run_value(&run, "q.accel")));
        run_free(&run);
    }
}

static void times_that_make_no_sense_are_refused(void **unused)
{
    (void)unused;
    Run run = run_of_text(SLIDE_FIRST, run_options(1e-9));
    assert_int_equal(yk_simulation_advance(run.sim, NAN), YK_BAD_ARGUMENT);
    assert_int_equal(yk_simulation_advance(run.sim, HUGE_VAL), YK_BAD_ARGUMENT);
    assert_int_equal(yk_simulation_advance(run.sim, -1), YK_BAD_ARGUMENT);
    assert_int_equal(yk_simulation_advance(run.sim, 0.3), YK_OK);
    assert_int_equal(yk_simulation_advance(run.sim, 0.3), YK_OK);
    assert_int_equal(yk_simulation_advance(run.sim, 0.2), YK_BAD_ARGUMENT);
    CHECK_NEAR(yk_simulation_time(run.sim), 0.3, 0);
    assert_int_equal(yk_simulation_advance(run.sim, 0.4), YK_OK); // none of this did any harm
    assert_int_equal(yk_simulation_set_effort(run.sim, "q", 1), YK_BAD_ARGUMENT);
    run_free(&run);
}

static void steps_may_be_counted_out(void **unused)
{
    (void)unused;
    YkSimulationOptions o = run_options(1e-9);
    o.steps_max = 20;
    Run run = run_of_text(SLIDE_FIRST, o);
    assert_int_equal(yk_simulation_advance(run.sim, 10), YK_NOT_CONVERGED);
    YkSimulationSummary s = yk_simulation_summary(run.sim);
    assert_true(s.steps == 20 && yk_simulation_time(run.sim) > 0.05);
    double q = run_value(&run, "q"), d = run_value(&run, "d");
    CHECK_NEAR(d, 0.1 * cos(q) + sqrt(0.09 - 0.01 * sin(q) * sin(q)), 1e-12);
    run_free(&run);
}

static void options_that_make_no_sense_are_refused(void **unused)
{
    (void)unused;
    YkProblems *problems = yk_problems_new();
    YkModel *model = yk_model_parse(SLIDE_FIRST, strlen(SLIDE_FIRST), "test.yaml", NULL, problems);
    YkSimulationOptions good = yk_default_simulation_options(), bad[4] = {good, good, good, good};
    bad[0].tolerance = 0;
    bad[1].tolerance = NAN;
    bad[2].start = HUGE_VAL;
    bad[3].integrator = YK_INTEGRATOR_RK4;
    bad[3].step = -1;
    for (size_t k = 0; k < 4; k++) {
        assert_null(yk_simulation_new(model, &bad[k], problems));
        assert_int_equal(yk_problems_error_count(problems), k + 1);
    }
    yk_model_free(model);
    yk_problems_free(problems);
}

static void it_may_start_late(void **unused)
{
    (void)unused;
    YkSimulationOptions o = run_options(1e-9);
    o.start = 1e6;
    Run late = run_of_text(SLIDE_FIRST, o), run = run_of_text(SLIDE_FIRST, run_options(1e-9));
    assert_int_equal(yk_simulation_advance(late.sim, 1e6 + 0.5), YK_OK);
    assert_int_equal(yk_simulation_advance(run.sim, 0.5), YK_OK);
    CHECK_NEAR(run_value(&late, "q"), run_value(&run, "q"), 1e-6);
    run_free(&late);
    run_free(&run);
}

// A slider crank whose rod is two bodies that a pin and a slide join, so that one constraint repeats others. The
// slide's coordinate, which is held, passes a dead point: another has to take over. The rod keeps its length between
// two points, each known from the ground along one joint.
static void a_group_that_repeats_constraints_passes_its_dead_point(void **unused)
{
    (void)unused;
    static const char text[] =
        "gravity: [0, -9.81]\nbodies:\n  ground: {points: {P0: [0.4486, 0.086], P1: [-0.6293, 0.5817]}}\n"
        "  b1: {points: {P0: [0.4486, 0.086], P3: [-0.1759, -0.0427]}, mass: 1, center: [-0.1, 0.2], inertia: 1.7}\n"
        "  b2: {points: {Q1: [-1.327869504593366, 0.8374104949981116], P2: [0.2186, -0.1165], P4: [0.657, -0.245]}, "
        "mass: 0.8, center: [0.6, -0.3], inertia: 0.2}\n"
        "  b3: {points: {Q2: [0.6471, -0.1165], P3: [-0.1759, -0.0427], P4: [0.657, -0.245]}, mass: 1, "
        "center: [-0.4, -0.7], inertia: 1.3}\n"
        "joints:\n  J0: {pin: [ground, b1], at: P0, angle: c0}\n"
        "  J1: {pin-slot: [ground, b2], along: -0.3509, from: P1, at: Q1, distance: c1, angle: d1}\n"
        "  J2: {slide: [b2, b3], along: 0, from: P2, to: Q2, distance: c2}\n"
        "  J3: {pin: [b1, b3], at: P3}\n  J4: {pin: [b3, b2], at: P4}\nstart: {c1: -0.7439, c2: 0.4285}\n";
    Run run = run_of_text(text, run_options(1e-9));
    for (int k = 1; k <= 15; k++) {
        assert_int_equal(yk_simulation_advance(run.sim, 0.1 * k), YK_OK);
        double c0 = run_value(&run, "c0"), c1 = run_value(&run, "c1"), x = -0.1759 - 0.4486, y = -0.0427 - 0.086;
        double P3x = 0.4486 + x * cos(c0) - y * sin(c0), P3y = 0.086 + x * sin(c0) + y * cos(c0);
        double Q1x = -0.6293 + c1 * cos(-0.3509), Q1y = 0.5817 + c1 * sin(-0.3509);
        CHECK_NEAR(hypot(Q1x - P3x, Q1y - P3y), hypot(-1.327869504593366 + 0.1759, 0.8374104949981116 + 0.0427), 1e-12);
    }
    YkSimulationSummary s = yk_simulation_summary(run.sim);
    assert_true(s.recoordinations >= 1 && s.energy_error < 1e-7);
    assert_true(s.steps < 100);
    run_free(&run);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(rows_are_answered_where_coordinates_change),
        cmocka_unit_test(long_steps_do_not_jump_over_folds),
        cmocka_unit_test(a_machine_may_start_at_rest_beside_a_change_point),
        cmocka_unit_test(a_blow_strikes_others_off_their_stops),
        cmocka_unit_test(a_drive_past_a_stop_is_a_limit),
        cmocka_unit_test(stops_hit_together_keep_the_energy),
        cmocka_unit_test(a_rough_linkage_sticks_everywhere_at_once),
        cmocka_unit_test(a_driven_guide_rubs_behind_its_dead_points),
        cmocka_unit_test(a_load_that_loses_its_value_is_named),
        cmocka_unit_test(times_that_make_no_sense_are_refused),
        cmocka_unit_test(steps_may_be_counted_out),
        cmocka_unit_test(options_that_make_no_sense_are_refused),
        cmocka_unit_test(it_may_start_late),
        cmocka_unit_test(a_group_that_repeats_constraints_passes_its_dead_point),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
