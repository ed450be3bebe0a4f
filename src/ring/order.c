// The reader's order: deterministic, from classes, symbols and powers alone.
#include <stdlib.h>
#include <string.h>
#include "ring/shown.h"

// Of the powers from `from` on, the one that comes next in order of (class, symbol) after (kind, symbol); NULL after
// the last.
static const YkPower *next_power(const YkRing *ring, uint32_t monomial, const YkPower *after)
{
    uint32_t count;
    const YkPower *powers = yk_powers_of(&ring->monomials, monomial, &count), *best = NULL;
    for (uint32_t i = 0; i < count; i++) {
        YkRingClass kind = ring->symbols[powers[i].symbol].kind;
        YkRingClass low = after ? ring->symbols[after->symbol].kind : YK_RING_INERTIA;
        if (after && (kind < low || (kind == low && powers[i].symbol <= after->symbol))) continue;
        if (!best || kind < ring->symbols[best->symbol].kind) best = &powers[i];
    }
    return best;
}

int yk_compare_monomials(const YkRing *ring, uint32_t a, uint32_t b)
{
    if (a == b) return 0;
    const YkPower *left = NULL, *right = NULL;
    do {
        left = next_power(ring, a, left);
        right = next_power(ring, b, right);
        if (!left || !right) return left ? 1 : right ? -1 : 0;
        YkRingClass left_kind = ring->symbols[left->symbol].kind, right_kind = ring->symbols[right->symbol].kind;
        if (left_kind != right_kind) return left_kind < right_kind ? -1 : 1;
        if (left->symbol != right->symbol) return left->symbol < right->symbol ? -1 : 1;
    } while (left->exponent == right->exponent);
    return left->exponent > right->exponent ? -1 : 1;
}

static int compare_phases(const YkRing *ring, uint32_t a, uint32_t b)
{
    uint32_t left_count, right_count;
    const YkPower *left = yk_powers_of(&ring->phases, a, &left_count),
                  *right = yk_powers_of(&ring->phases, b, &right_count);
    if (left_count != right_count) return left_count < right_count ? -1 : 1;
    for (uint32_t i = 0; i < left_count; i++) {
        if (left[i].symbol != right[i].symbol) return left[i].symbol < right[i].symbol ? -1 : 1;
        if (left[i].exponent != right[i].exponent) return left[i].exponent < right[i].exponent ? -1 : 1;
    }
    return 0;
}

int yk_compare_atoms(const YkRing *ring, const YkAtom *a, const YkAtom *b)
{
    int order = a->phase == b->phase ? 0 : compare_phases(ring, a->phase, b->phase);
    if (order == 0) order = a->shift - b->shift;
    if (order == 0) order = (int)a->function - (int)b->function;
    if (order == 0) order = (int)a->is_imaginary - (int)b->is_imaginary;
    return order != 0 ? order : (int)a->surd - (int)b->surd;
}

static bool precedes(const YkRing *ring, const YkShownTerm *a, const YkShownTerm *b, bool by_atom)
{
    int order = by_atom ? yk_compare_atoms(ring, &a->atom, &b->atom) : 0;
    return (order != 0 ? order : yk_compare_monomials(ring, a->monomial, b->monomial)) <= 0;
}

// Merge sort, stable, so that equal terms keep their order on every machine.
static void sort(const YkRing *ring, YkShownTerm *terms, YkShownTerm *room, size_t count, bool by_atom)
{
    if (count < 2) return;
    size_t half = count / 2, i = 0, k = half;
    sort(ring, terms, room, half, by_atom);
    sort(ring, terms + half, room, count - half, by_atom);
    if (precedes(ring, &terms[half - 1], &terms[half], by_atom)) return;
    memcpy(room, terms, count * sizeof *terms);
    for (size_t at = 0; at < count; at++)
        terms[at] = k == count || (i < half && precedes(ring, &room[i], &room[k], by_atom)) ? room[i++] : room[k++];
}

static void sort_terms(const YkSheet *sheet, YkShownTerm *terms, size_t count, bool by_atom)
{
    YkShownTerm *room =
        count > 1 ? YK_NEW(sheet->arena, YkShownTerm, count) : NULL; // a failed arena fails the sheet later
    if (room) sort(sheet->ring, terms, room, count, by_atom);
}

void yk_sort_by_monomial(const YkSheet *sheet, YkShownTerm *terms, size_t count)
{
    sort_terms(sheet, terms, count, false);
}

void yk_sort_by_atom(const YkSheet *sheet, YkShownTerm *terms, size_t count)
{
    sort_terms(sheet, terms, count, true);
}
