// Predicts and corrects along a path of places.
#include <string.h>
#include "synthesis/nine_points/alt.h"

enum {
    N = YK_ALT_SIZE,
    P = YK_ALT_PLACES,
    STEPS_MAX = 4000,
    STEP_WORK = 16000,
    FINE_WORK = 200000,
    CORRECTIONS = 3,
    POLISHES = 14
};

typedef struct Path {
    YkVec along[P], at[P]; // to - from; the places at the last t asked for
    const YkVec *from;
    bool is_fine;
    YkVec J[N * N];
    int pivot[N];
} Path;

// How large a change of x is, relative to it or to the size of the points, which is 1.
static double relative(const YkVec *x, const YkVec *change)
{
    double most = 0;
    for (size_t k = 0; k < N; k++) {
        double part = yk_sum_norm(change[k]) / fmax(1, yk_sum_norm(x[k]));
        if (!(part <= most)) most = part; // also for NaN
    }
    return most;
}

// Takes a Newton step. Returns its relative size.
static double correct(const YkVec *places, bool is_fine, YkVec *x, YkVec *J, int *pivot)
{
    YkVec F[N];
    yk_alt_evaluate(places, x, F, J, NULL, NULL);
    if (is_fine) yk_alt_residual(places, x, F);
    if (!yk_complex_factor(N, J, pivot)) return INFINITY;
    yk_complex_solve(N, J, pivot, F);
    double size = relative(x, F);
    for (size_t k = 0; k < N; k++) x[k] = yk_sub(x[k], F[k]);
    return size;
}

static double polish(const YkVec *places, bool is_fine, YkVec *x)
{
    YkVec J[N * N], best[N];
    int pivot[N];
    double last = INFINITY;
    for (int k = 0; k < POLISHES; k++) {
        memcpy(best, x, sizeof best);
        double size = correct(places, is_fine, x, J, pivot);
        if (!(size < last)) { // rounding is reached, or there is no progress
            memcpy(x, best, sizeof best);
            return last;
        }
        last = size;
        if (size < 1e-15) break;
    }
    return last;
}

double yk_alt_polish(const YkVec *places, YkVec *x)
{
    return polish(places, false, x);
}

static void go_to(Path *p, double t)
{
    for (size_t k = 0; k < P; k++)
        p->at[k] = yk_vec(p->from[k].x + t * p->along[k].x, p->from[k].y + t * p->along[k].y);
}

// Computes dx/dt on the path at p->at.
static bool tangent(Path *p, const YkVec *x, YkVec *rate)
{
    YkVec F[N];
    yk_alt_evaluate(p->at, x, F, p->J, p->along, rate);
    if (!yk_complex_factor(N, p->J, p->pivot)) return false;
    yk_complex_solve(N, p->J, p->pivot, rate);
    for (size_t k = 0; k < N; k++) rate[k] = yk_scale(-1, rate[k]);
    return true;
}

static void step_along(const YkVec *x, double h, const YkVec *rate, YkVec *out)
{
    for (size_t k = 0; k < N; k++) out[k] = yk_vec(x[k].x + h * rate[k].x, x[k].y + h * rate[k].y);
}

// Predicts x at t + h by Runge and Kutta's method; `first` is the tangent at t. Leaves the places there.
static bool predict(Path *p, const YkVec *x, double t, double h, const YkVec *first, YkVec *out)
{
    YkVec second[N], third[N], fourth[N];
    go_to(p, t + 0.5 * h);
    step_along(x, 0.5 * h, first, out);
    if (!tangent(p, out, second)) return false;
    step_along(x, 0.5 * h, second, out);
    if (!tangent(p, out, third)) return false;
    go_to(p, t + h);
    step_along(x, h, third, out);
    if (!tangent(p, out, fourth)) return false;
    for (size_t k = 0; k < N; k++) {
        YkVec middle = yk_scale(2, yk_add(second[k], third[k]));
        out[k] = yk_add(x[k], yk_scale(h / 6, yk_add(yk_add(first[k], fourth[k]), middle)));
    }
    return true;
}

// Corrects a prediction. Returns the size of the first correction, or infinity if the corrections do not contract.
static double settle(Path *p, YkVec *x)
{
    const double enough = 1e-9, trust = 1e-3;
    double first = 0, last = INFINITY;
    for (int k = 0; k < CORRECTIONS; k++) {
        double size = correct(p->at, p->is_fine, x, p->J, p->pivot);
        if (k == 0) first = size;
        if (!(size < trust) || (k > 0 && !(size < 0.1 * last || size < enough))) return INFINITY;
        if (size < enough) return first;
        last = size;
    }
    return last < 1e-7 ? first : INFINITY;
}

static bool is_far(const YkVec *x)
{
    const double far = 1e8;
    for (size_t k = 0; k < N; k++)
        if (!(yk_sum_norm(x[k]) < far)) return true;
    return false;
}

bool yk_alt_follow(const YkAltPath *path, YkVec *x)
{
    const double aim = 1e-5, least = 1e-13;
    YkVec rate[N], next[N];
    Path p = {.from = path->from, .is_fine = path->is_fine};
    double t = 0, h = 0.02;
    uint64_t work = path->is_fine ? FINE_WORK : STEP_WORK;
    for (size_t k = 0; k < P; k++) p.along[k] = yk_sub(path->to[k], path->from[k]);
    for (int step = 0; t < 1; step++) {
        if (step == STEPS_MAX || is_far(x) || !yk_pace_spend(path->pace, work)) return false;
        go_to(&p, t);
        if (!tangent(&p, x, rate)) return false;
        double error = INFINITY;
        while (h > least) {
            h = fmin(h, 1 - t);
            error = predict(&p, x, t, h, rate, next) ? settle(&p, next) : INFINITY;
            if (error < 10 * aim) break;
            h *= 0.5;
        }
        if (!(h > least)) return false;
        t = h == 1 - t ? 1 : t + h;
        memcpy(x, next, sizeof next);
        // The error grows with h^5; its fifth root is near enough by steps.
        h *= error < aim / 1000 ? 3 : error < aim / 30 ? 1.8 : error < aim ? 1.2 : 0.7;
    }
    return polish(path->to, path->is_fine, x) < 1e-9;
}
