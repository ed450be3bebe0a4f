// Roots of polynomials by companion matrices; conics by their resultant.
#include "synthesis/polynomial.h"
#include <math.h>
#include "num/eigen.h"

static const double none = 1e-14; // of the largest coefficient: nothing

// Improves a root by Newton's method; steps that do not come nearer end it.
static YkVec refine(const double *c, size_t degree, YkVec x)
{
    double last = INFINITY;
    for (int step = 0; step < 8; step++) {
        YkVec value = yk_vec(c[degree], 0), slope = yk_vec(0, 0);
        for (size_t k = degree; k-- > 0;) {
            slope = yk_add(yk_mul(slope, x), value);
            value = yk_add(yk_mul(value, x), yk_vec(c[k], 0));
        }
        if (!(yk_dot(slope, slope) > 0)) return x;
        YkVec change = yk_divide(value, slope);
        double size = yk_norm(change);
        if (!(size < last)) return x;
        x = yk_sub(x, change);
        last = size;
    }
    return x;
}

size_t yk_roots(const double *c, size_t degree, YkVec *root)
{
    double A[YK_DEGREE_MAX * YK_DEGREE_MAX] = {0}, real[YK_DEGREE_MAX], imaginary[YK_DEGREE_MAX], largest = 0;
    for (size_t k = 0; k <= degree; k++) largest = fmax(largest, fabs(c[k]));
    while (degree > 0 && fabs(c[degree]) <= none * largest) degree--;
    if (degree == 0 || !isfinite(largest)) return 0;
    for (size_t k = 0; k < degree; k++) {
        A[k * degree + degree - 1] = -c[k] / c[degree];
        if (k > 0) A[k * degree + k - 1] = 1;
    }
    if (!yk_eigen_general(degree, A, real, imaginary)) return 0;
    for (size_t k = 0; k < degree; k++) root[k] = refine(c, degree, yk_vec(real[k], imaginary[k]));
    return degree;
}

// --- conics

static void multiply(const double *a, size_t a_degree, const double *b, size_t b_degree, double sign, double *sum)
{
    for (size_t i = 0; i <= a_degree; i++)
        for (size_t k = 0; k <= b_degree; k++) sum[i + k] += sign * a[i] * b[k];
}

// A conic with c_2 = 1 as a quadratic in y = c_1: a y^2 + b(x) y + c(x), x = c_0.
typedef struct Quadratic {
    double a[1], b[2], c[3];
} Quadratic;

// Turns the axes by a fixed rotation, so that no point of interest lies at infinity.
static const double turn[3][3] = {{0.36, 0.48, -0.8}, {-0.8, 0.6, 0}, {0.48, 0.64, 0.6}};

static Quadratic quadratic_of(const YkConic *conic)
{
    double t[3][3] = {{0}};
    for (size_t i = 0; i < 3; i++)
        for (size_t k = i; k < 3; k++)
            for (size_t m = 0; m < 3; m++)
                for (size_t n = 0; n < 3; n++)
                    t[m < n ? m : n][m < n ? n : m] += conic->q[i][k] * turn[i][m] * turn[k][n];
    return (Quadratic){{t[1][1]}, {t[1][2], t[0][1]}, {t[2][2], t[0][2], t[0][0]}};
}

static YkVec evaluate(const double *c, size_t degree, YkVec x)
{
    YkVec sum = yk_vec(c[degree], 0);
    for (size_t k = degree; k-- > 0;) sum = yk_add(yk_mul(sum, x), yk_vec(c[k], 0));
    return sum;
}

// Returns y of the common point at x: from the line that the two quadratics share there.
static YkVec common(const double *top, const double *bottom, YkVec x)
{
    return yk_scale(-1, yk_divide(evaluate(top, 2, x), evaluate(bottom, 1, x)));
}

size_t yk_conics_meet(const YkConic *first, const YkConic *second, YkVec point[4][3])
{
    Quadratic f = quadratic_of(first), g = quadratic_of(second);
    double ac[3] = {0}, ab[2] = {0}, bc[4] = {0}, resultant[5] = {0}, size = 0;
    multiply(f.a, 0, g.c, 2, 1, ac);
    multiply(g.a, 0, f.c, 2, -1, ac);
    multiply(f.a, 0, g.b, 1, 1, ab);
    multiply(g.a, 0, f.b, 1, -1, ab);
    multiply(f.b, 1, g.c, 2, 1, bc);
    multiply(g.b, 1, f.c, 2, -1, bc);
    multiply(ac, 2, ac, 2, 1, resultant);
    multiply(ab, 1, bc, 3, -1, resultant);
    for (size_t k = 0; k < 5; k++) size = fmax(size, fabs(resultant[k]));
    if (!(size > 1e-20)) return 5;
    YkVec root[YK_DEGREE_MAX];
    size_t count = yk_roots(resultant, 4, root);
    for (size_t r = 0; r < count; r++) {
        YkVec own[3] = {root[r], common(ac, ab, root[r]), yk_vec(1, 0)};
        double length = sqrt(yk_dot(own[0], own[0]) + yk_dot(own[1], own[1]) + 1);
        for (size_t i = 0; i < 3; i++) {
            point[r][i] = yk_vec(0, 0);
            for (size_t m = 0; m < 3; m++) point[r][i] = yk_add(point[r][i], yk_scale(turn[i][m] / length, own[m]));
        }
    }
    return count;
}
