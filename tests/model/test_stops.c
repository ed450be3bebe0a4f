// Stops: the range of a coordinate.
#include "model/fixture.h"

#define MACHINE                                                                                                        \
    "parameters: {low: -30 deg, e: 0.3}\n"                                                                             \
    "bodies: {a: {}, b: {}}\n"                                                                                         \
    "joints: {O: {pin: [ground, a], angle: phi}, S: {slide: [a, b]}}\n"

static void a_stop_is_a_range_with_or_without_restitution(void **state)
{
    (void)state;
    YkModel *model = fixture_load("units: {length: mm, angle: deg}\n" MACHINE
                                  "stops: {phi: [low, 2*100], S.distance: {between: [0, 5], restitution: e/3}}\n");
    assert_int_equal(model->stop_count, 2);
    CHECK_NEAR(model->stops[0].low, -YK_PI / 6, 1e-16);
    CHECK_NEAR(model->stops[0].high, 200 * YK_PI / 180, 1e-15);
    CHECK_NEAR(model->stops[0].restitution, 0, 0);
    assert_null(model->stops[0].restitution_expr);
    assert_string_equal(model->coordinates[model->stops[1].coordinate].name, "S.distance");
    CHECK_NEAR(model->stops[1].low, 0, 0);
    CHECK_NEAR(model->stops[1].high, 0.005, 1e-18);
    CHECK_NEAR(model->stops[1].restitution, 0.1, 1e-16);
    yk_model_free(model);
}

static void restitution_goes_from_nothing_to_all(void **state)
{
    (void)state;
    YkModel *model = fixture_load(MACHINE "stops: {phi: {between: [0, 1], restitution: 0}, "
                                          "S.distance: {between: [0, 1], restitution: 1}}\n");
    CHECK_NEAR(model->stops[0].restitution, 0, 0);
    CHECK_NEAR(model->stops[1].restitution, 1, 0);
    yk_model_free(model);
}

static void refused(const char *section, int code, unsigned column, const char *part)
{
    char text[600];
    snprintf(text, sizeof text, MACHINE "%s\n", section);
    fixture_refused(text, code, 4, column, part);
}

static void mistakes_are_refused_at_their_place(void **state)
{
    (void)state;
    refused("stops: {psi: [0, 1]}", YK_CODE_UNKNOWN_COORDINATE, 9, "psi");
    refused("stops: {phi.rate: [0, 1]}", YK_CODE_RATE_NOT_HERE, 9, "phi.rate");
    refused("stops: {phi: [0]}", YK_CODE_COMPONENTS, 14, "two ends");
    refused("stops: {phi: 3}", YK_CODE_WRONG_KIND, 14, "stop of `phi`");
    refused("stops: {phi: {restitution: 1}}", YK_CODE_MISSING_KEY, 14, "`between`");
    refused("stops: {phi: {between: [0, 1], bounce: 1}}", YK_CODE_UNKNOWN_KEY, 32, "bounce");
    refused("stops: {phi: {between: 3}}", YK_CODE_WRONG_KIND, 24, "stop of `phi`");
    refused("stops: {phi: [0, 1], O.angle: [0, 1]}", YK_CODE_GIVEN_TWICE, 22, "`phi`");
    refused("stops: {phi: [0, 3 m]}", YK_CODE_WRONG_DIMENSION, 18, "stop of `phi`");
    refused("stops: {phi: [0, t]}", YK_CODE_NAME_NOT_HERE, 18, "time");
    refused("stops: {phi: {between: [0, 1], restitution: 0.5 m}}", YK_CODE_WRONG_DIMENSION, 45, "restitution of `phi`");
}

static void its_ends_stand_in_order_and_apart(void **state)
{
    (void)state;
    refused("stops: {phi: [2, 1]}", YK_CODE_BAD_STOP, 15, "from 2 to 1");
    refused("stops: {phi: [1, 1]}", YK_CODE_BAD_STOP, 15, "lowest");
    refused("stops: {S.distance: {between: [2 + 1, 1]}}", YK_CODE_BAD_STOP, 32, "S.distance");
    refused("stops: {phi: [1/0, 0]}", YK_CODE_EVALUATION, 15, "division"); // nothing is said of what has no value
}

static void restitution_beyond_its_range_is_refused(void **state)
{
    (void)state;
    refused("stops: {phi: {between: [0, 1], restitution: 1.01}}", YK_CODE_BAD_RESTITUTION, 45, "1.01");
    refused("stops: {phi: {between: [0, 1], restitution: -e}}", YK_CODE_BAD_RESTITUTION, 45, "-0.3");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_stop_is_a_range_with_or_without_restitution),
        cmocka_unit_test(restitution_goes_from_nothing_to_all),
        cmocka_unit_test(mistakes_are_refused_at_their_place),
        cmocka_unit_test(its_ends_stand_in_order_and_apart),
        cmocka_unit_test(restitution_beyond_its_range_is_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
