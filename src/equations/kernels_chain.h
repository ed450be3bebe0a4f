// Short chains of pins over lanes: the equations of motion in absolute rates, in one pass.
#ifndef EQUATIONS_KERNELS_CHAIN_H
#define EQUATIONS_KERNELS_CHAIN_H
#include "elementary/elementary.h"
#include "elementary/turn.h"
#include "equations/kernels_tree.h"
#include "equations/short_chain.h"

// A vector of a link's own axes: where all lie along one axis of theirs, its length along it is enough.
YK_INLINE YkVec chain_given(const YkTreeRows *rows, int x, YkAxis axis, size_t lane)
{
    return yk_vec(axis == YK_AXIS_Y ? 0 : rows->sign[x] * rows->given[x][lane],
                  axis == YK_AXIS_X ? 0 : rows->sign[x + 1] * rows->given[x + 1][lane]);
}

YK_INLINE double chain_dot(YkVec a, YkVec b, YkAxis axis)
{
    return axis == YK_AXIS_NONE ? yk_dot(a, b) : axis == YK_AXIS_X ? a.x * b.x : a.y * b.y;
}

// Returns v turned into world axes.
YK_INLINE YkVec chain_turned(YkVec e, YkVec v, YkAxis axis)
{
    if (axis == YK_AXIS_X) return yk_vec(e.x * v.x, e.y * v.x);
    return axis == YK_AXIS_Y ? yk_vec(-e.y * v.y, e.x * v.y) : yk_mul(e, v);
}

// Finds turn, direction and squared rate of turning of all links. is_far: whether an angle may be beyond the range of
// the near reduction; otherwise its bits are added to `far`.
YK_INLINE void chain_turn(ChainLink *link, const YkTreeRows *rows, size_t links, bool is_far, uint64_t *far,
                          size_t lane)
{
    double w = 0;
#pragma GCC unroll 4
    for (size_t k = 0; k < links; k++) {
        double angle = rows[k].sense * rows[k].q[lane];
        YkVec e;
        if (is_far)
            yk_sincos(angle, &e.y, &e.x);
        else
            sincos_near(angle, &e.y, &e.x);
        *far |= sincos_far_bits(angle);
        link[k].turn = e;
        link[k].e = k > 0 ? yk_mul(link[k - 1].e, e) : e;
        w = k > 0 ? w + rows[k].sense * rows[k].v[lane] : rows[k].sense * rows[k].v[lane];
        link[k].square = w * w;
    }
}

YK_INLINE double chain_torque(const YkTreeRows *rows, size_t lane)
{
    return rows->sense * rows->torque[lane];
}

// Finds the link's own part of the equations; next: the link after it, or NULL. is_plain: gravity acts along y alone.
// Returns whether its mass is possible.
YK_INLINE bool chain_link(ChainLink *own, const ChainLink *next, const YkTreeRows *rows, YkAxis axis, bool is_plain,
                          YkVec gravity, size_t lane)
{
    const double *const *given = rows->given;
    YkVec center = chain_given(rows, YK_GIVEN_CENTER_X, axis, lane);
    double mass = given[YK_GIVEN_MASS][lane], inertia = given[YK_GIVEN_INERTIA][lane];
    YkVec moment = yk_scale(mass, center);
    own->behind = inertia + chain_dot(moment, center, axis);
    own->mass_out = mass;
    own->effort = chain_torque(rows, lane);
    if (next) {
        YkVec at = chain_given(rows + 1, YK_GIVEN_AT_X, axis, lane);
        YkVec carried = yk_scale(next->mass_out, at);
        moment = yk_add(moment, carried);
        own->behind += chain_dot(carried, at, axis);
        own->mass_out += next->mass_out;
        own->effort -= chain_torque(rows + 1, lane);
        own->end = chain_turned(own->e, at, axis);
    }
    own->along = axis == YK_AXIS_Y ? moment.y : moment.x;
    own->moment = chain_turned(own->e, moment, axis);
    own->effort += is_plain ? own->moment.x * gravity.y : yk_cross(own->moment, gravity);
    return (mass > (rows->has_mass ? 0 : -1)) & (inertia >= 0);
}

// Couples a link to the one before it: where both lie along one axis of theirs, by the joint's own turn.
YK_INLINE void chain_couple_link(ChainLink *own, const ChainLink *before, const YkTreeRows *rows, YkAxis axis,
                                 size_t lane)
{
    YkVec at = chain_given(rows, YK_GIVEN_AT_X, axis, lane);
    if (axis == YK_AXIS_NONE)
        own->couple = chain_couple_of(before->end, own->moment);
    else
        own->couple = yk_scale((axis == YK_AXIS_Y ? at.y : at.x) * own->along, own->turn);
}

// Writes the coordinates' accelerations. Returns whether all are finite.
YK_INLINE bool chain_write(const ChainLink *link, size_t links, const YkTreeRows *rows, size_t lane)
{
    bool is_finite = true;
#pragma GCC unroll 4
    for (size_t d = 0; d < links; d++) {
        double found = rows[d].sense * (d > 0 ? link[d].alpha - link[d - 1].alpha : link[d].alpha);
        is_finite &= found - found == 0;
        rows[d].a[lane] = found;
    }
    return is_finite;
}

// The cases for which a pass over lanes must be prepared.
typedef enum ChainCare {
    CHAIN_NEAR, // angles within the range of the near reduction
    CHAIN_FAR,  // any angle
    CHAIN_LINKS // any angle and any inertia: two links are solved one by one, too
} ChainCare;

// Computes the accelerations of the states from `from` on, before `to`; ok: as yk_lanes_tree has it. *bad: whether one
// is not 1. Returns bits that are set if an angle is far: then all must be repeated with that care. is_plain:
// tree->side is not 0. All signs of vectors are then left out, which occur in pairs but for that of gravity's moment.
YK_INLINE uint64_t chain_lanes(const YkTreeLanes *tree, size_t links, YkAxis axis, bool is_plain, ChainCare care,
                               double *ok, bool *bad, size_t from, size_t to)
{
    const double *gx = tree->gravity[0], *gy = tree->gravity[1];
    const double side = tree->side;
    uint64_t far = 0, wrong = 0;
    YkTreeRows rows[YK_CHAIN_MOST]; // a copy, over which no row of results can lie
    for (size_t k = 0; k < links; k++) {
        rows[k] = tree->link[k];
        for (size_t i = 0; is_plain && i < YK_GIVEN_MASS; i++) rows[k].sign[i] = 1;
        if (is_plain) rows[k].sense = 1;
    }
    YK_EACH_LANE
    for (size_t i = from; i < to; i++) {
        ChainLink link[YK_CHAIN_MOST];
        YkVec gravity = is_plain ? yk_vec(0, side * gy[i]) : yk_vec(gx[i], gy[i]);
        bool is_possible = ok[i] >= 0;
        chain_turn(link, rows, links, care != CHAIN_NEAR, &far, i);
#pragma GCC unroll 4
        for (size_t k = links; k-- > 0;)
            is_possible &=
                chain_link(&link[k], k + 1 < links ? &link[k + 1] : NULL, &rows[k], axis, is_plain, gravity, i);
#pragma GCC unroll 4
        for (size_t k = 1; k < links; k++) chain_couple_link(&link[k], &link[k - 1], &rows[k], axis, i);
        chain_couple(link, links);
        bool is_quick = links == 2 && care != CHAIN_LINKS;
        bool resists = is_quick ? chain_solve_two(&link[0], &link[1]) : chain_solve(link, links);
        resists &= chain_write(link, links, rows, i);
        ok[i] = is_possible ? (resists ? 1 : 0) : -1;
        wrong |= 1 ^ (uint64_t)(is_possible & resists);
    }
    *bad = wrong != 0;
    return far;
}

// Chooses the copy for a chain: the most common ones know that their links are straight.
YK_INLINE uint64_t chain_choose(const YkTreeLanes *tree, ChainCare care, double *ok, bool *bad, size_t n)
{
    bool is_plain = YK_KNOWS_BLOCKS && care == CHAIN_NEAR && tree->side != 0, has_two = tree->link_count == 2;
    if (tree->link_count == 1) return chain_lanes(tree, 1, YK_AXIS_NONE, false, care, ok, bad, 0, n);
    if (is_plain && tree->axis == YK_AXIS_X) return chain_lanes(tree, 2, YK_AXIS_X, true, care, ok, bad, 0, n);
    if (is_plain) return chain_lanes(tree, 2, YK_AXIS_Y, true, care, ok, bad, 0, n);
    if (has_two && tree->axis == YK_AXIS_X) return chain_lanes(tree, 2, YK_AXIS_X, false, care, ok, bad, 0, n);
    if (has_two && tree->axis == YK_AXIS_Y) return chain_lanes(tree, 2, YK_AXIS_Y, false, care, ok, bad, 0, n);
    if (has_two) return chain_lanes(tree, 2, YK_AXIS_NONE, false, care, ok, bad, 0, n);
    return chain_lanes(tree, 3, YK_AXIS_NONE, false, care, ok, bad, 0, n);
}

#endif
