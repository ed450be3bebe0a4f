// Records the recipe of a mechanism while it is compiled.
#include "compile/recipe.h"
#include <stdlib.h>
#include "base/memory.h"

static int32_t append(YkRecipe *recipe, YkRecipeNode node)
{
    if (!YK_ROOM(recipe->nodes, recipe->node_count, recipe->node_capacity)) {
        recipe->failed = true;
        return 0;
    }
    recipe->nodes[recipe->node_count] = node;
    return (int32_t)recipe->node_count++;
}

bool yk_recipe_start(YkRecipe *recipe, const YkRedesign *redesign)
{
    *recipe = (YkRecipe){.redesign = redesign};
    append(recipe, (YkRecipeNode){.kind = YK_RECIPE_FIXED});
    return !recipe->failed;
}

void yk_recipe_end(YkRecipe *recipe)
{
    free(recipe->nodes);
    free(recipe->of_term);
    free(recipe->of_constant);
    free(recipe->lines);
    *recipe = (YkRecipe){0};
}

int32_t yk_recipe_leaf(YkRecipe *recipe, YkRecipeKind kind, int32_t joint, int side, YkVec value)
{
    if (!recipe) return 0;
    const YkModel *model = yk_redesign_model((YkRedesign *)(uintptr_t)recipe->redesign);
    bool varies = kind == YK_RECIPE_ALONG
                      ? yk_redesign_along_varies(recipe->redesign, joint)
                      : yk_redesign_point_varies(recipe->redesign, model->joints[joint].point[side]);
    return append(recipe, (YkRecipeNode){varies ? kind : YK_RECIPE_FIXED, joint, side, varies, value});
}

int32_t yk_recipe_negate(YkRecipe *recipe, int32_t node, YkVec value)
{
    if (!recipe || recipe->failed) return 0;
    bool varies = recipe->nodes[node].varies;
    return append(recipe, (YkRecipeNode){varies ? YK_RECIPE_NEGATE : YK_RECIPE_FIXED, node, 0, varies, value});
}

int32_t yk_recipe_add(YkRecipe *recipe, int32_t a, int32_t b, YkVec value)
{
    if (!recipe || recipe->failed) return 0;
    bool varies = recipe->nodes[a].varies || recipe->nodes[b].varies;
    return append(recipe, (YkRecipeNode){varies ? YK_RECIPE_ADD : YK_RECIPE_FIXED, a, b, varies, value});
}

// Sets items[at] to the node; items between the end and it become 0.
static bool put(YkRecipe *recipe, int32_t **items, size_t *count, size_t *capacity, size_t at, int32_t node)
{
    while (*count <= at) {
        if (!yk_grow((void **)items, *count, capacity, sizeof **items)) {
            recipe->failed = true;
            return false;
        }
        (*items)[(*count)++] = 0;
    }
    (*items)[at] = node;
    return true;
}

void yk_recipe_note_term(YkRecipe *recipe, size_t term, int32_t node)
{
    if (recipe) put(recipe, &recipe->of_term, &recipe->term_count, &recipe->term_capacity, term, node);
}

void yk_recipe_note_constant(YkRecipe *recipe, size_t first, int32_t node)
{
    if (recipe) put(recipe, &recipe->of_constant, &recipe->constant_count, &recipe->constant_capacity, first, node);
}

void yk_recipe_note_line(YkRecipe *recipe, int32_t block, int32_t line, int32_t node)
{
    if (!recipe) return;
    if (!YK_ROOM(recipe->lines, recipe->line_count, recipe->line_capacity)) {
        recipe->failed = true;
        return;
    }
    recipe->lines[recipe->line_count++] = (YkRecipeLine){block, line, node};
}
