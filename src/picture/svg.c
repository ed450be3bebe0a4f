// Writes SVG elements.
#include "picture/svg.h"
#include <string.h>
#include "base/escape.h"
#include "base/number.h"
#include "write/table.h"

void yk_svg_number(YkText *svg, double value)
{
    char digits[YK_NUMBER_SIZE];
    size_t length = yk_number_write_fixed(fabs(value) < 0.005 ? 0 : value, 2, digits);
    bool has_point = false;
    for (size_t i = 0; i < length; i++) has_point |= digits[i] == '.';
    while (has_point && digits[length - 1] == '0') length--;
    if (has_point && digits[length - 1] == '.') length--;
    yk_text_add(svg, digits, length);
}

static void add_attribute(YkText *svg, const char *name, double value)
{
    yk_text_format(svg, " %s=\"", name);
    yk_svg_number(svg, value);
    yk_text_puts(svg, "\"");
}

static void end_element(YkText *svg, const char *style)
{
    yk_text_format(svg, "%s%s/>\n", *style ? " " : "", style);
}

void yk_svg_line(YkText *svg, YkVec a, YkVec b, const char *style)
{
    yk_text_puts(svg, "<line");
    add_attribute(svg, "x1", a.x);
    add_attribute(svg, "y1", a.y);
    add_attribute(svg, "x2", b.x);
    add_attribute(svg, "y2", b.y);
    end_element(svg, style);
}

void yk_svg_circle(YkText *svg, YkVec center, double radius, const char *style)
{
    yk_text_puts(svg, "<circle");
    add_attribute(svg, "cx", center.x);
    add_attribute(svg, "cy", center.y);
    add_attribute(svg, "r", radius);
    end_element(svg, style);
}

static void add_points(YkText *svg, const char *element, const YkVec *points, size_t count, const char *style)
{
    yk_text_format(svg, "<%s points=\"", element);
    for (size_t i = 0; i < count; i++) {
        if (i > 0) yk_text_puts(svg, " ");
        yk_svg_number(svg, points[i].x);
        yk_text_puts(svg, ",");
        yk_svg_number(svg, points[i].y);
    }
    yk_text_puts(svg, "\"");
    end_element(svg, style);
}

void yk_svg_polygon(YkText *svg, const YkVec *corners, size_t count, const char *style)
{
    add_points(svg, "polygon", corners, count, style);
}

void yk_svg_polyline(YkText *svg, const YkVec *points, size_t count, const char *style)
{
    add_points(svg, "polyline", points, count, style);
}

void yk_svg_word(YkText *svg, YkVec at, const char *string, const char *style)
{
    yk_text_puts(svg, "<text");
    add_attribute(svg, "x", at.x);
    add_attribute(svg, "y", at.y);
    yk_text_format(svg, "%s%s>", *style ? " " : "", style);
    yk_escape_xml(svg, string);
    yk_text_puts(svg, "</text>\n");
}

static void add_span(YkText *svg, const char *string, const char *style)
{
    if (!string || !*string) return;
    yk_text_format(svg, "<tspan %s>", style);
    yk_escape_xml(svg, string);
    yk_text_puts(svg, "</tspan>");
}

void yk_svg_name(YkText *svg, YkVec at, const YkSvgName *name, const char *style)
{
    yk_text_puts(svg, "<text");
    add_attribute(svg, "x", at.x);
    add_attribute(svg, "y", at.y);
    yk_text_format(svg, "%s%s>", *style ? " " : "", style);
    if (name->sign) yk_escape_xml(svg, name->sign);
    if (name->factor) yk_escape_xml(svg, name->factor);
    add_span(svg, name->base, "font-style=\"italic\"");
    add_span(svg, name->super, "dy=\"-5\" font-size=\"10\"");
    add_span(svg, name->sub, name->super && *name->super ? "dy=\"9\" font-size=\"10\"" : "dy=\"4\" font-size=\"10\"");
    yk_text_puts(svg, "</text>\n");
}

static double width_of(const char *string, double of_one)
{
    return string ? of_one * (double)yk_text_columns(string, strlen(string)) : 0;
}

double yk_svg_name_width(const YkSvgName *name)
{
    double small = width_of(name->super, 6) + width_of(name->sub, 6);
    return 4 + width_of(name->sign, 7.6) + width_of(name->factor, 7.6) + width_of(name->base, 9) + small;
}
