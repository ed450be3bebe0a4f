// Bisection with Krawczyk's operator in real intervals (Krawczyk 1969; Moore 1977).
#include "configurations/exclude.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "configurations/ball.h"
#include "configurations/certify.h"
#include "num/dense.h"

enum { N = YK_GEARED_MAX, ROWS = YK_GEARED_ROWS, BOXES_MAX = 400000 };
#define SMALLEST 1e-7                // half a side, rad: poses that are not separated by then meet
#define NEAR (0.5 * YK_EXCLUDE_NEAR) // half a side: smaller boxes are left where a singular pose is as close
#define WIDER 1.5                    // a pose on the side of a box is inside of the box in which it is sought

typedef struct Box {
    double at[N], half[N];
} Box;

// The bounds of an equation over a box: F in the middles of box and interval, and the Jacobian over it, with radii.
typedef struct Row {
    double miss, miss_radius, slope[N], slope_radius[N];
    double rate, rate_radius; // its derivative by the interval's parameter
} Row;

typedef struct Search {
    const YkGeared *g;
    const YkExclusion *over; // NULL: at a pose
    size_t n, m;             // unknowns, equations
    Row rows[ROWS];
    size_t chosen[N]; // where there are more equations than unknowns: those that are solved
    double Y[N * N];  // an approximate inverse of the Jacobian in the middle
    double shift[N], shift_radius[N], rest[N * N]; // Y F; bounds of |I - Y J|
} Search;

// Coefficients: over the whole interval or at the pose; in the interval's middle; their derivatives over it.
typedef enum Which { WHOLE, MIDDLE, RATE } Which;

static YkBall coefficient(const Search *s, size_t loop, size_t k, Which which)
{
    size_t place = loop * (s->g->shape.unknowns + 1) + k;
    const YkExclusionPath *path = s->over ? &s->over->path : NULL;
    if (path && which == MIDDLE) return yk_ball(path->middle[place], path->middle_radius[place]);
    if (which == RATE) return path ? yk_ball(path->rate[place], path->rate_radius[place]) : yk_ball(yk_vec(0, 0), 0);
    YkVec a = s->g->coefficients[place];
    bool is_absent = k < s->g->shape.unknowns && a.x == 0 && a.y == 0 && s->g->radius[place] == 0;
    return yk_ball(a, is_absent ? 0 : fmax(YK_COEFFICIENT_ERROR, s->g->radius[place]));
}

// Adds a term of a loop to its derivative by an unknown.
static void add_slope(Row *re, Row *im, size_t k, YkBall slope)
{
    re->slope[k] += slope.at.x;
    im->slope[k] += slope.at.y;
    re->slope_radius[k] = YK_BALL_OUT(re->slope_radius[k] + slope.radius + 0x1p-51 * fabs(re->slope[k]));
    im->slope_radius[k] = YK_BALL_OUT(im->slope_radius[k] + slope.radius + 0x1p-51 * fabs(im->slope[k]));
}

// Returns e^(i angle), or a distance, over the box or in its middle.
static YkBall value_of(const Search *s, const Box *box, size_t k, bool is_over)
{
    double radius = is_over ? box->half[k] : 0;
    if (k >= s->g->shape.angles) return yk_ball(yk_vec(box->at[k], 0), radius);
    return yk_ball(yk_unit(box->at[k]), YK_BALL_OUT(fmin(2.1, 1e-15 + radius)));
}

// Adds a term of a loop over the box: to the sum, and to the slopes unless they are NULL.
static YkBall term_of(const Search *s, const Box *box, size_t loop, size_t k, Which which, Row *rows)
{
    bool is_over = which == WHOLE;
    const YkBall i = {{0, 1}, 0};
    YkBall a = coefficient(s, loop, k, which), x = value_of(s, box, k, is_over);
    int turning = s->g->shape.turning[k];
    if (k >= s->g->shape.angles && turning >= 0) a = yk_ball_mul(a, value_of(s, box, (size_t)turning, is_over));
    YkBall term = yk_ball_mul(a, x);
    if (!rows) return term;
    add_slope(rows, rows + 1, k, k < s->g->shape.angles ? yk_ball_mul(i, term) : a);
    if (turning >= 0) add_slope(rows, rows + 1, (size_t)turning, yk_ball_mul(i, term));
    return term;
}

// Reads a loop. Returns whether it certainly closes nowhere in the box.
static bool read_loop(Search *s, size_t loop, const Box *box)
{
    Row *rows = &s->rows[2 * loop];
    YkBall sum = coefficient(s, loop, s->n, MIDDLE), over = coefficient(s, loop, s->n, WHOLE);
    YkBall rate = coefficient(s, loop, s->n, RATE);
    for (int r = 0; r < 2; r++)
        for (size_t k = 0; k < s->n; k++) rows[r].slope[k] = rows[r].slope_radius[k] = 0;
    for (size_t k = 0; k < s->n; k++) {
        if (coefficient(s, loop, k, WHOLE).radius == 0) continue; // absent
        sum = yk_ball_add(sum, term_of(s, box, loop, k, MIDDLE, NULL));
        if (s->over) rate = yk_ball_add(rate, term_of(s, box, loop, k, RATE, NULL));
        over = yk_ball_add(over, term_of(s, box, loop, k, WHOLE, rows));
    }
    rows[0].miss = sum.at.x;
    rows[1].miss = sum.at.y;
    rows[0].miss_radius = rows[1].miss_radius = sum.radius;
    rows[0].rate = rate.at.x;
    rows[1].rate = rate.at.y;
    rows[0].rate_radius = rows[1].rate_radius = rate.radius;
    return fmax(fabs(over.at.x), fabs(over.at.y)) > over.radius;
}

// Adds a law to a relation over the box, by the mean value theorem; *size: the scale of what is rounded. Returns how
// far it can move.
static double read_law(const Search *s, const YkGearedLaw *law, double share, const Box *box, Row *row, double *size)
{
    double x = law->offset, radius = 1e-15 * fabs(x), d[YK_LAW_ORDER + 1], gain = share * law->gain;
    for (size_t k = 0; k < s->n; k++) {
        x += law->factor[k] * box->at[k];
        radius += fabs(law->factor[k]) * (box->half[k] + 4e-15 * fabs(box->at[k]));
    }
    yk_law_eval(law->law, x, d);
    double off = law->bound.curvature * radius + 1e-14 * law->bound.slope;
    bool is_near = off < law->bound.slope;
    double middle = is_near ? d[1] : 0, most = is_near ? off : law->bound.slope;
    for (size_t k = 0; k < s->n; k++) {
        row->slope[k] += gain * law->factor[k] * middle;
        row->slope_radius[k] = YK_BALL_OUT(row->slope_radius[k] + fabs(gain * law->factor[k]) * most);
    }
    row->miss += gain * d[0];
    *size += fabs(gain) * (fabs(d[0]) + law->bound.slope * (1 + fabs(x)));
    return YK_BALL_OUT(fabs(gain) * law->bound.slope * radius);
}

// Reads a relation. Returns how far its sum can move over the box; *nearest: how far it is from a multiple of 2 pi, or
// from 0 if it is met exactly.
static double read_relation(Search *s, size_t relation, const Box *box, double *nearest)
{
    Row *row = &s->rows[2 * s->g->shape.loops + relation];
    size_t at = (2 * s->g->shape.loops + relation) * (s->n + 1) + s->n; // of the phase
    row->miss = s->over ? s->over->path.middle[at].x : s->g->phase[relation];
    double size = fabs(row->miss), moves = 0;
    for (size_t k = 0; k < s->n; k++) {
        double p = s->g->factor[relation][k];
        row->miss += p * box->at[k];
        size += fabs(p * box->at[k]);
        moves += fabs(p) * box->half[k];
        row->slope[k] = p;
        row->slope_radius[k] = 4e-15 * fabs(p);
    }
    for (size_t r = 0; r < s->g->relations; r++)
        if (s->g->laws[r].law && s->g->share[relation][r] != 0)
            moves += read_law(s, &s->g->laws[r], s->g->share[relation][r], box, row, &size);
    if (relation < s->g->turning) row->miss -= 2 * YK_PI * rint(row->miss / (2 * YK_PI));
    row->miss_radius =
        1e-13 + 1e-14 * size + (s->over ? s->over->path.middle_radius[at] : s->g->phase_radius[relation]);
    row->rate = row->rate_radius = 0;
    if (s->over) {
        row->rate = s->over->path.rate[at].x;
        row->rate_radius = s->over->path.rate_radius[at];
        moves += (fabs(row->rate) + row->rate_radius) * s->over->path.half;
    }
    *nearest = fabs(row->miss);
    return YK_BALL_OUT(moves * (1 + 1e-14) + row->miss_radius);
}

// Chooses n independent equations: those that come first as columns with pivots. Returns false if there are fewer.
static bool choose_rows(Search *s)
{
    double A[N * ROWS], tau[N];
    size_t order[ROWS];
    for (size_t r = 0; r < s->m; r++)
        for (size_t c = 0; c < s->n; c++) A[c * s->m + r] = s->rows[r].slope[c];
    if (yk_qr_factor(s->n, s->m, A, order, tau, 1e-14) < s->n) return false;
    memcpy(s->chosen, order, s->n * sizeof *order);
    return true;
}

static void put_chosen_first(Search *s)
{
    Row rows[N];
    for (size_t k = 0; k < s->n; k++) rows[k] = s->rows[s->chosen[k]];
    memcpy(s->rows, rows, s->n * sizeof *rows);
}

static bool invert(Search *s)
{
    double A[N * N], scale[N], column[N];
    int pivot[N];
    if (s->m > s->n) put_chosen_first(s);
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
        double shift = 0, radius = 0, along = 0, beside = 0;
        for (size_t k = 0; k < s->n; k++) {
            shift += y[k] * s->rows[k].miss;
            radius += fabs(y[k]) * (s->rows[k].miss_radius + unit * fabs(s->rows[k].miss));
            along += y[k] * s->rows[k].rate;
            beside += fabs(y[k]) * (s->rows[k].rate_radius + unit * fabs(s->rows[k].rate));
        }
        if (s->over) radius += (fabs(along) + beside) * s->over->path.half;
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
    bool are_single = true;
    for (size_t l = 0; l < s->g->shape.loops; l++)
        if (read_loop(s, l, box)) return EMPTY;
    for (size_t r = 0; r < s->g->relations; r++) {
        double nearest, moves = read_relation(s, r, box, &nearest);
        if (nearest > moves) return EMPTY;
        are_single &=
            r >= s->g->turning || moves < 2 * YK_PI - nearest - 1e-9; // otherwise several multiples of 2 pi may be met
    }
    if (!are_single || (s->m > s->n && !choose_rows(s)) || !invert(s)) return UNKNOWN;
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

// Reads all equations at a pose.
static void read_at(Search *s, const double *x)
{
    double nearest;
    Box point = {.half = {0}};
    memcpy(point.at, x, s->n * sizeof *x);
    for (size_t l = 0; l < s->g->shape.loops; l++) read_loop(s, l, &point);
    for (size_t r = 0; r < s->g->relations; r++) read_relation(s, r, &point, &nearest);
}

// Finds the pose that is alone in a box, by Newton's method for the equations that prove that. Says by how much these
// miss there, and by how much all do if there are more.
static void polish(Search *s, const Box *box, double *x, double *miss, double *all)
{
    Box point = {.half = {0}};
    memcpy(point.at, box->at, sizeof point.at);
    for (int step = 0; step < 12; step++) {
        double most = 0;
        read_at(s, point.at);
        if (!invert(s)) break;
        multiply(s);
        for (size_t k = 0; k < s->n; k++) {
            point.at[k] -= s->shift[k];
            most = fmax(most, fabs(s->shift[k]));
        }
        if (most < 1e-15) break;
    }
    memcpy(x, point.at, s->n * sizeof *x);
    read_at(s, x);
    *miss = *all = 0;
    for (size_t r = 0; r < s->m && s->m > s->n; r++) *all = fmax(*all, fabs(s->rows[r].miss));
    for (size_t k = 0; k < s->n; k++) *miss = fmax(*miss, fabs(s->rows[s->m > s->n ? s->chosen[k] : k].miss));
}

static double difference(const Search *s, size_t k, double x, double y)
{
    return fabs(k < s->g->shape.angles ? yk_nearest_turn(x - y, 0) : x - y);
}

static bool is_within(const Search *s, const double *x, const double *middle, const double *half)
{
    for (size_t k = 0; k < s->n; k++)
        if (!(difference(s, k, x[k], middle[k]) < half[k])) return false;
    return true;
}

static double apart(const Search *s, const double *x, const double *y)
{
    double most = 0;
    for (size_t k = 0; k < s->n; k++) most = fmax(most, difference(s, k, x[k], y[k]));
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
    const double closed = 1e-11, open = 1e-9;
    double x[N], *alone, miss, all;
    size_t n = s->n;
    polish(s, box, x, &miss, &all);
    if (!(miss < open) || !is_within(s, x, box->at, box->half)) out->is_complete = false;
    if (all > open) return true; // the equations that were not needed do not hold at the only pose
    if (all > closed) out->is_complete = false;
    for (size_t k = 0; k < out->count; k++) {
        alone = out->alone + 2 * n * k;
        if (!(apart(s, x, out->poses + n * k) < 1e-7)) continue;
        if (!is_within(s, x, alone, alone + n)) out->is_complete = false; // two that cannot be separated
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

// Closes the equations from the middle of a box by least squares. Returns whether that leads to a singular pose beside
// it: a dead point, or one of a continuum.
static bool is_beside_singular(Search *s, const Box *box)
{
    const double rounding = 1e-7, closed = 1e-12;
    double x[N], A[ROWS * N], b[ROWS], tau[2 * N], step[N], miss = INFINITY;
    size_t order[N], rank = s->n;
    memcpy(x, box->at, s->n * sizeof *x);
    for (int round = 0; round < 25 && !(miss < 1e-15); round++) {
        double before = miss;
        read_at(s, x);
        miss = 0;
        for (size_t r = 0; r < s->m; r++) {
            memcpy(A + r * s->n, s->rows[r].slope, s->n * sizeof *A);
            b[r] = -s->rows[r].miss;
            miss = fmax(miss, fabs(b[r]));
        }
        rank = yk_qr_factor(s->m, s->n, A, order, tau, rounding);
        if (!(miss < before)) break;
        yk_qr_solve(s->m, s->n, A, order, tau, rank, b, step);
        for (size_t k = 0; k < s->n; k++) x[k] += step[k];
        for (size_t k = 0; k < s->n; k++)
            if (!(difference(s, k, x[k], box->at[k]) < NEAR)) return false;
    }
    return miss < closed && rank < s->n;
}

static bool search(Search *s, const Box *box, YkPace *pace, YkExcluded *out)
{
    if (!out->is_complete) return true;
    if (++out->boxes > (s->over ? s->over->most : BOXES_MAX) || !yk_pace_spend(pace, 40 * s->n * s->n * s->n)) {
        out->is_complete = false;
        return true;
    }
    if (judge(s, box) == EMPTY) return true;
    Box wider = *box;
    for (size_t k = 0; k < s->n; k++) wider.half[k] *= WIDER;
    size_t side = widest(box, s->n);
    bool is_alone = judge(s, &wider) == ALONE, is_small = box->half[side] < (s->over ? s->over->smallest : SMALLEST);
    if (is_alone && !s->over) return keep(s, &wider, out);
    if (s->over && is_alone && s->over->judge(s->over->context, wider.at, wider.half)) return true;
    if (!s->over && box->half[side] < NEAR && is_beside_singular(s, box)) {
        out->left++;
        return true;
    }
    if (is_small) {
        out->is_complete = s->over && s->over->keep(s->over->context, box->at, box->half);
        return true;
    }
    Box low = half_of(box, side, -1), high = half_of(box, side, 1);
    return search(s, &low, pace, out) && search(s, &high, pace, out);
}

// Puts the unknowns of a pose into the order of the group's columns, distances in metres.
static void order(const YkGeared *g, double *pose)
{
    double x[N];
    memcpy(x, pose, g->shape.unknowns * sizeof *x);
    for (size_t k = 0; k < g->shape.unknowns; k++)
        pose[g->shape.column[k]] = k < g->shape.angles ? x[k] : g->size * x[k];
}

static Search search_of(const YkGeared *g, const YkExclusion *over)
{
    return (Search){.g = g, .over = over, .n = g->shape.unknowns, .m = 2 * g->shape.loops + g->relations};
}

static bool search_all(Search *s, YkPace *pace, YkExcluded *out)
{
    Box all = {.half = {0}};
    for (size_t k = 0; k < s->n; k++) {
        all.at[k] = 0.0123456789 * (double)(k + 1); // so that no box ends where machines are special
        all.half[k] = YK_BALL_OUT(s->g->reach[k] + 1e-12 + (k < s->g->shape.angles ? 0 : fabs(all.at[k])));
    }
    out->count = out->boxes = out->left = 0;
    out->is_complete = true;
    return search(s, &all, pace, out);
}

bool yk_exclude_over(const YkGeared *geared, YkPace *pace, const YkExclusion *exclusion)
{
    Search s = search_of(geared, exclusion);
    YkExcluded none = {.is_complete = true};
    if (!exclusion->boxes) return search_all(&s, pace, &none) && none.is_complete;
    for (size_t k = 0; k < exclusion->count && none.is_complete; k++) {
        Box box;
        memcpy(box.at, exclusion->boxes + 2 * N * k, sizeof box.at);
        memcpy(box.half, exclusion->boxes + 2 * N * k + N, sizeof box.half);
        search(&s, &box, pace, &none);
    }
    return none.is_complete;
}

bool yk_exclude(const YkGeared *geared, YkPace *pace, YkExcluded *out)
{
    Search s = search_of(geared, NULL);
    bool has_memory = search_all(&s, pace, out);
    for (size_t p = 0; p < out->count; p++) order(geared, out->poses + p * s.n);
    return has_memory;
}

void yk_excluded_end(YkExcluded *excluded)
{
    free(excluded->poses);
    free(excluded->alone);
    *excluded = (YkExcluded){0};
}
