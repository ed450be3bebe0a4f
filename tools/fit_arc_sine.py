#!/usr/bin/python3
# Fits the polynomial of src/elementary/arc.h that turns a sine into its angle: asin(s) = s + s t P(t), t = s^2, for
# |s| <= sin(pi/8). P interpolates at Chebyshev's points, which is minimax to a few per cent here. Needs python3-mpmath.
import sys
from mpmath import mp, mpf, asin, sqrt, sin, pi, cos, matrix, lu_solve

mp.dps = 60
TERMS = int(sys.argv[1]) if len(sys.argv) > 1 else 10
END = sin(pi / 8) ** 2 * mpf("1.0001")  # a little slack: the vectors are units to rounding only


def wanted(t):
    return (asin(sqrt(t)) / sqrt(t) - 1) / t


def value(coefficients, t):
    total = mpf(0)
    for c in reversed(coefficients):
        total = total * t + c
    return total


nodes = [END / 2 * (1 - cos(pi * (2 * k + 1) / (2 * TERMS))) for k in range(TERMS)]
rows = matrix(TERMS, TERMS)
for i, t in enumerate(nodes):
    for j in range(TERMS):
        rows[i, j] = t**j
fit = [mpf(float(c)) for c in lu_solve(rows, matrix([wanted(t) for t in nodes]))]
worst = max(abs(t * (value(fit, t) - wanted(t))) for t in (END * k / 2000 for k in range(1, 2001)))
for c in fit:
    print(float(c).hex(), repr(float(c)))
print("largest relative error of asin: %s = 2^%s" % (mp.nstr(worst, 3), mp.nstr(mp.log(worst, 2), 4)))
