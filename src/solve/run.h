// Runs the compiled steps over lanes.
#ifndef SOLVE_RUN_H
#define SOLVE_RUN_H
#include "solve/group.h"
#include "solve/space.h"

typedef struct YkRun {
    const YkMechanism *mech;
    const YkSpace *space;        // whose lanes are written
    const double *const *inputs; // [3 * input + k]: lanes of position, velocity, acceleration
    const signed char *branch;   // per block
    YkGroupWork *groups;         // for GROUP blocks (one lane only), or NULL
    size_t lanes;
    const double *references; // [mech->reference_count]: references of the angles from which relations start
    const bool *rates_alone;  // [slot]: nothing reads its direction, so lanes need not turn it; or NULL
    const bool *idle;         // [slot]: nothing reads any of it; or NULL
    bool *is_plain;           // whether all inputs of several lanes are numbers, of a machine in which nothing else may
                              // fail: margins are then left alone; or NULL
} YkRun;

// Returns where an input or a relation turns an orientation: without its direction if nothing reads that.
static inline YkTurn yk_run_turn(const YkRun *run, int32_t slot)
{
    YkTurn turn = yk_space_turn(run->space, slot);
    if (run->rates_alone && run->rates_alone[slot]) turn.c = turn.s = NULL;
    return turn;
}

// Returns whether nothing reads what an input or a relation turns.
static inline bool yk_run_is_idle(const YkRun *run, int32_t slot)
{
    return run->idle && run->idle[slot];
}

// Runs steps [from, to). Margins and gaps continue from their present values: call yk_run_begin before step 0.
void yk_run_begin(const YkRun *run);
void yk_run_steps(const YkRun *run, size_t from, size_t to);
// Runs one step by the kernels over lanes.
void yk_run_lanes(const YkRun *run, const YkStep *step);
// Computes a sum over lanes: constant + nodes + turned vectors.
void yk_run_sum(const YkRun *run, const YkSum *sum, YkPlane out);
// Computes the place of a point of the model, after all steps.
void yk_run_point(const YkRun *run, size_t point, YkPlane out);

#endif
