#include "dynamics/influence.h"
#include <stdlib.h>
#include <string.h>
#include "dynamics/gradient_pose.h"

// --- making
// -----------------------------------------------------------------------------------------------------------------

static void put_terms(YkInfluence *f, const YkGradient *gradient, uint32_t first_index)
{
    for (uint32_t k = 0; k < gradient->columns; k++) {
        const YkGradientPiece *piece = &f->e->pieces[gradient->first_piece + k];
        int32_t unknown = f->e->index[first_index + k] * (int32_t)f->width;
        f->terms[f->term_count++] = (YkInfluenceTerm){4 * piece->unit, unknown, piece->v, 0};
    }
}

static void put_operation(YkInfluence *f, size_t p, size_t *freed)
{
    const YkOperation *op = &f->e->operations[p];
    YkInfluenceMove move = {YK_CARRY_OTHER, (uint32_t)p, (uint32_t)f->term_count, op->gradient.columns};
    if (op->kind == YK_OP_KNOWN) return; // R stays 0
    if (op->kind == YK_OP_FREE) {
        f->input[*freed] = op->input;
        f->unknown[*freed] = f->e->index[op->first_index];
        f->R[(size_t)f->unknown[*freed] * f->width + *freed] = 1; // and stays so
        (*freed)++;
        return;
    }
    if (op->kind == YK_OP_PAIR && op->gradient.is_plain) {
        move.kind = YK_CARRY_PAIR;
        put_terms(f, &op->gradient, op->first_index);
    }
    f->moves[f->move_count++] = move;
}

static void put_element(YkInfluence *f, size_t index)
{
    const YkElement *element = &f->e->elements[index];
    uint32_t columns = element->gradient.columns;
    YkInfluenceMove move = {YK_ADD_OTHER, (uint32_t)index, (uint32_t)f->term_count, columns};
    YkInfluenceBody *b = &f->bodies[index];
    *b = (YkInfluenceBody){element->mass, element->inertia, element->body, YK_NONE, YK_NONE};
    if (element->rotation != YK_NONE) {
        b->turn = 4 * f->e->mech->bodies[element->body].orientation;
        b->rotation = f->e->index[element->first_index + (uint32_t)element->rotation] * (int32_t)f->width;
    }
    if (element->gradient.is_plain && columns <= 2) {
        move.kind = columns == 1 ? YK_ADD_PIVOTED : YK_ADD_CARRIED;
        put_terms(f, &element->gradient, element->first_index);
        for (uint32_t k = 0; k < columns; k++) {
            YkInfluenceTerm *term = &f->terms[move.first_term + k];
            term->inertia = b->mass * yk_dot(term->v, term->v) + (term->unknown == b->rotation ? b->inertia : 0);
        }
    }
    f->moves[f->move_count++] = move;
}

static void put_moves(YkInfluence *f)
{
    size_t freed = 0;
    for (size_t p = 0; p < f->e->operation_count; p++) {
        const YkOperation *op = &f->e->operations[p];
        put_operation(f, p, &freed);
        for (uint32_t k = 0; k < op->element_count; k++) put_element(f, op->first_element + k);
    }
}

YkInfluence *yk_influence_new(const YkElimination *e, size_t free_count)
{
    YkInfluence *f = calloc(1, sizeof *f);
    if (!f) return NULL;
    size_t most = 1; // coefficients of any operation
    for (size_t p = 0; p < e->operation_count; p++) {
        size_t count = (size_t)e->operations[p].own * e->operations[p].given;
        if (count > most) most = count;
    }
    f->e = e;
    f->free_count = free_count;
    f->width = free_count > 2 ? 4 : free_count;
    f->gravity = e->mech->model->gravity;
    f->has_gravity = f->gravity.x != 0 || f->gravity.y != 0;
    f->moves = calloc(e->operation_count + e->element_count + 1, sizeof *f->moves);
    f->terms = calloc(e->piece_count + 1, sizeof *f->terms);
    f->bodies = calloc(e->element_count + 1, sizeof *f->bodies);
    f->R = calloc(e->unknown_count * f->width + 1, sizeof *f->R);
    f->C = calloc(most, sizeof *f->C);
    if (!f->moves || !f->terms || !f->bodies || !f->R || !f->C || !yk_coefficients_start(&f->work, e)) {
        yk_influence_free(f);
        return NULL;
    }
    put_moves(f);
    return f;
}

void yk_influence_free(YkInfluence *f)
{
    if (!f) return;
    yk_coefficients_end(&f->work);
    free(f->moves);
    free(f->terms);
    free(f->bodies);
    free(f->R);
    free(f->C);
    free(f);
}

// --- outwards
// ---------------------------------------------------------------------------------------------------------------

static inline YkVec column_of(const YkSpace *space, const YkInfluenceTerm *term)
{
    return yk_quarter(yk_turned_by(space->data + term->turn, term->v));
}

// R of a dyad's two unknowns: c0 R0 + c1 R1 + the given columns' share = 0.
static inline void carry_pair(YkInfluence *f, const YkSpace *space, const YkInfluenceMove *move, size_t n)
{
    const YkInfluenceTerm *term = f->terms + move->first_term;
    YkVec c0 = column_of(space, &term[0]), c1 = column_of(space, &term[1]), sum[YK_INFLUENCE_MAX];
    for (size_t i = 0; i < n; i++) sum[i] = yk_vec(0, 0);
    for (uint32_t k = 2; k < move->term_count; k++) {
        YkVec c = column_of(space, &term[k]);
        for (size_t i = 0; i < n; i++) sum[i] = yk_add(sum[i], yk_scale(f->R[(size_t)term[k].unknown + i], c));
    }
    double over = -1 / yk_cross(c0, c1);
    for (size_t i = 0; i < n; i++) {
        f->R[(size_t)term[0].unknown + i] = over * yk_cross(sum[i], c1);
        f->R[(size_t)term[1].unknown + i] = over * yk_cross(c0, sum[i]);
    }
}

static bool carry_other(YkInfluence *f, const YkSpace *space, const YkInfluenceMove *move, size_t n)
{
    const YkOperation *op = &f->e->operations[move->index];
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

// --- bodies
// -----------------------------------------------------------------------------------------------------------------

typedef struct Sums {
    double M[YK_INFLUENCE_MAX][YK_INFLUENCE_MAX]; // upper triangle
    double g[YK_INFLUENCE_MAX];
} Sums;

// What acts on a body besides inertia: weight and loads.
typedef struct Push {
    YkVec force;
    double moment;
} Push;

static inline Push push_of(const YkInfluence *f, const YkLoad *loads, const YkInfluenceBody *b)
{
    Push push = {yk_scale(b->mass, f->gravity), 0};
    if (!loads) return push;
    return (Push){yk_add(push.force, loads[b->body].force), loads[b->body].moment};
}

// It turns about a fixed point: one inertia, and the moments about that point.
static inline void add_pivoted(const YkInfluence *f, const YkSpace *space, const YkLoad *loads,
                               const YkInfluenceMove *move, Sums *sums, size_t n)
{
    const YkInfluenceTerm *term = f->terms + move->first_term;
    const YkInfluenceBody *b = &f->bodies[move->index];
    const double *t = space->data + term->turn, *R = f->R + term->unknown;
    double moment = -term->inertia * t[3];
    if (f->has_gravity || loads) {
        Push push = push_of(f, loads, b);
        moment += yk_cross(yk_turned_by(t, term->v), push.force) + (b->rotation == YK_NONE ? 0 : push.moment);
    }
    for (size_t i = 0; i < n; i++) {
        sums->g[i] += R[i] * moment;
        for (size_t j = i; j < n; j++) sums->M[i][j] += term->inertia * R[i] * R[j];
    }
}

// Two vectors u, w turn: their inertias, and m u.w between them; the centripetal parts act across, by m (u x w).
static inline void add_carried(const YkInfluence *f, const YkSpace *space, const YkLoad *loads,
                               const YkInfluenceMove *move, Sums *sums, size_t n)
{
    const YkInfluenceTerm *term = f->terms + move->first_term;
    const YkInfluenceBody *b = &f->bodies[move->index];
    const double *t0 = space->data + term[0].turn, *t1 = space->data + term[1].turn;
    const double *R0 = f->R + term[0].unknown, *R1 = f->R + term[1].unknown;
    YkVec u = yk_turned_by(t0, term[0].v), w = yk_turned_by(t1, term[1].v);
    double D0 = term[0].inertia, D1 = term[1].inertia;
    double between = b->mass * yk_dot(u, w), across = b->mass * yk_cross(u, w);
    double moment0 = across * t1[2] * t1[2] - between * t1[3] - D0 * t0[3];
    double moment1 = -across * t0[2] * t0[2] - between * t0[3] - D1 * t1[3];
    if (f->has_gravity || loads) {
        Push push = push_of(f, loads, b);
        moment0 += yk_cross(u, push.force) + (b->rotation == term[0].unknown ? push.moment : 0);
        moment1 += yk_cross(w, push.force) + (b->rotation == term[1].unknown ? push.moment : 0);
    }
    for (size_t i = 0; i < n; i++) {
        double p0 = D0 * R0[i] + between * R1[i], p1 = D1 * R1[i] + between * R0[i];
        sums->g[i] += R0[i] * moment0 + R1[i] * moment1;
        for (size_t j = i; j < n; j++) sums->M[i][j] += p0 * R0[j] + p1 * R1[j];
    }
}

static inline void add_other(const YkInfluence *f, const YkSpace *space, const YkLoad *loads,
                             const YkInfluenceMove *move, Sums *sums, size_t n)
{
    const YkElement *element = &f->e->elements[move->index];
    const YkInfluenceBody *b = &f->bodies[move->index];
    const int32_t *unknown = f->e->index + element->first_index;
    YkVec *c = f->work.column, a = yk_gradient_acceleration(f->e, space, &element->gradient, c), J[YK_INFLUENCE_MAX];
    Push push = push_of(f, loads, b);
    YkVec force = yk_sub(push.force, yk_scale(b->mass, a));
    double moment = b->turn == YK_NONE ? 0 : push.moment - b->inertia * space->data[b->turn + 3];
    for (size_t i = 0; i < n; i++) {
        J[i] = yk_vec(0, 0);
        for (uint32_t k = 0; k < element->gradient.columns; k++)
            J[i] = yk_add(J[i], yk_scale(f->R[(size_t)unknown[k] * n + i], c[k]));
    }
    for (size_t i = 0; i < n; i++) {
        double turn = b->rotation == YK_NONE ? 0 : f->R[(size_t)b->rotation + i];
        sums->g[i] += yk_dot(J[i], force) + turn * moment;
        for (size_t j = i; j < n; j++)
            sums->M[i][j] += b->mass * yk_dot(J[i], J[j]) +
                             (b->rotation == YK_NONE ? 0 : b->inertia * turn * f->R[(size_t)b->rotation + j]);
    }
}

// --- inwards
// ----------------------------------------------------------------------------------------------------------------

// Solves M x = g for x in g, the last free input first as in the elimination; returns the input without inertia, or -1.
static int solve(const YkInfluence *f, Sums *s)
{
    size_t n = f->free_count;
    double size[YK_INFLUENCE_MAX];
    for (size_t i = 0; i < n; i++) size[i] = s->M[i][i];
    for (size_t p = n; p-- > 0;) {
        double h = s->M[p][p];
        if (!(h > 1e-13 * size[p]) || !(h > 0)) return f->input[p];
        for (size_t i = 0; i < p; i++) {
            double k = s->M[i][p] / h;
            s->g[i] -= k * s->g[p];
            for (size_t j = i; j < p; j++) s->M[i][j] -= k * s->M[j][p];
        }
    }
    for (size_t p = 0; p < n; p++) {
        for (size_t i = 0; i < p; i++) s->g[p] -= s->M[i][p] * s->g[i];
        s->g[p] /= s->M[p][p];
    }
    return -1;
}

// All moves; the width n is known to the compiler.
static inline bool sum_up(YkInfluence *f, const YkSpace *space, const YkLoad *loads, Sums *total, size_t n)
{
    Sums sums = {.g = {0}};
    for (const YkInfluenceMove *move = f->moves, *end = move + f->move_count; move < end; move++) switch (move->kind) {
        case YK_CARRY_PAIR:
            carry_pair(f, space, move, n);
            break;
        case YK_CARRY_OTHER:
            if (!carry_other(f, space, move, n)) return false;
            break;
        case YK_ADD_PIVOTED:
            add_pivoted(f, space, loads, move, &sums, n);
            break;
        case YK_ADD_CARRIED:
            add_carried(f, space, loads, move, &sums, n);
            break;
        case YK_ADD_OTHER:
            add_other(f, space, loads, move, &sums, n);
            break;
        }
    *total = sums;
    return true;
}

static bool sum_up_for_one(YkInfluence *f, const YkSpace *space, const YkLoad *loads, Sums *sums)
{
    return sum_up(f, space, loads, sums, 1);
}

static bool sum_up_for_two(YkInfluence *f, const YkSpace *space, const YkLoad *loads, Sums *sums)
{
    return sum_up(f, space, loads, sums, 2);
}

static bool sum_up_for_four(YkInfluence *f, const YkSpace *space, const YkLoad *loads, Sums *sums)
{
    return sum_up(f, space, loads, sums, YK_INFLUENCE_MAX);
}

int yk_influence_accelerate(YkInfluence *f, const YkSpace *space, const YkLoad *loads, double *acceleration)
{
    const YkElimination *e = f->e;
    size_t n = f->free_count;
    Sums sums;
    bool (*const ways[])(YkInfluence *, const YkSpace *, const YkLoad *,
                         Sums *) = {NULL, sum_up_for_one, sum_up_for_two, NULL, sum_up_for_four};
    if (!ways[f->width](f, space, loads, &sums)) return -2;
    int bad = solve(f, &sums);
    if (bad != -1) return bad;
    for (size_t i = 0; i < n; i++) {
        int32_t parent = e->parent_of_input[f->input[i]];
        double own = sums.g[i];
        for (size_t j = 0; parent > 0 && j < n; j++) own -= f->R[(size_t)parent * f->width + j] * sums.g[j];
        acceleration[f->input[i]] = e->sign_of_input[f->input[i]] * own;
    }
    return -1;
}
