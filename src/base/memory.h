// Memory: an arena that is filled while loading and compiling and freed at once.
#ifndef BASE_MEMORY_H
#define BASE_MEMORY_H
#include <stdbool.h>
#include <stddef.h>

typedef struct YkArena {
    struct YkChunk *newest;
    unsigned char *next, *end; // free memory of the newest chunk, whole sixteens of bytes
    size_t chunk_size;         // of the next chunk
    bool failed;
} YkArena;

YkArena *yk_arena_new(void);
void yk_arena_free(YkArena *arena);
void yk_arena_clear(YkArena *arena); // all that was given is gone; memory is kept for what comes next, and what failed
void yk_arena_fail(YkArena *arena);  // what should stand in it is not there: its owner ran out of memory elsewhere
// Zeroed memory for `count` things of `size` bytes, aligned to 64 bytes from 64 bytes on, to 16 below.
// NULL on overflow or exhaustion; the arena then remembers: yk_arena_failed() stays true.
void *yk_arena_alloc(YkArena *arena, size_t count, size_t size);
// The same without zeros, aligned to 16 bytes: for what is written at once. The way of small things, many of them.
void *yk_arena_take_from_new_chunk(YkArena *arena, size_t bytes);
static inline void *yk_arena_take(YkArena *arena, size_t bytes)
{
    if (!arena || bytes > (size_t)(arena->end - arena->next)) return yk_arena_take_from_new_chunk(arena, bytes);
    unsigned char *memory = arena->next;
    arena->next += (bytes + 15) & ~(size_t)15;
    return memory;
}
// Gives back what was taken last, all but its first `kept` bytes.
static inline void yk_arena_give_back(YkArena *arena, void *taken, size_t kept)
{
    arena->next = (unsigned char *)taken + ((kept + 15) & ~(size_t)15);
}
bool yk_arena_failed(const YkArena *arena);
// A copy with a final NUL; of what a failed text reads as, NULL, and the arena fails as well.
char *yk_arena_copy(YkArena *arena, const char *text, size_t length);
#define YK_NEW(arena, type, count) ((type *)yk_arena_alloc((arena), (count), sizeof(type)))

// A growing array: capacity doubles. `items` is a pointer variable, `count` and `capacity` size_t variables.
// Evaluates to true when there is room for one more (items may have moved), false when out of memory.
bool yk_grow(void **items, size_t count, size_t *capacity, size_t size);
#define YK_ROOM(items, count, capacity)                                                                                \
    ((count) < (capacity) || yk_grow((void **)&(items), (count), &(capacity), sizeof *(items)))

#endif
