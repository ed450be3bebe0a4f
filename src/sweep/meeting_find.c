// Finds change points by the place of the input, or the inputs, that lead to them.
#include "sweep/meeting.h"

static const double MEETS = 1e-11, MEETS_LIMIT = YK_SINGULAR_MARGIN, START = 1e-4; // sin^2

static int side_at(const YkWalk *w, size_t block, double at)
{
    return yk_meeting_side(&w->path.meetings[block], w->path.state, yk_meeting_off_at(&w->path, block, at));
}

typedef struct Search {
    YkWalk *walk;
    size_t block;
    YkMeeting meeting;
    double place; // on the path, where the other inputs are as they are here
    double h;     // the distance between poses, in units
} Search;

// Returns the sine of the block's transmission angle; negative if it cannot be found.
static double sine_at(const Search *f, double value)
{
    const YkPath *path = &f->walk->path;
    YkState *s = path->state;
    bool is_place = f->meeting.input == YK_NONE;
    if (yk_path_set_inputs(path, is_place ? value : f->place, true) < 0) return -1;
    if (!is_place) s->input[3 * f->meeting.input] = value;
    yk_path_place_signs(path, is_place ? value : f->place);
    YkStatus status = yk_state_solve(s);
    if (status < 0 && s->report.block <= (int)f->block) return -1;
    double margin = (status < 0 ? &s->spare : &s->space)->block_margin[f->block];
    return margin >= YK_LIMIT_MARGIN ? sqrt(fmax(margin, 0)) : -1; // a little below zero is rounding
}

// Moves a first guess to where the sine, nearly a straight line, is about zero. The guess may be some steps off.
static bool come_closer(const Search *f, double *value)
{
    for (int k = 0; k < 4; k++) {
        double step = f->h * f->meeting.unit, here = sine_at(f, *value);
        double before = sine_at(f, *value - step), after = sine_at(f, *value + step);
        if (here < 0 || before < 0 || after < 0) return false;
        double slope = fmax(fabs(after - here), fabs(before - here)) / step;
        if (!(slope > 0)) return false;
        double way = fmin(here / slope, 10 * step);
        if (way < 0.02 * step) return true;
        *value += after < before ? way : -way;
    }
    return true;
}

// Corrects the value by a polynomial through three poses on each side, on which the sine has one sign each. Returns
// false unless that is smooth there, and about a straight line.
static bool correct(const Search *f, double *value)
{
    double step = f->h * f->meeting.unit, before[4], after[4];
    for (int k = 1; k < 4; k++) {
        before[k] = sine_at(f, *value - k * step);
        after[k] = sine_at(f, *value + k * step);
        if (!(before[k] > 0 && after[k] > 0)) return false;
    }
    double level = 0.75 * (after[1] - before[1]) - 0.3 * (after[2] - before[2]) + 0.05 * (after[3] - before[3]);
    double slope = (45 * (after[1] + before[1]) - 9 * (after[2] + before[2]) + after[3] + before[3]) / 60;
    double twice = (after[2] + before[2]) / (after[1] + before[1]);
    if (!(twice > 1.6 && twice < 2.4 && slope > 0 && fabs(level) < 0.3 * slope)) return false;
    *value -= level / slope * step;
    return true;
}

// Returns whether the value half a step away is what the poses farther away say: a limit or another change point may be
// near.
static bool is_smooth(const Search *f, double value)
{
    static const double weights[] = {75.0 / 128, -25.0 / 256, 3.0 / 256}; // midway between six poses
    double step = f->h * f->meeting.unit, sum = 0, sine[5];
    for (int k = 1; k < 5; k++) sine[k] = sine_at(f, value + (k - 0.5) * step);
    double nearer = sine_at(f, value - 0.5 * step), farther = sine_at(f, value - 1.5 * step);
    double middle = sine_at(f, value + step);
    if (!(nearer > 0 && farther > 0 && sine[4] > 0)) return false;
    sum = weights[0] * (sine[1] + sine[2]) + weights[1] * (sine[3] - nearer) + weights[2] * (sine[4] - farther);
    return fabs(sum - middle) < 1e-5 * middle + 1e-14 / f->h;
}

// Looks for the change point from a value near it, with poses ever closer to it.
static bool find_value(Search *f, double *value)
{
    static const double steps[] = {1e-3, 2e-4, 4e-5};
    double first = *value;
    for (int k = 0; k < 3; k++) {
        f->h = steps[k];
        *value = first;
        bool ok = come_closer(f, value) && correct(f, value) && correct(f, value) && correct(f, value);
        if (!ok || !is_smooth(f, *value)) continue;
        double least = sine_at(f, *value),
               meets = yk_path_is_time(&f->walk->path) && f->meeting.input == YK_NONE ? MEETS_LIMIT : MEETS;
        return least >= 0 && least * least <= meets;
    }
    return false;
}

// Finds the input that leads to the change point: over time, the only drive on which the block depends.
static bool find_input(Search *f)
{
    YkPath *path = &f->walk->path;
    YkState *s = path->state;
    const YkMechanism *mech = s->mech;
    size_t count = 0, depends = 0;
    f->meeting.input = YK_NONE;
    for (int pass = 0; pass < 2; pass++)
        for (size_t i = 0; i < mech->input_count; i++) {
            if (mech->coordinates[mech->inputs[i]].drive == YK_NONE || s->is_held[3 * i]) continue;
            if (pass == 0) {
                count++;
                f->meeting.input = (int32_t)i;
                continue;
            }
            Search one = *f;
            one.meeting.input = (int32_t)i;
            double value = yk_path_input_at(path, i, f->place), off = 1e-3 * yk_input_unit(mech, i);
            if (sine_at(&one, value) == sine_at(&one, value + off)) continue;
            depends++;
            f->meeting.input = (int32_t)i;
        }
    return count == 1 || depends == 1;
}

// Makes the place on the path count. The unit of time is one in which the block turns by not much more than a radian.
static void take_place(Search *f)
{
    enum { QUARTERS = 16 };
    YkPath *path = &f->walk->path;
    f->meeting.input = YK_NONE;
    yk_path_set(path, f->place, true);
    f->meeting.unit = yk_path_scale(path);
    for (int k = 0; yk_path_is_time(path) && k < QUARTERS; k++) {
        double before = sine_at(f, f->place - 1e-3 * f->meeting.unit),
               after = sine_at(f, f->place + 1e-3 * f->meeting.unit);
        if (before < 0.01 && after < 0.01) return;
        f->meeting.unit *= 0.25;
    }
}

static bool find_by_input(Search *f)
{
    const YkPath *path = &f->walk->path;
    if (!yk_path_is_time(path) || !find_input(f)) return false;
    f->meeting.unit = yk_input_unit(path->state->mech, (size_t)f->meeting.input);
    f->meeting.at = yk_path_input_at(path, (size_t)f->meeting.input, f->place);
    return isfinite(f->meeting.at) && find_value(f, &f->meeting.at);
}

static bool find_by_place(Search *f)
{
    take_place(f);
    f->meeting.at = f->place;
    return find_value(f, &f->meeting.at);
}

// Returns how much the sine changes along an input, per unit.
static double slope_along(const Search *f, size_t input)
{
    const double H = 1e-3;
    Search one = *f;
    one.meeting.input = (int32_t)input;
    double unit = yk_input_unit(f->walk->path.state->mech, input), value = f->walk->path.state->input[3 * input];
    double before = sine_at(&one, value - H * unit), here = sine_at(&one, value),
           after = sine_at(&one, value + H * unit);
    sine_at(&one, value);
    return before < 0 || here < 0 || after < 0 ? 0 : fmax(fabs(after - here), fabs(before - here)) / H;
}

// Returns the number of steps that lead to a block and solve it; 0 if a group is among them, which has no closed form.
static size_t steps_up_to(const YkMechanism *mech, size_t block)
{
    for (size_t k = 0; k < mech->step_count; k++) {
        if (mech->steps[k].kind != YK_STEP_BLOCK) continue;
        if (mech->blocks[mech->steps[k].target].kind == YK_BLOCK_GROUP) return 0;
        if ((size_t)mech->steps[k].target == block) return k + 1;
    }
    return 0;
}

// Finds the change point along the input that leads there fastest, with the others as they are here: on the path they
// all move.
static bool find_by_several(Search *f)
{
    const YkState *s = f->walk->path.state;
    const double CLEARLY = 1.01; // else the first: blocks that are alike take the same one
    double most = 0;
    f->meeting.input = YK_NONE;
    f->meeting.step_count = steps_up_to(s->mech, f->block);
    if (f->meeting.step_count == 0 || yk_path_set(&f->walk->path, f->place, true) < 0) return false;
    for (size_t i = 0; i < s->mech->input_count; i++) {
        double slope = slope_along(f, i);
        if (slope <= CLEARLY * most) continue;
        most = slope;
        f->meeting.input = (int32_t)i;
    }
    if (f->meeting.input == YK_NONE) return false;
    f->meeting.unit = yk_input_unit(s->mech, (size_t)f->meeting.input);
    f->meeting.at = s->input[3 * f->meeting.input];
    if (!find_value(f, &f->meeting.at)) return false;
    double step = f->h * f->meeting.unit;
    f->meeting.slope = (sine_at(f, f->meeting.at + step) + sine_at(f, f->meeting.at - step)) / (2 * f->h);
    for (int k = 0; k < YK_MEETING_SEEN; k++) f->meeting.seen_at[k] = NAN;
    return f->meeting.is_shared = f->meeting.slope > 0;
}

static bool find(YkWalk *w, size_t block, double at, YkMeeting *meeting)
{
    if (block >= w->path.meeting_count || !yk_walk_has_margin(w, block)) return false;
    Search f = {.walk = w, .block = block, .place = at};
    bool is_of_one = w->path.input >= 0; // the others rest
    w->path.meetings[block].is_known = false;
    if (!find_by_input(&f) && !(!is_of_one && find_by_several(&f)) && !find_by_place(&f) &&
        !(is_of_one && find_by_several(&f)))
        return false;
    *meeting = f.meeting;
    meeting->is_known = true;
    meeting->near = f.h;
    return true;
}

// Returns whether a change point is the one that was known before: whichever input was followed to it, the sine is the
// same.
static bool is_same(YkWalk *w, size_t block, YkMeeting old, YkMeeting m, double at)
{
    if (!old.is_known || old.is_shared != m.is_shared) return false;
    if (!m.is_shared) return old.input == m.input && fabs(old.at - m.at) < 0.1 * m.near * m.unit;
    w->path.meetings[block] = old;
    double before = fabs(old.slope * yk_meeting_off_at(&w->path, block, at));
    w->path.meetings[block] = m;
    return fabs(before - fabs(m.slope * yk_meeting_off_at(&w->path, block, at))) < 0.1 * m.near * m.slope;
}

static void keep(YkWalk *w, size_t block, YkMeeting m, int side)
{
    w->path.meetings[block].is_known = false;
    if (side == 0) return;
    m.side = (signed char)side;
    m.above = (signed char)(side * w->path.state->branch[block]);
    w->path.meetings[block] = m;
}

bool yk_walk_meets(YkWalk *w, size_t block, double at, double known, double way)
{
    YkMeeting m, old = block < w->path.meeting_count ? w->path.meetings[block] : (YkMeeting){0};
    if (old.is_known) yk_path_set(&w->path, known, true); // its sign there
    if (!find(w, block, at, &m)) return false;
    if (is_same(w, block, old, m, known)) {
        w->path.meetings[block] = old;
        return true;
    }
    w->path.meetings[block] = m;
    int side = side_at(w, block, known);
    bool is_off = isnan(yk_meeting_off_at(&w->path, block, known));
    if (side == 0 && !is_off) side = yk_meeting_side_beside(&w->path, block, known, -way);
    keep(w, block, m, side);
    return side != 0;
}

// Returns the side from which an earlier motion has come to the change point at which the walk begins: its signs hold
// there. If none has, they hold where it goes.
static int side_at_start(const YkWalk *w, size_t block, double at, double way)
{
    const YkPath *path = &w->path;
    const YkMeeting *m = &path->meetings[block];
    const YkState *s = path->state;
    double heading = yk_path_heading(path);
    for (size_t i = 0; m->input != YK_NONE && i < s->mech->input_count; i++)
        if (s->arrival[i] != s->valid_input[3 * i]) return yk_meeting_side_beside(path, block, at, way);
    if (m->input != YK_NONE) heading = s->heading[m->input];
    return heading != 0 ? (heading < 0) - (heading > 0) : yk_meeting_side_beside(path, block, at, way);
}

void yk_walk_begin_at(YkWalk *w, double at, double way)
{
    const YkPath *path = &w->path;
    bool has_looked = false;
    w->has_begun = true;
    for (size_t k = 0; k < path->meeting_count; k++) {
        double margin = path->state->space.block_margin[k];
        YkMeeting m;
        if (!yk_walk_has_margin(w, k) || !(margin < START)) continue;
        has_looked = true;
        bool is_found = find(w, k, at, &m);
        yk_path_probe(&w->path, at, true);
        if (!is_found) continue;
        path->meetings[k] = m;
        int side = side_at(w, k, at);
        if (isnan(yk_meeting_off_at(path, k, at))) path->meetings[k].is_known = false;
        if (!path->meetings[k].is_known) continue;
        keep(w, k, m, side != 0 ? side : side_at_start(w, k, at, way));
    }
    if (has_looked) yk_path_probe(&w->path, at, true);
}
