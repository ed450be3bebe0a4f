// Big natural numbers: multiplication by small factors, and exact comparison after scaling.
#include "base/numbers/big.h"

YkBig yk_big(uint64_t value)
{
    YkBig big = {.count = 0};
    for (; value != 0; value >>= 32) big.limb[big.count++] = (uint32_t)value;
    return big;
}

void yk_big_multiply_add(YkBig *big, uint32_t factor, uint32_t addend)
{
    uint64_t carry = addend;
    for (size_t i = 0; i < big->count; i++) {
        carry += (uint64_t)big->limb[i] * factor;
        big->limb[i] = (uint32_t)carry;
        carry >>= 32;
    }
    if (carry != 0 && big->count < YK_BIG_LIMBS) big->limb[big->count++] = (uint32_t)carry;
}

static void multiply_by_five_to(YkBig *big, int power)
{
    for (; power >= 13; power -= 13) yk_big_multiply_add(big, 1220703125u, 0); // 5^13 is the last below 2^32
    for (; power > 0; power--) yk_big_multiply_add(big, 5, 0);
}

static void shift_left(YkBig *big, int bits)
{
    size_t limbs = (size_t)bits / 32;
    yk_big_multiply_add(big, 1u << (bits % 32), 0);
    if (big->count == 0 || big->count + limbs > YK_BIG_LIMBS) return;
    for (size_t i = big->count; i-- > 0;) big->limb[i + limbs] = big->limb[i];
    for (size_t i = 0; i < limbs; i++) big->limb[i] = 0;
    big->count += limbs;
}

int yk_big_compare(YkBig *decimal, int tens, YkBig *binary, int twos)
{
    // Multiplies by whole factors only: a negative power of ten goes to the other side, and so does the smaller power
    // of two.
    if (tens >= 0)
        multiply_by_five_to(decimal, tens);
    else
        multiply_by_five_to(binary, -tens);
    if (tens >= twos)
        shift_left(decimal, tens - twos);
    else
        shift_left(binary, twos - tens);
    if (decimal->count != binary->count) return decimal->count < binary->count ? -1 : 1;
    for (size_t i = decimal->count; i-- > 0;)
        if (decimal->limb[i] != binary->limb[i]) return decimal->limb[i] < binary->limb[i] ? -1 : 1;
    return 0;
}
