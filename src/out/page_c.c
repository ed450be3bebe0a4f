// Pages as C: statements in doubles for a function's body, headings as comments. Symbols by yk_ring_name_in.
#include <string.h>
#include "out/page_print.h"

static void put_expression(YkPrinting *printing, const YkPoisson *a, YkText *text)
{
    yk_print_element(printing, a, YK_RING_C, YK_RING_TEXTBOOK, text);
}

static void put_comment(YkText *text, const char *words)
{
    yk_text_puts(text, "// ");
    for (const char *c = words; *c; c++) yk_text_format(text, "%c", *c == '\\' ? '/' : *c);
    yk_text_puts(text, "\n");
}

// J and gamma entry by entry, zeros too: a caller's array need not be cleared.
static void put_matrix(YkPrinting *printing, const YkLine *line, const YkShownMatrix *matrix)
{
    for (size_t i = 0; i < matrix->rows; i++)
        for (size_t k = 0; k < matrix->columns; k++) {
            yk_text_format(printing->text, "%s[%z]", line->target, i);
            if (matrix->columns > 1) yk_text_format(printing->text, "[%z]", k);
            yk_text_puts(printing->text, " = ");
            put_expression(printing, matrix->entries[i * matrix->columns + k], printing->text);
            yk_text_puts(printing->text, ";\n");
        }
}

static void put_statement(YkPrinting *printing, const YkLine *line, size_t *row)
{
    YkText *text = printing->text;
    const char *target = line->solved >= 0 ? yk_ring_name_in(printing->ring, line->solved, YK_RING_C) : line->target;
    bool is_row = line->solved < 0 && strcmp(target, "Phi") == 0;
    if (is_row)
        yk_text_format(text, "Phi[%z] = ", (*row)++);
    else
        yk_text_format(text, "const double %s = ", target);
    int64_t over, under;
    bool is_quotient = line->under && !(yk_ring_is_rational(line->under, &over, &under) && over == 1 && under == 1);
    if (is_quotient) yk_text_puts(text, "(");
    put_expression(printing, line->over, text);
    if (is_quotient) {
        yk_text_puts(text, ") / (");
        put_expression(printing, line->under, text);
        yk_text_puts(text, ")");
    }
    yk_text_puts(text, ";\n");
}

static const YkShownMatrix *first_matrix(const YkLine *line)
{
    for (const YkPagePiece *piece = line->first; piece; piece = piece->next)
        if (piece->kind == YK_PIECE_MATRIX) return piece->matrix;
    return NULL;
}

void yk_print_c(YkPrinting *printing, const YkPage *page)
{
    size_t row = 0;
    if (printing->title) put_comment(printing->text, printing->title);
    for (const YkLine *line = page->first; line && !printing->failed; line = line->next) {
        if (line->kind == YK_LINE_HEADING) {
            if (line->level == 1) yk_text_puts(printing->text, "\n");
            put_comment(printing->text, line->text);
        }
        if (line->kind != YK_LINE_FORMULA || (!line->target && line->solved < 0)) continue;
        const YkShownMatrix *matrix = line->over ? NULL : first_matrix(line);
        if (matrix)
            put_matrix(printing, line, matrix);
        else if (line->over)
            put_statement(printing, line, &row);
    }
}
