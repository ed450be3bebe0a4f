// Pieces that all printers of pages share: elements, numbers, matrices.
#include <math.h>
#include <string.h>
#include "base/letters.h"
#include "base/number.h"
#include "page/print.h"

void yk_print_view(YkPrinting *printing, const YkRingView *view, YkRingFormat format, YkRingStyle style, YkText *text)
{
    YkRingView shown = *view;
    if (!shown.of) shown.of = yk_ring_rational(printing->ring, 0, 1);
    if (!yk_ring_write_view(printing->ring, &shown, format, style, text)) printing->failed = true;
}

void yk_print_element(YkPrinting *printing, const YkPoisson *a, YkRingFormat format, YkRingStyle style, YkText *text)
{
    const YkRingView view = yk_ring_as_is(a);
    yk_print_view(printing, &view, format, style, text);
}

YkRingView yk_print_piece(const YkPagePiece *piece)
{
    return (YkRingView){piece->over, piece->changes, YK_RING_WHOLE};
}

bool yk_print_has_sum(const char *text)
{
    int depth = 0;
    for (const char *c = text; *c; c++) {
        depth += (*c == '(') - (*c == ')');
        if (depth == 0 && (*c == '+' || *c == '-')) return true;
    }
    return false;
}

bool yk_print_is_one_factor(const char *text)
{
    int depth = 0;
    for (const char *c = text; *c; c++) {
        depth += (*c == '(') - (*c == ')');
        if (depth == 0 && strchr(" */+-", *c)) return false;
    }
    return true;
}

void yk_print_brackets(YkText *text, size_t start)
{
    size_t length = text->length - start;
    yk_text_puts(text, "()");
    if (text->failed) return;
    memmove(text->data + start + 1, text->data + start, length);
    text->data[start] = '(';
}

bool yk_print_is_sum(YkPrinting *printing, const YkRingView *view)
{
    YkText text = {0};
    yk_print_view(printing, view, YK_RING_BOOK, YK_RING_TEXTBOOK, &text);
    bool is_sum = yk_print_has_sum(yk_text_get(&text));
    yk_text_free(&text);
    return is_sum;
}

double yk_print_entry(const YkPrinting *printing, const YkRingView *entry)
{
    const YkPoisson *a = entry->of ? yk_ring_view(printing->ring, entry) : NULL;
    return a ? yk_ring_value(printing->ring, a, printing->values).x : 0;
}

// Returns whether a quotient is a number in spite of rounding. Where its denominator vanishes, as at a dead point or a
// change point, the pose is known to rounding over the sine, its accelerations to the third power of that.
static bool is_determined(const YkPrinting *printing, const YkLine *line, double value, double under)
{
    const double rounding = 4e-16, most = 1e-6;
    double over_size = yk_ring_magnitude(printing->ring, yk_line_value(printing->ring, line), printing->values);
    double under_size = yk_ring_magnitude(printing->ring, line->value_under, printing->values);
    double ratio = fabs(under) / under_size, error = rounding * over_size / (fabs(under) * ratio * ratio);
    return error <= most * fmax(fabs(value), over_size / under_size);
}

bool yk_print_value(const YkPrinting *printing, const YkLine *line, YkVec *value)
{
    if (!printing->values || !line->value) return false;
    double within = line->within ? yk_ring_value(printing->ring, line->within, printing->values).x : 0;
    if (!(within >= 0 && within <= 1)) return false;
    const YkPoisson *shown = yk_line_value(printing->ring, line);
    if (!shown) return false;
    *value = yk_ring_value(printing->ring, shown, printing->values);
    if (line->value_under) {
        double under = yk_ring_value(printing->ring, line->value_under, printing->values).x;
        *value = yk_scale(1 / under, *value);
        if (!is_determined(printing, line, value->x, under)) return false;
    }
    return isfinite(value->x) && isfinite(value->y);
}

const YkShownMatrix *yk_print_only_matrix(const YkLine *line)
{
    const YkShownMatrix *matrix = NULL;
    for (const YkPagePiece *piece = line->first; piece; piece = piece->next) {
        if (piece->kind != YK_PIECE_MATRIX) continue;
        if (matrix) return NULL;
        matrix = piece->matrix;
    }
    return matrix;
}

void yk_print_number(YkText *text, double value)
{
    char digits[YK_NUMBER_SIZE];
    if (fabs(value) < 1e-14) value = 0; // rounding of a zero
    yk_number_write_digits(value, 6, digits);
    yk_text_puts(text, digits);
}

bool yk_print_is_letter_name(const char *name)
{
    return yk_is_letter(name[0]) && strspn(name + 1, "0123456789") == strlen(name + 1);
}
