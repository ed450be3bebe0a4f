// Long calls on a state, watched and stopped: the state then stands where it stood before.
#include "machine.h"
#include "solve/state.h"
#include "watched.h"

// A step of solution takes 100 ns at most, the judgement of a block 10: so many of them are 50 ms.
static const uint64_t STEPS_IN_50_MS = 500000, JUDGED_IN_50_MS = 5000000;

typedef struct Subject {
    Machine m;
    YkState *home; // a pose from which every run begins
    size_t count;  // rows, visits
    Watched *w;
} Subject;

static uint64_t hash_pose(uint64_t hash, const YkState *s)
{
    for (size_t c = 0; c < yk_coordinate_count(s->mech); c++) {
        YkMotion q = yk_state_coordinate(s, c);
        hash = hash_bytes(hash, &q, sizeof q);
    }
    return hash_bytes(hash, s->branch, s->mech->block_count);
}

static Subject subject_of(size_t four_bars)
{
    char *text = ladder_text(four_bars);
    Subject subject = {.m = machine_parse(text, true)};
    free(text);
    subject.home = yk_state_new(subject.m.mech);
    assert_non_null(subject.home);
    yk_state_copy(subject.home, subject.m.state);
    // What a watched state keeps for its return is there from now on.
    assert_int_equal(yk_state_set_progress(subject.m.state, (YkProgress){watch, NULL}), YK_OK);
    return subject;
}

// Under the sanitizers a half of the machine asks often enough.
static size_t sized(size_t four_bars)
{
#ifdef IS_SANITIZED
    return four_bars / 2;
#else
    return four_bars;
#endif
}

static void release(Subject *subject)
{
    yk_state_free(subject->home);
    machine_free(&subject->m);
}

static YkState *ready(Subject *subject, Watched *w)
{
    YkState *s = subject->m.state;
    yk_state_copy(s, subject->home);
    subject->w = w;
    assert_int_equal(yk_state_set_progress(s, progress_of(w)), YK_OK);
    return s;
}

static void check_return(const Subject *subject, bool is_stopped)
{
    const YkState *s = subject->m.state;
    if (!is_stopped) return;
    assert_int_equal(yk_state_report(s)->status, YK_STOPPED);
    assert_true(hash_pose(HASH, s) == hash_pose(HASH, subject->home));
    assert_memory_equal(s->input, subject->home->input, 3 * s->mech->input_count * sizeof *s->input);
}

// --- assembling

static bool assemble(void *self, Watched *w, uint64_t *hash)
{
    Subject *subject = self;
    YkState *s = ready(subject, w);
    yk_state_set_input(s, 0, (YkMotion){1.1, 1, 0});
    memcpy(subject->home->input, s->input, 3 * sizeof *s->input);
    YkStatus status = yk_state_assemble(s);
    check_return(subject, status == YK_STOPPED);
    *hash = hash_pose(*hash, s);
    return status == YK_STOPPED;
}

static bool visit(void *context, YkState *s)
{
    Subject *subject = context;
    subject->count++;
    if (subject->w) subject->w->done += s->mech->block_count; // judged, at least
    return true;
}

static bool visit_each(void *self, Watched *w, uint64_t *hash)
{
    Subject *subject = self;
    YkState *s = ready(subject, w);
    bool is_complete;
    subject->count = 0;
    YkStatus status = yk_state_each(s, visit, subject, &is_complete);
    check_return(subject, status == YK_STOPPED);
    *hash = hash_bytes(hash_pose(*hash, s), &subject->count, sizeof subject->count);
    return status == YK_STOPPED;
}

static void assembling_can_be_stopped(void **unused)
{
    (void)unused;
    Subject subject = subject_of(sized(4000));
    check_long_call("assemble", assemble, &subject);
    release(&subject);
    subject = subject_of(1000);
    uint64_t most = check_long_call("each", visit_each, &subject);
    assert_true(most > 0 && most <= JUDGED_IN_50_MS);
    release(&subject);
}

// A group is searched from many starts, by Newton's method.
static void the_search_of_a_group_can_be_stopped(void **unused)
{
    (void)unused;
    Subject subject = {.m = machine_load("jansen")};
    machine_free(&subject.m);
    subject.m = machine_load("double-butterfly");
    subject.home = yk_state_new(subject.m.mech);
    yk_state_copy(subject.home, subject.m.state);
    Watched w = watched(1);
    YkState *s = ready(&subject, &w);
    assert_int_equal(yk_state_assemble(s), YK_STOPPED);
    assert_int_equal(w.asked, 1);
    assert_true(hash_pose(HASH, s) == hash_pose(HASH, subject.home));
    assert_true(yk_state_assemble(ready(&subject, NULL)) >= 0);
    release(&subject);
}

// --- moving

static void count_row(void *context, const YkState *s)
{
    Subject *subject = context;
    if (subject->w) subject->w->done += s->mech->step_count;
}

static bool sweep(void *self, Watched *w, uint64_t *hash)
{
    Subject *subject = self;
    YkState *s = ready(subject, w);
    YkSweepOptions options = yk_default_sweep_options();
    YkChannel channel = machine_channel(&subject->m, "t9");
    options.coordinate = (int)yk_input_coordinate(s->mech, 0);
    options.from = yk_state_input(s, 0).position;
    options.to = options.from + 0.5;
    options.steps = 2000;
    options.visit = count_row;
    options.context = subject;
    YkProblems *problems = yk_problems_new();
    YkSweep *result = yk_sweep_run(s, &options, &channel, 1, problems);
    check_return(subject, !result);
    if (!result) assert_true(is_told(problems));
    for (size_t k = 0; result && k < yk_sweep_row_count(result); k++) {
        double value = yk_sweep_value(result, k, 0);
        *hash = hash_bytes(*hash, &value, sizeof value);
    }
    bool is_stopped = !result;
    yk_sweep_free(result);
    yk_problems_free(problems);
    return is_stopped;
}

static bool move(void *self, Watched *w, uint64_t *hash)
{
    Subject *subject = self;
    YkState *s = ready(subject, w);
    YkMotion goal = yk_state_input(s, 0);
    YkMoveOptions options = yk_default_move_options();
    options.turn_max = 2e-4;
    goal.position += 0.5;
    YkStatus status = yk_state_move_to(s, &goal, &options, NULL);
    assert_true(status >= 0 || status == YK_STOPPED);
    check_return(subject, status == YK_STOPPED);
    *hash = hash_pose(*hash, s);
    return status == YK_STOPPED;
}

static bool move_in_time(void *self, Watched *w, uint64_t *hash)
{
    Subject *subject = self;
    YkState *s = ready(subject, w);
    YkMoveOptions options = yk_default_move_options();
    options.turn_max = 2e-4;
    YkStatus status = yk_state_move_time(s, 0.5, &options, NULL, NULL);
    assert_true(status >= 0 || status == YK_STOPPED);
    check_return(subject, status == YK_STOPPED);
    *hash = hash_pose(*hash, s);
    return status == YK_STOPPED;
}

static bool find_ranges(void *self, Watched *w, uint64_t *hash)
{
    Subject *subject = self;
    YkState *s = ready(subject, w);
    YkRange ranges[8] = {{0}};
    size_t count = yk_closing_ranges(s, yk_input_coordinate(s->mech, 0), ranges, 8);
    check_return(subject, count == YK_NOT_FOUND);
    *hash = hash_bytes(*hash, ranges, sizeof ranges);
    return count == YK_NOT_FOUND;
}

static void a_stroke_can_be_stopped(void **unused)
{
    (void)unused;
    Subject subject = {.m = machine_load("four-bar")};
    Watched w = watched(1);
    YkStroke stroke;
    subject.home = yk_state_new(subject.m.mech);
    yk_state_copy(subject.home, subject.m.state);
    YkState *s = ready(&subject, &w);
    assert_int_equal(yk_stroke(s, 0, machine_channel(&subject.m, "theta4"), &stroke), YK_STOPPED);
    check_return(&subject, true);
    s = ready(&subject, NULL);
    assert_int_equal(yk_stroke(s, 0, machine_channel(&subject.m, "theta4"), &stroke), YK_OK);
    release(&subject);
}

static void dragging_can_be_stopped(void **unused)
{
    (void)unused;
    Subject subject = subject_of(100);
    Watched w = watched(1);
    YkState *s = ready(&subject, &w);
    size_t point = yk_model_find_point(subject.m.model, "r9.A9");
    assert_true(point != YK_NOT_FOUND);
    YkDrag *held = yk_drag_new(s, yk_model_point_body(subject.m.model, point), (double[]){0.1, 0}, NULL);
    assert_non_null(held);
    YkDragged dragged;
    assert_int_equal(yk_state_drag(held, (double[]){2.75, 0.09}, &dragged), YK_STOPPED);
    check_return(&subject, true);
    ready(&subject, NULL);
    assert_int_equal(yk_state_drag(held, (double[]){2.75, 0.09}, &dragged), YK_OK);
    assert_true(hash_pose(HASH, s) != hash_pose(HASH, subject.home));
    yk_drag_free(held);
    release(&subject);
}

static void motions_can_be_stopped(void **unused)
{
    (void)unused;
    Subject subject = subject_of(100);
    uint64_t most = check_long_call("sweep", sweep, &subject);
    assert_true(most > 0 && most <= STEPS_IN_50_MS);
    check_long_call("move", move, &subject);
    check_long_call("move in time", move_in_time, &subject);
    release(&subject);
    subject = subject_of(sized(2000));
    check_long_call("ranges", find_ranges, &subject);
    release(&subject);
}

static void a_single_solution_and_a_copy_ask_nobody(void **unused)
{
    (void)unused;
    Subject subject = subject_of(sized(2000));
    Watched w = watched(1);
    YkState *s = ready(&subject, &w), *copy = yk_state_new(subject.m.mech);
    for (int k = 0; k < 20; k++) assert_true(yk_state_solve(s) >= 0);
    assert_int_equal(yk_state_copy(copy, s), YK_OK);
    assert_true(yk_state_assemble(copy) >= 0);
    assert_int_equal(w.asked, 0);
    yk_state_free(copy);
    release(&subject);
}

int main(void)
{
    start_counting();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(assembling_can_be_stopped), cmocka_unit_test(the_search_of_a_group_can_be_stopped),
        cmocka_unit_test(motions_can_be_stopped),    cmocka_unit_test(dragging_can_be_stopped),
        cmocka_unit_test(a_stroke_can_be_stopped),   cmocka_unit_test(a_single_solution_and_a_copy_ask_nobody),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
