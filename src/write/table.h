// Tables for people: columns aligned, numbers by their decimal point, units in the head.
#ifndef WRITE_TABLE_H
#define WRITE_TABLE_H
#include "base/text.h"

typedef struct YkTable YkTable;

// Makes a table with this number of columns. Returns NULL when out of memory (the other calls then do nothing). A table
// that ran out of memory, or took a text that did, makes the text fail into which it is written.
YkTable *yk_table_new(size_t columns);
void yk_table_free(YkTable *table);
// Adds heads from the left: as many as there are columns, before the first cell. unit may be NULL.
void yk_table_head(YkTable *table, const char *name, const char *unit);
// Add cells, row by row from the left.
void yk_table_word(YkTable *table, const char *word);           // aligned left
void yk_table_number(YkTable *table, double value, int digits); // significant digits; "-" unless finite
// Writes head and rows, `indent` blanks before each line. Returns false when out of memory. Cost: linear in the cells.
bool yk_table_write(const YkTable *table, size_t indent, YkText *text);
size_t yk_table_rows(const YkTable *table); // complete ones, without the heads
bool yk_table_failed(const YkTable *table); // also if there is none
// Writes the table below an empty line and the line of its title, which may be NULL; writes nothing if it has no rows.
// Frees the table.
void yk_table_show(YkTable *table, const char *title, YkText *text);
// Writes an HTML table with a caption; the first column heads the rows. Returns false when out of memory.
bool yk_table_write_html(const YkTable *table, const char *caption, YkText *html);
// Returns how many columns of a terminal a text takes: code points, without combining ones.
size_t yk_text_columns(const char *text, size_t length);

#endif
