// Writes CSV (RFC 4180, with plain newlines): a head line and rows of numbers that read back to the same double.
#ifndef WRITE_CSV_H
#define WRITE_CSV_H
#include "base/text.h"

typedef struct YkCsv {
    YkText *text;
    bool has_fields; // in the present row
} YkCsv;

void yk_csv_name(YkCsv *csv, const char *name); // quoted only where it must be
void yk_csv_number(YkCsv *csv, double value);   // shortest that reads back; empty unless finite
void yk_csv_row(YkCsv *csv);                    // ends the row

#endif
