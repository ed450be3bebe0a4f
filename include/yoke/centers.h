// Instant centres: for every two bodies the point that moves alike on both, in the order in which Kennedy's theorem
// finds them.
#ifndef YOKE_CENTERS_H
#define YOKE_CENTERS_H

#include <yoke/state.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef enum YkCenterKind {
    YK_CENTER_POINT,
    YK_CENTER_AT_INFINITY, // the bodies slide on each other: `direction` leads to it, across their sliding
    YK_CENTER_UNDEFINED    // the bodies move as one
} YkCenterKind;
typedef enum YkCenterSource {
    YK_CENTER_JOINT,     // a pin or a slide between the two
    YK_CENTER_KENNEDY,   // where two lines meet, each through two centres that are known
    YK_CENTER_VELOCITIES // Kennedy's theorem leads no further here, so it comes from the velocities
} YkCenterSource;
typedef struct YkCenter {
    size_t body[2]; // ascending
    YkCenterKind kind;
    YkCenterSource source;
    double at[2];     // POINT: world, m
    double direction; // AT_INFINITY: rad, in (-pi/2, pi/2]
    size_t by[2];     // KENNEDY: the lines go through the centres of each of these bodies with the two
    size_t joint;     // JOINT
} YkCenter;

typedef struct YkCenters YkCenters;
// Finds all n (n - 1) / 2 centres of the n bodies, in the order in which they are found: those at joints, then those by
// Kennedy's theorem, one after the other. If it stalls, one centre comes from the velocities, and the theorem goes on.
// The state is solved and has rates at its pose; the machine has one input. Returns NULL with a problem added if not.
// Cost O(n^4) at most; at most 200 bodies.
YK_API YkCenters *yk_centers_new(const YkState *state, YkProblems *problems);
YK_API void yk_centers_free(YkCenters *centers);
YK_API size_t yk_centers_count(const YkCenters *centers);
YK_API YkCenter yk_centers_at(const YkCenters *centers, size_t index);
// Returns how many centres came from velocities because Kennedy's theorem stalled; bodies that move as one do not
// count.
YK_API size_t yk_centers_stalled(const YkCenters *centers);

#ifdef __cplusplus
}
#endif

#endif
