// Solves a polynomial segment's system in exact fractions.
#include "base/number.h"
#include "derive/cams/polynomial.h"

enum { FRACTION_MAX = 160 };

// Finds where the conditions lie in the segment, as fractions. Returns false if a place is not a rational number.
bool yk_polynomial_find_places(YkDerivePolynomial *p)
{
    YkRing *ring = p->law->d->ring;
    const YkPoisson *length = p->span.length;
    for (size_t k = 0; k < p->count; k++) {
        int64_t over, under;
        const YkPoisson *off = yk_ring_subtract(ring, p->conditions[k].at, p->span.from);
        const YkPoisson *u = yk_ring_terms(length) == 1 ? yk_ring_divide(ring, off, length) : NULL;
        if (!u || !yk_ring_is_rational(u, &over, &under)) return false;
        p->conditions[k].u = yk_fraction(over, under);
    }
    return yk_ring_status(ring) == YK_RING_OK;
}

static bool has_value(const YkDerivePolynomial *p, size_t k)
{
    return !yk_ring_is_zero(p->conditions[k].value);
}

// Solves in powers of u, with one right-hand side for each condition that is not zero.
static bool solve(const YkDerivePolynomial *p, YkExactSystem *system)
{
    int32_t n = (int32_t)p->count, rights = 0;
    for (size_t k = 0; k < p->count; k++) rights += has_value(p, k);
    if (!yk_exact_new(system, n, n, rights)) {
        p->law->d->failed = true;
        return false;
    }
    rights = 0;
    for (int32_t i = 0; i < n; i++) {
        const YkPolynomialCondition *condition = &p->conditions[i];
        YkFraction power = yk_fraction(1, 1);
        for (int32_t k = condition->order; k < n; k++) {
            YkFraction by = yk_fraction(yk_polynomial_falling((size_t)k, condition->order), 1);
            *yk_exact_cell(system, i, k) = yk_fraction_multiply(&power, &by, &system->overflow);
            power = yk_fraction_multiply(&power, &condition->u, &system->overflow);
        }
        if (has_value(p, (size_t)i)) *yk_exact_cell(system, i, n + rights++) = yk_fraction(1, 1);
    }
    yk_exact_reduce(system);
    return !system->overflow && system->rank == n;
}

static const YkPoisson *scaled(YkDerivation *d, const YkPoisson *a, const YkFraction *by)
{
    const YkPoisson *factor = yk_derive_fraction(d, by);
    return factor ? yk_ring_multiply(d->ring, a, factor) : NULL;
}

// Returns a condition's value in units of h, as a fraction: exactly if it is one, otherwise the nearest double.
static YkFraction in_units(const YkDerivePolynomial *p, size_t condition)
{
    YkDerivation *d = p->law->d;
    int64_t over, under;
    const YkPoisson *ratio = yk_ring_divide(d->ring, p->shares[condition], p->h);
    if (ratio && yk_ring_is_rational(ratio, &over, &under)) return yk_fraction(over, under);
    return yk_fraction_of(yk_derive_fixed(d, p->shares[condition]) / yk_derive_fixed(d, p->h));
}

// Enters a symbol c5 for a coefficient whose fraction is too long for a formula.
static int32_t enter_digits(const YkDerivePolynomial *p, size_t k, double value)
{
    YkDeriveLaw *law = p->law;
    YkText key = {0}, name = {0};
    bool is_new;
    yk_text_format(&key, "%s %z c%z", law->law->name, law->index, k);
    yk_text_format(&name, law->ending[0] ? "c%s_%z" : "c%s%z", law->ending, k);
    int32_t symbol = yk_derive_once(law->d, yk_text_get(&key), yk_text_get(&name), YK_RING_CONSTANT, false, &is_new);
    if (is_new) yk_derive_fix(law->d, symbol, value);
    yk_text_free(&key);
    yk_text_free(&name);
    return symbol;
}

// Writes c5 = -1234.567...: its digits, and the fraction that it is.
static const YkPoisson *put_digits(const YkDerivePolynomial *p, size_t k, const YkFraction *exact)
{
    YkDeriveLaw *law = p->law;
    YkText fraction = {0};
    char digits[YK_NUMBER_SIZE];
    const YkPoisson *c = yk_ring_of(law->d->ring, enter_digits(p, k, yk_fraction_value(exact)));
    YkLine *line = yk_page_formula(law->page, NULL);
    yk_number_write(yk_fraction_value(exact), digits);
    yk_line_element(law->page, line, c, YK_RING_TEXTBOOK);
    yk_line_sign(law->page, line, "=");
    yk_line_words(law->page, line, digits);
    yk_fraction_write(exact, &fraction);
    if (p->is_rational && fraction.length < FRACTION_MAX)
        yk_page_words(law->page, "that is %s", yk_text_get(&fraction));
    yk_text_free(&fraction);
    return yk_ring_multiply(law->d->ring, p->h, c);
}

static const YkPoisson *coefficient_in_ring(const YkDerivePolynomial *p, const YkExactSystem *system, int32_t row)
{
    YkRing *ring = p->law->d->ring;
    const YkPoisson *sum = yk_ring_rational(ring, 0, 1);
    int32_t right = system->columns;
    for (size_t i = 0; i < p->count; i++)
        if (has_value(p, i))
            sum = yk_ring_add(ring, sum, scaled(p->law->d, p->shares[i], yk_exact_cell(system, row, right++)));
    if (yk_ring_status(ring) != YK_RING_OK) yk_ring_clear(ring);
    return sum;
}

static YkFraction coefficient_as_fraction(const YkDerivePolynomial *p, const YkExactSystem *system, int32_t row,
                                          YkOverflow *overflow)
{
    YkFraction sum = yk_fraction(0, 1);
    int32_t right = system->columns;
    for (size_t i = 0; i < p->count; i++) {
        if (!has_value(p, i)) continue;
        YkFraction part = in_units(p, i);
        part = yk_fraction_multiply(&part, yk_exact_cell(system, row, right++), overflow);
        sum = yk_fraction_add(&sum, &part, overflow);
    }
    return sum;
}

static bool are_rational(const YkDerivePolynomial *p)
{
    int64_t over, under;
    for (size_t i = 0; i < p->count; i++) {
        const YkPoisson *ratio = yk_ring_divide(p->law->d->ring, p->shares[i], p->h);
        if (!ratio || !yk_ring_is_rational(ratio, &over, &under)) return false;
    }
    return true;
}

// Takes the coefficients of powers of u from the solved system.
static void take_coefficients(YkDerivePolynomial *p, const YkExactSystem *system)
{
    p->is_solved = true;
    p->is_rational = are_rational(p);
    for (size_t k = 0; k < p->count; k++) {
        int32_t row = system->pivot_row[k];
        YkOverflow overflow = false;
        p->by_u[k] = coefficient_in_ring(p, system, row);
        if (p->by_u[k]) continue;
        YkFraction exact = coefficient_as_fraction(p, system, row, &overflow);
        if (!overflow) p->by_u[k] = put_digits(p, k, &exact);
        p->is_solved &= p->by_u[k] != NULL;
    }
}

// Expands s = sum c_m ((theta - from) / length)^m in powers of theta.
static void expand(YkDerivePolynomial *p)
{
    YkRing *ring = p->law->d->ring;
    const YkPoisson *divisor = yk_ring_terms(p->span.length) == 1 ? p->span.length : p->span.beta;
    const YkPoisson *back = yk_ring_negate(ring, p->span.from);
    for (size_t k = 0; k < p->count; k++) {
        const YkPoisson *sum = yk_ring_rational(ring, 0, 1);
        int64_t binomial = 1; // of m over k
        for (size_t m = k; m < p->count && sum; m++) {
            bool is_there = m == k || !yk_ring_is_zero(back);
            if (is_there && p->by_u[m] && !yk_ring_is_zero(p->by_u[m])) {
                const YkPoisson *share = yk_ring_divide(ring, p->by_u[m], yk_ring_power(ring, divisor, (int32_t)m));
                share = yk_ring_multiply(ring, share, yk_ring_power(ring, back, (int32_t)(m - k)));
                sum = yk_ring_add(ring, sum, yk_ring_scale(ring, share, binomial, 1));
            } else if (is_there && !p->by_u[m]) {
                sum = NULL;
            }
            binomial = binomial * ((int64_t)m + 1) / ((int64_t)m + 1 - (int64_t)k);
        }
        if (yk_ring_status(ring) != YK_RING_OK) yk_ring_clear(ring);
        p->coefficients[k] = sum;
    }
}

// The largest s of the conditions is called h; values that are fractions of it are written as such.
void yk_polynomial_find_shares(YkDerivePolynomial *p)
{
    YkDerivation *d = p->law->d;
    const YkPoisson *largest = NULL;
    double most = 0;
    for (size_t k = 0; k < p->count; k++) {
        double size = fabs(yk_derive_fixed(d, p->conditions[k].value));
        if (p->conditions[k].order != 0 || !(size > most)) continue;
        most = size;
        largest = p->conditions[k].value;
    }
    p->h = largest ? yk_derive_call(p->law, "h", largest) : yk_ring_rational(d->ring, 1, 1);
    for (size_t k = 0; k < p->count; k++) {
        int64_t over, under;
        const YkPolynomialCondition *condition = &p->conditions[k];
        const YkPoisson *value = condition->value;
        const YkPoisson *ratio =
            largest && yk_ring_terms(largest) == 1 ? yk_ring_divide(d->ring, value, largest) : NULL;
        if (ratio && yk_ring_is_rational(ratio, &over, &under)) value = yk_ring_scale(d->ring, p->h, over, under);
        if (largest && yk_ring_is_same(condition->value, largest)) value = p->h;
        p->shares[k] = yk_ring_multiply(d->ring, value, yk_ring_power(d->ring, p->span.beta, condition->order));
    }
}

void yk_polynomial_solve(YkDerivePolynomial *p)
{
    YkExactSystem system;
    if (solve(p, &system)) {
        take_coefficients(p, &system);
        expand(p);
    }
    yk_exact_free(&system);
}
