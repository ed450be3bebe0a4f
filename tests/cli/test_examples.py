"""Every example against its expected answers: `python3 test_examples.py PATH/OF/yoke [NAME ...]`.

Reads examples/expected/*.json (written by tools/oracle, which knows nothing of the library) and asks the command for the same poses and
sweeps. Values are compared relative to max(1, |value|); angles modulo a turn at one pose, and without jumps in a sweep. Prints
each difference and a last line "N passed, M failed".
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
LIMIT_TOLERANCE = 1e-8
RANGE_TOLERANCE = 1e-9
SWEEP_TOLERANCE = 1e-11
CHANGE_TOLERANCE = 1e-6  # beside a change point a position is known to the square root of rounding only
UNITS = {True: ("rad", "rad/s", "rad/s^2"), False: ("m", "m/s", "m/s^2")}


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


def unwrapped(difference):
    return difference - TURN * round(difference / TURN)


def close(got, want, tolerance, is_angle=False):
    if not isinstance(got, (int, float)) or not math.isfinite(got):
        return False
    difference = unwrapped(got - want) if is_angle else got - want
    return abs(difference) <= tolerance * max(1.0, abs(want))


def run(yoke, words):
    done = subprocess.run([yoke] + words, stdout=subprocess.PIPE, stderr=subprocess.PIPE, timeout=60)
    return done.returncode, done.stdout.decode(), done.stderr.decode()


def pairs(option, values, order, angles):
    words = []
    for name, value in values.items():
        words += ["--" + option, "%s=%r%s" % (name, value, UNITS[name in angles][order])]
    return words


def model(document, entry):
    words = [os.path.join(EXAMPLES, document["file"])]
    for name, value in entry.get("params", {}).items():
        words += ["--param", name + "=" + value]
    return words


def channels(configuration):
    """The answers of `solve --format json` under the names of channels."""
    values = {}
    for name, motion in configuration["coordinates"].items():
        values[name], values[name + ".rate"], values[name + ".accel"] = \
            motion["position"], motion["velocity"], motion["acceleration"]
    for name, motion in configuration["bodies"].items():
        name += ".angle"
        values[name], values[name + ".rate"], values[name + ".accel"] = motion["angle"], motion["rate"], motion["acceleration"]
    for name, motion in configuration["points"].items():
        for i, axis in enumerate((".x", ".y")):
            values[name + axis], values[name + axis + ".rate"], values[name + axis + ".accel"] = \
                motion["position"][i], motion["velocity"][i], motion["acceleration"][i]
    return values


def solve(tally, yoke, document, pose, more=()):
    """The parsed answer at a pose, or None after telling why not."""
    angles = document["angles"]
    words = ["solve"] + model(document, pose)
    if "time" in pose:
        words += ["--time", "%rs" % pose["time"]]
    for order, option in enumerate(("at", "rate", "accel")):
        words += pairs(option, pose.get(option, {}), order, angles)
    code, out, err = run(yoke, words + ["--format", "json"] + list(more))
    if not tally.check(code == 0, "exit %d of %s\n%s" % (code, " ".join(words), err.strip() or out[:300])):
        return None
    try:
        return json.loads(out)
    except ValueError as error:
        tally.check(False, "not JSON: %s" % error)
        return None


def compare(tally, got, want, tolerance, angles, label):
    for name, value in want.items():
        if not tally.check(name in got, "%s%s is missing from the answer" % (label, name)):
            continue
        tally.check(close(got[name], value, tolerance, name in angles),
                    "%s%s is %r, expected %r (difference %.2g)" % (label, name, got[name], value, (got[name] or 0) - value))


def check_pose(tally, yoke, document, pose):
    answer = solve(tally, yoke, document, pose)
    if not answer or not tally.check(len(answer["configurations"]) == 1, "one configuration was asked for"):
        return
    tally.check(answer["status"] in ("ok", "redundant"), "status " + answer["status"])
    tally.check(answer["freedom"] == pose["freedom"], "freedom %r, expected %r" % (answer["freedom"], pose["freedom"]))
    got = channels(answer["configurations"][0])
    compare(tally, got, pose["expect"], pose["tolerance"], document["angles"], "")
    for name, (value, tolerance) in pose.get("published", {}).items():
        difference = got.get(name, math.nan) - value
        if name in document["angles"]:
            difference = unwrapped(difference) if math.isfinite(difference) else difference
        tally.check(abs(difference) <= tolerance, "published %s = %r, got %r" % (name, value, got.get(name)))


def check_configurations(tally, yoke, document, pose):
    """--all: every configuration of the oracle is listed, and no other."""
    answer = solve(tally, yoke, document, pose, ["--all"])
    if not answer:
        return
    found = [channels(c) for c in answer["configurations"]]
    want = pose["configurations"]
    tally.check(len(found) == len(want), "--all gives %d configurations, expected %d" % (len(found), len(want)))
    labels = [c["label"] for c in answer["configurations"]]
    tally.check(len(set(labels)) == len(labels), "labels repeat: %s" % labels)
    for row in want:
        matches = [f for f in found
                   if all(n in f and close(f[n], v, pose["tolerance"] * 10, n in document["angles"]) for n, v in row.items())]
        tally.check(len(matches) == 1, "--all has %d configurations with %r" % (len(matches), row))


def sweep_rows(tally, yoke, document, sweep):
    """(exit code, rows of floats with the swept value first, JSON answer) of a sweep."""
    angles = document["angles"]
    unit = UNITS[sweep["over"] in angles][0]
    words = ["sweep"] + model(document, sweep)
    words += pairs("at", sweep.get("fixed", {}), 0, angles)
    words += ["--over", "%s=%r%s:%r%s" % (sweep["over"], sweep["from"], unit, sweep["to"], unit), "--steps", str(sweep["steps"]),
              "--of", ",".join(sweep["of"])]
    code, out, err = run(yoke, words + ["--format", "csv"])
    lines = list(csv.reader(io.StringIO(out)))
    if not tally.check(lines and lines[0] == [sweep["over"]] + sweep["of"], "header %r\n%s" % (lines[:1], err.strip())):
        return code, [], err
    return code, [[float(v) if v else math.nan for v in line] for line in lines[1:]], run(yoke, words + ["--format", "json"])[1]


def row_tolerance(sweep, at):
    beside = any(abs(at - point) < 1e-3 for point in sweep.get("change_points", ()))
    return CHANGE_TOLERANCE if beside else SWEEP_TOLERANCE


def check_rows(tally, document, sweep, rows):
    tally.check(len(rows) == sweep["steps"] + 1, "%d rows, expected %d" % (len(rows), sweep["steps"] + 1))
    shift = {}
    for expected in sweep["rows"]:
        k, values = expected[0], expected[1:]
        if k >= len(rows):
            continue
        at = sweep["from"] + (sweep["to"] - sweep["from"]) * k / sweep["steps"]
        tally.check(close(rows[k][0], at, 1e-14), "row %d stands at %r, expected %r" % (k, rows[k][0], at))
        for i, name in enumerate(sweep["of"]):
            if values[i] is None:
                continue
            if name in document["angles"] and name not in shift:
                shift[name] = TURN * round((rows[k][i + 1] - values[i]) / TURN)
            want = values[i] + shift.get(name, 0.0)
            tally.check(close(rows[k][i + 1], want, row_tolerance(sweep, at)),
                        "at %s = %.10g: %s is %r, expected %r" % (sweep["over"], at, name, rows[k][i + 1], want))


def check_limit(tally, sweep, code, rows, text):
    """A sweep that meets a limit: rows up to it, exit 1, the place to 1e-8, every closing range."""
    tally.check(code == 1, "exit %d, expected 1 at a limit" % code)
    step = (sweep["to"] - sweep["from"]) / sweep["steps"]
    complete = math.floor((sweep["limit"] - sweep["from"]) / step + 1e-9) + 1
    tally.check(len(rows) in (complete, complete + 1), "%d rows before the limit, expected %d" % (len(rows), complete))
    try:
        answer = json.loads(text)
    except ValueError as error:
        tally.check(False, "not JSON: %s" % error)
        return
    tally.check(answer.get("status") == "limit", "status %r, expected 'limit'" % answer.get("status"))
    limits = [event["at"] for event in answer["events"] if event["kind"] == "limit"]
    tally.check(any(abs(at - sweep["limit"]) <= LIMIT_TOLERANCE for at in limits), "limit at %r, expected %r" % (limits, sweep["limit"]))
    if "ranges" in sweep:
        check_ranges(tally, sweep["ranges"], answer["ranges"])


def check_ranges(tally, want, got):
    tally.check(len(got) == len(want), "closes in %r, expected %r" % (got, want))
    for low, high in want:
        tally.check(any(abs(unwrapped(a - low)) <= RANGE_TOLERANCE and abs(unwrapped(b - high)) <= RANGE_TOLERANCE for a, b in got),
                    "range [%.12g, %.12g] is not among %r" % (low, high, got))


def column(sweep, rows, name):
    return [row[sweep["of"].index(name) + 1] for row in rows]


def check_extremes(tally, sweep, rows, _):
    for name, (low, high) in sweep["extremes"].items():
        values = column(sweep, rows, name)
        tolerance = sweep["extreme_tolerance"]
        tally.check(abs(min(values) - low) <= tolerance, "least %s is %r, expected %r" % (name, min(values), low))
        tally.check(abs(max(values) - high) <= tolerance, "greatest %s is %r, expected %r" % (name, max(values), high))


def check_straight(tally, sweep, rows, _):
    """The straight part: its length, and its deviation in percent of the length."""
    want = sweep["straight"]
    x, y = column(sweep, rows, want["x"]), column(sweep, rows, want["y"])
    length, percent = abs(x[-1] - x[0]), 100 * (max(y) - min(y)) / abs(x[-1] - x[0])
    tally.check(abs(length - want["x_span"]) <= 1e-9, "length %r, expected %r" % (length, want["x_span"]))
    tally.check(abs(percent / want["y_percent"] - 1) <= want["tolerance"], "deviation %r %%, expected %r" % (percent, want["y_percent"]))


def turning_points(at, rate):
    """Where a rate changes its sign: by a cubic through the four nearest samples, inverted."""
    found = []
    for k in range(1, len(rate) - 2):
        if (rate[k] < 0) != (rate[k + 1] < 0):
            xs, ys = at[k - 1:k + 3], rate[k - 1:k + 3]
            total = 0.0
            for i in range(4):
                weight = xs[i]
                for j in range(4):
                    if j != i:
                        weight *= -ys[j] / (ys[i] - ys[j])
                total += weight
            found.append(total)
    return found


def check_stroke(tally, sweep, rows, text):
    """Quick return: the stroke, and the ratio of the crank angles of its two ways."""
    want = sweep["stroke"]
    at, values = [row[0] for row in rows], column(sweep, rows, want["of"])
    ends = turning_points(at, column(sweep, rows, want["of"] + ".rate"))
    if not tally.check(len(ends) == 2, "%d ends of the stroke, expected 2" % len(ends)):
        return
    way = ends[1] - ends[0]
    ratio = max(way, TURN - way) / min(way, TURN - way)
    tally.check(abs(ratio - want["ratio"]) <= want["tolerance"], "time ratio %r, expected %r" % (ratio, want["ratio"]))
    length = max(values) - min(values)
    tally.check(abs(length - want["length"]) <= 1e-5 * want["length"], "stroke %r, expected %r" % (length, want["length"]))
    told = [s for s in json.loads(text)["strokes"] if s["column"] == want["of"]]
    if tally.check(len(told) == 1, "the sweep tells %d strokes of %s" % (len(told), want["of"])):
        tally.check(close(told[0]["ratio"], want["ratio"], 1e-8), "told time ratio %r, expected %r" % (told[0]["ratio"], want["ratio"]))
        tally.check(close(told[0]["high"] - told[0]["low"], want["length"], 1e-12), "told stroke %r" % (told[0]["high"] - told[0]["low"]))


def check_sweep(tally, yoke, document, sweep):
    code, rows, text = sweep_rows(tally, yoke, document, sweep)
    if not rows:
        tally.check(False, "no rows")
        return
    if "limit" in sweep:
        check_limit(tally, sweep, code, rows, text)
        return
    tally.check(code == 0, "exit %d" % code)
    check_rows(tally, document, sweep, rows)
    for key, function in (("extremes", check_extremes), ("straight", check_straight), ("stroke", check_stroke)):
        if key in sweep:
            function(tally, sweep, rows, text)


def check_document(tally, yoke, document):
    for index, pose in enumerate(document["poses"]):
        tally.where = "%s pose %d" % (document["file"], index)
        check_pose(tally, yoke, document, pose)
        if "configurations" in pose:
            check_configurations(tally, yoke, document, pose)
    for index, sweep in enumerate(document["sweeps"]):
        tally.where = "%s sweep %d (%s)" % (document["file"], index, sweep["over"])
        check_sweep(tally, yoke, document, sweep)


def main():
    if len(sys.argv) < 2:
        print(__doc__.strip().split("\n")[0])
        return 2
    yoke, names = sys.argv[1], sys.argv[2:]
    tally = Tally()
    folder = os.path.join(EXAMPLES, "expected")
    known = sorted(name for name in os.listdir(folder) if name.endswith(".json"))
    if "YOKE_FEW" in os.environ and "YOKE_EVERY" not in os.environ:
        known = known[::3]  # under the sanitizers
    for name in known:
        if names and name[:-5] not in names:
            continue
        with open(os.path.join(folder, name)) as file:
            document = json.load(file)
        try:
            check_document(tally, yoke, document)
        except (KeyError, IndexError, TypeError, ValueError, subprocess.TimeoutExpired) as error:
            tally.check(False, "%s: %s" % (type(error).__name__, error))
    print("%d passed, %d failed" % (tally.passed, tally.failed))
    return 1 if tally.failed or not tally.passed else 0


if __name__ == "__main__":
    sys.exit(main())
