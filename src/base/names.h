// Names: a hash table from strings to indices; and the nearest name, for "did you mean".
#ifndef BASE_NAMES_H
#define BASE_NAMES_H
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum { YK_NONE = -1 };
typedef struct YkNameEntry {
    int32_t value;
    uint32_t hash; // 0: a free slot
} YkNameEntry;

typedef struct YkNames {
    const char **keys;    // NULL in a free slot
    YkNameEntry *entries; // in the same slots: hashes distinguish most keys without reading their text
    size_t count, capacity;
} YkNames; // zeroed = empty

void yk_names_free(YkNames *names);
// Adds key -> value. The key is not copied and must outlive the table. Returns false when out of memory. *existing gets
// the value already there (the table is then unchanged) or YK_NONE.
bool yk_names_add(YkNames *names, const char *key, int32_t value, int32_t *existing);
int32_t yk_names_find(const YkNames *names, const char *key); // YK_NONE if there is none
// Returns the candidate nearest to `name` by edit distance (a transposition counts 1), or NULL when none is near:
// distance > 1 + length / 4, or no character in common. A name that differs only in case is nearer than any edit. Skips
// NULL candidates. Cost O(count * length^2); stops after 10,000 candidates.
const char *yk_nearest(const char *name, const char *const *candidates, size_t count);

#endif
