// Finds all poses of a geared group by exclusion: the space of its angles is halved until every box is proved to hold
// no pose, or not more than the one that is found in it.
#ifndef CONFIGURATIONS_EXCLUDE_H
#define CONFIGURATIONS_EXCLUDE_H
#include "configurations/geared.h"

#define YK_EXCLUDE_NEAR 0.02 // rad, or of the machine's size: boxes that are left lie that near to a singular pose

typedef struct YkExcluded { // the array is kept and reused
    double *poses; // [count][columns of the group]: angles, rad, with the turns that the relations want; distances, m
    double *alone; // [count][2 unknowns]: the middle and the half width of a box in which each is the only one
    size_t count, capacity, boxes;
    size_t left;      // boxes within YK_EXCLUDE_NEAR of a singular pose, which may hold poses
    bool is_complete; // every pose is listed here or lies in one of the boxes that were left
} YkExcluded;

// Returns false when out of memory. It is incomplete if `pace` stops it, or if poses that meet cannot be separated.
bool yk_exclude(const YkGeared *geared, YkPace *pace, YkExcluded *out);
// Coefficients along an interval of a parameter: discs of them in its middle, and of their derivatives all over it;
// those of the loops, then of the phases at [loops (unknowns + 1) 2 + relation (unknowns + 1) + unknowns].
typedef struct YkExclusionPath {
    const YkVec *middle, *rate;
    const double *middle_radius, *rate_radius;
    double half; // of the interval's length
} YkExclusionPath;

// Divides boxes, or the space of all unknowns, over the whole interval; `geared` has the coefficients all over it. A
// box is handed over by its middle and half widths. `judge` gets each box that is proved to hold exactly one pose at
// every parameter of the interval, and returns whether it knows that pose. `keep` gets each box that has become as
// small as `smallest` without being settled: nothing is proved of it, or `judge` did not know its pose.
// Returns false after `most` boxes, when stopped, or when `keep` returns false.
typedef struct YkExclusion {
    bool (*judge)(void *context, const double *at, const double *half);
    bool (*keep)(void *context, const double *at, const double *half);
    void *context;
    YkExclusionPath path;
    const double *boxes; // [count][2][YK_GEARED_MAX]: middles and half widths; NULL: the whole space
    size_t count;
    double smallest;
    size_t most;
} YkExclusion;
bool yk_exclude_over(const YkGeared *geared, YkPace *pace, const YkExclusion *exclusion);
void yk_excluded_end(YkExcluded *excluded);

#endif
