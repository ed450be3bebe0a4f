// The matrix pencil M_0 + h M_1 of a group whose unknown h is hidden.
#ifndef CONFIGURATIONS_PENCIL_H
#define CONFIGURATIONS_PENCIL_H
#include "configurations/eliminate.h"
#include "configurations/hidden.h"

// The exponent of each angle, from -8 to 7, takes four bits; above them stands the distance that is a factor, if any.
typedef uint32_t YkMonomial;

static inline YkMonomial yk_times_angle(YkMonomial m, int angle, int exponent) // angle -1: nothing
{
    return angle < 0 ? m : m + (YkMonomial)exponent * ((YkMonomial)1 << 4 * angle);
}

typedef struct YkPencil {
    const YkHidden *hidden;
    YkMonomial monomials[YK_ELIMINATION_MOST]; // of the columns
    size_t count;
    YkVec M[2][YK_ELIMINATION_MOST * YK_ELIMINATION_MOST]; // [count][count]
} YkPencil;

typedef enum YkPencilStatus { YK_PENCIL_MADE, YK_PENCIL_NONE, YK_PENCIL_NO_MEMORY } YkPencilStatus;

// Makes the pencil. Its rows are random combinations (of a fixed seed) of all combinations of the equations in which
// these monomials alone are left. NONE: there are fewer than monomials, or more monomials than C(8, 4).
YkPencilStatus yk_pencil_make(YkPencil *pencil, const YkHidden *hidden);
// Returns the column of a monomial, or -1.
int yk_pencil_column(const YkPencil *pencil, YkMonomial monomial);

#endif
