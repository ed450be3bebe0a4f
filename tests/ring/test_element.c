// Elements that pass: their memory is used again, and nothing that is kept depends on them.
#include "ring/inside.h"
#include "ring/ring_check.h"

// A power of a sum, with many elements on the way.
static Element work(Fixture *f, int32_t exponent)
{
    Element sum = yk_ring_add(f->ring, symbol(f, "l1"), yk_ring_unit(f->ring, f->angle[0])), power = sum;
    for (int32_t k = 1; k < exponent; k++) power = yk_ring_multiply(f->ring, power, sum);
    return power;
}

static void work_that_passes_leaves_its_result_alone(void **state)
{
    (void)state;
    Fixture f = fixture_new(1);
    Element kept = work(&f, 9);
    const unsigned char *start = f.ring->arena->next;
    for (int i = 0; i < 100; i++) {
        yk_ring_begin_passing(f.ring);
        work(&f, 9);
        assert_null(yk_ring_end_passing(f.ring, NULL));
    }
    assert_ptr_equal(f.ring->arena->next, start);
    yk_ring_begin_passing(f.ring);
    Element result = yk_ring_end_passing(f.ring, work(&f, 9));
    size_t size = sizeof *result + yk_ring_terms(result) * sizeof *result->terms;
    assert_int_equal(f.ring->arena->next - start, (size + 15) & ~(size_t)15);
    yk_ring_begin_passing(f.ring);
    work(&f, 12);
    yk_ring_end_passing(f.ring, NULL);
    check_same(f.ring, result, kept);
    yk_ring_free(f.ring);
}

// A symbol, the derivative of a function, the image of a change and the square of a root are made once, here while
// elements pass.
static void what_the_ring_remembers_stays(void **state)
{
    (void)state;
    Fixture f = fixture_new(1), other = fixture_new(1);
    enum { RESULTS = 4 };
    Element results[2][RESULTS];
    int32_t root = -1;
    for (int way = 0; way < 2; way++) {
        Fixture *g = way ? &other : &f;
        YkRing *r = g->ring;
        const YkRingChange change = {g->distance, yk_ring_add(r, symbol(g, "l1"), symbol(g, "m1")), NULL};
        YkRingChanges *changes = yk_ring_changes(r, &change, 1);
        for (int again = 0; again < 2; again++) {
            if (way) yk_ring_begin_passing(r);
            results[way][0] = yk_ring_of(r, g->force);
            results[way][1] = yk_ring_time_derivative(r, yk_ring_of(r, g->lift));
            results[way][2] = yk_ring_change(r, yk_ring_power(r, yk_ring_of(r, g->distance), 3), changes);
            if (!again) root = yk_ring_root(r, "w", results[way][2]);
            yk_ring_time_derivative(r, yk_ring_of(r, root)); // so that the next one is not at hand
            results[way][3] = yk_ring_partial(r, yk_ring_of(r, root), g->parameter[1]);
            if (way) {
                yk_ring_begin_passing(r); // one within the other
                yk_ring_end_passing(r, NULL);
                for (int k = 0; k < RESULTS; k++) results[way][k] = yk_ring_keep(r, results[way][k]);
                work(g, 12);
                yk_ring_end_passing(r, NULL);
                yk_ring_begin_passing(r);
                work(g, 12);
                yk_ring_end_passing(r, NULL);
            }
        }
    }
    for (int k = 0; k < RESULTS; k++) {
        YkText texts[2] = {{0}, {0}};
        assert_true(yk_ring_write(f.ring, results[0][k], YK_RING_TEXT, YK_RING_EXPANDED, &texts[0]));
        assert_true(yk_ring_write(other.ring, results[1][k], YK_RING_TEXT, YK_RING_EXPANDED, &texts[1]));
        assert_string_equal(yk_text_get(&texts[0]), yk_text_get(&texts[1]));
        yk_text_free(&texts[0]);
        yk_text_free(&texts[1]);
    }
    yk_ring_free(f.ring);
    yk_ring_free(other.ring);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(work_that_passes_leaves_its_result_alone),
        cmocka_unit_test(what_the_ring_remembers_stays),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
