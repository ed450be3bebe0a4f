// One lane of a tape: the same operations on single numbers, in an order in which operations of one kind stand
// together.
//
// Every value has a number of its own, so that operations may change places. Operations of one kind follow each other
// as long as some are ready, that is, wait for no other; the next kind is then that of the operation from which most
// others lead to a result, since the waiting for each other is half of the cost. A group of one kind costs one jump.
//
// Leaves that are numbers of a pose are read where they are: the operations get new addresses when the pose stands
// elsewhere.
#include "graph/tape_one.h"

typedef struct Maker {
    const YkTape *tape;
    YkTapeOne *one;
    YkTapeStep *steps; // by places
    int32_t *place;    // per row: of the value that it holds now, or YK_NONE
    bool *is_taken;    // per step
    bool *is_known;    // per place: its number is computed before the steps that remain
    size_t *order;     // steps as they run
    size_t *height;    // per step: how many follow it, each reading the one before
    int32_t *maker;    // per place: the step that makes it, or YK_NONE
    int32_t *leaf;     // per place: the leaf that stands there, or YK_NONE
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

// A step with two results is three for one lane.
static void place_spin(Maker *m, const YkTapeStep *step)
{
    int32_t x = place_of(m, step->in[0]), y = place_of(m, step->in[1]), w = place_of(m, step->in[2]);
    int32_t a = place_of(m, step->in[3]), square = new_place(m), along = new_place(m), across = new_place(m);
    const YkTapeStep three[] = {yk_tape_step(YK_TAPE_MULTIPLY, w, w, square, square),
                                yk_tape_step(YK_TAPE_DOT, x, square, y, a),
                                yk_tape_step(YK_TAPE_CROSS, x, a, y, square)};
    const int32_t out[] = {square, along, across};
    for (size_t k = 0; k < 3; k++) {
        YkTapeStep *s = &m->steps[m->step_count++];
        *s = three[k];
        s->out = s->in[4] = out[k];
    }
    m->place[step->out] = along;
    m->place[step->second] = across;
}

// A copy makes no number: its row holds the value of the other.
static void place_step(Maker *m, const YkTapeStep *step)
{
    if (step->op == YK_TAPE_COPY) {
        m->place[step->out] = place_of(m, step->in[0]);
        return;
    }
    if (yk_tape_is_spin(step)) {
        place_spin(m, step);
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

static void raise(Maker *m, int32_t place, size_t height)
{
    int32_t step = m->maker[place];
    if (step != YK_NONE && m->height[step] < height) m->height[step] = height;
}

static void find_makers(Maker *m)
{
    for (size_t k = 0; k < m->place_count; k++) m->maker[k] = YK_NONE;
    for (size_t k = 0; k < m->step_count; k++) {
        const YkTapeStep *s = &m->steps[k];
        const YkTapeCall *call = s->call == YK_NONE ? NULL : &m->one->calls[s->call];
        m->maker[s->out] = (int32_t)k;
        for (size_t i = 0; call && i < call->result_count; i++)
            if (call->results[i] != YK_NONE) m->maker[call->results[i]] = (int32_t)k;
    }
}

// Steps stand behind those that they read.
static void find_heights(Maker *m)
{
    find_makers(m);
    for (size_t k = m->step_count; k-- > 0;) {
        const YkTapeStep *s = &m->steps[k];
        const YkTapeCall *call = s->call == YK_NONE ? NULL : &m->one->calls[s->call];
        for (size_t i = 0; call && i < call->argument_count; i++) raise(m, call->arguments[i], m->height[k] + 1);
        for (size_t i = 0; !call && i < YK_TAPE_OPERANDS; i++)
            if (s->in[i] != s->out) raise(m, s->in[i], m->height[k] + 1);
    }
}

// Returns the kind of the highest step that is ready.
static YkTapeOp next_kind(const Maker *m)
{
    const YkTapeStep *best = NULL;
    size_t height = 0;
    for (size_t k = 0; k < m->step_count; k++) {
        if (m->is_taken[k] || (best && m->height[k] <= height) || !is_ready(m, &m->steps[k])) continue;
        best = &m->steps[k];
        height = m->height[k];
    }
    return best->op;
}

static void order_steps(Maker *m)
{
    find_heights(m);
    for (size_t count = 0; count < m->step_count;) {
        YkTapeOp op = next_kind(m);
        for (size_t k = 0; k < m->step_count; k++)
            if (!m->is_taken[k] && m->steps[k].op == op && is_ready(m, &m->steps[k])) take(m, k, count++);
    }
}

static void note_read(const Maker *m, int32_t place, const double **from)
{
    if (m->leaf[place] != YK_NONE) m->one->reads[m->one->read_count++] = (YkTapeRead){from, m->leaf[place]};
}

static void note_reads(const Maker *m, const YkTapeStep *s, YkTapeOperation *o)
{
    const double **const from[YK_TAPE_OPERANDS] = {&o->a, &o->b, &o->c, &o->d, &o->e};
    for (size_t k = 0; k < YK_TAPE_OPERANDS; k++) note_read(m, s->in[k], from[k]);
}

static void sort_steps(Maker *m)
{
    YkTapeOne *one = m->one;
    size_t rare = 0;
    order_steps(m);
    for (size_t k = 0; k < m->step_count; k++) {
        const YkTapeStep *s = &m->steps[m->order[k]];
        const double *const *at = (const double *const *)one->at;
        YkTapeOperation *o = &one->operations[k];
        one->at[s->out] = &o->out;
        *o = (YkTapeOperation){at[s->in[0]], at[s->in[1]], at[s->in[2]], at[s->in[3]], at[s->in[4]], .op = s->op};
        if (k > 0) o[-1].has_like = o[-1].op == s->op;
        if (s->op == YK_TAPE_RARE) one->rare[rare++] = *s;
        note_reads(m, s, o);
    }
    one->operations[m->step_count].op = YK_TAPE_END;
}

// --- the whole

static bool start(Maker *m, YkArena *work)
{
    const YkTape *t = m->tape;
    YkTapeOne *one = m->one;
    size_t steps = t->step_count - t->prelude_count + 1, results = 0, calls = 0;
    for (size_t k = t->prelude_count; k < t->step_count; k++) {
        if (yk_tape_is_spin(&t->steps[k])) steps += 2;
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
    m->height = YK_NEW(work, size_t, steps);
    m->maker = YK_NEW(work, int32_t, m->place_capacity);
    m->leaf = YK_NEW(work, int32_t, m->place_capacity);
    one->value = YK_NEW(t->arena, double, m->place_capacity);
    one->at = YK_NEW(t->arena, double *, m->place_capacity);
    one->leaf = YK_NEW(t->arena, int32_t, t->leaf_count + 1);
    one->number = YK_NEW(t->arena, size_t, t->leaf_count + 1);
    one->reads = YK_NEW(t->arena, YkTapeRead, YK_TAPE_OPERANDS * steps + t->root_count);
    one->result = YK_NEW(t->arena, const double *, t->root_count + 1);
    one->numbers = YK_NEW(t->arena, YkTapeNumber, t->row_count + 1);
    one->operations = YK_NEW(t->arena, YkTapeOperation, steps);
    one->rare = YK_NEW(t->arena, YkTapeStep, steps);
    one->calls = YK_NEW(t->arena, YkTapeCall, calls + 1);
    if (yk_arena_failed(work) || yk_arena_failed(t->arena)) return false;
    for (size_t k = 0; k < m->place_capacity; k++) one->at[k] = &one->value[k];
    for (size_t k = 0; k < t->row_count; k++) m->place[k] = YK_NONE;
    for (size_t k = 0; k < t->leaf_count; k++) one->leaf[k] = YK_NONE, one->number[k] = YK_TAPE_OWN;
    return true;
}

bool yk_tape_make_one(YkTape *t, YkArena *work)
{
    t->one = YK_NEW(t->arena, YkTapeOne, 1);
    if (!t->one) return false;
    Maker m = {.tape = t, .one = t->one};
    if (!start(&m, work)) return false;
    for (size_t k = t->prelude_count; k < t->step_count; k++) place_step(&m, &t->steps[k]);
    for (size_t k = 0; k < t->root_count; k++) place_of(&m, (int32_t)(t->leaf_count + k));
    if (yk_arena_failed(t->arena)) return false;
    for (size_t k = 0; k < m.place_count; k++) m.leaf[k] = YK_NONE;
    for (size_t k = 0; k < t->leaf_count; k++)
        if (t->one->leaf[k] != YK_NONE) m.leaf[t->one->leaf[k]] = (int32_t)k;
    sort_steps(&m);
    for (size_t k = 0; k < t->root_count; k++) {
        int32_t place = m.place[t->leaf_count + k];
        t->one->result[k] = t->one->at[place];
        note_read(&m, place, &t->one->result[k]);
    }
    yk_tape_prepare_one(t);
    return true;
}

double *yk_tape_leaf_of_one(YkTape *t, size_t leaf)
{
    return t->one->leaf[leaf] == YK_NONE ? NULL : &t->one->value[t->one->leaf[leaf]];
}

void yk_tape_read_number(YkTape *t, size_t leaf, size_t number)
{
    t->one->number[leaf] = number;
}

void yk_tape_read_pose(YkTape *t, const double *pose)
{
    YkTapeOne *one = t->one;
    one->pose = pose;
    for (size_t k = 0; k < t->leaf_count; k++) {
        if (one->leaf[k] == YK_NONE || one->number[k] == YK_TAPE_OWN) continue;
        const double *at = pose ? pose + one->number[k] : &one->value[one->leaf[k]];
        one->at[one->leaf[k]] = (double *)(uintptr_t)at; // only read
    }
    for (const YkTapeRead *r = one->reads, *end = r + one->read_count; r < end; r++)
        *r->from = one->at[one->leaf[r->leaf]];
}

void yk_tape_prepare_one(YkTape *t)
{
    const YkTapeOne *one = t->one;
    for (size_t k = 0; k < one->number_count; k++) one->value[one->numbers[k].place] = t->row[one->numbers[k].row][0];
}
