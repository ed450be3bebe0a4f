"""One meaning of a pose: whatever verb is asked, and by whatever way, the machine stands on the assembly that was meant.

Sweeps over three turns, forwards and backwards, against `solve --at`, `derive --numbers` and `study --at` at their rows, and
sweeps over time against `solve --time`: the same bits where the machine is made of dyads, the same configuration within
1e-12 of the machine's size where it has larger groups. A row that the sweep does not reach is refused by the others."""
import glob
import math
import os
import random
import re
import unittest

from harness import ROOT, Case, Run

FULL = os.environ.get("YOKE_FULL") == "1"
FEW = "YOKE_FEW" in os.environ  # under the sanitizers
TURN = 2 * math.pi
STEPS = 15  # 72 degrees each: three turns


# An arm on a pin: no loop, and a drive that swings 1.6e8 times a second.
ARM = """\
bodies:
  ground: {points: {O: [0, 0]}}
  arm:    {points: {O: [0, 0]}, mass: 1, center: [1, 0]}
joints: {O: {pin: [ground, arm], angle: theta}}
drives: {theta: sin(1e9 rad/s * t)}
"""

NEAR = """\
parameters: {a: 1}
bodies:
  ground:  {points: {O: [0, 0], C: [3, 0]}}
  crank:   {points: {O: [0, 0], A: [a, 0]}}
  coupler: {points: {A: [0, 0], B: [2.5, 0]}}
  rocker:  {points: {C: [0, 0], B: [2, 0]}}
joints:
  O: {pin: [ground, crank], angle: theta}
  A: {pin: [crank, coupler], angle: phi}
  C: {pin: [ground, rocker], angle: psi}
  B: {pin: [coupler, rocker]}
start: {theta: 60 deg, phi: -78 deg}
"""


def check(file):
    run = Run("check", file, "--format", "json", "--quiet")
    return run.json() if run.code == 0 else None


class Poses(Case):
    def coordinates(self, file, *words):
        run = Run("solve", file, *words, "--format", "json", "--quiet")
        if run.code != 0:
            return None
        answer = run.json()["configurations"][0]
        self.assertTrue(answer["is_start"])
        self.assertEqual(answer["reached"], "moved")
        return {name: motion["position"] for name, motion in answer["coordinates"].items()}

    def sweep(self, file, over, start, end, steps, names, unit):
        run = Run("sweep", file, "--over", "%s=%r%s:%r%s" % (over, start, unit, end, unit), "--steps", str(steps), "--of",
                  ",".join(names), "--format", "csv", "--quiet")
        self.assertIn(run.code, (0, 1), run.err)
        return run.csv()[1]

    def compare(self, file, words, expected, is_exact, what):
        got = self.coordinates(file, *words)
        self.assertIsNotNone(got, "%s: %s: solve refuses what the sweep reaches" % (file, words))
        for name, value in expected.items():
            allowed = 0 if is_exact else 1e-12 * max(1, abs(value))
            self.assertLessEqual(abs(got[name] - value), allowed, "%s, %s: %s by %s is %r, of the sweep %r" % (
                file, words, name, what, got[name], value))

    def walk_input(self, file, info, coordinate, rng):
        names = [c["name"] for c in info["coordinates"]]
        is_exact = coordinate["input"] and not any(block["kind"] == "group" for block in info["blocks"])
        is_angle = coordinate["kind"] == "angle"
        unit = "rad" if is_angle else "m"
        here = self.coordinates(file)
        self.assertIsNotNone(here, file)
        at = here[coordinate["name"]]
        for way in (1, -1):
            span = way * (3 * TURN if is_angle else 0.3 * self.size(file))
            rows = self.sweep(file, coordinate["name"], at, at + span, STEPS, names, unit)
            if not rows:  # put together at a dead point of this coordinate: no verb says which way it leaves
                beside = "%s=%r%s" % (coordinate["name"], at + 0.01 * span, unit)
                self.assertIsNone(self.coordinates(file, "--at", beside), file)
                continue
            wanted = range(len(rows)) if FULL else rng.sample(range(len(rows)), min(2, len(rows)))
            for k in wanted:
                words = ("--at", "%s=%r%s" % (coordinate["name"], rows[k][0], unit))
                expected = dict(zip(names, rows[k][1:]))
                self.compare(file, words, expected, is_exact, "solve")
                self.count += 1
                if k == wanted[0]:
                    self.compare_derive(file, words)
                    self.compare_study(file, info, words, expected, is_exact)
            if len(rows) <= STEPS and len(rows) > 1:  # a limit: nothing beyond it is given as the machine's own
                beyond = at + span * len(rows) / STEPS
                self.assertIsNone(self.coordinates(file, "--at", "%s=%r%s" % (coordinate["name"], beyond, unit)),
                                  "%s: %s = %r lies beyond the limit that the sweep meets" % (file, coordinate["name"], beyond))

    def size(self, file):
        points = Run("solve", file, "--format", "json", "--quiet").json()["configurations"][0]["points"]
        return max(max(map(abs, p["position"])) for p in points.values()) or 1

    def compare_derive(self, file, words):
        """Velocities as formulas with numbers, against the engine's."""
        run = Run("derive", file, *words, "--what", "velocity", "--numbers", "--format", "json", "--quiet")
        if run.code != 0:
            return
        rates = Run("solve", file, *words, "--format", "json", "--quiet").json()["configurations"][0]["coordinates"]
        for section in run.json()["sections"]:
            for item in section["items"]:
                name = item.get("text", "").split("' = ")[0]
                if name not in rates or not isinstance(item.get("value"), (int, float)) or rates[name]["velocity"] is None:
                    continue
                scale = max(abs(r["velocity"] or 0) for r in rates.values()) or 1
                self.assertLess(abs(item["value"] - rates[name]["velocity"]), 1e-7 * scale, (file, words, name))
                self.count += 1

    def compare_study(self, file, info, words, expected, is_exact):
        name = next((line for line in self.parameters(file)), None)
        if not name:
            return
        if Run("solve", file, *words, "--format", "json", "--quiet").json()["status"] == "singular":
            return  # at a dead point rounding decides whether a design still closes
        value = Run("study", file, *words, "--vary", "%s=%s:%s:1" % (name, name, name), "--of", ",".join(expected), "--format", "csv",
                    "--quiet")
        if value.code == 2:  # a parameter that does not vary
            return
        head, row = [line.split(",") for line in value.out.splitlines()[:2]]
        got = {name: float(field) if field else None for name, field in zip(head, row) if name in expected}
        for coordinate, want in expected.items():
            self.assertIsNotNone(got[coordinate], (file, words, coordinate, value.out))
            off = abs(got[coordinate] - want)
            off = abs(math.remainder(off, TURN)) if self.is_angle(info, coordinate) else off
            self.assertLessEqual(off, 0 if is_exact and off == 0 else 1e-9 * max(1, abs(want)), (file, words, coordinate))
        self.count += 1

    def is_angle(self, info, name):
        return next(c["kind"] for c in info["coordinates"] if c["name"] == name) == "angle"

    def parameters(self, file):
        with open(file, encoding="utf-8") as source:
            for line in source:
                if line.startswith("parameters: {"):
                    return [line[len("parameters: {"):].split(":")[0].strip()]
        return []

    def walk_time(self, file, info, rng):
        if not any(c["driven"] for c in info["coordinates"]):
            return
        names = [c["name"] for c in info["coordinates"]]
        is_exact = not any(block["kind"] == "group" for block in info["blocks"])
        rows = self.sweep(file, "t", 0, rng.uniform(0.1, 2), 8, names, "s")
        for k in (range(len(rows)) if FULL else rng.sample(range(len(rows)), min(2, len(rows)))):
            self.compare(file, ("--time", "%rs" % rows[k][0]), dict(zip(names, rows[k][1:])), is_exact, "solve --time")
            self.count += 1

    def walk(self, file, rng):
        info = check(file)
        if info is None or not info["loops"]:
            return
        inputs = [c for c in info["coordinates"] if c["input"]]
        for coordinate in inputs if FULL else inputs[:1]:
            self.walk_input(file, info, coordinate, rng)
        others = [c for c in info["coordinates"] if not c["input"] and c["declared"]]
        if os.path.basename(file) == "n-four-bar.yaml":
            others = []  # its rod folds onto its crank: driven there, the crank may stand anywhere
        if others and len(inputs) == 1:  # driven at another coordinate than the file's own
            self.walk_input(file, info, rng.choice(others), rng)
        self.walk_time(file, info, rng)

    def setUp(self):
        super().setUp()
        self.count = self.flipped = 0
        self.codes = set()

    def test_examples(self):
        rng = random.Random(20261122)
        for file in sorted(glob.glob(os.path.join(ROOT, "examples", "*.yaml")))[:: 6 if FEW else 1]:
            with self.subTest(file=os.path.basename(file)):
                self.walk(file, rng)
        self.assertGreater(self.count, 40 if FEW else 300)

    def test_other_parameters_keep_the_files_configuration(self):
        """The guess lies between the two ways to assemble the machine, a little nearer to the one; with a shorter crank it is
        nearer to the other, and the machine that was put together is still the same."""
        file = self.write("near.yaml", NEAR)
        label = Run("solve", file, "--format", "json").json()["configurations"][0]["label"]
        for crank in ("0.9", "0.95", "1.05", "1.1", "1.2"):
            run = Run("solve", file, "--param", "a=" + crank, "--format", "json")
            self.assertEqual(run.code, 0, run.err)
            answer = run.json()["configurations"][0]
            self.assertEqual(answer["label"], label)
            other = Run("solve", file, "--param", "a=" + crank, "--assembly", "nearest", "--format", "json").json()
            self.flipped += other["configurations"][0]["label"] != label
            code = Run("code", file, "--param", "a=" + crank)
            self.assertEqual(code.code, 0, code.err)
            self.codes.add(re.search(r"(?m)^.*\.B = .*$", code.out).group(0))
        self.assertEqual(len(self.codes), 1)
        self.assertGreater(self.flipped, 0)  # nearest to the guesses would have been another one

    def test_a_group_is_carried_along(self):
        """A triad whose ground pin is moved by a parameter: `--param` in one go, against a dozen small changes, after each
        of which the machine is put together nearest to where it stood."""
        carried = 0
        for seed in range(40 if FULL else 3 if FEW else 8):
            text = random_machine(random.Random(seed), triads=True)
            text = text.replace("parameters: {scale: 1}", "parameters: {shift: 0 m}")
            text = re.sub(r"(ground: .*B01: \[)([-\d.e]+)", r"\1\2 + shift", text)
            file = self.write("triad.yaml", text)
            run = Run("solve", file, "--param", "shift=0.3m", "--format", "json", "--quiet")
            stepped = self.step_by_step(file, text, 0.3, 30 if FULL else 12)
            if run.code != 0 or stepped is None:
                self.assertIn(run.code, (0, 1), run.err)
                continue
            got = run.json()["configurations"][0]["coordinates"]
            for name, want in stepped.items():
                self.assertLess(abs(math.remainder(got[name]["position"] - want, TURN)), 1e-9, (seed, name))
            carried += 1
        self.assertGreater(carried, 10 if FULL else 0 if FEW else 2)

    def step_by_step(self, file, text, end, steps):
        """Coordinates at the end, or None where the machine comes apart or two configurations come near each other."""
        guesses = None
        for k in range(steps + 1):
            run = Run("solve", self.write("step.yaml", text.replace("shift: 0 m", "shift: %r m" % (end * k / steps))), "--format",
                      "json", "--quiet")
            if run.code != 0:
                return None
            now = {n: c["position"] for n, c in run.json()["configurations"][0]["coordinates"].items()}
            if guesses and max(abs(math.remainder(now[n] - guesses[n], TURN)) for n in now) > 0.2:
                return None
            guesses = now
            text = re.sub(r"start: \{.*\}", "start: {%s}" % ", ".join("%s: %r" % i for i in now.items() if i[0] != "theta"), text)
        return guesses

    def test_a_way_that_is_too_long_is_refused_at_once(self):
        """A drive that swings 3e8 times on the way; what is asked of fewer swings is answered."""
        file = self.write("swings.yaml", NEAR.replace("start: {theta: 60 deg, ", "drives: {theta: 1 rad + 0.2 rad * sin(1e9 rad/s * t)}\nstart: {"))
        for words in (("solve", file, "--time", "2s"), ("sweep", file, "--over", "t=0:2s"), ("sweep", file, "--over", "t=1s:2s")):
            run = Run(*words)
            self.assertEqual(run.code, 1, words)
            self.assertIn("[E0608]", run.err)
            self.assertIn("too long", run.err)
        self.assertEqual(Run("solve", file, "--time", "1us").code, 0)
        self.assertEqual(Run("sweep", file, "--over", "t=0:1us", "--steps", "3").code, 0)

    def test_a_sweep_without_loops_is_refused_where_it_is_too_long(self):
        """An arm that swings 1.6e8 times; far from there, but over a short range, it is answered."""
        file = self.write("arm.yaml", ARM)
        run = Run("sweep", file, "--over", "t=0:1s", "--steps", "4")
        self.assertEqual(run.code, 1)
        self.assertIn("too long", run.err)
        run = Run("sweep", file, "--over", "t=1s:1.00000001s", "--steps", "2", "--of", "theta", "--format", "csv")
        self.assertEqual(run.code, 0, run.err)
        first = run.out.splitlines()[1].split(",")
        self.assertLess(abs(float(first[1]) - math.sin(1e9)), 1e-6)
        self.assertEqual(Run("report", file).code, 0)

    def test_a_start_at_which_a_drive_has_no_rate_is_told(self):
        """The square root has a value at 0 and no derivative: every message has its reason."""
        file = self.write("root.yaml", ARM.replace("sin(1e9 rad/s * t)", "sqrt(t/1s)"))
        run = Run("solve", file, "--time", "1s")
        self.assertEqual(run.code, 2)
        self.assertNotRegex(run.err, r", +\[E")
        self.assertIn("a drive has no value, rate or acceleration", run.err)

    def test_rest_starts_from_the_configuration_that_is_chosen(self):
        """A pendulum's rocking four-bar: which equilibria it reaches depends on how it was put together."""
        file = os.path.join(ROOT, "examples", "rocking-four-bar.yaml")
        labels = [c["label"] for c in Run("solve", file, "--all", "--format", "json").json()["configurations"]]
        self.assertEqual(len(labels), 2)
        reached = []
        for words in ((), ("--assembly", labels[0]), ("--assembly", labels[1]), ("--assembly", "1"), ("--assembly", "2")):
            run = Run("rest", file, *words, "--format", "json")
            self.assertEqual(run.code, 0, run.err)
            reached.append([e["reachable"] for e in run.json()["equilibria"]])
        self.assertEqual(reached[1], reached[3])
        self.assertEqual(reached[2], reached[4])
        self.assertIn(reached[0], reached[1:3])
        self.assertEqual(Run("rest", file, "--assembly", "Z+").code, 1)

    def test_random_machines(self):
        for seed in range(200 if FULL else 4 if FEW else 12):
            rng = random.Random(seed)
            with self.subTest(seed=seed):
                self.walk(self.write("random-%d.yaml" % seed, random_machine(rng)), rng)
        self.assertGreater(self.count, 5 if FEW else 20)


def random_machine(rng, triads=False):
    """A crank with dyads, sometimes a triad, put together where all angles are 0: points in world coordinates."""
    bodies = {"ground": {"O": (0, 0)}, "crank": {"O": (0, 0), "A": (rng.uniform(0.2, 0.5), rng.uniform(-0.2, 0.2))}}
    joints = ["  O: {pin: [ground, crank], angle: theta}"]
    angles = []

    def somewhere():
        return (rng.uniform(-2, 2), rng.uniform(-2, 2))

    def anchor(name, moving):
        body = rng.choice([b for b in bodies if b != "ground"]) if moving else "ground"
        point = "A" if body == "crank" else None
        if point is None:
            bodies[body][name] = somewhere()
            point = name
        return body, point

    def link(name, start, end, place):
        bodies[name] = {start[1]: bodies[start[0]][start[1]], end: place}
        angle = "q%d" % (len(angles) + 1)
        angles.append(angle)
        joints.append("  J%s: {pin: [%s, %s], at: %s, angle: %s}" % (name, start[0], name, start[1], angle))

    def dyad(k):
        place, end = somewhere(), "E%d" % k
        link("u%d" % k, anchor("P%d" % k, k == 0 or rng.random() < 0.7), end, place)
        link("w%d" % k, anchor("Q%d" % k, False), end, place)
        joints.append("  D%d: {pin: [u%d, w%d], at: %s}" % (k, k, k, end))

    def triad(k):
        corners = [somewhere() for _ in range(3)]
        for i in range(3):
            end = "C%d%d" % (k, i)
            link("v%d%d" % (k, i), anchor("B%d%d" % (k, i), i == 0), end, corners[i])
            extra = ""
            if i == 0:
                angles.append("q%d" % (len(angles) + 1))
                extra = ", angle: " + angles[-1]
            joints.append("  T%d%d: {pin: [v%d%d, t%d], at: %s%s}" % (k, i, k, i, k, end, extra))
        bodies["t%d" % k] = {"C%d%d" % (k, i): corners[i] for i in range(3)}

    for k in range(1 if triads else rng.randint(1, 3)):
        (triad if triads or rng.random() < 0.25 else dyad)(k)
    text = "parameters: {scale: 1}\nbodies:\n"
    for body, points in bodies.items():
        text += "  %s: {points: {%s}}\n" % (body, ", ".join("%s: [%r, %r]" % (n, *p) for n, p in points.items()))
    start = ", ".join("%s: 0" % a for a in angles)
    return text + "joints:\n" + "\n".join(joints) + "\ndrives: {theta: 1 rad/s * t}\nstart: {%s}\n" % start


if __name__ == "__main__":
    unittest.main()
