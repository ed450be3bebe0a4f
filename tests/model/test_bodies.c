// Bodies, their points and their masses.
#include "model/fixture.h"

#define PINNED "joints: {O: {pin: [ground, b]}}\n"

static void the_ground_is_body_zero_wherever_it_stands(void **state)
{
    (void)state;
    const char *texts[] = {"bodies: {b: {}}\n" PINNED, "bodies: {b: {}, ground: {points: {Q: [1, 2]}}}\n" PINNED,
                           "bodies: {ground: {points: {Q: [1, 2]}}, b: {}}\n" PINNED,
                           "bodies: {b: , ground: }\n" PINNED};
    for (size_t i = 0; i < 4; i++) {
        YkModel *model = fixture_load(texts[i]);
        assert_int_equal(yk_model_body_count(model), 2);
        assert_string_equal(yk_model_body_name(model, 0), "ground");
        assert_string_equal(yk_model_body_name(model, 1), "b");
        assert_int_equal(yk_model_find_body(model, "ground"), 0);
        yk_model_free(model);
    }
}

static void points_of_a_body_stand_together_and_know_their_body(void **state)
{
    (void)state;
    YkModel *model =
        fixture_load("bodies: {b: {points: {P: [1, 2], Q: [3, 4]}}, ground: {points: {P: [5, 6]}}}\n" PINNED);
    for (size_t i = 0; i < model->body_count; i++) {
        const YkBody *body = &model->bodies[i];
        for (int32_t k = 0; k < body->point_count; k++) assert_int_equal(model->points[body->first_point + k].body, i);
    }
    CHECK_NEAR(fixture_point(model, "b.Q")->at.y, 4, 0);
    CHECK_NEAR(fixture_point(model, "ground.P")->at.x, 5, 0);
    assert_int_equal(fixture_body(model, "b")->point_count, 2);
    yk_model_free(model);
}

static void numbers_keep_their_exact_decimals(void **state)
{
    (void)state;
    YkModel *model = fixture_load("bodies: {b: {points: {P: [0.1, -2.50], Q: ['3', 1e-3]}}}\n" PINNED);
    const YkPoint *p = fixture_point(model, "b.P"), *q = fixture_point(model, "b.Q");
    assert_int_equal(p->x->kind, YK_EXPR_NUMBER);
    assert_true(p->x->is_exact && p->x->mantissa == 1 && p->x->exponent == -1);
    assert_int_equal(p->y->kind, YK_EXPR_NEGATE);
    CHECK_NEAR(p->y->a->number, 2.5, 0);
    CHECK_NEAR(p->at.y, -2.5, 0);
    CHECK_NEAR(q->at.x, 3, 0);
    CHECK_NEAR(q->at.y, 0.001, 0);
    yk_model_free(model);
}

static void a_plain_number_equals_the_same_number_as_an_expression(void **state)
{
    (void)state;
    uint64_t seed = 7;
    for (int i = 0; i < 200; i++) {
        char text[300];
        double x = check_uniform(&seed, -1000, 1000), y = x * check_uniform(&seed, 0, 1e-9);
        snprintf(text, sizeof text,
                 "units: {length: mm}\nbodies: {b: {points: {P: [%.17g, %.17g], Q: [(%.17g), 0 + %.17g]}}}\n" PINNED, x,
                 y, x, y);
        YkModel *model = fixture_load(text);
        YkVec p = fixture_point(model, "b.P")->at, q = fixture_point(model, "b.Q")->at;
        assert_true(p.x == q.x && p.y == q.y);
        yk_model_free(model);
    }
}

static void a_rod_has_its_centre_and_inertia_at_any_place_and_direction(void **state)
{
    (void)state;
    uint64_t seed = 11;
    for (int i = 0; i < 50; i++) {
        char text[300];
        double x = check_uniform(&seed, -1, 1), y = check_uniform(&seed, -1, 1), m = check_uniform(&seed, 0.1, 9);
        double u = check_uniform(&seed, -1, 1), v = check_uniform(&seed, -1, 1);
        snprintf(text, sizeof text,
                 "bodies: {b: {points: {P: [%.17g, %.17g], Q: [%.17g, %.17g]}, mass: %.17g, rod: [P, Q]}}\n" PINNED, x,
                 y, u, v, m);
        YkModel *model = fixture_load(text);
        const YkBody *body = fixture_body(model, "b");
        // Independently: a thousand equal pieces of the rod.
        double inertia = 0;
        for (int k = 0; k < 1000; k++) {
            double s = (k + 0.5) / 1000 - 0.5;
            inertia += m / 1000 * s * s * ((u - x) * (u - x) + (v - y) * (v - y));
        }
        CHECK_NEAR(body->inertia, inertia, 2e-6 * inertia);
        CHECK_NEAR(body->center.x, (x + u) / 2, 1e-15);
        CHECK_NEAR(body->center.y, (y + v) / 2, 1e-15);
        assert_true(body->rod[0] != YK_NONE && body->rod[1] != YK_NONE && body->rod[0] != body->rod[1]);
        yk_model_free(model);
    }
}

// From a hundredth of the body's extent to a hundred times as much.
static void an_inertia_of_the_wrong_unit_is_doubted(void **state)
{
    (void)state;
    static const struct {
        const char *inertia;
        size_t warnings;
    } cases[] = {{"0.02 kg*mm^2", 1}, {"0.11 g*m^2", 0}, {"1 kg*m^2", 0},
                 {"0.9e4 kg*m^2", 0}, {"2e4 kg*m^2", 1}, {"0", 0}};
    for (size_t k = 0; k < sizeof cases / sizeof *cases; k++) {
        char text[256];
        snprintf(text, sizeof text, "bodies: {b: {points: {P: [1 m, 0]}, mass: 1 kg, inertia: %s}}\n" PINNED,
                 cases[k].inertia);
        YkProblems *problems = yk_problems_new();
        YkModel *model = yk_model_parse(text, strlen(text), "test.yaml", NULL, problems);
        assert_non_null(model);
        assert_int_equal(yk_problems_count(problems), cases[k].warnings);
        yk_model_free(model);
        yk_problems_free(problems);
    }
}

// A mistaken unit of a point is told once: its value is not taken for a length against which the inertia would look
// odd.
static void an_error_is_not_followed_by_a_doubt(void **state)
{
    (void)state;
    YkProblems *problems =
        fixture_refuse("bodies: {b: {points: {P: [260 kg, 0]}, mass: 1 kg, inertia: 0.1 kg*m^2}}\n" PINNED);
    assert_int_equal(yk_problems_count(problems), 1);
    assert_int_equal(yk_problems_get(problems, 0)->code, YK_CODE_WRONG_DIMENSION);
    yk_problems_free(problems);
}

static void mass_alone_is_a_point_mass_and_inertia_alone_a_flywheel(void **state)
{
    (void)state;
    YkModel *model = fixture_load("bodies: {b: {mass: 2}}\n" PINNED);
    const YkBody *body = fixture_body(model, "b");
    assert_true(body->has_mass && body->mass == 2 && body->inertia == 0 && body->center.x == 0);
    assert_null(body->center_x);
    assert_int_equal(body->rod[0], YK_NONE);
    yk_model_free(model);
    model = fixture_load("bodies: {b: {inertia: 3}}\n" PINNED);
    body = fixture_body(model, "b");
    assert_true(body->has_mass && body->mass == 0 && body->inertia == 3);
    yk_model_free(model);
    model = fixture_load("bodies: {b: {}}\n" PINNED);
    assert_false(fixture_body(model, "b")->has_mass);
    yk_model_free(model);
}

static void refused_body(const char *body, int code, unsigned column, const char *part)
{
    char text[300];
    snprintf(text, sizeof text, "bodies: {b: %s}\n" PINNED, body);
    fixture_refused(text, code, 1, column, part); // the body's text begins in column 13
}

static void mistakes_in_points_are_refused_where_they_stand(void **state)
{
    (void)state;
    refused_body("{points: {P: [1, 2, 3]}}", YK_CODE_COMPONENTS, 26, "x and y; here are 3");
    refused_body("{points: {P: [1,000 mm, 2]}}", YK_CODE_COMPONENTS, 26, "a comma ends a number");
    refused_body("{points: {P: [1]}}", YK_CODE_COMPONENTS, 26, "point `P` of `b`");
    refused_body("{points: {P: 3}}", YK_CODE_WRONG_KIND, 26, "point `P` of `b` must be a list");
    refused_body("{points: {P: [1, [2]]}}", YK_CODE_WRONG_KIND, 30, "y of point `P` of `b`");
    refused_body("{points: {P: [1, '']}}", YK_CODE_EMPTY_VALUE, 30, "y of point `P` of `b`");
    refused_body("{points: [P, Q]}", YK_CODE_WRONG_KIND, 22, "points of `b`");
    refused_body("{points: {1P: [1, 2]}}", YK_CODE_BAD_NAME, 23, "1P");
    refused_body("{points: {P: [1e101, 2]}}", YK_CODE_VALUE_RANGE, 27, "1e100");
    refused_body("{points: {P: [2e100 + 1, 2]}}", YK_CODE_VALUE_RANGE, 27, "1e100");
    refused_body("{point: {P: [1, 2]}}", YK_CODE_UNKNOWN_KEY, 14, "did you mean `points`");
    refused_body("7", YK_CODE_WRONG_KIND, 13, "body `b`");
}

static void mistakes_in_masses_are_refused_where_they_stand(void **state)
{
    (void)state;
    refused_body("{mass: 0}", YK_CODE_BAD_MASS, 20, "leave `mass` out");
    refused_body("{mass: -2 kg}", YK_CODE_BAD_MASS, 20, "-2");
    refused_body("{inertia: -1, mass: 1}", YK_CODE_BAD_INERTIA, 23, "negative");
    refused_body("{mass: 1, center: [1]}", YK_CODE_COMPONENTS, 31, "center of `b`");
    refused_body("{center: [1, 0]}", YK_CODE_NEEDS_MASS, 14, "no mass");
    refused_body("{points: {P: [0, 0], Q: [1, 0]}, rod: [P, Q]}", YK_CODE_NEEDS_MASS, 46, "no mass");
    refused_body("{points: {P: [0, 0], Q: [1, 0]}, mass: 1, rod: [P, Q, P]}", YK_CODE_COMPONENTS, 60, "two points");
    refused_body("{points: {P: [0, 0], Q: [1, 0]}, mass: 1, rod: [P, R]}", YK_CODE_UNKNOWN_POINT, 64, "no point `R`");
    refused_body("{points: {P: [0, 0]}, mass: 1, rod: [P, P]}", YK_CODE_ZERO_ROD, 49, "itself");
    refused_body("{points: {P: [1, 0], Q: [1, 0]}, mass: 1, rod: [P, Q]}", YK_CODE_ZERO_ROD, 10,
                 "`P` and `Q` coincide");
    refused_body("{points: {P: [0, 0], Q: [1, 0]}, mass: 1, rod: [P, Q], inertia: 2}", YK_CODE_RIVAL_KEYS, 68,
                 "inertia");
    refused_body("{points: {P: [0, 0], Q: [1, 0]}, mass: 1, rod: [P, Q], center: [0, 0]}", YK_CODE_RIVAL_KEYS, 68,
                 "center");
    refused_body("{mass: 3, masss: 3}", YK_CODE_UNKNOWN_KEY, 23, "mass");
}

static void a_machine_of_ground_alone_is_refused(void **state)
{
    (void)state;
    fixture_refused("name: x\n", YK_CODE_NO_BODIES, 1, 1, NULL);
    fixture_refused("bodies: {}\n", YK_CODE_NO_BODIES, 1, 9, NULL);
    fixture_refused("bodies: {ground: {points: {A: [0, 0]}}}\n", YK_CODE_NO_BODIES, 1, 9, NULL);
    fixture_refused("bodies: {ground: {mass: 1}, b: {}}\n" PINNED, YK_CODE_GROUND_KEY, 1, 19, "mass");
}

static void names_have_letters_digits_and_dashes(void **state)
{
    (void)state;
    const char *good[] = {"a", "A_1", "link-1", "_x"};
    const char *bad[] = {"1a", "-a", "a.b", "a b", "a/b", "\xc3\xa4", "~"};
    char text[400], name[120];
    for (size_t i = 0; i < 4; i++) {
        snprintf(text, sizeof text, "bodies: {%s: {}}\njoints: {O: {pin: [ground, %s]}}\n", good[i], good[i]);
        yk_model_free(fixture_load(text));
    }
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        snprintf(text, sizeof text, "bodies: {%s: {}}\njoints: {O: {pin: [ground, %s]}}\n", bad[i], bad[i]);
        YkProblems *problems = fixture_refuse(text);
        if (!fixture_problem(problems, YK_CODE_BAD_NAME)) print_error("%s", yk_problems_text(problems, 0));
        assert_non_null(fixture_problem(problems, YK_CODE_BAD_NAME));
        yk_problems_free(problems);
    }
    memset(name, 'n', 101);
    name[101] = '\0';
    snprintf(text, sizeof text, "bodies: {%s: {}}\njoints: {O: {pin: [ground, %s]}}\n", name, name);
    YkProblems *problems = fixture_refuse(text);
    assert_non_null(strstr(fixture_problem(problems, YK_CODE_BAD_NAME)->hint, "at most 100 letters"));
    yk_problems_free(problems);
    snprintf(text, sizeof text, "bodies: {%s: {}}\njoints: {O: {pin: [ground, %s]}}\n", name + 1, name + 1);
    yk_model_free(fixture_load(text));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_ground_is_body_zero_wherever_it_stands),
        cmocka_unit_test(points_of_a_body_stand_together_and_know_their_body),
        cmocka_unit_test(numbers_keep_their_exact_decimals),
        cmocka_unit_test(a_plain_number_equals_the_same_number_as_an_expression),
        cmocka_unit_test(a_rod_has_its_centre_and_inertia_at_any_place_and_direction),
        cmocka_unit_test(an_inertia_of_the_wrong_unit_is_doubted),
        cmocka_unit_test(an_error_is_not_followed_by_a_doubt),
        cmocka_unit_test(mass_alone_is_a_point_mass_and_inertia_alone_a_flywheel),
        cmocka_unit_test(mistakes_in_points_are_refused_where_they_stand),
        cmocka_unit_test(mistakes_in_masses_are_refused_where_they_stand),
        cmocka_unit_test(a_machine_of_ground_alone_is_refused),
        cmocka_unit_test(names_have_letters_digits_and_dashes),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
