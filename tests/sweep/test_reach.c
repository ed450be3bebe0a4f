// Equilibria that a machine can get to, against known circuits of linkages.
#include <yoke/yoke.h>
#include "check.h"
#include "rest/rest.h"

static YkRest *rest_of(const char *text, YkModel **model)
{
    YkProblems *problems = yk_problems_new();
    *model = yk_model_parse(text, strlen(text), "t.yaml", NULL, problems);
    if (!*model) print_error("%s", yk_problems_text(problems, 0));
    assert_non_null(*model);
    YkRest *rest = yk_rest_find(*model, NULL, problems);
    assert_non_null(rest);
    assert_int_equal(yk_rest_reach(rest), YK_OK);
    yk_problems_free(problems);
    return rest;
}

static double value_of(YkRest *rest, size_t index, const char *name)
{
    const YkMechanism *mech = yk_rest_mechanism(rest);
    return yk_state_coordinate(yk_rest_state(rest, index), yk_coordinate_find(mech, name)).position;
}

#define FOUR_BAR(ground, crank, coupler, rocker)                                                                       \
    "gravity: [0, -10]\nbodies:\n  ground: {points: {O: [0, 0], Q: [" #ground ", 0]}}\n"                               \
    "  crank: {points: {O: [0, 0], A: [" #crank ", 0]}, mass: 1, rod: [O, A]}\n"                                       \
    "  coupler: {points: {A: [0, 0], B: [" #coupler ", 0]}, mass: 1, rod: [A, B]}\n"                                   \
    "  rocker: {points: {Q: [0, 0], B: [" #rocker ", 0]}, mass: 1, rod: [Q, B]}\n"                                     \
    "joints:\n  O: {pin: [ground, crank], angle: q}\n  A: {pin: [crank, coupler], angle: c}\n"                         \
    "  Q: {pin: [ground, rocker], angle: r}\n  B: {pin: [coupler, rocker]}\n"

// A Grashof linkage has two circuits, mirror images of each other: on each the angle from coupler to rocker keeps its
// sign. As the crank turns right round or, driven at the rocker, through its dead points.
static void a_crank_rocker_stays_on_its_circuit(void **unused)
{
    (void)unused;
    static const char *const starts[] = {"start: {q: 1, c: 0, r: 1.5}\n", "start: {r: 1.7, q: 1, c: 0}\n"};
    for (int k = 0; k < 2; k++) {
        char text[1200];
        snprintf(text, sizeof text, FOUR_BAR(1, 0.3, 0.9, 0.6) "%s", starts[k]);
        YkModel *model;
        YkRest *rest = rest_of(text, &model);
        size_t reached = 0, count = yk_rest_count(rest);
        for (size_t i = 0; i < count; i++) {
            double between = value_of(rest, i, "r") - value_of(rest, i, "q") - value_of(rest, i, "c");
            bool is_own = sin(between) > 0; // as at the start
            assert_int_equal(yk_rest_equilibrium(rest, i).is_reachable, is_own);
            reached += is_own;
        }
        assert_true(reached >= 2 && reached < count);
        yk_rest_free(rest);
        yk_model_free(model);
    }
}

// A linkage that is not Grashof's has one circuit: all that closes can be reached, though every coordinate turns back
// somewhere.
static void a_triple_rocker_reaches_all(void **unused)
{
    (void)unused;
    static const char *const starts[] = {"start: {q: 1, c: 0, r: 1.5}\n", "start: {q: -1, c: 0, r: -1.5}\n",
                                         "start: {q: 1, c: -2, r: -1.5}\n"};
    for (int k = 0; k < 3; k++) {
        char text[1200];
        snprintf(text, sizeof text, FOUR_BAR(1, 0.7, 0.8, 0.75) "%s", starts[k]);
        YkModel *model;
        YkRest *rest = rest_of(text, &model);
        assert_true(yk_rest_count(rest) >= 2);
        for (size_t i = 0; i < yk_rest_count(rest); i++) assert_true(yk_rest_equilibrium(rest, i).is_reachable);
        yk_rest_free(rest);
        yk_model_free(model);
    }
}

// The slider of a slider-crank whose rod is longer than its crank stays on its side of the crank's pin.
static void a_slider_stays_on_its_side(void **unused)
{
    (void)unused;
    YkProblems *problems = yk_problems_new();
    YkModel *model = yk_model_load(YOKE_ROOT "/examples/spring-slider-crank.yaml", NULL, problems);
    YkRest *rest = yk_rest_find(model, NULL, problems);
    assert_true(rest && yk_rest_reach(rest) == YK_OK);
    size_t reached = 0;
    for (size_t i = 0; i < yk_rest_count(rest); i++) {
        bool is_own = value_of(rest, i, "x") > 0.5 * cos(value_of(rest, i, "q"));
        assert_int_equal(yk_rest_equilibrium(rest, i).is_reachable, is_own);
        reached += is_own;
    }
    assert_true(reached > 0 && reached < yk_rest_count(rest));
    yk_rest_free(rest);
    yk_model_free(model);
    yk_problems_free(problems);
}

static void an_open_chain_reaches_all(void **unused)
{
    (void)unused;
    YkModel *model;
    YkRest *rest = rest_of("gravity: [0, -10]\nbodies:\n  ground: {points: {O: [0, 0]}}\n"
                           "  a: {points: {O: [0, 0], P: [0, -1]}, mass: 1, center: [0, -1]}\n"
                           "  b: {points: {P: [0, 0]}, mass: 1, center: [0, -1]}\njoints:\n"
                           "  O: {pin: [ground, a], angle: x}\n  P: {pin: [a, b], angle: y}\nstart: {x: 1, y: 2}\n",
                           &model);
    assert_int_equal(yk_rest_count(rest), 4);
    for (size_t i = 0; i < 4; i++) assert_true(yk_rest_equilibrium(rest, i).is_reachable);
    yk_rest_free(rest);
    yk_model_free(model);
}

static bool refuse(void *context, double part)
{
    (void)part;
    ++*(size_t *)context;
    return false;
}

// A search that is stopped reports nothing that it has found so far.
static void nothing_is_reached_by_a_search_that_is_stopped(void **unused)
{
    (void)unused;
    YkProblems *problems = yk_problems_new();
    YkModel *model = yk_model_load(YOKE_ROOT "/examples/spring-slider-crank.yaml", NULL, problems);
    size_t count = 0, least = 0;
    YkRestOptions options = yk_default_rest_options();
    YkRest *rest = yk_rest_find(model, &options, problems);
    assert_true(rest && yk_rest_reach(rest) == YK_OK);
    for (size_t i = 0; i < yk_rest_count(rest); i++) least += yk_rest_equilibrium(rest, i).is_reachable;
    assert_true(least > 0);
    rest->progress = (YkProgress){refuse, &count};
    assert_int_equal(yk_rest_reach(rest), YK_STOPPED);
    assert_int_equal(count, 1);
    for (size_t i = 0; i < yk_rest_count(rest); i++) assert_false(yk_rest_equilibrium(rest, i).is_reachable);
    yk_rest_free(rest);
    yk_model_free(model);
    yk_problems_free(problems);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_crank_rocker_stays_on_its_circuit),
        cmocka_unit_test(a_triple_rocker_reaches_all),
        cmocka_unit_test(a_slider_stays_on_its_side),
        cmocka_unit_test(an_open_chain_reaches_all),
        cmocka_unit_test(nothing_is_reached_by_a_search_that_is_stopped),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
