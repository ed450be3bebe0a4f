// Hints that add the missing units of numbers to a product: what they write has the required dimension.
#include "expr_check.h"
#include "expr/dimension.h"

typedef struct Case {
    const char *text;
    YkDimension dimension;
    const char *repaired; // NULL: no hint writes the expression
} Case;

static YkUnits in_millimetres(bool has_force)
{
    YkUnits units = yk_units_si();
    units.length = 1e-3;
    units.length_name = "mm";
    units.force = has_force ? 1e3 : 0;
    units.force_name = has_force ? "kN" : NULL;
    return units;
}

static YkDimensions *dimensions_of(Fixture *fixture, const YkUnits *units)
{
    YkDimensions *dims = yk_dimensions_new(fixture->arena, units);
    yk_dimensions_fix(dims, "t", (YkDimension){0, 0, 1, 0});
    yk_dimensions_fix(dims, "pi", (YkDimension){0, 0, 0, 0});
    yk_dimensions_fix(dims, "theta", (YkDimension){0, 0, 0, 1});
    yk_dimensions_fix(dims, "theta.rate", (YkDimension){0, 0, -1, 1});
    yk_dimensions_fix(dims, "d", (YkDimension){1, 0, 0, 0});
    yk_dimensions_fix(dims, "rho", (YkDimension){-3, 1, 0, 0});
    return dims;
}

static bool runs(Fixture *fixture, const YkUnits *units, const char *text, YkDimension dimension)
{
    YkDimensions *dims = dimensions_of(fixture, units);
    YkExpr *expr = yk_expr_parse(text, strlen(text), (YkPlace){1, 1, 0}, fixture->arena, fixture->problems);
    assert_non_null(expr);
    yk_dimensions_use(dims, expr, dimension, "x");
    return yk_dimensions_run(dims, fixture->problems);
}

static void check(YkUnits units, const Case *wrong)
{
    Fixture fixture = fixture_new(), again = fixture_new();
    assert_false(runs(&fixture, &units, wrong->text, wrong->dimension));
    const char *hint = yk_problems_get(fixture.problems, 0)->hint;
    const char *start = hint ? strchr(hint, '`') : NULL;
    if (wrong->repaired) {
        char expected[128];
        snprintf(expected, sizeof expected, "`%s`", wrong->repaired);
        if (!start || strcmp(start, expected) != 0) print_error("«%s»: %s\n", wrong->text, hint ? hint : "no hint");
        assert_non_null(start);
        assert_string_equal(start, expected);
        if (!runs(&again, &units, wrong->repaired, wrong->dimension))
            print_error("%s", yk_problems_text(again.problems, 0));
        assert_int_equal(yk_problems_count(again.problems), 0);
    } else {
        if (start) print_error("«%s»: %s\n", wrong->text, hint);
        assert_null(start);
    }
    fixture_free(&fixture);
    fixture_free(&again);
}

static const YkDimension mass = {0, 1, 0, 0}, torque = {2, 1, -2, 0}, force = {1, 1, -2, 0}, angle = {0, 0, 0, 1},
                         length = {1, 0, 0, 0}, volume = {3, 0, 0, 0};

static void the_hint_writes_the_expression_with_its_units(void **state)
{
    (void)state;
    const Case cases[] = {
        {"rho*0.02*0.05*d", mass, "rho*0.02 m * 0.05 m * d"},
        {"rho*2*0.02*0.05*d", mass, "rho*2*0.02 m * 0.05 m * d"},
        {"pi/4*0.02^2*rho*d", mass, "pi/4*(0.02 m)^2*rho*d"},
        {"10*theta.rate", torque, "10 N*m*s/rad * theta.rate"},
        {"-10*theta.rate", torque, "-10 N*m*s/rad * theta.rate"},
        {"theta.rate*10", torque, "theta.rate*10 N*m*s/rad"},
        {"theta/10", torque, "theta/10 rad/N/m"},
        {"30 deg - 0.5*t", angle, "30 deg - 0.5 rad/s * t"},
        {"0.5*t + 30 deg", angle, "0.5 rad/s * t + 30 deg"},
        {"1 + 300*t", angle, "1 + 300 rad/s * t"},
        {"2 * t + 3*t", length, "2 m/s * t + 3 m/s * t"},
        {"100*(d - 2)", force, "100 N/m * (d - 2)"},
        {"0.1*t", volume, "0.1 m^3/s * t"},
        {"20*sin(theta)", length, "20 m * sin(theta)"},
        {"1.5*d", volume, "1.5 m^2 * d"},
        {"d^2", volume, NULL},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) check(yk_units_si(), &cases[i]);
}

static void the_units_are_the_files(void **state)
{
    (void)state;
    const Case own[] = {{"10*theta.rate", torque, "10 kN*mm*s/rad * theta.rate"},
                        {"20*sin(theta)", length, "20 mm * sin(theta)"},
                        {"rho*20*50*d", mass, "rho*20 mm * 50 mm * d"}};
    const Case none[] = {{"10*theta.rate", torque, "10 N*mm*s/rad * theta.rate"}};
    for (size_t i = 0; i < sizeof own / sizeof *own; i++) check(in_millimetres(true), &own[i]);
    check(in_millimetres(false), &none[0]);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_hint_writes_the_expression_with_its_units),
        cmocka_unit_test(the_units_are_the_files),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
