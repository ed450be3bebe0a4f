// A spline from conditions, in B-splines; every span becomes a piece.
#include <stdlib.h>
#include <string.h>
#include "base/sort.h"
#include "elementary/elementary.h"
#include "law/inside.h"

enum { TERMS_MAX = YK_LAW_DEGREE_MAX + 1, KNOTS_MAX = YK_LAW_CONDITIONS_MAX + TERMS_MAX };

typedef struct Spline {
    int degree;
    size_t count; // number of B-splines, that is of control values
    double knots[KNOTS_MAX];
} Spline;

// The polynomials of one span in powers of u, which runs from -1 to 1 over it: basis[i] is B-spline span - degree + i.
typedef struct Span {
    double middle, half;
    double basis[TERMS_MAX][TERMS_MAX];
} Span;

// Computes sum += (p + q u) * factor.
static void add_multiple(double *sum, const double *factor, int terms, double p, double q)
{
    for (int k = 0; k < terms; k++) {
        sum[k] += p * factor[k];
        if (k + 1 < TERMS_MAX) sum[k + 1] += q * factor[k];
    }
}

// Runs the recurrence of Cox and de Boor on polynomials. Source: de Boor 2001, ch. IX.
static void make_span(const Spline *spline, size_t index, Span *span)
{
    const double *t = spline->knots;
    double old[TERMS_MAX][TERMS_MAX];
    *span = (Span){.middle = t[index] + (t[index + 1] - t[index]) / 2, .half = (t[index + 1] - t[index]) / 2};
    span->basis[0][0] = 1;
    for (int d = 1; d <= spline->degree; d++) {
        memcpy(old, span->basis, sizeof old);
        memset(span->basis, 0, sizeof span->basis);
        for (int i = 0; i < d; i++) { // old[i] begins at knot low, ends at knot low + d
            size_t low = index + 1 + (size_t)i - (size_t)d;
            double width = t[low + (size_t)d] - t[low];
            add_multiple(span->basis[i + 1], old[i], d, (span->middle - t[low]) / width, span->half / width);
            add_multiple(span->basis[i], old[i], d, (t[low + (size_t)d] - span->middle) / width, -span->half / width);
        }
    }
}

// Returns the span that contains x: knots[span] <= x < knots[span + 1], the last one closed; no span is empty.
static size_t find_span(const Spline *spline, double x)
{
    size_t span = spline->count - 1;
    while (span > (size_t)spline->degree &&
           !(spline->knots[span] <= x && spline->knots[span] < spline->knots[span + 1]))
        span--;
    return span;
}

// Returns the derivative of a polynomial in powers of u.
static double derivative(const double *p, int terms, int order, double u)
{
    double sum = 0;
    for (int k = terms - 1; k >= order; k--) {
        double factor = p[k];
        for (int m = 0; m < order; m++) factor *= k - m;
        sum = sum * u + factor;
    }
    return sum;
}

// Makes knots as averages of `degree` places each: every place then lies within the support of its B-spline.
static void make_knots(Spline *spline, const double *places)
{
    size_t degree = (size_t)spline->degree, count = spline->count;
    for (size_t i = 0; i <= degree; i++) {
        spline->knots[i] = places[0];
        spline->knots[count + i] = places[count - 1];
    }
    for (size_t j = 1; j + degree < count; j++) {
        double sum = 0;
        for (size_t i = j; i < j + degree; i++) sum += places[i] - places[0];
        spline->knots[j + degree] = places[0] + sum / spline->degree;
    }
}

static YkLawFault solve(YkLawBuilder *builder, const Spline *spline, double *control, double *condition_number)
{
    size_t n = spline->count;
    const YkLawCondition *conditions = builder->conditions + (builder->condition_count - n);
    double *A = calloc((n + 1) * n, sizeof *A), length = spline->knots[n] - spline->knots[0];
    if (!A) return YK_LAW_NO_MEMORY;
    double *b = A + n * n;
    for (size_t i = 0; i < n; i++) {
        Span span;
        int order = conditions[i].order;
        size_t index = find_span(spline, conditions[i].at), first = index - (size_t)spline->degree;
        make_span(spline, index, &span);
        double u = (conditions[i].at - span.middle) / span.half, unit = yk_pow(length / span.half, order);
        for (int k = 0; k <= spline->degree; k++) {
            A[i * n + first + (size_t)k] = unit * derivative(span.basis[k], spline->degree + 1, order, u);
        }
        b[i] = conditions[i].value * yk_pow(length, order);
    }
    YkLawFault fault = yk_law_solve(n, A, b, control, condition_number, &builder->culprit);
    free(A);
    return fault;
}

// Converts powers of u to Chebyshev polynomials, by Horner: u T_k = (T_{k+1} + T_{k-1}) / 2.
static void to_chebyshev(const double *p, int terms, double *c)
{
    double old[TERMS_MAX + 1];
    for (int k = 0; k < terms; k++) c[k] = 0;
    for (int i = terms - 1; i >= 0; i--) {
        for (int k = 0; k < terms; k++) old[k] = c[k];
        for (int k = 0; k < terms; k++) {
            double below = k == 0 ? 0 : k == 1 ? old[0] : old[k - 1] / 2;
            double above = k + 1 < terms ? old[k + 1] / 2 : 0;
            c[k] = below + above;
        }
        c[0] += p[i];
    }
}

static bool add_spans(YkLawBuilder *builder, const Spline *spline, const double *control)
{
    int terms = spline->degree + 1;
    for (size_t index = (size_t)spline->degree; index < spline->count; index++) {
        double p[TERMS_MAX] = {0}, c[TERMS_MAX];
        Span span;
        if (!(spline->knots[index] < spline->knots[index + 1])) continue;
        make_span(spline, index, &span);
        for (int i = 0; i < terms; i++) {
            for (int k = 0; k < terms; k++)
                p[k] += control[index - (size_t)spline->degree + (size_t)i] * span.basis[i][k];
        }
        to_chebyshev(p, terms, c);
        YkPiece frame = {.from = index == (size_t)spline->degree ? builder->at : spline->knots[index],
                         .to = spline->knots[index + 1],
                         .middle = span.middle,
                         .scale = 1 / span.half,
                         .terms = (uint16_t)terms};
        if (!yk_law_add_piece(builder, &frame, c)) return false;
    }
    return true;
}

YkLawFault yk_law_add_spline(YkLawBuilder *builder, const YkLawCondition *conditions, size_t count, int degree)
{
    double from, to, places[YK_LAW_CONDITIONS_MAX], control[YK_LAW_CONDITIONS_MAX], condition_number = 0;
    if (degree < 1 || degree > YK_LAW_DEGREE_MAX) return YK_LAW_SHAPE;
    if (count <= (size_t)degree) return YK_LAW_TOO_FEW;
    YkLawFault fault = yk_law_take_conditions(builder, conditions, count, &from, &to);
    if (fault != YK_LAW_OK) return fault;
    Spline spline = {.degree = degree, .count = count};
    for (size_t i = 0; i < count; i++) places[i] = conditions[i].at;
    qsort(places, count, sizeof *places, yk_by_size);
    make_knots(&spline, places);
    size_t first = builder->piece_count;
    fault = solve(builder, &spline, control, &condition_number);
    if (fault == YK_LAW_OK && !add_spans(builder, &spline, control)) fault = YK_LAW_NO_MEMORY;
    if (fault == YK_LAW_OK) return yk_law_end_segment(builder, YK_LAW_SPLINE, first, count, condition_number);
    yk_law_name_culprit(builder, conditions, count);
    yk_law_take_back(builder, first, count);
    return fault;
}
