// Random points that are kept for many comparisons.
#include <stdlib.h>
#include "ring/proof/field.h"

enum { POINTS_MAX = 16 };

struct YkFieldPoints {
    const YkRing *ring;
    uint64_t seed;
    size_t symbols; // of the ring when the points were made
    YkFieldPoint *point[POINTS_MAX];
    bool is_tried[POINTS_MAX];
};

YkFieldPoints *yk_field_points_new(const YkRing *ring, uint64_t seed)
{
    YkFieldPoints *points = calloc(1, sizeof *points);
    if (points) points->ring = ring, points->seed = seed;
    return points;
}

static void forget(YkFieldPoints *points)
{
    for (size_t k = 0; k < POINTS_MAX; k++) {
        yk_field_point_free(points->point[k]);
        points->point[k] = NULL;
        points->is_tried[k] = false;
    }
}

void yk_field_points_free(YkFieldPoints *points)
{
    if (!points) return;
    forget(points);
    free(points);
}

const YkFieldPoint *yk_field_points_get(YkFieldPoints *points, size_t index)
{
    if (!points || index >= POINTS_MAX) return NULL;
    if (points->symbols != yk_ring_symbol_count(points->ring)) forget(points);
    points->symbols = yk_ring_symbol_count(points->ring);
    if (!points->is_tried[index])
        points->point[index] = yk_field_point_new(points->ring, points->seed + index * 0x632be59bd9b4e019u);
    points->is_tried[index] = true;
    return points->point[index];
}
