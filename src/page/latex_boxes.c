// Replaces wide entries of matrices and long sides of quotients by numbers in boxes.
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "base/memory.h"
#include "page/latex_display.h"

enum { QUOTIENT = YK_LATEX_LINE - 12 }; // a side of a quotient beside the rest of its equation

void yk_latex_boxes_free(YkLatexBoxes *boxes)
{
    free(boxes->items);
    yk_text_free(&boxes->formula);
    *boxes = (YkLatexBoxes){0};
}

// Returns the number of a part, from 1; 0 when out of memory.
static size_t number_of(YkLatexBoxes *boxes, const char *text, size_t length)
{
    for (size_t k = 0; k < boxes->count; k++)
        if (boxes->items[k].length == length && strncmp(boxes->items[k].text, text, length) == 0) return k + 1;
    if (!YK_ROOM(boxes->items, boxes->count, boxes->capacity)) return 0;
    boxes->items[boxes->count].text = text;
    boxes->items[boxes->count].length = length;
    return ++boxes->count;
}

static void put_part(YkLatexBoxes *boxes, const char *text, size_t length, double widest)
{
    while (length > 0 && *text == ' ') {
        yk_text_puts(&boxes->formula, " ");
        text++, length--;
    }
    size_t own = length;
    while (own > 0 && text[own - 1] == ' ') own--;
    if (!(yk_latex_width(text, own) > widest)) {
        yk_text_add(&boxes->formula, text, length);
        return;
    }
    size_t number = number_of(boxes, text, own);
    boxes->formula.failed |= number == 0;
    yk_text_format(&boxes->formula, "\\boxed{%z}", number);
    yk_text_add(&boxes->formula, text + own, length - own);
}

// Returns the place after the brace that closes the one at `at`.
static const char *behind_brace(const char *at)
{
    int depth = 0;
    for (; *at; at++) {
        depth += (*at == '{') - (*at == '}');
        if (depth == 0) return at + 1;
    }
    return at;
}

// Copies the entries from after the array's head to its end.
static const char *put_array(YkLatexBoxes *boxes, const char *from, double widest)
{
    const char *end = strstr(from, "\\end{array}");
    if (!end) end = from + strlen(from);
    if (yk_latex_width_of_array(from, end) < 0.6 * YK_LATEX_LINE) widest = INFINITY; // not this one
    for (const char *c = from; c < end; c++) {
        bool is_row = c[0] == '\\' && c[1] == '\\';
        if (!is_row && *c != '&') continue;
        put_part(boxes, from, (size_t)(c - from), widest);
        size_t sign = is_row ? 2 : 1;
        if (strncmp(c + sign, " \\hline", 7) == 0) sign += 7;
        yk_text_add(&boxes->formula, c, sign);
        c += sign - 1;
        from = c + 1;
    }
    put_part(boxes, from, (size_t)(end - from), widest);
    return end;
}

// Copies both sides of a \frac.
static const char *put_quotient(YkLatexBoxes *boxes, const char *at)
{
    for (int side = 0; side < 2 && *at == '{'; side++) {
        const char *end = behind_brace(at);
        yk_text_puts(&boxes->formula, "{");
        put_part(boxes, at + 1, (size_t)(end - at) - 2, QUOTIENT);
        yk_text_puts(&boxes->formula, "}");
        at = end;
    }
    return at;
}

bool yk_latex_box(YkLatexBoxes *boxes, const char *formula, double widest)
{
    static const char array[] = "\\begin{array}", quotient[] = "\\frac{";
    yk_text_clear(&boxes->formula);
    boxes->count = 0;
    for (const char *at = formula; *at;) {
        bool is_array = strncmp(at, array, sizeof array - 1) == 0;
        bool is_quotient = strncmp(at, quotient, sizeof quotient - 1) == 0;
        size_t head = is_array      ? (size_t)(behind_brace(at + sizeof array - 1) - at)
                      : is_quotient ? sizeof quotient - 2
                                    : 1;
        yk_text_add(&boxes->formula, at, head);
        at += head;
        if (is_array) at = put_array(boxes, at, widest);
        if (is_quotient) at = put_quotient(boxes, at);
    }
    return !boxes->formula.failed;
}
