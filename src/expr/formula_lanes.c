// Evaluates formulas over lanes: one instruction over all lanes, then the next. The same bits as one by one; an
// operation without a value gives a number that is not finite, and stays so through all that follows.
#include <math.h>
#include "expr/formula_inside.h"

static void operate(int operation, const double *a, const double *b, double *out, size_t n)
{
    switch (operation) {
    case YK_EXPR_NEGATE:
        for (size_t i = 0; i < n; i++) out[i] = -a[i];
        break;
    case YK_EXPR_ADD:
        for (size_t i = 0; i < n; i++) out[i] = a[i] + b[i];
        break;
    case YK_EXPR_SUBTRACT:
        for (size_t i = 0; i < n; i++) out[i] = a[i] - b[i];
        break;
    case YK_EXPR_MULTIPLY:
        for (size_t i = 0; i < n; i++) out[i] = a[i] * b[i] + 0.0;
        break;
    case YK_EXPR_DIVIDE:
        for (size_t i = 0; i < n; i++) out[i] = b[i] - b[i] == 0 ? a[i] / b[i] : NAN;
        break;
    default: // max(3, 1/0) has no value, though a comparison would give one
        for (size_t i = 0; i < n; i++)
            out[i] = a[i] - a[i] + (b[i] - b[i]) == 0 ? yk_formula_operate(operation, a[i], b[i]) : NAN;
    }
}

const double *yk_formula_lanes(const YkFormula *formula, const double *const *variables, double *scratch, size_t n)
{
    double *registers = scratch, *constant[2] = {scratch + YK_FORMULA_REGISTERS * YK_FORMULA_LANES,
                                                 scratch + (YK_FORMULA_REGISTERS + 1) * YK_FORMULA_LANES};
    const double *value = NULL;
    for (size_t k = 0; k <= formula->instruction_count; k++) {
        bool is_last = k == formula->instruction_count;
        YkInstruction end = {.from = {(uint8_t)formula->from}, .index = {formula->index}};
        const YkInstruction *at = is_last ? &end : &formula->instructions[k];
        const double *operand[2] = {NULL, NULL};
        for (int e = 0; e < 2 - is_last; e++) {
            if (at->from[e] == YK_FROM_CONSTANT) {
                for (size_t i = 0; i < n; i++) constant[e][i] = formula->constants[at->index[e]];
                operand[e] = constant[e];
            } else {
                operand[e] = at->from[e] == YK_FROM_VARIABLE ? variables[at->index[e]]
                                                             : registers + at->index[e] * YK_FORMULA_LANES;
            }
        }
        value = operand[0];
        if (is_last) break;
        operate(at->operation, operand[0], operand[1], registers + at->result * YK_FORMULA_LANES, n);
    }
    return value;
}
