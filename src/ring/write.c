// The tree as a line of text: TEXT, BOOK, LATEX and C.
#include "ring/write.h"
#include "ring/shown.h"

typedef struct Pen {
    const YkSheet *sheet;
    YkText *text;
    YkRingFormat format;
} Pen;

static void put_sum(const Pen *pen, const YkShow *sum);

static void put_whole(const Pen *pen, int64_t value)
{
    char digits[24];
    size_t at = sizeof digits;
    for (int64_t rest = value; rest > 0 || at == sizeof digits; rest /= 10) digits[--at] = (char)('0' + rest % 10);
    yk_text_add(pen->text, digits + at, sizeof digits - at);
    if (pen->format == YK_RING_C) yk_text_puts(pen->text, ".0");
}

static void put_ratio(const Pen *pen, YkRatio ratio)
{
    bool latex = pen->format == YK_RING_LATEX && ratio.under != 1;
    if (latex) yk_text_puts(pen->text, "\\tfrac{");
    put_whole(pen, ratio.over);
    if (latex)
        yk_text_puts(pen->text, "}{");
    else if (ratio.under != 1)
        yk_text_puts(pen->text, "/");
    if (ratio.under != 1) put_whole(pen, ratio.under);
    if (latex) yk_text_puts(pen->text, "}");
}

static void put_times(const Pen *pen)
{
    yk_text_puts(pen->text, pen->format == YK_RING_TEXT || pen->format == YK_RING_C ? "*" : " ");
}

// k pi / n
static void put_pi(const Pen *pen, const YkAngleShown *shown)
{
    bool latex = pen->format == YK_RING_LATEX, fraction = shown->pi_over != 1;
    if (latex && fraction) yk_text_puts(pen->text, "\\tfrac{");
    if (shown->factor != 1) {
        put_whole(pen, shown->factor);
        put_times(pen);
    }
    yk_text_puts(pen->text, latex ? "\\pi" : "pi");
    if (!fraction) return;
    yk_text_puts(pen->text, latex ? "}{" : "/");
    put_whole(pen, shown->pi_over);
    if (latex) yk_text_puts(pen->text, "}");
}

// Returns how many terms the angle has.
static uint32_t put_angle(const Pen *pen, const YkAtom *atom)
{
    YkAngleShown shown;
    uint32_t k = 0;
    for (; yk_angle_shown(pen->sheet, atom, k, &shown); k++) {
        if (shown.negative)
            yk_text_puts(pen->text, k > 0 ? " - " : "-");
        else if (k > 0)
            yk_text_puts(pen->text, " + ");
        if (shown.symbol < 0) {
            put_pi(pen, &shown);
            continue;
        }
        if (shown.factor != 1) {
            put_whole(pen, shown.factor);
            put_times(pen);
        }
        yk_text_puts(pen->text, yk_ring_name_in(pen->sheet->ring, shown.symbol, pen->format));
    }
    return k;
}

static const char *imaginary_unit(const Pen *pen)
{
    if (pen->format == YK_RING_LATEX) return "\\mathrm{i}";
    return yk_ring_find(pen->sheet->ring, "i") < 0 ? "i" : "1i";
}

static void put_exp(const Pen *pen, const YkAtom *atom)
{
    YkAngleShown shown;
    bool brackets =
        yk_angle_shown(pen->sheet, atom, 1, &shown) || (yk_angle_shown(pen->sheet, atom, 0, &shown) && shown.negative);
    yk_text_puts(pen->text, pen->format == YK_RING_LATEX ? "e^{" : "exp(");
    yk_text_puts(pen->text, imaginary_unit(pen));
    put_times(pen);
    if (brackets) yk_text_puts(pen->text, "(");
    put_angle(pen, atom);
    if (brackets) yk_text_puts(pen->text, ")");
    yk_text_puts(pen->text, pen->format == YK_RING_LATEX ? "}" : ")");
}

static void put_function(const Pen *pen, const YkAtom *atom)
{
    if (atom->function == YK_SHOWN_EXP) {
        put_exp(pen, atom);
        return;
    }
    if (pen->format == YK_RING_LATEX) yk_text_puts(pen->text, "\\");
    yk_text_puts(pen->text, atom->function == YK_SHOWN_COS ? "cos(" : "sin(");
    put_angle(pen, atom);
    yk_text_puts(pen->text, ")");
}

static void put_root(const Pen *pen, YkRatio number)
{
    bool latex = pen->format == YK_RING_LATEX;
    yk_text_puts(pen->text, latex ? "\\sqrt{" : "sqrt(");
    put_ratio(pen, number);
    yk_text_puts(pen->text, latex ? "}" : ")");
}

// A factor without its exponent.
static void put_base(const Pen *pen, const YkShow *factor)
{
    switch (factor->kind) {
    case YK_SHOW_NUMBER:
        put_ratio(pen, factor->number);
        break;
    case YK_SHOW_SYMBOL:
        yk_text_puts(pen->text, yk_ring_name_in(pen->sheet->ring, factor->symbol, pen->format));
        break;
    case YK_SHOW_I:
        yk_text_puts(pen->text, imaginary_unit(pen));
        break;
    case YK_SHOW_SQRT:
        put_root(pen, factor->number);
        break;
    case YK_SHOW_FUNCTION:
        put_function(pen, &factor->atom);
        break;
    case YK_SHOW_PRODUCT:
        break; // a product within a product is part of it
    case YK_SHOW_SUM:
        yk_text_puts(pen->text, "(");
        put_sum(pen, factor);
        yk_text_puts(pen->text, ")");
        break;
    }
}

// A factor to a positive power. C has no powers: small ones are written out, others are pow().
static void put_power(const Pen *pen, const YkShow *factor, int32_t exponent)
{
    enum { WRITTEN_OUT_MAX = 4 };
    bool in_c = pen->format == YK_RING_C, call = in_c && exponent > WRITTEN_OUT_MAX;
    if (call) yk_text_puts(pen->text, "pow(");
    put_base(pen, factor);
    for (int32_t i = 1; in_c && !call && i < exponent; i++) {
        yk_text_puts(pen->text, "*");
        put_base(pen, factor);
    }
    if (call)
        yk_text_format(pen->text, ", %d)", (int)exponent);
    else if (!in_c && exponent != 1)
        yk_text_format(pen->text, pen->format == YK_RING_LATEX ? "^{%d}" : "^%d", (int)exponent);
}

// The factors with positive exponents (sign 1) or with negative ones (sign -1); returns how many.
static size_t put_factors(const Pen *pen, const YkShow *product, int32_t sign, bool write)
{
    size_t count = 0;
    for (const YkShow *factor = product->first; factor; factor = factor->next) {
        if ((factor->exponent > 0) != (sign > 0)) continue;
        if (write && count > 0) put_times(pen);
        if (write) put_power(pen, factor, sign * factor->exponent);
        count++;
    }
    return count;
}

static bool is_power(const YkShow *product)
{
    for (const YkShow *factor = product->first; factor; factor = factor->next)
        if (factor->exponent < -1) return true;
    return false;
}

static void put_product(const Pen *pen, const YkShow *product)
{
    size_t above = put_factors(pen, product, 1, false), below = put_factors(pen, product, -1, false);
    bool latex = pen->format == YK_RING_LATEX && below > 0,
         brackets = below > 1 || (pen->format == YK_RING_C && is_power(product));
    if (latex) yk_text_puts(pen->text, "\\frac{");
    if (above > 0)
        put_factors(pen, product, 1, true);
    else
        put_whole(pen, 1);
    if (below == 0) return;
    yk_text_puts(pen->text, latex ? "}{" : brackets ? "/(" : "/");
    put_factors(pen, product, -1, true);
    yk_text_puts(pen->text, latex ? "}" : brackets ? ")" : "");
}

static void put_sum(const Pen *pen, const YkShow *sum)
{
    if (!sum->first) put_whole(pen, 0);
    for (const YkShow *part = sum->first; part; part = part->next) {
        if (part == sum->first)
            yk_text_puts(pen->text, part->negative ? "-" : "");
        else
            yk_text_puts(pen->text, part->negative ? " - " : " + ");
        put_product(pen, part);
    }
}

void yk_write_linear(const YkSheet *sheet, const YkShow *sum, YkText *text)
{
    const Pen pen = {sheet, text, sheet->format};
    put_sum(&pen, sum);
}

const char *yk_ring_name_in(YkRing *ring, int32_t symbol, YkRingFormat format)
{
    const YkRingSymbol *named = &ring->symbols[symbol];
    if (format == YK_RING_TEXT || format == YK_RING_BOOK || !yk_ring_typeset(ring)) return named->name;
    return format == YK_RING_LATEX ? named->latex : format == YK_RING_MATHML ? named->mathml : named->c;
}

bool yk_ring_write(YkRing *ring, const YkPoisson *a, YkRingFormat format, YkRingStyle style, YkText *text)
{
    if (!a) return false;
    if (a->count == 0 && format != YK_RING_MATHML) { // most entries of a matrix
        yk_text_puts(text, format == YK_RING_C ? "0.0" : "0");
        return !text->failed;
    }
    YkSheet sheet = {ring, ring->sheet, format, style, false};
    size_t count = 0;
    yk_arena_clear(ring->sheet);
    YkShownTerm *terms = yk_shown_terms(&sheet, a, &count);
    const YkShow *sum = terms ? yk_show_element(&sheet, terms, count) : NULL;
    if (sum && !yk_arena_failed(sheet.arena) && format == YK_RING_MATHML)
        yk_write_mathml(&sheet, sum, text);
    else if (sum && !yk_arena_failed(sheet.arena))
        yk_write_linear(&sheet, sum, text);
    bool well = sum && !yk_arena_failed(sheet.arena) && !text->failed;
    if (!well) yk_ring_fail(ring, YK_RING_MEMORY); // unless another failure was first
    return well;
}

static bool is_whole(const YkSheet *sheet, const YkShownTerm *term)
{
    uint32_t count;
    YkAngleShown shown;
    const YkPower *powers = yk_powers_of(&sheet->ring->monomials, term->monomial, &count);
    if (term->number.under != 1) return false;
    for (uint32_t i = 0; i < count; i++)
        if (powers[i].exponent < 0) return false;
    for (uint32_t k = 0; yk_angle_shown(sheet, &term->atom, k, &shown); k++)
        if (shown.symbol < 0 && shown.pi_over != 1) return false;
    return true;
}

bool yk_ring_is_whole_in_print(YkRing *ring, const YkPoisson *a)
{
    YkSheet sheet = {ring, ring->sheet, YK_RING_TEXT, YK_RING_EXPANDED, false};
    size_t count = 0;
    yk_arena_clear(ring->sheet);
    const YkShownTerm *terms = a ? yk_shown_terms(&sheet, a, &count) : NULL;
    for (size_t k = 0; k < count && terms; k++)
        if (!is_whole(&sheet, &terms[k])) return false;
    return terms != NULL;
}
