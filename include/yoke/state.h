// The state: one pose of a mechanism, with velocities and accelerations. One per thread; solving allocates nothing.
#ifndef YOKE_STATE_H
#define YOKE_STATE_H

#include <yoke/mechanism.h>

typedef struct YkState YkState;

// Scalar motion: a coordinate (m or rad) or a body's angle; the value, its rate and its acceleration. NaN never: rates
// that are not defined (status YK_SINGULAR) come as 0 with yk_state_has_rates() false.
typedef struct YkMotion {
    double position, velocity, acceleration;
} YkMotion;
typedef struct YkPointMotion {
    double position[2], velocity[2], acceleration[2];
} YkPointMotion; // world axes, m

YK_API YkState *yk_state_new(const YkMechanism *mech); // NULL when out of memory
YK_API void yk_state_free(YkState *state);
YK_API const YkMechanism *yk_state_mechanism(const YkState *state);
YK_API YkStatus yk_state_copy(YkState *to, const YkState *from); // same mechanism; allocates nothing

// Inputs. First all drives are evaluated at `time` and held coordinates take their start values and rates.
YK_API YkStatus yk_state_set_time(YkState *state, double time, YkProblems *problems);
YK_API double yk_state_time(const YkState *state);
YK_API void yk_state_set_input(YkState *state, size_t input, YkMotion motion);
// The same, number by number: a structure that was only just filled would go through memory and wait there.
YK_API void yk_state_set_input_to(YkState *state, size_t input, double position, double velocity, double acceleration);
YK_API YkMotion yk_state_input(const YkState *state, size_t input);
// Sets one order of an input (0 position, 1 velocity, 2 acceleration) and keeps it at every later yk_state_set_time, in
// place of what the drive says.
YK_API void yk_state_hold_input(YkState *state, size_t input, int order, double value);

// Assembles: among all configurations that close at the inputs, takes the one nearest to the guesses of `start:`
// (squared differences of angles modulo a turn and of lengths over the machine's size), and keeps its branches and its
// angles as reference. Cost: 2^d solutions of d dyads at worst, cut short by bounds. YK_OK, YK_SINGULAR, YK_REDUNDANT,
// YK_NO_ASSEMBLY, YK_NOT_CONVERGED where the search gave up without having tried everything, ...
YK_API YkStatus yk_state_assemble(YkState *state);
// Solves at the present inputs on the branches set (by assembling, by the last configuration, by yk_state_set_branch).
// Angles come out nearest to the reference. The last valid pose is kept on failure. Cost linear; allocates nothing.
YK_API YkStatus yk_state_solve(YkState *state);
// Visits every configuration at the present inputs, each as the state's pose, in a fixed order ("+" before "-").
// visit returns false to stop. complete: false where a GROUP was searched and not enumerated, or the cap of 4096 was
// reached. The state ends at the configuration it had. Returns YK_OK or YK_NO_ASSEMBLY.
YK_API YkStatus yk_state_each(YkState *state, bool (*visit)(void *context, YkState *state), void *context,
                              bool *complete);

// The branch of a block: the sign of its determinant, +1, -1, or 0 where the block has none.
YK_API int yk_state_branch(const YkState *state, size_t block);
YK_API void yk_state_set_branch(YkState *state, size_t block, int branch);
// "A+ C-": every block with a branch; returns the length needed.
YK_API size_t yk_state_label(const YkState *state, char *text, size_t capacity);

// Answers. Indices as in the model and the mechanism.
YK_API bool yk_state_has_pose(const YkState *state); // false until it was assembled
YK_API bool yk_state_has_rates(const YkState *state);
YK_API YkMotion yk_state_coordinate(const YkState *state, size_t coordinate);
YK_API YkMotion yk_state_body(const YkState *state, size_t body); // angle to the ground
YK_API YkPointMotion yk_state_point(const YkState *state, size_t point);
YK_API double yk_state_channel(const YkState *state, YkChannel channel);
// Transmission angle of a block, rad in [0, pi/2]: between the two directions in which its dyad is closed; its sine is
// the block's determinant over the product of its column lengths. 0 at a dead point.
YK_API double yk_state_transmission(const YkState *state, size_t block);

// How well it closes: the largest residual of all loop equations over the machine's size, of J q' + Phi_t, and of
// J q'' + gamma over the largest term; measured in the loops of the tree, not in the steps that solved it.
typedef struct YkResiduals {
    double position, velocity, acceleration;
} YkResiduals;
YK_API YkResiduals yk_state_residuals(const YkState *state);

// What went wrong in the last assemble or solve: where, by how much. joint, block = -1 where none.
typedef struct YkReport {
    YkStatus status;
    int block, joint;
    double gap;         // by how many metres the loop misses (NO_ASSEMBLY, LIMIT)
    double determinant; // of the worst block, over the product of its column lengths (SINGULAR)
    char message[240];  // one sentence, naming joint and loop
} YkReport;
YK_API const YkReport *yk_state_report(const YkState *state);

#endif
