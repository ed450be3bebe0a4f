// Identifies a machine by one number: all of a model that its motion depends on.
#include <string.h>
#include "simulate/fingerprint.h"

typedef struct Print {
    uint64_t sum;
} Print;

static void add_whole(Print *p, uint64_t value)
{
    for (int k = 0; k < 8; k++) p->sum = (p->sum ^ (value >> 8 * k & 0xff)) * UINT64_C(0x100000001b3);
}

static void add_number(Print *p, double value)
{
    uint64_t bits;
    memcpy(&bits, &value, sizeof bits);
    add_whole(p, bits);
}

static void add_vector(Print *p, YkVec v)
{
    add_number(p, v.x);
    add_number(p, v.y);
}

static void add_name(Print *p, const char *name)
{
    for (; name && *name; name++) p->sum = (p->sum ^ (unsigned char)*name) * UINT64_C(0x100000001b3);
    add_whole(p, 0);
}

static void add_expr(Print *p, const YkExpr *e)
{
    add_whole(p, e != NULL);
    if (!e) return;
    add_whole(p, e->kind);
    if (e->kind == YK_EXPR_NUMBER) add_number(p, e->number * e->unit_size * e->value_scale);
    if (e->kind == YK_EXPR_NAME) add_name(p, e->name);
    if (e->kind == YK_EXPR_CALL) add_whole(p, e->function);
    if (e->kind == YK_EXPR_NUMBER || e->kind == YK_EXPR_NAME) return;
    add_expr(p, e->a);
    add_expr(p, e->b);
}

// Adds whole numbers; indices among them may be YK_NONE.
static void add_indices(Print *p, const int32_t *indices, size_t count)
{
    for (size_t k = 0; k < count; k++) add_whole(p, (uint64_t)indices[k]);
}

#define INDICES(print, ...)                                                                                            \
    add_indices(print, (const int32_t[]){__VA_ARGS__}, sizeof(int32_t[]){__VA_ARGS__} / sizeof(int32_t))

static void add_numbers(Print *p, const double *numbers, size_t count)
{
    for (size_t k = 0; k < count; k++) add_number(p, numbers[k]);
}

#define NUMBERS(print, ...)                                                                                            \
    add_numbers(print, (const double[]){__VA_ARGS__}, sizeof(double[]){__VA_ARGS__} / sizeof(double))

// Each list begins with its count, so that two machines never give the same row of bytes.

static void add_bodies(Print *p, const YkModel *m)
{
    add_whole(p, m->body_count);
    for (size_t k = 0; k < m->body_count; k++) {
        const YkBody *b = &m->bodies[k];
        add_name(p, b->name);
        add_whole(p, b->has_mass);
        if (b->has_mass) NUMBERS(p, b->mass, b->inertia);
        add_vector(p, b->center);
    }
    add_whole(p, m->point_count);
    for (size_t k = 0; k < m->point_count; k++) {
        INDICES(p, m->points[k].body);
        add_vector(p, m->points[k].at);
    }
}

static void add_joints(Print *p, const YkModel *m)
{
    add_whole(p, m->joint_count);
    for (size_t k = 0; k < m->joint_count; k++) {
        const YkJoint *j = &m->joints[k];
        add_name(p, j->name);
        INDICES(p, (int32_t)j->kind, j->body[0], j->body[1], j->angle, j->distance, j->has_friction);
        add_vector(p, j->at[0]);
        add_vector(p, j->at[1]);
        add_vector(p, j->along);
        add_number(p, j->turned);
        if (j->has_friction) NUMBERS(p, j->friction.coulomb, j->friction.radius, j->friction.viscous);
    }
}

static void add_law(Print *p, const YkLaw *law)
{
    enum { SAMPLES = 7 };
    YkLawRange range = yk_law_range(law);
    NUMBERS(p, range.from, range.to, range.period);
    for (int j = 0; j <= SAMPLES; j++) {
        double d[YK_LAW_ORDER + 1];
        yk_law_eval(law, range.from + (range.to - range.from) * j / SAMPLES, d);
        add_number(p, d[0]);
    }
}

static void add_motion(Print *p, const YkModel *m)
{
    add_whole(p, m->parameter_count);
    for (size_t k = 0; k < m->parameter_count; k++) {
        add_name(p, m->parameters[k].name);
        add_number(p, m->parameters[k].value);
    }
    add_whole(p, m->coordinate_count);
    for (size_t k = 0; k < m->coordinate_count; k++) {
        const YkCoordinate *c = &m->coordinates[k];
        add_name(p, c->name);
        INDICES(p, c->joint, c->is_distance, c->drive);
    }
    add_whole(p, m->drive_count);
    for (size_t k = 0; k < m->drive_count; k++) {
        INDICES(p, m->drives[k].coordinate, m->drives[k].law, m->drives[k].is_hold);
        add_expr(p, m->drives[k].expr);
    }
    add_whole(p, m->follow_count);
    for (size_t k = 0; k < m->follow_count; k++)
        INDICES(p, m->follows[k].coordinate, m->follows[k].of, m->follows[k].law);
    add_whole(p, m->law_count);
    for (size_t k = 0; k < m->law_count; k++) add_law(p, m->laws[k].law);
}

static void add_strength(Print *p, const YkStrength *strength)
{
    INDICES(p, strength->law);
    add_expr(p, strength->expr);
}

static void add_forces(Print *p, const YkModel *m)
{
    add_whole(p, m->effort_count);
    for (size_t k = 0; k < m->effort_count; k++) {
        INDICES(p, m->efforts[k].coordinate);
        add_strength(p, &m->efforts[k].strength);
    }
    add_whole(p, m->force_count);
    for (size_t k = 0; k < m->force_count; k++) {
        const YkForce *f = &m->forces[k];
        INDICES(p, f->body, f->in_body_axes);
        add_vector(p, f->at);
        add_strength(p, &f->x);
        add_strength(p, &f->y);
        add_strength(p, &f->moment);
    }
}

static void add_loads(Print *p, const YkModel *m)
{
    add_vector(p, m->gravity);
    add_forces(p, m);
    add_whole(p, m->spring_count);
    for (size_t k = 0; k < m->spring_count; k++) {
        const YkSpring *s = &m->springs[k];
        INDICES(p, s->coordinate, s->body[0], s->body[1]);
        NUMBERS(p, s->stiffness, s->length, s->damping);
        add_strength(p, &s->force);
        for (int end = 0; end < 2; end++) add_vector(p, s->at[end]);
    }
    add_whole(p, m->stop_count);
    for (size_t k = 0; k < m->stop_count; k++) {
        INDICES(p, m->stops[k].coordinate);
        NUMBERS(p, m->stops[k].low, m->stops[k].high, m->stops[k].restitution);
    }
}

static void add_wheels(Print *p, const YkModel *m)
{
    add_whole(p, m->gear_count);
    for (size_t k = 0; k < m->gear_count; k++) {
        const YkGear *g = &m->gears[k];
        INDICES(p, g->body[0], g->body[1], g->carrier, g->is_internal);
        NUMBERS(p, (double)g->teeth[0], (double)g->teeth[1], g->module, g->pressure_angle, g->planets);
    }
    add_whole(p, m->rack_count);
    for (size_t k = 0; k < m->rack_count; k++) {
        const YkRack *r = &m->racks[k];
        INDICES(p, r->pinion, r->rack, r->carrier, r->slide, r->sense);
        add_number(p, r->radius);
    }
    add_whole(p, m->belt_count);
    for (size_t k = 0; k < m->belt_count; k++) {
        const YkBelt *b = &m->belts[k];
        INDICES(p, b->body[0], b->body[1], b->carrier, b->is_crossed, b->is_lock);
        NUMBERS(p, b->radius[0], b->radius[1]);
    }
}

static void add_cams(Print *p, const YkModel *m)
{
    add_whole(p, m->cam_count);
    for (size_t k = 0; k < m->cam_count; k++) {
        const YkCam *c = &m->cams[k];
        INDICES(p, c->cam, c->follower, c->carrier, c->cam_joint, c->follower_joint, c->law, c->point, c->oscillates,
                c->is_groove, c->is_conjugate, (int32_t)c->face);
        NUMBERS(p, c->base, c->roller, c->offset, c->arm, c->centers, c->other_roller, c->other_span, c->other_arm,
                c->other_angle);
    }
}

uint64_t yk_fingerprint(const YkModel *model)
{
    Print p = {UINT64_C(0xcbf29ce484222325)};
    add_bodies(&p, model);
    add_joints(&p, model);
    add_motion(&p, model);
    add_loads(&p, model);
    add_wheels(&p, model);
    add_cams(&p, model);
    return p.sum;
}
