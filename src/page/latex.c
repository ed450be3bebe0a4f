// Prints pages as a LaTeX document: article and amsmath.
#include "base/utf8.h"
#include "page/latex_display.h"
#include "page/print.h"

static void put_character(YkText *text, char c)
{
    switch (c) {
    case '\\':
        yk_text_puts(text, "\\textbackslash{}");
        break;
    case '<':
        yk_text_puts(text, "\\textless{}");
        break;
    case '>':
        yk_text_puts(text, "\\textgreater{}");
        break;
    case '|':
        yk_text_puts(text, "\\textbar{}");
        break;
    case '"':
        yk_text_puts(text, "''");
        break;
    default:
        if (strchr("_%&#${}", c))
            yk_text_format(text, "\\%c", c);
        else if (c == '^' || c == '~')
            yk_text_format(text, "\\%c{}", c);
        else
            yk_text_format(text, "%c", c);
    }
}

// Writes Latin letters as they are; article does not know others, and a ? is better than a page that does not compile.
static void put_words(YkText *text, const char *words)
{
    size_t length = strlen(words), bytes;
    for (size_t i = 0; i < length; i += bytes) {
        uint32_t code = 0;
        bytes = yk_utf8_decode(words + i, length - i, &code);
        if (bytes == 0) bytes = 1, code = UINT32_MAX;
        if (code < 0x80)
            put_character(text, words[i]);
        else if (code >= 0xc0 && code < 0x180)
            yk_text_add(text, words + i, bytes);
        else
            yk_text_puts(text, "?");
    }
}

// Writes a part of a point's name: O1 as O_1, crank.A upright.
static void put_point(YkText *text, const char *name, size_t length)
{
    bool is_letter = length > 0 && strspn(name + 1, "0123456789") >= length - 1 && yk_is_letter(*name);
    if (is_letter && length == 1) {
        yk_text_add(text, name, 1);
    } else if (is_letter) {
        yk_text_add(text, name, 1);
        yk_text_puts(text, "_{");
        yk_text_add(text, name + 1, length - 1);
        yk_text_puts(text, "}");
    } else if (strspn(name, "0123456789") >= length) {
        yk_text_add(text, name, length);
    } else {
        yk_text_puts(text, "\\mathrm{");
        for (size_t i = 0; i < length; i++) {
            if (name[i] == '_') yk_text_puts(text, "\\");
            yk_text_format(text, "%c", name[i]);
        }
        yk_text_puts(text, "}");
    }
}

static void put_points(YkText *text, const char *names)
{
    const char *slash = strchr(names, '/');
    put_point(text, names, slash ? (size_t)(slash - names) : strlen(names));
    if (!slash) return;
    yk_text_puts(text, "/");
    put_point(text, slash + 1, strlen(slash + 1));
}

static void put_base(YkText *text, const char *base)
{
    static const char *const greek[] = {"gamma", "lambda", "xi", "tau", "omega", "alpha"};
    for (size_t k = 0; k < sizeof greek / sizeof *greek; k++)
        if (strcmp(base, greek[k]) == 0) {
            yk_text_format(text, "\\boldsymbol{\\%s}", base);
            return;
        }
    yk_text_format(text, strcmp(base, "D") == 0 ? "%s" : "\\mathbf{%s}", base);
}

static void put_name(YkText *text, const YkPagePiece *piece)
{
    put_base(text, piece->text);
    if (piece->sub) {
        yk_text_puts(text, "_{");
        put_points(text, piece->sub);
        yk_text_puts(text, "}");
    }
    if (piece->super) {
        yk_text_puts(text, "^{");
        put_points(text, piece->super);
        yk_text_puts(text, "}");
    }
}

// Writes 1.5e-7 as 1.5 \cdot 10^{-7}.
static void put_number(YkText *text, double value)
{
    YkText digits = {0};
    yk_print_number(&digits, value);
    const char *e = strchr(yk_text_get(&digits), 'e');
    if (e) {
        yk_text_add(text, yk_text_get(&digits), (size_t)(e - yk_text_get(&digits)));
        yk_text_format(text, "\\cdot 10^{%s}", e + 1);
    } else {
        yk_text_puts(text, yk_text_get(&digits));
    }
    yk_text_free(&digits);
}

static void put_matrix(YkPrinting *printing, const YkShownMatrix *matrix, bool numbers, YkText *text)
{
    yk_text_puts(text, "\\left[\\begin{array}{");
    for (size_t k = 0; k < matrix->columns; k++)
        yk_text_puts(text, k + 1 < matrix->columns && matrix->column_cut[k] ? "c|" : "c");
    yk_text_puts(text, "}");
    for (size_t i = 0; i < matrix->rows; i++) {
        for (size_t k = 0; k < matrix->columns; k++) {
            const YkRingView entry = yk_shown_entry(matrix, i * matrix->columns + k);
            yk_text_puts(text, k ? " & " : " ");
            if (numbers)
                put_number(text, yk_print_entry(printing, &entry));
            else
                yk_print_view(printing, &entry, YK_RING_LATEX, YK_RING_TEXTBOOK, text);
        }
        if (i + 1 < matrix->rows) yk_text_puts(text, matrix->row_cut[i] ? " \\\\ \\hline" : " \\\\");
    }
    yk_text_puts(text, " \\end{array}\\right]");
}

static void put_sign(YkText *text, const char *sign)
{
    if (strcmp(sign, "x") == 0)
        yk_text_puts(text, "\\times");
    else if (strcmp(sign, ".") == 0)
        yk_text_puts(text, "\\cdot");
    else if (strcmp(sign, ",") == 0)
        yk_text_puts(text, ",\\quad");
    else if (strcmp(sign, "[") == 0)
        yk_text_puts(text, "\\left[");
    else if (strcmp(sign, "]") == 0)
        yk_text_puts(text, "\\right]");
    else
        yk_text_puts(text, sign);
}

static void put_element(YkPrinting *printing, const YkPagePiece *piece, YkText *text)
{
    const YkRingView view = yk_print_piece(piece);
    bool brackets = piece->is_factor && yk_print_is_sum(printing, &view);
    if (brackets) yk_text_puts(text, "\\left(");
    yk_print_view(printing, &view, YK_RING_LATEX, piece->style, text);
    if (brackets) yk_text_puts(text, "\\right)");
}

static void put_factors(YkPrinting *printing, const YkPagePiece *piece, int side, YkText *text)
{
    YkPagePiece factor = {.style = YK_RING_TEXTBOOK, .is_factor = piece->factor_count[side] > 1};
    for (size_t k = 0; k < piece->factor_count[side]; k++) {
        if (k > 0) yk_text_puts(text, " ");
        factor.over = piece->factors[side][k];
        put_element(printing, &factor, text);
    }
}

static void put_quotient(YkPrinting *printing, const YkPagePiece *piece, YkText *text)
{
    const YkPoisson *const sides[] = {piece->over, piece->under};
    for (int side = 0; side < 2; side++) {
        yk_text_puts(text, side == 0 ? "\\frac{" : "}{");
        if (piece->factors[side])
            put_factors(printing, piece, side, text);
        else
            yk_print_element(printing, sides[side], YK_RING_LATEX, YK_RING_TEXTBOOK, text);
    }
    yk_text_puts(text, "}");
}

static void put_piece(YkPrinting *printing, const YkPagePiece *piece, YkText *text)
{
    switch (piece->kind) {
    case YK_PIECE_ELEMENT:
        put_element(printing, piece, text);
        break;
    case YK_PIECE_QUOTIENT:
        put_quotient(printing, piece, text);
        break;
    case YK_PIECE_VECTOR:
        put_name(text, piece);
        break;
    case YK_PIECE_SIGN:
        put_sign(text, piece->text);
        break;
    case YK_PIECE_WORDS:
        yk_text_puts(text, "\\text{");
        put_words(text, piece->text);
        yk_text_puts(text, "}");
        break;
    case YK_PIECE_MATRIX:
        put_matrix(printing, piece->matrix, false, text);
        break;
    }
}

void yk_print_formula_latex(YkPrinting *printing, const YkLine *line, YkText *text)
{
    for (const YkPagePiece *piece = line->first; piece; piece = piece->next) {
        if (piece != line->first) yk_text_puts(text, " ");
        put_piece(printing, piece, text);
    }
}

static void put_value(YkPrinting *printing, const YkLine *line, YkText *text)
{
    YkVec value;
    const YkShownMatrix *matrix = yk_print_only_matrix(line);
    if (printing->values && matrix) {
        yk_text_puts(text, " = ");
        put_matrix(printing, matrix, true, text);
    } else if (yk_print_value(printing, line, &value)) {
        yk_text_puts(text, line->is_vector ? " = [" : " = ");
        put_number(text, value.x);
        if (!line->is_vector) return;
        yk_text_puts(text, ",\\;");
        put_number(text, value.y);
        yk_text_puts(text, "]");
    }
}

static void put_line(YkPrinting *printing, const YkLine *line)
{
    YkText *text = printing->text;
    if (line->kind == YK_LINE_HEADING) {
        yk_text_puts(text, line->level == 1 ? "\n\\section*{" : "\n\\subsection*{");
        put_words(text, line->text);
        yk_text_puts(text, "}\n");
    } else if (line->kind == YK_LINE_WORDS) {
        put_words(text, line->text);
        yk_text_puts(text, "\n\n");
    } else {
        if (line->text) {
            yk_text_puts(text, "\\noindent ");
            put_words(text, line->text);
            yk_text_puts(text, ":\n");
        }
        YkText formula = {0};
        yk_print_formula_latex(printing, line, &formula);
        put_value(printing, line, &formula);
        yk_latex_display(text, yk_text_get(&formula));
        printing->failed |= formula.failed;
        yk_text_free(&formula);
    }
}

void yk_print_latex_head(YkPrinting *printing)
{
    yk_text_puts(printing->text,
                 "\\documentclass{article}\n\\usepackage{amsmath}\n"
                 "\\paperwidth 297mm \\paperheight 210mm \\textwidth 267mm \\textheight 170mm\n"
                 "\\oddsidemargin -10.4mm \\topmargin -15.4mm \\headheight 0pt \\headsep 0pt\n"
                 "\\ifdefined\\pdfpagewidth \\pdfpagewidth\\paperwidth \\pdfpageheight\\paperheight \\fi\n"
                 "\\ifdefined\\pagewidth \\pagewidth\\paperwidth \\pageheight\\paperheight \\fi\n"
                 "\\allowdisplaybreaks\n"
                 "\\begin{document}\n");
    if (printing->title) {
        yk_text_puts(printing->text, "\\begin{center}\\Large ");
        put_words(printing->text, printing->title);
        yk_text_puts(printing->text, "\\end{center}\n");
    }
}

void yk_print_latex_part(YkPrinting *printing, const YkPage *part)
{
    for (const YkLine *line = part->first; line && !printing->failed; line = line->next) put_line(printing, line);
}

void yk_print_latex_end(YkPrinting *printing)
{
    yk_text_puts(printing->text, "\\end{document}\n");
}
