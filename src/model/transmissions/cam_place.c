// Places a cam and its follower by their joints, and judges whether they can touch.
#include "model/transmissions/cam_place.h"
#include <math.h>
#include <string.h>
#include "elementary/elementary.h"

enum { LIFT_SAMPLES = 720 };

// The angle nu at which f cos(nu - gamma) has this value, on the side where turning in the sense `away` makes it grow.
double yk_cam_face_angle(YkVec pivot, double distance, double away)
{
    return yk_atan2(pivot.y, pivot.x) - away * yk_acos(distance / yk_norm(pivot));
}

// Arm, centres and distance R form a triangle with R^2 = f^2 + a^2 + 2 a f cos(psi - gamma).
double yk_cam_arm_angle(YkVec pivot, double arm, double distance, double away)
{
    double f = yk_norm(pivot);
    double projection =
        ((distance - arm) * (distance + arm) - f * f) / (2 * arm); // of the pivot on the arm's direction
    return yk_cam_face_angle(pivot, projection, away);
}

bool yk_cam_touch(const YkCam *cam, YkVec *touch)
{
    bool is_flat = cam->face == YK_CAM_FACE_FLAT;
    double distance = cam->base + (is_flat ? cam->offset : cam->roller);
    if (!cam->is_apart) return false;
    *touch = yk_unit(is_flat ? yk_cam_face_angle(cam->pivot, distance, cam->away)
                             : yk_cam_arm_angle(cam->pivot, cam->arm, distance, cam->away));
    if (!is_flat) *touch = yk_scale(cam->arm, *touch);
    return true;
}

bool yk_cam_pair_holds(const YkCam *cam)
{
    double reach = cam->base + cam->roller, aside = cam->offset;
    YkVec arm;
    if (!cam->oscillates) return cam->other_span > sqrt(fmax(reach * reach - aside * aside, 0));
    if (!yk_cam_touch(cam, &arm)) return true; // nothing decides
    return cam->away * yk_cross(yk_mul(yk_unit(cam->other_angle), arm), cam->pivot) < 0;
}

static void place_slide(const YkJoint *guide, int side, YkVec apart, YkCam *cam)
{
    cam->along = side == 0 ? guide->along : yk_scale(-1, yk_mul(guide->along, yk_unit(-guide->turned)));
    // The offset of the guide's line.
    if (!cam->offset_expr) cam->offset = yk_dot(apart, yk_scale(-1, yk_quarter(cam->along)));
}

// Returns whether a falling lift leads away from the cam: the arm lies on that side, and the law goes below 0. Arcs
// have no law yet, and theirs follows the arm.
static bool falls_away(const YkModel *model, const YkCam *cam, YkVec arm)
{
    const YkLaw *law = cam->law == YK_NONE ? NULL : model->laws[cam->law].law;
    return cam->swing * yk_cross(arm, cam->pivot) < 0 && !(law && yk_cam_lowest_lift(law) > -1e-9);
}

// Finds arm and centres from points or keys; if two pins share one place, the file gives their distance.
static void place_pivot(const YkModel *model, const YkJoint *pin, YkVec apart, YkCam *cam)
{
    cam->pivot = apart;
    cam->is_apart = yk_norm(apart) > 1e-12 * (cam->base + cam->roller);
    if (cam->point != YK_NONE) {
        int side = pin->body[0] == cam->follower ? 0 : 1;
        YkVec arm = yk_sub(model->points[cam->point].at, pin->at[side]);
        cam->arm = yk_norm(arm);
        if (falls_away(model, cam, arm)) cam->away = -cam->swing;
    }
    if (!cam->centers_expr)
        cam->centers = yk_norm(apart);
    else if (!cam->is_apart)
        cam->pivot = yk_vec(cam->centers, 0);
    if (cam->is_conjugate && !cam->other_arm_expr) cam->other_arm = cam->arm;
}

void yk_cam_place(const YkModel *model, YkCam *cam)
{
    const YkJoint *pin = &model->joints[cam->cam_joint], *guide = &model->joints[cam->follower_joint];
    int pin_side = pin->body[0] == cam->carrier ? 0 : 1, guide_side = guide->body[0] == cam->carrier ? 0 : 1;
    YkVec apart = yk_sub(guide->at[guide_side], pin->at[pin_side]);
    cam->turn = pin_side == 0 ? 1 : -1;
    cam->away = cam->swing = guide_side == 0 ? 1 : -1;
    if (cam->oscillates)
        place_pivot(model, guide, apart, cam);
    else
        place_slide(guide, guide_side, apart, cam);
}

size_t yk_cam_pair_exprs(const YkModel *model, const YkCam *cam, const YkExpr *expr[YK_CAM_EXPRS])
{
    if (!cam->is_conjugate) return 0;
    const YkPoint *point = cam->point == YK_NONE ? NULL : &model->points[cam->point];
    const YkExpr *const all[YK_CAM_EXPRS] = {cam->other_span_expr, cam->other_arm_expr,     cam->other_angle_expr,
                                             cam->arm_expr,        point ? point->x : NULL, point ? point->y : NULL};
    memcpy(expr, all, sizeof all);
    return YK_CAM_EXPRS;
}

bool yk_cam_centers_agree(const YkCam *cam)
{
    double apart = yk_norm(cam->pivot);
    return !cam->oscillates || fabs(cam->centers - apart) <= 1e-9 * apart;
}

double yk_cam_lowest_lift(const YkLaw *law)
{
    YkLawRange range = yk_law_range(law);
    double low = INFINITY, d[YK_LAW_ORDER + 1];
    for (int i = 0; i <= LIFT_SAMPLES; i++) {
        yk_law_eval(law, range.from + (range.to - range.from) * i / LIFT_SAMPLES, d);
        low = fmin(low, d[0]);
    }
    return low;
}

static YkCamFault fault_of_slide(const YkCam *cam, double lowest)
{
    double size = cam->base + cam->roller;
    double start = cam->face == YK_CAM_FACE_FLAT ? cam->base : sqrt(fmax(size * size - cam->offset * cam->offset, 0));
    if (cam->face != YK_CAM_FACE_FLAT && !(fabs(cam->offset) < size)) return YK_CAM_OFFSET;
    return start + lowest > 0 ? YK_CAM_FITS : YK_CAM_LIFT;
}

YkCamFault yk_cam_fault(const YkCam *cam, double lowest)
{
    double size = cam->base + cam->roller;
    if (!cam->oscillates) return fault_of_slide(cam, lowest);
    if (!(cam->centers > 0)) return YK_CAM_CENTERS;
    if (cam->face == YK_CAM_FACE_FLAT)
        return fabs(cam->base + cam->offset) < cam->centers ? YK_CAM_FITS : YK_CAM_FLAT_LARGE;
    if (!(cam->arm > 0)) return YK_CAM_ARM;
    return size > fabs(cam->centers - cam->arm) && size < cam->centers + cam->arm ? YK_CAM_FITS : YK_CAM_REACH;
}
