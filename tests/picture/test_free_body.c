// Free-body drawings through the public header: available to programs that embed them, and safe when allocations fail.
#include "derive/forces_check.h"
#include "interposed.h"
#include "picture/free_body.h"

static bool draw_all(const Machine *m)
{
    YkDerivation *d = yk_derivation_new(m->model, m->mech, NULL);
    YkFreeBodyDrawings *pictures = d ? yk_free_body_drawings_new(d, m->state, NULL) : NULL;
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
    YkFreeBodyDrawings *pictures = yk_free_body_drawings_new(d, m.state, NULL);
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

// A hanging chain: far from the ground no position is written as a formula, and still it is drawn. The same force
// leaves one body as it comes to the next.
static void long_chains_are_drawn_to_their_end(void **state)
{
    (void)state;
    enum { LINKS = 150 };
    YkText text = {0};
    yk_text_puts(&text, "bodies:\n  ground: {points: {J1: [0, 0]}}\n");
    for (int k = 1; k <= LINKS; k++)
        yk_text_format(&text, "  b%d: {points: {J%d: [0, 0], J%d: [1, 0]}, mass: 1, center: [0.5, 0], inertia: 1}\n", k,
                       k, k + 1);
    yk_text_puts(&text, "joints:\n");
    for (int k = 1; k <= LINKS; k++) {
        yk_text_format(&text, "  J%d: {pin: [", k);
        yk_text_format(&text, k == 1 ? "ground" : "b%d", k - 1);
        yk_text_format(&text, ", b%d], angle: q%d}\n", k, k);
    }
    Machine m = machine_of(yk_text_get(&text));
    yk_text_free(&text);
    yk_state_set_time(m.state, 0, NULL);
    assert_true(yk_state_assemble(m.state) >= 0);
    YkFreeBodyDrawings *pictures = yk_free_body_drawings_new(m.d, m.state, NULL);
    assert_non_null(pictures);
    assert_int_equal(yk_free_body_drawings_count(pictures), LINKS);
    const char *svg = yk_free_body_drawings_svg(pictures, LINKS - 1);
    assert_non_null(strstr(svg, "<title>F_149_150, by b149 at J150</title>"));
    assert_null(strstr(svg, "nan"));
    svg = yk_free_body_drawings_svg(pictures, LINKS - 2);
    assert_non_null(strstr(svg, "<title>-F_149_150, by b150 at J150</title>"));
    yk_free_body_drawings_free(pictures);
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
                                       cmocka_unit_test(long_chains_are_drawn_to_their_end),
                                       cmocka_unit_test(any_one_failure_is_survived)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
