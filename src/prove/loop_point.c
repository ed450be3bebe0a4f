// Makes random points of the machine's motion over the prime field: random angles; the loop equations solved for what
// enters them linearly (distances, lengths, angles outside cos and sin); rates from J q' = 0; accelerations, and what
// sections have added, from their linear equations. All dimensions are random, so what holds there holds for all
// dimensions.
#include <stdlib.h>
#include "derive/forces/free_bodies.h"
#include "derive/inside.h"
#include "prove/loop_point.h"

// --- Parameters that the file defines by others follow these
static void follow_definitions(YkLoopMaking *making)
{
    YkDerivation *d = making->d;
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

// --- Linear systems over the field

// Puts in a row's numbers at the point. Returns what the sum of slope * unknown must be.
static uint64_t put_row(const YkLoopMaking *making, const YkLoopSystem *system, size_t row, YkFieldEntry *entries)
{
    const YkLoopRow *own = &system->rows[row];
    uint64_t sum = yk_loop_field(making, own->rest);
    for (size_t k = own[0].first; k < own[1].first; k++) {
        const YkLoopEntry *entry = &system->entries[k];
        uint64_t slope = yk_loop_field(making, entry->slope),
                 now = own->is_split ? 0 : yk_field_point_get(making->point, system->unknowns[entry->unknown]);
        entries[k] = (YkFieldEntry){(size_t)entry->unknown, slope};
        sum = yk_field_subtract(sum, yk_field_multiply(slope, now));
    }
    return yk_field_negate(sum);
}

static int solve(YkLoopMaking *making, const YkLoopSystem *system, size_t *first, YkFieldEntry *entries, uint64_t *b,
                 uint64_t *x)
{
    size_t rows = system->row_count, count = system->unknown_count;
    for (size_t k = 0; k < count; k++) x[k] = yk_field_point_get(making->point, system->unknowns[k]);
    for (size_t r = 0; r < rows; r++) b[r] = put_row(making, system, r, entries);
    for (size_t r = 0; r <= rows; r++) first[r] = system->rows[r].first;
    int rank = yk_field_solve(entries, first, b, rows, count, x);
    for (size_t k = 0; k < count && rank >= 0; k++) yk_field_point_set(making->point, system->unknowns[k], x[k]);
    return rank;
}

// Solves the system over the field. Returns false if rows contradict each other.
static bool solve_system(YkLoopMaking *making, const YkLoopSystem *system, int *rank)
{
    size_t rows = system->row_count;
    size_t *first = yk_derive_scratch(making->d, rows + 1, sizeof *first);
    YkFieldEntry *entries = yk_derive_scratch(making->d, system->rows[rows].first + 1, sizeof *entries);
    uint64_t *b = yk_derive_scratch(making->d, rows + system->unknown_count + 1, sizeof *b);
    making->failed |= !first || !entries || !b;
    *rank = making->failed ? -1 : solve(making, system, first, entries, b, b + rows);
    making->failed |= *rank == YK_FIELD_NO_MEMORY;
    making->d->failed |= making->failed;
    free(first);
    free(entries);
    free(b);
    return *rank >= 0;
}

// The sign that the point had for the root, before the loops changed its square, was random.
static uint64_t with_any_sign(const YkLoopMaking *making, size_t length, uint64_t root)
{
    const YkDeriveForces *forces = yk_derive_forces(making->d);
    uint64_t drawn = yk_field_point_get(making->point, forces->lengths[length].symbol);
    return drawn & 1 ? yk_field_negate(root) : root;
}

// Takes lengths of springs and other roots of squares, if there are any, lines of action from them, and quotients.
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

// Solves for rates: J q' = 0. A machine that moves only with special dimensions has too little freedom here.
static void move(YkLoopMaking *making)
{
    const YkDerivation *d = making->d;
    const YkLoopSystem *rates = &making->plan->rates;
    int rank = 0;
    making->is_possible =
        solve_system(making, rates, &rank) && (size_t)rank + d->mech->input_count <= d->coordinate_count + rates->held;
}

static void accelerate(YkLoopMaking *making)
{
    int rank = 0;
    making->is_possible = solve_system(making, &making->plan->accelerations, &rank);
}

// Sets the symbols of the bodies' own angles from the coordinates.
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

// Makes positions, rates and accelerations; stops when one of them cannot be made.
static void make(YkLoopMaking *making)
{
    follow_definitions(making);
    yk_loop_close_angles(making);
    if (making->is_possible) making->is_possible = solve_system(making, &making->plan->closing, &making->rank);
    if (making->is_possible) set_bodies(making);
    if (making->is_possible) take_roots(making);
    if (making->is_possible) move(making);
    if (making->is_possible) set_bodies(making);
    if (making->is_possible) accelerate(making);
    if (making->is_possible) set_bodies(making);
}

YkFieldPoint *yk_derive_assembly_point(YkDerivation *d, const YkLoopBonds *bonds, uint64_t seed, int *rank,
                                       bool *is_possible)
{
    YkLoopMaking making = {.d = d, .blocks = yk_derive_blocks(d), .bonds = bonds, .rank = -1, .is_possible = true};
    *is_possible = false;
    for (size_t k = 0; k < d->model->parameter_count; k++) yk_derive_definition(d, k); // enters the symbols they need
    yk_derive_enter_forces(d);
    making.plan = making.blocks ? yk_loop_plan(d) : NULL;
    making.point = making.plan ? yk_field_point_new(d->ring, seed) : NULL;
    d->failed |= making.plan && !making.point;
    if (!making.point) return NULL;
    make(&making);
    *rank = making.rank;
    *is_possible = making.is_possible && !making.failed;
    if (*is_possible) return making.point;
    yk_field_point_free(making.point);
    return NULL;
}
