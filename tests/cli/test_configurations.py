"""`yoke solve --all`: every configuration, whether there are others, and what is told where that is not known."""
import os
import unittest

from harness import ROOT, Case, Run


def example(name):
    return os.path.join(ROOT, "examples", name + ".yaml")


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
