// Says in words what a place in a builder's text is about.
#include <string.h>
#include "model/builder/builder.h"

enum { DEPTH_MAX = 8 };

// The name for an entry of each section.
static const char *noun_of(const char *section)
{
    static const char *const nouns[][2] = {{"bodies", "body"},
                                           {"points", "point"},
                                           {"joints", "joint"},
                                           {"parameters", "parameter"},
                                           {"drives", "drive of"},
                                           {"efforts", "effort along"},
                                           {"forces", "force"},
                                           {"springs", "spring"},
                                           {"stops", "stop of"},
                                           {"start", "start of"},
                                           {"gears", "mesh of gears"},
                                           {"racks", "rack"},
                                           {"belts", "belt"},
                                           {"cams", "cam"},
                                           {"laws", "law"},
                                           {"locks", "lock"}};
    for (size_t i = 0; i < sizeof nouns / sizeof *nouns; i++)
        if (strcmp(nouns[i][0], section) == 0) return nouns[i][1];
    return NULL;
}

static bool is_behind(YkPlace a, YkPlace b)
{
    return a.line != b.line ? a.line > b.line : a.column > b.column;
}

// The pair of the map in which the place lies: the last that does not begin behind it.
static const YkNodePair *pair_at(const YkNode *map, YkPlace place)
{
    const YkNodePair *found = NULL;
    for (size_t i = 0; i < map->count; i++) {
        if (is_behind(map->pairs[i].key->place, place)) break;
        found = &map->pairs[i];
    }
    return found;
}

static void add_words(YkText *words, const char *const *path, size_t depth)
{
    for (size_t i = 0; i < depth; i++) {
        const char *noun = i + 1 < depth ? noun_of(path[i]) : NULL;
        if (yk_text_has_some(words)) yk_text_puts(words, ", ");
        if (noun)
            yk_text_format(words, "%s %q", noun, path[++i]);
        else
            yk_text_format(words, "%s", path[i]);
    }
}

bool yk_builder_name_place(const char *source, size_t length, YkPlace place, YkText *words)
{
    const char *path[DEPTH_MAX];
    size_t depth = 0;
    YkArena *arena = yk_arena_new();
    const YkNode *node = arena ? yk_doc_parse(source, length, "", arena, NULL) : NULL;
    while (node && node->kind == YK_NODE_MAP && depth < DEPTH_MAX) {
        const YkNodePair *pair = pair_at(node, place);
        if (!pair) break;
        path[depth++] = pair->key->text;
        node = pair->value;
    }
    add_words(words, path, depth);
    yk_arena_free(arena);
    return depth > 0;
}
