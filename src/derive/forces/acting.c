// Lists what acts on each body, its contacts and the pushes of loads, without a search through those of others.
#include "derive/forces/free_bodies.h"

// Sorts entries by body, in their order: body b has those from first[b] to first[b + 1].
static YkDeriveActing list_of(YkArena *arena, size_t bodies, size_t count)
{
    return (YkDeriveActing){YK_NEW(arena, int32_t, bodies + 2), YK_NEW(arena, int32_t, count + 1)};
}

// Counting sort in two passes: `number` entries are counted and, after the sums, put in place.
static void count_one(YkDeriveActing *acting, int32_t body)
{
    acting->first[body + 2]++;
}

static void sum_up(YkDeriveActing *acting, size_t bodies)
{
    for (size_t b = 1; b <= bodies; b++) acting->first[b + 1] += acting->first[b];
}

static void put_one(YkDeriveActing *acting, int32_t body, int32_t entry)
{
    acting->entry[acting->first[body + 1]++] = entry;
}

bool yk_derive_sort_contacts(YkDeriveForces *f)
{
    size_t bodies = f->d->model->body_count;
    f->contacts_on = list_of(f->d->arena, bodies, f->contact_count);
    if (yk_arena_failed(f->d->arena)) return false;
    for (size_t k = 0; k < f->contact_count; k++) count_one(&f->contacts_on, f->contacts[k].push.body);
    sum_up(&f->contacts_on, bodies);
    for (size_t k = 0; k < f->contact_count; k++) put_one(&f->contacts_on, f->contacts[k].push.body, (int32_t)k);
    return true;
}

bool yk_derive_sort_pushes(YkDeriveForces *f)
{
    size_t bodies = f->d->model->body_count;
    f->pushes_on = list_of(f->d->arena, bodies, 2 * f->load_count);
    if (yk_arena_failed(f->d->arena)) return false;
    for (size_t k = 0; k < f->load_count; k++)
        for (size_t p = 0; p < f->loads[k].push_count; p++) count_one(&f->pushes_on, f->loads[k].push[p].body);
    sum_up(&f->pushes_on, bodies);
    for (size_t k = 0; k < f->load_count; k++)
        for (size_t p = 0; p < f->loads[k].push_count; p++)
            put_one(&f->pushes_on, f->loads[k].push[p].body, (int32_t)(2 * k + p));
    return true;
}

static const int32_t *entries_of(const YkDeriveActing *acting, int32_t body, size_t *count)
{
    *count = (size_t)(acting->first[body + 1] - acting->first[body]);
    return acting->entry + acting->first[body];
}

const int32_t *yk_derive_contacts_on(const YkDeriveForces *f, int32_t body, size_t *count)
{
    return entries_of(&f->contacts_on, body, count);
}

const int32_t *yk_derive_pushes_on(const YkDeriveForces *f, int32_t body, size_t *count)
{
    return entries_of(&f->pushes_on, body, count);
}

const YkPoisson *yk_derive_moment_of(const YkDeriveForces *f, const YkDerivePush *push)
{
    YkRing *ring = f->d->ring;
    if (push->force && (yk_ring_is_zero(push->force) || yk_ring_is_zero(push->arm))) return push->moment;
    return yk_ring_add(ring, yk_ring_cross(ring, push->arm, push->force), push->moment);
}
