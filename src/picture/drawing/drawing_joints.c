// Draws the joints of one pose: sliding boxes, rods that they slide on, slots, welds, pins; and named points without
// joints.
#include "picture/drawing/drawing.h"
#include "picture/svg.h"

// Writes attributes: fill, edge and its width.
void yk_drawing_style(YkText *style, const char *fill, const char *edge, double width)
{
    yk_text_clear(style);
    yk_text_format(style, "fill=\"%s\" stroke=\"%s\" stroke-width=\"", fill, edge);
    yk_svg_number(style, width);
    yk_text_puts(style, "\" stroke-linejoin=\"round\" stroke-linecap=\"round\"");
}

// Returns the direction of a joint's line, as a unit vector on the page.
static YkVec page_direction(const YkFrame *frames, const YkJoint *joint)
{
    return yk_conj(yk_mul(frames[joint->body[0]].axis, joint->along));
}

// Draws the line of a moving body along which another slides: a rod from its start to where the other is.
static void add_rod(YkDrawing *drawing, const YkFrame *frames, const YkJoint *joint, YkText *style)
{
    YkVec from = yk_drawing_pixel(drawing, yk_drawing_joint(drawing, frames, joint, 0));
    YkVec to = yk_drawing_pixel(drawing, yk_drawing_joint(drawing, frames, joint, 1));
    YkVec along = page_direction(frames, joint);
    double sign = yk_dot(yk_sub(to, from), along) < 0 ? -1 : 1;
    if (drawing->options.moving) { // long enough for every pose
        YkStretch stretch = yk_drawing_stretch(drawing, joint);
        sign = stretch.high > -stretch.low ? 1 : -1;
        to = yk_add(from, yk_scale(drawing->scale * (sign > 0 ? stretch.high : stretch.low), along));
        from =
            yk_add(from, yk_scale(drawing->scale * (sign > 0 ? fmin(stretch.low, 0) : fmax(stretch.high, 0)), along));
    }
    yk_drawing_style(style, "none", yk_drawing_colour((size_t)joint->body[0]).edge, fmax(1, 0.35 * drawing->bar));
    yk_svg_line(&drawing->svg, from, yk_add(to, yk_scale(sign * 2.2 * drawing->bar, along)), yk_text_get(style));
}

static void add_box(YkDrawing *drawing, const YkFrame *frames, const YkJoint *joint, YkText *style)
{
    YkVec at = yk_drawing_pixel(drawing, yk_drawing_joint(drawing, frames, joint, 1));
    YkVec along = yk_scale(1.6 * drawing->bar, page_direction(frames, joint));
    YkVec across = yk_scale(0.6, yk_quarter(along)), back = yk_sub(at, along), front = yk_add(at, along);
    YkVec corners[4] = {yk_sub(back, across), yk_sub(front, across), yk_add(front, across), yk_add(back, across)};
    YkColour colour = yk_drawing_colour((size_t)joint->body[1]);
    yk_drawing_style(style, colour.fill, colour.edge, fmin(1.3, 0.2 * drawing->bar));
    yk_svg_polygon(&drawing->svg, corners, 4, yk_text_get(style));
}

static void add_slot(YkDrawing *drawing, const YkFrame *frames, const YkJoint *joint, YkText *style)
{
    YkFrame frame = frames[joint->body[0]];
    YkStretch stretch = yk_drawing_stretch(drawing, joint);
    YkVec low = yk_frame_apply(frame, yk_add(joint->at[0], yk_scale(stretch.low, joint->along)));
    YkVec high = yk_frame_apply(frame, yk_add(joint->at[0], yk_scale(stretch.high, joint->along)));
    YkVec along = yk_scale(0.5 * drawing->bar, page_direction(frames, joint));
    YkVec a = yk_sub(yk_drawing_pixel(drawing, low), along), b = yk_add(yk_drawing_pixel(drawing, high), along);
    YkColour colour = yk_drawing_colour((size_t)joint->body[0]);
    yk_drawing_style(style, "none", colour.edge, 1.9 * drawing->bar);
    yk_svg_line(&drawing->svg, a, b, yk_text_get(style));
    yk_drawing_style(style, "none", colour.fill, 1.9 * drawing->bar - fmin(2.6, 0.4 * drawing->bar));
    yk_svg_line(&drawing->svg, a, b, yk_text_get(style));
    yk_drawing_style(style, "none", "#ffffff", drawing->bar);
    yk_svg_line(&drawing->svg, a, b, yk_text_get(style));
}

static void add_pin(YkDrawing *drawing, const YkFrame *frames, const YkJoint *joint, YkText *style)
{
    YkVec at = yk_drawing_pixel(drawing, yk_drawing_joint(drawing, frames, joint, 1));
    yk_drawing_style(style, "#ffffff", "#2b2d30", fmin(1.4, 0.2 * drawing->bar));
    yk_svg_circle(&drawing->svg, at, fmax(0.8, 0.36 * drawing->bar), yk_text_get(style));
}

static void add_weld(YkDrawing *drawing, const YkFrame *frames, const YkJoint *joint, YkText *style)
{
    YkVec at = yk_drawing_pixel(drawing, yk_drawing_joint(drawing, frames, joint, 1));
    double half = 0.45 * drawing->bar;
    YkVec corners[4] = {
        {at.x - half, at.y - half}, {at.x + half, at.y - half}, {at.x + half, at.y + half}, {at.x - half, at.y + half}};
    yk_drawing_style(style, "#2b2d30", "none", 0);
    yk_svg_polygon(&drawing->svg, corners, 4, yk_text_get(style));
}

typedef void AddJoint(YkDrawing *drawing, const YkFrame *frames, const YkJoint *joint, YkText *style);

// Lines belong to the joint's first body (side 0), what moves along them to its second.
static void add_each(YkDrawing *drawing, const YkFrame *frames, YkPartKind kind, int side, bool ground_too,
                     AddJoint *add, YkText *style)
{
    for (size_t j = 0; j < drawing->model->joint_count; j++) {
        const YkJoint *joint = &drawing->model->joints[j];
        if (yk_drawing_omits(drawing->model, joint) || joint->kind != kind || !(ground_too || joint->body[0] != 0))
            continue;
        yk_drawing_group(drawing, (size_t)joint->body[side]);
        add(drawing, frames, joint, style);
        yk_drawing_ungroup(drawing);
    }
}

// Draws named points without joints (a coupler point, a tip) as small dots.
static void add_points(YkDrawing *drawing, const YkFrame *frames, YkText *style)
{
    const YkModel *model = drawing->model;
    for (size_t i = 0; i < model->point_count; i++) {
        const YkPoint *point = &model->points[i];
        if (point->body == 0) continue;
        YkVec at = yk_drawing_pixel(drawing, yk_frame_apply(frames[point->body], point->at));
        yk_drawing_style(style, yk_drawing_colour((size_t)point->body).edge, "none", 0);
        yk_drawing_group(drawing, (size_t)point->body);
        yk_svg_circle(&drawing->svg, at, fmax(0.5, 0.2 * drawing->bar), yk_text_get(style));
        yk_drawing_ungroup(drawing);
    }
}

void yk_drawing_rods(YkDrawing *drawing, const YkFrame *frames)
{
    YkText style = {0};
    add_each(drawing, frames, YK_SLIDE, 0, false, add_rod, &style);
    add_each(drawing, frames, YK_PIN_SLOT, 0, false, add_rod, &style);
    yk_text_free(&style);
}

void yk_drawing_joints(YkDrawing *drawing, const YkFrame *frames)
{
    YkText style = {0};
    add_points(drawing, frames, &style);
    add_each(drawing, frames, YK_PIN_SLOT, 0, false, add_slot, &style);
    add_each(drawing, frames, YK_SLIDE, 1, true, add_box, &style);
    add_each(drawing, frames, YK_WELD, 1, true, add_weld, &style);
    add_each(drawing, frames, YK_PIN, 1, true, add_pin, &style);
    add_each(drawing, frames, YK_PIN_SLOT, 1, true, add_pin, &style);
    yk_text_free(&style);
}

void yk_drawing_joint_on(YkDrawing *drawing, const YkFrame *frames, const YkJoint *joint, int side)
{
    YkText style = {0};
    if (side == 0 && joint->kind == YK_SLIDE) add_rod(drawing, frames, joint, &style);
    if (side == 0 && joint->kind == YK_PIN_SLOT) add_slot(drawing, frames, joint, &style);
    if (side == 1 && joint->kind == YK_SLIDE) add_box(drawing, frames, joint, &style);
    if (joint->kind == YK_WELD) add_weld(drawing, frames, joint, &style);
    if (joint->kind == YK_PIN || (side == 1 && joint->kind == YK_PIN_SLOT)) add_pin(drawing, frames, joint, &style);
    yk_text_free(&style);
}
