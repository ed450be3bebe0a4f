// A segment that follows any smooth function: pieces by interpolation of its fourth derivative, as many as it needs.
#include <float.h>
#include <math.h>
#include <stdlib.h>
#include "base/sort.h"
#include "base/vec.h"
#include "elementary/elementary.h"
#include "law/inside.h"

enum {
    ORDERS = YK_LAW_ORDER + 1,
    NODES = 16,
    TERMS = NODES + YK_LAW_ORDER,
    CHECKS = 48,
    PIECES_MAX = 2000,
    KINKS_MAX = 100
};
// A kink is located to this part of the segment.
#define NARROW 4e-13
// Neighbouring values that differ by more than this do not belong to a function that can be followed.
#define ROUGH 1e-6

// How closely the pieces follow each derivative, as parts of its largest value in the segment.
static const double closeness[ORDERS] = {1e-13, 1e-12, 1e-11, 1e-10, 1e-8};

typedef struct Fit {
    YkLawBuilder *builder;
    YkLawFunction function;
    const void *context;
    double from, to;
    double tolerance[ORDERS];
    size_t first, kinks;
    YkLawFault fault;
} Fit;

static bool evaluate(Fit *fit, double x, double d[ORDERS])
{
    bool is_good = fit->function(fit->context, x, d);
    for (int m = 0; m < ORDERS; m++) is_good = is_good && isfinite(d[m]);
    if (is_good) return true;
    fit->builder->trouble = x;
    fit->fault = YK_LAW_NO_VALUE;
    return false;
}

// Estimates the function's own rounding in each derivative, by second differences so narrow that nothing else is left
// of them. Most of the places count: a kink may lie in some.
static bool find_noise(Fit *fit, double noise[ORDERS])
{
    double rough[ORDERS][CHECKS], before[ORDERS], here[ORDERS], after[ORDERS], length = fit->to - fit->from;
    for (int i = 0; i < CHECKS; i++) {
        double x = fit->from + length * ((i + 0.382) / CHECKS), step = 1e-9 * length;
        if (!evaluate(fit, x - step, before) || !evaluate(fit, x, here) || !evaluate(fit, x + step, after))
            return false;
        for (int m = 0; m < ORDERS; m++) rough[m][i] = fabs(before[m] - 2 * here[m] + after[m]);
    }
    for (int m = 0; m < ORDERS; m++) {
        qsort(rough[m], CHECKS, sizeof *rough[m], yk_by_size);
        noise[m] = 16 * rough[m][CHECKS * 5 / 6];
    }
    return true;
}

// Finds what is close enough. A derivative is at least as large as that of a motion of this height over the segment.
static bool find_tolerances(Fit *fit)
{
    double scale[ORDERS] = {0}, low = INFINITY, high = -INFINITY, d[ORDERS], noise[ORDERS];
    double length = fit->to - fit->from;
    if (!find_noise(fit, noise)) return false;
    for (int i = 0; i < CHECKS; i++) {
        if (!evaluate(fit, fit->from + length * i / CHECKS, d)) return false;
        for (int m = 0; m < ORDERS; m++) scale[m] = fmax(scale[m], fabs(d[m]));
        low = fmin(low, d[0]);
        high = fmax(high, d[0]);
    }
    if (noise[0] > ROUGH * (scale[0] + high - low)) {
        fit->builder->trouble = fit->from;
        fit->fault = YK_LAW_ROUGH;
        return false;
    }
    double unit = 1;
    for (int m = 0; m < ORDERS; m++, unit /= length) {
        double least = fmax(high - low, 1e-4 * scale[0]) * unit;
        fit->tolerance[m] = closeness[m] * fmax(scale[m], least) + noise[m] + DBL_MIN;
    }
    return true;
}

// Integrates a row of Chebyshev polynomials, which is `start` at u = -1 then. Source: Mason & Handscomb 2003, 2.4.
static void integrate(double *c, size_t terms, double start)
{
    double below = 2 * c[0], sum = 0;
    for (size_t k = 1; k <= terms; k++) {
        double above = k + 1 < terms ? c[k + 1] : 0, here = k < terms ? c[k] : 0;
        c[k] = (below - above) / (2 * (double)k);
        below = here;
        sum += k % 2 ? -c[k] : c[k];
    }
    c[0] = start - sum;
}

// Makes the piece over [a, b] whose fourth derivative takes the function's values at the zeros of T_16 and which
// agrees with it at a in all lower ones. Errors of the lower derivatives are then those of integrals: smaller.
static bool make_piece(Fit *fit, double a, double b, YkPiece *frame, double c[TERMS])
{
    double values[NODES], d[ORDERS], largest = 0, power = 1;
    *frame = (YkPiece){.from = a, .to = b, .middle = a + (b - a) / 2, .scale = 2 / (b - a)};
    for (int m = 0; m < YK_LAW_ORDER; m++) power *= frame->scale;
    for (int j = 0; j < NODES; j++) {
        double u = yk_cos(YK_PI * (j + 0.5) / NODES);
        if (!evaluate(fit, frame->middle + u / frame->scale, d)) return false;
        values[j] = d[YK_LAW_ORDER] / power;
    }
    for (int k = 0; k < TERMS; k++) c[k] = 0;
    for (int k = 0; k < NODES; k++) {
        for (int j = 0; j < NODES; j++) c[k] += values[j] * yk_cos(YK_PI * k * (j + 0.5) / NODES);
        c[k] *= k == 0 ? 1.0 / NODES : 2.0 / NODES;
        largest = fmax(largest, fabs(c[k]));
    }
    size_t terms = NODES;
    while (terms > 0 && fabs(c[terms - 1]) <= DBL_EPSILON * largest) c[--terms] = 0;
    if (!evaluate(fit, a, d)) return false;
    for (int m = YK_LAW_ORDER - 1; m >= 0; m--) {
        power /= frame->scale;
        integrate(c, terms, d[m] / power);
        terms++;
    }
    while (terms > 1 && c[terms - 1] == 0) terms--;
    frame->terms = (uint16_t)terms;
    return true;
}

static bool is_near(Fit *fit, const YkPiece *frame, const double *c, double x)
{
    double wanted[ORDERS], found[ORDERS];
    if (!evaluate(fit, x, wanted)) return false;
    yk_piece_eval(frame, c, x, found);
    for (int m = 0; m < ORDERS; m++) {
        if (!(fabs(found[m] - wanted[m]) <= fit->tolerance[m])) return false;
    }
    return true;
}

// Returns whether the piece follows the function between its ends, and up to its very end.
static bool is_close(Fit *fit, const YkPiece *frame, const double *c)
{
    double length = frame->to - frame->from;
    for (int i = 1; i < CHECKS; i++) {
        if (!is_near(fit, frame, c, frame->from + length * i / CHECKS)) return false;
    }
    return is_near(fit, frame, c, frame->to - 1e-9 * length);
}

static void add_piece(Fit *fit, const YkPiece *frame, const double *c)
{
    YkPiece piece = *frame;
    YkLawBuilder *builder = fit->builder;
    if (builder->piece_count == fit->first) piece.from = fit->from; // past a kink at the very beginning
    if (builder->piece_count - fit->first >= PIECES_MAX) {
        builder->trouble = frame->from;
        fit->fault = YK_LAW_ROUGH;
    } else if (!yk_law_add_piece(builder, &piece, c)) {
        fit->fault = YK_LAW_NO_MEMORY;
    }
}

// Passes a kink or step that is located to rounding: the piece before it reaches beyond.
static void pass_kink(Fit *fit, double a, double b)
{
    YkLawBuilder *builder = fit->builder;
    if (fit->kinks++ >= KINKS_MAX) {
        builder->trouble = a;
        fit->fault = YK_LAW_ROUGH;
    } else if (builder->piece_count > fit->first) {
        builder->pieces[builder->piece_count - 1].to = b;
    }
}

// Halves what one piece cannot follow; the depth is bounded by NARROW.
static void follow(Fit *fit, double a, double b)
{
    YkPiece frame;
    double c[TERMS], middle = a + (b - a) / 2;
    if (!make_piece(fit, a, b, &frame, c)) return;
    bool is_good = is_close(fit, &frame, c);
    if (fit->fault != YK_LAW_OK) return;
    double narrow = NARROW * fmax(fit->to - fit->from, fabs(a));
    if (is_good) {
        add_piece(fit, &frame, c);
    } else if (b - a <= narrow || !(a < middle && middle < b)) {
        pass_kink(fit, a, b);
    } else {
        follow(fit, a, middle);
        if (fit->fault == YK_LAW_OK) follow(fit, middle, b);
    }
}

YkLawFault yk_law_add_function(YkLawBuilder *builder, double to, YkLawKind kind, YkLawFunction function,
                               const void *context)
{
    Fit fit = {.builder = builder,
               .function = function,
               .context = context,
               .from = builder->at,
               .to = to,
               .first = builder->piece_count};
    if (!(to > builder->at)) return YK_LAW_BACKWARD;
    if (find_tolerances(&fit)) follow(&fit, fit.from, to);
    if (fit.fault == YK_LAW_OK && builder->piece_count == fit.first) fit.fault = YK_LAW_ROUGH;
    if (fit.fault == YK_LAW_OK) {
        builder->pieces[builder->piece_count - 1].to = to;
        return yk_law_end_segment(builder, kind, fit.first, 0, 1);
    }
    yk_law_take_back(builder, fit.first, 0);
    return fit.fault;
}
