// Moving: takes a machine from its pose to another as the machine itself would get there. No limit is jumped, change
// points are passed in the direction of the motion, and branch and circuit never change unreported.
#ifndef YOKE_MOVE_H
#define YOKE_MOVE_H

#include <yoke/state.h>
#include <yoke/variant.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct YkMoveOptions {
    double turn_max; // largest turn of any body between verified poses, rad (or this times the machine's
                     // size); default 8 deg
    size_t detours;  // number of poses tried for a detour when a limit blocks the straight way of a machine
                     // with several inputs; default 200, 0: none
    bool (*goes_on)(void *context, double part); // called at every verified pose with the part of the way that is
                                                 // done, in [0, 1]; false stops the move there. NULL: never stops
    void *context;
} YkMoveOptions;
YK_API YkMoveOptions yk_default_move_options(void);

enum { YK_MOVE_PASSES = 16 };
typedef struct YkPass { // a change point on the way
    int block;
    double part; // of the way, in [0, 1]
} YkPass;

// The result of a move. `part` is how much of the straight way was done before a limit or change point.
typedef struct YkMove {
    YkStatus status;
    bool is_detour;                // arrived by a detour
    double part;                   // 1 on arrival
    int block;                     // the block that does not close beyond (YK_LIMIT), or -1
    size_t pass_count;             // 0 for a detour
    YkPass passes[YK_MOVE_PASSES]; // the first ones
} YkMove;

// Moves a state that has a pose straight to goal[input_count], in all inputs at once; each ends exactly at its goal.
// Turns are counted; where the motion repeats turn by turn, one turn is followed and the others are counted.
// Returns YK_OK, YK_REDUNDANT, YK_CHANGE_POINT (the rates are limits of the motion that led there, to about 1e-10, and
// are lost when the pose is solved anew), YK_SINGULAR (all arrived), YK_LIMIT, YK_STOPPED, YK_NO_MEMORY,
// YK_BAD_ARGUMENT (no pose, or a goal that is not finite). If it does not arrive, the state is left at the last pose of
// the straight way, and its report says why; stopped by its progress (yk_state_set_progress), it is where it was
// before. move: receives how it went, may be NULL. options: NULL for the defaults. Cost: a solution every few degrees
// of the way, and of as many ways as `detours` says; allocates.
YK_API YkStatus yk_state_move_to(YkState *state, const YkMotion *goal, const YkMoveOptions *options, YkMove *move);
// Moves along the drives from the state's time to `time`, s. Inputs that are held (yk_state_hold_input) or have no
// drive keep their values. Also returns YK_BAD_MODEL if a drive has no value on the way.
YK_API YkStatus yk_state_move_time(YkState *state, double time, const YkMoveOptions *options, YkMove *move,
                                   YkProblems *problems);
// An input that is held at a value: its position (order 0), rate (1) or acceleration (2), in SI units.
typedef struct YkInputHold {
    size_t input;
    int order;
    double value;
} YkInputHold;
// Goes from a state's pose to the one that a request asks for, as every verb of the command does: sets the inputs that
// are held, moves straight to them (yk_state_move_to), then along the drives to `time`, s. `move` has the events of
// both ways, each with its part of its own way. Returns what these return.
YK_API YkStatus yk_state_reach(YkState *state, const YkInputHold *holds, size_t hold_count, double time,
                               const YkMoveOptions *options, YkMove *move, YkProblems *problems);
// Takes the coordinates of another state of the machine as the guesses from which yk_state_assemble chooses.
YK_API YkStatus yk_state_guess(YkState *state, const YkState *from);
// Puts a state in the pose of another one of the same machine whose mechanism was compiled with other inputs: same
// coordinates, with turns counted, at the same time. Inputs take the positions of their coordinates; their rates are
// those of the drives and of `start:`. Returns YK_OK, ...; YK_NO_ASSEMBLY if the pose is not found again; YK_SINGULAR
// if it is a dead point with these inputs, where two branches meet and either may be meant.
YK_API YkStatus yk_state_adopt(YkState *state, const YkState *from);
// Carries the assembly of a state of yk_variant_mechanism(variant) along while the parameters move straight from
// from[count] to to[count], in the order of yk_variant_new, and the inputs from their present values to
// goal[input_count]. The variant ends at `to`. Returns YK_OK, ...; YK_NO_ASSEMBLY if the assembly comes apart on the
// way; YK_BAD_MODEL if the parameters make no valid machine.
YK_API YkStatus yk_state_carry(YkState *state, YkVariant *variant, const double *from, const double *to, size_t count,
                               const YkMotion *goal);
// Takes the branches of a state of a machine with other dimensions, for yk_state_solve to close. Returns YK_OK, or
// YK_BAD_ARGUMENT if the two are not solved in the same dyads, or contain larger groups, whose assembly has no branch
// to carry over.
YK_API YkStatus yk_state_take_labels(YkState *state, const YkState *from);

#ifdef __cplusplus
}
#endif

#endif
