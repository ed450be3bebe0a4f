// Dynamics at a pose: joint reactions, efforts of drives, accelerations of free coordinates, energies.
//
// Every input of the mechanism is either *prescribed* (its acceleration is what the state says, its effort is sought)
// or *free* (its effort is known - what `efforts:` and other loads say - and its acceleration sought). Inverse
// dynamics: all prescribed. Forward dynamics: some free.
#ifndef YOKE_DYNAMICS_H
#define YOKE_DYNAMICS_H

#include <yoke/state.h>

typedef struct YkDynamics YkDynamics;

// Compiles inertia and loads for a mechanism. Driven inputs are prescribed, all others free, unless the machine has
// neither mass nor load (then all are prescribed). One per thread. NULL with a problem added when out of memory.
YK_API YkDynamics *yk_dynamics_new(const YkMechanism *mech, YkProblems *problems);
YK_API void yk_dynamics_free(YkDynamics *dynamics);
// Does the machine have any mass or load? Without, all forces are 0.
YK_API bool yk_dynamics_has_loads(const YkDynamics *dynamics);
YK_API void yk_dynamics_prescribe(YkDynamics *dynamics, size_t input, bool is_prescribed);
YK_API bool yk_dynamics_is_prescribed(const YkDynamics *dynamics, size_t input);
// Replaces what `efforts:` says along a coordinate by a constant (N m or N).
YK_API void yk_dynamics_set_effort(YkDynamics *dynamics, size_t coordinate, double effort);

typedef enum YkDynamicsMethod {
    YK_METHOD_REDUCED,     // equations in the free inputs alone; reactions afterwards. Default: faster
    YK_METHOD_NEWTON_EULER // every body's equations with all reactions and accelerations as unknowns
} YkDynamicsMethod;

// At the inputs of `state` (assembled): solves its pose, finds the free inputs' accelerations, sets them and solves the
// state again, then finds all reactions and efforts. YK_OK; YK_REDUNDANT: least-norm reactions; YK_SINGULAR: dead
// point, or a freedom without inertia (see the report). Allocates nothing. Cost linear for trees, chains of loops,
// ladders.
YK_API YkStatus yk_dynamics_solve(YkDynamics *dynamics, YkState *state, YkDynamicsMethod method);
// Accelerations alone (no reactions): the fast part of the above. What the state answers afterwards is not defined
// until it is solved again. accelerations[input], prescribed ones too.
YK_API YkStatus yk_dynamics_accelerate(YkDynamics *dynamics, YkState *state, double *accelerations);
YK_API const YkReport *yk_dynamics_report(const YkDynamics *dynamics);

// Results of the last yk_dynamics_solve.
typedef struct YkReaction {
    size_t by, on;   // bodies: the joint's first and second
    double force[2]; // that `by` exerts on `on` at the joint, world axes, N; without what a drive exerts along a slide
    double moment;   // about the joint's point (`to` of a slide), N m; without what a drive exerts about a pin
    double at[2];    // the joint's point in the world, m
    bool is_determinate; // false: one of many, the least in norm, or without the dry friction of joints that stand
} YkReaction;
YK_API YkReaction yk_dynamics_reaction(const YkDynamics *dynamics, size_t joint);
// What gears, racks, belts and cams transmit: on their second body (wheel, rack, pulley, follower) by their first, at
// the pitch point or where the cam touches. Where a force is not known - centres without points, belts - it is a couple
// about the body's centre of mass. Names live as long as the mechanism.
YK_API size_t yk_dynamics_contact_count(const YkDynamics *dynamics);
YK_API const char *yk_dynamics_contact_name(const YkDynamics *dynamics, size_t contact);
YK_API YkReaction yk_dynamics_contact(const YkDynamics *dynamics, size_t contact);
// A cam can push its follower, not pull it, unless a groove or a second roller holds it: would this contact have to
// pull? Then the motion computed is not the machine's: the follower leaves the cam. Not told of followers whose contact
// is a couple.
YK_API bool yk_dynamics_contact_pulls(const YkDynamics *dynamics, size_t contact);
// Along a tree coordinate, on the joint's second body (its reaction on the first): of the drive where the coordinate is
// a prescribed input, otherwise what `efforts:` gives. N m or N.
YK_API double yk_dynamics_effort(const YkDynamics *dynamics, size_t coordinate);
// A joint that stands under dry friction holds within an interval, so the effort that a drive must exert there has no
// single answer: every effort from low to high holds the machine, each input's taken by itself. The ends may be
// infinite: the joints jam. is_known is false where the interval was not found (then it is from -infinity to infinity).
// Otherwise is_single is true, and yk_dynamics_effort answers; in an interval it answers the effort with no friction in
// the joints that stand. What is computed exactly: docs/mathematics.md, section 10.
typedef struct YkEffortRange {
    bool is_single, is_known;
    double low, high; // N m or N
} YkEffortRange;
YK_API YkEffortRange yk_dynamics_effort_range(const YkDynamics *dynamics, size_t coordinate);
// Does dry friction at rest leave forces open? Reactions that it bears on are told as not determinate: those of no
// friction there.
YK_API bool yk_dynamics_is_held_by_friction(const YkDynamics *dynamics);
// Is there an effort along it at all: a prescribed input's, or one of `efforts:`?
YK_API bool yk_dynamics_has_effort(const YkDynamics *dynamics, size_t coordinate);
typedef struct YkEnergy {
    double kinetic, potential;
} YkEnergy; // J; potential: gravity and springs, 0 at world height 0
YK_API YkEnergy yk_dynamics_energy(const YkDynamics *dynamics);
// What the machine exerts on its frame: the resultant of all joint reactions and loads on the ground, about the world's
// origin.
typedef struct YkWrench {
    double force[2], moment;
} YkWrench;
YK_API YkWrench yk_dynamics_shaking(const YkDynamics *dynamics);
// A body's free-body balance about its centre of mass (origin, where it has no mass): loads (gravity, forces, springs,
// friction, efforts) + reactions = inertia; `residual` is what is left, over the largest force.
typedef struct YkBalance {
    YkWrench loads, reactions, inertia;
    double residual;
} YkBalance;
YK_API YkBalance yk_dynamics_balance(const YkDynamics *dynamics, size_t body);
// The count a textbook makes: force and moment equations of every body with mass (moments left out where they are
// trivial), of pins that join three bodies or more as massless junctions, and two acceleration equations a loop.
typedef struct YkEquationCount {
    size_t force, moment, acceleration, unknown_reactions, unknown_accelerations, unknown_efforts;
    bool ran_out; // of memory: nothing was counted
} YkEquationCount;
YK_API YkEquationCount yk_dynamics_count(const YkDynamics *dynamics);
// Channels of forces (A.force.x, theta1.effort, energy, ...) and all others.
YK_API double yk_dynamics_channel(const YkDynamics *dynamics, const YkState *state, YkChannel channel);

#endif
