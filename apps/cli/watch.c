// Watches memory by the linker: every request of the command and of the library in it passes through here, and a
// refusal is remembered. The library itself says where it ran out of memory; this is a second way to know, so that the
// command never gives out an answer that may lack a part.
#include <stdatomic.h>
#include "cli.h"

static atomic_bool has_run_out;

bool yk_memory_ran_out(void)
{
    return has_run_out;
}

#ifdef YOKE_WATCHES_MEMORY
void *__real_malloc(size_t size);
void *__real_calloc(size_t count, size_t size);
void *__real_realloc(void *memory, size_t size);
void *__real_aligned_alloc(size_t alignment, size_t size);
void *__wrap_malloc(size_t size);
void *__wrap_calloc(size_t count, size_t size);
void *__wrap_realloc(void *memory, size_t size);
void *__wrap_aligned_alloc(size_t alignment, size_t size);

static void *watched(void *memory)
{
    if (!memory) has_run_out = true;
    return memory;
}

void *__wrap_malloc(size_t size)
{
    return watched(__real_malloc(size));
}

void *__wrap_calloc(size_t count, size_t size)
{
    return watched(__real_calloc(count, size));
}

void *__wrap_realloc(void *memory, size_t size)
{
    return watched(__real_realloc(memory, size));
}

void *__wrap_aligned_alloc(size_t alignment, size_t size)
{
    return watched(__real_aligned_alloc(alignment, size));
}
#endif
