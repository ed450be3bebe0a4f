"""yoke report: the sentences of its findings, checked by going there.

Ends of ranges close and nothing beyond them does; change points bring two configurations together; coordinates turn round
where it is said, and time ratios are those of the angles; Grashof's sums are of lengths measured at the start; works sum up
to the change of energy; speeds of gears are those of the linkage's own solution; motion programs of cams are differences of
where the follower stands; residuals are what points are apart. Without YOKE_FULL every third example is read."""
import glob
import html
import math
import os
import re
import unittest
from collections import Counter

from harness import ROOT, Case, Run, third
from page import AMOUNT, NUMBER, Reader, amount, data_of, size_of

FULL = "YOKE_FULL" in os.environ
EXAMPLES = sorted(glob.glob(os.path.join(ROOT, "examples", "*.yaml")))
SAMPLE = third(EXAMPLES, 2) + [os.path.join(ROOT, "examples", name + ".yaml") for name in ("valve-cam", "change-point-four-bar", "excavator")]
TURN = 2 * math.pi
LEAST = {  # of each kind that is checked: on all examples, on a third of them
    "four-bar": (29, 5), "turn": (41, 8), "range": (9, 1), "change point": (6, 1), "turning": (100, 20), "ratio": (37, 8),
    "energy": (20, 4), "work of a turn": (7, 1),
    "closed": (600, 100), "balances": (31, 5), "steps": (21, 4), "happenings": (5, 1), "speed": (13, 0),
    "cam": (100, 25), "cam's acceleration": (90, 20), "pressure angle": (20, 20), "end": (1, 1), "rest": (1, 1)}


def configurations(path, *words):
    """All that `solve` tells; [] where the machine does not come there."""
    run = Run("solve", path, *words, "--format", "json", "-q")
    return run.json()["configurations"] if run.code == 0 else []


class Findings(Case):
    def setUp(self):
        super().setUp()
        self.count = Counter()

    def at(self, axis, value):
        return ("--time", "%rs" % value) if axis == "t" else ("--at", "%s=%r%s" % (axis, value, self.unit[axis]))

    def coordinate(self, path, axis, value, name):
        poses = configurations(path, *self.at(axis, value))
        self.assertTrue(poses, (path, axis, value))
        return poses[0]["coordinates"][name]["position"]

    # --- structure ---------------------------------------------------------------------------------------------------

    def joint_places(self, check, pose, first, second):
        """Where a joint between two bodies can be: points of both that stand in one place; its own name's first."""
        def places(body):
            return {name.split(".", 1)[1]: at["position"] for name, at in pose["points"].items() if name.split(".", 1)[0] == body}
        mine, other = places(first), places(second)
        size = max([abs(x) for p in pose["points"].values() for x in p["position"]] + [1e-6])
        names = [j["name"] for j in check["joints"] if sorted(j["bodies"]) == sorted((first, second)) and j["kind"] == "pin"]
        named = [mine[name] for name in names if name in mine] + [other[name] for name in names if name in other]
        return named[:1] or [p for p in mine.values() if any(math.dist(p, q) < 1e-9 * size for q in other.values())]

    def check_four_bar(self, text, check, pose):
        match = re.match(r"The bodies (\S+), (\S+), (\S+) and (\S+) are a four-bar, (.*) on the frame (\S+): shortest and longest link "
                         r"are together %s, the other two %s\." % (AMOUNT, AMOUNT), text)
        if not match:
            return
        bodies = match.groups()[:4]
        self.assertEqual(match.group(6), bodies[0])
        corners = [self.joint_places(check, pose, bodies[k - 1], bodies[k]) for k in range(4)]  # before body k
        if any(len(corner) != 1 for corner in corners):
            return
        links = [math.dist(corners[k][0], corners[(k + 1) % 4][0]) for k in range(4)]
        low, second, third, high = sorted(links)
        self.assertAlmostEqual(amount(match, 7), low + high, delta=6e-5 * (low + high), msg=text)
        self.assertAlmostEqual(amount(match, 9), second + third, delta=6e-5 * (second + third), msg=text)
        off = low + high - second - third
        kinds = ("drag link (Grashof double crank)", "crank-rocker (Grashof)", "double rocker (Grashof)", "rocker-crank (Grashof)")
        kind = "change-point four-bar" if abs(off) < 1e-9 * high else "triple rocker (non-Grashof)" if off > 0 else \
            kinds[links.index(low)]
        self.assertEqual(match.group(5), kind, text)
        self.count["four-bar"] += 1

    # --- ranges and events -------------------------------------------------------------------------------------------

    def check_range(self, text, path):
        match = re.match(r"(\S+) goes from %s to %s and no further" % (AMOUNT, AMOUNT), text)
        if match:
            name, ends, unit = match.group(1), (float(match.group(2)), float(match.group(4))), match.group(3).strip()
            self.unit[name] = unit
            hair = 1.2e-4 * max(map(abs, ends))
            for end, out in zip(ends, (-1, 1)):
                self.assertTrue(configurations(path, *self.at(name, end - out * hair)), text)
                self.assertFalse(configurations(path, *self.at(name, end + out * hair)), text)
            self.count["range"] += 1
        match = re.match(r"(\S+) can turn all the way round", text)
        if match:
            for way in (1, -1):
                start = configurations(path)[0]["coordinates"][match.group(1)]["position"]
                run = Run("sweep", path, "--over", "%s=%r:%rrad" % (match.group(1), start, start + way * TURN), "--steps", "12",
                          "--format", "json", "-q")
                self.assertEqual(len(run.json()["rows"]), 13, text)
                self.assertNotIn("limit", [event["kind"] for event in run.json()["events"]], text)
            self.count["turn"] += 1

    def apart(self, path, axis, value, joint):
        """How far two configurations that differ at a joint alone are from each other."""
        run = Run("solve", path, *self.at(axis, value), "--all", "--format", "json", "-q")
        poses = {pose["label"]: pose["coordinates"] for pose in run.json()["configurations"]}
        off = [max(abs(math.remainder(a[n]["position"] - poses[other][n]["position"], TURN)) for n in a) for label, a in
               poses.items() for other in [label.replace(joint + "+", joint + "-")] if other != label and other in poses]
        return min(off) if off else None

    def check_event(self, text, path, check):
        match = re.search(r"There is a change point at (\S+) = %s, where joint (\S+) can" % AMOUNT, text)
        if match and match.group(1) != "t" and not check["degrees"]["redundant"]:  # else one of the two does not close
            self.unit[match.group(1)] = match.group(3).strip()
            beside = [self.apart(path, match.group(1), float(match.group(2)) + off, match.group(4)) for off in (0.05, 5)]
            self.assertIsNotNone(beside[0], text)
            self.assertLess(beside[0], 0.05 * beside[1], text)
            self.count["change point"] += 1
        match = re.match(r"The motion ends at t = (%s) s" % NUMBER, text)
        if match and "joint" in text:
            end = float(match.group(1))
            self.assertTrue(configurations(path, "--time", "%rs" % (end * (1 - 1e-4))), text)
            self.assertFalse(configurations(path, "--time", "%rs" % (end * (1 + 1e-4))), text)
            self.count["end"] += 1

    def check_turning(self, path, text, name, axis, at, unit, value):
        """The coordinate's value is there, and on both sides of it the coordinate lies on the same side of it."""
        self.unit[axis] = unit
        step = 0.02 * TURN / 6 if axis == "t" else math.radians(0.5) / size_of(unit)
        there, before, after = (self.coordinate(path, axis, at + off, name) for off in (0, -step, step))
        self.assertLess(abs(math.remainder(there - value, TURN)), 2e-4 * max(1, abs(value)), text)
        here = [there + off if axis == "t" else there + math.remainder(off, TURN) for off in (before - there, after - there)]
        self.assertGreater((here[0] - there) * (here[1] - there), 0, text)
        self.count["turning"] += 1
        return 1 if here[0] > there else -1

    def check_strokes(self, text, path):
        match = re.match(r"(\S+) moves back and forth between %s \(at (\S+) = %s\) and %s \(at \S+ = %s\)" % (AMOUNT, AMOUNT, AMOUNT, AMOUNT), text)
        if match and not match.group(1).startswith("t "):
            name, axis, unit = match.group(1), match.group(4), match.group(6).strip()
            low, high = float(match.group(5)), float(match.group(9))
            self.assertEqual(self.check_turning(path, text, name, axis, low, unit, amount(match, 2)), 1)
            self.assertEqual(self.check_turning(path, text, name, axis, high, unit, amount(match, 7)), -1)
            there = (high - low) * size_of(unit) % TURN
            ratio = max(there, TURN - there) / min(there, TURN - there)
            told = re.search(r"time ratio is (%s): the quick stroke takes (%s) of" % (NUMBER, NUMBER), text)
            self.assertAlmostEqual(float(told.group(1)) if told else 1, ratio, delta=1e-3 * ratio, msg=text)
            if told:
                self.assertAlmostEqual(float(told.group(2)), 1 / ratio, delta=1e-3, msg=text)
            self.count["ratio"] += 1
        match = re.match(r"(\S+) reverses at (.*)\.$", text)
        if match and "goes to" not in text:
            for value, size, axis, at, unit in re.findall(r"%s \((\S+) = %s\)" % (AMOUNT, AMOUNT), match.group(2)):
                self.check_turning(path, text, match.group(1), axis, float(at), unit.strip(), float(value) * size_of(size))

    # --- forces and energy -------------------------------------------------------------------------------------------

    def check_works(self, text):
        match = re.match(r"Its energy goes from %s to %s(.*?)\. Over the whole" % (AMOUNT, AMOUNT), text)
        if not match:
            return
        start, end = amount(match), amount(match, 3)
        works = [float(w) * size_of(u) for w, u in re.findall(r" does %s" % AMOUNT, match.group(5))]
        scale = max(map(abs, works + [start, end]))
        noise = float(re.search(r"off by (%s) of the largest" % NUMBER, text).group(1))
        self.assertLess(noise, 1e-5, text)
        if match.group(5).count(" does ") < 8:  # all of them are told
            self.assertAlmostEqual(end - start, sum(works), delta=3e-5 * scale * (2 + len(works)) + 1e-12, msg=text)
            self.count["energy"] += 1

    def check_turn_work(self, page):
        for text in page.findings:
            work = re.match(r"Over one turn the drive (does|takes up) %s of work.*?(?: and ends %s (higher|lower))?[^0-9]*$" % (
                AMOUNT, AMOUNT), text)
            mean = next((m for f in page.findings for m in [re.search(r"takes at most .*, on average %s\." % AMOUNT, f)] if m), None)
            if work and mean and len([f for f in page.findings if ", on average " in f]) == 1:
                told = amount(work, 2) * (1 if work.group(1) == "does" else -1)
                self.assertAlmostEqual(abs(told), abs(amount(mean)) * TURN, delta=2e-4 * abs(told) + 1e-9, msg=text)
                self.count["work of a turn"] += 1

    def check_rest(self, text, path, pose):
        if not text.startswith("Released at its start it stays there"):
            return
        run = Run("rest", path, "--format", "json", "-q")
        found = [all(abs(math.remainder(c - pose["coordinates"][n]["position"], TURN)) < 1e-6 for n, c in e["coordinates"].items())
                 for e in run.json()["equilibria"]]
        rates = [abs(c["acceleration"]) for c in pose["coordinates"].values()]
        self.assertTrue(any(found) or max(rates) < 1e-9, text)
        self.count["rest"] += 1

    # --- how it was computed -----------------------------------------------------------------------------------------

    def check_residuals(self, path, page, check, pose, data):
        method = page.words["method"]
        size = max([abs(x) for p in pose["points"].values() for x in p["position"]] + [1e-6])
        close = re.search(r"loops close within (%s) of the machine's size, velocities within (%s), accelerations within (%s)" % (
            (NUMBER,) * 3), method)
        if close:
            for told, what in zip(close.groups(), ("position", "velocity", "acceleration")):
                self.assertLess(float(told), 1e-9)
                for joint in check["joints"]:
                    ends = [pose["points"].get("%s.%s" % (body, joint["name"])) for body in joint["bodies"]]
                    if joint["kind"] == "pin" and all(ends) and ends[0][what][0] is not None and ends[1][what][0] is not None:
                        largest = max(map(abs, ends[0][what]))
                        apart = math.dist(ends[0][what], ends[1][what])
                        if what == "position":
                            self.assertLess(apart, 30 * float(told) * size + 1e-13 * size)
                        self.assertLess(apart, 1e-9 * (largest + size * (1 + max(abs(c["velocity"] or 0) for c in
                                                                                 pose["coordinates"].values()) ** 2)))
                        self.count["closed"] += 1
        forces = re.search(r"Newton's and Euler's equations hold within (%s) of the largest force" % NUMBER, method)
        if forces and "balance" in pose:
            worst = max(balance["residual"] for balance in pose["balance"].values())
            self.assertAlmostEqual(float(forces.group(1)), worst, delta=0.06 * worst)
            self.count["balances"] += 1
        steps = re.search(r"(\d+) steps, (\d+) evaluations; the loops close within (%s), the balance of energy within (%s)\." % (
            NUMBER, NUMBER), method)
        if steps and data:
            run = Run("simulate", path, "--to", "%rs" % data["axis"]["values"][-1], "--steps", str(len(data["axis"]["values"]) - 1),
                      "--of", "t", "--format", "json", "-q")
            if run.out:
                answer = run.json()
                self.assertAlmostEqual(int(steps.group(1)), answer["summary"]["steps"], delta=2 + 0.05 * answer["summary"]["steps"])
                self.count["steps"] += 1
                self.check_happenings(page, answer)

    def check_happenings(self, page, answer):
        """Names and times of what happens on the way."""
        told = next((text for text in page.findings if text.startswith("On the way: ")), None)
        events = [event for event in answer["events"] if event["kind"] not in ("crossing",)]
        if told:
            happenings = re.findall(r"(?:: |; )(\S+) [a-z ]+ at t = (%s) s" % NUMBER, told)
            self.assertEqual(len(happenings), min(6, len(events)))
            for (name, time), event in zip(happenings, events):
                self.assertEqual(name, event["of"])
                self.assertAlmostEqual(float(time), event["time"], delta=6e-5 * event["time"] + 1e-9)
            more = re.search(r"and (\d+) more\.", told)
            self.assertEqual(int(more.group(1)) if more else 0, max(0, len(events) - 6))
            self.count["happenings"] += 1

    # --- gears and cams ----------------------------------------------------------------------------------------------

    def check_gears(self, path, page, check, pose):
        for row in page.table("Speeds, counter-clockwise"):
            if isinstance(row["speed"], float) and pose["bodies"][row["body"]]["rate"] is not None:
                rate = pose["bodies"][row["body"]]["rate"]
                self.assertAlmostEqual(row["speed"], rate, delta=1e-5 * abs(rate) + 1e-9)
                self.count["speed"] += 1
        for text in page.findings:
            ratio = re.match(r"The gear train's ratio of (\S+) to (\S+) is (?:(-?\d+)(?:/(\d+))? = )?(%s)\." % NUMBER, text)
            if ratio:
                value = float(ratio.group(5))
                if ratio.group(3):
                    self.assertAlmostEqual(int(ratio.group(3)) / int(ratio.group(4) or 1), value, delta=2e-6 * abs(value) + 1e-12)
                rates = [pose["bodies"][ratio.group(k)]["rate"] for k in (1, 2)]
                if None not in rates and abs(rates[1]) > 0:
                    self.assertAlmostEqual(rates[0] / rates[1], value, delta=1e-5 * abs(value), msg=text)
                    self.count["ratio of gears"] += 1

    def check_cams(self, path, page, check):
        captions = [caption for caption in page.tables if caption.startswith("The cam ")]
        if len(captions) != 1:
            return
        cam = Run("cam", path, "--format", "json", "-q").json()
        joints = {tuple(j["bodies"]): j["name"] for j in check["joints"]}
        names = {c["joint"]: c["name"] for c in check["coordinates"]}
        turn = names[joints[(cam["cam"]["carrier"], cam["cam"]["cam"])]]
        lift = names[joints[(cam["cam"]["carrier"], cam["cam"]["follower"])]]
        fine, rows = 40, page.table("Its motion program")
        steps = fine * (len(rows) - 1)
        period = cam["cam"]["period"]
        run = Run("sweep", path, "--over", "%s=0:%rrad" % (turn, cam["cam"]["turn"] * period), "--steps", str(steps), "--of", lift,
                  "--format", "json", "-q")
        at = [row[1] for row in run.json()["rows"]]
        self.assertEqual(len(at), steps + 1)
        way = 1 if (max(at) - at[0]) * max(row["s"] for row in rows) >= (at[0] - min(at)) * max(row["s"] for row in rows) else -1
        h, largest = period / steps, max(abs(row["s"]) for row in rows)
        speed, push = (max(abs(row[key]) for row in rows) for key in ("v = ds/dtheta", "a = dv/dtheta"))
        for k, row in enumerate(rows):
            self.assertAlmostEqual(way * (at[fine * k] - at[0]), row["s"] - rows[0]["s"], delta=2e-5 * largest, msg=str((path, k)))
            if 0 < k < len(rows) - 1:
                m = fine * k
                v = way * (8 * (at[m + 1] - at[m - 1]) - at[m + 2] + at[m - 2]) / (12 * h)
                self.assertAlmostEqual(v, row["v = ds/dtheta"], delta=1e-3 * speed, msg=str((path, k)))
                before, after = (at[m] - 2 * at[m - 1] + at[m - 2], at[m + 2] - 2 * at[m + 1] + at[m])
                if abs(before - after) < 0.1 * push * h * h:  # no segment begins here
                    a = way * (at[m + 1] - 2 * at[m] + at[m - 1]) / h ** 2
                    self.assertAlmostEqual(a, row["a = dv/dtheta"], delta=2e-2 * push, msg=str((path, k)))
                    self.count["cam's acceleration"] += 1
            self.check_pressure(cam["cam"], row, (path, k))
            self.count["cam"] += 1

    def check_pressure(self, cam, row, where):
        """The angle between the common normal and the motion of a roller that slides: Norton, Cam Design, equation 7.2."""
        if cam["motion"] != "translating" or cam["face"] != "roller" or cam["offset"] != 0:
            return
        angle = math.atan2(row["v = ds/dtheta"], cam["base"] + cam["roller"] + row["s"])
        self.assertAlmostEqual(angle, row["pressure angle"], delta=2e-5, msg=str(where))
        self.count["pressure angle"] += 1

    def check_whole(self, text, page, data, check, path):
        """How many parts it has; and each coordinate that is not 0 throughout is in one diagram, with what has its unit, but the axis."""
        told = re.search(r"<p>(\d+) moving bod(?:y|ies), (\d+) joints?, (\d+) loops?</p>", text)
        self.assertEqual(list(map(int, told.groups())), [len(check["bodies"]) - 1, len(check["joints"]), len(check["loops"])], path)
        rows = [(row["coordinate"], row["is"].split()[-1], row["at joint"], row["it"]) for row in page.table("Coordinates: second")]
        self.assertEqual(rows, [(c["name"], c["kind"], c["joint"], "is driven" if c["driven"] else "is free" if c["input"] else "follows")
                                for c in check["coordinates"]][:len(rows)], path)
        self.assertTrue(len(rows) == len(check["coordinates"]) or len(rows) > 50, path)
        loops = [html.unescape(loop) for loop in re.findall(r"<li>([^<]*, closed at [^<]*)</li>", text)]
        self.assertEqual(loops, [" – ".join(loop["bodies"] + loop["bodies"][:1]) + ", closed at " + loop["closed_at"]
                                 for loop in check["loops"]][:len(loops)], path)
        self.assertEqual(len(loops) > 0, len(check["loops"]) > 0, path)
        if not data:
            return
        shown = [data["columns"][k] for panel in data["panels"] for k in panel["columns"]]
        for panel in data["panels"]:
            self.assertEqual({data["columns"][k]["unit"] for k in panel["columns"]}, {panel["unit"]}, path)
        for coordinate in check["coordinates"]:
            names = [column["name"] for column in shown if column["name"] == coordinate["name"]]
            is_axis = coordinate["name"] == data["axis"]["name"]
            has = any(column["name"] == coordinate["name"] and any(column["values"]) for column in data["columns"])
            self.assertEqual(len(names), has and not is_axis, (path, coordinate["name"]))

    # --- all of it ---------------------------------------------------------------------------------------------------

    def check_page(self, text, path):
        self.unit = {}
        page, data = Reader(text), data_of(text)
        check = Run("check", path, "--format", "json", "-q").json()
        pose = configurations(path)[0]
        for finding in page.findings:
            finding = finding.replace("Note: ", "")
            self.check_four_bar(finding, check, pose)
            self.check_range(finding, path)
            self.check_event(finding, path, check)
            self.check_strokes(finding, path)
            self.check_works(finding)
            self.check_rest(finding, path, pose)
        self.check_whole(text, page, data, check, path)
        self.check_turn_work(page)
        self.check_residuals(path, page, check, pose, data)
        self.check_gears(path, page, check, pose)
        self.check_cams(path, page, check)

    def test_what_the_page_tells_is_found_there(self):
        for path in EXAMPLES if FULL else SAMPLE:
            with self.subTest(os.path.basename(path)):
                self.check_page(Run("report", path, "-q").out, path)
        for kind, least in LEAST.items():  # nothing was left out by a change of words
            self.assertGreaterEqual(self.count[kind], least[0] if FULL else least[1], kind)

    def test_a_wrong_number_is_seen(self):
        """Of a four-bar's sums and strokes, each a hundredth off, one at a time."""
        path = os.path.join(ROOT, "examples", "four-bar.yaml")
        text = Run("report", path, "-q").out
        begin, end = text.index('id="findings"'), text.index('id="motion"')
        numbers = [m for line in re.finditer(r"<li>[^<]*(?:moves back and forth|are a four-bar)[^<]*", text[begin:end]) for m in
                   re.finditer(r"(?<= )\d+\.?\d*(?= (?:deg|mm))(?! deg;)|(?<=ratio is )[\d.]+(?=:)", line.group(0))
                   for m in [(begin + line.start() + m.start(), begin + line.start() + m.end())]]
        self.assertGreater(len(numbers), 6)
        for start, stop in numbers:
            wrong = text[:start] + "%.5g" % (1.01 * float(text[start:stop]) + 0.1) + text[stop:]
            with self.subTest(text[start - 40:stop + 10]), self.assertRaises(AssertionError):
                self.check_page(wrong, path)


if __name__ == "__main__":
    unittest.main()
