"""yoke check --sketch: the parts that a machine lacks to move, and the changes that supply them. Run: YOKE=path/of/yoke python3 tests/cli/test_sketch.py"""
import glob
import os
import unittest

from harness import Case, ROOT, Run, some

BODIES = """\
name: Sketch of a four-bar
bodies:
  ground: {points: {O: [0, 0], C: [1, 0]}}
  crank: {points: {O: [0, 0], A: [0.3, 0]}}
  coupler: {points: {A: [0, 0], B: [0.9, 0]}}
  rocker: {points: {C: [0, 0], B: [0.7, 0], E: [0.1, 0.2]}}
"""
JOINTS = {"O": "{pin: [ground, crank], angle: u}", "A": "{pin: [crank, coupler]}", "C": "{pin: [ground, rocker]}",
          "B": "{pin: [coupler, rocker]}"}


def text_of(parts):
    """A model file of these parts, each a value by its path: joints/O."""
    text = BODIES
    for section in "joints", "drives":
        own = [path.split("/")[1] + ": " + value for path, value in parts.items() if path.startswith(section)]
        text += section + ":\n" + "".join("  " + line + "\n" for line in own) if own else ""
    return text


class Sketches(Case):
    def sketch(self, parts):
        """What is said of these parts, as JSON; the text says the same."""
        path = self.write("sketch.yaml", text_of(parts))
        answer = self.good("check", "--sketch", path, "--format", "json").json()
        text = self.good("check", "--sketch", path).out
        self.assertIn("; %d degree" % answer["freedom"], text)
        self.assertIn("  %d bodies beside the ground, %d joint" % (3, sum(name.startswith("joints") for name in parts)), text)
        needed, _, optional = text.partition("\nWhat could be added\n")
        self.assertEqual("It lacks nothing to move." in needed, answer["moves"])
        self.assertEqual("What it lacks to move" in needed, any(not lack["optional"] for lack in answer["lacks"]))
        for lack in answer["lacks"]:
            told = optional if lack["optional"] else needed
            count = " (%d degree%s of freedom)" % (lack["freedom"], "s"[:lack["freedom"] != 1]) if lack["freedom"] else ""
            self.assertIn("\n  " + lack["message"] + count + "\n    " + lack["mend"] + "\n", "\n" + told)
            if lack["path"]:
                self.assertIn("%s: {%s: %s}" % (*lack["path"].split("/"), lack["value"]), lack["mend"])
        return answer

    def mend(self, missing):
        """Leaves joints out and does what is advised, connections first, until the machine moves."""
        parts = {"joints/" + name: value for name, value in JOINTS.items() if name not in missing}
        for _ in range(2 * len(JOINTS)):
            answer = self.sketch(parts)
            self.assertEqual(answer["freedom"], 9 - 2 * sum(name.startswith("joints") for name in parts))
            if answer["moves"]:
                break
            mends = [lack for lack in answer["lacks"] if lack["path"] and lack["path"] not in parts]
            mends.sort(key=lambda lack: lack["kind"] == "drive")
            parts[mends[0]["path"]] = mends[0]["value"]
        self.assertTrue(answer["moves"], parts)
        solved = self.good("solve", self.path("sketch.yaml"), "--format", "json").json()
        self.assertEqual(solved["status"], "ok")
        self.assertEqual(answer["lacks"], [])
        return parts

    def test_doing_what_is_advised_makes_it_move(self):
        for missing in [], ["B"], ["A"], ["C"], ["A", "B"], ["B", "C"], ["A", "C"], ["A", "B", "C"]:
            with self.subTest(missing):
                parts = self.mend(missing)
                self.assertEqual(sum(name.startswith("drives") for name in parts), 1)
                self.assertEqual(sum(name.startswith("joints") for name in parts), len(JOINTS))

    def test_finished_machines_lack_nothing(self):
        moving = 0
        for path in some(sorted(glob.glob(os.path.join(ROOT, "examples", "*.yaml")))):
            answer = self.good("check", "--sketch", path, "--format", "json").json()
            whole = self.good("check", path, "--format", "json").json()
            self.assertEqual((answer["model"], answer["freedom"]), (whole["model"], whole["degrees"]["gruebler"] + whole["degrees"]["redundant"]), path)
            moving += answer["moves"]
            self.assertEqual([lack for lack in answer["lacks"] if not lack["optional"]] == [], answer["moves"], path)
        self.assertGreater(moving, 3)

    def test_what_is_wrong_is_refused(self):
        self.wrong(806, "check", "--sketch", self.four_bar, "--format", "csv")
        self.wrong(130, "check", "--sketch", self.path("no.yaml"))
        run = Run("check", "--sketch", self.write("wrong.yaml", text_of({"joints/O": "{pin: [ground, crnk]}"})))
        self.assertEqual((run.code, run.out), (2, ""))
        self.assertIn("crank", run.err)


if __name__ == "__main__":
    unittest.main()
