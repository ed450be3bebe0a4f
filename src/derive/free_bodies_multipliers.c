// Multipliers: one for each scalar equation of the loops, and the joint's force that it is.
//
// The convention is M q'' + ... + J^T lambda = Q. A loop is the first body's point minus the second's, so lambda is the
// force that the first body exerts on the second (of a row of angles: the moment that the second exerts on the first).
#include "derive/free_bodies.h"

static const char *multiplier_name(YkDerivation *d, size_t number)
{
    YkText text = {0};
    yk_text_format(&text, "lambda%z", number);
    const char *name = yk_derive_text(d, yk_text_get(&text), "", "");
    yk_text_free(&text);
    return name;
}

static void add_row(YkDeriveForces *f, int32_t joint, const YkPoisson *row, const YkPoisson *is)
{
    size_t k = f->row_count++;
    f->rows[k] = row;
    f->identities[k] = is;
    f->row_joint[k] = joint;
    f->multipliers[k] = yk_derive_symbol(f->d, multiplier_name(f->d, k + 1), YK_RING_FORCE);
}

// A spring along the joint's own distance pulls, too: its energy is part of the equations, its force of the multiplier.
static const YkPoisson *force_across(const YkDeriveForces *f, int32_t joint)
{
    const YkPoisson *force = f->joint_force[joint];
    size_t count;
    const int32_t *pushes = yk_derive_pushes_on(f, f->d->model->joints[joint].body[1], &count);
    for (size_t k = 0; k < count; k++) {
        const YkDeriveLoad *load = &f->loads[pushes[k] / 2];
        if (pushes[k] % 2 == 0 && load->joint == joint && load->energy)
            force = yk_ring_add(f->d->ring, force, load->push[0].force);
    }
    return force;
}

static void enter_loop(YkDeriveForces *f, const YkDeriveLoop *loop)
{
    YkDerivation *d = f->d;
    YkRing *ring = d->ring;
    const YkJoint *j = &d->model->joints[loop->joint];
    const YkPoisson *axes = yk_ring_conjugate(ring, d->bodies[loop->axes].unit);
    const YkPoisson *sum = yk_ring_multiply(ring, axes, loop->path.sum);
    const YkPoisson *force = yk_ring_multiply(ring, axes, force_across(f, loop->joint));
    add_row(f, loop->joint, yk_ring_real(ring, sum), yk_ring_real(ring, force));
    add_row(f, loop->joint, yk_ring_imaginary(ring, sum), yk_ring_imaginary(ring, force));
    if (!loop->angle) return;
    const YkPoisson *angle =
        yk_ring_subtract(ring, yk_derive_axes_angle(d, j->body[1]), yk_derive_axes_angle(d, j->body[0]));
    angle = yk_ring_subtract(ring, angle, yk_derive_expression(d, j->turned_expr));
    add_row(f, loop->joint, angle, yk_ring_negate(ring, f->joint_moment[loop->joint]));
}

bool yk_derive_enter_multipliers(YkDeriveForces *f)
{
    YkDerivation *d = f->d;
    const YkDeriveLoop *loops = yk_derive_loops(d);
    if (!loops) return false;
    f->rows = YK_NEW(d->arena, const YkPoisson *, 3 * d->loop_count + 1);
    f->identities = YK_NEW(d->arena, const YkPoisson *, 3 * d->loop_count + 1);
    f->multipliers = YK_NEW(d->arena, int32_t, 3 * d->loop_count + 1);
    f->row_joint = YK_NEW(d->arena, int32_t, 3 * d->loop_count + 1);
    if (yk_arena_failed(d->arena)) return false;
    for (size_t k = 0; k < d->loop_count; k++) enter_loop(f, &loops[k]);
    return yk_derivation_is_well(d);
}
