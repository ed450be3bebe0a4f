// Shared by the grammar, the literals and the messages of the parser: characters, places, nodes.
#include "expr/parser.h"

char yk_parser_peek(const YkParser *parser, size_t at)
{
    return at < parser->length ? parser->text[at] : '\0';
}

void yk_parser_skip_blanks(YkParser *parser)
{
    while (yk_parser_peek(parser, parser->at) == ' ') parser->at++;
}

YkPlace yk_parser_place(const YkParser *parser, size_t start, size_t end)
{
    YkPlace place = parser->place;
    if (place.line == 0) return place; // an unknown place stays unknown
    place.column += (uint32_t)start;
    place.length = (uint32_t)(end - start);
    return place;
}

bool yk_is_name_part(char c)
{
    return yk_begins_name(c) || yk_is_digit(c);
}

YkExpr *yk_parser_node(YkParser *parser, YkExprKind kind, size_t start)
{
    YkExpr *node = YK_NEW(parser->arena, YkExpr, 1);
    YkPlace place = yk_parser_place(parser, start, parser->at);
    if (!node) {
        yk_problem(parser->problems, YK_CODE_OUT_OF_MEMORY, place, "out of memory");
        return NULL;
    }
    node->kind = kind;
    node->place = place;
    node->text = parser->text + start;
    node->text_length = parser->at - start;
    node->unit_size = 1;
    node->value_scale = 1;
    parser->height = 1;
    return node;
}
