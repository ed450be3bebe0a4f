// Estimates how wide a formula is in print, in letters.
#include <string.h>
#include "page/latex_display.h"

enum { COLUMNS_MAX = 64 };

// Returns the length of a command's name at \, and its printed width in letters: three for \cos, one for \theta.
static size_t command(const char *at, double *width)
{
    static const char *const silent[] = {"left", "right", "mathbf", "mathit", "mathrm", "boldsymbol", "text", "tfrac",
                                         "frac", "dot",   "ddot",   "dddot",  "begin",  "end",        "hline"};
    size_t length = 1;
    while (yk_is_letter(at[length])) length++;
    if (length == 1) length = 2; // \, \; \_
    *width = length > 2 ? 1.2 : 0.3;
    if (strncmp(at, "\\cos", 4) == 0 || strncmp(at, "\\sin", 4) == 0) *width = 3;
    for (size_t k = 0; k < sizeof silent / sizeof *silent; k++)
        if (strlen(silent[k]) == length - 1 && strncmp(at + 1, silent[k], length - 1) == 0) *width = 0;
    return length;
}

double yk_latex_width(const char *text, size_t length)
{
    double sum = 0, one;
    for (size_t i = 0; i < length;) {
        if (text[i] == '\\') {
            i += command(text + i, &one);
            sum += one;
            continue;
        }
        bool is_sign = text[i] == '+' || text[i] == '=' || (text[i] == '-' && i > 0 && text[i - 1] == ' ');
        if (is_sign)
            sum += 2.4;
        else if (!strchr(" {}^_&", text[i]))
            sum += text[i] >= '0' && text[i] <= '9' ? 0.8 : 1;
        i++;
    }
    return sum;
}

// Returns the width of an array, from after its head to its end: that of its columns.
double yk_latex_width_of_array(const char *from, const char *end)
{
    double widest[COLUMNS_MAX] = {0}, sum = 0;
    size_t column = 0;
    for (const char *c = from;; c++) {
        bool is_row = c[0] == '\\' && c[1] == '\\', is_end = c >= end;
        if (!is_end && !is_row && *c != '&') continue;
        double width = yk_latex_width(from, (size_t)(c - from)) + 2;
        if (width > widest[column]) widest[column] = width;
        column = is_row || column + 1 == COLUMNS_MAX ? 0 : column + 1;
        if (is_end) break;
        if (is_row) c++;
        from = c + 1;
    }
    for (size_t k = 0; k < COLUMNS_MAX; k++) sum += widest[k];
    return sum;
}

double yk_latex_width_with_arrays(const char *formula, size_t length)
{
    double sum = 0;
    const char *from = formula, *stop = formula + length, *array;
    while ((array = strstr(from, "\\begin{array}")) != NULL && array < stop) {
        const char *end = strstr(array, "\\end{array}"), *head = strchr(array + 13, '}');
        if (!end || !head) break;
        sum += yk_latex_width(from, (size_t)(array - from)) + 2 + yk_latex_width_of_array(head + 1, end);
        from = end + 11;
    }
    return sum + yk_latex_width(from, (size_t)(stop - from));
}
