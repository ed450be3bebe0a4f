// Multipliers: one for each scalar equation of the loops and for each relation, with the force that each of them is.
//
// The convention is M q'' + ... + J^T lambda = Q. A loop is the first body's point minus the second's, so lambda is the
// force that the first body exerts on the second (for a row of angles: the moment that the second exerts on the first).
#include "derive/forces/free_bodies.h"
#include "derive/relations.h"

static void add_row(const YkDeriveForces *f, int32_t joint, const YkPoisson *row, const YkPoisson *is)
{
    YkDeriveMultipliers *m = f->multipliers;
    size_t k = m->count++;
    m->rows[k] = row;
    m->identities[k] = is;
    m->joint[k] = joint;
    m->symbols[k] = yk_derive_symbol(f->d, yk_derive_numbered(f->d, "lambda", k + 1), YK_RING_FORCE);
}

// Notes what else acts across a joint that closes a loop. A spring along the joint's own distance also pulls: its
// energy is part of the equations, its force part of the multiplier. And relations assume that the joint holds its
// bodies together: what they exert on one of them counts as if it came over the joint.
typedef struct Across {
    const YkPoisson *force, *moment; // on the second body
} Across;

static void add_held(const YkDeriveForces *f, const YkDeriveContact *c, const YkDeriveHolder *holder, Across *sum)
{
    YkRing *ring = f->d->ring;
    sum->force = (holder->side ? yk_ring_add : yk_ring_subtract)(ring, sum->force, c->push.force);
    if (f->d->model->joints[holder->joint].kind != YK_SLIDE) return; // the relation counts with the body's own angle
    const YkPoisson *arm = yk_derive_joint_arm((YkDeriveForces *)f, holder->joint, holder->side);
    const YkPoisson *moment =
        yk_ring_subtract(ring, yk_derive_moment_of(f, &c->push), yk_ring_cross(ring, arm, c->push.force));
    sum->moment = (holder->side ? yk_ring_add : yk_ring_subtract)(ring, sum->moment, moment);
}

static Across across(const YkDeriveForces *f, int32_t joint)
{
    YkRing *ring = f->d->ring;
    Across sum = {f->joint_force[joint], f->joint_moment[joint]};
    size_t count;
    const int32_t *pushes = yk_derive_pushes_on(f, f->d->model->joints[joint].body[1], &count);
    for (size_t k = 0; k < count; k++) {
        const YkDeriveLoad *load = &f->loads[pushes[k] / 2];
        if (pushes[k] % 2 == 0 && load->joint == joint && load->energy)
            sum.force = yk_ring_add(ring, sum.force, load->push[0].force);
    }
    for (size_t k = f->joint_contact_count; k < f->contact_count; k++)
        for (size_t h = 0; h < f->contacts[k].holder_count; h++)
            if (f->contacts[k].holders[h].joint == joint)
                add_held(f, &f->contacts[k], &f->contacts[k].holders[h], &sum);
    return sum;
}

static void enter_loop(const YkDeriveForces *f, const YkDeriveLoop *loop)
{
    YkDerivation *d = f->d;
    YkRing *ring = d->ring;
    const YkJoint *j = &d->model->joints[loop->joint];
    const Across all = across(f, loop->joint);
    const YkPoisson *axes = yk_ring_conjugate(ring, d->bodies[loop->axes].unit);
    const YkPoisson *sum = yk_ring_multiply(ring, axes, loop->path.sum);
    const YkPoisson *force = yk_ring_multiply(ring, axes, all.force);
    const YkPoisson *x = yk_ring_real(ring, sum), *y = yk_ring_imaginary(ring, sum);
    add_row(f, loop->joint, x, yk_ring_real(ring, force));
    add_row(f, loop->joint, y, yk_ring_imaginary(ring, force));
    if (!loop->angle) return;
    const YkPoisson *angle = yk_derive_axes_angle(d, j->body[1]);
    angle = yk_ring_subtract(ring, angle, yk_derive_axes_angle(d, j->body[0]));
    angle = yk_ring_subtract(ring, angle, yk_derive_expression(d, j->turned_expr));
    add_row(f, loop->joint, angle, yk_ring_negate(ring, all.moment));
}

bool yk_derive_allocate_multipliers(YkDeriveForces *f)
{
    YkArena *arena = f->d->arena;
    size_t most = 3 * f->d->mech->loop_count + f->d->mech->relation_count + 1;
    YkDeriveMultipliers *m = f->multipliers = YK_NEW(arena, YkDeriveMultipliers, 1);
    if (!m) return false;
    m->rows = YK_NEW(arena, const YkPoisson *, most);
    m->identities = YK_NEW(arena, const YkPoisson *, most);
    m->symbols = YK_NEW(arena, int32_t, most);
    m->joint = YK_NEW(arena, int32_t, most);
    return !yk_arena_failed(arena);
}

const YkDeriveMultipliers *yk_derive_multipliers(const YkDeriveForces *f)
{
    YkDerivation *d = f->d;
    if (f->multipliers->is_made) return f->multipliers;
    f->multipliers->is_made = true;
    const YkDeriveLoop *loops = yk_derive_loops(d);
    for (size_t k = 0; k < d->loop_count; k++) enter_loop(f, &loops[k]);
    for (size_t k = 0; k < d->tie_count; k++) add_row(f, YK_NONE, NULL, yk_ring_negate(d->ring, f->meshes[k].effort));
    return f->multipliers;
}

const char *yk_derive_row_name(const YkDeriveForces *f, size_t row)
{
    const YkDerivation *d = f->d;
    int32_t joint = f->multipliers->joint[row];
    return joint != YK_NONE ? d->model->joints[joint].name : d->ties[row - (f->multipliers->count - d->tie_count)].name;
}
