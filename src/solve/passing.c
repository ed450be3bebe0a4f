// Two of three equal cranks are in line with their coupler: as a four-bar they could fold either way there, and only
// the third crank decides how the coupler goes on. Beyond such a pose the kept equations hold again, on the other
// branch.
#include "solve/passing.h"
#include <math.h>
#include <string.h>
#include "compile/closure.h"
#include "elementary/elementary.h"
#include "solve/all_loops.h"
#include "solve/assemble.h"
#include "solve/track.h"

#define NEAR 1e-6 // rad, or lengths over the size: what all loops and the blocks may differ by at a regular pose

// Starts the groups from the pose of all variables; they keep their turns.
static void guess_groups(YkState *s, const double *x)
{
    size_t o = s->mech->orientation_count - 1;
    for (size_t k = 0; k < s->mech->column_count; k++) {
        YkColumn c = s->mech->group_columns[k];
        s->groups.x[k] = c.is_distance ? x[o + (size_t)c.index] : yk_nearest_turn(x[c.index - 1], s->valid_x[k]);
    }
}

// Returns whether the spare pose is the one of all variables.
static bool agrees(YkState *s, const double *x)
{
    size_t o = s->mech->orientation_count - 1, n = yk_variable_count(s->mech);
    for (size_t k = 0; k < o; k++) {
        YkTurn t = yk_space_turn(&s->spare, (int32_t)k + 1);
        YkVec e = yk_unit(x[k]);
        if (!(yk_hypot(*t.c - e.x, *t.s - e.y) < NEAR)) return false;
    }
    for (size_t k = o; k < n; k++)
        if (!(fabs(*yk_space_slide(&s->spare, (int32_t)(k - o)).d - x[k]) < NEAR * s->mech->size)) return false;
    return true;
}

static bool is_group(const YkState *s, size_t block)
{
    return s->mech->blocks[block].kind == YK_BLOCK_GROUP;
}

// Reads the branches of groups off their pose.
static void read_groups(YkState *s)
{
    YkRun run = yk_state_run(s, &s->spare);
    for (size_t b = 0; b < s->mech->block_count; b++)
        if (is_group(s, b)) s->branch[b] = (signed char)yk_group_sign(&run, b);
}

static void free_groups(YkState *s)
{
    for (size_t b = 0; b < s->mech->block_count; b++)
        if (is_group(s, b)) s->branch[b] = 0;
}

static void keep_branches(YkState *s)
{
    memcpy(s->search->kept_branch, s->branch, s->mech->block_count);
}

static void restore_branches(YkState *s)
{
    memcpy(s->branch, s->search->kept_branch, s->mech->block_count);
}

// Lets groups find the pose with whatever sign they have there; one dyad after another may have to change sides.
static bool stand_at(YkState *s, const double *x)
{
    free_groups(s);
    for (size_t b = 0; b <= s->mech->block_count; b++) {
        bool is_changed = b > 0 && !is_group(s, b - 1) && s->branch[b - 1] != 0;
        if (b > 0 && !is_changed) continue;
        if (is_changed) s->branch[b - 1] = (signed char)-s->branch[b - 1];
        guess_groups(s, x);
        if (yk_state_run_here(s) >= 0 && agrees(s, x)) {
            read_groups(s);
            return true;
        }
        if (is_changed) s->branch[b - 1] = (signed char)-s->branch[b - 1];
    }
    return false;
}

double yk_state_pass(YkState *s, const double *ends, double at, double left)
{
    const double shortest = 1e-4, longest = 0.02; // rad, or lengths over the size, of the input that moves farthest
    double most = 0;
    for (size_t i = 0; i < s->mech->input_count; i++)
        most = fmax(most, fabs(ends[2 * i + 1]) / yk_input_unit(s->mech, i));
    if (!s->all_loops || !(most > 0)) return 0;
    keep_branches(s);
    for (double way = shortest; way < longest; way *= 2) {
        double h = fmin(way / most, left);
        yk_set_path(s, ends, at + h);
        yk_space_copy(&s->spare, &s->space);
        const double *x = yk_all_loops_ahead(s, &s->spare, h);
        if (x && stand_at(s, x)) return h;
        restore_branches(s);
        if (!x || h == left) break;
    }
    return 0;
}

YkStatus yk_state_stand_here(YkState *s)
{
    YkStatus status = yk_state_run_here(s);
    s->is_regular = false;
    if (!s->all_loops || (status >= 0 && s->spare.margin[0] > YK_NEAR_MARGIN)) return status;
    if (status >= 0) return yk_state_by_all_loops(s, &s->spare, status);
    keep_branches(s); // there a group's sign is rounding
    free_groups(s);
    if (s->mech->column_count > 0) memcpy(s->groups.x, s->valid_x, s->mech->column_count * sizeof *s->valid_x);
    YkStatus free_status = yk_state_run_here(s);
    restore_branches(s);
    return free_status == YK_SINGULAR ? yk_state_by_all_loops(s, &s->spare, free_status) : status;
}
