// A lock that is engaged adds what it says and no more: a drive that stands still for each coordinate that it holds,
// one tie for each pair of bodies whose turns have no name; and it says what it cannot hold.
#include "fixture.h"

#define GEARS                                                                                                          \
    "bodies: {sun: {}, ring: {}, arm: {points: {P: [0.3, 0]}}, planet: {points: {P: [0, 0]}}, bar: {}}\n"              \
    "joints: {S: {pin: [ground, sun], angle: s}, R: {pin: [ground, ring]}, C: {pin: [ground, arm], angle: c},\n"       \
    "  P: {pin: [arm, planet]}, B: {slide: [ground, bar], along: x, distance: d}, E: {slide: [arm, bar], along: y}}\n"

static YkModel *engaged(const char *lock)
{
    static char text[60000];
    snprintf(text, sizeof text, "%slocks: {l: %s}\nstart: {c: 30 deg, d: 0.5}\n", GEARS, lock);
    return fixture_load_with(text, &(YkLoadOptions){.lock = "l"});
}

static void check_counts(const char *lock, size_t drives, size_t ties)
{
    YkModel *model = engaged(lock);
    if (model->drive_count != drives || model->belt_count != ties) print_error("%s\n", lock);
    assert_int_equal(model->drive_count, drives);
    assert_int_equal(model->belt_count, ties);
    for (size_t k = 0; k < drives; k++) {
        const YkDrive *drive = &model->drives[k];
        YkJet jet;
        const char *name = model->coordinates[drive->coordinate].name;
        assert_true(drive->is_hold);
        assert_int_equal(model->coordinates[drive->coordinate].drive, k);
        assert_int_equal(yk_model_drive(model, k, 17, &jet, NULL), YK_OK);
        CHECK_NEAR(jet.d[0], strcmp(name, "c") == 0 ? 0.52359877559829887 : 0.5, 1e-16); // where it starts
        CHECK_NEAR(jet.d[1], 0, 0);
    }
    for (size_t k = 0; k < ties; k++) {
        const YkBelt *tie = &model->belts[k];
        assert_true(tie->is_lock && !tie->is_crossed && tie->body[0] != tie->body[1]);
        CHECK_NEAR(tie->radius[0], tie->radius[1], 0);
        assert_string_equal(tie->name, "l");
    }
    yk_model_free(model);
}

static void named_freedoms_are_driven_and_unnamed_turns_tied(void **state)
{
    (void)state;
    check_counts("[c]", 1, 0);
    check_counts("[arm]", 1, 0);    // its joint with the ground has the coordinate c
    check_counts("[arm, c]", 1, 0); // held already
    check_counts("[ring]", 0, 1);   // its turn has no name
    check_counts("[planet]", 0, 1); // no joint with the ground
    check_counts("[bar]", 1, 0);    // d
    check_counts("[arm, ring]", 1, 1);
    check_counts("{join: [[arm, planet]]}", 0, 1);
    check_counts("{join: [[sun, planet]]}", 0, 1);
    check_counts("{hold: [c], join: [[sun, ring], [ring, planet]]}", 1, 2);
    check_counts("[]", 0, 0);
}

// A body that floats has three coordinates in one joint, to the ground or to another body, in either order.
static void floating_bodies_are_held_with_all_three_coordinates(void **state)
{
    (void)state;
    static const char *const locks[] = {"[puck]", "{join: [[plate, table]]}", "{join: [[table, plate]]}",
                                        "{hold: [a, b, c]}"};
    static const char *const names[][3] = {{"x", "y", "u"}, {"a", "b", "c"}, {"a", "b", "c"}, {"a", "b", "c"}};
    for (size_t k = 0; k < sizeof locks / sizeof *locks; k++) {
        char text[1000];
        snprintf(text, sizeof text,
                 "bodies: {table: {}, puck: {}, plate: {}}\njoints: {T: {pin: [ground, table], angle: s},\n"
                 "  F: {free: [ground, puck], at: [x, y, u]}, G: {free: [table, plate], at: [a, b, c]}}\n"
                 "start: {x: 0.1, y: 0.2, u: 0.3, a: 0.1, b: 0.2, c: 0.3}\nlocks: {l: %s}\n",
                 locks[k]);
        YkModel *model = fixture_load_with(text, &(YkLoadOptions){.lock = "l"});
        assert_int_equal(model->drive_count, 3);
        assert_int_equal(model->belt_count, 0);
        for (size_t i = 0; i < 3; i++) {
            int32_t drive = fixture_coordinate(model, names[k][i])->drive;
            YkJet jet;
            assert_true(drive != YK_NONE && model->drives[drive].is_hold);
            assert_int_equal(yk_model_drive(model, (size_t)drive, 5, &jet, NULL), YK_OK);
            CHECK_NEAR(jet.d[0], 0.1 * (double)(i + 1), 1e-16);
        }
        yk_model_free(model);
    }
}

// Of bodies with many joints between them the turn is tied once; a file may name a body thousands of times.
static void a_body_named_often_makes_a_tie_each_time_and_no_more(void **state)
{
    (void)state;
    static char text[60000];
    strcpy(text,
           "bodies: {ground: {points: {A: [0, 0], B: [1, 0], C: [2, 0]}}, a: {points: {A: [0, 0], B: [1, 0], C: [2, "
           "0]}}}\njoints: {A: {pin: [ground, a]}, B: {pin: [ground, a]}, C: {pin: [ground, a]}}\nlocks: {l: [a");
    for (int k = 1; k < 5000; k++) strcat(text, ", a");
    strcat(text, "]}\n");
    YkModel *model = fixture_load_with(text, &(YkLoadOptions){.lock = "l"});
    assert_int_equal(model->belt_count, 5000);
    assert_int_equal(model->drive_count, 0);
    yk_model_free(model);
}

static void refused(const char *sections, const char *lock, int code, const char *part, const char *hint)
{
    char text[2000];
    snprintf(text, sizeof text, "%s%s", GEARS, sections);
    YkProblems *problems = fixture_refuse_with(text, &(YkLoadOptions){.lock = lock});
    const YkProblem *problem = fixture_problem(problems, code);
    if (!problem || !strstr(problem->message, part)) print_error("%s", yk_problems_text(problems, 0));
    assert_non_null(problem);
    assert_non_null(strstr(problem->message, part));
    if (hint) assert_non_null(problem->hint);
    if (hint) assert_string_equal(problem->hint, hint);
    assert_int_equal(yk_problems_error_count(problems), 1);
    yk_problems_free(problems);
}

static void what_cannot_be_held_is_said(void **state)
{
    (void)state;
    refused("locks: {l: [s], m: [c]}", "x", YK_CODE_UNKNOWN_LOCK, "the model has no lock `x`", "it has `l`, `m`");
    refused("locks: {l: [s]}\nstart: {s: 0}\ndrives: {s: 1 rad/s * t}", "l", YK_CODE_BAD_LOCK,
            "lock `l` holds `s`, which is driven", NULL);
    refused("locks: {l: [c.rate]}", "l", YK_CODE_RATE_NOT_HERE, "`c.rate` is a rate; the coordinate itself is expected",
            NULL);
    refused("locks: {l: [s]}", "l", YK_CODE_BAD_LOCK, "lock `l` holds `s`, but nothing says where",
            "give `s` a value under `start:`");
    refused("locks: {l: {join: [[arm, bar]]}}", "l", YK_CODE_BAD_LOCK, "lock `l` holds what slides in joint `E`",
            "name it at the joint by `distance:`");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(named_freedoms_are_driven_and_unnamed_turns_tied),
        cmocka_unit_test(floating_bodies_are_held_with_all_three_coordinates),
        cmocka_unit_test(a_body_named_often_makes_a_tie_each_time_and_no_more),
        cmocka_unit_test(what_cannot_be_held_is_said),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
