// The equations of motion of a tree by lumped constants: bodies on the same arm act as one mass on it.
//
// The centre of each body is a sum of arms from the ground, e_a u_a, some of them times a distance d_a; e_a is the unit
// vector of the arm's orientation, u_a the body's lever on it. With plane vectors as complex numbers the velocity is
// the sum of e_a u_a z_a, with z = d' + i d w (d = 1 if there is no distance), and so sum over bodies m conj(v_i) v_j =
// sum over arms conj(z_a,i) K_ab conj(e_a) e_b z_b,j, with K_ab = sum m conj(u_a) u_b.
// K depends only on parameters, and conj(e_a) e_b on the angles between the arms: for a double pendulum this is the
// form of the textbooks. With closed loops the sums would cancel near dead points, where bodies stand still at the end
// of arms that turn; there the bodies are taken one by one.
#include "program/forces.h"

enum { ARMS_MAX = 16 };

typedef struct Arm {
    int32_t slot, distance;
    YkRefVec own; // of the current body: u
    YkRefVec sum; // sum of m u
} Arm;

typedef struct Work {
    YkForces *f;
    Arm arms[ARMS_MAX];
    size_t count;
    YkRefVec K[ARMS_MAX][ARMS_MAX]; // for a <= b
    bool too_many;
} Work;

// --- the arms of a body

static Arm *arm_of(Work *w, int32_t slot, int32_t distance)
{
    for (size_t a = 0; a < w->count; a++)
        if (w->arms[a].slot == slot && w->arms[a].distance == distance) return &w->arms[a];
    if (w->count == ARMS_MAX) {
        w->too_many = true;
        return &w->arms[0];
    }
    YkRefVec none = yk_graph_vec_number(&w->f->program->graph, 0, 0);
    w->arms[w->count] = (Arm){slot, distance, none, none};
    return &w->arms[w->count++];
}

static void put(Work *w, int32_t slot, int32_t distance, YkRefVec u)
{
    Arm *arm = arm_of(w, slot, distance);
    if (slot == 0 && distance == YK_NONE) return; // stands still
    arm->own = yk_graph_vec_add(&w->f->program->graph, arm->own, u);
}

static void put_sum(Work *w, const YkSum *sum, double sign)
{
    YkProgram *p = w->f->program;
    const int32_t nodes[2] = {sum->plus, sum->minus};
    for (int k = 0; k < 2; k++)
        if (nodes[k] != YK_NONE) put_sum(w, &p->mech->node_sums[nodes[k]], k == 0 ? sign : -sign);
    for (uint32_t k = sum->first; k < sum->first + sum->count; k++) {
        const YkTerm *term = &p->mech->terms[k];
        YkRef factor = yk_graph_number(&p->graph, sign);
        YkRefVec u = yk_graph_vec_scale(&p->graph, factor, yk_program_term(p, k));
        put(w, term->slot, term->distance, u);
    }
}

// Adds a body to the constants.
static void lump(Work *w, int32_t body)
{
    YkProgram *p = w->f->program;
    YkGraph *g = &p->graph;
    const YkPlacing *placing = &p->mech->bodies[body];
    YkRef mass = yk_forces_mass(p, body);
    for (size_t a = 0; a < w->count; a++) w->arms[a].own = yk_graph_vec_number(g, 0, 0);
    put_sum(w, &placing->origin, 1);
    put(w, placing->orientation, YK_NONE, yk_graph_vec_multiply(g, p->turn_unit[body], yk_forces_center(p, body)));
    for (size_t b = 0; b < w->count && !w->too_many; b++) {
        YkRefVec heavy = yk_graph_vec_scale(g, mass, w->arms[b].own);
        w->arms[b].sum = yk_graph_vec_add(g, w->arms[b].sum, heavy);
        for (size_t a = 0; a <= b; a++) {
            YkRefVec part = yk_graph_vec_multiply(g, yk_graph_vec_conjugate(g, w->arms[a].own), heavy);
            w->K[a][b] = yk_graph_vec_add(g, w->K[a][b], part);
        }
    }
    size_t own = (size_t)(arm_of(w, placing->orientation, YK_NONE) - w->arms);
    w->K[own][own].x = yk_graph_add(g, w->K[own][own].x, yk_forces_inertia(p, body));
}

static void name_constants(Work *w)
{
    YkProgram *p = w->f->program;
    for (size_t b = 0; b < w->count; b++)
        for (size_t a = 0; a <= b; a++) {
            const char *second = yk_program_slot_name(p, w->arms[b].slot);
            if (w->arms[a].distance != YK_NONE || w->arms[b].distance != YK_NONE) continue;
            if (a == b)
                yk_graph_name(&p->graph, w->K[a][a].x, "inertia_%s", second);
            else
                yk_graph_name(&p->graph, w->K[a][b].x, "inertia_%s_%s", yk_program_slot_name(p, w->arms[a].slot),
                              second);
        }
}

// --- the present arms

static const YkStep *turn_of(const YkMechanism *mech, int32_t slot)
{
    for (size_t k = 0; k < mech->step_count; k++) {
        const YkStep *s = &mech->steps[k];
        if ((s->kind == YK_STEP_TURN || s->kind == YK_STEP_COMPOSE) && s->target == slot) return s;
    }
    return NULL;
}

static bool hangs_from(const YkMechanism *mech, int32_t slot, int32_t root)
{
    while (slot != root) {
        const YkStep *step = turn_of(mech, slot);
        if (!step) return false;
        slot = step->parent;
    }
    return true;
}

// Returns conj(e_root) e_slot for a slot attached to the root: the turns between them.
static YkRefVec turns_from(YkProgram *p, int32_t root, int32_t slot)
{
    if (slot == root) return yk_graph_vec_number(&p->graph, 1, 0);
    const YkStep *step = turn_of(p->mech, slot);
    YkRefVec own = step->kind == YK_STEP_COMPOSE ? p->unit[step->other] : yk_program_turn(p, step);
    return yk_graph_vec_multiply(&p->graph, turns_from(p, root, step->parent), own);
}

static YkRefVec between(YkProgram *p, int32_t a, int32_t b)
{
    YkGraph *g = &p->graph;
    if (hangs_from(p->mech, b, a)) return turns_from(p, a, b);
    if (hangs_from(p->mech, a, b)) return yk_graph_vec_conjugate(g, turns_from(p, b, a));
    return yk_graph_vec_multiply(g, yk_graph_vec_conjugate(g, p->unit[a]), p->unit[b]);
}

// Computes z = d' + i d w of each arm.
static void rates_of(const Work *w, const YkRates *r, YkRefVec *z)
{
    YkProgram *p = w->f->program;
    for (size_t a = 0; a < w->count; a++) {
        const Arm *arm = &w->arms[a];
        YkRef turn = r->turn[arm->slot];
        z[a] = arm->distance == YK_NONE ? (YkRefVec){yk_graph_number(&p->graph, 0), turn}
                                        : (YkRefVec){r->slide[arm->distance],
                                                     yk_graph_multiply(&p->graph, p->distance[arm->distance], turn)};
    }
}

// Computes z' + i w z = d'' - d w^2 + i (d w' + 2 d' w).
static void accelerations_of(const Work *w, const YkRates *r, const YkRates *s, YkRefVec *z)
{
    YkProgram *p = w->f->program;
    YkGraph *g = &p->graph;
    for (size_t a = 0; a < w->count; a++) {
        const Arm *arm = &w->arms[a];
        YkRef turn = r->turn[arm->slot], inward = yk_graph_minus(g, yk_graph_multiply(g, turn, turn));
        z[a] = (YkRefVec){inward, s->turn[arm->slot]};
        if (arm->distance == YK_NONE) continue;
        YkRef two = yk_graph_number(g, 2), speed = yk_graph_multiply(g, r->slide[arm->distance], turn),
              across = yk_graph_multiply(g, two, speed);
        z[a] = yk_graph_vec_scale(g, p->distance[arm->distance], z[a]);
        z[a] = yk_graph_vec_add(g, z[a], (YkRefVec){s->slide[arm->distance], across});
    }
}

// --- the equations

// Returns the sum over b of K_ab conj(e_a) e_b z_b.
static YkRefVec push_on(const Work *w, size_t a, const YkRefVec *z)
{
    YkProgram *p = w->f->program;
    YkGraph *g = &p->graph;
    YkRefVec sum = yk_graph_vec_number(g, 0, 0);
    for (size_t b = 0; b < w->count; b++) {
        YkRefVec K = a <= b ? w->K[a][b] : yk_graph_vec_conjugate(g, w->K[b][a]);
        if (yk_graph_is_zero_vec(g, K) || yk_graph_is_zero_vec(g, z[b])) continue;
        YkRefVec turned = yk_graph_vec_multiply(g, K, between(p, w->arms[a].slot, w->arms[b].slot));
        sum = yk_graph_vec_add(g, sum, yk_graph_vec_multiply(g, turned, z[b]));
    }
    return sum;
}

// Returns the weight on an arm, in its own axes: conj(e_a) conj(sum m u) gravity.
static YkRefVec weight_on(const Work *w, const Arm *arm)
{
    YkProgram *p = w->f->program;
    YkGraph *g = &p->graph;
    YkRefVec moment = yk_graph_vec_multiply(g, yk_graph_vec_conjugate(g, arm->sum), w->f->gravity);
    return yk_graph_vec_multiply(g, yk_graph_vec_conjugate(g, p->unit[arm->slot]), moment);
}

static void make_matrix(const Work *w, const YkRefVec *z, YkEquations *out)
{
    YkGraph *g = &w->f->program->graph;
    size_t n = w->f->program->mech->input_count;
    for (size_t j = 0; j < n; j++)
        for (size_t a = 0; a < w->count; a++) {
            YkRefVec push = push_on(w, a, z + j * w->count);
            for (size_t i = j; i < n; i++) {
                YkRef part = yk_graph_dot(g, z[i * w->count + a], push);
                out->mass[i * n + j] = yk_graph_add(g, out->mass[i * n + j], part);
            }
        }
}

static void make_rest(const Work *w, const YkRefVec *z, const YkRefVec *bias, YkEquations *out)
{
    YkGraph *g = &w->f->program->graph;
    size_t n = w->f->program->mech->input_count;
    for (size_t a = 0; a < w->count; a++) {
        YkRefVec push = push_on(w, a, bias);
        push = yk_graph_vec_subtract(g, push, weight_on(w, &w->arms[a]));
        for (size_t i = 0; i < n; i++)
            out->rest[i] = yk_graph_add(g, out->rest[i], yk_graph_dot(g, z[i * w->count + a], push));
    }
}

bool yk_forces_lumped(YkForces *f, YkEquations *out)
{
    YkProgram *p = f->program;
    size_t n = p->mech->input_count;
    Work *w = YK_NEW(p->arena, Work, 1);
    YkRefVec *z = YK_NEW(p->arena, YkRefVec, n * ARMS_MAX + 1), bias[ARMS_MAX];
    if (!w || !z) {
        p->failed = true;
        return false;
    }
    if (p->mech->block_count > 0 || p->mech->relation_count > 0) return false;
    w->f = f;
    for (size_t a = 0; a < ARMS_MAX; a++)
        for (size_t b = 0; b < ARMS_MAX; b++) w->K[a][b] = yk_graph_vec_number(&p->graph, 0, 0);
    for (size_t b = 1; b < p->model->body_count; b++) {
        if (!p->model->bodies[b].has_mass) return false; // it would only carry what is attached to it, which may cancel
        lump(w, (int32_t)b);
        if (w->too_many) return false;
    }
    name_constants(w);
    for (size_t i = 0; i < n; i++) rates_of(w, &f->column[i], z + i * w->count);
    accelerations_of(w, &f->velocities, &f->bias, bias);
    make_matrix(w, z, out);
    make_rest(w, z, bias, out);
    return true;
}
