// The state: one pose of a mechanism with its velocities and accelerations. Use one per thread; solving allocates
// nothing.
#ifndef YOKE_STATE_H
#define YOKE_STATE_H

#include <yoke/mechanism.h>
#include <yoke/progress.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct YkState YkState;

// Scalar motion of a coordinate (m or rad) or a body's angle: value, rate and acceleration. Never NaN: rates that are
// undefined (status YK_SINGULAR) are 0, and yk_state_has_rates() is false.
typedef struct YkMotion {
    double position, velocity, acceleration;
} YkMotion;
typedef struct YkPointMotion {
    double position[2], velocity[2], acceleration[2];
} YkPointMotion; // world axes, m

YK_API YkState *yk_state_new(const YkMechanism *mech); // NULL when out of memory
YK_API void yk_state_free(YkState *state);
YK_API const YkMechanism *yk_state_mechanism(const YkState *state);
YK_API YkStatus yk_state_copy(YkState *to, const YkState *from); // both of the same mechanism; allocates nothing
// Lets `progress` watch the long calls on this state from now on (<yoke/progress.h>): assembling, visiting all
// configurations, moves, carrying, sweeps, closing ranges, dragging, reports. One that is stopped returns YK_STOPPED
// and leaves the state as it was before the call. A single solution (yk_state_solve) is short and is not watched. A
// copy of the state is not watched. Returns YK_OK, or YK_NO_MEMORY.
YK_API YkStatus yk_state_set_progress(YkState *state, YkProgress progress);

// Sets the inputs at `time`, s: evaluates all drives and gives held coordinates their start values and rates.
YK_API YkStatus yk_state_set_time(YkState *state, double time, YkProblems *problems);
YK_API double yk_state_time(const YkState *state);
YK_API void yk_state_set_input(YkState *state, size_t input, YkMotion motion);
// Does the same with three numbers, which is faster, since a structure just filled would have to go through memory.
YK_API void yk_state_set_input_to(YkState *state, size_t input, double position, double velocity, double acceleration);
YK_API YkMotion yk_state_input(const YkState *state, size_t input);
// Sets one order of an input (0 position, 1 velocity, 2 acceleration) and keeps it at every later
// yk_state_set_time, in place of the drive's value.
YK_API void yk_state_hold_input(YkState *state, size_t input, int order, double value);

// Assembles the machine: takes, among all configurations that close at the inputs, the one nearest to the guesses
// of `start:` (squared differences of angles modulo a turn and of lengths over the machine's size). Its branches are
// kept, and its angles become the reference. Returns YK_OK, YK_SINGULAR, YK_REDUNDANT, YK_NO_ASSEMBLY, ...;
// YK_NOT_CONVERGED if the search gave up before it had tried everything.
// Cost: at worst 2^d solutions for d dyads; bounds cut it short.
YK_API YkStatus yk_state_assemble(YkState *state);
// Solves at the present inputs on the present branches (from assembling, from the last configuration, or from
// yk_state_set_branch). Each angle is the one nearest to the reference. Keeps the last valid pose on failure.
// Cost: linear; allocates nothing.
YK_API YkStatus yk_state_solve(YkState *state);
// Visits every configuration at the present inputs, each as the state's pose, in a fixed order ("+" before "-").
// visit returns false to stop. complete (may be NULL): false if a GROUP was searched instead of enumerated, or the
// limit of 4096 was reached. The state returns to the configuration it had. Returns YK_OK or YK_NO_ASSEMBLY.
// yk_configurations_each (<yoke/configurations.h>) enumerates groups too, with proof.
YK_API YkStatus yk_state_each(YkState *state, bool (*visit)(void *context, YkState *state), void *context,
                              bool *complete);

// The branch of a block: the sign of its determinant, +1 or -1, or 0 for a block without one.
YK_API int yk_state_branch(const YkState *state, size_t block);
YK_API void yk_state_set_branch(YkState *state, size_t block, int branch);
// Writes "A+ C-": every block with a branch. Returns the length needed.
YK_API size_t yk_state_label(const YkState *state, char *text, size_t capacity);

// The results. Indices are those of the model and the mechanism.
YK_API bool yk_state_has_pose(const YkState *state); // false until it is assembled
// Returns whether both states of one mechanism stand in the same pose: angles up to whole turns and to 1e-6 rad,
// distances to 1e-6 of the machine's size. False without a pose.
YK_API bool yk_state_is_at(const YkState *state, const YkState *other);
YK_API bool yk_state_has_rates(const YkState *state);
YK_API YkMotion yk_state_coordinate(const YkState *state, size_t coordinate);
YK_API YkMotion yk_state_body(const YkState *state, size_t body); // angle to the ground
// Writes the motion of every body at once, as yk_state_body returns it: motions[body]. Cost: linear in their number.
YK_API void yk_state_bodies(const YkState *state, YkMotion *motions);
YK_API YkPointMotion yk_state_point(const YkState *state, size_t point);
YK_API double yk_state_channel(const YkState *state, YkChannel channel);
// Returns the transmission angle of a block, rad in [0, pi/2]: the angle between the two directions in which its dyad
// is closed. Its sine is the block's determinant over the product of its column lengths. 0 at a dead point.
YK_API double yk_state_transmission(const YkState *state, size_t block);

// The largest residuals: of the loop equations, over the machine's size; of J q' + Phi_t and of J q'' + gamma, over
// their largest term. They are measured in the loops of the tree, not in the steps that solved them.
typedef struct YkResiduals {
    double position, velocity, acceleration;
} YkResiduals;
YK_API YkResiduals yk_state_residuals(const YkState *state);

// The failure of the last assembly or solution: where and by how much. joint, block: -1 if none.
typedef struct YkReport {
    YkStatus status;
    int block, joint;
    double gap;         // by how many metres the loop fails to close (NO_ASSEMBLY, LIMIT)
    double determinant; // of the worst block, over the product of its column lengths (SINGULAR)
    char message[240];  // one sentence that names the joint and the loop
} YkReport;
YK_API const YkReport *yk_state_report(const YkState *state);

#ifdef __cplusplus
}
#endif

#endif
