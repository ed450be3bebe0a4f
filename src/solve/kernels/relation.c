// Relations: sums of multiples of scalars with their rates, and the chain rule for laws.
#include "solve/kernels/lanes.h"

YK_INLINE void multiple(double *out, double offset, bool is_first, double factor, const double *change, size_t n)
{
    YK_EACH_LANE
    for (size_t i = 0; i < n; i++) out[i] = (is_first ? offset : out[i]) + factor * change[i];
}

YK_INLINE void yk_lanes_multiple_body(YkScalar out, double offset, bool is_first, double factor, YkScalar x, size_t n)
{
    double *const to[] = {out.x, out.v, out.a}, *const from[] = {x.x, x.v, x.a};
    for (size_t k = 0; k < 3; k++) {
        if (YK_KNOWS_BLOCKS && is_first)
            multiple(to[k], k == 0 ? offset : 0, true, factor, from[k], n);
        else if (YK_KNOWS_BLOCKS)
            multiple(to[k], 0, false, factor, from[k], n);
        else
            multiple(to[k], k == 0 ? offset : 0, is_first, factor, from[k], n);
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
    if (YK_KNOWS_BLOCKS && is_first) {
        ADD_LAW(offset, 0, 0)
    } else {
        ADD_LAW(is_first ? offset : out.x[i], is_first ? 0 : out.v[i], is_first ? 0 : out.a[i])
    }
}
YK_KERNEL(yk_lanes_add_law,
          (YkScalar out, double offset, bool is_first, double gain, const double *const *law, YkScalar x, double *slope,
           size_t n),
          (out, offset, is_first, gain, law, x, slope))
