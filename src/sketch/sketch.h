// The sketch's inside.
#ifndef SKETCH_SKETCH_H
#define SKETCH_SKETCH_H
#include <yoke/sketch.h>
#include "base/text.h"
#include "compile/mechanism.h"
#include "model/model.h"

struct YkSketch {
    YkModel *model;
    YkMechanism *mech;
    YkLack *lacks;
    size_t lack_count, lack_capacity;
    YkArena *arena; // texts of lacks
    YkText text;    // scratch
    int32_t *group; // per body: the first body of its group; 0: connected to the ground
    bool failed;    // out of memory
};

// Finds what is missing. Sets sketch->failed when out of memory.
void yk_sketch_find_lacks(YkSketch *sketch);
void yk_sketch_find_connections(YkSketch *sketch);
void yk_sketch_find_ends(YkSketch *sketch);

// Adds a lack of this kind without texts; NULL when out of memory. The pointer is valid until the next.
YkLack *yk_sketch_add(YkSketch *sketch, YkLackKind kind);
// A text made as yk_text_format makes it, in the sketch's arena.
const char *yk_sketch_words(YkSketch *sketch, const char *format, ...);

#endif
