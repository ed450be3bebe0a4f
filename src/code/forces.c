#include "code/forces.h"
#include "base/problems.h"

enum { INPUTS_MAX = 40, STRAIGHT_MAX = 6 }; // more free inputs than the latter are solved with pivots, in a loop

static bool allocate(YkForces *f)
{
    YkProgram *p = f->program;
    size_t n = p->mech->input_count;
    f->motion = YK_NEW(p->arena, YkMotionRef, p->mech->coordinate_count + 1);
    f->column = YK_NEW(p->arena, YkRates, n + 1);
    f->load = YK_NEW(p->arena, YkWrenchRef, p->model->body_count);
    f->mass = YK_NEW(p->arena, YkRef, n * n + 1);
    f->rest = YK_NEW(p->arena, YkRef, n + 1);
    f->effort = YK_NEW(p->arena, YkRef, n + 1);
    f->acceleration = YK_NEW(p->arena, YkRef, n + 1);
    f->is_free = YK_NEW(p->arena, bool, n + 1);
    return !yk_arena_failed(p->arena);
}

static YkRef combine(YkProgram *p, YkRef sum, YkRef column, YkRef rate)
{
    return yk_dag_add(&p->graph, sum, yk_dag_multiply(&p->graph, column, rate));
}

// The columns, and the pose's velocities as their sum.
static void make_columns(YkForces *f)
{
    YkProgram *p = f->program;
    YkDag *g = &p->graph;
    size_t n = p->mech->input_count;
    YkRef *rate = YK_NEW(p->arena, YkRef, n + 1);
    if (!rate) {
        p->failed = true;
        return;
    }
    f->velocities = yk_program_new_rates(p);
    for (size_t i = 0; i < n; i++) {
        for (size_t k = 0; k < n; k++) rate[k] = yk_dag_number(g, k == i ? 1 : 0);
        f->column[i] = yk_program_velocities(p, rate);
    }
    yk_dag_section(g, "Velocities: what the Jacobian makes of the inputs' rates.");
    for (size_t i = 0; i < n && !p->failed; i++) {
        YkRef w = p->input[i].velocity;
        YkRates *v = &f->velocities, *c = &f->column[i];
        for (size_t k = 0; k < p->mech->slot_count; k++) v->turn[k] = combine(p, v->turn[k], c->turn[k], w);
        for (size_t k = 0; k < p->mech->distance_count; k++) v->slide[k] = combine(p, v->slide[k], c->slide[k], w);
        for (size_t k = 0; k < p->mech->node_count; k++)
            v->node[k] = yk_dag_vec_add(g, v->node[k], yk_dag_vec_scale(g, w, c->node[k]));
    }
}

// Rates of the laws' arguments, at the pose's velocities, for the second derivatives.
static void make_bias(YkForces *f)
{
    YkProgram *p = f->program;
    size_t n = p->mech->input_count;
    YkRef *rate = YK_NEW(p->arena, YkRef, n + 1);
    if (!rate) {
        p->failed = true;
        return;
    }
    for (size_t r = 0; r < p->mech->relation_count + p->mech->derived_count; r++)
        if (p->mech->relations[r].law) p->argument_rate[r] = yk_program_argument_rate(p, r, &f->velocities);
    for (size_t k = 0; k < n; k++) rate[k] = yk_dag_number(&p->graph, 0);
    f->bias = yk_program_accelerations(p, &f->velocities, rate);
}

static void make_motion(YkForces *f)
{
    YkProgram *p = f->program;
    for (size_t k = 0; k < p->mech->coordinate_count; k++) {
        int32_t input = p->mech->coordinates[k].input;
        f->motion[k].position = yk_program_coordinate(p, k);
        f->motion[k].velocity =
            input == YK_NONE ? yk_program_coordinate_rate(p, k, &f->velocities) : p->input[input].velocity;
    }
}

// Each body's part of M, h - Q and the kinetic energy.
static void add_body(YkForces *f, int32_t body)
{
    YkProgram *p = f->program;
    YkDag *g = &p->graph;
    size_t n = p->mech->input_count;
    const YkWrenchRef *load = &f->load[body];
    bool has_mass = p->model->bodies[body].has_mass;
    bool is_loaded = !yk_dag_is_zero_vec(g, load->force) || !yk_dag_is_number(g, load->moment, 0);
    if (!has_mass && !is_loaded) return;
    YkRefVec at = yk_forces_center(p, body);
    int32_t o = p->mech->bodies[body].orientation;
    YkRef m = has_mass ? yk_forces_mass(p, body) : yk_dag_number(g, 0);
    YkRef inertia = has_mass ? yk_forces_inertia(p, body) : m;
    YkRefVec bias = yk_program_at_accel(p, body, at, &f->velocities, &f->bias);
    YkRefVec force = yk_dag_vec_subtract(g, yk_dag_vec_scale(g, m, bias), load->force);
    YkRef moment = yk_dag_subtract(g, yk_dag_multiply(g, inertia, f->bias.turn[o]), load->moment);
    for (size_t i = 0; i < n; i++) {
        YkRefVec v = yk_program_at_rate(p, body, at, &f->column[i]);
        YkRef w = f->column[i].turn[o];
        YkRef part = yk_dag_add(g, yk_dag_dot(g, force, v), yk_dag_multiply(g, moment, w));
        f->rest[i] = yk_dag_add(g, f->rest[i], part);
        for (size_t j = 0; has_mass && j <= i; j++) {
            YkRefVec u = yk_program_at_rate(p, body, at, &f->column[j]);
            YkRef linear = yk_dag_multiply(g, m, yk_dag_dot(g, v, u));
            YkRef angular = yk_dag_multiply(g, inertia, yk_dag_multiply(g, w, f->column[j].turn[o]));
            f->mass[i * n + j] = yk_dag_add(g, f->mass[i * n + j], yk_dag_add(g, linear, angular));
        }
    }
}

static void make_equations(YkForces *f)
{
    YkProgram *p = f->program;
    YkDag *g = &p->graph;
    size_t n = p->mech->input_count;
    for (size_t k = 0; k < n * n; k++) f->mass[k] = yk_dag_number(g, 0);
    for (size_t k = 0; k < n; k++) f->rest[k] = yk_dag_number(g, 0);
    yk_dag_section(g, "Equations of motion: M q'' + rest = efforts, body by body.");
    for (size_t b = 1; b < p->model->body_count; b++) add_body(f, (int32_t)b);
    f->kinetic = yk_dag_number(g, 0);
    for (size_t i = 0; i < n; i++) {
        yk_dag_name(g, f->rest[i], "rest%d", (int)i + 1);
        for (size_t j = 0; j <= i; j++) {
            yk_dag_name(g, f->mass[i * n + j], "M%d%s%d", (int)i + 1, n > 9 ? "_" : "", (int)j + 1);
            f->mass[j * n + i] = f->mass[i * n + j];
            YkRef rates = yk_dag_multiply(g, p->input[i].velocity, p->input[j].velocity);
            YkRef half = yk_dag_number(g, i == j ? 0.5 : 1);
            f->kinetic =
                yk_dag_add(g, f->kinetic, yk_dag_multiply(g, half, yk_dag_multiply(g, f->mass[i * n + j], rates)));
        }
    }
}

static void make_efforts(YkForces *f)
{
    YkProgram *p = f->program;
    YkDag *g = &p->graph;
    size_t n = p->mech->input_count;
    yk_dag_section(g, "Efforts.");
    for (size_t i = 0; i < n; i++) {
        f->effort[i] = f->rest[i];
        for (size_t j = 0; j < n; j++)
            f->effort[i] = combine(p, f->effort[i], f->mass[i * n + j], p->input[j].acceleration);
    }
}

// Keeps what must be above 0: a pivot less its rounding.
static void keep_pivot(YkForces *f, YkRef pivot, YkRef whole)
{
    YkDag *g = &f->program->graph;
    YkRef rounding = yk_dag_multiply(g, yk_dag_number(g, 1e-14), whole);
    YkRef above = pivot == whole ? pivot : yk_dag_subtract(g, pivot, rounding);
    f->inertia = f->inertia < 0 ? above : yk_dag_binary(g, YK_VALUE_LEAST, f->inertia, above);
}

// Two by two: one division.
static void solve_pair(YkForces *f, const size_t *free, YkRef *b)
{
    YkProgram *p = f->program;
    YkDag *g = &p->graph;
    size_t n = p->mech->input_count;
    YkRef A = f->mass[free[0] * n + free[0]], B = f->mass[free[1] * n + free[0]], D = f->mass[free[1] * n + free[1]];
    YkRef whole = yk_dag_multiply(g, A, D);
    YkRef determinant = yk_dag_subtract(g, whole, yk_dag_multiply(g, B, B));
    YkRef over = yk_dag_divide(g, yk_dag_number(g, 1), determinant), first = b[0], second = b[1];
    keep_pivot(f, A, A);
    keep_pivot(f, determinant, whole);
    b[0] = yk_dag_subtract(g, yk_dag_multiply(g, D, first), yk_dag_multiply(g, B, second));
    b[1] = yk_dag_subtract(g, yk_dag_multiply(g, A, second), yk_dag_multiply(g, B, first));
    for (size_t k = 0; k < 2; k++) b[k] = yk_dag_multiply(g, b[k], over);
}

// M x = b for the free inputs by L D L^T, written out; every pivot must be above the rounding of its diagonal.
static void solve_straight(YkForces *f, const size_t *free, YkRef *b)
{
    YkProgram *p = f->program;
    YkDag *g = &p->graph;
    size_t n = p->mech->input_count, m = f->free_count;
    YkRef A[STRAIGHT_MAX][STRAIGHT_MAX], L[STRAIGHT_MAX][STRAIGHT_MAX], inverse[STRAIGHT_MAX];
    for (size_t i = 0; i < m; i++)
        for (size_t j = 0; j < m; j++) A[i][j] = f->mass[free[i] * n + free[j]];
    for (size_t k = 0; k < m; k++) {
        keep_pivot(f, A[k][k], f->mass[free[k] * n + free[k]]);
        inverse[k] = yk_dag_divide(g, yk_dag_number(g, 1), A[k][k]);
        for (size_t i = k + 1; i < m; i++) {
            L[i][k] = yk_dag_multiply(g, A[i][k], inverse[k]);
            for (size_t j = k + 1; j <= i; j++) {
                A[i][j] = yk_dag_subtract(g, A[i][j], yk_dag_multiply(g, L[i][k], A[j][k]));
                A[j][i] = A[i][j];
            }
        }
    }
    for (size_t k = 0; k < m; k++)
        for (size_t i = k + 1; i < m; i++) b[i] = yk_dag_subtract(g, b[i], yk_dag_multiply(g, L[i][k], b[k]));
    for (size_t k = m; k-- > 0;) {
        b[k] = yk_dag_multiply(g, b[k], inverse[k]);
        for (size_t i = k + 1; i < m; i++) b[k] = yk_dag_subtract(g, b[k], yk_dag_multiply(g, L[i][k], b[i]));
    }
}

static void solve_pivoted(YkForces *f, const size_t *free, YkRef *b)
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
    int32_t call = yk_dag_call(&p->graph, (YkCall){.kind = YK_CALL_SOLVE,
                                                   .n = (int32_t)m,
                                                   .m = 1,
                                                   .arguments = system,
                                                   .argument_count = m * (m + 1),
                                                   .result_count = m * (m + 1) + 1,
                                                   .name = "motion"});
    for (size_t i = 0; i < m; i++) b[i] = yk_dag_result(&p->graph, call, i * (m + 1) + m);
    YkRef size = yk_dag_unary(&p->graph, YK_VALUE_SIZE, yk_dag_result(&p->graph, call, m * (m + 1)));
    f->inertia = yk_dag_subtract(&p->graph, size, yk_dag_number(&p->graph, 1e-14));
}

static void make_accelerations(YkForces *f)
{
    YkProgram *p = f->program;
    YkDag *g = &p->graph;
    size_t n = p->mech->input_count, free[INPUTS_MAX];
    YkRef b[INPUTS_MAX];
    for (size_t i = 0; i < n; i++) {
        f->is_free[i] = p->mech->coordinates[p->mech->inputs[i]].drive == YK_NONE;
        f->acceleration[i] = p->input[i].acceleration;
        if (f->is_free[i]) free[f->free_count++] = i;
    }
    yk_dag_section(g, "Accelerations of the coordinates that are free.");
    f->inertia = -1;
    if (f->free_count == 0) return;
    for (size_t k = 0; k < f->free_count; k++) {
        const char *name = yk_program_name(p, p->mech->coordinates[p->mech->inputs[free[k]]].name);
        YkRef extra = yk_dag_leaf(g, YK_LEAF_POSE, yk_program_text(p, "in->%s_effort", name));
        b[k] = yk_dag_subtract(g, extra, f->rest[free[k]]);
        for (size_t j = 0; j < n; j++) {
            if (f->is_free[j]) continue;
            YkRef part = yk_dag_multiply(g, f->mass[free[k] * n + j], p->input[j].acceleration);
            b[k] = yk_dag_subtract(g, b[k], part);
        }
    }
    if (f->free_count == 2)
        solve_pair(f, free, b);
    else if (f->free_count <= STRAIGHT_MAX)
        solve_straight(f, free, b);
    else
        solve_pivoted(f, free, b);
    for (size_t k = 0; k < f->free_count; k++) f->acceleration[free[k]] = b[k];
}

bool yk_forces_build(YkForces *f, YkProgram *p)
{
    *f = (YkForces){.program = p};
    if (p->mech->input_count > INPUTS_MAX) {
        yk_problem(p->problems, YK_CODE_NOT_PRINTABLE, (YkPlace){0},
                   "the machine has %z freedoms; forces are printed for at most %d", p->mech->input_count,
                   (int)INPUTS_MAX);
        yk_problem_hint(p->problems, "`--kinematics` prints the motion alone");
        p->failed = true;
        return false;
    }
    if (!allocate(f)) return false;
    make_columns(f);
    if (p->failed) return false;
    make_motion(f);
    if (!yk_forces_loads(f)) return false;
    make_bias(f);
    make_equations(f);
    make_efforts(f);
    make_accelerations(f);
    return !p->failed;
}
