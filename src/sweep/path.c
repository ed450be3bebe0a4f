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

// Returns the rate of the fastest input: rad/s, or machine sizes per second.
static double fastest(const YkState *s)
{
    double rate = 0;
    for (size_t i = 0; i < s->mech->input_count; i++)
        rate = fmax(rate, fabs(s->input[3 * i + 1]) / yk_input_unit(s->mech, i));
    return rate;
}

// Returns the length of the line: rad, or machine sizes.
static double length_of_line(const YkPath *path)
{
    const YkMechanism *mech = path->state->mech;
    double longest = 0;
    for (size_t i = 0; i < mech->input_count; i++) {
        double way = fabs(path->goal[3 * i] - path->others[3 * i]);
        longest = fmax(longest, way / yk_input_unit(mech, i));
    }
    return longest;
}

double yk_path_scale(const YkPath *path)
{
    if (path->is_line) return 1 / fmax(length_of_line(path), 1e-300);
    if (path->input < 0) return 1 / fmax(1, fastest(path->state));
    return yk_input_unit(path->state->mech, (size_t)path->input);
}

// Sets a point on a line: exactly the goal at its end.
static void set_on_line(const YkPath *path, double at, bool along)
{
    YkState *s = path->state;
    for (size_t i = 0; i < s->mech->input_count; i++) {
        const double *from = path->others + 3 * i, *to = path->goal + 3 * i;
        double *input = s->input + 3 * i;
        input[0] = at == 1 ? to[0] : from[0] + at * (to[0] - from[0]);
        input[1] = along ? to[0] - from[0] : to[1];
        input[2] = along ? 0 : to[2];
    }
}

// Sets the inputs at a time; an input whose position is held has no rate along the path.
static YkStatus set_at_time(const YkPath *path, double time, bool along)
{
    YkState *s = path->state;
    YkStatus status = yk_state_set_time(s, time, NULL);
    for (size_t i = 0; along && i < s->mech->input_count; i++)
        if (s->is_held[3 * i]) s->input[3 * i + 1] = s->input[3 * i + 2] = 0;
    return status;
}

double yk_path_length(YkPath *path, double from, double to)
{
    enum { SAMPLES = 64 };
    if (!yk_path_is_time(path)) return fabs(to - from) / yk_path_scale(path);
    double sum = 0, time = path->state->time;
    for (int k = 0; k < SAMPLES; k++) // at unequal distances: equal ones might all meet the same phase
        if (yk_path_set(path, from + (to - from) * (k + 0.5 + 0.3 * yk_sin(k)) / SAMPLES, true) >= 0)
            sum += fastest(path->state);
    yk_path_set(path, time, true);
    return sum / SAMPLES * fabs(to - from);
}

// Sets the coordinate; the other inputs stay where the path began.
static void set_coordinate(const YkPath *path, double at, bool along)
{
    YkState *s = path->state;
    memcpy(s->input, path->others, 3 * s->mech->input_count * sizeof *s->input);
    for (size_t i = 0; along && i < s->mech->input_count; i++) s->input[3 * i + 1] = s->input[3 * i + 2] = 0;
    s->input[3 * path->input] = at;
    if (along) s->input[3 * path->input + 1] = 1;
}

YkStatus yk_path_set_inputs(const YkPath *path, double at, bool along)
{
    if (path->is_line)
        set_on_line(path, at, along);
    else if (path->input >= 0)
        set_coordinate(path, at, along);
    else
        return set_at_time(path, at, along);
    return YK_OK;
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
