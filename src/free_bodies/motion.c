// Forward dynamics of a part: finds the accelerations a of all its bodies together with what the joints and the
// prescribed inputs must exert: [M -A; A^T e] (a, f) = (load, bias), lengths over the size, forces over the size and
// the largest mass.
//
// e = 0 except for redundant parts: there A has dependent columns, and a small e keeps the system regular. Solving
// again for the residual of the constraints gives the accelerations of e = 0 (the method of multipliers: Hestenes
// 1969), which are unique; the reactions are then those of least norm.
#include <string.h>
#include "elementary/elementary.h"
#include "free_bodies/inside.h"

enum { ROUNDS_MAX = 12 };
static const double give = 1e-7; // e, unless it is 0
// To find a freedom without inertia: all bodies get a trace of the largest inertia, which has to exceed the rounding of
// the joints' resistance, 1 / e. Only that trace resists an acceleration beyond `enormous`.
static const double searching_give = 1e-4, trace = 1e-8, enormous = 1e5;

static bool is_constraint(const YkWrenchColumn *c, const bool *is_prescribed)
{
    return c->input == YK_NONE || is_prescribed[c->input];
}

static size_t constraint_count(const YkFreeBodies *f, const YkBodyPart *part, const bool *is_prescribed)
{
    size_t count = 0;
    for (size_t k = 0; k < part->column_count; k++)
        count += is_constraint(&f->columns[part->columns[k]], is_prescribed);
    return count;
}

static void emit_inertia(const YkFreeBodies *f, const YkBodyPart *part, YkBodySystem *s, double more)
{
    for (size_t k = 0; k < part->body_count; k++) {
        const YkBody *b = &f->mech->model->bodies[part->bodies[k]];
        double mass = b->has_mass ? b->mass / part->mass : 0;
        double inertia = b->has_mass ? b->inertia / (part->mass * f->size * f->size) : 0;
        for (size_t i = 0; i < 3; i++) yk_body_system_emit(s, 3 * k + i, 3 * k + i, (i < 2 ? mass : inertia) + more);
    }
}

static void emit_motion(const YkFreeBodies *f, const YkBodyPart *part, YkBodySystem *s, const bool *is_prescribed,
                        double e, double more)
{
    size_t at = 3 * part->body_count;
    emit_inertia(f, part, s, more);
    for (size_t k = 0; k < part->column_count; k++) {
        const YkWrenchColumn *c = &f->columns[part->columns[k]];
        if (!is_constraint(c, is_prescribed)) continue;
        yk_body_system_wrench(f, s, c, at, -1, false);
        yk_body_system_wrench(f, s, c, at, 1, true);
        if (e > 0) yk_body_system_emit(s, at, at, e);
        at++;
    }
}

static bool make_system(const YkFreeBodies *f, const YkBodyPart *part, YkBodySystem *s, const bool *is_prescribed,
                        double e)
{
    size_t n = constraint_count(f, part, is_prescribed), m = 3 * part->body_count;
    if (s->sparse) return true;
    if (!yk_body_system_start(s, m + n, m + (2 * YK_WRENCH_ENTRIES + 1) * n)) return false;
    emit_motion(f, part, s, is_prescribed, e, 0);
    return yk_body_system_finish(s);
}

// Sets the values and factors them; returns the smallest pivot, or -1 when out of memory.
static double factor(const YkFreeBodies *f, const YkBodyPart *part, YkBodySystem *s, const bool *is_prescribed,
                     double e, double more)
{
    if (!make_system(f, part, s, is_prescribed, e)) return -1;
    yk_body_system_begin(s);
    emit_motion(f, part, s, is_prescribed, e, more);
    return yk_sparse_factor(s->sparse, s->value, NULL);
}

static double unit_of(const YkFreeBodies *f, const YkWrenchColumn *c) // of the coordinate's acceleration
{
    return c->kind == YK_WRENCH_LINE ? f->size : 1;
}

// Writes the loads, and the accelerations that the constraints require, into f->b.
static void right_side(YkFreeBodies *f, const YkBodyPart *part, const bool *is_prescribed, const double *accelerations)
{
    size_t at = 3 * part->body_count;
    for (size_t k = 0; k < part->body_count; k++)
        for (size_t i = 0; i < 3; i++)
            f->b[3 * k + i] = f->load[3 * (size_t)part->bodies[k] + i] / (part->mass * f->size);
    for (size_t k = 0; k < part->column_count; k++) {
        const YkWrenchColumn *c = &f->columns[part->columns[k]];
        if (!is_constraint(c, is_prescribed)) continue;
        f->b[at++] = c->bias + (c->input == YK_NONE ? 0 : accelerations[c->input] / unit_of(f, c));
    }
}

// Solves for x = (a, f) with the right side f->b. Soft: until the constraints are met to rounding.
static void solve(YkFreeBodies *f, const YkBodySystem *s, size_t m, bool is_soft)
{
    double *x = f->x, *y = f->y, last = INFINITY;
    memset(y, 0, s->n * sizeof *y);
    for (int round = 0; round < ROUNDS_MAX; round++) {
        for (size_t i = 0; i < s->n; i++) x[i] = f->b[i] + (i < m ? 0 : give * y[i]);
        yk_sparse_solve(s->sparse, x, true);
        if (!is_soft) return;
        double change = 0;
        for (size_t i = m; i < s->n; i++) change = fmax(change, give * fabs(x[i] - y[i]));
        if (!(change < 0.5 * last)) return;
        last = change;
        memcpy(y, x, s->n * sizeof *y);
    }
}

static void keep(YkFreeBodies *f, const YkBodyPart *part, const bool *is_prescribed, double *accelerations)
{
    size_t at = 3 * part->body_count;
    for (size_t k = 0; k < part->body_count; k++)
        for (size_t i = 0; i < 3; i++) f->acceleration[3 * (size_t)part->bodies[k] + i] = f->x[3 * k + i] * f->size;
    for (size_t k = 0; k < part->column_count; k++) {
        YkWrenchColumn *c = &f->columns[part->columns[k]];
        if (is_constraint(c, is_prescribed))
            c->share = f->x[at++] * part->mass * f->size;
        else
            accelerations[c->input] = (yk_wrench_dot(f, c, f->x) - c->bias) * unit_of(f, c);
    }
}

// Finds the accelerations of bodies with a trace of inertia, under the load that moves them most: inverse iteration.
static void search_motion(YkFreeBodies *f, const YkBodySystem *s, size_t m)
{
    double *x = f->x;
    for (size_t i = 0; i < m; i++) x[i] = yk_cos((double)(3 * i + 1)); // any load
    for (int round = 0; round < 3; round++) {
        double sum = 0;
        for (size_t i = 0; i < m; i++) sum += x[i] * x[i];
        for (size_t i = 0; i < m; i++) x[i] /= sum > 0 ? sqrt(sum) : 1;
        memset(x + m, 0, (s->n - m) * sizeof *x);
        yk_sparse_solve(s->sparse, x, true);
    }
}

// Returns the input that accelerates most where only the trace of inertia resists; -1 if there is none.
static int find_culprit(YkFreeBodies *f, YkBodyPart *part, const bool *is_prescribed)
{
    double largest = enormous;
    int culprit = -1;
    if (!(factor(f, part, &part->soft, is_prescribed, searching_give, trace) > 0)) return -1;
    search_motion(f, &part->soft, 3 * part->body_count);
    for (size_t k = 0; k < part->column_count; k++) {
        const YkWrenchColumn *c = &f->columns[part->columns[k]];
        double a = fabs(yk_wrench_dot(f, c, f->x));
        if (is_constraint(c, is_prescribed) || !(a > largest)) continue;
        largest = a;
        culprit = c->input;
    }
    return culprit;
}

YkStatus yk_part_motion(YkFreeBodies *f, YkBodyPart *part, const bool *is_prescribed, double *accelerations,
                        int *culprit)
{
    bool is_soft = part->is_redundant;
    double pivot = factor(f, part, &part->motion, is_prescribed, is_soft ? give : 0, 0);
    if (pivot < 0) return YK_NO_MEMORY;
    if (!(pivot > YK_PIVOT_TOLERANCE)) {
        if (*culprit < 0) *culprit = find_culprit(f, part, is_prescribed);
        return YK_SINGULAR;
    }
    right_side(f, part, is_prescribed, accelerations);
    solve(f, &part->motion, 3 * part->body_count, is_soft);
    keep(f, part, is_prescribed, accelerations);
    return is_soft ? YK_REDUNDANT : YK_OK;
}
