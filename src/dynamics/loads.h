// Loads at a pose: what gravity, forces, springs, dampers, efforts and friction exert on every body, as one force and one
// moment a body; and what they store and take.
#ifndef DYNAMICS_LOADS_H
#define DYNAMICS_LOADS_H
#include <yoke/dynamics.h>
#include "compile/mechanism.h"
#include "solve/space.h"

// On a body: force, and moment about its reference point: the centre of mass, or the origin where it has no mass.
typedef struct YkLoad {
    YkVec force;
    double moment;
} YkLoad;

// Where a body's reference point is and how it moves, lane 0 of a space.
typedef struct YkBodyMotion {
    YkVec at, velocity, acceleration; // of the reference point, world axes
    YkVec e;                          // the body's x axis as a unit vector
    double w, a;                      // angular velocity and acceleration
} YkBodyMotion;
YkVec yk_reference_point(const YkModel *model, size_t body); // in the body's axes
YkBodyMotion yk_body_motion(const YkMechanism *mech, const YkSpace *space, size_t body);

#endif
