// Dormand & Prince 8(5,3) for a handful of unknowns, their number and the right-hand side known while compiling: the
// compiler unrolls everything. The tableau is the library's, which its tests prove.
#ifndef BENCH_DOP853_H
#define BENCH_DOP853_H
#include <math.h>
#include <string.h>
#include "num/ode/ode_dop853_tableau.h"

enum { DOP853_MOST = 16 };

typedef void (*Dop853Function)(const double *y, double *dy);

// z = y + h sum of weight * k.
static inline __attribute__((always_inline)) void dop853_combine(size_t n, const YkDop853Row *row, double h,
                                                                 const double *y, double (*k)[DOP853_MOST], double *z)
{
    for (size_t j = 0; j < n; j++) {
        double sum = 0;
#pragma GCC unroll 12
        for (size_t m = 0; m < row->terms; m++) sum += row->weight[m] * k[row->stage[m]][j];
        z[j] = y[j] + h * sum;
    }
}

static inline __attribute__((always_inline)) double dop853_error(size_t n, double h, double tolerance, const double *y,
                                                                 const double *z, double (*k)[DOP853_MOST])
{
    const YkDop853Row *b = &yk_dop853_b;
    double e5 = 0, e3 = 0;
    for (size_t j = 0; j < n; j++) {
        double q5 = 0, q3 = 0, over = 1 / (tolerance + tolerance * fmax(fabs(y[j]), fabs(z[j])));
#pragma GCC unroll 8
        for (size_t m = 0; m < 8; m++) {
            q5 += yk_dop853_e5[m] * k[b->stage[m]][j];
            q3 += (b->weight[m] - yk_dop853_b3[m]) * k[b->stage[m]][j];
        }
        e5 += q5 * q5 * over * over;
        e3 += q3 * q3 * over * over;
    }
    double length = e5 + 0.01 * e3;
    return length > 0 ? h * e5 / sqrt(length * (double)n) : 0;
}

// y from 0 to `end`, with relative and absolute tolerance. Returns the number of evaluations.
static inline __attribute__((always_inline)) long dop853(size_t n, Dop853Function f, double *y, double end,
                                                         double tolerance)
{
    double k[12][DOP853_MOST], z[DOP853_MOST], t = 0, h = 1e-3;
    long evaluations = 1;
    f(y, k[0]);
    while (t < end) {
        if (t + h > end) h = end - t;
#pragma GCC unroll 11
        for (size_t i = 0; i < 11; i++) {
            dop853_combine(n, &yk_dop853_a[i], h, y, k, z);
            f(z, k[i + 1]);
        }
        dop853_combine(n, &yk_dop853_b, h, y, k, z);
        double error = dop853_error(n, h, tolerance, y, z, k);
        double factor = error > 0 ? 0.9 * pow(error, -0.125) : 6;
        evaluations += 11;
        if (error <= 1) {
            t += h;
            memcpy(y, z, n * sizeof *y);
            f(y, k[0]);
            evaluations++;
        }
        h *= fmin(6, fmax(0.333, factor));
    }
    return evaluations;
}

#endif
