// Puts libyaml's errors in plain words. Its messages are fixed strings (libyaml 0.2.5, scanner.c and parser.c).
#include <string.h>
#include "doc/reader.h"

typedef struct Phrase {
    const char *problem; // libyaml's message; the first phrase that fits is taken
    const char *context; // what it was doing then, or NULL for anything
    YkCode code;
    bool at_context;            // the place is where the context began, not where parsing stopped
    const char *message, *hint; // "%u, %u" in the hint: line and column where the context began
} Phrase;

static const Phrase phrases[] = {
    {NULL, "while scanning an anchor", YK_CODE_YAML_ANCHOR, true, "a value cannot start with `&`",
     "put text in quotes"},
    {NULL, "while scanning an alias", YK_CODE_YAML_ALIAS, true, "a value cannot start with `*`",
     "a product has its `*` between two factors; put text in quotes"},
    {NULL, "while scanning a tag", YK_CODE_YAML_TAG, true, "a value cannot start with `!`", "put text in quotes"},
    {NULL, "while parsing a tag", YK_CODE_YAML_TAG, true, "a value cannot start with `!`", "put text in quotes"},
    {"found undefined tag handle", NULL, YK_CODE_YAML_TAG, false, "a value cannot start with `!`",
     "put text in quotes"},
    {NULL, "while scanning a directive", YK_CODE_YAML_SYNTAX, true, "a line cannot start with `%`",
     "a comment starts with `#`"},
    {NULL, "while scanning a %TAG directive", YK_CODE_YAML_TAG, true, "tags are not used in model files",
     "remove the line"},
    {NULL, "while scanning a %YAML directive", YK_CODE_YAML_SYNTAX, true, "the version in this line cannot be read",
     "remove the line"},
    {"found incompatible YAML document", NULL, YK_CODE_YAML_SYNTAX, false, "this version of YAML is unknown",
     "remove the line `%YAML`"},
    {"found unexpected end of stream", "while scanning a quoted scalar", YK_CODE_YAML_SYNTAX, true,
     "the quote that opens here is never closed", "close it on the same line"},
    {"found unexpected document indicator", "while scanning a quoted scalar", YK_CODE_YAML_SYNTAX, true,
     "the quote that opens here is not closed before the line `---` or `...`", "close it on the same line"},
    {"found unknown escape character", NULL, YK_CODE_YAML_SYNTAX, false,
     "an unknown escape after `\\` in double quotes", "use single quotes, in which `\\` is a character like any other"},
    {"did not find expected hexdecimal number", NULL, YK_CODE_YAML_SYNTAX, false,
     "an escape with bad hexadecimal digits", NULL},
    {"found invalid Unicode character escape code", NULL, YK_CODE_YAML_SYNTAX, false, "an escape that is no character",
     NULL},
    {"could not find expected ':'", NULL, YK_CODE_YAML_SYNTAX, true, "there is no `:` after this key",
     "write `key: value`, with a space after the colon"},
    {"mapping values are not allowed in this context", NULL, YK_CODE_YAML_SYNTAX, false,
     "a `key: value` cannot start here", "check the indentation; put text that contains `: ` in quotes"},
    {"mapping keys are not allowed in this context", NULL, YK_CODE_YAML_SYNTAX, false,
     "a key with `? ` cannot start here", "write `key: value`"},
    {"block sequence entries are not allowed in this context", NULL, YK_CODE_YAML_SYNTAX, false,
     "a list item `- ` cannot start here", "start the list on a line of its own, or write `[first, second]`"},
    {"did not find expected ',' or ']'", NULL, YK_CODE_YAML_SYNTAX, false, "expected `,` or `]`",
     "the list opens on line %u, column %u"},
    {"did not find expected ',' or '}'", NULL, YK_CODE_YAML_SYNTAX, false, "expected `,` or `}`",
     "the map opens on line %u, column %u"},
    {"did not find expected '-' indicator", NULL, YK_CODE_YAML_SYNTAX, false, "expected the next list item, `- `",
     "check the indentation: the list starts on line %u, column %u"},
    {"did not find expected key", NULL, YK_CODE_YAML_SYNTAX, false, "expected a key",
     "check the indentation: the map starts on line %u, column %u"},
    {"did not find expected node content", NULL, YK_CODE_YAML_SYNTAX, false, "expected a value", NULL},
    {"found character that cannot start any token", NULL, YK_CODE_YAML_SYNTAX, false,
     "a value cannot start with this character", "put text in quotes"},
    {"did not find expected <document start>", NULL, YK_CODE_YAML_SYNTAX, false, "text after the end of the model",
     "check the indentation; one file describes one machine"},
    {"found a tab character where an indentation space is expected", NULL, YK_CODE_YAML_TAB, false,
     "a tab in the indentation", "indent with spaces"},
    {"found a tab character that violates indentation", NULL, YK_CODE_YAML_TAB, false, "a tab in the indentation",
     "indent with spaces"},
    {NULL, "while scanning a block scalar", YK_CODE_YAML_SYNTAX, true, "a value cannot start with `|` or `>`",
     "write the text on one line"},
};

static bool is(const char *wanted, const char *text)
{
    return !wanted || (text && strcmp(wanted, text) == 0);
}

static const Phrase *find_phrase(const yaml_parser_t *parser)
{
    for (size_t i = 0; i < sizeof phrases / sizeof *phrases; i++)
        if (is(phrases[i].problem, parser->problem) && is(phrases[i].context, parser->context)) return &phrases[i];
    return NULL;
}

// Returns the place of a mark. If the text ends inside an open map or list, libyaml's mark is after the last line:
// moves back to where there is text.
static YkPlace place_of(yaml_mark_t mark, const char *text, size_t length)
{
    while (length > 0 && (text[length - 1] == '\n' || text[length - 1] == '\r' || text[length - 1] == ' ')) length--;
    YkPlace end = yk_doc_place_of(text, length);
    YkPlace place = {(uint32_t)mark.line + 1, (uint32_t)mark.column + 1, 1};
    return place.line > end.line ? end : place;
}

// Returns where line `line` (from 1) begins; the end of the text when it has fewer lines.
static size_t line_start(const char *text, size_t length, size_t line)
{
    size_t at = 0;
    for (size_t i = 1; i < line && at < length; i++) {
        const char *end = memchr(text + at, '\n', length - at);
        at = end ? (size_t)(end - text) + 1 : length;
    }
    return at;
}

// Returns the index of the colon in a line that starts at `at` like `key:value`; 0 otherwise. *is_void: nothing but a
// comment.
static size_t tight_colon(const char *text, size_t length, size_t at, bool *is_void)
{
    while (at < length && text[at] == ' ') at++;
    *is_void = at >= length || strchr("\r\n#", text[at]) != NULL;
    while (at < length && text[at] != '\n' && !strchr(":\"'[]{}# ", text[at])) at++;
    return at + 1 < length && text[at] == ':' && !strchr(" \r\n", text[at + 1]) ? at : 0;
}

enum { LINES_BACK = 16 };

// Reports `a:1` before a line `b: 2`: the text continues over both lines, so libyaml stumbles only at the second colon.
static bool report_tight_colon(const char *text, size_t length, size_t line, YkProblems *problems)
{
    size_t colon = 0;
    bool is_void = true;
    for (int back = 0; back < LINES_BACK && --line > 0 && is_void; back++)
        colon = tight_colon(text, length, line_start(text, length, line), &is_void);
    if (colon == 0) return false;
    yk_problem(problems, YK_CODE_YAML_SYNTAX, yk_doc_place_of(text, colon), "there is no space after this `:`");
    yk_problem_hint(problems, "write `key: value`, with a space after the colon");
    return true;
}

void yk_doc_yaml_error(const yaml_parser_t *parser, const char *text, size_t length, YkProblems *problems)
{
    if (parser->error == YAML_MEMORY_ERROR) {
        yk_problem(problems, YK_CODE_OUT_OF_MEMORY, (YkPlace){0, 0, 0}, "out of memory");
        return;
    }
    const Phrase *phrase = find_phrase(parser);
    yaml_mark_t mark = phrase && phrase->at_context ? parser->context_mark : parser->problem_mark;
    YkPlace place = place_of(mark, text, length);
    if (!phrase) {
        yk_problem(problems, YK_CODE_YAML_SYNTAX, place, "this is not YAML: %s",
                   parser->problem ? parser->problem : "it cannot be read");
        return;
    }
    bool may_be_colon = is("mapping values are not allowed in this context", parser->problem) ||
                        is("did not find expected key", parser->problem);
    if (may_be_colon && report_tight_colon(text, length, place.line, problems)) return;
    yk_problem(problems, phrase->code, place, "%s", phrase->message);
    if (phrase->hint)
        yk_problem_hint(problems, phrase->hint, (unsigned)parser->context_mark.line + 1,
                        (unsigned)parser->context_mark.column + 1);
}
