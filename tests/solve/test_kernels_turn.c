// Orientations against e^(i angle) in long double.
#include "lanes_check.h"

static Motion opposite_or_same(Motion angle, double sign)
{
    return sign < 0 ? motion_minus(angle) : angle;
}

static void turns(uint64_t seed, bool has_parent, bool is_reversed)
{
    static Pool pool;
    pool.used = 0;
    double sign = is_reversed ? -1 : 1, offset = check_uniform(&seed, -3, 3);
    YkTurn out = pool_turn(&pool), parent = has_parent ? pool_turn(&pool) : (YkTurn){0};
    YkSlide theta = pool_slide(&pool);
    static Motion expected[LANES];
    for (size_t i = 0; i < LANES; i++) {
        Motion angle = random_real(&seed, -10, 10), base = random_angle(&seed);
        put_slide(theta, i, angle);
        angle.value = theta.d[i] + offset; // as rounded: the kernel is asked for its cosine, not for the sum
        angle.value = (double)creall(angle.value);
        if (has_parent) put_turn(parent, i, base);
        expected[i] = opposite_or_same(angle, sign);
        if (has_parent) expected[i] = motion_add(expected[i], base);
    }
    yk_lanes_turn(out, parent, theta.d, theta.v, theta.a, offset, sign, LANES);
    for (size_t i = 0; i < LANES; i++) {
        check_turn_place(out, i, expected[i], has_parent ? 4e-16 : 1.2e-16);
        check_turn_rates(out, i, expected[i], 1e-15);
    }
}

static void turn_is_the_exponential_of_its_angle(void **state)
{
    (void)state;
    for_all_choices(turns, 10);
}

static void absent_rates_are_zero(void **state)
{
    (void)state;
    static Pool pool;
    uint64_t seed = 1;
    YkTurn out = pool_turn(&pool), parent = pool_turn(&pool), ground = {0};
    double *theta = pool_full(&pool, 0.5);
    for (size_t i = 0; i < LANES; i++) put_turn(parent, i, random_angle(&seed));
    yk_lanes_turn(out, ground, theta, NULL, NULL, 0, 1, LANES);
    for (size_t i = 0; i < LANES; i++) CHECK_NEAR(fabs(out.w[i]) + fabs(out.a[i]), 0, 0);
    yk_lanes_turn(out, parent, theta, NULL, NULL, 0, 1, LANES);
    assert_memory_equal(out.w, parent.w, sizeof pool.rows[0]);
    assert_memory_equal(out.a, parent.a, sizeof pool.rows[0]);
}

// One far angle among near ones: all come out right.
static void far_angles_are_right_too(void **state)
{
    (void)state;
    static Pool pool;
    YkTurn out = pool_turn(&pool), ground = {0};
    double *theta = pool_full(&pool, 0.5);
    theta[3] = 1e9, theta[100] = -3e5, theta[256] = 1e22;
    for (int k = 0; k <= 1; k++) {
        double offset = 0.75 * k; // the sum is exact but for 1e22, where the offset is below the rounding
        yk_lanes_turn(out, ground, theta, NULL, NULL, offset, -1, LANES);
        for (size_t i = 0; i < LANES; i++) {
            long double angle = -(long double)(theta[i] + offset);
            CHECK_NEAR(out.c[i], (double)cosl(angle), 1.2e-16);
            CHECK_NEAR(out.s[i], (double)sinl(angle), 1.2e-16);
        }
    }
}

static void compose_adds_angles_and_rates(void **state)
{
    (void)state;
    static Pool pool;
    uint64_t seed = 2;
    YkTurn out = pool_turn(&pool), a = pool_turn(&pool), b = pool_turn(&pool), ground = {0};
    static Motion sum[LANES];
    for (size_t i = 0; i < LANES; i++) {
        Motion one = random_angle(&seed), two = random_angle(&seed);
        put_turn(a, i, one), put_turn(b, i, two);
        sum[i] = motion_add(one, two);
    }
    yk_lanes_compose(out, a, b, LANES);
    for (size_t i = 0; i < LANES; i++) {
        check_turn_place(out, i, sum[i], 4e-16);
        check_turn_rates(out, i, sum[i], 1e-15);
    }
    const double *rows[] = {a.c, a.s, a.w, a.a}, *copies[] = {out.c, out.s, out.w, out.a};
    yk_lanes_compose(out, ground, a, LANES);
    for (size_t k = 0; k < 4; k++) assert_memory_equal(copies[k], rows[k], sizeof pool.rows[0]);
    memset(out.c, 0, sizeof pool.rows[0]);
    yk_lanes_compose(out, a, ground, LANES);
    for (size_t k = 0; k < 4; k++) assert_memory_equal(copies[k], rows[k], sizeof pool.rows[0]);
    yk_lanes_compose(out, ground, ground, LANES);
    for (size_t i = 0; i < LANES; i++)
        CHECK_NEAR(fabs(out.c[i] - 1) + fabs(out.s[i]) + fabs(out.w[i]) + fabs(out.a[i]), 0, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(turn_is_the_exponential_of_its_angle),
        cmocka_unit_test(absent_rates_are_zero),
        cmocka_unit_test(far_angles_are_right_too),
        cmocka_unit_test(compose_adds_angles_and_rates),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
