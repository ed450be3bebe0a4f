#include "compile/closure.h"
#include <stdlib.h>
#include <string.h>
#include "num/dense.h"

static void add_entry(const YkMechanism *mech, double *row, size_t n, int32_t slot, int32_t distance, YkVec turned, double d)
{
    YkVec turning = yk_scale(d, yk_quarter(turned));
    if (slot > 0) {
        row[slot - 1] += turning.x;
        row[n + (size_t)slot - 1] += turning.y;
    }
    if (distance == YK_NONE) return;
    size_t column = mech->orientation_count - 1 + (size_t)distance;
    row[column] += turned.x;
    row[n + column] += turned.y;
}

void yk_closure(const YkMechanism *mech, const double *x, double *residual, double *jacobian)
{
    size_t n = yk_variable_count(mech), o = mech->orientation_count - 1;
    if (jacobian) memset(jacobian, 0, 2 * mech->loop_count * n * sizeof *jacobian);
    for (size_t l = 0; l < mech->loop_count; l++) {
        const YkSum *sum = &mech->loops[l].sum;
        YkVec total = sum->constant;
        for (uint32_t k = 0; k < sum->count; k++) {
            YkTerm t = mech->terms[sum->first + k];
            double d = t.distance == YK_NONE ? 1 : x[o + (size_t)t.distance];
            YkVec turned = t.slot == 0 ? t.v : yk_mul(yk_unit(x[t.slot - 1]), t.v);
            total = yk_add(total, yk_scale(d, turned));
            if (jacobian) add_entry(mech, jacobian + 2 * l * n, n, t.slot, t.distance, turned, d);
        }
        residual[2 * l] = total.x;
        residual[2 * l + 1] = total.y;
    }
}

YkJointAngle yk_joint_angle(const YkMechanism *mech, int32_t joint)
{
    const YkJoint *j = &mech->model->joints[joint];
    const YkPlacing *a = &mech->bodies[j->body[0]], *b = &mech->bodies[j->body[1]];
    return (YkJointAngle){a->orientation, b->orientation, b->turn - a->turn};
}

void yk_closure_guess(const YkMechanism *mech, const double *coordinates, double *x)
{
    size_t n = mech->orientation_count;
    for (size_t k = 0; k < yk_variable_count(mech); k++) x[k] = 0;
    // Angles add up along the tree; coordinates are in joint order, so sweep until nothing changes (depth of the tree at most).
    bool *is_set = calloc(n, sizeof *is_set);
    if (!is_set) return;
    is_set[0] = true;
    for (bool more = true; more;) {
        more = false;
        for (size_t k = 0; k < mech->coordinate_count; k++) {
            const YkTreeCoordinate *c = &mech->coordinates[k];
            if (c->is_distance) {
                x[n - 1 + (size_t)c->distance] = coordinates[k];
                continue;
            }
            YkJointAngle j = yk_joint_angle(mech, c->joint);
            if (is_set[j.a] == is_set[j.b]) continue;
            int32_t from = is_set[j.a] ? j.a : j.b, to = is_set[j.a] ? j.b : j.a;
            double way = is_set[j.a] ? 1 : -1, base = from == 0 ? 0 : x[from - 1];
            x[to - 1] = base + way * (coordinates[k] - j.offset);
            is_set[to] = more = true;
        }
    }
    free(is_set);
}

typedef struct Work {
    size_t m, n;
    double *x, *residual, *J, *A, *tau, *step;
    size_t *order;
} Work;

static bool work_start(Work *w, const YkMechanism *mech, size_t extra)
{
    w->m = 2 * mech->loop_count;
    w->n = yk_variable_count(mech);
    size_t rows = w->m + w->n + extra + 1;
    w->x = calloc(2 * w->n + 2 * rows + rows * (w->n + 1) * 2 + w->n + 8, sizeof *w->x);
    w->order = calloc(w->n + rows, sizeof *w->order);
    if (!w->x || !w->order) return false;
    w->residual = w->x + w->n;
    w->step = w->residual + 2 * rows;
    w->tau = w->step + w->n;
    w->J = w->tau + w->n + 1;
    w->A = w->J + rows * (w->n + 1);
    return true;
}

// One Levenberg step: least squares of [J; mu I] step = [-r; 0].
static void damped_step(Work *w, double mu)
{
    size_t rows = w->m + w->n;
    memset(w->A, 0, rows * w->n * sizeof *w->A);
    memcpy(w->A, w->J, w->m * w->n * sizeof *w->A);
    for (size_t j = 0; j < w->n; j++) w->A[(w->m + j) * w->n + j] = mu;
    double *b = w->residual + rows;
    for (size_t i = 0; i < rows; i++) b[i] = i < w->m ? -w->residual[i] : 0;
    size_t rank = yk_qr_factor(rows, w->n, w->A, w->order, w->tau, 1e-14);
    yk_qr_solve(rows, w->n, w->A, w->order, w->tau, rank, b, w->step);
}

static double length_of(const double *v, size_t n)
{
    double sum = 0;
    for (size_t k = 0; k < n; k++) sum += v[k] * v[k];
    return sqrt(sum);
}

static bool close_loops(Work *w, const YkMechanism *mech)
{
    double mu = 0.1 * mech->size, size = mech->size;
    yk_closure(mech, w->x, w->residual, w->J);
    double now = length_of(w->residual, w->m);
    for (int iteration = 0; iteration < 200 && now > 1e-13 * size; iteration++) {
        double *old = w->A + (w->m + w->n) * w->n; // spare room behind A
        damped_step(w, mu);
        memcpy(old, w->x, w->n * sizeof *old);
        for (size_t k = 0; k < w->n; k++) w->x[k] += w->step[k];
        yk_closure(mech, w->x, w->residual, w->J);
        double then = length_of(w->residual, w->m);
        if (then < now) {
            now = then;
            mu *= 0.2;
        } else {
            memcpy(w->x, old, w->n * sizeof *old);
            yk_closure(mech, w->x, w->residual, w->J);
            mu = mu * 5 + 1e-12 * size;
            if (mu > 1e8 * size) break;
        }
    }
    return now <= 1e-10 * size;
}

// The rank of the loops' Jacobian with the rows of `rows` coordinates below it. Distances are measured by the size.
static size_t rank_with(Work *w, const YkMechanism *mech, const int32_t *rows, size_t count)
{
    size_t o = mech->orientation_count - 1;
    memcpy(w->A, w->J, w->m * w->n * sizeof *w->A);
    memset(w->A + w->m * w->n, 0, count * w->n * sizeof *w->A);
    for (size_t r = 0; r < count; r++) {
        const YkTreeCoordinate *c = &mech->coordinates[rows[r]];
        double *row = w->A + (w->m + r) * w->n;
        YkJointAngle angle = yk_joint_angle(mech, c->joint);
        if (c->is_distance) {
            row[o + (size_t)c->distance] = 1;
        } else {
            if (angle.a > 0) row[angle.a - 1] -= mech->size;
            if (angle.b > 0) row[angle.b - 1] += mech->size;
        }
    }
    for (size_t i = 0; i < w->m + count; i++)
        for (size_t j = 0; j < o; j++) w->A[i * w->n + j] /= mech->size;
    return yk_qr_factor(w->m + count, w->n, w->A, w->order, w->tau, 1e-9);
}

static size_t accept(Work *w, const YkMechanism *mech, const int32_t *candidates, size_t count, bool *accepted, size_t rank, int32_t *rows)
{
    size_t taken = 0;
    for (size_t k = 0; k < count && rank + taken < w->n; k++) {
        rows[taken] = candidates[k];
        accepted[k] = rank_with(w, mech, rows, taken + 1) == rank + taken + 1;
        if (accepted[k]) taken++;
    }
    return taken;
}

int yk_closure_freedom(const YkMechanism *mech, const double *guess, const int32_t *candidates, size_t count, bool *accepted)
{
    Work w = {0};
    int freedom = -1;
    uint64_t seed = 20261121;
    int32_t *rows = calloc(count + 1, sizeof *rows);
    if (work_start(&w, mech, count) && rows) {
        size_t best = 0;
        for (int attempt = 0; attempt < 6; attempt++) {
            yk_closure_guess(mech, guess, w.x);
            for (size_t k = 0; attempt > 0 && k < w.n; k++) {
                seed = seed * 6364136223846793005u + 1442695040888963407u;
                double r = (double)(int64_t)seed * 0x1p-63, scale = k < mech->orientation_count - 1 ? 1 : mech->size;
                w.x[k] += (attempt < 3 ? 0.1 : 1.0) * scale * r;
            }
            if (!close_loops(&w, mech)) continue;
            size_t rank = rank_with(&w, mech, rows, 0);
            if (freedom >= 0 && rank <= best) continue;
            best = rank;
            freedom = (int)(w.n - rank);
            accept(&w, mech, candidates, count, accepted, rank, rows);
        }
    }
    free(rows);
    free(w.x);
    free(w.order);
    return freedom;
}
