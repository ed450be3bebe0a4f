// Values from the command line in the model's terms, and the public questions about the model's contents.
#include "model/fixture.h"

static const char file[] = "units: {length: mm, angle: deg, force: N}\nparameters: {a1: 250, w: 30 deg/s, n: 3}\n"
                           "bodies: {ground: {points: {O: [0, 0]}}, crank: {points: {O: [0, 0], A: [a1, 0]}}}\n"
                           "joints: {O: {pin: [ground, crank], angle: theta}}\ndrives: {theta: n*w*t}\n";

static void check_value(const YkModel *model, const char *text, YkQuantity quantity, double expected)
{
    YkProblems *problems = yk_problems_new();
    double value = NAN;
    YkStatus status = yk_model_value(model, text, quantity, &value, problems);
    if (status) print_error("%s", yk_problems_text(problems, 0));
    assert_int_equal(status, YK_OK);
    CHECK_NEAR(value, expected, 1e-14 * fabs(expected));
    yk_problems_free(problems);
}

static void bare_numbers_have_the_files_units(void **state)
{
    (void)state;
    YkModel *model = fixture_load(file);
    check_value(model, "30", YK_QUANTITY_ANGLE, YK_PI / 6);
    check_value(model, "-30", YK_QUANTITY_ANGLE, -YK_PI / 6);
    check_value(model, "30", YK_QUANTITY_LENGTH, 0.03);
    check_value(model, "30", YK_QUANTITY_NUMBER, 30);
    check_value(model, "30", YK_QUANTITY_SPEED, 0.03);
    check_value(model, "30", YK_QUANTITY_TIME, 30);
    check_value(model, "30", YK_QUANTITY_ANGLE_RATE, YK_PI / 6);
    check_value(model, "30", YK_QUANTITY_FORCE, 30);
    check_value(model, "30", YK_QUANTITY_TORQUE, 0.03);
    check_value(model, "30", YK_QUANTITY_ACCELERATION, 0.03);
    check_value(model, "30", YK_QUANTITY_ANGLE_ACCELERATION, YK_PI / 6);
    yk_model_free(model);
}

static void a_bare_number_is_as_large_as_its_unit_says(void **state)
{
    (void)state;
    const char *files[] = {file, CRANK, "units: {length: in, mass: lb, time: ms}\n" CRANK};
    for (size_t i = 0; i < 3; i++) {
        YkModel *model = fixture_load(files[i]);
        for (int quantity = 0; quantity < YK_QUANTITY_COUNT; quantity++) {
            double size = 0;
            yk_model_unit(model, (YkQuantity)quantity, &size);
            check_value(model, "7", (YkQuantity)quantity, 7 * size);
        }
        yk_model_free(model);
    }
}

static void units_and_parameters_may_be_written(void **state)
{
    (void)state;
    YkModel *model = fixture_load(file);
    check_value(model, "30deg", YK_QUANTITY_ANGLE, YK_PI / 6);
    check_value(model, "1.5 rad", YK_QUANTITY_ANGLE, 1.5);
    check_value(model, "pi/2", YK_QUANTITY_ANGLE, YK_PI / 2);
    check_value(model, "a1/2", YK_QUANTITY_LENGTH, 0.125);
    check_value(model, "a1 + 10", YK_QUANTITY_LENGTH, 0.26);
    check_value(model, "0.5 rad/s", YK_QUANTITY_ANGLE_RATE, 0.5);
    check_value(model, "n", YK_QUANTITY_NUMBER, 3);
    check_value(model, "2*w", YK_QUANTITY_ANGLE_RATE, YK_PI / 3);
    yk_model_free(model);
}

static void wrong_values_are_refused_with_their_text(void **state)
{
    (void)state;
    YkModel *model = fixture_load(file);
    const struct {
        const char *text;
        YkQuantity quantity;
    } wrong[] = {{"", YK_QUANTITY_ANGLE},      {"abc", YK_QUANTITY_ANGLE},       {"3 mm", YK_QUANTITY_ANGLE},
                 {"a1", YK_QUANTITY_ANGLE},    {"t", YK_QUANTITY_TIME},          {"theta", YK_QUANTITY_ANGLE},
                 {"1/0", YK_QUANTITY_NUMBER},  {"1e300 km", YK_QUANTITY_LENGTH}, {"3 3", YK_QUANTITY_NUMBER},
                 {"1e101", YK_QUANTITY_NUMBER}};
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
        YkProblems *problems = yk_problems_new();
        double value = 77;
        assert_int_equal(yk_model_value(model, wrong[i].text, wrong[i].quantity, &value, problems), YK_BAD_ARGUMENT);
        assert_true(value == 77);
        assert_true(yk_problems_error_count(problems) > 0);
        char quoted[40];
        snprintf(quoted, sizeof quoted, "`%s`", wrong[i].text);
        assert_non_null(strstr(yk_problems_get(problems, 0)->message, quoted));
        assert_int_equal(yk_problems_get(problems, 0)->place.line, 0);
        assert_int_equal(yk_model_value(model, wrong[i].text, wrong[i].quantity, &value, NULL), YK_BAD_ARGUMENT);
        yk_problems_free(problems);
    }
    yk_model_free(model);
}

static void a_nearly_right_parameter_is_suggested(void **state)
{
    (void)state;
    YkModel *model = fixture_load(file);
    YkProblems *problems = yk_problems_new();
    double value;
    assert_int_equal(yk_model_value(model, "a2/2", YK_QUANTITY_LENGTH, &value, problems), YK_BAD_ARGUMENT);
    assert_string_equal(yk_problems_get(problems, 0)->hint, "did you mean `a1`?");
    yk_problems_free(problems);
    yk_model_free(model);
}

static void the_public_questions_agree_with_each_other(void **state)
{
    (void)state;
    YkModel *model = fixture_load(file);
    for (size_t i = 0; i < yk_model_body_count(model); i++) {
        assert_int_equal(yk_model_find_body(model, yk_model_body_name(model, i)), i);
    }
    for (size_t i = 0; i < yk_model_point_count(model); i++) {
        char name[60];
        snprintf(name, sizeof name, "%s.%s", yk_model_body_name(model, yk_model_point_body(model, i)),
                 yk_model_point_name(model, i));
        assert_int_equal(yk_model_find_point(model, name), i);
    }
    assert_int_equal(yk_model_joint_count(model), 1);
    assert_string_equal(yk_model_joint_name(model, 0), "O");
    assert_string_equal(yk_model_name(model), "test");
    yk_model_free(model);
}

static void what_is_not_there_is_not_found(void **state)
{
    (void)state;
    YkModel *model = fixture_load(file);
    const char *points[] = {"", "crank", "crank.", "crank.Z", ".A", "x.A", "crank.A.B"};
    for (size_t i = 0; i < 7; i++) assert_int_equal(yk_model_find_point(model, points[i]), (size_t)-1);
    assert_int_equal(yk_model_find_body(model, "x"), (size_t)-1);
    assert_int_equal(yk_model_find_body(model, NULL), (size_t)-1);
    assert_null(yk_model_body_name(model, 2));
    assert_null(yk_model_point_name(model, 99));
    assert_int_equal(yk_model_point_body(model, 99), (size_t)-1);
    assert_null(yk_model_joint_name(model, 1));
    yk_model_free(model);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(bare_numbers_have_the_files_units),
        cmocka_unit_test(a_bare_number_is_as_large_as_its_unit_says),
        cmocka_unit_test(units_and_parameters_may_be_written),
        cmocka_unit_test(wrong_values_are_refused_with_their_text),
        cmocka_unit_test(a_nearly_right_parameter_is_suggested),
        cmocka_unit_test(the_public_questions_agree_with_each_other),
        cmocka_unit_test(what_is_not_there_is_not_found),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
