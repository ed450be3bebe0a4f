// Substitutes many symbols at once. A term splits into the part that is replaced and the part that stays. The image of
// each replaced part is computed once for the changes, and all products of images and rests are gathered.
#include <stdlib.h>
#include "ring/inside.h"

enum { WORK_PER_TERM = 64 }; // products of terms allowed for each term of the ring's limit

typedef struct Image {
    uint64_t replaced; // monomial and phase of the symbols that change, as a key without unit; 0: a free slot
    const YkPoisson *value;
} Image;

// A term, without number and unit: what stays of it, and what the rest becomes.
typedef struct Part {
    uint64_t key, kept; // monomial and phase; kept == key: nothing changes
    const YkPoisson *image;
    bool is_new; // `kept` is still the replaced part; the part that stays is found when terms are gathered
} Part;

enum { TERMS_MADE_MIN = 64, TERMS_MADE_MAX = 1024 };

struct YkRingChanges {
    YkRingChanges *older;    // older changes of the same ring
    const YkRingChange **of; // [symbol_count], NULL for symbols that stay, as newer symbols do
    size_t symbol_count;
    uint64_t marks; // marks of the symbols that change
    Image *images;  // open addressing
    size_t image_count, slot_count;
    Part *made;        // [made_count], earlier terms: if two share a place, the later; NULL: none are kept
    size_t made_count; // a power of two
    Part *parts;       // for each term of the present element
    size_t part_capacity;
    YkRingChange changes[]; // a copy
};

// --- Images

static size_t slot_of(const YkRingChanges *changes, uint64_t replaced)
{
    size_t slot = (size_t)((replaced * 0x9e3779b97f4a7c15u) >> 32) & (changes->slot_count - 1);
    while (changes->images[slot].replaced != 0 && changes->images[slot].replaced != replaced)
        slot = (slot + 1) & (changes->slot_count - 1);
    return slot;
}

static bool more_slots(YkRingChanges *changes)
{
    Image *old = changes->images;
    size_t old_count = changes->slot_count, slot_count = old_count ? 2 * old_count : 32;
    Image *images = calloc(slot_count, sizeof *images);
    if (!images) return false;
    changes->images = images;
    changes->slot_count = slot_count;
    for (size_t k = 0; k < old_count; k++)
        if (old[k].replaced != 0) images[slot_of(changes, old[k].replaced)] = old[k];
    free(old);
    return true;
}

static const YkPoisson *unit_power(YkRing *ring, const YkPoisson *unit, int32_t exponent)
{
    return exponent < 0 ? yk_ring_power(ring, yk_ring_conjugate(ring, unit), -exponent)
                        : yk_ring_power(ring, unit, exponent);
}

static const YkPoisson *make_image(YkRing *ring, const YkRingChanges *changes, uint64_t replaced)
{
    const YkPoisson *image = ring->one;
    uint32_t count;
    yk_powers_of(&ring->monomials, yk_key_monomial(replaced), &count);
    for (uint32_t i = 0; i < count; i++) {
        const YkPower power = yk_powers_of(&ring->monomials, yk_key_monomial(replaced), &count)[i];
        const YkPoisson *value = changes->of[power.symbol]->value;
        image = yk_ring_multiply(ring, image, yk_ring_power(ring, value, power.exponent));
    }
    yk_powers_of(&ring->phases, yk_key_phase(replaced), &count);
    for (uint32_t i = 0; i < count; i++) {
        const YkPower power = yk_powers_of(&ring->phases, yk_key_phase(replaced), &count)[i];
        const YkPoisson *unit = changes->of[power.symbol]->unit;
        image = yk_ring_multiply(ring, image, unit_power(ring, unit, power.exponent));
    }
    return image;
}

// Returns the image of a replaced part.
static const YkPoisson *image_of(YkRing *ring, YkRingChanges *changes, uint64_t replaced)
{
    if (replaced == 0) return ring->one;
    if (2 * (changes->image_count + 1) > changes->slot_count && !more_slots(changes))
        return yk_ring_fail(ring, YK_RING_MEMORY);
    Image *image = &changes->images[slot_of(changes, replaced)];
    if (image->replaced == 0) {
        const YkPoisson *value = yk_ring_keep(ring, make_image(ring, changes, replaced));
        if (!value) return NULL;
        *image = (Image){replaced, value};
        changes->image_count++;
    }
    return image->value;
}

// --- Terms

const YkRingChange *yk_ring_change_of(const YkRingChanges *changes, int32_t symbol)
{
    return (size_t)symbol < changes->symbol_count ? changes->of[symbol] : NULL;
}

static bool has_value(const void *changes, int32_t symbol)
{
    const YkRingChange *change = yk_ring_change_of(changes, symbol);
    return change && change->value;
}

static bool has_unit(const void *changes, int32_t symbol)
{
    const YkRingChange *change = yk_ring_change_of(changes, symbol);
    return change && change->unit;
}

// Finds the part of a term whose symbols change: in the monomial those with a value, in the phase those with a unit.
// Returns false on failure.
static bool find_replaced(YkRing *ring, const YkRingChanges *changes, uint64_t key, uint64_t *replaced)
{
    YkPowersFault fault;
    uint32_t limit = (uint32_t)1 << YK_PHASE_BITS;
    uint32_t phase = yk_powers_part(&ring->phases, yk_key_phase(key), has_unit, changes, limit, &fault);
    if (phase == YK_NO_PRODUCT) yk_ring_fail(ring, fault == YK_POWERS_MEMORY ? YK_RING_MEMORY : YK_RING_POWER);
    uint32_t monomial = phase == YK_NO_PRODUCT ? phase : yk_ring_part(ring, yk_key_monomial(key), has_value, changes);
    *replaced = yk_key(phase, monomial, 0);
    return phase != YK_NO_PRODUCT && monomial != YK_NO_PRODUCT;
}

static Part *place_of(const YkRingChanges *changes, uint64_t key)
{
    return &changes->made[(key * 0x9e3779b97f4a7c15u) >> 40 & (changes->made_count - 1)];
}

static bool is_touched(const YkRing *ring, const YkRingChanges *changes, uint64_t key)
{
    uint64_t marks = ring->monomials.items[yk_key_monomial(key)].marks | ring->phases.items[yk_key_phase(key)].marks;
    return marks & changes->marks;
}

static bool find_part(YkRing *ring, YkRingChanges *changes, uint64_t key, Part *part)
{
    *part = (Part){key, key, ring->one, false};
    if (!is_touched(ring, changes, key)) return true;
    const Part *made = changes->made ? place_of(changes, key) : NULL;
    if (made && made->image && made->key == key) {
        *part = *made;
        return true;
    }
    uint64_t replaced;
    if (!find_replaced(ring, changes, key, &replaced)) return false;
    if (replaced != 0) *part = (Part){key, replaced, image_of(ring, changes, replaced), true};
    return part->image != NULL;
}

// Finds what changes in every term, and the common denominator of the images. *is_same: nothing does. False on failure.
static bool find_images(YkRing *ring, YkRingChanges *changes, const YkPoisson *a, int64_t *denominator, bool *is_same)
{
    size_t work = 0;
    *denominator = 1;
    *is_same = true;
    for (size_t i = 0; i < a->count; i++) {
        if (!YK_ROOM(changes->parts, i, changes->part_capacity)) return yk_ring_fail(ring, YK_RING_MEMORY) != NULL;
        Part *part = &changes->parts[i];
        if (!find_part(ring, changes, a->terms[i].key & ~(uint64_t)(YK_UNITS - 1), part)) return false;
        *is_same = *is_same && !part->is_new && part->kept == part->key;
        if (!yk_common_denominator(*denominator, part->image->denominator, denominator))
            return yk_ring_fail(ring, YK_RING_OVERFLOW) != NULL;
        work += part->image->count;
        if (work / WORK_PER_TERM > ring->limit) return yk_ring_fail(ring, YK_RING_SIZE) != NULL;
    }
    return true;
}

// Divides the replaced part out of the term. Returns false on failure.
static bool finish_part(YkRing *ring, YkRingChanges *changes, Part *part)
{
    if (!part->is_new) return true;
    uint32_t monomial = yk_ring_monomial(ring, yk_key_monomial(part->key), yk_key_monomial(part->kept), -1);
    uint32_t phase = yk_ring_phase(ring, yk_key_phase(part->key), yk_key_phase(part->kept), -1);
    if (monomial == YK_NO_PRODUCT || phase == YK_NO_PRODUCT) return false;
    part->kept = yk_key(phase, monomial, 0);
    part->is_new = false;
    if (changes->made) *place_of(changes, part->key) = *part;
    return true;
}

// Gathers a term with its replaced part as its image.
static bool add_term(YkRing *ring, YkRingChanges *changes, YkRingTerm term, Part *part, int64_t denominator)
{
    const YkPoisson *image = part->image;
    if (!finish_part(ring, changes, part)) return !(ring->gather.failed = true);
    if (!yk_ring_spend(ring, image->count * YK_WORK_PRODUCT)) return !(ring->gather.failed = true);
    const YkRingTerm kept = {part->kept | yk_key_unit(term.key), term.number};
    for (size_t i = 0; i < image->count; i++)
        if (!yk_gather_add_product(ring, &image->terms[i], &kept, denominator / image->denominator)) return false;
    return true;
}

const YkPoisson *yk_ring_change(YkRing *ring, const YkPoisson *a, YkRingChanges *changes)
{
    int64_t denominator, whole;
    bool is_same;
    if (!a || !changes || a->count == 0) return changes ? a : NULL;
    if (!find_images(ring, changes, a, &denominator, &is_same)) return NULL;
    if (is_same) return a;
    if (!yk_exact_multiply(denominator, a->denominator, &whole)) return yk_ring_fail(ring, YK_RING_OVERFLOW);
    yk_gather_begin(ring, whole);
    for (size_t i = 0; i < a->count; i++)
        if (!add_term(ring, changes, a->terms[i], &changes->parts[i], denominator)) break;
    return yk_gather_end(ring);
}

// --- Sets of changes

static void free_changes(YkRingChanges *changes)
{
    if (!changes) return;
    free((void *)changes->of);
    free(changes->images);
    free(changes->parts);
    free(changes->made);
    free(changes);
}

static YkRingChanges *new_changes(YkRing *ring, const YkRingChange *list, size_t count)
{
    for (size_t i = 0; i < count; i++)
        if (list[i].symbol < 0 || (size_t)list[i].symbol >= ring->symbol_count) {
            yk_ring_fail(ring, YK_RING_NAME);
            return NULL;
        }
    YkRingChanges *changes = calloc(1, sizeof *changes + count * sizeof *list);
    if (changes) changes->of = calloc(ring->symbol_count + 1, sizeof *changes->of);
    if (!changes || !changes->of) {
        free_changes(changes);
        yk_ring_fail(ring, YK_RING_MEMORY);
        return NULL;
    }
    changes->symbol_count = ring->symbol_count;
    for (size_t i = 0; i < count; i++) {
        changes->changes[i] = list[i];
        changes->of[list[i].symbol] = &changes->changes[i];
        changes->marks |= yk_mark(list[i].symbol);
    }
    return changes;
}

YkRingChanges *yk_ring_changes(YkRing *ring, const YkRingChange *list, size_t count)
{
    YkRingChanges *changes = new_changes(ring, list, count);
    if (!changes) return NULL;
    changes->made_count = TERMS_MADE_MIN;
    while (changes->made_count < TERMS_MADE_MAX && changes->made_count < 2 * changes->symbol_count)
        changes->made_count *= 2;
    // Without memory for it everything is merely as slow as the first time.
    changes->made = calloc(changes->made_count, sizeof *changes->made);
    changes->older = ring->changes;
    ring->changes = changes;
    return changes;
}

void yk_ring_free_all_changes(YkRing *ring)
{
    for (YkRingChanges *changes = ring->changes, *older; changes; changes = older) {
        older = changes->older;
        free_changes(changes);
    }
}

const YkPoisson *yk_ring_substitute(YkRing *ring, const YkPoisson *a, const YkRingChange *list, size_t count)
{
    YkRingChanges *changes = a ? new_changes(ring, list, count) : NULL;
    const YkPoisson *changed = yk_ring_change(ring, a, changes);
    free_changes(changes);
    return changed;
}
