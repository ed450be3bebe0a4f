// Displays formulas on a landscape A4 page, text 267 mm wide.
#ifndef PAGE_LATEX_DISPLAY_H
#define PAGE_LATEX_DISPLAY_H
#include "base/letters.h"
#include "base/text.h"

// Adds a formula (LaTeX without dollars) as \[ \] or, if it is too long for a line, as a multline* that breaks before
// signs. Matrices that are too wide are set smaller; if small type is not enough, the widest entries, and long
// numerators and denominators, become numbers in boxes, with their meaning in lines below. Widths are estimates:
// something that cannot break may still exceed the line.
void yk_latex_display(YkText *text, const char *formula);

// --- latex_width.c: widths in letters, approximate
enum { YK_LATEX_LINE = 118 }; // characters that fit in a line, roughly
double yk_latex_width(const char *formula, size_t length);
double yk_latex_width_of_array(const char *from, const char *end); // from behind its head
double yk_latex_width_with_arrays(const char *formula, size_t length);

// --- latex_boxes.c
typedef struct YkLatexBoxes {
    YkText formula; // with \boxed{1}, ... for what is too wide
    struct YkLatexPart {
        const char *text; // of the whole formula
        size_t length;
    } * items; // what they stand for; equal parts share a number
    size_t count, capacity;
} YkLatexBoxes;
// Boxes the entries of matrices that are wider than `widest`, and sides of quotients that fill a line. A second call
// starts afresh. Returns false when out of memory.
bool yk_latex_box(YkLatexBoxes *boxes, const char *formula, double widest);
void yk_latex_boxes_free(YkLatexBoxes *boxes);

#endif
