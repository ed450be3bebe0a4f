// Turns the tree of an expression into the instructions of a formula.
//
// Two walks: the first counts the nodes and registers that every part needs; the second emits the larger operand first,
// and folds constants. Both recurse as deep as the tree is high.
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "base/vec.h"
#include "expr/formula_inside.h"

enum { WHOLE_MAX = 64 }; // the largest exponent for which multiplying is as exact as pow, and faster

// A part of the expression. Parts are in the order of a walk that visits a node before its operands, a before b.
typedef struct Part {
    uint32_t size; // nodes
    int registers;
} Part;

typedef struct Operand {
    YkOperandSource from;
    int32_t index;
    double value; // the value of a constant, which gets its index when an instruction needs it
} Operand;

typedef struct Compiler {
    YkFormula *formula;
    YkResolve resolve;
    void *context;
    Part *parts;
    size_t part_count;
    bool is_unknown, has_no_value;
} Compiler;

static size_t count_parts(const YkExpr *expr)
{
    if (!expr) return 0;
    return 1 + count_parts(expr->a) + count_parts(expr->b);
}

static int larger(int a, int b)
{
    return a > b ? a : b;
}

// Measures the part and everything in it; leaves need no register.
static Part measure(Compiler *compiler, const YkExpr *expr)
{
    Part *part = &compiler->parts[compiler->part_count++];
    *part = (Part){.size = 1};
    if (!expr->a) return *part;
    Part a = measure(compiler, expr->a), b = {0};
    if (expr->b) b = measure(compiler, expr->b);
    part->size += a.size + b.size;
    part->registers = larger(larger(a.registers, b.registers), 1);
    if (expr->b && a.registers == b.registers && a.registers > 0) part->registers++;
    return *part;
}

static Operand constant(Compiler *compiler, double value)
{
    compiler->has_no_value |= !isfinite(value);
    return (Operand){.from = YK_FROM_CONSTANT, .value = value};
}

static Operand name(Compiler *compiler, const YkExpr *expr)
{
    double value = 0;
    int variable = compiler->resolve(compiler->context, expr, &value);
    if (variable == -1) return constant(compiler, value);
    if (variable < 0) {
        if (strcmp(expr->name, "pi") == 0) return constant(compiler, YK_PI);
        compiler->is_unknown = true;
        return constant(compiler, 0);
    }
    YkFormula *formula = compiler->formula;
    formula->variables[formula->variable_count++] = variable;
    return (Operand){.from = YK_FROM_VARIABLE, .index = variable};
}

static int32_t place_of(YkFormula *formula, const Operand *operand)
{
    if (operand->from != YK_FROM_CONSTANT) return operand->index;
    formula->constants[formula->constant_count] = operand->value;
    return (int32_t)formula->constant_count++;
}

static bool is_small_whole(const Operand *operand)
{
    return operand->from == YK_FROM_CONSTANT && fabs(operand->value) <= WHOLE_MAX &&
           operand->value == floor(operand->value);
}

static Operand operate(Compiler *compiler, const YkExpr *expr, const Operand *a, const Operand *b, int result)
{
    int operation = (int)expr->kind;
    if (expr->kind == YK_EXPR_CALL) operation = YK_OPERATION_FUNCTION + (int)expr->function;
    if (a->from == YK_FROM_CONSTANT && b->from == YK_FROM_CONSTANT) {
        return constant(compiler, yk_formula_operate(operation, a->value, b->value));
    }
    if (expr->kind == YK_EXPR_POWER && is_small_whole(b)) operation = YK_OPERATION_WHOLE_POWER;
    YkFormula *formula = compiler->formula;
    YkInstruction *instruction = &formula->instructions[formula->instruction_count++];
    *instruction = (YkInstruction){.operation = (uint8_t)operation, .result = (uint8_t)result};
    instruction->from[0] = (uint8_t)a->from;
    instruction->index[0] = place_of(formula, a);
    if (expr->b) {
        instruction->from[1] = (uint8_t)b->from;
        instruction->index[1] = place_of(formula, b);
    }
    return (Operand){.from = YK_FROM_REGISTER, .index = result};
}

// Emits the part; the registers from `free_register` on are free, and the first of them gets its value.
static Operand emit(Compiler *compiler, const YkExpr *expr, const Part *part, int free_register)
{
    if (expr->kind == YK_EXPR_NUMBER) {
        return constant(compiler, expr->number * (expr->has_unit ? expr->unit_size : expr->value_scale));
    }
    if (expr->kind == YK_EXPR_NAME) return name(compiler, expr);
    const Part *left = part + 1, *right = left + left->size;
    if (!expr->b) {
        Operand a = emit(compiler, expr->a, left, free_register), none = {.from = YK_FROM_CONSTANT};
        return operate(compiler, expr, &a, &none, free_register);
    }
    bool right_first = right->registers > left->registers;
    const YkExpr *first = right_first ? expr->b : expr->a, *second = right_first ? expr->a : expr->b;
    Operand p = emit(compiler, first, right_first ? right : left, free_register);
    Operand q = emit(compiler, second, right_first ? left : right, free_register + (p.from == YK_FROM_REGISTER));
    return operate(compiler, expr, right_first ? &q : &p, right_first ? &p : &q, free_register);
}

static int compare(const void *a, const void *b)
{
    int32_t x = *(const int32_t *)a, y = *(const int32_t *)b;
    return (x > y) - (x < y);
}

static void sort_variables(YkFormula *formula)
{
    size_t kept = 0;
    int32_t *variables = formula->variables;
    if (formula->variable_count > 1) qsort(variables, formula->variable_count, sizeof *variables, compare);
    for (size_t i = 0; i < formula->variable_count; i++) {
        if (kept == 0 || variables[kept - 1] != variables[i]) variables[kept++] = variables[i];
    }
    formula->variable_count = kept;
}

static void finish(Compiler *compiler, const Operand *result)
{
    YkFormula *formula = compiler->formula;
    formula->from = result->from;
    formula->index = place_of(formula, result);
    sort_variables(formula);
    if (!compiler->has_no_value) return;
    *formula = (YkFormula){.constants = formula->constants}; // a part without a value leaves the whole without one
    formula->constants[0] = NAN;
}

// Allocates enough for anything that `count` parts may become: there are fewer parts with two operands than leaves.
static YkFormula *new_formula(YkArena *arena, size_t count)
{
    YkFormula *formula = count < INT32_MAX ? YK_NEW(arena, YkFormula, 1) : NULL;
    if (!formula) return NULL;
    formula->instructions = YK_NEW(arena, YkInstruction, count);
    formula->constants = YK_NEW(arena, double, count + 1);
    formula->variables = YK_NEW(arena, int32_t, count);
    return formula->instructions && formula->constants && formula->variables ? formula : NULL;
}

YkFormula *yk_formula_compile(const YkExpr *expr, YkResolve resolve, void *context, YkArena *arena)
{
    size_t count = count_parts(expr);
    Compiler compiler = {.resolve = resolve, .context = context};
    compiler.formula = new_formula(arena, count);
    compiler.parts = compiler.formula ? malloc(count * sizeof *compiler.parts) : NULL;
    if (!compiler.parts) {
        yk_arena_fail(arena);
        return NULL;
    }
    measure(&compiler, expr);
    Operand result = emit(&compiler, expr, compiler.parts, 0);
    finish(&compiler, &result);
    free(compiler.parts);
    return compiler.is_unknown ? NULL : compiler.formula;
}
