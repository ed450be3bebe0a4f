// The machine's other assemblies at the present inputs.
#include <math.h>
#include <stdlib.h>
#include "core.h"
#include "exports.h"

static bool is_same(const YkState *a, const YkState *b)
{
    for (size_t k = 0; k < yk_coordinate_count(yk_core.mech); k++) {
        double off = yk_state_coordinate(a, k).position - yk_state_coordinate(b, k).position;
        bool is_distance = yk_coordinate_info(yk_core.mech, k).is_distance;
        if (!is_distance) off = yk_remainder(off, 2 * YK_PI);
        if (fabs(off) > 1e-6 * (is_distance ? yk_mechanism_size(yk_core.mech) : 1)) return false;
    }
    return true;
}

static bool keep(void *context, YkState *state)
{
    (void)context;
    if (is_same(state, yk_core.state)) return true;
    YkState *ghost = yk_core.ghost_count < YK_GHOSTS ? yk_state_new(yk_core.mech) : NULL;
    if (!ghost) return false;
    yk_state_copy(ghost, state);
    yk_core.ghosts[yk_core.ghost_count++] = ghost;
    return true;
}

// Finds the other assemblies, the first 16 of them. Returns how many; ys_ghost gives each.
YK_DOOR(ys_ghosts) int ys_ghosts(void)
{
    if (!yk_core.state || !yk_state_has_pose(yk_core.state)) return 0;
    YkState *visitor = yk_state_new(yk_core.mech);
    bool complete;
    yk_core_settle();
    if (!visitor) return YK_NO_MEMORY;
    yk_state_copy(visitor, yk_core.state);
    (void)yk_state_each(visitor, keep, NULL, &complete);
    yk_state_free(visitor);
    return (int)yk_core.ghost_count;
}

YK_DOOR(ys_ghost) int ys_ghost(size_t index)
{
    if (index >= yk_core.ghost_count) return yk_core_tell(yk_core.state, YK_BAD_ARGUMENT, "there is no such assembly");
    return yk_core_tell(yk_core.ghosts[index], YK_OK, "");
}

// Takes one of them in place of the present one.
YK_DOOR(ys_choose) int ys_choose(size_t index)
{
    if (index >= yk_core.ghost_count) return ys_ghost(index);
    yk_state_copy(yk_core.state, yk_core.ghosts[index]);
    yk_core_settle();
    return yk_core_tell(yk_core.state, YK_OK, "");
}
