// Lumped constants: every polynomial in constants alone, under one name.
#include <stdlib.h>
#include "ring/inside.h"

enum { CONSTANTS = 1 << YK_RING_INERTIA | 1 << YK_RING_MASS | 1 << YK_RING_CONSTANT | 1 << YK_RING_GRAVITY };

typedef struct Piece {
    uint64_t rest; // the key without the constants
    YkRingTerm constant;
} Piece;

bool yk_ring_is_constant(const YkRing *ring, int32_t index)
{
    const YkRingSymbol *symbol = &ring->symbols[index];
    return (CONSTANTS & 1 << symbol->kind) && !symbol->rate && !symbol->partials;
}

bool yk_ring_split_constants(YkRing *ring, uint32_t monomial, uint32_t *constant, uint32_t *rest)
{
    uint32_t count;
    *constant = 0;
    yk_powers_of(&ring->monomials, monomial, &count);
    for (uint32_t i = 0; i < count && *constant != YK_NO_PRODUCT; i++) {
        const YkPower power = yk_powers_of(&ring->monomials, monomial, &count)[i];
        if (!yk_ring_is_constant(ring, power.symbol)) continue;
        uint32_t one = yk_ring_monomial_of(ring, power.symbol, power.exponent);
        *constant = one == YK_NO_PRODUCT ? one : yk_ring_monomial(ring, *constant, one, 1);
    }
    *rest = *constant == YK_NO_PRODUCT ? YK_NO_PRODUCT : yk_ring_monomial(ring, monomial, *constant, -1);
    return *rest != YK_NO_PRODUCT;
}

// Takes a term apart: symbols of constant classes, and what is left.
static bool take_apart(YkRing *ring, uint64_t key, Piece *piece, int64_t number)
{
    uint32_t constant, rest;
    if (!yk_ring_split_constants(ring, yk_key_monomial(key), &constant, &rest)) return false;
    *piece = (Piece){yk_key(yk_key_phase(key), rest, yk_key_unit(key)), {yk_key(0, constant, 0), number}};
    return true;
}

static int by_rest(const void *a, const void *b)
{
    const Piece *p = a, *q = b;
    if (p->rest != q->rest) return p->rest < q->rest ? -1 : 1;
    return p->constant.key < q->constant.key ? -1 : p->constant.key > q->constant.key;
}

// The sum of one rest's constants as number * lump, the lump's first number positive.
static const YkPoisson *lumped(YkRing *ring, const Piece *pieces, size_t count, int64_t denominator,
                               YkLumpSymbol symbol_of, void *context)
{
    if (!yk_gather_room(ring, count)) return NULL;
    for (size_t i = 0; i < count; i++) ring->gather.terms[i] = pieces[i].constant;
    const YkPoisson *sum = yk_poisson_make(ring, ring->gather.terms, count, denominator);
    if (!sum || (sum->count == 1 && yk_key_monomial(sum->terms[0].key) == 0)) return sum; // a number
    int64_t content = (int64_t)yk_poisson_content(sum);
    if (sum->terms[0].number < 0) content = -content;
    const YkPoisson *lump = yk_ring_scale(ring, sum, sum->denominator, content);
    int32_t symbol = lump ? symbol_of(context, lump) : -1;
    if (symbol < 0) return ring->status == YK_RING_OK ? sum : NULL;
    return yk_ring_scale(ring, yk_ring_of(ring, symbol), content, sum->denominator);
}

const YkPoisson *yk_ring_lump(YkRing *ring, const YkPoisson *a, YkLumpSymbol symbol_of, void *context)
{
    if (!a) return NULL;
    Piece *pieces = calloc(a->count + 1, sizeof *pieces);
    const YkPoisson **parts = calloc(a->count + 1, sizeof *parts), *result = NULL;
    size_t part_count = 0;
    bool well = pieces && parts;
    if (!well) yk_ring_fail(ring, YK_RING_MEMORY);
    for (size_t i = 0; well && i < a->count; i++)
        well = take_apart(ring, a->terms[i].key, &pieces[i], a->terms[i].number);
    if (well) qsort(pieces, a->count, sizeof *pieces, by_rest);
    for (size_t start = 0, end; well && start < a->count; start = end) {
        for (end = start; end < a->count && pieces[end].rest == pieces[start].rest; end++) {}
        const YkPoisson *lump = lumped(ring, pieces + start, end - start, a->denominator, symbol_of, context);
        parts[part_count] = yk_ring_multiply(ring, lump, yk_poisson_term(ring, pieces[start].rest, 1, 1));
        well = parts[part_count++] != NULL;
    }
    if (well) result = yk_ring_sum(ring, parts, part_count);
    free(pieces);
    free(parts);
    return result;
}
