// PP: K + d1 e1 + d2 e2 = 0 on solutions chosen beforehand.
#include "lanes_check.h"

typedef struct Case {
    YkPlane K;
    YkTurn line1, line2;
    YkVec u1, u2;
    YkSlide d1, d2;
    double *margin, *own;
    Motion one[LANES], two[LANES]; // the chosen solution
} Case;

static Motion direction(YkTurn line, YkVec u, size_t i)
{
    return motion_times(vec_motion(u), get_turn(line, i));
}

static Motion left_over(const Case *c, size_t i, Motion d1, Motion d2)
{
    Motion first = motion_times(d1, direction(c->line1, c->u1, i)),
           second = motion_times(d2, direction(c->line2, c->u2, i));
    return motion_add(get_plane(c->K, i), motion_add(first, second));
}

static Case make(Pool *pool, uint64_t seed, bool turns1, bool turns2)
{
    Case c = {
        .K = pool_plane(pool), .line1 = random_line(pool, &seed, turns1), .line2 = random_line(pool, &seed, turns2)};
    c.u1 = random_unit(&seed), c.u2 = random_unit(&seed), c.d1 = pool_slide(pool), c.d2 = pool_slide(pool);
    c.margin = pool_full(pool, 1), c.own = pool_full(pool, 7);
    for (size_t i = 0; i < LANES; i++) {
        put_plane(c.K, i, motion_constant(0));
        c.one[i] = random_real(&seed, -2, 2), c.two[i] = random_real(&seed, -2, 2);
        put_plane(c.K, i, motion_minus(left_over(&c, i, c.one[i], c.two[i])));
    }
    return c;
}

static void finds(uint64_t seed, bool turns1, bool turns2)
{
    static Pool pool;
    pool.used = 0;
    Case c = make(&pool, seed, turns1, turns2);
    yk_lanes_pp(c.K, c.line1, c.u1, c.line2, c.u2, c.d1, c.d2, c.margin, c.own, LANES);
    yk_lanes_pp_rates(c.K, c.line1, c.u1, c.line2, c.u2, c.d1, c.d2, LANES);
    for (size_t i = 0; i < LANES; i++) {
        double D = cross_of(direction(c.line1, c.u1, i).value, direction(c.line2, c.u2, i).value);
        double near = fabs(D), cube = near * near * near;
        CHECK_NEAR(c.margin[i], D * D, 1e-15);
        CHECK_NEAR(c.own[i], c.margin[i], 0);
        if (near < 1e-2) continue; // nearly parallel lines magnify rounding
        Motion left = left_over(&c, i, get_slide(c.d1, i), get_slide(c.d2, i));
        CHECK_NEAR((double)cabsl(left.value), 0, 4e-15 / near);
        CHECK_NEAR((double)cabsl(left.rate), 0, 4e-14 / (near * near));
        CHECK_NEAR((double)cabsl(left.accel), 0, 4e-13 / cube);
        CHECK_NEAR(c.d1.d[i], (double)creall(c.one[i].value), 4e-15 / near);
        CHECK_NEAR(c.d2.d[i], (double)creall(c.two[i].value), 4e-15 / near);
        check_slide_rates(c.d1, i, c.one[i], 1e-13 / cube);
        check_slide_rates(c.d2, i, c.two[i], 1e-13 / cube);
    }
}

static void finds_the_chosen_solution_with_its_rates(void **state)
{
    (void)state;
    for_all_choices(finds, 10);
}

static void parallel_lines_have_a_negative_margin(void **state)
{
    (void)state;
    static Pool pool;
    YkPlane K = pool_plane(&pool);
    YkTurn ground = {0};
    YkSlide d1 = pool_slide(&pool), d2 = pool_slide(&pool);
    double *margin = pool_full(&pool, 1);
    put_plane(K, 0, motion_constant(1));
    yk_lanes_pp(K, ground, yk_vec(0.6, 0.8), ground, yk_vec(-0.6, -0.8), d1, d2, margin, NULL, 1);
    CHECK_NEAR(margin[0], -1, 0);
    yk_lanes_mask(d1.d, margin, 0, 1);
    yk_lanes_mask(d2.d, margin, 0, 1);
    CHECK_NEAR(fabs(d1.d[0]) + fabs(d2.d[0]), 0, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(finds_the_chosen_solution_with_its_rates),
        cmocka_unit_test(parallel_lines_have_a_negative_margin),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
