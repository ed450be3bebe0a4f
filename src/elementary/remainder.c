// fmod and remainder, by long division of the integers in both numbers.
#include "elementary/bits.h"
#include "elementary/elementary.h"

// |x| = integer 2^(exponent), the integer below 2^53.
typedef struct Parts {
    uint64_t integer;
    int exponent;
} Parts;

static Parts parts_of(double x)
{
    uint64_t bits = bits_of(x) & ~YK_SIGN_BIT, fraction = bits & (((uint64_t)1 << 52) - 1);
    int exponent = (int)(bits >> 52);
    return exponent == 0 ? (Parts){fraction, -1074} : (Parts){fraction | (uint64_t)1 << 52, exponent - 1075};
}

// Returns the remainder of |x| divided by |y|, both finite, y not 0, |x| >= |y|; *is_odd: whether the quotient is.
static double left_of(double x, double y, bool *is_odd)
{
    Parts a = parts_of(x), b = parts_of(y);
    uint64_t quotient = a.integer / b.integer, left = a.integer % b.integer;
    for (int places = a.exponent - b.exponent; places > 0;) {
        int step = places < 11 ? places : 11; // eleven bits more fit into 64
        quotient = (left << step) / b.integer;
        left = (left << step) % b.integer;
        places -= step;
    }
    *is_odd = (quotient & 1) != 0;
    return ldexp((double)left, b.exponent);
}

double yk_fmod(double x, double y)
{
    bool is_odd;
    if (!isfinite(x) || isnan(y) || y == 0) return NAN;
    return fabs(x) < fabs(y) ? x : copysign(left_of(x, y, &is_odd), x);
}

double yk_remainder(double x, double y)
{
    if (!isfinite(x) || isnan(y) || y == 0) return NAN;
    double b = fabs(y), left = fabs(x);
    bool is_odd = false;
    if (left >= b) left = left_of(x, y, &is_odd);
    bool is_more = left > b - left, is_half = left == b - left; // both differences are exact where it is close
    if (is_more || (is_half && is_odd)) left -= b;
    return signbit(x) ? -left : left;
}
