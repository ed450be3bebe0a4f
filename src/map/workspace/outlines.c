// Finds the regions of equal counts in a field and walks round them.
#include <math.h>
#include "base/memory.h"
#include "elementary/elementary.h"
#include "map/workspace/regions.h"

// The sides of a cell, counter-clockwise: lower, right, upper, left. Walking along them its inside is on the left.
static const int along[4][2] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}}, outward[4][2] = {{0, -1}, {1, 0}, {0, 1}, {-1, 0}};

typedef struct Place {
    long x, y; // a cell, perhaps outside of the domain
    int side;
} Place;

typedef struct Walk {
    YkRegions *regions;
    YkTract *part;
    uint32_t id;
    YkBorder *outline;
    double last[2], bound_length; // the last corner
    bool has_memory;
} Walk;

static bool is_within(const YkRegions *r, long x, long y)
{
    long n = (long)r->field.n;
    return x >= 0 && y >= 0 && x < n && y < n;
}

static size_t index_of(const YkRegions *r, long x, long y)
{
    return (size_t)y * r->field.n + (size_t)x;
}

// Returns the count of a cell, -1 outside of the domain.
static int count_of(const YkRegions *r, long x, long y)
{
    return is_within(r, x, y) ? r->field.count[index_of(r, x, y)] : -1;
}

static bool is_in(const Walk *w, long x, long y)
{
    return is_within(w->regions, x, y) && yk_runs_part(&w->regions->runs, (size_t)x, (size_t)y) == w->id;
}

// --- corners

static double edge_at(const YkField *f, int axis, long index)
{
    return f->low[axis] + (double)index * f->step[axis];
}

// Writes where a curve crosses the way from a cell to its neighbour beyond a side. Returns the block that meets there,
// or -1 at the domain's edge, which is crossed in the middle of the side.
static int cross(YkRegions *r, long x, long y, int side, double *at)
{
    YkField *f = &r->field;
    long beyond[2] = {x + outward[side][0], y + outward[side][1]};
    int axis = side % 2 == 1 ? 0 : 1;
    at[0] = f->low[0] + ((double)x + 0.5 + 0.5 * outward[side][0]) * f->step[0];
    at[1] = f->low[1] + ((double)y + 0.5 + 0.5 * outward[side][1]) * f->step[1];
    if (!is_within(r, beyond[0], beyond[1])) return -1;
    long first[2] = {x < beyond[0] ? x : beyond[0], y < beyond[1] ? y : beyond[1]};
    YkCrossing c = yk_field_crossing(f, (size_t)first[0], (size_t)first[1], axis);
    at[axis] = yk_field_center(f, axis, (size_t)first[axis]) + (double)c.part * f->step[axis];
    return (int)f->tracer.pieces[c.piece].block;
}

// Writes the place of a corner of cells at which three or four regions meet, or where one meets the domain's edge: the
// mean of the crossings about it. Returns false at others.
static bool meet(YkRegions *r, long x, long y, double *at)
{
    static const int cells[4][2] = {{-1, -1}, {0, -1}, {0, 0}, {-1, 0}}; // about it, counter-clockwise
    static const int sides[4] = {1, 2, 3, 0};                            // of each: towards the next
    const long corner[2] = {x, y}, n = (long)r->field.n;
    double sum[2] = {0, 0};
    int count = 0, inner = 0;
    for (int k = 0; k < 4; k++) {
        double crossing[2];
        long a[2] = {x + cells[k][0], y + cells[k][1]}, b[2] = {x + cells[(k + 1) % 4][0], y + cells[(k + 1) % 4][1]};
        if (count_of(r, a[0], a[1]) == count_of(r, b[0], b[1])) continue;
        count++;
        if (!is_within(r, a[0], a[1]) || !is_within(r, b[0], b[1])) continue;
        cross(r, a[0], a[1], sides[k], crossing);
        for (int axis = 0; axis < 2; axis++) sum[axis] += crossing[axis];
        inner++;
    }
    bool is_edge[2] = {x == 0 || x == n, y == 0 || y == n};
    if (count < 3 && !(is_edge[0] && is_edge[1])) return false;
    for (int axis = 0; axis < 2; axis++)
        at[axis] = is_edge[axis] || inner == 0 ? edge_at(&r->field, axis, corner[axis]) : sum[axis] / inner;
    return true;
}

static void add_corner(Walk *w, const double *at)
{
    YkBorder *o = w->outline;
    if (o->count > 0) w->bound_length += yk_hypot(at[0] - w->last[0], at[1] - w->last[1]);
    if (!YK_ROW_ROOM(o->points, 2, o->count, o->capacity)) {
        w->has_memory = false;
        return;
    }
    for (int axis = 0; axis < 2; axis++) o->points[2 * o->count + (size_t)axis] = w->last[axis] = at[axis];
    o->count++;
}

// --- what bounds a region

static void add_bound(Walk *w, int block)
{
    YkTract *p = w->part;
    size_t k = 0;
    while (k < p->region.bounds && p->bounds[k].block != block) k++;
    if (k == p->region.bounds) {
        if (!YK_ROOM(p->bounds, p->region.bounds, p->bound_capacity)) {
            w->has_memory = false;
            return;
        }
        p->bounds[p->region.bounds++] = (YkRegionBound){.block = block};
    }
    p->bounds[k].part += w->bound_length;
    w->bound_length = 0;
}

// --- walking

static Place step(const Walk *w, Place p)
{
    Place ahead = {p.x + along[p.side][0], p.y + along[p.side][1], p.side};
    Place aside = {ahead.x + outward[p.side][0], ahead.y + outward[p.side][1], (p.side + 3) % 4};
    if (!is_in(w, ahead.x, ahead.y)) return (Place){p.x, p.y, (p.side + 1) % 4};
    return is_in(w, aside.x, aside.y) ? aside : ahead;
}

static void walk(Walk *w, Place from)
{
    YkRegions *r = w->regions;
    Place p = from;
    double at[2];
    do {
        r->field.state[index_of(r, p.x, p.y)] |= (unsigned char)(YK_CELL_WALKED << p.side);
        int block = cross(r, p.x, p.y, p.side, at);
        if (block >= 0) add_corner(w, at); // the domain's edge is straight: its ends are enough
        // The corner of the grid at which this side ends.
        static const int end[4][2] = {{1, 0}, {1, 1}, {0, 1}, {0, 0}};
        if (meet(r, p.x + end[p.side][0], p.y + end[p.side][1], at)) add_corner(w, at);
        add_bound(w, block);
        p = step(w, p);
    } while (w->has_memory && (p.x != from.x || p.y != from.y || p.side != from.side));
    if (w->outline->count > 0) {
        const double *first = w->outline->points;
        w->bound_length = yk_hypot(first[0] - w->last[0], first[1] - w->last[1]);
        add_bound(w, cross(r, p.x, p.y, p.side, at));
    }
}

static double area_of(const YkBorder *o)
{
    double area = 0;
    for (size_t k = 0; k < o->count; k++) {
        const double *a = o->points + 2 * k, *b = o->points + 2 * ((k + 1) % o->count);
        area += 0.5 * ((a[0] - o->points[0]) * (b[1] - o->points[1]) - (b[0] - o->points[0]) * (a[1] - o->points[1]));
    }
    return area;
}

// Walks round a region from the sides of one cell that were not yet walked along.
static bool walk_from(YkRegions *r, uint32_t id, long x, long y)
{
    YkTract *part = &r->parts[id - 1];
    Walk w = {.regions = r, .part = part, .id = id, .has_memory = true};
    for (int side = 0; side < 4; side++) {
        bool is_outer = !is_in(&w, x + outward[side][0], y + outward[side][1]);
        if (!is_outer || (r->field.state[index_of(r, x, y)] & (YK_CELL_WALKED << side))) continue;
        if (!YK_ROOM(part->outlines, part->outline_count, part->outline_capacity)) return false;
        w.outline = &part->outlines[part->outline_count++];
        *w.outline = (YkBorder){0};
        w.bound_length = 0;
        walk(&w, (Place){x, y, side});
        if (!w.has_memory) return false;
        part->region.area += area_of(w.outline);
    }
    return true;
}

// --- regions

// Begins the regions, each with its first cell.
static bool begin_parts(YkRegions *r)
{
    const YkRuns *runs = &r->runs;
    for (size_t row = 0; row < runs->n; row++)
        for (size_t k = runs->first[row]; k < runs->first[row + 1]; k++) {
            size_t cell = row * runs->n + runs->items[k].from;
            if (runs->items[k].part <= r->count) continue;
            if (!YK_ROOM(r->parts, r->count, r->capacity)) return false;
            r->parts[r->count++] = (YkTract){.cell = cell, .region = {.configurations = r->field.count[cell]}};
        }
    return true;
}

// Walks round the regions from all cells of a row that have another number of configurations beside them.
static bool walk_row(YkRegions *r, size_t row)
{
    const YkRuns *runs = &r->runs;
    bool good = true;
    for (size_t k = runs->first[row]; k < runs->first[row + 1]; k++) {
        long end = (long)(k + 1 < runs->first[row + 1] ? runs->items[k + 1].from : runs->n), y = (long)row;
        int count = count_of(r, (long)runs->items[k].from, y);
        if (runs->items[k].part == 0) continue;
        for (long x = (long)runs->items[k].from; x < end && good; x++) {
            bool is_inner = x > (long)runs->items[k].from && x + 1 < end && count_of(r, x, y - 1) == count &&
                            count_of(r, x, y + 1) == count;
            if (!is_inner) good = walk_from(r, runs->items[k].part, x, y);
        }
    }
    return good;
}

static void measure(YkTract *part)
{
    double length = 0;
    YkRange *range = part->region.range;
    range[0] = range[1] = (YkRange){INFINITY, -INFINITY};
    for (size_t o = 0; o < part->outline_count; o++)
        for (size_t k = 0; k < 2 * part->outlines[o].count; k++) {
            double at = part->outlines[o].points[k];
            range[k % 2] = (YkRange){fmin(range[k % 2].from, at), fmax(range[k % 2].to, at)};
        }
    for (size_t k = 0; k < part->region.bounds; k++) length += part->bounds[k].part;
    for (size_t k = 0; k < part->region.bounds && length > 0; k++) part->bounds[k].part /= length;
    for (size_t a = 1; a < part->region.bounds; a++)
        for (size_t b = a; b > 0 && part->bounds[b].part > part->bounds[b - 1].part; b--) {
            YkRegionBound swapped = part->bounds[b];
            part->bounds[b] = part->bounds[b - 1];
            part->bounds[b - 1] = swapped;
        }
    part->region.outlines = part->outline_count;
}

bool yk_regions_trace(YkRegions *r)
{
    bool good = yk_runs_find(&r->runs, &r->field) && begin_parts(r);
    for (size_t row = 0; good && row < r->field.n; row++) good = walk_row(r, row);
    for (size_t k = 0; good && k < r->count; k++) measure(&r->parts[k]);
    return good && !r->field.tracer.out_of_memory;
}
