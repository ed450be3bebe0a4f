"""yoke study: grids, samples, sensitivities, threads, interruptions."""
import ast
import math
import os
import random
import resource
import signal
import statistics
import struct
import subprocess
import time
import unittest

from harness import Case, FEW, Run, ROOT, YOKE

EXAMPLES = os.path.join(ROOT, "examples")
TURN = "72" if FEW else "720"  # steps of a study that takes long enough to be interrupted

SUM = """\
units: {length: mm, angle: deg}
parameters: {a: 40, b: 30, c: 20}
bodies: {ground: {points: {O: [0, 0]}}, arm: {points: {O: [0, 0], P: [a + b - 2*c, 3*c]}}}
joints: {O: {pin: [ground, arm], angle: q}}
start: {q: 0}
"""

SAMPLE = """\
seed: 11
designs: 4000
parameters:
  a: {normal: [40, 0.5]}
  b: {uniform: [29, 32]}
  c: {triangular: [18, 20, 23]}
"""


# A six-bar without a dyad, and a five-bar whose wheels, on its links, close one group with its loops.
TRIAD = """\
parameters: {l: 4.5 m, r: 3 m}
bodies:
  ground: {points: {O2: [0, 0], O4: [4, 0], O6: [6, 2.5]}}
  crank: {points: {O2: [0, 0], A: [1, 0]}}
  coupler: {points: {A: [0, 0], B: [3.5, 0], C: [2, 1.5]}}
  rocker: {points: {O4: [0, 0], B: [r, 0]}}
  link: {points: {C: [0, 0], D: [l, 0]}}
  output: {points: {O6: [0, 0], D: [2.5, 0]}}
joints:
  O6: {pin: [ground, output], angle: theta6}
  D: {pin: [output, link], angle: theta5}
  O2: {pin: [ground, crank], angle: theta2}
  A: {pin: [crank, coupler], angle: theta3}
  O4: {pin: [ground, rocker], angle: theta4}
  B: {pin: [coupler, rocker]}
  C: {pin: [coupler, link]}
drives: {theta6: 120 deg + 0.1 rad/s * t}
start: {theta2: 120 deg, theta3: -90 deg, theta4: 119 deg, theta5: -101 deg}
"""

GEARED = """\
parameters: {p: 2.5 m, q: 2 m}
bodies:
  ground: {points: {A: [0, 0], E: [3, 0]}}
  a: {points: {A: [0, 0], B: [1, 0]}}
  b: {points: {C: [0, 0], B: [-p, 0]}}
  c: {points: {C: [0, 0], D: [q, 0]}}
  d: {points: {D: [0, 0], E: [2.2, 0]}}
joints:
  A: {pin: [ground, a], angle: t1}
  B: {pin: [a, b], angle: t2}
  C: {pin: [b, c], angle: t3}
  D: {pin: [c, d], angle: t4}
  E: {pin: [ground, d]}
gears: {g: {mesh: [b, d], teeth: [20, 30], carrier: c}}
drives: {t1: 60 deg + 1 rad/s * t}
start: {t2: -30 deg, t3: -60 deg, t4: -60 deg}
"""

CRANK = """\
parameters: {r: 50 mm, l: 180 mm}
bodies:
  ground: {points: {O: [0, 0]}}
  crank:  {points: {O: [0, 0], A: [r, 0]}}
  rod:    {points: {A: [0, 0], B: [l, 0]}}
  piston: {points: {B: [0, 0]}}
joints:
  O: {pin: [ground, crank], angle: theta}
  A: {pin: [crank, rod], angle: phi}
  B: {pin: [rod, piston]}
  S: {slide: [ground, piston], along: x, distance: s}
drives: {theta: 60 deg + 300 rpm * t}
start: {phi: -75 deg, s: 200 mm}
units: {length: mm, angle: deg}
"""


class Study(Case):
    def setUp(self):
        super().setUp()
        self.sum = self.write("sum.yaml", SUM)
        self.sample = self.write("sample.yaml", SAMPLE)

    def test_a_grid_has_every_combination_the_last_fastest(self):
        head, rows = self.table("--vary", "a=40:42:3", "--vary", "b=10mm:30mm:2", "--of", "arm.P.x,arm.P.y")
        self.assertEqual(head, ["design", "a", "b", "status", "poses", "arm.P.x", "arm.P.y"])
        self.assertEqual([row[:3] for row in rows],
                         [[str(k), a, b] for k, (a, b) in enumerate(
                             (a, b) for a in ("0.04", "0.041", "0.042") for b in ("0.01", "0.03"))])
        for row in rows:
            self.assertAlmostEqual(float(row[5]), float(row[1]) + float(row[2]) - 0.04, 15)

    def table(self, *words, file=None):
        out = self.good("study", file or self.sum, *words, "--format", "csv").out
        lines = [line.split(",") for line in out.splitlines()]
        return lines[0], lines[1:]

    def test_a_cycle_is_reduced(self):
        head, rows = self.table("--vary", "a=30:40:2", "--over", "q=0:360deg", "--steps", "360", "--of", "arm.P.x")
        self.assertEqual(head[4:], ["arm.P.x.min", "arm.P.x.max", "arm.P.x.mean", "arm.P.x.range"])
        for row in rows:
            reach = math.hypot(float(row[1]) + 0.03 - 0.04, 0.06)
            self.assertAlmostEqual(float(row[5]), reach, 5)
            self.assertAlmostEqual(float(row[7]), 2 * reach, 5)

    def test_samples_have_the_moments_of_their_distributions(self):
        _, rows = self.table("--sample", self.sample, "--of", "arm.P.x")
        self.assertEqual(len(rows), 4000)
        theory = [(0.04, 0.0005), (0.0305, 0.003 / math.sqrt(12)),
                  (0.061 / 3, math.sqrt((18**2 + 20**2 + 23**2 - 18 * 20 - 18 * 23 - 20 * 23) / 18) / 1000)]
        for k, (mean, deviation) in enumerate(theory):
            column = [float(row[1 + k]) for row in rows]
            self.assertLess(abs(statistics.fmean(column) - mean), 5 * deviation / math.sqrt(4000))
            self.assertLess(abs(statistics.stdev(column) / deviation - 1), 0.06)

    def test_the_same_seed_gives_the_same_bytes_on_any_threads(self):
        words = ["study", self.four_bar, "--vary", "a=20:60:301", "--over", "theta1=0:360deg", "--of", "theta3,coupler.P.x.rate",
                 "--format", "csv", "-q"]
        runs = [Run(*words, "--threads", n).out for n in ("1", "2", "3")]
        self.assertEqual(runs[0], runs[1])
        self.assertEqual(runs[0], runs[2])
        sample = ["study", self.sum, "--sample", self.sample, "--of", "arm.P.x", "--format", "csv"]
        first = self.good(*sample).out
        self.assertEqual(first, self.good(*sample, "--threads", "3").out)
        self.assertNotEqual(first, self.good(*sample, "--seed", "12").out)

    def test_worst_case_of_a_linear_answer_is_the_sum_of_its_parts(self):
        tolerances = self.write("t.yaml", "parameters: {a: {tolerance: 0.2}, b: {tolerance: 0.3 mm}, c: {tolerance: 0.1}}")
        answer = self.good("study", self.sum, "--sample", tolerances, "--designs", "2000", "--of", "arm.P.x,arm.P.y",
                           "--sensitivities", "--format", "json").json()
        found = answer["sensitivities"]["arm.P.x"]
        for name, exact in (("a", 1), ("b", 1), ("c", -2)):
            self.assertAlmostEqual(found[name]["derivative"], exact, 11)
            self.assertAlmostEqual(found[name]["difference"], exact, 11)
        self.assertAlmostEqual(found["worst"], 0.0002 + 0.0003 + 2 * 0.0001, 14)
        self.assertAlmostEqual(found["root"], math.sqrt(0.2**2 + 0.3**2 + 0.2**2) / 1000 / math.sqrt(3), 14)
        spread = answer["answers"]["arm.P.x"]
        self.assertLessEqual(spread["largest"] - 0.03, found["worst"])
        self.assertLess(abs(spread["deviation"] / found["root"] - 1), 0.06)

    def test_sensitivities_of_what_has_no_value_are_not_told(self):
        """Where a parallelogram is flat, its torque has no value: neither a number nor "nan" stands in its place."""
        path = self.write("flat.yaml", """\
parameters: {r: 2 m}
bodies:
  ground:  {points: {O: [0, 0], C: [4, 0]}}
  crank:   {points: {O: [0, 0], A: [r, 0]}, mass: 1 kg, center: [1, 0]}
  coupler: {points: {A: [0, 0], B: [4, 0]}}
  rocker:  {points: {C: [0, 0], B: [r, 0]}}
joints:
  O: {pin: [ground, crank], angle: theta}
  A: {pin: [crank, coupler], angle: alpha}
  C: {pin: [ground, rocker], angle: psi}
  B: {pin: [coupler, rocker]}
gravity: [0, -10 m/s^2]
drives: {theta: 60 deg + 60 deg/s * t}
start: {alpha: -60 deg, psi: 60 deg}
""")
        words = ("study", path, "--vary", "r=1.9m:2.1m:3", "--time", "2s", "--of", "theta.effort", "--sensitivities")
        self.assertIn("theta.effort at the file's values and pose: not determined", self.good(*words).out)
        self.assertNotIn("nan", self.good(*words).out)
        near = self.good(*words[:5], "1.9s", *words[6:]).out
        self.assertRegex(near, r"theta.effort at the file's values and pose: worst case \+- \d")

    def test_designs_that_do_not_stand_are_rows_with_a_status(self):
        head, rows = self.table("--vary", "a=20:300:7", "--of", "theta3,theta3.rate", file=self.four_bar)
        statuses = [row[2] for row in rows]
        self.assertIn("ok", statuses)
        self.assertIn("no-assembly", statuses)  # at the pose of `start:`
        for row in rows:
            self.assertEqual(row[4:] == ["", ""], row[2] == "no-assembly")
            self.assertEqual(row[3], "0" if row[2] == "no-assembly" else "1")
        self.assertNotIn("nan", str(rows).lower())
        run = Run("study", self.four_bar, "--vary", "a=280:300:3", "--of", "theta3")
        self.assertEqual(run.code, 1)
        self.assertIn("W0826", run.err)

    def test_a_design_that_makes_no_machine_says_why(self):
        run = Run("study", os.path.join(EXAMPLES, "epicyclic.yaml"), "--vary", "N1=27:28:3", "--of", "theta4")
        self.assertEqual(run.code, 0)
        self.assertIn("design 1 (N1 = 27.5) makes no machine: ", run.err)
        self.assertIn("27.5 is not a number of teeth", run.err)
        self.assertIn("[E0462]", run.err)

    def test_a_parameter_of_a_drive_is_refused_at_its_place(self):
        path = self.write("driven.yaml", "parameters: {w: 10}\nbodies: {arm: {points: {P: [1, 0]}}}\n"
                         "joints: {O: {pin: [ground, arm], angle: q}}\ndrives: {q: 1 + w*t}\n")
        run = Run("study", path, "--vary", "w=1:2:3", "--of", "arm.P.x")
        self.assertEqual(run.code, 2)
        self.assertIn("driven.yaml:4:", run.err)
        self.assertIn("drives: {q: 1 + w*t}\n", run.err)
        self.assertIn("[E0508]", run.err)

    def test_npy_is_what_csv_says(self):
        path = os.path.join(self.folder, "out.npy")
        self.good("study", self.four_bar, "--vary", "a=20:300:7", "--of", "theta3", "-o", path, "-q")
        with open(path, "rb") as file:
            data = file.read()
        self.assertEqual(data[:8], b"\x93NUMPY\x01\x00")
        length = struct.unpack("<H", data[8:10])[0]
        self.assertEqual((10 + length) % 64, 0)
        head = ast.literal_eval(data[10:10 + length].decode())
        self.assertEqual(head["shape"], (7,))
        self.assertEqual([field for field, kind in head["descr"]], ["a", "status", "poses", "theta3"])
        values = struct.unpack("<28d", data[10 + length:])
        _, rows = self.table("--vary", "a=20:300:7", "--of", "theta3", file=self.four_bar)
        for k, row in enumerate(rows):
            self.assertEqual(values[4 * k], float(row[1]))
            self.assertEqual(values[4 * k + 1], {"ok": 0, "no-assembly": -2}[row[2]])
            self.assertEqual(repr(values[4 * k + 3]), row[4] and repr(float(row[4])) or "nan")

    def agree(self, file, grids, where, of, most=0.0):
        """Every design of the grids at a place is what `solve` says of the file with these parameters there."""
        study = Run("study", file, *(word for grid in grids for word in ("--vary", grid)), *where, "--of", of, "--format", "csv", "-q")
        self.assertIn(study.code, (0, 1), study.err)  # 1: none stands
        head, *rows = [line.split(",") for line in study.out.splitlines()]
        stand = 0
        for row in rows:
            params = [word for k in range(len(grids)) for word in ("--param", f"{head[1 + k]}={row[1 + k]} m")]
            alone = Run("solve", file, *params, *where, "--of", of, "--format", "csv", "-q")
            design = (file, params, where)
            status, answers = row[1 + len(grids)], row[3 + len(grids):]
            self.assertEqual(alone.code, 0 if status in ("ok", "singular") else 1, design)
            if alone.code != 0:
                self.assertIn(status, ("limit", "no-assembly"), design)
                continue
            stand += 1
            exact = alone.out.splitlines()[-1].split(",")[1:]
            if most == 0:
                self.assertEqual(answers, exact, design)
            for mine, theirs in zip(answers, exact):
                self.assertLessEqual(abs(float(mine) - float(theirs)), most * max(1, abs(float(theirs))), design)
        return stand, len(rows) - stand

    def test_every_design_is_what_solve_says_of_it(self):
        four_bar, jansen, quick, five, peaucellier = (
            os.path.join(EXAMPLES, name + ".yaml") for name in ("four-bar", "jansen", "quick-return", "five-bar", "peaucellier"))
        triad, geared = self.write("triad.yaml", TRIAD), self.write("geared.yaml", GEARED)
        of = "gamma,theta4,theta4.rate,theta4.accel,coupler.P.x"
        stand, fall = 0, 0
        for words in ((four_bar, ["a=30mm:75mm:4"], ["--at", "theta2=500deg"], of),
                      (four_bar, ["a=30mm:45mm:3", "c=70mm:90mm:2"], ["--time", "1.7s"], of),
                      (four_bar, ["a=38mm:44mm:3"], ["--at", "theta4=100deg"], "theta2,gamma,coupler.P.y"),
                      (four_bar, ["a=38mm:44mm:3"], ["--at", "theta4=-90deg"], "theta2,gamma,coupler.P.y"),
                      (four_bar, ["d=20mm:140mm:4"], ["--at", "theta2=-400deg", "--rate", "theta2=3rad/s"], of),
                      (jansen, ["m=12mm:20mm:3"], ["--at", "theta=-300deg"], "theta,thetaJ,thetaK,thetaG,thetaG.rate"),
                      (quick, ["l1=0.6m:1.2m:3"], ["--at", "theta1=-250deg"], "theta2,theta4,d5,d5.accel"),
                      (peaucellier, ["s=1.2m:1.6m:3"], ["--at", "theta=-25deg"], "theta,theta.rate"),
                      (five, ["a=190mm:230mm:3"], ["--at", "theta1=150deg", "--at", "theta2=20deg"], "phi1,phi2,phi2.rate")):
            here, gone = self.agree(*words)
            stand, fall = stand + here, fall + gone
        self.assertGreater(stand, 20)
        self.assertGreater(fall, 5)
        for words in ((triad, ["l=4.4m:4.6m:3", "r=2.95m:3.05m:2"], ["--at", "theta6=112deg"], "theta2,theta3,theta5,theta5.rate"),
                      (geared, ["p=2.3m:2.6m:3"], ["--at", "t1=200deg"], "t2,t3,t4,t4.rate")):
            self.agree(*words, most=1e-12)

    def test_a_cycle_is_that_of_the_sweep(self):
        crank = self.write("crank.yaml", CRANK)
        for steps, way in (("36", "0:360deg"), ("7", "-90deg:800deg"), ("360", "360deg:0")):
            _, rows = self.table("--vary", "r=40mm:60mm:3", "--over", "theta=" + way, "--steps", steps, "--of",
                                 "s,phi,s.rate", file=crank)
            for row in rows:
                swept = self.good("sweep", crank, "--param", f"r={row[1]} m", "--over", "theta=" + way, "--steps", steps,
                                  "--of", "s,phi,s.rate", "--format", "csv", "-q").csv()[1]
                self.assertEqual(row[3], str(len(swept)))
                for c in range(3):
                    column = [line[1 + c] for line in swept]
                    self.assertEqual([float(x) for x in row[4 + 4 * c:6 + 4 * c]], [min(column), max(column)])
                    self.assertAlmostEqual(float(row[6 + 4 * c]), statistics.fmean(column), 12)

    def test_a_design_keeps_to_the_range_in_which_it_was_put_together(self):
        """The rocker's label is the same in [-128.7, -54.9] and in [54.9, 128.7] deg."""
        _, rows = self.table("--vary", "a=39mm:41mm:3", "--over", "theta4=-180deg:180deg", "--steps", "360", "--of",
                             "theta4,theta2", "-q", file=os.path.join(EXAMPLES, "four-bar.yaml"))
        for row in rows:
            a = float(row[1])
            low, high = (math.acos(((0.12 + way * a)**2 - 0.01 - 0.0064) / 0.016) for way in (1, -1))
            within = [k for k in range(-180, 181) if low < math.radians(k) < high]
            self.assertEqual((row[2], row[3]), ("limit", str(len(within))))
            self.assertAlmostEqual(math.degrees(float(row[4])), within[0], 9)
            self.assertAlmostEqual(math.degrees(float(row[5])), within[-1], 9)

    def test_sensitivities_are_those_of_the_asked_pose(self):
        crank = self.write("crank.yaml", CRANK)
        found = self.good("study", crank, "--vary", "r=49mm:51mm:2", "--at", "theta=240deg", "--of", "s", "--sensitivities",
                          "--format", "json").json()["sensitivities"]["s"]["r"]
        sine, cosine = math.sin(math.radians(240)), math.cos(math.radians(240))
        exact = cosine - 0.05 * sine**2 / math.sqrt(0.18**2 - (0.05 * sine)**2)
        self.assertAlmostEqual(found["derivative"], exact, 9)
        self.assertAlmostEqual(found["difference"], exact, 9)

    def test_an_interrupted_study_goes_on_to_the_same_bytes(self):
        path, whole = os.path.join(self.folder, "out.csv"), os.path.join(self.folder, "whole.csv")
        words = ["study", self.four_bar, "--vary", "a=20:60:60000", "--over", "theta1=0:360deg", "--steps", TURN, "--of",
                 "theta3,coupler.P.x", "--threads", "1", "-o"]
        self.good(*words, whole)
        with subprocess.Popen([YOKE, *words, path], stderr=subprocess.PIPE) as child:
            deadline = time.monotonic() + 60
            while time.monotonic() < deadline and child.poll() is None:
                if os.path.exists(path + ".partial") and os.path.getsize(path + ".partial") > 20000:
                    child.send_signal(signal.SIGINT)
                    break
                time.sleep(0.002)
            said = child.communicate()[1].decode()
        self.assertEqual(child.returncode, 1, said)
        self.assertIn("interrupted", said)
        self.assertFalse(os.path.exists(path))
        with open(path + ".partial", "ab") as file:
            file.write(b"half a row")
        other = Run(*[word.replace("60000", "60001") for word in words], path)
        self.assertEqual(other.code, 2)
        self.assertIn("E0825", other.err)
        self.good(*words, path)
        with open(path, "rb") as a, open(whole, "rb") as b:
            self.assertEqual(a.read(), b.read())
        self.assertFalse(os.path.exists(path + ".partial"))

    def test_what_is_not_the_study_s_stays(self):
        """An empty folder in the way is refused, not removed."""
        path = os.path.join(self.folder, "in-the-way.csv")
        os.mkdir(path + ".partial")
        done = Run("study", self.four_bar, "--vary", "a=39mm:41mm:3", "--of", "theta3", "-o", path)
        self.assertEqual(done.code, 2)
        self.assertIn("E0703", done.err)
        self.assertTrue(os.path.isdir(path + ".partial"))

    def test_a_killed_study_goes_on_too(self):
        path = os.path.join(self.folder, "out.csv")
        words = ["study", self.four_bar, "--vary", "a=20:60:60000", "--over", "theta1=0:360deg", "--steps", TURN, "--of",
                 "theta3", "-o", path]
        with subprocess.Popen([YOKE, *words]) as child:
            while child.poll() is None and not (os.path.exists(path + ".partial") and
                                                os.path.getsize(path + ".partial") > 5000):
                time.sleep(0.002)
            child.kill()
        self.good(*words)
        with open(path, encoding="utf-8") as file:
            self.assertEqual(sum(1 for _ in file), 60001)

    def limited(self, size, *words):
        """A run that may write no file larger than so many bytes: what a full disk does, at a place that is known."""
        done = subprocess.run([YOKE, *words], capture_output=True, encoding="utf-8", timeout=120, check=False,
                              preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (size, size)))
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertIn("[E0704]", done.stderr)
        return done.stderr

    def test_what_a_full_disk_leaves_is_told_and_goes_on(self):
        path, whole = os.path.join(self.folder, "out.csv"), os.path.join(self.folder, "whole.csv")
        words = ["study", self.four_bar, "--vary", "a=20:60:20000", "--of", "theta3,theta2", "--threads", "1", "-o"]
        self.good(*words, whole)
        size = os.path.getsize(whole)
        said = self.limited(200000, *words, path) # the partial file does not fit
        self.assertIn("out.csv.partial", said)
        self.assertIn("continues from there", said)
        self.assertTrue(0 < os.path.getsize(path + ".partial") <= 200000)
        said = self.limited(size - 1, *words, path) # the rows do, but not their text
        self.assertIn("continues from there", said)
        self.assertFalse(os.path.exists(path))
        self.assertTrue(os.path.exists(path + ".partial"))
        self.good(*words, path)
        self.assertFalse(os.path.exists(path + ".partial"))
        with open(path, "rb") as a, open(whole, "rb") as b:
            self.assertEqual(a.read(), b.read())
        said = self.limited(10, *words, path) # not even its head: nothing is left, and none is told
        self.assertNotIn("continues from there", said)
        self.assertFalse(os.path.exists(path + ".partial"))

    def test_what_was_overwritten_is_computed_again(self):
        """64 bytes or a bit anywhere behind the head: it is noticed, and the table comes out the same."""
        path, whole = os.path.join(self.folder, "out.csv"), os.path.join(self.folder, "whole.csv")
        words = ["study", self.four_bar, "--vary", "a=20:60:8000", "--of", "theta3", "--threads", "1", "-o"]
        self.good(*words, whole)
        with open(whole, "rb") as file:
            wanted = file.read()
        self.limited(100000, *words, path)
        with open(path + ".partial", "rb") as file:
            left = file.read()
        width = struct.calcsize("<4d") # of a row: the parameter, status, how many poses stand, the output
        end = 64                       # of the blocks that are whole
        while end + 16 <= len(left) and end + 16 + width * int.from_bytes(left[end:end + 8], "little") <= len(left):
            end += 16 + width * int.from_bytes(left[end:end + 8], "little")
        self.assertGreater(end, 20000)
        numbers = random.Random(5)
        places = [64, 65, 72, 80, 96, end // 2, end - 64] + [numbers.randrange(64, end - 64) for _ in range(6)]
        damages = [left[:at] + bytes(numbers.randrange(256) for _ in range(64)) + left[at + 64:] for at in places]
        damages += [left[:at] + bytes([left[at] ^ 1]) + left[at + 1:] for at in places] # one bit
        damages += [left[:64] + bytes(len(left) - 64)]                                   # a disk that lost what was written
        for damaged in damages[::5 if FEW else 1]:
            with open(path + ".partial", "wb") as file:
                file.write(damaged)
            run = self.good(*words, path)
            self.assertIn("W0828", run.err)
            with open(path, "rb") as file:
                self.assertEqual(file.read(), wanted)
        with open(path + ".partial", "wb") as file: # as it was left, its last block a half one: nothing is wrong with it
            file.write(left)
        run = self.good(*words, path)
        self.assertNotIn("W0828", run.err)
        with open(path, "rb") as file:
            self.assertEqual(file.read(), wanted)

    def test_what_is_wrong_is_told_with_its_place(self):
        def refuse(code, *words, file=None):
            self.wrong(code, "study", file or self.sum, *words)
        refuse(818, "--of", "arm.P.x")
        refuse(818, "--vary", "a=1:2:3")
        refuse(806, "--vary", "a=1:2", "--of", "arm.P.x")
        refuse(806, "--vary", "a=1:2:0", "--of", "arm.P.x")
        refuse(412, "--vary", "z=1:2:3", "--of", "arm.P.x")
        refuse(321, "--vary", "a=1 deg:2 deg:3", "--of", "arm.P.x")
        refuse(505, "--vary", "a=1:2:3", "--of", "arm.Q.x")
        refuse(817, "--vary", "a=1:2:3", "--sample", self.sample, "--of", "arm.P.x")
        for text in ("parameters: {a: {uniform: [41, 40]}}", "parameters: {a: {normal: [41]}}", "parameters: {a: 3}",
                     "parameters: {a: {uniform: [1, 2], within: [1, 2]}}", "designs: -1\nparameters: {a: {tolerance: 1}}",
                     "parameters: {a: {normal: [0, 1], within: [50, 60]}}", "parameters: {a: {tolerance: 0}}", "x: 1",
                     "sed: 1\nparameters: {a: {tolerance: 1}}"):
            refuse(824, "--sample", self.write("bad.yaml", text), "--of", "arm.P.x")
        driven = self.write("driven.yaml", SUM.replace("start: {q: 0}", "drives: {q: a/b * t * 1 rad/s}"))
        refuse(508, "--vary", "a=1:2:3", "--of", "arm.P.x", file=driven)


class FullStrokes(Case):
    """A piston driven over its full stroke takes its crank round: in closed form, the crank is in the half turn of the drive's phase."""

    MACHINE = """\
parameters: {m: 1 kg, r: 30 mm}
bodies:
  ground:  {points: {O: [0, 0]}}
  crank:   {points: {O: [0, 0], A: [r, 0]}, mass: m, inertia: 1e-4 kg*m^2, center: [0, 0]}
  coupler: {points: {A: [0, 0], B: [80 mm, 0]}, mass: 0.2 kg, inertia: 1e-4 kg*m^2, center: [40 mm, 0]}
  piston:  {points: {B: [0, 0]}, mass: 0.3 kg, inertia: 1e-4 kg*m^2}
joints:
  O: {pin: [ground, crank], angle: theta}
  A: {pin: [crank, coupler]}
  B: {pin: [coupler, piston]}
  S: {slide: [ground, piston], along: x, from: O, to: B, distance: s}
drives: {s: 80 mm + 30 mm * cos(1 rad/s * t + 1 rad)}
start: {theta: 60 deg, A.angle: -90 deg}
"""

    def crank(self, t, r=0.03):
        phase, l = t + 1, 0.08
        s = 0.08 + 0.03 * math.cos(phase)
        angle = math.acos(max(-1, min(1, (s * s + r * r - l * l) / (2 * r * s))))
        turns = 2 * math.pi * math.floor(phase / (2 * math.pi))
        return turns + angle if math.sin(phase) >= 0 else turns + 2 * math.pi - angle

    def study(self, *words):
        return self.good("study", self.write("piston.yaml", self.MACHINE), *words, "--format", "json").json()

    def test_every_pose_is_where_the_drive_takes_it(self):
        for t in (0.5, 2, 2.3, 4, 5.2, 5.4, 8, 20, 500):
            for row in self.study("--vary", "m=1kg:2kg:2", "--time", "%rs" % t, "--of", "theta")["rows"]:
                self.assertAlmostEqual(row[3], self.crank(t), places=10, msg=t)

    def test_a_range_of_poses(self):
        """Longer than a block of poses, and with poses just at the dead points."""
        for end, steps in ((20, 400), (4 * (math.pi - 1), 8), (3, 7)):
            answer = self.study("--vary", "m=1kg:2kg:2", "--over", "t=0:%rs" % end, "--steps", str(steps), "--of", "theta")
            values = [self.crank(end * k / steps) for k in range(steps + 1)]
            for row in answer["rows"]:
                self.assertEqual(row[2], steps + 1)
                for got, wanted in zip(row[3:], (min(values), max(values), sum(values) / len(values))):
                    self.assertAlmostEqual(got, wanted, places=6)  # at a dead point, the root of rounding

    def test_designs_with_other_strokes(self):
        """A longer crank turns back with the drive before its dead point; a shorter one does not close."""
        answer = self.study("--vary", "r=29mm:31mm:3", "--over", "t=0:6s", "--steps", "60", "--of", "theta")
        short, own, long = answer["rows"]
        self.assertEqual([short[1], own[1], long[1]], ["limit", "ok", "ok"])
        self.assertAlmostEqual(own[4], self.crank(6), places=9)
        s = 0.08 + 0.03 * math.cos(math.floor((math.pi - 1) * 10 + 0.5) / 10 + 1)  # of the row nearest to the turn
        self.assertAlmostEqual(long[4], math.acos((s * s + 0.031**2 - 0.08**2) / (2 * 0.031 * s)), places=10)

    def test_what_cannot_follow_is_refused(self):
        file = self.write("piston.yaml", self.MACHINE)
        for words in (("--sensitivities",), ("--assembly", "nearest"), ("--over", "s=60mm:90mm")):
            run = self.wrong(646, "study", file, "--vary", "m=1kg:2kg:2", "--of", "theta", "--time", "4s", *words)
            self.assertIn("t = 2.14159 s", run.err)  # pi - 1
            self.assertIn("cannot follow it", run.err)


if __name__ == "__main__":
    unittest.main()
