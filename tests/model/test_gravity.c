// Gravity, and its unit.
#include "fixture.h"

static const YkProblem *warning(const char *text, YkProblems **problems)
{
    *problems = yk_problems_new();
    YkModel *model = yk_model_parse(text, strlen(text), "test.yaml", NULL, *problems);
    assert_non_null(model);
    yk_model_free(model);
    return fixture_problem(*problems, YK_CODE_ODD_GRAVITY);
}

static void warns(const char *head, const char *part)
{
    char text[512];
    YkProblems *problems;
    snprintf(text, sizeof text, "%s" CRANK, head);
    const YkProblem *problem = warning(text, &problems);
    if (!problem || !problem->hint || !strstr(problem->hint, part))
        print_error("%s%s", head, yk_problems_text(problems, 0));
    assert_non_null(problem);
    assert_non_null(strstr(problem->hint, part));
    yk_problems_free(problems);
}

static void is_silent(const char *head)
{
    char text[512];
    YkProblems *problems;
    snprintf(text, sizeof text, "%s" CRANK, head);
    const YkProblem *problem = warning(text, &problems);
    if (problem) print_error("%s%s", head, yk_problems_text(problems, 0));
    assert_null(problem);
    yk_problems_free(problems);
}

static void a_bare_gravity_unlike_any_planets_warns_and_says_what_may_be_meant(void **state)
{
    (void)state;
    warns("units: {length: mm}\ngravity: [0, -9.81]\n", "`-9.81 m/s^2`");
    warns("units: {length: mm}\nparameters: {g: 9.81}\ngravity: [0, -g]\n", "`-9.81 m/s^2`");
    warns("units: {length: cm}\ngravity: [-9.81*sin(10 deg), -9.81*cos(10 deg)]\n", "`9.81 m/s^2`");
    warns("gravity: [0, -9810]\n", "`-9810 mm/s^2`");
    warns("gravity: [0, -981]\n", "`-981 cm/s^2`");
    warns("units: {length: ft}\ngravity: [0, -9.81]\n", "`-9.81 m/s^2`");
    warns("gravity: [0, -386]\n", "`-386 in/s^2`");
    warns("gravity: [0, -1e9]\n", "`-9.81 m/s^2`");
    warns("units: {length: mm}\ngravity: [0, -24.8]\n", "`-24.8 m/s^2`"); // Jupiter's
    warns("gravity: [0, -32.17]\n", "`-32.17 ft/s^2`");
}

static void the_message_converts_gravity_only_where_the_file_has_other_units(void **state)
{
    (void)state;
    static const char *const heads[] = {"gravity: [0, -981]\n", "units: {length: mm}\ngravity: [0, -9.81]\n"};
    for (int k = 0; k < 2; k++) {
        char text[512];
        YkProblems *problems;
        snprintf(text, sizeof text, "%s" CRANK, heads[k]);
        const YkProblem *problem = warning(text, &problems);
        assert_non_null(problem);
        assert_int_equal(strstr(problem->message, "which is") != NULL, k);
        yk_problems_free(problems);
    }
}

static void gravity_with_a_unit_or_of_a_planet_is_taken_as_it_is(void **state)
{
    (void)state;
    is_silent("gravity: [0, -9.81]\n");
    is_silent("gravity: [0, -1.62]\n");
    is_silent("gravity: [0, 24.8]\n");
    is_silent("gravity: [0, 0]\n");
    is_silent("units: {length: mm}\ngravity: [0, -9810]\n");
    is_silent("units: {length: mm}\ngravity: [0, -9.81 m/s^2]\n");
    is_silent("units: {length: ft}\ngravity: [0, -32.2]\n");
    is_silent("gravity: [0, -1e-6 m/s^2]\n"); // free fall, nearly
    is_silent("parameters: {g: 9810 mm/s^2}\nunits: {length: cm}\ngravity: [0, -g]\n");
}

// What a bare number means is not known then: the mistake in `units:` is told, and nothing that may only follow from
// it.
static void bad_units_are_no_reason_to_doubt_gravity(void **state)
{
    (void)state;
    static const char text[] = "units: {length: mn}\ngravity: [0, -9810]\n" CRANK;
    YkProblems *problems = yk_problems_new();
    assert_null(yk_model_parse(text, strlen(text), "test.yaml", NULL, problems));
    assert_non_null(fixture_problem(problems, YK_CODE_UNITS_ENTRY));
    assert_null(fixture_problem(problems, YK_CODE_ODD_GRAVITY));
    yk_problems_free(problems);
}

// Each parameter is twice the one before: a walk that looks at every use anew never ends.
static void gravity_of_a_long_chain_of_doubled_parameters_is_read(void **state)
{
    (void)state;
    enum { DOUBLED = 60 };
    char text[4096];
    int used = snprintf(text, sizeof text, "parameters:\n  p0: 1\n");
    for (int k = 1; k <= DOUBLED; k++)
        used += snprintf(text + used, sizeof text - (size_t)used, "  p%d: p%d + p%d\n", k, k - 1, k - 1);
    snprintf(text + used, sizeof text - (size_t)used, "gravity: [0, -p%d]\n" CRANK, DOUBLED);
    YkProblems *problems;
    assert_null(warning(text, &problems)); // whether a unit is in it is not known
    yk_problems_free(problems);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(bad_units_are_no_reason_to_doubt_gravity),
        cmocka_unit_test(a_bare_gravity_unlike_any_planets_warns_and_says_what_may_be_meant),
        cmocka_unit_test(the_message_converts_gravity_only_where_the_file_has_other_units),
        cmocka_unit_test(gravity_with_a_unit_or_of_a_planet_is_taken_as_it_is),
        cmocka_unit_test(gravity_of_a_long_chain_of_doubled_parameters_is_read),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
