// Gaps of dyads: their sign tells how many solutions there are, and their slope is that of differences.
#include "map/workspace/dyad.h"
#include "check.h"

static const YkShape shapes[] = {
    {.loops = 1, .angles = 2, .unknowns = 2, .turning = {-1, -1}, .column = {0, 1}},
    {.loops = 1, .angles = 1, .unknowns = 2, .turning = {-1, -1}, .column = {0, 1}},
    {.loops = 1, .angles = 1, .unknowns = 2, .turning = {-1, 0}, .column = {0, 1}},
};

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

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_the_gap_tells_the_number_of_solutions),
                                       cmocka_unit_test(test_the_gap_of_a_triangle_is_its_area)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
