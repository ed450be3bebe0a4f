// Makes drawings: collects poses, then writes the layers.
#include "picture/drawing/drawing.h"
#include <stdlib.h>
#include <string.h>
#include "base/escape.h"
#include "picture/svg.h"

YkDrawOptions yk_default_draw_options(void)
{
    return (YkDrawOptions){.width = 800, .labels = true};
}

static bool copy_traced(YkDrawing *drawing)
{
    size_t count = drawing->options.traced_count;
    size_t *own = calloc(count + 1, sizeof *own);
    if (!own) return false;
    if (count > 0) memcpy(own, drawing->options.traced_points, count * sizeof *own);
    drawing->options.traced_points = own;
    return true;
}

YkDrawing *yk_drawing_new(const YkMechanism *mech, const YkDrawOptions *options)
{
    YkDrawing *drawing = calloc(1, sizeof *drawing);
    if (!drawing) return NULL;
    drawing->mech = mech;
    drawing->model = yk_mechanism_model(mech);
    drawing->options = options ? *options : yk_default_draw_options();
    drawing->placed = calloc(drawing->model->body_count, sizeof *drawing->placed);
    drawing->motions = calloc(drawing->model->body_count, sizeof *drawing->motions);
    if (!drawing->placed || !drawing->motions || !copy_traced(drawing)) {
        free(drawing->motions);
        free(drawing->placed);
        free(drawing);
        return NULL;
    }
    if (!yk_drawing_outline(drawing) || !yk_drawing_take_cams(drawing)) {
        yk_drawing_free(drawing);
        return NULL;
    }
    return drawing;
}

void yk_drawing_free(YkDrawing *drawing)
{
    if (!drawing) return;
    free((void *)drawing->options.traced_points);
    yk_drawing_free_cams(drawing);
    free(drawing->outlines);
    free(drawing->corners);
    free(drawing->frames);
    free(drawing->placed);
    free(drawing->motions);
    free(drawing->traces);
    free(drawing->centers);
    free(drawing->centrode);
    free(drawing->shows_center);
    yk_text_free(&drawing->svg);
    free(drawing);
}

YkStatus yk_drawing_pose(YkDrawing *drawing, const YkState *state)
{
    size_t bodies = drawing->model->body_count;
    if (!YK_ROW_ROOM(drawing->frames, bodies, drawing->pose_count, drawing->pose_capacity)) return YK_NO_MEMORY;
    if (!yk_drawing_place(drawing, state, drawing->frames + drawing->pose_count * bodies)) return YK_BAD_ARGUMENT;
    drawing->pose_count++;
    return YK_OK;
}

YkStatus yk_drawing_trace(YkDrawing *drawing, const YkState *state)
{
    size_t points = drawing->options.traced_count;
    if (!YK_ROW_ROOM(drawing->traces, points, drawing->trace_count, drawing->trace_capacity)) return YK_NO_MEMORY;
    if (!yk_drawing_place(drawing, state, drawing->placed)) return YK_BAD_ARGUMENT;
    for (size_t i = 0; i < points; i++) {
        const YkPoint *point = &drawing->model->points[drawing->options.traced_points[i]];
        drawing->traces[drawing->trace_count * points + i] = yk_frame_apply(drawing->placed[point->body], point->at);
    }
    drawing->trace_count++;
    return YK_OK;
}

void yk_drawing_open(YkDrawing *drawing, const char *title)
{
    YkText *svg = &drawing->svg;
    yk_text_puts(svg, "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"");
    yk_svg_number(svg, drawing->width);
    yk_text_puts(svg, "\" height=\"");
    yk_svg_number(svg, drawing->height);
    yk_text_puts(svg, "\" viewBox=\"0 0 ");
    yk_svg_number(svg, drawing->width);
    yk_text_puts(svg, " ");
    yk_svg_number(svg, drawing->height);
    yk_text_puts(svg, "\" font-family=\"Helvetica, Arial, 'DejaVu Sans', sans-serif\" font-size=\"13\">\n<title>");
    yk_escape_xml(svg, title);
    yk_text_puts(svg, "</title>\n<rect width=\"100%\" height=\"100%\" fill=\"#fcfcfa\"/>\n");
}

// Writes the whole page, animated if seconds > 0.
static const char *write_document(YkDrawing *drawing, double seconds, bool to_and_fro)
{
    YkText *svg = &drawing->svg;
    yk_text_clear(svg);
    yk_drawing_fit(drawing);
    yk_drawing_open(drawing, yk_model_name(drawing->model));
    if (seconds > 0) yk_drawing_keyframes(drawing, seconds, to_and_fro);
    if (drawing->pose_count > 0) yk_drawing_guides(drawing);
    for (size_t pose = 0; pose + 1 < drawing->pose_count && !drawing->options.moving; pose++) {
        yk_text_puts(svg, "<g opacity=\"0.22\">\n");
        yk_drawing_bodies(drawing, pose);
        yk_text_puts(svg, "</g>\n");
    }
    yk_drawing_traces(drawing);
    yk_drawing_add_centrodes(drawing);
    if (drawing->pose_count > 0) {
        yk_drawing_bodies(drawing, drawing->pose_count - 1);
        if (drawing->options.labels) yk_drawing_labels(drawing);
        yk_drawing_mark_centers(drawing);
    }
    yk_drawing_margin(drawing);
    yk_text_puts(svg, "</svg>\n");
    return svg->failed ? NULL : yk_text_get(svg);
}

const char *yk_drawing_svg(YkDrawing *drawing)
{
    drawing->shown = drawing->pose_count > 0 ? yk_drawing_reference(drawing) : 0;
    return write_document(drawing, 0, false);
}

const char *yk_drawing_frame(YkDrawing *drawing, size_t pose)
{
    if (pose >= drawing->pose_count) return NULL;
    drawing->shown = pose;
    return write_document(drawing, 0, false);
}

const char *yk_drawing_animation(YkDrawing *drawing, double seconds, bool to_and_fro)
{
    if (drawing->pose_count == 0) return NULL;
    drawing->shown = yk_drawing_reference(drawing);
    return write_document(drawing, seconds, to_and_fro);
}
