// Prints HTML to PDF by a browser without a window.
#ifndef WRITE_PDF_H
#define WRITE_PDF_H
#include <stdbool.h>
#include <yoke/problem.h>
#include "base/text.h"

// Prints a whole HTML document with Chromium (or a browser of its kind) and adds the PDF to `output`. Returns false
// with a problem added (E0710 if there is no such browser on the PATH, E0711 if it fails).
bool yk_print_pdf(const char *html, YkText *output, YkProblems *problems);

#endif
