"""Reports and movies: valid pages that need nothing else, for every example; the drawing's motion; what is refused."""
import html.parser
import json
import math
import os
import re
import shutil
import subprocess
import unittest

from harness import Case, ROOT, Run, YOKE, some

EXAMPLES = os.path.join(ROOT, "examples")
VOID = {"meta", "input", "img", "br", "link", "hr"}
# What a parser would end by itself must still be ended here: every element is closed in order.
FLOW_IN_P = {"p", "div", "table", "ul", "ol", "section", "figure", "h1", "h2", "h3", "h4"}


class Strict(html.parser.HTMLParser):
    """Checks that elements nest, ids are unique and resolve, pictures have words, and nothing comes from outside."""

    def __init__(self):
        super().__init__()
        self.open, self.ids, self.used, self.faults, self.headings = [], set(), set(), [], []

    def handle_starttag(self, tag, attributes):
        values = dict(attributes)
        if len(values) != len(attributes):
            self.faults.append("%s has an attribute twice" % tag)
        if tag in FLOW_IN_P and "p" in self.open:
            self.faults.append("%s inside p" % tag)
        self.look(tag, values)
        if tag not in VOID:
            self.open.append(tag)

    def handle_startendtag(self, tag, attributes):
        self.look(tag, dict(attributes))

    def look(self, tag, values):
        if "id" in values:
            if values["id"] in self.ids:
                self.faults.append("id %s twice" % values["id"])
            self.ids.add(values["id"])
        for key in ("aria-labelledby", "for", "aria-controls"):
            self.used |= set(values.get(key, "").split())
        for key in ("href", "src", "xlink:href", "action", "data", "srcset"):
            target = values.get(key)
            if target and target.startswith("#"):
                self.used.add(target[1:])
            elif target and not target.startswith("data:"):
                self.faults.append("%s %s points outside" % (key, target))
        if tag == "img" and not values.get("alt"):
            self.faults.append("img without alt")
        if values.get("role") in ("img", "region") and not values.get("aria-label"):
            self.faults.append("%s without a label" % values["role"])
        if re.fullmatch("h[1-6]", tag):
            self.headings.append(int(tag[1]))
        if tag in ("iframe", "object", "embed", "base"):
            self.faults.append("%s is not for this page" % tag)

    def handle_endtag(self, tag):
        if not self.open or self.open[-1] != tag:
            self.faults.append("</%s> inside %s" % (tag, self.open[-3:]))
        if tag in self.open:
            while self.open.pop() != tag:
                pass


def faults(page):
    parser = Strict()
    parser.feed(page)
    parser.close()
    found = parser.faults + ["%s left open" % tag for tag in parser.open]
    found += ["no id %s" % name for name in parser.used - parser.ids]
    found += ["%d headings of the first level" % parser.headings.count(1)] if parser.headings.count(1) != 1 else []
    found += ["h%d after h%d" % (b, a) for a, b in zip(parser.headings, parser.headings[1:]) if b > a + 1]
    style = "".join(re.findall(r"<style>(.*?)</style>", page, re.S))
    found += ["the style points outside"] if re.search(r"@import|url\((?!data:)", style) else []
    return found


def data_of(page):
    """The numbers for the script; None where the page has none."""
    found = re.search(r'<script type="application/json" id="data">(.*?)</script>', page, re.S)
    return json.loads(found.group(1), parse_constant=lambda word: 1 / 0) if found else None


def text_of(page):
    return html.unescape(re.sub(r"<[^>]*>", "", page))


class Checker(unittest.TestCase):
    def test_it_sees_faults(self):
        good = '<html><body><h1>A</h1><p id="a">b</p><a href="#a">c</a></body></html>'
        self.assertEqual(faults(good), [])
        for old, new in (("</p>", ""), ('id="a"', ""), ("<p ", '<p id="a"></p><p '), ('"#a"', '"http://b"'), ("h1", "h2"),
                         ("<p ", '<img src="data:,"><p '), ("<p ", '<style>a{b:url(c)}</style><p '), ("b</p>", "<div></div></p>")):
            self.assertNotEqual(faults(good.replace(old, new)), [], new)


class Examples(Case):
    def test_every_example_has_a_valid_report(self):
        for name in some(sorted(os.listdir(EXAMPLES))):
            if not name.endswith(".yaml"):
                continue
            with self.subTest(name):
                run = Run("report", os.path.join(EXAMPLES, name))
                self.assertEqual(run.code, 0, run.err)
                self.assertEqual(faults(run.out), [])
                self.assertNotIn("nan", re.sub("[a-z]*nan[a-z]+|[a-z]+nan", "", text_of(run.out).lower()))
                for formula in re.findall(r"<math.*?</math>", run.out, re.S)[::20]:
                    self.assertNotIn("<mi></mi>", formula)

    def test_the_quick_returns_page_is_small(self):
        page = Run("report", os.path.join(EXAMPLES, "quick-return.yaml")).out
        self.assertLess(len(page.encode()), 600 * 1024)
        self.assertEqual(page, Run("report", os.path.join(EXAMPLES, "quick-return.yaml")).out) # the same every time


class Report(Case):
    def test_the_sections_are_there_and_in_the_contents(self):
        page = self.good("report", self.four_bar).out
        for name in ("findings", "motion", "diagrams", "parameters", "topology", "equations", "method"):
            self.assertIn('<section id="%s"' % name, page)
            self.assertIn('<a href="#%s"' % name, page)
        self.assertNotIn('<section id="gears"', page)
        self.assertIn("crank-rocker (Grashof)", page)
        self.assertIn("After the last equals sign: the value at the start.", page)

    def test_values_of_the_page_are_those_of_solve(self):
        data = data_of(self.good("report", self.four_bar, "--steps", "24").out)
        if data is None:
            self.skipTest("built without the script")
        columns = {column["name"]: column["values"] for column in data["columns"]}
        for row in (0, 5, 17):
            angle = data["axis"]["values"][row]
            answer = self.good("solve", self.four_bar, "--at", "theta1=%r" % angle, "--format", "json").json()
            for name, motion in answer["configurations"][0]["coordinates"].items():
                turn = math.degrees(motion["position"]) - columns[name][row]
                self.assertLess(abs(math.remainder(turn, 360)), 1e-4)
                self.assertAlmostEqual(math.degrees(motion["velocity"]), columns[name + ".rate"][row], delta=1e-4)

    def test_where_bodies_are_drawn_is_where_they_are(self):
        data = data_of(self.good("report", self.four_bar, "--steps", "24").out)
        if data is None:
            self.skipTest("built without the script")
        crank, rocker = data["bodies"][1], data["bodies"][3]
        self.assertEqual([len(data[key]) for key in ("bodies", "middles", "joints")], [4, 4, 4])
        for row in range(25): # the drawing turns clockwise where the machine turns counter-clockwise
            turned = -(crank["turn"][row] - crank["turn"][0])
            self.assertAlmostEqual(turned, data["axis"]["values"][row] - data["axis"]["values"][0], delta=1e-3)
            self.assertEqual([rocker["x"][row], rocker["y"][row]], [0, 0]) # pinned at its origin

    def test_a_name_cannot_break_the_page(self):
        model = self.read("four-bar.yaml").decode().replace("Test four-bar", "'</script><b id=x>&amp; \"quoted\"'")
        page = self.good("report", self.write("odd.yaml", model)).out
        self.assertEqual(faults(page), [])
        self.assertIn("&lt;/script&gt;", page)

    def test_a_machine_that_does_not_go_together_has_a_report(self):
        run = Run("report", self.rocker, "--at", "theta1=180deg", "--assembly", "nearest")
        self.assertEqual(run.code, 1)
        self.assertIn("[E0601]", run.err)
        self.assertEqual(faults(run.out), [])
        self.assertIn("cannot be assembled", run.out)
        self.assertIn('<section id="topology"', run.out)
        self.assertNotIn("After the last equals sign", run.out)

    @unittest.skipUnless(shutil.which("gnuplot"), "needs gnuplot")
    def test_a_plain_page_has_pictures_and_no_script(self):
        page = self.good("report", self.four_bar, "--plain").out
        built_without = data_of(self.good("report", self.four_bar).out) is None
        self.assertEqual("built without Node" in page, built_without)
        self.assertEqual(faults(page), [])
        self.assertNotIn("<script", page)
        self.assertGreaterEqual(page.count("data:image/svg+xml;base64,"), 3)

    def test_a_plain_page_without_gnuplot_says_so(self):
        run = Run("report", self.four_bar, "--plain", env={"PATH": self.folder})
        self.assertEqual(run.code, 0)
        self.assertIn("gnuplot", run.out)
        self.assertEqual(faults(run.out), [])

    def test_what_to_show_can_be_said(self):
        data = data_of(self.good("report", self.four_bar, "--over", "theta1=10:50deg", "--steps", "8").out)
        if data is None:
            self.skipTest("built without the script")
        self.assertAlmostEqual(data["axis"]["values"][0], 10, 6)
        self.assertAlmostEqual(data["axis"]["values"][8], 50, 6)
        data = data_of(self.good("report", self.four_bar, "--trace", "rocker.B").out)
        self.assertEqual([point["name"] for point in data["points"] if point["shown"]], ["rocker.B"])
        pendulum = os.path.join(EXAMPLES, "pendulum.yaml")
        data = data_of(self.good("report", pendulum, "--to", "0.5s").out)
        self.assertAlmostEqual(data["axis"]["values"][-1], 0.5, 9)

    def test_an_engaged_lock_is_no_mesh(self):
        gearbox = os.path.join(EXAMPLES, "gearbox-8hp70.yaml")
        page = self.good("report", gearbox, "--lock", "first", "-q").out
        self.assertEqual(faults(page), [])
        self.assertIn("is 108/23 = 4.69565", page)
        gears = page[page.index('<section id="gears"'):]
        self.assertNotIn("open belt", gears[:gears.index("</section>")])
        self.assertIn("Ratios, one for each set of locks", self.good("report", gearbox, "-q").out)

    def test_wrong_requests_are_refused(self):
        self.wrong(806, "report", self.four_bar, "--format", "docx")
        self.wrong(806, "report", self.four_bar, "--to", "-1s")
        self.wrong(815, "report", self.four_bar, "--trace", "coupler.Q")
        self.wrong(806, "report", self.four_bar, "--steps", "0")

    def test_pdf_without_a_browser_says_what_to_do(self):
        run = self.wrong(710, "report", self.four_bar, "-o", self.path("page.pdf"), env={"PATH": self.folder})
        self.assertIn(".html", run.err)
        self.assertFalse(os.path.exists(self.path("page.pdf")))

    @unittest.skipUnless(shutil.which("chromium"), "needs chromium")
    def test_pdf_is_printed(self):
        self.good("report", self.four_bar, "-o", self.path("page.pdf"))
        self.assertTrue(self.read("page.pdf").startswith(b"%PDF"))
        left = [name for name in os.listdir(self.folder) if name.startswith("yoke.")]
        self.assertEqual(left, [])


class Animate(Case):
    def fake(self, name, script):
        folder = self.path("bin")
        os.makedirs(folder, exist_ok=True)
        with open(os.path.join(folder, name), "w", encoding="utf-8") as file:
            file.write("#!/bin/sh\n" + script)
        os.chmod(os.path.join(folder, name), 0o755)
        return {"PATH": folder + ":/usr/bin:/bin"}

    def test_svg_moves_by_itself(self):
        self.good("draw", self.four_bar, "--animate", self.path("a.svg"))
        svg = self.read("a.svg").decode()
        self.assertNotIn("<script", svg)
        crank = re.search(r"@keyframes b1 \{(.*?)\}\n", svg, re.S).group(1)
        turns = [float(turn) for turn in re.findall(r"rotate\(([-0-9.]+)deg\)", crank)]
        self.assertAlmostEqual(abs(turns[-1] - turns[0]), 360, delta=0.02)
        self.assertTrue(all(b < a for a, b in zip(turns, turns[1:]))) # counter-clockwise, no jump
        self.assertIn("prefers-reduced-motion", svg)

    def test_a_range_goes_to_and_fro(self):
        self.good("draw", self.rocker, "--animate", self.path("a.svg"))
        self.assertIn("alternate", self.read("a.svg").decode())

    @unittest.skipUnless(shutil.which("rsvg-convert"), "needs rsvg-convert")
    def test_movies_are_made_of_pictures(self):
        # a stand-in for ffmpeg counts the pictures that it is given
        path = self.fake("ffmpeg", 'cat >"%s"\nfor last; do :; done\necho movie >"${last#file:}"\n' % self.path("pictures"))
        for ending in ("gif", "mp4", "webm"):
            self.good("draw", self.four_bar, "--over", "theta1=0:20deg", "--steps", "6", "--animate", self.path("a." + ending),
                      env=path)
            self.assertEqual(self.read("a." + ending), b"movie\n")
        pictures = self.read("pictures").split(b"\x89PNG")[1:]
        self.assertEqual(len(pictures), 7 + 5) # to and fro, both ends once
        self.assertEqual(len(set(pictures)), 7)
        self.assertEqual(pictures[7:], pictures[5:0:-1])

    def test_what_is_missing_is_told_and_nothing_is_left(self):
        run = self.wrong(710, "draw", self.four_bar, "--animate", self.path("a.gif"), env={"PATH": self.folder})
        self.assertIn(".svg", run.err)
        self.assertFalse(os.path.exists(self.path("a.gif")))

    @unittest.skipUnless(shutil.which("rsvg-convert"), "needs rsvg-convert")
    def test_a_failing_program_leaves_nothing(self):
        path = self.fake("ffmpeg", "echo no codec >&2\nexit 1\n")
        run = self.wrong(711, "draw", self.four_bar, "--steps", "2", "--animate", self.path("a.mp4"), env=path)
        self.assertIn("no codec", run.err)
        self.assertFalse(os.path.exists(self.path("a.mp4")))

    def test_wrong_requests_are_refused(self):
        self.wrong(706, "draw", self.four_bar, "--animate", self.path("a.avi"))
        self.wrong(818, "draw", self.four_bar, "--to", "3s")
        self.wrong(806, "draw", self.four_bar, "--animate", self.path("a.svg"), "-o", self.path("b.svg"))
        self.assertEqual(Run("draw", self.rocker, "--at", "theta1=180deg", "--animate", self.path("a.svg")).code, 1)


if __name__ == "__main__":
    unittest.main()
