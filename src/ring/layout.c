// The sections of an equation: accelerations, one bracket each; products of rates; gravity; the rest.
#include "ring/shown.h"

typedef struct Section {
    YkShownTerm *terms;
    size_t count;
} Section;
typedef enum SectionKind { ACCELERATIONS, RATES, GRAVITY, REST, SECTIONS } SectionKind;

static SectionKind section_of(const YkSheet *sheet, uint32_t monomial)
{
    static const YkRingClass classes[] = {YK_RING_ACCELERATION, YK_RING_RATE, YK_RING_GRAVITY};
    for (int kind = ACCELERATIONS; kind < REST; kind++)
        if (yk_ring_classes(sheet->ring, monomial) & 1u << classes[kind]) return (SectionKind)kind;
    return REST;
}

static void take_sections(YkSheet *sheet, const YkShownTerm *terms, size_t count, Section sections[SECTIONS])
{
    YkShownTerm *sorted = YK_NEW(sheet->arena, YkShownTerm, count + 1);
    if (!sorted) sheet->failed = true;
    for (int kind = 0; kind < SECTIONS && sorted; kind++) {
        sections[kind] = (Section){sorted, 0};
        for (size_t i = 0; i < count; i++)
            if (section_of(sheet, terms[i].monomial) == (SectionKind)kind) sorted[sections[kind].count++] = terms[i];
        sorted += sections[kind].count;
    }
}

// The common rational factor of the terms goes before the bracket where it is not 1.
static YkShow *bracket_factor(YkSheet *sheet, YkShownTerm *terms, size_t count)
{
    YkRatio number;
    if (count < 2 || !yk_common_number(terms, count, &number) || yk_ratio_is(number, 1))
        return yk_show(sheet, YK_SHOW_PRODUCT);
    for (size_t i = 0; i < count; i++)
        if (!yk_ratio_divide(terms[i].number, number, &terms[i].number)) sheet->failed = true;
    return yk_show_term(sheet, number, 0, NULL);
}

// Takes the minus out of a sum whose parts all have it.
static bool take_minus(YkShow *sum)
{
    bool minus = sum && sum->first;
    for (const YkShow *part = sum ? sum->first : NULL; part; part = part->next) minus = minus && part->negative;
    for (YkShow *part = sum ? sum->first : NULL; part && minus; part = part->next) part->negative = false;
    return minus;
}

// (bracket) * lead for terms that all hold the monomial `lead`, which is divided out.
static void lead_bracket(YkSheet *sheet, YkShow *sum, YkShownTerm *terms, size_t count, uint32_t lead, bool with_factor)
{
    for (size_t i = 0; i < count && !sheet->failed; i++)
        terms[i].monomial = yk_quotient(sheet, terms[i].monomial, lead);
    if (sheet->failed) return;
    YkShow *bracket = yk_show(sheet, YK_SHOW_SUM);
    YkShow *product = with_factor ? bracket_factor(sheet, terms, count) : yk_show(sheet, YK_SHOW_PRODUCT);
    yk_show_by_atom(sheet, bracket, terms, count);
    bool minus = take_minus(bracket);
    YkShow *inner = yk_show_simplest(bracket);
    bool is_one = inner && inner->kind == YK_SHOW_PRODUCT && inner->first && inner->first == inner->last &&
                  inner->first->kind == YK_SHOW_NUMBER && yk_ratio_is(inner->first->number, 1);
    if (!is_one) yk_show_append(product, inner);
    if (product && minus) product->negative = !product->negative;
    yk_show_append(product, yk_show_term(sheet, (YkRatio){1, 1}, lead, NULL));
    yk_show_append(sum, product);
}

// Sorts terms by their part of the class, in the order of monomials.
static void sort_by_part(YkSheet *sheet, YkShownTerm *terms, size_t count, YkRingClass kind)
{
    YkShownTerm *parts = YK_NEW(sheet->arena, YkShownTerm, count + 1);
    YkShownTerm *sorted = YK_NEW(sheet->arena, YkShownTerm, count + 1);
    if (!parts || !sorted) sheet->failed = true;
    for (size_t i = 0; i < count && !sheet->failed; i++) // the index travels as the number
        parts[i] = (YkShownTerm){yk_part_of_classes(sheet, terms[i].monomial, 1u << kind), {(int64_t)i, 1}, {0}};
    if (sheet->failed) return;
    yk_sort_by_monomial(sheet, parts, count);
    for (size_t i = 0; i < count; i++) sorted[i] = terms[parts[i].number.over];
    for (size_t i = 0; i < count; i++) terms[i] = sorted[i];
}

// One bracket for each different part of the class.
static void brackets(YkSheet *sheet, YkShow *sum, Section section, YkRingClass kind)
{
    if (section.count > 1) sort_by_part(sheet, section.terms, section.count, kind);
    for (size_t start = 0, end; start < section.count && !sheet->failed; start = end) {
        uint32_t lead = yk_part_of_classes(sheet, section.terms[start].monomial, 1u << kind);
        for (end = start + 1; end < section.count; end++)
            if (yk_part_of_classes(sheet, section.terms[end].monomial, 1u << kind) != lead) break;
        if (!sheet->failed) lead_bracket(sheet, sum, section.terms + start, end - start, lead, kind == YK_RING_RATE);
    }
}

// g (...) where gravity stands in several places to the same power; else by atoms.
static void gravity_section(YkSheet *sheet, YkShow *sum, Section section)
{
    if (section.count == 0) return;
    uint32_t lead = 0;
    bool is_common = section.count > 1;
    for (size_t i = 0; i < section.count && !sheet->failed; i++) {
        uint32_t part = yk_part_of_classes(sheet, section.terms[i].monomial, 1u << YK_RING_GRAVITY);
        if (i == 0) lead = part;
        is_common = is_common && part == lead;
    }
    YkShownTerm *terms = YK_NEW(sheet->arena, YkShownTerm, section.count + 1);
    if (!terms) sheet->failed = true;
    for (size_t i = 0; i < section.count && !sheet->failed; i++) {
        terms[i] = section.terms[i];
        if (is_common) terms[i].monomial = yk_quotient(sheet, terms[i].monomial, lead);
    }
    YkShow *bracket = yk_show(sheet, YK_SHOW_SUM);
    if (is_common && !sheet->failed) yk_show_by_atom(sheet, bracket, terms, section.count);
    if (!is_common || yk_show_count(bracket) < 2) {
        if (!sheet->failed) yk_show_by_atom(sheet, sum, section.terms, section.count);
        return;
    }
    bool minus = take_minus(bracket);
    YkShow *product = yk_show_term(sheet, (YkRatio){minus ? -1 : 1, 1}, lead, NULL);
    yk_show_append(product, bracket);
    yk_show_append(sum, product);
}

static void expanded(YkSheet *sheet, YkShow *sum, YkShownTerm *terms, size_t count)
{
    yk_sort_by_atom(sheet, terms, count);
    for (size_t i = 0; i < count && !sheet->failed; i++)
        yk_show_append(sum, yk_show_term(sheet, terms[i].number, terms[i].monomial, &terms[i].atom));
}

YkShow *yk_show_element(YkSheet *sheet, YkShownTerm *terms, size_t count)
{
    YkShow *sum = yk_show(sheet, YK_SHOW_SUM);
    if (sheet->style == YK_RING_EXPANDED) {
        expanded(sheet, sum, terms, count);
        return sheet->failed ? NULL : sum;
    }
    if (count == 1) { // nothing to group
        yk_show_append(sum, yk_show_term(sheet, terms[0].number, terms[0].monomial, &terms[0].atom));
        return sheet->failed ? NULL : sum;
    }
    Section sections[SECTIONS];
    take_sections(sheet, terms, count, sections);
    if (sheet->failed) return NULL;
    brackets(sheet, sum, sections[ACCELERATIONS], YK_RING_ACCELERATION);
    if (sheet->style == YK_RING_BRACKETS)
        brackets(sheet, sum, sections[RATES], YK_RING_RATE);
    else
        yk_show_by_atom(sheet, sum, sections[RATES].terms, sections[RATES].count);
    gravity_section(sheet, sum, sections[GRAVITY]);
    yk_show_by_atom(sheet, sum, sections[REST].terms, sections[REST].count);
    return sheet->failed ? NULL : sum;
}
