"""Lagrange's equations of three machines, derived once more by SymPy from their geometry written here by hand, equal
what `yoke derive` prints: as text and as JSON, at random points to 40 digits and term by term."""
import os
import random
import sys
import unittest

try:
    import sympy
    from sympy.parsing.sympy_parser import implicit_multiplication, parse_expr, standard_transformations
except ImportError:
    print("skipped: SymPy is not installed")
    sys.exit(77)

from harness import Case, ROOT

SLIDER_CRANK = """\
name: Slider-crank with masses
parameters: {r: 0.1, l: 0.4, rc: 0.03, lc: 0.15, e: 0.02, m1: 1, m2: 2, m3: 3, I1: 0.1, I2: 0.2, g: 9.81, tau: 5, P: 7}
gravity: [0, -g]
bodies:
  ground: {points: {O: [0, 0]}}
  crank:  {points: {O: [0, 0], A: [r, 0]}, mass: m1, center: [rc, e], inertia: I1}
  rod:    {points: {A: [0, 0], B: [l, 0]}, mass: m2, center: [lc, 0], inertia: I2}
  piston: {points: {B: [0, 0]}, mass: m3}
joints:
  O: {pin: [ground, crank], angle: theta}
  A: {pin: [crank, rod], angle: psi}
  B: {pin: [rod, piston]}
  S: {slide: [ground, piston], along: x, distance: s}
efforts: {theta: tau, s: -P}
start: {theta: 40 deg, psi: -50 deg, s: 0.45, theta.rate: 1}
"""

FOUR_BAR = """\
name: Four-bar with masses
parameters: {a: 0.1, b: 0.4, c: 0.3, d: 0.35, ac: 0.04, bc: 0.2, be: 0.1, cc: 0.12, m1: 1, m2: 2, m3: 3, I1: 0.1, I2: 0.2, I3: 0.3, g: 9.81, k: 4, z: 0.6}
gravity: [0, -g]
bodies:
  ground:  {points: {O: [0, 0], C: [d, 0]}}
  crank:   {points: {O: [0, 0], A: [a, 0]}, mass: m1, center: [ac, 0], inertia: I1}
  coupler: {points: {A: [0, 0], B: [b, 0]}, mass: m2, center: [bc, be], inertia: I2}
  rocker:  {points: {C: [0, 0], B: [c, 0]}, mass: m3, center: [cc, 0], inertia: I3}
joints:
  O: {pin: [ground, crank], angle: q1}
  A: {pin: [crank, coupler], angle: q2}
  C: {pin: [ground, rocker], angle: q3}
  B: {pin: [coupler, rocker]}
springs: {K: {along: q3, stiffness: k, damping: z}}
start: {q1: 60 deg, q2: -20 deg, q3: 90 deg, q1.rate: 1}
"""

t = sympy.Symbol("t")


class Machine:
    """Coordinates as functions of time; names as the command writes them."""

    def __init__(self, coordinates, parameters):
        self.names = coordinates.split()
        self.q = [sympy.Function(name)(t) for name in self.names]
        self.p = {name: sympy.Symbol(name) for name in parameters.split()}
        self.plain = {}
        for name, q in zip(self.names, self.q):
            for order, ending in enumerate(("", "_d", "_dd")):
                self.plain[q.diff(t, order)] = sympy.Symbol(name + ending)

    def flat(self, expression):
        """Functions of time as symbols; the highest derivatives first."""
        for old in sorted(self.plain, key=lambda a: -len(str(a))):
            expression = expression.subs(old, self.plain[old])
        return expression

    def lagrange(self, kinetic, potential, loss, forces):
        """d/dt dL/dq' - dL/dq + dD/dq' - Q."""
        left = []
        for q, force in zip(self.q, forces):
            lagrangian = kinetic - potential
            left.append(self.flat(lagrangian.diff(q.diff(t)).diff(t) - lagrangian.diff(q) + loss.diff(q.diff(t)) - force))
        return left

    def read(self, text):
        """A side of an equation as the command prints it."""
        text = text.replace("''", "_dd").replace("'", "_d").replace("^", "**")
        names = dict(self.p, **{str(symbol): symbol for symbol in self.plain.values()})
        names.update({"lambda%d" % k: sympy.Symbol("lambda%d" % k) for k in range(1, 9)})
        return parse_expr(text, names, standard_transformations + (implicit_multiplication,))


def turning(body):
    """1/2 m v^2 + 1/2 I w^2 of (mass, inertia, centre, angle)."""
    mass, inertia, (x, y), angle = body
    return mass * (x.diff(t) ** 2 + y.diff(t) ** 2) / 2 + inertia * sympy.diff(angle, t) ** 2 / 2


def at(start, angle, x, y=0):
    return (start[0] + x * sympy.cos(angle) - y * sympy.sin(angle), start[1] + x * sympy.sin(angle) + y * sympy.cos(angle))


def double_pendulum():
    m = Machine("theta1 theta2", "m1 m2 l1 lc1 lc2 I1 I2 g tau1 tau2")
    p, (q1, q2) = m.p, m.q
    down = -sympy.pi / 2  # angles count from the vertical
    elbow = at((0, 0), q1 + down, p["l1"])
    bodies = [(p["m1"], p["I1"], at((0, 0), q1 + down, p["lc1"]), q1),
              (p["m2"], p["I2"], at(elbow, q1 + q2 + down, p["lc2"]), q1 + q2)]
    potential = sum(p["g"] * mass * centre[1] for mass, _, centre, _ in bodies)
    equations = m.lagrange(sum(map(turning, bodies)), potential, sympy.Integer(0), [p["tau1"], p["tau2"]])
    return m, equations, []


def slider_crank():
    m = Machine("theta psi s", "r l rc lc e m1 m2 m3 I1 I2 g tau P")
    p, (theta, psi, s) = m.p, m.q
    pin = at((0, 0), theta, p["r"])
    bodies = [(p["m1"], p["I1"], at((0, 0), theta, p["rc"], p["e"]), theta),
              (p["m2"], p["I2"], at(pin, theta + psi, p["lc"]), theta + psi), (p["m3"], 0, (s, sympy.Integer(0)), sympy.Integer(0))]
    potential = sum(p["g"] * mass * centre[1] for mass, _, centre, _ in bodies)
    end = at(pin, theta + psi, p["l"])
    equations = m.lagrange(sum(map(turning, bodies)), potential, sympy.Integer(0), [p["tau"], sympy.Integer(0), -p["P"]])
    return m, equations, [end[0] - s, end[1]]


def four_bar():
    m = Machine("q1 q2 q3", "a b c d ac bc be cc m1 m2 m3 I1 I2 I3 g k z")
    p, (q1, q2, q3) = m.p, m.q
    pin = at((0, 0), q1, p["a"])
    bodies = [(p["m1"], p["I1"], at((0, 0), q1, p["ac"]), q1), (p["m2"], p["I2"], at(pin, q1 + q2, p["bc"], p["be"]), q1 + q2),
              (p["m3"], p["I3"], at((p["d"], 0), q3, p["cc"]), q3)]
    potential = sum(p["g"] * mass * centre[1] for mass, _, centre, _ in bodies) + p["k"] * q3 ** 2 / 2
    end, other = at(pin, q1 + q2, p["b"]), at((p["d"], 0), q3, p["c"])
    loss = p["z"] * q3.diff(t) ** 2 / 2
    equations = m.lagrange(sum(map(turning, bodies)), potential, loss, [sympy.Integer(0)] * 3)
    return m, equations, [end[0] - other[0], end[1] - other[1]]


def reduced(expression):
    """The same with single angles in sines and cosines, squares of sines replaced: zero only where it is zero."""
    expression = sympy.expand(sympy.expand_trig(sympy.expand(expression)))
    for angle in sorted({part.args[0] for part in expression.atoms(sympy.sin, sympy.cos)}, key=str):
        sine, cosine = sympy.Dummy("S"), sympy.Dummy("C")
        expression = expression.subs({sympy.sin(angle): sine, sympy.cos(angle): cosine})
        expression = sympy.rem(expression, sine**2 + cosine**2 - 1, sine)
    return sympy.expand(expression)


class Sympy(Case):
    def is_zero(self, expression, where):
        """At random points with 40 digits, and term by term."""
        symbols = sorted(expression.free_symbols, key=str)
        rng = random.Random(5)
        for _ in range(3):
            point = {symbol: sympy.Rational(rng.randint(-999, 999), 311) for symbol in symbols}
            self.assertLess(abs(sympy.N(expression.subs(point), 40)), 1e-25, where)
        self.assertEqual(reduced(expression), 0, where)

    def close_up(self, printed, derived, loops, m):
        """Multipliers may count either way, and the loop's rows may be in any order: but the same in all equations."""
        lambdas = [sympy.Symbol("lambda%d" % (k + 1)) for k in range(len(loops))]
        for left, own, name in zip(printed, derived, m.names):
            self.is_zero(left.subs({symbol: 0 for symbol in lambdas}) - own, name)
        for symbol in lambdas:
            ways = []
            for row in loops:
                for sign in (1, -1):
                    gaps = [sympy.diff(left, symbol) - sign * m.flat(row.diff(q)) for left, q in zip(printed, m.q)]
                    ways.append(all(reduced(gap) == 0 for gap in gaps))
            self.assertEqual(ways.count(True), 1, symbol)

    def compare(self, file, machine):
        m, derived, loops = machine
        answer = self.good("derive", file, "--what", "lagrange", "--format", "json").json()
        items = [item for item in answer["sections"][0]["items"] if item["kind"] == "formula" and item.get("remark") in m.names]
        text = self.good("derive", file, "--what", "lagrange").out
        printed = []
        for item, name in zip(items[:len(m.names)], m.names):
            self.assertEqual(item["remark"], name)
            self.assertIn("  %s:  %s\n" % (name, item["text"]), text)
            left, right = item["text"].split(" = ")
            printed.append(m.read(left) - m.read(right))
        self.assertEqual(len(printed), len(m.names))
        self.close_up(printed, derived, loops, m)
        matrices = {item["text"].split(" = ")[0]: item["matrices"][0]["entries"] for item in answer["sections"][0]["items"] if item.get("matrices")}
        for i, own in enumerate(derived):
            for k, name in enumerate(m.names):
                self.is_zero(m.read(str(matrices["M"][i][k])) - sympy.diff(own, sympy.Symbol(name + "_dd")), (i, k))

    def test_double_pendulum(self):
        self.compare(os.path.join(ROOT, "examples", "double-pendulum.yaml"), double_pendulum())

    def test_slider_crank(self):
        self.compare(self.write("slider-crank.yaml", SLIDER_CRANK), slider_crank())

    def test_four_bar(self):
        self.compare(self.write("four-bar-masses.yaml", FOUR_BAR), four_bar())


if __name__ == "__main__":
    unittest.main()
