// Draws wheels: pitch circles of gears with a mark at every tooth, pulleys, pinions, base circles of cams.
//
// The marks of two wheels in mesh meet at their pitch point. They are placed so at the drawn pose; since both circles
// roll through the same arc, they meet in every pose. A body has a set of marks for every mesh it takes part in.
#include "picture/drawing/drawing.h"
#include "picture/svg.h"

enum { MARKS_MAX = 400 };

static YkVec center_of(const YkFrame *frames, int32_t body)
{
    return frames[body].origin; // a wheel's centre is the origin of its body
}

double yk_drawing_pitch_radius(const YkGear *gear, int side)
{
    double a = (double)gear->teeth[0], b = (double)gear->teeth[1], sum = gear->is_internal ? b - a : a + b;
    double own = side ? b : a;
    return gear->center_distance > 0 && sum > 0 ? gear->center_distance * own / sum : 0.5 * gear->module * own;
}

static void set_style(YkText *style, size_t body, double width, const char *dashes)
{
    yk_text_clear(style);
    yk_text_format(style, "fill=\"none\" stroke=\"%s\" stroke-width=\"", yk_drawing_colour(body).edge);
    yk_svg_number(style, width);
    yk_text_format(style, "\"%s", dashes);
}

// Draws a circle in the body's colour, in its group.
static void add_circle(YkDrawing *drawing, YkVec center, double radius, size_t body, const char *dashes, YkText *style)
{
    if (!(radius > 0)) return;
    set_style(style, body, fmin(1.3, 0.2 * drawing->bar), dashes);
    yk_drawing_group(drawing, body);
    yk_svg_circle(&drawing->svg, yk_drawing_pixel(drawing, center), radius * drawing->scale, yk_text_get(style));
    yk_drawing_ungroup(drawing);
}

// Draws a mark at every tooth, the first at the given angle (world, rad); inwards, or outwards on a ring.
static void add_marks(YkDrawing *drawing, YkVec center, double radius, double first, int64_t teeth, double way,
                      size_t body, YkText *style)
{
    double pitch = 2 * YK_PI * radius / (double)teeth, length = 0.35 * pitch;
    if (teeth > MARKS_MAX || pitch * drawing->scale < 2) return; // they would merge
    set_style(style, body, fmin(1, 0.15 * drawing->bar), "");
    yk_drawing_group(drawing, body);
    for (int64_t k = 0; k < teeth; k++) {
        YkVec e = yk_unit(first + 2 * YK_PI * (double)k / (double)teeth);
        YkVec from = yk_drawing_pixel(drawing, yk_add(center, yk_scale(radius, e)));
        YkVec to = yk_drawing_pixel(drawing, yk_add(center, yk_scale(radius + way * length, e)));
        yk_svg_line(&drawing->svg, from, to, yk_text_get(style));
    }
    yk_drawing_ungroup(drawing);
}

// The first wheel's marks follow its own axes; the second's start where the first's nearest mark is off the pitch
// point.
static void add_pair(YkDrawing *drawing, const YkFrame *frames, const YkGear *gear, YkText *style)
{
    YkVec a = center_of(frames, gear->body[0]), b = center_of(frames, gear->body[1]), line = yk_sub(b, a);
    double ra = yk_drawing_pitch_radius(gear, 0), rb = yk_drawing_pitch_radius(gear, 1);
    if (!(ra > 0) || !(rb > 0)) return;
    add_circle(drawing, a, ra, (size_t)gear->body[0], "", style);
    add_circle(drawing, b, rb, (size_t)gear->body[1], "", style);
    double toward = yk_atan2(line.y, line.x) + (gear->is_internal ? YK_PI : 0); // from a's centre to the pitch point
    double own = yk_atan2(frames[gear->body[0]].axis.y, frames[gear->body[0]].axis.x);
    double step = 2 * YK_PI / (double)gear->teeth[0], off = own - toward - step * rint((own - toward) / step);
    double back = gear->is_internal ? toward : toward + YK_PI; // from b's centre to the pitch point
    double other = back + (gear->is_internal ? off : -off) * ra / rb;
    add_marks(drawing, a, ra, own, gear->teeth[0], -1, (size_t)gear->body[0], style);
    add_marks(drawing, b, rb, other, gear->teeth[1], gear->is_internal ? 1 : -1, (size_t)gear->body[1], style);
}

// Draws the straight runs of a belt: outer tangents, or inner ones if it is crossed.
static void add_belt(YkDrawing *drawing, const YkFrame *frames, const YkBelt *belt, YkText *style)
{
    YkVec a = center_of(frames, belt->body[0]), b = center_of(frames, belt->body[1]), line = yk_sub(b, a);
    double length = yk_norm(line), turn = (belt->radius[0] + (belt->is_crossed ? 1 : -1) * belt->radius[1]) / length;
    for (int k = 0; k < 2; k++) add_circle(drawing, k ? b : a, belt->radius[k], (size_t)belt->body[k], "", style);
    if (!(length > 0) || !(fabs(turn) <= 1)) return;
    yk_drawing_group(drawing, (size_t)belt->carrier);
    for (int side = -1; side <= 1; side += 2) {
        YkVec out = yk_mul(yk_scale(1 / length, line), yk_vec(turn, side * sqrt(1 - turn * turn)));
        YkVec from = yk_add(a, yk_scale(belt->radius[0], out));
        YkVec to = yk_add(b, yk_scale(belt->is_crossed ? -belt->radius[1] : belt->radius[1], out));
        yk_svg_line(&drawing->svg, yk_drawing_pixel(drawing, from), yk_drawing_pixel(drawing, to), yk_text_get(style));
    }
    yk_drawing_ungroup(drawing);
}

void yk_drawing_wheels(YkDrawing *drawing, const YkFrame *frames)
{
    const YkModel *model = drawing->model;
    YkText style = {0};
    for (size_t k = 0; k < model->gear_count; k++) add_pair(drawing, frames, &model->gears[k], &style);
    for (size_t k = 0; k < model->belt_count; k++)
        if (!model->belts[k].is_lock) add_belt(drawing, frames, &model->belts[k], &style);
    for (size_t k = 0; k < model->rack_count; k++)
        add_circle(drawing, center_of(frames, model->racks[k].pinion), model->racks[k].radius,
                   (size_t)model->racks[k].pinion, "", &style);
    for (size_t k = 0; k < model->cam_count; k++) {
        const YkCam *cam = &model->cams[k];
        const YkJoint *pin = &model->joints[cam->cam_joint];
        YkVec at = yk_drawing_joint(drawing, frames, pin, pin->body[1] == cam->cam);
        add_circle(drawing, at, cam->base, (size_t)cam->cam, " stroke-dasharray=\"4 3\"", &style);
    }
    yk_text_free(&style);
}

void yk_drawing_each_wheel(const YkDrawing *drawing, const YkFrame *frames, int32_t body, YkSeeWheel *see,
                           void *context)
{
    const YkModel *model = drawing->model;
    YkVec own = frames ? center_of(frames, body) : yk_vec(0, 0);
    for (size_t k = 0; k < model->gear_count; k++)
        for (int side = 0; side < 2; side++)
            if (model->gears[k].body[side] == body)
                see(context, own, yk_drawing_pitch_radius(&model->gears[k], side), false);
    for (size_t k = 0; k < model->belt_count; k++)
        for (int side = 0; side < 2; side++)
            if (model->belts[k].body[side] == body && !model->belts[k].is_lock)
                see(context, own, model->belts[k].radius[side], false);
    for (size_t k = 0; k < model->rack_count; k++)
        if (model->racks[k].pinion == body) see(context, own, model->racks[k].radius, false);
    for (size_t k = 0; k < model->cam_count; k++) {
        const YkJoint *pin = &model->joints[model->cams[k].cam_joint];
        if (model->cams[k].cam != body) continue;
        YkVec at = frames ? yk_drawing_joint(drawing, frames, pin, pin->body[1] == body) : own;
        see(context, at, model->cams[k].base, true);
    }
}

static void raise_reach(void *context, YkVec center, double radius, bool is_base)
{
    double *reach = context;
    (void)center;
    (void)is_base;
    *reach = fmax(*reach, radius);
}

void yk_drawing_wheel_reach(const YkDrawing *drawing, int32_t body, double *reach)
{
    yk_drawing_each_wheel(drawing, NULL, body, raise_reach, reach);
}

typedef struct WheelPen {
    YkDrawing *drawing;
    size_t body;
    YkText style;
} WheelPen;

static void draw_wheel(void *context, YkVec center, double radius, bool is_base)
{
    WheelPen *pen = context;
    add_circle(pen->drawing, center, radius, pen->body, is_base ? " stroke-dasharray=\"4 3\"" : "", &pen->style);
}

void yk_drawing_body_wheels(YkDrawing *drawing, const YkFrame *frames, int32_t body)
{
    WheelPen pen = {.drawing = drawing, .body = (size_t)body};
    yk_drawing_each_wheel(drawing, frames, body, draw_wheel, &pen);
    yk_text_free(&pen.style);
}
