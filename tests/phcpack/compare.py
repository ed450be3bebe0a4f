"""PHCpack as a third solver: pinned trusses as squared distances of their pins, which share nothing with Yoke's polynomials.

usage: compare.py YOKE [all]: trusses of five and seven links, three machines each, or also one of each of nine links. Needs `phc` (package phcpack).

Every link is rigid: its first two pins keep their distance, and each other pin stands at fixed coordinates in the frame of the first
two, a linear condition. Those pins are eliminated; what is left are as many quadratic equations as unknowns. `phc -b` (Verschelde 1999,
"Algorithm 795: PHCpack") finds all their complex solutions by polyhedral homotopies. Their number must be the one that Yoke counts, and
the real ones must be the configurations of `yoke solve --all`, pin by pin.
"""
import json
import os
import random
import re
import subprocess
import sys
import tempfile

# The ground first; how many complex solutions each is known to have.
TRUSSES = [("abc ad be cf def", 6), ("cef egh agi bdh ab cd fi", 14), ("acd cef bfi ghi ab dg eh", 16), ("bfhi cde adg ab cf gh ei", 18)]


def nine_links():
    """The 28 trusses of nine links, as the tests in C have them."""
    with open(os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "configurations", "nine_links.h")) as file:
        return [(words, int(count)) for words, count in re.findall(r'\{"([a-z ]+)", (\d+)\}', file.read())]


def free_count(links):
    """Freedoms by Gruebler's count: pins that n links share are n - 1 joints."""
    pins = "".join(links)
    joints = sum(pins.count(p) - 1 for p in set(pins))
    return 3 * (len(links) - 1) - 2 * joints


class Linear:
    """A point as a linear combination of unknown complex points and a constant: {pin: (re, im)}, its coefficients complex."""

    def __init__(self, terms, constant=0j):
        self.terms, self.constant = {k: v for k, v in terms.items() if v != 0}, constant

    def __add__(self, other):
        terms = dict(self.terms)
        for k, v in other.terms.items():
            terms[k] = terms.get(k, 0) + v
        return Linear(terms, self.constant + other.constant)

    def times(self, factor):
        return Linear({k: factor * v for k, v in self.terms.items()}, factor * self.constant)


def system_of(links, at):
    """Returns unknown pins, all pins as points of them, and the pairs of points whose distances are given."""
    points = {p: Linear({}, at[p]) for p in links[0]}
    pairs = []
    left = links[1:]
    while left:
        # The link with most pins that have points already is next.
        link = max(left, key=lambda l: (sum(p in points for p in l), len(l)))
        left.remove(link)
        known = [p for p in link if p in points]
        rest = [p for p in link if p not in points]
        for p in rest[:max(0, 2 - len(known))]:
            points[p] = Linear({p: 1 + 0j})
            known.append(p)
        a, b = known[0], known[1]
        pairs.append((a, b))
        for p in link:
            if p in (a, b):
                continue
            ratio = (at[p] - at[a]) / (at[b] - at[a])
            place = points[a] + (points[b] + points[a].times(-1)).times(ratio)
            if p in points:
                pairs.append((p, place, None))
            else:
                points[p] = place
    return points, pairs


def real_parts(linear, names):
    """Returns x and y of a point as strings over x_p, y_p."""
    x, y = ["(%.17g)" % linear.constant.real], ["(%.17g)" % linear.constant.imag]
    for p, c in linear.terms.items():
        x += ["(%.17g)*x%s" % (c.real, names[p]), "(%.17g)*y%s" % (-c.imag, names[p])]
        y += ["(%.17g)*x%s" % (c.imag, names[p]), "(%.17g)*y%s" % (c.real, names[p])]
    return "+".join(x), "+".join(y)


def equations_of(links, at):
    points, pairs = system_of(links, at)
    unknown = sorted({p for q in points.values() for p in q.terms})
    names = {p: str(k + 1) for k, p in enumerate(unknown)}
    equations = []
    for pair in pairs:
        if len(pair) == 2:
            a, b = pair
            x, y = real_parts(points[b] + points[a].times(-1), names)
            if not (points[b] + points[a].times(-1)).terms:
                continue
            equations.append("(%s)^2+(%s)^2-(%.17g)" % (x, y, abs(at[b] - at[a]) ** 2))
        else:
            equations += real_parts(points[pair[0]] + pair[1].times(-1), names)
    return unknown, points, equations


def solve(equations):
    """Returns all finite solutions that phc finds, as {variable: complex}."""
    with tempfile.TemporaryDirectory() as folder:
        given, found = os.path.join(folder, "given"), os.path.join(folder, "found")
        with open(given, "w") as file:
            file.write("%d\n%s\n" % (len(equations), "\n".join(e.replace("+-", "-") + ";" for e in equations)))
        subprocess.run(["phc", "-b", "-0", given, found], check=True, stdout=subprocess.DEVNULL, stdin=subprocess.DEVNULL)
        with open(given) as file:
            text = file.read()
    solutions = []
    for block in re.split(r"\nsolution \d+ :", text)[1:]:
        values = {n: complex(float(a), float(b)) for n, a, b in re.findall(r"^ ([xy]\d+) :\s*(\S+)\s+(\S+)", block, re.M)}
        size = max(abs(v) for v in values.values())
        if size < 1e6 and not any(all(abs(values[n] - s[n]) < 1e-7 * (1 + size) for n in values) for s in solutions):
            solutions.append(values)
    return solutions


def model_of(links, at):
    """The same truss as a model file: every link's frame is the world's where the dimensions were read."""
    names = names_of(links)
    lines = ["bodies:"]
    for name, link in zip(names, links):
        lines.append("  %s: {points: {%s}}" % (name, ", ".join("%s: [%.17g, %.17g]" % (p, at[p].real, at[p].imag) for p in link)))
    lines.append("joints:")
    for p in sorted(set("".join(links))):
        holders = [n for n, link in zip(names, links) if p in link]
        for k, other in enumerate(holders[1:]):
            lines.append("  %s%d: {pin: [%s, %s], at: %s}" % (p, k, holders[0], other, p))
    return "\n".join(lines) + "\n"


def yoke_answer(yoke, links, at):
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "truss.yaml")
        with open(path, "w") as file:
            file.write(model_of(links, at))
        run = subprocess.run([yoke, "solve", path, "--all", "--format", "json"], capture_output=True, text=True)
        assert run.returncode == 0, run.stderr
        return json.loads(run.stdout)


def places(solution, points, unknown):
    number = {p: str(k + 1) for k, p in enumerate(unknown)}
    value = {p: complex(solution["x" + number[p]].real, solution["y" + number[p]].real) for p in unknown}
    return {p: q.constant + sum(c * value[k] for k, c in q.terms.items()) for p, q in points.items()}


def names_of(links):
    return ["ground"] + ["L%d" % k for k in range(1, len(links))]


def farthest(configuration, links, where):
    """Returns how far a pin of a configuration is from where it should be, at most."""
    return max(abs(complex(*configuration["points"]["%s.%s" % (name, pin)]["position"]) - where[pin])
               for name, link in zip(names_of(links), links) for pin in link)


def compare(yoke, words, count, seed):
    links, draw = words.split(), random.Random(seed)
    assert free_count(links) == 0, words
    at = {p: complex(draw.uniform(-2, 2), draw.uniform(-2, 2)) for p in sorted(set("".join(links)))}
    unknown, points, equations = equations_of(links, at)
    assert len(equations) == 2 * len(unknown), (words, len(equations), len(unknown))
    solutions = solve(equations)
    answer = yoke_answer(yoke, links, at)
    assert answer["complete"] and answer["reason"] == "counted", answer["because"]
    counted = answer["complex"]["counted"]
    assert len(solutions) == counted and counted == count, (words, len(solutions), counted, count)
    real = [s for s in solutions if max(abs(v.imag) for v in s.values()) < 1e-8]
    assert len(real) == len(answer["configurations"]), (words, len(real), len(answer["configurations"]))
    # Every real solution is one configuration: all pins are where every link has them.
    for solution in real:
        where = places(solution, points, unknown)
        near = [c for c in answer["configurations"] if farthest(c, links, where) < 1e-6]
        assert len(near) == 1, (words, seed)
    return len(solutions), len(real)


def main():
    yoke, machines = sys.argv[1], [(words, count, seed) for words, count in TRUSSES for seed in (1, 2, 3)]
    if sys.argv[2:] == ["all"]:
        machines += [(words, count, 1) for words, count in nine_links()]
    for words, count, seed in machines:
        found = compare(yoke, words, count, seed)
        print("%s, seed %d: %d complex solutions, %d real, the same in Yoke and PHCpack" % (words, seed, *found), flush=True)
    print("%d trusses agree" % len(machines))


if __name__ == "__main__":
    main()
