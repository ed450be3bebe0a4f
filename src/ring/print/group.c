// Groups terms for the reader: polynomials by inertia and mass, sums by cos and sin.
#include "ring/print/shown.h"

static bool all_negative(const YkShownTerm *terms, size_t count)
{
    for (size_t i = 0; i < count; i++)
        if (terms[i].number.over > 0) return false;
    return true;
}

// Finds the common rational divisor with the sign that leaves the bracket readable: minus if every term has it.
static bool bracket_number(YkSheet *sheet, const YkShownTerm *terms, size_t count, YkRatio *number)
{
    if (!yk_common_number(terms, count, number)) return !(sheet->failed = true);
    if (all_negative(terms, count)) number->over = -number->over;
    return true;
}

static void append_terms(YkSheet *sheet, YkShow *sum, const YkShownTerm *terms, size_t count)
{
    for (size_t i = 0; i < count; i++)
        yk_show_append(sum, yk_show_term(sheet, terms[i].number, terms[i].monomial, NULL));
}

// Returns whether the number is 1 or -1, which is not written as a factor.
static bool is_sign(YkRatio number)
{
    return number.under == 1 && (number.over == 1 || number.over == -1);
}

// Shows the terms of one mass or inertia: the common factor times a bracket, or term by term if nothing is common.
static void polynomial_group(YkSheet *sheet, YkShow *sum, YkShownTerm *terms, size_t count)
{
    YkRatio number;
    if (count == 1) {
        append_terms(sheet, sum, terms, count);
        return;
    }
    YkMonomial common = yk_common_monomial(sheet, terms, count);
    if (!bracket_number(sheet, terms, count, &number)) return;
    if (common.count == 0 && is_sign(number)) {
        append_terms(sheet, sum, terms, count);
        return;
    }
    YkShow *product = yk_show_product(sheet, yk_show_term(sheet, number, common, NULL));
    YkShow *bracket = yk_show(sheet, YK_SHOW_SUM);
    yk_divide_terms(sheet, terms, count, common, number);
    append_terms(sheet, bracket, terms, count);
    yk_show_append(product, bracket);
    yk_show_append(sum, product);
}

// Does the same with products of rates: list[count] of one mass or inertia.
static void rate_group(YkSheet *sheet, YkShow *sum, YkRateProduct *list, size_t count)
{
    YkShownTerm *terms = YK_NEW(sheet->arena, YkShownTerm, count);
    YkRatio number = {1, 1};
    YkMonomial common = {NULL, 0, 0};
    if (!terms) sheet->failed = true;
    for (size_t i = 0; i < count && terms; i++) terms[i] = (YkShownTerm){list[i].monomial, list[i].number, {0}};
    if (!terms || (count > 1 && !bracket_number(sheet, terms, count, &number))) return;
    if (count > 1) common = yk_common_monomial(sheet, terms, count);
    YkShow *bracket = yk_show(sheet, YK_SHOW_SUM);
    yk_divide_terms(sheet, terms, count, common, number);
    for (size_t i = 0; i < count; i++) {
        bool bare = terms[i].monomial.count == 0 && is_sign(terms[i].number);
        YkShow *part = yk_show(sheet, YK_SHOW_PRODUCT);
        if (!bare) yk_show_append(part, yk_show_term(sheet, terms[i].number, terms[i].monomial, NULL));
        if (part) part->negative = terms[i].number.over < 0;
        yk_show_append(part, list[i].rates);
        yk_show_append(bracket, part);
    }
    YkShow *whole = bracket;
    if (common.count > 0 || !is_sign(number)) {
        whole = yk_show_product(sheet, yk_show_term(sheet, number, common, NULL));
        yk_show_append(whole, bracket);
    } else if (whole) {
        whole->negative = number.over < 0;
    }
    yk_show_append(sum, whole);
}

static YkMonomial mass_of(YkMonomial monomial)
{
    return yk_part_of(monomial, YK_RING_INERTIA, YK_RING_MASS);
}

static bool has_mass(YkMonomial monomial)
{
    return yk_holds(monomial, YK_RING_MASS) || yk_holds(monomial, YK_RING_INERTIA);
}

// Shows (m1 + m2) a for terms that are one length, or one product of lengths, times masses alone. Returns false for
// others.
static bool masses_times_common(YkSheet *sheet, YkShow *sum, YkShownTerm *terms, size_t count)
{
    YkRatio number;
    if (count < 2) return false;
    for (size_t i = 0; i < count; i++)
        if (!has_mass(terms[i].monomial)) return false;
    YkMonomial common = yk_common_monomial(sheet, terms, count);
    if (common.count == 0 || has_mass(common)) return false;
    for (size_t i = 0; i < count; i++) {
        YkMonomial rest = yk_quotient(sheet, terms[i].monomial, common);
        if (!has_mass(rest) || mass_of(rest).count < rest.count) return false;
    }
    if (!bracket_number(sheet, terms, count, &number)) return true;
    yk_divide_terms(sheet, terms, count, common, number);
    YkShow *product = yk_show(sheet, YK_SHOW_PRODUCT), *bracket = yk_show(sheet, YK_SHOW_SUM);
    if (!is_sign(number)) yk_show_append(product, yk_show_term(sheet, number, (YkMonomial){NULL, 0, 0}, NULL));
    append_terms(sheet, bracket, terms, count);
    yk_show_append(product, bracket);
    yk_show_append(product, yk_show_term(sheet, (YkRatio){1, 1}, common, NULL));
    if (product) product->negative = number.over < 0;
    yk_show_append(sum, product);
    return true;
}

// Adds a polynomial (the atom, common to all its terms, is left out) to a sum, grouped by inertias and masses.
static void show_polynomial(YkSheet *sheet, YkShow *sum, YkShownTerm *terms, size_t count)
{
    size_t products, end;
    if (count == 1) { // nothing to group
        append_terms(sheet, sum, terms, count);
        return;
    }
    yk_sort_terms(sheet, terms, count, YK_BY_MONOMIAL);
    YkRateProduct *list = yk_rate_products(sheet, terms, count, &products);
    if (!list && masses_times_common(sheet, sum, terms, count)) return;
    for (size_t start = 0; list && start < products; start = end) {
        YkMonomial mass = mass_of(list[start].monomial);
        for (end = start + 1; end < products && yk_is_same_monomial(mass, mass_of(list[end].monomial)); end++) {}
        rate_group(sheet, sum, list + start, end - start);
    }
    for (size_t start = 0; !list && start < count; start = end) {
        YkMonomial mass = mass_of(terms[start].monomial);
        for (end = start + 1; end < count && yk_is_same_monomial(mass, mass_of(terms[end].monomial)); end++) {}
        polynomial_group(sheet, sum, terms + start, end - start);
    }
}

static bool has_rate(const YkShownTerm *terms, size_t count)
{
    for (size_t i = 0; i < count; i++)
        if (yk_holds(terms[i].monomial, YK_RING_RATE)) return true;
    return false;
}

// Shows number, unit and constants of a bracket's factor, then - with gravity, function and rates kept apart - the
// bracket, in the order that reads best: 1/2 l1 (m1 + 2 m2) g cos(theta1), m2 l1 g cos(theta2) (theta1' + ...).
static void bracket_times_atom(YkSheet *sheet, YkShow *sum, YkShownTerm *terms, size_t count)
{
    const YkRatio one = {1, 1};
    YkAtom atom = terms[0].atom, unit = {.is_imaginary = atom.is_imaginary, .surd = atom.surd};
    YkRatio number;
    YkMonomial common = yk_common_monomial(sheet, terms, count);
    if (!yk_common_number(terms, count, &number)) {
        sheet->failed = true;
        return;
    }
    if (terms[0].number.over < 0) number.over = -number.over;
    yk_divide_terms(sheet, terms, count, common, number);
    YkMonomial gravity = yk_part_of(common, YK_RING_GRAVITY, YK_RING_GRAVITY);
    YkMonomial rates = yk_part_of(common, YK_RING_RATE, YK_RING_RATE);
    YkMonomial early = yk_quotient(sheet, yk_quotient(sheet, common, rates), gravity);
    YkShow *product = yk_show(sheet, YK_SHOW_PRODUCT), *bracket = yk_show(sheet, YK_SHOW_SUM);
    if (!is_sign(number) || early.count > 0 || unit.is_imaginary || unit.surd != 0)
        yk_show_append(product, yk_show_term(sheet, number, early, &unit));
    if (product) product->negative = number.over < 0;
    bool moving = has_rate(terms, count);
    if (moving)
        append_terms(sheet, bracket, terms, count);
    else
        show_polynomial(sheet, bracket, terms, count);
    atom.is_imaginary = false;
    atom.surd = 0;
    YkShow *tail = yk_show_term(sheet, one, gravity, &atom);
    yk_show_append(product, moving ? tail : bracket);
    yk_show_append(product, moving ? bracket : tail);
    if (rates.count > 0) yk_show_append(product, yk_show_term(sheet, one, rates, NULL));
    yk_show_append(sum, product);
}

static void atom_group(YkSheet *sheet, YkShow *sum, YkShownTerm *terms, size_t count)
{
    size_t products = 0;
    const YkRateProduct *list = count > 1 ? yk_rate_products(sheet, terms, count, &products) : NULL;
    if (list && products == 1) {
        YkShow *term = yk_show_term(sheet, list->number, list->monomial, &terms[0].atom);
        YkShow *product = yk_show_product(sheet, term);
        yk_show_append(product, list->rates);
        yk_show_append(sum, product);
    } else if (count == 1) {
        yk_show_append(sum, yk_show_term(sheet, terms->number, terms->monomial, &terms->atom));
    } else {
        bracket_times_atom(sheet, sum, terms, count);
    }
}

void yk_show_by_atom(YkSheet *sheet, YkShow *sum, YkShownTerm *terms, size_t count)
{
    yk_sort_terms(sheet, terms, count, YK_BY_ATOM);
    for (size_t start = 0, end; start < count && !sheet->failed; start = end) {
        const YkAtom atom = terms[start].atom;
        for (end = start + 1; end < count && yk_compare_atoms(sheet->ring, &atom, &terms[end].atom) == 0; end++) {}
        bool is_plain = atom.function == YK_SHOWN_ONE && !atom.is_imaginary && atom.surd == 0;
        if (is_plain)
            show_polynomial(sheet, sum, terms + start, end - start);
        else
            atom_group(sheet, sum, terms + start, end - start);
    }
}
