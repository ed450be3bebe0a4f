// Centrodes on a drawing: both curves at the last pose, where they touch at the instant centre.
#include <math.h>
#include <stdlib.h>
#include "base/escape.h"
#include "picture/drawing/drawing.h"
#include "picture/svg.h"

YkStatus yk_drawing_centrodes(YkDrawing *drawing, const YkCentrodes *centrodes)
{
    if (!drawing || !centrodes) return YK_BAD_ARGUMENT;
    size_t count = yk_centrodes_count(centrodes);
    YkCentrodePoint *points = calloc(count + 2, sizeof *points);
    if (!points) return YK_NO_MEMORY;
    for (size_t k = 0; k < count; k++) points[k] = yk_centrodes_point(centrodes, k);
    if (yk_centrodes_are_closed(centrodes)) points[count++] = points[0];
    free(drawing->centrode);
    drawing->centrode = points;
    drawing->centrode_count = count;
    for (size_t side = 0; side < 2; side++) drawing->centrode_body[side] = yk_centrodes_body(centrodes, side);
    return YK_OK;
}

static YkVec place_of(const YkDrawing *drawing, const YkCentrodePoint *point, size_t side)
{
    const YkFrame *frames = yk_drawing_frames(drawing, yk_drawing_reference(drawing));
    return yk_frame_apply(frames[drawing->centrode_body[side]], yk_vec(point->on[side][0], point->on[side][1]));
}

// Shows what lies within one machine's size of the machine, and enlarges the page to hold it.
void yk_drawing_include_centrodes(YkDrawing *drawing)
{
    YkVec low = drawing->low, high = drawing->high;
    double reach = fmax(high.x - low.x, high.y - low.y);
    drawing->centrode_low = yk_vec(low.x - reach, low.y - reach);
    drawing->centrode_high = yk_vec(high.x + reach, high.y + reach);
    for (size_t k = 0; k < drawing->centrode_count; k++)
        for (size_t side = 0; side < 2 && drawing->centrode[k].exists; side++) {
            YkVec at = place_of(drawing, &drawing->centrode[k], side);
            at.x = fmin(fmax(at.x, drawing->centrode_low.x), drawing->centrode_high.x);
            at.y = fmin(fmax(at.y, drawing->centrode_low.y), drawing->centrode_high.y);
            drawing->low = yk_vec(fmin(drawing->low.x, at.x), fmin(drawing->low.y, at.y));
            drawing->high = yk_vec(fmax(drawing->high.x, at.x), fmax(drawing->high.y, at.y));
        }
}

static bool is_shown(const YkDrawing *drawing, const YkCentrodePoint *point, size_t side)
{
    if (!point->exists) return false;
    YkVec at = place_of(drawing, point, side), low = drawing->centrode_low, high = drawing->centrode_high;
    return at.x >= low.x && at.x <= high.x && at.y >= low.y && at.y <= high.y;
}

// Draws one curve, piece by piece.
static void add_curve(YkDrawing *drawing, size_t side, YkVec *pixels)
{
    YkText style = {0};
    size_t count = 0, body = drawing->centrode_body[side];
    const char *colour = body == 0 ? "#55585c" : yk_drawing_colour(body).edge;
    yk_text_puts(&style, "class=\"centrode\" data-body=\"");
    yk_escape_xml(&style, drawing->model->bodies[body].name);
    yk_text_format(&style, "\" fill=\"none\" stroke=\"%s\" stroke-width=\"1.6\"%s", colour,
                   side == 0 ? "" : " stroke-dasharray=\"7 3\"");
    for (size_t k = 0; k <= drawing->centrode_count; k++) {
        bool goes_on = k < drawing->centrode_count && is_shown(drawing, &drawing->centrode[k], side);
        if (goes_on) pixels[count++] = yk_drawing_pixel(drawing, place_of(drawing, &drawing->centrode[k], side));
        if (goes_on || count == 0) continue;
        if (count > 1) yk_svg_polyline(&drawing->svg, pixels, count, yk_text_get(&style));
        count = 0;
    }
    drawing->svg.failed |= style.failed;
    yk_text_free(&style);
}

void yk_drawing_add_centrodes(YkDrawing *drawing)
{
    if (drawing->centrode_count == 0) return;
    YkVec *pixels = calloc(drawing->centrode_count, sizeof *pixels);
    if (!pixels) drawing->svg.failed = true;
    for (size_t side = 0; pixels && side < 2; side++) add_curve(drawing, side, pixels);
    free(pixels);
}
