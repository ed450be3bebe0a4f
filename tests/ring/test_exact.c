// Exact arithmetic reports when it cannot be exact; products of powers are kept once.
#include "check.h"
#include <stdbool.h>
#include "ring/exact.h"
#include "ring/powers.h"

static const int64_t edges[] = {
    0, 1, -1, 2, -3, 3037000499, 3037000500, -3037000500, INT64_MAX, -INT64_MAX, INT64_MAX / 2 + 1, 1LL << 32};
enum { EDGES = sizeof edges / sizeof *edges };

// By long double, which has 64 bits of mantissa on the machines that matter; else by the doubles' distance from the
// limit.
static bool fits(long double exact)
{
    return exact <= (long double)INT64_MAX && exact >= -(long double)INT64_MAX;
}

// A number that is not negative, of 1 to 63 bits.
static int64_t any_length(uint64_t *seed)
{
    uint64_t bits = check_random(seed);
    return (int64_t)(bits >> (1 + check_random(seed) % 63));
}

static void sums_and_products_fit_or_are_refused(void **state)
{
    (void)state;
    if (sizeof(long double) <= sizeof(double)) skip();
    uint64_t seed = 1;
    for (int i = 0; i < 100000; i++) {
        int64_t a = i < EDGES * EDGES ? edges[i / EDGES] : any_length(&seed);
        int64_t b = i < EDGES * EDGES ? edges[i % EDGES] : -any_length(&seed);
        int64_t sum = 0, product = 0;
        assert_true(yk_exact_add(a, b, &sum) == fits((long double)a + (long double)b));
        bool well = yk_exact_multiply(a, b, &product);
        // A product near the limit is rounded by long double: its own quotient decides there.
        if (well)
            assert_true(b == 0 ? product == 0 : product / b == a && product % b == 0);
        else
            assert_true(fabsl((long double)a * (long double)b) >= (long double)INT64_MAX * 0.999999999999L);
        if (yk_exact_add(a, b, &sum)) assert_true(sum - b == a);
    }
}

static void ratios_are_in_lowest_terms(void **state)
{
    (void)state;
    YkRatio ratio, quotient = {0, 1};
    for (int64_t over = -30; over <= 30; over++)
        for (int64_t under = -30; under <= 30; under++) {
            assert_true(yk_ratio_make(over, under, &ratio) == (under != 0));
            if (under == 0) continue;
            assert_true(ratio.under > 0 && ratio.over * under == over * ratio.under);
            assert_true(yk_gcd(yk_magnitude(ratio.over), (uint64_t)ratio.under) == 1);
            assert_true(yk_ratio_divide((YkRatio){1, 1}, ratio, &quotient) == (over != 0));
            if (over != 0) assert_true(quotient.over * over == quotient.under * under && quotient.under > 0);
        }
    assert_false(yk_ratio_make(INT64_MIN, 1, &ratio));
    assert_false(yk_ratio_make(1, INT64_MIN, &ratio));
    assert_true(yk_ratio_multiply((YkRatio){INT64_MAX, 2}, (YkRatio){2, INT64_MAX}, &ratio) && yk_ratio_is(ratio, 1));
    assert_false(yk_ratio_multiply((YkRatio){INT64_MAX, 2}, (YkRatio){3, 5}, &ratio));
}

static void a_product_of_powers_is_kept_once_however_it_is_made(void **state)
{
    (void)state;
    enum { SYMBOLS = 6, LIMIT = 1 << 20 };
    YkPowers table = {0};
    YkPowersFault fault;
    assert_true(yk_powers_start(&table));
    uint64_t seed = 3;
    for (int i = 0; i < 5000; i++) {
        int32_t exponent[SYMBOLS] = {0};
        uint32_t product = 0;
        for (int k = 0; k < 8; k++) { // one factor after another
            YkPower power = {(int32_t)(check_random(&seed) % SYMBOLS), (int32_t)(check_random(&seed) % 5) - 2};
            exponent[power.symbol] += power.exponent;
            uint32_t factor = yk_powers_enter(&table, &power, power.exponent != 0, LIMIT, &fault);
            product = yk_powers_multiply(&table, product, factor, 1, LIMIT, &fault);
        }
        YkPower whole[SYMBOLS];
        size_t count = 0;
        for (int32_t k = 0; k < SYMBOLS; k++) {
            if (exponent[k] != 0) whole[count++] = (YkPower){k, exponent[k]};
            assert_int_equal(yk_powers_exponent(&table, product, k), exponent[k]);
        }
        assert_int_equal(yk_powers_enter(&table, whole, count, LIMIT, &fault), product);
        assert_int_equal(yk_powers_multiply(&table, product, product, -1, LIMIT, &fault), 0);
    }
    yk_powers_free(&table);
}

static void the_table_of_products_has_limits(void **state)
{
    (void)state;
    YkPowers table = {0};
    YkPowersFault fault;
    assert_true(yk_powers_start(&table));
    const YkPower most = {0, YK_POWER_MAX}, more = {0, YK_POWER_MAX + 1}, other = {1, 1};
    uint32_t item = yk_powers_enter(&table, &most, 1, 2, &fault);
    assert_int_equal(item, 1);
    assert_true(yk_powers_enter(&table, &more, 1, 9, &fault) == YK_NO_PRODUCT && fault == YK_POWERS_TOO_LARGE);
    assert_true(yk_powers_multiply(&table, item, item, 1, 9, &fault) == YK_NO_PRODUCT && fault == YK_POWERS_TOO_LARGE);
    assert_true(yk_powers_enter(&table, &other, 1, 2, &fault) == YK_NO_PRODUCT && fault == YK_POWERS_TOO_LARGE);
    assert_true(yk_powers_enter(&table, &most, 1, 2, &fault) == item && fault == YK_POWERS_FINE);
    yk_powers_free(&table);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(sums_and_products_fit_or_are_refused),
        cmocka_unit_test(ratios_are_in_lowest_terms),
        cmocka_unit_test(a_product_of_powers_is_kept_once_however_it_is_made),
        cmocka_unit_test(the_table_of_products_has_limits),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
