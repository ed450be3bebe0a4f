#!/usr/bin/env python3
"""Writes src/base/numbers/powers_of_ten.c: 10^k cut to 128 bits, and checks what src/base/numbers relies on.

Usage: python3 tools/powers_of_ten.py > src/base/numbers/powers_of_ten.c
"""
from fractions import Fraction

FIRST, LAST = -342, 341


def floor_log2(x):
    """floor(log2(x)) of a positive fraction, exactly."""
    e = x.numerator.bit_length() - x.denominator.bit_length()
    return e if x >= Fraction(2) ** e else e - 1


def entry(k):
    """(128-bit integer, is it exact): 10^k = (integer + f) * 2^(floor_log2(10^k) - 127), 0 <= f < 1."""
    scaled = Fraction(10) ** k / Fraction(2) ** (floor_log2(Fraction(10) ** k) - 127)
    cut = scaled.numerator // scaled.denominator
    assert 1 << 127 <= cut < 1 << 128
    return cut, scaled == cut


def check():
    for k in range(FIRST, LAST + 1):
        cut, exact = entry(k)
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
print("const YkWide yk_powers_of_ten[YK_TEN_MAX - YK_TEN_MIN + 1] = {")
for k in range(FIRST, LAST + 1):
    value = entry(k)[0]
    print("    {0x%016x, 0x%016x}, // 10^%d" % (value >> 64, value % 2**64, k))
print("};")
