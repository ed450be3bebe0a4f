// RRR: K + U e^(i Phi1) + W e^(i Phi2) = 0 on solutions chosen beforehand.
#include "lanes_check.h"

typedef struct Case {
    YkPlane K;
    YkArm U, W;
    YkTurn out1, out2;
    double *margin, *own;
    Motion phi1[LANES], phi2[LANES]; // the chosen solution
} Case;

static Case make(Pool *pool, uint64_t seed, bool U_varies, bool W_varies)
{
    Case c = {.K = pool_plane(pool), .U = random_arm(pool, &seed, U_varies), .W = random_arm(pool, &seed, W_varies)};
    c.out1 = pool_turn(pool), c.out2 = pool_turn(pool), c.margin = pool_full(pool, 1), c.own = pool_full(pool, 7);
    for (size_t i = 0; i < LANES; i++) {
        c.phi1[i] = random_angle(&seed), c.phi2[i] = random_angle(&seed);
        Motion p = motion_times(get_arm(c.U, i), motion_turn(c.phi1[i]));
        Motion q = motion_times(get_arm(c.W, i), motion_turn(c.phi2[i]));
        put_plane(c.K, i, motion_minus(motion_add(p, q)));
    }
    return c;
}

// The determinant over the product of the column lengths, at the chosen solution.
static double sine(const Case *c, size_t i)
{
    Complex U = get_arm(c->U, i).value, W = get_arm(c->W, i).value;
    Complex p = U * motion_turn(c->phi1[i]).value, q = W * motion_turn(c->phi2[i]).value;
    return cross_of(p, q) / (double)(cabsl(U) * cabsl(W));
}

static void finds(uint64_t seed, bool U_varies, bool W_varies)
{
    static Pool pool;
    pool.used = 0;
    Case c = make(&pool, seed, U_varies, W_varies);
    for (int branch = -1; branch <= 1; branch += 2) {
        for (size_t i = 0; i < LANES; i++) c.margin[i] = 1;
        yk_lanes_rrr(c.K, c.U, c.W, branch, c.out1, c.out2, c.margin, c.own, LANES);
        for (size_t i = 0; i < LANES; i++) {
            double s = sine(&c, i), near = fabs(s) * fmin(1, (double)cabsl(get_plane(c.K, i).value));
            CHECK_NEAR(c.margin[i], s * s, 1e-14);
            if (near < 1e-2) continue; // K = 0 and dead points magnify rounding
            Motion p = motion_times(get_arm(c.U, i), get_turn(c.out1, i));
            Motion q = motion_times(get_arm(c.W, i), get_turn(c.out2, i));
            Motion left = motion_add(get_plane(c.K, i), motion_add(p, q));
            CHECK_NEAR((double)cabsl(left.value), 0, 3e-15);
            CHECK_NEAR((double)cabsl(get_turn(c.out1, i).value), 1, 4e-15 / near);
            assert_true(cross_of(p.value, q.value) * branch > 0);
            CHECK_NEAR((double)cabsl(left.rate), 0, 1e-13 / near);
            CHECK_NEAR((double)cabsl(left.accel), 0, 1e-12 / (near * near * near));
            if (s * branch < 0) continue; // the other branch has no chosen answer
            check_turn_place(c.out1, i, c.phi1[i], 3e-15 / near);
            check_turn_place(c.out2, i, c.phi2[i], 3e-15 / near);
            check_turn_rates(c.out1, i, c.phi1[i], 2e-13 / (near * near * near));
            check_turn_rates(c.out2, i, c.phi2[i], 2e-13 / (near * near * near));
        }
    }
}

static void finds_the_chosen_solution_with_its_rates(void **state)
{
    (void)state;
    for_all_choices(finds, 10);
}

static void what_cannot_close_has_a_negative_margin(void **state)
{
    (void)state;
    static Pool pool;
    YkPlane K = pool_plane(&pool);
    YkTurn one = pool_turn(&pool), two = pool_turn(&pool);
    double *margin = pool_full(&pool, 0.5), *own = pool_row(&pool);
    const double x[] = {3.1, -3.1, 0.9, 3, 1, 2, 0, (double)NAN, 1e200}; // arms of 2 and 1: closes for 1 <= |K| <= 3
    for (size_t i = 0; i < 9; i++) put_plane(K, i, (Motion){x[i], 1, 1});
    YkArm U = {.constant = {2, 0}}, W = {.constant = {0, 1}};
    yk_lanes_rrr(K, U, W, 1, one, two, margin, own, 9);
    for (size_t i = 0; i < 9; i++) assert_true(i >= 3 && i <= 5 ? margin[i] >= 0 : margin[i] < 0);
    CHECK_NEAR(own[0], (9 - 3.1 * 3.1) * (3.1 * 3.1 - 1) / 16, 1e-15); // the stated formula goes on beyond the limit
    CHECK_NEAR(own[3], 0, 0);
    CHECK_NEAR(own[5], 5.0 * 3 / 16, 1e-15);
    CHECK_NEAR(margin[5], 0.5, 0); // the block's margin is larger than the one that was there
    double *rows[] = {one.c, one.s, one.w, one.a, two.c, two.s, two.w, two.a};
    for (size_t k = 0; k < 8; k++) yk_lanes_mask(rows[k], margin, 1e-12, 9);
    for (size_t k = 0; k < 8; k++)
        for (size_t i = 0; i < 9; i++) assert_true(i == 5 ? isfinite(rows[k][i]) : rows[k][i] == 0);
}

static void two_equal_arms_folded_upon_each_other_have_no_answer(void **state)
{
    (void)state;
    static Pool pool;
    YkPlane K = pool_plane(&pool);
    YkTurn one = pool_turn(&pool), two = pool_turn(&pool);
    double *margin = pool_full(&pool, 1);
    put_plane(K, 0, motion_constant(0));
    YkArm arm = {.constant = {1, 0}};
    yk_lanes_rrr(K, arm, arm, 1, one, two, margin, NULL, 1);
    CHECK_NEAR(margin[0], -1, 0);
}

static void a_stretched_dyad_still_has_its_position(void **state)
{
    (void)state;
    static Pool pool;
    YkPlane K = pool_plane(&pool);
    YkTurn one = pool_turn(&pool), two = pool_turn(&pool);
    double *margin = pool_full(&pool, 1);
    put_plane(K, 0, motion_constant(-3));
    yk_lanes_rrr(K, (YkArm){.constant = {2, 0}}, (YkArm){.constant = {1, 0}}, 1, one, two, margin, NULL, 1);
    CHECK_NEAR(margin[0], 0, 0);
    CHECK_NEAR(one.c[0], 1, 0);
    CHECK_NEAR(two.c[0], 1, 0);
    CHECK_NEAR(fabs(one.s[0]) + fabs(two.s[0]), 0, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(finds_the_chosen_solution_with_its_rates),
        cmocka_unit_test(what_cannot_close_has_a_negative_margin),
        cmocka_unit_test(two_equal_arms_folded_upon_each_other_have_no_answer),
        cmocka_unit_test(a_stretched_dyad_still_has_its_position),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
