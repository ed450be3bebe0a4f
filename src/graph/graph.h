// Operations in the order in which a program does them: every value that printed C computes, each once.
//
// Values are numbers, names that the program gets from outside (leaves), and operations on earlier values. Building a
// value folds constants, and returns an existing value if there is one. A value that depends only on parameters belongs
// to the machine and is computed once; all others belong to a pose.
#ifndef GRAPH_GRAPH_H
#define GRAPH_GRAPH_H
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include "base/memory.h"
#include "base/names.h"
#include "base/pace.h"
#include "graph/function.h"

typedef int32_t YkRef; // a value of the graph

typedef struct YkRefVec { // of a plane vector
    YkRef x, y;
} YkRefVec;

typedef enum YkValueKind {
    YK_VALUE_NUMBER,
    YK_VALUE_LEAF, // a value that the program finds under a name
    YK_VALUE_ADD,
    YK_VALUE_SUBTRACT,
    YK_VALUE_MULTIPLY,
    YK_VALUE_DIVIDE,
    YK_VALUE_MINUS,
    YK_VALUE_FUNCTION, // of formulas: sin ... max
    YK_VALUE_POWER,
    YK_VALUE_SINE, // a pair of one angle, the cosine right behind the sine
    YK_VALUE_COSINE,
    YK_VALUE_ANGLE,    // of a unit vector (b, a): in [-pi, pi]
    YK_VALUE_NEAREST,  // angle a, less as many turns as bring it nearest to b
    YK_VALUE_ROOT,     // sqrt(a), of 0 if a is negative
    YK_VALUE_PER_ROOT, // 1 / sqrt(a), of something tiny where a is less
    YK_VALUE_NONZERO,  // |a|, or something tiny for 0
    YK_VALUE_LEAST,    // the smaller of two
    YK_VALUE_LARGEST,
    YK_VALUE_SIZE,    // |a|
    YK_VALUE_CHOOSE,  // a < 0 ? b : c
    YK_VALUE_WITNESS, // 0, or NaN if a is not finite
    YK_VALUE_RESULT   // number b of call a
} YkValueKind;

typedef struct YkValue {
    YkValueKind op;
    YkRef a, b, c; // operands, or -1; RESULT: the call and which of its results
    YkFunction function;
    double number;
    const char *name;   // of a leaf; for another value the name to print it under, or NULL
    int32_t section;    // under which heading it is computed
    bool of_parameters; // depends on parameters alone
    int32_t leaf_class; // of a leaf: YkLeafClass
    YkRef sine;         // of one part of a unit vector: the other part; 0: none
} YkValue;

typedef enum YkLeafClass {
    YK_LEAF_PARAMETER, // of the machine
    YK_LEAF_POSE,      // of the pose: inputs, configuration, time
    YK_LEAF_UNKNOWN    // of a group: an unknown of Newton's method
} YkLeafClass;

// A piece of program that is not an expression: it takes several values and gives several.
typedef enum YkCallKind {
    YK_CALL_SOLVE, // linear equations: arguments A[n][n + m], the right sides behind; results the same places solved,
                   // then the determinant over the lengths of the columns
    YK_CALL_GROUP, // Newton's method on a group: arguments the guess; results the unknowns, then how far it misses
    YK_CALL_LAW,   // a law of motion: the argument; results value, first and second derivative
    YK_CALL_FRICTION, // sizes of forces that depend on each other, x_k = a_k |V_k + W_k x|, the first m as they follow:
                      // arguments a_k, V_k, W_k of all n; then x[n], n to work with, and 1 if they agree
    YK_CALL_MOTION    // equations of motion: arguments A[n][n + 1], symmetric; results the same places, the last column
                      // solved, then the least pivot over the terms of its energy
} YkCallKind;

typedef struct YkCall {
    YkCallKind kind;
    int32_t index; // group or law
    int32_t n, m;
    const YkRef *arguments;
    size_t argument_count, result_count;
    const char *name;
    int32_t section;
} YkCall;

// The working memory of derivatives, allocated once. An entry is valid only if it carries the latest stamp.
typedef struct YkGraphMemo {
    YkRef *slope;
    uint32_t *slope_stamp, *reach_stamp, newest; // by value
    size_t capacity;
    YkRef reached;          // reach_stamp: which values this value is made of ...
    uint32_t reached_stamp; // ... where it is this
} YkGraphMemo;

typedef struct YkGraph {
    YkGraphMemo memo;
    YkArena *arena;
    YkValue *values;
    size_t count, capacity;
    YkCall *calls;
    size_t call_count, call_capacity;
    const char **sections;
    size_t section_count, section_capacity;
    int32_t *table; // hash table of the values that exist already
    size_t table_size;
    YkNames leaves;    // values by name
    YkPace *pace;      // of the long call that fills it, or NULL
    bool failed;       // out of memory, or stopped
    bool joins_terms;  // sums join multiples of the same factors, and c^2 + s^2 = 1 of unit vectors
    bool shares_signs; // b - a becomes -(a - b) where a - b is there, and sums with negative numbers are differences;
                       // with joins_terms, a number multiplies each term of sums such as p x + q y, and parts along
                       // one direction are added before they are turned
} YkGraph;

bool yk_graph_start(YkGraph *graph, YkArena *arena);
void yk_graph_end(YkGraph *graph);
// Puts the following values under this heading.
void yk_graph_section(YkGraph *graph, const char *heading);
// Gives a value a name, unless it has one or is a plain number; returns the value.
YkRef yk_graph_name(YkGraph *graph, YkRef value, const char *format, ...);

// Formats a text in the graph's arena; never NULL.
char *yk_graph_text(YkGraph *graph, const char *format, ...);

// Returns a value with its operands set: an existing one, or a new one.
YkRef yk_graph_intern(YkGraph *graph, YkValue value);
// Returns the existing one; -1 if there is none.
YkRef yk_graph_find(const YkGraph *graph, YkValue value);
YkRef yk_graph_number(YkGraph *graph, double number);
YkRef yk_graph_leaf(YkGraph *graph, YkLeafClass leaf_class, const char *name);
YkRef yk_graph_add(YkGraph *graph, YkRef a, YkRef b);
YkRef yk_graph_subtract(YkGraph *graph, YkRef a, YkRef b);
YkRef yk_graph_multiply(YkGraph *graph, YkRef a, YkRef b);
YkRef yk_graph_divide(YkGraph *graph, YkRef a, YkRef b);
YkRef yk_graph_inverse(YkGraph *graph, YkRef a);
YkRef yk_graph_minus(YkGraph *graph, YkRef a);
YkRef yk_graph_power(YkGraph *graph, YkRef a, YkRef b);
YkRef yk_graph_function(YkGraph *graph, YkFunction function, YkRef a, YkRef b);
YkRef yk_graph_unary(YkGraph *graph, YkValueKind op, YkRef a);
YkRef yk_graph_binary(YkGraph *graph, YkValueKind op, YkRef a, YkRef b); // ANGLE: y, x; NEAREST, LEAST, LARGEST
YkRef yk_graph_choose(YkGraph *graph, YkRef sign, YkRef negative, YkRef otherwise);
YkRefVec yk_graph_unit(YkGraph *graph, YkRef angle); // (cos, sin)
// Notes that these values are the parts of a unit vector.
void yk_graph_is_unit(YkGraph *graph, YkRefVec v);
// fold_terms.c: return a + sign b in a simpler form, or number times product; YK_NONE if there is none, or the graph
// does not join terms.
YkRef yk_graph_join(YkGraph *graph, YkRef a, YkRef b, double sign);
YkRef yk_graph_join_numbers(YkGraph *graph, YkRef number, YkRef product);
// Returns value times quotient without the inverse of a length that both contain, as the two parts of a force along a
// normal do; YK_NONE if there is none.
YkRef yk_graph_cancel(YkGraph *graph, YkRef value, YkRef quotient);
// A call; the result `k` of it.
int32_t yk_graph_call(YkGraph *graph, YkCall call);
YkRef yk_graph_result(YkGraph *graph, int32_t call, size_t k);
// Counts the operations of the roots, each value once, without those that depend only on parameters.
size_t yk_graph_cost(const YkGraph *graph, const YkRef *roots, size_t count);
// Returns d value / d leaf, exact.
YkRef yk_graph_derivative(YkGraph *graph, YkRef value, YkRef leaf);
// Returns its derivative by one of its operands, the others held.
YkRef yk_graph_partial(YkGraph *graph, YkRef value, YkRef operand);
// Makes the derivatives of a value by all leaves at once, by_leaf[count], backwards from it: a few times its
// operations, whatever the number of leaves. Returns false if the value has a part that is not differentiated, or when
// out of memory.
// Source: Griewank & Walther 2008, Evaluating Derivatives. adjoint.c
bool yk_graph_adjoint(YkGraph *graph, YkRef value, const YkRef *leaves, size_t count, YkRef *by_leaf);

bool yk_graph_is_number(const YkGraph *graph, YkRef value, double number);
bool yk_graph_is_zero_vec(const YkGraph *graph, YkRefVec v);

// Plane vectors.
YkRefVec yk_graph_vec_number(YkGraph *graph, double x, double y);
YkRefVec yk_graph_vec_add(YkGraph *graph, YkRefVec a, YkRefVec b);
YkRefVec yk_graph_vec_subtract(YkGraph *graph, YkRefVec a, YkRefVec b);
YkRefVec yk_graph_vec_scale(YkGraph *graph, YkRef k, YkRefVec a);
YkRefVec yk_graph_vec_multiply(YkGraph *graph, YkRefVec a, YkRefVec b); // turn and stretch
YkRefVec yk_graph_vec_conjugate(YkGraph *graph, YkRefVec a);
YkRefVec yk_graph_vec_quarter(YkGraph *graph, YkRefVec a);
YkRef yk_graph_dot(YkGraph *graph, YkRefVec a, YkRefVec b);
YkRef yk_graph_vec_length(YkGraph *graph, YkRefVec a);
YkRef yk_graph_cross(YkGraph *graph, YkRefVec a, YkRefVec b);

#endif
