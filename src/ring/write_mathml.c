// The tree as presentation MathML (W3C, MathML Core).
#include "ring/shown.h"

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

static void put_base(const YkSheet *sheet, const YkShow *factor, YkText *text)
{
    switch (factor->kind) {
    case YK_SHOW_NUMBER:
        put_ratio(text, factor->number);
        break;
    case YK_SHOW_SYMBOL:
        yk_text_puts(text, yk_ring_name_in(sheet->ring, factor->symbol, YK_RING_MATHML));
        break;
    case YK_SHOW_I:
        yk_text_puts(text, "<mi mathvariant=\"normal\">i</mi>");
        break;
    case YK_SHOW_SQRT:
        yk_text_puts(text, "<msqrt>");
        put_ratio(text, factor->number);
        yk_text_puts(text, "</msqrt>");
        break;
    case YK_SHOW_FUNCTION:
        put_function(sheet, &factor->atom, text);
        break;
    case YK_SHOW_PRODUCT:
        break; // a product within a product is part of it
    case YK_SHOW_SUM:
        yk_text_puts(text, "<mrow><mo>(</mo>");
        put_sum(sheet, factor, text);
        yk_text_puts(text, "<mo>)</mo></mrow>");
        break;
    }
}

static void put_power(const YkSheet *sheet, const YkShow *factor, int32_t exponent, YkText *text)
{
    if (exponent != 1) yk_text_puts(text, "<msup>");
    put_base(sheet, factor, text);
    if (exponent == 1) return;
    put_whole(text, exponent);
    yk_text_puts(text, "</msup>");
}

static size_t count_below(const YkShow *product)
{
    size_t count = 0;
    for (const YkShow *factor = product->first; factor; factor = factor->next) count += factor->exponent < 0;
    return count;
}

static void put_factors(const YkSheet *sheet, const YkShow *product, int32_t sign, YkText *text)
{
    size_t count = 0;
    yk_text_puts(text, "<mrow>");
    for (const YkShow *factor = product->first; factor; factor = factor->next) {
        if ((factor->exponent > 0) != (sign > 0)) continue;
        if (count++ > 0) yk_text_puts(text, factor->kind == YK_SHOW_FUNCTION ? SPACED_TIMES : TIMES);
        put_power(sheet, factor, sign * factor->exponent, text);
    }
    if (count == 0) put_whole(text, 1);
    yk_text_puts(text, "</mrow>");
}

static void put_product(const YkSheet *sheet, const YkShow *part, YkText *text)
{
    bool fraction = count_below(part) > 0;
    if (fraction) yk_text_puts(text, "<mfrac>");
    put_factors(sheet, part, 1, text);
    if (!fraction) return;
    put_factors(sheet, part, -1, text);
    yk_text_puts(text, "</mfrac>");
}

static void put_sum(const YkSheet *sheet, const YkShow *sum, YkText *text)
{
    yk_text_puts(text, "<mrow>");
    if (!sum->first) put_whole(text, 0);
    for (const YkShow *part = sum->first; part; part = part->next) {
        if (part->negative)
            yk_text_puts(text, "<mo>−</mo>");
        else if (part != sum->first)
            yk_text_puts(text, "<mo>+</mo>");
        put_product(sheet, part, text);
    }
    yk_text_puts(text, "</mrow>");
}

void yk_write_mathml(const YkSheet *sheet, const YkShow *sum, YkText *text)
{
    put_sum(sheet, sum, text);
}
