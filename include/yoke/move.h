// Moving: from the pose in which a machine stands to another one, as the machine itself would go there. No limit is
// jumped, a change point is passed in the direction of the motion, and no branch or circuit changes without a word.
#ifndef YOKE_MOVE_H
#define YOKE_MOVE_H

#include <yoke/state.h>
#include <yoke/variant.h>

typedef struct YkMoveOptions {
    double turn_max; // the way is verified at least every so many radians of the body that turns fastest (or this times
                     // the machine's size); default 8 deg
    size_t detours;  // poses by which a way round is tried where a limit blocks the straight way of a machine with
                     // several inputs; default 200, 0: none
    bool (*goes_on)(void *context, double part); // asked at every verified pose with the part of the way that is done,
                                                 // in [0, 1]; false stops the move. NULL: it goes on
    void *context;
} YkMoveOptions;
YK_API YkMoveOptions yk_default_move_options(void);

enum { YK_MOVE_PASSES = 16 };
typedef struct YkPass { // a change point on the way
    int block;
    double part; // of the way, in [0, 1]
} YkPass;

// How a move went. `part` is how much of the straight way was done where a limit or a change point is told.
typedef struct YkMove {
    YkStatus status;
    bool is_detour;                // arrived by a way round
    double part;                   // 1 on arrival
    int block;                     // which does not close beyond (YK_LIMIT), or -1
    size_t pass_count;             // of a detour 0
    YkPass passes[YK_MOVE_PASSES]; // the first of them
} YkMove;

// Moves a state that has a pose straight to goal[input_count], in all inputs at once; each ends exactly at its goal.
// Turns are counted; where the motion repeats itself turn by turn, one turn is followed and the others are counted.
// YK_OK, YK_REDUNDANT, YK_SINGULAR (arrived), YK_LIMIT, YK_STOPPED, YK_NO_MEMORY, YK_BAD_ARGUMENT (no pose, a goal that
// is not finite). Where it did not arrive, the state stands at the last pose of the straight way, and its report says
// why. move: NULL, or how it went. options: NULL for the defaults. Cost: of solving every few degrees of the way, and
// of as many ways as `detours` says; allocates.
YK_API YkStatus yk_state_move_to(YkState *state, const YkMotion *goal, const YkMoveOptions *options, YkMove *move);
// Moves along the drives from the state's time to `time`, s; inputs that are held (yk_state_hold_input) or have no
// drive stay. Also YK_BAD_MODEL, where a drive has no value on the way.
YK_API YkStatus yk_state_move_time(YkState *state, double time, const YkMoveOptions *options, YkMove *move,
                                   YkProblems *problems);
// Takes the coordinates of another state of the machine as the guesses by which yk_state_assemble chooses.
YK_API YkStatus yk_state_guess(YkState *state, const YkState *from);
// Puts a state in the pose of another one of the same machine, whose mechanism was compiled with other inputs: same
// coordinates, turns counted, at the same time. Inputs take the positions of their coordinates; their rates are those
// of the drives and of `start:`. YK_OK, ...; YK_NO_ASSEMBLY where the pose is not found again; YK_SINGULAR where with
// these inputs it is a dead point: two branches meet there, and either may be meant.
YK_API YkStatus yk_state_adopt(YkState *state, const YkState *from);
// Carries the assembly of a state of yk_variant_mechanism(variant) along while the parameters move straight from
// from[count] to to[count], in the order of yk_variant_new, and the inputs from where they stand to goal[input_count].
// The variant ends at `to`. YK_OK, ...; YK_NO_ASSEMBLY where the assembly comes apart on the way, YK_BAD_MODEL where
// the parameters make no machine.
YK_API YkStatus yk_state_carry(YkState *state, YkVariant *variant, const double *from, const double *to, size_t count,
                               const YkMotion *goal);
// Takes the branches of a state of a machine with other dimensions, for yk_state_solve to close. YK_OK, or
// YK_BAD_ARGUMENT where the two are not solved in the same dyads, or in larger groups, which have no branch that
// carries over.
YK_API YkStatus yk_state_take_labels(YkState *state, const YkState *from);

#endif
