"""Polynomials of degree 20 from conditions, solved in exact rational arithmetic; writes tests/law/polynomial_cases.h.

Places, values and the places asked for are dyadic, so the doubles of the test are exactly the numbers used here.
"""
import random
from fractions import Fraction as F

DEGREE = 20


def row(at, order, count):
    entries = []
    for k in range(count):
        factor = 1
        for m in range(order):
            factor *= k - m
        entries.append(F(factor) * F(at) ** (k - order) if k >= order else F(0))
    return entries


def solve(matrix, right):
    n = len(right)
    rows = [list(r) + [b] for r, b in zip(matrix, right)]
    for k in range(n):
        pivot = next(i for i in range(k, n) if rows[i][k] != 0)
        rows[k], rows[pivot] = rows[pivot], rows[k]
        rows[k] = [entry / rows[k][k] for entry in rows[k]]
        for i in range(n):
            if i != k and rows[i][k] != 0:
                factor = rows[i][k]
                rows[i] = [a - factor * b for a, b in zip(rows[i], rows[k])]
    return [r[n] for r in rows]


def layouts():
    ends = [(0, m) for m in range(5)] + [(6, m) for m in range(5)]
    yield "ends and a row of points", ends + [(F(k, 2), 0) for k in range(1, 12)]
    yield "values and slopes", [(F(5 * k, 8), m) for k in range(10) for m in range(2)] + [(6, 0)]
    yield "all orders at four places", [(2 * k, m) for k in range(4) for m in range(5)] + [(1, 0)]
    yield "velocities between", ends + [(F(k, 2), 1) for k in range(1, 6)] + [(F(k, 2), 0) for k in range(6, 12)]


def main():
    random.seed(5)
    print("// Written by tools/oracle/law_polynomial.py: polynomials of degree 20 in exact rational arithmetic.")
    print("// clang-format off")
    print("static const PolynomialCase polynomial_cases[] = {")
    for name, places in layouts():
        conditions = [(F(at), m, F(random.randint(-512, 512), 256)) for at, m in places]
        c = solve([row(at, m, DEGREE + 1) for at, m, _ in conditions], [value for _, _, value in conditions])
        print(f"    {{ // {name}\n        {{", end="")
        print(", ".join(f"{{{float(at)!r}, {m}, {float(value)!r}}}" for at, m, value in conditions), end="},\n        {")
        asked = []
        for k in range(8):
            x = F(2 * k + 1, 16) * 6
            d = [sum(a * b for a, b in zip(row(x, m, DEGREE + 1), c)) for m in range(5)]
            asked.append(f"{{{float(x)!r}, {{{', '.join(repr(float(v)) for v in d)}}}}}")
        print(",\n         ".join(asked) + "}},")
    print("};")


main()
