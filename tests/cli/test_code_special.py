"""yoke code: the status of the printed C at special poses and parameters, and the efforts by which coordinates follow laws."""
import math
import os
import random
import re
import subprocess
import unittest

from harness import FULL, ROOT, Run
from test_code import CC, FOLLOWERS, Printed
from test_coincidence import FLIP, lever

# Four equal links: the coupler's pins come to the rocker's where the crank points along the ground.
RHOMBUS = """\
parameters: {a: 1}
bodies:
  ground: {points: {O: [0, 0], C: [1, 0]}}
  crank: {points: {O: [0, 0], A: [1, 0]}, mass: 1, inertia: 1}
  coupler: {points: {A: [0, 0], B: [a, 0]}, mass: 1, inertia: 1}
  rocker: {points: {C: [0, 0], B: [1, 0]}, mass: 1, inertia: 1}
joints:
  O: {pin: [ground, crank], angle: th}
  A: {pin: [crank, coupler]}
  B: {pin: [coupler, rocker]}
  C: {pin: [ground, rocker], angle: ps}
start: {th: 40 deg, ps: 100 deg}
"""

LIFT = """\
parameters: {m: 3}
laws:
  lift: {period: 360 deg, segments: [{rise: {to: 180 deg, by: 0.1 m, law: cycloidal}}, {fall: {to: 360 deg, by: 0.1 m, law: cycloidal}}]}
  swing: {period: 360 deg, segments: [{rise: {to: 180 deg, by: 20 deg, law: cycloidal}}, {fall: {to: 360 deg, by: 20 deg, law: cycloidal}}]}
gravity: [0, -9.81]
bodies:
  ground: {points: {O: [0, 0]}}
  a: {points: {O: [0, 0]}, mass: 1, inertia: 0.1}
  b: {mass: m}
  c: {points: {O: [0, 0]}, mass: 1, inertia: 2}
joints:
  O: {pin: [ground, a], angle: theta}
  S: {slide: [ground, b], along: y, distance: d%s}
  C: {pin: [ground, c], at: O, angle: psi}
drives: {theta: 60 deg + 20 rad/s * t, d: {law: lift, of: theta}, psi: {law: swing, of: theta}}
"""

RACK = """\
parameters: {h: 20 mm, tilt: 0}
bodies:
  ground: {points: {O: [0, 0], P: [0, h]}}
  rack: {mass: 1}
  pinion: {points: {O: [0, 0]}, mass: 1, inertia: 0.1}
joints:
  R: {slide: [%s], along: tilt, %s: P, distance: x}
  O: {pin: [ground, pinion], angle: theta}
racks: {r: {pinion: pinion, rack: rack, radius: 20 mm}}
gravity: [2, -9.81]
start: {x: 0.01, x.rate: 1}
"""

# Poses one after the other, then all as a batch; prints status and results of each.
RUN = """
#include <stdio.h>
int main(void)
{
    enum { N = %(count)d };
    static const double given[N][INPUTS] = {%(poses)s};
    static double in[INPUTS][N], out[RESULTS][N], own[PARAMETERS][N];
    static signed char status[N];
    static const double changed[N][PARAMETERS] = {%(parameters)s};
    const m_machine first = m_prepare((const m_parameters *)changed[0]);
    const m_configuration c = m_start();
    const m_inputs_arrays inputs = {%(ins)s};
    const m_%(routine)s_arrays results = {%(outs)s};
    const m_parameters_arrays parameters = {%(owns)s};
    for (int i = 0; i < N; i++) {
        m_inputs pose;
        m_%(routine)s one;
        const m_machine m = m_prepare((const m_parameters *)changed[i]);
        for (int k = 0; k < INPUTS; k++) in[k][i] = ((double *)&pose)[k] = given[i][k];
        for (int k = 0; k < PARAMETERS; k++) own[k][i] = changed[i][k];
        printf("%%d", m_find_%(routine)s(&m, &c, &pose, &one));
        for (int k = 0; k < RESULTS; k++) printf(" %%.17g", ((double *)&one)[k]);
        puts("");
    }
    for (int designs = %(from)d; designs < %(rounds)d; designs++) {
        if (designs)
            m_find_%(routine)s_%(designs)s
        else
            m_find_%(routine)s_batch(N, &first, &c, &inputs, &results, status);
        for (int i = 0; i < N; i++) {
            printf("%%d", status[i]);
            for (int k = 0; k < RESULTS; k++) printf(" %%.17g", out[k][i]);
            puts("");
        }
    }
    return 0;
}
"""
OK, SINGULAR, LIMIT, BAD_DESIGN = 0, 3, -1, -4


def members(text, struct):
    return re.findall(r"    double (\w+);", re.search(r"(?s)typedef struct m_%s \{(.*?)\n?\}" % struct, text).group(1))


class Special(Printed):
    def find(self, text, routine, poses):
        """Status and results by name of every pose, with parameters of its own, which a call, a batch and a batch over
        parameters tell alike."""
        inputs, results, own = (members(text, name) for name in ("inputs", routine, "parameters"))
        defaults = dict(re.findall(r"\.(\w+) = ([^,]*),", re.search(r"(?s)m_defaults\(void\)\n\{.*?\n\}", text).group(0)))
        has_designs = "m_find_%s_designs(" % routine in text
        source = RUN % {"count": len(poses), "routine": routine, "rounds": 1 + has_designs,
                        "from": int(len({tuple(p.get(n) for n in own) for p in poses}) > 1),
                        "poses": ", ".join("{%s}" % ", ".join(repr(float(p.get(n, 0))) for n in inputs) for p in poses),
                        "parameters": ", ".join("{%s}" % ", ".join(repr(float(p.get(n, defaults.get(n, 0)))) for n in own) for p in poses),
                        "ins": ", ".join("in[%d]" % k for k in range(len(inputs))), "outs": ", ".join("out[%d]" % k for k in range(len(results))),
                        "owns": ", ".join("own[%d]" % k for k in range(len(own))),
                        "designs": "designs(N, &parameters, &c, &inputs, &results, status);" if has_designs
                                   else "batch(N, &first, &c, &inputs, &results, status);"}
        source = source.replace("INPUTS", str(len(inputs))).replace("RESULTS", str(len(results))).replace("PARAMETERS", str(len(own)))
        if not has_designs:
            source = re.sub(r"    const m_parameters_arrays .*\n", "", source)
        answers = []
        for level in ("-O0", "-O2") if FULL else ("-O1",):
            program = self.path("run" + level)
            done = subprocess.run([CC, "-std=c11", level, "-fno-math-errno", "-fno-trapping-math", self.write("run.c", text + source), "-lm",
                                   "-o", program], capture_output=True, encoding="utf-8", check=False)
            self.assertEqual(done.returncode, 0, done.stderr[:2000])
            rows = [line.split() for line in subprocess.run([program], capture_output=True, encoding="utf-8", check=True).stdout.splitlines()]
            rows = [(int(row[0]), dict(zip(results, map(float, row[1:])))) for row in rows]
            for first in range(len(poses), len(rows), len(poses)):
                for one, many in zip(rows, rows[first:first + len(poses)]):
                    self.assertEqual(one[0], many[0])
                    for name in results if one[0] >= 0 else ():
                        self.assertTrue(abs(one[1][name] - many[1][name]) <= 1e-9 * (1 + abs(one[1][name])) or one[0] == SINGULAR, name)
            answers = rows[:len(poses)]
        return answers


class Coincidences(Special):
    def test_the_lever_keeps_the_angle_with_which_it_comes(self):
        """Closed form: 90 deg + th/2 as th falls to 0; as it grows to 0 the branch has the lever turned by half a turn."""
        text = self.print(self.write("flip.yaml", FLIP))
        poses = [{"th": 0, "th_rate": rate} for rate in (-1, 1, -1e-3, -50)] + [{"th": 1e-6, "th_rate": 1}, {"th": 0.5, "th_rate": -1}]
        (falls, grows, slow, fast, near, far) = self.find(text, "motion", poses)
        self.assertEqual([row[0] for row in (falls, grows, slow, fast, near, far)], [SINGULAR] * 5 + [OK])
        self.assertEqual(Run("solve", self.write("in.yaml", FLIP.replace("th: 40 deg, ps: 110 deg", "th: 0, ps: 90 deg")), "--quiet").code, 0)
        for row, th in ((falls, 0), (slow, 0), (fast, 0), (near, 1e-6), (far, 0.5)):
            self.assertAlmostEqual(row[1]["ps"], lever(th)[0], delta=2e-8)
        self.assertAlmostEqual(math.cos(grows[1]["ps"] - lever(0)[0]), -1, delta=1e-12)
        for routine in ("points", "efforts", "reactions"):
            at, there = self.find(text, routine, [{"th": 0, "th_rate": -1}, {"th": 0.5, "th_rate": -1}])
            self.assertEqual((at[0], there[0]), (SINGULAR, OK), routine)
            if routine == "points":
                self.assertAlmostEqual(at[1]["lever_E_x"], lever(0)[1], delta=1e-7)
                self.assertAlmostEqual(at[1]["lever_E_y"], lever(0)[2], delta=1e-7)

    def test_pins_of_equal_links_coincide(self):
        """The rocker is beside the crank turned by the ground's direction: ps = th on one branch, 2 th' on none; points tell all."""
        text = self.print(self.write("rhombus.yaml", RHOMBUS), "--kinematics")
        before, at, beyond = self.find(text, "motion", [{"th": th, "th_rate": -1} for th in (1e-5, 0, -1e-5)])
        self.assertEqual((before[0], at[0], beyond[0]), (SINGULAR, SINGULAR, SINGULAR))
        self.assertAlmostEqual(before[1]["ps"], at[1]["ps"], delta=2e-5)
        points = self.find(text, "points", [{"th": 0, "th_rate": -1}])[0]
        self.assertEqual(points[0], SINGULAR)
        B = complex(points[1]["rocker_B_x"], points[1]["rocker_B_y"])
        self.assertAlmostEqual(abs(B - 1), 1, delta=1e-12)  # of the rocker's length, at the crank's end
        self.assertAlmostEqual(points[1]["coupler_B_x"], B.real, delta=2e-8)
        self.assertAlmostEqual(points[1]["coupler_B_y"], B.imag, delta=2e-8)

    def test_links_of_other_lengths_do_not_close_there(self):
        text = self.print(self.write("rhombus.yaml", RHOMBUS), "--kinematics")
        far, at = self.find(text, "motion", [{"th": th, "th_rate": -1, "a": 1.2} for th in (1, 0)])
        self.assertEqual((far[0], at[0]), (OK, LIMIT))
        self.assertNotEqual(Run("solve", self.write("rhombus.yaml", RHOMBUS), "--param", "a=1.2", "--at", "th=0deg", "--quiet").code, 0)

    def test_a_dead_point_stays_where_it_is(self):
        """Both arms in line exactly: no coincidence, and the place is that of the pose, not of one beside it."""
        text = RHOMBUS.replace("C: [1, 0]}", "C: [2, 0]}", 1).replace("a: 1}", "a: 2}", 1)
        text = self.print(self.write("line.yaml", text.replace("ps: 100 deg", "ps: 60 deg")), "--kinematics")
        row = self.find(text, "points", [{"th": math.pi, "th_rate": 1}, {"th": math.pi, "th_rate": -1}])
        for status, values in row:
            self.assertEqual(status, SINGULAR)
            self.assertAlmostEqual(values["rocker_B_x"], 1, delta=1e-7)
            self.assertAlmostEqual(values["rocker_B_y"], 0, delta=1e-7)


class Racks(Special):
    def test_a_rack_that_parameters_move_across_the_centre_is_refused(self):
        """On the other side the engine has the pinion turn the other way; on the file's own both agree."""
        for bodies, begin, pin in (("ground, rack", "from", "ground, pinion"), ("rack, ground", "to", "pinion, ground")):
            machine = RACK.replace("O: [0, 0], P: [0, h]", "O: [0, -30 mm], P: [0, h - 30 mm]").replace("ground, pinion", pin)
            path = self.write("rack.yaml", machine % (bodies, begin))
            text = self.print(path)
            self.assertEqual(self.run_test(text).stdout, "m: well\n")
            designs = ((0.02, 0, OK), (0.03, 0, OK), (1e-7, 0, OK), (-0.02, 0, BAD_DESIGN), (0.02, 3, BAD_DESIGN), (0.02, 6, OK))
            poses = [{"x": 0.01, "x_rate": 1, "h": h, "tilt": tilt} for h, tilt, _ in designs]
            motion, efforts = (self.find(text, routine, poses) for routine in ("motion", "efforts"))
            for (h, tilt, wanted), (status, values), (effort, _) in zip(designs, motion, efforts):
                given = Run("solve", path, "--param", "h=%rm" % h, "--param", "tilt=%rrad" % tilt, "--format", "json", "--quiet").json()
                rate = given["configurations"][0]["coordinates"]["theta"]["velocity"]
                self.assertEqual((status, effort), (wanted, wanted), (bodies, h, tilt))
                self.assertAlmostEqual(values["theta_rate"], -rate if wanted == BAD_DESIGN else rate, delta=1e-9 * abs(rate))

    def test_a_rack_that_stays_has_no_such_status(self):
        for text in (RACK.replace("h: 20 mm, ", "w: 1 kg, ").replace("[0, h]", "[0, 20 mm]").replace("tilt: 0", "u: 0").replace("along: tilt", "along: x"),):
            self.assertNotIn("BAD_DESIGN", self.print(self.write("rack.yaml", text % ("ground, rack", "from"))))


class Laws(Special):
    def test_a_drive_by_a_law_tells_its_effort(self):
        """What lifts the mass is m (g + s''), what swings the wheel I alpha; the other drive's power is that of both."""
        text = self.print(self.write("lift.yaml", LIFT % ""))
        self.assertEqual(self.run_test(text, "1e-13").stdout, "m: well\n")
        poses = [{"theta": 0.2 + 0.37 * k, "theta_rate": 20 - k, "theta_accel": 3 * k, "m": 5} for k in range(16)]
        rows = [self.find(text, routine, poses) for routine in ("motion", "efforts", "reactions")]
        for pose, (_, motion), (_, efforts), (status, found) in zip(poses, *rows):
            self.assertEqual(status, OK)
            lift, turn = 5 * (9.81 + motion["d_accel"]), 2 * motion["psi_accel"]
            self.assertAlmostEqual(found["d_effort"], lift, delta=1e-12 * abs(lift))
            self.assertAlmostEqual(found["psi_effort"], turn, delta=1e-12 * (1 + abs(turn)))
            power = lift * motion["d_rate"] + turn * motion["psi_rate"] + 0.1 * pose["theta_accel"] * pose["theta_rate"]
            self.assertAlmostEqual(efforts["theta_effort"] * pose["theta_rate"], power, delta=1e-10 * (1 + abs(power)))

    def test_the_engine_tells_the_same_and_the_test_can_fail(self):
        for name, model in (("followers", FOLLOWERS), ("rough", LIFT % ", friction: {coulomb: 0.2}")):
            text = self.print(self.write(name + ".yaml", model.replace("along: y", "along: 60 deg")))
            self.assertEqual(self.run_test(text).stdout, "m: well\n", name)
            efforts = [member for member in members(text, "reactions") if member.endswith("_effort")]
            self.assertEqual(len(efforts), 2)
            for effort in efforts:
                wrong, count = re.subn(r"(?m)^(    out->%s = )" % effort, r"\g<1>0.01 + ", text)
                self.assertGreater(count, 0)
                self.assertIn("reactions", self.run_test(wrong).stdout, effort)

    def test_where_constraints_repeat_others_they_are_left_out_and_the_file_says_so(self):
        with open(os.path.join(ROOT, "examples", "doubled-guide.yaml"), encoding="utf-8") as file:
            double = file.read().replace("lower: [0, -h]}}\njoints:", "lower: [0, -h]}, mass: 2, inertia: 0.01}\n  valve: {mass: 1}\njoints:")
        double = double.replace("drives: {", """  V: {slide: [ground, valve], along: y, distance: v}
laws: {lift: {period: 360 deg, segments: [{rise: {to: 180 deg, by: 0.1 m, law: cycloidal}}, {fall: {to: 360 deg, by: 0.1 m, law: cycloidal}}]}}
drives: {v: {law: lift, of: theta}, """)
        text = self.print(self.write("double.yaml", double))
        self.assertIn("The efforts of drives that follow laws are not part of it", text)
        self.assertNotIn("v_effort", members(text, "reactions"))
        self.assertNotIn("The efforts of drives", self.print(self.write("lift.yaml", LIFT % "")))


def chain(count, light=()):
    """Rods of 1 kg and 1 m, one hanging on the other; those in `light` weigh nothing, and the last one is then a point mass at its end."""
    bodies, joints = "  ground: {points: {J1: [0, 0]}}\n", ""
    for k in range(1, count + 1):
        mass = "" if k in light else ", mass: 1, center: [1, 0]" if light and k == count else ", mass: 1, center: [0.5, 0], inertia: 1/12"
        bodies += "  b%d: {points: {J%d: [0, 0], J%d: [1, 0]}%s}\n" % (k, k, k + 1, mass)
        joints += "  J%d: {pin: [%s, b%d], angle: q%d}\n" % (k, "b%d" % (k - 1) if k > 1 else "ground", k, k)
    return "gravity: [0, -9.81]\nbodies:\n%sjoints:\n%s" % (bodies, joints)


def fall(count, q, rate):
    """Accelerations of the rods' relative angles, from the equations of motion in absolute angles."""
    angle, spin = ([sum(of[:k + 1]) for k in range(count)] for of in (q, rate))
    weight = [[count - 1 - max(i, j) + (1 / 3 if i == j else 1 / 2) for j in range(count)] for i in range(count)]
    A = [[weight[i][j] * math.cos(angle[i] - angle[j]) for j in range(count)] for i in range(count)]
    b = [-sum(weight[i][j] * math.sin(angle[i] - angle[j]) * spin[j] ** 2 for j in range(count)) - 9.81 * (count - i - 0.5) * math.cos(angle[i])
         for i in range(count)]
    for k in range(count):
        for i in range(k + 1, count):
            share = A[i][k] / A[k][k]
            A[i] = [x - share * y for x, y in zip(A[i], A[k])]
            b[i] -= share * b[k]
    for k in reversed(range(count)):
        b[k] = (b[k] - sum(A[k][i] * b[i] for i in range(k + 1, count))) / A[k][k]
    return [b[k] - (b[k - 1] if k else 0) for k in range(count)]


class Chains(Special):
    def poses(self, count, poses):
        numbers = random.Random(count)
        return [{"q%d%s" % (k, end): numbers.uniform(-3, 3) for k in range(1, count + 1) for end in ("", "_rate")} for _ in range(poses)]

    def test_long_chains_fall_as_their_equations_say(self):
        for count in (5, 10):  # up to six are written out
            poses = self.poses(count, 10)
            rows = self.find(self.print(self.write("chain.yaml", chain(count))), "accelerations", poses)
            for pose, (status, found) in zip(poses, rows):
                wanted = fall(count, *([pose["q%d%s" % (k, end)] for k in range(1, count + 1)] for end in ("", "_rate")))
                self.assertEqual(status, OK, count)
                for k, one in enumerate(wanted):
                    self.assertAlmostEqual(found["q%d_accel" % (k + 1)], one, delta=1e-9 * (1 + max(map(abs, wanted))))

    def test_a_freedom_that_no_mass_shows_has_no_acceleration(self):
        """Two weightless links carry a link with a point mass: three freedoms, of which a point shows two."""
        for count, light in ((4, (2, 3)), (7, (5, 6))):
            rows = self.find(self.print(self.write("light.yaml", chain(count, light))), "accelerations", self.poses(count, 200))
            self.assertEqual({status for status, _ in rows}, {SINGULAR}, count)
        rows = self.find(self.print(self.write("light.yaml", chain(7, (6,)))), "accelerations", self.poses(7, 20))
        self.assertEqual({status for status, _ in rows}, {OK})


def truss(count, numbers):
    """Ternary links in a row, each with a leg to the ground and the ends with one more, of which a crank moves the first: one Assur
    group of 2 count + 2 links. All bodies have the world's axes at the start, so that all angles are 0."""
    def near(x, y):
        return "[%.6f, %.6f]" % (x + numbers.uniform(-0.3, 0.3), y + numbers.uniform(-0.3, 0.3))
    row = [near(2 * k, 2) for k in range(count + 1)]
    inner, ground = ([near(2 * k + 1, y) for k in range(count)] for y in (1.2, 0))
    first, last = near(-1.5, 0.5), near(2 * count + 1.5, 0.5)
    legs = [("e0", "E0", first, "P0", row[0]), ("e1", "E1", last, "P%d" % count, row[-1])]
    legs += [("l%d" % k, "G%d" % k, ground[k], "L%d" % k, inner[k]) for k in range(count)]
    mass = "mass: 1, center: %s, inertia: 0.1}"
    lines = ["gravity: [0, -9.81]", "bodies:", "  ground: {points: {O: [-1.7, 0.2], E1: %s, %s}}" % (last, ", ".join("G%d: %s" % at for at in enumerate(ground))),
             "  crank: {points: {O: [-1.7, 0.2], E0: %s}, %s" % (first, mass % first)]
    lines += ["  %s: {points: {%s: %s, %s: %s}, %s" % (*leg, mass % leg[4]) for leg in legs]
    lines += ["  t%d: {points: {P%d: %s, P%d: %s, L%d: %s}, %s" % (k, k, row[k], k + 1, row[k + 1], k, inner[k], mass % inner[k]) for k in range(count)]
    lines += ["joints:", "  O: {pin: [ground, crank], angle: q}", "  P0: {pin: [e0, t0]}", "  P%d: {pin: [e1, t%d]}" % (count, count - 1)]
    lines += ["  %s: {pin: [%s, %s]}" % (leg[1], "crank" if leg[0] == "e0" else "ground", leg[0]) for leg in legs]
    lines += ["  L%d: {pin: [l%d, t%d]}" % (k, k, k) for k in range(count)] + ["  P%d: {pin: [t%d, t%d]}" % (k, k - 1, k) for k in range(1, count)]
    return "\n".join(lines + ["start: {q: 0}", ""])


class Trusses(Special):
    def test_a_large_group_is_not_singular_because_its_determinant_is_small(self):
        text = self.print(self.write("truss.yaml", truss(8, random.Random(2))))
        self.assertEqual(self.run_test(text, "1e-9").stdout, "m: well\n")


if __name__ == "__main__":
    unittest.main()
