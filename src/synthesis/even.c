// The exchange method: at the six extremes of the error, find the change of the five dimensions that makes them alike.
//
// With the error e(t; p) of the output and its derivatives by the dimensions p, e + e_p dp = +E, -E, +E ... at the
// extremes is linear in dp and E. The extremes move, and the step is repeated. Source: Remez 1934; for nonlinear
// families Meinardus 1967, Approximation of Functions, ch. 7; for four-bars Freudenstein 1955.
#include "synthesis/even.h"
#include <math.h>
#include "num/dense.h"

enum { STEPS = 360, P = 5, EXTREMES = P + 1, FOUND = 12, ROUNDS = 40, HALVINGS = 12 };

typedef struct Curve {
    const YkTask *task;
    const YkFunctionTask *f;
    double at_start, rise; // of the function
    double sense;          // the branch: of the angle between coupler and output, or of the coupler along the line
} Curve;

typedef struct Extremes {
    double part[FOUND], error[FOUND], most, least;
    size_t count;
} Extremes;

static YkVec coupler_of(const YkGenerator *bar, double phi, double psi)
{
    YkVec B = yk_add(yk_vec(1, 0), yk_scale(bar->output, yk_unit(psi)));
    return yk_sub(B, yk_scale(bar->input, yk_unit(phi)));
}

static double wanted_at(const Curve *curve, double part)
{
    const YkFunctionTask *f = curve->f;
    double value = NAN;
    yk_task_function(curve->task, f->range.low + part * (f->range.high - f->range.low), &value);
    return (value - curve->at_start) / curve->rise * f->output;
}

// The error of a slider, with its derivatives: the coupler's length ties its place to the rest.
static double slider_error(const Curve *curve, const YkGenerator *bar, double part, double by[P])
{
    double wanted = wanted_at(curve, part), phi = bar->phi + part * curve->f->input;
    YkVec u = yk_unit(phi), A = yk_scale(bar->input, u);
    double y = bar->output - A.y, square = bar->coupler * bar->coupler - y * y;
    if (!(square > 0)) return NAN; // it does not close
    double x = curve->sense * sqrt(square), ratio = y / x;
    if (by) {
        by[0] = u.x + ratio * u.y;
        by[1] = bar->coupler / x;
        by[2] = -ratio;
        by[3] = ratio * A.x - A.y;
        by[4] = -1;
    }
    return A.x + x - bar->psi - wanted;
}

// The output's error where the argument is a part of its range, with its derivatives by the dimensions unless NULL.
static double error_at(const Curve *curve, const YkGenerator *bar, double part, double by[P])
{
    if (curve->f->is_slider) return slider_error(curve, bar, part, by);
    double wanted = wanted_at(curve, part), phi = bar->phi + part * curve->f->input;
    YkVec across = yk_sub(yk_vec(1, 0), yk_scale(bar->input, yk_unit(phi)));
    double b = bar->coupler, c = bar->output, f2 = yk_dot(across, across), f = sqrt(f2);
    double cosine = (b * b - f2 - c * c) / (2 * f * c);
    if (!(fabs(cosine) < 1)) return NAN; // it does not close
    double psi = yk_atan2(across.y, across.x) + curve->sense * yk_acos(cosine);
    double error = yk_remainder(psi - bar->psi - wanted, 2 * YK_PI);
    if (!by) return error;
    YkVec link = coupler_of(bar, phi, psi), u = yk_unit(phi), w = yk_unit(psi);
    double slope = c * yk_dot(link, yk_quarter(w)); // |link|^2 = b^2 ties psi to the rest
    by[0] = yk_dot(link, u) / slope;
    by[1] = b / slope;
    by[2] = -yk_dot(link, w) / slope;
    by[3] = bar->input * yk_dot(link, yk_quarter(u)) / slope;
    by[4] = -1;
    return error;
}

// Goes to the top of a parabola through three values, which are taken ever closer.
static void refine(const Curve *curve, const YkGenerator *bar, double *part, double *error)
{
    double h = 1.0 / STEPS;
    for (int round = 0; round < 3; round++, h /= 16) {
        double before = error_at(curve, bar, *part - h, NULL), after = error_at(curve, bar, *part + h, NULL);
        double bend = before - 2 * *error + after, to = *part + h * (before - after) / (2 * bend);
        if (!(fabs(to - *part) <= h)) return;
        to = fmin(fmax(to, 0), 1);
        double there = error_at(curve, bar, to, NULL);
        if (!(fabs(there) >= fabs(*error))) return;
        *part = to;
        *error = there;
    }
}

// Keeps six successive extremes of more: again and again leaves out the smaller one of both ends.
static void keep_six(Extremes *found)
{
    while (found->count > EXTREMES) {
        found->count--;
        if (fabs(found->error[0]) > fabs(found->error[found->count])) continue;
        for (size_t k = 0; k < found->count; k++) {
            found->part[k] = found->part[k + 1];
            found->error[k] = found->error[k + 1];
        }
    }
}

// Finds the largest error between each two changes of sign. Returns false unless there are six of them, or more.
static bool find_extremes(const Curve *curve, const YkGenerator *bar, Extremes *found)
{
    *found = (Extremes){.least = INFINITY};
    for (size_t k = 0; k <= STEPS; k++) {
        double part = (double)k / STEPS, error = error_at(curve, bar, part, NULL);
        if (isnan(error)) return false;
        bool is_new = found->count == 0 || error * found->error[found->count - 1] < 0;
        if (is_new && found->count == FOUND) return false;
        size_t last = is_new ? found->count++ : found->count - 1;
        if (!is_new && fabs(error) <= fabs(found->error[last])) continue;
        found->part[last] = part;
        found->error[last] = error;
    }
    for (size_t k = 0; k < found->count; k++) {
        bool is_inside = found->part[k] > 0 && found->part[k] < 1;
        if (is_inside) refine(curve, bar, &found->part[k], &found->error[k]);
    }
    keep_six(found);
    for (size_t k = 0; k < found->count; k++) {
        found->most = fmax(found->most, fabs(found->error[k]));
        found->least = fmin(found->least, fabs(found->error[k]));
    }
    return found->count == EXTREMES;
}

// Solves for the step of the dimensions.
static bool find_step(const Curve *curve, const YkGenerator *bar, const Extremes *at, double step[EXTREMES])
{
    double A[EXTREMES * EXTREMES], scale[EXTREMES];
    int pivot[EXTREMES];
    for (size_t k = 0; k < EXTREMES; k++) {
        step[k] = -error_at(curve, bar, at->part[k], &A[EXTREMES * k]);
        A[EXTREMES * k + P] = at->error[k] > 0 ? -1 : 1;
    }
    if (!(fabs(yk_lu_factor(EXTREMES, A, pivot, scale)) > 1e-300)) return false;
    yk_lu_solve(EXTREMES, A, pivot, step);
    return true;
}

static YkGenerator moved(const YkGenerator *bar, const double *step, double part)
{
    return (YkGenerator){bar->input + part * step[0], bar->coupler + part * step[1], bar->output + part * step[2],
                         bar->phi + part * step[3], bar->psi + part * step[4]};
}

static bool is_whole(const Curve *curve, const YkGenerator *bar)
{
    return bar->input > 0 && bar->coupler > 0 && (curve->f->is_slider || bar->output > 0);
}

// Takes as much of a step as makes the largest error smaller. Returns false if nothing does.
static bool go(const Curve *curve, YkGenerator *bar, Extremes *at)
{
    double step[EXTREMES];
    if (!find_step(curve, bar, at, step)) return false;
    for (int k = 0; k < HALVINGS; k++) {
        YkGenerator trial = moved(bar, step, ldexp(1, -k));
        Extremes there;
        if (!is_whole(curve, &trial) || !find_extremes(curve, &trial, &there) || !(there.most < at->most)) continue;
        *bar = trial;
        *at = there;
        return true;
    }
    return false;
}

// The points between the extremes where the error vanishes, by bisection.
static void find_pairs(const Curve *curve, const YkGenerator *bar, const Extremes *at, double pair[P][2])
{
    for (size_t k = 0; k < P; k++) {
        double low = at->part[k], high = at->part[k + 1];
        for (int i = 0; i < 60; i++) {
            double middle = (low + high) / 2;
            bool is_before = error_at(curve, bar, middle, NULL) * at->error[k] > 0;
            *(is_before ? &low : &high) = middle;
        }
        pair[k][0] = low * curve->f->input;
        pair[k][1] = wanted_at(curve, low);
    }
}

bool yk_even_out(const YkTask *task, YkFunctionTask *f, YkGenerator *bar, double *before,
                 double errors[2 * YK_EVEN_ROWS])
{
    static const double alike = 1e-9;
    Curve curve = {.task = task, .f = f};
    YkGenerator own = *bar;
    Extremes at;
    double at_end = 0;
    yk_task_function(task, f->range.low, &curve.at_start);
    yk_task_function(task, f->range.high, &at_end);
    curve.rise = at_end - curve.at_start;
    double phi = own.phi + f->pair[2][0], psi = own.psi + f->pair[2][1];
    if (f->is_slider)
        curve.sense = psi > own.input * yk_cos(phi) ? 1 : -1;
    else
        curve.sense = yk_cross(coupler_of(&own, phi, psi), yk_unit(psi)) > 0 ? 1 : -1;
    if (!find_extremes(&curve, &own, &at)) return false;
    *before = at.most;
    for (size_t r = 0; r < YK_EVEN_ROWS; r++) {
        double part = (double)r / (YK_EVEN_ROWS - 1);
        errors[2 * r] = part * f->input;
        errors[2 * r + 1] = error_at(&curve, &own, part, NULL);
    }
    for (int round = 0; round < ROUNDS && at.most - at.least > alike * at.most; round++)
        if (!go(&curve, &own, &at)) break;
    if (at.most - at.least > 1e-3 * at.most) return false;
    find_pairs(&curve, &own, &at, f->pair);
    *bar = own;
    return true;
}
