// The inside of YkRegions: a field, the regions of its cells, and their outlines.
#ifndef MAP_REGIONS_H
#define MAP_REGIONS_H
#include <yoke/regions.h>
#include "base/text.h"
#include "map/workspace/field.h"
#include "map/workspace/runs.h"

typedef struct YkBorder {
    double *points; // [count][2]
    size_t count, capacity;
} YkBorder;

typedef struct YkTract { // a region
    YkRegion region;
    size_t cell; // one of its cells
    YkBorder *outlines;
    size_t outline_count, outline_capacity;
    YkRegionBound *bounds;
    size_t bound_capacity;
} YkTract;

struct YkRegions {
    const YkMechanism *mech;
    YkField field;
    size_t coordinate[2];
    double *inputs;
    double start[2]; // within the domain
    YkRuns runs;     // which region a cell is in
    YkTract *parts;
    size_t count, capacity;
    bool is_complete;
    char message[480];
    YkText picture;
};

// Begins a map: its field has no cells yet. Returns NULL with a problem.
YkRegions *yk_regions_begin(const YkState *start, size_t first, size_t second, double tolerance, YkProblems *problems);
// Finds the regions of cells with equal counts, and their outlines (outlines.c). Returns false when out of memory.
bool yk_regions_trace(YkRegions *regions);

#endif
