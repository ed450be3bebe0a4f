// The functions of expressions: their names and numbers of arguments.
#include "expr/function.h"
#include <string.h>
#include "base/names.h"

static const char *const names[YK_FUNCTION_COUNT] = {"sin",   "cos",  "tan",  "asin", "acos", "atan",
                                                     "atan2", "sinh", "cosh", "tanh", "sqrt", "exp",
                                                     "log",   "abs",  "sign", "min",  "max"};

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
    static const char *const others[][2] = {{"ln", "log"},      {"arcsin", "asin"},   {"arccos", "acos"},
                                            {"arctan", "atan"}, {"arctan2", "atan2"}, {"tg", "tan"},
                                            {"sgn", "sign"},    {"root", "sqrt"},     {"fabs", "abs"},
                                            {"sh", "sinh"},     {"ch", "cosh"},       {"th", "tanh"}};
    for (size_t i = 0; i < sizeof others / sizeof *others; i++)
        if (strcmp(others[i][0], name) == 0) return others[i][1];
    return yk_nearest(name, names, YK_FUNCTION_COUNT);
}
