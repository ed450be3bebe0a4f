// Names of pins and bodies, each where it covers least of what is drawn already.
#include "out/drawing.h"
#include <stdlib.h>
#include <string.h>
#include "out/svg.h"
#include "out/table.h"

enum { LABELS_MAX = 160, PLACES = 16 }; // a machine with more names than that is drawn without

typedef struct Box {
    double left, top, right, bottom;
} Box;
typedef struct Labels {
    Box boxes[LABELS_MAX]; // taken by names
    size_t count;
    YkVec (*lines)[2]; // edges of bodies
    size_t line_count;
    double half; // of a bar's width, px
} Labels;

static double overlap(Box a, Box b)
{
    double across = fmin(a.right, b.right) - fmax(a.left, b.left), up = fmin(a.bottom, b.bottom) - fmax(a.top, b.top);
    return across > 0 && up > 0 ? across * up : 0;
}

// How much of a line runs within a box: samples would do, but clipping is exact (Liang & Barsky 1984).
static double covered(Box box, const YkVec line[2])
{
    YkVec d = yk_sub(line[1], line[0]);
    double p[4] = {-d.x, d.x, -d.y, d.y}, low = 0, high = 1;
    double q[4] = {line[0].x - box.left, box.right - line[0].x, line[0].y - box.top, box.bottom - line[0].y};
    for (int i = 0; i < 4; i++) {
        if (p[i] == 0 && q[i] < 0) return 0;
        if (p[i] < 0) low = fmax(low, q[i] / p[i]);
        if (p[i] > 0) high = fmin(high, q[i] / p[i]);
    }
    return high > low ? (high - low) * yk_norm(d) : 0;
}

static double cost(const Labels *labels, Box box)
{
    double sum = 0;
    for (size_t i = 0; i < labels->count; i++) sum += 4 * overlap(labels->boxes[i], box);
    Box wide = {box.left - labels->half, box.top - labels->half, box.right + labels->half, box.bottom + labels->half};
    for (size_t i = 0; i < labels->line_count; i++) sum += 10 * covered(wide, labels->lines[i]);
    return sum;
}

static Box box_at(YkVec middle, double width, double height)
{
    return (Box){middle.x - 0.5 * width, middle.y - 0.5 * height, middle.x + 0.5 * width, middle.y + 0.5 * height};
}

// Tries places round a point, near before far, and takes the first of the cheapest.
static void add_label(YkDrawing *drawing, Labels *labels, YkVec at, double reach, const char *name, const char *style)
{
    if (labels->count >= LABELS_MAX) return;
    double width = 7.3 * (double)yk_text_columns(name, strlen(name)) + 2, height = 13, best = INFINITY;
    Box chosen = {0};
    for (int ring = 0; ring < 3; ring++) {
        for (int i = 0; i < PLACES; i++) {
            YkVec out = yk_unit(-YK_PI / 4 + 2 * YK_PI * i / PLACES);
            double far = reach + 2 + 9.0 * ring;
            Box box =
                box_at(yk_vec(at.x + out.x * (far + 0.5 * width), at.y + out.y * (far + 0.5 * height)), width, height);
            double price = cost(labels, box) + 12.0 * ring;
            if (price < best - 1e-6) {
                best = price;
                chosen = box;
            }
        }
    }
    labels->boxes[labels->count++] = chosen;
    yk_svg_word(&drawing->svg, yk_vec(0.5 * (chosen.left + chosen.right), chosen.bottom - 2.5), name, style);
}

static bool add_lines(YkDrawing *drawing, const YkFrame *frames, Labels *labels)
{
    labels->lines = calloc(drawing->corner_count + 1, sizeof *labels->lines);
    if (!labels->lines) return false;
    for (size_t b = 1; b < drawing->model->body_count; b++) {
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

// Joints first, as obstacles, so that no name hides a pin, a box or a pedestal.
static void take_joints(YkDrawing *drawing, const YkFrame *frames, Labels *labels)
{
    double bar = drawing->bar;
    for (size_t j = 0; j < drawing->model->joint_count && labels->count < LABELS_MAX; j++) {
        const YkJoint *joint = &drawing->model->joints[j];
        YkVec at = yk_drawing_pixel(drawing, yk_drawing_joint(drawing, frames, joint, 1));
        bool on_ground = joint->body[0] == 0 || joint->body[1] == 0;
        Box box = box_at(at, bar, bar);
        if (joint->kind == YK_PIN && on_ground) box = box_at(yk_vec(at.x, at.y + bar), 3.6 * bar, 3 * bar);
        if (joint->kind == YK_SLIDE) box = box_at(at, 3.2 * bar, 2.6 * bar);
        labels->boxes[labels->count++] = box;
    }
}

static void name_joints(YkDrawing *drawing, const YkFrame *frames, Labels *labels)
{
    for (size_t j = 0; j < drawing->model->joint_count; j++) {
        const YkJoint *joint = &drawing->model->joints[j];
        YkVec at = yk_drawing_pixel(drawing, yk_drawing_joint(drawing, frames, joint, 1));
        double reach = joint->kind == YK_SLIDE ? 1.3 * drawing->bar : 0.6 * drawing->bar;
        add_label(drawing, labels, at, reach, joint->name, "fill=\"#1c1e21\" font-weight=\"bold\"");
    }
}

static YkVec middle_of(YkDrawing *drawing, const YkFrame *frames, size_t body)
{
    YkOutline outline = drawing->outlines[body];
    YkVec sum = {0, 0};
    for (size_t i = 0; i < outline.count; i++) sum = yk_add(sum, drawing->corners[outline.first + i]);
    if (outline.count > 0) sum = yk_scale(1 / (double)outline.count, sum);
    return yk_drawing_pixel(drawing, yk_frame_apply(frames[body], sum));
}

static void name_bodies(YkDrawing *drawing, const YkFrame *frames, Labels *labels)
{
    for (size_t b = 1; b < drawing->model->body_count; b++) {
        YkText style = {0};
        yk_text_format(&style, "fill=\"%s\" font-style=\"italic\"", yk_drawing_colour(b).edge);
        double reach = drawing->outlines[b].count < 2 ? 1.4 * drawing->bar : 0.7 * drawing->bar;
        add_label(drawing, labels, middle_of(drawing, frames, b), reach, yk_model_body_name(drawing->model, b),
                  yk_text_get(&style));
        drawing->svg.failed |= style.failed;
        yk_text_free(&style);
    }
}

void yk_drawing_labels(YkDrawing *drawing)
{
    if (drawing->model->joint_count * 2 + drawing->model->body_count > LABELS_MAX) return;
    const YkFrame *frames = yk_drawing_frames(drawing, drawing->pose_count - 1);
    Labels *labels = calloc(1, sizeof *labels);
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
