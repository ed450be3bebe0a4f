"""--lock: a case of `locks:` in the verbs that solve machines, against `yoke gears`, closed forms and itself."""
import os
import unittest

from harness import FOUR_BAR, ROOT, Case, Run

PLANETARY = """\
bodies:
  sun: {mass: 1, inertia: 0.3}
  planet: {mass: 0.4, inertia: 0.02}
  ring: {mass: 2, inertia: 0.9}
  arm: {points: {P: [0.3, 0]}, mass: 1, inertia: 0.5}
joints:
  S: {pin: [ground, sun], angle: s}
  R: {pin: [ground, ring], angle: r}
  C: {pin: [ground, arm], angle: c}
  P: {pin: [arm, planet]}
gears:
  sun-planet: {mesh: [sun, planet], teeth: [20, 10], carrier: arm}
  planet-ring: {mesh: [planet, ring], teeth: [10, 40], carrier: arm, internal: true}
locks: {held: [ring], direct: {join: [[sun, arm]]}, stopped: [s, c]}
efforts: {s: 6 N*m}
"""
# What the sun feels of all that turns with it: of the arm with the planet's mass on it, ring held at a third of its speed,
# and the planet's own turning.
HELD = 0.3 + (0.5 + 0.4 * 0.3 ** 2) / 9 + 0.02
DIRECT = 0.3 + 0.5 + 0.4 * 0.3 ** 2 + 0.02 + 0.9


def example(name):
    return os.path.join(ROOT, "examples", name + ".yaml")


class Locks(Case):
    def answer(self, *words):
        run = Run(*words, "--format", "json")
        self.assertEqual(run.code, 0, run.err)
        return run.json()["configurations"][0]

    def test_a_gearbox_turns_as_its_shift_table_says(self):
        path = example("gearbox-8hp70")
        table = Run("gears", path, "--in", "input", "--out", "output", "--format", "json").json()["shift_table"]
        self.assertEqual(len(table), 9)
        for lock, gear in table.items():
            bodies = self.answer("solve", path, "--lock", lock)["bodies"]
            self.assertAlmostEqual(bodies["input"]["rate"] / bodies["output"]["rate"], gear["ratio"]["value"], delta=2e-14 * 5)

    def test_the_dynamics_feel_the_lock(self):
        path = self.write("planetary.yaml", PLANETARY)
        for lock, inertia in (("held", HELD), ("direct", DIRECT)):
            for method in ("reduced", "newton-euler"):
                motion = self.answer("solve", path, "--lock", lock, "--method", method)["coordinates"]
                self.assertAlmostEqual(motion["s"]["acceleration"], 6 / inertia, delta=1e-12)
            rows = Run("simulate", path, "--lock", lock, "--to", "2s", "--every", "1s", "--of", "s,c", "--format", "csv").csv()[1]
            self.assertAlmostEqual(rows[2][1], 6 / inertia * 2, delta=1e-8)
            self.assertAlmostEqual(rows[2][2], 6 / inertia * 2 / (3 if lock == "held" else 1), delta=1e-8)

    def test_a_lock_that_puts_a_body_elsewhere_is_told(self):
        hoist = """units: {length: mm, angle: deg}
bodies:
  ground: {points: {A: [0, 0], B: [200, 0], G: [200, 40]}}
  motor: {points: {A: [0, 0]}, mass: 1, inertia: 0.001 kg*m^2}
  drum: {points: {B: [0, 0]}, mass: 3, inertia: 0.01 kg*m^2}
  rack: {mass: 2}
joints: {A: {pin: [ground, motor], angle: a}, B: {pin: [ground, drum], angle: b}, S: {slide: [ground, rack], along: x, from: G, distance: d}}
belts: {v: {between: [motor, drum], radii: [30, 75], crossed: true}}
racks: {z: {pinion: drum, rack: rack, radius: 40}}
locks: {brake: [drum], motor: [motor]}
start: {a: %s}
"""
        away = Run("solve", self.write("hoist.yaml", hoist % "50, b: -20"), "--format", "json")  # its own place: -50*30/75
        free = self.write("free.yaml", hoist % "50")
        told = Run("solve", free, "--lock", "brake", "--format", "json")
        self.assertEqual(told.code, 0)
        self.assertIn("free.yaml:10:9: warning: lock `brake` holds `b` at 0, since `start:` gives it no value; without the lock the "
                      "machine starts at -20 deg [W0618]", told.err)
        self.assertIn("hint: give `b` its value under `start:`", told.err)
        self.assertNotIn("W0618", away.err + Run("solve", free).err + Run("solve", free, "--lock", "motor").err)
        placed = Run("solve", self.write("placed.yaml", hoist % "50, b: -20"), "--lock", "brake", "--format", "json")
        self.assertNotIn("W0618", placed.err)
        for name in ("a", "b", "d"):  # the lock moves nothing
            self.assertAlmostEqual(placed.json()["configurations"][0]["coordinates"][name]["position"],
                                   away.json()["configurations"][0]["coordinates"][name]["position"], places=12)
        zero = self.write("zero.yaml", hoist % "0")
        self.assertNotIn("W0618", Run("solve", zero, "--lock", "brake").err)
        self.assertIn("W0618", Run("sweep", free, "--lock", "brake", "--over", "t=0s:1s").err)
        self.assertNotIn("W0618", Run("solve", free, "--lock", "brake", "--quiet").err)

    def test_what_holds_is_an_effort(self):
        path = self.write("planetary.yaml", PLANETARY)
        steady = self.answer("solve", path, "--lock", "held", "--effort", "s=3", "--effort", "c=-9")  # as the teeth: 1, 2, -3
        self.assertAlmostEqual(steady["coordinates"]["s"]["acceleration"], 0, delta=1e-12)
        self.assertAlmostEqual(steady["efforts"]["r"], 6, delta=1e-12)
        self.assertAlmostEqual(self.answer("solve", path, "--lock", "stopped")["efforts"]["c"], 0, delta=1e-12)

    def test_a_linkage_is_held_where_it_starts(self):
        text = FOUR_BAR.replace("drives: {theta1: 60 + 90 deg/s * t}", "locks: {park: [crank], jam: {join: [[coupler, rocker]]}}")
        path = self.write("parked.yaml", text.replace("start: {", "start: {theta1: 50, "))
        motion = self.answer("solve", path, "--lock", "park")["coordinates"]
        self.assertAlmostEqual(motion["theta1"]["position"], 50 * 3.141592653589793 / 180, delta=1e-15)
        self.assertIn("held by the lock", Run("check", path, "--lock", "park").out)
        self.assertIn("N0509", Run("solve", path).err)
        self.assertNotIn("N0509", Run("solve", path, "--at", "theta1=40").err)

    def test_wrong_locks_are_refused(self):
        driven = self.write("driven.yaml", FOUR_BAR + "locks: {park: [crank], mid: [rocker]}\n")
        run = Run("solve", driven, "--lock", "park")
        self.assertEqual(run.code, 2)
        self.assertIn("holds `theta1`, which is driven [E0469]", run.err)
        run = Run("solve", driven, "--lock", "mid")
        self.assertEqual(run.code, 2)
        self.assertIn("already fix it", run.err)
        nowhere = self.write("nowhere.yaml", FOUR_BAR.replace("drives: {theta1: 60 + 90 deg/s * t}", "locks: {park: [crank]}"))
        self.assertIn("nothing says where", Run("solve", nowhere, "--lock", "park").err)
        for verb in ("check", "solve", "simulate", "draw", "rest", "derive"):
            words = {"simulate": ["--to", "1s"], "draw": ["-o", self.path("x.svg")]}.get(verb, [])
            run = Run(verb, driven, "--lock", "parc", *words)
            self.assertEqual(run.code, 2)
            self.assertIn("E0511", run.err)

    def test_the_symbols_know_the_lock(self):
        path = self.write("planetary.yaml", PLANETARY)
        run = Run("derive", path, "--lock", "held", "--what", "loops")
        self.assertIn("r = 0", run.out)
        self.assertEqual(Run("derive", path, "--lock", "direct", "--check", "s.rate - 3*c.rate = 0").code, 1)
        self.assertEqual(Run("derive", path, "--lock", "direct", "--check", "s.rate - c.rate = 0").code, 0)


if __name__ == "__main__":
    unittest.main()
