// Short chains of pins over lanes: the equations of motion in absolute rates, in one pass.
//
// The reduction of a dense symmetric matrix of a few rows costs less than articulated inertias, and its entries stay in
// registers. Eliminated from the last link on, its pivots are the articulated inertias about the pins, and its diagonal
// holds the inertias behind them. Featherstone 2008, "Rigid Body Dynamics Algorithms", ch. 6.
#ifndef EQUATIONS_KERNELS_CHAIN_H
#define EQUATIONS_KERNELS_CHAIN_H
#include "elementary/elementary.h"
#include "elementary/turn.h"
#include "equations/kernels_tree.h"
#include "equations/tree_articulated.h"

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

// A link in one lane. behind: moments of inertia of it and of the masses that its end carries.
typedef struct ChainLink {
    YkVec e, moment, end; // world axes: direction, first moment of it and of what it carries, vector to the next pin
    double square, mass_out, behind, effort, row[YK_CHAIN_MOST], over, alpha;
} ChainLink;

// Finds direction and squared rate of turning of all links. is_far: whether an angle may be beyond the reduction's near
// range; otherwise its bits are added to `far`.
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
        link[k].e = k > 0 ? yk_mul(link[k - 1].e, e) : e;
        w = k > 0 ? w + rows[k].sense * rows[k].v[lane] : rows[k].sense * rows[k].v[lane];
        link[k].square = w * w;
    }
}

YK_INLINE double chain_torque(const YkTreeRows *rows, size_t lane)
{
    return rows->sense * rows->torque[lane];
}

// Finds the link's own part of the equations; next: the link after it, or NULL. Returns whether its mass is possible.
YK_INLINE bool chain_link(ChainLink *own, const ChainLink *next, const YkTreeRows *rows, YkAxis axis, YkVec gravity,
                          size_t lane)
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
    own->moment = chain_turned(own->e, moment, axis);
    own->effort += yk_cross(own->moment, gravity);
    return (mass > (rows->has_mass ? 0 : -1)) & (inertia >= 0);
}

// Couples the links: moments of inertia and centrifugal moments.
YK_INLINE void chain_couple(ChainLink *link, size_t links)
{
#pragma GCC unroll 4
    for (size_t d = 0; d < links; d++) {
        link[d].row[d] = link[d].behind;
#pragma GCC unroll 4
        for (size_t k = 0; k < d; k++) {
            double moment = yk_cross(link[k].end, link[d].moment);
            link[d].row[k] = yk_dot(link[k].end, link[d].moment);
            link[d].effort -= link[k].square * moment;
            link[k].effort += link[d].square * moment;
        }
    }
}

// Eliminates the links from the last one on. Returns whether inertia resists each.
YK_INLINE bool chain_eliminate(ChainLink *link, size_t links)
{
    bool resists = true;
#pragma GCC unroll 4
    for (size_t d = links; d-- > 0;) {
        ChainLink *own = &link[d];
        resists &= own->row[d] > YK_LEAST_PIVOT * own->behind;
        own->over = 1 / own->row[d];
#pragma GCC unroll 4
        for (size_t k = 0; k < d; k++) {
            double part = own->row[k] * own->over;
            link[k].effort -= part * own->effort;
#pragma GCC unroll 4
            for (size_t j = 0; j <= k; j++) link[k].row[j] -= part * own->row[j];
        }
    }
    return resists;
}

// Computes the coordinates' accelerations. Returns whether all are finite.
YK_INLINE bool chain_solve(ChainLink *link, size_t links, const YkTreeRows *rows, size_t lane)
{
    bool is_finite = true;
#pragma GCC unroll 4
    for (size_t d = 0; d < links; d++) {
        double effort = link[d].effort;
#pragma GCC unroll 4
        for (size_t k = 0; k < d; k++) effort -= link[d].row[k] * link[k].alpha;
        link[d].alpha = effort * link[d].over;
        double found = rows[d].sense * (d > 0 ? link[d].alpha - link[d - 1].alpha : link[d].alpha);
        is_finite &= found - found == 0;
        rows[d].a[lane] = found;
    }
    return is_finite;
}

// Computes the accelerations of n states; ok: as yk_lanes_tree has it. *bad: whether one is not 1. Returns the bits
// that tell whether an angle is far: then all must be repeated with is_far.
YK_INLINE uint64_t chain_lanes(const YkTreeLanes *tree, size_t links, YkAxis axis, bool is_far, double *ok, bool *bad,
                               size_t n)
{
    const YkTreeRows *rows = tree->link;
    const double *gx = tree->gravity[0], *gy = tree->gravity[1];
    uint64_t far = 0, wrong = 0;
    YK_EACH_LANE
    for (size_t i = 0; i < n; i++) {
        ChainLink link[YK_CHAIN_MOST];
        YkVec gravity = yk_vec(gx[i], gy[i]);
        bool is_possible = ok[i] >= 0;
        chain_turn(link, rows, links, is_far, &far, i);
#pragma GCC unroll 4
        for (size_t k = links; k-- > 0;)
            is_possible &= chain_link(&link[k], k + 1 < links ? &link[k + 1] : NULL, &rows[k], axis, gravity, i);
        chain_couple(link, links);
        bool resists = chain_eliminate(link, links);
        resists &= chain_solve(link, links, rows, i);
        ok[i] = is_possible ? (resists ? 1 : 0) : -1;
        wrong |= (is_possible & resists) ? 0u : 1u;
    }
    *bad = wrong != 0;
    return far;
}

// Chooses the copy for a chain: the most common ones know that their links are straight.
YK_INLINE uint64_t chain_choose(const YkTreeLanes *tree, bool is_far, double *ok, bool *bad, size_t n)
{
    if (tree->link_count == 1) return chain_lanes(tree, 1, YK_AXIS_NONE, is_far, ok, bad, n);
    if (tree->link_count == 2 && tree->axis == YK_AXIS_X) return chain_lanes(tree, 2, YK_AXIS_X, is_far, ok, bad, n);
    if (tree->link_count == 2 && tree->axis == YK_AXIS_Y) return chain_lanes(tree, 2, YK_AXIS_Y, is_far, ok, bad, n);
    if (tree->link_count == 2) return chain_lanes(tree, 2, YK_AXIS_NONE, is_far, ok, bad, n);
    return chain_lanes(tree, 3, YK_AXIS_NONE, is_far, ok, bad, n);
}

#endif
