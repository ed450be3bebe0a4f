// Reactions: Newton's and Euler's equations of every body, with all reactions and efforts unknown, as in free_bodies/:
// a pin transmits two forces, a slide a normal force and a couple, a pin-slot a normal force, a weld all three.
#include "program/balance.h"

static void add_column(YkBalanceSystem *w, size_t joint, int32_t input, YkRefVec force, bool is_couple)
{
    w->columns[w->count++] = (YkUnknown){
        .joint = (int32_t)joint, .input = input, .relation = YK_NONE, .force = force, .is_couple = is_couple};
}

static void make_columns(YkBalanceSystem *w)
{
    YkProgram *p = w->f->program;
    YkGraph *g = &p->graph;
    YkRefVec x = yk_graph_vec_number(g, 1, 0), y = yk_graph_vec_number(g, 0, 1), none = yk_graph_vec_number(g, 0, 0);
    for (size_t j = 0; j < p->model->joint_count; j++) {
        const YkJoint *joint = &p->model->joints[j];
        const YkPart *part = yk_part(joint->kind);
        if (part->slides) {
            add_column(w, j, YK_NONE, yk_graph_vec_quarter(g, yk_forces_line(p, joint)), false);
        } else {
            add_column(w, j, YK_NONE, x, false);
            add_column(w, j, YK_NONE, y, false);
        }
        if (!part->turns) add_column(w, j, YK_NONE, none, true);
    }
    for (size_t i = 0; i < p->mech->input_count; i++) {
        const YkTreeCoordinate *c = &p->mech->coordinates[p->mech->inputs[i]];
        YkRefVec line = c->is_distance ? yk_forces_line(p, &p->model->joints[c->joint]) : none;
        add_column(w, (size_t)c->joint, (int32_t)i, line, !c->is_distance);
    }
}

// Enters a joint's wrench on one of its bodies, at an arm from its centre of mass; a couple is taken over the unit.
static void enter(YkBalanceSystem *w, size_t column, int32_t body, double sign, YkRefVec arm)
{
    YkProgram *p = w->f->program;
    YkGraph *g = &p->graph;
    const YkUnknown *c = &w->columns[column];
    YkRefVec none = yk_graph_vec_number(g, 0, 0);
    if (c->is_couple) {
        yk_balance_add(w, column, body, none, yk_graph_number(g, sign * w->unit));
        return;
    }
    YkRefVec force = yk_graph_vec_scale(g, yk_graph_number(g, sign), c->force);
    yk_balance_add(w, column, body, force, yk_graph_cross(g, arm, force));
}

// Enters a joint's wrench on both bodies. It acts at the joint's point of the second body; from the first body's point
// that is where the joint has slid.
static void enter_joint(YkBalanceSystem *w, size_t column)
{
    YkProgram *p = w->f->program;
    YkGraph *g = &p->graph;
    size_t index = (size_t)w->columns[column].joint;
    const YkJoint *joint = &p->model->joints[index];
    YkRefVec arm = yk_forces_arm(p, joint->body[0], yk_program_point(p, joint->point[0]));
    if (yk_part(joint->kind)->slides) {
        YkRef slid = p->distance[p->mech->joint_distance[index]];
        arm = yk_graph_vec_add(g, arm, yk_graph_vec_scale(g, slid, yk_forces_line(p, joint)));
    }
    enter(w, column, joint->body[0], -1, arm);
    enter(w, column, joint->body[1], 1, yk_forces_arm(p, joint->body[1], yk_program_point(p, joint->point[1])));
}

// Enters inertia - weight - loads, with moments over the unit as in the rows.
static void enter_right(YkBalanceSystem *w, int32_t body)
{
    YkProgram *p = w->f->program;
    YkGraph *g = &p->graph;
    const YkWrenchRef *load = &w->f->load[body];
    YkRefVec force = yk_graph_vec_scale(g, yk_graph_number(g, -1), load->force);
    YkRef moment = yk_graph_minus(g, load->moment);
    if (p->model->bodies[body].has_mass) {
        YkRefVec center = yk_forces_center(p, body);
        YkRefVec a = yk_program_body_accel(p, body, center, &w->velocities, &w->accelerations);
        YkRefVec pull = yk_graph_vec_subtract(g, a, w->f->gravity);
        force = yk_graph_vec_add(g, force, yk_graph_vec_scale(g, yk_forces_mass(p, body), pull));
        YkRef spin = w->accelerations.turn[p->mech->bodies[body].orientation];
        moment = yk_graph_add(g, moment, yk_graph_multiply(g, yk_forces_inertia(p, body), spin));
    }
    yk_balance_add(w, w->n, body, force, moment);
}

static void make_system(YkBalanceSystem *w)
{
    YkProgram *p = w->f->program;
    YkGraph *g = &p->graph;
    YkRef zero = yk_graph_number(g, 0);
    for (size_t k = 0; k < 3 * (p->model->body_count - 1) * (w->n + w->sides); k++) w->system[k] = zero;
    for (size_t k = 0; k < w->count; k++) {
        if (w->columns[k].relation != YK_NONE) {
            yk_meshes_enter(w, k);
            continue;
        }
        enter_joint(w, k);
    }
    for (size_t b = 1; b < p->model->body_count; b++) enter_right(w, (int32_t)b);
    if (w->dry_count > 0) yk_dry_enter(w);
}

YkRef yk_balance_value(const YkBalanceSystem *w, size_t k)
{
    YkGraph *g = &w->f->program->graph;
    YkRef value = w->solution[k * w->sides];
    for (size_t side = 1; w->factor && side < w->sides; side++) {
        YkRef part = yk_graph_multiply(g, w->factor[side], w->solution[k * w->sides + side]);
        value = yk_graph_add(g, value, part);
    }
    if (w->factor) return value;
    for (size_t c = 0; c < w->count; c++) {
        size_t side = w->columns[c].radial;
        if (side == 0) continue;
        YkRef size = yk_graph_unary(g, YK_VALUE_SIZE, w->solution[c * w->sides]);
        YkRef part = yk_graph_multiply(g, size, w->solution[k * w->sides + side]);
        value = yk_graph_subtract(g, value, part);
    }
    return value;
}

// Turns the force of a planet's pin in the equations, which count the teeth of all N equal planets and the mass of one,
// into that of the one in the file.
static void take_own(YkBalanceSystem *w, const YkJoint *pin, YkRef *out)
{
    YkProgram *p = w->f->program;
    YkGraph *g = &p->graph;
    int32_t planet = pin->body[pin->copied_side];
    YkRefVec force = yk_graph_vec_scale(g, yk_graph_number(g, 1.0 / pin->copies), (YkRefVec){out[0], out[1]});
    if (p->model->bodies[planet].has_mass) {
        YkRefVec center = yk_forces_center(p, planet);
        YkRefVec pull = yk_program_body_accel(p, planet, center, &w->velocities, &w->accelerations);
        double others = (pin->copied_side == 1 ? 1 : -1) * (1 - 1.0 / pin->copies);
        YkRef mass = yk_graph_multiply(g, yk_graph_number(g, others), yk_forces_mass(p, planet));
        pull = yk_graph_vec_scale(g, mass, yk_graph_vec_subtract(g, pull, w->f->gravity));
        force = yk_graph_vec_add(g, force, pull);
    }
    out[0] = force.x, out[1] = force.y;
}

// Returns the force of the gear, rack, belt or cam of an unknown on its second body, with the separating force of
// gears' flanks.
static YkRefVec contact_force(YkBalanceSystem *w, size_t k)
{
    YkGraph *g = &w->f->program->graph;
    const YkUnknown *c = &w->columns[k];
    const YkRelation *r = &w->f->program->mech->relations[c->relation];
    int32_t copies = r->kind == YK_RELATION_GEAR ? w->f->program->model->gears[r->index].copies : 0;
    YkRefVec force = yk_graph_vec_scale(g, yk_balance_value(w, k), c->force);
    if (c->radial != 0) {
        YkRef size = yk_graph_unary(g, YK_VALUE_SIZE, yk_balance_value(w, k));
        force = yk_graph_vec_add(g, force, yk_graph_vec_scale(g, size, w->radial[c->radial]));
    }
    return copies > 1 ? yk_graph_vec_scale(g, yk_graph_number(g, 1.0 / copies), force) : force;
}

// Returns what the unknown of a relation says besides its force: the effort of a law along its coordinate, or a couple.
static YkRef contact_moment(YkBalanceSystem *w, size_t k)
{
    YkProgram *p = w->f->program;
    YkGraph *g = &p->graph;
    const YkUnknown *c = &w->columns[k];
    const YkRelation *r = &p->mech->relations[c->relation];
    if (r->kind != YK_RELATION_LAW) return yk_graph_multiply(g, yk_balance_value(w, k), c->moment);
    bool is_distance = p->model->coordinates[p->model->follows[r->index].coordinate].is_distance;
    return yk_graph_multiply(g, yk_balance_value(w, k), yk_graph_number(g, is_distance ? 1 : w->unit));
}

// Reads what gears, racks, belts, cams and laws transmit.
static bool read_contacts(YkBalanceSystem *w)
{
    YkProgram *p = w->f->program;
    YkGraph *g = &p->graph;
    w->f->contact = YK_NEW(p->arena, YkContactRef, p->mech->relation_count + 1);
    if (!w->f->contact) return false;
    for (size_t k = 0; k < w->count; k++) {
        const YkUnknown *c = &w->columns[k];
        if (c->relation == YK_NONE) continue;
        w->f->contact[c->relation] = (YkContactRef){.force = contact_force(w, k),
                                                    .moment = contact_moment(w, k),
                                                    .has_force = !yk_graph_is_zero_vec(g, c->force)};
    }
    return true;
}

// Couples are unknown over the unit, as the rows of moments are. Free joints transmit nothing: what their halves do is
// that of efforts on the way past the carriage.
bool yk_balance_read(YkBalanceSystem *w)
{
    YkProgram *p = w->f->program;
    YkGraph *g = &p->graph;
    YkRef *reaction = w->f->reaction = YK_NEW(p->arena, YkRef, 3 * p->model->joint_count + 1);
    if (!reaction || !read_contacts(w)) return false;
    for (size_t k = 0; k < 3 * p->model->joint_count; k++) reaction[k] = yk_graph_number(g, 0);
    for (size_t k = 0; k < w->count; k++) {
        const YkUnknown *c = &w->columns[k];
        if (c->input != YK_NONE || c->relation != YK_NONE || p->model->joints[c->joint].is_free) continue;
        YkRef value = yk_balance_value(w, k), *out = reaction + 3 * c->joint;
        if (c->is_couple) {
            out[2] = yk_graph_multiply(g, value, yk_graph_number(g, w->unit));
        } else {
            out[0] = yk_graph_add(g, out[0], yk_graph_multiply(g, value, c->force.x));
            out[1] = yk_graph_add(g, out[1], yk_graph_multiply(g, value, c->force.y));
        }
    }
    for (size_t j = 0; j < p->model->joint_count; j++)
        if (p->model->joints[j].copies > 1) take_own(w, &p->model->joints[j], reaction + 3 * j);
    return true;
}

bool yk_balance_make(YkBalanceSystem *w, YkForces *f, const YkRates *r, const YkRates *s, double unit)
{
    YkProgram *p = f->program;
    *w = (YkBalanceSystem){.f = f, .velocities = *r, .accelerations = *s, .unit = unit, .sides = 1};
    size_t rows = 3 * (p->model->body_count - 1);
    size_t most = 3 * p->model->joint_count + p->mech->input_count + p->mech->relation_count;
    w->columns = YK_NEW(p->arena, YkUnknown, most + 1);
    w->radial = YK_NEW(p->arena, YkRefVec, p->mech->relation_count + 1);
    if (yk_arena_failed(p->arena)) return false;
    yk_graph_section(&p->graph, "Free bodies: three equations each, their reactions and efforts unknown.");
    make_columns(w);
    yk_meshes_columns(w);
    w->n = w->count;
    if (f->balances_dry) {
        w->first_dry = w->sides;
        w->dry_count = f->dry_count;
        w->sides += f->dry_count;
    }
    if (w->count < rows || (w->count > rows && !f->takes_least)) {
        f->why_no_reactions = "constraints repeat others, so that they are not determined";
        return false;
    }
    w->system = YK_NEW(p->arena, YkRef, rows * (w->n + w->sides) + 1);
    if (yk_arena_failed(p->arena)) return false;
    make_system(w);
    f->is_least = w->count > rows;
    if (f->is_least && !yk_balance_widen(w)) return false;
    w->solution = YK_NEW(p->arena, YkRef, w->n * w->sides + 1);
    return w->solution != NULL;
}

void yk_forces_reactions(YkForces *f, const YkRates *r, const YkRates *s)
{
    YkBalanceSystem w;
    f->takes_least = true;
    bool made = yk_balance_make(&w, f, r, s, yk_program_size(f->program));
    if (made && !yk_balance_solve(&w)) {
        f->program->failed |= w.ran_out;
        f->why_no_reactions = "constraints repeat others, so that they are not determined";
        return;
    }
    if (made ? !yk_balance_read(&w) : !f->why_no_reactions) f->program->failed = true;
}
