"""Forces, motion in time and rest at the command: shapes, units, messages, exit codes, interruptions. Run: YOKE=path/of/yoke python3
test_forces.py. The numbers themselves are the matter of test_dynamics.py and test_simulations.py."""
import cmath
import json
import math
import os
import re
import resource
import signal
import subprocess
import time
import unittest

from harness import Case, FOUR_BAR, ROOT, Run, YOKE

PENDULUM = """\
name: Test pendulum
parameters: {tau: 0 N*m}
gravity: [0, -9.81]
bodies:
  ground: {points: {O: [0, 0]}}
  rod:    {points: {O: [0, 0], P: [0, -1]}, mass: 2, center: [0, -1], inertia: 0}
joints:
  O: {pin: [ground, rod], angle: theta}
efforts: {theta: tau}
start: {theta: 0.5, theta.rate: 0}
"""

HEAVY = FOUR_BAR.replace("A: [a, 0]}}", "A: [a, 0]}, mass: 1, rod: [O, A]}").replace("P: [60, 50]}}", "P: [60, 50]}, mass: 2, rod: [A, B]}")

# Every mass hangs in the middle of the crank: nothing resists the rider's sliding.
RIDER = PENDULUM.replace("joints:", "  rider:  {points: {}}\njoints:\n  S: {slide: [rod, rider], along: x, distance: d}")

# A toggle whose input, driven round, comes to a limit.
JAMMING = FOUR_BAR.replace("a: 40", "a: 90").replace("B: [120, 0]", "B: [60, 0]").replace("B: [80, 0]}}", "B: [40, 0]}, mass: 1, inertia: 1 kg*mm^2}").replace(
    "theta1: 60 + 90 deg/s * t", "theta1: 20 + 90 deg/s * t").replace("theta2: -20", "theta2: -60")

# A block on a rough incline, held by a drive.
PRESS = """\
# a slider-crank whose ram works against a table that ends too early
parameters: {r: 50 mm, l: 180 mm}
bodies:
  ground: {points: {O: [0, 0]}}
  crank:  {points: {O: [0, 0], A: [r, 0]}}
  rod:    {points: {A: [0, 0], B: [l, 0]}}
  ram:    {points: {B: [0, 0]}, mass: 2 kg}
joints:
  O: {pin: [ground, crank], angle: theta}
  A: {pin: [crank, rod], angle: phi}
  B: {pin: [rod, ram]}
  S: {slide: [ground, ram], along: x, distance: s}
drives: {theta: 60 deg + 300 rpm * t}
laws:
  cutting: {table: [[150 mm, -100 N], [180 mm, -300 N], [200 mm, -500 N]]}
efforts: {s: {law: cutting, of: s}}
start: {phi: -75 deg, s: 200 mm}
units: {length: mm, angle: deg}
"""

INCLINE = """\
gravity: [0, -10]
bodies:
  ground: {points: {O: [0, 0]}}
  b: {points: {P: [0, 0]}, mass: 2}
joints:
  S: {slide: [ground, b], along: 0.5 rad, distance: d, friction: {coulomb: 0.3}}
drives: {d: 0 m}
"""

GRAVITY = 9.81


def example(name):
    return os.path.join(ROOT, "examples", name + ".yaml")


class Machine(Case):
    def setUp(self):
        super().setUp()
        self.pendulum = self.write("pendulum.yaml", PENDULUM)
        self.heavy = self.write("heavy.yaml", HEAVY)

    def pose(self, *words):
        (pose,) = self.good("solve", *words, "--format", "json").json()["configurations"]
        return pose


class Solve(Machine):
    def test_the_json_has_the_documented_groups(self):
        pose = self.pose(self.heavy)
        self.assertEqual(set(pose["reactions"]), {"O", "A", "B", "C"})
        self.assertEqual(set(pose["reactions"]["A"]), {"by", "on", "force", "moment"})
        self.assertEqual([pose["reactions"]["A"]["by"], pose["reactions"]["A"]["on"]], ["crank", "coupler"])
        self.assertEqual(set(pose["efforts"]), {"theta1"})
        self.assertEqual(set(pose["energy"]), {"kinetic", "potential"})
        self.assertEqual(set(pose["shaking"]), {"force", "moment"})
        self.assertEqual(set(pose["balance"]), {"crank", "coupler", "rocker"})
        for balance in pose["balance"].values():
            self.assertEqual(set(balance), {"loads", "reactions", "inertia", "residual"})
            self.assertLess(balance["residual"], 1e-12)

    def test_a_machine_without_masses_and_loads_has_none(self):
        pose = self.pose(self.four_bar)
        for group in ("reactions", "efforts", "energy", "shaking", "balance", "equations"):
            self.assertNotIn(group, pose)
        self.assertNotIn("reaction", self.good("solve", self.four_bar).out)
        self.assertNotIn("reaction", self.good("solve", self.four_bar, "--format", "csv").out)

    def test_the_toggle_has_20_equations_in_20_unknowns(self):
        want = "12 force + 4 moment + 4 acceleration = 20 equations; 20 unknowns"
        equations = self.pose(example("toggle"))["equations"]
        self.assertEqual([equations["text"], equations["force"], equations["moment"], equations["acceleration"]], [want, 12, 4, 4])
        self.assertIn(want, self.good("solve", example("toggle")).out)

    def test_an_undriven_input_falls_and_a_set_acceleration_holds_it(self):
        free = self.pose(self.pendulum)
        self.assertAlmostEqual(free["coordinates"]["theta"]["acceleration"], -GRAVITY * math.sin(0.5), places=12)
        held = self.pose(self.pendulum, "--accel", "theta=0 rad/s^2")
        self.assertEqual(held["coordinates"]["theta"]["acceleration"], 0)
        self.assertAlmostEqual(held["efforts"]["theta"], 2 * GRAVITY * math.sin(0.5), places=12)

    def test_an_effort_replaces_the_files(self):
        pose = self.pose(self.pendulum, "--effort", "theta=3 N*m", "--at", "theta=0")
        self.assertAlmostEqual(pose["coordinates"]["theta"]["acceleration"], 1.5, places=12)
        self.assertEqual(pose["efforts"]["theta"], 3)
        same = self.pose(self.pendulum, "--param", "tau=3 N*m", "--at", "theta=0")
        self.assertEqual(pose, same)

    def test_a_freedom_without_inertia_is_named(self):
        file = self.write("bare.yaml", """gravity: [0, -9.81]
bodies:
  ground: {points: {O: [0, 0]}}
  arm:    {points: {O: [0, 0], A: [1, 0]}, mass: 1, center: [0.5, 0]}
  bare:   {points: {A: [0, 0]}, mass: 1}
joints:
  O: {pin: [ground, arm], angle: p}
  A: {pin: [arm, bare], angle: q}
start: {p: 0, q: 0}
""")
        for words in (("simulate", file, "--to", "1"), ("simulate", file, "--to", "1", "--of", "O.force.x")):
            run = Run(*words)
            self.assertEqual(run.code, 1)
            self.assertIn("no inertia resists `q`: give mass or inertia to body `bare`", run.err)

    def test_a_load_without_a_finite_value_is_told(self):
        file = self.write("infinite.yaml", "bodies: {ground: {}, block: {mass: 2 kg}}\n"
                          "joints: {S: {slide: [ground, block], along: x, distance: x}}\n"
                          "forces: {push: {body: block, value: [1 N*m / x, 0]}}\ndrives: {x: 0.1 m/s * t}\n")
        sweep = self.good("sweep", file, "--over", "t=0s:1s", "--steps", "4", "--of", "x.effort", "--format", "json")
        self.assertIsNone(sweep.json()["rows"][0][1])
        self.assertAlmostEqual(sweep.json()["rows"][2][1], -1 / 0.05, places=12)
        self.assertIn("warning: no forces at t = 0 s: the load `push` has no finite value at this pose and time [W0861]", sweep.err)
        away = self.good("sweep", file, "--over", "t=0.1s:1s", "--of", "x.effort")
        self.assertNotIn("W0861", away.err)
        self.assertNotIn("W0861", self.good("sweep", file, "--over", "t=0s:1s", "--of", "x").err)  # asks for no forces

    def test_a_law_whose_range_is_left_is_told(self):
        file = self.write("press.yaml", PRESS)
        stroke = lambda angle: 50 * math.cos(angle) + math.sqrt(180 ** 2 - (50 * math.sin(angle)) ** 2)
        outside = [k for k in range(13) if not 150 <= stroke(math.radians(30 * k)) <= 200]
        sweep = self.good("sweep", file, "--over", "theta=0:360deg", "--steps", "12", "--of", "theta.effort", "--format", "json")
        left = sweep.json()["laws_left"]
        self.assertEqual([(left[0][key]) for key in ("law", "user", "of", "poses", "at")], ["cutting", "effort", "s", len(outside), 0])
        self.assertAlmostEqual(left[0]["argument"], 0.23, places=12)
        self.assertIn("press.yaml:16:11: warning: the effort of `s` leaves the range of law `cutting`, 150 mm to 200 mm: at 230 mm "
                      "it keeps its end value, -500 N; first at theta = 0 deg, in %d poses [W0860]" % len(outside), sweep.err)
        positions = self.good("sweep", file, "--over", "theta=0:360deg", "--of", "s", "--format", "json")  # needs no law
        self.assertNotIn("laws_left", positions.json())
        self.assertNotIn("W0860", positions.err)
        inside = self.good("solve", file, "--format", "json")
        self.assertNotIn("laws_left", inside.json())
        self.assertNotIn("W0860", inside.err)
        pose = self.good("solve", file, "--at", "theta=180deg", "--format", "json")
        self.assertAlmostEqual(pose.json()["laws_left"][0]["argument"], 0.13, places=12)
        self.assertIn("at 130 mm it keeps its end value, -100 N [W0860]", pose.err)
        self.assertNotIn("W0860", self.good("solve", file, "--at", "theta=180deg", "--quiet").err)

    def test_balancing_tells_a_law_that_the_cycle_leaves(self):
        file = self.write("press.yaml", PRESS)
        stroke = lambda angle: 50 * math.cos(angle) + math.sqrt(180 ** 2 - (50 * math.sin(angle)) ** 2)
        turn = [60 + k for k in range(360)]
        outside = [angle for angle in turn if not 150 <= stroke(math.radians(angle)) <= 200]
        told = self.good("balance", file, "--format", "json")
        [left] = told.json()["laws_left"]
        self.assertEqual([left[key] for key in ("law", "user", "of", "poses")], ["cutting", "effort", "s", len(outside)])
        self.assertAlmostEqual(left["at"], math.radians(outside[0]), places=12)
        self.assertIn("press.yaml:16:11: warning: the effort of `s` leaves the range of law `cutting`, 150 mm to 200 mm", told.err)
        self.assertIn("first at theta = %d deg, in %d poses [W0860]" % (outside[0], len(outside)), told.err)
        whole = self.write("whole.yaml", PRESS.replace("[150 mm, -100 N], [180", "[120 mm, -100 N], [180").replace("[200 mm, -500 N]", "[230.1 mm, -500 N]"))
        inside = self.good("balance", whole, "--format", "json")
        self.assertNotIn("laws_left", inside.json())
        self.assertNotIn("W0860", inside.err)

    def test_a_study_tells_a_law_that_the_own_design_leaves(self):
        file = self.write("press.yaml", PRESS)
        words = ("study", file, "--vary", "r=48mm:50mm:3", "--of", "theta.effort")
        stroke = lambda angle: 50 * math.cos(angle) + math.sqrt(180 ** 2 - (50 * math.sin(angle)) ** 2)
        outside = [k for k in range(13) if not 150 <= stroke(math.radians(30 * k)) <= 200]
        turn = self.good(*words, "--over", "theta=0:360deg", "--steps", "12")
        self.assertIn("at 230 mm it keeps its end value, -500 N; first at theta = 0 deg, in %d poses, with the file's own values "
                      "[W0860]" % len(outside), turn.err)
        time = self.good(*words, "--over", "t=0s:0.2s", "--steps", "12")  # the same turn, from 60 deg
        self.assertIn("in %d poses, with the file's own values [W0860]" % (len(outside) - 1), time.err)
        self.assertIn("at 130 mm it keeps its end value, -100 N, with the file's own values [W0860]",
                      self.good(*words, "--at", "theta=180deg").err)
        self.assertNotIn("W0860", self.good(*words).err)
        self.assertNotIn("W0860", self.good("study", file, "--vary", "r=48mm:50mm:3", "--of", "s", "--over", "theta=0:360deg").err)

    def test_a_motion_and_a_report_tell_a_law_once(self):
        file = self.write("press.yaml", PRESS)
        run = self.good("simulate", file, "--to", "0.4s", "--steps", "4", "--format", "json")  # two turns
        angle = math.radians(60) + 10 * math.pi * run.json()["events"][0]["time"]
        self.assertEqual([(event["kind"], event["of"]) for event in run.json()["events"]], [("law-left", "s")])
        self.assertAlmostEqual(0.05 * math.cos(angle) + math.sqrt(0.18 ** 2 - (0.05 * math.sin(angle)) ** 2), 0.15, places=8)
        self.assertEqual(run.err.count("W0860"), 1)
        self.assertIn("law-left of s at t = 0.0330888", run.err)
        page = self.good("report", file).out
        self.assertEqual(page.count("leaves the range of law cutting, 150 mm to 200 mm"), 1)

    def test_an_effort_that_friction_holds_is_a_range(self):
        incline = self.write("incline.yaml", INCLINE)
        low, high = (20 * (math.sin(0.5) + side * 0.3 * math.cos(0.5)) for side in (-1, 1))
        pose = self.pose(incline)
        self.assertIsNone(pose["efforts"]["d"])
        held = pose["effort_ranges"]["d"]
        self.assertAlmostEqual(held["from"], low, places=12)
        self.assertAlmostEqual(held["to"], high, places=12)
        self.assertAlmostEqual(held["without_friction"], 20 * math.sin(0.5), places=12)
        self.assertIn("dry friction of joints at rest", held["reason"])
        text = self.good("solve", incline).out
        self.assertIn("4.32302 to 14.854", text)
        self.assertIn("there is no single answer", text)
        self.assertNotIn("effort_ranges", self.pose(incline, "--rate", "d=1e-9"))
        self.assertAlmostEqual(self.pose(incline, "--rate", "d=1e-9")["efforts"]["d"], high, places=12)
        run = self.good("solve", incline, "--of", "d.effort,d.effort.to", "--format", "json")
        self.assertEqual(run.json()["configurations"][0]["of"], {"d.effort": None, "d.effort.to": held["to"]})
        self.assertIn("[W0638]", run.err)

    def test_a_sweep_says_where_an_effort_is_a_range(self):
        incline = self.write("incline.yaml", INCLINE)
        run = self.good("sweep", incline, "--over", "d=0:1", "--steps", "2", "--of", "d.effort,d.effort.from,d.effort.to", "--format", "json")
        for row in run.json()["rows"]:
            self.assertIsNone(row[1])
            self.assertLess(row[2], row[3])
        self.assertIn("in 3 rows the machine stands under dry friction", run.err)
        self.assertIn("[W0638]", run.err)
        moving = self.good("sweep", incline, "--over", "d=0:1", "--steps", "2", "--of", "d.effort", "--rate", "d=1", "--format", "json")
        self.assertNotIn("[W0638]", moving.err)
        self.assertIsNotNone(moving.json()["rows"][0][1])

    def test_a_sweep_tells_every_effort_that_is_a_range(self):
        """A block on a block: 2 kg and 1 kg, 0.3 and 0.2. Each is held by the friction under it, and by what it pushes on."""
        file = self.write("blocks.yaml", """\
gravity: [0, -9.81]
bodies: {low: {mass: 2 kg}, high: {mass: 1 kg}}
joints:
  L: {slide: [ground, low], along: x, distance: x, friction: {coulomb: 0.3}}
  H: {slide: [low, high], along: x, distance: y, friction: {coulomb: 0.2}}
drives: {x: 0 m, y: 0.1 m}
""")
        run = self.good("sweep", file, "--over", "x=0:1m", "--steps", "2", "--of", "x,y.effort,x.effort", "--format", "json")
        for name, most in (("x", 0.3 * 3 * 9.81), ("y", 0.2 * 9.81)):
            self.assertIn("`%s.effort` has no single value; first at x = 0 m (-%g to %g N)" % (name, most, most), run.err)
        self.assertEqual(run.err.count("[W0638]"), 2)

    def test_a_report_tells_the_range(self):
        page = self.good("report", self.write("incline.yaml", INCLINE)).out
        self.assertIn("4.32302 to 14.854", page)
        self.assertIn("there is no single answer", page)

    def test_efforts_that_do_not_fit_are_refused(self):
        self.assertIn("did you mean `theta`?", self.wrong(814, "solve", self.pendulum, "--effort", "thata=3").err)
        self.assertEqual(Run("solve", self.pendulum, "--effort", "theta=3 m").code, 2)
        self.wrong(807, "solve", self.pendulum, "--effort", "theta")
        self.wrong(803, "draw", self.pendulum, "--effort", "theta=3")

    def test_methods_agree_and_others_are_refused(self):
        one, two = (self.pose(self.heavy, "--method", method) for method in ("reduced", "newton-euler"))
        for joint, reaction in one["reactions"].items():
            for a, b in zip(reaction["force"], two["reactions"][joint]["force"]):
                self.assertAlmostEqual(a, b, places=12)
        self.wrong(806, "solve", self.heavy, "--method", "rk4")
        self.wrong(806, "simulate", self.pendulum, "--to", "1s", "--method", "reduced")

    def test_every_configuration_has_its_forces(self):
        answer = self.good("solve", self.heavy, "--all", "--format", "json").json()
        self.assertEqual(len(answer["configurations"]), 2)
        near = self.pose(self.heavy)
        self.assertIn(near, answer["configurations"])
        efforts = [pose["efforts"]["theta1"] for pose in answer["configurations"]]
        self.assertNotEqual(*efforts)

    def test_at_a_dead_point_reactions_are_left_out_and_the_status_says_why(self):
        # Crank and coupler in line with the rocker as the input.
        stretched = math.acos((0.1 ** 2 + 0.08 ** 2 - 0.16 ** 2) / (2 * 0.1 * 0.08))
        model = HEAVY.replace("drives: {theta1: 60 + 90 deg/s * t}\n", "").replace("theta2: -20, theta3: 90", "theta3: 90, theta2: -20")
        path = self.write("dead.yaml", model)
        run = Run("solve", path, "--at", "theta3=%rrad" % (math.pi - stretched), "--format", "json")
        answer = run.json()
        self.assertEqual([run.code, answer["status"], answer["code"]], [0, "singular", "W0603"])
        self.assertGreater(len(answer["message"]), 10)
        self.assertNotIn("reactions", answer["configurations"][0])
        self.assertIsNone(answer["configurations"][0]["coordinates"]["theta1"]["acceleration"])

    def test_a_freedom_without_inertia_has_no_acceleration(self):
        run = Run("solve", self.write("rider.yaml", RIDER), "--format", "json")
        answer = run.json()
        self.assertEqual(answer["status"], "singular")
        self.assertIn("rider", answer["message"])
        (pose,) = answer["configurations"]
        self.assertEqual(pose["coordinates"]["d"]["position"], 0)
        self.assertIsNone(pose["coordinates"]["d"]["acceleration"])
        self.assertIsNone(pose["bodies"]["rod"]["acceleration"])
        self.assertNotIn("reactions", pose)
        text = Run("solve", self.path("rider.yaml")).out
        self.assertRegex(text, r"(?m)^  d \(input\) +0 +0 +-$")

    def test_text_is_in_usual_units(self):
        """Lengths in mm and no unit of force: N, N*m and J, not kg*mm/s^2."""
        text = self.good("solve", self.heavy).out
        self.assertRegex(text, r"(?m)^  reaction at +by, on +force x \[N\] +force y \[N\] +size \[N\] +moment \[N\*m\]$")
        self.assertRegex(text, r"(?m)^  torque along +\[N\*m\]$")
        self.assertRegex(text, r"(?m)^  energy: kinetic \S+ J, potential \S+ J$")
        own = self.good("solve", self.write("own.yaml", HEAVY.replace("angle: deg}", "angle: deg, force: kN}"))).out
        self.assertIn("force x [kN]", own)

    def test_csv_tells_forces_in_the_same_six_columns(self):
        lines = self.good("solve", self.heavy, "--format", "csv").out.splitlines()
        rows = {(line.split(",")[1], line.split(",")[2]): line.split(",") for line in lines}
        self.assertEqual({len(row) for row in rows.values()}, {6})
        pose = self.pose(self.heavy)
        self.assertEqual([float(field) for field in rows["reaction", "A"][3:]], pose["reactions"]["A"]["force"] + [pose["reactions"]["A"]["moment"]])
        self.assertEqual(float(rows["effort", "theta1"][3]), pose["efforts"]["theta1"])
        self.assertEqual(float(rows["energy", "kinetic"][3]), pose["energy"]["kinetic"])


class Check(Machine):
    def test_masses_loads_and_equations_are_counted(self):
        text = self.good("check", example("rocking-four-bar")).out
        self.assertRegex(text, r"3 bodies with mass, 2\.9 kg in all; gravity; 1 spring; 1 damper; friction at 3 joints\n")
        self.assertRegex(text, r"free bodies: .* = \d+ equations; \d+ unknowns\n")
        answer = self.good("check", example("rocking-four-bar"), "--format", "json").json()
        self.assertEqual(answer["masses"], {"left": 0.5, "coupler": 2, "right": 0.4})
        self.assertEqual([answer["loads"][kind] for kind in ("gravity", "springs", "dampers", "frictions", "stops")], [True, 1, 1, 3, 0])
        equations = answer["equations"]
        self.assertEqual(equations["force"] + equations["moment"] + equations["acceleration"],
                         sum(equations["unknown_" + kind] for kind in ("reactions", "accelerations", "efforts")))

    def test_a_machine_of_motion_alone_is_told_nothing_of_them(self):
        self.assertNotIn("mass", self.good("check", self.four_bar).out)
        answer = self.good("check", self.four_bar, "--format", "json").json()
        for key in ("masses", "loads", "equations"):
            self.assertNotIn(key, answer)


class Sweep(Machine):
    def test_columns_of_forces_are_those_of_solve(self):
        of = ["theta1.effort", "A.force.x", "A.force", "energy", "shaking.moment"]
        head, rows = self.good("sweep", self.heavy, "--over", "theta1=0:350deg", "--steps", "7", "--of", ",".join(of), "--format", "csv").csv()
        self.assertEqual(head, ["theta1"] + of)
        for row in rows:
            pose = self.pose(self.heavy, "--at", "theta1=%rrad" % row[0])
            force = pose["reactions"]["A"]["force"]
            want = [pose["efforts"]["theta1"], force[0], math.hypot(*force), sum(pose["energy"].values()), pose["shaking"]["moment"]]
            for a, b in zip(row[1:], want):
                self.assertAlmostEqual(a, b, delta=1e-9 * max(1, abs(b)))

    def test_at_dead_points_columns_of_forces_are_empty(self):
        """A piston that is pushed outwards: crank and rod come in line at 3 m."""
        path = self.write("piston.yaml", """\
bodies:
  ground: {points: {O: [0, 0]}}
  crank:  {points: {O: [0, 0], A: [1, 0]}, mass: 1, rod: [O, A]}
  rod:    {points: {A: [0, 0], B: [2, 0]}}
  piston: {points: {B: [0, 0]}, mass: 1}
joints:
  O: {pin: [ground, crank], angle: theta}
  A: {pin: [crank, rod]}
  B: {pin: [rod, piston]}
  S: {slide: [ground, piston], along: x, distance: x}
start: {x: 2.5, theta: 1}
""")
        _, rows = Run("sweep", path, "--over", "x=2.5:3", "--steps", "2", "--of", "theta,theta.rate,x.effort", "--format", "csv").csv()
        self.assertEqual([row[0] for row in rows], [2.5, 2.75, 3])
        self.assertAlmostEqual(rows[2][1], 0, places=7)
        self.assertEqual(rows[2][2:], [None, None])
        for row in rows[:2]:
            self.assertNotIn(None, row)

    def test_a_machine_without_loads_has_no_such_columns(self):
        self.wrong(819, "sweep", self.four_bar, "--over", "theta1=0:90deg", "--of", "theta1.effort")


class Simulate(Machine):
    def simulate(self, *words):
        return self.good("simulate", self.pendulum, *words)

    def test_rows_come_at_the_asked_times(self):
        for words, want in ((["--to", "2s", "--steps", "4"], [0, 0.5, 1, 1.5, 2]), (["--to", "1s", "--every", "0.4s"], [0, 0.4, 0.8, 1]),
                            (["--from", "3s", "--to", "4s", "--steps", "2"], [3, 3.5, 4])):
            head, rows = self.simulate(*words, "--format", "csv").csv()
            self.assertEqual(head, ["t", "theta", "energy"])
            for row, t in zip(rows, want):
                self.assertAlmostEqual(row[0], t, places=15)
            self.assertEqual(len(rows), len(want))
        self.assertEqual(len(self.simulate("--to", "1s", "--format", "csv").csv()[1]), 101)

    def test_the_json_shape_is_the_documented_one(self):
        answer = self.simulate("--to", "1s", "--steps", "2", "--of", "theta,theta.rate,O.force.y", "--effort", "theta=1", "--format", "json").json()
        self.assertEqual(list(answer), ["model", "status", "freedom", "columns", "rows", "events", "certified", "work", "summary"])
        self.assertEqual(answer["columns"], ["t", "theta", "theta.rate", "O.force.y"])
        self.assertEqual([row[0] for row in answer["rows"]], [0, 0.5, 1])
        self.assertEqual(answer["events"], [])
        work = {entry["of"]: entry["work"] for entry in answer["work"]}
        self.assertAlmostEqual(work["theta"], answer["rows"][-1][1] - 0.5, places=8)
        summary = answer["summary"]
        self.assertEqual(summary["end"], 1)
        self.assertAlmostEqual(summary["energy_end"] - summary["energy_start"], sum(work.values()), places=8)
        for count in ("steps", "rejected", "evaluations", "recoordinations"):
            self.assertIsInstance(summary[count], int)

    def test_the_formats_tell_the_same(self):
        words = ["--to", "1s", "--steps", "5", "--of", "theta,energy"]
        rows = self.simulate(*words, "--format", "csv").csv()[1]
        self.assertEqual(self.simulate(*words, "--format", "json").json()["rows"], rows)
        lines = self.simulate(*words).out.splitlines()
        self.assertRegex(lines[2], r"^ +t \[s\] +theta \[rad\] +energy \[J\]$")
        self.assertEqual({len(line) for line in lines[2:]}, {len(lines[2])})
        for line, row in zip(lines[3:], rows):
            for word, value in zip(line.split(), row):
                self.assertAlmostEqual(float(word), value, delta=1e-5 * max(1, abs(value)))

    def test_start_values_replace_the_files(self):
        rows = self.simulate("--to", "1s", "--steps", "1", "--of", "theta,theta.rate", "--at", "theta=30deg", "--rate", "theta=2rad/s", "--format", "csv").csv()[1]
        self.assertAlmostEqual(rows[0][1], math.pi / 6, places=15)
        self.assertEqual(rows[0][2], 2)
        # by the energy: rate^2 / 2 - g cos(theta) stays
        self.assertAlmostEqual(rows[1][2] ** 2 / 2 - GRAVITY * math.cos(rows[1][1]), 2 - GRAVITY * math.cos(math.pi / 6), places=7)

    def test_a_driven_coordinate_starts_where_its_drive_says(self):
        self.wrong(822, "simulate", self.heavy, "--to", "1s", "--at", "theta1=3")
        self.wrong(822, "simulate", self.heavy, "--to", "1s", "--rate", "theta1=3")

    def test_events_are_told_on_standard_error_and_in_json(self):
        run = self.simulate("--to", "2s", "--event", "theta=0deg", "--format", "csv")
        quarter = re.search(r"crossing of theta=0deg at t = (\S+) s", run.err)
        answer = self.simulate("--to", "2s", "--event", "theta=0deg", "--format", "json").json()
        kinds = [(event["kind"], event["of"]) for event in answer["events"]]
        self.assertEqual(kinds, [("crossing", "theta=0deg")] * 2)
        first, second = (event["time"] for event in answer["events"])
        self.assertAlmostEqual(float(quarter.group(1)), first, places=8)
        self.assertAlmostEqual(second, 3 * first, places=7)  # a quarter and three quarters of the period
        self.wrong(807, "simulate", self.pendulum, "--to", "2s", "--event", "theta")
        self.assertEqual(Run("simulate", self.pendulum, "--to", "2s", "--event", "thata=1").code, 2)

    def test_the_last_line_tells_cost_and_errors_quiet_or_not(self):
        pattern = r"^simulate: \d+ steps, \d+ evaluations; energy error [0-9.e-]+; worst residual [0-9.e-]+$"
        loud = self.simulate("--to", "1s", "--effort", "theta=1", "--format", "csv").err.splitlines()
        quiet = self.simulate("--to", "1s", "--effort", "theta=1", "--format", "csv", "--quiet").err.splitlines()
        self.assertRegex(loud[-1], pattern)
        self.assertRegex(loud[-2], r"^simulate: work of theta -?[0-9.e-]+ J$")
        self.assertEqual(quiet, loud[-1:])

    def test_all_methods_come_to_the_same(self):
        want = self.simulate("--to", "1s", "--steps", "1", "--tol", "1e-12", "--format", "csv").csv()[1][-1]
        for words in (["--method", "sdirk4"], ["--method", "rk4", "--step", "1ms"], ["--method", "dop853"]):
            got = self.simulate("--to", "1s", "--steps", "1", "--format", "csv", *words).csv()[1][-1]
            for a, b in zip(got, want):
                self.assertAlmostEqual(a, b, places=6, msg=str(words))

    def test_requests_that_cannot_be_met_are_refused(self):
        self.wrong(818, "simulate", self.pendulum)
        self.wrong(808, "simulate")
        for words in (["--to", "0s"], ["--to", "-1s"], ["--to", "1s", "--from", "2s"], ["--to", "1s", "--every", "0s"], ["--to", "1s", "--tol", "0"],
                      ["--to", "1s", "--tol", "1"], ["--to", "1s", "--step", "1ms"], ["--to", "1s", "--method", "euler"],
                      ["--to", "1s", "--method", "rk4", "--tol", "1e-6"], ["--to", "1s", "--every", "1e-9s"], ["--to", "1s", "--steps", "0"]):
            self.wrong(806, "simulate", self.pendulum, *words)
        self.wrong(817, "simulate", self.pendulum, "--to", "1s", "--steps", "3", "--every", "0.1s")
        self.wrong(706, "simulate", self.pendulum, "--to", "1s", "--plot", self.path("x.gif"))
        self.wrong(814, "simulate", self.pendulum, "--to", "1s", "--effort", "thata=1")
        self.assertEqual(Run("simulate", self.pendulum, "--to", "1 kg").code, 2)
        run = Run("simulate", self.pendulum, "--to", "1s", "--of", "theta,nothing")
        self.assertEqual([run.code, run.out], [2, ""])

    def test_a_machine_without_mass_does_not_move_by_itself(self):
        self.wrong(621, "simulate", self.four_bar, "--to", "1s")

    def test_stops_that_exclude_the_start_are_quoted_in_the_file(self):
        path = self.write("stops.yaml", PENDULUM + "stops: {theta: [-0.1, 0.2]}\n")
        run = self.wrong(622, "simulate", path, "--to", "1s")
        self.assertRegex(run.err, r"stops\.yaml:11:\d+: error: .*theta")
        self.assertIn("stops: {theta", run.err)

    def test_a_machine_that_does_not_go_together_is_exit_1(self):
        path = self.write("apart.yaml", HEAVY.replace("[120, 0]", "[20, 0]").replace("[80, 0]", "[20, 0]"))
        run = Run("simulate", path, "--to", "1s", "--format", "json")
        self.assertEqual(run.code, 1, run.err)
        self.assertEqual([run.json()["status"], run.json()["rows"]], ["no-assembly", []])
        self.assertIn("[E0601]", run.err)
        self.assertEqual(Run("simulate", path, "--to", "1s").out, "")

    def test_a_motion_that_ends_early_leaves_its_rows_with_exit_1(self):
        path = self.write("jamming.yaml", JAMMING)
        run = Run("simulate", path, "--to", "2s", "--every", "10ms", "--format", "csv")
        self.assertEqual(run.code, 1, run.err)
        rows = run.csv()[1]
        self.assertGreater(len(rows), 10)
        self.assertLess(rows[-1][0], 2)
        self.assertIn("[E0820]", run.err)
        self.assertRegex(run.err.splitlines()[-1], "^simulate: .* worst residual")
        answer = Run("simulate", path, "--to", "2s", "--every", "10ms", "--format", "json").json()
        self.assertEqual(answer["rows"], rows)
        self.assertEqual(answer["code"], "E0820")
        self.assertNotEqual(answer["status"], "ok")

    def test_the_same_request_gives_the_same_bytes(self):
        words = ["simulate", example("double-pendulum"), "--to", "5s", "--format", "json"]
        self.assertEqual(self.good(*words).out, self.good(*words).out)

    def test_o_writes_a_file_and_nothing_beside_it(self):
        shown = self.simulate("--to", "1s", "--format", "csv").out
        before = set(os.listdir(self.folder))
        run = self.simulate("--to", "1s", "--format", "csv", "-o", self.path("out.csv"))
        self.assertEqual([run.out, self.read("out.csv").decode()], ["", shown])
        self.assertEqual(set(os.listdir(self.folder)), before | {"out.csv"})

    def test_no_progress_and_no_colours_where_nobody_looks(self):
        self.assertNotIn("\r", self.simulate("--to", "1s").err)
        self.assertNotIn("\x1b", self.simulate("--to", "1s").err)


class Interruptions(Machine):
    """Simulations that would take long: the motor of the second link spins it faster and faster."""

    def start(self, *words, stdout=subprocess.PIPE, preexec=None):
        return subprocess.Popen([YOKE, "simulate", example("double-pendulum"), "--to", "9000s", *words], stdout=stdout,
                                stderr=subprocess.PIPE, encoding="utf-8", preexec_fn=preexec)

    def interrupted(self, process, number):
        time.sleep(0.4)
        process.send_signal(number)
        out, err = process.communicate(timeout=120)
        self.assertEqual(process.returncode, 1, err)
        self.assertRegex(err.splitlines()[-1], r"^simulate: interrupted at t = \S+ s; \d+ steps, .* worst residual")
        self.assertIn("[W0821]", err)
        return out

    def test_rows_so_far_come_whole(self):
        for number in (signal.SIGINT, signal.SIGTERM):
            out = self.interrupted(self.start("--every", "5s", "--format", "csv"), number)
            lines = out.split("\n")
            self.assertEqual([lines[0], lines[-1]], ["t,theta1,theta2,energy", ""])
            self.assertGreaterEqual(len(lines), 3)
            for k, line in enumerate(lines[1:-1]):
                self.assertEqual(float(line.split(",")[0]), 5 * k)
                self.assertEqual(line.count(","), 3)

    def test_an_interruption_does_not_wait_for_the_next_row(self):
        out = self.interrupted(self.start("--steps", "1"), signal.SIGINT)
        self.assertEqual(len(out.splitlines()), 4)  # title, blank, head, the row at t = 0

    def test_json_stays_whole_and_says_so(self):
        answer = json.loads(self.interrupted(self.start("--every", "5s", "--format", "json"), signal.SIGTERM))
        self.assertEqual([answer["status"], answer["code"]], ["interrupted", "W0821"])
        self.assertGreaterEqual(answer["summary"]["end"], answer["rows"][-1][0])

    def test_an_output_file_appears_with_the_rows_so_far(self):
        process = self.start("--every", "5s", "--format", "csv", "-o", self.path("out.csv"))
        time.sleep(0.4)
        self.assertFalse(os.path.exists(self.path("out.csv")))
        self.interrupted(process, signal.SIGINT)
        self.assertTrue(self.read("out.csv").endswith(b"\n"))
        self.assertFalse([name for name in os.listdir(self.folder) if name.endswith(".tmp")])

    def test_rows_are_seen_while_it_runs(self):
        process = self.start("--every", "0.5s", "--format", "csv")
        self.assertEqual(process.stdout.readline(), "t,theta1,theta2,energy\n")
        self.assertRegex(process.stdout.readline(), r"^0,")
        self.interrupted(process, signal.SIGINT)

    def full(self, target):
        """A disk with room for 5000 bytes."""
        def limit():
            resource.setrlimit(resource.RLIMIT_FSIZE, (5000, 5000))

        path = self.path("full.csv")
        words = ["--every", "1ms", "--format", "csv"]
        if target == "file":
            process = self.start(*words, "-o", path, preexec=limit)
        else:
            with open(path, "w", encoding="utf-8") as file:
                process = self.start(*words, stdout=file, preexec=limit)
        _, err = process.communicate(timeout=120)
        self.assertEqual(process.returncode, 2, err)
        self.assertIn("[E0704]", err)
        return self.read("full.csv").decode()

    def test_a_full_disk_leaves_whole_rows(self):
        for target in ("file", "standard output"):
            lines = self.full(target).split("\n")
            self.assertEqual(lines[-1], "")
            self.assertGreater(sum(map(len, lines)) + len(lines) - 1, 4900)
            self.assertEqual({line.count(",") for line in lines[:-1]}, {3})

    def test_a_closed_pipe_ends_it(self):
        process = self.start("--every", "1ms", "--format", "csv")
        process.stdout.readline()
        process.stdout.close()
        err = process.stderr.read()
        process.stderr.close()
        self.assertEqual(process.wait(timeout=120), 2)
        self.assertIn("[E0705]", err)


class Rest(Machine):
    def test_a_pendulum_rests_below_and_above(self):
        answer = self.good("rest", self.pendulum, "--format", "json").json()
        self.assertEqual([answer["status"], answer["free"]], ["ok", ["theta"]])
        below, above = answer["equilibria"]
        self.assertEqual([below["stability"], above["stability"]], ["stable", "unstable"])
        self.assertAlmostEqual(math.sin(below["coordinates"]["theta"]), 0, places=10)
        self.assertAlmostEqual(below["modes"][0]["frequency"], math.sqrt(GRAVITY), places=7)
        self.assertAlmostEqual(below["modes"][0]["hertz"], math.sqrt(GRAVITY) / (2 * math.pi), places=7)
        self.assertAlmostEqual(above["modes"][0]["frequency"], -math.sqrt(GRAVITY), places=7)
        self.assertIsNone(above["modes"][0]["hertz"])
        self.assertAlmostEqual(below["M"][0][0], 2, places=10)
        self.assertAlmostEqual(below["K"][0][0], 2 * GRAVITY, places=6)
        self.assertEqual(len(below["roots"]), 2)

    def test_an_equilibrium_outside_the_range_of_a_law_is_told(self):
        file = self.write("hung.yaml", """parameters: {m: 1}
gravity: [0, -9.81]
laws: {coil: {between: linear, table: [[20 mm, -8 N], [60 mm, 0 N], [100 mm, 12 N]]}}
bodies: {ground: {points: {O: [0, 0]}}, load: {points: {P: [0, 0]}, mass: m}}
joints: {S: {slide: [ground, load], along: -90 deg, distance: y}}
springs:
  coil: {along: y, force: {law: coil, of: length}}
  soft: {along: y, stiffness: 20 N/m, length: 50 mm}
""")
        inside = self.good("rest", file, "--format", "json")
        self.assertAlmostEqual(inside.json()["equilibria"][0]["coordinates"]["y"], (9.81 + 20 * 0.05 + 300 * 0.06) / 320, places=12)
        self.assertNotIn("laws_left", inside.json())
        self.assertNotIn("W0860", inside.err)
        outside = self.good("rest", file, "--param", "m=3kg", "--format", "json")
        place = 0.05 + (3 * 9.81 - 12) / 20
        self.assertAlmostEqual(outside.json()["equilibria"][0]["coordinates"]["y"], place, places=12)
        [left] = outside.json()["laws_left"]
        self.assertEqual([left[key] for key in ("law", "user", "of", "value", "at", "poses")], ["coil", "spring", "coil", 12, 1, 1])
        self.assertAlmostEqual(left["argument"], place, places=12)
        self.assertIn("hung.yaml:7:3: warning: the spring `coil` leaves the range of law `coil`, 0.02 m to 0.1 m: at %.4f m it keeps "
                      "its end value, 12 N; first at equilibrium = 1 [W0860]" % place, outside.err)

    def test_text_tells_frequencies_and_with_modes_the_matrices(self):
        text = self.good("rest", example("double-pendulum")).out
        self.assertIn("4 equilibria found", text)
        self.assertRegex(text, r"mode +frequency \[Hz\] +period \[s\] +damping ratio +growth \[1/s\] +theta1 +theta2")
        self.assertNotIn("K (SI)", text)
        self.assertIn("K (SI)", self.good("rest", example("double-pendulum"), "--modes").out)

    def motions(self, name, text):
        """The table of small motions with everything: [word, frequency, growth], by rows."""
        out = self.good("rest", self.write(name, text)).out.split("\n\n")
        tables = [part.splitlines()[2:] for part in out if "the small motions are:" in part]
        return [[line.split()[:-3], *[None if x == "-" else float(x) for x in (line.split()[-3], line.split()[-1])]]
                for lines in tables for line in lines]

    def test_damping_slows_the_growth_that_the_mode_has_without_it(self):
        rows = self.motions("oil.yaml", """gravity: [0, -9.81]
bodies:
  ground: {points: {O: [0, 0]}}
  bar: {points: {O: [0, 0]}, mass: 1, center: [0, 2], inertia: 0}
joints: {O: {pin: [ground, bar], angle: q, friction: {viscous: 50}}}
start: {q: 0.01}
""")
        rate, push = 50 / 4, GRAVITY / 2  # q'' + rate q' -+ push q = 0 above and below
        for (word, hertz, growth), sign, root in zip(rows, (1, 1, -1, -1), (1, -1, 1, -1)):
            expected = -rate / 2 + root * math.sqrt(rate ** 2 / 4 + sign * push)
            self.assertEqual(word, ["grows"] if expected > 0 else ["dies", "out"])
            self.assertIsNone(hertz)
            self.assertAlmostEqual(growth, expected, delta=1e-5 * abs(expected))
        self.assertEqual(len(rows), 4)

    def test_a_column_under_a_follower_load_flutters(self):
        # Ziegler 1952, masses 2 and 1: |K - w M| = 2 w^2 - w + 1 = 0 for w = -root^2, at a load of 3.
        rows = self.motions("column.yaml", """bodies:
  ground: {points: {O: [0, 0]}}
  a: {points: {O: [0, 0], A: [1, 0]}, mass: 2, center: [1, 0], inertia: 0}
  b: {points: {A: [0, 0], B: [1, 0]}, mass: 1, center: [1, 0], inertia: 0}
joints: {O: {pin: [ground, a], angle: q1}, A: {pin: [a, b], angle: q2}}
springs: {k1: {along: q1, stiffness: 1}, k2: {along: q2, stiffness: 1}}
forces: {P: {body: b, at: B, value: [-3, 0], axes: body}}
start: {q1: 0, q2: 0}
""")
        root = cmath.sqrt(-(1 + cmath.sqrt(1 - 8)) / 4)
        self.assertEqual(sorted(word for word, _, _ in rows), [["dies", "out"], ["grows"]])
        for _, hertz, growth in rows:
            self.assertAlmostEqual(hertz, abs(root.imag) / (2 * math.pi), places=5)
            self.assertAlmostEqual(abs(growth), abs(root.real), places=5)

    def test_modes_that_leave_nothing_out_stand_alone(self):
        self.assertNotIn("small motions", self.good("rest", example("double-pendulum")).out)

    def test_csv_has_a_line_for_each(self):
        lines = self.good("rest", self.pendulum, "--format", "csv").out.splitlines()
        self.assertEqual(lines[0], "equilibrium,stability,potential,theta,frequency1")
        self.assertEqual([line.split(",")[1] for line in lines[1:]], ["stable", "unstable"])

    def test_a_motor_that_is_too_strong_leaves_no_rest(self):
        run = Run("rest", self.pendulum, "--param", "tau=100 N*m", "--format", "json")
        self.assertEqual(run.code, 1)
        self.assertIn("[E0830]", run.err)
        self.assertEqual([run.json()["status"], run.json()["equilibria"], run.json()["code"]], ["no-equilibrium", [], "E0830"])

    def test_what_cannot_be_searched_is_refused(self):
        self.wrong(621, "rest", self.four_bar)
        self.wrong(806, "rest", self.pendulum, "--starts", "0")
        self.wrong(808, "rest")


if __name__ == "__main__":
    unittest.main()
