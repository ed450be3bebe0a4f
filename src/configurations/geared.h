// A group of loops with gears, belts, racks, cams or laws between its links, or with none, at a pose.
//
// Each relation says that sum p_j Phi_j + sum q_m d_m + law + C = 0 for angles that count their turns; whole turns do
// not change what a law gives. With whole p_j it can be met by adding turns exactly where the sum is a multiple of 2
// pi, if adding turns to all angles gives every combination of whole numbers for the relations: they are combined until
// it does. So poses are looked for modulo 2 pi. A relation without p_j, such as that of a follower that slides, is met
// exactly.
#ifndef CONFIGURATIONS_GEARED_H
#define CONFIGURATIONS_GEARED_H
#include "configurations/system.h"
#include "law/law.h"

enum { YK_GEARED_MAX = 6, YK_GEARED_RELATIONS = 3, YK_GEARED_ROWS = 12 }; // unknowns; relations; equations

// The law of one relation: gain times its value at sum factor_k x_k + offset.
typedef struct YkGearedLaw {
    const YkLaw *law; // NULL: none
    YkLawBound bound;
    double gain, offset, factor[YK_GEARED_MAX]; // of distances over the machine's size
} YkGearedLaw;

typedef struct YkGeared {
    YkShape shape;                        // unknowns <= 2 loops + relations
    size_t relation[YK_GEARED_RELATIONS]; // the mechanism's
    YkVec coefficients[2 * YK_GEARED_MAX * (YK_GEARED_MAX + 1)];
    double radius[2 * YK_GEARED_MAX *
                  (YK_GEARED_MAX + 1)]; // of the coefficients' discs; 0 at a pose, where it is their rounding
    double phase_radius[YK_GEARED_RELATIONS];
    size_t relations, turning;                         // those with p_j come first
    double factor[YK_GEARED_RELATIONS][YK_GEARED_MAX]; // p, whole numbers; q, by the machine's size
    double phase[YK_GEARED_RELATIONS];                 // C, rad; over the machine's size where there is no p_j
    YkGearedLaw laws[YK_GEARED_RELATIONS];
    double share[YK_GEARED_RELATIONS][YK_GEARED_RELATIONS]; // of each relation in every law
    double reach[YK_GEARED_MAX]; // of a distance: the loops allow no more, over the machine's size
    double size;                 // of the machine, m
} YkGeared;

// Reads block `index` of a run whose earlier blocks are solved. Returns false unless it is a group of this kind, with
// distances that its loops bound; some of its equations may repeat others.
bool yk_geared_read(YkGeared *geared, const YkRun *run, size_t index);
// Bounds the distances by the loops, at the coefficients. Returns false if they do not bound all.
bool yk_geared_bound(YkGeared *geared);
// Adds whole turns to the angles of a pose until all relations are met, as few as possible. Returns false if it takes
// too many.
bool yk_geared_turn(const YkGeared *geared, double *x);

#endif
