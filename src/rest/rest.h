// The inside of YkRest.
#ifndef REST_REST_H
#define REST_REST_H
#include <yoke/map.h>
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
    bool is_continuous; // meets no force in some direction
    size_t order;       // in which it was found: dyads without mass give several of one energy
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
    size_t *order;
    double force_scale; // the largest acceleration seen: the scale for zero
    double loads;       // what the loads would accelerate at most if none balanced another, 1/s^2 in units of inputs
    bool has_inertia;   // in some pose from which the search started
    bool is_complete;   // all circuits were searched
    bool is_wound;      // the loads of a pose differ a turn later
    bool ran_out;       // of memory, in that search
    const double *row;  // of the map, beside which the state stands; NULL elsewhere
    YkReport lack;      // report of the first such pose without accelerations
};

// Returns the coordinate of a free input.
static inline size_t yk_rest_free_coordinate(const YkRest *rest, size_t k)
{
    return (size_t)rest->mech->inputs[rest->input[k]];
}

#define YK_REST_STARTED 0.05 // share of the whole: compiling, and standing at the start

// search.c: looks for equilibria from the state's pose, along all circuits, and from that many random poses. Returns
// false when out of memory or stopped.
bool yk_rest_search(YkRest *rest, size_t starts);
// descend.c: goes from the pose in rest->q to an equilibrium, whose inputs are then there. Returns false if it comes to
// none.
bool yk_rest_descend(YkRest *rest);
// Keeps the pose in rest->q, an equilibrium, unless it is known. Returns false when out of memory.
bool yk_rest_keep(YkRest *rest);
// circuits.c: maps the motion of a machine with one freedom. Returns NULL for any other, or if it has too many branches
// or cannot be mapped; yk_map_free frees the map.
YkMap *yk_rest_map(YkRest *rest);
// Finds the equilibria on all circuits. Returns false when out of memory or stopped.
bool yk_rest_search_circuits(YkRest *rest, const YkMap *map);

// modes.c: finds accelerations a[f] at rest (rates 0, or `rates`) in the pose with free inputs q. Returns false if it
// does not close.
bool yk_rest_accelerations(YkRest *rest, const double *q, const double *rates, double *a);
// Differentiates the accelerations at q, the state's pose, by the free inputs, f x f: central differences of order 4.
bool yk_rest_differentiate(YkRest *rest, const double *q, double *matrix);
// Finds the accelerations a[2] at h, in units of the only input, on both sides of rest->q. Returns false if it does not
// close there.
bool yk_rest_beside(YkRest *rest, double h, double *a);
// Finds rest->loads in the pose with free inputs rest->q. Returns false if stopped.
bool yk_rest_weigh_loads(YkRest *rest);
// Finds M, C, K, modes and roots at a point whose inputs are in rest->q. False when out of memory or without inertia.
bool yk_rest_linearise(YkRest *rest, YkRestPoint *point);

#endif
