// Solves the pencil of a group with one unknown hidden, and reads the solutions from eigenvectors.
#include "configurations/eliminate.h"
#include <stdlib.h>
#include "base/mix.h"
#include "configurations/pencil.h"
#include "num/complex.h"
#include "num/eigen.h"

enum { N_MAX = 2 * YK_ELIMINATION_LOOPS_MAX, MOST = YK_ELIMINATION_MOST };

typedef struct Work {
    YkHidden hidden;
    YkPencil pencil;
    YkVec shift;                              // h = shift - 1 / value
    YkVec values[MOST], vectors[MOST * MOST]; // vectors in columns
    bool is_read[MOST];
    // Eigenvectors whose values are equal, and what multiplies their combinations.
    size_t cluster[MOST], size;
    YkVec times[MOST * MOST], low[MOST * MOST], high[MOST * MOST], combinations[MOST * MOST];
    int pivot[MOST];
} Work;

// Computes the eigenvalues of M_0 + h M_1 by those of 1 / (shift - h). Returns false if they are not found: the matrix
// is singular for every h.
static bool solve_pencil(Work *w)
{
    size_t n = w->pencil.count;
    YkVec column[MOST], *S = w->pencil.M[0], *R = w->pencil.M[1];
    for (size_t k = 0; k < n * n; k++) S[k] = yk_add_product(S[k], w->shift, R[k]);
    if (!yk_complex_factor(n, S, w->pivot)) return false;
    for (size_t j = 0; j < n; j++) {
        for (size_t i = 0; i < n; i++) column[i] = R[i * n + j];
        yk_complex_solve(n, S, w->pivot, column);
        for (size_t i = 0; i < n; i++) R[i * n + j] = column[i];
    }
    return yk_eigen_complex(n, R, w->values, w->vectors);
}

// Reads an angle from an eigenvector: the ratio of two monomials that differ by it, the largest for accuracy. Returns
// false if there is none.
static bool read_angle(const Work *w, const YkVec *vector, size_t angle, YkVec *z)
{
    const YkPencil *p = &w->pencil;
    double best = 0;
    for (size_t e = 0; e < p->count; e++) {
        int other = yk_pencil_column(p, yk_times_angle(p->monomials[e], (int)angle, 1));
        double size = other < 0 ? 0 : yk_sum_norm(vector[e]) * yk_sum_norm(vector[other]);
        if (!(size > best)) continue;
        best = size;
        *z = yk_mul(vector[other], yk_inverse(vector[e]));
    }
    return best > 0;
}

static bool read_solution(const Work *w, YkVec value, const YkVec *vector, YkVec *x)
{
    YkVec z[N_MAX];
    for (size_t k = 0; k < w->hidden.angles; k++)
        if (!read_angle(w, vector, k, &z[k])) return false;
    return yk_hidden_restore(&w->hidden, yk_sub(w->shift, yk_inverse(value)), z, x);
}

// --- solutions with equal h

// Adds, times a random number, the matrix by which an angle multiplies the vectors of the cluster: with their rows of
// all monomials in `low` and of the same times the angle in `high`, low Z = high by least squares. Returns false if the
// rows do not determine it.
static bool add_angle(Work *w, size_t angle, YkVec share)
{
    const YkPencil *p = &w->pencil;
    size_t c = w->size;
    for (size_t k = 0; k < c * c; k++) w->low[k] = w->high[k] = yk_vec(0, 0);
    for (size_t e = 0; e < p->count; e++) {
        int other = yk_pencil_column(p, yk_times_angle(p->monomials[e], (int)angle, 1));
        if (other < 0) continue;
        const YkVec *low = w->vectors + e * p->count, *high = w->vectors + (size_t)other * p->count;
        for (size_t i = 0; i < c; i++) {
            YkVec a = yk_conj(low[w->cluster[i]]);
            for (size_t j = 0; j < c; j++) {
                w->low[i * c + j] = yk_add_product(w->low[i * c + j], a, low[w->cluster[j]]);
                w->high[j * c + i] = yk_add_product(w->high[j * c + i], a, high[w->cluster[j]]); // transposed
            }
        }
    }
    if (!yk_complex_factor(c, w->low, w->pivot)) return false;
    for (size_t j = 0; j < c; j++) {
        yk_complex_solve(c, w->low, w->pivot, w->high + j * c);
        for (size_t i = 0; i < c; i++)
            w->times[i * c + j] = yk_add_product(w->times[i * c + j], share, w->high[j * c + i]);
    }
    return true;
}

// Finds which combinations of the cluster's vectors are solutions: a random sum of all angles multiplies them, too.
// Returns false if they are not determined.
static bool split_cluster(Work *w)
{
    uint64_t seed = 3;
    YkVec values[MOST];
    bool has_angle = false;
    for (size_t k = 0; k < w->size * w->size; k++) w->times[k] = yk_vec(0, 0);
    for (size_t k = 0; k < w->hidden.angles; k++) has_angle |= add_angle(w, k, yk_unit(6 * yk_mix_unit(&seed)));
    return has_angle && yk_eigen_complex(w->size, w->times, values, w->combinations);
}

static void make_unit(Work *w, size_t vector)
{
    double sum = 0;
    size_t n = w->pencil.count;
    YkVec *v = w->vectors + vector;
    for (size_t e = 0; e < n; e++) sum += yk_dot(v[e * n], v[e * n]);
    for (size_t e = 0; e < n; e++) v[e * n] = yk_scale(1 / sqrt(sum), v[e * n]);
}

// Gathers the eigenvalues that are equal to one, but for rounding.
static void gather_cluster(Work *w, size_t first)
{
    const double near = 1e-5;
    w->size = 0;
    for (size_t k = first; k < w->pencil.count; k++) {
        double off = yk_sum_norm(yk_sub(w->values[k], w->values[first]));
        if (w->is_read[k] || !(off <= near * yk_sum_norm(w->values[first]))) continue;
        w->is_read[k] = true;
        w->cluster[w->size++] = k;
        make_unit(w, k);
    }
}

static size_t read_cluster(Work *w, size_t unknowns, YkVec *solutions)
{
    size_t n = w->pencil.count, count = 0;
    YkVec vector[MOST];
    bool is_split = w->size > 1 && split_cluster(w);
    for (size_t s = 0; s < w->size; s++) {
        for (size_t e = 0; e < n; e++) {
            vector[e] = is_split ? yk_vec(0, 0) : w->vectors[e * n + w->cluster[s]];
            for (size_t j = 0; is_split && j < w->size; j++)
                vector[e] =
                    yk_add_product(vector[e], w->vectors[e * n + w->cluster[j]], w->combinations[j * w->size + s]);
        }
        count += read_solution(w, w->values[w->cluster[s]], vector, solutions + count * unknowns);
    }
    return count;
}

bool yk_eliminate(const YkShape *shape, const YkVec *coefficients, size_t attempt, YkVec *solutions, size_t *count)
{
    const double infinite = 1e-9;
    uint64_t seed = 2;
    Work *w = calloc(1, sizeof *w);
    *count = 0;
    if (!w) return false;
    bool can = shape->loops <= YK_ELIMINATION_LOOPS_MAX && yk_hide(&w->hidden, shape, coefficients, attempt);
    YkPencilStatus status = can ? yk_pencil_make(&w->pencil, &w->hidden) : YK_PENCIL_NONE;
    w->shift = yk_unit(2 * YK_PI * yk_mix_unit(&seed));
    bool is_solved = status == YK_PENCIL_MADE && solve_pencil(w);
    for (size_t k = 0; k < w->pencil.count && is_solved; k++) {
        if (w->is_read[k] || !(yk_sum_norm(w->values[k]) > infinite)) continue;
        gather_cluster(w, k);
        *count += read_cluster(w, shape->unknowns, solutions + *count * shape->unknowns);
    }
    free(w);
    return status != YK_PENCIL_NO_MEMORY;
}
