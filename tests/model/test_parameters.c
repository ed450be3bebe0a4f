// Parameters: values, order, circles; and values given from outside.
#include <stdlib.h>
#include "base/text.h"
#include "model/fixture.h"

static double value(const YkModel *model, const char *name)
{
    return fixture_parameter(model, name)->value;
}

static void parameters_may_be_defined_in_any_order(void **state)
{
    (void)state;
    YkModel *model = fixture_load("parameters: {c: a + b, b: 2*a, a: 3/4 m}\n" CRANK);
    CHECK_NEAR(value(model, "a"), 0.75, 0);
    CHECK_NEAR(value(model, "b"), 1.5, 0);
    CHECK_NEAR(value(model, "c"), 2.25, 0);
    assert_true(yk_dimension_equal(fixture_parameter(model, "c")->dimension, (YkDimension){.length = 1}));
    yk_model_free(model);
}

static void a_bare_parameter_takes_the_unit_of_its_use(void **state)
{
    (void)state;
    YkModel *model = fixture_load("units: {length: mm, angle: deg}\nparameters: {r: 20, n: 3, phi: 30}\n"
                                  "bodies: {b: {points: {P: [r*cos(phi), n*r]}}}\njoints: {O: {pin: [ground, b]}}\n");
    CHECK_NEAR(value(model, "r"), 0.02, 1e-17);
    CHECK_NEAR(value(model, "n"), 3, 0);
    CHECK_NEAR(value(model, "phi"), YK_PI / 6, 1e-16);
    CHECK_NEAR(fixture_point(model, "b.P")->at.x, 0.02 * cos(YK_PI / 6), 1e-17);
    CHECK_NEAR(fixture_point(model, "b.P")->at.y, 0.06, 1e-16);
    yk_model_free(model);
}

static void a_chain_of_a_hundred_thousand_definitions_is_evaluated(void **state)
{
    (void)state;
    YkText text = {0};
    yk_text_puts(&text, "parameters:\n");
    for (int i = 100000; i > 0; i--) yk_text_format(&text, "  p%d: p%d + 1\n", i, i - 1); // each needs the next
    yk_text_puts(&text, "  p0: 5\n" CRANK);
    YkModel *model = fixture_load(yk_text_get(&text));
    CHECK_NEAR(model->parameters[0].value, 100005, 0);
    yk_model_free(model);
    yk_text_free(&text);
}

static void a_circle_is_reported_once_with_the_names_along_it(void **state)
{
    (void)state;
    fixture_refused("parameters: {a: b + 1, b: 2*c, c: a}\n" CRANK, YK_CODE_PARAMETER_CYCLE, 1, 14, "a -> b -> c -> a");
    fixture_refused("parameters: {x: x}\n" CRANK, YK_CODE_PARAMETER_CYCLE, 1, 14, "x -> x");
}

static void a_long_circle_is_cut_in_its_message(void **state)
{
    (void)state;
    YkText text = {0};
    yk_text_puts(&text, "parameters:\n");
    for (int i = 0; i < 1000; i++) yk_text_format(&text, "  p%d: p%d\n", i, (i + 1) % 1000);
    yk_text_puts(&text, CRANK);
    YkProblems *problems = fixture_refuse(yk_text_get(&text));
    assert_int_equal(yk_problems_error_count(problems), 1);
    const char *message = yk_problems_get(problems, 0)->message;
    assert_non_null(strstr(message, "p0 -> p1 ->"));
    assert_non_null(strstr(message, "... -> p0"));
    assert_true(strlen(message) < 200);
    yk_problems_free(problems);
    yk_text_free(&text);
}

static void what_depends_on_a_faulty_parameter_is_not_reported_again(void **state)
{
    (void)state;
    fixture_refused("parameters: {a: 1/0, b: 2*a, c: b + a}\n" CRANK, YK_CODE_EVALUATION, 1, 17, "division by zero");
    fixture_refused("parameters: {a: z, b: 2*a}\n" CRANK, YK_CODE_UNKNOWN_NAME, 1, 17, "`z`");
}

static void names_and_values_of_parameters_are_checked(void **state)
{
    (void)state;
    fixture_refused("parameters: {sin: 3}\n" CRANK, YK_CODE_RESERVED_NAME, 1, 14, "function");
    fixture_refused("parameters: {a-b: 3}\n" CRANK, YK_CODE_BAD_NAME, 1, 14, "a-b");
    fixture_refused("parameters: {a: [1, 2]}\n" CRANK, YK_CODE_WRONG_KIND, 1, 17, "a list");
    fixture_refused("parameters: {a: }\n" CRANK, YK_CODE_EMPTY_VALUE, 1, 17, "parameter `a`");
    fixture_refused("parameters: {a: 1e101 m}\n" CRANK, YK_CODE_VALUE_RANGE, 1, 17, "1e100");
    fixture_refused("parameters: {a: t}\n" CRANK, YK_CODE_NAME_NOT_HERE, 1, 17, "time");
    fixture_refused("parameters: {a: 2*theta}\n" CRANK, YK_CODE_NAME_NOT_HERE, 1, 19, "coordinate");
}

static YkModel *load_with(const char *text, const char *name, const char *given)
{
    YkOverride override = {name, given};
    return fixture_load_with(text, &(YkLoadOptions){&override, 1});
}

static const char link_file[] = "units: {length: mm}\nparameters: {a: 100, b: 2*a, c: 3 kg}\n"
                                "bodies: {k: {points: {P: [b, 0]}, mass: c}}\njoints: {O: {pin: [ground, k]}}\n";

static void a_value_from_outside_replaces_the_files_own(void **state)
{
    (void)state;
    YkModel *model = load_with(link_file, "a", "75");
    CHECK_NEAR(fixture_point(model, "k.P")->at.x, 0.15, 1e-16);
    yk_model_free(model);
    model = load_with(link_file, "a", "2 in");
    CHECK_NEAR(fixture_point(model, "k.P")->at.x, 0.1016, 1e-16);
    yk_model_free(model);
    model = load_with(link_file, "b", "a/4 + 1");
    CHECK_NEAR(fixture_point(model, "k.P")->at.x, 0.026, 1e-16);
    yk_model_free(model);
}

static void the_last_of_two_values_counts(void **state)
{
    (void)state;
    YkOverride overrides[] = {{"a", "10"}, {"a", "20"}};
    YkModel *model = fixture_load_with(link_file, &(YkLoadOptions){overrides, 2});
    CHECK_NEAR(value(model, "a"), 0.02, 1e-17);
    yk_model_free(model);
}

static void refused_override(const char *name, const char *given, int code, const char *part)
{
    YkOverride override = {name, given};
    YkProblems *problems = fixture_refuse_with(link_file, &(YkLoadOptions){&override, 1});
    const YkProblem *problem = fixture_problem(problems, code);
    if (!problem) print_error("%s", yk_problems_text(problems, 0));
    assert_non_null(problem);
    assert_int_equal(problem->place.line, code == YK_CODE_PARAMETER_CYCLE ? 2 : 0); // a circle runs through the file
    if (!strstr(problem->message, part)) assert_non_null(strstr(problem->hint, part));
    yk_problems_free(problems);
}

static void a_wrong_value_from_outside_is_reported_nowhere_in_the_file(void **state)
{
    (void)state;
    refused_override("d", "1", YK_CODE_UNKNOWN_OVERRIDE, "`d`");
    refused_override("aa", "1", YK_CODE_UNKNOWN_OVERRIDE, "did you mean `a`");
    refused_override("c", "1 m", YK_CODE_OVERRIDE_DIMENSION, "a length");
    refused_override("a", "b", YK_CODE_PARAMETER_CYCLE, "b -> a");
    refused_override("a", "q", YK_CODE_UNKNOWN_NAME, "`q`");
    refused_override("a", "1/0", YK_CODE_EVALUATION, "division by zero");
}

static void a_malformed_value_from_outside_names_itself(void **state)
{
    (void)state;
    const char *given[] = {"", "3 +", "(", "3 furlongs"};
    for (size_t i = 0; i < 4; i++) {
        YkOverride override = {"a", given[i]};
        YkProblems *problems = fixture_refuse_with(link_file, &(YkLoadOptions){&override, 1});
        assert_non_null(strstr(yk_problems_get(problems, 0)->message, "`a`"));
        assert_int_equal(yk_problems_get(problems, 0)->place.line, 0);
        yk_problems_free(problems);
    }
}

static void the_default_options_change_nothing(void **state)
{
    (void)state;
    YkLoadOptions options = yk_default_load_options();
    YkModel *model = fixture_load_with(link_file, &options);
    CHECK_NEAR(value(model, "a"), 0.1, 1e-17);
    yk_model_free(model);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(parameters_may_be_defined_in_any_order),
        cmocka_unit_test(a_bare_parameter_takes_the_unit_of_its_use),
        cmocka_unit_test(a_chain_of_a_hundred_thousand_definitions_is_evaluated),
        cmocka_unit_test(a_circle_is_reported_once_with_the_names_along_it),
        cmocka_unit_test(a_long_circle_is_cut_in_its_message),
        cmocka_unit_test(what_depends_on_a_faulty_parameter_is_not_reported_again),
        cmocka_unit_test(names_and_values_of_parameters_are_checked),
        cmocka_unit_test(a_value_from_outside_replaces_the_files_own),
        cmocka_unit_test(the_last_of_two_values_counts),
        cmocka_unit_test(a_wrong_value_from_outside_is_reported_nowhere_in_the_file),
        cmocka_unit_test(a_malformed_value_from_outside_names_itself),
        cmocka_unit_test(the_default_options_change_nothing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
