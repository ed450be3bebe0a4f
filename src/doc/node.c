// Questions about a node of the tree.
#include "doc/node.h"
#include <string.h>

const YkNode *yk_node_get(const YkNode *map, const char *key)
{
    if (!map || map->kind != YK_NODE_MAP) return NULL;
    for (size_t i = 0; i < map->count; i++)
        if (strcmp(map->pairs[i].key->text, key) == 0) return map->pairs[i].value;
    return NULL;
}

const char *yk_node_kind_name(const YkNode *node)
{
    static const char *const names[] = {"a value", "a list", "a map"};
    return node ? names[node->kind] : "nothing";
}
