// Formulas in display on a page of A4 across, text 267 mm wide.
#ifndef OUT_LATEX_DISPLAY_H
#define OUT_LATEX_DISPLAY_H
#include "base/text.h"

// Adds a formula (LaTeX without dollars) as \[ \], or where it is too long for a line as a multline* that breaks before
// signs; matrices that are too wide are set smaller. An estimate: what cannot break may still stand out.
void yk_latex_display(YkText *text, const char *formula);

#endif
