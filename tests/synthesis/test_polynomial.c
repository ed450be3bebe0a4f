// Roots that a polynomial was made from, and points that two conics were made through, are found again.
#include "check.h"
#include "synthesis/polynomial.h"

// Multiplies a polynomial by x - root, or by the two factors of a root and its conjugate. Returns the new degree.
static size_t with_root(double *c, size_t degree, YkVec root)
{
    double factor[3] = {-root.x, 1, 0}, product[YK_DEGREE_MAX + 3] = {0};
    size_t more = root.y == 0 ? 1 : 2;
    if (more == 2) {
        factor[0] = root.x * root.x + root.y * root.y;
        factor[1] = -2 * root.x;
        factor[2] = 1;
    }
    for (size_t i = 0; i <= degree; i++)
        for (size_t k = 0; k <= more; k++) product[i + k] += c[i] * factor[k];
    memcpy(c, product, (degree + more + 1) * sizeof *c);
    return degree + more;
}

static double nearest(const YkVec *list, size_t count, YkVec to)
{
    double best = INFINITY;
    for (size_t k = 0; k < count; k++) best = fmin(best, hypot(list[k].x - to.x, list[k].y - to.y));
    return best;
}

static void polynomials_have_the_roots_they_were_made_from(void **state)
{
    (void)state;
    uint64_t seed = 11;
    for (uint64_t run = 0; run < check_cases(1000); run++) {
        double c[YK_DEGREE_MAX + 1] = {check_uniform(&seed, .5, 3)};
        YkVec own[YK_DEGREE_MAX], root[YK_DEGREE_MAX];
        size_t degree = 0, count = 0, most = 1 + check_random(&seed) % YK_DEGREE_MAX;
        while (degree < most) {
            YkVec at = {check_uniform(&seed, -2, 2),
                        most - degree > 1 && check_random(&seed) % 2 ? check_uniform(&seed, .3, 2) : 0};
            YkVec mirrored = {at.x, -at.y};
            if (nearest(own, count, at) < .3) continue; // roots that are nearly the same are known less well
            degree = with_root(c, degree, at);
            own[count++] = at;
            if (at.y != 0) own[count++] = mirrored;
        }
        size_t asked = degree < YK_DEGREE_MAX && check_random(&seed) % 2 ? degree + 1 : degree; // with a leading zero
        assert_int_equal(yk_roots(c, asked, root), degree);
        for (size_t k = 0; k < degree; k++) {
            CHECK_NEAR(nearest(root, degree, own[k]), 0, 1e-9);
            CHECK_NEAR(nearest(own, degree, root[k]), 0, 1e-9);
        }
    }
}

static void constants_have_no_roots(void **state)
{
    (void)state;
    YkVec root[YK_DEGREE_MAX];
    assert_int_equal(yk_roots((double[]){3}, 0, root), 0);
    assert_int_equal(yk_roots((double[]){3, 0, 0}, 2, root), 0);
    assert_int_equal(yk_roots((double[]){0, 0, 0}, 2, root), 0);
    assert_int_equal(yk_roots((double[]){1, INFINITY}, 1, root), 0);
    assert_int_equal(yk_roots((double[]){0, 2}, 1, root), 1);
    CHECK_NEAR(hypot(root[0].x, root[0].y), 0, 0);
}

static void cross(const double *a, const double *b, double *product)
{
    for (size_t i = 0; i < 3; i++) product[i] = a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3];
}

// Adds a multiple of the conic that is two lines.
static void add_lines(YkConic *conic, double scale, const double *line, const double *other)
{
    for (size_t i = 0; i < 3; i++)
        for (size_t k = 0; k < 3; k++) conic->q[i < k ? i : k][i < k ? k : i] += scale * line[i] * other[k];
}

// How far a complex point is from a real one, up to a factor.
static double off(const YkVec *point, const double *at)
{
    double sum = 0;
    for (size_t i = 0; i < 3; i++) {
        size_t j = (i + 1) % 3;
        sum = fmax(sum, hypot(point[i].x * at[j] - point[j].x * at[i], point[i].y * at[j] - point[j].y * at[i]));
    }
    return sum;
}

static void conics_through_four_points_meet_there(void **state)
{
    (void)state;
    uint64_t seed = 13;
    for (uint64_t run = 0; run < check_cases(500); run++) {
        double at[4][3], line[4][3];
        for (size_t k = 0; k < 4; k++) { // one near each corner, so that no three lie in a line
            at[k][0] = (k & 1 ? 1 : -1) + check_uniform(&seed, -.3, .3);
            at[k][1] = (k & 2 ? 1 : -1) + check_uniform(&seed, -.3, .3);
            at[k][2] = 1;
        }
        static const size_t ends[4][2] = {{0, 1}, {2, 3}, {0, 2}, {1, 3}};
        for (size_t k = 0; k < 4; k++) cross(at[ends[k][0]], at[ends[k][1]], line[k]);
        YkConic conic[2] = {0};
        YkVec point[4][3];
        double turn = check_uniform(&seed, 0, 3), more = check_uniform(&seed, .5, 2.5);
        add_lines(&conic[0], cos(turn), line[0], line[1]);
        add_lines(&conic[0], sin(turn), line[2], line[3]);
        add_lines(&conic[1], cos(turn + more), line[0], line[1]);
        add_lines(&conic[1], sin(turn + more), line[2], line[3]);
        assert_int_equal(yk_conics_meet(&conic[0], &conic[1], point), 4);
        for (size_t k = 0; k < 4; k++) {
            double least = INFINITY, size = 0;
            for (size_t r = 0; r < 4; r++) least = fmin(least, off(point[r], at[k]));
            for (size_t i = 0; i < 3; i++) size += point[k][i].x * point[k][i].x + point[k][i].y * point[k][i].y;
            CHECK_NEAR(least, 0, 1e-7);
            CHECK_NEAR(size, 1, 1e-7);
        }
        assert_int_equal(yk_conics_meet(&conic[0], &conic[0], point), 5);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(polynomials_have_the_roots_they_were_made_from),
        cmocka_unit_test(constants_have_no_roots),
        cmocka_unit_test(conics_through_four_points_meet_there),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
