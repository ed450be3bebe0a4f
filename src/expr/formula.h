// Formulas: expressions made ready to be evaluated millions of times - constants folded, names resolved to places in an
// array. Values only; allocates nothing when evaluated.
#ifndef EXPR_FORMULA_H
#define EXPR_FORMULA_H
#include "expr/expr.h"

typedef struct YkFormula YkFormula;

// What a name stands for: either a constant (value set, returns -1) or variables[index] (returns the index >= 0).
// -2: unknown here.
typedef int (*YkResolve)(void *context, const YkExpr *name, double *value);

// Compiles. NULL when out of memory or a name is unknown. Lives in the arena.
YkFormula *yk_formula_compile(const YkExpr *expr, YkResolve resolve, void *context, YkArena *arena);
bool yk_formula_is_constant(const YkFormula *formula); // then eval takes NULL variables
// The variable that it is as it stands or (*sign -1) negated; or -1.
int yk_formula_variable(const YkFormula *formula, double *sign);
bool yk_formula_depends_on(const YkFormula *formula, int variable);
// The value; not finite where the expression has none (division by zero, root of a negative number, ...).
double yk_formula_eval(const YkFormula *formula, const double *variables);
// One function of one or two numbers, as formulas mean it.
double yk_function_value(YkFunction function, double a, double b);
// The same as yk_formula_eval for n <= YK_FORMULA_LANES sets of variables at once, variables[index][lane]. Returns the
// lanes of the value, in scratch[YK_FORMULA_SCRATCH] or a variable's own; they stand until scratch is used again.
enum { YK_FORMULA_LANES = 64, YK_FORMULA_SCRATCH = 34 * YK_FORMULA_LANES };
const double *yk_formula_lanes(const YkFormula *formula, const double *const *variables, double *scratch, size_t n);

#endif
