// The inside of YkLaneForces: shared by the files that make the tape and run it.
#ifndef BATCH_LANE_FORCES_H
#define BATCH_LANE_FORCES_H
#include "batch/forces.h"
#include "graph/tape.h"

typedef enum YkLeafKind {
    YK_LEAF_OF_TURN,       // c, s, w, a of an orientation
    YK_LEAF_OF_SLIDE,      // d, v, a of a distance
    YK_LEAF_OF_NODE,       // x, y, vx, vy, ax, ay
    YK_LEAF_OF_COORDINATE, // position of an angle that is not an input
    YK_LEAF_OF_INPUT,      // position, velocity
    YK_LEAF_OF_GAIN,       // of a relation with a law
    YK_LEAF_OF_TIME,
    YK_LEAF_OF_PARAMETER,
    YK_LEAF_OF_WEIGHT // of a channel in the sum that is differentiated
} YkLeafKind;

typedef struct YkLeafSource { // where the lanes of a leaf lie
    YkLeafKind kind;
    int32_t index, part;
    size_t leaf; // of the tape
    double *one; // its own number in one lane of the tape
} YkLeafSource;

// Makes other values of those of the channels, for the tape to compute; NULL if it cannot.
typedef YkRef *(*YkRootsOf)(YkLaneForces *forces, YkGraph *graph, const YkRef *channel, size_t count);

struct YkLaneForces {
    const YkMechanism *mech;
    const YkVariant *variant;
    YkTape *tape;
    YkLeafSource *sources; // per leaf, while the tape is made
    YkLeafSource *needed;  // of the leaves that the tape reads, those of the space first
    size_t needed_count, in_space;
    YkRef *leaves;
    size_t leaf_count, leaf_capacity;
    bool *needs;        // per coordinate
    YkRootsOf roots_of; // NULL: the tape computes the channels; otherwise what this makes of them,
    size_t by_count;    // so many values
    bool failed;
};

// forces.c: makes them, with a tape of other values unless roots_of is NULL; adds a leaf.
YkLaneForces *yk_lane_forces_make(const YkMechanism *mech, const YkChannel *channels, size_t channel_count,
                                  size_t lanes, YkRootsOf roots_of, bool *fits);
YkRef yk_lane_forces_leaf(YkLaneForces *forces, YkGraph *graph, YkLeafKind kind, size_t index, int32_t part);
// forces_run.c: keeps the sources of the leaves that the tape reads. Returns false when out of memory.
bool yk_lane_forces_keep_needed(YkLaneForces *forces);

#endif
