// What the files of graphs share.
#ifndef RING_GRAPH_INSIDE_H
#define RING_GRAPH_INSIDE_H
#include "ring/graph/graph.h"
#include "ring/inside.h"

typedef enum YkOperation {
    YK_OP_NUMBER,
    YK_OP_SYMBOL,
    YK_OP_ADD,
    YK_OP_SUBTRACT,
    YK_OP_MULTIPLY,
    YK_OP_DIVIDE,
    YK_OP_SIN,
    YK_OP_COS,
    YK_OP_SQRT
} YkOperation;

typedef struct YkGraphNode {
    YkOperation operation;
    int32_t a, b;  // nodes, none of them negative; a is the symbol of a symbol node
    double number; // value of a number
    uint32_t depth;
    bool is_constant; // depends on constants alone
    bool is_wanted;   // by the present function
    uint32_t uses;    // in that function
    int32_t name;     // number of its variable in that function, from 1; 0: none
    int32_t constant; // index among the constants, or -1
} YkGraphNode;

struct YkGraph {
    YkRing *ring;
    YkGraphNode *nodes; // parts come before wholes
    size_t count, capacity;
    int32_t *slots; // node + 1, 0 is free
    size_t slot_count;
    YkGraphValue *defined; // per symbol, or YK_GRAPH_NONE
    size_t defined_count;
    struct YkGraphDefinition {
        int32_t symbol;
        YkGraphValue before;
    } * definitions;
    size_t definition_count, definition_capacity;
    int32_t *constants; // nodes
    size_t constant_count, constant_capacity;
    bool *is_read, *is_written; // per symbol: read by any function; written by the present one
    int32_t name_count;
    bool is_of_constants; // whether the present function computes them
    bool failed;
};

// A part nested more deeply than this gets a variable of its own.
enum { YK_GRAPH_DEPTH_MAX = 24 };

YkGraphValue yk_graph_node(YkGraph *graph, YkOperation operation, int32_t a, int32_t b, double number);
YkGraphValue yk_graph_function(YkGraph *graph, YkOperation operation, YkGraphValue argument);

#endif
