"""Events: those of a sweep beyond what it keeps are counted, and told; what is none is not."""
import os
import unittest

from harness import Case, ROOT

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


if __name__ == "__main__":
    unittest.main()
