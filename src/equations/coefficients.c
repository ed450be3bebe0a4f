// Computes the coefficients of each step of solution at a pose.
#include "equations/coefficients.h"
#include <stdlib.h>
#include <string.h>
#include "base/memory.h"
#include "equations/gradient_pose.h"
#include "num/dense.h"

bool yk_coefficients_start(YkCoefficients *work, const YkElimination *e)
{
    size_t group = e->largest_group, wide = e->widest + 2;
    size_t total = 2 * wide + group * group + group * wide + 3 * group;
    *work = (YkCoefficients){.e = e};
    work->memory = calloc(total * sizeof(double) + group * (sizeof(int) + sizeof(size_t)), 1);
    if (!work->memory) return false;
    double *p = work->memory;
    work->column = (YkVec *)p, p += 2 * wide;
    work->D = p, p += group * group;
    work->K = p, p += group * wide;
    work->tau = p, p += 2 * group;
    work->x = p, p += group;
    work->order = (size_t *)p;
    work->pivot = (int *)(work->order + group);
    return true;
}

void yk_coefficients_end(YkCoefficients *work)
{
    free(work->memory);
}

// --- groups

// Adds the rows of a group's relations after those of its loops.
static void add_relation_rows(const YkCoefficients *work, const YkSpace *space, const YkOperation *op, size_t m)
{
    const YkElimination *e = work->e;
    const YkBlock *block = &e->mech->blocks[op->block];
    const double *factor = yk_from(e->factors, op->first_factor);
    size_t n = op->own, q = op->given;
    for (size_t k = 0; k < block->relation_count; k++, factor += 2 * (n + q)) {
        size_t row = 2 * block->loop_count + k;
        double slope = space->gain[(size_t)e->mech->group_relations[block->first_relation + k] * space->stride];
        for (size_t u = 0; u < n; u++) work->D[row * n + u] = factor[2 * u] + slope * factor[2 * u + 1];
        for (size_t w = 0; w < q; w++) work->K[w * m + row] = -(factor[2 * (n + w)] + slope * factor[2 * (n + w) + 1]);
    }
}

// Solves D x = -K for the unknowns of a group; if there are more equations than unknowns, by least squares.
static bool solve_group(const YkCoefficients *work, const YkSpace *space, const YkOperation *op, double *C)
{
    const YkElimination *e = work->e;
    const YkBlock *block = &e->mech->blocks[op->block];
    size_t n = op->own, q = op->given, m = yk_block_rows(block);
    memset(work->D, 0, m * n * sizeof *work->D);
    memset(work->K, 0, m * q * sizeof *work->K);
    for (size_t row = 0; row < block->loop_count; row++) {
        for (uint32_t k = 0; k < op->gradient.columns; k++) work->column[k] = yk_vec(0, 0);
        for (uint32_t k = 0; k < op->gradient.node_count; k++) {
            const YkNodePart *part = &e->nodes[op->gradient.first_node + k];
            if (part->row != (int32_t)row) continue;
            work->column[part->column].x += part->sign;
            work->column[part->column + 1].y += part->sign;
        }
        for (uint32_t k = 0; k < op->gradient.piece_count; k++) {
            const YkGradientPiece *piece = &e->pieces[op->gradient.first_piece + k];
            if (piece->row == (int32_t)row) yk_add_piece(space, piece, work->column);
        }
        for (size_t k = 0; k < n; k++) {
            work->D[2 * row * n + k] = work->column[k].x;
            work->D[(2 * row + 1) * n + k] = work->column[k].y;
        }
        for (size_t k = 0; k < q; k++) {
            work->K[k * m + 2 * row] = -work->column[n + k].x;
            work->K[k * m + 2 * row + 1] = -work->column[n + k].y;
        }
    }
    add_relation_rows(work, space, op, m);
    if (m == n) {
        if (yk_lu_factor(n, work->D, work->pivot, work->tau) == 0) return false;
        for (size_t k = 0; k < q; k++) {
            yk_lu_solve(n, work->D, work->pivot, work->K + k * m);
            for (size_t u = 0; u < n; u++) C[u * q + k] = work->K[k * m + u];
        }
        return true;
    }
    size_t rank = yk_qr_factor(m, n, work->D, work->order, work->tau, 1e-10);
    for (size_t k = 0; k < q; k++) {
        yk_qr_solve(m, n, work->D, work->order, work->tau, rank, work->K + k * m, work->x);
        for (size_t u = 0; u < n; u++) C[u * q + k] = work->x[u];
    }
    return rank == n;
}

// --- every kind

bool yk_coefficients_find(const YkCoefficients *work, const YkSpace *space, const YkOperation *op, double *C)
{
    uint32_t q = op->given;
    const YkVec *c = work->column;
    switch (op->kind) {
    case YK_OP_COPY:
        for (uint32_t k = 0; k < q; k++) C[k] = 1;
        return true;
    case YK_OP_RELATION: {
        const double *factor = yk_from(work->e->factors, op->first_factor);
        double slope = space->gain[op->block * space->stride];
        for (uint32_t k = 0; k < q; k++) C[k] = factor[2 + 2 * k] + slope * factor[3 + 2 * k];
        return true;
    }
    case YK_OP_NODE:
        yk_gradient_columns(work->e, space, &op->gradient, work->column);
        for (uint32_t k = 0; k < q; k++) {
            C[k] = c[2 + k].x;
            C[q + k] = c[2 + k].y;
        }
        return true;
    case YK_OP_PAIR: {
        yk_gradient_columns(work->e, space, &op->gradient, work->column);
        double over = -1 / yk_cross(c[0], c[1]);
        for (uint32_t k = 0; k < q; k++) {
            C[k] = over * yk_cross(c[2 + k], c[1]);
            C[q + k] = over * yk_cross(c[0], c[2 + k]);
        }
        return true;
    }
    case YK_OP_SINGLE: {
        yk_gradient_columns(work->e, space, &op->gradient, work->column);
        double over = -1 / yk_dot(c[0], c[0]);
        for (uint32_t k = 0; k < q; k++) C[k] = over * yk_dot(c[0], c[1 + k]);
        return true;
    }
    case YK_OP_GROUP:
        return solve_group(work, space, op, C);
    default:
        return true;
    }
}
