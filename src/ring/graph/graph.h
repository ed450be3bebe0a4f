// Operations in the order in which a program performs them: elements in a form to compute rather than to read.
//
// A graph keeps every operation once, so that all requested values share their parts: it computes the sine and cosine
// of an angle once, derives those of sums of angles by products, and separates what depends on constants alone. It
// writes itself as C.
#ifndef RING_GRAPH_GRAPH_H
#define RING_GRAPH_GRAPH_H
#include "base/text.h"
#include "ring/ring.h"

typedef struct YkGraph YkGraph;
// A value: a node, and whether its negative is meant. All functions accept YK_GRAPH_NONE and return it; they also
// return it on failure (no memory, or an element that is not real: the ring's status tells which).
typedef int32_t YkGraphValue;
enum { YK_GRAPH_NONE = -1 };

YkGraph *yk_graph_new(YkRing *ring); // NULL when out of memory
void yk_graph_free(YkGraph *graph);
bool yk_graph_failed(const YkGraph *graph);

YkGraphValue yk_graph_number(YkGraph *graph, double number);
YkGraphValue yk_graph_symbol(YkGraph *graph, int32_t symbol); // or the value that defines it
YkGraphValue yk_graph_negate(YkGraphValue a);
YkGraphValue yk_graph_add(YkGraph *graph, YkGraphValue a, YkGraphValue b);
YkGraphValue yk_graph_subtract(YkGraph *graph, YkGraphValue a, YkGraphValue b);
YkGraphValue yk_graph_multiply(YkGraph *graph, YkGraphValue a, YkGraphValue b);
YkGraphValue yk_graph_divide(YkGraph *graph, YkGraphValue a, YkGraphValue b);
// Adds a real element: sums of (constants * sine or cosine), grouped by their products of coordinates and rates. Cost
// O(terms log terms).
YkGraphValue yk_graph_of(YkGraph *graph, const YkPoisson *a);

// Lets a symbol stand for a value from now on (a body's angle for a sum of joint angles; what an earlier line has
// solved).
void yk_graph_define(YkGraph *graph, int32_t symbol, YkGraphValue value);
// Takes back the definitions made since the count was read.
size_t yk_graph_definitions(const YkGraph *graph);
void yk_graph_forget(YkGraph *graph, size_t count);

// --- Values: numbers[yk_graph_size] of all nodes from completed values of the symbols; then those of values.
size_t yk_graph_size(const YkGraph *graph);
void yk_graph_evaluate(const YkGraph *graph, const double *symbols, double *numbers);
double yk_graph_number_of(YkGraphValue value, const double *numbers);

// --- C. The body of a function: begin; want everything it computes; write the statements of shared parts; then put
// each value as an expression. Symbols are m->NAME; what depends on constants alone is m->constant[k], which the body
// of one more function computes: yk_graph_put_constants, at the end.
void yk_graph_begin(YkGraph *graph);
void yk_graph_want(YkGraph *graph, YkGraphValue value);
// Declares a symbol that the function writes: call it before the symbol is read.
void yk_graph_writes(YkGraph *graph, int32_t symbol);
void yk_graph_put_shared(YkGraph *graph, YkText *text);
void yk_graph_put(YkGraph *graph, YkGraphValue value, YkText *text);
void yk_graph_put_constants(YkGraph *graph, YkText *text);
size_t yk_graph_constants(const YkGraph *graph);           // how many there are so far
bool yk_graph_reads(const YkGraph *graph, int32_t symbol); // whether any function so far reads it
size_t yk_graph_operations(const YkGraph *graph);          // in the present function: + - * / sqrt sin cos

#endif
