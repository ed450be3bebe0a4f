// Coordinates where they are used: drives and starts.
#include "model/fixture.h"

#define MACHINE                                                                                                        \
    "parameters: {w: 2 rad/s, k: 3}\n"                                                                                 \
    "bodies: {a: {}, b: {}}\n"                                                                                         \
    "joints: {O: {pin: [ground, a], angle: phi}, S: {pin-slot: [a, b], along: x}, J-2: {slide: [ground, b]}}\n"

static void a_joints_coordinate_is_declared_by_its_mention(void **state)
{
    (void)state;
    YkModel *model = fixture_load(MACHINE "drives: {S.angle: w*t}\nstart: {S.distance: 2, J-2.distance.rate: 3}\n"
                                          "efforts: {O.angle: 5}\n");
    const char *names[] = {"phi", "S.angle", "S.distance", "J-2.distance"};
    assert_int_equal(model->coordinate_count, 4);
    for (size_t i = 0; i < 4; i++) assert_string_equal(model->coordinates[i].name, names[i]);
    const YkJoint *slot = fixture_joint(model, "S");
    assert_int_equal(slot->angle, 1);
    assert_int_equal(slot->distance, 2);
    assert_false(model->coordinates[1].is_distance);
    assert_true(model->coordinates[2].is_distance);
    assert_int_equal(model->coordinates[1].drive, 0);
    assert_int_equal(model->efforts[0].coordinate, 0); // O.angle is phi
    assert_true(model->starts[1].is_rate);
    assert_int_equal(model->starts[1].coordinate, 3);
    yk_model_free(model);
}

static void many_coordinates_keep_their_order(void **state)
{
    (void)state;
    char text[20000];
    size_t n = (size_t)snprintf(text, sizeof text, "bodies: {");
    for (int i = 0; i < 100; i++) n += (size_t)snprintf(text + n, sizeof text - n, "b%d: {}, ", i);
    n += (size_t)snprintf(text + n, sizeof text - n, "}\njoints: {");
    for (int i = 0; i < 100; i++)
        n += (size_t)snprintf(text + n, sizeof text - n, "J%d: {pin: [ground, b%d], angle: q%d}, ", i, i, i);
    snprintf(text + n, sizeof text - n, "}\n");
    YkModel *model = fixture_load(text);
    assert_int_equal(model->coordinate_count, 100);
    for (int i = 0; i < 100; i++) {
        char name[20];
        snprintf(name, sizeof name, "q%d", i);
        assert_string_equal(model->coordinates[i].name, name);
        assert_int_equal(model->coordinates[i].joint, i);
        assert_int_equal(yk_names_find(&model->coordinate_names, name), i);
    }
    yk_model_free(model);
}

static void a_drive_is_an_expression_of_time_and_parameters(void **state)
{
    (void)state;
    YkModel *model = fixture_load(MACHINE "drives: {phi: 30 deg + w*t + sin(k*w*t)}\n");
    for (double t = 0; t < 3; t += 0.37) {
        YkJet jet;
        assert_int_equal(yk_model_eval(model, model->drives[0].expr, t, &jet, NULL), YK_OK);
        CHECK_NEAR(jet.d[0], YK_PI / 6 + 2 * t + sin(6 * t), 1e-14);
        CHECK_NEAR(jet.d[1], 2 + 6 * cos(6 * t), 1e-13);
        CHECK_NEAR(jet.d[2], -36 * sin(6 * t), 1e-12);
    }
    yk_model_free(model);
}

static void evaluation_faults_are_reported_at_their_place(void **state)
{
    (void)state;
    YkModel *model = fixture_load(MACHINE "drives: {phi: 1 rad/s^2 * 1 s^3 / t}\nefforts: {S.distance: phi * 3 N}\n");
    YkProblems *problems = yk_problems_new();
    YkJet jet;
    assert_int_equal(yk_model_eval(model, model->drives[0].expr, 0, &jet, problems), YK_BAD_MODEL);
    const YkProblem *problem = fixture_problem(problems, YK_CODE_EVALUATION);
    assert_non_null(problem);
    assert_int_equal(problem->place.line, 4);
    assert_int_equal(yk_model_eval(model, model->drives[0].expr, 2, &jet, problems), YK_OK);
    CHECK_NEAR(jet.d[0], 0.5, 1e-16);
    assert_int_equal(yk_problems_count(problems), 1);
    assert_int_equal(yk_model_eval(model, model->efforts[0].strength.expr, 0, &jet, problems),
                     YK_BAD_MODEL); // phi has no value
    assert_int_equal(yk_problems_count(problems), 2);
    yk_problems_free(problems);
    yk_model_free(model);
}

static void refused(const char *section, int code, unsigned column, const char *part)
{
    char text[600];
    snprintf(text, sizeof text, MACHINE "%s\n", section);
    fixture_refused(text, code, 4, column, part);
}

static void drives_of_unknown_or_impossible_coordinates_are_refused(void **state)
{
    (void)state;
    refused("drives: {ph: 3}", YK_CODE_UNKNOWN_COORDINATE, 10, "did you mean `phi`");
    refused("drives: {theta: 3}", YK_CODE_UNKNOWN_COORDINATE, 10, "name it at its joint");
    refused("drives: {X.angle: 3}", YK_CODE_UNKNOWN_COORDINATE, 10, "X.angle");
    refused("drives: {O.distance: 3}", YK_CODE_COORDINATE_KIND, 10, "a pin has no distance");
    refused("drives: {J-2.angle: 3}", YK_CODE_COORDINATE_KIND, 10, "a slide has no angle");
    refused("drives: {phi.rate: 3}", YK_CODE_RATE_NOT_HERE, 10, "phi.rate");
    refused("drives: {phi: 3, O.angle: 3}", YK_CODE_GIVEN_TWICE, 18, "`phi`");
    refused("drives: {phi: {law: lift, of: t}}", YK_CODE_UNKNOWN_LAW, 21, "lift");
    refused("drives: [phi]", YK_CODE_WRONG_KIND, 9, "drives");
}

static void drives_mention_neither_coordinates_nor_unknown_names(void **state)
{
    (void)state;
    refused("drives: {phi: S.distance * 3}", YK_CODE_NAME_NOT_HERE, 15, "coordinate");
    refused("drives: {phi: w*tt}", YK_CODE_UNKNOWN_NAME, 17, "`tt`");
    refused("drives: {phi: phj}", YK_CODE_UNKNOWN_NAME, 15, "did you mean `phi`");
    refused("drives: {phi: O.distance}", YK_CODE_COORDINATE_KIND, 15, "distance");
    refused("drives: {phi: }", YK_CODE_EMPTY_VALUE, 15, "drive of `phi`");
}

static void starts_are_checked_alike(void **state)
{
    (void)state;
    refused("start: {ph: 3}", YK_CODE_UNKNOWN_COORDINATE, 9, "did you mean `phi`");
    refused("start: {phi: t}", YK_CODE_NAME_NOT_HERE, 14, "time");
    refused("start: {phi.rate: 1, O.angle.rate: 1}", YK_CODE_GIVEN_TWICE, 22, "phi");
    refused("start: {phi: 1e200}", YK_CODE_VALUE_RANGE, 14, "1e100");
    refused("start: {phi: 1/0}", YK_CODE_EVALUATION, 14, "division by zero");
    YkModel *model = fixture_load(MACHINE "start: {phi: 1, O.angle.rate: 2}\ndrives: {phi: w*t}\n"); // driven: fine
    assert_int_equal(model->start_count, 2);
    yk_model_free(model);
}

static void each_use_has_its_own_dimension(void **state)
{
    (void)state;
    const char *wrong[] = {"drives: {phi: 3 mm}",      "start: {phi: 3 m}",
                           "start: {phi.rate: 3 m/s}", "start: {J-2.distance: 3 s}",
                           "efforts: {phi: 3 N}",      "efforts: {J-2.distance: 3 N*m}",
                           "gravity: [0, 9.81 m/s]",   "start: {J-2.distance.rate: 1 rad/s}"};
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
        char text[600];
        snprintf(text, sizeof text, MACHINE "%s\n", wrong[i]);
        YkProblems *problems = fixture_refuse(text);
        assert_int_equal(yk_problems_error_count(problems), 1);
        int code = yk_problems_get(problems, 0)->code;
        assert_true(code >= 300 && code < 400);
        assert_int_equal(yk_problems_get(problems, 0)->place.line, 4);
        yk_problems_free(problems);
    }
}

static void gravity_has_two_components(void **state)
{
    (void)state;
    YkModel *model = fixture_load(MACHINE "gravity: [w * 3 m/s, -9.81]\n");
    assert_true(model->has_gravity);
    CHECK_NEAR(model->gravity.x, 6, 0);
    CHECK_NEAR(model->gravity.y, -9.81, 0);
    yk_model_free(model);
    refused("gravity: 9.81", YK_CODE_WRONG_KIND, 10, "gravity must be a list");
    refused("gravity: [0]", YK_CODE_COMPONENTS, 10, "gravity");
    refused("gravity: [0, x]", YK_CODE_UNKNOWN_NAME, 14, "`x`");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_joints_coordinate_is_declared_by_its_mention),
        cmocka_unit_test(many_coordinates_keep_their_order),
        cmocka_unit_test(a_drive_is_an_expression_of_time_and_parameters),
        cmocka_unit_test(evaluation_faults_are_reported_at_their_place),
        cmocka_unit_test(drives_of_unknown_or_impossible_coordinates_are_refused),
        cmocka_unit_test(drives_mention_neither_coordinates_nor_unknown_names),
        cmocka_unit_test(starts_are_checked_alike),
        cmocka_unit_test(each_use_has_its_own_dimension),
        cmocka_unit_test(gravity_has_two_components),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
