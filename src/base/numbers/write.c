// Writes numbers: plain from 1e-5 up to 1e15, with an exponent beyond.
#include "base/number.h"
#include <math.h>
#include "base/numbers/decimal.h"
#include "base/wide.h"

enum { DIGITS_MAX = 20, PLAIN_LOW = -5, PLAIN_HIGH = 15 };

static char *put(char *out, const char *data, size_t length)
{
    memcpy(out, data, length);
    return out + length;
}

static char *put_zeros(char *out, int count)
{
    for (; count > 0; count--) *out++ = '0';
    return out;
}

// Writes the digits of value right-aligned into digits[0..DIGITS_MAX) and returns the first.
static const char *to_digits(uint64_t value, char digits[DIGITS_MAX])
{
    char *first = digits + DIGITS_MAX;
    do *--first = (char)('0' + value % 10);
    while ((value /= 10) != 0);
    return first;
}

static char *put_integer(char *out, int value)
{
    char digits[DIGITS_MAX];
    if (value < 0) *out++ = '-';
    const char *first = to_digits((uint64_t)(value < 0 ? -value : value), digits);
    return put(out, first, (size_t)(digits + DIGITS_MAX - first));
}

// Writes 0.00ddd, dd.ddd or ddd00 with `point` digits before the decimal point.
static char *put_plain(char *out, const char *first, int count, int point)
{
    if (point <= 0) {
        out = put_zeros(put(out, "0.", 2), -point);
        return put(out, first, (size_t)count);
    }
    if (point >= count) return put_zeros(put(out, first, (size_t)count), point - count);
    out = put(out, first, (size_t)point);
    *out++ = '.';
    return put(out, first + point, (size_t)(count - point));
}

static char *put_scientific(char *out, const char *first, int count, int exponent)
{
    *out++ = first[0];
    if (count > 1) *out++ = '.';
    out = put(out, first + 1, (size_t)(count - 1));
    *out++ = 'e';
    return put_integer(out, exponent);
}

static char *put_decimal(char *out, YkDecimal decimal)
{
    char digits[DIGITS_MAX];
    while (decimal.digits % 10 == 0) {
        decimal.digits /= 10;
        decimal.exponent++;
    }
    const char *first = to_digits(decimal.digits, digits);
    int count = (int)(digits + DIGITS_MAX - first), point = count + decimal.exponent;
    return point > PLAIN_LOW && point <= PLAIN_HIGH ? put_plain(out, first, count, point)
                                                    : put_scientific(out, first, count, point - 1);
}

static size_t finish(const char *text, char *end)
{
    *end = '\0';
    return (size_t)(end - text);
}

// Writes what needs no digits: sign, nan, inf and 0. Returns true if that is all; *out is where the rest goes.
static bool put_special(char **out, double value)
{
    if (isnan(value)) {
        *out = put(*out, "nan", 3);
        return true;
    }
    if (signbit(value)) *(*out)++ = '-';
    if (isinf(value)) *out = put(*out, "inf", 3);
    if (value == 0) *out = put(*out, "0", 1);
    return isinf(value) || value == 0;
}

size_t yk_number_write(double value, char text[YK_NUMBER_SIZE])
{
    char *out = text;
    if (!put_special(&out, value)) out = put_decimal(out, yk_decimal_shortest(fabs(value)));
    return finish(text, out);
}

size_t yk_number_write_digits(double value, int digits, char text[YK_NUMBER_SIZE])
{
    char *out = text;
    int count = digits < 1 ? 1 : digits > 17 ? 17 : digits;
    if (!put_special(&out, value)) out = put_decimal(out, yk_decimal_rounded(fabs(value), count));
    return finish(text, out);
}

// Returns wide / 2^shift rounded to the nearest integer, ties to even; wide < 2^110 and the result fits 64 bits.
static uint64_t shift_right_rounded(YkWide wide, int shift)
{
    bool sticky = false;
    if (shift >= 128) return 0; // less than a half
    if (shift > 64) {
        sticky = wide.low != 0;
        wide = (YkWide){0, wide.high};
        shift -= 64;
    }
    uint64_t half = (uint64_t)1 << (shift - 1), rest = wide.low & (2 * half - 1);
    uint64_t whole = shift == 64 ? wide.high : wide.high << (64 - shift) | wide.low >> shift;
    return whole + (rest > half || (rest == half && (sticky || (whole & 1))));
}

// Writes a fixed number of decimals. Below 1e15 < 2^50 a double has at least three binary places, so that `fraction` *
// 10^decimals / 2^places is an exact 128-bit quotient.
static char *put_fixed(char *out, double value, int decimals)
{
    char digits[DIGITS_MAX];
    YkBinary binary = yk_binary_from_bits(yk_double_bits(value));
    int places = -binary.exponent;
    uint64_t whole = places < 64 ? binary.mantissa >> places : 0, scale = 1;
    uint64_t fraction = places < 64 ? binary.mantissa & (((uint64_t)1 << places) - 1) : binary.mantissa;
    for (int i = 0; i < decimals; i++) scale *= 10;
    uint64_t after = shift_right_rounded(yk_wide_multiply(fraction, scale), places);
    if (decimals == 0) {
        // A tie goes to the even whole number, which `after` alone cannot see.
        if (after == 0 && (whole & 1) && places < 64 && fraction == (uint64_t)1 << (places - 1)) after = 1;
    }
    if (after == scale) {
        whole++;
        after = 0;
    }
    const char *first = to_digits(whole, digits);
    out = put(out, first, (size_t)(digits + DIGITS_MAX - first));
    if (decimals == 0) return out;
    *out++ = '.';
    first = to_digits(after, digits);
    out = put_zeros(out, decimals - (int)(digits + DIGITS_MAX - first));
    return put(out, first, (size_t)(digits + DIGITS_MAX - first));
}

size_t yk_number_write_fixed(double value, int decimals, char text[YK_NUMBER_SIZE])
{
    char *out = text;
    if (!(fabs(value) < 1e15)) return yk_number_write(value, text);
    if (signbit(value)) *out++ = '-';
    return finish(text, put_fixed(out, fabs(value), decimals < 0 ? 0 : decimals > 17 ? 17 : decimals));
}
