// Products, powers and quotients.
#include "ring/inside.h"

enum { WORK_PER_TERM = 64 }; // products of terms allowed for each term of the ring's limit

// The denominator of a * b, and the factors that cancel before multiplying: common divisors of one's numbers and the
// other's denominator.
typedef struct Cancelled {
    int64_t a_divisor, b_divisor, denominator;
} Cancelled;

static bool cancel(const YkPoisson *a, const YkPoisson *b, Cancelled *cancelled)
{
    cancelled->a_divisor = (int64_t)yk_poisson_content(a, (uint64_t)b->denominator);
    cancelled->b_divisor = (int64_t)yk_poisson_content(b, (uint64_t)a->denominator);
    return yk_exact_multiply(a->denominator / cancelled->b_divisor, b->denominator / cancelled->a_divisor,
                             &cancelled->denominator);
}

// Multiplies single terms whose numbers have been cancelled.
static const YkPoisson *multiply_terms(YkRing *ring, const YkRingTerm *a, const YkRingTerm *b, const Cancelled *by)
{
    uint64_t key;
    int64_t number;
    if (!yk_ring_key_product(ring, a->key, b->key, &key)) return NULL;
    if (!yk_exact_multiply(a->number / by->a_divisor, b->number / by->b_divisor, &number) ||
        !yk_exact_multiply(number, yk_unit_factor(yk_key_unit(a->key), yk_key_unit(b->key)), &number))
        return yk_ring_fail(ring, YK_RING_OVERFLOW);
    return yk_poisson_term(ring, key, number, by->denominator);
}

const YkPoisson *yk_ring_multiply(YkRing *ring, const YkPoisson *a, const YkPoisson *b)
{
    Cancelled cancelled;
    if (!a || !b) return NULL;
    if (a->count == 0 || b->count == 0) return ring->zero;
    if (yk_ring_is_same(a, ring->one)) return b;
    if (yk_ring_is_same(b, ring->one)) return a;
    if (a->count > ring->limit * WORK_PER_TERM / b->count) return yk_ring_fail(ring, YK_RING_SIZE);
    if (!cancel(a, b, &cancelled)) return yk_ring_fail(ring, YK_RING_OVERFLOW);
    if (a->count == 1 && b->count == 1) return multiply_terms(ring, a->terms, b->terms, &cancelled);
    if (a->count == 1 || b->count == 1)
        yk_gather_begin_distinct(ring, cancelled.denominator);
    else
        yk_gather_begin(ring, cancelled.denominator);
    for (size_t i = 0; i < a->count; i++) {
        if (!yk_ring_spend(ring, b->count * YK_WORK_PRODUCT)) ring->gather.failed = true;
        const YkRingTerm left = {a->terms[i].key, a->terms[i].number / cancelled.a_divisor};
        for (size_t k = 0; k < b->count; k++) {
            const YkRingTerm right = {b->terms[k].key, b->terms[k].number / cancelled.b_divisor};
            if (!yk_gather_add_product(ring, &left, &right, 1)) return yk_gather_end(ring);
        }
    }
    return yk_gather_end(ring);
}

const YkPoisson *yk_ring_product(YkRing *ring, const YkPoisson *const *parts, size_t count)
{
    const YkPoisson *product = ring->one;
    for (size_t i = 0; i < count; i++) product = yk_ring_multiply(ring, product, parts[i]);
    return product;
}

// Returns the conjugate that negates one of i, sqrt 2, sqrt 3 and changes nothing else, phases included.
static const YkPoisson *flip(YkRing *ring, const YkPoisson *a, unsigned unit)
{
    if (!a || !yk_gather_room(ring, a->count)) return NULL;
    YkRingTerm *out = ring->gather.terms;
    for (size_t i = 0; i < a->count; i++) {
        bool negative = (yk_key_unit(a->terms[i].key) & unit) != 0;
        out[i] = (YkRingTerm){a->terms[i].key, negative ? -a->terms[i].number : a->terms[i].number};
    }
    return yk_poisson_make(ring, out, a->count, a->denominator);
}

static bool is_single(const YkPoisson *a)
{
    for (size_t i = 1; i < a->count; i++)
        if (a->terms[i].key >> YK_UNIT_BITS != a->terms[0].key >> YK_UNIT_BITS) return false;
    return a->count > 0;
}

// Returns 1 / a for a single term. Multiplying by conjugates makes the coefficient rational.
static const YkPoisson *reciprocal(YkRing *ring, const YkPoisson *a)
{
    if (!a) return NULL;
    if (!is_single(a)) return yk_ring_fail(ring, YK_RING_DIVISOR);
    uint32_t monomial = yk_ring_monomial(ring, 0, yk_key_monomial(a->terms[0].key), -1);
    uint32_t phase = yk_ring_phase(ring, 0, yk_key_phase(a->terms[0].key), -1);
    if (monomial == YK_NO_PRODUCT || phase == YK_NO_PRODUCT) return NULL;
    if (a->count == 1 && yk_key_unit(a->terms[0].key) == 0) {
        int64_t number = a->terms[0].number, sign = number < 0 ? -1 : 1;
        return yk_poisson_term(ring, yk_key(phase, monomial, 0), sign * a->denominator, sign * number);
    }
    const YkPoisson *inverse = yk_poisson_term(ring, yk_key(phase, monomial, 0), 1, 1);
    const YkPoisson *number = yk_ring_multiply(ring, a, inverse);
    for (unsigned unit = YK_UNIT_I; unit <= YK_UNIT_SQRT3; unit *= 2) {
        const YkPoisson *flipped = flip(ring, number, unit);
        if (yk_ring_is_same(flipped, number)) continue;
        inverse = yk_ring_multiply(ring, inverse, flipped);
        number = yk_ring_multiply(ring, number, flipped);
    }
    return number ? yk_ring_scale(ring, inverse, number->denominator, number->terms[0].number) : NULL;
}

const YkPoisson *yk_ring_divide(YkRing *ring, const YkPoisson *a, const YkPoisson *term)
{
    return yk_ring_multiply(ring, a, reciprocal(ring, term));
}

const YkPoisson *yk_ring_power(YkRing *ring, const YkPoisson *a, int32_t exponent)
{
    if (!a) return NULL;
    if (exponent > YK_POWER_MAX || exponent < -YK_POWER_MAX) return yk_ring_fail(ring, YK_RING_POWER);
    const YkPoisson *base = exponent < 0 ? reciprocal(ring, a) : a, *power = ring->one;
    for (uint32_t rest = (uint32_t)(exponent < 0 ? -exponent : exponent); rest > 0; rest /= 2) {
        if (rest & 1) power = yk_ring_multiply(ring, power, base);
        if (rest > 1) base = yk_ring_multiply(ring, base, base);
        if (!power || !base) return NULL;
    }
    return power;
}
