// Watches the margins of every dyad three at a time, and how far bodies turn between poses.
#include "solve/watch.h"
#include <stdlib.h>
#include <string.h>

bool yk_watch_start(YkBranchWatch *w, const YkMechanism *mech)
{
    *w = (YkBranchWatch){.mech = mech};
    w->before = calloc(2 * mech->block_count + 1, sizeof *w->before);
    w->unit = calloc(2 * mech->block_count + 1, sizeof *w->unit);
    return w->before && w->unit;
}

void yk_watch_end(YkBranchWatch *w)
{
    free(w->before);
    free(w->unit);
    *w = (YkBranchWatch){0};
}

// Two poses whose margins differ by more than this are too far apart to judge what lies between them.
static const double CHANGE_MOST = 0.4;

static bool is_doubtful(double a, double m, double b)
{
    double least = fmin(a, fmin(m, b)), most = fmax(a, fmax(m, b));
    return !(least > YK_SINGULAR_MARGIN) || most - least > CHANGE_MOST || yk_margin_may_vanish(a, m, b);
}

static double sample(const double *before, const double *m, ptrdiff_t k)
{
    return k < 0 ? before[2 + k] : m[k];
}

// Returns the first of n lanes that is not clear; n if all are. Two poses precede them. The first three poses around a
// zero show it: it lies after the second of them, or after the last.
static size_t first_doubt(const double *before, const double *m, size_t seen, size_t n)
{
    bool dips = false;
    for (size_t k = seen < 2 ? 2 - seen : 0; k < n; k++) {
        ptrdiff_t at = (ptrdiff_t)k;
        if (is_doubtful(sample(before, m, at - 2), sample(before, m, at - 1), m[k])) return k >= 1 ? k - 1 : 0;
        if (k == 1 && n > 2) yk_lanes_dip(&dips, m, YK_SINGULAR_MARGIN, CHANGE_MOST, n - 2);
        if (k == 1 && !dips) return n;
    }
    return n;
}

static const double SWING_COSINE = 0.99; // 8.1 deg

// Returns the first of n lanes in which a body has turned far from the one before; n if there is none.
static size_t first_swing(YkTurn t, YkVec *before, bool is_first, size_t n)
{
    bool swings = false;
    YkVec last = is_first ? yk_vec(t.c[0], t.s[0]) : *before;
    *before = yk_vec(t.c[n - 1], t.s[n - 1]);
    if (!(last.x * t.c[0] + last.y * t.s[0] >= SWING_COSINE)) return 0;
    if (n > 1) yk_lanes_swing(&swings, t.c, t.s, SWING_COSINE, n - 1);
    for (size_t k = 1; swings && k < n; k++)
        if (!(t.c[k - 1] * t.c[k] + t.s[k - 1] * t.s[k] >= SWING_COSINE)) return k;
    return n;
}

size_t yk_watch_lanes(YkBranchWatch *w, const YkSpace *space, size_t n)
{
    size_t clear = n;
    for (size_t b = 0; b < w->mech->block_count; b++) {
        if (w->mech->blocks[b].kind > YK_BLOCK_RPR) continue; // the larger groups have no margin
        double *before = w->before + 2 * b;
        const double *m = space->block_margin + b * space->stride;
        size_t first = first_doubt(before, m, w->seen, n);
        if (first < clear) clear = first;
        for (size_t k = 0; k < 2; k++) {
            YkColumn column = w->mech->blocks[b].column[k];
            if (column.is_distance) continue;
            first = first_swing(yk_space_turn(space, column.index), &w->unit[2 * b + k], w->seen == 0, n);
            if (first < clear) clear = first;
        }
        before[0] = n > 1 ? m[n - 2] : before[1];
        before[1] = m[n - 1];
    }
    w->seen += n;
    return clear;
}
