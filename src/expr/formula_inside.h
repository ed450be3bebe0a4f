// The inside of YkFormula; no other room includes it.
//
// A formula is a list of instructions. Each applies one operation to one or two operands and puts the result into a
// register. An operand is a constant of the formula, a variable of the caller or a register. The larger operand of an
// operation is computed first (Sethi & Ullman 1970), so that a tree of n leaves needs at most 1 + log2(n) registers.
#ifndef EXPR_FORMULA_INSIDE_H
#define EXPR_FORMULA_INSIDE_H
#include "expr/formula.h"

enum { YK_FORMULA_REGISTERS = 32 }; // enough for 2^31 leaves

// Operations: the kinds of expression from YK_EXPR_NEGATE to YK_EXPR_POWER, then these.
enum {
    YK_OPERATION_WHOLE_POWER = YK_EXPR_CALL + 1, // a small whole exponent, by multiplication
    YK_OPERATION_FUNCTION                        // + YkFunction
};

typedef enum YkOperandSource { YK_FROM_CONSTANT, YK_FROM_VARIABLE, YK_FROM_REGISTER } YkOperandSource;

typedef struct YkInstruction {
    uint8_t operation, result; // a register
    uint8_t from[2];           // YkOperandSource of the operands; the second of a single operand is constant 0
    int32_t index[2];
} YkInstruction;

struct YkFormula {
    YkInstruction *instructions;
    double *constants;  // at least one
    int32_t *variables; // the variables on which it depends, ascending
    size_t instruction_count, constant_count, variable_count;
    YkOperandSource from; // where the value ends up
    int32_t index;
};

// Returns the value of an operation on finite operands; not finite if there is none.
double yk_formula_operate(int operation, double a, double b);

#endif
