// Writing numbers in the fewest digits that read back.
#include "check.h"
#include <stdlib.h>
#include "base/numbers/decimal.h"
#include "base/number.h"

static double random_double(uint64_t *seed)
{
    for (;;) {
        double value = yk_double_from_bits(check_random(seed));
        if (isfinite(value)) return value;
    }
}

// Doubles of everyday size, some with few digits.
static double everyday_double(uint64_t *seed)
{
    static const double scales[] = {1e-9, 1e-3, 1, 7, 1e3, 1e6, 1e12};
    double value = check_uniform(seed, -1, 1);
    value *= scales[check_random(seed) % 7];
    return check_random(seed) % 2 ? value : rint(value * 1000) / 1000;
}

static const double hard[] = {5e-324,
                              1e-323,
                              1.5e-323,
                              2.2250738585072009e-308,
                              2.2250738585072014e-308,
                              2.2250738585072011e-308,
                              1.7976931348623157e308,
                              1.7976931348623155e308,
                              9007199254740991,
                              9007199254740992,
                              9007199254740994,
                              0.1,
                              0.2,
                              0.3,
                              1.0 / 3,
                              2.0 / 3,
                              1e21,
                              1e22,
                              1e23,
                              9.5e-5,
                              1e-5,
                              9.9999999999999995e-6,
                              123456789012345680,
                              4.35,
                              2.675,
                              1.005,
                              0.5,
                              1.5,
                              2.5,
                              3.5,
                              0.125,
                              0.375,
                              999999.5,
                              9999995,
                              99999.95,
                              5e-5,
                              4.9e-6,
                              2e-44,
                              8.41e21,
                              2.0919495182368195e19,
                              9.409340012568248e18,
                              1.2345678,
                              4.4501477170144023e-308,
                              0x1p-1022,
                              0x1p-1074,
                              0x1p1023,
                              0x1p52,
                              0x1p53,
                              0x1p54,
                              0x1p63,
                              0x1p64,
                              0x1p-52,
                              0x1.fffffffffffffp-1,
                              999999999999999,
                              999999999999999.9,
                              1e15,
                              1e14,
                              1e16,
                              123456789012345.6};
enum { HARD = sizeof hard / sizeof *hard };

// Significant digits of a decimal text, without leading and trailing zeros.
static int significant_digits(const char *text)
{
    int count = 0, zeros = 0;
    for (; *text && *text != 'e'; text++) {
        if (*text < '0' || *text > '9') continue;
        if (*text == '0' && count == 0) continue;
        if (*text == '0') {
            zeros++;
            continue;
        }
        count += zeros + 1;
        zeros = 0;
    }
    return count;
}

// The law: it reads back, no shorter decimal does, and of its length it is the nearest, which is what printf gives.
static void check_shortest(double value)
{
    char text[YK_NUMBER_SIZE], other[64];
    size_t length = yk_number_write(value, text);
    assert_int_equal(length, strlen(text));
    assert_true(length < YK_NUMBER_SIZE);
    if (!(strtod(text, NULL) == value)) fail_msg("%.17g was written %s", value, text);
    int precision = 1;
    do snprintf(other, sizeof other, "%.*e", precision - 1, value);
    while (strtod(other, NULL) != value && ++precision <= 17);
    int digits = significant_digits(text);
    if (digits > precision) fail_msg("%.17g was written %s, but %s is shorter", value, text, other);
    // A decimal of fewer digits than any rounding of the value has would be a neighbour that still reads back (5e-324).
    if (digits == precision && significant_digits(other) == digits) {
        double near = fabs(strtod(text, NULL) - value), best = fabs(strtod(other, NULL) - value);
        assert_true(near <= best);
    }
}

static void the_shortest_form_reads_back_and_nothing_shorter_does(void **state)
{
    (void)state;
    uint64_t seed = 11;
    for (int i = 0; i < 60000; i++) check_shortest(random_double(&seed));
    for (int i = 0; i < 60000; i++) check_shortest(everyday_double(&seed));
    for (int i = 0; i < HARD; i++) {
        check_shortest(hard[i]);
        check_shortest(nextafter(hard[i], 0));
        check_shortest(-nextafter(hard[i], INFINITY) > -INFINITY ? nextafter(hard[i], INFINITY) : hard[i]);
    }
}

static void every_power_of_two_is_written_shortest(void **state)
{
    (void)state;
    for (int e = -1074; e <= 1023; e++) {
        check_shortest(ldexp(1, e));
        check_shortest(nextafter(ldexp(1, e), 0) > 0 ? nextafter(ldexp(1, e), 0) : 1);
    }
}

static void a_million_random_bit_patterns_read_back(void **state)
{
    (void)state;
    uint64_t seed = 12;
    for (int i = 0; i < 1000000; i++) {
        double value = random_double(&seed), back = 0;
        char text[YK_NUMBER_SIZE];
        size_t length = yk_number_write(value, text), sign = text[0] == '-';
        assert_int_equal(yk_number_read(text + sign, length - sign, &back), length - sign);
        if (!(back == fabs(value))) fail_msg("%.17g -> %s -> %.17g", value, text, back);
    }
}

static void the_layout_is_plain_from_1e_minus_5_to_1e15(void **state)
{
    (void)state;
    static const struct {
        double value;
        const char *text;
    } cases[] = {{0.1, "0.1"},
                 {1e-7, "1e-7"},
                 {12, "12"},
                 {-0.0, "-0"},
                 {0, "0"},
                 {NAN, "nan"},
                 {-NAN, "nan"},
                 {INFINITY, "inf"},
                 {-INFINITY, "-inf"},
                 {1e-5, "0.00001"},
                 {9.5e-6, "9.5e-6"},
                 {1.25e-5, "0.0000125"},
                 {1e14, "100000000000000"},
                 {999999999999999, "999999999999999"},
                 {1e15, "1e15"},
                 {1.5e15, "1.5e15"},
                 {1234567890123456, "1.234567890123456e15"},
                 {-2.5, "-2.5"},
                 {1e100, "1e100"},
                 {5e-324, "5e-324"},
                 {1.7976931348623157e308, "1.7976931348623157e308"},
                 {1.0 / 3, "0.3333333333333333"},
                 {100, "100"},
                 {2.0 / 3 * 1e-300, "6.666666666666667e-301"},
                 {0.75, "0.75"},
                 {1e23, "1e23"},
                 {9007199254740993.0, "9.007199254740992e15"},
                 {-1.7976931348623157e308, "-1.7976931348623157e308"},
                 {2.2250738585072014e-308, "2.2250738585072014e-308"}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        char text[YK_NUMBER_SIZE];
        assert_int_equal(yk_number_write(cases[i].value, text), strlen(cases[i].text));
        assert_string_equal(text, cases[i].text);
    }
}

// What printf rounds to, brought into the same shape: digits without trailing zeros, and a power of ten.
static void normal_form(const char *text, char digits[64], int *exponent)
{
    int count = 0, scale = 0, point = 0;
    for (; *text && *text != 'e'; text++) {
        if (*text == '-') continue;
        if (*text == '.') {
            point = 1;
            continue;
        }
        scale -= point;
        if (count > 0 || *text != '0') digits[count++] = *text;
    }
    if (*text == 'e') scale += atoi(text + 1);
    for (; count > 0 && digits[count - 1] == '0'; count--) scale++;
    digits[count] = '\0';
    *exponent = count == 0 ? 0 : scale;
}

static void check_digits(double value, int digits)
{
    char text[YK_NUMBER_SIZE], other[64], a[64], b[64];
    int a_exponent, b_exponent;
    size_t length = yk_number_write_digits(value, digits, text);
    assert_int_equal(length, strlen(text));
    assert_true(length < YK_NUMBER_SIZE);
    snprintf(other, sizeof other, "%.*e", digits - 1, value);
    normal_form(text, a, &a_exponent);
    normal_form(other, b, &b_exponent);
    if (strcmp(a, b) != 0 || a_exponent != b_exponent || (text[0] == '-') != (other[0] == '-'))
        fail_msg("%.17g to %d digits: %s, not %s", value, digits, text, other);
}

static void significant_digits_round_as_printf_does(void **state)
{
    (void)state;
    uint64_t seed = 13;
    for (int i = 0; i < 100000; i++) {
        int digits = 1 + (int)(check_random(&seed) % 17), more = 1 + (int)(check_random(&seed) % 17);
        check_digits(random_double(&seed), digits);
        check_digits(everyday_double(&seed), more);
    }
    for (int i = 0; i < HARD; i++)
        for (int digits = 1; digits <= 17; digits++) {
            check_digits(hard[i], digits);
            check_digits(-nextafter(hard[i], 0), digits);
        }
}

// Ties: k/2^n with all its digits but the last.
static void ties_of_significant_digits_go_to_even(void **state)
{
    (void)state;
    for (int k = 1; k < 2000; k += 2)
        for (int n = -40; n <= 12; n++)
            for (int digits = 1; digits <= 16; digits++) check_digits(ldexp(k, -n), digits);
    char text[YK_NUMBER_SIZE];
    yk_number_write_digits(2.5, 1, text);
    assert_string_equal(text, "2");
    yk_number_write_digits(25, 1, text);
    assert_string_equal(text, "20");
    yk_number_write_digits(9.5, 1, text);
    assert_string_equal(text, "10");
}

static void digits_out_of_range_are_brought_into_it(void **state)
{
    (void)state;
    char text[YK_NUMBER_SIZE];
    yk_number_write_digits(1.0 / 3, 0, text);
    assert_string_equal(text, "0.3");
    yk_number_write_digits(1.0 / 3, 99, text);
    assert_string_equal(text, "0.33333333333333331");
    yk_number_write_digits(-0.0, 3, text);
    assert_string_equal(text, "-0");
    yk_number_write_digits(INFINITY, 3, text);
    assert_string_equal(text, "inf");
}

static void check_fixed(double value, int decimals)
{
    char text[YK_NUMBER_SIZE], other[400];
    size_t length = yk_number_write_fixed(value, decimals, text);
    assert_int_equal(length, strlen(text));
    assert_true(length < YK_NUMBER_SIZE);
    snprintf(other, sizeof other, "%.*f", decimals, value);
    if (strcmp(text, other) != 0) fail_msg("%.17g with %d decimals: %s, not %s", value, decimals, text, other);
}

static void fixed_decimals_equal_printf(void **state)
{
    (void)state;
    uint64_t seed = 14;
    for (int i = 0; i < 100000; i++) {
        int decimals = (int)(check_random(&seed) % 18), exponent = (int)(check_random(&seed) % 170) - 120;
        check_fixed(everyday_double(&seed), decimals);
        double any = ldexp(check_uniform(&seed, -1, 1), exponent);
        if (fabs(any) < 1e15) check_fixed(any, (int)(check_random(&seed) % 18));
    }
    for (int i = 0; i < HARD; i++)
        for (int decimals = 0; decimals <= 17; decimals++)
            if (hard[i] < 1e15) check_fixed(-hard[i], decimals);
}

static void ties_of_fixed_decimals_go_to_even(void **state)
{
    (void)state;
    for (int k = 1; k < 4000; k += 2)
        for (int n = 1; n <= 14; n++)
            for (int decimals = 0; decimals < n; decimals++) check_fixed(ldexp(k, -n), decimals);
    for (int k = 0; k < 50; k++) check_fixed(k + 0.5, 0);
    check_fixed(999999999999999.5, 0);
    check_fixed(0x1p-64, 0);
    check_fixed(0x1p-64 * 3, 17);
}

static void large_values_are_written_shortest_instead_of_fixed(void **state)
{
    (void)state;
    char text[YK_NUMBER_SIZE];
    yk_number_write_fixed(-1e15, 3, text);
    assert_string_equal(text, "-1e15");
    yk_number_write_fixed(1e300, 3, text);
    assert_string_equal(text, "1e300");
    yk_number_write_fixed(NAN, 3, text);
    assert_string_equal(text, "nan");
    yk_number_write_fixed(1.5, -3, text);
    assert_string_equal(text, "2");
    yk_number_write_fixed(0.1, 40, text);
    assert_string_equal(text, "0.10000000000000001");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_shortest_form_reads_back_and_nothing_shorter_does),
        cmocka_unit_test(every_power_of_two_is_written_shortest),
        cmocka_unit_test(a_million_random_bit_patterns_read_back),
        cmocka_unit_test(the_layout_is_plain_from_1e_minus_5_to_1e15),
        cmocka_unit_test(significant_digits_round_as_printf_does),
        cmocka_unit_test(ties_of_significant_digits_go_to_even),
        cmocka_unit_test(digits_out_of_range_are_brought_into_it),
        cmocka_unit_test(fixed_decimals_equal_printf),
        cmocka_unit_test(ties_of_fixed_decimals_go_to_even),
        cmocka_unit_test(large_values_are_written_shortest_instead_of_fixed),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
