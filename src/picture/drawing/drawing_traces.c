// Paths of traced points, with a dot where the point is at the last pose.
#include "picture/drawing/drawing.h"
#include <stdlib.h>
#include "picture/svg.h"

static void add_path(YkDrawing *drawing, size_t index, YkVec *pixels)
{
    size_t width = drawing->options.traced_count, point = drawing->options.traced_points[index];
    const char *colour = yk_drawing_colour((size_t)drawing->model->points[point].body).edge;
    YkText style = {0};
    for (size_t i = 0; i < drawing->trace_count; i++)
        pixels[i] = yk_drawing_pixel(drawing, drawing->traces[i * width + index]);
    bool is_hidden = index + drawing->options.traced_hidden >= width;
    if (drawing->options.moving) yk_text_format(&style, "class=\"trace t%z%s\" ", point, is_hidden ? " off" : "");
    yk_text_format(&style, "fill=\"none\" stroke=\"%s\" stroke-width=\"1.6\" stroke-linejoin=\"round\"", colour);
    yk_svg_polyline(&drawing->svg, pixels, drawing->trace_count, yk_text_get(&style));
    yk_text_free(&style);
}

void yk_drawing_traces(YkDrawing *drawing)
{
    if (drawing->trace_count == 0 || drawing->options.traced_count == 0) return;
    YkVec *pixels = calloc(drawing->trace_count, sizeof *pixels);
    if (!pixels) drawing->svg.failed = true;
    for (size_t i = 0; pixels && i < drawing->options.traced_count; i++) add_path(drawing, i, pixels);
    free(pixels);
}
