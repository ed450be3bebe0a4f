// Expressions of the model file: numbers with units, parameters, coordinates, time; dimension-checked, evaluated with
// derivatives in time.
#ifndef EXPR_EXPR_H
#define EXPR_EXPR_H
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include "base/memory.h"
#include "base/problems.h"
#include "base/units/units.h"
#include "graph/function.h"

typedef enum YkExprKind {
    YK_EXPR_NUMBER, // value (in its unit), exact decimal kept; has_unit
    YK_EXPR_NAME,   // a parameter, `t`, `pi`, a coordinate, `coordinate.rate`
    YK_EXPR_NEGATE,
    YK_EXPR_ADD,
    YK_EXPR_SUBTRACT,
    YK_EXPR_MULTIPLY,
    YK_EXPR_DIVIDE,
    YK_EXPR_POWER,
    YK_EXPR_CALL // sin cos tan asin acos atan atan2 sinh cosh tanh sqrt exp log log10 abs sign min max
} YkExprKind;

typedef struct YkExpr YkExpr;
struct YkExpr {
    YkExprKind kind;
    YkPlace place;
    const char *text; // its place in the parsed text; NULL if it does not come from one
    size_t text_length;
    // number
    double number;    // as written, before its unit
    int64_t mantissa; // number = mantissa * 10^exponent when is_exact
    int32_t exponent;
    bool is_exact, has_unit;
    double unit_size; // SI value = number * unit_size
    YkDimension unit;
    // name
    const char *name;
    // operators and calls
    YkFunction function;
    const YkExpr *a, *b; // b NULL for one operand
    double value_scale;  // set by dimension inference: SI value of a bare number = number * value_scale (1 until then)
    // The inference's own notes:
    YkDimension dimension;
    uint8_t state;
    bool is_literal; // made of bare numbers, angles, pi and functions alone
    int32_t parameter;
};

// Limits on the nesting of parentheses, signs and powers; and on the height of the tree, which grows with the number of
// terms in a sum.
enum { YK_EXPR_DEPTH_MAX = 200, YK_EXPR_HEIGHT_MAX = 1000 };

// Parses text; place is the position of its first character in the file, and columns follow from it. Returns NULL with
// problems on a mistake. Grammar: + - * / ^ with the usual precedence (^ right-associative, binds tighter than unary
// minus), parentheses, calls, names [A-Za-z_][A-Za-z0-9_]* with dots, and numbers. A unit is one word without spaces
// right after a number or a ratio of integers: `3/4 m` is 3/4 of a metre; `30deg`; `0.5 rad/s * t` is a product because
// of the spaces around *.
YkExpr *yk_expr_parse(const char *text, size_t length, YkPlace place, YkArena *arena, YkProblems *problems);

// Derivatives with respect to time: value and first four derivatives.
enum { YK_JET_ORDER = 4 };
typedef struct YkJet {
    double d[YK_JET_ORDER + 1];
} YkJet;

// Gives the jet of a name (a constant has zero derivatives); returns false if the name has none at this place.
typedef bool (*YkLookup)(const void *context, const YkExpr *name, YkJet *jet);
// Evaluates in SI with derivatives by truncated Taylor arithmetic. Returns NULL on success, otherwise the
// sub-expression at fault (division by zero, sqrt of a negative, log of 0, overflow, ...) with *why set to a static
// phrase such as "division by zero". At a kink (abs, min, max) the derivatives are those just after it. sqrt(t) at t =
// 0 has no derivative, which is a fault; it is 0 for jets without derivatives, when only values are needed. `pi` needs
// no lookup, but may have one.
const YkExpr *yk_expr_eval(const YkExpr *expr, YkLookup lookup, const void *context, YkJet *result, const char **why);

// Returns how much rounding may have changed the value, to first order: the rounding of numbers, parameters and
// operations, propagated. The time itself is exact. INFINITY if the expression has no value.
double yk_expr_rounding(const YkExpr *expr, YkLookup lookup, const void *context);

// Returns whether the expression mentions this name exactly.
bool yk_expr_mentions(const YkExpr *expr, const char *name);
bool yk_expr_has_names(const YkExpr *expr); // any name, including pi
// Calls visit for every name in it, left to right.
void yk_expr_names(const YkExpr *expr, void (*visit)(void *context, const YkExpr *name), void *context);

// Dimension inference over a whole file. A bare number or bare parameter takes the dimension of its use. An expression
// made only of bare numbers, angles, pi and functions is a bare number; as a factor of anything else it is a plain
// number. Usage: create; declare each parameter with its expression; add every use (expression, expected dimension);
// then run.
typedef struct YkDimensions YkDimensions;
YkDimensions *yk_dimensions_new(YkArena *arena, const YkUnits *units);
// Fixes the dimension of a name from outside (t: a time, a coordinate: an angle or a length, pi: a number).
void yk_dimensions_fix(YkDimensions *dims, const char *name, YkDimension dimension);
// Declares a parameter, whose dimension follows from its expression or its uses.
void yk_dimensions_parameter(YkDimensions *dims, const char *name, YkExpr *expr);
// Adds an expression used where `expected` is wanted; `what` names it in messages ("mass of `link1`", copied into the
// arena by the caller).
void yk_dimensions_use(YkDimensions *dims, YkExpr *expr, YkDimension expected, const char *what);
// Infers all dimensions, reports every contradiction (mixed sums, `mass: 3 mm`, one parameter used in two ways), and
// sets value_scale of every bare number. The caller must have reported unknown names; they are skipped here. Returns
// false on errors.
bool yk_dimensions_run(YkDimensions *dims, YkProblems *problems);
// Returns whether people use the unit of a bare number of this dimension. They do not use kg*mm/s^2 for a force:
// inference warns of it.
bool yk_dimensions_is_usual(const YkUnits *units, YkDimension dimension);
// Finds the dimension of a parameter; returns false if it stayed open because nothing uses it: it then counts as a
// number.
bool yk_dimensions_of(const YkDimensions *dims, const char *name, YkDimension *dimension);

#endif
