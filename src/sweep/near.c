// Distances on a path, measured by how far the inputs go. While a drive rests, time does not show which poses are near:
// a whole dwell is one pose.
#include "sweep/path.h"
#include <string.h>

// Puts how far input i is from its position at `at` into u[i], rad or machine sizes, for the place `to` of a path over
// time. The state's inputs stay as they are. Returns false if a drive has no value at one of the places.
static bool displacement(const YkPath *path, double at, double to, double *u)
{
    YkState *s = path->state;
    const YkMechanism *mech = s->mech;
    double time = s->time, *kept = path->others + 3 * mech->input_count;
    memcpy(kept, s->input, 3 * mech->input_count * sizeof *kept);
    bool ok = yk_state_set_time(s, at, NULL) >= 0;
    for (size_t i = 0; i < mech->input_count; i++) u[i] = s->input[3 * i];
    ok = ok && yk_state_set_time(s, to, NULL) >= 0;
    for (size_t i = 0; i < mech->input_count; i++) {
        u[i] = (s->input[3 * i] - u[i]) / yk_input_unit(mech, i);
        ok = ok && isfinite(u[i]);
    }
    s->time = time;
    memcpy(s->input, kept, 3 * mech->input_count * sizeof *kept);
    return ok;
}

double yk_path_input_at(const YkPath *path, size_t input, double time)
{
    YkState *s = path->state;
    double now = s->time, *kept = path->others + 3 * s->mech->input_count;
    size_t bytes = 3 * s->mech->input_count * sizeof *kept;
    memcpy(kept, s->input, bytes);
    double value = yk_state_set_time(s, time, NULL) >= 0 ? s->input[3 * input] : (double)NAN;
    s->time = now;
    memcpy(s->input, kept, bytes);
    return value;
}

// Returns the largest displacement of an input; infinite if a drive has no value.
static double largest(const YkPath *path, double at, double to)
{
    double *u = path->others + 6 * path->state->mech->input_count, most = 0;
    if (!displacement(path, at, to, u)) return INFINITY;
    for (size_t i = 0; i < path->state->mech->input_count; i++) most = fmax(most, fabs(u[i]));
    return most;
}

double yk_path_way(const YkPath *path, double a, double b)
{
    if (!(isfinite(a) && isfinite(b))) return INFINITY;
    if (!yk_path_is_time(path)) return fabs(b - a) / yk_path_scale(path);
    double early = a + 0.29 * (b - a),
           late = a + 0.62 * (b - a); // at unequal distances, for the sake of periodic drives
    return fmax(largest(path, a, early), fmax(largest(path, a, late), largest(path, a, b)));
}

double yk_path_off(const YkPath *path, double at, double way, double distance)
{
    enum { DOUBLINGS = 64, HALVINGS = 50 };
    double near = 0, far = distance * yk_path_scale(path), gone = 0;
    if (!yk_path_is_time(path)) return at + way * far;
    for (int k = 0; k < DOUBLINGS && (gone = largest(path, at, at + way * far)) < 0.5 * distance; k++)
        near = far, far *= 2;
    for (int k = 0; k < HALVINGS && !(gone >= 0.5 * distance && gone < 2 * distance); k++) {
        double middle = 0.5 * (near + far);
        gone = largest(path, at, at + way * middle);
        if (gone < 0.5 * distance)
            near = middle;
        else
            far = middle;
    }
    return gone >= 0.5 * distance && isfinite(gone) ? at + way * far : (double)NAN;
}

double yk_path_between(const YkPath *path, double a, double b, double part)
{
    if (!yk_path_is_time(path)) return a + part * (b - a);
    double way = largest(path, a, b), near = 0, far = 1;
    for (int k = 0; k < 60; k++) {
        double middle = 0.5 * (near + far);
        if (largest(path, a, a + middle * (b - a)) < part * way)
            near = middle;
        else
            far = middle;
    }
    return a + 0.5 * (near + far) * (b - a);
}

double yk_path_heads(const YkPath *path, size_t input, double at, double way)
{
    double *u = path->others + 6 * path->state->mech->input_count;
    double place = yk_path_off(path, at, way, 1e-5);
    return isfinite(place) && displacement(path, at, place, u) ? u[input] : 0;
}

bool yk_path_turns_back(const YkPath *path, double at)
{
    if (!yk_path_is_time(path)) return false;
    double sum = 0;
    for (size_t i = 0; i < path->state->mech->input_count; i++)
        sum += yk_path_heads(path, i, at, 1) * yk_path_heads(path, i, at, -1);
    return !(sum < 0); // or it never moves again
}

double yk_path_rate(const YkPath *path, size_t i, double side)
{
    if (yk_path_is_time(path)) return side * yk_path_heads(path, i, path->last, side); // it may rest there
    const YkState *s = path->state;
    double rate = path->is_line ? path->goal[3 * i] - path->others[3 * i] : (double)((size_t)path->input == i);
    return rate / yk_input_unit(s->mech, i);
}

double yk_path_heading(const YkPath *path)
{
    const YkState *s = path->state;
    bool is_time = yk_path_is_time(path);
    double sum = 0;
    for (size_t i = 0; i < s->mech->input_count; i++) {
        if (s->arrival[i] != s->valid_input[3 * i]) return 0; // it has been put elsewhere since
        sum += s->heading[i] * yk_path_rate(path, i, 1);
    }
    if (is_time && s->time_heading != 0 && s->arrival_time == path->last) return s->time_heading;
    return (sum > 0) - (sum < 0);
}
