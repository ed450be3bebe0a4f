// Compiling survives the failure of any one allocation, and of all from any one on: it is refused, nothing leaks,
// nothing crashes, and what is not refused is the same mechanism.
#include "interposed.h"
#include "machine.h"
#include "table.h"

typedef struct Summary {
    char inputs[200], blocks[400];
    size_t steps, terms, redundant;
    YkFreedom freedom;
} Summary;

static Summary summarise(const YkMechanism *mech)
{
    Summary s = {.steps = mech->step_count,
                 .terms = mech->term_count,
                 .redundant = yk_redundant_count(mech),
                 .freedom = yk_mechanism_freedom(mech)};
    describe_inputs(mech, s.inputs, sizeof s.inputs);
    describe_blocks(mech, s.blocks, sizeof s.blocks);
    return s;
}

static void check_equal(const Summary *a, const Summary *b)
{
    assert_string_equal(a->inputs, b->inputs);
    assert_string_equal(a->blocks, b->blocks);
    assert_int_equal(a->steps, b->steps);
    assert_int_equal(a->terms, b->terms);
    assert_int_equal(a->redundant, b->redundant);
    assert_int_equal(a->freedom.by_rank, b->freedom.by_rank);
}

// Compiles while allocation number k fails. True when k is beyond the last one, so that nothing was disturbed.
static bool compile_while_failing(const YkModel *model, const YkCompileOptions *options, long k,
                                  const Summary *expected)
{
    YkProblems *problems = yk_problems_new();
    assert_non_null(problems);
    has_failed = false;
    countdown = k;
    YkMechanism *mech = yk_mechanism_compile(model, options, problems);
    countdown = -1;
    bool undisturbed = !has_failed;
    if (mech) { // a hint may be missing, never a part of the machine
        assert_non_null(expected);
        Summary summary = summarise(mech);
        check_equal(&summary, expected);
    } else {
        assert_true(!undisturbed || !expected);
        assert_true(yk_problems_error_count(problems) > 0); // it says why
    }
    yk_mechanism_free(mech);
    yk_problems_free(problems);
    return undisturbed;
}

static void check_all(const char *source, const YkCompileOptions *options)
{
    Machine m = machine_try(source, options);
    Summary expected = {0};
    if (m.mech) expected = summarise(m.mech);
    for (int good = 0; good < 2; good++) {
        long k = 0, before = live;
        fails_for_good = good;
        while (!compile_while_failing(m.model, options, k, m.mech ? &expected : NULL)) {
            if (live != before) print_error("leak of %ld blocks when allocation %ld fails\n", live - before, k);
            assert_true(live == before);
            k++;
        }
        assert_true(k > 5); // there was something to fail
    }
    machine_free(&m);
}

static void a_machine_is_compiled_or_refused_whichever_allocation_fails(void **state)
{
    (void)state;
    skip_unless_interposed();
    for (size_t k = 0; k < MACHINES; k++) check_all(machines[k].source, NULL);
}

static void what_is_wrong_is_refused_whichever_allocation_fails(void **state)
{
    (void)state;
    skip_unless_interposed();
    const char *both[] = {"theta4", "gamma"};
    check_all("four-bar", &(YkCompileOptions){both, 2});
    check_all("bodies: {a: {}, b: {}}\njoints: {S: {slide: [ground, a], along: x}, T: {slide: [a, b], along: y}, U: "
              "{slide: [b, ground], along: 0.3, turned: 1}}\n",
              NULL);
    check_all("bodies: {a: {}, b: {}}\njoints: {S: {pin: [ground, a], angle: p}, T: {slide: [a, b], along: y, "
              "distance: q}, U: {pin: [b, ground], angle: r}}\n",
              NULL);
}

static void channels_are_read_and_written_whichever_allocation_fails(void **state)
{
    (void)state;
    skip_unless_interposed();
    Machine m = machine("quick-return");
    static const char *const names[] = {"ram.C.x.rate", "levr.angle", "theta3", "C.transmission"};
    for (size_t n = 0; n < 4; n++) {
        bool undisturbed = false;
        for (long k = 0; !undisturbed; k++) {
            long before = live;
            char text[100];
            YkChannel channel;
            has_failed = fails_for_good = false;
            countdown = k;
            YkProblems *problems = yk_problems_new();
            YkStatus status = yk_channel_parse(m.mech, names[n], &channel, problems);
            if (status == YK_OK) yk_channel_name(m.mech, channel, text, sizeof text);
            yk_problems_free(problems);
            countdown = -1;
            undisturbed = !has_failed;
            assert_int_equal(status, n == 0 || n == 3 ? YK_OK : YK_BAD_ARGUMENT);
            if (undisturbed && status == YK_OK) assert_string_equal(text, names[n]);
            assert_true(live == before);
        }
    }
    machine_free(&m);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_machine_is_compiled_or_refused_whichever_allocation_fails),
        cmocka_unit_test(what_is_wrong_is_refused_whichever_allocation_fails),
        cmocka_unit_test(channels_are_read_and_written_whichever_allocation_fails),
    };
    return cmocka_run_group_tests_name("compile/memory", tests, NULL, NULL);
}
