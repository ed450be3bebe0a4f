// Answers to callers: coordinates, loops with their bodies in order, blocks, the freedom.
#include "machine.h"
#include "table.h"

static size_t bodies_of(const Machine *m, size_t loop, char *text, size_t capacity)
{
    size_t bodies[32], count = yk_loop_bodies(m->mech, loop, bodies, 32);
    text[0] = 0;
    for (size_t k = 0; k < count; k++) add_text(text, capacity, "%s%s%s", yk_model_body_name(m->model, bodies[k]), "");
    return count;
}

static void loops_are_told_in_order_from_the_closing_joints_first_body(void **state)
{
    (void)state;
    char text[300];
    Machine m = machine("toggle");
    bodies_of(&m, 0, text, sizeof text);
    assert_string_equal(text, "link2, link1, ground, link3");
    bodies_of(&m, 1, text, sizeof text);
    assert_string_equal(text, "link4, link3, ground, slider");
    machine_free(&m);
    m = machine("excavator"); // the second loop does not reach the ground
    bodies_of(&m, 1, text, sizeof text);
    assert_string_equal(text, "rod2, barrel2, boom, stick");
    machine_free(&m);
    m = machine("doubled-guide"); // two joints between the same bodies
    bodies_of(&m, 1, text, sizeof text);
    assert_string_equal(text, "ground, crosshead");
    machine_free(&m);
}

// Neighbours in the list share a joint of the tree, the ends the closing joint; no body comes twice.
static void each_loop_is_a_ring_of_joints(void **state)
{
    (void)state;
    for (size_t k = 0; k < MACHINES; k++) {
        Machine m = machine(machines[k].source);
        for (size_t l = 0; l < yk_loop_count(m.mech); l++) {
            size_t bodies[32], count = yk_loop_bodies(m.mech, l, bodies, 32), joint = yk_loop_joint(m.mech, l);
            assert_in_range(count, 2, 32);
            assert_int_equal(bodies[0], yk_model_joint_body(m.model, joint, 0));
            assert_int_equal(bodies[count - 1], yk_model_joint_body(m.model, joint, 1));
            for (size_t i = 0; i + 1 < count; i++) {
                bool is_up = m.mech->tree.parent[bodies[i]] == (int32_t)bodies[i + 1],
                     is_down = m.mech->tree.parent[bodies[i + 1]] == (int32_t)bodies[i];
                assert_true(is_up || is_down);
                for (size_t j = i + 1; j < count; j++) assert_true(bodies[i] != bodies[j]);
            }
        }
        machine_free(&m);
    }
}

static void lists_are_cut_to_the_room_there_is(void **state)
{
    (void)state;
    Machine m = machine("toggle");
    for (size_t room = 0; room < 5; room++) {
        size_t bodies[6] = {99, 99, 99, 99, 99, 99}, whole[6];
        assert_int_equal(yk_loop_bodies(m.mech, 0, bodies, room), 4);
        yk_loop_bodies(m.mech, 0, whole, 6);
        for (size_t k = 0; k < 6; k++) assert_int_equal(bodies[k], k < room && k < 4 ? whole[k] : 99);
    }
    machine_free(&m);
}

static void coordinates_know_their_joint_and_drive(void **state)
{
    (void)state;
    Machine m = machine("quick-return");
    static const struct {
        const char *name, *joint;
        bool is_distance, has_drive;
        int input;
    } cases[] = {{"theta1", "O1", false, true, 0},
                 {"theta2", "O2", false, false, -1},
                 {"d3", "S", true, false, -1},
                 {"theta4", "B", false, false, -1},
                 {"d5", "R", true, false, -1}};
    assert_int_equal(yk_coordinate_count(m.mech), 5);
    for (size_t k = 0; k < 5; k++) {
        YkCoordinateInfo info = yk_coordinate_info(m.mech, k);
        assert_string_equal(info.name, cases[k].name);
        assert_string_equal(yk_model_joint_name(m.model, info.joint), cases[k].joint);
        assert_int_equal(info.is_distance, cases[k].is_distance);
        assert_int_equal(info.has_drive, cases[k].has_drive);
        assert_int_equal(info.input, cases[k].input);
        assert_true(info.is_declared);
        assert_int_equal(yk_coordinate_find(m.mech, cases[k].name), k);
    }
    assert_int_equal(yk_coordinate_find(m.mech, "theta3"), YK_NOT_FOUND);
    assert_int_equal(yk_coordinate_find(m.mech, ""), YK_NOT_FOUND);
    machine_free(&m);
}

// Looking up by joint, with pin-slots that have both an angle and a distance.
static void coordinates_are_found_by_joint_and_kind(void **state)
{
    (void)state;
    for (size_t k = 0; k < MACHINES; k++) {
        Machine m = machine(machines[k].source);
        for (size_t j = 0; j < m.model->joint_count; j++)
            for (int is_distance = 0; is_distance < 2; is_distance++) {
                int32_t expected = YK_NONE;
                for (size_t c = 0; c < m.mech->coordinate_count; c++)
                    if (m.mech->coordinates[c].joint == (int32_t)j && m.mech->coordinates[c].is_distance == is_distance)
                        expected = (int32_t)c;
                assert_int_equal(yk_tree_coordinate(m.mech, (int32_t)j, is_distance), expected);
            }
        machine_free(&m);
    }
}

// By its name and by going through all; and the start that the file gives, by going through these.
static void every_coordinate_is_found_by_its_name(void **state)
{
    (void)state;
    for (size_t k = 0; k < MACHINES; k++) {
        Machine m = machine(machines[k].source);
        for (size_t c = 0; c < m.mech->coordinate_count; c++) {
            YkCoordinateInfo info = yk_coordinate_info(m.mech, c);
            size_t first = 0;
            while (strcmp(m.mech->coordinates[first].name, info.name) != 0) first++;
            assert_int_equal(yk_coordinate_find(m.mech, info.name), first);
            bool has_start = false;
            for (size_t i = 0; i < m.model->start_count; i++) {
                const YkCoordinate *named = &m.model->coordinates[m.model->starts[i].coordinate];
                has_start |= !m.model->starts[i].is_rate && named->joint == m.mech->coordinates[c].joint &&
                             named->is_distance == info.is_distance;
            }
            assert_int_equal(info.has_start, has_start);
        }
        machine_free(&m);
    }
    Machine m = machine("bodies: {a: {points: {P: [1, 0]}}, b: {}}\njoints: {A: {pin: [ground, a]}, "
                        "B: {free: [ground, b], at: [x, y, phi]}}\nstart: {x: 1}\n");
    static const char *const names[] = {"A.angle", "x", "y", "phi"};
    for (size_t c = 0; c < 4; c++) assert_int_equal(yk_coordinate_find(m.mech, names[c]), c);
    assert_false(yk_coordinate_info(m.mech, 0).has_start);
    assert_true(yk_coordinate_info(m.mech, 1).has_start);
    static const char *const others[] = {"A", "A.distance", "A.", ".angle", "A.angle.rate", "B.angle", "a.P"};
    for (size_t k = 0; k < sizeof others / sizeof *others; k++)
        assert_int_equal(yk_coordinate_find(m.mech, others[k]), YK_NOT_FOUND);
    machine_free(&m);
}

static void a_slot_in_the_tree_has_an_angle_and_a_distance(void **state)
{
    (void)state;
    char text[100];
    Machine m = machine("bodies: {pin: {}}\njoints: {P: {pin-slot: [ground, pin], along: x, angle: a, distance: d}}\n");
    describe_coordinates(m.mech, text, sizeof text);
    assert_string_equal(text, "a, d");
    assert_int_equal(yk_mechanism_freedom(m.mech).gruebler, 2);
    assert_int_equal(yk_input_count(m.mech), 2);
    machine_free(&m);
}

static void kinds_of_blocks_have_names(void **state)
{
    (void)state;
    for (int a = YK_BLOCK_RRR; a <= YK_BLOCK_GROUP; a++)
        for (int b = YK_BLOCK_RRR; b < a; b++)
            assert_string_not_equal(yk_block_kind_name((YkBlockKind)a), yk_block_kind_name((YkBlockKind)b));
    assert_string_equal(yk_block_kind_name(YK_BLOCK_RRR), "RRR dyad");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(loops_are_told_in_order_from_the_closing_joints_first_body),
        cmocka_unit_test(each_loop_is_a_ring_of_joints),
        cmocka_unit_test(lists_are_cut_to_the_room_there_is),
        cmocka_unit_test(coordinates_know_their_joint_and_drive),
        cmocka_unit_test(coordinates_are_found_by_joint_and_kind),
        cmocka_unit_test(every_coordinate_is_found_by_its_name),
        cmocka_unit_test(a_slot_in_the_tree_has_an_angle_and_a_distance),
        cmocka_unit_test(kinds_of_blocks_have_names),
    };
    return cmocka_run_group_tests_name("compile/info", tests, NULL, NULL);
}
