// Natural numbers of up to a fixed size.
#include "num/whole.h"
#include <string.h>

static void trim(YkWhole *a)
{
    while (a->count > 0 && a->limb[a->count - 1] == 0) a->count--;
}

YkWhole yk_whole(uint64_t value)
{
    YkWhole a;
    a.limb[0] = (uint32_t)value;
    a.limb[1] = (uint32_t)(value >> 32);
    a.count = 2;
    trim(&a);
    return a;
}

void yk_whole_copy(YkWhole *to, const YkWhole *from)
{
    to->count = from->count;
    memcpy(to->limb, from->limb, from->count * sizeof *from->limb);
}

int yk_whole_compare(const YkWhole *a, const YkWhole *b)
{
    if (a->count != b->count) return a->count < b->count ? -1 : 1;
    for (uint32_t i = a->count; i > 0; i--)
        if (a->limb[i - 1] != b->limb[i - 1]) return a->limb[i - 1] < b->limb[i - 1] ? -1 : 1;
    return 0;
}

void yk_whole_add(YkWhole *sum, const YkWhole *a, const YkWhole *b, YkOverflow *overflow)
{
    uint32_t count = a->count > b->count ? a->count : b->count;
    uint64_t carry = 0;
    for (uint32_t i = 0; i < count; i++) {
        carry += (i < a->count ? a->limb[i] : 0u);
        carry += (i < b->count ? b->limb[i] : 0u);
        sum->limb[i] = (uint32_t)carry;
        carry >>= 32;
    }
    sum->count = count;
    if (carry == 0) return;
    if (count == YK_WHOLE_LIMBS) {
        *overflow = true;
    } else {
        sum->limb[sum->count++] = (uint32_t)carry;
    }
}

void yk_whole_subtract(YkWhole *rest, const YkWhole *a, const YkWhole *b)
{
    uint64_t borrow = 0;
    for (uint32_t i = 0; i < a->count; i++) {
        uint64_t take = (i < b->count ? b->limb[i] : 0u) + borrow, from = a->limb[i];
        rest->limb[i] = (uint32_t)(from - take);
        borrow = from < take;
    }
    rest->count = a->count;
    trim(rest);
}

void yk_whole_multiply(YkWhole *product, const YkWhole *a, const YkWhole *b, YkOverflow *overflow)
{
    uint32_t count = a->count + b->count;
    product->count = 0;
    if (a->count == 0 || b->count == 0) return;
    if (count > YK_WHOLE_LIMBS + 1) {
        *overflow = true;
        return;
    }
    uint32_t limb[YK_WHOLE_LIMBS + 1];
    memset(limb, 0, count * sizeof *limb);
    for (uint32_t i = 0; i < a->count; i++) {
        uint64_t carry = 0;
        for (uint32_t k = 0; k < b->count; k++) {
            carry += (uint64_t)a->limb[i] * b->limb[k] + limb[i + k];
            limb[i + k] = (uint32_t)carry;
            carry >>= 32;
        }
        limb[i + b->count] = (uint32_t)carry;
    }
    while (count > 0 && limb[count - 1] == 0) count--;
    if (count > YK_WHOLE_LIMBS) {
        *overflow = true;
        return;
    }
    product->count = count;
    memcpy(product->limb, limb, count * sizeof *limb);
}

static void divide_by_limb(YkWhole *quotient, YkWhole *rest, const YkWhole *a, uint32_t b)
{
    uint64_t left = 0;
    if (quotient) quotient->count = a->count;
    for (uint32_t i = a->count; i > 0; i--) {
        left = left << 32 | a->limb[i - 1];
        if (quotient) quotient->limb[i - 1] = (uint32_t)(left / b);
        left %= b;
    }
    if (quotient) trim(quotient);
    *rest = yk_whole(left);
}

static int leading_zeros(uint32_t limb)
{
    int zeros = 0;
    for (; !(limb & 0x80000000u); limb <<= 1) zeros++;
    return zeros;
}

// Computes to[0..count] = a << shift, one limb more than a.
static void shift_up(uint32_t *to, const YkWhole *a, int shift)
{
    uint64_t carry = 0;
    for (uint32_t i = 0; i < a->count; i++) {
        carry |= (uint64_t)a->limb[i] << shift;
        to[i] = (uint32_t)carry;
        carry >>= 32;
    }
    to[a->count] = (uint32_t)carry;
}

// Finds one limb q of the quotient: the largest that fits. u[0..n] -= q * v[0..n); v's highest bit is set.
static uint32_t divide_step(uint32_t *u, const uint32_t *v, uint32_t n)
{
    uint64_t top = (uint64_t)u[n] << 32 | u[n - 1], q = top / v[n - 1], r = top % v[n - 1];
    while (q >> 32 || q * v[n - 2] > (r << 32 | u[n - 2])) {
        q--;
        r += v[n - 1];
        if (r >> 32) break;
    }
    uint64_t borrow = 0, carry = 0;
    for (uint32_t i = 0; i <= n; i++) {
        carry += i < n ? q * v[i] : 0;
        uint64_t take = (carry & 0xffffffffu) + borrow, from = u[i];
        u[i] = (uint32_t)(from - take);
        borrow = from < take;
        carry >>= 32;
    }
    if (!borrow) return (uint32_t)q;
    carry = 0; // q was one too large: add v back
    for (uint32_t i = 0; i <= n; i++) {
        carry += (uint64_t)u[i] + (i < n ? v[i] : 0u);
        u[i] = (uint32_t)carry;
        carry >>= 32;
    }
    return (uint32_t)q - 1;
}

void yk_whole_divide(YkWhole *quotient, YkWhole *rest, const YkWhole *a, const YkWhole *b)
{
    if (yk_whole_compare(a, b) < 0) {
        if (quotient) quotient->count = 0;
        yk_whole_copy(rest, a);
        return;
    }
    if (b->count == 1) {
        divide_by_limb(quotient, rest, a, b->limb[0]);
        return;
    }
    uint32_t u[YK_WHOLE_LIMBS + 1], v[YK_WHOLE_LIMBS + 1], n = b->count, steps = a->count - n + 1;
    int shift = leading_zeros(b->limb[n - 1]);
    shift_up(u, a, shift);
    shift_up(v, b, shift);
    if (quotient) quotient->count = steps;
    for (uint32_t k = steps; k > 0; k--) {
        uint32_t digit = divide_step(u + k - 1, v, n);
        if (quotient) quotient->limb[k - 1] = digit;
    }
    if (quotient) trim(quotient);
    for (uint32_t i = 0; i < n; i++) rest->limb[i] = (uint32_t)(((uint64_t)u[i + 1] << 32 | u[i]) >> shift);
    rest->count = n;
    trim(rest);
}

static uint64_t small_value(const YkWhole *a)
{
    return a->count == 0 ? 0 : a->count == 1 ? a->limb[0] : (uint64_t)a->limb[1] << 32 | a->limb[0];
}

void yk_whole_common(YkWhole *divisor, const YkWhole *a, const YkWhole *b)
{
    YkWhole parts[3]; // room for dividend, divisor and remainder, which take turns
    YkWhole *x = &parts[0], *y = &parts[1], *z = &parts[2];
    yk_whole_copy(x, a);
    yk_whole_copy(y, b);
    while (y->count > 2 || (x->count > 2 && y->count > 0)) {
        yk_whole_divide(NULL, z, x, y);
        YkWhole *free_part = x;
        x = y;
        y = z;
        z = free_part;
    }
    if (y->count == 0) {
        yk_whole_copy(divisor, x);
        return;
    }
    uint64_t m = small_value(x), n = small_value(y);
    while (n != 0) {
        uint64_t left = m % n;
        m = n;
        n = left;
    }
    *divisor = yk_whole(m);
}

double yk_whole_value(const YkWhole *a, int *twos)
{
    double value = 0;
    uint32_t low = a->count > 4 ? a->count - 4 : 0;
    for (uint32_t i = a->count; i > low; i--) value = value * 0x1p32 + a->limb[i - 1];
    *twos = (int)(32 * low);
    return value;
}

void yk_whole_write(const YkWhole *a, YkText *text)
{
    enum { DIGITS = YK_WHOLE_LIMBS * 10 };
    char digits[DIGITS];
    size_t at = DIGITS;
    YkWhole left, next, rest;
    yk_whole_copy(&left, a);
    while (left.count > 0) {
        divide_by_limb(&next, &rest, &left, 1000000000u);
        uint64_t part = small_value(&rest);
        for (int k = 0; k < 9 && (part > 0 || next.count > 0); k++, part /= 10) digits[--at] = (char)('0' + part % 10);
        yk_whole_copy(&left, &next);
    }
    if (at == DIGITS) digits[--at] = '0';
    yk_text_add(text, digits + at, DIGITS - at);
}
