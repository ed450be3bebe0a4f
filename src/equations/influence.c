// Carries influence coefficients outwards at a pose, sums over the bodies, and solves for the accelerations.
#include "equations/influence.h"
#include "equations/gradient_pose.h"
#include "equations/tree_noise.h"

// --- outwards: R

static inline YkVec column_of(const YkSpace *space, const YkInfluenceTerm *term)
{
    return yk_quarter(yk_turned_by(space->data + term->turn, term->v));
}

static void carry_pair(YkInfluence *f, const YkSpace *space, const YkInfluenceCarry *carry)
{
    size_t n = f->width;
    const YkInfluenceTerm *term = f->terms + carry->first_term;
    YkVec c0 = column_of(space, &term[0]), c1 = column_of(space, &term[1]), sum[YK_INFLUENCE_MAX];
    for (size_t i = 0; i < n; i++) sum[i] = yk_vec(0, 0);
    for (uint32_t k = 2; k < carry->term_count; k++) {
        YkVec c = column_of(space, &term[k]);
        for (size_t i = 0; i < n; i++) sum[i] = yk_add(sum[i], yk_scale(f->R[(size_t)term[k].unknown + i], c));
    }
    double over = -1 / yk_cross(c0, c1);
    for (size_t i = 0; i < n; i++) {
        f->R[(size_t)term[0].unknown + i] = over * yk_cross(sum[i], c1);
        f->R[(size_t)term[1].unknown + i] = over * yk_cross(c0, sum[i]);
    }
}

static bool carry_other(YkInfluence *f, const YkSpace *space, const YkInfluenceCarry *carry)
{
    size_t n = f->width;
    const YkOperation *op = &f->e->operations[carry->operation];
    const int32_t *unknown = f->e->index + op->first_index, *given = unknown + op->own;
    if (!yk_coefficients_find(&f->work, space, op, f->C)) return false;
    for (uint32_t u = 0; u < op->own; u++)
        for (size_t i = 0; i < n; i++) {
            double sum = 0;
            for (uint32_t k = 0; k < op->given; k++) sum += f->C[u * op->given + k] * f->R[(size_t)given[k] * n + i];
            f->R[(size_t)unknown[u] * n + i] = sum;
        }
    return true;
}

static bool carry_all(YkInfluence *f, const YkSpace *space)
{
    for (size_t k = 0; k < f->carry_count; k++) {
        const YkInfluenceCarry *carry = &f->carries[k];
        if (carry->term_count > 0)
            carry_pair(f, space, carry);
        else if (!carry_other(f, space, carry))
            return false;
    }
    return true;
}

// --- over the bodies

typedef struct Sums {
    double M[YK_INFLUENCE_MAX][YK_INFLUENCE_MAX]; // upper triangle
    double g[YK_INFLUENCE_MAX];
} Sums;

// The input of the sums: n columns of R; or, when moving, the rates in the pose as the only column.
typedef struct Look {
    const YkInfluence *f;
    const YkSpace *space;
    const YkLoad *loads;
    const bool *is_loaded; // per body, with loads
    YkVec gravity;
    bool has_weight;
    bool moving;
    size_t n;
} Look;

static inline const double *influence_of(const Look *look, int32_t turn, int32_t unknown)
{
    return look->moving ? look->space->data + turn + 2 : look->f->R + unknown;
}

// Returns whether weight or loads act on a body.
static inline bool is_pushed(const Look *look, int32_t body)
{
    return look->has_weight || (look->loads && look->is_loaded[body]);
}

// Returns the load on a body besides inertia: weight and loads.
static inline YkLoad push_on(const Look *look, double mass, int32_t body)
{
    YkLoad push = {yk_scale(mass, look->gravity), 0};
    if (!look->loads) return push;
    const YkLoad *load = &look->loads[body];
    return (YkLoad){yk_add(push.force, load->force), load->moment};
}

// Adds a body that turns about a fixed point: one inertia, and the moments about that point.
static inline void add_pivoted(const Look *look, const YkPivotedBody *b, Sums *sums)
{
    const YkInfluenceTerm *term = &b->term;
    const double *t = look->space->data + term->turn, *R = influence_of(look, term->turn, term->unknown);
    double moment = -b->about * t[3];
    if (is_pushed(look, b->body)) {
        YkLoad push = push_on(look, b->mass, b->body);
        moment += yk_cross(yk_turned_by(t, term->v), push.force) + (b->turns ? push.moment : 0);
    }
    for (size_t i = 0; i < look->n; i++) {
        sums->g[i] += R[i] * moment;
        for (size_t j = i; j < look->n; j++) sums->M[i][j] += b->about * R[i] * R[j];
    }
}

// Adds a body of two turning vectors u, w: their inertias, and m u.w between them; the centripetal parts act across, by
// m (u x w).
static inline void add_carried(const Look *look, const YkCarriedBody *b, Sums *sums)
{
    const YkInfluenceTerm *term = b->term;
    const double *t0 = look->space->data + term[0].turn, *t1 = look->space->data + term[1].turn;
    const double *R0 = influence_of(look, term[0].turn, term[0].unknown);
    const double *R1 = influence_of(look, term[1].turn, term[1].unknown);
    YkVec u = yk_turned_by(t0, term[0].v), w = yk_turned_by(t1, term[1].v);
    double between = b->mass * yk_dot(u, w), across = b->mass * yk_cross(u, w);
    double moment0 = across * t1[2] * t1[2] - between * t1[3] - b->about[0] * t0[3];
    double moment1 = -across * t0[2] * t0[2] - between * t0[3] - b->about[1] * t1[3];
    if (is_pushed(look, b->body)) {
        YkLoad push = push_on(look, b->mass, b->body);
        moment0 += yk_cross(u, push.force) + (b->own == 0 ? push.moment : 0);
        moment1 += yk_cross(w, push.force) + (b->own == 1 ? push.moment : 0);
    }
    for (size_t i = 0; i < look->n; i++) {
        double p0 = b->about[0] * R0[i] + between * R1[i], p1 = b->about[1] * R1[i] + between * R0[i];
        sums->g[i] += R0[i] * moment0 + R1[i] * moment1;
        for (size_t j = i; j < look->n; j++) sums->M[i][j] += p0 * R0[j] + p1 * R1[j];
    }
}

// Returns the rate of an unknown in the pose.
static double rate_of(const Look *look, int32_t unknown)
{
    const YkMechanism *mech = look->f->e->mech;
    int32_t first_distance = yk_unknown_of_distance(mech, 0), first_node = yk_unknown_of_node(mech, 0);
    if (unknown < first_distance) return yk_turn_at(look->space, unknown)[2];
    if (unknown < first_node) return yk_space_slide(look->space, unknown - first_distance).v[0];
    YkPlane node = yk_space_plane(look->space, (unknown - first_node) / 2);
    return (unknown - first_node) % 2 == 0 ? node.vx[0] : node.vy[0];
}

static void add_other(const Look *look, const YkOtherBody *b, Sums *sums)
{
    const YkInfluence *f = look->f;
    const YkElement *element = &f->e->elements[b->element];
    const int32_t *unknown = f->e->index + element->first_index;
    YkVec *c = f->work.column, J[YK_INFLUENCE_MAX];
    YkVec a = yk_gradient_acceleration(f->e, look->space, &element->gradient, c);
    YkLoad push = push_on(look, b->mass, b->body);
    YkVec force = yk_sub(push.force, yk_scale(b->mass, a));
    const double none[YK_INFLUENCE_MAX] = {0}, *R = none;
    double moment = 0;
    if (b->rotation != YK_NONE) {
        moment = push.moment - b->inertia * look->space->data[b->turn + 3];
        R = influence_of(look, b->turn, b->rotation);
    }
    for (size_t i = 0; i < look->n; i++) {
        J[i] = yk_vec(0, 0);
        for (uint32_t k = 0; k < element->gradient.columns; k++) {
            double r = look->moving ? rate_of(look, unknown[k]) : f->R[(size_t)unknown[k] * look->n + i];
            J[i] = yk_add(J[i], yk_scale(r, c[k]));
        }
    }
    for (size_t i = 0; i < look->n; i++) {
        sums->g[i] += yk_dot(J[i], force) + R[i] * moment;
        for (size_t j = i; j < look->n; j++) sums->M[i][j] += b->mass * yk_dot(J[i], J[j]) + b->inertia * R[i] * R[j];
    }
}

// Sums up over all bodies. The compiler knows `moving` and the width in each case below: no loops over one column are
// left.
static inline void sum_up(const Look *of, bool moving, size_t n, Sums *total)
{
    Look look = *of;
    look.moving = moving;
    look.n = n;
    Sums sums = {.g = {0}};
    const YkInfluence *f = look.f;
    for (size_t k = 0; k < f->carried_count; k++) add_carried(&look, &f->carried[k], &sums);
    for (size_t k = 0; k < f->pivoted_count; k++) add_pivoted(&look, &f->pivoted[k], &sums);
    for (size_t k = 0; k < f->other_count; k++) add_other(&look, &f->others[k], &sums);
    *total = sums;
}

static void sum_moving(const Look *look, Sums *sums)
{
    sum_up(look, true, 1, sums);
}
static void sum_one(const Look *look, Sums *sums)
{
    sum_up(look, false, 1, sums);
}
static void sum_two(const Look *look, Sums *sums)
{
    sum_up(look, false, 2, sums);
}
static void sum_four(const Look *look, Sums *sums)
{
    sum_up(look, false, 4, sums);
}

// --- the accelerations

// Solves M x = g for x in g, the last free input first as in the elimination; returns the input without inertia, or -1.
static int solve(const YkInfluence *f, Sums *s)
{
    size_t n = f->free_count;
    double N[YK_INFLUENCE_MAX][YK_INFLUENCE_MAX] = {{0}}; // the noise of M: see tree_noise.h
    for (size_t i = 0; i < n; i++) N[i][i] = s->M[i][i];
    for (size_t p = n; p-- > 0;) {
        double h = s->M[p][p], k[YK_INFLUENCE_MAX];
        if (!(h > YK_LEAST_OVER_NOISE * N[p][p]) || !(h > 0)) return f->input[p];
        for (size_t i = 0; i < p; i++) k[i] = s->M[i][p] / h;
        for (size_t i = 0; i < p; i++) {
            s->g[i] -= k[i] * s->g[p];
            N[i][i] += s->M[i][i];
            for (size_t j = i; j < p; j++) {
                N[i][j] += k[i] * (N[p][p] * k[j] - N[j][p]) - k[j] * N[i][p];
                s->M[i][j] -= k[i] * s->M[j][p];
            }
        }
    }
    for (size_t p = 0; p < n; p++) {
        for (size_t i = 0; i < p; i++) s->g[p] -= s->M[i][p] * s->g[i];
        s->g[p] /= s->M[p][p];
    }
    return -1;
}

// Solves for one moving input: twice the kinetic energy is M rate^2, the power g rate.
static int accelerate_moving(const Look *look, double rate, double *acceleration)
{
    Sums sums;
    sum_moving(look, &sums);
    if (!(sums.M[0][0] > 0)) return look->f->input[0];
    acceleration[look->f->input[0]] = rate * (sums.g[0] / sums.M[0][0]);
    return -1;
}

int yk_influence_accelerate(YkInfluence *f, const YkState *state, const YkLoad *loads, const bool *is_loaded,
                            double *acceleration)
{
    static const double LEAST_RATE = 1e-60; // its square is still a number
    void (*const ways[])(const Look *, Sums *) = {NULL, sum_one, sum_two, NULL, sum_four};
    const YkElimination *e = f->e;
    Sums sums;
    YkVec gravity = e->mech->model->gravity;
    Look look = {.f = f, .space = &state->space, .loads = loads, .is_loaded = is_loaded, .gravity = gravity};
    look.has_weight = gravity.x != 0 || gravity.y != 0;
    bool may_move = e->mech->input_count == 1 && fabs(state->input[1]) > LEAST_RATE;
    if (may_move) return accelerate_moving(&look, state->input[1], acceleration);
    if (!carry_all(f, look.space)) return -2;
    ways[f->width](&look, &sums);
    int bad = solve(f, &sums);
    if (bad != -1) return bad;
    for (size_t i = 0; i < f->free_count; i++) {
        int32_t parent = e->parent_of_input[f->input[i]];
        double own = sums.g[i];
        for (size_t j = 0; parent > 0 && j < f->free_count; j++) own -= f->R[(size_t)parent * f->width + j] * sums.g[j];
        acceleration[f->input[i]] = e->sign_of_input[f->input[i]] * own;
    }
    return -1;
}
