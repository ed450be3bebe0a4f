"""yoke report: every kind of number on its page, parsed out of it, is what the other verbs say of the machine.

Tables and sentences are read in the page's units; `solve`, `sweep`, `simulate`, `gears` and `cam` answer in SI. Accelerations
of centres of mass, scales of drawings and means are found here, from what those verbs say of points. All examples are read;
without YOKE_FULL the motion is compared on every third of them."""
import glob
import math
import os
import re
import unittest

from harness import ROOT, Case, Run, third
from page import AMOUNT, NUMBER, Reader, amount, data_of, size_of

EXAMPLES = sorted(glob.glob(os.path.join(ROOT, "examples", "*.yaml")))
FULL = "YOKE_FULL" in os.environ
class Page(Case):
    def near(self, told, wanted, scale=0.0, digits=6, what=""):
        """To the digits that the page shows; of sums that cancel, of their largest part."""
        margin = 0.6 * 10.0 ** (1 - digits) * abs(wanted) + 1e-9 * scale + 1e-12
        self.assertLessEqual(abs(told - wanted), margin, "%s: %r on the page, %r" % (what, told, wanted))

    # --- the start ---------------------------------------------------------------------------------------------------

    def check_forces(self, page, pose):
        reactions, efforts = pose.get("reactions", {}), pose.get("efforts", {})
        told = page.table("Reactions at the start")
        largest = max([math.hypot(*r["force"]) for r in reactions.values()] + [0])
        size = max([abs(x) for p in pose["points"].values() for x in p["position"]] + [1e-3])
        self.assertEqual([row["joint"] for row in told], list(reactions) if told else [])
        for row in told:
            wanted = reactions[row["joint"]]
            self.assertEqual((row["by"], row["on"]), (wanted["by"], wanted["on"]))
            self.near(row["force x"], wanted["force"][0], largest, what=row["joint"])
            self.near(row["force y"], wanted["force"][1], largest, what=row["joint"])
            self.near(row["size"], math.hypot(*wanted["force"]), largest, what=row["joint"])
            self.near(row["moment"], wanted["moment"], largest * size, what=row["joint"])
        most = max([abs(x) for x in efforts.values()] + [0])
        told = {row["along"]: row.get("torque", row.get("force")) for kind in ("Torques", "Forces")
                for row in page.table(kind + " along coordinates at the start")}
        self.assertEqual(set(told), set(efforts) if told else set())
        for name, value in told.items():
            self.near(value, efforts[name], max(most, largest * size), what=name)
        energy = re.search("Kinetic energy %s, potential energy %s" % (AMOUNT, AMOUNT), page.words.get("forces", ""))
        if energy:
            scale = abs(pose["energy"]["kinetic"]) + abs(pose["energy"]["potential"]) + 1e-3
            self.near(amount(energy), pose["energy"]["kinetic"], scale, 5)
            self.near(amount(energy, 3), pose["energy"]["potential"], scale, 5)
        return bool(reactions)

    def check_balances(self, page, pose):
        """Newton's and Euler's equations of every body, accelerations of its centre found from a point of it."""
        masses = {row["body"]: row for row in page.table("Masses")}
        own = {(row["of"], row["point"]): (row["x"], row["y"]) for row in page.table("Points")}
        told = page.table("Free bodies at the start")
        scale = max([abs(row["%s %s" % (what, axis)]) for row in told for what in ("loads", "reactions") for axis in "xy"] + [0])
        moment = max([abs(row["%s moment" % what]) for row in told for what in ("loads", "reactions")] + [0])
        for row in told:
            sums = [row["loads " + axis] + row["reactions " + axis] for axis in ("x", "y", "moment")]
            for k, axis in enumerate(("x", "y", "moment")):
                self.assertLessEqual(abs(sums[k] - row["inertia " + axis]), 3e-5 * (moment if k == 2 else scale) + 1e-12, row)
            mass = masses.get(row["body"])
            point = next(((name, at) for (body, name), at in own.items() if body == row["body"]), None)
            if not mass or not point:
                continue
            body, place = pose["bodies"][row["body"]], pose["points"]["%s.%s" % (row["body"], point[0])]
            c, s = math.cos(body["angle"]), math.sin(body["angle"])
            x, y = mass["centre x"] - point[1][0], mass["centre y"] - point[1][1]
            arm = (c * x - s * y, s * x + c * y)
            w, a = body["rate"], body["acceleration"]
            ax = place["acceleration"][0] - a * arm[1] - w * w * arm[0]
            ay = place["acceleration"][1] + a * arm[0] - w * w * arm[1]
            fast = mass["mass"] * (math.hypot(*place["acceleration"]) + (abs(a) + w * w) * math.hypot(*arm))
            self.assertAlmostEqual(row["inertia x"], mass["mass"] * ax, delta=1e-5 * (abs(mass["mass"] * ax) + fast) + 1e-9 * scale + 1e-12)
            self.assertAlmostEqual(row["inertia y"], mass["mass"] * ay, delta=1e-5 * (abs(mass["mass"] * ay) + fast) + 1e-9 * scale + 1e-12)
            self.assertAlmostEqual(row["inertia moment"], mass["inertia"] * a,
                                   delta=1e-5 * abs(mass["inertia"] * a) + 1e-9 * moment + 1e-12)

    def check_dimensions(self, path, page, pose):
        """Parameters as the printed C has them; points by how far they are apart in the world."""
        code = Run("code", path, "--prefix", "m", "-q", "--kinematics").out
        match = re.search(r"m_defaults\(void\)\n\{(.*?)\n\}", code, re.S)
        printed = {name: float(value) for name, value in re.findall(r"\.(\w+) = (%s)" % NUMBER, match.group(1))} if match else {}
        for row in page.table("Parameters"):
            if row["parameter"] in printed and row["value"] != "":
                self.near(row["value"] * size_of(row["unit"]) if row["unit"] not in ("1", "") else row["value"],
                          printed[row["parameter"]], digits=8, what=row["parameter"])
        points = page.table("Points")
        for a, b in zip(points, points[1:]):
            if a["of"] != b["of"]:
                continue
            here, there = (pose["points"]["%s.%s" % (row["of"], row["point"])]["position"] for row in (a, b))
            apart = math.dist(here, there)
            self.assertAlmostEqual(math.hypot(a["x"] - b["x"], a["y"] - b["y"]), apart, delta=1e-7 * (apart + 1e-3))

    def check_start(self, page, pose, path):
        if not any("it can be assembled in" in finding for finding in page.findings):  # then there is one way alone
            every = Run("solve", path, "--all", "--format", "json", "-q")
            if every.code == 0:
                self.assertEqual(len(every.json()["configurations"]), 1)
        for finding in page.findings:
            ways = re.search(r"it can be assembled in (at least )?(\d+) ways", finding)
            if ways and not ways.group(1):
                every = Run("solve", path, "--all", "--format", "json").json()
                self.assertEqual(int(ways.group(2)), len(every["configurations"]))
                label = re.search(r"start values \((.*)\)", finding)
                if label:
                    self.assertEqual(label.group(1), pose["label"])
            stands = re.search("At rest the largest force in a joint is %s, in (.+)\\." % AMOUNT, finding)
            if stands:
                sizes = {name: math.hypot(*r["force"]) for name, r in pose["reactions"].items()}
                self.near(amount(stands), max(sizes.values()), digits=5)
                self.near(sizes[stands.group(3)], max(sizes.values()))

    # --- the motion --------------------------------------------------------------------------------------------------

    def motion_of(self, path, data, names, axis):
        """The same rows by `sweep` or `simulate`: lists by name, in SI."""
        at, unit = data["axis"]["values"], size_of(data["axis"]["unit"])
        steps = len(at) - 1
        words = ["--steps", str(steps), "--of", ",".join(names), "--format", "json"]
        if axis == "simulation":
            done = Run("simulate", path, "--to", "%r s" % (at[-1] * unit), *words)
        else:
            span = "%s=%r:%r%s" % (axis, at[0], at[-1], data["axis"]["unit"])
            done = Run("sweep", path, "--over", span, *words)
        return done.json() if done.out else None

    def check_columns(self, page, data, answer, full):
        index = {name: k for k, name in enumerate(answer["columns"])}
        for column in data["columns"]:
            k, unit = index[column["name"]], size_of(column["unit"])
            wanted = [row[k] for row in answer["rows"]]
            largest = max([abs(x) for x in wanted if x is not None] + [0])
            if len(wanted) != len(column["values"]):
                continue # `sweep` ends beyond a limit where the page's motion is cut before
            turn = 2 * math.pi if column["unit"] == "deg" and "." not in column["name"] else 0
            for told, value in zip(column["values"], wanted):
                if told is None or value is None or largest == 0:
                    continue
                off = told * unit - value
                off = math.remainder(off, turn) if turn else off
                # the page rounds the ends of its range, too, to 7 digits
                self.assertLessEqual(abs(off), full * abs(value) + 3e-6 * largest + 1e-12, column["name"])

    def check_labels(self, page, data):
        """What a diagram says to those who cannot see it, and the data that it draws."""
        columns = {column["name"]: column for column in data["columns"]}
        found = 0
        for label in page.labels:
            for name, low, unit, high, _ in re.findall(r"(?:: |; )(\S+) between %s and %s" % (AMOUNT, AMOUNT), label):
                values = [x for x in columns[name]["values"] if x is not None]
                self.assertEqual(unit.strip(), columns[name]["unit"])
                largest = max(map(abs, values))
                self.assertAlmostEqual(float(low), min(values), delta=6e-5 * abs(min(values)) + 1e-9 * largest)
                self.assertAlmostEqual(float(high), max(values), delta=6e-5 * abs(max(values)) + 1e-9 * largest)
                found += 1
        return found

    def check_drawing(self, path, data, axis):
        """Pixels of traced points over the rows are their places to one scale, turned over and shifted, never stretched."""
        names = ["%s.%s" % (point["name"], axis_of) for point in data["points"] for axis_of in "xy"]
        answer = self.motion_of(path, data, names, axis)
        if not answer or len(answer["rows"]) != len(data["axis"]["values"]):
            return
        index = {name: k for k, name in enumerate(answer["columns"])}
        pairs = []
        for point in data["points"]:
            body = data["bodies"][point["body"]]
            for row in range(0, len(answer["rows"]), 7):
                angle = math.radians(body["turn"][row])
                dx, dy = (point["at"][k] - body["center"][k] for k in range(2))
                pixel = complex(body["center"][0] + body["x"][row], body["center"][1] + body["y"][row]) + complex(
                    math.cos(angle), math.sin(angle)) * complex(dx, dy)
                place = complex(*(answer["rows"][row][index["%s.%s" % (point["name"], k)]] for k in "xy"))
                pairs.append((pixel, place.conjugate()))
        if len(pairs) < 3:
            return
        middle_pixel, middle = (sum(side) / len(pairs) for side in zip(*pairs))
        spread = sum(abs(z - middle) ** 2 for _, z in pairs)
        if spread < 1e-20:
            return
        scale = sum((p - middle_pixel) * (z - middle).conjugate() for p, z in pairs) / spread
        self.assertLess(abs(scale.imag), 1e-3 * abs(scale))
        self.assertGreater(scale.real, 0)
        for pixel, place in pairs:
            self.assertLess(abs(pixel - middle_pixel - scale * (place - middle)), 0.1)

    def check_sweep_findings(self, path, page, data, answer, axis):
        names = answer["columns"]
        columns = {name: [row[k] for row in answer["rows"] if row[k] is not None] for k, name in enumerate(names)}
        strokes = {stroke["column"]: stroke for stroke in answer.get("strokes", [])}
        found = 0
        for text in page.findings:
            match = re.match(r"(\S+) moves back and forth between %s \(at .*?\) and %s \(at .*?\), a (?:stroke|swing) of %s" % (
                AMOUNT, AMOUNT, AMOUNT), text)
            if match and match.group(1) in strokes:
                stroke = strokes[match.group(1)]
                size = abs(stroke["low"]) + abs(stroke["high"])
                turn = 2 * math.pi if "deg" in match.group(3) or "rad" in match.group(3) else math.inf
                off = amount(match, 2) - stroke["low"]
                off -= turn * round(off / turn) if turn < math.inf else 0
                self.assertLess(abs(off), 1e-4 * size)
                self.near(amount(match, 6), stroke["high"] - stroke["low"], digits=5)
                ratio = re.search(r"time ratio is (%s)" % NUMBER, text)
                self.assertAlmostEqual(float(ratio.group(1)) if ratio else 1, stroke["ratio"], delta=6e-5)
                found += 1
            match = re.search(r"The transmission angle at joint (\S+) falls to %s" % AMOUNT, text)
            if match:
                least = min(columns[match.group(1) + ".transmission"])
                self.assertLessEqual(amount(match, 2), least * (1 + 1e-4))
                self.assertAlmostEqual(amount(match, 2), least, delta=2e-2 * (least + 0.05)) # it is found between the rows
                found += 1
            match = re.match(r"(?:The drive of|Moving) (\S+) takes at most %s( against its positive sense)? \(at .*?\)(?:, on average %s)?" % (
                AMOUNT, AMOUNT), text)
            if match:
                values = columns[match.group(1) + ".effort"]
                peak = max(values, key=abs)
                self.assertGreaterEqual(amount(match, 2) * (1 + 1e-4), abs(peak))
                self.assertLess(amount(match, 2), 1.1 * abs(peak) + 1e-9)
                if abs(max(values) + min(values)) > 0.1 * abs(peak):
                    self.assertEqual(bool(match.group(4)), peak < 0)
                if match.group(5):
                    mean = sum((a + b) / 2 for a, b in zip(values, values[1:])) / (len(values) - 1)
                    self.assertAlmostEqual(amount(match, 5), mean, delta=1e-4 * abs(mean) + 3e-6 * abs(peak))
                found += 1
            match = re.match(r"The largest force in a joint is (?:about )?%s, in (.+?) \(at" % AMOUNT, text)
            if match:
                most = max(max(map(abs, columns[name])) for name in names if re.fullmatch(r".*\.force", name))
                self.assertGreaterEqual(amount(match) * (1 + 1e-4), most)
                self.assertLess(amount(match), 1.1 * most)
                found += 1
            match = re.match(r"On its frame the machine exerts up to about %s" % AMOUNT, text)
            if match:
                most = max(math.hypot(x, y) for x, y in zip(columns["shaking.x"], columns["shaking.y"]))
                self.near(amount(match), most, digits=5)
                found += 1
            match = re.search(r"the machine's own energy lies between %s and %s" % (AMOUNT, AMOUNT), text)
            if match:
                scale = max(map(abs, columns["energy"]))
                self.near(amount(match), min(columns["energy"]), scale, 5)
                self.near(amount(match, 3), max(columns["energy"]), scale, 5)
                found += 1
            match = re.match(r"Its energy goes from %s to %s" % (AMOUNT, AMOUNT), text)
            if match:
                scale, start, end = max(map(abs, columns["energy"])), answer["summary"]["energy_start"], answer["summary"]["energy_end"]
                off = abs(end - start - sum(work["work"] for work in answer["work"]))  # no more than this is told as 0
                self.assertAlmostEqual(amount(match), start, delta=1e-4 * scale + 1.01 * off + 1e-12)
                self.assertAlmostEqual(amount(match, 3), end, delta=1e-4 * scale + 1.01 * off + 1e-12)
                found += 1
        return found

    def check_motion(self, path, page, data):
        if not data or len(data["axis"]["values"]) < 2:
            return 0
        simulated = "Its motion under its loads" in page.words["motion"]
        axis = "simulation" if simulated else data["axis"]["name"]
        answer = self.motion_of(path, data, [column["name"] for column in data["columns"]], axis)
        if answer is None or not answer.get("rows"):
            return 0
        self.check_columns(page, data, answer, 1e-5 if not simulated else 1e-3)
        self.check_drawing(path, data, axis)
        poses = re.search(r"Motion: (\d+) poses", page.words["method"])
        if poses:
            self.assertEqual(int(poses.group(1)), len(data["axis"]["values"]))
        if len(answer["rows"]) != len(data["axis"]["values"]):
            return 0
        return self.check_sweep_findings(path, page, data, answer, axis)

    # --- the moving parts ----------------------------------------------------------------------------------------------

    def check_pace(self, page, data, pose):
        """How long a pass takes, which way, and at which row the machine stands as `solve` finds it."""
        axis, at = data["axis"], data["axis"]["values"]
        span, rates = (at[-1] - at[0]) * size_of(axis["unit"]), [c["values"] for c in data["columns"] if c["name"] == axis["name"] + ".rate"]
        self.assertEqual(data["goes_back"], "Back and forth, " in page.words["motion"])
        told = re.search(r", (\S+) = %s to %s" % (AMOUNT, AMOUNT), page.words["motion"])
        self.assertEqual(told.group(1), axis["name"])
        self.near(amount(told, 2), at[0] * size_of(axis["unit"]), digits=5)
        self.near(amount(told, 4), at[-1] * size_of(axis["unit"]), digits=5)
        if any("The motion ends at" in finding for finding in page.findings):
            return
        if axis["name"] == "t":
            self.assertAlmostEqual(data["seconds"], min(max(2.5, span), 15), delta=1e-5 * data["seconds"])
        elif rates and min(rates[0]) == max(rates[0]) != 0:
            rate = rates[0][0] * size_of(next(c["unit"] for c in data["columns"] if c["name"] == axis["name"] + ".rate"))
            self.assertGreater(rate * span, 0)
            self.assertAlmostEqual(data["seconds"], min(max(2.5, span / rate), 15), delta=1e-5 * data["seconds"])
        start = at[0] * size_of(axis["unit"]) + data["start"] / (len(at) - 1) * span
        wanted = 0 if axis["name"] == "t" else pose["coordinates"][axis["name"]]["position"]
        self.assertLess(abs(start - wanted), 1e-5 * (abs(span) + abs(wanted)))

    def check_script(self, page, data, pose):
        """What follows the machine: columns that belong to each other by name, and pins and points where `solve` has them."""
        names = [column["name"] for column in data["columns"]]
        rows = len(data["axis"]["values"])
        self.assertEqual({len(column["values"]) for column in data["columns"]}, {rows})
        readout = [[names[k] for k in columns] for columns in data["readout"]]
        self.assertEqual(readout, [[n, n + ".rate", n + ".accel"] for n, *_ in readout])
        self.assertEqual([n for n, *_ in readout], [n for n in pose["coordinates"] if n in names])
        if "bodies" not in data:
            return 0
        self.assertEqual({len(body[key]) for body in data["bodies"] for key in ("x", "y", "turn")}, {rows})
        self.assertEqual([body["name"] for body in data["bodies"]][1:], [name for name in pose["bodies"] if name != "ground"])
        self.assertEqual([middle["body"] for middle in data["middles"]], list(range(len(data["bodies"]))))
        pairs = []
        for kind, endings in (("joints", (".force.x", ".force.y")), ("points", (".x.rate", ".y.rate"))):
            for thing in data[kind]:
                wanted = [thing["name"] + ending for ending in endings if thing["name"] + ending in names]
                self.assertEqual([names[k] for k in thing["columns"]], wanted)
                key = thing["name"] if kind == "points" else "%s.%s" % (data["bodies"][thing["body"]]["name"], thing["name"])
                ends = [p["position"] for name, p in pose["points"].items() if name.split(".", 1)[1] == thing["name"]]
                if key in pose["points"] and (kind == "points" or len(ends) == 2 and math.dist(*ends) < 1e-9):  # a pin
                    pairs.append((complex(*thing["at"]), complex(*pose["points"][key]["position"]).conjugate()))
        self.assertTrue(not data["points"] or any(point["shown"] for point in data["points"]))
        spread = max([abs(a[1] - b[1]) for a in pairs for b in pairs] + [0])
        if spread == 0:
            return 0
        (p, z), (q, w) = max(((a, b) for a in pairs for b in pairs), key=lambda two: abs(two[0][1] - two[1][1]))
        scale = (q - p) / (w - z)
        self.assertLess(abs(scale.imag) * spread, 0.03)
        for pixel, place in pairs:
            self.assertLess(abs(pixel - p - scale.real * (place - z)), 0.05)
        return len(pairs)

    # --- gears and cams ----------------------------------------------------------------------------------------------

    def check_gears(self, path, page):
        told = page.table("Meshes")
        if not told:
            return 0
        answer = Run("gears", path, "--format", "json").json()
        for row in told:
            mesh = answer["meshes"][row["mesh"]]
            self.assertEqual(row["Willis' equation"], mesh["willis"])
            for key, radius in zip(("first radius", "second radius"), mesh["radii"]):
                self.assertEqual(isinstance(row[key], float), radius is not None and radius > 0, row)
                if radius:
                    self.near(row[key], radius)
            for key, body, teeth in zip(("first", "second"), mesh["bodies"], mesh["teeth"] or [None, None]):
                self.assertEqual(row[key], body + (", %d teeth" % teeth if teeth else ""))
            kind = {"gears": ("external", "internal"), "belt": ("crossed belt", "open belt")}.get(mesh["kind"], ("rack", "rack"))
            self.assertEqual((row["kind"], row["carrier"]), (kind[mesh["internal"]], mesh["carrier"]))
        for caption, key in (("Speeds, counter-clockwise", "speed"), ("Turns for one turn", "turns")):
            for row in page.table(caption):
                wanted = answer["bodies"][row["body"]]
                self.assertEqual(str(row["exactly"]) == "open", wanted["speed"] is None, row)
                if wanted["speed"] is not None:
                    self.near(row[key], wanted["speed"], 1)
        if not answer["lock"]:
            self.assertEqual({row["lock"]: row["ratio"] if isinstance(row["ratio"], float) else None
                              for row in page.table("Ratios, one for each set")},
                             {lock: gear["ratio"] and gear["ratio"]["value"] and float("%.6g" % gear["ratio"]["value"])
                              for lock, gear in (answer["shift_table"] or {}).items()})
        for remark in answer["remarks"]:
            self.assertIn("%s: %s." % (remark["mesh"], remark["text"]), page.words["gears"])
            faults = [finding for finding in page.findings if "Mesh %s: %s." % (remark["mesh"], remark["text"]) in finding]
            self.assertEqual(len(faults), remark["fault"])
        return len(told)

    def check_cams(self, path, page):
        cams = [caption for caption in page.tables if caption.startswith("The cam ")]
        if len(cams) != 1:
            return 0
        answer = Run("cam", path, "--format", "json").json()
        summary, period = answer["summary"], answer["cam"]["period"]
        facts = {row[0]: row[1:] for row in page.tables[cams[0]][1:]}
        for what, key in (("largest pressure angle", "pressure_angle"), ("smallest convex radius of the surface", "surface_convex"),
                          ("smallest hollow radius of the surface", "surface_hollow")):
            if what in facts:
                self.near(amount(re.match(AMOUNT, facts[what][0])), summary[key]["value"], digits=5, what=what)
        program = page.table("Its motion program")
        self.assertAlmostEqual(program[-1]["cam angle"], period, delta=1e-5 * period)
        highest = max(row["s"] for row in program)
        self.assertLessEqual(highest, amount(re.match(AMOUNT, facts["largest lift"][0])) * (1 + 1e-4) + 1e-12)
        self.assertLessEqual(abs(max((row["v = ds/dtheta"] for row in program), key=abs)), abs(summary["v"]["value"]) * (1 + 1e-5))
        return len(program)

    # --- all of it ---------------------------------------------------------------------------------------------------

    def test_every_number_of_the_page_is_what_the_verbs_say(self):
        with_forces = findings = labels = meshes = rows = places = 0
        sample = EXAMPLES if FULL else third(EXAMPLES, 0)
        for path in EXAMPLES:
            with self.subTest(os.path.basename(path)):
                text = Run("report", path, "-q").out
                page, data = Reader(text), data_of(text)
                pose = Run("solve", path, "--format", "json").json()["configurations"][0]
                with_forces += self.check_forces(page, pose)
                self.check_balances(page, pose)
                self.check_dimensions(path, page, pose)
                self.check_start(page, pose, path)
                meshes += self.check_gears(path, page)
                rows += self.check_cams(path, page)
                if data:
                    labels += self.check_labels(page, data)
                    if len(data["axis"]["values"]) > 1:
                        self.check_pace(page, data, pose)
                        places += self.check_script(page, data, pose)
                if path in sample:
                    findings += self.check_motion(path, page, data)
        self.assertGreater(with_forces, 20) # nothing was left out by a change of words
        self.assertGreater(meshes, 10)
        self.assertGreater(rows, 20)
        if data_of(Run("report", self.four_bar).out): # built with the script
            self.assertGreater(labels, 200)
            self.assertGreater(places, 200)
            self.assertGreater(findings, 60 if FULL else 20)


if __name__ == "__main__":
    unittest.main()
