// Predicts and corrects along a path of coefficients.
#include "configurations/follow.h"
#include <string.h>
#include "num/complex.h"

enum {
    N_MAX = 2 * YK_SYSTEM_LOOPS_MAX,
    COEFFICIENTS_MAX = 2 * YK_SYSTEM_LOOPS_MAX * (N_MAX + 1),
    STEPS_MAX = 2000,
    CORRECTIONS = 3,
    POLISHES = 12
};

typedef struct Path {
    const YkShape *shape;
    const YkVec *from;
    YkVec along[COEFFICIENTS_MAX]; // to - from
    YkVec at[COEFFICIENTS_MAX];    // the coefficients at the last t asked for
    YkVec J[N_MAX * N_MAX];
    int pivot[N_MAX];
    size_t n, count;
} Path;

double yk_relative_change(const YkShape *shape, const YkVec *x, const YkVec *change)
{
    double most = 0;
    for (size_t k = 0; k < shape->unknowns; k++) {
        double size = yk_sum_norm(x[k]), part = yk_sum_norm(change[k]) / (k < shape->angles ? size : fmax(1, size));
        if (!(part <= most)) most = part; // also for NaN
    }
    return most;
}

// Takes a Newton step on the coefficients. Returns its relative size.
static double correct(const YkShape *shape, const YkVec *coefficients, YkVec *x, YkVec *J, int *pivot)
{
    YkVec F[N_MAX];
    size_t n = shape->unknowns;
    yk_system_evaluate(shape, coefficients, x, F, J);
    if (!yk_complex_factor(n, J, pivot)) return INFINITY;
    yk_complex_solve(n, J, pivot, F);
    double size = yk_relative_change(shape, x, F);
    for (size_t k = 0; k < n; k++) x[k] = yk_sub(x[k], F[k]);
    return size;
}

double yk_system_polish(const YkShape *shape, const YkVec *coefficients, YkVec *x)
{
    YkVec J[N_MAX * N_MAX], best[N_MAX];
    int pivot[N_MAX];
    double last = INFINITY;
    for (int k = 0; k < POLISHES; k++) {
        memcpy(best, x, shape->unknowns * sizeof *x);
        double size = correct(shape, coefficients, x, J, pivot);
        if (!(size < last)) { // rounding reached, or no progress
            memcpy(x, best, shape->unknowns * sizeof *x);
            return last;
        }
        last = size;
        if (size < 1e-15) break;
    }
    return last;
}

static void go_to(Path *p, double t)
{
    for (size_t k = 0; k < p->count; k++)
        p->at[k] = yk_vec(p->from[k].x + t * p->along[k].x, p->from[k].y + t * p->along[k].y);
}

// Computes dx/dt on the path, with the coefficients at p->at.
static bool tangent(Path *p, const YkVec *x, YkVec *rate)
{
    YkVec F[N_MAX];
    yk_system_evaluate(p->shape, p->at, x, F, p->J);
    if (!yk_complex_factor(p->n, p->J, p->pivot)) return false;
    yk_system_evaluate(p->shape, p->along, x, rate, NULL);
    for (size_t k = 0; k < p->n; k++) rate[k] = yk_scale(-1, rate[k]);
    yk_complex_solve(p->n, p->J, p->pivot, rate);
    return true;
}

static void step_along(size_t n, const YkVec *x, double h, const YkVec *rate, YkVec *out)
{
    for (size_t k = 0; k < n; k++) out[k] = yk_vec(x[k].x + h * rate[k].x, x[k].y + h * rate[k].y);
}

// Predicts x at t + h; `first` is the tangent at t. Leaves the coefficients there.
static bool predict(Path *p, const YkVec *x, double t, double h, const YkVec *first, YkVec *out)
{
    YkVec second[N_MAX], third[N_MAX], fourth[N_MAX];
    go_to(p, t + 0.5 * h);
    step_along(p->n, x, 0.5 * h, first, out);
    if (!tangent(p, out, second)) return false;
    step_along(p->n, x, 0.5 * h, second, out);
    if (!tangent(p, out, third)) return false;
    go_to(p, t + h);
    step_along(p->n, x, h, third, out);
    if (!tangent(p, out, fourth)) return false;
    for (size_t k = 0; k < p->n; k++) {
        YkVec middle = yk_scale(2, yk_add(second[k], third[k]));
        out[k] = yk_add(x[k], yk_scale(h / 6, yk_add(yk_add(first[k], fourth[k]), middle)));
    }
    return true;
}

// Corrects a prediction. Returns the size of the first correction, or infinity if the corrections do not contract.
static double settle(Path *p, YkVec *x)
{
    const double enough = 1e-11, trust = 1e-3;
    double first = 0, last = INFINITY;
    for (int k = 0; k < CORRECTIONS; k++) {
        double size = correct(p->shape, p->at, x, p->J, p->pivot);
        if (k == 0) first = size;
        if (!(size < trust) || (k > 0 && !(size < 0.1 * last || size < enough))) return INFINITY;
        if (size < enough) return first;
        last = size;
    }
    return last < 1e-9 ? first : INFINITY;
}

static bool is_far(const YkShape *shape, const YkVec *x)
{
    const double far = 1e9;
    for (size_t k = 0; k < shape->unknowns; k++) {
        double size = yk_sum_norm(x[k]);
        if (!(size < far) || (k < shape->angles && !(size > 1 / far))) return true;
    }
    return false;
}

bool yk_path_follow(const YkShape *shape, const YkVec *from, const YkVec *to, YkVec *x, YkPace *pace)
{
    const double aim = 1e-5, least = 1e-9;
    YkVec rate[N_MAX], next[N_MAX];
    Path p = {.shape = shape, .from = from, .n = shape->unknowns, .count = 2 * yk_coefficient_count(shape)};
    double t = 0, h = 0.1;
    for (size_t k = 0; k < p.count; k++) p.along[k] = yk_sub(to[k], from[k]);
    for (int step = 0; t < 1; step++) {
        if (step == STEPS_MAX || is_far(shape, x) || !yk_pace_spend(pace, 6 * p.n * p.n * (p.n + 40))) return false;
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
        memcpy(x, next, p.n * sizeof *x);
        // The error grows with h^5; its fifth root is near enough by steps.
        h *= error < aim / 1000 ? 3 : error < aim / 30 ? 1.8 : error < aim ? 1.2 : 0.7;
    }
    return yk_system_polish(shape, to, x) < 1e-10;
}
