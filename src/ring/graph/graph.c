// The graph of operations: every node once, with the simplest algebra done on the way.
#include "ring/graph/inside.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

YkGraph *yk_graph_new(YkRing *ring)
{
    YkGraph *graph = calloc(1, sizeof *graph);
    if (!graph) return NULL;
    graph->ring = ring;
    return graph;
}

void yk_graph_free(YkGraph *graph)
{
    if (!graph) return;
    free(graph->nodes);
    free(graph->slots);
    free(graph->defined);
    free(graph->definitions);
    free(graph->constants);
    free(graph->is_read);
    free(graph->is_written);
    free(graph);
}

bool yk_graph_failed(const YkGraph *graph)
{
    return graph->failed;
}

// Makes room for symbols that were added to the ring since.
static bool make_room_for_symbols(YkGraph *graph)
{
    size_t count = yk_ring_symbol_count(graph->ring);
    if (count <= graph->defined_count) return true;
    YkGraphValue *defined = realloc(graph->defined, count * sizeof *defined);
    if (defined) graph->defined = defined;
    bool *is_read = realloc(graph->is_read, count);
    if (is_read) graph->is_read = is_read;
    bool *is_written = realloc(graph->is_written, count);
    if (is_written) graph->is_written = is_written;
    if (!defined || !is_read || !is_written) {
        graph->failed = true;
        return false;
    }
    for (size_t s = graph->defined_count; s < count; s++) {
        defined[s] = YK_GRAPH_NONE;
        is_read[s] = is_written[s] = false;
    }
    graph->defined_count = count;
    return true;
}

// --- Nodes, each once

static bool is_constant_symbol(const YkRing *ring, int32_t index)
{
    return ring->symbols[index].pi_over > 0 || yk_ring_is_constant(ring, index);
}

static uint64_t hash_of(YkOperation operation, int32_t a, int32_t b, double number)
{
    uint64_t bits;
    memcpy(&bits, &number, sizeof bits);
    uint64_t hash = (uint64_t)operation * 0x9e3779b97f4a7c15u + (uint64_t)(uint32_t)a;
    hash = (hash ^ hash >> 29) * 0xbf58476d1ce4e5b9u + (uint64_t)(uint32_t)b;
    hash = (hash ^ hash >> 32) * 0x94d049bb133111ebu + bits;
    return (hash ^ hash >> 31) * 0x9e3779b97f4a7c15u >> 16;
}

static bool grow_slots(YkGraph *graph)
{
    size_t wanted = graph->slot_count ? 2 * graph->slot_count : 256;
    int32_t *slots = calloc(wanted, sizeof *slots);
    if (!slots) return false;
    for (size_t k = 0; k < graph->count; k++) {
        const YkGraphNode *node = &graph->nodes[k];
        size_t at = hash_of(node->operation, node->a, node->b, node->number) & (wanted - 1);
        while (slots[at]) at = (at + 1) & (wanted - 1);
        slots[at] = (int32_t)k + 1;
    }
    free(graph->slots);
    graph->slots = slots;
    graph->slot_count = wanted;
    return true;
}

// Returns the slot of the node, or the one where it would go.
static size_t slot_of(const YkGraph *graph, YkOperation operation, int32_t a, int32_t b, double number)
{
    size_t at = hash_of(operation, a, b, number) & (graph->slot_count - 1);
    for (; graph->slots[at]; at = (at + 1) & (graph->slot_count - 1)) {
        const YkGraphNode *node = &graph->nodes[graph->slots[at] - 1];
        if (node->operation == operation && node->a == a && node->b == b && node->number == number) break;
    }
    return at;
}

static YkGraphNode new_node(const YkGraph *graph, YkOperation operation, int32_t a, int32_t b, double number)
{
    YkGraphNode node = {.operation = operation, .a = a, .b = b, .number = number, .constant = -1};
    if (operation == YK_OP_NUMBER)
        node.is_constant = true;
    else if (operation == YK_OP_SYMBOL)
        node.is_constant = is_constant_symbol(graph->ring, a);
    else {
        const YkGraphNode *first = &graph->nodes[a], *second = b >= 0 ? &graph->nodes[b] : first;
        node.is_constant = first->is_constant && second->is_constant;
        uint32_t deepest = first->depth > second->depth ? first->depth : second->depth;
        node.depth = deepest >= YK_GRAPH_DEPTH_MAX ? 0 : deepest + 1; // it gets a variable
    }
    return node;
}

YkGraphValue yk_graph_node(YkGraph *graph, YkOperation operation, int32_t a, int32_t b, double number)
{
    if (2 * (graph->count + 1) > graph->slot_count && !grow_slots(graph)) graph->failed = true;
    if (graph->failed || graph->count >= INT32_MAX / 2 - 1) return YK_GRAPH_NONE;
    size_t at = slot_of(graph, operation, a, b, number);
    if (graph->slots[at]) return 2 * (graph->slots[at] - 1);
    if (!YK_ROOM(graph->nodes, graph->count, graph->capacity)) {
        graph->failed = true;
        return YK_GRAPH_NONE;
    }
    graph->nodes[graph->count] = new_node(graph, operation, a, b, number);
    graph->slots[at] = (int32_t)++graph->count;
    return 2 * ((int32_t)graph->count - 1);
}

// --- Values: 2 node, plus 1 for the negative

static bool is_negative(YkGraphValue a)
{
    return a & 1;
}

YkGraphValue yk_graph_negate(YkGraphValue a)
{
    return a < 0 ? a : a ^ 1;
}

static const YkGraphNode *node_of(const YkGraph *graph, YkGraphValue a)
{
    return &graph->nodes[a >> 1];
}

static bool is_number(const YkGraph *graph, YkGraphValue a, double *number)
{
    const YkGraphNode *node = node_of(graph, a);
    *number = is_negative(a) ? -node->number : node->number;
    return node->operation == YK_OP_NUMBER;
}

YkGraphValue yk_graph_number(YkGraph *graph, double number)
{
    YkGraphValue size = yk_graph_node(graph, YK_OP_NUMBER, -1, -1, number == 0 ? 0 : fabs(number));
    return number < 0 ? yk_graph_negate(size) : size;
}

YkGraphValue yk_graph_symbol(YkGraph *graph, int32_t symbol)
{
    if (symbol < 0 || !make_room_for_symbols(graph)) return YK_GRAPH_NONE;
    if (graph->defined[symbol] != YK_GRAPH_NONE) return graph->defined[symbol];
    const YkPoisson *square = graph->ring->symbols[symbol].square;
    if (square) return yk_graph_function(graph, YK_OP_SQRT, yk_graph_of(graph, square));
    return yk_graph_node(graph, YK_OP_SYMBOL, symbol, -1, 0);
}

void yk_graph_define(YkGraph *graph, int32_t symbol, YkGraphValue value)
{
    if (value < 0 || !make_room_for_symbols(graph) ||
        !YK_ROOM(graph->definitions, graph->definition_count, graph->definition_capacity)) {
        graph->failed = true;
        return;
    }
    graph->definitions[graph->definition_count].symbol = symbol;
    graph->definitions[graph->definition_count++].before = graph->defined[symbol];
    graph->defined[symbol] = value;
}

size_t yk_graph_definitions(const YkGraph *graph)
{
    return graph->definition_count;
}

void yk_graph_forget(YkGraph *graph, size_t count)
{
    while (graph->definition_count > count) {
        graph->definition_count--;
        graph->defined[graph->definitions[graph->definition_count].symbol] =
            graph->definitions[graph->definition_count].before;
    }
}

// Adds positive values a + b, the same in either order.
static YkGraphValue plain_sum(YkGraph *graph, int32_t a, int32_t b)
{
    bool is_there = graph->slots[slot_of(graph, YK_OP_ADD, b, a, 0)];
    return is_there ? yk_graph_node(graph, YK_OP_ADD, b, a, 0) : yk_graph_node(graph, YK_OP_ADD, a, b, 0);
}

static YkGraphValue plain_difference(YkGraph *graph, int32_t a, int32_t b)
{
    bool is_there = graph->slots[slot_of(graph, YK_OP_SUBTRACT, b, a, 0)];
    if (is_there) return yk_graph_negate(yk_graph_node(graph, YK_OP_SUBTRACT, b, a, 0));
    return yk_graph_node(graph, YK_OP_SUBTRACT, a, b, 0);
}

YkGraphValue yk_graph_add(YkGraph *graph, YkGraphValue a, YkGraphValue b)
{
    double x, y;
    if (a < 0 || b < 0) return YK_GRAPH_NONE;
    bool first = is_number(graph, a, &x), second = is_number(graph, b, &y);
    if (first && second) return yk_graph_number(graph, x + y);
    if (first && x == 0) return b;
    if (second && y == 0) return a;
    if (a == yk_graph_negate(b)) return yk_graph_number(graph, 0);
    if (is_negative(a) == is_negative(b)) {
        YkGraphValue sum = plain_sum(graph, a >> 1, b >> 1);
        return is_negative(a) ? yk_graph_negate(sum) : sum;
    }
    return is_negative(a) ? plain_difference(graph, b >> 1, a >> 1) : plain_difference(graph, a >> 1, b >> 1);
}

YkGraphValue yk_graph_subtract(YkGraph *graph, YkGraphValue a, YkGraphValue b)
{
    return yk_graph_add(graph, a, yk_graph_negate(b));
}

YkGraphValue yk_graph_multiply(YkGraph *graph, YkGraphValue a, YkGraphValue b)
{
    double x, y;
    if (a < 0 || b < 0) return YK_GRAPH_NONE;
    bool first = is_number(graph, a, &x), second = is_number(graph, b, &y);
    if (first && second) return yk_graph_number(graph, x * y);
    if ((first && x == 0) || (second && y == 0)) return yk_graph_number(graph, 0);
    if (first && fabs(x) == 1) return x < 0 ? yk_graph_negate(b) : b;
    if (second && fabs(y) == 1) return y < 0 ? yk_graph_negate(a) : a;
    int32_t one = a >> 1, other = b >> 1;
    size_t at = slot_of(graph, YK_OP_MULTIPLY, other, one, 0);
    if (graph->slots[at]) one = b >> 1, other = a >> 1;
    YkGraphValue product = yk_graph_node(graph, YK_OP_MULTIPLY, one, other, 0);
    return is_negative(a) != is_negative(b) ? yk_graph_negate(product) : product;
}

YkGraphValue yk_graph_divide(YkGraph *graph, YkGraphValue a, YkGraphValue b)
{
    double x, y;
    if (a < 0 || b < 0) return YK_GRAPH_NONE;
    if (is_number(graph, a, &x) && x == 0) return a;
    if (is_number(graph, b, &y) && fabs(y) == 1) return y < 0 ? yk_graph_negate(a) : a;
    YkGraphValue quotient = yk_graph_node(graph, YK_OP_DIVIDE, a >> 1, b >> 1, 0);
    return is_negative(a) != is_negative(b) ? yk_graph_negate(quotient) : quotient;
}

// Uses symmetry: the sine of a negative argument is that of the positive one, negated; the cosine is the same.
YkGraphValue yk_graph_function(YkGraph *graph, YkOperation operation, YkGraphValue argument)
{
    if (argument < 0) return YK_GRAPH_NONE;
    if (operation == YK_OP_SQRT) return yk_graph_node(graph, operation, argument >> 1, -1, 0); // of the square's value
    YkGraphValue value = yk_graph_node(graph, operation, argument >> 1, -1, 0);
    return operation == YK_OP_SIN && is_negative(argument) ? yk_graph_negate(value) : value;
}
