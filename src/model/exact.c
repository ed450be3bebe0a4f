// Exact values: numerator / denominator * pi^k in 64-bit whole numbers, for expressions that allow it.
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "base/number.h"
#include "model/model.h"

enum { PARAMETERS_DEEP = 64, POWER_MAX = 64, LOOKS_MAX = 20000 };
static const YkExact inexact = {.is_exact = false};

static YkExact whole(int64_t value)
{
    return (YkExact){.is_exact = true, .numerator = value, .denominator = 1};
}

static int64_t common_divisor(int64_t a, int64_t b)
{
    while (b != 0) {
        int64_t rest = a % b;
        a = b;
        b = rest;
    }
    return a < 0 ? -a : a;
}

// Computes a * b; returns false if it does not fit.
static bool times(int64_t a, int64_t b, int64_t *product)
{
    const int64_t most = INT64_MAX;
    if (a == INT64_MIN || b == INT64_MIN) return false;
    int64_t size_a = a < 0 ? -a : a, size_b = b < 0 ? -b : b;
    if (size_a != 0 && size_b > most / size_a) return false;
    *product = a * b;
    return true;
}

static bool plus(int64_t a, int64_t b, int64_t *sum)
{
    if ((b > 0 && a > INT64_MAX - b) || (b < 0 && a < -INT64_MAX - b)) return false;
    *sum = a + b;
    return true;
}

static YkExact multiply(YkExact a, YkExact b)
{
    if (!a.is_exact || !b.is_exact) return inexact;
    int64_t ab = common_divisor(a.numerator, b.denominator), ba = common_divisor(b.numerator, a.denominator);
    YkExact c = {.is_exact = true, .pi = a.pi + b.pi};
    if (!times(a.numerator / ab, b.numerator / ba, &c.numerator)) return inexact;
    if (!times(a.denominator / ba, b.denominator / ab, &c.denominator)) return inexact;
    if (c.numerator == 0) return whole(0);
    return c;
}

static YkExact invert(YkExact a)
{
    if (!a.is_exact || a.numerator == 0) return inexact;
    int64_t sign = a.numerator < 0 ? -1 : 1;
    return (YkExact){
        .is_exact = true, .numerator = sign * a.denominator, .denominator = sign * a.numerator, .pi = -a.pi};
}

static YkExact add(YkExact a, YkExact b)
{
    if (!a.is_exact || !b.is_exact) return inexact;
    if (a.numerator == 0) return b;
    if (b.numerator == 0) return a;
    if (a.pi != b.pi) return inexact;
    int64_t divisor = common_divisor(a.denominator, b.denominator), left, right;
    YkExact c = {.is_exact = true, .pi = a.pi};
    if (!times(a.numerator, b.denominator / divisor, &left) || !times(b.numerator, a.denominator / divisor, &right) ||
        !plus(left, right, &c.numerator) || !times(a.denominator, b.denominator / divisor, &c.denominator))
        return inexact;
    if (c.numerator == 0) return whole(0);
    int64_t common = common_divisor(c.numerator, c.denominator);
    c.numerator /= common;
    c.denominator /= common;
    return c;
}

static YkExact negative(YkExact a)
{
    a.numerator = -a.numerator;
    return a;
}

static YkExact power(YkExact base, YkExact exponent)
{
    if (!exponent.is_exact || exponent.denominator != 1 || exponent.pi != 0 || llabs(exponent.numerator) > POWER_MAX)
        return inexact;
    YkExact result = whole(1);
    for (int64_t k = 0; k < llabs(exponent.numerator); k++) result = multiply(result, base);
    return exponent.numerator < 0 ? invert(result) : result;
}

static YkExact decimal(int64_t mantissa, int32_t exponent)
{
    YkExact value = whole(mantissa), ten = exponent < 0 ? invert(whole(10)) : whole(10);
    for (int32_t k = 0; k < abs(exponent) && value.is_exact; k++) value = multiply(value, ten);
    return value;
}

// Returns the shortest decimal that reads as this double: a unit's size is a short decimal (mm, in) ...
static YkExact short_decimal(double size)
{
    char text[YK_NUMBER_SIZE];
    int64_t mantissa = 0;
    int32_t exponent = 0;
    size_t length = yk_number_write_digits(size, 15, text);
    if (length == 0 || !yk_number_read_exact(text, length, &mantissa, &exponent)) return inexact;
    return decimal(mantissa, exponent);
}

// ... or a simple fraction of pi (deg, rpm).
static YkExact size_of_unit(double size)
{
    static const int64_t parts[] = {1, 2, 3, 10, 12, 18, 30, 60, 180, 1800, 3600, 10800, 648000};
    for (size_t k = 0; k < sizeof parts / sizeof *parts; k++) {
        double numerator = size / YK_PI * (double)parts[k];
        if (numerator < 0.5 || numerator > 1e6 || fabs(numerator - rint(numerator)) > 1e-14 * numerator) continue;
        int64_t top = (int64_t)rint(numerator), common = common_divisor(top, parts[k]);
        return (YkExact){.is_exact = true, .numerator = top / common, .denominator = parts[k] / common, .pi = 1};
    }
    YkExact value = short_decimal(size);
    if (value.is_exact && fabs((double)value.numerator / (double)value.denominator - size) > 1e-15 * size)
        return inexact;
    return value;
}

typedef YkExactLine Line;

static const Line no_line = {.constant = {.is_exact = false}, .rate = {.is_exact = false}};

static Line constant_line(YkExact value)
{
    return (Line){value, whole(0)};
}

static bool is_zero(YkExact a)
{
    return a.is_exact && a.numerator == 0;
}

// One evaluation. Parameters that are each twice another, in a long chain, stand for more numbers than can be visited.
typedef struct Evaluation {
    const YkModel *model;
    size_t looks_left;
} Evaluation;

static Line eval(Evaluation *evaluation, const YkExpr *expr, int depth);

static Line eval_number(const YkExpr *expr)
{
    if (!expr->is_exact) return no_line;
    YkExact value = decimal(expr->mantissa, expr->exponent);
    double size = expr->has_unit ? expr->unit_size : expr->value_scale;
    return constant_line(size == 1 ? value : multiply(value, size_of_unit(size)));
}

static Line eval_name(Evaluation *evaluation, const YkExpr *expr, int depth)
{
    const YkModel *model = evaluation->model;
    if (strcmp(expr->name, "pi") == 0) {
        YkExact pi = whole(1);
        pi.pi = 1;
        return constant_line(pi);
    }
    if (strcmp(expr->name, "t") == 0) return (Line){whole(0), whole(1)};
    int32_t index = yk_names_find(&model->parameter_names, expr->name);
    if (index == YK_NONE || depth > PARAMETERS_DEEP || !model->parameters[index].expr) return no_line;
    return eval(evaluation, model->parameters[index].expr, depth + 1);
}

static Line product(Line a, Line b)
{
    if (!is_zero(a.rate) && !is_zero(b.rate)) return no_line; // not linear in t
    return (Line){multiply(a.constant, b.constant), add(multiply(a.rate, b.constant), multiply(b.rate, a.constant))};
}

static Line eval(Evaluation *evaluation, const YkExpr *expr, int depth)
{
    if (evaluation->looks_left == 0) return no_line;
    evaluation->looks_left--;
    if (expr->kind == YK_EXPR_NUMBER) return eval_number(expr);
    if (expr->kind == YK_EXPR_NAME) return eval_name(evaluation, expr, depth);
    if (expr->kind == YK_EXPR_CALL) return no_line;
    Line a = eval(evaluation, expr->a, depth), b = expr->b ? eval(evaluation, expr->b, depth) : no_line;
    switch (expr->kind) {
    case YK_EXPR_NEGATE:
        return (Line){negative(a.constant), negative(a.rate)};
    case YK_EXPR_ADD:
        return (Line){add(a.constant, b.constant), add(a.rate, b.rate)};
    case YK_EXPR_SUBTRACT:
        return (Line){add(a.constant, negative(b.constant)), add(a.rate, negative(b.rate))};
    case YK_EXPR_MULTIPLY:
        return product(a, b);
    case YK_EXPR_DIVIDE:
        return is_zero(b.rate) ? product(a, constant_line(invert(b.constant))) : no_line;
    case YK_EXPR_POWER:
        return is_zero(a.rate) && is_zero(b.rate) ? constant_line(power(a.constant, b.constant)) : no_line;
    default:
        return no_line;
    }
}

YkExactLine yk_model_exact_line(const YkModel *model, const YkExpr *expr)
{
    Evaluation evaluation = {model, LOOKS_MAX};
    return eval(&evaluation, expr, 0);
}

YkExact yk_model_exact(const YkModel *model, const YkExpr *expr)
{
    Line line = yk_model_exact_line(model, expr);
    return is_zero(line.rate) ? line.constant : inexact;
}

YkExact yk_model_exact_rate(const YkModel *model, const YkExpr *expr)
{
    return yk_model_exact_line(model, expr).rate;
}
