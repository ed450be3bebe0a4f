// Keeps crossings in a table with open addresses.
#include "map/workspace/crossings.h"
#include <stdlib.h>
#include "base/mix.h"

// Returns the place of a key, or the free one where it belongs; the table is never full.
static YkCrossing *place_of(const YkCrossings *c, uint32_t key)
{
    size_t k = (size_t)yk_mix(key) & (c->capacity - 1);
    while (c->items[k].key != 0 && c->items[k].key != key) k = (k + 1) & (c->capacity - 1);
    return &c->items[k];
}

const YkCrossing *yk_crossings_find(const YkCrossings *crossings, uint32_t key)
{
    const YkCrossing *found = crossings->capacity > 0 ? place_of(crossings, key) : NULL;
    return found && found->key == key ? found : NULL;
}

static bool grow(YkCrossings *c)
{
    YkCrossings larger = {.capacity = c->capacity > 0 ? 2 * c->capacity : 256, .count = c->count};
    larger.items = calloc(larger.capacity, sizeof *larger.items);
    if (!larger.items) return false;
    for (size_t k = 0; k < c->capacity; k++)
        if (c->items[k].key != 0) *place_of(&larger, c->items[k].key) = c->items[k];
    free(c->items);
    *c = larger;
    return true;
}

bool yk_crossings_add(YkCrossings *crossings, YkCrossing crossing)
{
    if (2 * (crossings->count + 1) > crossings->capacity && !grow(crossings)) return false;
    *place_of(crossings, crossing.key) = crossing;
    crossings->count++;
    return true;
}

void yk_crossings_end(YkCrossings *crossings)
{
    free(crossings->items);
    *crossings = (YkCrossings){0};
}
