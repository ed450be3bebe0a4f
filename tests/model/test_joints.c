// Joints: their kind, bodies, places and directions; the coordinates named there.
#include "model/fixture.h"

#define BODIES                                                                                                         \
    "bodies: {ground: {points: {O: [0, 0], P: [1, 2], W: [5, 0]}}, a: {points: {O: [0, 0], A: [3, 0]}},"               \
    " b: {points: {A: [0, 0], Q: [4, 5]}}}\n"
// Both bodies are held, so that a test adds one joint more.
#define HELD BODIES "joints:\n  O: {pin: [ground, a]}\n  A: {pin: [a, b]}\n"

static YkModel *load_joint(const char *joint)
{
    char text[500];
    snprintf(text, sizeof text, HELD "  J: %s\n", joint);
    return fixture_load(text);
}

static void refused_joint(const char *joint, int code, unsigned column, const char *part)
{
    char text[500];
    snprintf(text, sizeof text, HELD "  J: %s\n", joint);
    fixture_refused(text, code, 5, column, part); // the joint's text begins in column 6, line 5
}

static void check_ends(const char *text, double ax, double ay, double bx, double by)
{
    YkModel *model = load_joint(text);
    const YkJoint *joint = fixture_joint(model, "J");
    CHECK_NEAR(joint->at[0].x, ax, 0);
    CHECK_NEAR(joint->at[0].y, ay, 0);
    CHECK_NEAR(joint->at[1].x, bx, 0);
    CHECK_NEAR(joint->at[1].y, by, 0);
    for (int k = 0; k < 2; k++) {
        if (joint->point[k] != YK_NONE) assert_int_equal(model->points[joint->point[k]].body, joint->body[k]);
    }
    yk_model_free(model);
}

static void a_joint_sits_at_the_points_named_or_at_the_origins(void **state)
{
    (void)state;
    check_ends("{pin: [ground, b]}", 0, 0, 0, 0); // neither has a point J
    check_ends("{pin: [a, b], at: A}", 3, 0, 0, 0);
    check_ends("{weld: [a, b], at: A}", 3, 0, 0, 0);
    check_ends("{weld: [ground, b]}", 0, 0, 0, 0);
    check_ends("{slide: [ground, b]}", 0, 0, 0, 0);
    check_ends("{slide: [ground, b], from: P, to: Q}", 1, 2, 4, 5);
    check_ends("{pin-slot: [ground, b], from: P}", 1, 2, 0, 0);
    check_ends("{pin-slot: [ground, b], from: P, at: Q}", 1, 2, 4, 5);
}

static void a_pin_in_a_slot_takes_its_own_name_for_the_point_of_b(void **state)
{
    (void)state;
    YkModel *model = fixture_load(HELD "  Q: {pin-slot: [ground, b], along: y}\n");
    CHECK_NEAR(fixture_joint(model, "Q")->at[1].x, 4, 0);
    yk_model_free(model);
}

static void directions_by_name_are_exact(void **state)
{
    (void)state;
    const struct {
        const char *name;
        double x, y, angle;
    } cases[] = {{"x", 1, 0, 0}, {"y", 0, 1, YK_PI / 2}, {"-x", -1, 0, YK_PI}, {"-y", 0, -1, -YK_PI / 2}};
    for (size_t i = 0; i < 4; i++) {
        char text[100];
        snprintf(text, sizeof text, "{slide: [ground, b], along: %s}", cases[i].name);
        YkModel *model = load_joint(text);
        const YkJoint *joint = fixture_joint(model, "J");
        assert_true(joint->along.x == cases[i].x && joint->along.y == cases[i].y);
        CHECK_NEAR(joint->along_angle, cases[i].angle, 0);
        CHECK_NEAR(cos(joint->along_angle), cases[i].x, 1e-15);
        CHECK_NEAR(sin(joint->along_angle), cases[i].y, 1e-15);
        assert_null(joint->along_expr);
        yk_model_free(model);
    }
}

static void a_direction_may_be_an_angle_and_is_a_unit_vector(void **state)
{
    (void)state;
    YkModel *model = load_joint("{slide: [ground, b], along: 30 deg + 0.1, turned: pi/2}");
    const YkJoint *joint = fixture_joint(model, "J");
    CHECK_NEAR(joint->along_angle, YK_PI / 6 + 0.1, 1e-16);
    CHECK_NEAR(joint->along.x, cos(YK_PI / 6 + 0.1), 1e-16);
    CHECK_NEAR(joint->along.y, sin(YK_PI / 6 + 0.1), 1e-16);
    CHECK_NEAR(joint->turned, YK_PI / 2, 0);
    assert_non_null(joint->along_expr);
    assert_non_null(joint->turned_expr);
    yk_model_free(model);
}

static void coordinates_know_their_joint_and_kind(void **state)
{
    (void)state;
    YkModel *model = load_joint("{pin-slot: [ground, b], angle: beta, distance: s}");
    const YkJoint *joint = fixture_joint(model, "J");
    const YkCoordinate *beta = fixture_coordinate(model, "beta"), *s = fixture_coordinate(model, "s");
    assert_ptr_equal(&model->joints[beta->joint], joint);
    assert_ptr_equal(&model->coordinates[joint->angle], beta);
    assert_ptr_equal(&model->coordinates[joint->distance], s);
    assert_false(beta->is_distance);
    assert_true(s->is_distance);
    assert_int_equal(model->coordinate_count, 2);
    yk_model_free(model);
}

static void a_free_joint_names_three_coordinates(void **state)
{
    (void)state;
    YkModel *model = load_joint("{free: [ground, b], at: [u, v, w]}");
    const YkJoint *joint = fixture_joint(model, "J");
    const YkCoordinate *u = fixture_coordinate(model, "u"), *v = fixture_coordinate(model, "v"),
                       *w = fixture_coordinate(model, "w");
    assert_true(u->is_distance && v->is_distance && !w->is_distance);
    assert_ptr_equal(&model->coordinates[joint->distance], v);
    assert_ptr_equal(&model->coordinates[joint->angle], w);
    assert_int_equal(u->joint, joint->partner);
    assert_int_equal(model->joints[joint->partner].body[0], 0);
    assert_true(model->bodies[joint->body[0]].is_carriage);
    assert_int_equal(yk_model_find_body(model, "J"), YK_NOT_FOUND);
    yk_model_free(model);
    model = load_joint("{free: [ground, b]}");
    fixture_coordinate(model, "J.x"), fixture_coordinate(model, "J.y"), fixture_coordinate(model, "J.angle");
    yk_model_free(model);
}

static void mistakes_in_a_free_joint_are_refused(void **state)
{
    (void)state;
    refused_joint("{free: [ground, b], at: [u, v]}", YK_CODE_COMPONENTS, 30, "three coordinates");
    refused_joint("{free: [ground, b], at: u}", YK_CODE_WRONG_KIND, 30, "at of `J`");
    refused_joint("{free: [ground, b], at: [u, u, w]}", YK_CODE_REPEATED_NAME, 34, "`u`");
    refused_joint("{free: [ground, b], at: [u, [v], w]}", YK_CODE_WRONG_KIND, 34, "at of `J`");
    refused_joint("{free: [ground, b], along: x}", YK_CODE_UNKNOWN_KEY, 26, "along");
    refused_joint("{free: [ground, ground]}", YK_CODE_SELF_JOINT, 13, "`ground` to itself");
    fixture_refused("bodies: {b: {}, c: {}}\njoints: {F: {free: [b, c]}}\n", YK_CODE_NOT_CONNECTED, 1, 10,
                    "`b` and `c` are not connected");
    refused_joint("{free: [ground, c]}", YK_CODE_UNKNOWN_BODY, 22, "`c`");
    refused_joint("{free: [ground, b], to: Z}", YK_CODE_UNKNOWN_POINT, 30, "`Z`");
    refused_joint("{free: [ground, b], angle: w}", YK_CODE_UNKNOWN_KEY, 26, "angle");
}

static void the_kind_of_a_joint_is_exactly_one_of_the_catalogue(void **state)
{
    (void)state;
    refused_joint("{hinge: [ground, b]}", YK_CODE_JOINT_KIND, 7, "pin, slide, pin-slot, weld or free");
    refused_joint("{pinn: [ground, b]}", YK_CODE_JOINT_KIND, 7, "did you mean `pin`");
    refused_joint("{}", YK_CODE_JOINT_KIND, 3, "is not declared");
    refused_joint("{pin: [ground, b], slide: [ground, b]}", YK_CODE_JOINT_KIND, 25, "already");
    refused_joint("[ground, b]", YK_CODE_WRONG_KIND, 6, "joint `J` must be a map");
    refused_joint("", YK_CODE_EMPTY_VALUE, 5, "joint `J`");
}

static void the_bodies_of_a_joint_are_two_different_ones(void **state)
{
    (void)state;
    refused_joint("{pin: [ground]}", YK_CODE_BODY_PAIR, 12, "here are 1");
    refused_joint("{pin: [ground, a, b]}", YK_CODE_BODY_PAIR, 12, "here are 3");
    refused_joint("{pin: ground}", YK_CODE_WRONG_KIND, 12, "must be a list");
    refused_joint("{pin: [a, a]}", YK_CODE_SELF_JOINT, 12, "`a` to itself");
    refused_joint("{pin: [grond, a]}", YK_CODE_UNKNOWN_BODY, 13, "did you mean `ground`");
    refused_joint("{pin: [[a], a]}", YK_CODE_WRONG_KIND, 13, "name of a body");
}

static void the_points_of_a_joint_are_on_both_bodies_or_on_neither(void **state)
{
    (void)state;
    refused_joint("{pin: [ground, a], at: A}", YK_CODE_POINT_ON_ONE_BODY, 29,
                  "`a` has the point `A`, but `ground` has not");
    refused_joint("{pin: [ground, a], at: AA}", YK_CODE_POINT_ON_NEITHER, 29, "did you mean `A`");
    refused_joint("{weld: [ground, b], at: P}", YK_CODE_POINT_ON_ONE_BODY, 30, "weld `J`");
    refused_joint("{slide: [ground, b], from: X}", YK_CODE_UNKNOWN_POINT, 33, "`ground` has no point `X`");
    refused_joint("{slide: [ground, b], to: P}", YK_CODE_UNKNOWN_POINT, 31, "`b` has no point `P`");
    refused_joint("{pin-slot: [ground, b], at: O}", YK_CODE_UNKNOWN_POINT, 34, "`b` has no point `O`");
    fixture_refused(HELD "  W: {pin: [ground, b]}\n", YK_CODE_POINT_ON_ONE_BODY, 5, 3, "add `W: [0, 0]`");
}

static void a_joint_takes_the_keys_of_its_kind_only(void **state)
{
    (void)state;
    refused_joint("{pin: [ground, b], along: x}", YK_CODE_UNKNOWN_KEY, 25, "pin `J` has no key `along`");
    refused_joint("{slot: [ground, b], along: x}", YK_CODE_JOINT_KIND, 7, "did you mean `pin-slot`?");
    refused_joint("{pin: [ground, b], turned: 3}", YK_CODE_UNKNOWN_KEY, 25, "turned");
    refused_joint("{slide: [ground, b], at: Q}", YK_CODE_UNKNOWN_KEY, 27, "at");
    refused_joint("{weld: [ground, b], friction: {}}", YK_CODE_UNKNOWN_KEY, 26, "friction");
    refused_joint("{pin: [ground, b], distance: s}", YK_CODE_COORDINATE_KIND, 25, "does not move along a line");
    refused_joint("{slide: [ground, b], angle: s}", YK_CODE_COORDINATE_KIND, 27, "does not turn");
    refused_joint("{weld: [ground, b], angle: s}", YK_CODE_COORDINATE_KIND, 26, "does not turn");
}

static void what_others_write_is_told_in_our_words(void **state)
{
    (void)state;
    refused_joint("{revolute: [ground, b]}", YK_CODE_JOINT_KIND, 7, "did you mean `pin`?");
    refused_joint("{pin: [ground.O, b]}", YK_CODE_UNKNOWN_BODY, 13, "name the body alone");
    fixture_refused(HELD "loads: {}\n", YK_CODE_UNKNOWN_KEY, 5, 1, "did you mean `forces`?");
    fixture_refused(HELD "title: x\n", YK_CODE_UNKNOWN_KEY, 5, 1, "did you mean `name`?");
}

static void a_coordinates_name_is_its_own(void **state)
{
    (void)state;
    refused_joint("{pin: [ground, b], angle: t}", YK_CODE_RESERVED_NAME, 32, "the time");
    refused_joint("{pin: [ground, b], angle: a-b}", YK_CODE_BAD_NAME, 32, NULL);
    refused_joint("{pin: [ground, b], angle: [x]}", YK_CODE_WRONG_KIND, 32, "angle of `J`");
    refused_joint("{pin-slot: [ground, b], angle: q, distance: q}", YK_CODE_REPEATED_NAME, 50, "line 5");
    fixture_refused("parameters: {q: 1}\n" HELD "  J: {pin: [ground, b], angle: q}\n", YK_CODE_REPEATED_NAME, 6, 32,
                    "parameter");
}

static void directions_and_turns_must_be_angles(void **state)
{
    (void)state;
    YkProblems *problems = fixture_refuse(HELD "  J: {slide: [ground, b], along: 3 mm, turned: 2 kg}\n");
    assert_int_equal(yk_problems_error_count(problems), 2);
    assert_int_equal(yk_problems_get(problems, 0)->place.line, 5);
    assert_int_equal(yk_problems_get(problems, 0)->place.column, 34);
    yk_problems_free(problems);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_joint_sits_at_the_points_named_or_at_the_origins),
        cmocka_unit_test(a_pin_in_a_slot_takes_its_own_name_for_the_point_of_b),
        cmocka_unit_test(directions_by_name_are_exact),
        cmocka_unit_test(a_direction_may_be_an_angle_and_is_a_unit_vector),
        cmocka_unit_test(coordinates_know_their_joint_and_kind),
        cmocka_unit_test(a_free_joint_names_three_coordinates),
        cmocka_unit_test(mistakes_in_a_free_joint_are_refused),
        cmocka_unit_test(the_kind_of_a_joint_is_exactly_one_of_the_catalogue),
        cmocka_unit_test(the_bodies_of_a_joint_are_two_different_ones),
        cmocka_unit_test(the_points_of_a_joint_are_on_both_bodies_or_on_neither),
        cmocka_unit_test(a_joint_takes_the_keys_of_its_kind_only),
        cmocka_unit_test(what_others_write_is_told_in_our_words),
        cmocka_unit_test(a_coordinates_name_is_its_own),
        cmocka_unit_test(directions_and_turns_must_be_angles),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
