// Cams, and coordinates that follow others by a law: forces and couples from the slope of the law.
#include "program/balance.h"

// Returns d value / d argument of the relation's law.
static YkRef slope_of(const YkBalanceSystem *w, const YkRelation *r)
{
    YkProgram *p = w->f->program;
    size_t index = (size_t)(r - p->mech->relations);
    return yk_graph_divide(&p->graph, p->slope[2 * index], yk_graph_number(&p->graph, r->gain));
}

static YkRef times(YkGraph *g, double factor, YkRef value)
{
    return yk_graph_multiply(g, yk_graph_number(g, factor), value);
}

// --- cams

typedef struct CamPose {
    YkRef slope;
    YkRefVec center, u; // of the cam; the line of motion of a follower that slides
    double way, turn;   // +1 if the follower, the cam, is the second body of its joint
} CamPose;

// Returns a joint's point on one of its bodies, in that body's axes.
static YkRefVec point_on(YkProgram *p, int32_t joint, int32_t body)
{
    const YkJoint *j = &p->model->joints[joint];
    return yk_program_point(p, j->point[j->body[1] == body]);
}

static YkRefVec joint_on(YkProgram *p, int32_t joint, int32_t body)
{
    return yk_program_at(p, body, point_on(p, joint, body));
}

// Returns a vector that is given in the body's axes.
static YkRefVec turned_with(YkProgram *p, int32_t body, YkRefVec vector)
{
    YkGraph *g = &p->graph;
    YkRefVec unit = yk_graph_vec_multiply(g, p->unit[p->mech->bodies[body].orientation], p->turn_unit[body]);
    return yk_graph_vec_multiply(g, unit, vector);
}

// Returns where a follower that turns touches its cam at lift 0, as yk_cam_touch does, from the places of the pins: d
// and f are the pivot's distance along the direction, and its own, so that the direction is pivot (d -+ i sqrt(f^2 -
// d^2)) / f^2.
static YkRefVec touch_of(YkProgram *p, const YkCam *cam)
{
    YkGraph *g = &p->graph;
    bool is_flat = cam->face == YK_CAM_FACE_FLAT;
    double reach = cam->base + (is_flat ? cam->offset : cam->roller), arm = is_flat ? 1 : cam->arm;
    YkRefVec center = point_on(p, cam->cam_joint, cam->carrier), pin = point_on(p, cam->follower_joint, cam->carrier);
    YkRefVec pivot = yk_graph_vec_subtract(g, pin, center);
    YkRef f2 = yk_graph_dot(g, pivot, pivot), d = yk_graph_number(g, reach);
    if (!is_flat) d = times(g, 0.5 / arm, yk_graph_subtract(g, yk_graph_number(g, (reach - arm) * (reach + arm)), f2));
    YkRef aside = yk_graph_unary(g, YK_VALUE_ROOT, yk_graph_subtract(g, f2, yk_graph_multiply(g, d, d)));
    YkRefVec turn = {d, cam->swing > 0 ? yk_graph_minus(g, aside) : aside};
    YkRef per = yk_graph_divide(g, yk_graph_number(g, arm), f2);
    return yk_graph_vec_scale(g, per, yk_graph_vec_multiply(g, pivot, turn));
}

// Adds couples in the ratio of the motions, for followers that turn about the cam's own pin.
static void cam_couples(YkBalanceSystem *w, size_t column, const YkCam *cam, const CamPose *pose)
{
    YkGraph *g = &w->f->program->graph;
    double size = w->unit;
    YkRef on_cam = times(g, -pose->turn * size, pose->slope), on_follower = yk_graph_number(g, pose->way * size);
    const YkRef couples[] = {on_cam, on_follower, yk_graph_minus(g, yk_graph_add(g, on_cam, on_follower))};
    yk_balance_couples(w, column, (int32_t[]){cam->cam, cam->follower, cam->carrier}, couples);
}

// Pushes a flat face along its line of motion at the contact, which is off that line by the slope of the lift.
static void flat_face(YkBalanceSystem *w, size_t column, const YkCam *cam, const CamPose *pose)
{
    YkGraph *g = &w->f->program->graph;
    YkRef aside = times(g, -pose->turn, pose->slope);
    YkRefVec off = yk_graph_vec_scale(g, aside, yk_graph_vec_quarter(g, pose->u));
    yk_balance_force(w, column, (int32_t[]){cam->cam, cam->follower}, yk_graph_vec_add(g, pose->center, off), pose->u);
}

// Pushes a flat face that turns along its normal, where it touches (free_bodies/meshes.c).
static void turning_flat_face(YkBalanceSystem *w, size_t column, const YkCam *cam, const CamPose *pose)
{
    YkProgram *p = w->f->program;
    YkGraph *g = &p->graph;
    YkRefVec pin = joint_on(p, cam->follower_joint, cam->follower);
    YkRefVec n = turned_with(p, cam->follower, touch_of(p, cam));
    YkRefVec across = yk_graph_vec_quarter(g, n), pivot = yk_graph_vec_subtract(g, pin, pose->center);
    YkRef slope = times(g, pose->way, pose->slope);
    YkRef against = yk_graph_subtract(g, slope, yk_graph_number(g, pose->turn));
    YkRef part = yk_graph_divide(g, slope, against);
    YkRef aside = yk_graph_multiply(g, yk_graph_dot(g, across, pivot), part);
    YkRef height = yk_graph_subtract(g, yk_graph_dot(g, n, pivot), yk_graph_number(g, cam->offset));
    YkRefVec along = yk_graph_vec_scale(g, height, n),
             at = yk_graph_vec_add(g, along, yk_graph_vec_scale(g, aside, across));
    yk_balance_force(w, column, (int32_t[]){cam->cam, cam->follower}, yk_graph_vec_add(g, pose->center, at), n);
}

// Returns the direction in which a follower slides, in the carrier's axes.
static YkRefVec line_of(YkProgram *p, const YkCam *cam)
{
    const YkJoint *guide = &p->model->joints[cam->follower_joint];
    YkRefVec along = yk_program_along(p, guide);
    YkVec back = yk_scale(-1, yk_unit(-guide->turned));
    if (guide->body[0] == cam->carrier) return along;
    return yk_graph_vec_multiply(&p->graph, along, yk_graph_vec_number(&p->graph, back.x, back.y));
}

// Returns how far that line passes from the cam's centre, against the quarter turn from it.
static YkRef offset_of(YkProgram *p, const YkCam *cam)
{
    YkGraph *g = &p->graph;
    if (cam->offset_expr) return yk_graph_number(g, cam->offset);
    YkRefVec apart = yk_graph_vec_subtract(g, point_on(p, cam->follower_joint, cam->carrier),
                                           point_on(p, cam->cam_joint, cam->carrier));
    return yk_graph_minus(g, yk_graph_dot(g, apart, yk_graph_vec_quarter(g, line_of(p, cam))));
}

// Returns the roller or edge of a follower that slides and names no point.
static YkRefVec roller_of(YkBalanceSystem *w, const YkCam *cam, const CamPose *pose)
{
    YkProgram *p = w->f->program;
    YkGraph *g = &p->graph;
    double reach = cam->base + cam->roller;
    YkRef off = offset_of(p, cam), off2 = yk_graph_multiply(g, off, off);
    YkRef start = yk_graph_unary(g, YK_VALUE_ROOT, yk_graph_subtract(g, yk_graph_number(g, reach * reach), off2));
    YkRef lift = p->distance[p->mech->joint_distance[cam->follower_joint]];
    YkRefVec along = yk_graph_vec_scale(g, yk_graph_add(g, start, lift), pose->u);
    YkRefVec aside = yk_graph_vec_scale(g, yk_graph_minus(g, off), yk_graph_vec_quarter(g, pose->u));
    return yk_graph_vec_add(g, pose->center, yk_graph_vec_add(g, along, aside));
}

static YkRefVec cam_arm(YkBalanceSystem *w, const YkCam *cam, YkRefVec at)
{
    YkProgram *p = w->f->program;
    return yk_graph_vec_subtract(&p->graph, at, joint_on(p, cam->follower_joint, cam->follower));
}

// Returns the common normal: across the path of the roller on the cam.
static YkRefVec normal_at(YkBalanceSystem *w, const YkCam *cam, const CamPose *pose, YkRefVec at)
{
    YkGraph *g = &w->f->program->graph;
    YkRefVec velocity = yk_graph_vec_scale(g, pose->slope, pose->u);
    if (cam->oscillates) {
        YkRef spin = times(g, pose->way, pose->slope);
        velocity = yk_graph_vec_scale(g, spin, yk_graph_vec_quarter(g, cam_arm(w, cam, at)));
    }
    YkRefVec out = yk_graph_vec_quarter(g, yk_graph_vec_subtract(g, at, pose->center));
    YkRefVec against = yk_graph_vec_subtract(g, velocity, yk_graph_vec_scale(g, yk_graph_number(g, pose->turn), out));
    YkRef speed = yk_graph_vec_length(g, against);
    YkRef per = yk_graph_inverse(g, speed);
    return yk_graph_vec_scale(g, per, yk_graph_vec_quarter(g, against));
}

// Returns how far a place moves along a direction as the lift grows.
static YkRef lever_of(YkBalanceSystem *w, const YkCam *cam, const CamPose *pose, YkRefVec at, YkRefVec direction)
{
    YkGraph *g = &w->f->program->graph;
    if (!cam->oscillates) return yk_graph_dot(g, pose->u, direction);
    return times(g, pose->way, yk_graph_cross(g, cam_arm(w, cam, at), direction));
}

// Returns the second roller of a pair, behind the first.
static YkRefVec second_roller(YkBalanceSystem *w, const YkCam *cam, const CamPose *pose, YkRefVec first)
{
    YkGraph *g = &w->f->program->graph;
    YkRef span = yk_graph_number(g, cam->other_span);
    if (!cam->oscillates) return yk_graph_vec_subtract(g, first, yk_graph_vec_scale(g, span, pose->u));
    YkVec turned = yk_scale(cam->other_arm / cam->arm, yk_unit(cam->other_angle));
    YkRefVec arm = cam_arm(w, cam, first);
    YkRefVec other = yk_graph_vec_multiply(g, yk_graph_vec_number(g, turned.x, turned.y), arm);
    return yk_graph_vec_add(g, first, yk_graph_vec_subtract(g, other, arm));
}

// Adds the forces of two rollers to a column or right side.
static void push_two(YkBalanceSystem *w, size_t column, const YkCam *cam, const YkRefVec at[2], const YkRefVec force[2])
{
    for (int k = 0; k < 2; k++) yk_balance_force(w, column, (int32_t[]){cam->cam, cam->follower}, at[k], force[k]);
    *yk_balance_force_of(w, column) = yk_graph_vec_add(&w->f->program->graph, force[0], force[1]);
}

// Pushes the bearing one of two rollers: half the forces of both that do the same work, and for each newton of
// magnitude half their difference (free_bodies/meshes.c).
static void roller_pair(YkBalanceSystem *w, size_t column, const YkCam *cam, const CamPose *pose, YkRefVec first,
                        YkRefVec normal)
{
    YkGraph *g = &w->f->program->graph;
    const YkRefVec at[] = {first, second_roller(w, cam, pose, first)};
    YkRefVec other = normal_at(w, cam, pose, at[1]);
    YkRef own = lever_of(w, cam, pose, first, normal), its = lever_of(w, cam, pose, at[1], other);
    double half = 0.5 * pose->turn; // outwards: a positive share pushes
    YkRef ratio = times(g, half, yk_graph_divide(g, own, its));
    YkRefVec force[2];
    force[0] = yk_graph_vec_scale(g, yk_graph_number(g, half), normal);
    force[1] = yk_graph_vec_scale(g, ratio, other);
    push_two(w, column, cam, at, force);
    force[1] = yk_graph_vec_scale(g, yk_graph_number(g, -1), force[1]);
    push_two(w, w->n + w->columns[column].radial, cam, at, force);
}

// Pushes the roller or edge along the common normal.
static void roller_force(YkBalanceSystem *w, size_t column, const YkCam *cam, const CamPose *pose, YkRefVec at)
{
    YkRefVec normal = normal_at(w, cam, pose, at);
    if (w->columns[column].radial != 0)
        roller_pair(w, column, cam, pose, at, normal);
    else
        yk_balance_force(w, column, (int32_t[]){cam->cam, cam->follower}, at, normal);
}

bool yk_meshes_cam_has_pair(const YkCam *cam)
{
    return cam->is_conjugate && (!cam->oscillates || cam->point != YK_NONE || cam->is_apart);
}

void yk_meshes_cam(YkBalanceSystem *w, size_t column, const YkRelation *r, const YkCam *cam)
{
    YkProgram *p = w->f->program;
    YkGraph *g = &p->graph;
    const YkModel *m = p->model;
    CamPose pose = {.slope = slope_of(w, r)};
    pose.center = joint_on(p, cam->cam_joint, cam->cam);
    double reach = cam->base + cam->roller;
    pose.way = m->joints[cam->follower_joint].body[1] == cam->follower ? 1 : -1;
    pose.turn = m->joints[cam->cam_joint].body[1] == cam->cam ? 1 : -1;
    if (!cam->oscillates) pose.u = turned_with(p, cam->carrier, line_of(p, cam));
    if (!cam->oscillates && (cam->face == YK_CAM_FACE_FLAT || !(reach * reach > cam->offset * cam->offset)))
        flat_face(w, column, cam, &pose);
    else if (cam->point != YK_NONE)
        roller_force(w, column, cam, &pose, yk_program_at(p, cam->follower, yk_program_point(p, cam->point)));
    else if (cam->oscillates && !cam->is_apart)
        cam_couples(w, column, cam, &pose);
    else if (cam->oscillates && cam->face == YK_CAM_FACE_FLAT)
        turning_flat_face(w, column, cam, &pose);
    else if (cam->oscillates)
        roller_force(w, column, cam, &pose,
                     yk_graph_vec_add(g, joint_on(p, cam->follower_joint, cam->follower),
                                      turned_with(p, cam->follower, touch_of(p, cam))));
    else
        roller_force(w, column, cam, &pose, roller_of(w, cam, &pose));
}

// --- laws

// Adds an effort along a coordinate: on its joint's second body, and its reaction on the first.
static void push_along(YkBalanceSystem *w, size_t column, int32_t coordinate, YkRef effort)
{
    YkProgram *p = w->f->program;
    YkGraph *g = &p->graph;
    const YkCoordinate *c = &p->model->coordinates[coordinate];
    const YkJoint *j = &p->model->joints[c->joint];
    if (c->is_distance) {
        YkRefVec at = yk_program_at(p, j->body[1], yk_program_point(p, j->point[1]));
        yk_balance_force(w, column, j->body, at, yk_graph_vec_scale(g, effort, yk_forces_line(p, j)));
        return;
    }
    YkRefVec none = yk_graph_vec_number(g, 0, 0);
    yk_balance_add(w, column, j->body[1], none, effort);
    yk_balance_add(w, column, j->body[0], none, yk_graph_minus(g, effort));
}

// The follower pushes along its own coordinate; the other coordinate's two bodies feel minus the law's slope of it.
void yk_meshes_follow(YkBalanceSystem *w, size_t column, const YkRelation *r, const YkFollow *follow)
{
    YkProgram *p = w->f->program;
    YkGraph *g = &p->graph;
    bool is_distance = p->model->coordinates[follow->coordinate].is_distance;
    YkRef unit = yk_graph_number(g, is_distance ? 1 : w->unit);
    push_along(w, column, follow->coordinate, unit);
    push_along(w, column, follow->of, yk_graph_minus(g, yk_graph_multiply(g, slope_of(w, r), unit)));
}
