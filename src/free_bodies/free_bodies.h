// Free bodies: Newton's and Euler's equations of every body, with the reactions of all joints as unknowns.
//
// Three equations for each body (two of force, one of moment about its reference point). The unknowns are two force
// components for a pin; the force normal to its line and a moment about `to` for a slide; the normal force for a
// pin-slot; two components and a moment for a weld; and the effort of every input (along its coordinate: on the joint's
// second body, the reaction on the first). The matrix is square for a machine without redundant constraints: as many
// unknowns as equations, since bodies * 3 = constraints + freedom. It is the transpose of the bodies' velocity
// Jacobian, sparse, factored by num/sparse.
#ifndef FREE_BODIES_FREE_BODIES_H
#define FREE_BODIES_FREE_BODIES_H
#include "loads/loads.h"
#include "solve/state.h"

typedef struct YkFreeBodies YkFreeBodies;
YkFreeBodies *yk_free_bodies_new(const YkMechanism *mech); // NULL when out of memory
void yk_free_bodies_free(YkFreeBodies *bodies);

// Solves inverse dynamics: all accelerations are those of the space's pose (lane 0). loads[body]: everything applied
// besides the efforts sought (including gravity; efforts along coordinates as moments and forces on both bodies). Finds
// all reactions and the effort of every input. Returns YK_OK, YK_REDUNDANT (least norm, moments divided by the
// machine's size), YK_SINGULAR (dead point). is_regular: blocks are singular, although all loops together are not.
YkStatus yk_free_bodies_inverse(YkFreeBodies *bodies, const YkSpace *space, const YkLoad *loads, bool is_regular);
// Solves forward dynamics: the accelerations of the bodies are unknown as well, and the joints' constraints,
// differentiated twice, are further equations. is_prescribed[input]: its acceleration is given (accelerations[input],
// in) and its effort unknown; otherwise its effort is 0 beyond the loads and its acceleration is sought (out).
// Positions and velocities are those of the space. Returns YK_SINGULAR also when a freedom has no inertia; *culprit is
// then its input (or -1).
YkStatus yk_free_bodies_forward(YkFreeBodies *bodies, const YkSpace *space, const YkLoad *loads,
                                const bool *is_prescribed, double *accelerations, int *culprit);

// The results of the last solution.
typedef struct YkJointForce {
    YkVec force;   // on the second body by the first, world axes
    double moment; // about the joint's point on the second body
    bool is_determinate;
} YkJointForce;
YkJointForce yk_free_bodies_joint(const YkFreeBodies *bodies, size_t joint);
double yk_free_bodies_effort(const YkFreeBodies *bodies, size_t input);
// Adds to load[body], times sign, the forces that follow from those found and turn nothing: along the lines of centres,
// by the pressure angles of gears; and the difference that it makes which of a cam's two rollers bears. Returns false
// if there are none. Solving again with them changes the reactions alone.
bool yk_free_bodies_radial(const YkFreeBodies *bodies, YkLoad *load, double sign);
// The force or couple that a relation - gears, a rack, a belt, a cam, a law - exerts on its second body.
typedef struct YkMeshForce {
    YkVec force;      // N, world axes, including the separating force of gears' flanks; 0 if only couples are known
    double moment;    // about the body's reference point without that separating force, N m
    bool is_backward; // gears: the bearing flanks are those that push against the direction of the line across
    bool is_couple;   // only couples are known
    YkVec at;         // where the force acts; for a couple the body's reference point
    int32_t body[2];
} YkMeshForce;
YkMeshForce yk_free_bodies_mesh(const YkFreeBodies *bodies, const YkSpace *space, size_t relation);
// Adds what gears, racks, belts and cams exert on every body to load[body] (moments about the reference points, N m).
void yk_free_bodies_meshes(const YkFreeBodies *bodies, YkLoad *load);
// Does so for one of them, or for a law between coordinates.
void yk_free_bodies_add_mesh(const YkFreeBodies *bodies, size_t relation, YkLoad *load);
// Returns what the drive exerts that makes a coordinate follow another by a law, N or N m.
double yk_free_bodies_law_effort(const YkFreeBodies *bodies, size_t relation);

#endif
