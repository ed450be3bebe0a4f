"""Entries of a file that a pose ignores are reported: stops outside of `simulate`, values of `start:` under a drive."""
import math
import unittest

from harness import Case

CRANK = """\
name: Crank with a stop
bodies:
  ground:  {points: {O: [0, 0]}}
  crank:   {points: {O: [0, 0], A: [30 mm, 0]}}
  coupler: {points: {A: [0, 0], B: [80 mm, 0]}}
  piston:  {points: {B: [0, 0]}}
joints:
  O: {pin: [ground, crank], angle: theta}
  A: {pin: [crank, coupler]}
  B: {pin: [coupler, piston]}
  S: {slide: [ground, piston], along: x, from: O, to: B, distance: s}
stops: {s: [60 mm, 100 mm]}
drives: {theta: 10 deg + 90 deg/s * t}
start: {theta: 10 deg, s: 100 mm}
"""


def stroke(theta):
    return 0.03 * math.cos(theta) + math.sqrt(0.08**2 - (0.03 * math.sin(theta))**2)


class Stops(Case):
    def test_a_pose_beyond_a_stop_is_told(self):
        file = self.write("crank.yaml", CRANK)
        pose = self.good("solve", file, "--format", "json")
        (passed,) = pose.json()["stops_passed"]
        self.assertAlmostEqual(passed.pop("value"), stroke(math.radians(10)), places=14)
        self.assertEqual(passed, {"coordinate": "s", "from": 0.06, "to": 0.1, "poses": 1})
        self.assertRegex(pose.err, r"crank.yaml:12:9: warning: `s` is at 0\.1093\d* m, beyond its upper stop at 0\.1 m \[W0623\]")
        low = self.good("solve", file, "--at", "theta=180deg")
        self.assertIn("`s` is at 0.05 m, beyond its lower stop at 0.06 m [W0623]", low.err)
        inside = self.good("solve", file, "--at", "theta=90deg", "--format", "json")
        self.assertNotIn("stops_passed", inside.json())
        self.assertNotIn("W0623", inside.err)

    def test_rows_beyond_a_stop_are_counted(self):
        """The piston's place is known in closed form: so are the rows."""
        sweep = self.good("sweep", self.write("crank.yaml", CRANK), "--over", "theta=0:180deg", "--steps", "36", "--format", "json")
        values = [stroke(math.radians(5 * k)) for k in range(37)]
        beyond = [s > 0.1 or s < 0.06 for s in values]
        (passed,) = sweep.json()["stops_passed"]
        self.assertEqual((passed["poses"], passed["at"]), (sum(beyond), 0))
        self.assertTrue(any(s < 0.06 for s in values) and 0 < sum(beyond) < 37)
        self.assertIn("first at theta = 0 rad (0 deg), in %d poses [W0623]" % sum(beyond), sweep.err)


class Starts(Case):
    def test_a_value_that_the_drive_overrides_is_told(self):
        same = self.write("same.yaml", CRANK)
        self.assertNotIn("W0617", self.good("solve", same).err)
        for value in ("370 deg", "0.1745"): # a turn more is the same pose; a few digits are
            self.assertNotIn("W0617", self.good("check", self.write("near.yaml", CRANK.replace("{theta: 10 deg,", "{theta: %s," % value))).err)
        other = self.write("other.yaml", CRANK.replace("{theta: 10 deg,", "{theta: 40 deg,"))
        words = r"other.yaml:14:9: warning: `theta` is driven, so its value here, .*40 deg\), is not used: at t = 0 its drive has theta = .*10 deg\) \[W0617\]"
        for verb in (("check",), ("solve",), ("sweep", "--over", "t=0:1s"), ("simulate", "--to", "0.1s")):
            if verb[0] != "simulate":
                self.assertRegex(self.good(verb[0], other, *verb[1:]).err, words)
        self.assertEqual(self.good("solve", other).out.replace("other", "same"), self.good("solve", same).out)

    def test_a_rate_that_the_drive_overrides_is_told(self):
        def file(rate):
            return self.write("rate.yaml", CRANK.replace("start: {", "start: {theta.rate: %s, " % rate))
        self.assertNotIn("W0617", self.good("solve", file("90 deg/s")).err)
        self.assertIn("its drive has theta.rate = ", self.good("solve", file("80 deg/s")).err)


if __name__ == "__main__":
    unittest.main()
