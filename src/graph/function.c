// The functions of expressions: their names, numbers of arguments and values.
#include "graph/function.h"
#include <math.h>
#include <string.h>
#include "base/names.h"
#include "elementary/elementary.h"

static const char *const names[YK_FUNCTION_COUNT] = {"sin",   "cos",   "tan",  "asin", "acos", "atan",
                                                     "atan2", "sinh",  "cosh", "tanh", "sqrt", "exp",
                                                     "log",   "log10", "abs",  "sign", "min",  "max"};

const char *yk_function_name(YkFunction function)
{
    return names[function];
}

int yk_function_arity(YkFunction function)
{
    return function == YK_ATAN2 || function == YK_MIN || function == YK_MAX ? 2 : 1;
}

bool yk_function_find(const char *name, YkFunction *function)
{
    for (int i = 0; i < YK_FUNCTION_COUNT; i++) {
        if (strcmp(names[i], name) != 0) continue;
        *function = (YkFunction)i;
        return true;
    }
    return false;
}

const char *yk_function_nearest(const char *name)
{
    static const char *const others[][2] = {
        {"ln", "log"},        {"lg", "log10"}, {"arcsin", "asin"}, {"arccos", "acos"}, {"arctan", "atan"},
        {"arctan2", "atan2"}, {"tg", "tan"},   {"sgn", "sign"},    {"root", "sqrt"},   {"fabs", "abs"},
        {"sh", "sinh"},       {"ch", "cosh"},  {"th", "tanh"}};
    for (size_t i = 0; i < sizeof others / sizeof *others; i++)
        if (strcmp(others[i][0], name) == 0) return others[i][1];
    return yk_nearest(name, names, YK_FUNCTION_COUNT);
}

double yk_function_value(YkFunction function, double a, double b)
{
    switch (function) {
    case YK_SIN:
        return yk_sin(a);
    case YK_COS:
        return yk_cos(a);
    case YK_TAN:
        return yk_tan(a);
    case YK_ASIN:
        return yk_asin(a);
    case YK_ACOS:
        return yk_acos(a);
    case YK_ATAN:
        return yk_atan(a);
    case YK_ATAN2:
        return a == 0 && b == 0 ? NAN : yk_atan2(a, b);
    case YK_SINH:
        return yk_sinh(a);
    case YK_COSH:
        return yk_cosh(a);
    case YK_TANH:
        return yk_tanh(a);
    case YK_SQRT:
        return sqrt(a);
    case YK_EXP:
        return yk_exp(a);
    case YK_LOG:
        return yk_log(a);
    case YK_LOG10:
        return yk_log10(a);
    case YK_ABS:
        return fabs(a);
    case YK_SIGN:
        return (a > 0) - (a < 0);
    case YK_MIN:
        return a <= b ? a : b;
    case YK_MAX:
        return a >= b ? a : b;
    case YK_FUNCTION_COUNT:
        break;
    }
    return NAN;
}
