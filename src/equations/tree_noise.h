// Rounding in articulated inertias: which pivots are inertia, and which are only what rounding left of none.
//
// The noise of a subtree is an inertia, too, in units of the relative rounding error: for any acceleration of its point
// and link it bounds what rounding may have changed in the energy. A released joint hands it inwards along the motion
// with which the joint answers, so a small pivot magnifies the noise behind it as it magnifies rounding itself.
#ifndef EQUATIONS_TREE_NOISE_H
#define EQUATIONS_TREE_NOISE_H
#include "equations/tree_articulated.h"

// A pivot does not count as inertia unless it exceeds this many times its noise: then it has about three digits.
#define YK_LEAST_OVER_NOISE 1e-13

// Adds a rigid body: its mass, its inertia about the point.
static inline void yk_noise_add_body(YkInertia *noise, double mass, double inertia)
{
    noise->J += inertia;
    noise->xx += mass;
    noise->yy += mass;
}

// Adds what one operation on a matrix M of this trace rounds, whatever its direction.
static inline void yk_noise_add_trace(YkInertia *noise, double trace)
{
    noise->xx += trace;
    noise->yy += trace;
}

// Releases the rotation, which answers to an acceleration a by -on . a. trace: of M before.
static inline void yk_noise_release_turn(YkInertia *noise, YkVec on, double trace)
{
    YkVec h = noise->h, rest = yk_sub(yk_scale(noise->J, on), h);
    noise->xx += on.x * rest.x - on.x * h.x;
    noise->xy += on.x * rest.y - on.y * h.x;
    noise->yy += on.y * rest.y - on.y * h.y;
    noise->J = 0;
    noise->h = yk_vec(0, 0);
    yk_noise_add_trace(noise, trace);
}

// Returns the noise of the pivot of a slide along a unit vector.
static inline double yk_noise_along(const YkInertia *noise, YkVec line)
{
    return yk_dot(line, yk_inertia_times(noise, line));
}

// Releases the sliding along a unit vector; before: the articulated inertia as it was.
static inline void yk_noise_release_slide(YkInertia *noise, YkVec line, YkAnswer answer, const YkArticulated *before)
{
    YkVec on = answer.on, q = yk_inertia_times(noise, line);
    double turn = answer.turn, h = yk_dot(noise->h, line), along = yk_dot(line, q);
    YkVec rest = yk_sub(yk_scale(along, on), q);
    noise->J += turn * (turn * along - 2 * h) + before->of.J;
    noise->h = yk_add(noise->h, yk_sub(yk_scale(turn, rest), yk_scale(h, on)));
    noise->xx += on.x * rest.x - on.x * q.x;
    noise->xy += on.x * rest.y - on.y * q.x;
    noise->yy += on.y * rest.y - on.y * q.y;
    yk_noise_add_trace(noise, yk_inertia_trace(&before->of));
}

// Moves the noise to another point of the rigid parent, from which this one is a quarter turn back of `across`. trace:
// of M, whose moment of inertia there is rounded.
static inline YkInertia yk_noise_move(const YkInertia *noise, YkVec across, double trace)
{
    YkVec q = yk_inertia_times(noise, across);
    double J = noise->J + 2 * yk_dot(noise->h, across) + yk_dot(across, q) + trace * yk_dot(across, across);
    return (YkInertia){J, yk_add(noise->h, q), noise->xx, noise->xy, noise->yy};
}

// The same where J and h are 0 (a pin).
static inline YkInertia yk_noise_move_force(const YkInertia *noise, YkVec across, double trace)
{
    YkVec q = yk_inertia_times(noise, across);
    double J = yk_dot(across, q) + trace * yk_dot(across, across);
    return (YkInertia){J, q, noise->xx, noise->xy, noise->yy};
}

#endif
