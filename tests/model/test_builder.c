// The builder: machines made by calls are the machines of files, and problems name what is wrong.
#include <stdlib.h>
#include "check.h"
#include <yoke/yoke.h>

static YkBuilder *new_slider_crank(void)
{
    YkBuilder *b = yk_builder_new("Slider-crank");
    assert_non_null(b);
    yk_builder_parameter(b, "l", "0.5 m");
    yk_builder_body(b, "crank");
    yk_builder_body(b, "rod");
    yk_builder_body(b, "piston");
    yk_builder_point(b, "ground", "O", 0, 0);
    yk_builder_point(b, "crank", "O", 0, 0);
    yk_builder_point(b, "crank", "A", 0.3, 0);
    yk_builder_point(b, "rod", "A", 0, 0);
    yk_builder_set(b, "bodies/rod/points/B", "[l, 0]");
    yk_builder_point(b, "piston", "B", 0, 0);
    yk_builder_pin(b, "O", "ground", "crank", NULL, "theta");
    yk_builder_pin(b, "A", "crank", "rod", NULL, "phi");
    yk_builder_pin(b, "B", "rod", "piston", NULL, NULL);
    yk_builder_slide(b, "S", "ground", "piston", "x", NULL, NULL, "s");
    yk_builder_drive(b, "theta", "90 deg + 1 rad/s * t");
    yk_builder_start(b, "phi", -2);
    yk_builder_start(b, "s", 0.4);
    return b;
}

static double piston_at(const YkModel *model)
{
    YkProblems *problems = yk_problems_new();
    YkMechanism *mech = yk_mechanism_compile(model, NULL, problems);
    YkState *state = mech ? yk_state_new(mech) : NULL;
    assert_non_null(state);
    assert_int_equal(yk_state_set_time(state, 0, problems), YK_OK);
    assert_int_equal(yk_state_assemble(state), YK_OK);
    double s = yk_state_coordinate(state, yk_coordinate_find(mech, "s")).position;
    yk_state_free(state);
    yk_mechanism_free(mech);
    yk_problems_free(problems);
    return s;
}

static void test_calls_make_the_machine(void **context)
{
    (void)context;
    YkBuilder *b = new_slider_crank();
    YkProblems *problems = yk_problems_new();
    YkModel *model = yk_builder_model(b, NULL, problems);
    if (!model) print_error("%s", yk_problems_text(problems, 0));
    assert_non_null(model);
    assert_int_equal(yk_problems_count(problems), 0);
    assert_string_equal(yk_model_name(model), "Slider-crank");
    CHECK_NEAR(piston_at(model), 0.4, 1e-15); // 3-4-5
    yk_model_free(model);
    const YkOverride longer = {"l", "sqrt(0.34)*1 m"};
    model = yk_builder_model(b, &(YkLoadOptions){.parameters = &longer, .parameter_count = 1}, problems);
    assert_non_null(model);
    CHECK_NEAR(piston_at(model), 0.5, 1e-15);
    yk_model_free(model);
    yk_problems_free(problems);
    yk_builder_free(b);
}

static void test_what_was_set_is_replaced_and_removed(void **context)
{
    (void)context;
    YkBuilder *b = new_slider_crank();
    YkProblems *problems = yk_problems_new();
    yk_builder_set_number(b, "parameters/l", sqrt(0.34));
    yk_builder_set(b, "joints/spare", "{pin: [crank, rod]}");
    yk_builder_remove(b, "joints/spare");
    yk_builder_remove(b, "joints/never/there");
    YkModel *model = yk_builder_model(b, NULL, problems);
    assert_non_null(model);
    assert_int_equal(yk_model_joint_count(model), 4);
    CHECK_NEAR(piston_at(model), 0.5, 1e-15);
    yk_model_free(model);
    yk_problems_free(problems);
    yk_builder_free(b);
}

// Does a builder's one problem have this code, place and message?
static void check_told(YkBuilder *b, int code, const char *where, const char *message, const char *hint)
{
    YkProblems *problems = yk_problems_new();
    assert_null(yk_builder_model(b, NULL, problems));
    const YkProblem *problem = yk_problems_get(problems, 0);
    assert_int_equal(problem->code, code);
    assert_string_equal(problem->message, message);
    if (where)
        assert_string_equal(problem->where, where);
    else
        assert_null(problem->where);
    if (hint) assert_string_equal(problem->hint, hint);
    yk_problems_free(problems);
    yk_builder_free(b);
}

static void test_problems_name_what_they_are_about(void **context)
{
    (void)context;
    YkBuilder *b = new_slider_crank();
    yk_builder_set(b, "bodies/rod/points/B", "[2 kg, 0]");
    check_told(b, 321, "body `rod`, point `B`", "x of point `B` of `rod` must be a length, this is a mass", NULL);
    b = new_slider_crank();
    yk_builder_pin(b, "Z", "crnk", "rod", "A", NULL);
    check_told(b, 401, "joint `Z`, pin", "there is no body `crnk`", "did you mean `crank`?");
    b = new_slider_crank();
    yk_builder_mass(b, "rod", -1, 0, 0, 1);
    check_told(b, 415, "body `rod`, mass", "the mass of `rod` is -1 kg; it must be positive", NULL);
    b = new_slider_crank();
    yk_builder_point(b, "rood", "C", 0, 0);
    check_told(b, 401, NULL, "there is no body `rood`", "did you mean `rod`?");
    b = new_slider_crank();
    yk_builder_pin(b, "A", "crank", "rod", NULL, NULL);
    check_told(b, 107, NULL, "the joint `A` is given twice", "yk_builder_set replaces what was given");
    b = new_slider_crank();
    yk_builder_start(b, "theta.rate", (double)INFINITY);
    check_told(b, 417, NULL, "a value is not finite", NULL);
    b = new_slider_crank();
    yk_builder_parameter(b, "two\nlines", "1");
    check_told(b, 104, NULL, "a control character in `two\\nlines`", NULL);
    b = new_slider_crank();
    yk_builder_set(b, "bodies/rod/mass", "[1, 2");
    YkProblems *problems = yk_problems_new();
    assert_null(yk_builder_model(b, NULL, problems));
    assert_non_null(strstr(yk_problems_text(problems, 0), "`bodies/rod/mass`: "));
    yk_problems_free(problems);
    yk_builder_free(b);
}

static void test_problems_print_the_place_by_name(void **context)
{
    (void)context;
    YkBuilder *b = new_slider_crank();
    YkProblems *problems = yk_problems_new();
    yk_builder_set(b, "joints/B", "{pin: [rod, pistn]}");
    assert_null(yk_builder_model(b, NULL, problems));
    assert_string_equal(yk_problems_text(problems, 0), "joint `B`, pin: error: there is no body `pistn` [E0401]\n"
                                                       "      B: {pin: [rod, pistn]}\n"
                                                       "                     ^~~~~\n"
                                                       "hint: did you mean `piston`?\n");
    yk_problems_free(problems);
    yk_builder_free(b);
}

static void test_every_call_says_what_a_file_would(void **context)
{
    (void)context;
    YkBuilder *b = yk_builder_new(NULL);
    yk_builder_gravity(b, 0, -9.81);
    yk_builder_body(b, "a");
    yk_builder_mass(b, "a", 2, 0.1, -0.25, 1e-3);
    yk_builder_body(b, "b");
    yk_builder_rod(b, "b", 1, "P", "Q");
    yk_builder_weld(b, "w", "a", "b", "P");
    yk_builder_free_joint(b, "f", "ground", "c", NULL, "P", "u", "v", "w1");
    yk_builder_slot(b, "c", "a", "b", "30 deg", "P", "Q", "d", "phi");
    yk_builder_slide(b, "e", "a", "b", "-y", "P", "Q", "f");
    yk_builder_effort(b, "d", "1 N*sin(t)");
    yk_builder_force(b, "F", "a", NULL, "0", "-1 N");
    yk_builder_spring(b, "k", "ground.P", "a.Q", 100, 0.5, 2);
    yk_builder_spring_along(b, "m", "phi", 5, 0.25, 0);
    yk_builder_spring_along(b, "n", "f", 5, 0.25, 0);
    yk_builder_stop(b, "phi", -1, 1);
    yk_builder_gear(b, "g", "a", "b", 20, 30);
    yk_builder_rack(b, "r", "a", "b", 0.05);
    yk_builder_belt(b, "t", "a", "b", 0.1, 0.2);
    assert_string_equal(yk_builder_text(b),
                        "gravity: [0, -9.81]\n"
                        "bodies:\n"
                        "  a: {mass: 2, center: [0.1, -0.25], inertia: 0.001}\n"
                        "  b: {mass: 1, rod: [P, Q]}\n"
                        "joints:\n"
                        "  w: {weld: [a, b], at: P}\n"
                        "  f: {free: [ground, c], at: [u, v, w1], to: P}\n"
                        "  c: {pin-slot: [a, b], along: 30 deg, from: P, at: Q, distance: d, angle: phi}\n"
                        "  e: {slide: [a, b], along: -y, from: P, to: Q, distance: f}\n"
                        "efforts:\n"
                        "  d: 1 N*sin(t)\n"
                        "forces:\n"
                        "  F: {body: a, value: [0, -1 N]}\n"
                        "springs:\n"
                        "  k: {between: [ground.P, a.Q], stiffness: 100, length: 0.5, damping: 2}\n"
                        "  m: {along: phi, stiffness: 5, angle: 0.25, damping: 0}\n"
                        "  n: {along: f, stiffness: 5, length: 0.25, damping: 0}\n"
                        "stops:\n"
                        "  phi: [-1, 1]\n"
                        "gears:\n"
                        "  g: {mesh: [a, b], teeth: [20, 30]}\n"
                        "racks:\n"
                        "  r: {pinion: a, rack: b, radius: 0.05}\n"
                        "belts:\n"
                        "  t: {between: [a, b], radii: [0.1, 0.2]}\n");
    yk_builder_free(b);
}

// An open chain of random pins: by calls, and the same as text made here.
static void test_random_chains_by_calls_and_by_text(void **context)
{
    (void)context;
    for (uint64_t seed = 1; seed <= 50; seed++) {
        uint64_t random = seed;
        size_t count = 1 + check_random(&random) % 40;
        YkBuilder *b = yk_builder_new("chain");
        char *bodies = calloc(count + 1, 200), *joints = calloc(count + 1, 100), *start = calloc(count + 1, 60);
        char *text = calloc(count + 1, 400);
        for (size_t i = 1; i <= count; i++) {
            double x = check_uniform(&random, -1, 1), y = check_uniform(&random, -1, 1);
            double angle = check_uniform(&random, -3, 3);
            char body[16], before[16], pin[16], next[16], coordinate[16];
            snprintf(body, sizeof body, "b%zu", i);
            snprintf(before, sizeof before, i == 1 ? "ground" : "b%zu", i - 1);
            snprintf(pin, sizeof pin, "P%zu", i);
            snprintf(next, sizeof next, "P%zu", i + 1);
            snprintf(coordinate, sizeof coordinate, "q%zu", i);
            yk_builder_body(b, body);
            if (i == 1) yk_builder_point(b, before, pin, 0, 0);
            yk_builder_point(b, body, pin, 0, 0);
            yk_builder_point(b, body, next, x, y);
            yk_builder_pin(b, pin, before, body, NULL, coordinate);
            yk_builder_start(b, coordinate, angle);
            snprintf(bodies + strlen(bodies), 200, "  %s: {points: {%s: [0, 0], %s: [%.17g, %.17g]}}\n", body, pin,
                     next, x, y);
            snprintf(joints + strlen(joints), 100, "  %s: {pin: [%s, %s], angle: %s}\n", pin, before, body, coordinate);
            snprintf(start + strlen(start), 60, "  %s: %.17g\n", coordinate, angle);
        }
        snprintf(text, (count + 1) * 400, "bodies:\n  ground: {points: {P1: [0, 0]}}\n%sjoints:\n%sstart:\n%s", bodies,
                 joints, start);
        YkProblems *problems = yk_problems_new();
        YkModel *models[2] = {yk_builder_model(b, NULL, problems),
                              yk_model_parse(text, strlen(text), "chain", NULL, problems)};
        double ends[2][2];
        for (int k = 0; k < 2; k++) {
            YkMechanism *mech = models[k] ? yk_mechanism_compile(models[k], NULL, problems) : NULL;
            YkState *state = mech ? yk_state_new(mech) : NULL;
            if (!state) print_error("seed %d: %s", (int)seed, yk_problems_text(problems, 0));
            assert_non_null(state);
            assert_int_equal(yk_state_set_time(state, 0, problems), YK_OK);
            assert_int_equal(yk_state_assemble(state), YK_OK);
            char name[40];
            snprintf(name, sizeof name, "b%zu.P%zu", count, count + 1);
            YkPointMotion end = yk_state_point(state, yk_model_find_point(models[k], name));
            memcpy(ends[k], end.position, sizeof ends[k]);
            yk_state_free(state);
            yk_mechanism_free(mech);
            yk_model_free(models[k]);
        }
        assert_memory_equal(ends[0], ends[1], sizeof ends[0]);
        yk_problems_free(problems);
        yk_builder_free(b);
        free(bodies);
        free(joints);
        free(start);
        free(text);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_calls_make_the_machine),
        cmocka_unit_test(test_what_was_set_is_replaced_and_removed),
        cmocka_unit_test(test_problems_name_what_they_are_about),
        cmocka_unit_test(test_problems_print_the_place_by_name),
        cmocka_unit_test(test_every_call_says_what_a_file_would),
        cmocka_unit_test(test_random_chains_by_calls_and_by_text),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
