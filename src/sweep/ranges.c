// Finds the ranges of an input in which a configuration closes.
#include <string.h>
#include "sweep/walk.h"

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

// Descends to the bottom of a dip of the margin between three samples that close: it may hide a narrow gap.
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
    double margin[2] = {1, 1}; // of the two previous samples
    for (int k = 0; k <= SAMPLES; k++) {
        double at = at_of(scan, k), gap;
        yk_pace_reach(scan->path.state->pace, (double)k / (SAMPLES + 1));
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

// Follows a configuration with groups both ways: it consists of the poses that can be reached.
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

// Joins two ranges that meet at the ends of a full turn.
static void join_ends(Scan *scan)
{
    size_t n = scan->count < scan->capacity ? scan->count : scan->capacity;
    if (n < 2 || scan->count > scan->capacity || scan->ranges[0].from > scan->low ||
        scan->ranges[n - 1].to < scan->high)
        return;
    scan->ranges[0].from = scan->ranges[n - 1].from - 2 * YK_PI;
    scan->count--;
}

// Returns how far the motion goes from the position of `home`: through change points, up to a limit or to `to`; `from`
// itself if the machine does not close there with the inputs asked for. NaN when out of memory.
static double reach(Scan *scan, YkState *home, double from, double to)
{
    YkWalk walk;
    YkPath path;
    yk_state_copy(scan->path.state, home);
    yk_path_start(&path, scan->path.state, scan->path.state->mech->inputs[scan->path.input]);
    bool has_memory = yk_walk_start(&walk, path, 2 * YK_PI / 180);
    bool closes = has_memory && yk_path_probe(&walk.path, from, true) >= 0;
    walk.from = from;
    double end = !closes ? from : yk_walk_go(&walk, from, to) ? to : walk.path.last;
    if (!has_memory || walk.failed) end = (double)NAN;
    yk_walk_end(&walk);
    return end;
}

// Widens the range of the state beyond a change point, where a redundant link, or a later dyad, may close with the
// other sign only. The ranges that it absorbs are dropped.
static bool widen(Scan *scan, YkState *home, double here)
{
    size_t n = scan->count < scan->capacity ? scan->count : scan->capacity, kept = 0;
    bool is_whole = n == 1 && scan->ranges[0].to - scan->ranges[0].from >= scan->high - scan->low;
    if (is_whole || n == 0 || scan->count > scan->capacity || home->mech->block_count < 2) return true;
    double rounding = 1e-9 * yk_path_scale(&scan->path);
    YkRange own = {.from = reach(scan, home, here, scan->low)};
    own.to = reach(scan, home, here, scan->high);
    if (!(own.to > own.from)) return own.to == own.from; // it goes nowhere, so it absorbs nothing
    for (size_t k = 0; k < n; k++) {
        YkRange other = scan->ranges[k];
        bool overlaps = other.from < own.to - rounding && other.to > own.from + rounding;
        if (overlaps && fabs(other.from - own.from) < rounding) own.from = other.from;
        if (overlaps && fabs(other.to - own.to) < rounding) own.to = other.to;
        if (!overlaps) scan->ranges[kept++] = other;
    }
    size_t at = 0;
    while (at < kept && scan->ranges[at].from < own.from) at++;
    memmove(scan->ranges + at + 1, scan->ranges + at, (kept - at) * sizeof own);
    scan->ranges[at] = own;
    scan->count = kept + 1;
    return true;
}

static size_t find_ranges(YkState *state, size_t coordinate, YkRange *ranges, size_t capacity)
{
    const YkMechanism *mech = state->mech;
    int32_t input = coordinate < mech->coordinate_count ? mech->coordinates[coordinate].input : YK_NONE;
    YkState *probe = input == YK_NONE ? NULL : yk_state_new(mech);
    Scan scan = {.ranges = ranges, .capacity = capacity};
    if (!probe) return input == YK_NONE ? 0 : YK_NOT_FOUND;
    yk_state_copy(probe, state);
    yk_state_lend(probe, state->pace);
    if (!yk_path_start(&scan.path, probe, (int)coordinate)) {
        yk_state_free(probe);
        return YK_NOT_FOUND;
    }
    bool is_distance = mech->coordinates[coordinate].is_distance, is_good = true;
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
        is_good = widen(&scan, state, here);
        if (!is_distance) join_ends(&scan);
    }
    yk_path_end(&scan.path);
    yk_state_free(probe);
    return is_good ? scan.count : YK_NOT_FOUND;
}

size_t yk_closing_ranges(YkState *state, size_t coordinate, YkRange *ranges, size_t capacity)
{
    bool is_own = yk_state_begin(state);
    size_t count = find_ranges(state, coordinate, ranges, capacity);
    return yk_state_end(state, is_own, YK_OK) == YK_STOPPED ? YK_NOT_FOUND : count;
}
