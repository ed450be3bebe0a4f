// The examples in other units (tests/similar.h): sweeps, moves, ranges and drags are similar, with all of their events.
#include <yoke/drag.h>
#include "../similar.h"

// The first for sweeps over time: there a drive that is slower than 1 rad/s decides by the second how near is near
// (yk_path_scale).
static const int units[][3] = {{33, -22, 0}, {-35, 24, -33}};

static void check_events(const Similar *a, YkSweep *one, YkSweep *two, const YkChannel *channels, size_t count,
                         YkQuantity at)
{
    SIMILAR_EQUAL(a->file, yk_sweep_event_total(one), yk_sweep_event_total(two));
    for (size_t k = 0; k < yk_sweep_event_count(one); k++) {
        YkEvent e = yk_sweep_event(one, k), f = yk_sweep_event(two, k);
        SIMILAR_EQUAL(a->file, e.kind, f.kind);
        SIMILAR_EQUAL(a->file, e.block, f.block);
        SIMILAR_EQUAL(a->file, e.channel, f.channel);
        SIMILAR_EQUAL(a->file, e.is_maximum, f.is_maximum);
        SIMILAR_EQUAL(a->file, e.is_passed, f.is_passed);
        SIMILAR_EQUAL(a->file, e.is_turned, f.is_turned);
        similar_check(e.at, f.at, at, a->file, "place of an event");
        if (e.kind == YK_EVENT_EXTREME)
            similar_check(e.value, f.value, channels[e.channel].quantity, a->file, "an extreme");
        for (size_t c = 0; c < count; c++)
            similar_check(yk_sweep_event_value(one, k, c), yk_sweep_event_value(two, k, c), channels[c].quantity,
                          a->file, "value at an event");
    }
}

// Coordinates with their rates, and efforts: what sweeps watch.
static size_t choose_channels(const Similar *a, YkChannel *channels, size_t most)
{
    static const char *const endings[] = {"", ".rate", ".accel", ".effort"};
    size_t count = 0;
    for (size_t k = 0; k < yk_coordinate_count(a->mech); k++)
        for (size_t e = 0; e < 4 && count < most; e++) {
            char name[256];
            snprintf(name, sizeof name, "%s%s", yk_coordinate_info(a->mech, k).name, endings[e]);
            assert_int_equal(yk_channel_parse(a->mech, name, &channels[count++], a->problems), YK_OK);
        }
    return count;
}

// Returns where the first change point lies, to rounding; NaN if the sweep has passed none.
static double change_point(const YkSweep *sweep)
{
    for (size_t k = 0; k < yk_sweep_event_count(sweep); k++) {
        double at = yk_sweep_event(sweep, k).at, exact = YK_PI * rint(at / YK_PI); // where all links are in line
        if (yk_sweep_event(sweep, k).kind == YK_EVENT_CHANGE_POINT) return fabs(at - exact) < 1e-7 ? exact : at;
    }
    return NAN;
}

// Returns where it has passed a change point.
static double check_sweep(Similar *a, Similar *b, int coordinate, double from, double to, size_t steps)
{
    enum { MOST = 24 };
    YkChannel channels[MOST];
    size_t count = choose_channels(a, channels, MOST);
    YkQuantity at = coordinate < 0 ? YK_QUANTITY_TIME : similar_quantity(a->mech, (size_t)coordinate);
    YkSweepOptions o = yk_default_sweep_options();
    o.coordinate = coordinate;
    o.from = from;
    o.to = to;
    o.steps = steps;
    o.dynamics = a->dynamics;
    YkSweep *one = yk_sweep_run(a->state, &o, channels, count, a->problems);
    o.from = similar_to(from, at);
    o.to = similar_to(to, at);
    o.dynamics = b->dynamics;
    YkSweep *two = yk_sweep_run(b->state, &o, channels, count, b->problems);
    assert_true(one && two);
    SIMILAR_EQUAL(a->file, yk_sweep_status(one), yk_sweep_status(two));
    SIMILAR_EQUAL(a->file, yk_sweep_row_count(one), yk_sweep_row_count(two));
    for (size_t row = 0; row < yk_sweep_row_count(one); row++) {
        SIMILAR_EQUAL(a->file, yk_sweep_row_status(one, row), yk_sweep_row_status(two, row));
        similar_check(yk_sweep_at(one, row), yk_sweep_at(two, row), at, a->file, "place of a row");
        for (size_t c = 0; c < count; c++)
            similar_check(yk_sweep_value(one, row, c), yk_sweep_value(two, row, c), channels[c].quantity, a->file,
                          "value of a row");
    }
    check_events(a, one, two, channels, count, at);
    similar_check(yk_sweep_worst_residual(one), yk_sweep_worst_residual(two), YK_QUANTITY_NUMBER, a->file,
                  "worst residual");
    similar_check_state(a, b);
    double passed = change_point(one);
    yk_sweep_free(one);
    yk_sweep_free(two);
    return passed;
}

static void check_ranges(const Similar *a, const Similar *b, size_t coordinate)
{
    YkRange one[8], two[8];
    size_t count = yk_closing_ranges(a->state, coordinate, one, 8);
    SIMILAR_EQUAL(a->file, count, yk_closing_ranges(b->state, coordinate, two, 8));
    YkQuantity at = similar_quantity(a->mech, coordinate);
    for (size_t k = 0; k < count && k < 8; k++) {
        similar_check(one[k].from, two[k].from, at, a->file, "start of a range");
        similar_check(one[k].to, two[k].to, at, a->file, "end of a range");
    }
}

// Moves all inputs by this angle, or part of the size; or the first one to a place.
static void check_move(Similar *a, Similar *b, double by, double place)
{
    YkMotion goal[2][16];
    size_t count = yk_input_count(a->mech);
    if (count > 16) return;
    for (size_t k = 0; k < count; k++) {
        bool is_distance = yk_coordinate_info(a->mech, yk_input_coordinate(a->mech, k)).is_distance;
        goal[0][k] = yk_state_input(a->state, k);
        goal[0][k].position += by * (is_distance ? 0.3 * yk_mechanism_size(a->mech) : 1);
        if (k == 0 && isfinite(place)) goal[0][k].position = place;
        goal[1][k] = similar_motion(goal[0][k], is_distance);
    }
    YkMove one, two;
    SIMILAR_EQUAL(a->file, yk_state_move_to(a->state, goal[0], NULL, &one),
                  yk_state_move_to(b->state, goal[1], NULL, &two));
    SIMILAR_EQUAL(a->file, one.is_detour, two.is_detour);
    SIMILAR_EQUAL(a->file, one.block, two.block);
    SIMILAR_EQUAL(a->file, one.pass_count, two.pass_count);
    similar_check(one.part, two.part, YK_QUANTITY_NUMBER, a->file, "part of a move");
    for (size_t k = 0; k < one.pass_count && k < YK_MOVE_PASSES; k++)
        similar_check(one.passes[k].part, two.passes[k].part, YK_QUANTITY_NUMBER, a->file, "part of a pass");
    similar_check_state(a, b);
}

// Drags a point of the last body towards a place beside it.
static void check_drag(Similar *a, Similar *b)
{
    size_t body = yk_model_body_count(a->model) - 1;
    double size = yk_mechanism_size(a->mech);
    double place[2][2] = {{0.1 * size, -0.2 * size}}, target[2][2] = {{0.3 * size, 0.4 * size}};
    for (int k = 0; k < 2; k++) {
        place[1][k] = similar_to(place[0][k], YK_QUANTITY_LENGTH);
        target[1][k] = similar_to(target[0][k], YK_QUANTITY_LENGTH);
    }
    YkDrag *one = yk_drag_new(a->state, body, place[0], NULL), *two = yk_drag_new(b->state, body, place[1], NULL);
    YkDragged p, q;
    assert_true(one && two);
    SIMILAR_EQUAL(a->file, yk_state_drag(one, target[0], &p), yk_state_drag(two, target[1], &q));
    SIMILAR_EQUAL(a->file, p.end, q.end);
    SIMILAR_EQUAL(a->file, p.block, q.block);
    SIMILAR_EQUAL(a->file, p.coordinate, q.coordinate);
    SIMILAR_EQUAL(a->file, p.pass_count, q.pass_count);
    similar_check(p.distance, q.distance, YK_QUANTITY_LENGTH, a->file, "distance of a drag");
    similar_check_state(a, b);
    yk_drag_free(one);
    yk_drag_free(two);
}

static void check_input(Similar *a, Similar *b)
{
    if (yk_input_count(a->mech) == 0) return;
    size_t coordinate = yk_input_coordinate(a->mech, 0);
    bool is_distance = yk_coordinate_info(a->mech, coordinate).is_distance;
    double from = yk_state_coordinate(a->state, coordinate).position,
           far = is_distance ? 0.8 * yk_mechanism_size(a->mech) : 2 * YK_PI;
    double passed = check_sweep(a, b, (int)coordinate, from, from + far, 7);
    check_sweep(a, b, (int)coordinate, from + far / 3, from - 0.2 * far, 3);
    check_ranges(a, b, coordinate);
    check_move(a, b, 0.4, NAN);
    check_move(a, b, -1.1, NAN);
    if (isfinite(passed)) { // rows, and moves, that end just there
        check_sweep(a, b, (int)coordinate, passed + 0.25, passed - 0.25, 2);
        check_move(a, b, 0, passed);
    }
    check_drag(a, b);
}

static void check_pair(Similar *a, Similar *b, size_t k)
{
    if (k == 0) check_sweep(a, b, -1, 0, 0.7, 5);
    if (k == 1) check_input(a, b);
}

static void test_every_example_in_other_units(void **unused)
{
    (void)unused;
    similar_each_pair(units, sizeof units / sizeof *units, check_pair);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_every_example_in_other_units),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
