// A polynomial segment: the conditions as they are stated, the linear system in powers of the argument, coefficients
// solved in exact fractions, and the polynomial with its derivatives. Hermite-Birkhoff interpolation: Lorentz, Jetter &
// Riemenschneider 1983.
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "base/number.h"
#include "derive/cam.h"
#include "num/dense.h"
#include "num/exact_system.h"

enum { CONDITIONS_MAX = 25, FRACTION_MAX = 160 };

typedef struct Condition {
    const YkPoisson *at, *value; // as the file writes them; NULL: not to be written exactly
    double place;
    int order;
    YkFraction u; // where it lies in the segment, 0 to 1
} Condition;

typedef struct Polynomial {
    YkDeriveLaw *law;
    const YkLawPart *part;
    YkLawSegment segment;
    Condition conditions[CONDITIONS_MAX];
    size_t count;
    YkDeriveSpan span;
    const YkPoisson *h;                            // the factor before the bracket
    const YkPoisson *shares[CONDITIONS_MAX];       // of each condition: value * beta^order
    const YkPoisson *by_u[CONDITIONS_MAX];         // coefficients of powers of u; NULL: beyond the ring's numbers
    const YkPoisson *coefficients[CONDITIONS_MAX]; // of powers of the argument
    const YkPoisson *symbols[CONDITIONS_MAX];      // C0, C1, ...
    bool is_new;                                   // the first page of this derivation
    bool is_solved, is_rational;                   // by_u are there; and are rational multiples of h
} Polynomial;

// --- Conditions ------------------------------------------------------------------------------------------------------

static bool comes_before(const Condition *a, const Condition *b)
{
    return a->order < b->order || (a->order == b->order && a->place < b->place);
}

// All s, then all v, a, ..., each by ascending place.
static bool collect(Polynomial *p)
{
    YkDerivation *d = p->law->d;
    for (size_t i = 0; i < p->part->given_count; i++) {
        const YkLawGiven *given = &p->part->given[i];
        for (int order = 0; order <= YK_LAW_ORDER; order++) {
            if (!given->d[order].expr) continue;
            if (p->count == CONDITIONS_MAX) return false;
            Condition condition = {.at = yk_derive_given(d, given->at.expr),
                                   .value = yk_derive_given(d, given->d[order].expr),
                                   .place = given->at.value,
                                   .order = order};
            size_t k = p->count++;
            for (; k > 0 && comes_before(&condition, &p->conditions[k - 1]); k--)
                p->conditions[k] = p->conditions[k - 1];
            p->conditions[k] = condition;
        }
    }
    return true;
}

static bool are_written(const Polynomial *p)
{
    for (size_t k = 0; k < p->count; k++)
        if (!p->conditions[k].at || !p->conditions[k].value) return false;
    return true;
}

// lift_v(2/3 pi) = 0.
static void put_condition(const Polynomial *p, const Condition *condition)
{
    YkDeriveLaw *law = p->law;
    static const char *const letters[] = {"s", "v", "a", "j", "p"};
    YkLine *line = yk_page_formula(law->page, NULL);
    if (condition->order < YK_DERIVE_ORDERS)
        yk_line_element(law->page, line, law->shown[condition->order], YK_RING_TEXTBOOK);
    else
        yk_line_words(law->page, line, letters[condition->order]);
    yk_line_sign(law->page, line, "(");
    yk_line_element(law->page, line, condition->at, YK_RING_TEXTBOOK);
    yk_line_sign(law->page, line, ")");
    yk_line_sign(law->page, line, "=");
    yk_line_element(law->page, line, condition->value, YK_RING_TEXTBOOK);
}

// --- The system ------------------------------------------------------------------------------------------------------

// k (k - 1) ... (k - order + 1).
static int64_t falling(size_t k, int order)
{
    int64_t product = 1;
    for (int m = 0; m < order; m++) product *= (int64_t)k - m;
    return k < (size_t)order ? 0 : product;
}

static const YkPoisson *name_coefficient(Polynomial *p, size_t k)
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

static void fill_system(const Polynomial *p, const YkPoisson *const *at, YkShownMatrix *A, YkShownMatrix *x,
                        YkShownMatrix *b)
{
    YkRing *ring = p->law->d->ring;
    size_t n = p->count;
    for (size_t i = 0; i < n; i++) {
        const Condition *condition = &p->conditions[i];
        x->entries[i] = p->symbols[i];
        b->entries[i] = condition->value;
        const YkPoisson *power = yk_ring_rational(ring, 1, 1);
        for (size_t k = (size_t)condition->order; k < n; k++) {
            A->entries[i * n + k] = yk_ring_scale(ring, power, falling(k, condition->order), 1);
            if (k + 1 < n) power = yk_ring_multiply(ring, power, at[i]);
        }
    }
}

// Names for the places, where their powers are too long to be written: x1 = 5/12 pi.
static void name_places(const Polynomial *p, const YkPoisson **at)
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

// Rows in the order of the conditions, columns by powers of the argument.
static void put_system(const Polynomial *p)
{
    YkDeriveLaw *law = p->law;
    YkRing *ring = law->d->ring;
    size_t n = p->count;
    const YkPoisson *at[CONDITIONS_MAX];
    bool is_short = true;
    for (size_t i = 0; i < n; i++) {
        at[i] = p->conditions[i].at;
        is_short &= yk_ring_scale(ring, yk_ring_power(ring, at[i], (int32_t)n), falling(n, 4), 1) != NULL;
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

// sigma_max / sigma_min of the matrix in powers of the argument, by one-sided Jacobi rotations of its columns, which
// keep small values accurate. Source: Demmel & Veselic 1992.
static double condition_number(const Polynomial *p)
{
    size_t n = p->count;
    double *A = malloc((n * n + n) * sizeof *A), *values = A + n * n, largest = 0, smallest = INFINITY;
    if (!A) return NAN;
    for (size_t i = 0; i < n; i++) {
        const YkLawCondition row = {p->conditions[i].place, p->conditions[i].order, 0};
        yk_law_power_row(&row, n, A + i * n);
    }
    yk_singular_values(n, n, A, values);
    for (size_t k = 0; k < n; k++) largest = fmax(largest, values[k]), smallest = fmin(smallest, values[k]);
    free(A);
    return largest / smallest;
}

static void put_condition_number(const Polynomial *p)
{
    char text[YK_NUMBER_SIZE], inner[YK_NUMBER_SIZE];
    double number = condition_number(p);
    yk_number_write_digits(number, 6, text);
    yk_number_write_digits(p->segment.condition_number, 4, inner);
    yk_page_words(
        p->law->page,
        "Condition number of this matrix: %s (2-norm); of the system in Chebyshev polynomials by which `solve` "
        "and `cam` compute: %s.",
        number < 1e15 ? text : "above 1e15", inner);
}

// --- Its solution ----------------------------------------------------------------------------------------------------

// Where the conditions lie in the segment, as fractions; false where that is no rational number.
static bool find_places(Polynomial *p)
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

static bool has_value(const Polynomial *p, size_t k)
{
    return !yk_ring_is_zero(p->conditions[k].value);
}

// In powers of u, one right-hand side for each condition that is not zero.
static bool solve(const Polynomial *p, YkExactSystem *system)
{
    int32_t n = (int32_t)p->count, rights = 0;
    for (size_t k = 0; k < p->count; k++) rights += has_value(p, k);
    if (!yk_exact_new(system, n, n, rights)) return false;
    rights = 0;
    for (int32_t i = 0; i < n; i++) {
        const Condition *condition = &p->conditions[i];
        YkFraction power = yk_fraction(1, 1);
        for (int32_t k = condition->order; k < n; k++) {
            YkFraction by = yk_fraction(falling((size_t)k, condition->order), 1);
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

// What a condition is worth in units of h, as a fraction: exactly where it is one, else as the double nearest to it.
static YkFraction in_units(const Polynomial *p, size_t condition)
{
    YkDerivation *d = p->law->d;
    int64_t over, under;
    const YkPoisson *ratio = yk_ring_divide(d->ring, p->shares[condition], p->h);
    if (ratio && yk_ring_is_rational(ratio, &over, &under)) return yk_fraction(over, under);
    return yk_fraction_of(yk_derive_fixed(d, p->shares[condition]) / yk_derive_fixed(d, p->h));
}

// A coefficient whose fraction is too long for a formula: a symbol c5.
static int32_t enter_digits(const Polynomial *p, size_t k, double value)
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

// c5 = -1234.567...: its digits, and the fraction that it is.
static const YkPoisson *put_digits(const Polynomial *p, size_t k, const YkFraction *exact)
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

static const YkPoisson *coefficient_in_ring(const Polynomial *p, const YkExactSystem *system, int32_t row)
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

static YkFraction coefficient_as_fraction(const Polynomial *p, const YkExactSystem *system, int32_t row,
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

static bool are_rational(const Polynomial *p)
{
    int64_t over, under;
    for (size_t i = 0; i < p->count; i++) {
        const YkPoisson *ratio = yk_ring_divide(p->law->d->ring, p->shares[i], p->h);
        if (!ratio || !yk_ring_is_rational(ratio, &over, &under)) return false;
    }
    return true;
}

// Coefficients of powers of u from the solved system.
static void take_coefficients(Polynomial *p, const YkExactSystem *system)
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

// s = sum c_m ((theta - from) / length)^m in powers of theta.
static void expand(Polynomial *p)
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

// The largest s of the conditions is called h; values that are fractions of it are told by it.
static void find_shares(Polynomial *p)
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
        const Condition *condition = &p->conditions[k];
        const YkPoisson *value = condition->value;
        const YkPoisson *ratio =
            largest && yk_ring_terms(largest) == 1 ? yk_ring_divide(d->ring, value, largest) : NULL;
        if (ratio && yk_ring_is_rational(ratio, &over, &under)) value = yk_ring_scale(d->ring, p->h, over, under);
        if (largest && yk_ring_is_same(condition->value, largest)) value = p->h;
        p->shares[k] = yk_ring_multiply(d->ring, value, yk_ring_power(d->ring, p->span.beta, condition->order));
    }
}

// --- What it comes to ------------------------------------------------------------------------------------------------

// C3 = 27 h/pi^3, and in decimals where the fractions are too long.
static void put_coefficients(const Polynomial *p)
{
    YkDeriveLaw *law = p->law;
    double powers[CONDITIONS_MAX];
    bool has_powers = yk_law_power_coefficients(law->law->law, law->index, powers);
    for (size_t k = 0; k < p->count; k++) {
        char text[YK_NUMBER_SIZE];
        if (p->coefficients[k]) {
            YkLine *line = yk_page_equation(law->page, NULL, p->symbols[k], p->coefficients[k], YK_RING_TEXTBOOK);
            if (line) line->value = yk_ring_is_zero(p->coefficients[k]) ? NULL : p->coefficients[k];
            continue;
        }
        if (!has_powers) continue;
        yk_number_write_digits(powers[k], 15, text);
        yk_page_words(law->page, "C%z is about %s", k, text);
    }
}

// h/beta^m [64 u^3 - 192 u^4 + ...].
static void put_derivative(const Polynomial *p, int order)
{
    YkDeriveLaw *law = p->law;
    YkRing *ring = law->d->ring;
    const YkPoisson *factor = yk_ring_divide(ring, p->h, yk_ring_power(ring, p->span.beta, order));
    const YkPoisson *sum = yk_ring_rational(ring, 0, 1);
    YkLine *line = yk_derive_begin_line(law, order, NULL);
    for (size_t k = (size_t)order; k < p->count; k++) {
        const YkPoisson *c = yk_ring_divide(ring, yk_ring_scale(ring, p->by_u[k], falling(k, order), 1), p->h);
        sum = yk_ring_add(ring, sum, yk_ring_multiply(ring, c, yk_ring_power(ring, p->span.u, (int32_t)k - order)));
    }
    yk_derive_put_bracket(law->page, line, factor, sum, p->span.u);
    yk_derive_end_line(law, line, order, yk_ring_multiply(ring, factor, sum), p->span.u, "");
}

// In powers of theta itself, within the first period.
static void put_in_powers(const Polynomial *p)
{
    YkDeriveLaw *law = p->law;
    YkLine *line = yk_derive_begin_line(law, 0, "in powers");
    bool any = false;
    for (size_t k = 0; k < p->count; k++) {
        if (p->coefficients[k] && yk_ring_is_zero(p->coefficients[k])) continue;
        if (any) yk_line_sign(law->page, line, "+");
        yk_line_element(law->page, line, p->symbols[k], YK_RING_TEXTBOOK);
        if (k > 0)
            yk_line_element(law->page, line, yk_ring_power(law->d->ring, law->theta, (int32_t)k), YK_RING_TEXTBOOK);
        any = true;
    }
    if (!any) yk_line_sign(law->page, line, "0");
}

static void put_solution(Polynomial *p)
{
    YkExactSystem system;
    if (solve(p, &system)) {
        take_coefficients(p, &system);
        expand(p);
    }
    yk_exact_free(&system);
}

// Where the follower stands then: as a condition says, or the sum of the coefficients.
static const YkPoisson *value_at_end(const Polynomial *p)
{
    const YkPoisson *sum = yk_ring_rational(p->law->d->ring, 0, 1);
    for (size_t k = 0; k < p->count; k++)
        if (p->conditions[k].order == 0 && p->conditions[k].place == p->segment.to) return p->conditions[k].value;
    for (size_t k = 0; k < p->count; k++) sum = yk_ring_add(p->law->d->ring, sum, p->by_u[k]);
    return sum;
}

static bool find_span(Polynomial *p)
{
    const Condition *first = &p->conditions[0], *last = first;
    for (size_t k = 1; k < p->count; k++) {
        if (p->conditions[k].place < first->place) first = &p->conditions[k];
        if (p->conditions[k].place > last->place) last = &p->conditions[k];
    }
    return yk_derive_span(p->law, first->at, last->at, false, &p->span);
}

void yk_derive_put_polynomial(YkDeriveLaw *law, const YkLawPart *part, YkLawSegment segment)
{
    Polynomial *p = YK_NEW(law->page->arena, Polynomial, 1);
    if (!p) return;
    *p = (Polynomial){.law = law, .part = part, .segment = segment};
    bool is_short = collect(p);
    if (!is_short || !are_written(p)) {
        yk_page_words(law->page, is_short ? "Its conditions are no polynomials of the parameters."
                                          : "A polynomial of many conditions: `yoke cam` gives its numbers.");
        law->at = law->value = NULL;
        return;
    }
    yk_page_words(law->page, "Conditions:");
    for (size_t k = 0; k < p->count; k++) put_condition(p, &p->conditions[k]);
    if (!find_span(p)) return;
    find_shares(p);
    for (size_t k = 0; k < p->count; k++) p->symbols[k] = name_coefficient(p, k);
    yk_page_words(law->page, "The system in powers of %s, rows in the order of the conditions:", law->theta_name);
    put_system(p);
    put_condition_number(p);
    if (find_places(p)) put_solution(p);
    for (size_t k = 0; k < p->count && p->is_new; k++)
        if (p->coefficients[k])
            yk_derive_define(law->d, yk_ring_next_symbol(law->d->ring, p->symbols[k], -1), p->coefficients[k]);
    put_coefficients(p);
    put_in_powers(p);
    if (p->is_solved)
        for (int order = 0; order < YK_DERIVE_ORDERS; order++) put_derivative(p, order);
    law->at = p->span.to;
    law->value = value_at_end(p);
}
