// Dynamics at a pose: joint reactions, efforts of drives, accelerations of free coordinates, energies.
//
// Every input of the mechanism is either *prescribed* (the state gives its acceleration, and its effort is sought) or
// *free* (`efforts:` and other loads give its effort, and its acceleration is sought). In inverse dynamics all inputs
// are prescribed; in forward dynamics some are free.
#ifndef YOKE_DYNAMICS_H
#define YOKE_DYNAMICS_H

#include <yoke/state.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct YkDynamics YkDynamics;

// Compiles inertia and loads for a mechanism; cost linear in the machine, some microseconds a body. Driven inputs are
// prescribed and all others free, unless the machine has neither mass nor load (then all are prescribed). Use one per
// thread. Returns NULL with a problem added when out of memory.
YK_API YkDynamics *yk_dynamics_new(const YkMechanism *mech, YkProblems *problems);
YK_API void yk_dynamics_free(YkDynamics *dynamics);
// Returns whether the machine has any mass or load. If it has none, all forces are 0.
YK_API bool yk_dynamics_has_loads(const YkDynamics *dynamics);
YK_API void yk_dynamics_prescribe(YkDynamics *dynamics, size_t input, bool is_prescribed);
YK_API bool yk_dynamics_is_prescribed(const YkDynamics *dynamics, size_t input);
// Replaces the effort that `efforts:` gives along a coordinate by a constant (N m or N).
YK_API void yk_dynamics_set_effort(YkDynamics *dynamics, size_t coordinate, double effort);

typedef enum YkMethod {
    YK_METHOD_REDUCED,     // equations in the free inputs alone, then the reactions; the default, and faster
    YK_METHOD_NEWTON_EULER // the equations of every body, with all reactions and accelerations as unknowns
} YkMethod;

// Solves the dynamics at the inputs of `state` (assembled): solves its pose, finds the free inputs' accelerations,
// sets them, solves the state again, then finds all reactions and efforts. Returns YK_OK; YK_REDUNDANT with least-norm
// reactions; YK_SINGULAR at a dead point or for a freedom without inertia (see the report); YK_CHANGE_POINT at a pose
// whose rates are limits, which stay. Allocates nothing, except at the first pose of a variant's design.
// Cost: linear for trees, chains of loops and ladders; of many poses one a call, yk_batch_run takes a tenth of it.
YK_API YkStatus yk_dynamics_solve(YkDynamics *dynamics, YkState *state, YkMethod method);
// Finds only the accelerations, the fast part of the above: accelerations[input], prescribed ones too. The state's
// answers are undefined until it is solved again.
YK_API YkStatus yk_dynamics_accelerate(YkDynamics *dynamics, YkState *state, double *accelerations);
YK_API const YkReport *yk_dynamics_report(const YkDynamics *dynamics);

// Results of the last yk_dynamics_solve.
typedef struct YkReaction {
    size_t by, on;   // bodies: the joint's first and second
    double force[2]; // that `by` exerts on `on` at the joint, world axes, N; without what a drive exerts along a slide
    double moment;   // about the joint's point (`to` of a slide), N m; without what a drive exerts about a pin
    double at[2];    // the joint's point in the world, m
    bool is_determinate; // false: one of many, the least in norm, or without the dry friction of joints at rest
} YkReaction;
// Returns the reaction of a joint. Where equal planets share a load (`planets: N` of gears), the forces at the pin and
// at the teeth are those on the one planet that the file describes.
YK_API YkReaction yk_dynamics_reaction(const YkDynamics *dynamics, size_t joint);
// Contacts are what gears, racks, belts and cams transmit: the force that their first body exerts on their second
// (wheel, rack, pulley, follower), at the pitch point or where the cam touches. Where that place is not known, as for
// belts and for wheels whose centres are not points, the contact is a couple about the body's centre of mass. Names
// live as long as the mechanism.
YK_API size_t yk_dynamics_contact_count(const YkDynamics *dynamics);
YK_API const char *yk_dynamics_contact_name(const YkDynamics *dynamics, size_t contact);
YK_API YkReaction yk_dynamics_contact(const YkDynamics *dynamics, size_t contact);
// Returns whether this contact would have to pull. A cam can push its follower but not pull it, unless a groove or a
// second roller holds it: then the follower leaves the cam, and the motion computed is not the machine's. Always false
// for followers whose contact is a couple.
YK_API bool yk_dynamics_contact_pulls(const YkDynamics *dynamics, size_t contact);
// Returns the effort along a tree coordinate, on the joint's second body (its reaction acts on the first), N m or N:
// that of the drive for a prescribed input or a coordinate that follows another by a law, otherwise that of `efforts:`.
YK_API double yk_dynamics_effort(const YkDynamics *dynamics, size_t coordinate);
// A joint at rest under dry friction holds within an interval, so the effort that a drive must exert there is not
// unique: every effort from low to high holds the machine, for each input by itself. The ends may be infinite: then the
// joints jam. is_known is false if the interval was not found (then it is from -infinity to infinity). If the effort is
// unique, is_single is true and yk_dynamics_effort gives it; within an interval that function gives the effort without
// friction in the joints at rest. docs/mathematics.md, section 10, says exactly what is computed.
typedef struct YkEffortRange {
    bool is_single, is_known;
    double low, high; // N m or N
} YkEffortRange;
YK_API YkEffortRange yk_dynamics_effort_range(const YkDynamics *dynamics, size_t coordinate);
// Returns whether dry friction at rest leaves forces undetermined. Reactions that depend on it are reported as not
// determinate, with the values they have without that friction.
YK_API bool yk_dynamics_is_held_by_friction(const YkDynamics *dynamics);
// Returns whether there is an effort along a coordinate at all: a drive's, or one of `efforts:`.
YK_API bool yk_dynamics_has_effort(const YkDynamics *dynamics, size_t coordinate);
typedef struct YkEnergy {
    double kinetic, potential;
} YkEnergy; // J; potential: gravity and springs, 0 at world height 0
YK_API YkEnergy yk_dynamics_energy(const YkDynamics *dynamics);
// The wrench that the machine exerts on its frame: the resultant of all joint reactions and loads on the ground, about
// the world's origin.
typedef struct YkWrench {
    double force[2], moment;
} YkWrench;
YK_API YkWrench yk_dynamics_shaking(const YkDynamics *dynamics);
// A body's free-body balance about its centre of mass (its origin if it has no mass): loads (gravity, forces, springs,
// friction, efforts) + reactions = inertia; `residual` is the difference, over the largest force (or 1 where all are
// 0).
typedef struct YkBalance {
    YkWrench loads, reactions, inertia;
    double residual;
} YkBalance;
YK_API YkBalance yk_dynamics_balance(const YkDynamics *dynamics, size_t body);
// The equations counted as a textbook does: force and moment equations of every body with mass (without trivial
// moments), those of massless junctions at pins that join three bodies or more, and two acceleration equations for each
// loop.
typedef struct YkEquationCount {
    size_t force, moment, acceleration, unknown_reactions, unknown_accelerations, unknown_efforts;
    bool ran_out; // out of memory: nothing was counted
} YkEquationCount;
YK_API YkEquationCount yk_dynamics_count(const YkDynamics *dynamics);
// Returns a channel of forces (A.force.x, theta1.effort, energy, ...) or any other.
YK_API double yk_dynamics_channel(const YkDynamics *dynamics, const YkState *state, YkChannel channel);

#ifdef __cplusplus
}
#endif

#endif
