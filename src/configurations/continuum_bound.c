// Bounds the dimension of a continuum from both sides, with proof.
#include <math.h>
#include <stdlib.h>
#include "compile/closure.h"
#include "configurations/continuum_inside.h"
#include "num/complex.h"
#include "num/dense.h"

// Proves that A[m][n] has a rank of at least r, at all poses within 1e-10 of this one: some r columns have a left
// inverse Y, with |I - Y A| < 1 in every row. Returns r, or 0 if that is not proved.
static size_t prove_rank(YkContinua *c, size_t m, size_t n, const double *A)
{
    size_t count = m * n + m + 2 * n + m * n;
    double *Q = calloc(count + 1, sizeof *Q), least = 0;
    size_t *order = calloc(n + 1, sizeof *order), rank = 0;
    c->failed |= !Q || !order;
    if (Q && order) {
        double *tau = Q + m * n, *b = tau + 2 * n, *Y = b + m;
        memcpy(Q, A, m * n * sizeof *Q);
        rank = yk_qr_factor(m, n, Q, order, tau, 1e-7);
        for (size_t i = 0; i < m && rank > 0; i++) { // Y's columns; each is x of least |A x - e_i|
            memset(b, 0, m * sizeof *b);
            b[i] = 1;
            yk_qr_solve(m, n, Q, order, tau, rank, b, Y + i * n);
        }
        for (size_t j = 0; j < rank; j++) {
            double sum = 0;
            for (size_t k = 0; k < rank; k++) {
                double entry = j == k ? -1 : 0, round = 0;
                for (size_t i = 0; i < m; i++) {
                    double y = Y[i * n + order[j]], a = A[i * n + order[k]];
                    entry += y * a;
                    round += fabs(y) * (fabs(a) * 0x1p-40 + 1e-9); // rounding; what the pose may move it by
                }
                sum += fabs(entry) + round;
            }
            least = fmax(least, sum);
        }
    }
    free(Q);
    free(order);
    return least < 0.9 ? rank : 0;
}

// --- bodies that keep their angle

// Returns the class of each orientation (0: the ground's): those that all samples show at the same angle to each other.
static size_t find_classes(YkContinua *c)
{
    const double same = 1e-9;
    size_t classes = 0, o = c->mech->orientation_count - 1;
    for (size_t k = 0; k < o; k++) {
        size_t with = o; // an earlier orientation, or `o` for the ground
        bool is_found = false;
        for (size_t j = 0; j <= k && !is_found; j++) { // the ground first
            is_found = true;
            for (size_t s = 1; s < c->sample_count; s++) {
                const double *x = c->samples + s * c->columns, *y = c->samples;
                double off = x[k] - y[k] - (j == 0 ? 0 : x[j - 1] - y[j - 1]);
                is_found &= fabs(yk_nearest_turn(off, 0)) < same;
            }
            if (is_found) with = j == 0 ? o : j - 1;
        }
        c->body[k] = !is_found ? ++classes : with == o ? 0 : c->body[with];
    }
    return classes;
}

// Returns how many of the loops are left, as complex rows, where orientations of one class turn together; SIZE_MAX
// where that is not clear or memory ran out.
static size_t count_loops(YkContinua *c, const double *x, size_t classes)
{
    const YkMechanism *mech = c->mech;
    // columns: the constant and the classes; a distance along each of them
    // A column and a row more have a single 1, beside which rounding is small however little the loops leave.
    size_t width = (classes + 1) * (mech->distance_count + 1) + 1, count = mech->loop_count + 1, rank = SIZE_MAX;
    YkVec *rows = calloc(count * width, sizeof *rows), *kernel = calloc(width * width, sizeof *kernel);
    YkVec *again = calloc(count * width, sizeof *rows);
    size_t *order = calloc(width + 1, sizeof *order);
    for (size_t l = 0; rows && kernel && again && order && l < mech->loop_count; l++) {
        const YkSum *sum = &mech->loops[l].sum;
        rows[l * width] = yk_scale(1 / mech->size, sum->constant);
        for (uint32_t k = 0; k < sum->count; k++) {
            YkTerm t = mech->terms[sum->first + k];
            size_t class = t.slot == 0 ? 0 : c->body[t.slot - 1];
            YkVec v = t.slot == 0 ? t.v : yk_mul(t.v, yk_unit(x[t.slot - 1]));
            YkVec *to = &rows[l * width + (size_t)(t.distance + 1) * (classes + 1) + class];
            *to = yk_add(*to, yk_scale(t.distance == YK_NONE ? 1 / mech->size : 1, v));
        }
    }
    c->failed |= !rows || !kernel || !again || !order;
    if (rows && kernel && again && order) {
        rows[count * width - 1] = yk_vec(1, 0);
        memcpy(again, rows, count * width * sizeof *rows);
        rank = yk_complex_kernel(count, width, rows, order, 1e-11, kernel) - 1;
        if (yk_complex_kernel(count, width, again, order, 1e-6, kernel) - 1 != rank) rank = SIZE_MAX;
    }
    free(rows);
    free(kernel);
    free(again);
    free(order);
    return rank;
}

// Adds up the columns of orientations that turn together: B[rows][classes + distances].
static void reduce_columns(const YkContinua *c, size_t classes, double *B)
{
    size_t n = c->columns, o = c->mech->orientation_count - 1, width = classes + n - o;
    for (size_t row = 0; row < c->rows; row++)
        for (size_t k = 0; k < n; k++) {
            size_t to = k >= o ? classes + k - o + 1 : c->body[k];
            if (to > 0) B[row * width + to - 1] += c->A[row * n + k];
        }
}

// Bounds the dimension from below. With the classes held together, e equations are left in n' unknowns; where their
// Jacobian is proved to have rank e, their solutions are a manifold of dimension n' - e, by the implicit function
// theorem.
static size_t bound_below(YkContinua *c, const double *x)
{
    size_t o = c->mech->orientation_count - 1, loops = 2 * c->mech->loop_count;
    size_t classes = find_classes(c), left = count_loops(c, x, classes), width = classes + c->columns - o, least = 0;
    if (left == SIZE_MAX || width == 0) return 0;
    size_t others = c->mech->relation_count + c->mech->input_count, rows = c->rows > width ? c->rows : width;
    double *B = calloc(rows * width + 1, sizeof *B), *Q = calloc(rows * width + 2 * width + 1, sizeof *Q);
    size_t *order = calloc(width + 1, sizeof *order);
    c->failed |= !B || !Q || !order;
    if (B && Q && order) {
        yk_continuum_evaluate(c, x);
        reduce_columns(c, classes, B);
        memset(Q, 0, rows * width * sizeof *Q);
        memcpy(Q, B + loops * width, others * width * sizeof *Q);
        // Gears and inputs are linear: those that repeat each other here do so everywhere.
        size_t linear = others == 0 ? 0 : yk_qr_factor(rows, width, Q, order, Q + rows * width, 1e-9);
        size_t equations = 2 * left + linear;
        if (equations < width && (equations == 0 || prove_rank(c, rows, width, B) == equations))
            least = width - equations;
    }
    free(B);
    free(Q);
    free(order);
    return least;
}

void yk_continuum_bound(YkContinua *c, const double *x, YkContinuum *found)
{
    found->at_least = bound_below(c, x);
    yk_continuum_evaluate(c, x);
    found->at_most = c->columns - prove_rank(c, c->rows, c->columns, c->A);
}

// --- ways along it

// Makes the kernel orthonormal, by Gram and Schmidt's method. Returns its dimension.
static size_t orthonormal_kernel(YkContinua *c, const double *x)
{
    size_t n = c->columns, d = yk_continuum_kernel(c, x);
    for (size_t k = 0; k < d; k++) {
        double *v = c->kernel + k * n;
        for (size_t twice = 0; twice < 2 * k; twice++) {
            const double *u = c->kernel + twice / 2 * n;
            double share = yk_inner_product(u, v, n);
            for (size_t j = 0; j < n; j++) v[j] -= share * u[j];
        }
        double length = sqrt(yk_inner_product(v, v, n));
        for (size_t j = 0; j < n; j++) v[j] /= length;
    }
    return d;
}

// Goes from x towards y as straight as the continuum allows. Returns whether it arrives.
static bool goes_straight(YkContinua *c, double *x, const double *y, int steps)
{
    size_t n = c->columns, o = c->mech->orientation_count - 1;
    double way[100], on[100], miss, last = INFINITY;
    for (int step = 0; step < steps; step++) {
        double apart = yk_continuum_apart(c, x, y), most = 0;
        if (apart < 1e-7) return true;
        if (!(apart < last)) return false;
        last = apart;
        size_t d = orthonormal_kernel(c, x);
        for (size_t j = 0; j < n; j++) {
            way[j] = j < o ? yk_nearest_turn(y[j] - x[j], 0) : (y[j] - x[j]) / c->mech->size;
            on[j] = 0;
        }
        for (size_t k = 0; k < d; k++) {
            double share = yk_inner_product(c->kernel + k * n, way, n);
            for (size_t j = 0; j < n; j++) on[j] += share * c->kernel[k * n + j];
        }
        for (size_t j = 0; j < n; j++) most = fmax(most, fabs(on[j]));
        double part = fmin(1, 0.1 / most);
        for (size_t j = 0; j < n; j++) x[j] += part * on[j] * (j < o ? 1 : c->mech->size);
        if (!(most > 1e-9) || !yk_continuum_close(c, x, &miss)) return false;
    }
    return false;
}

// Follows a curve from x, first forwards (sign 1) or backwards, and looks for y on it.
static bool meets(YkContinua *c, const double *x, const double *y, double sign)
{
    enum { STEPS = 1500 };
    size_t n = c->columns, o = c->mech->orientation_count - 1;
    double at[100], heading[100] = {0}, from[100], miss;
    memcpy(at, x, n * sizeof *at);
    for (int step = 0; step < STEPS; step++) {
        if (yk_continuum_apart(c, at, y) < 0.15) {
            memcpy(from, at, n * sizeof *at);
            if (goes_straight(c, from, y, 12)) return true;
        }
        if (step > 10 && yk_continuum_apart(c, at, x) < 0.03) return false; // once round
        if (orthonormal_kernel(c, at) != 1) return false;
        double way = step == 0 ? sign : yk_inner_product(c->kernel, heading, n) < 0 ? -1 : 1;
        for (size_t j = 0; j < n; j++) {
            heading[j] = way * c->kernel[j];
            at[j] += 0.06 * heading[j] * (j < o ? 1 : c->mech->size);
        }
        if (!yk_continuum_close(c, at, &miss)) return false;
    }
    return false;
}

bool yk_continuum_joins(YkContinua *c, const double *x, const double *y, size_t dimension)
{
    double at[100];
    memcpy(at, x, c->columns * sizeof *at);
    if (goes_straight(c, at, y, 200)) return true;
    return dimension == 1 && (meets(c, x, y, 1) || meets(c, x, y, -1));
}
