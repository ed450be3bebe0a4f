// Starts the margins: a pose whose inputs are not numbers closes nothing.
#include "elementary/bits.h"
#include "solve/kernels/lanes.h"

// Returns 0 if an input of a lane is a number with its rates; otherwise NaN.
YK_INLINE double nothing(double x, double rate, double accel)
{
    double v = rate * YK_RATE_GUARD, a = accel * YK_ACCELERATION_GUARD;
    return 0 * x + ((v - v) + (a - a));
}

YK_INLINE void begin(double *margin, const double *x, const double *rate, const double *accel, bool is_first, size_t n)
{
    YK_EACH_LANE YK_UNROLL for (size_t i = 0; i < n; i++)
    {
        double before = is_first ? 1 : margin[i];
        margin[i] = nothing(x[i], rate[i], accel[i]) == 0 ? before : -1;
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

YK_INLINE void yk_lanes_numbers_body(bool *are_numbers, const double *x, const double *rate, const double *accel,
                                     size_t n)
{
    uint64_t bits = 0;
    YK_EACH_LANE YK_UNROLL for (size_t i = 0; i < n; i++) bits |= bits_of(nothing(x[i], rate[i], accel[i]));
    *are_numbers = (bits & ~YK_SIGN_BIT) == 0;
}
YK_KERNEL(yk_lanes_numbers, (bool *are_numbers, const double *x, const double *rate, const double *accel, size_t n),
          (are_numbers, x, rate, accel))
