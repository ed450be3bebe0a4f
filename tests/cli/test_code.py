"""yoke code: the printed C compiles clean, agrees with the engine at other poses and parameters, and says what it leaves out.

CC is the compiler; with YOKE_FEW only some of the examples are compiled."""
import ctypes
import glob
import math
import os
import random
import re
import subprocess
import unittest

from harness import Case, FOUR_BAR, FULL, ROOT, Run, third
from test_locks import PLANETARY

CC = os.environ.get("CC", "cc")
WARNINGS = ["-std=c11", "-Wall", "-Wextra", "-Wpedantic", "-Wconversion", "-Werror"]
EXAMPLES = sorted(glob.glob(os.path.join(ROOT, "examples", "*.yaml")))
OTHERS = {"andrews", "double-pendulum", "quick-return", "jansen", "gas-engine", "double-butterfly", "car-axis", "five-bar",
          "swing-cam", "epicyclic-drive", "scotch-yoke", "elliptic-trammel", "excavator"}  # compiled with other parameters too
FEW = {"quick-return", "double-pendulum", "double-butterfly", "valve-cam"}
NUMBER = re.compile(r"\b\d+\.\d*(?:e-?\d+)?\b|\b\d+e-?\d+\b")


def name_of(path):
    return os.path.splitext(os.path.basename(path))[0]


def parts(text):
    """The file as: what comes before its values, its values (defaults, start), its functions, its self-test."""
    cut = {}
    for function in ("defaults", "start"):
        match = re.search(r"(?ms)^\w+ m_%s\(void\)\n\{.*?^\}\n" % function, text)
        cut[function] = match.group(0)
        text = text.replace(match.group(0), "<%s>" % function)
    body, test = text.split("#ifdef m_TEST", 1)
    return body, cut, test


def joined(body, cut, test):
    for function, own in cut.items():
        body = body.replace("<%s>" % function, own)
    return body + "#ifdef m_TEST" + test


def random_tree(numbers):
    """A model of 2 to 5 moving bodies, each on one before it, by a joint whose freedom is an input."""
    def some(size, least=None):
        number = numbers.uniform(-size, size) if least is None else numbers.uniform(least, size)
        return "%.6f" % number

    count = numbers.randint(2, 5)
    points = [{} for _ in range(count + 1)]
    points[0]["P"] = points[count]["P"] = "[%s, %s]" % (some(0.5), some(0.5))
    joints, starts, loads = [], [], []
    for k in range(1, count + 1):
        on = numbers.randint(0, k - 1)
        for body in (on, k):
            points[body]["J%d" % k] = "[%s, %s]" % (some(0.5), some(0.5))
        kind = numbers.choice(("pin", "pin", "slide", "pin-slot"))
        freedom = {"pin": "angle: q%d", "slide": "along: %s rad, distance: q%%d" % some(3),
                   "pin-slot": "along: %s rad, distance: q%%d, angle: r%d" % (some(3), k)}[kind] % k
        joints.append("  J%d: {%s: [b%d, b%d], %s}" % (k, kind, on, k, freedom))
        starts += ["q%d: %s" % (k, some(1)), "q%d.rate: %s" % (k, some(2))]
        if kind == "pin-slot":
            starts += ["r%d: %s" % (k, some(2)), "r%d.rate: %s" % (k, some(2))]
        loads.append("q%d: %s" % (k, some(4)))
    bodies = ["  b%d: {points: {%s}%s}" % (k, ", ".join("%s: %s" % pair for pair in places.items()),
              ", mass: %s, center: [%s, %s], inertia: %s" % (some(3, 0.2), some(0.3), some(0.3), some(0.1, 0.01)) if k else "")
              for k, places in enumerate(points)]
    text = "\n".join(["gravity: [%s, -9.81]" % some(2), "bodies:", *bodies, "joints:", *joints,
                      "efforts: {%s}" % ", ".join(loads[:2]),
                      "springs:", "  S: {between: [b0.P, b%d.P], stiffness: %s, length: 0.3, damping: %s}" % (
                          count, some(40, 5), some(2, 0.1)),
                      "  P: {between: [b0.P, b%d.P], force: '%s N/m^3 * (length - 0.2 m)^3 + %s N*s/m * rate*cos(1 rad/s * t)'}" % (
                          count, some(40, 5), some(2, 0.1)),
                      "  A: {along: q1, %s}" % ("torque: '1 N*m * sin(angle) + 0.3 N*m/rad^3 * angle^3'" if "{pin:" in joints[0] else "force: {law: B, of: length}"),
                      "laws: {B: {table: [[-1, -3], [0, 0], [1, 5]], between: cubic}}",
                      "forces:", "  F: {body: b%d, at: P, value: [%s, %s]}" % (count, some(5), some(5)),
                      "start: {%s}" % ", ".join(starts), ""])
    return re.sub(r"\bb0\b", "ground", text)


# Two coordinates that follow a third by laws: of an angle and of a distance, one joint turned about.
FOLLOWERS = """\
gravity: [0.3, -9.81]
bodies:
  ground: {points: {O: [0, 0], P: [1, 0.2]}}
  a: {points: {O: [0.1, 0], S: [0.2, 0.5]}, mass: 1.3, center: [0.2, 0.1], inertia: 0.1}
  b: {points: {P: [0, 0.1]}, mass: 0.7, center: [0.1, -0.2], inertia: 0.05}
  c: {points: {S: [0, 0]}, mass: 0.5, center: [0.1, 0.3], inertia: 0.04}
joints:
  O: {pin: [ground, a], angle: q}
  P: {pin: [b, ground], angle: r}
  S: {slide: [a, c], along: 0.4 rad, distance: x}
laws:
  lift: {period: 2*pi, segments: [{rise: {to: 3 rad, by: 0.05, law: 3-4-5}}, {fall: {to: 2*pi, by: 0.05, law: harmonic}}]}
  swing: {period: 2*pi, segments: [{rise: {to: 3 rad, by: 0.4 rad, law: cycloidal}}, {fall: {to: 2*pi, by: 0.4 rad, law: 3-4-5}}]}
drives: {x: {law: lift, of: q}, r: {law: swing, of: q}}
efforts: {q: 3}
start: {q: 0.7, q.rate: 2}
"""

# In place of the mesh of a five-bar.
LAW = ("laws:\n  l: {period: 2*pi, segments: [{rise: {to: 3 rad, by: 0.3 rad, law: 3-4-5}}, "
       "{fall: {to: 2*pi, by: 0.3 rad, law: cycloidal}}]}")


def random_train(numbers):
    """An arm that turns about the ground, with a wheel that meshes with two others on it, one of them a ring, with a
    pulley on its belt and a rack; every body heavy, with its centre beside its shaft."""
    def some(size, least=None):
        return numbers.uniform(-size, size) if least is None else numbers.uniform(least, size)

    teeth = [numbers.randint(12, 30), numbers.randint(12, 30)]
    teeth.append(teeth[0] + numbers.randint(20, 40))
    module, along, across = some(0.02, 0.005), some(3), some(3)
    apart = [module * (teeth[0] + teeth[1]) / 2, module * (teeth[2] - teeth[0]) / 2]
    at = [(0.1, -0.2)]
    for k, angle in enumerate((some(3), some(3))):
        at.append((at[0][0] + apart[k] * math.cos(angle), at[0][1] + apart[k] * math.sin(angle)))
    at.append((some(0.5), some(0.5)))
    radius = some(0.2, 0.05)

    # one wheel in two is named first on its shaft
    pairs = [("arm", "w%d" % k) if numbers.randint(0, 1) else ("w%d" % k, "arm") for k in range(4)]

    def rack_line(sense):
        return at[0][0] - sense * radius * math.sin(across), at[0][1] + sense * radius * math.cos(across)

    points = ", ".join("W%d: [%.17g, %.17g]" % (k, x, y) for k, (x, y) in enumerate(at))
    heavy = "mass: %.6f, center: [%.6f, %.6f], inertia: %.6f"

    def mass():
        return heavy % (some(3, 0.2), some(0.1), some(0.1), some(0.1, 0.01))

    lines = ["gravity: [%.6f, -9.81]" % some(2), "bodies:", "  ground: {points: {O: [0, 0]}}",
             "  arm: {points: {O: [%.6f, %.6f], %s, R: [%.17g, %.17g]}, %s}" % (some(0.3), some(0.3), points, *rack_line(numbers.choice((-1, 1))), mass()),
             *["  w%d: {points: {W%d: [0, 0]}, %s}" % (k, k, mass()) for k in range(4)],
             "  bar: {points: {R: [0, 0]}, %s}" % mass(),
             "joints:", "  O: {pin: [ground, arm], angle: q}",
             *["  W%d: {pin: [%s]%s}" % (k, ", ".join(pair), ", angle: p" if k == 0 else ", angle: s%d" % k) for k, pair in enumerate(pairs)],
             "  R: {slide: [arm, bar], along: %.17g rad, distance: x}" % across,
             "gears:", "  g: {mesh: [w0, w1], teeth: [%d, %d], carrier: arm, pressure_angle: %d deg}" % (*teeth[:2], numbers.choice((20, 25))),
             "  h: {mesh: [w0, w2], teeth: [%d, %d], carrier: arm, internal: true}" % (teeth[0], teeth[2]),
             "belts: {b: {between: [w1, w3], radii: [0.1, %.6f], crossed: %s}}" % (some(0.3, 0.05), numbers.choice(("true", "false"))),
             "racks: {r: {pinion: w0, rack: bar, radius: %.17g}}" % radius,
             "efforts: {p: %.6f}" % some(5),
             "start: {q: %.6f, q.rate: %.6f, p: %.6f, p.rate: %.6f}" % (along, some(2), some(2), some(3)), ""]
    return "\n".join(lines)


class Printed(Case):
    """What a machine is printed as, compiled without a warning."""

    def compile(self, text, *options, name="m"):
        """With the optimiser, which sees more to warn of, a few machines in the gate and all of them under YOKE_FULL."""
        source = self.write(name + ".c", text)
        program = self.path(name)
        level = "-O1" if name in FEW or FULL else "-O0"
        done = subprocess.run([CC, *WARNINGS, level, source, *options, "-lm", "-o", program], capture_output=True,
                              encoding="utf-8", check=False)
        self.assertEqual(done.returncode, 0, name + "\n" + done.stderr[:3000])
        return program

    def run_test(self, text, tolerance="1e-12", name="m"):
        program = self.compile(text, "-Dm_TEST", "-Dm_TOLERANCE=" + tolerance, name=name)
        return subprocess.run([program], capture_output=True, encoding="utf-8", check=False)

    def print(self, file, *words):
        return self.good("code", file, "--prefix", "m", "--quiet", *words).out

    def library(self, text):
        return ctypes.CDLL(self.compile(text, "-shared", "-fPIC"))


def unit_of(section, parameter, value):
    """What a bare number of the file is in SI, where a parameter is given as one; 1 otherwise."""
    number = re.search(r"\b%s: (-?[\d.]+)\s*(,|$)" % re.escape(parameter), section)
    return value / float(number.group(1)) if number and float(number.group(1)) != 0 and value != 0 else 1


def units(text, struct):
    """The members of a printed struct, and what their comments say."""
    return dict(re.findall(r"(?m)^    double (\w+); +/\* (.*?) \*/$", re.search(r"(?s)typedef struct m_%s \{(.*?)\n\}" % struct, text).group(1)))


def tables(text, routine):
    """What the self-test of a routine compares: its rows of inputs, the values wanted and the scales."""
    body = re.search(r"(?s)static int m_test_%s\(void\)\n\{(.*?)\n\}\n" % routine, text).group(1)
    found = []
    for name, shape, values in re.findall(r"(?s)static const double (\w+)((?:\[\d+\])+) = \{(.*?)\};", body):
        *_, width = map(int, re.findall(r"\d+", shape))
        numbers = [float(number) for number in re.findall(r"[-+.\w]+", values)]
        found.append([numbers[k:k + width] for k in range(0, len(numbers), width)])
    return found


class Code(Printed):
    def test_every_example_compiles_clean_and_agrees_with_the_engine(self):
        """Every third in the gate: tests/bits knows the text that is printed of each."""
        chosen = [name_of(path) for path in (EXAMPLES if FULL else third(EXAMPLES, 0))]
        for path in EXAMPLES:
            name = name_of(path)
            if name not in FEW and ("YOKE_FEW" in os.environ or name not in chosen):
                continue
            with self.subTest(name):
                done = self.run_test(self.print(path), name=name)
                self.assertEqual(done.stdout, "m: well\n", name)

    def test_random_trees_agree_with_the_engine(self):
        """Pins, slides and welds, centres beside the joints, springs, torques and point forces; compared by the self-test."""
        for seed in range(3 if "YOKE_FEW" in os.environ else 9 if FULL else 5):
            done = self.run_test(self.print(self.write("tree.yaml", random_tree(random.Random(seed)))), "1e-11", name="tree%d" % seed)
            self.assertEqual(done.stdout, "m: well\n", "seed %d" % seed)

    def test_springs_between_joined_ends_have_no_direction(self):
        """Rounding alone is between the ends: nothing pulls by the length that the spring lacks, in no one's direction."""
        with open(os.path.join(ROOT, "examples", "watt-with-masses.yaml"), encoding="utf-8") as file:
            text = file.read() + "springs:\n" + "".join(
                "  s%s: {between: [%s.%s, %s.%s], stiffness: 1000, length: 0.3, damping: 2}\n" % (p, a, p, b, p)
                for a, b, p in (("BCD", "CFG", "C"), ("BCD", "DE", "D"), ("EF", "CFG", "F")))
        code = self.print(self.write("joined.yaml", text))
        self.assertIn("m_find_reactions", code)
        self.assertEqual(self.run_test(code).stdout, "m: well\n")
        code = self.print(self.write("joined.yaml", text), "--single")
        self.assertEqual(self.run_test(code, "2e-3").stdout, "m: well\n")

    def test_random_trains_agree_with_the_engine(self):
        """Gears outside and inside, a belt and a rack on an arm that turns; their reactions too."""
        for seed in range(2 if "YOKE_FEW" in os.environ else 6 if FULL else 3):
            text = self.print(self.write("train.yaml", random_train(random.Random(seed))))
            self.assertIn("m_find_reactions", text)
            done = self.run_test(text, "1e-10", name="train%d" % seed)
            self.assertEqual(done.stdout, "m: well\n", "seed %d" % seed)

    def test_what_follows_by_a_law_is_in_the_reactions(self):
        text = self.print(self.write("followers.yaml", FOLLOWERS))
        self.assertIn("m_find_reactions", text)
        self.assertEqual(self.run_test(text).stdout, "m: well\n")

    def test_reactions_contain_what_teeth_and_cams_transmit(self):
        """Their forces, where one is known, are results that the self-test compares with the engine's: with another sign it fails."""
        for example, contact in (("planetary-gear", "inner"), ("valve-cam", "intake"), ("flat-faced-cam", "disc")):
            text = self.print(os.path.join(ROOT, "examples", example + ".yaml"))
            self.assertEqual(self.run_test(text).stdout, "m: well\n", example)
            for end in ("force_x", "force_y"):
                name = "%s_%s" % (contact, end)
                self.assertRegex(text, r"double %s;" % name)
            wrong, count = re.subn(r"(?m)^(    out->%s_force_y = )" % contact, r"\g<1>3 + ", text)
            self.assertEqual(count, 1, example)
            self.assertIn("reactions", self.run_test(wrong).stdout, example)

    def test_cams_that_parameters_move_push_where_the_engine_says(self):
        """The place of a follower's pin or line is a parameter, and so is that line's direction."""
        machine = """parameters: {px: 80 mm, al: 90 deg}
laws:
  lift: {period: 2*pi, segments: [{rise: {to: 180 deg, by: %s, law: cycloidal}}, {fall: {to: 360 deg, by: %s, law: cycloidal}}]}
bodies:
  ground: {points: {K: [0, 0], P: [%s, 5 mm]}}
  shaft: {points: {K: [0, 0]}}
  lever: {points: {P: [0, 0]}, mass: 1 kg, center: [-20 mm, 10 mm], inertia: 0.001 kg*m^2}
joints:
  K: {pin: [ground, shaft], angle: theta}
  P: {%s}
cams: {c: {cam: shaft, follower: lever, law: lift, base: 30 mm, %s}}
gravity: [0, -9.81]
drives: {theta: 1.4 rad + 2 rad/s * t}
"""
        pin = "pin: [ground, lever], angle: psi"
        slide = "slide: [ground, lever], along: al, from: P, distance: s"
        for name, joint, place, lift, touch in (
                ("flat", pin, "px", "15 deg", "face: flat"), ("roller", pin, "px", "15 deg", "roller: 8 mm, arm: 70 mm"),
                ("tappet", slide, "px/8", "15 mm", "roller: 8 mm")):
            path = self.write(name + ".yaml", machine % (lift, lift, place, joint, touch))
            body, cut, _ = parts(self.print(path))
            _, cut, test = parts(self.print(path, "--param", "px=95 mm", "--param", "al=80 deg"))
            self.assertEqual(self.run_test(joined(body, cut, test)).stdout, "m: well\n", name)
            for change, others in (("px=95mm", "px=80mm:95mm:2"), ("al=80deg", "al=90deg:80deg:2")):
                asked = ("--of", "c.force.x", "--quiet")
                told = self.good("solve", path, "--param", change, *asked).out
                rows = self.good("study", path, "--vary", others, *asked, "--format", "json").json()["rows"]
                own = float(re.search(r"c\.force\.x +(\S+)", told).group(1))
                self.assertAlmostEqual(rows[1][-1], own, delta=1e-5 * abs(own), msg=name + " " + change)

    def test_laws_are_solved_together_with_loops(self):
        """A five-bar whose fourth angle follows its second by a law, both unknown: Newton's method calls the law."""
        with open(os.path.join(ROOT, "examples", "geared-five-bar.yaml"), encoding="utf-8") as file:
            text = re.sub(r"(?m)^gears:.*$", LAW, file.read())
        text = text.replace("1 rad/s * t}", "1 rad/s * t, t4: {law: l, of: t2}}")
        for words in ([], ["--kinematics"]):
            code = self.print(self.write("law.yaml", text), *words)
            self.assertEqual(self.run_test(code).stdout, "m: well\n", words)

    def test_locks_are_engaged(self):
        """A planetary drive with heavy wheels: each of its locks, by name."""
        for lock in ("held", "direct", "stopped"):
            text = self.print(self.write("planetary.yaml", PLANETARY), "--lock", lock)
            self.assertIn("Its lock %s is engaged." % lock, text)
            self.assertEqual(self.run_test(text).stdout, "m: well\n", lock)

    def test_the_self_test_of_a_machine_beside_its_limit_is_well(self):
        """There two ways to the same numbers differ by more than the test allows: it compares nothing where rounding decides."""
        text = ("bodies:\n  ground: {points: {O: [0, 0]}}\n  a: {points: {O: [0, 0], A: [0.5, 0]}}\n"
                "  b: {points: {A: [0, 0], B: [0.5, 0]}}\n  s: {points: {B: [0, 0]}, mass: 2}\njoints:\n"
                "  O: {pin: [ground, a], angle: q}\n  A: {pin: [a, b], angle: p}\n  B: {pin: [b, s]}\n"
                "  S: {slide: [ground, s], along: x, from: O, to: B, distance: d}\n"
                "springs: {K: {along: q, stiffness: 3, angle: 0.1}}\n"
                "start: {d: %r, q: 1e-4, p: -2e-4, d.rate: -0.1}\n" % math.cos(1e-4))
        self.assertEqual(self.run_test(self.print(self.write("elbow.yaml", text)), "1e-10").stdout, "m: well\n")

    def test_the_self_test_compares_what_the_engine_has_at_poses_apart(self):
        """Its tables, read back: of each routine five different poses, from the start on, each result as `solve` has it there, and
        as scale of its errors the largest value with its unit."""
        for example, routines in (("double-pendulum", ["points", "accelerations"]), ("quick-return", ["motion", "points"])):
            path = os.path.join(ROOT, "examples", example + ".yaml")
            text = self.print(path)
            found = {name: [units(text, name), *tables(text, name)] for name in re.findall(r"static int m_test_(\w+)\(void\)", text)}
            self.assertEqual(sorted(found), sorted(set(re.findall(r"int m_find_(\w+)\(", text))), example)
            self.assertEqual(len(re.findall(r"(?m)^    failures \+= m_test_\w+\(\);$", text)), len(found), example)
            inputs = list(units(text, "inputs"))
            for name, (unit, rows, wanted, (scale,)) in found.items():
                self.assertEqual((len(rows), len(wanted), len(set(map(tuple, rows)))), (5, 5, 5), name)
                for k, kind in enumerate(unit.values()):
                    alike = [abs(row[i]) for row in wanted for i, other in enumerate(unit.values()) if other == kind]
                    self.assertEqual(scale[k], max(alike), (example, name, k))
                for pose, row in enumerate(rows):
                    at = dict(zip(inputs, row))
                    self.assertAlmostEqual(at["t"], 0.01 * pose, delta=1e-15)
                    for member, value in at.items():
                        self.assertLessEqual(abs(value - rows[0][inputs.index(member)]), 2 if "_accel" in member else 1, member)
                    if name in routines and pose in (0, 3):
                        self.compare_with_solve(path, at, dict(zip(unit, wanted[pose])))

    def compare_with_solve(self, path, at, wanted):
        """What moves follows from the accelerations; where these are asked for, the loads alone make them."""
        is_forward, words = all(name in at for name in wanted), ["--time", "%r" % at["t"]]
        for member, value in at.items():
            name, order = re.fullmatch(r"(\w+?)(_rate|_accel|_effort|)", member).groups()
            option = {"": "--at", "_rate": "--rate", "_accel": "--accel"}.get(order)
            if member != "t" and option and not (is_forward and option == "--accel"):
                words += [option, "%s=%r%s" % (name, value, "rad" if option == "--at" else "")]
        asked = [re.sub("_(x|y|rate|accel)", r".\1", re.sub("^([a-z]+[0-9]?)_(?!x|y|rate|accel)", r"\1.", name)) for name in wanted]
        answer = self.good("solve", path, *words, "--of", ",".join(asked), "--format", "json").json()["configurations"][0]["of"]
        for name, value in zip(asked, wanted.values()):
            self.assertAlmostEqual(answer[name], value, delta=1e-11 * (1 + abs(value)), msg=name)

    def test_the_self_test_can_fail(self):
        text = self.print(os.path.join(ROOT, "examples", "quick-return.yaml"))
        wrong = text.replace("wanted[5][12] = {\n        {", "wanted[5][12] = {\n        {0.001 + ", 1)
        self.assertNotEqual(wrong, text)
        done = self.run_test(wrong)
        self.assertEqual(done.returncode, 1)
        self.assertIn("motion: value 0 at pose 0", done.stdout)

    def test_other_parameters_give_what_the_engine_gives_for_them(self):
        """The functions printed for the file's values, with the values, start and self-test printed for others."""
        tried = 0
        for path in EXAMPLES:
            name = name_of(path)
            with open(path, encoding="utf-8") as file:
                text = file.read()
            section = re.search(r"(?s)^parameters:\s*\{(.*?)\}", text, re.M)
            if not section or ("YOKE_FEW" in os.environ and name not in FEW):
                continue
            body, cut, test = parts(self.print(path))
            members = re.findall(r"\.(\w+) = ([^,]*),", cut["defaults"])
            numbers = random.Random(name)
            words = []
            for parameter, value in members:
                size = numbers.uniform(0.97, 1.03) * float(value) if float(value) != 0 else 0.001
                if parameter != "none":
                    words += ["--param", "%s=%r" % (parameter, size / unit_of(section.group(1), parameter, float(value)))]
            other = Run("code", path, "--prefix", "m", "--quiet", *words)
            if other.code != 0 or not words:  # in other units, or it does not close
                continue
            given = dict(re.findall(r"\.(\w+) = ([^,]*),", parts(other.out)[1]["defaults"]))
            if any(abs(float(given[n]) - float(v)) > 0.1 * abs(float(v)) + 0.01 for n, v in members):
                continue # bare numbers are in the file's units: another machine, whose links may all but vanish
            with self.subTest(name):
                other_body, other_cut, other_test = parts(other.out)
                self.assertEqual(NUMBER.sub("#", body), NUMBER.sub("#", other_body), "the text hangs on values")
                tried += 1
                if name in (sorted(OTHERS) if FULL else sorted(OTHERS)[::2]):
                    done = self.run_test(joined(body, other_cut, other_test), name=name)
                    self.assertEqual(done.stdout, "m: well\n", name)
        self.assertGreater(tried, 1 if "YOKE_FEW" in os.environ else 25)

    def test_single_precision_and_motion_alone(self):
        for name, words in (("quick-return", ["--single"]), ("double-butterfly", ["--single"]), ("andrews", ["--single"]),
                            ("crank-press", ["--kinematics"])):
            with self.subTest(name):
                text = self.print(os.path.join(ROOT, "examples", name + ".yaml"), *words)
                done = self.run_test(text, "1e-2f" if "--single" in words else "1e-12", name=name)
                self.assertEqual(done.stdout, "m: well\n", name)
                if "--single" in words:
                    code = re.sub(r"(?s)/\*.*?\*/|#ifdef m_TEST.*", "", text)
                    self.assertNotIn("double", code)

    def test_a_limit_is_told_where_the_engine_tells_it(self):
        text = self.print(self.rocker, "--kinematics")
        library = self.library(text)
        members = re.findall(r"    double (\w+);", re.search(r"(?s)typedef struct m_inputs \{(.*?)\}", text).group(1))
        inputs = type("Inputs", (ctypes.Structure,), {"_fields_": [(n, ctypes.c_double) for n in members]})
        machine, configuration, parameters = (ctypes.create_string_buffer(4096) for _ in range(3))
        for kind, target, argument in (("defaults", parameters, None), ("prepare", machine, parameters),
                                       ("start", configuration, None)):
            size = len(re.findall(r"(?m)^    \w+ [\w.]+;", re.search(
                r"(?s)typedef struct m_%s \{(.*?)\n\}" % {"defaults": "parameters", "prepare": "machine",
                                                         "start": "configuration"}[kind], text).group(1)))
            # by value: a struct of as many numbers (the machine's first member is the parameters)
            extra = len(re.findall(r"(?m)^    double", re.search(r"(?s)typedef struct m_parameters \{(.*?)\n\}", text).group(1)))
            count = size - 1 + extra if kind == "prepare" else size
            result = type("Values", (ctypes.Structure,), {"_fields_": [("v", ctypes.c_double * count)]})
            function = getattr(library, "m_" + kind)
            function.restype = result
            value = function(*([argument] if argument else []))
            ctypes.memmove(target, ctypes.byref(value), ctypes.sizeof(value))
        seen = set()
        for k in range(72):
            angle = math.radians(5 * k - 180)
            pose = inputs(**{"theta1": angle})
            out = ctypes.create_string_buffer(4096)
            status = library.m_find_motion(machine, configuration, ctypes.byref(pose), out)
            engine = Run("solve", self.rocker, "--at", "theta1=%rrad" % angle, "--assembly", "nearest", "--quiet")
            self.assertEqual(status >= 0, engine.code == 0, "%d deg: %d" % (5 * k - 180, status))
            seen.add(status)
        self.assertEqual(seen, {0, -1})
        bad = inputs(**{"theta1": float("nan")})
        self.assertLess(library.m_find_motion(machine, configuration, ctypes.byref(bad), out), 0)
        far = inputs(**{"theta1": 1e9})
        self.assertLess(library.m_find_motion(machine, configuration, ctypes.byref(far), out), 0)

    def test_a_batch_says_of_each_pose_what_a_call_says(self):
        """Arrays longer than a block and no multiple of one, good poses among others of every kind."""
        text = self.print(self.rocker, "--kinematics")
        members = re.findall(r"    double (\w+);", re.search(r"(?s)typedef struct m_inputs \{(.*?)\}", text).group(1))
        results = re.findall(r"    double (\w+);", re.search(r"(?s)typedef struct m_motion \{(.*?)\n\}", text).group(1))
        program = """
#include <stdio.h>
int main(void)
{
    enum { N = 1003 };
    static double in[%d][N], out[%d][N];
    static signed char status[N];
    const m_parameters p = m_defaults();
    const m_machine m = m_prepare(&p);
    const m_configuration c = m_start();
    const m_inputs_arrays inputs = {%s};
    const m_motion_arrays outputs = {%s};
    double worst = 0;
    int seen[16] = {0};
    for (int i = 0; i < N; i++) in[1][i] = i %% 97 == 13 ? NAN : i %% 89 == 7 ? 1e9 : 0.013 * i - 6;
    m_find_motion_batch(N, &m, &c, &inputs, &outputs, status);
    for (int i = 0; i < N; i++) {
        const m_inputs pose = {%s};
        m_motion one;
        if (m_find_motion(&m, &c, &pose, &one) != status[i]) return 1;
        seen[status[i] + 8] = 1;
        if (status[i] != m_OK) continue;
%s    }
    if (!seen[m_OK + 8] || !seen[m_LIMIT + 8] || worst > 1e-11) return 2;
    return 0;
}
""" % (len(members), len(results), ", ".join("in[%d]" % k for k in range(len(members))),
            ", ".join("out[%d]" % k for k in range(len(results))), ", ".join("in[%d][i]" % k for k in range(len(members))),
            "".join("        worst = fmax(worst, fabs(one.%s - out[%d][i]));\n" % (n, k) for k, n in enumerate(results)))
        for flags in (["-O1"], ["-O3", "-fno-math-errno", "-fno-trapping-math"]):
            run = subprocess.run([self.compile(text + program, *flags)], check=False)
            self.assertEqual(run.returncode, 0, flags)

    def test_residuals_vanish_at_a_pose_and_their_jacobian_is_their_derivative(self):
        """Of loops, of a mesh, of a law, of a distance without a name, and on a base that is welded askew."""
        with open(os.path.join(ROOT, "examples", "geared-five-bar.yaml"), encoding="utf-8") as file:
            text = file.read()
        law = re.sub(r"(?m)^gears:.*$", LAW, text).replace("1 rad/s * t}", "1 rad/s * t, t4: {law: l, of: t2}}")
        for name in ("quick-return", "scotch-yoke"):
            self.check_residuals(name, os.path.join(ROOT, "examples", name + ".yaml"))
        askew = FOUR_BAR.replace("a: 40", "a: 40, tilt: 20 deg").replace("pin: [ground", "pin: [base").replace("  ground:  {", """\
  ground: {points: {W: [0, 0]}}
  base: {""").replace("points: {O", "points: {W: [5, 3], O", 1).replace("joints:", "joints:\n  W: {weld: [ground, base], turned: tilt}")
        for name, machine in (("mesh", text), ("law", law), ("weld", askew)):
            self.check_residuals(name, self.write(name + ".yaml", machine))

    def check_residuals(self, name, path):
        text = self.print(path, "--kinematics")
        about = re.search(r"(?s)Residuals of the (\d+) equations .*?, \[(\d+)\]\[(\d+)\] row by row\.\s+q: (.*?)\.\s+Rows: (.*?)\. \*/", text)
        rows, shown, columns = map(int, about.groups()[:3])
        order = [word.split() for word in about.group(4).split(", ")]
        self.assertEqual([int(place) for place, _ in order], list(range(columns)), name)
        places = [int(place) for place in re.findall(r"(?:^|, |and )(\d+)\b", about.group(5))]
        self.assertEqual((shown, places), (rows, list(range(rows))), name)
        asked = [re.sub("_(distance|angle)$", r".\1", word) for _, word in order]
        found = self.good("solve", path, "--of", ",".join(asked), "--format", "json").json()["configurations"][0]["of"]
        values = [found[word] for word in asked]
        program = """
#include <stdio.h>
int main(void)
{
    enum { ROWS = %d, COUNT = %d };
    const m_parameters p = m_defaults();
    const m_machine m = m_prepare(&p);
    double q[] = {%s}, r[ROWS], J[ROWS * COUNT], a[ROWS], b[ROWS], unused[ROWS * COUNT], miss = 0, worst = 0, all = 0;
    m_residuals(&m, q, r, J);
    for (int i = 0; i < ROWS; i++) miss += fabs(r[i]);
    for (int k = 0; k < COUNT; k++) {
        const double before = q[k];
        q[k] = before + 1e-6;
        m_residuals(&m, q, a, unused);
        q[k] = before - 1e-6;
        m_residuals(&m, q, b, unused);
        q[k] = before;
        for (int i = 0; i < ROWS; i++) worst = fmax(worst, fabs((a[i] - b[i]) / 2e-6 - J[i * COUNT + k]));
        for (int i = 0; i < ROWS; i++) all += fabs(J[i * COUNT + k]);
    }
    printf("%%.3g %%.3g %%.3g", miss, worst, all);
    return 0;
}
""" % (rows, columns, ", ".join(map(repr, values)))
        run = subprocess.run([self.compile(text + program)], capture_output=True, encoding="utf-8", check=True)
        residual, worst, size = map(float, run.stdout.split())
        self.assertLess(residual, 1e-12, name)
        self.assertLess(worst, 1e-8 * (1 + size), name)
        self.assertGreater(size, 0.1, name)

    def test_a_batch_over_parameters_gives_what_each_gives_alone(self):
        text = self.print(os.path.join(ROOT, "examples", "double-pendulum.yaml"))
        struct = re.search(r"(?s)typedef struct m_parameters \{(.*?)\n\}", text).group(1)
        names = re.findall(r"double (\w+);", struct)
        program = """
#include <stdio.h>
int main(void)
{
    enum { N = 40 };
    static double p[%d][N], in[9][N], a[2][N];
    static signed char status[N];
    const m_configuration c = m_start();
    m_parameters_arrays parameters = {%s};
    m_inputs_arrays inputs = {in[0], in[1], in[2], in[3], in[4], in[5], in[6], in[7], in[8]};
    m_accelerations_arrays out = {a[0], a[1]};
    double worst = 0;
    for (int i = 0; i < N; i++) {
        const m_parameters own = m_defaults();
%s        for (int k = 0; k < 9; k++) in[k][i] = sin(1.7 * i + k);
    }
    m_find_accelerations_designs(N, &parameters, &c, &inputs, &out, status);
    for (int i = 0; i < N; i++) {
        m_parameters own = m_defaults();
        m_accelerations one;
%s        const m_machine m = m_prepare(&own);
        const m_inputs x = {in[0][i], in[1][i], in[2][i], in[3][i], in[4][i], in[5][i], in[6][i], in[7][i], in[8][i]};
        if (m_find_accelerations(&m, &c, &x, &one) != status[i] || status[i] != m_OK) return 1;
        worst = fmax(worst, fmax(fabs(one.theta1_accel - a[0][i]), fabs(one.theta2_accel - a[1][i])));
    }
    printf("%%.3g", worst);
    return 0;
}
""" % (len(names), ", ".join("p[%d]" % k for k in range(len(names))),
            "".join("        p[%d][i] = own.%s * (1 + 0.1 * sin(3.1 * i + %d));\n" % (k, n, k) for k, n in enumerate(names)),
            "".join("        own.%s = p[%d][i];\n" % (n, k) for k, n in enumerate(names)))
        run = subprocess.run([self.compile(text + program)], capture_output=True, encoding="utf-8", check=False)
        self.assertEqual(run.returncode, 0)
        self.assertLess(float(run.stdout), 1e-11)

    def test_what_cannot_be_printed_is_refused_by_name_and_nothing_is_written(self):
        chain = "bodies:\n  ground: {points: {J0: [0, 0]}}\n" + "".join("  b%d: {points: {J%d: [0, 0], J%d: [1, 0]}, mass: 1}\n" % (k, k - 1, k) for k in range(1, 42))
        chain += "joints:\n" + "".join("  J%d: {pin: [%s, b%d], angle: q%d}\n" % (k, "b%d" % k if k else "ground", k + 1, k) for k in range(41))
        target = self.path("chain.c")
        run = Run("code", self.write("chain.yaml", chain), "-o", target)
        self.assertEqual(run.code, 1)
        self.assertIn("[E0660]", run.err)
        self.assertIn("41 freedoms", run.err)
        self.assertFalse(os.path.exists(target))
        self.assertEqual(run.out, "")

    def test_bad_options_are_refused(self):
        for prefix in ("3d", "a-b", "_x"):
            self.wrong(806, "code", self.four_bar, "--prefix", prefix)
        self.wrong(803, "code", self.four_bar, "--over", "theta1=0:1")

    def test_the_file_says_what_it_leaves_out(self):
        path = os.path.join(ROOT, "examples", "three-crank-parallelogram.yaml")
        run = self.good("code", path, "--prefix", "m")
        self.assertNotIn("m_find_reactions", run.out)
        with open(path, encoding="utf-8") as file:
            heavy = file.read().replace("bodies:", "gravity: [0, -9.81]\nbodies:", 1).replace("A1: [0.5, 0]}", "A1: [0.5, 0]}, mass: 1, inertia: 0.1")
        run = self.good("code", self.write("heavy.yaml", heavy), "--prefix", "m")
        self.assertNotIn("[W0661]", run.err)

    def test_reactions_of_redundant_constraints_are_the_least(self):
        """The engine's self-test samples, from a factorisation of its own; once with a part beside it that has one solution."""
        with open(os.path.join(ROOT, "examples", "three-crank-parallelogram.yaml"), encoding="utf-8") as file:
            heavy = file.read().replace("bodies:", "gravity: [0.4, -9.81]\nbodies:", 1).replace("A1: [0.5, 0]}", "A1: [0.5, 0]}, mass: 1, inertia: 0.1")
        heavy = heavy.replace("joints:", "  bob: {points: {W: [0, 0]}, mass: 0.4, center: [0.2, 0.1], inertia: 0.02}\njoints:\n  W: {pin: [ground, bob], at: W, angle: w}", 1).replace("ground: {points: {", "ground: {points: {W: [0, 1], ", 1)
        with open(os.path.join(ROOT, "examples", "doubled-guide.yaml"), encoding="utf-8") as file:
            guide = file.read().replace("points: {B: [0, 0], upper: [0, h], lower: [0, -h]}", "points: {B: [0, 0], upper: [0, h], lower: [0, -h]}, mass: 2, inertia: 0.01")
        for name, text in (("heavy", heavy), ("guide", guide)):
            run = self.good("code", self.write(name + ".yaml", text), "--prefix", "m")
            self.assertIn("m_find_reactions", run.out)
            self.assertIn("those of least norm", run.out)
            self.assertNotIn("[W0661]", run.err)
            self.assertEqual(self.run_test(run.out, "1e-11", name=name).stdout, "m: well\n", name)

    def test_values_that_make_the_machine_what_it_is_are_told(self):
        """Three cranks in a parallelogram, each with a length of its own: only where all are equal does it turn."""
        with open(os.path.join(ROOT, "examples", "three-crank-parallelogram.yaml"), encoding="utf-8") as file:
            text = file.read()
        self.assertNotIn("W0607", self.good("code", self.write("one.yaml", text)).err)
        text = text.replace("bodies:", "parameters: {a: 0.5, b: 0.5, c: 0.5}\nbodies:", 1)
        for crank, name in enumerate("abc", 1):
            text = text.replace("A%d: [0.5, 0]" % crank, "A%d: [%s, 0]" % (crank, name))
        path = self.write("three.yaml", text)
        run = self.good("code", path, "--prefix", "m")
        self.assertIn("[W0607]", run.err)
        self.assertIn("The parameters' values are special", run.out)
        self.assertEqual(self.run_test(run.out).stdout, "m: well\n")

    def test_json_holds_the_same_code(self):
        answer = self.good("code", self.four_bar, "--format", "json").json()
        self.assertEqual(answer["prefix"], "four_bar")
        self.assertEqual(answer["code"], self.good("code", self.four_bar).out)
        self.wrong(806, "code", self.four_bar, "--format", "csv")

    def test_names_follow_the_file_or_the_prefix(self):
        self.assertIn("four_bar_find_motion(", self.good("code", self.four_bar).out)
        self.assertNotIn("four_bar", self.print(self.four_bar))
        for file, prefix in (("3 Bars' -X.v2.yaml", "machine_3_bars_x_v2"), ("..-.yaml", "machine"), ("-Z-", "z"), (".a", "a"),
                             ("m" * 50 + ".yaml", "m" * 40)):
            self.assertEqual(re.search(r"(?m)^int (\w+)_find_motion\(", self.good("code", self.write(file, FOUR_BAR)).out).group(1), prefix)


if __name__ == "__main__":
    unittest.main()
