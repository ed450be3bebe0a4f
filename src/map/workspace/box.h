// Counts the configurations over boxes of two inputs.
#ifndef MAP_BOX_H
#define MAP_BOX_H
#include "map/strand.h"

enum { YK_BOX_UNCLEAR = -1, YK_BOX_LEVELS = 64 };

// Returns how many real configurations the machine has at each pose of a box of the mapped inputs, the same number at
// all of them; YK_BOX_UNCLEAR if that is not proved, which it is not where two of them meet, or when out of memory or
// stopped. low = high: at one pose. counts: [piece_count + 1], or NULL: how many the blocks up to each have together.
// Source of the proof: docs/configurations.md, "Two freedoms".
int yk_box_count(YkTracer *tracer, const double low[2], const double high[2], int *counts);

// Kept by counting from box to box: for every group where its paths begin, and how many solutions it has. A proof
// that only just succeeds or fails may depend on it; with the same memory a box has the same answer.
typedef struct YkBoxMemory {
    YkGeneric generic[YK_BOX_LEVELS];
    size_t expected[YK_BOX_LEVELS];
} YkBoxMemory;
// Notes what is kept now. Returns false when out of memory.
bool yk_box_remember(const YkTracer *tracer, YkBoxMemory *memory);
// Keeps what was noted; and the solutions of a box nearby, [piece_count], from which those of the next are found
// sooner, or none if `near` is NULL. Returns false when out of memory.
bool yk_box_recall(YkTracer *tracer, const YkBoxMemory *memory, const YkGroupSolutions *near);
// Returns the solutions of the last box, [piece_count]; NULL if the machine has no groups, or when out of memory, which
// is noted.
YkGroupSolutions *yk_box_near(YkTracer *tracer);
void yk_box_near_free(YkGroupSolutions *near, size_t piece_count);
void yk_box_memory_end(YkBoxMemory *memory);

// A dyad of two pinned links that are equally long to rounding: where its ends meet it turns freely.
typedef struct YkFold {
    size_t level; // of the piece
    YkVec apart;  // from one end to the other, over the machine's size
} YkFold;
// Finds the dyad of that kind whose ends are nearest to each other at a pose, over all branches of the dyads below.
// Returns false if there is none.
bool yk_box_fold(YkTracer *tracer, const double at[2], YkFold *fold);

// How near two solutions of a dyad are to each other: yk_dyad_gap, at a pose.
typedef struct YkGap {
    size_t level; // of the piece
    double value;
} YkGap;
// Finds the dyad with the smallest gap at a pose, over all branches of the dyads below; dyads whose ends meet do not
// count. Returns false if there is none.
bool yk_box_gap(YkTracer *tracer, const double at[2], YkGap *gap);

#endif
