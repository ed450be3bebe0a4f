// The surface of a cam of arcs: where they touch each other, and when the follower touches them.
#include "model/transmissions/cam_arcs.h"
#include <math.h>
#include "elementary/elementary.h"

// Circles touch, and a turn is closed, to this part of the size.
#define SAME 1e-9

// The flank's circle touches base circle and nose: (R - r)^2 = (R - b)^2 + d^2 + 2 (R - b) d cos(alpha).
YkCamArcsFault yk_cam_arcs_symmetrical(const YkCamArcs *arcs, double base, YkCamArc *items)
{
    double nose = arcs->nose, d = base + arcs->lift - nose, flank = arcs->flank, alpha = arcs->angle / 2;
    bool is_line = arcs->flank_is_line;
    if (!(d > fabs(base - nose))) return YK_CAM_ARCS_FLANK;
    if (arcs->angle_expr) {
        double c = yk_cos(alpha), bend = 2 * (base - nose - d * c);
        is_line = fabs(bend) <= 1e-12 * (base + d);
        flank = (base * base + d * d - 2 * base * d * c - nose * nose) / bend;
        if (!is_line && !(alpha > 0 && alpha < YK_PI && (flank < 0 || flank > fmax(base, nose))))
            return YK_CAM_ARCS_FLANK;
    } else {
        double c = (base - nose) / d;
        if (!is_line)
            c = ((flank - nose) * (flank - nose) - (flank - base) * (flank - base) - d * d) / (2 * (flank - base) * d);
        if (!(fabs(c) < 1)) return YK_CAM_ARCS_FLANK;
        alpha = yk_acos(c);
    }
    YkPlace place = arcs->place;
    YkVec side = yk_scale(base - flank, yk_unit(alpha));
    items[0] = (YkCamArc){.place = place, .radius = base};
    items[2] = (YkCamArc){.place = place, .center = yk_vec(d, 0), .radius = nose};
    items[1] = items[3] = (YkCamArc){.place = place, .is_line = is_line, .radius = is_line ? 0 : flank};
    if (is_line) return YK_CAM_ARCS_GOOD;
    items[3].center = side;
    items[1].center = yk_vec(side.x, -side.y);
    return YK_CAM_ARCS_GOOD;
}

// Finds the normal at which two circles touch: p + r n = q + s n.
static bool touch(const YkCamArc *a, const YkCamArc *b, YkVec *normal)
{
    YkVec apart = yk_sub(a->center, b->center);
    double distance = yk_norm(apart), difference = b->radius - a->radius;
    double size = fabs(a->radius) + fabs(b->radius) + distance;
    if (!(distance > SAME * size) || fabs(distance - fabs(difference)) > SAME * size) return false;
    *normal = yk_scale((difference > 0 ? 1 : -1) / distance, apart);
    return true;
}

// Finds the normal of the line that leads counterclockwise from one circle to the next and touches both.
static bool join(const YkCamArc *a, const YkCamArc *b, YkVec *normal)
{
    YkVec way = yk_sub(b->center, a->center);
    double distance = yk_norm(way), across = (a->radius - b->radius) / distance;
    if (!(distance > 0) || !(fabs(across) < 1)) return false;
    YkVec along = yk_scale(1 / distance, way), right = yk_scale(-1, yk_quarter(along));
    *normal = yk_add(yk_scale(across, along), yk_scale(sqrt((1 - across) * (1 + across)), right));
    return true;
}

// Finds where element i ends.
static bool find_end(const YkCamArc *items, size_t count, size_t i, YkCamSurface *surface)
{
    const YkCamArc *here = &items[i], *next = &items[(i + 1) % count], *before = &items[(i + count - 1) % count];
    const YkCamArc *arc = here->is_line ? next : here; // which has its end in common with the line
    bool is_good = here->is_line   ? join(before, next, &surface->end_normal)
                   : next->is_line ? join(here, &items[(i + 2) % count], &surface->end_normal)
                                   : touch(here, next, &surface->end_normal);
    surface->end = yk_add(arc->center, yk_scale(arc->radius, surface->end_normal));
    return is_good;
}

static double modulo_turn(double angle)
{
    double rest = yk_fmod(angle, 2 * YK_PI);
    if (rest < 0) rest += 2 * YK_PI;
    return rest > 2 * YK_PI - SAME ? 0 : rest;
}

// Sets the angles during which the follower touches each element. While the cam turns counterclockwise, the contact
// runs over it clockwise.
static YkCamArcsFault find_angles(const YkCam *cam, YkCamSurface *surface, size_t count, size_t *culprit)
{
    double sum = 0;
    for (size_t i = 0; i < count; i++) {
        surface[i].from = yk_cam_contact_angle(cam, surface[i].end, surface[i].end_normal);
        *culprit = i;
        if (!isfinite(surface[i].from)) return YK_CAM_ARCS_REACH;
    }
    double last = surface[count - 1].from;
    for (size_t i = 0; i < count; i++) {
        double begins = last, ends = surface[i].from;
        last = ends;
        surface[i].length = modulo_turn(cam->turn > 0 ? begins - ends : ends - begins);
        surface[i].from = cam->turn > 0 ? ends : begins;
        sum += surface[i].length;
    }
    return fabs(sum - 2 * YK_PI) <= SAME * (double)count ? YK_CAM_ARCS_GOOD : YK_CAM_ARCS_ORDER;
}

YkCamArcsFault yk_cam_arcs_surface(const YkCam *cam, const YkCamArc *items, size_t count, YkCamSurface *surface,
                                   size_t *culprit)
{
    for (size_t i = 0; i < count; i++) {
        bool is_hollow = !items[i].is_line && items[i].radius < 0;
        *culprit = i;
        bool fits = cam->face != YK_CAM_FACE_FLAT && -items[i].radius > cam->roller && count > 1;
        if (is_hollow && !fits) return YK_CAM_ARCS_HOLLOW;
        if (items[i].is_line && (count < 3 || items[(i + 1) % count].is_line)) return YK_CAM_ARCS_LINE;
        surface[i] = (YkCamSurface){.is_line = items[i].is_line, .center = items[i].center, .radius = items[i].radius};
        if (count == 1) continue;
        if (!find_end(items, count, i, &surface[i])) {
            bool is_line = items[i].is_line || items[(i + 1) % count].is_line;
            if (is_line && !items[i].is_line) *culprit = (i + 1) % count;
            return is_line ? YK_CAM_ARCS_LINE : YK_CAM_ARCS_APART;
        }
        surface[i].normal = surface[i].end_normal; // of a line
        surface[i].support = yk_dot(surface[i].end, surface[i].end_normal);
    }
    if (count > 1) return find_angles(cam, surface, count, culprit);
    surface[0].length = 2 * YK_PI;
    return YK_CAM_ARCS_GOOD;
}

void yk_cam_arcs_turn(const YkCam *cam, YkCamSurface *surface, size_t count, size_t element, double from)
{
    double by = from - (surface[element].from + surface[element].length);
    YkVec turned = yk_unit(-cam->turn * by);
    for (size_t i = 0; i < count; i++) {
        YkCamSurface *s = &surface[i];
        YkVec *const vectors[] = {&s->center, &s->normal, &s->end, &s->end_normal};
        for (size_t k = 0; k < sizeof vectors / sizeof *vectors; k++) *vectors[k] = yk_mul(turned, *vectors[k]);
        s->from += by;
    }
}

static YkLawFault add(const YkCam *cam, const YkCamSurface *surface, double to, YkLawBuilder *builder)
{
    YkCamContact contact = {cam, surface};
    return yk_law_add_function(builder, to, YK_LAW_ARC, yk_cam_contact_lift, &contact);
}

// Goes through the elements in the order in which the follower touches them, which may begin in the middle of one.
YkLawFault yk_cam_arcs_add(const YkCam *cam, const YkCamSurface *surface, size_t count, double from,
                           YkLawBuilder *builder)
{
    YkLawFault fault = YK_LAW_OK;
    size_t first = 0;
    double least = INFINITY;
    for (size_t i = 0; i < count; i++) {
        double since = modulo_turn(surface[i].from - from);
        if (surface[i].length > 0 && since < least) first = i, least = since;
    }
    size_t step = cam->turn > 0 ? count - 1 : 1; // clockwise, or counterclockwise
    size_t last = first;
    do last = (last + count - step) % count;
    while (!(surface[last].length > 0));
    if (least > SAME) fault = add(cam, &surface[last], from + least, builder);
    double at = from + least;
    for (size_t k = 0, i = first; k < count && fault == YK_LAW_OK; k++, i = (i + step) % count) {
        if (!(surface[i].length > 0)) continue;
        at += surface[i].length;
        fault = add(cam, &surface[i], i == last ? from + 2 * YK_PI : at, builder);
    }
    return fault;
}
