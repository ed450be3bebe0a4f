// Differentiates formulas exactly, forward beside the value.
#include <math.h>
#include "expr/formula_inside.h"
#include "expr/jet.h"

// Returns the slope of a function or a power from its Taylor series; NaN if it has none.
static double slope_of_series(int operation, const double value[2], const double slope[2])
{
    YkSeries a = {{value[0], slope[0]}}, b = {{value[1], slope[1]}}, result;
    bool is_power = operation == YK_EXPR_POWER || operation == YK_OPERATION_WHOLE_POWER;
    const char *why = is_power ? yk_series_power(&a, &b, &result)
                               : yk_series_function((YkFunction)(operation - YK_OPERATION_FUNCTION), &a, &b, &result);
    return why ? NAN : result.c[1];
}

static double slope_of(int operation, const double value[2], const double slope[2])
{
    switch (operation) {
    case YK_EXPR_NEGATE:
        return -slope[0];
    case YK_EXPR_ADD:
        return slope[0] + slope[1];
    case YK_EXPR_SUBTRACT:
        return slope[0] - slope[1];
    case YK_EXPR_MULTIPLY:
        return slope[0] * value[1] + value[0] * slope[1];
    case YK_EXPR_DIVIDE:
        return (slope[0] - value[0] / value[1] * slope[1]) / value[1];
    default:
        return slope_of_series(operation, value, slope);
    }
}

double yk_formula_slope(const YkFormula *formula, const double *variables, const double *direction)
{
    static const double none[1] = {0};
    double registers[YK_FORMULA_REGISTERS], slopes[YK_FORMULA_REGISTERS];
    const double *const sources[] = {formula->constants, variables, registers};
    const double *const changes[] = {none, direction, slopes};
    bool moves = false;
    for (size_t i = 0; i < formula->variable_count; i++) moves |= direction[formula->variables[i]] != 0;
    if (!moves) return 0;
    for (size_t i = 0; i < formula->instruction_count; i++) {
        const YkInstruction *at = &formula->instructions[i];
        double value[2], slope[2];
        for (int k = 0; k < 2; k++) {
            value[k] = sources[at->from[k]][at->index[k]];
            slope[k] = at->from[k] == YK_FROM_CONSTANT ? 0 : changes[at->from[k]][at->index[k]];
        }
        bool is_still = slope[0] == 0 && slope[1] == 0;
        registers[at->result] = yk_formula_operate(at->operation, value[0], value[1]);
        slopes[at->result] = is_still ? 0 : slope_of(at->operation, value, slope);
        if (!isfinite(registers[at->result]) || !isfinite(slopes[at->result])) return NAN;
    }
    return formula->from == YK_FROM_CONSTANT ? 0 : changes[formula->from][formula->index];
}
