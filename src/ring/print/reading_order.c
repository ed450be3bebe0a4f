// The reader's order: deterministic, from classes, symbols and powers alone.
#include <string.h>
#include "ring/print/shown.h"

enum { FEW = 6 }; // fewer terms than this are sorted by insertion

YkMonomial yk_monomial(YkSheet *sheet, uint32_t monomial)
{
    uint32_t count, classes = 0;
    const YkRing *ring = sheet->ring;
    const YkPower *of = yk_powers_of(&ring->monomials, monomial, &count);
    YkShownPower *powers = count > 0 ? yk_arena_take(sheet->arena, count * sizeof *powers) : NULL;
    if (count > 0 && !powers) sheet->failed = true;
    for (uint32_t i = 0; powers && i < count; i++) {
        uint32_t kind = ring->symbols[of[i].symbol].kind;
        YkShownPower power = {kind << YK_RANK_BITS | (uint32_t)of[i].symbol, of[i].exponent};
        classes |= yk_shown_class(power);
        uint32_t k = i;
        for (; k > 0 && powers[k - 1].rank > power.rank; k--) powers[k] = powers[k - 1];
        powers[k] = power;
    }
    return (YkMonomial){powers, powers ? count : 0, classes};
}

static int compare_monomials(YkMonomial a, YkMonomial b)
{
    if (a.powers == b.powers && a.count == b.count) return 0;
    for (size_t i = 0; i < a.count && i < b.count; i++) {
        if (a.powers[i].rank != b.powers[i].rank) return a.powers[i].rank < b.powers[i].rank ? -1 : 1;
        if (a.powers[i].exponent != b.powers[i].exponent) return a.powers[i].exponent > b.powers[i].exponent ? -1 : 1;
    }
    return a.count == b.count ? 0 : a.count < b.count ? -1 : 1;
}

bool yk_is_same_monomial(YkMonomial a, YkMonomial b)
{
    return a.count == b.count && compare_monomials(a, b) == 0;
}

int yk_compare_atoms(const YkRing *ring, const YkAtom *a, const YkAtom *b)
{
    int order = yk_powers_compare(&ring->phases, a->phase, b->phase);
    if (order == 0) order = a->shift - b->shift;
    if (order == 0) order = (int)a->function - (int)b->function;
    if (order == 0) order = (int)a->is_imaginary - (int)b->is_imaginary;
    return order != 0 ? order : (int)a->surd - (int)b->surd;
}

static bool precedes(const YkRing *ring, const YkShownTerm *a, const YkShownTerm *b, YkTermOrder order)
{
    int sign = order == YK_BY_ATOM ? yk_compare_atoms(ring, &a->atom, &b->atom) : 0;
    if (sign != 0) return sign < 0;
    if (order == YK_BY_MONOMIAL || order == YK_BY_ATOM) return compare_monomials(a->monomial, b->monomial) <= 0;
    YkRingClass kind = order == YK_BY_RATE ? YK_RING_RATE : YK_RING_ACCELERATION;
    return compare_monomials(yk_part_of(a->monomial, kind, kind), yk_part_of(b->monomial, kind, kind)) <= 0;
}

// Sorts few terms by insertion, more by merging; stable, so that equal terms keep their order on every machine.
static void sort(const YkRing *ring, YkShownTerm *terms, YkShownTerm *room, size_t count, YkTermOrder order)
{
    size_t half = count / 2, i = 0, k = half;
    if (count <= FEW) {
        for (i = 1; i < count; i++) {
            YkShownTerm term = terms[i];
            for (k = i; k > 0 && !precedes(ring, &terms[k - 1], &term, order); k--) terms[k] = terms[k - 1];
            terms[k] = term;
        }
        return;
    }
    sort(ring, terms, room, half, order);
    sort(ring, terms + half, room, count - half, order);
    if (precedes(ring, &terms[half - 1], &terms[half], order)) return;
    memcpy(room, terms, half * sizeof *terms);
    for (size_t at = 0; i < half; at++)
        terms[at] = k == count || precedes(ring, &room[i], &terms[k], order) ? room[i++] : terms[k++];
}

void yk_sort_terms(YkSheet *sheet, YkShownTerm *terms, size_t count, YkTermOrder order)
{
    YkShownTerm *room = count > FEW ? yk_arena_take(sheet->arena, count / 2 * sizeof *room) : NULL;
    if (count > FEW && !room)
        sheet->failed = true;
    else
        sort(sheet->ring, terms, room, count, order);
}
