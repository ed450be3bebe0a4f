// The graph: orientations, the spanning tree that follows the file's coordinates, and loops that agree with the bodies.
#include "compile/topology.h"
#include "machine.h"
#include "table.h"

enum { TEXT_MAX = 8000, BODIES_MAX = 12 };

// --- the tree
// -----------------------------------------------------------------------------------------------------------

static bool in_tree(const YkMechanism *mech, size_t joint)
{
    const YkJoint *j = &mech->model->joints[joint];
    return mech->tree.joint[j->body[0]] == (int32_t)joint || mech->tree.joint[j->body[1]] == (int32_t)joint;
}

static void check_tree(const YkMechanism *mech)
{
    const YkModel *model = mech->model;
    size_t branches = 0, coordinates = 0;
    for (size_t b = 1; b < model->body_count; b++) { // every body is attached to another by a joint of both
        const YkJoint *j = &model->joints[mech->tree.joint[b]];
        int32_t up = mech->tree.parent[b];
        assert_true((j->body[0] == (int32_t)b && j->body[1] == up) || (j->body[1] == (int32_t)b && j->body[0] == up));
        assert_int_equal(mech->tree.depth[b], mech->tree.depth[up] + 1);
    }
    for (size_t j = 0; j < model->joint_count; j++) {
        const YkJoint *joint = &model->joints[j];
        bool is_declared = joint->angle >= 0 || joint->distance >= 0;
        if (is_declared) assert_true(in_tree(mech, j));
        if (!in_tree(mech, j)) continue;
        branches++;
        coordinates += (size_t)yk_part(joint->kind)->turns + (size_t)yk_part(joint->kind)->slides;
    }
    assert_int_equal(branches, model->body_count - 1);
    assert_int_equal(mech->coordinate_count, coordinates);
    assert_int_equal(mech->loop_count, model->joint_count - branches);
    for (size_t k = 1; k < mech->coordinate_count; k++) { // file order; a pin-slot's angle before its distance
        const YkTreeCoordinate *a = &mech->coordinates[k - 1], *b = &mech->coordinates[k];
        assert_true(a->joint < b->joint || (a->joint == b->joint && !a->is_distance && b->is_distance));
    }
    for (size_t l = 1; l < mech->loop_count; l++) assert_true(mech->loops[l - 1].joint < mech->loops[l].joint);
}

static void trees_of_known_machines_span_and_follow_the_file(void **state)
{
    (void)state;
    for (size_t k = 0; k < MACHINES; k++) {
        Machine m = machine(machines[k].source);
        check_tree(m.mech);
        machine_free(&m);
    }
}

static int32_t root_of(int32_t *up, int32_t b)
{
    while (up[b] != b) b = up[b];
    return b;
}

// A random connected machine of pins, slides, pin-slots and welds, in which a random forest has names.
static void random_text(uint64_t *seed, char *text, bool *closes_loop)
{
    static const char *const kinds[] = {"pin", "slide", "pin-slot", "weld"};
    int32_t forest[BODIES_MAX];
    size_t bodies = 2 + (size_t)(check_random(seed) % (BODIES_MAX - 2)), extra = (size_t)(check_random(seed) % 5),
           n = 0;
    n += (size_t)snprintf(text, TEXT_MAX, "bodies:\n");
    for (size_t b = 1; b < bodies; b++) n += (size_t)snprintf(text + n, TEXT_MAX - n, "  b%zu: {}\n", b);
    n += (size_t)snprintf(text + n, TEXT_MAX - n, "joints:\n");
    for (size_t b = 0; b < bodies; b++) forest[b] = (int32_t)b;
    *closes_loop = false;
    for (size_t j = 0; j < bodies - 1 + extra; j++) {
        int32_t b = j < bodies - 1 ? (int32_t)j + 1 : (int32_t)(check_random(seed) % bodies), a;
        do a = (int32_t)(check_random(seed) % (j < bodies - 1 ? j + 1 : bodies));
        while (a == b);
        bool turned_round = check_random(seed) % 2, names = check_random(seed) % 3 == 0;
        if (turned_round) {
            int32_t c = a;
            a = b;
            b = c;
        }
        size_t kind = (size_t)(check_random(seed) % 8);
        kind = kind < 5 ? 0 : kind - 4;
        if (j >= bodies - 1 && kind != 2) kind = 0; // slides and welds on the tree only: they cannot contradict
        char first[16] = "ground", second[16] = "ground", name[40] = "";
        if (a > 0) snprintf(first, sizeof first, "b%d", a);
        if (b > 0) snprintf(second, sizeof second, "b%d", b);
        if (names && kind != 3) {
            snprintf(name, sizeof name, ", %s: q%zu", kind == 0 ? "angle" : "distance", j);
            int32_t p = root_of(forest, a), q = root_of(forest, b);
            *closes_loop = *closes_loop || p == q;
            forest[p] = q;
        }
        n += (size_t)snprintf(text + n, TEXT_MAX - n, "  J%zu: {%s: [%s, %s]%s%s}\n", j, kinds[kind], first, second,
                              kind == 1 || kind == 2 ? ", along: 0.3" : "", name);
    }
}

// Only the graph: such machines need not close.
static bool topology(YkMechanism *mech, const YkModel *model, YkProblems *problems)
{
    YkIncidence incidence;
    *mech = (YkMechanism){.model = model, .size = model->size, .arena = yk_arena_new()};
    return yk_incidence_build(&incidence, mech->arena, model) && yk_topology_orientations(mech, &incidence, problems) &&
           yk_topology_tree(mech, &incidence, problems);
}

static void random_trees_hold_every_named_coordinate_unless_names_close_a_loop(void **state)
{
    (void)state;
    uint64_t seed = 31;
    size_t refused = 0, taken = 0;
    for (int trial = 0; trial < 1500; trial++) {
        char text[TEXT_MAX];
        bool closes_loop;
        YkMechanism mech;
        random_text(&seed, text, &closes_loop);
        YkProblems *problems = yk_problems_new();
        YkModel *model = yk_model_parse(text, strlen(text), "random.yaml", NULL, problems);
        if (!model) print_error("trial %d of seed 31\n%s%s", trial, text, yk_problems_text(problems, 0));
        assert_non_null(model);
        bool ok = topology(&mech, model, problems);
        if (ok == closes_loop) print_error("trial %d of seed 31\n%s%s", trial, text, yk_problems_text(problems, 0));
        assert_int_equal(ok, !closes_loop);
        if (ok) check_tree(&mech);
        if (!ok)
            assert_int_equal(yk_problems_get(problems, yk_problems_count(problems) - 1)->code,
                             YK_CODE_COORDINATE_CLOSES_LOOP);
        *(ok ? &taken : &refused) += 1;
        free(mech.terms);
        yk_arena_free(mech.arena);
        yk_model_free(model);
        yk_problems_free(problems);
    }
    assert_true(taken > 300 && refused > 30); // both were tried
}

static void a_named_coordinate_that_closes_a_loop_is_reported_where_it_stands(void **state)
{
    (void)state;
    machine_refused(
        "bodies:\n  ground: {points: {O: [0, 0], Q: [4, 0]}}\n" LINK("a", "O", "A", "1") LINK("b", "A", "B", "3.5")
            LINK("c", "Q", "B", "3") "joints: {O: {pin: [ground, a], angle: p}, A: {pin: [a, b], angle: q}, B: {pin: "
                                     "[b, c], angle: r}, Q: {pin: [ground, c], angle: s}}\n",
        NULL, YK_CODE_COORDINATE_CLOSES_LOOP, "closes a loop of joints that all have coordinates");
    // a slide has no angle to ask for
    machine_refused(
        "bodies:\n  ground: {points: {O: [0, 0], Q: [4, 0]}}\n" LINK("a", "O", "A", "1") "  b: {}\n" LINK(
            "c", "Q", "B", "3") "joints: {O: {pin: [ground, a], angle: p}, S: {slide: [a, b], along: x, distance: s}, "
                                "Q: {pin: [ground, c], angle: q}, B: {slide: [c, b], along: y, distance: d}}\n",
        NULL, YK_CODE_COORDINATE_CLOSES_LOOP, "`S.distance`");
}

static void undeclared_trees_are_shallow(void **state)
{
    (void)state;
    Machine m = machine(undeclared); // O - crank, Q - rocker, and one of A, B
    char text[200];
    describe_coordinates(m.mech, text, sizeof text);
    assert_string_equal(text, "O.angle, A.angle, Q.angle");
    assert_int_equal(yk_loop_joint(m.mech, 0), 2);
    machine_free(&m);
}

// --- loops
// --------------------------------------------------------------------------------------------------------------

static void loop_sums_are_the_first_bodys_point_minus_the_seconds(void **state)
{
    (void)state;
    uint64_t seed = 32;
    for (size_t k = 0; k < MACHINES; k++) {
        Machine m = machine(machines[k].source);
        size_t n = yk_variable_count(m.mech), loops = yk_loop_count(m.mech);
        double *x = calloc(n + 1, sizeof *x), *residual = calloc(2 * loops + 1, sizeof *residual);
        Pose pose = pose_new(m.model);
        for (int trial = 0; trial < 20; trial++) {
            random_variables(m.mech, &seed, x);
            pose_from_variables(m.mech, x, n, 0, &pose);
            yk_closure(m.mech, x, residual, NULL);
            for (size_t l = 0; l < loops; l++) {
                Vector gap = loop_gap(m.mech, &pose, l);
                CHECK_NEAR(residual[2 * l], creal(gap.x), 1e-13 * m.mech->size);
                CHECK_NEAR(residual[2 * l + 1], creal(gap.y), 1e-13 * m.mech->size);
            }
        }
        pose_free(&pose);
        free(x);
        free(residual);
        machine_free(&m);
    }
}

// --- orientations
// -------------------------------------------------------------------------------------------------------

static size_t orientation_of(const Machine *m, const char *body)
{
    return (size_t)m->mech->bodies[yk_model_find_body(m->model, body)].orientation;
}
static double turn_of(const Machine *m, const char *body)
{
    return m->mech->bodies[yk_model_find_body(m->model, body)].turn;
}

static void slides_and_welds_share_an_orientation_and_add_their_turns(void **state)
{
    (void)state;
    Machine m = machine("units: {angle: deg}\n"
                        "bodies: {a: {}, b: {}, c: {}, d: {}}\n"
                        "joints:\n"
                        "  P: {pin: [ground, a]}\n"
                        "  S: {slide: [a, b], along: x, turned: 20}\n"
                        "  W: {weld: [c, b], turned: 50}\n" // b is turned 50 against c: c stands at -30
                        "  K: {pin-slot: [ground, d], along: y}\n");
    assert_int_equal(m.mech->orientation_count, 3);
    assert_int_equal(orientation_of(&m, "ground"), 0);
    assert_int_equal(orientation_of(&m, "a"), orientation_of(&m, "b"));
    assert_int_equal(orientation_of(&m, "a"), orientation_of(&m, "c"));
    assert_true(orientation_of(&m, "d") != orientation_of(&m, "a") && orientation_of(&m, "d") != 0);
    CHECK_NEAR(turn_of(&m, "b") - turn_of(&m, "a"), 20 * YK_PI / 180, 1e-15);
    CHECK_NEAR(turn_of(&m, "c") - turn_of(&m, "a"), -30 * YK_PI / 180, 1e-15);
    CHECK_NEAR(turn_of(&m, "ground"), 0, 0);
    CHECK_NEAR(turn_of(&m, "d"), 0, 0);
    assert_int_equal(m.mech->distance_count, 2);
    machine_free(&m);
}

#define RING_OF_SLIDES(turned)                                                                                         \
    "bodies: {ground: {}, a: {}, b: {}}\n"                                                                             \
    "joints: {S: {slide: [ground, a], along: x, turned: 100 deg}, T: {slide: [a, b], along: y, turned: 200 deg}, U: "  \
    "{slide: [b, ground], along: 0.3, turned: " turned "}}\n"

static void turns_round_a_loop_must_add_up_to_whole_turns(void **state)
{
    (void)state;
    Machine m = machine(RING_OF_SLIDES("60 deg")); // 360 in all
    assert_int_equal(m.mech->orientation_count, 1);
    machine_free(&m);
    machine_refused(RING_OF_SLIDES("61 deg"), NULL, YK_CODE_TURNS_DISAGREE, "allow");
    machine_refused(RING_OF_SLIDES("60.00001 deg"), NULL, YK_CODE_TURNS_DISAGREE, "`turned:`");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(trees_of_known_machines_span_and_follow_the_file),
        cmocka_unit_test(random_trees_hold_every_named_coordinate_unless_names_close_a_loop),
        cmocka_unit_test(a_named_coordinate_that_closes_a_loop_is_reported_where_it_stands),
        cmocka_unit_test(undeclared_trees_are_shallow),
        cmocka_unit_test(loop_sums_are_the_first_bodys_point_minus_the_seconds),
        cmocka_unit_test(slides_and_welds_share_an_orientation_and_add_their_turns),
        cmocka_unit_test(turns_round_a_loop_must_add_up_to_whole_turns),
    };
    return cmocka_run_group_tests_name("compile/topology", tests, NULL, NULL);
}
