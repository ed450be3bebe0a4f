// Friction of joints.
#include "model/fixture.h"

#define MACHINE                                                                                                        \
    "parameters: {mu: 0.1, r: 8 mm}\n"                                                                                 \
    "bodies: {a: {}, b: {}, c: {}, d: {}}\n"                                                                           \
    "joints:\n"

static void each_joint_that_moves_may_rub(void **state)
{
    (void)state;
    YkModel *model =
        fixture_load(MACHINE "  O: {pin: [ground, a], friction: {coulomb: mu, radius: r/2, viscous: 3 N*m*s/rad}}\n"
                             "  S: {slide: [a, b], friction: {coulomb: 2*mu, viscous: 2 N*s/m}}\n"
                             "  T: {pin-slot: [b, c], friction: {viscous: 1 N*s/m}}\n"
                             "  W: {pin: [c, d], friction: {viscous: 0.5 N*m*s}}\n"
                             "  Q: {pin: [ground, d]}\n");
    const YkJoint *pin = fixture_joint(model, "O"), *slide = fixture_joint(model, "S");
    assert_true(pin->has_friction);
    CHECK_NEAR(pin->friction.coulomb, 0.1, 0);
    CHECK_NEAR(pin->friction.radius, 0.004, 1e-18);
    CHECK_NEAR(pin->friction.viscous, 3, 0);
    assert_int_equal(pin->friction.place.line, 4);
    CHECK_NEAR(slide->friction.coulomb, 0.2, 0);
    CHECK_NEAR(slide->friction.radius, 0, 0);
    assert_null(slide->friction.radius_expr);
    CHECK_NEAR(slide->friction.viscous, 2, 0);
    CHECK_NEAR(fixture_joint(model, "T")->friction.viscous, 1, 0); // it slides: a force
    CHECK_NEAR(fixture_joint(model, "W")->friction.viscous, 0.5, 0);
    assert_false(fixture_joint(model, "Q")->has_friction);
    yk_model_free(model);
}

static void bare_values_are_in_the_units_of_the_file(void **state)
{
    (void)state;
    YkModel *model = fixture_load("units: {length: mm, angle: deg, force: N}\n" MACHINE
                                  "  O: {pin: [ground, a], friction: {coulomb: 10 %, radius: 8, viscous: 2}}\n"
                                  "  S: {slide: [a, b], friction: {viscous: 2}}\n"
                                  "  T: {slide: [b, c]}\n  V: {slide: [c, d]}\n");
    const YkFriction *pin = &fixture_joint(model, "O")->friction;
    CHECK_NEAR(pin->coulomb, 0.1, 1e-17);
    CHECK_NEAR(pin->radius, 0.008, 1e-17);
    CHECK_NEAR(pin->viscous, 2 * 1e-3 * 180 / YK_PI, 1e-15); // N mm at a degree a second
    CHECK_NEAR(fixture_joint(model, "S")->friction.viscous, 2000, 1e-12);
    yk_model_free(model);
}

static void refused(const char *joint, int code, unsigned column, const char *part)
{
    char text[600];
    snprintf(text, sizeof text, MACHINE "  A: {%s}\n  B: {pin: [a, b]}\n  C: {pin: [b, c]}\n  D: {pin: [c, d]}\n",
             joint);
    fixture_refused(text, code, 4, column, part);
}

static void dry_friction_in_a_pin_needs_a_radius(void **state)
{
    (void)state;
    refused("pin: [ground, a], friction: {coulomb: mu}", YK_CODE_MISSING_KEY, 35, "radius");
    refused("pin: [ground, a], friction: {coulomb: mu, radius: 0}", YK_CODE_BAD_FRICTION, 57, "must be positive");
    refused("pin: [ground, a], friction: {radius: r - 2*r}", YK_CODE_BAD_FRICTION, 44, "-0.008");
}

static void only_a_pin_has_a_radius(void **state)
{
    (void)state;
    refused("slide: [ground, a], friction: {coulomb: mu, radius: r}", YK_CODE_UNKNOWN_KEY, 51, "in a slide");
    refused("pin-slot: [ground, a], friction: {coulomb: mu, radius: r}", YK_CODE_UNKNOWN_KEY, 54, "in a pin-slot");
}

static void a_weld_does_not_rub(void **state)
{
    (void)state;
    refused("weld: [ground, a], friction: {viscous: 3}", YK_CODE_UNKNOWN_KEY, 26, "friction");
}

static void negative_friction_is_refused(void **state)
{
    (void)state;
    refused("slide: [ground, a], friction: {coulomb: -mu}", YK_CODE_BAD_FRICTION, 47, "-0.1");
    refused("slide: [ground, a], friction: {viscous: -2}", YK_CODE_BAD_DAMPING, 47, "-2");
}

static void what_is_refused_is_told_in_the_units_of_the_file(void **state)
{
    (void)state;
    static const char units[] = "units: {length: mm, angle: deg, force: N}\n" MACHINE;
    static const struct {
        const char *joint, *told;
        int code;
    } bad[] = {{"O: {pin: [ground, a], friction: {coulomb: mu, radius: -3}}", "-3 mm;", YK_CODE_BAD_FRICTION},
               {"O: {pin: [ground, a], friction: {viscous: -2}}", "-2 N*mm*s/deg;", YK_CODE_BAD_DAMPING},
               {"O: {slide: [ground, a], friction: {viscous: -2}}", "-2 N*s/mm;", YK_CODE_BAD_DAMPING}};
    for (size_t k = 0; k < sizeof bad / sizeof *bad; k++) {
        char text[600];
        snprintf(text, sizeof text, "%s  %s\n  B: {pin: [a, b]}\n  C: {pin: [b, c]}\n  D: {pin: [c, d]}\n", units,
                 bad[k].joint);
        YkProblems *problems = fixture_refuse(text);
        const YkProblem *problem = fixture_problem(problems, bad[k].code);
        assert_non_null(problem);
        assert_non_null(strstr(problem->message, bad[k].told));
        yk_problems_free(problems);
    }
}

static void its_values_are_constants_of_their_dimension(void **state)
{
    (void)state;
    refused("slide: [ground, a], friction: {viscous: 3 N*m*s}", YK_CODE_WRONG_DIMENSION, 47, "viscous of `A`");
    refused("pin: [ground, a], friction: {viscous: 3 N*s/m}", YK_CODE_WRONG_DIMENSION, 45, "viscous of `A`");
    refused("pin: [ground, a], friction: {coulomb: 3 N, radius: r}", YK_CODE_WRONG_DIMENSION, 45, "coulomb of `A`");
    refused("slide: [ground, a], friction: {coulomb: mu*t}", YK_CODE_NAME_NOT_HERE, 50, "time");
    refused("slide: [ground, a], friction: {coulom: mu}", YK_CODE_UNKNOWN_KEY, 38, "did you mean `coulomb`");
    refused("slide: [ground, a], friction: 0.1", YK_CODE_WRONG_KIND, 37, "friction of `A`");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(each_joint_that_moves_may_rub),
        cmocka_unit_test(bare_values_are_in_the_units_of_the_file),
        cmocka_unit_test(dry_friction_in_a_pin_needs_a_radius),
        cmocka_unit_test(only_a_pin_has_a_radius),
        cmocka_unit_test(a_weld_does_not_rub),
        cmocka_unit_test(negative_friction_is_refused),
        cmocka_unit_test(what_is_refused_is_told_in_the_units_of_the_file),
        cmocka_unit_test(its_values_are_constants_of_their_dimension),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
