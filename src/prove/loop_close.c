// Closes the loops at a point of the field: angles first, then what enters linearly, and finds which symbols these are.
#include <stdlib.h>
#include "prove/loop_point.h"

// Returns whether a parameter is given by others, or in a definition.
static bool is_defined(YkDerivation *d, size_t parameter)
{
    for (size_t k = 0; k < d->model->parameter_count; k++) { // defined, or in a definition
        const YkPoisson *definition = yk_derive_definition(d, k);
        if (!definition) continue;
        if (k == parameter || yk_ring_mentions(d->ring, definition, d->parameters[parameter])) return true;
    }
    return false;
}

// --- Slides and welds that close loops: e^(i angle row) = 1, solved for a coordinate that is not in an earlier row.
static const YkPoisson *unit_of_row(YkDerivation *d, const YkDeriveLoop *loop)
{
    const YkJoint *j = &d->model->joints[loop->joint];
    const YkPoisson *first = yk_ring_multiply(d->ring, d->bodies[j->body[0]].unit, yk_derive_turn(d, j->turned_expr));
    const YkPoisson *second = d->bodies[j->body[1]].unit;
    return yk_derive_in_joints(d, yk_ring_multiply(d->ring, yk_ring_conjugate(d->ring, first), second));
}

static void close_angle(YkLoopMaking *making, const YkDeriveRow *row, bool *used)
{
    YkDerivation *d = making->d;
    int64_t over = 0, under = 1;
    for (size_t k = 0; k < row->count; k++) {
        int32_t c = row->columns[k];
        if (used[c] || !yk_ring_is_rational(row->entries[k], &over, &under) || over * over != 1 || under != 1) continue;
        int32_t angle = d->coordinates[c].position;
        uint64_t unit = yk_loop_field(making, unit_of_row(d, &d->loops[row->loop]));
        uint64_t rest = yk_loop_field(making, row->value), now = yk_field_point_get(making->point, angle);
        const YkPoisson *own = yk_ring_unit(d->ring, angle);
        uint64_t factor = over > 0 ? yk_field_invert(unit) : unit;
        yk_field_point_set_unit(making->point, angle, yk_field_multiply(yk_loop_field(making, own), factor));
        yk_field_point_set(making->point, angle, over > 0 ? yk_field_subtract(now, rest) : yk_field_add(now, rest));
        for (size_t i = 0; i < row->count; i++) used[row->columns[i]] = true;
        return;
    }
    making->is_possible = false;
}

// --- Bonds: the pivot's angle from the others
static void bind(YkLoopMaking *making, const YkLoopBond *bond)
{
    YkDerivation *d = making->d;
    YkRing *ring = d->ring;
    const YkPoisson *unit = yk_ring_turn(ring, bond->turns, 12);
    const YkPoisson *angle = yk_ring_scale(ring, yk_ring_pi(ring), bond->turns, 12);
    for (size_t k = 0; k < d->tree_count; k++) {
        int32_t factor = bond->factor[k], position = d->coordinates[k].position;
        if (factor == 0 || (int32_t)k == bond->pivot) continue;
        unit = yk_ring_multiply(ring, unit, yk_ring_power(ring, yk_ring_unit(ring, position), -factor));
        angle = yk_ring_subtract(ring, angle, yk_ring_scale(ring, yk_ring_of(ring, position), factor, 1));
    }
    yk_field_point_set_unit(making->point, d->coordinates[bond->pivot].position, yk_loop_field(making, unit));
    yk_field_point_set(making->point, d->coordinates[bond->pivot].position, yk_loop_field(making, angle));
}

// Bonds satisfy the rows of angles, or they are not those of this machine.
static bool is_angle_closed(YkLoopMaking *making, const YkDeriveRow *row)
{
    YkDerivation *d = making->d;
    return yk_loop_field(making, unit_of_row(d, &d->loops[row->loop])) == 1 && yk_loop_field(making, row->value) == 0;
}

void yk_loop_close_angles(YkLoopMaking *making)
{
    const YkDeriveBlocks *blocks = making->blocks;
    bool *used = yk_derive_scratch(making->d, making->d->coordinate_count + 1, sizeof *used);
    if (!used) making->failed = true;
    for (size_t k = 0; making->bonds && k < making->bonds->count; k++) bind(making, &making->bonds->bond[k]);
    for (size_t r = 0; used && r < blocks->row_count; r++) {
        if (blocks->rows[r].part != 2) continue;
        if (!making->bonds)
            close_angle(making, &blocks->rows[r], used);
        else if (!is_angle_closed(making, &blocks->rows[r]))
            making->is_possible = false;
    }
    free(used);
}

// --- What enters the loops linearly

// Returns whether it contains the symbol outside cos and sin. The unit vector of an angle is a value of its own.
static bool stands_outside(YkRing *ring, const YkPoisson *a, int32_t symbol)
{
    int32_t lowest, highest;
    if (!yk_ring_mentions(ring, a, symbol)) return false;
    return !yk_ring_powers(ring, a, symbol, &lowest, &highest) || lowest != 0 || highest != 0;
}

// Returns whether every row is affine in the symbol, with a slope free of the symbols taken so far.
static bool is_linear(YkRing *ring, const YkDeriveBlocks *blocks, int32_t symbol, const int32_t *taken, size_t count)
{
    bool is_there = false; // an angle counts if it is outside cos and sin
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

size_t yk_loop_linear(YkDerivation *d, const YkDeriveBlocks *blocks, int32_t *unknowns)
{
    size_t count = 0;
    for (size_t k = 0; k < d->coordinate_count; k++)
        if (is_linear(d->ring, blocks, d->coordinates[k].position, unknowns, count))
            unknowns[count++] = d->coordinates[k].position;
    for (size_t k = 0; k < d->model->parameter_count; k++)
        if (!yk_ring_is_angle(d->ring, d->parameters[k]) && !is_defined(d, k) &&
            is_linear(d->ring, blocks, d->parameters[k], unknowns, count))
            unknowns[count++] = d->parameters[k];
    return count;
}
