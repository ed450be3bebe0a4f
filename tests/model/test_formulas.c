// Expressions of a model as formulas: what their names stand for.
#include "model/fixture.h"
#include "model/formulas.h"

#define MACHINE                                                                                                        \
    "parameters: {w: 2 rad/s, k: 3, L: 2 m + 1 m}\n"                                                                   \
    "bodies: {a: {}, b: {}}\n"                                                                                         \
    "joints: {O-1: {pin: [ground, a], angle: phi}, S: {pin-slot: [a, b], along: x, distance: s}}\n"

// Variable 1 + 2 * coordinate is the coordinate, the next its rate; `hidden` has none.
typedef struct Numbering {
    int32_t hidden;
    int calls;
} Numbering;

static int number(void *context, int32_t coordinate, bool is_rate)
{
    Numbering *numbering = context;
    numbering->calls++;
    return coordinate == numbering->hidden ? -2 : 1 + 2 * coordinate + is_rate;
}

static YkFormula *formula_of_effort(const char *effort, YkModel **model, Numbering *numbering)
{
    char text[900];
    snprintf(text, sizeof text, MACHINE "efforts: {phi: \"%s\"}\n", effort);
    *model = fixture_load(text);
    return yk_model_formula(*model, (*model)->efforts[0].strength.expr, number, numbering, (*model)->arena);
}

// t, then phi, s and S.angle with their rates.
static const double variables[] = {0.7, 0.3, -1.1, 0.25, 4, 1.9, -0.6};

static void check(const char *effort, double wanted)
{
    YkModel *model;
    Numbering numbering = {.hidden = YK_NONE};
    const YkFormula *formula = formula_of_effort(effort, &model, &numbering);
    assert_non_null(formula);
    CHECK_NEAR(yk_formula_eval(formula, variables), wanted, 1e-14 * (1 + fabs(wanted)));
    yk_model_free(model);
}

static void names_stand_for_time_parameters_coordinates_and_rates(void **state)
{
    (void)state;
    check("k*sin(w*t)", 3 * sin(1.4));
    check("phi * 1 N*m/rad", 0.3);
    check("phi.rate * 1 N*m*s", -1.1);
    check("2 N * s", 0.5);
    check("L * 1 N + s.rate * 1 N*s", 3 + 4);
    check("cos(pi*s/L) * k", 3 * cos(YK_PI * 0.25 / 3));
    check("-5 + 3 N*m/deg * 2 deg", 1);
}

static void coordinates_may_be_spoken_of_by_their_joint(void **state)
{
    (void)state;
    check("2 N*m/rad * S.angle - 1 N*m*s * S.angle.rate", 2 * 1.9 + 0.6); // declared by its mention, without a name
    check("2 N * S.distance", 0.5);                                       // is s
    check("1 N*s * S.distance.rate", 4);
}

static void constants_need_no_variables(void **state)
{
    (void)state;
    YkModel *model = fixture_load(MACHINE "efforts: {phi: 2*k*pi}\nstart: {s: L/2}\n");
    const YkFormula *formula = yk_model_formula(model, model->efforts[0].strength.expr, NULL, NULL, model->arena);
    assert_true(yk_formula_is_constant(formula));
    CHECK_NEAR(yk_formula_eval(formula, NULL), 6 * YK_PI, 1e-14);
    formula = yk_model_formula(model, model->starts[0].expr, NULL, NULL, model->arena);
    CHECK_NEAR(yk_formula_eval(formula, NULL), model->starts[0].value, 0);
    yk_model_free(model);
}

static void a_coordinate_without_variable_gives_no_formula(void **state)
{
    (void)state;
    YkModel *model;
    Numbering numbering = {.hidden = 1};
    assert_null(formula_of_effort("2 N * s", &model, &numbering));
    assert_null(yk_model_formula(model, model->efforts[0].strength.expr, NULL, NULL, model->arena));
    yk_model_free(model);
}

// Names that no loaded file holds.
static void strange_names_give_no_formula(void **state)
{
    (void)state;
    static char lengthy[400];
    memset(lengthy, 'x', sizeof lengthy - 1);
    const char *names[] = {"", "q", "phi.accel", ".rate", ".angle", "phi.angle", "O-1.distance", "Q.angle", lengthy};
    YkModel *model = fixture_load(MACHINE);
    Numbering numbering = {.hidden = YK_NONE};
    for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
        YkExpr expr = {.kind = YK_EXPR_NAME, .name = names[i]};
        assert_null(yk_model_formula(model, &expr, number, &numbering, model->arena));
    }
    YkExpr joint = {.kind = YK_EXPR_NAME, .name = "O-1.angle.rate"};
    assert_non_null(yk_model_formula(model, &joint, number, &numbering, model->arena));
    yk_model_free(model);
}

// The evaluator of trees, on expressions of time.
static void formulas_of_time_agree_with_the_model(void **state)
{
    (void)state;
    YkModel *model =
        fixture_load(MACHINE "drives: {phi: \"30 deg + w*t + sin(k*w*t)^2/k - min(w*t, 1)\", s: L*exp(-t/3 s)}\n");
    for (size_t i = 0; i < 2; i++) {
        const YkExpr *expr = model->drives[i].expr;
        const YkFormula *formula = yk_model_formula(model, expr, NULL, NULL, model->arena);
        assert_non_null(formula);
        for (double t = 0; t < 3; t += 0.0137) {
            YkJet jet;
            assert_int_equal(yk_model_eval(model, expr, t, &jet, NULL), YK_OK);
            CHECK_NEAR(yk_formula_eval(formula, &t), jet.d[0], 0);
        }
    }
    yk_model_free(model);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(names_stand_for_time_parameters_coordinates_and_rates),
        cmocka_unit_test(coordinates_may_be_spoken_of_by_their_joint),
        cmocka_unit_test(constants_need_no_variables),
        cmocka_unit_test(a_coordinate_without_variable_gives_no_formula),
        cmocka_unit_test(strange_names_give_no_formula),
        cmocka_unit_test(formulas_of_time_agree_with_the_model),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
