// The inside of YkState.
#ifndef SOLVE_STATE_H
#define SOLVE_STATE_H
#include <yoke/state.h>
#include <string.h>
#include "base/archive.h"
#include "base/memory.h"
#include "base/pace.h"
#include "solve/run.h"

typedef struct YkPhase { // of an input that has made many turns: stands for `angle` as long as the input has this value
    double value, angle;
} YkPhase;

// A witness follows the motions of a state, or of a simulation. A YkCertifier begins with one.
typedef enum YkWitnessed {
    YK_WITNESS_STEP, // the next verified pose of the motion
    YK_WITNESS_TRY,  // the same, but if the way to it is refuted it does not count
    YK_WITNESS_ASIDE // a pose between the last two steps: a row, after other such poses. The next step goes on from the last one
} YkWitnessed;
typedef struct YkWitness {
    void (*begin)(struct YkWitness *witness, const YkState *state); // where a motion begins
    // At a pose of the motion. Returns false if it is proved that the motion cannot have come there.
    bool (*step)(struct YkWitness *witness, const YkState *state, YkWitnessed kind);
    // The motion goes on with a state of another mechanism of the same model, at the same pose. `from` is the state
    // before it; NULL: it begins there. `to` NULL: that mechanism is gone.
    void (*change)(struct YkWitness *witness, const YkState *from, const YkState *to);
    // Remembers what it has received so far, under a number; and goes back to it, for another try.
    void (*keep)(struct YkWitness *witness, size_t number);
    void (*recall)(struct YkWitness *witness, size_t number);
} YkWitness;

struct YkState {
    const YkMechanism *mech;
    YkArena *arena;             // holds what follows, and the search
    YkSpace space, spare;       // the last valid pose; the trial pose
    double *input;              // [3 * input + k]
    const double **input_lanes; // pointers to the same, for the runner
    double *valid_input;        // inputs at the valid pose
    double *held;               // [3 * input + k]: replaces a drive's value if is_held
    bool *is_held;
    YkPhase *phases;        // [input]
    bool has_phases;        // some input has had a phase
    double *reference;      // per coordinate: its angle is taken nearest to this
    double *slot_reference; // [mech->reference_count]: the same for orientations from which relations start
    double *guess;          // per coordinate, from `start:`
    bool *is_guessed;
    signed char *branch; // per block; 0 if it has none
    YkGroupWork groups;
    double *valid_x; // group columns at the valid pose
    // Where the last motion ended: at a change point the branches are those of the side it came from.
    double *arrival, *heading;         // [input]: the inputs there, and the direction in which they moved; 0: unknown
    double arrival_time, time_heading; // the same of time, if the pose was reached over time
    double time;
    bool has_pose, has_rates;
    bool
        is_regular; // only the kept equations are singular, or nearly: pose and rates come from all loops (all_loops.c)
    double *all_loops; // room for that; NULL if it cannot be
    bool
        is_clear; // a change point is close, and rates that rounding would spoil come from poses beside it (sweep/blur.c)
    bool is_kept; // at a coincidence: the last pose has angles that no loop determines, kept from the pose before it
    YkReport report;
    YkWitness *witness; // or NULL
    // assembling: see assemble.c
    struct YkSearch *search;
    // long calls: see long_call.c
    YkPace *pace; // of the one that is being worked for, this state's own or another's; NULL outside of them
    YkPace own_pace;
    YkProgress progress;    // who watches the state's own calls
    struct YkState *before; // the state before such a call; NULL unless somebody watches
};

// Begins a long call on a state; returns whether it is one of its own, for which `progress` is asked. Otherwise it is
// part of another call, or no caller watches. From here until yk_state_end solutions fail with YK_STOPPED once the
// caller has said so; the call may then end with whatever it finds.
bool yk_state_begin(YkState *state);
// Ends it. Returns the status; YK_STOPPED if it was stopped, and then, if the call is its own, the state stands where
// it stood before.
YkStatus yk_state_end(YkState *state, bool is_own, YkStatus status);
// Lets a state work for a call that began elsewhere; NULL: no longer.
void yk_state_lend(YkState *state, YkPace *pace);
static inline bool yk_state_is_stopped(const YkState *state)
{
    return yk_pace_is_stopped(state->pace);
}
// Counts the work of running steps. Returns whether to go on.
static inline bool yk_state_spend(YkState *state, size_t steps)
{
    enum { STEP = 40 }; // one step and its judgement
    return yk_pace_spend(state->pace, STEP * (steps + 1));
}

// Lets the runner read phases in place of the angles of inputs that have one.
void yk_state_place_phases(YkState *state);

static inline YkRun yk_state_run(YkState *state, const YkSpace *space)
{
    if (state->has_phases) yk_state_place_phases(state);
    return (YkRun){state->mech,    space, state->input_lanes,    state->branch,
                   &state->groups, 1,     state->slot_reference, NULL,
                   NULL,           NULL};
}

// Tolerances, in one place.
#define YK_CLOSING_TOLERANCE 1e-12 // over the size: a loop that misses by no more counts as closed
#define YK_LIMIT_MARGIN (-1e-13)   // a smaller sin^2 does not close; between this and 0 it is rounding at a limit
#define YK_SINGULAR_MARGIN                                                                                             \
    1e-14                    // sin^2 at most this: a dead point (sin <= 1e-7: velocities would have two digits left)
#define YK_NEAR_MARGIN 4e-6  // sin^2 below which rounding costs accelerations more than half their digits
#define YK_FORCE_MARGIN 1e-7 // sin^2 below which forces may be blurred
#define YK_BLUR_MARGIN 1e-9  // the same for accelerations, see yk_is_blurred

// Returns how far a redundant loop may miss, m: near a dead point the dyads before it are known only to rounding /
// sine.
static inline double yk_gap_tolerance(const YkMechanism *mech, double margin)
{
    return mech->size * (YK_CLOSING_TOLERANCE + 4e-16 / sqrt(fmax(margin, YK_SINGULAR_MARGIN)));
}

// Returns whether rounding spoils the accelerations of a block in the space. Near a limit they grow as fast as their
// errors do; near a change point, or where a base vanishes, they stay bounded, and errors exceed them long before the
// margin shows it.
bool yk_is_blurred(const YkMechanism *mech, const YkSpace *space);
// Returns whether rounding spoils the forces at the pose: of its accelerations they have the errors over the sine once
// more.
bool yk_state_blurs_forces(const YkState *state);
// Returns whether a margin could reach zero between its three samples. It cannot if it stays well above its own
// variation, nor if it is zero at an end and rises from there like a parabola or a line.
static inline bool yk_margin_may_vanish(double a, double m, double b)
{
    double least = fmin(a, fmin(m, b)), most = fmax(a, fmax(m, b));
    if (a <= YK_SINGULAR_MARGIN || b <= YK_SINGULAR_MARGIN) return m < 0.1 * most;
    return least < 0.2 * (most - least);
}

// Returns whether the pose has the present inputs, with their rates.
static inline bool yk_state_is_up_to_date(const YkState *state)
{
    size_t bytes = 3 * state->mech->input_count * sizeof *state->input;
    return bytes == 0 || memcmp(state->input, state->valid_input, bytes) == 0;
}

// Returns whether the rates of the pose are limits of the motion that led there, at a change point (sweep/limits.c). A
// new solution at the same inputs has none.
static inline bool yk_state_has_limits(const YkState *state)
{
    return state->has_rates && state->report.status == YK_CHANGE_POINT && yk_state_is_up_to_date(state);
}

// Solves at the present inputs, unless the pose has them and clearer rates than a solution would give.
static inline YkStatus yk_state_solve_unless_clear(YkState *state)
{
    return state->is_clear && yk_state_is_up_to_date(state) ? state->report.status : yk_state_solve(state);
}

// Returns sin^2 below which a single state does more about a pose than run its blocks.
static inline double yk_state_close_margin(const YkState *state)
{
    return state->all_loops ? YK_NEAR_MARGIN : YK_BLUR_MARGIN;
}

// Returns the status of the space: OK, REDUNDANT, SINGULAR, LIMIT (a block does not close) or NO_ASSEMBLY (a redundant
// loop gapes).
YkStatus yk_state_judge(const YkState *state, const YkSpace *space);
// Fills the report for a status: only the status if all is well.
void yk_state_explain(YkState *state, const YkSpace *space, YkStatus status);
static inline void yk_state_tell(YkState *state, const YkSpace *space, YkStatus status)
{
    YkReport *report = &state->report;
    report->status = status;
    report->block = report->joint = -1;
    report->gap = report->determinant = 0;
    report->message[0] = 0;
    if (status != YK_OK && status != YK_REDUNDANT) yk_state_explain(state, space, status);
}
// Fills the report of a request that is refused, or given up, whatever the blocks do: only why. Returns the status.
YkStatus yk_state_refuse(YkState *state, YkStatus status, const char *message);
// Takes the inputs, branches, reference angles and guesses of a state of another mechanism with the same plan (a
// variant); also the pose if it is the same mechanism.
void yk_state_take(YkState *to, const YkState *from);
// Writes a state, or reads it into one of the same mechanism: it goes on with the same bits.
void yk_state_archive(YkState *state, YkArchive *archive);
void yk_report_archive(YkReport *report, const YkMechanism *mech, YkArchive *archive);
// Writes the label of the state in place of the text.
void yk_state_write_label(const YkState *state, YkText *text);
// Makes the spare space the pose.
void yk_state_accept(YkState *state);
// Makes the present angles the reference for the next.
void yk_state_refer(YkState *state);
// Returns the residual of positions alone, as yk_state_residuals does.
double yk_state_gap(const YkState *state);
// Reads coordinate angles and distances directly from a space.
YkMotion yk_coordinate_in(const YkState *state, const YkSpace *space, size_t coordinate);

#endif
