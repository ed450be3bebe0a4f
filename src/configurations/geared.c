// Reads a group with one gear relation, and finds the turns of its angles.
#include "configurations/geared.h"
#include <math.h>
#include <stdlib.h>
#include "solve/relations.h"

enum { RATIO_MAX = 720, TURNS_MAX = 6 };

static bool make_whole(YkGeared *g, const double *factor, double *times)
{
    size_t n = g->shape.unknowns;
    double least = INFINITY;
    for (size_t k = 0; k < n; k++)
        if (factor[k] != 0) least = fmin(least, fabs(factor[k]));
    // The least multiple of all factors that is whole has no common divisor.
    for (int q = 1; q <= RATIO_MAX; q++) {
        bool is_whole = true;
        *times = q / least;
        for (size_t k = 0; k < n; k++) {
            double p = *times * factor[k];
            is_whole &= fabs(p - rint(p)) < 1e-9 && fabs(p) <= RATIO_MAX;
            g->ratio[k] = is_whole ? (int)rint(p) : 0;
        }
        if (is_whole) return true;
    }
    return false;
}

static bool read_relation(YkGeared *g, const YkRun *run, size_t index)
{
    const YkRelation *r = &run->mech->relations[index];
    double factor[YK_GEARED_MAX] = {0}, zero[YK_GEARED_MAX] = {0}, times;
    if (r->law) return false;
    for (uint32_t k = r->first_source; k < r->first_source + r->source_count; k++)
        if (run->mech->sources[k].kind == YK_SOURCE_DISTANCE) return false;
    yk_relation_gradient(run->mech, index, 0, factor);
    if (!make_whole(g, factor, &times)) return false;
    // Known angles that loops place have turns of their own, which must be whole here too.
    for (uint32_t k = r->first_source; k < r->first_source + r->source_count; k++) {
        const YkRelationSource *s = &run->mech->sources[k];
        double p = times * s->factor;
        if (s->kind == YK_SOURCE_SLOT && !(fabs(p - rint(p)) < 1e-9)) return false;
    }
    g->phase = times * yk_relation_pose(run, index, zero, NULL).value.position;
    return isfinite(g->phase);
}

bool yk_geared_read(YkGeared *g, const YkRun *run, size_t index)
{
    const YkMechanism *mech = run->mech;
    const YkBlock *block = &mech->blocks[index];
    size_t n = block->column_count;
    if (block->relation_count != 1 || n != yk_block_rows(block) || n > YK_GEARED_MAX) return false;
    *g = (YkGeared){.shape = {.loops = block->loop_count, .angles = n, .unknowns = n}};
    for (size_t k = 0; k < n; k++) {
        if (mech->group_columns[block->first_column + k].is_distance) return false;
        g->shape.column[k] = k;
        g->shape.turning[k] = -1;
    }
    if (!read_relation(g, run, (size_t)mech->group_relations[block->first_relation])) return false;
    yk_coefficients_read(&g->shape, run, index, g->coefficients);
    return true;
}

// Looks for turns of the angles from `k` on whose sum, times the ratios, is `wanted`; `most` turns in all.
static bool find_turns(const YkGeared *g, size_t k, long wanted, int most, int *turns)
{
    if (k == g->shape.unknowns) return wanted == 0;
    for (int t = 0; t <= 2 * most; t++) {
        turns[k] = t % 2 == 1 ? (t + 1) / 2 : -t / 2;
        if (find_turns(g, k + 1, wanted - (long)g->ratio[k] * turns[k], most - abs(turns[k]), turns)) return true;
    }
    return false;
}

bool yk_geared_turn(const YkGeared *g, double *x)
{
    int turns[YK_GEARED_MAX];
    double sum = g->phase;
    for (size_t k = 0; k < g->shape.unknowns; k++) sum += g->ratio[k] * x[k];
    for (int most = 0; most <= TURNS_MAX; most++) {
        if (!find_turns(g, 0, -lrint(sum / (2 * YK_PI)), most, turns)) continue;
        for (size_t k = 0; k < g->shape.unknowns; k++) x[k] += 2 * YK_PI * turns[k];
        return true;
    }
    return false;
}
