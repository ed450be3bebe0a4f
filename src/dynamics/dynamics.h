// The inside of YkDynamics.
#ifndef DYNAMICS_DYNAMICS_H
#define DYNAMICS_DYNAMICS_H
#include "equations/influence.h"
#include "equations/reduced.h"
#include "equations/tree.h"
#include "free_bodies/free_bodies.h"

struct YkHolding;

struct YkDynamics {
    const YkMechanism *mech;
    YkLoads *loads;
    bool *is_free, *prescribed; // per input; prescribed: scratch
    bool has_mass;
    YkElimination *elimination; // made anew when what is free changes
    YkReduced *reduced;
    YkTreeDynamics *tree;   // open trees: the fast way; otherwise NULL
    YkInfluence *influence; // closed machines with few free inputs: the fast way; otherwise NULL
    YkFreeBodies *bodies;
    struct YkHolding *holding;             // of joints with dry friction that stand; NULL without dry friction
    bool is_stale;                         // elimination and tree do not fit the choice of free inputs
    double *q, *v, *effort, *acceleration; // per input
    double *power;                         // per item of the loads
    YkLoad *load;                          // per body: all loads with gravity, and what drives exert
    YkLoad *reaction;                      // per body: sum over its joints
    YkBodyMotion *motion;                  // per body
    YkReaction *joint;                     // per joint
    YkReaction *contact;                   // per relation
    double *drive;                         // per input: what its drive exerts
    double stored;                         // in springs, J
    double largest_force;
    int32_t pushed; // an input on which `push` acts besides all loads, for responses
    double push;
    bool ran_out; // of memory, once: what came of it afterwards is not to be relied on
    YkReport report;
};

// Makes what is stale. False when out of memory.
bool yk_dynamics_prepare(YkDynamics *dynamics);
// Accelerations of the free inputs at the state's inputs, into dynamics->acceleration; the state's pose stands there
// with the free inputs' accelerations 0 (open trees: its pose is not touched). All loads but gravity are in `load`
// then. The reduced equations stand too, for efforts and responses.
YkStatus yk_dynamics_reduce(YkDynamics *dynamics, YkState *state);
// The same by the fastest way, where nothing but the accelerations is asked.
YkStatus yk_dynamics_find_accelerations(YkDynamics *dynamics, YkState *state);
// With dynamics->acceleration for the free inputs: solves the state again, then all reactions and efforts.
YkStatus yk_dynamics_apply(YkDynamics *dynamics, YkState *state);
// One solution at the state's inputs, with the dry friction of the loads as it is.
YkStatus yk_dynamics_solve_once(YkDynamics *dynamics, YkState *state, YkDynamicsMethod method);
// Dry friction depends on the reactions, which depend on it: sets it from the last reactions; does it stand?
// round: how often this has been done at the pose, below YK_DRY_ROUNDS.
enum { YK_DRY_ROUNDS = 400 };
bool yk_dynamics_find_dry(YkDynamics *dynamics, const YkState *state, int round);
double yk_dynamics_dry_tolerance(int round);
YkStatus yk_dynamics_fail_at_dry(YkDynamics *dynamics); // it never does: forgets it
double yk_dynamics_dry_limit(const YkDynamics *dynamics, const YkLoadItem *item);
// Kinetic and potential energy at the state's pose, without forces.
YkEnergy yk_dynamics_energy_at(YkDynamics *dynamics, const YkState *state);
YkStatus yk_dynamics_fail_at_input(YkDynamics *dynamics, int input);
YkStatus yk_dynamics_fail_at_load(YkDynamics *dynamics, size_t item); // its value is not finite
YkStatus yk_dynamics_fail(YkDynamics *dynamics, YkStatus status, const char *head, const char *name, const char *tail);

#endif
