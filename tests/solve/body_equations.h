// The truth of a machine that was drawn: its constraints in body coordinates (x, y, angle of each body) and their
// Jacobian, dense, with rank and least steps by orthogonalised rows. It shares nothing with the engine: neither loops
// nor a tree nor an order of solution.
#ifndef TESTS_SOLVE_BODY_EQUATIONS_H
#define TESTS_SOLVE_BODY_EQUATIONS_H
#include "overconstrained.h"

typedef struct Equations {
    const Drawn *drawn;
    int rows, columns;         // columns 3 (body - 1) + {0, 1, 2}
    double q[COLUMNS_MAX + 3]; // body 0 stands in front, at 0
    double residual[ROWS_MAX];
    double J[ROWS_MAX][COLUMNS_MAX];
    // after orthogonalise: the rows taken, the rows of Q, and L with J[taken] = L Q
    int rank, taken[ROWS_MAX];
    double Q[ROWS_MAX][COLUMNS_MAX], L[ROWS_MAX][COLUMNS_MAX];
    double least, most_left; // the least of the pivots taken, and the longest row left over
} Equations;

static inline void equations_start(Equations *e, const Drawn *d)
{
    e->drawn = d;
    e->columns = 3 * (d->bodies - 1);
    for (int b = 0; b < d->bodies; b++) {
        e->q[3 * b] = d->place[b].x;
        e->q[3 * b + 1] = d->place[b].y;
        e->q[3 * b + 2] = d->angle[b];
    }
}

static inline YkVec equations_arm(const Equations *e, int body, YkVec at)
{
    return yk_mul(yk_unit(e->q[3 * body + 2]), at);
}
static inline YkVec equations_point(const Equations *e, int body, YkVec at)
{
    return yk_add(yk_vec(e->q[3 * body], e->q[3 * body + 1]), equations_arm(e, body, at));
}

static inline void equations_entry(Equations *e, int row, int body, int part, double value)
{
    if (body > 0) e->J[row][3 * (body - 1) + part] += value;
}

static inline int equations_row(Equations *e, double residual)
{
    assert_true(e->rows < ROWS_MAX);
    memset(e->J[e->rows], 0, sizeof e->J[e->rows]);
    e->residual[e->rows] = residual;
    return e->rows++;
}

// (second point - first point) along a direction fixed in the world (turning = false) or in the first body.
static inline void equations_along(Equations *e, const Joint *j, YkVec u, bool turning)
{
    int a = j->body[0], b = j->body[1];
    YkVec off = yk_sub(equations_point(e, b, j->at[1]), equations_point(e, a, j->at[0]));
    YkVec arm_a = yk_quarter(equations_arm(e, a, j->at[0])), arm_b = yk_quarter(equations_arm(e, b, j->at[1]));
    int row = equations_row(e, yk_dot(u, off));
    equations_entry(e, row, b, 0, u.x);
    equations_entry(e, row, b, 1, u.y);
    equations_entry(e, row, b, 2, yk_dot(u, arm_b));
    equations_entry(e, row, a, 0, -u.x);
    equations_entry(e, row, a, 1, -u.y);
    equations_entry(e, row, a, 2, -yk_dot(u, arm_a) + (turning ? yk_dot(yk_quarter(u), off) : 0));
}

static inline void equations_turn(Equations *e, const Joint *j, double turned)
{
    int row = equations_row(e, e->q[3 * j->body[1] + 2] - e->q[3 * j->body[0] + 2] - turned);
    equations_entry(e, row, j->body[1], 2, 1);
    equations_entry(e, row, j->body[0], 2, -1);
}

static inline YkVec equations_line(const Equations *e, const Joint *j)
{
    return yk_unit(j->along + e->q[3 * j->body[0] + 2]);
}

static inline void equations_joint(Equations *e, const Joint *j)
{
    if (j->kind == PIN || j->kind == WELD) {
        equations_along(e, j, yk_vec(1, 0), false);
        equations_along(e, j, yk_vec(0, 1), false);
    } else {
        equations_along(e, j, yk_quarter(equations_line(e, j)), true);
    }
    if (j->kind == WELD || j->kind == SLIDE) equations_turn(e, j, j->turned);
}

static inline void equations_mesh(Equations *e, const Mesh *m)
{
    const double *angle = e->drawn->angle;
    double factor[3] = {m->teeth[0], m->teeth[1], -m->teeth[0] - m->teeth[1]}, size = m->teeth[0] + m->teeth[1];
    int body[3] = {m->body[0], m->body[1], m->carrier};
    double sum = 0;
    for (int k = 0; k < 3; k++) sum += factor[k] * (e->q[3 * body[k] + 2] - angle[body[k]]);
    int row = equations_row(e, sum / size);
    for (int k = 0; k < 3; k++) equations_entry(e, row, body[k], 2, factor[k] / size);
}

// All constraints at the pose q.
static inline void equations_evaluate(Equations *e)
{
    e->rows = 0;
    for (int j = 0; j < e->drawn->joints; j++) equations_joint(e, &e->drawn->joint[j]);
    for (int k = 0; k < e->drawn->meshes; k++) equations_mesh(e, &e->drawn->mesh[k]);
}

static inline double equations_miss(const Equations *e)
{
    double worst = 0;
    for (int r = 0; r < e->rows; r++) worst = fmax(worst, fabs(e->residual[r]));
    return worst;
}

// Takes rows, the one with most left over first, until at most `tolerance` is left of any or `most` are taken.
static inline void equations_orthogonalise(Equations *e, double tolerance, int most)
{
    static double left[ROWS_MAX][COLUMNS_MAX];
    int n = e->columns;
    bool is_taken[ROWS_MAX] = {false};
    memcpy(left, e->J, sizeof left[0] * (size_t)e->rows);
    memset(e->L, 0, sizeof e->L[0] * (size_t)e->rows);
    static double coefficient[ROWS_MAX][COLUMNS_MAX];
    e->rank = 0;
    e->least = INFINITY;
    for (;;) {
        int best = -1;
        double length = 0;
        for (int r = 0; r < e->rows; r++) {
            double sum = 0;
            for (int c = 0; c < n; c++) sum += left[r][c] * left[r][c];
            if (is_taken[r] || (best >= 0 && sum <= length)) continue;
            best = r;
            length = sum;
        }
        length = sqrt(length);
        e->most_left = best < 0 ? 0 : length;
        if (best < 0 || !(length > tolerance) || e->rank == most || e->rank == n) return;
        int k = e->rank++;
        e->least = fmin(e->least, length);
        is_taken[best] = true;
        e->taken[k] = best;
        for (int c = 0; c < n; c++) e->Q[k][c] = left[best][c] / length;
        for (int i = 0; i < k; i++) e->L[k][i] = coefficient[best][i];
        e->L[k][k] = length;
        for (int r = 0; r < e->rows; r++) {
            if (is_taken[r]) continue;
            coefficient[r][k] = 0;
            for (int twice = 0; twice < 2; twice++) {
                double sum = 0;
                for (int c = 0; c < n; c++) sum += left[r][c] * e->Q[k][c];
                for (int c = 0; c < n; c++) left[r][c] -= sum * e->Q[k][c];
                coefficient[r][k] += sum;
            }
        }
    }
}

// The shortest step that makes the rows taken as large as value[row].
static inline void equations_step(const Equations *e, const double *value, double *step)
{
    double y[ROWS_MAX];
    memset(step, 0, sizeof *step * (size_t)e->columns);
    for (int k = 0; k < e->rank; k++) {
        y[k] = value[e->taken[k]];
        for (int i = 0; i < k; i++) y[k] -= e->L[k][i] * y[i];
        y[k] /= e->L[k][k];
        for (int c = 0; c < e->columns; c++) step[c] += y[k] * e->Q[k][c];
    }
}

// Takes away from a motion what the constraints forbid.
static inline void equations_project(const Equations *e, double *motion)
{
    for (int k = 0; k < e->rank; k++) {
        double sum = 0;
        for (int c = 0; c < e->columns; c++) sum += motion[c] * e->Q[k][c];
        for (int c = 0; c < e->columns; c++) motion[c] -= sum * e->Q[k][c];
    }
}

#endif
