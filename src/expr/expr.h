// Expressions of the model file: numbers with units, parameters, coordinates, time; dimension-checked, evaluated with
// derivatives in time.
#ifndef EXPR_EXPR_H
#define EXPR_EXPR_H
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include "base/memory.h"
#include "base/problems.h"
#include "base/units.h"

typedef enum YkExprKind {
    YK_EXPR_NUMBER, // value (in its unit), exact decimal kept; has_unit
    YK_EXPR_NAME,   // a parameter, `t`, `pi`, a coordinate, `coordinate.rate`
    YK_EXPR_NEGATE,
    YK_EXPR_ADD,
    YK_EXPR_SUBTRACT,
    YK_EXPR_MULTIPLY,
    YK_EXPR_DIVIDE,
    YK_EXPR_POWER,
    YK_EXPR_CALL // sin cos tan asin acos atan atan2 sinh cosh tanh sqrt exp log abs sign min max
} YkExprKind;

typedef enum YkFunction {
    YK_SIN,
    YK_COS,
    YK_TAN,
    YK_ASIN,
    YK_ACOS,
    YK_ATAN,
    YK_ATAN2,
    YK_SINH,
    YK_COSH,
    YK_TANH,
    YK_SQRT,
    YK_EXP,
    YK_LOG,
    YK_ABS,
    YK_SIGN,
    YK_MIN,
    YK_MAX,
    YK_FUNCTION_COUNT
} YkFunction;

typedef struct YkExpr YkExpr;
struct YkExpr {
    YkExprKind kind;
    YkPlace place;
    const char *text; // where it stands in the text that was parsed; NULL where it does not come from one
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
    int32_t symbol; // resolved by yk_expr_resolve; YK_SYMBOL_* or index
    // operators and calls
    YkFunction function;
    const YkExpr *a, *b; // b NULL for one operand
    double value_scale;  // set by dimension inference: SI value of a bare number = number * value_scale (1 until then)
    // the inference's own notes
    YkDimension dimension;
    uint8_t state;
    bool is_literal; // made of bare numbers, angles, pi and functions alone
    int32_t parameter;
};

// What a name in an expression stands for.
typedef struct YkSymbol {
    const char *name;
    YkDimension dimension;
    bool dimension_known;
} YkSymbol;

// Depth of parentheses, signs and powers; and of the tree, which a sum of many terms makes as deep as it is long.
enum { YK_EXPR_DEPTH_MAX = 200, YK_EXPR_HEIGHT_MAX = 1000 };

// Parses text (place = where its first character stands in the file; columns follow). NULL with problems on a mistake.
// Grammar: + - * / ^ with the usual precedence (^ right-associative, binds tighter than unary minus), parentheses,
// calls, names [A-Za-z_][A-Za-z0-9_]* with dots, and numbers. A unit is one word without spaces right after a number or
// a ratio of integers: `3/4 m` is 3/4 of a metre; `30deg`; `0.5 rad/s * t` is a product because of the spaces around *.
YkExpr *yk_expr_parse(const char *text, size_t length, YkPlace place, YkArena *arena, YkProblems *problems);

// Derivatives with respect to time: value and first four derivatives.
enum { YK_JET_ORDER = 4 };
typedef struct YkJet {
    double d[YK_JET_ORDER + 1];
} YkJet;

// Gives the jet of a name (a constant has zero derivatives); returns false where the name has none at this place.
typedef bool (*YkLookup)(const void *context, const YkExpr *name, YkJet *jet);
// Evaluates in SI with derivatives by truncated Taylor arithmetic. Returns NULL when well, otherwise the sub-expression
// at fault (division by zero, sqrt of a negative, log of 0, overflow, ...) with *why set to a static phrase such as
// "division by zero". Where a function has a kink (abs, min, max) the derivatives are those just after. sqrt(t) at t =
// 0 has no derivative and is a fault; who wants values only gives jets without derivatives, and then it is 0. `pi`
// needs no lookup, but may have one.
const YkExpr *yk_expr_eval(const YkExpr *expr, YkLookup lookup, const void *context, YkJet *result, const char **why);

// By how much rounding may have moved the value, to first order: what the numbers, the parameters and each operation
// round off, carried on. The time itself is exact. INFINITY where the expression has no value.
double yk_expr_rounding(const YkExpr *expr, YkLookup lookup, const void *context);

// Does the expression mention this name (exactly)?
bool yk_expr_mentions(const YkExpr *expr, const char *name);
bool yk_expr_has_names(const YkExpr *expr); // any, pi among them
// Calls visit for every name in it, left to right.
void yk_expr_names(const YkExpr *expr, void (*visit)(void *context, const YkExpr *name), void *context);

// Dimension inference over a whole file.
// A bare number or bare parameter takes the dimension of its use. An expression of bare numbers, angles, pi and
// functions alone is a bare number; as a factor of anything else it is a plain number. Usage: create; declare each
// parameter with its expression; add every use (expression, expected dimension); then run.
typedef struct YkDimensions YkDimensions;
YkDimensions *yk_dimensions_new(YkArena *arena, const YkUnits *units);
// A name with a dimension fixed from outside (t: a time, a coordinate: an angle or a length, pi: a number).
void yk_dimensions_fix(YkDimensions *dims, const char *name, YkDimension dimension);
// A parameter, whose dimension follows from its expression or its uses.
void yk_dimensions_parameter(YkDimensions *dims, const char *name, YkExpr *expr);
// An expression used where `expected` is wanted; `what` names it in messages ("mass of `link1`", copied into the arena
// by the caller).
void yk_dimensions_use(YkDimensions *dims, YkExpr *expr, YkDimension expected, const char *what);
// Infers all, reports every contradiction (mixed sums, `mass: 3 mm`, one parameter used in two ways), and sets
// value_scale of every bare number. Unknown names must have been reported by the caller; they are skipped here. Returns
// false on errors.
bool yk_dimensions_run(YkDimensions *dims, YkProblems *problems);
// Is the unit of a bare number of this dimension one that people use? Not so a force in kg*mm/s^2, which inference
// warns of.
bool yk_dimensions_is_usual(const YkUnits *units, YkDimension dimension);
// The dimension found for a parameter; false when it stayed open (nothing uses it): then it counts as a number.
bool yk_dimensions_of(const YkDimensions *dims, const char *name, YkDimension *dimension);

#endif
