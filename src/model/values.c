// Reads single values: a plain number has its value at once, an expression becomes a use that waits for its value.
#include <math.h>
#include <string.h>
#include "base/number.h"
#include "model/load.h"

const char *yk_load_subject(YkLoader *loader, const YkSubject *subject)
{
    YkText *text = &loader->text;
    yk_text_clear(text);
    if (subject->axis) yk_text_puts(text, subject->axis);
    yk_text_puts(text, subject->noun);
    if (subject->part) yk_text_format(text, " %q", subject->part);
    if (subject->owner) yk_text_format(text, " of %q", subject->owner);
    return yk_text_get(text);
}

bool yk_load_is_empty(const YkNode *node)
{
    if (!node) return true;
    if (node->kind != YK_NODE_SCALAR) return false;
    if (node->length == 0) return true;
    return !node->quoted && (strcmp(node->text, "~") == 0 || strcmp(node->text, "null") == 0);
}

static const char *kind_name(YkNodeKind kind)
{
    return kind == YK_NODE_SCALAR ? "a value" : kind == YK_NODE_LIST ? "a list" : "a map";
}

bool yk_load_expect(YkLoader *loader, const YkNode *node, YkNodeKind kind, const YkSubject *subject)
{
    if (node->kind == kind && !(kind == YK_NODE_SCALAR && yk_load_is_empty(node))) return true;
    const char *what = yk_load_subject(loader, subject);
    if (yk_load_is_empty(node)) {
        yk_problem(loader->problems, YK_CODE_EMPTY_VALUE, node->place, "%s is left empty", what);
        yk_problem_hint(loader->problems, "%s is needed", kind_name(kind));
    } else {
        yk_problem(loader->problems, YK_CODE_WRONG_KIND, node->place, "%s must be %s, this is %s", what,
                   kind_name(kind), yk_node_kind_name(node));
    }
    return false;
}

YkPlace yk_load_text_place(const YkNode *node)
{
    YkPlace place = node->place;
    if (node->quoted) place.column++;
    return place;
}

void yk_load_refuse_amount(YkLoader *loader, YkCode code, const YkExpr *expr, double value, YkDimension dimension,
                           const char *message, const char *noun, const char *owner)
{
    const YkUnits *units = &loader->model->units;
    YkText unit = {0};
    yk_units_name(units, dimension, &unit);
    yk_problem(loader->problems, code, expr->place, message, noun, owner, value / yk_units_size(units, dimension),
               yk_text_get(&unit));
    loader->failed |= unit.failed;
    yk_text_free(&unit);
}

bool yk_load_in_range(YkLoader *loader, YkPlace place, double value)
{
    if (fabs(value) <= YK_VALUE_MAX) return true;
    yk_problem(loader->problems, YK_CODE_VALUE_RANGE, place,
               isfinite(value) ? "the value %e is beyond 1e100 in SI units" : "the value is not finite", value);
    return false;
}

// Makes a plain number a single node: most of a large file is numbers, which need neither parser nor inference.
static YkExpr *plain_number(YkLoader *loader, const YkNode *node, YkDimension dimension)
{
    bool is_negative = node->length > 0 && node->text[0] == '-';
    const char *digits = node->text + is_negative;
    size_t length = node->length - is_negative;
    double number = 0;
    if (length == 0 || yk_number_read(digits, length, &number) != length || !isfinite(number)) return NULL;
    YkExpr *expr = YK_NEW(loader->arena, YkExpr, is_negative ? 2u : 1u);
    if (!expr) return NULL;
    YkPlace place = yk_load_text_place(node);
    YkExpr *literal = expr + is_negative;
    *literal = (YkExpr){.kind = YK_EXPR_NUMBER, .place = place, .number = number, .unit_size = 1};
    literal->is_exact = yk_number_read_exact(digits, length, &literal->mantissa, &literal->exponent);
    literal->value_scale = yk_units_size(&loader->model->units, dimension);
    if (!is_negative) return expr;
    literal->place.column++;
    *expr = (YkExpr){.kind = YK_EXPR_NEGATE, .place = place, .unit_size = 1, .value_scale = 1, .a = literal};
    return expr;
}

static double plain_value(const YkExpr *expr)
{
    return expr->kind == YK_EXPR_NEGATE ? -plain_value(expr->a) : expr->number * expr->value_scale;
}

// The meaning of `name` in one value alone, while its names are replaced.
typedef struct Meaning {
    YkLoader *loader;
    const YkOwnName *own;
} Meaning;

// Replaces a name. A parameter or another coordinate of that name could be meant as well.
static void replace_name(void *context, const YkExpr *name)
{
    const Meaning *meaning = context;
    const YkModel *model = meaning->loader->model;
    const YkOwnName *own = meaning->own;
    if (strcmp(name->name, own->name) != 0) return;
    bool is_parameter = yk_names_find(&model->parameter_names, own->name) != YK_NONE;
    bool is_other = strcmp(own->name, own->means) != 0 && yk_names_find(&model->coordinate_names, own->name) != YK_NONE;
    if (is_parameter || is_other) {
        yk_problem(meaning->loader->problems, YK_CODE_REPEATED_NAME, name->place,
                   "%q is %s here, and also the name of a %s", own->name, own->whose,
                   is_parameter ? "parameter" : "coordinate");
        yk_problem_hint(meaning->loader->problems, "rename the %s", is_parameter ? "parameter" : "coordinate");
    }
    ((YkExpr *)name)->name = own->means;
}

static YkExpr *waiting_expression(YkLoader *loader, const YkNode *node, const YkWant *want, double *target)
{
    YkExpr *expr = yk_expr_parse(node->text, node->length, yk_load_text_place(node), loader->arena, loader->problems);
    if (!expr) return NULL;
    for (const YkOwnName *own = want->own; own && own->name; own++)
        yk_expr_names(expr, replace_name, &(Meaning){loader, own});
    const char *what = yk_load_subject(loader, &want->subject);
    what = yk_arena_copy(loader->arena, what, strlen(what));
    if (!what || !YK_ROOM(loader->uses, loader->use_count, loader->use_capacity)) {
        loader->failed = true;
        return NULL;
    }
    loader->uses[loader->use_count++] =
        (YkUse){.expr = expr, .dimension = want->dimension, .scope = want->scope, .what = what, .target = target};
    return expr;
}

YkExpr *yk_load_value(YkLoader *loader, const YkNode *node, const YkWant *want, double *target)
{
    if (target) *target = NAN;
    if (!yk_load_expect(loader, node, YK_NODE_SCALAR, &want->subject)) return NULL;
    bool is_usual = yk_dimensions_is_usual(&loader->model->units, want->dimension); // otherwise inference warns of it
    YkExpr *expr = is_usual ? plain_number(loader, node, want->dimension) : NULL;
    if (!expr) return waiting_expression(loader, node, want, target);
    double value = plain_value(expr);
    if (yk_load_in_range(loader, node->place, value) && target) *target = value;
    return expr;
}

bool yk_load_expect_pair(YkLoader *loader, const YkNode *node, const YkWant *want)
{
    if (!yk_load_expect(loader, node, YK_NODE_LIST, &want->subject)) return false;
    if (node->count == 2) return true;
    yk_problem(loader->problems, YK_CODE_COMPONENTS, node->place, "%s has two components, x and y; here are %z",
               yk_load_subject(loader, &want->subject), node->count);
    if (node->count > 2) yk_problem_hint(loader->problems, "a comma ends a number: write `1.5` and `1000`");
    return false;
}

bool yk_load_pair(YkLoader *loader, const YkNode *node, const YkWant *want, YkExpr *expr[2], YkVec *target)
{
    if (target) *target = yk_vec(NAN, NAN);
    if (!yk_load_expect_pair(loader, node, want)) return false;
    YkWant component = *want;
    component.subject.axis = "x of ";
    expr[0] = yk_load_value(loader, node->items[0], &component, target ? &target->x : NULL);
    component.subject.axis = "y of ";
    expr[1] = yk_load_value(loader, node->items[1], &component, target ? &target->y : NULL);
    return expr[0] && expr[1];
}

YkExpr *yk_load_key_value(YkLoader *loader, const YkNode *map, const char *key, const YkWant *want, double *target)
{
    const YkNode *node = yk_node_get(map, key);
    if (node) return yk_load_value(loader, node, want, target);
    *target = 0;
    return NULL;
}
