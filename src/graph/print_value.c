// Writes values as expressions of C.
#include "graph/print.h"
#include <string.h>
#include "base/number.h"
#include "graph/function.h"

void yk_printer_number(YkPrinter *pr, double number)
{
    char text[YK_NUMBER_SIZE];
    if (pr->single)
        yk_number_write_digits(number, 9, text);
    else
        yk_number_write(number, text);
    yk_text_puts(pr->out, text);
    if (!strpbrk(text, ".en")) yk_text_puts(pr->out, ".0");
    if (pr->single) yk_text_puts(pr->out, "f");
}

static int32_t cut_of(const YkPrinter *pr, YkRef value)
{
    for (size_t k = 0; k < pr->cut_count; k++)
        if (pr->cut[k] == value) return (int32_t)k;
    return -1;
}

// Returns whether it needs no statement: a number, a leaf, a value of the machine, an element of `known`.
bool yk_printer_is_given(const YkPrinter *pr, YkRef value)
{
    const YkValue *v = yk_printer_at(pr, value);
    if (v->op == YK_VALUE_NUMBER || v->op == YK_VALUE_LEAF) return true;
    if (pr->cut && cut_of(pr, value) >= 0) return true;
    return v->of_parameters && !pr->in_machine;
}

// --- expressions

typedef enum Rank { RANK_SUM = 1, RANK_PRODUCT, RANK_SIGN, RANK_PRIMARY } Rank;

static void expression(YkPrinter *pr, YkRef value, Rank least);

static Rank rank_of(const YkPrinter *pr, YkRef value)
{
    const YkValue *v = yk_printer_at(pr, value);
    if (v->op == YK_VALUE_NUMBER) return v->number < 0 ? RANK_SIGN : RANK_PRIMARY;
    if (v->op == YK_VALUE_MINUS) return RANK_SIGN;
    if (yk_printer_is_given(pr, value) || pr->local[value]) return RANK_PRIMARY;
    switch (v->op) {
    case YK_VALUE_ADD:
    case YK_VALUE_SUBTRACT:
        return RANK_SUM;
    case YK_VALUE_MULTIPLY:
    case YK_VALUE_DIVIDE:
    case YK_VALUE_WITNESS:
        return RANK_PRODUCT;
    default:
        return RANK_PRIMARY;
    }
}

static void call_helper(YkPrinter *pr, YkHelper helper, const char *name, YkRef a, YkRef b)
{
    pr->uses[helper] = true;
    yk_text_format(pr->out, "%s_%s(", pr->prefix, name);
    expression(pr, a, RANK_SUM);
    if (b >= 0) {
        yk_text_puts(pr->out, ", ");
        expression(pr, b, RANK_SUM);
    }
    yk_text_puts(pr->out, ")");
}

static void call_math(YkPrinter *pr, const char *name, YkRef a, YkRef b)
{
    yk_text_format(pr->out, "%s%s(", name, pr->single ? "f" : "");
    expression(pr, a, RANK_SUM);
    if (b >= 0) {
        yk_text_puts(pr->out, ", ");
        expression(pr, b, RANK_SUM);
    }
    yk_text_puts(pr->out, ")");
}

static void function(YkPrinter *pr, const YkValue *v)
{
    static const char *const own[] = {[YK_ABS] = "fabs", [YK_MIN] = "fmin", [YK_MAX] = "fmax"};
    if (v->function == YK_SIGN) {
        call_helper(pr, YK_HELPER_SIGN, "sign", v->a, -1);
        return;
    }
    bool is_own = v->function == YK_ABS || v->function == YK_MIN || v->function == YK_MAX;
    call_math(pr, is_own ? own[v->function] : yk_function_name(v->function), v->a, v->b);
}

static void operation(YkPrinter *pr, const YkValue *v)
{
    static const char *const signs[] = {
        [YK_VALUE_ADD] = " + ", [YK_VALUE_SUBTRACT] = " - ", [YK_VALUE_MULTIPLY] = " * ", [YK_VALUE_DIVIDE] = " / "};
    bool is_sum = v->op == YK_VALUE_ADD || v->op == YK_VALUE_SUBTRACT;
    expression(pr, v->a, is_sum ? RANK_SUM : RANK_PRODUCT);
    yk_text_puts(pr->out, signs[v->op]);
    expression(pr, v->b, is_sum ? RANK_PRODUCT : RANK_SIGN); // on the right, as it was built
}

static void given(YkPrinter *pr, YkRef value)
{
    const YkValue *v = yk_printer_at(pr, value);
    int32_t known = pr->cut ? cut_of(pr, value) : -1;
    if (known >= 0)
        yk_text_format(pr->out, "known[%d]", (int)known);
    else if (v->op == YK_VALUE_LEAF && v->of_parameters)
        yk_text_format(pr->out, "%s%s", pr->in_machine ? pr->file->own_parameter : pr->file->parameter, v->name);
    else if (v->op == YK_VALUE_LEAF)
        yk_text_puts(pr->out, v->name);
    else
        yk_text_format(pr->out, "m->%s", pr->field[value] ? pr->field[value] : "lost");
}

static void choose(YkPrinter *pr, const YkValue *v)
{
    yk_text_puts(pr->out, "(");
    expression(pr, v->a, RANK_SUM);
    yk_text_puts(pr->out, " < 0 ? ");
    expression(pr, v->b, RANK_SUM);
    yk_text_puts(pr->out, " : ");
    expression(pr, v->c, RANK_SUM);
    yk_text_puts(pr->out, ")");
}

void yk_printer_written(YkPrinter *pr, YkRef value)
{
    const YkValue *v = yk_printer_at(pr, value);
    switch (v->op) {
    case YK_VALUE_ADD:
    case YK_VALUE_SUBTRACT:
    case YK_VALUE_MULTIPLY:
    case YK_VALUE_DIVIDE:
        operation(pr, v);
        break;
    case YK_VALUE_FUNCTION:
        function(pr, v);
        break;
    case YK_VALUE_POWER:
        call_math(pr, "pow", v->a, v->b);
        break;
    case YK_VALUE_SINE: // of the machine; a pose has them in pairs
        call_math(pr, "sin", v->a, -1);
        break;
    case YK_VALUE_COSINE:
        call_math(pr, "cos", v->a, -1);
        break;
    case YK_VALUE_ANGLE:
        call_helper(pr, YK_HELPER_ANGLE, "angle", v->a, v->b);
        break;
    case YK_VALUE_NEAREST:
        call_helper(pr, YK_HELPER_NEAREST, "nearest", v->a, v->b);
        break;
    case YK_VALUE_ROOT:
        call_helper(pr, YK_HELPER_ROOT, "root", v->a, -1);
        break;
    case YK_VALUE_PER_ROOT:
        call_helper(pr, YK_HELPER_PER_ROOT, "per_root", v->a, -1);
        break;
    case YK_VALUE_NONZERO:
        call_helper(pr, YK_HELPER_NONZERO, "nonzero", v->a, -1);
        break;
    case YK_VALUE_LEAST:
        call_helper(pr, YK_HELPER_LEAST, "least", v->a, v->b);
        break;
    case YK_VALUE_LARGEST:
        call_helper(pr, YK_HELPER_LARGEST, "largest", v->a, v->b);
        break;
    case YK_VALUE_SIZE:
        call_math(pr, "fabs", v->a, -1);
        break;
    case YK_VALUE_WITNESS:
        yk_text_puts(pr->out, "0 * ");
        expression(pr, v->a, RANK_SIGN);
        break;
    case YK_VALUE_CHOOSE:
        choose(pr, v);
        break;
    default:
        break;
    }
}

static void expression(YkPrinter *pr, YkRef value, Rank least)
{
    enum { WORK = 200 };
    if (!yk_pace_spend(pr->graph->pace, WORK)) pr->failed = true;
    if (pr->failed) return;
    const YkValue *v = yk_printer_at(pr, value);
    bool in_brackets = rank_of(pr, value) < least;
    if (in_brackets) yk_text_puts(pr->out, "(");
    if (v->op == YK_VALUE_NUMBER) {
        yk_printer_number(pr, v->number);
    } else if (v->op == YK_VALUE_MINUS && !(pr->cut && cut_of(pr, value) >= 0)) {
        yk_text_puts(pr->out, "-");
        expression(pr, v->a, RANK_PRIMARY);
    } else if (pr->local[value]) {
        yk_text_puts(pr->out, pr->local[value]);
    } else if (yk_printer_is_given(pr, value)) {
        given(pr, value);
    } else {
        yk_printer_written(pr, value);
    }
    if (in_brackets) yk_text_puts(pr->out, ")");
}

void yk_printer_value(YkPrinter *pr, YkRef value)
{
    expression(pr, value, RANK_SUM);
}
