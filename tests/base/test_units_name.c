// The unit of a bare number: what is written reads back as a unit of the same dimension and size.
#include "check.h"
#include "base/units/units.h"

static void check(const YkUnits *units, YkDimension dimension, const char *expected)
{
    YkText text = {0};
    yk_units_name(units, dimension, &text);
    assert_string_equal(yk_text_get(&text), expected);
    if (text.length > 0) {
        double size = 0;
        YkDimension read = {0};
        const char *bad;
        size_t bad_length;
        assert_true(yk_unit_read(yk_text_get(&text), text.length, &size, &read, &bad, &bad_length));
        assert_int_equal(read.length, dimension.length);
        assert_int_equal(read.mass, dimension.mass);
        assert_int_equal(read.time, dimension.time);
        assert_int_equal(read.angle, dimension.angle);
        CHECK_NEAR(size, yk_units_size(units, dimension), 1e-15 * size);
    }
    yk_text_free(&text);
}

static void a_unit_is_written_as_a_file_would_write_it(void **state)
{
    (void)state;
    YkUnits si = yk_units_si(), mm = si, tonne = si, force = si;
    mm.length = tonne.length = force.length = 1e-3;
    mm.length_name = tonne.length_name = force.length_name = "mm";
    tonne.mass = 1e3;
    tonne.mass_name = "t";
    force.force = 1e3;
    force.force_name = "kN";
    check(&si, (YkDimension){0, 0, 0, 0}, "");
    check(&si, (YkDimension){0, 0, 0, 1}, "rad");
    check(&si, (YkDimension){2, 1, -2, 0}, "N*m");
    check(&si, (YkDimension){0, 1, -2, 0}, "N/m");
    check(&si, (YkDimension){2, 1, -2, -1}, "N*m/rad");
    check(&si, (YkDimension){0, 1, -1, 0}, "N*s/m");
    check(&si, (YkDimension){2, 1, 0, 0}, "kg*m^2");
    check(&tonne, (YkDimension){0, 1, -2, 0}, "N/mm");
    check(&mm, (YkDimension){1, 0, -2, 0}, "mm/s^2");
    check(&mm, (YkDimension){-3, 1, 0, 0}, "kg/mm^3");
    check(&mm, (YkDimension){2, 1, -2, 0}, "kg*mm^2/s^2");
    check(&mm, (YkDimension){0, 0, -2, 0}, "s^-2");
    check(&mm, (YkDimension){-2, 0, -1, 0}, "mm^-2*s^-1");
    check(&force, (YkDimension){2, 1, -2, 0}, "kN*mm");
    check(&force, (YkDimension){0, 1, -2, 0}, "kN/mm");
    check(&force, (YkDimension){2, 1, -1, -1}, "kN*mm*s/rad");
    check(&force, (YkDimension){2, 1, 0, 0}, "kg*mm^2");
    check(&force, (YkDimension){1, 0, -1, 0}, "mm/s");
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(a_unit_is_written_as_a_file_would_write_it)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
