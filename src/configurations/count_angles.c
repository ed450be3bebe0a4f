// Counts solutions by deletion and contraction.
#include "configurations/count.h"
#include <stdlib.h>

// Counts that are known, by key; open addressing.
typedef struct Known {
    uint32_t *key; // 0: free
    uint32_t *value;
    size_t size, used; // size: a power of two
} Known;

typedef struct Counter {
    const YkMatroid *matroid;
    size_t all;
    Known known;
    YkPace *pace;
    bool failed;
} Counter;

static size_t place_of(const Known *known, uint32_t key)
{
    size_t at = (key * 2654435761u) & (known->size - 1);
    while (known->key[at] != 0 && known->key[at] != key) at = (at + 1) & (known->size - 1);
    return at;
}

static bool start_known(Known *known, size_t size)
{
    *known = (Known){calloc(size, sizeof *known->key), calloc(size, sizeof *known->value), size, 0};
    return known->key && known->value;
}

static void end_known(Known *known)
{
    free(known->key);
    free(known->value);
}

static bool learn(Known *known, uint32_t key, uint32_t value)
{
    if (2 * known->used >= known->size) {
        Known larger;
        bool ok = start_known(&larger, 2 * known->size);
        for (size_t k = 0; ok && k < known->size; k++)
            if (known->key[k] != 0) ok = learn(&larger, known->key[k], known->value[k]);
        if (!ok) end_known(&larger);
        if (!ok) return false;
        end_known(known);
        *known = larger;
    }
    size_t at = place_of(known, key);
    known->key[at] = key;
    known->value[at] = value;
    known->used++;
    return true;
}

static int size_of(size_t set)
{
    int size = 0;
    for (; set; set &= set - 1) size++;
    return size;
}

// Returns the rank of a set after others were contracted.
static int rank(const Counter *c, size_t set, size_t contracted)
{
    return c->matroid->rank[set | contracted] - c->matroid->rank[contracted];
}

static uint32_t count_minor(Counter *c, size_t set, size_t first);

// Adds up the ways in which the solutions break up into two parts when the product of the last element's coordinates
// tends to zero: `high`, which with it tends to zero faster, and the rest.
static uint32_t count_parts(Counter *c, size_t set, size_t first, size_t second)
{
    size_t last = set & -set, rest = set ^ last;
    uint32_t sum = 0;
    for (size_t high = rest;; high = (high - 1) & rest) {
        size_t low = rest ^ high;
        bool is_high = rank(c, high, first) + rank(c, set, second) - rank(c, low | last, second) == size_of(high) + 1;
        bool is_low = rank(c, set, first) - rank(c, high | last, first) + rank(c, low, second) == size_of(low) + 1;
        if ((is_high || high == 0) && (is_low || low == 0)) {
            uint32_t high_count = high == 0 ? 1 : count_minor(c, high, first);
            uint32_t low_count = high_count == 0 ? 0 : low == 0 ? 1 : count_minor(c, low, first | high | last);
            sum += high_count * low_count;
        }
        if (high == 0 || c->failed) return sum;
    }
}

// Counts for the elements of a set; of the others, `first` are contracted in the first matroid and deleted in the
// second, the rest the other way round.
static uint32_t count_minor(Counter *c, size_t set, size_t first)
{
    size_t second = c->all & ~(set | first);
    for (size_t left = set; left; left &= left - 1) {
        size_t element = left & -left;
        if (rank(c, element, first) == 0 || rank(c, element, second) == 0) return 0;
    }
    if ((set & (set - 1)) == 0) return 1;
    uint32_t key = (uint32_t)(set << 16 | first);
    size_t at = place_of(&c->known, key);
    if (c->known.key[at] == key) return c->known.value[at];
    c->failed |= !yk_pace_spend(c->pace, (size_t)10 << size_of(set));
    uint32_t count = c->failed ? 0 : count_parts(c, set, first, second);
    if (!c->failed) c->failed = !learn(&c->known, key, count);
    return count;
}

YkCountStatus yk_count_angles(const YkMatroid *matroid, YkPace *pace, size_t *count)
{
    Counter c = {.matroid = matroid, .all = ((size_t)1 << matroid->elements) - 1, .pace = pace};
    bool started = start_known(&c.known, 1024);
    *count = started ? count_minor(&c, c.all, 0) : 0;
    end_known(&c.known);
    if (!started || c.failed) return yk_pace_is_stopped(pace) ? YK_COUNT_STOPPED : YK_COUNT_NO_MEMORY;
    return YK_COUNTED;
}
