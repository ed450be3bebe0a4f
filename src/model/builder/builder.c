// The builder: from calls to a file's text, and through the loader to a model.
#include <stdlib.h>
#include <string.h>
#include "model/builder/builder.h"
#include "model/model.h"

YkBuilder *yk_builder_new(const char *name)
{
    YkBuilder *builder = calloc(1, sizeof *builder);
    if (!builder) return NULL;
    builder->arena = yk_arena_new();
    builder->problems = yk_problems_new();
    builder->root = builder->arena ? yk_branch_new(builder, YK_NODE_MAP) : NULL;
    if (builder->root && name) yk_branch_put(builder, builder->root, "name", yk_branch_scalar(builder, name));
    if (builder->root && builder->problems && !builder->failed && !yk_arena_failed(builder->arena)) return builder;
    yk_builder_free(builder);
    return NULL;
}

void yk_builder_free(YkBuilder *builder)
{
    if (!builder) return;
    for (YkBranch *branch = builder->branches; branch; branch = branch->next) yk_names_free(&branch->names);
    yk_arena_free(builder->arena);
    yk_problems_free(builder->problems);
    yk_text_free(&builder->text);
    yk_text_free(&builder->scratch);
    free(builder);
}

// The map in which the last name of the path stands, and that name; NULL if a map on the way is missing and `makes`
// is false.
static YkBranch *walk(YkBuilder *builder, const char *path, bool makes, const char **last)
{
    YkBranch *map = builder->root;
    YkText *name = &builder->scratch;
    for (const char *slash; map && (slash = strchr(path, '/')); path = slash + 1) {
        yk_text_clear(name);
        yk_text_add(name, path, (size_t)(slash - path));
        if (name->failed) return NULL;
        map = makes ? yk_branch_map(builder, map, yk_text_get(name)) : yk_branch_get(map, yk_text_get(name));
    }
    *last = path;
    return map;
}

void yk_builder_set(YkBuilder *builder, const char *path, const char *value)
{
    const char *last = path;
    YkBranch *map = walk(builder, path, true, &last);
    YkArena *arena = yk_arena_new();
    YkProblems *found = yk_problems_new();
    const YkNode *node = NULL;
    if (arena && found) {
        node = yk_doc_parse(value, strlen(value), path, arena, found);
        yk_problems_pass_on(builder->problems, found, path);
    } else {
        builder->failed = true;
    }
    if (node && map) yk_branch_put(builder, map, last, yk_branch_copy(builder, node));
    yk_problems_free(found);
    yk_arena_free(arena);
}

void yk_builder_set_number(YkBuilder *builder, const char *path, double value)
{
    const char *last = path;
    YkBranch *map = walk(builder, path, true, &last);
    if (map) yk_branch_put(builder, map, last, yk_branch_number(builder, value));
}

void yk_builder_remove(YkBuilder *builder, const char *path)
{
    const char *last = path;
    YkBranch *map = walk(builder, path, false, &last);
    yk_branch_take_away(builder, map, last);
}

static bool has_failed(const YkBuilder *builder)
{
    return builder->failed || builder->scratch.failed || yk_arena_failed(builder->arena);
}

const char *yk_builder_text(YkBuilder *builder)
{
    if (builder->text.failed)
        yk_text_free(&builder->text);
    else
        yk_text_clear(&builder->text);
    yk_doc_write(&builder->root->node, &builder->text);
    return builder->text.failed || has_failed(builder) ? NULL : yk_text_get(&builder->text);
}

YkModel *yk_builder_model(YkBuilder *builder, const YkLoadOptions *options, YkProblems *problems)
{
    const YkReading how = {.options = options, .name_place = yk_builder_name_place};
    const YkBranch *name = yk_branch_get(builder->root, "name");
    const char *text = yk_builder_text(builder);
    if (!text) {
        yk_problem(problems, YK_CODE_OUT_OF_MEMORY, (YkPlace){0}, "out of memory while building the model");
        return NULL;
    }
    YkModel *model =
        yk_model_read(text, builder->text.length,
                      name && name->node.kind == YK_NODE_SCALAR ? name->node.text : "machine", &how, problems);
    yk_problems_pass_on(problems, builder->problems, NULL);
    if (model && yk_problems_error_count(builder->problems) > 0) {
        yk_model_free(model);
        model = NULL;
    }
    return model;
}
