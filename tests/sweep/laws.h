// Random laws of a drive that goes over a change point, at 0, by 1e-9 to 1e-3 and comes back, once or several times.
#ifndef TESTS_SWEEP_LAWS_H
#define TESTS_SWEEP_LAWS_H
#include "../check.h"
#include <math.h>
#include <stdio.h>

typedef struct Law {
    char text[256]; // of T = t/s
    double start;   // its value at t = 0
} Law;

static inline double ipow(double x, int n)
{
    double y = 1;
    for (int k = 0; k < n; k++) y *= x;
    return y;
}

// Most laws reach a maximum a little above zero, or cross zero several times at a small distance.
static inline Law random_law(uint64_t *seed)
{
    Law law;
    double small = pow(10, check_uniform(seed, -9, -3)), z = check_uniform(seed, 0.4, 2.6),
           sign = check_random(seed) % 2 ? 1 : -1;
    double w = check_uniform(seed, 1, 6), s = check_uniform(seed, 0.2, 1.5), later = z + check_uniform(seed, 0.01, 0.4);
    int kind = (int)(check_random(seed) % 5), m = 1 + (int)(check_random(seed) % 4),
        n = 1 + (int)(check_random(seed) % 4);
    switch (kind) {
    case 0:
        snprintf(law.text, sizeof law.text, "%.17g*(%.17g - %.17g*(t/(1 s) - %.17g)^2)", sign, small, s, z);
        law.start = sign * (small - s * z * z);
        break;
    case 1:
        snprintf(law.text, sizeof law.text, "%.17g*(%.17g*(t/(1 s) - %.17g) + %.17g*sin(%.17g*t/(1 s)))", sign, s, z,
                 small, 50 * w);
        law.start = -sign * s * z;
        break;
    case 2:
        snprintf(law.text, sizeof law.text, "%.17g*(t/(1 s) - %.17g)^%d*(t/(1 s) - %.17g)^%d", sign * s, z, m, later,
                 n);
        law.start = sign * s * ipow(-z, m) * ipow(-later, n);
        break;
    case 3:
        snprintf(law.text, sizeof law.text, "%.17g*((1 + %.17g)*sin(%.17g*t/(1 s) - 0.5) - 1)", sign, small, w);
        law.start = sign * ((1 + small) * sin(-0.5) - 1);
        break;
    default: // two small excursions, one after the other
        snprintf(law.text, sizeof law.text, "%.17g*(%.17g - (t/(1 s) - %.17g)^2*(t/(1 s) - %.17g)^2)", sign, small, z,
                 later);
        law.start = sign * (small - z * z * later * later);
    }
    return law;
}

#endif
