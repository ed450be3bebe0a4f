// Exact fractions.
#include <math.h>
#include <stdlib.h>
#include "num/whole.h"

static const YkWhole *under(const YkFraction *a, YkWhole *one)
{
    if (a->under.count > 0) return &a->under;
    *one = yk_whole(1);
    return one;
}

static bool is_one(const YkWhole *a)
{
    return a->count == 1 && a->limb[0] == 1;
}

static bool is_small(const YkWhole *a)
{
    return a->count <= 1;
}

static uint64_t small(const YkWhole *a)
{
    return a->count == 0 ? 0 : a->limb[0];
}

static uint64_t size_of(int64_t value)
{
    return value < 0 ? 0 - (uint64_t)value : (uint64_t)value;
}

static uint64_t common(uint64_t a, uint64_t b)
{
    while (b != 0) {
        uint64_t rest = a % b;
        a = b;
        b = rest;
    }
    return a;
}

static YkFraction reduced(bool is_negative, uint64_t over, uint64_t below)
{
    uint64_t divisor = common(over, below);
    YkFraction a;
    a.is_negative = is_negative && over != 0;
    a.over = yk_whole(over / divisor);
    a.under = yk_whole(below / divisor);
    return a;
}

YkFraction yk_fraction(int64_t numerator, int64_t denominator)
{
    return reduced((numerator < 0) != (denominator < 0), size_of(numerator), size_of(denominator));
}

bool yk_fraction_is_zero(const YkFraction *a)
{
    return a->over.count == 0;
}

bool yk_fraction_is_one(const YkFraction *a)
{
    return !a->is_negative && is_one(&a->over) && (a->under.count == 0 || is_one(&a->under));
}

YkFraction yk_fraction_negative(const YkFraction *a)
{
    YkFraction b = *a;
    b.is_negative = !a->is_negative && a->over.count > 0;
    return b;
}

YkFraction yk_fraction_inverse(const YkFraction *a)
{
    YkFraction b;
    YkWhole one;
    b.is_negative = a->is_negative;
    yk_whole_copy(&b.over, under(a, &one));
    yk_whole_copy(&b.under, &a->over);
    return b;
}

// Computes to = a / divisor, exactly.
static void divide_out(YkWhole *to, const YkWhole *a, const YkWhole *divisor)
{
    YkWhole rest;
    if (is_one(divisor)) {
        yk_whole_copy(to, a);
    } else {
        yk_whole_divide(to, &rest, a, divisor);
    }
}

YkFraction yk_fraction_multiply(const YkFraction *a, const YkFraction *b, YkOverflow *overflow)
{
    YkFraction c;
    YkWhole one_a, one_b, ab, ba, part[4];
    const YkWhole *under_a = under(a, &one_a), *under_b = under(b, &one_b);
    bool is_negative = a->is_negative != b->is_negative;
    if (a->over.count == 0 || b->over.count == 0) return yk_fraction(0, 1);
    if (is_small(&a->over) && is_small(&b->over) && is_small(under_a) && is_small(under_b))
        return reduced(is_negative, small(&a->over) * small(&b->over), small(under_a) * small(under_b));
    yk_whole_common(&ab, &a->over, under_b); // cancels crosswise: the products are then in lowest terms
    yk_whole_common(&ba, &b->over, under_a);
    divide_out(&part[0], &a->over, &ab);
    divide_out(&part[1], &b->over, &ba);
    divide_out(&part[2], under_a, &ba);
    divide_out(&part[3], under_b, &ab);
    yk_whole_multiply(&c.over, &part[0], &part[1], overflow);
    yk_whole_multiply(&c.under, &part[2], &part[3], overflow);
    c.is_negative = is_negative;
    return c;
}

YkFraction yk_fraction_divide(const YkFraction *a, const YkFraction *b, YkOverflow *overflow)
{
    YkFraction inverse = yk_fraction_inverse(b);
    return yk_fraction_multiply(a, &inverse, overflow);
}

// Adds natural numbers with signs.
static bool add_signed(YkWhole *sum, const YkWhole *a, bool a_negative, const YkWhole *b, bool b_negative,
                       YkOverflow *overflow)
{
    if (a_negative == b_negative) {
        yk_whole_add(sum, a, b, overflow);
        return a_negative;
    }
    bool is_more = yk_whole_compare(a, b) >= 0;
    if (is_more) {
        yk_whole_subtract(sum, a, b);
    } else {
        yk_whole_subtract(sum, b, a);
    }
    return is_more ? a_negative : b_negative;
}

YkFraction yk_fraction_add(const YkFraction *a, const YkFraction *b, YkOverflow *overflow)
{
    YkFraction c;
    YkWhole one_a, one_b, divisor, left, right, factor, sum;
    const YkWhole *under_a = under(a, &one_a), *under_b = under(b, &one_b);
    if (a->over.count == 0) return *b;
    if (b->over.count == 0) return *a;
    yk_whole_common(&divisor, under_a, under_b);
    divide_out(&factor, under_b, &divisor);
    yk_whole_multiply(&left, &a->over, &factor, overflow);
    yk_whole_multiply(&c.under, under_a, &factor, overflow); // the common denominator
    divide_out(&factor, under_a, &divisor);
    yk_whole_multiply(&right, &b->over, &factor, overflow);
    if (*overflow) return yk_fraction(0, 1);
    c.is_negative = add_signed(&sum, &left, a->is_negative, &right, b->is_negative, overflow);
    if (sum.count == 0 || *overflow) return yk_fraction(0, 1);
    yk_whole_common(&divisor, &sum, &divisor); // only what the denominators shared can cancel (Knuth 4.5.1)
    divide_out(&c.over, &sum, &divisor);
    yk_whole_copy(&factor, &c.under);
    divide_out(&c.under, &factor, &divisor);
    return c;
}

double yk_fraction_value(const YkFraction *a)
{
    int twos_over = 0, twos_under = 0;
    YkWhole one;
    double over = yk_whole_value(&a->over, &twos_over), below = yk_whole_value(under(a, &one), &twos_under);
    double value = ldexp(over / below, twos_over - twos_under);
    return a->is_negative ? -value : value;
}

void yk_fraction_write(const YkFraction *a, YkText *text)
{
    YkWhole one;
    const YkWhole *below = under(a, &one);
    if (a->is_negative) yk_text_puts(text, "-");
    yk_whole_write(&a->over, text);
    if (is_one(below)) return;
    yk_text_puts(text, "/");
    yk_whole_write(below, text);
}

YkFraction yk_fraction_of(double value)
{
    int twos = 0;
    YkOverflow overflow = false;
    YkFraction fraction = yk_fraction((int64_t)ldexp(frexp(value, &twos), 53), INT64_C(1) << 53);
    YkFraction two = yk_fraction(twos < 0 ? 1 : 2, twos < 0 ? 2 : 1);
    for (int k = abs(twos); k > 0; k--) fraction = yk_fraction_multiply(&fraction, &two, &overflow);
    return fraction;
}
