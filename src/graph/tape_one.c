// One lane of a tape: the same operations on single numbers, in an order in which operations of one kind stand together.
//
// Every value has a number of its own, so that operations may change places. Operations of one kind follow each other as
// long as some are ready, that is, wait for no other; the next kind is then the one with the most operations ready. A
// group of one kind costs one jump.
#include "graph/tape_one.h"

typedef struct Maker {
    const YkTape *tape;
    YkTapeOne *one;
    YkTapeStep *steps; // by places
    int32_t *place;    // per row: of the value that it holds now, or YK_NONE
    bool *is_taken;    // per step
    bool *is_known;    // per place: its number is computed before the steps that remain
    size_t *order;     // steps as they run
    size_t step_count, place_count, place_capacity;
} Maker;

// --- places

static int32_t new_place(Maker *m)
{
    return (int32_t)m->place_count++;
}

// Returns the place of the value that a row holds; constants and leaves get theirs when they are first read.
static int32_t place_of(Maker *m, int32_t row)
{
    YkTapeOne *one = m->one;
    if (m->place[row] != YK_NONE) return m->place[row];
    m->place[row] = new_place(m);
    m->is_known[m->place[row]] = true;
    if ((size_t)row < m->tape->leaf_count)
        one->leaf[row] = m->place[row];
    else
        one->numbers[one->number_count++] = (YkTapeNumber){row, m->place[row]};
    return m->place[row];
}

static void place_call(Maker *m, YkTapeStep *s)
{
    const YkTapeCall *call = &m->tape->calls[s->call];
    YkTapeCall *own = &m->one->calls[s->call];
    YkArena *arena = m->tape->arena;
    *own = *call;
    own->arguments = YK_NEW(arena, int32_t, call->argument_count + 1);
    own->results = YK_NEW(arena, int32_t, call->result_count + 1);
    if (yk_arena_failed(arena)) return;
    for (size_t k = 0; k < YK_TAPE_OPERANDS; k++) s->in[k] = 0; // not read
    for (size_t k = 0; k < call->argument_count; k++) own->arguments[k] = place_of(m, call->arguments[k]);
    for (size_t k = 0; k < call->result_count; k++) {
        own->results[k] = call->results[k] == YK_NONE ? YK_NONE : new_place(m);
        if (own->results[k] != YK_NONE) s->out = m->place[call->results[k]] = own->results[k];
    }
}

// Operands that an operation does not read name the row of its result.
static void place_operands(Maker *m, YkTapeStep *s)
{
    int32_t row = s->out;
    bool is_read[YK_TAPE_OPERANDS];
    for (size_t k = 0; k < YK_TAPE_OPERANDS; k++) {
        is_read[k] = s->in[k] != row;
        if (is_read[k]) s->in[k] = place_of(m, s->in[k]);
    }
    s->out = m->place[row] = new_place(m);
    for (size_t k = 0; k < YK_TAPE_OPERANDS; k++)
        if (!is_read[k]) s->in[k] = s->out;
}

// A copy makes no number: its row holds the value of the other.
static void place_step(Maker *m, const YkTapeStep *step)
{
    if (step->op == YK_TAPE_COPY) {
        m->place[step->out] = place_of(m, step->in[0]);
        return;
    }
    YkTapeStep *s = &m->steps[m->step_count];
    *s = *step;
    if (s->call != YK_NONE)
        place_call(m, s);
    else
        place_operands(m, s);
    m->step_count++;
}

// --- groups

// Returns whether nothing that a step reads is still to be made. A step that reads less names its own result.
static bool is_ready(const Maker *m, const YkTapeStep *s)
{
    const YkTapeCall *call = s->call == YK_NONE ? NULL : &m->one->calls[s->call];
    for (size_t k = 0; call && k < call->argument_count; k++)
        if (!m->is_known[call->arguments[k]]) return false;
    for (size_t k = 0; !call && k < YK_TAPE_OPERANDS; k++)
        if (s->in[k] != s->out && !m->is_known[s->in[k]]) return false;
    return true;
}

static void take(Maker *m, size_t step, size_t at)
{
    const YkTapeStep *s = &m->steps[step];
    const YkTapeCall *call = s->call == YK_NONE ? NULL : &m->one->calls[s->call];
    m->is_taken[step] = true;
    m->order[at] = step;
    m->is_known[s->out] = true;
    for (size_t k = 0; call && k < call->result_count; k++)
        if (call->results[k] != YK_NONE) m->is_known[call->results[k]] = true;
}

// Returns the kind of which most steps are ready.
static YkTapeOp largest_kind(const Maker *m)
{
    size_t ready[YK_TAPE_COPY + 1] = {0}, best = 0;
    for (size_t k = 0; k < m->step_count; k++)
        if (!m->is_taken[k] && is_ready(m, &m->steps[k])) ready[m->steps[k].op]++;
    for (size_t op = 1; op <= YK_TAPE_COPY; op++)
        if (ready[op] > ready[best]) best = op;
    return (YkTapeOp)best;
}

static void order_steps(Maker *m)
{
    for (size_t count = 0; count < m->step_count;) {
        YkTapeOp op = largest_kind(m);
        for (size_t k = 0; k < m->step_count; k++)
            if (!m->is_taken[k] && m->steps[k].op == op && is_ready(m, &m->steps[k])) take(m, k, count++);
    }
}

static void add_to_groups(YkTapeOne *one, YkTapeOp op, const YkTapeOperation *end)
{
    if (one->group_count == 0 || one->groups[one->group_count - 1].op != op) one->group_count++;
    one->groups[one->group_count - 1] = (YkTapeGroup){end, op};
}

static void sort_steps(Maker *m)
{
    YkTapeOne *one = m->one;
    size_t rare = 0;
    order_steps(m);
    for (size_t k = 0; k < m->step_count; k++) {
        const YkTapeStep *s = &m->steps[m->order[k]];
        const double *const *at = (const double *const *)one->at;
        one->operations[k] =
            (YkTapeOperation){at[s->in[0]], at[s->in[1]], at[s->in[2]], at[s->in[3]], at[s->in[4]], one->at[s->out]};
        if (s->op == YK_TAPE_RARE) one->rare[rare++] = *s;
        add_to_groups(one, s->op, &one->operations[k + 1]);
    }
}

// --- the whole

static bool start(Maker *m, YkArena *work)
{
    const YkTape *t = m->tape;
    YkTapeOne *one = m->one;
    size_t steps = t->step_count - t->prelude_count + 1, results = 0, calls = 0;
    for (size_t k = t->prelude_count; k < t->step_count; k++) {
        if (t->steps[k].call == YK_NONE) continue;
        results += t->calls[t->steps[k].call].result_count;
        if ((size_t)t->steps[k].call >= calls) calls = (size_t)t->steps[k].call + 1;
    }
    m->place_capacity = t->row_count + steps + results;
    m->steps = YK_NEW(work, YkTapeStep, steps);
    m->order = YK_NEW(work, size_t, steps);
    m->is_taken = YK_NEW(work, bool, steps);
    m->place = YK_NEW(work, int32_t, t->row_count + 1);
    m->is_known = YK_NEW(work, bool, m->place_capacity);
    one->value = YK_NEW(t->arena, double, m->place_capacity);
    one->at = YK_NEW(t->arena, double *, m->place_capacity);
    one->leaf = YK_NEW(t->arena, int32_t, t->leaf_count + 1);
    one->result = YK_NEW(t->arena, const double *, t->root_count + 1);
    one->numbers = YK_NEW(t->arena, YkTapeNumber, t->row_count + 1);
    one->operations = YK_NEW(t->arena, YkTapeOperation, steps);
    one->groups = YK_NEW(t->arena, YkTapeGroup, steps);
    one->rare = YK_NEW(t->arena, YkTapeStep, steps);
    one->calls = YK_NEW(t->arena, YkTapeCall, calls + 1);
    if (yk_arena_failed(work) || yk_arena_failed(t->arena)) return false;
    for (size_t k = 0; k < m->place_capacity; k++) one->at[k] = &one->value[k];
    for (size_t k = 0; k < t->row_count; k++) m->place[k] = YK_NONE;
    for (size_t k = 0; k < t->leaf_count; k++) one->leaf[k] = YK_NONE;
    return true;
}

bool yk_tape_make_one(YkTape *t, YkArena *work)
{
    t->one = YK_NEW(t->arena, YkTapeOne, 1);
    if (!t->one) return false;
    Maker m = {.tape = t, .one = t->one};
    if (!start(&m, work)) return false;
    for (size_t k = t->prelude_count; k < t->step_count; k++) place_step(&m, &t->steps[k]);
    for (size_t k = 0; k < t->root_count; k++)
        t->one->result[k] = &t->one->value[place_of(&m, (int32_t)(t->leaf_count + k))];
    if (yk_arena_failed(t->arena)) return false;
    sort_steps(&m);
    yk_tape_prepare_one(t);
    return true;
}

double *yk_tape_leaf_of_one(YkTape *t, size_t leaf)
{
    return t->one->leaf[leaf] == YK_NONE ? NULL : &t->one->value[t->one->leaf[leaf]];
}

void yk_tape_prepare_one(YkTape *t)
{
    const YkTapeOne *one = t->one;
    for (size_t k = 0; k < one->number_count; k++) one->value[one->numbers[k].place] = t->row[one->numbers[k].row][0];
}
