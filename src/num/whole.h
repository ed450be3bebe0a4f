// Whole numbers of up to 2048 bits and fractions of them: gear ratios are exact, and a train of forty gears has
// numerators of hundreds of bits. They are values, without allocation; an overflow is noticed.
#ifndef NUM_WHOLE_H
#define NUM_WHOLE_H
#include <stdbool.h>
#include <stdint.h>
#include "base/text.h"

enum { YK_WHOLE_LIMBS = 64 };

// A natural number, little-endian, without leading zero limbs. Zeroed = 0; only limb[0..count) is meaningful.
typedef struct YkWhole {
    uint32_t count;
    uint32_t limb[YK_WHOLE_LIMBS];
} YkWhole;

// A sticky flag: a result did not fit; all results after it are worthless.
typedef bool YkOverflow;

YkWhole yk_whole(uint64_t value);
void yk_whole_copy(YkWhole *to, const YkWhole *from); // only the limbs that count
int yk_whole_compare(const YkWhole *a, const YkWhole *b);
void yk_whole_add(YkWhole *sum, const YkWhole *a, const YkWhole *b, YkOverflow *overflow);
void yk_whole_subtract(YkWhole *rest, const YkWhole *a, const YkWhole *b); // a >= b
void yk_whole_multiply(YkWhole *product, const YkWhole *a, const YkWhole *b,
                       YkOverflow *overflow); // product is neither a nor b
// Divides by b > 0. quotient and rest are neither a nor b; quotient may be NULL. Source: Knuth, TAOCP 2, 4.3.1,
// algorithm D.
void yk_whole_divide(YkWhole *quotient, YkWhole *rest, const YkWhole *a, const YkWhole *b);
void yk_whole_common(YkWhole *divisor, const YkWhole *a, const YkWhole *b); // greatest common divisor
double yk_whole_value(const YkWhole *a, int *twos);                         // a = value * 2^twos, value below 2^64
void yk_whole_write(const YkWhole *a, YkText *text);                        // decimal digits

// A fraction in lowest terms. Zeroed = 0 (its denominator then counts as 1).
typedef struct YkFraction {
    bool is_negative;
    YkWhole over, under;
} YkFraction;

YkFraction yk_fraction(int64_t numerator, int64_t denominator); // denominator != 0
YkFraction yk_fraction_of(double value); // the exact value of a double: finite, between 1e-290 and 1e290 in size, or 0
bool yk_fraction_is_zero(const YkFraction *a);
bool yk_fraction_is_one(const YkFraction *a);
YkFraction yk_fraction_negative(const YkFraction *a);
YkFraction yk_fraction_inverse(const YkFraction *a); // a != 0
YkFraction yk_fraction_add(const YkFraction *a, const YkFraction *b, YkOverflow *overflow);
YkFraction yk_fraction_multiply(const YkFraction *a, const YkFraction *b, YkOverflow *overflow);
YkFraction yk_fraction_divide(const YkFraction *a, const YkFraction *b, YkOverflow *overflow); // b != 0
double yk_fraction_value(const YkFraction *a);             // nearest double, within an ulp
void yk_fraction_write(const YkFraction *a, YkText *text); // "-108/23", "3", "0"

#endif
