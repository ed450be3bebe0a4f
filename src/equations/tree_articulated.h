// Articulated inertia of the plane: how a subtree resists acceleration at a point once its joints have been released.
//
// For an acceleration a of the point and an angular acceleration alpha of the link it requires at the point
// force = M a + h alpha + f, moment = J alpha + h . a + n.
// Featherstone 1983, "The calculation of robot dynamics using articulated-body inertias"; after a pin, J and h are 0.
#ifndef EQUATIONS_TREE_ARTICULATED_H
#define EQUATIONS_TREE_ARTICULATED_H
#include <stdbool.h>
#include "base/vec.h"

typedef struct YkArticulated {
    double J;
    YkVec h;
    double xx, xy, yy; // M
    YkVec f;
    double n;
} YkArticulated;

// A joint's acceleration, given those of its point: by - on . (alpha, a).
typedef struct YkAnswer {
    double by, turn;
    YkVec on;
} YkAnswer;

static inline YkVec yk_articulated_times(const YkArticulated *A, YkVec v)
{
    return yk_vec(A->xx * v.x + A->xy * v.y, A->xy * v.x + A->yy * v.y);
}

// Adds a rigid body: mass, mass * (centre - point) in world axes, inertia about the point, rate of turning.
static inline void yk_articulated_add_body(YkArticulated *A, double mass, YkVec moment, double inertia, double w)
{
    A->J += inertia;
    A->h = yk_add(A->h, yk_quarter(moment));
    A->xx += mass;
    A->yy += mass;
    A->f = yk_sub(A->f, yk_scale(w * w, moment));
}

static inline void yk_articulated_add(YkArticulated *A, const YkArticulated *b)
{
    A->J += b->J;
    A->h = yk_add(A->h, b->h);
    A->xx += b->xx;
    A->xy += b->xy;
    A->yy += b->yy;
    A->f = yk_add(A->f, b->f);
    A->n += b->n;
}

// Releases the rotation under a known moment: the point then requires only a force, and the moment. J must not be 0.
static inline YkAnswer yk_articulated_release_turn(YkArticulated *A, double moment)
{
    double over = 1 / A->J;
    YkVec h = A->h, on = yk_scale(over, h);
    double by = (moment - A->n) * over;
    A->xx -= h.x * h.x * over;
    A->xy -= h.x * h.y * over;
    A->yy -= h.y * h.y * over;
    A->f = yk_add(A->f, yk_scale(by, h));
    A->J = 0;
    A->h = yk_vec(0, 0);
    A->n = moment;
    return (YkAnswer){.by = by, .on = on};
}

// Releases the sliding along a unit vector under a known force along it. The pivot line . M line must not be 0.
static inline YkAnswer yk_articulated_release_slide(YkArticulated *A, YkVec line, double force)
{
    YkVec on = yk_articulated_times(A, line);
    double turn = yk_dot(A->h, line), over = 1 / yk_dot(line, on), by = (force - yk_dot(line, A->f)) * over;
    A->J -= turn * turn * over;
    A->h = yk_sub(A->h, yk_scale(turn * over, on));
    A->xx -= on.x * on.x * over;
    A->xy -= on.x * on.y * over;
    A->yy -= on.y * on.y * over;
    A->f = yk_add(A->f, yk_scale(by, on));
    A->n += by * turn;
    return (YkAnswer){.by = by, .turn = turn * over, .on = yk_scale(over, on)};
}

// Moves everything to another point of the rigid parent, `arm` back from here.
static inline YkArticulated yk_articulated_move(const YkArticulated *A, YkVec arm)
{
    YkVec across = yk_quarter(arm), q = yk_articulated_times(A, across);
    double J = A->J + 2 * yk_dot(A->h, across) + yk_dot(across, q);
    return (YkArticulated){J, yk_add(A->h, q), A->xx, A->xy, A->yy, A->f, A->n + yk_dot(across, A->f)};
}

// Moves the force to another point of the rigid parent, `arm` back from here: J and h are 0 here (a pin). bias: how
// much this point accelerates beyond a + alpha x arm of the parent's point.
static inline YkArticulated yk_articulated_move_force(const YkArticulated *A, YkVec arm, YkVec bias)
{
    YkVec across = yk_quarter(arm), q = yk_articulated_times(A, across);
    YkVec f = yk_add(A->f, yk_articulated_times(A, bias));
    double J = (across.x * across.x * A->xx + across.y * across.y * A->yy) + 2 * (across.x * across.y) * A->xy;
    return (YkArticulated){J, q, A->xx, A->xy, A->yy, f, A->n + yk_dot(across, f)};
}

#endif
