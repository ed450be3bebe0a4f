// Forward dynamics: solves M q'' = efforts - rest for the free inputs.
#include "program/forces.h"

enum { STRAIGHT_MAX = 6 }; // more free inputs are solved in a loop

// Returns how large a pivot may be, relative to the terms that it is the sum of, and still be rounding alone.
static YkRef rounding(YkProgram *p)
{
    return yk_graph_number(&p->graph, p->is_single ? 5e-6 : 1e-14);
}

// Records what must be above 0: a pivot less its rounding.
static void keep_pivot(YkForces *f, YkRef pivot, YkRef terms)
{
    YkGraph *g = &f->program->graph;
    YkRef lost = yk_graph_multiply(g, rounding(f->program), terms);
    YkRef above = pivot == terms ? pivot : yk_graph_subtract(g, pivot, lost);
    f->inertia = f->inertia < 0 ? above : yk_graph_binary(g, YK_VALUE_LEAST, f->inertia, above);
}

// Solves two equations with one division.
static void solve_pair(YkForces *f, const size_t *free, YkRef *b)
{
    YkProgram *p = f->program;
    YkGraph *g = &p->graph;
    size_t n = p->mech->input_count;
    YkRef A = f->mass[free[0] * n + free[0]], B = f->mass[free[1] * n + free[0]], D = f->mass[free[1] * n + free[1]];
    YkRef whole = yk_graph_multiply(g, A, D);
    YkRef determinant = yk_graph_subtract(g, whole, yk_graph_multiply(g, B, B));
    YkRef over = yk_graph_inverse(g, determinant), first = b[0], second = b[1];
    keep_pivot(f, A, A);
    keep_pivot(f, determinant, whole);
    YkRef D_first = yk_graph_multiply(g, D, first), B_second = yk_graph_multiply(g, B, second),
          A_second = yk_graph_multiply(g, A, second), B_first = yk_graph_multiply(g, B, first);
    b[0] = yk_graph_subtract(g, D_first, B_second);
    b[1] = yk_graph_subtract(g, A_second, B_first);
    for (size_t k = 0; k < 2; k++) b[k] = yk_graph_multiply(g, b[k], over);
}

// Returns an estimate of the terms of the energy that pivot k is the sum of: those of the diagonal, for a unit of k and
// the answers of the coordinates before it. Small pivots make these answers large, and with them what rounding loses.
static YkRef terms_of(YkForces *f, const size_t *free, size_t k, YkRef L[STRAIGHT_MAX][STRAIGHT_MAX])
{
    YkGraph *g = &f->program->graph;
    size_t n = f->program->mech->input_count;
    YkRef answer[STRAIGHT_MAX], terms = f->mass[free[k] * n + free[k]];
    for (size_t i = k; i-- > 0;) {
        YkRef sum = L[k][i];
        for (size_t j = i + 1; j < k; j++) sum = yk_graph_subtract(g, sum, yk_graph_multiply(g, L[j][i], answer[j]));
        answer[i] = sum;
        YkRef square = yk_graph_multiply(g, sum, sum);
        terms = yk_graph_add(g, terms, yk_graph_multiply(g, square, f->mass[free[i] * n + free[i]]));
    }
    return terms;
}

// Solves M x = b for the free inputs by L D L^T, written out; every pivot must be above the rounding of its terms.
static void solve_straight(YkForces *f, const size_t *free, YkRef *b)
{
    YkProgram *p = f->program;
    YkGraph *g = &p->graph;
    size_t n = p->mech->input_count, m = f->free_count;
    YkRef A[STRAIGHT_MAX][STRAIGHT_MAX], L[STRAIGHT_MAX][STRAIGHT_MAX], inverse[STRAIGHT_MAX];
    for (size_t i = 0; i < m; i++)
        for (size_t j = 0; j < m; j++) A[i][j] = f->mass[free[i] * n + free[j]];
    for (size_t k = 0; k < m; k++) {
        keep_pivot(f, A[k][k], terms_of(f, free, k, L));
        inverse[k] = yk_graph_inverse(g, A[k][k]);
        for (size_t i = k + 1; i < m; i++) {
            L[i][k] = yk_graph_multiply(g, A[i][k], inverse[k]);
            for (size_t j = k + 1; j <= i; j++) {
                A[i][j] = yk_graph_subtract(g, A[i][j], yk_graph_multiply(g, L[i][k], A[j][k]));
                A[j][i] = A[i][j];
            }
        }
    }
    for (size_t k = 0; k < m; k++)
        for (size_t i = k + 1; i < m; i++) b[i] = yk_graph_subtract(g, b[i], yk_graph_multiply(g, L[i][k], b[k]));
    for (size_t k = m; k-- > 0;) {
        b[k] = yk_graph_multiply(g, b[k], inverse[k]);
        for (size_t i = k + 1; i < m; i++) b[k] = yk_graph_subtract(g, b[k], yk_graph_multiply(g, L[i][k], b[i]));
    }
}

static void solve_in_a_loop(YkForces *f, const size_t *free, YkRef *b)
{
    YkProgram *p = f->program;
    size_t n = p->mech->input_count, m = f->free_count;
    YkRef *system = YK_NEW(p->arena, YkRef, m * (m + 1));
    if (!system) {
        p->failed = true;
        return;
    }
    for (size_t i = 0; i < m; i++) {
        for (size_t j = 0; j < m; j++) system[i * (m + 1) + j] = f->mass[free[i] * n + free[j]];
        system[i * (m + 1) + m] = b[i];
    }
    int32_t call = yk_graph_call(&p->graph, (YkCall){.kind = YK_CALL_MOTION,
                                                     .n = (int32_t)m,
                                                     .arguments = system,
                                                     .argument_count = m * (m + 1),
                                                     .result_count = m * (m + 1) + 1,
                                                     .name = "motion"});
    for (size_t i = 0; i < m; i++) b[i] = yk_graph_result(&p->graph, call, i * (m + 1) + m);
    YkRef least = yk_graph_result(&p->graph, call, m * (m + 1));
    f->inertia = yk_graph_subtract(&p->graph, least, rounding(p));
}

static void solve(YkForces *f, const size_t *free, YkRef *b)
{
    if (f->free_count == 2)
        solve_pair(f, free, b);
    else if (f->free_count <= STRAIGHT_MAX)
        solve_straight(f, free, b);
    else
        solve_in_a_loop(f, free, b);
}

YkRef *yk_forces_response(YkForces *f, const YkRef *along)
{
    YkProgram *p = f->program;
    size_t n = p->mech->input_count, free[YK_FORCES_INPUTS_MAX] = {0}, count = 0;
    YkRef b[YK_FORCES_INPUTS_MAX], *response = YK_NEW(p->arena, YkRef, n + 1), inertia = f->inertia;
    if (!response) return NULL;
    for (size_t i = 0; i < n; i++) {
        response[i] = yk_graph_number(&p->graph, 0);
        if (!f->is_free[i]) continue;
        b[count] = along[i];
        free[count++] = i;
    }
    solve(f, free, b);
    f->inertia = inertia;
    for (size_t k = 0; k < count; k++) response[free[k]] = b[k];
    return response;
}

void yk_forces_accelerations(YkForces *f)
{
    YkProgram *p = f->program;
    YkGraph *g = &p->graph;
    size_t n = p->mech->input_count, free[YK_FORCES_INPUTS_MAX];
    YkRef b[YK_FORCES_INPUTS_MAX];
    for (size_t i = 0; i < n; i++) {
        f->is_free[i] = p->mech->coordinates[p->mech->inputs[i]].drive == YK_NONE;
        f->acceleration[i] = p->input[i].acceleration;
        if (f->is_free[i]) free[f->free_count++] = i;
    }
    yk_graph_section(g, "Accelerations of the coordinates that are free.");
    f->inertia = -1;
    if (f->free_count == 0) return;
    for (size_t k = 0; k < f->free_count; k++) {
        const char *name = p->names.coordinate[p->mech->inputs[free[k]]];
        YkRef extra = yk_graph_leaf(g, YK_LEAF_POSE, yk_graph_text(&p->graph, "in->%s_effort", name));
        b[k] = yk_graph_subtract(g, extra, f->rest[free[k]]);
        for (size_t j = 0; j < n; j++) {
            if (f->is_free[j]) continue;
            YkRef part = yk_graph_multiply(g, f->mass[free[k] * n + j], p->input[j].acceleration);
            b[k] = yk_graph_subtract(g, b[k], part);
        }
    }
    solve(f, free, b);
    for (size_t k = 0; k < f->free_count; k++) f->acceleration[free[k]] = b[k];
}
