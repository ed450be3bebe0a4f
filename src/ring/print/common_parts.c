// Parts of monomials, and the common part of terms.
#include <string.h>
#include "ring/print/shown.h"

YkMonomial yk_piece_of(YkMonomial monomial, YkRingClass from, YkRingClass to)
{
    uint32_t wanted = ((uint32_t)2 << to) - ((uint32_t)1 << from), first = 0, end = monomial.count;
    while (yk_rank_class(monomial.powers[end - 1].rank) > to) end--;
    while (yk_rank_class(monomial.powers[first].rank) < from) first++;
    return (YkMonomial){monomial.powers + first, end - first, monomial.classes & (wanted | YK_MAY_BE_BELOW)};
}

static YkMonomial with_classes(const YkShownPower *powers, uint32_t count)
{
    YkMonomial monomial = {powers, count, 0};
    for (uint32_t i = 0; i < count; i++) monomial.classes |= yk_shown_class(powers[i]);
    return monomial;
}

static YkShownPower *new_powers(YkSheet *sheet, size_t count)
{
    YkShownPower *powers = yk_arena_take(sheet->arena, (count + 1) * sizeof *powers);
    if (!powers) sheet->failed = true;
    return powers;
}

// Writes the powers of a * b^-1 to out, which has room for all; returns how many.
static uint32_t divide(YkMonomial a, YkMonomial b, YkShownPower *out)
{
    uint32_t i = 0, k = 0, count = 0;
    while (i < a.count || k < b.count) {
        bool from_a = i < a.count && (k == b.count || a.powers[i].rank <= b.powers[k].rank);
        bool from_b = k < b.count && (i == a.count || b.powers[k].rank <= a.powers[i].rank);
        YkShownPower power = {from_a ? a.powers[i].rank : b.powers[k].rank, 0};
        if (from_a) power.exponent += a.powers[i++].exponent;
        if (from_b) power.exponent -= b.powers[k++].exponent;
        if (power.exponent != 0) out[count++] = power;
    }
    return count;
}

YkMonomial yk_quotient(YkSheet *sheet, YkMonomial monomial, YkMonomial divisor)
{
    if (divisor.count == 0) return monomial;
    // The divisor is the last piece of the monomial itself.
    if (monomial.count > 0 && divisor.powers + divisor.count == monomial.powers + monomial.count)
        return with_classes(monomial.powers, monomial.count - divisor.count);
    YkShownPower *powers = new_powers(sheet, monomial.count + divisor.count);
    return with_classes(powers, powers ? divide(monomial, divisor, powers) : 0);
}

// Keeps, of powers[count], the positive ones that the other monomial shares; returns how many.
static uint32_t share(YkShownPower *powers, uint32_t count, YkMonomial other)
{
    uint32_t kept = 0, k = 0;
    for (uint32_t i = 0; i < count; i++) {
        YkShownPower power = powers[i];
        while (k < other.count && other.powers[k].rank < power.rank) k++;
        if (k == other.count) break;
        if (other.powers[k].rank != power.rank) continue;
        if (other.powers[k].exponent < power.exponent) power.exponent = other.powers[k].exponent;
        if (power.exponent > 0) powers[kept++] = power;
    }
    return kept;
}

YkMonomial yk_common_monomial(YkSheet *sheet, const YkShownTerm *terms, size_t count)
{
    uint32_t shared = terms[0].monomial.count;
    YkShownPower *powers = shared > 0 ? new_powers(sheet, shared) : NULL;
    if (!powers) return (YkMonomial){NULL, 0, 0};
    memcpy(powers, terms[0].monomial.powers, shared * sizeof *powers);
    for (size_t i = 0; i < count && shared > 0; i++) shared = share(powers, shared, terms[i].monomial);
    return with_classes(powers, shared);
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

void yk_divide_terms(YkSheet *sheet, YkShownTerm *terms, size_t count, YkMonomial monomial, YkRatio number)
{
    for (size_t i = 0; i < count; i++) {
        terms[i].monomial = yk_quotient(sheet, terms[i].monomial, monomial);
        if (!yk_ratio_divide(terms[i].number, number, &terms[i].number)) sheet->failed = true;
    }
}
