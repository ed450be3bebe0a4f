// A file in another order is the same machine: freedoms, poses, and the signs of its branches.
#include <yoke/yoke.h>
#include "check.h"

typedef struct Answer {
    char label[16];
    double u, v;
    int freedom;
} Answer;

static YkMechanism *compile(const char *text, const char *input, YkModel **model, YkProblems *problems)
{
    YkCompileOptions options = {.inputs = &input, .input_count = input ? 1 : 0};
    *model = yk_model_parse(text, strlen(text), "test.yaml", NULL, problems);
    if (!*model) print_error("%s\n%s", text, yk_problems_text(problems, 0));
    assert_non_null(*model);
    return yk_mechanism_compile(*model, &options, problems);
}

static Answer answer_of(const char *text)
{
    Answer a = {.label = ""};
    YkProblems *problems = yk_problems_new();
    YkModel *model;
    YkMechanism *mech = compile(text, NULL, &model, problems);
    assert_non_null(mech);
    YkState *state = yk_state_new(mech);
    assert_int_equal(yk_state_assemble(state), YK_OK);
    yk_state_label(state, a.label, sizeof a.label);
    a.u = yk_state_coordinate(state, yk_coordinate_find(mech, "u")).position;
    a.v = yk_state_coordinate(state, yk_coordinate_find(mech, "v")).position;
    a.freedom = (int)yk_input_count(mech);
    yk_state_free(state);
    yk_mechanism_free(mech);
    yk_model_free(model);
    yk_problems_free(problems);
    return a;
}

// The joints in one of 24 orders; that without a coordinate from either of its bodies to the other.
static Answer answer_in_order(const char *bodies, const char *const joints[4], const char *turned, const char *start,
                              int order)
{
    char text[1500];
    bool is_used[4] = {false};
    int at = snprintf(text, sizeof text, "%sjoints:\n", bodies);
    for (int k = 4, rest = order % 24; k > 0; rest /= k, k--) {
        int skip = rest % k, j = 0;
        while (is_used[j] || skip-- > 0) j++;
        is_used[j] = true;
        at += snprintf(text + at, sizeof text - (size_t)at, "  %s\n", j == 3 && order >= 24 ? turned : joints[j]);
    }
    snprintf(text + at, sizeof text - (size_t)at, "%s", start);
    return answer_of(text);
}

static void check_orders(const char *bodies, const char *const joints[4], const char *turned, const char *start)
{
    Answer first = answer_in_order(bodies, joints, turned, start, 0);
    assert_int_equal(strlen(first.label), 2); // a joint and the sign
    for (int order = 1; order < 48; order++) {
        Answer other = answer_in_order(bodies, joints, turned, start, order);
        assert_int_equal(other.label[1], first.label[1]);
        assert_int_equal(other.freedom, first.freedom);
        CHECK_NEAR(other.u, first.u, 1e-12);
        CHECK_NEAR(other.v, first.v, 1e-12);
    }
}

static void the_order_of_joints_changes_no_branch(void **unused)
{
    (void)unused;
    static const char *const four[] = {"O: {pin: [ground, crank], angle: q}", "A: {pin: [crank, coupler], angle: u}",
                                       "Q: {pin: [ground, rocker], angle: v}", "B: {pin: [coupler, rocker]}"},
                             *const slider[] = {
                                 "O: {pin: [ground, crank], angle: q}", "A: {pin: [crank, rod], angle: u}",
                                 "R: {slide: [ground, piston], along: x, distance: v}", "B: {pin: [rod, piston]}"};
    static const char *const bodies = "bodies:\n  ground: {points: {O: [0, 0], Q: [2, 0]}}\n"
                                      "  crank: {points: {O: [0, 0], A: [0.7, 0]}}\n"
                                      "  coupler: {points: {A: [0, 0], B: [2.1, 0]}}\n"
                                      "  rocker: {points: {Q: [0, 0], B: [1.8, 0]}}\n",
                             *const others =
                                 "bodies:\n  ground: {points: {O: [0, 0]}}\n"
                                 "  crank: {points: {O: [0, 0], A: [0.7, 0]}}\n"
                                 "  rod: {points: {A: [0, 0], B: [2.1, 0]}}\n  piston: {points: {B: [0, 0]}}\n";
    for (int branch = 0; branch < 2; branch++) {
        check_orders(bodies, four, "B: {pin: [rocker, coupler]}",
                     branch ? "drives: {q: 1 rad}\nstart: {u: -2.8, v: -1.9}\n"
                            : "drives: {q: 1 rad}\nstart: {u: -0.4, v: 1.3}\n");
        check_orders(others, slider, "B: {pin: [piston, rod]}",
                     branch ? "drives: {q: 1 rad}\nstart: {u: -3.8, v: -1.6}\n"
                            : "drives: {q: 1 rad}\nstart: {u: -1.3, v: 2.4}\n");
    }
}

static void an_input_that_does_not_exist_is_refused(void **unused)
{
    (void)unused;
    static const char *const text = "bodies: {a: {}, b: {}}\njoints:\n  A: {pin: [ground, a], angle: q}\n"
                                    "  B: {slide: [ground, b], along: x, distance: s}\n";
    static const char *const names[] = {"q", "s", "r", "A", ""};
    for (size_t k = 0; k < sizeof names / sizeof *names; k++) {
        YkProblems *problems = yk_problems_new();
        YkModel *model;
        YkMechanism *mech = compile(text, names[k], &model, problems);
        assert_int_equal(mech != NULL, k < 2);
        assert_int_equal(yk_problems_count(problems), k < 2 ? 0 : 1);
        yk_mechanism_free(mech);
        yk_model_free(model);
        yk_problems_free(problems);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_order_of_joints_changes_no_branch),
        cmocka_unit_test(an_input_that_does_not_exist_is_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
