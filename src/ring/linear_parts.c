// Takes an element that is linear in some symbols apart, in one walk over its terms.
#include <stdlib.h>
#include <string.h>
#include "ring/inside.h"

typedef struct Split {
    YkRing *ring;
    const YkPoisson *a;
    const int32_t *symbols;
    size_t count;
    uint64_t marks;     // marks of all these symbols
    uint32_t *place;    // per symbol of the ring: its index in `symbols` + 1, or 0
    uint32_t *of;       // per term: the index + 1 of its symbol, or 0
    uint32_t *starts;   // [count + 2]: where the terms of a symbol start in `in_order`
    uint32_t *in_order; // terms; those without any of the symbols come first
} Split;

// Returns the index + 1 of the one symbol in a monomial, 0 if there is none, UINT32_MAX if the monomial is not linear.
static uint32_t place_in(const Split *s, uint32_t monomial)
{
    uint32_t count, place = 0;
    if (!(s->ring->monomials.items[monomial].marks & s->marks)) return 0;
    const YkPower *powers = yk_powers_of(&s->ring->monomials, monomial, &count);
    for (uint32_t i = 0; i < count; i++) {
        uint32_t here = s->place[powers[i].symbol];
        if (here == 0) continue;
        if (place != 0 || powers[i].exponent != 1) return UINT32_MAX;
        place = here;
    }
    return place;
}

// Sorts the terms by symbol, by counting. Returns false with the status if the element is not linear.
static bool sort_by_symbol(Split *s)
{
    for (size_t k = 0; k < s->count; k++) {
        if (s->symbols[k] < 0) return yk_ring_fail(s->ring, YK_RING_MEMORY) != NULL; // it could not be entered
        if (s->place[s->symbols[k]] == 0) s->place[s->symbols[k]] = (uint32_t)k + 1;
        s->marks |= yk_mark(s->symbols[k]);
    }
    for (size_t i = 0; i < s->a->count; i++) {
        s->of[i] = place_in(s, yk_key_monomial(s->a->terms[i].key));
        if (s->of[i] == UINT32_MAX) return yk_ring_fail(s->ring, YK_RING_POWER) != NULL;
        s->starts[s->of[i] + 1]++;
    }
    for (size_t k = 0; k <= s->count; k++) s->starts[k + 1] += s->starts[k];
    for (size_t i = 0; i < s->a->count; i++) s->in_order[s->starts[s->of[i]]++] = (uint32_t)i;
    return true; // starts[k] is now where the terms of place k end
}

// Returns the terms at one place, without their symbol.
static const YkPoisson *part(const Split *s, uint32_t place)
{
    YkRing *ring = s->ring;
    uint32_t first = place == 0 ? 0 : s->starts[place - 1], end = s->starts[place], one = 0;
    if (first == end) return ring->zero;
    if (place == 0 && end == s->a->count) return s->a;
    if (place > 0) one = yk_ring_monomial_of(ring, s->symbols[place - 1], 1);
    if (one == YK_NO_PRODUCT) return NULL;
    yk_gather_begin_distinct(ring, s->a->denominator);
    for (uint32_t i = first; i < end; i++) {
        const YkRingTerm *term = &s->a->terms[s->in_order[i]];
        uint32_t monomial = yk_ring_monomial(ring, yk_key_monomial(term->key), one, -1);
        if (monomial == YK_NO_PRODUCT) ring->gather.failed = true;
        yk_gather_add(ring, yk_key(yk_key_phase(term->key), monomial, yk_key_unit(term->key)), term->number);
    }
    return yk_gather_end(ring);
}

const YkPoisson *yk_ring_split(YkRing *ring, const YkPoisson *a, const int32_t *symbols, size_t count,
                               const YkPoisson **coefficients, size_t wanted)
{
    if (!a) return NULL;
    size_t room = ring->symbol_count + 2 * a->count + count + 2;
    uint32_t *place = calloc(room, sizeof *place), *of = place + ring->symbol_count;
    if (!place) return yk_ring_fail(ring, YK_RING_MEMORY);
    Split s = {ring, a, symbols, count, 0, place, of, of + a->count, of + a->count + count + 2};
    const YkPoisson *rest = NULL;
    if (sort_by_symbol(&s)) {
        for (size_t k = 0; k < wanted; k++) coefficients[k] = part(&s, (uint32_t)k + 1);
        rest = part(&s, 0);
    }
    free(place);
    return rest;
}
