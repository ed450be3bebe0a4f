// Shared by the tests of expressions: a fixture with arena and problems, and a tree written as text.
#ifndef TESTS_EXPR_CHECK_H
#define TESTS_EXPR_CHECK_H
#include "check.h"
#include <stdlib.h>
#include "base/number.h"
#include "expr/expr.h"
#include "graph/function.h"

typedef struct Fixture {
    YkArena *arena;
    YkProblems *problems;
} Fixture;

static inline Fixture fixture_new(void)
{
    return (Fixture){yk_arena_new(), yk_problems_new()};
}

static inline void fixture_free(Fixture *fixture)
{
    yk_arena_free(fixture->arena);
    yk_problems_free(fixture->problems);
}

static inline YkExpr *fixture_parse(Fixture *fixture, const char *text)
{
    return yk_expr_parse(text, strlen(text), (YkPlace){3, 11, 0}, fixture->arena, fixture->problems);
}

static inline void tree_add(char *out, size_t size, const char *text)
{
    size_t used = strlen(out);
    snprintf(out + used, size - used, "%s", text);
}

// Prefix form: "(+ a (* 2 b))"; a number with a unit as "2[0.001]".
static inline void tree_write(const YkExpr *expr, char *out, size_t size)
{
    static const char *const signs[] = {"", "", "-", "+", "-", "*", "/", "^", ""};
    char number[64];
    if (expr->kind == YK_EXPR_NUMBER) {
        snprintf(number, sizeof number, "%.10g", expr->number);
        tree_add(out, size, number);
        snprintf(number, sizeof number, "[%.6g]", expr->unit_size);
        if (expr->has_unit) tree_add(out, size, number);
        return;
    }
    if (expr->kind == YK_EXPR_NAME) {
        tree_add(out, size, expr->name);
        return;
    }
    tree_add(out, size, "(");
    tree_add(out, size, expr->kind == YK_EXPR_CALL ? yk_function_name(expr->function) : signs[expr->kind]);
    tree_add(out, size, " ");
    tree_write(expr->a, out, size);
    if (expr->b) {
        tree_add(out, size, " ");
        tree_write(expr->b, out, size);
    }
    tree_add(out, size, ")");
}

// Fails unless the fixture's only problem has this code and column, and mentions `word` in message or hint.
static inline void check_one_problem(const Fixture *fixture, const char *text, int code, unsigned column,
                                     const char *word)
{
    size_t count = yk_problems_count(fixture->problems);
    const YkProblem *problem = count > 0 ? yk_problems_get(fixture->problems, 0) : NULL;
    bool fits = count == 1 && problem->code == code && problem->place.line == 3 && problem->place.column == 10 + column;
    bool says = problem && (!word || strstr(problem->message, word) || (problem->hint && strstr(problem->hint, word)));
    if (!fits || !says)
        print_error("«%s»: wanted one %d at column %u with «%s»; %zu problems, first: %s", text, code, column,
                    word ? word : "", count, yk_problems_text(fixture->problems, 0));
    assert_true(fits && says);
}
#endif
