// Unit words, dimensions, and bare numbers.
#include "check.h"
#include <stdlib.h>
#include "base/units/units.h"
#include "base/vec.h"

typedef struct Case {
    const char *word;
    double size;
    YkDimension dimension;
} Case;

static const Case words[] = {{"m", 1, {1, 0, 0, 0}},
                             {"mm", 1e-3, {1, 0, 0, 0}},
                             {"cm", 1e-2, {1, 0, 0, 0}},
                             {"dm", 0.1, {1, 0, 0, 0}},
                             {"km", 1e3, {1, 0, 0, 0}},
                             {"um", 1e-6, {1, 0, 0, 0}},
                             {"in", 0.0254, {1, 0, 0, 0}},
                             {"ft", 0.3048, {1, 0, 0, 0}},
                             {"kg", 1, {0, 1, 0, 0}},
                             {"g", 1e-3, {0, 1, 0, 0}},
                             {"t", 1e3, {0, 1, 0, 0}},
                             {"lb", 0.45359237, {0, 1, 0, 0}},
                             {"s", 1, {0, 0, 1, 0}},
                             {"ms", 1e-3, {0, 0, 1, 0}},
                             {"us", 1e-6, {0, 0, 1, 0}},
                             {"min", 60, {0, 0, 1, 0}},
                             {"h", 3600, {0, 0, 1, 0}},
                             {"rad", 1, {0, 0, 0, 1}},
                             {"mrad", 1e-3, {0, 0, 0, 1}},
                             {"deg", 3.14159265358979323846 / 180, {0, 0, 0, 1}},
                             {"turn", 6.28318530717958647693, {0, 0, 0, 1}},
                             {"rev", 6.28318530717958647693, {0, 0, 0, 1}},
                             {"rpm", 0.10471975511965977462, {0, 0, -1, 1}},
                             {"rps", 6.28318530717958647693, {0, 0, -1, 1}},
                             {"Hz", 1, {0, 0, -1, 0}},
                             {"N", 1, {1, 1, -2, 0}},
                             {"mN", 1e-3, {1, 1, -2, 0}},
                             {"kN", 1e3, {1, 1, -2, 0}},
                             {"MN", 1e6, {1, 1, -2, 0}},
                             {"lbf", 4.4482216152605, {1, 1, -2, 0}},
                             {"kgf", 9.80665, {1, 1, -2, 0}},
                             {"Nm", 1, {2, 1, -2, 0}},
                             {"Nmm", 1e-3, {2, 1, -2, 0}},
                             {"kNm", 1e3, {2, 1, -2, 0}},
                             {"J", 1, {2, 1, -2, 0}},
                             {"mJ", 1e-3, {2, 1, -2, 0}},
                             {"kJ", 1e3, {2, 1, -2, 0}},
                             {"W", 1, {2, 1, -3, 0}},
                             {"mW", 1e-3, {2, 1, -3, 0}},
                             {"kW", 1e3, {2, 1, -3, 0}},
                             {"Pa", 1, {-1, 1, -2, 0}},
                             {"kPa", 1e3, {-1, 1, -2, 0}},
                             {"MPa", 1e6, {-1, 1, -2, 0}},
                             {"GPa", 1e9, {-1, 1, -2, 0}},
                             {"bar", 1e5, {-1, 1, -2, 0}},
                             {"%", 0.01, {0, 0, 0, 0}},
                             {"kg*m^2", 1, {2, 1, 0, 0}},
                             {"kg*mm^2", 1e-6, {2, 1, 0, 0}},
                             {"g*cm^2", 1e-7, {2, 1, 0, 0}},
                             {"N*s/m", 1, {0, 1, -1, 0}},
                             {"m/s^2", 1, {1, 0, -2, 0}},
                             {"mm/s", 1e-3, {1, 0, -1, 0}},
                             {"rad/s", 1, {0, 0, -1, 1}},
                             {"rad/s^2", 1, {0, 0, -2, 1}},
                             {"deg/s", 3.14159265358979323846 / 180, {0, 0, -1, 1}},
                             {"N*m", 1, {2, 1, -2, 0}},
                             {"N*mm", 1e-3, {2, 1, -2, 0}},
                             {"N*m/rad", 1, {2, 1, -2, -1}},
                             {"N*m*s/rad", 1, {2, 1, -1, -1}},
                             {"N/mm", 1e3, {0, 1, -2, 0}},
                             {"N/mm^2", 1e6, {-1, 1, -2, 0}},
                             {"kN/m", 1e3, {0, 1, -2, 0}},
                             {"1/s", 1, {0, 0, -1, 0}},
                             {"s^-1", 1, {0, 0, -1, 0}},
                             {"m*s^-2", 1, {1, 0, -2, 0}},
                             {"mm^3", 1e-9, {3, 0, 0, 0}},
                             {"in^2", 0.00064516, {2, 0, 0, 0}},
                             {"lbf/in", 175.126835246476377952755905511811, {0, 1, -2, 0}},
                             {"km/h", 1000.0 / 3600, {1, 0, -1, 0}},
                             {"m^9", 1, {9, 0, 0, 0}},
                             {"kg/m^3", 1, {-3, 1, 0, 0}}};
enum { WORDS = sizeof words / sizeof *words };

static bool same_dimension(YkDimension a, YkDimension b)
{
    return yk_dimension_equal(a, b) && a.angle == b.angle;
}

static void every_unit_has_its_exact_size_and_dimension(void **state)
{
    (void)state;
    for (int i = 0; i < WORDS; i++) {
        double size;
        YkDimension dimension;
        const char *bad;
        size_t bad_length;
        if (!yk_unit_read(words[i].word, strlen(words[i].word), &size, &dimension, &bad, &bad_length))
            fail_msg("%s is unknown", words[i].word);
        if (size != words[i].size) fail_msg("%s is %.17g, not %.17g", words[i].word, size, words[i].size);
        if (!same_dimension(dimension, words[i].dimension))
            fail_msg("%s is %s", words[i].word, yk_dimension_name(dimension));
    }
}

static double size_of(const char *word)
{
    double size = NAN;
    YkDimension dimension;
    const char *bad;
    size_t bad_length;
    assert_true(yk_unit_read(word, strlen(word), &size, &dimension, &bad, &bad_length));
    return size;
}

static void units_agree_with_each_other(void **state)
{
    (void)state;
    CHECK_NEAR(180 * size_of("deg"), YK_PI, 0);
    CHECK_NEAR(90 * size_of("deg"), YK_PI / 2, 0);
    CHECK_NEAR(360 * size_of("deg"), size_of("turn"), 0);
    CHECK_NEAR(size_of("rpm"), size_of("turn/min"), 1e-16);
    CHECK_NEAR(size_of("rpm"), 6 * size_of("deg/s"), 1e-16);
    CHECK_NEAR(size_of("rps"), 60 * size_of("rpm"), 1e-15);
    CHECK_NEAR(size_of("lbf"), size_of("lb") * 9.80665, 1e-15);
    CHECK_NEAR(size_of("ft"), 12 * size_of("in"), 1e-16);
    CHECK_NEAR(size_of("W"), size_of("N*m/s"), 0);
    CHECK_NEAR(size_of("MPa"), size_of("N/mm^2"), 0);
    CHECK_NEAR(size_of("kN*mm"), size_of("J"), 0);
    CHECK_NEAR(size_of("bar"), size_of("N/cm^2") * 10, 0);
}

static void what_is_no_unit_is_pointed_at(void **state)
{
    (void)state;
    static const struct {
        const char *word, *bad;
    } cases[] = {{"foo", "foo"},
                 {"N*foo/m", "foo"},
                 {"N*m/foo^2", "foo^2"},
                 {"", ""},
                 {"kg**m", ""},
                 {"kg*", ""},
                 {"/s", ""},
                 {"m^", "m^"},
                 {"m^x", "m^x"},
                 {"m^0", "m^0"},
                 {"m^10", "m^10"},
                 {"m^-", "m^-"},
                 {"1", "1"},
                 {"kg*1/s", "1"},
                 {"Kg", "Kg"},
                 {"M", "M"},
                 {"m s", "m s"},
                 {"2m", "2m"},
                 {"min^9*min^9*min^9*min^9*min^9*min^9*min^9*min^9*min^9*min^9*min^9*min^9*min^9*min^9*min^9*min^9*min^"
                  "9*min^9*min^9*min^9*min^9",
                  "min^9*min^9*min^9*min^9*min^9*min^9*min^9*min^9*min^9*min^9*min^9*min^9*min^9*min^9*min^9*min^9*min^"
                  "9*min^9*min^9*min^9*min^9"},
                 {"um^9", "um^9"}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        double size;
        YkDimension dimension;
        const char *bad = NULL;
        size_t bad_length = 99;
        assert_false(yk_unit_read(cases[i].word, strlen(cases[i].word), &size, &dimension, &bad, &bad_length));
        assert_int_equal(bad_length, strlen(cases[i].bad));
        assert_memory_equal(bad, cases[i].bad, bad_length);
        assert_true(bad >= cases[i].word && bad + bad_length <= cases[i].word + strlen(cases[i].word));
    }
}

static void only_the_given_length_is_read(void **state)
{
    (void)state;
    double size;
    YkDimension dimension;
    const char *bad;
    size_t bad_length;
    assert_true(yk_unit_read("mm/s]", 2, &size, &dimension, &bad, &bad_length));
    assert_true(size == 1e-3 && dimension.time == 0);
}

static void the_nearest_unit_is_found(void **state)
{
    (void)state;
    static const struct {
        const char *word, *nearest;
    } cases[] = {{"KG", "kg"},
                 {"Deg", "deg"},
                 {"degs", "deg"},
                 {"RPM", "rpm"},
                 {"n", "N"},
                 {"hz", "Hz"},
                 {"radd", "rad"},
                 {"trn", "turn"},
                 {"degr^2", "deg"},
                 {"degrees", "deg"},
                 {"Degree", NULL},
                 {"metre", "m"},
                 {"millimeters", "mm"},
                 {"secs", "s"},
                 {"secondss", NULL},
                 {"kilograms^2", "kg"},
                 {"parsec", NULL},
                 {"", NULL},
                 {"^2", NULL},
                 {"a-very-long-word-for-a-unit", NULL}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        const char *found = yk_unit_nearest(cases[i].word, strlen(cases[i].word));
        if (!cases[i].nearest)
            assert_null(found);
        else if (!found || strcmp(found, cases[i].nearest) != 0)
            fail_msg("%s -> %s", cases[i].word, found ? found : "nothing");
    }
}

static void dimensions_differ_in_more_than_the_angle(void **state)
{
    (void)state;
    assert_true(yk_dimension_equal((YkDimension){2, 1, -2, 0}, (YkDimension){2, 1, -2, -1}));
    assert_false(yk_dimension_equal((YkDimension){2, 1, -2, 0}, (YkDimension){1, 1, -2, 0}));
    assert_false(yk_dimension_equal((YkDimension){0, 1, 0, 0}, (YkDimension){0, 0, 0, 0}));
    assert_false(yk_dimension_equal((YkDimension){0, 0, 1, 0}, (YkDimension){0, 0, 0, 0}));
}

static void dimensions_multiply_as_a_group(void **state)
{
    (void)state;
    uint64_t seed = 41;
    for (int i = 0; i < 1000; i++) {
        YkDimension a = {0}, b = {0};
        signed char *parts[] = {&a.length, &a.mass, &a.time, &a.angle, &b.length, &b.mass, &b.time, &b.angle};
        for (size_t k = 0; k < 8; k++) *parts[k] = (signed char)((int)(check_random(&seed) % 9) - 4);
        int power = (int)(check_random(&seed) % 7) - 3;
        YkDimension product = yk_dimension_times(a, b, power);
        assert_true(same_dimension(yk_dimension_times(product, b, -power), a));
        assert_true(same_dimension(yk_dimension_times(a, b, 1), yk_dimension_times(b, a, 1)));
        assert_int_equal(product.mass, a.mass + power * b.mass);
    }
    YkDimension far = yk_dimension_times((YkDimension){100, 0, 0, 0}, (YkDimension){100, 0, 0, 0}, 1000000000);
    assert_int_equal(far.length, 127);
}

static void dimensions_have_the_names_of_the_field(void **state)
{
    (void)state;
    static const struct {
        YkDimension dimension;
        const char *name;
    } cases[] = {{{0, 0, 0, 0}, "a number"},
                 {{0, 0, 0, 1}, "an angle"},
                 {{1, 0, 0, 0}, "a length"},
                 {{0, 1, 0, 0}, "a mass"},
                 {{0, 0, 1, 0}, "a time"},
                 {{2, 1, -2, 0}, "a torque or energy"},
                 {{2, 1, -2, -1}, "an angular stiffness"},
                 {{1, 1, -2, 0}, "a force"},
                 {{2, 1, 0, 0}, "a moment of inertia"},
                 {{0, 0, -1, 1}, "an angular speed"},
                 {{0, 0, -1, 0}, "a frequency"},
                 {{0, 0, -1, 5}, "a frequency"},
                 {{1, 0, 0, 7}, "a length"},
                 {{0, 1, -2, 0}, "a stiffness"},
                 {{2, 2, -1, 0}, "a quantity in kg^2 m^2 s^-1"},
                 {{4, 0, 4, 0}, "a quantity in m^4 s^4"},
                 {{0, 0, 2, 0}, "a quantity in s^2"},
                 {{-1, 0, 0, 0}, "a quantity in m^-1"},
                 {{-4, -2, -4, 0}, "a quantity in kg^-2 m^-4 s^-4"},
                 {{5, 0, 0, 0}, "a quantity of an unusual dimension"},
                 {{0, -3, 0, 0}, "a quantity of an unusual dimension"},
                 {{0, 0, 127, 0}, "a quantity of an unusual dimension"}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++)
        assert_string_equal(yk_dimension_name(cases[i].dimension), cases[i].name);
}

// By units that measure nothing else.
static void units_have_the_names_of_what_they_measure(void **state)
{
    (void)state;
    static const char *const cases[][2] = {{"cm^2", "an area"},
                                           {"mm^3", "a volume"},
                                           {"rpm", "an angular speed"},
                                           {"rad/s^2", "an angular acceleration"},
                                           {"deg/s^3", "an angular jerk"},
                                           {"km/h", "a speed"},
                                           {"mm/s^2", "an acceleration"},
                                           {"m/s^3", "a jerk"},
                                           {"g*cm^2", "a moment of inertia"},
                                           {"kg/m^3", "a density"},
                                           {"N*s", "a momentum"},
                                           {"N*m*s", "an angular momentum or angular damping"},
                                           {"N*m*s/rad", "an angular damping"},
                                           {"lbf", "a force"},
                                           {"kJ", "a torque or energy"},
                                           {"Nmm/deg", "an angular stiffness"},
                                           {"N/mm", "a stiffness"},
                                           {"N*s/m", "a damping"},
                                           {"kW", "a power"},
                                           {"bar", "a pressure"}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        double size;
        YkDimension dimension;
        const char *bad;
        size_t bad_length;
        assert_true(yk_unit_read(cases[i][0], strlen(cases[i][0]), &size, &dimension, &bad, &bad_length));
        assert_string_equal(yk_dimension_name(dimension), cases[i][1]);
    }
}

// The unnamed ones are written out by hand-made macros: read them back.
static void every_unnamed_dimension_is_spelt_out(void **state)
{
    (void)state;
    int seen = 0;
    for (signed char m = -2; m <= 2; m++)
        for (signed char l = -4; l <= 4; l++)
            for (signed char s = -4; s <= 4; s++) {
                const char *name = yk_dimension_name((YkDimension){l, m, s, 0}), *prefix = "a quantity in ";
                if (strncmp(name, prefix, strlen(prefix)) != 0) continue;
                YkDimension total = {0};
                char copy[64];
                snprintf(copy, sizeof copy, "%s", name + strlen(prefix));
                for (char *word = strtok(copy, " "); word; word = strtok(NULL, " ")) {
                    double size;
                    YkDimension part;
                    const char *bad;
                    size_t bad_length;
                    assert_true(yk_unit_read(word, strlen(word), &size, &part, &bad, &bad_length));
                    total = yk_dimension_times(total, part, 1);
                }
                assert_true(total.length == l && total.mass == m && total.time == s);
                seen++;
            }
    assert_true(seen > 350);
}

static void bare_numbers_are_si_by_default(void **state)
{
    (void)state;
    YkUnits si = yk_units_si();
    assert_string_equal(si.length_name, "m");
    assert_string_equal(si.mass_name, "kg");
    assert_string_equal(si.time_name, "s");
    assert_string_equal(si.angle_name, "rad");
    assert_null(si.force_name);
    for (int i = 0; i < WORDS; i++) assert_true(yk_units_size(&si, words[i].dimension) == 1);
}

static void with_a_force_unit_stiffness_and_torque_follow_it_and_inertia_the_mass(void **state)
{
    (void)state;
    YkUnits units = yk_units_si();
    units.length = 1e-3;
    units.angle = size_of("deg");
    units.force = 1;
    static const struct {
        const char *quantity, *unit;
    } cases[] = {{"m", "mm"},
                 {"kg", "kg"},
                 {"N", "N"},
                 {"N/m", "N/mm"},
                 {"N*m", "N*mm"},
                 {"kg*m^2", "kg*mm^2"},
                 {"N*s/m", "N*s/mm"},
                 {"deg", "deg"},
                 {"rpm", "deg/s"},
                 {"m/s^2", "mm/s^2"},
                 {"W", "N*mm/s"},
                 {"Pa", "N/mm^2"},
                 {"N*m/rad", "N*mm/deg"},
                 {"1/s", "1/s"},
                 {"m^2", "mm^2"}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        double size;
        YkDimension dimension;
        const char *bad;
        size_t bad_length;
        assert_true(yk_unit_read(cases[i].quantity, strlen(cases[i].quantity), &size, &dimension, &bad, &bad_length));
        CHECK_NEAR(yk_units_size(&units, dimension), size_of(cases[i].unit), 0);
    }
}

static void without_a_force_unit_force_follows_from_the_others(void **state)
{
    (void)state;
    YkUnits units = yk_units_si();
    units.length = 1e-3;
    units.time = 60;
    CHECK_NEAR(yk_units_size(&units, (YkDimension){1, 1, -2, 0}), size_of("kg*mm/min^2"), 1e-22);
    CHECK_NEAR(yk_units_size(&units, (YkDimension){0, 1, -2, 0}), size_of("kg/min^2"), 1e-19);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_unit_has_its_exact_size_and_dimension),
        cmocka_unit_test(units_agree_with_each_other),
        cmocka_unit_test(what_is_no_unit_is_pointed_at),
        cmocka_unit_test(only_the_given_length_is_read),
        cmocka_unit_test(the_nearest_unit_is_found),
        cmocka_unit_test(dimensions_differ_in_more_than_the_angle),
        cmocka_unit_test(dimensions_multiply_as_a_group),
        cmocka_unit_test(dimensions_have_the_names_of_the_field),
        cmocka_unit_test(units_have_the_names_of_what_they_measure),
        cmocka_unit_test(every_unnamed_dimension_is_spelt_out),
        cmocka_unit_test(bare_numbers_are_si_by_default),
        cmocka_unit_test(with_a_force_unit_stiffness_and_torque_follow_it_and_inertia_the_mass),
        cmocka_unit_test(without_a_force_unit_force_follows_from_the_others),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
