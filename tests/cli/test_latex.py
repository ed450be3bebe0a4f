"""yoke derive --format latex: every example compiles with article and amsmath; one run of LaTeX sees them all."""
import glob
import os
import re
import shutil
import subprocess
import unittest

from harness import Case, ROOT, Run, at_least, some

EXAMPLES = sorted(glob.glob(os.path.join(ROOT, "examples", "*.yaml")))
LATEX = shutil.which("pdflatex")


class Latex(Case):
    def document(self, name, *words):
        run = Run("derive", name, "-q", "--format", "latex", *words)
        self.assertIn(run.code, (0, 1), run.err)
        return run.out

    def compile(self, text):
        """The log of a run that must end well."""
        self.write("page.tex", text)
        done = subprocess.run([LATEX, "-interaction=nonstopmode", "-halt-on-error", "-draftmode", "page.tex"], cwd=self.folder,
                              capture_output=True, check=False, encoding="utf-8", errors="replace", timeout=300)
        log = self.read("page.log").decode("latin-1").replace("\n", "")
        self.assertEqual(done.returncode, 0, re.findall(r"! .{300}", log))
        return log

    @unittest.skipUnless(LATEX, "no pdflatex")
    def test_all_examples_compile_as_one_document(self):
        documents = [self.document(example, "--numbers") for example in some(EXAMPLES)]
        documents = [text for text in documents if text]
        head = documents[0].split("\\begin{document}")[0]
        self.assertEqual(re.findall(r"\\usepackage\{(.*?)\}", head), ["amsmath"])
        bodies = []
        for text in documents:
            own, rest = text.split("\\begin{document}")
            self.assertEqual(own, head)
            body, after = rest.split("\\end{document}")
            self.assertEqual(after, "\n")
            bodies.append(body)
        self.assertGreater(len(bodies), at_least(50))
        log = self.compile(head + "\\begin{document}\n" + "\\clearpage\n".join(bodies) + "\\end{document}\n")
        self.assertNotIn("undefined", log)
        self.assertNotIn("Missing character", log)
        wide = [float(width) for width in re.findall(r"Overfull \\hbox \(([0-9.]+)pt too wide\)", log)]
        formulas = sum(text.count("\\[\n") + text.count("\\begin{multline*}") for text in bodies)
        self.assertGreater(formulas, at_least(3000))
        self.assertEqual(wide, [])

    @unittest.skipUnless(LATEX, "no pdflatex")
    def test_long_formulas_break_inside_of_brackets_and_over_pages(self):
        count, bodies, joints = 14, [], []
        for k in range(1, count + 1):
            bodies.append("  b%d: {points: {P%d: [0, 0], P%d: [l%d, 0]}, mass: m%d, center: [x%d, y%d], inertia: I%d}"
                          % (k, k, k + 1, k, k, k, k, k))
            joints.append("  P%d: {pin: [%s, b%d], angle: q%d}" % (k, "b%d" % (k - 1) if k > 1 else "ground", k, k))
        values = ", ".join("l%d: 1 m, m%d: 2 kg, x%d: 0.4 m, y%d: 0.1 m, I%d: 0.2" % (k, k, k, k, k)
                           for k in range(1, count + 1))
        name = self.write("arm.yaml", "parameters: {%s, g: 9.81}\ngravity: [0, -g]\nbodies:\n  ground: {points: {P1: [0, 0]}}\n"
                          "%s\njoints:\n%s\n" % (values, "\n".join(bodies), "\n".join(joints)))
        log = self.compile(self.document(name, "--what", "energy,lagrange"))
        self.assertEqual(re.findall(r"Overfull \\[hv]box \(([0-9.]+)pt", log), [])

    @unittest.skipUnless(LATEX, "no pdflatex")
    def test_names_with_signs_of_latex_and_other_letters(self):
        name = self.write("odd.yaml", self.read("four-bar.yaml").decode("utf-8").replace(
            "Test four-bar", "'100% _#$&{}~^\\\\ <Krümmer> \"θ日\" |'"))
        self.compile(self.document(name))

    def test_what_is_too_wide_stands_below_under_a_number(self):
        text = self.document(os.path.join(ROOT, "examples", "toggle.yaml"), "--what", "newton-euler")
        matrix = re.search(r"\\left\[\\begin\{array\}\{c{20}\}(.*?)\\end\{array\}", text, re.S).group(1)
        numbers = sorted({int(number) for number in re.findall(r"\\boxed\{(\d+)\}", matrix)})
        self.assertEqual(numbers, list(range(1, numbers[-1] + 1)))
        below = text[text.index(matrix) + len(matrix):]
        for number in numbers:  # each is said once; equal entries have one number
            self.assertEqual(below.count("\\boxed{%d} = " % number), 1)
        parts = [re.search(r"\\boxed\{%d\} = (.*?)(?: ,\\quad|\n)" % number, below).group(1) for number in numbers]
        self.assertEqual(len(set(parts)), len(parts))
        rows = [row.split(" & ") for row in matrix.strip().split(" \\\\ ")]
        self.assertEqual([len(row) for row in rows], [20] * 20)
        entry = re.fullmatch(r"\\boxed\{(\d+)\}", rows[2][0].strip()).group(1)  # the arm of F01x about the centre of link1
        self.assertEqual(parts[int(entry) - 1], "\\tfrac{1}{2} l_{1} \\sin(\\theta_{1})")

    def test_long_sums_break_before_their_signs(self):
        text = self.document(os.path.join(ROOT, "examples", "toggle.yaml"), "--what", "lagrange")
        blocks = re.findall(r"\\begin\{multline\*\}\n(.*?)\n\\end\{multline\*\}", text, re.S)
        self.assertGreater(len(blocks), 2)
        for block in blocks:
            lines = block.split(" \\\\\n")
            self.assertGreater(len(lines), 1)
            for line in lines[1:]:
                self.assertIn(line[:2], ("+ ", "- ", "= "))


if __name__ == "__main__":
    unittest.main()
