// Predicts and corrects along a path of coefficients.
#include "num/homotopy.h"
#include <math.h>
#include <string.h>

enum { N = YK_HOMOTOPY_UNKNOWNS, CORRECTIONS = 3 };

static void step_along(size_t n, const YkVec *x, double h, const YkVec *rate, YkVec *out)
{
    for (size_t k = 0; k < n; k++) out[k] = yk_vec(x[k].x + h * rate[k].x, x[k].y + h * rate[k].y);
}

// Predicts x at t + h; `first` is the tangent at t. Leaves the coefficients there.
static bool predict(const YkHomotopy *p, const YkVec *x, double t, double h, const YkVec *first, YkVec *out)
{
    YkVec second[N], third[N], fourth[N];
    p->go_to(p->context, t + 0.5 * h);
    step_along(p->n, x, 0.5 * h, first, out);
    if (!p->tangent(p->context, out, second)) return false;
    step_along(p->n, x, 0.5 * h, second, out);
    if (!p->tangent(p->context, out, third)) return false;
    p->go_to(p->context, t + h);
    step_along(p->n, x, h, third, out);
    if (!p->tangent(p->context, out, fourth)) return false;
    for (size_t k = 0; k < p->n; k++) {
        YkVec middle = yk_scale(2, yk_add(second[k], third[k]));
        out[k] = yk_add(x[k], yk_scale(h / 6, yk_add(yk_add(first[k], fourth[k]), middle)));
    }
    return true;
}

// Corrects a prediction. Returns the size of the first correction, or infinity if the corrections do not contract.
static double settle(const YkHomotopy *p, YkVec *x)
{
    const double trust = 1e-3;
    double first = 0, last = INFINITY;
    for (int k = 0; k < CORRECTIONS; k++) {
        double size = p->correct(p->context, x);
        if (k == 0) first = size;
        if (!(size < trust) || (k > 0 && !(size < 0.1 * last || size < p->enough))) return INFINITY;
        if (size < p->enough) return first;
        last = size;
    }
    return last < p->at_most ? first : INFINITY;
}

bool yk_homotopy_follow(const YkHomotopy *p, YkVec *x)
{
    const double aim = 1e-5;
    YkVec rate[N], next[N];
    double t = 0, h = p->first_step;
    for (int step = 0; t < 1; step++) {
        if (step == p->steps || !p->goes_on(p->context, x)) return false;
        p->go_to(p->context, t);
        if (!p->tangent(p->context, x, rate)) return false;
        double error = INFINITY;
        while (h > p->least_step) {
            h = fmin(h, 1 - t);
            error = predict(p, x, t, h, rate, next) ? settle(p, next) : INFINITY;
            if (error < 10 * aim) break;
            h *= 0.5;
        }
        if (!(h > p->least_step)) return false;
        t = h == 1 - t ? 1 : t + h;
        memcpy(x, next, p->n * sizeof *x);
        // The error grows with h^5; its fifth root is near enough by steps.
        h *= error < aim / 1000 ? 3 : error < aim / 30 ? 1.8 : error < aim ? 1.2 : 0.7;
    }
    return true;
}

double yk_homotopy_polish(const YkHomotopy *p, int most, YkVec *x)
{
    YkVec best[N];
    double last = INFINITY;
    for (int k = 0; k < most; k++) {
        memcpy(best, x, p->n * sizeof *x);
        double size = p->correct(p->context, x);
        if (!(size < last)) {
            memcpy(x, best, p->n * sizeof *x);
            return last;
        }
        last = size;
        if (size < 1e-15) break;
    }
    return last;
}
