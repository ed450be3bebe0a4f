// Forces of the program: the equations of motion in the inputs alone, efforts, accelerations, energies; reactions.
//
// With the Jacobian columns J_i of every body (its velocities for the rate 1 of input i), the equations are
//     sum_j M_ij q_j'' + h_i = Q_i + effort_i,   M_ij = sum m v_i.v_j + I w_i w_j,
// h from the accelerations for q'' = 0, Q from the loads. Source: Kane & Levinson 1985.
#ifndef PROGRAM_FORCES_H
#define PROGRAM_FORCES_H
#include "program/program.h"

typedef struct YkWrenchRef { // on a body: force, and moment about its reference point
    YkRefVec force;
    YkRef moment;
} YkWrenchRef;

typedef struct YkContactRef { // of a gear, rack, belt, cam or law on its second body
    YkRefVec force;
    YkRef moment;   // of one that transmits couples; of a law: its effort along the coordinate that follows it
    bool has_force; // otherwise couples alone
} YkContactRef;

typedef struct YkDryJoint { // a joint with dry friction
    int32_t joint;
    bool slides;
    YkRef limit;     // of its friction, for 1 N in the joint
    YkRef *along;    // per input: its rate for the rate 1 of that input
    YkRef *response; // per input: the acceleration of a free one that 1 N or N m along it adds; NULL: all are given
} YkDryJoint;

typedef struct YkDryResult {
    YkRef moves;       // above 0 if no joint with dry friction is at rest
    YkRef settled;     // 1 if frictions and reactions agree
    YkRef determinant; // of the equations
} YkDryResult;

typedef struct YkForces {
    YkProgram *program;
    YkMotionRef *motion;      // per coordinate of the tree: position and velocity
    YkRates *column;          // per input
    YkRates velocities, bias; // of the pose; bias: its accelerations for zero accelerations of the inputs
    YkRefVec gravity;
    YkWrenchRef *load;   // per body, besides its weight
    YkRef *given;        // per effort of the model: its value
    YkRef *mass, *rest;  // M[n][n]; h - Q
    YkRef *effort;       // per input, all accelerations given
    YkRef *acceleration; // per input; inputs without a drive have no effort except `extra`
    bool *is_free;       // per input
    size_t free_count;
    YkRef inertia; // above 0 if every free input has inertia
    YkRef kinetic, potential;
    YkRef *reaction;       // per joint: force x, y, moment; NULL: not printed
    YkContactRef *contact; // per relation, where there are reactions
    YkRef determinant;     // of the reactions' equations
    const char *why_no_reactions;
    YkDryJoint *dry;
    size_t dry_count;
    bool balances_dry;                                // each of them is a right side of the balance
    YkDryResult dry_result, dry_inverse, dry_forward; // dry_result: the latest
    bool takes_least; // where constraints repeat others, the reactions are those of least norm;
    bool is_least;    // some are
} YkForces;

typedef struct YkEquations { // M q'' + rest = efforts
    YkRef *mass, *rest;      // M[n][n], at and below its diagonal
} YkEquations;

enum { YK_FORCES_INPUTS_MAX = 40 };

// Makes room, and nothing else. Returns false when out of memory.
bool yk_forces_start(YkForces *forces, YkProgram *program);
// Returns false if a load cannot be printed: reported.
bool yk_forces_build(YkForces *forces, YkProgram *program);
// loads.c: the action of all loads, into forces->load; the energy of springs and gravity.
bool yk_forces_loads(YkForces *forces);
YkRefVec yk_forces_center(YkProgram *program, int32_t body); // its reference point, in the body's axes
// Returns the vector from the body's reference point to a point given in its axes, world axes.
YkRefVec yk_forces_arm(YkProgram *program, int32_t body, YkRefVec at);
YkRefVec yk_forces_line(YkProgram *program, const YkJoint *joint); // of a joint that slides, world axes
YkRef yk_forces_mass(YkProgram *program, int32_t body);
YkRef yk_forces_inertia(YkProgram *program, int32_t body);
// equations.c: M and the rest.
bool yk_forces_equations(YkForces *forces);
// lumped_masses.c: adds all masses and their weight. Returns false if the machine is not a tree or a body has no mass.
bool yk_forces_lumped(YkForces *forces, YkEquations *out);
// accelerations.c: those of the free inputs.
void yk_forces_accelerations(YkForces *forces);
// Returns the accelerations that forces along the inputs add to the free ones (0 elsewhere); NULL when out of memory.
YkRef *yk_forces_response(YkForces *forces, const YkRef *along);
// loads.c: makes the wrenches of an effort of 1 along a joint's freedom, into load[body].
void yk_forces_unit_effort(YkForces *forces, int32_t joint, bool is_distance, YkWrenchRef *load);
// dry_friction.c: adds dry friction to the efforts and the accelerations, and finds the reactions with it; for machines
// with dry_count > 0. Returns false if it cannot be printed, which is reported, or when out of memory.
bool yk_forces_dry(YkForces *forces, const YkRates *velocities, const YkRates *accelerations);
// reactions.c: the equations of the free bodies.
void yk_forces_reactions(YkForces *forces, const YkRates *velocities, const YkRates *accelerations);
// Returns whether it has mass or load.
bool yk_model_has_forces(const YkModel *model);

#endif
