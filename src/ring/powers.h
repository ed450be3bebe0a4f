// Products of whole powers, each kept once and identified by a number: monomials and phases. A product's hash is the
// sum of exponent * hash of the symbol, so the hash of a product of two is the sum of theirs.
#ifndef RING_POWERS_H
#define RING_POWERS_H
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

typedef struct YkPower {
    int32_t symbol, exponent; // exponent != 0
} YkPower;

typedef struct YkProductOfPowers {
    uint64_t hash;
    uint64_t marks; // marks of all its symbols
    size_t first;   // index of its first power in the pool; powers ascend by symbol
    uint32_t count;
    uint32_t note; // what the owner of the table has found out about it; initially 0
} YkProductOfPowers;

// Returns a symbol's mark, one bit of 64: a product without the mark does not contain the symbol.
static inline uint64_t yk_mark(int32_t symbol)
{
    return (uint64_t)1 << (symbol & 63);
}

// A product that was made before. If two belong in one place, the later one stays.
typedef struct YkProductMade {
    uint32_t a, b, product;
    int32_t times; // 0: none
} YkProductMade;

typedef struct YkPowers {
    YkPower *pool;
    size_t pool_count, pool_capacity;
    YkProductOfPowers *items; // item 0 is the empty product, 1
    size_t count, capacity;
    uint32_t *slots; // item + 1, 0 is free; open addressing
    size_t slot_count;
    YkPower *scratch;
    size_t scratch_capacity;
    YkProductMade *made; // [made_count]; cleared when it grows with the table
    size_t made_count;   // a power of two
} YkPowers;

enum { YK_POWER_MAX = 1000000 };
#define YK_NO_PRODUCT UINT32_MAX

typedef enum YkPowersFault { YK_POWERS_FINE, YK_POWERS_MEMORY, YK_POWERS_TOO_LARGE } YkPowersFault;

bool yk_powers_start(YkPowers *table); // given a zeroed table; false when out of memory
void yk_powers_free(YkPowers *table);
// Returns the powers of a product, valid until the next new one.
static inline const YkPower *yk_powers_of(const YkPowers *table, uint32_t item, uint32_t *count)
{
    *count = table->items[item].count;
    return *count > 0 ? table->pool + table->items[item].first : NULL;
}
// Compares in an order that does not depend on what was made first: fewer symbols, lower symbols, lower exponents.
int yk_powers_compare(const YkPowers *table, uint32_t a, uint32_t b);
int32_t yk_powers_exponent(const YkPowers *table, uint32_t item, int32_t symbol); // 0 if it does not occur
// Returns the number of a product. Powers ascend by symbol. On failure YK_NO_PRODUCT with *fault; at most `limit`
// items.
uint32_t yk_powers_enter(YkPowers *table, const YkPower *powers, size_t count, uint32_t limit, YkPowersFault *fault);
// Returns the common part of two products: for each symbol the lower exponent, 0 where it does not occur.
uint32_t yk_powers_common(YkPowers *table, uint32_t a, uint32_t b, uint32_t limit, YkPowersFault *fault);
// Returns a * b^times, times = 1 or -1 (or any other small power), b not 0.
uint32_t yk_powers_multiply(YkPowers *table, uint32_t a, uint32_t b, int32_t times, uint32_t limit,
                            YkPowersFault *fault);
// Returns the product of those powers of an item whose symbols are wanted.
uint32_t yk_powers_part(YkPowers *table, uint32_t item, bool (*is_wanted)(const void *context, int32_t symbol),
                        const void *context, uint32_t limit, YkPowersFault *fault);
static inline YkProductMade *yk_powers_place(const YkPowers *table, uint32_t a, uint32_t b, int32_t times)
{
    uint32_t mixed = (a * 0x9e3779b1u ^ b * 0x85ebca6bu ^ (uint32_t)times) >> 16;
    return &table->made[mixed & (table->made_count - 1)];
}
// Returns whether a * b^times is among the products kept.
static inline bool yk_powers_at_hand(const YkPowers *table, uint32_t a, uint32_t b, int32_t times, uint32_t *product)
{
    const YkProductMade *made = yk_powers_place(table, a, b, times);
    bool is_one = b == 0 || times == 0, is_other = a == 0 && times == 1;
    *product = is_one ? a : is_other ? b : made->product;
    return is_one || is_other || (made->a == a && made->b == b && made->times == times);
}

#endif
