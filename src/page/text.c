// Prints pages as plain text: a formula is a row of parts - words and elements, or a matrix - each a few lines high.
#include <stdlib.h>
#include <string.h>
#include "page/print.h"

// A line of a part: a piece of the sheet's text.
typedef struct Slice {
    size_t start, length;
} Slice;

// Lines of one width, whose middle is in line with the middles of other parts.
typedef struct Part {
    size_t first, height, width; // first of its lines
} Part;

// One formula before it is laid out in rows; its memory is reused for the next.
typedef struct YkTextSheet {
    YkPrinting *printing;
    YkText text, cells; // of the lines, and of a matrix's entries
    Slice *lines, *entries;
    size_t line_count, line_capacity, entry_count, entry_capacity;
    size_t *widths, width_count, width_capacity; // of a matrix's columns
    Part *parts;
    size_t part_count, part_capacity;
    bool has_lines; // something was printed
} YkTextSheet;
typedef YkTextSheet Sheet;

static void clear_sheet(Sheet *sheet)
{
    yk_text_clear(&sheet->text);
    sheet->line_count = sheet->part_count = 0;
}

void yk_print_text_end(YkPrinting *printing)
{
    Sheet *sheet = printing->sheet;
    printing->sheet = NULL;
    if (!sheet) return;
    printing->failed |= sheet->text.failed || sheet->cells.failed;
    yk_text_free(&sheet->text);
    yk_text_free(&sheet->cells);
    free(sheet->lines);
    free(sheet->entries);
    free(sheet->widths);
    free(sheet->parts);
    free(sheet);
}

// Ends a line of the last part, which began at `start`.
static void end_line(Sheet *sheet, size_t start)
{
    if (!YK_ROOM(sheet->lines, sheet->line_count, sheet->line_capacity)) {
        sheet->printing->failed = true;
        return;
    }
    Part *part = &sheet->parts[sheet->part_count - 1];
    Slice line = {start, sheet->text.length - start};
    sheet->lines[sheet->line_count++] = line;
    part->height++;
    if (line.length > part->width) part->width = line.length;
}

static bool add_part(Sheet *sheet)
{
    if (!YK_ROOM(sheet->parts, sheet->part_count, sheet->part_capacity)) return !(sheet->printing->failed = true);
    sheet->parts[sheet->part_count++] = (Part){.first = sheet->line_count};
    return true;
}

// Makes a part of one line of everything written since `start`.
static void add_line(Sheet *sheet, size_t start)
{
    if (sheet->text.length > start && add_part(sheet)) end_line(sheet, start);
}

static size_t middle(size_t height)
{
    return height > 0 ? (height - 1) / 2 : 0;
}

// Writes all parts side by side, without blanks at the ends of lines.
static void put_rows(const Sheet *sheet)
{
    YkText *out = sheet->printing->text;
    size_t height = 1;
    for (size_t k = 0; k < sheet->part_count; k++)
        if (sheet->parts[k].height > height) height = sheet->parts[k].height;
    for (size_t row = 0; row < height && !sheet->printing->failed; row++) {
        size_t blanks = 0;
        for (size_t k = 0; k < sheet->part_count; k++) {
            const Part *part = &sheet->parts[k];
            size_t above = middle(height) - middle(part->height);
            const Slice none = {0, 0};
            Slice line = row < above || row - above >= part->height ? none : sheet->lines[part->first + row - above];
            const char *data = yk_text_get(&sheet->text) + line.start;
            size_t length = line.length;
            while (length > 0 && data[length - 1] == ' ') length--;
            if (length > 0) {
                yk_text_repeat(out, ' ', blanks);
                yk_text_add(out, data, length);
                blanks = 0;
            }
            blanks += part->width - length;
        }
        yk_text_add(out, "\n", 1);
    }
}

// --- Matrices

static void write_entries(Sheet *sheet, const YkShownMatrix *matrix, bool numbers)
{
    YkPrinting *printing = sheet->printing;
    yk_text_clear(&sheet->cells);
    sheet->entry_count = 0;
    for (size_t k = 0; k < matrix->rows * matrix->columns; k++) {
        size_t start = sheet->cells.length;
        const YkRingView entry = yk_shown_entry(matrix, k);
        if (numbers)
            yk_print_number(&sheet->cells, yk_print_entry(printing, &entry));
        else
            yk_print_view(printing, &entry, YK_RING_BOOK, YK_RING_TEXTBOOK, &sheet->cells);
        if (!YK_ROOM(sheet->entries, sheet->entry_count, sheet->entry_capacity)) {
            printing->failed = true;
            return;
        }
        sheet->entries[sheet->entry_count++] = (Slice){start, sheet->cells.length - start};
    }
}

static void add_width(Sheet *sheet, const YkShownMatrix *matrix, size_t column)
{
    size_t width = 1;
    for (size_t i = column; i < sheet->entry_count; i += matrix->columns)
        if (sheet->entries[i].length > width) width = sheet->entries[i].length;
    if (YK_ROOM(sheet->widths, sheet->width_count, sheet->width_capacity))
        sheet->widths[sheet->width_count++] = width;
    else
        sheet->printing->failed = true;
}

static void put_cell(Sheet *sheet, const Slice *cell, size_t width)
{
    size_t free_space = width - cell->length;
    yk_text_repeat(&sheet->text, ' ', free_space / 2);
    yk_text_add(&sheet->text, yk_text_get(&sheet->cells) + cell->start, cell->length);
    yk_text_repeat(&sheet->text, ' ', free_space - free_space / 2);
}

// Writes a row of entries, or of dashes below it.
static void put_row(Sheet *sheet, const YkShownMatrix *matrix, size_t row, bool dashes)
{
    const size_t *widths = sheet->widths;
    YkText *text = &sheet->text;
    size_t start = text->length;
    yk_text_puts(text, "[ ");
    for (size_t k = 0; k < matrix->columns; k++) {
        bool is_last = k + 1 == matrix->columns, is_cut = matrix->column_cut[k];
        if (dashes)
            yk_text_repeat(text, '-', widths[k]);
        else
            put_cell(sheet, &sheet->entries[row * matrix->columns + k], widths[k]);
        yk_text_puts(text, is_last ? " ]" : dashes ? is_cut ? "-+-" : "--" : is_cut ? " | " : "  ");
    }
    end_line(sheet, start);
}

// Adds rows, with cuts between blocks as lines of dashes.
static void add_matrix(Sheet *sheet, const YkShownMatrix *matrix, bool numbers)
{
    write_entries(sheet, matrix, numbers);
    sheet->width_count = 0;
    for (size_t k = 0; k < matrix->columns && !sheet->printing->failed; k++) add_width(sheet, matrix, k);
    if (sheet->printing->failed || !add_part(sheet)) return;
    for (size_t i = 0; i < matrix->rows; i++) {
        put_row(sheet, matrix, i, false);
        if (matrix->row_cut[i] && i + 1 < matrix->rows) put_row(sheet, matrix, i, true);
    }
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

static void put_remark(const YkLine *line, YkText *text)
{
    yk_text_add(text, "  ", 2);
    if (!line->text) return;
    yk_text_puts(text, line->text);
    yk_text_add(text, ":  ", 3);
}

static void put_value(const YkPrinting *printing, const YkLine *line, YkText *text)
{
    YkVec value;
    if (!yk_print_value(printing, line, &value)) return;
    yk_text_puts(text, line->is_vector ? " = [" : " = ");
    yk_print_number(text, value.x);
    if (!line->is_vector) return;
    yk_text_puts(text, ", ");
    yk_print_number(text, value.y);
    yk_text_puts(text, "]");
}

static void add_value(Sheet *sheet, const YkLine *line, const YkShownMatrix *matrix)
{
    YkText *text = &sheet->text;
    size_t start = text->length;
    if (sheet->printing->values && matrix) {
        yk_text_puts(text, " = ");
        add_line(sheet, start);
        add_matrix(sheet, matrix, true);
    } else {
        put_value(sheet->printing, line, text);
        add_line(sheet, start);
    }
}

// Writes a formula with matrices side by side, with the pieces between them.
static void put_tall(Sheet *sheet, const YkLine *line)
{
    YkText *text = &sheet->text;
    const YkPagePiece *before = NULL;
    clear_sheet(sheet);
    put_remark(line, text);
    size_t start = 0;
    for (const YkPagePiece *piece = line->first; piece; before = piece, piece = piece->next) {
        if (piece->kind != YK_PIECE_MATRIX) {
            yk_print_text_piece(sheet->printing, piece, before, text);
            continue;
        }
        if (before) yk_text_puts(text, " ");
        add_line(sheet, start);
        add_matrix(sheet, piece->matrix, false);
        start = text->length;
    }
    add_line(sheet, start);
    const YkShownMatrix *matrix = yk_print_only_matrix(line);
    add_value(sheet, line, matrix);
    put_rows(sheet);
    if (matrix) put_matrix_names(sheet->printing, matrix);
}

// Writes a formula of one line, without blanks at its end.
static void put_low(YkPrinting *printing, const YkLine *line)
{
    YkText *out = printing->text;
    const YkPagePiece *before = NULL;
    put_remark(line, out);
    for (const YkPagePiece *piece = line->first; piece; before = piece, piece = piece->next)
        yk_print_text_piece(printing, piece, before, out);
    put_value(printing, line, out);
    while (out->length > 0 && out->data[out->length - 1] == ' ') out->length--;
    yk_text_add(out, "\n", 1);
}

static void put_formula(Sheet *sheet, const YkLine *line)
{
    const YkPagePiece *piece = line->first;
    while (piece && piece->kind != YK_PIECE_MATRIX) piece = piece->next;
    if (piece)
        put_tall(sheet, line);
    else
        put_low(sheet->printing, line);
}

static void put_words(YkText *text, const char *before, const char *words)
{
    yk_text_puts(text, before);
    yk_text_puts(text, words);
    yk_text_puts(text, "\n");
}

static void put_heading(YkPrinting *printing, const YkLine *line, bool first)
{
    put_words(printing->text, first ? "" : "\n", line->text);
    if (line->level > 1) return;
    yk_text_repeat(printing->text, '=', strlen(line->text));
    yk_text_puts(printing->text, "\n");
}

void yk_print_text_head(YkPrinting *printing)
{
    printing->sheet = calloc(1, sizeof *printing->sheet);
    if (!printing->sheet) {
        printing->failed = true;
        return;
    }
    printing->sheet->printing = printing;
    if (printing->title) yk_text_format(printing->text, "%s\n\n", printing->title);
}

void yk_print_text_part(YkPrinting *printing, const YkPage *part)
{
    Sheet *sheet = printing->sheet;
    for (const YkLine *line = part->first; line && !printing->failed; line = line->next) {
        if (line->kind == YK_LINE_HEADING) put_heading(printing, line, !sheet->has_lines);
        if (line->kind == YK_LINE_WORDS) put_words(printing->text, "  ", line->text);
        if (line->kind == YK_LINE_FORMULA) put_formula(sheet, line);
        sheet->has_lines = true;
    }
    printing->failed |= sheet->text.failed || sheet->cells.failed;
}
