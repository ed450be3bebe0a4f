// Newton's and Euler's equations of one body, and their projection on the motions that the joints allow.
#include "derive/forces/free_bodies.h"
#include "derive/relations.h"

static const YkPoisson *newton(const YkDeriveForces *f, int32_t body)
{
    YkRing *ring = f->d->ring;
    const YkPoisson *sum = yk_ring_rational(ring, 0, 1);
    size_t count;
    const int32_t *contacts = yk_derive_contacts_on(f, body, &count);
    for (size_t k = 0; k < count; k++) sum = yk_ring_add(ring, sum, f->contacts[contacts[k]].push.force);
    const int32_t *pushes = yk_derive_pushes_on(f, body, &count);
    for (size_t k = 0; k < count; k++) sum = yk_ring_add(ring, sum, f->loads[pushes[k] / 2].push[pushes[k] % 2].force);
    return yk_ring_subtract(ring, sum, yk_ring_multiply(ring, f->bodies[body].mass, f->bodies[body].acceleration));
}

const YkPoisson *yk_derive_newton(const YkDeriveForces *f, int32_t body)
{
    if (!f->newton[body]) f->newton[body] = yk_ring_keep(f->d->ring, newton(f, body));
    return f->newton[body];
}

static const YkPoisson *euler(const YkDeriveForces *f, int32_t body)
{
    YkRing *ring = f->d->ring;
    const YkPoisson *sum =
        yk_ring_negate(ring, yk_ring_multiply(ring, f->bodies[body].inertia, f->d->bodies[body].spin_rate));
    size_t count;
    const int32_t *contacts = yk_derive_contacts_on(f, body, &count);
    for (size_t k = 0; k < count; k++)
        sum = yk_ring_add(ring, sum, yk_derive_moment_of(f, &f->contacts[contacts[k]].push));
    const int32_t *pushes = yk_derive_pushes_on(f, body, &count);
    for (size_t k = 0; k < count; k++)
        sum = yk_ring_add(ring, sum, yk_derive_moment_of(f, &f->loads[pushes[k] / 2].push[pushes[k] % 2]));
    return sum;
}

const YkPoisson *yk_derive_euler(const YkDeriveForces *f, int32_t body)
{
    if (!f->euler[body]) f->euler[body] = yk_ring_keep(f->d->ring, euler(f, body));
    return f->euler[body];
}

// --- Partial velocities, d(velocity)/d(rate) = d(position)/d(coordinate) in body form

// The partial velocity of a body's spin is 1 or 0.
static bool is_turned_by(const YkDeriveForces *f, int32_t body, size_t coordinate)
{
    YkDeriveFreedom freedom = yk_derive_freedom(f->d, coordinate);
    return freedom.body != YK_NONE && f->d->bodies[body].angle == freedom.position;
}

static const YkPoisson *partial_position(const YkDeriveForces *f, const YkPoisson *position, size_t coordinate)
{
    return yk_ring_partial(f->d->ring, position, yk_derive_freedom(f->d, coordinate).position);
}

const YkPoisson *yk_derive_projected(const YkDeriveForces *f, size_t coordinate)
{
    YkDerivation *d = f->d;
    YkRing *ring = d->ring;
    size_t bodies = yk_model_body_count(d->model), count = 0, turned = 0;
    // Virtual work of forces, complex: the real parts count; then of moments.
    const YkPoisson **works = YK_NEW(d->arena, const YkPoisson *, 2 * bodies + f->junction_count + 1);
    const YkPoisson **moments = works ? works + bodies + f->junction_count : NULL;
    if (!works) return NULL;
    for (size_t b = 1; b < bodies; b++) {
        const YkPoisson *shift = partial_position(f, f->bodies[b].position, coordinate);
        if (!yk_ring_is_zero(shift))
            works[count++] = yk_ring_multiply(ring, yk_ring_conjugate(ring, shift), yk_derive_newton(f, (int32_t)b));
        if (is_turned_by(f, (int32_t)b, coordinate)) moments[turned++] = yk_derive_euler(f, (int32_t)b);
    }
    for (size_t k = 0; k < f->junction_count; k++) {
        YkDerivePlace place = f->junctions[k].place;
        const YkPoisson *at = yk_derive_position(d, place.body, yk_derive_at(d, place.point));
        const YkPoisson *shift = partial_position(f, at, coordinate);
        works[count++] = yk_ring_multiply(ring, yk_ring_conjugate(ring, shift), f->junctions[k].force);
    }
    const YkPoisson *work = yk_ring_real(ring, yk_ring_sum(ring, works, count));
    return yk_ring_add(ring, work, yk_ring_sum(ring, moments, turned));
}

const YkPoisson *yk_derive_generalised(const YkDeriveForces *f, const YkDeriveLoad *load, size_t coordinate)
{
    YkRing *ring = f->d->ring;
    const YkPoisson *sum = yk_ring_rational(ring, 0, 1);
    for (size_t p = 0; p < load->push_count; p++) {
        const YkDerivePush *push = &load->push[p];
        if (push->body == 0) continue;
        const YkPoisson *shift = partial_position(f, f->bodies[push->body].position, coordinate);
        sum = yk_ring_add(ring, sum, yk_ring_dot(ring, shift, push->force));
        if (is_turned_by(f, push->body, coordinate)) sum = yk_ring_add(ring, sum, yk_derive_moment_of(f, push));
    }
    return sum;
}

// --- Conditions of relations and of joints that close loops on the accelerations. A guide's distance is left out:
// only the direction across it counts.

static const YkPoisson *across(YkDerivation *d, const YkDeriveLoop *loop)
{
    YkDerivePlace first = yk_derive_place(d, loop->joint, 0), second = yk_derive_place(d, loop->joint, 1);
    const YkPoisson *from = yk_derive_position(d, first.body, yk_derive_at(d, first.point));
    const YkPoisson *to = yk_derive_position(d, second.body, yk_derive_at(d, second.point));
    const YkPoisson *line = yk_ring_multiply(d->ring, d->bodies[first.body].unit, yk_derive_along(d, loop->joint));
    return yk_ring_cross(d->ring, line, yk_ring_subtract(d->ring, to, from));
}

static const YkPoisson *twice(YkRing *ring, const YkPoisson *zero)
{
    return yk_ring_time_derivative(ring, yk_ring_time_derivative(ring, zero));
}

static void add_closing_row(const YkDeriveForces *f, const char *name, const YkPoisson *second)
{
    f->closing_name[*f->closing_count] = name;
    f->closing[(*f->closing_count)++] = yk_derive_shown(f->d, second);
}

int yk_derive_closing_rows(const YkDeriveForces *f)
{
    YkDerivation *d = f->d;
    if (*f->closing_count >= 0) return *f->closing_count;
    const YkPoisson *const *zeros = yk_derive_multipliers(f)->rows;
    *f->closing_count = 0;
    for (size_t k = 0; k < d->loop_count; k++) {
        const YkDeriveLoop *loop = &d->loops[k];
        bool slides = d->joint_distance[loop->joint] != YK_NONE;
        const char *name = d->model->joints[loop->joint].name;
        add_closing_row(f, name, twice(d->ring, slides ? across(d, loop) : zeros[0]));
        if (!slides) add_closing_row(f, name, twice(d->ring, zeros[1]));
        if (loop->angle) add_closing_row(f, name, twice(d->ring, zeros[2]));
        zeros += loop->angle ? 3 : 2;
    }
    for (size_t k = 0; k < d->tie_count; k++)
        add_closing_row(f, d->ties[k].name, yk_derive_tie_acceleration(d, &d->ties[k]));
    return yk_derivation_is_well(d) ? *f->closing_count : -1;
}
