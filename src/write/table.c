// Writes tables for people.
#include "write/table.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "base/escape.h"
#include "base/memory.h"
#include "base/number.h"

// All cells' texts are in one buffer, each followed by a NUL.
typedef struct Cell {
    size_t start; // in table->words
    bool is_number;
} Cell;

struct YkTable {
    size_t columns;
    Cell *cells; // heads first, then the rows
    size_t count, capacity;
    YkText words;
};

// Widths of a column: of words as a whole, of numbers before and from the decimal point on.
typedef struct Width {
    size_t word, left, right, total;
} Width;

YkTable *yk_table_new(size_t columns)
{
    YkTable *table = calloc(1, sizeof *table);
    if (table) table->columns = columns;
    return table;
}

void yk_table_free(YkTable *table)
{
    if (!table) return;
    yk_text_free(&table->words);
    free(table->cells);
    free(table);
}

static void add_cell(YkTable *table, const char *word, bool is_number)
{
    if (!table) return;
    if (!word || !YK_ROOM(table->cells, table->count, table->capacity)) {
        yk_text_fail(&table->words);
        return;
    }
    table->cells[table->count++] = (Cell){.start = table->words.length, .is_number = is_number};
    yk_text_add(&table->words, word, strlen(word) + 1);
}

void yk_table_head(YkTable *table, const char *name, const char *unit)
{
    YkText head = {0};
    yk_text_puts(&head, name);
    if (unit && *unit) yk_text_format(&head, " [%s]", unit);
    add_cell(table, yk_text_get(&head), false);
    yk_text_free(&head);
}

void yk_table_word(YkTable *table, const char *word)
{
    add_cell(table, word, false);
}

void yk_table_number(YkTable *table, double value, int digits)
{
    char text[YK_NUMBER_SIZE] = "-";
    if (isfinite(value)) yk_number_write_digits(value == 0 ? 0.0 : value, digits, text); // no "-0"
    add_cell(table, text, true);
}

size_t yk_text_columns(const char *text, size_t length)
{
    size_t columns = 0;
    for (size_t i = 0; i < length; i++) {
        unsigned char byte = (unsigned char)text[i];
        bool combines = byte == 0xcc || (byte == 0xcd && i + 1 < length && (unsigned char)text[i + 1] < 0xb0);
        columns += (byte & 0xc0) != 0x80 && !combines;
    }
    return columns;
}

static const char *word_of(const YkTable *table, const Cell *cell)
{
    return table->words.data + cell->start;
}

static size_t columns_of(const YkTable *table, const Cell *cell)
{
    const char *word = word_of(table, cell);
    return yk_text_columns(word, strlen(word));
}

// Returns where a number is aligned: at its point, its exponent, or its end; a dash takes the place of the last digit
// before the point.
static size_t left_part(const char *number)
{
    return strcspn(number, ".e");
}

static void widen(Width *width, const YkTable *table, const Cell *cell)
{
    if (cell->is_number) {
        const char *number = word_of(table, cell);
        size_t left = left_part(number), right = strlen(number) - left;
        if (left > width->left) width->left = left;
        if (right > width->right) width->right = right;
    } else if (columns_of(table, cell) > width->word) {
        width->word = columns_of(table, cell);
    }
}

static void measure(const YkTable *table, Width *widths)
{
    for (size_t i = 0; i < table->count; i++) widen(&widths[i % table->columns], table, &table->cells[i]);
    for (size_t c = 0; c < table->columns; c++) {
        size_t number = widths[c].left + widths[c].right;
        widths[c].total = number > widths[c].word ? number : widths[c].word;
    }
}

// Writes the blanks before the cell; the next cell fills what follows it, so that no line ends in blanks.
static size_t lead(const YkTable *table, const Cell *cell, const Width *width)
{
    if (cell->is_number)
        return width->total - width->left - width->right + width->left - left_part(word_of(table, cell));
    bool is_head = cell < table->cells + table->columns;
    return is_head && width->left > 0 ? width->total - columns_of(table, cell) : 0;
}

static void write_row(const YkTable *table, size_t first, const Width *widths, size_t indent, YkText *text)
{
    size_t pending = indent;
    for (size_t c = 0; c < table->columns && first + c < table->count; c++) {
        const Cell *cell = &table->cells[first + c];
        size_t before = lead(table, cell, &widths[c]), own = columns_of(table, cell);
        if (own > 0) {
            yk_text_repeat(text, ' ', pending + before);
            yk_text_puts(text, word_of(table, cell));
            pending = widths[c].total - before - own + 2;
        } else {
            pending += widths[c].total + 2;
        }
    }
    yk_text_puts(text, "\n");
}

bool yk_table_failed(const YkTable *table)
{
    return !table || table->words.failed;
}

bool yk_table_write(const YkTable *table, size_t indent, YkText *text)
{
    Width *widths = yk_table_failed(table) ? NULL : calloc(table->columns + 1, sizeof *widths);
    if (!widths) {
        yk_text_fail(text);
        return false;
    }
    measure(table, widths);
    for (size_t first = 0; first < table->count; first += table->columns) write_row(table, first, widths, indent, text);
    free(widths);
    return !text->failed;
}

size_t yk_table_rows(const YkTable *table)
{
    return table && table->count > table->columns ? table->count / table->columns - 1 : 0;
}

void yk_table_show(YkTable *table, const char *title, YkText *text)
{
    if (yk_table_failed(table) || yk_table_rows(table) > 0) {
        yk_text_puts(text, "\n");
        if (title) yk_text_format(text, "%s\n", title);
        yk_table_write(table, 2, text);
    }
    yk_table_free(table);
}

// A head without a unit and an empty cell are plain cells.
static void write_cell(const YkTable *table, size_t index, YkText *html)
{
    const Cell *cell = &table->cells[index];
    bool is_head = index < table->columns, is_first = index % table->columns == 0;
    const char *tag = (is_head || is_first) && *word_of(table, cell) ? "th" : "td";
    const char *scope = *tag == 't' && tag[1] == 'h' ? is_head ? " scope=\"col\"" : " scope=\"row\"" : "";
    bool is_number = table->cells[index].is_number;
    if (is_head && index + table->columns < table->count) is_number = table->cells[index + table->columns].is_number;
    yk_text_format(html, "<%s%s%s>", tag, scope, is_number ? " class=\"n\"" : "");
    yk_escape_xml(html, word_of(table, cell));
    yk_text_format(html, "</%s>", tag);
}

bool yk_table_write_html(const YkTable *table, const char *caption, YkText *html)
{
    if (yk_table_failed(table)) {
        yk_text_fail(html);
        return false;
    }
    yk_text_puts(html, "<table>\n<caption>");
    yk_escape_xml(html, caption);
    yk_text_puts(html, "</caption>\n");
    for (size_t first = 0; first < table->count; first += table->columns) {
        yk_text_puts(html, first == 0 ? "<thead><tr>" : "<tr>");
        for (size_t c = 0; c < table->columns && first + c < table->count; c++) write_cell(table, first + c, html);
        yk_text_puts(html, first == 0 ? "</tr></thead>\n<tbody>\n" : "</tr>\n");
    }
    yk_text_puts(html, "</tbody>\n</table>\n");
    return !html->failed;
}
