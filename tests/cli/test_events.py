"""Events: those of a sweep beyond the number that it keeps are counted and reported; nothing else is reported as one."""
import math
import os
import re
import unittest

from harness import Case, ROOT, Run

FOUR_BAR = os.path.join(ROOT, "examples", "four-bar.yaml")
KEPT = 10000
FIVE_BAR = """bodies:
  ground: {points: {O: [0, 0], C: [0.2 m, 0]}}
  a: {points: {O: [0, 0], A: [0.12 m, 0]}, mass: 1 kg, inertia: 0.001 kg*m^2}
  b: {points: {A: [0, 0], B: [0.2 m, 0]}, mass: 0.5 kg, inertia: 0.001 kg*m^2}
  c: {points: {B: [0, 0], D: [0.2 m, 0]}, mass: 0.5 kg, inertia: 0.001 kg*m^2}
  d: {points: {C: [0, 0], D: [0.12 m, 0]}, mass: 0.5 kg, inertia: 0.001 kg*m^2}
joints:
  O: {pin: [ground, a], angle: u}
  A: {pin: [a, b]}
  B: {pin: [b, c]}
  D: {pin: [c, d]}
  C: {pin: [ground, d], angle: w}
springs: {s: {along: u, stiffness: 20 N*m/rad, angle: 120 deg}}
drives: {w: 60 deg + 5 deg/s * t}
start: {u: 100 deg}
"""


class Events(Case):
    def sweep(self, turns, *words):
        return self.good("sweep", FOUR_BAR, "--over", "theta2=0:%ddeg" % (360 * turns), "--steps", str(4 * turns), "--of",
                         "theta4,gamma,coupler.P.x,coupler.P.y,coupler.B.x,coupler.B.y", *words)

    def test_those_beyond_are_counted(self):
        """As many as the turns have, each the same."""
        once = self.sweep(1, "--format", "json").json()
        self.assertEqual(once["event_total"], len(once["events"]))
        self.assertNotIn("more events", self.sweep(1).out)
        turns = KEPT // len(once["events"]) + 3
        more = turns * len(once["events"]) - KEPT
        self.assertIn("%d more events were found: the first %d are listed" % (more, KEPT), self.sweep(turns).out)

    def test_turning_back_beside_a_drive_is_no_dead_point(self):
        """The free crank swings on its spring while the other one is driven: its rate has many zeros, none of them a dead point."""
        run = self.good("simulate", self.write("five-bar.yaml", FIVE_BAR), "--to", "0.5s", "--steps", "200", "--of", "u.rate", "--format", "json").json()
        rates = [row[1] for row in run["rows"]]
        self.assertGreater(sum(a * b < 0 for a, b in zip(rates, rates[1:])), 3)
        self.assertEqual([event for event in run["events"] if event.get("kind", event.get("event")) == "dead-point"], [])
        self.assertEqual(run["events"], [])


class NearLimits(Case):
    """A piston that is driven to its dead centre, or nearly, in closed form."""

    def piston(self, stroke):
        return self.write("piston.yaml", """\
bodies:
  ground:  {points: {O: [0, 0]}}
  crank:   {points: {O: [0, 0], A: [30 mm, 0]}, mass: 0.5 kg, inertia: 1e-4 kg*m^2, center: [0, 0]}
  coupler: {points: {A: [0, 0], B: [80 mm, 0]}, mass: 0.2 kg, inertia: 1e-4 kg*m^2, center: [40 mm, 0]}
  piston:  {points: {B: [0, 0]}, mass: 0.3 kg, inertia: 1e-4 kg*m^2}
joints:
  O: {pin: [ground, crank], angle: theta}
  A: {pin: [crank, coupler], angle: phi}
  B: {pin: [coupler, piston]}
  S: {slide: [ground, piston], along: x, from: O, to: B, distance: s}
drives: {s: %s}
start: {theta: 60 deg, phi: -90 deg}
""" % stroke)

    def test_a_drive_that_turns_back_just_before_a_limit_is_followed(self):
        """By so little that the crank is within the root of rounding of its dead point."""
        for off in (1e-3, 1e-5, 1e-8, 1e-10, 1e-13):
            swing = math.pi - 2 - off
            file = self.piston("80 mm + 30 mm * cos(2 rad + %.15f rad * sin(1 rad/s * t))" % swing)
            run = self.good("simulate", file, "--to", "6s", "--steps", "12", "--of", "theta,energy", "--format", "json").json()
            self.assertEqual(len(run["rows"]), 13)
            for t, theta, _ in run["rows"]:
                s = 0.08 + 0.03 * math.cos(2 + swing * math.sin(t))
                self.assertAlmostEqual(theta, math.acos((s * s + 0.03**2 - 0.08**2) / (2 * 0.03 * s)), places=9, msg=(off, t))

    def test_a_motion_ends_at_the_limit_itself(self):
        ends = {"80 mm + 31 mm * cos(1 rad/s * t + 1 rad)": math.acos(-30 / 31) - 1,
                "51 mm + 100 mm/s^2 * t^2": math.sqrt(0.59)}
        for stroke, end in ends.items():
            run = Run("simulate", self.piston(stroke), "--to", "6s", "--steps", "6", "--of", "theta")
            self.assertEqual(run.code, 1)
            found = re.search(r"the motion ends at t = (\S+) s: a limit position: beyond, joint `B` does not close \[E0820\]", run.err)
            self.assertTrue(found, run.err)
            self.assertAlmostEqual(float(found.group(1)), end, delta=1e-9 * max(1, end))


if __name__ == "__main__":
    unittest.main()
