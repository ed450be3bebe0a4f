"""yoke code: the status of the printed C for inputs that are not numbers, or too large, in every place."""
import os
import random
import re
import subprocess
import unittest

from harness import FULL, ROOT
from test_code import FOLLOWERS, Printed, name_of, random_train
from test_locks import PLANETARY

# Open, closed by each kind of dyad, by Newton's method; with constraints that repeat others; gears, racks, cams; loads of time.
MACHINES = ["double-pendulum", "cart-pendulum", "excavator", "four-bar", "andrews", "quick-return", "slider-crank", "scotch-yoke",
            "elliptic-trammel", "five-bar", "double-butterfly", "three-crank-parallelogram", "doubled-guide", "geared-five-bar",
            "epicyclic-drive", "valve-cam", "swing-cam", "gas-engine", "five-bar-motors"]
VECTOR = {*MACHINES[::3], "rack", "train"}
FEW = {"double-pendulum", "four-bar", "double-butterfly", "valve-cam"}

# A rack pushed by hand turns its pinion, which turns a crank with a rod and a slider.
RACK = """\
bodies:
  ground: {points: {O: [0, 0]}}
  rack: {points: {R: [0, 0]}, mass: 1}
  pinion: {points: {O: [0, 0], A: [0.1, 0]}, mass: 1, inertia: 0.1}
  rod: {points: {A: [0, 0], B: [0.4, 0]}}
  piston: {points: {B: [0, 0]}}
joints:
  R: {slide: [ground, rack], along: x, distance: x}
  O: {pin: [ground, pinion], angle: theta}
  A: {pin: [pinion, rod], angle: phi}
  B: {pin: [rod, piston]}
  S: {slide: [ground, piston], along: x, distance: s}
racks: {r: {pinion: pinion, rack: rack, radius: 0.02}}
forces: {F: {body: rack, at: R, value: [3 N * sin(2 rad/s * t), 0]}}
start: {x: 0.01, phi: -30 deg, s: 0.4}
"""

# Every input in turn is what it should not be, alone and as lanes of a batch; the rest is a pose of the self-test.
PROGRAM = """
#include <stdio.h>
#include <string.h>

enum { BAD = 4, LANES = 3 * INPUTS * BAD + 5 };

static int is_finite(const double *values, int n)
{
    for (int k = 0; k < n; k++)
        if (!(0 * values[k] == 0)) return 0;
    return 1;
}

static int check(int status, const double *out, const double *good, int n, int kind, int is_angle, int is_length)
{
    if (kind < 3) // no number: it says so, or does not take this input
        return status == m_BAD_INPUT || (status >= 0 && memcmp(out, good, (size_t)n * sizeof *out) == 0);
    if (is_angle) return status == m_BAD_INPUT;
    if (status == m_BAD_INPUT) return is_length; // too large for the angle of a pinion
    return status < 0 || status == m_SINGULAR || !is_length || is_finite(out, n);
}
"""
ROUTINE = """
static int test_@(void)
{
    static const double values[BAD] = {NAN, INFINITY, -INFINITY, 1e300};
    static const int is_angle[INPUTS] = {#angles}, is_length[INPUTS] = {#lengths};
    static const double pose[INPUTS] = {#pose};
    static double in[INPUTS][LANES], out[RESULTS_@][LANES];
    static signed char status[LANES];
    const m_parameters p = m_defaults();
    const m_machine m = m_prepare(&p);
    const m_configuration c = m_start();
    m_inputs one;
    m_@ good, found;
    int wrong = 0;
    memcpy(&one, pose, sizeof one);
    int well = m_find_@(&m, &c, &one, &good);
    if (well < 0) printf("@: %d\\n", well);
    for (int i = 0; i < LANES; i++)
        for (int k = 0; k < INPUTS; k++) in[k][i] = i % 3 == 1 && i / 3 / BAD == k ? values[i / 3 % BAD] : pose[k];
    const m_inputs_arrays inputs = {#ins};
    const m_@_arrays results = {#outs};
    m_find_@_batch(LANES, &m, &c, &inputs, &results, status);
    for (int i = 0; i < LANES; i++) {
        const int input = i / 3 / BAD, kind = i / 3 % BAD;
        for (int k = 0; k < INPUTS; k++) memcpy((double *)&one + k, &in[k][i], sizeof(double));
        int how = m_find_@(&m, &c, &one, &found);
        int right = i % 3 != 1 || input >= INPUTS ? how == well
                                : check(how, (double *)&found, (double *)&good, RESULTS_@, kind, is_angle[input], is_length[input]);
        if (right && how == status[i]) continue;
        printf("@: input %d is %g: %d, in a batch %d\\n", input, in[input % INPUTS][i], how, status[i]);
        wrong = 1;
    }
    return wrong;
}
"""


def members(text, struct):
    """Names and comments of a struct of numbers."""
    return re.findall(r"    double (\w+);(?: */\* (.*?) \*/)?", re.search(r"(?s)typedef struct m_%s \{(.*?)\n?\}" % struct, text).group(1))


def program(text):
    inputs = members(text, "inputs")
    names = re.findall(r"(?m)^int m_find_(\w+)\(.*\);", text)
    rows = re.search(r"(?s)static const double rows\[5\]\[\d+\] = \{\s*\{(.*?)\}", text).group(1)
    lists = {"angles": [int(comment == "rad") for _, comment in inputs], "lengths": [int(comment == "m") for _, comment in inputs],
             "pose": [value.strip() for value in rows.split(",")], "ins": ["in[%d]" % k for k in range(len(inputs))]}
    parts = [PROGRAM.replace("INPUTS * BAD", "%d * BAD" % len(inputs)).replace("enum { BAD", "enum { INPUTS = %d, BAD" % len(inputs))]
    for name in names:
        results = members(text, name)
        own = dict(lists, outs=["out[%d]" % k for k in range(len(results))])
        part = ROUTINE.replace("@", name).replace("RESULTS_" + name, str(len(results)))
        parts.append(re.sub(r"#(\w+)", lambda match: ", ".join(map(str, own[match.group(1)])), part))
    calls = " | ".join("test_%s()" % name for name in names)
    return "".join(parts) + "\nint main(void) { return %s; }\n" % calls


class Inputs(Printed):
    def try_all(self, path):
        """Every input of every routine: as scalar code or, in the gate every third machine, as vector code; in full as both."""
        name = name_of(path)
        with self.subTest(name):
            text = self.print(path)
            source = program(text)
            vector = ["-O3", "-fno-math-errno", "-fno-trapping-math"]
            for flags in [[], vector] if FULL else [vector if name in VECTOR else []]:
                run = subprocess.run([self.compile(text + source, *flags, name=name)], capture_output=True, encoding="utf-8", check=False)
                self.assertEqual((run.returncode, run.stdout), (0, ""), flags)

    def test_inputs_that_are_no_numbers_or_too_large_are_bad_in_every_place(self):
        for name in MACHINES if "YOKE_FULL" in os.environ else FEW.union(MACHINES[::2]):
            if "YOKE_FEW" not in os.environ or name in FEW:
                self.try_all(os.path.join(ROOT, "examples", name + ".yaml"))

    def test_of_trains_and_followers_too(self):
        """A law's follower; gears, a belt and a rack on an arm; a planetary drive; a pinion that a rack turns."""
        self.try_all(self.write("rack.yaml", RACK))
        if "YOKE_FEW" not in os.environ:
            self.try_all(self.write("followers.yaml", FOLLOWERS))
            self.try_all(self.write("train.yaml", random_train(random.Random(1))))
            self.try_all(self.write("planetary.yaml", PLANETARY))


if __name__ == "__main__":
    unittest.main()
