// Compiling an open tree survives the failure of any one allocation, and accelerating allocates nothing. Interposes
// malloc, so only with glibc and without sanitizers that do the same.
#include "open_tree.h"

#if defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(memory_sanitizer) || __has_feature(thread_sanitizer)
#define IS_SANITIZED 1
#endif
#endif
#if defined(__GLIBC__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__) && !defined(IS_SANITIZED)
#define CAN_INTERPOSE 1
#endif

#ifdef CAN_INTERPOSE
extern void *__libc_malloc(size_t size);
extern void *__libc_calloc(size_t count, size_t size);
extern void *__libc_realloc(void *memory, size_t size);
extern void __libc_free(void *memory);

static long countdown = -1; // allocations until one fails; below 0: none fails
static long requests, live; // live: blocks that are not freed

static bool must_fail(void)
{
    requests++;
    return countdown >= 0 && countdown-- == 0;
}

void *malloc(size_t size)
{
    void *memory = must_fail() ? NULL : __libc_malloc(size);
    live += memory != NULL;
    return memory;
}
void *calloc(size_t count, size_t size)
{
    void *memory = must_fail() ? NULL : __libc_calloc(count, size);
    live += memory != NULL;
    return memory;
}
void *realloc(void *old, size_t size)
{
    void *memory = must_fail() ? NULL : __libc_realloc(old, size);
    live += memory && !old;
    return memory;
}
void free(void *memory)
{
    live -= memory != NULL;
    __libc_free(memory);
}

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
    check_no_request((TreeRecipe){.bodies = 300, .pins_only = true});
    check_no_request((TreeRecipe){.bodies = 300});
}
#else
static void test_every_failed_allocation_is_survived(void **unused)
{
    (void)unused;
    skip();
}
static void test_accelerating_allocates_nothing(void **unused)
{
    (void)unused;
    skip();
}
#endif

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_every_failed_allocation_is_survived),
        cmocka_unit_test(test_accelerating_allocates_nothing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
