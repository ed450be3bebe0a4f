// Makes a tape from a graph: which values it computes, and in which order.
#include "graph/tape.h"
#include <stdlib.h>
#include <string.h>
#include "graph/tape_steps.h"

// --- what is needed

static void use_operands(YkTapeMaker *m, YkRef value)
{
    const YkValue *v = yk_tape_value(m, value);
    const YkRef operands[] = {v->a, v->b, v->c};
    for (size_t k = 0; k < 3; k++)
        if (operands[k] != YK_NONE) m->uses[operands[k]]++;
}

static void use_call(YkTapeMaker *m, int32_t index)
{
    const YkCall *call = &m->graph->calls[index];
    if (m->of_call[index] != YK_NONE) return; // another result of it has counted them
    m->of_call[index] = (int32_t)m->call_count++;
    m->failed |= call->kind != YK_CALL_SOLVE && call->kind != YK_CALL_LAW;
    for (size_t k = 0; k < call->argument_count; k++) m->uses[call->arguments[k]]++;
}

// Counts from the last value to the first, since operands come before what they are for.
static void count_uses(YkTapeMaker *m, const YkRef *roots, size_t root_count)
{
    for (size_t k = 0; k < root_count; k++) m->uses[roots[k]]++;
    for (YkRef v = (YkRef)m->graph->count - 1; v >= 0; v--) {
        YkValueKind op = yk_tape_value(m, v)->op;
        if (m->uses[v] == 0 || op == YK_VALUE_NUMBER || op == YK_VALUE_LEAF) continue;
        if (op == YK_VALUE_RESULT)
            use_call(m, yk_tape_value(m, v)->a);
        else
            use_operands(m, v);
    }
}

// --- steps, whose operands are still values

static YkTapeStep rare_step(const YkTapeMaker *m, const YkValue *v)
{
    YkTapeStep s = yk_tape_step(YK_TAPE_RARE, v->a, v->b, v->c, YK_NONE);
    s.kind = v->op;
    s.function = v->function;
    if (v->op != YK_VALUE_RESULT) return s;
    s.in[0] = s.in[1] = YK_NONE;
    s.call = m->of_call[v->a];
    return s;
}

static YkTapeStep make_step(const YkTapeMaker *m, YkRef value)
{
    const YkValue *v = yk_tape_value(m, value);
    switch (v->op) {
    case YK_VALUE_ADD:
    case YK_VALUE_SUBTRACT:
        return yk_tape_sum(m, value);
    case YK_VALUE_MULTIPLY:
        return yk_tape_step(YK_TAPE_MULTIPLY, v->a, v->b, YK_NONE, YK_NONE);
    case YK_VALUE_DIVIDE:
        return yk_tape_step(YK_TAPE_DIVIDE, v->a, v->b, YK_NONE, YK_NONE);
    case YK_VALUE_MINUS:
        return yk_tape_step(YK_TAPE_MINUS, v->a, YK_NONE, YK_NONE, YK_NONE);
    case YK_VALUE_SIZE:
        return yk_tape_step(YK_TAPE_SIZE, v->a, YK_NONE, YK_NONE, YK_NONE);
    case YK_VALUE_NONZERO:
        return yk_tape_step(YK_TAPE_NONZERO, v->a, YK_NONE, YK_NONE, YK_NONE);
    case YK_VALUE_CHOOSE:
        return yk_tape_step(YK_TAPE_CHOOSE, v->a, v->b, v->c, YK_NONE);
    case YK_VALUE_FUNCTION:
        if (v->function == YK_SQRT) return yk_tape_step(YK_TAPE_ROOT, v->a, YK_NONE, YK_NONE, YK_NONE);
        return rare_step(m, v);
    default:
        return rare_step(m, v);
    }
}

// Notes the values that a call takes and gives.
static void make_call(YkTapeMaker *m, int32_t index)
{
    const YkCall *call = &m->graph->calls[index];
    YkArena *arena = m->tape->arena;
    YkTapeCall *c = &m->tape->calls[m->of_call[index]];
    if (c->arguments) return;
    *c = (YkTapeCall){call->kind,
                      call->index,
                      call->n,
                      call->m,
                      call->argument_count,
                      call->result_count,
                      YK_NEW(arena, int32_t, call->argument_count + 1),
                      YK_NEW(arena, int32_t, call->result_count + 1)};
    if (yk_arena_failed(arena)) return;
    memcpy(c->arguments, call->arguments, call->argument_count * sizeof *c->arguments);
    for (size_t k = 0; k < call->result_count; k++) {
        YkValue result = {.op = YK_VALUE_RESULT, .a = index, .b = (YkRef)k, .c = YK_NONE};
        YkRef value = yk_graph_find(m->graph, result);
        c->results[k] = value != YK_NONE && m->uses[value] > 0 ? value : YK_NONE;
    }
    size_t numbers = call->argument_count > call->result_count ? call->argument_count : call->result_count;
    if (numbers > m->most_arguments) m->most_arguments = numbers;
}

// Returns whether a value has a step of its own.
static bool has_step(YkTapeMaker *m, YkRef value)
{
    const YkValue *v = yk_tape_value(m, value);
    if (m->uses[value] == 0 || m->is_within[value] || yk_tape_is_beside(m, value) || v->op == YK_VALUE_NUMBER ||
        v->op == YK_VALUE_LEAF)
        return false;
    if (v->op != YK_VALUE_RESULT) return true;
    bool is_first = m->tape->calls[m->of_call[v->a]].arguments == NULL; // the step of a call makes all its results
    make_call(m, v->a);
    return is_first;
}

static void make_steps(YkTapeMaker *m, bool of_parameters)
{
    YkTape *t = m->tape;
    for (YkRef v = 0; v < (YkRef)m->graph->count && !yk_arena_failed(t->arena); v++) {
        if (yk_tape_value(m, v)->of_parameters != of_parameters || !has_step(m, v)) continue;
        YkTapeStep *step = &t->steps[t->step_count];
        m->made[t->step_count++] = v;
        *step = make_step(m, v);
        if (!of_parameters) yk_tape_mark_scalars(m, step);
    }
}

// --- the tape

static bool make(YkTapeMaker *m, YkArena *work, const YkRef *leaves, const YkRef *roots)
{
    YkTape *t = m->tape;
    const YkGraph *g = m->graph;
    m->uses = YK_NEW(work, int32_t, g->count + 1);
    m->in_sums = YK_NEW(work, int32_t, g->count + 1);
    m->is_within = YK_NEW(work, bool, g->count + 1);
    m->inner = YK_NEW(work, YkRef, g->count + 1);
    if (YK_KNOWS_BLOCKS) m->spin = YK_NEW(work, YkTapeStep *, g->count + 1);
    if (YK_KNOWS_BLOCKS) m->is_beside = YK_NEW(work, bool, g->count + 1);
    m->of_call = YK_NEW(work, int32_t, g->call_count + 1);
    m->made = YK_NEW(work, YkRef, g->count + t->root_count + 1);
    t->steps = YK_NEW(t->arena, YkTapeStep, g->count + t->root_count + 1);
    t->calls = YK_NEW(t->arena, YkTapeCall, g->call_count + 1);
    if (yk_arena_failed(work) || yk_arena_failed(t->arena)) return false;
    for (size_t k = 0; k < g->call_count; k++) m->of_call[k] = YK_NONE;
    for (size_t k = 0; k < g->count; k++) m->inner[k] = YK_NONE;
    count_uses(m, roots, t->root_count);
    if (m->failed) return false;
    yk_tape_find_sums(m);
    make_steps(m, true);
    t->prelude_count = t->step_count;
    make_steps(m, false);
    t->scratch = YK_NEW(t->arena, double, m->most_arguments + 3);
    return !yk_arena_failed(t->arena) && yk_tape_turn_signs(m, work, roots) && yk_tape_order(m, work, roots) &&
           yk_tape_place(t, work, g, leaves, roots, m->made) && yk_tape_find_telling(m, work, roots) &&
           yk_tape_make_one(t, work);
}

// Makes the negatives of all numbers: see tape_signs.c.
static void negate_numbers(YkGraph *g)
{
    size_t count = g->count;
    for (size_t k = 0; YK_KNOWS_BLOCKS && k < count; k++)
        if (g->values[k].op == YK_VALUE_NUMBER) yk_graph_number(g, -g->values[k].number);
}

YkTape *yk_tape_new(YkGraph *graph, const YkRef *leaves, size_t leaf_count, const YkRef *roots, size_t root_count,
                    size_t lanes, YkTapeLaws laws)
{
    YkTape *t = calloc(1, sizeof *t);
    YkArena *work = yk_arena_new();
    if (t) t->arena = yk_arena_new();
    negate_numbers(graph);
    bool good = t && t->arena && work && !graph->failed;
    if (good) {
        t->laws = laws;
        t->lanes = lanes;
        t->leaf_count = leaf_count;
        t->root_count = root_count;
        good = make(&(YkTapeMaker){.tape = t, .graph = graph}, work, leaves, roots);
    }
    yk_arena_free(work);
    if (good) return t;
    yk_tape_free(t);
    return NULL;
}

void yk_tape_free(YkTape *t)
{
    if (!t) return;
    yk_arena_free(t->arena);
    free(t);
}

size_t yk_tape_length(const YkTape *t)
{
    return t->step_count - t->prelude_count;
}

bool yk_tape_needs(const YkTape *t, size_t leaf)
{
    return t->own_row[leaf] != NULL;
}

bool yk_tape_tells(const YkTape *t, size_t root)
{
    const double *number = t->constant[root];
    return t->tells[root] && !(number && *number - *number == 0);
}

void yk_tape_set_lanes(YkTape *t, size_t leaf, const double *lanes)
{
    t->row[leaf] = (double *)(uintptr_t)lanes; // only read
}

void yk_tape_pack_lanes(YkTape *t, size_t leaf, const double *lanes, const size_t *which, size_t n)
{
    for (size_t k = 0; k < n; k++) t->own_row[leaf][k] = lanes[which[k]];
    t->row[leaf] = t->own_row[leaf];
}

void yk_tape_set(YkTape *t, size_t leaf, double value)
{
    if (!yk_tape_needs(t, leaf)) return;
    size_t width = t->is_parameter[leaf] ? 1 : t->lanes;
    for (size_t k = 0; k < width; k++) t->own_row[leaf][k] = value;
    t->row[leaf] = t->own_row[leaf];
    double *one = yk_tape_leaf_of_one(t, leaf);
    if (one) *one = value;
}

void yk_tape_prepare(YkTape *t)
{
    yk_tape_run_steps(t, t->steps, t->prelude_count, 1);
    for (size_t k = 0; k < t->wide_count; k++) {
        double *row = t->row[t->wide[k]];
        for (size_t i = 1; i < t->lanes; i++) row[i] = row[0];
    }
    yk_tape_prepare_one(t);
}

static void run_first_lane(YkTape *t, double *const *out)
{
    for (size_t k = 0; k < t->leaf_count; k++) {
        double *one = yk_tape_leaf_of_one(t, k);
        if (one) *one = *t->row[k];
    }
    const double *const *result = yk_tape_run_one(t, NULL);
    for (size_t k = 0; k < t->root_count; k++) *out[k] = *result[k];
}

void yk_tape_run(YkTape *t, double *const *out, size_t n)
{
    if (n == 1) {
        run_first_lane(t, out);
        return;
    }
    for (size_t k = 0; k < t->root_count; k++) t->row[t->leaf_count + k] = out[k];
    yk_tape_run_steps(t, t->steps + t->prelude_count, t->step_count - t->prelude_count, n);
}
