// Lumps constants: gives every polynomial in constants alone one name.
#include <stdlib.h>
#include "ring/inside.h"

enum { CONSTANTS = 1 << YK_RING_INERTIA | 1 << YK_RING_MASS | 1 << YK_RING_CONSTANT | 1 << YK_RING_GRAVITY };

typedef struct Piece {
    uint64_t rest; // the key without the constants
    YkRingTerm constant, whole;
} Piece;

bool yk_ring_is_constant(const YkRing *ring, int32_t index)
{
    const YkRingSymbol *symbol = &ring->symbols[index];
    return (CONSTANTS & 1 << symbol->kind) && !symbol->rate && !symbol->meaning->partials;
}

static bool is_constant(const void *ring, int32_t symbol)
{
    return yk_ring_is_constant(ring, symbol);
}

bool yk_ring_split_constants(YkRing *ring, uint32_t monomial, uint32_t *constant, uint32_t *rest)
{
    *constant = 0, *rest = monomial;
    if (!(yk_ring_classes(ring, monomial) & CONSTANTS)) return true;
    *constant = yk_ring_part(ring, monomial, is_constant, ring);
    if (*constant != YK_NO_PRODUCT) *rest = yk_ring_monomial(ring, monomial, *constant, -1);
    return *constant != YK_NO_PRODUCT && *rest != YK_NO_PRODUCT;
}

// Splits a term into symbols of constant classes and the rest.
static bool take_apart(YkRing *ring, YkRingTerm term, Piece *piece)
{
    uint32_t constant, rest;
    if (!yk_ring_split_constants(ring, yk_key_monomial(term.key), &constant, &rest)) return false;
    *piece = (Piece){
        yk_key(yk_key_phase(term.key), rest, yk_key_unit(term.key)), {yk_key(0, constant, 0), term.number}, term};
    return true;
}

static int by_rest(const void *a, const void *b)
{
    const Piece *p = a, *q = b;
    if (p->rest != q->rest) return p->rest < q->rest ? -1 : 1;
    return p->constant.key < q->constant.key ? -1 : p->constant.key > q->constant.key;
}

// The pieces with one rest: pieces[first ... end).
typedef struct Group {
    const YkRing *ring;
    uint64_t rest;
    size_t first, end;
} Group;

// Compares by phase, then by monomial and unit of the rest: the order in which lumps get their names does not depend on
// what the ring has made before.
static int by_order_of_rests(const void *a, const void *b)
{
    const Group *p = a, *q = b;
    int order = yk_powers_compare(&p->ring->phases, yk_key_phase(p->rest), yk_key_phase(q->rest));
    if (order == 0) order = yk_powers_compare(&p->ring->monomials, yk_key_monomial(p->rest), yk_key_monomial(q->rest));
    return order != 0 ? order : (int)yk_key_unit(p->rest) - (int)yk_key_unit(q->rest);
}

// Compares by the first class - inertias, masses, numbers last - then as above.
static int compare_constants(YkRing *ring, uint64_t a, uint64_t b)
{
    unsigned left = yk_ring_classes(ring, yk_key_monomial(a)), right = yk_ring_classes(ring, yk_key_monomial(b));
    left &= 0u - left, right &= 0u - right; // the lowest bit
    if (left != right) return left - 1 < right - 1 ? -1 : 1;
    return yk_powers_compare(&ring->monomials, yk_key_monomial(a), yk_key_monomial(b));
}

// Returns the piece whose constants come first.
static const YkRingTerm *first_of(YkRing *ring, const Piece *pieces, size_t count)
{
    const YkRingTerm *first = &pieces[0].constant;
    for (size_t i = 1; i < count; i++)
        if (compare_constants(ring, pieces[i].constant.key, first->key) < 0) first = &pieces[i].constant;
    return first;
}

// Returns the common divisor of the pieces with one rest, with the sign of the first.
static int64_t content_of(const Piece *pieces, size_t count, const YkRingTerm *first)
{
    uint64_t content = 0;
    for (size_t i = 0; i < count && content != 1; i++)
        content = yk_gcd(yk_magnitude(pieces[i].constant.number), content);
    return first->number < 0 ? -(int64_t)content : (int64_t)content;
}

// Returns the lump of pieces over their content. If its numbers are large, for example decimals, its first number
// becomes 1 instead, and the number by which the lump is multiplied grows with it. NULL on failure.
static const YkPoisson *lump_of(YkRing *ring, const Piece *pieces, size_t count, const YkRingTerm *first,
                                int64_t *content)
{
    enum { NUMBER_MAX = 1000 }; // the largest whole number in a lump
    int64_t most = 0, lead = 1;
    if (!yk_gather_room(ring, count)) return NULL;
    for (size_t i = 0; i < count; i++) {
        int64_t number = pieces[i].constant.number / *content;
        ring->gather.terms[i] = (YkRingTerm){pieces[i].constant.key, number};
        if ((int64_t)yk_magnitude(number) > most) most = (int64_t)yk_magnitude(number);
    }
    if (most > NUMBER_MAX) lead = first->number / *content;
    if (!yk_exact_multiply(*content, lead, content)) return yk_ring_fail(ring, YK_RING_OVERFLOW);
    return yk_poisson_make(ring, ring->gather.terms, count, lead);
}

// Puts the terms that replace one rest: a number times the lump's symbol, or what was there. Returns how many there
// are, 0 on failure.
static size_t put_lumped(YkRing *ring, const Piece *pieces, size_t count, YkLumpSymbol symbol_of, void *context,
                         YkRingTerm *out)
{
    bool is_number = count == 1 && yk_key_monomial(pieces[0].constant.key) == 0;
    const YkRingTerm *first = first_of(ring, pieces, count);
    int64_t content = content_of(pieces, count, first);
    int32_t symbol = -1;
    if (!is_number) {
        const YkPoisson *lump = lump_of(ring, pieces, count, first, &content);
        symbol = lump ? symbol_of(context, lump) : -1;
        if (ring->status != YK_RING_OK) return 0;
    }
    for (size_t i = 0; i < count && symbol < 0; i++) out[i] = pieces[i].whole;
    if (symbol < 0) return count;
    uint32_t one = yk_ring_monomial_of(ring, symbol, 1);
    uint32_t monomial = one == YK_NO_PRODUCT ? one : yk_ring_monomial(ring, one, yk_key_monomial(pieces[0].rest), 1);
    *out = (YkRingTerm){yk_key(yk_key_phase(pieces[0].rest), monomial, yk_key_unit(pieces[0].rest)), content};
    return monomial != YK_NO_PRODUCT;
}

// Finds the pieces of each rest, in order; returns how many rests there are.
static size_t find_groups(const YkRing *ring, Piece *pieces, size_t count, Group *groups)
{
    size_t found = 0;
    qsort(pieces, count, sizeof *pieces, by_rest);
    for (size_t start = 0, end; start < count; start = end) {
        for (end = start; end < count && pieces[end].rest == pieces[start].rest; end++) {}
        groups[found++] = (Group){ring, pieces[start].rest, start, end};
    }
    qsort(groups, found, sizeof *groups, by_order_of_rests);
    return found;
}

const YkPoisson *yk_ring_lump(YkRing *ring, const YkPoisson *a, YkLumpSymbol symbol_of, void *context)
{
    if (!a) return NULL;
    Piece *pieces = calloc(a->count + 1, sizeof *pieces);
    YkRingTerm *terms = calloc(a->count + 1, sizeof *terms);
    Group *groups = calloc(a->count + 1, sizeof *groups);
    size_t count = 0, group_count = 0;
    bool well = pieces && terms && groups;
    if (!well) yk_ring_fail(ring, YK_RING_MEMORY);
    for (size_t i = 0; well && i < a->count; i++) well = take_apart(ring, a->terms[i], &pieces[i]);
    if (well) group_count = find_groups(ring, pieces, a->count, groups);
    for (size_t k = 0; well && k < group_count; k++) {
        const Group *group = &groups[k];
        size_t made =
            put_lumped(ring, pieces + group->first, group->end - group->first, symbol_of, context, terms + count);
        well = made > 0;
        count += made;
    }
    yk_gather_begin(ring, a->denominator);
    for (size_t i = 0; well && i < count; i++) well = yk_gather_add(ring, terms[i].key, terms[i].number);
    free(pieces);
    free(terms);
    free(groups);
    return well ? yk_gather_end(ring) : NULL;
}
