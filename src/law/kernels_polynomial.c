// The polynomial of a piece over lanes: Clenshaw's recurrence for the value and two derivatives, as add_polynomial of
// eval.c has it.
#include "elementary/kernel.h"
#include "law/inside.h"

typedef struct Sums { // of one lane: b_(k+1) and b_(k+2) of the value and its derivatives
    double b[3], before[3];
} Sums;

YK_INLINE Sums next(Sums s, double u, double c)
{
    double value = 2 * u * s.b[0] - s.before[0] + c;
    double first = 2 * u * s.b[1] - s.before[1] + 2 * s.b[0];
    double second = 2 * u * s.b[2] - s.before[2] + 4 * s.b[1];
    return (Sums){{value, first, second}, {s.b[0], s.b[1], s.b[2]}};
}

// Sums for the two highest terms, after which nothing is zero any more.
YK_INLINE Sums begin(const double *c, size_t terms, double u)
{
    Sums s = {{0 + c[terms - 1], 0, 0}, {0, 0, 0}};
    if (terms == 2) return s;
    return (Sums){{2 * u * s.b[0] + c[terms - 2], 2 * s.b[0], 0}, {s.b[0], 0, 0}};
}

enum { STEPS = 5 }; // up to eight terms: the rises of the textbooks

// Written without a loop, so that lanes stay in registers where `terms` is known.
YK_INLINE Sums recur(const double *c, size_t terms, double u)
{
    Sums s = {{0, 0, 0}, {0, 0, 0}};
    if (terms < 2) return s;
    s = begin(c, terms, u);
    size_t last = YK_KNOWS_BLOCKS ? STEPS : 0; // where lanes are not vectors, all is the loop
    for (size_t k = terms - 3; terms > last + 3 && k > last; k--) s = next(s, u, c[k]);
    if (!YK_KNOWS_BLOCKS) return s;
    if (terms > 7) s = next(s, u, c[5]);
    if (terms > 6) s = next(s, u, c[4]);
    if (terms > 5) s = next(s, u, c[3]);
    if (terms > 4) s = next(s, u, c[2]);
    if (terms > 3) s = next(s, u, c[1]);
    return s;
}

YK_INLINE void over_lanes(const double *c, size_t terms, double middle, double scale, const double *x, double *const *d,
                          size_t n)
{
    double *value = d[0], *first = d[1], *second = d[2];
    YK_EACH_LANE
    for (size_t i = 0; i < n; i++) {
        double u = (x[i] - middle) * scale;
        Sums s = recur(c, terms, u);
        value[i] = 0 + (u * s.b[0] - s.before[0]) + c[0];
        first[i] = (0 + (u * s.b[1] - s.before[1]) + s.b[0]) * scale;
        second[i] = (0 + (u * s.b[2] - s.before[2]) + 2 * s.b[1]) * (scale * scale);
    }
}

// Numbers of terms that have a loop of their own: cubics, and rises of the fifth, sixth and seventh degree.
YK_INLINE void yk_law_polynomial_body(const double *c, size_t terms, double middle, double scale, const double *x,
                                      double *const *d, size_t n)
{
    if (YK_KNOWS_BLOCKS && terms == 4)
        over_lanes(c, 4, middle, scale, x, d, n);
    else if (YK_KNOWS_BLOCKS && terms == 6)
        over_lanes(c, 6, middle, scale, x, d, n);
    else if (YK_KNOWS_BLOCKS && terms == 7)
        over_lanes(c, 7, middle, scale, x, d, n);
    else if (YK_KNOWS_BLOCKS && terms == 8)
        over_lanes(c, 8, middle, scale, x, d, n);
    else
        over_lanes(c, terms, middle, scale, x, d, n);
}
YK_KERNEL(yk_law_polynomial,
          (const double *c, size_t terms, double middle, double scale, const double *x, double *const *d, size_t n),
          (c, terms, middle, scale, x, d))

YK_INLINE void yk_law_within_body(bool *within, const double *x, double from, double to, size_t n)
{
    uint64_t outside = 0;
    YK_EACH_LANE
    for (size_t i = 0; i < n; i++) outside |= x[i] >= from && x[i] < to ? 0u : 1u;
    *within = outside == 0;
}
YK_KERNEL(yk_law_within, (bool *within, const double *x, double from, double to, size_t n), (within, x, from, to))
