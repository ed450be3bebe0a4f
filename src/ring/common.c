// Common parts of terms.
#include "ring/shown.h"

static uint32_t or_fail(YkSheet *sheet, uint32_t monomial)
{
    if (monomial == YK_NO_PRODUCT) sheet->failed = true;
    return monomial;
}

uint32_t yk_quotient(YkSheet *sheet, uint32_t monomial, uint32_t divisor)
{
    if (sheet->failed) return YK_NO_PRODUCT;
    return or_fail(sheet, yk_ring_monomial(sheet->ring, monomial, divisor, -1));
}

static uint32_t product_of(YkSheet *sheet, uint32_t product, YkPower power)
{
    uint32_t factor = yk_ring_monomial_of(sheet->ring, power.symbol, power.exponent);
    return or_fail(sheet, factor == YK_NO_PRODUCT ? factor : yk_ring_monomial(sheet->ring, product, factor, 1));
}

uint32_t yk_part_of_classes(YkSheet *sheet, uint32_t monomial, unsigned classes)
{
    uint32_t count, part = 0;
    YkRing *ring = sheet->ring;
    if (sheet->failed) return YK_NO_PRODUCT;
    if (!(yk_ring_classes(ring, monomial) & classes)) return 0;
    if (!(yk_ring_classes(ring, monomial) & ~classes)) return monomial;
    yk_powers_of(&ring->monomials, monomial, &count);
    for (uint32_t i = 0; i < count && part != YK_NO_PRODUCT; i++) {
        const YkPower power = yk_powers_of(&ring->monomials, monomial, &count)[i];
        if (classes >> ring->symbols[power.symbol].kind & 1) part = product_of(sheet, part, power);
    }
    return part;
}

// The positive powers that two monomials share.
static uint32_t shared(YkSheet *sheet, uint32_t a, uint32_t b)
{
    uint32_t count, part = 0;
    const YkRing *ring = sheet->ring;
    yk_powers_of(&ring->monomials, a, &count);
    for (uint32_t i = 0; i < count && part != YK_NO_PRODUCT; i++) {
        YkPower power = yk_powers_of(&ring->monomials, a, &count)[i];
        int32_t other = yk_powers_exponent(&ring->monomials, b, power.symbol);
        if (other < power.exponent) power.exponent = other;
        if (power.exponent > 0) part = product_of(sheet, part, power);
    }
    return part;
}

uint32_t yk_common_monomial(YkSheet *sheet, const YkShownTerm *terms, size_t count)
{
    uint32_t common = shared(sheet, terms[0].monomial, terms[0].monomial);
    for (size_t i = 1; i < count && common != 0 && !sheet->failed; i++)
        common = shared(sheet, common, terms[i].monomial);
    return common;
}

bool yk_common_number(const YkShownTerm *terms, size_t count, YkRatio *common)
{
    uint64_t over = 0;
    int64_t under = 1;
    for (size_t i = 0; i < count; i++) {
        over = yk_gcd(yk_magnitude(terms[i].number.over), over);
        if (!yk_common_denominator(under, terms[i].number.under, &under)) return false;
    }
    *common = (YkRatio){(int64_t)over, under};
    return true;
}
