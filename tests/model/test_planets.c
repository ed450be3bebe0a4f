// Which planets share a load: what each reason against it says, and that the set then counts one.
#include <math.h>
#include "fixture.h"

// A set whose planet P on the arm has room for more keys.
#define SET(PLANET, PIN, MORE_BODIES, MORE_JOINTS, GEARS, REST)                                                        \
    "gravity: [0, -9.81]\nbodies:\n  ground: {points: {G: [0, 0], F: [1, 0]}}\n  sun: {points: {G: [0, 0]}}\n"         \
    "  planet: {mass: 0.2, points: {E: [0.004, 0]}" PLANET "}\n  ring: {points: {G: [0, 0]}}\n"                        \
    "  arm: {points: {G: [0, 0], P: [0.03, 0], Q: [-0.03, 0]}}\n" MORE_BODIES                                          \
    "joints:\n  S: {pin: [ground, sun], at: G, angle: s}\n  C: {pin: [ground, arm], at: G, angle: c}\n"                \
    "  R: {weld: [ground, ring], at: G}\n  P: {pin: [arm, planet], angle: p" PIN "}\n" MORE_JOINTS                     \
    "gears:\n  inner: {mesh: [sun, planet], teeth: [20, 10], carrier: arm, planets: 3}\n"                              \
    "  outer: {mesh: [planet, ring], teeth: [10, 40], internal: true, carrier: arm}\n" GEARS REST

static YkModel *model_of(const char *text, YkProblems *problems)
{
    YkModel *model = yk_model_parse(text, strlen(text), "test.yaml", NULL, problems);
    for (size_t k = 0; !model && k < yk_problems_count(problems); k++)
        print_error("%s\n", yk_problems_get(problems, k)->message);
    assert_non_null(model);
    return model;
}

static void planets_share_a_load(void **state)
{
    (void)state;
    YkProblems *problems = yk_problems_new();
    YkModel *model =
        model_of(SET(", inertia: 1e-5", ", friction: {viscous: 2}", "", "", "", "efforts: {s: 1}\n"), problems);
    assert_int_equal(yk_problems_count(problems), 0);
    const YkBody *planet = &model->bodies[yk_model_find_body(model, "planet")],
                 *others = &model->bodies[yk_model_find_body(model, "planet_others")];
    assert_int_equal(model->gears[0].copies, 3);
    assert_int_equal(model->gears[0].planet, 1);
    assert_int_equal(model->gears[1].copies, 3); // one number is enough
    assert_int_equal(model->gears[1].planet, 0);
    CHECK_NEAR(planet->mass, 0.2, 0);
    CHECK_NEAR(planet->inertia, 3e-5, 1e-20);
    CHECK_NEAR(fixture_joint(model, "P")->friction.viscous, 6, 0);
    // All masses about the axis: 3 * 0.2 * 0.03^2, and their centre lies on it.
    double from_axis = 0.03 + others->center.x;
    CHECK_NEAR(0.2 * 0.03 + others->mass * from_axis, 0, 1e-17);
    CHECK_NEAR(0.2 * 9e-4 + others->inertia + others->mass * from_axis * from_axis, 0.6 * 9e-4, 1e-17);
    yk_model_free(model);
    yk_problems_free(problems);
}

static void two_planets_leave_one_mass_across_the_axis(void **state)
{
    (void)state;
    YkProblems *problems = yk_problems_new();
    YkModel *model = model_of("bodies: {sun: {}, planet: {mass: 0.2}, arm: {points: {P: [0.03, 0]}}}\n"
                              "joints: {S: {pin: [ground, sun], angle: s}, C: {pin: [ground, arm], angle: c}, "
                              "P: {pin: [arm, planet]}}\n"
                              "gears: {g: {mesh: [planet, sun], teeth: [10, 20], planets: 2}}\n",
                              problems);
    const YkBody *other = &model->bodies[yk_model_find_body(model, "planet_others")];
    CHECK_NEAR(other->center.x, -0.06, 1e-17);
    CHECK_NEAR(other->mass, 0.2, 0);
    CHECK_NEAR(other->inertia, 0, 0);
    yk_model_free(model);
    yk_problems_free(problems);
}

// A set that says it has one planet is as if it said nothing.
static void one_planet_changes_nothing(void **state)
{
    (void)state;
    static const char *const numbers[] = {", planets: 1", ""};
    for (int k = 0; k < 2; k++) {
        char text[1000];
        YkProblems *problems = yk_problems_new();
        snprintf(text, sizeof text,
                 "bodies: {sun: {}, planet: {mass: 0.2, inertia: 1e-5}, ring: {}, arm: {points: {P: [0.03, 0]}}}\n"
                 "joints: {S: {pin: [ground, sun], angle: s}, C: {pin: [ground, arm], angle: c}, "
                 "P: {pin: [arm, planet]}, R: {pin: [ground, ring]}}\n"
                 "gears: {g: {mesh: [planet, sun], teeth: [10, 20]%s}, h: {mesh: [planet, ring], teeth: [10, 40], "
                 "internal: true%s}}\n",
                 numbers[k], numbers[k]);
        YkModel *model = model_of(text, problems);
        assert_int_equal(yk_problems_count(problems), 0);
        assert_true(model->gears[0].copies <= 1 && model->gears[1].copies <= 1);
        const YkBody *planet = &model->bodies[yk_model_find_body(model, "planet")];
        CHECK_NEAR(planet->mass, 0.2, 0);
        CHECK_NEAR(planet->inertia, 1e-5, 0);
        yk_model_free(model);
        yk_problems_free(problems);
    }
}

static void what_keeps_planets_from_sharing_is_told(void **state)
{
    (void)state;
    static const struct {
        const char *text, *why;
    } cases[] = {
        {SET(", center: [1e-3, 0]", "", "", "", "", ""), "centre of mass of `planet`"},
        {SET("", ", friction: {coulomb: 0.1, radius: 2 mm}", "", "", "", ""), "dry friction"},
        {SET("", "", "", "", "", "forces: {f: {body: planet, at: E, value: [1, 0]}}\n"),
         "something besides gears acts on `planet`"},
        {SET("", "", "", "", "", "springs: {k: {between: [ground.F, planet.E], stiffness: 3, length: 1}}\n"),
         "something besides gears acts on `planet`"},
        {SET("", "", "", "", "", "springs: {k: {along: p, stiffness: 3, angle: 1}}\n"),
         "something besides gears acts on `planet`"},
        {SET("", "", "", "", "", "efforts: {p: 2 N*m}\n"), "something besides gears acts on `planet`"},
        {SET("", "", "", "", "", "drives: {p: 3 rad/s * t}\n"), "something besides gears acts on `planet`"},
        {SET("", "", "", "", "", "springs: {k: {between: [planet.E, ground.F], stiffness: 3, length: 1}}\n"),
         "something besides gears acts on `planet`"},
        {SET("", "", "", "", "", "belts: {t: {between: [planet, sun], radii: [1e-3, 2e-3], carrier: arm}}\n"),
         "something besides gears acts on `planet`"},
        {SET("", "", "", "", "", "belts: {t: {between: [sun, planet], radii: [2e-3, 1e-3], carrier: arm}}\n"),
         "something besides gears acts on `planet`"},
        {SET("", "", "  bar: {points: {E: [0, 0]}}\n", "  E: {pin: [planet, bar], angle: e}\n", "", ""),
         "no wheel is held by one pin alone"},
        {SET("", "", "  wheel: {}\n", "  W: {pin: [arm, wheel], at: Q}\n",
             "  more: {mesh: [sun, wheel], teeth: [20, 10], carrier: arm, planets: 3}\n", ""),
         "second planet"},
    };
    for (size_t k = 0; k < sizeof cases / sizeof *cases; k++) {
        YkProblems *problems = yk_problems_new();
        YkModel *model = model_of(cases[k].text, problems);
        const YkProblem *problem = fixture_problem(problems, YK_CODE_PLANETS_ONCE);
        if (!problem || !strstr(problem->message, cases[k].why))
            print_error("%s, not %s\n", cases[k].why, problem ? problem->message : "nothing");
        assert_non_null(problem);
        assert_non_null(strstr(problem->message, cases[k].why));
        for (size_t i = 0; i < model->gear_count; i++) assert_int_equal(model->gears[i].copies, 0);
        assert_true(yk_model_find_body(model, "planet_others") == YK_NOT_FOUND);
        yk_model_free(model);
        yk_problems_free(problems);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(planets_share_a_load),
        cmocka_unit_test(two_planets_leave_one_mass_across_the_axis),
        cmocka_unit_test(one_planet_changes_nothing),
        cmocka_unit_test(what_keeps_planets_from_sharing_is_told),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
