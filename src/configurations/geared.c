// Reads a group with gears, belts or racks, and finds the turns of its angles.
#include "configurations/geared.h"
#include <math.h>
#include <stdlib.h>
#include "num/complex.h"
#include "solve/relations.h"

enum { RATIO_MAX = 720, TURNS_MAX = 6, N = YK_GEARED_MAX, R = YK_GEARED_RELATIONS };

// --- relations

static bool is_whole(double x)
{
    return fabs(x - rint(x)) < 1e-9;
}

// Finds what makes the factors of all angles whole, without a common divisor. Returns false if nothing does.
static bool find_times(const YkShape *shape, const double *factor, double *times)
{
    double least = INFINITY;
    for (size_t k = 0; k < shape->angles; k++)
        if (factor[k] != 0) least = fmin(least, fabs(factor[k]));
    if (least == INFINITY) return false;
    for (int q = 1; q <= RATIO_MAX; q++) {
        bool all = true;
        *times = q / least;
        for (size_t k = 0; k < shape->angles; k++) {
            double p = *times * factor[k];
            all &= is_whole(p) && fabs(p) <= RATIO_MAX;
        }
        if (all) return true;
    }
    return false;
}

static bool read_relation(YkGeared *g, const YkRun *run, size_t number, size_t index, double *times)
{
    double factor[N] = {0}, own[N], zero[N] = {0};
    if (run->mech->relations[index].law) return false;
    yk_relation_gradient(run->mech, index, 0, factor);
    for (size_t k = 0; k < g->shape.unknowns; k++) own[k] = factor[g->shape.column[k]];
    if (!find_times(&g->shape, own, times)) return false;
    for (size_t k = 0; k < g->shape.unknowns; k++)
        g->factor[number][k] = k < g->shape.angles ? rint(*times * own[k]) : *times * own[k] * g->size;
    g->phase[number] = *times * yk_relation_pose(run, index, zero, NULL).value.position;
    return isfinite(g->phase[number]);
}

static void subtract_column(double A[R][N], size_t relations, size_t from, size_t column, double times)
{
    for (size_t r = 0; r < relations; r++) A[r][from] -= times * A[r][column];
}

static void swap_columns(double A[R][N], size_t relations, size_t i, size_t j)
{
    for (size_t r = 0; r < relations; r++) {
        double kept = A[r][i];
        A[r][i] = A[r][j];
        A[r][j] = kept;
    }
}

// Finds a basis of all combinations that whole turns of the angles give: the first columns of Hermite's form, by Euclid's
// algorithm on the columns. Returns false if the relations depend on each other.
static bool find_lattice(const YkGeared *g, double A[R][N])
{
    size_t n = g->shape.angles;
    for (size_t r = 0; r < g->relations; r++)
        for (size_t k = 0; k < n; k++) A[r][k] = g->factor[r][k];
    for (size_t r = 0; r < g->relations; r++) {
        for (bool goes_on = true; goes_on;) {
            size_t least = n;
            for (size_t k = r; k < n; k++)
                if (A[r][k] != 0 && (least == n || fabs(A[r][k]) < fabs(A[r][least]))) least = k;
            if (least == n) return false;
            swap_columns(A, g->relations, r, least);
            goes_on = false;
            for (size_t k = r + 1; k < n; k++) {
                subtract_column(A, g->relations, k, r, rint(A[r][k] / A[r][r]));
                goes_on |= A[r][k] != 0;
            }
        }
    }
    return true;
}

// Solves for the combinations that whole turns give one by one; times[r] of the relations were taken. Returns false unless
// known angles that loops place, which have turns of their own, count with whole numbers too.
static bool combine(YkGeared *g, const YkRun *run, const YkBlock *block, const double *times)
{
    double A[R][N], inverse[R][R] = {{0}};
    if (!find_lattice(g, A)) return false;
    for (size_t r = 0; r < g->relations; r++) {
        inverse[r][r] = 1;
        for (size_t above = 0; above < r; above++) {
            for (size_t k = 0; k < g->shape.unknowns; k++) g->factor[r][k] -= A[r][above] * g->factor[above][k];
            for (size_t k = 0; k <= r; k++) inverse[r][k] -= A[r][above] * inverse[above][k];
            g->phase[r] -= A[r][above] * g->phase[above];
        }
        for (size_t k = 0; k < g->shape.unknowns; k++) g->factor[r][k] /= A[r][r];
        for (size_t k = 0; k <= r; k++) inverse[r][k] /= A[r][r];
        g->phase[r] /= A[r][r];
        for (size_t k = 0; k < g->shape.angles; k++) g->factor[r][k] = rint(g->factor[r][k]);
    }
    for (size_t r = 0; r < g->relations; r++) {
        const YkRelation *own = &run->mech->relations[run->mech->group_relations[block->first_relation + r]];
        for (uint32_t k = own->first_source; k < own->first_source + own->source_count; k++) {
            const YkRelationSource *s = &run->mech->sources[k];
            for (size_t row = r; row < g->relations && s->kind == YK_SOURCE_SLOT; row++)
                if (!is_whole(inverse[row][r] * times[r] * s->factor)) return false;
        }
    }
    return true;
}

// --- distances

// Bounds a distance by a loop: it is no longer than all else of the loop together.
static double reach_in(const YkGeared *g, size_t loop, size_t slide)
{
    const YkVec *row = g->coefficients + loop * (g->shape.unknowns + 1);
    double own = yk_norm(row[slide]), sum = yk_norm(row[g->shape.unknowns]);
    if (own == 0) return INFINITY;
    for (size_t k = 0; k < g->shape.unknowns; k++) {
        double length = yk_norm(row[k]);
        if (k != slide && length > 0) sum += length * (k < g->shape.angles ? 1 : g->reach[k]);
    }
    return sum / own * (1 + 1e-9);
}

static bool bound_distances(YkGeared *g)
{
    size_t n = g->shape.unknowns;
    for (size_t k = 0; k < n; k++) g->reach[k] = k < g->shape.angles ? YK_PI : INFINITY;
    for (size_t round = 0; round < n; round++)
        for (size_t k = g->shape.angles; k < n; k++)
            for (size_t l = 0; l < g->shape.loops; l++) g->reach[k] = fmin(g->reach[k], reach_in(g, l, k));
    for (size_t k = 0; k < n; k++)
        if (!(g->reach[k] < INFINITY)) return false;
    return true;
}

// --- the group

bool yk_geared_read(YkGeared *g, const YkRun *run, size_t index)
{
    const YkMechanism *mech = run->mech;
    const YkBlock *block = &mech->blocks[index];
    double times[R];
    *g = (YkGeared){.relations = block->relation_count, .size = mech->size};
    if (block->relation_count == 0 || block->relation_count > R || block->column_count > N) return false;
    if (block->column_count != yk_block_rows(block) || !yk_shape_read_columns(&g->shape, mech, index)) return false;
    for (size_t r = 0; r < g->relations; r++)
        if (!read_relation(g, run, r, (size_t)mech->group_relations[block->first_relation + r], &times[r]))
            return false;
    yk_coefficients_read(&g->shape, run, index, g->coefficients);
    return combine(g, run, block, times) && bound_distances(g);
}

// Looks for turns of the angles from `k` on that give every relation what it wants; `most` turns in all.
static bool find_turns(const YkGeared *g, size_t k, const double *wanted, int most, int *turns)
{
    if (k == g->shape.angles) {
        for (size_t r = 0; r < g->relations; r++)
            if (wanted[r] != 0) return false;
        return true;
    }
    for (int t = 0; t <= 2 * most; t++) {
        double rest[R];
        turns[k] = t % 2 == 1 ? (t + 1) / 2 : -t / 2;
        for (size_t r = 0; r < g->relations; r++) rest[r] = wanted[r] - g->factor[r][k] * turns[k];
        if (find_turns(g, k + 1, rest, most - abs(turns[k]), turns)) return true;
    }
    return false;
}

bool yk_geared_turn(const YkGeared *g, double *x)
{
    int turns[N];
    double wanted[R];
    for (size_t r = 0; r < g->relations; r++) {
        double sum = g->phase[r];
        for (size_t k = 0; k < g->shape.unknowns; k++) sum += g->factor[r][k] * x[k];
        wanted[r] = -rint(sum / (2 * YK_PI));
    }
    for (int most = 0; most <= TURNS_MAX; most++) {
        if (!find_turns(g, 0, wanted, most, turns)) continue;
        for (size_t k = 0; k < g->shape.angles; k++) x[k] += 2 * YK_PI * turns[k];
        return true;
    }
    return false;
}
