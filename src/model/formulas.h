// Expressions of the model as fast formulas of time, coordinates and rates.
#ifndef MODEL_FORMULAS_H
#define MODEL_FORMULAS_H
#include "expr/formula.h"
#include "model/model.h"

// Says which variable a declared coordinate (or its rate) is: its index, above 0; negative where it has none.
typedef int (*YkCoordinateVariable)(void *context, int32_t model_coordinate, bool is_rate);

// Compiles an expression of a loaded model. Parameters become constants, `t` is variable 0; NAME, NAME.rate,
// JOINT.angle, JOINT.distance and their rates are what coordinate_variable (NULL: none is known) says. NULL when out of
// memory or a name is unknown. The formula lives in the arena. Cost linear in the expression.
YkFormula *yk_model_formula(const YkModel *model, const YkExpr *expr, YkCoordinateVariable coordinate_variable,
                            void *context, YkArena *arena);

#endif
