// Dimension inference: what bare numbers and parameters become, and which contradictions are found where.
#include "expr_check.h"

#define NUMBER ((YkDimension){0, 0, 0, 0})
#define ANGLE ((YkDimension){0, 0, 0, 1})
#define LENGTH ((YkDimension){1, 0, 0, 0})
#define MASS ((YkDimension){0, 1, 0, 0})
#define TIME ((YkDimension){0, 0, 1, 0})
#define AREA ((YkDimension){2, 0, 0, 0})
#define INERTIA ((YkDimension){2, 1, 0, 0})
#define FORCE ((YkDimension){1, 1, -2, 0})
#define TORQUE ((YkDimension){2, 1, -2, 0})
#define RATE ((YkDimension){0, 0, -1, 1})
#define STIFFNESS ((YkDimension){0, 1, -2, 0})
#define ACCELERATION ((YkDimension){1, 0, -2, 0})

enum { NAMES = 12 };

// A small file: parameters, then uses; uses stand on line 3 + their index + 1 so that places tell them apart.
typedef struct File {
    Fixture fixture;
    YkDimensions *dims;
    const char *names[NAMES];
    YkExpr *values[NAMES];
    size_t count;
    bool is_fine;
} File;

static YkUnits millimetres_and_degrees(void)
{
    YkUnits units = yk_units_si();
    units.length = 1e-3;
    units.angle = 3.14159265358979323846 / 180;
    units.force = 1;
    return units;
}

static File file_new(YkUnits units)
{
    File file = {.fixture = fixture_new()};
    file.dims = yk_dimensions_new(file.fixture.arena, &units);
    assert_non_null(file.dims);
    yk_dimensions_fix(file.dims, "t", TIME);
    yk_dimensions_fix(file.dims, "pi", NUMBER);
    yk_dimensions_fix(file.dims, "theta", ANGLE);
    yk_dimensions_fix(file.dims, "theta.rate", RATE);
    yk_dimensions_fix(file.dims, "d", LENGTH);
    return file;
}

static void file_free(File *file)
{
    fixture_free(&file->fixture);
}

static void parameter(File *file, const char *name, const char *text)
{
    YkExpr *expr = fixture_parse(&file->fixture, text);
    assert_non_null(expr);
    file->names[file->count] = name;
    file->values[file->count++] = expr;
    yk_dimensions_parameter(file->dims, name, expr);
}

static YkExpr *use(File *file, const char *text, YkDimension expected, const char *what)
{
    YkExpr *expr = yk_expr_parse(text, strlen(text), (YkPlace){3, 11, 0}, file->fixture.arena, file->fixture.problems);
    assert_non_null(expr);
    yk_dimensions_use(file->dims, expr, expected, what);
    return expr;
}

static bool run(File *file)
{
    return file->is_fine = yk_dimensions_run(file->dims, file->fixture.problems);
}

static void run_well(File *file)
{
    if (!run(file)) print_error("%s", yk_problems_text(file->fixture.problems, 0));
    assert_true(file->is_fine);
    assert_int_equal(yk_problems_count(file->fixture.problems), 0);
}

// Parameters by their expressions, and one value for each of the fixed names.
static bool lookup(const void *context, const YkExpr *name, YkJet *jet)
{
    const File *file = context;
    const char *why;
    for (size_t i = 0; i < file->count; i++)
        if (strcmp(file->names[i], name->name) == 0)
            return yk_expr_eval(file->values[i], lookup, file, jet, &why) == NULL;
    *jet = (YkJet){{strcmp(name->name, "pi") == 0 ? 3.14159265358979323846 : 2}};
    return true;
}

static double value(const File *file, const YkExpr *expr)
{
    YkJet jet;
    const char *why;
    assert_null(yk_expr_eval(expr, lookup, file, &jet, &why));
    return jet.d[0];
}

static void check_parameter(const File *file, const char *name, YkDimension wanted)
{
    YkDimension found;
    if (!yk_dimensions_of(file->dims, name, &found)) print_error("%s stayed open\n", name);
    assert_true(yk_dimensions_of(file->dims, name, &found));
    assert_true(yk_dimension_equal(found, wanted));
}

static void a_bare_number_takes_the_unit_of_its_use(void **state)
{
    (void)state;
    File file = file_new(millimetres_and_degrees());
    const struct {
        const char *text;
        YkDimension dimension;
        double si;
    } cases[] = {
        {"12", LENGTH, 0.012},
        {"30", ANGLE, 0.52359877559829887},
        {"3", MASS, 3},
        {"-12", LENGTH, -0.012},
        {"3/4", LENGTH, 0.75e-3},
        {"3/4 m", LENGTH, 0.75},
        {"2*3", LENGTH, 6e-3},
        {"2 + 3", LENGTH, 5e-3},
        {"2 m + 3", LENGTH, 2.003},
        {"d + 3", LENGTH, 2.003},
        {"2*d - 3", LENGTH, 3.997},
        {"5", TORQUE, 5e-3},
        {"2^2", LENGTH, 4e-3},
        {"sqrt(9)", LENGTH, 3e-3},
        {"sqrt(3)/2", LENGTH, 0.8660254037844386e-3},
        {"max(3, d)", LENGTH, 2},
        {"abs(-3)", LENGTH, 3e-3},
        {"10", NUMBER, 10},
        {"0", LENGTH, 0},
        {"9810", ACCELERATION, 9.81},
        {"6", RATE, 0.10471975511965977},
        {"2*3 + d", LENGTH, 2.006},
        {"1/(1/4)", LENGTH, 4e-3},
        {"-(3 - 1)", LENGTH, -2e-3},
    };
    const YkExpr *exprs[sizeof cases / sizeof *cases];
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++)
        exprs[i] = use(&file, cases[i].text, cases[i].dimension, "x");
    run_well(&file);
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        double si = value(&file, exprs[i]);
        if (!(fabs(si - cases[i].si) <= 1e-15 * fabs(cases[i].si))) print_error("«%s»\n", cases[i].text);
        CHECK_NEAR(si, cases[i].si, 1e-15 * fabs(cases[i].si));
    }
    file_free(&file);
}

static void angles_in_functions_are_in_the_files_unit_and_pi_is_in_radians(void **state)
{
    (void)state;
    File file = file_new(millimetres_and_degrees());
    const struct {
        const char *text;
        YkDimension dimension;
        double si;
    } cases[] = {
        {"sin(30)", NUMBER, 0.5},
        {"sin(30 + 60 deg)", NUMBER, 1},
        {"sin(pi/6)", NUMBER, 0.5},
        {"cos(2*pi/6)", NUMBER, 0.5},
        {"pi/2", ANGLE, 1.5707963267948966},
        {"30*pi/180", ANGLE, 0.52359877559829887},
        {"pi/2 + 90", ANGLE, 3.1415926535897931},
        {"asin(0.5)", ANGLE, 0.52359877559829887},
        {"atan2(1, 1)", ANGLE, 0.78539816339744828},
        {"atan2(2, d)", ANGLE, 0.00099999966666686661},
        {"asin(0.5) + 30", ANGLE, 1.0471975511965976},
        {"2*pi", RATE, 6.283185307179586},
        {"pi/4", LENGTH, 0.78539816339744828e-3},
        {"theta - 180", ANGLE, 2 - 3.1415926535897931},
        {"2*(pi/2 + 1)", ANGLE, 5.1415926535897931}, // a sum with pi in it is in radians as a whole
        {"2*(1 + pi/2)", ANGLE, 5.1415926535897931},
        {"2*max(pi, 3)", ANGLE, 6.283185307179586},
        {"2*(2 + 3)", ANGLE, 0.17453292519943295},
        {"2*max(2, 3)", ANGLE, 0.10471975511965977},
        {"sqrt(2)*sin(45)", NUMBER, 1},
        {"exp(0) + 2", NUMBER, 3},
    };
    const YkExpr *exprs[sizeof cases / sizeof *cases];
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++)
        exprs[i] = use(&file, cases[i].text, cases[i].dimension, "x");
    run_well(&file);
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        double si = value(&file, exprs[i]);
        if (!(fabs(si - cases[i].si) <= 4e-15 * fabs(cases[i].si))) print_error("«%s»\n", cases[i].text);
        CHECK_NEAR(si, cases[i].si, 4e-15 * fabs(cases[i].si));
    }
    file_free(&file);
}

// Literals, angles and functions of them, without a parameter or a coordinate: one bare number, in the file's unit.
static void a_number_of_literals_alone_is_bare_whatever_functions_are_in_it(void **state)
{
    (void)state;
    const double half = 0.5, rad = 3.14159265358979323846 / 180;
    File file = file_new(millimetres_and_degrees());
    const struct {
        const char *text;
        YkDimension dimension;
        double si;
    } cases[] = {
        {"3*cos(60 deg)", LENGTH, 3 * half * 1e-3},
        {"3*cos(60)", LENGTH, 3 * half * 1e-3},
        {"cos(60 deg)*3", LENGTH, 3 * half * 1e-3},
        {"cos(60 deg)", LENGTH, half * 1e-3},
        {"-cos(pi/3)", LENGTH, -half * 1e-3},
        {"2 - cos(60 deg)", LENGTH, 1.5e-3},
        {"2/(1 + cos(60 deg))", LENGTH, 2 / 1.5 * 1e-3},
        {"(2 + sin(30))*4", LENGTH, 10e-3},
        {"3*cos(60 deg) + 2 mm", LENGTH, 3.5e-3},
        {"d + 3*cos(60 deg)", LENGTH, 2.0015},
        {"sqrt(3^2 + 4^2)*sin(30 deg)", LENGTH, 2.5e-3},
        {"sqrt(sin(30 deg)*2)", LENGTH, 1e-3},
        {"max(3*cos(60 deg), 1)", LENGTH, 1.5e-3},
        {"abs(-3*cos(60 deg))", LENGTH, 1.5e-3},
        {"sign(-3)*5", LENGTH, -5e-3},
        {"2^sin(30 deg)", LENGTH, 1.4142135623730951e-3},
        {"5^0", LENGTH, 1e-3},
        {"pi", LENGTH, 3.14159265358979323846e-3},
        {"exp(0)*tan(45 deg)", LENGTH, 1e-3},
        {"30 deg/(15 deg)", LENGTH, 2e-3},
        {"3*cos(atan2(3, 4))", LENGTH, 2.4e-3},
        {"40*cos(60 deg)", ANGLE, 20 * rad},
        {"40*cos(60 deg)", NUMBER, 20},
        {"7*cos(60 deg)", TORQUE, 3.5e-3}, // units: {length: mm, force: N}
        {"d*cos(60 deg)", LENGTH, 1},
        {"d*3*cos(60 deg)", LENGTH, 3},
        {"d*sin(30)", LENGTH, 1},
        {"atan2(3, 3)", ANGLE, 45 * rad},
        {"2*atan2(3, 3)", ANGLE, 90 * rad},
        {"15 deg + 30", ANGLE, 45 * rad},
    };
    const YkExpr *exprs[sizeof cases / sizeof *cases];
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++)
        exprs[i] = use(&file, cases[i].text, cases[i].dimension, "x");
    run_well(&file);
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        double si = value(&file, exprs[i]);
        if (!(fabs(si - cases[i].si) <= 1e-15 * fabs(cases[i].si))) print_error("«%s»: %.17g\n", cases[i].text, si);
        CHECK_NEAR(si, cases[i].si, 1e-15 * fabs(cases[i].si));
    }
    file_free(&file);
}

static void a_sine_among_the_parameters_is_a_number_unless_a_use_says_otherwise(void **state)
{
    (void)state;
    File file = file_new(millimetres_and_degrees());
    parameter(&file, "l", "30");
    parameter(&file, "c", "cos(60 deg)");
    parameter(&file, "w", "4*sin(30)");
    const YkExpr *x = use(&file, "l*c", LENGTH, "x"), *square = use(&file, "l*c^2", LENGTH, "x");
    const YkExpr *width = use(&file, "w", LENGTH, "y");
    run_well(&file);
    check_parameter(&file, "l", LENGTH);
    check_parameter(&file, "w", LENGTH);
    CHECK_NEAR(value(&file, x), 0.015, 1e-17);
    CHECK_NEAR(value(&file, square), 0.0075, 1e-17);
    CHECK_NEAR(value(&file, width), 0.002, 1e-17);
    file_free(&file);
}

static void a_bare_parameter_takes_the_dimension_of_its_use(void **state)
{
    (void)state;
    File file = file_new(millimetres_and_degrees());
    parameter(&file, "l", "250");
    parameter(&file, "m", "3");
    parameter(&file, "phi", "30");
    const YkExpr *x = use(&file, "l + 1 m", LENGTH, "x of point `A`"), *half = use(&file, "-l/2", LENGTH, "x");
    const YkExpr *inertia = use(&file, "m*l^2/12", INERTIA, "inertia");
    const YkExpr *height = use(&file, "l*sin(phi)", LENGTH, "y");
    use(&file, "m", MASS, "mass");
    run_well(&file);
    check_parameter(&file, "l", LENGTH);
    check_parameter(&file, "m", MASS);
    check_parameter(&file, "phi", ANGLE);
    CHECK_NEAR(value(&file, x), 1.25, 1e-15);
    CHECK_NEAR(value(&file, half), -0.125, 1e-15);
    CHECK_NEAR(value(&file, inertia), 3 * 0.0625 / 12, 1e-16);
    CHECK_NEAR(value(&file, height), 0.125, 1e-15);
    file_free(&file);
}

static void the_toggle_linkages_parameters_are_found(void **state)
{
    (void)state;
    File file = file_new(yk_units_si());
    static const char *const lengths[] = {"l1", "l2", "a0x", "a0y"};
    for (size_t i = 0; i < 4; i++) parameter(&file, lengths[i], "0.25");
    parameter(&file, "m1", "0.4");
    parameter(&file, "tau", "2");
    parameter(&file, "g", "9.81 m/s^2");
    for (size_t i = 0; i < 3; i++) use(&file, lengths[i], LENGTH, "x of a point");
    use(&file, "-a0y", LENGTH, "y of point `O2`");
    use(&file, "m1", MASS, "mass of `link1`");
    use(&file, "-g", ACCELERATION, "y of gravity");
    use(&file, "tau", TORQUE, "effort along `theta1`");
    run_well(&file);
    for (size_t i = 0; i < 4; i++) check_parameter(&file, lengths[i], LENGTH);
    check_parameter(&file, "m1", MASS);
    check_parameter(&file, "tau", TORQUE);
    check_parameter(&file, "g", ACCELERATION);
    file_free(&file);
}

static void a_module_in_length_makes_numbers_of_teeth(void **state)
{
    (void)state;
    File file = file_new(millimetres_and_degrees());
    parameter(&file, "N1", "27");
    parameter(&file, "N2", "36");
    parameter(&file, "mod", "2 mm");
    const YkExpr *x = use(&file, "mod*(N1 + N2)/2", LENGTH, "x of point `P`");
    run_well(&file);
    check_parameter(&file, "N1", NUMBER);
    check_parameter(&file, "N2", NUMBER);
    check_parameter(&file, "mod", LENGTH);
    CHECK_NEAR(value(&file, x), 0.063, 1e-16);
    file_free(&file);
}

static void a_factor_is_solved_for_when_it_is_the_only_unknown(void **state)
{
    (void)state;
    const struct {
        const char *text;
        YkDimension dimension, unknown;
    } cases[] = {
        {"k*d", FORCE, STIFFNESS},
        {"d*k", FORCE, STIFFNESS},
        {"k*t", ANGLE, RATE},
        {"d/k", NUMBER, LENGTH},
        {"k/d", NUMBER, LENGTH},
        {"2*k*d*3", AREA, LENGTH},
        {"-k*theta.rate", TORQUE, {2, 1, -1, -1}},
        {"k^2", AREA, LENGTH},
        {"sqrt(k)", LENGTH, AREA},
        {"k^2 + d^2", AREA, LENGTH},
        {"sqrt(k^2 + d^2)", LENGTH, LENGTH},
        {"1/k", {0, 0, -1, 0}, TIME},
        {"d*sin(k*t)", LENGTH, RATE},
        {"exp(-t/k)", NUMBER, TIME},
        {"min(k, d)", LENGTH, LENGTH},
        {"d*2^k", LENGTH, NUMBER},
        {"d*k^1.5", LENGTH, NUMBER},
        {"atan2(k, d)", ANGLE, LENGTH},
        {"d*sign(k - t)", LENGTH, TIME},
        {"abs(k)*d", AREA, LENGTH},
        {"theta*k^theta", ANGLE, NUMBER},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        File file = file_new(yk_units_si());
        parameter(&file, "k", "7");
        use(&file, cases[i].text, cases[i].dimension, "x");
        if (!run(&file)) print_error("«%s»: %s", cases[i].text, yk_problems_text(file.fixture.problems, 0));
        assert_true(file.is_fine);
        YkDimension found;
        if (!yk_dimensions_of(file.dims, "k", &found) || !yk_dimension_equal(found, cases[i].unknown))
            print_error("«%s» makes it %s\n", cases[i].text, yk_dimension_name(found));
        check_parameter(&file, "k", cases[i].unknown);
        file_free(&file);
    }
}

static void solved_angles_convert_like_any_other(void **state)
{
    (void)state;
    File file = file_new(millimetres_and_degrees());
    parameter(&file, "w", "90");
    const YkExpr *angle = use(&file, "w*t", ANGLE, "drive"); // 90 deg/s for 2 s
    run_well(&file);
    CHECK_NEAR(value(&file, angle), 3.14159265358979323846, 1e-14);
    file_free(&file);
}

static void dimensions_travel_along_chains_of_parameters_in_any_order(void **state)
{
    (void)state;
    File file = file_new(millimetres_and_degrees());
    parameter(&file, "a", "b/2");
    parameter(&file, "b", "c + e");
    parameter(&file, "c", "10");
    parameter(&file, "e", "f");
    parameter(&file, "f", "6");
    parameter(&file, "h", "3 mm");
    parameter(&file, "i", "2*h");
    const YkExpr *x = use(&file, "a", LENGTH, "x");
    use(&file, "i*1 m", AREA, "area");
    run_well(&file);
    check_parameter(&file, "f", LENGTH);
    check_parameter(&file, "i", LENGTH);
    CHECK_NEAR(value(&file, x), 0.008, 1e-16);
    file_free(&file);
}

// One use decides a chain of any length, whether each parameter is declared before what it needs or after.
static void one_use_decides_a_chain_of_parameters(void **state)
{
    (void)state;
    static const char *const names[] = {"q0", "q1", "q2", "q3", "q4", "q5", "q6", "q7", "q8", "q9"};
    for (int way = 0; way < 2; way++) {
        File file = file_new(millimetres_and_degrees());
        for (int k = 0; k < 10; k++) {
            int at = way ? 9 - k : k;
            char text[20];
            snprintf(text, sizeof text, at > 0 ? "q%d/2" : "512", at - 1);
            parameter(&file, names[at], text);
        }
        const YkExpr *x = use(&file, "q9", LENGTH, "x");
        run_well(&file);
        for (int k = 0; k < 10; k++) check_parameter(&file, names[k], LENGTH);
        CHECK_NEAR(value(&file, x), 1e-3, 1e-18);
        file_free(&file);
    }
}

static void an_unused_parameter_stays_open_and_counts_as_a_number(void **state)
{
    (void)state;
    File file = file_new(millimetres_and_degrees());
    YkDimension found = LENGTH;
    parameter(&file, "a", "7");
    parameter(&file, "b", "a + 1");
    run_well(&file);
    assert_false(yk_dimensions_of(file.dims, "a", &found));
    assert_true(yk_dimension_equal(found, NUMBER));
    assert_false(yk_dimensions_of(file.dims, "nobody", &found));
    CHECK_NEAR(value(&file, file.values[1]), 8, 0);
    file_free(&file);
}

static void of_two_unknown_factors_the_first_is_a_number(void **state)
{
    (void)state;
    File file = file_new(yk_units_si());
    parameter(&file, "k", "3");
    parameter(&file, "b", "4");
    const YkExpr *torque = use(&file, "k*b", TORQUE, "effort");
    run_well(&file);
    CHECK_NEAR(value(&file, torque), 12, 0);
    check_parameter(&file, "b", TORQUE);
    file_free(&file);
}

static void of_two_products_with_an_unknown_each_the_first_has_a_number(void **state)
{
    (void)state;
    File file = file_new(yk_units_si());
    parameter(&file, "k", "3");
    parameter(&file, "b", "4");
    const YkExpr *torque = use(&file, "(k*d)*(b/t)", TORQUE, "effort");
    run_well(&file);
    CHECK_NEAR(value(&file, torque), 12, 0);
    check_parameter(&file, "b", (YkDimension){1, 1, -1, 0});
    file_free(&file);
}

static void a_later_use_decides_an_ambiguous_product(void **state)
{
    (void)state;
    File file = file_new(yk_units_si());
    parameter(&file, "k", "3");
    parameter(&file, "b", "4");
    use(&file, "k*b", TORQUE, "effort");
    use(&file, "k", FORCE, "force");
    run_well(&file);
    check_parameter(&file, "k", FORCE);
    check_parameter(&file, "b", LENGTH);
    file_free(&file);
}

typedef struct Wrong {
    const char *text;
    YkDimension dimension;
    int code;
    unsigned column;
    const char *word;
} Wrong;

static void contradictions_inside_an_expression_are_found_at_their_place(void **state)
{
    (void)state;
    const Wrong cases[] = {
        {"3 mm", MASS, 321, 1, "mass of `link1` must be a mass, this is a length"},
        {"d + t", LENGTH, 320, 5, "cannot add a length and a time"},
        {"d - 3 kg", LENGTH, 320, 5, "cannot subtract a mass from a length"},
        {"d*(2 + (t - d))", AREA, 320, 13, "cannot subtract a length from a time"},
        {"2*t", ANGLE, 321, 1, "must be an angle, this is a time"},
        {"2*sin(theta)", LENGTH, 321, 1, "`2 m * sin(theta)`"},
        {"sin(theta)", LENGTH, 321, 1, "`1 m * (sin(theta))`"},
        {"3*15 deg", LENGTH, 321, 1, "this is an angle"},
        {"sin(d)", NUMBER, 323, 5, "`sin` takes an angle, this is a length"},
        {"exp(t)", NUMBER, 323, 5, "`exp` takes a number, this is a time"},
        {"asin(d)", ANGLE, 323, 6, "`asin` takes a number"},
        {"max(d, t)", LENGTH, 320, 8, "`max` needs two of the same kind"},
        {"atan2(d, t)", ANGLE, 320, 10, "`atan2`"},
        {"sqrt(d)", LENGTH, 324, 1, "cannot take the square root of a length"},
        {"d^0.5", LENGTH, 324, 1, "cannot raise a length to the power 0.5"},
        {"2^d", NUMBER, 324, 3, "an exponent must be a number, this is a length"},
        {"d^theta", NUMBER, 324, 3, "whole number"},
        {"d^2", LENGTH, 321, 1, "must be a length, this is an area"},
        {"1/d", LENGTH, 321, 1, "must be a length"},
        {"(d^2)^0.25", LENGTH, 324, 2, "cannot raise an area"},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        File file = file_new(millimetres_and_degrees());
        use(&file, cases[i].text, cases[i].dimension, "mass of `link1`");
        if (run(&file)) print_error("«%s» passed\n", cases[i].text);
        assert_false(file.is_fine);
        unsigned column = i == sizeof cases / sizeof *cases - 1 ? 1 : cases[i].column;
        check_one_problem(&file.fixture, cases[i].text, cases[i].code, column, cases[i].word);
        file_free(&file);
    }
}

static void whole_powers_and_roots_of_quantities_are_fine(void **state)
{
    (void)state;
    const struct {
        const char *text;
        YkDimension dimension;
    } cases[] = {
        {"sqrt(d^2 + d*(3 mm))", LENGTH}, {"(d^2)^0.5", LENGTH}, {"(d^2)^(1/2)", LENGTH}, {"d^-1*d", NUMBER},
        {"(d/t^2)*t*t", LENGTH},          {"(d/d)^0.3", NUMBER}, {"(d^2)^1.5/d", AREA},   {"theta^2", NUMBER},
        {"sqrt(theta)", NUMBER},          {"d^0", NUMBER},       {"theta.rate*t", ANGLE}, {"d*theta", LENGTH},
        {"(d/d)^(theta)", NUMBER},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        File file = file_new(millimetres_and_degrees());
        use(&file, cases[i].text, cases[i].dimension, "x");
        if (!run(&file)) print_error("«%s»: %s", cases[i].text, yk_problems_text(file.fixture.problems, 0));
        assert_true(file.is_fine);
        file_free(&file);
    }
}

static void one_parameter_in_two_ways_names_both_uses_and_the_other_place(void **state)
{
    (void)state;
    File file = file_new(yk_units_si());
    YkExpr *first = fixture_parse(&file.fixture, "a"), *second = fixture_parse(&file.fixture, "a");
    parameter(&file, "a", "3");
    first->place = (YkPlace){7, 5, 1};
    second->place = (YkPlace){9, 2, 1};
    yk_dimensions_use(file.dims, first, LENGTH, "x of point `A`");
    yk_dimensions_use(file.dims, second, MASS, "mass of `link1`");
    assert_false(run(&file));
    assert_int_equal(yk_problems_count(file.fixture.problems), 1);
    const YkProblem *problem = yk_problems_get(file.fixture.problems, 0);
    assert_int_equal(problem->code, YK_CODE_TWO_DIMENSIONS);
    assert_int_equal(problem->place.line, 9);
    assert_string_equal(problem->message,
                        "`a` is used as a mass here (mass of `link1`) but as a length elsewhere (x of point `A`)");
    assert_non_null(strstr(problem->hint, "line 7, column 5"));
    file_free(&file);
}

static void two_ways_are_found_in_sums_functions_and_other_parameters(void **state)
{
    (void)state;
    static const char *const seconds[] = {"a + t", "t - 2*a", "max(t, a)", "sin(a)*t", "t*2^a", "-a/2 + t"};
    for (size_t i = 0; i < sizeof seconds / sizeof *seconds; i++) {
        File file = file_new(yk_units_si());
        parameter(&file, "a", "3");
        use(&file, "a", LENGTH, "x");
        use(&file, seconds[i], TIME, "duration");
        assert_false(run(&file));
        assert_int_equal(yk_problems_count(file.fixture.problems), 1);
        if (yk_problems_get(file.fixture.problems, 0)->code != YK_CODE_TWO_DIMENSIONS)
            print_error("«%s»\n", seconds[i]);
        assert_int_equal(yk_problems_get(file.fixture.problems, 0)->code, YK_CODE_TWO_DIMENSIONS);
        file_free(&file);
    }
}

static void degrees_and_plain_numbers_are_two_ways_only_where_they_differ(void **state)
{
    (void)state;
    for (int in_degrees = 0; in_degrees < 2; in_degrees++) {
        File file = file_new(in_degrees ? millimetres_and_degrees() : yk_units_si());
        parameter(&file, "a", "30");
        use(&file, "a", ANGLE, "angle");
        use(&file, "a", NUMBER, "teeth");
        assert_int_equal(run(&file), !in_degrees);
        assert_int_equal(yk_problems_count(file.fixture.problems), in_degrees);
        file_free(&file);
    }
}

static void a_parameter_with_its_own_unit_is_wrong_at_the_use(void **state)
{
    (void)state;
    File file = file_new(yk_units_si());
    parameter(&file, "a", "b");
    parameter(&file, "b", "3 mm");
    use(&file, "a", MASS, "mass of `link1`");
    assert_false(run(&file));
    check_one_problem(&file.fixture, "a", YK_CODE_WRONG_DIMENSION, 1,
                      "mass of `link1` must be a mass, this is a length");
    file_free(&file);
}

static void a_parameters_own_sum_is_checked_even_when_it_is_not_used(void **state)
{
    (void)state;
    File file = file_new(yk_units_si());
    parameter(&file, "a", "3 mm + 2 kg");
    assert_false(run(&file));
    check_one_problem(&file.fixture, "a", YK_CODE_MIXED_SUM, 8, "cannot add a length and a mass");
    file_free(&file);
}

static void unknown_names_are_left_to_the_caller(void **state)
{
    (void)state;
    File file = file_new(yk_units_si());
    parameter(&file, "a", "nobody*2");
    use(&file, "a + nobody + 3 kg * d", LENGTH, "x");
    use(&file, "sin(nobody)^nobody", LENGTH, "x");
    use(&file, "max(nobody, t) - d/nobody", LENGTH, "x");
    run_well(&file);
    file_free(&file);
}

static void circles_of_parameters_come_to_an_end(void **state)
{
    (void)state;
    File file = file_new(yk_units_si());
    parameter(&file, "a", "b + 1");
    parameter(&file, "b", "2*a");
    use(&file, "b", LENGTH, "x");
    run_well(&file);
    check_parameter(&file, "a", LENGTH);
    file_free(&file);
}

static void an_empty_file_is_fine(void **state)
{
    (void)state;
    Fixture fixture = fixture_new();
    YkUnits units = yk_units_si();
    YkDimensions *dims = yk_dimensions_new(fixture.arena, &units);
    YkDimension found;
    assert_false(yk_dimensions_of(dims, "a", &found)); // before it ran
    assert_true(yk_dimensions_run(dims, fixture.problems));
    assert_false(yk_dimensions_of(dims, "a", &found));
    fixture_free(&fixture);
}

// A chain of parameters, declared so that each needs the next: the worst order for sweeps.
static void follow_chain(size_t count)
{
    Fixture fixture = fixture_new();
    YkUnits units = yk_units_si();
    YkDimensions *dims = yk_dimensions_new(fixture.arena, &units);
    char text[32];
    for (size_t i = 0; i < count; i++) {
        int length = snprintf(text, sizeof text, i + 1 < count ? "p%zu + 1" : "3 mm", i + 1);
        YkExpr *expr = yk_expr_parse(text, (size_t)length, (YkPlace){1, 1, 0}, fixture.arena, fixture.problems);
        length = snprintf(text, sizeof text, "p%zu", i);
        char *name = yk_arena_copy(fixture.arena, text, (size_t)length);
        yk_dimensions_parameter(dims, name, expr);
        YkExpr *use = yk_expr_parse(text, (size_t)length, (YkPlace){1, 1, 0}, fixture.arena, fixture.problems);
        yk_dimensions_use(dims, use, LENGTH, "x");
    }
    assert_true(yk_dimensions_run(dims, fixture.problems));
    YkDimension found;
    assert_true(yk_dimensions_of(dims, "p0", &found));
    assert_true(yk_dimension_equal(found, LENGTH));
    fixture_free(&fixture);
}

// At a quadratic cost it would not end before the test's time limit.
static void a_long_chain_is_followed(void **state)
{
    (void)state;
    follow_chain(100000);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_bare_number_takes_the_unit_of_its_use),
        cmocka_unit_test(angles_in_functions_are_in_the_files_unit_and_pi_is_in_radians),
        cmocka_unit_test(a_number_of_literals_alone_is_bare_whatever_functions_are_in_it),
        cmocka_unit_test(a_sine_among_the_parameters_is_a_number_unless_a_use_says_otherwise),
        cmocka_unit_test(a_bare_parameter_takes_the_dimension_of_its_use),
        cmocka_unit_test(the_toggle_linkages_parameters_are_found),
        cmocka_unit_test(a_module_in_length_makes_numbers_of_teeth),
        cmocka_unit_test(a_factor_is_solved_for_when_it_is_the_only_unknown),
        cmocka_unit_test(solved_angles_convert_like_any_other),
        cmocka_unit_test(dimensions_travel_along_chains_of_parameters_in_any_order),
        cmocka_unit_test(one_use_decides_a_chain_of_parameters),
        cmocka_unit_test(an_unused_parameter_stays_open_and_counts_as_a_number),
        cmocka_unit_test(of_two_unknown_factors_the_first_is_a_number),
        cmocka_unit_test(of_two_products_with_an_unknown_each_the_first_has_a_number),
        cmocka_unit_test(a_later_use_decides_an_ambiguous_product),
        cmocka_unit_test(contradictions_inside_an_expression_are_found_at_their_place),
        cmocka_unit_test(whole_powers_and_roots_of_quantities_are_fine),
        cmocka_unit_test(one_parameter_in_two_ways_names_both_uses_and_the_other_place),
        cmocka_unit_test(two_ways_are_found_in_sums_functions_and_other_parameters),
        cmocka_unit_test(degrees_and_plain_numbers_are_two_ways_only_where_they_differ),
        cmocka_unit_test(a_parameter_with_its_own_unit_is_wrong_at_the_use),
        cmocka_unit_test(a_parameters_own_sum_is_checked_even_when_it_is_not_used),
        cmocka_unit_test(unknown_names_are_left_to_the_caller),
        cmocka_unit_test(circles_of_parameters_come_to_an_end),
        cmocka_unit_test(an_empty_file_is_fine),
        cmocka_unit_test(a_long_chain_is_followed),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
