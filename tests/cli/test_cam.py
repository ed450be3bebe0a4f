"""`yoke cam`: answers of the gallery's cams against the oracle, published figures, shapes of JSON, files, refusals."""
import cmath
import csv
import glob
import json
import math
import os
import re
import subprocess
import unittest

from harness import Case, ROOT, Run

EXAMPLES = os.path.join(ROOT, "examples")
DEG = math.pi / 180
UNDERCUT = """\
name: Undercut
laws: {lift: {period: 2*pi, segments: [{rise: {to: 60 deg, by: 20 mm, law: cycloidal}}, {fall: {to: 120 deg, by: 20 mm, law: cycloidal}}, {dwell: {to: 2*pi}}]}}
cams: {c: {cam: shaft, follower: tappet, law: lift, face: flat, base: 20 mm}}
bodies: {shaft: {}, tappet: {}}
joints: {K: {pin: [ground, shaft], angle: theta}, T: {slide: [ground, tappet], along: y, distance: s}}
"""


def example(name):
    return os.path.join(EXAMPLES, name + ".yaml")


TURNING = """
units: {length: mm, angle: deg, force: N}
parameters: {n: 200 rpm}
laws:
  swing:
    period: 360
    segments:
      - {rise: {to: 130, by: 15 deg, law: modified-sine}}
      - {dwell: {to: 180}}
      - {fall: {to: 320, by: 15 deg, law: 3-4-5}}
      - {dwell: {to: 360}}
cams:
  c: {cam: shaft, follower: rocker, law: swing, %s}
bodies:
  ground: {points: {O: [0, 0], Q: [-90, 20]}}
  shaft: {points: {O: [0, 0]}}
  rocker: {points: {Q: [0, 0]}, mass: 0.6 kg, center: [50, 5], inertia: 900 kg*mm^2}
joints:
  O: {pin: [ground, shaft], angle: theta}
  Q: {pin: %s, angle: phi}
springs: {k: {along: phi, stiffness: 20 N*m/rad, angle: %d}}
drives: {theta: n * t}
"""


class Cam(Case):
    def answer(self, name, *words):
        return self.good("cam", name if name.endswith(".yaml") else example(name), "--format", "json", "-q", *words).json()

    def rows(self, answer):
        return [dict(zip(answer["columns"], row)) for row in answer["rows"]]

    def near(self, got, want, tolerance, label=""):
        self.assertIsNotNone(got, label)
        self.assertLessEqual(abs(got - want), tolerance * max(1.0, abs(want)), "%s: %r, expected %r" % (label, got, want))

    def prints_code_that_agrees(self, file):
        """The C of a machine, whose self-test compares it with the engine."""
        self.good("code", file, "--prefix", "own", "-o", self.path("own.c"))
        subprocess.run([os.environ.get("CC", "cc"), "-Down_TEST", "-o", self.path("own"), self.path("own.c"), "-lm"], check=True)
        self.assertIn("well", subprocess.run([self.path("own")], capture_output=True, encoding="utf-8", check=True).stdout)


class Oracle(Cam):
    """examples/expected/cams, written by tools/oracle/cam_oracle.py with 60 digits."""

    def test_every_row_agrees(self):
        documents = sorted(glob.glob(os.path.join(EXAMPLES, "expected", "cams", "*.json")))
        self.assertGreaterEqual(len(documents), 4)
        for name in documents:
            with open(name, encoding="utf-8") as file:
                document = json.load(file)
            answer = self.answer(example(document["file"][:-5]), "--cam", document["cam"], "--steps", "360")
            rows = self.rows(answer)
            for want in document["rows"]:
                got = rows[round(want["angle"] / DEG)]
                for key, value in want.items():
                    self.near(got[key], value, document["tolerance"], "%s %s at %g deg" % (document["file"], key, want["angle"] / DEG))

    def test_the_cep_cam_is_its_polynomial(self):
        answer = self.answer("cep-cam", "--steps", "360")
        for row in self.rows(answer):
            u = row["angle"] / (4 * math.pi / 3)
            s = 0.2 * (64 * u**3 - 192 * u**4 + 192 * u**5 - 64 * u**6) if u < 1 else 0
            self.assertLess(abs(row["s"] - s), 1e-13)
        segment = answer["segments"][0]
        self.assertEqual(segment["kind"], "polynomial")
        self.assertEqual([c["order"] for c in segment["conditions"]], [0, 0, 0, 1, 1, 2, 2])
        self.assertGreater(segment["condition_number"], 1)
        self.assertNotIn("conditions", answer["segments"][1])


class Arcs(Cam):
    def test_every_jump_of_the_acceleration_is_told_with_its_size(self):
        """Where a straight flank leaves the base circle, a jumps by base and roller together."""
        run = self.good("check", example("arc-cam"))
        self.assertEqual(run.err.count("[N0460]"), 4)
        answer = self.answer("arc-cam")
        self.assertEqual([segment["kind"] for segment in answer["segments"]], ["arc"] * 4)
        sizes = [jump["size"] for jump in answer["jumps"]]
        self.near(sizes[0], 0.035, 1e-12)
        self.near(sizes[3], -0.035, 1e-12)

    def test_a_study_makes_the_surface_anew(self):
        """A parameter of the arcs: the lift of the middle of the nose is what `lift` says."""
        with open(example("arc-cam"), encoding="utf-8") as file:
            text = file.read().replace("lift: 12,", "lift: h,").replace("units:", "parameters: {h: 12 mm}\nunits:")
        path = self.write("arcs.yaml", text)
        top = math.acos(14 / 26.5)  # of the nose for h = 12.5 mm
        rows = self.good("study", path, "--vary", "h=12mm:12.5mm:2", "--of", "s", "--at", "theta=%.17g rad" % top, "--format", "csv", "-q").out.splitlines()
        off = math.acos(14 / 26) - top
        for row, want in zip(rows[1:], (26 * math.cos(off) + math.sqrt(21**2 - (26 * math.sin(off))**2) - 35, 12.5)):
            self.near(1000 * float(row.split(",")[-1]), want, 1e-12)
        self.assertEqual(len(rows), 3)


class Formula(Cam):
    def test_kinks_are_told_where_they_are(self):
        text = """name: kinks
laws: {lift: {period: 360 deg, segments: [{formula: {s: "10 mm * max(0, sin(angle))^2 + 5 mm * abs(sin(angle / 2))", of: angle, to: 360 deg}}]}}
cams: {c: {cam: shaft, follower: tappet, law: lift, roller: 5 mm, base: 40 mm}}
bodies: {shaft: {}, tappet: {}}
joints: {K: {pin: [ground, shaft], angle: theta}, T: {slide: [ground, tappet], along: y, distance: s}}
"""
        answer = self.answer(self.write("kinks.yaml", text), "--steps", "180")
        jumps = [(round(jump["angle"], 9), jump["order"], round(jump["size"], 9)) for jump in answer["jumps"]]
        self.assertIn((0.0, 1, 0.005), jumps)                            # |sin(x / 2)| turns round: v from -0.0025 to 0.0025
        self.assertIn((round(math.pi, 9), 2, -0.02), jumps)              # max(0, sin)^2: a from 0.02 to 0
        for row in self.rows(answer):
            x = row["angle"]
            self.near(row["s"], 0.01 * max(0, math.sin(x))**2 + 0.005 * abs(math.sin(x / 2)), 1e-12)

    def test_a_name_of_its_own_may_not_be_a_parameter(self):
        text = """parameters: {x: 2 mm}
laws: {lift: {period: 360 deg, segments: [{formula: {s: 10 mm * (1 - cos(x)), to: 360 deg}}]}}
cams: {c: {cam: shaft, follower: tappet, law: lift, base: 40 mm}}
bodies: {shaft: {}, tappet: {}}
joints: {K: {pin: [ground, shaft], angle: theta}, T: {slide: [ground, tappet], along: y, distance: s}}
"""
        run = self.wrong(405, "check", self.write("own.yaml", text))
        self.assertIn("the law's argument", run.err)


class Figures(Cam):
    def published(self, name):
        with open(os.path.join(ROOT, "tests", "validation", "cases.json"), encoding="utf-8") as file:
            found = []

            def search(node):
                if isinstance(node, dict):
                    if node.get("id") == name:
                        found.append(node)
                    for value in node.values():
                        search(value)
                elif isinstance(node, list):
                    for value in node:
                        search(value)

            search(json.load(file))
        return found[0]

    def test_peak_factors(self):
        names = {"cycloidal": "cycloidal", "simple harmonic": "harmonic", "constant acceleration": "parabolic",
                 "modified trapezoidal": "modified-trapezoid", "modified sine": "modified-sine", "3-4-5": "3-4-5", "4-5-6-7": "4-5-6-7"}
        rows = self.published("CAM-FAC")["check"]["rows"]["rows"]
        answer = self.answer("cep-cam", "--compare", ",".join(names[row[0]] for row in rows))
        for row, got in zip(rows, answer["compare"]):
            self.assertEqual(got["law"], names[row[0]])
            for key, want in zip(("Cv", "Ca", "Cj"), row[1:4]):
                if isinstance(want, str):
                    self.assertIsNone(got[key])
                else:
                    self.near(got[key], want, 1e-12, row[0] + " " + key)

    def test_flat_faced_follower(self):
        case = self.published("CAM-FLAT")
        answer = self.answer("flat-faced-cam", "--limits", "curvature=6.35mm")
        base = answer["smallest_base"]
        self.near(base["base"] / 0.0254, case["check"]["Rb"], 1e-11)
        self.assertEqual(round(base["base"] / 0.0254, 3), case["published"]["base_radius_in"])
        self.assertEqual(base["by"], "curvature")
        width = answer["summary"]["reach_high"]["value"] - answer["summary"]["reach_low"]["value"]
        self.near(width / 0.0254, case["check"]["face"], 1e-12)
        self.assertEqual(round(width / 0.0254, 2), case["published"]["min_face_width_in"])


class Answers(Cam):
    def test_json_holds_what_the_manual_says(self):
        answer = self.answer("valve-cam", "--compare", "cycloidal")
        self.assertEqual(list(answer), ["model", "status", "cam", "segments", "jumps", "strokes", "summary", "smallest_base", "forces",
                                        "compare", "columns", "rows"])
        self.assertEqual(answer["cam"]["motion"], "translating")
        self.near(answer["cam"]["speed"], 100 * math.pi, 1e-14)
        self.assertEqual(len(answer["rows"]), 73)
        with open(os.path.join(ROOT, "man", "yoke-cam.1.scd"), encoding="utf-8") as file:
            page = file.read()
        for key in list(answer) + list(answer["cam"]) + list(answer["summary"]) + list(answer["forces"]) + list(answer["smallest_base"]):
            self.assertIn("_%s_" % key, page)

    def test_forces_at_the_drives_speed_and_at_another(self):
        answer = self.answer("valve-cam")
        forces, w = answer["forces"], 100 * math.pi
        effort = 0.11 * (answer["summary"]["a"]["value"] * w * w + 9.81) + 40000 * (0.009 + 0.008)
        self.near(forces["contact_low"]["value"], effort, 1e-11)
        other = self.answer("valve-cam", "--speed", "%rrad/s" % (1.02 * forces["jump_speed"]))["forces"]
        self.assertLess(other["contact_low"]["value"], 0)
        self.assertAlmostEqual(self.answer("valve-cam", "--speed", "%rrad/s" % forces["jump_speed"])["forces"]["contact_low"]["value"], 0, 6)
        run = self.good("cam", example("valve-cam"), "--speed", "3500rpm")
        self.assertIn("0555]", run.err)

    def test_the_engine_finds_the_same_torque(self):
        """The same cam as a constraint of the motion, solved as a linkage."""
        for name in ("cep-cam", "valve-cam", "swing-cam", "flat-faced-cam"):
            rows = self.rows(self.answer(name))
            for row in (6, 15, 40):
                run = self.good("solve", example(name), "--at", "theta=%ddeg" % (5 * row), "--format", "json", "-q")
                self.near(run.json()["configurations"][0]["efforts"]["theta"], rows[row]["torque"], 1e-12, name)

    def test_csv_has_the_rows_of_the_json(self):
        answer = self.answer("swing-cam", "--steps", "12", "--cutter", "20mm")
        head, rows = self.good("cam", example("swing-cam"), "--steps", "12", "--cutter", "20mm", "--format", "csv").csv()
        self.assertEqual(head, answer["columns"])
        self.assertIn("cutter.x", head)
        self.assertEqual(rows, [[None if value is None else float(value) for value in row] for row in answer["rows"]])

    def test_contact_force_is_that_of_the_free_bodies(self):
        for name, cam in (("valve-cam", "intake"), ("swing-cam", "rocker-cam")):
            path = os.path.join(ROOT, "examples", name + ".yaml")
            head, rows = self.good("cam", path, "--steps", "24", "--format", "csv").csv()
            of = ",".join(["theta.effort", cam + ".force"])
            other = self.good("sweep", path, "--over", "theta=0:360deg", "--steps", "24", "--of", of, "--format", "csv").csv()[1]
            largest = max(row[head.index("contact_force")] for row in rows)
            for row, asked in zip(rows, other):
                self.assertAlmostEqual(asked[2], row[head.index("contact_force")], delta=1e-6 * largest, msg=name)
                self.assertAlmostEqual(asked[1], row[head.index("torque")], delta=1e-7 * largest, msg=name)

    def test_followers_that_turn_are_pushed_along_the_common_normal(self):
        """Without a point `at`, too: the force is that of `cam`, and its line crosses the line of centres where both turn alike (Kennedy)."""
        for kind, pin, way in (("face: flat, base: 40, offset: 5", "[ground, rocker]", 1), ("roller: 9, base: 40, arm: 85", "[rocker, ground]", -1)):
            file = self.write("turning.yaml", TURNING % (kind, pin, -25))
            of = "phi,phi.rate,c.force.x,c.force.y,theta.effort,Q.force.x,Q.force.y"
            rows = self.good("sweep", file, "--over", "theta=10:370deg", "--steps", "36", "--of", of, "--format", "csv").csv()[1]
            other = self.good("sweep", file, "--over", "theta=10:370deg", "--steps", "36", "--of", of, "--method", "newton-euler", "--format",
                              "csv").csv()[1]
            head, known = self.good("cam", file, "--steps", "36", "--format", "csv").csv()
            known = {round(math.degrees(row[0])): row[head.index("contact_force")] for row in known}
            speed = 200 * math.pi / 30
            for row, again in zip(rows, other):
                theta, phi, rate, x, y, effort = row[:6]
                self.assertAlmostEqual(math.hypot(x, y), known[round(math.degrees(theta)) % 360], delta=1e-6)
                ratio = way * rate / speed
                at = ratio / (ratio - 1)  # of the centres' distance
                centre = (-0.09 * at, 0.02 * at)
                moment = (centre[0] + 0.09) * y - (centre[1] - 0.02) * x
                self.assertAlmostEqual(moment * way * rate, effort * speed, delta=1e-9)  # what the follower takes, the drive gives
                for value, same in zip(row, again):
                    self.assertAlmostEqual(value, same, delta=1e-9)
            text = self.good("derive", file, "--what", "free-bodies", "--numbers", "--at", "theta=80deg").out
            self.assertIn("at lift 0 the follower's", text)
            shown = re.search(r"by ground at O:.* \[ *(\S+) *\]\n.* \[ *(\S+) *\]", text)
            for value, want in zip(shown.groups(), rows[7][3:5]):  # the shaft's bearing carries the contact force
                self.assertAlmostEqual(float(value), want, delta=1e-3)
            self.prints_code_that_agrees(file)
        weak = self.write("weak.yaml", (TURNING % ("face: flat, base: 40, offset: 5", "[ground, rocker]", -25)).replace("20 N*m", "2 N*m"))
        self.assertIn("lift-off of c", self.good("simulate", weak, "--to", "0.2s", "--param", "n=900rpm").err)

    def test_a_follower_that_leaves_its_cam_is_told(self):
        with open(os.path.join(ROOT, "examples", "valve-cam.yaml"), encoding="utf-8") as file:
            text = file.read()
        slow = self.write("slow.yaml", text)
        fast = self.write("fast.yaml", text.replace("3000 rpm", "3600 rpm"))  # it jumps from 3386 rpm, at 60 deg
        groove = self.write("groove.yaml", text.replace("3000 rpm", "3600 rpm").replace("base: 17}", "base: 17, groove: true}"))
        massless = self.write("massless.yaml", text.replace("valve: {mass: 0.11 kg}", "valve: {}").replace("length: -8", "length: 4")
                              .replace("camshaft: {}", "camshaft: {mass: 1 kg}"))
        pose, motion = ["--at", "theta=60deg"], ["--to", "20ms"]
        for file, count in ((slow, 0), (fast, 1), (groove, 0)):
            self.assertEqual(self.good("solve", file, *pose).err.count("[W0555]"), count)
        for file, events in ((slow, []), (fast, ["lift-off", "landing"]), (groove, []), (massless, ["pull"])):
            run = self.good("simulate", file, *motion, "--format", "json")
            kinds = [event["kind"] for event in json.loads(run.out)["events"]]
            self.assertEqual(kinds[:2] if events != ["pull"] else kinds[:1], events, file)
            self.assertEqual(run.err.count("[W0555]"), 1 if events == ["pull"] else 0)

    def test_text_is_in_the_files_units(self):
        out = self.good("cam", example("valve-cam"), "--steps", "4").out
        for words in ("s(60 deg) = 9 mm", "3000 rpm", "5.8872 mm", "-4860000 mm/s^2", "condition number", "[mm/rad^2]"):
            self.assertIn(words, out)
        self.assertRegex(out, r"largest pressure angle +26\.74\d+ deg at 30\.\d+ deg")

    def test_parameters_change_the_cam(self):
        wide = self.answer("flat-faced-cam", "--param", "in=30mm")
        self.near(wide["summary"]["s"]["value"], 0.03, 1e-14)

    def test_undercut_is_named_with_its_angles(self):
        run = self.good("cam", self.write("undercut.yaml", UNDERCUT))
        self.assertRegex(run.err, r"warning: cam `c`: the surface is undercut at cam angles [\d.]+ rad \(3\d\.\d+ deg\)")
        ranges = self.answer(self.path("undercut.yaml"))["summary"]["undercut"]
        rows = self.rows(self.answer(self.path("undercut.yaml"), "--steps", "720"))
        for row in rows:
            inside = any(low < row["angle"] < high for low, high in ranges)
            self.assertEqual(row["surface_radius"] < 0, inside)

    def test_the_same_request_gives_the_same_bytes(self):
        words = ("cam", example("swing-cam"), "--format", "json", "--compare", "3-4-5")
        self.assertEqual(self.good(*words).out, self.good(*words).out)


PAIR = """
units: {length: mm, angle: deg, force: N}
parameters: {n: 500 rpm%(parameters)s}
laws:
  lift:
    period: 360
    segments:
      - {rise: {to: 150, by: %(by)s, law: cycloidal}}
      - {dwell: {to: 200}}
      - {fall: {to: 330, by: %(by)s, law: 3-4-5}}
      - {dwell: {to: 360}}
cams:
  c: {cam: shaft, follower: fol, law: lift, roller: 8, base: 30, %(cam)s}
bodies:
  ground: {points: {O: [0, 0], Q: [-90, 20]}}
  shaft: {points: {O: [0, 0]}, mass: 2 kg, inertia: 900 kg*mm^2}
  fol: {points: {Q: [0, 0]%(point)s}, mass: 2 kg, center: [%(center)s], inertia: 900 kg*mm^2}
joints:
  O: {pin: %(pin)s, angle: th}
  %(guide)s
drives: {th: n * t}
"""


class Pairs(Cam):
    """Cams with two rollers: where the first would have to pull, the second bears, with its own common normal."""

    def push(self, places, moves, spin, need):
        """The force on the follower by hand: from the roller that bears, along the normal of its path on the cam."""
        at, moves = (places[need < 0], moves[need < 0])
        path = moves[1] - 1j * spin * at  # moves: per lift, and now
        normal = 1j * path / abs(path)
        if (normal.conjugate() * at).real < 0:
            normal = -normal
        size = need / (moves[0].conjugate() * normal).real
        self.assertGreaterEqual(size, -1e-9)  # a roller only pushes
        return size * normal

    def agree(self, text, guide, hand):
        """solve by both methods, cam, simulate, the printed C and the symbols against hand(th, lift, rate, accel)."""
        file = self.write("pair.yaml", text)
        words = ("sweep", file, "--over", "th=10:370deg", "--steps", "36", "--format", "csv", "--of")
        of = "q,q.rate,q.accel,c.force.x,c.force.y,%s.force.x,%s.force.y,O.force.x,O.force.y,th.effort" % (guide, guide)
        rows = self.good(*words, of).csv()[1]
        other = self.good(*words, of, "--method", "newton-euler").csv()[1]
        head, known = self.good("cam", file, "--steps", "36", "--format", "csv").csv()
        known = {round(math.degrees(row[0])) % 360: row[head.index("contact_force")] for row in known}
        seconds = 0
        for row, again in zip(rows, other):
            need, force, guide, shaft = hand(*row[1:4])
            seconds += need < -1e-9
            for got, want in ((row[4:6], force), (row[6:8], guide), (row[8:10], shaft)):
                self.assertAlmostEqual(complex(*got), want, delta=1e-9)
            self.assertAlmostEqual(math.copysign(abs(force), need), known[round(math.degrees(row[0])) % 360], delta=1e-6)
            self.assertAlmostEqual(row[10] * 500 * math.pi / 30, need * row[2], delta=1e-9)  # what the drive gives, the follower takes
            for value, same in zip(row, again):
                self.assertAlmostEqual(value, same, delta=1e-9)
        self.assertTrue(10 < seconds < 26)
        steps = self.good("simulate", file, "--to", "0.12s", "--steps", "36", "--format", "csv", "--of", "c.force.x,c.force.y", "-q").csv()[1]
        for step, row in zip(steps[1:], rows):
            for k in (0, 1):
                self.assertAlmostEqual(step[1 + k], row[4 + k], delta=1e-6)
        self.prints_code_that_agrees(file)
        for at in (5, 10):  # 60 and 110 deg: the first bears, then the second
            text = self.good("derive", file, "--what", "free-bodies", "--numbers", "--at", "th=%ddeg" % (10 * at + 10)).out
            self.assertIn("at the roller that bears", text)
            shown = re.search(r"by (?:ground|shaft) at O:.* \[ *(\S+) *\]\n.* \[ *(\S+) *\]", text).groups()
            contact = re.search(r"by shaft at c:.* \[ *(\S+) *\]\n.* \[ *(\S+) *\]", text).groups()
            for k in (0, 1):
                self.assertAlmostEqual(float(contact[k]), rows[at][4 + k], delta=1e-3)
                self.assertAlmostEqual(abs(float(shown[k])), abs(rows[at][8 + k]), delta=1e-3)

    def test_a_follower_that_slides(self):
        for pin, turn, guide, way in (("[ground, shaft]", 1, "[ground, fol]", 1), ("[shaft, ground]", -1, "[fol, ground]", -1)):
            text = PAIR % {"by": 20, "cam": "offset: 6, conjugate: {roller: 10, span: 90}", "parameters": "", "point": "", "center": "0, 0", "pin": pin,
                           "guide": "G: {slide: %s, along: y, distance: q}" % guide}
            u, spin = way * 1j, turn * 500 * math.pi / 30
            start = math.sqrt(0.038**2 - 0.006**2) * u - 0.006j * u

            def hand(lift, rate, accel):
                need = 2 * accel
                first = start + lift * u
                force = self.push((first, first - 0.09 * u), [(u, rate * u)] * 2, spin, need)
                return need, force, way * (need * u - force), turn * force

            self.agree(text, "G", hand)

    def test_a_follower_that_turns(self):
        pivot, arm, speed = -0.09 + 0.02j, 0.085, 500 * math.pi / 30
        between = (0.038**2 - abs(pivot)**2 - arm**2) / (2 * abs(pivot) * arm)  # cos of the angle from the pivot to the arm
        for cam, has_point, pin, turn, guide, way in (("arm: 85, conjugate: {arm: 70, angle: -75}", False, "[ground, shaft]", 1, "[ground, fol]", 1),
                                                      ("at: P, conjugate: {roller: 9, angle: 80}", True, "[shaft, ground]", -1, "[fol, ground]", -1)):
            start = arm * pivot / abs(pivot) * cmath.exp(-way * 1j * math.acos(between))
            place = ", x: %.17g m, y: %.17g m" % (start.real, start.imag) if has_point else ""
            point = ", P: [x, y]" if has_point else ""
            text = PAIR % {"by": 15, "cam": cam, "parameters": place, "point": point, "center": "50, 5", "pin": pin, "guide": "Q: {pin: %s, angle: q}" % guide}
            behind = cmath.exp(80j * DEG) if has_point else 70 / 85 * cmath.exp(-75j * DEG)
            center = 0.05 + 0.005j

            def hand(lift, rate, accel):
                turned = cmath.exp(1j * way * lift)
                need = (900e-6 + 2 * abs(center)**2) * accel
                arms = (start * turned, start * turned * behind)
                force = self.push([pivot + a for a in arms], [(way * 1j * a, rate * way * 1j * a) for a in arms], turn * speed, need)
                pulls = 2 * (way * 1j * accel - rate**2) * center * turned
                return need, force, way * (pulls - force), turn * force

            self.agree(text, "Q", hand)

    def test_dry_friction_of_the_guide(self):
        """The guide's friction grows with the sideways force of the roller that bears."""
        text = PAIR % {"by": 20, "cam": "conjugate: {roller: 10, span: 90}", "parameters": "", "point": "", "center": "0, 0", "pin": "[ground, shaft]",
                       "guide": "G: {slide: [ground, fol], along: y, distance: q, friction: {coulomb: 0.3}}"}
        file = self.write("pair.yaml", text)
        seconds = 0
        for lift, rate, accel, x, y in (row[1:] for row in self.good("sweep", file, "--over", "th=10:370deg", "--steps", "36", "--of",
                                                                     "q,q.rate,q.accel,c.force.x,c.force.y", "--format", "csv").csv()[1]):
            if rate == 0:
                continue
            self.assertAlmostEqual(y, 2 * accel + math.copysign(0.3 * abs(x), rate), delta=1e-9)
            seconds += y < 0
            height = 0.038 + lift - (0.09 if y < 0 else 0)
            self.assertAlmostEqual(x, -y * rate / (500 * math.pi / 30) / height, delta=1e-9)
        self.assertGreater(seconds, 5)
        self.prints_code_that_agrees(file)

    def test_a_groove_keeps_the_normal(self):
        """The other flank lies on the same line, whichever bears."""
        text = PAIR % {"by": 20, "cam": "groove: true", "parameters": "", "point": "", "center": "0, 0", "pin": "[ground, shaft]",
                       "guide": "G: {slide: [ground, fol], along: y, distance: q}"}
        file = self.write("groove.yaml", text)
        for lift, rate, accel, x, y in (row[1:] for row in self.good("sweep", file, "--over", "th=10:370deg", "--steps", "36", "--of",
                                                                     "q,q.rate,q.accel,c.force.x,c.force.y", "--format", "csv").csv()[1]):
            slope = rate / (500 * math.pi / 30)
            self.assertAlmostEqual(y, 2 * accel, delta=1e-9)
            self.assertAlmostEqual(x, -2 * accel * slope / (0.038 + lift), delta=1e-9)

    def test_a_second_roller_on_the_first_ones_side_is_told(self):
        for cam, guide in (("conjugate: {span: 20}", "G: {slide: [ground, fol], along: y, distance: q}"),
                           ("arm: 85, conjugate: {arm: 70, angle: 75}", "Q: {pin: [ground, fol], angle: q}")):
            text = PAIR % {"by": 15, "cam": cam, "parameters": "", "point": "", "center": "0, 0", "pin": "[ground, shaft]", "guide": guide}
            run = self.good("check", self.write("wrong.yaml", text))
            self.assertIn("the two do not hold the follower [W0474]", run.err)


class Files(Cam):
    def outline(self, name, *words):
        self.good("cam", example(name), "-q", "--profile", self.path("p.csv"), *words)
        with open(self.path("p.csv"), encoding="utf-8") as file:
            rows = list(csv.reader(file))
        self.assertEqual(rows[0], ["curve", "x", "y"])
        curves = {}
        for curve, x, y in rows[1:]:
            curves.setdefault(curve, []).append((float(x), float(y)))
        return curves

    def test_every_point_of_the_table_lies_within_the_tolerance(self):
        for name in ("cep-cam", "valve-cam", "swing-cam", "flat-faced-cam"):
            points = self.outline(name, "--tolerance", "0.01mm")["surface"]
            for row in self.rows(self.answer(name, "--steps", "90")):
                best = 1.0
                for (ax, ay), (bx, by) in zip(points, points[1:] + points[:1]):
                    ux, uy, px, py = bx - ax, by - ay, row["x"] - ax, row["y"] - ay
                    k = min(max((ux * px + uy * py) / (ux * ux + uy * uy), 0), 1)
                    best = min(best, math.hypot(px - k * ux, py - k * uy))
                self.assertLessEqual(best, 1e-5)

    def test_a_finer_tolerance_takes_more_points(self):
        coarse, fine = (len(self.outline("valve-cam", "--tolerance", t)["surface"]) for t in ("0.1mm", "0.001mm"))
        self.assertGreater(fine, 5 * coarse)

    def test_the_svg_is_to_scale_and_has_every_curve(self):
        self.good("cam", example("valve-cam"), "-q", "--profile", self.path("p.svg"), "--cutter", "5mm")
        svg = self.read("p.svg").decode()
        width = float(re.search(r'width="([\d.]+)mm"', svg).group(1))
        self.assertEqual(width, float(re.search(r'viewBox="\S+ \S+ (\S+) ', svg).group(1)))
        for curve in ("surface", "pitch", "cutter"):
            self.assertIn('id="%s"' % curve, svg)
        self.assertIn('r="17.00000"', svg)
        self.assertIn('r="8.00000"', svg)

    def test_the_dxf_holds_the_points_in_millimetres(self):
        self.good("cam", example("valve-cam"), "-q", "--profile", self.path("p.dxf"))
        lines = self.read("p.dxf").decode().split("\n")
        pairs = list(zip(lines[0::2], lines[1::2]))
        self.assertEqual(pairs[-1], ("0", "EOF"))
        self.assertEqual(pairs.count(("0", "SECTION")), pairs.count(("0", "ENDSEC")))
        points = []
        for at, pair in enumerate(pairs):
            if pair == ("0", "VERTEX") and pairs[at + 1] == ("8", "surface"):
                points.append((float(pairs[at + 2][1]) / 1000, float(pairs[at + 3][1]) / 1000))
        outline = self.outline("valve-cam")["surface"]
        self.assertEqual(len(points), len(outline))
        for a, b in zip(points, outline):
            self.assertLess(math.dist(a, b), 1e-12)

    def test_the_diagram_is_drawn(self):
        run = Run("cam", example("swing-cam"), "-q", "--plot", self.path("d.svg"), "--compare", "cycloidal")
        if "E0710" in run.err:
            self.skipTest("needs gnuplot")
        self.assertEqual(run.code, 0, run.err)
        svg = self.read("d.svg").decode()
        for words in ("deg/rad^2", "cycloidal", "pressure angle", "cam angle"):
            self.assertIn(words, svg)

    def test_an_undercut_cam_has_no_profile(self):
        run = Run("cam", self.write("undercut.yaml", UNDERCUT), "--profile", self.path("p.dxf"))
        self.assertEqual(run.code, 1)
        self.assertIn("[E0557]", run.err)
        self.assertFalse(os.path.exists(self.path("p.dxf")))


class Refusals(Cam):
    def test_a_machine_without_cams(self):
        self.wrong(551, "cam", self.four_bar)

    def test_a_cam_that_is_not_there(self):
        run = self.wrong(550, "cam", example("valve-cam"), "--cam", "intak")
        self.assertIn("did you mean `intake`?", run.err)

    def test_a_law_that_is_not_there(self):
        run = self.wrong(558, "cam", example("valve-cam"), "--compare", "3-4-5,cycliodal")
        self.assertIn("did you mean `cycloidal`?", run.err)

    def test_limits(self):
        self.wrong(559, "cam", example("valve-cam"), "--limits", "pressur=30deg")
        self.wrong(806, "cam", example("valve-cam"), "--limits", "pressure=0deg")
        self.wrong(321, "cam", example("valve-cam"), "--limits", "pressure=3mm")
        run = self.good("cam", example("swing-cam"), "--limits", "pressure=1deg")
        self.assertIn("0556", run.err)

    def test_lengths_and_endings(self):
        self.wrong(806, "cam", example("valve-cam"), "--tolerance", "-1mm")
        self.wrong(806, "cam", example("valve-cam"), "--cutter", "0mm")
        self.wrong(706, "cam", example("valve-cam"), "--profile", self.path("p.step"))
        self.wrong(706, "cam", example("valve-cam"), "--plot", self.path("p.dxf"))
        self.wrong(806, "cam", example("valve-cam"), "--steps", "0")
        self.wrong(808, "cam")


if __name__ == "__main__":
    unittest.main()
