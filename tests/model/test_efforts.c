// Efforts along coordinates, as expressions and as laws.
#include "model/fixture.h"

#define MACHINE                                                                                                        \
    "parameters: {w: 2 rad/s}\n"                                                                                       \
    "bodies: {a: {}, b: {}}\n"                                                                                         \
    "joints: {O: {pin: [ground, a], angle: phi}, S: {pin-slot: [a, b], along: x}, J-2: {slide: [ground, b]}}\n"
#define LAWS                                                                                                           \
    "laws: {work: {table: [[0 m, 40 N], [1 m, 10 N]]}, brake: {table: [[0 rad, 4 N*m], [6 rad, 1 N*m]]}, "             \
    "plain: {table: [[0, 1], [2, 3]]}, lift: {table: [[0 rad, 0 m], [6 rad, 1 m]]}}\n"

static void efforts_may_mention_time_coordinates_and_rates(void **state)
{
    (void)state;
    YkModel *model = fixture_load(MACHINE "efforts: {phi: -2 N*m/rad * phi - 3 N*m*s * phi.rate + 1 N*m * sin(w*t),"
                                          " S.distance: -5 N/m * S.distance - 4 N*s * O.angle.rate}\n");
    assert_int_equal(model->effort_count, 2);
    assert_true(yk_expr_mentions(model->efforts[0].strength.expr, "phi.rate"));
    assert_int_equal(model->efforts[0].strength.law, YK_NONE);

    assert_int_equal(model->coordinate_count, 2);
    yk_model_free(model);
}

static void a_law_of_an_expression_gives_an_effort(void **state)
{
    (void)state;
    YkModel *model = fixture_load(
        MACHINE LAWS "efforts: {S.distance: {law: work, of: 2*S.distance - 0.1}, phi: {law: brake, of: phi}, "
                     "J-2.distance: {law: plain, of: t}}\n");
    assert_int_equal(model->effort_count, 3);
    const YkEffort *effort = model->efforts;

    assert_string_equal(model->laws[effort->strength.law].name, "work");
    assert_true(yk_expr_mentions(effort->strength.expr, "S.distance"));
    assert_string_equal(model->laws[model->efforts[1].strength.law].name, "brake");
    assert_int_equal(model->efforts[2].strength.law, 2);
    yk_model_free(model);
}

static void refused(const char *section, int code, unsigned column, const char *part)
{
    char text[1000];
    snprintf(text, sizeof text, MACHINE LAWS "%s\n", section);
    fixture_refused(text, code, 5, column, part);
}

static void mistakes_are_refused_at_their_place(void **state)
{
    (void)state;
    refused("efforts: {ph: 3}", YK_CODE_UNKNOWN_COORDINATE, 11, "did you mean `phi`");
    refused("efforts: {phi.rate: 3}", YK_CODE_RATE_NOT_HERE, 11, NULL);
    refused("efforts: {phi: 3, O.angle: 3}", YK_CODE_GIVEN_TWICE, 19, "`phi`");
    refused("efforts: {phi: 3 N}", YK_CODE_WRONG_DIMENSION, 16, "effort of `phi`");
    refused("efforts: {phi: [1, 2]}", YK_CODE_WRONG_KIND, 16, "effort of `phi`");
    refused("efforts: {phi: }", YK_CODE_EMPTY_VALUE, 16, "effort of `phi`");
}

static void mistakes_in_the_use_of_a_law_are_refused(void **state)
{
    (void)state;
    refused("efforts: {phi: {law: brak, of: phi}}", YK_CODE_UNKNOWN_LAW, 22, "did you mean `brake`");
    refused("efforts: {phi: {law: brake}}", YK_CODE_MISSING_KEY, 16, "`of`");
    refused("efforts: {phi: {of: phi}}", YK_CODE_MISSING_KEY, 16, "`law`");
    refused("efforts: {phi: {law: brake, of: phi, at: 3}}", YK_CODE_UNKNOWN_KEY, 38, "`at`");
    refused("efforts: {phi: {law: brake, of: psi}}", YK_CODE_UNKNOWN_NAME, 33, "`psi`");
    refused("efforts: {phi: {law: [brake], of: phi}}", YK_CODE_WRONG_KIND, 22, NULL);
}

static void a_law_of_other_quantities_is_refused(void **state)
{
    (void)state;
    refused("efforts: {phi: {law: lift, of: phi}}", YK_CODE_WRONG_DIMENSION, 22, "must be a torque");
    refused("efforts: {S.distance: {law: brake, of: phi}}", YK_CODE_WRONG_DIMENSION, 29, "must be a force");
    refused("efforts: {phi: {law: brake, of: S.distance}}", YK_CODE_WRONG_DIMENSION, 33, "argument of the law");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(efforts_may_mention_time_coordinates_and_rates),
        cmocka_unit_test(a_law_of_an_expression_gives_an_effort),
        cmocka_unit_test(mistakes_are_refused_at_their_place),
        cmocka_unit_test(mistakes_in_the_use_of_a_law_are_refused),
        cmocka_unit_test(a_law_of_other_quantities_is_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
