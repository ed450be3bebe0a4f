"""Writes examples/expected/*.json from machines.py: run `python3 tools/oracle/generate.py` (needs python3-mpmath)."""
import json
import os
import sys

from mpmath import mp, mpf

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from machines import CASES  # noqa: E402

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..")


def number(value):
    """The double nearest to a value; 0 for what is only rounding of the oracle's differences."""
    return 0.0 if abs(value) < mpf(10) ** -25 else float(value)


def wrapped(difference):
    return difference - 2 * mp.pi * mp.nint(difference / (2 * mp.pi))


def complain(machine, text):
    print("%s: %s" % (machine.name, text))
    complain.count += 1


complain.count = 0


def start_inputs(case):
    """Where the file's machine stands at its start: the inputs of the first pose."""
    return {n: float(v) for n, v in case["poses"][0]["at"].items()}


def assembled(machine, inputs):
    """The configuration that the format prescribes at these inputs: the nearest to the guesses of `start`; and how clear the choice is."""
    found = machine.configurations(inputs, tries=60 if len(machine.bodies) > 5 else 200)
    direct = machine.at_start(inputs)
    if direct is not None:
        values = machine.values([mpf(v) for v in direct])
        if not any(machine.same(values, other) for other, _ in found):
            found.append((values, direct))
    found.sort(key=lambda item: machine.distance_to_start(item[0]))
    if not found:
        return None, [], 0
    nearest = machine.distance_to_start(found[0][0])
    margin = float(machine.distance_to_start(found[1][0]) / nearest) if len(found) > 1 and nearest > 0 else float("inf")
    return found[0][1], found, margin


def pose_entry(case, index, pose, entry_tolerance):
    machine = case["machine"]
    at = {n: float(v) for n, v in pose["at"].items()}
    vector, found, margin = assembled(machine, at)
    if vector is None:
        complain(machine, "no assembly at %s" % at)
        return None
    if margin < 1.5:
        complain(machine, "pose %d: the choice of assembly is narrow (%.3f)" % (index, margin))
    exact_at = pose["at"]
    motion = machine.motion(vector, exact_at, pose["rate"], pose["accel"])
    for name, (value, tolerance) in pose.get("published", {}).items():
        difference = motion[name] - value
        if name in machine.angles():
            difference = wrapped(difference)
        if abs(difference) > tolerance:
            complain(machine, "pose %d: published %s = %.17g, oracle %.17g" % (index, name, value, float(motion[name])))
    entry = {}
    if "time" in pose:
        entry["time"] = pose["time"]
    else:
        for key in ("at", "rate", "accel"):
            entry[key] = {n: float(v) for n, v in pose[key].items()}
    if case["params"]:
        entry["params"] = case["params"]
    entry["expect"] = {n: number(v) for n, v in motion.items()}
    if pose.get("published"):
        entry["published"] = {n: list(v) for n, v in pose["published"].items()}
    entry["tolerance"] = pose.get("tolerance", entry_tolerance)
    entry["freedom"] = machine.freedom
    if index in case["all_poses"]:
        again = machine.configurations(at, tries=400, seed=7)
        if len(again) != len(found):
            complain(machine, "pose %d: %d or %d configurations" % (index, len(found), len(again)))
        rows = []
        for _, solved in again:
            values = machine.closed(solved, exact_at)
            rows.append({n: number(values[n]) for n in machine.coordinates()})
        entry["configurations"] = sorted(rows, key=lambda row: list(row.values()))
    return entry


def closed_form(name, machine, inputs):
    """Poses known without solving, for machines that pass singular positions of the oracle's own equations."""
    assert name == "parallel"
    theta = mpf(inputs[machine.inputs[0]])
    if machine.name == "parallelogram":
        return {"theta3": -theta, "theta4": theta, "coupler.angle": mpf(0)}
    return {"theta2": theta, "theta3": theta, "phi": -theta, "rod.angle": mpf(0)}


def sweep_entry(case, sweep):
    machine = case["machine"]
    over, begin, end, steps = sweep["over"], sweep["from"], sweep["to"], sweep["steps"]
    entry = {k: v for k, v in sweep.items() if k not in ("only_ends", "closed_form")}
    if case["params"]:
        entry["params"] = case["params"]
    inputs = dict(sweep.get("fixed", {}))
    inputs[over] = begin
    vector = assembled(machine, inputs)[0]
    if vector is None:
        complain(machine, "sweep from %g does not assemble" % begin)
        return entry
    if "limit" in sweep:
        # the branch closes up to the limit and not past it
        towards = 1 if end > begin else -1
        before = machine.follow(vector, inputs, dict(inputs, **{over: sweep["limit"] - towards * 1e-4}), 400)
        past = machine.follow(vector, inputs, dict(inputs, **{over: sweep["limit"] + towards * 1e-4}), 400)
        if before is None or past is not None:
            complain(machine, "limit %g is not where the oracle finds it" % sweep["limit"])
        return entry
    rows = []
    for k in range(steps + 1):
        to = dict(inputs, **{over: begin + (end - begin) * k / steps})
        if sweep.get("closed_form"):
            values = closed_form(sweep["closed_form"], machine, to)
        else:
            if sweep.get("only_ends") and k not in (0, steps):
                continue
            if k:
                vector = machine.follow(vector, inputs, to, 12 if not sweep.get("only_ends") else 400)
                if vector is None:
                    complain(machine, "sweep over %s is lost before %g" % (over, to[over]))
                    return entry
                inputs = to
            values = machine.closed(vector, to)
        if k in (0, steps) or not sweep.get("only_ends"):
            rows.append([k] + [number(values[n]) if n in values else None for n in sweep["of"]])
    entry["rows"] = rows
    return entry


def write(path, document):
    text = json.dumps(document, indent=1)
    # short lists and groups of values on few lines
    lines, buffer = [], ""
    for line in text.split("\n"):
        stripped = line.strip()
        is_value = stripped and not stripped.endswith(("{", "[")) and stripped[0] not in "}]"
        if is_value:
            if buffer and len(buffer) + len(stripped) < 118:
                buffer += " " + stripped
            else:
                if buffer:
                    lines.append(buffer)
                buffer = line[: len(line) - len(line.lstrip())] + stripped
        else:
            if buffer and stripped[:1] in "]}" and lines and len(lines[-1]) + len(buffer) < 118 and lines[-1].endswith(("[", "{")):
                buffer = lines.pop() + buffer.strip() + stripped
                lines.append(buffer)
                buffer = ""
                continue
            if buffer:
                lines.append(buffer)
                buffer = ""
            lines.append(line)
    if buffer:
        lines.append(buffer)
    with open(path, "w") as file:
        file.write("\n".join(lines) + "\n")
    assert json.load(open(path)) == document


def main():
    only = sys.argv[1:]
    documents = {}
    for case in CASES:
        machine = case["machine"]
        if only and machine.name not in only:
            continue
        document = documents.setdefault(machine.name, {
            "file": machine.name + ".yaml", "source": machine.source, "angles": machine.angles(), "poses": [], "sweeps": []})
        for index, pose in enumerate(case["poses"]):
            entry = pose_entry(case, index, pose, case["tolerance"])
            if entry:
                document["poses"].append(entry)
        for sweep in case["sweeps"]:
            document["sweeps"].append(sweep_entry(case, sweep))
        print(machine.name, [len(p.get("configurations", [])) for p in document["poses"]], flush=True)
    os.makedirs(os.path.join(ROOT, "examples", "expected"), exist_ok=True)
    for name, document in documents.items():
        write(os.path.join(ROOT, "examples", "expected", name + ".json"), document)
    return 1 if complain.count else 0


if __name__ == "__main__":
    sys.exit(main())
