// A group of loops of pinned links and one gear relation between its angles, at a pose.
//
// The relation says that sum p_j Phi_j + C = 0 for angles that count their turns. With whole p_j that have no common
// divisor it can be met by adding turns exactly where the sum is a multiple of 2 pi: so poses are looked for modulo 2 pi.
#ifndef CONFIGURATIONS_GEARED_H
#define CONFIGURATIONS_GEARED_H
#include "configurations/system.h"

enum { YK_GEARED_MAX = 5 }; // unknowns

typedef struct YkGeared {
    YkShape shape; // angles alone; unknowns = 2 loops + 1
    YkVec coefficients[2 * YK_GEARED_MAX * (YK_GEARED_MAX + 1)];
    int ratio[YK_GEARED_MAX]; // p
    double phase;             // C, rad
} YkGeared;

// Reads block `index` of a run whose earlier blocks are solved. Returns false unless it is a group of this kind.
bool yk_geared_read(YkGeared *geared, const YkRun *run, size_t index);
// Adds whole turns to the angles of a pose until the relation is met, as few as possible. Returns false if it takes too many.
bool yk_geared_turn(const YkGeared *geared, double *x);

#endif
