// Short chains of pins: the equations of motion in absolute rates, for one state or a lane.
//
// The reduction of a dense symmetric matrix of a few rows costs less than articulated inertias, and its entries stay in
// registers. Eliminated from the last link on, its pivots are the articulated inertias about the pins, and its diagonal
// holds the inertias behind them. Featherstone 2008, "Rigid Body Dynamics Algorithms", ch. 6.
#ifndef EQUATIONS_SHORT_CHAIN_H
#define EQUATIONS_SHORT_CHAIN_H
#include "elementary/kernel.h"
#include "equations/tree_articulated.h"

// A pivot does not count as inertia unless it exceeds this part of the inertia behind it, times what was lost there.
#define YK_LEAST_PIVOT 1e-14

enum { YK_CHAIN_MOST = 3 }; // links of a short chain, each on the one before

// A link. behind: moments of inertia of it and of the masses that its end carries. lost: how many times rounding grew
// in the links behind it, whose pivots are that much less than the inertias there.
typedef struct ChainLink {
    YkVec e, moment, end; // world axes: direction, first moment of it and of what it carries, vector to the next pin
    YkVec turn;           // of its joint
    YkVec couple;         // end . moment and end x moment, of the end of the link before it
    double along;         // the first moment, where it lies along an axis of the link's own
    double square, mass_out, behind, effort, row[YK_CHAIN_MOST], lost, over, alpha;
} ChainLink;

// Returns how a link's moment couples it to one that ends before it.
YK_INLINE YkVec chain_couple_of(YkVec end, YkVec moment)
{
    return yk_vec(yk_dot(end, moment), yk_cross(end, moment));
}

// Couples the links: moments of inertia and centrifugal moments.
YK_INLINE void chain_couple(ChainLink *link, size_t links)
{
#pragma GCC unroll 4
    for (size_t d = 0; d < links; d++) {
        link[d].row[d] = link[d].behind;
#pragma GCC unroll 4
        for (size_t k = 0; k < d; k++) {
            YkVec couple = k + 1 == d ? link[d].couple : chain_couple_of(link[k].end, link[d].moment);
            link[d].row[k] = couple.x;
            link[d].effort -= link[k].square * couple.y;
            link[k].effort += link[d].square * couple.y;
        }
    }
}

// Returns whether inertia resists the turning of a link, once those behind it are eliminated: more than rounding.
YK_INLINE bool chain_resists(const ChainLink *link, size_t d)
{
    return link[d].row[d] > YK_LEAST_PIVOT * link[d].behind * link[d].lost;
}

// Eliminates the links from the last one on. Returns whether inertia resists each.
YK_INLINE bool chain_eliminate(ChainLink *link, size_t links)
{
    bool resists = true;
    double lost = 1;
#pragma GCC unroll 4
    for (size_t d = links; d-- > 0;) {
        ChainLink *own = &link[d];
        own->lost = lost;
        resists &= chain_resists(link, d);
        own->over = 1 / own->row[d];
        lost *= own->behind * own->over;
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

// Solves for two links by their determinant, with one division. Returns false if inertia does not resist each of them,
// or if the product of their inertias may be no number: chain_solve finds which, since all rows are left as they are.
YK_INLINE bool chain_solve_two(ChainLink *first, ChainLink *second)
{
    const double least = 1e-290, most = 1e290;
    double own = first->row[0], other = second->row[1], shared = second->row[0];
    double both = own * other, determinant = both - shared * shared, over = 1 / determinant;
    first->alpha = (other * first->effort - shared * second->effort) * over;
    second->alpha = (own * second->effort - shared * first->effort) * over;
    return (determinant > YK_LEAST_PIVOT * both + least) & (both < most);
}

// Computes the absolute angular accelerations, link by link. Returns whether inertia resists each.
YK_INLINE bool chain_solve(ChainLink *link, size_t links)
{
    bool resists = chain_eliminate(link, links);
#pragma GCC unroll 4
    for (size_t d = 0; d < links; d++) {
        double effort = link[d].effort;
#pragma GCC unroll 4
        for (size_t k = 0; k < d; k++) effort -= link[d].row[k] * link[k].alpha;
        link[d].alpha = effort * link[d].over;
    }
    return resists;
}

#endif
