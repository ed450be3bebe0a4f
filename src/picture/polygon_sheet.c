// Draws what pictures of polygons share.
#include "picture/polygon_sheet.h"
#include <string.h>
#include "base/escape.h"
#include "elementary/elementary.h"
#include "picture/svg.h"

enum { LINE = 17, COLUMNS = 112, INDENT = 30 };

void yk_sheet_open(YkText *svg, double height, const char *attributes, const char *model, const char *title)
{
    yk_text_format(svg, "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%d\" height=\"", (int)YK_SHEET_WIDTH);
    yk_svg_number(svg, height);
    yk_text_format(svg, "\" viewBox=\"0 0 %d ", (int)YK_SHEET_WIDTH);
    yk_svg_number(svg, height);
    yk_text_format(svg, "\"%s font-family=\"Helvetica, Arial, 'DejaVu Sans', sans-serif\" font-size=\"13\">\n<title>",
                   attributes);
    yk_escape_xml(svg, model);
    yk_text_format(svg, ": %s</title>\n<rect width=\"100%%\" height=\"100%%\" fill=\"#fcfcfa\"/>\n", title);
}

void yk_sheet_arrow(YkText *svg, YkVec a, YkVec b, const char *name, const char *colour, bool is_dashed)
{
    YkText style = {0};
    YkVec way = yk_sub(b, a);
    double length = yk_norm(way), head = fmin(10, 0.5 * length);
    if (!(length > 0.05)) return;
    YkVec along = yk_scale(head / length, way), across = yk_scale(0.35, yk_quarter(along)), back = yk_sub(b, along);
    yk_text_format(&style, "class=\"%s\" stroke=\"%s\" stroke-width=\"1.6\"%s", name, colour,
                   is_dashed ? " stroke-dasharray=\"6 3\"" : "");
    yk_svg_line(svg, a, b, yk_text_get(&style));
    yk_text_clear(&style);
    yk_text_format(&style, "fill=\"%s\"", colour);
    yk_svg_polygon(svg, (const YkVec[]){b, yk_add(back, across), yk_sub(back, across)}, 3, yk_text_get(&style));
    svg->failed |= style.failed;
    yk_text_free(&style);
}

double yk_sheet_scale(YkText *svg, YkVec a, double scale, double target, const char *unit)
{
    double most = target / scale, size = yk_pow(10, floor(yk_log10(most)));
    size *= most >= 5 * size ? 5 : most >= 2 * size ? 2 : 1;
    YkText text = {0};
    YkVec b = yk_vec(a.x + size * scale, a.y);
    yk_svg_line(svg, a, b, "class=\"scale\" stroke=\"#1d1f21\" stroke-width=\"2\"");
    yk_text_format(&text, "%e %s", size, unit);
    yk_svg_word(svg, yk_add(b, yk_vec(8, 4)), yk_text_get(&text), "");
    svg->failed |= text.failed;
    yk_text_free(&text);
    return b.x;
}

double yk_sheet_words(YkText *svg, size_t number, const char *words, double y, bool writes)
{
    YkText line = {0};
    yk_text_format(&line, "%z. ", number + 1);
    for (size_t at = 0, length = strlen(words); at < length; y += LINE) {
        size_t room = COLUMNS - 3, end = length - at <= room ? length : at + room;
        while (end < length && end > at && words[end] != ' ') end--;
        if (end == at) end = length - at <= room ? length : at + room;
        if (at > 0) yk_text_puts(&line, "    ");
        yk_text_add(&line, words + at, end - at);
        if (writes) yk_svg_word(svg, yk_vec(INDENT, y), yk_text_get(&line), "");
        yk_text_clear(&line);
        at = end + (end < length && words[end] == ' ');
    }
    svg->failed |= line.failed;
    yk_text_free(&line);
    return y + 6;
}
