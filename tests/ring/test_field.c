// Values of elements: in doubles and modulo p, both homomorphisms.
#include "ring/field_check.h"
#include "ring/ring_check.h"

static YkVec value(Fixture *f, Element a, const double *values)
{
    return yk_ring_value(f->ring, a, values);
}

static void check_near(YkVec a, YkVec b, double size)
{
    CHECK_NEAR(a.x, b.x, 1e-11 * (1 + size));
    CHECK_NEAR(a.y, b.y, 1e-11 * (1 + size));
}

static void double_values_are_a_homomorphism(void **state)
{
    (void)state;
    Fixture f = fixture_new(1);
    YkRing *r = f.ring;
    double *values = random_values(&f);
    for (int i = 0; i < 2000; i++) {
        Element a = random_element(&f, below(&f, 5)), b = random_element(&f, below(&f, 5));
        YkVec va = value(&f, a, values), vb = value(&f, b, values);
        double size = (yk_norm(va) + 100) * (yk_norm(vb) + 100); // terms are larger than their sum
        check_near(value(&f, yk_ring_add(r, a, b), values), yk_add(va, vb), size);
        check_near(value(&f, yk_ring_multiply(r, a, b), values), yk_mul(va, vb), size);
        check_near(value(&f, yk_ring_conjugate(r, a), values), yk_conj(va), size);
        check_near(value(&f, yk_ring_real(r, a), values), yk_vec(va.x, 0), size);
        check_near(value(&f, yk_ring_imaginary(r, a), values), yk_vec(va.y, 0), size);
    }
    assert_true(isnan(value(&f, NULL, values).x));
    free(values);
    yk_ring_free(r);
}

static void field_values_are_a_homomorphism(void **state)
{
    (void)state;
    Fixture f = fixture_new(2);
    YkRing *r = f.ring;
    yk_ring_root(r, "L", read_text(&f, "l1^2 + m1*cos(theta1)"));
    YkFieldPoint *point = yk_field_point_new(r, 5);
    assert_non_null(point);
    for (int i = 0; i < 2000; i++) {
        Element a = random_element(&f, below(&f, 5)), b = random_element(&f, below(&f, 5));
        uint64_t va = yk_ring_field(r, a, point, false), vb = yk_ring_field(r, b, point, false);
        assert_true(yk_ring_field(r, yk_ring_add(r, a, b), point, false) == yk_field_add(va, vb));
        assert_true(yk_ring_field(r, yk_ring_multiply(r, a, b), point, false) == yk_field_multiply(va, vb));
        assert_true(yk_ring_field(r, yk_ring_conjugate(r, a), point, false) == yk_ring_field(r, a, point, true));
        assert_true(yk_ring_field(r, yk_ring_scale(r, a, -3, 7), point, false) ==
                    yk_field_multiply(va, yk_field_multiply(yk_field_of(-3), yk_field_invert(7))));
        // Two different elements have different values: by chance they never meet.
        if (!yk_ring_is_same(a, b)) assert_true(va != vb);
    }
    int32_t L = yk_ring_find(r, "L");
    uint64_t length = yk_field_point_get(point, L);
    assert_true(yk_field_multiply(length, length) ==
                yk_ring_field(r, read_text(&f, "l1^2 + m1*cos(theta1)"), point, false));
    yk_field_point_free(point);
    yk_ring_free(r);
}

static void trigonometry_holds_at_a_point_set_by_hand(void **state)
{
    (void)state;
    Fixture f = fixture_new(3);
    YkFieldPoint *point = yk_field_point_new(f.ring, 9);
    yk_field_point_set(point, f.parameter[3], 12);
    yk_field_point_set_unit(point, f.angle[0], 1); // theta1 = 0
    assert_true(yk_ring_field(f.ring, read_text(&f, "l1*cos(theta1)/4 + sin(theta1)"), point, false) == 3);
    assert_true(yk_ring_field(f.ring, read_text(&f, "l1^-1*36"), point, false) == 3);
    yk_field_point_set(point, -1, 3); // nothing
    yk_field_point_set_unit(point, 100000, 3);
    assert_true(yk_field_point_get(point, 100000) == 0);
    YkFieldPoint *same = yk_field_point_new(f.ring, 9), *other = yk_field_point_new(f.ring, 10);
    assert_true(yk_field_point_get(same, f.gravity) == yk_field_point_get(point, f.gravity));
    assert_true(yk_field_point_get(other, f.gravity) != yk_field_point_get(point, f.gravity));
    yk_field_point_free(point);
    yk_field_point_free(same);
    yk_field_point_free(other);
    yk_ring_free(f.ring);
}

static void a_name_for_a_number_has_its_value(void **state)
{
    (void)state;
    Fixture f = fixture_new(3);
    int32_t mass = yk_ring_symbol(f.ring, "m_rod", YK_RING_MASS);
    yk_ring_set_number(f.ring, mass, yk_ring_rational(f.ring, 51, 400));
    int32_t root = yk_ring_root(f.ring, "L", read_text(&f, "m_rod^2 + l1^2"));
    assert_true(mass >= 0 && root >= 0);
    for (uint64_t seed = 1; seed < 20; seed++) {
        YkFieldPoint *point = yk_field_point_new(f.ring, seed);
        assert_true(yk_ring_field(f.ring, read_text(&f, "400*m_rod - 51"), point, false) == 0);
        assert_true(yk_ring_field(f.ring, read_text(&f, "L^2 - l1^2 - m_rod*51/400"), point, false) == 0);
        yk_field_point_free(point);
    }
    assert_false(yk_ring_is_same(read_text(&f, "m_rod"), read_text(&f, "51/400"))); // in print it stays
    yk_ring_free(f.ring);
}

// The slow and sure way: double and add.
static uint64_t multiply_slowly(uint64_t a, uint64_t b)
{
    uint64_t sum = 0;
    for (; b > 0; b /= 2) {
        if (b & 1) sum = yk_field_add(sum, a);
        a = yk_field_add(a, a);
    }
    return sum;
}

static void field_arithmetic_is_that_of_the_integers_modulo_p(void **state)
{
    (void)state;
    static const uint64_t edges[] = {
        0, 1, 2, 0xffffffff, 0x100000000, 0x7fffffffffffffff, 0x8000000000000000, YK_PRIME - 2, YK_PRIME - 1};
    enum { EDGES = sizeof edges / sizeof *edges };
    uint64_t seed = 4;
    for (int i = 0; i < 2000; i++) {
        uint64_t a = i < EDGES * EDGES ? edges[i / EDGES] : check_random(&seed) % YK_PRIME;
        uint64_t b = i < EDGES * EDGES ? edges[i % EDGES] : check_random(&seed) % YK_PRIME;
        assert_true(yk_field_multiply(a, b) == multiply_slowly(a, b));
        assert_true(yk_field_add(yk_field_subtract(a, b), b) == a);
        assert_true(yk_field_add(a, yk_field_negate(a)) == 0);
        assert_true(a == 0 || yk_field_multiply(a, yk_field_invert(a)) == 1);
    }
    assert_true(yk_field_of(-1) == YK_PRIME - 1 && yk_field_of(INT64_MIN) == YK_PRIME - 0x8000000000000000u);
}

static void half_of_all_numbers_have_a_root_and_it_is_one(void **state)
{
    (void)state;
    uint64_t seed = 5, root;
    int have = 0;
    for (int i = 0; i < 1000; i++) {
        uint64_t a = check_random(&seed) % YK_PRIME, square = yk_field_multiply(a, a);
        assert_true(yk_field_sqrt(square, &root) && (root == a || root == yk_field_negate(a)));
        bool has = yk_field_sqrt(a, &root);
        if (has) assert_true(yk_field_multiply(root, root) == a);
        assert_true(has == (yk_field_power(a, (YK_PRIME - 1) / 2) == 1)); // Euler
        have += has;
    }
    assert_true(have > 400 && have < 600);
    assert_true(yk_field_sqrt(0, &root) && root == 0);
}

enum { SIDE = 24 };

// Dense ones, ones of few different numbers, ones of few entries.
static uint64_t entry_of(int i, uint64_t *seed)
{
    if (i % 3 == 2 && check_random(seed) % 8 > 0) return 0;
    return check_random(seed) % (i % 3 == 1 ? 3 : YK_PRIME);
}

// Rows and columns have one rank. A and b are lost.
static int rank_of_transpose(const uint64_t *A, size_t rows, size_t columns)
{
    uint64_t turned[SIDE * SIDE], b[SIDE] = {0}, x[SIDE] = {0};
    for (size_t k = 0; k < rows * columns; k++) turned[k % columns * rows + k / columns] = A[k];
    return solve_dense(turned, b, columns, rows, x);
}

static void linear_systems_are_solved_modulo_p(void **state)
{
    (void)state;
    uint64_t seed = 6;
    for (int i = 0; i < 300; i++) {
        size_t rows = 1 + check_random(&seed) % SIDE, columns = 1 + check_random(&seed) % SIDE;
        uint64_t A[SIDE * SIDE], b[SIDE], x[SIDE], A_copy[SIDE * SIDE], b_copy[SIDE], free_value = 77;
        for (size_t k = 0; k < columns; k++) x[k] = check_random(&seed) % YK_PRIME;
        for (size_t k = 0; k < rows * columns; k++) A[k] = entry_of(i, &seed);
        for (size_t k = 0; k < rows; k++) {
            b[k] = 0;
            for (size_t j = 0; j < columns; j++) b[k] = yk_field_add(b[k], yk_field_multiply(A[k * columns + j], x[j]));
        }
        memcpy(A_copy, A, sizeof A);
        memcpy(b_copy, b, sizeof b);
        for (size_t k = 0; k < columns; k++) x[k] = free_value; // of free unknowns
        int rank = solve_dense(A, b, rows, columns, x);
        assert_int_equal(rank, rank_of_transpose(A_copy, rows, columns));
        size_t kept = 0;
        for (size_t k = 0; k < columns; k++) kept += x[k] == free_value;
        assert_true(kept >= columns - (size_t)rank);
        for (size_t k = 0; k < rows; k++) {
            uint64_t sum = 0;
            for (size_t j = 0; j < columns; j++)
                sum = yk_field_add(sum, yk_field_multiply(A_copy[k * columns + j], x[j]));
            assert_true(sum == b_copy[k]);
        }
    }
    uint64_t A[] = {1, 2, 2, 4}, b[] = {1, 3}, x[2] = {0, 0};
    assert_int_equal(solve_dense(A, b, 2, 2, x), -1);
}

static void a_root_without_a_value_may_be_anything(void **state)
{
    (void)state;
    Fixture f = fixture_new(7);
    yk_ring_root(f.ring, "L", number(&f, 7, 1)); // 7 generates the field: it is not a square
    YkFieldPoint *point = yk_field_point_new(f.ring, 1), *other = yk_field_point_new(f.ring, 2);
    assert_true(yk_field_point_is_loose(point));
    int32_t L = yk_ring_find(f.ring, "L");
    assert_true(yk_field_point_get(point, L) != yk_field_point_get(other, L));
    const YkPoisson *square = yk_ring_power(f.ring, yk_ring_of(f.ring, L), 2), *seven = number(&f, 7, 1);
    // neither equal nor different is reported for what depends on it
    assert_int_equal(compare_forms(f.ring, yk_form_of(f.ring, square), yk_form_of(f.ring, seven), 3, 1),
                     YK_FORM_UNDECIDED);
    assert_int_equal(compare_forms(f.ring, yk_form_of(f.ring, square), yk_form_of(f.ring, square), 3, 1),
                     YK_FORM_EQUAL);
    yk_field_point_free(point);
    yk_field_point_free(other);
    double *values = random_values(&f);
    CHECK_NEAR(values[yk_ring_find(f.ring, "L")], sqrt(7), 1e-15);
    free(values);
    yk_ring_free(f.ring);
}

// Forty roots, each of a sum that shares symbols with others, and roots of roots.
static void many_roots_have_their_values(void **state)
{
    (void)state;
    enum { COUNT = 40 };
    YkRing *r = yk_ring_new();
    char name[16];
    const YkPoisson *square[COUNT], *sum = yk_ring_rational(r, 0, 1);
    int32_t root[COUNT];
    for (int k = 0; k < COUNT; k++) {
        snprintf(name, sizeof name, "x%d", k);
        const YkPoisson *x = yk_ring_of(r, yk_ring_symbol(r, name, YK_RING_CONSTANT));
        sum = yk_ring_add(r, sum, yk_ring_power(r, x, 2));
        square[k] = k % 5 == 4 ? yk_ring_add(r, yk_ring_of(r, root[k - 1]), x) : sum;
        snprintf(name, sizeof name, "L%d", k);
        root[k] = yk_ring_root(r, name, square[k]);
    }
    YkFieldPoint *point = yk_field_point_new(r, 3);
    assert_non_null(point);
    assert_false(yk_field_point_is_loose(point));
    for (int k = 0; k < COUNT; k++) {
        uint64_t value = yk_field_point_get(point, root[k]);
        assert_true(yk_field_multiply(value, value) == yk_ring_field(r, square[k], point, false));
    }
    yk_field_point_free(point);
    yk_ring_free(r);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(double_values_are_a_homomorphism),
        cmocka_unit_test(field_values_are_a_homomorphism),
        cmocka_unit_test(trigonometry_holds_at_a_point_set_by_hand),
        cmocka_unit_test(a_name_for_a_number_has_its_value),
        cmocka_unit_test(field_arithmetic_is_that_of_the_integers_modulo_p),
        cmocka_unit_test(half_of_all_numbers_have_a_root_and_it_is_one),
        cmocka_unit_test(linear_systems_are_solved_modulo_p),
        cmocka_unit_test(a_root_without_a_value_may_be_anything),
        cmocka_unit_test(many_roots_have_their_values),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
