// Messages of the parser when something else stands in place of a piece of an expression.
#include <string.h>
#include "base/utf8.h"
#include "expr/parser.h"
#include "graph/function.h"

typedef struct Look {
    const char *character, *meant;
} Look;

// Returns the plain character for one that word processors and keyboards offer in its place.
static const char *meant_by(const char *text, size_t length)
{
    static const Look looks[] = {{"\xe2\x88\x92", "-"}, {"\xe2\x80\x93", "-"}, {"\xc3\x97", "*"},   {"\xc2\xb7", "*"},
                                 {"\xe2\x8b\x85", "*"}, {"\xc3\xb7", "/"},     {"\xc2\xb0", "deg"}, {"\xc2\xb2", "^2"},
                                 {"\xc2\xb3", "^3"},    {"\xc2\xb5", "u"},     {"\xcf\x80", "pi"},  {"\xc2\xa0", " "}};
    for (size_t i = 0; i < sizeof looks / sizeof *looks; i++) {
        size_t size = strlen(looks[i].character);
        if (size <= length && memcmp(looks[i].character, text, size) == 0) return looks[i].meant;
    }
    return NULL;
}

static YkExpr *refuse_character(YkParser *parser)
{
    const char *text = parser->text + parser->at;
    size_t left = parser->length - parser->at;
    uint32_t code_point;
    size_t bytes = yk_utf8_decode(text, left, &code_point);
    const char *character = yk_arena_copy(parser->arena, text, bytes > 0 ? bytes : 1);
    yk_problem(parser->problems, YK_CODE_EXPR_CHARACTER, yk_parser_place(parser, parser->at, parser->at + 1),
               "%q cannot stand in an expression", character ? character : "");
    const char *meant = meant_by(text, left);
    if (meant) yk_problem_hint(parser->problems, "write %q", meant);
    return NULL;
}

// Reports that something else stands in place of `wanted`.
YkExpr *yk_parser_expected(YkParser *parser, const char *wanted)
{
    char c = yk_parser_peek(parser, parser->at);
    YkPlace place = yk_parser_place(parser, parser->at, parser->at + 1);
    bool is_end = parser->at >= parser->length;
    if (!is_end && c != '\'' && (!strchr("+-*/^(),.", c) || c == '\0') && !yk_is_name_part(c))
        return refuse_character(parser);
    if (is_end) {
        yk_problem(parser->problems, YK_CODE_EXPR_SYNTAX, place, "expected %s, but the expression ends here", wanted);
        return NULL;
    }
    char found[2] = {c, '\0'};
    yk_problem(parser->problems, YK_CODE_EXPR_SYNTAX, place, "expected %s, found `%s`", wanted, found);
    if (c == ',') yk_problem_hint(parser->problems, "a comma ends a number: write `1.5` and `1000`");
    return NULL;
}

YkExpr *yk_parser_expected_operator(YkParser *parser)
{
    char c = yk_parser_peek(parser, parser->at);
    if (c == ')') {
        YkPlace place = yk_parser_place(parser, parser->at, parser->at + 1);
        yk_problem(parser->problems, YK_CODE_EXPR_SYNTAX, place, "this `)` closes nothing");
        return NULL;
    }
    yk_parser_expected(parser, "an operator");
    if (yk_is_name_part(c) || c == '(') yk_problem_hint(parser->problems, "a product needs its `*`");
    if (c == '.' && yk_begins_name(yk_parser_peek(parser, parser->at + 1)))
        yk_problem_hint(parser->problems, "a blank ends a unit: `2 N*s/m * s.rate`");
    return NULL;
}

YkExpr *yk_parser_refuse_function(YkParser *parser, const char *name, size_t start, size_t end)
{
    yk_problem(parser->problems, YK_CODE_EXPR_FUNCTION, yk_parser_place(parser, start, end), "there is no function %q",
               name);
    const char *near = yk_function_nearest(name);
    if (strcmp(name, "pow") == 0)
        yk_problem_hint(parser->problems, "write a power with `^`: `a^b`");
    else if (near)
        yk_problem_hint(parser->problems, "did you mean %q?", near);
    else
        yk_problem_hint(parser->problems, "for a product write `*` before the parenthesis");
    return NULL;
}

YkExpr *yk_parser_refuse_arguments(YkParser *parser, YkFunction function, size_t start, size_t end)
{
    int arity = yk_function_arity(function);
    yk_problem(parser->problems, YK_CODE_EXPR_ARGUMENTS, yk_parser_place(parser, start, end), "%q takes %s",
               yk_function_name(function), arity == 1 ? "one argument" : "two arguments");
    if (arity == 1) yk_problem_hint(parser->problems, "a comma ends a number: write `1.5` and `1000`");
    return NULL;
}
