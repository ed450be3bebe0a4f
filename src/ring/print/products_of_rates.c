// Products of rates as the books print them: theta2' (2 theta1' + theta2'), (theta1' + theta2')^2.
#include <string.h>
#include "ring/print/shown.h"

enum { RATES_MAX = 32 };

// A quadratic form in rates: S[i][k] symmetric.
typedef struct Form {
    uint32_t rates[RATES_MAX]; // ranks
    size_t count;
    YkRatio S[RATES_MAX][RATES_MAX];
} Form;

static bool index_of(Form *form, uint32_t rate, size_t *index)
{
    for (*index = 0; *index < form->count; ++*index)
        if (form->rates[*index] == rate) return true;
    if (form->count == RATES_MAX) return false;
    form->rates[form->count++] = rate;
    for (size_t i = 0; i < form->count; i++) form->S[i][*index] = form->S[*index][i] = (YkRatio){0, 1};
    return true;
}

// Returns whether the rates are of second degree, in one or two rates.
static bool is_quadratic(YkMonomial rates)
{
    if (rates.count == 1) return rates.powers[0].exponent == 2;
    return rates.count == 2 && rates.powers[0].exponent == 1 && rates.powers[1].exponent == 1;
}

// Reads a quadratic form. Returns false if a term is not of second degree, or there are too many rates.
static bool read_form(const YkShownTerm *terms, size_t count, Form *form)
{
    form->count = 0;
    for (size_t i = 0; i < count; i++) {
        size_t a, b;
        const YkShownPower *powers = terms[i].monomial.powers;
        if (!is_quadratic(terms[i].monomial)) return false;
        bool is_square = terms[i].monomial.count == 1;
        if (!index_of(form, powers[0].rank, &a) || !index_of(form, powers[is_square ? 0 : 1].rank, &b)) return false;
        YkRatio value = terms[i].number;
        if (!is_square && !yk_ratio_multiply(value, (YkRatio){1, 2}, &value)) return false;
        form->S[a][b] = form->S[b][a] = value;
    }
    return true;
}

// Sorts the rates in ascending order, and the rows and columns with them.
static void sort_form(Form *form)
{
    for (size_t i = 1; i < form->count; i++)
        for (size_t k = i; k > 0 && form->rates[k] < form->rates[k - 1]; k--) {
            uint32_t rate = form->rates[k];
            form->rates[k] = form->rates[k - 1];
            form->rates[k - 1] = rate;
            for (size_t j = 0; j < form->count; j++) {
                YkRatio held = form->S[k][j];
                form->S[k][j] = form->S[k - 1][j];
                form->S[k - 1][j] = held;
            }
            for (size_t j = 0; j < form->count; j++) {
                YkRatio held = form->S[j][k];
                form->S[j][k] = form->S[j][k - 1];
                form->S[j][k - 1] = held;
            }
        }
}

// Returns whether the form has rank one with pivot k: S[i][j] S[k][k] = S[i][k] S[k][j] for all.
static bool is_square_at(const Form *form, size_t k)
{
    if (form->S[k][k].over == 0) return false;
    for (size_t i = 0; i < form->count; i++)
        for (size_t j = 0; j < form->count; j++) {
            YkRatio left, right;
            if (!yk_ratio_multiply(form->S[i][j], form->S[k][k], &left) ||
                !yk_ratio_multiply(form->S[i][k], form->S[k][j], &right) || left.over != right.over ||
                left.under != right.under)
                return false;
        }
    return true;
}

// Returns whether every term contains rate k.
static bool is_common(const Form *form, size_t k)
{
    for (size_t i = 0; i < form->count; i++)
        for (size_t j = 0; j < form->count; j++)
            if (i != k && j != k && form->S[i][j].over != 0) return false;
    return true;
}

static YkMonomial rate_power(YkSheet *sheet, uint32_t rate, int32_t exponent)
{
    YkShownPower *power = yk_arena_take(sheet->arena, sizeof *power);
    if (!power) sheet->failed = true;
    if (power) *power = (YkShownPower){rate, exponent};
    return (YkMonomial){power, power ? 1 : 0, 1u << YK_RING_RATE};
}

// Shows the linear form with these coefficients as factor * (whole combination, first sign +)^exponent: a symbol or a
// sum. The factor is that of the form, not raised. Returns NULL on overflow.
static YkShow *linear_form(YkSheet *sheet, const Form *form, const YkRatio *coefficients, int32_t exponent,
                           YkRatio *factor)
{
    YkShownTerm terms[RATES_MAX];
    size_t count = 0;
    for (size_t i = 0; i < form->count; i++)
        if (coefficients[i].over != 0)
            terms[count++] = (YkShownTerm){rate_power(sheet, form->rates[i], 1), coefficients[i], {0}};
    if (count == 0 || !yk_common_number(terms, count, factor)) return NULL;
    if (terms[0].number.over < 0) factor->over = -factor->over;
    if (count == 1) {
        uint32_t rate = terms[0].monomial.count > 0 ? terms[0].monomial.powers[0].rank : 0;
        return yk_show_term(sheet, (YkRatio){1, 1}, rate_power(sheet, rate, exponent), NULL);
    }
    YkShow *sum = yk_show(sheet, YK_SHOW_SUM);
    for (size_t i = 0; i < count; i++) {
        if (!yk_ratio_divide(terms[i].number, *factor, &terms[i].number)) return NULL;
        yk_show_append(sum, yk_show_term(sheet, terms[i].number, terms[i].monomial, NULL));
    }
    if (sum) sum->exponent = exponent;
    return sum;
}

static YkShow *square(YkSheet *sheet, const Form *form, size_t k, YkRatio *factor)
{
    YkRatio coefficients[RATES_MAX], c;
    for (size_t i = 0; i < form->count; i++)
        if (!yk_ratio_divide(form->S[k][i], form->S[k][k], &coefficients[i])) return NULL;
    YkShow *power = linear_form(sheet, form, coefficients, 2, &c);
    if (!power || !yk_ratio_multiply(c, c, factor) || !yk_ratio_multiply(*factor, form->S[k][k], factor)) return NULL;
    return yk_show_product(sheet, power);
}

static YkShow *common_rate(YkSheet *sheet, const Form *form, size_t k, YkRatio *factor)
{
    YkRatio coefficients[RATES_MAX];
    for (size_t i = 0; i < form->count; i++)
        if (!yk_ratio_multiply(form->S[k][i], (YkRatio){i == k ? 1 : 2, 1}, &coefficients[i])) return NULL;
    YkShow *linear = linear_form(sheet, form, coefficients, 1, factor);
    YkShow *rate = yk_show_term(sheet, (YkRatio){1, 1}, rate_power(sheet, form->rates[k], 1), NULL);
    YkShow *product = yk_show_product(sheet, rate);
    yk_show_append(product, linear);
    return linear ? product : NULL;
}

static YkShow *factored(YkSheet *sheet, const YkShownTerm *terms, size_t count, YkRatio *factor)
{
    Form form;
    if (count == 1 && is_quadratic(terms->monomial)) {
        *factor = terms->number;
        return yk_show_product(sheet, yk_show_term(sheet, (YkRatio){1, 1}, terms->monomial, NULL));
    }
    if (!read_form(terms, count, &form)) return NULL;
    sort_form(&form);
    for (size_t k = 0; k < form.count; k++)
        if (is_square_at(&form, k)) return square(sheet, &form, k, factor);
    for (size_t k = 0; k < form.count; k++)
        if (is_common(&form, k)) return common_rate(sheet, &form, k, factor);
    return NULL;
}

// Splits terms into monomials of their rates alone and the rests. Returns false if a term has no rate.
static bool split_rates(YkSheet *sheet, YkShownTerm *terms, size_t count, YkMonomial *rests)
{
    for (size_t i = 0; i < count; i++) {
        if (!yk_holds(terms[i].monomial, YK_RING_RATE)) return false;
        YkMonomial rates = yk_part_of(terms[i].monomial, YK_RING_RATE, YK_RING_RATE);
        rests[i] = yk_quotient(sheet, terms[i].monomial, rates);
        terms[i].monomial = rates;
    }
    return true;
}

YkRateProduct *yk_rate_products(YkSheet *sheet, const YkShownTerm *terms, size_t count, size_t *products)
{
    *products = 0;
    if (count == 0 || !yk_holds(terms[0].monomial, YK_RING_RATE)) return NULL;
    YkMonomial *rests = yk_arena_take(sheet->arena, count * sizeof *rests);
    YkRateProduct *list = yk_arena_take(sheet->arena, count * sizeof *list);
    YkShownTerm *rates = yk_arena_take(sheet->arena, count * sizeof *rates);
    if (!rests || !list || !rates) {
        sheet->failed = true;
        return NULL;
    }
    memcpy(rates, terms, count * sizeof *rates);
    if (!split_rates(sheet, rates, count, rests)) return NULL;
    for (size_t start = 0, end; start < count; start = end) {
        // Equal rests are adjacent: the sort puts rates after all other classes.
        for (end = start + 1; end < count && yk_is_same_monomial(rests[end], rests[start]); end++) {}
        YkRateProduct *product = &list[*products];
        product->monomial = rests[start];
        product->rates = factored(sheet, rates + start, end - start, &product->number);
        if (!product->rates) return NULL;
        ++*products;
    }
    return list;
}
