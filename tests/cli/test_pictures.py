"""Pictures of synthesis, of cognates and of polygons, read back: every line and word is where the answer's numbers have it."""
import cmath
import math
import os
import re
import unittest
from xml.etree import ElementTree

from harness import Case, ROOT, Run
from page import size_of

BARE = """\
gravity: [0, -9.81]
bodies:
  ground: {points: {O: [0, 0]}}
  arm:    {points: {O: [0, 0], A: [1, 0]}, mass: 1, center: [0.5, 0]}
  bare:   {points: {A: [0, 0]}, mass: 1}
joints:
  O: {pin: [ground, arm], angle: p}
  A: {pin: [arm, bare], angle: q}
start: {p: 0, q: 0}
"""
DEAD = """\
bodies:
  ground: {points: {O: [0, 0]}}
  crank:  {points: {O: [0, 0], A: [0.05, 0]}}
  rod:    {points: {A: [0, 0], B: [0.18, 0]}, mass: 1}
  piston: {points: {B: [0, 0]}}
joints:
  O: {pin: [ground, crank], angle: th}
  A: {pin: [crank, rod], angle: ph}
  B: {pin: [rod, piston]}
  S: {slide: [ground, piston], along: x, distance: s}
drives: {s: 0.23}
start: {th: 0, ph: 0}
"""
SVG = "{http://www.w3.org/2000/svg}"


def example(name):
    return os.path.join(ROOT, "examples", name + ".yaml")


def found(group, tag, **having):
    """Elements with these attributes; class_ is class, stroke_width stroke-width."""
    return [e for e in group.iter(SVG + tag) if all(e.get(k.strip("_").replace("_", "-")) == v for k, v in having.items())]


def center(circle):
    """Where it is, with y upwards."""
    return complex(float(circle.get("cx")), -float(circle.get("cy")))


def ends(line):
    return [complex(float(line.get("x%d" % i)), -float(line.get("y%d" % i))) for i in (1, 2)]


def corners(line):
    return [complex(float(x), -float(y)) for x, y in (pair.split(",") for pair in line.get("points").split())]


class Pictures(Case):
    def assert_at(self, one, other):
        self.assertLess(abs(one - other), 0.05)

    def assert_lines(self, lines, wanted):
        """The lines have these ends, whichever is first."""
        def both(pair):
            return sorted(pair, key=lambda z: (round(z.real), round(z.imag)))
        lines, wanted = (sorted(map(both, pairs), key=lambda pair: [(round(z.real), round(z.imag)) for z in pair]) for pairs in (lines, wanted))
        self.assertEqual(len(lines), len(wanted))
        for line, pair in zip(lines, wanted):
            for one, other in zip(line, pair):
                self.assert_at(one, other)


class Synthesis(Pictures):
    def drawn(self, path):
        """A picture's groups: ranges of the axes, and what maps its pixels to values."""
        root = ElementTree.parse(path).getroot()
        groups = list(root.iter(SVG + "g"))
        frames = [p for p in root.iter(SVG + "polygon") if p.get("stroke") == "#888"]
        self.assertEqual(len(groups), len(frames))
        for group, frame in zip(groups, frames):
            x, y = ([float(v) for v in group.get("data-" + axis).split()] for axis in "xy")
            (left, bottom), _, (right, top) = [tuple(map(float, p.split(","))) for p in frame.get("points").split()][:3]
            scale = (right - left) / (x[1] - x[0]), (bottom - top) / (y[1] - y[0])
            yield group, lambda px, py, l=left, b=bottom, s=scale, x0=x[0], y0=y[0]: (x0 + (px - l) / s[0], y0 + (b - py) / s[1]), scale

    def test_burmesters_curves_are_where_dyads_reach_all_positions(self):
        for name, count in (("four-positions", 1), ("five-positions", 2)):
            path = os.path.join(ROOT, "examples", "tasks", name + ".yaml")
            folder = os.path.join(self.folder, name)
            answer = self.good("synthesize", path, "-o", folder, "--format", "json").json()
            with open(path, encoding="utf-8") as file:
                text = file.read()
            unit = 0.001 if "length: mm" in text else 1
            poses = [(float(a), float(b), math.radians(float(c))) for a, b, c in
                     re.findall(r"at: \[([-0-9.]+), ([-0-9.]+)\], angle: ([-0-9.]+)", text)]
            self.assertEqual(len(poses), 3 + count)
            (group, value, scale), = self.drawn(os.path.join(folder, "burmester.svg"))
            paths = list(group.iter(SVG + "path"))
            self.assertEqual(len(paths), 2 * count)
            for k, drawn in enumerate(paths):
                own = poses[:3] + [poses[3 + k // 2]]
                points = [value(float(a), float(b)) for a, b in re.findall(r"[ML]([-0-9.]+) ([-0-9.]+)", drawn.get("d"))]
                self.assertGreater(len(points), 100)
                for at in points:
                    self.assertLess(self.off_curve(own, at, drawn.get("class") == "centres") * scale[0], 0.05)
            for drawn in paths[:2 * count - 2]:  # nothing is missing where a ray touches the curve
                points = re.findall(r"[ML]([-0-9.]+ [-0-9.]+)", drawn.get("d"))
                ends = [complex(*map(float, at.split())) for at in points if points.count(at) == 1]
                self.assertEqual([(a, b) for a in ends for b in ends if 3 < abs(a - b) < 40], [])
            marks = {(m.get("class"), int(m.get("data-dyad"))): m for m in group.iter(SVG + "circle")}
            self.assertGreater(len(marks), 4)
            for (kind, number), mark in marks.items():
                dyad = answer["dyads"][number - 1]
                x, y, turn = poses[0]
                mx, my = (v / unit for v in dyad["moving"])
                wanted = [v / unit for v in dyad["fixed"]] if kind == "centre" else [
                    x + mx * math.cos(turn) - my * math.sin(turn), y + mx * math.sin(turn) + my * math.cos(turn)]
                for told, drawn_at, is_at in zip(map(float, mark.get("data-at").split()), value(float(mark.get("cx")), float(mark.get("cy"))), wanted):
                    self.assertAlmostEqual(told, is_at, delta=1e-4 * max(1, abs(is_at)))
                    self.assertAlmostEqual(drawn_at, is_at, delta=0.01 / scale[0])

    @staticmethod
    def off_curve(poses, at, is_centre):
        """How far a fixed pivot (or a moving one, where it is at the first position) is from having a partner at a constant distance."""
        def determinant(px, py):
            rows = []
            first = complex(*poses[0][:2]), cmath.exp(1j * poses[0][2])
            p = complex(px, py)
            z = (p - first[0]) / first[1]
            for x, y, turn in poses[1:]:
                d, r = complex(x, y), cmath.exp(1j * turn)
                if is_centre:  # |d + r z - p|^2 less that of the first position, linear in z
                    w = (d - p) * r.conjugate() - (first[0] - p) * first[1].conjugate()
                    rows.append((2 * w.real, 2 * w.imag, abs(d - p) ** 2 - abs(first[0] - p) ** 2))
                else:  # linear in the fixed pivot
                    q, q0 = d + r * z, p
                    rows.append((2 * (q - q0).real, 2 * (q - q0).imag, abs(q0) ** 2 - abs(q) ** 2))
            (a, b, c), (d, e, f), (g, h, i) = rows
            return a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g)
        here, step = determinant(*at), 1e-5
        slope = math.hypot(determinant(at[0] + step, at[1]) - determinant(at[0] - step, at[1]),
                           determinant(at[0], at[1] + step) - determinant(at[0], at[1] - step)) / (2 * step)
        return abs(here) / slope if slope > 0 else 0

    def test_errors_of_a_function_are_drawn_before_and_after(self):
        path = self.write("both.yaml", """synthesis: function
of: x^1.5
x: [1, 4]
input: 90 deg
output: 90 deg
mechanisms: [four-bar, slider-crank]
fix: {travel: 80 mm}
evened: true
units: {length: mm, angle: deg}
""")
        folder = os.path.join(self.folder, "both")
        answer = self.good("synthesize", path, "-o", folder, "--format", "json").json()
        drawn = list(self.drawn(os.path.join(folder, "errors.svg")))
        self.assertEqual(len(drawn), len(answer["candidates"]))
        with open(os.path.join(folder, "errors.svg"), encoding="utf-8") as file:
            told = re.findall(r"error of the output \[(\w+)\], at most ([\d.e-]+)", file.read())
        self.assertEqual(len(told), len(drawn))
        for (unit, most), candidate in zip(told, answer["candidates"]):
            self.assertAlmostEqual(float(most) * size_of(unit), candidate["worst"], delta=6e-4 * candidate["worst"])
        evened = 0
        for (group, value, scale), candidate in zip(drawn, answer["candidates"]):
            unit = 0.001 if candidate["mechanism"] == "slider-crank" else math.pi / 180
            lines = {p.get("class"): [value(*map(float, q.split(","))) for q in p.get("points").split()]
                     for p in group.iter(SVG + "polyline")}
            self.assertAlmostEqual(lines["error"][-1][0], 90, delta=0.05)
            self.assertAlmostEqual(max(abs(y) for _, y in lines["error"]), candidate["worst"] / unit, delta=0.01 * candidate["worst"] / unit)
            self.assertEqual("before" in lines, "interpolating" in candidate)
            if "before" in lines:
                before = candidate["interpolating"] / unit
                self.assertAlmostEqual(max(abs(y) for _, y in lines["before"]), before, delta=0.01 * before)
                evened += 1
        self.assertGreater(evened, 2)

    def test_candidates_are_drawn_as_they_stand(self):
        """Joints, bars, the curve, the task and the words, against the file of each candidate, which the engine solves."""
        six = self.write("six.yaml", "synthesis: path\nmechanisms: [watt]\nbest: 1\npoints: [[-40, 0], [-20, 17], [0, 20], [20, 17]]\nunits: {length: mm}\n")
        names = ("film-advance", "five-positions", "hatch", "metering-pump")
        for path in [os.path.join(ROOT, "examples", "tasks", name + ".yaml") for name in names] + [six]:
            folder = self.path("drawn-" + os.path.basename(path)[:-5])
            answer = self.good("synthesize", path, "-o", folder, "--format", "json").json()
            picture = ElementTree.parse(os.path.join(folder, "candidates.svg")).getroot()
            groups = found(picture, "g", class_="candidate")
            self.assertEqual(len(groups), len(answer["candidates"]))
            size = 270 * min(3, len(groups)), 310 * ((len(groups) + 2) // 3)  # of cells with their words
            self.assertEqual([float(picture.get(key)) for key in ("width", "height")], list(map(float, size)))
            for k, (group, candidate) in enumerate(zip(groups, answer["candidates"])):
                with self.subTest(path, rank=k + 1):
                    self.check_candidate(group, candidate, os.path.join(folder, candidate["file"]), complex(270 * (k % 3), -310 * (k // 3)))

    def check_candidate(self, group, candidate, path, corner):
        solved = next(c for c in self.good("solve", path, "--format", "json").json()["configurations"] if c["is_start"])
        at = {name.split(".")[1]: complex(*point["position"]) for name, point in solved["points"].items()}
        if candidate["mechanism"] == "inverted-slider-crank":
            at["B"] = at["B0"]  # the block's joint with the rod is where it turns about the ground
        joints = [name for name in ("A0", "B0", "A", "B", "C", "D", "E") if name in at]
        drawn = list(map(center, found(group, "circle", stroke="#34495e")))
        self.assertEqual(len(drawn), len(joints))
        far = max(joints, key=lambda name: abs(at[name] - at["A0"]))
        scale = abs(drawn[joints.index(far)] - drawn[0]) / abs(at[far] - at["A0"])
        pixel = {name: drawn[0] + scale * (point - at["A0"]) for name, point in at.items()}
        for one, name in zip(drawn, joints):
            self.assert_at(one, pixel[name])
        rods = [("A0", "A"), ("D", "E")] + ([] if at["B"] == at.get("B0") else [("B0", "B")])
        for style, pairs in (("#34495e", rods), ("#5d6d7e", (("A", "B"), ("C", "E")))):
            self.assert_lines(map(ends, found(group, "line", stroke=style)), [[pixel[a], pixel[b]] for a, b in pairs if a in at and b in at])
        self.check_task(group, candidate, pixel, scale)
        shown = drawn + [pixel[name] for name in pixel if re.fullmatch(r"T\d+|P", name)]
        shown += [z for line in found(group, "polyline", stroke="#2471a3") for z in corners(line)]
        wide = max(max(part) - min(part) for part in ([z.real for z in shown], [z.imag for z in shown]))
        self.assertAlmostEqual(wide, 270 - 2 * 22, delta=0.1)  # it fills its cell
        for z in shown:
            self.assertTrue(21.9 < (z - corner).real < 248.1 and 21.9 < (corner - z).imag < 248.1)
        first, second = [text.text for text in found(group, "text")][-2:]
        self.assertEqual(first, "%d  %s" % (candidate["rank"], candidate["type"]))
        told = float(re.fullmatch(r"transmission from (\S+) deg.*", second).group(1))
        self.assertAlmostEqual(told, math.degrees(candidate["transmission"][0]), delta=0.05)

    def check_task(self, group, candidate, pixel, scale):
        """Points, or positions along the body's x axis; the curve passes all of them, and where the machine stands."""
        tasks = [pixel["T%d" % k] for k in range(1, 20) if "T%d" % k in pixel]
        for one, task in zip(map(center, found(group, "circle", fill="#c0392b")), tasks):
            self.assert_at(one, task)
        for line, task in zip(found(group, "line", stroke="#c0392b", stroke_width="2"), tasks):
            self.assert_at(ends(line)[0], task)
            self.assertAlmostEqual(abs(ends(line)[1] - ends(line)[0]), 22, delta=0.05)
        for curve in map(corners, found(group, "polyline", stroke="#2471a3")):
            step = max(abs(a - b) for a, b in zip(curve, curve[1:]))
            for task in tasks + [pixel["P"]]:
                self.assertLess(min(abs(z - task) for z in curve), step + scale * candidate["worst"])

    def test_the_curve_of_a_machine_that_is_there_is_drawn_before_and_after(self):
        """Both, and the points that it should pass, against sweeps of the machine and of what was found."""
        goal = [1 + 5j, 2 + 5.1j, 3 + 5j]
        path = self.write("machine.yaml", "synthesis: machine\nmachine: %s\nfree: {l1: [1.5, 3.5], l3: [2, 5]}\nbest: 2\n"
                          "over: {input: theta, range: [90 deg, 270 deg], steps: 24}\ngoals:\n  - {point: coupler.P, through: %s}\n"
                          % (example("hoeken"), [[z.real, z.imag] for z in goal]))
        folder = self.path("hoeken")
        answer = self.good("synthesize", path, "-o", folder, "--format", "json").json()
        groups = found(ElementTree.parse(os.path.join(folder, "candidates.svg")), "g", class_="candidate")
        self.assertEqual(len(groups), len(answer["candidates"]))

        def swept(file):
            rows = self.good("sweep", file, "--over", "theta=90:270deg", "--steps", "24", "--of", "coupler.P.x,coupler.P.y", "--format", "csv").csv()[1]
            return [complex(x, y) for _, x, y in rows]

        for k, (group, candidate) in enumerate(zip(groups, answer["candidates"])):
            before, after = map(corners, found(group, "polyline"))
            own, other = swept(example("hoeken")), swept(os.path.join(folder, candidate["file"]))
            every = own + other + goal
            low, high = (complex(end(z.real for z in every), end(z.imag for z in every)) for end in (min, max))
            scale = (270 - 2 * 22) / max((high - low).real, (high - low).imag)
            middle = complex(135 + 270 * k, -135)
            marks = list(map(center, found(group, "circle", fill="#c0392b")))
            for drawn, places in ((before, own), (after, other), (marks, goal)):
                self.assertEqual(len(drawn), len(places))
                for one, at in zip(drawn, places):
                    self.assert_at(one, middle + scale * (at - (low + high) / 2))
            words, = (text.text for text in found(group, "text"))
            rank, error = re.fullmatch(r"(\d+)  error (\S+)", words).groups()
            self.assertEqual(int(rank), candidate["rank"])
            self.assertAlmostEqual(float(error), candidate["error"], delta=1e-3 * candidate["error"])


class Cognates(Pictures):
    def test_cognates_are_drawn_over_one_another_with_their_point_on_the_curve(self):
        for name in ("four-bar", "slider-crank"):
            path, folder = example(name), self.path(name)
            traced = [] if name == "four-bar" else ["--trace", "rod.P"]
            if traced:
                with open(path, encoding="utf-8") as file:
                    text = re.sub(r"(rod: +\{points: \{)", r"\1P: [0.1, 0.05], ", file.read())
                path = self.write("slider.yaml", text)
            answer = self.good("cognates", path, "--format", "json", "-o", folder, *traced).json()
            picture = ElementTree.parse(os.path.join(folder, "cognates.svg"))
            plates = [corners(p) for p in found(picture, "polygon")]
            self.assertEqual(len(plates), 1 + len(answer["cognates"]))
            points = [plate[2] for plate in plates]  # all trace the same point
            for point in points:
                self.assert_at(point, points[0])
            curve, = map(corners, found(picture, "polyline"))
            self.assertLess(min(abs(z - points[0]) for z in curve), max(abs(a - b) for a, b in zip(curve, curve[1:])))
            drawn = list(map(center, found(picture, "circle")))
            self.assertEqual(len(drawn), 4 * len(plates))
            scale = None
            for k, cognate in enumerate(answer["cognates"], 1):
                a0, a, b, b0 = drawn[4 * k:4 * k + 4]
                lengths = cognate["lengths"]
                scale = scale or abs(a - a0) / lengths["input"]
                self.assertAlmostEqual(abs(a - a0), scale * lengths["input"], delta=0.05)
                self.assertAlmostEqual(abs(b - a), scale * lengths["coupler"], delta=0.05)
                self.assert_at(points[k], a + (b - a) / abs(b - a) * scale * complex(*cognate["point"]))
                if cognate["mechanism"] == "four-bar":
                    self.assertAlmostEqual(abs(b0 - b), scale * lengths["output"], delta=0.05)
                    self.assert_at(b0 - a0, scale * (complex(*cognate["pivots"][1]) - complex(*cognate["pivots"][0])))
            every = drawn + curve
            self.assertAlmostEqual(max(max(v) - min(v) for v in ([z.real for z in every], [z.imag for z in every])), 560, delta=0.1)


class Polygons(Pictures):
    def vectors(self, path, kind):
        return self.good("solve", path, "--polygon", kind, "--format", "json").json()["configurations"][0]["polygon"]

    def picture(self, path, kind):
        return ElementTree.fromstring(self.good("draw", path, "--polygon", kind).out)

    def check_bar(self, group, scale, units):
        """The bar of the scale is as long as its words say, in a unit that people use."""
        bar, = found(group, "line", class_="scale")
        words = next(t.text for t in found(group, "text") if float(t.get("y")) == float(bar.get("y1")) + 4)
        number, unit = words.split(" ")
        self.assertIn(unit, units)
        self.assertIn(float(number) / 10 ** math.floor(math.log10(float(number)) + 1e-9), (1, 2, 5))
        a, b = ends(bar)
        self.assertAlmostEqual(abs(b - a), float(number) * size_of(unit) * scale, delta=0.02)

    def check_words(self, picture, steps):
        told = " ".join(t.text.strip() for t in found(picture, "text", x="30"))
        self.assertEqual(told, " ".join("%d. %s" % (k + 1, step) for k, step in enumerate(steps)))
        heights = [float(t.get("y")) for t in found(picture, "text", x="30")]  # below all that is drawn, one below the other
        drawn = max(place.imag for line in picture.iter("{http://www.w3.org/2000/svg}line") for place in ends(line))
        self.assertLess(drawn + 10, heights[0])
        self.assertEqual(heights, sorted(set(heights)))
        self.assertLess(heights[-1], float(picture.get("height")))

    def test_velocities_and_accelerations_are_drawn_to_scale(self):
        for name, kind in (("quick-return", "velocity"), ("quick-return", "acceleration"), ("crank-press", "acceleration")):
            with self.subTest(name, kind=kind):
                polygon, picture = self.vectors(example(name), kind), self.picture(example(name), kind)
                scale = float(picture.get("data-scale"))
                marks = list(map(center, found(picture, "circle")))
                images = [complex(*image["value"]) for image in polygon["images"]]
                self.assertEqual(len(marks), len(images))
                for mark, image in zip(marks, images):
                    self.assert_at(mark - marks[0], scale * (image - images[0]))
                drawn = {}
                for vector in polygon["vectors"]:
                    value, part = scale * complex(*vector["value"]), "Coriolis" if vector["part"] == "coriolis" else vector["part"]
                    if abs(value) > 0.05:
                        start = marks[0] + scale * (complex(*vector["start"]) - images[0])
                        drawn.setdefault(part, []).append([start, start + value])
                for part in ("turning", "normal", "tangential", "sliding", "Coriolis"):
                    lines = found(picture, "line", class_=part)
                    self.assert_lines(map(ends, lines), drawn.get(part, []))
                    self.assertEqual({line.get("stroke-dasharray") for line in lines}, ({"6 3"} if part in ("normal", "Coriolis") else {None}) if lines else set())
                    self.assertEqual(part in [t.text for t in found(picture, "text")], part in [v["part"].replace("c", "C") if v["part"] == "coriolis" else v["part"] for v in polygon["vectors"]])
                tips = [corners(p)[0] for p in found(picture, "polygon")]
                for pairs in drawn.values():
                    for _, tip in pairs:
                        self.assertLess(min(abs(tip - one) for one in tips), 0.05)
                reached = [end for pairs in drawn.values() for pair in pairs for end in pair]  # as large as the page lets it be
                across, up = (max(part) - min(part) for part in ([z.real for z in reached], [z.imag for z in reached]))
                self.assertAlmostEqual(max(across / (float(picture.get("width")) - 120), up / 560), 1, delta=1e-3)
                names = sorted(name for t in found(picture, "text", font_style="italic") for name in t.text.split(", "))
                self.assertEqual(names, sorted(image["name"] for image in polygon["images"]))
                self.check_bar(picture, scale, ("m/s", "mm/s", "m/s^2", "mm/s^2"))
                self.check_words(picture, polygon["steps"])

    def test_accelerations_that_loads_do_not_give_have_no_polygon(self):
        """Both inputs are free, and nothing resists one of them: how the other moves is not known either."""
        light = self.write("light.yaml", BARE)
        for verb in ("solve", "draw"):
            run = Run(verb, light, "--polygon", "acceleration")
            self.assertEqual(run.code, 1, run.err)
            self.assertIn("no acceleration polygon can be drawn", run.err)
            self.assertNotIn("whose motion is given", run.out)
            self.assertIn("whose motion is given: 0 rad/s.", Run(verb, light, "--polygon", "velocity").out)

    def test_a_dead_point_is_the_reason_why_there_are_no_forces(self):
        """The piston drives the crank, which is in line with the rod."""
        dead = self.write("dead.yaml", DEAD)
        for verb in ("solve", "draw"):
            run = Run(verb, dead, "--polygon", "force")
            self.assertEqual(run.code, 1, run.err)
            self.assertIn("no force polygon can be drawn: dead point at joint `B`", run.err)

    def test_forces_close_a_polygon_for_each_body(self):
        """In newtons, where the file's units of length and mass would make kg*mm/s^2."""
        polygon, picture = self.vectors(example("crank-press"), "force"), self.picture(example("crank-press"), "force")
        cells = found(picture, "g")
        self.assertEqual([cell.get("data-body") for cell in cells], ["crank", "rod", "ram"])
        for cell in cells:
            own = [v for v in polygon["vectors"] if v["body"] == cell.get("data-body")]
            scale = float(cell.get("data-scale"))
            self.assertLess(abs(sum(complex(*v["value"]) for v in own)), 1e-9 * max(abs(complex(*v["value"])) for v in own))
            seen = [v for v in own if scale * abs(complex(*v["value"])) > 0.05]
            lines = [line for line in found(cell, "line") if line.get("class") != "scale"]
            self.assertEqual([line.get("class") for line in lines], [v["part"] for v in seen])
            first = ends(lines[0])[0] - scale * complex(*seen[0]["start"])
            for line, v in zip(lines, seen):
                self.assert_at(ends(line)[0], first + scale * complex(*v["start"]))
                self.assert_at(ends(line)[1], first + scale * (complex(*v["start"]) + complex(*v["value"])))
            reached = [end for line in lines for end in ends(line)]  # as large as its place lets it be: 280 by 220
            across, up = (max(part) - min(part) for part in ([z.real for z in reached], [z.imag for z in reached]))
            self.assertAlmostEqual(max(across / 280, up / 220), 1, delta=1e-3)
            self.assertEqual([t.text for t in found(cell, "text", font_style="italic")], [v["name"] for v in seen])
            self.check_bar(cell, scale, ("N", "kN"))
        self.check_words(picture, polygon["steps"])
        size = float(re.search(r"at B from ram, (\S+) N", polygon["steps"][1]).group(1))
        self.assertAlmostEqual(size, abs(complex(*next(v["value"] for v in polygon["vectors"] if (v["body"], v["name"]) == ("rod", "B")))), delta=1e-3)
        table = self.good("solve", example("crank-press"), "--polygon", "force").out
        self.assertIn("size [N]  moment [N*m]", table)
        told = re.search(r"(?m)^  rod +B +ram +(\S+) +(\S+) +(\S+)", table)
        self.assertAlmostEqual(float(told.group(3)), size, delta=1e-3)


if __name__ == "__main__":
    unittest.main()
