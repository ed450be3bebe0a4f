// Conjugation: i -> -i, e^(i phi) -> e^(-i phi). Real and imaginary parts, dot and cross products.
#include "ring/inside.h"

static bool has_no_phase(const YkPoisson *a)
{
    return a->count == 0 || yk_key_phase(a->terms[a->count - 1].key) == 0; // keys ascend by phase
}

// Returns, for an element without phases, the terms without i, or those with it, divided by i. Keeps their order.
static const YkPoisson *half_of_constant(YkRing *ring, const YkPoisson *a, bool imaginary)
{
    size_t count = 0;
    if (!yk_gather_room(ring, a->count)) return NULL;
    YkRingTerm *out = ring->gather.terms;
    for (size_t i = 0; i < a->count; i++) {
        bool has_i = yk_key_unit(a->terms[i].key) & YK_UNIT_I;
        if (has_i == imaginary) out[count++] = (YkRingTerm){a->terms[i].key & ~(uint64_t)YK_UNIT_I, a->terms[i].number};
    }
    return count == a->count && !imaginary ? a : yk_poisson_make(ring, out, count, a->denominator);
}

// Returns the first term whose key is not below `key`.
static size_t find_key(const YkPoisson *a, size_t from, uint64_t key)
{
    size_t low = from, high = a->count;
    while (low < high) {
        size_t middle = low + (high - low) / 2;
        if (a->terms[middle].key < key)
            low = middle + 1;
        else
            high = middle;
    }
    return low;
}

static size_t end_of_phase(const YkPoisson *a, size_t start)
{
    size_t end = start + 1;
    while (end < a->count && yk_key_phase(a->terms[end].key) == yk_key_phase(a->terms[start].key)) end++;
    return end;
}

// Returns whether count terms from `other` on are the conjugates of those from `start` on, apart from their phases.
static bool are_conjugates(const YkPoisson *a, size_t start, size_t other, size_t count)
{
    const uint64_t rest = ((uint64_t)1 << (YK_MONOMIAL_BITS + YK_UNIT_BITS)) - 1;
    for (size_t i = 0; i < count; i++) {
        const YkRingTerm *left = &a->terms[start + i], *right = &a->terms[other + i];
        bool has_i = yk_key_unit(left->key) & YK_UNIT_I;
        if (((left->key ^ right->key) & rest) != 0 || left->number != (has_i ? -right->number : right->number))
            return false;
    }
    return true;
}

// Checks that every phase has its opposite, with the conjugates of its terms in the same order: makes no elements.
bool yk_ring_is_real(YkRing *ring, const YkPoisson *a)
{
    if (a && a->count > 0 && yk_key_phase(a->terms[a->count - 1].key) == 0) return are_conjugates(a, 0, 0, a->count);
    size_t first = 0, second = 0; // terms of the phases that come first of two opposite ones, and of their opposites
    for (size_t start = 0, end; a && start < a->count; start = end) {
        uint32_t phase = yk_key_phase(a->terms[start].key), opposite = yk_ring_opposite(ring, phase);
        end = end_of_phase(a, start);
        if (opposite == YK_NO_PRODUCT) return false;
        if (opposite < phase) {
            second += end - start;
            continue;
        }
        // The opposite phase often comes right after it.
        bool is_next = end < a->count && yk_key_phase(a->terms[end].key) == opposite;
        size_t other = opposite == phase ? start : is_next ? end : find_key(a, end, yk_key(opposite, 0, 0));
        if (a->count - other < end - start || !are_conjugates(a, start, other, end - start)) return false;
        if (opposite == phase) continue;
        if (yk_key_phase(a->terms[other].key) != opposite) return false;
        if (end_of_phase(a, other) - other != end - start) return false;
        first += end - start;
    }
    return a && first == second;
}

// Returns whether the opposite of a phase occurs as well.
static bool has_opposites(YkRing *ring, const YkPoisson *a)
{
    for (size_t start = 0, end; start < a->count; start = end) {
        uint32_t phase = yk_key_phase(a->terms[start].key), opposite = yk_ring_opposite(ring, phase);
        end = end_of_phase(a, start);
        if (opposite <= phase) continue; // itself, or found from its opposite
        size_t other = find_key(a, end, yk_key(opposite, 0, 0));
        if (other < a->count && yk_key_phase(a->terms[other].key) == opposite) return true;
    }
    return false;
}

// Gathers (sign a + conjugate a) * i^turns / 2, turns 0 or 1, for a without i and with i multiplied in.
static const YkPoisson *half(YkRing *ring, const YkPoisson *a, bool imaginary)
{
    int64_t denominator;
    if (has_no_phase(a)) return half_of_constant(ring, a, imaginary);
    if (yk_ring_is_real(ring, a)) return imaginary ? ring->zero : a;
    if (!yk_exact_multiply(a->denominator, 2, &denominator)) return yk_ring_fail(ring, YK_RING_OVERFLOW);
    yk_gather_begin(ring, denominator);
    ring->gather.is_distinct = !has_opposites(ring, a);
    for (size_t i = 0; i < a->count; i++) {
        uint64_t key = a->terms[i].key;
        int64_t number = a->terms[i].number;
        uint32_t phase = yk_ring_opposite(ring, yk_key_phase(key));
        if (phase == YK_NO_PRODUCT) ring->gather.failed = true;
        bool has_i = yk_key_unit(key) & YK_UNIT_I;
        unsigned unit = yk_key_unit(key) ^ (imaginary ? YK_UNIT_I : 0);
        // real: a + conj a. imaginary: -i a + i conj a; -i times i is 1, -i times 1 is -i, i times -i is 1.
        int64_t direct = imaginary && !has_i ? -number : number, mirrored = has_i && !imaginary ? -number : number;
        if (phase != 0) {
            yk_gather_add(ring, yk_key(yk_key_phase(key), yk_key_monomial(key), unit), direct);
            yk_gather_add(ring, yk_key(phase, yk_key_monomial(key), unit), mirrored);
        } else if (has_i == imaginary) { // the two terms are one
            if (!yk_exact_add(direct, mirrored, &direct))
                ring->gather.failed = yk_ring_fail(ring, YK_RING_OVERFLOW) == NULL;
            yk_gather_add(ring, yk_key(0, yk_key_monomial(key), unit), direct);
        }
    }
    return yk_gather_end(ring);
}

const YkPoisson *yk_ring_conjugate(YkRing *ring, const YkPoisson *a)
{
    if (!a) return NULL;
    yk_gather_begin_distinct(ring, a->denominator);
    for (size_t i = 0; i < a->count; i++) {
        uint64_t key = a->terms[i].key;
        uint32_t phase = yk_ring_opposite(ring, yk_key_phase(key));
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

const YkPoisson *yk_ring_dot(YkRing *ring, const YkPoisson *u, const YkPoisson *v)
{
    return yk_ring_real(ring, yk_ring_multiply(ring, yk_ring_conjugate(ring, u), v));
}

const YkPoisson *yk_ring_cross(YkRing *ring, const YkPoisson *u, const YkPoisson *v)
{
    return yk_ring_imaginary(ring, yk_ring_multiply(ring, yk_ring_conjugate(ring, u), v));
}
