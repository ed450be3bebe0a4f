// Reads numbers and their units: `0.75`, `3/4 m`, `30deg`, `0.5 rad/s`.
#include <math.h>
#include <string.h>
#include "base/number.h"
#include "expr/parser.h"

enum { QUOTE_MAX = 40 }; // the longest quotation of a text in a hint

// Copies a piece of the text as a string of its own, for messages.
static const char *piece(YkParser *parser, size_t start, size_t end)
{
    size_t length = end - start < QUOTE_MAX ? end - start : QUOTE_MAX;
    const char *copy = yk_arena_copy(parser->arena, parser->text + start, length);
    return copy ? copy : "";
}

static bool starts_unit(char c)
{
    return yk_begins_name(c) || c == '%';
}

static size_t skip_digits(const YkParser *parser, size_t at)
{
    while (yk_is_digit(yk_parser_peek(parser, at))) at++;
    return at;
}

static size_t skip_blanks_from(const YkParser *parser, size_t at)
{
    while (yk_parser_peek(parser, at) == ' ') at++;
    return at;
}

// Skips one factor of a unit: "kg", "s^2", "m^-1". A caret before anything else is the operator.
static size_t skip_factor(const YkParser *parser, size_t at)
{
    while (yk_is_name_part(yk_parser_peek(parser, at)) || yk_parser_peek(parser, at) == '%') at++;
    if (yk_parser_peek(parser, at) != '^') return at;
    size_t digits = at + 1 + (yk_parser_peek(parser, at + 1) == '-');
    size_t end = skip_digits(parser, digits);
    return end > digits ? end : at;
}

// Returns the end of the unit word that starts at `at`: factors joined by * and / without spaces.
static size_t unit_end(const YkParser *parser, size_t at)
{
    for (;;) {
        at = skip_factor(parser, at);
        char sign = yk_parser_peek(parser, at);
        if ((sign != '*' && sign != '/') || !starts_unit(yk_parser_peek(parser, at + 1))) return at;
        at++;
    }
}

// Returns where a unit contains the word `t` after an operator: it means the time far more often than the tonne.
static size_t find_time(const YkParser *parser, size_t start, size_t end)
{
    for (size_t i = start + 1; i < end; i++) {
        char before = parser->text[i - 1];
        bool is_alone = i + 1 == end || !yk_is_name_part(parser->text[i + 1]);
        if ((before == '*' || before == '/') && parser->text[i] == 't' && is_alone) return i;
    }
    return end;
}

static bool looks_like_a_name(const char *word)
{
    return strcmp(word, "t") == 0 || strpbrk(word, "0123456789_") != NULL;
}

// Refuses the text in place of a unit: a misspelt unit, or a factor whose operator is missing or has no spaces.
static YkExpr *refuse_unit(YkParser *parser, size_t number, size_t unit, size_t bad, size_t bad_length)
{
    if (bad_length == 0) bad_length = 1;
    const char *word = piece(parser, bad, bad + bad_length);
    bool is_call = yk_parser_peek(parser, skip_blanks_from(parser, bad + bad_length)) == '(';
    bool is_rate = yk_parser_peek(parser, bad + bad_length) == '.';
    bool is_name = is_call || is_rate || looks_like_a_name(word);
    const char *near = is_name ? NULL : yk_unit_nearest(parser->text + bad, bad_length);
    size_t number_end = unit;
    while (number_end > number && parser->text[number_end - 1] == ' ') number_end--;
    yk_problem(parser->problems, YK_CODE_EXPR_UNIT, yk_parser_place(parser, bad, bad + bad_length), "%q is not a unit",
               word);
    if (near && bad > unit)
        yk_problem_hint(parser->problems, "did you mean %q? For a product put spaces around the operator: `%s %c %s`",
                        near, piece(parser, number, bad - 1), (int)parser->text[bad - 1], word);
    else if (near)
        yk_problem_hint(parser->problems, "did you mean %q?", near);
    else if (bad > unit)
        yk_problem_hint(parser->problems, "for a product put spaces around the operator: `%s %c %s%s`",
                        piece(parser, number, bad - 1), (int)parser->text[bad - 1], word, is_call ? "(...)" : "");
    else
        yk_problem_hint(parser->problems, "for a product write `%s*%s%s`", piece(parser, number, number_end), word,
                        is_call ? "(...)" : "");
    return NULL;
}

// Reads the unit word at `unit` into the number. Returns false with a problem if it is not a unit.
static bool read_unit(YkParser *parser, YkExpr *number, size_t start, size_t unit)
{
    size_t end = unit_end(parser, unit), bad_length = 0;
    const char *bad = NULL;
    size_t time = find_time(parser, unit, end);
    if (!yk_unit_read(parser->text + unit, end - unit, &number->unit_size, &number->unit, &bad, &bad_length)) {
        refuse_unit(parser, start, unit, (size_t)(bad - parser->text), bad_length);
        return false;
    }
    if (time < end || yk_parser_peek(parser, end) == '(') {
        size_t at = time < end ? time : unit;
        refuse_unit(parser, start, unit, at, time < end ? 1 : end - unit);
        return false;
    }
    number->has_unit = true;
    parser->at = end;
    return true;
}

static YkExpr *read_number(YkParser *parser)
{
    size_t start = parser->at, left = parser->length - start;
    double value = 0;
    size_t bytes = yk_number_read(parser->text + start, left, &value);
    if (bytes == 0) {
        yk_problem(parser->problems, YK_CODE_EXPR_SYNTAX, yk_parser_place(parser, start, start + 1),
                   "expected a number");
        return NULL;
    }
    parser->at += bytes;
    if (!isfinite(value)) {
        yk_problem(parser->problems, YK_CODE_EXPR_OVERFLOW, yk_parser_place(parser, start, parser->at),
                   "the number %q is too large", piece(parser, start, parser->at));
        return NULL;
    }
    YkExpr *number = yk_parser_node(parser, YK_EXPR_NUMBER, start);
    if (!number) return NULL;
    number->number = value;
    number->is_exact = yk_number_read_exact(parser->text + start, bytes, &number->mantissa, &number->exponent);
    return number;
}

// Returns whether a ratio of integers with a unit starts at `start`, such as `3/4 m`. *second is then where its second
// integer starts and *unit where its unit does. Without a unit the quotient is an operation like any other.
static bool is_ratio(const YkParser *parser, size_t start, size_t *second, size_t *unit)
{
    size_t slash = skip_digits(parser, start);
    if (slash == start || yk_parser_peek(parser, slash) != '/') return false;
    size_t end = skip_digits(parser, slash + 1);
    if (end == slash + 1 || yk_parser_peek(parser, end) == '.') return false;
    *second = slash + 1;
    *unit = skip_blanks_from(parser, end);
    return starts_unit(yk_parser_peek(parser, *unit));
}

// Turns `3/4 m` into (3 m) / 4: exact, and of the same value.
static YkExpr *parse_ratio(YkParser *parser, size_t second, size_t unit)
{
    size_t start = parser->at;
    YkExpr *above = read_number(parser);
    if (!above) return NULL;
    parser->at = second;
    YkExpr *below = read_number(parser);
    if (!below || parser->at > unit) return NULL;
    if (!read_unit(parser, above, start, unit)) return NULL;
    YkExpr *ratio = yk_parser_node(parser, YK_EXPR_DIVIDE, start);
    if (!ratio) return NULL;
    ratio->a = above;
    ratio->b = below;
    parser->height = 2;
    return ratio;
}

YkExpr *yk_parse_literal(YkParser *parser)
{
    size_t start = parser->at, second, unit;
    if (is_ratio(parser, start, &second, &unit)) {
        // In `1/2e3 m` the exponent makes the second number not an integer: reads it as an operation.
        double value;
        size_t bytes = yk_number_read(parser->text + second, parser->length - second, &value);
        if (skip_blanks_from(parser, second + bytes) == unit) return parse_ratio(parser, second, unit);
    }
    YkExpr *number = read_number(parser);
    if (!number) return NULL;
    unit = skip_blanks_from(parser, parser->at);
    if (!starts_unit(yk_parser_peek(parser, unit))) return number;
    if (!read_unit(parser, number, start, unit)) return NULL;
    number->place = yk_parser_place(parser, start, parser->at);
    number->text_length = parser->at - start;
    return number;
}
