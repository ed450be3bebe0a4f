// Writes the tree as presentation MathML (W3C, MathML Core).
#include "ring/print/shown.h"

static const char *const TIMES = "<mo>&#x2062;</mo>";                            // invisible times
static const char *const SPACED_TIMES = "<mo rspace=\"0.1667em\">&#x2062;</mo>"; // before cos and sin

static void put_sum(const YkSheet *sheet, const YkShow *sum, YkText *text);

static void put_whole(YkText *text, int64_t value)
{
    char digits[24];
    size_t at = sizeof digits;
    for (int64_t rest = value; rest > 0 || at == sizeof digits; rest /= 10) digits[--at] = (char)('0' + rest % 10);
    yk_text_puts(text, "<mn>");
    yk_text_add(text, digits + at, sizeof digits - at);
    yk_text_puts(text, "</mn>");
}

static void put_ratio(YkText *text, YkRatio ratio)
{
    if (ratio.under != 1) yk_text_puts(text, "<mfrac>");
    put_whole(text, ratio.over);
    if (ratio.under == 1) return;
    put_whole(text, ratio.under);
    yk_text_puts(text, "</mfrac>");
}

static void put_pi(YkText *text, const YkAngleShown *shown)
{
    if (shown->pi_over != 1) yk_text_puts(text, "<mfrac>");
    yk_text_puts(text, "<mrow>");
    if (shown->factor != 1) put_whole(text, shown->factor);
    yk_text_puts(text, "<mi>π</mi></mrow>");
    if (shown->pi_over == 1) return;
    put_whole(text, shown->pi_over);
    yk_text_puts(text, "</mfrac>");
}

static void put_angle(const YkSheet *sheet, const YkAtom *atom, YkText *text)
{
    YkAngleShown shown;
    yk_text_puts(text, "<mrow>");
    for (uint32_t k = 0; yk_angle_shown(sheet, atom, k, &shown); k++) {
        if (shown.negative || k > 0) yk_text_puts(text, shown.negative ? "<mo>−</mo>" : "<mo>+</mo>");
        if (shown.symbol < 0) {
            put_pi(text, &shown);
            continue;
        }
        if (shown.factor != 1) {
            put_whole(text, shown.factor);
            yk_text_puts(text, TIMES);
        }
        yk_text_puts(text, yk_ring_name_in(sheet->ring, shown.symbol, YK_RING_MATHML));
    }
    yk_text_puts(text, "</mrow>");
}

static void put_function(const YkSheet *sheet, const YkAtom *atom, YkText *text)
{
    if (atom->function == YK_SHOWN_EXP) {
        yk_text_puts(text, "<msup><mi>e</mi><mrow><mi mathvariant=\"normal\">i</mi><mo>(</mo>");
        put_angle(sheet, atom, text);
        yk_text_puts(text, "<mo>)</mo></mrow></msup>");
        return;
    }
    yk_text_puts(text, atom->function == YK_SHOWN_COS ? "<mi>cos</mi>" : "<mi>sin</mi>");
    yk_text_puts(text, "<mo>&#x2061;</mo><mrow><mo>(</mo>");
    put_angle(sheet, atom, text);
    yk_text_puts(text, "<mo>)</mo></mrow>");
}

// Writes what separates two factors.
static void separate(YkText *text, const char *times, bool *any)
{
    if (*any) yk_text_puts(text, times);
    *any = true;
}

// Writes powers with positive exponents (sign 1) or with negative ones (sign -1).
static void put_powers(const YkSheet *sheet, YkMonomial monomial, int32_t sign, bool *any, YkText *text)
{
    for (uint32_t i = 0; i < monomial.count; i++) {
        int32_t exponent = sign * monomial.powers[i].exponent;
        if (exponent < 0) continue;
        separate(text, TIMES, any);
        if (exponent > 1) yk_text_puts(text, "<msup>");
        yk_text_puts(text, yk_ring_name_in(sheet->ring, yk_rank_symbol(monomial.powers[i].rank), YK_RING_MATHML));
        if (exponent == 1) continue;
        put_whole(text, exponent);
        yk_text_puts(text, "</msup>");
    }
}

// Writes the part of a term above the line.
static void put_term(const YkSheet *sheet, const YkShow *show, bool *any, YkText *text)
{
    const YkAtom *atom = &show->term.atom;
    if (show->has_number) {
        separate(text, TIMES, any);
        put_ratio(text, show->term.number);
    }
    if (atom->is_imaginary) {
        separate(text, TIMES, any);
        yk_text_puts(text, "<mi mathvariant=\"normal\">i</mi>");
    }
    if (atom->surd != 0) {
        separate(text, TIMES, any);
        yk_text_puts(text, "<msqrt>");
        put_whole(text, yk_surd_square(atom->surd));
        yk_text_puts(text, "</msqrt>");
    }
    put_powers(sheet, yk_part_of(show->term.monomial, YK_RING_INERTIA, YK_RING_FORCE), 1, any, text);
    if (atom->function != YK_SHOWN_ONE) {
        separate(text, SPACED_TIMES, any);
        put_function(sheet, atom, text);
    }
    put_powers(sheet, yk_part_of(show->term.monomial, YK_RING_RATE, YK_RING_ACCELERATION), 1, any, text);
}

static void put_bracket(const YkSheet *sheet, const YkShow *sum, bool *any, YkText *text)
{
    separate(text, TIMES, any);
    if (sum->exponent != 1) yk_text_puts(text, "<msup>");
    yk_text_puts(text, "<mrow><mo>(</mo>");
    put_sum(sheet, sum, text);
    yk_text_puts(text, "<mo>)</mo></mrow>");
    if (sum->exponent == 1) return;
    put_whole(text, sum->exponent);
    yk_text_puts(text, "</msup>");
}

static void put_above(const YkSheet *sheet, const YkShow *product, YkText *text)
{
    bool any = false;
    yk_text_puts(text, "<mrow>");
    for (const YkShow *factor = yk_show_first(product); factor; factor = yk_show_next(product, factor))
        if (factor->kind == YK_SHOW_TERM)
            put_term(sheet, factor, &any, text);
        else
            put_bracket(sheet, factor, &any, text);
    if (!any) put_whole(text, 1);
    yk_text_puts(text, "</mrow>");
}

static void put_below(const YkSheet *sheet, const YkShow *product, YkText *text)
{
    bool any = false;
    yk_text_puts(text, "<mrow>");
    for (const YkShow *factor = yk_show_first(product); factor; factor = yk_show_next(product, factor))
        put_powers(sheet, factor->term.monomial, -1, &any, text);
    yk_text_puts(text, "</mrow>");
}

static void put_product(const YkSheet *sheet, const YkShow *product, YkText *text)
{
    bool high, fraction = yk_show_below(product, &high) > 0;
    if (fraction) yk_text_puts(text, "<mfrac>");
    put_above(sheet, product, text);
    if (!fraction) return;
    put_below(sheet, product, text);
    yk_text_puts(text, "</mfrac>");
}

static void put_sum(const YkSheet *sheet, const YkShow *sum, YkText *text)
{
    yk_text_puts(text, "<mrow>");
    const YkShow *first = yk_show_first(sum);
    if (!first) put_whole(text, 0);
    for (const YkShow *part = first; part; part = yk_show_next(sum, part)) {
        if (part->negative)
            yk_text_puts(text, "<mo>−</mo>");
        else if (part != first)
            yk_text_puts(text, "<mo>+</mo>");
        put_product(sheet, part, text);
    }
    yk_text_puts(text, "</mrow>");
}

void yk_write_mathml(const YkSheet *sheet, const YkShow *sum, YkText *text)
{
    put_sum(sheet, sum, text);
}
