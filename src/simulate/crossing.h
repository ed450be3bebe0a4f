// Singular positions that the motion passes, such as a parallelogram flat on the line of its pivots, where two branches
// meet.
//
// There the angle between the two columns of a dyad goes through 0 (or half a turn), smoothly on the branch that
// momentum takes: its sine, with its sign, is the determinant. So the sign at a stage follows from that angle,
// predicted from the last accepted step by its rate and acceleration. Next to the singular position the two unknowns
// are known only to rounding / sine, so accelerations are interpolated between poses before and after it along the
// motion.
#ifndef SIMULATE_CROSSING_H
#define SIMULATE_CROSSING_H
#include "simulate/simulation.h"

#define YK_NEAR_SINE2 0.06 // sin^2 below which a block is watched

typedef struct YkDirection {
    double angle, rate, acceleration;
} YkDirection;

static inline bool yk_has_columns(const YkBlock *block)
{
    return block->kind <= YK_BLOCK_RPR;
}

// column_angles.c: the angle from the block's first column to its second, in the kernels' order; for an RPR its
// substitute.
YkDirection yk_between_columns(const YkRun *run, const YkBlock *block);

static inline double yk_near_angle(const YkNear *near, double ahead) // predicted
{
    return near->angle + ahead * (near->rate + 0.5 * ahead * near->acceleration);
}

// Returns whether the motion begins at a singular position, and has made no step from there.
static inline bool yk_begins_flat(const YkSimulation *sim)
{
    return sim->is_flat && sim->near_time == sim->options.start;
}

// --- guide.c
//
// Drives that alone move the machine may rest, or turn back, so near to a singular position that no prediction shows on
// which side of it they go on. A second state, the guide, follows the drives there as sweeps do.

// Starts it at the state's pose, unless it has begun. Returns false when out of memory.
bool yk_simulation_start_guide(YkSimulation *sim);
// Returns whether the present pose is the same.
bool yk_simulation_agrees_with_guide(YkSimulation *sim);
// Ends the motion at the limit, if any, that the drives are about to reach: steps in time fail a little before it.
void yk_simulation_end_at_limit(YkSimulation *sim);
// Where one drive moves a machine without dry friction near a singular position, puts it in the guide's pose at t, with
// its rates; and finds what power each load and the drive bring there. Return false elsewhere. There must be a guide.
// must_be_sure: only where its rates have lost no digits; otherwise also beside a limit, where the drive turns back
// soon.
bool yk_simulation_stands_with_guide(YkSimulation *sim, double t, bool must_be_sure);
bool yk_simulation_moves_with_guide(YkSimulation *sim, double t, double *dydt, bool must_be_sure);

#endif
