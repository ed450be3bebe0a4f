// Pages as plain text: a formula is a row of boxes, each a few lines high.
#include <stdlib.h>
#include <string.h>
#include "out/page_print.h"

// Lines of text, all of one width.
typedef struct Box {
    YkText *lines;
    size_t height, width;
} Box;

static void free_box(Box *box)
{
    for (size_t i = 0; i < box->height; i++) yk_text_free(&box->lines[i]);
    free(box->lines);
    *box = (Box){0};
}

static Box new_box(YkPrinting *printing, size_t height)
{
    Box box = {.lines = calloc(height, sizeof *box.lines), .height = height};
    if (!box.lines) {
        printing->failed = true;
        box.height = 0;
    }
    return box;
}

static void fill_up(Box *box)
{
    for (size_t i = 0; i < box->height; i++)
        if (box->lines[i].length > box->width) box->width = box->lines[i].length;
    for (size_t i = 0; i < box->height; i++) yk_text_repeat(&box->lines[i], ' ', box->width - box->lines[i].length);
}

// Puts `part` to the right, middle beside middle.
static void append_box(YkPrinting *printing, Box *whole, Box *part)
{
    if (part->height > whole->height) {
        Box higher = new_box(printing, part->height);
        if (higher.height == 0) return;
        size_t above = (part->height - 1) / 2 - (whole->height - (whole->height > 0)) / 2;
        for (size_t i = 0; i < whole->height; i++) {
            higher.lines[above + i] = whole->lines[i];
            whole->lines[i] = (YkText){0};
        }
        free_box(whole);
        *whole = higher;
    }
    fill_up(whole);
    size_t above = (whole->height - 1) / 2 - (part->height - (part->height > 0)) / 2;
    for (size_t i = 0; i < part->height; i++) yk_text_puts(&whole->lines[above + i], yk_text_get(&part->lines[i]));
    whole->width = 0;
    fill_up(whole);
}

static void append_text(YkPrinting *printing, Box *whole, const char *text)
{
    Box box = new_box(printing, 1);
    if (box.height == 0) return;
    yk_text_puts(&box.lines[0], text);
    append_box(printing, whole, &box);
    free_box(&box);
}

static void put_factor(YkPrinting *printing, const YkPoisson *a, YkText *text)
{
    bool is_sum = yk_print_is_sum(printing, a);
    if (is_sum) yk_text_puts(text, "(");
    yk_print_element(printing, a, YK_RING_BOOK, YK_RING_TEXTBOOK, text);
    if (is_sum) yk_text_puts(text, ")");
}

// A minus before a single product needs none.
static void put_dividend(YkPrinting *printing, const YkPoisson *a, YkText *text)
{
    YkText inner = {0};
    yk_print_element(printing, a, YK_RING_BOOK, YK_RING_TEXTBOOK, &inner);
    bool is_sum = yk_print_has_sum(yk_text_get(&inner) + (*yk_text_get(&inner) == '-'));
    yk_text_format(text, is_sum ? "(%s)" : "%s", yk_text_get(&inner));
    yk_text_free(&inner);
}

// A divisor of more than one symbol needs brackets.
static void put_divisor(YkPrinting *printing, const YkPoisson *a, YkText *text)
{
    YkText inner = {0};
    yk_print_element(printing, a, YK_RING_BOOK, YK_RING_TEXTBOOK, &inner);
    bool is_plain = yk_print_is_one_factor(yk_text_get(&inner));
    yk_text_format(text, is_plain ? "%s" : "(%s)", yk_text_get(&inner));
    yk_text_free(&inner);
}

static void put_name(const YkPagePiece *piece, YkText *text)
{
    yk_text_puts(text, piece->text);
    if (piece->sub) yk_text_format(text, "_%s", piece->sub);
    if (piece->super) yk_text_format(text, "^{%s}", piece->super);
}

static void put_piece(YkPrinting *printing, const YkPagePiece *piece, const YkPagePiece *before, YkText *text)
{
    bool is_spaced = before && !(piece->kind == YK_PIECE_SIGN && (*piece->text == ',' || *piece->text == ')')) &&
                     !(before->kind == YK_PIECE_SIGN && *before->text == '(');
    if (before && before->kind == YK_PIECE_QUOTIENT && piece->kind == YK_PIECE_ELEMENT) yk_text_puts(text, " *");
    if (is_spaced) yk_text_puts(text, " ");
    switch (piece->kind) {
    case YK_PIECE_ELEMENT:
        if (piece->is_factor)
            put_factor(printing, piece->over, text);
        else
            yk_print_element(printing, piece->over, YK_RING_BOOK, piece->style, text);
        break;
    case YK_PIECE_QUOTIENT:
        put_dividend(printing, piece->over, text);
        yk_text_puts(text, " / ");
        put_divisor(printing, piece->under, text);
        break;
    case YK_PIECE_VECTOR:
        put_name(piece, text);
        break;
    case YK_PIECE_SIGN:
    case YK_PIECE_WORDS:
        yk_text_puts(text, piece->text);
        break;
    case YK_PIECE_MATRIX:
        break;
    }
}

// --- Matrices

static YkText *write_entries(YkPrinting *printing, const YkShownMatrix *matrix, bool numbers)
{
    YkText *cells = calloc(matrix->rows * matrix->columns + 1, sizeof *cells);
    if (!cells) {
        printing->failed = true;
        return NULL;
    }
    for (size_t k = 0; k < matrix->rows * matrix->columns; k++) {
        if (numbers)
            yk_print_number(&cells[k], yk_print_entry(printing, matrix->entries[k]));
        else
            yk_print_element(printing, matrix->entries[k], YK_RING_BOOK, YK_RING_TEXTBOOK, &cells[k]);
    }
    return cells;
}

static void free_entries(const YkShownMatrix *matrix, YkText *cells)
{
    for (size_t k = 0; cells && k < matrix->rows * matrix->columns; k++) yk_text_free(&cells[k]);
    free(cells);
}

static size_t column_width(const YkShownMatrix *matrix, const YkText *cells, size_t column)
{
    size_t width = 1;
    for (size_t i = 0; i < matrix->rows; i++)
        if (cells[i * matrix->columns + column].length > width) width = cells[i * matrix->columns + column].length;
    return width;
}

static void put_cell(YkText *line, const YkText *cell, size_t width)
{
    size_t free_space = width - cell->length;
    yk_text_repeat(line, ' ', free_space / 2);
    yk_text_puts(line, yk_text_get(cell));
    yk_text_repeat(line, ' ', free_space - free_space / 2);
}

// Rows with cuts between blocks as lines of dashes.
static Box matrix_box(YkPrinting *printing, const YkShownMatrix *matrix, bool numbers)
{
    size_t height = matrix->rows, at = 0;
    for (size_t i = 0; i + 1 < matrix->rows; i++) height += matrix->row_cut[i];
    YkText *cells = write_entries(printing, matrix, numbers);
    Box box = new_box(printing, cells ? height : 0);
    if (box.height == 0) {
        free_entries(matrix, cells);
        return box;
    }
    for (size_t i = 0; i < matrix->rows; i++) {
        bool is_cut = matrix->row_cut[i] && i + 1 < matrix->rows;
        YkText *line = &box.lines[at++], *dashes = is_cut ? &box.lines[at++] : NULL;
        yk_text_puts(line, "[ ");
        if (dashes) yk_text_puts(dashes, "[ ");
        for (size_t k = 0; k < matrix->columns; k++) {
            size_t width = column_width(matrix, cells, k);
            bool is_last = k + 1 == matrix->columns;
            put_cell(line, &cells[i * matrix->columns + k], width);
            yk_text_puts(line, is_last ? " ]" : matrix->column_cut[k] ? " | " : "  ");
            if (!dashes) continue;
            yk_text_repeat(dashes, '-', width);
            yk_text_puts(dashes, is_last ? " ]" : matrix->column_cut[k] ? "-+-" : "--");
        }
    }
    free_entries(matrix, cells);
    fill_up(&box);
    return box;
}

static void put_matrix_names(YkPrinting *printing, const YkShownMatrix *matrix)
{
    if (matrix->columns == 0 || matrix->column_symbols[0] < 0) return;
    yk_text_puts(printing->text, "      columns:");
    for (size_t k = 0; k < matrix->columns; k++)
        yk_text_format(printing->text, "%s %s%s", k ? "," : "",
                       yk_ring_symbol_name(printing->ring, matrix->column_symbols[k]),
                       k + 1 < matrix->columns && matrix->column_cut[k] ? " |" : "");
    yk_text_puts(printing->text, "\n      rows:");
    for (size_t i = 0; i < matrix->rows; i++)
        yk_text_format(printing->text, "%s %s%s", i ? "," : "", matrix->row_labels[i] ? matrix->row_labels[i] : "",
                       i + 1 < matrix->rows && matrix->row_cut[i] ? " |" : "");
    yk_text_puts(printing->text, "\n");
}

// --- Lines

static void put_value(YkPrinting *printing, const YkLine *line, Box *whole)
{
    YkVec value;
    YkText text = {0};
    const YkShownMatrix *matrix = yk_print_only_matrix(line);
    if (printing->values && matrix) {
        Box box = matrix_box(printing, matrix, true);
        append_text(printing, whole, " = ");
        if (box.height > 0) append_box(printing, whole, &box);
        free_box(&box);
    } else if (yk_print_value(printing, line, &value)) {
        yk_text_puts(&text, " = ");
        if (line->is_vector) yk_text_puts(&text, "[");
        yk_print_number(&text, value.x);
        if (line->is_vector) {
            yk_text_puts(&text, ", ");
            yk_print_number(&text, value.y);
            yk_text_puts(&text, "]");
        }
        append_text(printing, whole, yk_text_get(&text));
        yk_text_free(&text);
    }
}

static void put_formula(YkPrinting *printing, const YkLine *line)
{
    Box whole = new_box(printing, 1);
    const YkPagePiece *before = NULL;
    if (whole.height == 0) return;
    yk_text_puts(&whole.lines[0], "  ");
    if (line->text) yk_text_format(&whole.lines[0], "%s:  ", line->text);
    for (const YkPagePiece *piece = line->first; piece; before = piece, piece = piece->next) {
        if (piece->kind == YK_PIECE_MATRIX) {
            Box box = matrix_box(printing, piece->matrix, false);
            if (before) append_text(printing, &whole, " ");
            if (box.height > 0) append_box(printing, &whole, &box);
            free_box(&box);
        } else {
            YkText text = {0};
            put_piece(printing, piece, before, &text);
            append_text(printing, &whole, yk_text_get(&text));
            yk_text_free(&text);
        }
    }
    put_value(printing, line, &whole);
    for (size_t i = 0; i < whole.height; i++) {
        const char *data = yk_text_get(&whole.lines[i]);
        size_t length = whole.lines[i].length;
        while (length > 0 && data[length - 1] == ' ') length--;
        yk_text_add(printing->text, data, length);
        yk_text_puts(printing->text, "\n");
    }
    free_box(&whole);
    const YkShownMatrix *matrix = yk_print_only_matrix(line);
    if (matrix) put_matrix_names(printing, matrix);
}

void yk_print_formula_text(YkPrinting *printing, const YkLine *line, YkText *text)
{
    const YkPagePiece *before = NULL;
    for (const YkPagePiece *piece = line->first; piece; before = piece, piece = piece->next) {
        put_piece(printing, piece, before, text);
        if (piece->kind != YK_PIECE_MATRIX) continue;
        const YkShownMatrix *matrix = piece->matrix;
        yk_text_puts(text, "[");
        for (size_t k = 0; k < matrix->rows * matrix->columns; k++) {
            if (k > 0) yk_text_puts(text, k % matrix->columns == 0 ? "; " : ", ");
            yk_print_element(printing, matrix->entries[k], YK_RING_BOOK, YK_RING_TEXTBOOK, text);
        }
        yk_text_puts(text, "]");
    }
}

static void put_heading(YkPrinting *printing, const YkLine *line, bool first)
{
    yk_text_format(printing->text, "%s%s\n", first ? "" : "\n", line->text);
    if (line->level > 1) return;
    yk_text_repeat(printing->text, '=', strlen(line->text));
    yk_text_puts(printing->text, "\n");
}

void yk_print_text(YkPrinting *printing, const YkPage *page)
{
    if (printing->title) yk_text_format(printing->text, "%s\n\n", printing->title);
    for (const YkLine *line = page->first; line && !printing->failed; line = line->next) {
        if (line->kind == YK_LINE_HEADING) put_heading(printing, line, line == page->first);
        if (line->kind == YK_LINE_WORDS) yk_text_format(printing->text, "  %s\n", line->text);
        if (line->kind == YK_LINE_FORMULA) put_formula(printing, line);
    }
}
