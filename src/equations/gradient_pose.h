// Gradients of sums in numbers, at a pose of one lane: the columns are i u for rotations, u for slides.
#ifndef EQUATIONS_GRADIENT_POSE_H
#define EQUATIONS_GRADIENT_POSE_H
#include "base/memory.h"
#include "equations/elimination.h"
#include "solve/space.h"

// Returns the lanes of one pose, which are contiguous: cos, sin, rate, acceleration.
static inline const double *yk_turn_at(const YkSpace *space, int32_t slot)
{
    return space->data + 4 * slot;
}

static inline YkVec yk_turned_by(const double *turn, YkVec v)
{
    return yk_vec(turn[0] * v.x - turn[1] * v.y, turn[0] * v.y + turn[1] * v.x);
}

static inline void yk_add_to_column(YkVec *columns, int32_t column, double k, YkVec v)
{
    if (column == YK_NONE) return;
    columns[column].x += k * v.x;
    columns[column].y += k * v.y;
}

static inline void yk_add_piece(const YkSpace *space, const YkGradientPiece *piece, YkVec *columns)
{
    YkVec u = piece->slot ? yk_turned_by(yk_turn_at(space, piece->slot), piece->v) : piece->v;
    if (piece->root) u = yk_turned_by(yk_turn_at(space, piece->root), u);
    YkVec iu = yk_quarter(u);
    double d = 1;
    if (piece->distance != YK_NONE) {
        d = yk_space_slide(space, piece->distance).d[0];
        yk_add_to_column(columns, piece->along, 1, u);
    }
    yk_add_to_column(columns, piece->turn[0], d, iu);
    yk_add_to_column(columns, piece->turn[1], d, iu);
}

// Computes the gradient's columns[gradient->columns].
static inline void yk_gradient_columns(const YkElimination *e, const YkSpace *space, const YkGradient *gradient,
                                       YkVec *columns)
{
    const YkGradientPiece *piece = yk_from(e->pieces, gradient->first_piece);
    if (gradient->is_plain) {
        for (uint32_t k = 0; k < gradient->columns; k++)
            columns[k] = yk_quarter(yk_turned_by(yk_turn_at(space, piece[k].unit), piece[k].v));
        return;
    }
    for (uint32_t k = 0; k < gradient->columns; k++) columns[k] = yk_vec(0, 0);
    for (uint32_t k = 0; k < gradient->node_count; k++) {
        const YkNodePart *part = &e->nodes[gradient->first_node + k];
        columns[part->column].x += part->sign;
        columns[part->column + 1].y += part->sign;
    }
    for (uint32_t k = 0; k < gradient->piece_count; k++) yk_add_piece(space, &piece[k], columns);
}

// Computes what a piece of a point adds to its gradient and, in the pose, to its acceleration.
static inline YkVec yk_piece_acceleration(const YkSpace *space, const YkGradientPiece *piece, YkVec *columns)
{
    YkVec u = piece->v;
    double w = 0, a = 0, d = 1;
    if (piece->slot) {
        const double *t = yk_turn_at(space, piece->slot);
        u = yk_turned_by(t, u);
        w = t[2], a = t[3];
    }
    YkVec iu = yk_quarter(u);
    double along = -w * w, across = a;
    if (piece->distance != YK_NONE) {
        YkSlide s = yk_space_slide(space, piece->distance);
        d = s.d[0];
        along = s.a[0] - d * w * w;
        across = d * a + 2 * s.v[0] * w;
        yk_add_to_column(columns, piece->along, 1, u);
    }
    yk_add_to_column(columns, piece->turn[1], d, iu);
    return yk_vec(along * u.x + across * iu.x, along * u.y + across * iu.y);
}

// Computes the gradient of a body's reference point, and returns its acceleration in the pose.
static inline YkVec yk_gradient_acceleration(const YkElimination *e, const YkSpace *space, const YkGradient *gradient,
                                             YkVec *columns)
{
    YkVec sum = {0, 0};
    const YkGradientPiece *piece = yk_from(e->pieces, gradient->first_piece);
    if (gradient->is_plain) {
        for (uint32_t k = 0; k < gradient->columns; k++) {
            const double *t = yk_turn_at(space, piece[k].unit);
            YkVec u = yk_turned_by(t, piece[k].v), iu = yk_quarter(u);
            double w2 = t[2] * t[2];
            columns[k] = iu;
            sum.x += t[3] * iu.x - w2 * u.x;
            sum.y += t[3] * iu.y - w2 * u.y;
        }
        return sum;
    }
    for (uint32_t k = 0; k < gradient->columns; k++) columns[k] = yk_vec(0, 0);
    for (uint32_t k = 0; k < gradient->node_count; k++) {
        const YkNodePart *part = &e->nodes[gradient->first_node + k];
        YkPlane p = yk_space_plane(space, part->node);
        columns[part->column].x += part->sign;
        columns[part->column + 1].y += part->sign;
        sum = yk_add(sum, yk_scale(part->sign, yk_vec(p.ax[0], p.ay[0])));
    }
    for (uint32_t k = 0; k < gradient->piece_count; k++)
        sum = yk_add(sum, yk_piece_acceleration(space, &piece[k], columns));
    return sum;
}

#endif
