"""yoke derive --svg: free bodies as drawings that say what the equations say. yoke draw: where names lie."""
import glob
import math
import os
import re
import subprocess
import unittest
import xml.etree.ElementTree as tree

from harness import Case, FEW, ROOT, Run, at_least, some

SVG = "{http://www.w3.org/2000/svg}"
LOST = """\
gravity: [0, -9.81]
bodies:
  ground: {points: {O: [0, 0]}}
  rod:    {points: {O: [0, 0], P: [1, 0]}, mass: 1 kg, center: [0.5, 0]}
joints:
  O: {pin: [ground, rod], angle: theta}
forces:
  push: {body: rod, at: P, value: [sqrt(-1 - theta^2) * 1 N, 0]}
start: {theta: 0.3}
"""
EXAMPLES = sorted(glob.glob(os.path.join(ROOT, "examples", "*.yaml")))


def plain(name):
    """Names of the equations and of the drawings, written alike: -F_12, -m1a^{C1}."""
    return re.sub(r"[\s()^{}_*]", "", name).replace("\u00b2", "2").replace("\u00b3", "3")


def named_in_section(answer):
    """Per heading: the names on the left of = (of a junction's equation: each term, with the other sign)."""
    found, heading = {}, None
    for item in answer["sections"][0]["items"]:
        if item["kind"] == "heading":
            heading = found.setdefault(item["text"], [])
        elif item["kind"] == "formula" and heading is not None:
            left = item["text"].split(" = ")[0]
            if item["text"].endswith(" = 0"):
                heading += ["-" + plain(term) for term in left.split(" + ")]
            else:
                heading.append(plain(left))
    found.pop("Constants of the file", None)
    return found


class Arrow:
    """A group of the drawing: its name, and the way it points or turns (y up)."""

    def __init__(self, group):
        self.name = plain(group.find(SVG + "title").text.split(", ")[0])
        line, arc = group.find(SVG + "line"), group.find(SVG + "polyline")
        if line is not None:
            self.ends = [(float(line.get("x" + k)), float(line.get("y" + k))) for k in "12"]
            x, y = self.ends[1][0] - self.ends[0][0], self.ends[0][1] - self.ends[1][1]
            length = math.hypot(x, y)
            self.way, self.points = (x / length, y / length), self.ends
        else:
            self.points = [tuple(map(float, pair.split(","))) for pair in arc.get("points").split()]
            (ax, ay), (bx, by), (cx, cy) = self.points[0], self.points[9], self.points[18]
            self.way = (math.copysign(1, -((bx - ax) * (cy - ay) - (by - ay) * (cx - ax))),)


def circle_of(arc):
    """The center and the radius of a moment's arc, through three of its points."""
    a, b, c = (complex(*arc.points[k]) for k in (0, 9, 18))
    w = (c - a) / (b - a)
    center = a - (a - b) * (w - abs(w) ** 2) / (2j * w.imag)
    return center, abs(center - a)


def label_box(text):
    """What a text covers, measured generously for Helvetica and its kin."""
    width = 0
    for part in [text.text or ""] + [span.text if span.get("font-size") is None else span.text[:len(span.text) * 3 // 4]
                                     for span in text.findall(SVG + "tspan")]:
        width += 6.3 * len(part)
    x, y = float(text.get("x")), float(text.get("y"))
    return x, y - 9, x + width, y + 2


def meets(box, a, b):
    """Does the segment pass through the box? Sampled each half pixel."""
    count = max(2, int(2 * math.hypot(b[0] - a[0], b[1] - a[1])))
    for i in range(count + 1):
        x, y = (a[k] + (b[k] - a[k]) * i / count for k in (0, 1))
        if box[0] < x < box[2] and box[1] < y < box[3]:
            return True
    return False


def complexes(points):
    return [complex(*map(float, pair.split(","))) for pair in points.split()]


def distance(z, a, b):
    """Of a point from a segment."""
    part = ((z - a) * (b - a).conjugate()).real / max(abs(b - a) ** 2, 1e-12)
    return abs(z - a - min(1, max(0, part)) * (b - a))


class Picture:
    def __init__(self, path):
        root = self.root = tree.parse(path).getroot()
        self.size = root.get("width"), root.get("height")
        self.arrows = [Arrow(group) for group in root.iter(SVG + "g") if group.find(SVG + "title") is not None]
        texts = [text for text in root.iter(SVG + "text") if text.get("font-size") is None]
        self.labels = [label_box(text) for text in texts]
        words = [text.text for text in root.iter(SVG + "text") if text.get("font-weight") == "bold"]
        self.title = words[0]


class Drawings(Case):
    drawn = {}  # what `draw` has answered

    def draw(self, example):
        """The section's names and the pictures, both by heading; None where the machine has none yet."""
        if example not in self.drawn:
            self.drawn[example] = self.draw_anew(example)
        return self.drawn[example]

    def draw_anew(self, example):
        folder = self.path("of-" + os.path.basename(example))
        run = Run("derive", example, "-q", "--what", "free-bodies", "--format", "json", "--svg", folder)
        if run.code == 1 and "--svg" in run.err:
            self.assertFalse(os.path.exists(folder))
            return None, None
        self.assertEqual(run.code, 0, example + run.err)
        pictures = [Picture(path) for path in sorted(glob.glob(folder + "/*"))]
        self.assertFalse(glob.glob(folder + "/.*"))
        return named_in_section(run.json()), {picture.title: picture for picture in pictures}

    def test_every_force_of_the_equations_is_drawn_once_on_each_of_its_bodies(self):
        drawn = 0
        for example in some(EXAMPLES):
            named, pictures = self.draw(example)
            if named is None:
                continue
            self.assertEqual(sorted(named), sorted(pictures), example)
            ways = {}
            for title, picture in pictures.items():
                self.assertEqual(sorted(named[title]), sorted(arrow.name for arrow in picture.arrows), example + title)
                self.assertEqual(picture.size, ("560", "440"))
                for arrow in picture.arrows:
                    ways.setdefault(arrow.name.lstrip("-"), {})[arrow.name[0] == "-"] = arrow.way
            for name, sides in ways.items():
                if len(sides) == 2:
                    drawn += 1
                    for one, other in zip(sides[False], sides[True]):
                        self.assertAlmostEqual(one, -other, places=3, msg=example + name)
        self.assertGreater(drawn, at_least(150))

    def test_names_lie_clear_of_arrows_and_of_each_other(self):
        labels = touched = turns = 0
        for example in some(EXAMPLES):
            named, pictures = self.draw(example)
            for picture in (pictures or {}).values():
                arcs = [circle_of(arrow) for arrow in picture.arrows if len(arrow.way) == 1]
                for k, (center, radius) in enumerate(arcs):
                    for other, own in arcs[:k]:  # moments at one point are drawn round each other
                        turns += abs(center - other) < 10
                        self.assertTrue(abs(center - other) >= 10 or abs(radius - own) > 6, example)
                for k, box in enumerate(picture.labels):
                    labels += 1
                    touched += any(meets(box, a, b) for arrow in picture.arrows
                                   for a, b in zip(arrow.points, arrow.points[1:]))
                    for other in picture.labels[:k]:
                        apart = (box[2] <= other[0] or other[2] <= box[0] or box[3] <= other[1] or other[3] <= box[1])
                        touched += not apart
                    self.assertTrue(0 <= box[0] and box[2] <= 560 and 0 <= box[1] and box[3] <= 440, example)
        self.assertGreater(labels, at_least(800))
        self.assertTrue(FEW or turns > 3, turns)
        self.assertEqual(touched, 0)

    def test_names_in_a_drawing_of_a_machine_of_pins_lie_on_nothing(self):
        """Neither on bars, pins, pedestals and hatching nor on one another: there is room beside these."""
        labels = 0
        for name in ("andrews", "chain", "change-point-four-bar", "chebyshev", "double-pendulum"):
            root = tree.fromstring(self.good("draw", os.path.join(ROOT, "examples", name + ".yaml")).out)
            strokes = [[(float(line.get("x" + end)), float(line.get("y" + end))) for end in "12"] for line in root.iter(SVG + "line")]
            for polygon in root.iter(SVG + "polygon"):
                corners = [tuple(map(float, pair.split(","))) for pair in polygon.get("points").split()]
                strokes += zip(corners, corners[1:] + corners[:1])
            rings = [tuple(float(circle.get(key)) for key in ("cx", "cy", "r")) for circle in root.iter(SVG + "circle")]
            strokes += [((x - r, y), (x + r, y)) for x, y, r in rings] + [((x, y - r), (x, y + r)) for x, y, r in rings]
            boxes = []
            for text in (text for group in root.iter(SVG + "g") if group.get("text-anchor") == "middle" for text in group.iter(SVG + "text")):
                x, y, half = float(text.get("x")), float(text.get("y")), 3.25 * len("".join(text.itertext()))
                boxes.append((x - half, y - 9, x + half, y + 1))
            for k, box in enumerate(boxes):
                self.assertFalse([stroke for stroke in strokes if meets(box, *stroke)], (name, box))
                for other in boxes[:k]:
                    self.assertTrue(box[2] <= other[0] or other[2] <= box[0] or box[3] <= other[1] or other[3] <= box[1], name)
            labels += len(boxes)
        self.assertGreater(labels, 40)

    def check_arrow(self, group, spots, what):
        """A force's head sits on its line, which is as long as all others; a couple's, on its arc of three quarters of a turn. Both
        act at a point that is marked: a force ends or begins 8 px off it, or 14 px beside that."""
        tip, *base = complexes(group.find(SVG + "polygon").get("points"))
        line, arc = group.find(SVG + "line"), group.find(SVG + "polyline")
        if line is not None:
            tail, end = (complex(float(line.get("x" + k)), float(line.get("y" + k))) for k in "12")
            along = (tip - tail) / abs(tip - tail)
            self.assertAlmostEqual(abs(tip - tail), 62, delta=0.02)
            self.assertAlmostEqual(abs(tip - 8 * along - end), 0, delta=0.02)  # the line ends within the head
            off = [min(abs(spot - foot - aside * 1j * along) for aside in (0, 14, -14) for foot in (tail - 8 * along, tip + 8 * along))
                   for spot in spots]
            self.assertLess(min(off), 0.05, what)
        else:
            turned = complexes(arc.get("points"))
            center, radius = circle_of(Arrow(group))
            self.assertLess(max(abs(abs(z - center) - radius) for z in turned + [tip]), 0.1, what)
            along = tip - turned[-1]
            along /= abs(along)
            steps = [((b - center) / (a - center)) for a, b in zip(turned, turned[1:])]
            angle = sum(math.atan2(step.imag, step.real) for step in steps)
            self.assertAlmostEqual(abs(angle), math.radians(250), delta=math.radians(5))
            self.assertGreater((along / (1j * (tip - center))).real * angle, 0, what)  # it goes on the way of its arc
            self.assertGreater(abs((along / (tip - center) * abs(tip - center)).imag), 0.9, what)
        self.assertAlmostEqual(abs(sum(base) / 2 - (tip - 10 * along)), 0, delta=1.5 if line is None else 0.02)
        self.assertAlmostEqual(abs(base[0] - base[1]), 7.2, delta=0.03)
        self.assertAlmostEqual(abs(base[0] - tip), abs(base[1] - tip), delta=0.03)

    @staticmethod
    def edges_of(element):
        if element.tag == SVG + "line":
            return [tuple(complex(float(element.get("x" + k)), float(element.get("y" + k))) for k in "12")]
        corners = complexes(element.get("points"))
        return list(zip(corners, corners[1:] + corners[:1]))

    def check_clear(self, group, spots, edges, others, what):
        """An arrow runs beside the body where it can: not through it if, on its line or beside it, a place is free of everything."""
        line, tip = group.find(SVG + "line"), complexes(group.find(SVG + "polygon").get("points"))[0]
        tail = complex(float(line.get("x1")), float(line.get("y1")))
        along = (tip - tail) / abs(tip - tail)
        leaves = group.find(SVG + "title").text.startswith("W_")

        def pressed(start, lines):
            """By how much it comes nearer to lines than 13 px, in the mean, off the end at its point."""
            ends = (start, start + 62 * along)
            near, far = ends if min(abs(ends[0] - spot) for spot in spots) < min(abs(ends[1] - spot) for spot in spots) else ends[::-1]
            samples = [near + (0.2 + 0.8 * k / 8) * (far - near) for k in range(1, 9)]
            return sum(max(0, 13 - distance(z, *each)) for z in samples for each in lines) + sum(max(0, 60 - z.imag, z.imag - 380) for z in samples)

        foot = min(((spot, aside) for spot in spots for aside in (0, 14, -14)),
                   key=lambda at: min(abs(at[0] + at[1] * 1j * along + start * along - tail) for start in (8, -70)))[0]
        free = [20 * (aside != 0) for aside in (0, 14, -14) for start in ((8,) if leaves else (8, -70))
                if pressed(foot + aside * 1j * along + start * along, edges + others) == 0]
        if free:
            self.assertLessEqual(pressed(tail, edges), min(free) + 4, (what, group.find(SVG + "title").text))
        return len(free) > 0

    def check_givers(self, picture, bodies, joints, what):
        """F_23 is what body 2 exerts on body 3: by each on the other, and with the other sign on the first."""
        own = int(picture.title.rsplit(" ", 1)[1])
        for group in picture.root.iter(SVG + "g"):
            title = group.find(SVG + "title")
            found = title is not None and re.match(r"(-?)[FNM]_(\d)(\d)(?:_\S+)?, by (.+) at \S+$", title.text)
            if found and len(bodies) <= 10:
                pair = [int(found.group(2)), int(found.group(3))]
                if not any(sorted(joint["bodies"]) == sorted(bodies[k] for k in pair) for joint in joints):
                    continue  # a mesh, whose sum for equal planets their carrier gives
                self.assertIn(own, pair, what)
                other = pair[0] if own == pair[1] else pair[1]
                self.assertEqual((found.group(4), found.group(1)), (bodies[other], "-" if own == pair[0] else ""), (what, title.text))
                self.given += 1

    def check_joints(self, shape, body, joints, what):
        """Each joint of a body is drawn on it: pins as circles, what slides as a box, its line as a rod or a slot."""
        own = [(joint["kind"], joint["bodies"].index(body)) for joint in joints if body in joint["bodies"]]
        drawn = [sum(1 for e in shape if e.get("fill") == "#ffffff"),
                 sum(1 for e in shape if e.tag == SVG + "polygon" and e.get("fill") == "#2b2d30"),
                 sum(1 for e in shape if e.tag == SVG + "polygon" and 0 < float(e.get("stroke-width")) <= 1.3),
                 sum(1 for e in shape if e.tag == SVG + "line" and 3 < float(e.get("stroke-width")) < 5),
                 sum(1 for e in shape if e.tag == SVG + "line" and e.get("stroke") == "#ffffff")]
        self.assertEqual(drawn, [sum(kind == "pin" or (kind, side) == ("pin-slot", 1) for kind, side in own),
                                 sum(kind == "weld" for kind, side in own), own.count(("slide", 1)),
                                 own.count(("slide", 0)), own.count(("pin-slot", 0))], what)

    def check_view(self, shape, marks, what):
        """The body and all places at which something acts are in the middle, as large as 230 by 170 px let them be."""
        places = list(marks)
        for element in shape:
            width, radius = float(element.get("stroke-width")), element.get("r")
            if element.tag == SVG + "line" and width < 8 or element.get("fill") == "none" and radius:
                return 0  # a rod, a wheel: how far they reach is not known here
            if element.tag == SVG + "line":
                places += [complex(float(element.get("x" + k)), float(element.get("y" + k))) for k in "12"]
            elif element.tag == SVG + "polygon":
                if width <= 1.3:
                    return 0  # a box, which slides: its couples act anywhere
                places += complexes(element.get("points"))
        if len(places) == 0:
            return 0
        low = complex(min(z.real for z in places), min(z.imag for z in places))
        high = complex(max(z.real for z in places), max(z.imag for z in places))
        self.assertAlmostEqual(abs((low + high) / 2 - (280 + 220j)), 0, delta=0.05, msg=what)
        if abs(high - low) > 1:
            self.assertAlmostEqual(max((high - low).real / 230, (high - low).imag / 170), 1, delta=1e-3, msg=what)
        return 1

    def test_arrows_and_marks_are_whole_and_named(self):
        """Every mark of a place has a name beside it, marks of centres are crossed, and powers are written as such."""
        powers = marks = over = viewed = cleared = self.given = 0
        for example in some(EXAMPLES):
            _, pictures = self.draw(example)
            checked = self.good("check", example, "--format", "json", "-q").json() if pictures and example in EXAMPLES[::3] else {"joints": []}
            for picture in (pictures or {}).values():
                root, what = picture.root, example + picture.title
                circles = [(complex(float(c.get("cx")), float(c.get("cy"))), c) for c in root.iter(SVG + "circle") if c.get("r") in ("3", "4.5")]
                circles = [(at, c) for at, c in circles if c.get("stroke") == "#fcfcfa" or c.get("fill") == "#fcfcfa"]
                names = [text for text in root.iter(SVG + "text") if text.get("fill") == "#1c1e21" and text.get("font-size") is None]
                self.assertEqual(len(names), len(circles), what)
                shape = list(root)[2:]
                shape = shape[:next(k for k, e in enumerate(shape) if e.get("stroke-width") == "1.2")]  # the axes begin
                thick = max([k for k, e in enumerate(shape) if float(e.get("stroke-width")) >= 3] + [-1])  # bars, rods and slots
                pins = [k for k, e in enumerate(shape) if e.get("fill") == "#ffffff"]
                self.assertTrue(all(k > thick for k in pins), what)  # nothing lies on a pin
                over += len(pins) > 0 and thick >= 0
                if checked["joints"] and ", body " in picture.title:
                    self.check_joints(shape, picture.title.split(", body ")[0], checked["joints"], what)
                    self.check_givers(picture, checked["bodies"], checked["joints"], what)
                viewed += self.check_view(shape, [at for at, _ in circles], what)
                marks += len(names)
                for text in names:
                    self.assertTrue("".join(text.itertext()).strip(), what)
                    left, top, right, bottom = label_box(text)
                    self.assertLess(min(max(0, left - z.real, z.real - right) + max(0, top - z.imag, z.imag - bottom) for z, _ in circles), 60, what)
                lines = [{complex(float(line.get("x" + k)), float(line.get("y" + k))) for k in "12"} for line in root.iter(SVG + "line")]
                for at, circle in circles:
                    if circle.get("r") == "4.5":
                        for arm in (4.5, 4.5j):
                            self.assertTrue(any(len(ends) == 2 and all(min(abs(z - at - arm), abs(z - at + arm)) < 0.02 for z in ends) for ends in lines))
                tips = [max(complexes(p.get("points")), key=lambda z: z.real - z.imag) for p in root.findall(SVG + "polygon") if p.get("fill") == "#55585c"]
                self.assertEqual([text.text for _, text in zip(tips, root.findall(SVG + "text"))], ["x", "y"])
                self.assertAlmostEqual(abs((tips[0] - tips[1]) - (30 + 30j)), 0, delta=0.02)  # each 30 px from one place
                for tip, text in zip(tips, root.findall(SVG + "text")):  # names of the axes, to the right of their tips
                    self.assertTrue(3 < float(text.get("x")) - tip.real < 10 and abs(float(text.get("y")) - tip.imag) < 8, what)
                edges = [line for e in shape if e.tag in (SVG + "line", SVG + "polygon") and float(e.get("stroke-width")) > 8 for line in self.edges_of(e)]
                whole = all(e.get("fill") == "#ffffff" or float(e.get("stroke-width")) > 8 for e in shape)  # nothing else is in the way
                groups = [group for group in root.iter(SVG + "g") if group.find(SVG + "title") is not None]
                for group in groups:
                    others = [line for other in groups if other is not group and other.find(SVG + "line") is not None for line in self.edges_of(other.find(SVG + "line"))]
                    if whole and edges and group.find(SVG + "line") is not None:
                        cleared += self.check_clear(group, [at for at, _ in circles], edges, others, what)
                    if picture.title.startswith("Junction"):  # unknown: for positive components
                        self.assertTrue(min(part * (-1 if group.find(SVG + "title").text[0] == "-" else 1) for part in Arrow(group).way) > 0.05, what)
                    self.check_arrow(group, [at for at, _ in circles], what)
                    name = group.find(SVG + "title").text.split(", ")[0]
                    self.assertNotRegex(name, r"\^[23](?!\d)", what)
                    powers += "\u00b2" in name
        self.assertGreater(marks, at_least(400))
        self.assertGreater(over, at_least(100))
        self.assertGreater(viewed, at_least(100))
        self.assertTrue(FEW or self.given > 40, self.given)
        self.assertTrue(FEW or cleared > 100, cleared)
        self.assertTrue(FEW or powers > 0)

    def test_a_known_force_points_as_it_does_and_an_unknown_one_up_and_right(self):
        _, pictures = self.draw(os.path.join(ROOT, "examples", "double-pendulum.yaml"))
        arrows = {arrow.name: arrow for arrow in pictures["link1, body 1"].arrows}
        self.assertEqual(arrows["Wlink1"].way, (0, -1))
        self.assertTrue(arrows["F01"].way[0] > 0.2 and arrows["F01"].way[1] > 0.2)
        self.assertTrue(arrows["-F12"].way[0] < -0.2 and arrows["-F12"].way[1] < -0.2)
        self.assertEqual((arrows["Mtheta1"].way, arrows["-Mtheta2"].way), ((1,), (-1,)))

    def test_all_files_or_none(self):
        example = os.path.join(ROOT, "examples", "toggle.yaml")
        folder = self.path("pictures")
        os.makedirs(os.path.join(folder, "3-link3.svg"))  # in the way of one of six
        with open(os.path.join(folder, "mine.txt"), "w", encoding="utf-8") as file:
            file.write("mine")
        run = Run("derive", example, "--what", "free-bodies", "--svg", folder)
        self.assertEqual((run.code, run.out), (2, ""))
        self.assertEqual(sorted(os.listdir(folder)), ["3-link3.svg", "mine.txt"])
        os.rmdir(os.path.join(folder, "3-link3.svg"))
        self.good("derive", example, "--what", "free-bodies", "--svg", folder)
        self.assertEqual(len(os.listdir(folder)), 7)
        self.good("derive", example, "--what", "free-bodies", "--svg", folder)  # again, over the old ones

    def test_places_that_cannot_be_written_are_named(self):
        example = os.path.join(ROOT, "examples", "toggle.yaml")
        for folder in (self.path("none/such"), self.four_bar):
            run = Run("derive", example, "--svg", folder)
            self.assertEqual((run.code, run.out), (2, ""))
            self.assertIn("[E07", run.err)

    def test_the_same_pose_is_the_same_bytes_and_another_pose_is_not(self):
        example = os.path.join(ROOT, "examples", "slider-crank.yaml")
        for name, at in (("a", "60deg"), ("b", "60deg"), ("c", "20deg")):
            self.good("derive", example, "--svg", self.path(name), "--at", "theta=" + at)
        self.assertEqual(self.read("a/2-rod.svg"), self.read("b/2-rod.svg"))
        self.assertNotEqual(self.read("a/2-rod.svg"), self.read("c/2-rod.svg"))

    def test_gears_push_as_they_do_in_the_report(self):
        example = os.path.join(ROOT, "examples", "geared-five-bar.yaml")
        page = self.good("report", example).out
        self.good("derive", example, "--svg", self.path("pictures"))
        for name in os.listdir(self.path("pictures")):
            arrows = re.findall(r"<(?:line|polygon) [^>]*>", self.read("pictures/" + name).decode())
            self.assertGreater(len(arrows), 0)
            for arrow in arrows:
                self.assertIn(arrow, page, name)

    def test_a_warning_of_the_pose_is_given_once(self):
        for name in ("doubled-guide", "ferguson"):
            example = os.path.join(ROOT, "examples", name + ".yaml")
            run = self.good("derive", example, "--svg", self.path(name), "--numbers")
            self.assertEqual(run.err.count("[W0605]"), 1, run.err)

    def test_a_pose_without_forces_has_pictures_and_no_values(self):
        lost = self.write("lost.yaml", LOST)
        self.assertEqual(self.good("derive", lost, "--svg", self.path("a")).err, "")
        self.assertEqual(os.listdir(self.path("a")), ["1-rod.svg"])
        run = Run("derive", lost, "--svg", self.path("b"), "--numbers")
        self.assertEqual((run.code, run.out, run.err.count("[E0606]")), (1, "", 1), run.err)

    def test_the_pictures_of_the_readme_are_what_the_command_draws(self):
        script = os.path.join(ROOT, "tools", "draw-pictures")
        subprocess.run(["sh", script, os.path.abspath(os.environ["YOKE"]), self.path("")], check=True, stdin=subprocess.DEVNULL)
        with open(os.path.join(ROOT, "docs", "pictures", "jansen-leg.svg"), "rb") as kept:
            self.assertEqual(self.read("jansen-leg.svg"), kept.read())
        self.assertEqual(self.read("jansen-leg.svg").count(b"@keyframes"), 7)  # every body that moves, and no script
        self.assertNotIn(b"<script", self.read("jansen-leg.svg"))
        # The plot is gnuplot's own drawing, which changes with its versions; of ours are the curves and their names.
        with open(os.path.join(ROOT, "docs", "pictures", "jansen-foot.svg"), encoding="utf-8") as kept:
            words = re.findall(r"<text[^>]*>(.*?)</text>", kept.read(), re.S)
        self.assertEqual(re.findall(r"<text[^>]*>(.*?)</text>", self.read("jansen-foot.svg").decode(), re.S), words)


if __name__ == "__main__":
    unittest.main()
