"""Cams and their mirror images: every number of the one is that of the other, with the sign that a mirror gives it.

The mirror is the x axis. The cam turns the other way, by its pin read from the shaft. A follower that turns goes the other
way too: its law is the negative one, or its pin is read from the follower and the law stays.
"""
import csv
import re
import unittest

from harness import Case

MACHINE = """\
name: Cam
units: {length: mm, angle: deg, force: N}
gravity: [-500, %(up)d*9810]
parameters: {n: 240 rpm}
%(laws)s
cams:
  c: {cam: shaft, follower: rocker, base: 45, %(cam)s}
bodies:
  ground: {points: {O: [0, 0], Q: [-90, %(up)d*40]}}
  shaft: {points: {O: [0, 0]}}
  rocker: {points: {Q: [0, 0], P: [90, %(up)d*15]}, mass: 0.6 kg, center: [30, %(up)d*10], inertia: 700 kg*mm^2}
joints:
  O: {pin: %(shaft)s, angle: theta}
  Q: {pin: %(pin)s, angle: phi}
drives: {theta: n * t}
springs: {k: {along: phi, stiffness: %(stiffness)g N*m/rad, angle: %(way)d*-20}}
"""
STROKES = """\
laws:
  swing:
    period: 360
    segments:
      - {rise: {to: 120, by: 20 deg, law: modified-sine}}
      - {dwell: {to: 160}}
      - {fall: {to: 280, by: 20 deg, law: 3-4-5}}
      - {dwell: {to: 360}}"""
# Lift 0 is on the way: the law goes to both sides of it.
BOTH = """\
laws:
  swing:
    period: 360
    segments:
      - {rise: {to: 100, by: 8 deg, law: cycloidal}}
      - {fall: {to: 200, by: 20 deg, law: cycloidal}}
      - {rise: {to: 330, by: 12 deg, law: 4-5-6-7}}
      - {dwell: {to: 360}}"""
FORMULA = """\
laws: {swing: {period: 360, segments: [{formula: {to: 360, s: %(way)d*15 deg*(3 - 4*cos(x) + cos(2*x))/8}}]}}"""
# name: laws, keys of the cam
WITH_POINT = {
    "roller": (STROKES, "law: swing, at: P, roller: 10"),
    "edge": (STROKES.replace("20 deg", "15 deg"), "law: swing, at: E"),
    "groove": (STROKES, "law: swing, at: P, roller: 10, groove: true"),
    "both": (BOTH, "law: swing, at: P, roller: 10"),
    "formula": (FORMULA, "law: swing, at: P, roller: 10"),
    "pair": (STROKES, "law: swing, at: P, roller: 10, conjugate: {roller: 9, angle: %(up)d*-80}"),
    "symmetrical arcs": ("", "at: P, roller: 10, arcs: {nose: 15, lift: 12, angle: 140}"),
    "arcs": ("", "at: P, roller: 10, arcs: [{center: [8, %(up)d*3], radius: 54}]"),
}
WITHOUT = {
    "arm": (STROKES, "law: swing, arm: 91, roller: 10"),
    "flat": (STROKES.replace("20 deg", "8 deg"), "law: swing, face: flat, offset: 5"),
    "pair": (STROKES, "law: swing, arm: 91, roller: 10, conjugate: {arm: 80, angle: %(up)d*-80}"),
    "arcs": ("", "arm: 91, roller: 10, arcs: {nose: 15, lift: 12, angle: 140}"),
    "flat arcs": ("", "face: flat, arcs: [{center: [8, %(up)d*3], radius: 50}]"),
}
TURNS = {"turn", "pressure_angle", "y"}  # the mirror alone
LIFTS = {"s", "v", "a", "j", "p", "lift", "size", "preload", "preload_needed"}  # along the follower's coordinate


class Mirror(Case):
    def machine(self, kind, up, has_negative_law, stiffness=30):
        laws, cam = kind
        words = {"up": up, "way": -1 if has_negative_law else 1, "stiffness": stiffness,
                 "shaft": "[ground, shaft]" if up > 0 else "[shaft, ground]",
                 "pin": "[ground, rocker]" if up > 0 or has_negative_law else "[rocker, ground]"}
        text = MACHINE % dict(words, laws=laws % words, cam=cam % words)
        if has_negative_law:  # what rose falls
            text = re.sub("(rise|fall)(?=: )", lambda word: {"rise": "fall", "fall": "rise"}[word[0]], text)
        if "at: E" in cam:  # without a roller, 45 mm from the centre
            text = text.replace("P: [90, %d*15]" % up, "E: [90, %d*5]" % up)
        return self.write("%s%s.yaml" % ("machine" if up > 0 else "mirror", "-negative" if has_negative_law else ""), text)

    def pairs(self):
        """The machine and its mirror image, and -1 where the follower's coordinate counts the other way."""
        for name, kind in WITH_POINT.items():
            yield name, kind, -1
            yield name, kind, 1
        for name, kind in WITHOUT.items():
            yield name, kind, 1

    def same(self, one, other, sign, key=""):
        """Compares two answers of `yoke cam`; `sign` is that of the follower's coordinate."""
        flips = (-1 if key.split(".")[-1] in TURNS else 1) * (sign if key in LIFTS else 1)
        if isinstance(one, dict):
            self.assertEqual(one.keys(), other.keys())
            if "value" in one:
                self.close(one["value"], other["value"], flips, key)
                return
            for k in one:
                if k not in ("model", "rows"):
                    self.same(one[k], other[k], sign, k)
            for row, mirrored in zip(one.get("rows", []), other.get("rows", []), strict=True):
                for k, a, b in zip(one["columns"], row, mirrored, strict=True):
                    self.same(a, b, sign, k)
        elif isinstance(one, list):
            self.assertEqual(len(one), len(other), key)
            for a, b in zip(one, other):
                self.same(a, b, sign, key)
        else:
            self.close(one, other, flips, key)

    def close(self, one, other, flips, key):
        if not isinstance(one, (int, float)) or isinstance(one, bool):
            if key != "kind":  # a rise downwards is a fall
                self.assertEqual(one, other, key)
            return
        coarse = 100 if key.endswith("angle") else 1  # where something is greatest
        self.assertAlmostEqual(one, flips * other, delta=coarse * 1e-9 * max(1, abs(one)), msg=key)

    def asked(self, file, words):
        """The answer of `yoke cam`, the outline's vertices, and the rows of a sweep."""
        run = self.good("cam", file, "--format", "json", "--steps", "36", "--cutter", "6mm", "--profile", self.path("p.csv"), *words)
        self.assertNotIn("W0474", run.err)
        with open(self.path("p.csv"), encoding="utf-8") as outline:
            vertices = [(curve, float(x), float(y)) for curve, x, y in list(csv.reader(outline))[1:]]
        of = "phi,phi.rate,phi.accel,c.force.x,c.force.y,Q.force.x,Q.force.y,theta.effort"
        _, rows = self.good("sweep", file, "--over", "theta=0:360deg", "--steps", "36", "--of", of, "--format", "csv", "-q").csv()
        return run.json(), vertices, rows

    def agree(self, kind, sign):
        words = ["--limits", "pressure=33deg"] + (["--compare", "cycloidal,3-4-5"] if "rise" in kind[0] else [])
        answers, outlines, sweeps = zip(*(self.asked(self.machine(kind, up, up < 0 and sign < 0), words) for up in (1, -1)))
        self.same(*answers, sign)
        self.assertGreater(len(outlines[0]), 60)
        for one, other in zip(*outlines, strict=True):
            self.assertEqual(one[0], other[0])
            self.assertAlmostEqual(one[1], other[1], delta=1e-9)
            self.assertAlmostEqual(one[2], -other[2], delta=1e-9)
        flips = (sign, sign, sign, 1, -1, -sign, sign, 1)  # a pin's force acts on its second body
        for one, other in zip(*sweeps, strict=True):
            for a, b, flip in zip(one[1:], other[1:], flips, strict=True):
                self.assertAlmostEqual(a, flip * b, delta=1e-7 * max(1, abs(a)))
        for answer, rows in zip(answers, sweeps):
            column = answer["columns"].index("contact_force")
            for at, row in zip(answer["rows"], rows, strict=True):
                self.assertAlmostEqual(abs(at[column]), abs(complex(row[4], row[5])), delta=1e-6 * max(1, abs(at[column])))

    def test_every_number(self):
        """Of `yoke cam`, of the outline, and of the motion and forces; and `yoke cam` gives the contact force that dynamics find."""
        for name, kind, sign in self.pairs():
            with self.subTest(name, sign=sign):
                self.agree(kind, sign)

    def test_its_drawing(self):
        """Both ways to write the mirror image draw it alike."""
        for name, kind in WITH_POINT.items():
            with self.subTest(name):
                pictures = [self.good("draw", self.machine(kind, -1, negative), "--at", "theta=70deg", "-q").out for negative in (True, False)]
                self.assertIn("<svg", pictures[0])
                self.assertEqual(*pictures)

    def test_it_flies_alike(self):
        of = ["phi", "phi.rate"]
        for name in ("roller", "both", "formula"):
            rows, events = [], []
            for up in (1, -1):
                run = self.good("simulate", self.machine(WITH_POINT[name], up, up < 0, stiffness=1), "--param", "n=1500rpm", "--to", "0.25s", "--of", ",".join(of), "--format", "json", "-q").json()
                rows.append(run["rows"])
                events.append([(e["kind"], e["time"]) for e in run["events"]])
            with self.subTest(name):
                self.assertIn("lift-off", [kind for kind, _ in events[0]])
                self.assertEqual([kind for kind, _ in events[0]], [kind for kind, _ in events[1]])
                for (_, one), (_, other) in zip(*events):
                    self.assertAlmostEqual(one, other, delta=1e-7)
                for one, other in zip(*rows, strict=True):
                    for a, b in zip(one[1:], other[1:]):
                        self.assertAlmostEqual(a, -b, delta=1e-6 * max(1, abs(a)))

    def test_a_law_of_the_wrong_sign_is_told(self):
        """Above 0 it would lead the roller into the cam: the point is taken for a mistake, and a growing lift leads away."""
        text = self.read(self.machine(WITH_POINT["roller"], -1, True)).decode()
        text = text.replace("fall", "rise", 1).replace("rise: {to: 280", "fall: {to: 280")
        run = self.good("check", self.write("wrong.yaml", text))
        self.assertIn("on the side where lift brings it nearer", re.sub(r"\s+", " ", run.err))
        self.assertIn("[W0474]", run.err)


if __name__ == "__main__":
    unittest.main(argv=[__file__])
