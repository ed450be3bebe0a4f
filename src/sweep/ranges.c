// The ranges of an input in which a configuration closes.
#include <stdlib.h>
#include "sweep/path.h"

enum { SAMPLES = 1440 };

typedef struct Scan {
    YkPath path;
    double low, high;
    YkRange *ranges;
    size_t count, capacity;
    bool is_open;
} Scan;

static double at_of(const Scan *scan, int k)
{
    return scan->low + (scan->high - scan->low) * k / SAMPLES;
}

static void open_range(Scan *scan, double at)
{
    if (scan->count < scan->capacity) scan->ranges[scan->count].from = at;
    scan->is_open = true;
}

static void close_range(Scan *scan, double at)
{
    if (scan->count < scan->capacity) scan->ranges[scan->count].to = at;
    scan->count++;
    scan->is_open = false;
}

// A dip of the margin between three samples that close may hide a narrow gap: goes down to its bottom.
static bool bottom(Scan *scan, double a, double b, double *at)
{
    static const double golden = 0.3819660112501051;
    for (int k = 0; k < 60; k++) {
        double x = a + golden * (b - a), y = b - golden * (b - a), mx, my;
        if (yk_path_probe(&scan->path, *at = x, true) < 0) return true;
        mx = scan->path.state->space.margin[0];
        if (yk_path_probe(&scan->path, *at = y, true) < 0) return true;
        my = scan->path.state->space.margin[0];
        if (mx < my)
            b = y;
        else
            a = x;
    }
    return false;
}

static void scan_closed_form(Scan *scan)
{
    double margin[2] = {1, 1}; // of the two samples before
    for (int k = 0; k <= SAMPLES; k++) {
        double at = at_of(scan, k), gap;
        bool closes = yk_path_probe(&scan->path, at, true) >= 0;
        double m = closes ? scan->path.state->space.margin[0] : -1;
        if (closes && !scan->is_open)
            open_range(scan, k == 0 ? at : yk_path_limit(&scan->path, at, at_of(scan, k - 1)));
        if (!closes && scan->is_open) close_range(scan, yk_path_limit(&scan->path, at_of(scan, k - 1), at));
        bool dips = closes && k >= 2 && margin[0] > margin[1] && margin[1] <= m; // and all three close
        if (dips && margin[1] > -1 && margin[1] < 0.01 && margin[0] > 0 && bottom(scan, at_of(scan, k - 2), at, &gap)) {
            close_range(scan, yk_path_limit(&scan->path, at_of(scan, k - 2), gap));
            open_range(scan, yk_path_limit(&scan->path, at, gap));
        }
        margin[0] = margin[1];
        margin[1] = m;
    }
    if (scan->is_open) close_range(scan, scan->high);
}

// With groups, a configuration is what can be reached: follow it both ways.
static double follow(Scan *scan, YkState *home, double from, double to)
{
    yk_state_copy(scan->path.state, home);
    double at = from;
    for (int k = 1; k <= SAMPLES; k++) {
        double next = from + (to - from) * k / SAMPLES;
        if (yk_path_probe(&scan->path, next, true) < 0) return yk_path_limit(&scan->path, at, next);
        at = next;
    }
    return to;
}

// Two ranges that meet at the ends of a full turn are one.
static void join_ends(Scan *scan)
{
    size_t n = scan->count < scan->capacity ? scan->count : scan->capacity;
    if (n < 2 || scan->count > scan->capacity || scan->ranges[0].from > scan->low ||
        scan->ranges[n - 1].to < scan->high)
        return;
    scan->ranges[0].from = scan->ranges[n - 1].from - 2 * YK_PI;
    scan->count--;
}

size_t yk_closing_ranges(YkState *state, size_t coordinate, YkRange *ranges, size_t capacity)
{
    const YkMechanism *mech = state->mech;
    int32_t input = mech->coordinates[coordinate].input;
    YkState *probe = input == YK_NONE ? NULL : yk_state_new(mech);
    Scan scan = {.ranges = ranges, .capacity = capacity};
    if (!probe) return input == YK_NONE ? 0 : (size_t)-1;
    yk_state_copy(probe, state);
    if (!yk_path_start(&scan.path, probe, (int)coordinate)) {
        yk_state_free(probe);
        return (size_t)-1;
    }
    bool is_distance = mech->coordinates[coordinate].is_distance;
    double here = state->valid_input[3 * input], reach = is_distance ? 0 : YK_PI;
    for (size_t b = 0; is_distance && b < mech->model->point_count; b++) reach += yk_norm(mech->model->points[b].at);
    scan.low = is_distance ? -reach : here - reach;
    scan.high = is_distance ? reach : here + reach;
    if (mech->has_groups) {
        double low = follow(&scan, state, here, scan.low);
        double high = low <= scan.low ? scan.high : follow(&scan, state, here, scan.high);
        open_range(&scan, low);
        close_range(&scan, high);
    } else {
        scan_closed_form(&scan);
        if (!is_distance) join_ends(&scan);
    }
    yk_path_end(&scan.path);
    yk_state_free(probe);
    return scan.count;
}
