// Finds a function of two arguments inside `{...}` or `[...]`: in YAML its comma ends the value.
#include "base/text.h"
#include "doc/reader.h"

// The look ahead at each value, so that a list of values that never end costs no more than its length.
enum { PIECES_MAX = 16 };

// Returns how many parentheses are left open after the text of a plain scalar; parentheses in quotes do not count.
static int open_after(int open, const YkNode *node)
{
    if (node->kind != YK_NODE_SCALAR || node->quoted) return 0;
    for (size_t i = 0; i < node->length; i++) open += (node->text[i] == '(') - (node->text[i] == ')');
    return open;
}

// Returns the piece that follows at `index` of the list or map: in a map a key without a value. NULL if there is none.
static const YkNode *piece_at(const YkNode *node, size_t index)
{
    if (index >= node->count) return NULL;
    if (node->kind == YK_NODE_LIST) return node->items[index];
    const YkNode *value = node->pairs[index].value;
    bool is_void = value->kind == YK_NODE_SCALAR && !value->quoted && value->length == 0;
    return is_void ? node->pairs[index].key : NULL;
}

// Returns how many pieces after entry `index` belong to its value; 0 if the value is whole, or does not end
// within PIECES_MAX.
static size_t pieces_after(const YkNode *node, size_t index, const YkNode *value)
{
    int open = open_after(0, value);
    for (size_t more = 1; open > 0 && more <= PIECES_MAX; more++) {
        const YkNode *piece = piece_at(node, index + more);
        if (!piece || piece->kind != YK_NODE_SCALAR || piece->quoted) return 0;
        open = open_after(open, piece);
        if (open <= 0) return more;
    }
    return 0;
}

static void report(const YkNode *node, size_t index, const YkNode *value, size_t more, YkProblems *problems)
{
    YkText whole = {0};
    YkPlace place = value->place;
    yk_text_puts(&whole, value->text);
    for (size_t i = 1; i <= more; i++) {
        const YkNode *piece = piece_at(node, index + i);
        yk_text_format(&whole, ", %s", piece->text);
        if (piece->place.line == place.line)
            place.length = piece->place.column + piece->place.length - value->place.column;
    }
    yk_problem(problems, YK_CODE_YAML_COMMA, place, "the comma in `%s` ends the value", yk_text_get(&whole));
    yk_problem_hint(problems, "between `{` and `}` or `[` and `]`, quote it: `\"%s\"`", yk_text_get(&whole));
    yk_text_free(&whole);
}

bool yk_doc_check_commas(const YkNode *node, YkProblems *problems)
{
    bool good = true;
    for (size_t i = 0; i < node->count; i++) {
        const YkNode *value = node->kind == YK_NODE_LIST ? node->items[i] : node->pairs[i].value;
        size_t more = pieces_after(node, i, value);
        if (more == 0) continue;
        report(node, i, value, more, problems);
        i += more;
        good = false;
    }
    return good;
}
