"""`yoke solve --all`: every configuration, whether there are others, and the answer if that is not known."""
import os
import re
import unittest

from harness import ROOT, Case, Run


def example(name):
    return os.path.join(ROOT, "examples", name + ".yaml")


# A parallelogram, whose crank passes a change point, with a triad on its coupler.
TRIAD_ON_PARALLELOGRAM = """bodies:
  ground:  {points: {A: [0, 0], D: [3, 0], E: [6, 0], F: [5, 4]}}
  crank:   {points: {A: [0, 0], B: [1, 0]}}
  coupler: {points: {B: [0, 0], C: [3, 0], P: [1.5, 1]}}
  rocker:  {points: {D: [0, 0], C: [1, 0]}}
  leg:     {points: {P: [0, 0], Q: [3, 0]}}
  arm:     {points: {E: [0, 0], R: [2, 0]}}
  bar:     {points: {F: [0, 0], S: [2, 0]}}
  plate:   {points: {Q: [0, 0], R: [2, 0], S: [1, 1.5]}}
joints:
  A: {pin: [ground, crank], angle: theta}
  B: {pin: [crank, coupler], angle: b}
  D: {pin: [ground, rocker], angle: d}
  C: {pin: [coupler, rocker]}
  P: {pin: [coupler, leg], angle: p}
  E: {pin: [ground, arm], angle: e}
  F: {pin: [ground, bar], angle: f}
  Q: {pin: [leg, plate], angle: q}
  R: {pin: [arm, plate]}
  S: {pin: [bar, plate]}
drives: {theta: 60 deg}
start: {b: -60 deg, d: 60 deg, e: 120 deg, f: -120 deg, p: 20 deg, q: 0 deg}
"""


class Configurations(Case):
    def test_a_group_is_counted(self):
        answer = Run("solve", example("double-butterfly"), "--all", "--format", "json").json()
        self.assertEqual(len(answer["configurations"]), 8)
        self.assertIs(answer["complete"], True)
        self.assertEqual(answer["reason"], "counted")
        self.assertEqual(answer["complex"], {"proved": 16, "counted": 16})
        self.assertEqual(sum(c["is_start"] for c in answer["configurations"]), 1)
        text = Run("solve", example("double-butterfly"), "--all").out
        self.assertIn("8 configurations; there are no others: all 16 complex solutions", text)

    def test_every_configuration_has_its_own_name_and_can_be_taken_by_it(self):
        file = example("double-butterfly")
        answer = Run("solve", file, "--all", "--format", "json").json()
        labels = [c["label"] for c in answer["configurations"]]
        self.assertEqual(len(set(labels)), len(labels))
        for k, configuration in enumerate(answer["configurations"]):
            for word in (configuration["label"], str(k + 1)):
                taken = Run("solve", file, "--assembly", word, "--format", "json").json()["configurations"][0]
                self.assertEqual(taken["label"], configuration["label"])
                for name, motion in taken["coordinates"].items():
                    self.assertAlmostEqual(motion["position"], configuration["coordinates"][name]["position"], 9)

    def test_a_name_that_is_none_is_answered_with_those_there_are(self):
        there = {"double-pendulum": "there is only 1, which has no label", "rocking-four-bar": "there are 1: B+; 2: B-"}
        for name, hint in there.items():
            run = Run("rest", example(name), "--assembly", "X")
            self.assertEqual(run.code, 1)
            self.assertIn(hint + "\n", run.err)
            self.assertEqual(Run("rest", example(name), "--assembly", "1", "--starts", "2").code, 0)

    def test_the_way_to_a_pose_and_between_rows_is_certified(self):
        file, over = example("double-butterfly"), ("--over", "lambda=-10:30deg", "--steps", "6")
        answer = Run("sweep", file, *over, "--format", "json").json()
        self.assertIs(answer["certified"], True)
        trusted = Run("sweep", file, *over, "--trust", "--format", "json").json()
        self.assertIsNone(trusted["certified"])
        self.assertEqual(trusted["rows"], answer["rows"])
        self.assertIn("certified: proved to stay", Run("sweep", file, *over).out)
        self.assertNotIn("certified", Run("sweep", file, *over, "--trust").out)
        self.assertIs(Run("solve", file, "--at", "lambda=20deg", "--format", "json").json()["certified"], True)
        self.assertIn("\ncertified: proved", Run("solve", file, "--at", "lambda=20deg").out)
        self.assertNotIn("certified", Run("solve", file).out)
        self.assertIs(Run("sweep", self.four_bar, "--over", "theta2=0:90deg", "--format", "json").json()["certified"], True)
        self.assertNotIn("certified", Run("sweep", self.four_bar, "--over", "theta2=0:90deg").out)

    def test_what_is_not_certified_is_told(self):
        geared = Run("sweep", example("geared-five-bar"), "--over", "t=0:1s", "--steps", "4")
        self.assertIn("not certified: gears", geared.out)
        self.assertNotIn("W0616", geared.err)
        file = self.write("triad.yaml", TRIAD_ON_PARALLELOGRAM)
        run = Run("sweep", file, "--over", "theta=60:-30deg", "--steps", "9")
        self.assertIn("W0616", run.err)
        self.assertIn("2 of 54 steps are not proved", run.out)
        self.assertRegex(run.err, r"first between theta = 0\.029.* and 0 rad")
        over = ("sweep", file, "--over", "theta=60:10deg", "--format", "json")
        self.assertIs(Run(*over).json()["certified"], True)
        answer = Run("sweep", file, "--over", "theta=60:-30deg", "--steps", "9", "--format", "json").json()
        self.assertIs(answer["certified"], False)
        why = answer["not_certified"]
        self.assertEqual((why["steps"], why["proved"], why["refuted"], why["joint"], why["coordinate"]), (54, 52, False, "C", "theta"))
        self.assertIn("two solutions", why["why"])
        self.assertTrue(0 < why["from"] < 0.04 and why["to"] == 0, why)
        self.assertNotIn("not_certified", Run(*over).json())
        long = self.write("long.yaml", re.sub(r"\b(C|theta)\b", lambda word: 20 * word[0].ljust(5, "C"), TRIAD_ON_PARALLELOGRAM))
        why = Run("sweep", long, "--over", 20 * "theta" + "=60:-30deg", "--steps", "9", "--format", "json").json()["not_certified"]
        self.assertEqual((why["joint"], why["coordinate"]), (100 * "C", 20 * "theta"))
        why = Run("sweep", example("geared-five-bar"), "--over", "t=0:1s", "--steps", "4", "--format", "json").json()["not_certified"]
        self.assertEqual((why["proved"], why["coordinate"], why["from"]), (0, None, None))
        self.assertIn("gears", why["why"])

    def test_simulations_drawings_and_reports_are_certified(self):
        text = re.sub(r"(\n  (?!ground)\w+: +\{points: \{[^}]*\})\}", r"\1, mass: 1, inertia: 0.2, center: [0.5, 0.3]}", TRIAD_ON_PARALLELOGRAM)
        text = text.replace("drives: {theta: 60 deg}\n", "").replace("start: {", "start: {theta: 60 deg, ")
        file = self.write("triad.yaml", "gravity: [0, -9.81]\n" + text)
        good = Run("simulate", file, "--to", "0.5s", "--steps", "20", "--format", "json").json()
        self.assertIs(good["certified"], True)
        trusted = Run("simulate", file, "--to", "0.5s", "--steps", "20", "--trust", "--format", "json").json()
        self.assertIsNone(trusted["certified"])
        self.assertEqual(trusted["rows"], good["rows"])
        passes = Run("simulate", file, "--to", "1s", "--steps", "20", "--format", "json").json()
        self.assertIs(passes["certified"], False)
        why = passes["not_certified"]
        passage = next(e["time"] for e in passes["events"] if e["kind"] == "change-point")
        self.assertTrue(why["from_time"] < passage and why["joint"] == "C", (why, passage))
        run = Run("simulate", file, "--to", "1s", "--steps", "20")
        self.assertRegex(run.err, r"simulate: not certified: \d+ of \d+ steps")
        self.assertRegex(run.err, r"W0616")
        self.assertRegex(run.err, r"first between t = .* at joint `C`")
        self.assertIn("simulate: certified: proved to stay", Run("simulate", file, "--to", "0.5s", "--steps", "20").err)
        self.assertNotIn("certified", Run("simulate", self.four_bar_with_mass(), "--to", "0.1s").err)
        driven = self.write("driven.yaml", TRIAD_ON_PARALLELOGRAM)
        for words in (("draw", driven, "--poses", "5"), ("report", driven)):
            over = Run(*words, "--over", "theta=60:-30deg")
            self.assertIn("W0616", over.err, words)
            self.assertEqual(over.code, 0)
            self.assertNotIn("W0616", Run(*words, "--over", "theta=60:10deg").err)
            self.assertNotIn("W0616", Run(*words, "--over", "theta=60:-30deg", "--trust").err)
        self.assertIn("W0616", Run("report", file, "--to", "1s").err)
        self.assertNotIn("W0616", Run("report", file, "--to", "0.5s").err)

    def four_bar_with_mass(self):
        return example("four-bar-at-rest")

    def test_dyads_are_complete_in_closed_form(self):
        answer = Run("solve", self.four_bar, "--all", "--format", "json").json()
        self.assertIs(answer["complete"], True)
        self.assertEqual(answer["reason"], "closed form")
        self.assertNotIn("complex", answer)

    def test_a_group_with_a_gear_is_excluded(self):
        answer = Run("solve", example("geared-five-bar"), "--all", "--format", "json").json()
        self.assertEqual((answer["complete"], answer["reason"], len(answer["configurations"])), (True, "excluded", 10))
        self.assertNotIn("complex", answer)

    def test_what_is_searched_says_so(self):
        with open(example("geared-five-bar"), encoding="utf-8") as file:
            text = file.read().replace("mesh: [b, d], teeth: [20, 30]", "mesh: [b, d], teeth: [997, 991]")
        file = self.write("odd.yaml", text)
        answer = Run("solve", file, "--all", "--format", "json").json()
        self.assertIs(answer["complete"], False)
        self.assertIsNone(answer["reason"])
        self.assertIn("gears", answer["because"])

    def test_no_assembly_is_proved(self):
        run = Run("solve", example("stephenson-awkward"), "--all", "--at", "theta6=0", "--format", "json")
        self.assertEqual(run.code, 1)
        answer = run.json()
        self.assertEqual(answer["configurations"], [])
        self.assertIs(answer["complete"], True)
        self.assertEqual(answer["complex"], {"proved": 6, "counted": 6})
        self.assertIn("none closes the machine", answer["because"])

    def test_a_time_that_is_too_short_claims_nothing(self):
        answer = Run("solve", example("double-butterfly"), "--all", "--within", "1e-9 s", "--format", "json").json()
        self.assertIs(answer["complete"], False)
        self.assertIn("stopped", answer["because"])
        answer = Run("solve", example("double-butterfly"), "--all", "--within", "1h", "--format", "json").json()
        self.assertIs(answer["complete"], True)

    def test_both_solvers_give_the_same_answer(self):
        answers = []
        for solver in ("elimination", "paths", "both"):
            answer = Run("solve", example("double-butterfly"), "--all", "--solver", solver, "--format", "json").json()
            self.assertIs(answer["complete"], True)
            self.assertEqual(answer["complex"], {"proved": 16, "counted": 16})
            answers.append([(c["label"], {name: round(q["position"], 9) for name, q in c["coordinates"].items()}) for c in answer["configurations"]])
        self.assertEqual(len(answers[0]), 8)
        self.assertEqual(answers[0], answers[1])
        self.assertEqual(answers[0], answers[2])

    def test_bad_solvers_are_refused(self):
        for words, reason in ((("--all", "--solver", "newton"), "takes elimination, paths or both"), (("--solver", "paths"), "needs --all")):
            run = Run("solve", example("double-butterfly"), *words)
            self.assertEqual(run.code, 2, words)
            self.assertIn(reason, run.err)
            self.assertEqual(run.out, "")

    def side_by_side(self, count):
        """A file with so many dyads side by side on the ground: two to the power of that many configurations."""
        ground = ", ".join("A%d: [%d, 0], B%d: [%d, 0]" % (k, 3 * k, k, 3 * k + 1) for k in range(count))
        bodies, joints = ["  ground: {points: {%s}}" % ground], []
        for k in range(count):
            bodies.append("  a%d: {points: {A%d: [0, 0], C: [0.9, 0]}}" % (k, k))
            bodies.append("  b%d: {points: {B%d: [0, 0], C: [0.8, 0]}}" % (k, k))
            joints += ["  A%d: {pin: [ground, a%d]}" % (k, k), "  B%d: {pin: [ground, b%d]}" % (k, k),
                       "  C%d: {pin: [a%d, b%d], at: C}" % (k, k, k)]
        return self.write("side%d.yaml" % count, "\n".join(["bodies:"] + bodies + ["joints:"] + joints) + "\n")

    def test_beyond_ten_thousand_they_are_counted_and_the_first_shown(self):
        text = Run("solve", self.side_by_side(12), "--all", "--of", "a0.angle").out
        self.assertEqual(text.splitlines()[-1], "4096 configurations; there are no others")
        run = Run("solve", self.side_by_side(14), "--all", "--of", "a0.angle", "--format", "json")
        answer = run.json()
        self.assertEqual((len(answer["configurations"]), answer["count"], answer["complete"]), (10000, 16384, True))
        text = Run("solve", self.side_by_side(22), "--all", "--of", "a0.angle", "--within", "1e-6 s").out
        self.assertRegex(text.splitlines()[-1], "there may be others: not all combinations of branches were visited$")

    def test_a_continuum_is_told(self):
        answer = Run("solve", example("peaucellier"), "--all", "--format", "json").json()
        told = {c["label"]: c["continuum"]["dimension"] for c in answer["configurations"] if "continuum" in c}
        self.assertEqual(told, {"B+ C+ Q+": 1, "B- C- Q+": 1})  # B and C in one place: Q turns about it
        self.assertEqual((answer["continua"], answer["complete"], answer["reason"]), (2, False, None))
        text = Run("solve", example("peaucellier"), "--all").out
        self.assertIn("one of a continuum of dimension 1", text)
        self.assertIn("6 configurations; there are others: 2 of them stand for continua (largest dimension: 1)", text)

    def test_bad_times_are_refused(self):
        for words, code in ((("--all", "--within", "0s"), "E0"), (("--all", "--within", "-1s"), "E0"),
                            (("--all", "--within", "2mm"), "E0"), (("--all", "--within", "soon"), "E0"),
                            (("--within", "1s"), "needs --all")):
            run = Run("solve", example("four-bar"), *words)
            self.assertEqual(run.code, 2, words)
            self.assertIn(code, run.err)
            self.assertEqual(run.out, "")


if __name__ == "__main__":
    unittest.main()
