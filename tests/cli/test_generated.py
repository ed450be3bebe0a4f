"""yoke derive --format c: compiles without a word, and computes the engine's numbers."""
import glob
import os
import re
import shutil
import subprocess
import unittest

from harness import Case, FEW, ROOT, Run, at_least, sampled

EXAMPLES = sorted(glob.glob(os.path.join(ROOT, "examples", "*.yaml")))
STRICT = ["-std=c17", "-Wall", "-Wextra", "-Wpedantic", "-Wconversion", "-Werror"]
COMPILERS = [name for name in ("gcc", "clang") if shutil.which(name)]


def results(code):
    """Per function: its results' names and sizes, and the fields that it writes."""
    found = {}
    for name, parameters in re.findall(r"^void machine_(\w+)\(([^)]*)\);", code, re.M):
        if name == "constants":
            continue
        arrays = [(array, [int(size) for size in re.findall(r"\[(\d+)\]", sizes)])
                  for array, sizes in re.findall(r"double \*?(\w+)((?:\[\d+\])*)", parameters)]
        body = code[code.rindex("\nvoid machine_%s(" % name):]
        fields = re.findall(r"^    m->(\w+) = ", body[:body.index("\n}")], re.M)
        found[name] = arrays, fields
    return found


def driver(code):
    """A main that calls everything at the pose and prints NAME VALUE lines."""
    lines = ["#include <stdio.h>", "int main(void)", "{"]
    for name, (arrays, fields) in results(code).items():
        lines += ["    {", "        Machine m = machine_at_pose;", "        machine_constants(&m);"]
        words = ["&m"]
        for array, sizes in arrays:
            lines.append("        double %s%s;" % (array, "".join("[%d]" % size for size in sizes)))
            words.append(array if sizes else "&" + array)
        lines.append("        machine_%s(%s);" % (name, ", ".join(words)))
        for array, sizes in arrays:
            count = 1
            for size in sizes:
                count *= size
            lines.append("        for (int k = 0; k < %d; k++) printf(\"%s.%s %%.17g\\n\", ((double *)&%s)[k]);" % (count, name, array, array))
        lines += ["        printf(\"%s.%s %%.17g\\n\", m.%s);" % (name, field, field) for field in fields]
        lines.append("    }")
    return "\n".join(lines + ["}", ""])


def name_of(formula):
    """The C name of what stands on the left of the formula."""
    left = formula.split(" = ")[0]
    return re.sub(r"[^A-Za-z0-9]", "_", left.replace("^{", "_").replace("}", "").replace("''", "_accel").replace("'", "_rate"))


def expected(answer):
    """Per section and name: all values in the order of the page; and matrices by name."""
    values, matrices = {}, {}
    for section in answer["sections"]:
        name = section["name"].replace("-", "_")
        for item in section["items"]:
            if item["kind"] != "formula":
                continue
            value = item.get("value")
            if value is not None:
                values.setdefault((name, name_of(item["text"])), []).append(value if isinstance(value, list) else [value])
            blocks = [block["values"] for block in item.get("matrices", []) if "values" in block]
            left = "A" if item.get("remark") == "A xi = b" else name_of(item["text"])
            if left in ("J", "M", "h", "gamma", "A") and blocks:
                # M and h of a long chain are shown in the bodies' angles; the code is in the file's coordinates
                others = any(".angle" in column for column in item["matrices"][0].get("columns", []))
                if others or (left == "h" and (name, "M") not in matrices):
                    continue
                matrices[(name, left)] = blocks[0]
                if left == "A":
                    matrices[(name, "b")] = blocks[2]
    return values, matrices


class Generated(Case):
    def compile(self, code, name, compiler, *options):
        source = self.write(name + ".c", code)
        done = subprocess.run([compiler, *STRICT, source, *options], capture_output=True, check=False, encoding="utf-8")
        self.assertEqual((done.returncode, done.stderr), (0, ""), name)

    def outcome(self, code, name):
        binary = self.path(name + ".out")
        self.compile(code + driver(code), name, COMPILERS[0], "-o", binary, "-lm")
        found = {}
        for line in subprocess.run([binary], capture_output=True, check=True, encoding="utf-8").stdout.splitlines():
            key, value = line.split()
            found.setdefault(tuple(key.split(".")), []).append(float(value))
        return found

    def close(self, got, wanted, where):
        self.assertEqual(len(got), len(wanted), where)
        scale = max([1.0] + [abs(value) for value in wanted])
        for one, other in zip(got, wanted):
            self.assertLessEqual(abs(one - other), 1e-12 * scale, "%s: %r, %r" % (where, got, wanted))

    def compare(self, example):
        """Returns how many results were compared."""
        name = os.path.basename(example)[:-5]
        run = Run("derive", example, "-q", "--format", "c", "--numbers")
        if run.code == 1:  # does not close at its start, or is too large
            return 0
        self.assertEqual(run.code, 0, name + run.err)
        found = self.outcome(run.out, name)
        if len(COMPILERS) > 1:
            self.compile(run.out, name, COMPILERS[1], "-c", "-o", os.devnull)
        values, matrices = expected(self.good("derive", example, "-q", "--format", "json", "--numbers").json())
        count = 0
        for key, got in found.items():
            if matrices.get((key[0], key[1].rstrip("_"))):
                self.close(got, [x for row in matrices[(key[0], key[1].rstrip("_"))] for x in row], (name, key))
            elif key in values:
                self.close(got, values[key][0], (name, key))
            elif key[1] == "Phi":
                self.close(got, [0.0] * len(got), (name, key))
            else:
                continue
            count += 1
        return count

    def test_every_section_of_every_example_compiles_and_gives_the_engines_numbers(self):
        counts = {os.path.basename(example): self.compare(example) for example in sampled(EXAMPLES, 0)}
        share = 1 if FEW else len(EXAMPLES) / len(counts)
        self.assertGreater(share * sum(counts.values()), at_least(900))
        self.assertGreater(share * sum(1 for count in counts.values() if count), at_least(50))

    def test_loops_slides_and_gears_share_one_array_of_equations(self):
        example = self.path("beside.yaml")
        with open(example, "w", encoding="utf-8") as file:
            file.write("""bodies:
  ground: {points: {O: [0, 0], Q: [3, 0], R: [0, 4], W: [6, 1]}}
  crank: {points: {O: [0, 0], A: [1, 0]}}
  rod: {points: {A: [0, 0], B: [2.5, 0]}}
  rocker: {points: {Q: [0, 0], B: [2, 0]}}
  block: {points: {R: [0, 0]}}
  wheel: {points: {W: [0, 0]}}
joints:
  O: {pin: [ground, crank], angle: a}
  A: {pin: [crank, rod], angle: b}
  Q: {pin: [ground, rocker], angle: c}
  B: {pin: [rod, rocker]}
  R: {slide: [ground, block], along: 30 deg, from: R, distance: s}
  W: {pin: [ground, wheel], angle: w}
gears: {g: {mesh: [crank, wheel], teeth: [20, 40]}}
start: {a: 1, b: 5, c: 1.2, s: 0.5}
""")
        arrays, _ = results(self.good("derive", example, "-q", "--format", "c").out)["loops"]
        self.assertEqual([sizes for name, sizes in arrays if name == "Phi"], [[3]])  # two of the loop, one of the gear
        self.assertGreater(self.compare(example), 20)

    def test_a_function_is_called_with_fields_of_ones_own(self):
        example = os.path.join(ROOT, "examples", "quick-return.yaml")
        solved = self.good("solve", example, "--format", "json").json()["configurations"][0]["coordinates"]
        fields = {"l1": 0.75, "l2": 1.75, "l4": 2 / 3, "theta1_rate": solved["theta1"]["velocity"]}
        fields.update((name, solved[name]["position"]) for name in solved)
        code = self.good("derive", example, "--what", "velocity", "--format", "c").out
        code += """#include <stdio.h>
        int main(void)
        {
            Machine m = {%s};
            machine_constants(&m);
            machine_velocity(&m);
            printf("%%.17g %%.17g", m.d5_rate, m.k_d5);
        }
        """ % ", ".join(".%s = %r" % pair for pair in fields.items() if "double %s;" % pair[0] in code)
        binary = self.path("rates")
        self.compile(code, "rates", COMPILERS[0], "-o", binary, "-lm")
        rate, influence = map(float, subprocess.run([binary], capture_output=True, check=True).stdout.split())
        self.assertAlmostEqual(rate, solved["d5"]["velocity"], 12)
        self.assertAlmostEqual(influence, solved["d5"]["velocity"] / solved["theta1"]["velocity"], 12)

    def test_a_segment_of_a_cam_is_the_engines_lift(self):
        example = os.path.join(ROOT, "examples", "swing-cam.yaml")
        code = self.good("derive", example, "--what", "cam", "--format", "c").out
        solved = self.good("solve", example, "--at", "theta=0.8rad", "--rate", "theta=1rad/s", "--format", "json").json()
        arrays, _ = results(code)["cam"]
        lines = ["#include <stdio.h>", "int main(void)", "{", "    Machine m = {.theta = 0.8};", "    machine_constants(&m);"]
        lines += ["    double %s%s;" % (name, "".join("[%d]" % size for size in sizes)) for name, sizes in arrays]
        lines.append("    machine_cam(&m, %s);" % ", ".join(name if sizes else "&" + name for name, sizes in arrays))
        lines += ["    printf(\"%.17g %.17g\", swing_1b, swing_v_1b);", "}", ""]
        binary = self.path("lift")
        self.compile(code + "\n".join(lines), "lift", COMPILERS[0], "-o", binary, "-lm")
        lift, slope = map(float, subprocess.run([binary], capture_output=True, check=True).stdout.split())
        follower = solved["configurations"][0]["coordinates"]["phi"]
        self.assertAlmostEqual(lift, follower["position"], 14)
        self.assertAlmostEqual(slope, follower["velocity"], 14)

    def test_all_of_a_machine_is_there(self):
        code = self.good("derive", os.path.join(ROOT, "examples", "slider-crank.yaml"), "--format", "c").out
        for section in ("loops", "jacobian", "velocity", "acceleration", "free_bodies", "newton_euler", "energy", "lagrange"):
            self.assertRegex(code, r"(?m)^void machine_%s\(" % section)
        self.assertNotIn("machine_at_pose", code)


if __name__ == "__main__":
    unittest.main()
