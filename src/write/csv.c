// Writes CSV.
#include "write/csv.h"
#include <math.h>
#include <string.h>
#include "base/number.h"

static void separate(YkCsv *csv)
{
    if (csv->has_fields) yk_text_add(csv->text, ",", 1);
    csv->has_fields = true;
}

void yk_csv_name(YkCsv *csv, const char *name)
{
    separate(csv);
    if (name == yk_text_lost) yk_text_fail(csv->text);
    if (!strpbrk(name, ",\"\r\n")) {
        yk_text_puts(csv->text, name);
        return;
    }
    yk_text_add(csv->text, "\"", 1);
    for (const char *c = name; *c; c++) yk_text_add(csv->text, *c == '"' ? "\"\"" : c, *c == '"' ? 2 : 1);
    yk_text_add(csv->text, "\"", 1);
}

void yk_csv_number(YkCsv *csv, double value)
{
    char digits[YK_NUMBER_SIZE];
    separate(csv);
    if (isfinite(value)) yk_text_add(csv->text, digits, yk_number_write(value, digits));
}

void yk_csv_row(YkCsv *csv)
{
    yk_text_add(csv->text, "\n", 1);
    csv->has_fields = false;
}
