#include "solve/track.h"
#include <string.h>

#define STEP_FLOOR 0x1p-46 // rad, or lengths over the size: where not even such a step succeeds, there is a limit

// Runs everything at the inputs as they stand, from the guess in groups.x.
static YkStatus run_here(YkState *s)
{
    YkRun run = yk_state_run(s, &s->spare);
    s->groups.global = false;
    s->groups.moved = 0;
    yk_run_begin(&run);
    yk_run_steps(&run, 0, s->mech->step_count);
    return yk_state_judge(s, &s->spare);
}

typedef struct Path { // of one input: position from + at * way; its true rates at the end
    double from, way, rate, accel;
} Path;

static Path path_of(const YkState *s, size_t i)
{
    return (Path){s->valid_input[3 * i], s->input[3 * i] - s->valid_input[3 * i], s->input[3 * i + 1], s->input[3 * i + 2]};
}

// Largest change of an input along the path: radians, or lengths over the size.
static double path_length(const YkState *s)
{
    double longest = 0;
    for (size_t i = 0; i < s->mech->input_count; i++) {
        bool is_distance = s->mech->coordinates[s->mech->inputs[i]].is_distance;
        longest = fmax(longest, fabs(path_of(s, i).way) / (is_distance ? s->mech->size : 1));
    }
    return longest;
}

// Puts the group's unknowns where velocity and acceleration (along the path) predict them; at a dead point, where they stand.
// Returns the largest change: radians, or lengths over the size.
static double predict(YkState *s, const YkSpace *space, double h)
{
    bool has_rates = space->margin[0] > YK_SINGULAR_MARGIN;
    double largest = 0;
    for (size_t k = 0; k < s->mech->column_count; k++) {
        YkColumn c = s->mech->group_columns[k];
        double v = 0, a = 0;
        if (has_rates && c.is_distance) {
            YkSlide d = yk_space_slide(space, c.index);
            v = d.v[0];
            a = d.a[0];
        } else if (has_rates) {
            YkTurn t = yk_space_turn(space, c.index);
            v = t.w[0];
            a = t.a[0];
        }
        double change = h * (v + 0.5 * h * a);
        s->groups.x[k] = s->valid_x[k] + change;
        largest = fmax(largest, fabs(change) / (c.is_distance ? s->mech->size : 1));
    }
    return largest;
}

// Inputs at `at` of the path from `base` (its inputs at 0), with the path itself as rate.
static void set_path(YkState *s, const double *ends, double at)
{
    for (size_t i = 0; i < s->mech->input_count; i++) {
        double from = ends[2 * i], way = ends[2 * i + 1];
        s->input[3 * i] = from + at * way;
        s->input[3 * i + 1] = way;
        s->input[3 * i + 2] = 0;
    }
}

typedef struct Tracker { double at, h, longest; } Tracker;

static void accept_along(YkState *s)
{
    YkSpace space = s->space;
    s->space = s->spare;
    s->spare = space;
    memcpy(s->valid_x, s->groups.x, s->mech->column_count * sizeof *s->valid_x);
}

// What Newton's method may correct of a prediction. From a dead point, which predicts nothing, the unknowns move as the root of
// the step, and the determinant's sign says which way.
static double correction_max(const YkState *s, double way)
{
    return s->space.margin[0] > YK_SINGULAR_MARGIN ? 0.25 * way + 1e-9 : 0.01;
}

// One step of the path; false when even the smallest fails. Newton's correction must be small against the predicted way: what it
// reaches is then the continuation and no other solution. Towards a limit steps shrink with the distance that is left.
static bool advance(YkState *s, Tracker *t, const double *ends)
{
    while (t->at + t->h > t->at && t->h > STEP_FLOOR) {
        double h = fmin(t->h, 1 - t->at), way = predict(s, &s->space, h);
        set_path(s, ends, t->at + h);
        if (way < 0.5 && run_here(s) >= 0 && s->groups.moved <= correction_max(s, way)) {
            accept_along(s);
            t->at += h;
            t->h = fmin(2 * t->h, 0.05 / fmax(t->longest, 1e-300));
            return true;
        }
        t->h = 0.5 * h;
    }
    return false;
}

YkStatus yk_state_track(YkState *s)
{
    size_t n = s->mech->input_count;
    double *ends = s->search->path, *wanted = s->search->wanted;
    if (!s->has_pose) return YK_BAD_ARGUMENT;
    memcpy(wanted, s->input, 3 * n * sizeof *wanted);
    for (size_t i = 0; i < n; i++) {
        Path p = path_of(s, i);
        ends[2 * i] = p.from;
        ends[2 * i + 1] = p.way;
    }
    Tracker t = {0, 1, path_length(s)};
    t.h = t.longest > 0.05 ? 0.05 / t.longest : 1;
    memcpy(s->groups.x, s->valid_x, s->mech->column_count * sizeof *s->valid_x);
    yk_space_copy(&s->search->kept, &s->space); // to come back to on failure
    memcpy(s->search->kept_x, s->valid_x, s->mech->column_count * sizeof *s->valid_x);
    set_path(s, ends, 0);
    YkStatus status = run_here(s); // rates along the path at its start
    if (status >= 0) accept_along(s);
    bool ok = status >= 0;
    while (ok && t.at < 1) ok = advance(s, &t, ends);
    memcpy(s->input, wanted, 3 * n * sizeof *wanted);
    if (ok) {
        memcpy(s->groups.x, s->valid_x, s->mech->column_count * sizeof *s->valid_x);
        status = run_here(s);
        yk_state_tell(s, &s->spare, status);
        if (status >= 0) yk_state_accept(s);
    }
    if (!ok || status < 0) {
        status = YK_LIMIT;
        yk_state_tell(s, &s->spare, status);
        yk_space_copy(&s->space, &s->search->kept);
        memcpy(s->valid_x, s->search->kept_x, s->mech->column_count * sizeof *s->valid_x);
    }
    return status;
}
