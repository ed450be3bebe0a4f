// Counts solutions by intersecting the cones of two tropical linear spaces.
//
// The cones of a tropical linear space are the chains of flats of its matroid: F_1 < ... < F_L stands for all sums of
// a_i 1_(F_i) with a_i >= 0 (Ardila & Klivans 2006). Every constraint x_j y_j = c becomes X_j + Y_j = v_j, a distance
// that both conjugates share X_m - X_j = Y_m - Y_j + v_m. At generic v, two cones meet in a point or not at all, and
// count |det| times (Osserman & Payne 2013).
#include "configurations/count.h"
#include <stdlib.h>
#include "base/mix.h"
#include "num/dense.h"

enum { L_MAX = YK_SYSTEM_LOOPS_MAX, N_MAX = 2 * L_MAX, PAIRS_MAX = 3000000 };

typedef struct Cones {
    const YkMatroid *matroid;
    const YkShape *shape;
    size_t *flats; // [chain][loops]
    size_t count, capacity;
    size_t chain[L_MAX];
    bool failed;
} Cones;

static bool is_flat(const YkMatroid *m, size_t set)
{
    for (size_t e = 0; e < m->elements; e++)
        if (!(set >> e & 1) && m->rank[set | (size_t)1 << e] == m->rank[set]) return false;
    return true;
}

static void list_chains(Cones *c, size_t depth)
{
    size_t loops = c->shape->loops, below = depth == 0 ? 0 : c->chain[depth - 1];
    if (depth == loops) {
        if (c->count == c->capacity) {
            size_t capacity = 2 * c->capacity + 64;
            size_t *flats = realloc(c->flats, capacity * loops * sizeof *flats);
            c->failed |= !flats;
            if (!flats) return;
            c->flats = flats;
            c->capacity = capacity;
        }
        for (size_t k = 0; k < loops; k++) c->flats[c->count * loops + k] = c->chain[k];
        c->count++;
        return;
    }
    size_t all = ((size_t)1 << c->matroid->elements) - 1, rest = all ^ below;
    for (size_t add = rest; add && !c->failed && c->count * c->count <= PAIRS_MAX; add = (add - 1) & rest) {
        c->chain[depth] = below | add;
        if (c->matroid->rank[below | add] == depth + 1 && is_flat(c->matroid, below | add)) list_chains(c, depth + 1);
    }
}

// Writes the left-hand sides at a flat's vector 1_F, from which the constant's coordinate was taken: a column of the
// equations. side: 0 for X, 1 for Y.
static void write_column(const YkShape *shape, size_t flat, int side, double *A, size_t column)
{
    size_t n = shape->unknowns;
    double constant = (double)(flat >> n & 1), sign = side == 0 ? 1 : -1;
    for (size_t k = 0; k < n; k++) {
        double own = (double)(flat >> k & 1) - constant;
        int turning = shape->turning[k];
        double angle = turning < 0 ? 0 : (double)(flat >> turning & 1) - constant;
        A[k * n + column] = k < shape->angles ? own : sign * (own - angle);
    }
}

// Returns how often two cones meet: |det|, 0 where they do not, -1 where v is not generic enough to tell.
static int meet(const Cones *c, const size_t *X, const size_t *Y, const double *v)
{
    const double unclear = 1e-9;
    size_t n = c->shape->unknowns, loops = c->shape->loops;
    double A[N_MAX * N_MAX], b[N_MAX], scale[N_MAX], det = 1;
    int pivot[N_MAX];
    for (size_t k = 0; k < loops; k++) {
        write_column(c->shape, X[k], 0, A, k);
        write_column(c->shape, Y[k], 1, A, loops + k);
    }
    if (yk_lu_factor(n, A, pivot, scale) == 0) return 0;
    for (size_t k = 0; k < n; k++) det *= A[k * n + k];
    if (fabs(det) < 0.5) return 0;
    for (size_t k = 0; k < n; k++) b[k] = v[k];
    yk_lu_solve(n, A, pivot, b);
    for (size_t k = 0; k < n; k++) {
        if (fabs(b[k]) < unclear) return -1;
        if (b[k] < 0) return 0;
    }
    return (int)(fabs(det) + 0.5);
}

// Counts with one choice of v. Returns false if it was not generic, or when stopped.
static bool count_with(const Cones *c, uint64_t seed, YkPace *pace, size_t *count)
{
    double v[N_MAX];
    size_t n = c->shape->unknowns, loops = c->shape->loops;
    for (size_t k = 0; k < n; k++) v[k] = 2 * yk_mix_unit(&seed) - 1;
    *count = 0;
    for (size_t x = 0; x < c->count; x++) {
        if (!yk_pace_spend(pace, c->count * n * n * n)) return false;
        for (size_t y = 0; y < c->count; y++) {
            int times = meet(c, c->flats + x * loops, c->flats + y * loops, v);
            if (times < 0) return false;
            *count += (size_t)times;
        }
    }
    return true;
}

YkCountStatus yk_count_cones(const YkMatroid *matroid, const YkShape *shape, YkPace *pace, size_t *count)
{
    Cones c = {.matroid = matroid, .shape = shape};
    bool counted = false;
    *count = 0;
    for (size_t e = 0; e < matroid->elements; e++)
        if (matroid->rank[(size_t)1 << e] == 0) return YK_COUNTED; // an unknown that must vanish: no solution
    list_chains(&c, 0);
    bool is_large = c.count * c.count > PAIRS_MAX;
    for (uint64_t seed = 0; seed < 3 && !counted && !c.failed && !is_large; seed++)
        counted = count_with(&c, 1000 * seed, pace, count);
    free(c.flats);
    if (counted) return YK_COUNTED;
    if (c.failed) return YK_COUNT_NO_MEMORY;
    return yk_pace_is_stopped(pace) ? YK_COUNT_STOPPED : YK_COUNT_TOO_LARGE;
}
