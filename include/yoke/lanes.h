// Lanes: many copies of one machine that move in time together, several in one SIMD register. For open trees.
#ifndef YOKE_LANES_H
#define YOKE_LANES_H

#include <yoke/simulation.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct YkLanes YkLanes;
// Makes lanes with a simulation's machine, efforts, fixed step and goes_on. Returns NULL if the machine does not fit
// (*fits false), or when out of memory. A machine fits if it is an open tree of pins, slides, pin-slots and welds
// without drives, whose loads are gravity, constant efforts, viscous friction, and linear springs and dampers along
// coordinates; the integrator is YK_INTEGRATOR_RK4. The simulation's mechanism must live as long. Cost O(bodies).
YK_API YkLanes *yk_lanes_new(YkSimulation *simulation, bool *fits);
YK_API void yk_lanes_free(YkLanes *lanes);
// Returns how many inputs a copy has: all its coordinates, as yk_coordinate_info numbers their inputs.
YK_API size_t yk_lanes_input_count(const YkLanes *lanes);

typedef struct YkLanesCase {
    double *const *states;        // [2 * input + k][copy]: position (k = 0) and rate (1) of each input, SI
    const double *const *efforts; // [input][copy], N m or N; a NULL array: the simulation's effort along that input
    double *times;                // [copy], s
    signed char *status;          // [copy]: a copy whose status is below 0 stands still
} YkLanesCase;
// Advances the copies from `from` up to `to` by a span of time, s: in steps of the simulation's length, the last of
// which is cut. A copy that cannot go on keeps its last good state and time, and its status becomes YK_NOT_CONVERGED,
// or YK_BAD_ARGUMENT for an effort that is not finite. Returns the worst status; YK_BAD_ARGUMENT, and nothing changes,
// for a span that is negative, not finite, or beyond 1e14 steps; YK_STOPPED if goes_on ended it. A copy has the same
// bits whatever the others do, and agrees with a single simulation up to rounding. Allocates nothing; each thread needs
// its own lanes.
YK_API YkStatus yk_lanes_step(YkLanes *lanes, const YkLanesCase *asked, size_t from, size_t to, double span);

#ifdef __cplusplus
}
#endif

#endif
