// Scenes: drawings whose bodies are moved by whoever shows them.
#include "base/escape.h"
#include "picture/drawing/drawing.h"
#include "picture/svg.h"

const char *yk_drawing_scene(YkDrawing *drawing)
{
    YkText *svg = &drawing->svg;
    if (drawing->pose_count == 0) return NULL;
    yk_text_clear(svg);
    yk_drawing_fit(drawing);
    drawing->shown = yk_drawing_reference(drawing);
    drawing->is_scene = true;
    yk_text_puts(svg, "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 ");
    yk_svg_number(svg, drawing->width);
    yk_text_puts(svg, " ");
    yk_svg_number(svg, drawing->height);
    YkVec zero = yk_drawing_pixel(drawing, yk_vec(0, 0));
    yk_text_format(svg, "\" data-scale=\"%g\" data-origin=\"%g %g\"", drawing->scale, zero.x, zero.y);
    yk_text_puts(svg, " font-family=\"Helvetica, Arial, 'DejaVu Sans', sans-serif\" font-size=\"13\">\n<title>");
    yk_escape_xml(svg, yk_model_name(drawing->model));
    yk_text_puts(svg, "</title>\n");
    yk_drawing_guides(drawing);
    yk_drawing_bodies(drawing, yk_drawing_reference(drawing));
    yk_text_puts(svg, "</svg>\n");
    drawing->is_scene = false;
    return svg->failed ? NULL : yk_text_get(svg);
}

// --- what is not fixed to one body

enum { COILS = 8 };

static void add_spring(YkDrawing *drawing, const YkFrame *frames, const YkSpring *spring)
{
    YkVec a = yk_drawing_pixel(drawing, yk_frame_apply(frames[spring->body[0]], spring->at[0]));
    YkVec b = yk_drawing_pixel(drawing, yk_frame_apply(frames[spring->body[1]], spring->at[1])), line = yk_sub(b, a);
    double length = yk_norm(line), width = 0.7 * drawing->bar;
    if (!(length > 0)) return;
    YkVec out = yk_scale(width / length, yk_quarter(line)), corners[2 * COILS + 4];
    size_t count = 0;
    corners[count++] = a;
    corners[count++] = yk_add(a, yk_scale(0.2, line));
    for (int k = 0; k < 2 * COILS; k++) {
        double part = 0.2 + 0.6 * (k + 0.5) / (2 * COILS);
        corners[count++] = yk_add(yk_add(a, yk_scale(part, line)), yk_scale(k % 2 ? -1 : 1, out));
    }
    corners[count++] = yk_add(a, yk_scale(0.8, line));
    corners[count++] = b;
    yk_svg_polyline(&drawing->svg, corners, count,
                    "fill=\"none\" stroke=\"#55585c\" stroke-width=\"1.4\" stroke-linejoin=\"round\"");
}

const char *yk_drawing_parts(YkDrawing *drawing, const YkState *state)
{
    if (drawing->pose_count < 2) return NULL;
    YkFrame *shown = drawing->frames + (drawing->pose_count - 2) * drawing->model->body_count;
    yk_text_clear(&drawing->svg);
    if (!yk_drawing_place(drawing, state, shown)) return yk_text_get(&drawing->svg);
    drawing->shown = drawing->pose_count - 2;
    for (size_t k = 0; k < drawing->model->spring_count; k++)
        if (drawing->model->springs[k].coordinate < 0) add_spring(drawing, shown, &drawing->model->springs[k]);
    if (drawing->options.labels) yk_drawing_labels(drawing);
    return drawing->svg.failed ? NULL : yk_text_get(&drawing->svg);
}
