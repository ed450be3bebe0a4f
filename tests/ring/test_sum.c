// Sums of elements with large numbers: exact where the result fits, refused where it does not, never wrong.
#include "ring/ring_check.h"

enum { DIGITS = 62 };

// A rational with up to `bits` bits, over a small denominator.
static Element large_number(Fixture *f, int bits)
{
    int64_t over = (int64_t)(check_random(&f->seed) >> (64 - bits));
    int under = 1 + below(f, 12);
    return number(f, below(f, 2) ? over : -over, under);
}

static Element large_element(Fixture *f)
{
    Element sum = number(f, 0, 1);
    for (int i = 0; i < 3; i++) {
        Element mass = yk_ring_of(f->ring, f->parameter[below(f, 3)]);
        Element term = yk_ring_multiply(f->ring, large_number(f, 1 + below(f, DIGITS)), mass);
        sum = yk_ring_add(f->ring, sum, term);
        if (!sum) return NULL;
    }
    return sum;
}

// An operation and its undoing: either both fit and give the start back, or the status says overflow.
static void what_fits_is_exact_and_what_does_not_is_refused(void **state)
{
    (void)state;
    Fixture f = fixture_new(1);
    YkRing *r = f.ring;
    int fitted = 0, refused = 0;
    for (int i = 0; i < 20000; i++) {
        Element a = large_element(&f), b = large_element(&f);
        Element sum = yk_ring_add(r, a, b), back = yk_ring_subtract(r, sum, b);
        if (back) check_same(r, back, a);
        if (!sum) assert_int_equal(yk_ring_status(r), YK_RING_OVERFLOW);
        fitted += back != NULL;
        refused += sum == NULL;
        yk_ring_clear(r);
    }
    assert_true(fitted > 1000 && refused > 1000);
    yk_ring_free(r);
}

static void a_product_that_fits_divides_back(void **state)
{
    (void)state;
    Fixture f = fixture_new(2);
    YkRing *r = f.ring;
    int fitted = 0, refused = 0;
    for (int i = 0; i < 20000; i++) {
        Element a = large_element(&f), c = large_number(&f, 1 + below(&f, 40));
        if (!a || yk_ring_is_zero(c)) {
            yk_ring_clear(r);
            continue;
        }
        Element product = yk_ring_multiply(r, a, c), back = yk_ring_divide(r, product, c);
        if (product)
            check_same(r, back, a); // the way back cancels before it multiplies
        else
            assert_int_equal(yk_ring_status(r), YK_RING_OVERFLOW);
        fitted += product != NULL;
        refused += product == NULL;
        yk_ring_clear(r);
    }
    assert_true(fitted > 1000 && refused > 1000);
    yk_ring_free(r);
}

static void overflow_is_told_by_every_operation(void **state)
{
    (void)state;
    Fixture f = fixture_new(3);
    YkRing *r = f.ring;
    Element huge = number(&f, INT64_MAX, 1), tiny = number(&f, 1, INT64_MAX), x = symbol(&f, "l1");
    Element wide = yk_ring_multiply(r, huge, x), thin = yk_ring_multiply(r, tiny, x);
    Element failures[] = {yk_ring_add(r, wide, wide),
                          yk_ring_subtract(r, wide, yk_ring_negate(r, wide)),
                          yk_ring_sum(r, (Element[]){wide, wide}, 2),
                          yk_ring_sum(r, (Element[]){tiny, number(&f, 1, 2)}, 2),
                          yk_ring_sum(r, (Element[]){wide, number(&f, 1, 2)}, 2),
                          yk_ring_add(r, tiny, number(&f, 1, 2)),
                          yk_ring_add(r, wide, number(&f, 1, 3)),
                          yk_ring_multiply(r, wide, wide),
                          yk_ring_multiply(r, thin, thin),
                          yk_ring_scale(r, wide, 2, 1),
                          yk_ring_scale(r, thin, 1, 2),
                          yk_ring_scale(r, yk_ring_add(r, wide, symbol(&f, "m1")), 2, 1),
                          yk_ring_real(r, yk_ring_multiply(r, thin, yk_ring_unit(r, f.angle[0]))),
                          yk_ring_partial(r, yk_ring_power(r, yk_ring_multiply(r, wide, x), 1), f.parameter[3]),
                          yk_ring_turn(r, 1, INT64_MIN),
                          yk_ring_scale(r, x, 1, INT64_MIN)};
    for (size_t i = 0; i < sizeof failures / sizeof *failures; i++)
        if (failures[i]) fail_msg("%d", (int)i);
    assert_int_equal(yk_ring_status(r), YK_RING_OVERFLOW);
    yk_ring_free(r);
}

// Derivatives whose images have denominators without a common multiple in 64 bits.
static void a_derivative_with_large_denominators_is_refused(void **state)
{
    (void)state;
    Fixture f = fixture_new(4);
    YkRing *r = f.ring;
    int32_t a = yk_ring_symbol(r, "a", YK_RING_FUNCTION), b = yk_ring_symbol(r, "b", YK_RING_FUNCTION);
    assert_true(yk_ring_set_rate(r, a, number(&f, 1, 9223372036854775783)) &&
                yk_ring_set_rate(r, b, number(&f, 1, 4611686018427387847)));
    check_same(r, yk_ring_time_derivative(r, yk_ring_of(r, a)), number(&f, 1, 9223372036854775783));
    assert_null(yk_ring_time_derivative(r, yk_ring_add(r, yk_ring_of(r, a), yk_ring_of(r, b))));
    assert_int_equal(yk_ring_status(r), YK_RING_OVERFLOW);
    yk_ring_clear(r);
    assert_null(yk_ring_time_derivative(r, yk_ring_scale(r, yk_ring_of(r, a), 1, 3)));
    assert_int_equal(yk_ring_status(r), YK_RING_OVERFLOW);
    yk_ring_free(r);
}

static void a_null_part_makes_the_whole_null(void **state)
{
    (void)state;
    Fixture f = fixture_new(5);
    YkRing *r = f.ring;
    Element one = number(&f, 1, 1);
    Element results[] = {yk_ring_add(r, NULL, one),
                         yk_ring_subtract(r, one, NULL),
                         yk_ring_sum(r, (Element[]){one, NULL}, 2),
                         yk_ring_product(r, (Element[]){one, NULL}, 2),
                         yk_ring_multiply(r, NULL, NULL),
                         yk_ring_scale(r, NULL, 1, 2),
                         yk_ring_negate(r, NULL),
                         yk_ring_power(r, NULL, 2),
                         yk_ring_divide(r, one, NULL),
                         yk_ring_divide(r, NULL, one),
                         yk_ring_conjugate(r, NULL),
                         yk_ring_real(r, NULL),
                         yk_ring_imaginary(r, NULL),
                         yk_ring_dot(r, NULL, one),
                         yk_ring_cross(r, one, NULL),
                         yk_ring_partial(r, NULL, 0),
                         yk_ring_time_derivative(r, NULL),
                         yk_ring_substitute(r, NULL, NULL, 0),
                         yk_ring_coefficient(r, NULL, 0, 1),
                         yk_ring_content(r, NULL)};
    for (size_t i = 0; i < sizeof results / sizeof *results; i++) assert_null(results[i]);
    int32_t lowest, highest;
    assert_false(yk_ring_powers(r, NULL, 0, &lowest, &highest));
    assert_false(yk_ring_is_zero(NULL) || yk_ring_is_same(NULL, NULL) || yk_ring_is_equal(r, NULL, one) ||
                 yk_ring_is_real(r, NULL));
    assert_false(yk_ring_mentions(r, NULL, 0));
    assert_int_equal(yk_ring_terms(NULL), 0);
    assert_int_equal(yk_ring_status(r), YK_RING_OK); // the first failure was reported
    yk_ring_free(r);
}

// Enough terms for several rounds of the merge sort and a growing hash table.
static void long_sums_stay_sorted(void **state)
{
    (void)state;
    Fixture f = fixture_new(6);
    YkRing *r = f.ring;
    Element up = number(&f, 0, 1), parts[700];
    for (int i = 0; i < 700; i++) {
        int k = i * 319 % 700; // another order
        parts[k] = yk_ring_scale(r,
                                 yk_ring_product(r,
                                                 (Element[]){yk_ring_power(r, symbol(&f, "l1"), i % 26),
                                                             yk_ring_power(r, symbol(&f, "m1"), i / 26)},
                                                 2),
                                 i + 1, 1);
        up = yk_ring_add(r, up, parts[k]);
    }
    assert_int_equal(yk_ring_terms(up), 700);
    check_same(r, yk_ring_sum(r, parts, 700), up);
    assert_true(yk_ring_is_zero(yk_ring_subtract(r, yk_ring_sum(r, parts, 700), up)));
    yk_ring_free(r);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_fits_is_exact_and_what_does_not_is_refused),
        cmocka_unit_test(a_product_that_fits_divides_back),
        cmocka_unit_test(overflow_is_told_by_every_operation),
        cmocka_unit_test(a_derivative_with_large_denominators_is_refused),
        cmocka_unit_test(a_null_part_makes_the_whole_null),
        cmocka_unit_test(long_sums_stay_sorted),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
