// Identifies a machine by one number: names, dimensions, masses, loads, drives and laws of a model.
#include <string.h>
#include "simulate/save.h"

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

static void add_bodies(Print *p, const YkModel *m)
{
    for (size_t k = 0; k < m->body_count; k++) {
        const YkBody *b = &m->bodies[k];
        add_name(p, b->name);
        add_number(p, b->has_mass ? b->mass : 0);
        add_number(p, b->has_mass ? b->inertia : 0);
        add_vector(p, b->center);
    }
    for (size_t k = 0; k < m->joint_count; k++) {
        const YkJoint *j = &m->joints[k];
        add_name(p, j->name);
        add_whole(p, (uint64_t)j->kind);
        for (int end = 0; end < 2; end++) {
            add_whole(p, (uint64_t)j->body[end]);
            add_vector(p, j->at[end]);
        }
        add_vector(p, j->along);
        add_number(p, j->turned);
        if (!j->has_friction) continue;
        add_number(p, j->friction.coulomb);
        add_number(p, j->friction.radius);
        add_number(p, j->friction.viscous);
    }
}

static void add_motion(Print *p, const YkModel *m)
{
    for (size_t k = 0; k < m->parameter_count; k++) {
        add_name(p, m->parameters[k].name);
        add_number(p, m->parameters[k].value);
    }
    for (size_t k = 0; k < m->coordinate_count; k++) add_name(p, m->coordinates[k].name);
    for (size_t k = 0; k < m->drive_count; k++) {
        add_whole(p, (uint64_t)m->drives[k].coordinate);
        add_expr(p, m->drives[k].expr);
    }
    for (size_t k = 0; k < m->law_count; k++) {
        enum { SAMPLES = 7 };
        YkLawRange range = yk_law_range(m->laws[k].law);
        for (int j = 0; j <= SAMPLES; j++) {
            double d[YK_LAW_ORDER + 1];
            yk_law_eval(m->laws[k].law, range.from + (range.to - range.from) * j / SAMPLES, d);
            add_number(p, d[0]);
        }
    }
}

static void add_loads(Print *p, const YkModel *m)
{
    add_vector(p, m->gravity);
    for (size_t k = 0; k < m->effort_count; k++) {
        add_whole(p, (uint64_t)m->efforts[k].coordinate);
        add_expr(p, m->efforts[k].expr);
        add_expr(p, m->efforts[k].law.of);
    }
    for (size_t k = 0; k < m->force_count; k++) {
        const YkForce *f = &m->forces[k];
        add_whole(p, (uint64_t)f->body);
        add_vector(p, f->at);
        add_expr(p, f->x);
        add_expr(p, f->y);
        add_expr(p, f->moment);
    }
    for (size_t k = 0; k < m->spring_count; k++) {
        const YkSpring *s = &m->springs[k];
        add_number(p, s->stiffness);
        add_number(p, s->length);
        add_number(p, s->damping);
        for (int end = 0; end < 2; end++) add_vector(p, s->at[end]);
    }
    for (size_t k = 0; k < m->stop_count; k++) {
        add_number(p, m->stops[k].low);
        add_number(p, m->stops[k].high);
        add_number(p, m->stops[k].restitution);
    }
}

static void add_transmissions(Print *p, const YkModel *m)
{
    for (size_t k = 0; k < m->gear_count; k++) {
        add_number(p, (double)m->gears[k].teeth[0]);
        add_number(p, (double)m->gears[k].teeth[1]);
        add_number(p, m->gears[k].pressure_angle);
    }
    for (size_t k = 0; k < m->rack_count; k++) add_number(p, m->racks[k].radius);
    for (size_t k = 0; k < m->belt_count; k++) {
        add_number(p, m->belts[k].radius[0]);
        add_number(p, m->belts[k].radius[1]);
    }
    for (size_t k = 0; k < m->cam_count; k++) {
        add_number(p, m->cams[k].base);
        add_number(p, m->cams[k].roller);
        add_number(p, m->cams[k].offset);
    }
}

uint64_t yk_fingerprint(const YkModel *model)
{
    Print p = {UINT64_C(0xcbf29ce484222325)};
    add_bodies(&p, model);
    add_motion(&p, model);
    add_loads(&p, model);
    add_transmissions(&p, model);
    return p.sum;
}
