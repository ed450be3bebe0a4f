// Every allocation may fail: enumerating then says so, claims nothing, loses nothing, and can be repeated.
#include "check.h"
#include "interposed.h"
#include <yoke/yoke.h>

static void check_each_failure(const char *file, YkGroupSolver solver, size_t count, size_t continua)
{
    YkProblems *problems = yk_problems_new();
    YkModel *model = yk_model_load(file, NULL, problems);
    YkMechanism *mech = yk_mechanism_compile(model, NULL, problems);
    YkState *state = yk_state_new(mech);
    assert_true(state && yk_state_set_time(state, 0, problems) >= 0 && yk_state_assemble(state) >= 0);
    const YkConfigurationsOptions options = {.in_search_order = true, .solver = solver};
    long failures = 0, blocks = live;
    for (long allowed = 0;; allowed++) {
        YkConfigurationsReport r = {.complete = false};
        countdown = allowed;
        has_failed = false;
        YkConfigurations *all = yk_configurations_new(mech);
        YkStatus status = all ? yk_configurations_each(all, state, &options, NULL, NULL, &r) : YK_NO_MEMORY;
        countdown = -1;
        if (!has_failed) {
            assert_true(status == YK_OK && r.complete == (continua == 0) && r.count == count && r.continua == continua);
            yk_configurations_free(all);
            break;
        }
        failures++;
        assert_int_equal(status, YK_NO_MEMORY);
        assert_false(r.complete);
        if (all) {
            assert_int_equal(yk_configurations_each(all, state, &options, NULL, NULL, &r), YK_OK);
            assert_true(r.complete == (continua == 0) && r.count == count && r.continua == continua);
        }
        yk_configurations_free(all);
        assert_int_equal(live, blocks);
    }
    assert_true(failures >= 8);
    assert_int_equal(live, blocks);
    yk_state_free(state);
    yk_mechanism_free(mech);
    yk_model_free(model);
    yk_problems_free(problems);
}

static void test_each_failure_is_told(void **unused)
{
    (void)unused;
    skip_unless_interposed();
    check_each_failure(YOKE_ROOT "/examples/stephenson-awkward.yaml", YK_SOLVER_ELIMINATION, 2, 0);
    check_each_failure(YOKE_ROOT "/examples/stephenson-awkward.yaml", YK_SOLVER_PATHS, 2, 0);
    check_each_failure(YOKE_ROOT "/examples/geared-five-bar.yaml", YK_SOLVER_BOTH, 10, 0);
    check_each_failure(YOKE_ROOT "/examples/peaucellier.yaml", YK_SOLVER_BOTH, 6, 2);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_each_failure_is_told)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
