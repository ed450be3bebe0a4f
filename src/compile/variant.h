// The inside of YkVariant.
#ifndef COMPILE_VARIANT_H
#define COMPILE_VARIANT_H
#include <yoke/variant.h>
#include "compile/mechanism.h"
#include "compile/recipe.h"

typedef struct YkPatch { // a vector of the mechanism, and the node it comes from
    YkVec *at;
    int32_t node;
} YkPatch;

struct YkVariant {
    YkRedesign *redesign;
    YkMechanism *mech;
    YkRecipe recipe;
    int32_t *active; // nodes that vary, in order
    size_t active_count;
    YkPatch *patches;
    size_t patch_count, patch_capacity;
    bool failed;
};

// Compiles with a recipe (NULL: without).
YkMechanism *yk_compile_with(const YkModel *model, const YkCompileOptions *options, YkRecipe *recipe,
                             YkProblems *problems);

#endif
