// Turns YAML text into a tree of nodes, over libyaml's event interface. Without recursion: open maps and lists are
// frames on a stack of fixed depth. Their children wait on one pile and move to the arena when their parent closes, so
// the cost is linear. Events report their places in code points from 0.
#include <stdlib.h>
#include <string.h>
#include "base/utf8.h"
#include "doc/reader.h"

typedef struct Frame {
    YkNode *node;
    size_t first; // where its children begin on the pile
    yaml_mark_t start;
} Frame;

typedef struct Reader {
    yaml_parser_t parser;
    const char *text;
    size_t length;
    YkArena *arena;
    YkProblems *problems;
    bool failed, stopped; // failed: there was an error; stopped: reading on makes no sense
    Frame frames[YK_DOC_DEPTH_MAX];
    size_t depth;
    YkNode **pile;
    size_t pile_count, pile_capacity;
    YkNode *root;
    YkNode *spare; // nodes and room for text, taken from the arena in blocks
    char *room;
    size_t spare_count, room_size;
    size_t documents;
    size_t line_start, line; // a cursor into the text that only moves forward: the byte where line (from 0) begins
} Reader;

static YkPlace place_of(yaml_mark_t mark)
{
    return (YkPlace){(uint32_t)mark.line + 1, (uint32_t)mark.column + 1, 0};
}

static void complain(Reader *reader, YkCode code, YkPlace place, const char *message, const char *hint)
{
    yk_problem(reader->problems, code, place, "%s", message);
    if (hint) yk_problem_hint(reader->problems, "%s", hint);
    reader->failed = true;
}

static void out_of_memory(Reader *reader, YkPlace place)
{
    complain(reader, YK_CODE_OUT_OF_MEMORY, place, "out of memory", NULL);
    reader->stopped = true;
}

// Returns the number of code points in the given line of the text.
static size_t columns_of_line(Reader *reader, size_t line)
{
    while (reader->line < line) {
        const char *from = reader->text + reader->line_start;
        const char *end = memchr(from, '\n', reader->length - reader->line_start);
        if (!end) return 0;
        reader->line_start = (size_t)(end - reader->text) + 1;
        reader->line++;
    }
    size_t columns = 0;
    for (size_t i = reader->line_start; i < reader->length && reader->text[i] != '\n' && reader->text[i] != '\r'; i++)
        columns += ((unsigned char)reader->text[i] & 0xc0) != 0x80;
    return columns;
}

// Returns the place from start to end; a place of several lines is underlined to the end of its first.
static YkPlace place_between(Reader *reader, yaml_mark_t start, yaml_mark_t end)
{
    YkPlace place = place_of(start);
    size_t stop = end.line == start.line ? end.column : columns_of_line(reader, start.line);
    if (stop > start.column) place.length = (uint32_t)(stop - start.column);
    return place;
}

enum { NODES_AT_ONCE = 256, TEXT_AT_ONCE = 16384 };

static YkNode *new_node(Reader *reader, YkNodeKind kind, YkPlace place)
{
    if (reader->spare_count == 0) {
        reader->spare = YK_NEW(reader->arena, YkNode, NODES_AT_ONCE);
        reader->spare_count = reader->spare ? NODES_AT_ONCE : 0;
    }
    if (!reader->spare) {
        out_of_memory(reader, place);
        return NULL;
    }
    reader->spare_count--;
    YkNode *node = reader->spare++;
    node->kind = kind;
    node->place = place;
    return node;
}

static char *copy_text(Reader *reader, const unsigned char *text, size_t length)
{
    if (length >= TEXT_AT_ONCE / 4) return yk_arena_copy(reader->arena, (const char *)text, length);
    if (length >= reader->room_size) {
        reader->room = yk_arena_alloc(reader->arena, TEXT_AT_ONCE, 1);
        reader->room_size = reader->room ? TEXT_AT_ONCE : 0;
        if (!reader->room) return NULL;
    }
    char *copy = memcpy(reader->room, text, length);
    reader->room += length + 1;
    reader->room_size -= length + 1;
    return copy;
}

static void refuse_anchor_and_tag(Reader *reader, const yaml_event_t *event, const yaml_char_t *anchor,
                                  const yaml_char_t *tag)
{
    YkPlace place = place_of(event->start_mark);
    if (anchor)
        complain(reader, YK_CODE_YAML_ANCHOR, place, "anchors (`&name`) are not used in model files",
                 "write the value out, or make it a parameter");
    if (tag)
        complain(reader, YK_CODE_YAML_TAG, place, "tags (`!name`) are not used in model files",
                 "remove the tag, or put the text in quotes");
}

// Checks that a key is a scalar with some text; `<<` would merge another map.
static void check_key(Reader *reader, const YkNode *key)
{
    if (key->kind != YK_NODE_SCALAR)
        complain(reader, YK_CODE_YAML_KEY_NOT_SCALAR, key->place, "a key cannot be a map or a list",
                 "a key is a plain word; put text with `{` or `[` in quotes");
    else if (key->length == 0)
        complain(reader, YK_CODE_YAML_KEY_EMPTY, key->place, "a key is missing before the `:`", NULL);
    else if (!key->quoted && strcmp(key->text, "<<") == 0)
        complain(reader, YK_CODE_YAML_MERGE, key->place, "merge keys (`<<`) are not used in model files",
                 "write the entries out");
}

// Attaches a finished or just opened node to the innermost open map or list, or makes it the root.
static void attach(Reader *reader, YkNode *node)
{
    if (reader->depth == 0) {
        reader->root = node;
        return;
    }
    const Frame *frame = &reader->frames[reader->depth - 1];
    bool is_key = frame->node->kind == YK_NODE_MAP && (reader->pile_count - frame->first) % 2 == 0;
    if (is_key) check_key(reader, node);
    if (!YK_ROOM(reader->pile, reader->pile_count, reader->pile_capacity)) {
        out_of_memory(reader, node->place);
        return;
    }
    reader->pile[reader->pile_count++] = node;
}

static void check_text(Reader *reader, const YkNode *node)
{
    for (size_t i = 0; i < node->length;) {
        unsigned char c = (unsigned char)node->text[i];
        uint32_t code_point = c;
        size_t bytes = c < 0x80 ? 1 : yk_utf8_decode(node->text + i, node->length - i, &code_point);
        if (bytes == 0 || !yk_doc_is_allowed(code_point)) {
            complain(reader, YK_CODE_YAML_CONTROL, node->place,
                     c == '\n'   ? "a line break inside a value"
                     : c == '\t' ? "a tab inside a value"
                                 : "a control character inside a value",
                     "write the value on one line, with spaces only");
            return;
        }
        i += bytes;
    }
}

static void on_scalar(Reader *reader, const yaml_event_t *event)
{
    refuse_anchor_and_tag(reader, event, event->data.scalar.anchor, event->data.scalar.tag);
    YkNode *node = new_node(reader, YK_NODE_SCALAR, place_between(reader, event->start_mark, event->end_mark));
    if (!node) return;
    char *text = copy_text(reader, event->data.scalar.value, event->data.scalar.length);
    if (!text) {
        out_of_memory(reader, node->place);
        return;
    }
    node->quoted = event->data.scalar.style != YAML_PLAIN_SCALAR_STYLE;
    node->text = text;
    node->length = event->data.scalar.length;
    check_text(reader, node);
    attach(reader, node);
}

// Handles an alias, whose value is not read: a node takes its place so that reading can continue.
static void on_alias(Reader *reader, const yaml_event_t *event)
{
    YkPlace place = place_between(reader, event->start_mark, event->end_mark);
    complain(reader, YK_CODE_YAML_ALIAS, place, "aliases (`*name`) are not used in model files",
             "write the value out, or make it a parameter; a product has its `*` between two factors");
    YkNode *node = new_node(reader, YK_NODE_SCALAR, place);
    if (!node) return;
    node->text = "*";
    node->length = 1;
    attach(reader, node);
}

static void on_open(Reader *reader, const yaml_event_t *event, YkNodeKind kind)
{
    YkPlace place = place_of(event->start_mark);
    if (reader->depth == YK_DOC_DEPTH_MAX) {
        complain(reader, YK_CODE_YAML_DEPTH, place, "maps and lists are nested too deeply",
                 "a model file needs few levels");
        reader->stopped = true;
        return;
    }
    YkNode *node = new_node(reader, kind, place);
    if (!node) return;
    attach(reader, node);
    reader->frames[reader->depth++] = (Frame){node, reader->pile_count, event->start_mark};
}

// Moves the children from the pile to the node.
static bool take_children(Reader *reader, YkNode *node, size_t first)
{
    size_t count = reader->pile_count - first;
    if (count == 0) return true;
    YkNode **children = reader->pile + first;
    reader->pile_count = first;
    if (node->kind == YK_NODE_LIST) {
        node->items = YK_NEW(reader->arena, YkNode *, count);
        if (!node->items) return false;
        memcpy(node->items, children, count * sizeof *children);
        node->count = count;
        return true;
    }
    node->pairs = YK_NEW(reader->arena, YkNodePair, count / 2);
    if (!node->pairs) return false;
    for (size_t i = 0; i < count / 2; i++) node->pairs[i] = (YkNodePair){children[2 * i], children[2 * i + 1]};
    node->count = count / 2;
    return true;
}

static void on_close(Reader *reader, const yaml_event_t *event)
{
    Frame frame = reader->frames[--reader->depth];
    if (!take_children(reader, frame.node, frame.first)) {
        out_of_memory(reader, frame.node->place);
        return;
    }
    if (frame.start.line == event->end_mark.line)
        frame.node->place.length = (uint32_t)(event->end_mark.column - frame.start.column);
    if (!yk_doc_check_commas(frame.node, reader->problems)) {
        reader->failed = true;
        return;
    }
    if (frame.node->kind == YK_NODE_MAP && !yk_doc_check_keys(frame.node, reader->problems)) reader->failed = true;
}

static void on_document(Reader *reader, const yaml_event_t *event)
{
    YkPlace place = place_of(event->start_mark);
    if (event->data.document_start.tag_directives.start != event->data.document_start.tag_directives.end)
        complain(reader, YK_CODE_YAML_TAG, place, "tags are not used in model files",
                 "remove the line that starts with `%`");
    if (++reader->documents < 2) return;
    complain(reader, YK_CODE_YAML_DOCUMENTS, place, "a second document starts here",
             "one file describes one machine: split the file at the line `---`");
    reader->stopped = true;
}

static void on_event(Reader *reader, const yaml_event_t *event)
{
    switch (event->type) {
    case YAML_DOCUMENT_START_EVENT:
        on_document(reader, event);
        break;
    case YAML_ALIAS_EVENT:
        on_alias(reader, event);
        break;
    case YAML_SCALAR_EVENT:
        on_scalar(reader, event);
        break;
    case YAML_SEQUENCE_START_EVENT:
        refuse_anchor_and_tag(reader, event, event->data.sequence_start.anchor, event->data.sequence_start.tag);
        on_open(reader, event, YK_NODE_LIST);
        break;
    case YAML_MAPPING_START_EVENT:
        refuse_anchor_and_tag(reader, event, event->data.mapping_start.anchor, event->data.mapping_start.tag);
        on_open(reader, event, YK_NODE_MAP);
        break;
    case YAML_SEQUENCE_END_EVENT:
    case YAML_MAPPING_END_EVENT:
        on_close(reader, event);
        break;
    default:
        break;
    }
}

enum { EVENT = 1000 }; // work of one

static void read_events(Reader *reader)
{
    for (bool done = false; !done && !reader->stopped && yk_pace_spend(reader->arena->pace, EVENT);) {
        yaml_event_t event;
        if (!yaml_parser_parse(&reader->parser, &event)) {
            yk_doc_yaml_error(&reader->parser, reader->text, reader->length, reader->problems);
            reader->failed = true;
            return;
        }
        done = event.type == YAML_STREAM_END_EVENT;
        on_event(reader, &event);
        yaml_event_delete(&event);
    }
}

// Returns whether there is nothing at all, or only an unquoted scalar without text, as after a lone `---`.
static bool is_empty(const YkNode *root)
{
    return !root || (root->kind == YK_NODE_SCALAR && !root->quoted && root->length == 0);
}

static bool check_input(const char *text, size_t length, YkProblems *problems)
{
    if (length <= YK_DOC_SIZE_MAX) return yk_doc_guard(text, length, problems);
    yk_problem(problems, YK_CODE_FILE_TOO_LARGE, (YkPlace){0, 0, 0}, "the text has more than %z bytes",
               YK_DOC_SIZE_MAX);
    return false;
}

YkNode *yk_doc_parse(const char *text, size_t length, const char *name, YkArena *arena, YkProblems *problems)
{
    if (length >= 3 && memcmp(text, "\xef\xbb\xbf", 3) == 0) { // a byte order mark: no editor counts it as a column
        text += 3;
        length -= 3;
    }
    if (problems) yk_problems_set_source(problems, name, text, length);
    if (!check_input(text, length, problems)) return NULL;
    Reader reader = {.text = text, .length = length, .arena = arena, .problems = problems};
    if (!yaml_parser_initialize(&reader.parser)) {
        out_of_memory(&reader, (YkPlace){0, 0, 0});
        return NULL;
    }
    yaml_parser_set_encoding(&reader.parser, YAML_UTF8_ENCODING);
    yaml_parser_set_input_string(&reader.parser, (const unsigned char *)text, length);
    read_events(&reader);
    reader.failed |= yk_pace_is_stopped(arena->pace); // the caller of the long call says so
    if (!reader.failed && is_empty(reader.root))
        complain(&reader, YK_CODE_YAML_EMPTY, (YkPlace){1, 1, 0}, "the file describes nothing",
                 "start with `bodies:` and `joints:`");
    yaml_parser_delete(&reader.parser);
    free(reader.pile);
    return reader.failed ? NULL : reader.root;
}
