// Plane vectors as complex numbers.
#include "check.h"
#include "../check_vec.h"
#include "base/vec.h"

static YkVec random_vec(uint64_t *seed)
{
    return check_vec(seed, -3, 3, -3, 3);
}

static void multiplying_by_a_unit_vector_turns(void **state)
{
    (void)state;
    uint64_t seed = 51;
    for (int i = 0; i < 1000; i++) {
        YkVec a = random_vec(&seed), b = random_vec(&seed);
        double angle = check_uniform(&seed, -10, 10), other = check_uniform(&seed, -10, 10);
        YkVec turned = yk_mul(yk_unit(angle), a);
        CHECK_NEAR(yk_norm(turned), yk_norm(a), 1e-14);
        CHECK_NEAR(yk_cross(a, turned), yk_dot(a, a) * sin(angle), 1e-13);
        YkVec twice = yk_mul(yk_unit(other), turned), once = yk_mul(yk_unit(angle + other), a);
        CHECK_NEAR(yk_norm(yk_sub(twice, once)), 0, 1e-13);
        CHECK_NEAR(yk_dot(turned, yk_mul(yk_unit(angle), b)), yk_dot(a, b), 1e-13);
        YkVec back = yk_mul(yk_conj(yk_unit(angle)), turned);
        CHECK_NEAR(yk_norm(yk_sub(back, a)), 0, 1e-14);
    }
}

static void a_quarter_turn_is_the_derivative_of_turning(void **state)
{
    (void)state;
    uint64_t seed = 52;
    for (int i = 0; i < 100; i++) {
        YkVec a = random_vec(&seed), quarter = yk_mul(yk_vec(0, 1), a);
        assert_true(yk_quarter(a).x == quarter.x && yk_quarter(a).y == quarter.y);
        assert_true(yk_dot(a, yk_quarter(a)) == 0);
        YkVec slope = yk_scale(1 / 2e-6, yk_sub(yk_mul(yk_unit(1e-6), a), yk_mul(yk_unit(-1e-6), a)));
        CHECK_NEAR(yk_norm(yk_sub(slope, yk_quarter(a))), 0, 1e-9);
        YkVec sum = yk_add(a, yk_scale(-1, a));
        assert_true(sum.x == 0 && sum.y == 0);
    }
}

static void the_nearest_turn_is_within_half_a_turn(void **state)
{
    (void)state;
    uint64_t seed = 53;
    for (int i = 0; i < 1000; i++) {
        double angle = check_uniform(&seed, -50, 50), reference = check_uniform(&seed, -50, 50);
        double near = yk_nearest_turn(angle, reference);
        assert_true(fabs(near - reference) <= YK_PI + 1e-13);
        CHECK_NEAR(sin(near), sin(angle), 1e-13);
        CHECK_NEAR(cos(near), cos(angle), 1e-13);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(multiplying_by_a_unit_vector_turns),
        cmocka_unit_test(a_quarter_turn_is_the_derivative_of_turning),
        cmocka_unit_test(the_nearest_turn_is_within_half_a_turn),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
