// Sums: merges two sorted elements, gathers many.
#include "ring/inside.h"

// Computes *out = number * factor; returns false with the status on overflow.
static bool scaled(YkRing *ring, int64_t number, int64_t factor, int64_t *out)
{
    if (yk_exact_multiply(number, factor, out)) return true;
    yk_ring_fail(ring, YK_RING_OVERFLOW);
    return false;
}

// Merges a * a_factor + b * b_factor into the gather's terms; returns how many, or SIZE_MAX on failure.
static size_t merge(YkRing *ring, const YkPoisson *a, int64_t a_factor, const YkPoisson *b, int64_t b_factor)
{
    YkRingTerm *out = ring->gather.terms;
    size_t i = 0, k = 0, count = 0;
    while (i < a->count || k < b->count) {
        bool from_a = i < a->count && (k == b->count || a->terms[i].key <= b->terms[k].key);
        bool from_b = k < b->count && (i == a->count || b->terms[k].key <= a->terms[i].key);
        uint64_t key = from_a ? a->terms[i].key : b->terms[k].key;
        int64_t left = 0, right = 0, sum;
        if (from_a && !scaled(ring, a->terms[i++].number, a_factor, &left)) return SIZE_MAX;
        if (from_b && !scaled(ring, b->terms[k++].number, b_factor, &right)) return SIZE_MAX;
        if (!yk_exact_add(left, right, &sum)) {
            yk_ring_fail(ring, YK_RING_OVERFLOW);
            return SIZE_MAX;
        }
        if (sum != 0) out[count++] = (YkRingTerm){key, sum};
    }
    return count;
}

static const YkPoisson *add(YkRing *ring, const YkPoisson *a, const YkPoisson *b, int64_t sign)
{
    if (!a || !b) return NULL;
    if (b->count == 0) return a;
    if (a->count == 0 && sign == 1) return b;
    int64_t denominator, divisor = (int64_t)yk_gcd((uint64_t)a->denominator, (uint64_t)b->denominator);
    if (!yk_exact_multiply(a->denominator / divisor, b->denominator, &denominator))
        return yk_ring_fail(ring, YK_RING_OVERFLOW);
    if (!yk_gather_room(ring, a->count + b->count)) return NULL;
    size_t count = merge(ring, a, b->denominator / divisor, b, sign * (a->denominator / divisor));
    return count == SIZE_MAX ? NULL : yk_poisson_make(ring, ring->gather.terms, count, denominator);
}

const YkPoisson *yk_ring_add(YkRing *ring, const YkPoisson *a, const YkPoisson *b)
{
    return add(ring, a, b, 1);
}

const YkPoisson *yk_ring_subtract(YkRing *ring, const YkPoisson *a, const YkPoisson *b)
{
    return add(ring, a, b, -1);
}

const YkPoisson *yk_ring_sum(YkRing *ring, const YkPoisson *const *parts, size_t count)
{
    int64_t denominator = 1, number;
    for (size_t i = 0; i < count; i++) {
        if (!parts[i]) return NULL;
        if (!yk_common_denominator(denominator, parts[i]->denominator, &denominator))
            return yk_ring_fail(ring, YK_RING_OVERFLOW);
    }
    if (count == 1) return parts[0];
    yk_gather_begin(ring, denominator);
    for (size_t i = 0; i < count; i++)
        for (size_t k = 0; k < parts[i]->count; k++) {
            const YkRingTerm *term = &parts[i]->terms[k];
            if (!scaled(ring, term->number, denominator / parts[i]->denominator, &number)) ring->gather.failed = true;
            if (!yk_gather_add(ring, term->key, ring->gather.failed ? 0 : number)) return yk_gather_end(ring);
        }
    return yk_gather_end(ring);
}

const YkPoisson *yk_ring_negate(YkRing *ring, const YkPoisson *a)
{
    return a ? add(ring, ring->zero, a, -1) : NULL;
}

const YkPoisson *yk_ring_scale(YkRing *ring, const YkPoisson *a, int64_t numerator, int64_t denominator)
{
    if (!a) return NULL;
    YkRatio ratio, whole;
    if (denominator == 0) return yk_ring_fail(ring, YK_RING_DIVISOR);
    if (!yk_ratio_make(numerator, denominator, &ratio)) return yk_ring_fail(ring, YK_RING_OVERFLOW);
    if (ratio.over == 0 || a->count == 0) return ring->zero;
    if (ratio.over == 1 && ratio.under == 1) return a;
    // Computes content / denominator * ratio with everything cancelled first: it overflows only if the result must.
    bool is_whole = a->denominator == 1 && ratio.under == 1;
    int64_t content = is_whole ? 1 : (int64_t)yk_poisson_content(a, 0);
    if (!yk_ratio_multiply((YkRatio){content, a->denominator}, ratio, &whole))
        return yk_ring_fail(ring, YK_RING_OVERFLOW);
    if (!yk_gather_room(ring, a->count)) return NULL;
    YkRingTerm *out = ring->gather.terms;
    for (size_t i = 0; i < a->count; i++) {
        out[i].key = a->terms[i].key;
        int64_t number = content == 1 ? a->terms[i].number : a->terms[i].number / content;
        if (!scaled(ring, number, whole.over, &out[i].number)) return NULL;
    }
    return yk_poisson_make(ring, out, a->count, whole.under);
}
