// Bisection with Krawczyk's operator in real intervals (Krawczyk 1969; Moore 1977).
#include "configurations/exclude.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "configurations/ball.h"
#include "configurations/certify.h"
#include "num/dense.h"

enum { N = YK_GEARED_MAX, BOXES_MAX = 400000 };
#define SMALLEST 1e-7 // half a side, rad: poses that are not told apart then meet
#define WIDER 1.5     // a pose on the side of a box is inside of the box in which it is sought

typedef struct Box {
    double at[N], half[N];
} Box;

// What is known of the equations over a box: F in its middle, and the Jacobian over it, each with a radius.
typedef struct Row {
    double miss, miss_radius, slope[N], slope_radius[N];
} Row;

typedef struct Search {
    const YkGeared *g;
    size_t n;
    Row rows[N];
    double Y[N * N];                               // an approximate inverse of the Jacobian in the middle
    double shift[N], shift_radius[N], rest[N * N]; // Y F; bounds of |I - Y J|
} Search;

static YkBall coefficient(const YkGeared *g, size_t loop, size_t k)
{
    YkVec a = g->coefficients[loop * (g->shape.unknowns + 1) + k];
    bool is_absent = k < g->shape.unknowns && a.x == 0 && a.y == 0;
    return yk_ball(a, is_absent ? 0 : YK_COEFFICIENT_ERROR);
}

// Reads a loop. Returns whether it certainly closes nowhere in the box.
static bool read_loop(Search *s, size_t loop, const Box *box)
{
    Row *re = &s->rows[2 * loop], *im = re + 1;
    YkBall sum = coefficient(s->g, loop, s->n), over = sum;
    for (size_t k = 0; k < s->n; k++) {
        YkBall a = coefficient(s->g, loop, k), e = yk_ball(yk_unit(box->at[k]), 1e-15);
        YkBall point = yk_ball_mul(a, e);
        YkBall whole = yk_ball_mul(a, yk_ball(e.at, YK_BALL_OUT(fmin(2.1, 1e-15 + box->half[k]))));
        bool is_absent = a.radius == 0;
        if (!is_absent) sum = yk_ball_add(sum, point);
        if (!is_absent) over = yk_ball_add(over, whole);
        re->slope[k] = is_absent ? 0 : -whole.at.y; // the derivative is i times the term
        im->slope[k] = is_absent ? 0 : whole.at.x;
        re->slope_radius[k] = im->slope_radius[k] = is_absent ? 0 : whole.radius;
    }
    re->miss = sum.at.x;
    im->miss = sum.at.y;
    re->miss_radius = im->miss_radius = sum.radius;
    return fmax(fabs(over.at.x), fabs(over.at.y)) > over.radius;
}

// Reads the relation. Returns how far its sum can move over the box; *nearest: how far it is from a multiple of 2 pi.
static double read_relation(Search *s, const Box *box, double *nearest)
{
    Row *row = &s->rows[s->n - 1];
    double sum = s->g->phase, size = fabs(sum), moves = 0;
    for (size_t k = 0; k < s->n; k++) {
        double p = s->g->ratio[k];
        sum += p * box->at[k];
        size += fabs(p * box->at[k]);
        moves += fabs(p) * box->half[k];
        row->slope[k] = p;
        row->slope_radius[k] = 0;
    }
    row->miss = sum - 2 * YK_PI * rint(sum / (2 * YK_PI));
    row->miss_radius = 1e-13 + 4e-15 * size;
    *nearest = fabs(row->miss);
    return YK_BALL_OUT(moves + row->miss_radius);
}

static bool invert(Search *s)
{
    double A[N * N], scale[N], column[N];
    int pivot[N];
    for (size_t r = 0; r < s->n; r++) memcpy(A + r * s->n, s->rows[r].slope, s->n * sizeof *A);
    if (yk_lu_factor(s->n, A, pivot, scale) == 0) return false;
    for (size_t k = 0; k < s->n; k++) {
        for (size_t r = 0; r < s->n; r++) column[r] = r == k;
        yk_lu_solve(s->n, A, pivot, column);
        for (size_t r = 0; r < s->n; r++) s->Y[r * s->n + k] = column[r];
    }
    return true;
}

static void multiply(Search *s)
{
    const double unit = 0x1p-48; // of all that is added: more than its rounding
    for (size_t r = 0; r < s->n; r++) {
        const double *y = s->Y + r * s->n;
        double shift = 0, radius = 0;
        for (size_t k = 0; k < s->n; k++) {
            shift += y[k] * s->rows[k].miss;
            radius += fabs(y[k]) * (s->rows[k].miss_radius + unit * fabs(s->rows[k].miss));
        }
        s->shift[r] = shift;
        s->shift_radius[r] = YK_BALL_OUT(radius);
        for (size_t c = 0; c < s->n; c++) {
            double product = r == c ? -1 : 0, more = unit;
            for (size_t k = 0; k < s->n; k++) {
                product += y[k] * s->rows[k].slope[c];
                more += fabs(y[k]) * (s->rows[k].slope_radius[c] + unit * fabs(s->rows[k].slope[c]));
            }
            s->rest[r * s->n + c] = YK_BALL_OUT(fabs(product) + more);
        }
    }
}

typedef enum Verdict { EMPTY, ALONE, UNKNOWN } Verdict;

// Judges a box: no pose in it; exactly one; or unknown.
static Verdict judge(Search *s, const Box *box)
{
    double nearest, moves;
    for (size_t l = 0; l < s->g->shape.loops; l++)
        if (read_loop(s, l, box)) return EMPTY;
    moves = read_relation(s, box, &nearest);
    if (nearest > moves) return EMPTY;
    if (moves > 2 * YK_PI - nearest - 1e-9 || !invert(s)) return UNKNOWN; // several multiples of 2 pi may be met
    multiply(s);
    bool is_alone = true;
    for (size_t r = 0; r < s->n; r++) {
        double rest = s->shift_radius[r];
        for (size_t c = 0; c < s->n; c++) rest += s->rest[r * s->n + c] * box->half[c];
        rest = YK_BALL_OUT(rest);
        if (fabs(s->shift[r]) > YK_BALL_OUT(rest + box->half[r])) return EMPTY;
        is_alone &= YK_BALL_OUT(fabs(s->shift[r]) + rest) < box->half[r];
    }
    return is_alone ? ALONE : UNKNOWN;
}

// --- poses

// Finds the pose that is alone in a box, by Newton's method.
static void polish(Search *s, const Box *box, double *x)
{
    Box point = {.half = {0}};
    memcpy(point.at, box->at, sizeof point.at);
    for (int step = 0; step < 12; step++) {
        double nearest, most = 0;
        for (size_t l = 0; l < s->g->shape.loops; l++) read_loop(s, l, &point);
        read_relation(s, &point, &nearest);
        if (!invert(s)) break;
        multiply(s);
        for (size_t k = 0; k < s->n; k++) {
            point.at[k] -= s->shift[k];
            most = fmax(most, fabs(s->shift[k]));
        }
        if (most < 1e-15) break;
    }
    memcpy(x, point.at, s->n * sizeof *x);
}

static bool is_within(size_t n, const double *x, const double *middle, const double *half)
{
    for (size_t k = 0; k < n; k++)
        if (!(fabs(yk_nearest_turn(x[k] - middle[k], 0)) < half[k])) return false;
    return true;
}

static double apart(size_t n, const double *x, const double *y)
{
    double most = 0;
    for (size_t k = 0; k < n; k++) most = fmax(most, fabs(yk_nearest_turn(x[k] - y[k], 0)));
    return most;
}

static bool make_room(YkExcluded *out, size_t n)
{
    if (out->count < out->capacity) return true;
    size_t capacity = 2 * out->capacity + 16;
    double *poses = realloc(out->poses, capacity * n * sizeof *poses);
    if (poses) out->poses = poses;
    double *alone = realloc(out->alone, 2 * capacity * n * sizeof *alone);
    if (alone) out->alone = alone;
    if (poses && alone) out->capacity = capacity;
    return poses && alone;
}

// Keeps the pose of a box, unless it is one that was kept. Returns false when out of memory.
static bool keep(Search *s, const Box *box, YkExcluded *out)
{
    double x[N], *alone;
    size_t n = s->n;
    polish(s, box, x);
    if (!is_within(n, x, box->at, box->half)) out->is_complete = false;
    for (size_t k = 0; k < out->count; k++) {
        alone = out->alone + 2 * n * k;
        if (!(apart(n, x, out->poses + n * k) < 1e-7)) continue;
        if (!is_within(n, x, alone, alone + n)) out->is_complete = false; // two that nothing tells apart
        return true;
    }
    if (!yk_geared_turn(s->g, x)) out->is_complete = false;
    if (!make_room(out, n)) return false;
    alone = out->alone + 2 * n * out->count;
    memcpy(out->poses + n * out->count++, x, n * sizeof *x);
    memcpy(alone, box->at, n * sizeof *x);
    memcpy(alone + n, box->half, n * sizeof *x);
    return true;
}

// --- boxes

static size_t widest(const Box *box, size_t n)
{
    size_t k = 0;
    for (size_t j = 1; j < n; j++)
        if (box->half[j] > box->half[k]) k = j;
    return k;
}

static Box half_of(const Box *box, size_t side, double sign)
{
    Box part = *box;
    part.half[side] *= 0.5;
    part.at[side] += sign * part.half[side];
    part.half[side] = YK_BALL_OUT(part.half[side] + 1e-15); // what the middle is rounded by
    return part;
}

static bool search(Search *s, const Box *box, YkPace *pace, YkExcluded *out)
{
    if (!out->is_complete) return true;
    if (++out->boxes > BOXES_MAX || !yk_pace_spend(pace, 40 * s->n * s->n * s->n)) {
        out->is_complete = false;
        return true;
    }
    if (judge(s, box) == EMPTY) return true;
    Box wider = *box;
    for (size_t k = 0; k < s->n; k++) wider.half[k] *= WIDER;
    size_t side = widest(box, s->n);
    if (judge(s, &wider) == ALONE) return keep(s, &wider, out);
    if (box->half[side] < SMALLEST) {
        out->is_complete = false;
        return true;
    }
    Box low = half_of(box, side, -1), high = half_of(box, side, 1);
    return search(s, &low, pace, out) && search(s, &high, pace, out);
}

bool yk_exclude(const YkGeared *geared, YkPace *pace, YkExcluded *out)
{
    Search s = {.g = geared, .n = geared->shape.unknowns};
    Box all;
    for (size_t k = 0; k < N; k++) {
        all.at[k] = 0.0123456789 * (double)(k + 1); // so that no box ends where machines are special
        all.half[k] = YK_BALL_OUT(YK_PI + 1e-12);
    }
    out->count = out->boxes = 0;
    out->is_complete = true;
    return search(&s, &all, pace, out);
}

void yk_excluded_end(YkExcluded *excluded)
{
    free(excluded->poses);
    free(excluded->alone);
    *excluded = (YkExcluded){0};
}
