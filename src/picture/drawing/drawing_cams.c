// Draws cams: their outlines, and what rides on them - a roller, a flat face or an edge - with its stem or arm.
//
// The outline is in the cam's axes and turns with it. The follower's part is drawn where it touches the cam. The model
// only measures the lift from the base circle, so a follower that is attached to nothing but its guide is drawn moved
// to where its point rides.
#include <stdlib.h>
#include "elementary/elementary.h"
#include "picture/drawing/drawing.h"
#include "picture/svg.h"

static const double tolerance = 2e-3; // of the base circle: largest error of an outline

// The drawing of a cam: outlines in the cam's axes; roller, edge or contact of the face at one lift, and the normal
// there, in the carrier's axes from the cam's centre.
struct YkDrawnCam {
    YkVec *surface, *outer;
    size_t surface_count, outer_count;
    YkVec at, normal;
    double lift, reach; // reach: the farthest of the outline, m
    YkVec shift;        // of a translating follower, in the carrier's axes, m
    double turn;        // of an oscillating one about its pivot, rad
};

static bool take_curve(const YkCamDesign *design, YkCamCurve curve, double base, YkVec **points, size_t *count)
{
    YkCamVertex *vertices;
    if (yk_cam_profile(design, curve, tolerance * base, 0, &vertices, count) != YK_OK) return false;
    *points = calloc(*count + 1, sizeof **points);
    for (size_t i = 0; *points && i < *count; i++) (*points)[i] = yk_vec(vertices[i].x, vertices[i].y);
    yk_cam_vertices_free(vertices);
    return *points != NULL;
}

static size_t joints_of(const YkModel *model, int32_t body)
{
    size_t count = 0;
    for (size_t j = 0; j < model->joint_count; j++)
        count += model->joints[j].body[0] == body || model->joints[j].body[1] == body;
    return count;
}

// Finds the vector from the follower's point in the model at this lift to where it rides. The point is `at:` of one
// that swings, and the guide's point of one that slides, if the guide's line begins at the cam's centre.
static void find_shift(const YkModel *model, const YkCam *cam, YkDrawnCam *own)
{
    const YkJoint *guide = &model->joints[cam->follower_joint], *pin = &model->joints[cam->cam_joint];
    int side = guide->body[1] == cam->follower;
    YkVec center = pin->at[pin->body[1] == cam->carrier], held = guide->at[side],
          base = yk_sub(guide->at[!side], center);
    YkVec point = cam->point == YK_NONE ? held : model->points[cam->point].at;
    if (joints_of(model, cam->follower) != 1) return;
    if (cam->oscillates) {
        YkVec arm = yk_mul(yk_unit(cam->swing * own->lift), yk_sub(point, held)), ridden = yk_sub(own->at, cam->pivot);
        if (cam->face != YK_CAM_FACE_FLAT && yk_norm(arm) > 0)
            own->turn = yk_atan2(yk_cross(arm, ridden), yk_dot(arm, ridden));
    } else if (side == 1) {
        YkVec there =
            yk_add(base, yk_add(yk_scale(own->lift, cam->along), yk_mul(yk_unit(guide->turned), yk_sub(point, held))));
        YkVec apart = yk_sub(own->at, there);
        bool begins_there = fabs(yk_dot(base, cam->along)) < 1e-9 * cam->base;
        if (begins_there) own->shift = yk_scale(yk_dot(apart, cam->along), cam->along);
    }
}

static bool take(const YkModel *model, size_t k, YkDrawnCam *own)
{
    YkCamDesign *design = yk_cam_design_new(model, k);
    if (!design) return false;
    const YkCam *cam = &model->cams[k];
    YkCamPoint point = yk_cam_at(design, 0); // the cam's axes are here the carrier's
    const double *at = cam->face == YK_CAM_FACE_FLAT ? point.surface : point.pitch;
    own->at = yk_vec(at[0], at[1]);
    own->normal = yk_vec(point.normal[0], point.normal[1]);
    own->lift = point.lift[0];
    find_shift(model, cam, own);
    bool good = take_curve(design, YK_CAM_CURVE_SURFACE, cam->base, &own->surface, &own->surface_count);
    if (cam->is_groove)
        good = good && take_curve(design, YK_CAM_CURVE_OUTER, cam->base, &own->outer, &own->outer_count);
    for (size_t i = 0; good && i < own->surface_count; i++) own->reach = fmax(own->reach, yk_norm(own->surface[i]));
    for (size_t i = 0; good && i < own->outer_count; i++) own->reach = fmax(own->reach, yk_norm(own->outer[i]));
    yk_cam_design_free(design);
    return good;
}

bool yk_drawing_take_cams(YkDrawing *drawing)
{
    drawing->cams = calloc(drawing->model->cam_count + 1, sizeof *drawing->cams);
    bool good = drawing->cams != NULL;
    for (size_t k = 0; good && k < drawing->model->cam_count; k++) good = take(drawing->model, k, &drawing->cams[k]);
    return good;
}

void yk_drawing_free_cams(YkDrawing *drawing)
{
    for (size_t k = 0; drawing->cams && k < drawing->model->cam_count; k++) {
        free(drawing->cams[k].surface);
        free(drawing->cams[k].outer);
    }
    free(drawing->cams);
}

double yk_drawing_cam_reach(const YkDrawing *drawing, size_t cam)
{
    return drawing->cams[cam].reach;
}

// --- Where the follower is

// Returns the frame of the carrier with its origin at the cam's centre.
static YkFrame carrier_frame(const YkDrawing *drawing, const YkFrame *frames, const YkCam *cam)
{
    const YkJoint *pin = &drawing->model->joints[cam->cam_joint];
    return (YkFrame){yk_drawing_joint(drawing, frames, pin, pin->body[1] == cam->carrier), frames[cam->carrier].axis};
}

YkVec yk_drawing_cam_center(const YkDrawing *drawing, const YkFrame *frames, size_t cam)
{
    return carrier_frame(drawing, frames, &drawing->model->cams[cam]).origin;
}

// Returns the follower's coordinate at a pose; an angle within half a turn.
static double lift_of(const YkDrawing *drawing, const YkFrame *frames, size_t k)
{
    const YkCam *cam = &drawing->model->cams[k];
    const YkJoint *guide = &drawing->model->joints[cam->follower_joint];
    YkVec first = frames[guide->body[0]].axis, second = frames[guide->body[1]].axis;
    if (cam->oscillates)
        return yk_atan2(yk_cross(first, second), yk_dot(first, second)) - cam->swing * drawing->cams[k].turn;
    YkVec apart = yk_sub(yk_drawing_joint(drawing, frames, guide, 1), yk_drawing_joint(drawing, frames, guide, 0));
    return yk_dot(apart, yk_mul(first, guide->along)) - yk_dot(drawing->cams[k].shift, cam->along);
}

double yk_drawing_follower_turn(const YkDrawing *drawing, size_t body)
{
    for (size_t k = 0; k < drawing->model->cam_count; k++)
        if ((size_t)drawing->model->cams[k].follower == body) return drawing->cams[k].turn;
    return 0;
}

void yk_drawing_move_followers(const YkDrawing *drawing, YkFrame *frames)
{
    for (size_t k = 0; k < drawing->model->cam_count && !drawing->keeps_followers; k++) {
        const YkCam *cam = &drawing->model->cams[k];
        const YkDrawnCam *own = &drawing->cams[k];
        const YkJoint *guide = &drawing->model->joints[cam->follower_joint];
        YkFrame *frame = &frames[cam->follower];
        YkVec pivot = yk_drawing_joint(drawing, frames, guide, guide->body[1] == cam->follower),
              turn = yk_unit(own->turn);
        if (cam->oscillates) {
            frame->origin = yk_add(pivot, yk_mul(turn, yk_sub(frame->origin, pivot)));
            frame->axis = yk_mul(turn, frame->axis);
        } else {
            frame->origin = yk_add(frame->origin, yk_mul(frames[cam->carrier].axis, own->shift));
        }
    }
}

typedef struct Rider {
    YkVec at, normal; // world
} Rider;

static Rider rider_of(const YkDrawing *drawing, const YkFrame *frames, size_t k)
{
    const YkCam *cam = &drawing->model->cams[k];
    const YkDrawnCam *own = &drawing->cams[k];
    YkFrame carrier = carrier_frame(drawing, frames, cam);
    double risen = lift_of(drawing, frames, k) - own->lift;
    if (!cam->oscillates) {
        YkVec at = yk_add(own->at, yk_scale(risen, cam->along));
        return (Rider){yk_frame_apply(carrier, at), yk_mul(carrier.axis, own->normal)};
    }
    YkVec turn = yk_unit(cam->swing * risen), at = yk_mul(turn, yk_sub(own->at, cam->pivot));
    return (Rider){yk_frame_apply(carrier, yk_add(cam->pivot, at)), yk_mul(carrier.axis, yk_mul(turn, own->normal))};
}

YkVec yk_drawing_rider(const YkDrawing *drawing, const YkFrame *frames, size_t cam)
{
    return rider_of(drawing, frames, cam).at;
}

// --- Drawing

static void add_curve(YkDrawing *drawing, YkFrame frame, const YkVec *points, size_t count, const YkText *style)
{
    YkVec *pixels = calloc(count + 1, sizeof *pixels);
    if (!pixels) drawing->svg.failed = true;
    for (size_t i = 0; pixels && i < count; i++)
        pixels[i] = yk_drawing_pixel(drawing, yk_frame_apply(frame, points[i]));
    if (pixels) yk_svg_polygon(&drawing->svg, pixels, count, yk_text_get(style));
    free(pixels);
}

static void add_outline(YkDrawing *drawing, const YkFrame *frames, size_t k, YkText *style)
{
    const YkCam *cam = &drawing->model->cams[k];
    const YkDrawnCam *own = &drawing->cams[k];
    YkFrame frame = {carrier_frame(drawing, frames, cam).origin, frames[cam->cam].axis};
    YkColour colour = yk_drawing_colour((size_t)cam->cam);
    yk_drawing_group(drawing, (size_t)cam->cam);
    yk_drawing_style(style, cam->is_groove ? "none" : colour.fill, colour.edge, fmin(1.3, 0.2 * drawing->bar));
    add_curve(drawing, frame, own->surface, own->surface_count, style);
    if (own->outer) add_curve(drawing, frame, own->outer, own->outer_count, style);
    yk_drawing_ungroup(drawing);
}

// Draws the stem or arm from the follower's joint to what rides.
static void add_rider(YkDrawing *drawing, const YkFrame *frames, size_t k, YkText *style)
{
    const YkCam *cam = &drawing->model->cams[k];
    const YkJoint *guide = &drawing->model->joints[cam->follower_joint];
    YkColour colour = yk_drawing_colour((size_t)cam->follower);
    Rider rider = rider_of(drawing, frames, k);
    YkVec at = yk_drawing_pixel(drawing, rider.at), along = yk_conj(yk_quarter(rider.normal));
    YkVec held = yk_drawing_joint(drawing, frames, guide, guide->body[1] == cam->follower);
    double half = 0.6 * cam->base * drawing->scale;
    yk_drawing_group(drawing, (size_t)cam->follower);
    yk_drawing_style(style, "none", colour.edge, fmax(1, 0.35 * drawing->bar));
    yk_svg_line(&drawing->svg, at, yk_drawing_pixel(drawing, held), yk_text_get(style));
    if (cam->face == YK_CAM_FACE_FLAT) {
        yk_drawing_style(style, "none", colour.edge, fmax(1.5, 0.4 * drawing->bar));
        yk_svg_line(&drawing->svg, yk_sub(at, yk_scale(half, along)), yk_add(at, yk_scale(half, along)),
                    yk_text_get(style));
    } else if (cam->roller > 0) {
        yk_drawing_style(style, colour.fill, colour.edge, fmin(1.3, 0.2 * drawing->bar));
        yk_svg_circle(&drawing->svg, at, cam->roller * drawing->scale, yk_text_get(style));
    }
    yk_drawing_ungroup(drawing);
}

void yk_drawing_cams(YkDrawing *drawing, const YkFrame *frames)
{
    YkText style = {0};
    for (size_t k = 0; k < drawing->model->cam_count; k++) {
        add_outline(drawing, frames, k, &style);
        add_rider(drawing, frames, k, &style);
    }
    yk_text_free(&style);
}
