// Bars to begin with. The ratios of a bar's lengths and the input's angles from the ground are drawn. The rest, which
// is the pivot, size and direction of the bar and the coupler point, enters the path linearly, as complex numbers:
// P = A0 + S e^(i theta) + Q e^(i phi). If dimensions have bounds, every second bar is drawn within them.
#include "synthesis/paths/path_chain.h"
#include "synthesis/paths/path_start.h"
#include <math.h>
#include <string.h>
#include "base/mix.h"
#include "elementary/elementary.h"
#include "num/dense.h"

static double between(uint64_t *seed, double low, double high)
{
    return low + (high - low) * yk_mix_unit(seed);
}

static double ratio(uint64_t *seed)
{
    return yk_exp(between(seed, -2, 2));
}

// Draws the input's angles: given, or a start with a step, or growing with the way along the points and their number.
static void draw_angles(const YkPathProblem *problem, uint64_t *seed, double *angle)
{
    const YkPathTask *path = &problem->task->path;
    size_t n = problem->count;
    double start = between(seed, -YK_PI, YK_PI), way = 0, gone = 0, sense = yk_mix_next(seed) & 1 ? 1 : -1;
    double mix = yk_mix_unit(seed), span = between(seed, 0.1, 2 * YK_PI * 0.97);
    if (problem->angle) {
        memcpy(angle, problem->angle, n * sizeof *angle);
        return;
    }
    bool is_round = path->is_closed || yk_norm(yk_sub(problem->point[n - 1], problem->point[0])) < 1e-9 * problem->size;
    for (size_t k = 1; k < n; k++) way += yk_norm(yk_sub(problem->point[k], problem->point[k - 1]));
    double last = path->is_closed ? yk_norm(yk_sub(problem->point[n - 1], problem->point[0])) : 0;
    double steps = path->is_closed ? (double)n : (double)n - 1;
    if (is_round) span = 2 * YK_PI;
    for (size_t k = 0; k < n; k++) {
        if (k > 0) gone += yk_norm(yk_sub(problem->point[k], problem->point[k - 1]));
        double part = mix * (double)k / steps + (1 - mix) * gone / (way + last);
        if (problem->task->any_order && !is_round) part = yk_mix_unit(seed);
        angle[k] = start + (problem->shifts ? problem->step * (double)k : sense * span * part);
    }
}

// Draws the ratios of the lengths to the input's.
static void draw_shape(const YkPathProblem *problem, uint64_t *seed, YkBar *bar)
{
    double *v = bar->v;
    v[YK_BAR_INPUT] = 1;
    v[YK_BAR_COUPLER] = ratio(seed);
    v[YK_BAR_OUTPUT] = ratio(seed);
    v[YK_BAR_GROUND] = ratio(seed);
    if (problem->kind == YK_DESIGN_SLIDER_CRANK) v[YK_BAR_GROUND] = between(seed, -2, 2);
    if (problem->kind == YK_DESIGN_INVERTED) v[YK_BAR_OUTPUT] = between(seed, -1, 1) * fabs(v[YK_BAR_GROUND] - 1);
    if (problem->kind == YK_DESIGN_INVERTED) v[YK_BAR_COUPLER] = 1;
    bar->branch = yk_mix_next(seed) & 1 ? 1 : -1;
    if (problem->kind == YK_DESIGN_INVERTED)
        bar->branch = 1; // the other one is the same machine, its coupler's axes reversed
}

// Draws a place near a link of some length.
static void draw_place(uint64_t *seed, double length, double *u, double *v)
{
    YkVec at = yk_scale(length * yk_exp(between(seed, -1.2, 0.8)), yk_unit(between(seed, -YK_PI, YK_PI)));
    *u = at.x;
    *v = at.y;
}

// Draws a first loop whose input turns through where the task asks for that.
static bool draw_first_loop(const YkPathProblem *problem, uint64_t *seed, YkBar *bar)
{
    enum { TRIES = 40 };
    double excess[YK_PATH_LIMITS], by[YK_PATH_LIMITS][YK_BAR_SIZE];
    for (size_t k = 0; k < TRIES; k++) {
        bar->v[YK_BAR_COUPLER] = ratio(seed);
        bar->v[YK_BAR_OUTPUT] = ratio(seed);
        bar->v[YK_BAR_GROUND] = ratio(seed);
        if (!problem->turns || !yk_bar_has_loop(bar->kind)) return true;
        size_t count = yk_path_limits(problem, bar, excess, by);
        bool is_inside = true;
        for (size_t i = 0; i < count && i < 3; i++)
            is_inside = is_inside && excess[i] < 0; // those of turning come first
        if (is_inside) return true;
    }
    return false;
}

// Draws lengths of link and arm with which the dyad closes all round, from the least and largest distance of its ends.
static void draw_dyad(uint64_t *seed, double least, double most, YkBar *bar)
{
    double sum = most * (1 + yk_exp(between(seed, -3.5, 0.7))), difference = 0.95 * least * between(seed, -1, 1);
    bar->v[YK_BAR_LINK] = (sum + difference) / 2;
    bar->v[YK_BAR_ARM] = (sum - difference) / 2;
    bar->bend = yk_mix_next(seed) & 1 ? 1 : -1;
}

// Draws the shape of a machine with a dyad: an input of length 1, and places in terms of it. The direction of its
// ground and all angles are those of the try.
static bool draw_chain(const YkPathProblem *problem, uint64_t *seed, YkPathTry *try)
{
    double *v = try->bar.v, least = INFINITY, most = 0;
    YkBar *bar = &try->bar;
    v[YK_BAR_INPUT] = 1;
    bar->branch = yk_mix_next(seed) & 1 ? 1 : -1;
    bar->variant = (int)(yk_mix_next(seed) % yk_chain_variants(bar->kind));
    YkChainVariant variant = yk_chain_variant(bar->kind, bar->variant);
    const YkChainBody ends[] = {variant.link, variant.arm};
    if (!draw_first_loop(problem, seed, bar)) return false;
    const double lengths[] = {v[YK_BAR_GROUND], 1, v[YK_BAR_COUPLER], v[YK_BAR_OUTPUT]};
    if (bar->kind == YK_DESIGN_GEARED) {
        v[YK_BAR_CU] = between(seed, -YK_PI, YK_PI);
        v[YK_BAR_COUPLER] = 1;
    } else {
        draw_place(seed, lengths[ends[0]], &v[YK_BAR_CU], &v[YK_BAR_CV]);
        draw_place(seed, lengths[ends[1]], &v[YK_BAR_DU], &v[YK_BAR_DV]);
    }
    for (size_t k = 0; k < problem->count; k++) {
        YkVec end[2];
        if (!yk_chain_ends(bar, try->angle[k], end)) return false;
        double apart = yk_norm(yk_sub(end[1], end[0]));
        least = fmin(least, apart);
        most = fmax(most, apart);
    }
    draw_dyad(seed, least, most, bar);
    return true;
}

// Keeps the dimensions within their bounds.
static void clip(const YkPathProblem *problem, YkBar *bar)
{
    for (size_t j = 0; j < problem->dimensions; j++)
        bar->v[j] = fmin(fmax(bar->v[j], problem->low[j]), problem->high[j]);
}

// Columns of the linear problem: which of A0, S, Q they are.
typedef struct Columns {
    double *A, *b;
    size_t count;
    bool has_pivot, has_turn; // free: the pivot, the direction
} Columns;

static void add_rows(const Columns *c, size_t k, YkVec at, YkVec crank, YkVec coupler)
{
    for (size_t i = 0; i < 2; i++) {
        double *row = &c->A[(2 * k + i) * c->count];
        if (c->has_pivot) *row++ = i == 0;
        if (c->has_pivot) *row++ = i == 1;
        *row++ = i == 0 ? crank.x : crank.y;
        if (c->has_turn) *row++ = i == 0 ? -crank.y : crank.x;
        *row++ = i == 0 ? coupler.x : coupler.y;
        *row = i == 0 ? -coupler.y : coupler.x;
        c->b[2 * k + i] = i == 0 ? at.x : at.y;
    }
}

// Finds pivot, size, direction and coupler point. The angles become absolute.
static bool place(const YkPathProblem *problem, YkPathWork *work, YkPathTry *try, bool is_turned)
{
    double *v = try->bar.v, x[6], tau[6], shift = 0;
    size_t order[6], n = problem->count;
    bool has_pivot = !(problem->task->path.pivot[0].is_given && !problem->hangs_at_end);
    Columns c = {work->A, work->b, (size_t)(3 + 2 * has_pivot + is_turned), has_pivot, is_turned};
    YkVec pivot = has_pivot ? yk_vec(0, 0) : problem->task->path.pivot[0].at, u, origin;
    if (2 * n < c.count) return false;
    for (size_t k = 0; k < n; k++) {
        if (!yk_bar_frame(&try->bar, try->angle[k], &origin, &u)) return false;
        add_rows(&c, k, yk_sub(problem->point[k], pivot), origin, u);
    }
    size_t rank = yk_qr_factor(2 * n, c.count, c.A, order, tau, 1e-12);
    yk_qr_solve(2 * n, c.count, c.A, order, tau, rank, c.b, x);
    const double *at = x;
    if (has_pivot) pivot = yk_vec(at[0], at[1]);
    if (has_pivot) at += 2;
    YkVec S = yk_vec(at[0], is_turned ? at[1] : 0);
    at += 1 + is_turned;
    double size = is_turned ? yk_norm(S) : S.x;
    if (!(size > 1e-9 * problem->size)) return false;
    if (is_turned) shift = yk_atan2(S.y, S.x);
    YkVec p = yk_mul(yk_unit(-shift), yk_vec(at[0], at[1]));
    for (size_t k = 0; k < n && is_turned; k++) try->angle[k] += shift;
    v[YK_BAR_TURN] += shift;
    v[YK_BAR_GROUND] *= size;
    v[YK_BAR_INPUT] = size;
    v[YK_BAR_COUPLER] *= size;
    v[YK_BAR_OUTPUT] *= size;
    for (int j = YK_BAR_CU; j < YK_BAR_SIZE; j++)
        if (j != YK_BAR_CU || problem->kind != YK_DESIGN_GEARED) v[j] *= size; // there it is a phase
    v[YK_BAR_PX] = p.x;
    v[YK_BAR_PY] = p.y;
    if (problem->hangs_at_end) pivot = yk_add(pivot, yk_scale(v[YK_BAR_GROUND], yk_unit(v[YK_BAR_TURN])));
    v[YK_BAR_X] = pivot.x;
    v[YK_BAR_Y] = pivot.y;
    return true;
}

// Pivots and coupler points with wide bounds are drawn near the points.
static void draw_in_box(const YkPathProblem *problem, uint64_t *seed, YkBar *bar)
{
    for (size_t j = 0; j < YK_BAR_SIZE; j++) {
        bool is_length = j == YK_BAR_GROUND || (j >= YK_BAR_INPUT && j <= YK_BAR_OUTPUT);
        double middle = j == YK_BAR_X ? problem->middle.x : j == YK_BAR_Y ? problem->middle.y : 0;
        double reach = j == YK_BAR_TURN ? YK_PI : is_length ? INFINITY : 4 * problem->size;
        double low = fmax(problem->low[j], middle - reach), high = fmin(problem->high[j], middle + reach);
        bar->v[j] = low < high ? between(seed, low, high) : problem->low[j];
    }
    bar->branch = yk_mix_next(seed) & 1 ? 1 : -1;
}

// Returns whether the limits are met nearly, so that the first steps can meet them.
static bool is_near_limits(const YkPathProblem *problem, const YkBar *bar)
{
    double excess[YK_PATH_LIMITS], by[YK_PATH_LIMITS][YK_BAR_SIZE];
    size_t count = problem->turns ? yk_path_limits(problem, bar, excess, by) : 0;
    for (size_t k = 0; k < count; k++)
        if (excess[k] > 0.3 * bar->v[YK_BAR_COUPLER]) return false;
    return true;
}

static bool has_turn(const YkPathProblem *problem)
{
    return (!problem->angle || problem->follows) && !problem->task->path.ground_angle.is_given;
}

// Draws all numbers of a bar. Returns whether it is drawn within its bounds; otherwise these are ratios.
// is_drawn: false if a machine with a dyad does not close.
static bool draw_numbers(const YkPathProblem *problem, uint64_t *seed, YkPathTry *try, bool *is_drawn)
{
    *is_drawn = true;
    const YkPathTask *path = &problem->task->path;
    try->bar = (YkBar){.kind = problem->kind, .hangs_at_end = problem->hangs_at_end};
    draw_angles(problem, seed, try->angle);
    bool is_chain = problem->dimensions > YK_BAR_PLAIN;
    bool is_in_box = !is_chain && problem->task->lengths.is_given && yk_mix_next(seed) & 1;
    if (is_in_box) {
        draw_in_box(problem, seed, &try->bar);
        return true;
    }
    if (!is_chain) draw_shape(problem, seed, &try->bar);
    try->bar.v[YK_BAR_TURN] = path->ground_angle.is_given ? path->ground_angle.value
                              : has_turn(problem)         ? 0
                                                          : between(seed, -YK_PI, YK_PI);
    yk_path_turn_angles(problem, try);
    *is_drawn = !is_chain || draw_chain(problem, seed, try);
    return false;
}

void yk_path_skip(const YkPathProblem *problem, uint64_t *seed, YkPathTry *scratch)
{
    bool is_drawn;
    draw_numbers(problem, seed, scratch, &is_drawn);
}

bool yk_path_draw(const YkPathProblem *problem, YkPathWork *work, uint64_t *seed, YkPathTry *try)
{
    bool is_drawn, is_in_box = draw_numbers(problem, seed, try, &is_drawn);
    if (!is_drawn) return false;
    if (!is_in_box) {
        if (!is_near_limits(problem, &try->bar) || !place(problem, work, try, has_turn(problem))) return false;
        clip(problem, &try->bar);
    }
    return is_near_limits(problem, &try->bar) && yk_path_measure(problem, work, try);
}
