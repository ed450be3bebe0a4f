"""Five-bars against circles: with two inputs, and with a mesh between the cranks, moved through turns by every verb.

The reference is the intersection of two circles on the side on which the machine was put together, followed here in small steps.
Where the circles part on the way, a machine with one input is refused; one with two may find a way round, on the same side."""
import cmath
import math
import os
import random
import re
import unittest

from harness import Case, Run

FULL = os.environ.get("YOKE_FULL") == "1"
FEW = "YOKE_FEW" in os.environ
TURN = 2 * math.pi
NAMES = ("theta1", "theta2", "phi1", "phi2")


class FiveBar:
    """Lengths, a start and a side; `ratio` is the second crank's turn for one of the first, or None for two inputs."""

    def __init__(self, rng, geared):
        while True:
            self.w, self.a, self.b, self.c, self.d = (rng.uniform(*span) for span in ((1, 3), (0.3, 1.2), (0.3, 1.2), (1, 3), (1, 3)))
            self.teeth = (rng.randint(15, 40), rng.randint(15, 40))
            self.ratio = -self.teeth[0] / self.teeth[1] if geared else None
            self.start = (rng.uniform(-3, 3), rng.uniform(-3, 3))
            self.side = rng.choice((1, -1))
            if self.margin(*self.start) > 0.05:
                self.angles = self.phis(*self.start, None)
                return

    def ends(self, one, two):
        return self.a * cmath.exp(1j * one), self.w + self.b * cmath.exp(1j * two)

    def margin(self, one, two):
        """How far the circles are from touching, over their radii: negative where they do not meet."""
        first, second = self.ends(one, two)
        apart = abs(second - first)
        return min(self.c + self.d - apart, apart - abs(self.c - self.d)) / (self.c + self.d)

    def phis(self, one, two, near):
        first, second = self.ends(one, two)
        apart = abs(second - first)
        along = (self.c ** 2 - self.d ** 2 + apart ** 2) / (2 * apart)
        tip = first + (second - first) / apart * complex(along, self.side * math.sqrt(self.c ** 2 - along ** 2))
        found = [cmath.phase(tip - first) - one, cmath.phase(tip - second) - two]
        if near:
            found = [n + math.remainder(f - n, TURN) for f, n in zip(found, near)]
        return found

    def second(self, one):
        return self.start[1] + self.ratio * (one - self.start[0])

    def move(self, one, two):
        """All four angles after a straight move of the inputs, and the smallest margin on the way."""
        steps = max(200, int(400 * max(abs(one - self.start[0]), abs(two - self.start[1]))))
        angles, least = self.angles, math.inf
        for k in range(1, steps + 1):
            here = [s + (e - s) * k / steps for s, e in zip(self.start, (one, two))]
            least = min(least, self.margin(*here))
            if least > 0:
                angles = self.phis(*here, angles)
        return (one, two, *angles) if least > 0 else None, least

    def text(self, start=None, drives=None):
        one, two, phi1, phi2 = start or (*self.start, *self.angles)
        gears = "gears: {g: {mesh: [left, right], teeth: [%d, %d]}}\n" % self.teeth if self.ratio else ""
        drives = drives or ("{theta1: %r}" % one if self.ratio else "{theta1: %r, theta2: %r}" % (one, two))
        return """bodies:
  ground: {points: {L: [0, 0], R: [%r, 0]}}
  left:   {points: {L: [0, 0], A: [%r, 0]}, mass: 1, inertia: 0.1}
  right:  {points: {R: [0, 0], B: [%r, 0]}, mass: 1, inertia: 0.1}
  one:    {points: {A: [0, 0], P: [%r, 0]}, mass: 1, inertia: 0.1}
  two:    {points: {B: [0, 0], P: [%r, 0]}, mass: 1, inertia: 0.1}
joints:
  L: {pin: [ground, left], angle: theta1}
  R: {pin: [ground, right], angle: theta2}
  A: {pin: [left, one], angle: phi1}
  B: {pin: [right, two], angle: phi2}
  P: {pin: [one, two]}
%sdrives: %s
start: {theta2: %r, phi1: %r, phi2: %r}
""" % (self.w, self.a, self.b, self.c, self.d, gears, drives, two, phi1, phi2)


class FiveBars(Case):
    def setUp(self):
        super().setUp()
        self.reached = self.refused = 0

    def close(self, got, want, what):
        for name, value in zip(NAMES, want):
            self.assertLess(abs(got[name] - value), 1e-8, "%s: %s is %r, not %r" % (what, name, got[name], value))

    def solved(self, run):
        return {name: c["position"] for name, c in run.json()["configurations"][0]["coordinates"].items()}

    def try_move(self, bar, file, goal, words, what):
        want, least = bar.move(*goal)
        run = Run("solve", file, *words, "--format", "json", "--quiet")
        if abs(least) < 1e-3:  # too close to call
            return None
        if want:
            self.assertEqual(run.code, 0, "%s: %s" % (what, run.err))
            self.close(self.solved(run), want, what)
            self.reached += 1
        elif bar.ratio:
            self.assertEqual(run.code, 1, "%s: the circles part on the way" % what)
            self.refused += 1
        else:
            self.assertIn(run.code, (0, 1), what)
            if run.code == 0:
                got = self.solved(run)
                for name, value in zip(NAMES[2:], bar.phis(*goal, None)):
                    self.assertLess(abs(math.remainder(got[name] - value, TURN)), 1e-8, what + " by a way round: " + name)
        return want

    def draw_alike(self, bar, file, want, words, what):
        """The picture after the move is that of the machine put together there."""
        there = self.write("there.yaml", bar.text(want))
        pictures = [Run("draw", name, *more, "--quiet") for name, more in ((file, words), (there, ()))]
        numbers = []
        for picture in pictures:
            self.assertEqual(picture.code, 0, what + picture.err)
            numbers.append([float(n) for n in re.findall(r"-?\d+(?:\.\d+)?", picture.out)])
        self.assertEqual(*map(len, numbers), what)
        self.assertLess(max(abs(a - b) for a, b in zip(*numbers)), 0.02, what)  # two decimals are written

    def sweep(self, bar, file, end, what):
        rows = Run("sweep", file, "--over", "theta1=%rrad:%rrad" % (bar.start[0], end), "--steps", "7", "--of", ",".join(NAMES), "--format",
                   "csv", "--quiet").csv()[1]
        for row in rows:
            want, least = bar.move(row[0], bar.second(row[0]) if bar.ratio else bar.start[1])
            if abs(least) > 1e-3:
                self.assertIsNotNone(want, what)
                self.close(dict(zip(NAMES, row[1:])), want, what + ", swept")
                self.reached += 1

    def simulate(self, bar, rng, what):
        """Driven at constant speeds from the start: every row of a simulation, as far as the circles meet."""
        speeds = [rng.uniform(-4, 4), rng.uniform(-4, 4)]
        drives = ["theta%d: %r + %r rad/s * t" % (k + 1, bar.start[k], speeds[k]) for k in range(1 if bar.ratio else 2)]
        file = self.write("driven.yaml", bar.text(None, "{%s}" % ", ".join(drives)))
        run = Run("simulate", file, "--to", "2s", "--steps", "8", "--of", ",".join(NAMES), "--format", "csv", "--quiet")
        self.assertIn(run.code, (0, 1), what + run.err)
        for row in run.csv()[1]:
            one = bar.start[0] + speeds[0] * row[0]
            want, least = bar.move(one, bar.second(one) if bar.ratio else bar.start[1] + speeds[1] * row[0])
            if least > 1e-3:
                self.close(dict(zip(NAMES, row[1:])), want, what + ", simulated to %r" % row[0])
                self.reached += 1
            elif least < -1e-3:
                self.fail("%s: simulated to %r, where the circles have parted" % (what, row[0]))

    def try_machine(self, seed, geared):
        rng = random.Random(seed)
        bar = FiveBar(rng, geared)
        file = self.write("five-bar.yaml", bar.text())
        for k in range(3):
            what = "seed %d, %s, move %d" % (seed, "geared" if geared else "two inputs", k)
            one = bar.start[0] + rng.choice((0.3, 1, 3)) * rng.uniform(-TURN, TURN)
            two = bar.second(one) if geared else bar.start[1] + rng.uniform(-TURN, TURN)
            words = ["--at", "theta1=%rrad" % one] + ([] if geared else ["--at", "theta2=%rrad" % two])
            want = self.try_move(bar, file, (one, two), words, what)
            if want and k == 0:
                self.draw_alike(bar, file, want, words, what)
        self.sweep(bar, file, bar.start[0] + rng.choice((1, -1)) * 2 * TURN, what)
        self.simulate(bar, rng, what)

    def test_two_inputs(self):
        for seed in range(300 if FULL else 4 if FEW else 15):
            self.try_machine(seed, False)
        self.assertGreater(self.reached, 30 if FEW else 100)

    def test_meshed_cranks(self):
        for seed in range(300 if FULL else 4 if FEW else 15):
            self.try_machine(1000 + seed, True)
        self.assertGreater(self.reached, 30 if FEW else 100)
        self.assertGreater(self.refused, 0 if FEW else 5)


if __name__ == "__main__":
    unittest.main()
