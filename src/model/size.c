// Finds the size of a machine: the largest distance between two points of one body. Uses the convex hull (Andrew 1979)
// with rotating calipers (Shamos 1978), since a frame may have as many points as the machine has links: n log n.
#include <math.h>
#include <stdlib.h>
#include "model/size.h"
#include "elementary/elementary.h"
#include "model/load.h"

static bool is_before(YkVec p, YkVec q)
{
    return p.x != q.x ? p.x < q.x : p.y < q.y;
}

static void sink(YkVec *heap, size_t at, size_t count)
{
    YkVec p = heap[at];
    for (size_t child; (child = 2 * at + 1) < count; at = child) {
        if (child + 1 < count && is_before(heap[child], heap[child + 1])) child++;
        if (!is_before(p, heap[child])) break;
        heap[at] = heap[child];
    }
    heap[at] = p;
}

// Sorts by x, then y. Uses a heap in place: qsort may allocate, and variants must not.
static void sort(YkVec *points, size_t count)
{
    for (size_t k = count / 2; k-- > 0;) sink(points, k, count);
    for (size_t k = count; k-- > 1;) {
        YkVec last = points[0];
        points[0] = points[k];
        points[k] = last;
        sink(points, 0, k);
    }
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

// Finds the hull of sorted points, anticlockwise; hull has room for 2 * count. Returns its number of points.
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
    return yk_hypot(a.x - b.x, a.y - b.y);
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

// Compares all pairs, for few points.
static double widest_pair(const YkVec *points, size_t count)
{
    YkVec widest = {0, 0};
    for (size_t i = 1; i < count; i++)
        for (size_t j = 0; j < i; j++) {
            YkVec apart = yk_sub(points[i], points[j]);
            if (yk_dot(apart, apart) > yk_dot(widest, widest)) widest = apart;
        }
    return yk_hypot(widest.x, widest.y);
}

static double spread(YkVec *points, size_t count, YkVec *hull)
{
    enum { FEW = 8 };
    if (count <= FEW) return widest_pair(points, count);
    sort(points, count);
    return diameter(hull, convex_hull(points, count, hull));
}

double yk_size_of_body(const YkModel *model, size_t body, bool has_origin, YkVec *room)
{
    const YkBody *b = &model->bodies[body];
    size_t count = 0;
    for (int32_t k = 0; k < b->point_count; k++) room[count++] = model->points[b->first_point + k].at;
    if (has_origin) room[count++] = yk_vec(0, 0);
    return spread(room, count, room + count);
}

double yk_size_of_start(const YkModel *model)
{
    double largest = 0;
    for (size_t i = 0; i < model->start_count; i++) {
        const YkStart *start = &model->starts[i];
        if (start->is_rate || !model->coordinates[start->coordinate].is_distance) continue;
        largest = fmax(largest, fabs(start->value));
    }
    return largest;
}

double yk_size_of_values(const YkModel *model)
{
    double largest = 0;
    for (size_t i = 0; i < model->parameter_count; i++) {
        const YkParameter *p = &model->parameters[i];
        if (p->dimension.length == 1 && !p->dimension.mass && !p->dimension.time)
            largest = fmax(largest, fabs(p->value));
    }
    for (size_t i = 0; i < model->cam_count; i++) largest = fmax(largest, model->cams[i].base + model->cams[i].roller);
    return largest > 0 ? largest : model->units.length;
}

void yk_size_origins(const YkModel *model, bool *has_origin)
{
    for (size_t i = 0; i < model->joint_count; i++)
        for (int k = 0; k < 2; k++)
            if (model->joints[i].point[k] == YK_NONE) has_origin[model->joints[i].body[k]] = true;
}

bool yk_load_size(YkModel *model)
{
    YkVec *room = malloc(yk_size_room(model) * sizeof *room);
    bool *has_origin = calloc(model->body_count, sizeof *has_origin), done = room && has_origin;
    double size = yk_size_of_start(model);
    if (done) yk_size_origins(model, has_origin);
    for (size_t i = 0; done && i < model->body_count; i++)
        size = fmax(size, yk_size_of_body(model, i, has_origin[i], room));
    model->size = size > 0 ? size : yk_size_of_values(model);
    free(room);
    free(has_origin);
    return done;
}
