// Forces and moments on bodies.
#include "model/fixture.h"

#define MACHINE                                                                                                        \
    "parameters: {F: 100, L: 2}\n"                                                                                     \
    "bodies: {ground: {points: {P: [0, 0]}}, ram: {points: {C: [L/4, -L]}}}\n"                                         \
    "joints: {O: {pin: [ground, ram], angle: phi}}\n"
FIXTURE_BY_NAME(YkForce, fixture_force, forces, force_count)

static void a_force_acts_at_a_point_in_world_or_body_axes(void **state)
{
    (void)state;
    YkModel *model = fixture_load(MACHINE "forces: {F1: {body: ram, at: C, value: [-F, 0]}, "
                                          "F2: {body: ram, value: [0, F*sin(phi)], axes: body}, "
                                          "F3: {body: ground, value: [1, 2], axes: world}}\n");
    assert_int_equal(model->force_count, 3);
    const YkForce *first = fixture_force(model, "F1"), *second = fixture_force(model, "F2");
    assert_int_equal(first->body, 1);
    assert_int_equal(first->point, yk_model_find_point(model, "ram.C"));
    CHECK_NEAR(first->at.x, 0.5, 0); // the point's place is an expression
    CHECK_NEAR(first->at.y, -2, 0);
    assert_false(first->in_body_axes);
    YkJet jet;
    assert_int_equal(yk_model_eval(model, first->x.expr, 0, &jet, NULL), YK_OK);
    CHECK_NEAR(jet.d[0], -100, 0);
    assert_null(first->moment.expr);
    assert_int_equal(second->point, YK_NONE);
    CHECK_NEAR(second->at.x, 0, 0);
    assert_true(second->in_body_axes);
    assert_true(yk_expr_mentions(second->y.expr, "phi"));
    assert_int_equal(fixture_force(model, "F3")->body, 0);
    yk_model_free(model);
}

static void values_come_in_the_units_of_the_file(void **state)
{
    (void)state;
    YkModel *model =
        fixture_load("units: {length: mm, force: kN}\n" MACHINE
                     "forces: {F1: {body: ram, value: [3, F], moment: 5}, F2: {body: ram, moment: 2 N*m}}\n");
    const YkForce *force = fixture_force(model, "F1");
    const YkExpr *exprs[] = {force->x.expr, force->y.expr, force->moment.expr, fixture_force(model, "F2")->moment.expr};
    const double wanted[] = {3000, 100e3, 5, 2}; // a bare moment is in kN*mm
    for (int k = 0; k < 4; k++) {
        YkJet jet;
        assert_int_equal(yk_model_eval(model, exprs[k], 0, &jet, NULL), YK_OK);
        CHECK_NEAR(jet.d[0], wanted[k], 1e-12 * wanted[k]);
    }
    yk_model_free(model);
}

static void a_moment_may_stand_without_a_force(void **state)
{
    (void)state;
    YkModel *model = fixture_load(MACHINE "forces: {M: {body: ram, moment: -3 N*m*s * phi.rate}}\n");
    const YkForce *force = fixture_force(model, "M");
    assert_null(force->x.expr);
    assert_null(force->y.expr);
    assert_true(yk_expr_mentions(force->moment.expr, "phi.rate"));
    yk_model_free(model);
}

static void forces_may_mention_time_coordinates_and_rates(void **state)
{
    (void)state;
    YkModel *model =
        fixture_load("bodies: {a: {}, b: {}}\njoints: {S: {slide: [ground, a]}, P: {pin: [a, b]}}\n"
                     "forces: {F: {body: b, value: [F0*t/T, -2 N/m * S.distance - 1 N*s * P.angle.rate]}}\n"
                     "parameters: {F0: 3 N, T: 2 s}\n");
    assert_int_equal(model->coordinate_count, 2); // spoken of, so declared
    assert_int_equal(model->joints[0].distance, 0);
    assert_int_equal(model->joints[1].angle, 1);
    yk_model_free(model);
}

static void a_section_without_forces_is_none(void **state)
{
    (void)state;
    const char *texts[] = {MACHINE "forces: {}\n", MACHINE "forces:\n", MACHINE};
    for (size_t i = 0; i < 3; i++) {
        YkModel *model = fixture_load(texts[i]);
        assert_int_equal(model->force_count, 0);
        yk_model_free(model);
    }
}

static void refused(const char *section, int code, unsigned column, const char *part)
{
    char text[600];
    snprintf(text, sizeof text, MACHINE "%s\n", section);
    fixture_refused(text, code, 4, column, part);
}

static void on_is_the_older_spelling_of_body(void **state)
{
    (void)state;
    YkModel *model =
        fixture_load(MACHINE "forces: {F1: {on: ram, at: C, value: [1, 0]}, F2: {body: ram, at: C, value: [1, 0]}}\n");
    assert_int_equal(model->forces[0].body, model->forces[1].body);
    assert_int_equal(model->forces[0].point, model->forces[1].point);
    assert_string_equal(model->bodies[model->forces[0].body].name, "ram");
    yk_model_free(model);
}

static void mistakes_are_refused_at_their_place(void **state)
{
    (void)state;
    refused("forces: {F1: {body: rom, value: [0, 0]}}", YK_CODE_UNKNOWN_BODY, 21, "did you mean `ram`");
    refused("forces: {F1: {body: ram, at: D, value: [0, 0]}}", YK_CODE_UNKNOWN_POINT, 30, "`D`");
    refused("forces: {F1: {body: ram}}", YK_CODE_MISSING_KEY, 14, "force `F1` needs `value`");
    refused("forces: {F1: {value: [0, 0]}}", YK_CODE_MISSING_KEY, 14, "`body`");
    refused("forces: {F1: {body: ram, on: ram, value: [0, 0]}}", YK_CODE_RIVAL_KEYS, 26, "`on`");
    refused("forces: {F1: {body: ram, value: [0, 0, 0]}}", YK_CODE_COMPONENTS, 33, "F1");
    refused("forces: {F1: {body: ram, value: [0, z]}}", YK_CODE_UNKNOWN_NAME, 37, "`z`");
    refused("forces: {F1: {body: ram, value: [0, 0], axes: local}}", YK_CODE_WRONG_WORD, 47, "local");
    refused("forces: {F1: {body: ram, value: [0, 0], axis: body}}", YK_CODE_UNKNOWN_KEY, 41, "axes");
    refused("forces: {F1: 3}", YK_CODE_WRONG_KIND, 14, "force `F1`");
    refused("forces: {F1: {body: ram, value: 3}}", YK_CODE_WRONG_KIND, 33, "force `F1`");
    refused("forces: {F1: {body: ram, moment: }}", YK_CODE_EMPTY_VALUE, 34, "moment of `F1`");
    refused("forces: {1F: {body: ram, moment: 3}}", YK_CODE_BAD_NAME, 10, "1F");
    refused("forces: {F1: {body: ram, moment: 3}, F1: {body: ram, moment: 3}}", YK_CODE_YAML_DUPLICATE_KEY, 38, "F1");
    refused("forces: [F1]", YK_CODE_WRONG_KIND, 9, "forces");
}

static void forces_and_moments_have_their_dimensions(void **state)
{
    (void)state;
    refused("forces: {F1: {body: ram, value: [0, 3 m]}}", YK_CODE_WRONG_DIMENSION, 37, "y of force `F1`");
    refused("forces: {F1: {body: ram, value: [3 N*m, 0]}}", YK_CODE_WRONG_DIMENSION, 34, "x of force `F1`");
    refused("forces: {F1: {body: ram, moment: 3 N}}", YK_CODE_WRONG_DIMENSION, 34, "moment of `F1`");
    refused("forces: {F1: {body: ram, moment: F, value: [F, 0]}}", YK_CODE_TWO_DIMENSIONS, 34, "`F`");
}

static void laws_give_components_and_moments(void **state)
{
    (void)state;
    YkModel *model = fixture_load("bodies: {ram: {}}\njoints: {O: {pin: [ground, ram], angle: phi}}\n"
                                  "laws: {push: {table: [[0, 1], [1, 5]]}, turn: {table: [[0, 2], [3, 4]]}}\n"
                                  "forces: {F: {body: ram, value: [{law: push, of: t}, 3 N * sin(phi)], "
                                  "moment: {law: turn, of: phi}}}\n");
    const YkForce *force = fixture_force(model, "F");
    assert_string_equal(model->laws[force->x.law].name, "push");
    assert_string_equal(model->laws[force->moment.law].name, "turn");
    assert_int_equal(force->y.law, YK_NONE);
    assert_string_equal(yk_dimension_name(model->laws[0].of), "a time");
    assert_string_equal(yk_dimension_name(model->laws[0].value), "a force");
    assert_string_equal(yk_dimension_name(model->laws[1].value), "a torque or energy");
    yk_model_free(model);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(laws_give_components_and_moments),
        cmocka_unit_test(a_force_acts_at_a_point_in_world_or_body_axes),
        cmocka_unit_test(values_come_in_the_units_of_the_file),
        cmocka_unit_test(a_moment_may_stand_without_a_force),
        cmocka_unit_test(forces_may_mention_time_coordinates_and_rates),
        cmocka_unit_test(a_section_without_forces_is_none),
        cmocka_unit_test(on_is_the_older_spelling_of_body),
        cmocka_unit_test(mistakes_are_refused_at_their_place),
        cmocka_unit_test(forces_and_moments_have_their_dimensions),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
