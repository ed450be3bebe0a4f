// The ring survives the failure of any one allocation: the status says so, nothing leaks, nothing crashes, and what
// comes out is right.
#include "interposed.h"
#include "ring/machines.h"
#include "ring/proof/form.h"

// Symbols of all kinds, arithmetic, derivatives, substitution, forms, points and reading; writes one equation.
static bool use(YkRing *r, YkRingFormat format, YkText *out)
{
    const char *const lift[] = {"s", "s1", "s2"};
    int32_t l = yk_ring_symbol(r, "l", YK_RING_CONSTANT), theta = yk_ring_angle(r, "theta"),
            rate = yk_ring_rates(r, theta);
    yk_ring_function(r, lift, 3, theta);
    const char text[] =
        "l^2*(l + 2*cos(theta + pi/12))^3*theta'^2 + s*theta'*theta'' + cos(theta)*l*(theta' + s)^2 + cos(pi/7)";
    Element a = yk_ring_read(r, YK_RING_TEXT, text, sizeof text - 1, (YkPlace){1, 1, 0}, NULL);
    Element square = yk_ring_add(r, yk_ring_power(r, yk_ring_of(r, l), 2), yk_ring_rational(r, 1, 1));
    int32_t root = yk_ring_root(r, "L", square);
    a = yk_ring_add(r, a, yk_ring_multiply(r, yk_ring_of(r, root), yk_ring_of(r, rate)));
    yk_ring_begin_passing(r);
    a = yk_ring_end_passing(r, yk_ring_add(r, yk_ring_partial(r, a, theta), yk_ring_time_derivative(r, a)));
    const YkRingChange change = {l, yk_ring_add(r, yk_ring_of(r, l), yk_ring_rational(r, 1, 2)), NULL};
    Element changed = yk_ring_substitute(r, a, &change, 1);
    const YkForm *form = yk_form_multiply(r, yk_form_of(r, changed), yk_form_of(r, a));
    YkFieldPoint *point = yk_field_point_new(r, 1);
    uint64_t value;
    bool valued = point && yk_form_field(r, form, point, &value);
    yk_field_point_free(point);
    bool well = valued && yk_form_expand(r, form, 100000) != NULL && yk_ring_is_real(r, changed);
    return well && yk_ring_write(r, changed, format, YK_RING_TEXTBOOK, out) && yk_ring_status(r) == YK_RING_OK;
}

// Enough symbols for the ring to keep patterns, and elements that are alike.
static bool write_alike(YkRing *r, YkRingFormat format, YkText *out)
{
    enum { PAIRS = 66 };
    int32_t mass[PAIRS], length[PAIRS];
    bool well = true;
    for (int k = 0; k < PAIRS; k++) {
        char names[2][8];
        snprintf(names[0], sizeof names[0], "m%d", k);
        snprintf(names[1], sizeof names[1], "l%d", k);
        mass[k] = yk_ring_symbol(r, names[0], YK_RING_MASS);
        length[k] = yk_ring_symbol(r, names[1], YK_RING_CONSTANT);
    }
    for (int k = 0; k < 8; k++) {
        Element of[] = {yk_ring_of(r, mass[k]), yk_ring_of(r, mass[k + 1]), yk_ring_of(r, length[k])};
        Element a = yk_ring_multiply(r, yk_ring_add(r, of[0], of[1]), yk_ring_power(r, of[2], 1 + k % 2));
        well = well && yk_ring_write(r, a, format, YK_RING_TEXTBOOK, out);
    }
    return well && yk_ring_status(r) == YK_RING_OK;
}

static void check_each_failure(bool (*use_of)(YkRing *r, YkRingFormat format, YkText *out), YkRingFormat format)
{
    YkText whole = {0};
    YkRing *ring = yk_ring_new();
    assert_true(use_of(ring, format, &whole));
    yk_ring_free(ring);
    long start = live, k = 0;
    for (bool reached = true; reached; k++) {
        YkText text = {0};
        countdown = k;
        ring = yk_ring_new();
        bool well = ring && use_of(ring, format, &text);
        reached = countdown < 0;
        countdown = -1;
        if (well) assert_string_equal(yk_text_get(&text), yk_text_get(&whole));
        assert_true(well || reached);
        yk_text_free(&text);
        yk_ring_free(ring);
        assert_int_equal(live, start);
    }
    yk_text_free(&whole);
}

static void any_one_failed_allocation_is_told_and_leaks_nothing(void **state)
{
    (void)state;
    skip_unless_interposed();
    for (int format = 0; format < YK_RING_FORMATS; format++) {
        check_each_failure(use, (YkRingFormat)format);
        check_each_failure(write_alike, (YkRingFormat)format);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(any_one_failed_allocation_is_told_and_leaks_nothing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
