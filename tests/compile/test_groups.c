// Groups that remain after peeling dyads: their order, in which each needs only earlier ones, and their Assur class.
#include "machine.h"
#include "table.h"

// The awkward Stephenson: three arms on a ternary link, driven by its output. Names end in `k`; `drive` holds the
// output's angle.
static size_t add_bodies(char *text, size_t capacity, const char *k, const char *output)
{
    return (size_t)snprintf(
        text, capacity,
        "  crank%s: {points: {P%s: [0, 0], A%s: [1, 0]}}\n  coupler%s: {points: {A%s: [0, 0], B%s: [3.5, 0], C%s: [2, "
        "1.5]}}\n"
        "  rocker%s: {points: {Q%s: [0, 0], B%s: [3, 0]}}\n  link%s: {points: {C%s: [0, 0], %s: [4.5, 0]}}\n",
        k, k, k, k, k, k, k, k, k, k, k, k, output);
}
static size_t add_joints(char *text, size_t capacity, const char *k, const char *driver, const char *output)
{
    return (size_t)snprintf(text, capacity,
                            "  %s: {pin: [%s, link%s], angle: v%s}\n  P%s: {pin: [ground, crank%s], angle: p%s}\n  "
                            "A%s: {pin: [crank%s, coupler%s], angle: a%s}\n"
                            "  Q%s: {pin: [ground, rocker%s], angle: q%s}\n  B%s: {pin: [coupler%s, rocker%s]}\n  C%s: "
                            "{pin: [coupler%s, link%s]}\n",
                            output, driver, k, k, k, k, k, k, k, k, k, k, k, k, k, k, k, k, k, k);
}

// Two in a row: the first one's crank drives the second. The second may come first in the file.
static void groups_that_feed_each_other_are_solved_in_order(void **state)
{
    (void)state;
    for (int order = 0; order < 2; order++) {
        char text[6000];
        size_t n = (size_t)snprintf(text, sizeof text,
                                    "bodies:\n  ground: {points: {O: [6, 2.5], P1: [0, 0], Q1: [4, 0], P2: [-6, -2.5], "
                                    "Q2: [-2, -2.5]}}\n  output: {points: {O: [0, 0], D1: [2.5, 0]}}\n");
        n += add_bodies(text + n, sizeof text - n, "1", "D1");
        n += add_bodies(text + n, sizeof text - n, "2", "D2");
        n += (size_t)snprintf(
            text + n, sizeof text - n,
            "  arm: {points: {A1: [0, 0], D2: [2.5, 0]}}\njoints:\n  O: {pin: [ground, output], angle: w}\n");
        if (order) n += add_joints(text + n, sizeof text - n, "2", "arm", "D2");
        n += add_joints(text + n, sizeof text - n, "1", "output", "D1");
        if (!order) n += add_joints(text + n, sizeof text - n, "2", "arm", "D2");
        n += (size_t)snprintf(text + n, sizeof text - n, "  W: {weld: [crank1, arm], at: A1}\n");
        snprintf(text + n, sizeof text - n,
                 "drives: {w: 120 deg}\nstart: {p1: 120 deg, a1: -90 deg, q1: 119 deg, v1: -101 deg}\n");
        Machine m = machine(text);
        YkFreedom f = yk_mechanism_freedom(m.mech);
        assert_int_equal(f.gruebler, 1);
        assert_int_equal(yk_input_count(m.mech), 1);
        assert_int_equal(yk_block_count(m.mech), 2);
        for (size_t b = 0; b < 2; b++) {
            YkBlockInfo info = yk_block_info(m.mech, b);
            assert_int_equal(info.kind, YK_BLOCK_GROUP);
            assert_int_equal(info.unknowns, 4);
            assert_int_equal(info.equations, 4);
            assert_int_equal(info.assur_class, 3);
            assert_int_equal(info.label[1], '1' + (int)b); // the first machine's first
        }
        machine_free(&m);
    }
}

static void three_loops_that_hang_together_are_one_group(void **state)
{
    (void)state;
    Machine m = machine("double-butterfly");
    YkBlockInfo info = yk_block_info(m.mech, 0);
    assert_int_equal(yk_block_count(m.mech), 1);
    assert_int_equal(info.unknowns, 6);
    assert_int_equal(info.equations, 6);
    assert_int_equal(info.assur_class, 4);
    assert_true(m.mech->has_groups);
    assert_int_equal(m.mech->largest_group, 6);
    machine_free(&m);
}

static void each_unknown_of_a_group_is_listed_once(void **state)
{
    (void)state;
    static const char *const sources[] = {"double-butterfly", "stephenson-awkward", rack_of_slots};
    for (size_t k = 0; k < 3; k++) {
        Machine m = machine(sources[k]);
        for (size_t a = 0; a < m.mech->column_count; a++)
            for (size_t b = 0; b < a; b++) {
                YkColumn p = m.mech->group_columns[a], q = m.mech->group_columns[b];
                assert_false(p.is_distance == q.is_distance && p.index == q.index);
            }
        machine_free(&m);
    }
}

// The plate on three slots: one angle, three distances, two loops.
static void a_body_in_three_slots_is_a_group_of_four_unknowns(void **state)
{
    (void)state;
    Machine m = machine(rack_of_slots);
    size_t distances = 0;
    assert_int_equal(m.mech->column_count, 4);
    for (size_t c = 0; c < 4; c++) distances += m.mech->group_columns[c].is_distance;
    assert_int_equal(distances, 3);
    machine_free(&m);
}

static void machines_of_dyads_have_no_groups(void **state)
{
    (void)state;
    for (size_t k = 0; k < MACHINES; k++) {
        Machine m = machine(machines[k].source);
        bool expected = strstr(machines[k].blocks, "GROUP") != NULL;
        assert_int_equal(m.mech->has_groups, expected);
        if (!expected) assert_int_equal(m.mech->column_count, 0);
        machine_free(&m);
    }
}

// Machines side by side are solved each for itself, by a group as large as that of one alone.
static void groups_side_by_side_stay_apart(void **state)
{
    (void)state;
    static const char *const names[] = {"1", "2", "3"}, *const ends[] = {"D1", "D2", "D3"},
                             *const outputs[] = {"output1", "output2", "output3"};
    char text[6000];
    bool is_seen[3] = {false, false, false};
    size_t n = (size_t)snprintf(text, sizeof text, "bodies:\n  ground: {points: {Z: [0, 0]");
    for (int k = 1; k <= 3; k++)
        n += (size_t)snprintf(text + n, sizeof text - n, ", O%d: [6, 2.5], P%d: [0, 0], Q%d: [4, 0]", k, k, k);
    n += (size_t)snprintf(text + n, sizeof text - n, "}}\n");
    for (int k = 1; k <= 3; k++)
        n += (size_t)snprintf(text + n, sizeof text - n, "  output%d: {points: {O%d: [0, 0], D%d: [2.5, 0]}}\n", k, k,
                              k);
    for (int k = 0; k < 3; k++) n += add_bodies(text + n, sizeof text - n, names[k], ends[k]);
    n += (size_t)snprintf(text + n, sizeof text - n, "joints:\n");
    for (int k = 0; k < 3; k++) {
        n += (size_t)snprintf(text + n, sizeof text - n, "  O%d: {pin: [ground, output%d], angle: w%d}\n", k + 1, k + 1,
                              k + 1);
        n += add_joints(text + n, sizeof text - n, names[k], outputs[k], ends[k]);
    }
    snprintf(text + n, sizeof text - n, "drives: {w1: 120 deg, w2: 121 deg, w3: 122 deg}\n");
    Machine m = machine(text);
    assert_int_equal(yk_block_count(m.mech), 3);
    for (size_t b = 0; b < 3; b++) {
        YkBlockInfo info = yk_block_info(m.mech, b);
        assert_int_equal(info.kind, YK_BLOCK_GROUP);
        assert_int_equal(info.unknowns, 4);
        assert_int_equal(info.equations, 4);
        assert_int_equal(info.assur_class, 3);
        is_seen[info.label[1] - '1'] = true;
    }
    assert_true(is_seen[0] && is_seen[1] && is_seen[2]);
    machine_free(&m);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(groups_side_by_side_stay_apart),
        cmocka_unit_test(groups_that_feed_each_other_are_solved_in_order),
        cmocka_unit_test(three_loops_that_hang_together_are_one_group),
        cmocka_unit_test(each_unknown_of_a_group_is_listed_once),
        cmocka_unit_test(a_body_in_three_slots_is_a_group_of_four_unknowns),
        cmocka_unit_test(machines_of_dyads_have_no_groups),
    };
    return cmocka_run_group_tests_name("compile/groups", tests, NULL, NULL);
}
