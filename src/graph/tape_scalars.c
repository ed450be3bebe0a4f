// Finds the operands of a pose's steps that are the same in all lanes: those that depend on parameters alone.
#include "graph/tape_steps.h"

static bool has_product(YkTapeOp op)
{
    return op == YK_TAPE_MULTIPLY || (op >= YK_TAPE_PRODUCT_PLUS && op <= YK_TAPE_LESS_LESS);
}

static bool has_two_products(YkTapeOp op)
{
    return op >= YK_TAPE_DOT && op <= YK_TAPE_LESS_LESS;
}

int32_t yk_tape_scalar_operand(YkTapeOp op, int32_t bit)
{
    if (op == YK_TAPE_ADD || op == YK_TAPE_SUBTRACT || op == YK_TAPE_DIVIDE) return bit;
    if (has_two_products(op)) return bit == 0 ? 1 : 3;
    if (has_product(op)) return bit == 0 ? 1 : op == YK_TAPE_MULTIPLY ? YK_NONE : 2;
    return op == YK_TAPE_COPY && bit == 0 ? 0 : YK_NONE;
}

bool yk_tape_reads_lanes(const YkTapeStep *s, int32_t operand)
{
    for (int32_t bit = 0; bit < 2; bit++)
        if ((s->scalars >> bit & 1) && yk_tape_scalar_operand(s->op, bit) == operand) return false;
    return true;
}

static void sort_factors(const YkTapeMaker *m, YkRef *factor)
{
    YkRef first = factor[0];
    if (!yk_tape_value(m, first)->of_parameters) return;
    factor[0] = factor[1];
    factor[1] = first;
}

void yk_tape_mark_scalars(const YkTapeMaker *m, YkTapeStep *s)
{
    if (has_product(s->op)) sort_factors(m, s->in);
    if (has_two_products(s->op)) sort_factors(m, s->in + 2);
    for (int32_t bit = 0; bit < 2; bit++) {
        int32_t operand = yk_tape_scalar_operand(s->op, bit);
        if (operand != YK_NONE && yk_tape_value(m, s->in[operand])->of_parameters) s->scalars |= 1 << bit;
    }
}
