// Gaps of dyads: their sign shows how many solutions there are, and their slope is that of differences.
#include "map/workspace/dyad.h"
#include "check.h"

static const YkShape shapes[] = {
    {.loops = 1, .angles = 2, .unknowns = 2, .turning = {-1, -1}, .column = {0, 1}},
    {.loops = 1, .angles = 1, .unknowns = 2, .turning = {-1, -1}, .column = {0, 1}},
    {.loops = 1, .angles = 1, .unknowns = 2, .turning = {-1, 0}, .column = {0, 1}},
};

static const YkShape slides = {.loops = 1, .angles = 0, .unknowns = 2, .turning = {-1, -1}, .column = {0, 1}};

static YkVec random_vec(uint64_t *seed)
{
    double x = check_uniform(seed, -2, 2), y = check_uniform(seed, -2, 2);
    return yk_vec(x, y);
}

// Returns the coefficients at + t rate, without radii.
static YkDiscCoefficients coefficients_at(const YkVec at[3], const YkVec rate[3], double t)
{
    YkDiscCoefficients c = {.radius = {0}};
    for (int k = 0; k < 3; k++) {
        c.at[k] = yk_add(at[k], yk_scale(t, rate[k]));
        c.rate[k] = rate[k];
    }
    return c;
}

static void test_the_gap_tells_the_number_of_solutions(void **unused)
{
    (void)unused;
    uint64_t seed = 5;
    for (size_t s = 0; s < sizeof shapes / sizeof *shapes; s++) {
        size_t none = 0, two = 0;
        for (int trial = 0; trial < 300; trial++) {
            YkVec at[3], rate[3];
            for (int k = 0; k < 3; k++) at[k] = random_vec(&seed), rate[k] = random_vec(&seed);
            YkDiscCoefficients c = coefficients_at(at, rate, 0), before = coefficients_at(at, rate, -1e-5),
                               after = coefficients_at(at, rate, 1e-5);
            YkDual gap = yk_dyad_gap(&shapes[s], &c);
            int count = yk_dyad_count(&shapes[s], &c);
            assert_int_equal(count, gap.at.at.x > 0 ? 2 : 0);
            double slope = (yk_dyad_gap(&shapes[s], &after).at.at.x - yk_dyad_gap(&shapes[s], &before).at.at.x) / 2e-5;
            CHECK_NEAR(gap.rate.at.x, slope, 1e-5 * fmax(1, fabs(slope)));
            two += count == 2;
            none += count == 0;
        }
        assert_true(two > 30 && none > 30);
    }
}

// A triangle's is the square of four times its area: 3, 4, 5.
static void test_the_gap_of_a_triangle_is_its_area(void **unused)
{
    (void)unused;
    const YkVec at[3] = {{3, 0}, {0, 4}, {-5, 0}}, rate[3] = {{0, 0}};
    YkDiscCoefficients c = coefficients_at(at, rate, 0);
    CHECK_NEAR(yk_dyad_gap(&shapes[0], &c).at.at.x, 24 * 24, 1e-10);
}

// Discs round coefficients of which x is a solution: it lies on one of the branches.
static YkDiscCoefficients discs_round(const YkShape *shape, uint64_t *seed, double width, YkVec x[2])
{
    YkDiscCoefficients c = {.radius = {0}};
    YkVec at[3] = {random_vec(seed), random_vec(seed), {0, 0}};
    for (size_t k = 0; k < 2; k++) {
        double angle = check_uniform(seed, -4, 4);
        x[k] = k < shape->angles ? yk_vec(cos(angle), sin(angle)) : yk_vec(angle, 0);
    }
    for (size_t k = 0; k < 2; k++) {
        YkVec factor = shape->turning[k] < 0 ? x[k] : yk_mul(x[k], x[shape->turning[k]]);
        at[2] = yk_sub(at[2], yk_mul(at[k], factor));
    }
    for (int k = 0; k < 3; k++) {
        double aside = check_uniform(seed, 0, 6.3), off = width * fmin(1, check_uniform(seed, 0.5, 2));
        c.at[k] = yk_add(at[k], yk_vec(off * cos(aside), off * sin(aside)));
        c.radius[k] = width + 1e-15;
    }
    return c;
}

static bool is_inside(const YkBall ball[2], const YkVec x[2])
{
    return yk_norm(yk_sub(x[0], ball[0].at)) <= ball[0].radius && yk_norm(yk_sub(x[1], ball[1].at)) <= ball[1].radius;
}

// Whatever the widths of the discs, a solution of coefficients in them lies in a piece of the hull; where the number of
// solutions is known, on a branch; and where discs are narrow, so are the branches.
static void test_solutions_lie_where_they_are_enclosed(void **unused)
{
    (void)unused;
    uint64_t seed = 8;
    for (int s = 0; s < 4; s++) {
        const YkShape *shape = s < 3 ? &shapes[s] : &slides;
        int most = shape->angles == 0 ? 1 : 2;
        size_t counted = 0, narrow = 0, hulls = 0, branches = shape->angles == 0 ? 1 : 2;
        for (size_t trial = 0; trial < check_cases(2000); trial++) {
            double width = pow(10, check_uniform(&seed, -17, 0));
            YkVec x[2];
            YkBall ball[2][2];
            YkDiscCoefficients c = discs_round(shape, &seed, width, x);
            int count = yk_dyad_count(shape, &c);
            assert_true(count == most || count == -1); // there is one solution at least
            size_t with = 0, whole = 0;
            for (size_t b = 0; count > 0 && b < branches; b++)
                if (yk_dyad_branch(shape, &c, b == 0 ? 1 : -1, ball[b])) whole++, with += is_inside(ball[b], x);
            counted += count > 0;
            if (count > 0 && whole == branches) assert_true(with >= 1);
            if (count > 0 && whole == branches && width < 1e-9) {
                assert_int_equal(with, 1); // the branches lie apart
                double radius = fmax(ball[0][0].radius, ball[0][1].radius);
                narrow += radius < 1e-6;
            }
            size_t parts = 1 + trial % 7, found = 0, known = 0;
            for (size_t part = 0; part < parts && shape->angles > 0; part++) {
                YkBall piece[2];
                bool is = yk_dyad_hull(shape, &c, part, parts, piece);
                known += is, found += is && is_inside(piece, x);
            }
            if (known == parts && shape->angles > 0) assert_true(found > 0), hulls++;
        }
        assert_true(counted > check_cases(2000) / 3 && narrow > check_cases(2000) / 10);
        assert_true(shape->angles == 0 || hulls > check_cases(2000) / 3);
    }
}

// How many solutions there are for all coefficients in discs is not said unless it is so for some on either side.
static void test_counts_hold_all_over_the_discs(void **unused)
{
    (void)unused;
    uint64_t seed = 12;
    for (int s = 0; s < 4; s++) {
        const YkShape *shape = s < 3 ? &shapes[s] : &slides;
        for (size_t trial = 0; trial < check_cases(2000); trial++) {
            YkDiscCoefficients wide = {.radius = {0}}, point = {.radius = {0}};
            for (int k = 0; k < 3; k++) {
                wide.at[k] = random_vec(&seed), wide.radius[k] = pow(10, check_uniform(&seed, -3, 0.3));
                double aside = check_uniform(&seed, 0, 6.3), off = wide.radius[k] * check_uniform(&seed, 0.8, 1);
                point.at[k] = yk_add(wide.at[k], yk_vec(off * cos(aside), off * sin(aside)));
            }
            int count = yk_dyad_count(shape, &wide);
            if (count >= 0) assert_int_equal(yk_dyad_count(shape, &point), count);
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_solutions_lie_where_they_are_enclosed),
                                       cmocka_unit_test(test_counts_hold_all_over_the_discs),
                                       cmocka_unit_test(test_the_gap_tells_the_number_of_solutions),
                                       cmocka_unit_test(test_the_gap_of_a_triangle_is_its_area)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
