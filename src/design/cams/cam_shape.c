// Makes a shape from the model's cam: where the follower stands at lift 0.
#include <math.h>
#include "design/cams/cam.h"
#include "elementary/elementary.h"

// Returns the angle nu at which f cos(nu - gamma) has this value, on the side where turning by `swing` makes it grow.
static double angle_of(YkVec pivot, double value, double swing)
{
    double gamma = yk_atan2(pivot.y, pivot.x), off = yk_acos(value / yk_norm(pivot));
    return swing > 0 ? gamma - off : gamma + off;
}

// Returns the arm's angle psi: arm, centres and distance R form a triangle with R^2 = f^2 + a^2 + 2 a f cos(psi -
// gamma).
static double arm_angle(const YkCamShape *shape, double distance)
{
    double f = yk_norm(shape->pivot), a = shape->arm;
    double projection = ((distance - a) * (distance + a) - f * f) / (2 * a); // of the pivot on the arm's direction
    return angle_of(shape->pivot, projection, shape->swing);
}

bool yk_cam_shape_fit(YkCamShape *shape)
{
    double distance = shape->base + shape->roller;
    if (!shape->oscillates) {
        bool is_flat = shape->face == YK_CAM_FACE_FLAT;
        shape->start = is_flat ? shape->base : sqrt((distance - shape->offset) * (distance + shape->offset));
    } else if (shape->face == YK_CAM_FACE_FLAT) {
        shape->start = angle_of(shape->pivot, shape->base + shape->offset, shape->swing);
    } else {
        shape->start = arm_angle(shape, distance);
    }
    return isfinite(shape->start);
}

YkCamShape yk_cam_shape_of(const YkCam *cam)
{
    YkCamShape shape = {.face = cam->face,
                        .oscillates = cam->oscillates,
                        .turn = cam->turn,
                        .swing = cam->swing,
                        .sign = 1,
                        .base = cam->base,
                        .roller = cam->roller,
                        .offset = cam->offset,
                        .arm = cam->arm,
                        .along = cam->along,
                        .pivot = cam->pivot};
    yk_cam_shape_fit(&shape);
    return shape;
}

// Seen from its own side, the second follower's lift is the first one's reversed.
YkCamShape yk_cam_shape_second(const YkCamShape *first, const YkCam *cam)
{
    YkCamShape second = *first;
    second.sign = -1;
    second.roller = cam->other_roller;
    if (first->oscillates) {
        second.arm = cam->other_arm;
        second.swing = -first->swing;
        second.start = first->start + cam->other_angle;
        second.base = yk_norm(yk_add(second.pivot, yk_scale(second.arm, yk_unit(second.start)))) - second.roller;
    } else {
        second.along = yk_scale(-1, first->along);
        second.offset = -first->offset;
        second.start = cam->other_span - first->start;
        second.base = yk_hypot(second.start, second.offset) - second.roller;
    }
    return second;
}
