#include "solve/path.h"
#include <stdlib.h>
#include <string.h>

bool yk_path_start(YkPath *path, YkState *state, int coordinate)
{
    size_t n = 3 * state->mech->input_count;
    *path = (YkPath){.state = state, .input = coordinate < 0 ? -1 : state->mech->coordinates[coordinate].input};
    path->others = malloc((n + 1) * sizeof *path->others);
    if (path->others) memcpy(path->others, state->input, n * sizeof *path->others);
    return path->others != NULL;
}

void yk_path_end(YkPath *path)
{
    free(path->others);
    path->others = NULL;
}

double yk_path_scale(const YkPath *path)
{
    if (path->input < 0) return 1;
    const YkMechanism *mech = path->state->mech;
    return mech->coordinates[mech->inputs[path->input]].is_distance ? mech->size : 1;
}

void yk_path_set(YkPath *path, double at, bool along)
{
    YkState *s = path->state;
    if (path->input < 0) {
        yk_state_set_time(s, at, NULL);
        return;
    }
    memcpy(s->input, path->others, 3 * s->mech->input_count * sizeof *s->input);
    for (size_t i = 0; along && i < s->mech->input_count; i++) s->input[3 * i + 1] = s->input[3 * i + 2] = 0;
    s->input[3 * path->input] = at;
    if (along) s->input[3 * path->input + 1] = 1;
}

YkStatus yk_path_probe(YkPath *path, double at, bool along)
{
    yk_path_set(path, at, along);
    YkStatus status = yk_state_solve(path->state);
    if (status >= 0) yk_state_refer(path->state);
    return status;
}

double yk_path_limit(YkPath *path, double good, double bad)
{
    for (int k = 0; k < 100; k++) {
        double middle = 0.5 * (good + bad);
        if (middle == good || middle == bad || fabs(bad - good) < 1e-15 * yk_path_scale(path)) break;
        if (yk_path_probe(path, middle, true) >= 0)
            good = middle;
        else
            bad = middle;
    }
    yk_path_probe(path, good, true);
    return good;
}
