// Sweeps, moves, ranges and drags whose allocations fail one after the other: refused as a whole, or complete.
#include <yoke/drag.h>
#include <yoke/move.h>
#include <yoke/sweep.h>
#include "../survive.h"
#include "rest/rest.h"
#include "solve/machine.h"

typedef struct Task {
    Machine m;
    const char *channel; // of the rows
    double span;
    double value; // of the last row
} Task;

static bool sweep(void *context)
{
    Task *t = context;
    YkChannel channel;
    if (yk_channel_parse(t->m.mech, t->channel, &channel, NULL) != YK_OK) return false;
    YkState *state = yk_state_new(t->m.mech);
    YkDynamics *dynamics = yk_dynamics_new(t->m.mech, NULL);
    YkSweepOptions options = yk_default_sweep_options();
    double from = yk_state_input(t->m.state, 0).position;
    options.coordinate = (int)yk_input_coordinate(t->m.mech, 0);
    options.from = from;
    options.to = from + t->span;
    options.steps = 6;
    options.dynamics = dynamics;
    bool is_ready = state && dynamics && yk_state_copy(state, t->m.state) == YK_OK;
    YkSweep *w = is_ready ? yk_sweep_run(state, &options, &channel, 1, NULL) : NULL;
    bool good = w && yk_sweep_status(w) != YK_NO_MEMORY;
    if (good) {
        double last = yk_sweep_value(w, yk_sweep_row_count(w) - 1, 0);
        assert_true(t->value == 0 || memcmp(&t->value, &last, sizeof last) == 0);
        t->value = last;
    }
    yk_sweep_free(w);
    yk_dynamics_free(dynamics);
    yk_state_free(state);
    return good;
}

static void sweeps_survive(void **unused)
{
    (void)unused;
    skip_unless_interposed();
    static const char *const files[] = {"four-bar", "non-grashof", "parallelogram", "spring-slider-crank"},
                             *const channels[] = {"coupler.P.x.rate", "energy", "energy", "A.force"};
    for (size_t k = 0; k < sizeof files / sizeof *files; k++) {
        Task t = {.m = machine_load(files[k]), .channel = channels[k], .span = 4};
        survive(sweep, &t, files[k]);
        machine_free(&t.m);
    }
}

static bool move(void *context)
{
    Task *t = context;
    YkState *state = yk_state_new(t->m.mech);
    YkRange ranges[8];
    YkDragged dragged;
    bool good = state && yk_state_copy(state, t->m.state) == YK_OK;
    size_t count = good ? yk_closing_ranges(state, yk_input_coordinate(t->m.mech, 0), ranges, 8) : YK_NOT_FOUND;
    good = count != YK_NOT_FOUND;
    YkMotion goal = good ? yk_state_input(state, 0) : (YkMotion){0};
    goal.position += t->span;
    YkStatus status = good ? yk_state_move_to(state, &goal, NULL, NULL) : YK_NO_MEMORY;
    YkDrag *drag = status == YK_NO_MEMORY ? NULL : yk_drag_new(state, 1, (double[]){0.01, 0}, NULL);
    good = drag && yk_state_drag(drag, (double[]){0, 0.01}, &dragged) == YK_OK;
    yk_drag_free(drag);
    yk_state_free(state);
    return good;
}

static void moves_survive(void **unused)
{
    (void)unused;
    skip_unless_interposed();
    static const char *const files[] = {"four-bar", "non-grashof", "stephenson-awkward", "watt-with-masses"};
    for (size_t k = 0; k < sizeof files / sizeof *files; k++) {
        Task t = {.m = machine_load(files[k]), .span = k == 1 ? 4 : k == 3 ? 0.05 : 0.3};
        survive(move, &t, files[k]);
        machine_free(&t.m);
    }
}

static bool reach(void *context)
{
    return yk_rest_reach(context) == YK_OK;
}

static void searches_for_what_is_reached_survive(void **unused)
{
    (void)unused;
    skip_unless_interposed();
    Machine m = machine_load("spring-slider-crank");
    YkRest *rest = yk_rest_find(m.model, NULL, m.problems);
    assert_non_null(rest);
    survive(reach, rest, "reach");
    yk_rest_free(rest);
    machine_free(&m);
}

int main(void)
{
    start_counting();
    const struct CMUnitTest tests[] = {cmocka_unit_test(sweeps_survive), cmocka_unit_test(moves_survive),
                                       cmocka_unit_test(searches_for_what_is_reached_survive)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
