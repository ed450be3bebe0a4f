// The linear system of a polynomial segment.
#include <math.h>
#include <stdlib.h>
#include "base/number.h"
#include "derive/cams/polynomial.h"
#include "num/dense.h"

// Returns k (k - 1) ... (k - order + 1).
int64_t yk_polynomial_falling(size_t k, int order)
{
    int64_t product = 1;
    for (int m = 0; m < order; m++) product *= (int64_t)k - m;
    return k < (size_t)order ? 0 : product;
}

const YkPoisson *yk_polynomial_name_coefficient(YkDerivePolynomial *p, size_t k)
{
    YkDerivation *d = p->law->d;
    YkText key = {0}, name = {0};
    bool is_new;
    yk_text_format(&key, "%s %z C%z", p->law->law->name, p->law->index, k);
    yk_text_format(&name, p->law->ending[0] ? "C%s_%z" : "C%s%z", p->law->ending, k);
    int32_t symbol = yk_derive_once(d, yk_text_get(&key), yk_text_get(&name), YK_RING_CONSTANT, false, &is_new);
    p->is_new |= is_new;
    yk_text_free(&key);
    yk_text_free(&name);
    return yk_ring_of(d->ring, symbol);
}

static void fill_system(const YkDerivePolynomial *p, const YkPoisson *const *at, YkShownMatrix *A, YkShownMatrix *x,
                        YkShownMatrix *b)
{
    YkRing *ring = p->law->d->ring;
    size_t n = p->count;
    for (size_t i = 0; i < n; i++) {
        const YkPolynomialCondition *condition = &p->conditions[i];
        x->entries[i] = p->symbols[i];
        b->entries[i] = condition->value;
        const YkPoisson *power = yk_ring_rational(ring, 1, 1);
        for (size_t k = (size_t)condition->order; k < n; k++) {
            A->entries[i * n + k] = yk_ring_scale(ring, power, yk_polynomial_falling(k, condition->order), 1);
            if (k + 1 < n) power = yk_ring_multiply(ring, power, at[i]);
        }
    }
}

// Gives names to the places if their powers are too long to be written: x1 = 5/12 pi.
static void name_places(const YkDerivePolynomial *p, const YkPoisson **at)
{
    size_t count = 0;
    for (size_t i = 0; i < p->count; i++) {
        size_t same = 0;
        while (same < i && !yk_ring_is_same(p->conditions[same].at, p->conditions[i].at)) same++;
        at[i] = same < i ? at[same] : p->conditions[i].at;
        if (same < i || yk_ring_is_zero(at[i])) continue;
        YkText name = {0};
        yk_text_format(&name, p->law->ending[0] ? "x%z_" : "x%z", ++count);
        at[i] = yk_derive_call(p->law, yk_text_get(&name), p->conditions[i].at);
        yk_text_free(&name);
    }
}

// Writes rows in the order of the conditions, columns by powers of the argument.
void yk_polynomial_put_system(const YkDerivePolynomial *p)
{
    YkDeriveLaw *law = p->law;
    YkRing *ring = law->d->ring;
    size_t n = p->count;
    const YkPoisson *at[YK_POLYNOMIAL_CONDITIONS_MAX];
    bool is_short = true;
    for (size_t i = 0; i < n; i++) {
        at[i] = p->conditions[i].at;
        is_short &= yk_ring_scale(ring, yk_ring_power(ring, at[i], (int32_t)n), yk_polynomial_falling(n, 4), 1) != NULL;
    }
    if (!is_short) {
        yk_ring_clear(ring);
        name_places(p, at);
    }
    YkLine *line = yk_page_formula(law->page, NULL);
    YkShownMatrix *A = yk_line_matrix(law->page, line, n, n), *x = yk_line_matrix(law->page, line, n, 1);
    yk_line_sign(law->page, line, "=");
    YkShownMatrix *b = yk_line_matrix(law->page, line, n, 1);
    if (A && x && b) fill_system(p, at, A, x, b);
}

// Computes sigma_max / sigma_min of the matrix in powers of the argument by one-sided Jacobi rotations of its
// columns, which keep small values accurate. Source: Demmel & Veselic 1992.
static double condition_number(const YkDerivePolynomial *p)
{
    size_t n = p->count;
    double *A = yk_derive_scratch(p->law->d, n * n + n, sizeof *A), largest = 0, smallest = INFINITY;
    if (!A) return NAN;
    double *values = A + n * n;
    for (size_t i = 0; i < n; i++) {
        const YkLawCondition row = {p->conditions[i].place, p->conditions[i].order, 0};
        yk_law_power_row(&row, n, A + i * n);
    }
    yk_singular_values(n, n, A, values);
    for (size_t k = 0; k < n; k++) largest = fmax(largest, values[k]), smallest = fmin(smallest, values[k]);
    free(A);
    return largest / smallest;
}

void yk_polynomial_put_condition_number(const YkDerivePolynomial *p)
{
    char text[YK_NUMBER_SIZE], inner[YK_NUMBER_SIZE];
    double number = condition_number(p);
    yk_number_write_digits(number, 6, text);
    yk_number_write_digits(p->segment.condition_number, 4, inner);
    yk_page_words(p->law->page,
                  "Condition number of this matrix: %s (2-norm); of the system in Chebyshev polynomials by "
                  "which `solve` "
                  "and `cam` compute: %s.",
                  number < 1e15 ? text : "above 1e15", inner);
}
