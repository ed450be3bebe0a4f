// A four-bar or a slider-crank on the ground of any machine, at its present pose.
#ifndef SYNTHESIS_LINKAGE_H
#define SYNTHESIS_LINKAGE_H
#include "compile/mechanism.h"
#include "solve/state.h"
#include "synthesis/design.h"

typedef struct YkLinkage {
    int32_t input, coupler, output; // bodies; the slider for a slider-crank (YK_NONE for a pin in a slot)
    YkVec A0, A, B, B0;             // world, m; slider-crank: B0 is a point of the line
    YkVec along;                    // slider-crank: unit direction of the line
    bool is_slider;
} YkLinkage;

// Returns where a point of a body, given in its axes, is in the world.
YkVec yk_linkage_place(const YkState *state, int32_t body, YkVec at);
// Finds the first one whose coupler has a point that is not one of its joints (`point`, or any: YK_NOT_FOUND). Returns
// the point, or YK_NOT_FOUND if there is none, or when out of memory (*ran_out).
size_t yk_linkage_find(const YkState *state, size_t point, YkLinkage *ring, bool *ran_out);

#endif
