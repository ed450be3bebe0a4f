// Amounts in the file's units.
#include "check.h"
#include <yoke/yoke.h>
#include "base/vec.h"
#include "write/amount.h"

static YkModel *load(const char *units)
{
    char text[400];
    snprintf(
        text, sizeof text,
        "%s\nbodies: {ground: {}, crank: {points: {A: [1, 0]}}}\njoints: {O: {pin: [ground, crank], angle: theta}}\n",
        units);
    YkProblems *problems = yk_problems_new();
    YkModel *model = yk_model_parse(text, strlen(text), "test", NULL, problems);
    assert_non_null(model);
    yk_problems_free(problems);
    return model;
}

static void check(const char *units, double value, YkQuantity quantity, const char *expected)
{
    YkModel *model = load(units);
    YkText text = {0};
    yk_amount_write_shown(&text, model, yk_amount_in_unit(model, NULL, value, quantity), quantity, 5);
    assert_string_equal(yk_text_get(&text), expected);
    yk_text_free(&text);
    yk_model_free(model);
}

static void amounts_are_told_in_the_files_units(void **state)
{
    (void)state;
    check("units: {length: mm, angle: deg}", 0.25, YK_QUANTITY_LENGTH, "250 mm");
    check("units: {length: mm, angle: deg}", YK_PI / 6, YK_QUANTITY_ANGLE, "30 deg");
    check("units: {length: mm, angle: deg}", YK_PI, YK_QUANTITY_ANGLE_RATE, "180 deg/s");
    check("units: {length: mm, force: N}", 2.5, YK_QUANTITY_TORQUE, "2500 N*mm");
    check("units: {}", 3, YK_QUANTITY_NUMBER, "3");
}

static void radians_are_told_in_degrees_too(void **state)
{
    (void)state;
    check("units: {}", YK_PI / 2, YK_QUANTITY_ANGLE, "1.5708 rad (90 deg)");
}

// Of units that would make an unusual one of force, N, N*m and J are told; energies always in J.
static void unusual_units_of_force_are_not_told(void **state)
{
    (void)state;
    check("units: {length: mm}", 12, YK_QUANTITY_FORCE, "12 N");
    check("units: {length: mm}", 12, YK_QUANTITY_TORQUE, "12 N*m");
    check("units: {}", 12, YK_QUANTITY_ENERGY, "12 J");
}

static void rounding_is_no_amount(void **state)
{
    (void)state;
    check("units: {}", 1e-15, YK_QUANTITY_LENGTH, "0 m");
    check("units: {}", -1e-15, YK_QUANTITY_FORCE, "0 N");
    check("units: {}", 1e-9, YK_QUANTITY_LENGTH, "1e-9 m");
}

// Of lengths and their rates rounding is measured by the machine: 1e-13 of 1 km is a tenth of a nanometre.
static void rounding_of_lengths_grows_with_the_machine(void **state)
{
    (void)state;
    YkProblems *problems = yk_problems_new();
    static const char text[] = "bodies: {ground: {points: {O: [0, 0]}}, crank: {points: {O: [0, 0], A: [1 km, 0]}}}\n"
                               "joints: {O: {pin: [ground, crank], angle: theta}}\n";
    YkModel *model = yk_model_parse(text, strlen(text), "test", NULL, problems);
    YkMechanism *mech = yk_mechanism_compile(model, NULL, problems);
    assert_non_null(mech);
    assert_true(yk_mechanism_size(mech) >= 1000);
    for (int quantity = YK_QUANTITY_ANGLE; quantity <= YK_QUANTITY_ENERGY; quantity++) {
        bool is_length =
            quantity == YK_QUANTITY_LENGTH || quantity == YK_QUANTITY_SPEED || quantity == YK_QUANTITY_ACCELERATION;
        double rounding = 5e-11, shown = yk_amount_in_unit(model, mech, rounding, (YkQuantity)quantity);
        CHECK_NEAR(shown, is_length ? 0 : rounding, 0);
        CHECK_NEAR(yk_amount_in_unit(model, NULL, rounding, (YkQuantity)quantity), rounding, 0);
    }
    yk_mechanism_free(mech);
    yk_model_free(model);
    yk_problems_free(problems);
}

static void ranges_are_told_by_their_finite_ends(void **state)
{
    (void)state;
    static const struct {
        double low, high;
        const char *expected;
    } cases[] = {{2.96, 3.49, "2.96 to 3.49"},
                 {3, INFINITY, "3 or more"},
                 {-INFINITY, 5, "up to 5"},
                 {-INFINITY, INFINITY, "any"}};
    for (size_t k = 0; k < 4; k++) {
        YkText text = {0};
        yk_amount_between(&text, cases[k].low, cases[k].high, 3);
        assert_string_equal(yk_text_get(&text), cases[k].expected);
        yk_text_free(&text);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(amounts_are_told_in_the_files_units),
        cmocka_unit_test(radians_are_told_in_degrees_too),
        cmocka_unit_test(unusual_units_of_force_are_not_told),
        cmocka_unit_test(rounding_is_no_amount),
        cmocka_unit_test(ranges_are_told_by_their_finite_ends),
        cmocka_unit_test(rounding_of_lengths_grows_with_the_machine),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
