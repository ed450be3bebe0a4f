// Draws what is fixed: pins on their pedestals, rails of guides, hatched towards the ground.
#include "picture/drawing/drawing.h"
#include "picture/svg.h"

static const char edge[] = "fill=\"#eeeeea\" stroke=\"#55585c\" stroke-width=\"1.4\" stroke-linejoin=\"round\"";
static const char rail[] = "stroke=\"#55585c\" stroke-width=\"1.4\" stroke-linecap=\"round\"";
static const char stroke[] = "stroke=\"#8a8d91\" stroke-width=\"0.9\" stroke-linecap=\"round\"";

// Draws short slanted strokes along a line, on the side to which `down` points.
static void add_hatch(YkDrawing *drawing, YkVec a, YkVec b, YkVec down)
{
    double spacing = fmax(3, 0.6 * drawing->bar), length = yk_norm(yk_sub(b, a));
    size_t count = (size_t)fmin(fmax(floor(length / spacing), 1), 1000);
    YkVec step = yk_scale(1 / (double)count, yk_sub(b, a));
    YkVec slant =
        yk_sub(yk_scale(0.75 * spacing, down), yk_scale(0.6 * spacing, yk_scale(1 / fmax(length, 1e-9), yk_sub(b, a))));
    yk_svg_line(&drawing->svg, a, b, rail);
    for (size_t i = 0; i < count; i++) {
        YkVec from = yk_add(a, yk_scale((double)i + 0.75, step));
        yk_svg_line(&drawing->svg, from, yk_add(from, slant), stroke);
    }
}

static void add_pedestal(YkDrawing *drawing, YkVec at)
{
    double half = 1.15 * drawing->bar, tall = 1.7 * drawing->bar;
    YkVec corners[3] = {at, {at.x - half, at.y + tall}, {at.x + half, at.y + tall}};
    yk_svg_polygon(&drawing->svg, corners, 3, edge);
    add_hatch(drawing, yk_vec(at.x - 1.6 * half, at.y + tall), yk_vec(at.x + 1.6 * half, at.y + tall), yk_vec(0, 1));
}

YkStretch yk_drawing_stretch(const YkDrawing *drawing, const YkJoint *joint)
{
    YkStretch stretch = {INFINITY, -INFINITY};
    for (size_t pose = 0; pose < drawing->pose_count; pose++) {
        const YkFrame *frames = yk_drawing_frames(drawing, pose);
        YkVec offset = yk_sub(yk_drawing_joint(drawing, frames, joint, 1), yk_drawing_joint(drawing, frames, joint, 0));
        double distance = yk_dot(offset, yk_mul(frames[joint->body[0]].axis, joint->along));
        stretch.low = fmin(stretch.low, distance);
        stretch.high = fmax(stretch.high, distance);
    }
    return stretch;
}

// Draws the two rails of a guide in the ground, over the stretch that is used and a little more.
static void add_rails(YkDrawing *drawing, const YkJoint *joint)
{
    double gap = joint->kind == YK_SLIDE ? 1.02 * drawing->bar : 0.5 * drawing->bar, beyond = 3 * drawing->bar;
    YkStretch stretch = yk_drawing_stretch(drawing, joint);
    const YkFrame *frames = yk_drawing_frames(drawing, 0);
    YkVec from = yk_drawing_joint(drawing, frames, joint, 0), along = yk_conj(joint->along);
    YkVec low = yk_drawing_pixel(drawing, yk_add(from, yk_scale(stretch.low, joint->along)));
    YkVec high = yk_drawing_pixel(drawing, yk_add(from, yk_scale(stretch.high, joint->along)));
    low = yk_sub(low, yk_scale(beyond, along));
    high = yk_add(high, yk_scale(beyond, along));
    for (int side = -1; side <= 1; side += 2) {
        YkVec out = yk_scale(side, yk_quarter(along)), shift = yk_scale(gap, out);
        add_hatch(drawing, yk_add(low, shift), yk_add(high, shift), out);
    }
}

void yk_drawing_guides(YkDrawing *drawing)
{
    const YkModel *model = drawing->model;
    const YkFrame *frames = yk_drawing_frames(drawing, 0);
    for (size_t j = 0; j < model->joint_count; j++) {
        const YkJoint *joint = &model->joints[j];
        bool first = joint->body[0] == 0, on_ground = first || joint->body[1] == 0;
        if (!on_ground || yk_drawing_omits(model, joint)) continue;
        if (joint->kind == YK_PIN) {
            add_pedestal(drawing, yk_drawing_pixel(drawing, yk_drawing_joint(drawing, frames, joint, first ? 0 : 1)));
        } else if (first && (joint->kind == YK_SLIDE || joint->kind == YK_PIN_SLOT)) {
            add_rails(drawing, joint);
        } else if (joint->kind != YK_WELD) { // a guide that moves over a block of the ground
            add_pedestal(drawing, yk_drawing_pixel(drawing, yk_drawing_joint(drawing, frames, joint, 1)));
        }
    }
}
