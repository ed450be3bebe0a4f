// The tree as YAML text: sections as blocks, each of their entries on a line of its own where it fits.
#include <string.h>
#include "doc/node.h"

enum { LINE_MAX_LENGTH = 110, INDENT = 2 };

// Does a scalar read back as itself without quotes, inside of braces too? More is quoted than would have to be.
static bool is_plain(const char *text, size_t length)
{
    if (length == 0 || strchr("?:,[]{}#&*!|>'\"%@` ", text[0]) || text[length - 1] == ' ') return false;
    if (text[0] == '-' && (length == 1 || text[1] == ' ' || text[1] == '-')) return false;
    if (strcspn(text, ",[]{}:?#") < length) return false;
    return strcmp(text, "~") != 0 && strcmp(text, "null") != 0 && strcmp(text, "...") != 0;
}

static bool is_nothing(const YkNode *scalar)
{
    return scalar->length == 0 || strcmp(scalar->text, "~") == 0 || strcmp(scalar->text, "null") == 0;
}

void yk_doc_write_scalar(const YkNode *scalar, YkText *text)
{
    if (!scalar->quoted && is_nothing(scalar)) {
        yk_text_puts(text, "~");
        return;
    }
    if (is_plain(scalar->text, scalar->length)) {
        yk_text_puts(text, scalar->text);
        return;
    }
    yk_text_puts(text, "'");
    for (size_t i = 0; i < scalar->length; i++) {
        yk_text_add(text, scalar->text + i, 1);
        if (scalar->text[i] == '\'') yk_text_puts(text, "'");
    }
    yk_text_puts(text, "'");
}

static void write_flow(const YkNode *node, YkText *text)
{
    if (node->kind == YK_NODE_SCALAR) {
        yk_doc_write_scalar(node, text);
        return;
    }
    bool is_map = node->kind == YK_NODE_MAP;
    yk_text_puts(text, is_map ? "{" : "[");
    for (size_t i = 0; i < node->count; i++) {
        if (i > 0) yk_text_puts(text, ", ");
        if (is_map) {
            yk_doc_write_scalar(node->pairs[i].key, text);
            yk_text_puts(text, ": ");
        }
        write_flow(is_map ? node->pairs[i].value : node->items[i], text);
    }
    yk_text_puts(text, is_map ? "}" : "]");
}

// A value behind its key or dash: on the same line where it is short, otherwise below, further in.
static void write_value(const YkNode *value, size_t indent, bool on_one_line, YkText *text)
{
    size_t start = text->length;
    yk_text_puts(text, " ");
    write_flow(value, text);
    bool fits = text->length - start + indent <= LINE_MAX_LENGTH;
    if (value->kind == YK_NODE_SCALAR || value->count == 0 || (on_one_line && fits) || text->failed) {
        yk_text_puts(text, "\n");
        return;
    }
    text->length = start;
    yk_text_puts(text, "\n");
    for (size_t i = 0; i < value->count; i++) {
        yk_text_repeat(text, ' ', indent);
        if (value->kind == YK_NODE_MAP) yk_doc_write_scalar(value->pairs[i].key, text);
        yk_text_puts(text, value->kind == YK_NODE_MAP ? ":" : "-");
        const YkNode *inner = value->kind == YK_NODE_MAP ? value->pairs[i].value : value->items[i];
        write_value(inner, indent + INDENT, true, text);
    }
}

void yk_doc_write(const YkNode *root, YkText *text)
{
    if (root->kind != YK_NODE_MAP || root->count == 0) {
        write_flow(root, text);
        yk_text_puts(text, "\n");
        return;
    }
    for (size_t i = 0; i < root->count; i++) {
        const YkNode *value = root->pairs[i].value;
        yk_doc_write_scalar(root->pairs[i].key, text);
        yk_text_puts(text, ":");
        write_value(value, INDENT, value->kind == YK_NODE_LIST, text);
    }
}
