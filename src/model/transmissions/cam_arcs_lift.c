// The lift of a follower on one arc or line of a cam, with four derivatives, by truncated Taylor series.
//
// The cam's centre is the origin, vectors are complex numbers in the carrier's axes. At the cam's angle theta an arc's
// centre lies at P = p exp(i sigma theta). A roller's centre C lies at the distance r + rho from it; a flat face with
// the normal n lies at the distance Re(P conj(n)) + r from the cam's centre.
#include <math.h>
#include "elementary/elementary.h"
#include "expr/jet.h"
#include "model/transmissions/cam_arcs.h"
#include "model/transmissions/cam_place.h"

typedef struct Turning {
    YkSeries x, y;
} Turning;

// Returns a vector that turns with the cam, as series: each derivative is i sigma times the one before.
static Turning turn(const YkCam *cam, YkVec body, double angle)
{
    YkVec at = yk_mul(body, yk_unit(cam->turn * angle));
    Turning turning;
    for (int k = 0; k <= YK_JET_ORDER; k++) {
        turning.x.c[k] = at.x;
        turning.y.c[k] = at.y;
        at = yk_scale(cam->turn / (k + 1), yk_quarter(at));
    }
    return turning;
}

// Returns sign * acos(value / norm) away from the angle of (x, y): angle - sign acos(...).
static const char *lean(const Turning *f, const YkSeries *value, const YkSeries *norm, double sign, YkSeries *result)
{
    YkSeries ratio = yk_series_quotient(value, norm), off, direction;
    if (!(fabs(ratio.c[0]) < 1)) return "out of reach";
    const char *why = yk_series_function(YK_ACOS, &ratio, NULL, &off);
    if (!why) why = yk_series_function(YK_ATAN2, &f->y, &f->x, &direction);
    if (!why) *result = yk_series_sum(&direction, &off, -sign);
    return why;
}

static YkSeries squared(const Turning *f)
{
    YkSeries x = yk_series_product(&f->x, &f->x), y = yk_series_product(&f->y, &f->y);
    return yk_series_sum(&x, &y, 1);
}

static Turning from_pivot(const YkCam *cam, const Turning *P)
{
    YkSeries x = yk_series_constant(cam->pivot.x), y = yk_series_constant(cam->pivot.y);
    return (Turning){yk_series_sum(&x, &P->x, -1), yk_series_sum(&y, &P->y, -1)};
}

// A roller or edge on an arm: |f + a exp(i psi)| = |r + rho| with f = pivot - P. In a hollow lift leads towards the
// centre.
static const char *arm_on_arc(const YkCam *cam, const Turning *P, double reach, YkSeries *psi)
{
    Turning f = from_pivot(cam, P);
    YkSeries square = squared(&f), norm, value = yk_series_constant(reach * reach - cam->arm * cam->arm);
    const char *why = yk_series_function(YK_SQRT, &square, NULL, &norm);
    if (why) return why;
    value = yk_series_sum(&value, &square, -1);
    value = yk_series_scaled(&value, 1 / (2 * cam->arm));
    return lean(&f, &value, &norm, reach > 0 ? cam->away : -cam->away, psi);
}

// The same on a line: (pivot + a exp(i psi)) . n = support + rho.
static const char *arm_on_line(const YkCam *cam, const Turning *n, double support, YkSeries *psi)
{
    YkSeries x = yk_series_scaled(&n->x, cam->pivot.x), y = yk_series_scaled(&n->y, cam->pivot.y);
    YkSeries value = yk_series_constant(support), norm = yk_series_constant(cam->arm);
    value = yk_series_sum(&value, &x, -1);
    value = yk_series_sum(&value, &y, -1);
    return lean(n, &value, &norm, cam->away, psi);
}

// A flat face that turns with its normal's angle nu: Re(f exp(-i nu)) = r + offset.
static const char *face_on_arc(const YkCam *cam, const Turning *P, double radius, YkSeries *nu)
{
    Turning f = from_pivot(cam, P);
    YkSeries square = squared(&f), norm, value = yk_series_constant(radius + cam->offset);
    const char *why = yk_series_function(YK_SQRT, &square, NULL, &norm);
    return why ? why : lean(&f, &value, &norm, cam->away, nu);
}

// A roller or edge in a guide, at y along it and -e across: (y - a)^2 + (e + b)^2 = (r + rho)^2 with a + i b = P /
// along.
static const char *slide_on_arc(const YkCam *cam, const Turning *P, double reach, YkSeries *y)
{
    YkSeries side = yk_series_constant(cam->offset), root, radius = yk_series_constant(reach * reach);
    side = yk_series_sum(&side, &P->y, 1);
    side = yk_series_product(&side, &side);
    radius = yk_series_sum(&radius, &side, -1);
    if (!(radius.c[0] > 0)) return "out of reach";
    const char *why = yk_series_function(YK_SQRT, &radius, NULL, &root);
    if (!why) *y = yk_series_sum(&P->x, &root, reach > 0 ? 1 : -1);
    return why;
}

static const char *slide_on_line(const YkCam *cam, const Turning *n, double support, YkSeries *y)
{
    YkSeries value = yk_series_scaled(&n->y, cam->offset), constant = yk_series_constant(support);
    if (!(n->x.c[0] > 0)) return "out of reach";
    value = yk_series_sum(&value, &constant, 1);
    *y = yk_series_quotient(&value, &n->x);
    return NULL;
}

// Finds y, psi or nu, whichever the follower has.
static const char *place(const YkCam *cam, const YkCamSurface *surface, double angle, YkSeries *result)
{
    bool is_flat = cam->face == YK_CAM_FACE_FLAT;
    YkVec body = surface->is_line ? surface->normal : surface->center;
    double reach = surface->radius + cam->roller, support = surface->support + cam->roller;
    if (!cam->oscillates) body = yk_mul(body, yk_vec(cam->along.x, -cam->along.y));
    Turning turning = turn(cam, body, angle);
    if (is_flat && surface->is_line) return "a flat face rests on a line at one angle only";
    if (!cam->oscillates && is_flat) {
        YkSeries radius = yk_series_constant(surface->radius);
        *result = yk_series_sum(&turning.x, &radius, 1);
        return NULL;
    }
    if (!cam->oscillates)
        return surface->is_line ? slide_on_line(cam, &turning, support, result)
                                : slide_on_arc(cam, &turning, reach, result);
    if (is_flat) return face_on_arc(cam, &turning, surface->radius, result);
    return surface->is_line ? arm_on_line(cam, &turning, support, result) : arm_on_arc(cam, &turning, reach, result);
}

static double start_of(const YkCam *cam)
{
    YkSeries start;
    const YkCamSurface circle = {.radius = cam->base};
    return place(cam, &circle, 0, &start) ? NAN : start.c[0];
}

bool yk_cam_contact_lift(const void *context, double angle, double d[YK_LAW_ORDER + 1])
{
    const YkCamContact *contact = context;
    const YkCam *cam = contact->cam;
    YkSeries series;
    if (place(cam, contact->surface, angle, &series)) return false;
    YkJet jet = yk_jet_of_series(&series);
    double sign = cam->oscillates ? cam->swing : 1, start = start_of(cam);
    for (int m = 0; m <= YK_LAW_ORDER; m++) d[m] = sign * jet.d[m];
    d[0] = sign * (cam->oscillates ? yk_remainder(jet.d[0] - start, 2 * YK_PI) : jet.d[0] - start);
    return true;
}

double yk_cam_contact_angle(const YkCam *cam, YkVec point, YkVec normal)
{
    YkVec c = yk_add(point, yk_scale(cam->roller, normal)), C;
    double distance = yk_norm(c), a = cam->arm;
    if (cam->face == YK_CAM_FACE_FLAT) {
        double nu = cam->oscillates ? yk_cam_face_angle(cam->pivot, yk_dot(point, normal) + cam->offset, cam->away)
                                    : yk_argument(cam->along);
        return cam->turn * (nu - yk_argument(normal));
    }
    if (cam->oscillates) {
        C = yk_scale(a, yk_unit(yk_cam_arm_angle(cam->pivot, a, distance, cam->away)));
        C = yk_add(cam->pivot, C);
    } else {
        double y = sqrt((distance - cam->offset) * (distance + cam->offset));
        C = yk_mul(cam->along, yk_vec(y, -cam->offset));
    }
    return cam->turn * (yk_argument(C) - yk_argument(c));
}
