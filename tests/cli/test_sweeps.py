"""Laws that every sweep of the gallery obeys, without expected numbers: `python3 test_sweeps.py PATH/OF/yoke [NAME ...]`.

For every example whose crank turns through: the poses do not depend on the step, nor on the direction; a whole turn leads back to the
first pose; rates and accelerations are the differences of the positions; the same request gives the same bytes. Prints each difference
and a last line "N passed, M failed".
"""
import csv
import io
import json
import math
import os
import subprocess
import sys

EXAMPLES = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "examples")
TURN = 2 * math.pi
STEPS = (8, 12, 24, 72, 360)
SAME_POSE = 1e-10
CHANGE_POINT = 1e-6        # at a change point a position is known to the square root of rounding only
DIFFERENCES = 1e-7
SMALL_STEP = 1e-3          # rad, for differences


class Tally:
    """Counts checks and tells of those that fail."""

    def __init__(self):
        self.passed = self.failed = 0
        self.where = ""

    def check(self, holds, text):
        if holds:
            self.passed += 1
        else:
            self.failed += 1
            print("FAIL %s: %s" % (self.where, text))
        return holds


def sweep(yoke, name, over, begin, end, steps, of, more=()):
    """Text of the answer, and its rows (lists of floats, the swept value first)."""
    words = [yoke, "sweep", os.path.join(EXAMPLES, name), "--over", "%s=%rrad:%rrad" % (over, begin, end), "--steps", str(steps),
             "--of", ",".join(of), "--format", "csv"] + list(more)
    done = subprocess.run(words, stdout=subprocess.PIPE, stderr=subprocess.PIPE, timeout=60)
    lines = list(csv.reader(io.StringIO(done.stdout.decode())))[1:]
    return done.stdout, [[float(v) if v else math.nan for v in line] for line in lines]


def relative(got, want):
    difference = abs(got - want) / max(1.0, abs(want))
    return difference if math.isfinite(difference) else math.inf


def beside(at, points):
    return any(abs(math.remainder(at - p, TURN)) < 1e-6 for p in points)


def check_steps(tally, yoke, name, turn, of):
    """Every coarse sweep, forward and back, against the rows of the finest."""
    over, begin = turn["over"], turn["from"]
    points = turn.get("change_points", ())
    fine = sweep(yoke, name, over, begin, begin + TURN, max(STEPS), of)[1]
    if not tally.check(len(fine) == max(STEPS) + 1, "%d rows of a whole turn" % len(fine)):
        return
    for steps in STEPS:
        for sign in (1, -1):
            rows = sweep(yoke, name, over, begin, begin + sign * TURN, steps, of)[1]
            if not tally.check(len(rows) == steps + 1, "%d rows in %d steps" % (len(rows), steps)):
                continue
            compare_turn(tally, rows, fine, sign, points, of)


def compare_turn(tally, rows, fine, sign, points, of):
    """Row k of n against the fine row at the same angle; backwards, angles that turn through lie one turn of theirs lower."""
    every = (len(fine) - 1) // (len(rows) - 1)
    turned = [b - a for a, b in zip(fine[0], fine[-1])]
    for k, row in enumerate(rows):
        same = fine[k * every] if sign > 0 else fine[len(fine) - 1 - k * every]
        tolerance = CHANGE_POINT if beside(row[0], points) else SAME_POSE
        for i, channel in enumerate(of, 1):
            want = same[i] - (0 if sign > 0 else turned[i])
            if not relative(row[i], want) <= tolerance:
                tally.check(False, "%d steps, %+d: %s is %r at %.6f, expected %r" % (len(rows) - 1, sign, channel, row[i], row[0], want))
                return
    tally.check(True, "")


def check_whole_turn(tally, yoke, name, turn, of, angles):
    """After a turn of the crank every length is the same again and every angle has turned a whole number of times."""
    rows = sweep(yoke, name, turn["over"], turn["from"], turn["from"] + TURN, 24, of)[1]
    if not tally.check(len(rows) == 25, "%d rows" % len(rows)):
        return
    for i, channel in enumerate(of, 1):
        difference = rows[-1][i] - rows[0][i]
        if channel in angles:
            difference = math.remainder(difference, TURN)
        tally.check(abs(difference) <= SAME_POSE, "%s comes back with a difference of %g" % (channel, difference))


def check_differences(tally, yoke, name, turn, of):
    """Rates at unit speed are the first, accelerations the second 5-point differences of positions."""
    names = [c + order for c in of for order in ("", ".rate", ".accel")]
    over = turn["over"]
    unit = ["--rate", over + "=1rad/s", "--accel", over + "=0rad/s^2"]
    for k in range(1, 12, 2):
        middle = turn["from"] + TURN * k / 12 + 0.01
        rows = sweep(yoke, name, over, middle - 2 * SMALL_STEP, middle + 2 * SMALL_STEP, 4, names, unit)[1]
        if not tally.check(len(rows) == 5, "%d rows round %g" % (len(rows), middle)):
            continue
        for i, channel in enumerate(of):
            a, b, c, d, e = (row[3 * i + 1] for row in rows)
            first = (a - 8 * b + 8 * d - e) / (12 * SMALL_STEP)
            second = (-a + 16 * b - 30 * c + 16 * d - e) / (12 * SMALL_STEP ** 2)
            tally.check(relative(rows[2][3 * i + 2], first) <= DIFFERENCES,
                        "%s.rate is %r at %g, differences give %r" % (channel, rows[2][3 * i + 2], middle, first))
            tally.check(relative(rows[2][3 * i + 3], second) <= DIFFERENCES,
                        "%s.accel is %r at %g, differences give %r" % (channel, rows[2][3 * i + 3], middle, second))


def check_same_bytes(tally, yoke, name, turn, of):
    first = sweep(yoke, name, turn["over"], turn["from"], turn["from"] + TURN, 36, of)[0]
    tally.check(first and first == sweep(yoke, name, turn["over"], turn["from"], turn["from"] + TURN, 36, of)[0], "two runs differ")


def main():
    if len(sys.argv) < 2:
        print(__doc__.strip().split("\n")[0])
        return 2
    yoke, names = sys.argv[1], sys.argv[2:]
    tally = Tally()
    folder = os.path.join(EXAMPLES, "expected")
    for file_name in sorted(os.listdir(folder)):
        if not file_name.endswith(".json") or (names and file_name[:-5] not in names):
            continue
        with open(os.path.join(folder, file_name)) as file:
            document = json.load(file)
        turns = [s for s in document["sweeps"] if s["steps"] == 24 and "limit" not in s and abs(s["to"] - s["from"] - TURN) < 1e-9]
        for turn in turns:
            name, of = document["file"], turn["of"]
            tally.where = name
            check_steps(tally, yoke, name, turn, of)
            check_whole_turn(tally, yoke, name, turn, of, document["angles"])
            check_differences(tally, yoke, name, turn, of)
            check_same_bytes(tally, yoke, name, turn, of)
    print("%d passed, %d failed" % (tally.passed, tally.failed))
    return 1 if tally.failed or not tally.passed else 0


if __name__ == "__main__":
    sys.exit(main())
