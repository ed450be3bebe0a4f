// Reads decimal numbers, correctly rounded. The first 19 digits times a 128-bit power of ten bound the value from both
// sides (after Lemire 2021, "Number parsing at a gigabyte per second"). If both bounds round to the same double, that
// is the answer; otherwise all digits are compared exactly with the midpoint of the two candidates.
#include "base/letters.h"
#include "base/number.h"
#include "base/numbers/big.h"
#include "base/numbers/decimal.h"
#include "base/numbers/powers_of_ten.h"

enum {
    MANTISSA_DIGITS = 19, // always fit in 64 bits
    EXACT_DIGITS = 768    // no midpoint of two doubles has more (767); beyond, only whether any digit follows matters
};
#define EXPONENT_LIMIT ((int64_t)1000000000000000000) // keeps sums in range; no text is that long

// mantissa * 10^exponent <= value; equal unless digits were dropped.
typedef struct Scan {
    uint64_t mantissa;
    int64_t exponent;
    bool dropped;      // a nonzero digit did not fit
    size_t first, end; // the digits, from the first that is not zero, with perhaps a point inside
    size_t length;     // bytes of the whole number, 0 if there is none
} Scan;

static size_t scan_exponent(const char *text, size_t length, size_t at, int64_t *exponent)
{
    size_t i = at;
    if (i == length || (text[i] != 'e' && text[i] != 'E')) return at;
    bool negative = ++i < length && text[i] == '-';
    if (i < length && (text[i] == '-' || text[i] == '+')) i++;
    if (i == length || !yk_is_digit(text[i])) return at; // "2em" is the number 2, then a word
    int64_t value = 0;
    for (; i < length && yk_is_digit(text[i]); i++)
        if (value < EXPONENT_LIMIT / 10) value = 10 * value + (text[i] - '0');
    *exponent += negative ? -value : value;
    return i;
}

static Scan scan_number(const char *text, size_t length)
{
    Scan scan = {0};
    bool any = false, point = false;
    int kept = 0;
    size_t i = 0;
    for (; i < length; i++) {
        if (text[i] == '.' && !point) {
            point = true;
            continue;
        }
        if (!yk_is_digit(text[i])) break;
        any = true;
        unsigned digit = (unsigned)(text[i] - '0');
        if (kept == MANTISSA_DIGITS) {
            scan.dropped |= digit != 0;
            scan.exponent += !point;
            continue;
        }
        if (kept == 0 && digit != 0) scan.first = i;
        if (kept != 0 || digit != 0) kept++;
        scan.mantissa = 10 * scan.mantissa + digit;
        scan.exponent -= point;
    }
    if (!any) return scan;
    scan.end = i;
    scan.length = scan_exponent(text, length, i, &scan.exponent);
    return scan;
}

// Returns the bits of the double nearest to (product + sticky * something below 1) * 2^exponent, ties to even.
static uint64_t round_to_bits(YkWide product, bool sticky, int exponent)
{
    if (product.high >> 63 == 0) {
        product = (YkWide){product.high << 1 | product.low >> 63, product.low << 1};
        exponent--;
    }
    int power = exponent + 127; // 2^power <= value < 2^(power + 1)
    int keep = power >= -1022 ? 53 : 53 + 1022 + power;
    if (keep < 0) return 0;
    uint64_t mantissa = keep == 0 ? 0 : product.high >> (64 - keep);
    uint64_t rest = product.high << keep, half = (uint64_t)1 << 63;
    bool above = rest > half || (rest == half && (product.low != 0 || sticky));
    mantissa += above || (rest == half && (mantissa & 1));
    if (power > 1023) return (uint64_t)0x7ff << 52;
    // The hidden bit adds one to the exponent field, and so does a carry out of the mantissa.
    return power >= -1022 ? ((uint64_t)(power + 1022) << 52) + mantissa : mantissa;
}

// Returns whether the number is at or above the midpoint of the double `bits` and the next; a tie counts if `bits` is
// odd.
static bool is_above_midpoint(const char *text, const Scan *scan, uint64_t bits)
{
    YkBig decimal = yk_big(0);
    int taken = 0;
    bool more = false;
    int64_t exponent = scan->exponent;
    for (size_t i = scan->first; i < scan->end; i++) {
        if (text[i] == '.') continue;
        if (taken == EXACT_DIGITS) {
            more |= text[i] != '0';
            continue;
        }
        yk_big_multiply_add(&decimal, 10, (uint32_t)(text[i] - '0'));
        if (++taken > MANTISSA_DIGITS) exponent--;
    }
    YkBinary below = yk_binary_from_bits(bits);
    YkBig midpoint = yk_big(2 * below.mantissa + 1);
    int sign = yk_big_compare(&decimal, (int)exponent, &midpoint, below.exponent - 1);
    return sign > 0 || (sign == 0 && (more || (bits & 1)));
}

// Returns an upper bound of the value from the lower bound `product`, in the same units. The errors: one unit each for
// the cut-off low word of the product and the truncated power of ten; less than one unit of the mantissa for dropped
// digits.
static YkWide upper_bound(YkWide product, bool dropped, int shift)
{
    YkWide upper = yk_wide_add(product, 2);
    if (dropped) upper.high += (uint64_t)1 << shift;
    return upper.high < product.high ? (YkWide){UINT64_MAX, UINT64_MAX} : upper; // the value stays below 2^128
}

static double nearest_double(const char *text, const Scan *scan)
{
    if (scan->mantissa == 0 || scan->exponent < YK_TEN_MIN) return 0; // 10^19 * 10^-343 is under half the smallest
    if (scan->exponent > 308) return yk_double_from_bits((uint64_t)0x7ff << 52);
    int tens = (int)scan->exponent, shift = yk_leading_zeros(scan->mantissa);
    uint64_t w = scan->mantissa << shift;
    YkWide power = yk_power_of_ten(tens), low = yk_wide_multiply(w, power.low);
    YkWide product = yk_wide_add(yk_wide_multiply(w, power.high), low.high);
    int exponent = yk_floor_log2_of_ten(tens) - 127 - shift + 64;

    bool exact = yk_power_of_ten_is_exact(tens) && !scan->dropped;
    uint64_t bits = round_to_bits(product, !exact || low.low != 0, exponent);
    if (!exact && bits != round_to_bits(upper_bound(product, scan->dropped, shift), false, exponent))
        bits += is_above_midpoint(text, scan, bits);
    return yk_double_from_bits(bits);
}

size_t yk_number_read(const char *text, size_t length, double *value)
{
    static const double tens[] = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,  1e8,  1e9,  1e10, 1e11,
                                  1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};
    Scan scan = scan_number(text, length);
    if (scan.length == 0) return 0;
    // Both operands are exact, so one operation rounds correctly (Clinger 1990).
    if (!scan.dropped && scan.mantissa <= (uint64_t)1 << 53 && scan.exponent >= -22 && scan.exponent <= 22) {
        double mantissa = (double)scan.mantissa;
        *value = scan.exponent < 0 ? mantissa / tens[-scan.exponent] : mantissa * tens[scan.exponent];
    } else {
        *value = nearest_double(text, &scan);
    }
    return scan.length;
}

bool yk_number_read_exact(const char *text, size_t length, int64_t *mantissa, int32_t *exponent)
{
    Scan scan = scan_number(text, length);
    if (scan.length == 0 || scan.dropped) return false;
    if (scan.mantissa == 0) scan.exponent = 0;
    for (; scan.mantissa != 0 && scan.mantissa % 10 == 0; scan.exponent++) scan.mantissa /= 10;
    if (scan.mantissa > INT64_MAX || scan.exponent > INT32_MAX || scan.exponent < -INT32_MAX) return false;
    *mantissa = (int64_t)scan.mantissa;
    *exponent = (int32_t)scan.exponent;
    return true;
}
