// Drawings that move: everything of a body is in groups with its class, written at the reference pose. Another pose is
// shown by moving the groups: a turn about the former place of the body's origin, then a shift to the new one.
#include "base/escape.h"
#include "picture/drawing/drawing.h"
#include "picture/svg.h"

YkShift yk_drawing_shift(const YkDrawing *drawing, size_t body, size_t pose)
{
    YkFrame from = yk_drawing_frames(drawing, yk_drawing_reference(drawing))[body];
    YkFrame to = yk_drawing_frames(drawing, pose)[body];
    YkVec center = yk_drawing_pixel(drawing, from.origin);
    return (YkShift){.by = yk_sub(yk_drawing_pixel(drawing, to.origin), center),
                     .turn = -yk_atan2(yk_cross(from.axis, to.axis), yk_dot(from.axis, to.axis)),
                     .center = center};
}

static void add_number(YkText *svg, double value) // degrees need more digits than pixels do
{
    yk_text_format(svg, "%e", fabs(value) < 1e-7 ? 0 : value);
}

static void add_attribute(YkDrawing *drawing, YkShift shift)
{
    YkText *svg = &drawing->svg;
    yk_text_puts(svg, " transform=\"translate(");
    add_number(svg, shift.by.x);
    yk_text_puts(svg, " ");
    add_number(svg, shift.by.y);
    if (shift.turn != 0) {
        yk_text_puts(svg, ") rotate(");
        add_number(svg, shift.turn * 180 / YK_PI);
        yk_text_puts(svg, " ");
        add_number(svg, shift.center.x);
        yk_text_puts(svg, " ");
        add_number(svg, shift.center.y);
    }
    yk_text_puts(svg, ")\"");
}

static void open_group(YkDrawing *drawing, char kind, size_t index, YkShift shift)
{
    yk_text_format(&drawing->svg, "<g class=\"%c%z\"", kind, index);
    if (drawing->shown != yk_drawing_reference(drawing)) add_attribute(drawing, shift);
    yk_text_puts(&drawing->svg, ">\n");
}

static void add_numbers(YkText *svg, const char *before, double a, double b)
{
    yk_text_format(svg, "%s%g %g)", before, a == 0 ? 0.0 : a, b == 0 ? 0.0 : b);
}

// Opens the group of a body in a scene, which is three nested ones: the world in metres, y up; the body, at its pose;
// and the way back from the pixels in which everything is written.
static void open_scene_group(YkDrawing *drawing, size_t body)
{
    YkText *svg = &drawing->svg;
    YkFrame frame = yk_drawing_frames(drawing, yk_drawing_reference(drawing))[body];
    YkVec zero = yk_drawing_pixel(drawing, yk_vec(0, 0)), origin = yk_drawing_pixel(drawing, frame.origin);
    double turn = yk_atan2(frame.axis.y, frame.axis.x) * 180 / YK_PI;
    add_numbers(svg, "<g transform=\"translate(", zero.x, zero.y);
    add_numbers(svg, " scale(", drawing->scale, -drawing->scale);
    yk_text_puts(svg, "\"><g data-body=\"");
    yk_escape_xml(svg, drawing->model->bodies[body].name);
    add_numbers(svg, "\" transform=\"translate(", frame.origin.x, frame.origin.y);
    yk_text_format(svg, " rotate(%g)\"><g transform=\"rotate(%g)", turn, -turn);
    add_numbers(svg, " scale(", 1 / drawing->scale, -1 / drawing->scale);
    add_numbers(svg, " translate(", -origin.x, -origin.y);
    yk_text_puts(svg, "\">\n");
}

void yk_drawing_group(YkDrawing *drawing, size_t body)
{
    if (drawing->is_scene)
        open_scene_group(drawing, body);
    else if (drawing->options.moving)
        open_group(drawing, 'b', body, yk_drawing_shift(drawing, body, drawing->shown));
}

void yk_drawing_group_name(YkDrawing *drawing, char kind, size_t index, YkVec from, YkVec to)
{
    if (!drawing->options.moving) return;
    YkVec by = yk_sub(yk_drawing_pixel(drawing, to), yk_drawing_pixel(drawing, from));
    open_group(drawing, kind, index, (YkShift){.by = by});
}

void yk_drawing_ungroup(YkDrawing *drawing)
{
    if (drawing->options.moving) yk_text_puts(&drawing->svg, drawing->is_scene ? "</g></g></g>\n" : "</g>\n");
}

// --- Keyframes

// Returns where a body or name is at a pose.
typedef YkShift ShiftOf(const YkDrawing *drawing, size_t index, size_t pose);

static YkShift joint_shift(const YkDrawing *drawing, size_t joint, size_t pose)
{
    const YkJoint *of = &drawing->model->joints[joint];
    const YkFrame *from = yk_drawing_frames(drawing, yk_drawing_reference(drawing)),
                  *to = yk_drawing_frames(drawing, pose);
    return (YkShift){.by = yk_sub(yk_drawing_pixel(drawing, yk_drawing_joint(drawing, to, of, 1)),
                                  yk_drawing_pixel(drawing, yk_drawing_joint(drawing, from, of, 1)))};
}

static YkShift name_shift(const YkDrawing *drawing, size_t body, size_t pose)
{
    const YkFrame *from = yk_drawing_frames(drawing, yk_drawing_reference(drawing)),
                  *to = yk_drawing_frames(drawing, pose);
    return (YkShift){.by = yk_sub(yk_drawing_pixel(drawing, yk_drawing_middle(drawing, to, body)),
                                  yk_drawing_pixel(drawing, yk_drawing_middle(drawing, from, body)))};
}

static bool stands_still(const YkDrawing *drawing, ShiftOf *shift, size_t index)
{
    for (size_t pose = 0; pose < drawing->pose_count; pose++) {
        YkShift at = shift(drawing, index, pose);
        if (yk_norm(at.by) > 0.005 || fabs(at.turn) > 1e-5) return false;
    }
    return true;
}

// Turns are counted from pose to pose, so that a whole turn is one.
static void add_keyframes(YkDrawing *drawing, char kind, size_t index, ShiftOf *shift, const char *timing)
{
    YkText *svg = &drawing->svg;
    double turn = 0;
    if (stands_still(drawing, shift, index)) return;
    yk_text_format(svg, "@keyframes %c%z {", kind, index);
    for (size_t pose = 0; pose < drawing->pose_count; pose++) {
        YkShift at = shift(drawing, index, pose);
        turn = pose == 0 ? at.turn : turn + yk_remainder(at.turn - turn, 2 * YK_PI);
        yk_svg_number(svg, drawing->pose_count > 1 ? 100 * (double)pose / (double)(drawing->pose_count - 1) : 0);
        yk_text_puts(svg, "%{transform:translate(");
        yk_svg_number(svg, at.by.x);
        yk_text_puts(svg, "px,");
        yk_svg_number(svg, at.by.y);
        yk_text_puts(svg, "px)");
        if (kind == 'b') {
            yk_text_puts(svg, " rotate(");
            yk_svg_number(svg, turn * 180 / YK_PI);
            yk_text_puts(svg, "deg)");
        }
        yk_text_puts(svg, "}");
    }
    YkShift at = shift(drawing, index, 0);
    yk_text_format(svg, "}\n.%c%z{animation:%c%z %s", kind, index, kind, index, timing);
    if (kind == 'b') {
        yk_text_puts(svg, ";transform-origin:");
        yk_svg_number(svg, at.center.x);
        yk_text_puts(svg, "px ");
        yk_svg_number(svg, at.center.y);
        yk_text_puts(svg, "px");
    }
    yk_text_puts(svg, "}\n");
}

void yk_drawing_keyframes(YkDrawing *drawing, double seconds, bool to_and_fro)
{
    YkText timing = {0};
    yk_text_format(&timing, "%es linear infinite%s", seconds, to_and_fro ? " alternate" : "");
    yk_text_puts(&drawing->svg, "<style>\n");
    for (size_t b = 1; b < drawing->model->body_count; b++)
        add_keyframes(drawing, 'b', b, yk_drawing_shift, yk_text_get(&timing));
    for (size_t j = 0; drawing->options.labels && j < drawing->model->joint_count; j++)
        add_keyframes(drawing, 'j', j, joint_shift, yk_text_get(&timing));
    for (size_t b = 1; drawing->options.labels && b < drawing->model->body_count; b++)
        add_keyframes(drawing, 'n', b, name_shift, yk_text_get(&timing));
    yk_text_puts(&drawing->svg, "@media (prefers-reduced-motion:reduce){g{animation:none!important}}\n</style>\n");
    yk_text_free(&timing);
}
