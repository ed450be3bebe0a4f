"""yoke derive --format latex: every example compiles with article and amsmath; one run of LaTeX sees them all. What it and
MathML say is what the formulas say as plain text: worked out with numbers, side by side and entry by entry."""
import glob
import os
import re
import shutil
import subprocess
import unittest
import zlib

import mathml
from harness import Case, FULL, ROOT, Run, at_least, sampled, some

EXAMPLES = sorted(glob.glob(os.path.join(ROOT, "examples", "*.yaml")))
LATEX = shutil.which("pdflatex")

LATEX_TOKEN = re.compile(r"\\([a-zA-Z]+|.)|(\d[\d.]*)|([a-zA-Z])|(\S)")
TEXT_TOKEN = re.compile(r"([A-Za-z](?:[\w.]|[,-](?=\w))*(?:\^\{[^}]*\}|_\{[^}]*\})*)('*)|(\d[\d.]*(?:e[-+]?\d+)?)|\[([^\]]*)\]|(\S)")


def plain(name):
    """Without what LaTeX writes around it."""
    return re.sub(r"\\math[a-z]+|[_{}^,\\]", "", name)


def in_brackets(rows):
    """A matrix; a sum, which may stand in such brackets too, where it has one entry."""
    return [("sign", "("), *rows[0][0], ("sign", ")")] if len(rows) == len(rows[0]) == 1 else [("matrix", rows)]


def of_text(text):
    """A formula as plain text in tokens."""
    out = []
    for name, dots, number, matrix, sign in TEXT_TOKEN.findall(text):
        if name in mathml.FUNCTIONS:
            out.append(("function", name))
        elif name:
            out.append(("name", plain(name) + dots))
        elif number:
            out.append(("number", float(number)))
        elif matrix:
            out += in_brackets([[of_text(cell) for cell in re.split("[,|]", row)] for row in matrix.split(";")])
        else:
            out.append(("sign", "*" if sign == "." else sign))
    return out


def group(text, at):
    """What stands in the braces at a place, and the place behind them."""
    depth, end = 1, at + 1
    while depth:
        depth += {"{": 1, "}": -1}.get(text[end], 0)
        end += 1
    return text[at + 1:end - 1], end


def of_latex(text):
    """The same of LaTeX."""
    out, at = [], 0
    while at < len(text):
        if text.startswith("\\left[\\begin{array}", at):
            _, start = group(text, at + len("\\left[\\begin{array}"))
            end = text.index("\\end{array}", start)
            rows = text[start:end].replace("\\hline", "").split("\\\\")
            out += in_brackets([[of_latex(cell) for cell in row.split("&")] for row in rows])
            at = end + len("\\end{array}\\right]")
            continue
        match = LATEX_TOKEN.match(text, at)
        if not match:
            at += 1
            continue
        word, number, letter, sign = match.groups()
        at = match.end()
        if word in ("frac", "tfrac"):
            over, at = group(text, at)
            under, at = group(text, at)
            out += [("sign", "(")] * 2 + of_latex(over) + [("sign", ")"), ("sign", "/"), ("sign", "(")] + of_latex(under) + [("sign", ")")] * 2
        elif word in mathml.FUNCTIONS:
            if word == "sqrt":
                inner, at = group(text, at)
                out += [("function", word), ("sign", "(")] + of_latex(inner) + [("sign", ")")]
            else:
                out.append(("function", word))
        elif word in ("left", "right", ",", ";", "quad"):
            continue
        elif word in ("cdot", "times"):
            out.append(("sign", "*") if word == "cdot" else ("name", "x"))
        elif number:
            out.append(("number", float(number)))
        elif word or letter:
            name, dots = letter or word, ""
            if word in ("dot", "ddot", "mathrm", "mathit", "mathbf", "boldsymbol"):
                inner, at = group(text, at)
                name, dots = inner, {"dot": "'", "ddot": "''"}.get(word, "")
            bold = word in ("mathbf", "boldsymbol")
            while text.startswith("_{", at) or (bold and text.startswith("^{", at)):
                inner, at = group(text, at + 1)
                name += inner
            out.append(("name", plain(name) + dots))
        elif sign == "^":
            inner, at = group(text, at)
            out += [("sign", "^"), ("sign", "(")] + of_latex(inner) + [("sign", ")")]
        elif sign not in "{}":
            out.append(("sign", {"[": "(", "]": ")"}.get(sign, sign)))
    return out


def of_mathml(tokens):
    """The same of what `mathml` reads."""
    out = []
    for kind, what in tokens:
        if kind == "matrix":
            if out and out[-1] == ("sign", "["):
                out.pop()
            out += in_brackets([[of_mathml(cell) for cell in row] for row in what])
        elif (kind, what) == ("sign", "]") and out and out[-1][0] == "matrix" or (kind, what) == ("sign", ""):
            continue
        else:
            out.append((kind, plain(what) if kind == "name" else what))
    return out


def cuts_of_latex(text):
    """Of each matrix: before which rows it has a line, and columns."""
    found = []
    for spec, body in re.findall(r"\\begin\{array\}\{([c|]*)\}(.*?)\\end\{array\}", text, re.S):
        found.append(([k for k, row in enumerate(body.split("\\\\")) if "\\hline" in row],
                      [spec[:at].count("c") for at, sign in enumerate(spec) if sign == "|"]))
    return found


def cuts_of_mathml(text):
    """The same; a cell has the line below or beside it."""
    found = []
    for table in re.findall("(?s)<mtable>(.*?)</mtable>", text):
        cells = [re.findall('<mtd(?: class="([br ]*)")?>', row) for row in re.findall("(?s)<mtr>(.*?)</mtr>", table)]
        lines = ([k + 1 for k, row in enumerate(cells) if any("b" in cell for cell in row)],
                 [k + 1 for k in range(len(cells[0])) if any("r" in row[k] for row in cells)])
        whole = all(("b" in cell, "r" in cell) == (i + 1 in lines[0], k + 1 in lines[1]) for i, row in enumerate(cells) for k, cell in enumerate(row))
        found.append(lines if whole else None)
    return found


class Symbols(dict):
    """Every name has a number of its own."""

    def get(self, name, _=None):
        return self[name]

    def __missing__(self, name):
        return mathml.Number(0.5 + zlib.crc32(name.encode()) / 2**32)


def values(tokens):
    """Of the sides and entries in order; None where a side is none."""
    found, side = [], []
    for token in tokens + [("sign", "=")]:
        if token[0] == "matrix":
            found += [value for row in token[1] for cell in row for value in values(cell)]
        elif token[1] in ("=", ","):
            try:
                found += [mathml.Reader(side, Symbols()).value()] if side else []
            except (mathml.Unknown, OverflowError, ZeroDivisionError, ValueError):
                found.append(None)
            side = []
        else:
            side.append(token)
    return found


def displayed(document):
    """The formulas of a document as they were before lines were broken and wide parts set below under numbers."""
    found = []
    for one, broken in re.findall(r"\\\[\n(.*?)\n\\\]\n|\\begin\{multline\*\}\n(.*?)\n\\end\{multline\*\}", document, re.S):
        text = re.sub(r" \\\\\n ?", " ", one or broken)
        below = re.split(r"(?: ,\\quad )?\\boxed\{(\d+)\} = ", text) if text.startswith("\\boxed") else [text]
        found += below if len(below) == 1 else []
        for number, part in zip(below[1::2], below[2::2]):
            found[-1] = found[-1].replace("\\boxed{%s}" % number, part)
    return found


class Meaning(Case):
    def test_text_latex_and_mathml_are_one_value(self):
        """Every sixth example in the gate."""
        compared = marked = cut = 0
        for example in sampled(EXAMPLES, 2)[::1 if FULL else 2]:
            answer = Run("derive", example, "-q", "--format", "json")
            sections = answer.json()["sections"] if answer.out else []
            items = [item for section in sections for item in section["items"] if item["kind"] == "formula"]
            document = Run("derive", example, "-q", "--format", "latex").out
            self.assertEqual(displayed(document), [item["latex"] for item in items], example)
            page = re.findall("(?s)<math.*?</math>", Run("derive", example, "-q", "--format", "mathml").out)
            self.assertEqual(len(page), len(items), example)
            for item, drawn in zip(items, page):
                where = (os.path.basename(example), item["text"], item["latex"])
                for word in re.findall(r"\\mathrm\{([^}]*)\}", item["latex"]):  # letters are slanted, with their number below
                    self.assertNotRegex(word, r"^[A-Za-z]\d*$", where)
                    self.assertNotRegex(word, r"^\d+$", where)
                cuts = [(matrix.get("row_cuts", []), matrix.get("column_cuts", [])) for matrix in item.get("matrices", [])]
                self.assertEqual((cuts_of_latex(item["latex"]), cuts_of_mathml(drawn)), (cuts, cuts), where)
                cut += sum(len(rows) + len(columns) for rows, columns in cuts)
                if "\\text{" in item["latex"]:
                    continue
                self.assertEqual(item["latex"].count("("), drawn.count("<mo>(</mo>"), (where, drawn))
                sides = mathml.formula(drawn)
                third = values(sum(([("sign", "=")] + of_mathml(side) for side in sides), [])[1:])
                text, latex = values(of_text(item["text"])), values(of_latex(item["latex"]))
                self.assertEqual(len(third), len(text), where)
                for a, b in zip(text, third):
                    if a is not None and b is not None:
                        self.assertLessEqual(abs(a.value - b.value), a.error + b.error + 1e-12, (where, drawn))
                        marked += 1
                self.assertEqual([a is None for a in text], [b is None for b in latex], where)
                for a, b in zip(text, latex):
                    if a is not None:
                        self.assertLessEqual(abs(a.value - b.value), a.error + b.error + 1e-12, where)
                        compared += 1
        self.assertGreater(compared, at_least(3000))
        self.assertGreater(marked, at_least(2500))
        self.assertGreater(cut, at_least(16))


def letters(latex):
    """About how many are in print: one for a Greek letter, three for a cosine."""
    bare = re.sub(r"\\(left|right|t?frac|d*dot|mathrm|mathit|[,;])", "", latex)
    return len(re.sub(r"[\s{}^_]", "", re.sub(r"\\[a-z]+", "x", re.sub(r"\\(cos|sin)", "cos", bare))))


NUMBER = r"-?\d+\.?\d*(?:e[-+]?\d+)?"


def numbers_in_text(page):
    """Of each matrix that a page shows twice, the second one, which is of numbers, entry by entry."""
    found, block, at = [], [], None
    for line in page.splitlines() + [""]:
        last = re.search(r"\[ ([^\[\]]*) \](?: ,.*)?$", line)
        if not last or last.start() != at:
            if len({line.count("[ ") for line, _ in block} | {1}) == 1 and any(line.endswith("] = ") for line, _ in block):
                found += [float(number) for _, row in block if "---" not in row for number in re.findall(NUMBER, row)]
            block, at = [], last.start() if last else None
        if last:
            block.append((line[:at], last.group(1)))
    return found


class Numbers(Case):
    def test_they_stand_beside_their_formulas_alike_in_all_formats(self):
        """As many and the same as in JSON, to six digits, behind the formula and a sign of equality."""
        for name in ("quick-return", "planetary-gear", "double-pendulum"):
            words = ("derive", os.path.join(ROOT, "examples", name + ".yaml"), "-q", "--format")
            sections = self.good(*words, "json", "--numbers").json()["sections"]
            items = [item for section in sections for item in section["items"] if item["kind"] == "formula"]
            latex = displayed(self.good(*words, "latex", "--numbers").out)
            page = self.good(*words, "mathml", "--numbers").out
            marked = re.findall("(?s)<math.*?</math>", page)
            headings = [item["text"] for section in sections for item in section["items"] if item["kind"] == "heading"]
            self.assertEqual(re.findall("<h2>(.*?)</h2>", page), [section["title"] for section in sections])
            self.assertEqual(re.findall("<h3>(.*?)</h3>", page), headings)
            text = self.good(*words, "text", "--numbers").out
            self.assertEqual([len(items)] * 2, [len(latex), len(marked)], name)
            matrices = []
            for item, one, two in zip(items, latex, marked):
                values = [value for matrix in item.get("matrices", []) for row in matrix.get("values", []) for value in row]
                if not values and "value" in item:
                    values = [item["value"]]
                if len(item.get("matrices", [])) > 1:  # a whole system, whose numbers are in JSON alone
                    values = []
                elif item.get("matrices") and values:
                    matrices += values
                self.assertTrue(one.startswith(item["latex"] + (" = " if values else "")), (item["text"], one))
                self.alike(re.findall(r"(?<=[ &])%s(?= |$)" % NUMBER, one[len(item["latex"]):]), values, item["text"])
                bold = re.findall('font-weight:bold">(.*?)</mi>', two), re.findall(r"\\(?:mathbf|boldsymbol)\{\\?(.*?)\}", one)
                self.assertEqual(["".join(mathml.GREEK.get(c, c) for c in name) for name in bold[0]], bold[1], item["text"])
                if not values:
                    continue
                beside = re.findall("(<mo>-</mo>)?<mn>(.*?)</mn>", two.rpartition("<mo>=</mo>")[2])
                self.alike([("-" if sign else "") + number for sign, number in beside], values, item["text"])
                if not item.get("matrices"):
                    shown = re.search(r"(?m)%s = (%s)(?:  .*)?$" % (re.escape(item["text"]), NUMBER), text)
                    self.alike([shown.group(1)], values, item["text"])
            self.alike(numbers_in_text(text), matrices, name)
            named = [item["matrices"][0] for item in items if len(item.get("matrices", [])) == 1 and "columns" in item["matrices"][0]]
            words = re.findall(r"(?m)^ {6}columns: (.*)\n {6}rows: (.*)$", text)
            self.assertEqual(len(words), len(named))
            for both, matrix in zip(words, named):
                for line, of in zip(both, ("column", "row")):
                    parts = line.split(", ")
                    self.assertEqual([k + 1 for k, part in enumerate(parts) if part.endswith(" |")], matrix.get(of + "_cuts", []))
                    self.assertEqual([part.removesuffix(" |") for part in parts], matrix[of + "s"])
            self.assertGreater(len(matrices), 30)

    def alike(self, shown, values, where):
        self.assertEqual(len(shown), len(values), (where, shown, values))
        for number, value in zip(shown, values):
            self.assertAlmostEqual(float(number), value, delta=5.1e-6 * abs(value) + 1e-14, msg=where)


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
            for line, after in zip(lines, lines[1:] + [""]):  # as long as they may be, and no longer
                self.assertLess(letters(line), 115)
                if after:
                    self.assertGreater(letters(line) + letters(re.match("[-+=] .*?(?= [-+=] |$)", after).group()), 90)


if __name__ == "__main__":
    unittest.main()
