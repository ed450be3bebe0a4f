// Hash table with open addressing and linear probing; the number of slots is a power of two, at most half of them full.
#include "base/names.h"
#include <stdlib.h>
#include <string.h>

void yk_names_free(YkNames *names)
{
    free(names->keys);
    free(names->entries);
    *names = (YkNames){0};
}

// FNV-1a with a final mix, since only the low bits choose the slot (Fowler, Noll, Vo; Steele et al. 2014). Never 0.
static uint32_t hash(const char *key)
{
    uint64_t h = 0xcbf29ce484222325u;
    for (; *key; key++) h = (h ^ (unsigned char)*key) * 0x100000001b3u;
    h = (h ^ (h >> 30)) * 0xbf58476d1ce4e5b9u;
    h ^= h >> 31;
    return (uint32_t)h != 0 ? (uint32_t)h : 1;
}

// Returns the slot that holds key, or the free slot where it belongs. Requires capacity > 0 and a free slot.
static size_t slot_of(const YkNames *names, const char *key, uint32_t hash)
{
    size_t mask = names->capacity - 1, slot = hash & mask;
    for (; names->entries[slot].hash != 0; slot = (slot + 1) & mask)
        if (names->entries[slot].hash == hash && strcmp(names->keys[slot], key) == 0) break;
    return slot;
}

static bool rehash(YkNames *names)
{
    YkNames larger = {.count = names->count, .capacity = names->capacity ? 2 * names->capacity : 16};
    if (larger.capacity > UINT32_MAX / 2) return false;
    larger.keys = calloc(larger.capacity, sizeof *larger.keys);
    larger.entries = calloc(larger.capacity, sizeof *larger.entries);
    if (!larger.keys || !larger.entries) {
        yk_names_free(&larger);
        return false;
    }
    for (size_t i = 0; i < names->capacity; i++) {
        if (names->entries[i].hash == 0) continue;
        size_t mask = larger.capacity - 1, slot = names->entries[i].hash & mask;
        while (larger.entries[slot].hash != 0) slot = (slot + 1) & mask;
        larger.keys[slot] = names->keys[i];
        larger.entries[slot] = names->entries[i];
    }
    yk_names_free(names);
    *names = larger;
    return true;
}

bool yk_names_add(YkNames *names, const char *key, int32_t value, int32_t *existing)
{
    uint32_t h = hash(key);
    size_t slot = names->capacity > 0 ? slot_of(names, key, h) : 0;
    bool is_there = names->capacity > 0 && names->entries[slot].hash != 0;
    if (existing) *existing = is_there ? names->entries[slot].value : YK_NONE;
    if (is_there) return true;
    if (2 * (names->count + 1) > names->capacity) {
        if (!rehash(names)) return false;
        slot = slot_of(names, key, h);
    }
    names->keys[slot] = key;
    names->entries[slot] = (YkNameEntry){value, h};
    names->count++;
    return true;
}

int32_t yk_names_find(const YkNames *names, const char *key)
{
    if (names->capacity == 0) return YK_NONE;
    size_t slot = slot_of(names, key, hash(key));
    return names->entries[slot].hash != 0 ? names->entries[slot].value : YK_NONE;
}
