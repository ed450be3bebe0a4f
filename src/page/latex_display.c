// Displays a formula on a page of limited width. Sums that are too long for a line break before their signs; matrices
// that are too wide become smaller. If that is not enough, their widest entries, like long numerators, are written
// below under a number (latex_boxes.c).
#include "page/latex_display.h"
#include <math.h>
#include <string.h>

enum { DEPTH_MAX = 64 };

// --- Breaking sums

typedef struct Walk {
    char open[DEPTH_MAX]; // brackets around it: { a group or \left, f of a function, ( of a sum
    size_t depth;
} Walk;

// Takes one step; returns its length.
static size_t step(Walk *walk, const char *text, size_t at)
{
    const char *c = text + at;
    size_t room = walk->depth < DEPTH_MAX - 1;
    if (strncmp(c, "\\left", 5) == 0 && !yk_is_letter(c[5])) {
        if (room) walk->open[walk->depth++] = '{';
        return 6;
    }
    if (strncmp(c, "\\right", 6) == 0 && !yk_is_letter(c[6])) {
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

// The places at which a sum may break: outside brackets and at their first depth, or further inside.
typedef enum Break { BREAK_NONE, BREAK_DEEP, BREAK_SHALLOW } Break;

static Break break_at(const Walk *walk, const char *c)
{
    if (c[0] != ' ' || !strchr("+-=", c[1]) || c[1] == '\0' || c[2] != ' ') return BREAK_NONE;
    for (size_t k = 0; k < walk->depth; k++)
        if (walk->open[k] != '(') return BREAK_NONE;
    return walk->depth <= 1 ? BREAK_SHALLOW : BREAK_DEEP;
}

// A formula as it is broken into lines: the line begun, and the last places where it may break; in nested sums only
// if nothing else helps.
typedef struct Lines {
    const char *formula;
    size_t begin, shallow, deep;
    YkText *text;
} Lines;

// Ends lines until the text up to `at` fits on one, or cannot break.
static void fill_lines(Lines *lines, size_t at)
{
    while (yk_latex_width(lines->formula + lines->begin, at - lines->begin) > YK_LATEX_LINE) {
        size_t cut = lines->shallow > lines->begin ? lines->shallow : lines->deep;
        if (cut <= lines->begin) return;
        yk_text_add(lines->text, lines->formula + lines->begin, cut - lines->begin);
        yk_text_puts(lines->text, " \\\\\n");
        lines->begin = cut + 1; // its blank
    }
}

static void put_lines(const char *formula, YkText *text)
{
    Walk walk = {.depth = 0};
    Lines lines = {.formula = formula, .text = text};
    size_t at = 0, length = strlen(formula);
    yk_text_puts(text, "\\begin{multline*}\n");
    while (at < length) {
        Break here = break_at(&walk, formula + at);
        if (here != BREAK_NONE) {
            fill_lines(&lines, at);
            lines.deep = at;
            if (here == BREAK_SHALLOW) lines.shallow = at;
        }
        at += step(&walk, formula, at);
    }
    fill_lines(&lines, length);
    yk_text_add(text, formula + lines.begin, length - lines.begin);
    yk_text_puts(text, "\n\\end{multline*}\n");
}

// --- Matrices

// A formula may break after a matrix: returns the length before it, or the whole length.
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

// Returns the ratio to a line's width: A x = b on one line or, if it is too wide, two: the first matrix, then the rest.
static double times_of(const char *formula, bool *breaks)
{
    size_t length = strlen(formula), first = through_matrix(formula);
    double times = yk_latex_width_with_arrays(formula, length) / YK_LATEX_LINE;
    *breaks = times > 1.2 && first < length;
    if (!*breaks) return times;
    double above = yk_latex_width_with_arrays(formula, first) / YK_LATEX_LINE;
    double below = yk_latex_width_with_arrays(formula + first, length - first) / YK_LATEX_LINE;
    return above > below ? above : below;
}

static void put_matrices(const char *formula, YkText *text)
{
    size_t first = through_matrix(formula);
    bool breaks;
    double times = times_of(formula, &breaks);
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

static void put_display(const char *formula, YkText *text)
{
    if (strstr(formula, "\\begin{array}"))
        put_matrices(formula, text);
    else if (yk_latex_width(formula, strlen(formula)) > YK_LATEX_LINE)
        put_lines(formula, text);
    else
        yk_text_format(text, "\\[\n%s\n\\]\n", formula);
}

// --- Boxed parts, below under their numbers

// Returns whether it fits on the page, if necessary in small type.
static bool fits(const char *formula)
{
    bool breaks;
    return !strstr(formula, "\\begin{array}") || times_of(formula, &breaks) <= 1.4;
}

// Writes the meaning of each number: as many on a line as fit.
static void put_boxes(const YkLatexBoxes *boxes, YkText *text)
{
    YkText line = {0};
    double width = 0;
    for (size_t k = 0; k < boxes->count; k++) {
        const struct YkLatexPart *part = &boxes->items[k];
        double own = yk_latex_width(part->text, part->length) + 8;
        if (k > 0 && width + own > YK_LATEX_LINE) {
            put_display(yk_text_get(&line), text);
            yk_text_clear(&line);
            width = 0;
        }
        if (yk_text_has_some(&line)) yk_text_puts(&line, " ,\\quad ");
        yk_text_format(&line, "\\boxed{%z} = ", k + 1);
        yk_text_add(&line, part->text, part->length);
        width += own;
    }
    if (yk_text_has_some(&line)) put_display(yk_text_get(&line), text);
    yk_text_free(&line);
}

void yk_latex_display(YkText *text, const char *formula)
{
    static const double widest[] = {60, 40, 30, 24, 20, 17, 14, 12, 10, 8};
    YkLatexBoxes boxes = {0};
    size_t k = 0;
    bool good = yk_latex_box(&boxes, formula, INFINITY); // quotients that are too wide alone
    while (good && !fits(yk_text_get(&boxes.formula)) && k < sizeof widest / sizeof *widest)
        good = yk_latex_box(&boxes, formula, widest[k++]);
    text->failed |= !good;
    put_display(yk_text_get(&boxes.formula), text);
    put_boxes(&boxes, text);
    yk_latex_boxes_free(&boxes);
}
