// Constructs force polygons: the known forces first, then those that hold the body.
#include "design/polygons/force_polygon.h"
#include <stdlib.h>
#include "base/problems.h"
#include "compile/mechanism.h"
#include "dynamics/dynamics.h"
#include "free_bodies/free_bodies.h"

typedef struct Walk {
    YkForcePolygons *p;
    const YkDynamics *d;
    size_t body, first;
    YkVec end;          // of what has been drawn
    YkVec center;       // of mass
    YkVec held;         // sum of contacts and reactions
    double held_moment; // of these about the centre of mass
    YkLoad *load;       // [body count]
} Walk;

static const double least = 1e-12; // of what is drawn, over the largest force

// Adds a force, unless there is none.
static void add(Walk *w, YkForceVector v, YkVec force)
{
    YkForcePolygons *p = w->p;
    double none = least * p->largest;
    v.body = w->body;
    if (v.part >= YK_FORCE_CONTACT) {
        YkVec arm = yk_sub(yk_vec(v.at[0], v.at[1]), w->center);
        w->held = yk_add(w->held, force);
        w->held_moment += v.moment + yk_cross(arm, force);
    }
    if (!(yk_norm(force) > none)) force = yk_vec(0, 0);
    if (!(fabs(v.moment) > none * p->size)) v.moment = 0;
    if (force.x == 0 && force.y == 0 && v.moment == 0) return;
    v.start[0] = w->end.x;
    v.start[1] = w->end.y;
    v.value[0] = force.x + 0.0; // no -0
    v.value[1] = force.y + 0.0;
    v.moment += 0.0;
    p->vector[p->vector_count++] = v;
    w->end = yk_add(w->end, force);
}

// Adds a force that acts at the centre of mass.
static void add_central(Walk *w, YkForcePart part, const char *name, YkVec force, double moment)
{
    YkForceVector v = {.part = part, .by = YK_NOT_FOUND, .name = name, .moment = moment, .is_determinate = true};
    v.at[0] = w->center.x;
    v.at[1] = w->center.y;
    add(w, v, force);
}

// Adds what a joint or contact does to the body, if it is one of its two.
static void add_reaction(Walk *w, YkForcePart part, const char *name, const YkReaction *r)
{
    if (r->by == r->on || (r->by != w->body && r->on != w->body)) return;
    double sign = r->on == w->body ? 1 : -1;
    YkForceVector v = {.part = part, .by = r->on == w->body ? r->by : r->on, .name = name, .moment = sign * r->moment};
    bool has_place = isfinite(r->at[0]) && isfinite(r->at[1]);
    v.at[0] = has_place ? r->at[0] : w->center.x;
    v.at[1] = has_place ? r->at[1] : w->center.y;
    v.is_determinate = r->is_determinate;
    add(w, v, yk_scale(sign, yk_vec(r->force[0], r->force[1])));
}

static bool has_planets(const YkModel *model)
{
    for (size_t g = 0; g < model->gear_count; g++)
        if (model->gears[g].copies > 1) return true;
    return false;
}

// Adds what a relation does to the body. Couples of belts and wheels differ on the two bodies, and their carrier feels
// the rest; a law acts on four bodies.
static void add_relation(Walk *w, size_t relation, const char *name)
{
    const YkDynamics *d = w->d;
    const YkReaction *r = &d->contact[relation];
    for (size_t b = 0; b < w->p->model->body_count; b++) w->load[b] = (YkLoad){0};
    yk_free_bodies_add_mesh(d->bodies, relation, w->load);
    YkLoad load = w->load[w->body];
    YkForceVector v = {.part = YK_FORCE_CONTACT, .by = YK_NOT_FOUND, .name = name, .is_determinate = r->is_determinate};
    if (r->by != r->on && (r->on == w->body || r->by == w->body)) v.by = r->on == w->body ? r->by : r->on;
    bool has_place = isfinite(r->at[0]) && isfinite(r->at[1]) && yk_norm(load.force) > 0;
    v.at[0] = has_place ? r->at[0] : w->center.x;
    v.at[1] = has_place ? r->at[1] : w->center.y;
    v.moment = load.moment - yk_cross(yk_sub(yk_vec(v.at[0], v.at[1]), w->center), load.force);
    add(w, v, load.force);
}

static void add_relations(Walk *w)
{
    const YkMechanism *mech = w->d->mech;
    const YkModel *model = w->p->model;
    for (size_t k = 0; k < yk_dynamics_contact_count(w->d); k++) {
        int32_t relation = yk_contact_relation(mech, k);
        if (relation != YK_NONE) add_relation(w, (size_t)relation, yk_dynamics_contact_name(w->d, k));
    }
    for (size_t k = 0; model->follow_count > 0 && k < mech->relation_count; k++)
        if (mech->relations[k].kind == YK_RELATION_LAW)
            add_relation(w, k, model->coordinates[model->follows[mech->relations[k].index].coordinate].name);
}

// Adds reactions and contacts, and what the planets do that the file does not describe.
static void add_held(Walk *w, const YkBalance *balance)
{
    const YkDynamics *d = w->d;
    for (size_t k = 0; has_planets(w->p->model) && k < yk_dynamics_contact_count(d); k++) {
        YkReaction r = yk_dynamics_contact(d, k);
        add_reaction(w, YK_FORCE_CONTACT, yk_dynamics_contact_name(d, k), &r);
    }
    if (!has_planets(w->p->model)) add_relations(w);
    for (size_t j = 0; j < w->p->model->joint_count; j++) {
        YkReaction r = yk_dynamics_reaction(d, j);
        add_reaction(w, YK_FORCE_REACTION, w->p->model->joints[j].name, &r);
    }
    if (!has_planets(w->p->model)) return;
    YkVec rest = yk_sub(yk_vec(balance->reactions.force[0], balance->reactions.force[1]), w->held);
    double moment = balance->reactions.moment - w->held_moment;
    if (yk_norm(rest) <= 1e-9 * w->p->largest) rest = yk_vec(0, 0); // rounding
    if (fabs(moment) <= 1e-9 * w->p->largest * w->p->size) moment = 0;
    add_central(w, YK_FORCE_PLANETS, "other planets", rest, moment);
}

static void take_body(Walk *w, size_t body)
{
    YkForcePolygons *p = w->p;
    const YkBody *b = &p->model->bodies[body];
    YkBalance balance = yk_dynamics_balance(w->d, body);
    YkVec weight = yk_scale(b->mass, p->model->gravity);
    YkVec loads = yk_sub(yk_vec(balance.loads.force[0], balance.loads.force[1]), weight);
    YkVec inertia = yk_vec(-balance.inertia.force[0], -balance.inertia.force[1]);
    *w = (Walk){
        .p = p, .d = w->d, .load = w->load, .body = body, .first = p->vector_count, .center = w->d->motion[body].at};
    add_central(w, YK_FORCE_WEIGHT, "weight", weight, 0);
    add_central(w, YK_FORCE_LOADS, "loads", loads, balance.loads.moment);
    add_central(w, YK_FORCE_INERTIA, "inertia", inertia, -balance.inertia.moment);
    add_held(w, &balance);
    if (p->vector_count > w->first) yk_force_polygon_tell(p, w->first);
}

static bool make(YkForcePolygons *p, const YkDynamics *d)
{
    const YkModel *model = d->mech->model;
    size_t bodies = model->body_count, links = 2 * model->joint_count + 4 * d->mech->relation_count;
    p->arena = yk_arena_new();
    if (!p->arena) return false;
    p->model = model;
    p->size = d->mech->size;
    p->largest = d->largest_force;
    for (size_t b = 1; b < bodies; b++)
        p->largest = fmax(p->largest, yk_norm(yk_scale(model->bodies[b].mass, d->motion[b].acceleration)));
    p->vector = YK_NEW(p->arena, YkForceVector, 4 * bodies + links);
    p->step = YK_NEW(p->arena, const char *, bodies);
    if (!p->vector || !p->step) return false;
    Walk walk = {.p = p, .d = d, .load = YK_NEW(p->arena, YkLoad, bodies)};
    if (!walk.load) return false;
    for (size_t b = 1; b < bodies; b++) take_body(&walk, b);
    return !p->failed && !yk_arena_failed(p->arena);
}

YkForcePolygons *yk_force_polygons_new(const YkDynamics *dynamics, YkProblems *problems)
{
    if (!dynamics) return NULL;
    YkForcePolygons *p = calloc(1, sizeof *p);
    if (p && make(p, dynamics)) return p;
    yk_problem(problems, YK_CODE_OUT_OF_MEMORY, (YkPlace){0}, "out of memory while constructing force polygons");
    yk_force_polygons_free(p);
    return NULL;
}

void yk_force_polygons_free(YkForcePolygons *p)
{
    if (!p) return;
    yk_text_free(&p->svg);
    yk_arena_free(p->arena);
    free(p);
}

size_t yk_force_polygons_vector_count(const YkForcePolygons *p)
{
    return p ? p->vector_count : 0;
}
YkForceVector yk_force_polygons_vector(const YkForcePolygons *p, size_t index)
{
    if (index < yk_force_polygons_vector_count(p)) return p->vector[index];
    return (YkForceVector){.body = YK_NOT_FOUND, .by = YK_NOT_FOUND};
}
size_t yk_force_polygons_step_count(const YkForcePolygons *p)
{
    return p ? p->step_count : 0;
}
const char *yk_force_polygons_step(const YkForcePolygons *p, size_t index)
{
    return index < yk_force_polygons_step_count(p) ? p->step[index] : NULL;
}
