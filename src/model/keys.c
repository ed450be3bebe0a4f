// Reads sections of the file and checks their keys.
#include <string.h>
#include "model/load.h"

const YkNode *yk_load_section(YkLoader *loader, const char *key)
{
    const YkNode *node = yk_node_get(loader->root, key);
    if (yk_load_is_empty(node)) return NULL;
    YkSubject subject = {.noun = "section", .part = key};
    if (!yk_load_expect(loader, node, YK_NODE_MAP, &subject)) return NULL;
    return yk_load_count_fits(loader, node, node->count, key) ? node : NULL;
}

static bool is_among(const char *key, const char *const *keys)
{
    for (size_t i = 0; keys[i]; i++) {
        if (strcmp(keys[i], key) == 0) return true;
    }
    return false;
}

void yk_load_check_keys(YkLoader *loader, const YkNode *map, const char *const *keys, const YkSubject *subject)
{
    for (size_t i = 0; i < map->count; i++) {
        const YkNode *key = map->pairs[i].key;
        if (is_among(key->text, keys)) continue;
        yk_problem(loader->problems, YK_CODE_UNKNOWN_KEY, key->place, "%s has no key %q",
                   yk_load_subject(loader, subject), key->text);
        yk_load_hint_nearest_key(loader, key->text, keys);
    }
}

const YkNode *yk_load_key(const YkNode *map, const char *key)
{
    for (size_t i = 0; i < map->count; i++) {
        if (strcmp(map->pairs[i].key->text, key) == 0) return map->pairs[i].key;
    }
    return NULL;
}

bool yk_load_count_fits(YkLoader *loader, const YkNode *section, size_t count, const char *noun)
{
    if (count <= YK_COUNT_MAX) return true;
    yk_problem(loader->problems, YK_CODE_TOO_MANY, section->place, "%z %s are more than a model can have (%d)", count,
               noun, (int)YK_COUNT_MAX);
    return false;
}

const YkNode *yk_load_require(YkLoader *loader, const YkNode *map, const char *key, const YkSubject *subject)
{
    const YkNode *node = yk_node_get(map, key);
    if (!node) {
        yk_problem(loader->problems, YK_CODE_MISSING_KEY, map->place, "%s needs `%s`", yk_load_subject(loader, subject),
                   key);
    }
    return node;
}
