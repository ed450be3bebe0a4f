// Open addressing with linear probing; a power of two of slots, at most half full.
#include "base/names.h"
#include <stdlib.h>
#include <string.h>

void yk_names_free(YkNames *names)
{
    free(names->keys);
    free(names->values);
    *names = (YkNames){0};
}

// FNV-1a with a final mix, since only the low bits choose the slot (Fowler, Noll, Vo; Steele et al. 2014).
static uint64_t hash(const char *key)
{
    uint64_t h = 0xcbf29ce484222325u;
    for (; *key; key++) h = (h ^ (unsigned char)*key) * 0x100000001b3u;
    h = (h ^ (h >> 30)) * 0xbf58476d1ce4e5b9u;
    return h ^ (h >> 31);
}

// The slot that holds key, or the free one where it belongs. capacity > 0 and a slot is free.
static size_t slot_of(const YkNames *names, const char *key)
{
    size_t mask = names->capacity - 1, slot = (size_t)hash(key) & mask;
    while (names->keys[slot] && strcmp(names->keys[slot], key) != 0) slot = (slot + 1) & mask;
    return slot;
}

static bool rehash(YkNames *names)
{
    YkNames larger = {.count = names->count, .capacity = names->capacity ? 2 * names->capacity : 16};
    if (larger.capacity < names->capacity) return false;
    larger.keys = calloc(larger.capacity, sizeof *larger.keys);
    larger.values = calloc(larger.capacity, sizeof *larger.values);
    if (!larger.keys || !larger.values) {
        yk_names_free(&larger);
        return false;
    }
    for (size_t i = 0; i < names->capacity; i++) {
        if (!names->keys[i]) continue;
        size_t slot = slot_of(&larger, names->keys[i]);
        larger.keys[slot] = names->keys[i];
        larger.values[slot] = names->values[i];
    }
    yk_names_free(names);
    *names = larger;
    return true;
}

bool yk_names_add(YkNames *names, const char *key, int32_t value, int32_t *existing)
{
    int32_t found = yk_names_find(names, key);
    if (existing) *existing = found;
    if (found != YK_NONE) return true;
    if (2 * (names->count + 1) > names->capacity && !rehash(names)) return false;
    size_t slot = slot_of(names, key);
    names->keys[slot] = key;
    names->values[slot] = value;
    names->count++;
    return true;
}

int32_t yk_names_find(const YkNames *names, const char *key)
{
    if (names->capacity == 0) return YK_NONE;
    size_t slot = slot_of(names, key);
    return names->keys[slot] ? names->values[slot] : YK_NONE;
}
