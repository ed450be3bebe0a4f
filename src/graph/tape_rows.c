// Gives the values of a tape their rows: a row is reused once its value is no longer needed.
#include "graph/tape_steps.h"

enum { APART = 8 }; // numbers between rows, so that they do not compete for the same cache lines

typedef struct Placer {
    YkTape *tape;
    const YkGraph *graph;
    int32_t *row;    // per value, or YK_NONE
    int32_t *last;   // per value: the last step that reads it; YK_NONE: its row is never free
    bool *is_wide;   // per value that depends on parameters alone: a step of a pose reads it lane by lane
    int32_t *vacant; // rows that are free, a stack
    size_t vacant_count, own_count;
} Placer;

static int32_t new_row(Placer *p)
{
    return (int32_t)(p->tape->leaf_count + p->tape->root_count + p->own_count++);
}

// --- the last step that reads each value

// Calls a function for every place in a step that names a value it reads.
static void each_operand(Placer *p, YkTapeStep *s, int32_t step, void (*visit)(Placer *p, int32_t *value, int32_t step))
{
    for (size_t k = 0; k < YK_TAPE_OPERANDS; k++)
        if (s->in[k] != YK_NONE) visit(p, &s->in[k], step);
    if (s->call == YK_NONE) return;
    YkTapeCall *call = &p->tape->calls[s->call];
    for (size_t k = 0; k < call->argument_count; k++) visit(p, &call->arguments[k], step);
}

static void note_reader(Placer *p, int32_t *value, int32_t step)
{
    if (p->row[*value] == YK_NONE) p->last[*value] = step;
}

// --- rows

static void leave(Placer *p, int32_t *value, int32_t step)
{
    if (p->last[*value] == step) {
        p->vacant[p->vacant_count++] = p->row[*value];
        p->last[*value] = YK_NONE; // a step may read it twice
    }
}

static void take_row_of(Placer *p, int32_t *value, int32_t step)
{
    (void)step;
    *value = p->row[*value];
}

static int32_t row_for(Placer *p, YkRef value)
{
    if (p->row[value] == YK_NONE) p->row[value] = p->vacant_count > 0 ? p->vacant[--p->vacant_count] : new_row(p);
    return p->row[value];
}

// A result gets its row before those of the operands are free, so that it is none of them.
static void place_step(Placer *p, YkTapeStep *s, YkRef made, int32_t step)
{
    if (s->call == YK_NONE) {
        s->out = row_for(p, made);
        if (yk_tape_is_spin(s)) s->second = row_for(p, s->second);
    } else {
        YkTapeCall *call = &p->tape->calls[s->call];
        for (size_t k = 0; k < call->result_count; k++)
            if (call->results[k] != YK_NONE) s->out = call->results[k] = row_for(p, call->results[k]);
    }
    each_operand(p, s, step, leave);
    each_operand(p, s, step, take_row_of);
    for (size_t k = 0; k < YK_TAPE_OPERANDS; k++)
        if (s->in[k] == YK_NONE) s->in[k] = s->out; // not read
}

// Returns whether a step of a pose computes the value.
static bool is_of_pose(const Placer *p, YkRef value)
{
    const YkValue *v = &p->graph->values[value];
    return !v->of_parameters && v->op != YK_VALUE_LEAF;
}

// Rows that stay: numbers, leaves, what depends on parameters alone, roots.
static void place_lasting(Placer *p, const YkRef *leaves, const YkRef *roots)
{
    const YkTape *t = p->tape;
    for (size_t k = 0; k < p->graph->count; k++) p->row[k] = p->last[k] = YK_NONE;
    for (size_t k = 0; k < t->leaf_count; k++) p->row[leaves[k]] = (int32_t)k;
    for (size_t k = 0; k < t->root_count; k++)
        if (is_of_pose(p, roots[k]) && p->row[roots[k]] == YK_NONE) p->row[roots[k]] = (int32_t)(t->leaf_count + k);
}

static void place_constant(Placer *p, int32_t *value, int32_t step)
{
    (void)step;
    const YkValue *v = &p->graph->values[*value];
    if (v->of_parameters && v->op != YK_VALUE_LEAF && p->row[*value] == YK_NONE) p->row[*value] = new_row(p);
}

// Notes which values of parameters a step of a pose reads lane by lane.
static void note_wide(Placer *p, const YkTapeStep *s)
{
    for (int32_t k = 0; k < YK_TAPE_OPERANDS; k++)
        if (s->in[k] != YK_NONE && yk_tape_reads_lanes(s, k)) p->is_wide[s->in[k]] = true;
    if (s->call == YK_NONE) return;
    const YkTapeCall *call = &p->tape->calls[s->call];
    for (size_t k = 0; k < call->argument_count; k++) p->is_wide[call->arguments[k]] = true;
}

// Adds steps for roots that no step computes in their own rows.
static void copy_roots(Placer *p, const YkRef *roots)
{
    YkTape *t = p->tape;
    for (size_t k = 0; k < t->root_count; k++) {
        int32_t out = (int32_t)(t->leaf_count + k);
        if (p->row[roots[k]] == out) continue;
        place_constant(p, &(int32_t){roots[k]}, 0);
        t->steps[t->step_count++] = (YkTapeStep){.op = YK_TAPE_COPY,
                                                 .scalars = p->graph->values[roots[k]].of_parameters,
                                                 .out = out,
                                                 .in = {p->row[roots[k]], out, out, out, out},
                                                 .call = YK_NONE};
    }
}

// --- memory

// Returns how many numbers a row holds, with those that keep it apart from the next one.
static size_t room_of(const Placer *p, bool is_single)
{
    return is_single ? 1 : p->tape->lanes + APART;
}

// Marks the rows that hold one number for all lanes.
static void find_single(const Placer *p, bool *is_single)
{
    for (size_t v = 0; v < p->graph->count; v++)
        if (p->row[v] != YK_NONE && p->graph->values[v].of_parameters) is_single[p->row[v]] = !p->is_wide[v];
}

static bool is_own(const YkTape *t, size_t row, const bool *is_needed)
{
    return row < t->leaf_count ? is_needed[row] : row >= t->leaf_count + t->root_count;
}

// Rows of lanes begin at cache lines; single numbers follow them side by side.
static bool make_memory(Placer *p, const bool *is_needed, const bool *is_single)
{
    YkTape *t = p->tape;
    size_t room = 8;
    for (size_t k = 0; k < t->row_count; k++) room += is_own(t, k, is_needed) ? room_of(p, is_single[k]) : 0;
    double *numbers = YK_NEW(t->arena, double, room);
    if (!numbers) return false;
    numbers = (double *)(((uintptr_t)numbers + 63) & ~(uintptr_t)63);
    for (int singles = 0; singles < 2; singles++)
        for (size_t k = 0; k < t->row_count; k++) {
            if (!is_own(t, k, is_needed) || is_single[k] != singles) continue;
            t->row[k] = numbers;
            numbers += room_of(p, singles);
        }
    return true;
}

// Fills the rows of numbers, and lists those of parameters that have to be filled for every set of them.
static void fill_numbers(const Placer *p)
{
    YkTape *t = p->tape;
    for (size_t v = 0; v < p->graph->count; v++) {
        const YkValue *value = &p->graph->values[v];
        if (p->row[v] == YK_NONE || !value->of_parameters) continue;
        if (value->op != YK_VALUE_NUMBER) {
            if (p->is_wide[v]) t->wide[t->wide_count++] = p->row[v];
            continue;
        }
        size_t width = p->is_wide[v] ? t->lanes : 1;
        for (size_t k = 0; k < width; k++) t->row[p->row[v]][k] = value->number;
    }
}

// Roots that are copied from one number are the same in all lanes.
static void find_constants(YkTape *t)
{
    for (size_t k = t->prelude_count; k < t->step_count; k++)
        if (t->steps[k].op == YK_TAPE_COPY && t->steps[k].scalars)
            t->constant[(size_t)t->steps[k].out - t->leaf_count] = t->row[t->steps[k].in[0]];
}

static bool make_rows(Placer *p, const bool *is_needed)
{
    YkTape *t = p->tape;
    t->row_count = t->leaf_count + t->root_count + p->own_count;
    t->row = YK_NEW(t->arena, double *, t->row_count + 1);
    t->own_row = YK_NEW(t->arena, double *, t->leaf_count + 1);
    t->constant = YK_NEW(t->arena, const double *, t->root_count + 1);
    t->wide = YK_NEW(t->arena, int32_t, t->row_count + 1);
    bool *is_single = YK_NEW(t->arena, bool, t->row_count + 1);
    if (yk_arena_failed(t->arena)) return false;
    find_single(p, is_single);
    if (!make_memory(p, is_needed, is_single)) return false;
    for (size_t k = 0; k < t->leaf_count; k++) t->own_row[k] = t->row[k];
    find_constants(t);
    fill_numbers(p);
    return true;
}

// Marks the leaves that steps read; by now steps name rows.
static void find_needed(const YkTape *t, bool *is_needed)
{
    for (size_t s = 0; s < t->step_count; s++) {
        const YkTapeStep *step = &t->steps[s];
        for (size_t k = 0; k < YK_TAPE_OPERANDS; k++)
            if ((size_t)step->in[k] < t->leaf_count) is_needed[step->in[k]] = true;
        for (size_t k = 0; step->call != YK_NONE && k < t->calls[step->call].argument_count; k++)
            if ((size_t)t->calls[step->call].arguments[k] < t->leaf_count)
                is_needed[t->calls[step->call].arguments[k]] = true;
    }
}

// Returns whether every leaf that is read, or is a root, has been promised a value.
static bool has_all_leaves(const Placer *p, const YkRef *roots)
{
    for (size_t k = 0; k < p->tape->root_count; k++)
        if (p->graph->values[roots[k]].op == YK_VALUE_LEAF && p->row[roots[k]] == YK_NONE) return false;
    for (size_t v = 0; v < p->graph->count; v++)
        if (p->graph->values[v].op == YK_VALUE_LEAF && p->row[v] == YK_NONE && p->last[v] != YK_NONE) return false;
    return true;
}

bool yk_tape_place(YkTape *t, YkArena *work, const YkGraph *graph, const YkRef *leaves, const YkRef *roots,
                   const YkRef *made)
{
    size_t values = graph->count + 1;
    Placer p = {.tape = t, .graph = graph};
    p.row = YK_NEW(work, int32_t, values);
    p.last = YK_NEW(work, int32_t, values);
    p.vacant = YK_NEW(work, int32_t, values);
    p.is_wide = YK_NEW(work, bool, values);
    t->is_parameter = YK_NEW(t->arena, bool, t->leaf_count + 1);
    bool *is_needed = YK_NEW(work, bool, t->leaf_count + 1);
    if (yk_arena_failed(work) || yk_arena_failed(t->arena)) return false;
    for (size_t k = 0; k < t->leaf_count; k++) t->is_parameter[k] = graph->values[leaves[k]].of_parameters;
    place_lasting(&p, leaves, roots);
    for (size_t s = 0; s < t->step_count; s++) {
        each_operand(&p, &t->steps[s], (int32_t)s, place_constant);
        if (s < t->prelude_count) place_constant(&p, &(int32_t){made[s]}, 0);
        each_operand(&p, &t->steps[s], (int32_t)s, note_reader);
        if (s >= t->prelude_count) note_wide(&p, &t->steps[s]);
    }
    if (!has_all_leaves(&p, roots)) return false;
    for (size_t s = 0; s < t->step_count; s++) place_step(&p, &t->steps[s], made[s], (int32_t)s);
    copy_roots(&p, roots);
    find_needed(t, is_needed);
    return make_rows(&p, is_needed);
}
