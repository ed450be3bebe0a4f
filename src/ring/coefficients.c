// Examines elements: powers and coefficients of a symbol, content, equality under roots.
#include "ring/inside.h"

bool yk_ring_powers(const YkRing *ring, const YkPoisson *a, int32_t symbol, int32_t *lowest, int32_t *highest)
{
    if (!a || a->count == 0) return false;
    for (size_t i = 0; i < a->count; i++) {
        int32_t exponent = yk_powers_exponent(&ring->monomials, yk_key_monomial(a->terms[i].key), symbol);
        if (i == 0 || exponent < *lowest) *lowest = exponent;
        if (i == 0 || exponent > *highest) *highest = exponent;
    }
    return true;
}

static int32_t next_power(const YkPowers *table, uint32_t item, int32_t after, int32_t least)
{
    uint32_t count;
    const YkPower *powers = yk_powers_of(table, item, &count);
    for (uint32_t i = 0; i < count; i++)
        if (powers[i].symbol > after) return least < 0 || powers[i].symbol < least ? powers[i].symbol : least;
    return least;
}

int32_t yk_ring_next_symbol(const YkRing *ring, const YkPoisson *a, int32_t after)
{
    int32_t least = -1;
    for (size_t i = 0; a && i < a->count; i++) {
        least = next_power(&ring->monomials, yk_key_monomial(a->terms[i].key), after, least);
        least = next_power(&ring->phases, yk_key_phase(a->terms[i].key), after, least);
    }
    return least;
}

bool yk_ring_mentions(const YkRing *ring, const YkPoisson *a, int32_t symbol)
{
    for (size_t i = 0; a && i < a->count; i++)
        if (yk_powers_exponent(&ring->monomials, yk_key_monomial(a->terms[i].key), symbol) != 0 ||
            yk_powers_exponent(&ring->phases, yk_key_phase(a->terms[i].key), symbol) != 0)
            return true;
    return false;
}

// Returns the exponent of a symbol in a term, outside of phases.
static int32_t exponent_in(YkRing *ring, YkRingTerm term, int32_t symbol)
{
    uint32_t monomial = yk_key_monomial(term.key);
    if (!(yk_ring_classes(ring, monomial) & 1u << ring->symbols[symbol].kind)) return 0;
    return yk_powers_exponent(&ring->monomials, monomial, symbol);
}

const YkPoisson *yk_ring_coefficient(YkRing *ring, const YkPoisson *a, int32_t symbol, int32_t power)
{
    size_t found = 0;
    if (!a) return NULL;
    for (size_t i = 0; i < a->count; i++) found += exponent_in(ring, a->terms[i], symbol) == power;
    if (found == 0) return ring->zero;
    if (power == 0 && found == a->count) return a;
    uint32_t divisor = yk_ring_monomial_of(ring, symbol, power);
    if (divisor == YK_NO_PRODUCT) return NULL;
    yk_gather_begin_distinct(ring, a->denominator);
    for (size_t i = 0; i < a->count; i++) {
        uint64_t key = a->terms[i].key;
        if (exponent_in(ring, a->terms[i], symbol) != power) continue;
        uint32_t monomial = yk_ring_monomial(ring, yk_key_monomial(key), divisor, -1);
        if (monomial == YK_NO_PRODUCT) ring->gather.failed = true;
        yk_gather_add(ring, yk_key(yk_key_phase(key), monomial, yk_key_unit(key)), a->terms[i].number);
    }
    return yk_gather_end(ring);
}

// Reduces *monomial to its common part with the monomials of all terms. Returns false on failure.
static bool take_common(YkRing *ring, const YkPoisson *a, uint32_t *monomial)
{
    for (size_t i = 0; i < a->count && *monomial != YK_NO_PRODUCT; i++)
        *monomial = yk_ring_common_monomial(ring, *monomial, yk_key_monomial(a->terms[i].key));
    return *monomial != YK_NO_PRODUCT;
}

const YkPoisson *yk_ring_content(YkRing *ring, const YkPoisson *a)
{
    if (!a || a->count == 0) return a;
    uint32_t monomial = yk_key_monomial(a->terms[0].key);
    if (!take_common(ring, a, &monomial)) return NULL;
    return yk_poisson_term(ring, yk_key(0, monomial, 0), (int64_t)yk_poisson_content(a, 0), a->denominator);
}

const YkPoisson *yk_ring_common_content(YkRing *ring, const YkPoisson *a, const YkPoisson *b)
{
    int64_t denominator, of_a, of_b;
    if (!a || !b) return NULL;
    if (a->count == 0 || b->count == 0) return yk_ring_content(ring, a->count == 0 ? b : a);
    uint32_t monomial = yk_key_monomial(a->terms[0].key);
    if (!take_common(ring, a, &monomial) || !take_common(ring, b, &monomial)) return NULL;
    if (!yk_common_denominator(a->denominator, b->denominator, &denominator) ||
        !yk_exact_multiply((int64_t)yk_poisson_content(a, 0), denominator / a->denominator, &of_a) ||
        !yk_exact_multiply((int64_t)yk_poisson_content(b, 0), denominator / b->denominator, &of_b))
        return yk_ring_fail(ring, YK_RING_OVERFLOW);
    int64_t number = (int64_t)yk_gcd((uint64_t)of_a, (uint64_t)of_b);
    return yk_poisson_term(ring, yk_key(0, monomial, 0), number, denominator);
}

// Returns a times root^2k, with the least k that makes all its powers >= 0, and every root^2 replaced by the square:
// zero exactly when a is.
static const YkPoisson *without_root(YkRing *ring, const YkPoisson *a, int32_t symbol)
{
    int32_t lowest, highest;
    if (!yk_ring_powers(ring, a, symbol, &lowest, &highest) || (lowest >= 0 && highest <= 1)) return a;
    const YkPoisson *sum = ring->zero, *square = ring->symbols[symbol].meaning->square,
                    *root = yk_ring_of(ring, symbol);
    int32_t shift = lowest < 0 ? (-lowest + 1) / 2 * 2 : 0;
    for (int32_t power = lowest; power <= highest; power++) {
        const YkPoisson *part = yk_ring_coefficient(ring, a, symbol, power);
        if (!part) return NULL;
        if (part->count == 0) continue;
        part = yk_ring_multiply(ring, part, yk_ring_power(ring, square, (power + shift) / 2));
        if ((power + shift) % 2 != 0) part = yk_ring_multiply(ring, part, root);
        sum = yk_ring_add(ring, sum, part);
    }
    return sum;
}

bool yk_ring_is_equal(YkRing *ring, const YkPoisson *a, const YkPoisson *b)
{
    if (yk_ring_is_same(a, b)) return true;
    const YkPoisson *difference = yk_ring_subtract(ring, a, b);
    // A square mentions only symbols older than its root: going down from the youngest root meets each once.
    for (size_t i = ring->symbol_count; i-- > 0 && difference && difference->count > 0;)
        if (ring->symbols[i].meaning->square) difference = without_root(ring, difference, (int32_t)i);
    return yk_ring_is_zero(difference);
}
