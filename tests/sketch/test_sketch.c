// The parts that a machine lacks to move; adding them supplies what is missing.
#include "check.h"
#include <yoke/yoke.h>

static YkSketch *sketch_of(const char *text)
{
    YkProblems *problems = yk_problems_new();
    YkSketch *sketch = yk_sketch_parse(text, strlen(text), "test", NULL, problems);
    if (yk_problems_count(problems) > 0) print_error("%s", yk_problems_text(problems, 0));
    assert_non_null(sketch);
    assert_int_equal(yk_problems_count(problems), 0);
    yk_problems_free(problems);
    return sketch;
}

#define FOUR_BODIES                                                                                                    \
    "bodies: {ground: {points: {O: [0, 0], C: [4, 0]}}, crank: {points: {O: [0, 0], A: [1, 0]}},\n"                    \
    "  coupler: {points: {A: [0, 0], B: [3, 0]}}, rocker: {points: {C: [0, 0], B: [3, 0]}}}\n"

static void nothing_but_the_ground_lacks_a_body(void **state)
{
    (void)state;
    YkSketch *sketch = sketch_of("name: empty\n");
    assert_int_equal(yk_sketch_lack_count(sketch), 1);
    assert_int_equal(yk_sketch_lack(sketch, 0).kind, YK_LACK_BODY);
    assert_int_equal(yk_sketch_freedom(sketch), 0);
    assert_false(yk_sketch_moves(sketch));
    yk_sketch_free(sketch);
}

static void bodies_without_joints_float_with_three_freedoms_each(void **state)
{
    (void)state;
    YkSketch *sketch = sketch_of(FOUR_BODIES);
    assert_int_equal(yk_sketch_freedom(sketch), 9);
    assert_int_equal(yk_sketch_joint_count(sketch), 0);
    assert_int_equal(yk_sketch_lack_count(sketch), 3);
    YkLack lack = yk_sketch_lack(sketch, 0);
    assert_int_equal(lack.kind, YK_LACK_CONNECTION);
    assert_int_equal(lack.freedom, 3);
    assert_string_equal(yk_model_body_name(yk_sketch_model(sketch), lack.body), "crank");
    assert_string_equal(lack.text, "`crank` is not connected to the ground by joints");
    assert_string_equal(lack.mend, "`ground` and `crank` both have a point `O`: pin them, as in `joints: {O: {pin: "
                                   "[ground, crank]}}`");
    assert_string_equal(lack.path, "joints/O");
    assert_string_equal(lack.value, "{pin: [ground, crank]}");
    yk_sketch_free(sketch);
}

static void groups_are_told_once_with_all_their_bodies(void **state)
{
    (void)state;
    YkSketch *sketch = sketch_of("bodies: {a: {}, b: {points: {P: [0, 0]}}, c: {points: {P: [1, 0]}}, d: {}}\n"
                                 "joints: {O: {pin: [ground, a]}, P: {pin: [b, c]}, Q: {weld: [c, d]}}\n"
                                 "drives: {O.angle: 1 rad/s * t}\n");
    assert_int_equal(yk_sketch_lack_count(sketch), 2);
    YkLack lack = yk_sketch_lack(sketch, 0);
    assert_int_equal(lack.body_count, 3);
    assert_string_equal(lack.text, "`b` and 2 more bodies joined to it are not connected to the ground");
    assert_null(lack.path);
    lack = yk_sketch_lack(sketch, 1);
    assert_int_equal(lack.kind, YK_LACK_DRIVE);
    assert_string_equal(lack.path, "drives/P.angle");
    assert_int_equal(yk_sketch_freedom(sketch), 1 + 1 + 3);
    yk_sketch_free(sketch);
}

// A group that floats with a free joint in it, and a body that only a free joint ties to the ground.
static void free_joints_count_as_connections(void **state)
{
    (void)state;
    YkSketch *sketch = sketch_of("bodies: {a: {}, b: {}, c: {mass: 1, inertia: 1}, d: {}}\n"
                                 "joints: {F: {free: [a, b]}, G: {free: [ground, c]}}\n");
    assert_int_equal(yk_sketch_joint_count(sketch), 2);
    YkLack lack = yk_sketch_lack(sketch, 0);
    assert_int_equal(lack.kind, YK_LACK_CONNECTION);
    assert_int_equal(lack.body_count, 2);
    assert_string_equal(lack.text, "`a` and 1 more body joined to it are not connected to the ground");
    assert_string_equal(yk_sketch_lack(sketch, 1).text, "`d` is not connected to the ground by joints");
    assert_int_equal(yk_sketch_freedom(sketch), 3 + 3 + 3 + 3);
    yk_sketch_free(sketch);
}

static void open_ends_name_the_point_they_could_be_pinned_to(void **state)
{
    (void)state;
    YkSketch *sketch = sketch_of(FOUR_BODIES "joints: {O: {pin: [ground, crank]}, A: {pin: [crank, coupler]},\n"
                                             "  C: {pin: [ground, rocker]}}\ndrives: {O.angle: 1 rad/s * t}\n");
    size_t ends = 0, drives = 0;
    for (size_t i = 0; i < yk_sketch_lack_count(sketch); i++) {
        YkLack lack = yk_sketch_lack(sketch, i);
        drives += lack.kind == YK_LACK_DRIVE;
        if (lack.kind != YK_LACK_END) continue;
        ends++;
        assert_true(lack.is_optional);
        assert_string_equal(lack.path, "joints/B");
    }
    assert_int_equal(ends, 2);
    assert_int_equal(drives, 2);
    yk_sketch_free(sketch);
}

// The names of the ends of a sketch, in the order of its points: "crank.A, rod.B".
static void check_ends(const char *text, const char *expected)
{
    YkSketch *sketch = sketch_of(text);
    const YkModel *model = yk_sketch_model(sketch);
    char found[200] = "";
    for (size_t i = 0; i < yk_sketch_lack_count(sketch); i++) {
        YkLack lack = yk_sketch_lack(sketch, i);
        if (lack.kind != YK_LACK_END) continue;
        assert_int_equal(lack.body, yk_model_point_body(model, lack.point));
        snprintf(found + strlen(found), sizeof found - strlen(found), "%s%s.%s", *found ? ", " : "",
                 yk_model_body_name(model, lack.body), yk_model_point_name(model, lack.point));
    }
    assert_string_equal(found, expected);
    yk_sketch_free(sketch);
}

#define ARM "points: {O: [0, 0], A: [1, 0], B: [2, 0]}"
#define HELD "joints: {O: {pin: [ground, arm]}}\n"

static void what_something_uses_is_no_open_end(void **state)
{
    (void)state;
    check_ends("bodies: {ground: {points: {O: [0, 0]}}, arm: {" ARM "}}\n" HELD, "arm.A, arm.B");
    check_ends("bodies: {ground: {points: {O: [0, 0], F: [5, 0]}}, arm: {" ARM "}}\n" HELD
               "springs: {k: {between: [ground.F, arm.B], stiffness: 1, length: 1}}\n",
               "arm.A");
    check_ends("bodies: {ground: {points: {O: [0, 0]}}, arm: {" ARM "}}\n" HELD
               "forces: {f: {body: arm, at: A, value: [1, 0]}}\n",
               "arm.B");
    check_ends("laws: {swing: {period: 2*pi, segments: [{dwell: {to: 2*pi}}]}}\n"
               "bodies: {ground: {points: {O: [0, 0], K: [1, -1]}}, arm: {" ARM "}, shaft: {points: {K: [0, 0]}}}\n"
               "joints: {O: {pin: [ground, arm]}, K: {pin: [ground, shaft]}}\n"
               "cams: {c: {cam: shaft, follower: arm, law: swing, roller: 0.1, base: 0.9, at: A}}\n",
               "arm.B"); // at A is a roller
    check_ends("bodies: {ground: {points: {O: [0, 0]}}, arm: {" ARM ", mass: 1, inertia: 1}}\n" HELD, ""); // a pendulum
    check_ends("bodies: {ground: {points: {O: [0, 0]}}, arm: {" ARM "}, rod: {points: {A: [0, 0], C: [1, 0]}}}\n"
               "joints: {O: {pin: [ground, arm]}, A: {pin: [arm, rod]}}\n",
               "rod.C");                                                         // the arm is held by two
    check_ends("bodies: {ground: {points: {O: [0, 0]}}, arm: {" ARM "}}\n", ""); // held by none: it floats
}

// A joint has the point's name already: the pin is named after the body as well, and says at which point.
static void a_pin_whose_name_is_taken_gets_another(void **state)
{
    (void)state;
    YkSketch *sketch = sketch_of("bodies: {ground: {points: {O: [0, 0], C: [4, 0]}}, crank: {points: {O: [0, 0]}},\n"
                                 "  rocker: {points: {O: [0, 0]}}}\njoints: {O: {pin: [ground, crank]}}\n");
    YkLack lack = yk_sketch_lack(sketch, 0);
    assert_int_equal(lack.kind, YK_LACK_CONNECTION);
    assert_string_equal(lack.path, "joints/O-rocker");
    assert_string_equal(lack.value, "{pin: [ground, rocker], at: O}");
    assert_string_equal(lack.mend, "`ground` and `rocker` both have a point `O`: pin them, as in `joints: {O-rocker: "
                                   "{pin: [ground, rocker], at: O}}`");
    yk_sketch_free(sketch);
}

// Two bodies that a joint joins already are not pinned once more, whichever of them it names first.
static void bodies_that_are_joined_are_not_pinned_again(void **state)
{
    (void)state;
    static const char *const pins[] = {"[rod, other]", "[other, rod]"};
    for (size_t k = 0; k < 2; k++) {
        char text[400];
        snprintf(text, sizeof text,
                 "bodies: {ground: {points: {O: [0, 0]}}, crank: {points: {O: [0, 0], A: [1, 0]}},\n"
                 "  rod: {points: {A: [0, 0], D: [1, 0], B: [2, 0]}}, other: {points: {D: [0, 0], B: [1, 0]}}}\n"
                 "joints: {O: {pin: [ground, crank]}, A: {pin: [crank, rod]}, D: {pin: %s}}\n",
                 pins[k]);
        YkSketch *sketch = sketch_of(text);
        size_t ends = 0;
        for (size_t i = 0; i < yk_sketch_lack_count(sketch); i++) {
            YkLack lack = yk_sketch_lack(sketch, i);
            if (lack.kind != YK_LACK_END) continue;
            ends++;
            assert_string_equal(yk_model_body_name(yk_sketch_model(sketch), lack.body), "other");
            assert_null(lack.path); // B of `rod` is on a body to which it is joined
        }
        assert_int_equal(ends, 1);
        yk_sketch_free(sketch);
    }
}

// What holds a group that floats is no joint of the sketch.
static void an_open_end_of_a_group_that_floats_could_be_pinned_to_the_ground(void **state)
{
    (void)state;
    YkSketch *sketch = sketch_of("bodies: {ground: {points: {B: [4, 0]}}, a: {points: {A: [0, 0], B: [1, 0]}},\n"
                                 "  b: {points: {A: [0, 0]}}}\njoints: {A: {pin: [a, b]}}\n");
    size_t ends = 0;
    for (size_t i = 0; i < yk_sketch_lack_count(sketch); i++) {
        YkLack lack = yk_sketch_lack(sketch, i);
        if (lack.kind != YK_LACK_END) continue;
        ends++;
        assert_string_equal(yk_model_body_name(yk_sketch_model(sketch), lack.body), "a");
        assert_string_equal(lack.path, "joints/B");
        assert_string_equal(lack.value, "{pin: [ground, a]}");
    }
    assert_int_equal(ends, 1);
    yk_sketch_free(sketch);
}

static void masses_make_drives_optional(void **state)
{
    (void)state;
    YkSketch *sketch = sketch_of("bodies: {a: {mass: 1, inertia: 1}}\njoints: {O: {pin: [ground, a], angle: phi}}\n");
    assert_int_equal(yk_sketch_lack_count(sketch), 1);
    YkLack lack = yk_sketch_lack(sketch, 0);
    assert_true(lack.is_optional);
    assert_int_equal(lack.coordinate, yk_coordinate_find(yk_sketch_mechanism(sketch), "phi"));
    assert_string_equal(lack.text, "nothing drives `phi`: masses and loads move it");
    assert_true(yk_sketch_moves(sketch));
    yk_sketch_free(sketch);
}

static void a_frame_lacks_a_freedom(void **state)
{
    (void)state;
    YkSketch *sketch = sketch_of("bodies: {a: {points: {P: [1, 0]}}}\njoints: {O: {weld: [ground, a]}}\n");
    assert_int_equal(yk_sketch_lack(sketch, 0).kind, YK_LACK_FREEDOM);
    assert_int_equal(yk_sketch_freedom(sketch), 0);
    yk_sketch_free(sketch);
}

static void what_is_wrong_still_is(void **state)
{
    (void)state;
    static const char *const texts[] = {
        "bodies: {a: {points: {P: [1 kg, 0]}}}\n",
        "bodies: {a: {}}\njoints: {O: {pin: [ground, b]}}\n",
        "bodies: {a: {}}\njoints: {O: {pin: [ground, a], angle: q}, P: {pin: [ground, a]}}\ndrives: {q: 1 rad/s * t, "
        "r: 1 rad/s * t}\n",
        "body: {}\n",
    };
    for (size_t i = 0; i < sizeof texts / sizeof *texts; i++) {
        YkProblems *problems = yk_problems_new();
        assert_null(yk_sketch_parse(texts[i], strlen(texts[i]), "test", NULL, problems));
        assert_true(yk_problems_error_count(problems) > 0);
        yk_problems_free(problems);
    }
}

// From bodies alone, what is suggested first is added until the machine moves: it is the four-bar then.
static void what_would_mend_mends(void **state)
{
    (void)state;
    YkBuilder *b = yk_builder_new("four-bar");
    YkProblems *problems = yk_problems_new();
    yk_builder_set(b, "bodies",
                   "{ground: {points: {O: [0, 0], C: [4, 0]}}, crank: {points: {O: [0, 0], A: [1, 0]}}, "
                   "coupler: {points: {A: [0, 0], B: [3, 0]}}, rocker: {points: {C: [0, 0], B: [3, 0]}}}");
    int rounds = 0, last = 100;
    for (; rounds < 10; rounds++) {
        YkSketch *sketch = yk_sketch_build(b, NULL, problems);
        assert_non_null(sketch);
        size_t best = yk_sketch_lack_count(sketch);
        for (size_t i = yk_sketch_lack_count(sketch); i-- > 0;) // connections, then ends, then drives
            if (yk_sketch_lack(sketch, i).kind != YK_LACK_DRIVE) best = i;
        if (best == yk_sketch_lack_count(sketch)) best = 0;
        if (yk_sketch_moves(sketch)) {
            yk_sketch_free(sketch);
            break;
        }
        assert_true(yk_sketch_freedom(sketch) < last || yk_sketch_lack(sketch, best).kind == YK_LACK_DRIVE);
        last = yk_sketch_freedom(sketch);
        yk_builder_set(b, yk_sketch_lack(sketch, best).path, yk_sketch_lack(sketch, best).value);
        yk_sketch_free(sketch);
    }
    assert_int_equal(rounds, 5); // four pins and a drive
    YkModel *model = yk_builder_model(b, NULL, problems);
    YkMechanism *mech = model ? yk_mechanism_compile(model, NULL, problems) : NULL;
    assert_non_null(mech);
    assert_int_equal(yk_mechanism_freedom(mech).by_rank, 1);
    assert_int_equal(yk_mechanism_freedom(mech).driven, 1);
    yk_mechanism_free(mech);
    yk_model_free(model);
    yk_problems_free(problems);
    yk_builder_free(b);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(nothing_but_the_ground_lacks_a_body),
        cmocka_unit_test(bodies_without_joints_float_with_three_freedoms_each),
        cmocka_unit_test(groups_are_told_once_with_all_their_bodies),
        cmocka_unit_test(free_joints_count_as_connections),
        cmocka_unit_test(open_ends_name_the_point_they_could_be_pinned_to),
        cmocka_unit_test(what_something_uses_is_no_open_end),
        cmocka_unit_test(a_pin_whose_name_is_taken_gets_another),
        cmocka_unit_test(bodies_that_are_joined_are_not_pinned_again),
        cmocka_unit_test(an_open_end_of_a_group_that_floats_could_be_pinned_to_the_ground),
        cmocka_unit_test(masses_make_drives_optional),
        cmocka_unit_test(a_frame_lacks_a_freedom),
        cmocka_unit_test(what_is_wrong_still_is),
        cmocka_unit_test(what_would_mend_mends),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
