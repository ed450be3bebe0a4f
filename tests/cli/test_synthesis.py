"""yoke synthesize: every example task, the shape of the JSON, folders of files, tasks that are wrong. YOKE=path/of/yoke python3 ..."""
import glob
import json
import math
import os
import re
import unittest

from harness import Case, FEW, ROOT, Run, some

TASKS = sorted(glob.glob(os.path.join(ROOT, "examples", "tasks", "*.yaml")))
FIVE = os.path.join(ROOT, "examples", "tasks", "five-positions.yaml")
KEYS = {"rank", "file", "model", "mechanism", "error", "worst", "transmission", "size", "circuits", "type", "parameters", "pivots", "lengths", "point"}
DIMENSIONS = {"transmission", "size", "circuits", "pivots", "lengths", "point"}


class Synthesis(Case):
    def test_every_example_has_machines_that_other_verbs_take(self):
        self.assertGreater(len(TASKS), 6)
        for path in some(TASKS):
            answer = self.good("synthesize", path, "--format", "json").json()
            self.assertEqual(answer["status"], "ok", path)
            self.assertGreater(len(answer["candidates"]), 0)
            if "nine-points" in path:
                self.assertEqual((answer["complete"], answer["solutions"]), (True, {"complex": 8652, "real": 384}))
            for candidate in answer["candidates"][:1 if FEW else None]:
                self.assertLessEqual(KEYS if answer["synthesis"] != "machine" else KEYS - DIMENSIONS, set(candidate))
                file = self.write("candidate.yaml", candidate["model"])
                self.good("check", file)
                solved = self.good("solve", file, "--format", "json").json()
                self.assertEqual(solved["status"], "ok")
                if answer["synthesis"] not in ("path", "machine"):
                    self.assertLess(candidate["error"], 1e-12)

    def test_any_number_of_threads_finds_the_same_bytes(self):
        oval = self.write("oval.yaml", """synthesis: path
points: [[-40, 0], [-20, 17], [0, 20], [20, 17], [40, 0], [20, -17], [0, -20], [-20, -17]]
closed: true
mechanisms: [four-bar, slider-crank]
best: 4
units: {length: mm}
""")
        machine = os.path.join(ROOT, "examples", "tasks", "straight-line-machine.yaml")
        for path in [oval, machine, FIVE]:
            answers = {self.good("synthesize", path, "--threads", n, "--format", "json").out for n in ("1", "3")}
            self.assertEqual(len(answers), 1, path)
        for bad in ("0", "x", "2000"):
            self.wrong(806, "synthesize", FIVE, "--threads", bad)

    def test_the_published_positions(self):
        answer = self.good("synthesize", FIVE, "--format", "json", "--defects").json()
        self.assertEqual((answer["complete"], answer["reproducible"], answer["solutions"]), (True, True, {"complex": 4, "real": 4}))
        self.assertEqual(len(answer["candidates"]) + sum(answer["left_out"].values()), 6)
        self.assertEqual(len(answer["defects"]), sum(answer["left_out"].values()))
        for candidate in answer["candidates"]:
            (ax, ay), (bx, by) = candidate["pivots"]
            self.assertAlmostEqual(math.hypot(bx - ax, by - ay), candidate["lengths"]["ground"], 12)
            first, second = (answer["dyads"][k] for k in candidate["dyads"])
            self.assertEqual(first["fixed"], candidate["pivots"][0])
            self.assertEqual(second["fixed"], candidate["pivots"][1])

    def test_errors_evened_out_are_told_with_those_before(self):
        with open(os.path.join(ROOT, "examples", "tasks", "power-function.yaml"), encoding="utf-8") as file:
            path = self.write("evened.yaml", file.read() + "evened: true\n")
        self.assertIn("interpolating", self.good("synthesize", path).out)
        for candidate in self.good("synthesize", path, "--format", "json").json()["candidates"]:
            self.assertLess(candidate["worst"], 0.8 * candidate["interpolating"])

    def test_so_far_tells_what_is_found_and_then_the_answer_as_it_is_without(self):
        path = self.write("oval.yaml", """synthesis: path
points: [[-40, 0], [-20, 17], [0, 20], [20, 17], [40, 0], [20, -17], [0, -20], [-20, -17]]
closed: true
mechanisms: [four-bar]
require: {input: turns}
best: 3
units: {length: mm}
""")
        out = self.good("synthesize", path, "--format", "json", "--so-far").out
        answer = out[out.index("\n{\n") + 1:]
        self.assertEqual(answer, self.good("synthesize", path, "--format", "json").out)
        lines = [json.loads(line) for line in out[:-len(answer)].splitlines()]
        parts = [line["part"] for line in lines if "part" in line]
        self.assertEqual(parts, sorted(set(parts)))
        self.assertGreater(len(parts), 3)
        best = []
        for line in lines:
            if "part" not in line:
                self.assertEqual(line["best"], 3)
                best.insert(line["rank"] - 1, line)
        first = json.loads(answer)["candidates"][0]
        self.assertEqual({key: best[0][key] for key in ("model", "worst", "lengths", "transmission")},
                         {key: first[key] for key in ("model", "worst", "lengths", "transmission")})
        self.wrong(806, "synthesize", path, "--so-far")

    def test_slider_cranks_take_a_body_through_positions(self):
        path = self.write("slide.yaml", self.read_example().replace("name:", "mechanisms: [slider-crank]\nname:"))
        self.wrong(841, "synthesize", path)
        with open(path, encoding="utf-8") as file:
            lines = [line for line in file if "40 deg" not in line and "30 deg" not in line]
        answer = self.good("synthesize", self.write("slide.yaml", "".join(lines)), "--format", "json").json()
        self.assertEqual({candidate["mechanism"] for candidate in answer["candidates"]}, {"slider-crank"})

    def test_a_slider_crank_is_told_with_its_offset(self):
        path = self.write("stroke.yaml", "synthesis: stroke\nstroke: 100 mm\ntime_ratio: 1.25\nunits: {length: mm, angle: deg}\n")
        length = self.good("synthesize", path, "--format", "json").json()["candidates"][0]["lengths"]
        a, b, e = length["input"], length["coupler"], length["offset"]
        far, near = math.sqrt((b + a) ** 2 - e * e), math.sqrt((b - a) ** 2 - e * e)
        self.assertAlmostEqual(far - near, 0.1)  # the stroke, and the angle between the dead centres
        self.assertAlmostEqual(abs(math.atan2(e, near) - math.atan2(e, far)), math.pi * 0.25 / 2.25)
        table = self.good("synthesize", path).out
        self.assertIn("offset [mm]", table)
        self.assertIn("%.4f" % (1000 * e), table)
        self.assertNotIn("offset", self.good("synthesize", FIVE).out)

    def test_a_folder_holds_the_machines_the_picture_and_the_answer(self):
        folder = self.path("machines")
        run = self.good("synthesize", FIVE, "-o", folder)
        self.assertIn("crank-rocker", run.out)
        names = sorted(os.listdir(folder))
        self.assertEqual(names, ["01-four-bar.yaml", "02-four-bar.yaml", "03-four-bar.yaml", "burmester.svg", "candidates.svg", "task.json"])
        with open(os.path.join(folder, "task.json"), encoding="utf-8") as file:
            answer = json.load(file)
        for candidate in answer["candidates"]:
            with open(os.path.join(folder, candidate["file"]), encoding="utf-8") as file:
                self.assertEqual(file.read(), candidate["model"])
        with open(os.path.join(folder, "candidates.svg"), encoding="utf-8") as file:
            self.assertEqual(file.read().count('class="candidate"'), 3)

    def test_a_folder_that_holds_other_files_is_refused(self):
        folder = self.path("taken")
        os.mkdir(folder)
        with open(os.path.join(folder, "mine.txt"), "w", encoding="utf-8") as file:
            file.write("keep")
        self.wrong(846, "synthesize", FIVE, "-o", folder)
        self.assertEqual(os.listdir(folder), ["mine.txt"])
        self.wrong(846, "synthesize", FIVE, "-o", FIVE)

    def test_no_machine_is_an_answer_with_its_reasons(self):
        path = self.write("none.yaml", self.read_example().replace("name:", "require: {transmission: 89 deg}\nname:"))
        run = Run("synthesize", path, "--format", "json")
        self.assertEqual(run.code, 1)
        answer = json.loads(run.out)
        self.assertEqual((answer["status"], answer["candidates"]), ("none", []))
        self.assertEqual(sum(answer["left_out"].values()), 6)
        self.assertIn("transmission", run.err)

    def read_example(self):
        with open(FIVE, encoding="utf-8") as file:
            return file.read()

    def test_the_same_seed_gives_the_same_answer(self):
        path = os.path.join(ROOT, "examples", "tasks", "four-positions.yaml")
        first, second, other = (self.good("synthesize", path, "--format", "json", "--seed", seed).out for seed in "112")
        self.assertEqual(first, second)
        self.assertNotEqual(first, other)

    def test_a_cut_by_time_says_so(self):
        path = os.path.join(ROOT, "examples", "tasks", "four-positions.yaml")
        run = Run("synthesize", path, "--format", "json", "--within", "0.001ms")
        answer = json.loads(run.out)
        self.assertEqual((answer["status"], answer["complete"], answer["reproducible"]), ("time", False, False))

    def test_wrong_values_and_files(self):
        self.wrong(806, "synthesize", FIVE, "--within", "fast")
        self.wrong(806, "synthesize", FIVE, "--within", "3mm")
        self.wrong(806, "synthesize", FIVE, "--format", "csv")
        self.wrong(806, "synthesize", FIVE, "--seed", "x")
        self.wrong(808, "synthesize")
        self.wrong(130, "synthesize", self.path("missing.yaml"))
        self.wrong(840, "synthesize", self.write("dance.yaml", "synthesis: dance\n"))
        self.wrong(806, "new", "--task", "dance")

    def test_paths_have_their_angles_and_points(self):
        path = os.path.join(ROOT, "examples", "tasks", "arc-at-angles.yaml")
        folder = self.path("paths")
        self.assertIn("random starts", self.good("synthesize", path, "-o", folder).out)
        with open(os.path.join(folder, "task.json"), encoding="utf-8") as file:
            answer = json.load(file)
        self.assertEqual((answer["synthesis"], answer["complete"], answer["reproducible"]), ("path", False, True))
        errors = [candidate["error"] for candidate in answer["candidates"]]
        self.assertEqual(errors, sorted(errors))
        self.assertLess(errors[0], 2.5803559e-6)
        for candidate in answer["candidates"]:
            self.assertEqual(len(candidate["angles"]), 6)
            self.assertAlmostEqual(candidate["angles"][2], math.pi / 2, 14)
        with open(os.path.join(folder, "candidates.svg"), encoding="utf-8") as file:
            self.assertIn("#c0392b", file.read())

    def test_a_path_cut_by_time_keeps_its_best(self):
        points = ", ".join("[%r, %r]" % (math.cos(k / 20) + 0.1 * math.cos(k / 5), math.sin(k / 20)) for k in range(125))
        path = self.write("long.yaml", "synthesis: path\nclosed: true\npoints: [%s]\n" % points)
        run = Run("synthesize", path, "--format", "json", "--within", "300ms")
        answer = json.loads(run.out)
        self.assertEqual((answer["status"], answer["complete"], answer["reproducible"]), ("time", False, False))

    def test_cognates_share_the_curve(self):
        for name, count in (("four-bar", 2), ("hoeken", 2), ("chebyshev", 2)):
            folder = self.path(name)
            path = os.path.join(ROOT, "examples", name + ".yaml")
            answer = self.good("cognates", path, "--format", "json", "-o", folder).json()
            self.assertEqual(len(answer["cognates"]), count)
            for cognate in answer["cognates"]:
                size = max(cognate["lengths"].values())
                self.assertLess(cognate["apart"], 1e-7 * size)
                self.good("check", os.path.join(folder, cognate["file"]))
            self.assertIn("cognates.svg", os.listdir(folder))
        self.wrong(846, "cognates", path, "-o", folder)
        self.wrong(815, "cognates", path, "--trace", "coupler.nothing")
        self.assertEqual(Run("cognates", os.path.join(ROOT, "examples", "pendulum.yaml")).code, 1)

    def test_balancing(self):
        path = os.path.join(ROOT, "examples", "watt-with-masses.yaml")
        folder = self.path("balanced")
        answer = self.good("balance", path, "--format", "json", "-o", folder).json()
        self.assertTrue(answer["full"])
        self.assertGreater(answer["before"]["force"], 0)
        self.assertLess(answer["after"]["force"], 1e-8 * answer["before"]["force"])
        self.assertEqual(sorted(os.listdir(folder)), ["balance.json", "balanced.yaml"])
        self.good("check", os.path.join(folder, "balanced.yaml"))
        self.assertIn("shaking force", self.good("balance", path).out)
        engine = self.good("balance", os.path.join(ROOT, "examples", "gas-engine.yaml"), "--format", "json").json()
        self.assertEqual((engine["turns"], [order["order"] for order in engine["orders"]]), (2, [1, 2, 3, 4, 5, 6]))
        self.assertAlmostEqual(engine["orders"][1]["before"]["with"], engine["orders"][1]["before"]["against"], 9)
        self.assertIn("turns with the input and against it", self.good("balance", os.path.join(ROOT, "examples", "gas-engine.yaml")).out)
        self.wrong(806, "balance", path, "--fluctuation", "much")
        self.wrong(806, "balance", path, "--format", "csv")
        self.assertEqual(Run("balance", os.path.join(ROOT, "examples", "double-pendulum.yaml")).code, 1)

    def test_instant_centres(self):
        path = os.path.join(ROOT, "examples", "four-bar.yaml")
        answer = self.good("solve", path, "--centers", "--format", "json").json()["configurations"][0]
        self.assertEqual((len(answer["centers"]), answer["stalled"]), (6, 0))
        self.assertEqual([c["source"] for c in answer["centers"]], ["joint"] * 4 + ["kennedy"] * 2)
        self.assertIn("lines by", self.good("solve", path, "--centers").out)
        butterfly = self.good("solve", os.path.join(ROOT, "examples", "double-butterfly.yaml"), "--centers")
        self.assertIn("stalled", butterfly.out)
        self.wrong(806, "solve", path, "--centers", "--format", "csv")
        self.assertEqual(Run("solve", os.path.join(ROOT, "examples", "double-pendulum.yaml"), "--centers").code, 1)

    def test_polygons(self):
        path = os.path.join(ROOT, "examples", "quick-return.yaml")
        answer = self.good("solve", path, "--polygon", "acceleration", "--format", "json").json()["configurations"][0]
        polygon = answer["polygon"]
        self.assertEqual(polygon["kind"], "acceleration")
        self.assertIn("coriolis", [v["part"] for v in polygon["vectors"]])
        image = {i["name"]: i["value"] for i in polygon["images"]}
        ends = {(v["from"], v["to"]): [s + d for s, d in zip(v["start"], v["value"])] for v in polygon["vectors"]}
        for (_, to), end in ends.items():
            for one, other in zip(end, image[to]):
                self.assertAlmostEqual(one, other, delta=1e-12)
        self.assertEqual(len(polygon["steps"]), 3)
        self.assertIn("Coriolis", self.good("solve", path, "--polygon", "acceleration").out)
        told = {}
        for unit in ("m", "mm"):
            with open(path, encoding="utf-8") as file:
                own = self.write("polygon.yaml", re.sub(r"(?m)^units:.*$", "", file.read()) + "\nunits: {length: %s}\n" % unit)
            run = Run("solve", own, "--polygon", "velocity")
            told[unit] = [float(line.split()[-1]) for line in run.out[run.out.rindex("size ["):].splitlines()[1:] if line.strip()]
            self.assertIn("size [%s/s]" % unit, run.out)
            self.assertIn(" %s/s " % unit, run.out[run.out.index("1. "):])
        for one, other in zip(told["m"], told["mm"]):
            self.assertAlmostEqual(1000 * one, other, delta=0.01 * abs(other) + 1e-9)
        self.assertGreater(len(told["m"]), 3)
        self.assertIn("velocity polygon", self.good("draw", path, "--polygon", "velocity").out)
        self.assertIn('class="center"', self.good("draw", path, "--centers").out)
        free = os.path.join(ROOT, "examples", "driven-coupler.yaml")
        for verb in ("solve", "draw"):
            self.wrong(806, verb, path, "--polygon", "torque")
            self.assertEqual(Run(verb, free, "--polygon", "velocity").code, 1)
        self.wrong(806, "solve", path, "--polygon", "velocity", "--format", "csv")
        self.wrong(806, "draw", path, "--polygon", "velocity", "--trace", "ram.C")
        self.wrong(806, "draw", path, "--centers", "--animate", "a.svg")
        self.assertEqual(Run("draw", os.path.join(ROOT, "examples", "double-pendulum.yaml"), "--centers").code, 1)

    def test_the_effort_of_a_cylinder_is_a_force(self):
        path = self.write("lift.yaml", """
gravity: [0, -9.81 m/s^2]
bodies:
  ground: {points: {O: [0, 0], H: [500, -300]}}
  arm:    {points: {O: [0, 0], K: [400, 0]}, mass: 12 kg, center: [450, 0], inertia: 0.8 kg*m^2}
  barrel: {points: {H: [0, 0]}}
  stem:   {points: {K: [0, 0]}}
joints:
  O: {pin: [ground, arm], angle: alpha}
  H: {pin: [ground, barrel], angle: beta}
  S: {slide: [barrel, stem], along: x, to: K, distance: s}
  K: {pin: [arm, stem]}
drives: {s: 400 mm + 50 mm/s * t}
start: {alpha: 10 deg, beta: 100 deg}
units: {length: mm, angle: deg, force: N}
""")
        table = self.good("balance", path).out
        self.assertIn("effort [N]", table)
        row = re.search(r"before +(\S+) +(\S+) +(\S+)", table)
        self.assertAlmostEqual(float(row.group(3)) / self.good("balance", path, "--format", "json").json()["before"]["torque"], 1, 5)

    def test_balance_compromises(self):
        path = os.path.join(ROOT, "examples", "crank-press.yaml")
        answer = self.good("balance", path, "--weights", "1,0,0", "--format", "json").json()
        self.assertFalse(answer["full"])
        self.assertLess(answer["after"]["force"], answer["before"]["force"])
        self.assertIn("compromise", self.good("balance", path, "--weights", "1,0.5,0").out)
        for word in ("1,2", "0,0,0", "1,2,3,4", "1,-1,0", "a,b,c", "1,,0"):
            self.wrong(806, "balance", path, "--weights", word)

    def test_centrodes(self):
        path = os.path.join(ROOT, "examples", "four-bar.yaml")
        drawn = self.good("draw", path, "--centrodes", "crank,rocker").out
        self.assertIn('class="centrode" data-body="crank"', drawn)
        self.assertIn('class="centrode" data-body="rocker"', drawn)
        self.assertIn('class="centrode" data-body="ground"', self.good("draw", path, "--centrodes", "coupler").out)
        self.wrong(401, "draw", path, "--centrodes", "crank,nothing")
        self.wrong(806, "draw", path, "--centrodes", "crank", "--animate", "a.svg")
        self.wrong(806, "draw", path, "--centrodes", "crank", "--polygon", "velocity")
        self.assertEqual(Run("draw", path, "--centrodes", "crank,crank").code, 1)

    def test_force_polygons(self):
        path = os.path.join(ROOT, "examples", "crank-press.yaml")
        answer = self.good("solve", path, "--polygon", "force", "--format", "json").json()["configurations"][0]
        sums, reactions = {}, 0
        for v in answer["polygon"]["vectors"]:
            total = sums.setdefault(v["body"], [0, 0])
            for axis in range(2):
                self.assertAlmostEqual(v["start"][axis], total[axis], delta=1e-9)
                total[axis] += v["value"][axis]
            if v["part"] == "reaction":
                told = answer["reactions"][v["name"]]
                sign = 1 if told["on"] == v["body"] else -1
                self.assertEqual(v["value"], [sign * x for x in told["force"]])
                reactions += 1
        self.assertGreater(reactions, 5)
        size = max(abs(x) for v in answer["polygon"]["vectors"] for x in v["value"])
        for total in sums.values():
            self.assertLess(max(map(abs, total)), 1e-10 * size)
        self.assertEqual([s.split(":")[0] for s in answer["polygon"]["steps"]], list(sums))
        told = self.good("solve", path, "--polygon", "force").out
        for body in sums:
            self.assertIn(". %s: " % body, told)
        self.assertIn("force polygons", self.good("draw", path, "--polygon", "force").out)
        light = os.path.join(ROOT, "examples", "four-bar.yaml")
        for verb in ("solve", "draw"):
            self.assertEqual(Run(verb, light, "--polygon", "force").code, 2)

    def test_new_writes_tasks_that_work(self):
        self.write("four-bar.yaml", self.good("new", "four-bar").out)
        for kind in ("path", "motion", "function", "stroke", "machine"):
            path = self.write(kind + ".yaml", self.good("new", "--task", kind).out)
            self.assertEqual(self.good("synthesize", path, "--format", "json").json()["synthesis"], kind)


if __name__ == "__main__":
    unittest.main()
