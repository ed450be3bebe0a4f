// Whole numbers of many limbs and fractions of them, by identities and against arithmetic modulo a prime.
#include "check.h"
#include "num/whole.h"

static const uint64_t prime = 2147483647;

static YkWhole random_whole(uint64_t *seed, uint32_t limbs)
{
    YkWhole a = {.count = limbs};
    for (uint32_t i = 0; i < limbs; i++) {
        uint64_t r = check_random(seed);
        a.limb[i] = r % 5 == 0 ? 0xffffffffu : r % 5 == 1 ? 0 : (uint32_t)(r >> 20); // limbs that carry and borrow
    }
    while (a.count > 0 && a.limb[a.count - 1] == 0) a.count--;
    return a;
}

static uint64_t modulo(const YkWhole *a)
{
    uint64_t rest = 0;
    for (uint32_t i = a->count; i > 0; i--) rest = ((rest << 32) | a->limb[i - 1]) % prime;
    return rest;
}

static void division_gives_back_the_dividend(void **state)
{
    (void)state;
    uint64_t seed = 5;
    for (int trial = 0; trial < 20000; trial++) {
        YkWhole a = random_whole(&seed, 1 + (uint32_t)(check_random(&seed) % 30)), q, r, back, sum;
        YkWhole b = random_whole(&seed, 1 + (uint32_t)(check_random(&seed) % 12));
        YkOverflow overflow = false;
        if (b.count == 0) continue;
        yk_whole_divide(&q, &r, &a, &b);
        assert_true(yk_whole_compare(&r, &b) < 0);
        yk_whole_multiply(&back, &q, &b, &overflow);
        yk_whole_add(&sum, &back, &r, &overflow);
        assert_false(overflow);
        assert_int_equal(yk_whole_compare(&sum, &a), 0);
        assert_int_equal((modulo(&q) * modulo(&b) + modulo(&r)) % prime, modulo(&a));
    }
}

static void the_common_divisor_divides_both_and_nothing_is_left(void **state)
{
    (void)state;
    uint64_t seed = 6;
    for (int trial = 0; trial < 3000; trial++) {
        YkWhole a = random_whole(&seed, 6), b = random_whole(&seed, 5), c = random_whole(&seed, 3), ac, bc, g, q, r,
                one;
        YkOverflow overflow = false;
        yk_whole_multiply(&ac, &a, &c, &overflow);
        yk_whole_multiply(&bc, &b, &c, &overflow);
        if (ac.count == 0 || bc.count == 0) continue;
        yk_whole_common(&g, &ac, &bc);
        yk_whole_divide(&q, &r, &g, &c);
        assert_int_equal(r.count, 0);
        YkWhole x, y;
        yk_whole_divide(&x, &r, &ac, &g);
        assert_int_equal(r.count, 0);
        yk_whole_divide(&y, &r, &bc, &g);
        assert_int_equal(r.count, 0);
        yk_whole_common(&one, &x, &y);
        assert_true(one.count == 1 && one.limb[0] == 1);
    }
}

static void what_does_not_fit_is_noticed(void **state)
{
    (void)state;
    uint64_t seed = 7;
    YkWhole a = {.count = 40}, b = {.count = 25}, c;
    for (uint32_t i = 0; i < 40; i++) a.limb[i] = 0xffffffffu;
    for (uint32_t i = 0; i < 25; i++) b.limb[i] = 0xffffffffu;
    YkOverflow overflow = false;
    yk_whole_multiply(&c, &a, &b, &overflow);
    assert_true(overflow);
    overflow = false;
    YkWhole full = {.count = YK_WHOLE_LIMBS}, unit = yk_whole(1);
    for (uint32_t i = 0; i < YK_WHOLE_LIMBS; i++) full.limb[i] = 0xffffffffu;
    yk_whole_add(&c, &full, &unit, &overflow);
    assert_true(overflow);
    overflow = false;
    b = random_whole(&seed, 24);
    yk_whole_multiply(&c, &a, &b, &overflow);
    assert_false(overflow);
}

static void digits_are_decimal(void **state)
{
    (void)state;
    YkText text = {0};
    YkFraction a = yk_fraction(-108, 46), big = yk_fraction(1, 1), ten = yk_fraction(10, 1);
    YkOverflow overflow = false;
    yk_fraction_write(&a, &text);
    assert_string_equal(yk_text_get(&text), "-54/23");
    for (int k = 0; k < 40; k++) big = yk_fraction_multiply(&big, &ten, &overflow);
    yk_text_clear(&text);
    yk_fraction_write(&big, &text);
    assert_string_equal(yk_text_get(&text), "10000000000000000000000000000000000000000");
    CHECK_NEAR(yk_fraction_value(&big), 1e40, 1e25);
    yk_text_clear(&text);
    a = yk_fraction(0, -3);
    yk_fraction_write(&a, &text);
    assert_string_equal(yk_text_get(&text), "0");
    yk_text_free(&text);
}

// (a + b) c - a c - b c = 0 and a / b * b = a, with numbers that grow.
static void fractions_obey_the_laws_of_a_field(void **state)
{
    (void)state;
    uint64_t seed = 8;
    for (int trial = 0; trial < 3000; trial++) {
        YkOverflow overflow = false;
        YkFraction f[3];
        for (int k = 0; k < 3; k++) {
            f[k] = yk_fraction(1, 1);
            for (int j = 0; j <= trial % 8; j++) {
                int64_t under = (int64_t)(check_random(&seed) % 999) + 1;
                int64_t over = (int64_t)(check_random(&seed) % 2001) - 1000;
                YkFraction by = yk_fraction(over, under);
                if (yk_fraction_is_zero(&by)) by = yk_fraction(7, 3);
                f[k] = yk_fraction_multiply(&f[k], &by, &overflow);
            }
        }
        YkFraction sum = yk_fraction_add(&f[0], &f[1], &overflow), left = yk_fraction_multiply(&sum, &f[2], &overflow);
        YkFraction ac = yk_fraction_multiply(&f[0], &f[2], &overflow),
                   bc = yk_fraction_multiply(&f[1], &f[2], &overflow);
        YkFraction right = yk_fraction_add(&ac, &bc, &overflow), minus = yk_fraction_negative(&right);
        YkFraction rest = yk_fraction_add(&left, &minus, &overflow);
        assert_true(yk_fraction_is_zero(&rest) && !overflow);
        YkFraction ratio = yk_fraction_divide(&f[0], &f[1], &overflow),
                   back = yk_fraction_multiply(&ratio, &f[1], &overflow);
        minus = yk_fraction_negative(&f[0]);
        rest = yk_fraction_add(&back, &minus, &overflow);
        assert_true(yk_fraction_is_zero(&rest) && !overflow);
        double value = yk_fraction_value(&f[0]) / yk_fraction_value(&f[1]);
        CHECK_NEAR(yk_fraction_value(&ratio), value, 1e-14 * fabs(value));
    }
}

static void a_fraction_of_a_double_is_the_double(void **state)
{
    (void)state;
    const double values[] = {0, 1, -0.1, 1e-40, 3.5e60, 0x1.fffffffffffffp-3};
    for (size_t k = 0; k < sizeof values / sizeof *values; k++) {
        YkFraction a = yk_fraction_of(values[k]);
        assert_true(yk_fraction_value(&a) == values[k]);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(division_gives_back_the_dividend),
        cmocka_unit_test(the_common_divisor_divides_both_and_nothing_is_left),
        cmocka_unit_test(what_does_not_fit_is_noticed),
        cmocka_unit_test(digits_are_decimal),
        cmocka_unit_test(fractions_obey_the_laws_of_a_field),
        cmocka_unit_test(a_fraction_of_a_double_is_the_double),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
