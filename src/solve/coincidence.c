// Settles dyads that any angle closes: the angle stays as it was, the pose is one of the machine, and its rates are
// unknown.
#include "solve/coincidence.h"

// Over the size: a shorter vector has no direction, and a loop that closes may miss by as much.
static const double VANISHED = 5e-13;

static YkVec sum_at(const YkRun *run, const YkSum *sum, int scratch)
{
    YkPlane p = yk_space_scratch(run->space, scratch);
    yk_run_sum(run, sum, p);
    return yk_vec(p.x[0], p.y[0]);
}

static void stand(const YkRun *run, int32_t slot, YkVec e)
{
    YkTurn t = yk_space_turn(run->space, slot);
    double length = yk_norm(e);
    YkVec unit = length > 0 ? yk_scale(1 / length, e) : yk_vec(1, 0);
    *t.c = unit.x, *t.s = unit.y;
    *t.w = *t.a = 0;
}

static void stand_off(const YkRun *run, int32_t distance, double d)
{
    YkSlide slide = yk_space_slide(run->space, distance);
    *slide.d = d;
    *slide.v = *slide.a = 0;
}

static YkVec kept_unit(const YkTurn *kept, int32_t slot)
{
    return yk_vec(*kept[slot].c, *kept[slot].s);
}

// Settles K + U e1 + W e2 = 0. An arm without length leaves its own angle open, a base without length both.
static bool settle_rrr(const YkRun *run, const YkBlock *b, const YkTurn *kept, double least)
{
    YkVec K = sum_at(run, &b->known, YK_SCRATCH_KNOWN), arm[2];
    int32_t slot[2] = {b->column[0].index, b->column[1].index};
    for (int k = 0; k < 2; k++) arm[k] = sum_at(run, &b->aside->arm[k], YK_SCRATCH_ARM_1 + k);
    int open = yk_norm(arm[0]) < least ? 0 : 1, held = 1 - open;
    bool has_base = yk_norm(K) >= least, has_arm = yk_norm(arm[open]) >= least;
    if (has_base && has_arm) return false;
    if (!has_base) open = 0, held = 1;
    YkVec e = kept_unit(kept, slot[open]);
    YkVec other = yk_scale(-1, has_base ? K : yk_mul(arm[open], e));
    double miss = yk_norm(other) - yk_norm(arm[held]);
    if (!(fabs(miss) < 2 * least)) return false;
    stand(run, slot[open], e);
    stand(run, slot[held], yk_mul(other, yk_conj(arm[held])));
    return true;
}

// Settles K + W e^(i Phi) + d e = 0 if W has no length.
static bool settle_rrp(const YkRun *run, const YkBlock *b, const YkTurn *kept, double least)
{
    if (b->arm_is_constant[0] || !(yk_norm(sum_at(run, &b->aside->arm[0], YK_SCRATCH_ARM_1)) < least)) return false;
    YkVec K = sum_at(run, &b->known, YK_SCRATCH_KNOWN), e = b->line[0];
    YkTurn line = yk_space_turn(run->space, b->line_slot[0]);
    if (line.c) e = yk_mul(yk_vec(*line.c, *line.s), e);
    if (!(fabs(yk_cross(K, e)) < 2 * least)) return false;
    stand(run, b->column[0].index, kept_unit(kept, b->column[0].index));
    stand_off(run, b->column[1].index, -yk_dot(K, e));
    return true;
}

// Settles K + (C + d f) e^(i Phi) = 0 if K has no length: the point of the line at the pin is the one nearest to it.
static bool settle_rpr(const YkRun *run, const YkBlock *b, const YkTurn *kept, double least)
{
    if (!(yk_norm(sum_at(run, &b->known, YK_SCRATCH_KNOWN)) < least)) return false;
    YkVec C = sum_at(run, &b->aside->arm[0], YK_SCRATCH_ARM_1), f = b->line[0];
    YkTurn inner = yk_space_turn(run->space, b->line_slot[0]);
    if (inner.c) f = yk_mul(yk_vec(*inner.c, *inner.s), f);
    if (!(fabs(yk_cross(f, C)) < 2 * least)) return false;
    stand(run, b->column[0].index, kept_unit(kept, b->column[0].index));
    stand_off(run, b->column[1].index, -yk_dot(f, C));
    return true;
}

static bool settle_block(const YkRun *run, const YkBlock *b, const YkTurn *kept)
{
    double least = VANISHED * run->mech->size;
    if (b->kind == YK_BLOCK_RRR) return settle_rrr(run, b, kept, least);
    if (b->kind == YK_BLOCK_RRP) return settle_rrp(run, b, kept, least);
    return b->kind == YK_BLOCK_RPR && settle_rpr(run, b, kept, least);
}

bool yk_run_settled(const YkRun *run, size_t from, size_t to, const YkTurn *kept)
{
    double *margin = run->space->margin;
    bool found = false;
    yk_run_begin(run);
    for (size_t k = from; k < to; k++) {
        const YkStep *step = &run->mech->steps[k];
        double before = *margin;
        yk_run_steps(run, k, k + 1);
        if (step->kind != YK_STEP_BLOCK || !yk_may_coincide(run->space->block_margin[step->target])) continue;
        if (!settle_block(run, &run->mech->blocks[step->target], kept)) continue;
        run->space->block_margin[step->target] = 0;
        *margin = fmin(before, 0);
        found = true;
    }
    return found;
}
