// Starts the margins: a pose whose inputs are not numbers closes nothing.
#include "solve/kernels/lanes.h"

YK_INLINE void begin(double *margin, const double *x, const double *rate, const double *accel, bool is_first, size_t n)
{
    YK_EACH_LANE YK_UNROLL for (size_t i = 0; i < n; i++)
    {
        double before = is_first ? 1 : margin[i], v = rate[i] * YK_RATE_GUARD, a = accel[i] * YK_ACCELERATION_GUARD;
        double zero = 0 * x[i] + ((v - v) + (a - a)); // or NaN
        margin[i] = zero == 0 ? before : -1;
    }
}

YK_INLINE void yk_lanes_begin_body(double *margin, const double *x, const double *rate, const double *accel,
                                   bool is_first, size_t n)
{
    if (is_first)
        begin(margin, x, rate, accel, true, n);
    else
        begin(margin, x, rate, accel, false, n);
}
YK_KERNEL(yk_lanes_begin,
          (double *margin, const double *x, const double *rate, const double *accel, bool is_first, size_t n),
          (margin, x, rate, accel, is_first))
