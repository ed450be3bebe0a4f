// A displayed formula on a page of a width: sums that are too long for a line break before their signs, matrices that
// are too wide become smaller.
#include "out/latex_display.h"
#include <string.h>

enum { LINE = 118, DEPTH_MAX = 64, COLUMNS_MAX = 64 }; // a line holds about so many letters

// --- How wide a formula is, about: in letters

static bool is_letter(char c)
{
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

// The length of a command's name at \, and how many letters it takes in print: \cos three, \theta one.
static size_t command(const char *at, double *width)
{
    static const char *const silent[] = {"left", "right", "mathbf", "mathit", "mathrm", "boldsymbol", "text", "tfrac",
                                         "frac", "dot",   "ddot",   "dddot",  "begin",  "end",        "hline"};
    size_t length = 1;
    while (is_letter(at[length])) length++;
    if (length == 1) length = 2; // \, \; \_
    *width = length > 2 ? 1.2 : 0.3;
    if (strncmp(at, "\\cos", 4) == 0 || strncmp(at, "\\sin", 4) == 0) *width = 3;
    for (size_t k = 0; k < sizeof silent / sizeof *silent; k++)
        if (strlen(silent[k]) == length - 1 && strncmp(at + 1, silent[k], length - 1) == 0) *width = 0;
    return length;
}

static double width_of(const char *text, size_t length)
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

// --- Breaking sums

typedef struct Walk {
    char open[DEPTH_MAX]; // brackets around: { a group or \left, f of a function, ( of a sum
    size_t depth;
} Walk;

// One step; returns how far.
static size_t step(Walk *walk, const char *text, size_t at)
{
    const char *c = text + at;
    size_t room = walk->depth < DEPTH_MAX - 1;
    if (strncmp(c, "\\left", 5) == 0 && !is_letter(c[5])) {
        if (room) walk->open[walk->depth++] = '{';
        return 6;
    }
    if (strncmp(c, "\\right", 6) == 0 && !is_letter(c[6])) {
        if (walk->depth > 0) walk->depth--;
        return 7;
    }
    if (*c == '{' && room) walk->open[walk->depth++] = '{';
    if (*c == '(' && room)
        walk->open[walk->depth++] =
            at >= 3 && (strncmp(c - 3, "cos", 3) == 0 || strncmp(c - 3, "sin", 3) == 0) ? 'f' : '(';
    if ((*c == '}' || *c == ')') && walk->depth > 0) walk->depth--;
    return 1;
}

static bool may_break(const Walk *walk, const char *c)
{
    if (c[0] != ' ' || !strchr("+-=", c[1]) || c[1] == '\0' || c[2] != ' ') return false;
    return walk->depth == 0 || (walk->depth == 1 && walk->open[0] == '(');
}

static void put_lines(const char *formula, YkText *text)
{
    Walk walk = {.depth = 0};
    size_t begin = 0, last = 0, at = 0, length = strlen(formula); // last: the last place for a break
    yk_text_puts(text, "\\begin{multline*}\n");
    while (at < length) {
        if (may_break(&walk, formula + at)) {
            if (last > begin && width_of(formula + begin, at - begin) > LINE) {
                yk_text_add(text, formula + begin, last - begin);
                yk_text_puts(text, " \\\\\n");
                begin = last + 1; // its blank
            }
            last = at;
        }
        at += step(&walk, formula, at);
    }
    if (last > begin && width_of(formula + begin, length - begin) > LINE) {
        yk_text_add(text, formula + begin, last - begin);
        yk_text_puts(text, " \\\\\n");
        begin = last + 1;
    }
    yk_text_add(text, formula + begin, length - begin);
    yk_text_puts(text, "\n\\end{multline*}\n");
}

// --- Matrices

// An array from behind its head to its end: as wide as its columns.
static double width_of_array(const char *from, const char *end)
{
    double widest[COLUMNS_MAX] = {0}, sum = 0;
    size_t column = 0;
    for (const char *c = from;; c++) {
        bool is_row = c[0] == '\\' && c[1] == '\\', is_end = c >= end;
        if (!is_end && !is_row && *c != '&') continue;
        double width = width_of(from, (size_t)(c - from)) + 2;
        if (width > widest[column]) widest[column] = width;
        column = is_row || column + 1 == COLUMNS_MAX ? 0 : column + 1;
        if (is_end) break;
        if (is_row) c++;
        from = c + 1;
    }
    for (size_t k = 0; k < COLUMNS_MAX; k++) sum += widest[k];
    return sum;
}

static double width_with_arrays(const char *formula, size_t length)
{
    double sum = 0;
    const char *from = formula, *stop = formula + length, *array;
    while ((array = strstr(from, "\\begin{array}")) != NULL && array < stop) {
        const char *end = strstr(array, "\\end{array}"), *head = strchr(array + 13, '}');
        if (!end || !head) break;
        sum += width_of(from, (size_t)(array - from)) + 2 + width_of_array(head + 1, end);
        from = end + 11;
    }
    return sum + width_of(from, (size_t)(stop - from));
}

// Behind a matrix a formula may break: the length of what comes before, or of all.
static size_t through_matrix(const char *formula)
{
    static const char end[] = "\\end{array}\\right]";
    const char *found = strstr(formula, end);
    return found ? (size_t)(found - formula) + sizeof end - 1 : strlen(formula);
}

static const char *size_for(double times)
{
    return times > 1.4 ? "\\tiny" : times > 1.2 ? "\\scriptsize" : times > 1 ? "\\footnotesize" : NULL;
}

// A x = b on two lines where one is too narrow: the first matrix, then the rest.
static void put_matrices(const char *formula, YkText *text)
{
    size_t length = strlen(formula), first = through_matrix(formula);
    double times = width_with_arrays(formula, length) / LINE;
    bool breaks = times > 1.2 && first < length;
    if (breaks) {
        double above = width_with_arrays(formula, first) / LINE;
        double below = width_with_arrays(formula + first, length - first) / LINE;
        times = above > below ? above : below;
    }
    const char *size = size_for(times);
    if (size) yk_text_format(text, "{%s\n", size);
    if (times > 1.2) yk_text_puts(text, "\\setlength{\\arraycolsep}{2pt}\n");
    yk_text_puts(text, breaks ? "\\begin{multline*}\n" : "\\[\n");
    yk_text_add(text, formula, first);
    if (breaks) yk_text_puts(text, " \\\\\n");
    yk_text_puts(text, formula + first);
    yk_text_puts(text, breaks ? "\n\\end{multline*}\n" : "\n\\]\n");
    if (size) yk_text_puts(text, "}\n");
}

void yk_latex_display(YkText *text, const char *formula)
{
    if (strstr(formula, "\\begin{array}"))
        put_matrices(formula, text);
    else if (width_of(formula, strlen(formula)) > LINE)
        put_lines(formula, text);
    else
        yk_text_format(text, "\\[\n%s\n\\]\n", formula);
}
