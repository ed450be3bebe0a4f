"""yoke gears: its formats against each other, the examples against the books, and speeds against `solve`."""
import json
import math
import os
import unittest
from fractions import Fraction

from harness import Case, ROOT, Run


def example(name):
    return os.path.join(ROOT, "examples", name + ".yaml")


def gears(name, *words):
    return Run("gears", example(name), *words)


class Gears(Case):
    def answer(self, name, *words):
        run = gears(name, *words, "--format", "json")
        self.assertEqual(run.code, 0, run.err)
        return run.json()

    def check(self, case):
        words = [word for key in ("in", "out", "lock") if key in case for word in ("--" + key, case[key])]
        answer = self.answer(case["file"], *words)
        for body, exact in case.get("bodies", {}).items():
            self.assertEqual(answer["bodies"][body]["exact"], exact, case["file"])
        for body, shares in case.get("formulas", {}).items():
            for name, formula in shares.items():
                self.assertEqual(answer["bodies"][body]["shares"][name]["formula"], formula)
        for lock, exact in case.get("shift_table", {}).items():
            ratio = answer["shift_table"][lock]["ratio"]
            self.assertEqual(ratio["exact"], exact)
            self.assertAlmostEqual(ratio["value"], float(Fraction(exact)), delta=1e-15 * 5)
            self.assertAlmostEqual(ratio["value"], case["published"][lock], delta=6e-5)
        if "ratio" in case:
            self.assertEqual(answer["ratio"]["exact"], case["ratio"])
        for name, torque in case.get("torques", {}).items():
            found = [t["torque"] for t in answer["torques"] if t["name"] == name]
            self.assertEqual(len(found), 1)
            self.assertAlmostEqual(found[0], torque, delta=1e-9)

    def test_examples_have_their_published_answers(self):
        with open(os.path.join(ROOT, "examples", "expected", "gears", "trains.json"), encoding="utf-8") as file:
            for case in json.load(file):
                with self.subTest(case["file"]):
                    self.check(case)

    def test_formulas_give_the_exact_shares(self):
        for name, words in (("epicyclic", []), ("ferguson", []), ("reverted-train", ["--lock", "fixed"]),
                            ("two-rings", ["--lock", "A-fixed"]), ("epicyclic-drive", ["--lock", "held"])):
            answer = self.answer(name, *words)
            teeth = {}
            for mesh in answer["meshes"].values():
                teeth.update(zip(mesh["symbols"], (Fraction(z) for z in mesh["teeth"])))
            for body in answer["bodies"].values():
                for share in body["shares"].values():
                    value = eval(share["formula"], {"__builtins__": {}}, dict(teeth))  # our own output: + - * / and names
                    self.assertEqual(value, Fraction(share["exact"]), share)

    def test_formulas_of_a_shift_table_give_its_ratios(self):
        answer = self.answer("gearbox-8hp70")
        teeth = {}
        for mesh in answer["meshes"].values():
            teeth.update(zip(mesh["symbols"], (Fraction(z) for z in mesh["teeth"])))
        for gear in answer["shift_table"].values():
            value = eval(gear["ratio"]["formula"], {"__builtins__": {}}, dict(teeth))
            self.assertEqual(value, Fraction(gear["ratio"]["exact"]))

    def test_speeds_are_those_of_the_engine(self):
        solved = Run("solve", example("epicyclic"), "--format", "json")
        if solved.code != 0:
            self.skipTest("the engine does not turn gears")
        bodies = solved.json()["configurations"][0]["bodies"]
        for name, body in self.answer("epicyclic")["bodies"].items():
            self.assertAlmostEqual(body["speed"], bodies[name]["rate"], delta=1e-12)

    def test_csv_and_json_say_the_same(self):
        run = gears("epicyclic", "--format", "csv")
        lines = [line.split(",") for line in run.out.splitlines()]
        self.assertEqual(lines[0], ["body", "speed", "thetaC", "theta1"])
        answer = self.answer("epicyclic")
        for line in lines[1:]:
            self.assertEqual(float(line[1]), answer["bodies"][line[0]]["speed"])
        table = gears("gearbox-8hp70", "--format", "csv").out.splitlines()
        self.assertEqual(table[0], "lock,ratio")
        self.assertEqual(len(table), 10)

    def test_text_shows_all_the_methods(self):
        text = gears("epicyclic").out
        for part in ("460/29 rpm", "15.86207", "(sun - arm)*N1 = -(planet - arm)*N2", "Tabular method", "2 degrees of freedom",
                     "thetaC*(1 + N1*N3/(N2*N4)) - theta1*N1*N3/(N2*N4)", "0.063"):
            self.assertIn(part, text)
        text = gears("gearbox-8hp70").out
        self.assertIn("Shift table, input / output", text)
        self.assertIn("8826/6871", text)

    def test_parameters_change_the_teeth(self):
        run = gears("ferguson", "--param", "N3=120", "--format", "json")
        self.assertEqual(run.json()["bodies"]["sun3"]["exact"], "50/3 rpm")
        run = gears("ferguson", "--param", "N3=99.5")
        self.assertEqual(run.code, 2)
        self.assertIn("E0462", run.err)

    def test_power_goes_in_and_out(self):
        answer = self.answer("epicyclic-drive", "--lock", "held", "--out", "X", "--efficiency", "0.98")
        power = answer["power"]
        self.assertAlmostEqual(power["in"], 130e3, delta=1e-6)
        self.assertAlmostEqual(power["in"] - power["loss"], power["out"], delta=1e-6)
        self.assertTrue(0.96 < power["efficiency"] < 1)
        total = sum(t["torque"] for t in answer["torques"] if t["from"] == "ground")
        self.assertAlmostEqual(total, 0, delta=1e-9)

    def test_effort_replaces_the_files(self):
        answer = self.answer("epicyclic-drive", "--lock", "held", "--out", "X", "--effort", "theta=74N*m")
        load = [t for t in answer["torques"] if t["role"] == "load"][0]
        self.assertAlmostEqual(load["torque"], -74 * 21 / 16, delta=1e-11)

    def test_locked_and_open_trains_are_told(self):
        run = gears("epicyclic", "--param", "N1=27", "--format", "json")
        self.assertEqual(run.code, 0)
        run = gears("reverted-train")
        self.assertEqual(run.code, 1 if "E0516" in run.err else 0)
        with open(example("epicyclic"), encoding="utf-8") as file:
            text = file.read()
        open_train = self.write("open.yaml", text.replace("thetaC: 20 rpm * t, ", ""))
        run = Run("gears", open_train, "--format", "json")
        self.assertEqual((run.code, run.json()["status"]), (1, "undetermined"))
        self.assertIn("E0516", run.err)
        locked = self.write("locked.yaml", text.replace("drives: {", "drives: {theta4: 1 rpm * t, "))
        run = Run("gears", locked, "--format", "json")
        self.assertEqual((run.code, run.json()["status"]), (1, "locked"))
        self.assertIn("theta4", run.json()["message"])

    def test_wrong_requests_are_refused(self):
        for words, code in ((["--lock", "tenth"], "E0511"), (["--in", "moon"], "E0512"), (["--efficiency", "2"], "E0513"),
                            (["--effort", "nothing=1"], "E0814")):
            run = gears("gearbox-8hp70", *words)
            self.assertEqual((run.code, run.out), (2, ""))
            self.assertIn(code, run.err)
        run = Run("gears", self.four_bar)
        self.assertEqual(run.code, 2)
        self.assertIn("E0510", run.err)

    def test_numbers_are_finite(self):
        for name in ("simple-planetary", "gearbox-8hp70", "two-rings"):
            self.assertNotIn("nan", gears(name).out.lower())
            text = gears(name, "--format", "json").out
            self.assertFalse(math.isnan(len(json.loads(text))))


if __name__ == "__main__":
    unittest.main()
