// A field: the plane of two inputs as a grid of cells, with the number of configurations in each.
#ifndef MAP_FIELD_H
#define MAP_FIELD_H
#include "map/box.h"

// Which of its sides a cell's crossing is kept for: with its right and with its upper neighbour.
enum { YK_CELL_PROVED = 1, YK_CELL_LOST = 2, YK_CELL_NEAR = 4 };

typedef struct YkCrossing { // where the number changes between two cells' centres
    float part;             // of the way from the first to the second; negative: not yet looked for
    int16_t piece;          // the one whose configurations meet there
} YkCrossing;

typedef struct YkField {
    YkTracer tracer;
    bool is_angle[2];
    double low[2], high[2], step[2];
    size_t n;                 // cells a side, a power of two
    uint16_t *count;          // [n][n], the first input fastest: configurations at the centre
    unsigned char *state;     // [n][n]: PROVED (of the whole cell), LOST (not even at its centre), NEAR (a curve)
    YkCrossing *crossings[2]; // [n][n] each
    size_t proved, lost;      // cells
} YkField;

static inline double yk_field_center(const YkField *f, int axis, size_t index)
{
    return f->low[axis] + ((double)index + 0.5) * f->step[axis];
}

// Fills the field: tracer and is_angle are set. Distances are mapped over what the machine can reach. Returns false
// when out of memory or stopped.
bool yk_field_fill(YkField *field, double tolerance);
void yk_field_end(YkField *field); // with its tracer
// Finds where the number changes between the centres of a cell and its right (axis 0) or upper (axis 1) neighbour.
const YkCrossing *yk_field_crossing(YkField *field, size_t x, size_t y, int axis);
// Returns a cell that is not proved and has none of the curves near it, as an index; n * n if there is none. Crossings
// must all have been found.
size_t yk_field_stray(YkField *field);

#endif
