// Formatting without stdio: a handful of conversions, the same in every locale.
#include "base/text.h"
#include <string.h>
#include "base/escape.h"
#include "base/number.h"

static void add_unsigned(YkText *text, size_t value)
{
    char digits[24], *first = digits + sizeof digits;
    do *--first = (char)('0' + value % 10);
    while ((value /= 10) != 0);
    yk_text_add(text, first, (size_t)(digits + sizeof digits - first));
}

static void add_int(YkText *text, int value)
{
    if (value < 0) yk_text_add(text, "-", 1);
    add_unsigned(text, value < 0 ? (size_t)0 - (size_t)value : (size_t)value);
}

static void add_double(YkText *text, double value, bool shortest)
{
    char number[YK_NUMBER_SIZE];
    size_t length = shortest ? yk_number_write(value, number) : yk_number_write_digits(value, 6, number);
    yk_text_add(text, number, length);
}

static const char *or_empty(const char *string)
{
    return string ? string : "";
}

void yk_text_vformat(YkText *text, const char *format, va_list arguments)
{
    for (const char *percent; (percent = strchr(format, '%')) != NULL; format = percent + 2) {
        yk_text_add(text, format, (size_t)(percent - format));
        switch (percent[1]) {
        case 's':
            yk_text_puts(text, or_empty(va_arg(arguments, const char *)));
            break;
        case 'q':
            yk_escape_quoted(text, or_empty(va_arg(arguments, const char *)));
            break;
        case 'c':
            yk_text_repeat(text, (char)va_arg(arguments, int), 1);
            break;
        case 'd':
            add_int(text, va_arg(arguments, int));
            break;
        case 'u':
            add_unsigned(text, va_arg(arguments, unsigned));
            break;
        case 'z':
            add_unsigned(text, va_arg(arguments, size_t));
            break;
        case 'g':
            add_double(text, va_arg(arguments, double), true);
            break;
        case 'e':
            add_double(text, va_arg(arguments, double), false);
            break;
        case '%':
            yk_text_add(text, "%", 1);
            break;
        case '\0':
            yk_text_add(text, "%", 1);
            return;
        default:
            yk_text_add(text, percent, 2); // an unknown conversion is our own mistake: show it and take no argument
        }
    }
    yk_text_puts(text, format);
}

void yk_text_format(YkText *text, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    yk_text_vformat(text, format, arguments);
    va_end(arguments);
}
