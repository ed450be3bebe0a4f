// Cams: where the follower is touched, and the common normal along which it is pushed. The geometry is that of
// design/cams/cam_point.c, with the law's value and slope as symbols. Source: Norton 2009, Cam Design and Manufacturing
// Handbook, ch. 7 (pressure angle).
#include <math.h>
#include "derive/cams/cams.h"
#include "derive/forces/meshes.h"
#include "derive/inside.h"
#include "elementary/elementary.h"
#include "model/transmissions/cam_place.h"

// Shared by all kinds of followers.
typedef struct Cam {
    const YkCam *cam;
    int32_t body[2];      // cam, follower
    int turn, way;        // 1 if the joint's coordinate counts forwards for the cam, for the follower
    const YkPoisson *v;   // the law's slope
    const YkPoisson *arm; // from the cam's reference to its centre
} Cam;

static Cam cam_of(YkMeshMaking *m, const YkCam *cam)
{
    const YkJoint *shaft = &m->d->model->joints[cam->cam_joint], *guide = &m->d->model->joints[cam->follower_joint];
    Cam of = {.cam = cam, .body = {cam->cam, cam->follower}, .v = yk_ring_of(m->ring, m->tie->function + 1)};
    of.turn = shaft->body[1] == cam->cam ? 1 : -1;
    of.way = guide->body[1] == cam->follower ? 1 : -1;
    of.arm = yk_derive_arm(m->f, cam->cam, yk_mesh_at(m, cam->cam_joint, of.turn > 0));
    return of;
}

// Adds a force at `reach` from the cam's centre.
static void push_follower(YkMeshMaking *m, const Cam *of, const YkPoisson *reach, const YkPoisson *force)
{
    YkRing *ring = m->ring;
    const YkPoisson *arm = yk_ring_add(ring, of->arm, reach);
    const YkPoisson *place = yk_ring_add(ring, m->f->bodies[of->body[0]].position, arm);
    const YkPoisson *arms[] = {arm, yk_mesh_arm(m, of->body[1], place)};
    const YkMeshHeld held[] = {yk_mesh_held_by(m, of->cam->cam_joint, of->turn > 0),
                               yk_mesh_held_by(m, of->cam->follower_joint, of->way > 0)};
    yk_mesh_force(m, "N", of->body, held, arms, force);
}

// Returns the unknown force along a direction: e^(i phi) of the normal's angle phi, which the direction defines.
static const YkPoisson *along(YkMeshMaking *m, const YkPoisson *direction)
{
    YkRing *ring = m->ring;
    m->mesh->lean = yk_derive_angle(m->d, yk_derive_force_name(m->f, "phi", m->between, ""));
    m->mesh->direction = direction;
    m->mesh->length = yk_derive_root(m->f, yk_derive_text(m->d, "rho_", m->tie->name, ""), "",
                                     yk_ring_dot(ring, direction, direction));
    return m->mesh->lean < 0 ? NULL : yk_ring_multiply(ring, m->unknown, yk_ring_unit(ring, m->mesh->lean));
}

// Returns by how far the line of motion passes to the right of the cam's centre.
static const YkPoisson *offset_of(YkMeshMaking *m, const Cam *of, const YkPoisson *u)
{
    YkRing *ring = m->ring;
    const YkCam *cam = of->cam;
    if (cam->offset_expr) return yk_derive_expression(m->d, cam->offset_expr);
    const YkPoisson *apart = yk_mesh_at(m, cam->follower_joint, of->way < 0);
    apart = yk_ring_subtract(ring, apart, yk_mesh_at(m, cam->cam_joint, of->turn < 0));
    const YkPoisson *in_carrier = yk_ring_multiply(ring, yk_ring_conjugate(ring, m->d->bodies[cam->carrier].unit), u);
    return yk_ring_negate(ring, yk_ring_cross(ring, in_carrier, apart));
}

// Adds to what the unknown is.
static void tell(YkMeshMaking *m, YkText *word)
{
    m->mesh->word = yk_derive_text(m->d, m->mesh->word, yk_text_get(word), "");
    m->d->failed |= word->failed;
    yk_text_free(word);
}

// Returns a symbol that has one value while the first of two rollers bears, and another while the second does.
static const YkPoisson *bearing(YkMeshMaking *m, int place, const char *stem, bool is_angle, double first,
                                double second)
{
    const char *name = yk_derive_force_name(m->f, stem, m->between, "");
    int32_t symbol = is_angle ? yk_derive_angle(m->d, name) : yk_derive_symbol(m->d, name, YK_RING_FUNCTION);
    m->mesh->bearing[place] = symbol;
    m->mesh->bearing_value[0][place] = first;
    m->mesh->bearing_value[1][place] = second;
    if (symbol < 0) return NULL;
    return is_angle ? yk_ring_unit(m->ring, symbol) : yk_ring_of(m->ring, symbol);
}

// Returns how far behind the first roller of a follower that slides the one is that bears.
static const YkPoisson *span_of(YkMeshMaking *m, const YkCam *cam)
{
    YkText word = {0};
    const YkPoisson *span = bearing(m, 0, "l_b", false, 0, cam->other_span);
    if (!span) return NULL;
    const char *name = yk_ring_symbol_name(m->ring, m->mesh->bearing[0]);
    yk_text_format(
        &word,
        " at the roller that bears: the first, with %s = 0, or where that one would have to pull the second, "
        "%s = %e m behind it",
        name, name, cam->other_span);
    tell(m, &word);
    return span;
}

// Returns the arm of the roller that bears over the first's, of a follower that turns.
static const YkPoisson *arm_ratio(YkMeshMaking *m, const YkCam *cam)
{
    YkText word = {0};
    double ratio = cam->other_arm / cam->arm;
    const YkPoisson *size = bearing(m, 0, "k_b", false, 1, ratio);
    const YkPoisson *turn = bearing(m, 1, "psi_b", true, 0, cam->other_angle);
    if (!size || !turn) return NULL;
    const char *k = yk_ring_symbol_name(m->ring, m->mesh->bearing[0]);
    const char *psi = yk_ring_symbol_name(m->ring, m->mesh->bearing[1]);
    yk_text_format(&word,
                   " at the roller that bears, whose arm is %s times the first's and turned from it by %s: the first, "
                   "with %s = 1 and %s = 0, or where that one would have to pull the second, with %s = %e and %s = %e "
                   "deg",
                   k, psi, k, psi, k, ratio, psi, cam->other_angle * 180 / YK_PI);
    tell(m, &word);
    return yk_ring_multiply(m->ring, size, turn);
}

// A follower that slides along u. Its roller is h from the cam's centre along u and e beside it.
static void make_sliding(YkMeshMaking *m, const Cam *of)
{
    YkRing *ring = m->ring;
    const YkCam *cam = of->cam;
    const YkPoisson *u = yk_ring_scale(ring, yk_mesh_line(m, cam->follower_joint), of->way, 1);
    const YkPoisson *iu = yk_ring_multiply(ring, yk_ring_i(ring), u);
    const YkPoisson *v = yk_ring_scale(ring, of->v, of->turn, 1);
    const YkPoisson *lift = yk_derive_distance(m->d, cam->follower_joint);
    const YkPoisson *base = yk_derive_expression(m->d, cam->base_expr);
    double size = cam->base + cam->roller;
    m->mesh->effort = m->unknown;
    if (cam->face == YK_CAM_FACE_FLAT ||
        !(fabs(cam->offset) < size)) { // contact where the cam rises as fast as the lift
        const YkPoisson *touch = yk_ring_multiply(ring, yk_ring_add(ring, base, lift), u);
        touch = yk_ring_subtract(ring, touch, yk_ring_multiply(ring, v, iu));
        push_follower(m, of, touch, yk_ring_multiply(ring, m->unknown, u));
        return;
    }
    const YkPoisson *e = offset_of(m, of, u), *start = base;
    if (cam->roller_expr) start = yk_ring_add(ring, base, yk_derive_expression(m->d, cam->roller_expr));
    if (e && !yk_ring_is_zero(e)) {
        const YkPoisson *square = yk_ring_power(ring, e, 2); // first: order is that of terms in print
        square = yk_ring_subtract(ring, yk_ring_power(ring, start, 2), square);
        const char *name = yk_derive_text(m->d, "h_", m->tie->name, "");
        start = yk_derive_root(m->f, name, "height of the roller over the cam's centre at lift 0", square);
    }
    const YkPoisson *h = yk_ring_add(ring, start, lift), *reach = yk_ring_multiply(ring, e, iu);
    if (cam->is_conjugate) h = yk_ring_subtract(ring, h, span_of(m, cam));
    reach = yk_ring_subtract(ring, yk_ring_multiply(ring, h, u), reach);
    const YkPoisson *aside = yk_ring_subtract(ring, v, e);
    aside = yk_ring_multiply(ring, yk_ring_i(ring), aside);
    const YkPoisson *force = along(m, yk_ring_add(ring, h, aside));
    push_follower(m, of, reach, yk_ring_multiply(ring, u, force));
    m->mesh->effort = yk_ring_real(ring, force);
}

// Returns e^(i psi0) of the direction in which the arm or the face's normal points at lift 0, in the follower's axes.
static const YkPoisson *start_of(YkMeshMaking *m, const Cam *of, YkVec touch)
{
    YkDerivation *d = m->d;
    YkText word = {0};
    bool is_new;
    double angle = yk_atan2(touch.y, touch.x);
    int32_t symbol = yk_derive_cam_symbol(d, of->cam, "psi0", true, &is_new);
    if (symbol < 0 || (is_new && !yk_derive_fix(d, symbol, angle))) return NULL;
    yk_text_format(&word, "; at lift 0 the follower's %s has the angle %s of %e deg",
                   of->cam->face == YK_CAM_FACE_FLAT ? "normal" : "arm", yk_ring_symbol_name(d->ring, symbol),
                   angle * 180 / YK_PI);
    tell(m, &word);
    return yk_ring_unit(d->ring, symbol);
}

// A flat face that turns, with the normal n: it touches at h n + h' i n from the cam's centre
// (design/cams/cam_point.c).
static void make_turning_flat(YkMeshMaking *m, const Cam *of, const YkPoisson *c, const YkPoisson *n)
{
    YkRing *ring = m->ring;
    const YkPoisson *e = yk_ring_rational(ring, 0, 1), *iu = yk_ring_multiply(ring, yk_ring_i(ring), n);
    if (of->cam->offset_expr) e = yk_derive_expression(m->d, of->cam->offset_expr);
    const YkPoisson *slope = yk_ring_scale(ring, of->v, of->way, 1);
    const YkPoisson *turns = yk_ring_subtract(ring, slope, yk_ring_rational(ring, of->turn, 1));
    const char *name = yk_derive_text(m->d, "kappa_", m->tie->name, "");
    const YkPoisson *part =
        yk_derive_ratio(m->f, name, "the slope of the lift over that of the turning against the cam", slope, turns);
    const YkPoisson *along = yk_ring_dot(ring, n, c), *across = yk_ring_dot(ring, iu, c);
    const YkPoisson *at = yk_ring_multiply(ring, yk_ring_subtract(ring, along, e), n);
    at = yk_ring_add(ring, at, yk_ring_multiply(ring, yk_ring_multiply(ring, part, across), iu));
    const YkPoisson *force = yk_ring_multiply(ring, m->unknown, n);
    push_follower(m, of, at, force);
    m->mesh->effort = yk_ring_scale(ring, yk_ring_cross(ring, yk_ring_subtract(ring, at, c), force), of->way, 1);
}

// A follower that turns about a pin at c from the cam's centre; its roller is at `swing` from there.
static void make_turning(YkMeshMaking *m, const Cam *of)
{
    YkRing *ring = m->ring;
    const YkCam *cam = of->cam;
    YkVec touch;
    if (cam->point == YK_NONE && !yk_cam_touch(cam, &touch)) {
        const YkPoisson *back = yk_ring_scale(ring, of->v, -of->turn, 1);
        yk_mesh_couples(m, of->body, cam->carrier, back, yk_ring_rational(ring, of->way, 1));
        m->mesh->effort = m->unknown;
        return;
    }
    const YkPoisson *unit = m->d->bodies[cam->follower].unit, *carrier = m->d->bodies[cam->carrier].unit, *swing;
    const YkPoisson *c = yk_mesh_at(m, cam->follower_joint, of->way < 0);
    c = yk_ring_subtract(ring, c, yk_mesh_at(m, cam->cam_joint, of->turn < 0));
    c = yk_ring_multiply(ring, carrier, c);
    if (cam->face == YK_CAM_FACE_FLAT) {
        make_turning_flat(m, of, c, yk_ring_multiply(ring, unit, start_of(m, of, touch)));
        return;
    }
    const YkPoisson *ratio = cam->is_conjugate ? arm_ratio(m, cam) : NULL;
    if (cam->point == YK_NONE) {
        const YkPoisson *arm = yk_derive_expression(m->d, cam->arm_expr);
        swing = yk_ring_multiply(ring, yk_ring_multiply(ring, unit, arm), start_of(m, of, touch));
    } else {
        const YkPoisson *pin = yk_mesh_at(m, cam->follower_joint, of->way > 0);
        swing = yk_ring_multiply(ring, unit, yk_ring_subtract(ring, yk_derive_at(m->d, cam->point), pin));
    }
    if (cam->is_conjugate) swing = yk_ring_multiply(ring, swing, ratio);
    const YkPoisson *slope = yk_ring_scale(ring, of->v, of->turn * of->way, 1);
    const YkPoisson *rest = yk_ring_subtract(ring, yk_ring_rational(ring, 1, 1), slope);
    const YkPoisson *normal = yk_ring_add(ring, c, yk_ring_multiply(ring, rest, swing));
    const YkPoisson *force =
        yk_ring_multiply(ring, carrier, along(m, yk_ring_multiply(ring, yk_ring_conjugate(ring, carrier), normal)));
    push_follower(m, of, yk_ring_add(ring, c, swing), force);
    m->mesh->effort = yk_ring_scale(ring, yk_ring_cross(ring, swing, force), of->way, 1);
}

void yk_mesh_cam(YkMeshMaking *m, const YkRelation *of)
{
    Cam cam = cam_of(m, &m->d->model->cams[of->index]);
    bool is_couple = cam.cam->oscillates && cam.cam->point == YK_NONE && !cam.cam->is_apart;
    yk_mesh_unknown(m, is_couple ? "T" : "N", cam.body,
                    is_couple ? "the moment by which the cam turns its follower"
                              : "the force by which the cam pushes its follower, along their common normal");
    if (cam.cam->oscillates)
        make_turning(m, &cam);
    else
        make_sliding(m, &cam);
}
