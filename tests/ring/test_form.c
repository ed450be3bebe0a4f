// Structured forms: expanded, evaluated and compared.
#include "ring/field_check.h"
#include "ring/ring_check.h"

// A random form and, where it has one, its element: both built by the same operations.
static const YkForm *random_form(Fixture *f, int depth, Element *element)
{
    YkRing *r = f->ring;
    if (depth == 0) {
        *element = random_element(f, below(f, 3));
        return yk_form_of(r, *element);
    }
    Element left, right;
    const YkForm *a = random_form(f, depth - 1, &left), *b = random_form(f, depth - 1, &right);
    switch (below(f, 4)) {
    case 0:
        *element = yk_ring_add(r, left, right);
        return yk_form_add(r, a, b);
    case 1:
        *element = yk_ring_subtract(r, left, right);
        return yk_form_subtract(r, a, b);
    case 2:
        *element = yk_ring_multiply(r, left, right);
        return yk_form_multiply(r, a, b);
    default:
        break;
    }
    Element divisor = random_term(f, true);
    if (yk_ring_is_zero(divisor)) divisor = number(f, 2, 3);
    *element = yk_ring_divide(r, left, divisor);
    return yk_form_divide(r, a, yk_form_of(r, divisor));
}

static void a_form_expands_to_the_element_of_the_same_operations(void **state)
{
    (void)state;
    Fixture f = fixture_new(1);
    for (int i = 0; i < 500; i++) {
        Element element;
        const YkForm *form = random_form(&f, 1 + below(&f, 3), &element);
        check_same(f.ring, yk_form_expand(f.ring, form, 100000), element);
    }
    assert_int_equal(yk_ring_status(f.ring), YK_RING_OK);
    yk_ring_free(f.ring);
}

static void values_of_a_form_are_values_of_its_element(void **state)
{
    (void)state;
    Fixture f = fixture_new(2);
    double *values = random_values(&f);
    YkFieldPoint *point = yk_field_point_new(f.ring, 3);
    for (int i = 0; i < 500; i++) {
        Element element;
        const YkForm *form = random_form(&f, 1 + below(&f, 3), &element);
        uint64_t residue;
        assert_true(yk_form_field(f.ring, form, point, &residue));
        assert_true(residue == yk_ring_field(f.ring, element, point, false));
        YkVec a = yk_form_value(f.ring, form, values), b = yk_ring_value(f.ring, element, values);
        CHECK_NEAR(yk_norm(yk_sub(a, b)), 0, 1e-9 * (1e3 + yk_norm(b)));
    }
    free(values);
    yk_field_point_free(point);
    yk_ring_free(f.ring);
}

static void forms_are_equal_just_when_their_elements_are(void **state)
{
    (void)state;
    Fixture f = fixture_new(3);
    for (int i = 0; i < 300; i++) {
        Element element;
        const YkForm *form = random_form(&f, 2, &element), *flat = yk_form_of(f.ring, element);
        assert_int_equal(compare_forms(f.ring, form, flat, 3, (uint64_t)i), YK_FORM_EQUAL);
        Element off = yk_ring_add(f.ring, element, yk_ring_scale(f.ring, random_element(&f, 1), 1, 1000));
        YkFormVerdict expected = yk_ring_is_same(off, element) ? YK_FORM_EQUAL : YK_FORM_DIFFERENT;
        assert_int_equal(compare_forms(f.ring, form, yk_form_of(f.ring, off), 3, (uint64_t)i), expected);
    }
    yk_ring_free(f.ring);
}

// (l1 + m1 cos theta1)^60: 10^3 terms and coefficients beyond 64 bits when multiplied out, compared in no time when
// not.
static void large_products_are_compared_without_expanding(void **state)
{
    (void)state;
    Fixture f = fixture_new(4);
    YkRing *r = f.ring;
    const YkForm *base = yk_form_of(r, read_text(&f, "l1 + m1*cos(theta1) + 3*d3")), *power = base, *other = base;
    for (int i = 1; i < 80; i++) power = yk_form_multiply(r, base, power), other = yk_form_multiply(r, other, base);
    assert_int_equal(compare_forms(r, power, other, 3, 1), YK_FORM_EQUAL);
    assert_int_equal(compare_forms(r, power, yk_form_multiply(r, other, base), 3, 1), YK_FORM_DIFFERENT);
    assert_null(yk_form_expand(r, power, 1000));
    assert_true(yk_ring_status(r) == YK_RING_SIZE || yk_ring_status(r) == YK_RING_OVERFLOW);
    yk_ring_clear(r);
    assert_null(yk_form_expand(r, yk_form_multiply(r, base, base), 5));
    assert_int_equal(yk_ring_status(r), YK_RING_SIZE);
    yk_ring_clear(r);
    assert_int_equal(yk_ring_terms(yk_form_expand(r, base, 4)), 4);
    yk_ring_free(r);
}

static void division_by_sums_stays_a_quotient(void **state)
{
    (void)state;
    Fixture f = fixture_new(5);
    YkRing *r = f.ring;
    const YkForm *a = yk_form_of(r, read_text(&f, "l1")), *b = yk_form_of(r, read_text(&f, "m1 + cos(theta1)"));
    const YkForm *quotient = yk_form_divide(r, a, b), *zero = yk_form_subtract(r, b, b);
    assert_int_equal(compare_forms(r, yk_form_multiply(r, quotient, b), a, 3, 1), YK_FORM_EQUAL);
    assert_null(yk_form_expand(r, quotient, 100));
    assert_int_equal(yk_ring_status(r), YK_RING_DIVISOR);
    yk_ring_clear(r);
    assert_int_equal(compare_forms(r, yk_form_divide(r, a, zero), a, 3, 1), YK_FORM_UNDECIDED);
    assert_int_equal(compare_forms(r, NULL, a, 3, 1), YK_FORM_UNDECIDED);
    double *values = random_values(&f);
    CHECK_NEAR(yk_form_value(r, quotient, values).x, values[3] / (values[1] + cos(values[f.angle[0]])), 1e-14);
    assert_true(isnan(yk_form_value(r, yk_form_divide(r, a, zero), values).x));
    free(values);
    yk_ring_free(r);
}

static void a_form_tells_its_parts(void **state)
{
    (void)state;
    Fixture f = fixture_new(6);
    YkRing *r = f.ring;
    Element l1 = symbol(&f, "l1");
    const YkForm *a = yk_form_of(r, l1), *sum = yk_form_add(r, a, yk_form_add(r, a, a));
    assert_true(yk_form_element(a) == l1 && yk_form_part_count(a) == 0);
    assert_true(yk_form_element(sum) == NULL && yk_form_part_count(sum) == 2);
    assert_true(yk_form_part(sum, 0) == a && yk_form_part_count(yk_form_part(sum, 1)) == 2);
    assert_null(yk_form_of(r, NULL));
    assert_null(yk_form_add(r, a, NULL));
    const YkForm *tall = a;
    for (int i = 0; i < 20000 && tall; i++) tall = yk_form_add(r, tall, a);
    assert_null(tall); // walking is recursive
    assert_int_equal(yk_ring_status(r), YK_RING_SIZE);
    yk_ring_free(r);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_form_expands_to_the_element_of_the_same_operations),
        cmocka_unit_test(values_of_a_form_are_values_of_its_element),
        cmocka_unit_test(forms_are_equal_just_when_their_elements_are),
        cmocka_unit_test(large_products_are_compared_without_expanding),
        cmocka_unit_test(division_by_sums_stays_a_quotient),
        cmocka_unit_test(a_form_tells_its_parts),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
