// Segments: intervals of the input over which all complex solutions of a block were followed, with the real ones kept.
#ifndef MAP_SEGMENTS_H
#define MAP_SEGMENTS_H
#include "map/strand.h"

typedef struct YkSegment {
    double from, to;
    bool is_far[2];  // whether what ends it there is a solution on its way to infinity
    YkStrand **real; // NULL where one was joined to a strand of the segment before
    size_t count, capacity;
} YkSegment;

typedef struct YkSegments { // ascending
    YkSegment *items;
    size_t count, capacity;
} YkSegments;

// Covers the interval of a strand with segments, up to zones of YK_TRACE_ZONE in which solutions meet.
void yk_segments_find(YkTracer *tracer, YkStrand *below, YkSegments *out);
void yk_segments_free(YkSegments *segments); // and the strands that are still theirs

#endif
