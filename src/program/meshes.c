// Gears, racks, belts, cams and laws as unknowns of the bodies' balance. By virtual work the force belongs to the
// relation that it enforces; free_bodies/meshes derives where it acts.
#include <math.h>
#include "program/balance.h"
#include "elementary/elementary.h"

static bool has_force(const YkGear *gear)
{
    return gear->center_distance > 0;
}

// Returns whether it transmits something for each newton of its force's magnitude too.
static bool has_radial(const YkModel *m, const YkRelation *r)
{
    if (r->kind == YK_RELATION_CAM) return yk_meshes_cam_has_pair(&m->cams[r->index]);
    if (r->kind != YK_RELATION_GEAR || !has_force(&m->gears[r->index])) return false;
    return yk_tan(m->gears[r->index].pressure_angle) != 0;
}

void yk_meshes_columns(YkBalanceSystem *w)
{
    const YkProgram *p = w->f->program;
    for (size_t k = 0; k < p->mech->relation_count; k++) {
        const YkRelation *r = &p->mech->relations[k];
        YkUnknown *u = &w->columns[w->count++];
        *u = (YkUnknown){.joint = YK_NONE, .input = YK_NONE, .relation = (int32_t)k};
        if (has_radial(p->model, r)) u->radial = w->sides++;
    }
}

// Enters couples given as numbers: the largest is 1 N times the machine's size.
static void enter_couples(YkBalanceSystem *w, size_t column, const int32_t *bodies, double a, double b)
{
    YkProgram *p = w->f->program;
    double unit = w->unit / fmax(fabs(a), fmax(fabs(b), fabs(a + b)));
    const double sizes[] = {a * unit, b * unit, -(a + b) * unit};
    YkRef couples[3];
    for (size_t k = 0; k < 3; k++) couples[k] = yk_graph_number(&p->graph, sizes[k]);
    yk_balance_couples(w, column, bodies, couples);
}

// Returns a wheel's centre: the origin of its body.
static YkRefVec center_of(YkProgram *p, int32_t body)
{
    return yk_program_at(p, body, yk_graph_vec_number(&p->graph, 0, 0));
}

// Adds the force of teeth on the second wheel and its opposite on the first. If planets share it, the carrier's axis
// bears the opposite of the force on the planet, and the wheel about the axis takes their couple.
static void push_teeth(YkBalanceSystem *w, size_t column, const YkGear *gear, YkRefVec pitch, YkRefVec force)
{
    YkProgram *p = w->f->program;
    YkGraph *g = &p->graph;
    if (!yk_gear_is_about_axis(gear)) {
        yk_balance_force(w, column, gear->body, pitch, force);
        return;
    }
    int32_t wheel = gear->body[!gear->planet];
    double sign = gear->planet ? 1 : -1;
    YkRefVec axis = center_of(p, wheel), none = yk_graph_vec_number(g, 0, 0);
    YkRef couple = yk_graph_cross(g, yk_graph_vec_subtract(g, pitch, axis), force);
    *yk_balance_force_of(w, column) = force;
    yk_balance_push(w, column, gear->body[gear->planet], sign, pitch, force);
    yk_balance_push(w, column, gear->carrier, -sign, axis, force);
    if (column < w->n) yk_balance_add(w, column, wheel, none, yk_graph_multiply(g, yk_graph_number(g, -sign), couple));
}

// At the pitch point: a force across the line of centres and, per newton of it, a force on the second wheel away from
// the first centre, from the pressure angle.
static void enter_gear(YkBalanceSystem *w, size_t column, const YkGear *gear)
{
    YkProgram *p = w->f->program;
    YkGraph *g = &p->graph;
    double a = (double)gear->teeth[0], b = gear->is_internal ? -(double)gear->teeth[1] : (double)gear->teeth[1];
    if (!has_force(gear)) {
        const int32_t bodies[] = {gear->body[0], gear->body[1], gear->carrier};
        enter_couples(w, column, bodies, a, b);
        return;
    }
    YkRefVec A = center_of(p, gear->body[0]), line = yk_graph_vec_subtract(g, center_of(p, gear->body[1]), A);
    YkRefVec out = yk_graph_vec_scale(g, yk_graph_number(g, a / (a + b)), line); // internal: beyond A
    YkRefVec pitch = yk_graph_vec_add(g, A, out);
    YkRef per = yk_graph_inverse(g, yk_graph_vec_length(g, line));
    YkRefVec unit = yk_graph_vec_scale(g, per, line);
    push_teeth(w, column, gear, pitch, yk_graph_vec_quarter(g, unit));
    if (w->columns[column].radial == 0) return;
    double slope = (a / (a + b) < 0 ? -1 : 1) * yk_tan(gear->pressure_angle);
    YkRefVec radial = yk_graph_vec_scale(g, yk_graph_number(g, slope), unit);
    push_teeth(w, w->n + w->columns[column].radial, gear, pitch, radial);
}

static void enter_rack(YkBalanceSystem *w, size_t column, const YkRack *rack)
{
    YkProgram *p = w->f->program;
    YkGraph *g = &p->graph;
    const YkJoint *slide = &p->model->joints[rack->slide];
    double sign = slide->body[1] == rack->rack ? 1 : -1; // the distance and its sense are the second body's
    YkRefVec u = yk_forces_line(p, slide);
    YkRef away = yk_graph_number(g, -sign * rack->sense * rack->radius);
    YkRefVec center = center_of(p, rack->pinion);
    YkRefVec pitch = yk_graph_vec_add(g, center, yk_graph_vec_scale(g, away, yk_graph_vec_quarter(g, u)));
    const int32_t bodies[] = {rack->pinion, rack->rack};
    yk_balance_force(w, column, bodies, pitch, yk_graph_vec_scale(g, yk_graph_number(g, sign), u));
}

void yk_meshes_enter(YkBalanceSystem *w, size_t column)
{
    const YkModel *m = w->f->program->model;
    const YkRelation *r = &w->f->program->mech->relations[w->columns[column].relation];
    if (r->kind == YK_RELATION_GEAR) {
        enter_gear(w, column, &m->gears[r->index]);
    } else if (r->kind == YK_RELATION_RACK) {
        enter_rack(w, column, &m->racks[r->index]);
    } else if (r->kind == YK_RELATION_CAM) {
        yk_meshes_cam(w, column, r, &m->cams[r->index]);
    } else if (r->kind == YK_RELATION_LAW) {
        yk_meshes_follow(w, column, r, &m->follows[r->index]);
    } else {
        const YkBelt *belt = &m->belts[r->index];
        double a = belt->radius[0], b = belt->is_crossed ? belt->radius[1] : -belt->radius[1];
        enter_couples(w, column, (int32_t[]){belt->body[0], belt->body[1], belt->carrier}, a, b);
    }
}
