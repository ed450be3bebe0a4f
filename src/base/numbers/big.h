// Exact comparison of decimal and binary numbers, for the rare cases that 128 bits cannot decide.
#ifndef BASE_BIG_H
#define BASE_BIG_H
#include <stddef.h>
#include <stdint.h>

// 3200 bits. The longest number needed is 770 decimal digits against the midpoint of two doubles: below 2700 bits.
enum { YK_BIG_LIMBS = 100 };
typedef struct YkBig {
    uint32_t limb[YK_BIG_LIMBS];
    size_t count;
} YkBig; // little-endian, no leading zero limb

YkBig yk_big(uint64_t value);
void yk_big_multiply_add(YkBig *big, uint32_t factor, uint32_t addend); // big = big * factor + addend
// Returns the sign of decimal * 10^tens - binary * 2^twos. Scales both numbers in place.
int yk_big_compare(YkBig *decimal, int tens, YkBig *binary, int twos);

#endif
