// Sums of vectors against the product rule in long double.
#include "lanes_check.h"
#include "../check_vec.h"

typedef struct Case {
    YkPlane out, plus, minus;
    YkTurn turn;
    YkSlide slide;
    YkVec constant, v;
} Case;

static Case make(Pool *pool, uint64_t seed)
{
    Case c = {pool_plane(pool), pool_plane(pool), pool_plane(pool), pool_turn(pool), pool_slide(pool), {0, 0}, {0, 0}};
    c.constant = check_vec(&seed, -2, 2, -2, 2);
    c.v = check_vec(&seed, -2, 2, -2, 2);
    if (seed % 2) c.v.y = 0; // along an axis, as most are
    for (size_t i = 0; i < LANES; i++) {
        put_plane(c.plus, i, random_plane(&seed, 2)), put_plane(c.minus, i, random_plane(&seed, 2));
        put_turn(c.turn, i, random_angle(&seed)), put_slide(c.slide, i, random_real(&seed, -2, 2));
        put_plane(c.out, i, random_plane(&seed, 2));
    }
    return c;
}

static void start_adds_what_is_there(uint64_t seed, bool has_plus, bool has_minus)
{
    static Pool pool;
    pool.used = 0;
    const YkPlane none = {0};
    Case c = make(&pool, seed);
    yk_lanes_start(c.out, c.constant, has_plus ? c.plus : none, has_minus ? c.minus : none, LANES);
    for (size_t i = 0; i < LANES; i++) {
        Motion sum = vec_motion(c.constant);
        if (has_plus) sum = motion_add(sum, get_plane(c.plus, i));
        if (has_minus) sum = motion_add(sum, motion_minus(get_plane(c.minus, i)));
        check_plane(c.out, i, sum, 2e-15);
    }
}

static void start_is_constant_plus_and_minus(void **state)
{
    (void)state;
    for_all_choices(start_adds_what_is_there, 4);
}

static void turned(uint64_t seed, bool turns, bool adds)
{
    static Pool pool;
    pool.used = 0;
    Case c = make(&pool, seed);
    YkTurn turn = turns || adds ? c.turn : (YkTurn){0};
    static Motion expected[LANES];
    for (size_t i = 0; i < LANES; i++) {
        Motion before = adds ? get_plane(c.out, i) : vec_motion(c.constant);
        expected[i] = motion_add(before, motion_times(vec_motion(c.v), get_turn(turn, i)));
    }
    if (adds)
        yk_lanes_add_turn(c.out, turn, c.v, LANES);
    else
        yk_lanes_start_turn(c.out, c.constant, turn, c.v, LANES);
    for (size_t i = 0; i < LANES; i++) check_plane(c.out, i, expected[i], 1e-14);
}

static void a_vector_turns_with_its_body(void **state)
{
    (void)state;
    for_all_choices(turned, 10);
}

static void slid(uint64_t seed, bool turns, bool is_short)
{
    static Pool pool;
    pool.used = 0;
    Case c = make(&pool, seed);
    YkTurn turn = turns ? c.turn : (YkTurn){0};
    size_t n = is_short ? 5 : LANES;
    static Motion expected[LANES];
    for (size_t i = 0; i < LANES; i++) {
        Motion e = motion_times(vec_motion(c.v), get_turn(turn, i));
        expected[i] = motion_add(get_plane(c.out, i), motion_times(get_slide(c.slide, i), e));
        if (i >= n) expected[i] = get_plane(c.out, i); // lanes beyond the count stay as they are
    }
    yk_lanes_add_slide(c.out, turn, c.v, c.slide, n);
    for (size_t i = 0; i < LANES; i++) check_plane(c.out, i, expected[i], 4e-14);
}

static void a_slide_brings_its_coriolis_term(void **state)
{
    (void)state;
    for_all_choices(slid, 10);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(start_is_constant_plus_and_minus),
        cmocka_unit_test(a_vector_turns_with_its_body),
        cmocka_unit_test(a_slide_brings_its_coriolis_term),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
