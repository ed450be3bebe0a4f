// Shared by dragging with one free input (drag.c) and with several (drag_many.c): the present pose, the stops, a
// walk.
#ifndef SWEEP_DRAG_WALK_H
#define SWEEP_DRAG_WALK_H
#include <yoke/drag.h>
#include "loads/loads.h"
#include "sweep/walk.h"

typedef struct YkDragStop {
    const YkStop *own;
    int32_t coordinate;
    double low, high, scale; // scale: 1 rad, or the machine's size
} YkDragStop;

enum { YK_DRAG_NORMALS = 6 };

struct YkDrag {
    YkState *state;
    YkLoadEnd end;
    YkVec target;
    YkWalk walk;
    YkDragStop *stops;
    size_t stop_count;
    int32_t *active; // inputs that follow
    size_t active_count;
    double *goal;          // [3 * input + k], of a line
    double *home;          // likewise, where a step begins
    double *jx, *jy, *way; // [active], in units of the inputs' scales
    double *normal;        // [YK_DRAG_NORMALS][active] orthonormal: ways that are blocked
    size_t normal_count;
    int block; // that did not close when last looked beside a pose
    void *memory;
};

double yk_drag_distance(const YkDrag *drag);             // of the present pose
double yk_drag_scale(const YkDrag *drag, size_t active); // 1 rad, or the machine's size
void yk_drag_begin_walk(YkDrag *drag);                   // a new walk from where the state stands
void yk_drag_widen_stops(YkDrag *drag); // so that a machine that stands beyond a stop already may stay there
// Returns the stop that is met first after a, of those that the pose at b is beyond, and where; SIZE_MAX: none. The
// path stands at b, or there.
size_t yk_drag_meet_stop(YkDrag *drag, double a, double *b);
// drag_many.c: drags with several free inputs.
void yk_drag_many(YkDrag *drag, YkDragged *dragged);

#endif
