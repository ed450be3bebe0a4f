// The inside of a polygon.
#ifndef DESIGN_POLYGON_H
#define DESIGN_POLYGON_H
#include <yoke/polygon.h>
#include "base/memory.h"
#include "base/text.h"
#include "design/polygons/polygon_plan.h"
#include "model/model.h"
#include "model/shown_unit.h"

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

// Adds a number in the unit in which the quantity is shown: "250 mm/s".
static inline void yk_polygon_number(const YkModel *model, double value, YkQuantity quantity, YkText *text)
{
    double size = 1;
    const char *unit = yk_model_shown_unit(model, quantity, &size);
    yk_text_format(text, "%e %s", value / size, unit);
}
static inline YkQuantity yk_polygon_quantity(const YkPolygon *polygon)
{
    return polygon->kind == YK_POLYGON_VELOCITY ? YK_QUANTITY_SPEED : YK_QUANTITY_ACCELERATION;
}

// polygon_text.c: adds the words of a step, whose vectors from `first` on are complete. rate[body]: rad/s or rad/s^2.
void yk_polygon_tell(YkPolygon *polygon, const YkPolygonPlan *plan, const YkPolygonStep *step, size_t first,
                     const double *rate);

#endif
