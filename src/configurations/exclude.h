// Finds all poses of a geared group by exclusion: the space of its angles is halved until every box is proved to hold no
// pose, or not more than the one that is found in it.
#ifndef CONFIGURATIONS_EXCLUDE_H
#define CONFIGURATIONS_EXCLUDE_H
#include "configurations/geared.h"

#define YK_EXCLUDE_NEAR 0.02 // rad, or of the machine's size: boxes that are left lie that near to a singular pose

typedef struct YkExcluded { // the array is kept and reused
    double *poses; // [count][columns of the group]: angles, rad, with the turns that the relations want; distances, m
    double *alone; // [count][2 unknowns]: the middle and the half width of a box in which each is the only one
    size_t count, capacity, boxes;
    size_t left;      // boxes within YK_EXCLUDE_NEAR of a singular pose, which may hold poses
    bool is_complete; // there are no poses but these and those in boxes that were left
} YkExcluded;

// Returns false when out of memory. Being stopped by `pace` leaves it incomplete, as do poses that meet and cannot be told apart.
bool yk_exclude(const YkGeared *geared, YkPace *pace, YkExcluded *out);
void yk_excluded_end(YkExcluded *excluded);

#endif
