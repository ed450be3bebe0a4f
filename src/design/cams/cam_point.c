// A cam at one angle. Sources: Angeles & Lopez-Cajun 1991, ch. 3-4 (unified treatment by curvature); Norton 2009, ch. 7
// (pressure angle, radius of curvature); Rothbart 2004, ch. 3. Derived anew in complex numbers.
#include <math.h>
#include "design/cams/cam.h"
#include "elementary/elementary.h"

// The point of the carrier where the roller's centre or the edge lies, and its derivatives by the cam's angle.
typedef struct Path {
    YkVec at, d1, d2;
    YkVec lifts; // unit direction in which the follower leaves the cam
} Path;

static Path follow(const YkCamShape *shape, const double lift[])
{
    double s = shape->sign * lift[0], v = shape->sign * lift[1], a = shape->sign * lift[2];
    YkVec u = shape->along;
    if (!shape->oscillates) {
        YkVec aside = yk_scale(-shape->offset, yk_quarter(u));
        return (Path){yk_add(yk_scale(shape->start + s, u), aside), yk_scale(v, u), yk_scale(a, u), u};
    }
    YkVec arm = yk_scale(shape->arm, yk_unit(shape->start + shape->swing * s)), across = yk_quarter(arm);
    YkVec d2 = yk_add(yk_scale(shape->swing * a, across), yk_scale(-v * v, arm));
    return (Path){yk_add(shape->pivot, arm), yk_scale(shape->swing * v, across), d2,
                  yk_scale(shape->swing / shape->arm, across)};
}

static void set(double to[2], YkVec from)
{
    to[0] = from.x;
    to[1] = from.y;
}

static double angle_between(YkVec from, YkVec to)
{
    return yk_atan2(yk_cross(from, to), yk_dot(from, to));
}

// Pitch curve c = exp(-i sigma theta) C: c' and c'' in the carrier's axes are C' - i sigma C and
// C'' - 2 i sigma C' - C. With sigma > 0 the curve runs clockwise, so the cam lies to the right of c'.
static void place_roller(const YkCamShape *shape, const double lift[], YkVec turned, YkCamPoint *point)
{
    double sigma = shape->turn, r = shape->roller;
    Path path = follow(shape, lift);
    YkVec c1 = yk_sub(path.d1, yk_scale(sigma, yk_quarter(path.at)));
    YkVec c2 = yk_sub(yk_sub(path.d2, yk_scale(2 * sigma, yk_quarter(path.d1))), path.at);
    double speed = yk_norm(c1), curvature = -sigma * yk_cross(c1, c2) / (speed * speed * speed);
    YkVec normal = yk_scale(sigma / speed, yk_quarter(c1));
    YkVec contact = yk_sub(path.at, yk_scale(r, normal));
    point->pitch_radius = curvature == 0 ? (double)INFINITY : 1 / curvature;
    point->surface_radius = point->pitch_radius - r;
    point->fullness = 1 - r * curvature;
    point->outer_fullness = 1 + r * curvature;
    point->pressure_angle = angle_between(path.lifts, normal);
    set(point->pitch, yk_mul(turned, path.at));
    set(point->contact, contact);
    set(point->surface, yk_mul(turned, contact));
    set(point->outer, yk_mul(turned, yk_add(path.at, yk_scale(r, normal))));
    set(point->normal, yk_mul(turned, normal));
}

// The face's distance h from the cam's centre and its normal's angle, with derivatives by the cam's angle.
typedef struct Face {
    double h, h1, h2, nu1, nu2;
    YkVec normal;
} Face;

static Face face_at(const YkCamShape *shape, const double lift[])
{
    double s = lift[0], v = lift[1], a = lift[2];
    if (!shape->oscillates) return (Face){shape->start + s, v, a, 0, 0, shape->along};
    Face face = {.nu1 = shape->swing * v, .nu2 = shape->swing * a};
    face.normal = yk_unit(shape->start + shape->swing * s);
    double along = yk_dot(face.normal, shape->pivot), across = yk_dot(yk_quarter(face.normal), shape->pivot);
    face.h = along - shape->offset;
    face.h1 = across * face.nu1;
    face.h2 = across * face.nu2 - along * face.nu1 * face.nu1;
    return face;
}

// Returns where the contact lies along the face: from the line of motion, or from the pivot's foot away from the pivot.
static double reach_of(const YkCamShape *shape, YkVec contact, YkVec normal)
{
    YkVec across = yk_quarter(normal);
    if (!shape->oscillates) return -yk_dot(contact, across) - shape->offset;
    return -shape->swing * yk_dot(yk_sub(contact, shape->pivot), across);
}

// With the support function h(phi) the contact is h n + h_phi i n, and the radius of curvature is h + h_phiphi.
static void place_flat(const YkCamShape *shape, const double lift[], YkVec turned, YkCamPoint *point)
{
    Face face = face_at(shape, lift);
    double phi1 = face.nu1 - shape->turn, phi2 = face.nu2, slope = face.h1 / phi1;
    double radius = face.h + (face.h2 * phi1 - face.h1 * phi2) / (phi1 * phi1 * phi1);
    YkVec across = yk_quarter(face.normal);
    YkVec contact = yk_add(yk_scale(face.h, face.normal), yk_scale(slope, across));
    point->pitch_radius = point->surface_radius = radius;
    point->fullness = radius / shape->base;
    point->outer_fullness = 1;
    if (shape->turn * phi1 >= 0) point->fullness = -1; // the face turns faster than the cam
    point->reach = reach_of(shape, contact, face.normal);
    if (shape->oscillates) {
        YkVec moves = yk_scale(shape->swing, yk_quarter(yk_sub(contact, shape->pivot)));
        point->pressure_angle = angle_between(moves, face.normal);
    }
    set(point->contact, contact);
    set(point->surface, yk_mul(turned, contact));
    set(point->pitch, yk_mul(turned, contact));
    set(point->outer, yk_mul(turned, contact));
    set(point->normal, yk_mul(turned, face.normal));
}

YkCamPoint yk_cam_shape_at(const YkCamShape *shape, double angle, const double lift[YK_LAW_ORDER + 1])
{
    YkCamPoint point = {.angle = angle};
    YkVec turned = yk_unit(-shape->turn * angle);
    for (int k = 0; k <= YK_LAW_ORDER; k++) point.lift[k] = lift[k];
    if (shape->face == YK_CAM_FACE_FLAT) {
        place_flat(shape, lift, turned, &point);
    } else {
        place_roller(shape, lift, turned, &point);
    }
    return point;
}
