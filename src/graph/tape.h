// A tape: a graph as a list of operations on rows of numbers. A row holds one value, and a lane of it one pose.
//
// Values that depend on parameters alone are computed once for a set of parameters; all others for every pose. The
// operations are those of the graph, in its order and without fused rounding: a lane has the same bits alone and among
// others.
#ifndef GRAPH_TAPE_H
#define GRAPH_TAPE_H
#include "graph/graph.h"

typedef struct YkTape YkTape;

// The meaning of the graph's calls of laws: result = value, first and second derivative.
typedef struct YkTapeLaws {
    const void *context;
    void (*evaluate)(const void *context, int32_t law, double argument, double result[3]);
} YkTapeLaws;

// Makes a tape that computes the roots in blocks of at most `lanes` poses. leaves[k]: the leaves that will be given
// values; every leaf that the roots depend on must be among them. Returns NULL when out of memory, or if the
// graph contains calls of groups, which a tape cannot run. The graph gets some more numbers; it is not needed
// afterwards.
YkTape *yk_tape_new(YkGraph *graph, const YkRef *leaves, size_t leaf_count, const YkRef *roots, size_t root_count,
                    size_t lanes, YkTapeLaws laws);
void yk_tape_free(YkTape *tape);
size_t yk_tape_length(const YkTape *tape); // operations a pose

// Returns whether the roots depend on a leaf.
bool yk_tape_needs(const YkTape *tape, size_t leaf);
// Returns whether a root is one of those that decide whether all are finite: all are if these are.
bool yk_tape_tells(const YkTape *tape, size_t root); // with the present parameters
// Gives a leaf of a pose its lanes, which must stay until the tape has run.
void yk_tape_set_lanes(YkTape *tape, size_t leaf, const double *lanes);
// Gives a leaf the lanes which[0 .. n) of these, one after the other; they are copied.
void yk_tape_pack_lanes(YkTape *tape, size_t leaf, const double *lanes, const size_t *which, size_t n);
// Gives a leaf the same value in all lanes. After parameters, call yk_tape_prepare.
void yk_tape_set(YkTape *tape, size_t leaf, double value);
// Computes the values that depend on parameters alone.
void yk_tape_prepare(YkTape *tape);
// Computes out[root][0 .. n) for the first n lanes. The rows of roots and leaves must not overlap. Allocates nothing.
void yk_tape_run(YkTape *tape, double *const *out, size_t n);

// One lane runs from numbers instead of rows, with the same bits. Returns where the number of a leaf stands, to be
// written before each run; NULL if the lanes of a pose do not depend on it.
double *yk_tape_leaf_of_one(YkTape *tape, size_t leaf);
// Makes a leaf one of the numbers of a pose: it is read from there when the tape runs from a pose.
void yk_tape_read_number(YkTape *tape, size_t leaf, size_t number);
// Computes the roots, from the numbers of a pose or, if NULL, from the leaves' own alone. Returns where the roots'
// numbers stand until the next run: *result[root].
const double *const *yk_tape_run_one(YkTape *tape, const double *pose);

#endif
