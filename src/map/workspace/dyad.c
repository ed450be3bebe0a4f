// Dyads over boxes of coefficients: triangles whose sides are known within bounds.
//
// The loop reads a z_1 + b z_2 + c = 0 (two angles), a z + b d + c = 0 (a slide along a known line), a z + b d z + c =
// 0 (a slide along a line that turns) or a d_1 + b d_2 + c = 0 (two slides).
#include "map/workspace/dyad.h"
#include <math.h>

typedef struct Bounds {
    double low, high;
} Bounds;

static Bounds widened(double value, double radius)
{
    double more = radius + 1e-14 * value;
    return (Bounds){fmax(0, value - more), value + more};
}

static YkBall disc(const YkDiscCoefficients *c, size_t k)
{
    return yk_ball(c->at[k], c->radius[k]);
}

static Bounds length_of(YkBall a)
{
    return widened(yk_norm(a.at), a.radius);
}

// Returns bounds of |Im(a conj b)|: of the area that two vectors span.
static Bounds area_of(YkBall a, YkBall b)
{
    YkBall product = yk_ball_mul(a, yk_ball(yk_conj(b.at), b.radius));
    return widened(fabs(product.at.y), product.radius);
}

static Bounds product_of(Bounds a, Bounds b)
{
    return (Bounds){a.low * b.low * (1 - 1e-15), a.high * b.high * (1 + 1e-15)};
}

// Returns 2 if the first is certainly smaller, 0 if it is certainly larger, and -1 otherwise.
static int two_if_less(Bounds a, Bounds b)
{
    return a.high < b.low ? 2 : a.low > b.high ? 0 : -1;
}

static int count_triangle(Bounds a, Bounds b, Bounds c)
{
    const double out = 1 + 1e-15;
    double sum_low = (a.low + b.low) / out, sum_high = (a.high + b.high) * out;
    double least_low = fmax(a.low - b.high, b.low - a.high) / out, least_high = fmax(a.high - b.low, b.high - a.low);
    if (c.low > sum_high || c.high < least_low) return 0;
    return c.high < sum_low && c.low > least_high * out ? 2 : -1;
}

int yk_dyad_count(const YkShape *shape, const YkDiscCoefficients *coefficients)
{
    YkBall a = disc(coefficients, 0), b = disc(coefficients, 1), c = disc(coefficients, 2);
    switch (shape->angles) {
    case 2:
        return count_triangle(length_of(a), length_of(b), length_of(c));
    case 1:
        if (!(length_of(b).low > 0)) return -1;
        if (shape->turning[1] < 0) return two_if_less(area_of(c, b), product_of(length_of(a), length_of(b)));
        return two_if_less(area_of(a, b), product_of(length_of(c), length_of(b)));
    default:
        return area_of(a, b).low > 0 ? 1 : -1;
    }
}

// --- the gap

static YkDual dual(const YkDiscCoefficients *c, size_t k)
{
    return (YkDual){yk_ball(c->at[k], c->radius[k]), yk_ball(c->rate[k], c->rate_radius[k])};
}

static YkDual square_of(YkDual a) // |a|^2
{
    return yk_dual_mul(a, yk_dual_conjugate(a));
}

static YkDual minus(YkDual a, YkDual b)
{
    return yk_dual_add(a, yk_dual_negate(b));
}

// Returns |a|^2 |b|^2 - Im(c conj b)^2.
static YkDual chord(YkDual a, YkDual b, YkDual c)
{
    YkDual area = yk_dual_mul(c, yk_dual_conjugate(b)), twice = minus(area, yk_dual_conjugate(area));
    return yk_dual_add(yk_dual_mul(square_of(a), square_of(b)),
                       yk_dual_times(yk_vec(0.25, 0), yk_dual_mul(twice, twice)));
}

YkDual yk_dyad_gap(const YkShape *shape, const YkDiscCoefficients *coefficients)
{
    YkDual a = dual(coefficients, 0), b = dual(coefficients, 1), c = dual(coefficients, 2);
    if (shape->angles == 0) return yk_dual_constant(yk_vec(INFINITY, 0));
    if (shape->angles == 1) return shape->turning[1] < 0 ? chord(a, b, c) : chord(c, b, a);
    YkDual rest = minus(square_of(c), yk_dual_add(square_of(a), square_of(b)));
    return minus(yk_dual_times(yk_vec(4, 0), yk_dual_mul(square_of(a), square_of(b))), yk_dual_mul(rest, rest));
}

// --- in bounds

static YkBall between(double low, double high)
{
    double middle = low + 0.5 * (high - low);
    return yk_ball(yk_vec(middle, 0), YK_BALL_OUT(fmax(high - middle, middle - low)));
}

static YkBall upright(YkBall a) // i a
{
    return yk_ball_mul(yk_ball(yk_vec(0, 1), 0), a);
}

// Returns the direction of a vector: a / |a|.
static YkBall direction(YkBall a)
{
    Bounds length = length_of(a);
    return yk_ball_mul(a, between(1 / length.high * (1 - 1e-15), 1 / length.low * (1 + 1e-15)));
}

static YkBall conjugate(YkBall a)
{
    return yk_ball(yk_conj(a.at), a.radius);
}

static YkBall real_part(YkBall a)
{
    return yk_ball(yk_vec(a.at.x, 0), a.radius);
}

static YkBall imaginary_part(YkBall a)
{
    return yk_ball(yk_vec(a.at.y, 0), a.radius);
}

// The height of a triangle, s with s^2 + of^2 = length^2, and what part of it is looked at.
typedef struct Height {
    int branch; // +1, -1: s of that sign, where no solutions meet; 0: a part of all s
    size_t part, parts;
} Height;

static YkBall across(Bounds length, YkBall of, Height h)
{
    double least = fmax(0, fabs(of.at.x) - of.radius), most = fabs(of.at.x) + of.radius;
    double high = sqrt(fmax(0, (length.high - least) * (length.high + least))) * (1 + 1e-14);
    double low = sqrt(fmax(0, (length.low - most) * (length.low + most))) * (1 - 1e-14);
    if (h.branch != 0) return h.branch > 0 ? between(low, high) : between(-high, -low);
    double step = 2 * high / (double)h.parts, from = -high + (double)h.part * step;
    YkBall s = between(from, from + step);
    return yk_ball(s.at, s.radius + 1e-14 * high);
}

static void take_triangle(YkBall a, YkBall b, YkBall c, Height h, YkBall *x)
{
    Bounds A = length_of(a), B = length_of(b), C = length_of(c);
    // The foot of the height: (A^2 - B^2) / (2 C) + C / 2.
    double low = (A.low - B.high) * (A.low + B.high), high = (A.high - B.low) * (A.high + B.low);
    YkBall foot = yk_ball_add(between(low / 2 / (low > 0 ? C.high : C.low) - 1e-14 * A.high,
                                      high / 2 / (high > 0 ? C.low : C.high) + 1e-14 * A.high),
                              between(0.5 * C.low, 0.5 * C.high));
    YkBall side = yk_ball_add(foot, upright(across(A, foot, h)));
    side = yk_ball_mul(yk_ball_negate(direction(c)), side);
    x[0] = yk_ball_mul(side, yk_ball_inverse(a));
    x[1] = yk_ball_mul(yk_ball_negate(yk_ball_add(c, side)), yk_ball_inverse(b));
}

// Takes a part of a whole turn of the first angle.
static void take_turn(YkBall a, YkBall b, YkBall c, Height h, YkBall *x)
{
    double half = YK_PI / (double)h.parts;
    x[0] = yk_ball(yk_unit((2 * (double)h.part + 1) * half), YK_BALL_OUT(half + 1e-15));
    x[1] = yk_ball_mul(yk_ball_negate(yk_ball_add(c, yk_ball_mul(a, x[0]))), yk_ball_inverse(b));
}

// In the axes of the line: a z = along + i height.
static void take_line(YkBall a, YkBall b, YkBall c, Height h, YkBall *x)
{
    YkBall turn = conjugate(direction(b)), known = yk_ball_mul(c, turn);
    YkBall height = yk_ball_negate(imaginary_part(known)), along = across(length_of(a), height, h);
    x[0] = yk_ball_mul(yk_ball_add(along, upright(height)), yk_ball_inverse(yk_ball_mul(a, turn)));
    x[1] = yk_ball_mul(yk_ball_negate(yk_ball_add(real_part(known), along)),
                       yk_ball_inverse(real_part(yk_ball_mul(b, turn))));
}

// In the axes of the line that turns: a + b d = along + i offset, as long as c.
static void take_turning_line(YkBall a, YkBall b, YkBall c, Height h, YkBall *x)
{
    YkBall line = direction(b), per = conjugate(line), offset = yk_ball_mul(a, per);
    YkBall along = across(length_of(c), imaginary_part(offset), h);
    YkBall arm = yk_ball_mul(line, yk_ball_add(along, upright(imaginary_part(offset))));
    x[0] = yk_ball_mul(yk_ball_negate(c), yk_ball_inverse(arm));
    x[1] = yk_ball_mul(yk_ball_add(along, yk_ball_negate(real_part(offset))),
                       yk_ball_inverse(real_part(yk_ball_mul(b, per))));
}

static void take_slides(YkBall a, YkBall b, YkBall c, YkBall *x)
{
    YkBall per = yk_ball_inverse(imaginary_part(yk_ball_mul(a, conjugate(b))));
    x[0] = yk_ball_mul(yk_ball_negate(imaginary_part(yk_ball_mul(c, conjugate(b)))), per);
    x[1] = yk_ball_mul(imaginary_part(yk_ball_mul(c, conjugate(a))), per);
}

static bool take(const YkShape *shape, const YkDiscCoefficients *coefficients, Height h, YkBall x[2])
{
    YkBall a = disc(coefficients, 0), b = disc(coefficients, 1), c = disc(coefficients, 2);
    bool is_line = shape->angles == 1 && shape->turning[1] < 0;
    if (shape->angles > 0 && !(length_of(b).low > 0)) return false;
    if (shape->angles == 2 && h.branch == 0 && !(length_of(c).low > 0.1 * length_of(a).high))
        take_turn(a, b, c, h, x);
    else if (shape->angles == 2 && length_of(c).low > 0 && length_of(a).low > 0)
        take_triangle(a, b, c, h, x);
    else if (is_line && length_of(a).low > 0)
        take_line(a, b, c, h, x);
    else if (shape->angles == 1 && !is_line)
        take_turning_line(a, b, c, h, x);
    else if (shape->angles == 0 && h.branch != 0)
        take_slides(a, b, c, x);
    else
        return false;
    return isfinite(x[0].radius) && isfinite(x[1].radius);
}

bool yk_dyad_branch(const YkShape *shape, const YkDiscCoefficients *c, int branch, YkBall x[2])
{
    return take(shape, c, (Height){.branch = branch}, x);
}

bool yk_dyad_hull(const YkShape *shape, const YkDiscCoefficients *c, size_t part, size_t parts, YkBall x[2])
{
    return take(shape, c, (Height){.part = part, .parts = parts}, x);
}
