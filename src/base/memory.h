// Memory: an arena that fills up while loading and compiling and is freed at once.
#ifndef BASE_MEMORY_H
#define BASE_MEMORY_H
#include <stdbool.h>
#include <stddef.h>
#include "base/pace.h"

typedef struct YkArena {
    struct YkChunk *newest;
    unsigned char *next, *end; // free memory of the newest chunk, a multiple of 16 bytes
    size_t chunk_size;         // size of the next chunk
    bool failed;
    YkPace *pace; // of the long call that fills it, or NULL: new chunks count as work
} YkArena;

YkArena *yk_arena_new(void);
void yk_arena_free(YkArena *arena);
void yk_arena_clear(YkArena *arena); // discards the contents; keeps the memory for reuse, and the failed state
// Marks the arena failed: its owner ran out of memory elsewhere, so something is missing.
void yk_arena_fail(YkArena *arena);
// Returns zeroed memory for `count` things of `size` bytes, aligned to 64 bytes if it is at least that large, otherwise
// to 16. Returns NULL on overflow or exhaustion; yk_arena_failed() stays true from then on.
void *yk_arena_alloc(YkArena *arena, size_t count, size_t size);
// Returns memory that is not zeroed, aligned to 16 bytes: for many small things that are written at once.
void *yk_arena_take_from_new_chunk(YkArena *arena, size_t bytes);
static inline void *yk_arena_take(YkArena *arena, size_t bytes)
{
    if (!arena || bytes > (size_t)(arena->end - arena->next)) return yk_arena_take_from_new_chunk(arena, bytes);
    unsigned char *memory = arena->next;
    arena->next += (bytes + 15) & ~(size_t)15;
    return memory;
}
// Gives back the memory taken last, except its first `kept` bytes.
static inline void yk_arena_give_back(YkArena *arena, void *taken, size_t kept)
{
    arena->next = (unsigned char *)taken + ((kept + 15) & ~(size_t)15);
}
bool yk_arena_failed(const YkArena *arena);
// Copies a text and adds a NUL. Given the content of a failed text, returns NULL and fails as well.
char *yk_arena_copy(YkArena *arena, const char *text, size_t length);
#define YK_NEW(arena, type, count) ((type *)yk_arena_alloc((arena), (count), sizeof(type)))

// Grows an array by doubling its capacity. `items` is a pointer variable, `count` and `capacity` are size_t variables.
// Evaluates to true when there is room for one more (items may have moved), to false when out of memory.
bool yk_grow(void **items, size_t count, size_t *capacity, size_t size);
#define YK_ROOM(items, count, capacity)                                                                                \
    ((count) < (capacity) || yk_grow((void **)&(items), (count), &(capacity), sizeof *(items)))

// The same with rows of `width` items each.
#define YK_ROW_ROOM(items, width, count, capacity)                                                                     \
    ((count) < (capacity) || yk_grow((void **)&(items), (count), &(capacity), (width) * sizeof *(items)))

// The same in an arena: the old array stays behind, and all that do are together no longer than the new one.
bool yk_grow_in(YkArena *arena, void **items, size_t count, size_t *capacity, size_t size);
#define YK_ROOM_IN(arena, items, count, capacity)                                                                      \
    ((count) < (capacity) || yk_grow_in((arena), (void **)&(items), (count), &(capacity), sizeof *(items)))

// array + offset; NULL where the array was never made because it would be empty: C does not define NULL + 0.
#define yk_from(array, offset) ((array) ? (array) + (offset) : NULL)

#endif
