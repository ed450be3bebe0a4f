// The inside of dimension inference; no other room includes it.
#ifndef EXPR_DIMENSION_H
#define EXPR_DIMENSION_H
#include "expr/expr.h"

// The knowledge about a node of an expression, kept in its `state`.
typedef enum YkDimState {
    YK_DIM_SKIP,    // not judged: it contains an unknown name, or a mistake that is reported elsewhere
    YK_DIM_OPEN,    // depends on parameters whose dimension has not been found yet
    YK_DIM_BARE,    // a number made only of numbers without units, angles and functions: takes any dimension
    YK_DIM_BARE_PI, // the same with pi in it: angles in it are in radians
    YK_DIM_KNOWN
} YkDimState;

typedef struct YkConstraint YkConstraint;

typedef struct YkDimName {
    const char *name;
    YkExpr *expr; // the parameter's; NULL if the dimension is fixed from outside
    YkDimension dimension;
    bool is_known, is_default;  // default: a number because nothing else decided it
    const YkConstraint *origin; // the use that gave it its dimension; NULL if its own expression did
    YkPlace origin_place;
} YkDimName;

// An expression that must have the dimension of its use, or of its parameter.
struct YkConstraint {
    YkExpr *expr;
    YkDimension expected;
    const char *what;
    int32_t parameter; // the parameter whose value it is; -1 for a use
    bool is_queued;
};

// The phases of inference. Each adds rules, so that the surest evidence comes first.
typedef enum YkDimPhase {
    YK_PHASE_OWN,    // parameters by their own expressions
    YK_PHASE_DIRECT, // and by uses that name their dimension: terms of sums, arguments, bare values
    YK_PHASE_SOLVE,  // and by products and powers with one unknown
    YK_PHASE_FINAL   // everything is known: numbers get their scales, contradictions are reported
} YkDimPhase;

struct YkDimensions {
    YkArena *arena;
    YkUnits units;
    YkDimName *names;
    size_t name_count, name_capacity;
    YkConstraint *constraints;
    size_t constraint_count, constraint_capacity;
    int32_t *slots; // hash table of names: index + 1, 0 = empty; slot_count is a power of two
    size_t slot_count;
    // The constraints that mention name i: dependents[first_dependent[i] .. first_dependent[i + 1]).
    size_t *first_dependent;
    int32_t *dependents;
    int32_t *queue; // constraints to visit again: a ring buffer of constraint_count places
    size_t queue_first, queue_count;
    YkDimPhase phase;
    YkConstraint *current;
    YkProblems *problems; // NULL before the last phase
    bool failed, has_errors, has_warned;
};

// Queues a constraint, unless it is queued or the phase leaves it out.
void yk_dim_queue(YkDimensions *dims, int32_t index);
// Sets the dimension of an open name and queues the constraints that depend on it. origin NULL: from its own
// expression.
void yk_dim_set(YkDimensions *dims, int32_t name, YkDimension dimension, const YkConstraint *origin, YkPlace place);

// Finds state and dimension of the expression and all its parts from the leaves up. In the last phase it reports what
// does not fit inside it.
void yk_dim_up(YkDimensions *dims, YkExpr *expr);
// Gives the expression, and so its parts, the dimension that its place requires (NULL: none in particular). Sets open
// parameters and the scales of bare numbers. is_direct: no other quantity contributed to `want`.
void yk_dim_down(YkDimensions *dims, YkExpr *expr, const YkDimension *want, bool is_direct);

bool yk_dim_is_bare(const YkExpr *expr);
// Finds the value of an expression of plain numbers only, such as an exponent. Returns false if it contains anything
// else.
bool yk_dim_literal(const YkExpr *expr, double *value);
// Computes dimension^power; returns false if the exponents are not whole (that of the angle does not count; it becomes
// 0).
bool yk_dim_power(YkDimension dimension, double power, YkDimension *result);
// Returns, of two equal dimensions, the one with an angle, since only that converts bare numbers.
YkDimension yk_dim_richer(YkDimension a, YkDimension b);
#define YK_DIM_NONE ((YkDimension){0, 0, 0, 0})

// Writes `whole` with the units that the numbers of `part`, a part of it, lack: `missing` is the dimension that `part`
// should have, divided by the one it has. Returns false if no number can take them.
bool yk_dim_repair(const YkUnits *units, const YkExpr *whole, const YkExpr *part, YkDimension missing, YkText *text);

// Reports; they do nothing before the last phase.
void yk_dim_report_use(YkDimensions *dims, const YkExpr *expr, YkDimension wanted);
void yk_dim_report_pair(YkDimensions *dims, const YkExpr *expr); // the dimensions of its two operands differ
void yk_dim_report_argument(YkDimensions *dims, const YkExpr *call, YkDimension wanted);
void yk_dim_report_power(YkDimensions *dims, const YkExpr *expr);
void yk_dim_report_exponent(YkDimensions *dims, const YkExpr *exponent);
void yk_dim_report_two_ways(YkDimensions *dims, const YkExpr *name, YkDimension wanted);
// Warns that a parameter without a unit is an angle by another use, and multiplies here what must have no angle.
void yk_dim_warn_of_factor(YkDimensions *dims, const YkExpr *expr);
// Gives a bare number this dimension; warns if the file's units then make a unit that no one would mean.
void yk_dim_warn_of_unit(YkDimensions *dims, const YkExpr *number, YkDimension dimension);

#endif
