// Springs and dampers, between points and along coordinates.
#include "model/fixture.h"

#define MACHINE                                                                                                        \
    "parameters: {k: 800, c: 5, L: 0.5 m}\n"                                                                           \
    "bodies: {ground: {points: {P: [0, L]}}, ram: {points: {C: [L/2, 0]}}, b: {}}\n"                                   \
    "joints: {O: {pin: [ground, ram], angle: phi}, S: {slide: [ram, b], distance: s}, J: {pin-slot: [ram, b]}}\n"
FIXTURE_BY_NAME(YkSpring, fixture_spring, springs, spring_count)

static void a_spring_lies_between_two_points(void **state)
{
    (void)state;
    YkModel *model = fixture_load(MACHINE "springs: {k1: {between: [ground.P, ram.C], stiffness: k, length: L - 0.2, "
                                          "damping: 2*c*1 N*s/m}}\n");
    const YkSpring *spring = fixture_spring(model, "k1");
    assert_int_equal(spring->coordinate, YK_NONE);
    assert_int_equal(spring->body[0], 0);
    assert_int_equal(spring->body[1], 1);
    assert_int_equal(spring->point[1], yk_model_find_point(model, "ram.C"));
    CHECK_NEAR(spring->at[0].y, 0.5, 0);
    CHECK_NEAR(spring->at[1].x, 0.25, 0);
    CHECK_NEAR(spring->stiffness, 800, 0);
    CHECK_NEAR(spring->length, 0.3, 1e-16);
    CHECK_NEAR(spring->damping, 10, 0);
    assert_non_null(spring->length_expr);
    yk_model_free(model);
}

static void a_spring_lies_along_a_coordinate_of_either_kind(void **state)
{
    (void)state;
    YkModel *model = fixture_load("units: {length: mm, angle: deg, force: N}\n" MACHINE "springs:\n"
                                  "  turn: {along: phi, stiffness: 3 N*m/rad, damping: 0.5 N*m*s/rad, angle: -30}\n"
                                  "  bare: {along: phi, stiffness: 2}\n"
                                  "  push: {along: s, stiffness: 3, length: -20, damping: 4 N*s/m}\n"
                                  "  slot: {along: J.angle, damping: 1 N*m*s}\n");
    const YkSpring *turn = fixture_spring(model, "turn"), *push = fixture_spring(model, "push");
    assert_int_equal(turn->coordinate, 0);
    assert_int_equal(turn->body[0], YK_NONE);
    CHECK_NEAR(turn->stiffness, 3, 0);
    CHECK_NEAR(turn->damping, 0.5, 0);
    CHECK_NEAR(turn->length, -YK_PI / 6, 1e-16);
    CHECK_NEAR(fixture_spring(model, "bare")->stiffness, 2 * 1e-3 / (YK_PI / 180), 1e-15); // N mm a degree
    CHECK_NEAR(push->stiffness, 3000, 1e-12);
    CHECK_NEAR(push->length, -0.02, 1e-17); // a free distance may lie on either side
    CHECK_NEAR(push->damping, 4, 0);
    assert_null(turn->length_expr ? NULL : turn);
    const YkSpring *slot = fixture_spring(model, "slot");
    assert_string_equal(model->coordinates[slot->coordinate].name, "J.angle"); // declared by its mention
    assert_null(slot->stiffness_expr);
    CHECK_NEAR(slot->stiffness, 0, 0);
    CHECK_NEAR(slot->length, 0, 0);
    yk_model_free(model);
}

static void refused(const char *section, int code, unsigned column, const char *part)
{
    char text[600];
    snprintf(text, sizeof text, MACHINE "%s\n", section);
    fixture_refused(text, code, 4, column, part);
}

static void mistakes_in_its_place_are_refused(void **state)
{
    (void)state;
    refused("springs: {k: {stiffness: 1, between: [ground.P, ram.D]}}", YK_CODE_UNKNOWN_POINT, 49, "`D`");
    refused("springs: {k: {stiffness: 1, between: [ground.P, rm.C]}}", YK_CODE_UNKNOWN_BODY, 49, "`rm`");
    refused("springs: {k: {stiffness: 1, between: [P, ram.C]}}", YK_CODE_UNKNOWN_POINT, 39, "ground.P");
    refused("springs: {k: {stiffness: 1, between: [ram.C]}}", YK_CODE_COMPONENTS, 38, "two points");
    refused("springs: {k: {stiffness: 3 N/m}}", YK_CODE_MISSING_KEY, 14, "between");
    refused("springs: {k: {along: psi, stiffness: 1}}", YK_CODE_UNKNOWN_COORDINATE, 22, "psi");
    refused("springs: {k: {along: phi.rate, stiffness: 1}}", YK_CODE_RATE_NOT_HERE, 22, "phi.rate");
    refused("springs: {k: {along: [phi], stiffness: 1}}", YK_CODE_WRONG_KIND, 22, "along of `k`");
    refused("springs: {k: {along: phi, between: [ground.P, ram.C]}}", YK_CODE_RIVAL_KEYS, 27, "coordinate already");
    refused("dampers: {k: {along: phi, damping: 1}}", YK_CODE_UNKNOWN_KEY, 1, "did you mean `springs`?");
    refused("springs: {k: {along: phi, damping: 0, damper: 1}}", YK_CODE_UNKNOWN_KEY, 39, "did you mean `damping`?");
    refused("springs: {k: {along: phi}}", YK_CODE_MISSING_KEY, 14, "`stiffness`, `damping` or `torque`");
    refused("springs: {k: 3}", YK_CODE_WRONG_KIND, 14, "spring `k`");
    refused("springs: {k: {along: phi, stifness: 3, damping: 1}}", YK_CODE_UNKNOWN_KEY, 27, "did you mean `stiffness`");
}

static void the_free_value_is_named_after_its_kind(void **state)
{
    (void)state;
    refused("springs: {k: {along: phi, stiffness: 1, length: 3}}", YK_CODE_UNKNOWN_KEY, 41, "along an angle");
    refused("springs: {k: {along: s, stiffness: 1, angle: 3}}", YK_CODE_UNKNOWN_KEY, 39, "along a distance");
    refused("springs: {k: {between: [ground.P, ram.C], stiffness: 1, angle: 3}}", YK_CODE_UNKNOWN_KEY, 57, "points");
}

static void the_force_of_a_spring_depends_on_its_own_length_and_rate(void **state)
{
    (void)state;
    YkModel *model =
        fixture_load(MACHINE "laws: {air: {table: [[0.2, 5], [0.4, 1]]}, shock: {table: [[-1, -3], [1, 9]]}, "
                             "rubber: {table: [[-1, -2], [1, 2]]}, buffer: {table: [[0, 0], [1, 7]]}}\n"
                             "springs: {a: {between: [ground.P, ram.C], force: {law: air, of: length}},\n"
                             "  b: {between: [ground.P, ram.C], force: 3 N/m * length + 2 N*s/m * rate*sin(phi)},\n"
                             "  c: {along: phi, torque: {law: rubber, of: angle}, damping: c}, d: {along: s, force: "
                             "{law: shock, of: rate}},\n"
                             "  e: {along: s, stiffness: 3, force: {law: buffer, of: length}}}\n");
    const YkSpring *a = fixture_spring(model, "a"), *b = fixture_spring(model, "b");
    assert_string_equal(model->laws[a->force.law].name, "air");
    assert_true(yk_expr_mentions(a->force.expr, YK_OWN_LENGTH));
    assert_null(a->stiffness_expr);
    assert_int_equal(b->force.law, YK_NONE);
    assert_true(yk_expr_mentions(b->force.expr, YK_OWN_RATE) && yk_expr_mentions(b->force.expr, "phi"));
    assert_string_equal(fixture_spring(model, "c")->force.expr->name, "phi"); // the coordinate itself
    assert_string_equal(fixture_spring(model, "d")->force.expr->name, "s.rate");
    assert_string_equal(fixture_spring(model, "e")->force.expr->name, "s");
    static const char *const names[] = {"air", "shock", "rubber", "buffer"};
    const YkDimension of[] = {{.length = 1}, {.length = 1, .time = -1}, {.angle = 1}, {.length = 1}};
    for (size_t k = 0; k < 4; k++) { // bare tables take the dimensions of their use
        assert_string_equal(model->laws[k].name, names[k]);
        assert_true(yk_dimension_equal(model->laws[k].of, of[k]) && model->laws[k].of.angle == of[k].angle);
        assert_string_equal(yk_dimension_name(model->laws[k].value), k == 2 ? "a torque or energy" : "a force");
    }
    yk_model_free(model);
}

static void mistakes_in_the_force_of_a_spring_are_refused(void **state)
{
    (void)state;
    refused("springs: {k: {along: phi, force: 3 N}}", YK_CODE_UNKNOWN_KEY, 27, "it has a `torque`, no `force`");
    refused("springs: {k: {along: s, torque: 3 N*m}}", YK_CODE_UNKNOWN_KEY, 25, "it has a `force`, no `torque`");
    refused("springs: {k: {along: s, force: angle * 1 N}}", YK_CODE_UNKNOWN_NAME, 32, "`angle`");
    refused("springs: {k: {along: s, force: 3 N/m * rate}}", YK_CODE_WRONG_DIMENSION, 32, "force of `k`");
    refused("springs: {k: {along: s, force: {law: none, of: length}}}", YK_CODE_UNKNOWN_LAW, 38, "`none`");
    refused("efforts: {phi: 2 N * length}", YK_CODE_UNKNOWN_NAME, 22, "`length`"); // it means something there only
    refused("springs: {k: {along: s, stiffness: length}}", YK_CODE_UNKNOWN_NAME, 36, "`length`");
    fixture_refused("parameters: {length: 3}\nbodies: {b: {}}\njoints: {S: {slide: [ground, b], distance: s}}\n"
                    "springs: {k: {along: s, force: 2 N/m * length}}\n",
                    YK_CODE_REPEATED_NAME, 4, 40, "rename the parameter");
    fixture_refused("bodies: {b: {}, c: {}}\njoints: {S: {slide: [ground, b], distance: rate}, \n"
                    "  T: {slide: [b, c], distance: u}}\nsprings: {k: {along: u, force: 2 N*s/m * rate}}\n",
                    YK_CODE_REPEATED_NAME, 4, 42, "rename the coordinate");
}

static void negative_values_are_refused_where_they_stand(void **state)
{
    (void)state;
    refused("springs: {k: {along: phi, damping: 1 - 3}}", YK_CODE_BAD_DAMPING, 36, "damping of spring `k` is -2");
    refused("springs: {k: {between: [ground.P, ram.C], stiffness: k, length: L - 1}}", YK_CODE_BAD_LENGTH, 65, "-0.5");
    YkModel *model = fixture_load(MACHINE "springs: {k: {along: s, stiffness: 0, damping: 0, length: -1}}\n");
    yk_model_free(model);
}

static void negative_stiffness_is_allowed_with_a_note(void **state)
{
    (void)state;
    static const char text[] = MACHINE "springs: {k: {along: phi, stiffness: -3}}\n";
    YkProblems *problems = yk_problems_new();
    YkModel *model = yk_model_parse(text, strlen(text), "test.yaml", NULL, problems);
    const YkProblem *problem = fixture_problem(problems, YK_CODE_NEGATIVE_STIFFNESS);
    assert_non_null(model);
    assert_true(fixture_spring(model, "k")->stiffness == -3);
    assert_non_null(problem);
    assert_int_equal(problem->severity, YK_SEVERITY_NOTE);
    assert_int_equal(problem->place.column, 38);
    assert_non_null(
        strstr(problem->message, "stiffness of spring `k` is -3 N*m/rad; it pushes away from its free angle"));
    yk_model_free(model);
    yk_problems_free(problems);
}

static void its_values_are_constants_of_their_dimension(void **state)
{
    (void)state;
    refused("springs: {k: {along: phi, stiffness: 3 N/m}}", YK_CODE_WRONG_DIMENSION, 38, "stiffness of `k`");
    refused("springs: {k: {along: s, stiffness: 3 N*m/rad}}", YK_CODE_WRONG_DIMENSION, 36, "stiffness of `k`");
    refused("springs: {k: {along: s, damping: 3 N/m}}", YK_CODE_WRONG_DIMENSION, 34, "damping of `k`");
    refused("springs: {k: {along: s, stiffness: k, length: 3 deg}}", YK_CODE_WRONG_DIMENSION, 47, "length of `k`");
    refused("springs: {k: {along: s, stiffness: k*t}}", YK_CODE_NAME_NOT_HERE, 38, "time");
    refused("springs: {k: {along: s, stiffness: k, length: s}}", YK_CODE_NAME_NOT_HERE, 47, "coordinate");
    refused("springs: {k: {along: s, stiffness: k/0}}", YK_CODE_EVALUATION, 36, "division by zero");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_spring_lies_between_two_points),
        cmocka_unit_test(a_spring_lies_along_a_coordinate_of_either_kind),
        cmocka_unit_test(mistakes_in_its_place_are_refused),
        cmocka_unit_test(the_free_value_is_named_after_its_kind),
        cmocka_unit_test(the_force_of_a_spring_depends_on_its_own_length_and_rate),
        cmocka_unit_test(mistakes_in_the_force_of_a_spring_are_refused),
        cmocka_unit_test(negative_values_are_refused_where_they_stand),
        cmocka_unit_test(negative_stiffness_is_allowed_with_a_note),
        cmocka_unit_test(its_values_are_constants_of_their_dimension),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
