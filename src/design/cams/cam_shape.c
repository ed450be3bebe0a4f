// Makes a shape from the model's cam: where the follower stands at lift 0.
#include <math.h>
#include "design/cams/cam.h"
#include "model/transmissions/cam_place.h"

bool yk_cam_shape_fit(YkCamShape *shape)
{
    double distance = shape->base + shape->roller;
    if (!shape->oscillates) {
        bool is_flat = shape->face == YK_CAM_FACE_FLAT;
        shape->start = is_flat ? shape->base : sqrt((distance - shape->offset) * (distance + shape->offset));
    } else if (shape->face == YK_CAM_FACE_FLAT) {
        shape->start = yk_cam_face_angle(shape->pivot, shape->base + shape->offset, shape->swing);
    } else {
        shape->start = yk_cam_arm_angle(shape->pivot, shape->arm, distance, shape->swing);
    }
    return isfinite(shape->start);
}

YkCamShape yk_cam_shape_of(const YkCam *cam)
{
    YkCamShape shape = {.face = cam->face,
                        .oscillates = cam->oscillates,
                        .turn = cam->turn,
                        .swing = cam->away,
                        .sign = cam->swing * cam->away,
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
    second.sign = -first->sign;
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
