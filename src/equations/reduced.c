// Assembles and eliminates the reduced equations at a pose, and substitutes back.
#include "equations/reduced.h"
#include <stdlib.h>
#include <string.h>
#include "equations/gradient_pose.h"
#include "equations/tree_noise.h"

YkReduced *yk_reduced_new(const YkElimination *e)
{
    YkReduced *r = calloc(1, sizeof *r);
    if (!r) return NULL;
    size_t wide = e->widest + 2, tall = e->largest_group > 2 ? e->largest_group : 2;
    size_t total = 2 * e->entry_count + 3 * e->unknown_count + e->coefficient_count + 2 * tall * wide;
    r->e = e;
    r->memory = calloc(total + 1, sizeof(double));
    if (!r->memory || !yk_coefficients_start(&r->work, e)) {
        yk_reduced_free(r);
        return NULL;
    }
    double *p = r->memory;
    r->H = p, p += e->entry_count;
    r->g = p, p += e->unknown_count;
    r->lost = p, p += e->unknown_count;
    r->xi = p, p += e->unknown_count;
    r->C = p, p += e->coefficient_count;
    r->B = p, p += tall * wide;
    r->G = p, p += tall * wide;
    r->N = p;
    return r;
}

void yk_reduced_free(YkReduced *r)
{
    if (!r) return;
    yk_coefficients_end(&r->work);
    free(r->memory);
    free(r);
}

// Returns the place of the diagonal entry of row k among the pairs of n unknowns.
static uint32_t diagonal(uint32_t k, uint32_t n)
{
    return k * n - k * (k - 1) / 2;
}

// --- bodies

static void add_element(YkReduced *r, const YkSpace *space, const YkLoad *loads, const YkElement *element)
{
    const YkElimination *e = r->e;
    const YkModel *model = e->mech->model;
    const int32_t *unknown = e->index + element->first_index, *entry = unknown + element->gradient.columns;
    uint32_t n = element->gradient.columns;
    double m = element->mass, moment = 0;
    YkVec *column = r->work.column;
    YkVec a = yk_gradient_acceleration(e, space, &element->gradient, column);
    YkVec f = yk_vec(m * (model->gravity.x - a.x), m * (model->gravity.y - a.y));
    if (element->rotation != YK_NONE)
        moment = -element->inertia * yk_space_turn(space, e->mech->bodies[element->body].orientation).a[0];
    if (loads) {
        f = yk_add(f, loads[element->body].force);
        moment += loads[element->body].moment;
    }
    for (uint32_t i = 0; i < n; i++) {
        YkVec c = column[i];
        r->g[unknown[i]] += c.x * f.x + c.y * f.y;
        if (r->measures) r->N[*entry] += m * yk_dot(c, c);
        for (uint32_t j = i; j < n; j++) r->H[*entry++] += m * (c.x * column[j].x + c.y * column[j].y);
    }
    if (element->rotation == YK_NONE) return;
    uint32_t k = (uint32_t)element->rotation;
    entry = unknown + n + diagonal(k, n);
    r->g[unknown[k]] += moment;
    r->H[*entry] += element->inertia;
    if (r->measures) r->N[*entry] += element->inertia;
}

// --- operations

// Substitutes one unknown in a form, H or N: F += c (B + f c / 2)^T + its transpose.
static void substitute_one(YkReduced *r, double *F, const YkOperation *op)
{
    const int32_t *entry = r->e->index + op->first_index + 1 + op->neighbours;
    const double *C = r->C + op->first_coefficient;
    uint32_t n = op->neighbours, q = op->given;
    double f = 0.5 * F[entry[0]];
    const int32_t *row = entry + 1, *pair = row + n;
    for (uint32_t j = 0; j < n; j++) r->G[j] = (row[j] == YK_NONE ? 0 : F[row[j]]) + (j < q ? f * C[j] : 0);
    for (uint32_t i = 0; i < q; i++) {
        F[*pair++] += 2 * C[i] * r->G[i];
        for (uint32_t j = i + 1; j < q; j++) F[*pair++] += C[i] * r->G[j] + r->G[i] * C[j];
        for (uint32_t j = q; j < n; j++) F[*pair++] += C[i] * r->G[j];
    }
}

static void substitute_two(YkReduced *r, double *F, const YkOperation *op)
{
    const int32_t *entry = r->e->index + op->first_index + 2 + op->neighbours;
    const double *C = r->C + op->first_coefficient;
    uint32_t n = op->neighbours, q = op->given;
    double f0 = 0.5 * F[entry[0]], f1 = 0.5 * F[entry[2]], f01 = 0.5 * F[entry[1]];
    const int32_t *row = entry + 3, *pair = row + 2 * n;
    double *G0 = r->G, *G1 = r->G + n;
    const double *C0 = C, *C1 = C + q;
    for (uint32_t j = 0; j < n; j++) {
        G0[j] = row[j] == YK_NONE ? 0 : F[row[j]];
        G1[j] = row[n + j] == YK_NONE ? 0 : F[row[n + j]];
    }
    for (uint32_t j = 0; j < q; j++) {
        G0[j] += f0 * C0[j] + f01 * C1[j];
        G1[j] += f01 * C0[j] + f1 * C1[j];
    }
    for (uint32_t i = 0; i < q; i++) {
        F[*pair++] += 2 * (C0[i] * G0[i] + C1[i] * G1[i]);
        for (uint32_t j = i + 1; j < q; j++)
            F[*pair++] += C0[i] * G0[j] + G0[i] * C0[j] + C1[i] * G1[j] + G1[i] * C1[j];
        for (uint32_t j = q; j < n; j++) F[*pair++] += C0[i] * G0[j] + C1[i] * G1[j];
    }
}

static void substitute_many(YkReduced *r, double *F, const YkOperation *op)
{
    uint32_t p = op->own, n = op->neighbours, q = op->given;
    const int32_t *entry = r->e->index + op->first_index + p + n;
    const double *C = r->C + op->first_coefficient;
    const int32_t *row = entry + p * (p + 1) / 2, *pair = row + p * n;
    for (uint32_t u = 0; u < p; u++)
        for (uint32_t j = 0; j < n; j++) r->G[u * n + j] = row[u * n + j] == YK_NONE ? 0 : F[row[u * n + j]];
    for (uint32_t u = 0; u < p; u++)
        for (uint32_t v = u; v < p; v++) {
            double f = 0.5 * F[*entry++];
            for (uint32_t j = 0; j < q; j++) {
                r->G[u * n + j] += f * C[v * q + j];
                if (v > u) r->G[v * n + j] += f * C[u * q + j];
            }
        }
    for (uint32_t i = 0; i < q; i++)
        for (uint32_t j = i; j < n; j++, pair++)
            for (uint32_t u = 0; u < p; u++) {
                const double *c = C + u * q, *G = r->G + u * n;
                F[*pair] += c[i] * G[j] + (j < q ? G[i] * c[j] : 0);
            }
}

static void substitute(YkReduced *r, double *F, const YkOperation *op)
{
    if (op->own == 1)
        substitute_one(r, F, op);
    else if (op->own == 2)
        substitute_two(r, F, op);
    else
        substitute_many(r, F, op);
}

// Adds what may be lost of all that an operation's own unknowns move, and what its sums round, to the unknowns on which
// they depend.
static void pass_on_loss(YkReduced *r, const YkOperation *op)
{
    uint32_t p = op->own, n = op->neighbours, q = op->given;
    const int32_t *unknown = r->e->index + op->first_index, *later = unknown + p, *entry = later + n;
    const int32_t *pair = entry + p * (p + 1) / 2 + p * n;
    const double *C = r->C + op->first_coefficient;
    for (uint32_t u = 0; u < p; u++) {
        double h = r->H[entry[diagonal(u, p)]], lost = r->lost[unknown[u]];
        for (uint32_t i = 0; i < q; i++) {
            double square = C[u * q + i] * C[u * q + i];
            r->lost[later[i]] += square * (h + lost);
            if (r->measures) r->N[pair[diagonal(i, n)]] += square * h;
        }
    }
}

// Returns whether a free unknown has inertia. In doubt, the noise decides.
static bool has_inertia(YkReduced *r, double h, const YkOperation *op)
{
    const int32_t *unknown = r->e->index + op->first_index, *entry = unknown + 1 + op->neighbours;
    if (r->measures) return h > YK_LEAST_OVER_NOISE * r->N[entry[0]] && h > 0;
    r->is_in_doubt |= !(h > 1e-6 * (h + r->lost[unknown[0]]));
    return h > 0;
}

// Hands the noise on along the motion with which the unknown answers, and adds what the subtraction rounds.
static void minimise_noise(YkReduced *r, const YkOperation *op, double over)
{
    uint32_t n = op->neighbours;
    const int32_t *entry = r->e->index + op->first_index + 1 + n, *row = entry + 1, *pair = row + n;
    double noise = r->N[entry[0]];
    for (uint32_t i = 0; i < n; i++) {
        double k = r->B[i] * over, own = r->N[row[i]];
        r->N[*pair] += r->H[*pair];
        for (uint32_t j = i; j < n; j++)
            r->N[*pair++] += k * (noise * r->B[j] * over - r->N[row[j]]) - own * r->B[j] * over;
    }
}

static bool minimise(YkReduced *r, const YkOperation *op)
{
    uint32_t n = op->neighbours;
    const int32_t *later = r->e->index + op->first_index + 1, *entry = later + n, *row = entry + 1, *pair = row + n;
    double h = r->H[entry[0]], over = 1 / h;
    if (!has_inertia(r, h, op)) return false;
    for (uint32_t j = 0; j < n; j++) r->B[j] = r->H[row[j]];
    if (r->measures) minimise_noise(r, op, over);
    for (uint32_t i = 0; i < n; i++) {
        double k = r->B[i] * over;
        r->lost[later[i]] += k * r->B[i];
        for (uint32_t j = i; j < n; j++) r->H[*pair++] -= k * r->B[j];
    }
    return true;
}

// Carries the forces g inwards with the present factors.
static void carry(YkReduced *r, const YkOperation *op)
{
    const int32_t *unknown = r->e->index + op->first_index, *later = unknown + op->own;
    const double *C = r->C + op->first_coefficient;
    if (op->kind == YK_OP_KNOWN) return;
    if (op->kind == YK_OP_FREE) {
        const int32_t *entry = later + op->neighbours, *row = entry + 1;
        double u = r->g[unknown[0]] / r->H[entry[0]];
        if (u == 0) return;
        for (uint32_t j = 0; j < op->neighbours; j++) r->g[later[j]] -= r->H[row[j]] * u;
        return;
    }
    for (uint32_t u = 0; u < op->own; u++)
        for (uint32_t j = 0; j < op->given; j++) r->g[later[j]] += C[u * op->given + j] * r->g[unknown[u]];
}

static bool eliminate(YkReduced *r, const YkSpace *space, const YkOperation *op)
{
    if (op->kind == YK_OP_KNOWN) return true;
    if (op->kind == YK_OP_FREE) {
        if (!minimise(r, op)) return false;
    } else {
        if (!yk_coefficients_find(&r->work, space, op, r->C + op->first_coefficient)) return false;
        substitute(r, r->H, op);
        if (r->measures) substitute(r, r->N, op);
        pass_on_loss(r, op);
    }
    carry(r, op);
    return true;
}

static int factor(YkReduced *r, const YkSpace *space, const YkLoad *loads, bool measures)
{
    const YkElimination *e = r->e;
    r->measures = measures;
    r->is_in_doubt = false;
    memset(r->H, 0, (e->entry_count + 2 * e->unknown_count) * sizeof *r->H); // also clears g and lost
    if (measures) memset(r->N, 0, e->entry_count * sizeof *r->N);
    for (size_t p = e->operation_count; p-- > 0;) {
        const YkOperation *op = &e->operations[p];
        for (uint32_t k = 0; k < op->element_count; k++)
            add_element(r, space, loads, &e->elements[op->first_element + k]);
        if (!eliminate(r, space, op)) return op->kind == YK_OP_FREE ? op->input : -2;
    }
    return -1;
}

int yk_reduced_factor(YkReduced *r, const YkSpace *space, const YkLoad *loads)
{
    int culprit = factor(r, space, loads, false);
    return culprit == -1 && r->is_in_doubt ? factor(r, space, loads, true) : culprit;
}

// --- back substitution

static void go_back(YkReduced *r, const YkOperation *op)
{
    const int32_t *unknown = r->e->index + op->first_index, *later = unknown + op->own;
    const double *C = r->C + op->first_coefficient;
    if (op->kind == YK_OP_KNOWN) {
        r->xi[unknown[0]] = 0;
    } else if (op->kind == YK_OP_FREE) {
        const int32_t *entry = later + op->neighbours, *row = entry + 1;
        double sum = r->g[unknown[0]];
        for (uint32_t j = 0; j < op->neighbours; j++) sum -= r->H[row[j]] * r->xi[later[j]];
        r->xi[unknown[0]] = sum / r->H[entry[0]];
    } else {
        for (uint32_t u = 0; u < op->own; u++) {
            double sum = 0;
            for (uint32_t j = 0; j < op->given; j++) sum += C[u * op->given + j] * r->xi[later[j]];
            r->xi[unknown[u]] = sum;
        }
    }
}

void yk_reduced_solve(YkReduced *r, double *acceleration, bool all)
{
    const YkElimination *e = r->e;
    for (size_t p = 0; p < e->operation_count; p++)
        if (all || e->is_back_needed[p]) go_back(r, &e->operations[p]);
    for (size_t i = 0; i < e->mech->input_count; i++) {
        int32_t at = e->operation_of_input[i];
        if (at == YK_NONE || e->operations[at].kind != YK_OP_FREE) continue;
        int32_t own = e->index[e->operations[at].first_index], parent = e->parent_of_input[i];
        acceleration[i] = e->sign_of_input[i] * (r->xi[own] - (parent > 0 ? r->xi[parent] : 0));
    }
}

double yk_reduced_effort(const YkReduced *r, size_t input)
{
    const YkElimination *e = r->e;
    int32_t at = e->operation_of_input[input];
    if (at == YK_NONE || e->operations[at].kind == YK_OP_FREE) return 0;
    const YkOperation *op = &e->operations[at];
    const int32_t *unknown = e->index + op->first_index, *later = unknown + 1, *entry = later + op->neighbours;
    double sum = r->H[entry[0]] * r->xi[unknown[0]] - r->g[unknown[0]];
    for (uint32_t j = 0; j < op->neighbours; j++)
        if (entry[1 + j] != YK_NONE) sum += r->H[entry[1 + j]] * r->xi[later[j]];
    return e->sign_of_input[input] * sum;
}

void yk_reduced_respond(YkReduced *r, int32_t b, int32_t a)
{
    const YkElimination *e = r->e;
    memset(r->g, 0, e->unknown_count * sizeof *r->g);
    if (b > 0) r->g[b] += 1;
    if (a > 0) r->g[a] -= 1;
    for (size_t p = e->operation_count; p-- > 0;) carry(r, &e->operations[p]);
    for (size_t p = 0; p < e->operation_count; p++) go_back(r, &e->operations[p]);
}
