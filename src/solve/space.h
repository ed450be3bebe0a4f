// The space in which steps run: lanes of orientations, distances, nodes and scratch, one lane a pose, in one allocation.
#ifndef SOLVE_SPACE_H
#define SOLVE_SPACE_H
#include "compile/mechanism.h"
#include "solve/kernels.h"

typedef struct YkSpace {
    size_t stride;          // lanes there is room for
    size_t slots, distances, nodes, blocks;
    double *data;           // 64-byte aligned: orientations,
    double *slides, *planes;// then distances, then nodes and scratch
    double *margin;         // least sin^2 over the blocks: negative where something does not close
    double *gap;            // largest miss of redundant loops, m
    double *block_margin;   // [block][lane], or NULL
    void *memory;
} YkSpace;

// with_margins: keep every block's own margin.
bool yk_space_start(YkSpace *space, const YkMechanism *mech, size_t stride, bool with_margins);
void yk_space_end(YkSpace *space);
void yk_space_copy(YkSpace *to, const YkSpace *from);

static inline YkTurn yk_space_turn(const YkSpace *space, int32_t slot)
{
    size_t n = space->stride;
    double *p = space->data + 4 * n * (size_t)slot;
    return slot == 0 ? (YkTurn){NULL, NULL, NULL, NULL} : (YkTurn){p, p + n, p + 2 * n, p + 3 * n};
}
static inline YkSlide yk_space_slide(const YkSpace *space, int32_t distance)
{
    size_t n = space->stride;
    double *p = space->slides + 3 * n * (size_t)distance;
    return (YkSlide){p, p + n, p + 2 * n};
}
// Nodes, then three planes of scratch (YK_SCRATCH_KNOWN, ...).
static inline YkPlane yk_space_plane(const YkSpace *space, int32_t node)
{
    size_t n = space->stride;
    double *p = space->planes + 6 * n * (size_t)node;
    return node == YK_NONE ? (YkPlane){NULL, NULL, NULL, NULL, NULL, NULL} : (YkPlane){p, p + n, p + 2 * n, p + 3 * n, p + 4 * n, p + 5 * n};
}
enum { YK_SCRATCH_KNOWN, YK_SCRATCH_ARM_1, YK_SCRATCH_ARM_2, YK_SCRATCH_COUNT };
static inline YkPlane yk_space_scratch(const YkSpace *space, int which)
{
    return yk_space_plane(space, (int32_t)space->nodes + which);
}

#endif
