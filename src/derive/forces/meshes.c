// Gears, racks, belts, cams and laws transmit one unknown each; the forces on all bodies are multiples of it. By
// virtual work the force belongs to the relation that it enforces, so its multiplier is minus the unknown times the
// lever through which it acts.
// - gears: N along the line of action, through the pitch point, which divides the line of centres as the teeth do.
//   Flanks push their wheels apart: the pressure angle alpha has the sign of N; N > 0 pushes the second wheel to the
//   left of the line of centres. Wheels on one axis: couples, T for each tooth.
// - racks: F along the rack at the pitch line
// - belts: couples T r, T the pull of one span less that of the other
// - cams: N along the common normal, at phi from the line of motion of a follower that slides (the pressure angle,
//   tan phi = (v - e) / h), otherwise from the carrier's x axis; a flat face is pushed along its normal. Couples, if a
//   follower turns about the cam's own pin. With two rollers it is the one that bears, for whose place there are
//   symbols.
// - laws: an effort along the coordinate that follows, and minus the law's slope times it along the other
// This is the model of free_bodies/meshes.c, derived anew.
#include "derive/forces/meshes.h"

// --- Racks and belts

static void make_rack(YkMeshMaking *m, const YkRelation *of)
{
    const YkRack *rack = &m->d->model->racks[of->index];
    YkRing *ring = m->ring;
    const int32_t body[] = {rack->pinion, rack->rack};
    int sign = m->d->model->joints[rack->slide].body[1] == rack->rack ? 1 : -1;
    m->point = yk_derive_pitch_name(m->d, m->d->model->gear_count + (size_t)of->index);
    yk_mesh_unknown(
        m, "F", body,
        yk_derive_text(m->d, "the force between pinion and rack at their pitch point ", m->point, ", along the rack"));
    const YkPoisson *u = yk_ring_scale(ring, yk_mesh_line(m, rack->slide), sign, 1);
    const YkPoisson *across = yk_ring_product(
        ring, (const YkPoisson *[]){yk_ring_i(ring), u, yk_derive_expression(m->d, rack->radius_expr)}, 3);
    const YkPoisson *down = yk_ring_scale(ring, across, -rack->sense, 1);
    const YkPoisson *pitch = yk_ring_add(ring, yk_derive_origin(m->d, rack->pinion), down);
    const YkPoisson *arm[] = {yk_ring_add(ring, yk_mesh_center(m, rack->pinion), down),
                              yk_mesh_arm(m, rack->rack, pitch)};
    const YkMeshHeld held[] = {yk_mesh_axis(m, rack->pinion, rack->carrier).held,
                               yk_mesh_held_by(m, rack->slide, sign > 0)};
    yk_mesh_force(m, "F", body, held, arm, yk_ring_multiply(ring, m->unknown, u));
    m->mesh->effort = m->unknown;
}

static void make_belt(YkMeshMaking *m, const YkRelation *of)
{
    const YkBelt *belt = &m->d->model->belts[of->index];
    const YkPoisson *second = yk_derive_expression(m->d, belt->radius_expr[1]);
    yk_mesh_unknown(m, "T", belt->body, "the pull of one span of the belt less that of the other");
    yk_mesh_couples(m, belt->body, belt->carrier, yk_derive_expression(m->d, belt->radius_expr[0]),
                    yk_ring_scale(m->ring, second, belt->is_crossed ? 1 : -1, 1));
    m->mesh->effort = m->unknown;
}

// --- Laws

// Adds a multiple of the unknown along a coordinate: on its joint's second body, and its reaction on the first.
static void push_along(YkMeshMaking *m, const YkCoordinate *coordinate, const YkPoisson *multiple)
{
    YkRing *ring = m->ring;
    int32_t joint = coordinate->joint;
    const int32_t *body = m->d->model->joints[joint].body;
    if (coordinate->is_distance) {
        const YkPoisson *arm[2];
        for (int side = 0; side < 2; side++) arm[side] = yk_derive_joint_arm(m->f, joint, side);
        const YkPoisson *factors[] = {m->unknown, multiple, yk_mesh_line(m, joint)};
        yk_mesh_force(m, "Q", body, (YkMeshHeld[]){{NULL, 0}, yk_mesh_held_by(m, joint, 1)}, arm,
                      yk_ring_product(ring, factors, 3));
        return;
    }
    const YkPoisson *zero = yk_ring_rational(ring, 0, 1), *moment = yk_ring_multiply(ring, multiple, m->unknown);
    for (int k = 0; k < 2; k++) {
        YkDerivePush push = {body[k], zero, zero, k ? moment : yk_ring_negate(ring, moment)};
        yk_mesh_add_contact(m, (YkDeriveContact){.by = m->d->model->bodies[body[!k]].name,
                                                 .between = m->between,
                                                 .moment = "M",
                                                 .is_negative = k == 0,
                                                 .push = push});
        m->mesh->push = push;
    }
}

static void make_follow(YkMeshMaking *m, const YkRelation *of)
{
    const YkModel *model = m->d->model;
    const YkFollow *follow = &model->follows[of->index];
    const YkCoordinate *own = &model->coordinates[follow->coordinate], *other = &model->coordinates[follow->of];
    YkRing *ring = m->ring;
    yk_mesh_unknown(m, own->is_distance ? "F" : "T", model->joints[own->joint].body,
                    "what the law's drive exerts along the coordinate that follows");
    m->mesh->effort = m->unknown;
    m->between = other->name;
    push_along(m, other, yk_ring_negate(ring, yk_ring_of(ring, m->tie->function + 1)));
    m->between = own->name;
    push_along(m, own, yk_ring_rational(ring, 1, 1)); // last: the unknown's value is taken from it
}

bool yk_derive_enter_meshes(YkDeriveForces *f)
{
    typedef void (*Maker)(YkMeshMaking *, const YkRelation *);
    static const Maker makers[] = {yk_mesh_gear, make_rack, make_belt, yk_mesh_cam, make_follow}; // as YkRelationKind
    YkDerivation *d = f->d;
    const YkDeriveRelation *ties = yk_derive_ties(d);
    f->meshes = YK_NEW(d->arena, YkDeriveMesh, d->tie_count + 1);
    if (!f->meshes) return false;
    for (size_t k = 0; k < d->tie_count && yk_derivation_is_well(d); k++) {
        YkMeshMaking m = {
            .f = f, .d = d, .ring = d->ring, .index = k, .tie = &ties[k], .mesh = &f->meshes[k], .point = ties[k].name};
        *m.mesh = (YkDeriveMesh){.symbol = YK_NONE, .lean = YK_NONE, .bearing = {YK_NONE, YK_NONE}};
        makers[ties[k].kind](&m, &d->mech->relations[k]);
    }
    return yk_derivation_is_well(d);
}
