// SVG out: elements with coordinates in pixels, y down, as text. Two decimals, so the same picture is the same bytes.
#ifndef OUT_SVG_H
#define OUT_SVG_H
#include "base/text.h"
#include "base/vec.h"

void yk_svg_number(YkText *svg, double value);
void yk_svg_escape(YkText *svg, const char *string); // for element text and attributes; what XML forbids becomes U+FFFD
// Elements; `style` is a run of attributes ("stroke=\"#333\"") or "".
void yk_svg_line(YkText *svg, YkVec a, YkVec b, const char *style);
void yk_svg_circle(YkText *svg, YkVec center, double radius, const char *style);
void yk_svg_polygon(YkText *svg, const YkVec *corners, size_t count, const char *style);
void yk_svg_polyline(YkText *svg, const YkVec *points, size_t count, const char *style);
void yk_svg_word(YkText *svg, YkVec at, const char *string, const char *style);

#endif
