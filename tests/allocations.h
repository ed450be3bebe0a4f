// Allocations that are counted, and may fail: what tests of memory share.
//
// A test compiles sources in with `#define malloc try_malloc` and so on, or takes the whole program's allocator with
// `interposed.h`. Threads may allocate at the same time.
#ifndef TESTS_ALLOCATIONS_H
#define TESTS_ALLOCATIONS_H
#include <stdatomic.h>
#include <stdbool.h>
#include <stdlib.h>

static atomic_long countdown = -1; // allocations until one fails; below 0: none does
static atomic_bool fails_for_good; // from the one that fails on, all do
static atomic_bool has_failed;
static atomic_long requests;            // since the start
static atomic_long live;                // blocks not yet freed
static void (*on_failure)(void);        // called where one fails; may be NULL
static void (*on_request)(long number); // called for each, before it is made; may be NULL

static inline bool must_fail(void)
{
    long number = requests++;
    if (on_request) on_request(number);
    long left = countdown;
    while (left > 0 && !atomic_compare_exchange_weak(&countdown, &left, left - 1)) {}
    if (left != 0) return false;
    if (!fails_for_good && !atomic_compare_exchange_strong(&countdown, &left, -1)) return false;
    has_failed = true;
    if (on_failure) on_failure();
    return true;
}

static inline void *counted(void *memory)
{
    live += memory != NULL;
    return memory;
}

static inline void *try_malloc(size_t size)
{
    return must_fail() ? NULL : counted(malloc(size));
}
static inline void *try_calloc(size_t count, size_t size)
{
    return must_fail() ? NULL : counted(calloc(count, size));
}
static inline void *try_realloc(void *old, size_t size)
{
    if (must_fail()) return NULL;
    live -= old != NULL;
    return counted(realloc(old, size));
}
static inline void count_free(void *memory)
{
    live -= memory != NULL;
    free(memory);
}
#endif
