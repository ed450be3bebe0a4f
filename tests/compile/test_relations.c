// Gears, racks, belts, cams and laws as relations: when they are solved, from what, and what is refused.
#include "check.h"
#include <yoke/yoke.h>
#include "solve/state.h"

typedef struct Made {
    YkProblems *problems;
    YkModel *model;
    YkMechanism *mech;
} Made;

static Made make(const char *text)
{
    Made m = {.problems = yk_problems_new()};
    m.model = yk_model_parse(text, strlen(text), "t.yaml", NULL, m.problems);
    if (!m.model) print_error("%s", yk_problems_text(m.problems, 0));
    assert_non_null(m.model);
    m.mech = yk_mechanism_compile(m.model, NULL, m.problems);
    return m;
}

static void drop(Made *m)
{
    yk_mechanism_free(m->mech);
    yk_model_free(m->model);
    yk_problems_free(m->problems);
}

static bool tells(const Made *m, const char *words)
{
    for (size_t k = 0; k < yk_problems_count(m->problems); k++)
        if (strstr(yk_problems_get(m->problems, k)->message, words)) return true;
    return false;
}

#define TRAIN                                                                                                          \
    "bodies: {ground: {points: {A: [0, 0], B: [3, 0], C: [7, 0]}}, a: {points: {A: [0, 0]}}, b: {points: {B: [0, "     \
    "0]}}, "                                                                                                           \
    "c: {points: {C: [0, 0]}}}\njoints: {A: {pin: [ground, a], angle: x}, B: {pin: [ground, b], angle: y}, "           \
    "C: {pin: [ground, c], angle: z}}\n"

static double value(const Made *m, YkState *state, const char *name)
{
    YkChannel channel;
    assert_int_equal(yk_channel_parse(m->mech, name, &channel, NULL), YK_OK);
    return yk_state_channel(state, channel);
}

static void a_train_is_sums_of_its_inputs(void **unused)
{
    (void)unused;
    Made m = make(
        TRAIN
        "gears: {p: {mesh: [a, b], teeth: [10, 20]}, q: {mesh: [b, c], teeth: [15, 25]}}\ndrives: {x: 3 rad/s * t}\n");
    assert_non_null(m.mech);
    assert_int_equal(m.mech->relation_count, 2);
    assert_int_equal(m.mech->reference_count, 0); // nothing has to be taken nearest to anything
    assert_int_equal(yk_mechanism_freedom(m.mech).gruebler, 1);
    YkState *state = yk_state_new(m.mech);
    assert_int_equal(yk_state_assemble(state), YK_OK);
    CHECK_NEAR(value(&m, state, "z.rate"), 3 * 0.5 * 0.6, 1e-15);
    yk_state_free(state);
    drop(&m);
}

static void any_wheel_may_be_the_input(void **unused)
{
    (void)unused;
    Made m = make(
        TRAIN
        "gears: {p: {mesh: [a, b], teeth: [10, 20]}, q: {mesh: [b, c], teeth: [15, 25]}}\ndrives: {z: 3 rad/s * t}\n");
    assert_non_null(m.mech);
    YkState *state = yk_state_new(m.mech);
    assert_int_equal(yk_state_assemble(state), YK_OK);
    CHECK_NEAR(value(&m, state, "x.rate"), 3 / (0.5 * 0.6), 1e-14);
    yk_state_free(state);
    drop(&m);
}

static void the_start_gives_the_phase(void **unused)
{
    (void)unused;
    Made m = make(
        TRAIN
        "gears: {p: {mesh: [a, b], teeth: [10, 20]}, q: {mesh: [b, c], teeth: [15, 25]}}\nstart: {x: 0.2, y: 0.7}\n");
    assert_non_null(m.mech);
    YkState *state = yk_state_new(m.mech);
    assert_int_equal(yk_state_assemble(state), YK_OK);
    CHECK_NEAR(value(&m, state, "x"), 0.2, 0);
    CHECK_NEAR(value(&m, state, "y"), 0.7, 1e-15);        // both are given: theirs
    CHECK_NEAR(value(&m, state, "z"), -0.7 * 0.6, 1e-15); // z is not: all 0 meets
    yk_state_free(state);
    drop(&m);
}

static void two_drives_on_one_train_are_too_many(void **unused)
{
    (void)unused;
    Made m = make(TRAIN "gears: {p: {mesh: [a, b], teeth: [10, 20]}, q: {mesh: [b, c], teeth: [15, 25]}}\ndrives: {x: "
                        "1 rad/s * t, z: 2 rad/s * t}\n");
    assert_null(m.mech);
    assert_true(tells(&m, "already fix it"));
    drop(&m);
}

static void a_law_drives_over_time(void **unused)
{
    (void)unused;
    Made m = make("laws: {l: {period: 2*pi, segments: [{rise: {to: pi, by: 2 rad, law: harmonic}}, {fall: {to: 2*pi, "
                  "by: 2 rad, law: harmonic}}]}}\n" TRAIN
                  "drives: {x: {law: l, of: 2 rad/s * t}, y: 1 rad/s * t, z: 1 rad/s * t}\n");
    assert_non_null(m.mech);
    YkState *state = yk_state_new(m.mech);
    double t = 0.3;
    assert_int_equal(yk_state_assemble(state), YK_OK);
    assert_int_equal(yk_state_set_time(state, t, NULL), YK_OK);
    assert_int_equal(yk_state_solve(state), YK_OK);
    CHECK_NEAR(value(&m, state, "x"), 1 - cos(2 * t), 1e-14);
    CHECK_NEAR(value(&m, state, "x.rate"), 2 * sin(2 * t), 1e-14);
    CHECK_NEAR(value(&m, state, "x.accel"), 4 * cos(2 * t), 1e-13);
    yk_state_free(state);
    drop(&m);
}

static void a_law_follows_a_coordinate(void **unused)
{
    (void)unused;
    Made m =
        make("laws: {l: {period: 2*pi, segments: [{rise: {to: pi, by: 2 rad, law: harmonic}}, {fall: {to: 2*pi, by: 2 "
             "rad, law: harmonic}}]}}\n" TRAIN "drives: {x: 3 rad/s * t + 0.4, y: {law: l, of: x}, z: 1 rad/s * t}\n");
    assert_non_null(m.mech);
    YkState *state = yk_state_new(m.mech);
    assert_int_equal(yk_state_assemble(state), YK_OK);
    CHECK_NEAR(value(&m, state, "y"), 1 - cos(0.4), 1e-14);
    CHECK_NEAR(value(&m, state, "y.rate"), 3 * sin(0.4), 1e-14);
    CHECK_NEAR(value(&m, state, "y.accel"), 9 * cos(0.4), 1e-13);
    yk_state_free(state);
    drop(&m);
}

// A wheel fixed to the rocker drives one on the coupler about their common pin: its angle comes from the loop's.
static void a_wheel_may_hang_on_what_loops_place(void **unused)
{
    (void)unused;
    Made m = make(
        "bodies:\n  ground: {points: {A: [0, 0], D: [3, 0]}}\n  a: {points: {A: [0, 0], B: [1, 0]}}\n"
        "  b: {points: {B: [0, 0], C: [3, 0]}}\n  c: {points: {C: [0, 0], D: [2, 0]}}\n  w: {points: {B: [0, 0]}}\n"
        "joints:\n  A: {pin: [ground, a], angle: x}\n  B: {pin: [a, b], angle: y}\n  D: {pin: [ground, c], angle: z}\n"
        "  C: {pin: [b, c]}\n  W: {pin: [b, w], at: B, angle: p}\n"
        "gears: {g: {mesh: [c, w], teeth: [20, 10], carrier: b}}\nstart: {y: -50 deg, z: 220 deg}\n"
        "drives: {x: 60 deg + 1 rad/s * t}\n");
    assert_non_null(m.mech);
    assert_true(m.mech->reference_count > 0);
    YkState *state = yk_state_new(m.mech);
    assert_true(yk_state_assemble(state) >= 0);
    double b = value(&m, state, "b.rate"), c = value(&m, state, "c.rate"), w = value(&m, state, "w.rate");
    CHECK_NEAR(20 * (c - b) + 10 * (w - b), 0, 1e-13);
    yk_state_free(state);
    drop(&m);
}

// Wheels on the second and the fourth link of a five-bar, their centres on the third: loop and mesh need each other.
static void a_loop_and_a_mesh_are_one_group(void **unused)
{
    (void)unused;
    Made m = make("bodies:\n  ground: {points: {A: [0, 0], E: [3, 0]}}\n  a: {points: {A: [0, 0], B: [1, 0]}}\n"
                  "  b: {points: {B: [-2.5, 0], C: [0, 0]}}\n  c: {points: {C: [0, 0], D: [2, 0]}}\n"
                  "  d: {points: {D: [0, 0], E: [2.2, 0]}}\njoints:\n  A: {pin: [ground, a], angle: w}\n"
                  "  B: {pin: [a, b], angle: x}\n  C: {pin: [b, c], angle: y}\n  D: {pin: [c, d], angle: z}\n"
                  "  E: {pin: [ground, d]}\ngears: {g: {mesh: [b, d], teeth: [20, 30], carrier: c}}\n"
                  "drives: {w: 60 deg + 1 rad/s * t}\nstart: {x: -30 deg, y: -60 deg, z: -60 deg}\n");
    assert_non_null(m.mech);
    assert_int_equal(m.mech->block_count, 1);
    assert_int_equal(m.mech->blocks[0].relation_count, 1);
    YkBlockInfo group = yk_block_info(m.mech, 0);
    assert_int_equal(group.unknowns, 3);
    assert_int_equal(group.equations, 3);
    YkState *state = yk_state_new(m.mech);
    assert_true(yk_state_assemble(state) >= 0);
    double phase = -20 * -60 + 30 * -60;        // of `start:`, in degrees
    for (int turn = 0; turn < 2 * 36; turn++) { // twice round: no tooth slips
        yk_state_set_input(state, 0, (YkMotion){YK_PI / 3 + turn * YK_PI / 18, 1, 0});
        assert_int_equal(yk_state_solve(state), YK_OK);
        yk_state_refer(state);
        double y = value(&m, state, "y"), z = value(&m, state, "z");
        CHECK_NEAR(30 * z - 20 * y, phase * YK_PI / 180, 1e-12);
        CHECK_NEAR(30 * value(&m, state, "z.rate") - 20 * value(&m, state, "y.rate"), 0, 1e-12);
        assert_true(yk_state_residuals(state).position < 1e-13);
    }
    yk_state_free(state);
    drop(&m);
}

// A third wheel between two in mesh repeats their ratio: fine where it is the same, no motion where it is not.
static void meshes_that_repeat_each_other_are_checked(void **unused)
{
    (void)unused;
    const char *const last[] = {"{mesh: [a, c], teeth: [10, 30], internal: true}", "{mesh: [a, c], teeth: [10, 31]}"};
    for (int k = 0; k < 2; k++) {
        char text[1000];
        snprintf(text, sizeof text,
                 "%sgears: {p: {mesh: [a, b], teeth: [10, 20]}, q: {mesh: [b, c], teeth: [20, 30]}, r: %s}\n", TRAIN,
                 last[k]);
        Made m = make(text);
        assert_non_null(m.mech);
        assert_int_equal(yk_mechanism_freedom(m.mech).by_rank, k == 0);
        assert_int_equal(yk_mechanism_freedom(m.mech).gruebler, 0);
        assert_int_equal(m.mech->redundant_relation_count, k == 0);
        YkState *state = yk_state_new(m.mech);
        assert_int_equal(yk_state_assemble(state), k == 0 ? YK_REDUNDANT : YK_OK);
        yk_state_free(state);
        drop(&m);
    }
}

// The phases of `start:` need not go together.
static void a_mesh_that_does_not_fit_is_told(void **unused)
{
    (void)unused;
    Made m = make(TRAIN "gears: {p: {mesh: [a, b], teeth: [10, 20]}, q: {mesh: [b, c], teeth: [20, 30]}, "
                        "r: {mesh: [a, c], teeth: [10, 30], internal: true}}\nstart: {x: 0.1, y: 0.3}\n");
    assert_non_null(m.mech);
    YkState *state = yk_state_new(m.mech);
    assert_int_equal(yk_state_assemble(state), YK_NO_ASSEMBLY);
    yk_state_free(state);
    drop(&m);
}

// The cam's follower is known: where on the cam that is, Newton's method finds.
static void a_law_is_solved_for_its_argument(void **unused)
{
    (void)unused;
    Made m =
        make("laws: {l: {period: 2*pi, segments: [{rise: {to: pi, by: 2 rad, law: harmonic}}, {fall: {to: 2*pi, by: 2 "
             "rad, law: harmonic}}]}}\n" TRAIN "drives: {y: {law: l, of: x}, z: 1 rad/s * t}\nstart: {y: 0.7, x: 1}\n");
    assert_non_null(m.mech);
    YkState *state = yk_state_new(m.mech);
    assert_int_equal(yk_state_assemble(state), YK_OK);
    CHECK_NEAR(value(&m, state, "x"), acos(1 - 0.7), 1e-14);
    yk_state_free(state);
    drop(&m);
}

static void a_law_follows_a_distance(void **unused)
{
    (void)unused;
    Made m = make("laws: {l: {table: [[0 m, 0 m], [2 m, 1 m], [4 m, 5 m]], between: linear}}\n"
                  "bodies: {a: {}, b: {}}\njoints: {S: {slide: [ground, a], along: x, distance: d}, "
                  "T: {slide: [a, b], along: y, distance: e}}\ndrives: {d: 1 m + 3 m/s * t, e: {law: l, of: d}}\n");
    assert_non_null(m.mech);
    YkState *state = yk_state_new(m.mech);
    assert_int_equal(yk_state_assemble(state), YK_OK);
    CHECK_NEAR(value(&m, state, "e"), 0.5, 1e-15);
    CHECK_NEAR(value(&m, state, "e.rate"), 1.5, 1e-15);
    yk_state_free(state);
    drop(&m);
}

// A rocker turns from where it stands at lift 0 by its cam's law, half of it in the middle of a rise or fall.
static void a_rocker_on_a_cam_turns_by_its_law(void **unused)
{
    (void)unused;
    static const double at[] = {0, 60, 120, 140, 160, 220, 280, 320, 420}, lift[] = {0, 10, 20, 20, 20, 10, 0, 0, 10};
    YkProblems *problems = yk_problems_new();
    YkModel *model = yk_model_load(YOKE_ROOT "/examples/swing-cam.yaml", NULL, problems);
    YkMechanism *mech = yk_mechanism_compile(model, NULL, problems);
    YkState *state = yk_state_new(mech);
    size_t phi = yk_coordinate_find(mech, "phi");
    yk_state_set_input(state, 0, (YkMotion){0, 1, 0});
    assert_int_equal(yk_state_assemble(state), YK_OK);
    double rest = yk_state_coordinate(state, phi).position;
    for (size_t k = 0; k < sizeof at / sizeof *at; k++) {
        yk_state_set_input(state, 0, (YkMotion){at[k] * YK_PI / 180, 1, 0});
        assert_int_equal(yk_state_solve(state), YK_OK);
        CHECK_NEAR(fabs(yk_state_coordinate(state, phi).position - rest), lift[k] * YK_PI / 180, 1e-13);
    }
    yk_state_free(state);
    yk_mechanism_free(mech);
    yk_model_free(model);
    yk_problems_free(problems);
}

// Whichever followers have left their cams, contacts keep their names, and the relations behind the others are theirs.
static void contacts_of_open_cams_have_no_relation(void **unused)
{
    (void)unused;
    static const char *const text =
        "laws: {lift: {period: 2*pi, segments: [{rise: {to: pi, by: 0.02 m, law: 3-4-5}},"
        " {fall: {to: 2*pi, by: 0.02 m, law: 3-4-5}}]}}\n"
        "cams:\n  c0: {cam: shaft, follower: f0, law: lift, roller: 0.01, base: 0.05}\n"
        "  c1: {cam: shaft, follower: f1, law: lift, roller: 0.01, base: 0.06}\n"
        "  c2: {cam: shaft, follower: f2, law: lift, roller: 0.01, base: 0.07}\n"
        "gears: {G: {mesh: [shaft, wheel], teeth: [20, 40]}}\n"
        "bodies: {shaft: {}, wheel: {}, f0: {}, f1: {}, f2: {}}\njoints:\n  O: {pin: [ground, shaft], angle: q}\n"
        "  W: {pin: [ground, wheel], angle: w}\n  T0: {slide: [ground, f0], along: y, distance: s0}\n"
        "  T1: {slide: [ground, f1], along: y, distance: s1}\n  T2: {slide: [ground, f2], along: y, distance: s2}\n"
        "drives: {q: 1 rad/s * t}\n";
    for (unsigned mask = 0; mask < 8; mask++) {
        Made m = make(text);
        const bool open[3] = {(mask & 1) != 0, (mask & 2) != 0, (mask & 4) != 0};
        YkCompileOptions options = {.open_cams = open};
        YkMechanism *mech = yk_mechanism_compile(m.model, &options, m.problems);
        assert_non_null(mech);
        assert_int_equal(yk_contact_count(mech), 4);
        for (size_t k = 0; k < 4; k++) {
            static const char *const names[] = {"G", "c0", "c1", "c2"};
            int32_t relation = yk_contact_relation(mech, k);
            assert_string_equal(yk_contact_name(mech, k), names[k]);
            assert_int_equal(relation == YK_NONE, k > 0 && open[k - 1]);
            if (relation != YK_NONE) assert_string_equal(mech->relations[relation].name, names[k]);
        }
        assert_int_equal(yk_mechanism_freedom(mech).by_rank, 1 + open[0] + open[1] + open[2]);
        yk_mechanism_free(mech);
        drop(&m);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_train_is_sums_of_its_inputs),
        cmocka_unit_test(any_wheel_may_be_the_input),
        cmocka_unit_test(the_start_gives_the_phase),
        cmocka_unit_test(two_drives_on_one_train_are_too_many),
        cmocka_unit_test(a_law_drives_over_time),
        cmocka_unit_test(a_law_follows_a_coordinate),
        cmocka_unit_test(a_wheel_may_hang_on_what_loops_place),
        cmocka_unit_test(a_loop_and_a_mesh_are_one_group),
        cmocka_unit_test(meshes_that_repeat_each_other_are_checked),
        cmocka_unit_test(a_mesh_that_does_not_fit_is_told),
        cmocka_unit_test(a_law_is_solved_for_its_argument),
        cmocka_unit_test(a_law_follows_a_distance),
        cmocka_unit_test(a_rocker_on_a_cam_turns_by_its_law),
        cmocka_unit_test(contacts_of_open_cams_have_no_relation),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
