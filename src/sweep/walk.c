// Verified progress. Between two rows the path is probed, more finely wherever a block's margin (sin^2 of its
// transmission angle) could reach zero: a simple zero is a limit position, a double zero a change point, which the
// motion passes with the other sign.
#include "sweep/meeting.h"
#include <string.h>

static const double FASTEST = 1e4, COST_MAX = 2e8; // steps of solution

// Returns whether a place is still at the change point that was passed last, or at the one where the walk began with
// the signs to go on from there.
static bool is_decided(const YkWalk *w, size_t block, double at)
{
    return yk_walk_was_flipped_near(w, block, at) || yk_path_way(&w->path, w->from, at) < 1e-4;
}

// Returns whether only a block is singular at `at`: constraints that repeat it determine the motion, and no branch
// parts.
static bool is_regular(YkWalk *w, double at)
{
    YkState *s = w->path.state;
    return s->mech->redundant_count > 0 && yk_path_try(&w->path, at, true) >= 0 && s->is_regular;
}

// Passes the change point at `at` with the other sign. way: the direction of the motion, +1 or -1.
static void pass(YkWalk *w, size_t block, double at, double way)
{
    YkState *s = w->path.state;
    bool is_seen = !is_regular(w, at), is_turned = yk_path_turns_back(&w->path, at);
    w->path.passed = at;
    w->path.side = way;
    s->branch[block] = (signed char)-s->branch[block];
    if (block < w->path.meeting_count) w->path.meetings[block].is_known = false;
    w->flipped_at[block] = at;
    YkEvent event = {
        .kind = YK_EVENT_CHANGE_POINT, .at = at, .block = (int)block, .is_passed = true, .is_turned = is_turned};
    if (is_seen) yk_walk_note(w, event);
}

// Finds the change point near `at` precisely. Returns false if the motion turns back there, which keeps the sign unless
// it is just the limit to which it has come.
static bool refine(YkWalk *w, size_t block, double *at)
{
    if (yk_path_turns_back(&w->path, *at)) return yk_walk_turns_at_limit(w, block, at);
    *at = yk_walk_refine_touch(w, block, *at, 1.2e-6);
    return true;
}

// Passes the change point near `at`. Returns false if the motion keeps the sign.
static bool flip(YkWalk *w, size_t block, double at, double way)
{
    if (!refine(w, block, &at)) return false;
    pass(w, block, at, way);
    return true;
}

// Passes the change point near `at` if it lies in [a, b]. Otherwise the next interval passes it, or the walk began
// behind it.
static void flip_between(YkWalk *w, size_t block, double at, double a, double b)
{
    double way = copysign(1, b - a);
    if (!refine(w, block, &at) || !yk_walk_closes_beyond(w, block, at, way)) return;
    bool is_behind = (at - a) * way < 0 && yk_path_way(&w->path, at, a) >= 2e-8;
    if ((at - b) * way <= 0 && !is_behind) pass(w, block, at, way);
}

static bool advance(YkWalk *w, double a, double b, size_t depth);
static bool go_on(YkWalk *w, double from, double to, size_t depth);

static bool passes_with_other_sign(YkWalk *w, size_t block, double beyond)
{
    YkState *s = w->path.state;
    w->path.meetings[block].is_off = true;
    s->branch[block] = (signed char)-s->branch[block];
    bool passes = yk_path_probe(&w->path, beyond, true) >= 0;
    s->branch[block] = (signed char)-s->branch[block];
    w->path.meetings[block].is_off = false;
    return passes;
}

// Decides what happens between `good`, where the machine closes, and `bad`, where it does not. A block may have come to
// a change point beyond which only its other sign fits the rest (a redundant link, a later dyad): the motion then
// continues. Otherwise this is a limit.
static bool stop_or_pass(YkWalk *w, double good, double bad, size_t depth)
{
    YkState *s = w->path.state;
    if (yk_walk_is_stopped(w)) return false;
    w->limit_block = s->report.block;
    double at = yk_path_limit(&w->path, good, bad), beyond = yk_path_off(&w->path, at, copysign(1, bad - at), 2e-5);
    if (!(fabs(beyond - at) < fabs(bad - at))) beyond = bad; // it is as near
    bool fits = beyond != at && w->margin_count == s->mech->block_count && depth + 1 < WALK_DEPTH_MAX;
    double *margins = yk_walk_margins(w, depth, 0);
    yk_walk_read_margins(w, margins);
    for (size_t k = 0; fits && k < w->margin_count; k++) {
        if (!yk_walk_has_margin(w, k) || margins[k] > 1e-8 || yk_walk_was_flipped_near(w, k, at) ||
            yk_walk_is_at_meeting(w, k, at, at))
            continue;
        if (!passes_with_other_sign(w, k, beyond)) continue;
        double touch = yk_walk_touch(at, margins[k], beyond, s->space.block_margin[k]);
        if (!yk_walk_meets(w, k, touch, good, bad - good) && !flip(w, k, touch, copysign(1, bad - at))) continue;
        yk_path_probe(&w->path, beyond, true);
        yk_walk_note_crossings(w, good, beyond);
        yk_walk_read_margins(w, yk_walk_margins(w, depth + 1, 0));
        return beyond == bad || advance(w, beyond, bad, depth + 1);
    }
    yk_walk_end_at(w, at, bad);
    return false;
}

// Puts the state at the end of an interval again, reached from its beginning.
static void return_to(YkWalk *w, double a, double b)
{
    w->path.last = a;
    yk_path_try(&w->path, b, true);
}

// Returns whether an interval that ends almost at a change point has passed it. The state is at b again.
static bool flip_at_end(YkWalk *w, size_t block, double a, double b)
{
    double at, way = copysign(1, b - a);
    if (w->margin_count != w->path.state->mech->block_count || is_decided(w, block, b)) return false;
    bool has_passed = yk_walk_has_just_passed(w, block, b, way, &at);
    has_passed = has_passed && flip(w, block, at, way);
    return_to(w, a, b);
    return has_passed;
}

typedef enum Verdict { CLEAR, FINER, TOUCHED } Verdict;

// Returns whether a block could pass a singular position between two times though three samples of its margin do not
// show it: a drive may go past it and come back, at any pace, so only the way of the inputs shows it.
static bool is_within_reach(const YkWalk *w, double least, double a, double b)
{
    const double AHEAD = 2; // how much farther than the inputs the block may turn
    bool is_time = yk_path_is_time(&w->path);
    return is_time && least < 0.05 && sqrt(fmax(least, 0)) < AHEAD * yk_path_way(&w->path, a, b);
}

// Returns how much faster than the path its fastest body turns: a gear, or a short link, may turn further than the
// inputs, and a margin may vanish and recover within a small part of its turn.
static double fastest_turn(const YkWalk *w)
{
    const YkState *s = w->path.state;
    double fastest = 1, unit = yk_path_scale(&w->path);
    for (size_t k = 1; s->has_rates && k < s->mech->slot_count; k++) {
        YkTurn turn = yk_space_turn(&s->space, (int32_t)k);
        if (turn.w) fastest = fmax(fastest, unit * fabs(turn.w[0]));
    }
    return fmin(fastest, FASTEST);
}

// Returns whether bodies turn much farther than the inputs go in an interval, so that it only seems narrow.
static bool is_wide_for_bodies(const YkWalk *w, double a, double b, size_t depth)
{
    return depth + 1 < WALK_DEPTH_MAX && fastest_turn(w) * yk_path_way(&w->path, a, b) > 4e-6;
}

// Returns whether a block comes to a singular position in a narrow interval with that least margin. One in which the
// drives turn back may be long.
static bool is_touch(YkWalk *w, size_t block, double *at, double least)
{
    return least <= 1e-11 || yk_walk_turns_at_limit(w, block, at);
}

// Looks for change points of blocks that are as close to theirs as the one that touches: later links may come into line
// with it, and their margins in the interval were those of its other branch.
static void meet_others(YkWalk *w, double a, double b, size_t depth)
{
    const double CLOSE = 1e-8; // sin^2
    const double *ma = yk_walk_margins(w, depth, 0), *mb = yk_walk_margins(w, depth, 2);
    for (size_t k = 0; k < w->path.meeting_count; k++)
        if (yk_walk_has_margin(w, k) && fmin(ma[k], mb[k]) < CLOSE && !yk_walk_is_at_meeting(w, k, a, b) &&
            !yk_walk_was_flipped_near(w, k, b))
            yk_walk_meets(w, k, b, a, b - a);
}

// Returns whether a block has passed a change point in an interval at whose ends and in whose middle its margin does
// not seem to vanish: near the end, or, where a drive turns back, anywhere.
static bool has_passed_unseen(YkWalk *w, size_t block, double a, double b, double least, double last)
{
    bool is_at_end = last <= YK_SINGULAR_MARGIN;
    if (!is_at_end && (is_decided(w, block, b) || !is_within_reach(w, least, a, b))) return false;
    if (yk_walk_meets(w, block, b, a, b - a) || (is_at_end && flip_at_end(w, block, a, b))) return true;
    return_to(w, a, b);
    return false;
}

// Looks, where several inputs move, for the change point of a block that they may pass between a and b, before the
// intervals are so narrow that there would be very many of them. Returns whether it decides the sign in all of [a, b];
// the state is at b again.
static bool meets_early(YkWalk *w, size_t block, double a, double b)
{
    const double WIDE = 2e-4, FINE = 5e-5;
    double way = yk_path_way(&w->path, a, b);
    if (w->path.state->mech->input_count < 2 || !(way < WIDE && way > FINE)) return false;
    bool meets = yk_walk_meets(w, block, b, a, b - a) && yk_walk_is_at_meeting(w, block, a, b);
    if (!meets) return_to(w, a, b);
    return meets;
}

// Judges [a, b] from the margins at both ends and in the middle; in the narrowest intervals a touch is a change point.
static Verdict look(YkWalk *w, double a, double b, size_t depth)
{
    const double *ma = yk_walk_margins(w, depth, 0), *mm = yk_walk_margins(w, depth, 1),
                 *mb = yk_walk_margins(w, depth, 2);
    bool narrow = yk_path_way(&w->path, a, b) < 4e-7 || depth + 1 >= WALK_DEPTH_MAX, touched = false;
    for (size_t k = 0; k < w->margin_count; k++) {
        if (!yk_walk_has_margin(w, k) || yk_walk_is_at_meeting(w, k, a, b)) continue;
        double least = fmin(ma[k], fmin(mm[k], mb[k]));
        if (!narrow && !is_decided(w, k, b) && is_within_reach(w, least, a, b)) {
            if (!meets_early(w, k, a, b)) return FINER;
            touched = true;
            continue;
        }
        if (!yk_margin_may_vanish(ma[k], mm[k], mb[k])) {
            touched |= has_passed_unseen(w, k, a, b, least, mb[k]);
            continue;
        }
        if (is_decided(w, k, b)) continue;
        if (!narrow || is_wide_for_bodies(w, a, b, depth)) return FINER;
        double touch = yk_walk_touch(a, ma[k], b, mb[k]);
        if (yk_walk_meets(w, k, touch, a, b - a)) {
            touched = true;
            continue;
        }
        if (w->margin_count != w->path.state->mech->block_count || !is_touch(w, k, &touch, least)) {
            return_to(w, a, b);
            continue;
        }
        flip_between(w, k, touch, a, b);
        touched = true;
    }
    if (touched) meet_others(w, a, b, depth);
    return touched ? TOUCHED : CLEAR;
}

// Returns whether the machine closes a little ahead; the state is at a again.
static bool closes_ahead(YkWalk *w, double a, double way)
{
    double ahead = yk_path_off(&w->path, a, way, 2e-5);
    bool closes = !isfinite(ahead) || yk_path_try(&w->path, ahead, true) >= 0;
    w->path.last = a - way; // so that it comes to a in its own direction
    yk_path_try(&w->path, a, true);
    return closes;
}

size_t yk_walk_unflip(YkWalk *w, double a)
{
    size_t count = 0;
    for (size_t k = 0; k < w->margin_count; k++) {
        if (!yk_walk_was_flipped_near(w, k, a)) continue;
        w->path.state->branch[k] = (signed char)-w->path.state->branch[k];
        w->flipped_at[k] = NAN;
        count++;
    }
    return count;
}

void yk_walk_flip_at(YkWalk *w, double a, const double *margins)
{
    if (w->margin_count != w->path.state->mech->block_count) return;
    double way = w->path.way;
    size_t events = w->event_count, more = w->more_events, tried = 0, flips = 0;
    for (size_t k = 0; k < w->margin_count; k++) {
        if (!yk_walk_has_margin(w, k) || margins[k] > YK_SINGULAR_MARGIN || is_decided(w, k, a)) continue;
        if (yk_walk_is_at_meeting(w, k, a, a) || yk_walk_meets(w, k, a, a, way)) continue;
        tried++;
        flips += flip(w, k, a, way);
    }
    if (tried == 0 || closes_ahead(w, a, way) || flips == 0) return;
    yk_walk_unflip(w, a);
    w->event_count = events;
    w->more_events = more;
    w->path.side = 0;
}

// Returns whether, over time, the drives go farther between a and b than the path may go unchecked.
static bool is_coarse(YkWalk *w, double a, double b)
{
    if (w->path.input >= 0 || yk_path_set(&w->path, 0.5 * (a + b), true) < 0) return false;
    double scale = yk_path_scale(&w->path);
    if (yk_path_set(&w->path, b, true) < 0) return false;
    return fabs(b - a) > 1.001 * w->turn_max * fmin(scale, yk_path_scale(&w->path));
}

static bool halve(YkWalk *w, double a, double b, size_t depth)
{
    double middle = 0.5 * (a + b), *next = yk_walk_margins(w, depth + 1, 0);
    memcpy(next, yk_walk_margins(w, depth, 0), w->margin_count * sizeof *next);
    return advance(w, a, middle, depth + 1) && go_on(w, middle, b, depth);
}

// Advances from the valid pose at a (margins known at this depth) to b. Returns false when stopped.
static bool advance(YkWalk *w, double a, double b, size_t depth)
{
    double middle = 0.5 * (a + b);
    if (depth + 1 < WALK_DEPTH_MAX && is_coarse(w, a, b)) return halve(w, a, b, depth);
    if (yk_path_try(&w->path, middle, true) < 0) return stop_or_pass(w, a, middle, depth) && go_on(w, middle, b, depth);
    yk_walk_read_margins(w, yk_walk_margins(w, depth, 1));
    if (yk_path_try(&w->path, b, true) < 0) return stop_or_pass(w, middle, b, depth);
    yk_walk_read_margins(w, yk_walk_margins(w, depth, 2));
    bool is_tracked =
        w->path.state->mech->has_groups && w->margin_count != w->path.state->mech->block_count; // checked on the way
    Verdict verdict = is_tracked ? CLEAR : look(w, a, b, depth);
    if (verdict == TOUCHED && yk_path_try(&w->path, b, true) < 0) return stop_or_pass(w, middle, b, depth);
    if (verdict == FINER) return halve(w, a, b, depth);
    yk_walk_note_crossings(w, a, b);
    yk_path_refer(&w->path); // only poses on the branch serve as references
    return true;
}

// Continues from `from`, which the state has just reached, to `to`, one level deeper.
static bool go_on(YkWalk *w, double from, double to, size_t depth)
{
    if (depth + 1 >= WALK_DEPTH_MAX) return yk_path_probe(&w->path, to, true) >= 0 || stop_or_pass(w, from, to, depth);
    double *margins = yk_walk_margins(w, depth + 1, 0);
    yk_walk_read_margins(w, margins);
    yk_walk_flip_at(w, from, margins);
    return advance(w, from, to, depth + 1);
}

bool yk_walk_refuses(YkWalk *w, double a, double b)
{
    YkState *s = w->path.state;
    double cost = 10 + (double)s->mech->step_count; // of a step
    if (yk_path_length(&w->path, a, b) / w->turn_max * cost <= COST_MAX) return false;
    w->status = yk_state_refuse(s, YK_STOPPED,
                                "the way is too long to be followed pose by pose: the inputs turn too often on it; ask "
                                "for a shorter one");
    return true;
}

// Returns the end of the next stride from `last`. From a singular pose it is a short one, which distinguishes a limit
// from a change point: farther on the machine may close again, on the other side of a gap.
static double next_place(const YkWalk *w, double last, double b)
{
    double way = b > last ? 1 : -1, stride = w->turn_max * yk_path_scale(&w->path) / fastest_turn(w),
           left = fabs(b - last);
    double next = left <= stride * (1 + 1e-9) ? b : last + way * left / ceil(left / stride);
    if (w->path.state->space.margin[0] <= YK_SINGULAR_MARGIN) {
        double ahead = yk_path_off(&w->path, last, way, 2e-5);
        if ((next - ahead) * way > 0) next = ahead;
    }
    return next == last ? b : next;
}

bool yk_walk_go(YkWalk *w, double a, double b)
{
    double last = a, way = b > a ? 1 : -1;
    YkWitness *witness = w->path.state->witness;
    if (witness && !w->is_witnessed) witness->begin(witness, w->path.state);
    w->is_witnessed = true;
    if (!w->has_begun) yk_walk_begin_at(w, a, way);
    bool is_singular = w->path.state->space.margin[0] <= YK_SINGULAR_MARGIN;
    if (a == w->from && (w->path.way == way || !is_singular)) w->from = NAN; // it goes on as it came: it passes there
    while (last != b) {
        double next = next_place(w, last, b), *margins = yk_walk_margins(w, 0, 0);
        yk_walk_read_margins(w, margins);
        yk_walk_flip_at(w, last, margins);
        if (!advance(w, last, next, 0) || yk_walk_is_stopped(w)) return false;
        if (witness) witness->step(witness, w->path.state, YK_WITNESS_STEP);
        if (w->arrived && !w->arrived(w->context, next)) {
            w->status = YK_STOPPED;
            return false;
        }
        last = next;
    }
    return true;
}
