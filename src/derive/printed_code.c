// For generated code: what body angles and lengths of springs stand for, and M and h by sums over the tree.
//
// In body form every entry has one term or two. The machine's own coordinates turn a body with all that it carries, so
// M and h in them are sums over branches of the tree, and each branch is the sum of its first body and of the branches
// after it: n^2 additions instead of the n^4 terms of the expanded form (related to composite bodies, Featherstone
// 2008).
#include "derive/printed_code.h"
#include <stdlib.h>
#include <string.h>
#include "derive/forces/free_bodies.h"
#include "ring/graph/element.h"

// --- Definitions

static YkRef after(YkRingGraph *graph, YkRef before, YkRef step, bool forwards)
{
    return forwards ? yk_graph_add(&graph->graph, before, step) : yk_graph_subtract(&graph->graph, before, step);
}

// Defines the angle of a body's axes, its spin and the spin's rate from those of the body before it.
static void define_body(YkDerivation *d, YkRingGraph *graph, int32_t b, YkRef (*motions)[3])
{
    const YkDeriveBody *body = &d->bodies[b];
    bool forwards = d->model->joints[body->joint].body[1] == b;
    int32_t coordinate = d->joint_angle[body->joint];
    YkRef *before = motions[body->parent], *here = motions[b];
    if (coordinate == YK_NONE) {
        const YkPoisson *turned = yk_derive_expression(d, d->model->joints[body->joint].turned_expr);
        here[0] = after(graph, before[0], yk_ring_graph_of(graph, turned), forwards);
        here[1] = before[1], here[2] = before[2];
        return;
    }
    const YkDeriveCoordinate *c = &d->coordinates[coordinate];
    const int32_t steps[] = {c->position, c->rate, c->acceleration};
    const int32_t own[] = {body->angle, body->rate, body->acceleration};
    for (int k = 0; k < 3; k++) {
        here[k] = after(graph, before[k], yk_ring_graph_symbol(graph, steps[k]), forwards);
        if (own[k] != steps[k]) yk_ring_graph_define(graph, own[k], here[k]);
    }
}

static void define_lengths(YkDerivation *d, YkRingGraph *graph)
{
    const YkDeriveForces *f = yk_derive_forces(d);
    for (size_t k = 0; f && k < f->length_count; k++)
        if (f->lengths[k].rate_symbol != YK_NONE)
            yk_ring_graph_define(graph, f->lengths[k].rate_symbol, yk_ring_graph_of(graph, f->lengths[k].rate));
}

static void look_for_name(void *context, const YkExpr *expr)
{
    *(bool *)context |= strcmp(expr->name, "pi") != 0;
}

// Defines constants that no parameter changes as numbers.
static void define_numbers(YkDerivation *d, YkRingGraph *graph)
{
    for (size_t k = 0; k < d->constant_count; k++) {
        bool has_names = false;
        yk_expr_names(d->constants[k].expr, look_for_name, &has_names);
        if (!has_names)
            yk_ring_graph_define(graph, d->constants[k].symbol, yk_graph_number(&graph->graph, d->constants[k].value));
    }
}

bool yk_derive_define_bodies(void *derivation, YkRingGraph *graph)
{
    YkDerivation *d = derivation;
    size_t bodies = d->model->body_count;
    YkRef(*motions)[3] = yk_derive_scratch(d, bodies + 1, sizeof *motions);
    if (!motions) return false;
    for (int k = 0; k < 3; k++) motions[0][k] = yk_graph_number(&graph->graph, 0);
    for (size_t k = 0; k < bodies; k++) {
        int32_t b = d->mech->tree_order[k];
        if (d->bodies[b].parent != YK_NONE) define_body(d, graph, b, motions);
    }
    free(motions);
    define_lengths(d, graph);
    define_numbers(d, graph);
    return !graph->graph.failed;
}

// --- Branches of the tree

typedef struct Branches {
    const YkDeriveForces *f;
    YkRingGraph *graph;
    size_t n;
    int32_t *first, *next, *parent; // of coordinates: those that begin right after one, or YK_NONE
    bool *is_backwards;
    YkRef *own, *column, *both; // memo, [n][n]: M in body form; summed over rows; over rows and columns
} Branches;

static void find_branch(Branches *t, size_t k)
{
    YkDerivation *d = t->f->d;
    YkDeriveFreedom freedom = yk_derive_freedom(d, k);
    t->parent[k] = YK_NONE;
    if (freedom.body == YK_NONE) return;
    t->is_backwards[k] = d->model->joints[d->bodies[freedom.body].joint].body[1] != freedom.body;
    for (int32_t b = d->bodies[freedom.body].parent; d->bodies[b].parent != YK_NONE; b = d->bodies[b].parent) {
        int32_t before = d->joint_angle[d->bodies[b].joint];
        if (before == YK_NONE) continue;
        t->parent[k] = before;
        t->next[k] = t->first[before];
        t->first[before] = (int32_t)k;
        return;
    }
}

static bool start(Branches *t, const YkDeriveForces *f, YkRingGraph *graph)
{
    YkArena *arena = f->d->arena;
    size_t n = f->d->tree_count;
    *t = (Branches){.f = f,
                    .graph = graph,
                    .n = n,
                    .first = YK_NEW(arena, int32_t, n + 1),
                    .next = YK_NEW(arena, int32_t, n + 1),
                    .parent = YK_NEW(arena, int32_t, n + 1),
                    .is_backwards = YK_NEW(arena, bool, n + 1),
                    .own = YK_NEW(arena, YkRef, n * n + 1),
                    .column = YK_NEW(arena, YkRef, n * n + 1),
                    .both = YK_NEW(arena, YkRef, n * n + 1)};
    if (yk_arena_failed(arena)) return false;
    for (size_t k = 0; k < n * n; k++) t->own[k] = t->column[k] = t->both[k] = YK_NONE;
    for (size_t k = 0; k < n; k++) t->first[k] = t->next[k] = YK_NONE;
    for (size_t k = 0; k < n; k++) find_branch(t, k);
    return true;
}

static YkRef entry(Branches *t, size_t i, size_t k)
{
    YkDerivation *d = t->f->d;
    if (i < k) return entry(t, k, i); // M is symmetric
    YkRef *memo = &t->own[i * t->n + k];
    if (*memo != YK_NONE) return *memo;
    const YkPoisson *left = yk_derive_lagrange(t->f, i).left;
    int32_t acceleration = yk_derive_freedom(d, k).acceleration;
    if (!left || !yk_ring_mentions(d->ring, left, acceleration)) return *memo = yk_graph_number(&t->graph->graph, 0);
    return *memo = yk_ring_graph_of(t->graph, yk_ring_coefficient(d->ring, left, acceleration, 1));
}

// Sums over the branch that begins with i.
static YkRef column_sum(Branches *t, size_t i, size_t k)
{
    YkRef *memo = &t->column[i * t->n + k];
    if (*memo != YK_NONE) return *memo;
    YkRef sum = entry(t, i, k);
    for (int32_t c = t->first[i]; c != YK_NONE; c = t->next[c])
        sum = yk_graph_add(&t->graph->graph, sum, column_sum(t, (size_t)c, k));
    return *memo = sum;
}

static bool is_before(const Branches *t, size_t i, size_t k) // on the way from k to the ground
{
    for (int32_t at = t->parent[k]; at != YK_NONE; at = t->parent[at])
        if (at == (int32_t)i) return true;
    return false;
}

// Sums over the branches that begin with i and k; i is never before k, so that both halves of M come from one.
static YkRef sum_of_both(Branches *t, size_t i, size_t k)
{
    if (is_before(t, i, k) || (i < k && !is_before(t, k, i))) return sum_of_both(t, k, i);
    YkRef *memo = &t->both[i * t->n + k];
    if (*memo != YK_NONE) return *memo;
    YkRef sum = column_sum(t, i, k);
    for (int32_t c = t->first[k]; c != YK_NONE; c = t->next[c])
        sum = yk_graph_add(&t->graph->graph, sum, sum_of_both(t, i, (size_t)c));
    return *memo = sum;
}

// Returns the rest of a coordinate's equation in body form, without accelerations and multipliers.
static YkRef rest_of(Branches *t, size_t k)
{
    YkDerivation *d = t->f->d;
    const YkDeriveMultipliers *m = yk_derive_multipliers(t->f);
    size_t count = t->n + m->count;
    int32_t *symbols = YK_NEW(d->arena, int32_t, count + 1);
    if (!symbols) {
        t->graph->graph.failed = true;
        return 0;
    }
    for (size_t c = 0; c < t->n; c++) symbols[c] = yk_derive_freedom(d, c).acceleration;
    for (size_t r = 0; r < m->count; r++) symbols[t->n + r] = m->symbols[r];
    const YkPoisson *left = yk_derive_lagrange(t->f, k).left;
    return yk_ring_graph_of(t->graph, yk_ring_split(d->ring, left, symbols, count, NULL, 0));
}

static YkRef rest_sum(Branches *t, size_t k)
{
    if (t->own[k] != YK_NONE) return t->own[k];
    YkRef sum = rest_of(t, k);
    for (int32_t c = t->first[k]; c != YK_NONE; c = t->next[c])
        sum = yk_graph_add(&t->graph->graph, sum, rest_sum(t, (size_t)c));
    return t->own[k] = sum;
}

bool yk_derive_build_mass(void *forces, YkRingGraph *graph, YkRef *entries)
{
    Branches t;
    if (!start(&t, forces, graph)) return false;
    for (size_t i = 0; i < t.n; i++)
        for (size_t k = 0; k < t.n; k++) {
            YkRef sum = sum_of_both(&t, i, k);
            entries[i * t.n + k] = t.is_backwards[i] != t.is_backwards[k] ? yk_graph_minus(&graph->graph, sum) : sum;
        }
    return !graph->graph.failed;
}

bool yk_derive_build_rest(void *forces, YkRingGraph *graph, YkRef *entries)
{
    Branches t;
    if (!start(&t, forces, graph)) return false;
    for (size_t k = 0; k < t.n; k++) {
        YkRef sum = rest_sum(&t, k);
        entries[k] = t.is_backwards[k] ? yk_graph_minus(&graph->graph, sum) : sum;
    }
    return !graph->graph.failed;
}
