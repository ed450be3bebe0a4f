// Free-body drawings through the library's door: they are there for who embeds them, and survive failing allocations.
#include "interposed.h"
#include "derive/forces_check.h"
#include "out/free_body.h"

static bool draw_all(const Machine *m)
{
    YkDerivation *d = yk_derivation_new(m->model, m->mech, NULL);
    YkFreeBodyDrawings *pictures = d ? yk_free_body_drawings_new(d, m->state) : NULL;
    bool good = pictures != NULL;
    for (size_t k = 0; good && k < yk_free_body_drawings_count(pictures); k++)
        good = yk_free_body_drawings_svg(pictures, k) != NULL;
    yk_free_body_drawings_free(pictures);
    yk_derivation_free(d);
    return good;
}

static void bodies_come_first_then_junctions(void **state)
{
    (void)state;
    Machine m = example("toggle");
    YkDerivation *d = yk_derivation_new(m.model, m.mech, NULL);
    YkFreeBodyDrawings *pictures = yk_free_body_drawings_new(d, m.state);
    assert_non_null(pictures);
    assert_int_equal(yk_free_body_drawings_count(pictures), 6);
    assert_string_equal(yk_free_body_drawings_title(pictures, 0), "link1, body 1");
    assert_string_equal(yk_free_body_drawings_stem(pictures, 4), "5-slider");
    assert_string_equal(yk_free_body_drawings_stem(pictures, 5), "junction-J");
    const char *svg = yk_free_body_drawings_svg(pictures, 5);
    assert_non_null(strstr(svg, "<title>-F_J2, by link2</title>"));
    assert_null(strstr(svg, "nan"));
    yk_free_body_drawings_free(pictures);
    yk_derivation_free(d);
    machine_end(&m);
}

static void any_one_failure_is_survived(void **state)
{
    (void)state;
    skip_unless_interposed();
    Machine m = example("toggle");
    long before = live, failures = 0;
    for (long k = 0;; k++) {
        countdown = k;
        bool well = draw_all(&m), is_past = countdown >= 0;
        countdown = -1;
        assert_int_equal(live, before);
        if (is_past) {
            assert_true(well);
            break;
        }
        failures += !well;
    }
    assert_true(failures > 50);
    machine_end(&m);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(bodies_come_first_then_junctions),
                                       cmocka_unit_test(any_one_failure_is_survived)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
