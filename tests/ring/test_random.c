// Random elements by the thousand: the laws of the ring, print that reads back, and arithmetic that is right or
// refuses. Every result is also asked of the field: evaluation there shares nothing with the ring's products and sums.
// The gate runs 4000 cases of each of the eight properties. A million of each take three minutes of one processor:
//     YOKE_TEST_RANDOM=1000000 nice -n 15 build/release/tests/test_ring_random
// (November 2026: all passed, 181 s.) A failure prints its case's seed; YOKE_TEST_SEED=SEED runs that case alone.
#include "ring/ring_check.h"

enum { CASES = 4000, RING_CASES = 500 }; // cases in all; with one ring, whose memory grows

static uint64_t case_count(void)
{
    const char *wish = getenv("YOKE_TEST_RANDOM");
    return wish ? strtoull(wish, NULL, 10) : CASES;
}

typedef void (*Property)(Fixture *f);

static struct {
    uint64_t seed;
    bool runs;
} now; // the case

// Runs a property, each case from its own seed.
static void for_all(Property property, uint64_t first_seed)
{
    const char *only = getenv("YOKE_TEST_SEED");
    uint64_t cases = only ? 1 : case_count();
    Fixture f = {0};
    now.runs = true;
    for (uint64_t k = 0; k < cases; k++) {
        if (k % RING_CASES == 0) {
            yk_ring_free(f.ring);
            f = fixture_new(first_seed);
        }
        f.seed = now.seed = only ? strtoull(only, NULL, 10) : first_seed + 7919 * k;
        property(&f);
    }
    now.runs = false;
    yk_ring_free(f.ring);
}

static int tell_case(void **state)
{
    (void)state;
    if (now.runs) print_error("the case of seed %llu\n", (unsigned long long)now.seed);
    now.runs = false;
    return 0;
}

// What an operation must come to, where it has a result.
static void check_field(Fixture *f, Element result, uint64_t expected, const YkFieldPoint *point, const char *what)
{
    if (!result || yk_ring_field(f->ring, result, point, false) == expected) return;
    print_error("%s is wrong in the field\n", what);
    fail();
}

static YkFieldPoint *some_point(Fixture *f)
{
    YkFieldPoint *point = yk_field_point_new(f->ring, f->seed);
    assert_non_null(point);
    return point;
}

// --- Laws

static void associative_and_distributive(Fixture *f)
{
    YkRing *r = f->ring;
    Element a = random_element(f, below(f, 5)), b = random_element(f, below(f, 5)), c = random_element(f, below(f, 4));
    Element ab = yk_ring_multiply(r, a, b), bc = yk_ring_multiply(r, b, c), sum = yk_ring_add(r, a, b);
    check_same(r, yk_ring_multiply(r, ab, c), yk_ring_multiply(r, a, bc));
    check_same(r, yk_ring_add(r, sum, c), yk_ring_add(r, a, yk_ring_add(r, b, c)));
    check_same(r, yk_ring_multiply(r, sum, c), yk_ring_add(r, yk_ring_multiply(r, a, c), bc));
    YkFieldPoint *point = some_point(f);
    uint64_t in_a = yk_ring_field(r, a, point, false), in_b = yk_ring_field(r, b, point, false);
    check_field(f, ab, yk_field_multiply(in_a, in_b), point, "a product");
    check_field(f, sum, yk_field_add(in_a, in_b), point, "a sum");
    check_field(f, yk_ring_conjugate(r, a), yk_ring_field(r, a, point, true), point, "a conjugate");
    yk_field_point_free(point);
}

// Products in which the same terms come again and again, few and many.
static void squares_are_binomial(Fixture *f)
{
    YkRing *r = f->ring;
    Element a = random_element(f, below(f, 8)), b = random_element(f, below(f, 8)), sum = yk_ring_add(r, a, b);
    const Element parts[] = {yk_ring_multiply(r, a, a), yk_ring_scale(r, yk_ring_multiply(r, b, a), 2, 1),
                             yk_ring_multiply(r, b, b)};
    check_same(r, yk_ring_multiply(r, sum, sum), yk_ring_sum(r, parts, 3));
    Element square = yk_ring_multiply(r, yk_ring_conjugate(r, sum), sum); // |u|^2, and it is real
    assert_true(yk_ring_is_real(r, square) && yk_ring_is_same(square, yk_ring_dot(r, sum, sum)));
}

static void derivatives_obey_leibniz(Fixture *f)
{
    YkRing *r = f->ring;
    Element a = random_element(f, below(f, 4)), b = random_element(f, below(f, 4)), ab = yk_ring_multiply(r, a, b);
    int32_t x = any_symbol(f);
    for (int by_time = 0; by_time < 2; by_time++) {
        Element da = by_time ? yk_ring_time_derivative(r, a) : yk_ring_partial(r, a, x);
        Element db = by_time ? yk_ring_time_derivative(r, b) : yk_ring_partial(r, b, x);
        Element d_ab = by_time ? yk_ring_time_derivative(r, ab) : yk_ring_partial(r, ab, x);
        check_same(r, d_ab, yk_ring_add(r, yk_ring_multiply(r, da, b), yk_ring_multiply(r, a, db)));
        Element d_sum =
            by_time ? yk_ring_time_derivative(r, yk_ring_add(r, a, b)) : yk_ring_partial(r, yk_ring_add(r, a, b), x);
        check_same(r, d_sum, yk_ring_add(r, da, db));
    }
}

// --- Print

static bool has_fraction(const char *text) // other than pi/4
{
    for (const char *at = strchr(text, '/'); at; at = strchr(at + 1, '/'))
        if (at - text < 2 || strncmp(at - 2, "pi", 2) != 0) return true;
    return false;
}

static void print_reads_back(Fixture *f)
{
    static const YkRingFormat formats[] = {YK_RING_TEXT, YK_RING_BOOK, YK_RING_LATEX, YK_RING_C};
    YkRing *r = f->ring;
    Element a = random_element(f, below(f, 7)), real = yk_ring_real(r, a);
    YkText text = {0};
    for (size_t k = 0; k < sizeof formats / sizeof *formats; k++) {
        YkRingStyle style = (YkRingStyle)below(f, YK_RING_STYLES);
        Element written = formats[k] == YK_RING_C || below(f, 2) ? real : a;
        yk_text_clear(&text);
        assert_true(yk_ring_write(r, written, formats[k], style, &text));
        check_same(r, read_as(r, formats[k], yk_text_get(&text)), written);
    }
    yk_text_clear(&text);
    assert_true(yk_ring_write(r, a, YK_RING_TEXT, YK_RING_EXPANDED, &text));
    Element half = yk_ring_half_if_whole(r, yk_ring_scale(r, a, 2, 1));
    assert_true((half != NULL) == !has_fraction(yk_text_get(&text)));
    if (half) check_same(r, half, a);
    yk_text_free(&text);
}

// --- Right, or refused

static Element large_term(Fixture *f)
{
    int shift = below(f, 62);
    int64_t over = (int64_t)(check_random(&f->seed) >> 1) >> shift, under = 1 + (below(f, 4) ? 0 : below(f, 1 << 20));
    Element term = random_term(f, true);
    return yk_ring_multiply(f->ring, number(f, below(f, 2) ? over : -over, under), term);
}

static Element large_element(Fixture *f)
{
    Element sum = number(f, 0, 1);
    for (int k = 1 + below(f, 4); k > 0; k--) {
        Element more = yk_ring_add(f->ring, sum, large_term(f));
        if (more) sum = more;
        yk_ring_clear(f->ring);
    }
    return sum;
}

static void check_refusal(Fixture *f, Element result, YkRingStatus allowed)
{
    assert_true(yk_ring_status(f->ring) == (result ? YK_RING_OK : allowed));
    yk_ring_clear(f->ring);
}

static void large_numbers_are_exact_or_refused(Fixture *f)
{
    YkRing *r = f->ring;
    Element a = large_element(f), b = large_element(f);
    YkFieldPoint *point = some_point(f);
    uint64_t in_a = yk_ring_field(r, a, point, false), in_b = yk_ring_field(r, b, point, false);
    Element result = yk_ring_multiply(r, a, b);
    check_field(f, result, yk_field_multiply(in_a, in_b), point, "a large product");
    check_refusal(f, result, YK_RING_OVERFLOW);
    result = yk_ring_subtract(r, a, b);
    check_field(f, result, yk_field_subtract(in_a, in_b), point, "a large difference");
    check_refusal(f, result, YK_RING_OVERFLOW);
    const Element parts[] = {a, b, a};
    result = yk_ring_sum(r, parts, 3);
    check_field(f, result, yk_field_add(yk_field_add(in_a, in_a), in_b), point, "a large sum");
    check_refusal(f, result, YK_RING_OVERFLOW);
    int64_t all_digits = (int64_t)(check_random(&f->seed) >> 1), over = all_digits >> below(f, 62),
            under = 1 + below(f, 1 << 30);
    result = yk_ring_scale(r, a, over, under);
    uint64_t factor = yk_field_multiply(yk_field_of(over), yk_field_invert(yk_field_of(under)));
    check_field(f, result, yk_field_multiply(in_a, factor), point, "a large multiple");
    check_refusal(f, result, YK_RING_OVERFLOW);
    result = yk_ring_real(r, a);
    uint64_t twice = yk_field_add(in_a, yk_ring_field(r, a, point, true));
    check_field(f, result, yk_field_multiply(twice, yk_field_invert(2)), point, "a large real part");
    check_refusal(f, result, YK_RING_OVERFLOW);
    yk_field_point_free(point);
}

static void sizes_are_kept_or_refused(Fixture *f)
{
    YkRing *r = f->ring;
    Element a = random_element(f, 1 + below(f, 6)), b = random_element(f, 1 + below(f, 6));
    Element free_product = yk_ring_multiply(r, a, b), free_rate = yk_ring_time_derivative(r, a);
    size_t limit = 1 + (size_t)below(f, 16);
    yk_ring_set_limit(r, limit);
    Element product = yk_ring_multiply(r, a, b);
    check_refusal(f, product, YK_RING_SIZE);
    Element rate = yk_ring_time_derivative(r, a);
    check_refusal(f, rate, YK_RING_SIZE);
    yk_ring_set_limit(r, YK_RING_TERMS_MAX);
    bool is_operand = product == a || product == b; // by one: nothing is made
    assert_true((is_operand || yk_ring_terms(product) <= limit) && yk_ring_terms(rate) <= limit);
    if (product) check_same(r, product, free_product);
    if (rate) check_same(r, rate, free_rate);
}

// --- Numbers

// Terms without roots: at symbols that are 1 or 2 and angles that are multiples of 90 deg all is exact in doubles.
static Element plain_element(Fixture *f, YkAngleTerm *turn)
{
    YkRing *r = f->ring;
    Element sum = number(f, 0, 1);
    for (int k = below(f, 6); k > 0; k--) {
        int under = 1 + below(f, 6);
        Element term = number(f, below(f, 41) - 20, under);
        for (int i = below(f, 4); i > 0; i--) {
            int32_t x = any_symbol(f);
            if (!yk_ring_is_angle(r, x))
                term = yk_ring_multiply(r, term, yk_ring_power(r, yk_ring_of(r, x), below(f, 7) - 3));
        }
        *turn = (YkAngleTerm){f->angle[below(f, ANGLES)], below(f, 7) - 3};
        term = yk_ring_multiply(r, term, yk_ring_exp(r, turn, (size_t)below(f, 2)));
        if (below(f, 3) == 0) term = yk_ring_multiply(r, term, yk_ring_i(r));
        sum = yk_ring_add(r, sum, term);
    }
    return sum;
}

// 60 * 2^9 clears all denominators: six different ones, and three powers down to 2^-3.
static uint64_t as_field(double value)
{
    double whole = value * 60 * 512;
    assert_true(fabs(whole) < 0x1p45);
    CHECK_NEAR(whole, nearbyint(whole), 1e-2);
    return yk_field_of((int64_t)nearbyint(whole));
}

static void doubles_agree_with_the_field(Fixture *f)
{
    YkRing *r = f->ring;
    YkAngleTerm turn;
    Element a = plain_element(f, &turn);
    double *values = random_values(f);
    YkFieldPoint *point = some_point(f);
    uint64_t i = yk_ring_field(r, yk_ring_i(r), point, false);
    for (size_t s = 0; s < yk_ring_symbol_count(r); s++) {
        int choice = below(f, 4);
        bool is_angle = yk_ring_is_angle(r, (int32_t)s);
        values[s] = is_angle ? choice * 1.57079632679489662 : 1 + choice % 2;
        if (is_angle)
            yk_field_point_set_unit(point, (int32_t)s, yk_field_power(i, (uint64_t)choice));
        else
            yk_field_point_set(point, (int32_t)s, (uint64_t)(1 + choice % 2));
    }
    YkVec value = yk_ring_value(r, a, values);
    uint64_t in_field = yk_field_multiply(yk_ring_field(r, a, point, false), 60 * 512);
    assert_true(in_field == yk_field_add(as_field(value.x), yk_field_multiply(i, as_field(value.y))));
    yk_field_point_free(point);
    free(values);
}

// --- Substitution

static void prepared_changes_do_what_single_ones_do(Fixture *f)
{
    YkRing *r = f->ring;
    Element replaced = random_term(f, true), a = random_element(f, below(f, 6)), b = random_element(f, below(f, 6));
    if (yk_ring_is_zero(replaced)) return;
    const YkRingChange changes[] = {{f->parameter[below(f, PARAMETERS)], replaced, NULL},
                                    {f->angle[below(f, ANGLES)], NULL, random_unit(f)}};
    YkRingChanges *prepared = yk_ring_changes(r, changes, 2);
    Element a_new = yk_ring_change(r, a, prepared), b_new = yk_ring_change(r, b, prepared);
    check_same(r, a_new, yk_ring_substitute(r, a, changes, 2));
    check_same(r, yk_ring_change(r, yk_ring_multiply(r, a, b), prepared), yk_ring_multiply(r, a_new, b_new));
    check_same(r, yk_ring_change(r, yk_ring_add(r, a, b), prepared), yk_ring_add(r, a_new, b_new));
}

#define PROPERTY(name, seed)                                                                                           \
    static void name##_in_all_cases(void **state)                                                                      \
    {                                                                                                                  \
        (void)state;                                                                                                   \
        for_all(name, seed);                                                                                           \
    }
PROPERTY(associative_and_distributive, 11)
PROPERTY(squares_are_binomial, 18)
PROPERTY(derivatives_obey_leibniz, 12)
PROPERTY(print_reads_back, 13)
PROPERTY(large_numbers_are_exact_or_refused, 14)
PROPERTY(sizes_are_kept_or_refused, 15)
PROPERTY(doubles_agree_with_the_field, 16)
PROPERTY(prepared_changes_do_what_single_ones_do, 17)

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_teardown(associative_and_distributive_in_all_cases, tell_case),
        cmocka_unit_test_teardown(squares_are_binomial_in_all_cases, tell_case),
        cmocka_unit_test_teardown(derivatives_obey_leibniz_in_all_cases, tell_case),
        cmocka_unit_test_teardown(print_reads_back_in_all_cases, tell_case),
        cmocka_unit_test_teardown(large_numbers_are_exact_or_refused_in_all_cases, tell_case),
        cmocka_unit_test_teardown(sizes_are_kept_or_refused_in_all_cases, tell_case),
        cmocka_unit_test_teardown(doubles_agree_with_the_field_in_all_cases, tell_case),
        cmocka_unit_test_teardown(prepared_changes_do_what_single_ones_do_in_all_cases, tell_case),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
