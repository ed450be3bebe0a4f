// Counts solutions by intersecting the cones of two tropical linear spaces.
//
// A tropical linear space is a fan. Its cones belong to nested sets of connected flats of the matroid: {F_1 .. F_L}
// stands for all sums of a_i 1_(F_i) with a_i >= 0, where no two or more incomparable ones have a connected flat as
// their join (Feichtner & Sturmfels 2005). These are far fewer than the chains of all flats (Ardila & Klivans 2006),
// which divide them further. Every constraint x_j y_j = c becomes X_j + Y_j = v_j, a distance that both conjugates
// share X_m - X_j = Y_m - Y_j + v_m. At generic v, two cones meet in a point or not at all, and count |det| times
// (Osserman & Payne 2013).
#include "configurations/count.h"
#include <math.h>
#include <stdlib.h>
#include "base/memory.h"
#include "base/mix.h"
#include "num/dense.h"

enum { L_MAX = YK_SYSTEM_LOOPS_MAX, N_MAX = 2 * L_MAX, PAIRS_MAX = 100000000 };

typedef struct Cones {
    const YkMatroid *matroid;
    const YkShape *shape;
    size_t *flats; // connected, without the set of all
    size_t flat_count, flat_capacity;
    uint16_t *cones; // [cone][loops]: flats
    size_t count, capacity;
    size_t nested[L_MAX]; // flats of the cone that is being listed
    double *columns;      // [flat][unknowns]: see eliminate
    bool is_large, failed;
} Cones;

// --- the cones

static size_t closure_of(const YkMatroid *m, size_t set)
{
    size_t closure = set;
    for (size_t e = 0; e < m->elements; e++)
        if (m->rank[set | (size_t)1 << e] == m->rank[set]) closure |= (size_t)1 << e;
    return closure;
}

// Returns whether a set is connected: it is not the direct sum of two smaller sets.
static bool is_connected(const YkMatroid *m, size_t set)
{
    size_t one = set & -set, rest = set ^ one;
    for (size_t part = rest; part; part = (part - 1) & rest) // the part without the first element
        if (m->rank[part] + m->rank[set ^ part] == m->rank[set]) return false;
    return true;
}

// Returns whether a set is a member of the building set: a connected flat, or all.
static bool is_built(const YkMatroid *m, size_t flat)
{
    return flat + 1 == (size_t)1 << m->elements || is_connected(m, flat);
}

static bool list_flats(Cones *c)
{
    const YkMatroid *m = c->matroid;
    for (size_t set = 1; set + 1 < (size_t)1 << m->elements; set++) {
        if (closure_of(m, set) != set || !is_connected(m, set)) continue;
        if (!YK_ROOM(c->flats, c->flat_count, c->flat_capacity)) return false;
        c->flats[c->flat_count++] = set;
    }
    return true;
}

static bool are_comparable(size_t a, size_t b)
{
    return (a & b) == a || (a & b) == b;
}

// Returns whether no join of `flat` with incomparable ones among those nested from `from` on is in the building set.
// join: that of `flat` with those chosen before, mutually incomparable, whose bits are in `chosen`.
static bool fits(const Cones *c, size_t depth, size_t flat, size_t join, size_t from, size_t chosen)
{
    for (size_t k = from; k < depth; k++) {
        size_t other = c->flats[c->nested[k]];
        bool is_incomparable = !are_comparable(flat, other);
        for (size_t j = 0; j < k && is_incomparable; j++)
            if (chosen >> j & 1) is_incomparable = !are_comparable(c->flats[c->nested[j]], other);
        if (!is_incomparable) continue;
        size_t with = closure_of(c->matroid, join | other);
        if (is_built(c->matroid, with) || !fits(c, depth, flat, with, k + 1, chosen | (size_t)1 << k)) return false;
    }
    return true;
}

static void list_cones(Cones *c, size_t depth, size_t first)
{
    size_t loops = c->shape->loops;
    if (depth == loops) {
        c->is_large |= (c->count + 1) * (c->count + 1) > PAIRS_MAX;
        c->failed |= !YK_ROW_ROOM(c->cones, loops, c->count, c->capacity);
        if (c->failed) return;
        for (size_t k = 0; k < loops; k++) c->cones[c->count * loops + k] = (uint16_t)c->nested[k];
        c->count++;
        return;
    }
    for (size_t f = first; f + loops - depth <= c->flat_count && !c->failed && !c->is_large; f++) {
        if (!fits(c, depth, c->flats[f], c->flats[f], 0, 0)) continue;
        c->nested[depth] = f;
        list_cones(c, depth + 1, f + 1);
    }
}

// --- their intersections

// Writes the left-hand sides at a flat's vector 1_F, from which the constant's coordinate was taken: a column of the
// equations. side: 0 for X, 1 for Y.
static void write_column(const YkShape *shape, size_t flat, int side, double *column)
{
    size_t n = shape->unknowns;
    double constant = (double)(flat >> n & 1), sign = side == 0 ? 1 : -1;
    for (size_t k = 0; k < n; k++) {
        double own = (double)(flat >> k & 1) - constant;
        int turning = shape->turning[k];
        double angle = turning < 0 ? 0 : (double)(flat >> turning & 1) - constant;
        column[k] = k < shape->angles ? own : sign * (own - angle);
    }
}

// Pivot rows that eliminate the columns of the first cone, one each.
typedef struct Steps {
    size_t pivot[L_MAX];
    double column[L_MAX][N_MAX], det; // each as it was when its turn came
    bool is_used[N_MAX];
} Steps;

// Takes the pivot columns' share from a vector: what is left in the rows without a pivot does not depend on the first
// cone; the entry of pivot k is then x_k plus what later pivots contribute to it.
static void apply(const Steps *s, size_t count, size_t n, double *v)
{
    for (size_t k = 0; k < count; k++) {
        double share = v[s->pivot[k]] / s->column[k][s->pivot[k]];
        for (size_t i = 0; i < n; i++)
            if (i != s->pivot[k]) v[i] -= share * s->column[k][i];
        v[s->pivot[k]] = share;
    }
}

// Returns false if the columns depend on each other: no second cone meets this one in a point.
static bool eliminate(const Cones *c, const uint16_t *cone, Steps *s)
{
    size_t n = c->shape->unknowns;
    *s = (Steps){.det = 1};
    for (size_t k = 0; k < c->shape->loops; k++) {
        double *column = s->column[k];
        size_t best = n;
        write_column(c->shape, c->flats[cone[k]], 0, column);
        apply(s, k, n, column);
        for (size_t i = 0; i < n; i++)
            if (!s->is_used[i] && (best == n || fabs(column[i]) > fabs(column[best]))) best = i;
        if (fabs(column[best]) < 1e-6) return false;
        s->pivot[k] = best;
        s->is_used[best] = true;
        s->det *= column[best];
    }
    return true;
}

// Solves A x = b of size n in place, unless A is singular. Returns |det A|.
static double solve(size_t n, double *A, double *b)
{
    int pivot[L_MAX];
    double scale[L_MAX], det = 1;
    if (yk_lu_factor(n, A, pivot, scale) == 0) return 0;
    yk_lu_solve(n, A, pivot, b);
    for (size_t k = 0; k < n; k++) det *= fabs(A[k * n + k]);
    return det;
}

// Returns 1 if all are positive, 0 if one is negative, -1 where it is not clear.
static int sign_of(const double *x, size_t n)
{
    const double unclear = 1e-9;
    int sign = 1;
    for (size_t k = 0; k < n; k++) {
        if (x[k] < -unclear) return 0;
        if (x[k] < unclear) sign = -1;
    }
    return sign;
}

// Returns how often the eliminated cone meets another: |det|, 0 if they do not, -1 where v is not generic enough to
// tell. v: with the first cone's share taken from it.
static int meet(const Cones *c, const Steps *s, const uint16_t *cone, const double *v)
{
    size_t n = c->shape->unknowns, loops = c->shape->loops, row = 0;
    double A[L_MAX * L_MAX], b[L_MAX], a[L_MAX];
    for (size_t i = 0; i < n; i++) {
        if (s->is_used[i]) continue;
        for (size_t k = 0; k < loops; k++) A[row * loops + k] = c->columns[cone[k] * n + i];
        b[row++] = v[i];
    }
    double det = fabs(s->det) * solve(loops, A, b);
    if (det < 0.5) return 0;
    int sign = sign_of(b, loops);
    if (sign == 0) return 0;
    for (size_t k = loops; k-- > 0;) {
        a[k] = v[s->pivot[k]];
        for (size_t j = 0; j < loops; j++) a[k] -= c->columns[cone[j] * n + s->pivot[k]] * b[j];
    }
    int other = sign_of(a, loops);
    return other == 0 ? 0 : sign < 0 || other < 0 ? -1 : (int)(det + 0.5);
}

// Counts with one choice of v. Returns false if it was not generic, or when stopped.
static bool count_with(const Cones *c, uint64_t seed, YkPace *pace, size_t *count)
{
    double v[N_MAX], rest[N_MAX];
    size_t n = c->shape->unknowns, loops = c->shape->loops;
    for (size_t k = 0; k < n; k++) v[k] = 2 * yk_mix_unit(&seed) - 1;
    *count = 0;
    for (size_t x = 0; x < c->count; x++) {
        Steps steps;
        if (!yk_pace_spend(pace, c->count * loops * loops * loops)) return false;
        if (!eliminate(c, c->cones + x * loops, &steps)) continue;
        for (size_t f = 0; f < c->flat_count; f++) {
            write_column(c->shape, c->flats[f], 1, c->columns + f * n);
            apply(&steps, loops, n, c->columns + f * n);
        }
        for (size_t k = 0; k < n; k++) rest[k] = v[k];
        apply(&steps, loops, n, rest);
        for (size_t y = 0; y < c->count; y++) {
            int times = meet(c, &steps, c->cones + y * loops, rest);
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
    c.failed = !list_flats(&c);
    c.columns = malloc((c.flat_count * shape->unknowns + 1) * sizeof *c.columns);
    c.failed |= !c.columns;
    if (!c.failed) list_cones(&c, 0, 0);
    for (uint64_t seed = 0; seed < 3 && !counted && !c.failed && !c.is_large; seed++)
        counted = count_with(&c, 1000 * seed, pace, count);
    free(c.flats);
    free(c.cones);
    free(c.columns);
    if (counted) return YK_COUNTED;
    if (c.failed) return YK_COUNT_NO_MEMORY;
    return yk_pace_is_stopped(pace) ? YK_COUNT_STOPPED : YK_COUNT_TOO_LARGE;
}
