// Plane vectors and rotations, as complex numbers: x + iy.
#ifndef BASE_VEC_H
#define BASE_VEC_H
#include <math.h>
#include "elementary/elementary.h"

typedef struct YkVec {
    double x, y;
} YkVec;

#define YK_PI 3.14159265358979323846

static inline YkVec yk_vec(double x, double y)
{
    return (YkVec){x, y};
}
static inline YkVec yk_add(YkVec a, YkVec b)
{
    return yk_vec(a.x + b.x, a.y + b.y);
}
static inline YkVec yk_sub(YkVec a, YkVec b)
{
    return yk_vec(a.x - b.x, a.y - b.y);
}
static inline YkVec yk_scale(double k, YkVec a)
{
    return yk_vec(k * a.x, k * a.y);
}
static inline YkVec yk_mul(YkVec a, YkVec b)
{
    return yk_vec(a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x);
} // turns and stretches
static inline YkVec yk_conj(YkVec a)
{
    return yk_vec(a.x, -a.y);
}
static inline YkVec yk_quarter(YkVec a)
{
    return yk_vec(-a.y, a.x);
} // i a: turns by 90 deg
static inline double yk_dot(YkVec a, YkVec b)
{
    return a.x * b.x + a.y * b.y;
}
static inline double yk_cross(YkVec a, YkVec b)
{
    return a.x * b.y - a.y * b.x;
}
static inline double yk_norm(YkVec a)
{
    return yk_hypot(a.x, a.y);
}
// Returns the angle from x to a, rad, in (-pi, pi].
static inline double yk_argument(YkVec a)
{
    return yk_atan2(a.y, a.x);
}
static inline YkVec yk_unit(double angle)
{
    YkVec e;
    yk_sincos(angle, &e.y, &e.x);
    return e;
}
// Returns the angle nearest to `reference` that equals `angle` up to whole turns.
static inline double yk_nearest_turn(double angle, double reference)
{
    double off = angle - reference;
    return fabs(off) < YK_PI ? angle : angle - 2 * YK_PI * rint(off / (2 * YK_PI));
}
static inline YkVec yk_divide(YkVec a, YkVec b)
{
    return yk_scale(1 / yk_dot(b, b), yk_mul(a, yk_conj(b)));
}

#endif
