// A field: the plane of two inputs as a grid of cells, with the number of configurations in each.
#ifndef MAP_FIELD_H
#define MAP_FIELD_H
#include <yoke/regions.h>
#include "map/workspace/box.h"
#include "map/workspace/crossings.h"

// The state of a cell: PROVED (its number, everywhere in it), LOST (not even at its centre), NEAR (a curve). From
// WALKED on, a bit for each of its sides: an outline runs along it.
enum { YK_CELL_PROVED = 1, YK_CELL_LOST = 2, YK_CELL_NEAR = 4, YK_CELL_WALKED = 8 };

// A place about which the number of configurations is the same, but not at it: a dyad turns freely there, so that there
// is a continuum, or two solutions of a dyad touch, and are one.
typedef struct YkFoldPlace {
    double at[2];
    size_t level; // of the piece
    bool is_touch;
} YkFoldPlace;
enum { YK_FOLD_PLACES = 32 };

typedef struct YkTile { // a square of cells
    size_t x, y, size;
    YkGroupSolutions *near; // of groups, with which it begins (box.h)
} YkTile;

typedef struct YkField {
    YkTracer tracer;
    bool is_angle[2];
    double low[2], high[2], step[2];
    size_t n;        // cells a side, a power of two
    uint16_t *count; // [n][n], the first input fastest: configurations at the centre. NULL if tiles are all that is
    unsigned char *state; // [n][n] asked for
    YkCrossings crossings;
    size_t proved, lost; // cells
    YkFoldPlace folds[YK_FOLD_PLACES];
    size_t fold_count;
    size_t boxes_left; // that may still be divided finer than cells
    YkTile *tiles;     // the squares that are not proved as a whole, in the order of dividing (tile.h)
    size_t tile_count, tile_capacity;
    bool has_curves;            // whether tiles find their crossings
    YkBoxMemory first, memory;  // with which each plane begins, and then each tile
    size_t most[YK_BOX_LEVELS]; // of each piece, how many solutions were expected anywhere
    const YkTileSource *source; // of tiles; NULL: they are computed here
    YkStatus status;            // below 0: the source failed
} YkField;

static inline double yk_field_center(const YkField *f, int axis, size_t index)
{
    return f->low[axis] + ((double)index + 0.5) * f->step[axis];
}

static inline bool yk_field_is_over(const YkField *f) // out of memory, stopped, or without tiles
{
    return f->tracer.out_of_memory || f->status < 0 || yk_pace_is_stopped(f->tracer.pace);
}

// Begins a field near a pose whose groups are likely to have as many solutions as anywhere. Returns false when out of
// memory or stopped.
bool yk_field_begin(YkField *field, const double start[2]);
// Sets the plane over which the field goes, n squares a side.
void yk_field_set(YkField *field, const double low[2], const double high[2], size_t n, bool has_curves);
// Fills the field: tracer and is_angle are set. Distances are mapped over what the machine can reach. Returns false
// when out of memory or stopped.
bool yk_field_fill(YkField *field, double tolerance);
void yk_field_end(YkField *field); // with its tracer
// find_crossing.c: counts the configurations at a place, in counts[level] those of each piece. Returns -1 if it cannot.
int yk_field_count_at(YkField *field, double x, double y, int *counts);
// Finds where the number changes between the centres of a cell and its right (axis 0) or upper (axis 1) neighbour.
YkCrossing yk_field_find_crossing(YkField *field, size_t x, size_t y, int axis);
// Does the same, unless it is known; keeps it.
YkCrossing yk_field_crossing(YkField *field, size_t x, size_t y, int axis);
// Returns a cell that is not proved and has none of the curves and of the places of folds near it, as an index; n * n
// if there is none. Crossings must all have been found; folds are found here.
size_t yk_field_stray(YkField *field);

#endif
