// Evaluates elements at points of the prime field.
#include <stdlib.h>
#include <string.h>
#include "base/mix.h"
#include "ring/inside.h"
#include "ring/proof/field.h"

enum { DENOMINATORS = 64, /* 2^6 */ TRIES = 256, DRAWS = 64 }; // half of all values are squares at a random point

// Inverses are computed on demand: most never are. 0: not computed yet.
typedef struct Denominator {
    int64_t of;
    uint64_t inverse;
} Denominator;

struct YkFieldPoint {
    size_t count;
    uint64_t *value, *value_inverse, *unit, *unit_inverse; // [count]; one block, `value`
    uint64_t number[YK_UNITS];                             // i, sqrt 2, sqrt 3 and their products
    Denominator *denominators;                             // [DENOMINATORS]: the latest ones, by hash
    bool is_loose;
};

// Returns a random value below p, not 0.
static uint64_t random_value(uint64_t *seed)
{
    return yk_mix_next(seed) % (YK_PRIME - 1) + 1;
}

static void set_numbers(YkFieldPoint *point)
{
    static const uint64_t squares[] = {YK_PRIME - 1, 2, 3};
    point->number[0] = 1;
    for (unsigned bit = 0; bit < 3; bit++) {
        uint64_t root = 0;
        yk_field_sqrt(squares[bit], &root); // p - 1 is a multiple of 24, so the roots exist
        for (unsigned unit = 0; unit < 1u << bit; unit++)
            point->number[unit | 1u << bit] = yk_field_multiply(point->number[unit], root);
    }
}

void yk_field_point_set(YkFieldPoint *point, int32_t symbol, uint64_t value)
{
    if (symbol < 0 || (size_t)symbol >= point->count) return;
    point->value[symbol] = value;
    point->value_inverse[symbol] = 0;
}

void yk_field_point_set_unit(YkFieldPoint *point, int32_t angle, uint64_t unit)
{
    if (angle < 0 || (size_t)angle >= point->count) return;
    point->unit[angle] = unit;
    point->unit_inverse[angle] = 0;
}

uint64_t yk_field_point_get(const YkFieldPoint *point, int32_t symbol)
{
    return symbol >= 0 && (size_t)symbol < point->count ? point->value[symbol] : 0;
}

bool yk_field_point_is_loose(const YkFieldPoint *point)
{
    return point->is_loose;
}

static void draw(const YkRing *ring, YkFieldPoint *point, int32_t symbol, uint64_t *seed)
{
    const YkPoisson *number = ring->symbols[symbol].meaning->number;
    uint64_t drawn = random_value(seed);
    yk_field_point_set(point, symbol, number ? yk_ring_field(ring, number, point, false) : drawn);
    if (ring->symbols[symbol].is_angle) yk_field_point_set_unit(point, symbol, random_value(seed));
}

// Returns a symbol of the square on which no earlier root depends; -1 if there is none.
static int32_t free_symbol(const YkRing *ring, const YkPoisson *square, const bool *is_taken)
{
    int32_t symbol = yk_ring_next_symbol(ring, square, -1);
    while (symbol >= 0 &&
           (is_taken[symbol] || ring->symbols[symbol].meaning->square || ring->symbols[symbol].meaning->number))
        symbol = yk_ring_next_symbol(ring, square, symbol);
    return symbol;
}

// Fixes from now on what the root depends on.
static void take(const YkRing *ring, const YkPoisson *square, bool *is_taken)
{
    for (int32_t s = yk_ring_next_symbol(ring, square, -1); s >= 0; s = yk_ring_next_symbol(ring, square, s))
        is_taken[s] = true;
}

// Draws anew only what the square depends on. The square of a number such as 7 may have no root in this field: its root
// is then any value.
static bool find_root(const YkRing *ring, YkFieldPoint *point, size_t root, bool *is_taken, uint64_t *seed)
{
    const YkPoisson *square = ring->symbols[root].meaning->square;
    uint64_t value;
    int draws = 0;
    while (!yk_field_sqrt(yk_ring_field(ring, square, point, false), &value)) {
        int32_t symbol = free_symbol(ring, square, is_taken);
        if (symbol < 0 || draws++ == DRAWS) {
            if (yk_ring_next_symbol(ring, square, -1) >= 0) return false;
            draw(ring, point, (int32_t)root, seed);
            return point->is_loose = true;
        }
        draw(ring, point, symbol, seed);
    }
    take(ring, square, is_taken);
    bool is_turned = random_value(seed) & 1; // the field does not know which of the two is positive
    yk_field_point_set(point, (int32_t)root, is_turned ? yk_field_negate(value) : value);
    return true;
}

// Draws random values for all symbols and computes the roots; returns false if a root does not exist here.
static bool fill(const YkRing *ring, YkFieldPoint *point, bool *is_taken, uint64_t *seed)
{
    for (size_t i = 0; i < point->count; i++)
        if (!ring->symbols[i].meaning->square)
            draw(ring, point, (int32_t)i, seed);
        else if (!find_root(ring, point, i, is_taken, seed))
            return false;
    return true;
}

YkFieldPoint *yk_field_point_new(const YkRing *ring, uint64_t seed)
{
    YkFieldPoint *point = calloc(1, sizeof *point);
    uint64_t *block = calloc(4 * ring->symbol_count + 1, sizeof *block);
    Denominator *denominators = calloc(DENOMINATORS, sizeof *denominators);
    bool *is_taken = calloc(ring->symbol_count + 1, sizeof *is_taken), is_filled = false;
    size_t count = ring->symbol_count;
    if (point && block && denominators && is_taken) {
        *point = (YkFieldPoint){.count = count,
                                .value = block,
                                .value_inverse = block + count,
                                .unit = block + 2 * count,
                                .unit_inverse = block + 3 * count,
                                .denominators = denominators};
        set_numbers(point);
        for (int i = 0; i < TRIES && !is_filled; i++) {
            memset(is_taken, 0, count);
            point->is_loose = false;
            is_filled = fill(ring, point, is_taken, &seed);
        }
    }
    free(is_taken);
    if (is_filled) return point;
    free(block);
    free(denominators);
    free(point);
    return NULL;
}

void yk_field_point_free(YkFieldPoint *point)
{
    if (!point) return;
    free(point->value);
    free(point->denominators);
    free(point);
}

// The values of symbols, or units of angles, and their inverses.
typedef struct Bases {
    const uint64_t *value;
    uint64_t *inverse;
    size_t known;
} Bases;

static uint64_t inverse_at(const Bases *bases, int32_t symbol)
{
    uint64_t *inverse = &bases->inverse[symbol];
    if (*inverse == 0) *inverse = yk_field_invert(bases->value[symbol]);
    return *inverse;
}

static uint64_t power_of(uint64_t base, int64_t exponent)
{
    if (exponent == 1) return base;
    return exponent == 2 ? yk_field_multiply(base, base) : yk_field_power(base, (uint64_t)exponent);
}

// Returns the value of a product; of the conjugate by the inverse of each power.
static uint64_t powers_value(const YkPowers *table, uint32_t item, const Bases *bases, bool conjugate)
{
    uint32_t count;
    const YkPower *powers = yk_powers_of(table, item, &count);
    uint64_t value = 1;
    for (uint32_t i = 0; i < count; i++) {
        int32_t symbol = powers[i].symbol;
        int64_t exponent = conjugate ? -(int64_t)powers[i].exponent : powers[i].exponent;
        if ((size_t)symbol >= bases->known) return 0;
        uint64_t base = exponent < 0 ? inverse_at(bases, symbol) : bases->value[symbol];
        value = yk_field_multiply(value, power_of(base, exponent < 0 ? -exponent : exponent));
    }
    return value;
}

static uint64_t inverse_of(const YkFieldPoint *point, int64_t denominator)
{
    Denominator *known = &point->denominators[(uint64_t)denominator * 0x9e3779b97f4a7c15u >> 58];
    if (known->of != denominator) *known = (Denominator){denominator, yk_field_invert(yk_field_of(denominator))};
    return known->inverse;
}

uint64_t yk_ring_field(const YkRing *ring, const YkPoisson *a, const YkFieldPoint *point, bool conjugate)
{
    uint64_t sum = 0, phase = 1;
    yk_pace_spend(ring->pace, (1 + yk_ring_terms(a)) * YK_WORK_VALUE);
    Bases values = {point->value, point->value_inverse, point->count},
          units = {point->unit, point->unit_inverse, point->count};
    for (size_t i = 0; a && i < a->count; i++) {
        uint64_t key = a->terms[i].key;
        if (i == 0 || yk_key_phase(key) != yk_key_phase(a->terms[i - 1].key))
            phase = powers_value(&ring->phases, yk_key_phase(key), &units, conjugate);
        uint64_t term = powers_value(&ring->monomials, yk_key_monomial(key), &values, false);
        term = yk_field_multiply(yk_field_multiply(term, phase), point->number[yk_key_unit(key)]);
        term = yk_field_multiply(term, yk_field_of(a->terms[i].number));
        bool negative = conjugate && (yk_key_unit(key) & YK_UNIT_I);
        sum = negative ? yk_field_subtract(sum, term) : yk_field_add(sum, term);
    }
    return a && a->denominator != 1 ? yk_field_multiply(sum, inverse_of(point, a->denominator)) : sum;
}
