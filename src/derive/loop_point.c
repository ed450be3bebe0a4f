// Random points of the machine's motion over the prime field: random angles; the loop equations solved for what enters
// them linearly (distances, lengths, angles outside of cos and sin); rates from J q' = 0; accelerations, and what
// sections have added, from their linear equations. All dimensions are random, so what holds there holds for all
// dimensions.
#include <stdlib.h>
#include "derive/frame.h"
#include "derive/free_bodies.h"
#include "derive/loop_point.h"

// --- Parameters that the file defines by others follow them.
static void follow_definitions(YkLoopMaking *making)
{
    YkDerivation *d = making->d;
    for (size_t k = 0; k < d->constant_count; k++) // numbers under names are numbers
        if (d->constants[k].exact)
            yk_field_point_set(making->point, d->constants[k].symbol, yk_loop_field(making, d->constants[k].exact));
    for (size_t pass = 0; pass < 8; pass++) // definitions of definitions
        for (size_t k = 0; k < d->model->parameter_count; k++) {
            const YkPoisson *definition = yk_derive_definition(d, k);
            if (!definition) continue;
            yk_field_point_set(making->point, d->parameters[k], yk_loop_field(making, definition));
            if (!yk_ring_is_angle(d->ring, d->parameters[k])) continue;
            const YkPoisson *unit = yk_derive_turn(d, d->model->parameters[k].expr);
            if (unit) yk_field_point_set_unit(making->point, d->parameters[k], yk_loop_field(making, unit));
        }
}

// --- Linear systems over the field: rows `zero` of the ring, affine in the unknown symbols.
bool yk_loop_solve(YkLoopMaking *making, const YkPoisson *const *zeros, size_t rows, const int32_t *unknowns,
                   size_t count, int *rank)
{
    YkRing *ring = making->d->ring;
    uint64_t *block = calloc(rows * count + rows + count + 1, sizeof *block);
    if (!block) {
        making->failed = true;
        return false;
    }
    uint64_t *A = block, *b = block + rows * count, *x = b + rows;
    for (size_t k = 0; k < count; k++) x[k] = yk_field_point_get(making->point, unknowns[k]);
    for (size_t r = 0; r < rows; r++) {
        uint64_t sum = yk_loop_field(making, zeros[r]);
        for (size_t k = 0; k < count; k++) {
            const YkPoisson *slope = yk_ring_coefficient(ring, zeros[r], unknowns[k], 1);
            A[r * count + k] = yk_loop_field(making, slope);
            sum = yk_field_subtract(sum, yk_field_multiply(A[r * count + k], x[k]));
        }
        b[r] = yk_field_negate(sum);
    }
    *rank = yk_field_solve(A, b, rows, count, x);
    for (size_t k = 0; k < count && *rank >= 0; k++) yk_field_point_set(making->point, unknowns[k], x[k]);
    free(block);
    return *rank >= 0;
}

// The sign that the point had for the root, before the loops changed its square, was drawn by chance.
static uint64_t with_any_sign(const YkLoopMaking *making, size_t length, uint64_t root)
{
    const YkDeriveForces *forces = yk_derive_forces(making->d);
    uint64_t drawn = yk_field_point_get(making->point, forces->lengths[length].symbol);
    return drawn & 1 ? yk_field_negate(root) : root;
}

// Lengths of springs and other roots of squares, where there are any; lines of action by them; quotients.
static void take_roots(YkLoopMaking *making)
{
    const YkDeriveForces *forces = yk_derive_forces(making->d);
    for (size_t k = 0; forces && k < forces->length_count && making->is_possible; k++) {
        uint64_t root;
        if (yk_ring_next_symbol(making->d->ring, forces->lengths[k].square, -1) < 0) continue; // as it was made
        if (yk_field_sqrt(yk_loop_field(making, forces->lengths[k].square), &root) && root != 0)
            yk_field_point_set(making->point, forces->lengths[k].symbol, with_any_sign(making, k, root));
        else
            making->is_possible = false;
    }
    for (size_t k = 0; forces && k < making->d->tie_count && making->is_possible; k++) {
        const YkDeriveMesh *mesh = &forces->meshes[k];
        if (!mesh->direction) continue;
        const YkPoisson *unit = yk_ring_divide(making->d->ring, mesh->direction, mesh->length);
        yk_field_point_set_unit(making->point, mesh->lean, yk_loop_field(making, unit));
    }
    for (size_t k = 0; forces && k < forces->ratio_count && making->is_possible; k++) {
        const YkDeriveRatio *ratio = &forces->ratios[k];
        uint64_t under = yk_loop_field(making, ratio->under);
        if (under == 0)
            making->is_possible = false;
        else
            yk_field_point_set(making->point, ratio->symbol,
                               yk_field_multiply(yk_loop_field(making, ratio->over), yk_field_invert(under)));
    }
}

// Rows of their own: what a lock holds neither moves nor starts to.
static size_t hold(const YkLoopMaking *making, bool accelerations, const YkPoisson **zeros)
{
    const YkDerivation *d = making->d;
    size_t count = 0;
    for (size_t k = 0; k < d->coordinate_count; k++)
        if (d->coordinates[k].is_held)
            zeros[count++] =
                yk_ring_of(d->ring, accelerations ? d->coordinates[k].acceleration : d->coordinates[k].rate);
    return count;
}

// Rates: J q' = 0. A machine that moves only with special dimensions has too little freedom here.
static void move(YkLoopMaking *making, bool accelerations)
{
    YkDerivation *d = making->d;
    const YkDeriveBlocks *blocks = making->blocks;
    int rank = 0;
    size_t more = accelerations ? d->relation_count : 0,
           n = d->coordinate_count + (accelerations ? d->unknown_count : 0);
    int32_t *unknowns = calloc(n + 1, sizeof *unknowns);
    const YkPoisson **zeros =
        (const YkPoisson **)calloc(blocks->row_count + more + d->coordinate_count + 1, sizeof *zeros);
    making->failed |= !unknowns || !zeros;
    for (size_t r = 0; r < blocks->row_count && !making->failed; r++) {
        zeros[r] = yk_ring_time_derivative(d->ring, blocks->rows[r].value);
        if (accelerations) zeros[r] = yk_ring_time_derivative(d->ring, zeros[r]);
    }
    for (size_t r = 0; r < more && !making->failed; r++) zeros[blocks->row_count + r] = d->relations[r];
    for (size_t k = 0; k < d->coordinate_count && !making->failed;
         k++) // unknown ones first: given ones stay as they are
        unknowns[k] = accelerations ? d->coordinates[blocks->column_order[d->coordinate_count - 1 - k]].acceleration
                                    : d->coordinates[blocks->column_order[d->coordinate_count - 1 - k]].rate;
    for (size_t k = d->coordinate_count; k < n && !making->failed; k++)
        unknowns[k] = d->unknowns[k - d->coordinate_count];
    size_t held = making->failed ? 0 : hold(making, accelerations, zeros + blocks->row_count + more);
    if (!making->failed && !yk_loop_solve(making, zeros, blocks->row_count + more + held, unknowns, n, &rank))
        making->is_possible = false;
    if (!accelerations && (size_t)rank + d->mech->input_count > d->coordinate_count + held) making->is_possible = false;
    free(unknowns);
    free((void *)zeros);
}

// Symbols of the bodies' own angles, from the coordinates.
static void set_bodies(YkLoopMaking *making)
{
    YkDerivation *d = making->d;
    yk_derive_body_angle(d, 0); // makes the changes
    for (size_t k = 0; d->changes && k < d->change_count; k++) {
        yk_field_point_set(making->point, d->changes[k].symbol, yk_loop_field(making, d->changes[k].value));
        if (d->changes[k].unit)
            yk_field_point_set_unit(making->point, d->changes[k].symbol, yk_loop_field(making, d->changes[k].unit));
    }
}

YkFieldPoint *yk_derive_assembly_point(YkDerivation *d, const YkLoopBonds *bonds, uint64_t seed, int *rank,
                                       bool *is_possible)
{
    YkLoopMaking making = {.d = d, .blocks = yk_derive_blocks(d), .bonds = bonds, .is_possible = true};
    *is_possible = false;
    for (size_t k = 0; k < d->model->parameter_count; k++) yk_derive_definition(d, k); // enters the symbols they need
    yk_derive_enter_forces(d);
    making.point = making.blocks ? yk_field_point_new(d->ring, seed) : NULL;
    if (!making.point) return NULL;
    follow_definitions(&making);
    yk_loop_close_angles(&making);
    yk_loop_close(&making);
    set_bodies(&making);
    take_roots(&making);
    move(&making, false);
    set_bodies(&making);
    move(&making, true);
    set_bodies(&making);
    *rank = making.rank;
    *is_possible = making.is_possible && !making.failed;
    if (*is_possible) return making.point;
    yk_field_point_free(making.point);
    return NULL;
}

YkFieldPoint *yk_derive_loop_point(YkDerivation *d, uint64_t seed, bool *is_possible)
{
    int rank;
    return yk_derive_assembly_point(d, NULL, seed, &rank, is_possible);
}
