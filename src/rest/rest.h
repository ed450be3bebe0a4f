// The inside of YkRest.
#ifndef REST_REST_H
#define REST_REST_H
#include <yoke/rest.h>
#include "dynamics/dynamics.h"

typedef struct YkRestPoint {
    double *inputs;                     // [3 * input]
    signed char *branch;                // per block
    double *coordinates;                // per coordinate: its value
    double *mass, *damping, *stiffness; // f x f
    double *shape, *frequency, *ratio;  // [mode][f], [mode], [mode]
    double *real, *imaginary;           // 2 f
    YkEquilibrium at;
} YkRestPoint;

struct YkRest {
    YkArena *arena;
    YkMechanism *mech;
    YkState *state;
    YkDynamics *dynamics;
    YkProgress progress;
    YkPace *pace; // of the call that is running
    double time;
    const YkState *pose; // owned by the caller, or NULL
    size_t freedom;
    int32_t *input; // the free ones
    YkRestPoint *points;
    size_t count, capacity;
    size_t of_start;                                 // how many of them (0 or 1) belong to `start:`
    double *q, *a, *jacobian, *step, *trial, *scale; // scratch
    int *pivot;
    double force_scale; // the largest acceleration seen: the scale for zero
    bool has_inertia;   // in some pose from which the search started
    YkReport lack;      // report of the first such pose without accelerations
};

// Finds accelerations a[f] at rest (rates 0, or `rates`) in the pose with free inputs q. Returns false if it does not
// close.
bool yk_rest_accelerations(YkRest *rest, const double *q, const double *rates, double *a);
// Differentiates the accelerations by the free inputs (or, of_rates, by their rates), f x f: central differences of
// order 4.
bool yk_rest_differentiate(YkRest *rest, const double *q, bool of_rates, double *matrix);
// Finds M, C, K, modes and roots at a point whose inputs are in rest->q. False when out of memory or without inertia.
bool yk_rest_linearise(YkRest *rest, YkRestPoint *point);

#endif
