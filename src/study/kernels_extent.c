// Reduces rows in eight parts: one after the other, each number would wait for the one before.
#include "study/kernels_extent.h"
#include "elementary/kernel.h"

enum { PARTS = 8 };

YK_INLINE double lesser(double a, double b)
{
    return a <= b ? a : b;
}

YK_INLINE double greater(double a, double b)
{
    return a >= b ? a : b;
}

YK_INLINE void yk_lanes_extent_body(double *least, double *largest, double *sum, const double *row, size_t n)
{
    double low[PARTS], high[PARTS], part[PARTS] = {0};
    size_t k = 0;
    for (size_t i = 0; i < PARTS; i++) low[i] = *least, high[i] = *largest;
    for (; k + PARTS <= n; k += PARTS) {
        YK_EACH_LANE
        for (size_t i = 0; i < PARTS; i++) {
            low[i] = lesser(low[i], row[k + i]);
            high[i] = greater(high[i], row[k + i]);
            part[i] += row[k + i];
        }
    }
    for (size_t i = 0; k + i < n; i++) {
        low[i] = lesser(low[i], row[k + i]);
        high[i] = greater(high[i], row[k + i]);
        part[i] += row[k + i];
    }
    for (size_t half = PARTS / 2; half > 0; half /= 2)
        for (size_t i = 0; i < half; i++) {
            low[i] = lesser(low[i], low[i + half]);
            high[i] = greater(high[i], high[i + half]);
            part[i] += part[i + half];
        }
    *least = low[0];
    *largest = high[0];
    *sum += part[0];
}
YK_KERNEL(yk_lanes_extent, (double *least, double *largest, double *sum, const double *row, size_t n),
          (least, largest, sum, row))
