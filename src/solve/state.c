// States: inputs, solving a pose at them, copies, and the judgement of a pose.
#include "solve/state.h"
#include <stdlib.h>
#include <string.h>
#include "compile/closure.h"
#include "compile/topology.h"
#include "solve/all_loops.h"
#include "solve/assemble.h"
#include "solve/coincidence.h"
#include "solve/relations.h"
#include "solve/track.h"

static bool allocate(YkState *s)
{
    const YkMechanism *mech = s->mech;
    size_t inputs = mech->input_count, n = mech->coordinate_count;
    YkArena *a = s->arena = yk_arena_new();
    s->input = YK_NEW(a, double, 3 * inputs);
    s->valid_input = YK_NEW(a, double, 3 * inputs);
    s->held = YK_NEW(a, double, 3 * inputs);
    s->is_held = YK_NEW(a, bool, 3 * inputs);
    s->input_lanes = YK_NEW(a, const double *, 3 * inputs);
    s->phases = YK_NEW(a, YkPhase, inputs);
    s->reference = YK_NEW(a, double, n);
    s->guess = YK_NEW(a, double, n);
    s->slot_reference = YK_NEW(a, double, mech->reference_count);
    s->is_guessed = YK_NEW(a, bool, n);
    s->branch = YK_NEW(a, signed char, mech->block_count);
    s->valid_x = YK_NEW(a, double, mech->column_count);
    s->arrival = YK_NEW(a, double, inputs);
    s->heading = YK_NEW(a, double, inputs);
    s->search = yk_search_new(mech, a);
    return s->search && !yk_arena_failed(a) && yk_space_start(&s->space, mech, 1, true) &&
           yk_space_start(&s->spare, mech, 1, true) && yk_group_start(&s->groups, mech) && yk_all_loops_start(s);
}

static void mark_guesses(YkState *s)
{
    const YkModel *model = s->mech->model;
    yk_start_guess(s->mech, s->guess);
    for (size_t k = 0; k < model->start_count; k++) {
        const YkCoordinate *c = &model->coordinates[model->starts[k].coordinate];
        int32_t q = model->starts[k].is_rate ? YK_NONE : yk_tree_coordinate(s->mech, c->joint, c->is_distance);
        if (q != YK_NONE) s->is_guessed[q] = true;
    }
}

YkState *yk_state_new(const YkMechanism *mech)
{
    YkState *s = calloc(1, sizeof *s);
    if (!s) return NULL;
    s->mech = mech;
    if (!allocate(s)) {
        yk_state_free(s);
        return NULL;
    }
    for (size_t k = 0; k < 3 * mech->input_count; k++) s->input_lanes[k] = &s->input[k];
    mark_guesses(s);
    memcpy(s->reference, s->guess, mech->coordinate_count * sizeof *s->reference);
    yk_relations_guess(s);
    yk_state_set_time(s, 0, NULL);
    return s;
}

void yk_state_free(YkState *s)
{
    if (!s) return;
    yk_space_end(&s->space);
    yk_space_end(&s->spare);
    yk_group_end(&s->groups);
    yk_search_end(s->search);
    yk_state_free(s->before);
    free(s->all_loops);
    yk_arena_free(s->arena);
    free(s);
}

void yk_state_take(YkState *to, const YkState *from)
{
    const YkMechanism *mech = to->mech;
    memcpy(to->guess, from->guess, mech->coordinate_count * sizeof *to->guess);
    memcpy(to->is_guessed, from->is_guessed, mech->coordinate_count * sizeof *to->is_guessed);
    bool same = mech == from->mech; // a variant may keep nodes that cancel in the file's own mechanism
    if (same) yk_space_copy(&to->space, &from->space);
    memcpy(to->input, from->input, 3 * mech->input_count * sizeof *to->input);
    memcpy(to->valid_input, from->valid_input, 3 * mech->input_count * sizeof *to->input);
    memcpy(to->held, from->held, 3 * mech->input_count * sizeof *to->held);
    memcpy(to->is_held, from->is_held, 3 * mech->input_count * sizeof *to->is_held);
    memcpy(to->arrival, from->arrival, mech->input_count * sizeof *to->arrival);
    memcpy(to->heading, from->heading, mech->input_count * sizeof *to->heading);
    to->arrival_time = from->arrival_time, to->time_heading = from->time_heading;
    memcpy(to->phases, from->phases, mech->input_count * sizeof *to->phases);
    to->has_phases = to->has_phases || from->has_phases;
    memcpy(to->reference, from->reference, mech->coordinate_count * sizeof *to->reference);
    memcpy(to->slot_reference, from->slot_reference, mech->reference_count * sizeof *to->slot_reference);
    memcpy(to->branch, from->branch, mech->block_count);
    memcpy(to->valid_x, from->valid_x, mech->column_count * sizeof *to->valid_x);
    if (mech->column_count > 0) memcpy(to->groups.x, from->groups.x, mech->column_count * sizeof *to->groups.x);
    to->time = from->time;
    to->has_pose = same && from->has_pose;
    to->has_rates = same && from->has_rates;
    to->is_regular = same && from->is_regular;
    to->is_clear = same && from->is_clear;
    to->is_kept = same && from->is_kept;
    to->report = from->report;
}

YkStatus yk_state_copy(YkState *to, const YkState *from)
{
    if (to->mech != from->mech) return YK_BAD_ARGUMENT;
    yk_state_take(to, from);
    return YK_OK;
}

// --- inputs

void yk_state_hold_input(YkState *s, size_t input, int order, double value)
{
    if (input >= s->mech->input_count || order < 0 || order > 2) return;
    size_t k = 3 * input + (size_t)order;
    s->is_held[k] = true;
    s->held[k] = s->input[k] = value;
}

double yk_state_time(const YkState *s)
{
    return s->time;
}

void yk_state_set_input_to(YkState *s, size_t input, double position, double velocity, double acceleration)
{
    if (input >= s->mech->input_count) return;
    s->input[3 * input] = position;
    s->input[3 * input + 1] = velocity;
    s->input[3 * input + 2] = acceleration;
}

void yk_state_set_input(YkState *s, size_t input, YkMotion m)
{
    yk_state_set_input_to(s, input, m.position, m.velocity, m.acceleration);
}

YkMotion yk_state_input(const YkState *s, size_t input)
{
    if (input >= s->mech->input_count) return (YkMotion){(double)NAN, (double)NAN, (double)NAN};
    return (YkMotion){s->input[3 * input], s->input[3 * input + 1], s->input[3 * input + 2]};
}

// --- solving

static double rate_of(const YkMechanism *mech, const YkSpace *space, YkColumn column, int order)
{
    if (column.is_distance) {
        YkSlide d = yk_space_slide(space, column.index);
        return fabs(order == 1 ? *d.v : *d.a) / mech->size;
    }
    YkTurn t = yk_space_turn(space, column.index);
    return fabs(order == 1 ? *t.w : *t.a);
}

// With rates w, an error of rounding / sine in the position grows to w^2 * rounding / sine^3 in the accelerations, and
// forces have their errors over the sine.
static bool is_block_blurred(const YkMechanism *mech, const YkSpace *space, size_t index, bool has_forces)
{
    const double rounding = 1e-16, most = 1e-2; // share of the accelerations, or of the rates squared if these are more
    const YkBlock *b = &mech->blocks[index];
    const YkColumn *column = b->kind == YK_BLOCK_GROUP ? mech->group_columns + b->first_column : b->column;
    double m = space->block_margin[index], rate = 0, accel = 0;
    if ((b->kind > YK_BLOCK_PP && b->kind != YK_BLOCK_GROUP) || m > YK_FORCE_MARGIN) return false;
    for (uint32_t k = 0; k < b->column_count; k++) {
        rate = fmax(rate, rate_of(mech, space, column[k], 1));
        accel = fmax(accel, rate_of(mech, space, column[k], 2));
    }
    double sine = sqrt(fmax(m, 0));
    return rounding * rate * rate > most * m * sine * (has_forces ? sine : 1) * fmax(accel, rate * rate);
}

static bool has_blurred_block(const YkMechanism *mech, const YkSpace *space, bool has_forces)
{
    for (size_t b = 0; b < mech->block_count; b++)
        if (is_block_blurred(mech, space, b, has_forces)) return true;
    return false;
}

bool yk_is_blurred(const YkMechanism *mech, const YkSpace *space)
{
    return space->margin[0] <= YK_SINGULAR_MARGIN || has_blurred_block(mech, space, false);
}

bool yk_state_blurs_forces(const YkState *s)
{
    if (s->space.margin[0] > YK_FORCE_MARGIN || s->is_clear || s->is_regular) return false;
    return has_blurred_block(s->mech, &s->space, true);
}

YkStatus yk_state_judge(const YkState *s, const YkSpace *space)
{
    if (!(space->margin[0] >= YK_LIMIT_MARGIN)) return YK_LIMIT;
    // The smallest tolerance usually suffices.
    bool is_closed = space->gap[0] <= s->mech->size * YK_CLOSING_TOLERANCE;
    if (!is_closed && !(space->gap[0] <= yk_gap_tolerance(s->mech, space->margin[0]))) return YK_NO_ASSEMBLY;
    if (space->margin[0] <= YK_BLUR_MARGIN && yk_is_blurred(s->mech, space)) return YK_SINGULAR;
    return s->mech->redundant_count + s->mech->redundant_relation_count > 0 ? YK_REDUNDANT : YK_OK;
}

// Exchanges two spaces of a state, 16 bytes at a time: through a whole copy it took a tenth of the time of a pose.
static inline void exchange(YkSpace *a, YkSpace *b)
{
    typedef struct Pair {
        uint64_t words[2];
    } Pair;
    enum { DIFFERENT = offsetof(YkSpace, slots) };
    _Static_assert(DIFFERENT % sizeof(Pair) == 0, "whole pairs are exchanged");
    unsigned char *p = (unsigned char *)a, *q = (unsigned char *)b;
    for (size_t k = 0; k < DIFFERENT; k += sizeof(Pair)) {
        Pair x, y;
        memcpy(&x, p + k, sizeof x);
        memcpy(&y, q + k, sizeof y);
        memcpy(p + k, &y, sizeof y);
        memcpy(q + k, &x, sizeof x);
    }
}

void yk_state_accept(YkState *s)
{
    exchange(&s->space, &s->spare);
    memcpy(s->valid_input, s->input, 3 * s->mech->input_count * sizeof *s->input);
    if (s->mech->column_count > 0) memcpy(s->valid_x, s->groups.x, s->mech->column_count * sizeof *s->valid_x);
    s->has_pose = true;
    s->is_clear = false;
    s->has_rates = s->is_regular || s->space.margin[0] > YK_BLUR_MARGIN || !yk_is_blurred(s->mech, &s->space);
}

void yk_state_refer(YkState *s)
{
    yk_relations_refer(s, &s->space);
    for (size_t k = 0; k < s->mech->coordinate_count; k++)
        if (!s->mech->coordinates[k].is_distance) s->reference[k] = yk_coordinate_in(s, &s->space, k).position;
}

// Returns whether the rates are numbers that cannot be computed with.
static bool is_too_fast(const YkState *s)
{
    for (const double *in = s->input; in < s->input + 3 * s->mech->input_count; in += 3)
        if (isfinite(in[1]) && isfinite(in[2]) &&
            (!isfinite(in[1] * YK_RATE_GUARD) || !isfinite(in[2] * YK_ACCELERATION_GUARD)))
            return true;
    return false;
}

// Settles a pose that does not close or is singular, since it may be a coincidence: angles that no loop determines then
// stay.
static YkStatus settle(YkState *s, YkStatus status)
{
    bool may = false;
    for (size_t b = 0; b < s->mech->block_count; b++) may = may || yk_may_coincide(s->spare.block_margin[b]);
    if (!may || !s->has_pose) return status;
    YkRun run = yk_state_run(s, &s->spare);
    s->is_kept = yk_run_settled(&run, 0, s->mech->step_count, s->space.turn);
    return s->is_kept ? yk_state_judge(s, &s->spare) : status;
}

static YkStatus solve(YkState *s)
{
    if (!yk_state_spend(s, s->mech->step_count)) return YK_STOPPED;
    if (s->mech->has_groups) return yk_state_track(s);
    if (s->mech->reference_count > 0) yk_state_walk(s);
    YkRun run = yk_state_run(s, &s->spare);
    yk_run_begin(&run);
    yk_run_steps(&run, 0, s->mech->step_count);
    YkStatus status = yk_state_judge(s, &s->spare);
    s->is_kept = false;
    s->is_regular = false;
    if (status < 0 || status == YK_SINGULAR) status = settle(s, status);
    if (s->spare.margin[0] <= YK_NEAR_MARGIN) status = yk_state_by_all_loops(s, &s->spare, status);
    yk_state_tell(s, &s->spare, status);
    if (status >= 0) yk_state_accept(s);
    if (status < 0 && s->mech->reference_count > 0) yk_state_walk_back(s);
    return status;
}

YkStatus yk_state_solve(YkState *s)
{
    YkStatus status = solve(s);
    if (status >= 0) return status;
    if (yk_state_is_stopped(s)) return yk_state_end(s, false, status);
    if (!is_too_fast(s)) return status;
    return yk_state_refuse(s, YK_BAD_ARGUMENT, "the rates of the inputs are too large to be computed with");
}

const YkMechanism *yk_state_mechanism(const YkState *s)
{
    return s->mech;
}
int yk_state_branch(const YkState *s, size_t block)
{
    if (block >= s->mech->block_count) return 0;
    return s->branch[block];
}
void yk_state_set_branch(YkState *s, size_t block, int branch)
{
    if (block >= s->mech->block_count) return;
    s->branch[block] = (signed char)((branch > 0) - (branch < 0));
}
bool yk_state_has_pose(const YkState *s)
{
    return s->has_pose;
}
bool yk_state_has_rates(const YkState *s)
{
    return s->has_rates;
}
const YkReport *yk_state_report(const YkState *s)
{
    return &s->report;
}
