// The six names of a linkage in Alt's problem.
//
// Roberts' third fixed pivot c makes with a and b a triangle similar to the coupler's, the coupler point in the place
// of c. The cognate on a and c has as dyads the parallelogram's other side, a - x, at a, and z at c.
#include <string.h>
#include "synthesis/nine_points/alt.h"

void yk_alt_swap(const YkVec *x, YkVec *swapped)
{
    memcpy(swapped, x + YK_ALT_DYAD, YK_ALT_DYAD * sizeof *x);
    memcpy(swapped + YK_ALT_DYAD, x, YK_ALT_DYAD * sizeof *x);
}

void yk_alt_cognate(const YkVec *x, YkVec *cognate)
{
    for (size_t hat = 0; hat < YK_ALT_DYAD; hat += YK_ALT_X_HAT) {
        const YkVec *one = x + hat, *two = one + YK_ALT_DYAD;
        YkVec *to = cognate + hat, inverse = yk_inverse(yk_sub(two[YK_ALT_X], one[YK_ALT_X]));
        YkVec turned = yk_sub(yk_mul(one[YK_ALT_A], two[YK_ALT_X]), yk_mul(two[YK_ALT_A], one[YK_ALT_X]));
        YkVec back = yk_sub(one[YK_ALT_A], one[YK_ALT_X]);
        to[YK_ALT_X] = back;
        to[YK_ALT_A] = one[YK_ALT_A];
        to[YK_ALT_DYAD + YK_ALT_X] = yk_mul(yk_mul(back, two[YK_ALT_X]), inverse);
        to[YK_ALT_DYAD + YK_ALT_A] = yk_mul(turned, inverse);
    }
}

void yk_alt_name(size_t name, const YkVec *x, YkVec *named)
{
    YkVec other[YK_ALT_SIZE];
    if (name % 3 == 0) {
        memcpy(other, x, sizeof other);
    } else if (name % 3 == 1) {
        yk_alt_cognate(x, other);
    } else {
        yk_alt_swap(x, named);
        yk_alt_cognate(named, other);
    }
    if (name < 3)
        memcpy(named, other, sizeof other);
    else
        yk_alt_swap(other, named);
}
