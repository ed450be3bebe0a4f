// Enters the loads: gravity, springs and dampers, friction, forces, efforts, and the efforts of drives.
#include "derive/forces/free_bodies.h"

// --- Building

static YkDeriveLoad *add_load(YkDeriveForces *f, YkDeriveLoadKind kind, const char *name)
{
    YkDeriveLoad *load = &f->loads[f->load_count++];
    *load = (YkDeriveLoad){.kind = kind, .name = name, .joint = YK_NONE, .symbol = YK_NONE};
    return load;
}

static void push(YkDeriveForces *f, YkDeriveLoad *load, int32_t body, const YkPoisson *arm, const YkPoisson *force,
                 const YkPoisson *moment)
{
    const YkPoisson *zero = yk_ring_rational(f->d->ring, 0, 1);
    load->push[load->push_count++] =
        (YkDerivePush){body, arm ? arm : zero, force ? force : zero, moment ? moment : zero};
}

static void add_gravity(YkDeriveForces *f)
{
    YkDerivation *d = f->d;
    const YkPoisson *g = yk_derive_gravity(d);
    for (size_t b = 1; g && b < d->model->body_count; b++) {
        if (!d->model->bodies[b].has_mass || yk_ring_is_zero(g)) continue;
        YkDeriveLoad *load = add_load(f, YK_DERIVE_GRAVITY, d->model->bodies[b].name);
        const YkPoisson *weight = yk_ring_multiply(d->ring, f->bodies[b].mass, g);
        push(f, load, (int32_t)b, NULL, weight, NULL);
        if (f->bodies[b].position)
            load->energy = yk_ring_negate(d->ring, yk_ring_dot(d->ring, weight, f->bodies[b].position));
    }
}

// Returns the vector from a body's reference to the place where an effort along a joint acts; past a free joint's
// carriage.
static const YkPoisson *end_arm(YkDeriveForces *f, int32_t joint, int side)
{
    const YkModel *model = f->d->model;
    int32_t end[] = {(int32_t)(yk_joint_end(model, (size_t)joint, 0) - model->joints),
                     (int32_t)(yk_joint_end(model, (size_t)joint, 1) - model->joints)};
    const YkPoisson *arm = yk_derive_joint_arm(f, end[side], side);
    if (side == 1 || end[0] == end[1]) return arm;
    return yk_ring_add(f->d->ring, arm, yk_derive_joint_arm(f, end[1], 0));
}

// Adds an effort along a joint's freedom: on the second body, with its reaction on the first.
static YkDeriveLoad *add_along(YkDeriveForces *f, YkDeriveLoadKind kind, const char *name, int32_t joint,
                               bool is_distance, const YkPoisson *effort)
{
    YkDerivation *d = f->d;
    const YkJoint *j = &d->model->joints[joint];
    YkDeriveLoad *load = add_load(f, kind, name);
    load->joint = joint;
    int32_t body[] = {yk_joint_end(d->model, (size_t)joint, 0)->body[0],
                      yk_joint_end(d->model, (size_t)joint, 1)->body[1]};
    const YkPoisson *line = yk_ring_multiply(d->ring, d->bodies[j->body[0]].unit, yk_derive_along(d, joint));
    for (int side = 1; side >= 0; side--) {
        const YkPoisson *signed_effort = side ? effort : yk_ring_negate(d->ring, effort);
        if (is_distance)
            push(f, load, body[side], end_arm(f, joint, side), yk_ring_multiply(d->ring, signed_effort, line), NULL);
        else
            push(f, load, body[side], NULL, NULL, signed_effort);
    }
    return load;
}

// Returns a joint's freedom or its rate, body form.
static const YkPoisson *freedom_of(YkDerivation *d, int32_t joint, bool is_distance, bool rate)
{
    const YkJoint *j = &d->model->joints[joint];
    if (is_distance) {
        const YkDeriveCoordinate *c = &d->coordinates[d->joint_distance[joint]];
        return yk_ring_of(d->ring, rate ? c->rate : c->position);
    }
    if (rate) return yk_ring_subtract(d->ring, d->bodies[j->body[1]].spin, d->bodies[j->body[0]].spin);
    const YkPoisson *second = yk_derive_axes_angle(d, j->body[1]);
    return yk_ring_subtract(d->ring, second, yk_derive_axes_angle(d, j->body[0]));
}

static void add_damper_along(YkDeriveForces *f, const char *name, int32_t joint, bool is_distance,
                             const YkExpr *damping)
{
    const YkPoisson *c = yk_derive_strength(f->d, damping, "c", name),
                    *rate = freedom_of(f->d, joint, is_distance, true);
    if (!c || yk_ring_is_zero(c)) return;
    add_along(f, YK_DERIVE_DAMPER, name, joint, is_distance,
              yk_ring_negate(f->d->ring, yk_ring_multiply(f->d->ring, c, rate)));
}

// Adds the pull by a law of its own along a coordinate.
static void add_pull_along(YkDeriveForces *f, const YkSpring *spring)
{
    const YkCoordinate *c = &f->d->model->coordinates[spring->coordinate];
    if (!spring->force.expr) return;
    const YkPoisson *pull = yk_derive_load_value(f, &spring->force, c->is_distance ? "F_" : "tau_", spring->name);
    if (!pull || yk_ring_is_zero(pull)) return;
    add_along(f, YK_DERIVE_PULL, spring->name, c->joint, c->is_distance, yk_ring_negate(f->d->ring, pull));
}

static void add_spring_along(YkDeriveForces *f, const YkSpring *spring)
{
    YkRing *ring = f->d->ring;
    const YkCoordinate *c = &f->d->model->coordinates[spring->coordinate];
    const YkPoisson *k = yk_derive_strength(f->d, spring->stiffness_expr, "k", spring->name);
    const YkPoisson *stretch = freedom_of(f->d, c->joint, c->is_distance, false);
    stretch = yk_ring_subtract(ring, stretch, yk_derive_expression(f->d, spring->length_expr));
    if (k && !yk_ring_is_zero(k)) {
        const YkPoisson *pull = yk_ring_negate(ring, yk_ring_multiply(ring, k, stretch));
        YkDeriveLoad *load = add_along(f, YK_DERIVE_SPRING, spring->name, c->joint, c->is_distance, pull);
        load->energy = yk_ring_scale(ring, yk_ring_product(ring, (const YkPoisson *[]){k, stretch, stretch}, 3), 1, 2);
    }
    add_damper_along(f, spring->name, c->joint, c->is_distance, spring->damping_expr);
    add_pull_along(f, spring);
}

// Pulls both ends together by `tension` times the vector from the first to the second.
static YkDeriveLoad *add_between(YkDeriveForces *f, YkDeriveLoadKind kind, const YkSpring *spring,
                                 const YkPoisson *tension, const YkPoisson *line)
{
    YkDerivation *d = f->d;
    YkDeriveLoad *load = add_load(f, kind, spring->name);
    const YkPoisson *pull = yk_ring_multiply(d->ring, tension, line);
    for (int end = 0; end < 2; end++) {
        const YkPoisson *arm = yk_derive_arm(f, spring->body[end], yk_derive_at(d, spring->point[end]));
        push(f, load, spring->body[end], arm, end ? yk_ring_negate(d->ring, pull) : pull, NULL);
    }
    return load;
}

// Returns the spring's length: a symbol whose square is known. Its rate is a symbol too; written out it would fill
// pages.
static const YkDeriveLength *length_of(YkDeriveForces *f, const YkSpring *spring, const YkPoisson *square,
                                       bool is_damped)
{
    YkDerivation *d = f->d;
    YkRing *ring = d->ring;
    YkDeriveLength *length = &f->lengths[f->length_count];
    *length = (YkDeriveLength){.symbol = -1, .rate_symbol = YK_NONE, .square = square};
    for (const char *stem = "L_"; length->symbol < 0; stem = yk_derive_text(d, stem, "_", "")) {
        const char *name = yk_derive_text(d, stem, spring->name, ""), *rate = yk_derive_text(d, name, "'", "");
        if (d->failed || yk_ring_status(ring) != YK_RING_OK) return NULL;
        if (yk_ring_find(ring, name) >= 0 || yk_ring_find(ring, rate) >= 0) continue;
        length->symbol = yk_ring_root(ring, name, square);
        if (is_damped) length->rate_symbol = yk_ring_symbol(ring, rate, YK_RING_RATE);
    }
    length->rate = yk_ring_time_derivative(ring, yk_ring_of(ring, length->symbol));
    f->length_count++;
    return yk_ring_status(ring) == YK_RING_OK ? length : NULL;
}

// Adds the pull by a law of its own between points.
static void add_pull_between(YkDeriveForces *f, const YkSpring *spring, const YkDeriveLength *of, const YkPoisson *line)
{
    YkDerivation *d = f->d;
    if (!spring->force.expr) return;
    d->spring[0] = of->symbol;
    d->spring[1] = of->rate_symbol;
    const YkPoisson *pull = yk_derive_load_value(f, &spring->force, "F_", spring->name);
    if (!pull || yk_ring_is_zero(pull)) return;
    add_between(f, YK_DERIVE_PULL, spring, yk_ring_divide(d->ring, pull, yk_ring_of(d->ring, of->symbol)), line);
}

static void add_spring_between(YkDeriveForces *f, const YkSpring *spring)
{
    YkDerivation *d = f->d;
    YkRing *ring = d->ring;
    const YkPoisson *end[2];
    for (int e = 0; e < 2; e++) end[e] = yk_derive_position(d, spring->body[e], yk_derive_at(d, spring->point[e]));
    const YkPoisson *line = yk_ring_subtract(ring, end[1], end[0]), *square = yk_ring_dot(ring, line, line);
    const YkPoisson *k = yk_derive_strength(d, spring->stiffness_expr, "k", spring->name),
                    *c = yk_derive_strength(d, spring->damping_expr, "c", spring->name);
    const YkPoisson *free_length = yk_derive_expression(d, spring->length_expr);
    if (!k || !c || !free_length) return;
    const YkExpr *own = spring->force.expr;
    if (yk_ring_is_zero(free_length) && yk_ring_is_zero(c) && !own) { // needs no direction
        YkDeriveLoad *load = add_between(f, YK_DERIVE_SPRING, spring, k, line);
        load->energy = yk_ring_scale(ring, yk_ring_multiply(ring, k, square), 1, 2);
        return;
    }
    bool has_rate = !yk_ring_is_zero(c) || yk_expr_mentions(own, YK_OWN_RATE);
    const YkDeriveLength *of = length_of(f, spring, square, has_rate);
    if (!of) return;
    add_pull_between(f, spring, of, line);
    const YkPoisson *length = yk_ring_of(ring, of->symbol);
    if (!yk_ring_is_zero(k)) {
        const YkPoisson *stretch = yk_ring_subtract(ring, length, free_length);
        const YkPoisson *tension = yk_ring_divide(ring, yk_ring_multiply(ring, k, stretch), length);
        YkDeriveLoad *load = add_between(f, YK_DERIVE_SPRING, spring, tension, line);
        load->energy = yk_ring_scale(ring, yk_ring_product(ring, (const YkPoisson *[]){k, stretch, stretch}, 3), 1, 2);
    }
    if (yk_ring_is_zero(c)) return;
    const YkPoisson *rate = yk_ring_of(ring, of->rate_symbol);
    add_between(f, YK_DERIVE_DAMPER, spring, yk_ring_divide(ring, yk_ring_multiply(ring, c, rate), length), line);
}

// Adds dry friction and stops at one freedom, whose size depends on the pose.
static void add_dry(YkDeriveForces *f, const char *letter, int32_t joint, bool is_distance)
{
    YkDerivation *d = f->d;
    int32_t symbol = yk_derive_symbol(d, yk_derive_text(d, letter, d->model->joints[joint].name, ""), YK_RING_FORCE);
    if (symbol < 0) return;
    add_along(f, YK_DERIVE_DRY, d->model->joints[joint].name, joint, is_distance, yk_ring_of(d->ring, symbol))->symbol =
        symbol;
}

static void add_friction(YkDeriveForces *f)
{
    const YkModel *model = f->d->model;
    for (size_t j = 0; j < model->joint_count; j++) {
        const YkJoint *joint = &model->joints[j];
        if (!joint->has_friction) continue;
        bool slides = yk_part(joint->kind)->slides;
        add_damper_along(f, joint->name, (int32_t)j, slides, joint->friction.viscous_expr);
        if (joint->friction.coulomb_expr) add_dry(f, "R_", (int32_t)j, slides);
    }
    for (size_t k = 0; k < model->stop_count; k++) {
        const YkCoordinate *c = &model->coordinates[model->stops[k].coordinate];
        add_dry(f, "S_", c->joint, c->is_distance);
    }
}

static void add_forces(YkDeriveForces *f)
{
    YkDerivation *d = f->d;
    for (size_t k = 0; k < d->model->force_count; k++) {
        const YkForce *force = &d->model->forces[k];
        YkDeriveLoad *load = add_load(f, YK_DERIVE_FORCE, force->name);
        const YkPoisson *x = yk_derive_load_value(f, &force->x, force->name, "x");
        const YkPoisson *y = yk_derive_load_value(f, &force->y, force->name, "y");
        const YkPoisson *moment = yk_derive_load_value(f, &force->moment, force->name, "m");
        const YkPoisson *vector = yk_ring_add(d->ring, x, yk_ring_multiply(d->ring, yk_ring_i(d->ring), y));
        if (force->in_body_axes) vector = yk_ring_multiply(d->ring, d->bodies[force->body].unit, vector);
        push(f, load, force->body, yk_derive_arm(f, force->body, yk_derive_at(d, force->point)), vector, moment);
    }
}

static void add_efforts(YkDeriveForces *f)
{
    YkDerivation *d = f->d;
    const YkModel *model = d->model;
    for (size_t k = 0; k < model->effort_count; k++) {
        const YkEffort *effort = &model->efforts[k];
        const YkCoordinate *c = &model->coordinates[effort->coordinate];
        const YkPoisson *value = yk_derive_load_value(f, &effort->strength, c->is_distance ? "F_" : "tau_", c->name);
        if (value) add_along(f, YK_DERIVE_EFFORT, c->name, c->joint, c->is_distance, value);
    }
}

// Given inputs need an effort; in a machine without masses all inputs do.
static void add_drives(YkDeriveForces *f)
{
    YkDerivation *d = f->d;
    bool has_mass = false;
    for (size_t b = 1; b < d->model->body_count; b++) has_mass = has_mass || d->model->bodies[b].has_mass;
    for (size_t k = 0; k < d->tree_count; k++) {
        const YkDeriveCoordinate *c = &d->coordinates[k];
        if (!c->is_input || (has_mass && c->drive == YK_NONE)) continue;
        int32_t symbol =
            yk_derive_symbol(d, yk_derive_text(d, c->is_distance ? "F_" : "tau_", c->name, ""), YK_RING_FORCE);
        if (symbol < 0) return;
        add_along(f, YK_DERIVE_DRIVE, c->name, c->joint, c->is_distance, yk_ring_of(d->ring, symbol))->symbol = symbol;
        f->effort_coordinate[f->effort_count] = (int32_t)k;
        f->efforts[f->effort_count++] = symbol;
    }
}

bool yk_derive_enter_loads(YkDeriveForces *f)
{
    YkDerivation *d = f->d;
    const YkModel *model = d->model;
    size_t most =
        model->body_count + model->effort_count + model->force_count + 3 * model->spring_count + model->stop_count + 1;
    for (size_t j = 0; j < model->joint_count; j++) most += model->joints[j].has_friction ? 2 : 0;
    for (size_t k = 0; k < d->tree_count; k++) most += d->coordinates[k].is_input;
    f->loads = YK_NEW(d->arena, YkDeriveLoad, most);
    f->opaques =
        YK_NEW(d->arena, YkDeriveOpaque, model->effort_count + 3 * model->force_count + model->spring_count + 1);
    f->lengths = YK_NEW(d->arena, YkDeriveLength, model->spring_count + 2 * d->mech->relation_count + 1);
    f->ratios = YK_NEW(d->arena, YkDeriveRatio, d->mech->relation_count + 1);
    f->efforts = YK_NEW(d->arena, int32_t, d->coordinate_count + 1);
    f->effort_coordinate = YK_NEW(d->arena, int32_t, d->coordinate_count + 1);
    if (yk_arena_failed(d->arena)) return false;
    add_gravity(f);
    for (size_t k = 0; k < model->spring_count; k++) {
        if (model->springs[k].coordinate != YK_NONE)
            add_spring_along(f, &model->springs[k]);
        else
            add_spring_between(f, &model->springs[k]);
    }
    add_friction(f);
    add_forces(f);
    add_efforts(f);
    add_drives(f);
    return yk_derive_sort_pushes(f) && yk_derivation_is_well(d);
}
