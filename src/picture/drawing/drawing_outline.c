// Finds the outline of a body: the convex hull of its points, by Andrew's monotone chain (Andrew 1979).
#include "picture/drawing/drawing.h"
#include <stdlib.h>

// A point that may become part of an outline.
typedef struct Spot {
    size_t body;
    YkVec at;
} Spot;

static int compare(const void *left, const void *right)
{
    const Spot *a = left, *b = right;
    if (a->body != b->body) return a->body < b->body ? -1 : 1;
    if (a->at.x != b->at.x) return a->at.x < b->at.x ? -1 : 1;
    return a->at.y < b->at.y ? -1 : a->at.y > b->at.y;
}

// Collects all points of all bodies: named ones, and the places that joints use. The ground has no outline.
static size_t gather(const YkModel *model, Spot *spots)
{
    size_t count = 0;
    for (size_t i = 0; i < model->point_count; i++)
        if (model->points[i].body > 0) spots[count++] = (Spot){(size_t)model->points[i].body, model->points[i].at};
    for (size_t j = 0; j < model->joint_count; j++)
        for (int side = 0; side < 2; side++)
            if (model->joints[j].body[side] > 0 && !yk_drawing_omits(model, &model->joints[j]))
                spots[count++] = (Spot){(size_t)model->joints[j].body[side], model->joints[j].at[side]};
    return count;
}

// Returns whether the chain turns left at its last corner towards `next`. Nearly straight counts as straight.
static bool turns_left(const YkVec *corner, YkVec next, double tolerance)
{
    YkVec before = yk_sub(corner[-1], corner[-2]), after = yk_sub(next, corner[-1]);
    return yk_cross(before, after) > tolerance * yk_norm(before) * yk_norm(after);
}

// Walks the sorted spots in both directions; returns the number of corners.
static size_t hull(const Spot *spots, size_t count, YkVec *corners)
{
    const double tolerance = 1e-9;
    size_t n = 0;
    for (size_t i = 0; i < count; i++) {
        while (n >= 2 && !turns_left(corners + n, spots[i].at, tolerance)) n--;
        corners[n++] = spots[i].at;
    }
    size_t lower = n;
    for (size_t i = count > 0 ? count - 1 : 0; i-- > 0;) {
        while (n > lower && !turns_left(corners + n, spots[i].at, tolerance)) n--;
        corners[n++] = spots[i].at;
    }
    return count > 1 ? n - 1 : n;
}

// Drops repeats from the sorted spots.
static size_t unique(Spot *spots, size_t count)
{
    size_t kept = 0;
    for (size_t i = 0; i < count; i++)
        if (kept == 0 || compare(&spots[kept - 1], &spots[i]) != 0) spots[kept++] = spots[i];
    return kept;
}

bool yk_drawing_outline(YkDrawing *drawing)
{
    const YkModel *model = drawing->model;
    size_t most = model->point_count + 2 * model->joint_count;
    Spot *spots = calloc(most + 1, sizeof *spots);
    drawing->outlines = calloc(model->body_count + 1, sizeof *drawing->outlines);
    drawing->corners = calloc(2 * most + 2, sizeof *drawing->corners);
    bool good = spots && drawing->outlines && drawing->corners;
    if (good) {
        size_t count = gather(model, spots);
        qsort(spots, count, sizeof *spots, compare);
        count = unique(spots, count);
        for (size_t i = 0, end; i < count; i = end) {
            for (end = i; end < count && spots[end].body == spots[i].body;) end++;
            YkOutline *outline = &drawing->outlines[spots[i].body];
            outline->first = drawing->corner_count;
            outline->count = hull(spots + i, end - i, drawing->corners + drawing->corner_count);
            drawing->corner_count += outline->count;
        }
    }
    free(spots);
    return good;
}

YkVec yk_drawing_middle(const YkDrawing *drawing, const YkFrame *frames, size_t body)
{
    YkOutline outline = drawing->outlines[body];
    YkVec sum = {0, 0};
    for (size_t i = 0; i < outline.count; i++) sum = yk_add(sum, drawing->corners[outline.first + i]);
    if (outline.count > 0) sum = yk_scale(1 / (double)outline.count, sum);
    return yk_frame_apply(frames[body], sum);
}
