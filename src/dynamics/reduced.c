#include "dynamics/reduced.h"
#include <stdlib.h>
#include <string.h>
#include "num/dense.h"

YkReduced *yk_reduced_new(const YkElimination *e)
{
    YkReduced *r = calloc(1, sizeof *r);
    if (!r) return NULL;
    size_t group = e->largest_group, wide = e->widest + 2, tall = group > 2 ? group : 2;
    size_t total = e->entry_count + 3 * e->unknown_count + e->coefficient_count + 2 * wide + 2 * tall * wide +
                   group * group + group * wide + 2 * group + 8;
    r->e = e;
    r->memory = calloc(total * sizeof(double) + group * (sizeof(int) + sizeof(size_t)) + 16, 1);
    if (!r->memory) {
        free(r);
        return NULL;
    }
    double *p = r->memory;
    r->H = p, p += e->entry_count;
    r->g = p, p += e->unknown_count;
    r->lost = p, p += e->unknown_count;
    r->xi = p, p += e->unknown_count;
    r->C = p, p += e->coefficient_count;
    r->column = (YkVec *)p, p += 2 * wide;
    r->B = p, p += tall * wide;
    r->G = p, p += tall * wide;
    r->D = p, p += group * group;
    r->K = p, p += group * wide;
    r->tau = p, p += 2 * group + 8;
    r->order = (size_t *)p;
    r->pivot = (int *)(r->order + group);
    return r;
}

void yk_reduced_free(YkReduced *r)
{
    if (!r) return;
    free(r->memory);
    free(r);
}

// --- gradients
// ----------------------------------------------------------------------------------------------------------

// Lanes of one pose stand side by side: cos, sin, rate, acceleration.
static inline const double *turn_of(const YkSpace *space, int32_t slot)
{
    return space->data + 4 * slot;
}

static inline YkVec turned(const double *turn, YkVec v)
{
    return yk_vec(turn[0] * v.x - turn[1] * v.y, turn[0] * v.y + turn[1] * v.x);
}

static inline void add_to(YkVec *columns, int32_t column, double k, YkVec v)
{
    if (column == YK_NONE) return;
    columns[column].x += k * v.x;
    columns[column].y += k * v.y;
}

static inline void add_piece(const YkSpace *space, const YkGradientPiece *piece, YkVec *columns)
{
    YkVec u = piece->slot ? turned(turn_of(space, piece->slot), piece->v) : piece->v;
    if (piece->root) u = turned(turn_of(space, piece->root), u);
    YkVec iu = yk_quarter(u);
    double d = 1;
    if (piece->distance != YK_NONE) {
        d = yk_space_slide(space, piece->distance).d[0];
        add_to(columns, piece->along, 1, u);
    }
    add_to(columns, piece->turn[0], d, iu);
    add_to(columns, piece->turn[1], d, iu);
}

static inline void add_nodes(const YkElimination *e, const YkGradient *gradient, YkVec *columns)
{
    for (uint32_t k = 0; k < gradient->node_count; k++) {
        const YkNodePart *part = &e->nodes[gradient->first_node + k];
        columns[part->column].x += part->sign;
        columns[part->column + 1].y += part->sign;
    }
}

static inline void find_gradient(YkReduced *r, const YkSpace *space, const YkGradient *gradient)
{
    if (gradient->is_plain) {
        const YkGradientPiece *piece = &r->e->pieces[gradient->first_piece];
        for (uint32_t k = 0; k < gradient->columns; k++)
            r->column[k] = yk_quarter(turned(turn_of(space, piece[k].unit), piece[k].v));
        return;
    }
    for (uint32_t k = 0; k < gradient->columns; k++) r->column[k] = yk_vec(0, 0);
    add_nodes(r->e, gradient, r->column);
    for (uint32_t k = 0; k < gradient->piece_count; k++)
        add_piece(space, &r->e->pieces[gradient->first_piece + k], r->column);
}

// --- bodies
// -------------------------------------------------------------------------------------------------------------

// The gradient of the reference point, and its acceleration in the pose.
static inline YkVec find_acceleration(YkReduced *r, const YkSpace *space, const YkGradient *gradient)
{
    YkVec sum = {0, 0};
    if (gradient->is_plain) {
        const YkGradientPiece *piece = &r->e->pieces[gradient->first_piece];
        for (uint32_t k = 0; k < gradient->columns; k++) {
            const double *t = turn_of(space, piece[k].unit);
            YkVec u = turned(t, piece[k].v), iu = yk_quarter(u);
            double w2 = t[2] * t[2];
            r->column[k] = iu;
            sum.x += t[3] * iu.x - w2 * u.x;
            sum.y += t[3] * iu.y - w2 * u.y;
        }
        return sum;
    }
    for (uint32_t k = 0; k < gradient->columns; k++) r->column[k] = yk_vec(0, 0);
    for (uint32_t k = 0; k < gradient->node_count; k++) {
        const YkNodePart *part = &r->e->nodes[gradient->first_node + k];
        YkPlane p = yk_space_plane(space, part->node);
        r->column[part->column].x += part->sign;
        r->column[part->column + 1].y += part->sign;
        sum = yk_add(sum, yk_scale(part->sign, yk_vec(p.ax[0], p.ay[0])));
    }
    for (uint32_t k = 0; k < gradient->piece_count; k++) {
        const YkGradientPiece *piece = &r->e->pieces[gradient->first_piece + k];
        YkVec u = piece->v;
        double w = 0, a = 0;
        if (piece->slot) {
            const double *t = turn_of(space, piece->slot);
            u = turned(t, u);
            w = t[2];
            a = t[3];
        }
        YkVec iu = yk_quarter(u);
        double along = -w * w, across = a, d = 1;
        if (piece->distance != YK_NONE) {
            YkSlide s = yk_space_slide(space, piece->distance);
            d = s.d[0];
            along = s.a[0] - d * w * w;
            across = d * a + 2 * s.v[0] * w;
            add_to(r->column, piece->along, 1, u);
        }
        add_to(r->column, piece->turn[1], d, iu);
        sum.x += along * u.x + across * iu.x;
        sum.y += along * u.y + across * iu.y;
    }
    return sum;
}

static void add_element(YkReduced *r, const YkSpace *space, const YkLoad *loads, const YkElement *element)
{
    const YkElimination *e = r->e;
    const YkModel *model = e->mech->model;
    const int32_t *unknown = e->index + element->first_index, *entry = unknown + element->gradient.columns;
    uint32_t n = element->gradient.columns;
    double m = element->mass, moment = 0;
    YkVec a = find_acceleration(r, space, &element->gradient);
    YkVec f = yk_vec(m * (model->gravity.x - a.x), m * (model->gravity.y - a.y));
    if (element->rotation != YK_NONE)
        moment = -element->inertia * yk_space_turn(space, e->mech->bodies[element->body].orientation).a[0];
    if (loads) {
        f = yk_add(f, loads[element->body].force);
        moment += loads[element->body].moment;
    }
    for (uint32_t i = 0; i < n; i++) {
        YkVec c = r->column[i];
        r->g[unknown[i]] += c.x * f.x + c.y * f.y;
        for (uint32_t j = i; j < n; j++) r->H[*entry++] += m * (c.x * r->column[j].x + c.y * r->column[j].y);
    }
    if (element->rotation == YK_NONE) return;
    uint32_t k = (uint32_t)element->rotation; // its diagonal entry
    entry = unknown + n + k * n - k * (k - 1) / 2;
    r->g[unknown[k]] += moment;
    r->H[*entry] += element->inertia;
}

// --- operations
// ---------------------------------------------------------------------------------------------------------

// The rows of a group's relations, behind those of its loops.
static void add_relation_rows(YkReduced *r, const YkSpace *space, const YkOperation *op, size_t m)
{
    const YkElimination *e = r->e;
    const YkBlock *block = &e->mech->blocks[op->block];
    const double *factor = e->factors + op->first_factor;
    size_t n = op->own, q = op->given;
    for (size_t k = 0; k < block->relation_count; k++, factor += 2 * (n + q)) {
        size_t row = 2 * block->loop_count + k;
        double slope = space->gain[(size_t)e->mech->group_relations[block->first_relation + k] * space->stride];
        for (size_t u = 0; u < n; u++) r->D[row * n + u] = factor[2 * u] + slope * factor[2 * u + 1];
        for (size_t w = 0; w < q; w++) r->K[w * m + row] = -(factor[2 * (n + w)] + slope * factor[2 * (n + w) + 1]);
    }
}

// D x = -K for the unknowns of a group; more equations than unknowns: least squares.
static bool solve_group(YkReduced *r, const YkSpace *space, const YkOperation *op, double *C)
{
    const YkElimination *e = r->e;
    const YkBlock *block = &e->mech->blocks[op->block];
    size_t n = op->own, q = op->given, m = yk_block_rows(block);
    memset(r->D, 0, m * n * sizeof *r->D);
    memset(r->K, 0, m * q * sizeof *r->K);
    for (size_t row = 0; row < block->loop_count; row++) {
        for (uint32_t k = 0; k < op->gradient.columns; k++) r->column[k] = yk_vec(0, 0);
        for (uint32_t k = 0; k < op->gradient.node_count; k++) {
            const YkNodePart *part = &e->nodes[op->gradient.first_node + k];
            if (part->row != (int32_t)row) continue;
            r->column[part->column].x += part->sign;
            r->column[part->column + 1].y += part->sign;
        }
        for (uint32_t k = 0; k < op->gradient.piece_count; k++) {
            const YkGradientPiece *piece = &e->pieces[op->gradient.first_piece + k];
            if (piece->row == (int32_t)row) add_piece(space, piece, r->column);
        }
        for (size_t k = 0; k < n; k++) {
            r->D[2 * row * n + k] = r->column[k].x;
            r->D[(2 * row + 1) * n + k] = r->column[k].y;
        }
        for (size_t k = 0; k < q; k++) {
            r->K[k * m + 2 * row] = -r->column[n + k].x;
            r->K[k * m + 2 * row + 1] = -r->column[n + k].y;
        }
    }
    add_relation_rows(r, space, op, m);
    if (m == n) {
        if (yk_lu_factor(n, r->D, r->pivot, r->tau) == 0) return false;
        for (size_t k = 0; k < q; k++) {
            yk_lu_solve(n, r->D, r->pivot, r->K + k * m);
            for (size_t u = 0; u < n; u++) C[u * q + k] = r->K[k * m + u];
        }
        return true;
    }
    size_t rank = yk_qr_factor(m, n, r->D, r->order, r->tau, 1e-10);
    for (size_t k = 0; k < q; k++) {
        yk_qr_solve(m, n, r->D, r->order, r->tau, rank, r->K + k * m, r->B); // B is free here
        for (size_t u = 0; u < n; u++) C[u * q + k] = r->B[u];
    }
    return rank == n;
}

// The coefficients C of the operation's unknowns in the given ones.
static bool find_coefficients(YkReduced *r, const YkSpace *space, const YkOperation *op)
{
    double *C = r->C + op->first_coefficient;
    uint32_t q = op->given;
    const YkVec *c = r->column;
    switch (op->kind) {
    case YK_OP_COPY:
        for (uint32_t k = 0; k < q; k++) C[k] = 1;
        return true;
    case YK_OP_RELATION: {
        const double *factor = r->e->factors + op->first_factor;
        double slope = space->gain[op->block * space->stride];
        for (uint32_t k = 0; k < q; k++) C[k] = factor[2 + 2 * k] + slope * factor[3 + 2 * k];
        return true;
    }
    case YK_OP_NODE:
        find_gradient(r, space, &op->gradient);
        for (uint32_t k = 0; k < q; k++) {
            C[k] = c[2 + k].x;
            C[q + k] = c[2 + k].y;
        }
        return true;
    case YK_OP_PAIR: {
        find_gradient(r, space, &op->gradient);
        double over = -1 / yk_cross(c[0], c[1]);
        for (uint32_t k = 0; k < q; k++) {
            C[k] = over * yk_cross(c[2 + k], c[1]);
            C[q + k] = over * yk_cross(c[0], c[2 + k]);
        }
        return true;
    }
    case YK_OP_SINGLE: {
        find_gradient(r, space, &op->gradient);
        double over = -1 / yk_dot(c[0], c[0]);
        for (uint32_t k = 0; k < q; k++) C[k] = over * yk_dot(c[0], c[1 + k]);
        return true;
    }
    case YK_OP_GROUP:
        return solve_group(r, space, op, C);
    default:
        return true;
    }
}

// One unknown: H += c (B + h c / 2)^T + its transpose.
static void substitute_one(YkReduced *r, const YkOperation *op)
{
    const int32_t *unknown = r->e->index + op->first_index, *later = unknown + 1, *entry = later + op->neighbours;
    const double *C = r->C + op->first_coefficient;
    uint32_t n = op->neighbours, q = op->given;
    double h = 0.5 * r->H[entry[0]], g = r->g[unknown[0]];
    const int32_t *row = entry + 1, *pair = row + n;
    for (uint32_t j = 0; j < n; j++) r->G[j] = (row[j] == YK_NONE ? 0 : r->H[row[j]]) + (j < q ? h * C[j] : 0);
    for (uint32_t i = 0; i < q; i++) {
        r->g[later[i]] += C[i] * g;
        r->H[*pair++] += 2 * C[i] * r->G[i];
        for (uint32_t j = i + 1; j < q; j++) r->H[*pair++] += C[i] * r->G[j] + r->G[i] * C[j];
        for (uint32_t j = q; j < n; j++) r->H[*pair++] += C[i] * r->G[j];
    }
}

static void substitute_two(YkReduced *r, const YkOperation *op)
{
    const int32_t *unknown = r->e->index + op->first_index, *later = unknown + 2, *entry = later + op->neighbours;
    const double *C = r->C + op->first_coefficient;
    uint32_t n = op->neighbours, q = op->given;
    double h0 = 0.5 * r->H[entry[0]], h1 = 0.5 * r->H[entry[2]], h01 = 0.5 * r->H[entry[1]];
    double g0 = r->g[unknown[0]], g1 = r->g[unknown[1]];
    const int32_t *row = entry + 3, *pair = row + 2 * n;
    double *G0 = r->G, *G1 = r->G + n;
    const double *C0 = C, *C1 = C + q;
    for (uint32_t j = 0; j < n; j++) {
        G0[j] = row[j] == YK_NONE ? 0 : r->H[row[j]];
        G1[j] = row[n + j] == YK_NONE ? 0 : r->H[row[n + j]];
    }
    for (uint32_t j = 0; j < q; j++) {
        G0[j] += h0 * C0[j] + h01 * C1[j];
        G1[j] += h01 * C0[j] + h1 * C1[j];
    }
    for (uint32_t i = 0; i < q; i++) {
        r->g[later[i]] += C0[i] * g0 + C1[i] * g1;
        r->H[*pair++] += 2 * (C0[i] * G0[i] + C1[i] * G1[i]);
        for (uint32_t j = i + 1; j < q; j++)
            r->H[*pair++] += C0[i] * G0[j] + G0[i] * C0[j] + C1[i] * G1[j] + G1[i] * C1[j];
        for (uint32_t j = q; j < n; j++) r->H[*pair++] += C0[i] * G0[j] + C1[i] * G1[j];
    }
}

static void substitute_many(YkReduced *r, const YkOperation *op)
{
    uint32_t p = op->own, n = op->neighbours, q = op->given;
    const int32_t *unknown = r->e->index + op->first_index, *later = unknown + p, *entry = later + n;
    const double *C = r->C + op->first_coefficient;
    const int32_t *row = entry + p * (p + 1) / 2, *pair = row + p * n;
    for (uint32_t u = 0; u < p; u++)
        for (uint32_t j = 0; j < n; j++) r->G[u * n + j] = row[u * n + j] == YK_NONE ? 0 : r->H[row[u * n + j]];
    for (uint32_t u = 0; u < p; u++)
        for (uint32_t v = u; v < p; v++) {
            double h = 0.5 * r->H[*entry++];
            for (uint32_t j = 0; j < q; j++) {
                r->G[u * n + j] += h * C[v * q + j];
                if (v > u) r->G[v * n + j] += h * C[u * q + j];
            }
        }
    for (uint32_t i = 0; i < q; i++) {
        for (uint32_t u = 0; u < p; u++) r->g[later[i]] += C[u * q + i] * r->g[unknown[u]];
        for (uint32_t j = i; j < n; j++, pair++)
            for (uint32_t u = 0; u < p; u++) {
                const double *c = C + u * q, *G = r->G + u * n;
                r->H[*pair] += c[i] * G[j] + (j < q ? G[i] * c[j] : 0);
            }
    }
}

static bool minimise(YkReduced *r, const YkOperation *op)
{
    uint32_t n = op->neighbours;
    const int32_t *unknown = r->e->index + op->first_index, *later = unknown + 1, *entry = later + n;
    double h = r->H[entry[0]], size = h + r->lost[unknown[0]];
    if (!(h > 1e-13 * size) || !(h > 0)) return false;
    const int32_t *row = entry + 1, *pair = row + n;
    double over = 1 / h, u = r->g[unknown[0]] * over;
    for (uint32_t j = 0; j < n; j++) r->B[j] = r->H[row[j]];
    for (uint32_t i = 0; i < n; i++) {
        double k = r->B[i] * over;
        r->g[later[i]] -= r->B[i] * u;
        r->lost[later[i]] += k * r->B[i];
        for (uint32_t j = i; j < n; j++) r->H[*pair++] -= k * r->B[j];
    }
    return true;
}

static bool eliminate(YkReduced *r, const YkSpace *space, const YkOperation *op)
{
    if (op->kind == YK_OP_FREE) return minimise(r, op);
    if (op->kind == YK_OP_KNOWN) return true;
    if (!find_coefficients(r, space, op)) return false;
    if (op->own == 1)
        substitute_one(r, op);
    else if (op->own == 2)
        substitute_two(r, op);
    else
        substitute_many(r, op);
    return true;
}

int yk_reduced_factor(YkReduced *r, const YkSpace *space, const YkLoad *loads)
{
    const YkElimination *e = r->e;
    memset(r->H, 0, (e->entry_count + 2 * e->unknown_count) * sizeof *r->H); // and g, and lost
    for (size_t p = e->operation_count; p-- > 0;) {
        const YkOperation *op = &e->operations[p];
        for (uint32_t k = 0; k < op->element_count; k++)
            add_element(r, space, loads, &e->elements[op->first_element + k]);
        if (!eliminate(r, space, op)) return op->kind == YK_OP_FREE ? op->input : -2;
    }
    return -1;
}

// --- back
// ---------------------------------------------------------------------------------------------------------------

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

// Carries the forces g inwards with the factors that stand.
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

void yk_reduced_respond(YkReduced *r, int32_t b, int32_t a)
{
    const YkElimination *e = r->e;
    memset(r->g, 0, e->unknown_count * sizeof *r->g);
    if (b > 0) r->g[b] += 1;
    if (a > 0) r->g[a] -= 1;
    for (size_t p = e->operation_count; p-- > 0;) carry(r, &e->operations[p]);
    for (size_t p = 0; p < e->operation_count; p++) go_back(r, &e->operations[p]);
}
