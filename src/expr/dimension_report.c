// Reports dimensions that do not fit, in words.
#include <string.h>
#include "base/text.h"
#include "expr/dimension.h"
#include "graph/function.h"

enum { QUOTE_MAX = 40 }; // the longest quotation of an expression in a hint

// Returns whether to stay silent: before the last phase nothing is final.
static bool is_silent(YkDimensions *dims)
{
    if (dims->phase == YK_PHASE_FINAL) dims->has_errors = true;
    return dims->phase != YK_PHASE_FINAL;
}

// Returns "mass of `link1`", or "parameter `a`".
static const char *describe(const YkDimensions *dims, const YkConstraint *constraint)
{
    if (constraint->parameter < 0) return constraint->what ? constraint->what : "a value";
    const char *name = dims->names[constraint->parameter].name;
    size_t length = strlen(name);
    static const char before[] = "parameter `";
    char *text = yk_arena_alloc(dims->arena, sizeof before + length + 1, 1);
    if (!text) return "a parameter";
    memcpy(text, before, sizeof before - 1);
    memcpy(text + sizeof before - 1, name, length);
    text[sizeof before - 1 + length] = '`';
    return text;
}

// Returns the parameter without a unit that the expression is, up to sign and a factor; or NULL.
static const YkExpr *parameter_in(const YkDimensions *dims, const YkExpr *expr)
{
    while (expr->kind != YK_EXPR_NAME) {
        bool is_product = expr->kind == YK_EXPR_MULTIPLY || expr->kind == YK_EXPR_DIVIDE;
        if (expr->kind == YK_EXPR_NEGATE || (is_product && yk_dim_is_bare(expr->b)))
            expr = expr->a;
        else if (expr->kind == YK_EXPR_MULTIPLY && yk_dim_is_bare(expr->a))
            expr = expr->b;
        else
            return NULL;
    }
    return expr->parameter >= 0 && dims->names[expr->parameter].origin ? expr : NULL;
}

static void report_two_ways(YkDimensions *dims, const YkExpr *expr, YkDimension wanted, YkCode code)
{
    const YkDimName *name = &dims->names[expr->parameter];
    const char *here = describe(dims, dims->current), *there = describe(dims, name->origin);
    yk_problem(dims->problems, code, expr->place, "%q is used as %s here (%s) but as %s elsewhere (%s)", expr->name,
               yk_dimension_name(wanted), here, yk_dimension_name(name->dimension), there);
    if (name->origin_place.line > 0)
        yk_problem_hint(dims->problems, "the other use is on line %u, column %u; give %q a unit, or use two parameters",
                        (unsigned)name->origin_place.line, (unsigned)name->origin_place.column, expr->name);
    else
        yk_problem_hint(dims->problems, "give %q a unit, or use two parameters", expr->name);
}

void yk_dim_report_two_ways(YkDimensions *dims, const YkExpr *expr, YkDimension wanted)
{
    if (!is_silent(dims)) report_two_ways(dims, expr, wanted, YK_CODE_TWO_DIMENSIONS);
}

// Returns a factor of which a use has made an angle; NULL if there is none. Terms that agree in their angles are meant
// so.
static const YkExpr *angle_in(const YkDimensions *dims, const YkExpr *expr)
{
    if (!expr || expr->kind == YK_EXPR_CALL || expr->kind == YK_EXPR_NUMBER) return NULL;
    if (expr->kind == YK_EXPR_NAME) {
        const YkDimName *name = expr->parameter >= 0 ? &dims->names[expr->parameter] : NULL;
        return name && name->origin && name->dimension.angle != 0 ? expr : NULL;
    }
    bool is_sum = expr->kind == YK_EXPR_ADD || expr->kind == YK_EXPR_SUBTRACT;
    if (is_sum && expr->a->dimension.angle == expr->b->dimension.angle) return NULL;
    const YkExpr *found = angle_in(dims, expr->a);
    return found ? found : angle_in(dims, expr->b);
}

void yk_dim_warn_of_factor(YkDimensions *dims, const YkExpr *expr)
{
    const YkExpr *name = dims->problems && dims->units.angle != 1 ? angle_in(dims, expr) : NULL;
    if (name) report_two_ways(dims, name, YK_DIM_NONE, YK_CODE_ANGLE_FACTOR);
}

// Returns whether the dimension is wrong because a parameter in it has got its dimension elsewhere.
static bool is_two_ways(YkDimensions *dims, const YkExpr *expr, YkDimension wanted)
{
    const YkExpr *name = parameter_in(dims, expr);
    if (name) yk_dim_report_two_ways(dims, name, wanted);
    return name != NULL;
}

// Hints how the whole expression may have been meant if the part has numbers as factors and should be `wanted`. Returns
// false if it has none.
static bool hint_at_product(YkDimensions *dims, const YkExpr *part, YkDimension wanted)
{
    YkText repaired = {0};
    YkDimension missing = yk_dimension_times(wanted, part->dimension, -1);
    bool done = yk_dim_repair(&dims->units, dims->current->expr, part, missing, &repaired);
    if (done)
        yk_problem_hint(dims->problems, "in a product a bare number is a plain number; give it its unit: `%s`",
                        yk_text_get(&repaired));
    yk_text_free(&repaired);
    return done;
}

// Hints at what would make a number without a unit `wanted`.
static void hint_at_number(YkDimensions *dims, const YkExpr *expr, YkDimension wanted)
{
    YkText repaired = {0};
    YkUnits units = dims->units;
    bool is_short = expr->text && expr->text_length <= QUOTE_MAX;
    if (!units.force_name) units.force_name = "N";
    yk_text_puts(&repaired, "1 ");
    yk_units_name(&units, wanted, &repaired);
    yk_text_puts(&repaired, " * (");
    yk_text_add(&repaired, is_short ? expr->text : "...", is_short ? expr->text_length : 3);
    yk_text_puts(&repaired, ")");
    yk_problem_hint(dims->problems, "it is a plain number: multiply it by a unit, as in `%s`", yk_text_get(&repaired));
    yk_text_free(&repaired);
}

void yk_dim_report_use(YkDimensions *dims, const YkExpr *expr, YkDimension wanted)
{
    if (is_silent(dims) || is_two_ways(dims, expr, wanted)) return;
    const YkConstraint *current = dims->current;
    yk_problem(dims->problems, YK_CODE_WRONG_DIMENSION, expr->place, "%s must be %s, this is %s",
               describe(dims, current), yk_dimension_name(wanted), yk_dimension_name(expr->dimension));
    const YkDimName *owner = current->parameter >= 0 ? &dims->names[current->parameter] : NULL;
    if (owner && owner->origin)
        yk_problem_hint(dims->problems, "it is used as %s on line %u, column %u", yk_dimension_name(wanted),
                        (unsigned)owner->origin_place.line, (unsigned)owner->origin_place.column);
    else if (!hint_at_product(dims, expr, wanted) && yk_dimension_equal(expr->dimension, YK_DIM_NONE))
        hint_at_number(dims, expr, wanted);
}

void yk_dim_report_pair(YkDimensions *dims, const YkExpr *expr)
{
    if (is_silent(dims)) return;
    YkDimension a = expr->a->dimension, b = expr->b->dimension;
    if (is_two_ways(dims, expr->b, a) || is_two_ways(dims, expr->a, b)) return;
    const char *name_a = yk_dimension_name(a), *name_b = yk_dimension_name(b);
    YkPlace place = expr->b->place;
    if (expr->kind == YK_EXPR_ADD)
        yk_problem(dims->problems, YK_CODE_MIXED_SUM, place, "cannot add %s and %s", name_a, name_b);
    else if (expr->kind == YK_EXPR_SUBTRACT)
        yk_problem(dims->problems, YK_CODE_MIXED_SUM, place, "cannot subtract %s from %s", name_b, name_a);
    else
        yk_problem(dims->problems, YK_CODE_MIXED_SUM, place, "%q needs two of the same kind, not %s and %s",
                   yk_function_name(expr->function), name_a, name_b);
    if (!hint_at_product(dims, expr->b, a)) hint_at_product(dims, expr->a, b);
}

// Returns whether the units of force, and those made with one, are usual: those of SI, and the dyne's.
bool yk_dimensions_is_usual(const YkUnits *units, YkDimension dimension)
{
    if (units->force > 0 || dimension.mass == 0 || dimension.time == 0) return true;
    double force = units->mass * units->length / (units->time * units->time);
    return force == 1 || (units->length == 0.01 && units->mass == 0.001);
}

void yk_dim_warn_of_unit(YkDimensions *dims, const YkExpr *number, YkDimension dimension)
{
    double value = 1;
    if (dims->phase != YK_PHASE_FINAL || dims->has_warned || yk_dimensions_is_usual(&dims->units, dimension)) return;
    if (yk_dim_literal(number, &value) && value == 0) return;
    dims->has_warned = true; // once is enough: one line of `units:` mends them all
    YkUnits newtons = dims->units;
    newtons.force = 1;
    newtons.force_name = "N";
    YkText unit = {0}, usual = {0};
    yk_units_name(&dims->units, dimension, &unit);
    yk_units_name(&newtons, dimension, &usual);
    double size = yk_units_size(&dims->units, dimension) / yk_units_size(&newtons, dimension);
    yk_problem(dims->problems, YK_CODE_ODD_UNIT, number->place,
               "%s: the file names no unit of force, so a bare number is in %s here, which is %e %s",
               describe(dims, dims->current), yk_text_get(&unit), size, yk_text_get(&usual));
    yk_problem_hint(dims->problems,
                    "say `force: N` under `units:`, which makes it %s, or write the unit after the number",
                    yk_text_get(&usual));
    dims->failed |= unit.failed || usual.failed;
    yk_text_free(&unit);
    yk_text_free(&usual);
}

void yk_dim_report_argument(YkDimensions *dims, const YkExpr *call, YkDimension wanted)
{
    if (is_silent(dims) || is_two_ways(dims, call->a, wanted)) return;
    yk_problem(dims->problems, YK_CODE_WRONG_ARGUMENT, call->a->place, "%q takes %s, this is %s",
               yk_function_name(call->function), yk_dimension_name(wanted), yk_dimension_name(call->a->dimension));
}

void yk_dim_report_power(YkDimensions *dims, const YkExpr *expr)
{
    if (is_silent(dims)) return;
    const char *base = yk_dimension_name(expr->a->dimension);
    double power;
    if (expr->kind == YK_EXPR_CALL)
        yk_problem(dims->problems, YK_CODE_BAD_POWER, expr->place, "cannot take the square root of %s", base);
    else if (yk_dim_literal(expr->b, &power))
        yk_problem(dims->problems, YK_CODE_BAD_POWER, expr->place, "cannot raise %s to the power %g", base, power);
    else
        yk_problem(dims->problems, YK_CODE_BAD_POWER, expr->b->place, "the exponent of %s must be a plain whole number",
                   base);
}

void yk_dim_report_exponent(YkDimensions *dims, const YkExpr *exponent)
{
    if (is_silent(dims) || is_two_ways(dims, exponent, YK_DIM_NONE)) return;
    yk_problem(dims->problems, YK_CODE_BAD_POWER, exponent->place, "an exponent must be a number, this is %s",
               yk_dimension_name(exponent->dimension));
}
