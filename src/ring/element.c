// Makes, keeps and compares elements.
#include <string.h>
#include "ring/inside.h"

uint64_t yk_poisson_content(const YkPoisson *a, uint64_t divisor)
{
    for (size_t i = 0; i < a->count && divisor != 1; i++) divisor = yk_gcd(yk_magnitude(a->terms[i].number), divisor);
    return divisor;
}

// Divides numbers and denominator by their common divisor.
static void reduce(YkPoisson *a)
{
    int64_t divisor = (int64_t)yk_poisson_content(a, (uint64_t)a->denominator);
    if (divisor == 1) return;
    for (size_t i = 0; i < a->count; i++) a->terms[i].number /= divisor;
    a->denominator /= divisor;
}

const YkPoisson *yk_poisson_make(YkRing *ring, const YkRingTerm *terms, size_t count, int64_t denominator)
{
    if (count == 0 && ring->zero) return ring->zero;
    if (!yk_ring_spend(ring, YK_WORK_ELEMENT + count * YK_WORK_TERM)) return NULL;
    if (count > YK_RING_MADE_MAX - ring->made) return yk_ring_fail(ring, YK_RING_SIZE);
    YkPoisson *a = yk_arena_take(ring->elements, sizeof(YkPoisson) + count * sizeof(YkRingTerm));
    if (!a) return yk_ring_fail(ring, YK_RING_MEMORY);
    *a = (YkPoisson){.denominator = denominator};
    for (size_t i = 0; i < count; i++)
        if (terms[i].number != 0) a->terms[a->count++] = terms[i];
    bool is_zero = a->count == 0 && ring->zero, is_long = a->count > ring->limit;
    if (a->count < count) yk_arena_give_back(ring->elements, a, is_zero ? 0 : sizeof *a + a->count * sizeof *a->terms);
    if (is_zero) return ring->zero;
    ring->made += a->count;
    if (is_long) return yk_ring_fail(ring, YK_RING_SIZE);
    reduce(a);
    return a;
}

const YkPoisson *yk_poisson_term(YkRing *ring, uint64_t key, int64_t number, int64_t denominator)
{
    const YkRingTerm term = {key, number};
    return yk_poisson_make(ring, &term, 1, denominator);
}

void yk_ring_begin_passing(YkRing *ring)
{
    if (!ring->passing) ring->passing = yk_arena_new();
    if (ring->passing) ring->elements = ring->passing; // otherwise everything is kept
    ring->depth++;
}

const YkPoisson *yk_ring_end_passing(YkRing *ring, const YkPoisson *result)
{
    result = yk_ring_keep(ring, result);
    if (--ring->depth > 0 || !ring->passing) return result;
    ring->elements = ring->arena;
    yk_arena_clear(ring->passing);
    return result;
}

const YkPoisson *yk_ring_keep(YkRing *ring, const YkPoisson *a)
{
    if (!a || ring->elements == ring->arena) return a;
    size_t size = sizeof *a + a->count * sizeof *a->terms;
    YkPoisson *kept = yk_arena_take(ring->arena, size);
    return kept ? memcpy(kept, a, size) : yk_ring_fail(ring, YK_RING_MEMORY);
}

bool yk_common_denominator(int64_t a, int64_t b, int64_t *all)
{
    return yk_exact_multiply(a / (int64_t)yk_gcd((uint64_t)a, (uint64_t)b), b, all);
}

size_t yk_ring_terms(const YkPoisson *a)
{
    return a ? a->count : 0;
}

bool yk_ring_is_zero(const YkPoisson *a)
{
    return a && a->count == 0;
}

bool yk_ring_is_same(const YkPoisson *a, const YkPoisson *b)
{
    if (!a || !b) return false;
    if (a == b) return true;
    if (a->count != b->count || a->denominator != b->denominator) return false;
    for (size_t i = 0; i < a->count; i++)
        if (a->terms[i].key != b->terms[i].key || a->terms[i].number != b->terms[i].number) return false;
    return true;
}

bool yk_ring_is_rational(const YkPoisson *a, int64_t *numerator, int64_t *denominator)
{
    if (!a || a->count > 1 || (a->count == 1 && a->terms[0].key != 0)) return false;
    *numerator = a->count == 0 ? 0 : a->terms[0].number;
    *denominator = a->denominator;
    return true;
}

// Compares both without their contents, up to a sign.
bool yk_ring_is_multiple(const YkPoisson *a, const YkPoisson *b, int64_t *over, int64_t *under)
{
    if (!a || !b || a->count != b->count || a->count == 0) return false;
    int64_t left = (int64_t)yk_poisson_content(a, 0), right = (int64_t)yk_poisson_content(b, 0);
    int64_t sign = (a->terms[0].number < 0) != (b->terms[0].number < 0) ? -1 : 1;
    for (size_t i = 0; i < a->count; i++)
        if (a->terms[i].key != b->terms[i].key || a->terms[i].number / left != sign * (b->terms[i].number / right))
            return false;
    YkRatio ratio;
    if (!yk_ratio_multiply((YkRatio){sign * left, 1}, (YkRatio){b->denominator, 1}, &ratio) ||
        !yk_ratio_divide(ratio, (YkRatio){right, 1}, &ratio) ||
        !yk_ratio_divide(ratio, (YkRatio){a->denominator, 1}, &ratio))
        return false;
    *over = ratio.over, *under = ratio.under;
    return true;
}
