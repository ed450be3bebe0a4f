// Poses so near to a change point that rounding shows in their rates, in accelerations by its distance to the third
// power. The motion is smooth through it, so their rates are interpolated from poses on both sides, as at the change
// point itself.
#include <stdlib.h>
#include "elementary/elementary.h"
#include "sweep/walk.h"

// Returns whether the walk's pose is one, by its blocks. It may also be close to a limit, where nothing is
// smooth.
static bool may_be_blurred(const YkWalk *w)
{
    const YkState *s = w->path.state;
    double margin = s->space.margin[0];
    return margin > YK_SINGULAR_MARGIN && margin <= YK_NEAR_MARGIN && !s->is_regular && !s->is_kept &&
           !s->mech->has_groups && w->margin_count == s->mech->block_count;
}

// Reads the margins, with zero for blocks that touch close by. Returns whether the walk has just passed such a touch.
static bool read_touches(const YkWalk *w, double at, double *margins)
{
    const double close = 5e-3; // rad, or lengths over the size
    bool has_passed = false;
    yk_walk_read_margins(w, margins);
    for (size_t k = 0; k < w->margin_count; k++) {
        if (!yk_walk_has_margin(w, k) || margins[k] > YK_NEAR_MARGIN) continue;
        margins[k] = 0;
        has_passed = has_passed || yk_path_way(&w->path, w->flipped_at[k], at) < close;
    }
    return has_passed;
}

// Returns whether an interpolated pose is the state's own. On the other branch through the change point the motion is
// smooth as well, and only its distance from this one distinguishes them: it grows with the sine, and rounding with its
// inverse.
static bool is_own_pose(const YkState *s, const double *numbers)
{
    const YkSpace *space = &s->space;
    double sine = sqrt(space->margin[0]), most = 1e-5 * sine + 2e-15 / sine, off = 0;
    for (size_t k = 1; k < space->slots; k++) {
        YkTurn t = space->turn[k];
        off = fmax(off, yk_hypot(numbers[t.c - space->data] - *t.c, numbers[t.s - space->data] - *t.s));
    }
    for (size_t k = 0; k < space->distances; k++) {
        const double *d = space->slide[k].d;
        off = fmax(off, fabs(numbers[d - space->data] - *d) / s->mech->size);
    }
    return off <= most;
}

YkStatus yk_walk_clear_rates(YkWalk *w, double at, double way, YkStatus status)
{
    YkState *s = w->path.state;
    if (status < 0 || !may_be_blurred(w) || !yk_path_moves_along(&w->path)) return status;
    double *margins = yk_walk_margins(w, 0, 0);
    double *rates = malloc((yk_space_number_count(&s->space) + 1) * sizeof *rates);
    if (!rates) return YK_NO_MEMORY;
    double side = read_touches(w, at, margins) ? way : -way; // on which the signs hold
    bool is_found = false;
    for (int k = 0; k < 2 && !is_found && !w->failed; k++, side = -side) {
        YkBeside beside = {.walk = w, .at = at, .side = side, .margins = margins};
        is_found = yk_beside_begin(&beside, rates);
        is_found = yk_path_probe(&w->path, at, false) >= 0 && is_found && is_own_pose(s, rates);
    }
    if (is_found) {
        yk_state_take_rates(s, rates);
        s->has_rates = s->is_clear = true;
        status = s->mech->redundant_count + s->mech->redundant_relation_count > 0 ? YK_REDUNDANT : YK_OK;
        yk_state_tell(s, &s->space, status);
    }
    free(rates);
    return w->failed ? YK_NO_MEMORY : status;
}
