// The inside of YkDynamics.
#ifndef DYNAMICS_DYNAMICS_H
#define DYNAMICS_DYNAMICS_H
#include "equations/influence.h"
#include "equations/reduced.h"
#include "equations/tree.h"
#include "free_bodies/free_bodies.h"

struct YkHolding;

struct YkDynamics {
    YkArena *arena; // of its arrays
    const YkMechanism *mech;
    YkLoads *loads;
    bool *is_free, *prescribed; // per input; prescribed: scratch
    bool has_mass;
    YkElimination *elimination; // remade when the free inputs change
    YkReduced *reduced;
    YkTreeDynamics *tree;   // open trees: the fast path; otherwise NULL
    YkInfluence *influence; // closed machines with few free inputs: the fast path; otherwise NULL
    YkFreeBodies *bodies;
    struct YkHolding *holding;             // for joints at rest under dry friction; NULL without dry friction
    bool is_stale;                         // elimination and tree do not match the choice of free inputs
    double *q, *v, *effort, *acceleration; // per input
    double *power;                         // per item of the loads
    YkLoad *load;                          // per body: all loads including gravity, and the efforts of drives
    YkLoad *reaction;                      // per body: sum over its joints
    YkBodyMotion *motion;                  // per body
    YkReaction *joint;                     // per joint; of planets that share a load, that of the one in the file
    YkVec *whole;                          // per joint: its force in the equations, which count all planets in one
    YkReaction *contact;                   // per relation
    double *drive;                         // per input: the effort of its drive
    double stored;                         // in springs, J
    double largest_force;
    uint64_t changes; // of the mechanism's variant, when its values were taken
    bool ran_out;     // of memory, once: later results cannot be trusted
    YkReport report;
};

// follow.c: takes the present values of the mechanism's variant if they have changed. Returns false when out of memory.
bool yk_dynamics_follow(YkDynamics *dynamics);

// accelerations.c: frees the equations. The second remakes what is stale; it returns false when out of memory.
void yk_dynamics_forget_equations(YkDynamics *dynamics);
bool yk_dynamics_prepare(YkDynamics *dynamics);
// Finds the accelerations of all inputs of an open tree, which is prepared, without a pose.
YkStatus yk_dynamics_reduce_tree(YkDynamics *dynamics, const YkState *state, double *accelerations);
// Finds the accelerations of the free inputs at the state's inputs, in dynamics->acceleration; the state then has the
// pose there with the free inputs' accelerations 0 (open trees: its pose is unchanged), and `load` all loads but
// gravity. The reduced equations stay factored for efforts and responses.
YkStatus yk_dynamics_reduce(YkDynamics *dynamics, YkState *state);
// Does the same by the fastest method, when only the accelerations are needed.
YkStatus yk_dynamics_find_accelerations(YkDynamics *dynamics, YkState *state);
YkStatus yk_dynamics_fail_at_input(YkDynamics *dynamics, int input);
YkStatus yk_dynamics_fail_at_load(YkDynamics *dynamics, size_t item); // for a value that is not finite
YkStatus yk_dynamics_fail(YkDynamics *dynamics, YkStatus status, const char *head, const char *name, const char *tail);

// forces.c: solves the state again with dynamics->acceleration for the free inputs, then all reactions and efforts.
YkStatus yk_dynamics_apply(YkDynamics *dynamics, YkState *state);
// Finds one solution at the state's inputs, with the present dry friction of the loads.
YkStatus yk_dynamics_solve_once(YkDynamics *dynamics, YkState *state, YkMethod method);
// Sets dry friction from the last reactions, which in turn depend on it; returns whether it has settled. round: how
// often this has been done at the pose, below YK_DRY_ROUNDS.
enum { YK_DRY_ROUNDS = 400 };
bool yk_dynamics_find_dry(YkDynamics *dynamics, const YkState *state, int round);
double yk_dynamics_dry_tolerance(int round);
YkStatus yk_dynamics_fail_at_dry(YkDynamics *dynamics); // it does not settle: forgets it
// Forgets the friction of the last pose, from which the next one's is sought otherwise: its last digits depend on it.
void yk_dynamics_forget_dry(YkDynamics *dynamics);
double yk_dynamics_dry_limit(const YkDynamics *dynamics, const YkLoadItem *item);

// solved.c: returns the cam of a contact that nothing holds, neither a groove nor a second roller; NULL for all others.
const YkCam *yk_dynamics_loose_cam(const YkDynamics *dynamics, size_t contact);
// Returns how strongly such a contact would have to pull, less what is rounding, over 1 / its distance from the shaft:
// above 0 if it would. 0 for all others.
double yk_dynamics_contact_pull(const YkDynamics *dynamics, size_t contact);
// Returns the kinetic and potential energy at the state's pose, without forces.
YkEnergy yk_dynamics_energy_at(YkDynamics *dynamics, const YkState *state);

#endif
