// Certificates: given where they should be, refused where they must not be; and discs that enclose.
#include "configurations/ball.h"
#include "configurations/certify.h"
#include "configurations/follow.h"
#include "check.h"

static YkVec random_vec(uint64_t *seed, double size)
{
    double x = check_uniform(seed, -size, size), y = check_uniform(seed, -size, size);
    return yk_vec(x, y);
}

// --- discs

static bool holds(YkBall ball, long double x, long double y)
{
    long double dx = x - (long double)ball.at.x, dy = y - (long double)ball.at.y;
    return sqrtl(dx * dx + dy * dy) <= (long double)ball.radius;
}

// Any points of the discs have their sum, product and inverse, in 64 bits of mantissa, in the disc of the result; and
// the radius is not much more than it must be.
static void test_discs_enclose(void **unused)
{
    (void)unused;
    uint64_t seed = 1;
    for (int trial = 0; trial < 20000; trial++) {
        double ra = trial % 3 == 0 ? 0 : check_uniform(&seed, 0, 1e-3), rb = trial % 5 == 0 ? 0 : ra;
        YkBall a = yk_ball(random_vec(&seed, 2), ra), b = yk_ball(random_vec(&seed, 2), rb);
        if (yk_norm(a.at) < 0.01 || yk_norm(b.at) < 0.01) continue;
        double s = check_uniform(&seed, 0, 2 * YK_PI), t = check_uniform(&seed, 0, 2 * YK_PI);
        long double ax = a.at.x + (long double)ra * 0.999999L * cosl(s),
                    ay = a.at.y + (long double)ra * 0.999999L * sinl(s);
        long double bx = b.at.x + (long double)rb * 0.999999L * cosl(t),
                    by = b.at.y + (long double)rb * 0.999999L * sinl(t);
        assert_true(holds(yk_ball_add(a, b), ax + bx, ay + by));
        assert_true(holds(yk_ball_mul(a, b), ax * bx - ay * by, ax * by + ay * bx));
        long double square = ax * ax + ay * ay;
        assert_true(holds(yk_ball_inverse(a), ax / square, -ay / square));
        assert_true(yk_ball_most(a) >= yk_norm(a.at) + ra);
        assert_true(yk_ball_mul(a, b).radius <= 8 * (ra + rb) + 1e-13);
    }
    assert_true(isinf(yk_ball_inverse(yk_ball(yk_vec(0.5, 0), 0.6)).radius));
    assert_true(isinf(yk_ball_inverse(yk_ball(yk_vec(0, 0), 0)).radius));
}

// --- a loop of two bars: z_1 a + z_2 b = c, whose solutions are those of a triangle

static const YkShape two_bars = {.loops = 1, .angles = 2, .unknowns = 2, .turning = {-1, -1}, .column = {0, 1}};

static void make_triangle(double a, double b, double c, YkVec *coefficients)
{
    const double row[] = {a, b, -c};
    for (int k = 0; k < 3; k++) coefficients[k] = coefficients[3 + k] = yk_vec(row[k], 0);
}

// Returns z_1 of a triangle by the law of cosines.
static YkVec first_side(double a, double b, double c)
{
    double x = (a * a + c * c - b * b) / (2 * a * c);
    return yk_vec(x, sqrt(1 - x * x));
}

static void test_a_triangle_is_proved_real(void **unused)
{
    (void)unused;
    YkVec k[6], x[2];
    YkCertificate one, two;
    make_triangle(0.8, 0.7, 1, k);
    YkVec z = first_side(0.8, 0.7, 1);
    x[0] = z;
    x[1] = yk_scale(1 / 0.7, yk_sub(yk_vec(1, 0), yk_scale(0.8, z)));
    assert_true(yk_certify(&two_bars, k, x, &one));
    assert_int_equal(one.reality, YK_REAL);
    assert_true(one.within < one.radius);
    CHECK_NEAR(x[0].x, z.x, one.within);
    CHECK_NEAR(x[0].y, z.y, one.within);
    YkVec y[2] = {yk_conj(x[0]), yk_conj(x[1])}; // the triangle's mirror image is another solution
    assert_true(yk_certify(&two_bars, k, y, &two));
    assert_true(yk_are_distinct(&two_bars, x, &one, y, &two));
    assert_false(yk_are_distinct(&two_bars, x, &one, x, &one));
}

static void test_what_is_no_solution_is_not_proved(void **unused)
{
    (void)unused;
    uint64_t seed = 4;
    YkVec k[6];
    YkCertificate c;
    make_triangle(0.8, 0.7, 1, k);
    for (int trial = 0; trial < 1000; trial++) {
        YkVec x[2] = {yk_unit(check_uniform(&seed, -3, 3)), yk_unit(check_uniform(&seed, -3, 3))};
        YkVec z = first_side(0.8, 0.7, 1);
        if (fabs(x[0].x - z.x) < 1e-3) continue;
        assert_false(yk_certify(&two_bars, k, x, &c));
    }
}

// Bars too short to meet: two complex solutions, proved not to be real.
static void test_an_open_triangle_is_proved_not_real(void **unused)
{
    (void)unused;
    YkVec k[6];
    YkCertificate c;
    make_triangle(0.4, 0.3, 1, k);
    // (a z_1 - c)(a / z_1 - c) = b^2: a c (z_1 + 1 / z_1) = a^2 + c^2 - b^2
    double half = (0.16 + 1 - 0.09) / (2 * 0.4), z = half + sqrt(half * half - 1);
    YkVec x[2] = {yk_vec(z, 0), yk_vec((1 - 0.4 * z) / 0.3, 0)};
    assert_true(yk_certify(&two_bars, k, x, &c));
    assert_int_equal(c.reality, YK_NOT_REAL);
}

// Towards the stretched triangle the two solutions merge. As long as both are proved they are distinct; at it, nothing
// is.
static void test_a_double_root_is_not_proved(void **unused)
{
    (void)unused;
    YkVec k[6], x[2];
    YkCertificate c;
    make_triangle(0.6, 0.4, 1, k);
    x[0] = x[1] = yk_vec(1, 0);
    assert_false(yk_certify(&two_bars, k, x, &c));
    size_t proved = 0;
    for (double gap = 0.1; gap > 1e-17; gap *= 0.1) {
        double a = 0.6 + gap, half = (a * a + 1 - 0.16) / (2 * a);
        make_triangle(a, 0.4, 1, k);
        x[0] = half < 1 ? first_side(a, 0.4, 1) : yk_vec(1, 0);
        x[1] = yk_scale(1 / 0.4, yk_sub(yk_vec(1, 0), yk_scale(a, x[0])));
        yk_system_polish(&two_bars, k, x);
        if (!yk_certify(&two_bars, k, x, &c)) continue;
        proved++;
        YkVec y[2] = {yk_conj(x[0]), yk_conj(x[1])};
        assert_true(yk_are_distinct(&two_bars, x, &c, y, &c));
    }
    assert_true(proved >= 4 && proved <= 14);
}

// The proof holds for every coefficient within its error: the solutions of all these triangles lie within the polydisc.
static void test_the_proof_covers_rounded_coefficients(void **unused)
{
    (void)unused;
    YkVec k[6], x[2];
    YkCertificate c;
    make_triangle(0.8, 0.7, 1, k);
    x[0] = first_side(0.8, 0.7, 1);
    x[1] = yk_scale(1 / 0.7, yk_sub(yk_vec(1, 0), yk_scale(0.8, x[0])));
    assert_true(yk_certify(&two_bars, k, x, &c));
    for (int corner = 0; corner < 8; corner++) {
        long double e = 0.9L * (long double)YK_COEFFICIENT_ERROR, a = 0.8L + (corner & 1 ? e : -e),
                    b = 0.7L + (corner & 2 ? e : -e), d = 1 + (corner & 4 ? e : -e);
        long double u = (a * a + d * d - b * b) / (2 * a * d), v = sqrtl(1 - u * u);
        long double off = sqrtl((u - (long double)x[0].x) * (u - (long double)x[0].x) +
                                (v - (long double)x[0].y) * (v - (long double)x[0].y));
        assert_true(off <= (long double)(c.within * yk_sum_norm(x[0])));
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_discs_enclose),
        cmocka_unit_test(test_a_triangle_is_proved_real),
        cmocka_unit_test(test_what_is_no_solution_is_not_proved),
        cmocka_unit_test(test_an_open_triangle_is_proved_not_real),
        cmocka_unit_test(test_a_double_root_is_not_proved),
        cmocka_unit_test(test_the_proof_covers_rounded_coefficients),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
