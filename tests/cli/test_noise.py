"""Rounding noise is 0 in the tables for people and exact in JSON; true values are shown, however small."""
import csv
import math
import re
import unittest

from harness import Case

# A slider-crank that turns fast: the piston's y is 0 in truth, and its velocity and acceleration with it.
FAST = """\
bodies:
  ground: {points: {O: [0, 0]}}
  crank:  {points: {O: [0, 0], A: [0.05, 0]}, mass: 2, inertia: 0.001}
  rod:    {points: {A: [0, 0], B: [0.18, 0]}, mass: 1, rod: [A, B]}
  piston: {points: {B: [0, 0]}, mass: 0.5}
joints:
  O: {pin: [ground, crank], angle: theta}
  A: {pin: [crank, rod], angle: phi}
  S: {slide: [ground, piston], along: %s, distance: s}
  B: {pin: [rod, piston]}
drives: {theta: 1 + %g rad/s * t}
start: {phi: -1.2, s: 0.2}
"""

# Lengths of a micrometre, masses of picograms, one turn in a year.
TINY = """\
parameters: {r: 0.05 um, l: 0.18 um}
bodies:
  ground: {points: {O: [0, 0]}}
  crank:  {points: {O: [0, 0], A: [r, 0]}, mass: 1e-15}
  rod:    {points: {A: [0, 0], B: [l, 0]}, mass: 1e-15, rod: [A, B]}
  piston: {points: {B: [0, 0]}, mass: 1e-15}
joints:
  O: {pin: [ground, crank], angle: theta}
  A: {pin: [crank, rod], angle: phi}
  S: {slide: [ground, piston], along: x, distance: s}
  B: {pin: [rod, piston]}
drives: {theta: 1 + 2e-7 rad/s * t}
start: {phi: -1.2, s: 0.2 um}
"""

# Its two cranks are always parallel: 90 deg/s.
PARALLELOGRAM = """\
units: {length: mm, angle: deg}
bodies:
  ground:  {points: {O: [0, 0], C: [100, 0]}}
  crank:   {points: {O: [0, 0], A: [40, 0]}}
  coupler: {points: {A: [0, 0], B: [100, 0], P: [50, 30]}}
  rocker:  {points: {C: [0, 0], B: [40, 0]}}
joints:
  O: {pin: [ground, crank], angle: theta1}
  A: {pin: [crank, coupler], angle: theta2}
  C: {pin: [ground, rocker], angle: theta3}
  B: {pin: [coupler, rocker]}
drives: {theta1: 60 + 90 deg/s * t}
start: {theta2: -60, theta3: 60}
"""

# Eight stages of 1 : 50, each shaft pinned to the ground.
TRAIN = ("bodies:\n  ground: {points: {%s}}\n" % ", ".join("P%d: [%d, 0]" % (k, k) for k in range(9))
         + "".join("  g%d: {}\n" % k for k in range(9)) + "joints:\n"
         + "".join("  P%d: {pin: [ground, g%d], angle: a%d}\n" % (k, k, k) for k in range(9)) + "gears:\n"
         + "".join("  m%d: {mesh: [g%d, g%d], teeth: [20, 1000]}\n" % (k, k, k + 1) for k in range(8))
         + "drives: {a0: 3000 rpm * t}\n")


def numbers(text, name):
    """The numbers of the line that begins with this name."""
    (line,) = re.findall(r"(?m)^  %s  .*$" % re.escape(name), text)
    return [float(word) for word in re.findall(r"(?<![\w.])-?\d[\d.]*(?:e[+-]?\d+)?(?!\w)", line[2 + len(name):])]


class Noise(Case):
    def both(self, model, *words):
        path = self.write("machine.yaml", model)
        return self.good("solve", path, *words).out, self.good("solve", path, *words, "--format", "json").json()["configurations"][0]

    def test_what_is_0_in_truth_is_0_in_text_and_exact_in_json(self):
        seen = 0
        for along in ("x", "0.3", "90 deg", "-1.1"):
            for rate in (1e-3, 1, 300, 1e5):
                # The guide's direction turned: across it the piston moves by nothing, whatever its size along it.
                text, pose = self.both(FAST % (along, rate))
                piston = pose["bodies"]["piston"]
                self.assertEqual([piston["rate"], piston["acceleration"]], [0, 0])
                if along == "90 deg":
                    x = numbers(text, "piston.B")[0::2]
                    self.assertEqual(x, [0, 0, 0])
                    seen += any(pose["points"]["piston.B"][key][0] != 0 for key in ("position", "velocity", "acceleration"))
                if along == "x":
                    self.assertEqual(numbers(text, "piston.B")[1::2], [0, 0, 0])
        self.assertGreater(seen, 0)  # otherwise nothing was hidden here

    def test_every_value_that_is_not_noise_is_told(self):
        for model in (FAST % ("x", 1e-12), FAST % ("x", 300), TINY):
            text, pose = self.both(model)
            for name, motion in pose["coordinates"].items():
                label = name + " (input)" if name == "theta" else name
                told = numbers(text, label)
                for have, want in zip(told, (motion["position"], motion["velocity"], motion["acceleration"])):
                    self.assertAlmostEqual(have, want, delta=1e-5 * abs(want))
            for name in ("A", "B"):
                told = [float(word) for word in re.findall(r"-?\d[\d.]*(?:e[+-]?\d+)?", re.findall(r"(?m)^  %s +\w+, \w+ (.*)$" % name, text)[0])]
                force = pose["reactions"][name]["force"]
                for have, want in zip(told, force):
                    self.assertAlmostEqual(have, want, delta=1e-5 * abs(want))
                    self.assertNotEqual(have, 0)
            kinetic = float(re.search(r"kinetic (\S+) J", text)[1])
            self.assertAlmostEqual(kinetic, pose["energy"]["kinetic"], delta=1e-5 * pose["energy"]["kinetic"])
            self.assertGreater(kinetic, 0)

    def test_the_last_wheel_of_a_long_train_turns(self):
        text, pose = self.both(TRAIN)
        expected = 3000 * 3.141592653589793 / 30 / 50 ** 8
        self.assertAlmostEqual(pose["coordinates"]["a8"]["velocity"], expected, delta=1e-13 * expected)
        self.assertAlmostEqual(numbers(text, "a8")[1], expected, delta=1e-5 * expected)
        self.assertLess(expected / 314, 1e-13)

    def test_a_value_of_the_command_line_is_told_as_it_was_given(self):
        text, _ = self.both(FAST % ("x", 1), "--at", "theta=1e-20", "--rate", "theta=3e-25")
        self.assertEqual(numbers(text, "theta (input)")[:2], [1e-20, 3e-25])

    def test_tables_over_a_range_hide_noise_alone(self):
        path = self.write("machine.yaml", FAST % ("90 deg", 300))
        words = ("--over", "theta=-180deg:180deg", "--steps", "12", "--of", "s,piston.B.x,piston.B.x.accel,s.accel,kinetic")
        text = self.good("sweep", path, *words).out
        rows = [line.split() for line in text.split("\n\n")[1].splitlines()[1:]]
        exact = self.good("sweep", path, *words, "--format", "json").json()["rows"]
        self.assertEqual(len(rows), 13)
        hidden = 0
        for told, true in zip(rows, exact):
            self.assertEqual([told[2], told[3]], ["0", "0"])
            hidden += true[2] != 0
            for column in (1, 4, 5):
                self.assertAlmostEqual(float(told[column]), true[column], delta=1e-5 * abs(true[column]))
        self.assertGreater(hidden, 0)
        self.assertEqual(rows[6][0], "0")


# A four-bar that rocks, its limit at cos(theta) = 1/4, and an arm on a pin of its own that turns with little inertia.
ROCKING = """\
bodies:
  ground: {points: {O: [0, 0], C: [1, 0]}}
  crank:  {points: {O: [0, 0], A: [0.5, 0]}, mass: 1, inertia: 0.1}
  rod:    {points: {A: [0, 0], B: [0.4, 0]}, mass: 1, inertia: 0.1}
  rocker: {points: {C: [0, 0], B: [0.6, 0]}, mass: 1, inertia: 0.1}
  arm:    {points: {O: [0, 0], P: [0.2, 0]}, mass: 0.2, center: [0.1, 0]}
joints:
  O: {pin: [ground, crank], angle: theta}
  A: {pin: [crank, rod], angle: phi}
  C: {pin: [ground, rocker], angle: psi}
  B: {pin: [rod, rocker]}
  Q: {pin: [ground, arm], at: O, angle: q}
drives: {theta: 1 rad/s * t, q: 0.6 + 0.01 rad/s * t}
start: {phi: 0.5, psi: 2}
"""


# A heavy wheel under a small torque, and a pin of a milligram that its guide holds against tonnes.
LIGHT = """\
bodies:
  ground: {points: {O: [0, 0], W: [3, 0]}}
  wheel:  {points: {W: [0, 0]}, mass: 2000, inertia: 500}
  pin:    {points: {O: [0, 0]}, mass: 1e-6}
joints:
  W: {pin: [ground, wheel], angle: theta}
  S: {slide: [ground, pin], along: x, distance: x}
forces: {F: {body: pin, value: [0, 20 kN]}}
efforts: {theta: 1e-4 N*m}
"""


class Loads(Case):
    def test_a_light_body_held_against_a_load_hides_no_small_acceleration(self):
        text = self.good("solve", self.write("light.yaml", LIGHT)).out
        self.assertEqual(numbers(text, "wheel"), [0, 0, 2e-7])
        self.assertIn("  theta         0.0001\n", text)


# A stiff damped spring throws a bead at the start; beside it a heavy flywheel gathers speed.
JOLT = """\
bodies:
  ground: {points: {O: [0, 0]}}
  bead: {mass: 1e-3}
  wheel: {points: {O: [0, 0]}, mass: 1, inertia: 500}
joints:
  S: {slide: [ground, bead], along: x, distance: x}
  O: {pin: [ground, wheel], angle: q}
springs: {k: {along: x, stiffness: 1e7, damping: 200}}
efforts: {q: 1e-6 N*m}
start: {x: 0.1}
"""


class Jolts(Case):
    def test_a_jolt_hides_no_later_acceleration(self):
        out = self.good("simulate", self.write("jolt.yaml", JOLT), "--to", "1", "--every", "0.1", "--of", "x.accel,q.accel").out
        rows = [line.split() for line in out.split("\n\n")[1].splitlines()[1:]]
        self.assertEqual(float(rows[0][1]), -1e9)
        self.assertEqual([row[2] for row in rows[6:]], ["2e-9"] * 5)

    def test_noise_of_a_large_load_across_the_guide_is_0(self):
        """20 kN at right angles to a guide at 30 degrees leave 1e-16 of them along it, over a milligram."""
        text = self.good("solve", self.write("light.yaml", LIGHT.replace("along: x", "along: 30 deg").replace(
            "[0, 20 kN]", "[-10 kN, 17320.508075688772]"))).out
        self.assertEqual(numbers(text, "wheel"), [0, 0, 2e-7])
        self.assertEqual(numbers(text, "x (input)"), [0, 0, 0])
        self.assertEqual(numbers(text, "pin.O"), [0, 0, 0, 0, 0, 0])


class Limits(Case):
    def test_what_grows_without_bound_at_a_limit_hides_nothing(self):
        """Near a limit accelerations and forces grow without bound: beside them, and in the rows before, the rest stays what it is."""
        path = self.write("rocking.yaml", ROCKING)
        limit = math.acos(0.25)
        for off in (1e-5, 1e-7, 1e-9):
            words = ("--over", "theta=1:%r" % (limit - off), "--steps", "4", "--of",
                     "phi.accel,psi.accel,crank.A.x.accel,arm.P.x.rate,arm.P.y.accel,O.force.x,C.force.x,Q.force.x,theta.effort,kinetic")
            rows = [line.split() for line in self.good("sweep", path, *words).out.split("\n\n")[1].splitlines()[1:]]
            exact = self.good("sweep", path, *words, "--format", "json").json()["rows"]
            self.assertEqual(len(rows), 5)
            self.assertGreater(abs(exact[4][1]), off ** -1.5 / 100)
            for told, true in zip(rows, exact):
                for have, want in list(zip(told, true))[1:]:
                    self.assertAlmostEqual(float(have), want, delta=1e-5 * abs(want))


    def test_a_design_at_its_limit_hides_nothing_of_the_others(self):
        path = self.write("designs.yaml", ROCKING.replace("B: [0.4, 0]", "B: [b, 0]").replace("theta: 1", "theta: 1.31811607 + 1") + "parameters: {b: 0.4}\n")
        words = ("--vary", "b=0.4:0.41:3", "--of", "psi.accel,crank.A.x.accel,arm.P.x.rate,C.force.x,theta.effort")
        tables = self.good("study", path, *words).out.split("\n\n")
        exact = list(csv.reader(self.good("study", path, *words, "--format", "csv").out.splitlines()))[1:]
        self.assertGreater(abs(float(exact[0][4])), 1e11)
        for told, true in zip([line.split()[2:] for line in tables[1].splitlines()[2:]], exact[1:]):
            for have, want in zip(told, map(float, true[4:])):
                self.assertAlmostEqual(float(have), want, delta=1e-5 * abs(want))
        (told,) = [line.split()[2:] for line in tables[2].splitlines() if line.startswith("  crank")]
        self.assertEqual(told, ["-0.125", "0", "-0.125", "-0.125"])


class Designs(Case):
    def test_a_design_of_which_all_that_is_asked_is_0_shows_no_noise(self):
        """One design of three is a parallelogram, whose coupler does not turn; one guide of three stands across x."""
        path = self.write("designs.yaml", PARALLELOGRAM.replace("C: [100, 0]", "C: [d, 0]") + "parameters: {d: 100 mm}\n")
        out = self.good("study", path, "--vary", "d=90mm:110mm:3", "--of", "coupler.rate,coupler.accel").out
        rows = [line.split()[2:] for line in out.split("\n\n")[1].splitlines()[1:]]
        self.assertEqual(rows[1], ["0", "0"])
        self.assertNotIn("0", rows[0] + rows[2])
        path = self.write("guides.yaml", FAST % ("u", 300) + "parameters: {u: 90 deg}\n")
        out = self.good("study", path, "--vary", "u=80deg:100deg:3", "--of", "piston.B.x.rate,piston.B.x.accel").out
        rows = [line.split()[2:] for line in out.split("\n\n")[1].splitlines()[1:]]
        self.assertEqual(rows[1], ["0", "0"])
        self.assertNotIn("0", rows[0] + rows[2])


class Reversals(Case):
    def test_where_a_drive_turns_back_all_is_at_rest(self):
        """At 0.25 s the rate of sin(2 pi t) is 0, but for the rounding of the time; at 0.5 s its acceleration is."""
        path = self.write("turns.yaml", PARALLELOGRAM.replace("60 + 90 deg/s * t", "60 + 20 deg * sin(360 deg/s * t)"))
        of = "theta3.rate,rocker.rate,coupler.P.x.rate,crank.A.y.rate,crank.accel,theta3.accel,crank.A.y"
        out = self.good("sweep", path, "--over", "t=0:1s", "--steps", "4", "--of", of).out
        rows = [line.split()[1:] for line in out.split("\n\n")[1].splitlines()[1:]]
        for row in (0, 2, 4):
            self.assertEqual(rows[row][4:6], ["0", "0"])
        for row in (1, 3):
            self.assertEqual(rows[row][:4], ["0"] * 4)
            self.assertNotIn("0", rows[row - 1][:4] + rows[row][4:])
        events = [line.split() for line in out.split("\n\n")[2].splitlines() if "crank.A.y =" in line]
        self.assertEqual([line[1] for line in events], ["0.25", "0.75"])
        self.assertEqual([line[-7:-3] for line in events], [["0"] * 4] * 2)


class ChangePoints(Case):
    def test_zeros_at_and_beside_a_change_point_are_0(self):
        """A parallelogram moves alike at every pose: accelerations of its cranks are 0, and so is the coupler's rate."""
        path = self.write("parallelogram.yaml", PARALLELOGRAM)
        zeros = "theta2.accel,theta3.accel,coupler.rate,coupler.accel"
        for over, steps in (("0:360deg", 8), ("175:185deg", 10), ("179:180deg", 4)):
            words = ("--over", "theta1=" + over, "--steps", str(steps), "--of", zeros + ",theta3.rate,coupler.P.x.accel")
            rows = [line.split() for line in self.good("sweep", path, *words).out.split("\n\n")[1].splitlines()[1:]]
            exact = self.good("sweep", path, *words, "--format", "json").json()["rows"]
            self.assertEqual(len(rows), steps + 1)
            self.assertTrue(any(value != 0 for row in exact for value in row[1:5]))
            for told, true in zip(rows, exact):
                self.assertEqual(told[1:5], ["0"] * 4)
                self.assertEqual(told[5], "90")
                accel = -40 * (math.pi / 2) ** 2 * math.cos(true[0])
                self.assertAlmostEqual(float(told[6]), accel, delta=1e-4)

    def test_a_pose_at_a_change_point_is_that_row_of_a_sweep(self):
        """Solve moves there as a sweep does: the same rates, limits of the motion, and as zeros what is noise."""
        path = self.write("parallelogram.yaml", PARALLELOGRAM)
        run = self.good("solve", path, "--at", "theta1=180deg", "--of", "theta2.accel,theta3.accel,coupler.rate,theta3.rate,coupler.P.x.accel")
        self.assertIn("W0604", run.err)
        told = [line.split()[1] for line in run.out.split("\n\n")[1].splitlines()[1:]]
        self.assertEqual(told[:4], ["0", "0", "0", "90"])
        self.assertAlmostEqual(float(told[4]), 40 * (math.pi / 2) ** 2, delta=1e-4)

    def test_what_is_small_and_true_beside_a_change_point_is_told(self):
        """Almost a parallelogram: its cranks differ by a millionth, and the rate of its coupler is 1e-7 of theirs."""
        path = self.write("almost.yaml", PARALLELOGRAM.replace("B: [40, 0]", "B: [40.00004, 0]"))
        rows = [line.split() for line in self.good("sweep", path, "--over", "theta1=5:80deg", "--steps", "15", "--of",
                                                   "coupler.rate").out.split("\n\n")[1].splitlines()[1:]]
        self.assertTrue(all(float(row[1]) != 0 for row in rows))


class Turns(Case):
    def test_lost_digits_of_an_angle_that_is_set_are_told(self):
        """10^6 and 10^18 degrees are both 280 beyond whole turns, but a number holds only the first of them."""
        file = self.write("fast.yaml", FAST % ("x", 1))
        near = self.good("solve", file, "--at", "theta=280deg", "--format", "json").json()["configurations"][0]
        s = near["coordinates"]["s"]["position"]
        for degrees, is_told in (("1e6", False), ("1e15", True), ("1e18", True)):
            run = self.good("solve", file, "--at", "theta=%sdeg" % degrees, "--format", "json")
            self.assertEqual("[W0641]" in run.err, is_told, run.err)
            off = abs(run.json()["configurations"][0]["coordinates"]["s"]["position"] - s)
            self.assertEqual(off > 1e-10, is_told, off)


if __name__ == "__main__":
    unittest.main()
