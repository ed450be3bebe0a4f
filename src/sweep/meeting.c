// Change points that are known by the place of the input that leads to them. On each side of it the block has one sign,
// however often and however little the motion goes over it: the pose follows from where the input is, not from its
// past. If several inputs lead there together, it follows from where they all are (side.c). If a drive turns back just
// at a limit, time takes the place of the input.
#include "sweep/meeting.h"

bool yk_walk_is_at_meeting(const YkWalk *w, size_t block, double a, double b)
{
    const YkPath *path = &w->path;
    if (block >= path->meeting_count || !path->meetings[block].is_known) return false;
    const YkMeeting *m = &path->meetings[block];
    if (m->is_shared && a != b && !(yk_path_way(path, a, b) < m->near)) return false; // costs less than the poses
    double before = yk_meeting_off_at(path, block, a), after = a == b ? before : yk_meeting_off_at(path, block, b);
    bool is_short = m->input == YK_NONE ? fabs(after - before) < m->near : a == b || yk_path_way(path, a, b) < m->near;
    return is_short && fmin(fabs(before), fabs(after)) < m->near;
}

bool yk_walk_knows_meeting(const YkWalk *w, size_t block, double at)
{
    const double FAR = 64; // as the sine falls to less than 1e-3, where rates begin to be blurred
    if (block >= w->path.meeting_count || !w->path.meetings[block].is_known) return false;
    return fabs(yk_meeting_off_at(&w->path, block, at)) < FAR * w->path.meetings[block].near;
}

// Returns whether only the block is singular: constraints that repeat it determine the motion, and no branch parts.
static bool is_seen(YkWalk *w, double at)
{
    const YkState *s = w->path.state;
    return !(s->mech->redundant_count > 0 && yk_path_try(&w->path, at, true) >= 0 && s->is_regular);
}

static void note(YkWalk *w, size_t block, double at)
{
    bool may_turn = yk_path_is_time(&w->path) && w->path.meetings[block].input == YK_NONE;
    YkEvent event = {.kind = YK_EVENT_CHANGE_POINT, .at = at, .block = (int)block, .is_passed = true};
    event.is_turned = may_turn && yk_path_turns_back(&w->path, at);
    if (is_seen(w, at)) yk_walk_note(w, event);
}

// Returns where the path goes over the change point between a place on the side of `side` and one on the other.
static double crossing(const YkPath *path, size_t block, double inside, double outside, int side)
{
    if (!(side * yk_meeting_off_at(path, block, inside) > 0)) return inside;
    for (int k = 0; k < 64; k++) {
        double middle = 0.5 * (inside + outside);
        if (middle == inside || middle == outside) break;
        if (side * yk_meeting_off_at(path, block, middle) > 0)
            inside = middle;
        else
            outside = middle;
    }
    return inside;
}

// Returns the place between a and b at which the path is farthest beyond the change point; a if it cannot get there.
static double farthest_beyond(const YkPath *path, size_t block, double a, double b)
{
    enum { SAMPLES = 16, FEW = 4, HALVINGS = 40 };
    const YkMeeting *m = &path->meetings[block];
    int samples = m->is_shared ? FEW : SAMPLES;
    double reach = 2 * (double)path->state->mech->input_count * yk_path_way(path, a, b); // of all inputs together
    double best = a, step = (b - a) / samples,
           least = fmin(m->side * yk_meeting_off_at(path, block, a), m->side * yk_meeting_off_at(path, block, b));
    if (least > reach) return a;
    least = INFINITY;
    for (int k = 1; k < samples; k++) {
        double at = a + k * step, off = m->side * yk_meeting_off_at(path, block, at);
        if (off < least) least = off, best = at;
    }
    for (int k = 0; k < HALVINGS && least < reach * step / (b - a); k++, step *= 0.6)
        for (int way = -1; way <= 1; way += 2) {
            double at = best + 0.5 * way * step, off = m->side * yk_meeting_off_at(path, block, at);
            if ((at - a) * (b - at) > 0 && off < least) least = off, best = at;
        }
    return best;
}

// Notes both passages of a change point beyond which the path goes between a and b, though both lie on the same side of
// it. Returns whether there are any.
static bool note_excursion(YkWalk *w, size_t block, double a, double b)
{
    const YkMeeting *m = &w->path.meetings[block];
    double beyond = farthest_beyond(&w->path, block, a, b);
    if (yk_meeting_side(m, w->path.state, yk_meeting_off_at(&w->path, block, beyond)) != -m->side) return false;
    note(w, block, crossing(&w->path, block, a, beyond, m->side));
    note(w, block, crossing(&w->path, block, b, beyond, m->side));
    return true;
}

void yk_walk_note_crossings(YkWalk *w, double a, double b)
{
    const YkPath *path = &w->path;
    bool is_moved = false;
    for (size_t k = 0; k < path->meeting_count; k++) {
        YkMeeting *m = &path->meetings[k];
        if (!m->is_known) continue;
        double off = yk_meeting_off_at(path, k, b);
        int side = yk_meeting_side(m, path->state, off);
        bool is_near = fmin(fabs(yk_meeting_off_at(path, k, a)), fabs(off)) < m->near;
        if (side == m->side && m->input != YK_NONE && yk_walk_is_at_meeting(w, k, a, b))
            is_moved |= note_excursion(w, k, a, b);
        if (isnan(off) && m->is_shared) m->is_known = false; // the next one may be another
        if (side == 0 || side == m->side) continue;
        if (is_near) note(w, k, crossing(path, k, a, b, m->side));
        is_moved |= is_near;
        m->side = (signed char)side;
    }
    if (is_moved && path->state->mech->redundant_count > 0) yk_path_try(&w->path, b, true);
}

// Returns whether the inputs at `at` are just at a known change point.
static bool is_there(const YkWalk *w, size_t block, double at)
{
    double off = yk_meeting_off_at(&w->path, block, at);
    return fabs(off) <= yk_meeting_tolerance(&w->path.meetings[block], w->path.state);
}

bool yk_walk_passes_meeting(YkWalk *w, size_t block, double at, double way, bool is_start)
{
    YkMeeting *m = &w->path.meetings[block];
    if (!is_there(w, block, at)) return true; // elsewhere, if at all
    int ahead = yk_meeting_side_beside(&w->path, block, at, way);
    int before = is_start ? m->side : yk_meeting_side_beside(&w->path, block, at, -way);
    if (ahead == 0 || ahead == before) return false;
    if (m->side != ahead) note(w, block, at);
    m->side = (signed char)ahead;
    return true;
}

double yk_walk_side_held(const YkWalk *w, size_t block, double at)
{
    const YkMeeting *m = &w->path.meetings[block];
    return m->is_known && is_there(w, block, at) ? m->side : 0;
}
