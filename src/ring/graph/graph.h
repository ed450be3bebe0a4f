// Operations in the order in which a program does them: what elements become when they are to be computed, not read.
//
// A graph keeps every operation once, so that whatever is asked for shares its parts: the sine and cosine of an angle
// are computed once, those of sums of angles follow by products, and what depends on constants alone is apart. It
// writes itself as C.
#ifndef RING_GRAPH_GRAPH_H
#define RING_GRAPH_GRAPH_H
#include "base/text.h"
#include "ring/ring.h"

typedef struct YkGraph YkGraph;
// A value: a node, and whether its negative is meant. All functions take YK_GRAPH_NONE and give it back; it is also
// what failure gives (memory, an element that is not real: then the ring's status tells).
typedef int32_t YkGraphValue;
enum { YK_GRAPH_NONE = -1 };

YkGraph *yk_graph_new(YkRing *ring); // NULL when out of memory
void yk_graph_free(YkGraph *graph);
bool yk_graph_failed(const YkGraph *graph);

YkGraphValue yk_graph_number(YkGraph *graph, double number);
YkGraphValue yk_graph_symbol(YkGraph *graph, int32_t symbol); // or what it is defined as
YkGraphValue yk_graph_negate(YkGraphValue a);
YkGraphValue yk_graph_add(YkGraph *graph, YkGraphValue a, YkGraphValue b);
YkGraphValue yk_graph_subtract(YkGraph *graph, YkGraphValue a, YkGraphValue b);
YkGraphValue yk_graph_multiply(YkGraph *graph, YkGraphValue a, YkGraphValue b);
YkGraphValue yk_graph_divide(YkGraph *graph, YkGraphValue a, YkGraphValue b);
// A real element: sums of (constants * sine or cosine), grouped by their products of coordinates and rates. Cost
// O(terms log terms).
YkGraphValue yk_graph_of(YkGraph *graph, const YkPoisson *a);

// From now on a symbol stands for a value (a body's angle for a sum of joint angles; what a line before has solved).
void yk_graph_define(YkGraph *graph, int32_t symbol, YkGraphValue value);
// Definitions made since the count was taken are taken back.
size_t yk_graph_definitions(const YkGraph *graph);
void yk_graph_forget(YkGraph *graph, size_t count);

// --- Values: numbers[yk_graph_size] of all nodes from completed values of the symbols; then those of values.
size_t yk_graph_size(const YkGraph *graph);
void yk_graph_evaluate(const YkGraph *graph, const double *symbols, double *numbers);
double yk_graph_number_of(YkGraphValue value, const double *numbers);

// --- C. A function's body: begin; want all that it computes; write the statements of shared parts; then put each value
// as an expression. Symbols are m->NAME; what depends on constants alone is m->constant[k], which the body of one more
// function computes: yk_graph_put_constants, at the end.
void yk_graph_begin(YkGraph *graph);
void yk_graph_want(YkGraph *graph, YkGraphValue value);
// A symbol that the function writes: read it before.
void yk_graph_writes(YkGraph *graph, int32_t symbol);
void yk_graph_put_shared(YkGraph *graph, YkText *text);
void yk_graph_put(YkGraph *graph, YkGraphValue value, YkText *text);
void yk_graph_put_constants(YkGraph *graph, YkText *text);
size_t yk_graph_constants(const YkGraph *graph);           // how many there are now
bool yk_graph_reads(const YkGraph *graph, int32_t symbol); // any function so far
size_t yk_graph_operations(const YkGraph *graph);          // of the present function: + - * / sqrt sin cos

#endif
