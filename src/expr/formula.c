// Evaluates formulas.
#include <math.h>
#include <stdlib.h>
#include "elementary/elementary.h"
#include "expr/formula_inside.h"

// Computes a power by repeated squaring; for a negative exponent its reciprocal.
static double whole_power(double base, double exponent)
{
    double power = 1;
    for (int left = abs((int)exponent); left > 0; left >>= 1) {
        if (left & 1) power = power * base + 0.0;
        if (left > 1) base = base * base;
    }
    return exponent < 0 ? 1 / power : power;
}

double yk_formula_operate(int operation, double a, double b)
{
    switch (operation) {
    case YK_EXPR_NEGATE:
        return -a;
    case YK_EXPR_ADD:
        return a + b;
    case YK_EXPR_SUBTRACT:
        return a - b;
    case YK_EXPR_MULTIPLY:
        return a * b + 0.0; // a zero has no sign here, which only atan2 would show
    case YK_EXPR_DIVIDE:
        return a / b;
    case YK_EXPR_POWER:
        return yk_pow(a, b);
    case YK_OPERATION_WHOLE_POWER:
        return whole_power(a, b);
    default:
        return yk_function_value((YkFunction)(operation - YK_OPERATION_FUNCTION), a, b);
    }
}

double yk_formula_eval(const YkFormula *formula, const double *variables)
{
    double registers[YK_FORMULA_REGISTERS];
    const double *const sources[] = {formula->constants, variables, registers};
    for (size_t i = 0; i < formula->variable_count; i++) {
        if (!isfinite(variables[formula->variables[i]])) return NAN;
    }
    for (size_t i = 0; i < formula->instruction_count; i++) {
        const YkInstruction *at = &formula->instructions[i];
        double a = sources[at->from[0]][at->index[0]], b = sources[at->from[1]][at->index[1]];
        double value = yk_formula_operate(at->operation, a, b);
        if (!isfinite(value)) return NAN; // min(3, 1/0) and exp(-1/0) have no value, though C would give one
        registers[at->result] = value;
    }
    return sources[formula->from][formula->index];
}

bool yk_formula_is_constant(const YkFormula *formula)
{
    return formula->variable_count == 0;
}

int yk_formula_variable(const YkFormula *formula, double *sign)
{
    const YkInstruction *only = formula->instruction_count == 1 ? formula->instructions : NULL;
    bool is_negated = only && only->operation == YK_EXPR_NEGATE && only->from[0] == YK_FROM_VARIABLE;
    *sign = is_negated ? -1 : 1;
    if (is_negated) return only->index[0];
    return formula->instruction_count == 0 && formula->from == YK_FROM_VARIABLE ? formula->index : -1;
}
