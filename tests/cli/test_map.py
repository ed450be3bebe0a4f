"""`yoke map`: all circuits of a machine, in text, JSON and pictures, and what it refuses."""
import math
import os
import re
import unittest

from harness import ROOT, Case, Run


def example(name):
    return os.path.join(ROOT, "examples", name + ".yaml")


# A guide that turns, and a bar from its block to a link.
POLAR = """\
units: {length: mm, angle: deg}
bodies:
  ground: {points: {O: [0, 0], C: [100, 0]}}
  rail: {points: {O: [0, 0]}}
  block: {points: {B: [0, 0]}}
  bar: {points: {B: [0, 0], D: [60, 0]}}
  link: {points: {C: [0, 0], D: [50, 0]}}
joints:
  O: {pin: [ground, rail], angle: theta}
  S: {slide: [rail, block], along: 0, from: O, to: B, distance: d}
  B: {pin: [block, bar], angle: phi}
  D: {pin: [bar, link]}
  C: {pin: [ground, link]}
start: {theta: 40, d: 70, phi: -60}
"""


class Map(Case):
    def answer(self, *words):
        return self.good("map", *words, "--format", "json").json()

    def test_a_rocker_has_two_circuits(self):
        answer = self.answer(example("four-bar"), "--over", "theta4")
        self.assertIs(answer["complete"], True)
        self.assertEqual(answer["coordinate"], "theta4")
        self.assertEqual([c["contains_start"] for c in answer["circuits"]], [True, False])
        for circuit, sign in zip(answer["circuits"], (1, -1)):
            (low, high), = circuit["ranges"]
            self.assertAlmostEqual(math.degrees(min(sign * low, sign * high)), 54.9, 1)
            self.assertAlmostEqual(math.degrees(max(sign * low, sign * high)), 128.7, 1)
            self.assertEqual(circuit["branches"], 2)
            self.assertEqual([e["kind"] for e in circuit["events"]], ["limit", "limit"])
            self.assertIs(circuit["joints"]["O2"]["full"], True)
            self.assertIs(circuit["joints"]["O4"]["full"], False)
            self.assertEqual([e["at"] for e in circuit["events"]], [low, high])

    def test_a_limit_is_where_a_sweep_stops(self):
        answer = self.answer(example("non-grashof"))
        at = max(e["at"] for e in answer["circuits"][0]["events"])
        run = Run("sweep", example("non-grashof"), "--over", f"theta2=0:{at + 0.1}", "--format", "json")
        self.assertEqual(run.code, 1)
        limit = next(e for e in run.json()["events"] if e["kind"] == "limit")
        self.assertAlmostEqual(limit["at"], at, 9)

    def test_the_range_of_a_group_ends_where_the_map_has_limits(self):
        file = example("double-butterfly")
        limits = [e["at"] for c in self.answer(file, "--over", "lambda")["circuits"] for e in c["events"] if e["kind"] == "limit"]
        run = Run("sweep", file, "--over", "lambda=0:1", "--steps", "4", "--format", "json")
        (ends,) = run.json()["ranges"]
        for end in ends:
            self.assertLess(min(abs(end - at) for at in limits), 1e-9)

    def test_the_drive_stands_at_dead_points(self):
        answer = self.answer(example("non-grashof"), "--over", "theta4")
        kinds = [(e["kind"], e["of"]) for e in answer["circuits"][0]["events"]]
        self.assertEqual(sorted(kinds), [("dead-point", "theta2")] * 2 + [("limit", "B")] * 2)
        limits = self.answer(example("non-grashof"))["circuits"][0]["ranges"][0]
        for event in answer["circuits"][0]["events"]:
            if event["kind"] == "dead-point":
                stands = math.remainder(event["coordinates"]["theta2"], 2 * math.pi)
                self.assertAlmostEqual(abs(stands), limits[1], 9)

    def test_words(self):
        out = self.good("map", example("four-bar"), "--over", "theta4").out
        self.assertIn("circuit 1: theta4 from 54.9004 to 128.682 deg, two branches; contains the start", out)
        self.assertIn("turn fully: O2, A\n", out)
        self.assertIn("circuit 1: theta2 at every angle, one branch", self.good("map", example("four-bar")).out)

    def test_places_where_circuits_meet_have_the_digits_that_are_known(self):
        """A kite meets itself where its crank lies along the ground, at any angle of the ground."""
        for turned in (0, 0.123456789123):
            kite = self.write("kite.yaml", """bodies:
  ground: {points: {O: [0, 0], C: [%r, %r]}}
  crank:  {points: {O: [0, 0], A: [1, 0]}}
  coupler: {points: {A: [0, 0], B: [1.5, 0]}}
  rocker:  {points: {C: [0, 0], B: [1.5, 0]}}
joints:
  O: {pin: [ground, crank], angle: th}
  C: {pin: [ground, rocker], angle: ps}
  A: {pin: [crank, coupler]}
  B: {pin: [coupler, rocker]}
start: {th: %r, ps: %r}
""" % (math.cos(turned), math.sin(turned), turned + 0.7, turned + 1.7))
            text = self.good("map", kite, "--over", "th").out
            place = "0" if turned == 0 else "%.9f" % turned
            self.assertEqual(re.findall(r"change point  A +(\S+) ", text), [place, place], text)
            self.assertIn("near 0 rad" if turned == 0 else "near 0.123457 rad", text)

    def test_pictures(self):
        path = self.path("map.svg")
        self.good("map", example("four-bar"), "--over", "theta4", "--plot", path, "--trace", "coupler.P", "--of", "theta2")
        with open(path, encoding="utf-8") as file:
            svg = file.read()
        self.assertTrue(svg.startswith("<svg") and svg.endswith("</svg>\n"))
        self.assertEqual(svg.count("<circle"), 4)
        self.assertIn('stroke-width="3"', svg)
        self.assertNotIn("nan", svg)

    def test_a_workspace_is_the_annuli_of_both_legs(self):
        answer = self.answer(example("five-bar"), "--over", "reachL.P.x,reachL.P.y", "--tol", "0.005")
        self.assertIs(answer["complete"], True)
        self.assertEqual(answer["coordinates"], ["reachL.P.x", "reachL.P.y"])
        region, = answer["regions"]
        self.assertEqual((region["configurations"], region["contains_start"], len(region["holes"])), (4, True, 1))
        self.assertEqual(sorted(b["of"] for b in region["bounds"]), ["A", "P"])
        # Two discs of radius 0.46 whose centres are 0.12 apart share a lens; two holes of radius 0.06 touch.
        lens = 2 * 0.46**2 * math.acos(0.12 / 0.92) - 0.06 * math.sqrt(0.92**2 - 0.12**2)
        self.assertAlmostEqual(region["area"], lens - 2 * math.pi * 0.06**2, 4)
        for x, y in region["polygon"]:
            self.assertLess(max(math.hypot(x + 0.06, y), math.hypot(x - 0.06, y)), 0.4601)

    def test_regions_are_drawn_where_they_are(self):
        """Outlines and holes at the numbers along both axes; the legend has the colour of each count that occurs, on the page."""
        for machine, names, units, sizes in ((example("five-bar"), ("reachL.P.x", "reachL.P.y"), ("mm", "mm"), (0.001, 0.001)),
                                             (self.write("polar.yaml", POLAR), ("theta", "d"), ("deg", "mm"), (math.pi / 180, 0.001))):
            svg = self.path("regions.svg")
            answer = self.good("map", machine, "--over", ",".join(names), "--tol", "0.02", "--plot", svg, "--format", "json").json()
            with open(svg, encoding="utf-8") as file:
                text = file.read()
            across = [(float(x), float(word)) for x, word in re.findall(r'<text x="([^"]*)" y="[^"]*" text-anchor="middle"[^>]*>(-?[\d.]+)</text>', text)]
            up = [(float(y) - 4, float(word)) for y, word in re.findall(r'<text x="[^"]*" y="([^"]*)" text-anchor="end"[^>]*>(-?[\d.]+)</text>', text)]
            self.assertGreater(min(len(across), len(up)), 3)

            def pixel(place):
                return [a[0] + (value / size - a[1]) * (b[0] - a[0]) / (b[1] - a[1])
                        for value, size, (a, b) in zip(place, sizes, ((across[0], across[-1]), (up[0], up[-1])))]

            low, high = map(pixel, zip(*answer["domain"]))
            self.assertAlmostEqual(low[0] + high[0], 660, delta=0.1)
            self.assertAlmostEqual(low[1] + high[1], 580, delta=0.1)
            spans = high[0] - low[0], low[1] - high[1]  # the map fills the panel, angles both ways
            self.assertAlmostEqual(spans[0] if units[0] == "deg" else max(spans), 520, delta=0.1)
            self.assertAlmostEqual(spans[1] if units[0] == "deg" else max(spans), 520, delta=0.1)
            drawn = re.findall(r'<path fill="(.*?)".*? d="(.*?)"><title>(\d+) configurations</title>', text)
            self.assertEqual([int(count) for _, _, count in drawn], [region["configurations"] for region in answer["regions"]])
            for (_, way, _), region in zip(drawn, answer["regions"]):
                outlines = [re.findall(r"(\S+?) (\S+?)(?=[LZ])", part.lstrip("M")) for part in re.findall("M[^M]*Z", way)]
                for shown, outline in zip(outlines, [region["polygon"], *region["holes"]]):
                    self.assertEqual(len(shown), len(outline))
                    for one, place in zip(shown, outline):
                        for got, wanted in zip(one, pixel(place)):
                            self.assertAlmostEqual(float(got.lstrip("L")), wanted, delta=0.05)
            legend = re.findall(r'<polygon points="([\d.]+),[^"]*" fill="(#.*?)" stroke="#888"/>\n<text x="([\d.]+)"[^>]*>(\d+)<', text)
            self.assertEqual({(colour, count) for _, colour, _, count in legend}, {(colour, count) for colour, _, count in drawn})
            width = float(re.search(r'width="(\d+)"', text).group(1))
            self.assertTrue(legend and all(float(left) > 590 and float(at) + 8 < width for left, _, at, _ in legend))
            squares = [[complex(*map(float, corner.split(","))) for corner in square.split()]
                       for square in re.findall(r'<polygon points="([^"]*)" fill="#[^"]*" stroke="#888"/>\n<text', text)]
            feet = [float(y) for y in re.findall(r'stroke="#888"/>\n<text x="[^"]*" y="([^"]*)"', text)]
            self.assertEqual(len(squares), len(legend))
            for square, foot in zip(squares, feet):  # each has four equal sides, round its number's line
                sides = [b - a for a, b in zip(square, square[1:] + square[:1])]
                self.assertTrue(all(abs(b - 1j * a) < 0.02 and abs(a) > 8 for a, b in zip(sides, sides[1:])), square)
                self.assertTrue(square[0].imag < foot - 6 < foot < square[2].imag)
            self.assertTrue(all(a[2].imag < b[0].imag for a, b in zip(squares, squares[1:])))
            circle, = re.findall(r'<circle cx="([^"]*)" cy="([^"]*)"', text)  # where the machine stands
            start = self.good("solve", machine, "--format", "json", "-q").json()["configurations"][0]
            here = start["points"]["reachL.P"]["position"] if "." in names[0] else [start["coordinates"][name]["position"] for name in names]
            for got, wanted in zip(circle, pixel(here)):
                self.assertAlmostEqual(float(got), wanted, delta=0.1)
            for name, unit in zip(names, units):
                self.assertIn("%s [%s]" % (name, unit), text)

    def test_two_coordinates_are_asked_for_well(self):
        file = example("five-bar")
        self.wrong(806, "map", file, "--tol", "1")
        self.wrong(806, "map", example("four-bar"), "--tol", "0.01")
        self.wrong(806, "map", file, "--over", "theta1,theta2", "--tol", "0.00001")
        self.wrong(815, "map", file, "--over", "reachL.Q.x,reachL.Q.y")
        self.wrong(502, "map", file, "--over", "theta1,nothing")
        self.wrong(502, "map", file, "--over", "theta1,")
        self.wrong(818, "map", file, "--of", "theta1")
        for words in (("--trace", "reachL.P"), ("--of", "theta1")):
            self.wrong(817, "map", file, "--plot", self.path("x.svg"), *words)
        self.wrong(817, "map", file, "--over", "theta1,theta2", "--reach", "theta1=1")
        for words in ((example("four-bar"), "--over", "theta2,theta4"), (file, "--over", "theta1,theta1")):
            run = Run("map", *words)
            self.assertNotEqual(run.code, 0, run.out)
            self.assertIn("error", run.err)

    def test_more_freedoms_are_held(self):
        held = self.answer(example("five-bar-motors"), "--over", "theta1", "--at", "theta2=2.2")
        self.assertIs(held["complete"], True)
        for circuit in held["circuits"]:
            for event in circuit["events"]:
                self.assertEqual(event["coordinates"]["theta2"], 2.2)

    def test_what_can_be_reached(self):
        file = example("non-grashof")
        answer = self.answer(file, "--pose", "theta2=0.5", "--pose", "theta3=%r" % self.theta3(file, 0.5, 0),
                             "--reach", "theta2=0.5", "--reach", "theta3=%r" % self.theta3(file, 0.5, 1))
        self.assertIs(answer["reachable"], True)
        self.assertEqual(len(answer["way"]), 3)
        column = answer["coordinates"].index("theta2")
        self.assertAlmostEqual(abs(answer["way"][1][column]), math.radians(116.103881137), 7)
        run = Run("map", example("four-bar"), "--reach", "theta2=100deg", "--reach",
                  "theta4=%r rad" % self.other_rocker("100deg"), "--format", "json")
        self.assertEqual((run.code, run.json()["reachable"]), (1, False))
        self.assertIn("circuit 2", run.json()["reason"])
        far = Run("map", file, "--reach", "theta2=170deg")
        self.assertEqual(far.code, 1)
        self.assertIn("no configuration closes", far.out)
        self.wrong(818, "map", file, "--pose", "theta2=0.5")
        self.wrong(818, "map", file, "--pose", "theta3=0.5", "--reach", "theta2=1")

    def test_a_pose_of_several_configurations_is_told_by_what_tells_them_apart(self):
        file, at = example("four-bar"), "theta2=0.5"
        run = Run("map", file, "--pose", at, "--reach", "theta2=1")
        listed = re.search(r"`(\w+)` is (\S+) deg or (\S+) deg", run.err)
        self.assertTrue(run.code == 2 and listed, run.err)
        solved = self.good("solve", file, "--at", at, "--all", "--format", "json").json()["configurations"]
        values = [math.degrees(c["coordinates"][listed[1]]["position"]) for c in solved]
        for found, value in zip(sorted(map(float, listed.groups()[1:])), sorted(values)):
            self.assertAlmostEqual(found, value, 2)
            self.good("map", file, "--pose", at, "--pose", f"{listed[1]}={found} deg", "--reach", at, "--reach", f"{listed[1]}={found} deg")

    def theta3(self, file, at, index):
        answer = self.good("solve", file, "--at", f"theta2={at}", "--all", "--format", "json").json()
        return answer["configurations"][index]["coordinates"]["theta3"]["position"]

    def other_rocker(self, at):
        answer = self.good("solve", example("four-bar"), "--at", f"theta2={at}", "--all", "--format", "json").json()
        return next(c["coordinates"]["theta4"]["position"] for c in answer["configurations"] if not c["is_start"])

    def test_every_circuit_that_holds_the_pose_is_named(self):
        file = example("stephenson-awkward")
        circuits = self.answer(file)["circuits"]
        held = [k + 1 for k, c in enumerate(circuits) if c["ranges"][0][0] < 2.5 < c["ranges"][0][1]]
        self.assertEqual(len(held), 2)
        own = self.good("solve", file, "--at", "theta6=-2.2", "--all", "--format", "json").json()["configurations"][0]
        run = Run("map", file, "--pose", "theta6=-2.2", "--pose", "theta2=%r" % own["coordinates"]["theta2"]["position"],
                  "--reach", "theta6=2.5")
        self.assertEqual(run.code, 1, run.err)
        self.assertIn("on circuits %d and %d: no motion" % tuple(held), run.out)

    def test_a_repeated_constraint_leaves_one_circuit(self):
        answer = self.answer(example("three-crank-parallelogram"))
        circuit, = answer["circuits"]
        self.assertEqual((circuit["branches"], circuit["events"], circuit["parts"][0]["closed"]), (1, [], True))
        # On the crossed branch of the first two cranks the third one fits in two poses.
        self.assertIs(answer["complete"], False)
        self.assertIn("2 single poses", answer["reason"])
        for at in ("-0.0487", "3.0442"):
            self.assertIn(at, answer["reason"])

    def test_refusals(self):
        for name in ("two-rings", "ferguson"):
            run = Run("map", example(name))
            self.assertEqual((run.code, "E0850" in run.err), (1, True), name)
        self.wrong(806, "map", example("four-bar"), "--format", "csv")
        self.wrong(806, "map", example("four-bar"), "--over", "theta2=0:1")
        self.wrong(818, "map", example("four-bar"), "--trace", "coupler.P")
        self.wrong(502, "map", example("four-bar"), "--over", "thta2")
        self.wrong(815, "map", example("four-bar"), "--plot", self.path("x.svg"), "--trace", "coupler.nothing")


if __name__ == "__main__":
    unittest.main()
