// RPR: K + (C + d u e^(i inner)) e^(i Phi) = 0 on solutions chosen beforehand.
#include "lanes_check.h"

typedef struct Case {
    YkPlane K;
    YkArm C;
    YkTurn inner, out;
    YkVec u;
    YkSlide d;
    double *margin, *own;
    Motion phi[LANES], distance[LANES]; // the chosen solution
} Case;

// p = (C + d u e^(i inner)) e^(i Phi), from a distance and an orientation.
static Motion arm_in_plane(const Case *c, size_t i, Motion distance, Motion unit)
{
    Motion along = motion_times(distance, motion_times(vec_motion(c->u), get_turn(c->inner, i)));
    return motion_times(motion_add(get_arm(c->C, i), along), unit);
}

static Case make(Pool *pool, uint64_t seed, bool varies, bool turns)
{
    Case c = {.K = pool_plane(pool), .C = random_arm(pool, &seed, varies), .inner = random_line(pool, &seed, turns)};
    c.u = random_unit(&seed), c.out = pool_turn(pool), c.d = pool_slide(pool);
    c.margin = pool_full(pool, 1), c.own = pool_full(pool, 7);
    if (seed % 2 && !varies) c.C.constant = yk_vec(0, 0);  // the line through the pin is the commonest,
    if (seed % 3) c.u = yk_vec(seed % 3 == 1 ? -1 : 1, 0); // and along an axis
    for (size_t i = 0; i < LANES; i++) {
        c.phi[i] = random_angle(&seed), c.distance[i] = random_real(&seed, -3, 3);
        put_plane(c.K, i, motion_minus(arm_in_plane(&c, i, c.distance[i], motion_turn(c.phi[i]))));
    }
    return c;
}

// dot(e, p), at an orientation and a distance.
static double determinant(const Case *c, size_t i, Motion distance, Motion unit)
{
    Complex e = vec_motion(c->u).value * get_turn(c->inner, i).value * unit.value;
    return dot_of(e, arm_in_plane(c, i, distance, unit).value);
}

static void finds(uint64_t seed, bool varies, bool turns)
{
    static Pool pool;
    pool.used = 0;
    Case c = make(&pool, seed, varies, turns);
    for (int branch = -1; branch <= 1; branch += 2) {
        for (size_t i = 0; i < LANES; i++) c.margin[i] = 1;
        yk_lanes_rpr(c.K, c.C, c.inner, c.u, branch, c.out, c.d, c.margin, c.own, LANES);
        for (size_t i = 0; i < LANES; i++) {
            double length = (double)cabsl(get_plane(c.K, i).value);
            double r = determinant(&c, i, c.distance[i], motion_turn(c.phi[i]));
            double near = fmin(1, fabs(r)) * fmin(1, length), cube = near * near * near;
            if (near < 1e-2) continue; // dead points and K = 0 magnify rounding
            CHECK_NEAR(c.margin[i], r * r / (length * length), 1e-14 / near);
            Motion unit = get_turn(c.out, i),
                   left = motion_add(get_plane(c.K, i), arm_in_plane(&c, i, get_slide(c.d, i), unit));
            CHECK_NEAR((double)cabsl(left.value), 0, 4e-15);
            CHECK_NEAR((double)cabsl(unit.value), 1, 4e-15 / near);
            assert_true(determinant(&c, i, get_slide(c.d, i), unit) * branch > 0);
            CHECK_NEAR((double)cabsl(left.rate), 0, 1e-13 / near);
            CHECK_NEAR((double)cabsl(left.accel), 0, 1e-12 / cube);
            if (r * branch < 0) continue; // the other branch has no chosen answer
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
    YkTurn out = pool_turn(&pool), none = {0};
    YkSlide d = pool_slide(&pool);
    double *margin = pool_full(&pool, 1), *own = pool_row(&pool);
    const double x[] = {0.9, 0, (double)NAN, 1, 2}; // the line passes the pin at a distance of 1
    for (size_t i = 0; i < 5; i++) put_plane(K, i, (Motion){x[i], 1, 1});
    yk_lanes_rpr(K, (YkArm){.constant = {0, 1}}, none, yk_vec(1, 0), 1, out, d, margin, own, 5);
    for (size_t i = 0; i < 5; i++) assert_true(i >= 3 ? margin[i] >= 0 : margin[i] < 0);
    CHECK_NEAR(own[0], 1 - 1 / 0.81, 1e-15);
    CHECK_NEAR(own[3], 0, 0);
    CHECK_NEAR(d.d[3], 0, 0); // the dead point itself has its place
    CHECK_NEAR(out.s[3], 1, 1e-15);
    CHECK_NEAR(own[4], 0.75, 1e-15);
    double *rows[] = {out.c, out.s, out.w, out.a, d.d, d.v, d.a};
    for (size_t k = 0; k < 7; k++) yk_lanes_mask(rows[k], margin, 1e-12, 5);
    for (size_t k = 0; k < 7; k++)
        for (size_t i = 0; i < 5; i++) assert_true(i == 4 ? isfinite(rows[k][i]) : rows[k][i] == 0);
}

static void a_block_on_its_pivot_has_no_answer(void **state)
{
    (void)state;
    static Pool pool;
    YkPlane K = pool_plane(&pool);
    YkTurn none = {0};
    double *margin = pool_full(&pool, 1);
    put_plane(K, 0, motion_constant(0));
    yk_lanes_rpr(K, (YkArm){0}, none, yk_vec(1, 0), 1, pool_turn(&pool), pool_slide(&pool), margin, NULL, 1);
    CHECK_NEAR(margin[0], -1, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(finds_the_chosen_solution_with_its_rates),
        cmocka_unit_test(what_cannot_close_has_a_negative_margin),
        cmocka_unit_test(a_block_on_its_pivot_has_no_answer),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
