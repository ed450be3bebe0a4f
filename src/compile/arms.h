// What the lengths of a dyad's arms give, once and for all poses where the arms are constant: whatever takes a root or
// a division.
#ifndef COMPILE_ARMS_H
#define COMPILE_ARMS_H
#include <stdbool.h>
#include "base/vec.h"

// Of the two arms U, W of an RRR dyad.
typedef struct YkArmPair {
    double outer, inner, product; // (U+W)^2, (U-W)^2, (U+W) (U-W)
    double scale, rectangle;      // 1 / (4 U^2 W^2), U W
    YkVec inverse_U, inverse_W;   // 1 / U, 1 / W as complex numbers
} YkArmPair;

// Of the arm W of an RRP dyad: its circle, and what turns a vector of the circle back to e^(i Phi).
typedef struct YkArmCircle {
    double radius, inverse_square;
    YkVec inverse;
} YkArmCircle;

typedef union YkArms {
    YkArmPair pair;
    YkArmCircle circle;
} YkArms;

// Whether a constant vector points along x (is a real number), as most points and slides do.
static inline bool yk_is_axial(YkVec v)
{
    return v.y == 0;
}

// 1 / a, as a complex number.
static inline YkVec yk_vec_inverse(YkVec a)
{
    return yk_scale(1 / yk_dot(a, a), yk_conj(a));
}

static inline YkArmPair yk_arm_pair(YkVec U, YkVec W)
{
    double U2 = yk_dot(U, U), W2 = yk_dot(W, W), sum = sqrt(U2) + sqrt(W2), difference = sqrt(U2) - sqrt(W2);
    return (YkArmPair){sum * sum,     difference * difference, sum * difference, 1 / (4 * U2 * W2),
                       sqrt(U2 * W2), yk_vec_inverse(U),       yk_vec_inverse(W)};
}

static inline YkArmCircle yk_arm_circle(YkVec W)
{
    double square = yk_dot(W, W), inverse = 1 / square;
    return (YkArmCircle){sqrt(square), inverse, yk_scale(inverse, yk_conj(W))};
}

#endif
