// The whole program's allocator, counted and made to fail as `allocations.h` says; the C library's own requests (qsort,
// stdio) too. Our definitions come before the C library's, so only with glibc, and not under sanitizers that do the
// same: there requests are counted by their hooks, and a test that makes allocations fail begins with
// `skip_unless_interposed()`.
#ifndef TESTS_INTERPOSED_H
#define TESTS_INTERPOSED_H
#include <errno.h>
#include "allocations.h"
#include "check.h"

#ifdef IS_SANITIZED
enum { IS_INTERPOSED = false };
int __sanitizer_install_malloc_and_free_hooks(void (*on_malloc)(const volatile void *, size_t),
                                              void (*on_free)(const volatile void *));
static inline void count_request(const volatile void *memory, size_t size)
{
    (void)memory;
    (void)size;
    requests++;
}
static inline void pass_over_free(const volatile void *memory)
{
    (void)memory;
}
static inline void start_counting(void)
{
    __sanitizer_install_malloc_and_free_hooks(count_request, pass_over_free);
}
#else
enum { IS_INTERPOSED = true };
void *__libc_malloc(size_t size);
void *__libc_calloc(size_t count, size_t size);
void *__libc_realloc(void *memory, size_t size);
void *__libc_memalign(size_t alignment, size_t size);
void __libc_free(void *memory);

static bool must_fail_here(void)
{
    bool fails = must_fail();
    if (fails) errno = ENOMEM;
    return fails;
}
void *malloc(size_t size)
{
    return must_fail_here() ? NULL : counted(__libc_malloc(size));
}
void *calloc(size_t count, size_t size)
{
    return must_fail_here() ? NULL : counted(__libc_calloc(count, size));
}
void *realloc(void *old, size_t size)
{
    void *memory = must_fail_here() ? NULL : __libc_realloc(old, size);
    live += memory && !old;
    return memory;
}
void *aligned_alloc(size_t alignment, size_t size)
{
    return must_fail_here() ? NULL : counted(__libc_memalign(alignment, size));
}
void free(void *memory)
{
    live -= memory != NULL;
    __libc_free(memory);
}
static inline void start_counting(void) {}
#endif

static inline void skip_unless_interposed(void)
{
    if (!IS_INTERPOSED) skip();
}
#endif
