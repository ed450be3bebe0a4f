// Draws a polygon of velocities or accelerations to scale, with the steps of its construction below.
#include <math.h>
#include <string.h>
#include "base/escape.h"
#include "design/polygon.h"
#include "picture/svg.h"

enum { WIDTH = 800, MARGIN = 60, DRAWING = 560, LINE = 17, COLUMNS = 112 };

typedef struct Page {
    YkPolygon *p;
    YkText *svg;
    double scale, height; // px per m/s or m/s^2
    YkVec low, high;
} Page;

static const char *const colours[] = {
    [YK_POLYGON_TURNING] = "#274b7a", [YK_POLYGON_NORMAL] = "#5b5f66",   [YK_POLYGON_TANGENTIAL] = "#274b7a",
    [YK_POLYGON_SLIDING] = "#2f6b3a", [YK_POLYGON_CORIOLIS] = "#a93f22",
};
static const char *const meanings[] = {
    [YK_POLYGON_TURNING] = "turning", [YK_POLYGON_NORMAL] = "normal",     [YK_POLYGON_TANGENTIAL] = "tangential",
    [YK_POLYGON_SLIDING] = "sliding", [YK_POLYGON_CORIOLIS] = "Coriolis",
};

static void include(Page *page, const double at[2])
{
    page->low = yk_vec(fmin(page->low.x, at[0]), fmin(page->low.y, at[1]));
    page->high = yk_vec(fmax(page->high.x, at[0]), fmax(page->high.y, at[1]));
}

static YkVec end_of(const YkPolygonVector *v)
{
    return yk_vec(v->start[0] + v->value[0], v->start[1] + v->value[1]);
}

static void fit(Page *page)
{
    for (size_t k = 0; k < page->p->vector_count; k++) {
        YkVec end = end_of(&page->p->vector[k]);
        include(page, page->p->vector[k].start);
        include(page, (const double[]){end.x, end.y});
    }
    double across = page->high.x - page->low.x, up = page->high.y - page->low.y;
    page->scale = fmin((WIDTH - 2 * MARGIN) / across, DRAWING / up);
    if (!isfinite(page->scale)) page->scale = 1;
    page->height = up * page->scale + 2 * MARGIN;
}

static YkVec pixel(const Page *page, YkVec at)
{
    double middle = 0.5 * (page->low.x + page->high.x);
    return yk_vec(0.5 * WIDTH + (at.x - middle) * page->scale, MARGIN + (page->high.y - at.y) * page->scale);
}

static void add_vector(Page *page, const YkPolygonVector *v)
{
    YkText style = {0};
    YkVec a = pixel(page, yk_vec(v->start[0], v->start[1])), b = pixel(page, end_of(v)), way = yk_sub(b, a);
    double length = yk_norm(way), head = fmin(10, 0.5 * length);
    if (!(length > 0.05)) return;
    YkVec along = yk_scale(head / length, way), across = yk_scale(0.35, yk_quarter(along)), back = yk_sub(b, along);
    bool is_thin = v->part == YK_POLYGON_NORMAL || v->part == YK_POLYGON_CORIOLIS;
    yk_text_format(&style, "class=\"%s\" stroke=\"%s\" stroke-width=\"1.6\"%s", meanings[v->part], colours[v->part],
                   is_thin ? " stroke-dasharray=\"6 3\"" : "");
    yk_svg_line(page->svg, a, b, yk_text_get(&style));
    yk_text_clear(&style);
    yk_text_format(&style, "fill=\"%s\"", colours[v->part]);
    yk_svg_polygon(page->svg, (const YkVec[]){b, yk_add(back, across), yk_sub(back, across)}, 3, yk_text_get(&style));
    page->svg->failed |= style.failed;
    yk_text_free(&style);
}

// Names that would lie on one another are written side by side: images that coincide are one point of the picture.
static void add_names(Page *page)
{
    for (size_t k = 0; k < page->p->image_count; k++) {
        YkVec at = pixel(page, yk_vec(page->p->image[k].value[0], page->p->image[k].value[1]));
        YkText name = {0};
        bool is_told = false;
        for (size_t i = 0; i < page->p->image_count; i++) {
            YkVec other = pixel(page, yk_vec(page->p->image[i].value[0], page->p->image[i].value[1]));
            if (yk_norm(yk_sub(at, other)) > 3) continue;
            is_told |= i < k;
            yk_text_format(&name, "%s%s", name.length > 0 ? ", " : "", page->p->image[i].name);
        }
        yk_svg_circle(page->svg, at, 2.4, "fill=\"#1d1f21\"");
        if (!is_told) yk_svg_word(page->svg, yk_add(at, yk_vec(7, -6)), yk_text_get(&name), "font-style=\"italic\"");
        page->svg->failed |= name.failed;
        yk_text_free(&name);
    }
}

// A bar of 1, 2 or 5 times a power of ten, and what the colours mean.
static void add_scale(Page *page)
{
    double target = 120 / page->scale, size = yk_pow(10, floor(yk_log10(target))), y = page->height - 14;
    size *= target >= 5 * size ? 5 : target >= 2 * size ? 2 : 1;
    YkText text = {0};
    YkVec a = yk_vec(MARGIN, y), b = yk_vec(MARGIN + size * page->scale, y);
    yk_svg_line(page->svg, a, b, "class=\"scale\" stroke=\"#1d1f21\" stroke-width=\"2\"");
    yk_text_format(&text, "%e %s", size, page->p->kind == YK_POLYGON_VELOCITY ? "m/s" : "m/s^2");
    yk_svg_word(page->svg, yk_add(b, yk_vec(8, 4)), yk_text_get(&text), "");
    yk_text_free(&text);
    double x = b.x + 130;
    for (int part = 0; part <= YK_POLYGON_CORIOLIS; part++) {
        bool has = false;
        YkText style = {0};
        for (size_t k = 0; k < page->p->vector_count; k++) has |= (int)page->p->vector[k].part == part;
        if (!has) continue;
        yk_text_format(&style, "fill=\"%s\"", colours[part]);
        yk_svg_word(page->svg, yk_vec(x, y + 4), meanings[part], yk_text_get(&style));
        yk_text_free(&style);
        x += 90;
    }
}

// Breaks a line of words into lines of the page; returns where the next begins.
static double add_step(Page *page, size_t number, const char *words, double y, bool writes)
{
    YkText line = {0};
    yk_text_format(&line, "%z. ", number + 1);
    for (size_t at = 0, length = strlen(words); at < length; y += LINE) {
        size_t room = COLUMNS - 3, end = length - at <= room ? length : at + room;
        while (end < length && end > at && words[end] != ' ') end--;
        if (end == at) end = length - at <= room ? length : at + room;
        if (at > 0) yk_text_puts(&line, "    ");
        yk_text_add(&line, words + at, end - at);
        if (writes) yk_svg_word(page->svg, yk_vec(MARGIN / 2, y), yk_text_get(&line), "");
        yk_text_clear(&line);
        at = end + (end < length && words[end] == ' ');
    }
    page->svg->failed |= line.failed;
    yk_text_free(&line);
    return y + 6;
}

static void open_page(Page *page, double height)
{
    YkText *svg = page->svg;
    bool is_velocity = page->p->kind == YK_POLYGON_VELOCITY;
    yk_text_format(svg, "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%d\" height=\"", (int)WIDTH);
    yk_svg_number(svg, height);
    yk_text_format(svg, "\" viewBox=\"0 0 %d ", (int)WIDTH);
    yk_svg_number(svg, height);
    yk_text_format(
        svg,
        "\" data-scale=\"%g\" font-family=\"Helvetica, Arial, 'DejaVu Sans', sans-serif\" font-size=\"13\">\n<title>",
        page->scale);
    yk_escape_xml(svg, page->p->model->name);
    yk_text_format(svg, ": %s polygon</title>\n<rect width=\"100%%\" height=\"100%%\" fill=\"#fcfcfa\"/>\n",
                   is_velocity ? "velocity" : "acceleration");
}

const char *yk_polygon_svg(YkPolygon *p)
{
    if (!p) return NULL;
    Page page = {.p = p, .svg = &p->svg};
    yk_text_clear(&p->svg);
    fit(&page);
    double y = page.height + 26, end = y;
    for (size_t k = 0; k < p->step_count; k++) end = add_step(&page, k, p->step[k], end, false);
    open_page(&page, end + 6);
    for (size_t k = 0; k < p->vector_count; k++) add_vector(&page, &p->vector[k]);
    add_names(&page);
    add_scale(&page);
    for (size_t k = 0; k < p->step_count; k++) y = add_step(&page, k, p->step[k], y, true);
    yk_text_puts(&p->svg, "</svg>\n");
    return p->svg.failed ? NULL : yk_text_get(&p->svg);
}
