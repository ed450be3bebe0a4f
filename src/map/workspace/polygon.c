// Finds loops of a group that cannot close: every real angle has |z| = 1, so a loop is a polygon of known sides.
#include "map/workspace/polygon.h"
#include <math.h>

// Returns whether a row plus `sign` times another is open; sign 0: the row alone.
static bool is_open(const YkShape *shape, const YkDiscCoefficients *c, size_t row, size_t other, int sign)
{
    const double out = 1 + 1e-14;
    size_t width = shape->unknowns + 1;
    double longest = -INFINITY, sum = 0;
    for (size_t k = 0; k < width; k++) {
        size_t a = row * width + k, b = other * width + k;
        YkVec side = yk_add(c->at[a], yk_scale(sign, c->at[b]));
        double length = yk_norm(side), radius = c->radius[a] + (sign == 0 ? 0 : c->radius[b]);
        bool is_slide = k >= shape->angles && k < shape->unknowns;
        if (is_slide && (length > 0 || radius > 0)) return false;
        // For the longest side the least length counts in place of the greatest.
        longest = fmax(longest, length / out - radius + (length * out + radius));
        sum += length * out + radius;
    }
    return longest > sum * out + 1e-13;
}

bool yk_polygon_is_open(const YkShape *shape, const YkDiscCoefficients *c)
{
    for (size_t row = 0; row < shape->loops; row++) {
        if (is_open(shape, c, row, row, 0)) return true;
        for (size_t other = row + 1; other < shape->loops; other++)
            if (is_open(shape, c, row, other, 1) || is_open(shape, c, row, other, -1)) return true;
    }
    return false;
}
