// Keys that kinematics does not compute with are read, checked and noted; those that would change the motion are
// refused.
#include "model/fixture.h"

#define MACHINE                                                                                                        \
    "parameters: {F: 100, mu: 0.1}\n"                                                                                  \
    "bodies: {ground: {points: {P: [0, 0]}}, ram: {points: {C: [1, 0]}}}\n"                                            \
    "joints: {O: {pin: [ground, ram], angle: phi}}\n"

static void check_notes(const char *text, size_t notes)
{
    YkProblems *problems = yk_problems_new();
    YkModel *model = yk_model_parse(text, strlen(text), "test", NULL, problems);
    if (!model || yk_problems_count(problems) != notes) print_error("%s\n%s", text, yk_problems_text(problems, 0));
    assert_non_null(model);
    assert_int_equal(yk_problems_count(problems), notes);
    for (size_t i = 0; i < notes; i++) {
        assert_int_equal(yk_problems_get(problems, i)->code, YK_CODE_NOT_USED);
        assert_int_equal(yk_problems_get(problems, i)->severity, YK_NOTE);
        assert_true(yk_problems_get(problems, i)->place.line > 0);
    }
    yk_model_free(model);
    yk_problems_free(problems);
}

static void forces_springs_stops_and_friction_load_with_a_note_each(void **state)
{
    (void)state;
    check_notes(MACHINE
                "forces: {F1: {on: ram, at: C, value: [-F, 0]}, F2: {on: ram, value: [0, F*sin(phi)], axes: body}}\n",
                1);
    check_notes(MACHINE
                "springs: {k1: {between: [ground.P, ram.C], stiffness: 800 N/m, length: 0.2 m, damping: 5 N*s/m}}\n",
                1);
    check_notes(MACHINE "springs: {k2: {along: phi, stiffness: 3 N*m, damping: 1 N*m*s, angle: 30 deg}}\n", 1);
    check_notes(MACHINE "stops: {phi: [-30 deg, 200 deg]}\n", 1);
    check_notes(MACHINE "forces: {}\nsprings:\nstops: {}\n", 0);
    check_notes("bodies: {a: {}, b: {}}\njoints: {O: {pin: [ground, a], friction: {coulomb: 0.1, radius: 8 mm}}, "
                "A: {slide: [a, b], friction: {viscous: 2 N*s/m}}}\n",
                1);
}

static void refused(const char *section, int code, unsigned column, const char *part)
{
    char text[600];
    snprintf(text, sizeof text, MACHINE "%s\n", section);
    fixture_refused(text, code, 4, column, part);
}

static void mistakes_in_forces_are_refused(void **state)
{
    (void)state;
    refused("forces: {F1: {on: rom, value: [0, 0]}}", YK_CODE_UNKNOWN_BODY, 19, "did you mean `ram`");
    refused("forces: {F1: {on: ram, at: D, value: [0, 0]}}", YK_CODE_UNKNOWN_POINT, 28, "`D`");
    refused("forces: {F1: {on: ram}}", YK_CODE_MISSING_KEY, 14, "force `F1` needs `value`");
    refused("forces: {F1: {value: [0, 0]}}", YK_CODE_MISSING_KEY, 14, "`on`");
    refused("forces: {F1: {on: ram, value: [0, 0, 0]}}", YK_CODE_COMPONENTS, 31, "F1");
    refused("forces: {F1: {on: ram, value: [0, z]}}", YK_CODE_UNKNOWN_NAME, 35, "`z`");
    refused("forces: {F1: {on: ram, value: [0, 0], axes: local}}", YK_CODE_WRONG_WORD, 45, "local");
    refused("forces: {F1: {on: ram, value: [0, 0], axis: body}}", YK_CODE_UNKNOWN_KEY, 39, "axes");
    refused("forces: {F1: 3}", YK_CODE_WRONG_KIND, 14, "force `F1`");
}

static void mistakes_in_springs_and_stops_are_refused(void **state)
{
    (void)state;
    refused("springs: {k: {between: [ground.P, ram.D]}}", YK_CODE_UNKNOWN_POINT, 35, "`D`");
    refused("springs: {k: {between: [ground.P, rm.C]}}", YK_CODE_UNKNOWN_BODY, 35, "`rm`");
    refused("springs: {k: {between: [P, ram.C]}}", YK_CODE_UNKNOWN_POINT, 25, "ground.P");
    refused("springs: {k: {between: [ram.C]}}", YK_CODE_COMPONENTS, 24, "two points");
    refused("springs: {k: {stiffness: 3 N/m}}", YK_CODE_MISSING_KEY, 14, "between");
    refused("springs: {k: {along: psi}}", YK_CODE_UNKNOWN_COORDINATE, 22, "psi");
    refused("stops: {psi: [0, 1]}", YK_CODE_UNKNOWN_COORDINATE, 9, "psi");
    refused("stops: {phi: [0]}", YK_CODE_COMPONENTS, 14, "two ends");
    refused("stops: {phi: 3}", YK_CODE_WRONG_KIND, 14, "stop of `phi`");
}

static void what_would_change_the_motion_is_refused_at_its_key(void **state)
{
    (void)state;
    const char *keys[] = {"gears", "racks", "belts", "cams", "laws", "locks"};
    for (size_t i = 0; i < 6; i++) {
        char section[60];
        snprintf(section, sizeof section, "%s: {a: {b: c}}", keys[i]);
        refused(section, YK_CODE_NOT_SUPPORTED, 1, keys[i]);
    }
}

static void a_gear_explains_a_point_that_is_on_one_body_only(void **state)
{
    (void)state;
    fixture_refused("bodies: {arm: {points: {P: [1, 0]}}, planet: {}}\n"
                    "joints: {O: {pin: [ground, arm]}, P: {pin: [arm, planet]}}\ngears: {g: {}}\n",
                    YK_CODE_NOT_SUPPORTED, 3, 1, "gears");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(forces_springs_stops_and_friction_load_with_a_note_each),
        cmocka_unit_test(mistakes_in_forces_are_refused),
        cmocka_unit_test(mistakes_in_springs_and_stops_are_refused),
        cmocka_unit_test(what_would_change_the_motion_is_refused_at_its_key),
        cmocka_unit_test(a_gear_explains_a_point_that_is_on_one_body_only),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
