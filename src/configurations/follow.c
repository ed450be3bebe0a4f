// Predicts and corrects along a path of coefficients.
#include "configurations/follow.h"
#include "num/complex.h"
#include "num/homotopy.h"

enum {
    N_MAX = 2 * YK_SYSTEM_LOOPS_MAX,
    COEFFICIENTS_MAX = 2 * YK_SYSTEM_LOOPS_MAX * (N_MAX + 1),
    STEPS_MAX = 2000,
    POLISHES = 12
};
_Static_assert((int)N_MAX <= (int)YK_HOMOTOPY_UNKNOWNS, "a group's unknowns fit");

typedef struct Path {
    const YkShape *shape;
    const YkVec *from, *coefficients;
    YkVec along[COEFFICIENTS_MAX]; // to - from
    YkVec at[COEFFICIENTS_MAX];    // the coefficients at the last t asked for
    YkVec J[N_MAX * N_MAX];
    int pivot[N_MAX];
    size_t count;
    YkPace *pace;
} Path;

double yk_relative_change(const YkShape *shape, const YkVec *x, const YkVec *change)
{
    double most = 0;
    for (size_t k = 0; k < shape->unknowns; k++) {
        double part = yk_sum_norm(change[k]) / yk_unknown_size(shape, x, k);
        if (!(part <= most)) most = part; // also for NaN
    }
    return most;
}

// Takes a Newton step on the coefficients. Returns its relative size.
static double correct(void *context, YkVec *x)
{
    Path *p = context;
    YkVec F[N_MAX];
    size_t n = p->shape->unknowns;
    yk_system_evaluate(p->shape, p->coefficients, x, F, p->J);
    if (!yk_complex_factor(n, p->J, p->pivot)) return INFINITY;
    yk_complex_solve(n, p->J, p->pivot, F);
    double size = yk_relative_change(p->shape, x, F);
    for (size_t k = 0; k < n; k++) x[k] = yk_sub(x[k], F[k]);
    return size;
}

double yk_system_polish(const YkShape *shape, const YkVec *coefficients, YkVec *x)
{
    Path p;
    p.shape = shape;
    p.coefficients = coefficients;
    return yk_homotopy_polish(&(YkHomotopy){.n = shape->unknowns, .context = &p, .correct = correct}, POLISHES, x);
}

static void go_to(void *context, double t)
{
    Path *p = context;
    for (size_t k = 0; k < p->count; k++)
        p->at[k] = yk_vec(p->from[k].x + t * p->along[k].x, p->from[k].y + t * p->along[k].y);
}

static bool tangent(void *context, const YkVec *x, YkVec *rate)
{
    Path *p = context;
    YkVec F[N_MAX];
    size_t n = p->shape->unknowns;
    yk_system_evaluate(p->shape, p->at, x, F, p->J);
    if (!yk_complex_factor(n, p->J, p->pivot)) return false;
    yk_system_evaluate(p->shape, p->along, x, rate, NULL);
    for (size_t k = 0; k < n; k++) rate[k] = yk_scale(-1, rate[k]);
    yk_complex_solve(n, p->J, p->pivot, rate);
    return true;
}

static bool goes_on(void *context, const YkVec *x)
{
    const double far = 1e9;
    const Path *p = context;
    size_t n = p->shape->unknowns;
    for (size_t k = 0; k < n; k++) {
        double size = yk_sum_norm(x[k]);
        if (!(size < far) || (k < p->shape->angles && !(size > 1 / far))) return false;
    }
    return yk_pace_spend(p->pace, 6 * n * n * (n + 40));
}

bool yk_path_follow(const YkShape *shape, const YkVec *from, const YkVec *to, YkVec *x, YkPace *pace)
{
    Path p;
    p.shape = shape;
    p.from = from;
    p.coefficients = p.at;
    p.count = 2 * yk_coefficient_count(shape);
    p.pace = pace;
    for (size_t k = 0; k < p.count; k++) p.along[k] = yk_sub(to[k], from[k]);
    const YkHomotopy homotopy = {.n = shape->unknowns,
                                 .context = &p,
                                 .go_to = go_to,
                                 .tangent = tangent,
                                 .correct = correct,
                                 .goes_on = goes_on,
                                 .first_step = 0.1,
                                 .least_step = 1e-9,
                                 .steps = STEPS_MAX,
                                 .enough = 1e-11,
                                 .at_most = 1e-9};
    return yk_homotopy_follow(&homotopy, x) && yk_system_polish(shape, to, x) < 1e-10;
}
