// Examples in another unit of length (tests/similar.h): their maps have the same circuits, branches, rows and events.
#include <yoke/map.h>
#include "../similar.h"

static YkMap *map_of(const Similar *m)
{
    assert_true(yk_state_set_time(m->state, 0, m->problems) >= 0 && yk_state_assemble(m->state) >= 0);
    YkMap *map = yk_map_new(m->state, yk_input_coordinate(m->mech, 0), m->problems);
    if (!map) print_error("%s: %s", m->file, yk_problems_text(m->problems, 0));
    assert_non_null(map);
    return map;
}

static void check_range(const Similar *a, YkRange r, YkRange s, YkQuantity of)
{
    similar_check(r.from, s.from, of, a->file, "start of a range");
    similar_check(r.to, s.to, of, a->file, "end of a range");
}

static void check_circuit(const Similar *a, const YkMap *one, const YkMap *two, size_t c)
{
    YkMapCircuit p = yk_map_circuit(one, c), q = yk_map_circuit(two, c);
    YkQuantity over = similar_quantity(a->mech, yk_map_coordinate(one));
    size_t coordinates = yk_coordinate_count(a->mech);
    SIMILAR_EQUAL(a->file, p.contains_start, q.contains_start);
    SIMILAR_EQUAL(a->file, p.ranges, q.ranges);
    SIMILAR_EQUAL(a->file, p.branches, q.branches);
    SIMILAR_EQUAL(a->file, p.events, q.events);
    for (size_t k = 0; k < p.ranges; k++) check_range(a, yk_map_range(one, c, k), yk_map_range(two, c, k), over);
    for (size_t k = 0; k < p.events; k++) {
        YkMapEvent e = yk_map_event(one, c, k), f = yk_map_event(two, c, k);
        SIMILAR_EQUAL(a->file, e.kind, f.kind);
        SIMILAR_EQUAL(a->file, e.block, f.block);
        SIMILAR_EQUAL(a->file, e.branch, f.branch);
        similar_check(e.at, f.at, over, a->file, "place of an event");
        for (size_t i = 0; i < coordinates; i++)
            similar_check(yk_map_event_value(one, c, k, i), yk_map_event_value(two, c, k, i),
                          similar_quantity(a->mech, i), a->file, "a coordinate at an event");
    }
    for (size_t k = 0; k < p.branches; k++) {
        YkMapBranch b = yk_map_branch(one, c, k), d = yk_map_branch(two, c, k);
        SIMILAR_EQUAL(a->file, b.is_closed, d.is_closed);
        SIMILAR_EQUAL(a->file, b.rows, d.rows);
        for (size_t row = 0; row < b.rows; row++)
            for (size_t i = 0; i < coordinates; i++)
                similar_check(yk_map_row(one, c, k, row)[i], yk_map_row(two, c, k, row)[i],
                              similar_quantity(a->mech, i), a->file, "a coordinate in a row");
    }
    for (size_t j = 0; j < yk_model_joint_count(a->model); j++) {
        YkMapTurn t = yk_map_turn(one, c, j), u = yk_map_turn(two, c, j);
        SIMILAR_EQUAL(a->file, t.is_full, u.is_full);
        check_range(a, t.range, u.range, YK_QUANTITY_ANGLE);
    }
}

static void check_file(const char *file, const char *over, int metre)
{
    similar_set(0, 0, 0);
    Similar a = similar_load(file, over);
    YkMap *one = map_of(&a);
    similar_set(metre, 0, 0);
    Similar b = similar_load(file, over);
    YkMap *two = map_of(&b);
    assert_string_equal(yk_map_message(one), yk_map_message(two));
    SIMILAR_EQUAL(file, yk_map_is_complete(one), yk_map_is_complete(two));
    SIMILAR_EQUAL(file, yk_map_circuit_count(one), yk_map_circuit_count(two));
    for (size_t c = 0; c < yk_map_circuit_count(one); c++) check_circuit(&a, one, two, c);
    yk_map_free(one);
    yk_map_free(two);
    similar_free(&a);
    similar_free(&b);
}

static void test_maps_in_another_unit(void **unused)
{
    (void)unused;
    static const char *const files[][2] = {
        {"quick-return"},        {"slider-crank"},  {"four-bar", "theta4"}, {"inverted-slider-crank"},
        {"whitworth-kg"},        {"kite"},          {"parallelogram"},      {"stephenson-six-bar"},
        {"watt-six-bar"},        {"klann"},         {"scotch-yoke"},        {"oscillating-cylinder"},
        {"crank-slotted-lever"}, {"planetary-gear"}};
    for (size_t k = 0; k < check_cases(sizeof files / sizeof *files); k++) {
        char path[64];
        snprintf(path, sizeof path, "examples/%s.yaml", files[k][0]);
        check_file(path, files[k][1], k % 2 ? 33 : -35);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_maps_in_another_unit)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
