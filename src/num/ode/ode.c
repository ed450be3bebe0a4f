// Steppers for ordinary differential equations: options, memory, start, and values within the last step.
#include "num/ode/ode_internal.h"
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

// Memory is one block, cut into columns of n that begin at a cache line. Long columns get an extra line, which keeps
// them from competing for the same places in the cache (n a power of two).
typedef struct Cutter {
    unsigned char *memory; // NULL: count only
    size_t used;
    bool overflow;
} Cutter;

static void *cut(Cutter *cutter, size_t count, size_t size)
{
    size_t most = SIZE_MAX / 4;
    if (count > most / size || cutter->used > most - count * size - 192) {
        cutter->overflow = true;
        return NULL;
    }
    void *piece = cutter->memory ? cutter->memory + cutter->used : NULL;
    cutter->used += (count * size + 63) / 64 * 64 + (count * size > 4096 ? 64 : 0);
    return piece;
}

static void cut_square(Cutter *cutter, size_t rows, size_t columns, double **matrix)
{
    if (columns && rows > SIZE_MAX / 16 / columns)
        cutter->overflow = true;
    else
        *matrix = cut(cutter, rows * columns, sizeof(double));
}

static void cut_columns(Cutter *cutter, size_t n, size_t count, double **column)
{
    for (size_t i = 0; i < count; i++) column[i] = cut(cutter, n, sizeof(double));
}

static void cut_newton(Cutter *cutter, const YkOde *ode, YkOdeNewton *newton)
{
    size_t m = ode->controlled;
    cut_square(cutter, m, ode->n, &newton->J);
    cut_square(cutter, m, m, &newton->E);
    newton->residual = cut(cutter, m, sizeof(double));
    newton->scratch = cut(cutter, m, sizeof(double));
    newton->guess = cut(cutter, ode->n, sizeof(double));
    newton->pivot = cut(cutter, m, sizeof(int));
}

static void cut_all(Cutter *cutter, YkOde *ode)
{
    double **const column[] = {&ode->y, &ode->rate, &ode->y_previous, &ode->rate_previous, &ode->z, &ode->z_rate};
    size_t n = ode->n;
    for (size_t i = 0; i < sizeof column / sizeof *column; i++) cut_columns(cutter, n, 1, column[i]);
    ode->floor = cut(cutter, ode->controlled, sizeof(double));
    switch (ode->options.method) {
    case YK_ODE_DOP853: // stages 0 and 12 are the rates at the two ends
        cut_columns(cutter, n, 11, ode->stage + 1);
        cut_columns(cutter, n, 3, ode->stage + 13);
        cut_columns(cutter, n, 7, ode->dense);
        break;
    case YK_ODE_SDIRK4:
        cut_columns(cutter, n, 6, ode->stage);
        cut_newton(cutter, ode, &ode->newton);
        break;
    case YK_ODE_RK4:
        cut_columns(cutter, n, 3, ode->stage);
        break;
    }
}

static bool get_memory(YkOde *ode)
{
    Cutter cutter = {0};
    cut_all(&cutter, ode);
    if (cutter.overflow) return false;
    ode->memory = calloc(1, cutter.used + 64);
    if (!ode->memory) return false;
    size_t off = (size_t)((uintptr_t)ode->memory & 63);
    cutter = (Cutter){.memory = (unsigned char *)ode->memory + (off ? 64 - off : 0)};
    cut_all(&cutter, ode);
    return true;
}

static bool positive(double x)
{
    return x > 0 && x <= DBL_MAX;
}
static bool not_negative(double x)
{
    return x >= 0 && x <= DBL_MAX;
}

// Returns whether the options suffice: tolerances for the methods with error control, a step for the method without.
static bool options_make_sense(size_t n, const YkOdeOptions *o)
{
    if (n == 0 || o->controlled > n) return false;
    if (!not_negative(o->first_step) || !not_negative(o->largest_step)) return false;
    if (!not_negative(o->relative) || !not_negative(o->absolute)) return false;
    if (o->method == YK_ODE_RK4) return positive(o->fixed_step);
    if (o->method != YK_ODE_DOP853 && o->method != YK_ODE_SDIRK4) return false;
    return o->relative > 0 || o->absolute > 0;
}

YkOde *yk_ode_new(size_t n, const YkOdeOptions *options, YkOdeFunction f, void *context)
{
    if (!options_make_sense(n, options)) return NULL;
    YkOde *ode = calloc(1, sizeof *ode);
    if (!ode) return NULL;
    *ode = (YkOde){.options = *options, .n = n, .f = f, .context = context};
    ode->controlled = options->controlled ? options->controlled : n;
    ode->room = n + n % 2;
    if (!get_memory(ode)) {
        free(ode);
        return NULL;
    }
    for (size_t j = 0; j < ode->controlled; j++)
        ode->floor[j] = options->absolute * (options->scale ? fabs(options->scale[j]) : 1);
    ode->options.scale = NULL; // copied; the caller may free its array
    return ode;
}

void yk_ode_free(YkOde *ode)
{
    if (!ode) return;
    free(ode->memory);
    free(ode);
}

void yk_ode_set_context(YkOde *ode, void *context)
{
    ode->context = context;
}

YkOdeStatus yk_ode_start(YkOde *ode, double t, const double *y, double t_end, bool keep_step)
{
    ode->started = false;
    if (!yk_ode_finite(ode->n, y) || !(fabs(t) <= DBL_MAX) || !(fabs(t_end) <= DBL_MAX)) return YK_ODE_FAILED;
    memmove(ode->y, y, ode->n * sizeof *y);
    ode->t = ode->previous = ode->start = ode->grid = t;
    ode->end = t_end;
    ode->direction = t_end > t ? 1 : t_end < t ? -1 : 0;
    ode->even = ode->length = 0;
    ode->dense_ready = false;
    ode->newton.fresh = false;
    if (!keep_step) {
        ode->h = 0;
        ode->newton.known = false;
    }
    ode->started = yk_ode_evaluate(ode, t, ode->y, ode->rate) && yk_ode_finite(ode->n, ode->rate);
    return ode->started ? YK_ODE_OK : YK_ODE_FAILED;
}

void yk_ode_set_end(YkOde *ode, double t_end)
{
    if (!(fabs(t_end) <= DBL_MAX)) return;
    if (ode->direction == 0 || (ode->t == ode->start && ode->length == 0))
        ode->direction = t_end > ode->t ? 1 : t_end < ode->t ? -1 : 0;
    ode->end = (t_end - ode->t) * ode->direction > 0 ? t_end : ode->t;
}

double yk_ode_length(const YkOde *ode)
{
    return ode->h;
}
double yk_ode_time(const YkOde *ode)
{
    return ode->t;
}
double yk_ode_previous(const YkOde *ode)
{
    return ode->previous;
}
const double *yk_ode_state(const YkOde *ode)
{
    return ode->y;
}
const double *yk_ode_rate(const YkOde *ode)
{
    return ode->rate;
}
YkOdeCounts yk_ode_counts(const YkOde *ode)
{
    return ode->counts;
}

YkOdeStatus yk_ode_dense(YkOde *ode, double t, double *y)
{
    double rounding = 4 * DBL_EPSILON * fmax(fabs(ode->t), fabs(ode->previous));
    double s = ode->length != 0 ? (t - ode->previous) / ode->length : 1;
    bool at_end = t == ode->t || (s >= 1 && fabs(t - ode->t) <= rounding);
    bool at_start = t == ode->previous || (s <= 0 && fabs(t - ode->previous) <= rounding);
    if (at_end || at_start) {
        memcpy(y, at_end ? ode->y : ode->y_previous, ode->n * sizeof *y);
        return YK_ODE_OK;
    }
    if (!(s > 0 && s < 1)) return YK_ODE_FAILED; // t lies outside the step
    switch (ode->options.method) {
    case YK_ODE_DOP853:
        return yk_ode_dop853_dense(ode, s, y);
    case YK_ODE_SDIRK4:
        yk_ode_sdirk4_dense(ode, s, y);
        break;
    case YK_ODE_RK4:
        yk_ode_rk4_dense(ode, s, y);
        break;
    }
    return YK_ODE_OK;
}
