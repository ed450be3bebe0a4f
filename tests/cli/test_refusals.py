"""What a verb refuses: a value out of range, an option without the one it needs, two that exclude each other, a file of the wrong kind, an
equation that cannot be read. Each is refused at once, with exit code 2, its code and a message that names what was given; nothing is
written. Run: YOKE=path/of/yoke python3 test_refusals.py"""
import os
import shlex
import unittest

from harness import Case, ROOT, Run, SAMPLED

# Of each case: the code, the command, and words of the message. A machine NAME is one of the gallery's.
CASES = """
403 solve four-bar --time soon | no parameter `soon`
807 solve four-bar --at theta2= | NAME=VALUE
321 solve four-bar --at theta2=1kg | must be an angle
502 solve four-bar --at thet=1 | no coordinate `thet`
806 solve four-bar --method lagrange | --method takes reduced or newton-euler
806 solve four-bar --polygon jerk | not `jerk`
806 solve four-bar --polygon velocity --format csv | --polygon is written as text or json
806 solve four-bar --centers --format csv | --centers are written as text or json
806 solve four-bar --format xml | not `xml`
818 solve four-bar --within 5s | needs --all
806 solve four-bar --all --within 0s | a time above 0
403 solve four-bar --all --within soon | no parameter `soon`
818 solve four-bar --solver paths | needs --all
806 solve four-bar --all --solver luck | not `luck`
817 solve four-bar --at theta2=1 --at theta2=2 | gives `theta2` twice
817 solve four-bar --time 1s --time 2s | given twice
807 solve four-bar --at theta2 | NAME=VALUE
804 solve four-bar --time | --time
805 solve four-bar --all=yes | --all
505 solve four-bar --of nothing | `nothing`
819 solve four-bar --of theta2.effort | mass
819 solve four-bar --polygon force | neither masses nor loads
809 solve four-bar kite | kite
808 solve | file
818 sweep four-bar | needs --over
812 sweep four-bar --over theta2 | NAME=FROM:TO
812 sweep four-bar --over theta2=0 | NAME=FROM:TO
502 sweep four-bar --over nothing=0:1 | no coordinate `nothing`
806 sweep four-bar --over theta2=0:90deg --steps 0 | whole number
806 sweep four-bar --over theta2=0:90deg --steps many | not `many`
706 sweep four-bar --over theta2=0:90deg --plot plot.txt | `plot.txt`
818 simulate pendulum | needs --to
806 simulate pendulum --to 0s | later than the start
806 simulate pendulum --to 1s --every 0s | greater than 0
806 simulate pendulum --to 1s --every 1e-12s | more than 1e7 rows
817 simulate pendulum --to 1s --every 1ms --steps 3 | give one
806 simulate pendulum --to 1s --method euler | not `euler`
806 simulate pendulum --to 1s --step 1ms | only --method rk4
806 simulate pendulum --to 1s --method rk4 --tol 1e-6 | no tolerance
806 simulate pendulum --to 1s --tol 1 | from 1e-15 to 0.1
403 simulate pendulum --to 1s --tol none | no parameter `none`
806 simulate pendulum --to 1s --method rk4 --step 0s | greater than 0
706 simulate pendulum --to 1s --plot plot.txt | `plot.txt`
505 simulate pendulum --to 1s --event nothing=1 | nothing
806 rest pendulum --starts 0 | whole number
818 study four-bar --vary b=110mm:130mm:3 | needs --of
818 study four-bar --of theta4 | needs
806 study four-bar --vary b=110mm --of theta4 | NAME=FROM:TO:N
806 study four-bar --vary b=110mm:130mm:0 --of theta4 | not `0`
806 study four-bar --vary b=1mm:2mm:9000 --vary a=1mm:2mm:9000 --of theta4 | more than 10 million
806 study four-bar --vary b=110mm:130mm:3 --of theta4 --format xml | jsonl, csv or npy
806 study four-bar --vary b=110mm:130mm:3 --of theta4 --threads 0 | whole number
817 study four-bar --vary b=110mm:130mm:3 --sample x --of theta4 | not both
818 draw four-bar --poses 3 | --poses needs --over
818 draw four-bar --to 1s | --to 1s needs --animate
818 draw four-bar --steps 3 | needs --animate
706 draw four-bar --animate moving.txt --to 1s | .svg, .gif, .mp4 or .webm
806 draw four-bar --animate moving.svg --to 1s -o other.svg | names its own file
806 draw four-bar --animate moving.svg --to 1s --polygon velocity | draws no polygon
806 draw four-bar --animate moving.svg --to 1s --centers | no instant centres
806 draw four-bar --animate moving.svg --to 1s --centrodes coupler | no centrodes
806 draw four-bar --animate moving.svg --to 0s | later than the start
706 draw four-bar -o picture.txt | .svg, .pdf or .png
806 draw four-bar --polygon velocity --centers | picture of its own
815 draw four-bar --trace coupler | coupler
401 draw four-bar --centrodes nobody | nobody
806 map four-bar --format csv | text or json
806 map four-bar --over theta2=0:1 | without a range
818 map four-bar --trace coupler.P | needs --plot
818 map four-bar --of theta4 | --plot FILE
818 map four-bar --pose theta2=1 | needs --reach
817 map four-bar --reach theta2=1 --plot map.svg | without --plot
806 map four-bar --tol 0.01 | two coordinates
817 map four-bar --over theta2 --at theta2=1 | --at cannot hold it
818 map four-bar --over theta2 --reach theta4=1 | theta2
818 map double-pendulum --over theta1,theta2 --trace rod.A | needs --plot
502 map five-bar --over nothing,theta1 --tol 2 | no coordinate `nothing`
806 map five-bar --over theta1,theta2 --tol 2 | 0.0001 to 0.1
817 map five-bar --over theta1,theta2 --at theta1=1 | --at cannot hold it
817 map five-bar --over theta1,theta2 --trace left.A --plot map.svg | without --trace
817 map five-bar --over theta1,theta2 --of phi1 --plot map.svg | without --of
817 map five-bar --over theta1,theta2 --reach theta1=1 | over one coordinate
815 map five-bar --over left.Z.x,left.Z.y | Z
551 cam four-bar | no `cams:`
550 cam valve-cam --cam nothing | nothing
706 cam valve-cam --profile outline.txt | .svg, .dxf or .csv
706 cam valve-cam --plot plot.txt | .svg, .pdf or .png
806 cam valve-cam --cutter 0mm | length must be greater than zero
559 cam valve-cam --limits width=3mm | pressure=ANGLE
806 cam valve-cam --limits pressure=0deg | greater than zero
558 cam valve-cam --compare cyclodal | did you mean `cycloidal`
806 cam valve-cam --compare """ + ",".join(["cycloidal"] * 17) + """ | up to 16
806 cam valve-cam --steps 0 | whole number
513 gears epicyclic --efficiency 2 | above 0 and up to 1
806 derive four-bar --what nothing | no part `nothing`
806 derive four-bar --format xml | mathml
806 report four-bar --format xml | html or pdf
806 report pendulum --to 0s | later than the start
806 code four-bar --prefix 1st | begins with a letter
806 code four-bar --format csv | text or json
806 balance rocking-four-bar --weights 1,2 | three numbers
806 balance rocking-four-bar --weights 1,-2,1 | three numbers
806 balance rocking-four-bar --format csv | text or json
806 balance rocking-four-bar --fluctuation 3 | between 0 and 2
806 balance rocking-four-bar --steps 0 | whole number
806 cognates four-bar --format csv | text or json
806 cognates four-bar --trace coupler.P --trace crank.A | one --trace at a time
806 check four-bar --sketch --format csv | text or json
806 new --task poem | path, motion
823 new for-bar | four-bar
816 explain E9999 | E9999
808 synthesize | task file
806 synthesize tasks/wiper --format csv | text or json
806 synthesize tasks/wiper --so-far | needs --format json
806 synthesize tasks/wiper --within soon | soon
806 synthesize tasks/wiper --within 0s | time span
806 synthesize tasks/wiper --seed none | whole number
806 studio - | cannot save
"""


def parse(line):
    """(code, words of the command, what the message says)."""
    command, _, said = line.partition(" | ")
    code, *words = shlex.split(command)
    for k, word in enumerate(words[1:3], 1):
        example = os.path.join(ROOT, "examples", word + ".yaml")
        if os.path.exists(example):
            words[k] = example
    return int(code), words, said


class Refusals(Case):
    def test_what_cannot_be_done_is_refused_at_once_in_words(self):
        before = sorted(os.listdir(self.folder))
        cases = CASES.strip().splitlines()
        for line in cases[::4] if SAMPLED else cases:
            code, words, said = parse(line)
            with self.subTest(line):
                run = self.wrong(code, *words, cwd=self.folder)
                self.assertIn(said, run.err)
                self.assertEqual(sorted(os.listdir(self.folder)), before)


# Equations that cannot be read, with what is said of each; a machine may have names of its own.
UNREADABLE = {
    "four-bar": [
        ("(theta2=0", "this bracket is never closed"), ("[theta2)=0", "`]` is expected here"), ("(theta2]=0", "`)` is expected here"),
        ("theta2)=0", "an operator or `=` is expected here"), ("theta2^x=0", "unknown name `x`"), ("theta2^0.5=0", "an exponent is a whole number"),
        ("theta2^99=0", "up to 32"), ("theta2^-99=0", "up to 32"), ("theta2^=0", "a quantity is expected before `=`"),
        ("sin^0(theta2)=0", "an exponent is a whole number"), ("sin^40(theta2)=0", "up to 32"), ("sin^2 theta2=0", "`(` is expected after `sin`"),
        ("sqrt((theta2=0", "this bracket is never closed"), ("sqrt(theta2", "this bracket is never closed"), ("sqrt(i)=0", "the root of"),
        ("sin=0", "`(` is expected after `sin`"), ("sin()=0", "a quantity is expected here"), ("=0", "a quantity is expected before `=`"),
        ("theta2=", "the equation ends where a quantity is expected"), ("theta2", "there is no `=`"), ("theta2=theta4 @", "an operator is expected here"),
        ("nothing=0", "unknown name `nothing`"), ("coupler.P.speed=0", "unknown name"), ("B.transmission=0", "unknown name"), ("F_x=0", "unknown name"),
        ("dtheta2=0", "unknown name"), ("x_P=0", "unknown name"), ("x_Z=0", "unknown name"), ("a=40 mm/s", "the right side a speed"),
        ("a = 40 kg", "the right side a mass"), ("sin(a)=0", "an angle is expected here"), ("exp(theta2)=0", "an angle here is a sum"),
        ("e^theta2=0", "unknown name `e`"), ("atan2(1,2)=0", "has many values"), ("1e400=0", "too large"), ("99999999999999999999=a", "too large"),
        ("\u03b8=0", "this sign cannot be used"), ("\"theta2\"=0", "a quantity is expected here"), ("theta2'''=0", "unknown name"),
        ("(" * 300 + "theta2" + ")" * 300 + "=theta2", "nested too deeply"),
    ],
    "valve-cam": [("alpha=0", "unknown name `alpha`"), ("rho=0", "unknown name `rho`"), ("intake=0", "unknown name `intake`")],
    "spring-slider-crank": [("k.force=0", "unknown name"), ("q.effort=0", "unknown name"), ("R_A=0", "unknown name")],
}
# True of any numbers; with another right side, of none.
IDENTITIES = [("theta2^(1+1)", "theta2^2"), ("theta2**2", "theta2^2"), ("theta2^-2", "theta2^(-2)"), ("sin^2(theta2) + cos^2(theta2)", "1"),
              ("tan(theta2)*cos(theta2)", "sin(theta2)"), ("sqrt(4)", "2"), ("sqrt(2/9)", "sqrt(2)/3"), ("2 mm", "0.002 m"), ("i^2", "-1"),
              ("sin(pi/6)", "1/2"), ("cos(60 deg)", "1/2"), ("pi", "180 deg"), ("a b", "b a"), ("2(a + b)", "2 a + 2 b"), ("a[b + b]", "2 a b"), (".5", "1/2"),
              ("a\tb", "a b"), ("((a))", "a"), ("-a - (-b)", "b - a"), ("a/(2 b)", "1/2*a/b"), ("coupler.P.x - coupler.P.x", "0 m")]


class Equations(Case):
    def answers(self, machine, code, equations):
        run = Run("derive", os.path.join(ROOT, "examples", machine + ".yaml"), "--check", "-", stdin="\n".join(equations) + "\n")
        self.assertEqual(run.code, code, run.err)
        said = [line for line in run.out.splitlines() if line.strip()]
        starts = [k for k, line in enumerate(said) if line in equations] + [len(said)]
        self.assertEqual(len(starts), len(equations) + 1)
        return [" ".join(said[start + 1:end]) for start, end in zip(starts, starts[1:])], run.err

    def test_what_cannot_be_read_is_told_with_its_place(self):
        for machine, cases in UNREADABLE.items():
            answers, told = self.answers(machine, 2, [equation for equation, _ in cases])
            for row, ((equation, said), answer) in enumerate(zip(cases, answers), 1):
                self.assertTrue(answer.startswith("  not understood: "), equation + answer)
                self.assertIn(said, answer, equation)
                self.assertRegex(told, r"standard input:%d:\d+: error: " % row)

    def test_identities_are_true_and_others_are_not(self):
        answers, told = self.answers("four-bar", 0, ["%s = %s" % sides for sides in IDENTITIES])
        for sides, answer in zip(IDENTITIES, answers):
            self.assertRegex(answer, r"^  true for all dimensions \(an identity", sides)
        answers, told = self.answers("four-bar", 1, ["%s = 3*(%s) + (%s)" % (left, left, right) for left, right in IDENTITIES[:-1]])
        for sides, answer in zip(IDENTITIES, answers):
            self.assertRegex(answer, r"^  false: ", sides)


if __name__ == "__main__":
    unittest.main(verbosity=2)
