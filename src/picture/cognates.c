// A machine and its cognates over one another, with the curve that they share.
#include <math.h>
#include "picture/svg.h"
#include "synthesis/cognates.h"

enum { SIZE = 640, MARGIN = 40 };

typedef struct Page {
    YkText *svg;
    YkVec middle; // m
    double scale; // px per m
} Page;

static YkVec pixel(const Page *page, YkVec at)
{
    YkVec off = yk_scale(page->scale, yk_sub(at, page->middle));
    return yk_vec(SIZE / 2.0 + off.x, SIZE / 2.0 - off.y);
}

// A0, A, B, B0 (or B again for a slider) and P.
static void place(const YkDesign *d, YkVec at[5])
{
    YkVec along = yk_unit(d->angle[1]);
    at[0] = d->pivot[0];
    at[1] = yk_add(at[0], yk_scale(d->length[1], yk_unit(d->angle[0])));
    at[2] = yk_add(at[1], yk_scale(d->length[2], along));
    at[3] = d->kind == YK_DESIGN_FOUR_BAR ? d->pivot[1] : at[2];
    at[4] = yk_add(at[1], yk_mul(along, d->point));
}

static void include(YkVec *low, YkVec *high, YkVec at)
{
    *low = yk_vec(fmin(low->x, at.x), fmin(low->y, at.y));
    *high = yk_vec(fmax(high->x, at.x), fmax(high->y, at.y));
}

static void draw(const Page *page, const YkDesign *d, const char *colour)
{
    YkVec at[5], p[5];
    YkText style = {0};
    place(d, at);
    for (size_t k = 0; k < 5; k++) p[k] = pixel(page, at[k]);
    YkVec corners[3] = {p[1], p[2], p[4]};
    yk_text_format(&style, "fill=\"%s\" fill-opacity=\"0.15\" stroke=\"%s\"", colour, colour);
    yk_svg_polygon(page->svg, corners, 3, yk_text_get(&style));
    yk_text_clear(&style);
    yk_text_format(&style, "stroke=\"%s\" stroke-width=\"3\"", colour);
    yk_svg_line(page->svg, p[0], p[1], yk_text_get(&style));
    yk_svg_line(page->svg, p[2], p[3], yk_text_get(&style));
    if (d->kind == YK_DESIGN_SLIDER_CRANK) {
        YkVec along = yk_scale(40, yk_conj(yk_unit(d->along)));
        yk_text_puts(&style, " stroke-dasharray=\"5 3\"");
        yk_svg_line(page->svg, yk_sub(p[2], along), yk_add(p[2], along), yk_text_get(&style));
    }
    for (size_t k = 0; k < 4; k++) yk_svg_circle(page->svg, p[k], 3, "fill=\"#fff\" stroke=\"#34495e\"");
    if (style.failed) yk_text_fail(page->svg);
    yk_text_free(&style);
}

const char *yk_cognates_picture(YkCognates *c)
{
    static const char *const colours[] = {"#2471a3", "#ca6f1e", "#1e8449"};
    YkVec low, high, at[5], points[YK_CURVE_ROWS];
    if (!c) return NULL;
    Page page = {.svg = &c->picture};
    low = high = c->own.pivot[0];
    for (size_t k = 0; k <= c->count; k++) {
        place(k == 0 ? &c->own : &c->item[k - 1].design, at);
        for (size_t i = 0; i < 5; i++) include(&low, &high, at[i]);
    }
    for (size_t r = 0; r < c->rows; r++) include(&low, &high, yk_vec(c->curve[2 * r], c->curve[2 * r + 1]));
    page.middle = yk_scale(0.5, yk_add(low, high));
    page.scale = (SIZE - 2 * MARGIN) / fmax(fmax(high.x - low.x, high.y - low.y), 1e-12);
    yk_text_clear(page.svg);
    yk_text_format(page.svg,
                   "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%d\" height=\"%d\" viewBox=\"0 0 %d %d\" "
                   "font-family=\"sans-serif\">\n<rect width=\"100%%\" height=\"100%%\" fill=\"#fff\"/>\n",
                   SIZE, SIZE, SIZE, SIZE);
    for (size_t r = 0; r < c->rows; r++) points[r] = pixel(&page, yk_vec(c->curve[2 * r], c->curve[2 * r + 1]));
    yk_svg_polyline(page.svg, points, c->rows, "fill=\"none\" stroke=\"#7b241c\" stroke-width=\"1.5\"");
    for (size_t k = 0; k <= c->count; k++) draw(&page, k == 0 ? &c->own : &c->item[k - 1].design, colours[k]);
    yk_text_puts(page.svg, "</svg>\n");
    return page.svg->failed ? NULL : yk_text_get(page.svg);
}
