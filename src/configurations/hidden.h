// A group's system with one unknown hidden, as elimination needs it: linear in the hidden h with constant coefficients.
//
// If there are slides the hidden unknown is the distance of one, along a line that is made known: where it turns with
// an angle z_j, everything is seen from the body that carries it. All loops are divided by z_j, so that 1 / z_j and the
// constants change places, and known lines turn with 1 / z_j. Otherwise, and where these do not lead to all solutions,
// it is an angle with which no line turns, z_h in the loops and 1 / z_h in their conjugates.
#ifndef CONFIGURATIONS_HIDDEN_H
#define CONFIGURATIONS_HIDDEN_H
#include "configurations/system.h"

typedef struct YkHidden {
    size_t loops, angles, slides; // without the hidden one
    int turning[2 * YK_SYSTEM_LOOPS_MAX];
    // Those of loops, then of conjugates: [2 loops][angles + slides + 1], the constants last; and the factors of h.
    YkVec coefficients[2 * YK_SYSTEM_LOOPS_MAX * 2 * YK_SYSTEM_LOOPS_MAX], times[2 * YK_SYSTEM_LOOPS_MAX];
    bool is_angle;                           // the hidden one
    size_t hidden;                           // its unknown in the shape
    int seen_from;                           // the angle by which the loops are divided, or -1
    size_t unknown[2 * YK_SYSTEM_LOOPS_MAX]; // of the shape
} YkHidden;

// Hides the unknown with this number among those that can be hidden. Returns false if there are fewer.
bool yk_hide(YkHidden *hidden, const YkShape *shape, const YkVec *coefficients, size_t number);
// Writes the unknowns x of the shape from the values of h and of the other angles; finds the distances by least
// squares. Returns false if they are not determined.
bool yk_hidden_restore(const YkHidden *hidden, YkVec h, const YkVec *angles, YkVec *x);

#endif
