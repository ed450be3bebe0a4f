// Joins the components of a turning vector's acceleration, x w^2 + y a and x a - y w^2, to one step with two results.
// Every body has such a pair; its four factors are read once. If lanes are not vectors, nothing would be gained.
#include "graph/tape_steps.h"

// Returns whether a sum has a step of its own, with two products and nothing else.
static bool is_free(const YkTapeMaker *m, YkRef sum)
{
    const YkValue *v = yk_tape_value(m, sum);
    return m->uses[sum] > 0 && !v->of_parameters && !yk_tape_is_beside(m, sum) && m->is_within[v->a] &&
           m->is_within[v->b];
}

static bool is_square(const YkTapeMaker *m, YkRef value)
{
    const YkValue *v = yk_tape_value(m, value);
    return v->op == YK_VALUE_MULTIPLY && v->a == v->b && !v->of_parameters;
}

static YkRef product_of(const YkTapeMaker *m, YkRef a, YkRef b)
{
    YkRef found = yk_graph_find(m->graph, (YkValue){.op = YK_VALUE_MULTIPLY, .a = a, .b = b, .c = YK_NONE});
    if (found != YK_NONE) return found;
    return yk_graph_find(m->graph, (YkValue){.op = YK_VALUE_MULTIPLY, .a = b, .b = a, .c = YK_NONE});
}

// Returns x a - y square, if a step of its own computes it; YK_NONE otherwise.
static YkRef across(const YkTapeMaker *m, YkRef x, YkRef a, YkRef y, YkRef square)
{
    YkRef p = product_of(m, x, a), q = product_of(m, y, square);
    if (p == YK_NONE || q == YK_NONE) return YK_NONE;
    YkRef sum = yk_graph_find(m->graph, (YkValue){.op = YK_VALUE_SUBTRACT, .a = p, .b = q, .c = YK_NONE});
    return sum != YK_NONE && is_free(m, sum) ? sum : YK_NONE;
}

// Joins x square + y a with its other half, if there is one. The square needs no step if nothing else reads it.
static bool join(YkTapeMaker *m, YkRef sum, YkRef x, YkRef square, YkRef y, YkRef a)
{
    YkRef other = is_square(m, square) ? across(m, x, a, y, square) : YK_NONE;
    YkTapeStep *step = other == YK_NONE ? NULL : YK_NEW(m->tape->arena, YkTapeStep, 1);
    if (!step) return false;
    *step = yk_tape_step(YK_TAPE_SPIN, x, y, yk_tape_value(m, square)->a, a);
    step->second = other;
    m->spin[sum] = step;
    m->is_beside[other] = true;
    bool is_own = m->uses[product_of(m, x, square)] == 1 && m->uses[product_of(m, y, square)] == 1;
    if (is_own && m->uses[square] == 2) m->is_beside[square] = true;
    return true;
}

void yk_tape_find_spins(YkTapeMaker *m)
{
    for (YkRef v = 0; YK_KNOWS_BLOCKS && v < (YkRef)m->graph->count; v++) {
        if (yk_tape_value(m, v)->op != YK_VALUE_ADD || !is_free(m, v)) continue;
        const YkValue *p = yk_tape_value(m, yk_tape_value(m, v)->a), *q = yk_tape_value(m, yk_tape_value(m, v)->b);
        const YkRef factor[] = {p->a, p->b, q->a, q->b};
        for (size_t k = 0; k < 4; k++) { // any of them may be the square; of the other product, either the change
            YkRef x = factor[k ^ 1], square = factor[k], y = factor[k ^ 2], a = factor[k ^ 3];
            if (join(m, v, x, square, y, a) || join(m, v, x, square, a, y)) break;
        }
    }
}
