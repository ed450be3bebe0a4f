// Any bytes as a small file of expressions: "name = expression" lines are parameters, other lines are uses whose wanted
// dimension is taken from their length. Parsed, inferred, evaluated.
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include "expr/expr.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

enum { USES = 64 };

typedef struct Uses {
    YkExpr *exprs[USES];
    size_t count;
} Uses;

static void demand(bool condition)
{
    if (!condition) abort();
}

static bool lookup(const void *context, const YkExpr *name, YkJet *jet)
{
    (void)context;
    double value = (double)(unsigned char)name->name[0] / 100 - 1;
    *jet = (YkJet){{value, strcmp(name->name, "t") == 0, 0, 0, 0}};
    return name->name[0] != 'z';
}

// Places lie within the text, parts within the whole, and walking works.
static void check_places(const YkExpr *expr, size_t length)
{
    demand(expr->place.column >= 1 && expr->place.column - 1 + expr->place.length <= length);
    if (expr->a) check_places(expr->a, length);
    if (expr->b) check_places(expr->b, length);
}

static void check_value(const YkExpr *expr)
{
    const char *why;
    YkJet jet;
    const YkExpr *fault = yk_expr_eval(expr, lookup, NULL, &jet, &why);
    demand((fault == NULL) == (why == NULL));
    for (int k = 0; k <= YK_JET_ORDER; k++) demand(isfinite(jet.d[k]));
}

static void read_line(YkDimensions *dims, const char *line, size_t length, YkArena *arena, YkProblems *problems,
                      Uses *uses)
{
    const char *equals = memchr(line, '=', length);
    size_t start = equals ? (size_t)(equals - line) + 1 : 0;
    size_t before = yk_problems_error_count(problems);
    YkExpr *expr = yk_expr_parse(line + start, length - start, (YkPlace){1, 1, 0}, arena, problems);
    demand((expr == NULL) == (yk_problems_error_count(problems) > before) || before >= 200);
    if (!expr) return;
    check_places(expr, length - start);
    if (equals) {
        const char *name = yk_arena_copy(arena, line, start - 1);
        if (name) yk_dimensions_parameter(dims, name, expr);
    } else {
        signed char kind = (signed char)(length % 4);
        yk_dimensions_use(dims, expr, (YkDimension){kind, kind == 2, kind == 3 ? -2 : 0, kind == 0}, "a use");
    }
    if (uses->count < USES) uses->exprs[uses->count++] = expr;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    YkArena *arena = yk_arena_new();
    YkProblems *problems = yk_problems_new();
    YkUnits units = yk_units_si();
    units.length = 1e-3;
    units.angle = 0.017453292519943295;
    YkDimensions *dims = arena ? yk_dimensions_new(arena, &units) : NULL;
    if (dims && problems) {
        Uses uses = {.count = 0};
        yk_dimensions_fix(dims, "t", (YkDimension){0, 0, 1, 0});
        yk_dimensions_fix(dims, "pi", (YkDimension){0, 0, 0, 0});
        yk_dimensions_fix(dims, "theta", (YkDimension){0, 0, 0, 1});
        const char *text = (const char *)data, *end = text + size;
        for (const char *next; text < end; text = next) {
            const char *stop = memchr(text, '\n', (size_t)(end - text));
            next = stop ? stop + 1 : end;
            read_line(dims, text, (size_t)((stop ? stop : end) - text), arena, problems, &uses);
        }
        yk_dimensions_run(dims, problems);
        for (size_t i = 0; i < uses.count; i++) check_value(uses.exprs[i]);
        demand(yk_problems_text(problems, 0) != NULL);
    }
    yk_problems_free(problems);
    yk_arena_free(arena);
    return 0;
}
