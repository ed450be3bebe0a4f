// A sweep in two parts, and a sweep back, go through the poses of the sweep in one, past the same events.
#include "../examples.h"
#include "solve/machine.h"

enum { STEPS = 8, CHANNELS = 24 };

// All coordinates with their rates and accelerations, as far as there is room.
static size_t choose_channels(const Machine *m, YkChannel *channels)
{
    size_t count = 0;
    for (size_t k = 0; k < yk_coordinate_count(m->mech); k++)
        for (int order = 0; order < 3 && count < CHANNELS; order++)
            channels[count++] = (YkChannel){YK_CHANNEL_COORDINATE, (int)k, order, YK_QUANTITY_NUMBER};
    return count;
}

// Sweeps over a coordinate, or over time (-1).
static YkSweep *sweep(const Machine *m, int coordinate, double from, double to, size_t steps)
{
    YkChannel channels[CHANNELS];
    YkSweepOptions o = yk_default_sweep_options();
    o.coordinate = coordinate;
    o.from = from;
    o.to = to;
    o.steps = steps;
    YkSweep *found = yk_sweep_run(m->state, &o, channels, choose_channels(m, channels), m->problems);
    assert_non_null(found);
    return found;
}

// Positions agree in all rows; rates only where they are of this branch alone. Where a block is near a limit, rounding
// of 1e-16 moves its pose by the root of that, and rates by more.
static void check_row(const Machine *m, YkSweep *one, size_t row, YkSweep *two, size_t other, const char *file)
{
    YkChannel channels[CHANNELS];
    size_t count = choose_channels(m, channels);
    double size = yk_mechanism_size(m->mech), most[3] = {1, 1, 1};
    bool has_rates = yk_sweep_row_status(one, row) == YK_OK && yk_sweep_row_status(two, other) == YK_OK;
    for (size_t c = 0; c < count; c++)
        most[channels[c].order] = fmax(most[channels[c].order], fabs(yk_sweep_value(one, row, c)));
    for (size_t c = 0; c < count; c++) {
        int order = channels[c].order;
        bool is_distance = yk_coordinate_info(m->mech, (size_t)channels[c].index).is_distance;
        double a = yk_sweep_value(one, row, c), b = yk_sweep_value(two, other, c), off = fabs(a - b);
        double allowed = order == 0 ? 1e-8 * (is_distance ? size : 1) : 1e-6 * most[order];
        if ((order > 0 && !has_rates) || off <= allowed) continue;
        print_error("%s: row %zu, channel %zu: %.17g, not %.17g\n", file, row, c, b, a);
        fail();
    }
}

static size_t events_inside(YkSweep *s, YkEventKind kind, double low, double high)
{
    size_t count = 0;
    for (size_t k = 0; k < yk_sweep_event_count(s); k++) {
        YkEvent e = yk_sweep_event(s, k);
        count += e.kind == kind && e.at > low && e.at < high;
    }
    return count;
}

// Every event of one has its like in the other, or, if it lies at an end of a part, in neither.
static void check_events(YkSweep *one, YkSweep *two, double low, double high, bool may_rest, const char *file)
{
    double rim = 1e-5 * (high - low);
    for (size_t k = 0; k < yk_sweep_event_count(one); k++) {
        YkEvent e = yk_sweep_event(one, k), nearest = {0};
        if (!(e.at > low + rim && e.at < high - rim)) continue;
        for (size_t i = 0; i < yk_sweep_event_count(two); i++) {
            YkEvent f = yk_sweep_event(two, i);
            bool is_like = f.kind == e.kind && f.block == e.block && f.channel == e.channel;
            if (may_rest && is_like && e.kind == YK_EVENT_EXTREME && f.is_maximum == e.is_maximum &&
                fabs(f.value - e.value) <= 1e-9 * (1 + fabs(e.value)))
                f.at = e.at; // a drive that rests at its extreme begins to at one end, coming from either side
            if (is_like && !(fabs(nearest.at - e.at) < fabs(f.at - e.at) && nearest.kind == e.kind && nearest.at != 0))
                nearest = f;
        }
        if (!(fabs(nearest.at - e.at) <= 2e-7 * (high - low)))
            print_error("%s: event %d at %.17g, nearest at %.17g\n", file, (int)e.kind, e.at, nearest.at);
        assert_true(fabs(nearest.at - e.at) <= 2e-7 * (high - low));
        if (e.kind == YK_EVENT_EXTREME) assert_int_equal(e.is_maximum, nearest.is_maximum);
        if (e.kind == YK_EVENT_EXTREME) CHECK_NEAR(e.value, nearest.value, 1e-9 * (1 + fabs(e.value)));
    }
}

// Returns whether the whole range was gone through.
static bool check_range(const char *file, Machine *m, int coordinate, double from, double to)
{
    YkSweep *whole = sweep(m, coordinate, from, to, 2 * STEPS);
    bool is_whole = yk_sweep_status(whole) == YK_OK;
    if (is_whole) {
        double middle = from + (to - from) / 2, low = fmin(from, to), high = fmax(from, to);
        YkSweep *back = sweep(m, coordinate, to, from, 2 * STEPS);
        assert_int_equal(yk_sweep_status(back), YK_OK);
        YkSweep *first = sweep(m, coordinate, from, middle, STEPS), *last = sweep(m, coordinate, middle, to, STEPS);
        assert_int_equal(yk_sweep_status(first), YK_OK);
        assert_int_equal(yk_sweep_status(last), YK_OK);
        for (size_t k = 0; k <= STEPS; k++) {
            check_row(m, whole, k, first, k, file);
            check_row(m, whole, STEPS + k, last, k, file);
        }
        for (size_t k = 0; k <= 2 * STEPS; k++) check_row(m, whole, k, back, 2 * STEPS - k, file);
        check_events(whole, back, low, high, coordinate < 0, file);
        check_events(back, whole, low, high, coordinate < 0, file);
        check_events(first, whole, fmin(from, middle), fmax(from, middle), coordinate < 0, file);
        check_events(last, whole, fmin(middle, to), fmax(middle, to), coordinate < 0, file);
        double rim = 1e-5 * (high - low);
        for (int kind = YK_EVENT_LIMIT; kind <= YK_EVENT_EXTREME; kind++) {
            size_t due = events_inside(whole, (YkEventKind)kind, low + rim, high - rim);
            assert_int_equal(events_inside(back, (YkEventKind)kind, low + rim, high - rim), due);
        }
        yk_sweep_free(back);
        yk_sweep_free(first);
        yk_sweep_free(last);
    }
    yk_sweep_free(whole);
    return is_whole;
}

// Returns the rate of the fastest input at the start: rad/s, or machine sizes per second.
static double fastest(const Machine *m)
{
    double most = 0;
    for (size_t k = 0; k < yk_input_count(m->mech); k++) {
        bool is_distance = yk_coordinate_info(m->mech, yk_input_coordinate(m->mech, k)).is_distance;
        double rate = fabs(yk_state_input(m->state, k).velocity);
        most = fmax(most, is_distance ? rate / yk_mechanism_size(m->mech) : rate);
    }
    return most;
}

static size_t check_file(const char *path, size_t number)
{
    (void)number;
    char name[128];
    const char *file = strrchr(path, '/') + 1;
    size_t gone = 0;
    snprintf(name, sizeof name, "%.*s", (int)(strlen(file) - strlen(".yaml")), file);
    Machine m = machine_try(path);
    if (m.state && yk_input_count(m.mech) > 0 && yk_state_set_time(m.state, 0, m.problems) >= 0 &&
        yk_state_assemble(m.state) == YK_OK) {
        size_t coordinate = yk_input_coordinate(m.mech, 0);
        double here = yk_state_coordinate(m.state, coordinate).position;
        double far = yk_coordinate_info(m.mech, coordinate).is_distance ? 0.2 * yk_mechanism_size(m.mech) : 1.9;
        gone += check_range(name, &m, (int)coordinate, here, here + far);
        gone += check_range(name, &m, (int)coordinate, here, here - 0.3 * far);
        if (fastest(&m) > 0) gone += check_range(name, &m, -1, 0, 2.9 / fastest(&m));
    }
    machine_free(&m);
    return gone;
}

static void test_examples_in_parts_and_back(void **unused)
{
    (void)unused;
    assert_true(each_example(check_file) > 80);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_examples_in_parts_and_back),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
