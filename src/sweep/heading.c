// Remembers the direction in which a motion came to a pose, for the next one that begins there. Exactly at a change point
// the signs of the blocks are those of the side that it came from: going on passes the change point, turning back does
// not.
#include "sweep/path.h"

// Returns how input i moves along the path, per unit of it; only its share in the sum of all counts.
static double rate_of(const YkPath *path, size_t i)
{
    const YkState *s = path->state;
    bool is_distance = s->mech->coordinates[s->mech->inputs[i]].is_distance;
    double rate = path->is_line       ? path->goal[3 * i] - path->others[3 * i]
                  : path->input >= 0  ? (double)((size_t)path->input == i)
                  : s->is_held[3 * i] ? 0
                                      : s->input[3 * i + 1];
    return is_distance ? rate / s->mech->size : rate;
}

double yk_path_heading(const YkPath *path)
{
    const YkState *s = path->state;
    double sum = 0;
    for (size_t i = 0; i < s->mech->input_count; i++) {
        if (s->arrival[i] != s->valid_input[3 * i]) return 0; // it has been put elsewhere since
        sum += s->heading[i] * rate_of(path, i);
    }
    return (sum > 0) - (sum < 0);
}

void yk_path_arrive(const YkPath *path, double way)
{
    YkState *s = path->state;
    for (size_t i = 0; i < s->mech->input_count; i++) {
        s->arrival[i] = s->valid_input[3 * i];
        s->heading[i] = way * rate_of(path, i);
    }
}
