// Takes the compiled steps in discs, and reads blocks as systems.
#include "map/piece.h"
#include <stdlib.h>
#include <string.h>
#include "configurations/certify.h"
#include "law/law.h"

// Returns the lowest order of a derivative in which a law jumps, 0: its value; 3 if neither slope nor curvature does. So many
// jumps that not all are read count as those of the value.
static int first_jump(const YkLaw *law)
{
    enum { JUMPS_MAX = 64 };
    YkLawJump jumps[JUMPS_MAX];
    int order = 3;
    size_t count = yk_law_jumps(law, jumps, JUMPS_MAX);
    for (size_t k = 0; k < count && k < JUMPS_MAX; k++) order = jumps[k].order < order ? jumps[k].order : order;
    return count > JUMPS_MAX ? 0 : order;
}

// Bounds the laws of relations. A law without a period stands still outside of its range, so that its slope may jump there.
static void bound_laws(YkDiscs *discs)
{
    const double out = 1 + 1e-6; // peaks are exact up to rounding
    for (size_t k = 0; k < discs->mech->relation_count; k++) {
        const YkLaw *law = discs->mech->relations[k].law;
        if (!law) continue;
        bool is_smooth = yk_law_range(law).period > 0 && first_jump(law) > 1;
        YkLawPeak slope = yk_law_peak(law, 1), curvature = yk_law_peak(law, 2);
        discs->laws[k] = (YkLawBound){out * fabs(slope.value), is_smooth ? out * fabs(curvature.value) : INFINITY};
    }
}

bool yk_discs_start(YkDiscs *discs, const YkMechanism *mech)
{
    *discs = (YkDiscs){.mech = mech, .second = YK_NONE};
    discs->slots = calloc(mech->slot_count + mech->orientation_count + 1, sizeof *discs->slots);
    discs->distances = calloc(mech->distance_count + 1, sizeof *discs->distances);
    discs->nodes = calloc(mech->node_count + 1, sizeof *discs->nodes);
    discs->laws = calloc(mech->relation_count + 1, sizeof *discs->laws);
    if (!discs->slots || !discs->distances || !discs->nodes || !discs->laws) return false;
    bound_laws(discs);
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

// --- the structure of a block

static YkPieceStatus read_group(YkPiece *piece, const YkMechanism *mech)
{
    switch (yk_shape_read(&piece->shape, mech, piece->block)) {
    case YK_OUTSIDE_NOT:
        return YK_PIECE_READ;
    case YK_OUTSIDE_RELATIONS:
        return YK_PIECE_RELATIONS;
    case YK_OUTSIDE_REDUNDANT:
        return YK_PIECE_REDUNDANT;
    case YK_OUTSIDE_LARGE:
        return YK_PIECE_LARGE;
    default:
        return YK_PIECE_LINES;
    }
}

YkPieceStatus yk_piece_read(YkPiece *piece, const YkMechanism *mech, size_t step)
{
    *piece = (YkPiece){.block = (size_t)mech->steps[step].target, .step = step};
    const YkBlock *block = &mech->blocks[piece->block];
    if (block->kind == YK_BLOCK_GROUP) return read_group(piece, mech);
    if (block->kind == YK_BLOCK_LINK || block->kind == YK_BLOCK_CHECK) return YK_PIECE_REPEATED;
    size_t angles = block->kind == YK_BLOCK_RRR ? 2 : block->kind == YK_BLOCK_PP ? 0 : 1;
    piece->shape = (YkShape){.loops = 1, .angles = angles, .unknowns = 2, .turning = {-1, -1}, .column = {0, 1}};
    if (block->kind == YK_BLOCK_RPR) piece->shape.turning[1] = 0;
    return YK_PIECE_READ;
}

double yk_piece_size(const YkPiece *piece, const YkVec *x, size_t unknown)
{
    double size = yk_sum_norm(x[unknown]);
    return unknown < piece->shape.angles ? size : fmax(1, size);
}

// --- the steps

static bool is_whole(double x)
{
    return x == rint(x) && fabs(x) <= 64;
}

static bool can_take_law(const YkMechanism *mech, const YkRelation *r)
{
    for (uint32_t k = r->first_argument_source; k < r->first_argument_source + r->argument_source_count; k++)
        if (mech->sources[k].kind != YK_SOURCE_INPUT) return false;
    return first_jump(r->law) > 0;
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

// --- values with their derivatives

static YkBall real_disc(double at, double radius)
{
    return yk_ball(yk_vec(at, 0), radius);
}

static YkDual constant(YkVec v)
{
    return (YkDual){yk_ball(v, 0), yk_ball(yk_vec(0, 0), 0)};
}

static YkDual add(YkDual a, YkDual b)
{
    return (YkDual){yk_ball_add(a.at, b.at), yk_ball_add(a.rate, b.rate)};
}

static YkDual negate(YkDual a)
{
    return (YkDual){yk_ball_negate(a.at), yk_ball_negate(a.rate)};
}

static YkDual mul(YkDual a, YkDual b)
{
    return (YkDual){yk_ball_mul(a.at, b.at), yk_ball_add(yk_ball_mul(a.rate, b.at), yk_ball_mul(a.at, b.rate))};
}

// Returns the product with a constant, whose zeros stay zeros.
static YkDual times(YkVec v, YkDual a)
{
    YkBall factor = yk_ball(v, 0);
    return (YkDual){yk_ball_mul(factor, a.at), yk_ball_mul(factor, a.rate)};
}

static YkDual conjugate(YkDual a)
{
    return (YkDual){yk_ball(yk_conj(a.at.at), a.at.radius), yk_ball(yk_conj(a.rate.at), a.rate.radius)};
}

// Returns e^(i angle), where the angle is real.
static YkDual turn_by(YkDual angle)
{
    double at = angle.at.at.x;
    YkBall e = yk_ball(yk_unit(at), YK_BALL_OUT(angle.at.radius + 1e-15 + fabs(at) * 4e-16));
    return (YkDual){e, yk_ball_mul(yk_ball_mul(yk_ball(yk_vec(0, 1), 0), angle.rate), e)};
}

static YkDual power(YkDual z, int n)
{
    YkDual result = constant(yk_vec(1, 0)), base = n < 0 ? conjugate(z) : z; // |z| = 1
    for (int k = n < 0 ? -n : n; k > 0; k--) result = mul(result, base);
    return result;
}

static YkDual input_of(const YkDiscs *d, int32_t input)
{
    if (input == d->second) return (YkDual){d->second_input, yk_ball(yk_vec(0, 0), 0)};
    if (input != d->mapped) return constant(yk_vec(d->others[input], 0));
    return (YkDual){d->input, real_disc(1, 0)};
}

// Returns gain times the law over its argument: by the mean value theorem no farther from its middle than its slope allows.
static YkDual law_of(const YkDiscs *d, const YkRelation *r)
{
    YkLawBound bound = d->laws[r - d->mech->relations];
    YkDual x = constant(yk_vec(r->argument_offset, 0));
    for (uint32_t k = r->first_argument_source; k < r->first_argument_source + r->argument_source_count; k++)
        x = add(x, times(yk_vec(d->mech->sources[k].factor, 0), input_of(d, d->mech->sources[k].index)));
    double y[YK_LAW_ORDER + 1], rounding = 1e-14 * (1 + fabs(x.at.at.x)) * bound.slope, radius = x.at.radius;
    yk_law_eval(r->law, x.at.at.x, y);
    YkBall value = real_disc(y[0], YK_BALL_OUT(bound.slope * radius + rounding + 1e-14 * fabs(y[0])));
    double off = YK_BALL_OUT(bound.curvature * fmax(radius, 1e-14 * (1 + fabs(x.at.at.x))) + 1e-14 * bound.slope);
    YkBall slope = off < bound.slope ? real_disc(y[1], off) : real_disc(0, bound.slope);
    return times(yk_vec(r->gain, 0), (YkDual){value, yk_ball_mul(slope, x.rate)});
}

static void take_relation(YkDiscs *d, const YkRelation *r)
{
    YkDual sum = constant(yk_vec(r->offset, 0)), turn = constant(yk_vec(1, 0));
    for (uint32_t k = r->first_source; k < r->first_source + r->source_count; k++) {
        const YkRelationSource *s = &d->mech->sources[k];
        if (s->kind == YK_SOURCE_SLOT)
            turn = mul(turn, power(d->slots[s->index], (int)s->factor));
        else
            sum = add(sum, times(yk_vec(s->factor, 0),
                                 s->kind == YK_SOURCE_INPUT ? input_of(d, s->index) : d->distances[s->index]));
    }
    if (r->law) sum = add(sum, law_of(d, r));
    if (r->target.is_distance)
        d->distances[r->target.index] = sum;
    else
        d->slots[r->target.index] = mul(turn, turn_by(sum));
}

YkDual yk_discs_sum(const YkDiscs *d, const YkSum *sum)
{
    YkDual total = constant(sum->constant);
    if (sum->plus != YK_NONE) total = add(total, d->nodes[sum->plus]);
    if (sum->minus != YK_NONE) total = add(total, negate(d->nodes[sum->minus]));
    for (uint32_t k = sum->first; k < sum->first + sum->count; k++) {
        YkTerm t = d->mech->terms[k];
        YkDual v = times(t.v, d->slots[t.slot]);
        if (t.distance != YK_NONE) v = mul(v, d->distances[t.distance]);
        total = add(total, v);
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
    return times(block->line[0], d->slots[block->line_slot[0]]);
}

static YkBall real_part(YkBall a)
{
    return real_disc(a.at.x, a.radius);
}

// Finds the one unknown of a loop: known + arm z = 0, or known + line d = 0.
static void take_repeated(YkDiscs *d, const YkBlock *block)
{
    if (block->kind != YK_BLOCK_LINK) return;
    YkColumn c = block->column[0];
    YkDual away = negate(yk_discs_sum(d, &block->known));
    if (!c.is_distance) {
        d->slots[c.index] = divide(away, yk_discs_sum(d, &block->arm[0]));
        return;
    }
    YkDual along = mul(away, conjugate(line_of(d, block)));
    d->distances[c.index] = (YkDual){real_part(along.at), real_part(along.rate)};
}

YkDual yk_discs_miss(const YkDiscs *d, const YkBlock *block)
{
    YkDual known = times(yk_vec(1 / d->mech->size, 0), yk_discs_sum(d, &block->known));
    if (block->kind == YK_BLOCK_CHECK) return known;
    if (block->column[0].is_distance) {
        YkDual along = mul(known, conjugate(line_of(d, block)));
        return (YkDual){real_disc(along.at.at.y, along.at.radius), real_disc(along.rate.at.y, along.rate.radius)};
    }
    YkDual arm = times(yk_vec(1 / d->mech->size, 0), yk_discs_sum(d, &block->arm[0]));
    return add(mul(known, conjugate(known)), negate(mul(arm, conjugate(arm))));
}

void yk_discs_take(YkDiscs *d, const YkStep *step)
{
    switch (step->kind) {
    case YK_STEP_TURN: {
        YkDual angle = add(input_of(d, step->input), constant(yk_vec(step->offset, 0)));
        d->slots[step->target] = mul(d->slots[step->parent], turn_by(times(yk_vec(step->sign, 0), angle)));
        break;
    }
    case YK_STEP_COMPOSE:
        d->slots[step->target] = mul(d->slots[step->parent], d->slots[step->other]);
        break;
    case YK_STEP_DISTANCE:
        d->distances[step->target] = input_of(d, step->input);
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

// --- coefficients

static void read_dyad(const YkDiscs *d, const YkBlock *block, double per_size, YkDual row[3])
{
    YkVec scale = yk_vec(per_size, 0);
    bool slides[2] = {block->kind == YK_BLOCK_PP, block->kind != YK_BLOCK_RRR};
    for (int k = 0; k < 2; k++) {
        int line = block->kind == YK_BLOCK_PP ? k : 0;
        row[k] = slides[k] ? times(block->line[line], d->slots[block->line_slot[line]])
                           : times(scale, yk_discs_sum(d, &block->arm[k]));
    }
    row[2] = times(scale, yk_discs_sum(d, &block->known));
}

static int find(const YkMechanism *mech, const YkPiece *piece, bool is_distance, int32_t index)
{
    const YkBlock *block = &mech->blocks[piece->block];
    for (size_t k = 0; k < piece->shape.unknowns; k++) {
        YkColumn c = mech->group_columns[block->first_column + piece->shape.column[k]];
        if (c.is_distance == is_distance && c.index == index) return (int)k;
    }
    return -1;
}

static void read_loop(const YkPiece *piece, const YkDiscs *d, const YkSum *sum, YkDual *row)
{
    const YkMechanism *mech = d->mech;
    YkSum known = *sum;
    YkVec scale = yk_vec(1 / mech->size, 0);
    known.count = 0;
    for (size_t k = 0; k < piece->shape.unknowns; k++) row[k] = constant(yk_vec(0, 0));
    row[piece->shape.unknowns] = times(scale, yk_discs_sum(d, &known));
    for (uint32_t k = sum->first; k < sum->first + sum->count; k++) {
        YkTerm t = mech->terms[k];
        int angle = t.slot == 0 ? -1 : find(mech, piece, false, mech->group_root[t.slot]);
        int slide = t.distance == YK_NONE ? -1 : find(mech, piece, true, t.distance);
        YkDual v = times(t.v, d->slots[angle >= 0 ? mech->relative_slot[t.slot] : t.slot]);
        if (slide < 0) v = times(scale, v); // an unknown distance counts sizes, so its direction has no length
        if (slide < 0 && t.distance != YK_NONE) v = mul(v, d->distances[t.distance]);
        size_t column = slide >= 0 ? (size_t)slide : angle >= 0 ? (size_t)angle : piece->shape.unknowns;
        row[column] = add(row[column], v);
    }
}

void yk_piece_coefficients(const YkPiece *piece, const YkDiscs *d, YkDiscCoefficients *out)
{
    const YkBlock *block = &d->mech->blocks[piece->block];
    size_t n = piece->shape.unknowns, width = n + 1, half = yk_coefficient_count(&piece->shape);
    YkDual row[YK_PIECE_UNKNOWNS + 1];
    for (size_t l = 0; l < piece->shape.loops; l++) {
        if (block->kind == YK_BLOCK_GROUP)
            read_loop(piece, d, &d->mech->group_loops[block->first_loop + l], row);
        else
            read_dyad(d, block, 1 / d->mech->size, row);
        for (size_t k = 0; k < width; k++) {
            size_t at = l * width + k;
            YkBall v = row[k].at, rate = row[k].rate;
            bool is_absent = k < n && v.at.x == 0 && v.at.y == 0 && v.radius < 1e-200;
            out->at[at] = v.at;
            out->rate[at] = rate.at;
            out->radius[at] = out->radius[half + at] = is_absent ? 0 : YK_BALL_OUT(v.radius + YK_COEFFICIENT_ERROR);
            out->rate_radius[at] = out->rate_radius[half + at] =
                is_absent ? 0 : YK_BALL_OUT(rate.radius + YK_COEFFICIENT_ERROR);
            out->at[half + at] = yk_conj(v.at);
            out->rate[half + at] = yk_conj(rate.at);
        }
    }
}

void yk_discs_place(YkDiscs *d, const YkPiece *piece, const YkDual *x)
{
    const YkBlock *block = &d->mech->blocks[piece->block];
    bool is_group = block->kind == YK_BLOCK_GROUP;
    for (size_t k = 0; k < piece->shape.unknowns; k++) {
        YkColumn c = is_group ? d->mech->group_columns[block->first_column + piece->shape.column[k]] : block->column[k];
        if (k < piece->shape.angles)
            d->slots[c.index] = x[k];
        else
            d->distances[c.index] = times(yk_vec(d->mech->size, 0), x[k]);
    }
}
