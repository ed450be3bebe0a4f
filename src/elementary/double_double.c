// The last step of results that may overflow or be subnormal.
#include "elementary/double_double.h"

double yk_scaled(DoubleDouble a, int64_t exponent)
{
    int64_t own = (int64_t)(bits_of(a.high) >> 52) - 1023;
    double unit = power_of_two(-own), high = a.high * unit, low = a.low * unit; // 1 <= high < 2
    exponent += own;
    if (exponent > 1024) return INFINITY;
    if (exponent < -1076) return 0;
    if (exponent > -1022 || (exponent == -1022 && high + low >= 1))
        return (high + low) * power_of_two(exponent - (exponent > 0)) * (exponent > 0 ? 2 : 1);
    // Added to this number, both are rounded where the answer ends, at 2^-1074.
    double grid = power_of_two(52 - 1074 - exponent);
    DoubleDouble sum = dd_ordered_sum(grid, high);
    return ((sum.high + (sum.low + low)) - grid) * 0x1p-700 * power_of_two(exponent + 700);
}
