// Every allocation of the analysis may fail: it then answers with a problem, or with a formula less; nothing leaks or
// crashes. Works by interposing malloc, so only with glibc and without sanitizers that do the same.
#include <stdlib.h>
#include "design/train_check.h"

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
static int has_failed;
static long live; // blocks that are not freed

static int must_fail(void)
{
    if (countdown < 0) return 0;
    if (countdown > 0) return countdown--, 0;
    countdown = -1;
    has_failed = 1;
    return 1;
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
#else
int main(void)
{
    return 0; // the allocator belongs to the sanitizer
}
#endif
