// The space in which steps run: lanes of orientations, distances, nodes and scratch, one lane for each pose, in one
// allocation.
#ifndef SOLVE_SPACE_H
#define SOLVE_SPACE_H
#include "compile/mechanism.h"
#include "solve/kernels/kernels.h"

typedef struct YkSpace {
    double *data;            // 64-byte aligned: orientations,
    double *slides, *planes; // then distances, then nodes and scratch
    double *margin;          // least sin^2 over the blocks: negative if something does not close
    double *gap;             // largest gap of redundant loops, m
    double *block_margin;    // [block][lane], or NULL
    double *gain;            // [relation][lane]: derivative of its target by its law's argument
    // Pointers to the lanes, made once: making them anew for every call costs more than the arithmetic of one pose.
    YkTurn *turn;   // [slot]
    YkSlide *slide; // [distance]
    YkPlane *plane; // [1 + node], then scratch; 0 is absent
    void *memory;
    size_t stride; // number of lanes it has room for
    // The same in all spaces of a mechanism:
    size_t slots, distances, nodes, blocks, relations;
} YkSpace;

// with_margins: keeps every block's own margin.
bool yk_space_start(YkSpace *space, const YkMechanism *mech, size_t stride, bool with_margins);
void yk_space_end(YkSpace *space);
size_t yk_space_number_count(const YkSpace *space); // of its data
void yk_space_copy(YkSpace *to, const YkSpace *from);

// Slot 0 and node YK_NONE have no lanes.
static inline YkTurn yk_space_turn(const YkSpace *space, int32_t slot)
{
    return space->turn[slot];
}
static inline YkSlide yk_space_slide(const YkSpace *space, int32_t distance)
{
    return space->slide[distance];
}
// Returns nodes, then three planes of scratch (YK_SCRATCH_KNOWN, ...).
static inline YkPlane yk_space_plane(const YkSpace *space, int32_t node)
{
    return space->plane[node == YK_NONE ? 0 : node + 1];
}
enum { YK_SCRATCH_KNOWN, YK_SCRATCH_ARM_1, YK_SCRATCH_ARM_2, YK_SCRATCH_COUNT };
static inline YkPlane yk_space_scratch(const YkSpace *space, int which)
{
    return yk_space_plane(space, (int32_t)space->nodes + which);
}

#endif
