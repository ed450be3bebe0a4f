// Leaves out steps that only turn a sign round: the step of the value computes its negative instead, and what reads the
// value takes the negative with the other sign. Nothing is rounded in another way. Forces that both sides of a joint
// name are full of them.
#include <string.h>
#include "graph/tape_steps.h"

typedef enum Kind { // terms with signs: a step is their sum
    SUM,            // a, b
    ONE,            // a b, c
    TWO,            // a b, c d
    WITH,           // a b and c d first, then e
    CHAIN,          // e and a b first, then c d
    ALONE           // a b or a / b
} Kind;

typedef struct Form {
    YkTapeOp op;
    Kind kind;
    int sign[3]; // of its terms
} Form;

static const Form forms[] = {
    {YK_TAPE_ADD, SUM, {1, 1, 0}},           {YK_TAPE_SUBTRACT, SUM, {1, -1, 0}},
    {YK_TAPE_PRODUCT_PLUS, ONE, {1, 1, 0}},  {YK_TAPE_PRODUCT_LESS, ONE, {1, -1, 0}},
    {YK_TAPE_LESS_PRODUCT, ONE, {-1, 1, 0}}, {YK_TAPE_DOT, TWO, {1, 1, 0}},
    {YK_TAPE_CROSS, TWO, {1, -1, 0}},        {YK_TAPE_PLUS_DOT, WITH, {1, 1, 1}},
    {YK_TAPE_LESS_DOT, WITH, {-1, -1, 1}},   {YK_TAPE_DOT_LESS, WITH, {1, 1, -1}},
    {YK_TAPE_PLUS_CROSS, WITH, {1, -1, 1}},  {YK_TAPE_LESS_CROSS, WITH, {-1, 1, 1}},
    {YK_TAPE_CROSS_LESS, WITH, {1, -1, -1}}, {YK_TAPE_PLUS_PLUS, CHAIN, {1, 1, 1}},
    {YK_TAPE_PLUS_LESS, CHAIN, {1, -1, 1}},  {YK_TAPE_LESS_PLUS, CHAIN, {-1, 1, 1}},
    {YK_TAPE_LESS_LESS, CHAIN, {-1, -1, 1}}, {YK_TAPE_MULTIPLY, ALONE, {1, 0, 0}},
    {YK_TAPE_DIVIDE, ALONE, {1, 0, 0}},
};
enum { FORMS = sizeof forms / sizeof *forms };

static const Form *form_of(const YkTapeStep *s)
{
    for (size_t k = 0; k < FORMS; k++)
        if (forms[k].op == s->op) return &forms[k];
    return NULL;
}

// Returns the term in which an operand stands.
static size_t term_of(Kind kind, size_t operand)
{
    if (kind == SUM) return operand;
    return operand == 4 ? 2 : operand / 2;
}

// Turns round the sign of a product by that of a number in it. Returns false if it has none.
static bool turn_number(const YkTapeMaker *m, YkTapeStep *s, size_t first)
{
    for (size_t k = first; k < first + (s->op == YK_TAPE_DIVIDE ? 1 : 2); k++) {
        const YkValue *v = yk_tape_value(m, s->in[k]);
        if (v->op != YK_VALUE_NUMBER || v->number == 0) continue;
        YkValue negative = *v;
        negative.number = -v->number;
        YkRef found = yk_graph_find(m->graph, negative);
        if (found != YK_NONE) s->in[k] = found;
        return found != YK_NONE;
    }
    return false;
}

static void swap_terms(YkTapeStep *s, Kind kind)
{
    size_t width = kind == SUM ? 1 : 2;
    for (size_t k = 0; k < width; k++) {
        YkRef kept = s->in[k];
        s->in[k] = s->in[width + k];
        s->in[width + k] = kept;
    }
}

// Gives a step an operation with these signs, if there is one with its terms in this order or, where they may change
// places, in the other one.
static bool choose_op(const YkTapeMaker *m, YkTapeStep *s, Kind kind, const int *sign)
{
    bool may_swap = kind == SUM || kind == TWO || kind == WITH;
    for (int swaps = 0; swaps <= (may_swap ? 1 : 0); swaps++)
        for (size_t k = 0; k < FORMS; k++) {
            const Form *f = &forms[k];
            if (f->kind != kind || f->sign[0] != sign[swaps] || (kind == ALONE && f->op != s->op)) continue;
            if (f->sign[1] != sign[1 - swaps] || f->sign[2] != sign[2]) continue;
            if (swaps) swap_terms(s, kind);
            s->op = f->op;
            s->scalars = 0;
            yk_tape_mark_scalars(m, s);
            return true;
        }
    return false;
}

// Gives a step these signs. Where no operation has them, numbers in its products change their own signs instead.
static bool set_signs(const YkTapeMaker *m, YkTapeStep *s, Kind kind, const int *sign)
{
    size_t products = kind == SUM ? 0 : kind == ONE || kind == ALONE ? 1 : 2;
    for (unsigned turned = 0; turned < 1u << products; turned++) {
        YkTapeStep tried = *s;
        int own[3] = {sign[0], kind == ALONE ? 0 : sign[1], sign[2]};
        bool can = true;
        for (size_t p = 0; p < products; p++)
            if (turned >> p & 1) own[p] = -own[p], can = can && turn_number(m, &tried, 2 * p);
        if (!can || !choose_op(m, &tried, kind, own)) continue;
        *s = tried;
        return true;
    }
    return false;
}

static YkTapeStep *maker_of(const YkTapeMaker *m, YkTapeStep *steps, YkRef value)
{
    const YkTape *t = m->tape;
    for (size_t k = t->prelude_count; k < t->step_count; k++)
        if (m->made[k] == value) return &steps[k];
    return NULL;
}

// Makes a step compute its negative: by its signs, or by those of an operand that nothing else reads.
static bool negate(YkTapeMaker *m, YkTapeStep *steps, YkTapeStep *s, int depth)
{
    const Form *f = form_of(s);
    if (!f) return false;
    const int sign[3] = {-f->sign[0], -f->sign[1], -f->sign[2]};
    if (set_signs(m, s, f->kind, sign)) return true;
    for (size_t k = 0; f->kind == ALONE && depth > 0 && k < 2; k++) {
        YkTapeStep *own = m->uses[s->in[k]] == 1 ? maker_of(m, steps, s->in[k]) : NULL;
        if (own && negate(m, steps, own, depth - 1)) return true;
    }
    return false;
}

static bool reads(const YkTapeStep *s, YkRef value)
{
    return s->in[0] == value || s->in[1] == value || s->in[2] == value || s->in[3] == value || s->in[4] == value;
}

// Makes a step that reads a value read its negative. Returns false if it cannot.
static bool read_negative(const YkTapeMaker *m, YkTapeStep *s, YkRef value, YkRef negative)
{
    const Form *f = form_of(s);
    int sign[3] = {0, 0, 0};
    for (size_t k = 0; f && k < 3; k++) sign[k] = f->sign[k];
    for (size_t k = 0; k < YK_TAPE_OPERANDS; k++) {
        if (s->in[k] != value) continue;
        s->in[k] = negative;
        if (f) sign[term_of(f->kind, k)] *= -1;
    }
    if (s->op == YK_TAPE_SIZE || s->op == YK_TAPE_NONZERO) return true;
    return f && set_signs(m, s, f->kind, sign);
}

static bool calls_read(const YkTapeMaker *m, YkRef value)
{
    for (size_t c = 0; c < m->call_count; c++)
        for (size_t k = 0; k < m->tape->calls[c].argument_count; k++)
            if (m->tape->calls[c].arguments[k] == value) return true;
    return false;
}

// Lets the step of a value compute its negative, which a step of its own computes now. trial: room for all steps.
static bool leave_out(YkTapeMaker *m, size_t minus, YkTapeStep *trial)
{
    YkTape *t = m->tape;
    YkRef value = t->steps[minus].in[0], negative = m->made[minus];
    if (!maker_of(m, t->steps, value) || calls_read(m, value)) return false;
    memcpy(trial, t->steps, t->step_count * sizeof *trial);
    YkTapeStep *own = maker_of(m, trial, value);
    if (!negate(m, trial, own, 1)) return false;
    for (size_t k = t->prelude_count; k < t->step_count; k++)
        if (k != minus && reads(&trial[k], value) && !read_negative(m, &trial[k], value, negative)) return false;
    m->made[own - trial] = negative;
    m->uses[negative] += m->uses[value] - 1;
    size_t after = t->step_count - minus - 1;
    memmove(&trial[minus], &trial[minus + 1], after * sizeof *trial);
    memmove(&m->made[minus], &m->made[minus + 1], after * sizeof *m->made);
    t->step_count--;
    memcpy(t->steps, trial, t->step_count * sizeof *trial);
    return true;
}

bool yk_tape_turn_signs(YkTapeMaker *m, YkArena *work, const YkRef *roots)
{
    YkTape *t = m->tape;
    if (!YK_KNOWS_BLOCKS) return true;
    YkTapeStep *trial = YK_NEW(work, YkTapeStep, t->step_count + 1);
    bool *is_root = YK_NEW(work, bool, m->graph->count + 1);
    if (yk_arena_failed(work)) return false;
    for (size_t k = 0; k < t->root_count; k++) is_root[roots[k]] = true;
    for (bool changes = true; changes;) { // one may make another one possible
        changes = false;
        for (size_t k = t->prelude_count; k < t->step_count; k++)
            if (t->steps[k].op == YK_TAPE_MINUS && !is_root[t->steps[k].in[0]]) changes |= leave_out(m, k, trial);
    }
    return true;
}
