// A variant is made whole or refused, whichever allocation fails: a plan that could not be made for want of memory is
// not mistaken for another machine near the file's values.
#include "interposed.h"
#include "compile/variant.h"
#include "machine.h"

// True when allocation k is beyond the last one, so that nothing was disturbed.
static bool make_while_failing(const YkMechanism *mech, const char *const *names, size_t count, long k,
                               const YkVariant *expected)
{
    YkProblems *problems = yk_problems_new();
    assert_non_null(problems);
    has_failed = false;
    countdown = k;
    YkVariant *variant = yk_variant_new(mech, names, count, problems);
    countdown = -1;
    bool undisturbed = !has_failed;
    assert_true(!undisturbed || variant);
    if (variant) {
        assert_int_equal(yk_problems_count(problems), 0); // the machines of this test stay what they are
        assert_int_equal(variant->patch_count, expected->patch_count);
        assert_int_equal(variant->active_count, expected->active_count);
    } else {
        assert_true(yk_problems_error_count(problems) > 0);
    }
    yk_variant_free(variant);
    yk_problems_free(problems);
    return undisturbed;
}

static void check_all(const char *source, const char *const *names, size_t count)
{
    Machine m = machine(source);
    YkVariant *expected = yk_variant_new(m.mech, names, count, m.problems);
    assert_non_null(expected);
    assert_true(expected->patch_count > 0);
    for (int good = 0; good < 2; good++) {
        long k = 0, before = live;
        fails_for_good = good;
        while (!make_while_failing(m.mech, names, count, k, expected)) {
            if (live != before) print_error("leak of %ld blocks when allocation %ld fails\n", live - before, k);
            assert_true(live == before);
            k++;
        }
        assert_true(k > 5);
    }
    yk_variant_free(expected);
    machine_free(&m);
}

static void a_variant_is_made_whole_or_refused_whichever_allocation_fails(void **state)
{
    (void)state;
    skip_unless_interposed();
    check_all("four-bar", (const char *const[]){"a", "b"}, 2);
    check_all("parameters: {l: 3, e: 1}\n"
              "bodies:\n"
              "  ground: {points: {A: [0, 0], E: [l, 0]}}\n"
              "  a: {points: {A: [0, 0], B: [1, 0]}}\n"
              "  b: {points: {C: [0, 0], B: [-2.5, 0]}}\n"
              "  c: {points: {C: [0, 0], D: [2, 0]}}\n"
              "  d: {points: {D: [0, 0], E: [2.2, 0]}}\n"
              "joints:\n"
              "  A: {pin: [ground, a], angle: t1}\n"
              "  B: {pin: [a, b], angle: t2}\n"
              "  C: {pin: [b, c], angle: t3}\n"
              "  D: {pin: [c, d], angle: t4}\n"
              "  E: {pin: [ground, d]}\n"
              "gears: {g: {mesh: [b, d], teeth: [20, 30], carrier: c}}\n"
              "stops: {t1: {between: [0, 2], restitution: e}}\n"
              "start: {t1: 1.05, t2: -0.52, t3: -1.05, t4: -1.05}\n",
              (const char *const[]){"l", "e"}, 2);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_variant_is_made_whole_or_refused_whichever_allocation_fails),
    };
    return cmocka_run_group_tests_name("compile/variant_memory", tests, NULL, NULL);
}
