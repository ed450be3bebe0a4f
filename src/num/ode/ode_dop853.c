// The method DOP853. Hairer, Norsett & Wanner 1993, Solving Ordinary Differential Equations I, II.5 and II.10.
#include "num/ode/ode_combine.h"
#include "num/ode/ode_dop853_tableau.h"
#include "num/ode/ode_internal.h"

// Lists the slopes of the step by number. `first` and `last` are f at its two ends.
static void list_slopes(const YkOde *ode, const double *first, const double *last, const double *k[YK_DOP853_STAGES])
{
    for (size_t i = 0; i < YK_DOP853_STAGES; i++) k[i] = ode->stage[i];
    k[0] = first;
    k[12] = last;
}

static void combine_row(const YkOde *ode, const YkDop853Row *row, const double *const *k, double h, const double *y)
{
    yk_ode_combine(ode->room, row->terms, row->weight, row->stage, k, h, y, ode->z);
}

// Combines the estimates of order 5 and 3 as Hairer does: behaves as order 8 where both are small.
static double error_norm(const YkOde *ode, const double *const *k, double h)
{
    const double *restrict a = k[0], *restrict b = k[5], *restrict c = k[6], *restrict d = k[7], *restrict e = k[8],
                           *restrict f = k[9], *restrict g = k[10], *restrict l = k[11];
    const double *const E = yk_dop853_e5, *const B = yk_dop853_b.weight, *const B3 = yk_dop853_b3;
    double sum5 = 0, sum3 = 0;
    for (size_t j = 0; j < ode->controlled; j++) {
        double one = 1 / yk_ode_allowed(ode, j, ode->y[j], ode->z[j]);
        double e5 = E[0] * a[j] + E[1] * b[j] + E[2] * c[j] + E[3] * d[j] + E[4] * e[j] + E[5] * f[j] + E[6] * g[j] +
                    E[7] * l[j];
        double e3 = (B[0] - B3[0]) * a[j] + B[1] * b[j] + B[2] * c[j] + B[3] * d[j] + (B[4] - B3[4]) * e[j] +
                    B[5] * f[j] + B[6] * g[j] + (B[7] - B3[7]) * l[j];
        e5 *= one;
        e3 *= one;
        sum5 += e5 * e5;
        sum3 += e3 * e3;
    }
    double both = sum5 + 0.01 * sum3;
    if (both == 0) return 0;
    return fabs(h) * sum5 / sqrt(both * (double)ode->controlled);
}

YkOdeTrial yk_ode_dop853_try(YkOde *ode, double h, double *error)
{
    const double *k[YK_DOP853_STAGES];
    list_slopes(ode, ode->rate, NULL, k);
    for (size_t i = 1; i <= 11; i++) {
        const YkDop853Row *row = &yk_dop853_a[i - 1];
        combine_row(ode, row, k, h, ode->y);
        if (!yk_ode_evaluate(ode, ode->t + row->node * h, ode->z, ode->stage[i])) return YK_TRIAL_F_FAILED;
    }
    combine_row(ode, &yk_dop853_b, k, h, ode->y);
    *error = error_norm(ode, k, h);
    return YK_TRIAL_DONE;
}

// Makes the coefficients of degree 1 .. 7; that of degree 0 is y_previous.
static void make_coefficients(YkOde *ode, const double *const *k, double h)
{
    double *const *c = ode->dense;
    for (size_t j = 0; j < ode->n; j++) {
        double difference = ode->y[j] - ode->y_previous[j], slope = h * k[0][j] - difference;
        c[0][j] = difference;
        c[1][j] = slope;
        c[2][j] = difference - h * k[12][j] - slope;
    }
    for (size_t d = 0; d < 4; d++)
        for (size_t j = 0; j < ode->n; j++) {
            double sum = 0;
            for (size_t m = 0; m < 12; m++) sum += yk_dop853_d[d][m] * k[yk_dop853_dense_stage[m]][j];
            c[3 + d][j] = h * sum;
        }
}

static bool prepare_dense(YkOde *ode)
{
    const double *k[YK_DOP853_STAGES];
    double h = ode->length;
    list_slopes(ode, ode->rate_previous, ode->rate, k);
    for (size_t i = 13; i < 16; i++) {
        const YkDop853Row *row = &yk_dop853_extra[i - 13];
        combine_row(ode, row, k, h, ode->y_previous);
        if (!yk_ode_evaluate(ode, ode->previous + row->node * h, ode->z, ode->stage[i])) return false;
    }
    make_coefficients(ode, k, h);
    for (size_t d = 0; d < 4; d++)
        if (!yk_ode_finite(ode->n, ode->dense[3 + d])) return false;
    return true;
}

YkOdeStatus yk_ode_dop853_dense(YkOde *ode, double s, double *y)
{
    if (!ode->dense_ready && !prepare_dense(ode)) return YK_ODE_FAILED;
    ode->dense_ready = true;
    double *const *c = ode->dense, r = 1 - s;
    for (size_t j = 0; j < ode->n; j++) {
        double high = c[3][j] + s * (c[4][j] + r * (c[5][j] + s * c[6][j]));
        y[j] = ode->y_previous[j] + s * (c[0][j] + r * (c[1][j] + s * (c[2][j] + r * high)));
    }
    return YK_ODE_OK;
}
