// The space of one pose (a stride of 1) as records: what belongs together lies side by side there.
#ifndef SOLVE_POSE_H
#define SOLVE_POSE_H
#include "solve/kernels/lanes.h"
#include "solve/space.h"

typedef struct Slide {
    double d, v, a;
} Slide;

// [slot]; that of the ground stands still.
YK_INLINE Line *pose_turns(const YkSpace *space)
{
    return (Line *)space->data;
}
YK_INLINE Slide *pose_slides(const YkSpace *space) // [distance]
{
    return (Slide *)space->slides;
}
YK_INLINE Known *pose_nodes(const YkSpace *space)
{
    return (Known *)space->planes;
}

#endif
