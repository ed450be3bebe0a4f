// Elementary functions for SIMD loops, written for the references: branch-free, absolute error below 1e-15 for moderate
// arguments. Polynomials of fdlibm.
#ifndef BENCH_LANES_H
#define BENCH_LANES_H
#include <math.h>
#include <stdint.h>
#define ALWAYS static inline __attribute__((always_inline))

ALWAYS void lane_sincos(double x, double *s, double *c)
{
    double shifted = x * 0.63661977236758134308 + 6755399441055744.0, k = __builtin_rint(x * 0.63661977236758134308);
    union {
        double d;
        int64_t i;
    } whole = {shifted};
    int64_t q = whole.i;
    double r = x - k * 1.57079632673412561417e+00;
    r = r - k * 6.07710050650619224932e-11;
    double z = r * r;
    double u = r + r * z *
                       (-1.66666666666666324348e-01 +
                        z * (8.33333333332248946124e-03 +
                             z * (-1.98412698298579493134e-04 +
                                  z * (2.75573137070700676789e-06 +
                                       z * (-2.50507602534068634195e-08 + z * 1.58969099521155010221e-10)))));
    double v = 1 - 0.5 * z +
               z * z *
                   (4.16666666666666019037e-02 +
                    z * (-1.38888888888741095749e-03 +
                         z * (2.48015872894767294178e-05 +
                              z * (-2.75573143513906633035e-07 +
                                   z * (2.08757232129817482790e-09 + z * -1.13596475577881948265e-11)))));
    double ss = q & 1 ? v : u, cc = q & 1 ? u : v;
    *s = q & 2 ? -ss : ss;
    *c = (q + 1) & 2 ? -cc : cc;
}

ALWAYS double lane_atan2(double y, double x)
{
    double ax = fabs(x), ay = fabs(y), most = ax > ay ? ax : ay, least = ax > ay ? ay : ax;
    int big = least > 0.41421356237309503 * most;
    double u = (big ? least - most : least) / (big ? least + most : most), z = u * u, v = z * z;
    double p = z * (3.33333333333329318027e-01 +
                    v * (1.42857142725034663711e-01 +
                         v * (9.09088713343650656196e-02 +
                              v * (6.66107313738753120669e-02 +
                                   v * (4.97687799461593236017e-02 + v * 1.62858201153657823623e-02))))) +
               v * (-1.99999999998764832476e-01 +
                    v * (-1.11111104054623557880e-01 +
                         v * (-7.69187620504482999495e-02 +
                              v * (-5.83357013379057348645e-02 + v * -3.65315727442169155270e-02))));
    double a = (u - u * p) + (big ? 0.78539816339744830962 : 0.0);
    a = ay > ax ? 1.57079632679489661923 - a : a;
    a = x < 0 ? 3.14159265358979323846 - a : a;
    return y < 0 ? -a : a;
}

#endif
