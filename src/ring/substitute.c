// Substitution of many symbols at once. Terms are sorted by what of them is replaced; each such part is computed once.
#include <stdlib.h>
#include "ring/inside.h"

typedef struct Split {
    uint64_t replaced; // monomial and phase made of the symbols that change, as a key without unit
    YkRingTerm kept;
} Split;

typedef struct Changes {
    const YkRingChange **of; // [symbol count], NULL where a symbol stays
    YkPower *powers;         // room for one product
    size_t capacity;
} Changes;

// The part of a product whose symbols change (in a phase: have a unit; in a monomial: a value).
static uint32_t replaced_part(YkRing *ring, Changes *changes, YkPowers *table, uint32_t item, bool phase)
{
    uint32_t count, kept = 0;
    const YkPower *powers = yk_powers_of(table, item, &count);
    while (changes->capacity < count)
        if (!yk_grow((void **)&changes->powers, changes->capacity, &changes->capacity, sizeof *changes->powers)) {
            yk_ring_fail(ring, YK_RING_MEMORY);
            return YK_NO_PRODUCT;
        }
    for (uint32_t i = 0; i < count; i++) {
        const YkRingChange *change = changes->of[powers[i].symbol];
        if (change && (phase ? change->unit : change->value)) changes->powers[kept++] = powers[i];
    }
    if (kept == 0) return 0;
    YkPowersFault fault;
    uint32_t part = yk_powers_enter(table, changes->powers, kept, (uint32_t)1 << YK_PHASE_BITS, &fault);
    if (part == YK_NO_PRODUCT) yk_ring_fail(ring, fault == YK_POWERS_MEMORY ? YK_RING_MEMORY : YK_RING_POWER);
    return part;
}

static bool split_term(YkRing *ring, Changes *changes, YkRingTerm term, Split *split)
{
    uint32_t monomial = yk_key_monomial(term.key), phase = yk_key_phase(term.key);
    uint32_t in_monomial = replaced_part(ring, changes, &ring->monomials, monomial, false);
    uint32_t in_phase = replaced_part(ring, changes, &ring->phases, phase, true);
    if (in_monomial == YK_NO_PRODUCT || in_phase == YK_NO_PRODUCT) return false;
    uint32_t kept_monomial = yk_ring_monomial(ring, monomial, in_monomial, -1);
    uint32_t kept_phase = yk_ring_phase(ring, phase, in_phase, -1);
    if (kept_monomial == YK_NO_PRODUCT || kept_phase == YK_NO_PRODUCT) return false;
    *split = (Split){yk_key(in_phase, in_monomial, 0),
                     {yk_key(kept_phase, kept_monomial, yk_key_unit(term.key)), term.number}};
    return true;
}

static int compare_splits(const void *a, const void *b)
{
    const Split *left = a, *right = b;
    if (left->replaced != right->replaced) return left->replaced < right->replaced ? -1 : 1;
    return left->kept.key < right->kept.key ? -1 : left->kept.key > right->kept.key;
}

static const YkPoisson *unit_power(YkRing *ring, const YkPoisson *unit, int32_t exponent)
{
    return exponent < 0 ? yk_ring_power(ring, yk_ring_conjugate(ring, unit), -exponent)
                        : yk_ring_power(ring, unit, exponent);
}

// What the replaced part becomes.
static const YkPoisson *image_of(YkRing *ring, const Changes *changes, uint64_t replaced)
{
    const YkPoisson *image = ring->one;
    uint32_t count;
    yk_powers_of(&ring->monomials, yk_key_monomial(replaced), &count);
    for (uint32_t i = 0; i < count; i++) {
        const YkPower power = yk_powers_of(&ring->monomials, yk_key_monomial(replaced), &count)[i];
        const YkPoisson *value = changes->of[power.symbol]->value;
        image = yk_ring_multiply(ring, image, yk_ring_power(ring, value, power.exponent));
    }
    yk_powers_of(&ring->phases, yk_key_phase(replaced), &count);
    for (uint32_t i = 0; i < count; i++) {
        const YkPower power = yk_powers_of(&ring->phases, yk_key_phase(replaced), &count)[i];
        const YkPoisson *unit = changes->of[power.symbol]->unit;
        image = yk_ring_multiply(ring, image, unit_power(ring, unit, power.exponent));
    }
    return image;
}

// The sum over groups of equal replaced parts: image * the kept terms. parts has room for one pointer a split.
static const YkPoisson *add_groups(YkRing *ring, const Changes *changes, const Split *splits, size_t count,
                                   int64_t denominator, const YkPoisson **parts)
{
    size_t part_count = 0;
    for (size_t start = 0, end; start < count; start = end) {
        for (end = start; end < count && splits[end].replaced == splits[start].replaced; end++) {}
        const YkPoisson *image = image_of(ring, changes, splits[start].replaced);
        if (!image || !yk_gather_room(ring, end - start)) return NULL;
        for (size_t i = start; i < end; i++) ring->gather.terms[i - start] = splits[i].kept;
        const YkPoisson *kept = yk_poisson_make(ring, ring->gather.terms, end - start, denominator);
        parts[part_count++] = yk_ring_multiply(ring, image, kept);
    }
    return yk_ring_sum(ring, parts, part_count);
}

static const YkPoisson *substitute(YkRing *ring, Changes *changes, const YkPoisson *a)
{
    Split *splits = calloc(a->count + 1, sizeof *splits);
    const YkPoisson **parts = calloc(a->count + 1, sizeof *parts), *result = NULL;
    bool well = splits && parts;
    if (!well) yk_ring_fail(ring, YK_RING_MEMORY);
    for (size_t i = 0; i < a->count && well; i++) well = split_term(ring, changes, a->terms[i], &splits[i]);
    if (well) {
        qsort(splits, a->count, sizeof *splits, compare_splits);
        result = add_groups(ring, changes, splits, a->count, a->denominator, parts);
    }
    free(splits);
    free(parts);
    return result;
}

const YkPoisson *yk_ring_substitute(YkRing *ring, const YkPoisson *a, const YkRingChange *changes, size_t count)
{
    if (!a) return NULL;
    for (size_t i = 0; i < count; i++)
        if (changes[i].symbol < 0 || (size_t)changes[i].symbol >= ring->symbol_count)
            return yk_ring_fail(ring, YK_RING_NAME);
    Changes table = {.of = calloc(ring->symbol_count + 1, sizeof *table.of)};
    if (!table.of) return yk_ring_fail(ring, YK_RING_MEMORY);
    for (size_t i = 0; i < count; i++) table.of[changes[i].symbol] = &changes[i];
    const YkPoisson *result = substitute(ring, &table, a);
    free(table.of);
    free(table.powers);
    return result;
}
