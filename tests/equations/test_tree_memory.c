// Compiling an open tree survives the failure of any one allocation, and accelerating allocates nothing.
#include "interposed.h"
#include "open_tree.h"

static void check_every_allocation(TreeRecipe recipe)
{
    uint64_t seed = 3;
    OpenTree t = random_tree(&seed, recipe);
    long before = live, failures = 0;
    bool is_done = false;
    for (long k = 0; !is_done; k++) {
        bool fits = false;
        countdown = k;
        YkTreeDynamics *tree = yk_tree_dynamics_new(t.mech, &fits);
        is_done = countdown >= 0; // nothing failed
        countdown = -1;
        assert_true(fits); // it would, with more memory
        assert_int_equal(tree != NULL, is_done);
        failures += !is_done;
        yk_tree_dynamics_free(tree);
        assert_int_equal(live, before);
    }
    assert_true(failures >= 3);
    open_tree_free(&t);
}

static void test_every_failed_allocation_is_survived(void **unused)
{
    (void)unused;
    skip_unless_interposed();
    check_every_allocation((TreeRecipe){.bodies = 12, .pins_only = true});
    check_every_allocation((TreeRecipe){.bodies = 12});
    check_every_allocation((TreeRecipe){.bodies = 3000, .pins_only = true}); // more than one piece of the arena
    check_every_allocation((TreeRecipe){.bodies = 3000});
}

static void check_no_request(TreeRecipe recipe)
{
    uint64_t seed = 5;
    OpenTree t = random_tree(&seed, recipe);
    double *q = numbers(t.n), *a = numbers(t.n);
    for (size_t i = 0; i < t.n; i++) q[i] = 0.1 * (double)i;
    long before = requests;
    for (int k = 0; k < 100; k++) {
        q[0] += 0.01;
        assert_int_equal(yk_tree_accelerate(t.tree, q, q, q, a), -1);
    }
    assert_int_equal(requests, before);
    free(q);
    free(a);
    open_tree_free(&t);
}

static void test_accelerating_allocates_nothing(void **unused)
{
    (void)unused;
    skip_unless_interposed();
    check_no_request((TreeRecipe){.bodies = 300, .pins_only = true});
    check_no_request((TreeRecipe){.bodies = 300});
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_every_failed_allocation_is_survived),
        cmocka_unit_test(test_accelerating_allocates_nothing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
