// Articulated inertia of the plane: how a subtree resists acceleration at a point once its joints have been released.
//
// For an acceleration a of the point and an angular acceleration alpha of the link it requires at the point
// force = M a + h alpha + f, moment = J alpha + h . a + n.
// Featherstone 1983, "The calculation of robot dynamics using articulated-body inertias"; after a pin, J and h are 0.
#ifndef EQUATIONS_TREE_ARTICULATED_H
#define EQUATIONS_TREE_ARTICULATED_H
#include <stdbool.h>
#include "base/vec.h"

typedef struct YkInertia {
    double J;
    YkVec h;
    double xx, xy, yy; // M
} YkInertia;

typedef struct YkArticulated {
    YkInertia of;
    YkVec f;
    double n;
} YkArticulated;

// A joint's acceleration, given those of its point: by - on . (alpha, a).
typedef struct YkAnswer {
    double by, turn;
    YkVec on;
} YkAnswer;

// Returns M v.
static inline YkVec yk_inertia_times(const YkInertia *I, YkVec v)
{
    return yk_vec(I->xx * v.x + I->xy * v.y, I->xy * v.x + I->yy * v.y);
}

static inline void yk_inertia_add(YkInertia *I, const YkInertia *b)
{
    I->J += b->J;
    I->h = yk_add(I->h, b->h);
    I->xx += b->xx;
    I->xy += b->xy;
    I->yy += b->yy;
}

// Returns the trace of M.
static inline double yk_inertia_trace(const YkInertia *I)
{
    return I->xx + I->yy;
}

// Adds a rigid body: mass, mass * (centre - point) in world axes, inertia about the point, rate of turning.
static inline void yk_articulated_add_body(YkArticulated *A, double mass, YkVec moment, double inertia, double w)
{
    A->of.J += inertia;
    A->of.h = yk_add(A->of.h, yk_quarter(moment));
    A->of.xx += mass;
    A->of.yy += mass;
    A->f = yk_sub(A->f, yk_scale(w * w, moment));
}

static inline void yk_articulated_add(YkArticulated *A, const YkArticulated *b)
{
    yk_inertia_add(&A->of, &b->of);
    A->f = yk_add(A->f, b->f);
    A->n += b->n;
}

// Releases the rotation under a known moment: the point then requires only a force, and the moment. J must not be 0.
static inline YkAnswer yk_articulated_release_turn(YkArticulated *A, double moment)
{
    double over = 1 / A->of.J;
    YkVec h = A->of.h, on = yk_scale(over, h);
    double by = (moment - A->n) * over;
    A->of.xx -= h.x * h.x * over;
    A->of.xy -= h.x * h.y * over;
    A->of.yy -= h.y * h.y * over;
    A->f = yk_add(A->f, yk_scale(by, h));
    A->of.J = 0;
    A->of.h = yk_vec(0, 0);
    A->n = moment;
    return (YkAnswer){.by = by, .on = on};
}

// Releases the sliding along a unit vector under a known force along it. The pivot line . M line must not be 0.
static inline YkAnswer yk_articulated_release_slide(YkArticulated *A, YkVec line, double force)
{
    YkVec on = yk_inertia_times(&A->of, line);
    double turn = yk_dot(A->of.h, line), over = 1 / yk_dot(line, on), by = (force - yk_dot(line, A->f)) * over;
    A->of.J -= turn * turn * over;
    A->of.h = yk_sub(A->of.h, yk_scale(turn * over, on));
    A->of.xx -= on.x * on.x * over;
    A->of.xy -= on.x * on.y * over;
    A->of.yy -= on.y * on.y * over;
    A->f = yk_add(A->f, yk_scale(by, on));
    A->n += by * turn;
    return (YkAnswer){.by = by, .turn = turn * over, .on = yk_scale(over, on)};
}

// Moves everything to another point of the rigid parent, `arm` back from here.
static inline YkArticulated yk_articulated_move(const YkArticulated *A, YkVec arm)
{
    YkVec across = yk_quarter(arm), q = yk_inertia_times(&A->of, across);
    double J = A->of.J + 2 * yk_dot(A->of.h, across) + yk_dot(across, q);
    return (YkArticulated){{J, yk_add(A->of.h, q), A->of.xx, A->of.xy, A->of.yy}, A->f, A->n + yk_dot(across, A->f)};
}

// Moves the force to another point of the rigid parent, `arm` back from here: J and h are 0 here (a pin). bias: how
// much this point accelerates beyond a + alpha x arm of the parent's point.
static inline YkArticulated yk_articulated_move_force(const YkArticulated *A, YkVec arm, YkVec bias)
{
    YkVec across = yk_quarter(arm), q = yk_inertia_times(&A->of, across);
    YkVec f = yk_add(A->f, yk_inertia_times(&A->of, bias));
    double J = (across.x * across.x * A->of.xx + across.y * across.y * A->of.yy) + 2 * (across.x * across.y) * A->of.xy;
    return (YkArticulated){{J, q, A->of.xx, A->of.xy, A->of.yy}, f, A->n + yk_dot(across, f)};
}

#endif
