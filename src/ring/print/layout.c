// The sections of an equation: accelerations, with one bracket each; products of rates; gravity; the rest.
#include "ring/print/shown.h"

typedef struct Section {
    YkShownTerm *terms;
    size_t count;
} Section;
typedef enum SectionKind { ACCELERATIONS, RATES, GRAVITY, REST, SECTIONS } SectionKind;

static SectionKind section_of(YkMonomial monomial)
{
    if (yk_holds(monomial, YK_RING_ACCELERATION)) return ACCELERATIONS;
    if (yk_holds(monomial, YK_RING_RATE)) return RATES;
    return yk_holds(monomial, YK_RING_GRAVITY) ? GRAVITY : REST;
}

// Returns whether there is a section besides the rest.
static bool has_sections(const YkShownTerm *terms, size_t count)
{
    uint32_t classes = 0;
    for (size_t i = 0; i < count; i++) classes |= terms[i].monomial.classes;
    return classes & (1u << YK_RING_ACCELERATION | 1u << YK_RING_RATE | 1u << YK_RING_GRAVITY);
}

static void take_sections(YkSheet *sheet, const YkShownTerm *terms, size_t count, Section sections[SECTIONS])
{
    YkShownTerm *sorted = yk_arena_take(sheet->arena, count * sizeof *sorted);
    if (!sorted) sheet->failed = true;
    for (int kind = 0; kind < SECTIONS; kind++) sections[kind] = (Section){sorted, 0};
    if (!sorted) return;
    for (size_t i = 0; i < count; i++) sections[section_of(terms[i].monomial)].count++;
    for (int kind = 1; kind < SECTIONS; kind++) {
        sections[kind].terms = sections[kind - 1].terms + sections[kind - 1].count;
        sections[kind - 1].count = 0;
    }
    sections[REST].count = 0;
    for (size_t i = 0; i < count; i++) {
        Section *section = &sections[section_of(terms[i].monomial)];
        section->terms[section->count++] = terms[i];
    }
}

// Puts the common rational factor of the terms before the bracket if it is not 1.
static void append_factor(YkSheet *sheet, YkShow *product, YkShownTerm *terms, size_t count)
{
    const YkMonomial none = {NULL, 0, 0};
    YkRatio number;
    if (count < 2 || !yk_common_number(terms, count, &number) || yk_ratio_is(number, 1)) return;
    yk_divide_terms(sheet, terms, count, none, number);
    yk_show_append(product, yk_show_term(sheet, number, none, NULL));
}

// Takes the minus out of a sum in which every part has one.
static bool take_minus(YkShow *sum)
{
    bool minus = sum && sum->first;
    for (const YkShow *part = sum ? sum->first : NULL; part; part = part->next) minus = minus && part->negative;
    for (YkShow *part = sum ? sum->first : NULL; part && minus; part = part->next) part->negative = false;
    return minus;
}

static bool is_one(const YkShow *show)
{
    return show && show->kind == YK_SHOW_TERM && show->has_number && yk_ratio_is(show->term.number, 1);
}

// Shows (bracket) * lead for terms that all contain the monomial `lead`, which is divided out.
static void lead_bracket(YkSheet *sheet, YkShow *sum, YkShownTerm *terms, size_t count, YkMonomial lead,
                         bool with_factor)
{
    for (size_t i = 0; i < count; i++) terms[i].monomial = yk_quotient(sheet, terms[i].monomial, lead);
    YkShow *bracket = yk_show(sheet, YK_SHOW_SUM), *product = yk_show(sheet, YK_SHOW_PRODUCT);
    if (with_factor) append_factor(sheet, product, terms, count);
    yk_show_by_atom(sheet, bracket, terms, count);
    bool minus = take_minus(bracket);
    YkShow *inner = yk_show_simplest(bracket);
    if (!is_one(inner)) yk_show_append(product, inner);
    if (product && minus) product->negative = !product->negative;
    yk_show_append(product, yk_show_term(sheet, (YkRatio){1, 1}, lead, NULL));
    yk_show_append(sum, product);
}

// Shows one bracket for each different part of the class, rates or accelerations.
static void brackets(YkSheet *sheet, YkShow *sum, Section section, YkRingClass kind)
{
    bool is_rate = kind == YK_RING_RATE;
    if (section.count == 0) return;
    yk_sort_terms(sheet, section.terms, section.count, is_rate ? YK_BY_RATE : YK_BY_ACCELERATION);
    for (size_t start = 0, end; start < section.count && !sheet->failed; start = end) {
        YkMonomial lead = yk_part_of(section.terms[start].monomial, kind, kind);
        for (end = start + 1; end < section.count; end++)
            if (!yk_is_same_monomial(yk_part_of(section.terms[end].monomial, kind, kind), lead)) break;
        const YkShownTerm *only = &section.terms[start];
        if (end == start + 1)
            yk_show_append(sum, yk_show_term(sheet, only->number, only->monomial, &only->atom));
        else
            lead_bracket(sheet, sum, section.terms + start, end - start, lead, is_rate);
    }
}

// Shows g (...) if gravity occurs in several terms to the same power; otherwise by atoms.
static void gravity_section(YkSheet *sheet, YkShow *sum, Section section)
{
    YkShownTerm *terms = section.count > 1 ? yk_arena_take(sheet->arena, section.count * sizeof *terms) : NULL;
    YkShow *bracket = section.count > 1 ? yk_show(sheet, YK_SHOW_SUM) : NULL;
    YkMonomial lead = {NULL, 0, 0};
    bool is_common = bracket && terms;
    if (section.count > 0) lead = yk_part_of(section.terms[0].monomial, YK_RING_GRAVITY, YK_RING_GRAVITY);
    for (size_t i = 0; i < section.count && is_common; i++) {
        terms[i] = section.terms[i];
        is_common = yk_is_same_monomial(yk_part_of(terms[i].monomial, YK_RING_GRAVITY, YK_RING_GRAVITY), lead);
        terms[i].monomial = yk_quotient(sheet, terms[i].monomial, lead);
    }
    if (is_common) yk_show_by_atom(sheet, bracket, terms, section.count);
    if (!is_common || bracket->first == bracket->last) {
        yk_show_by_atom(sheet, sum, section.terms, section.count);
        return;
    }
    bool minus = take_minus(bracket);
    YkShow *product = yk_show_product(sheet, yk_show_term(sheet, (YkRatio){minus ? -1 : 1, 1}, lead, NULL));
    yk_show_append(product, bracket);
    yk_show_append(sum, product);
}

static void expanded(YkSheet *sheet, YkShow *sum, YkShownTerm *terms, size_t count)
{
    yk_sort_terms(sheet, terms, count, YK_BY_ATOM);
    for (size_t i = 0; i < count && !sheet->failed; i++)
        yk_show_append(sum, yk_show_term(sheet, terms[i].number, terms[i].monomial, &terms[i].atom));
}

YkShow *yk_show_element(YkSheet *sheet, YkShownTerm *terms, size_t count)
{
    if (count == 1) return yk_show_term(sheet, terms->number, terms->monomial, &terms->atom);
    YkShow *sum = yk_show(sheet, YK_SHOW_SUM);
    if (sheet->style == YK_RING_EXPANDED) {
        expanded(sheet, sum, terms, count);
        return sheet->failed ? NULL : sum;
    }
    if (!has_sections(terms, count)) {
        yk_show_by_atom(sheet, sum, terms, count);
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
