// Grouping for the reader: polynomials by inertia and mass, sums by cos and sin.
#include "ring/shown.h"

static bool all_negative(const YkShownTerm *terms, size_t count)
{
    for (size_t i = 0; i < count; i++)
        if (terms[i].number.over > 0) return false;
    return true;
}

// The common rational divisor with the sign that leaves the bracket readable: minus where every term has it.
static bool bracket_number(YkSheet *sheet, const YkShownTerm *terms, size_t count, YkRatio *number)
{
    if (!yk_common_number(terms, count, number)) return !(sheet->failed = true);
    if (all_negative(terms, count)) number->over = -number->over;
    return true;
}

// Divides terms by a monomial and a number, in place.
static void divide_terms(YkSheet *sheet, YkShownTerm *terms, size_t count, uint32_t monomial, YkRatio number)
{
    for (size_t i = 0; i < count && !sheet->failed; i++) {
        terms[i].monomial = yk_quotient(sheet, terms[i].monomial, monomial);
        if (!yk_ratio_divide(terms[i].number, number, &terms[i].number)) sheet->failed = true;
    }
}

static void append_terms(YkSheet *sheet, YkShow *sum, const YkShownTerm *terms, size_t count)
{
    for (size_t i = 0; i < count && !sheet->failed; i++)
        yk_show_append(sum, yk_show_term(sheet, terms[i].number, terms[i].monomial, NULL));
}

// One mass or inertia: common factor times bracket, or the terms one by one where nothing is common.
static void polynomial_group(YkSheet *sheet, YkShow *sum, YkShownTerm *terms, size_t count)
{
    YkRatio number;
    uint32_t common = count > 1 ? yk_common_monomial(sheet, terms, count) : 0;
    if (sheet->failed || !bracket_number(sheet, terms, count, &number)) return;
    if (count == 1 || (common == 0 && (yk_ratio_is(number, 1) || yk_ratio_is(number, -1)))) {
        append_terms(sheet, sum, terms, count);
        return;
    }
    YkShow *product = yk_show_term(sheet, number, common, NULL), *bracket = yk_show(sheet, YK_SHOW_SUM);
    divide_terms(sheet, terms, count, common, number);
    append_terms(sheet, bracket, terms, count);
    yk_show_append(product, bracket);
    yk_show_append(sum, product);
}

// The same with products of rates: list[count] of one mass or inertia.
static void rate_group(YkSheet *sheet, YkShow *sum, YkRateProduct *list, size_t count)
{
    YkShownTerm *terms = YK_NEW(sheet->arena, YkShownTerm, count);
    if (!terms) sheet->failed = true;
    for (size_t i = 0; i < count && terms; i++) terms[i] = (YkShownTerm){list[i].monomial, list[i].number, {0}};
    YkRatio number = {1, 1};
    uint32_t common = !sheet->failed && count > 1 ? yk_common_monomial(sheet, terms, count) : 0;
    if (sheet->failed || (count > 1 && !bracket_number(sheet, terms, count, &number))) return;
    YkShow *bracket = yk_show(sheet, YK_SHOW_SUM);
    divide_terms(sheet, terms, count, common, number);
    for (size_t i = 0; i < count && !sheet->failed; i++) {
        bool bare = terms[i].monomial == 0 && (yk_ratio_is(terms[i].number, 1) || yk_ratio_is(terms[i].number, -1));
        YkShow *part =
            bare ? yk_show(sheet, YK_SHOW_PRODUCT) : yk_show_term(sheet, terms[i].number, terms[i].monomial, NULL);
        if (part) part->negative = terms[i].number.over < 0;
        yk_show_append(part, list[i].rates);
        yk_show_append(bracket, part);
    }
    bool factored = common != 0 || !(yk_ratio_is(number, 1) || yk_ratio_is(number, -1));
    YkShow *whole = factored ? yk_show_term(sheet, number, common, NULL) : bracket;
    if (factored)
        yk_show_append(whole, bracket);
    else if (whole)
        whole->negative = number.over < 0;
    yk_show_append(sum, whole);
}

// Do two monomials have the same inertias and masses?
static bool same_mass(YkSheet *sheet, uint32_t a, uint32_t b)
{
    uint32_t left = yk_part_of_classes(sheet, a, YK_CLASSES_OF_MASS);
    return left == yk_part_of_classes(sheet, b, YK_CLASSES_OF_MASS) && !sheet->failed;
}

// (m1 + m2) a for terms that are one length, or one product of such, times masses alone. False where they are not so.
static bool masses_times_common(YkSheet *sheet, YkShow *sum, YkShownTerm *terms, size_t count)
{
    YkRatio number;
    uint32_t common = count > 1 ? yk_common_monomial(sheet, terms, count) : 0;
    if (common == 0 || sheet->failed || yk_part_of_classes(sheet, common, YK_CLASSES_OF_MASS) != 0) return false;
    for (size_t i = 0; i < count && !sheet->failed; i++) {
        uint32_t rest = yk_quotient(sheet, terms[i].monomial, common);
        if (sheet->failed || rest == 0 || yk_part_of_classes(sheet, rest, YK_CLASSES_OF_MASS) != rest) return false;
    }
    if (!bracket_number(sheet, terms, count, &number)) return true;
    divide_terms(sheet, terms, count, common, number);
    bool bare = yk_ratio_is(number, 1) || yk_ratio_is(number, -1);
    YkShow *product = bare ? yk_show(sheet, YK_SHOW_PRODUCT) : yk_show_term(sheet, number, 0, NULL);
    YkShow *bracket = yk_show(sheet, YK_SHOW_SUM);
    append_terms(sheet, bracket, terms, count);
    yk_show_append(product, bracket);
    if (!sheet->failed) yk_show_append(product, yk_show_term(sheet, (YkRatio){1, 1}, common, NULL));
    if (product) product->negative = number.over < 0;
    yk_show_append(sum, product);
    return true;
}

void yk_show_polynomial(YkSheet *sheet, YkShow *sum, YkShownTerm *terms, size_t count)
{
    size_t products, end;
    yk_sort_by_monomial(sheet, terms, count);
    YkRateProduct *list = yk_rate_products(sheet, terms, count, &products);
    if (!list && !sheet->failed && masses_times_common(sheet, sum, terms, count)) return;
    for (size_t start = 0; list && start < products && !sheet->failed; start = end) {
        for (end = start + 1; end < products && same_mass(sheet, list[start].monomial, list[end].monomial); end++) {}
        rate_group(sheet, sum, list + start, end - start);
    }
    for (size_t start = 0; !list && start < count && !sheet->failed; start = end) {
        for (end = start + 1; end < count && same_mass(sheet, terms[start].monomial, terms[end].monomial); end++) {}
        polynomial_group(sheet, sum, terms + start, end - start);
    }
}

static bool has_class(YkSheet *sheet, const YkShownTerm *terms, size_t count, YkRingClass kind)
{
    for (size_t i = 0; i < count && !sheet->failed; i++)
        if (yk_ring_classes(sheet->ring, terms[i].monomial) & 1u << kind) return true;
    return false;
}

// Number, unit and constants of a bracket's factor, then - gravity, function and rates aside - the bracket:
// 1/2 l1 (m1 + 2 m2) g cos(theta1), m2 l1 g cos(theta2) (theta1' + ...), in the order that reads best.
static void bracket_times_atom(YkSheet *sheet, YkShow *sum, YkShownTerm *terms, size_t count)
{
    YkAtom atom = terms[0].atom, unit = {.is_imaginary = atom.is_imaginary, .surd = atom.surd};
    YkRatio number;
    uint32_t common = yk_common_monomial(sheet, terms, count);
    if (sheet->failed || !yk_common_number(terms, count, &number)) {
        sheet->failed = true;
        return;
    }
    if (terms[0].number.over < 0) number.over = -number.over;
    uint32_t late = yk_part_of_classes(sheet, common, 1u << YK_RING_GRAVITY | 1u << YK_RING_RATE);
    uint32_t rates = yk_part_of_classes(sheet, common, 1u << YK_RING_RATE);
    divide_terms(sheet, terms, count, common, number);
    if (sheet->failed) return;
    bool moving = has_class(sheet, terms, count, YK_RING_RATE);
    uint32_t early = yk_quotient(sheet, common, late), gravity = yk_quotient(sheet, late, rates);
    if (sheet->failed) return;
    YkShow *product = yk_show_term(sheet, number, early, &unit), *bracket = yk_show(sheet, YK_SHOW_SUM);
    if (product && yk_ratio_is(number, number.over < 0 ? -1 : 1) && early == 0 && !unit.is_imaginary && unit.surd == 0)
        product->first = product->last = NULL; // no lone 1
    if (moving)
        append_terms(sheet, bracket, terms, count);
    else
        yk_show_polynomial(sheet, bracket, terms, count);
    atom.is_imaginary = false;
    atom.surd = 0;
    YkShow *tail = yk_show_term(sheet, (YkRatio){1, 1}, gravity, &atom);
    YkShow *motion = rates != 0 ? yk_show_term(sheet, (YkRatio){1, 1}, rates, NULL) : NULL;
    yk_show_append(product, moving ? tail : bracket);
    yk_show_append(product, moving ? bracket : tail);
    yk_show_append(product, motion);
    yk_show_append(sum, product);
}

static void atom_group(YkSheet *sheet, YkShow *sum, YkShownTerm *terms, size_t count)
{
    size_t products = 0;
    const YkRateProduct *list = count > 1 ? yk_rate_products(sheet, terms, count, &products) : NULL;
    if (sheet->failed) return;
    if (list && products == 1) {
        YkShow *product = yk_show_term(sheet, list->number, list->monomial, &terms[0].atom);
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
    yk_sort_by_atom(sheet, terms, count);
    for (size_t start = 0, end; start < count && !sheet->failed; start = end) {
        const YkAtom atom = terms[start].atom;
        for (end = start + 1; end < count && yk_compare_atoms(sheet->ring, &atom, &terms[end].atom) == 0; end++) {}
        bool is_plain = atom.function == YK_SHOWN_ONE && !atom.is_imaginary && atom.surd == 0;
        if (is_plain)
            yk_show_polynomial(sheet, sum, terms + start, end - start);
        else
            atom_group(sheet, sum, terms + start, end - start);
    }
}
