// Conjugation: i -> -i, e^(i phi) -> e^(-i phi). Real and imaginary parts, dot and cross products.
#include "ring/inside.h"

// Gathers (sign a + conjugate a) * i^turns / 2, turns 0 or 1, a without i and with it turned.
static const YkPoisson *half(YkRing *ring, const YkPoisson *a, bool imaginary)
{
    int64_t denominator;
    if (!yk_exact_multiply(a->denominator, 2, &denominator)) return yk_ring_fail(ring, YK_RING_OVERFLOW);
    yk_gather_begin(ring, denominator);
    for (size_t i = 0; i < a->count; i++) {
        uint64_t key = a->terms[i].key;
        int64_t number = a->terms[i].number;
        uint32_t phase = yk_ring_phase(ring, 0, yk_key_phase(key), -1);
        if (phase == YK_NO_PRODUCT) ring->gather.failed = true;
        bool has_i = yk_key_unit(key) & YK_UNIT_I;
        unsigned unit = yk_key_unit(key) ^ (imaginary ? YK_UNIT_I : 0);
        // real: a + conj a. imaginary: -i a + i conj a; -i times i is 1, -i times 1 is -i, i times -i is 1.
        int64_t direct = imaginary && !has_i ? -number : number, mirrored = has_i && !imaginary ? -number : number;
        yk_gather_add(ring, yk_key(yk_key_phase(key), yk_key_monomial(key), unit), direct);
        yk_gather_add(ring, yk_key(phase, yk_key_monomial(key), unit), mirrored);
    }
    return yk_gather_end(ring);
}

const YkPoisson *yk_ring_conjugate(YkRing *ring, const YkPoisson *a)
{
    if (!a) return NULL;
    yk_gather_begin(ring, a->denominator);
    for (size_t i = 0; i < a->count; i++) {
        uint64_t key = a->terms[i].key;
        uint32_t phase = yk_ring_phase(ring, 0, yk_key_phase(key), -1);
        if (phase == YK_NO_PRODUCT) ring->gather.failed = true;
        bool negative = yk_key_unit(key) & YK_UNIT_I;
        yk_gather_add(ring, yk_key(phase, yk_key_monomial(key), yk_key_unit(key)),
                      negative ? -a->terms[i].number : a->terms[i].number);
    }
    return yk_gather_end(ring);
}

const YkPoisson *yk_ring_real(YkRing *ring, const YkPoisson *a)
{
    return a ? half(ring, a, false) : NULL;
}

const YkPoisson *yk_ring_imaginary(YkRing *ring, const YkPoisson *a)
{
    return a ? half(ring, a, true) : NULL;
}

bool yk_ring_is_real(YkRing *ring, const YkPoisson *a)
{
    return yk_ring_is_same(a, yk_ring_conjugate(ring, a));
}

const YkPoisson *yk_ring_dot(YkRing *ring, const YkPoisson *u, const YkPoisson *v)
{
    return yk_ring_real(ring, yk_ring_multiply(ring, yk_ring_conjugate(ring, u), v));
}

const YkPoisson *yk_ring_cross(YkRing *ring, const YkPoisson *u, const YkPoisson *v)
{
    return yk_ring_imaginary(ring, yk_ring_multiply(ring, yk_ring_conjugate(ring, u), v));
}
