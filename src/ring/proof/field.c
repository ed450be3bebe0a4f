// Inverses, square roots and signed numbers in the prime field.
#include "ring/proof/field.h"

uint64_t yk_field_power(uint64_t base, uint64_t exponent)
{
    uint64_t power = 1;
    for (; exponent > 0; exponent /= 2) {
        if (exponent & 1) power = yk_field_multiply(power, base);
        base = yk_field_multiply(base, base);
    }
    return power;
}

// Returns a^(2^times).
static uint64_t squared(uint64_t a, int times)
{
    for (int k = 0; k < times; k++) a = yk_field_multiply(a, a);
    return a;
}

// Uses Fermat: a^(p - 2), where p - 2 = 31 ones, a zero and 32 ones in binary; ones(2 n) = ones(n)^(2^n) * ones(n).
uint64_t yk_field_invert(uint64_t a)
{
    uint64_t ones2 = yk_field_multiply(squared(a, 1), a), ones3 = yk_field_multiply(squared(ones2, 1), a),
             ones6 = yk_field_multiply(squared(ones3, 3), ones3), ones12 = yk_field_multiply(squared(ones6, 6), ones6),
             ones24 = yk_field_multiply(squared(ones12, 12), ones12),
             ones30 = yk_field_multiply(squared(ones24, 6), ones6), ones31 = yk_field_multiply(squared(ones30, 1), a),
             high = squared(ones31, 1);
    return yk_field_multiply(squared(high, 32), yk_field_multiply(high, a));
}

uint64_t yk_field_of(int64_t value)
{
    uint64_t size = value < 0 ? (uint64_t)0 - (uint64_t)value : (uint64_t)value;
    return value < 0 ? yk_field_negate(size) : size; // |value| <= 2^63 < p
}

// Uses p - 1 = 2^32 * odd. 7 generates the field, so 7^odd has order 2^32 (Tonelli 1891, Shanks 1973).
bool yk_field_sqrt(uint64_t a, uint64_t *root)
{
    const uint64_t odd = 0xffffffffu;
    *root = 0;
    if (a == 0) return true;
    uint64_t x = yk_field_power(a, (odd + 1) / 2), t = yk_field_power(a, odd), c = yk_field_power(7, odd);
    unsigned order = 32;
    while (t != 1) {
        unsigned i = 0;
        for (uint64_t power = t; power != 1 && i < order; i++) power = yk_field_multiply(power, power);
        if (i >= order) return false;
        for (unsigned k = 0; k + i + 1 < order; k++) c = yk_field_multiply(c, c);
        x = yk_field_multiply(x, c);
        c = yk_field_multiply(c, c);
        t = yk_field_multiply(t, c);
        order = i;
    }
    *root = x;
    return true;
}
