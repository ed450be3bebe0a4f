// Writes the tree as a line of text: TEXT, BOOK, LATEX and C.
#include "ring/print/write.h"
#include "ring/print/pattern.h"
#include "ring/print/shown.h"

typedef struct Pen {
    const YkSheet *sheet;
    YkText *text;
    YkRingFormat format;
    bool is_plain; // TEXT or BOOK
    char times;
} Pen;

static void put_sum(const Pen *pen, const YkShow *sum);

static void put_digits(const Pen *pen, int64_t value)
{
    char digits[24];
    size_t at = sizeof digits;
    if (value < 10) {
        digits[0] = (char)('0' + value);
        yk_text_add(pen->text, digits, 1);
        return;
    }
    for (int64_t rest = value; rest > 0; rest /= 10) digits[--at] = (char)('0' + rest % 10);
    yk_text_add(pen->text, digits + at, sizeof digits - at);
}

static void put_whole(const Pen *pen, int64_t value)
{
    put_digits(pen, value);
    if (pen->format == YK_RING_C) yk_text_puts(pen->text, ".0");
}

static void put_name(const Pen *pen, int32_t symbol)
{
    size_t start = pen->text->length;
    YkMarks *marks = &pen->sheet->ring->marks;
    yk_write_name(pen->sheet->ring, symbol, pen->format, pen->text);
    if (!marks->is_wanted) return;
    if (YK_ROOM(marks->items, marks->count, marks->capacity))
        marks->items[marks->count++] = (YkMark){start, pen->text->length - start, symbol};
    else
        marks->failed = true;
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
    yk_text_add(pen->text, &pen->times, 1);
}

// Writes k pi / n.
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

// Writes an angle; returns how many terms it has.
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
        put_name(pen, shown.symbol);
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

static void put_root(const Pen *pen, unsigned surd)
{
    bool latex = pen->format == YK_RING_LATEX;
    yk_text_puts(pen->text, latex ? "\\sqrt{" : "sqrt(");
    put_whole(pen, yk_surd_square(surd));
    yk_text_puts(pen->text, latex ? "}" : ")");
}

// Writes a sum, or a symbol if there is none.
static void put_base(const Pen *pen, const YkShow *sum, int32_t symbol)
{
    if (!sum) {
        put_name(pen, symbol);
        return;
    }
    yk_text_puts(pen->text, "(");
    put_sum(pen, sum);
    yk_text_puts(pen->text, ")");
}

// Writes a base to a positive power. C has no powers: small ones become products, others pow().
static void put_power(const Pen *pen, const YkShow *sum, int32_t symbol, int32_t exponent)
{
    enum { WRITTEN_OUT_MAX = 4 };
    if (exponent == 1) {
        put_base(pen, sum, symbol);
        return;
    }
    bool in_c = pen->format == YK_RING_C, call = in_c && exponent > WRITTEN_OUT_MAX;
    if (call) yk_text_puts(pen->text, "pow(");
    put_base(pen, sum, symbol);
    for (int32_t i = 1; in_c && !call && i < exponent; i++) {
        yk_text_puts(pen->text, "*");
        put_base(pen, sum, symbol);
    }
    if (in_c && !call) return;
    yk_text_puts(pen->text, call ? ", " : pen->format == YK_RING_LATEX ? "^{" : "^");
    put_digits(pen, exponent);
    yk_text_puts(pen->text, call ? ")" : pen->format == YK_RING_LATEX ? "}" : "");
}

// Writes what separates two factors.
static void separate(const Pen *pen, bool *any)
{
    if (*any) put_times(pen);
    *any = true;
}

// Writes the powers of a monomial from `k` up to a class, those with positive exponents (sign 1) or with negative ones
// (sign -1); returns the next k.
static uint32_t put_powers(const Pen *pen, YkMonomial monomial, uint32_t k, YkRingClass last, int32_t sign, bool *any)
{
    for (; k < monomial.count && yk_rank_class(monomial.powers[k].rank) <= last; k++) {
        int32_t exponent = sign * monomial.powers[k].exponent;
        if (exponent < 0) continue;
        separate(pen, any);
        put_power(pen, NULL, yk_rank_symbol(monomial.powers[k].rank), exponent);
    }
    return k;
}

// Writes the part of a term above the line.
static void put_term(const Pen *pen, const YkShow *show, bool *any)
{
    const YkAtom *atom = &show->term.atom;
    if (show->has_number) {
        separate(pen, any);
        put_ratio(pen, show->term.number);
    }
    if (atom->is_imaginary) {
        separate(pen, any);
        yk_text_puts(pen->text, imaginary_unit(pen));
    }
    if (atom->surd != 0) {
        separate(pen, any);
        put_root(pen, atom->surd);
    }
    uint32_t late = put_powers(pen, show->term.monomial, 0, YK_RING_FORCE, 1, any);
    if (atom->function != YK_SHOWN_ONE) {
        separate(pen, any);
        put_function(pen, atom);
    }
    put_powers(pen, show->term.monomial, late, YK_RING_ACCELERATION, 1, any);
}

static void put_product(const Pen *pen, const YkShow *product)
{
    bool high, any = false;
    size_t below = yk_show_below(product, &high);
    bool latex = pen->format == YK_RING_LATEX && below > 0, brackets = below > 1 || (pen->format == YK_RING_C && high);
    if (latex) yk_text_puts(pen->text, "\\frac{");
    for (const YkShow *factor = yk_show_first(product); factor; factor = yk_show_next(product, factor)) {
        if (factor->kind == YK_SHOW_TERM) {
            put_term(pen, factor, &any);
            continue;
        }
        separate(pen, &any);
        put_power(pen, factor, -1, factor->exponent);
    }
    if (!any) put_whole(pen, 1);
    if (below == 0) return;
    yk_text_puts(pen->text, latex ? "}{" : brackets ? "/(" : "/");
    any = false;
    for (const YkShow *factor = yk_show_first(product); factor; factor = yk_show_next(product, factor))
        put_powers(pen, factor->term.monomial, 0, YK_RING_ACCELERATION, -1, &any);
    yk_text_puts(pen->text, latex ? "}" : brackets ? ")" : "");
}

static void put_sum(const Pen *pen, const YkShow *sum)
{
    const YkShow *first = yk_show_first(sum);
    if (!first) put_whole(pen, 0);
    for (const YkShow *part = first; part; part = yk_show_next(sum, part)) {
        if (part != first)
            yk_text_add(pen->text, part->negative ? " - " : " + ", 3);
        else if (part->negative)
            yk_text_add(pen->text, "-", 1);
        put_product(pen, part);
    }
}

// Writes a sum on one line: for TEXT, BOOK, LATEX and C.
static void write_linear(const YkSheet *sheet, const YkShow *sum, YkText *text)
{
    const YkRingFormat format = sheet->format;
    const Pen pen = {.sheet = sheet,
                     .text = text,
                     .format = format,
                     .is_plain = format == YK_RING_TEXT || format == YK_RING_BOOK,
                     .times = format == YK_RING_TEXT || format == YK_RING_C ? '*' : ' '};
    put_sum(&pen, sum);
}

static bool write_element(YkRing *ring, const YkPoisson *a, YkRingFormat format, YkRingStyle style, YkText *text)
{
    if (!yk_ring_spend(ring, (1 + a->count) * YK_WORK_PRINT)) return false;
    YkSheet sheet = {ring, ring->sheet, format, style, false};
    size_t count = 0;
    yk_arena_clear(ring->sheet);
    ring->marks.count = 0;
    ring->marks.failed = false;
    YkShownTerm *terms = yk_shown_terms(&sheet, a, &count);
    const YkShow *sum = terms ? yk_show_element(&sheet, terms, count) : NULL;
    if (sum && !yk_arena_failed(sheet.arena) && format == YK_RING_MATHML)
        yk_write_mathml(&sheet, sum, text);
    else if (sum && !yk_arena_failed(sheet.arena))
        write_linear(&sheet, sum, text);
    bool well = sum && !yk_arena_failed(sheet.arena) && !text->failed;
    if (!well && (text->failed || yk_ring_status(ring) == YK_RING_OK)) yk_ring_fail(ring, YK_RING_MEMORY);
    return well;
}

const YkPoisson *yk_ring_view(YkRing *ring, const YkRingView *view)
{
    const YkPoisson *a = view->changes ? yk_ring_change(ring, view->of, view->changes) : view->of;
    if (!a || view->side == YK_RING_WHOLE) return a;
    return view->side == YK_RING_X ? yk_ring_real(ring, a) : yk_ring_imaginary(ring, a);
}

bool yk_ring_write_view(YkRing *ring, const YkRingView *view, YkRingFormat format, YkRingStyle style, YkText *text)
{
    size_t start = text->length;
    bool is_linear = format != YK_RING_MATHML;
    if (!view->of) return false;
    if (view->of->count == 0 && is_linear) { // as most entries of a matrix
        yk_text_puts(text, format == YK_RING_C ? "0.0" : "0");
        if (text->failed) yk_ring_fail(ring, YK_RING_MEMORY);
        return !text->failed;
    }
    if (is_linear && yk_pattern_write(ring, view, format, style, text)) {
        if (text->failed) yk_ring_fail(ring, YK_RING_MEMORY);
        return yk_ring_spend(ring, YK_WORK_PRINT) && !text->failed;
    }
    const YkPoisson *a = yk_ring_view(ring, view);
    if (!a || !write_element(ring, a, format, style, text)) return false;
    if (is_linear && ring->marks.is_wanted && yk_ring_is_real(ring, a)) // i has another name where a symbol is called i
        yk_pattern_keep(ring, view, format, style, text, start);
    return true;
}

bool yk_ring_write(YkRing *ring, const YkPoisson *a, YkRingFormat format, YkRingStyle style, YkText *text)
{
    const YkRingView view = yk_ring_as_is(a);
    return yk_ring_write_view(ring, &view, format, style, text);
}

static bool is_whole(const YkShownTerm *term)
{
    if (term->number.under != 1) return false;
    for (size_t i = 0; i < term->monomial.count; i++)
        if (term->monomial.powers[i].exponent < 0) return false;
    return true;
}

const YkPoisson *yk_ring_half_if_whole(YkRing *ring, const YkPoisson *a)
{
    YkSheet sheet = {ring, ring->sheet, YK_RING_TEXT, YK_RING_EXPANDED, false};
    size_t count = 0;
    const YkPoisson *half = yk_ring_scale(ring, a, 1, 2);
    yk_arena_clear(ring->sheet);
    const YkShownTerm *terms = half ? yk_shown_terms(&sheet, half, &count) : NULL;
    for (size_t k = 0; k < count && terms; k++)
        if (!is_whole(&terms[k])) return NULL;
    return terms ? half : NULL;
}
