// The space of one pose (a stride of 1) as records, in which the lanes of one thing are contiguous.
#ifndef SOLVE_POSE_H
#define SOLVE_POSE_H
#include "solve/kernels/lanes.h"
#include "solve/space.h"

typedef struct Slide {
    double d, v, a;
} Slide;

// [slot]; the ground's is at rest.
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
