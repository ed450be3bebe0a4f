// The classical method of order 4. Kutta 1901; Hairer, Norsett & Wanner 1993, II.1. Dense output by cubic Hermite,
// II.6.
#include "num/ode/ode_combine.h"
#include "num/ode/ode_internal.h"

YkOdeTrial yk_ode_rk4_try(YkOde *ode, double h)
{
    static const double half[] = {0.5}, one[] = {1}, weights[] = {1.0 / 6, 1.0 / 3, 1.0 / 3, 1.0 / 6};
    const double *k[] = {ode->rate, ode->stage[0], ode->stage[1], ode->stage[2]}, *const node[] = {half, half, one};
    for (size_t i = 0; i < 3; i++) {
        yk_ode_combine(ode->room, 1, node[i], yk_ode_in_order, k + i, h, ode->y, ode->z);
        if (!yk_ode_evaluate(ode, ode->t + *node[i] * h, ode->z, ode->stage[i])) return YK_TRIAL_F_FAILED;
    }
    yk_ode_combine(ode->room, 4, weights, yk_ode_in_order, k, h, ode->y, ode->z);
    return YK_TRIAL_DONE;
}

void yk_ode_rk4_dense(const YkOde *ode, double s, double *y)
{
    double r = 1 - s, h = ode->length;
    const double *a = ode->y_previous, *b = ode->y, *fa = ode->rate_previous, *fb = ode->rate;
    for (size_t j = 0; j < ode->n; j++) {
        double difference = b[j] - a[j];
        y[j] = a[j] + s * (difference + r * (r * (h * fa[j] - difference) - s * (h * fb[j] - difference)));
    }
}
