// One machine's pose for the same machine with other inputs.
#include <yoke/move.h>
#include "solve/state.h"

#define ADOPTED 1e-5 // rad, or lengths over the size: at a dead point positions are known to the root of rounding

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
    if (to->mech->model != from->mech->model || !from->has_pose) return YK_BAD_ARGUMENT;
    for (size_t c = 0; c < to->mech->coordinate_count; c++) {
        to->guess[c] = to->reference[c] = yk_state_coordinate(from, c).position;
        to->is_guessed[c] = true;
    }
    YkStatus status = yk_state_set_time(to, from->time, NULL);
    if (status < 0) return status;
    for (size_t i = 0; i < to->mech->input_count; i++) to->input[3 * i] = to->guess[to->mech->inputs[i]];
    status = yk_state_assemble(to);
    if (status >= 0 && !stands_there(to)) status = YK_NO_ASSEMBLY;
    return status;
}
