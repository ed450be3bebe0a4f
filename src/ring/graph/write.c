// Writes a graph as C.
#include <math.h>
#include <string.h>
#include "base/number.h"
#include "ring/graph/inside.h"
#include "ring/print/write.h"

static bool is_leaf(const YkGraphNode *node)
{
    return node->operation == YK_OP_NUMBER || node->operation == YK_OP_SYMBOL;
}

// Returns whether the node is computed elsewhere and read from the constants.
static bool is_hoisted(const YkGraph *graph, const YkGraphNode *node)
{
    return !graph->is_of_constants && node->is_constant && !is_leaf(node);
}

void yk_graph_begin(YkGraph *graph)
{
    for (size_t k = 0; k < graph->count; k++) {
        graph->nodes[k].is_wanted = false;
        graph->nodes[k].uses = 0;
        graph->nodes[k].name = 0;
    }
    for (size_t s = 0; s < graph->defined_count; s++) graph->is_written[s] = false;
    graph->name_count = 0;
}

void yk_graph_want(YkGraph *graph, YkGraphValue value)
{
    if (value < 0) {
        graph->failed = true;
        return;
    }
    graph->nodes[value >> 1].is_wanted = true;
    graph->nodes[value >> 1].uses++;
}

void yk_graph_writes(YkGraph *graph, int32_t symbol)
{
    if ((size_t)symbol < graph->defined_count) graph->is_written[symbol] = true;
}

static void want_part(YkGraph *graph, int32_t node)
{
    if (node >= 0) yk_graph_want(graph, 2 * node);
}

// Gives places to constants that no function has used before.
static void place_constants(YkGraph *graph)
{
    for (size_t k = 0; k < graph->count && !graph->failed; k++) {
        YkGraphNode *node = &graph->nodes[k];
        if (!node->is_wanted || !is_hoisted(graph, node) || node->constant >= 0) continue;
        if (!YK_ROOM(graph->constants, graph->constant_count, graph->constant_capacity)) {
            graph->failed = true;
            return;
        }
        node->constant = (int32_t)graph->constant_count;
        graph->constants[graph->constant_count++] = (int32_t)k;
    }
}

// Marks all nodes that are needed: wholes come after their parts, so one pass from the back suffices.
static void spread(YkGraph *graph)
{
    for (size_t k = graph->count; k-- > 0;) {
        YkGraphNode *node = &graph->nodes[k];
        if (!node->is_wanted || is_hoisted(graph, node)) continue;
        if (node->operation == YK_OP_SYMBOL) graph->is_read[node->a] = true;
        if (is_leaf(node)) continue;
        want_part(graph, node->a);
        want_part(graph, node->b);
    }
    place_constants(graph);
}

static bool needs_variable(const YkGraph *graph, const YkGraphNode *node)
{
    if (node->operation == YK_OP_SYMBOL) return graph->is_written[node->a];
    if (node->operation == YK_OP_NUMBER || is_hoisted(graph, node)) return false;
    if (graph->is_of_constants && node->constant >= 0) return false;
    bool is_function = node->operation == YK_OP_SIN || node->operation == YK_OP_COS || node->operation == YK_OP_SQRT;
    return node->uses > 1 || is_function || node->depth == 0;
}

// --- Expressions

static void put_number(YkText *text, double number)
{
    char digits[YK_NUMBER_SIZE];
    yk_number_write(number, digits);
    yk_text_puts(text, digits);
    if (!strpbrk(digits, ".en")) yk_text_puts(text, ".0");
}

static void put_symbol(const YkGraph *graph, int32_t symbol, YkText *text)
{
    const YkRingSymbol *of = &graph->ring->symbols[symbol];
    if (of->pi_over > 0)
        put_number(text, YK_PI / (double)of->pi_over);
    else
        yk_text_format(text, "m->%s", yk_ring_name_in(graph->ring, symbol, YK_RING_C));
}

static void put_node(const YkGraph *graph, int32_t index, YkText *text);

static void put_operation(const YkGraph *graph, const YkGraphNode *node, YkText *text)
{
    static const char *const words[] = {
        [YK_OP_ADD] = " + ",  [YK_OP_SUBTRACT] = " - ", [YK_OP_MULTIPLY] = "*", [YK_OP_DIVIDE] = "/",
        [YK_OP_SIN] = "sin(", [YK_OP_COS] = "cos(",     [YK_OP_SQRT] = "sqrt("};
    if (node->b < 0) {
        yk_text_puts(text, words[node->operation]);
        put_node(graph, node->a, text);
        yk_text_puts(text, ")");
        return;
    }
    bool is_sum = node->operation == YK_OP_ADD || node->operation == YK_OP_SUBTRACT;
    for (int side = 0; side < 2; side++) {
        const YkGraphNode *part = &graph->nodes[side ? node->b : node->a];
        bool is_inline = part->name == 0 && !is_leaf(part) && !is_hoisted(graph, part) && part->b >= 0 &&
                         !(graph->is_of_constants && part->constant >= 0);
        bool part_is_sum = part->operation == YK_OP_ADD || part->operation == YK_OP_SUBTRACT;
        // A sum in a product needs brackets, and so does a right operand that does not bind more tightly: it is
        // computed first.
        bool brackets = is_inline && (is_sum ? part_is_sum && side == 1 : part_is_sum || side == 1);
        if (side == 1) yk_text_puts(text, words[node->operation]);
        if (brackets) yk_text_puts(text, "(");
        put_node(graph, side ? node->b : node->a, text);
        if (brackets) yk_text_puts(text, ")");
    }
}

static void put_node(const YkGraph *graph, int32_t index, YkText *text)
{
    const YkGraphNode *node = &graph->nodes[index];
    if (node->name > 0)
        yk_text_format(text, "t%d", (int)node->name);
    else if (node->operation == YK_OP_NUMBER)
        put_number(text, node->number);
    else if (node->operation == YK_OP_SYMBOL)
        put_symbol(graph, node->a, text);
    else if (is_hoisted(graph, node) || (graph->is_of_constants && node->constant >= 0))
        yk_text_format(text, "m->constant[%d]", (int)node->constant);
    else
        put_operation(graph, node, text);
}

void yk_graph_put(YkGraph *graph, YkGraphValue value, YkText *text)
{
    if (value < 0) {
        graph->failed = true;
        return;
    }
    const YkGraphNode *node = &graph->nodes[value >> 1];
    bool is_negative = value & 1, is_named = node->name > 0 || is_leaf(node) || is_hoisted(graph, node);
    bool brackets = is_negative && !is_named && (node->operation == YK_OP_ADD || node->operation == YK_OP_SUBTRACT);
    if (is_negative) yk_text_puts(text, brackets ? "-(" : "-");
    put_node(graph, value >> 1, text);
    if (brackets) yk_text_puts(text, ")");
}

static void put_definition(YkGraph *graph, YkGraphNode *node, YkText *text)
{
    int32_t name = ++graph->name_count;
    yk_text_format(text, "    const double t%d = ", (int)name);
    if (node->operation == YK_OP_SYMBOL)
        put_symbol(graph, node->a, text);
    else
        put_operation(graph, node, text);
    yk_text_puts(text, ";\n");
    node->name = name;
}

void yk_graph_put_shared(YkGraph *graph, YkText *text)
{
    spread(graph);
    for (size_t k = 0; k < graph->count && !graph->failed; k++) {
        YkGraphNode *node = &graph->nodes[k];
        if (node->is_wanted && needs_variable(graph, node)) put_definition(graph, node, text);
    }
}

// --- Constants

void yk_graph_put_constants(YkGraph *graph, YkText *text)
{
    yk_graph_begin(graph);
    graph->is_of_constants = true;
    for (size_t k = 0; k < graph->constant_count; k++) yk_graph_want(graph, 2 * graph->constants[k]);
    spread(graph);
    for (size_t k = 0; k < graph->count && !graph->failed; k++) {
        YkGraphNode *node = &graph->nodes[k];
        if (!node->is_wanted) continue;
        if (node->constant >= 0) {
            yk_text_format(text, "    m->constant[%d] = ", (int)node->constant);
            put_operation(graph, node, text);
            yk_text_puts(text, ";\n");
        } else if (needs_variable(graph, node)) {
            put_definition(graph, node, text);
        }
    }
    graph->is_of_constants = false;
}

size_t yk_graph_constants(const YkGraph *graph)
{
    return graph->constant_count;
}

bool yk_graph_reads(const YkGraph *graph, int32_t symbol)
{
    bool is_pi = graph->ring->symbols[symbol].pi_over > 0; // pi is a number in C
    return (size_t)symbol < graph->defined_count && graph->is_read[symbol] && !is_pi;
}

size_t yk_graph_operations(const YkGraph *graph)
{
    size_t count = 0;
    for (size_t k = 0; k < graph->count; k++) {
        const YkGraphNode *node = &graph->nodes[k];
        count += node->is_wanted && !is_leaf(node) && !is_hoisted(graph, node);
    }
    return count;
}
