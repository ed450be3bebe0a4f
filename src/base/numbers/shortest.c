// Writes the shortest decimal that reads back to the same double, after Giulietti 2020 (Schubfach, "pigeonhole"). Take
// the largest power of ten 10^k that is not wider than the rounding interval: at least one and at most a few of its
// multiples lie inside. A coarser multiple, of 10^(k+1), is tried first.
#include <stdbool.h>
#include "base/numbers/decimal.h"
#include "base/numbers/powers_of_ten.h"

// Returns floor(power * x / 2^128), with the last bit set when the cut-off rest may not vanish: enough to compare
// exactly with multiples of 2 (Giulietti 2020, section 9.9). `power` is rounded up.
static uint64_t multiply_to_odd(YkWide power, uint64_t x)
{
    YkWide high = yk_wide_add(yk_wide_multiply(power.high, x), yk_wide_multiply(power.low, x).high);
    return high.high | (high.low > 1);
}

static YkWide power_rounded_up(int exponent)
{
    YkWide power = yk_power_of_ten(exponent);
    power.low += !yk_power_of_ten_is_exact(exponent); // never carries: the tool that writes the table checks it
    return power;
}

// Returns whether exactly one of the neighbours s and s + 1 (in units of 4 in `v`, `low` and `high`) is inside; *up
// says which.
static bool only_one_inside(uint64_t s, uint64_t unit, uint64_t low, uint64_t high, bool *up)
{
    bool lower_inside = low <= unit * s, upper_inside = unit * (s + 1) <= high;
    *up = upper_inside;
    return lower_inside != upper_inside;
}

YkDecimal yk_decimal_shortest(double value)
{
    uint64_t bits = yk_double_bits(value);
    YkBinary binary = yk_binary_from_bits(bits);
    uint64_t c = binary.mantissa;
    int q = binary.exponent;
    if (q <= 0 && q > -53 && (c & (((uint64_t)1 << -q) - 1)) == 0) return (YkDecimal){c >> -q, 0}; // an integer

    // At a power of two the interval's lower half is half as wide: log10(3/4) = -524031 / 2^22, rounded down.
    bool narrow_below = c == (uint64_t)1 << 52 && q > -1074;
    int k = (q * 1262611 - (narrow_below ? 524031 : 0)) >> 22;
    int shift = q + yk_floor_log2_of_ten(-k) + 1;
    YkWide power = power_rounded_up(-k);

    // Value and interval ends, times 4 / 10^k. The ends themselves read back only to an even mantissa.
    uint64_t odd = c & 1;
    uint64_t v = multiply_to_odd(power, (4 * c) << shift);
    uint64_t low = multiply_to_odd(power, (4 * c - 2 + narrow_below) << shift) + odd;
    uint64_t high = multiply_to_odd(power, (4 * c + 2) << shift) - odd;

    uint64_t s = v / 4;
    bool up;
    if (s >= 10 && only_one_inside(s / 10, 40, low, high, &up)) return (YkDecimal){s / 10 + up, k + 1};
    if (!only_one_inside(s, 4, low, high, &up)) up = v % 4 > 2 || (v % 4 == 2 && (s & 1)); // both are: the nearest
    return (YkDecimal){s + up, k};
}
