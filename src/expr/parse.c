// The grammar, by recursive descent:
//   sum      product {("+" | "-") product}
//   product  sign {("*" | "/") sign}
//   sign     ("-" | "+") sign | power
//   power    primary ["^" sign]
//   primary  literal | name | function "(" sum {"," sum} ")" | "(" sum ")"
// The first mistake ends the parse.
#include "expr/parser.h"
#include "graph/function.h"

static YkExpr *parse_sum(YkParser *parser);
static YkExpr *parse_sign(YkParser *parser);

static YkExpr *too_deep(YkParser *parser, size_t start, const char *message)
{
    yk_problem(parser->problems, YK_CODE_EXPR_TOO_DEEP, yk_parser_place(parser, start, start + 1), "%s", message);
    yk_problem_hint(parser->problems, "split the expression by parameters");
    return NULL;
}

// Joins operands (b NULL for one), given their heights, into a node over text[start..at).
static YkExpr *join(YkParser *parser, YkExprKind kind, size_t start, const YkExpr *a, int a_height, const YkExpr *b)
{
    if (!a) return NULL;
    int height = 1 + (b && parser->height > a_height ? parser->height : a_height);
    if (height > YK_EXPR_HEIGHT_MAX) return too_deep(parser, start, "too many operations follow each other");
    YkExpr *node = yk_parser_node(parser, kind, start);
    if (!node) return NULL;
    node->a = a;
    node->b = b;
    parser->height = height;
    return node;
}

static bool take(YkParser *parser, char c)
{
    yk_parser_skip_blanks(parser);
    if (yk_parser_peek(parser, parser->at) != c || parser->at >= parser->length) return false;
    parser->at++;
    return true;
}

static size_t name_end(const YkParser *parser, size_t at)
{
    for (;;) {
        while (yk_is_name_part(yk_parser_peek(parser, at))) at++;
        if (yk_parser_peek(parser, at) != '.' || !yk_begins_name(yk_parser_peek(parser, at + 1))) return at;
        at++;
    }
}

// Parses the arguments and the closing parenthesis; the opening one has been read.
static YkExpr *parse_call(YkParser *parser, const char *name, size_t start, size_t name_stop)
{
    YkFunction function;
    if (!yk_function_find(name, &function)) return yk_parser_refuse_function(parser, name, start, name_stop);
    int arity = yk_function_arity(function);
    YkExpr *a = parse_sum(parser), *b = NULL;
    if (!a) return NULL;
    int height = parser->height;
    if (arity == 2) {
        if (!take(parser, ',')) {
            if (yk_parser_peek(parser, parser->at) != ')')
                return yk_parser_expected(parser, "`,` and a second argument");
            return yk_parser_refuse_arguments(parser, function, start, name_stop);
        }
        b = parse_sum(parser);
        if (!b) return NULL;
    }
    if (yk_parser_peek(parser, parser->at) == ',')
        return yk_parser_refuse_arguments(parser, function, parser->at, parser->at + 1);
    if (!take(parser, ')')) return yk_parser_expected(parser, "an operator or `)`");
    YkExpr *call = join(parser, YK_EXPR_CALL, start, a, height, b);
    if (call) call->function = function;
    return call;
}

static YkExpr *parse_name(YkParser *parser)
{
    size_t start = parser->at, end = name_end(parser, start);
    char *name = yk_arena_copy(parser->arena, parser->text + start, end - start);
    if (!name) {
        yk_problem(parser->problems, YK_CODE_OUT_OF_MEMORY, parser->place, "out of memory");
        return NULL;
    }
    parser->at = end;
    if (take(parser, '(')) return parse_call(parser, name, start, end);
    parser->at = end;
    YkExpr *node = yk_parser_node(parser, YK_EXPR_NAME, start);
    if (node) node->name = name;
    return node;
}

static YkExpr *parse_primary(YkParser *parser)
{
    yk_parser_skip_blanks(parser);
    char c = yk_parser_peek(parser, parser->at);
    if (yk_is_digit(c) || (c == '.' && yk_is_digit(yk_parser_peek(parser, parser->at + 1))))
        return yk_parse_literal(parser);
    if (yk_begins_name(c)) return parse_name(parser);
    if (!take(parser, '(')) return yk_parser_expected(parser, "a value");
    YkExpr *inside = parse_sum(parser);
    if (!inside) return NULL;
    return take(parser, ')') ? inside : yk_parser_expected(parser, "an operator or `)`");
}

static YkExpr *parse_power(YkParser *parser)
{
    yk_parser_skip_blanks(parser);
    size_t start = parser->at;
    YkExpr *base = parse_primary(parser);
    int height = parser->height;
    size_t end = parser->at;
    if (!base || !take(parser, '^')) {
        parser->at = end; // blanks after a value are not part of it
        return base;
    }
    YkExpr *exponent = parse_sign(parser);
    return exponent ? join(parser, YK_EXPR_POWER, start, base, height, exponent) : NULL;
}

// Parses a sign. Every recursion passes here: parentheses, arguments, signs, exponents.
static YkExpr *parse_sign(YkParser *parser)
{
    yk_parser_skip_blanks(parser);
    size_t start = parser->at;
    YkExpr *result;
    if (parser->depth == YK_EXPR_DEPTH_MAX) return too_deep(parser, start, "the expression is nested too deeply");
    parser->depth++;
    if (take(parser, '-')) {
        YkExpr *operand = parse_sign(parser);
        result = join(parser, YK_EXPR_NEGATE, start, operand, parser->height, NULL);
    } else {
        result = take(parser, '+') ? parse_sign(parser) : parse_power(parser);
    }
    parser->depth--;
    return result;
}

// Reads one of two operators, or leaves the text unread.
static bool take_operator(YkParser *parser, char first, char second, bool *is_second)
{
    size_t start = parser->at;
    *is_second = false;
    if (take(parser, first)) return true;
    *is_second = true;
    if (take(parser, second)) return true;
    parser->at = start;
    return false;
}

static YkExpr *parse_product(YkParser *parser)
{
    yk_parser_skip_blanks(parser);
    size_t start = parser->at;
    YkExpr *left = parse_sign(parser);
    bool divides;
    while (left && take_operator(parser, '*', '/', &divides)) {
        int height = parser->height;
        if (!divides && yk_parser_peek(parser, parser->at) == '*') {
            yk_parser_expected(parser, "a value");
            yk_problem_hint(parser->problems, "write a power with `^`");
            return NULL;
        }
        YkExpr *right = parse_sign(parser);
        left = right ? join(parser, divides ? YK_EXPR_DIVIDE : YK_EXPR_MULTIPLY, start, left, height, right) : NULL;
    }
    return left;
}

static YkExpr *parse_sum(YkParser *parser)
{
    yk_parser_skip_blanks(parser);
    size_t start = parser->at;
    YkExpr *left = parse_product(parser);
    bool subtracts;
    while (left && take_operator(parser, '+', '-', &subtracts)) {
        int height = parser->height;
        YkExpr *right = parse_product(parser);
        left = right ? join(parser, subtracts ? YK_EXPR_SUBTRACT : YK_EXPR_ADD, start, left, height, right) : NULL;
    }
    yk_parser_skip_blanks(parser);
    return left;
}

YkExpr *yk_expr_parse(const char *text, size_t length, YkPlace place, YkArena *arena, YkProblems *problems)
{
    YkParser parser = {.text = text, .length = length, .place = place, .arena = arena, .problems = problems};
    YkExpr *expr = parse_sum(&parser);
    if (!expr) return NULL;
    return parser.at == length ? expr : yk_parser_expected_operator(&parser);
}
