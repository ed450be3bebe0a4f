// Every allocation of the analysis may fail: it then answers with a problem, or with a formula less; nothing leaks or
// crashes.
#include "interposed.h"
#include "design/train_check.h"

// Analyses while allocation number k fails. True when k is beyond the last one.
static int ask_while_failing(const YkModel *model, const YkTrainOptions *options, long k)
{
    YkProblems *problems = yk_problems_new();
    assert_non_null(problems);
    has_failed = 0;
    countdown = k;
    YkTrain *train = yk_train_new(model, options, problems);
    countdown = -1;
    int undisturbed = !has_failed;
    if (undisturbed) assert_non_null(train);
    if (!train) assert_true(yk_problems_count(problems) > 0);
    yk_train_free(train);
    yk_problems_free(problems);
    return undisturbed;
}

static void check_all(const char *name, const YkTrainOptions *options)
{
    char path[500];
    snprintf(path, sizeof path, YOKE_ROOT "/examples/%s.yaml", name);
    YkModel *model = yk_model_load(path, NULL, NULL);
    assert_non_null(model);
    int undisturbed = 0;
    long k = 0;
    for (; !undisturbed; k += 1 + k / 300) {
        long before = live;
        undisturbed = ask_while_failing(model, options, k);
        if (live != before) print_error("%s: allocation %ld leaves %ld blocks\n", name, k, live - before);
        assert_int_equal(live, before);
    }
    assert_true(k > 20); // it did allocate
    yk_model_free(model);
}

static void trains_are_analysed_or_refused_whichever_allocation_fails(void **state)
{
    (void)state;
    skip_unless_interposed();
    check_all("epicyclic", NULL);
    check_all("gearbox-8hp70", &(YkTrainOptions){.efficiency = 1, .in = "input", .out = "output"});
    check_all("epicyclic-drive", &(YkTrainOptions){.efficiency = 0.98, .lock = "held", .out = "X"});
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(trains_are_analysed_or_refused_whichever_allocation_fails),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
