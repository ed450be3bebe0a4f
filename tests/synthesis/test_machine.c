// Parameters of an existing machine: goals met, claims kept, every answer measured on its own file.
#include "synthesis/answer.h"
#include "base/codes.h"
#include "base/vec.h"

// Drives a candidate's file over a range and returns the largest value of a channel less its least.
static void extent(const char *model, const char *channel, double from, double to, double *low, double *high)
{
    Standing s = standing(model);
    YkChannel c;
    YkSweepOptions options = yk_default_sweep_options();
    assert_int_equal(yk_channel_parse(s.mech, channel, &c, NULL), YK_OK);
    YkMotion start = {.position = from};
    assert_true(yk_state_move_to(s.state, &start, NULL, NULL) >= 0);
    options.coordinate = (int)yk_input_coordinate(s.mech, 0);
    options.from = from;
    options.to = to;
    options.steps = 90;
    YkSweep *sweep = yk_sweep_run(s.state, &options, &c, 1, NULL);
    assert_true(yk_sweep_status(sweep) >= 0);
    *low = INFINITY;
    *high = -INFINITY;
    for (size_t r = 0; r < yk_sweep_row_count(sweep); r++) {
        *low = fmin(*low, yk_sweep_value(sweep, r, 0));
        *high = fmax(*high, yk_sweep_value(sweep, r, 0));
    }
    yk_sweep_free(sweep);
    standing_free(&s);
}

static Answer solve(const char *goals, const YkSynthesisOptions *options)
{
    char text[2000];
    snprintf(text, sizeof text, "synthesis: machine\nmachine: %s/examples/hoeken.yaml\n%s", YOKE_ROOT, goals);
    return answer_with(text, options);
}

static void a_straight_line_becomes_straighter_than_hoekens(void **state)
{
    (void)state;
    double low, high, own_low, own_high;
    Answer a = solve("free: {l1: [1.5, 3.5], l3: [2, 5]}\nover: {input: theta, range: [90 deg, 270 deg], steps: 60}\n"
                     "goals: [{value: coupler.P.y, equals: 5.48}]\nbest: 1\n",
                     NULL);
    YkCandidate c = yk_synthesis_candidate(a.synthesis, 0);
    extent(c.model, "coupler.P.y", YK_PI / 2, 3 * YK_PI / 2, &low, &high);
    YkModel *own = yk_model_load(YOKE_ROOT "/examples/hoeken.yaml", NULL, NULL);
    extent(yk_model_text(own), "coupler.P.y", YK_PI / 2, 3 * YK_PI / 2, &own_low, &own_high);
    assert_true(high - low <= own_high - own_low);
    assert_true(c.worst >= fmax(high - 5.48, 5.48 - low) - 1e-9);
    yk_model_free(own);
    answer_free(&a);
}

static void dimensions_are_found_again_from_their_motion(void **state)
{
    (void)state;
    // The angles of the rocker at l1 = 2.5, l3 = 3.25 belong to these lengths alone.
    Answer a = solve("free: {l1: [1.5, 3.5], l3: [2, 5]}\nover: {input: theta, range: [90 deg, 270 deg], steps: 12}\n"
                     "goals:\n- {value: coupler.P.x, equals: 2.5, where: [180 deg, 180 deg]}\n"
                     "- {value: coupler.P.y, equals: 5.477225575051661, where: [180 deg, 180 deg]}\nbest: 1\n",
                     NULL);
    double l1, l3;
    assert_string_equal(yk_synthesis_parameter(a.synthesis, 0, 0, &l1), "l1");
    assert_string_equal(yk_synthesis_parameter(a.synthesis, 0, 1, &l3), "l3");
    assert_null(yk_synthesis_parameter(a.synthesis, 0, 2, NULL));
    CHECK_NEAR(l1, 2.5, 1e-7);
    CHECK_NEAR(l3, 3.25, 1e-7);
    assert_true(yk_synthesis_candidate(a.synthesis, 0).error < 1e-14);
    answer_free(&a);
}

static void claims_hold_on_the_files(void **state)
{
    (void)state;
    check_without_sanitizers();
    double low, high;
    Answer a = solve("free: {l1: [1.5, 3.5], l3: [2, 5]}\nover: {input: theta, range: [90 deg, 270 deg], steps: 90}\n"
                     "goals: [{value: coupler.P.y, equals: 5.48}]\n"
                     "require: ['min(B.transmission) > 52 deg', 'max(coupler.P.x) < 5']\nbest: 3\n",
                     NULL);
    assert_true(yk_synthesis_count(a.synthesis) > 0);
    for (size_t k = 0; k < yk_synthesis_count(a.synthesis); k++) {
        YkCandidate c = yk_synthesis_candidate(a.synthesis, k);
        extent(c.model, "B.transmission", YK_PI / 2, 3 * YK_PI / 2, &low, &high);
        assert_true(low > 52 * YK_PI / 180);
        extent(c.model, "coupler.P.x", YK_PI / 2, 3 * YK_PI / 2, &low, &high);
        assert_true(high < 5);
    }
    answer_free(&a);
    a = solve("free: {l1: [2, 3]}\nover: {input: theta, range: [90 deg, 270 deg]}\n"
              "goals: [{value: coupler.P.y, equals: 5.48}]\nrequire: ['max(coupler.P.y) < 1']\n",
              NULL);
    assert_int_equal(yk_synthesis_count(a.synthesis), 0);
    assert_true(yk_synthesis_left_out(a.synthesis, YK_DEFECT_REQUIRE) > 0);
    answer_free(&a);
}

static void points_are_passed_and_rates_kept_small(void **state)
{
    (void)state;
    Answer a = solve("free: {l1: [1.5, 3.5], l3: [2, 5]}\nover: {input: theta, range: [0 deg, 360 deg], steps: 72}\n"
                     "goals: [{point: coupler.P, through: [[0.5, 5.6], [4.5, 5.6]]}]\nbest: 2\n",
                     NULL);
    const double *xy;
    size_t rows = yk_synthesis_curve(a.synthesis, 0, &xy);
    double nearest = INFINITY;
    for (size_t r = 0; r < rows; r++) nearest = fmin(nearest, hypot(xy[2 * r] - .5, xy[2 * r + 1] - 5.6));
    assert_true(nearest < yk_synthesis_candidate(a.synthesis, 0).worst + 0.2);
    answer_free(&a);
    a = solve("free: {l1: [2, 3]}\nover: {input: theta, range: [90 deg, 270 deg]}\n"
              "goals: [{least: max(abs(coupler.angle.rate))}]\nbest: 1\n",
              NULL);
    assert_true(yk_synthesis_count(a.synthesis) == 1);
    answer_free(&a);
}

static void the_largest_effort_becomes_small(void **state)
{
    (void)state;
    // Lifting a weight on a crank takes its weight times the crank's length at most: the shortest crank is the best.
    static const char lift[] = "gravity: [0, -10]\nparameters: {a: 2}\nbodies:\n  ground: {points: {O: [0, 0]}}\n"
                               "  crank: {points: {O: [0, 0], A: [a, 0]}, mass: 3, center: [a, 0], inertia: 1}\n"
                               "joints: {O: {pin: [ground, crank], angle: theta}}\ndrives: {theta: 1 rad/s * t}\n";
    static const char task[] = "synthesis: machine\nmachine: lift.yaml\nfree: {a: [0.5, 4]}\n"
                               "over: {input: theta, range: [0 deg, 180 deg], steps: 12}\n"
                               "goals: [{least: max(abs(theta.effort))}]\nbest: 1\n";
    double a = 0;
    FILE *file = fopen("lift.yaml", "w");
    assert_non_null(file);
    assert_true(fputs(lift, file) >= 0);
    assert_int_equal(fclose(file), 0);
    Answer answer = answer_to(task);
    assert_string_equal(yk_synthesis_parameter(answer.synthesis, 0, 0, &a), "a");
    CHECK_NEAR(a, 0.5, 1e-9);
    CHECK_NEAR(sqrt(yk_synthesis_candidate(answer.synthesis, 0).error), 15, 1e-9);
    answer_free(&answer);
    remove("lift.yaml");
}

static void a_seed_determines_the_machines(void **state)
{
    (void)state;
    static const char goals[] = "free: {l1: [1.5, 3.5], l3: [2, 5]}\nover: {input: theta, range: [90 deg, 270 deg]}\n"
                                "goals: [{value: coupler.P.y, equals: 5.2}]\nbest: 2\n";
    Answer a = solve(goals, NULL), b = solve(goals, NULL);
    assert_string_equal(yk_synthesis_candidate(a.synthesis, 0).model, yk_synthesis_candidate(b.synthesis, 0).model);
    answer_free(&a);
    answer_free(&b);
}

// --- wrong tasks

static void refuse(const char *goals, int code)
{
    char text[2000];
    snprintf(text, sizeof text, "synthesis: machine\nmachine: %s/examples/hoeken.yaml\n%s", YOKE_ROOT, goals);
    YkProblems *problems = yk_problems_new();
    YkTask *task = yk_task_parse(text, strlen(text), "bad.yaml", problems);
    bool has = false;
    for (size_t k = 0; k < yk_problems_count(problems); k++) has |= yk_problems_get(problems, k)->code == code;
    if (task || !has) print_error("%s\nwants E%04d:\n%s", text, code, yk_problems_text(problems, 0));
    assert_null(task);
    assert_true(has);
    yk_problems_free(problems);
}

#define OVER "over: {input: theta, range: [0 deg, 90 deg]}\n"
#define FREE "free: {l1: [2, 3]}\n"
#define GOAL "goals: [{value: coupler.P.y, equals: 5}]\n"

static void wrong_tasks_are_refused_with_their_place(void **state)
{
    (void)state;
    refuse(OVER GOAL, YK_CODE_MISSING_KEY);
    refuse(FREE GOAL, YK_CODE_MISSING_KEY);
    refuse(FREE OVER, YK_CODE_MISSING_KEY);
    refuse(FREE OVER "goals: []\n", YK_CODE_TASK_BOUNDS);
    refuse("free: {q: [2, 3]}\n" OVER GOAL, YK_CODE_UNKNOWN_NAME);
    refuse("free: {l1: [3, 2]}\n" OVER GOAL, YK_CODE_TASK_BOUNDS);
    refuse("free: {l1: [3 kg, 4]}\n" OVER GOAL, YK_CODE_WRONG_DIMENSION);
    refuse(FREE "over: {input: nothing, range: [0, 1]}\n" GOAL, YK_CODE_TASK_MACHINE);
    refuse(FREE "over: {input: theta, range: [0, 1], steps: 1}\n" GOAL, YK_CODE_TASK_BOUNDS);
    refuse(FREE "over: {input: theta, range: [1, 1]}\n" GOAL, YK_CODE_TASK_BOUNDS);
    refuse(FREE OVER "goals: [{value: coupler.Q.y, equals: 5}]\n", YK_CODE_UNKNOWN_NAME);
    refuse(FREE OVER "goals: [{value: coupler.P.y, equals: 5 deg}]\n", YK_CODE_WRONG_DIMENSION);
    refuse(FREE OVER "goals: [{value: coupler.P.y, equals: 5, weight: 0}]\n", YK_CODE_TASK_BOUNDS);
    refuse(FREE OVER "goals: [{colour: red}]\n", YK_CODE_UNKNOWN_KEY);
    refuse(FREE OVER "goals: [{least: coupler.P.y}]\n", YK_CODE_TASK_FUNCTION);
    refuse(FREE OVER GOAL "require: [coupler.P.y > 3]\n", YK_CODE_TASK_FUNCTION);
    refuse(FREE OVER GOAL "require: ['min(coupler.P.y) = 3']\n", YK_CODE_TASK_FUNCTION);
    refuse(FREE OVER GOAL "bounds: {lengths: [1, 2]}\n", YK_CODE_UNKNOWN_KEY);
    refuse(FREE OVER GOAL "mechanisms: [four-bar]\n", YK_CODE_UNKNOWN_KEY);
    refuse(FREE OVER GOAL "fix: {ground: 1}\n", YK_CODE_UNKNOWN_KEY);
    YkProblems *problems = yk_problems_new();
    static const char missing[] = "synthesis: machine\nmachine: nowhere.yaml\n" FREE OVER GOAL;
    assert_null(yk_task_parse(missing, strlen(missing), "bad.yaml", problems));
    assert_int_equal(yk_problems_get(problems, 0)->code, YK_CODE_TASK_MACHINE);
    yk_problems_free(problems);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_straight_line_becomes_straighter_than_hoekens),
        cmocka_unit_test(dimensions_are_found_again_from_their_motion),
        cmocka_unit_test(claims_hold_on_the_files),
        cmocka_unit_test(points_are_passed_and_rates_kept_small),
        cmocka_unit_test(the_largest_effort_becomes_small),
        cmocka_unit_test(a_seed_determines_the_machines),
        cmocka_unit_test(wrong_tasks_are_refused_with_their_place),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
