// Variants: bit for bit what the file gives with the same values, for every parameter of every example; lengths that
// are 0 in the file; what is refused.
#include "machine.h"
#include "base/units/units.h"
#include "compile/mechanism.h"

static bool same_bits(double a, double b)
{
    return memcmp(&a, &b, sizeof a) == 0 || (a == 0 && b == 0);
}

static Machine load_with(const char *file, const char *name, double value_in_file_units)
{
    char path[512], text[64];
    snprintf(path, sizeof path, "%s/examples/%s.yaml", YOKE_ROOT, file);
    snprintf(text, sizeof text, "%.17g", value_in_file_units);
    YkOverride override = {name, text};
    YkLoadOptions options = {&override, 1};
    Machine m = {.problems = yk_problems_new()};
    m.model = yk_model_load(path, &options, m.problems);
    if (!m.model) return m;
    m.mech = yk_mechanism_compile(m.model, NULL, m.problems);
    m.state = m.mech ? yk_state_new(m.mech) : NULL;
    return m;
}

// Both at the inputs and branches of the file's own state: every coordinate and every point, with rates.
static void compare(const Machine *own, YkState *variant, const Machine *fresh, const char *what)
{
    for (size_t b = 0; b < yk_block_count(own->mech); b++) {
        yk_state_set_branch(variant, b, yk_state_branch(own->state, b));
        yk_state_set_branch(fresh->state, b, yk_state_branch(own->state, b));
    }
    for (size_t i = 0; i < yk_input_count(own->mech); i++) {
        YkMotion in = yk_state_input(own->state, i);
        in.velocity += 0.7, in.acceleration -= 0.3;
        yk_state_set_input(variant, i, in);
        yk_state_set_input(fresh->state, i, in);
    }
    YkStatus a = yk_state_solve(variant), b = yk_state_solve(fresh->state);
    if (a != b) print_error("%s: status %d, compiled anew %d\n", what, a, b);
    assert_int_equal(a, b);
    if (a < 0) return;
    for (size_t c = 0; c < yk_coordinate_count(own->mech); c++) {
        YkMotion x = yk_state_coordinate(variant, c), y = yk_state_coordinate(fresh->state, c);
        if (!same_bits(x.position, y.position)) print_error("%s: %.17g, anew %.17g\n", what, x.position, y.position);
        assert_true(same_bits(x.position, y.position) && same_bits(x.velocity, y.velocity) &&
                    same_bits(x.acceleration, y.acceleration));
    }
    for (size_t p = 0; p < yk_model_point_count(own->model); p++) {
        YkPointMotion x = yk_state_point(variant, p), y = yk_state_point(fresh->state, p);
        for (int k = 0; k < 2; k++)
            assert_true(same_bits(x.position[k], y.position[k]) && same_bits(x.velocity[k], y.velocity[k]) &&
                        same_bits(x.acceleration[k], y.acceleration[k]));
    }
    YkResiduals r = yk_state_residuals(variant);
    assert_true(r.position <= 1e-11);
}

// One parameter a little off; false where it cannot vary.
static bool check_parameter(const Machine *own, const char *file, const YkParameter *parameter)
{
    char what[200];
    snprintf(what, sizeof what, "%s, %s", file, parameter->name);
    YkVariant *variant = yk_variant_new(own->mech, &parameter->name, 1, NULL);
    if (!variant) return false;
    double size = yk_units_size(&own->model->units, parameter->dimension);
    Machine fresh = load_with(file, parameter->name, parameter->value * 1.003 / size);
    if (fresh.state) {
        double value = yk_model_parameter(fresh.model, parameter->name);
        YkState *state = yk_state_new(yk_variant_mechanism(variant));
        assert_non_null(state);
        assert_int_equal(yk_variant_set(variant, &value), YK_OK);
        compare(own, state, &fresh, what);
        yk_state_free(state);
    }
    machine_free(&fresh);
    yk_variant_free(variant);
    return true;
}

static void test_a_variant_has_the_bits_of_the_file_with_that_value(void **unused)
{
    (void)unused;
    size_t checked = 0;
    for (size_t k = 0; k < EXAMPLE_COUNT; k++) {
        if (!strcmp(all_examples[k], "double-butterfly") || !strcmp(all_examples[k], "stephenson-awkward")) continue;
        Machine own = machine_load(all_examples[k]);
        for (size_t p = 0; p < own.model->parameter_count; p++)
            checked += check_parameter(&own, all_examples[k], &own.model->parameters[p]);
        machine_free(&own);
    }
    assert_true(checked > 60);
}

static const char *const OFFSET = "parameters: {r: 1, l: 3, e: 0, slope: 0}\n"
                                  "bodies:\n"
                                  "  ground: {points: {O: [0, 0], F: [0, e]}}\n"
                                  "  crank: {points: {O: [0, 0], A: [r, 0]}}\n"
                                  "  rod: {points: {A: [0, 0], B: [l, 0]}}\n"
                                  "  piston: {points: {B: [0, 0]}}\n"
                                  "joints:\n"
                                  "  O: {pin: [ground, crank], angle: theta}\n"
                                  "  A: {pin: [crank, rod], angle: phi}\n"
                                  "  B: {pin: [rod, piston]}\n"
                                  "  S: {slide: [ground, piston], from: F, to: B, along: slope, distance: s}\n"
                                  "drives: {theta: 1 rad + 1 rad/s * t}\n"
                                  "start: {phi: -1.3, s: 3.5}\n";

// The offset is 0 in the file, so its terms cancel there; s = r cos + sqrt(l^2 - (r sin - e)^2), and turned by the
// slope.
static void test_what_is_zero_in_the_file_can_vary(void **unused)
{
    (void)unused;
    Machine m = machine_parse(OFFSET, true);
    const char *names[] = {"e", "slope"};
    YkVariant *variant = yk_variant_new(m.mech, names, 2, m.problems);
    assert_non_null(variant);
    YkState *state = yk_state_new(yk_variant_mechanism(variant));
    uint64_t seed = 4;
    for (size_t b = 0; b < yk_block_count(m.mech); b++) yk_state_set_branch(state, b, yk_state_branch(m.state, b));
    for (int k = 0; k < 200; k++) {
        double value[2] = {k == 0 ? 0 : check_uniform(&seed, -0.8, 0.8), k == 0 ? 0 : check_uniform(&seed, -1, 1)};
        assert_int_equal(yk_variant_set(variant, value), YK_OK);
        assert_true(yk_state_solve(state) >= 0);
        YkVec u = yk_unit(value[1]), A = yk_sub(yk_unit(1), yk_vec(0, value[0]));
        double along = yk_dot(A, u), across = yk_cross(u, A);
        double s = yk_state_coordinate(state, yk_coordinate_find(m.mech, "s")).position;
        CHECK_NEAR(s, along + sqrt(9 - across * across), 1e-13);
    }
    yk_state_free(state);
    yk_variant_free(variant);
    machine_free(&m);
}

static void test_derived_parameters_follow(void **unused)
{
    (void)unused;
    Machine m = machine_parse("parameters: {half: 2*quarter, whole: 2*half, quarter: 0.25}\n"
                              "bodies:\n"
                              "  ground: {points: {O: [0, 0]}}\n"
                              "  arm: {points: {O: [0, 0], P: [whole + quarter, whole*sin(0.3*half/quarter)]}}\n"
                              "joints: {O: {pin: [ground, arm], angle: a}}\n"
                              "start: {a: 0}\n",
                              true);
    const char *name = "quarter";
    YkVariant *variant = yk_variant_new(m.mech, &name, 1, m.problems);
    YkState *state = yk_state_new(yk_variant_mechanism(variant));
    double value = 0.75;
    assert_int_equal(yk_variant_set(variant, &value), YK_OK);
    assert_int_equal(yk_state_solve(state), YK_OK);
    YkPointMotion p = yk_state_point(state, yk_model_find_point(m.model, "arm.P"));
    CHECK_NEAR(p.position[0], 3.75, 1e-15);
    CHECK_NEAR(p.position[1], 3 * sin(0.6), 1e-15);
    assert_true(yk_model_parameter(m.model, "half") == 0.5); // the file's model is as it was
    yk_state_free(state);
    yk_variant_free(variant);
    machine_free(&m);
}

static void test_values_that_make_no_machine_are_refused(void **unused)
{
    (void)unused;
    Machine m = machine_parse("parameters: {m: 1, l: 2}\n"
                              "bodies:\n"
                              "  ground: {points: {O: [0, 0]}}\n"
                              "  arm: {points: {O: [0, 0], P: [l, 0]}, mass: m, rod: [O, P]}\n"
                              "joints: {O: {pin: [ground, arm], angle: a}}\n",
                              true);
    const char *names[] = {"m", "l"};
    YkVariant *v = yk_variant_new(m.mech, names, 2, m.problems);
    assert_non_null(v);
    assert_int_equal(yk_variant_set(v, (double[]){2, 3}), YK_OK);
    const YkBody *arm = &yk_mechanism_model(yk_variant_mechanism(v))->bodies[1];
    CHECK_NEAR(arm->inertia, 2 * 9 / 12.0, 1e-15);
    CHECK_NEAR(arm->center.x, 1.5, 0);
    assert_int_equal(yk_variant_set(v, (double[]){0, 3}), YK_BAD_MODEL);
    assert_int_equal(yk_variant_set(v, (double[]){-1, 3}), YK_BAD_MODEL);
    assert_int_equal(yk_variant_set(v, (double[]){1, 0}), YK_BAD_MODEL);
    assert_int_equal(yk_variant_set(v, (double[]){1, NAN}), YK_BAD_MODEL);
    assert_int_equal(yk_variant_set(v, (double[]){1, 1e200}), YK_BAD_MODEL);
    assert_int_equal(yk_variant_set(v, (double[]){1, 1}), YK_OK);
    yk_variant_free(v);
    machine_free(&m);
}

static void check_all_refused(const char *text, const char *const *names, size_t count, int code)
{
    Machine m = machine_parse(text, false);
    assert_null(yk_variant_new(m.mech, names, count, m.problems));
    bool found = false;
    for (size_t k = 0; k < yk_problems_count(m.problems); k++) found |= yk_problems_get(m.problems, k)->code == code;
    if (!found) print_error("%s", yk_problems_text(m.problems, 0));
    assert_true(found);
    machine_free(&m);
}

static void check_refused(const char *text, const char *name, int code)
{
    check_all_refused(text, &name, 1, code);
}

static void test_what_cannot_follow_is_refused_with_its_place(void **unused)
{
    (void)unused;
    const char *text = "parameters: {tilt: 0.1, l: 1}\n"
                       "bodies: {ground: {points: {O: [0, 0]}}, a: {points: {O: [0, 0]}}, b: {points: {S: [0, 0]}}}\n"
                       "joints:\n"
                       "  O: {pin: [ground, a], angle: q}\n"
                       "  S: {slide: [a, b], along: x, turned: tilt, distance: d}\n";
    check_refused(text, "tilt", 508);
    check_refused(text, "no_such", 412);
    // the meshing of gears depends on `start:`; a drive's speed does not
    text = "parameters: {tilt: 0.1, speed: 2}\n"
           "bodies: {ground: {points: {A: [0, 0], B: [3, 0]}}, a: {points: {A: [0, 0]}}, b: {points: {B: [0, 0]}}}\n"
           "joints: {A: {pin: [ground, a], angle: p}, B: {pin: [ground, b], angle: q}}\n"
           "gears: {g: {mesh: [a, b], teeth: [10, 20]}}\n"
           "drives: {p: 0.2 rad + speed * 1 rad/s * t}\n"
           "start: {q: tilt}\n";
    check_refused(text, "tilt", 508);
    const char *speed = "speed";
    Machine m = machine_parse(text, false);
    YkVariant *variant = yk_variant_new(m.mech, &speed, 1, m.problems);
    assert_non_null(variant);
    yk_variant_free(variant);
    machine_free(&m);
}

// A restitution is not more than 1, a friction not less than 0: values beside these are on one side only.
static void test_values_at_a_limit_are_as_good_as_others(void **unused)
{
    (void)unused;
    const char *text = "parameters: {tilt: 0.1, e: 1, mu: 0}\n"
                       "bodies: {ground: {points: {A: [0, 0], B: [3, 0]}}, a: {points: {A: [0, 0]}}, b: {points: {B: "
                       "[0, 0]}}}\n"
                       "joints:\n"
                       "  A: {pin: [ground, a], angle: p, friction: {viscous: mu * 1 N*m*s}}\n"
                       "  B: {pin: [ground, b], angle: q}\n"
                       "gears: {g: {mesh: [a, b], teeth: [10, 20]}}\n"
                       "stops: {p: {between: [-1, 1], restitution: e}}\n"
                       "start: {p: 0.2, q: tilt}\n";
    const char *const all[] = {"e", "mu", "tilt"};
    check_all_refused(text, all, 3, 508); // where the gears mesh is asked for all the same
    Machine m = machine_parse(text, false);
    YkProblems *problems = yk_problems_new();
    YkVariant *variant = yk_variant_new(m.mech, all, 2, problems);
    assert_non_null(variant);
    assert_int_equal(yk_problems_count(problems), 0);
    yk_variant_free(variant);
    yk_problems_free(problems);
    machine_free(&m);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_a_variant_has_the_bits_of_the_file_with_that_value),
        cmocka_unit_test(test_what_is_zero_in_the_file_can_vary),
        cmocka_unit_test(test_derived_parameters_follow),
        cmocka_unit_test(test_values_that_make_no_machine_are_refused),
        cmocka_unit_test(test_what_cannot_follow_is_refused_with_its_place),
        cmocka_unit_test(test_values_at_a_limit_are_as_good_as_others),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
