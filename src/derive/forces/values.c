// The forces of a derivation, made at first use, with values from the numeric engine and relations for proofs.
#include <math.h>
#include "derive/forces/free_bodies.h"
#include "dynamics/dynamics.h"
#include "elementary/elementary.h"

// --- Values

static void fill_opaque(const YkDeriveOpaque *o, double *values)
{
    double variables[64], law[YK_LAW_ORDER + 1];
    if (o->variable_count > sizeof variables / sizeof *variables) return;
    for (size_t k = 0; k < o->variable_count; k++) variables[k] = values[o->variables[k]];
    double x = yk_formula_eval(o->formula, yk_formula_is_constant(o->formula) ? NULL : variables);
    if (o->law && isfinite(x)) {
        yk_law_eval(o->law, x, law);
        x = law[0];
    }
    values[o->symbol] = x;
}

// Fills in the engine's dry friction and stops at a freedom.
static void fill_dry(const YkDeriveForces *f, YkDynamics *dynamics, double *values)
{
    for (size_t k = 0; k < f->load_count; k++)
        if (f->loads[k].kind == YK_DERIVE_DRY) values[f->loads[k].symbol] = 0;
    for (size_t i = 0; i < dynamics->loads->item_count; i++) {
        const YkLoadItem *item = &dynamics->loads->items[i];
        if (item->kind != YK_LOAD_COULOMB && item->kind != YK_LOAD_STOP) continue;
        for (size_t k = 0; k < f->load_count; k++) // the first load of this joint takes all
            if (f->loads[k].kind == YK_DERIVE_DRY && f->loads[k].joint == item->joint &&
                yk_ring_is_zero(f->loads[k].push[0].moment) == item->is_distance) {
                values[f->loads[k].symbol] += item->dry;
                break;
            }
    }
}

// Fills accelerations that are symbols, each from that of the body before.
static void fill_steps(const YkDeriveForces *f, double *values)
{
    const YkDerivation *d = f->d;
    for (size_t k = 0; k < d->model->body_count; k++) {
        int32_t b = d->mech->tree_order[k];
        const YkDeriveMass *m = &f->bodies[b];
        if (m->position) continue;
        YkVec before = yk_ring_value(d->ring, f->bodies[d->bodies[b].parent].acceleration, values);
        YkVec own = yk_add(before, yk_ring_value(d->ring, m->step, values));
        values[m->symbols[0]] = own.x, values[m->symbols[1]] = own.y;
    }
}

static void add_part(const YkDeriveForces *f, size_t k, const YkReaction *r, double sign, double *values)
{
    const YkDerivation *d = f->d;
    double *value = &values[f->reactions[k]];
    switch (f->reaction_part[k]) {
    case 'x':
        *value += sign * r->force[0];
        break;
    case 'y':
        *value += sign * r->force[1];
        break;
    case 'm':
        *value += sign * r->moment;
        break;
    default: { // along the normal: the force's element is a multiple of it
        const YkPoisson *normal =
            yk_ring_coefficient(d->ring, f->joint_force[f->reaction_joint[k]], f->reactions[k], 1);
        YkVec n = yk_ring_value(d->ring, normal, values);
        *value += sign * (r->force[0] * n.x + r->force[1] * n.y);
    }
    }
}

// The equations of planets that share a load have the forces of all of them together.
static YkReaction whole_reaction(const YkDynamics *dynamics, size_t joint)
{
    YkReaction r = yk_dynamics_reaction(dynamics, joint);
    r.force[0] = dynamics->whole[joint].x, r.force[1] = dynamics->whole[joint].y;
    return r;
}

static void fill_reaction(const YkDeriveForces *f, size_t k, YkDynamics *dynamics, double *values)
{
    const YkModel *model = f->d->model;
    int32_t joint = f->reaction_joint[k], body = f->reaction_body[k];
    values[f->reactions[k]] = 0;
    if (body == YK_NONE) {
        YkReaction r = whole_reaction(dynamics, (size_t)joint);
        add_part(f, k, &r, 1, values);
        return;
    }
    int32_t j = f->junctions[f->junction_of[joint]].first_joint;
    for (; j != YK_NONE; j = f->next_at_junction[j]) // all pins of the junction on this body
        for (int side = 0; side < 2; side++) {
            if (model->joints[j].body[side] != body) continue;
            YkReaction r = whole_reaction(dynamics, (size_t)j);
            add_part(f, k, &r, side ? 1 : -1, values);
        }
}

static void fill_lean(const YkDeriveForces *f, const YkDeriveMesh *mesh, double *values)
{
    if (mesh->lean == YK_NONE) return;
    YkVec direction = mesh->direction ? yk_ring_value(f->d->ring, mesh->direction, values) : yk_vec(0, 0);
    values[mesh->lean] = mesh->direction ? yk_atan2(direction.y, direction.x) : mesh->lean_value;
}

static void fill_bearing(const YkDeriveMesh *mesh, bool is_second, double *values)
{
    for (int k = 0; k < 2; k++)
        if (mesh->bearing[k] != YK_NONE) values[mesh->bearing[k]] = mesh->bearing_value[is_second][k];
}

// Fills a relation's unknown: the engine's force (or moment) on the second body is a multiple of it.
static void fill_mesh(const YkDeriveForces *f, size_t tie, const YkState *state, YkDynamics *dynamics, double *values)
{
    YkRing *ring = f->d->ring;
    const YkDeriveMesh *mesh = &f->meshes[tie];
    YkMeshForce found = yk_free_bodies_mesh(dynamics->bodies, &state->space, tie);
    if (mesh->lean != YK_NONE && !mesh->direction)
        values[mesh->lean] = found.is_backward ? -mesh->lean_value : mesh->lean_value;
    if (mesh->bearing[0] != YK_NONE && found.is_backward) { // elsewhere, with another normal
        fill_bearing(mesh, true, values);
        yk_ring_complete(ring, values);
        fill_lean(f, mesh, values);
    }
    bool is_force = !yk_ring_is_zero(mesh->push.force);
    const YkPoisson *of = is_force ? mesh->push.force : mesh->push.moment;
    YkVec unit = yk_ring_value(ring, yk_ring_coefficient(ring, of, mesh->symbol, 1), values);
    YkVec whole = is_force ? found.force : yk_vec(found.moment, 0);
    values[mesh->symbol] = yk_dot(whole, unit) / yk_dot(unit, unit);
}

// Quotients.
static void fill_constants(const YkDeriveForces *f, double *values)
{
    for (size_t k = 0; k < f->ratio_count; k++) {
        const YkDeriveRatio *r = &f->ratios[k];
        yk_ring_complete(f->d->ring, values);
        values[r->symbol] =
            yk_ring_value(f->d->ring, r->over, values).x / yk_ring_value(f->d->ring, r->under, values).x;
    }
}

// Fills the rates of springs' lengths.
static void fill_rates(const YkDeriveForces *f, double *values)
{
    if (f->length_count > 0) yk_ring_complete(f->d->ring, values);
    for (size_t k = 0; k < f->length_count; k++)
        if (f->lengths[k].rate_symbol != YK_NONE)
            values[f->lengths[k].rate_symbol] = yk_ring_value(f->d->ring, f->lengths[k].rate, values).x;
}

static void fill_forces(void *context, const YkState *state, YkDynamics *dynamics, double *values)
{
    const YkDeriveForces *f = context;
    (void)state;
    for (size_t k = 0; k < f->d->tie_count; k++) fill_bearing(&f->meshes[k], false, values);
    fill_constants(f, values);
    fill_rates(f, values); // the force of a spring may depend on it
    for (size_t k = 0; k < f->opaque_count; k++) fill_opaque(&f->opaques[k], values);
    for (const YkDeriveLump *l = f->lumps[0]; l; l = l->next)
        values[l->symbol] = yk_ring_value(f->d->ring, l->value, values).x;
    yk_ring_complete(f->d->ring, values);
    // Lines of action as if the unknowns of gears and of pairs of rollers were positive, until a pose says otherwise:
    for (size_t k = 0; k < f->d->tie_count; k++) fill_lean(f, &f->meshes[k], values);
    fill_steps(f, values);
    if (!dynamics) return;
    fill_dry(f, dynamics, values);
    for (size_t k = 0; k < f->effort_count; k++)
        values[f->efforts[k]] = yk_dynamics_effort(dynamics, (size_t)f->effort_coordinate[k]);
    for (size_t k = 0; k < f->reaction_count; k++)
        if (f->reaction_part[k] != 'r') fill_reaction(f, k, dynamics, values);
    for (size_t k = 0; k < f->d->tie_count; k++) fill_mesh(f, k, state, dynamics, values);
    const YkDeriveMultipliers *m = f->multipliers; // those that a section has made
    for (size_t k = 0; k < m->count; k++) values[m->symbols[k]] = yk_ring_value(f->d->ring, m->identities[k], values).x;
}

// --- Relations, for equations derived by hand

static void relate(YkDerivation *d, const YkPoisson *zero)
{
    const YkPoisson *parts[] = {yk_ring_real(d->ring, zero), yk_ring_imaginary(d->ring, zero)};
    for (int k = 0; k < 2; k++)
        if (parts[k] && !yk_ring_is_zero(parts[k])) yk_derive_add_relation(d, parts[k]);
}

static void relate_length(YkDerivation *d, const YkDeriveLength *length)
{
    if (length->rate_symbol == YK_NONE) return;
    relate(d, yk_ring_subtract(d->ring, yk_ring_of(d->ring, length->rate_symbol), length->rate));
    yk_derive_add_unknown(d, length->rate_symbol);
}

static void relate_step(const YkDeriveForces *f, int32_t body)
{
    YkDerivation *d = f->d;
    const YkDeriveMass *m = &f->bodies[body];
    if (m->position) return;
    const YkPoisson *is = yk_ring_add(d->ring, f->bodies[d->bodies[body].parent].acceleration, m->step);
    relate(d, yk_ring_subtract(d->ring, m->acceleration, is));
    for (int k = 0; k < 2; k++) yk_derive_add_unknown(d, m->symbols[k]);
}

static bool add_relations(const YkDeriveForces *f)
{
    YkDerivation *d = f->d;
    const YkDeriveMultipliers *m = yk_derive_multipliers(f);
    for (size_t k = 0; k < f->length_count; k++) relate_length(d, &f->lengths[k]);
    for (size_t b = 1; b < d->model->body_count; b++) {
        relate(d, yk_derive_newton(f, (int32_t)b));
        relate(d, yk_derive_euler(f, (int32_t)b));
        relate_step(f, (int32_t)b);
    }
    for (size_t k = 0; k < f->junction_count; k++) relate(d, f->junctions[k].force);
    for (size_t k = 0; k < m->count; k++)
        relate(d, yk_ring_subtract(d->ring, yk_ring_of(d->ring, m->symbols[k]), m->identities[k]));
    for (size_t k = 0; k < f->reaction_count; k++) yk_derive_add_unknown(d, f->reactions[k]);
    for (size_t k = 0; k < f->effort_count; k++) yk_derive_add_unknown(d, f->efforts[k]);
    for (size_t k = 0; k < m->count; k++) yk_derive_add_unknown(d, m->symbols[k]);
    return yk_derivation_is_well(d);
}

static YkDeriveForces *make(YkDerivation *d)
{
    YkDeriveForces *f = YK_NEW(d->arena, YkDeriveForces, 1);
    if (!f) return NULL;
    *f = (YkDeriveForces){.d = d};
    bool well = yk_derive_enter_masses(f) && yk_derive_enter_loads(f) && yk_derive_enter_contacts(f) &&
                yk_derive_allocate_multipliers(f);
    return well && yk_derive_add_source(d, fill_forces, f) ? f : NULL;
}

// The derivation finds its forces by the source of their values.
const YkDeriveForces *yk_derive_forces(YkDerivation *d)
{
    for (size_t k = 0; k < d->source_count; k++)
        if (d->sources[k].fill == fill_forces) return d->sources[k].context;
    return make(d);
}

bool yk_derive_enter_forces(YkDerivation *d)
{
    YkDeriveForces *f = (YkDeriveForces *)yk_derive_forces(d);
    if (!f || f->is_related) return f != NULL;
    f->is_related = true;
    return add_relations(f);
}
