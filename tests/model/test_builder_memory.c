// Building survives the failure of any one allocation, and of all from any one on: it is refused, and nothing leaks.
#include "interposed.h"
#include "check.h"
#include <yoke/yoke.h>

// Builds while allocation k fails. Returns whether none failed.
static bool build_while_failing(long k)
{
    YkProblems *problems = yk_problems_new();
    assert_non_null(problems);
    has_failed = 0;
    countdown = k;
    YkBuilder *b = yk_builder_new("many");
    YkModel *model = NULL;
    if (b) {
        char name[8];
        for (int i = 0; i < 20; i++) { // enough for a table of names
            snprintf(name, sizeof name, "b%d", i);
            yk_builder_body(b, name);
            yk_builder_pin(b, name, "ground", name, NULL, NULL);
        }
        yk_builder_parameter(b, "l", "1 m");
        yk_builder_set(b, "bodies/b3/points/P", "[l, 0]");
        yk_builder_set_number(b, "bodies/b3/mass", 2);
        yk_builder_set(b, "bodies/b3/inertia", "0.1");
        yk_builder_remove(b, "joints/b19");
        yk_builder_remove(b, "bodies/b19");
        model = yk_builder_model(b, NULL, problems);
    }
    countdown = -1;
    bool undisturbed = !has_failed;
    if (undisturbed) assert_non_null(model);
    if (model) assert_int_equal(yk_model_body_count(model), 20);
    if (model) assert_string_equal(yk_model_text(model), yk_builder_text(b));
    if (b && !model) assert_true(yk_problems_error_count(problems) > 0); // it says why
    yk_model_free(model);
    yk_builder_free(b);
    yk_problems_free(problems);
    return undisturbed;
}

static void a_machine_is_built_or_refused_whichever_allocation_fails(void **state)
{
    (void)state;
    skip_unless_interposed();
    for (int for_good = 0; for_good < 2; for_good++) {
        fails_for_good = for_good;
        long k = 0, before = live;
        for (; !build_while_failing(k); k++)
            if (live != before) fail_msg("leak of %ld blocks when allocation %ld fails", live - before, k);
        assert_true(k > 20);
    }
    fails_for_good = false;
}

// A sketch likewise.
static bool sketch_while_failing(long k)
{
    static const char text[] = "bodies: {a: {points: {P: [0, 0], Q: [1, 0]}}, b: {points: {P: [0, 0]}}, c: {}}\n"
                               "joints: {O: {pin: [ground, a], angle: q}}\n";
    YkProblems *problems = yk_problems_new();
    has_failed = 0;
    countdown = k;
    YkSketch *sketch = yk_sketch_parse(text, sizeof text - 1, "test", NULL, problems);
    countdown = -1;
    bool undisturbed = !has_failed;
    if (undisturbed) assert_non_null(sketch);
    if (sketch) {
        assert_int_equal(yk_sketch_lack_count(sketch), 5); // b and c float, q is free, P and Q are open
        for (size_t i = 0; i < 5; i++) assert_non_null(yk_sketch_lack(sketch, i).mend);
    } else {
        assert_true(yk_problems_error_count(problems) > 0);
    }
    yk_sketch_free(sketch);
    yk_problems_free(problems);
    return undisturbed;
}

static void a_sketch_is_read_or_refused_whichever_allocation_fails(void **state)
{
    (void)state;
    skip_unless_interposed();
    for (int for_good = 0; for_good < 2; for_good++) {
        fails_for_good = for_good;
        long k = 0, before = live;
        for (; !sketch_while_failing(k); k++)
            if (live != before) fail_msg("leak of %ld blocks when allocation %ld fails", live - before, k);
        assert_true(k > 20);
    }
    fails_for_good = false;
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_machine_is_built_or_refused_whichever_allocation_fails),
        cmocka_unit_test(a_sketch_is_read_or_refused_whichever_allocation_fails),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
