// Follows one period of a motion that repeats itself, and skips the other periods.
#include "sweep/turns.h"
#include <string.h>

enum { TURNS_MAX = 64, PERIODS_MAX = 64, WORTH_IT = 4 };
static const double DRIFT = 1e-6, RETURNED = 1e-6; // rad, or lengths over the size

static double way_of(const YkPath *path, size_t input)
{
    return path->goal[3 * input] - path->others[3 * input];
}

// Returns the least change of an input that moves; 0 if a distance moves.
static double least_way(const YkPath *path)
{
    const YkMechanism *mech = path->state->mech;
    double least = INFINITY;
    for (size_t i = 0; i < mech->input_count; i++) {
        double way = fabs(way_of(path, i));
        if (way > 0 && mech->coordinates[mech->inputs[i]].is_distance) return 0;
        if (way > 0) least = fmin(least, way);
    }
    return isfinite(least) ? least : 0;
}

double yk_turns_period(const YkPath *path)
{
    double least = least_way(path);
    for (int k = 1; least > 0 && k <= TURNS_MAX; k++) {
        double period = k * 2 * YK_PI / least, off = 0;
        if (period * WORTH_IT > 1) return 0;
        for (size_t i = 0; i < path->state->mech->input_count; i++) {
            double turns = period * way_of(path, i) / (2 * YK_PI);
            off = fmax(off, fabs(turns - rint(turns)));
        }
        if (off / period < DRIFT) return period;
    }
    return 0;
}

// A pose, for comparison with later ones.
typedef struct Memory {
    YkArena *arena;                          // of all arrays
    double *reference, *distance, *slot, *x; // angles with their turns; distances; references; group columns
    signed char *branch;
} Memory;

static bool make_room(Memory *m, const YkMechanism *mech)
{
    YkArena *a = m->arena = yk_arena_new();
    m->reference = yk_arena_alloc(a, mech->coordinate_count + 1, sizeof *m->reference);
    m->distance = yk_arena_alloc(a, mech->coordinate_count + 1, sizeof *m->distance);
    m->slot = yk_arena_alloc(a, mech->reference_count + 1, sizeof *m->slot);
    m->x = yk_arena_alloc(a, mech->column_count + 1, sizeof *m->x);
    m->branch = yk_arena_alloc(a, mech->block_count + 1, 1);
    return !yk_arena_failed(a);
}

static void remember(Memory *m, const YkState *s)
{
    const YkMechanism *mech = s->mech;
    for (size_t c = 0; c < mech->coordinate_count; c++)
        (mech->coordinates[c].is_distance ? m->distance : m->reference)[c] = yk_state_coordinate(s, c).position;
    memcpy(m->slot, s->slot_reference, mech->reference_count * sizeof *m->slot);
    memcpy(m->x, s->valid_x, mech->column_count * sizeof *m->x);
    memcpy(m->branch, s->branch, mech->block_count);
}

static bool is_whole(double turn)
{
    return fabs(yk_nearest_turn(turn, 0)) < RETURNED;
}

// Returns whether the machine is in the same pose as then, up to whole turns.
static bool has_returned(const Memory *m, const YkState *s)
{
    const YkMechanism *mech = s->mech;
    for (size_t b = 0; b < mech->block_count; b++)
        if (s->branch[b] != m->branch[b]) return false;
    for (size_t c = 0; c < mech->coordinate_count; c++) {
        double now = yk_state_coordinate(s, c).position;
        bool same = mech->coordinates[c].is_distance ? fabs(now - m->distance[c]) < RETURNED * mech->size
                                                     : is_whole(now - m->reference[c]);
        if (!same) return false;
    }
    for (size_t k = 0; k < mech->reference_count; k++)
        if (!is_whole(s->slot_reference[k] - m->slot[k])) return false;
    return true;
}

static double whole(double turn)
{
    return 2 * YK_PI * rint(turn / (2 * YK_PI));
}

// Advances the pose by `count` stretches: the same vectors, with the turns counted.
static void skip(YkWalk *w, const Memory *m, double at, double count)
{
    YkState *s = w->path.state;
    const YkMechanism *mech = s->mech;
    for (size_t c = 0; c < mech->coordinate_count; c++)
        if (!mech->coordinates[c].is_distance)
            s->reference[c] += count * whole(yk_state_coordinate(s, c).position - m->reference[c]);
    for (size_t k = 0; k < mech->reference_count; k++)
        s->slot_reference[k] += count * whole(s->slot_reference[k] - m->slot[k]);
    for (size_t k = 0; k < mech->column_count; k++)
        if (!mech->group_columns[k].is_distance) s->valid_x[k] += count * whole(s->valid_x[k] - m->x[k]);
    yk_path_set(&w->path, at, true);
    memcpy(s->valid_input, s->input, 3 * mech->input_count * sizeof *s->input);
    w->is_witnessed = false; // the same pose: what is left begins there
}

static size_t count_passes(const YkWalk *w)
{
    size_t count = 0;
    for (size_t k = 0; k < w->event_count; k++) count += w->events[k].kind == YK_EVENT_CHANGE_POINT;
    return count + w->more_events;
}

static double skip_from(YkWalk *w, Memory *m, double period)
{
    // Not the position in which the machine was put together: that may be a change point.
    const double start = 0.381966 * period;
    double at = 0;
    size_t passes = 0;
    for (int k = 0; k <= PERIODS_MAX && start + k * period < 1; k++) {
        double next = start + k * period;
        if (!yk_walk_go(w, at, next)) return -1;
        at = next;
        if (k == 0) {
            remember(m, w->path.state);
            passes = count_passes(w);
            continue;
        }
        if (!has_returned(m, w->path.state)) continue;
        double stretches = floor((1 - at) / (k * period) - 1e-9);
        if (stretches < 1) return at;
        at += stretches * k * period;
        skip(w, m, at, stretches);
        w->skipped_passes += stretches * (double)(count_passes(w) - passes);
        return yk_path_probe(&w->path, at, true) < 0 ? -1 : at;
    }
    return at;
}

double yk_turns_skip(YkWalk *w, double period)
{
    Memory memory = {0};
    double at = -1;
    if (make_room(&memory, w->path.state->mech))
        at = skip_from(w, &memory, period);
    else
        w->failed = true;
    yk_arena_free(memory.arena);
    return at;
}
