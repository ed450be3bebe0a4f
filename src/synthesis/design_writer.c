// Writes lengths and angles into the model file of a design.
#include "synthesis/design_writer.h"
#include "base/number.h"

static void write_number(const YkDesignWriter *w, double value)
{
    char digits[YK_NUMBER_SIZE];
    size_t length = yk_number_write_digits(value == 0 ? 0 : value, w->digits, digits);
    yk_text_add(w->text, digits, length);
}

void yk_write_length(const YkDesignWriter *w, const char *before, double value)
{
    yk_text_puts(w->text, before);
    write_number(w, value / w->unit);
}

void yk_write_angle(const YkDesignWriter *w, const char *before, double value, const char *after)
{
    yk_text_puts(w->text, before);
    write_number(w, value * 180 / YK_PI);
    yk_text_puts(w->text, after);
}
