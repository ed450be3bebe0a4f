// Finds repeated keys of a map.
#include <string.h>
#include "base/names.h"
#include "doc/reader.h"

enum { FEW = 8 }; // fewer keys than this are compared directly, without a table or an allocation

static bool same(const YkNode *a, const YkNode *b)
{
    return a->kind == YK_NODE_SCALAR && b->kind == YK_NODE_SCALAR && a->length == b->length &&
           memcmp(a->text, b->text, a->length) == 0;
}

static void report(const YkNode *key, const YkNode *first, YkProblems *problems)
{
    yk_problem(problems, YK_CODE_YAML_DUPLICATE_KEY, key->place, "the key %q appears twice in the same map", key->text);
    yk_problem_hint(problems, "it first appears on line %u, column %u", (unsigned)first->place.line,
                    (unsigned)first->place.column);
}

static bool check_few(const YkNode *map, YkProblems *problems)
{
    bool fine = true;
    for (size_t i = 1; i < map->count; i++)
        for (size_t k = 0; k < i; k++)
            if (same(map->pairs[i].key, map->pairs[k].key)) {
                report(map->pairs[i].key, map->pairs[k].key, problems);
                fine = false;
                break;
            }
    return fine;
}

static bool check_many(const YkNode *map, YkProblems *problems)
{
    YkNames names = {0};
    bool fine = true;
    for (size_t i = 0; i < map->count; i++) {
        const YkNode *key = map->pairs[i].key;
        int32_t first;
        if (key->kind != YK_NODE_SCALAR) continue;
        bool added = yk_names_add(&names, key->text, (int32_t)i, &first);
        if (!added) yk_problem(problems, YK_CODE_OUT_OF_MEMORY, key->place, "out of memory");
        if (added && first != YK_NONE) report(key, map->pairs[first].key, problems);
        fine = fine && added && first == YK_NONE;
        if (!added) break;
    }
    yk_names_free(&names);
    return fine;
}

bool yk_doc_check_keys(const YkNode *map, YkProblems *problems)
{
    return map->count <= FEW ? check_few(map, problems) : check_many(map, problems);
}
