// The exact integers behind reading and writing: wide.h, big.h and the table of powers of ten.
#include "check.h"
#include "base/numbers/big.h"
#include "base/numbers/decimal.h"
#include "base/numbers/powers_of_ten.h"

static void both_wide_products_agree(void **state)
{
    (void)state;
    uint64_t seed = 1;
    const uint64_t edges[] = {0, 1, 0xffffffffu, 0x100000000u, UINT64_MAX, UINT64_MAX - 1, (uint64_t)1 << 63};
    for (int i = 0; i < 100000; i++) {
        uint64_t a = i % 3 ? check_random(&seed) : edges[check_random(&seed) % 7];
        uint64_t b = i % 5 ? check_random(&seed) : edges[check_random(&seed) % 7];
        YkWide one = yk_wide_multiply(a, b), two = yk_wide_multiply_halves(a, b);
        assert_true(one.high == two.high && one.low == two.low);
        assert_true(one.low == a * b);
    }
    YkWide square = yk_wide_multiply_halves(UINT64_MAX, UINT64_MAX); // (2^64 - 1)^2 = 2^128 - 2^65 + 1
    assert_true(square.high == UINT64_MAX - 1 && square.low == 1);
}

static void adding_carries_into_the_high_word(void **state)
{
    (void)state;
    YkWide sum = yk_wide_add((YkWide){5, UINT64_MAX}, 1);
    assert_true(sum.high == 6 && sum.low == 0);
    sum = yk_wide_add((YkWide){5, UINT64_MAX - 1}, 1);
    assert_true(sum.high == 5 && sum.low == UINT64_MAX);
}

static void leading_zeros_are_counted(void **state)
{
    (void)state;
    for (int i = 0; i < 64; i++) {
        assert_int_equal(yk_leading_zeros((uint64_t)1 << i), 63 - i);
        assert_int_equal(yk_leading_zeros(((uint64_t)1 << i) | 1), 63 - i);
    }
}

// A second way to every entry: ten times the entry before, one bit at a time, by exact comparison.
static void every_power_of_ten_is_the_floor_of_its_128_bits(void **state)
{
    (void)state;
    for (int k = YK_TEN_MIN; k <= YK_TEN_MAX; k++) {
        YkWide entry = yk_power_of_ten(k);
        int twos = yk_floor_log2_of_ten(k) - 127;
        assert_true(entry.high >> 63 == 1);
        for (uint32_t more = 0; more <= 1; more++) { // entry * 2^twos <= 10^k < (entry + 1) * 2^twos
            YkBig ten = yk_big(1), cut = yk_big(entry.high);
            yk_big_multiply_add(&cut, 1u << 16, 0);
            yk_big_multiply_add(&cut, 1u << 16, (uint32_t)(entry.low >> 32));
            yk_big_multiply_add(&cut, 1u << 16, 0);
            yk_big_multiply_add(&cut, 1u << 16, (uint32_t)entry.low);
            if (more) yk_big_multiply_add(&cut, 1, 1);
            int sign = yk_big_compare(&ten, k, &cut, twos);
            if (more)
                assert_true(sign < 0);
            else
                assert_true(yk_power_of_ten_is_exact(k) ? sign == 0 : sign > 0);
        }
    }
}

static void comparison_is_exact_where_doubles_are(void **state)
{
    (void)state;
    uint64_t seed = 2;
    for (int i = 0; i < 20000; i++) {
        uint64_t a = check_random(&seed) >> 40, b = check_random(&seed) >> 40;
        int tens = (int)(check_random(&seed) % 8), twos = (int)(check_random(&seed) % 24);
        double left = (double)a * pow(10, tens), right = ldexp((double)b, twos);
        YkBig decimal = yk_big(a), binary = yk_big(b);
        assert_int_equal(yk_big_compare(&decimal, tens, &binary, twos), (left > right) - (left < right));
        decimal = yk_big(a);
        binary = yk_big(b);
        left = ldexp((double)a, twos); // divided by 2^twos and 10^tens on both sides
        right = (double)b * pow(10, tens);
        assert_int_equal(yk_big_compare(&decimal, -tens, &binary, -twos), (left > right) - (left < right));
    }
}

static void equal_numbers_compare_equal_however_they_are_written(void **state)
{
    (void)state;
    YkBig a = yk_big(5), b = yk_big(1);
    assert_int_equal(yk_big_compare(&a, -1, &b, -1), 0); // 5 / 10 = 1 / 2
    a = yk_big(1);
    b = yk_big(1000000007);
    assert_int_equal(yk_big_compare(&a, 0, &b, 0), -1);
    a = yk_big(0);
    b = yk_big(0);
    assert_int_equal(yk_big_compare(&a, 300, &b, -1000), 0);
    a = yk_big(152587890625u); // 5^16
    b = yk_big(1);
    assert_int_equal(yk_big_compare(&a, -16, &b, -16), 0);
}

static void multiplying_and_adding_carries_through_all_limbs(void **state)
{
    (void)state;
    YkBig big = yk_big(UINT64_MAX);
    yk_big_multiply_add(&big, 1, 1);
    assert_int_equal(big.count, 3);
    assert_true(big.limb[0] == 0 && big.limb[1] == 0 && big.limb[2] == 1);
    assert_int_equal(yk_big(0).count, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(both_wide_products_agree),
        cmocka_unit_test(adding_carries_into_the_high_word),
        cmocka_unit_test(leading_zeros_are_counted),
        cmocka_unit_test(every_power_of_ten_is_the_floor_of_its_128_bits),
        cmocka_unit_test(comparison_is_exact_where_doubles_are),
        cmocka_unit_test(equal_numbers_compare_equal_however_they_are_written),
        cmocka_unit_test(multiplying_and_adding_carries_through_all_limbs),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
