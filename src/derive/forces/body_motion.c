// Bodies as moving masses: references, velocities, accelerations, and the coordinates of the body form.
#include "derive/forces/free_bodies.h"

YkDeriveFreedom yk_derive_freedom(const YkDerivation *d, size_t coordinate)
{
    const YkDeriveCoordinate *c = &d->coordinates[coordinate];
    YkDeriveFreedom freedom = {c->position, c->rate, c->acceleration, YK_NONE};
    if (c->is_distance) return freedom;
    const int32_t *body = d->model->joints[c->joint].body;
    freedom.body = d->bodies[body[1]].joint == c->joint ? body[1] : body[0];
    const YkDeriveBody *b = &d->bodies[freedom.body];
    freedom.position = b->angle, freedom.rate = b->rate, freedom.acceleration = b->acceleration;
    return freedom;
}

const YkPoisson *yk_derive_axes_angle(YkDerivation *d, int32_t body)
{
    const YkPoisson *turned = yk_ring_rational(d->ring, 0, 1);
    for (; d->bodies[body].parent != YK_NONE; body = d->bodies[body].parent) {
        int32_t joint = d->bodies[body].joint;
        if (d->joint_angle[joint] != YK_NONE)
            return yk_ring_add(d->ring, turned, yk_ring_of(d->ring, d->bodies[body].angle));
        const YkPoisson *step = yk_derive_expression(d, d->model->joints[joint].turned_expr);
        bool forwards = d->model->joints[joint].body[1] == body;
        turned = forwards ? yk_ring_add(d->ring, turned, step) : yk_ring_subtract(d->ring, turned, step);
    }
    return turned;
}

// Where gears, racks, belts or cams touch depends on positions, so these are written out at any depth.
static bool is_far(const YkDerivation *d, int32_t depth)
{
    return depth > YK_DERIVE_DEPTH_MAX && d->mech->relation_count == 0;
}

// Steps from the parent's reference over the joint to the body's.
static void enter_step(YkDeriveForces *f, int32_t b)
{
    YkDerivation *d = f->d;
    YkRing *ring = d->ring;
    YkDeriveMass *m = &f->bodies[b];
    int32_t joint = d->bodies[b].joint;
    int side = d->model->joints[joint].body[1] == b;
    const YkPoisson *line = yk_derive_joint_arm(f, joint, !side);
    line = yk_ring_subtract(ring, line, yk_derive_joint_arm(f, joint, side));
    m->step = yk_ring_time_derivative(ring, yk_ring_time_derivative(ring, line));
    const char *stem = yk_derive_text(d, "a_", yk_derive_center_name(d, b), "");
    m->symbols[0] = yk_derive_symbol(d, yk_derive_text(d, stem, "x", ""), YK_RING_ACCELERATION);
    m->symbols[1] = yk_derive_symbol(d, yk_derive_text(d, stem, "y", ""), YK_RING_ACCELERATION);
    m->acceleration = yk_ring_vector(ring, m->symbols[0], m->symbols[1]);
}

void yk_derive_put_step(const YkDeriveForces *f, YkPage *page, int32_t body)
{
    YkDerivation *d = f->d;
    YkRing *ring = d->ring;
    const YkDeriveMass *m = &f->bodies[body];
    if (m->position) return;
    const YkPoisson *is = yk_ring_add(ring, f->bodies[d->bodies[body].parent].acceleration, m->step);
    const YkPoisson *parts[] = {yk_ring_real(ring, is), yk_ring_imaginary(ring, is)};
    for (int k = 0; k < 2; k++)
        yk_page_equation(page, "acceleration", yk_ring_of(ring, m->symbols[k]), parts[k], YK_RING_TEXTBOOK);
}

bool yk_derive_put_depth(const YkDerivation *d, YkPage *page)
{
    if (!is_far(d, d->most_depth)) return false;
    yk_page_words(
        page,
        "Up to %z joints stand between a body and the ground: positions, and what follows from them, are written "
        "out up to %z. Ask for free-bodies and newton-euler, which go from body to body.",
        (size_t)d->most_depth, (size_t)YK_DERIVE_DEPTH_MAX);
    return true;
}

static void enter_mass(YkDeriveForces *f, int32_t b)
{
    YkDerivation *d = f->d;
    YkDeriveMass *m = &f->bodies[b];
    *m = (YkDeriveMass){.mass = yk_derive_mass(d, b)};
    m->inertia = yk_derive_inertia(d, b);
    m->center = d->model->bodies[b].has_mass ? yk_derive_center(d, b) : yk_ring_rational(d->ring, 0, 1);
    if (is_far(d, d->mech->tree.depth[b])) {
        enter_step(f, b);
        return;
    }
    m->position = yk_derive_position(d, b, m->center);
    m->velocity = yk_ring_time_derivative(d->ring, m->position);
    m->acceleration = yk_ring_time_derivative(d->ring, m->velocity);
}

bool yk_derive_enter_masses(YkDeriveForces *f)
{
    size_t bodies = f->d->model->body_count, closing = 3 * f->d->mech->loop_count + f->d->mech->relation_count + 1;
    f->bodies = YK_NEW(f->d->arena, YkDeriveMass, bodies + 1);
    f->kinetic = YK_NEW(f->d->arena, const YkPoisson *, bodies + 1);
    f->newton = YK_NEW(f->d->arena, const YkPoisson *, bodies + 1);
    f->euler = YK_NEW(f->d->arena, const YkPoisson *, bodies + 1);
    f->closing = YK_NEW(f->d->arena, const YkPoisson *, closing);
    f->closing_name = YK_NEW(f->d->arena, const char *, closing);
    f->closing_count = YK_NEW(f->d->arena, int, 1);
    f->potential = YK_NEW(f->d->arena, const YkPoisson *, 1);
    f->lumps = YK_NEW(f->d->arena, YkDeriveLump *, 1);
    f->lagrange_in_joints = YK_NEW(f->d->arena, struct YkDeriveLagrange, f->d->coordinate_count + 1);
    f->lagrange = YK_NEW(f->d->arena, struct YkDeriveLagrange, f->d->coordinate_count + 1);
    if (yk_arena_failed(f->d->arena)) return false;
    *f->closing_count = -1;
    for (size_t k = 0; k < bodies; k++) enter_mass(f, f->d->mech->tree_order[k]); // parents first
    return yk_derivation_is_well(f->d);
}

const YkPoisson *yk_derive_arm(YkDeriveForces *f, int32_t body, const YkPoisson *at)
{
    YkRing *ring = f->d->ring;
    return yk_ring_multiply(ring, f->d->bodies[body].unit, yk_ring_subtract(ring, at, f->bodies[body].center));
}

const YkPoisson *yk_derive_joint_arm(YkDeriveForces *f, int32_t joint, int side)
{
    YkDerivation *d = f->d;
    YkDerivePlace place = yk_derive_place(d, joint, side);
    const YkPoisson *arm = yk_derive_arm(f, place.body, yk_derive_at(d, place.point));
    if (side == 1 || d->joint_distance[joint] == YK_NONE) return arm;
    return yk_ring_add(d->ring, arm, yk_derive_slide(d, joint));
}

// Sums of more joint angles than this are not readable.
enum { JOINTS_IN_SUM_MAX = 4 };

bool yk_derive_shows_joints(const YkDerivation *d)
{
    return d->most_joints <= JOINTS_IN_SUM_MAX;
}

const YkPoisson *yk_derive_shown(YkDerivation *d, const YkPoisson *a)
{
    return yk_derive_shows_joints(d) ? yk_derive_in_joints(d, a) : a;
}

YkRingChanges *yk_derive_shown_by(YkDerivation *d)
{
    return yk_derive_shows_joints(d) ? yk_derive_to_joints(d) : NULL;
}

int32_t yk_derive_shown_acceleration(const YkDerivation *d, size_t coordinate)
{
    return yk_derive_shows_joints(d) ? d->coordinates[coordinate].acceleration
                                     : yk_derive_freedom(d, coordinate).acceleration;
}

// Returns a body's angle by those of the joints or, if these are too many, by that of the body before.
static const YkPoisson *shown_angle(YkDerivation *d, int32_t body)
{
    YkRing *ring = d->ring;
    const YkPoisson *sum = yk_ring_rational(ring, 0, 1);
    bool is_short = d->bodies[body].joints_in_angle <= JOINTS_IN_SUM_MAX;
    do {
        int32_t joint = d->bodies[body].joint, c = d->joint_angle[joint];
        const YkPoisson *turn = c == YK_NONE ? yk_derive_expression(d, d->model->joints[joint].turned_expr)
                                             : yk_ring_of(ring, d->coordinates[c].position);
        bool forwards = d->model->joints[joint].body[1] == body;
        sum = forwards ? yk_ring_add(ring, sum, turn) : yk_ring_subtract(ring, sum, turn);
        body = d->bodies[body].parent;
    } while (is_short && d->bodies[body].parent != YK_NONE);
    return is_short ? sum : yk_ring_add(ring, sum, yk_derive_axes_angle(d, body));
}

void yk_derive_put_angles(YkDerivation *d, YkPage *page)
{
    if (yk_derive_shows_joints(d)) return;
    yk_page_words(page, "In the angles of the bodies against the ground, which keep the equations short:");
    for (size_t b = 1; b < d->model->body_count; b++) {
        const YkDeriveBody *body = &d->bodies[b];
        int32_t c = d->joint_angle[body->joint];
        if (c == YK_NONE || body->angle == d->coordinates[c].position) continue;
        YkLine *line = yk_page_equation(page, body->name, yk_ring_of(d->ring, body->angle), shown_angle(d, (int32_t)b),
                                        YK_RING_TEXTBOOK);
        if (line) line->left = NULL; // the numeric engine counts turns of bodies apart
    }
}
