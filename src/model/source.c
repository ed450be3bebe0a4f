// The text that a model came from, kept so that it can be written again: comments, order and layout as they are.
#include <string.h>
#include <yoke/builder.h>
#include "model/load.h"

// From byte *offset, where line *line begins, to the place.
static size_t offset_of(const char *text, size_t length, YkPlace place, size_t *start, uint32_t *line)
{
    while (*line < place.line) {
        const char *end = memchr(text + *start, '\n', length - *start);
        if (!end) return length;
        *start = (size_t)(end - text) + 1;
        ++*line;
    }
    size_t at = *start;
    for (uint32_t column = 1; column < place.column && at < length; column++) {
        at++;
        while (at < length && ((unsigned char)text[at] & 0xc0) == 0x80) at++;
    }
    return at;
}

static bool is_blank(char c)
{
    return c == ' ' || c == '\n' || c == '\r';
}

// Returns where a value in quotes ends; 0 if it does not.
static size_t quoted_end(const char *text, size_t length, size_t at)
{
    char quote = text[at++];
    for (; at < length; at++) {
        if (quote == '"' && text[at] == '\\') {
            at++;
        } else if (text[at] == quote) {
            if (quote == '"' || at + 1 == length || text[at + 1] != quote) return at + 1;
            at++;
        }
    }
    return 0;
}

// Returns where the scalar ends that begins at a byte of the source; over several lines a blank stands for each break.
// 0 if it is written in another way (folded by `>`).
static size_t scalar_end(const char *text, size_t length, size_t at, const YkNode *scalar)
{
    if (at < length && (text[at] == '\'' || text[at] == '"')) return quoted_end(text, length, at);
    for (size_t i = 0; i < scalar->length;) {
        if (at < length && text[at] == scalar->text[i]) {
            at++;
            i++;
            continue;
        }
        if (at == length || !is_blank(text[at])) return 0;
        while (at < length && is_blank(text[at])) at++;
        i += scalar->text[i] == ' ';
    }
    return at;
}

// The new value of a name, the last where there are several; NULL: it has none.
static const char *new_value(const YkOverride *values, size_t count, const char *name)
{
    const char *value = NULL;
    for (size_t i = 0; i < count; i++)
        if (strcmp(values[i].name, name) == 0) value = values[i].value;
    return value;
}

// The text with new values of a section in place of the old; false if one of these is not found as it is written.
static bool replace(const YkNode *section, const YkOverride *values, size_t count, const char *source, size_t length,
                    YkText *text)
{
    size_t done = 0, start = 0;
    uint32_t line = 1;
    for (size_t i = 0; section && i < section->count; i++) {
        const YkNode *old = section->pairs[i].value;
        const char *value = new_value(values, count, section->pairs[i].key->text);
        if (!value) continue;
        size_t from = offset_of(source, length, old->place, &start, &line);
        size_t to = scalar_end(source, length, from, old);
        if (to == 0) return false;
        yk_text_add(text, source + done, from - done);
        yk_doc_write_scalar(&(YkNode){.text = value, .length = strlen(value), .quoted = true}, text);
        done = to;
    }
    yk_text_add(text, source + done, length - done);
    return true;
}

bool yk_source_replace(const char *source, const char *section, const YkOverride *values, size_t count, YkText *text)
{
    YkArena *arena = yk_arena_new();
    const YkNode *root = arena ? yk_doc_parse(source, strlen(source), "model", arena, NULL) : NULL;
    const YkNode *values_now = root && root->kind == YK_NODE_MAP ? yk_node_get(root, section) : NULL;
    bool is_map = values_now && values_now->kind == YK_NODE_MAP;
    for (size_t i = 0; is_map && i < values_now->count; i++)
        is_map = values_now->pairs[i].value->kind == YK_NODE_SCALAR;
    bool good = is_map && replace(values_now, values, count, source, strlen(source), text);
    if (!root) text->failed = true; // a model was read from this text
    yk_arena_free(arena);
    return good && !text->failed;
}

// The tree laid out anew, with the new values.
static void lay_out(const YkLoader *loader, YkText *text)
{
    const YkNode *section = yk_node_get(loader->root, "parameters");
    for (size_t i = 0; section && i < section->count; i++) {
        YkNode *scalar = section->pairs[i].value;
        const char *value =
            new_value(loader->options->parameters, loader->options->parameter_count, section->pairs[i].key->text);
        if (!value) continue;
        scalar->text = value; // the caller's: read here and no more
        scalar->length = strlen(value);
    }
    yk_doc_write(loader->root, text);
}

void yk_load_keep_source(YkLoader *loader, const char *source, size_t length)
{
    YkModel *model = loader->model;
    YkText text = {0};
    if (length >= 3 && memcmp(source, "\xef\xbb\xbf", 3) == 0) { // skips a byte order mark
        source += 3;
        length -= 3;
    }
    bool is_changed = loader->options && loader->options->parameter_count > 0;
    if (is_changed && !replace(yk_node_get(loader->root, "parameters"), loader->options->parameters,
                               loader->options->parameter_count, source, length, &text)) {
        yk_text_clear(&text);
        lay_out(loader, &text);
    }
    model->source_length = is_changed ? text.length : length;
    model->source = yk_arena_copy(model->arena, is_changed ? yk_text_get(&text) : source, model->source_length);
    loader->failed |= !model->source;
    yk_text_free(&text);
}

const char *yk_model_text(const YkModel *model)
{
    return model->source;
}
