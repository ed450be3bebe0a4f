// The graph of a program: every value that the printed C computes, each once.
//
// Values are numbers, names that the program gets from outside (leaves), and operations on earlier values. Building a
// value folds constants, and returns an existing value if there is one. A value that depends only on parameters belongs
// to the machine and is computed once; all others belong to a pose.
#ifndef CODE_DAG_H
#define CODE_DAG_H
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include "base/memory.h"
#include "base/names.h"
#include "expr/expr.h"

typedef int32_t YkRef; // a value of the graph

typedef struct YkRefVec { // of a plane vector
    YkRef x, y;
} YkRefVec;

typedef enum YkValueKind {
    YK_VALUE_NUMBER,
    YK_VALUE_LEAF, // what the program finds under a name
    YK_VALUE_ADD,
    YK_VALUE_SUBTRACT,
    YK_VALUE_MULTIPLY,
    YK_VALUE_DIVIDE,
    YK_VALUE_MINUS,
    YK_VALUE_FUNCTION, // of expressions: sin ... max
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
    YK_VALUE_WITNESS, // 0, or NaN where a is not finite
    YK_VALUE_RESULT   // number b of call a
} YkValueKind;

typedef struct YkValue {
    YkValueKind op;
    YkRef a, b, c; // operands, or -1; RESULT: the call and which of its results
    YkFunction function;
    double number;
    const char *name;   // of a leaf; of others what to call it, or NULL
    int32_t section;    // under which heading it is computed
    bool of_parameters; // depends on parameters alone
    int32_t leaf_class; // of a leaf: YkLeafClass
} YkValue;

typedef enum YkLeafClass {
    YK_LEAF_PARAMETER, // of the machine
    YK_LEAF_POSE,      // of the pose: inputs, configuration, time
    YK_LEAF_UNKNOWN    // of a group: what Newton's method looks for
} YkLeafClass;

// A piece of program that is not an expression: it takes several values and gives several.
typedef enum YkCallKind {
    YK_CALL_SOLVE, // linear equations: arguments A[n][n + m], the right sides behind; results the same places solved,
                   // then the determinant over the lengths of the columns
    YK_CALL_GROUP, // Newton's method on a group: arguments the guess; results the unknowns, then how far it misses
    YK_CALL_LAW    // a law of motion: the argument; results value, first and second derivative
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

// What derivatives remember about values: room made once, whose entries count only with the latest stamp.
typedef struct YkDagMemo {
    YkRef *slope;
    uint32_t *slope_stamp, *reach_stamp, newest; // by value
    size_t capacity;
    YkRef reached;          // reach_stamp tells what this value is made of ...
    uint32_t reached_stamp; // ... where it is this
} YkDagMemo;

typedef struct YkDag {
    YkDagMemo memo;
    YkArena *arena;
    YkValue *values;
    size_t count, capacity;
    YkCall *calls;
    size_t call_count, call_capacity;
    const char **sections;
    size_t section_count, section_capacity;
    int32_t *table; // of what is there already
    size_t table_size;
    YkNames leaves; // values by name
    bool failed;    // out of memory
} YkDag;

bool yk_dag_start(YkDag *graph, YkArena *arena);
void yk_dag_end(YkDag *graph);
// Puts the following values under this heading.
void yk_dag_section(YkDag *graph, const char *heading);
// Gives a value a name, unless it has one or is a plain number; returns the value.
YkRef yk_dag_name(YkDag *graph, YkRef value, const char *format, ...);

// Returns a value with its operands set: an existing one, or a new one.
YkRef yk_dag_intern(YkDag *graph, YkValue value);
YkRef yk_dag_number(YkDag *graph, double number);
YkRef yk_dag_leaf(YkDag *graph, YkLeafClass leaf_class, const char *name);
YkRef yk_dag_add(YkDag *graph, YkRef a, YkRef b);
YkRef yk_dag_subtract(YkDag *graph, YkRef a, YkRef b);
YkRef yk_dag_multiply(YkDag *graph, YkRef a, YkRef b);
YkRef yk_dag_divide(YkDag *graph, YkRef a, YkRef b);
YkRef yk_dag_inverse(YkDag *graph, YkRef a);
YkRef yk_dag_minus(YkDag *graph, YkRef a);
YkRef yk_dag_power(YkDag *graph, YkRef a, YkRef b);
YkRef yk_dag_function(YkDag *graph, YkFunction function, YkRef a, YkRef b);
YkRef yk_dag_unary(YkDag *graph, YkValueKind op, YkRef a);
YkRef yk_dag_binary(YkDag *graph, YkValueKind op, YkRef a, YkRef b); // ANGLE: y, x; NEAREST, LEAST, LARGEST
YkRef yk_dag_choose(YkDag *graph, YkRef sign, YkRef negative, YkRef otherwise);
YkRefVec yk_dag_unit(YkDag *graph, YkRef angle); // (cos, sin)
// A call; the result `k` of it.
int32_t yk_dag_call(YkDag *graph, YkCall call);
YkRef yk_dag_result(YkDag *graph, int32_t call, size_t k);
// Counts the operations of the roots, each value once, without those that depend only on parameters.
size_t yk_dag_cost(const YkDag *graph, const YkRef *roots, size_t count);
// Returns d value / d leaf, exact. memo: one entry per present value, -1 if not known yet.
YkRef yk_dag_derivative(YkDag *graph, YkRef value, YkRef leaf);

bool yk_dag_is_number(const YkDag *graph, YkRef value, double number);
bool yk_dag_is_zero_vec(const YkDag *graph, YkRefVec v);

// Plane vectors.
YkRefVec yk_dag_vec_number(YkDag *graph, double x, double y);
YkRefVec yk_dag_vec_add(YkDag *graph, YkRefVec a, YkRefVec b);
YkRefVec yk_dag_vec_subtract(YkDag *graph, YkRefVec a, YkRefVec b);
YkRefVec yk_dag_vec_scale(YkDag *graph, YkRef k, YkRefVec a);
YkRefVec yk_dag_vec_multiply(YkDag *graph, YkRefVec a, YkRefVec b); // turn and stretch
YkRefVec yk_dag_vec_conjugate(YkDag *graph, YkRefVec a);
YkRefVec yk_dag_vec_quarter(YkDag *graph, YkRefVec a);
YkRef yk_dag_dot(YkDag *graph, YkRefVec a, YkRefVec b);
YkRef yk_dag_cross(YkDag *graph, YkRefVec a, YkRefVec b);

#endif
