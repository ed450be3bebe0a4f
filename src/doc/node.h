// The document: a tree of nodes that know their place in the source, whatever front end reads it.
#ifndef DOC_NODE_H
#define DOC_NODE_H
#include <stdbool.h>
#include <stddef.h>
#include <yoke/problem.h>
#include "base/memory.h"
#include "base/text.h"

typedef enum YkNodeKind { YK_NODE_SCALAR, YK_NODE_LIST, YK_NODE_MAP } YkNodeKind;

typedef struct YkNode YkNode;
typedef struct YkNodePair {
    YkNode *key, *value;
} YkNodePair; // key is a scalar

struct YkNode {
    YkNodeKind kind;
    bool quoted; // a scalar in quotes
    YkPlace place;
    const char *text; // scalar: its text, NUL-terminated, valid UTF-8, no control characters
    size_t length;
    size_t count; // list: items; map: pairs (in file order, keys unique)
    YkNode **items;
    YkNodePair *pairs;
};

const YkNode *yk_node_get(const YkNode *map, const char *key); // NULL if there is none (or map is not a map)
const char *yk_node_kind_name(const YkNode *node);             // "a value", "a list", "a map"

enum { YK_DOC_DEPTH_MAX = 64 };
#define YK_DOC_SIZE_MAX ((size_t)256 << 20)

// Reads YAML text into a tree in `arena` (front end: libyaml's event interface). Refuses what a model file does not
// need: anchors, aliases, tags, merge keys, tabs in indentation, several documents, depth over YK_DOC_DEPTH_MAX,
// repeated keys, bad UTF-8, control characters, NUL. Sets the source of `problems`. Returns NULL if there was an error.
YkNode *yk_doc_parse(const char *text, size_t length, const char *name, YkArena *arena, YkProblems *problems);
// Adds the tree to the text as YAML that reads back as the same tree (places aside). Comments are not in the tree.
void yk_doc_write(const YkNode *root, YkText *text);
void yk_doc_write_scalar(const YkNode *scalar, YkText *text); // in quotes where it needs them, in braces too
// Reads a whole file ("-": standard input) into malloc'd memory. Refuses more than YK_DOC_SIZE_MAX without reading it
// all (directories, endless pipes, ...). Returns NULL and adds a problem if it cannot.
char *yk_doc_read_file(const char *path, size_t *length, YkProblems *problems);

#endif
