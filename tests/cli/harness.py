"""Shared by the tests of the command: running the binary, and reading its answers strictly."""
import csv
import io
import json
import os
import subprocess
import tempfile
import unittest
import zlib

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..")
YOKE = os.environ.get("YOKE", "yoke")
FULL = "YOKE_FULL" in os.environ  # all that the gate takes samples of
FEW = "YOKE_FEW" in os.environ  # under the sanitizers, whose answers are the same and take long
SAMPLED = FEW and "YOKE_EVERY" not in os.environ  # then one test of three, chosen by its name; `tools/test full` runs all

FOUR_BAR = """\
name: Test four-bar
units: {length: mm, angle: deg}
parameters: {a: 40}
bodies:
  ground:  {points: {O: [0, 0], C: [100, 0]}}
  crank:   {points: {O: [0, 0], A: [a, 0]}}
  coupler: {points: {A: [0, 0], B: [120, 0], P: [60, 50]}}
  rocker:  {points: {C: [0, 0], B: [80, 0]}}
joints:
  O: {pin: [ground, crank], angle: theta1}
  A: {pin: [crank, coupler], angle: theta2}
  C: {pin: [ground, rocker], angle: theta3}
  B: {pin: [coupler, rocker]}
drives: {theta1: 60 + 90 deg/s * t}
start: {theta2: -20, theta3: 90}
"""

# Ground 100, crank 90, coupler 60, rocker 40: the crank cannot turn through.
ROCKER = FOUR_BAR.replace("a: 40", "a: 90").replace("B: [120, 0]", "B: [60, 0]").replace("B: [80, 0]", "B: [40, 0]").replace(
    "theta1: 60 + 90 deg/s * t", "theta1: 20 + 90 deg/s * t").replace("theta2: -20", "theta2: -60")


def some(examples):
    """All examples, or one of four under the sanitizers."""
    return examples[::4] if FEW else examples


# Machines added since samples of every third one were chosen: a new one must not move the others into or out of a sample.
LATER = ("arc-cam", "formula-cam", "planetary-gear")


def third(examples, first):
    """Every third example, from the one of this number, and all later ones."""
    def is_later(path):
        return os.path.basename(path)[:-5] in LATER
    return [path for path in examples if not is_later(path)][first::3] + [path for path in examples if is_later(path)]


def sampled(examples, first):
    """All examples in full, one of four under the sanitizers, in the gate every third one from the one of this number."""
    return examples if FULL and not FEW else examples[::4] if FEW else third(examples, first)


def at_least(count):
    """How many cases of all examples a test must have seen, or of those of `some`."""
    return count // 8 if FEW else count


kinds = set()  # what this test has run


def sanitizer(words):
    """The environment of a call under the sanitizers: the first one of each verb with these options is searched for leaks, which takes
    as long as the rest of a small call."""
    kind = words[:1] + tuple(sorted(word.split("=")[0] for word in words if word.startswith("-")))
    options = os.environ.get("ASAN_OPTIONS", "")
    if not FEW or kind not in kinds:
        kinds.add(kind)
        return {}
    return {"ASAN_OPTIONS": options + ":detect_leaks=0"}


class Run:
    """One call of the command: its exit code and both streams, as text."""

    def __init__(self, *words, stdin=None, env=None, cwd=None):
        environment = dict(os.environ, **sanitizer(words), **(env or {}))
        done = subprocess.run([YOKE, *words], input=stdin, capture_output=True, env=environment, timeout=120, cwd=cwd,
                              encoding="utf-8", check=False)
        self.code, self.out, self.err = done.returncode, done.stdout, done.stderr

    def json(self):
        """The answer as JSON; NaN and Infinity, which Python would take, are errors."""
        return json.loads(self.out, parse_constant=refuse_constant)

    def csv(self):
        """Head and rows, empty fields as None."""
        lines = list(csv.reader(io.StringIO(self.out)))
        return lines[0], [[float(field) if field else None for field in line] for line in lines[1:]]


def refuse_constant(word):
    raise ValueError("JSON has no %s" % word)


class Case(unittest.TestCase):
    """A test with a folder of its own, which holds a four-bar that turns and one that does not."""

    def setUp(self):
        if SAMPLED and zlib.crc32(("%s.%s" % (type(self).__name__, self._testMethodName)).encode()) % 3:
            self.skipTest("not in the sample of the sanitizers")
        folder = tempfile.TemporaryDirectory(prefix="yoke-test-")
        self.addCleanup(folder.cleanup)
        self.folder = folder.name
        self.four_bar = self.write("four-bar.yaml", FOUR_BAR)
        self.rocker = self.write("rocker.yaml", ROCKER)

    def path(self, name):
        return os.path.join(self.folder, name)

    def write(self, name, text):
        with open(self.path(name), "w", encoding="utf-8") as file:
            file.write(text)
        return self.path(name)

    def read(self, name):
        with open(self.path(name), "rb") as file:
            return file.read()

    def good(self, *words, **options):
        run = Run(*words, **options)
        self.assertEqual(run.code, 0, run.err)
        return run

    def wrong(self, code, *words, **options):
        """Exit 2 with this code on standard error, and nothing on standard output."""
        run = Run(*words, **options)
        self.assertEqual(run.code, 2, run.out + run.err)
        self.assertIn("[E%04d]" % code, run.err)
        self.assertEqual(run.out, "")
        return run
