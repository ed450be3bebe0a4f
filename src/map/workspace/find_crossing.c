// Finds where a curve crosses the way between the centres of two cells.
#include <string.h>
#include "map/workspace/field.h"

enum { SEARCHES = 24 };

int yk_field_count_at(YkField *f, double x, double y, int *counts)
{
    double at[2] = {x, y};
    return yk_box_count(&f->tracer, at, at, counts);
}

static int16_t first_difference(const YkField *f, const int *a, const int *b)
{
    for (size_t level = 1; level <= f->tracer.piece_count; level++)
        if (a[level] != b[level]) return (int16_t)(level - 1);
    return 0;
}

// Bisects the way from a cell's centre to its neighbour's.
YkCrossing yk_field_find_crossing(YkField *f, size_t x, size_t y, int axis)
{
    double at[2] = {yk_field_center(f, 0, x), yk_field_center(f, 1, y)}, from = 0, to = 1;
    int own[2][YK_BOX_LEVELS] = {{0}}, middle[YK_BOX_LEVELS] = {0};
    int first = yk_field_count_at(f, at[0], at[1], own[0]);
    int second =
        yk_field_count_at(f, at[0] + (axis == 0 ? f->step[0] : 0), at[1] + (axis == 1 ? f->step[1] : 0), own[1]);
    for (int k = 0; k < SEARCHES && first >= 0 && second >= 0 && first != second; k++) {
        double half = 0.5 * (from + to);
        int count = yk_field_count_at(f, at[0] + (axis == 0 ? half * f->step[0] : 0),
                                      at[1] + (axis == 1 ? half * f->step[1] : 0), middle);
        if (count < 0) break;
        bool is_before = count == first;
        memcpy(own[is_before ? 0 : 1], middle, sizeof middle);
        *(is_before ? &from : &to) = half;
        if (!is_before) second = count;
    }
    int16_t piece = first >= 0 && second >= 0 ? first_difference(f, own[0], own[1]) : 0;
    return (YkCrossing){yk_crossing_key(y * f->n + x, axis), (float)(0.5 * (from + to)), piece};
}
