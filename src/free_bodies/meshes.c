// The forces of gears, racks, belts and cams. By virtual work each force belongs to the relation that it enforces:
// - gears: a force at the pitch point across the line of centres, if the centres are apart; otherwise couples
// - racks: a force along the rack at the pitch line
// - belts: couples on both pulleys and on their carrier
// - cams: a force along the common normal through the follower's roller (or edge), or where a flat face touches;
//   couples for a follower that turns about a pin on the cam's own, in which case its place is not known
// - cams with two rollers: the first bears while the force is positive, otherwise the second, with its own normal. With
//   a and b the forces of both that do the same work as the lift grows, that is (a + b)/2 for each newton, and
//   (a - b)/2 for each newton of its magnitude, which turns nothing
//
// Flanks of gears lean by the pressure angle: the force across comes with one along the line of centres, towards the
// first wheel's centre on that wheel, whichever flank bears. It turns nothing, so it follows from the solution and is
// applied as a load.
// Where several planets share a load (model/transmissions/planets.c), the column is that of all of them: on the wheel
// about the axis their forces leave a couple, and the carrier's axis bears the opposite of what pushes the planet.
#include "elementary/elementary.h"
#include "free_bodies/inside.h"
#include "model/transmissions/cam_place.h"

static void bodies_of(const YkModel *model, const YkRelation *r, YkWrenchColumn *c)
{
    const YkGear *gear = r->kind == YK_RELATION_GEAR ? &model->gears[r->index] : NULL;
    switch (r->kind) {
    case YK_RELATION_GEAR:
        c->body[0] = gear->body[0];
        c->body[1] = gear->body[1];
        c->third = gear->center_distance > 0 ? 0 : gear->carrier;
        if (!yk_gear_is_about_axis(gear)) break;
        c->body[!gear->planet] = gear->carrier;
        c->third = gear->body[!gear->planet];
        break;
    case YK_RELATION_BELT:
        c->body[0] = model->belts[r->index].body[0];
        c->body[1] = model->belts[r->index].body[1];
        c->third = model->belts[r->index].carrier;
        break;
    case YK_RELATION_RACK:
        c->body[0] = model->racks[r->index].pinion;
        c->body[1] = model->racks[r->index].rack;
        break;
    case YK_RELATION_LAW:
        for (int k = 0; k < 2; k++)
            c->body[k] = model->joints[model->coordinates[model->follows[r->index].coordinate].joint].body[k];
        c->third = model->joints[model->coordinates[model->follows[r->index].of].joint].body[1];
        c->fourth = model->joints[model->coordinates[model->follows[r->index].of].joint].body[0];
        break;
    case YK_RELATION_CAM:
        c->body[0] = model->cams[r->index].cam;
        c->body[1] = model->cams[r->index].follower;
        c->third = model->cams[r->index].carrier;
        break;
    }
}

void yk_meshes_build(YkFreeBodies *f)
{
    f->first_mesh = f->column_count;
    for (size_t k = 0; k < f->mech->relation_count; k++) {
        YkWrenchColumn c = {.joint = YK_NONE, .input = YK_NONE, .relation = (int32_t)k, .kind = YK_WRENCH_MESH};
        bodies_of(f->mech->model, &f->mech->relations[k], &c);
        f->columns[f->column_count++] = c;
    }
}

// The place of a body's point and its axes.
typedef struct Place {
    YkVec at, e;
} Place;

static Place place_of(const YkFreeBodies *f, const YkSpace *space, int32_t body, YkVec point)
{
    YkBodyMotion m = yk_body_motion(f->mech, space, (size_t)body);
    return (Place){yk_add(m.at, yk_mul(m.e, yk_sub(point, f->reference[body]))), m.e};
}

static YkVec center_of(const YkFreeBodies *f, const YkSpace *space, int32_t joint, int32_t body)
{
    const YkJoint *j = &f->mech->model->joints[joint];
    return place_of(f, space, body, j->at[j->body[1] == body]).at;
}

// Returns a wheel's centre, the origin of its body.
static YkVec wheel_center(const YkFreeBodies *f, const YkSpace *space, int32_t body)
{
    return place_of(f, space, body, yk_vec(0, 0)).at;
}

// Sets a force on the second body at a place in the world, and its opposite on the first.
static void set_force(const YkFreeBodies *f, const YkSpace *space, YkWrenchColumn *c, YkVec at, YkVec force)
{
    c->force = force;
    c->at[0] = c->at[1] = at;
    c->third_moment = 0;
    for (int k = 0; k < 2; k++) {
        YkVec arm = yk_sub(at, place_of(f, space, c->body[k], f->reference[c->body[k]]).at);
        c->moment[k] = (k ? 1 : -1) * yk_cross(arm, force) / f->size;
    }
}

static void set_radial(const YkFreeBodies *f, const YkSpace *space, YkWrenchColumn *c, YkVec center, YkVec pitch,
                       double slope)
{
    YkVec out = yk_sub(pitch, center);
    c->radial = yk_scale(slope / yk_norm(out), out);
    for (int k = 0; k < 2; k++) {
        YkVec arm = yk_sub(pitch, place_of(f, space, c->body[k], f->reference[c->body[k]]).at);
        c->radial_moment[k] = (k ? 1 : -1) * yk_cross(arm, c->radial);
    }
}

static void set_couples(YkWrenchColumn *c, double a, double b, double third)
{
    double most = fmax(fabs(a), fmax(fabs(b), fabs(third)));
    c->force = c->radial = yk_vec(0, 0);
    c->radial_moment[0] = c->radial_moment[1] = 0;
    c->moment[0] = a / most;
    c->moment[1] = b / most;
    c->third_moment = third / most;
}

// Sets the force of all planets on the one in the file, its opposite on the carrier's axis, and their couple on the
// wheel about that axis.
static void pose_shared(const YkFreeBodies *f, const YkSpace *space, YkWrenchColumn *c, const YkGear *gear, YkVec pitch)
{
    YkVec axis = wheel_center(f, space, gear->body[!gear->planet]);
    for (int k = 0; k < 2; k++) {
        YkVec at = k == gear->planet ? pitch : axis;
        YkVec arm = yk_sub(at, place_of(f, space, c->body[k], f->reference[c->body[k]]).at);
        c->moment[k] = (k ? 1 : -1) * yk_cross(arm, c->force) / f->size;
        c->radial_moment[k] = (k ? 1 : -1) * yk_cross(arm, c->radial);
    }
    c->third_moment = (gear->planet ? -1 : 1) * yk_cross(yk_sub(pitch, axis), c->force) / f->size;
}

static void pose_gear(const YkFreeBodies *f, const YkSpace *space, YkWrenchColumn *c, const YkGear *gear)
{
    double a = (double)gear->teeth[0], b = gear->is_internal ? -(double)gear->teeth[1] : (double)gear->teeth[1];
    if (!(gear->center_distance > 0)) {
        set_couples(c, a, b, -a - b);
        return;
    }
    YkVec A = wheel_center(f, space, gear->body[0]), B = wheel_center(f, space, gear->body[1]), line = yk_sub(B, A);
    YkVec pitch = yk_add(A, yk_scale(a / (a + b), line)); // internal: beyond A
    set_force(f, space, c, pitch, yk_scale(1 / yk_norm(line), yk_quarter(line)));
    set_radial(f, space, c, A, pitch, yk_tan(gear->pressure_angle));
    if (yk_gear_is_about_axis(gear)) pose_shared(f, space, c, gear, pitch);
}

static void pose_rack(const YkFreeBodies *f, const YkSpace *space, YkWrenchColumn *c, const YkRack *rack)
{
    const YkModel *model = f->mech->model;
    const YkJoint *slide = &model->joints[rack->slide];
    YkVec u = yk_mul(place_of(f, space, slide->body[0], slide->at[0]).e, slide->along);
    YkVec center = wheel_center(f, space, rack->pinion);
    // The distance is measured to the second body, and so is the sense.
    double sign = slide->body[1] == rack->rack ? 1 : -1;
    YkVec pitch = yk_add(center, yk_scale(-sign * rack->sense * rack->radius, yk_quarter(u)));
    set_force(f, space, c, pitch, yk_scale(sign, u));
}

// A cam at a pose.
typedef struct CamPose {
    const YkCam *cam;
    YkVec center, pin, u;    // of the cam; a follower that turns: its pin; one that slides: its line
    double slope, way, turn; // +1 if the follower, the cam, is the second body of its joint
} CamPose;

// Places the push on a flat face: along its line of motion, where it touches, which is off that line by the slope of
// the lift.
static void pose_flat(const YkFreeBodies *f, const YkSpace *space, YkWrenchColumn *c, const CamPose *p)
{
    YkVec touch = yk_add(p->center, yk_scale(-p->slope * p->turn, yk_quarter(p->u)));
    set_force(f, space, c, touch, p->u); // a force along u may act anywhere along u
}

// Places the push on a flat face that turns: along its normal n, at h n + h' i n from the cam's centre, with the face's
// distance h as a support function of the angle by which it turns against the cam (design/cams/cam_point.c).
static void pose_turning_flat(const YkFreeBodies *f, const YkSpace *space, YkWrenchColumn *c, const CamPose *p,
                              YkVec touch)
{
    YkVec n = yk_mul(place_of(f, space, p->cam->follower, yk_vec(0, 0)).e, touch), across = yk_quarter(n);
    YkVec pivot = yk_sub(p->pin, p->center);
    double slope = p->way * p->slope, aside = yk_dot(across, pivot) * slope / (slope - p->turn);
    YkVec at = yk_add(yk_scale(yk_dot(n, pivot) - p->cam->offset, n), yk_scale(aside, across));
    set_force(f, space, c, yk_add(p->center, at), n);
}

// Finds the follower's roller or edge; returns false if its place is unknown.
static bool roller_of(const YkFreeBodies *f, const YkSpace *space, const CamPose *p, double lift, YkVec *at)
{
    const YkModel *model = f->mech->model;
    const YkCam *cam = p->cam;
    const YkJoint *guide = &model->joints[cam->follower_joint];
    YkVec arm;
    if (cam->point != YK_NONE) {
        *at = place_of(f, space, cam->follower, model->points[cam->point].at).at;
        return true;
    }
    double reach = cam->base + cam->roller, start = reach * reach - cam->offset * cam->offset;
    if (cam->oscillates) {
        if (!yk_cam_touch(cam, &arm)) return false;
        *at = place_of(f, space, cam->follower, yk_add(guide->at[guide->body[1] == cam->follower], arm)).at;
        return true;
    }
    *at = yk_add(p->center, yk_add(yk_scale(sqrt(start) + lift, p->u), yk_scale(-cam->offset, yk_quarter(p->u))));
    return true;
}

// Returns the second roller of a pair, behind the first.
static YkVec second_roller(const CamPose *p, YkVec first)
{
    const YkCam *cam = p->cam;
    if (!cam->oscillates) return yk_sub(first, yk_scale(cam->other_span, p->u));
    YkVec turned = yk_scale(cam->other_arm / cam->arm, yk_unit(cam->other_angle));
    return yk_add(p->pin, yk_mul(turned, yk_sub(first, p->pin)));
}

// Returns how a place of the follower moves as the lift grows.
static YkVec moves_of(const CamPose *p, YkVec at)
{
    return p->cam->oscillates ? yk_scale(p->way, yk_quarter(yk_sub(at, p->pin))) : p->u;
}

// Returns the common normal at the follower's roller, across its path on the cam: outwards if the cam turns
// counterclockwise, inwards if clockwise; 0 if it rests there.
static YkVec normal_at(const CamPose *p, YkVec at)
{
    YkVec against = yk_sub(yk_scale(p->slope, moves_of(p, at)), yk_scale(p->turn, yk_quarter(yk_sub(at, p->center))));
    double speed = yk_norm(against);
    return speed > 0 ? yk_scale(1 / speed, yk_quarter(against)) : yk_vec(0, 0);
}

// Adds half the second roller's force that does the work of the first's, `normal`. Half of that, outwards so that a
// positive share pushes, is in the column.
static void add_second(const YkFreeBodies *f, const YkSpace *space, YkWrenchColumn *c, const CamPose *p, YkVec first,
                       YkVec normal)
{
    YkVec at = second_roller(p, first), other = normal_at(p, at);
    YkWrenchColumn second = *c;
    double ratio = yk_dot(moves_of(p, first), normal) / yk_dot(moves_of(p, at), other);
    set_force(f, space, &second, at, yk_scale(0.5 * p->turn * ratio, other));
    c->radial = yk_sub(c->force, second.force);
    c->force = yk_add(c->force, second.force);
    for (int k = 0; k < 2; k++) {
        c->radial_moment[k] = (c->moment[k] - second.moment[k]) * f->size;
        c->moment[k] += second.moment[k];
    }
    c->at[1] = at;
}

static void pose_cam(const YkFreeBodies *f, const YkSpace *space, YkWrenchColumn *c, const YkRelation *r,
                     const YkCam *cam)
{
    const YkModel *model = f->mech->model;
    const YkJoint *guide = &model->joints[cam->follower_joint], *shaft = &model->joints[cam->cam_joint];
    CamPose p = {.cam = cam,
                 .slope = space->gain[c->relation * (int32_t)space->stride] / r->gain,
                 .way = guide->body[1] == cam->follower ? 1 : -1,
                 .turn = shaft->body[1] == cam->cam ? 1 : -1,
                 .center = center_of(f, space, cam->cam_joint, cam->cam)};
    double lift = 0;
    YkVec at;
    if (cam->oscillates) {
        p.pin = center_of(f, space, cam->follower_joint, cam->follower);
    } else {
        p.u = yk_mul(place_of(f, space, cam->carrier, yk_vec(0, 0)).e, cam->along);
        lift = yk_space_slide(space, f->mech->joint_distance[cam->follower_joint]).d[0];
        if (cam->face == YK_CAM_FACE_FLAT) {
            pose_flat(f, space, c, &p);
            return;
        }
    }
    if (cam->oscillates && cam->face == YK_CAM_FACE_FLAT && yk_cam_touch(cam, &at)) {
        pose_turning_flat(f, space, c, &p, at);
        return;
    }
    YkVec normal = roller_of(f, space, &p, lift, &at) ? normal_at(&p, at) : yk_vec(0, 0);
    if (!(yk_norm(normal) > 0)) {
        set_couples(c, -p.slope * p.turn, p.way, p.slope * p.turn - p.way);
        return;
    }
    set_force(f, space, c, at, cam->is_conjugate ? yk_scale(0.5 * p.turn, normal) : normal);
    if (cam->is_conjugate) add_second(f, space, c, &p, at, normal);
}

// A unit effort along a coordinate, on its joint's second body and its reaction on the first; about their reference
// points.
typedef struct Effort {
    YkVec force;      // N, 0 along an angle
    double moment[2]; // N m
} Effort;

static Effort effort_along(const YkFreeBodies *f, const YkSpace *space, const YkCoordinate *coordinate)
{
    const YkJoint *joint = &f->mech->model->joints[coordinate->joint];
    Effort effort = {{0, 0}, {-1, 1}};
    if (!coordinate->is_distance) return effort;
    YkVec at = place_of(f, space, joint->body[1], joint->at[1]).at;
    effort.force = yk_mul(place_of(f, space, joint->body[0], joint->at[0]).e, joint->along);
    for (int k = 0; k < 2; k++) {
        YkVec arm = yk_sub(at, place_of(f, space, joint->body[k], f->reference[joint->body[k]]).at);
        effort.moment[k] = (k ? 1 : -1) * yk_cross(arm, effort.force);
    }
    return effort;
}

// Computes the effort of a law between coordinates: the follower's own, and on the other's two bodies the law's slope
// times it.
static void pose_follow(const YkFreeBodies *f, const YkSpace *space, YkWrenchColumn *c, const YkRelation *r)
{
    const YkModel *model = f->mech->model;
    const YkCoordinate *own = &model->coordinates[model->follows[r->index].coordinate];
    const YkCoordinate *of = &model->coordinates[model->follows[r->index].of];
    double slope = space->gain[c->relation * (int32_t)space->stride] / r->gain;
    Effort on = effort_along(f, space, own), back = effort_along(f, space, of);
    double unit = own->is_distance ? 1 : f->size; // N or N m: couples are divided by the size
    c->force = yk_scale(unit, on.force);
    c->other = yk_scale(-slope * unit, back.force);
    for (int k = 0; k < 2; k++) c->moment[k] = unit * on.moment[k] / f->size;
    c->third_moment = -slope * unit * back.moment[1] / f->size;
    c->fourth_moment = -slope * unit * back.moment[0] / f->size;
}

// Returns the bias. Any accelerations that the relation allows give the same product with its forces: those of the pose
// do.
static double bias_of(const YkFreeBodies *f, const YkSpace *space, const YkWrenchColumn *c)
{
    const int32_t bodies[] = {c->body[0], c->body[1], c->third, c->fourth};
    double sum = 0;
    for (int k = 0; k < 4; k++) {
        if (bodies[k] == 0) continue;
        YkBodyMotion m = yk_body_motion(f->mech, space, (size_t)bodies[k]);
        double moment = k < 2 ? c->moment[k] : k == 2 ? c->third_moment : c->fourth_moment;
        YkVec force = k < 2 ? c->force : c->other;
        sum += (k == 1 || k == 2 ? 1 : -1) * yk_dot(force, m.acceleration) + moment * m.a * f->size;
    }
    return sum / f->size;
}

void yk_mesh_pose(const YkFreeBodies *f, const YkSpace *space, YkWrenchColumn *c)
{
    const YkModel *model = f->mech->model;
    const YkRelation *r = &f->mech->relations[c->relation];
    if (r->kind == YK_RELATION_GEAR)
        pose_gear(f, space, c, &model->gears[r->index]);
    else if (r->kind == YK_RELATION_RACK)
        pose_rack(f, space, c, &model->racks[r->index]);
    else if (r->kind == YK_RELATION_CAM)
        pose_cam(f, space, c, r, &model->cams[r->index]);
    else if (r->kind == YK_RELATION_LAW)
        pose_follow(f, space, c, r);
    else {
        const YkBelt *belt = &model->belts[r->index];
        double b = belt->is_crossed ? belt->radius[1] : -belt->radius[1];
        set_couples(c, belt->radius[0], b, -belt->radius[0] - b);
    }
    c->bias = bias_of(f, space, c);
}

static bool add_radial(const YkWrenchColumn *c, YkLoad *load, double sign)
{
    double size = sign * fabs(c->share);
    bool is_none = c->radial.x == 0 && c->radial.y == 0 && c->radial_moment[0] == 0 && c->radial_moment[1] == 0;
    if (is_none) return false;
    for (int i = 0; i < 2; i++) {
        YkLoad *l = &load[c->body[i]];
        l->force = yk_add(l->force, yk_scale(i ? size : -size, c->radial));
        l->moment += size * c->radial_moment[i];
    }
    return size != 0;
}

bool yk_free_bodies_radial(const YkFreeBodies *f, YkLoad *load, double sign)
{
    bool any = false;
    for (size_t k = 0; k < f->column_count; k++)
        if (f->columns[k].kind == YK_WRENCH_MESH) any = add_radial(&f->columns[k], load, sign) || any;
    return any;
}

YkMeshForce yk_free_bodies_mesh(const YkFreeBodies *f, const YkSpace *space, size_t relation)
{
    const YkWrenchColumn *c = &f->columns[f->first_mesh + relation];
    YkVec force = yk_add(yk_scale(c->share, c->force), yk_scale(fabs(c->share), c->radial));
    bool is_couple = c->force.x == 0 && c->force.y == 0 && c->radial.x == 0 && c->radial.y == 0;
    YkVec at = is_couple ? yk_body_motion(f->mech, space, (size_t)c->body[1]).at : c->at[c->share < 0];
    const YkRelation *r = &f->mech->relations[relation];
    const int32_t *body = r->kind == YK_RELATION_GEAR ? f->mech->model->gears[r->index].body : c->body;
    return (YkMeshForce){force, c->share * c->moment[1] * f->size, c->share < 0, is_couple, at, {body[0], body[1]}};
}

static void add_mesh(const YkFreeBodies *f, const YkWrenchColumn *c, YkLoad *load)
{
    for (int i = 0; i < 2; i++) {
        YkLoad *l = &load[c->body[i]];
        l->force = yk_add(l->force, yk_scale(i ? c->share : -c->share, c->force));
        l->moment += c->share * c->moment[i] * f->size;
    }
    add_radial(c, load, 1);
    YkLoad *third = &load[c->third], *fourth = &load[c->fourth];
    third->force = yk_add(third->force, yk_scale(c->share, c->other));
    third->moment += c->share * c->third_moment * f->size;
    fourth->force = yk_sub(fourth->force, yk_scale(c->share, c->other));
    fourth->moment += c->share * c->fourth_moment * f->size;
}

void yk_free_bodies_meshes(const YkFreeBodies *f, YkLoad *load)
{
    for (size_t k = 0; k < f->column_count; k++)
        if (f->columns[k].kind == YK_WRENCH_MESH) add_mesh(f, &f->columns[k], load);
}

void yk_free_bodies_add_mesh(const YkFreeBodies *f, size_t relation, YkLoad *load)
{
    add_mesh(f, &f->columns[f->first_mesh + relation], load);
}

double yk_free_bodies_law_effort(const YkFreeBodies *f, size_t relation)
{
    const YkModel *model = f->mech->model;
    const YkFollow *follow = &model->follows[f->mech->relations[relation].index];
    double unit = model->coordinates[follow->coordinate].is_distance ? 1 : f->size; // as in pose_follow
    return unit * f->columns[f->first_mesh + relation].share;
}
