// The angle of a joint from the directions of its bodies.
#ifndef SOLVE_ANGLE_H
#define SOLVE_ANGLE_H
#include "base/vec.h"
#include "elementary/arc.h"

// Returns angle + offset, less whole turns, nearest to the reference.
YK_INLINE double near_reference(double angle, double offset, double reference)
{
    double sum = angle + offset, turns = (sum - reference) * (1 / (2 * YK_PI));
    double k = (turns + YK_TO_INTEGER) - YK_TO_INTEGER;
    return sum - k * (2 * YK_PI);
}

// Returns the angle from a (has_a: not the ground) to b.
YK_INLINE double angle_between(YkVec a, bool has_a, YkVec b, double offset, double reference)
{
    YkVec e = has_a ? yk_mul(b, yk_conj(a)) : b;
    return near_reference(unit_angle(e.y, e.x), offset, reference);
}

#endif
