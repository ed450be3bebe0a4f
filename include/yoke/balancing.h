// Balancing: counterweights that keep a machine's centre of mass still, and the flywheel that evens out its torque.
#ifndef YOKE_BALANCING_H
#define YOKE_BALANCING_H

#include <yoke/dynamics.h>
#include <yoke/laws.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct YkBalancingOptions {
    size_t steps;       // poses of a turn of the input, or of its way, default 360, at least 48
    double fluctuation; // of the speed, (largest - least) / mean: for the flywheel; default 0.05
    // How much shaking force, shaking moment and input effort count in a compromise, each relative to its root mean
    // square before. All 0, the default: the force alone, which is balanced in full if counterweights can do it.
    double weight[3];
    YkLawWatch *laws; // of the state's model; looks at the cycle's poses, each at its input's position. NULL: no watch
} YkBalancingOptions;
YK_API YkBalancingOptions yk_default_balancing_options(void);

// Peaks over the cycle: the force on the frame (N) and its moment about the input's pivot (N m), both of inertia alone;
// the input's effort (N m or N), of everything in the file.
typedef struct YkShakingPeaks {
    double force, moment, torque;
} YkShakingPeaks;

// A part of the shaking force: at `order` times the rate of the input one part turns with the input and another
// against it; together they draw an ellipse. A counterweight on the input's body changes only the part of the first
// order that turns with it; the other parts need weights on wheels that turn at their rate (Lanchester's balancer).
typedef struct YkShakingOrder {
    double with, against; // N
    double direction;     // of the ellipse's long axis, of length with + against, in the world, rad
} YkShakingOrder;
enum { YK_SHAKING_ORDERS = 6 };

// A counterweight on a body: its mass times its distance from the body's pivot, and its direction in the body's axes.
typedef struct YkCounterweight {
    size_t body;
    size_t joint;   // the pin about which it is measured
    double product; // kg m
    double angle;   // rad
    double mass;    // kg, as written into the model: at `radius`, m
    double radius;
} YkCounterweight;

typedef struct YkBalancing YkBalancing;
// Finds counterweights: on the bodies pinned to the ground and, if these do not suffice, on others. The state is
// solved and has one input; its rate, or 1 if that is 0, is the rate of the cycle. The counterweights are a
// least-squares fit over the cycle's poses, which is exact if a full balance of force exists. With weights, only bodies
// pinned to the ground get counterweights, and these minimise the weighted sum of mean squares. Returns NULL with a
// problem added if the machine has no masses or not one freedom, or when out of memory. Source: Berkof & Lowen 1969
// (four-bars); Tepper & Lowen 1972 (when a full balance exists).
YK_API YkBalancing *yk_balancing_new(const YkState *state, const YkBalancingOptions *options, YkProblems *problems);
YK_API void yk_balancing_free(YkBalancing *balancing);
YK_API bool yk_balancing_is_full(const YkBalancing *balancing); // the centre of mass stands still
YK_API size_t yk_balancing_count(const YkBalancing *balancing);
YK_API YkCounterweight yk_balancing_at(const YkBalancing *balancing, size_t index);
YK_API YkShakingPeaks yk_balancing_before(const YkBalancing *balancing);
YK_API YkShakingPeaks yk_balancing_after(const YkBalancing *balancing); // as the engine measures the model below
// Returns the part of the shaking force of an order, 1 to YK_SHAKING_ORDERS, for the file's machine or with the
// counterweights. NaN for any other order, and if yk_balancing_turns is 0.
YK_API YkShakingOrder yk_balancing_order(const YkBalancing *balancing, size_t order, bool with_counterweights);
// Returns the number of turns of the input after which the machine and its efforts repeat: 2 for a four-stroke engine.
// Returns 0 if the input does not turn through, or if nothing repeats within 12 turns.
YK_API size_t yk_balancing_turns(const YkBalancing *balancing);
// Returns the moment of inertia of a flywheel on the input, kg m^2, for the machine without its counterweights; NaN if
// yk_balancing_turns is 0.
YK_API double yk_balancing_flywheel(const YkBalancing *balancing);
// Returns the text of the model with its counterweights, which are bodies welded to those that they balance. It belongs
// to the balancing.
YK_API const char *yk_balancing_model(const YkBalancing *balancing);

#ifdef __cplusplus
}
#endif

#endif
