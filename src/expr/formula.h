// Formulas: expressions prepared for millions of evaluations, with constants folded and names resolved to places in an
// array. They compute values only, and allocate nothing when evaluated.
#ifndef EXPR_FORMULA_H
#define EXPR_FORMULA_H
#include "expr/expr.h"

typedef struct YkFormula YkFormula;

// Resolves a name: a constant (sets value, returns -1) or variables[index] (returns the index >= 0).
// Returns -2 if it does not know the name.
typedef int (*YkResolve)(void *context, const YkExpr *name, double *value);

// Compiles an expression. Returns NULL when out of memory, and then the arena has failed, or if a name is unknown. The
// formula lives in the arena.
YkFormula *yk_formula_compile(const YkExpr *expr, YkResolve resolve, void *context, YkArena *arena);
bool yk_formula_is_constant(const YkFormula *formula); // eval then accepts NULL variables
// Returns the index of the variable that the formula is, by itself or (*sign -1) negated; or -1.
int yk_formula_variable(const YkFormula *formula, double *sign);
// Returns the value; not finite if the expression has none (division by zero, root of a negative number, ...).
double yk_formula_eval(const YkFormula *formula, const double *variables);
// Returns the exact derivative of the value where the variables change at the rates direction[index]; NaN if there is
// none. At a kink (abs, min, max) it is that just after it.
double yk_formula_slope(const YkFormula *formula, const double *variables, const double *direction);
// Does the same as yk_formula_eval for n <= YK_FORMULA_LANES sets of variables at once, variables[index][lane]. Returns
// the lanes of the value, in scratch[YK_FORMULA_SCRATCH] or a variable's own; they stay valid until scratch is used
// again.
enum { YK_FORMULA_LANES = 256, YK_FORMULA_SCRATCH = 34 * YK_FORMULA_LANES };
const double *yk_formula_lanes(const YkFormula *formula, const double *const *variables, double *scratch, size_t n);

#endif
