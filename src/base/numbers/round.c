// Rounds a double correctly to a number of significant digits: one 192-bit product decides, or exact integers when it
// cannot settle a tie.
#include <stdbool.h>
#include "base/numbers/big.h"
#include "base/numbers/decimal.h"
#include "base/numbers/powers_of_ten.h"

static uint64_t small_power_of_ten(int exponent)
{
    uint64_t power = 1;
    for (; exponent > 0; exponent--) power *= 10;
    return power;
}

// Returns whether mantissa * 2^exponent is at or above (digits + 1/2) * 10^tens; a tie counts only when digits is odd.
static bool rounds_up_exactly(YkBinary binary, uint64_t digits, int tens)
{
    YkBig midpoint = yk_big(2 * digits + 1), value = yk_big(binary.mantissa);
    int sign = yk_big_compare(&midpoint, tens, &value, binary.exponent + 1);
    return sign < 0 || (sign == 0 && (digits & 1));
}

// Returns the integer nearest to binary / 10^tens, which must be below 2^60; *floor is the integer below.
static uint64_t divide_by_ten_to(YkBinary binary, int tens, uint64_t *floor)
{
    int shift = yk_leading_zeros(binary.mantissa);
    uint64_t w = binary.mantissa << shift;
    YkWide power = yk_power_of_ten(-tens), low = yk_wide_multiply(w, power.low);
    YkWide product = yk_wide_add(yk_wide_multiply(w, power.high), low.high); // the quotient is at most 2 units larger

    // The fraction bits of product.high.
    int fraction_bits = -(binary.exponent - shift + yk_floor_log2_of_ten(-tens) - 127 + 128);
    uint64_t half = (uint64_t)1 << (fraction_bits - 1);
    uint64_t fraction = product.high & (2 * half - 1);
    *floor = product.high >> fraction_bits;

    bool exact = yk_power_of_ten_is_exact(-tens), up;
    if (fraction == half)
        up = product.low != 0 || low.low != 0 || !exact || (*floor & 1);
    else if (fraction == half - 1 && product.low >= UINT64_MAX - 2 && !exact)
        up = rounds_up_exactly(binary, *floor, tens);
    else
        up = fraction > half;
    return *floor + up;
}

YkDecimal yk_decimal_rounded(double value, int count)
{
    YkBinary binary = yk_binary_from_bits(yk_double_bits(value));
    uint64_t limit = small_power_of_ten(count), floor;
    // The power of two gives an estimate of log10 that is exact or one too small.
    int tens = yk_floor_log10_of_two(binary.exponent + 63 - yk_leading_zeros(binary.mantissa)) - count + 1;
    uint64_t digits = divide_by_ten_to(binary, tens, &floor);
    if (floor >= limit) digits = divide_by_ten_to(binary, ++tens, &floor);
    if (digits >= limit) return (YkDecimal){limit / 10, tens + 1}; // 9.99 -> 10.0
    return (YkDecimal){digits, tens};
}
