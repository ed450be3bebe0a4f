// Reads blocks as systems whose coefficients are discs.
#include "map/piece.h"
#include "configurations/certify.h"
#include "map/meshed.h"

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
    *piece = (YkPiece){.block = (size_t)mech->steps[step].target, .step = step, .relation = YK_NONE};
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
    return yk_unknown_size(&piece->shape, x, unknown);
}

YkVec yk_piece_off(const YkPiece *piece, const YkVec *x, const YkVec *y, size_t unknown)
{
    YkVec off = yk_sub(x[unknown], y[unknown]);
    if (piece->shape.relations > 0 && unknown < piece->shape.angles) off.x = yk_nearest_turn(off.x, 0);
    return off;
}

// --- coefficients

static void read_dyad(const YkDiscs *d, const YkBlock *block, double per_size, YkDual row[3])
{
    YkVec scale = yk_vec(per_size, 0);
    bool slides[2] = {block->kind == YK_BLOCK_PP, block->kind != YK_BLOCK_RRR};
    for (int k = 0; k < 2; k++) {
        int line = block->kind == YK_BLOCK_PP ? k : 0;
        row[k] = slides[k] ? yk_dual_times(block->line[line], d->slots[block->line_slot[line]])
                           : yk_dual_times(scale, yk_discs_sum(d, &block->aside->arm[k]));
    }
    row[2] = yk_dual_times(scale, yk_discs_sum(d, &block->known));
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
    for (size_t k = 0; k < piece->shape.unknowns; k++) row[k] = yk_dual_constant(yk_vec(0, 0));
    row[piece->shape.unknowns] = yk_dual_times(scale, yk_discs_sum(d, &known));
    for (uint32_t k = sum->first; k < sum->first + sum->count; k++) {
        YkTerm t = mech->terms[k];
        int angle = t.slot == 0 ? -1 : find(mech, piece, false, mech->group_root[t.slot]);
        int slide = t.distance == YK_NONE ? -1 : find(mech, piece, true, t.distance);
        YkDual v = yk_dual_times(t.v, d->slots[angle >= 0 ? mech->relative_slot[t.slot] : t.slot]);
        if (slide < 0) v = yk_dual_times(scale, v); // an unknown distance counts sizes, so its direction has no length
        if (slide < 0 && t.distance != YK_NONE) v = yk_dual_mul(v, d->distances[t.distance]);
        size_t column = slide >= 0 ? (size_t)slide : angle >= 0 ? (size_t)angle : piece->shape.unknowns;
        row[column] = yk_dual_add(row[column], v);
    }
}

static void write_coefficient(YkDiscCoefficients *out, size_t at, YkDual v, bool is_absent)
{
    out->at[at] = v.at.at;
    out->rate[at] = v.rate.at;
    out->radius[at] = is_absent ? 0 : YK_BALL_OUT(v.at.radius + YK_COEFFICIENT_ERROR);
    out->rate_radius[at] = is_absent ? 0 : YK_BALL_OUT(v.rate.radius + YK_COEFFICIENT_ERROR);
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
            YkBall v = row[k].at;
            bool is_absent = k < n && v.at.x == 0 && v.at.y == 0 && v.radius < 1e-200;
            write_coefficient(out, at, row[k], is_absent);
            write_coefficient(out, half + at, yk_dual_conjugate(row[k]), is_absent);
        }
    }
    for (size_t r = 0; r < piece->shape.relations; r++) {
        yk_meshed_row(piece->meshed, d, r, row);
        for (size_t k = 0; k < width; k++)
            write_coefficient(out, 2 * half + r * width + k, row[k], k < n && row[k].at.at.x == 0);
    }
}

void yk_discs_place(YkDiscs *d, const YkPiece *piece, const YkDual *x)
{
    const YkBlock *block = &d->mech->blocks[piece->block];
    bool is_group = piece->relation == YK_NONE && block->kind == YK_BLOCK_GROUP;
    for (size_t k = 0; k < piece->shape.unknowns; k++) {
        YkColumn c = piece->relation != YK_NONE ? (YkColumn){false, d->mech->relations[piece->relation].target.index}
                     : is_group                 ? d->mech->group_columns[block->first_column + piece->shape.column[k]]
                                                : block->column[k];
        if (k < piece->shape.angles)
            d->slots[c.index] = piece->shape.relations > 0 ? yk_dual_turn(x[k]) : x[k];
        else
            d->distances[c.index] = yk_dual_times(yk_vec(d->mech->size, 0), x[k]);
    }
}
