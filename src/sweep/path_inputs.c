// The inputs at places of a path, and the unit in which the path is measured.
#include <string.h>
#include "sweep/path.h"

double yk_path_fastest(const YkState *s)
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
    if (path->input < 0) return 1 / fmax(1, yk_path_fastest(path->state));
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
