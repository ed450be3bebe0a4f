// `gears:`, `racks:`, `belts:` and `locks:` as they are read, and what is refused.
#include "model/fixture.h"

#define TRAIN                                                                                                          \
    "parameters: {N1: 27, N2: 36, mod: 2 mm}\n"                                                                        \
    "bodies: {sun: {}, planet: {points: {P: [0, 0]}}, ring: {}, arm: {points: {P: [mod*(N1 + N2)/2, 0]}}, bar: {}}\n"  \
    "joints: {S: {pin: [ground, sun], angle: s}, C: {pin: [ground, arm], angle: c}, R: {pin: [ground, ring]},\n"       \
    "  P: {pin: [arm, planet]}, B: {slide: [ground, bar], from: Q, distance: d}}\n"
#define GROUND "{points: {Q: [0, -40 mm]}}"

static YkModel *train(const char *sections)
{
    char text[2000];
    snprintf(text, sizeof text, "%s%s", TRAIN, sections);
    char *from = strstr(text, "from: Q, ");
    memmove(from, from + 9, strlen(from + 9) + 1);
    return fixture_load(text);
}

static void refused(const char *sections, int code, const char *part)
{
    char text[2000];
    snprintf(text, sizeof text, "%s%s", TRAIN, sections);
    char *from = strstr(text, "from: Q, ");
    memmove(from, from + 9, strlen(from + 9) + 1);
    YkProblems *problems = fixture_refuse(text);
    const YkProblem *problem = fixture_problem(problems, code);
    int is_right = problem && (strstr(problem->message, part) || (problem->hint && strstr(problem->hint, part))) &&
                   yk_problems_error_count(problems) == 1;
    if (!is_right) print_error("expected E%04d (%s), found\n%s", code, part, yk_problems_text(problems, 0));
    yk_problems_free(problems);
    assert_true(is_right);
}

static void gears_keep_teeth_module_and_their_carrier(void **state)
{
    (void)state;
    YkModel *model = train("gears: {g: {mesh: [sun, planet], teeth: [N1, N2], module: mod},\n"
                           "  h: {mesh: [planet, ring], teeth: [24, 3*29], internal: true, pressure_angle: 25 deg}}\n");
    const YkGear *g = &model->gears[0], *h = &model->gears[1];
    assert_int_equal(model->gear_count, 2);
    assert_string_equal(model->bodies[g->carrier].name, "arm");
    assert_string_equal(model->bodies[h->carrier].name, "arm");
    assert_int_equal(g->teeth[0], 27);
    assert_int_equal(g->teeth[1], 36);
    assert_int_equal(h->teeth[1], 87);
    assert_true(h->is_internal && !g->is_internal);
    CHECK_NEAR(g->module, 0.002, 0);
    CHECK_NEAR(g->pressure_angle, 20 * YK_PI / 180, 1e-16);
    CHECK_NEAR(h->pressure_angle, 25 * YK_PI / 180, 1e-15);
    CHECK_NEAR(g->center_distance, 0.063, 1e-15);
    yk_model_free(model);
}

static void a_wheels_centre_needs_no_name(void **state)
{
    (void)state;
    YkModel *model =
        fixture_load("bodies: {arm: {points: {P: [63 mm, 0]}}, planet: {}, sun: {}}\n"
                     "joints: {O: {pin: [ground, arm]}, S: {pin: [ground, sun]}, P: {pin: [arm, planet]}}\n"
                     "gears: {g: {mesh: [sun, planet], teeth: [27, 36]}}\n");
    const YkJoint *pin = fixture_joint(model, "P");
    CHECK_NEAR(pin->at[0].x, 0.063, 1e-15);
    CHECK_NEAR(pin->at[1].x, 0, 0);
    yk_model_free(model);
    fixture_refused("bodies: {arm: {points: {P: [1, 0]}}, planet: {}}\n"
                    "joints: {O: {pin: [ground, arm]}, P: {pin: [arm, planet]}}\n",
                    YK_CODE_POINT_ON_ONE_BODY, 2, 35, "has not");
}

// A wheel with a point of its own, and a pin `P` to it.
static void check_slip(const char *own, bool warns)
{
    char text[400];
    snprintf(text, sizeof text,
             "bodies: {arm: {points: {P: [63 mm, 0]}}, planet: {points: {%s}}, sun: {}}\n"
             "joints: {O: {pin: [ground, arm]}, S: {pin: [ground, sun]}, P: {pin: [arm, planet]}}\n"
             "gears: {g: {mesh: [sun, planet], teeth: [27, 36]}}\n",
             own);
    YkProblems *problems = yk_problems_new();
    YkModel *model = yk_model_parse(text, strlen(text), "test.yaml", NULL, problems);
    assert_non_null(model);
    const YkProblem *warning = fixture_problem(problems, YK_CODE_WHEEL_POINT);
    assert_true((warning != NULL) == warns);
    yk_model_free(model);
    yk_problems_free(problems);
}

static void a_centre_may_be_a_slip_of_the_pen(void **state)
{
    (void)state;
    check_slip("p: [20 mm, 0]", true);
    check_slip("P2: [0, 20 mm]", true);
    check_slip("P: [0, 0]", false);
    check_slip("P2: [0, 0]", false); // the same place
    check_slip("edge: [20 mm, 0]", false);
}

static void gears_that_cannot_exist_are_refused(void **state)
{
    (void)state;
    refused("gears: {g: {mesh: [sun, planet], teeth: [N1/2, N2]}}", YK_CODE_BAD_TEETH, "13.5");
    refused("gears: {g: {mesh: [sun, planet], teeth: [N1, -N2]}}", YK_CODE_BAD_TEETH, "-36");
    refused("gears: {g: {mesh: [sun, planet], teeth: [0, N2]}}", YK_CODE_BAD_TEETH, "0");
    refused("gears: {g: {mesh: [planet, ring], teeth: [N2, N1], internal: true}}", YK_CODE_RING_TOO_SMALL, "27");
    refused("gears: {g: {mesh: [planet, planet], teeth: [N1, N2]}}", YK_CODE_SELF_MESH, "planet");
    refused("gears: {g: {mesh: [sun, planets], teeth: [N1, N2]}}", YK_CODE_UNKNOWN_BODY, "planet");
    refused("gears: {g: {mesh: [sun, planet], teeth: [N1]}}", YK_CODE_COMPONENTS, "two");
    refused("gears: {g: {mesh: [sun, planet]}}", YK_CODE_MISSING_KEY, "teeth");
    refused("gears: {g: {mesh: [sun, planet], teeth: [N1, N2], modul: 2}}", YK_CODE_UNKNOWN_KEY, "module");
    refused("gears: {g: {mesh: [sun, planet], teeth: [N1, 36, 3]}}", YK_CODE_COMPONENTS, "3");
    refused("gears: {g: {mesh: [sun, planet], teeth: [N1, N2], module: 0 mm}}", YK_CODE_BAD_MODULE, "positive");
    refused("units: {length: mm}\ngears: {g: {mesh: [sun, planet], teeth: [N1, N2], module: -2}}", YK_CODE_BAD_MODULE,
            "-2 mm;");
    refused("gears: {g: {mesh: [sun, planet], teeth: [N1, N2], pressure_angle: 60 deg}}", YK_CODE_BAD_MODULE, "60");
    refused("gears: {g: {mesh: [sun, planet], teeth: [N1, N2], planets: 2.5}}", YK_CODE_BAD_TEETH, "2.5");
    refused("gears: {g: {mesh: [sun, planet], teeth: [N1, N2], internal: yes}}", YK_CODE_WRONG_WORD, "true");
}

static void centres_that_no_body_holds_are_refused(void **state)
{
    (void)state;
    refused("gears: {g: {mesh: [sun, planet], teeth: [N1, N2], carrier: ring}}", YK_CODE_NO_CARRIER, "planet");
    refused("gears: {g: {mesh: [sun, planet], teeth: [N1, N2], carrier: planet}}", YK_CODE_NO_CARRIER, "itself");
    refused("gears: {g: {mesh: [sun, bar], teeth: [N1, N2]}}", YK_CODE_NO_CARRIER, "no pin holds the centre of `bar`");
    refused("gears: {g: {mesh: [sun, ring], teeth: [N1, N2]}}", YK_CODE_NO_CARRIER, "turn about one axis");
}

// The epicyclic train whose arm has no point for the planet: the pin then lies on the axis of all the others.
static void a_carrier_without_a_point_off_the_axis_is_told_what_it_lacks(void **state)
{
    (void)state;
    const char *machine = "bodies: {sun: {}, planet: {}, arm: {%s}, twin: {%s}, ground: {points: {A: [0, 0]}}}\n"
                          "joints:\n  S: {pin: [ground, sun], angle: a}\n  C: {pin: [ground, arm], angle: c}\n"
                          "  D: {pin: [ground, twin], angle: d}\n  P: {pin: [arm, planet], angle: p%s}\n%s"
                          "gears: {g: {mesh: [sun, planet], teeth: [27, 36]}}\n";
    const struct {
        const char *arm, *twin, *at, *more, *message, *hint;
    } cases[] = {
        {"", "", "", "", "`sun` and `planet` turn about one axis", "`arm: {points: {P: [a, 0]}}`"},
        {"points: {Q: [1, 0]}", "", "", "", "`sun` and `planet` turn about one axis", "`at: Q`"},
        {"points: {Q: [1, 0]}", "points: {Q: [1, 0]}", ", at: Q", "  T: {pin: [twin, planet], at: Q}\n",
         "both `arm` and `twin` hold the two centres", "`carrier: arm`"},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        char text[1000];
        snprintf(text, sizeof text, machine, cases[i].arm, cases[i].twin, cases[i].at, cases[i].more);
        YkProblems *problems = fixture_refuse(text);
        const YkProblem *problem = fixture_problem(problems, YK_CODE_NO_CARRIER);
        if (!problem || !problem->hint || !strstr(problem->hint, cases[i].hint))
            print_error("%s", yk_problems_text(problems, 0));
        assert_non_null(problem);
        assert_non_null(strstr(problem->message, cases[i].message));
        assert_non_null(strstr(problem->hint, cases[i].hint));
        yk_problems_free(problems);
    }
}

static void a_centre_distance_that_does_not_fit_is_told_with_its_error(void **state)
{
    (void)state;
    refused("gears: {g: {mesh: [sun, planet], teeth: [N1, N2 + 1], module: mod}}", YK_CODE_CENTER_DISTANCE,
            "0.001 m too little");
    refused("gears: {g: {mesh: [planet, ring], teeth: [24, 86], module: mod, internal: true}}", YK_CODE_CENTER_DISTANCE,
            "0.001 m too much");
}

static void all_mistakes_are_told_at_once(void **state)
{
    (void)state;
    YkProblems *problems =
        fixture_refuse("bodies: {sun: {}, planet: {}, arm: {points: {P: [1, 0]}}}\n"
                       "joints: {S: {pin: [ground, sun]}, C: {pin: [ground, arm]}, P: {pin: [arm, planet]}}\n"
                       "gears: {g: {mesh: [sun, planet], teeth: [1.5, 20]}, h: {mesh: [sun, sun], teeth: [1, 2]}}\n"
                       "belts: {b: {between: [sun, planet], radii: [0, 1]}}\nlocks: {x: [moon]}\n");
    assert_int_equal(yk_problems_error_count(problems), 4);
    yk_problems_free(problems);
}

static void radii_of_belts_are_kept_exactly(void **state)
{
    (void)state;
    YkModel *model = train("belts: {b: {between: [sun, planet], radii: [0.3, 12.5 mm], crossed: true}}\n");
    const YkBelt *belt = &model->belts[0];
    assert_true(belt->is_crossed && belt->exact_radius[0].is_exact && belt->exact_radius[1].is_exact);
    assert_int_equal(belt->exact_radius[0].numerator, 3);
    assert_int_equal(belt->exact_radius[0].denominator, 10);
    assert_int_equal(belt->exact_radius[1].numerator, 1);
    assert_int_equal(belt->exact_radius[1].denominator, 80);
    yk_model_free(model);
    refused("belts: {b: {between: [sun, planet], radii: [0.3, -1]}}", YK_CODE_BAD_RADIUS, "-1");
    refused("units: {length: mm}\nbelts: {b: {between: [sun, planet], radii: [3, -5]}}", YK_CODE_BAD_RADIUS, "-5 mm;");
}

static void exact_values_know_units_and_pi(void **state)
{
    (void)state;
    YkModel *model =
        fixture_load("parameters: {a: 20 rpm, b: 3/4 deg, c: 2*pi, d: 1 in, e: sqrt(2), f: (1/3)^2 - 0.1}\n" CRANK
                     "drives: {theta: 40 rpm * t + 1}\n");
    const struct {
        const char *name;
        int64_t numerator, denominator;
        int32_t pi;
    } cases[] = {{"a", 2, 3, 1}, {"b", 1, 240, 1}, {"c", 2, 1, 1}, {"d", 127, 5000, 0}, {"f", 1, 90, 0}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        YkExact exact = yk_model_exact(model, fixture_parameter(model, cases[i].name)->expr);
        assert_true(exact.is_exact);
        assert_int_equal(exact.numerator, cases[i].numerator);
        assert_int_equal(exact.denominator, cases[i].denominator);
        assert_int_equal(exact.pi, cases[i].pi);
    }
    assert_false(yk_model_exact(model, fixture_parameter(model, "e")->expr).is_exact);
    YkExact rate = yk_model_exact_rate(model, model->drives[0].expr);
    assert_true(rate.is_exact && rate.numerator == 4 && rate.denominator == 3 && rate.pi == 1);
    assert_false(yk_model_exact(model, model->drives[0].expr).is_exact); // it depends on t
    yk_model_free(model);
}

static void a_racks_sense_depends_on_the_side_of_its_pinion(void **state)
{
    (void)state;
    for (int side = 0; side < 2; side++) {
        char text[600];
        snprintf(text, sizeof text,
                 "bodies: {ground: {points: {Q: [0, %s]}}, pinion: {}, bar: {}}\n"
                 "joints: {A: {pin: [ground, pinion]}, B: {slide: [ground, bar], from: Q}}\n"
                 "racks: {r: {pinion: pinion, rack: bar, radius: 40 mm}}\n",
                 side ? "40 mm" : "-40 mm");
        YkModel *model = fixture_load(text);
        assert_int_equal(model->racks[0].sense, side ? -1 : 1);
        assert_int_equal(model->racks[0].carrier, 0);
        yk_model_free(model);
    }
    refused("racks: {r: {pinion: planet, rack: bar, radius: 1}}", YK_CODE_NO_CARRIER, "slide");
    refused("racks: {r: {pinion: sun, rack: sun, radius: 1}}", YK_CODE_SELF_MESH, "sun");
    refused("racks: {r: {pinion: sun, rack: bar, radius: 0}}", YK_CODE_BAD_RADIUS, "0");
    refused("units: {length: mm}\nracks: {r: {pinion: sun, rack: bar, radius: -5}}", YK_CODE_BAD_RADIUS, "-5 mm;");
}

// Returns how many problems of this code the text has.
static size_t count_of(const char *text, int code)
{
    YkProblems *problems = yk_problems_new();
    yk_model_free(yk_model_parse(text, strlen(text), "t.yaml", NULL, problems));
    size_t count = 0;
    for (size_t k = 0; k < yk_problems_count(problems); k++) count += (int)yk_problems_get(problems, k)->code == code;
    yk_problems_free(problems);
    return count;
}

static void a_rack_through_its_pinion_and_pulleys_without_room_are_told(void **state)
{
    (void)state;
    static const struct {
        const char *place, *drives;
        size_t rack, belt;
    } cases[] = {
        {"[0, 0]", "racks: {r: {pinion: a, rack: bar, radius: 0.04}}", 1, 0},
        {"[0.3, 0]", "racks: {r: {pinion: a, rack: bar, radius: 0.04}}", 1, 0},
        {"[0, 0.04]", "racks: {r: {pinion: a, rack: bar, radius: 0.04}}", 0, 0},
        {"[0, 0]", "belts: {b: {between: [a, b], radii: [0.05, 0.051]}}", 0, 1},
        {"[0, 0]", "belts: {b: {between: [a, b], radii: [0.05, 0.051], crossed: true}}", 0, 1},
        {"[0, 0]", "belts: {b: {between: [a, b], radii: [0.05, 0.049]}}", 0, 0},
    };
    for (size_t k = 0; k < sizeof cases / sizeof *cases; k++) {
        char text[600];
        snprintf(text, sizeof text,
                 "bodies: {ground: {points: {Q: %s, B: [0.1, 0]}}, a: {}, b: {points: {B: [0, 0]}}, bar: {}}\n"
                 "joints: {A: {pin: [ground, a]}, B: {pin: [ground, b]}, S: {slide: [ground, bar], from: Q}}\n%s\n",
                 cases[k].place, cases[k].drives);
        assert_int_equal(count_of(text, YK_CODE_RACK_SIDE), cases[k].rack);
        assert_int_equal(count_of(text, YK_CODE_PULLEYS_OVERLAP), cases[k].belt);
    }
}

static void locks_are_lists_or_maps(void **state)
{
    (void)state;
    YkModel *model = train("locks: {a: [ring, sun], b: {hold: [c, d], join: [[sun, arm], [ring, planet]]}}\n");
    assert_int_equal(model->lock_count, 2);
    assert_int_equal(model->locks[0].hold_count, 2);
    assert_string_equal(model->bodies[model->locks[0].holds[0].body].name, "ring");
    assert_int_equal(model->locks[1].holds[0].body, YK_NONE);
    assert_string_equal(model->coordinates[model->locks[1].holds[1].coordinate].name, "d");
    assert_int_equal(model->locks[1].join_count, 2);
    yk_model_free(model);
    refused("locks: {a: [rings]}", YK_CODE_UNKNOWN_BODY, "ring");
    refused("locks: {a: [ground]}", YK_CODE_BAD_LOCK, "already");
    refused("locks: {a: {join: [[sun, sun]]}}", YK_CODE_BAD_LOCK, "itself");
    refused("locks: {a: {join: [[sun, rings]]}}", YK_CODE_UNKNOWN_BODY, "ring");
    refused("locks: {a: {join: [[rings, sun], [sun, arm]]}}", YK_CODE_UNKNOWN_BODY, "ring");
    refused("locks: {a: {join: [[sun, arm, ring]]}}", YK_CODE_COMPONENTS, "3");
    refused("locks: {a: 3}", YK_CODE_WRONG_KIND, "join");
    refused("locks: {a: {join: [sun]}}", YK_CODE_WRONG_KIND, "list");
    refused("locks: {a: {keep: [sun]}}", YK_CODE_UNKNOWN_KEY, "keep");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(gears_keep_teeth_module_and_their_carrier),
        cmocka_unit_test(a_wheels_centre_needs_no_name),
        cmocka_unit_test(a_centre_may_be_a_slip_of_the_pen),
        cmocka_unit_test(gears_that_cannot_exist_are_refused),
        cmocka_unit_test(centres_that_no_body_holds_are_refused),
        cmocka_unit_test(a_carrier_without_a_point_off_the_axis_is_told_what_it_lacks),
        cmocka_unit_test(a_centre_distance_that_does_not_fit_is_told_with_its_error),
        cmocka_unit_test(all_mistakes_are_told_at_once),
        cmocka_unit_test(radii_of_belts_are_kept_exactly),
        cmocka_unit_test(exact_values_know_units_and_pi),
        cmocka_unit_test(a_racks_sense_depends_on_the_side_of_its_pinion),
        cmocka_unit_test(a_rack_through_its_pinion_and_pulleys_without_room_are_told),
        cmocka_unit_test(locks_are_lists_or_maps),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
