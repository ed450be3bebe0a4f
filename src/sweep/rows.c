// The rows: the channels at the requested poses. A row exactly on a change point gets the limits of its rates.
#include "dynamics/dynamics.h"
#include "sweep/meeting.h"
#include "sweep/sweep.h"

static bool wants_forces(const YkSweep *w)
{
    for (size_t c = 0; w->options.dynamics && c < w->channel_count; c++)
        if (yk_channel_needs_forces(w->channels[c])) return true;
    return false;
}

void yk_sweep_read_channels(YkSweep *w, double *values)
{
    YkState *s = w->walk.path.state;
    yk_state_spend(s, wants_forces(w) ? 8 * s->mech->step_count : w->channel_count);
    YkStatus status =
        wants_forces(w) && s->has_rates ? yk_dynamics_solve(w->options.dynamics, s, w->options.method) : YK_SINGULAR;
    w->walk.failed |= status == YK_NO_MEMORY;
    bool has_forces = status == YK_OK || status == YK_REDUNDANT;
    for (size_t c = 0; c < w->channel_count; c++) {
        if (!yk_channel_needs_forces(w->channels[c]))
            values[c] = yk_state_channel(s, w->channels[c]);
        else
            values[c] = has_forces ? yk_dynamics_channel(w->options.dynamics, s, w->channels[c]) : (double)NAN;
    }
}

bool yk_sweep_record(YkSweep *w, double at)
{
    YkState *s = w->walk.path.state;
    YkStatus status = yk_path_probe(&w->walk.path, at, false);
    if (status < 0) {
        w->walk.limit_block = s->report.block;
        yk_walk_end_at(&w->walk, w->row_count > 0 ? *yk_sweep_row(w, w->row_count - 1) : at, at);
        return false;
    }
    double way = w->options.to > w->options.from ? 1 : -1;
    if (status >= 0) status = yk_walk_clear_rates(&w->walk, at, way, status);
    w->walk.failed |= status == YK_NO_MEMORY;
    size_t row = w->row_count++;
    *yk_sweep_row(w, row) = at;
    w->row_status[row] = (signed char)status;
    yk_sweep_read_channels(w, yk_sweep_row(w, row) + 1);
    if (w->options.visit) w->options.visit(w->options.context, s);
    w->worst_residual = fmax(w->worst_residual, yk_state_gap(s));
    if (status == YK_SINGULAR)
        yk_walk_note(&w->walk, (YkEvent){.kind = YK_EVENT_SINGULAR, .at = at, .block = s->report.block});
    return true;
}

// Drops the singular event of a row that proved to be a change point: it says nothing more.
static size_t drop_singular(YkSweep *w, double at)
{
    size_t kept = 0;
    for (size_t k = 0; k < w->walk.event_count; k++)
        if (w->walk.events[k].kind != YK_EVENT_SINGULAR || w->walk.events[k].at != at)
            w->walk.events[kept++] = w->walk.events[k];
    return kept;
}

// Forces may be without bound at a change point, though efforts are not: then nearer to it they are larger than at all
// poses from which a limit was made. Returns whether a channel of forces is so.
static bool is_unbounded(const YkSweep *w, size_t c)
{
    if (!yk_channel_needs_forces(w->channels[c])) return false;
    double arm = w->channels[c].quantity == YK_QUANTITY_FORCE ? 1 : w->walk.path.state->mech->size;
    return fabs(w->beside[c]) > 4 * w->largest[c] + 1e-9 * arm * w->options.dynamics->largest_force;
}

// Adds the channels at a pose beside the change point to its row's sums.
static void add_channels(void *context, double weight)
{
    YkSweep *w = context;
    yk_sweep_read_channels(w, w->beside);
    for (size_t c = 0; c < w->channel_count; c++) {
        if (weight == 0 && is_unbounded(w, c)) w->sums[c] = (double)NAN;
        if (weight == 0) continue;
        w->sums[c] += weight * w->beside[c];
        w->largest[c] = fmax(w->largest[c], fabs(w->beside[c]));
    }
}

// Fills a row exactly on a change point: rates and forces are the limits from both sides.
static void fill_change_row(YkSweep *w, size_t row, const double *margins, double side)
{
    YkBeside beside = {.walk = &w->walk, .at = *yk_sweep_row(w, row), .side = side, .margins = margins};
    for (size_t c = 0; c < w->channel_count; c++) w->sums[c] = w->largest[c] = 0;
    if (!yk_beside_begin(&beside, NULL)) return;
    beside.wants_nearer = wants_forces(w);
    if (!yk_beside_visit(&beside, add_channels, w)) return;
    w->row_status[row] = YK_CHANGE_POINT;
    for (size_t c = 0; c < w->channel_count; c++)
        if (w->channels[c].order > 0 || w->channels[c].kind >= YK_CHANNEL_POINT_SPEED)
            yk_sweep_row(w, row)[1 + c] = w->sums[c];
}

// A drive may turn back at a change point, and so may the sweep at its start: the signs then hold that the machine came
// with, unless it is a limit that the drive just touches.
static bool passes(YkSweep *w, size_t row, const double *margins, double way)
{
    if (row == 0) return w->walk.path.way == way;
    double at = *yk_sweep_row(w, row);
    if (!yk_path_turns_back(&w->walk.path, at)) return true;
    bool goes_on = yk_walk_turns_at_a_limit(&w->walk, margins, at);
    yk_path_try(&w->walk.path, at, true);
    return goes_on;
}

// Returns whether the path goes over the change point at a row: where it is known, that says where the input is.
static bool goes_over(YkSweep *w, size_t row, const double *margins, double way)
{
    bool is_known = false, is_passed = false;
    double at = *yk_sweep_row(w, row);
    for (size_t k = 0; k < w->walk.path.meeting_count; k++)
        if (margins[k] <= YK_SINGULAR_MARGIN && yk_walk_is_at_meeting(&w->walk, k, at, at)) {
            is_known = true;
            is_passed |= yk_walk_passes_meeting(&w->walk, k, at, way, row == 0);
        }
    if (is_known) yk_path_try(&w->walk.path, at, true);
    return is_known ? is_passed : passes(w, row, margins, way);
}

static bool was_flipped(const YkSweep *w, size_t row)
{
    for (size_t k = 0; k < w->walk.margin_count; k++)
        if (yk_walk_was_flipped_near(&w->walk, k, *yk_sweep_row(w, row))) return true;
    return false;
}

// Returns whether the machine goes on from a row at a known change point, though its rates have no limits there: one
// input may stop and another start.
static bool goes_on(YkSweep *w, size_t row, double way)
{
    YkPath *path = &w->walk.path;
    double at = *yk_sweep_row(w, row), ahead = yk_path_off(path, at, way, 2e-5);
    bool is_known = false, closes = isfinite(ahead) && yk_path_try(path, ahead, true) >= 0;
    yk_path_try(path, at, true);
    for (size_t k = 0; k < path->meeting_count; k++) is_known |= yk_walk_side_held(&w->walk, k, at) != 0;
    return is_known && closes;
}

void yk_sweep_try_change_row(YkSweep *w)
{
    size_t row = w->row_count - 1;
    double way = w->options.to > w->options.from ? 1 : -1, *margins = yk_walk_margins(&w->walk, 0, 0);
    YkState *s = w->walk.path.state;
    if (s->space.margin[0] > YK_SINGULAR_MARGIN || w->row_status[row] != YK_SINGULAR ||
        w->walk.margin_count != s->mech->block_count || s->mech->has_groups)
        return;
    yk_walk_read_margins(&w->walk, margins);
    size_t before = w->walk.event_count;
    bool is_passed = goes_over(w, row, margins, way);
    if (row == 0 && is_passed) w->walk.from = NAN;
    if (is_passed) yk_walk_flip_at(&w->walk, *yk_sweep_row(w, row), margins);
    fill_change_row(w, row, margins, is_passed || row == 0 ? way : -way); // else it goes back to where the signs hold
    bool is_told = w->walk.event_count > before;
    if (w->row_status[row] == YK_CHANGE_POINT || (is_told && goes_on(w, row, way))) {
        w->walk.event_count = drop_singular(w, *yk_sweep_row(w, row));
        YkEvent touched = {.kind = YK_EVENT_CHANGE_POINT,
                           .at = *yk_sweep_row(w, row),
                           .block = yk_walk_touching_block(&w->walk, margins)};
        if (!is_passed) yk_walk_note(&w->walk, touched);
        return;
    }
    if (row == 0) w->walk.from = *yk_sweep_row(w, row);
    if (is_told && !was_flipped(w, row)) w->walk.event_count = before;
    w->walk.event_count -= yk_walk_unflip(&w->walk, *yk_sweep_row(w, row));
}
