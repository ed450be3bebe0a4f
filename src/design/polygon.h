// The inside of a polygon.
#ifndef DESIGN_POLYGON_H
#define DESIGN_POLYGON_H
#include <yoke/polygon.h>
#include "base/memory.h"
#include "base/text.h"
#include "model/model.h"

struct YkPolygon {
    YkArena *arena;
    const YkModel *model;
    YkPolygonKind kind;
    YkPolygonVector *vector;
    YkPolygonImage *image;
    size_t vector_count, image_count;
    const char **step;
    size_t step_count;
    YkText svg;
    bool failed; // out of memory
};

// What a step begins with: bodies that follow known ones, or a block that is solved.
typedef struct YkPolygonStep {
    const size_t *body;  // [count]
    size_t count, first; // the first of its vectors
    int block;           // or -1
} YkPolygonStep;

// polygon_text.c: adds the words of a step whose vectors are complete. rate[body]: rad/s or rad/s^2.
void yk_polygon_tell(YkPolygon *polygon, const YkPolygonStep *step, const char *block, const double *rate);

#endif
