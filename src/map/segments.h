// Segments: intervals of the input over which all complex solutions of a block were followed, with the real ones kept.
#ifndef MAP_SEGMENTS_H
#define MAP_SEGMENTS_H
#include "map/strand.h"

typedef struct YkSegment {
    double from, to;
    bool is_far[2];  // whether what ends it there is a solution on its way to infinity
    YkStrand **real; // NULL if one was joined to a strand of the segment before
    size_t count, capacity;
} YkSegment;

typedef struct YkSegments { // ascending
    YkSegment *items;
    size_t count, capacity;
} YkSegments;

// The ends that meet in one zone (meeting.c).
enum { YK_MEETING_MAX = 128 };
typedef struct YkMeeting {
    YkStrand *strand[YK_MEETING_MAX];
    int end[YK_MEETING_MAX]; // 1: it ends here, 0: it begins here
    size_t count;
    double from, to; // the zone
} YkMeeting;
void yk_trace_meet(YkTracer *tracer, YkMeeting *meeting, YkStrand *strand, int end);
void yk_trace_tie_all(YkTracer *tracer, const YkMeeting *meeting);

// Covers the interval of a strand with segments, up to zones of YK_TRACE_ZONE in which solutions meet.
void yk_segments_find(YkTracer *tracer, YkStrand *below, YkSegments *out);
void yk_segments_free(YkSegments *segments); // and the strands that are still theirs

#endif
