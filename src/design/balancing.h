// The inside of balancing: a cycle of poses, and the engine's answers at each.
#ifndef DESIGN_BALANCING_H
#define DESIGN_BALANCING_H
#include <yoke/balancing.h>
#include "base/text.h"
#include "loads/loads.h"

enum { YK_WEIGHTS_MAX = 16 };

// A cycle of the input, `count` poses: round until everything repeats, or most of the way between its limits.
typedef struct YkCycle {
    double from, step, rate;
    size_t count;
    size_t turns;     // 0: not round
    bool repeats;     // after these turns; otherwise nothing does within YK_TURNS_MAX, and one turn is taken
    YkLawWatch *laws; // that looks at each pose whose peaks are measured, or NULL
} YkCycle;
enum { YK_TURNS_MAX = 12 };

struct YkBalancing {
    YkCounterweight weight[YK_WEIGHTS_MAX];
    size_t count;
    bool is_full;
    YkShakingPeaks before, after;
    YkShakingOrder order[2][YK_SHAKING_ORDERS]; // before and after
    size_t turns;
    double flywheel;
    YkText model;
};

// Finds the cycle: one turn, or the way between limits. Returns YK_BAD_ARGUMENT if there is none.
YkStatus yk_cycle_find(const YkState *state, size_t steps, YkCycle *cycle);
// Makes a turn as many turns as the machine and its efforts need to repeat: two for a four-stroke engine.
YkStatus yk_cycle_repeat(const YkState *state, YkCycle *cycle);
// Moves a state to pose k of the cycle, at its rate. Returns its status.
YkStatus yk_cycle_pose(const YkCycle *cycle, YkState *state, size_t k);
// Measures shaking over the cycle. torques[count], forces[count] (or NULL) receive the input's effort and the force.
YkStatus yk_cycle_peaks(const YkCycle *cycle, const YkState *state, YkShakingPeaks *peaks, double *torques,
                        YkVec *forces);
// Finds the parts of the force by order.
void yk_cycle_orders(const YkCycle *cycle, const YkVec *forces, YkShakingOrder order[YK_SHAKING_ORDERS]);
// Returns the energy that flows in and out of the machine about a steady torque, J.
double yk_cycle_swing(const YkCycle *cycle, const double *torques);

// Finds what inertia does to the frame at a pose: its force, and its moment about the input's pivot.
YkVec yk_cycle_shaking(const YkState *state, double *moment);
YkVec yk_cycle_pivot(const YkState *state); // the input's in the world, or the origin

// balancing_weights.c: finds the counterweights.
YkStatus yk_balancing_weigh(const YkCycle *cycle, const YkState *state, YkBalancing *balancing);
// Returns how far the counterweight of a body lies from its pin: half as far as its farthest point.
double yk_balancing_radius(const YkModel *model, size_t joint, size_t body, double size);
// balancing_compromise.c: finds the counterweights for weights of force, moment and effort. torques: the effort before.
YkStatus yk_balancing_compromise(const YkCycle *cycle, const YkState *state, const double *torques,
                                 const double weight[3], YkBalancing *balancing);
// balancing_model.c: adds the model of the state with the counterweights as text. False when it cannot be written.
bool yk_balancing_write(const YkModel *model, YkBalancing *balancing);

#endif
