// Evaluates elements in numbers.
#include "ring/inside.h"

static double whole_power(double base, int32_t exponent)
{
    double power = 1;
    for (uint32_t rest = (uint32_t)(exponent < 0 ? -exponent : exponent); rest > 0; rest /= 2) {
        if (rest & 1) power *= base;
        base *= base;
    }
    return exponent < 0 ? 1 / power : power;
}

static double monomial_value(const YkRing *ring, uint32_t monomial, const double *values)
{
    uint32_t count;
    const YkPower *powers = yk_powers_of(&ring->monomials, monomial, &count);
    double value = 1;
    for (uint32_t i = 0; i < count; i++) value *= whole_power(values[powers[i].symbol], powers[i].exponent);
    return value;
}

static double phase_value(const YkRing *ring, uint32_t phase, const double *values)
{
    uint32_t count;
    const YkPower *powers = yk_powers_of(&ring->phases, phase, &count);
    double value = 0;
    for (uint32_t i = 0; i < count; i++) value += powers[i].exponent * values[powers[i].symbol];
    return value;
}

// Returns a term's magnitude with its sign, before the element's denominator.
static double term_value(const YkRing *ring, const YkRingTerm *term, const double *values)
{
    double size = (double)term->number * monomial_value(ring, yk_key_monomial(term->key), values);
    if (yk_key_unit(term->key) & YK_UNIT_SQRT2) size *= sqrt(2);
    if (yk_key_unit(term->key) & YK_UNIT_SQRT3) size *= sqrt(3);
    return size;
}

YkVec yk_ring_value(const YkRing *ring, const YkPoisson *a, const double *values)
{
    YkVec sum = {0, 0}, unit = {1, 0};
    if (!a) return yk_vec(NAN, NAN);
    for (size_t i = 0; i < a->count; i++) {
        uint64_t key = a->terms[i].key;
        if (i == 0 || yk_key_phase(key) != yk_key_phase(a->terms[i - 1].key))
            unit = yk_unit(phase_value(ring, yk_key_phase(key), values));
        YkVec term = yk_scale(term_value(ring, &a->terms[i], values), unit);
        sum = yk_add(sum, yk_key_unit(key) & YK_UNIT_I ? yk_quarter(term) : term);
    }
    return yk_vec(sum.x / (double)a->denominator, sum.y / (double)a->denominator);
}

double yk_ring_magnitude(const YkRing *ring, const YkPoisson *a, const double *values)
{
    double sum = 0;
    if (!a) return NAN;
    for (size_t i = 0; i < a->count; i++) sum += fabs(term_value(ring, &a->terms[i], values));
    return sum / (double)a->denominator;
}

void yk_ring_complete(YkRing *ring, double *values)
{
    for (size_t i = 0; i < ring->symbol_count; i++) {
        const YkRingSymbol *symbol = &ring->symbols[i];
        if (symbol->meaning->pi_over > 0) values[i] = YK_PI / (double)symbol->meaning->pi_over;
        if (symbol->meaning->square) values[i] = sqrt(yk_ring_value(ring, symbol->meaning->square, values).x);
    }
}
