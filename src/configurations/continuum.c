// Follows the kernel of all equations of a machine, and bounds the dimension of what it leads to.
#include "configurations/continuum.h"
#include <math.h>
#include <stdlib.h>
#include "base/mix.h"
#include "compile/closure.h"
#include "configurations/continuum_inside.h"

enum { UNKNOWNS_MAX = 100, TRIES = 24 };
#define STEP 0.02 // rad or sizes

static size_t row_count(const YkMechanism *mech)
{
    return 2 * mech->loop_count + mech->relation_count + mech->input_count;
}

bool yk_continua_start(YkContinua *c, const YkMechanism *mech)
{
    size_t n = yk_variable_count(mech), m = row_count(mech), rows = m > n ? m : n;
    *c = (YkContinua){.mech = mech};
    for (size_t k = 0; k < mech->relation_count; k++)
        if (mech->relations[k].law) return true;
    if (n == 0 || n > UNKNOWNS_MAX) return true;
    c->rows = rows; // rows of zeros make up for those that lack
    c->columns = n;
    c->x0 = calloc(rows * n + 3 * rows + 5 * n + n * n + YK_CONTINUUM_SAMPLES * n, sizeof(double));
    c->order = calloc(2 * n + 1, sizeof *c->order);
    if (!c->x0 || !c->order) yk_continua_end(c);
    if (!c->x0) return false;
    c->A = c->x0 + n;
    c->F = c->A + rows * n;
    c->b = c->F + rows;
    c->tau = c->b + 2 * rows;
    c->step = c->tau + 2 * n;
    c->kernel = c->step + 2 * n;
    c->samples = c->kernel + n * n;
    c->body = c->order + n;
    return true;
}

void yk_continua_end(YkContinua *c)
{
    free(c->x0);
    free(c->order);
    free(c->poses);
    free(c->dimension);
    *c = (YkContinua){0};
}

// --- the dimension

// Takes a short step from x along a direction, which becomes the pose that the step leads to. Returns whether that
// is a pose, about as far away as the step was long.
static bool take_step(YkContinua *c, const double *x, double *way, double *miss)
{
    for (size_t k = 0; k < c->columns; k++) way[k] = x[k] + STEP * yk_continuum_unit(c, k) * way[k];
    if (!yk_continuum_close(c, way, miss)) return false;
    double off = yk_continuum_apart(c, x, way);
    return off > STEP / 3 && off < 3 * STEP;
}

static void keep_sample(YkContinua *c, const double *x)
{
    if (c->sample_count < YK_CONTINUUM_SAMPLES)
        memcpy(c->samples + c->sample_count++ * c->columns, x, c->columns * sizeof *x);
}

// Returns whether x can move along all of its kernel, both ways, and the kernel stays as large.
static bool moves_along_all(YkContinua *c, const double *x, YkContinuum *found)
{
    double way[UNKNOWNS_MAX], miss;
    size_t n = c->columns, d = yk_continuum_kernel(c, x);
    YkContinuum own = {.dimension = d};
    c->sample_count = 0;
    keep_sample(c, x);
    for (size_t k = 0; k < 2 * d; k++) {
        yk_continuum_kernel(c, x);
        for (size_t j = 0; j < n; j++) way[j] = (k % 2 == 0 ? 1 : -1) * c->kernel[k / 2 * n + j];
        if (!take_step(c, x, way, &miss) || yk_continuum_kernel(c, way) != d) return false;
        keep_sample(c, way);
        own.poses++;
        own.miss = fmax(own.miss, miss);
    }
    if (d > 0) *found = own;
    return d > 0;
}

// Takes a step from x0 along a random direction of its kernel. Returns whether it leads to a pose.
static bool step_aside(YkContinua *c, size_t dimension, uint64_t *seed, double *way)
{
    double share[UNKNOWNS_MAX], most = 0, miss;
    size_t n = c->columns;
    for (size_t k = 0; k < dimension; k++) share[k] = 2 * yk_mix_unit(seed) - 1;
    for (size_t j = 0; j < n; j++) {
        way[j] = 0;
        for (size_t k = 0; k < dimension; k++) way[j] += share[k] * c->kernel[k * n + j];
        most = fmax(most, fabs(way[j]));
    }
    for (size_t j = 0; j < n; j++) way[j] /= most;
    return take_step(c, c->x0, way, &miss);
}

// Finds the largest dimension of a continuum through x0, or beside it if several cross there. *x: a pose on the
// continuum whose kernel has exactly that dimension.
static void find_dimension(YkContinua *c, double *x, YkContinuum *found)
{
    double way[UNKNOWNS_MAX];
    uint64_t seed = 7;
    size_t d = yk_continuum_kernel(c, c->x0);
    if (d == 0) return;
    memcpy(x, c->x0, c->columns * sizeof *x);
    if (moves_along_all(c, x, found)) return;
    for (int k = 0; k < TRIES && d > 0; k++) {
        YkContinuum own = {0};
        yk_continuum_kernel(c, c->x0);
        if (!step_aside(c, d, &seed, way) || !moves_along_all(c, way, &own)) continue;
        if (own.dimension <= found->dimension) continue;
        *found = own;
        memcpy(x, way, c->columns * sizeof *x);
    }
    if (found->dimension > 0) moves_along_all(c, x, found); // with the samples of this one
}

static void read_pose(YkContinua *c, const YkState *s)
{
    size_t o = c->mech->orientation_count - 1;
    for (size_t k = 0; k < o; k++) {
        YkTurn t = yk_space_turn(&s->space, (int32_t)k + 1);
        c->x0[k] = yk_atan2(*t.s, *t.c);
    }
    for (size_t k = o; k < c->columns; k++) c->x0[k] = *yk_space_slide(&s->space, (int32_t)(k - o)).d;
}

static bool keep_pose(YkContinua *c, size_t dimension)
{
    size_t n = c->columns;
    if (c->kept == c->kept_capacity) {
        size_t capacity = 2 * c->kept_capacity + 8;
        double *poses = realloc(c->poses, capacity * n * sizeof *poses);
        if (poses) c->poses = poses;
        size_t *dimensions = realloc(c->dimension, capacity * sizeof *dimensions);
        if (dimensions) c->dimension = dimensions;
        if (!poses || !dimensions) return false;
        c->kept_capacity = capacity;
    }
    memcpy(c->poses + c->kept * n, c->x0, n * sizeof *c->x0);
    c->dimension[c->kept++] = dimension;
    return true;
}

bool yk_continuum_at(YkContinua *c, const YkState *state, YkContinuum *found, bool *is_new)
{
    double x[UNKNOWNS_MAX];
    *found = (YkContinuum){0};
    *is_new = true;
    c->failed = false;
    if (c->columns == 0) return true;
    read_pose(c, state);
    find_dimension(c, x, found);
    if (found->dimension == 0) return true;
    yk_continuum_bound(c, x, found);
    if (c->failed) return false;
    for (size_t k = 0; k < c->kept && *is_new; k++)
        *is_new = c->dimension[k] != found->dimension ||
                  !yk_continuum_joins(c, c->x0, c->poses + k * c->columns, found->dimension);
    return !*is_new || keep_pose(c, found->dimension);
}
