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

from harness import Case, Run, YOKE

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

    def test_designs_that_do_not_stand_are_rows_with_a_status(self):
        head, rows = self.table("--vary", "a=20:300:7", "--of", "theta3,theta3.rate", file=self.four_bar)
        statuses = [row[2] for row in rows]
        self.assertIn("ok", statuses)
        self.assertIn("limit", statuses)
        for row in rows:
            self.assertEqual(row[4:] == ["", ""], row[2] == "limit")
            self.assertEqual(row[3], "0" if row[2] == "limit" else "1")
        self.assertNotIn("nan", str(rows).lower())
        run = Run("study", self.four_bar, "--vary", "a=280:300:3", "--of", "theta3")
        self.assertEqual(run.code, 1)
        self.assertIn("W0826", run.err)

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
            self.assertEqual(values[4 * k + 1], {"ok": 0, "limit": -1}[row[2]])
            self.assertEqual(repr(values[4 * k + 3]), row[4] and repr(float(row[4])) or "nan")

    def test_an_interrupted_study_goes_on_to_the_same_bytes(self):
        path, whole = os.path.join(self.folder, "out.csv"), os.path.join(self.folder, "whole.csv")
        words = ["study", self.four_bar, "--vary", "a=20:60:60000", "--over", "theta1=0:360deg", "--steps", "720", "--of",
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
        words = ["study", self.four_bar, "--vary", "a=20:60:60000", "--over", "theta1=0:360deg", "--steps", "720", "--of",
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
        self.assertIn("goes on from there", said)
        self.assertTrue(0 < os.path.getsize(path + ".partial") <= 200000)
        said = self.limited(size - 1, *words, path) # the rows do, but not their text
        self.assertIn("goes on from there", said)
        self.assertFalse(os.path.exists(path))
        self.assertTrue(os.path.exists(path + ".partial"))
        self.good(*words, path)
        self.assertFalse(os.path.exists(path + ".partial"))
        with open(path, "rb") as a, open(whole, "rb") as b:
            self.assertEqual(a.read(), b.read())
        said = self.limited(10, *words, path) # not even its head: nothing is left, and none is told
        self.assertNotIn("goes on from there", said)
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
        for damaged in damages:
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


if __name__ == "__main__":
    unittest.main()
