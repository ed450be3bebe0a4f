#include "code/dag.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "base/text.h"
#include "expr/formula.h"

enum { NOTHING = -1 };

bool yk_dag_start(YkDag *g, YkArena *arena)
{
    *g = (YkDag){.arena = arena, .table_size = 1024};
    g->table = malloc(g->table_size * sizeof *g->table);
    if (!g->table) return false;
    for (size_t k = 0; k < g->table_size; k++) g->table[k] = NOTHING;
    yk_dag_section(g, NULL);
    yk_dag_number(g, 0); // value 0 is always there: what a failed allocation leaves refers to it
    return !g->failed;
}

void yk_dag_end(YkDag *g)
{
    free(g->values);
    free(g->calls);
    free(g->sections);
    free(g->table);
    *g = (YkDag){0};
}

void yk_dag_section(YkDag *g, const char *heading)
{
    if (YK_ROOM(g->sections, g->section_count, g->section_capacity))
        g->sections[g->section_count++] = heading;
    else
        g->failed = true;
}

YkRef yk_dag_name(YkDag *g, YkRef value, const char *format, ...)
{
    YkValue *v = &g->values[value];
    if (v->name || v->op == YK_VALUE_NUMBER || v->op == YK_VALUE_MINUS) return value;
    YkText text = {0};
    va_list arguments;
    va_start(arguments, format);
    yk_text_vformat(&text, format, arguments);
    va_end(arguments);
    const char *name = yk_arena_copy(g->arena, yk_text_get(&text), text.length);
    if (!name || text.failed) g->failed = true;
    v->name = name;
    yk_text_free(&text);
    return value;
}

// --- finding again
// --------------------------------------------------------------------------------------------------------

static size_t hash_of(const YkValue *v)
{
    uint64_t bits, h = (uint64_t)v->op * 31 + (uint64_t)v->function;
    memcpy(&bits, &v->number, sizeof bits);
    const uint64_t parts[] = {(uint64_t)v->a, (uint64_t)v->b, (uint64_t)v->c, bits, (uint64_t)(uintptr_t)v->name};
    for (size_t k = 0; k < 5; k++) h = (h ^ parts[k]) * 0x9e3779b97f4a7c15u + (h >> 29);
    return (size_t)(h >> 16);
}

static bool is_same(const YkValue *a, const YkValue *b)
{
    if (a->op != b->op || a->a != b->a || a->b != b->b || a->c != b->c || a->function != b->function) return false;
    if (a->op == YK_VALUE_LEAF) return strcmp(a->name, b->name) == 0;
    return memcmp(&a->number, &b->number, sizeof a->number) == 0;
}

static void enter(YkDag *g, size_t index, size_t hash)
{
    size_t at = hash % g->table_size;
    while (g->table[at] != NOTHING) at = (at + 1) % g->table_size;
    g->table[at] = (int32_t)index;
}

// The name of a value is no part of what it is, but for leaves.
static YkValue key_of(const YkValue *v)
{
    YkValue key = *v;
    key.name = NULL;
    return key;
}

static bool grow_table(YkDag *g)
{
    int32_t *table = malloc(2 * g->table_size * sizeof *table);
    if (!table) return false;
    free(g->table);
    g->table = table;
    g->table_size *= 2;
    for (size_t k = 0; k < g->table_size; k++) table[k] = NOTHING;
    for (size_t k = 0; k < g->count; k++) {
        YkValue key = key_of(&g->values[k]);
        enter(g, k, hash_of(&key));
    }
    return true;
}

// A value with its operands set: the one that is there, or a new one.
static YkRef intern(YkDag *g, YkValue v)
{
    YkValue key = key_of(&v);
    size_t hash = hash_of(&key);
    for (size_t at = hash % g->table_size; g->table[at] != NOTHING; at = (at + 1) % g->table_size)
        if (is_same(&g->values[g->table[at]], &v)) return g->table[at];
    if ((2 * g->count > g->table_size && !grow_table(g)) || !YK_ROOM(g->values, g->count, g->capacity)) {
        g->failed = true;
        return 0;
    }
    v.section = (int32_t)g->section_count - 1;
    if (v.op != YK_VALUE_LEAF && v.op != YK_VALUE_NUMBER && v.op != YK_VALUE_RESULT) {
        const YkRef operands[] = {v.a, v.b, v.c};
        v.of_parameters = true;
        for (size_t k = 0; k < 3; k++)
            if (operands[k] != NOTHING && !g->values[operands[k]].of_parameters) v.of_parameters = false;
    }
    g->values[g->count] = v;
    enter(g, g->count, hash);
    return (YkRef)g->count++;
}

static YkRef operation(YkDag *g, YkValueKind op, YkRef a, YkRef b, YkRef c)
{
    return intern(g, (YkValue){.op = op, .a = a, .b = b, .c = c});
}

YkRef yk_dag_number(YkDag *g, double number)
{
    return intern(g, (YkValue){.op = YK_VALUE_NUMBER,
                               .a = NOTHING,
                               .b = NOTHING,
                               .c = NOTHING,
                               .number = number == 0 ? 0 : number, // no negative zero
                               .of_parameters = true});
}

YkRef yk_dag_leaf(YkDag *g, YkLeafClass leaf_class, const char *name)
{
    for (size_t k = 0; k < g->count; k++)
        if (g->values[k].op == YK_VALUE_LEAF && strcmp(g->values[k].name, name) == 0) return (YkRef)k;
    const char *copy = yk_arena_copy(g->arena, name, strlen(name));
    if (!copy) {
        g->failed = true;
        return 0;
    }
    YkRef leaf = intern(g, (YkValue){.op = YK_VALUE_LEAF,
                                     .a = (YkRef)g->count, // a leaf is found by its name alone, above
                                     .b = NOTHING,
                                     .c = NOTHING,
                                     .name = copy,
                                     .of_parameters = leaf_class == YK_LEAF_PARAMETER,
                                     .leaf_class = (int32_t)leaf_class});
    return leaf;
}

// --- folding
// --------------------------------------------------------------------------------------------------------------

static const YkValue *at(const YkDag *g, YkRef value)
{
    return &g->values[value];
}

bool yk_dag_is_number(const YkDag *g, YkRef value, double number)
{
    return at(g, value)->op == YK_VALUE_NUMBER && at(g, value)->number == number;
}

static bool is_number(const YkDag *g, YkRef value)
{
    return at(g, value)->op == YK_VALUE_NUMBER;
}

static bool is_minus(const YkDag *g, YkRef value)
{
    return at(g, value)->op == YK_VALUE_MINUS;
}

static void order(YkRef *a, YkRef *b)
{
    if (*a <= *b) return;
    YkRef other = *a;
    *a = *b;
    *b = other;
}

YkRef yk_dag_minus(YkDag *g, YkRef a)
{
    if (is_number(g, a)) return yk_dag_number(g, -at(g, a)->number);
    if (is_minus(g, a)) return at(g, a)->a;
    if (at(g, a)->op == YK_VALUE_SUBTRACT) return yk_dag_subtract(g, at(g, a)->b, at(g, a)->a);
    return operation(g, YK_VALUE_MINUS, a, NOTHING, NOTHING);
}

YkRef yk_dag_add(YkDag *g, YkRef a, YkRef b)
{
    if (yk_dag_is_number(g, a, 0)) return b;
    if (yk_dag_is_number(g, b, 0)) return a;
    if (is_number(g, a) && is_number(g, b)) return yk_dag_number(g, at(g, a)->number + at(g, b)->number);
    if (is_minus(g, b)) return yk_dag_subtract(g, a, at(g, b)->a);
    if (is_minus(g, a)) return yk_dag_subtract(g, b, at(g, a)->a);
    order(&a, &b);
    return operation(g, YK_VALUE_ADD, a, b, NOTHING);
}

YkRef yk_dag_subtract(YkDag *g, YkRef a, YkRef b)
{
    if (yk_dag_is_number(g, b, 0)) return a;
    if (a == b) return yk_dag_number(g, 0);
    if (is_number(g, a) && is_number(g, b)) return yk_dag_number(g, at(g, a)->number - at(g, b)->number);
    if (yk_dag_is_number(g, a, 0)) return yk_dag_minus(g, b);
    if (is_minus(g, b)) return yk_dag_add(g, a, at(g, b)->a);
    if (is_minus(g, a)) return yk_dag_minus(g, yk_dag_add(g, at(g, a)->a, b));
    return operation(g, YK_VALUE_SUBTRACT, a, b, NOTHING);
}

YkRef yk_dag_multiply(YkDag *g, YkRef a, YkRef b)
{
    if (is_number(g, a) && is_number(g, b)) return yk_dag_number(g, at(g, a)->number * at(g, b)->number);
    if (is_number(g, b)) {
        YkRef other = a;
        a = b;
        b = other;
    }
    if (yk_dag_is_number(g, a, 0)) return a;
    if (yk_dag_is_number(g, a, 1)) return b;
    if (yk_dag_is_number(g, a, -1)) return yk_dag_minus(g, b);
    if (is_number(g, a) && at(g, a)->number < 0)
        return yk_dag_minus(g, yk_dag_multiply(g, yk_dag_number(g, -at(g, a)->number), b));
    if (is_minus(g, a)) return yk_dag_minus(g, yk_dag_multiply(g, at(g, a)->a, b));
    if (is_minus(g, b)) return yk_dag_minus(g, yk_dag_multiply(g, a, at(g, b)->a));
    order(&a, &b);
    return operation(g, YK_VALUE_MULTIPLY, a, b, NOTHING);
}

YkRef yk_dag_divide(YkDag *g, YkRef a, YkRef b)
{
    if (yk_dag_is_number(g, b, 1)) return a;
    if (yk_dag_is_number(g, b, -1)) return yk_dag_minus(g, a);
    if (is_number(g, a) && is_number(g, b) && at(g, b)->number != 0)
        return yk_dag_number(g, at(g, a)->number / at(g, b)->number);
    if (yk_dag_is_number(g, a, 0) && !is_number(g, b)) return a;
    if (is_minus(g, a)) return yk_dag_minus(g, yk_dag_divide(g, at(g, a)->a, b));
    if (is_minus(g, b)) return yk_dag_minus(g, yk_dag_divide(g, a, at(g, b)->a));
    return operation(g, YK_VALUE_DIVIDE, a, b, NOTHING);
}

// Whole powers up to this are products.
enum { POWER_MAX = 8 };

YkRef yk_dag_power(YkDag *g, YkRef a, YkRef b)
{
    if (is_number(g, a) && is_number(g, b)) return yk_dag_number(g, pow(at(g, a)->number, at(g, b)->number));
    if (is_number(g, b)) {
        double exponent = at(g, b)->number;
        if (exponent == 0.5) return yk_dag_function(g, YK_SQRT, a, NOTHING);
        if (exponent == rint(exponent) && fabs(exponent) <= POWER_MAX) {
            YkRef product = yk_dag_number(g, 1);
            for (int k = 0; k < (int)fabs(exponent); k++) product = yk_dag_multiply(g, product, a);
            return exponent < 0 ? yk_dag_divide(g, yk_dag_number(g, 1), product) : product;
        }
    }
    return operation(g, YK_VALUE_POWER, a, b, NOTHING);
}

YkRef yk_dag_function(YkDag *g, YkFunction function, YkRef a, YkRef b)
{
    bool has_second = b != NOTHING;
    if (is_number(g, a) && (!has_second || is_number(g, b)))
        return yk_dag_number(g, yk_function_value(function, at(g, a)->number, has_second ? at(g, b)->number : 0));
    if (function == YK_SQRT && at(g, a)->op == YK_VALUE_MULTIPLY && at(g, a)->a == at(g, a)->b)
        return yk_dag_unary(g, YK_VALUE_SIZE, at(g, a)->a);
    return intern(g, (YkValue){.op = YK_VALUE_FUNCTION, .a = a, .b = b, .c = NOTHING, .function = function});
}

YkRef yk_dag_unary(YkDag *g, YkValueKind op, YkRef a)
{
    if (is_number(g, a)) {
        double x = at(g, a)->number;
        if (op == YK_VALUE_ROOT) return yk_dag_number(g, sqrt(x > 0 ? x : 0));
        if (op == YK_VALUE_PER_ROOT) return yk_dag_number(g, 1 / sqrt(x > 1e-36 ? x : 1e-36));
        if (op == YK_VALUE_NONZERO) return yk_dag_number(g, fabs(x) + 1e-200);
        if (op == YK_VALUE_SIZE) return yk_dag_number(g, fabs(x));
        if (op == YK_VALUE_WITNESS) return yk_dag_number(g, 0);
    }
    if (op == YK_VALUE_SIZE && (is_minus(g, a) || at(g, a)->op == YK_VALUE_SIZE)) a = at(g, a)->a;
    return operation(g, op, a, NOTHING, NOTHING);
}

YkRef yk_dag_binary(YkDag *g, YkValueKind op, YkRef a, YkRef b)
{
    if (is_number(g, a) && is_number(g, b)) {
        double x = at(g, a)->number, y = at(g, b)->number;
        if (op == YK_VALUE_LEAST) return yk_dag_number(g, x < y ? x : y);
        if (op == YK_VALUE_LARGEST) return yk_dag_number(g, x > y ? x : y);
        if (op == YK_VALUE_ANGLE) return yk_dag_number(g, atan2(x, y));
    }
    return operation(g, op, a, b, NOTHING);
}

YkRef yk_dag_choose(YkDag *g, YkRef sign, YkRef negative, YkRef otherwise)
{
    if (is_number(g, sign)) return at(g, sign)->number < 0 ? negative : otherwise;
    return negative == otherwise ? negative : operation(g, YK_VALUE_CHOOSE, sign, negative, otherwise);
}

YkRefVec yk_dag_unit(YkDag *g, YkRef angle)
{
    if (is_number(g, angle)) {
        double x = at(g, angle)->number;
        return yk_dag_vec_number(g, cos(x), sin(x));
    }
    if (is_minus(g, angle)) return yk_dag_vec_conjugate(g, yk_dag_unit(g, at(g, angle)->a));
    YkRef sine = operation(g, YK_VALUE_SINE, angle, NOTHING, NOTHING);
    return (YkRefVec){operation(g, YK_VALUE_COSINE, angle, sine, NOTHING), sine};
}

int32_t yk_dag_call(YkDag *g, YkCall call)
{
    if (!YK_ROOM(g->calls, g->call_count, g->call_capacity)) {
        g->failed = true;
        return 0;
    }
    call.section = (int32_t)g->section_count - 1;
    g->calls[g->call_count] = call;
    return (int32_t)g->call_count++;
}

YkRef yk_dag_result(YkDag *g, int32_t call, size_t k)
{
    return intern(g, (YkValue){.op = YK_VALUE_RESULT, .a = call, .b = (YkRef)k, .c = NOTHING});
}

// --- vectors
// --------------------------------------------------------------------------------------------------------------

YkRefVec yk_dag_vec_number(YkDag *g, double x, double y)
{
    return (YkRefVec){yk_dag_number(g, x), yk_dag_number(g, y)};
}

YkRefVec yk_dag_vec_add(YkDag *g, YkRefVec a, YkRefVec b)
{
    return (YkRefVec){yk_dag_add(g, a.x, b.x), yk_dag_add(g, a.y, b.y)};
}

YkRefVec yk_dag_vec_subtract(YkDag *g, YkRefVec a, YkRefVec b)
{
    return (YkRefVec){yk_dag_subtract(g, a.x, b.x), yk_dag_subtract(g, a.y, b.y)};
}

YkRefVec yk_dag_vec_scale(YkDag *g, YkRef k, YkRefVec a)
{
    return (YkRefVec){yk_dag_multiply(g, k, a.x), yk_dag_multiply(g, k, a.y)};
}

YkRefVec yk_dag_vec_multiply(YkDag *g, YkRefVec a, YkRefVec b)
{
    return (YkRefVec){yk_dag_subtract(g, yk_dag_multiply(g, a.x, b.x), yk_dag_multiply(g, a.y, b.y)),
                      yk_dag_add(g, yk_dag_multiply(g, a.x, b.y), yk_dag_multiply(g, a.y, b.x))};
}

YkRefVec yk_dag_vec_conjugate(YkDag *g, YkRefVec a)
{
    return (YkRefVec){a.x, yk_dag_minus(g, a.y)};
}

YkRefVec yk_dag_vec_quarter(YkDag *g, YkRefVec a)
{
    return (YkRefVec){yk_dag_minus(g, a.y), a.x};
}

YkRef yk_dag_dot(YkDag *g, YkRefVec a, YkRefVec b)
{
    return yk_dag_add(g, yk_dag_multiply(g, a.x, b.x), yk_dag_multiply(g, a.y, b.y));
}

YkRef yk_dag_cross(YkDag *g, YkRefVec a, YkRefVec b)
{
    return yk_dag_subtract(g, yk_dag_multiply(g, a.x, b.y), yk_dag_multiply(g, a.y, b.x));
}

bool yk_dag_is_zero_vec(const YkDag *g, YkRefVec v)
{
    return yk_dag_is_number(g, v.x, 0) && yk_dag_is_number(g, v.y, 0);
}
