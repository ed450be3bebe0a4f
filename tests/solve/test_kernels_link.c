// Loops with one unknown or none, on solutions chosen beforehand and on loops that do not close.
#include "lanes_check.h"

static void finds_link(uint64_t seed, bool varies, bool is_turned)
{
    static Pool pool;
    pool.used = 0;
    YkPlane K = pool_plane(&pool);
    YkArm U = random_arm(&pool, &seed, varies);
    YkTurn out = pool_turn(&pool);
    double *gap = pool_full(&pool, 0);
    static Motion phi[LANES];
    for (size_t i = 0; i < LANES; i++) {
        phi[i] = random_angle(&seed);
        if (is_turned) phi[i].value += 3.14L; // other quadrants
        put_plane(K, i, motion_minus(motion_times(get_arm(U, i), motion_turn(phi[i]))));
    }
    yk_lanes_link(K, U, out, gap, LANES);
    yk_lanes_link_rates(K, U, out, LANES);
    for (size_t i = 0; i < LANES; i++) {
        check_turn_place(out, i, phi[i], 2e-15);
        check_turn_rates(out, i, phi[i], 3e-14);
        CHECK_NEAR(gap[i], 0, 2e-15);
    }
}

static void link_finds_the_chosen_angle_with_its_rates(void **state)
{
    (void)state;
    for_all_choices(finds_link, 10);
}

static void link_says_by_how_much_it_misses(void **state)
{
    (void)state;
    static Pool pool;
    YkPlane K = pool_plane(&pool);
    YkTurn out = pool_turn(&pool);
    double *gap = pool_full(&pool, 0.1);
    const Complex at[] = {3 + 4 * I, -2, 0, 2.05L * I, (long double)NAN};
    for (size_t i = 0; i < 5; i++) put_plane(K, i, motion_constant(at[i]));
    yk_lanes_link(K, (YkArm){.constant = {0, 2}}, out, gap, 5);
    CHECK_NEAR(gap[0], 3, 1e-15);
    CHECK_NEAR(gap[1], 0.1, 0); // keeps the largest
    CHECK_NEAR(gap[2], 2, 0);
    CHECK_NEAR(gap[3], 0.1, 0);
    assert_true(isinf(gap[4]));
    CHECK_NEAR(hypot(out.c[2], out.s[2]), 1, 0); // any angle, but an angle
    CHECK_NEAR(out.c[1], 0, 1e-16);              // 2i e^(i phi) = 2
    CHECK_NEAR(out.s[1], -1, 1e-16);
}

// The remainder of the rates is normal to the column that the unknown commands: it is the least one.
static void link_rates_are_the_best_where_none_is_right(void **state)
{
    (void)state;
    static Pool pool;
    uint64_t seed = 3;
    YkPlane K = pool_plane(&pool);
    YkArm U = random_arm(&pool, &seed, false);
    YkTurn out = pool_turn(&pool);
    double *gap = pool_full(&pool, 0);
    for (size_t i = 0; i < LANES; i++) put_plane(K, i, random_plane(&seed, 2));
    yk_lanes_link(K, U, out, gap, LANES);
    yk_lanes_link_rates(K, U, out, LANES);
    for (size_t i = 0; i < LANES; i++) {
        Motion p = motion_times(get_arm(U, i), get_turn(out, i)), left = motion_add(get_plane(K, i), p);
        CHECK_NEAR(dot_of(left.rate, I * p.value), 0, 1e-13);
        CHECK_NEAR(dot_of(left.accel, I * p.value), 0, 1e-12);
        CHECK_NEAR(gap[i], (double)cabsl(left.value), 1e-14);
    }
}

static void finds_guide(uint64_t seed, bool turns, bool misses)
{
    static Pool pool;
    pool.used = 0;
    YkPlane K = pool_plane(&pool);
    YkTurn line = random_line(&pool, &seed, turns);
    YkVec u = random_unit(&seed);
    YkSlide d = pool_slide(&pool);
    double *gap = pool_full(&pool, 0);
    for (size_t i = 0; i < LANES; i++) {
        Motion e = motion_times(vec_motion(u), get_turn(line, i)), distance = random_real(&seed, -2, 2);
        Motion beside = misses ? random_real(&seed, -1, 1) : motion_constant(0);
        Motion across = motion_times(motion_times(motion_constant(I), e), beside);
        put_plane(K, i, motion_minus(motion_add(motion_times(distance, e), across)));
    }
    yk_lanes_guide(K, line, u, d, gap, LANES);
    yk_lanes_guide_rates(K, line, u, d, LANES);
    for (size_t i = 0; i < LANES; i++) {
        Motion e = motion_times(vec_motion(u), get_turn(line, i));
        Motion left = motion_add(get_plane(K, i), motion_times(get_slide(d, i), e));
        CHECK_NEAR(dot_of(left.value, e.value), 0, 3e-15);
        CHECK_NEAR(dot_of(left.rate, e.value), 0, 1e-14);
        CHECK_NEAR(dot_of(left.accel, e.value), 0, 1e-13);
        CHECK_NEAR(gap[i], (double)cabsl(left.value), 3e-15);
        if (!misses) CHECK_NEAR((double)(cabsl(left.rate) + cabsl(left.accel)), 0, 1e-13);
    }
}

static void guide_leaves_only_what_is_across_the_line(void **state)
{
    (void)state;
    for_all_choices(finds_guide, 10);
}

static void gap_keeps_the_largest_distance(void **state)
{
    (void)state;
    static Pool pool;
    YkPlane K = pool_plane(&pool);
    double *gap = pool_full(&pool, 1);
    put_plane(K, 0, motion_constant(-3 + 4 * I));
    put_plane(K, 1, motion_constant(0.5L));
    put_plane(K, 2, motion_constant((long double)NAN));
    yk_lanes_gap(K, gap, 3);
    CHECK_NEAR(gap[0], 5, 0);
    CHECK_NEAR(gap[1], 1, 0);
    assert_true(isinf(gap[2]));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(link_finds_the_chosen_angle_with_its_rates),
        cmocka_unit_test(link_says_by_how_much_it_misses),
        cmocka_unit_test(link_rates_are_the_best_where_none_is_right),
        cmocka_unit_test(guide_leaves_only_what_is_across_the_line),
        cmocka_unit_test(gap_keeps_the_largest_distance),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
