// The functions of expressions, by name.
#ifndef EXPR_FUNCTION_H
#define EXPR_FUNCTION_H
#include "expr/expr.h"

const char *yk_function_name(YkFunction function);
int yk_function_arity(YkFunction function); // 1 or 2
bool yk_function_find(const char *name, YkFunction *function);
// Returns the function that an unknown name may have meant, or NULL.
const char *yk_function_nearest(const char *name);

#endif
