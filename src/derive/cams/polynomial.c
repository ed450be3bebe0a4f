// Writes a polynomial segment: the conditions as they are stated, the linear system in powers of the argument,
// coefficients solved in exact fractions, and the polynomial with its derivatives. Hermite-Birkhoff interpolation.
// Source: Lorentz, Jetter & Riemenschneider 1983.
#include "base/number.h"
#include "derive/cams/polynomial.h"

// --- conditions

static bool comes_before(const YkPolynomialCondition *a, const YkPolynomialCondition *b)
{
    return a->order < b->order || (a->order == b->order && a->place < b->place);
}

// Collects the conditions: all s, then all v, a, ..., each by ascending place.
static bool collect(YkDerivePolynomial *p)
{
    YkDerivation *d = p->law->d;
    for (size_t i = 0; i < p->part->given_count; i++) {
        const YkLawGiven *given = &p->part->given[i];
        for (int order = 0; order <= YK_LAW_ORDER; order++) {
            if (!given->d[order].expr) continue;
            if (p->count == YK_POLYNOMIAL_CONDITIONS_MAX) return false;
            YkPolynomialCondition condition = {.place = given->at.value, .order = order};
            condition.at = yk_derive_given(d, given->at.expr);
            condition.value = yk_derive_given(d, given->d[order].expr);
            size_t k = p->count++;
            for (; k > 0 && comes_before(&condition, &p->conditions[k - 1]); k--)
                p->conditions[k] = p->conditions[k - 1];
            p->conditions[k] = condition;
        }
    }
    return true;
}

static bool are_written(const YkDerivePolynomial *p)
{
    for (size_t k = 0; k < p->count; k++)
        if (!p->conditions[k].at || !p->conditions[k].value) return false;
    return true;
}

// Writes lift_v(2/3 pi) = 0.
static void put_condition(const YkDerivePolynomial *p, const YkPolynomialCondition *condition)
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

// --- What it comes to

// Writes C3 = 27 h/pi^3, also in decimals if the fractions are too long.
static void put_coefficients(const YkDerivePolynomial *p)
{
    YkDeriveLaw *law = p->law;
    double powers[YK_POLYNOMIAL_CONDITIONS_MAX];
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

// Writes h/beta^m [64 u^3 - 192 u^4 + ...].
static void put_derivative(const YkDerivePolynomial *p, int order)
{
    YkDeriveLaw *law = p->law;
    YkRing *ring = law->d->ring;
    const YkPoisson *factor = yk_ring_divide(ring, p->h, yk_ring_power(ring, p->span.beta, order));
    const YkPoisson *sum = yk_ring_rational(ring, 0, 1);
    YkLine *line = yk_derive_begin_line(law, order, NULL);
    for (size_t k = (size_t)order; k < p->count; k++) {
        const YkPoisson *c =
            yk_ring_divide(ring, yk_ring_scale(ring, p->by_u[k], yk_polynomial_falling(k, order), 1), p->h);
        sum = yk_ring_add(ring, sum, yk_ring_multiply(ring, c, yk_ring_power(ring, p->span.u, (int32_t)k - order)));
    }
    yk_derive_put_bracket(law->page, line, factor, sum, p->span.u);
    yk_derive_end_line(law, line, order, yk_ring_multiply(ring, factor, sum), p->span.u, "");
}

// Writes the polynomial in powers of theta itself, within the first period.
static void put_in_powers(const YkDerivePolynomial *p)
{
    YkDeriveLaw *law = p->law;
    YkRing *ring = law->d->ring;
    YkLine *line = yk_derive_begin_line(law, 0, "in powers");
    const YkPoisson *sum = yk_ring_rational(ring, 0, 1);
    bool any = false;
    for (size_t k = 0; k < p->count; k++) {
        if (p->coefficients[k] && yk_ring_is_zero(p->coefficients[k])) continue;
        if (any) yk_line_sign(law->page, line, "+");
        yk_line_element(law->page, line, p->symbols[k], YK_RING_TEXTBOOK);
        if (k > 0) yk_line_element(law->page, line, yk_ring_power(ring, law->theta, (int32_t)k), YK_RING_TEXTBOOK);
        sum =
            yk_ring_add(ring, sum, yk_ring_multiply(ring, p->symbols[k], yk_ring_power(ring, law->theta, (int32_t)k)));
        any = true;
    }
    if (!any) yk_line_sign(law->page, line, "0");
    if (!line) return;
    line->left = law->position, line->right = sum;
    line->within = yk_ring_divide(ring, yk_ring_subtract(ring, law->theta, p->span.from), p->span.beta);
}

// Returns the follower's position at the end: from a condition, or the sum of the coefficients.
static const YkPoisson *value_at_end(const YkDerivePolynomial *p)
{
    const YkPoisson *sum = yk_ring_rational(p->law->d->ring, 0, 1);
    for (size_t k = 0; k < p->count; k++)
        if (p->conditions[k].order == 0 && p->conditions[k].place == p->segment.to) return p->conditions[k].value;
    for (size_t k = 0; k < p->count; k++) sum = yk_ring_add(p->law->d->ring, sum, p->by_u[k]);
    return sum;
}

static bool find_span(YkDerivePolynomial *p)
{
    const YkPolynomialCondition *first = &p->conditions[0], *last = first;
    for (size_t k = 1; k < p->count; k++) {
        if (p->conditions[k].place < first->place) first = &p->conditions[k];
        if (p->conditions[k].place > last->place) last = &p->conditions[k];
    }
    return yk_derive_span(p->law, first->at, last->at, false, &p->span);
}

void yk_derive_put_polynomial(YkDeriveLaw *law, const YkLawPart *part, YkLawSegment segment)
{
    YkDerivePolynomial *p = YK_NEW(law->page->arena, YkDerivePolynomial, 1);
    if (!p) return;
    *p = (YkDerivePolynomial){.law = law, .part = part, .segment = segment};
    bool is_short = collect(p);
    if (!is_short || !are_written(p)) {
        yk_page_words(law->page, is_short ? "Its conditions are not polynomials of the parameters."
                                          : "A polynomial of many conditions: `yoke cam` gives its numbers.");
        law->at = law->value = NULL;
        return;
    }
    yk_page_words(law->page, "Conditions:");
    for (size_t k = 0; k < p->count; k++) put_condition(p, &p->conditions[k]);
    if (!find_span(p)) return;
    yk_polynomial_find_shares(p);
    for (size_t k = 0; k < p->count; k++) p->symbols[k] = yk_polynomial_name_coefficient(p, k);
    yk_page_words(law->page, "The system in powers of %s, rows in the order of the conditions:", law->theta_name);
    yk_polynomial_put_system(p);
    yk_polynomial_put_condition_number(p);
    if (yk_polynomial_find_places(p)) yk_polynomial_solve(p);
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
