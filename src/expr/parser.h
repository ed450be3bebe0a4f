// Shared by the parser's files; no other room includes it.
#ifndef EXPR_PARSER_H
#define EXPR_PARSER_H
#include "base/letters.h"
#include "expr/expr.h"

// Everything outside ASCII ends the parse, so every byte before a problem is one column.
typedef struct YkParser {
    const char *text;
    size_t length, at;
    YkPlace place; // of the first character
    YkArena *arena;
    YkProblems *problems;
    int depth;  // of the recursion
    int height; // of the tree parsed last
} YkParser;

char yk_parser_peek(const YkParser *parser, size_t at); // '\0' at the end
void yk_parser_skip_blanks(YkParser *parser);
YkPlace yk_parser_place(const YkParser *parser, size_t start, size_t end);
// Makes a node over text[start..at), of height 1. Returns NULL when out of memory, with a problem.
YkExpr *yk_parser_node(YkParser *parser, YkExprKind kind, size_t start);

bool yk_is_name_part(char c); // a letter, _ or a digit

// Report problems; all return NULL, for the caller to return. `expected`: something else stands in place of `wanted`.
YkExpr *yk_parser_expected(YkParser *parser, const char *wanted);
YkExpr *yk_parser_expected_operator(YkParser *parser);
YkExpr *yk_parser_refuse_function(YkParser *parser, const char *name, size_t start, size_t end);
YkExpr *yk_parser_refuse_arguments(YkParser *parser, YkFunction function, size_t start, size_t end);

// Parses a number with its unit, if any; the text stands at a digit, or at a point before one. NULL with a problem.
YkExpr *yk_parse_literal(YkParser *parser);

#endif
