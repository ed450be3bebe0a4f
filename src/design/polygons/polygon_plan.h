// The plan of a velocity or acceleration polygon: which images are joined by which vectors, in the order in which the
// machine is solved. It depends on the machine alone, not on its pose, so that numbers and symbols fill in the same
// one.
#ifndef DESIGN_POLYGON_PLAN_H
#define DESIGN_POLYGON_PLAN_H
#include <yoke/polygon.h>
#include "base/memory.h"
#include "base/text.h"
#include "compile/mechanism.h"

// A place whose velocity or acceleration is drawn: where a joint is, or a point of a body. The place moves with `body`.
typedef struct YkPolygonEnd {
    size_t body, joint; // joint: YK_NOT_FOUND of a point
    size_t point;       // of the model
    const char *image;  // its name: "o" is the pole
} YkPolygonEnd;

// From one place to another of the same turning body; or, at a slide, from a place of one body to that of the other.
typedef struct YkPolygonLink {
    size_t body;  // which turns; of sliding the one that carries the line
    size_t joint; // of sliding; otherwise YK_NOT_FOUND
    YkPolygonEnd from, to;
} YkPolygonLink;

// Bodies that follow known ones, or a block that is solved.
typedef struct YkPolygonStep {
    const size_t *body;  // [count]
    size_t count;        //
    size_t first, links; // the first of its links, and their number
    int block;           // or -1
} YkPolygonStep;

typedef struct YkPolygonPlan {
    const YkMechanism *mech;
    YkPolygonStep *step;
    YkPolygonLink *link;
    YkPolygonEnd *image; // [0]: the pole
    size_t step_count, link_count, image_count;
} YkPolygonPlan;

// Makes the plan in an arena. Returns NULL when out of memory. Cost: O((points + joints)^2).
const YkPolygonPlan *yk_polygon_plan(const YkMechanism *mech, YkArena *arena);
// Returns why nothing can be planned for this machine, or NULL.
const char *yk_polygon_why_not(const YkModel *model);
// Returns the most vectors that it can have.
static inline size_t yk_polygon_most_vectors(const YkPolygonPlan *plan)
{
    return 2 * plan->link_count + 1;
}

// polygon_text.c: the words that numbers and symbols share.
// "rod and piston, which meet at B: the directions are known; closing the polygon gives the sizes, and from them follow
// the rates", or "crank, whose motion is given".
void yk_polygon_tell_step(const YkPolygonPlan *plan, const YkPolygonStep *step, YkPolygonKind kind, YkText *text);
// "perpendicular to the line between these points of rod".
void yk_polygon_tell_direction(YkPolygonPart part, const char *body, YkText *text);

#endif
