// Collects terms: a hash table from keys to coefficients, sorted at the end.
#include <stdlib.h>
#include <string.h>
#include "ring/inside.h"

enum { INSERTION_MAX = 24, FEW = 12 }; // FEW: so few terms are searched one by one

void yk_gather_free(YkGather *gather)
{
    free(gather->terms);
    free(gather->slots);
    free(gather->sorted);
    *gather = (YkGather){0};
}

static size_t slot_start(const YkGather *gather, uint64_t key)
{
    return (size_t)((key * 0x9e3779b97f4a7c15u) >> 32) & (gather->slot_count - 1);
}

static void enter_all(YkGather *gather)
{
    for (size_t i = 0; i < gather->count; i++) {
        size_t slot = slot_start(gather, gather->terms[i].key);
        while (gather->slots[slot] != 0) slot = (slot + 1) & (gather->slot_count - 1);
        gather->slots[slot] = (uint32_t)i + 1;
    }
}

// Allocates twice as many slots and enters all terms anew.
static bool more_slots(YkGather *gather)
{
    size_t slot_count = gather->slot_count ? 2 * gather->slot_count : 64;
    uint32_t *slots = slot_count > gather->slot_count ? calloc(slot_count, sizeof *slots) : NULL;
    if (!slots) return false;
    free(gather->slots);
    gather->slots = slots;
    gather->slot_count = slot_count;
    if (gather->count > FEW && !gather->ascends) enter_all(gather);
    return true;
}

bool yk_gather_room(YkRing *ring, size_t count)
{
    YkGather *gather = &ring->gather;
    while (gather->capacity < count)
        if (!yk_grow((void **)&gather->terms, gather->capacity, &gather->capacity, sizeof *gather->terms)) {
            yk_ring_fail(ring, YK_RING_MEMORY);
            return false;
        }
    return true;
}

void yk_gather_begin(YkRing *ring, int64_t denominator)
{
    ring->gather.count = 0;
    ring->gather.ascends = true;
    ring->gather.is_distinct = false;
    ring->gather.denominator = denominator;
    ring->gather.failed = false;
}

void yk_gather_begin_distinct(YkRing *ring, int64_t denominator)
{
    yk_gather_begin(ring, denominator);
    ring->gather.is_distinct = true;
}

static bool fail(YkRing *ring, YkRingStatus status)
{
    ring->gather.failed = true;
    yk_ring_fail(ring, status);
    return false;
}

// Returns the term of a key, or NULL; *slot is then where it belongs.
static YkRingTerm *find_term(YkGather *gather, uint64_t key, size_t *slot)
{
    if (gather->count <= FEW) {
        for (size_t i = 0; i < gather->count; i++)
            if (gather->terms[i].key == key) return &gather->terms[i];
        return NULL;
    }
    for (*slot = slot_start(gather, key); gather->slots[*slot] != 0; *slot = (*slot + 1) & (gather->slot_count - 1))
        if (gather->terms[gather->slots[*slot] - 1].key == key) return &gather->terms[gather->slots[*slot] - 1];
    return NULL;
}

// Handles the first key that does not ascend: enters the terms collected so far.
static bool stop_ascending(YkGather *gather)
{
    while (gather->count >= FEW && 2 * (gather->count + 2) > gather->slot_count)
        if (!more_slots(gather)) return false;
    gather->ascends = false;
    if (gather->count > FEW) enter_all(gather);
    return true;
}

static bool append(YkRing *ring, uint64_t key, int64_t number)
{
    YkGather *gather = &ring->gather;
    if (gather->count >= ring->limit) return fail(ring, YK_RING_SIZE);
    if (!YK_ROOM(gather->terms, gather->count, gather->capacity)) return fail(ring, YK_RING_MEMORY);
    gather->terms[gather->count++] = (YkRingTerm){key, number};
    return true;
}

bool yk_gather_add(YkRing *ring, uint64_t key, int64_t number)
{
    YkGather *gather = &ring->gather;
    size_t slot = 0;
    if (gather->failed) return false;
    if (gather->ascends) {
        if (gather->count == 0 || gather->terms[gather->count - 1].key < key) return append(ring, key, number);
        if (gather->is_distinct)
            gather->ascends = false;
        else if (!stop_ascending(gather))
            return fail(ring, YK_RING_MEMORY);
    }
    if (gather->is_distinct) return append(ring, key, number);
    if (gather->count >= FEW && 2 * (gather->count + 2) > gather->slot_count && !more_slots(gather))
        return fail(ring, YK_RING_MEMORY);
    YkRingTerm *term = find_term(gather, key, &slot);
    if (term) return yk_exact_add(term->number, number, &term->number) || fail(ring, YK_RING_OVERFLOW);
    if (!append(ring, key, number)) return false;
    if (gather->count == FEW + 1) enter_all(gather);
    if (gather->count > FEW + 1) gather->slots[slot] = (uint32_t)gather->count;
    return true;
}

bool yk_gather_add_product(YkRing *ring, const YkRingTerm *a, const YkRingTerm *b, int64_t factor)
{
    uint64_t key;
    int64_t number;
    if (ring->gather.failed) return false;
    if (!yk_ring_key_product(ring, a->key, b->key, &key)) {
        ring->gather.failed = true;
        return false;
    }
    int unit = yk_unit_factor(yk_key_unit(a->key), yk_key_unit(b->key));
    if (!yk_exact_multiply(a->number, b->number, &number) || !yk_exact_multiply(number, factor, &number) ||
        !yk_exact_multiply(number, unit, &number))
        return fail(ring, YK_RING_OVERFLOW);
    return yk_gather_add(ring, key, number);
}

static void empty_slots(YkGather *gather)
{
    if (gather->ascends || gather->is_distinct || gather->count <= FEW) return;
    if (gather->count * 8 > gather->slot_count) {
        if (gather->slots) memset(gather->slots, 0, gather->slot_count * sizeof *gather->slots);
        return;
    }
    // Few terms in a large table: undoes them in reverse order, so that each is found along its own chain.
    for (size_t i = gather->count; i-- > 0;) {
        size_t slot = slot_start(gather, gather->terms[i].key);
        while (gather->slots[slot] != (uint32_t)i + 1) slot = (slot + 1) & (gather->slot_count - 1);
        gather->slots[slot] = 0;
    }
}

static void sort_insertion(YkRingTerm *terms, size_t count)
{
    for (size_t i = 1; i < count; i++) {
        YkRingTerm term = terms[i];
        size_t k = i;
        for (; k > 0 && terms[k - 1].key > term.key; k--) terms[k] = terms[k - 1];
        terms[k] = term;
    }
}

static void merge_runs(const YkRingTerm *from, YkRingTerm *to, size_t count, size_t run)
{
    for (size_t start = 0; start < count; start += 2 * run) {
        size_t middle = start + run < count ? start + run : count, end = middle + run < count ? middle + run : count;
        size_t i = start, k = middle;
        for (size_t at = start; at < end; at++)
            to[at] = i < middle && (k == end || from[i].key <= from[k].key) ? from[i++] : from[k++];
    }
}

// Sorts by merging runs that are sorted by insertion. Returns false when out of memory.
static bool sort_terms(YkGather *gather)
{
    size_t count = gather->count;
    for (size_t i = 0; i < count; i += INSERTION_MAX)
        sort_insertion(gather->terms + i, count - i < INSERTION_MAX ? count - i : INSERTION_MAX);
    if (count <= INSERTION_MAX) return true;
    while (gather->sorted_capacity < gather->capacity)
        if (!yk_grow((void **)&gather->sorted, gather->sorted_capacity, &gather->sorted_capacity,
                     sizeof *gather->sorted))
            return false;
    for (size_t run = INSERTION_MAX; run < count; run *= 2) {
        merge_runs(gather->terms, gather->sorted, count, run);
        YkRingTerm *terms = gather->terms;
        size_t capacity = gather->capacity;
        gather->terms = gather->sorted;
        gather->capacity = gather->sorted_capacity;
        gather->sorted = terms;
        gather->sorted_capacity = capacity;
    }
    return true;
}

const YkPoisson *yk_gather_end(YkRing *ring)
{
    YkGather *gather = &ring->gather;
    empty_slots(gather);
    if (gather->failed) return NULL;
    if (!gather->ascends && !sort_terms(gather)) return yk_ring_fail(ring, YK_RING_MEMORY);
    return yk_poisson_make(ring, gather->terms, gather->count, gather->denominator);
}
