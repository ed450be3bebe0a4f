// The second pass over cams: what follows from the joints, and whether the sizes are possible.
#include <math.h>
#include "base/number.h"
#include "model/load.h"
#include "model/transmissions/cam_place.h"

// Writes a length as the file would give it.
static const char *length_text(YkLoader *loader, double value)
{
    YkText *text = &loader->text;
    char number[YK_NUMBER_SIZE];
    double size = 1;
    const char *unit = yk_model_unit(loader->model, YK_QUANTITY_LENGTH, &size);
    yk_number_write_digits(value / size, 6, number);
    yk_text_clear(text);
    yk_text_format(text, "%s %s", number, unit);
    return yk_text_get(text);
}

static YkPlace place_of(const YkCam *cam, const YkExpr *expr)
{
    return expr ? expr->place : cam->place;
}

static void refuse_size(YkLoader *loader, const YkCam *cam, const YkExpr *expr, const char *what)
{
    yk_problem(loader->problems, YK_CODE_CAM_SIZE, place_of(cam, expr), "cam %q: %s", cam->name, what);
}

static void check_centers(YkLoader *loader, const YkCam *cam)
{
    if (!cam->centers_expr || yk_cam_centers_agree(cam)) return;
    yk_problem(loader->problems, YK_CODE_CAM_SIZE, cam->centers_expr->place,
               "cam %q: `centers` disagrees with the points of the two pins, which are %s apart", cam->name,
               length_text(loader, yk_norm(cam->pivot)));
}

static bool check_positive(YkLoader *loader, const YkCam *cam, const YkExpr *expr, double value, const char *key)
{
    if (!expr || value > 0 || isnan(value)) return true;
    yk_problem(loader->problems, YK_CODE_CAM_SIZE, expr->place, "cam %q: `%s` must be a length greater than zero",
               cam->name, key);
    return false;
}

static bool check_signs(YkLoader *loader, const YkCam *cam)
{
    bool good = check_positive(loader, cam, cam->base_expr, cam->base, "base");
    good &= check_positive(loader, cam, cam->roller_expr, cam->roller, "roller");
    good &= check_positive(loader, cam, cam->arm_expr, cam->arm, "arm");
    good &= check_positive(loader, cam, cam->centers_expr, cam->centers, "centers");
    good &= check_positive(loader, cam, cam->other_roller_expr, cam->other_roller, "roller");
    good &= check_positive(loader, cam, cam->other_arm_expr, cam->other_arm, "arm");
    good &= check_positive(loader, cam, cam->other_span_expr, cam->other_span, "span");
    return good;
}

// Warns if the file's geometry puts the roller or edge elsewhere while the follower's angle is 0.
static void warn_of_place(YkLoader *loader, const YkCam *cam)
{
    const YkModel *model = loader->model;
    const YkJoint *pin = &model->joints[cam->follower_joint];
    double asked = cam->base + cam->roller;
    if (cam->point == YK_NONE || cam->face == YK_CAM_FACE_FLAT) return;
    YkVec arm = yk_sub(model->points[cam->point].at, pin->at[pin->body[0] == cam->follower ? 0 : 1]);
    double found = yk_norm(yk_add(cam->pivot, arm));
    bool is_lifted = cam->away * yk_cross(arm, cam->pivot) > 0;
    if (fabs(found - asked) <= 1e-4 * asked && is_lifted) return;
    YkText words = {0};
    yk_text_format(&words, "%s", length_text(loader, found));
    yk_problem(loader->problems, YK_CODE_CAM_TURNED, cam->place,
               "cam %q: at lift 0 the point %q lies %s from the cam's centre%s; `base` and roller ask for %s",
               cam->name, model->points[cam->point].name, yk_text_get(&words),
               is_lifted ? "" : ", on the side where lift brings it nearer", length_text(loader, asked));
    yk_text_free(&words);
    yk_problem_hint(
        loader->problems,
        "give the follower's points as they lie at lift 0; until then `yoke cam` turns it there, and the forces of "
        "`solve` and `simulate` act where the points say");
}

// Warns that a follower with mass, or a cam, pinned at one point with the other is only turned.
static void warn_of_couple(YkLoader *loader, const YkCam *cam)
{
    const YkBody *bodies = loader->model->bodies;
    if (cam->is_apart || (!bodies[cam->follower].mass_expr && !bodies[cam->cam].mass_expr)) return;
    yk_problem(loader->problems, YK_CODE_CAM_TURNED, cam->place,
               "cam %q: its pin and its follower's lie on one point, so nothing says where they touch: the "
               "reactions of `solve` and `simulate` lack the contact force",
               cam->name);
    yk_problem_hint(loader->problems, "give the pins points in the carrier, `centers` apart");
}

// Warns that a second roller would leave its cam where the first would leave its own.
static void warn_of_second(YkLoader *loader, const YkCam *cam)
{
    const YkExpr *expr = cam->oscillates ? cam->other_angle_expr : cam->other_span_expr;
    if (!expr || yk_cam_pair_holds(cam)) return;
    yk_problem(loader->problems, YK_CODE_CAM_TURNED, expr->place,
               "cam %q: lift moves the second roller away from the cam, as it does the first: the two do not hold the "
               "follower",
               cam->name);
    yk_problem_hint(loader->problems,
                    "it lies beyond the cam's centre: a longer `span`, or an `angle` of the other sign");
}

static void check_fit(YkLoader *loader, const YkCam *cam)
{
    const YkLaw *law = cam->law == YK_NONE ? NULL : loader->model->laws[cam->law].law;
    double size = cam->base + cam->roller;
    switch (yk_cam_fault(cam, law && !cam->oscillates ? yk_cam_lowest_lift(law) : 0)) {
    case YK_CAM_FITS:
        if (cam->oscillates) warn_of_place(loader, cam);
        if (cam->oscillates) warn_of_couple(loader, cam);
        warn_of_second(loader, cam);
        break;
    case YK_CAM_OFFSET:
        yk_problem(loader->problems, YK_CODE_CAM_SIZE, place_of(cam, cam->offset_expr),
                   "cam %q: the offset must be less than base and roller together, %s", cam->name,
                   length_text(loader, size));
        break;
    case YK_CAM_LIFT:
        refuse_size(loader, cam, cam->base_expr, "where the lift is lowest the follower would reach the cam's centre");
        break;
    case YK_CAM_CENTERS:
        refuse_size(loader, cam, NULL,
                    "cam and follower turn about the same place; `centers` says how far they are apart");
        break;
    case YK_CAM_FLAT_LARGE:
        refuse_size(loader, cam, cam->base_expr, "the flat face cannot touch the base circle: it is too large");
        break;
    case YK_CAM_ARM:
        refuse_size(loader, cam, NULL, "a follower that turns needs its `arm`, or a point by `at`");
        break;
    case YK_CAM_REACH:
        yk_problem(loader->problems, YK_CODE_CAM_SIZE, place_of(cam, cam->base_expr),
                   "cam %q: with this arm the roller or edge cannot lie %s from the cam's centre", cam->name,
                   length_text(loader, size));
        break;
    }
}

// Checks that the law is over an angle, gives the follower's motion, and repeats once or more in a turn.
static void check_law(YkLoader *loader, const YkCam *cam)
{
    const YkModelLaw *law = &loader->model->laws[cam->law];
    YkDimension wanted = cam->oscillates ? YK_DIM_ANGLE : YK_DIM_LENGTH;
    if (!yk_dimension_equal(law->of, YK_DIM_ANGLE) || !yk_dimension_equal(law->value, wanted)) {
        yk_problem(loader->problems, YK_CODE_CAM_LAW, cam->place,
                   "cam %q: law %q gives %s over %s; this follower needs %s over an angle", cam->name, law->name,
                   yk_dimension_name(law->value), yk_dimension_name(law->of),
                   cam->oscillates ? "an angle" : "a length");
        return;
    }
    if (!law->law) return;
    double period = yk_law_range(law->law).period, times = 2 * YK_PI / period;
    if (!(period > 0)) {
        yk_problem(loader->problems, YK_CODE_CAM_LAW, law->place, "cam %q: law %q does not return: it has no period",
                   cam->name, law->name);
        yk_problem_hint(loader->problems, "add `period: 2*pi`, with a dwell or a fall to the end of the turn");
    } else if (times < 0.5 || fabs(times - rint(times)) > 1e-9) {
        yk_problem(loader->problems, YK_CODE_CAM_LAW, law->place,
                   "cam %q: after a turn law %q has not returned: a turn is %e of its periods", cam->name, law->name,
                   times);
        yk_problem_hint(loader->problems, "the period of a cam's law is a turn, or a whole part of one");
    }
}

static bool is_known(const YkCam *cam)
{
    const double values[] = {cam->base,         cam->roller,     cam->offset,    cam->arm,        cam->centers,
                             cam->other_roller, cam->other_span, cam->other_arm, cam->other_angle};
    bool known = cam->base_expr != NULL;
    for (size_t i = 0; i < sizeof values / sizeof *values; i++) known &= !isnan(values[i]);
    return known;
}

static void finish(YkLoader *loader, YkCam *cam)
{
    bool good = check_signs(loader, cam) && is_known(cam);
    if (cam->carrier == YK_NONE) return;
    if (cam->law != YK_NONE && !cam->arcs) check_law(loader, cam);
    yk_cam_place(loader->model, cam);
    if (!good) return;
    if (cam->is_conjugate && !cam->other_roller_expr) cam->other_roller = cam->roller;
    check_centers(loader, cam);
    if (cam->arcs && yk_cam_fault(cam, 0) == YK_CAM_FITS) yk_load_finish_cam_arcs(loader, cam);
    check_fit(loader, cam);
}

void yk_load_finish_cams(YkLoader *loader)
{
    for (size_t i = 0; i < loader->model->cam_count; i++) finish(loader, &loader->model->cams[i]);
}
