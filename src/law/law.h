// Scalar laws of motion: a value and its first four derivatives with respect to the argument (a cam angle, time, a
// coordinate). Made once (law/build.h), then constant; evaluation allocates nothing.
#ifndef LAW_LAW_H
#define LAW_LAW_H
#include <stdbool.h>
#include <stddef.h>

enum { YK_LAW_ORDER = 4 };

typedef struct YkLaw YkLaw;

// Computes d[0] = the value and d[k] = the k-th derivative at x. A law with a period takes x modulo the period; one
// without keeps its end values outside its range (derivatives 0). At a joint of segments, gives the values just after
// it. Cost O(log segments).
void yk_law_eval(const YkLaw *law, double x, double d[YK_LAW_ORDER + 1]);
// Computes d[0], d[1], d[2] at n places with the same bits: many at a time where they lie in one polynomial.
void yk_law_eval_lanes(const YkLaw *law, const double *x, double *const d[3], size_t n);

// The range of x over which the law is defined; period 0 if it has none.
typedef struct YkLawRange {
    double from, to, period;
} YkLawRange;
YkLawRange yk_law_range(const YkLaw *law);

// A joint at which the value (order 0) or a derivative (1: v, 2: a) is discontinuous: its value just after x less that
// just before. The fundamental law of cam design allows none (Norton 2009, ch. 2). Without a period the law stands
// still outside its range, which may cause a jump too.
typedef struct YkLawJump {
    double x;
    int order;
    double size;
} YkLawJump;

// Finds the jumps above 1e-9 of the derivative's largest value, by ascending x, and by ascending order at each x; the
// joint that closes the period is at the law's `from`. Returns how many there are; writes the first `capacity` to
// jumps. Cost linear.
size_t yk_law_jumps(const YkLaw *law, YkLawJump *jumps, size_t capacity);

// The place where a derivative (order 0 to 4) is largest in magnitude over the law's range, from either side of its
// joints; exact up to rounding in the value.
typedef struct YkLawPeak {
    double x, value;
} YkLawPeak;
YkLawPeak yk_law_peak(const YkLaw *law, int order);

// No slope and no curvature of the law is larger than these. A law without a period stands still outside of its range,
// so that its slope may jump there; where it jumps, curvature is infinite.
typedef struct YkLawBound {
    bool is_continuous;
    double slope, curvature;
} YkLawBound;
YkLawBound yk_law_bound(const YkLaw *law);

// The kinds of segments of which a law is made.
typedef enum YkLawKind {
    YK_LAW_POLYNOMIAL,
    YK_LAW_SPLINE,
    YK_LAW_DWELL,
    YK_LAW_RISE,
    YK_LAW_FALL,
    YK_LAW_CONSTANT_VELOCITY,
    YK_LAW_TABLE,
    YK_LAW_FORMULA,
    YK_LAW_ARC // a cam's surface is an arc of a circle or a straight line
} YkLawKind;

// One condition: the derivative of this order (0: the value) at x is `value`.
typedef struct YkLawCondition {
    double at;
    int order;
    double value;
} YkLawCondition;

typedef struct YkLawSegment {
    YkLawKind kind;
    double from, to;
    size_t first_piece, piece_count;  // for the room's own use
    const YkLawCondition *conditions; // polynomial, spline: all s, then all v, a, ..., each by ascending x
    size_t condition_count;
    double condition_number; // of the system that was solved, rows scaled (1-norm)
} YkLawSegment;

size_t yk_law_segment_count(const YkLaw *law);
YkLawSegment yk_law_segment(const YkLaw *law, size_t segment);

// Writes a condition as an equation for the coefficients of 1, x, x^2, ...: row[k] = d^order x^k / dx^order at `at`.
void yk_law_power_row(const YkLawCondition *condition, size_t count, double *row);
// Computes the coefficients of a polynomial segment in powers of x, coefficients[condition_count], for readers. They
// lose digits where the degree is high or the segment lies far from 0; evaluation does not use them. Returns false for
// other segments.
bool yk_law_power_coefficients(const YkLaw *law, size_t segment, double *coefficients);

#endif
