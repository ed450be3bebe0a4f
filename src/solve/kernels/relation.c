// Relations: sums of multiples of scalars with their rates, and the chain rule for laws.
#include "solve/kernels/lanes.h"

YK_INLINE void start(double *out, double offset, double factor, const double *change, size_t n)
{
    YK_EACH_LANE
    for (size_t i = 0; i < n; i++) out[i] = offset + factor * change[i];
}

YK_INLINE void add(double *out, double factor, const double *change, size_t n)
{
    YK_EACH_LANE
    for (size_t i = 0; i < n; i++) out[i] += factor * change[i];
}

YK_INLINE void yk_lanes_multiple_body(YkScalar out, double offset, bool is_first, double factor, YkScalar x, size_t n)
{
    if (is_first) {
        start(out.x, offset, factor, x.x, n);
        start(out.v, 0, factor, x.v, n);
        start(out.a, 0, factor, x.a, n);
    } else {
        add(out.x, factor, x.x, n);
        add(out.v, factor, x.v, n);
        add(out.a, factor, x.a, n);
    }
}
YK_KERNEL(yk_lanes_multiple, (YkScalar out, double offset, bool is_first, double factor, YkScalar x, size_t n),
          (out, offset, is_first, factor, x))

// Adds what the law gives to `base`, an array or a number.
#define ADD_LAW(base_x, base_v, base_a)                                                                                \
    YK_EACH_LANE                                                                                                       \
    for (size_t i = 0; i < n; i++) {                                                                                   \
        double w = x.v[i];                                                                                             \
        out.x[i] = (base_x) + gain * value[i];                                                                         \
        out.v[i] = (base_v) + gain * first[i] * w;                                                                     \
        out.a[i] = (base_a) + gain * (first[i] * x.a[i] + second[i] * w * w);                                          \
        slope[i] = gain * first[i];                                                                                    \
    }

YK_INLINE void yk_lanes_add_law_body(YkScalar out, double offset, bool is_first, double gain, const double *const *law,
                                     YkScalar x, double *slope, size_t n)
{
    const double *value = law[0], *first = law[1], *second = law[2];
    if (is_first) {
        ADD_LAW(offset, 0, 0)
    } else {
        ADD_LAW(out.x[i], out.v[i], out.a[i])
    }
}
YK_KERNEL(yk_lanes_add_law,
          (YkScalar out, double offset, bool is_first, double gain, const double *const *law, YkScalar x, double *slope,
           size_t n),
          (out, offset, is_first, gain, law, x, slope))
