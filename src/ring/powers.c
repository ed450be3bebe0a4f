// The table of products of powers: every monomial or phase once, found by its hash.
#include "ring/powers.h"
#include <stdlib.h>
#include "base/memory.h"
#include "base/mix.h"

enum { MADE_MIN = 64, MADE_MAX = 8192 }; // number of products kept

// Returns a random odd number for each symbol.
static uint64_t symbol_hash(int32_t symbol)
{
    return yk_mix(((uint64_t)symbol + 1) * YK_MIX_STEP) | 1;
}

static size_t slot_start(const YkPowers *table, uint64_t hash)
{
    return (size_t)(hash ^ (hash >> 29)) & (table->slot_count - 1);
}

bool yk_powers_start(YkPowers *table)
{
    table->slot_count = 64;
    table->slots = calloc(table->slot_count, sizeof *table->slots);
    table->made_count = MADE_MIN;
    table->made = calloc(table->made_count, sizeof *table->made);
    YkPowersFault fault;
    return table->slots && table->made && yk_powers_enter(table, NULL, 0, 1, &fault) == 0;
}

void yk_powers_free(YkPowers *table)
{
    free(table->pool);
    free(table->items);
    free(table->slots);
    free(table->scratch);
    free(table->made);
    *table = (YkPowers){0};
}

int32_t yk_powers_exponent(const YkPowers *table, uint32_t item, int32_t symbol)
{
    uint32_t count;
    if (!(table->items[item].marks & yk_mark(symbol))) return 0;
    const YkPower *powers = yk_powers_of(table, item, &count);
    for (uint32_t i = 0; i < count && powers[i].symbol <= symbol; i++)
        if (powers[i].symbol == symbol) return powers[i].exponent;
    return 0;
}

int yk_powers_compare(const YkPowers *table, uint32_t a, uint32_t b)
{
    if (a == b) return 0;
    uint32_t left_count, right_count;
    const YkPower *left = yk_powers_of(table, a, &left_count), *right = yk_powers_of(table, b, &right_count);
    if (left_count != right_count) return left_count < right_count ? -1 : 1;
    for (uint32_t i = 0; i < left_count; i++) {
        if (left[i].symbol != right[i].symbol) return left[i].symbol < right[i].symbol ? -1 : 1;
        if (left[i].exponent != right[i].exponent) return left[i].exponent < right[i].exponent ? -1 : 1;
    }
    return 0;
}

static bool more_slots(YkPowers *table)
{
    size_t slot_count = 2 * table->slot_count;
    uint32_t *slots = slot_count > table->slot_count ? calloc(slot_count, sizeof *slots) : NULL;
    if (!slots) return false;
    free(table->slots);
    table->slots = slots;
    table->slot_count = slot_count;
    for (size_t i = 0; i < table->count; i++) {
        size_t slot = slot_start(table, table->items[i].hash);
        while (slots[slot] != 0) slot = (slot + 1) & (slot_count - 1);
        slots[slot] = (uint32_t)i + 1;
    }
    return true;
}

static bool more_pool(YkPowers *table, size_t wanted)
{
    while (table->pool_capacity - table->pool_count < wanted)
        if (!yk_grow((void **)&table->pool, table->pool_capacity, &table->pool_capacity, sizeof *table->pool))
            return false;
    return true;
}

static uint32_t add_item(YkPowers *table, const YkPower *powers, size_t count, uint64_t hash, uint32_t limit,
                         YkPowersFault *fault)
{
    *fault = table->count >= limit ? YK_POWERS_TOO_LARGE : YK_POWERS_MEMORY;
    if (table->count >= limit || (2 * (table->count + 1) > table->slot_count && !more_slots(table)) ||
        !more_pool(table, count) || !YK_ROOM(table->items, table->count, table->capacity))
        return YK_NO_PRODUCT;
    *fault = YK_POWERS_FINE;
    uint64_t marks = 0;
    for (size_t i = 0; i < count; i++) {
        table->pool[table->pool_count + i] = powers[i];
        marks |= yk_mark(powers[i].symbol);
    }
    table->items[table->count] = (YkProductOfPowers){hash, marks, table->pool_count, (uint32_t)count, 0};
    table->pool_count += count;
    size_t slot = slot_start(table, hash);
    while (table->slots[slot] != 0) slot = (slot + 1) & (table->slot_count - 1);
    table->slots[slot] = (uint32_t)table->count + 1;
    return (uint32_t)table->count++;
}

static bool is_same(const YkPower *a, const YkPower *b, size_t count)
{
    for (size_t i = 0; i < count; i++)
        if (a[i].symbol != b[i].symbol || a[i].exponent != b[i].exponent) return false;
    return true;
}

// Returns the item of these powers, whose hash is known; enters it if it is new.
static uint32_t find_or_add(YkPowers *table, const YkPower *powers, size_t count, uint64_t hash, uint32_t limit,
                            YkPowersFault *fault)
{
    size_t slot = slot_start(table, hash);
    for (; table->slots[slot] != 0; slot = (slot + 1) & (table->slot_count - 1)) {
        const YkProductOfPowers *item = &table->items[table->slots[slot] - 1];
        if (item->hash != hash || item->count != count || !is_same(yk_from(table->pool, item->first), powers, count))
            continue;
        *fault = YK_POWERS_FINE;
        return table->slots[slot] - 1;
    }
    return add_item(table, powers, count, hash, limit, fault);
}

uint32_t yk_powers_enter(YkPowers *table, const YkPower *powers, size_t count, uint32_t limit, YkPowersFault *fault)
{
    uint64_t hash = 0;
    for (size_t i = 0; i < count; i++) {
        if (powers[i].exponent > YK_POWER_MAX || powers[i].exponent < -YK_POWER_MAX) {
            *fault = YK_POWERS_TOO_LARGE;
            return YK_NO_PRODUCT;
        }
        hash += (uint64_t)(int64_t)powers[i].exponent * symbol_hash(powers[i].symbol);
    }
    return find_or_add(table, powers, count, hash, limit, fault);
}

// Merges a * b^times, times not 0, into out, which has room for all. Returns the count, or SIZE_MAX when an exponent is
// too large.
static size_t merge(const YkPower *a, size_t a_count, const YkPower *b, size_t b_count, int32_t times, YkPower *out)
{
    size_t i = 0, count = 0;
    for (size_t k = 0; k < b_count; k++) {
        int64_t exponent = (int64_t)times * b[k].exponent;
        while (i < a_count && a[i].symbol < b[k].symbol) out[count++] = a[i++];
        if (i < a_count && a[i].symbol == b[k].symbol) exponent += a[i++].exponent;
        if (exponent > YK_POWER_MAX || exponent < -YK_POWER_MAX) return SIZE_MAX;
        if (exponent != 0) out[count++] = (YkPower){b[k].symbol, (int32_t)exponent};
    }
    while (i < a_count) out[count++] = a[i++];
    return count;
}

static bool more_scratch(YkPowers *table, size_t wanted)
{
    while (table->scratch_capacity < wanted)
        if (!yk_grow((void **)&table->scratch, table->scratch_capacity, &table->scratch_capacity,
                     sizeof *table->scratch))
            return false;
    return true;
}

uint32_t yk_powers_part(YkPowers *table, uint32_t item, bool (*is_wanted)(const void *context, int32_t symbol),
                        const void *context, uint32_t limit, YkPowersFault *fault)
{
    uint32_t count, wanted = 0;
    const YkPower *powers = yk_powers_of(table, item, &count);
    *fault = YK_POWERS_MEMORY;
    if (!more_scratch(table, count)) return YK_NO_PRODUCT;
    for (uint32_t i = 0; i < count; i++)
        if (is_wanted(context, powers[i].symbol)) table->scratch[wanted++] = powers[i];
    *fault = YK_POWERS_FINE;
    if (wanted == 0) return 0;
    return wanted == count ? item : yk_powers_enter(table, table->scratch, wanted, limit, fault);
}

static uint32_t multiply(YkPowers *table, uint32_t a, uint32_t b, int32_t times, uint32_t limit, YkPowersFault *fault)
{
    const YkProductOfPowers *left = &table->items[a], *right = &table->items[b];
    *fault = YK_POWERS_MEMORY;
    if (!more_scratch(table, (size_t)left->count + right->count)) return YK_NO_PRODUCT;
    size_t count = merge(left->count ? table->pool + left->first : NULL, left->count,
                         right->count ? table->pool + right->first : NULL, right->count, times, table->scratch);
    if (count == SIZE_MAX) {
        *fault = YK_POWERS_TOO_LARGE;
        return YK_NO_PRODUCT;
    }
    uint64_t hash = left->hash + (uint64_t)(int64_t)times * right->hash;
    return find_or_add(table, table->scratch, count, hash, limit, fault);
}

// Enlarges the memory of products as the table grows, and forgets those kept so far. Without memory it changes nothing.
static void keep_more(YkPowers *table)
{
    if (table->made_count >= MADE_MAX || table->count < table->made_count) return;
    YkProductMade *made = calloc(4 * table->made_count, sizeof *made);
    if (!made) return;
    free(table->made);
    table->made = made;
    table->made_count *= 4;
}

uint32_t yk_powers_multiply(YkPowers *table, uint32_t a, uint32_t b, int32_t times, uint32_t limit,
                            YkPowersFault *fault)
{
    uint32_t product;
    *fault = YK_POWERS_FINE;
    if (yk_powers_at_hand(table, a, b, times, &product)) return product;
    product = multiply(table, a, b, times, limit, fault);
    if (product == YK_NO_PRODUCT) return product;
    keep_more(table);
    *yk_powers_place(table, a, b, times) = (YkProductMade){a, b, product, times};
    return product;
}

uint32_t yk_powers_common(YkPowers *table, uint32_t a, uint32_t b, uint32_t limit, YkPowersFault *fault)
{
    uint32_t a_count, b_count, i = 0, k = 0;
    size_t count = 0;
    *fault = YK_POWERS_FINE;
    if (a == b) return a;
    *fault = YK_POWERS_MEMORY;
    if (!more_scratch(table, (size_t)table->items[a].count + table->items[b].count)) return YK_NO_PRODUCT;
    const YkPower *left = yk_powers_of(table, a, &a_count), *right = yk_powers_of(table, b, &b_count);
    while (i < a_count || k < b_count) {
        bool from_a = i < a_count && (k == b_count || left[i].symbol <= right[k].symbol);
        bool from_b = k < b_count && (i == a_count || right[k].symbol <= left[i].symbol);
        YkPower power = {from_a ? left[i].symbol : right[k].symbol, 0};
        int32_t of_a = from_a ? left[i++].exponent : 0, of_b = from_b ? right[k++].exponent : 0;
        power.exponent = of_a < of_b ? of_a : of_b;
        if (power.exponent != 0) table->scratch[count++] = power;
    }
    return yk_powers_enter(table, table->scratch, count, limit, fault);
}
