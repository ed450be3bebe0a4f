// Derives Lagrange's equations in the coordinates of the body form, and sums them for the machine's own.
#include "derive/forces/free_bodies.h"
#include "derive/relations.h"

// Returns dV/dq + d/dt dT/du - dT/dq of the whole machine.
static const YkPoisson *by_energies(const YkDeriveForces *f, const YkDeriveFreedom *freedom)
{
    YkRing *ring = f->d->ring;
    const YkPoisson *slope = yk_ring_partial(ring, yk_derive_potential(f), freedom->position);
    const YkPoisson *T = yk_derive_kinetic_total(f);
    yk_ring_begin_passing(ring);
    const YkPoisson *change = yk_ring_time_derivative(ring, yk_ring_partial(ring, T, freedom->rate));
    change = yk_ring_subtract(ring, change, yk_ring_partial(ring, T, freedom->position));
    return yk_ring_end_passing(ring, yk_ring_add(ring, slope, change));
}

static const YkPoisson *slope_of(const YkDeriveForces *f, size_t row, int32_t position)
{
    YkDerivation *d = f->d;
    const YkDeriveMultipliers *m = yk_derive_multipliers(f);
    if (m->joint[row] == YK_NONE) return yk_derive_tie_slope(d, &d->ties[row - (m->count - d->tie_count)], position);
    if (!yk_ring_mentions(d->ring, m->rows[row], position)) return yk_ring_rational(d->ring, 0, 1);
    return yk_ring_partial(d->ring, m->rows[row], position);
}

// Returns what relations and joints that close loops add: lambda dPhi/dq.
static const YkPoisson *multiplied_rows(const YkDeriveForces *f, int32_t position)
{
    YkRing *ring = f->d->ring;
    const YkDeriveMultipliers *m = yk_derive_multipliers(f);
    const YkPoisson *sum = yk_ring_rational(ring, 0, 1);
    for (size_t k = 0; k < m->count; k++) {
        const YkPoisson *slope = slope_of(f, k, position);
        if (slope && yk_ring_is_zero(slope)) continue;
        sum = yk_ring_add(ring, sum, yk_ring_multiply(ring, slope, yk_ring_of(ring, m->symbols[k])));
    }
    return sum;
}

static bool is_on_the_right(YkDeriveLoadKind kind)
{
    return kind == YK_DERIVE_FORCE || kind == YK_DERIVE_EFFORT || kind == YK_DERIVE_DRIVE || kind == YK_DERIVE_DRY;
}

YkDeriveLagrange yk_derive_lagrange(const YkDeriveForces *f, size_t coordinate)
{
    YkDerivation *d = f->d;
    YkRing *ring = d->ring;
    YkDeriveFreedom freedom = yk_derive_freedom(d, coordinate);
    if (f->lagrange[coordinate].left) return f->lagrange[coordinate];
    YkDeriveLagrange sides = {by_energies(f, &freedom), yk_ring_rational(ring, 0, 1)};
    for (size_t k = 0; k < f->load_count; k++) {
        const YkDeriveLoad *load = &f->loads[k];
        if (load->energy) continue;
        const YkPoisson *Q = yk_derive_generalised(f, load, coordinate);
        if (is_on_the_right(load->kind))
            sides.right = yk_ring_add(ring, sides.right, Q);
        else
            sides.left = yk_ring_subtract(ring, sides.left, Q);
    }
    sides.left = yk_ring_add(ring, sides.left, multiplied_rows(f, freedom.position));
    f->lagrange[coordinate] = sides;
    return sides;
}

static YkDeriveLagrange in_joints(const YkDeriveForces *f, size_t coordinate)
{
    YkDeriveLagrange *memo = &f->lagrange_in_joints[coordinate], own = yk_derive_lagrange(f, coordinate);
    if (!memo->left) {
        memo->left = yk_derive_in_joints(f->d, own.left);
        memo->right = yk_derive_in_joints(f->d, own.right);
    }
    return *memo;
}

YkDeriveLagrange yk_derive_lagrange_of(const YkDeriveForces *f, size_t coordinate)
{
    YkDerivation *d = f->d;
    YkRing *ring = d->ring;
    YkDeriveLagrange sum = {yk_ring_rational(ring, 0, 1), yk_ring_rational(ring, 0, 1)};
    int32_t *B = YK_NEW(d->arena, int32_t, d->tree_count + 1);
    if (!B) return (YkDeriveLagrange){0};
    for (size_t k = 0; k < d->coordinate_count; k++) {
        YkDeriveFreedom freedom = yk_derive_freedom(d, k);
        int32_t factor = k == coordinate;
        if (freedom.body != YK_NONE && !d->coordinates[coordinate].is_distance) {
            yk_derive_combination(d, freedom.body, B);
            factor = B[coordinate];
        }
        if (factor == 0) continue;
        YkDeriveLagrange part = in_joints(f, k);
        sum.left = yk_ring_add(ring, sum.left, yk_ring_scale(ring, part.left, factor, 1));
        sum.right = yk_ring_add(ring, sum.right, yk_ring_scale(ring, part.right, factor, 1));
    }
    return sum;
}
