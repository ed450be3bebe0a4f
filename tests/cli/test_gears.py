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

    def test_a_ratio_that_is_asked_for_leaves_drives_out(self):
        """The file drives the sun, the lock holds it: ring to arm has a ratio all the same, that of the file without drives."""
        with open(example("simple-planetary"), encoding="utf-8") as file:
            text = file.read()
        driven = self.write("driven.yaml", text + "drives: {theta_s: 100 rpm * t}\n")
        words = ("--lock", "sun-held", "--in", "ring", "--out", "arm")
        run = self.good("gears", driven, *words)
        self.assertEqual(run.out.count("the hold of `sun`"), 1)
        self.assertIn("Ratio ring / arm without the file's drives\n  27/17", run.out)
        still = self.write("still.yaml", text + "drives: {theta_c: 100 rpm * t}\n")
        self.assertIn("without the file's drives\n  infinite", self.good("gears", still, "--lock", "arm-held", "--in", "sun", "--out", "arm").out)
        ratio = self.good("gears", driven, *words, "--format", "json").json()["ratio"]
        self.assertEqual(ratio, self.answer("simple-planetary", *words)["ratio"])
        self.assertEqual(Run("gears", driven, "--lock", "sun-held").code, 1)

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


CASES = {c["id"]: c for c in json.load(open(os.path.join(ROOT, "tests", "validation", "cases.json"), encoding="utf-8"))["cases"]}
# Wheels on the ground's axis and arms; "wheel@arm" is pinned to the arm. Meshes: (wheel, teeth, wheel, teeth), the second a ring with "i".
KHURMI_GUPTA = {
    "KG13.1": ("A B C D", [("A", 20, "B", 50), ("B", 25, "C", 75), ("C", 26, "D", 65)], {"A": 975}, ["D"]),
    "KG13.4": ("A arm B@arm", [("A", 36, "B", 45)], [{"A": 0, "arm": 150}, {"A": -300, "arm": 150}], ["B"]),
    "KG13.6": ("A C arm B@arm", [("C", 32, "B", 20), ("B", 20, "A", 72, "i")], {"A": 0, "arm": 18}, ["C", "B"]),
    "KG13.7a": ("A D arm B@arm", [("A", 40, "B", 25), ("B", 25, "D", 90, "i")], {"A": -1, "D": "1/2"}, ["arm"]),
    "KG13.7b": ("A D arm B@arm", [("A", 40, "B", 25), ("B", 25, "D", 90, "i")], {"A": -1, "D": 0}, ["arm"]),
    "KG13.10": ("C G arm DE@arm", [("C", 50, "DE", 20), ("DE", 35, "G", 105, "i")], {"C": 110, "G": 0}, ["arm"]),
    "KG13.14": ("H C G arm KL@arm", [("H", 40, "KL", 20), ("KL", 30, "C", 90, "i"), ("arm", 50, "G", 80)], {"H": -400, "C": 0}, ["G"]),
    "KG13.16": ("A arm B@arm", [("A", 40, "B", 30)], {"A": -100, "arm": 100}, ["B"]),
}


def train(wheels, meshes, speeds, unit="rpm"):
    bodies = [word.split("@") for word in wheels.split()]
    lines = ["bodies: {%s}" % ", ".join("%s: {}" % body[0] for body in bodies), "joints:"]
    on = {body[0]: body[1] if len(body) > 1 else "ground" for body in bodies}
    lines += ["  J%s: {pin: [%s, %s], angle: theta_%s}" % (name, carrier, name, name) for name, carrier in on.items()]
    lines.append("gears:")
    for k, mesh in enumerate(meshes):
        carrier = next((on[w] for w in (mesh[0], mesh[2]) if on[w] != "ground"), "ground")
        lines.append("  m%d: {mesh: [%s, %s], teeth: [%d, %d], carrier: %s, internal: %s}" %
                     (k, mesh[0], mesh[2], mesh[1], mesh[3], carrier, "true" if len(mesh) > 4 else "false"))
    lines.append("drives: {%s}" % ", ".join("theta_%s: %s %s * t" % (name, speed, unit) for name, speed in speeds.items()))
    return "\n".join(lines) + "\n"


class KhurmiGupta(Case):
    """Trains of Khurmi and Gupta, ch. 13, whose layout the text gives, by `gears` and as formulas by `derive`."""

    def speeds(self, wheels, meshes, speeds, unit="rpm"):
        file = self.write("train.yaml", train(wheels, meshes, speeds, unit))
        answer = Run("gears", file, "--format", "json").json()["bodies"]
        derived = Run("derive", file, "--what", "gears", "--numbers", "--format", "json").json()["sections"][0]["items"]
        for name, body in answer.items():  # the formula's value is the speed
            values = [item["value"] for item in derived if item.get("remark") == name and "value" in item]
            self.assertTrue(values)
            for value in values:
                self.assertAlmostEqual(value, body["speed"], delta=1e-12 * (1 + abs(body["speed"])))
        return answer

    def test_the_published_speeds(self):
        rows = {row[0]: row[1] for row in CASES["GT-KG"]["check"]["rows"]["rows"]}
        for name, (wheels, meshes, runs, outputs) in KHURMI_GUPTA.items():
            found = []
            for speeds in runs if isinstance(runs, list) else [runs]:
                answer = self.speeds(wheels, meshes, speeds)
                found += [Fraction(answer[out]["exact"].split()[0]) for out in outputs]
            expected = [Fraction(text) for text in rows[name].split(" , ")]
            if name == "KG13.1":  # told without its sense; three meshes turn it round
                expected = [-x for x in expected]
            self.assertEqual(found, expected, name)

    def test_two_rings_at_speeds_in_turns(self):
        meshes = [("A", 12, "BC", 30), ("BC", 30, "E", 72, "i"), ("BC", 14, "D", 56, "i")]
        answer = self.speeds("A E D arm BC@arm", meshes, {"A": -60, "D": 300})
        row = next(row for row in CASES["GT-KG"]["check"]["rows"]["rows"] if row[0] == "KG13.11")
        for body, text in zip(("arm", "E"), row[2].split(" , ")):
            self.assertAlmostEqual(answer[body]["speed"], float(text), delta=1e-8)

    def test_torques_of_a_planetary_set(self):
        text = train("S E arm P@arm", [("S", 16, "P", 24), ("P", 24, "E", 64, "i")], {"S": 5, "E": 0})
        file = self.write("13-20.yaml", text + "efforts: {theta_S: 100 N*m}\n")
        answer = Run("gears", file, "--in", "S", "--out", "arm", "--format", "json").json()
        torques = {t["name"]: t["torque"] for t in answer["torques"]}
        self.assertEqual(answer["bodies"]["arm"]["exact"], "1 rpm")  # 5 turns of S for one of the arm
        self.assertAlmostEqual(abs(torques["theta_E"]), 400, delta=1e-9)


if __name__ == "__main__":
    unittest.main()
