// The inside of YkVariant.
#ifndef COMPILE_VARIANT_H
#define COMPILE_VARIANT_H
#include <yoke/variant.h>
#include "compile/mechanism.h"
#include "compile/recipe.h"

typedef struct YkPatch { // a vector of the mechanism, and its node
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
    // Values beside the file's make another machine: it is compiled at the file's own values, and terms that are 0 or
    // cancel there stay so.
    bool is_of_file;
    uint64_t changes; // how often values were set
    bool failed;
};

#endif
