// Free bodies: Newton's and Euler's equations of every body, with the reactions of all joints as unknowns.
//
// Three equations a body (two of force, one of moment about its reference point). Unknown: of a pin two force
// components; of a slide the force normal to its line and a moment about `to`; of a pin-slot the normal force; of a
// weld two components and a moment; of every input its effort (along its coordinate: on the joint's second body, the
// reaction on the first). The matrix is square for a machine without redundant constraints: as many unknowns as
// equations, since bodies * 3 = constraints + freedom. It is the transpose of the bodies' velocity Jacobian, sparse,
// factored by num/sparse.
#ifndef FREE_BODIES_FREE_BODIES_H
#define FREE_BODIES_FREE_BODIES_H
#include "loads/loads.h"
#include "solve/state.h"

typedef struct YkFreeBodies YkFreeBodies;
YkFreeBodies *yk_free_bodies_new(const YkMechanism *mech); // NULL when out of memory
void yk_free_bodies_free(YkFreeBodies *bodies);

// Inverse dynamics: all accelerations are those of the space's pose (lane 0). loads[body]: everything applied besides
// the efforts sought (gravity included; efforts along coordinates as moments and forces on both bodies). Solves for all
// reactions and the effort of every input. YK_OK, YK_REDUNDANT (least norm, moments divided by the machine's size),
// YK_SINGULAR (dead point).
YkStatus yk_free_bodies_inverse(YkFreeBodies *bodies, const YkSpace *space, const YkLoad *loads);
// Forward dynamics: additionally the accelerations of the bodies are unknown, and the joints' constraints
// differentiated twice are equations. is_prescribed[input]: its acceleration is given (accelerations[input], in) and
// its effort unknown; otherwise its effort is 0 beyond the loads and its acceleration is sought (out). Positions and
// velocities are those of the space. YK_SINGULAR also when a freedom has no inertia; then *culprit is an input that it
// is (or -1).
YkStatus yk_free_bodies_forward(YkFreeBodies *bodies, const YkSpace *space, const YkLoad *loads,
                                const bool *is_prescribed, double *accelerations, int *culprit);

// Results of the last solve.
typedef struct YkJointForce {
    YkVec force;   // on the second body by the first, world axes
    double moment; // about the joint's point on the second body
    bool is_determinate;
} YkJointForce;
YkJointForce yk_free_bodies_joint(const YkFreeBodies *bodies, size_t joint);
double yk_free_bodies_effort(const YkFreeBodies *bodies, size_t input);
// The forces along the lines of centres that gears' pressure angles bring with the forces found: times sign, added to
// load[body]. False where there are none. They turn nothing: solved again with them, only reactions change.
bool yk_free_bodies_radial(const YkFreeBodies *bodies, YkLoad *load, double sign);
// What a relation of the mechanism - gears, a rack, a belt, a cam, a law - exerts on its second body.
typedef struct YkMeshForce {
    YkVec force;      // N, world axes, the push apart of gears' flanks included; 0 where only couples are known
    double moment;    // about the body's reference point without that push, N m
    bool is_backward; // gears: the flanks that bear are those that push against the sense of the line across
    bool is_couple;   // only couples are known
    YkVec at;         // where the force acts; of a couple the body's reference point
    int32_t body[2];
} YkMeshForce;
YkMeshForce yk_free_bodies_mesh(const YkFreeBodies *bodies, const YkSpace *space, size_t relation);
// Adds what gears, racks, belts and cams exert on every body to load[body] (moments about the reference points, N m).
void yk_free_bodies_meshes(const YkFreeBodies *bodies, YkLoad *load);
// Largest residual of any body's equations over the largest force (moments over the machine's size).
double yk_free_bodies_imbalance(const YkFreeBodies *bodies);

#endif
