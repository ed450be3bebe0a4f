// Turns expressions of the file into elements of the ring: exactly, with parameters as symbols.
#include <math.h>
#include <string.h>
#include "base/number.h"
#include "derive/inside.h"
#include "elementary/elementary.h"

enum { DIGITS_EXACT = 1000000000, DENOMINATOR_MAX = 1000000 };

// Finds the fraction over / under with under <= DENOMINATOR_MAX that equals value to a few bits (continued fraction).
static bool as_fraction(double value, int64_t *over, int64_t *under)
{
    int64_t p0 = 0, p1 = 1, q0 = 1, q1 = 0;
    double rest = fabs(value);
    if (!(rest < 1e12)) return false;
    for (int step = 0; step < 40; step++) {
        double whole = floor(rest);
        if (whole > 1e15 || (double)q1 * whole + (double)q0 > DENOMINATOR_MAX) return false;
        int64_t a = (int64_t)whole, p = a * p1 + p0, q = a * q1 + q0;
        p0 = p1, p1 = p, q0 = q1, q1 = q;
        if (fabs((double)p1 / (double)q1 - fabs(value)) <= 4e-16 * fabs(value)) {
            *over = value < 0 ? -p1 : p1;
            *under = q1;
            return true;
        }
        rest = 1 / (rest - whole);
    }
    return false;
}

// Returns a double as the decimal that its writer meant, if that is short.
static const YkPoisson *as_decimal(YkRing *ring, double value, int64_t limit)
{
    char text[YK_NUMBER_SIZE];
    int64_t mantissa;
    int32_t exponent;
    size_t length = yk_number_write(fabs(value), text);
    if (!yk_number_read_exact(text, length, &mantissa, &exponent) || mantissa > limit) return NULL;
    return yk_ring_decimal(ring, value < 0 ? -mantissa : mantissa, exponent);
}

const YkPoisson *yk_derive_unit_size(YkDerivation *d, double size, int angle)
{
    YkRing *ring = d->ring;
    int64_t over, under;
    const YkPoisson *decimal = as_decimal(ring, size, DIGITS_EXACT);
    if (decimal) return decimal;
    if (angle != 0 && as_fraction(size / yk_pow(YK_PI, angle), &over, &under)) {
        const YkPoisson *pi = yk_ring_power(ring, yk_ring_pi(ring), angle);
        return yk_ring_scale(ring, pi, over, under);
    }
    if (as_fraction(size, &over, &under)) return yk_ring_rational(ring, over, under);
    return as_decimal(ring, size, INT64_MAX);
}

static const YkPoisson *number(YkDerivation *d, const YkExpr *expr)
{
    const YkPoisson *value = expr->is_exact ? yk_ring_decimal(d->ring, expr->mantissa, expr->exponent)
                                            : as_decimal(d->ring, expr->number, INT64_MAX);
    double size = expr->has_unit ? expr->unit_size : expr->value_scale;
    if (size == 1) return value;
    int angle = expr->has_unit ? expr->unit.angle : expr->dimension.angle;
    return yk_ring_multiply(d->ring, value, yk_derive_unit_size(d, size, angle ? angle : 1));
}

static const YkPoisson *name(YkDerivation *d, const YkExpr *expr)
{
    if (strcmp(expr->name, "pi") == 0) return yk_ring_pi(d->ring);
    int own = yk_model_own_name(expr->name);
    if (own != YK_NONE) return yk_ring_of(d->ring, d->spring[own]);
    int32_t symbol = yk_derive_find(d, expr->name);
    if (symbol < 0) {
        yk_derive_enter_names(d);
        symbol = yk_derive_find(d, expr->name);
    }
    return symbol < 0 ? NULL : yk_ring_of(d->ring, symbol);
}

static const YkPoisson *constant_or_none(YkDerivation *d, const YkExpr *expr)
{
    int32_t symbol;
    return yk_derive_constant(d, expr, false, &symbol);
}

static const YkPoisson *power(YkDerivation *d, const YkExpr *expr)
{
    int64_t over, under;
    const YkPoisson *base = yk_derive_expression(d, expr->a), *exponent = yk_derive_expression(d, expr->b);
    if (!yk_ring_is_rational(exponent, &over, &under) || under != 1 || over > 64 || over < -64 ||
        (over < 0 && yk_ring_terms(base) != 1))
        return constant_or_none(d, expr);
    return yk_ring_power(d->ring, base, (int32_t)over);
}

static const YkPoisson *quotient(YkDerivation *d, const YkExpr *expr)
{
    const YkPoisson *over = yk_derive_expression(d, expr->a), *under = yk_derive_expression(d, expr->b);
    if (!over || !under) return NULL;
    return yk_ring_terms(under) == 1 ? yk_ring_divide(d->ring, over, under) : constant_or_none(d, expr);
}

// Returns the root of a rational square if it is a number of the ring.
static const YkPoisson *root(YkDerivation *d, const YkExpr *expr)
{
    int64_t over, under;
    const YkPoisson *square = yk_derive_expression(d, expr->a);
    if (!square) return NULL;
    if (!yk_ring_is_rational(square, &over, &under) || over < 0 || over > INT32_MAX || under > INT32_MAX ||
        yk_ring_status(d->ring) != YK_RING_OK)
        return constant_or_none(d, expr);
    const YkPoisson *whole = yk_ring_sqrt(d->ring, over * under);
    if (whole) return yk_ring_scale(d->ring, whole, 1, under);
    yk_ring_clear(d->ring);
    return constant_or_none(d, expr);
}

static const YkPoisson *call(YkDerivation *d, const YkExpr *expr)
{
    if (expr->function == YK_SQRT) return root(d, expr);
    if (expr->function != YK_SIN && expr->function != YK_COS) return constant_or_none(d, expr);
    const YkPoisson *unit = yk_derive_turn(d, expr->a);
    return expr->function == YK_COS ? yk_ring_real(d->ring, unit) : yk_ring_imaginary(d->ring, unit);
}

const YkPoisson *yk_derive_expression(YkDerivation *d, const YkExpr *expr)
{
    if (!expr) return yk_ring_rational(d->ring, 0, 1);
    switch (expr->kind) {
    case YK_EXPR_NUMBER:
        return number(d, expr);
    case YK_EXPR_NAME:
        return name(d, expr);
    case YK_EXPR_NEGATE:
        return yk_ring_negate(d->ring, yk_derive_expression(d, expr->a));
    case YK_EXPR_ADD:
    case YK_EXPR_SUBTRACT:
    case YK_EXPR_MULTIPLY: {
        const YkPoisson *left = yk_derive_expression(d, expr->a), *right = yk_derive_expression(d, expr->b);
        return expr->kind == YK_EXPR_ADD        ? yk_ring_add(d->ring, left, right)
               : expr->kind == YK_EXPR_SUBTRACT ? yk_ring_subtract(d->ring, left, right)
                                                : yk_ring_multiply(d->ring, left, right);
    }
    case YK_EXPR_DIVIDE:
        return quotient(d, expr);
    case YK_EXPR_POWER:
        return power(d, expr);
    case YK_EXPR_CALL:
        return call(d, expr);
    }
    return NULL;
}

void yk_derive_forgive(YkDerivation *d)
{
    YkRingStatus status = yk_ring_status(d->ring);
    if (status == YK_RING_DIVISOR || status == YK_RING_OVERFLOW || status == YK_RING_SIZE) yk_ring_clear(d->ring);
}

const YkPoisson *yk_derive_given(YkDerivation *d, const YkExpr *expr)
{
    const YkPoisson *a = expr ? yk_derive_expression(d, expr) : NULL;
    if (!a) yk_derive_forgive(d);
    return a;
}

// Takes factor * symbol out of *rest, whole factors only; multiplies *unit by e^(i factor symbol).
static bool take_angle(YkRing *ring, const YkPoisson **rest, int32_t symbol, const YkPoisson **unit)
{
    int64_t over, under;
    if (!yk_ring_mentions(ring, *rest, symbol)) return true;
    const YkPoisson *factor = yk_ring_coefficient(ring, *rest, symbol, 1);
    if (!yk_ring_is_rational(factor, &over, &under) || under != 1 || over > 1000 || over < -1000) return false;
    *rest = yk_ring_subtract(ring, *rest, yk_ring_multiply(ring, factor, yk_ring_of(ring, symbol)));
    *unit = yk_ring_multiply(ring, *unit, yk_ring_power(ring, yk_ring_unit(ring, symbol), (int32_t)over));
    return !yk_ring_mentions(ring, *rest, symbol);
}

// Returns e^(i angle) if the angle is a whole combination of angles and a rational multiple of pi; otherwise NULL.
static const YkPoisson *unit_of(YkDerivation *d, const YkPoisson *angle)
{
    YkRing *ring = d->ring;
    const YkPoisson *rest = angle, *unit = yk_ring_rational(ring, 1, 1);
    for (size_t k = 0; k < d->model->parameter_count; k++)
        if (yk_ring_is_angle(ring, d->parameters[k]) && !take_angle(ring, &rest, d->parameters[k], &unit)) return NULL;
    for (size_t k = 0; k < d->coordinate_count; k++)
        if (!d->coordinates[k].is_distance && !take_angle(ring, &rest, d->coordinates[k].position, &unit)) return NULL;
    int64_t over, under;
    const YkPoisson *turns = yk_ring_divide(ring, rest, yk_ring_pi(ring));
    if (!yk_ring_is_rational(turns, &over, &under)) return NULL;
    return yk_ring_multiply(ring, unit, yk_ring_turn(ring, over, under));
}

// Returns whether it is a function whose values the ring does not have: atan(h/l).
static bool is_foreign(const YkExpr *expr)
{
    return expr->kind == YK_EXPR_CALL && expr->function != YK_SIN && expr->function != YK_COS &&
           expr->function != YK_SQRT;
}

const YkPoisson *yk_derive_turn(YkDerivation *d, const YkExpr *expr)
{
    int32_t symbol;
    if (!expr) return yk_ring_rational(d->ring, 1, 1);
    if (is_foreign(expr) && yk_derive_constant(d, expr, true, &symbol)) return yk_ring_unit(d->ring, symbol);
    const YkPoisson *angle = yk_derive_expression(d, expr), *unit = angle ? unit_of(d, angle) : NULL;
    if (unit || yk_ring_status(d->ring) != YK_RING_OK) return unit;
    if (!yk_derive_constant(d, expr, true, &symbol)) return NULL;
    return yk_ring_unit(d->ring, symbol);
}

// A definition by a single number is the parameter's own value.
const YkPoisson *yk_derive_definition(YkDerivation *d, size_t parameter)
{
    const YkExpr *expr = d->model->parameters[parameter].expr;
    return yk_expr_has_names(expr) && !(expr->kind == YK_EXPR_NAME && strcmp(expr->name, "pi") == 0)
               ? yk_derive_expression(d, expr)
               : NULL;
}
