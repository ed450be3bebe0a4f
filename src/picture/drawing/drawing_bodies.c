// Draws bars and plates: an outline drawn twice with round joins, dark and then a little narrower and light.
#include "picture/drawing/drawing.h"
#include "picture/svg.h"

enum { CORNERS_MAX = 64 }; // corners beyond these are not drawn

static void add_shape(YkDrawing *drawing, const YkVec *corners, size_t count, const char *colour, double width)
{
    YkText style = {0};
    yk_text_format(&style, "fill=\"%s\" stroke=\"%s\" stroke-width=\"", count > 2 ? colour : "none", colour);
    yk_svg_number(&style, width);
    yk_text_puts(&style, "\" stroke-linejoin=\"round\" stroke-linecap=\"round\"");
    if (count > 2) {
        yk_svg_polygon(&drawing->svg, corners, count, yk_text_get(&style));
    } else {
        yk_svg_line(&drawing->svg, corners[0], corners[1], yk_text_get(&style));
    }
    yk_text_free(&style);
}

void yk_drawing_body(YkDrawing *drawing, const YkFrame *frame, size_t body)
{
    YkVec corners[CORNERS_MAX];
    YkOutline outline = drawing->outlines[body];
    if (outline.count < 2) return;
    size_t count = outline.count < CORNERS_MAX ? outline.count : CORNERS_MAX;
    for (size_t i = 0; i < count; i++) {
        size_t corner = outline.first + i * outline.count / count;
        corners[i] = yk_drawing_pixel(drawing, yk_frame_apply(*frame, drawing->corners[corner]));
    }
    YkColour colour = yk_drawing_colour(body);
    yk_drawing_group(drawing, body);
    double rim = fmin(1.3, 0.2 * drawing->bar);
    add_shape(drawing, corners, count, colour.edge, drawing->bar);
    add_shape(drawing, corners, count, colour.fill, drawing->bar - 2 * rim);
    yk_drawing_ungroup(drawing);
}

void yk_drawing_bodies(YkDrawing *drawing, size_t pose)
{
    const YkFrame *frames = yk_drawing_frames(drawing, pose);
    yk_drawing_rods(drawing, frames);
    yk_drawing_cams(drawing, frames);
    yk_drawing_wheels(drawing, frames);
    for (size_t b = 1; b < drawing->model->body_count; b++) yk_drawing_body(drawing, &frames[b], b);
    yk_drawing_joints(drawing, frames);
}
