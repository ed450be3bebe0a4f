// The tree that calls fill: maps and lists that grow, in the builder's arena.
#include <math.h>
#include <string.h>
#include "base/number.h"
#include "model/builder/builder.h"

enum { FEW = 16 }; // fewer keys than this are searched without a table

YkBranch *yk_branch_new(YkBuilder *builder, YkNodeKind kind)
{
    YkBranch *branch = YK_NEW(builder->arena, YkBranch, 1);
    if (!branch) return NULL;
    branch->node.kind = kind;
    branch->next = builder->branches;
    builder->branches = branch;
    return branch;
}

// A line break would become a blank on the way through a file; other control characters are refused there.
static bool is_one_line(const char *text)
{
    for (; *text; text++)
        if ((unsigned char)*text < 0x20 || *text == 0x7f) return false;
    return true;
}

YkBranch *yk_branch_scalar(YkBuilder *builder, const char *text)
{
    YkBranch *branch = yk_branch_new(builder, YK_NODE_SCALAR);
    if (!branch) return NULL;
    if (!is_one_line(text))
        yk_problem(builder->problems, YK_CODE_YAML_CONTROL, (YkPlace){0}, "a control character in %q", text);
    branch->node.length = strlen(text);
    branch->node.text = yk_arena_copy(builder->arena, text, branch->node.length);
    return branch->node.text ? branch : NULL;
}

YkBranch *yk_branch_number(YkBuilder *builder, double value)
{
    char digits[YK_NUMBER_SIZE];
    if (!isfinite(value)) {
        yk_problem(builder->problems, YK_CODE_VALUE_RANGE, (YkPlace){0}, "a value is not finite");
        return yk_branch_scalar(builder, "0");
    }
    yk_number_write(value, digits);
    return yk_branch_scalar(builder, digits);
}

static int32_t find(const YkBranch *map, const char *key)
{
    if (map->names.count > 0) return yk_names_find(&map->names, key);
    for (size_t i = 0; i < map->node.count; i++)
        if (strcmp(map->node.pairs[i].key->text, key) == 0) return (int32_t)i;
    return YK_NONE;
}

YkBranch *yk_branch_get(const YkBranch *map, const char *key)
{
    if (!map || map->node.kind != YK_NODE_MAP) return NULL;
    int32_t index = find(map, key);
    return index == YK_NONE ? NULL : (YkBranch *)map->node.pairs[index].value;
}

static void enter_name(YkBuilder *builder, YkBranch *map, size_t index)
{
    int32_t existing;
    builder->failed |= !yk_names_add(&map->names, map->node.pairs[index].key->text, (int32_t)index, &existing);
}

static void enter_names(YkBuilder *builder, YkBranch *map)
{
    size_t count = map->node.count;
    if (count <= FEW) return;
    if (map->names.count > 0)
        enter_name(builder, map, count - 1);
    else
        for (size_t i = 0; i < count; i++) enter_name(builder, map, i);
}

void yk_branch_put(YkBuilder *builder, YkBranch *map, const char *key, YkBranch *value)
{
    if (!map || !value) return;
    int32_t index = find(map, key);
    if (index != YK_NONE) {
        map->node.pairs[index].value = &value->node;
        return;
    }
    YkBranch *name = yk_branch_scalar(builder, key);
    if (!name || !YK_ROOM_IN(builder->arena, map->node.pairs, map->node.count, map->capacity)) return;
    map->node.pairs[map->node.count++] = (YkNodePair){&name->node, &value->node};
    enter_names(builder, map);
}

void yk_branch_add(YkBuilder *builder, YkBranch *list, YkBranch *value)
{
    if (!list || !value || !YK_ROOM_IN(builder->arena, list->node.items, list->node.count, list->capacity)) return;
    list->node.items[list->node.count++] = &value->node;
}

void yk_branch_take_away(YkBuilder *builder, YkBranch *map, const char *key)
{
    int32_t index = map && map->node.kind == YK_NODE_MAP ? find(map, key) : YK_NONE;
    if (index == YK_NONE) return;
    YkNodePair *pairs = map->node.pairs;
    size_t after = map->node.count - 1 - (size_t)index;
    memmove(pairs + index, pairs + index + 1, after * sizeof *pairs);
    map->node.count--;
    yk_names_free(&map->names);
    map->names = (YkNames){0};
    enter_names(builder, map);
}

YkBranch *yk_branch_map(YkBuilder *builder, YkBranch *map, const char *key)
{
    YkBranch *inner = yk_branch_get(map, key);
    if (inner && inner->node.kind == YK_NODE_MAP) return inner;
    inner = map ? yk_branch_new(builder, YK_NODE_MAP) : NULL;
    yk_branch_put(builder, map, key, inner);
    return inner;
}

YkBranch *yk_branch_copy(YkBuilder *builder, const YkNode *node)
{
    YkBranch *branch =
        node->kind == YK_NODE_SCALAR ? yk_branch_scalar(builder, node->text) : yk_branch_new(builder, node->kind);
    if (!branch) return NULL;
    branch->node.quoted = node->quoted;
    for (size_t i = 0; i < node->count; i++) {
        if (node->kind == YK_NODE_MAP)
            yk_branch_put(builder, branch, node->pairs[i].key->text, yk_branch_copy(builder, node->pairs[i].value));
        else
            yk_branch_add(builder, branch, yk_branch_copy(builder, node->items[i]));
    }
    return branch;
}
