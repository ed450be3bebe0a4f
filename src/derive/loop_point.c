// Random points of the machine's motion over the prime field: random angles; the loop equations solved for what enters
// them linearly (distances, lengths, angles outside of cos and sin); rates from J q' = 0; accelerations, and what
// sections have added, from their linear equations. All dimensions are random, so what holds there holds for all
// dimensions.
#include <stdlib.h>
#include "derive/blocks.h"
#include "derive/check.h"
#include "derive/frame.h"
#include "derive/free_bodies.h"

typedef struct Making {
    YkDerivation *d;
    YkFieldPoint *point;
    const YkDeriveBlocks *blocks;
    bool is_possible, failed;
} Making;

static uint64_t field(const Making *making, const YkPoisson *a)
{
    return yk_ring_field(making->d->ring, a, making->point, false);
}

// --- Parameters that the file defines by others follow them.
static void follow_definitions(Making *making)
{
    YkDerivation *d = making->d;
    for (size_t pass = 0; pass < 8; pass++) // definitions of definitions
        for (size_t k = 0; k < d->model->parameter_count; k++) {
            const YkPoisson *definition = yk_derive_definition(d, k);
            if (!definition) continue;
            yk_field_point_set(making->point, d->parameters[k], field(making, definition));
            if (!yk_ring_is_angle(d->ring, d->parameters[k])) continue;
            const YkPoisson *unit = yk_derive_turn(d, d->model->parameters[k].expr);
            if (unit) yk_field_point_set_unit(making->point, d->parameters[k], field(making, unit));
        }
}

static bool is_defined(YkDerivation *d, size_t parameter)
{
    for (size_t k = 0; k < d->model->parameter_count; k++) { // defined, or in a definition
        const YkPoisson *definition = yk_derive_definition(d, k);
        if (!definition) continue;
        if (k == parameter || yk_ring_mentions(d->ring, definition, d->parameters[parameter])) return true;
    }
    return false;
}

// --- Slides and welds that close loops: e^(i angle row) = 1, solved for a coordinate that stands in no earlier such
// row.
static const YkPoisson *unit_of_row(YkDerivation *d, const YkDeriveLoop *loop)
{
    const YkJoint *j = &d->model->joints[loop->joint];
    const YkPoisson *first = yk_ring_multiply(d->ring, d->bodies[j->body[0]].unit, yk_derive_turn(d, j->turned_expr));
    const YkPoisson *second = d->bodies[j->body[1]].unit;
    return yk_derive_in_joints(d, yk_ring_multiply(d->ring, yk_ring_conjugate(d->ring, first), second));
}

static void close_angle(Making *making, const YkDeriveRow *row, bool *used)
{
    YkDerivation *d = making->d;
    int64_t over = 0, under = 1;
    for (size_t k = 0; k < row->count; k++) {
        int32_t c = row->columns[k];
        if (used[c] || !yk_ring_is_rational(row->entries[k], &over, &under) || over * over != 1 || under != 1) continue;
        int32_t angle = d->coordinates[c].position;
        uint64_t unit = field(making, unit_of_row(d, &d->loops[row->loop]));
        uint64_t rest = field(making, row->value), now = yk_field_point_get(making->point, angle);
        const YkPoisson *own = yk_ring_unit(d->ring, angle);
        uint64_t factor = over > 0 ? yk_field_invert(unit) : unit;
        yk_field_point_set_unit(making->point, angle, yk_field_multiply(field(making, own), factor));
        yk_field_point_set(making->point, angle, over > 0 ? yk_field_subtract(now, rest) : yk_field_add(now, rest));
        for (size_t i = 0; i < row->count; i++) used[row->columns[i]] = true;
        return;
    }
    making->is_possible = false;
}

static void close_angles(Making *making)
{
    bool *used = calloc(making->d->coordinate_count + 1, sizeof *used);
    if (!used) making->failed = true;
    for (size_t r = 0; used && r < making->blocks->row_count; r++)
        if (making->blocks->rows[r].part == 2) close_angle(making, &making->blocks->rows[r], used);
    free(used);
}

// --- Linear systems over the field: rows `zero` of the ring, affine in the unknown symbols.
static bool solve(Making *making, const YkPoisson *const *zeros, size_t rows, const int32_t *unknowns, size_t count,
                  int *rank)
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
        uint64_t sum = field(making, zeros[r]);
        for (size_t k = 0; k < count; k++) {
            const YkPoisson *slope = yk_ring_coefficient(ring, zeros[r], unknowns[k], 1);
            A[r * count + k] = field(making, slope);
            sum = yk_field_subtract(sum, yk_field_multiply(A[r * count + k], x[k]));
        }
        b[r] = yk_field_negate(sum);
    }
    *rank = yk_field_solve(A, b, rows, count, x);
    for (size_t k = 0; k < count && *rank >= 0; k++) yk_field_point_set(making->point, unknowns[k], x[k]);
    free(block);
    return *rank >= 0;
}

// Does the symbol stand in it outside of cos and sin? The unit of an angle is a value of its own.
static bool stands_outside(YkRing *ring, const YkPoisson *a, int32_t symbol)
{
    int32_t lowest, highest;
    if (!yk_ring_mentions(ring, a, symbol)) return false;
    return !yk_ring_powers(ring, a, symbol, &lowest, &highest) || lowest != 0 || highest != 0;
}

// Is every row affine in the symbol, with a slope free of the symbols taken so far?
static bool is_linear(YkRing *ring, const YkDeriveBlocks *blocks, int32_t symbol, const int32_t *taken, size_t count)
{
    bool is_there = false; // an angle counts where it stands outside of cos and sin
    for (size_t r = 0; r < blocks->row_count; r++) {
        int32_t lowest, highest;
        const YkPoisson *row = blocks->rows[r].value;
        if (!yk_ring_mentions(ring, row, symbol)) continue;
        if (!yk_ring_powers(ring, row, symbol, &lowest, &highest) || lowest < 0 || highest > 1) return false;
        if (highest == 0) continue;
        const YkPoisson *slope = yk_ring_coefficient(ring, row, symbol, 1);
        for (size_t k = 0; k < count; k++)
            if (stands_outside(ring, slope, taken[k])) return false;
        is_there = true;
    }
    return is_there;
}

static size_t find_linear(Making *making, int32_t *unknowns)
{
    YkDerivation *d = making->d;
    size_t count = 0;
    for (size_t k = 0; k < d->coordinate_count; k++)
        if (is_linear(d->ring, making->blocks, d->coordinates[k].position, unknowns, count))
            unknowns[count++] = d->coordinates[k].position;
    for (size_t k = 0; k < d->model->parameter_count; k++)
        if (!yk_ring_is_angle(d->ring, d->parameters[k]) && !is_defined(d, k) &&
            is_linear(d->ring, making->blocks, d->parameters[k], unknowns, count))
            unknowns[count++] = d->parameters[k];
    return count;
}

static void close_loops(Making *making)
{
    YkDerivation *d = making->d;
    const YkDeriveBlocks *blocks = making->blocks;
    int rank = 0;
    int32_t *unknowns = calloc(d->coordinate_count + d->model->parameter_count + 1, sizeof *unknowns);
    const YkPoisson **zeros = (const YkPoisson **)calloc(blocks->row_count + 1, sizeof *zeros);
    if (unknowns && zeros) {
        for (size_t r = 0; r < blocks->row_count; r++) zeros[r] = blocks->rows[r].value;
        size_t count = find_linear(making, unknowns);
        making->is_possible = making->is_possible && solve(making, zeros, blocks->row_count, unknowns, count, &rank);
    } else {
        making->failed = true;
    }
    free(unknowns);
    free((void *)zeros);
}

// Lengths of springs and other roots of squares, where there are any; lines of action by them; quotients.
static void take_roots(Making *making)
{
    const YkDeriveForces *forces = yk_derive_forces(making->d);
    for (size_t k = 0; forces && k < forces->length_count && making->is_possible; k++) {
        uint64_t root;
        if (yk_field_sqrt(field(making, forces->lengths[k].square), &root) && root != 0)
            yk_field_point_set(making->point, forces->lengths[k].symbol, root);
        else
            making->is_possible = false;
    }
    for (size_t k = 0; forces && k < making->d->tie_count && making->is_possible; k++) {
        const YkDeriveMesh *mesh = &forces->meshes[k];
        if (!mesh->direction) continue;
        const YkPoisson *unit = yk_ring_divide(making->d->ring, mesh->direction, mesh->length);
        yk_field_point_set_unit(making->point, mesh->lean, field(making, unit));
    }
    for (size_t k = 0; forces && k < forces->ratio_count && making->is_possible; k++) {
        const YkDeriveRatio *ratio = &forces->ratios[k];
        uint64_t under = field(making, ratio->under);
        if (under == 0)
            making->is_possible = false;
        else
            yk_field_point_set(making->point, ratio->symbol,
                               yk_field_multiply(field(making, ratio->over), yk_field_invert(under)));
    }
}

// Rows of their own: what a lock holds neither moves nor starts to.
static size_t hold(const Making *making, bool accelerations, const YkPoisson **zeros)
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
static void move(Making *making, bool accelerations)
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
    if (!making->failed && !solve(making, zeros, blocks->row_count + more + held, unknowns, n, &rank))
        making->is_possible = false;
    if (!accelerations && (size_t)rank + d->mech->input_count > d->coordinate_count + held) making->is_possible = false;
    free(unknowns);
    free((void *)zeros);
}

// Symbols of the bodies' own angles, from the coordinates.
static void set_bodies(Making *making)
{
    YkDerivation *d = making->d;
    yk_derive_body_angle(d, 0); // makes the changes
    for (size_t k = 0; d->changes && k < d->change_count; k++) {
        yk_field_point_set(making->point, d->changes[k].symbol, field(making, d->changes[k].value));
        if (d->changes[k].unit)
            yk_field_point_set_unit(making->point, d->changes[k].symbol, field(making, d->changes[k].unit));
    }
}

YkFieldPoint *yk_derive_loop_point(YkDerivation *d, uint64_t seed, bool *is_possible)
{
    Making making = {.d = d, .blocks = yk_derive_blocks(d), .is_possible = true};
    *is_possible = false;
    for (size_t k = 0; k < d->model->parameter_count; k++) yk_derive_definition(d, k); // enters the symbols they need
    yk_derive_enter_forces(d);
    making.point = making.blocks ? yk_field_point_new(d->ring, seed) : NULL;
    if (!making.point) return NULL;
    follow_definitions(&making);
    close_angles(&making);
    close_loops(&making);
    set_bodies(&making);
    take_roots(&making);
    move(&making, false);
    set_bodies(&making);
    move(&making, true);
    set_bodies(&making);
    *is_possible = making.is_possible && !making.failed;
    if (*is_possible) return making.point;
    yk_field_point_free(making.point);
    return NULL;
}
