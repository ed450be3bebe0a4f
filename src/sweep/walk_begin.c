// Begins and ends a walk, and keeps what it knows: margins, events, the last change point of each block.
#include <stdlib.h>
#include "sweep/walk.h"

enum { MARGINS_MAX = 2000, EVENTS_MAX = 10000 };

bool yk_walk_start(YkWalk *w, YkPath path, double turn_max)
{
    size_t blocks = path.state->mech->block_count, count = blocks == 0 || blocks > MARGINS_MAX ? 1 : blocks;
    *w = (YkWalk){
        .path = path, .turn_max = turn_max, .margin_count = count, .limit_block = -1, .events_max = EVENTS_MAX};
    w->margins = calloc(3 * (WALK_DEPTH_MAX + 1) * count, sizeof *w->margins);
    w->flipped_at = calloc(count, sizeof *w->flipped_at);
    for (size_t k = 0; w->flipped_at && k < count; k++) w->flipped_at[k] = NAN;
    w->path.meetings = calloc(count, sizeof *w->path.meetings);
    w->path.signs = calloc(count, 1);
    w->path.meeting_count = w->path.meetings && count == blocks ? count : 0;
    return path.others && w->margins && w->flipped_at && w->path.meetings && w->path.signs;
}

void yk_walk_end(YkWalk *w)
{
    yk_path_end(&w->path);
    free(w->margins);
    free(w->flipped_at);
    free(w->path.meetings);
    free(w->path.signs);
    free(w->events);
}

void yk_walk_note(YkWalk *w, YkEvent event)
{
    if (w->event_count >= w->events_max) {
        w->more_events++;
        return;
    }
    if (!YK_ROOM(w->events, w->event_count, w->event_capacity)) {
        w->failed = true;
        return;
    }
    w->events[w->event_count++] = event;
}

double *yk_walk_margins(const YkWalk *w, size_t depth, size_t which)
{
    return w->margins + (3 * depth + which) * w->margin_count;
}

void yk_walk_read_margins(const YkWalk *w, double *margins)
{
    const YkState *s = w->path.state;
    if (s->mech->block_count != w->margin_count) margins[0] = s->space.margin[0];
    for (size_t k = 0; s->mech->block_count == w->margin_count && k < w->margin_count; k++)
        margins[k] = s->space.block_margin[k];
}

bool yk_walk_has_margin(const YkWalk *w, size_t block)
{
    const YkMechanism *mech = w->path.state->mech;
    return w->margin_count != mech->block_count || mech->blocks[block].kind <= YK_BLOCK_RPR;
}

void yk_walk_end_at(YkWalk *w, double at, double bad)
{
    if (yk_walk_is_stopped(w)) return;
    w->status = yk_path_set(&w->path, bad, true) < 0 ? YK_BAD_MODEL : YK_LIMIT;
    if (w->status == YK_BAD_MODEL) yk_state_set_time(w->path.state, bad, w->problems);
    yk_walk_note(w, (YkEvent){.kind = YK_EVENT_LIMIT, .at = at, .block = w->status == YK_LIMIT ? w->limit_block : -1});
    yk_path_probe(&w->path, at, true);
}

bool yk_walk_is_stopped(YkWalk *w)
{
    if (!yk_state_is_stopped(w->path.state)) return false;
    w->status = YK_STOPPED;
    return true;
}

bool yk_walk_was_flipped_near(const YkWalk *w, size_t block, double at)
{
    return yk_path_way(&w->path, w->flipped_at[block], at) < 1e-4;
}
