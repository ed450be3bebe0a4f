// Goes to the pose that a request asks for: inputs that are set, then the time.
#include <stdlib.h>
#include <string.h>
#include <yoke/move.h>
#include "solve/state.h"

// Sets the inputs and moves straight to where they are then held.
static YkStatus go_straight(YkState *s, const YkInputHold *holds, size_t count, const YkMoveOptions *options,
                            YkMove *move)
{
    size_t inputs = s->mech->input_count;
    YkMotion *goal = calloc(inputs + 1, sizeof *goal);
    if (!goal) return move->status = YK_NO_MEMORY;
    for (size_t k = 0; k < count; k++) yk_state_hold_input(s, holds[k].input, holds[k].order, holds[k].value);
    for (size_t i = 0; i < inputs; i++) goal[i] = yk_state_input(s, i);
    YkStatus status = yk_state_move_to(s, goal, options, move);
    free(goal);
    return status;
}

// Puts what happened on the way before in front of what happened since.
static void prepend(YkMove *move, const YkMove *before)
{
    YkMove both = *move;
    size_t first = before->pass_count < YK_MOVE_PASSES ? before->pass_count : YK_MOVE_PASSES;
    size_t second = move->pass_count < YK_MOVE_PASSES - first ? move->pass_count : YK_MOVE_PASSES - first;
    memcpy(both.passes, before->passes, first * sizeof *both.passes);
    memcpy(both.passes + first, move->passes, second * sizeof *both.passes);
    both.pass_count += before->pass_count;
    both.is_detour |= before->is_detour;
    *move = both;
}

YkStatus yk_state_reach(YkState *s, const YkInputHold *holds, size_t count, double time, const YkMoveOptions *options,
                        YkMove *move, YkProblems *problems)
{
    YkMove unseen;
    YkMove *m = move ? move : &unseen;
    *m = (YkMove){.part = 1, .block = -1};
    if (!s || (count > 0 && !holds) || !s->has_pose) return m->status = YK_BAD_ARGUMENT;
    YkStatus status = m->status = s->report.status;
    if (count > 0) status = go_straight(s, holds, count, options, m);
    if (status < 0 || time == s->time) return status;
    YkMove before = *m;
    status = yk_state_move_time(s, time, options, m, problems);
    prepend(m, &before);
    return status;
}
