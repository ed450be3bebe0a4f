// Products of rates as the books print them: theta2' (2 theta1' + theta2'), (theta1' + theta2')^2.
#include "ring/shown.h"

enum { RATES_MAX = 32 };

// A quadratic form in rates: S[i][k] symmetric.
typedef struct Form {
    int32_t rates[RATES_MAX];
    size_t count;
    YkRatio S[RATES_MAX][RATES_MAX];
} Form;

static bool index_of(Form *form, int32_t rate, size_t *index)
{
    for (*index = 0; *index < form->count; ++*index)
        if (form->rates[*index] == rate) return true;
    if (form->count == RATES_MAX) return false;
    form->rates[form->count++] = rate;
    for (size_t i = 0; i < form->count; i++) form->S[i][*index] = form->S[*index][i] = (YkRatio){0, 1};
    return true;
}

// False where a term is not of second degree, or there are too many rates.
static bool read_form(const YkSheet *sheet, const YkShownTerm *terms, size_t count, Form *form)
{
    form->count = 0;
    for (size_t i = 0; i < count; i++) {
        uint32_t powers_count;
        size_t a, b;
        const YkPower *powers = yk_powers_of(&sheet->ring->monomials, terms[i].monomial, &powers_count);
        bool is_square = powers_count == 1 && powers[0].exponent == 2;
        if (!is_square && !(powers_count == 2 && powers[0].exponent == 1 && powers[1].exponent == 1)) return false;
        if (!index_of(form, powers[0].symbol, &a) || !index_of(form, powers[is_square ? 0 : 1].symbol, &b))
            return false;
        YkRatio value = terms[i].number;
        if (!is_square && !yk_ratio_multiply(value, (YkRatio){1, 2}, &value)) return false;
        form->S[a][b] = form->S[b][a] = value;
    }
    return true;
}

// Rates in ascending order, rows and columns with them.
static void sort_form(Form *form)
{
    for (size_t i = 1; i < form->count; i++)
        for (size_t k = i; k > 0 && form->rates[k] < form->rates[k - 1]; k--) {
            int32_t rate = form->rates[k];
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

// Rank one with pivot k: S[i][j] S[k][k] = S[i][k] S[k][j] for all.
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

// Does every term hold rate k?
static bool is_common(const Form *form, size_t k)
{
    for (size_t i = 0; i < form->count; i++)
        for (size_t j = 0; j < form->count; j++)
            if (i != k && j != k && form->S[i][j].over != 0) return false;
    return true;
}

// The linear form with these coefficients, as factor * (whole combination, first sign +): a symbol or a sum. NULL on
// overflow.
static YkShow *linear_form(YkSheet *sheet, const Form *form, const YkRatio *coefficients, YkRatio *factor)
{
    YkShownTerm terms[RATES_MAX];
    size_t count = 0;
    for (size_t i = 0; i < form->count; i++)
        if (coefficients[i].over != 0)
            terms[count++] = (YkShownTerm){yk_ring_monomial_of(sheet->ring, form->rates[i], 1), coefficients[i], {0}};
    if (count == 0 || !yk_common_number(terms, count, factor)) return NULL;
    if (terms[0].number.over < 0) factor->over = -factor->over;
    YkShow *sum = yk_show(sheet, YK_SHOW_SUM);
    for (size_t i = 0; i < count; i++) {
        if (!yk_ratio_divide(terms[i].number, *factor, &terms[i].number) || terms[i].monomial == YK_NO_PRODUCT)
            return NULL;
        yk_show_append(sum, yk_show_term(sheet, terms[i].number, terms[i].monomial, NULL));
    }
    if (count > 1 || !sum || !sum->first) return sum;
    return sum->first->first; // the bare symbol
}

static YkShow *square(YkSheet *sheet, const Form *form, size_t k, YkRatio *factor)
{
    YkRatio coefficients[RATES_MAX], c;
    for (size_t i = 0; i < form->count; i++)
        if (!yk_ratio_divide(form->S[k][i], form->S[k][k], &coefficients[i])) return NULL;
    YkShow *base = linear_form(sheet, form, coefficients, &c);
    if (!base || !yk_ratio_multiply(c, c, factor) || !yk_ratio_multiply(*factor, form->S[k][k], factor)) return NULL;
    base->exponent = 2;
    YkShow *product = yk_show(sheet, YK_SHOW_PRODUCT);
    yk_show_append(product, base);
    return product;
}

static YkShow *common_rate(YkSheet *sheet, const Form *form, size_t k, YkRatio *factor)
{
    YkRatio coefficients[RATES_MAX];
    for (size_t i = 0; i < form->count; i++)
        if (!yk_ratio_multiply(form->S[k][i], (YkRatio){i == k ? 1 : 2, 1}, &coefficients[i])) return NULL;
    YkShow *product = yk_show(sheet, YK_SHOW_PRODUCT), *rate = yk_show(sheet, YK_SHOW_SYMBOL);
    if (rate) rate->symbol = form->rates[k];
    yk_show_append(product, rate);
    YkShow *linear = linear_form(sheet, form, coefficients, factor);
    yk_show_append(product, linear);
    return linear ? product : NULL;
}

static YkShow *factored(YkSheet *sheet, const YkShownTerm *terms, size_t count, YkRatio *factor)
{
    Form form;
    if (!read_form(sheet, terms, count, &form)) return NULL;
    sort_form(&form);
    for (size_t k = 0; k < form.count; k++)
        if (is_square_at(&form, k)) return square(sheet, &form, k, factor);
    for (size_t k = 0; k < form.count; k++)
        if (is_common(&form, k)) return common_rate(sheet, &form, k, factor);
    return NULL;
}

// Terms with their rates apart: sorted by the rest, and the rates alone left as monomials. NULL where one has none.
static YkShownTerm *split_rates(YkSheet *sheet, const YkShownTerm *terms, size_t count, uint32_t *rests)
{
    YkShownTerm *rates = YK_NEW(sheet->arena, YkShownTerm, count);
    if (!rates) sheet->failed = true;
    for (size_t i = 0; i < count && !sheet->failed; i++) {
        rates[i] = terms[i];
        rates[i].monomial = yk_part_of_classes(sheet, terms[i].monomial, 1u << YK_RING_RATE);
        if (rates[i].monomial == 0) return NULL;
        if (!sheet->failed) rests[i] = yk_quotient(sheet, terms[i].monomial, rates[i].monomial);
    }
    return sheet->failed ? NULL : rates;
}

YkRateProduct *yk_rate_products(YkSheet *sheet, const YkShownTerm *terms, size_t count, size_t *products)
{
    *products = 0;
    uint32_t *rests = YK_NEW(sheet->arena, uint32_t, count + 1);
    YkRateProduct *list = YK_NEW(sheet->arena, YkRateProduct, count + 1);
    if (!rests || !list) sheet->failed = true;
    YkShownTerm *rates = sheet->failed || count == 0 ? NULL : split_rates(sheet, terms, count, rests);
    if (!rates) return NULL;
    for (size_t start = 0, end; start < count; start = end) {
        // Equal rests stand together: the sort puts rates after all other classes.
        for (end = start + 1; end < count && rests[end] == rests[start]; end++) {}
        YkRateProduct *product = &list[*products];
        product->monomial = rests[start];
        product->rates = factored(sheet, rates + start, end - start, &product->number);
        if (!product->rates) return NULL;
        ++*products;
    }
    return list;
}
