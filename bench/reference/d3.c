// A hanging chain of uniform rods by hand.
#define _GNU_SOURCE // sincos
#include "d3.h"
#include <math.h>
#include <stdint.h>
#include <string.h>

static const double G = 9.81, LC = 0.5, M = 1, I = 1. / 12;

// What the part of the chain further out shows at its upper pin: a 2 x 2 inertia and a force.
typedef struct Shown {
    double xx, xy, yy, fx, fy;
} Shown;

static inline Shown inward(Shown o, double s, double c, double w, D3Link *link)
{
    double ex = s, ey = -c, px = c, py = s, w2 = w * w; // along the rod, and across
    double gx = o.fx - w2 * (o.xx * ex + o.xy * ey), gy = o.fy - w2 * (o.xy * ex + o.yy * ey);
    double qx = o.xx * px + o.xy * py, qy = o.xy * px + o.yy * py;
    double J = I + M * LC * LC + px * qx + py * qy;
    double hx = M * LC * px + qx, hy = M * LC * py + qy;
    double bx = -M * LC * w2 * ex + gx, by = -M * LC * w2 * ey + M * G + gy;
    double moment = M * G * LC * py + px * gx + py * gy;
    double over = 1 / J, u = -moment * over;
    *link = (D3Link){ex, ey, over, hx, hy, u};
    return (Shown){M + o.xx - hx * hx * over, o.xy - hx * hy * over, M + o.yy - hy * hy * over, bx + hx * u,
                   by + hy * u};
}

static void outward(size_t n, const double *w, double *alpha, const D3Link *link)
{
    double ax = 0, ay = 0;
    for (size_t i = 0; i < n; i++) {
        const D3Link *l = &link[i];
        double a = l->u - (l->hx * ax + l->hy * ay) * l->over_J, w2 = w[i] * w[i];
        alpha[i] = a;
        ax += -l->ey * a - w2 * l->ex;
        ay += l->ex * a - w2 * l->ey;
    }
}

void d3_chain(size_t n, const double *theta, const double *w, double *alpha, D3Link *link)
{
    Shown shown = {0};
    for (size_t i = n; i-- > 0;) {
        double s, c;
        sincos(theta[i], &s, &c);
        shown = inward(shown, s, c, w[i], &link[i]);
    }
    outward(n, w, alpha, link);
}

// Moderate arguments: Cody-Waite reduction in two parts, polynomials of fdlibm.
static void sines(const double *restrict x, double *restrict s, double *restrict c, size_t n)
{
    for (size_t i = 0; i < n; i++) {
        double shifted = x[i] * 0.63661977236758134308 + 6755399441055744.0, k = shifted - 6755399441055744.0;
        uint64_t q;
        memcpy(&q, &shifted, sizeof q);
        double r = x[i] - k * 1.57079632673412561417e+00;
        r = r - k * 6.07710050650619224932e-11;
        double z = r * r;
        double low =
            -1.98412698298579493134e-04 +
            z * (2.75573137070700676789e-06 + z * (-2.50507602534068634195e-08 + z * 1.58969099521155010221e-10));
        double sine = r + r * z * (-1.66666666666666324348e-01 + z * (8.33333333332248946124e-03 + z * low));
        double high =
            -1.38888888888741095749e-03 +
            z * (2.48015872894767294178e-05 + z * (-2.75573143513906633035e-07 +
                                                   z * (2.08757232129817482790e-09 + z * -1.13596475577881948265e-11)));
        double cosine = 1 - 0.5 * z + z * z * (4.16666666666666019037e-02 + z * high);
        double a = (q & 1) ? cosine : sine, b = (q & 1) ? sine : cosine;
        s[i] = (q & 2) ? -a : a;
        c[i] = ((q + 1) & 2) ? -b : b;
    }
}

void d3_chain_lanes(size_t n, const double *theta, const double *w, double *alpha, D3Link *link, double *sine)
{
    Shown shown = {0};
    sines(theta, sine, sine + n, n);
    for (size_t i = n; i-- > 0;) shown = inward(shown, sine[i], sine[n + i], w[i], &link[i]);
    outward(n, w, alpha, link);
}
