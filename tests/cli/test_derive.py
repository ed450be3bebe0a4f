"""yoke derive: sections, formats, numbers, and verdicts on equations."""
import math
import os
import re
import subprocess
import sys
import unittest
import xml.etree.ElementTree
from fractions import Fraction

from harness import Case, ROOT, Run, at_least, some

EXAMPLES = os.path.join(ROOT, "examples")
QUICK = os.path.join(ROOT, "examples", "quick-return.yaml")
TOGGLE = os.path.join(ROOT, "examples", "toggle.yaml")
RIGHT = "l1*cos(theta1) - d3*cos(theta2) = 0"
WRONG = "l1*cos(theta1) + d3*cos(theta2) = 0"


def formulas(answer):
    return [item for section in answer["sections"] for item in section["items"] if item["kind"] == "formula"]


class Derive(Case):
    def test_a_constant_is_printed_as_its_check_reads_it(self):
        """90 * 1e-6 in floating point is 0.00008999999999999999: not the file's number, and too long to be exact."""
        for given, printed in (("90 kg*mm^2", "0.00009"), ("1234567 kg*mm^2", "1.234567"), ("0.054981 kg*m^2", "0.054981"),
                               ("70.07 g*cm^2", "7.007e-6"), ("3.3 lb*in^2", None)):
            path = self.write("arm.yaml", """\
bodies:
  ground: {points: {O: [0, 0]}}
  arm: {points: {O: [0, 0], A: [1, 0]}, mass: 2 kg, center: [0.5, 0], inertia: %s}
joints: {O: {pin: [ground, arm], angle: theta}}
""" % given)
            (line,) = re.findall(r"I_arm = \S+ kg\*m\^2", self.good("derive", path).out)
            if printed:
                self.assertEqual(line, "I_arm = %s kg*m^2" % printed)
            if printed or len(line.split()[2]) < 18:
                self.assertIn("true for all dimensions", self.good("derive", path, "--check", line).out)

    def test_springs_in_pounds_and_inches_are_exact(self):
        """3 lbf/in is a fraction of 13 digits: multiplied by lengths in inches it was too large (E0650)."""
        machine = """\
units: {length: in, angle: deg, force: lbf, mass: lb}
gravity: [0, -386.4]
bodies:
  ground: {points: {O: [0, 0], G: [7, 2]}}
  arm: {points: {O: [0, 0], P: [6.5, 1.25]}, mass: 3, center: [3, 0.5], inertia: 5}
joints: {O: {pin: [ground, arm], angle: theta}}
springs:
  S: {%s}
start: {theta: 40 deg, theta.rate: 3 rad/s}
"""
        path = self.write("turned.yaml", machine % "along: theta, stiffness: 0.4, angle: 10, damping: 0.02")
        text = self.good("derive", path, "--what", "free-bodies,newton-euler,energy,lagrange").out
        k = 0.4 * 0.45359237 * 9.80665 * 0.0254 * 180 / math.pi
        self.assertAlmostEqual(float(re.search(r"k_S = (\S+)", text).group(1)), k, delta=1e-12 * k)
        path = self.write("pounds.yaml", machine % "between: [ground.G, arm.P], stiffness: 3, length: 2.25, damping: 0.35")
        text = self.good("derive", path, "--what", "free-bodies,newton-euler,energy,lagrange", "--numbers").out
        k = 3 * 0.45359237 * 9.80665 / 0.0254
        self.assertAlmostEqual(float(re.search(r"k_S = (\S+)", text).group(1)), k, delta=1e-12 * k)
        solved = self.good("solve", path, "--of", "arm.P.x,arm.P.y", "--format", "json").json()["configurations"][0]
        gap = math.hypot(solved["of"]["arm.P.x"] - 7 * 0.0254, solved["of"]["arm.P.y"] - 2 * 0.0254)
        shown = float(re.search(r"V_S = .* = (\S+)", text).group(1))
        self.assertAlmostEqual(shown, k * (gap - 2.25 * 0.0254) ** 2 / 2, delta=1e-4 * shown)

    def test_couples_on_one_body_have_names_of_their_own(self):
        """Spring, damper and law along one angle were all called M_S, friction and stop of one pin M_O."""
        path = self.write("arm.yaml", """\
parameters: {k: 3, c: 0.5, m: 2}
bodies:
  ground: {points: {O: [0, 0]}}
  arm: {points: {O: [0, 0]}, mass: m, center: [1, 0], inertia: 0.1}
joints: {O: {pin: [ground, arm], angle: q, friction: {viscous: 0.2, coulomb: 0.1, radius: 10 mm}}}
springs: {S: {along: q, stiffness: k, angle: 0.3, damping: c, torque: 2 N*m * angle^3}}
efforts: {q: 0.7}
drives: {q: 1 rad/s * t}
stops: {q: [-2, 2]}
""")
        for example in (path, os.path.join(EXAMPLES, "epicyclic-drive.yaml")):
            names, body = [], ""
            for section in self.good("derive", example, "--what", "free-bodies", "-q", "--format", "json").json()["sections"]:
                for item in section["items"]:
                    body = item["text"] if item["kind"] == "heading" else body
                    found = re.match(r"-? ?(M_\S+) = ", item["text"])
                    names += [(body, found.group(1))] if found else []
            self.assertEqual(len(names), len(set(names)), names)
            self.assertGreater(len(names), 4)

    def test_lengths_of_springs_are_defined_where_they_are_used(self):
        """Among the free bodies and the energies, each once; rows of M are the coordinates whose accelerations are its columns."""
        lengths = 0
        for name in ("car-axis", "floating-plate", "rocking-four-bar", "spring-slider-crank"):
            answer = self.good("derive", os.path.join(EXAMPLES, name + ".yaml"), "-q", "--format", "json").json()
            for section in answer["sections"]:
                items = [item for item in section["items"] if item["kind"] == "formula"]
                texts = [item["text"] for item in items]
                if section["title"] in ("Free bodies", "Energies"):
                    defined = [text.split("^2 = ")[0] for text in texts if re.match(r"L_\w+\^2 = ", text)]
                    self.assertEqual(sorted(set(re.findall(r"\bL_\w+", " ".join(texts)))), sorted(defined))
                    lengths += len(defined)
                for item in items:
                    if item["text"].startswith("M = "):
                        matrix, = item["matrices"]
                        self.assertEqual([row + "''" for row in matrix["rows"]], matrix["columns"])
        self.assertEqual(lengths, 12)

    def test_teeth_push_only_what_they_touch(self):
        """A body that acts at a pitch point is in mesh with the free body; what equal planets leave to their carrier has the gears' name."""
        for name in ("epicyclic-drive", "simple-planetary", "ferguson"):
            path = os.path.join(EXAMPLES, name + ".yaml")
            meshes = Run("gears", path, "--format", "json", "-q").json()["meshes"]
            pairs = [set(mesh["bodies"]) for mesh in meshes.values()]
            body, found = None, 0
            for line in self.good("derive", path, "--what", "free-bodies", "-q").out.splitlines():
                head, act = re.match(r"(\S+), body \d+$", line), re.match(r"  by (\S+) at Q\d+:", line)
                body = head.group(1) if head else body
                if act:
                    self.assertTrue({act.group(1), body} in pairs or act.group(1) in meshes, (name, body, line))
                    found += 1
            self.assertGreaterEqual(found, 2 * len(meshes))

    def test_all_that_there_is_comes_by_default(self):
        run = self.good("derive", QUICK)
        for title in ("Loop equations", "Jacobian", "Velocities", "Accelerations"):
            self.assertRegex(run.out, "(?m)^%s\n=+$" % title)
        self.assertIn("  x:  l1 cos(theta1) - d3 cos(theta2) = 0\n", run.out)

    def test_what_chooses_and_keeps_the_order_of_the_book(self):
        run = self.good("derive", QUICK, "--what", "velocity,loops")
        self.assertLess(run.out.index("Loop equations"), run.out.index("Velocities"))
        self.assertNotIn("Jacobian", run.out)

    def test_an_unknown_part_is_refused_with_a_hint(self):
        run = Run("derive", QUICK, "--what", "jacobien")
        self.assertEqual(run.code, 2)
        self.assertIn("jacobian", run.err)

    def test_json_holds_J_with_its_blocks(self):
        answer = self.good("derive", QUICK, "--what", "jacobian", "--format", "json").json()
        matrix = formulas(answer)[0]["matrices"][0]
        self.assertEqual(matrix["columns"], ["theta1", "theta2", "d3", "theta4", "d5"])
        self.assertEqual((matrix["row_cuts"], matrix["column_cuts"]), ([2], [1, 3]))
        self.assertEqual(len(matrix["entries"]), 4)
        self.assertEqual(matrix["entries"][2][4], "-1")
        self.assertNotIn("values", matrix)

    def test_numbers_are_those_of_solve(self):
        pose = ("--at", "theta1=40deg", "--rate", "theta1=2", "--accel", "theta1=0.5")
        solved = self.good("solve", QUICK, *pose, "--format", "json").json()["configurations"][0]["coordinates"]
        answer = self.good("derive", QUICK, *pose, "--what", "velocity,acceleration", "--numbers", "--format", "json").json()
        seen = 0
        for item in formulas(answer):
            found = re.match(r"(theta2|theta4|d3|d5)('+) = ", item["text"])
            if not found:
                continue
            value = solved[found.group(1)]["velocity" if found.group(2) == "'" else "acceleration"]
            self.assertTrue(math.isclose(item["value"], value, rel_tol=1e-10, abs_tol=1e-12), item["text"])
            seen += 1
        self.assertEqual(seen, 8)

    def test_beside_a_limit_a_number_is_right_or_is_not_there(self):
        """The sine that it is divided by is as the root of what is left to the limit: from some place on, rounding decides its digits."""
        for left, is_shown in ((1e-3, True), (1e-6, True), (1e-9, True), (1e-12, False), (1e-13, False)):
            at = ("--at", "theta1=%rrad" % (math.acos(0.45) - left), "--format", "json", "-q")
            solved = self.good("solve", self.rocker, *at).json()["configurations"][0]["coordinates"]
            answer = self.good("derive", self.rocker, *at, "--what", "velocity,acceleration", "--numbers").json()
            rates = [(item, re.match("(theta[23])('+) = ", item["text"])) for item in formulas(answer)]
            rates = [(item, found.group(1), found.group(2)) for item, found in rates if found]
            self.assertEqual([(name, dots) for _, name, dots in rates], [(name, dots) for dots in ("'", "''") for name in ("theta2", "theta3")])
            for item, name, dots in rates:
                self.assertEqual("value" in item, is_shown, (left, item["text"]))
                wanted = solved[name]["velocity" if dots == "'" else "acceleration"]
                self.assertAlmostEqual(item.get("value", wanted), wanted, delta=1e-9 * abs(wanted))

    def test_a_wrong_value_is_a_wrong_request_and_a_pose_out_of_reach_an_answer(self):
        for option in (("--numbers",), ("--check", "l1 = l1"), ("--svg", self.path("pictures"))):
            self.wrong(403, "derive", QUICK, *option, "--at", "theta1=foo")
            self.wrong(403, "derive", QUICK, *option, "--effort", "theta1=foo")
            run = Run("derive", self.rocker, *option, "--at", "theta1=170deg")
            self.assertEqual((run.code, run.out), (1, ""), run.err)
            self.assertEqual(run.err.count("[E0602]"), 1, run.err)

    def test_text_shows_values_beside_the_symbols(self):
        run = self.good("derive", QUICK, "--what", "velocity", "--numbers")
        self.assertRegex(run.out, r"theta2' = l1 cos\(theta1 - theta2\) / d3 \* theta1' = -0\.202703\n")

    def test_mathml_is_well_formed(self):
        text = self.good("derive", TOGGLE, "--format", "mathml", "--numbers").out
        found = re.findall(r"<math.*?</math>", text, re.S)
        self.assertGreater(len(found), 20)
        for formula in found:
            xml.etree.ElementTree.fromstring(formula)

    def test_latex_is_a_document(self):
        text = self.good("derive", TOGGLE, "--format", "latex").out
        self.assertTrue(text.startswith("\\documentclass{article}"))
        self.assertEqual(text.count("\\["), text.count("\\]"))
        self.assertEqual(text.count("\\begin{array}"), text.count("\\end{array}"))

    def test_an_unknown_format_is_refused(self):
        run = Run("derive", QUICK, "--format", "csv")
        self.assertEqual(run.code, 2)
        self.assertIn("latex", run.err)


# Conditions of a polynomial of degree 20: places in degrees, values in mm and mm/rad.
DEGREE_20 = [(0, "svajp", (0,) * 5), (30, "s", (3,)), (60, "sv", (11, 2)), (75, "s", (17,)), (100, "sv", (20, 0)), (120, "s", (19,)),
             (140, "sv", (18, 1)), (160, "s", (12,)), (200, "s", (10,)), (240, "svajp", (0,) * 5)]
CAM = """laws:
  lift:
    period: 2*pi
    segments:
      - polynomial: [%s]
      - {dwell: {to: 2*pi}}
cams: {c: {cam: shaft, follower: tappet, law: lift, face: flat, base: 900 mm}}
bodies: {shaft: {}, tappet: {}}
joints: {K: {pin: [ground, shaft], angle: theta}, T: {slide: [ground, tappet], along: y, distance: s}}
"""


def exact_coefficients(conditions):
    """Of s/h in powers of u, by Gauss and Jordan in exact fractions; h = 20 mm, u = theta / (4 pi/3)."""
    beta = Fraction(math.pi) * 4 / 3
    rows, n = [], sum(len(kinds) for _, kinds, _ in conditions)
    for at, kinds, values in conditions:
        for kind, value in zip(kinds, values):
            order, u = "svajp".index(kind), Fraction(at, 240)
            row = [math.perm(k, order) * u ** (k - order) if k >= order else Fraction(0) for k in range(n)]
            rows.append(row + [Fraction(value, 20) * beta ** order])
    for column in range(n):
        pivot = next(r for r in range(column, n) if rows[r][column] != 0)
        rows[column], rows[pivot] = rows[pivot], rows[column]
        rows[column] = [x / rows[column][column] for x in rows[column]]
        for r in range(n):
            if r != column and rows[r][column] != 0:
                rows[r] = [x - rows[r][column] * y for x, y in zip(rows[r], rows[column])]
    return [row[-1] for row in rows]


class Cam(Case):
    def coefficients(self, file):
        answer = self.good("derive", file, "--what", "cam", "--numbers", "--format", "json").json()
        return {f["text"].split(" = ")[0]: f for f in formulas(answer) if re.match(r"[Cc]\d+ = ", f["text"])}

    def test_degree_20_keeps_its_digits(self):
        conditions = ", ".join("{at: %d deg, %s}" % (at, ", ".join("%s: %d mm%s" % (k, v, "/rad" * (k == "v")) if v else k + ": 0"
                                                                  for k, v in zip(kinds, values))) for at, kinds, values in DEGREE_20)
        found = self.coefficients(self.write("degree-20.yaml", CAM % conditions))
        expected = exact_coefficients(DEGREE_20)
        self.assertEqual(len(expected), 21)
        for k, value in enumerate(expected):
            if value == 0:
                self.assertEqual(found["C%d" % k]["text"], "C%d = 0" % k)
                continue
            digits = float(found["c%d" % k]["text"].split(" = ")[1])
            self.assertAlmostEqual(digits / float(value), 1, delta=1e-12)
            power = float(value) * 0.02 / (4 * math.pi / 3) ** k
            self.assertAlmostEqual(found["C%d" % k]["value"] / power, 1, delta=1e-12)

    def test_the_cep_cam_to_the_last_digit(self):
        found = self.coefficients(os.path.join(EXAMPLES, "cep-cam.yaml"))
        for k, text, factor in ((3, "27 h/pi^3", 64), (4, "-243/4 h/pi^4", -192), (5, "729/16 h/pi^5", 192), (6, "-729/64 h/pi^6", -64)):
            self.assertEqual(found["C%d" % k]["text"], "C%d = %s" % (k, text))
            expected = factor * 0.2 / (4 * math.pi / 3) ** k
            self.assertAlmostEqual(found["C%d" % k]["value"] / expected, 1, delta=1e-13)


class Check(Case):
    def verdict(self, *equations, code=0, file=QUICK, stdin=None):
        words = [word for equation in equations for word in ("--check", equation)]
        run = Run("derive", file, *words, "--format", "json", stdin=stdin)
        self.assertEqual(run.code, code, run.err)
        return run.json()["checks"]

    def test_a_right_equation_exits_0(self):
        self.assertEqual(self.verdict(RIGHT)[0]["verdict"], "true")

    def test_a_wrong_one_exits_1_with_a_pose_and_a_hint(self):
        answer = self.verdict(WRONG, code=1)[0]
        self.assertEqual(answer["verdict"], "false")
        self.assertGreater(abs(answer["left"] - answer["right"]), 0.1)
        pose = {name: motion["position"] for name, motion in answer["pose"].items()}
        self.assertAlmostEqual(0.75 * math.cos(pose["theta1"]) + pose["d3"] * math.cos(pose["theta2"]), answer["left"], 12)
        self.assertIn("`d3*cos(theta2)`", answer["hint"])

    def test_what_only_these_numbers_make_true(self):
        self.assertEqual(self.verdict("l1 = 3/4")[0]["verdict"], "true-here")

    def test_rates_in_both_ways_of_writing(self):
        for equation in ("d3*theta2' = l1*cos(theta1 - theta2)*theta1'", "d3 theta2.rate = l1 cos(theta1 - theta2) theta1.rate",
                         "d3*theta2'' + 2*d3'*theta2' = l1*cos(theta1-theta2)*theta1.accel - l1*sin(theta1-theta2)*theta1'^2"):
            self.assertEqual(self.verdict(equation)[0]["verdict"], "true", equation)

    def test_standard_input_gives_one_a_line(self):
        answers = self.verdict("-", code=1, stdin="# mine\n%s\n\n%s\n" % (RIGHT, WRONG))
        self.assertEqual([answer["verdict"] for answer in answers], ["true", "false"])

    def test_text_is_kind_and_exact(self):
        run = Run("derive", QUICK, "--check", WRONG)
        self.assertEqual(run.code, 1)
        self.assertRegex(run.out, r"false: the left side is 1\.29904, the right side 0")
        self.assertIn("theta1 = 0.523599 rad (30 deg)", run.out)
        self.assertIn("with the other sign before `d3*cos(theta2)` it would be true", run.out)

    def test_a_mistake_in_the_equation_is_shown_with_a_caret(self):
        run = Run("derive", QUICK, "--check", "l1*cos(theta1) = nonsense")
        self.assertEqual(run.code, 2)
        self.assertIn("unknown name `nonsense`", run.err)
        self.assertIn("                 ^~~~~~~~", run.err)

    def test_a_gear_trains_willis_equation(self):
        train = os.path.join(ROOT, "examples", "epicyclic.yaml")
        self.assertEqual(self.verdict("N1*(theta1' - thetaC') = -N2*theta2'", file=train)[0]["verdict"], "true")
        self.assertEqual(self.verdict("N1*(theta1' - thetaC') = N2*theta2'", file=train, code=1)[0]["verdict"], "false")

    def test_a_chain_is_taken_pair_by_pair(self):
        answers = self.verdict("l1 = 3/4 = 750 mm", "l1 == 3/4")
        self.assertEqual([answer["equation"] for answer in answers], ["l1 = 3/4", "3/4 = 750 mm", "l1 == 3/4"])
        self.assertEqual([answer["verdict"] for answer in answers], ["true-here", "true", "true-here"])

    def test_a_machine_is_named_at_which_it_does_not_hold(self):
        answer = self.verdict("l1 = 3/4")[0]
        self.assertEqual(answer["other_dimensions"], "false")
        named = re.fullmatch(r"l1 = ([0-9.]+)", answer["false_at"]["parameters"])
        self.assertEqual(float(named[1]), answer["false_at"]["left"])
        self.assertEqual(Run("derive", QUICK, "--param", "l1=" + named[1], "--check", "l1 = 3/4").code, 1)
        run = Run("derive", QUICK, "--check", "l1 = 3/4")
        self.assertIn("true only with this file's numbers (at 24 poses); with l1 = %s (SI) it is false" % named[1], run.out)

    def test_what_drives_do_is_told_apart(self):
        self.assertEqual(self.verdict("theta1' = -0.5 rad/s")[0]["verdict"], "true-driven")
        self.assertIn("as this file's drives move", Run("derive", QUICK, "--check", "theta1' = -0.5 rad/s").out)


# What a page prints must not be called false on its own machine.
class LongMachines(Case):
    def chain(self, count):
        run = subprocess.run([sys.executable, os.path.join(ROOT, "tools", "make-model"), "chain", str(count)],
                             capture_output=True, text=True, check=True)
        return self.write("chain.yaml", run.stdout)

    def test_a_hundred_bodies_are_no_hindrance_to_a_proof(self):
        out = self.good("derive", self.chain(100), "--check", "link3.rate = link2.rate + q3'").out
        self.assertIn("\n  true: proved", out)

    def test_what_is_too_large_for_a_proof_is_tried_at_poses(self):
        run = Run("derive", self.chain(1000), "--check", "link3.rate = link2.rate + q3'", "--check", "link3.rate = link2.rate",
                  "--check", "link900.angle = link899.angle + q900", "--check", "cos(link3.angle) = cos(link2.angle + q3)")
        self.assertIn("\n  true at 24 poses of this machine, not proved: it is too large for that\n", run.out)
        verdicts = [line.split()[0] for line in run.out.splitlines() if re.match(r"  (true|false)", line)]
        self.assertEqual(verdicts, ["true", "false:", "true", "true"])


class Printed(Case):
    CONTEXT = re.compile(r"\^\{|\b[FMNTWSDRQev]_|work of the|tan\(alpha\)|^rho = |^x = lift_v$")

    def equations(self, path, *options):
        for section in self.good("derive", path, "--format", "json", *options).json()["sections"]:
            for item in section["items"]:
                if item["kind"] != "formula" or item.get("matrices"):
                    continue
                sides = item["text"].split("=")
                for left, right in zip(sides, sides[1:]):
                    yield section["name"], item.get("remark", ""), "%s = %s" % (left.strip(), right.strip())

    def lock_of(self, path, section, remark):
        with open(path) as file:
            has_lock = re.search(r"^\s+%s:\s+\{(hold|join)" % re.escape(remark), file.read(), re.M) if remark else None
        return remark if section == "gears" and has_lock else None

    def test_every_printed_equation_is_true_or_says_what_it_needs(self):
        proved = tried = driven = 0
        for name in some(sorted(os.listdir(EXAMPLES))):
            path = os.path.join(EXAMPLES, name)
            if not name.endswith(".yaml"):
                continue
            by_lock = {}
            for section, remark, equation in self.equations(path):
                by_lock.setdefault(self.lock_of(path, section, remark), []).append(equation)
            for lock, equations in by_lock.items():
                locked = ("--lock", lock) if lock else ()
                run = Run("derive", path, "--check", "-", "--format", "json", *locked, stdin="\n".join(equations))
                answers = run.json()["checks"]
                self.assertEqual([answer["equation"] for answer in answers], equations, name)
                for answer in answers:
                    word = answer["verdict"]
                    if word == "unreadable":
                        self.assertRegex(answer["equation"], self.CONTEXT, "%s: %s" % (name, answer["message"]))
                        continue
                    self.assertIn(word, ("true", "true-here", "true-driven"), "%s: %s" % (name, answer["equation"]))
                    proved += word == "true"
                    tried += word == "true-here"
                    driven += word == "true-driven"
        self.assertGreater(proved, at_least(2000))
        self.assertGreater(tried, at_least(500))
        self.assertGreater(driven, at_least(100))


if __name__ == "__main__":
    unittest.main(argv=sys.argv)
