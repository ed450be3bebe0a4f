// Bodies without a way to the ground, and links of no length.
#include "model/fixture.h"

static void bodies_without_a_way_to_the_ground_are_named_group_by_group(void **state)
{
    (void)state;
    YkProblems *problems = fixture_refuse("bodies: {a: {}, b: {}, c: {}, d: {}, e: {}, f: {}, g: {}}\n"
                                          "joints: {A: {pin: [ground, d]}, B: {pin: [b, a]}, C: {pin: [f, b]}, "
                                          "D: {slide: [d, e]}, E: {weld: [g, c]}}\n");
    assert_int_equal(yk_problems_error_count(problems), 2);
    const YkProblem *first = yk_problems_get(problems, 0), *second = first;
    for (size_t i = 1; i < yk_problems_count(problems); i++) { // warnings of short links lie between
        if (yk_problems_get(problems, i)->code == YK_CODE_NOT_CONNECTED) second = yk_problems_get(problems, i);
    }
    assert_int_equal(first->code, YK_CODE_NOT_CONNECTED);
    assert_non_null(strstr(first->message, "`a`, `b` and `f` are not connected"));
    assert_int_equal(first->place.column, 10);
    assert_non_null(strstr(second->message, "`c` and `g` are"));
    yk_problems_free(problems);
    fixture_refused("bodies: {a: {}}\n", YK_CODE_NOT_CONNECTED, 1, 10, "`a` is not connected");
}

static void a_large_group_is_cut_in_its_message(void **state)
{
    (void)state;
    char text[9000];
    size_t n = (size_t)snprintf(text, sizeof text, "bodies: {");
    for (int i = 0; i < 100; i++) n += (size_t)snprintf(text + n, sizeof text - n, "b%d: {}, ", i);
    n += (size_t)snprintf(text + n, sizeof text - n, "}\njoints: {");
    for (int i = 1; i < 100; i++)
        n += (size_t)snprintf(text + n, sizeof text - n, "J%d: {pin: [b%d, b%d]}, ", i, i - 1, i);
    snprintf(text + n, sizeof text - n, "}\n");
    YkProblems *problems = fixture_refuse(text);
    assert_int_equal(yk_problems_error_count(problems), 1);
    const YkProblem *problem = fixture_problem(problems, YK_CODE_NOT_CONNECTED);
    assert_non_null(problem);
    assert_non_null(strstr(problem->message, "and 92 more are not connected"));
    yk_problems_free(problems);
}

static void connections_are_not_judged_where_a_joint_is_broken(void **state)
{
    (void)state;
    fixture_refused("bodies: {a: {}, b: {}}\njoints: {A: {pin: [ground, x]}, B: {pin: [a, b]}}\n", YK_CODE_UNKNOWN_BODY,
                    2, 28, "`x`");
}

static size_t warnings(const char *text, const char *part)
{
    YkProblems *problems = yk_problems_new();
    YkModel *model = yk_model_parse(text, strlen(text), "test", NULL, problems);
    assert_non_null(model);
    size_t count = yk_problems_count(problems);
    for (size_t i = 0; i < count; i++) {
        assert_int_equal(yk_problems_get(problems, i)->code, YK_CODE_COINCIDENT_PINS);
        assert_int_equal(yk_problems_get(problems, i)->severity, YK_SEVERITY_WARNING);
        assert_non_null(strstr(yk_problems_get(problems, i)->message, part));
    }
    yk_model_free(model);
    yk_problems_free(problems);
    return count;
}

// Body b with its points A and B, between two bodies that turn about the ground.
#define LINK(points, second)                                                                                           \
    "bodies: {ground: {points: {O: [0, 0], Q: [1, 0]}}, a: {points: {O: [0, 0], A: [1, 0]}}, b: {points: " points      \
    "}, c: {points: {Q: [0, 0], B: [1, 0]}}}\n"                                                                        \
    "joints: {O: {pin: [ground, a]}, Q: {pin: [ground, c]}, A: {pin: [a, b]}, B: {" second ": [c, b]}}\n"

static void a_link_of_no_length_is_a_warning(void **state)
{
    (void)state;
    assert_int_equal(warnings(LINK("{A: [0.3, 0], B: [0.1 + 0.2, 0]}", "pin"), "`A` and `B` coincide"), 1);
    assert_int_equal(warnings(LINK("{A: [0.3, 0], B: [0.3, 1e-6]}", "pin"), ""), 0);
    assert_int_equal(warnings(LINK("{A: [0.3, 0], B: [0.3, 0]}", "pin-slot"), ""), 0);
}

static void two_pins_at_the_origin_are_a_link_of_no_length(void **state)
{
    (void)state;
    assert_int_equal(warnings("bodies: {b: {}, c: {}}\njoints: {A: {pin: [ground, b]}, B: {pin: [b, c]}}\n",
                              "`b` is a link without length: both its pins lie at its origin"),
                     1);
    assert_int_equal(warnings("bodies: {ground: {points: {A: [1, 0]}}, b: {points: {A: [0, 0]}}, c: {}}\n"
                              "joints: {A: {pin: [ground, b]}, B: {pin: [b, c]}}\n",
                              "`b` is a link without length: its point `A` lies at its origin, as its other pin does"),
                     1);
    assert_int_equal(warnings("bodies: {b: {}, c: {}, d: {}}\n"
                              "joints: {A: {pin: [ground, b]}, B: {pin: [b, c]}, C: {pin: [b, d]}}\n",
                              ""),
                     0);
}

static void a_link_is_not_judged_where_its_joint_is_broken(void **state)
{
    (void)state;
    static const char text[] = "bodies: {a: {points: {A: [0, 0], B: [1, 0]}}}\n"
                               "joints: {A: {pin: [ground, a]}, B: {pin: [a, x]}}\n";
    YkProblems *problems = yk_problems_new();
    assert_null(yk_model_parse(text, strlen(text), "test", NULL, problems));
    for (size_t i = 0; i < yk_problems_count(problems); i++)
        assert_int_not_equal(yk_problems_get(problems, i)->code, YK_CODE_COINCIDENT_PINS);
    yk_problems_free(problems);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(bodies_without_a_way_to_the_ground_are_named_group_by_group),
        cmocka_unit_test(a_large_group_is_cut_in_its_message),
        cmocka_unit_test(connections_are_not_judged_where_a_joint_is_broken),
        cmocka_unit_test(a_link_of_no_length_is_a_warning),
        cmocka_unit_test(two_pins_at_the_origin_are_a_link_of_no_length),
        cmocka_unit_test(a_link_is_not_judged_where_its_joint_is_broken),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
