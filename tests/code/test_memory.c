// Every allocation while printing may fail: it then answers with a problem; nothing leaks or crashes.
#include <yoke/code.h>
#include "interposed.h"

// Prints while allocation number k fails. True when k is beyond the last one.
static bool print_while_failing(const YkModel *model, long k)
{
    YkProblems *problems = yk_problems_new();
    assert_non_null(problems);
    has_failed = 0;
    countdown = k;
    YkCSource *source = yk_c_source_new(model, NULL, problems);
    countdown = -1;
    bool undisturbed = !has_failed;
    if (undisturbed) assert_non_null(source);
    if (!source) assert_true(yk_problems_count(problems) > 0);
    yk_c_source_free(source);
    yk_problems_free(problems);
    return undisturbed;
}

static void check_all(const char *name)
{
    char path[500];
    snprintf(path, sizeof path, YOKE_ROOT "/examples/%s.yaml", name);
    YkModel *model = yk_model_load(path, NULL, NULL);
    assert_non_null(model);
    bool undisturbed = false;
    long k = 0;
    for (; !undisturbed; k += 1 + k / 60) {
        long before = live;
        undisturbed = print_while_failing(model, k);
        if (live != before) print_error("%s: allocation %ld leaves %ld blocks\n", name, k, live - before);
        assert_int_equal(live, before);
    }
    assert_true(k > 20); // it did allocate
    yk_model_free(model);
}

static void code_is_printed_or_refused_whichever_allocation_fails(void **state)
{
    (void)state;
    skip_unless_interposed();
    check_all("quick-return");
    check_all("double-butterfly"); // a group
    check_all("valve-cam");        // a law
    check_all("double-pendulum");
    check_all("crank-press"); // dry friction
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(code_is_printed_or_refused_whichever_allocation_fails),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
