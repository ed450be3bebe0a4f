// Finds on which side of a block's known change point the inputs are. If one input leads there, its value decides. If
// several do together, poses decide: the sine of the transmission angle, with a sign, is nearly a straight line along
// any one input, so poses a little farther along it on both sides give the value here to rounding.
#include "sweep/meeting.h"
#include <string.h>

double yk_meeting_tolerance(const YkMeeting *m, const YkState *s)
{
    const double ROUNDING = 1e-15; // of a sine squared, shared out over the distance of the poses
    double size = fabs(m->at / m->unit);
    for (size_t i = 0; m->is_shared && i < s->mech->input_count; i++)
        size = fmax(size, fabs(s->input[3 * i]) / yk_input_unit(s->mech, i));
    return fmax(1e-11, m->is_shared ? ROUNDING / (m->near * m->slope) : 0) * fmax(1, 1e-4 * size);
}

int yk_meeting_side(const YkMeeting *m, const YkState *s, double off)
{
    return fabs(off) > yk_meeting_tolerance(m, s) ? (off > 0) - (off < 0) : 0;
}

// --- several inputs

static bool place(const YkPath *path, size_t block, double at, int level);

static void set_sign(const YkPath *path, size_t block, int side)
{
    const YkMeeting *m = &path->meetings[block];
    path->state->branch[block] = (signed char)((side != 0 ? side : m->side) * m->above);
}

static bool is_placed(const YkMeeting *m)
{
    return m->is_known && !m->is_off;
}

// Returns how far the input as it is set, or the place `at`, is from a change point to which it leads alone.
static double off_of_one(const YkPath *path, const YkMeeting *m, double at)
{
    return ((m->input == YK_NONE ? at : path->state->input[3 * m->input]) - m->at) / m->unit;
}

// Returns the side on which a distance lies after `steps` more along the same input; 0 if it must be looked at anew,
// since the sine may now be steeper, or less, than where the change point was found.
static int side_after(double off, double steps)
{
    const double CLEAR = 0.3;
    bool goes_over = fabs(off) < CLEAR * fabs(steps), stays = off * steps >= 0 || CLEAR * fabs(off) > fabs(steps);
    return goes_over ? (steps > 0) - (steps < 0) : stays ? (off > 0) - (off < 0) : 0;
}

// Gives the blocks before this one their signs where its input has been moved by `steps` from where `level` knows them.
// Most follow from that, so the cost does not multiply from block to block. Returns false if they cannot be told.
static bool place_moved(const YkPath *path, size_t block, double steps, double at, int level)
{
    const YkMeeting *own = &path->meetings[block];
    for (size_t k = 0; k < block; k++) {
        const YkMeeting *m = &path->meetings[k];
        if (!is_placed(m)) continue;
        int side = 0;
        if (!m->is_shared)
            side = yk_meeting_side(m, path->state, off_of_one(path, m, at));
        else if (!isnan(m->off[level])) {
            side = m->input == own->input ? side_after(m->off[level], steps) : 0;
            if (side == 0) return place(path, block, at, level + 1);
        }
        set_sign(path, k, side);
    }
    return true;
}

// Returns the sine of the block's transmission angle with the input changed by `steps` units; negative if it does not
// close. With 0 steps the blocks before have their signs already.
static double sine_beside(const YkPath *path, size_t block, double steps, double at, int level)
{
    YkState *s = path->state;
    const YkMeeting *m = &path->meetings[block];
    double *input = &s->input[3 * m->input], here = *input;
    *input = here + steps * m->unit;
    bool is_told = steps == 0 || place_moved(path, block, steps, at, level);
    YkRun run = yk_state_run(s, &s->spare);
    yk_run_begin(&run);
    yk_run_steps(&run, 0, m->step_count);
    yk_state_spend(s, m->step_count);
    *input = here;
    double margin = s->spare.block_margin[block];
    return is_told && margin >= YK_LIMIT_MARGIN ? sqrt(fmax(margin, 0)) : -1; // a little below zero is rounding
}

// Returns how far the inputs, as they are set, are beyond the change point along one of them, interpolated between
// poses on both sides; NaN if it does not close.
static double off_by_poses(const YkPath *path, size_t block, double at, int level)
{
    static const double weights[] = {0.75, -0.3, 0.05};
    const YkMeeting *m = &path->meetings[block];
    double sum = 0;
    for (int k = 0; k < 3; k++) {
        double after = sine_beside(path, block, (k + 1) * m->near, at, level);
        double before = sine_beside(path, block, -(k + 1) * m->near, at, level);
        if (!(before >= 0 && after >= 0)) return NAN;
        sum += weights[k] * (after - before);
    }
    return sum / m->slope;
}

// Returns how far the inputs, as they are set, are from a change point on which several of them decide; NaN if that
// cannot be told, which is far from it. Farther off than the poses that interpolate, the side is the one to which the
// sine rises.
static double off_of_several(const YkPath *path, size_t block, double at, int level)
{
    const double FAR = 0.2;
    const YkMeeting *m = &path->meetings[block];
    double here = sine_beside(path, block, 0, at, level), off = here / m->slope;
    if (!(here >= 0 && here < FAR)) return NAN;
    if (off < 0.5 * m->near) return off_by_poses(path, block, at, level);
    double before = sine_beside(path, block, -off, at, level), after = sine_beside(path, block, off, at, level);
    if (before >= 0 && before < 0.5 * here && after > 1.4 * here) return off;
    return after >= 0 && after < 0.5 * here && before > 1.4 * here ? -off : (double)NAN;
}

// --- any

// Returns how far the inputs as they are set, at the place `at`, are from the change point, in units. The blocks before
// have their signs; afterwards, if it is shared, they have not.
static double off_here(const YkPath *path, size_t block, double at, int level)
{
    const YkMeeting *m = &path->meetings[block];
    return m->is_shared ? off_of_several(path, block, at, level) : off_of_one(path, m, at);
}

// Gives the blocks before this one the signs that they have for the inputs as they are set, and keeps their distances
// as those of `level`: one for every time that inputs are moved from where they are known already. Returns false if
// there are too many.
static bool place(const YkPath *path, size_t block, double at, int level)
{
    if (level == YK_MEETING_LEVELS) return false;
    for (size_t k = 0; k < block && k < path->meeting_count; k++) {
        YkMeeting *m = &path->meetings[k];
        if (!is_placed(m)) continue;
        m->off[level] = off_here(path, k, at, level);
        for (size_t j = 0; m->is_shared && j < k; j++)
            if (is_placed(&path->meetings[j]))
                set_sign(path, j, yk_meeting_side(&path->meetings[j], path->state, path->meetings[j].off[level]));
        set_sign(path, k, yk_meeting_side(m, path->state, m->off[level]));
    }
    return true;
}

void yk_path_place_signs(const YkPath *path, double at)
{
    place(path, path->meeting_count, at, 0);
}

// Returns it on the path at `at`, where one input is moved on by that much.
static double off_on_path(const YkPath *path, size_t block, double at, size_t input, double move)
{
    YkState *s = path->state;
    double now = s->time, *kept = path->others + 3 * s->mech->input_count;
    size_t bytes = 3 * s->mech->input_count * sizeof *kept;
    memcpy(kept, s->input, bytes);
    memcpy(path->signs, s->branch, path->meeting_count);
    bool is_set = yk_path_set_inputs(path, at, true) >= 0;
    s->input[3 * input] += move;
    place(path, block, at, 0);
    double off = is_set ? off_here(path, block, at, 0) : (double)NAN;
    s->time = now;
    memcpy(s->input, kept, bytes);
    memcpy(s->branch, path->signs, path->meeting_count);
    return off;
}

double yk_meeting_off_at(const YkPath *path, size_t block, double at)
{
    YkMeeting *m = &path->meetings[block];
    if (!m->is_shared)
        return ((m->input == YK_NONE ? at : yk_path_input_at(path, (size_t)m->input, at)) - m->at) / m->unit;
    for (int k = 0; k < YK_MEETING_SEEN; k++)
        if (m->seen_at[k] == at) return m->seen_off[k];
    double off = off_on_path(path, block, at, 0, 0);
    m->seen_at[m->seen] = at, m->seen_off[m->seen] = off;
    m->seen = (m->seen + 1) % YK_MEETING_SEEN;
    return off;
}

double yk_meeting_rise(const YkPath *path, size_t block, double at, size_t input)
{
    double near = path->meetings[block].near, step = near * yk_input_unit(path->state->mech, input);
    double after = off_on_path(path, block, at, input, step), before = off_on_path(path, block, at, input, -step);
    double rise = (after - before) / (2 * near);
    return fabs(rise) > 1e-6 ? rise : 0;
}

int yk_meeting_side_beside(const YkPath *path, size_t block, double at, double way)
{
    enum { DOUBLINGS = 80 };
    const YkMeeting *m = &path->meetings[block];
    double step = 1e-13 * fmax(yk_path_scale(path), fabs(at));
    int side = yk_meeting_side(m, path->state, yk_meeting_off_at(path, block, at));
    if (side == 0 && m->input == YK_NONE) return way > 0 ? 1 : -1;
    for (int k = 0; k < DOUBLINGS && side == 0; k++, step *= 2) {
        double off = yk_meeting_off_at(path, block, at + way * step);
        if (!isfinite(off)) return 0;
        side = yk_meeting_side(m, path->state, 0.25 * off);
    }
    return side;
}
