// Predicts and corrects along a path of places.
#include "num/homotopy.h"
#include "synthesis/nine_points/alt.h"

enum { N = YK_ALT_SIZE, P = YK_ALT_PLACES, STEPS_MAX = 4000, STEP_WORK = 16000, FINE_WORK = 200000, POLISHES = 14 };

typedef struct Path {
    const YkAltPath *path;
    YkVec along[P], at[P]; // to - from; the places at the last t asked for
    const YkVec *places;
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
static double correct(void *context, YkVec *x)
{
    Path *p = context;
    YkVec F[N];
    yk_alt_evaluate(p->places, x, F, p->J, NULL, NULL);
    if (p->is_fine) yk_alt_residual(p->places, x, F);
    if (!yk_complex_factor(N, p->J, p->pivot)) return INFINITY;
    yk_complex_solve(N, p->J, p->pivot, F);
    double size = relative(x, F);
    for (size_t k = 0; k < N; k++) x[k] = yk_sub(x[k], F[k]);
    return size;
}

static double polish(const YkVec *places, bool is_fine, YkVec *x)
{
    Path p;
    p.places = places;
    p.is_fine = is_fine;
    return yk_homotopy_polish(&(YkHomotopy){.n = N, .context = &p, .correct = correct}, POLISHES, x);
}

double yk_alt_polish(const YkVec *places, YkVec *x)
{
    return polish(places, false, x);
}

static void go_to(void *context, double t)
{
    Path *p = context;
    const YkVec *from = p->path->from;
    for (size_t k = 0; k < P; k++) p->at[k] = yk_vec(from[k].x + t * p->along[k].x, from[k].y + t * p->along[k].y);
}

static bool tangent(void *context, const YkVec *x, YkVec *rate)
{
    Path *p = context;
    YkVec F[N];
    yk_alt_evaluate(p->at, x, F, p->J, p->along, rate);
    if (!yk_complex_factor(N, p->J, p->pivot)) return false;
    yk_complex_solve(N, p->J, p->pivot, rate);
    for (size_t k = 0; k < N; k++) rate[k] = yk_scale(-1, rate[k]);
    return true;
}

static bool goes_on(void *context, const YkVec *x)
{
    const double far = 1e8;
    const Path *p = context;
    for (size_t k = 0; k < N; k++)
        if (!(yk_sum_norm(x[k]) < far)) return false;
    return yk_pace_spend(p->path->pace, p->is_fine ? FINE_WORK : STEP_WORK);
}

bool yk_alt_follow(const YkAltPath *path, YkVec *x)
{
    Path p;
    p.path = path;
    p.places = p.at;
    p.is_fine = path->is_fine;
    for (size_t k = 0; k < P; k++) p.along[k] = yk_sub(path->to[k], path->from[k]);
    const YkHomotopy homotopy = {.n = N,
                                 .context = &p,
                                 .go_to = go_to,
                                 .tangent = tangent,
                                 .correct = correct,
                                 .goes_on = goes_on,
                                 .first_step = 0.02,
                                 .least_step = 1e-13,
                                 .steps = STEPS_MAX,
                                 .enough = 1e-9,
                                 .at_most = 1e-7};
    return yk_homotopy_follow(&homotopy, x) && polish(path->to, path->is_fine, x) < 1e-9;
}
