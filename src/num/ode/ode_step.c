// Step control: the first length, the next length, and when to give up. Hairer, Norsett & Wanner 1993, II.4.
#include "num/ode/ode_internal.h"
#include <string.h>

// How the length follows the error: h <- h * safety * error^(-1/order), within bounds. The orders are powers of two, so
// that all roots are square roots, with the same bits everywhere.
typedef struct Control {
    int roots; // order = 2^roots
    double safety;
    double shrink, grow; // bounds of the change
} Control;

static Control control_of(YkOdeMethod method)
{
    if (method == YK_ODE_DOP853) return (Control){3, 0.9, 0.333, 6};
    return (Control){2, 0.9, 0.2, 5};
}

static double root(double x, int roots)
{
    for (int i = 0; i < roots; i++) x = sqrt(x);
    return x;
}

// Returns the shortest step that time resolves. A far end says nothing about the motion: beyond one unit of time it
// does not count.
static double smallest_length(const YkOde *ode)
{
    return 1e-14 * fmax(fmin(fabs(ode->end - ode->start), 1), fabs(ode->t));
}

static double bounded_length(const YkOde *ode, double h)
{
    double largest = ode->options.largest_step;
    return largest > 0 && h > largest ? largest : h;
}

// Returns the root mean square over the controlled components of v - w (w NULL: of v), relative to the errors allowed
// at y.
static double norm_at_start(const YkOde *ode, const double *v, const double *w)
{
    double sum = 0;
    for (size_t j = 0; j < ode->controlled; j++) {
        double e = (w ? v[j] - w[j] : v[j]) / yk_ode_allowed(ode, j, ode->y[j], ode->y[j]);
        sum += e * e;
    }
    return sqrt(sum / (double)ode->controlled);
}

// Evaluates f after an explicit Euler step; takes a shorter one if f fails.
static bool explore(YkOde *ode, double *h)
{
    for (int i = 0; i < 12; i++, *h *= 0.25) {
        for (size_t j = 0; j < ode->n; j++) ode->z[j] = ode->y[j] + ode->direction * *h * ode->rate[j];
        if (yk_ode_evaluate(ode, ode->t + ode->direction * *h, ode->z, ode->z_rate) &&
            yk_ode_finite(ode->n, ode->z_rate))
            return true;
    }
    return false;
}

// Returns the starting step of Hairer, Norsett & Wanner 1993, II.4: from the first derivative, and the second by one
// explicit step.
static double first_length(YkOde *ode)
{
    double span = bounded_length(ode, fabs(ode->end - ode->t));
    double smallest = 16 * smallest_length(ode);
    if (ode->options.first_step > 0) return fmin(fmax(ode->options.first_step, smallest), span);
    int roots = control_of(ode->options.method).roots;
    double size = norm_at_start(ode, ode->y, NULL), speed = norm_at_start(ode, ode->rate, NULL);
    double h = size <= 1e-5 || speed <= 1e-5 ? 1e-6 : 0.01 * size / speed;
    h = fmin(h, span);
    if (!explore(ode, &h)) return fmax(h, smallest);
    double change = fmax(norm_at_start(ode, ode->z_rate, ode->rate) / h, speed);
    double second = change <= 1e-15 ? fmax(1e-6, h * 1e-3) : root(0.01 / change, roots);
    h = fmin(fmin(100 * h, second), span);
    return h > 0 ? fmax(h, smallest) : smallest;
}

// Returns the signed length of the step to try. *to_end: it reaches the end (stretched by up to a hundredth to do so,
// or by rounding if it is already the longest allowed).
static double next_length(const YkOde *ode, bool *to_end)
{
    double left = fabs(ode->end - ode->t), rounding = 1 + 1e-9;
    *to_end = 1.01 * ode->h >= left && bounded_length(ode, left) * rounding >= left;
    return ode->direction * (*to_end ? left : ode->h);
}

static YkOdeTrial try_step(YkOde *ode, double h, double t_new, double *error)
{
    bool explicitly = ode->options.method == YK_ODE_DOP853;
    YkOdeTrial trial = explicitly ? yk_ode_dop853_try(ode, h, error) : yk_ode_sdirk4_try(ode, h, error);
    if (trial != YK_TRIAL_DONE) return trial;
    if (!(*error <= DBL_MAX) || !yk_ode_finite(ode->n, ode->z)) return YK_TRIAL_F_FAILED;
    if (*error > 1) return YK_TRIAL_DONE;
    bool fine = yk_ode_evaluate(ode, t_new, ode->z, ode->z_rate) && yk_ode_finite(ode->n, ode->z_rate);
    return fine ? YK_TRIAL_DONE : YK_TRIAL_F_FAILED;
}

static void accept(YkOde *ode, double h, double t_new)
{
    size_t size = ode->n * sizeof(double);
    memcpy(ode->y_previous, ode->y, size);
    memcpy(ode->rate_previous, ode->rate, size);
    memcpy(ode->y, ode->z, size);
    memcpy(ode->rate, ode->z_rate, size);
    ode->previous = ode->t;
    ode->t = t_new;
    ode->length = h;
    ode->dense_ready = false;
    ode->newton.fresh = false;
    ode->counts.steps++;
}

static double longer(const YkOde *ode, double h, double error)
{
    Control control = control_of(ode->options.method);
    double factor = error > 0 ? control.safety / root(error, control.roots) : control.grow;
    factor = fmin(control.grow, fmax(control.shrink, factor));
    // Not worth growing a little: reusing the factors of the implicit method saves more. Hairer & Wanner 1996, IV.8.
    if (ode->options.method == YK_ODE_SDIRK4 && factor >= 1 && factor <= 1.2) factor = 1;
    return bounded_length(ode, h * factor);
}

static double shorter(const YkOde *ode, double h, YkOdeTrial trial, double error)
{
    Control control = control_of(ode->options.method);
    if (trial == YK_TRIAL_F_FAILED) return h * 0.25;
    if (trial == YK_TRIAL_DIVERGED) return h * 0.5;
    return h * fmax(control.shrink, control.safety / root(error, control.roots));
}

// Gives up: y stays as it was, and there is no last step to evaluate.
static YkOdeStatus give_up(YkOde *ode, YkOdeTrial reason)
{
    ode->h = ode->length = 0;
    ode->previous = ode->t;
    ode->newton.known = false;
    return reason == YK_TRIAL_F_FAILED ? YK_ODE_FAILED : YK_ODE_STEP_TOO_SMALL;
}

static YkOdeStatus controlled_step(YkOde *ode)
{
    YkOdeTrial trial = YK_TRIAL_DONE;
    bool rejected = false;
    if (ode->h == 0) ode->h = first_length(ode);
    ode->h = bounded_length(ode, ode->h);
    for (;;) {
        bool to_end;
        double h = next_length(ode, &to_end), error = 0;
        if (!to_end && !(ode->h >= smallest_length(ode))) return give_up(ode, trial);
        double t_new = to_end ? ode->end : ode->t + h;
        trial = try_step(ode, h, t_new, &error);
        if (trial == YK_TRIAL_DONE && error <= 1) {
            double next = longer(ode, fabs(h), error);
            if (rejected)
                next = fmin(next, fabs(h));
            else if (to_end)
                next = fmax(next, ode->h); // the end cut it short, not the error
            ode->h = next;
            accept(ode, h, t_new);
            return YK_ODE_OK;
        }
        ode->counts.rejected++;
        rejected = true;
        ode->h = shorter(ode, fabs(h), trial, error);
    }
}

// Makes a fixed step. Counts equal steps from where they began, so that their ends do not drift; cuts the last one at
// the end. A remainder of rounding size belongs to the step before.
static YkOdeStatus fixed_step(YkOde *ode)
{
    double length = ode->options.fixed_step, left = fabs(ode->end - ode->t);
    bool to_end = left <= length * (1 + 1e-9) + 4 * DBL_EPSILON * fabs(ode->t);
    double t_new = to_end ? ode->end : ode->grid + ode->direction * length * (ode->even + 1), h = t_new - ode->t;
    // With shorter steps the run would never end.
    double smallest = 1e-14 * fmax(fabs(ode->end - ode->start), fabs(ode->t));
    if (!to_end && !(length >= smallest)) return give_up(ode, YK_TRIAL_DONE);
    bool fine = yk_ode_rk4_try(ode, h) == YK_TRIAL_DONE && yk_ode_finite(ode->n, ode->z) &&
                yk_ode_evaluate(ode, t_new, ode->z, ode->z_rate) && yk_ode_finite(ode->n, ode->z_rate);
    if (!fine) {
        ode->counts.rejected++;
        return give_up(ode, YK_TRIAL_F_FAILED);
    }
    accept(ode, h, t_new);
    ode->even++;
    if (to_end) {
        ode->grid = ode->t;
        ode->even = 0;
    }
    return YK_ODE_OK;
}

YkOdeStatus yk_ode_step(YkOde *ode)
{
    if (!ode->started) return YK_ODE_FAILED;
    if (ode->t == ode->end) return YK_ODE_OK;
    return ode->options.method == YK_ODE_RK4 ? fixed_step(ode) : controlled_step(ode);
}
