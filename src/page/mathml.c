// Prints pages as an HTML document with presentation MathML.
#include <string.h>
#include "page/print.h"

static void put_escaped(YkText *text, const char *words)
{
    if (words == yk_text_lost) yk_text_fail(text);
    for (const char *c = words; *c; c++) {
        if (*c == '<')
            yk_text_puts(text, "&lt;");
        else if (*c == '>')
            yk_text_puts(text, "&gt;");
        else if (*c == '&')
            yk_text_puts(text, "&amp;");
        else
            yk_text_add(text, c, 1);
    }
}

// Writes a point's name: a letter with digits as subscript, other names upright.
static void put_point(YkText *text, const char *name)
{
    if (yk_print_is_letter_name(name) && name[1]) {
        yk_text_format(text, "<msub><mi>%c</mi><mn>%s</mn></msub>", *name, name + 1);
    } else if (strspn(name, "0123456789") == strlen(name)) {
        yk_text_format(text, "<mn>%s</mn>", name);
    } else {
        yk_text_puts(text, name[1] ? "<mi mathvariant=\"normal\">" : "<mi>");
        put_escaped(text, name);
        yk_text_puts(text, "</mi>");
    }
}

static void put_points(YkText *text, const char *names)
{
    const char *slash = strchr(names, '/');
    YkText first = {0};
    yk_text_add(&first, names, slash ? (size_t)(slash - names) : strlen(names));
    yk_text_puts(text, "<mrow>");
    put_point(text, yk_text_get(&first));
    yk_text_free(&first);
    if (slash) {
        yk_text_puts(text, "<mo>/</mo>");
        put_point(text, slash + 1);
    }
    yk_text_puts(text, "</mrow>");
}

static void put_base(YkText *text, const char *base)
{
    static const char *const greek[][2] = {{"gamma", "γ"}, {"lambda", "λ"}, {"xi", "ξ"},
                                           {"tau", "τ"},   {"omega", "ω"},  {"alpha", "α"}};
    const char *shown = base;
    for (size_t k = 0; k < sizeof greek / sizeof *greek; k++)
        if (strcmp(base, greek[k][0]) == 0) shown = greek[k][1];
    yk_text_puts(text, strcmp(base, "D") == 0 ? "<mi>" : "<mi style=\"font-weight:bold\">");
    put_escaped(text, shown);
    yk_text_puts(text, "</mi>");
}

static void put_name(YkText *text, const YkPagePiece *piece)
{
    const char *tag = piece->sub && piece->super ? "msubsup" : piece->sub ? "msub" : piece->super ? "msup" : "mrow";
    yk_text_format(text, "<%s>", tag);
    put_base(text, piece->text);
    if (piece->sub) put_points(text, piece->sub);
    if (piece->super) put_points(text, piece->super);
    yk_text_format(text, "</%s>", tag);
}

static void put_number(YkText *text, double value)
{
    yk_text_puts(text, value < 0 ? "<mrow><mo>-</mo><mn>" : "<mrow><mn>");
    yk_print_number(text, value < 0 ? -value : value);
    yk_text_puts(text, "</mn></mrow>");
}

static void put_matrix(YkPrinting *printing, const YkShownMatrix *matrix, bool numbers, YkText *text)
{
    yk_text_puts(text, "<mrow><mo>[</mo><mtable>");
    for (size_t i = 0; i < matrix->rows; i++) {
        yk_text_puts(text, "<mtr>");
        for (size_t k = 0; k < matrix->columns; k++) {
            bool below = i + 1 < matrix->rows && matrix->row_cut[i],
                 beside = k + 1 < matrix->columns && matrix->column_cut[k];
            const YkRingView entry = yk_shown_entry(matrix, i * matrix->columns + k);
            yk_text_format(text, "<mtd%s><mrow>",
                           below && beside ? " class=\"b r\""
                           : below         ? " class=\"b\""
                           : beside        ? " class=\"r\""
                                           : "");
            if (numbers)
                put_number(text, yk_print_entry(printing, &entry));
            else
                yk_print_view(printing, &entry, YK_RING_MATHML, YK_RING_TEXTBOOK, text);
            yk_text_puts(text, "</mrow></mtd>");
        }
        yk_text_puts(text, "</mtr>");
    }
    yk_text_puts(text, "</mtable><mo>]</mo></mrow>");
}

static void put_element(YkPrinting *printing, YkRingView view, YkRingStyle style, bool is_factor, YkText *text)
{
    bool brackets = is_factor && yk_print_is_sum(printing, &view);
    yk_text_puts(text, brackets ? "<mrow><mo>(</mo>" : "<mrow>");
    yk_print_view(printing, &view, YK_RING_MATHML, style, text);
    yk_text_puts(text, brackets ? "<mo>)</mo></mrow>" : "</mrow>");
}

static void put_side(YkPrinting *printing, const YkPagePiece *piece, int side, YkText *text)
{
    if (!piece->factors[side]) {
        put_element(printing, yk_ring_as_is(side == 0 ? piece->over : piece->under), YK_RING_TEXTBOOK, false, text);
        return;
    }
    yk_text_puts(text, "<mrow>");
    for (size_t k = 0; k < piece->factor_count[side]; k++)
        put_element(printing, yk_ring_as_is(piece->factors[side][k]), YK_RING_TEXTBOOK, piece->factor_count[side] > 1,
                    text);
    yk_text_puts(text, "</mrow>");
}

static void put_piece(YkPrinting *printing, const YkPagePiece *piece, YkText *text)
{
    switch (piece->kind) {
    case YK_PIECE_ELEMENT:
        put_element(printing, yk_print_piece(piece), piece->style, piece->is_factor, text);
        break;
    case YK_PIECE_QUOTIENT:
        yk_text_puts(text, "<mfrac>");
        put_side(printing, piece, 0, text);
        put_side(printing, piece, 1, text);
        yk_text_puts(text, "</mfrac>");
        break;
    case YK_PIECE_VECTOR:
        put_name(text, piece);
        break;
    case YK_PIECE_SIGN:
        yk_text_format(text, "<mo>%s</mo>",
                       strcmp(piece->text, "x") == 0   ? "×"
                       : strcmp(piece->text, ".") == 0 ? "·"
                                                       : piece->text);
        break;
    case YK_PIECE_WORDS:
        yk_text_puts(text, "<mtext>");
        put_escaped(text, piece->text);
        yk_text_puts(text, "</mtext>");
        break;
    case YK_PIECE_MATRIX:
        put_matrix(printing, piece->matrix, false, text);
        break;
    }
}

static void put_value(YkPrinting *printing, const YkLine *line, YkText *text)
{
    YkVec value;
    const YkShownMatrix *matrix = yk_print_only_matrix(line);
    if (printing->values && matrix) {
        yk_text_puts(text, "<mo>=</mo>");
        put_matrix(printing, matrix, true, text);
    } else if (yk_print_value(printing, line, &value)) {
        yk_text_puts(text, "<mo>=</mo>");
        if (line->is_vector) yk_text_puts(text, "<mo>[</mo>");
        put_number(text, value.x);
        if (!line->is_vector) return;
        yk_text_puts(text, "<mo>,</mo>");
        put_number(text, value.y);
        yk_text_puts(text, "<mo>]</mo>");
    }
}

static void put_line(YkPrinting *printing, const YkLine *line)
{
    YkText *text = printing->text;
    if (line->kind == YK_LINE_FORMULA) {
        if (line->text) {
            yk_text_puts(text, "<p>");
            put_escaped(text, line->text);
            yk_text_puts(text, ":</p>\n");
        }
        yk_text_puts(text, "<math display=\"block\" xmlns=\"http://www.w3.org/1998/Math/MathML\"><mrow>");
        for (const YkPagePiece *piece = line->first; piece; piece = piece->next) put_piece(printing, piece, text);
        put_value(printing, line, text);
        yk_text_puts(text, "</mrow></math>\n");
        return;
    }
    if (line->kind == YK_LINE_WORDS) {
        yk_text_puts(text, "<p>");
        put_escaped(text, line->text);
        yk_text_puts(text, "</p>\n");
    } else {
        int level = printing->heading + line->level - 1;
        yk_text_format(text, "<h%d>", level);
        put_escaped(text, line->text);
        yk_text_format(text, "</h%d>\n", level);
    }
}

void yk_print_mathml_part(YkPrinting *printing, const YkPage *part)
{
    for (const YkLine *line = part->first; line && !printing->failed; line = line->next) put_line(printing, line);
}

bool yk_page_write_part(const YkPage *page, int heading, const double *values, YkText *html)
{
    YkPrinting printing = {.ring = page->ring, .text = html, .values = values, .heading = heading};
    if (page->failed) return false;
    yk_print_mathml_part(&printing, page);
    return !printing.failed && !html->failed;
}

void yk_print_mathml_head(YkPrinting *printing)
{
    const char *title = printing->title ? printing->title : "Derivation";
    yk_text_puts(printing->text, "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<title>");
    put_escaped(printing->text, title);
    yk_text_puts(printing->text,
                 "</title>\n<style>math { margin: 0.6em 2em; text-align: left } .r { border-right: 1px solid } "
                 ".b { border-bottom: 1px solid } mtd { padding: 0.2em 0.6em }</style>\n</head>\n<body>\n<h1>");
    put_escaped(printing->text, title);
    yk_text_puts(printing->text, "</h1>\n");
    printing->heading = 2;
}

void yk_print_mathml_end(YkPrinting *printing)
{
    yk_text_puts(printing->text, "</body>\n</html>\n");
}
