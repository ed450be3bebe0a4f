// Centrodes: the paths of the instant centre of two bodies on each of them, which roll on each other in the motion.
#ifndef YOKE_CENTRODES_H
#define YOKE_CENTRODES_H

#include <yoke/state.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct YkCentrodePoint {
    bool exists;     // false: at infinity, or the velocities are not determined there
    double input;    // rad or m
    double at[2];    // the instant centre in the world, m
    double on[2][2]; // in the axes of the first and of the second body, m
} YkCentrodePoint;

typedef struct YkCentrodes YkCentrodes;
// Follows the instant centre of two bodies through a cycle of the machine's one input, from the pose of `state`: once
// round, or through most of the range in which it closes. `steps`: of the cycle. Returns NULL with a problem added if
// the machine has not one freedom, if both bodies are the same, or when out of memory. Cost: a verified move for each
// step.
YK_API YkCentrodes *yk_centrodes_new(const YkState *state, size_t first, size_t second, size_t steps,
                                     YkProblems *problems);
YK_API void yk_centrodes_free(YkCentrodes *centrodes);
YK_API size_t yk_centrodes_body(const YkCentrodes *centrodes, size_t side); // side: 0 or 1
YK_API bool yk_centrodes_are_closed(const YkCentrodes *centrodes);          // after the last point comes the first
YK_API size_t yk_centrodes_count(const YkCentrodes *centrodes);
YK_API YkCentrodePoint yk_centrodes_point(const YkCentrodes *centrodes, size_t index);

#ifdef __cplusplus
}
#endif

#endif
