// Compiles expressions of the model into fast formulas of time, coordinates and rates.
#ifndef MODEL_FORMULAS_H
#define MODEL_FORMULAS_H
#include "expr/formula.h"
#include "model/model.h"

// Returns the variable of a declared coordinate (or its rate), or with YK_NONE of the spring's own length: an index
// above 0; negative if it has none.
typedef int (*YkCoordinateVariable)(void *context, int32_t model_coordinate, bool is_rate);

// Compiles an expression of a loaded model. Parameters become constants, `t` is variable 0; coordinate_variable (NULL:
// none is known) gives the variables of NAME, NAME.rate, JOINT.angle, JOINT.distance and their rates. Returns NULL when
// out of memory or a name is unknown. The formula lives in the arena. Cost linear in the expression.
YkFormula *yk_model_formula(const YkModel *model, const YkExpr *expr, YkCoordinateVariable coordinate_variable,
                            void *context, YkArena *arena);

#endif
