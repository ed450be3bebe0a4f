"""yoke code: dry friction in printed C, against the engine, closed forms and the answers of `yoke solve`."""
import math
import os
import re
import subprocess
import unittest

from harness import ROOT, Run
from test_code import Printed
from test_forces import INCLINE

PRESS = """\
parameters: {mu: 0.2, mp: 0.1, rp: 12 mm}
gravity: [0.3, -9.81]
bodies:
  ground: {points: {O: [0, 0]}}
  crank:  {points: {O: [0, 0], A: [0.1, 0]}, mass: 1, center: [0.04, 0.01], inertia: 0.01}
  rod:    {points: {A: [0, 0], B: [0.35, 0]}, mass: 0.8, center: [0.15, 0], inertia: 0.008}
  ram:    {points: {B: [0, 0]}, mass: 2, center: [0.02, 0.03], inertia: 0.01}
joints:
  O: {pin: [ground, crank], angle: theta, friction: {coulomb: mp, radius: rp, viscous: 0.02 N*m*s/rad}}
  A: {pin: [crank, rod], angle: phi, friction: {coulomb: mp, radius: rp}}
  B: {pin: [rod, ram], friction: {coulomb: mp, radius: rp}}
  R: {slide: [ground, ram], along: x, distance: s, friction: {coulomb: mu}}
efforts: {s: -200 N}
start: {theta: 1, theta.rate: 2, phi: -1.2, s: 0.39}
"""

# A toggle whose block rubs so hard that every round of the search multiplies its friction.
ELBOW = """\
parameters: {mu: 8}
gravity: [0, -9.81]
bodies:
  ground: {points: {O: [0, 0]}}
  a: {points: {O: [0, 0], A: [0.5, 0]}, mass: 1, inertia: 0.1}
  b: {points: {A: [0, 0], B: [0.5, 0]}, mass: 1, inertia: 0.1}
  s: {points: {B: [0, 0]}, mass: 2}
joints:
  O: {pin: [ground, a], angle: q}
  A: {pin: [a, b], angle: p}
  S: {slide: [ground, s], along: x, from: O, to: B, distance: d, friction: {coulomb: mu}}
  B: {pin: [b, s]}
start: {q: 0.9, q.rate: 1, p: -1.8, d: 0.62}
"""

# Forces of teeth between them press the shafts apart, and friction in the shafts loads the teeth.
GEARS = """\
gravity: [0, -9.81]
bodies:
  ground: {points: {P: [0, 0], W: [80 mm, 0]}}
  pinion: {points: {P: [0, 0]}, mass: 0.5, center: [3 mm, 0], inertia: 2e-4}
  wheel:  {points: {W: [0, 0], Q: [40 mm, 0]}, mass: 1.5, center: [10 mm, 5 mm], inertia: 3e-3}
  bob:    {points: {Q: [0, 0]}, mass: 0.7, center: [50 mm, 0], inertia: 1e-3}
joints:
  P: {pin: [ground, pinion], angle: p, friction: {coulomb: 0.15, radius: 6 mm}}
  W: {pin: [ground, wheel], angle: w, friction: {coulomb: 0.1, radius: 10 mm}}
  Q: {pin: [wheel, bob], angle: q, friction: {coulomb: 0.1, radius: 5 mm, viscous: 0.001 N*m*s/rad}}
gears:
  G: {mesh: [pinion, wheel], teeth: [20, 60], module: 2 mm, pressure_angle: 20 deg}
efforts: {p: 2 N*m}
start: {p: 0.2, p.rate: 5, q: 1, q.rate: 3}
"""

# An open chain of five freedoms, whose accelerations depend on each other and on every friction.
CHAIN = """\
parameters: {mu: 0.3}
gravity: [0, -9.81]
bodies:
  ground: {points: {O: [0, 0]}}
  arm: {points: {O: [0, 0], S: [0.1, 0.05]}, mass: 1, center: [0.2, 0], inertia: 0.1}
  bead: {points: {S: [0, 0], E: [0.1, 0]}, mass: 0.5, center: [0.1, 0.02], inertia: 0.02}
  tip: {points: {E: [0, 0]}, mass: 0.3, center: [0.1, 0], inertia: 0.01}
joints:
  O: {pin: [ground, arm], angle: q, friction: {coulomb: mu, radius: 0.02}}
  S: {pin-slot: [arm, bead], along: 0.3 rad, distance: d, angle: r, friction: {coulomb: mu/2}}
  E: {pin: [bead, tip], angle: e, friction: {coulomb: mu, radius: 0.01, viscous: 0.1 N*m*s/rad}}
springs: {K: {along: d, stiffness: 40, length: 0.3}}
start: {q: 0.5, q.rate: 2, d: 0.2, d.rate: -0.4, r: 1, r.rate: 1, e: 0.3, e.rate: -2}
"""

# Reads poses of one freedom, with a coefficient of friction before; prints statuses, efforts and accelerations.
MAIN = """
#include <stdio.h>
int main(void)
{
    double mu, q, v, a;
    while (scanf("%lf %lf %lf %lf", &mu, &q, &v, &a) == 4) {
        m_parameters p = m_defaults();
        SET
        const m_machine m = m_prepare(&p);
        const m_configuration c = m_start();
        const m_inputs in = {0, q, v, aMORE};
        m_efforts out;
        const int inverse = m_find_efforts(&m, &c, &in, &out);
        printf("%d %.17g\\n", inverse, out.NAME_effort);
    }
    return 0;
}
"""
OK, AT_REST, NOT_CONVERGED = 0, 4, -3


class Friction(Printed):
    def poses(self, text, name, poses, parameter="mu"):
        """For rows of mu, position, rate, acceleration: rows of status and effort."""
        code = self.print(self.write("%s.yaml" % name, text))
        extra = ", 0" * ("%s_effort" % name in re.search(r"(?s)typedef struct m_inputs \{(.*?)\}", code).group(1))
        program = self.compile(code + MAIN.replace("NAME", name).replace("MORE", extra).replace(
            "SET", "p.%s = mu;" % parameter if parameter else ""))
        run = subprocess.run([program], input="".join("%.17g %.17g %.17g %.17g\n" % row for row in poses),
                             capture_output=True, encoding="utf-8", check=True)
        return [(int(status), float(effort)) for status, effort in map(str.split, run.stdout.splitlines())]

    def test_sliding_machines_agree_with_the_engine(self):
        with open(os.path.join(ROOT, "examples", "three-crank-parallelogram.yaml"), encoding="utf-8") as file:
            cranks = file.read().replace("bodies:", "gravity: [0.4, -9.81]\nbodies:", 1).replace(
                "A1: [0.5, 0]}", "A1: [0.5, 0]}, mass: 1, inertia: 0.1", 1)
        for pin in ("angle: theta2", "pin: [rod, crank3]"):
            self.assertIn(pin, cranks)
            cranks = cranks.replace(pin, pin + ", friction: {coulomb: 0.3, radius: 0.05}")
        for name, text in (("press", PRESS), ("gears", GEARS), ("chain", CHAIN), ("cranks", cranks)):
            with self.subTest(name):
                code = self.print(self.write(name + ".yaml", text))
                for routine in ("efforts", "reactions", *(["accelerations"] if name != "cranks" else [])):
                    self.assertIn("failures += m_test_%s()" % routine, code)
                self.assertEqual(self.run_test(code, "1e-11").stdout, "m: well\n")
        single = self.print(self.write("press.yaml", PRESS), "--single")
        self.assertEqual(self.run_test(single, "2e-3").stdout, "m: well\n")

    def test_a_block_on_an_incline_by_hand(self):
        """Force = m (a + g sin) +- mu m g cos; at rest the acceleration says which way it begins to slip, or nothing does."""
        g, slope, m = 10, 0.5, 2
        rows = [(0.3, 0.1, v, a) for v in (-2, 0, 3) for a in (-1, 0, 2)]
        rows += [(0.0, 0.1, 0.0, 0.0), (0.3, 0.1, 1e20, 0.0), (0.3, 0.0, 1e-13, 0.0), (0.3, 0.0, 1e-13, 1.0)]
        text = "parameters: {mu: 0.3}\n" + INCLINE.replace("coulomb: 0.3", "coulomb: mu")
        for (mu, _, v, a), (status, effort) in zip(rows, self.poses(text, "d", rows)):
            sense = v if abs(v) > 1e-11 * max(abs(v), abs(a)) or a == 0 else a
            friction = math.copysign(mu * m * g * math.cos(slope), sense) if sense else 0
            self.assertEqual(status, AT_REST if sense == 0 and mu > 0 else OK, (mu, v, a))
            self.assertAlmostEqual(effort, m * (a + g * math.sin(slope)) + friction, delta=1e-11)

    def test_what_the_library_tells_of_rest_and_jams_is_told(self):
        """A press at rest, about to move, moving, moving with more and more friction until it jams."""
        rows = [(0.2, 1.2, 0.0, 0.0), (0.2, 1.2, 0.0, 1.5), (0.2, 1.2, 0.0, -1.5), (0.2, 1.2, -2.0, 0.3)]
        rows += [(mu, 1.2, 2.0, 0.0) for mu in (2.0, 3.5, 5.0, 8.0, 30.0)] + [(mu, 1.2, -2.0, 0.0) for mu in (2.0, 3.5, 3.7, 8.0)]
        found = self.poses(PRESS, "theta", rows)
        file, seen = self.write("press.yaml", PRESS), set()
        for (mu, at, rate, accel), (status, effort) in zip(rows, found):
            run = Run("solve", file, "--param", "mu=%r" % mu, "--at", "theta=%r" % at, "--rate", "theta=%r" % rate,
                      "--accel", "theta=%r" % accel, "--format", "json")
            seen.add(status)
            if run.code != 0:
                self.assertIn("the joints jam", run.err)
                self.assertEqual(status, NOT_CONVERGED, (mu, rate))
                continue
            ranges = run.json()["configurations"][0].get("effort_ranges")
            self.assertEqual(status, AT_REST if ranges else OK, (mu, rate, accel))
            wanted = ranges["theta"]["without_friction"] if ranges else run.json()["configurations"][0]["efforts"]["theta"]
            self.assertAlmostEqual(effort, wanted, delta=1e-9 * abs(wanted))
        self.assertEqual(seen, {OK, AT_REST, NOT_CONVERGED})

    def test_a_sweep_tells_of_jams_as_of_other_rows_without_forces(self):
        words = ["sweep", self.write("press.yaml", PRESS), "--rate", "theta=2", "--over", "theta=1.2:1.4", "--steps", "2", "--of", "theta.effort", "--format", "json"]
        jams = self.good(*words, "--param", "mu=8")
        self.assertEqual([row[1] for row in jams.json()["rows"]], [None] * 3)
        self.assertRegex(jams.err, r"no forces at theta = 1\.2 rad .* and at later poses: .* the joints jam .*\[W0861\]")
        self.assertIn("jams", self.good("explain", "W0861").out)
        self.assertNotIn("W0861", self.good(*words, "--param", "mu=5").err)

    def test_friction_that_grows_beyond_all_numbers_is_a_jam(self):
        """It was taken for settled where its square overflowed: forces of 1e154 N, and infinity in printed C."""
        factors = (3.0, 5.0, 8.0, 20.0, 200.0)
        file = self.write("elbow.yaml", ELBOW)
        for mu in factors:
            run = Run("solve", file, "--param", "mu=%r" % mu, "--accel", "q=0")
            self.assertEqual(run.code, 1, (mu, run.out))
            self.assertIn("the joints jam", run.err)
        found = self.poses(ELBOW, "q", [(mu, 0.9, 1.0, 0.0) for mu in factors])
        self.assertEqual([status for status, _ in found], [NOT_CONVERGED] * len(factors))


if __name__ == "__main__":
    unittest.main()
