// Finds the roots that decide whether all roots are finite.
//
// A value that is not finite makes every sum and product that reads it not finite, and every quotient of which it is
// the numerator. If such a root is finite, so is everything that it is made of.
#include "graph/tape_steps.h"

static void show_operands(const YkValue *v, bool *is_shown)
{
    bool has_two = v->op == YK_VALUE_ADD || v->op == YK_VALUE_SUBTRACT || v->op == YK_VALUE_MULTIPLY;
    bool has_one = v->op == YK_VALUE_DIVIDE || v->op == YK_VALUE_MINUS || v->op == YK_VALUE_SIZE;
    if (has_one || has_two) is_shown[v->a] = true;
    if (has_two) is_shown[v->b] = true;
}

bool yk_tape_find_telling(YkTapeMaker *m, YkArena *work, const YkRef *roots)
{
    YkTape *t = m->tape;
    size_t *root = YK_NEW(work, size_t, m->graph->count + 1); // per value: 1 + a root that it is
    bool *is_shown = YK_NEW(work, bool, m->graph->count + 1); // per value: roots that decide are made of it
    t->tells = YK_NEW(t->arena, bool, t->root_count + 1);
    if (yk_arena_failed(work) || yk_arena_failed(t->arena)) return false;
    for (size_t k = 0; k < t->root_count; k++) root[roots[k]] = k + 1;
    for (YkRef v = (YkRef)m->graph->count - 1; v >= 0; v--) {
        const YkValue *value = yk_tape_value(m, v);
        if (root[v] && !is_shown[v] && value->op != YK_VALUE_MINUS) t->tells[root[v] - 1] = is_shown[v] = true;
        if (is_shown[v]) show_operands(value, is_shown);
    }
    for (size_t k = 0; k < t->root_count; k++) { // a value that is only turned round decides if nothing else does
        const YkValue *value = yk_tape_value(m, roots[k]);
        if (value->op != YK_VALUE_MINUS || is_shown[roots[k]] || is_shown[value->a]) continue;
        t->tells[k] = is_shown[value->a] = true;
    }
    return true;
}
