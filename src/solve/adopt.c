// Takes another state's pose into a state of the machine with other inputs, or slightly different dimensions.
#include <yoke/move.h>
#include "solve/state.h"

// rad, or lengths over the size: at a dead point positions are known only to the square root of rounding.
#define ADOPTED 1e-5

YkStatus yk_state_guess(YkState *to, const YkState *from)
{
    if (to->mech->coordinate_count != from->mech->coordinate_count || !from->has_pose) return YK_BAD_ARGUMENT;
    for (size_t c = 0; c < to->mech->coordinate_count; c++) {
        to->guess[c] = to->reference[c] = yk_state_coordinate(from, c).position;
        to->is_guessed[c] = true;
    }
    return YK_OK;
}

static bool stands_there(const YkState *s)
{
    for (size_t c = 0; c < s->mech->coordinate_count; c++) {
        double off = yk_state_coordinate(s, c).position - s->guess[c];
        if (!(fabs(off) < ADOPTED * (s->mech->coordinates[c].is_distance ? s->mech->size : 1))) return false;
    }
    return true;
}

YkStatus yk_state_adopt(YkState *to, const YkState *from)
{
    YkStatus status = yk_state_guess(to, from);
    if (status >= 0) status = yk_state_set_time(to, from->time, NULL);
    if (status < 0) return status;
    for (size_t i = 0; i < to->mech->input_count; i++) to->input[3 * i] = to->guess[to->mech->inputs[i]];
    status = yk_state_assemble(to);
    if (status >= 0 && !stands_there(to)) status = YK_NO_ASSEMBLY;
    return status;
}
