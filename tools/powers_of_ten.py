#!/usr/bin/env python3
"""Writes src/base/numbers/powers_of_ten.c: what 10^k cut to 128 bits is made from. Checks what src/base/numbers relies on.

Usage: python3 tools/powers_of_ten.py > src/base/numbers/powers_of_ten.c
"""
from fractions import Fraction

FIRST, LAST = -342, 341
STEP = 27  # as YK_TEN_STEP
STEPS = range(FIRST // STEP, LAST // STEP + 1)


def floor_log2(x):
    """floor(log2(x)) of a positive fraction, exactly."""
    e = x.numerator.bit_length() - x.denominator.bit_length()
    return e if x >= Fraction(2) ** e else e - 1


def entry(k, bits):
    """(integer of so many bits, is it exact): 10^k = (integer + f) * 2^(floor_log2(10^k) - bits + 1), 0 <= f < 1."""
    scaled = Fraction(10) ** k / Fraction(2) ** (floor_log2(Fraction(10) ** k) - bits + 1)
    cut = scaled.numerator // scaled.denominator
    assert 1 << bits - 1 <= cut < 1 << bits
    return cut, scaled == cut


def product(k):
    """What yk_power_of_ten() makes of 192 bits of a step and 64 bits of a small power, both cut."""
    cut = entry(k // STEP * STEP, 192)[0] * entry(k % STEP, 64)[0]
    return cut >> cut.bit_length() - 128


def check():
    for k in range(FIRST, LAST + 1):
        cut, exact = entry(k, 128)
        assert product(k) == cut, k
        assert exact == (0 <= k <= 55), k
        assert exact or cut % 2**64 != 2**64 - 1, k  # adding one to round up never carries
    for e in range(-1233, 1234):
        assert (e * 1741647) >> 19 == floor_log2(Fraction(10) ** e), e
    power = Fraction(1, 2**1650)
    ten = -497  # floor(log10(2^-1650))
    for e in range(-1650, 1651):
        while Fraction(10) ** (ten + 1) <= power:
            ten += 1
        assert Fraction(10) ** ten <= power
        assert (e * 1262611) >> 22 == ten, e
        power *= 2


check()
print("// Written by tools/powers_of_ten.py; do not edit.")
print('#include "base/numbers/powers_of_ten.h"')
print()
print("// clang-format off")
print("const YkTenStep yk_ten_steps[] = {")
for k in STEPS:
    value = entry(k * STEP, 192)[0]
    print("    {0x%016x, 0x%016x, 0x%016x}, // 10^%d" % (value >> 128, value >> 64 & 2**64 - 1, value & 2**64 - 1, k * STEP))
print("};")
print("const uint64_t yk_small_tens[YK_TEN_STEP] = {")
for k in range(STEP):
    print("    0x%016x, // 10^%d" % (entry(k, 64)[0], k))
print("};")
