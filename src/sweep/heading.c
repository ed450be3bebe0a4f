// Remembers the direction in which a motion came to a pose, for the next one that begins there. Exactly at a change
// point the signs of the blocks are those of the side that it came from: going on passes the change point, turning back
// does not.
#include "sweep/walk.h"

bool yk_walk_has_passed(const YkWalk *w)
{
    for (size_t k = 0; k < w->margin_count; k++)
        if (yk_walk_was_flipped_near(w, k, w->path.last)) return true;
    return false;
}

// At a known change point, the side for which the signs hold is the one from which the machine has come.
static void take_side_held(const YkWalk *w)
{
    YkState *s = w->path.state;
    for (size_t k = 0; k < w->path.meeting_count; k++) {
        double side = yk_walk_side_held(w, k, w->path.last);
        int32_t input = w->path.meetings[k].input;
        if (side == 0) continue;
        for (size_t i = 0; w->path.meetings[k].is_shared && i < s->mech->input_count; i++)
            s->heading[i] = -side * yk_meeting_rise(&w->path, k, w->path.last, i);
        if (w->path.meetings[k].is_shared) continue;
        if (input != YK_NONE)
            s->heading[input] = -side;
        else if (yk_path_is_time(&w->path))
            s->time_heading = -side;
        else
            for (size_t i = 0; i < s->mech->input_count; i++) s->heading[i] = -side * yk_path_rate(&w->path, i, 1);
    }
}

void yk_walk_arrive(const YkWalk *w, double way)
{
    YkState *s = w->path.state;
    bool is_there_still = yk_path_way(&w->path, w->from, w->path.last) < 1e-4; // the drives rest
    double side = yk_walk_has_passed(w) ? -1 : 1; // as if it had come from beyond: turning back passes it
    bool is_time = yk_path_is_time(&w->path);
    if (!is_there_still || !is_time || s->arrival_time != w->from)
        s->time_heading = is_time && !is_there_still ? side * way : 0;
    s->arrival_time = w->path.last;
    for (size_t i = 0; i < s->mech->input_count; i++) {
        s->arrival[i] = s->valid_input[3 * i];
        if (!is_there_still) s->heading[i] = side * way * yk_path_rate(&w->path, i, -way);
    }
    take_side_held(w);
}
