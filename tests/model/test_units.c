// The meaning of bare numbers, and the unit in which each quantity is written.
#include "model/fixture.h"

#define DEG (YK_PI / 180)

static void check_unit(const YkModel *model, YkQuantity quantity, const char *name, double size)
{
    double found = 0;
    assert_string_equal(yk_model_unit(model, quantity, &found), name);
    CHECK_NEAR(found, size, 1e-15 * size);
}

static void without_units_numbers_are_si_and_radians(void **state)
{
    (void)state;
    YkModel *model = fixture_load(CRANK "start: {theta: 1.5}\n");
    CHECK_NEAR(fixture_point(model, "crank.A")->at.x, 0.1, 0);
    CHECK_NEAR(model->starts[0].value, 1.5, 0);
    check_unit(model, YK_QUANTITY_NUMBER, "", 1);
    check_unit(model, YK_QUANTITY_ANGLE, "rad", 1);
    check_unit(model, YK_QUANTITY_SPEED, "m/s", 1);
    check_unit(model, YK_QUANTITY_FORCE, "N", 1);
    check_unit(model, YK_QUANTITY_TORQUE, "N*m", 1);
    yk_model_free(model);
}

static void declared_units_scale_plain_numbers_and_expressions_alike(void **state)
{
    (void)state;
    YkModel *model = fixture_load("units: {length: mm, angle: deg, mass: g}\nparameters: {r: 100, q: 50 mm}\n"
                                  "gravity: [0, -9810]\n"
                                  "bodies: {crank: {points: {O: [0, 0], A: [100, -100], B: [r, 2*q], C: [0.1 m, r]},"
                                  " mass: 200, inertia: 1000}}\n"
                                  "joints: {S: {pin-slot: [ground, crank], along: 90, angle: a, distance: d}}\n"
                                  "start: {a: 60, a.rate: 180, d: 5, d.rate: 7}\n");
    CHECK_NEAR(fixture_point(model, "crank.A")->at.x, 0.1, 1e-17);
    CHECK_NEAR(fixture_point(model, "crank.A")->at.y, -0.1, 1e-17);
    CHECK_NEAR(fixture_point(model, "crank.B")->at.x, 0.1, 1e-16);
    CHECK_NEAR(fixture_point(model, "crank.B")->at.y, 0.1, 1e-16);
    CHECK_NEAR(fixture_point(model, "crank.C")->at.y, 0.1, 1e-16);
    CHECK_NEAR(fixture_body(model, "crank")->mass, 0.2, 1e-16);
    CHECK_NEAR(fixture_body(model, "crank")->inertia, 1e-6, 1e-20); // 1000 g mm^2
    CHECK_NEAR(model->gravity.y, -9.81, 1e-14);
    CHECK_NEAR(model->joints[0].along_angle, 90 * DEG, 1e-15);
    const double start[] = {60 * DEG, 180 * DEG, 0.005, 0.007};
    for (size_t i = 0; i < 4; i++) CHECK_NEAR(model->starts[i].value, start[i], 1e-15);
    yk_model_free(model);
}

static void composed_units_have_names_and_sizes(void **state)
{
    (void)state;
    YkModel *model = fixture_load("units: {length: mm, angle: deg, force: N}\n" CRANK);
    check_unit(model, YK_QUANTITY_LENGTH, "mm", 1e-3);
    check_unit(model, YK_QUANTITY_TIME, "s", 1);
    check_unit(model, YK_QUANTITY_ANGLE_RATE, "deg/s", DEG);
    check_unit(model, YK_QUANTITY_ANGLE_ACCELERATION, "deg/s^2", DEG);
    check_unit(model, YK_QUANTITY_ACCELERATION, "mm/s^2", 1e-3);
    check_unit(model, YK_QUANTITY_FORCE, "N", 1);
    check_unit(model, YK_QUANTITY_TORQUE, "N*mm", 1e-3);
    yk_model_free(model);
    model = fixture_load("units: {length: mm, mass: g, time: ms}\n" CRANK);
    check_unit(model, YK_QUANTITY_FORCE, "g*mm/ms^2", 1);
    check_unit(model, YK_QUANTITY_TORQUE, "g*mm^2/ms^2", 1e-3);
    assert_null(yk_model_unit(model, (YkQuantity)99, NULL));
    yk_model_free(model);
}

static void every_unit_name_reads_back_as_its_size(void **state)
{
    (void)state;
    const char *files[] = {CRANK, "units: {length: in, mass: lb, angle: deg, time: min}\n" CRANK,
                           "units: {length: cm, force: kN}\n" CRANK};
    for (size_t i = 0; i < 3; i++) {
        YkModel *model = fixture_load(files[i]);
        for (int quantity = YK_QUANTITY_ANGLE; quantity < YK_QUANTITY_COUNT; quantity++) {
            double size = 0, read = 0;
            const char *name = yk_model_unit(model, (YkQuantity)quantity, &size), *bad;
            YkDimension dimension;
            size_t bad_length;
            assert_true(yk_unit_read(name, strlen(name), &read, &dimension, &bad, &bad_length));
            CHECK_NEAR(read, size, 1e-14 * size);
        }
        yk_model_free(model);
    }
}

static void wrong_units_are_refused_where_they_stand(void **state)
{
    (void)state;
    fixture_refused("units: {length: parsek}\n" CRANK, YK_CODE_UNITS_ENTRY, 1, 17, "parsek");
    fixture_refused("units: {length: kg}\n" CRANK, YK_CODE_UNITS_ENTRY, 1, 17, "not a unit of length");
    fixture_refused("units: {angle: '%'}\n" CRANK, YK_CODE_UNITS_ENTRY, 1, 16, "not a unit of angle");
    fixture_refused("units: {lenght: mm}\n" CRANK, YK_CODE_UNKNOWN_KEY, 1, 9, "length");
    fixture_refused("units: {length: }\n" CRANK, YK_CODE_EMPTY_VALUE, 1, 17, "length");
    fixture_refused("units: mm\n" CRANK, YK_CODE_WRONG_KIND, 1, 8, "units");
}

// Bare numbers that are forces or torques, in a file that names a unit of length and none of force.
static void forces_in_units_that_nobody_means_are_told_once(void **state)
{
    (void)state;
    const struct {
        const char *text;
        int warnings;
        unsigned line;
    } cases[] = {
        {"units: {length: mm}\n" CRANK "efforts: {theta: -1500}\n", 1, 4},
        {"units: {length: mm}\n" CRANK "efforts: {theta: 3*cos(15 deg)}\n", 1, 4},
        {"units: {length: mm}\nparameters: {tau: 1500}\n" CRANK "efforts: {theta: tau}\n", 1, 2},
        {"units: {length: mm}\n" CRANK
         "forces: {F: {body: crank, at: A, value: [-80, 20]}, G: {body: crank, moment: 3}}\n",
         1, 4},
        {"units: {length: mm}\n" CRANK "springs: {k: {along: theta, stiffness: 4, angle: 0}}\n", 1, 4},
        {"units: {length: cm, mass: kg}\n" CRANK "efforts: {theta: 1}\n", 1, 4},
        {"units: {length: mm}\n" CRANK "efforts: {theta: 1500 N*mm}\n", 0, 0},
        {"units: {length: mm}\n" CRANK "efforts: {theta: 0}\n", 0, 0},
        {"units: {length: mm, force: N}\n" CRANK "efforts: {theta: 1500}\n", 0, 0},
        {"units: {length: mm, mass: t}\n" CRANK "efforts: {theta: 1500}\n", 0, 0}, // makes newtons
        {"units: {length: cm, mass: g}\n" CRANK "efforts: {theta: 1500}\n", 0, 0}, // dynes
        {"units: {length: m}\n" CRANK "efforts: {theta: 1500}\n", 0, 0},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        YkProblems *problems = yk_problems_new();
        YkModel *model = yk_model_parse(cases[i].text, strlen(cases[i].text), "test.yaml", NULL, problems);
        const YkProblem *problem = fixture_problem(problems, YK_CODE_ODD_UNIT);
        int count = 0;
        for (size_t k = 0; k < yk_problems_count(problems); k++)
            count += yk_problems_get(problems, k)->code == YK_CODE_ODD_UNIT;
        if (!model || count != cases[i].warnings) print_error("%s%s", cases[i].text, yk_problems_text(problems, 0));
        assert_non_null(model);
        assert_int_equal(count, cases[i].warnings);
        if (problem) {
            assert_int_equal(problem->place.line, cases[i].line);
            assert_non_null(strstr(problem->hint, "`force: N`"));
        }
        yk_model_free(model);
        yk_problems_free(problems);
    }
}

static void values_that_cannot_be_are_told_in_the_files_units(void **state)
{
    (void)state;
    static const struct {
        YkCode code;
        const char *body, *springs, *part;
    } cases[] = {
        {YK_CODE_BAD_MASS, "mass: -5", "", "mass of `rod` is -5 g;"},
        {YK_CODE_BAD_INERTIA, "mass: 5, inertia: -7", "", "inertia of `rod` is -7 g*mm^2;"},
        {YK_CODE_BAD_DAMPING, "mass: 5", "springs: {k: {along: phi, damping: -2 N*mm*s/deg}}\n", "is -2 N*mm*s/deg;"},
        {YK_CODE_NEGATIVE_STIFFNESS, "mass: 5", "springs: {k: {along: phi, stiffness: -2 N*mm/deg}}\n",
         "is -2 N*mm/deg;"},
        {YK_CODE_NEGATIVE_STIFFNESS, "mass: 5", "springs: {k: {between: [ground.P, rod.C], stiffness: -3}}\n",
         "is -3 N/mm;"},
    };
    for (size_t k = 0; k < sizeof cases / sizeof *cases; k++) {
        char text[600];
        snprintf(text, sizeof text,
                 "units: {length: mm, mass: g, angle: deg, force: N}\n"
                 "bodies: {ground: {points: {P: [0, 5]}}, rod: {points: {C: [2, 0]}, %s}}\n"
                 "joints: {O: {pin: [ground, rod], angle: phi}}\n%s",
                 cases[k].body, cases[k].springs);
        YkProblems *problems = yk_problems_new();
        YkModel *model = yk_model_parse(text, strlen(text), "test.yaml", NULL, problems);
        const YkProblem *problem = fixture_problem(problems, cases[k].code);
        assert_true((model != NULL) == (cases[k].code == YK_CODE_NEGATIVE_STIFFNESS));
        yk_model_free(model);
        if (!problem || !strstr(problem->message, cases[k].part)) print_error("%s", yk_problems_text(problems, 0));
        assert_non_null(problem);
        assert_non_null(strstr(problem->message, cases[k].part));
        yk_problems_free(problems);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(without_units_numbers_are_si_and_radians),
        cmocka_unit_test(declared_units_scale_plain_numbers_and_expressions_alike),
        cmocka_unit_test(composed_units_have_names_and_sizes),
        cmocka_unit_test(every_unit_name_reads_back_as_its_size),
        cmocka_unit_test(forces_in_units_that_nobody_means_are_told_once),
        cmocka_unit_test(wrong_units_are_refused_where_they_stand),
        cmocka_unit_test(values_that_cannot_be_are_told_in_the_files_units),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
