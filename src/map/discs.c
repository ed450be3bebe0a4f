// Evaluates the compiled steps in discs.
#include <stdlib.h>
#include "law/law.h"
#include "map/piece.h"

bool yk_discs_start(YkDiscs *discs, const YkMechanism *mech)
{
    *discs = (YkDiscs){.mech = mech, .second = YK_NONE};
    discs->slots = calloc(mech->slot_count + mech->orientation_count + 1, sizeof *discs->slots);
    discs->distances = calloc(mech->distance_count + 1, sizeof *discs->distances);
    discs->nodes = calloc(mech->node_count + 1, sizeof *discs->nodes);
    discs->laws = calloc(mech->relation_count + 1, sizeof *discs->laws);
    if (!discs->slots || !discs->distances || !discs->nodes || !discs->laws) return false;
    for (size_t k = 0; k < mech->relation_count; k++)
        if (mech->relations[k].law) discs->laws[k] = yk_law_bound(mech->relations[k].law);
    discs->slots[0].at = yk_ball(yk_vec(1, 0), 0);
    return true;
}

void yk_discs_end(YkDiscs *discs)
{
    free(discs->slots);
    free(discs->distances);
    free(discs->nodes);
    free(discs->laws);
    *discs = (YkDiscs){0};
}

// --- what can be taken

static bool is_whole(double x)
{
    return x == rint(x) && fabs(x) <= 64;
}

static bool can_take_law(const YkMechanism *mech, const YkRelation *r)
{
    for (uint32_t k = r->first_argument_source; k < r->first_argument_source + r->argument_source_count; k++)
        if (mech->sources[k].kind != YK_SOURCE_INPUT) return false;
    return yk_law_bound(r->law).is_continuous;
}

bool yk_discs_can_take(const YkMechanism *mech, const YkStep *step)
{
    if (step->kind == YK_STEP_CHECK) return false;
    if (step->kind != YK_STEP_RELATION) return true;
    const YkRelation *r = &mech->relations[step->target];
    if (r->law && !can_take_law(mech, r)) return false;
    for (uint32_t k = r->first_source; k < r->first_source + r->source_count; k++) {
        const YkRelationSource *s = &mech->sources[k];
        if (s->kind == YK_SOURCE_COLUMN) return false;
        if (s->kind == YK_SOURCE_SLOT && (r->target.is_distance || !is_whole(s->factor))) return false;
    }
    return true;
}

// --- the steps

YkDual yk_dual_turn(YkDual angle)
{
    double at = angle.at.at.x;
    YkBall e = yk_ball(yk_unit(at), YK_BALL_OUT(angle.at.radius + 1e-15 + fabs(at) * 4e-16));
    return (YkDual){e, yk_ball_mul(yk_ball_mul(yk_ball(yk_vec(0, 1), 0), angle.rate), e)};
}

static YkDual power(YkDual z, int n)
{
    YkDual result = yk_dual_constant(yk_vec(1, 0)), base = n < 0 ? yk_dual_conjugate(z) : z; // |z| = 1
    for (int k = n < 0 ? -n : n; k > 0; k--) result = yk_dual_mul(result, base);
    return result;
}

YkDual yk_discs_input(const YkDiscs *d, int32_t input)
{
    if (d->ways) {
        YkBall way = yk_real_disc(d->ways[input], 0), from = yk_real_disc(d->others[input], 0);
        return (YkDual){yk_ball_add(from, yk_ball_mul(way, d->input)), way};
    }
    if (input == d->second) return (YkDual){d->second_input, yk_ball(yk_vec(0, 0), 0)};
    if (input != d->mapped) return yk_dual_constant(yk_vec(d->others[input], 0));
    return (YkDual){d->input, yk_real_disc(1, 0)};
}

// Returns gain times the law over its argument: by the mean value theorem, as far from its middle as its slope allows.
YkDual yk_discs_law(const YkDiscs *d, const YkRelation *r)
{
    YkLawBound bound = d->laws[r - d->mech->relations];
    YkDual x = yk_dual_constant(yk_vec(r->argument_offset, 0));
    for (uint32_t k = r->first_argument_source; k < r->first_argument_source + r->argument_source_count; k++)
        x = yk_dual_add(
            x, yk_dual_times(yk_vec(d->mech->sources[k].factor, 0), yk_discs_input(d, d->mech->sources[k].index)));
    double y[YK_LAW_ORDER + 1], rounding = 1e-14 * (1 + fabs(x.at.at.x)) * bound.slope, radius = x.at.radius;
    yk_law_eval(r->law, x.at.at.x, y);
    YkBall value = yk_real_disc(y[0], YK_BALL_OUT(bound.slope * radius + rounding + 1e-14 * fabs(y[0])));
    double off = YK_BALL_OUT(bound.curvature * fmax(radius, 1e-14 * (1 + fabs(x.at.at.x))) + 1e-14 * bound.slope);
    YkBall slope = off < bound.slope ? yk_real_disc(y[1], off) : yk_real_disc(0, bound.slope);
    return yk_dual_times(yk_vec(r->gain, 0), (YkDual){value, yk_ball_mul(slope, x.rate)});
}

static void take_relation(YkDiscs *d, const YkRelation *r)
{
    YkDual sum = yk_dual_constant(yk_vec(r->offset, 0)), turn = yk_dual_constant(yk_vec(1, 0));
    for (uint32_t k = r->first_source; k < r->first_source + r->source_count; k++) {
        const YkRelationSource *s = &d->mech->sources[k];
        if (s->kind == YK_SOURCE_SLOT)
            turn = yk_dual_mul(turn, power(d->slots[s->index], (int)s->factor));
        else
            sum = yk_dual_add(sum, yk_dual_times(yk_vec(s->factor, 0), s->kind == YK_SOURCE_INPUT
                                                                           ? yk_discs_input(d, s->index)
                                                                           : d->distances[s->index]));
    }
    if (r->law) sum = yk_dual_add(sum, yk_discs_law(d, r));
    if (r->target.is_distance)
        d->distances[r->target.index] = sum;
    else
        d->slots[r->target.index] = yk_dual_mul(turn, yk_dual_turn(sum));
}

YkDual yk_discs_sum(const YkDiscs *d, const YkSum *sum)
{
    YkDual total = yk_dual_constant(sum->constant);
    if (sum->plus != YK_NONE) total = yk_dual_add(total, d->nodes[sum->plus]);
    if (sum->minus != YK_NONE) total = yk_dual_add(total, yk_dual_negate(d->nodes[sum->minus]));
    for (uint32_t k = sum->first; k < sum->first + sum->count; k++) {
        YkTerm t = d->mech->terms[k];
        YkDual v = yk_dual_times(t.v, d->slots[t.slot]);
        if (t.distance != YK_NONE) v = yk_dual_mul(v, d->distances[t.distance]);
        total = yk_dual_add(total, v);
    }
    return total;
}

// --- loops that repeat others

static YkDual divide(YkDual a, YkDual b)
{
    YkBall inverse = yk_ball_inverse(b.at), at = yk_ball_mul(a.at, inverse);
    YkBall rate = yk_ball_add(a.rate, yk_ball_negate(yk_ball_mul(at, b.rate)));
    return (YkDual){at, yk_ball_mul(rate, inverse)};
}

static YkDual line_of(const YkDiscs *d, const YkBlock *block)
{
    return yk_dual_times(block->line[0], d->slots[block->line_slot[0]]);
}

static YkBall real_part(YkBall a)
{
    return yk_real_disc(a.at.x, a.radius);
}

// Finds the one unknown of a loop: known + arm z = 0, or known + line d = 0.
static void take_repeated(YkDiscs *d, const YkBlock *block)
{
    if (block->kind != YK_BLOCK_LINK) return;
    YkColumn c = block->column[0];
    YkDual away = yk_dual_negate(yk_discs_sum(d, &block->known));
    if (!c.is_distance) {
        d->slots[c.index] = divide(away, yk_discs_sum(d, &block->aside->arm[0]));
        return;
    }
    YkDual along = yk_dual_mul(away, yk_dual_conjugate(line_of(d, block)));
    d->distances[c.index] = (YkDual){real_part(along.at), real_part(along.rate)};
}

YkDual yk_discs_miss(const YkDiscs *d, const YkBlock *block)
{
    YkDual known = yk_dual_times(yk_vec(1 / d->mech->size, 0), yk_discs_sum(d, &block->known));
    if (block->kind == YK_BLOCK_CHECK) return known;
    if (block->column[0].is_distance) {
        YkDual along = yk_dual_mul(known, yk_dual_conjugate(line_of(d, block)));
        return (YkDual){yk_real_disc(along.at.at.y, along.at.radius), yk_real_disc(along.rate.at.y, along.rate.radius)};
    }
    YkDual arm = yk_dual_times(yk_vec(1 / d->mech->size, 0), yk_discs_sum(d, &block->aside->arm[0]));
    return yk_dual_add(yk_dual_mul(known, yk_dual_conjugate(known)),
                       yk_dual_negate(yk_dual_mul(arm, yk_dual_conjugate(arm))));
}

void yk_discs_take(YkDiscs *d, const YkStep *step)
{
    switch (step->kind) {
    case YK_STEP_TURN: {
        YkDual angle = yk_dual_add(yk_discs_input(d, step->input), yk_dual_constant(yk_vec(step->offset, 0)));
        d->slots[step->target] =
            yk_dual_mul(d->slots[step->parent], yk_dual_turn(yk_dual_times(yk_vec(step->sign, 0), angle)));
        break;
    }
    case YK_STEP_COMPOSE:
        d->slots[step->target] = yk_dual_mul(d->slots[step->parent], d->slots[step->other]);
        break;
    case YK_STEP_DISTANCE:
        d->distances[step->target] = yk_discs_input(d, step->input);
        break;
    case YK_STEP_NODE:
        d->nodes[step->target] = yk_discs_sum(d, &d->mech->node_sums[step->target]);
        break;
    case YK_STEP_RELATION:
        take_relation(d, &d->mech->relations[step->target]);
        break;
    case YK_STEP_BLOCK:
        take_repeated(d, &d->mech->blocks[step->target]);
        break;
    default:
        break;
    }
}
