// Products of the keys of terms, and the classes and parts of monomials.
#include "ring/inside.h"

static uint32_t outcome(YkRing *ring, uint32_t item, YkPowersFault fault)
{
    if (fault == YK_POWERS_MEMORY) yk_ring_fail(ring, YK_RING_MEMORY);
    if (fault == YK_POWERS_TOO_LARGE) yk_ring_fail(ring, YK_RING_POWER);
    return item;
}

uint32_t yk_ring_make_monomial(YkRing *ring, uint32_t a, uint32_t b, int32_t times)
{
    YkPowersFault fault;
    uint32_t item = yk_powers_multiply(&ring->monomials, a, b, times, (uint32_t)1 << YK_MONOMIAL_BITS, &fault);
    return outcome(ring, item, fault);
}

uint32_t yk_ring_common_monomial(YkRing *ring, uint32_t a, uint32_t b)
{
    YkPowersFault fault;
    uint32_t item = yk_powers_common(&ring->monomials, a, b, (uint32_t)1 << YK_MONOMIAL_BITS, &fault);
    return outcome(ring, item, fault);
}

uint32_t yk_ring_make_phase(YkRing *ring, uint32_t a, uint32_t b, int32_t times)
{
    YkPowersFault fault;
    uint32_t item = yk_powers_multiply(&ring->phases, a, b, times, (uint32_t)1 << YK_PHASE_BITS, &fault);
    return outcome(ring, item, fault);
}

uint32_t yk_ring_opposite(YkRing *ring, uint32_t phase)
{
    uint32_t opposite = ring->phases.items[phase].note;
    if (phase == 0 || opposite != 0) return opposite;
    opposite = yk_ring_phase(ring, 0, phase, -1);
    if (opposite == YK_NO_PRODUCT) return opposite;
    ring->phases.items[phase].note = opposite;
    ring->phases.items[opposite].note = phase;
    return opposite;
}

unsigned yk_ring_classes(YkRing *ring, uint32_t monomial)
{
    uint32_t *classes = &ring->monomials.items[monomial].note, count;
    if (*classes != 0) return *classes;
    const YkPower *powers = yk_powers_of(&ring->monomials, monomial, &count);
    for (uint32_t i = 0; i < count; i++) *classes |= 1u << ring->symbols[powers[i].symbol].kind;
    return *classes;
}

uint32_t yk_ring_monomial_of(YkRing *ring, int32_t symbol, int32_t exponent)
{
    YkPowersFault fault;
    const YkPower power = {symbol, exponent};
    uint32_t limit = (uint32_t)1 << YK_MONOMIAL_BITS, *known = exponent == 1 ? &ring->symbols[symbol].monomial : NULL;
    if (known && *known != 0) return *known;
    uint32_t item = yk_powers_enter(&ring->monomials, &power, exponent != 0, limit, &fault);
    if (known && item != YK_NO_PRODUCT) *known = item;
    return outcome(ring, item, fault);
}

uint32_t yk_ring_part(YkRing *ring, uint32_t monomial, bool (*is_wanted)(const void *context, int32_t symbol),
                      const void *context)
{
    YkPowersFault fault;
    uint32_t limit = (uint32_t)1 << YK_MONOMIAL_BITS;
    uint32_t part = yk_powers_part(&ring->monomials, monomial, is_wanted, context, limit, &fault);
    return outcome(ring, part, fault);
}

uint32_t yk_ring_phase_of(YkRing *ring, int32_t angle, int32_t factor)
{
    YkPowersFault fault;
    const YkPower power = {angle, factor};
    uint32_t limit = (uint32_t)1 << YK_PHASE_BITS;
    uint32_t item = yk_powers_enter(&ring->phases, &power, factor != 0, limit, &fault);
    return outcome(ring, item, fault);
}
