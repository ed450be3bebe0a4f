// The functions that formulas may call, by name and in numbers.
#ifndef GRAPH_FUNCTION_H
#define GRAPH_FUNCTION_H
#include <stdbool.h>

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
    YK_LOG10,
    YK_ABS,
    YK_SIGN,
    YK_MIN,
    YK_MAX,
    YK_FUNCTION_COUNT
} YkFunction;

const char *yk_function_name(YkFunction function);
int yk_function_arity(YkFunction function); // 1 or 2
bool yk_function_find(const char *name, YkFunction *function);
// Returns the function that an unknown name may have meant, or NULL.
const char *yk_function_nearest(const char *name);
// The value at one or two numbers, as formulas mean it; not finite where there is none.
double yk_function_value(YkFunction function, double a, double b);

#endif
