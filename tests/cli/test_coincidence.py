"""A machine that passes a coincidence, against its closed form: where the slot's pin comes to the pivot of the lever, any
angle of the lever would close, and the machine keeps the one that it comes with."""
import math
import os
import random
import re
import unittest

from harness import ROOT, Case, Run

FULL = "YOKE_FULL" in os.environ
FLIP = """\
bodies:
  ground: {points: {O: [0, 0], C: [1, 0]}}
  crank:  {points: {O: [0, 0], A: [1, 0]}, mass: 1, inertia: 1}
  lever:  {points: {C: [0, 0], E: [2, 0]}, mass: 1, inertia: 1}
joints:
  O: {pin: [ground, crank], angle: th}
  C: {pin: [ground, lever], angle: ps}
  A: {pin-slot: [lever, crank], along: x, from: C, at: A}
start: {th: 40 deg, ps: 110 deg, th.rate: -1}
"""


def lever(th):
    """The lever's angle and its end's place: a base of two equal sides, so ps = 90 deg + th/2."""
    return math.pi / 2 + th / 2, 1 - 2 * math.sin(th / 2), 2 * math.cos(th / 2)


class DerivedNumbers(Case):
    """Beside a formula stands the number that it has at the pose: the engine's own, or none where the formula is 0/0."""

    def numbers(self, file, at):
        text = self.good("derive", file, "--numbers", "--what", "velocity,acceleration", "--at", at).out
        found = re.findall(r"^  (theta[34]'+) = .* = (\S+)$", text, re.M)
        self.assertIn("theta4'' = ", text)
        return [(name, float(value)) for name, value in found]

    def test_a_quotient_that_is_0_over_0_has_no_number(self):
        file = os.path.join(ROOT, "examples", "parallelogram.yaml")
        counts = {}
        for at in ("theta2=0", "theta2=180deg", "theta2=180.0001deg", "theta2=179.99deg", "theta2=1e-7deg", "theta2=40deg", "theta2=-1deg"):
            pose = self.good("solve", file, "--at", at, "--format", "json").json()["configurations"][0]["coordinates"]
            numbers = self.numbers(file, at)
            counts[at] = len(numbers)
            for name, value in numbers:
                key = "acceleration" if name.endswith("''") else "velocity"
                should = pose[name.rstrip("'")][key]
                self.assertLessEqual(abs(value - should), 1e-5 * max(1, abs(should)), (at, name))
        self.assertEqual(counts["theta2=180deg"], 0)
        self.assertEqual(counts["theta2=40deg"], 4)
        self.assertEqual(counts["theta2=-1deg"], 4)


class Coincidence(Case):
    def setUp(self):
        super().setUp()
        self.file = self.write("flip.yaml", FLIP)

    def close(self, got, wanted, tolerance, what):
        for value, want in zip(got, wanted):
            self.assertIsNotNone(value, what)
            self.assertLessEqual(abs(value - want), tolerance, what)

    def place(self, answer):
        pose = answer["configurations"][0]
        return pose["coordinates"]["ps"]["position"], *pose["points"]["lever.E"]["position"]

    def test_solve_comes_to_every_pose(self):
        for degrees in (40, 1, 1e-3, 1e-6, 1e-9, 1e-14, -1e-14, -1e-9, -1e-6, -1e-3, -1, -40, -170, 170):
            run = self.good("solve", self.file, "--at", "th=%rdeg" % degrees, "--format", "json")
            answer, th = run.json(), math.radians(degrees)
            self.close(self.place(answer), lever(th), 1e-8, (degrees, run.out))
            rates = answer["configurations"][0]["coordinates"]["ps"]
            if answer["status"] != "singular":  # rates are right where they are told
                self.close((rates["velocity"],), (-0.5,), 1e-6, degrees)
            else:
                self.assertIsNone(rates["velocity"])
            if answer["status"] != "ok":
                self.assertLess(abs(degrees), 2e-3)

    def test_at_the_coincidence_velocities_are_limits(self):
        run = self.good("solve", self.file, "--at", "th=0deg", "--format", "json")
        answer = run.json()
        self.assertEqual(answer["status"], "change-point")
        self.close(self.place(answer), lever(0), 1e-8, run.out)
        ps = answer["configurations"][0]["coordinates"]["ps"]
        self.close((ps["velocity"],), (-0.5,), 1e-9, run.out)
        self.assertIsNone(ps["acceleration"])  # the forces would tell it, and they have no value at this pose

    def test_a_sweep_passes_it(self):
        rng = random.Random(7)
        for k in range(300 if FULL else 16):
            ends = rng.choice([(40, -40), (rng.randint(1, 80), -rng.randint(1, 80)), (rng.uniform(1, 80), -rng.uniform(1, 80))])
            start, end = ends if k % 2 else ends[::-1]
            steps = rng.randint(1, 40)
            what = (start, end, steps)
            run = self.good("sweep", self.file, "--over", "th=%r:%rdeg" % (start, end), "--steps", str(steps), "--of",
                            "ps,lever.E.x,lever.E.y,ps.rate", "--format", "json")
            answer = run.json()
            self.assertEqual((len(answer["rows"]), answer["status"]), (steps + 1, "ok"), what)
            for th, *values, rate in answer["rows"]:
                self.close(values + [rate], lever(th) + (-0.5,), 1e-7, what)
            self.assertEqual(sorted(e["kind"] for e in answer["events"]), ["change-point", "maximum"], what)
            for event in answer["events"]:
                self.assertLess(abs(event["at"]), 1e-6, what)
                self.close([event["values"][name] for name in ("ps", "lever.E.x", "lever.E.y")], lever(event["at"]), 1e-7, what)
                if event["kind"] == "maximum":
                    self.assertEqual(event["column"], "lever.E.y")
                    self.assertAlmostEqual(event["value"], 2, delta=1e-9)

    def test_check_tells_freedom_and_the_coincidence_at_the_start(self):
        inside = self.write("inside.yaml", FLIP.replace("th: 40 deg, ps: 110 deg", "th: 0, ps: 90 deg"))
        for file, status, notes in ((self.file, "ok", 0), (inside, "singular", 1)):
            run = self.good("check", file, "--format", "json")
            answer = run.json()
            self.assertEqual((answer["freedom"], answer["degrees"]["rank"], answer["degrees"]["redundant"]), (1, 1, 0))
            self.assertEqual(answer["status"], status)
            self.assertEqual(run.err.count("[W0603]"), notes)

    def test_put_together_in_it_the_machine_leaves_it_smoothly(self):
        file = self.write("in.yaml", FLIP.replace("th: 40 deg, ps: 110 deg", "th: 0, ps: 90 deg"))
        for degrees in (10, -10, 100):
            run = Run("solve", file, "--at", "th=%rdeg" % degrees, "--format", "json")
            self.assertIn("[W0615]", run.err)
            pose = self.place(run.json())
            if degrees > 0:  # A+, as the note says; the other way the lever may be either
                self.close(pose, lever(math.radians(degrees)), 1e-8, degrees)

    def test_let_go_it_coasts_through(self):
        answer = self.good("simulate", self.file, "--to", "1.4s", "--steps", "28", "--of", "th,ps,lever.E.x,lever.E.y", "--format",
                           "json").json()
        crossed = 0
        for _, th, *values in answer["rows"]:
            self.close(values, lever(th), 1e-6, th)
            crossed += th < 0
        self.assertGreater(crossed, 5)


if __name__ == "__main__":
    unittest.main()
