// The inside of force polygons.
#ifndef DESIGN_FORCE_POLYGON_H
#define DESIGN_FORCE_POLYGON_H
#include <yoke/force_polygon.h>
#include "base/memory.h"
#include "base/text.h"
#include "model/model.h"

struct YkForcePolygons {
    YkArena *arena;
    const YkModel *model;
    YkForceVector *vector;
    size_t vector_count;
    const char **step;
    size_t step_count;
    double size, largest; // of the machine, m; of all forces, N
    YkText svg;
    bool failed; // out of memory
};

// force_polygon_text.c: adds the words of a body whose vectors begin at `first` and are complete.
void yk_force_polygon_tell(YkForcePolygons *polygons, size_t first);

#endif
