// Machines of the gallery by closed forms, as SIMD loops.
#include "gallery.h"
#include "lanes.h"

#define ROW(k) double *restrict o##k = out[k]
#define SIX                                                                                                            \
    ROW(0);                                                                                                            \
    ROW(1);                                                                                                            \
    ROW(2);                                                                                                            \
    ROW(3);                                                                                                            \
    ROW(4);                                                                                                            \
    ROW(5)

// Four-bars: crank a, coupler b, rocker c, ground d. The rocker by the circle about A; rates by Cramer's rule.
#define FOUR_BAR(name, a, b, c, d, sign)                                                                               \
    static void name(const double *const *in, double w, double al, double *const *out, size_t n)                       \
    {                                                                                                                  \
        const double *restrict t = in[0];                                                                              \
        SIX;                                                                                                           \
        _Pragma("omp simd") for (size_t i = 0; i < n; i++)                                                             \
        {                                                                                                              \
            double s2, c2;                                                                                             \
            lane_sincos(t[i], &s2, &c2);                                                                               \
            double x = (a)*c2 - (d), y = (a)*s2, L2 = x * x + y * y, over = 1 / L2;                                    \
            double p = (L2 + (c) * (c) - (b) * (b)) * (0.5 / (c)), q = (sign)*sqrt(L2 - p * p);                        \
            double c4 = (p * x - q * y) * over, s4 = (p * y + q * x) * over;                                           \
            double c3 = ((c)*c4 - x) * (1.0 / (b)), s3 = ((c)*s4 - y) * (1.0 / (b));                                   \
            double det = 1 / (c3 * s4 - s3 * c4), sa = c2 * s4 - s2 * c4, sb = c3 * s2 - s3 * c2;                      \
            double w3 = -(a)*w * sa * det * (1.0 / (b)), w4 = (a)*w * sb * det * (1.0 / (c));                          \
            double gx = -(a) * (al * s2 + w * w * c2) - (b)*w3 * w3 * c3 + (c)*w4 * w4 * c4;                           \
            double gy = (a) * (al * c2 - w * w * s2) - (b)*w3 * w3 * s3 + (c)*w4 * w4 * s4;                            \
            double a3 = -(gx * c4 + gy * s4) * det * (1.0 / (b)), a4 = -(gx * c3 + gy * s3) * det * (1.0 / (c));       \
            o0[i] = lane_atan2(s3 * c2 - c3 * s2, c3 * c2 + s3 * s2), o1[i] = lane_atan2(s4, c4);                      \
            o2[i] = w3 - w, o3[i] = w4, o4[i] = a3 - al, o5[i] = a4;                                                   \
        }                                                                                                              \
    }
FOUR_BAR(four_bar, 0.04, 0.12, 0.08, 0.1, -1)
FOUR_BAR(drag_link, 2, 1.8, 2.4, 1, -1)
FOUR_BAR(hoeken, 1, 3.25, 3.25, 2.5, -1)
FOUR_BAR(chebyshev, 5, 2, 5, 4, 1)

// Slider-cranks: crank r, rod l, the slide's line at height e.
#define SLIDER_CRANK(name, r, l, e)                                                                                    \
    static void name(const double *const *in, double w, double al, double *const *out, size_t n)                       \
    {                                                                                                                  \
        const double *restrict t = in[0];                                                                              \
        SIX;                                                                                                           \
        _Pragma("omp simd") for (size_t i = 0; i < n; i++)                                                             \
        {                                                                                                              \
            double s2, c2;                                                                                             \
            lane_sincos(t[i], &s2, &c2);                                                                               \
            double s3 = ((e) - (r)*s2) * (1.0 / (l)), c3 = sqrt((1 - s3) * (1 + s3)), over = 1 / ((l)*c3);             \
            double w3 = -(r)*w * c2 * over, a3 = ((l)*w3 * w3 * s3 - (r) * (al * c2 - w * w * s2)) * over;             \
            o0[i] = lane_atan2(s3 * c2 - c3 * s2, c3 * c2 + s3 * s2), o1[i] = (r)*c2 + (l)*c3;                         \
            o2[i] = w3 - w, o3[i] = -(r)*w * s2 - (l)*w3 * s3, o4[i] = a3 - al;                                        \
            o5[i] = -(r) * (al * s2 + w * w * c2) - (l) * (a3 * s3 + w3 * w3 * c3);                                    \
        }                                                                                                              \
    }
SLIDER_CRANK(slider_crank, 0.15, 0.6, 0)
SLIDER_CRANK(offset_slider_crank, 0.04, 0.12, -0.02)

static void oscillating_cylinder(const double *const *in, double w, double al, double *const *out, size_t n)
{
    const double *restrict t = in[0], r = 0.06, d = 0.25;
    SIX;
#pragma omp simd
    for (size_t i = 0; i < n; i++) {
        double s2, c2;
        lane_sincos(t[i], &s2, &c2);
        double x = r * c2 - d, y = r * s2, L2 = x * x + y * y, over = 1 / sqrt(L2), L = L2 * over;
        double c = -x * over, s = -y * over, vx = -r * w * s2, vy = r * w * c2; // A = K + d e, d < 0
        double dv = c * vx + s * vy, wc = (s * vx - c * vy) * over;
        double ax = -r * (al * s2 + w * w * c2), ay = r * (al * c2 - w * w * s2);
        double da = c * ax + s * ay - L * wc * wc, ac = (s * ax - c * ay + 2 * dv * wc) * over;
        o0[i] = lane_atan2(s, c), o1[i] = -L, o2[i] = wc, o3[i] = dv, o4[i] = ac, o5[i] = da;
    }
}

static void scotch_yoke(const double *const *in, double w, double al, double *const *out, size_t n)
{
    const double *restrict t = in[0], r = 0.05;
    ROW(0);
    ROW(1);
    ROW(2);
#pragma omp simd
    for (size_t i = 0; i < n; i++) {
        double s, c;
        lane_sincos(t[i], &s, &c);
        o0[i] = r * c, o1[i] = -r * w * s, o2[i] = -r * (al * s + w * w * c);
    }
}

static void elliptic_trammel(const double *const *in, double w, double al, double *const *out, size_t n)
{
    const double *restrict t = in[0], l = 0.3;
    SIX;
#pragma omp simd
    for (size_t i = 0; i < n; i++) {
        double s, c;
        lane_sincos(t[i], &s, &c);
        o0[i] = -l * c, o1[i] = l * s, o2[i] = l * w * s, o3[i] = l * w * c;
        o4[i] = l * (al * s + w * w * c), o5[i] = l * (al * c - w * w * s);
    }
}

static void five_bar(const double *const *in, double w, double al, double *const *out, size_t n)
{
    const double *restrict t = in[0], *restrict u = in[1], W = 0.12, a = 0.2, b = 0.26;
    SIX;
#pragma omp simd
    for (size_t i = 0; i < n; i++) {
        double s1, c1, s2, c2;
        lane_sincos(t[i], &s1, &c1);
        lane_sincos(u[i], &s2, &c2);
        double x = W + a * (c2 - c1), y = a * (s2 - s1), L2 = x * x + y * y; // from A to B
        double h = sqrt(b * b / L2 - 0.25), c3 = (0.5 * x - h * y) / b, s3 = (0.5 * y + h * x) / b;
        double c4 = (-0.5 * x - h * y) / b, s4 = (-0.5 * y + h * x) / b, det = 1 / (b * (c3 * s4 - s3 * c4));
        double vx = -a * w * (s2 - s1), vy = a * w * (c2 - c1); // of B against A
        double w3 = (vx * c4 + vy * s4) * det, w4 = (vx * c3 + vy * s3) * det;
        double gx = -a * (al * (s2 - s1) + w * w * (c2 - c1)) + b * (w3 * w3 * c3 - w4 * w4 * c4);
        double gy = a * (al * (c2 - c1) - w * w * (s2 - s1)) + b * (w3 * w3 * s3 - w4 * w4 * s4);
        double a3 = (gx * c4 + gy * s4) * det, a4 = (gx * c3 + gy * s3) * det;
        o0[i] = lane_atan2(s3 * c1 - c3 * s1, c3 * c1 + s3 * s1),
        o1[i] = lane_atan2(s4 * c2 - c4 * s2, c4 * c2 + s4 * s2);
        o2[i] = w3 - w, o3[i] = w4 - w, o4[i] = a3 - al, o5[i] = a4 - al;
    }
}

#define OF(x, y) x "," y "," x ".rate," y ".rate," x ".accel," y ".accel"
const GalleryMachine gallery_machines[] = {
    {"four-bar", OF("gamma", "theta4"), four_bar, {0}, {6.28}, 1},
    {"drag-link", OF("theta3", "theta4"), drag_link, {0}, {6.28}, 1},
    {"hoeken", OF("gamma", "beta"), hoeken, {0}, {6.28}, 1},
    {"chebyshev", OF("gamma", "beta"), chebyshev, {0.8}, {1.6}, 1}, // away from its dead points
    {"slider-crank", OF("psi", "x"), slider_crank, {0}, {6.28}, 1},
    {"offset-slider-crank", OF("psi", "d"), offset_slider_crank, {0}, {6.28}, 1},
    {"oscillating-cylinder", OF("phi", "s"), oscillating_cylinder, {0}, {6.28}, 1},
    {"scotch-yoke", "x,x.rate,x.accel", scotch_yoke, {0}, {6.28}, 1},
    {"elliptic-trammel", OF("x", "y"), elliptic_trammel, {0}, {6.28}, 1},
    {"five-bar", OF("phi1", "phi2"), five_bar, {1.8, 0.8}, {2.2, 1.2}, 2},
};
const size_t gallery_count = sizeof gallery_machines / sizeof *gallery_machines;

void d1_batch(const double *const *p, const double *const *q, const double *const *v, double *const *a, size_t n)
{
    const double *restrict l1 = p[0], *restrict e1 = p[1], *restrict e2 = p[2], *restrict m1 = p[3],
                           *restrict m2 = p[4];
    const double *restrict I1 = p[5], *restrict I2 = p[6], *restrict q1 = q[0], *restrict q2 = q[1];
    const double *restrict v1 = v[0], *restrict v2 = v[1], G = 9.81;
    double *restrict a1 = a[0], *restrict a2 = a[1];
#pragma omp simd
    for (size_t i = 0; i < n; i++) {
        double s1, c1, s2, c2;
        lane_sincos(q1[i], &s1, &c1);
        lane_sincos(q2[i], &s2, &c2);
        double D = I2[i] + m2[i] * e2[i] * e2[i], A = I1[i] + m1[i] * e1[i] * e1[i] + m2[i] * l1[i] * l1[i] + D;
        double B = m2[i] * l1[i] * e2[i], G2 = G * m2[i] * e2[i], G1 = G * (m1[i] * e1[i] + m2[i] * l1[i]);
        double s12 = s1 * c2 + c1 * s2, b = B * c2, h = B * s2, m11 = A + 2 * b, m12 = D + b;
        double r1 = h * (v2[i] * (2 * v1[i] + v2[i])) - G1 * s1 - G2 * s12, r2 = -h * v1[i] * v1[i] - G2 * s12;
        double over = 1 / (m11 * D - m12 * m12);
        a1[i] = (D * r1 - m12 * r2) * over;
        a2[i] = (m11 * r2 - m12 * r1) * over;
    }
}
