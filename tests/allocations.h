// Allocations that are counted, and may fail: what tests of memory share.
//
// A test compiles sources in with `#define malloc try_malloc` and so on, or takes the whole program's allocator with
// `interposed.h`.
#ifndef TESTS_ALLOCATIONS_H
#define TESTS_ALLOCATIONS_H
#include <stdbool.h>
#include <stdlib.h>

static volatile long countdown = -1; // allocations until one fails; below 0: none does
static volatile bool fails_for_good; // from the one that fails on, all do
static volatile bool has_failed;
static volatile long requests; // since the start
static volatile long live;     // blocks not yet freed

static inline bool must_fail(void)
{
    requests++;
    if (countdown < 0) return false;
    if (countdown > 0) {
        countdown--;
        return false;
    }
    if (!fails_for_good) countdown = -1;
    has_failed = true;
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
