// Reading decimal numbers to the nearest double.
#include "check.h"
#include <stdlib.h>
#include "base/numbers/decimal.h"
#include "base/number.h"

// The law: the whole text is read, to the double strtod gives (glibc rounds correctly).
static void check_read(const char *text)
{
    double value = -1;
    size_t length = strlen(text);
    if (yk_number_read(text, length, &value) != length) fail_msg("%s was not read to its end", text);
    double expected = strtod(text, NULL);
    if (yk_double_bits(value) != yk_double_bits(expected)) fail_msg("%s was read as %a, not %a", text, value, expected);
}

static double random_magnitude(uint64_t *seed)
{
    for (;;) {
        double value = fabs(yk_double_from_bits(check_random(seed)));
        if (isfinite(value)) return value;
    }
}

static void a_million_random_bit_patterns_in_17_digits_read_back(void **state)
{
    (void)state;
    uint64_t seed = 21;
    for (int i = 0; i < 1000000; i++) {
        char text[64];
        double value = random_magnitude(&seed), back = -1;
        size_t length = (size_t)snprintf(text, sizeof text, "%.17g", value);
        assert_int_equal(yk_number_read(text, length, &back), length);
        if (yk_double_bits(back) != yk_double_bits(value)) fail_msg("%s was read as %a, not %a", text, back, value);
    }
}

// The first characters of a text read as they would alone, whatever follows them.
static void what_follows_the_end_is_not_read(void **state)
{
    (void)state;
    static const char letters[] = "0123456789.eE+-";
    uint64_t seed = 23;
    for (int i = 0; i < 20000; i++) {
        char text[12], alone[12];
        for (size_t k = 0; k < sizeof text; k++) text[k] = letters[check_random(&seed) % (sizeof letters - 1)];
        size_t length = check_random(&seed) % sizeof text;
        memcpy(alone, text, length);
        alone[length] = '\0';
        double here = -1, there = -1;
        assert_int_equal(yk_number_read(text, length, &here), yk_number_read(alone, length, &there));
        if (yk_double_bits(here) != yk_double_bits(there)) fail_msg("%s: %a, then %a", alone, here, there);
    }
}

static void random_decimals_read_as_strtod_reads_them(void **state)
{
    (void)state;
    uint64_t seed = 22;
    for (int i = 0; i < 300000; i++) {
        char text[80];
        size_t length = 0;
        int digits = 1 + (int)(check_random(&seed) % 40), point = (int)(check_random(&seed) % 40);
        for (int k = 0; k < digits; k++) {
            if (k == point) text[length++] = '.';
            text[length++] = (char)('0' + check_random(&seed) % 10);
        }
        int most = check_random(&seed) % 2 ? 700 : 40;
        int exponent = (int)(check_random(&seed) % (uint64_t)most);
        if (check_random(&seed) % 4)
            snprintf(text + length, 12, "e%d", exponent - 350 + 330 * (exponent < 40));
        else
            text[length] = '\0';
        check_read(text);
    }
}

// Exactly between two doubles, and a hair to either side: the longest way through the code.
static void midpoints_round_to_even_and_their_neighbours_away(void **state)
{
    (void)state;
    uint64_t seed = 23;
    for (int i = 0; i < 3000; i++) {
        char text[1200];
        uint64_t bits = yk_double_bits(random_magnitude(&seed));
        if (i % 3 == 0) bits &= 0x000fffffffffffffu;                                 // subnormal
        if (i % 3 == 1) bits = (bits >> 12 & 0x3ffu) << 52 | (bits & 0xffffu) << 36; // below 2, few bits
        double low = yk_double_from_bits(bits), high = yk_double_from_bits(bits + 1);
        if (!isfinite(high)) continue;
        long double middle = ((long double)low + (long double)high) / 2; // exact: 64 bits of mantissa, a larger range
        assert_true(middle > low && middle < high);
        int length = snprintf(text, sizeof text, "%.800Le", middle);
        char *e = strchr(text, 'e'), exponent[16];
        assert_true(length > 800 && e != NULL);
        snprintf(exponent, sizeof exponent, "%s", e);
        double value = -1;
        assert_int_equal(yk_number_read(text, strlen(text), &value), strlen(text));
        assert_true(value == (bits & 1 ? high : low));
        snprintf(e, 64, "00000000000000000000001%s", exponent);
        assert_int_equal(yk_number_read(text, strlen(text), &value), strlen(text));
        assert_true(value == high);
        char *last = e - 1; // ...5000 becomes ...4999
        for (; *last == '0' || *last == '.'; last--)
            if (*last == '0') *last = '9';
        --*last;
        assert_int_equal(yk_number_read(text, strlen(text), &value), strlen(text));
        if (!(value == low)) fail_msg("%a, not %a from %s", value, low, text);
    }
}

static void hard_cases_read_as_strtod_reads_them(void **state)
{
    (void)state;
    static const char *const cases[] = {
        "0",
        "0.0",
        "0e5",
        "0e99999",
        "0.000e-400",
        "1",
        "1.",
        ".5",
        "00012",
        "3.e2",
        "1e400",
        "1e-400",
        "1e308",
        "1.8e308",
        "1e309",
        "1.7976931348623157e308",
        "1.7976931348623158e308",
        "1.7976931348623159e308",
        "17976931348623158079372897140530341507993413271003782693617377898044496829276475094664901797758720709633028641"
        "66928879109465555478519404026306574886715058206819089020007083836762738548458177115317644757302700698555713669"
        "59622842914819860834936475292719074168444365510704342711559699508093042880",
        "17976931348623158079372897140530341507993413271003782693617377898044496829276475094664901797758720709633028641"
        "66928879109465555478519404026306574886715058206819089020007083836762738548458177115317644757302700698555713669"
        "59622842914819860834936475292719074168444365510704342711559699508093042879.999",
        "9007199254740991",
        "9007199254740992",
        "9007199254740993",
        "9007199254740993.0000000000000000001",
        "9007199254740995",
        "9007199254740992.9999999999999999999999",
        "18014398509481985",
        "18014398509481986",
        "18446744073709551615",
        "18446744073709551616",
        "9999999999999999999",
        "99999999999999999999",
        "99999999999999999999999999999e-10",
        "5e-324",
        "4.9e-324",
        "4.9406564584124654e-324",
        "2.4703282292062327e-324",
        "2.4703282292062328e-324",
        "2.5e-324",
        "2.4703282292062327208e-324",
        "2.47032822920623272088284396434110686182e-324",
        "2.47032822920623272088284396434110686183e-324",
        "2.2250738585072011e-308",
        "2.2250738585072012e-308",
        "2.2250738585072014e-308",
        "2."
        "22507385850720113605740979670913197593481954635164564802342610972482222202107694551652952390813508791414915891"
        "30396211068700864386945946455276572074078206217433799881410632673292535522868813721490129811224514518898490572"
        "22307285255133155755015914397476397983411801999323962548289017107081850690630666655994938275772572015763062690"
        "66333264756530000924588831643303777979186961204949739037782970490505108060994073026293712895895000358379996720"
        "72543043602840788957717961509455167482434710307026091446215722898802581825451803257070188608721131280795122334"
        "26288368622321503775666622503982534335974568884423900265498198385487948292206894721689831099698365846814022854"
        "24333066033985088644580400103493397042756718644338377048603786162277173854562306587467901408672332763671875123"
        "4567890123456789012345678901e-308",
        "1.00000000000000011102230246251565404",
        "1.00000000000000011102230246251565405",
        "1.000000000000000111022302462515654042363166809082031250",
        "1.000000000000000111022302462515654042363166809082031250000000000001",
        "0.1",
        "0.3",
        "1e22",
        "1e23",
        "8.5e22",
        "123456789e-30",
        "6.631236846766476e-316",
        "3."
        "23788391330290128958835241250153217486303766942310805990129704955230197067067656578683574258779955786061577655"
        "98382834355143910841531692526891905643964595773946180389283653051434639551003566966656292020173313440317300443"
        "69360205258345803431471660032699580731300954848363975548690010751530018881758184174569652173110473696022749934"
        "63842538062336977473656000899740406096749802838919187896396857543922220641698146269011334252400272438594165105"
        "12935526014211553334302252372915238433223313261384314778235911424088000307751706259156707286570031519536642607"
        "69822494937951845801530895238439819708403389937873241463484205608000027270531106827387907791444918534771598750"
        "162812548862768493201518991668028251730299953143924168545708663913273994694463908672332763671875e-316"};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) check_read(cases[i]);
}

static void eight_hundred_digits_and_more_are_all_looked_at(void **state)
{
    (void)state;
    uint64_t seed = 24;
    for (int i = 0; i < 300; i++) {
        char text[2100];
        size_t length = 0;
        while (length < 800) text[length++] = (char)('0' + check_random(&seed) % 10);
        snprintf(text + length, 16, "e%d", -(int)(check_random(&seed) % 1200));
        check_read(text);
    }
    // 1 + 2^-53 + 10^-2000: only the last digit says up.
    char text[2100];
    memset(text, '0', sizeof text);
    memcpy(text, "1.00000000000000011102230246251565404236316680908203125", 55);
    text[2002] = '1';
    text[2003] = '\0';
    check_read(text);
    text[2002] = '0';
    check_read(text);
}

static void far_exponents_do_not_overflow(void **state)
{
    (void)state;
    double value;
    char text[3000];
    const char *huge = "1e99999999999999999999999", *tiny = "1e-99999999999999999999999";
    assert_int_equal(yk_number_read(huge, strlen(huge), &value), strlen(huge));
    assert_true(value == INFINITY);
    assert_int_equal(yk_number_read(tiny, strlen(tiny), &value), strlen(tiny));
    assert_true(value == 0);
    snprintf(text, sizeof text, "0.%02000d1e2001", 0); // the exponent undoes the zeros
    check_read(text);
    assert_int_equal(yk_number_read(text, strlen(text), &value), strlen(text));
    assert_true(value == 1);
    snprintf(text, sizeof text, "1%02000de-2000", 0);
    assert_int_equal(yk_number_read(text, strlen(text), &value), strlen(text));
    assert_true(value == 1);
}

static void only_the_number_at_the_start_is_read(void **state)
{
    (void)state;
    static const struct {
        const char *text;
        size_t length;
        double value;
    } cases[] = {{"3q", 1, 3},      {"2em", 1, 2},    {"2e", 1, 2},  {"2e+", 1, 2},     {"2e+x", 1, 2},
                 {"1.5.2", 3, 1.5}, {"30deg", 2, 30}, {"3/4", 1, 3}, {"1e3m", 3, 1000}, {"1E+3", 4, 1000},
                 {"1e-3", 4, 1e-3}, {"7 mm", 1, 7},   {"5.", 2, 5},  {"12,5", 2, 12},   {"", 0, -1},
                 {".", 0, -1},      {"-1", 0, -1},    {"+1", 0, -1}, {"inf", 0, -1},    {"nan", 0, -1},
                 {"e5", 0, -1},     {".e5", 0, -1},   {" 1", 0, -1}, {"0x10", 1, 0}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        double value = -1;
        assert_int_equal(yk_number_read(cases[i].text, strlen(cases[i].text), &value), cases[i].length);
        assert_true(value == cases[i].value);
    }
    double value = -1;
    assert_int_equal(yk_number_read("12345", 3, &value), 3); // the length is respected, no NUL is needed
    assert_true(value == 123);
    assert_int_equal(yk_number_read("1e5", 2, &value), 1);
    assert_true(value == 1);
}

static void the_exact_decimal_has_no_trailing_zeros(void **state)
{
    (void)state;
    static const struct {
        const char *text;
        int64_t mantissa;
        int32_t exponent;
    } cases[] = {{"1.50", 15, -1},
                 {"60", 6, 1},
                 {"0", 0, 0},
                 {"0.000", 0, 0},
                 {"0e77", 0, 0},
                 {"9.81", 981, -2},
                 {"1e-3", 1, -3},
                 {"9223372036854775807", INT64_MAX, 0},
                 {"9223372036854775807000", INT64_MAX, 3},
                 {"0.00012", 12, -5},
                 {"1000000000000000000000000000", 1, 27},
                 {"1.00000000000000000000000000", 1, 0},
                 {"12.", 12, 0},
                 {"1e-2000000000", 1, -2000000000}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        int64_t mantissa = -1;
        int32_t exponent = -1;
        assert_true(yk_number_read_exact(cases[i].text, strlen(cases[i].text), &mantissa, &exponent));
        assert_true(mantissa == cases[i].mantissa);
        assert_int_equal(exponent, cases[i].exponent);
    }
}

static void a_decimal_that_does_not_fit_is_not_exact(void **state)
{
    (void)state;
    static const char *const cases[] = {"9223372036854775808",
                                        "99999999999999999999",
                                        "1.2345678901234567890123",
                                        "",
                                        "x",
                                        "1e3000000000",
                                        "1e-99999999999999999999",
                                        "1e-2147483648",
                                        "1e2147483648"};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        int64_t mantissa;
        int32_t exponent;
        assert_false(yk_number_read_exact(cases[i], strlen(cases[i]), &mantissa, &exponent));
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_million_random_bit_patterns_in_17_digits_read_back),
        cmocka_unit_test(random_decimals_read_as_strtod_reads_them),
        cmocka_unit_test(what_follows_the_end_is_not_read),
        cmocka_unit_test(midpoints_round_to_even_and_their_neighbours_away),
        cmocka_unit_test(hard_cases_read_as_strtod_reads_them),
        cmocka_unit_test(eight_hundred_digits_and_more_are_all_looked_at),
        cmocka_unit_test(far_exponents_do_not_overflow),
        cmocka_unit_test(only_the_number_at_the_start_is_read),
        cmocka_unit_test(the_exact_decimal_has_no_trailing_zeros),
        cmocka_unit_test(a_decimal_that_does_not_fit_is_not_exact),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
