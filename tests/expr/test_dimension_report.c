// Messages about dimensions that do not fit: the words, the hints and the places, of uses and of parameters, and the
// warning about units of force that a file does not name.
#include "expr_check.h"
#include "expr/dimension.h"

static const YkDimension number = {0, 0, 0, 0}, angle = {0, 0, 0, 1}, length = {1, 0, 0, 0}, mass = {0, 1, 0, 0},
                         duration = {0, 0, 1, 0}, area = {2, 0, 0, 0}, force = {1, 1, -2, 0}, torque = {2, 1, -2, 0};

typedef struct File {
    Fixture fixture;
    YkDimensions *dims;
} File;

static File file_new(YkUnits units)
{
    File file = {.fixture = fixture_new()};
    file.dims = yk_dimensions_new(file.fixture.arena, &units);
    assert_non_null(file.dims);
    yk_dimensions_fix(file.dims, "t", duration);
    yk_dimensions_fix(file.dims, "pi", number);
    yk_dimensions_fix(file.dims, "theta", angle);
    yk_dimensions_fix(file.dims, "d", length);
    return file;
}

static YkExpr *parsed(File *file, const char *text, unsigned line)
{
    YkExpr *expr =
        yk_expr_parse(text, strlen(text), (YkPlace){line, 11, 0}, file->fixture.arena, file->fixture.problems);
    assert_non_null(expr);
    return expr;
}

static void parameter(File *file, const char *name, const char *text, unsigned line)
{
    yk_dimensions_parameter(file->dims, name, parsed(file, text, line));
}

static void use(File *file, const char *text, YkDimension expected, const char *what, unsigned line)
{
    yk_dimensions_use(file->dims, parsed(file, text, line), expected, what);
}

// The one problem of the file; then the file is at its end.
static void expect(File *file, int code, unsigned line, unsigned column, const char *message, const char *hint)
{
    bool is_warning = code == YK_CODE_ODD_UNIT;
    assert_int_equal(yk_dimensions_run(file->dims, file->fixture.problems), is_warning);
    assert_int_equal(yk_problems_count(file->fixture.problems), 1);
    const YkProblem *problem = yk_problems_get(file->fixture.problems, 0);
    assert_int_equal(problem->code, code);
    assert_string_equal(problem->message, message);
    assert_int_equal(problem->place.line, line);
    assert_int_equal(problem->place.column, column);
    if (!hint) assert_null(problem->hint);
    if (hint) assert_non_null(problem->hint);
    if (hint) assert_string_equal(problem->hint, hint);
    fixture_free(&file->fixture);
}

static void a_parameter_that_is_used_otherwise_says_where(void **state)
{
    (void)state;
    File file = file_new(yk_units_si());
    parameter(&file, "a", "k*t", 4); // decided by the use of a; k by its own, later
    parameter(&file, "k", "3", 5);
    use(&file, "a", length, "x of point `A`", 8);
    use(&file, "k", mass, "mass of `link1`", 9);
    expect(&file, YK_CODE_WRONG_DIMENSION, 4, 11, "parameter `a` must be a length, this is a quantity in kg s",
           "it is used as a length on line 8, column 11");
}

// The dimension is another because one parameter in it was decided elsewhere: it is the parameter that is told.
static void a_parameter_behind_signs_and_factors_is_found(void **state)
{
    (void)state;
    static const struct {
        const char *text;
        unsigned column;
    } cases[] = {{"a", 11}, {"-a", 12}, {"2*a", 13}, {"a*2", 11}, {"a/2", 11}, {"-3*a/2", 14}};
    for (size_t k = 0; k < sizeof cases / sizeof *cases; k++) {
        File file = file_new(yk_units_si());
        parameter(&file, "a", "3", 2);
        use(&file, "a", length, "x of point `A`", 8);
        use(&file, cases[k].text, mass, "mass of `link1`", 9);
        expect(&file, YK_CODE_TWO_DIMENSIONS, 9, cases[k].column,
               "`a` is used as a mass here (mass of `link1`) but as a length elsewhere (x of point `A`)",
               "the other use is on line 8, column 11; give `a` a unit, or use two parameters");
    }
    File file = file_new(yk_units_si());
    parameter(&file, "a", "3", 2);
    use(&file, "a", length, "x of point `A`", 8);
    use(&file, "2/a", mass, "mass of `link1`", 9); // not a factor: what is wrong is the quotient
    expect(&file, YK_CODE_WRONG_DIMENSION, 9, 11, "mass of `link1` must be a mass, this is a quantity in m^-1",
           "in a product a bare number is a plain number; give it its unit: `2 kg*m / a`");
}

static void a_sum_says_what_does_not_fit_and_mends_the_part_with_a_number(void **state)
{
    (void)state;
    File file = file_new(yk_units_si());
    use(&file, "d + 2*t", length, "x", 3);
    expect(&file, YK_CODE_MIXED_SUM, 3, 15, "cannot add a length and a time",
           "in a product a bare number is a plain number; give it its unit: `d + 2 m/s * t`");
    file = file_new(yk_units_si());
    use(&file, "2*t + d", length, "x", 3);
    expect(&file, YK_CODE_MIXED_SUM, 3, 17, "cannot add a time and a length",
           "in a product a bare number is a plain number; give it its unit: `2 m/s * t + d`");
    file = file_new(yk_units_si());
    use(&file, "d - t", length, "x", 3);
    expect(&file, YK_CODE_MIXED_SUM, 3, 15, "cannot subtract a time from a length", NULL);
    file = file_new(yk_units_si());
    use(&file, "max(t, d)", length, "x", 3);
    expect(&file, YK_CODE_MIXED_SUM, 3, 18, "`max` needs two of the same kind, not a time and a length", NULL);
}

static void powers_say_what_cannot_be_raised(void **state)
{
    (void)state;
    File file = file_new(yk_units_si());
    use(&file, "sqrt(d)", length, "x", 3);
    expect(&file, YK_CODE_BAD_POWER, 3, 11, "cannot take the square root of a length", NULL);
    file = file_new(yk_units_si());
    use(&file, "d^0.3", length, "x", 3);
    expect(&file, YK_CODE_BAD_POWER, 3, 11, "cannot raise a length to the power 0.3", NULL);
    file = file_new(yk_units_si());
    use(&file, "d^theta", length, "x", 3);
    expect(&file, YK_CODE_BAD_POWER, 3, 13, "the exponent of a length must be a plain whole number", NULL);
    file = file_new(yk_units_si());
    use(&file, "2^t", number, "x", 3);
    expect(&file, YK_CODE_BAD_POWER, 3, 13, "an exponent must be a number, this is a time", NULL);
}

// A plain number where a quantity belongs: the hint quotes it, if it is short.
static void a_plain_number_is_given_a_unit(void **state)
{
    (void)state;
    File file = file_new(yk_units_si());
    use(&file, "sin(theta)^2", force, "effort", 3);
    expect(&file, YK_CODE_WRONG_DIMENSION, 3, 11, "effort must be a force, this is a number",
           "it is a plain number: multiply it by a unit, as in `1 N * (sin(theta)^2)`");
    file = file_new(yk_units_si());
    use(&file, "sin(theta)^2 + sin(theta)^4 + sin(theta)^6", torque, "effort", 3); // 42 characters
    expect(&file, YK_CODE_WRONG_DIMENSION, 3, 11, "effort must be a torque or energy, this is a number",
           "it is a plain number: multiply it by a unit, as in `1 N*m * (...)`");
}

static YkUnits in_millimetres(void)
{
    YkUnits units = yk_units_si();
    units.length = 1e-3;
    units.length_name = "mm";
    return units;
}

// kg mm/s^2 is no unit that anybody means; said once, and not of a 0, nor where the file names its unit of force.
static void a_bare_force_in_odd_units_is_warned_of_once(void **state)
{
    (void)state;
    File file = file_new(in_millimetres());
    use(&file, "0", force, "effort", 3);
    use(&file, "12", length, "x", 4);
    use(&file, "12", area, "area", 5);
    use(&file, "-7", force, "effort along `x`", 6);
    use(&file, "8", torque, "effort along `y`", 7);
    expect(&file, YK_CODE_ODD_UNIT, 6, 12,
           "effort along `x`: the file names no unit of force, so a bare number is in kg*mm/s^2 here, which is 0.001 N",
           "say `force: N` under `units:`, which makes it N, or write the unit after the number");
    YkUnits usual[4] = {in_millimetres(), yk_units_si(), yk_units_si(), in_millimetres()};
    usual[0].force = 1, usual[0].force_name = "N";
    usual[2].length = 0.01, usual[2].mass = 1e-3; // dyn
    usual[3].mass = 1e3;                          // t mm/s^2 = N
    for (int k = 0; k < 4; k++) {
        file = file_new(usual[k]);
        use(&file, "7", force, "effort", 3);
        assert_true(yk_dimensions_run(file.dims, file.fixture.problems));
        assert_int_equal(yk_problems_count(file.fixture.problems), 0);
        fixture_free(&file.fixture);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_parameter_that_is_used_otherwise_says_where),
        cmocka_unit_test(a_parameter_behind_signs_and_factors_is_found),
        cmocka_unit_test(a_sum_says_what_does_not_fit_and_mends_the_part_with_a_number),
        cmocka_unit_test(powers_say_what_cannot_be_raised),
        cmocka_unit_test(a_plain_number_is_given_a_unit),
        cmocka_unit_test(a_bare_force_in_odd_units_is_warned_of_once),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
