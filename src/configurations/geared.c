// Reads a group with gears, belts, racks, cams or laws, and finds the turns of its angles.
#include "configurations/geared.h"
#include <math.h>
#include <stdlib.h>
#include "solve/relations.h"

enum { RATIO_MAX = 720, TURNS_MAX = 6, N = YK_GEARED_MAX, R = YK_GEARED_RELATIONS };

// --- relations

static bool is_whole(double x)
{
    return fabs(x - rint(x)) < 1e-9;
}

// Finds what makes the angles' factors, not all 0, whole without a common divisor. Returns false if nothing does.
static bool find_times(const YkShape *shape, const double *factor, double *times)
{
    double least = INFINITY;
    for (size_t k = 0; k < shape->angles; k++)
        if (factor[k] != 0) least = fmin(least, fabs(factor[k]));
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

static bool has_angle(const YkShape *shape, const double *factor)
{
    for (size_t k = 0; k < shape->angles; k++)
        if (factor[k] != 0) return true;
    return false;
}

// Reads how a relation depends on the unknowns: but for its law (slope 0), or with what moves the law's argument.
static void read_factors(const YkGeared *g, const YkMechanism *mech, size_t index, double slope, double *factor)
{
    double columns[N] = {0};
    yk_relation_gradient(mech, index, slope, columns);
    for (size_t k = 0; k < g->shape.unknowns; k++)
        factor[k] = columns[g->shape.column[k]] * (k < g->shape.angles ? 1 : g->size);
}

// Returns whether whole turns of an angle, which moves the argument by `factor` of its own, change nothing.
static bool repeats(const YkLaw *law, double factor)
{
    double period = yk_law_range(law).period;
    return factor == 0 || (period > 0 && is_whole(2 * YK_PI * factor / period));
}

// Reads a relation's law. Returns false if it is not smooth or turns change it.
static bool read_law(YkGeared *g, const YkMechanism *mech, size_t number, size_t index, double argument)
{
    const YkRelation *r = &mech->relations[index];
    YkGearedLaw *own = &g->laws[number];
    double linear[N], both[N];
    *own = (YkGearedLaw){.law = r->law, .bound = yk_law_bound(r->law), .gain = r->gain, .offset = argument};
    read_factors(g, mech, index, 0, linear);
    read_factors(g, mech, index, 1, both);
    for (size_t k = 0; k < g->shape.unknowns; k++) {
        own->factor[k] = both[k] - linear[k];
        if (k < g->shape.angles && !repeats(r->law, own->factor[k])) return false;
    }
    for (uint32_t k = r->first_argument_source; k < r->first_argument_source + r->argument_source_count; k++) {
        const YkRelationSource *s = &mech->sources[k];
        if (s->kind == YK_SOURCE_SLOT && !repeats(r->law, s->factor)) return false;
    }
    return own->bound.is_continuous && own->bound.curvature < INFINITY;
}

static bool read_relation(YkGeared *g, const YkRun *run, size_t number, size_t index)
{
    double times = 1 / g->size, own[N], zero[N] = {0}, law[YK_LAW_ORDER + 1] = {0};
    const YkRelation *r = &run->mech->relations[index];
    YkRelationPose pose = yk_relation_pose(run, index, zero, NULL);
    if (r->law && !read_law(g, run->mech, number, index, pose.argument)) return false;
    if (r->law) yk_law_eval(r->law, pose.argument, law);
    read_factors(g, run->mech, index, 0, own);
    if (has_angle(&g->shape, own) && !find_times(&g->shape, own, &times)) return false;
    for (size_t k = 0; k < g->shape.unknowns; k++)
        g->factor[number][k] = k < g->shape.angles ? rint(times * own[k]) : times * own[k];
    g->phase[number] = times * (pose.value.position - r->gain * law[0]);
    g->share[number][number] = times;
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

// Finds a basis of all combinations that whole turns of the angles give: the first columns of Hermite's form, by
// Euclid's algorithm on the columns. Returns false if the relations depend on each other.
static bool find_lattice(const YkGeared *g, double A[R][N])
{
    size_t n = g->shape.angles;
    for (size_t r = 0; r < g->turning; r++)
        for (size_t k = 0; k < n; k++) A[r][k] = g->factor[r][k];
    for (size_t r = 0; r < g->turning; r++) {
        for (bool goes_on = true; goes_on;) {
            size_t least = n;
            for (size_t k = r; k < n; k++)
                if (A[r][k] != 0 && (least == n || fabs(A[r][k]) < fabs(A[r][least]))) least = k;
            if (least == n) return false;
            swap_columns(A, g->turning, r, least);
            goes_on = false;
            for (size_t k = r + 1; k < n; k++) {
                subtract_column(A, g->turning, k, r, rint(A[r][k] / A[r][r]));
                goes_on |= A[r][k] != 0;
            }
        }
    }
    return true;
}

// Takes times relation `from` from relation r.
static void subtract_relation(YkGeared *g, size_t r, size_t from, double times)
{
    for (size_t k = 0; k < g->shape.unknowns; k++) g->factor[r][k] -= times * g->factor[from][k];
    for (size_t k = 0; k < g->relations; k++) g->share[r][k] -= times * g->share[from][k];
    g->phase[r] -= times * g->phase[from];
}

// Solves for the combinations that whole turns give one by one. Returns false if the relations depend on each other.
static bool combine(YkGeared *g)
{
    double A[R][N];
    if (!find_lattice(g, A)) return false;
    for (size_t r = 0; r < g->turning; r++) {
        for (size_t above = 0; above < r; above++) subtract_relation(g, r, above, A[r][above]);
        for (size_t k = 0; k < g->shape.unknowns; k++) g->factor[r][k] /= A[r][r];
        for (size_t k = 0; k < g->relations; k++) g->share[r][k] /= A[r][r];
        g->phase[r] /= A[r][r];
        for (size_t k = 0; k < g->shape.angles; k++) g->factor[r][k] = rint(g->factor[r][k]);
    }
    return true;
}

// Returns whether known angles that loops place, which have turns of their own, count with whole numbers too.
static bool are_known_turns_whole(const YkGeared *g, const YkMechanism *mech, const size_t *index)
{
    for (size_t r = 0; r < g->relations; r++) {
        const YkRelation *own = &mech->relations[index[r]];
        for (uint32_t k = own->first_source; k < own->first_source + own->source_count; k++) {
            const YkRelationSource *s = &mech->sources[k];
            if (s->kind != YK_SOURCE_SLOT) continue;
            if (r >= g->turning) return false; // they are not taken modulo turns
            for (size_t row = 0; row < g->turning; row++)
                if (!is_whole(g->share[row][r] * s->factor)) return false;
        }
    }
    return true;
}

// Lists a block's relations, those with angles first.
static void list_relations(YkGeared *g, const YkMechanism *mech, const YkBlock *block, size_t *index)
{
    size_t count = 0;
    for (int turning = 1; turning >= 0; turning--) {
        for (size_t r = 0; r < g->relations; r++) {
            double factor[N];
            size_t relation = (size_t)mech->group_relations[block->first_relation + r];
            read_factors(g, mech, relation, 0, factor);
            if (has_angle(&g->shape, factor) == (turning == 1)) index[count++] = relation;
        }
        if (turning == 1) g->turning = count;
    }
}

// --- distances

// Bounds a distance by a loop: it is no longer than all else of the loop together.
static double reach_in(const YkGeared *g, size_t loop, size_t slide)
{
    const YkVec *row = g->coefficients + loop * (g->shape.unknowns + 1);
    const double *radius = g->radius + loop * (g->shape.unknowns + 1);
    double own = yk_norm(row[slide]) - radius[slide], sum = yk_norm(row[g->shape.unknowns]) + radius[g->shape.unknowns];
    if (!(own > 0)) return INFINITY;
    for (size_t k = 0; k < g->shape.unknowns; k++) {
        double length = yk_norm(row[k]) + radius[k];
        if (k != slide && length > 0) sum += length * (k < g->shape.angles ? 1 : g->reach[k]);
    }
    return sum / own * (1 + 1e-9);
}

bool yk_geared_bound(YkGeared *g)
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
    *g = (YkGeared){.relations = block->relation_count, .size = mech->size};
    if (block->relation_count > R || block->column_count > N || block->loop_count > YK_GEARED_MAX) return false;
    if (yk_block_rows(block) < block->column_count || yk_block_rows(block) > YK_GEARED_ROWS) return false;
    if (!yk_shape_read_columns(&g->shape, mech, index)) return false;
    list_relations(g, mech, block, g->relation);
    for (size_t r = 0; r < g->relations; r++)
        if (!read_relation(g, run, r, g->relation[r])) return false;
    yk_coefficients_read(&g->shape, run, index, g->coefficients);
    return combine(g) && are_known_turns_whole(g, mech, g->relation) && yk_geared_bound(g);
}

// Returns the sum of a relation, at unknowns in the order of the shape.
static double sum_of(const YkGeared *g, size_t relation, const double *x)
{
    double sum = g->phase[relation];
    for (size_t k = 0; k < g->shape.unknowns; k++) sum += g->factor[relation][k] * x[k];
    for (size_t r = 0; r < g->relations; r++) {
        const YkGearedLaw *own = &g->laws[r];
        double argument = own->offset, d[YK_LAW_ORDER + 1];
        if (!own->law || g->share[relation][r] == 0) continue;
        for (size_t k = 0; k < g->shape.unknowns; k++) argument += own->factor[k] * x[k];
        yk_law_eval(own->law, argument, d);
        sum += g->share[relation][r] * own->gain * d[0];
    }
    return sum;
}

// Looks for turns of the angles from `k` on that give every relation what it wants; `most` turns in all.
static bool find_turns(const YkGeared *g, size_t k, const double *wanted, int most, int *turns)
{
    if (k == g->shape.angles) {
        for (size_t r = 0; r < g->turning; r++)
            if (wanted[r] != 0) return false;
        return true;
    }
    for (int t = 0; t <= 2 * most; t++) {
        double rest[R];
        turns[k] = t % 2 == 1 ? (t + 1) / 2 : -t / 2;
        for (size_t r = 0; r < g->turning; r++) rest[r] = wanted[r] - g->factor[r][k] * turns[k];
        if (find_turns(g, k + 1, rest, most - abs(turns[k]), turns)) return true;
    }
    return false;
}

bool yk_geared_turn(const YkGeared *g, double *x)
{
    int turns[N];
    double wanted[R];
    for (size_t r = 0; r < g->turning; r++) wanted[r] = -rint(sum_of(g, r, x) / (2 * YK_PI));
    for (int most = 0; most <= TURNS_MAX; most++) {
        if (!find_turns(g, 0, wanted, most, turns)) continue;
        for (size_t k = 0; k < g->shape.angles; k++) x[k] += 2 * YK_PI * turns[k];
        return true;
    }
    return false;
}
