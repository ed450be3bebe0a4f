// RRP: K + W e^(i Phi) + d e = 0 on solutions chosen beforehand.
#include "lanes_check.h"

typedef struct Case {
    YkPlane K;
    YkArm W;
    YkTurn line, out;
    YkVec u;
    YkSlide d;
    double *margin, *own;
    Motion phi[LANES], distance[LANES]; // the chosen solution
} Case;

static Motion direction(const Case *c, size_t i)
{
    return motion_times(vec_motion(c->u), get_turn(c->line, i));
}

static Case make(Pool *pool, uint64_t seed, bool varies, bool turns)
{
    Case c = {.K = pool_plane(pool), .W = random_arm(pool, &seed, varies), .line = random_line(pool, &seed, turns)};
    c.u = random_unit(&seed), c.out = pool_turn(pool), c.d = pool_slide(pool);
    c.margin = pool_full(pool, 1), c.own = pool_full(pool, 7);
    if (seed % 3 == 0) c.u = yk_vec(seed % 2 ? -1 : 1, 0); // along the axes, as most are
    if (seed % 3 == 0 && !varies) c.W.constant.y = 0;
    for (size_t i = 0; i < LANES; i++) {
        c.phi[i] = random_angle(&seed), c.distance[i] = random_real(&seed, -2, 2);
        Motion q = motion_times(get_arm(c.W, i), motion_turn(c.phi[i]));
        put_plane(c.K, i, motion_minus(motion_add(q, motion_times(c.distance[i], direction(&c, i)))));
    }
    return c;
}

static double determinant(const Case *c, size_t i, Complex unit)
{
    return dot_of(direction(c, i).value, get_arm(c->W, i).value * unit);
}

static void finds(uint64_t seed, bool varies, bool turns)
{
    static Pool pool;
    pool.used = 0;
    Case c = make(&pool, seed, varies, turns);
    for (int branch = -1; branch <= 1; branch += 2) {
        for (size_t i = 0; i < LANES; i++) c.margin[i] = 1;
        yk_lanes_rrp(c.K, c.W, c.line, c.u, branch, c.out, c.d, c.margin, c.own, LANES);
        for (size_t i = 0; i < LANES; i++) {
            double s = determinant(&c, i, motion_turn(c.phi[i]).value) / (double)cabsl(get_arm(c.W, i).value);
            double near = fabs(s), cube = near * near * near;
            CHECK_NEAR(c.margin[i], s * s, 2e-14);
            CHECK_NEAR(c.own[i], c.margin[i], 0);
            if (near < 1e-2) continue; // dead points magnify rounding
            Motion q = motion_times(get_arm(c.W, i), get_turn(c.out, i));
            Motion left =
                motion_add(get_plane(c.K, i), motion_add(q, motion_times(get_slide(c.d, i), direction(&c, i))));
            CHECK_NEAR((double)cabsl(left.value), 0, 4e-15);
            CHECK_NEAR((double)cabsl(get_turn(c.out, i).value), 1, 6e-15);
            assert_true(determinant(&c, i, get_turn(c.out, i).value) * branch > 0);
            CHECK_NEAR((double)cabsl(left.rate), 0, 1e-13 / near);
            CHECK_NEAR((double)cabsl(left.accel), 0, 1e-12 / cube);
            if (s * branch < 0) continue; // the other branch has no chosen answer
            check_turn_place(c.out, i, c.phi[i], 1e-14 / near);
            CHECK_NEAR(c.d.d[i], (double)creall(c.distance[i].value), 1e-14 / near);
            check_turn_rates(c.out, i, c.phi[i], 5e-13 / cube);
            check_slide_rates(c.d, i, c.distance[i], 5e-13 / cube);
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
    YkTurn out = pool_turn(&pool), ground = {0};
    YkSlide d = pool_slide(&pool);
    double *margin = pool_full(&pool, 0.8), *own = pool_row(&pool);
    const double y[] = {2.5, -2.5, 2, 1, 0, (double)NAN, 1e200}; // an arm of 2 about a line at -y
    for (size_t i = 0; i < 7; i++) put_plane(K, i, (Motion){5 + I * y[i], 1, 1});
    yk_lanes_rrp(K, (YkArm){.constant = {0, 2}}, ground, yk_vec(1, 0), 1, out, d, margin, own, 7);
    for (size_t i = 0; i < 7; i++) assert_true(i >= 2 && i <= 4 ? margin[i] >= 0 : margin[i] < 0);
    CHECK_NEAR(own[0], 1 - 2.5 * 2.5 / 4, 1e-15);
    CHECK_NEAR(own[2], 0, 0);
    CHECK_NEAR(d.d[2], -5, 0); // the limit position itself has its place
    CHECK_NEAR(own[3], 0.75, 1e-15);
    CHECK_NEAR(margin[4], 0.8, 0);
    double *rows[] = {out.c, out.s, out.w, out.a, d.d, d.v, d.a};
    for (size_t k = 0; k < 7; k++) yk_lanes_mask(rows[k], margin, 1e-12, 7);
    for (size_t k = 0; k < 7; k++)
        for (size_t i = 0; i < 7; i++) assert_true(i == 3 || i == 4 ? isfinite(rows[k][i]) : rows[k][i] == 0);
}

static void nobody_need_ask_for_the_block_margin(void **state)
{
    (void)state;
    static Pool pool;
    Case c = make(&pool, 5, false, false);
    double *margin = pool_full(&pool, 0.3);
    for (size_t i = 0; i < LANES; i++) c.margin[i] = 0.3;
    yk_lanes_rrp(c.K, c.W, c.line, c.u, 1, c.out, c.d, c.margin, c.own, LANES);
    yk_lanes_rrp(c.K, c.W, c.line, c.u, 1, c.out, c.d, margin, NULL, LANES);
    for (size_t i = 0; i < LANES; i++) CHECK_NEAR(margin[i], fmin(0.3, c.own[i]), 0);
    assert_memory_equal(margin, c.margin, LANES * sizeof *margin);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(finds_the_chosen_solution_with_its_rates),
        cmocka_unit_test(what_cannot_close_has_a_negative_margin),
        cmocka_unit_test(nobody_need_ask_for_the_block_margin),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
