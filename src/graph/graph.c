// The graph of a program: makes values, and finds those that are already there.
#include "graph/graph.h"
#include <stdlib.h>
#include <string.h>
#include "base/text.h"

bool yk_graph_start(YkGraph *g, YkArena *arena)
{
    *g = (YkGraph){.arena = arena, .table_size = 1024};
    g->table = malloc(g->table_size * sizeof *g->table);
    if (!g->table) return false;
    for (size_t k = 0; k < g->table_size; k++) g->table[k] = YK_NONE;
    yk_graph_section(g, NULL);
    yk_graph_number(g, 0); // value 0 always exists: a failed allocation refers to it
    return !g->failed;
}

void yk_graph_end(YkGraph *g)
{
    free(g->values);
    free(g->calls);
    free(g->sections);
    free(g->table);
    free(g->memo.slope);
    free(g->memo.slope_stamp);
    free(g->memo.reach_stamp);
    yk_names_free(&g->leaves);
    *g = (YkGraph){0};
}

void yk_graph_section(YkGraph *g, const char *heading)
{
    if (YK_ROOM(g->sections, g->section_count, g->section_capacity))
        g->sections[g->section_count++] = heading;
    else
        g->failed = true;
}

static char *text_of(YkGraph *g, const char *format, va_list arguments)
{
    static char nothing[1];
    YkText text = {0};
    yk_text_vformat(&text, format, arguments);
    char *copy = yk_arena_copy(g->arena, yk_text_get(&text), text.length);
    if (!copy || text.failed) g->failed = true;
    yk_text_free(&text);
    return copy ? copy : nothing;
}

char *yk_graph_text(YkGraph *g, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    char *text = text_of(g, format, arguments);
    va_end(arguments);
    return text;
}

YkRef yk_graph_name(YkGraph *g, YkRef value, const char *format, ...)
{
    YkValue *v = &g->values[value];
    if (v->name || v->op == YK_VALUE_NUMBER || v->op == YK_VALUE_MINUS) return value;
    va_list arguments;
    va_start(arguments, format);
    v->name = text_of(g, format, arguments);
    va_end(arguments);
    return value;
}

// --- finding again

// Leaves the name out: it distinguishes leaves only, and is_same compares it.
static size_t hash_of(const YkValue *v)
{
    uint64_t bits, h = (uint64_t)v->op * 31 + (uint64_t)v->function;
    memcpy(&bits, &v->number, sizeof bits);
    const uint64_t parts[] = {(uint64_t)v->a, (uint64_t)v->b, (uint64_t)v->c, bits};
    for (size_t k = 0; k < 4; k++) h = (h ^ parts[k]) * 0x9e3779b97f4a7c15u + (h >> 29);
    return (size_t)(h >> 16);
}

static bool is_same(const YkValue *a, const YkValue *b)
{
    if (a->op != b->op || a->a != b->a || a->b != b->b || a->c != b->c || a->function != b->function) return false;
    if (a->op == YK_VALUE_LEAF) return strcmp(a->name, b->name) == 0;
    return memcmp(&a->number, &b->number, sizeof a->number) == 0;
}

static void enter(YkGraph *g, size_t index, size_t hash)
{
    size_t at = hash % g->table_size;
    while (g->table[at] != YK_NONE) at = (at + 1) % g->table_size;
    g->table[at] = (int32_t)index;
}

static bool grow_table(YkGraph *g)
{
    int32_t *table = malloc(2 * g->table_size * sizeof *table);
    if (!table) return false;
    free(g->table);
    g->table = table;
    g->table_size *= 2;
    for (size_t k = 0; k < g->table_size; k++) table[k] = YK_NONE;
    for (size_t k = 0; k < g->count; k++) enter(g, k, hash_of(&g->values[k]));
    return true;
}

static YkRef find(const YkGraph *g, const YkValue *v, size_t hash)
{
    for (size_t at = hash % g->table_size; g->table[at] != YK_NONE; at = (at + 1) % g->table_size)
        if (is_same(&g->values[g->table[at]], v)) return g->table[at];
    return YK_NONE;
}

YkRef yk_graph_find(const YkGraph *g, YkValue v)
{
    return find(g, &v, hash_of(&v));
}

enum { VALUE = 50 }; // work of one

// Returns a value with its operands set: an existing one, or a new one.
YkRef yk_graph_intern(YkGraph *g, YkValue v)
{
    if (!yk_pace_spend(g->pace, VALUE)) {
        g->failed = true;
        return 0;
    }
    size_t hash = hash_of(&v);
    YkRef known = find(g, &v, hash);
    if (known != YK_NONE) return known;
    if ((2 * g->count > g->table_size && !grow_table(g)) || !YK_ROOM(g->values, g->count, g->capacity)) {
        g->failed = true;
        return 0;
    }
    v.section = (int32_t)g->section_count - 1;
    if (v.op != YK_VALUE_LEAF && v.op != YK_VALUE_NUMBER && v.op != YK_VALUE_RESULT) {
        const YkRef operands[] = {v.a, v.b, v.c};
        v.of_parameters = true;
        for (size_t k = 0; k < 3; k++)
            if (operands[k] != YK_NONE && !g->values[operands[k]].of_parameters) v.of_parameters = false;
    }
    g->values[g->count] = v;
    enter(g, g->count, hash);
    return (YkRef)g->count++;
}

YkRef yk_graph_number(YkGraph *g, double number)
{
    return yk_graph_intern(g, (YkValue){.op = YK_VALUE_NUMBER,
                                        .a = YK_NONE,
                                        .b = YK_NONE,
                                        .c = YK_NONE,
                                        .number = number == 0 ? 0 : number, // no negative zero
                                        .of_parameters = true});
}

YkRef yk_graph_leaf(YkGraph *g, YkLeafClass leaf_class, const char *name)
{
    int32_t known = yk_names_find(&g->leaves, name);
    if (known != YK_NONE) return known;
    const char *copy = yk_arena_copy(g->arena, name, strlen(name));
    if (!copy || !yk_names_add(&g->leaves, copy, (int32_t)g->count, NULL)) {
        g->failed = true;
        return 0;
    }
    YkRef leaf = yk_graph_intern(g, (YkValue){.op = YK_VALUE_LEAF,
                                              .a = (YkRef)g->count, // a leaf is found by its name alone, above
                                              .b = YK_NONE,
                                              .c = YK_NONE,
                                              .name = copy,
                                              .of_parameters = leaf_class == YK_LEAF_PARAMETER,
                                              .leaf_class = (int32_t)leaf_class});
    return leaf;
}

int32_t yk_graph_call(YkGraph *g, YkCall call)
{
    if (!YK_ROOM(g->calls, g->call_count, g->call_capacity)) {
        g->failed = true;
        return 0;
    }
    call.section = (int32_t)g->section_count - 1;
    g->calls[g->call_count] = call;
    return (int32_t)g->call_count++;
}

YkRef yk_graph_result(YkGraph *g, int32_t call, size_t k)
{
    return yk_graph_intern(g, (YkValue){.op = YK_VALUE_RESULT, .a = call, .b = (YkRef)k, .c = YK_NONE});
}

// --- cost

static size_t cost_of(const YkGraph *g, YkRef value, bool *counted)
{
    const YkValue *v = &g->values[value];
    if (counted[value] || v->of_parameters || v->op == YK_VALUE_LEAF) return 0;
    counted[value] = true;
    size_t sum = v->op != YK_VALUE_MINUS && v->op != YK_VALUE_RESULT;
    const YkRef operands[] = {v->a, v->b, v->c};
    for (size_t k = 0; k < 3 && v->op != YK_VALUE_RESULT; k++)
        if (operands[k] != YK_NONE) sum += cost_of(g, operands[k], counted);
    return sum;
}

size_t yk_graph_cost(const YkGraph *g, const YkRef *roots, size_t count)
{
    size_t sum = 0;
    bool *counted = YK_NEW(g->arena, bool, g->count);
    for (size_t k = 0; counted && k < count; k++) sum += cost_of(g, roots[k], counted);
    return sum;
}
