// Writes SVG: elements with coordinates in pixels, y down. Two decimals, so that equal pictures have equal bytes.
#ifndef PICTURE_SVG_H
#define PICTURE_SVG_H
#include "base/text.h"
#include "base/vec.h"

void yk_svg_number(YkText *svg, double value);
// Elements; `style` is a run of attributes ("stroke=\"#333\"") or "".
void yk_svg_line(YkText *svg, YkVec a, YkVec b, const char *style);
void yk_svg_circle(YkText *svg, YkVec center, double radius, const char *style);
void yk_svg_polygon(YkText *svg, const YkVec *corners, size_t count, const char *style);
void yk_svg_polyline(YkText *svg, const YkVec *points, size_t count, const char *style);
void yk_svg_word(YkText *svg, YkVec at, const char *string, const char *style);

// A quantity's name in print: sign, factor, base with superscript and subscript; NULL or "": nothing.
typedef struct YkSvgName {
    const char *sign, *factor, *base, *super, *sub;
} YkSvgName;
// Writes a name from `at` to the right, its base in italics. yk_svg_name_width estimates its width in px, at 13 px a
// line.
void yk_svg_name(YkText *svg, YkVec at, const YkSvgName *name, const char *style);
double yk_svg_name_width(const YkSvgName *name);

#endif
