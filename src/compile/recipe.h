// The recipe: how the numbers of a mechanism - the vectors of its sums - follow from points and directions of its
// model. It is kept only for variants (variant.h): every vector is then a node in a list of additions, which is
// repeated for other values. The same additions in the same order give the same bits as compiling anew.
#ifndef COMPILE_RECIPE_H
#define COMPILE_RECIPE_H
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <yoke/mechanism.h>
#include "base/vec.h"
#include "model/redesign.h"

typedef enum YkRecipeKind {
    YK_RECIPE_FIXED,
    YK_RECIPE_POINT,
    YK_RECIPE_ALONG,
    YK_RECIPE_NEGATE,
    YK_RECIPE_ADD
} YkRecipeKind;

typedef struct YkRecipeNode {
    YkRecipeKind kind;
    int32_t a, b; // POINT: joint and its side; ALONG: joint; otherwise nodes before this one
    bool varies;
    YkVec value;
} YkRecipeNode;

typedef struct YkRecipeLine { // the direction of a block's line
    int32_t block, line, node;
} YkRecipeLine;

typedef struct YkRecipe {
    const YkRedesign *redesign;
    YkRecipeNode *nodes; // [0]: the vector 0
    size_t node_count, node_capacity;
    int32_t *of_term; // node of mech->terms[k].v
    size_t term_count, term_capacity;
    int32_t *of_constant; // node of the constant of the sum whose first term is k
    size_t constant_count, constant_capacity;
    YkRecipeLine *lines;
    size_t line_count, line_capacity;
    bool failed; // out of memory
} YkRecipe;

bool yk_recipe_start(YkRecipe *recipe, const YkRedesign *redesign);
void yk_recipe_end(YkRecipe *recipe);
// Return nodes; with recipe NULL they return 0 and keep nothing. value: the vector's present value in the mechanism.
int32_t yk_recipe_leaf(YkRecipe *recipe, YkRecipeKind kind, int32_t joint, int side, YkVec value);
int32_t yk_recipe_negate(YkRecipe *recipe, int32_t node, YkVec value);
int32_t yk_recipe_add(YkRecipe *recipe, int32_t a, int32_t b, YkVec value);
void yk_recipe_note_term(YkRecipe *recipe, size_t term, int32_t node);
void yk_recipe_note_constant(YkRecipe *recipe, size_t first, int32_t node);
// Returns the node of the constant of a stored sum. A sum that is only a node (first 0, has_plus) has constant 0.
static inline int32_t yk_recipe_constant(const YkRecipe *recipe, uint32_t first, bool has_plus)
{
    if (!recipe || (first == 0 && has_plus) || first >= recipe->constant_count) return 0; // missing: out of memory
    return recipe->of_constant[first];
}
void yk_recipe_note_line(YkRecipe *recipe, int32_t block, int32_t line, int32_t node);
// compile.c: compiles a machine and writes its recipe (NULL: none).
YkMechanism *yk_compile_with(const YkModel *model, const YkCompileOptions *options, YkRecipe *recipe,
                             YkProblems *problems);

#endif
