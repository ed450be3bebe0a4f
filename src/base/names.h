// Names: a hash table from strings to indices; and the closest name, for "did you mean".
#ifndef BASE_NAMES_H
#define BASE_NAMES_H
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum { YK_NONE = -1 };
typedef struct YkNameEntry {
    int32_t value;
    uint32_t hash; // 0: a free place
} YkNameEntry;

typedef struct YkNames {
    const char **keys;    // NULL at a free place
    YkNameEntry *entries; // at the same places: most are told apart without a look at their text
    size_t count, capacity;
} YkNames; // zeroed = empty

void yk_names_free(YkNames *names);
// Adds key -> value (the key is not copied and must outlive the table). False when out of memory; *existing gets the
// value already there (the table is unchanged) or YK_NONE.
bool yk_names_add(YkNames *names, const char *key, int32_t value, int32_t *existing);
int32_t yk_names_find(const YkNames *names, const char *key); // YK_NONE where there is none
// Among candidates, the one nearest to `name` by edit distance (transpositions count 1), or NULL when none is near
// (distance > 1 + length / 4, or no character is kept). Another case of the same letters is nearer than any edit.
// NULL candidates are skipped. Cost O(count * length^2); stops looking after 10,000 candidates.
const char *yk_nearest(const char *name, const char *const *candidates, size_t count);

#endif
