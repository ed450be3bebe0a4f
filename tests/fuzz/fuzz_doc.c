// Any bytes as a document: a tree or problems, and either of them well formed.
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include "doc/node.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

static void demand(bool condition)
{
    if (!condition) abort();
}

// Every node is what node.h promises. Depth is limited by the reader.
static void check_node(const YkNode *node)
{
    demand(node != NULL && node->place.line > 0 && node->place.column > 0);
    if (node->kind == YK_NODE_SCALAR) demand(node->text && strlen(node->text) == node->length);
    for (size_t i = 0; node->kind == YK_NODE_LIST && i < node->count; i++) check_node(node->items[i]);
    for (size_t i = 0; node->kind == YK_NODE_MAP && i < node->count; i++) {
        demand(node->pairs[i].key->kind == YK_NODE_SCALAR && node->pairs[i].key->length > 0);
        check_node(node->pairs[i].key);
        check_node(node->pairs[i].value);
        demand(yk_node_get(node, node->pairs[i].key->text) == node->pairs[i].value); // keys are unique
    }
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    YkArena *arena = yk_arena_new();
    YkProblems *problems = yk_problems_new();
    const YkNode *root = arena && problems ? yk_doc_parse((const char *)data, size, "fuzz", arena, problems) : NULL;
    if (problems) demand((root == NULL) == (yk_problems_error_count(problems) > 0));
    if (root) check_node(root);
    if (problems) demand(yk_problems_text(problems, 1) != NULL);
    yk_problems_free(problems);
    yk_arena_free(arena);
    return 0;
}
