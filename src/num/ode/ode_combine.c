// One unrolled loop for each number of slopes.
#include "num/ode/ode_combine.h"

// Each loop writes out the sum over the slopes, so that only the loop over components is left and can be vectorised.
#define K(m) const double *restrict k##m = k[of[m]]
#define LOOP(name, slopes, sum)                                                                                        \
    static void name(size_t n, const double *restrict a, const size_t *of, const double *const *k, double h,           \
                     const double *restrict y, double *restrict z)                                                     \
    {                                                                                                                  \
        slopes;                                                                                                        \
        for (size_t j = 0; j < n; j++) z[j] = y[j] + h * (sum);                                                        \
    }
// clang-format off
#define K2 K(0); K(1)
#define K3 K2; K(2)
#define K4 K3; K(3)
#define K5 K4; K(4)
#define K6 K5; K(5)
#define K7 K6; K(6)
#define K8 K7; K(7)
#define K9 K8; K(8)
// clang-format on
#define SUM1 a[0] * k0[j]
#define SUM2 SUM1 + a[1] * k1[j]
#define SUM3 SUM2 + a[2] * k2[j]
#define SUM4 SUM3 + a[3] * k3[j]
#define SUM5 SUM4 + a[4] * k4[j]
#define SUM6 SUM5 + a[5] * k5[j]
#define SUM7 SUM6 + a[6] * k6[j]
#define SUM8 SUM7 + a[7] * k7[j]
#define SUM9 SUM8 + a[8] * k8[j]

LOOP(combine_1, K(0), SUM1)
LOOP(combine_2, K2, SUM2)
LOOP(combine_3, K3, SUM3)
LOOP(combine_4, K4, SUM4)
LOOP(combine_5, K5, SUM5)
LOOP(combine_6, K6, SUM6)
LOOP(combine_7, K7, SUM7)
LOOP(combine_8, K8, SUM8)
LOOP(combine_9, K9, SUM9)

typedef void (*Combine)(size_t n, const double *restrict a, const size_t *of, const double *const *k, double h,
                        const double *restrict y, double *restrict z);

void yk_ode_combine(size_t n, size_t terms, const double *a, const size_t *of, const double *const *k, double h,
                    const double *y, double *z)
{
    static const Combine combine[YK_ODE_MOST_TERMS + 1] = {NULL,      combine_1, combine_2, combine_3, combine_4,
                                                           combine_5, combine_6, combine_7, combine_8, combine_9};
    combine[terms](n, a, of, k, h, y, z);
}
