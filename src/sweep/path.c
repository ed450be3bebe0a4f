// Paths of the inputs: places on them, their length, and poses next to change points and limits.
#include "sweep/path.h"
#include "elementary/elementary.h"
#include <stdlib.h>
#include <string.h>

bool yk_path_start(YkPath *path, YkState *state, int coordinate)
{
    size_t n = 3 * state->mech->input_count;
    *path = (YkPath){.state = state, .input = coordinate < 0 ? -1 : state->mech->coordinates[coordinate].input};
    path->others = malloc((2 * n + state->mech->input_count + 1) * sizeof *path->others);
    if (!path->others) return false;
    memcpy(path->others, state->input, n * sizeof *path->others);
    path->last = path->input < 0 ? state->time : state->valid_input[3 * path->input];
    path->way = yk_path_heading(path);
    return true;
}

bool yk_path_start_line(YkPath *path, YkState *state, const double *goal)
{
    if (!yk_path_start(path, state, -1)) return false;
    path->is_line = true;
    path->goal = goal;
    path->last = 0;
    memcpy(path->others, state->valid_input, 3 * state->mech->input_count * sizeof *path->others);
    path->way = yk_path_heading(path);
    return true;
}

void yk_path_end(YkPath *path)
{
    free(path->others);
    path->others = NULL;
}

double yk_path_length(YkPath *path, double from, double to)
{
    enum { SAMPLES = 64 };
    if (!yk_path_is_time(path)) return fabs(to - from) / yk_path_scale(path);
    double sum = 0, time = path->state->time;
    for (int k = 0; k < SAMPLES; k++) // at unequal distances: equal ones might all meet the same phase
        if (yk_path_set(path, from + (to - from) * (k + 0.5 + 0.3 * yk_sin(k)) / SAMPLES, true) >= 0)
            sum += yk_path_fastest(path->state);
    yk_path_set(path, time, true);
    return sum / SAMPLES * fabs(to - from);
}

YkStatus yk_path_set(YkPath *path, double at, bool along)
{
    YkStatus status = yk_path_set_inputs(path, at, along);
    if (status >= 0) yk_path_place_signs(path, at);
    return status;
}

// Returns a place a little back on the path, but on that side of the last change point for which the signs hold.
static double beside(const YkPath *path, double at, double off)
{
    double step = off * fmax(yk_path_scale(path), fabs(at)), back = at - path->way * step;
    bool is_near = path->side != 0 && fabs(at - path->passed) <= step;
    return is_near && (back - path->passed) * path->side <= 0 ? at + path->side * step : back;
}

// Keeps an angle where a dyad's base vanishes, as in a folded rhombus: any angle closes it there, so it takes the one
// from a little back on the path, where the base is long enough to determine it.
static YkStatus keep_from_beside(YkPath *path, double at, bool along)
{
    YkState *s = path->state;
    YkStatus status = yk_path_set(path, beside(path, at, 1e-8), along);
    if (status == YK_OK) status = yk_state_solve(s);
    if (status >= 0) status = yk_path_set(path, at, along);
    return status < 0 ? status : yk_state_solve(s);
}

// Solves a pose that closes up to rounding: the pose a few roundings back on the path replaces it.
static YkStatus solve_beside(YkPath *path, double at, double off, bool along)
{
    YkState *s = path->state;
    YkStatus status = yk_path_set(path, beside(path, at, off), along);
    if (status == YK_OK) status = yk_state_solve(s);
    if (status < 0 || s->is_kept) return status;
    status = yk_path_set(path, at, along); // stands for this place: the inputs are those requested, to the last bit
    if (status < 0) return status;
    memcpy(s->valid_input, s->input, 3 * s->mech->input_count * sizeof *s->input);
    s->has_rates = s->is_regular = false;
    yk_state_tell(s, &s->space, YK_SINGULAR);
    return YK_SINGULAR;
}

YkStatus yk_path_try(YkPath *path, double at, bool along)
{
    if (at != path->last) path->way = at > path->last ? 1 : -1;
    YkStatus status = yk_path_set(path, at, along);
    if (status < 0) return status;
    status = yk_state_solve(path->state);
    if (status < 0 && path->state->has_pose) status = solve_beside(path, at, 1e-15, along);
    if (status >= 0 && path->state->is_kept) status = solve_beside(path, at, 4e-12, along);
    if (status >= 0 && path->state->is_kept) status = keep_from_beside(path, at, along);
    if (yk_path_is_time(path)) path->state->time = at;
    if (status >= 0) path->last = at;
    return status;
}

void yk_path_refer(YkPath *path)
{
    yk_path_refer_state(path->state);
}

void yk_path_refer_state(YkState *s)
{
    if (s->space.margin[0] > YK_BRANCH_MARGIN) yk_state_refer(s);
}

YkStatus yk_path_probe(YkPath *path, double at, bool along)
{
    YkStatus status = yk_path_try(path, at, along);
    if (status >= 0) yk_path_refer(path);
    return status;
}

void yk_path_settle(YkPath *path)
{
    YkState *s = path->state;
    if (yk_path_probe(path, path->last, false) >= 0) return;
    s->has_rates = false;
    for (size_t i = 0; i < s->mech->input_count; i++)
        memcpy(s->valid_input + 3 * i + 1, s->input + 3 * i + 1, 2 * sizeof *s->input);
}

double yk_path_limit(YkPath *path, double good, double bad)
{
    for (int k = 0; k < 100; k++) {
        double middle = 0.5 * (good + bad);
        if (middle == good || middle == bad || fabs(bad - good) < 1e-15 * yk_path_scale(path)) break;
        if (yk_path_probe(path, middle, true) >= 0 && path->state->space.margin[0] >= 0) // not by tolerance alone
            good = middle;
        else
            bad = middle;
    }
    yk_path_probe(path, good, true);
    return good;
}
