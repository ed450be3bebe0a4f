// Shared by pictures of polygons: the page, arrows, bars of a scale, lines of words.
#ifndef PICTURE_POLYGON_SHEET_H
#define PICTURE_POLYGON_SHEET_H
#include "base/text.h"
#include "base/vec.h"

enum { YK_SHEET_WIDTH = 800 };

// Begins a document of this height, with its title; `attributes` go into its root.
void yk_sheet_open(YkText *svg, double height, const char *attributes, const char *model, const char *title);
// Draws a vector with a head, in the class and colour given; none if it is too short to be seen.
void yk_sheet_arrow(YkText *svg, YkVec from, YkVec to, const char *name, const char *colour, bool is_dashed);
// Draws a bar of 1, 2 or 5 times a power of ten of the unit; scale: px per unit. Returns where it ends.
double yk_sheet_scale(YkText *svg, YkVec at, double scale, double target, const char *unit);
// Breaks a line of words, after its number, into lines of the page. Returns where the next begins.
double yk_sheet_words(YkText *svg, size_t number, const char *words, double y, bool writes);

#endif
