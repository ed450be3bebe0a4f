"""yoke report: the equations of its page hold with the numbers of `solve`, and the values beside them are theirs.

Every formula is read from the page's MathML and worked out here: with coordinates, rates, reactions and efforts of `solve`,
and parameters of the page's own table. Free bodies are in balance as they are printed. The pictures of them show points
where they are, and arrows that act there. Without YOKE_FULL every third example is read."""
import glob
import math
import os
import re
import unittest

import mathml
from harness import ROOT, Case, Run, third
from page import Reader, size_of

FULL = "YOKE_FULL" in os.environ
EXAMPLES = sorted(glob.glob(os.path.join(ROOT, "examples", "*.yaml")))
SHOWN = 6e-6  # of a number with six digits
NUMBER = mathml.Number


def symbols_of(page, check, pose):
    """What the formulas' names stand for, by the other verbs."""
    symbols = {"pi": NUMBER(math.pi), "t": NUMBER(0)}
    for row in page.table("Parameters"):
        if isinstance(row["value"], float):
            value = row["value"] * (size_of(row["unit"]) if row["unit"] not in ("", "1") else 1)
            symbols[row["parameter"].replace("_", "")] = NUMBER(value, 1e-7 * abs(value))
    for group, keys in (("bodies", ("angle", "rate", "acceleration")), ("coordinates", ("position", "velocity", "acceleration"))):
        for name, motion in pose[group].items():
            for dots, key in enumerate(keys):
                if motion[key] is not None:
                    value = motion[key]
                    full = (name + (".angle" if group == "bodies" else "")).replace("_", "") + "'" * dots
                    symbols[full] = NUMBER(value, 1e-11 * abs(value) + 1e-12 * 10 ** (3 * dots))
    for name, effort in pose.get("efforts", {}).items():
        if isinstance(effort, float):
            symbols["tau" + name] = NUMBER(effort, 1e-9 * abs(effort))
    for row in page.table("Masses"):
        for letter, key in (("m", "mass"), ("I", "inertia")):
            symbols.setdefault((letter + row["body"]).replace("_", ""), NUMBER(row[key], 1e-7 * row[key]))
    for caption in page.tables:  # laws are functions
        law = re.match(r"The cam \S+: law (\S+),", caption)
        if law:
            symbols[law.group(1)] = None
    number = {name: k for k, name in enumerate(check["bodies"])}
    kinds = {joint["name"]: joint["kind"] for joint in check["joints"]}
    pairs = [tuple(sorted(joint["bodies"])) for joint in check["joints"]]
    largest = max([math.hypot(*r["force"]) for r in pose.get("reactions", {}).values()] + [0])
    for joint, reaction in pose.get("reactions", {}).items():
        by, on = reaction["by"], reaction["on"]
        if kinds[joint] != "pin" or pairs.count(tuple(sorted((by, on)))) != 1:
            continue
        way = 1 if number[by] < number[on] else -1
        names = ["F%s%d%s" % (min(number[by], number[on]), max(number[by], number[on]), axis) for axis in "xy"]
        if max(number[by], number[on]) > 9:
            names = ["F%d,%d%s" % (min(number[by], number[on]), max(number[by], number[on]), axis) for axis in "xy"]
        for name, force in zip(names, reaction["force"]):
            symbols[name] = NUMBER(way * force, 1e-9 * abs(force) + 1e-11 * largest)
    return symbols


def shown(tokens):
    """A printed number; None where a side is none."""
    words = [what for _, what in tokens if what != ""]
    if len(words) == 2 and words[0] == "-" and isinstance(words[1], float):
        return -words[1]
    return words[0] if len(words) == 1 and isinstance(words[0], float) else None


class Equations(Case):
    def setUp(self):
        super().setUp()
        self.compared = self.balanced = self.pictured = 0

    def value(self, tokens, symbols):
        number = shown(tokens)
        if number is not None:
            return NUMBER(number, SHOWN * abs(number))
        try:
            return mathml.Reader(tokens, symbols).value()
        except (mathml.Unknown, OverflowError, ZeroDivisionError, ValueError):
            return None

    def compare(self, sides, symbols, noise, what):
        """All sides are one number; a name that nothing has told yet is told by what is printed for it."""
        names = [side[0][1] if len(side) == 1 and side[0][0] == "name" and side[0][1] not in symbols else None for side in sides]
        last = shown(sides[-1])
        for name in names:
            if name and last is not None:
                symbols[name] = NUMBER(last, SHOWN * abs(last) + noise)
                names = [None if n == name else n for n in names]
        values = [self.value(side, symbols) for side in sides]
        known = [v for v in values if v is not None]
        for a, b in zip(known, known[1:]):
            self.assertLessEqual(abs(a.value - b.value), a.error + b.error + noise, what)
            self.compared += 1

    def check_formula(self, text, symbols, noise, what):
        sides = mathml.formula(text)
        tables = [mathml.only_matrix(side) for side in sides]
        if not any(tables):
            if len(sides) > 1:
                self.compare(sides, symbols, noise, what)
            return
        tables = [table for table in tables if table]
        for entries in zip(*(row for table in [tables[0]] for row in [sum(table, [])]),
                           *(sum(table, []) for table in tables[1:])):
            if len(entries) > 1:
                self.compare(list(entries), symbols, noise, what)

    def check_balance(self, section, what):
        """The forces on a body and its inertia, as they are printed, cancel."""
        balanced = 0
        for body in re.split(r"<h4>", section)[1:]:
            forces = []
            for text in re.findall(r"<math.*?</math>", body, re.S):
                sides = mathml.formula(text)
                table = mathml.only_matrix(sides[-1])
                if table:
                    forces.append([shown(cell) for cell in sum(table, [])])
                elif any(mathml.only_matrix(side) for side in sides) or ("sign", "[") in sides[-1]:
                    forces.append(None)
            if len(forces) < 2 or any(f is None or len(f) != 2 or None in f for f in forces):
                continue
            for axis in (0, 1):
                terms = [force[axis] for force in forces]
                self.assertLessEqual(abs(sum(terms)), SHOWN * sum(map(abs, terms)) + 1e-9, (what, body[:40]))
            balanced += any(force != [0, 0] for force in forces)
        return balanced

    # --- pictures ----------------------------------------------------------------------------------------------------

    def check_picture(self, svg, pose, vectors, what):
        """Points of the body to one scale, upright; arrows along the vectors that are printed; couples by their signs."""
        body = re.search(r'aria-label="Free body: (.*), body \d+ with', svg)
        if not body:
            return 0  # a pin without mass
        spots = [complex(float(x), float(y)) for x, y in re.findall(r'<circle cx="([-\d.]+)" cy="([-\d.]+)" r="3" ', svg)]
        places, found = {}, 0
        for name, words, drawn in re.findall(r"<g>\s*<title>([^,<]*(?:,\d+)?), ([^<]*)</title>(.*?)</g>", svg, re.S):
            head = complex(*map(float, re.search(r'<polygon points="([-\d.]+),([-\d.]+)', drawn).groups()))
            if "<polyline" in drawn:
                turn = [complex(*map(float, p.split(","))) for p in re.search(r'<polyline points="([^"]*)"', drawn).group(1).split()]
                around = ((turn[1] - turn[0]).conjugate() * (turn[2] - turn[1])).imag
                self.assertEqual(around > 0, name.startswith("-"), (what, name))  # y points down
                found += 1
                continue
            tail = complex(*map(float, re.search(r'<line x1="([-\d.]+)" y1="([-\d.]+)"', drawn).groups()))
            along = (head - tail).conjugate()
            at = [spot for spot in spots if min(abs(abs(spot - end) - 8) for end in (tail, head)) < 0.1 and
                  abs(((spot - tail).conjugate() * (head - tail)).imag) < 0.2 * abs(head - tail)]
            point = re.search(r" at (?:\S+\.)?(\S+)$", words)
            if at and point and "%s.%s" % (body.group(1), point.group(1)) in pose["points"]:
                places.setdefault(point.group(1), set()).update(at)
            vector = vectors.get((body.group(1), name.replace("_", "")))
            if vector and not (words.startswith("by ") and "F_" in name) and words != "inertia":
                self.assertLess(abs((vector.conjugate() * along).imag), 2e-3 * abs(vector) * abs(along), (what, name))
                found += 1
        points = [(at.copy().pop(), complex(*pose["points"]["%s.%s" % (body.group(1), point)]["position"]).conjugate())
                  for point, at in places.items() if len(at) == 1]
        for (p, a), (q, b) in zip(points, points[1:]):
            if abs(a - b) > 0:
                scale = (q - p) / (b - a)
                self.assertLess(abs(scale.imag) * abs(b - a), 0.05, (what, places))
                self.assertGreater(scale.real, 0, (what, places))
                found += 1
        return found

    def vectors_of(self, section):
        """What is printed for every force on every body."""
        vectors = {}
        for body in re.split(r"<h4>", section)[1:]:
            title = re.match(r"(.*), body \d+<", body)
            for text in re.findall(r"<math.*?</math>", body, re.S):
                table = mathml.only_matrix(mathml.formula(text)[-1])
                flat = [shown(cell) for cell in sum(table, [])] if table else []
                if title and len(flat) == 2 and None not in flat and flat != [0, 0]:
                    name = re.sub(r"<[^>]*>", "", text.split("<mo>=</mo>")[0]).strip()
                    key = (title.group(1), name)
                    vectors[key] = None if key in vectors else complex(*flat)
        return vectors

    # --- all of it ---------------------------------------------------------------------------------------------------

    def check_page(self, text, path):
        page, name = Reader(text), os.path.basename(path)
        check = Run("check", path, "--format", "json", "-q").json()
        answer = Run("solve", path, "--format", "json", "-q").json()
        pose = answer["configurations"][0]
        begin = text.index('id="equations"')
        section = text[begin:text.index("</section>", begin)]
        symbols = symbols_of(page, check, pose)
        for formula in re.findall(r"<math.*?</math>", section, re.S):
            self.check_formula(formula, symbols, 1e-9, (name, re.sub("<[^>]*>", " ", formula)[:300]))
        bodies = re.search(r'aria-label="Free bodies">(.*?)</div>', section, re.S)
        if bodies:
            self.balanced += self.check_balance(bodies.group(1), name)
            vectors = self.vectors_of(bodies.group(1))
            for svg in re.findall(r'<svg role="img" aria-label="Free body.*?</svg>', section, re.S):
                self.pictured += self.check_picture(svg, pose, vectors, name)

    def test_every_formula_holds_at_the_start(self):
        for path in EXAMPLES if FULL else third(EXAMPLES, 1):
            with self.subTest(os.path.basename(path)):
                self.check_page(Run("report", path, "-q").out, path)
        compared, balanced, pictured = (9000, 70, 430) if FULL else (3000, 15, 130)
        self.assertGreater(self.compared, compared)  # nothing was left out by a change of words
        self.assertGreater(self.balanced, balanced)
        self.assertGreater(self.pictured, pictured)

    def test_a_wrong_number_is_seen(self):
        """Every fifth printed number a thousandth off, one at a time."""
        path = os.path.join(ROOT, "examples", "steam-engine.yaml")
        text = Run("report", path, "-q").out
        begin = text.index('id="equations"')
        numbers = [m for m in re.finditer(r"<mo>=</mo><mrow>(?:<mo>-</mo>)?<mn>([\d.e+-]+)</mn></mrow></mrow></math>", text) if
                   m.start() > begin and float(m.group(1)) != 0]
        seen = 0
        for match in numbers[::5]:
            wrong = text[:match.start(1)] + "%.6g" % (1.001 * float(match.group(1))) + text[match.end(1):]
            try:
                self.check_page(wrong, path)
            except AssertionError:
                seen += 1
        self.assertGreater(len(numbers), 15)
        self.assertEqual(seen, len(numbers[::5]))


if __name__ == "__main__":
    unittest.main()
