// The builder's inside: the tree that calls fill, and how they say what is wrong.
#ifndef MODEL_BUILDER_BUILDER_H
#define MODEL_BUILDER_BUILDER_H
#include <yoke/builder.h>
#include "base/memory.h"
#include "base/names.h"
#include "base/problems.h"
#include "base/text.h"
#include "doc/node.h"

// A node that can grow. Maps with many keys find them by a table.
typedef struct YkBranch {
    YkNode node; // first, so that a node of the builder's tree is a branch
    size_t capacity;
    YkNames names; // values: indices of pairs; empty while there are few
    struct YkBranch *next;
} YkBranch;

struct YkBuilder {
    YkArena *arena;
    YkBranch *root, *branches; // branches: all of them, for their tables
    YkProblems *problems;      // of the calls
    YkText text;               // the last yk_builder_text
    YkText scratch;
    bool failed; // out of memory
};

// builder_tree.c. A NULL branch is one for which there was no memory.
YkBranch *yk_branch_new(YkBuilder *builder, YkNodeKind kind);
YkBranch *yk_branch_scalar(YkBuilder *builder, const char *text);
YkBranch *yk_branch_number(YkBuilder *builder, double value); // NULL (reported) if it is not finite
YkBranch *yk_branch_copy(YkBuilder *builder, const YkNode *node);
YkBranch *yk_branch_get(const YkBranch *map, const char *key); // NULL if there is none
void yk_branch_put(YkBuilder *builder, YkBranch *map, const char *key, YkBranch *value);
void yk_branch_add(YkBuilder *builder, YkBranch *list, YkBranch *value);
void yk_branch_take_away(YkBuilder *builder, YkBranch *map, const char *key);
// The map behind a key, made where there is none; another kind of node (a set value) is replaced by a map.
YkBranch *yk_branch_map(YkBuilder *builder, YkBranch *map, const char *key);

// Names what a place in a builder's text is about: "body `crank`, point `A`".
bool yk_builder_name_place(const char *source, size_t length, YkPlace place, YkText *words);

#endif
