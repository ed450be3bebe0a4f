// Runs compiled steps over lanes: turns, sums, blocks and relations.
#include "solve/run.h"
#include "elementary/kernel.h"
#include "solve/relations.h"
#include "solve/single.h"
#include <string.h>

static void begin_single(const YkRun *run)
{
    const double *const *in = run->inputs, *const *end = in + 3 * run->mech->input_count;
    double numbers = 0; // or NaN: see yk_lanes_begin
    for (; in < end; in += 3)
        numbers += 0 * *in[0] + 0 * (*in[1] * YK_RATE_GUARD) + 0 * (*in[2] * YK_ACCELERATION_GUARD);
    run->space->margin[0] = numbers == 0 ? 1 : -1;
    run->space->gap[0] = 0;
}

// Returns whether all inputs are numbers.
static bool are_numbers(const YkRun *run)
{
    bool all = true;
    for (size_t i = 0; all && i < run->mech->input_count; i++)
        yk_lanes_numbers(&all, run->inputs[3 * i], run->inputs[3 * i + 1], run->inputs[3 * i + 2], run->lanes);
    return all;
}

// Apart, so that one pose does not pay for it.
YK_APART void begin_lanes(const YkRun *run)
{
    double *margin = run->space->margin;
    size_t n = run->lanes, inputs = run->mech->input_count;
    if (YK_KNOWS_BLOCKS && run->is_plain && (*run->is_plain = are_numbers(run))) return;
    if (yk_measures_gaps(run->mech)) memset(run->space->gap, 0, n * sizeof(double));
    for (size_t i = 0; i < inputs; i++)
        yk_lanes_begin(margin, run->inputs[3 * i], run->inputs[3 * i + 1], run->inputs[3 * i + 2], i == 0, n);
    for (size_t k = 0; inputs == 0 && k < n; k++) margin[k] = 1;
}

void yk_run_begin(const YkRun *run)
{
    if (run->lanes == 1)
        begin_single(run);
    else
        begin_lanes(run);
}

static void add_term(const YkRun *run, YkTerm term, YkPlane out)
{
    YkTurn turn = yk_space_turn(run->space, term.slot);
    if (term.distance == YK_NONE)
        yk_lanes_add_turn(out, turn, term.v, run->lanes);
    else
        yk_lanes_add_slide(out, turn, term.v, yk_space_slide(run->space, term.distance), run->lanes);
}

void yk_run_sum(const YkRun *run, const YkSum *sum, YkPlane out)
{
    if (run->space->stride == 1) {
        yk_run_single_sum(run, sum, out);
        return;
    }
    const YkTerm *terms = run->mech->terms + sum->first;
    uint32_t k = 0;
    if (sum->plus == YK_NONE && sum->minus == YK_NONE && sum->count > 0 && terms[0].distance == YK_NONE) {
        yk_lanes_start_turn(out, sum->constant, yk_space_turn(run->space, terms[0].slot), terms[0].v, run->lanes);
        k = 1;
    } else {
        yk_lanes_start(out, sum->constant, yk_space_plane(run->space, sum->plus),
                       yk_space_plane(run->space, sum->minus), run->lanes);
    }
    for (; k < sum->count; k++) add_term(run, terms[k], out);
}

void yk_run_point(const YkRun *run, size_t point, YkPlane out)
{
    const YkPoint *p = &run->mech->model->points[point];
    YkTerm term = yk_body_term(run->mech, p->body, p->at);
    YkSum origin = run->mech->bodies[p->body].origin;
    if (term.slot == 0) origin.constant = yk_add(origin.constant, term.v);
    yk_run_sum(run, &origin, out);
    if (term.slot != 0) yk_lanes_add_turn(out, yk_space_turn(run->space, term.slot), term.v, run->lanes);
}

static YkArm varying_arm(const YkRun *run, const YkBlock *block, int k)
{
    YkArm arm = {.lanes = yk_space_scratch(run->space, YK_SCRATCH_ARM_1 + k), .per_enough2 = block->per_size2};
    yk_run_sum(run, &block->aside->arm[k], arm.lanes);
    return arm;
}

// Returns a constant arm, judged as in yk_block_measure; an RPR is judged by its base, which varies.
static inline YkArm constant_arm(const YkBlock *block, int k)
{
    double share = block->kind == YK_BLOCK_RPR ? 1 : YK_PER_ARM_ENOUGH2;
    return (YkArm){.constant = block->aside->arm[k].constant, .per_enough2 = share * block->per_size2};
}

static inline YkArm arm_of(const YkRun *run, const YkBlock *block, int k)
{
    return block->arm_is_constant[k] ? constant_arm(block, k) : varying_arm(run, block, k);
}

// Returns whether a sum is a constant and one turned vector along x: K.
static bool is_turned(const YkRun *run, const YkSum *sum, YkTurned *K)
{
    if (sum->count != 1 || sum->plus != YK_NONE || sum->minus != YK_NONE) return false;
    YkTerm term = run->mech->terms[sum->first];
    if (term.slot == 0 || term.distance != YK_NONE || !yk_is_axial(term.v)) return false;
    K->constant = sum->constant;
    K->along = term.v.x;
    K->turn = yk_space_turn(run->space, term.slot);
    return true;
}

typedef struct Outs { // of a dyad
    YkTurn turn, other;
    YkSlide slide;
    double *margin, *own, branch;
} Outs;

// Returns the outputs of a block; those that its kind lacks are the ground's, or the first.
static inline Outs outs_of(const YkRun *run, const YkBlock *b, size_t index)
{
    const YkSpace *s = run->space;
    int32_t second = b->column[1].index, turn = b->kind == YK_BLOCK_RRR ? second : 0, slide = turn ? 0 : second;
    return (Outs){yk_space_turn(s, b->column[0].index),
                  yk_space_turn(s, turn),
                  yk_space_slide(s, slide),
                  s->margin,
                  s->block_margin ? s->block_margin + index * s->stride : NULL,
                  run->branch[index] < 0 ? -1 : 1};
}

// Runs closed forms, positions and rates together. The most common compute their known part themselves.
static bool run_turned(const YkRun *run, const YkBlock *b, size_t index)
{
    YkTurned K;
    if (b->form <= YK_FORM_RRR_SHORT || !is_turned(run, &b->known, &K)) return false;
    Outs out = outs_of(run, b, index);
    YkArm arm = constant_arm(b, 0);
    if (b->kind == YK_BLOCK_RRR)
        yk_lanes_rrr_turned(&K, arm, constant_arm(b, 1), out.branch, out.turn, out.other, out.margin, out.own,
                            run->lanes);
    else if (b->kind == YK_BLOCK_RRP)
        yk_lanes_rrp_turned(&K, arm, yk_space_turn(run->space, b->line_slot[0]), b->line[0], out.branch, out.turn,
                            out.slide, out.margin, out.own, run->lanes);
    else
        yk_lanes_rpr_turned(&K, arm, b->line[0], out.branch, out.turn, out.slide, out.margin, out.own, run->lanes);
    return true;
}

static void run_pp(const YkRun *run, const YkBlock *b, size_t index, YkPlane K)
{
    const YkSpace *s = run->space;
    double *own = s->block_margin ? s->block_margin + index * s->stride : NULL;
    YkTurn line1 = yk_space_turn(s, b->line_slot[0]), line2 = yk_space_turn(s, b->line_slot[1]);
    YkSlide d1 = yk_space_slide(s, b->column[0].index), d2 = yk_space_slide(s, b->column[1].index);
    yk_lanes_pp(K, line1, b->line[0], line2, b->line[1], d1, d2, s->margin, own, run->lanes);
    yk_lanes_pp_rates(K, line1, b->line[0], line2, b->line[1], d1, d2, run->lanes);
}

static void run_dyad(const YkRun *run, const YkBlock *b, size_t index)
{
    YkPlane K = yk_space_scratch(run->space, YK_SCRATCH_KNOWN);
    size_t n = run->lanes;
    if (run_turned(run, b, index)) return;
    yk_run_sum(run, &b->known, K);
    if (b->kind == YK_BLOCK_PP) {
        run_pp(run, b, index, K);
        return;
    }
    Outs out = outs_of(run, b, index);
    YkArm arm = arm_of(run, b, 0);
    YkTurn line = yk_space_turn(run->space, b->line_slot[0]);
    if (b->kind == YK_BLOCK_RRR)
        yk_lanes_rrr(K, arm, arm_of(run, b, 1), out.branch, out.turn, out.other, out.margin, out.own, n);
    else if (b->kind == YK_BLOCK_RRP)
        yk_lanes_rrp(K, arm, line, b->line[0], out.branch, out.turn, out.slide, out.margin, out.own, n);
    else
        yk_lanes_rpr(K, arm, line, b->line[0], out.branch, out.turn, out.slide, out.margin, out.own, n);
}

// Runs blocks that repeat constraints: one unknown or none.
static void run_redundant(const YkRun *run, const YkBlock *b)
{
    const YkSpace *s = run->space;
    YkPlane K = yk_space_scratch(s, YK_SCRATCH_KNOWN);
    yk_run_sum(run, &b->known, K);
    if (b->kind == YK_BLOCK_CHECK) {
        yk_lanes_gap(K, s->gap, run->lanes);
    } else if (b->column[0].is_distance) {
        YkTurn line = yk_space_turn(s, b->line_slot[0]);
        YkSlide d = yk_space_slide(s, b->column[0].index);
        yk_lanes_guide(K, line, b->line[0], d, s->gap, run->lanes);
        yk_lanes_guide_rates(K, line, b->line[0], d, run->lanes);
    } else {
        YkTurn out = yk_space_turn(s, b->column[0].index);
        YkArm U = arm_of(run, b, 0);
        yk_lanes_link(K, U, out, s->gap, run->lanes);
        yk_lanes_link_rates(K, U, out, run->lanes);
    }
}

static void run_block(const YkRun *run, size_t index)
{
    const YkBlock *b = &run->mech->blocks[index];
    if (b->kind == YK_BLOCK_GROUP)
        yk_group_solve(run, index, run->branch[index]);
    else if (b->kind == YK_BLOCK_LINK || b->kind == YK_BLOCK_CHECK)
        run_redundant(run, b);
    else
        run_dyad(run, b, index);
}

static void run_distance(const YkRun *run, const YkStep *step)
{
    const double *const *in = run->inputs + 3 * step->input;
    YkSlide d = yk_space_slide(run->space, step->target);
    for (size_t k = 0; k < run->lanes; k++) {
        d.d[k] = in[0][k];
        d.v[k] = in[1][k];
        d.a[k] = in[2][k];
    }
}

// Returns whether the rates of an input are those of the body that it turns: against the ground, and where no row of
// results is written in place of them.
static bool shares_rates(const YkRun *run, const YkStep *step)
{
    return YK_KNOWS_BLOCKS && run->rates_alone && step->parent == 0 && step->sign == 1;
}

// Reads the rates where the caller has them: yk_lanes_turn leaves a row alone that is its own source.
static void share_rates(const YkSpace *space, int32_t slot, const double *const *in)
{
    space->turn[slot].w = (double *)(uintptr_t)in[1];
    space->turn[slot].a = (double *)(uintptr_t)in[2];
}

void yk_run_lanes(const YkRun *run, const YkStep *step)
{
    const YkSpace *s = run->space;
    switch (step->kind) {
    case YK_STEP_TURN: {
        const double *const *in = run->inputs + 3 * step->input;
        if (yk_run_is_idle(run, step->target)) break;
        if (shares_rates(run, step)) share_rates(s, step->target, in);
        yk_lanes_turn(yk_run_turn(run, step->target), yk_space_turn(s, step->parent), in[0], in[1], in[2], step->offset,
                      step->sign, run->lanes);
        break;
    }
    case YK_STEP_COMPOSE:
        yk_lanes_compose(yk_space_turn(s, step->target), yk_space_turn(s, step->parent), yk_space_turn(s, step->other),
                         run->lanes);
        break;
    case YK_STEP_DISTANCE:
        run_distance(run, step);
        break;
    case YK_STEP_NODE:
        yk_run_sum(run, &run->mech->node_sums[step->target], yk_space_plane(s, step->target));
        break;
    case YK_STEP_BLOCK:
        run_block(run, (size_t)step->target);
        break;
    case YK_STEP_RELATION:
        yk_run_relation(run, (size_t)step->target);
        break;
    case YK_STEP_CHECK:
        yk_run_relation_check(run, (size_t)step->target);
        break;
    }
}

void yk_run_steps(const YkRun *run, size_t from, size_t to)
{
    if (run->space->stride == 1) {
        yk_run_single(run, from, to);
        return;
    }
    for (size_t k = from; k < to; k++) yk_run_lanes(run, &run->mech->steps[k]);
}
