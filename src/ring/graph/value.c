// Evaluates a graph in numbers.
#include <math.h>
#include "elementary/elementary.h"
#include "ring/graph/inside.h"

void yk_graph_evaluate(const YkGraph *graph, const double *symbols, double *numbers)
{
    for (size_t k = 0; k < graph->count; k++) {
        const YkGraphNode *node = &graph->nodes[k];
        double a = node->operation > YK_OP_SYMBOL ? numbers[node->a] : 0, b = node->b >= 0 ? numbers[node->b] : 0;
        switch (node->operation) {
        case YK_OP_NUMBER:
            numbers[k] = node->number;
            break;
        case YK_OP_SYMBOL:
            numbers[k] = symbols[node->a];
            break;
        case YK_OP_ADD:
            numbers[k] = a + b;
            break;
        case YK_OP_SUBTRACT:
            numbers[k] = a - b;
            break;
        case YK_OP_MULTIPLY:
            numbers[k] = a * b;
            break;
        case YK_OP_DIVIDE:
            numbers[k] = a / b;
            break;
        case YK_OP_SIN:
            numbers[k] = yk_sin(a);
            break;
        case YK_OP_COS:
            numbers[k] = yk_cos(a);
            break;
        case YK_OP_SQRT:
            numbers[k] = sqrt(a);
            break;
        }
    }
}

size_t yk_graph_size(const YkGraph *graph)
{
    return graph->count;
}

double yk_graph_number_of(YkGraphValue value, const double *numbers)
{
    if (value < 0) return NAN;
    return value & 1 ? -numbers[value >> 1] : numbers[value >> 1];
}
