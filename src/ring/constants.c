// Numbers of the ring, and its symbols as elements.
#include "ring/inside.h"

const YkPoisson *yk_ring_rational(YkRing *ring, int64_t numerator, int64_t denominator)
{
    YkRatio ratio;
    if (denominator == 0) return yk_ring_fail(ring, YK_RING_DIVISOR);
    if (numerator == 0) return ring->zero;
    if (numerator == 1 && denominator == 1) return ring->one;
    if (!yk_ratio_make(numerator, denominator, &ratio)) return yk_ring_fail(ring, YK_RING_OVERFLOW);
    return yk_poisson_term(ring, 0, ratio.over, ratio.under);
}

const YkPoisson *yk_ring_decimal(YkRing *ring, int64_t mantissa, int32_t exponent)
{
    YkRatio ratio = {mantissa, 1};
    bool fits = mantissa != INT64_MIN;
    if (mantissa == 0) return ring->zero;
    for (; exponent > 0 && fits; exponent--) fits = yk_ratio_multiply(ratio, (YkRatio){10, 1}, &ratio);
    for (; exponent < 0 && fits; exponent++) fits = yk_ratio_multiply(ratio, (YkRatio){1, 10}, &ratio);
    return fits ? yk_poisson_term(ring, 0, ratio.over, ratio.under) : yk_ring_fail(ring, YK_RING_OVERFLOW);
}

const YkPoisson *yk_ring_i(YkRing *ring)
{
    return yk_poisson_term(ring, YK_UNIT_I, 1, 1);
}

const YkPoisson *yk_ring_vector(YkRing *ring, int32_t x, int32_t y)
{
    if (!yk_ring_has_symbol(ring, x) || !yk_ring_has_symbol(ring, y)) return NULL;
    uint32_t along = yk_ring_monomial_of(ring, x, 1), across = yk_ring_monomial_of(ring, y, 1);
    if (along == YK_NO_PRODUCT || across == YK_NO_PRODUCT) return NULL;
    const YkRingTerm terms[] = {{yk_key(0, along, 0), 1}, {yk_key(0, across, YK_UNIT_I), 1}};
    const YkRingTerm swapped[] = {terms[1], terms[0]};
    return yk_poisson_make(ring, terms[0].key < terms[1].key ? terms : swapped, 2, 1);
}

// Divides *rest by all powers of a prime: returns the root of its square part; *odd: whether one factor is left
// over.
static int64_t take_prime(int64_t *rest, int64_t prime, bool *odd)
{
    int64_t root = 1;
    *odd = false;
    for (; *rest % prime == 0; *rest /= prime) {
        if (*odd) root *= prime;
        *odd = !*odd;
    }
    return root;
}

// Returns the whole square root, or 0 if the number is not a square.
static int64_t whole_root(int64_t square)
{
    int64_t root = (int64_t)(sqrt((double)square) + 0.5), product;
    return yk_exact_multiply(root, root, &product) && product == square ? root : 0;
}

const YkPoisson *yk_ring_sqrt(YkRing *ring, int64_t square)
{
    if (square == 0) return ring->zero;
    if (square < 0) return yk_ring_fail(ring, YK_RING_POWER);
    bool odd2, odd3;
    int64_t rest = square, root = take_prime(&rest, 2, &odd2) * take_prime(&rest, 3, &odd3), other = whole_root(rest);
    if (other == 0) return yk_ring_fail(ring, YK_RING_POWER);
    return yk_poisson_term(ring, (odd2 ? YK_UNIT_SQRT2 : 0u) | (odd3 ? YK_UNIT_SQRT3 : 0u), root * other, 1);
}

static const YkPoisson *unit_power(YkRing *ring, int32_t angle, int32_t factor)
{
    if (!yk_ring_has_symbol(ring, angle)) return NULL;
    if (!ring->symbols[angle].is_angle) return yk_ring_fail(ring, YK_RING_NAME);
    uint32_t phase = yk_ring_phase_of(ring, angle, factor);
    return phase == YK_NO_PRODUCT ? NULL : yk_poisson_term(ring, yk_key(phase, 0, 0), 1, 1);
}

const YkPoisson *yk_ring_unit(YkRing *ring, int32_t angle)
{
    return unit_power(ring, angle, 1);
}

const YkPoisson *yk_ring_exp(YkRing *ring, const YkAngleTerm *terms, size_t count)
{
    const YkPoisson *unit = ring->one;
    for (size_t i = 0; i < count; i++)
        unit = yk_ring_multiply(ring, unit, unit_power(ring, terms[i].angle, terms[i].factor));
    return unit;
}

const YkPoisson *yk_ring_cos(YkRing *ring, const YkAngleTerm *terms, size_t count)
{
    return yk_ring_real(ring, yk_ring_exp(ring, terms, count));
}

const YkPoisson *yk_ring_sin(YkRing *ring, const YkAngleTerm *terms, size_t count)
{
    return yk_ring_imaginary(ring, yk_ring_exp(ring, terms, count));
}

// Returns e^(i steps * 15 deg) exactly: cos 15 deg = (sqrt 6 + sqrt 2) / 4, sin 15 deg = (sqrt 6 - sqrt 2) / 4.
static const YkPoisson *fifteenths(YkRing *ring, int32_t steps)
{
    const YkRingTerm first[] = {
        {YK_UNIT_SQRT2, 1}, {YK_UNIT_SQRT2 | YK_UNIT_I, -1}, {YK_UNIT_SURD, 1}, {YK_UNIT_SURD | YK_UNIT_I, 1}};
    return yk_ring_power(ring, yk_poisson_make(ring, first, 4, 4), (steps % 24 + 24) % 24);
}

const YkPoisson *yk_ring_turn(YkRing *ring, int64_t numerator, int64_t denominator)
{
    YkRatio ratio;
    if (denominator == 0) return yk_ring_fail(ring, YK_RING_DIVISOR);
    if (!yk_ratio_make(numerator, denominator, &ratio)) return yk_ring_fail(ring, YK_RING_OVERFLOW);
    if (12 % ratio.under == 0) return fifteenths(ring, (int32_t)(ratio.over % (2 * ratio.under) * (12 / ratio.under)));
    int32_t angle = yk_ring_constant_angle(ring, ratio.under);
    if (ratio.over > YK_POWER_MAX || ratio.over < -YK_POWER_MAX) return yk_ring_fail(ring, YK_RING_POWER);
    return angle < 0 ? NULL : unit_power(ring, angle, (int32_t)ratio.over);
}

const YkPoisson *yk_ring_pi(YkRing *ring)
{
    int32_t pi = yk_ring_constant_angle(ring, 1);
    return pi < 0 ? NULL : yk_ring_of(ring, pi);
}

const YkPoisson *yk_ring_exp_of(YkRing *ring, const YkPoisson *angle)
{
    const YkPoisson *unit = angle ? ring->one : NULL;
    for (size_t i = 0; unit && i < angle->count; i++) {
        uint32_t count;
        const YkRingTerm term = angle->terms[i];
        const YkPower *powers = yk_powers_of(&ring->monomials, yk_key_monomial(term.key), &count);
        if (yk_key_phase(term.key) != 0 || yk_key_unit(term.key) != 0 || count != 1 || powers[0].exponent != 1)
            return NULL;
        int32_t symbol = powers[0].symbol;
        int64_t factor = term.number / angle->denominator;
        if (ring->symbols[symbol].meaning->pi_over == 1) {
            unit = yk_ring_multiply(ring, unit, yk_ring_turn(ring, term.number, angle->denominator));
            continue;
        }
        bool whole = term.number % angle->denominator == 0 && factor >= -YK_POWER_MAX && factor <= YK_POWER_MAX;
        if (!whole || !ring->symbols[symbol].is_angle) return NULL;
        const YkAngleTerm one = {symbol, (int32_t)factor};
        unit = yk_ring_multiply(ring, unit, yk_ring_exp(ring, &one, 1));
    }
    return unit;
}
