// Joins sums and the products in them to single steps, in the order in which the graph rounds them.
#include "graph/tape_steps.h"

static bool is_sum(const YkTapeMaker *m, YkRef value)
{
    return yk_tape_value(m, value)->op == YK_VALUE_ADD || yk_tape_value(m, value)->op == YK_VALUE_SUBTRACT;
}

// Returns whether the operand of a sum is a product that nothing else needs.
static bool is_own_product(const YkTapeMaker *m, YkRef sum, YkRef operand)
{
    const YkValue *v = yk_tape_value(m, operand);
    return v->op == YK_VALUE_MULTIPLY && m->uses[operand] == 1 &&
           v->of_parameters == yk_tape_value(m, sum)->of_parameters;
}

static bool has_scalar_factor(const YkTapeMaker *m, YkRef value)
{
    const YkValue *v = yk_tape_value(m, value);
    if (v->op != YK_VALUE_MULTIPLY || v->of_parameters) return false;
    return yk_tape_value(m, v->a)->of_parameters || yk_tape_value(m, v->b)->of_parameters;
}

// A lane multiplied by a number costs a sum no more than another lane: where sums alone need such a product, each of
// them computes it.
static void find_shared_products(YkTapeMaker *m)
{
    for (YkRef v = 0; v < (YkRef)m->graph->count; v++) {
        const YkValue *sum = yk_tape_value(m, v);
        if (m->uses[v] == 0 || !is_sum(m, v)) continue;
        m->in_sums[sum->a]++;
        m->in_sums[sum->b]++;
    }
    for (YkRef v = 0; v < (YkRef)m->graph->count; v++)
        if (m->uses[v] > 0 && m->in_sums[v] == m->uses[v] && has_scalar_factor(m, v)) m->is_within[v] = true;
}

static void find_own_products(YkTapeMaker *m)
{
    for (YkRef v = 0; v < (YkRef)m->graph->count; v++) {
        if (m->uses[v] == 0 || !is_sum(m, v)) continue;
        const YkRef operands[] = {yk_tape_value(m, v)->a, yk_tape_value(m, v)->b};
        for (size_t k = 0; k < 2; k++)
            if (is_own_product(m, v, operands[k])) m->is_within[operands[k]] = true;
    }
}

// Returns whether the operand of a sum is a sum with products that nothing else needs, and has no sum within itself.
static bool is_own_sum(const YkTapeMaker *m, YkRef sum, YkRef operand)
{
    if (yk_tape_spin(m, operand) || yk_tape_is_beside(m, operand)) return false;
    return is_sum(m, operand) && m->uses[operand] == 1 && m->inner[operand] == YK_NONE &&
           yk_tape_value(m, operand)->of_parameters == yk_tape_value(m, sum)->of_parameters;
}

// Returns whether one step can do a sum with the sum within it: two products and one more term in all.
static bool can_join(const YkTapeMaker *m, YkRef sum, YkRef within, YkRef other)
{
    const YkValue *w = yk_tape_value(m, within);
    if (!is_own_sum(m, sum, within)) return false;
    if (m->is_within[w->a] && m->is_within[w->b]) return !m->is_within[other];
    bool is_chain = m->is_within[w->b] || (m->is_within[w->a] && w->op == YK_VALUE_ADD); // e + a b, e - a b
    bool is_first = yk_tape_value(m, sum)->op == YK_VALUE_ADD || yk_tape_value(m, sum)->a == within;
    return is_chain && is_first && m->is_within[other];
}

static void find_own_sums(YkTapeMaker *m)
{
    for (YkRef v = 0; v < (YkRef)m->graph->count; v++) {
        const YkValue *sum = yk_tape_value(m, v);
        if (m->uses[v] == 0 || !is_sum(m, v) || sum->a == sum->b) continue;
        if (can_join(m, v, sum->a, sum->b))
            m->inner[v] = sum->a;
        else if (can_join(m, v, sum->b, sum->a))
            m->inner[v] = sum->b;
        if (m->inner[v] != YK_NONE) m->is_within[m->inner[v]] = true;
    }
}

static YkTapeStep sum_of(const YkTapeMaker *m, const YkValue *v)
{
    bool adds = v->op == YK_VALUE_ADD;
    const YkValue *a = yk_tape_value(m, v->a), *b = yk_tape_value(m, v->b);
    if (m->is_within[v->a] && m->is_within[v->b])
        return yk_tape_step(adds ? YK_TAPE_DOT : YK_TAPE_CROSS, a->a, a->b, b->a, b->b);
    if (m->is_within[v->a])
        return yk_tape_step(adds ? YK_TAPE_PRODUCT_PLUS : YK_TAPE_PRODUCT_LESS, a->a, a->b, v->b, YK_NONE);
    if (m->is_within[v->b])
        return yk_tape_step(adds ? YK_TAPE_PRODUCT_PLUS : YK_TAPE_LESS_PRODUCT, b->a, b->b, v->a, YK_NONE);
    return yk_tape_step(adds ? YK_TAPE_ADD : YK_TAPE_SUBTRACT, v->a, v->b, YK_NONE, YK_NONE);
}

// Makes one step of a sum and the sum within it.
static YkTapeStep joined_sum(const YkTapeMaker *m, const YkValue *v, YkRef within)
{
    YkTapeStep s = sum_of(m, yk_tape_value(m, within));
    bool adds = v->op == YK_VALUE_ADD, comes_first = v->a == within;
    YkRef other = comes_first ? v->b : v->a;
    if (s.op == YK_TAPE_DOT || s.op == YK_TAPE_CROSS) {
        bool is_dot = s.op == YK_TAPE_DOT;
        s.in[4] = other;
        if (adds)
            s.op = is_dot ? YK_TAPE_PLUS_DOT : YK_TAPE_PLUS_CROSS;
        else if (comes_first)
            s.op = is_dot ? YK_TAPE_DOT_LESS : YK_TAPE_CROSS_LESS;
        else
            s.op = is_dot ? YK_TAPE_LESS_DOT : YK_TAPE_LESS_CROSS;
        return s;
    }
    bool was_plus = s.op == YK_TAPE_PRODUCT_PLUS;
    s.in[4] = s.in[2];
    s.in[2] = yk_tape_value(m, other)->a;
    s.in[3] = yk_tape_value(m, other)->b;
    s.op = was_plus ? (adds ? YK_TAPE_PLUS_PLUS : YK_TAPE_PLUS_LESS) : (adds ? YK_TAPE_LESS_PLUS : YK_TAPE_LESS_LESS);
    return s;
}

YkTapeStep yk_tape_sum(const YkTapeMaker *m, YkRef value)
{
    const YkValue *v = yk_tape_value(m, value);
    if (yk_tape_spin(m, value)) return *yk_tape_spin(m, value);
    return m->inner[value] == YK_NONE ? sum_of(m, v) : joined_sum(m, v, m->inner[value]);
}

void yk_tape_find_sums(YkTapeMaker *m)
{
    find_own_products(m);
    find_shared_products(m);
    yk_tape_find_spins(m);
    find_own_sums(m);
}
