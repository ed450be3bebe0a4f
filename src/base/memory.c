// The arena: chunks of memory in a list, freed together; and growing arrays.
#include "base/memory.h"
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include "base/text.h"

// Tests in which allocations fail make a chunk for each thing, so that none has room by chance.
#ifndef YOKE_CHUNK_MAX
#define YOKE_CHUNK_MIN 4096
#define YOKE_CHUNK_MAX (1 << 24)
#endif
enum { CHUNK_MIN = YOKE_CHUNK_MIN, CHUNK_MAX = YOKE_CHUNK_MAX, ALIGN_SMALL = 16, ALIGN_LARGE = 64, WORK_PER_BYTE = 4 };

typedef struct YkChunk {
    _Alignas(ALIGN_SMALL) struct YkChunk *older;
} Chunk; // the memory follows the header

YkArena *yk_arena_new(void)
{
    YkArena *arena = malloc(sizeof *arena);
    if (arena) *arena = (YkArena){.chunk_size = CHUNK_MIN};
    return arena;
}

void yk_arena_free(YkArena *arena)
{
    if (!arena) return;
    for (Chunk *chunk = arena->newest, *older; chunk; chunk = older) {
        older = chunk->older;
        free(chunk);
    }
    free(arena);
}

void yk_arena_clear(YkArena *arena)
{
    Chunk *kept = arena->newest; // the largest chunk
    if (!kept) return;
    for (Chunk *chunk = kept->older, *older; chunk; chunk = older) {
        older = chunk->older;
        free(chunk);
    }
    kept->older = NULL;
    arena->next = (unsigned char *)(kept + 1);
}

// Adds a chunk with room for `bytes` at any alignment. The rest of the previous chunk is lost.
static bool add_chunk(YkArena *arena, size_t bytes)
{
    size_t size = arena->chunk_size, needed = sizeof(Chunk) + ALIGN_LARGE + bytes;
    if (needed < bytes) return false;
    if (size < needed) size = needed;
    Chunk *chunk = malloc(size);
    if (!chunk) return false;
    yk_pace_spend(arena->pace, WORK_PER_BYTE * size);
    chunk->older = arena->newest;
    arena->newest = chunk;
    arena->next = (unsigned char *)(chunk + 1);
    arena->end = arena->next + (size - sizeof(Chunk)) / ALIGN_SMALL * ALIGN_SMALL;
    if (arena->chunk_size < CHUNK_MAX) arena->chunk_size *= 2;
    return true;
}

void *yk_arena_take_from_new_chunk(YkArena *arena, size_t bytes)
{
    if (arena && add_chunk(arena, bytes)) return yk_arena_take(arena, bytes);
    if (arena) arena->failed = true;
    return NULL;
}

void *yk_arena_alloc(YkArena *arena, size_t count, size_t size)
{
    if (!arena) return NULL;
    if (size != 0 && count > PTRDIFF_MAX / size) {
        arena->failed = true;
        return NULL;
    }
    size_t bytes = count * size, pad = 0;
    if (bytes == 0) bytes = 1; // so that two empty arrays differ
    if (bytes >= ALIGN_LARGE) {
        if (bytes + ALIGN_LARGE > (size_t)(arena->end - arena->next) && !add_chunk(arena, bytes)) {
            arena->failed = true;
            return NULL;
        }
        pad = (size_t)(-(uintptr_t)arena->next & (ALIGN_LARGE - 1));
    }
    unsigned char *memory = yk_arena_take(arena, pad + bytes);
    return memory ? memset(memory + pad, 0, bytes) : NULL;
}

void yk_arena_fail(YkArena *arena)
{
    if (arena) arena->failed = true;
}

bool yk_arena_failed(const YkArena *arena)
{
    return !arena || arena->failed;
}

char *yk_arena_copy(YkArena *arena, const char *text, size_t length)
{
    if (arena && text == yk_text_lost) arena->failed = true;
    if (!arena || text == yk_text_lost || length >= PTRDIFF_MAX) return NULL;
    char *copy = yk_arena_take(arena, length + 1);
    if (!copy) return NULL;
    if (length > 0) memcpy(copy, text, length);
    copy[length] = '\0';
    return copy;
}

bool yk_grow(void **items, size_t count, size_t *capacity, size_t size)
{
    if (count < *capacity) return true;
    size_t wanted = *capacity < 16 ? 16 : 2 * *capacity;
    if (size == 0) size = 1; // rows of no width
    if (wanted <= *capacity || wanted > PTRDIFF_MAX / size) return false;
    // The caller's variable is a T *, not a void *: copying its bytes is allowed for every type.
    void *old;
    memcpy(&old, items, sizeof old);
    void *grown = realloc(old, wanted * size);
    if (!grown) return false;
    memcpy(items, &grown, sizeof grown);
    *capacity = wanted;
    return true;
}

bool yk_grow_in(YkArena *arena, void **items, size_t count, size_t *capacity, size_t size)
{
    if (count < *capacity) return true;
    size_t wanted = *capacity < 16 ? 16 : 2 * *capacity;
    void *old, *grown = yk_arena_alloc(arena, wanted, size);
    if (!grown) return false;
    memcpy(&old, items, sizeof old);
    if (count > 0) memcpy(grown, old, count * size);
    memcpy(items, &grown, sizeof grown);
    *capacity = wanted;
    return true;
}
