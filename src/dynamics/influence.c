#include "dynamics/influence.h"
#include <stdlib.h>
#include <string.h>
#include "dynamics/gradient_pose.h"

// --- making
// -----------------------------------------------------------------------------------------------------------------

static void put_terms(YkInfluence *f, const YkGradient *gradient, uint32_t first_index, size_t *count)
{
    for (uint32_t k = 0; k < gradient->columns; k++) {
        const YkGradientPiece *piece = &f->e->pieces[gradient->first_piece + k];
        int32_t unknown = f->e->index[first_index + k];
        f->terms[(*count)++] = (YkInfluenceTerm){4 * piece->unit, unknown * (int32_t)f->free_count, piece->v};
    }
}

static YkInfluenceBody body_of(const YkInfluence *f, const YkElement *element)
{
    const YkElimination *e = f->e;
    YkInfluenceBody b = {element->mass, element->inertia, element->body, YK_NONE, YK_NONE};
    if (element->rotation == YK_NONE) return b;
    b.turn = 4 * e->mech->bodies[element->body].orientation;
    b.rotation = e->index[element->first_index + (uint32_t)element->rotation] * (int32_t)f->free_count;
    return b;
}

static void put_operation(YkInfluence *f, size_t p, size_t *freed, size_t *terms)
{
    const YkOperation *op = &f->e->operations[p];
    YkInfluenceMove move = {YK_CARRY_OTHER, (uint32_t)p, (uint32_t)*terms, op->gradient.columns};
    if (op->kind == YK_OP_KNOWN) return; // R stays 0
    if (op->kind == YK_OP_FREE) {
        f->input[*freed] = op->input;
        f->unknown[*freed] = f->e->index[op->first_index];
        move.kind = YK_CARRY_FREE;
        move.index = (uint32_t)(*freed)++;
    } else if (op->kind == YK_OP_PAIR && op->gradient.is_plain) {
        move.kind = YK_CARRY_PAIR;
        put_terms(f, &op->gradient, op->first_index, terms);
    }
    f->moves[f->move_count++] = move;
}

static void put_element(YkInfluence *f, size_t index, size_t *terms)
{
    const YkElement *element = &f->e->elements[index];
    YkInfluenceMove move = {YK_ADD_OTHER, (uint32_t)index, (uint32_t)*terms, element->gradient.columns};
    f->bodies[index] = body_of(f, element);
    if (element->gradient.is_plain) {
        move.kind = YK_ADD_PLAIN;
        put_terms(f, &element->gradient, element->first_index, terms);
    }
    f->moves[f->move_count++] = move;
}

static void put_moves(YkInfluence *f)
{
    size_t freed = 0, terms = 0;
    for (size_t p = 0; p < f->e->operation_count; p++) {
        const YkOperation *op = &f->e->operations[p];
        put_operation(f, p, &freed, &terms);
        for (uint32_t k = 0; k < op->element_count; k++) put_element(f, op->first_element + k, &terms);
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
    f->moves = calloc(e->operation_count + e->element_count + 1, sizeof *f->moves);
    f->terms = calloc(e->piece_count + 1, sizeof *f->terms);
    f->bodies = calloc(e->element_count + 1, sizeof *f->bodies);
    f->R = calloc(e->unknown_count * free_count + 1, sizeof *f->R);
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

// A body's reference point: its acceleration in the pose, and how it moves for each free input.
typedef struct Reference {
    YkVec a, J[YK_INFLUENCE_MAX];
} Reference;

static inline Reference plain_reference(const YkInfluence *f, const YkSpace *space, const YkInfluenceMove *move,
                                        size_t n)
{
    Reference at = {.a = {0, 0}};
    for (uint32_t k = 0; k < move->term_count; k++) {
        const YkInfluenceTerm *term = &f->terms[move->first_term + k];
        const double *t = space->data + term->turn;
        YkVec u = yk_turned_by(t, term->v), iu = yk_quarter(u);
        double w2 = t[2] * t[2];
        at.a.x += t[3] * iu.x - w2 * u.x;
        at.a.y += t[3] * iu.y - w2 * u.y;
        for (size_t i = 0; i < n; i++) at.J[i] = yk_add(at.J[i], yk_scale(f->R[(size_t)term->unknown + i], iu));
    }
    return at;
}

static Reference other_reference(const YkInfluence *f, const YkSpace *space, const YkElement *element, size_t n)
{
    const int32_t *unknown = f->e->index + element->first_index;
    YkVec *c = f->work.column;
    Reference at = {.a = yk_gradient_acceleration(f->e, space, &element->gradient, c)};
    for (uint32_t k = 0; k < element->gradient.columns; k++)
        for (size_t i = 0; i < n; i++) at.J[i] = yk_add(at.J[i], yk_scale(f->R[(size_t)unknown[k] * n + i], c[k]));
    return at;
}

static inline void add_body(const YkInfluence *f, const YkSpace *space, const YkLoad *loads, const YkInfluenceBody *b,
                            const Reference *at, Sums *sums, size_t n)
{
    YkVec gravity = f->e->mech->model->gravity;
    YkVec force = yk_vec(b->mass * (gravity.x - at->a.x), b->mass * (gravity.y - at->a.y));
    double moment = b->turn == YK_NONE ? 0 : -b->inertia * space->data[b->turn + 3];
    if (loads) {
        force = yk_add(force, loads[b->body].force);
        moment += loads[b->body].moment;
    }
    for (size_t i = 0; i < n; i++) {
        sums->g[i] += yk_dot(at->J[i], force);
        for (size_t j = i; j < n; j++) sums->M[i][j] += b->mass * yk_dot(at->J[i], at->J[j]);
    }
    if (b->rotation == YK_NONE) return;
    const double *R = f->R + b->rotation;
    for (size_t i = 0; i < n; i++) {
        sums->g[i] += R[i] * moment;
        for (size_t j = i; j < n; j++) sums->M[i][j] += b->inertia * R[i] * R[j];
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

// All moves; n is the number of free inputs, known to the compiler where it is 1.
static inline bool sum_up(YkInfluence *f, const YkSpace *space, const YkLoad *loads, Sums *total, size_t n)
{
    Sums sums = {.g = {0}};
    Reference at;
    for (const YkInfluenceMove *move = f->moves, *end = move + f->move_count; move < end; move++)
        switch (move->kind) {
        case YK_CARRY_FREE:
            for (size_t i = 0; i < n; i++) f->R[(size_t)f->unknown[move->index] * n + i] = i == move->index;
            break;
        case YK_CARRY_PAIR:
            carry_pair(f, space, move, n);
            break;
        case YK_CARRY_OTHER:
            if (!carry_other(f, space, move, n)) return false;
            break;
        case YK_ADD_PLAIN:
            at = plain_reference(f, space, move, n);
            add_body(f, space, loads, &f->bodies[move->index], &at, &sums, n);
            break;
        case YK_ADD_OTHER:
            at = other_reference(f, space, &f->e->elements[move->index], n);
            add_body(f, space, loads, &f->bodies[move->index], &at, &sums, n);
            break;
        }
    *total = sums;
    return true;
}

int yk_influence_accelerate(YkInfluence *f, const YkSpace *space, const YkLoad *loads, double *acceleration)
{
    const YkElimination *e = f->e;
    size_t n = f->free_count;
    Sums sums;
    bool stands = n == 1 ? sum_up(f, space, loads, &sums, 1) : sum_up(f, space, loads, &sums, n);
    if (!stands) return -2;
    int bad = solve(f, &sums);
    if (bad != -1) return bad;
    for (size_t i = 0; i < n; i++) {
        int32_t parent = e->parent_of_input[f->input[i]];
        double own = sums.g[i];
        for (size_t j = 0; parent > 0 && j < n; j++) own -= f->R[(size_t)parent * n + j] * sums.g[j];
        acceleration[f->input[i]] = e->sign_of_input[f->input[i]] * own;
    }
    return -1;
}
