// Puts the steps of a pose into an order in which few values wait: each is made shortly before it is read, so that its
// row is free again soon and the rows in use stay in the first-level cache.
#include <string.h>
#include "graph/tape_steps.h"

typedef struct Order {
    const YkTapeMaker *maker;
    const YkTapeStep *steps; // in the order of the graph
    int32_t *step_of;        // per value: the step that makes it, or YK_NONE
    size_t *stack;
    bool *is_open, *is_done; // per step
    YkTapeStep *ordered;
    YkRef *made;
    size_t count;
} Order;

static int32_t step_of(const Order *o, YkRef value)
{
    return value == YK_NONE ? YK_NONE : o->step_of[value];
}

// Puts the steps that make what a step reads on the stack. Returns their new count.
static size_t push_operands(const Order *o, size_t step, size_t top)
{
    const YkTapeStep *s = &o->steps[step];
    const YkTapeCall *call = s->call == YK_NONE ? NULL : &o->maker->tape->calls[s->call];
    for (size_t k = call ? call->argument_count : 0; k-- > 0;) {
        int32_t of = step_of(o, call->arguments[k]);
        if (of != YK_NONE && !o->is_done[of]) o->stack[top++] = (size_t)of;
    }
    for (size_t k = YK_TAPE_OPERANDS; k-- > 0;) {
        int32_t of = step_of(o, s->in[k]);
        if (of != YK_NONE && !o->is_done[of]) o->stack[top++] = (size_t)of;
    }
    return top;
}

// Emits a step after all that it needs.
static void emit(Order *o, size_t step)
{
    size_t top = 0;
    o->stack[top++] = step;
    while (top > 0) {
        size_t at = o->stack[top - 1];
        if (!o->is_done[at] && !o->is_open[at]) {
            o->is_open[at] = true;
            top = push_operands(o, at, top);
            continue;
        }
        top--;
        if (o->is_done[at]) continue;
        o->is_done[at] = true;
        o->made[o->count] = o->maker->made[at];
        o->ordered[o->count++] = o->steps[at];
    }
}

static void find_makers(const Order *o, size_t from, size_t to)
{
    const YkTapeMaker *m = o->maker;
    for (size_t k = 0; k < m->graph->count; k++) o->step_of[k] = YK_NONE;
    for (size_t s = from; s < to; s++) {
        const YkTapeStep *step = &o->steps[s];
        o->step_of[m->made[s]] = (int32_t)s;
        if (yk_tape_is_spin(step)) o->step_of[step->second] = (int32_t)s;
        if (step->call == YK_NONE) continue;
        const YkTapeCall *call = &m->tape->calls[step->call];
        for (size_t k = 0; k < call->result_count; k++)
            if (call->results[k] != YK_NONE) o->step_of[call->results[k]] = (int32_t)s;
    }
}

static size_t count_operands(const YkTape *t)
{
    size_t count = 1;
    for (size_t s = 0; s < t->step_count; s++) {
        const YkTapeStep *step = &t->steps[s];
        count += YK_TAPE_OPERANDS + 1;
        if (step->call != YK_NONE) count += t->calls[step->call].argument_count;
    }
    return count;
}

bool yk_tape_order(YkTapeMaker *m, YkArena *work, const YkRef *roots)
{
    YkTape *t = m->tape;
    size_t from = t->prelude_count, count = t->step_count;
    Order o = {.maker = m, .steps = t->steps};
    o.step_of = YK_NEW(work, int32_t, m->graph->count + 1);
    o.stack = YK_NEW(work, size_t, count_operands(t));
    o.is_open = YK_NEW(work, bool, count + 1);
    o.is_done = YK_NEW(work, bool, count + 1);
    o.ordered = YK_NEW(work, YkTapeStep, count + 1);
    o.made = YK_NEW(work, YkRef, count + 1);
    if (yk_arena_failed(work)) return false;
    find_makers(&o, from, count);
    for (size_t k = 0; k < t->root_count; k++)
        if (o.step_of[roots[k]] != YK_NONE) emit(&o, (size_t)o.step_of[roots[k]]);
    memcpy(t->steps + from, o.ordered, o.count * sizeof *o.ordered);
    memcpy(m->made + from, o.made, o.count * sizeof *o.made);
    t->step_count = from + o.count;
    return true;
}
