// Draws a polygon of velocities or accelerations to scale, with the steps of its construction below.
#include <math.h>
#include "design/polygons/polygon.h"
#include "picture/polygon_sheet.h"
#include "picture/svg.h"

enum { WIDTH = YK_SHEET_WIDTH, MARGIN = 60, DRAWING = 560 };

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
    YkVec a = pixel(page, yk_vec(v->start[0], v->start[1])), b = pixel(page, end_of(v));
    bool is_thin = v->part == YK_POLYGON_NORMAL || v->part == YK_POLYGON_CORIOLIS;
    yk_sheet_arrow(page->svg, a, b, meanings[v->part], colours[v->part], is_thin);
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
    double y = page->height - 14;
    double size = 1;
    const char *unit = yk_model_unit(page->p->model, yk_polygon_quantity(page->p), &size);
    double x = yk_sheet_scale(page->svg, yk_vec(MARGIN, y), page->scale * size, 120, unit) + 130;
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

const char *yk_polygon_svg(YkPolygon *p)
{
    if (!p) return NULL;
    Page page = {.p = p, .svg = &p->svg};
    yk_text_clear(&p->svg);
    fit(&page);
    double y = page.height + 26, end = y;
    for (size_t k = 0; k < p->step_count; k++) end = yk_sheet_words(&p->svg, k, p->step[k], end, false);
    YkText scale = {0};
    yk_text_format(&scale, " data-scale=\"%g\"", page.scale);
    yk_sheet_open(&p->svg, end + 6, yk_text_get(&scale), p->model->name,
                  p->kind == YK_POLYGON_VELOCITY ? "velocity polygon" : "acceleration polygon");
    p->svg.failed |= scale.failed;
    yk_text_free(&scale);
    for (size_t k = 0; k < p->vector_count; k++) add_vector(&page, &p->vector[k]);
    add_names(&page);
    add_scale(&page);
    for (size_t k = 0; k < p->step_count; k++) y = yk_sheet_words(&p->svg, k, p->step[k], y, true);
    yk_text_puts(&p->svg, "</svg>\n");
    return p->svg.failed ? NULL : yk_text_get(&p->svg);
}
