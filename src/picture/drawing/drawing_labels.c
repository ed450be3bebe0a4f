// Places the names of pins and bodies, each where it covers least of what is already drawn.
#include "picture/drawing/drawing.h"
#include <stdlib.h>
#include <string.h>
#include "picture/labels.h"
#include "picture/svg.h"
#include "write/table.h"

// Tries places round a point, near before far, and takes the first of the cheapest.
static void add_label(YkDrawing *drawing, YkLabels *labels, YkVec at, double reach, const char *name, const char *style)
{
    if (labels->count >= YK_LABELS_MAX) return;
    double width = 7.3 * (double)yk_text_columns(name, strlen(name)) + 2, height = 13;
    YkBox chosen = yk_labels_find(labels, at, reach, width, height, NULL);
    yk_labels_take(labels, chosen);
    yk_svg_word(&drawing->svg, yk_vec(0.5 * (chosen.left + chosen.right), chosen.bottom - 2.5), name, style);
}

static bool add_lines(YkDrawing *drawing, const YkFrame *frames, YkLabels *labels)
{
    labels->lines = calloc(drawing->corner_count + 1, sizeof *labels->lines);
    if (!labels->lines) return false;
    for (size_t b = 1; b < yk_model_body_count(drawing->model); b++) {
        YkOutline outline = drawing->outlines[b];
        for (size_t i = 0; i + (outline.count < 3) < outline.count; i++) {
            YkVec a = drawing->corners[outline.first + i],
                  z = drawing->corners[outline.first + (i + 1) % outline.count];
            labels->lines[labels->line_count][0] = yk_drawing_pixel(drawing, yk_frame_apply(frames[b], a));
            labels->lines[labels->line_count++][1] = yk_drawing_pixel(drawing, yk_frame_apply(frames[b], z));
        }
    }
    return true;
}

// Takes joints first, as obstacles, so that no name hides a pin, a box or a pedestal.
static void take_joints(YkDrawing *drawing, const YkFrame *frames, YkLabels *labels)
{
    double bar = drawing->bar;
    for (size_t j = 0; j < drawing->model->joint_count && labels->count < YK_LABELS_MAX; j++) {
        const YkJoint *joint = &drawing->model->joints[j];
        if (yk_drawing_omits(drawing->model, joint)) continue;
        YkVec at = yk_drawing_pixel(drawing, yk_drawing_joint(drawing, frames, joint, 1));
        bool on_ground = joint->body[0] == 0 || joint->body[1] == 0;
        YkBox box = yk_box_at(at, bar, bar);
        if (joint->kind == YK_PIN && on_ground) box = yk_box_at(yk_vec(at.x, at.y + bar), 3.6 * bar, 3 * bar);
        if (joint->kind == YK_SLIDE) box = yk_box_at(at, 3.2 * bar, 2.6 * bar);
        yk_labels_take(labels, box);
    }
}

static void name_joints(YkDrawing *drawing, const YkFrame *frames, YkLabels *labels)
{
    const YkFrame *shown = yk_drawing_frames(drawing, drawing->shown);
    for (size_t j = 0; j < drawing->model->joint_count; j++) {
        const YkJoint *joint = &drawing->model->joints[j];
        if (yk_drawing_omits(drawing->model, joint)) continue;
        YkVec at = yk_drawing_joint(drawing, frames, joint, 1);
        double reach = joint->kind == YK_SLIDE ? 1.3 * drawing->bar : 0.6 * drawing->bar;
        yk_drawing_group_name(drawing, 'j', j, at, yk_drawing_joint(drawing, shown, joint, 1));
        add_label(drawing, labels, yk_drawing_pixel(drawing, at), reach, joint->name,
                  "fill=\"#1c1e21\" font-weight=\"bold\"");
        yk_drawing_ungroup(drawing);
    }
}

static void name_bodies(YkDrawing *drawing, const YkFrame *frames, YkLabels *labels)
{
    const YkFrame *shown = yk_drawing_frames(drawing, drawing->shown);
    for (size_t b = 1; b < yk_model_body_count(drawing->model); b++) {
        YkText style = {0};
        yk_text_format(&style, "fill=\"%s\" font-style=\"italic\"", yk_drawing_colour(b).edge);
        double reach = drawing->outlines[b].count < 2 ? 1.4 * drawing->bar : 0.7 * drawing->bar;
        YkVec middle = yk_drawing_middle(drawing, frames, b);
        yk_drawing_group_name(drawing, 'n', b, middle, yk_drawing_middle(drawing, shown, b));
        add_label(drawing, labels, yk_drawing_pixel(drawing, middle), reach, yk_model_body_name(drawing->model, b),
                  yk_text_get(&style));
        yk_drawing_ungroup(drawing);
        yk_text_free(&style);
    }
}

void yk_drawing_labels(YkDrawing *drawing)
{
    if (drawing->model->joint_count * 2 + drawing->model->body_count > YK_LABELS_MAX) return;
    const YkFrame *frames = yk_drawing_frames(drawing, drawing->pose_count - 1);
    YkLabels *labels = calloc(1, sizeof *labels);
    if (!labels || !add_lines(drawing, frames, labels)) {
        drawing->svg.failed = true;
    } else {
        labels->half = 0.5 * drawing->bar;
        take_joints(drawing, frames, labels);
        yk_text_puts(&drawing->svg,
                     "<g text-anchor=\"middle\" stroke=\"#fcfcfa\" stroke-width=\"3\" stroke-linejoin=\"round\" "
                     "paint-order=\"stroke\">\n");
        name_joints(drawing, frames, labels);
        name_bodies(drawing, frames, labels);
        yk_text_puts(&drawing->svg, "</g>\n");
    }
    if (labels) free(labels->lines);
    free(labels);
}
