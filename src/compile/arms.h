// The arms of a dyad: everything in their lengths that takes a root or a division, computed once for all poses if the
// arms are constant.
#ifndef COMPILE_ARMS_H
#define COMPILE_ARMS_H
#include <stdbool.h>
#include "base/vec.h"

// For the two arms U, W of an RRR dyad.
typedef struct YkArmPair {
    double outer, inner, product; // (U+W)^2, (U-W)^2, (U+W) (U-W)
    double scale, rectangle;      // 1 / (4 U^2 W^2), U W
    double share;                 // of a margin: yk_arm_share of the shorter arm
    YkVec inverse_U, inverse_W;   // 1 / U, 1 / W as complex numbers
} YkArmPair;

// For the arm W of an RRP dyad: its circle, and the factors that turn a vector of the circle back to e^(i Phi).
typedef struct YkArmCircle {
    double radius, inverse_square, share;
    YkVec inverse;
} YkArmCircle;

// Returns whether a constant vector points along x (is a real number), as for most points and slides.
static inline bool yk_is_axial(YkVec v)
{
    return v.y == 0;
}

// Returns 1 / a, as a complex number.
static inline YkVec yk_vec_inverse(YkVec a)
{
    return yk_scale(1 / yk_dot(a, a), yk_conj(a));
}

// The angle of a constant arm counts as well known from a thousandth of the machine's size (this is 1 over its square);
// that of an arm which varies, and may vanish on the way, from the size itself.
#define YK_PER_ARM_ENOUGH2 1e6

// Returns the factor by which its length reduces an arm's margin: (length / enough)^2; 1 if it is long enough.
// per_enough2: 1 / enough^2, or 0 if nothing is known of the machine.
static inline double yk_arm_share(double square, double per_enough2)
{
    double share = square * per_enough2;
    return share < 1 && per_enough2 > 0 ? share : 1;
}

static inline YkArmPair yk_arm_pair(YkVec U, YkVec W, double U_per_enough2, double W_per_enough2)
{
    double U2 = yk_dot(U, U), W2 = yk_dot(W, W), sum = sqrt(U2) + sqrt(W2), difference = sqrt(U2) - sqrt(W2);
    double U_share = yk_arm_share(U2, U_per_enough2), W_share = yk_arm_share(W2, W_per_enough2);
    return (YkArmPair){.outer = sum * sum,
                       .inner = difference * difference,
                       .product = sum * difference,
                       .scale = 1 / (4 * U2 * W2),
                       .rectangle = sqrt(U2 * W2),
                       .share = U_share < W_share ? U_share : W_share,
                       .inverse_U = yk_vec_inverse(U),
                       .inverse_W = yk_vec_inverse(W)};
}

static inline YkArmCircle yk_arm_circle(YkVec W, double per_enough2)
{
    double square = yk_dot(W, W), inverse = 1 / square;
    return (YkArmCircle){sqrt(square), inverse, yk_arm_share(square, per_enough2), yk_scale(inverse, yk_conj(W))};
}

#endif
