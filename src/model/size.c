// The size of a machine: the largest distance between two points of one body. Found on the convex hull (Andrew 1979)
// with rotating calipers (Shamos 1978), since a frame may have as many points as the machine has links: n log n.
#include <math.h>
#include <stdlib.h>
#include "model/load.h"

static int by_x_then_y(const void *a, const void *b)
{
    const YkVec *p = a, *q = b;
    if (p->x != q->x) return p->x < q->x ? -1 : 1;
    return (p->y > q->y) - (p->y < q->y);
}

static double cross(YkVec o, YkVec a, YkVec b)
{
    return (a.x - o.x) * (b.y - o.y) - (a.y - o.y) * (b.x - o.x);
}

// Adds a point to a chain that turns left; the chain keeps at least `least` points.
static size_t extend(YkVec *hull, size_t count, size_t least, YkVec p)
{
    while (count >= least + 1 && count >= 2 && cross(hull[count - 2], hull[count - 1], p) <= 0) count--;
    hull[count] = p;
    return count + 1;
}

// The hull of sorted points, anticlockwise; hull has room for 2 * count. Returns how many.
static size_t convex_hull(const YkVec *points, size_t count, YkVec *hull)
{
    size_t n = 0;
    for (size_t i = 0; i < count; i++) n = extend(hull, n, 1, points[i]);
    size_t lower = n;
    for (size_t i = count - 1; i-- > 0;) n = extend(hull, n, lower, points[i]);
    return n > 1 ? n - 1 : n; // the last is the first again
}

static double distance(YkVec a, YkVec b)
{
    return hypot(a.x - b.x, a.y - b.y);
}

static double diameter(const YkVec *hull, size_t n)
{
    double largest = 0;
    for (size_t i = 0, j = 1; i < n && n > 1; i++) {
        YkVec a = hull[i], b = hull[(i + 1) % n];
        while (fabs(cross(a, b, hull[(j + 1) % n])) > fabs(cross(a, b, hull[j]))) j = (j + 1) % n;
        largest = fmax(largest, fmax(distance(a, hull[j]), distance(b, hull[j])));
    }
    return largest;
}

static double spread(YkVec *points, size_t count, YkVec *hull)
{
    if (count < 2) return 0;
    if (count == 2) return distance(points[0], points[1]);
    qsort(points, count, sizeof *points, by_x_then_y);
    return diameter(hull, convex_hull(points, count, hull));
}

static double largest_start(const YkModel *model)
{
    double largest = 0;
    for (size_t i = 0; i < model->start_count; i++) {
        const YkStart *start = &model->starts[i];
        if (start->is_rate || !model->coordinates[start->coordinate].is_distance) continue;
        largest = fmax(largest, fabs(start->value));
    }
    return largest;
}

bool yk_load_size(YkModel *model)
{
    YkVec *points = malloc((model->point_count + 1) * 3 * sizeof *points);
    bool *has_origin = calloc(model->body_count, sizeof *has_origin);
    double size = 0;
    for (size_t i = 0; points && has_origin && i < model->joint_count; i++) {
        for (int k = 0; k < 2; k++) {
            if (model->joints[i].point[k] == YK_NONE) has_origin[model->joints[i].body[k]] = true;
        }
    }
    for (size_t i = 0; points && has_origin && i < model->body_count; i++) {
        const YkBody *body = &model->bodies[i];
        size_t count = 0;
        for (int32_t k = 0; k < body->point_count; k++) points[count++] = model->points[body->first_point + k].at;
        if (has_origin[i]) points[count++] = yk_vec(0, 0);
        size = fmax(size, spread(points, count, points + model->point_count + 1));
    }
    size = fmax(size, largest_start(model));
    model->size = size > 0 ? size : 1;
    bool done = points && has_origin;
    free(points);
    free(has_origin);
    return done;
}
