"""Writes examples/expected/dynamics/*.json from dynamics_machines.py: `python3 tools/oracle/dynamics_generate.py [NAME ...]`.

Poses are solved with 60 digits; motions are integrated twice, with other steps and tolerances, and it complains where the two differ by more
than a tenth of what the test allows. Needs python3-mpmath; about five minutes.
"""
import json
import os
import sys

from mpmath import mp, mpf

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from dynamics_machines import CASES  # noqa: E402
from dynamics_oracle import Doubles, Long  # noqa: E402

FOLDER = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "examples", "expected", "dynamics")
WHOLE = ("kinetic", "potential", "energy")


def number(value):
    """The double nearest to a value; 0 for what is only rounding."""
    return 0.0 if abs(value) < mpf(10) ** -22 else float(value)


def is_force(name):
    return name.endswith((".force.x", ".force.y", ".moment", ".effort")) or name in WHOLE


def pose_entry(case, pose):
    """One pose: `at`, `rate`, `accel` as the command takes them, and every answer."""
    machine = case["machine"]
    hold, state = pose.get("hold", {}), pose.get("state", {})
    running = machine.running(Long, {name: (lambda _, v=value: v) for name, value in hold.items()} if hold else None)
    entry = {"at": {}, "rate": {}, "accel": {}}
    for name, (at, rate, accel) in hold.items():
        entry["at"][name], entry["rate"][name], entry["accel"][name] = float(at), float(rate), float(accel)
        hold[name] = tuple(mpf(float(v)) for v in (at, rate, accel))
    for name, value in state.items():
        kind, plain = ("rate", name[:-5]) if name.endswith(".rate") else ("at", name)
        entry[kind][plain] = float(mpf(value))
    kept = dict(machine.start)
    try:
        machine.start = dict({n: v for n, v in kept.items()}, **{n: mpf(float(mpf(v))) for n, v in state.items()})
        if state:  # what is given is held before what is guessed
            machine.start = dict([(n, machine.start[n]) for n in state] + [(n, v) for n, v in machine.start.items() if n not in state])
        answers = running.pose(mpf(0))
    finally:
        machine.start = kept
    entry["expect"] = {name: number(value) for name, value in answers.items() if is_force(name) or name.endswith(".accel") or name in machine.where}
    entry["tolerance"] = case["tolerance"]
    return entry


def simulation_entry(case, simulation):
    machine = case["machine"]
    times = [float(t) for t in simulation["times"]]
    runs = []
    for step, tolerance in ((simulation["step"], 1e-13), (simulation["step"] * 0.7, 1e-12)):
        running = machine.running(Doubles)
        found = running.simulate(times, step, max(tolerance, simulation.get("effort_tolerance", 0)))
        runs.append([running.channels(t, q, v) for t, q, v in found])
    allowed = simulation.get("tolerance", 1e-9)
    worst = max(abs(a[n] - b[n]) / max(1, abs(a[n])) for a, b in zip(*runs) for n in simulation["of"])
    if worst > allowed / 10:
        print("%s: two integrations differ by %.2g, the test allows %.2g" % (machine.name, worst, allowed))
    return {"to": times[-1], "rows": [[t] + [float(row[n]) for n in simulation["of"]] for t, row in zip(times, runs[0])],
            "of": simulation["of"], "tol": simulation.get("tol", 1e-12), "tolerance": allowed, "uncertainty": float("%.1e" % worst)}


def lines(value, indent=1, width=140):
    """JSON with short lists and maps on one line."""
    flat = json.dumps(value, ensure_ascii=False)
    if len(flat) + indent <= width or not isinstance(value, (dict, list)):
        return flat
    pad = " " * indent
    if isinstance(value, dict):
        if all(not isinstance(v, (dict, list)) for v in value.values()):
            rows, row = [], ""
            for key, v in value.items():
                item = "%s: %s, " % (json.dumps(key), json.dumps(v))
                if row and len(row) + len(item) + indent > width:
                    rows.append(row.rstrip())
                    row = ""
                row += item
            rows.append(row.rstrip(", "))
            return "{\n" + pad + ("\n" + pad).join(rows) + "}"
        return "{\n" + ",\n".join("%s%s: %s" % (pad, json.dumps(k), lines(v, indent + 1, width)) for k, v in value.items()) + "}"
    return "[\n" + ",\n".join(pad + lines(v, indent + 1, width) for v in value) + "]"


def main():
    os.makedirs(FOLDER, exist_ok=True)
    wanted = sys.argv[1:]
    for case in CASES:
        machine = case["machine"]
        if wanted and machine.name not in wanted:
            continue
        document = {"file": machine.name + ".yaml", "source": machine.source, "angles": machine.angles(),
                    "poses": [pose_entry(case, pose) for pose in case["poses"]],
                    "simulations": [simulation_entry(case, s) for s in case["simulations"]]}
        with open(os.path.join(FOLDER, machine.name + ".json"), "w") as file:
            file.write(lines(document) + "\n")
        print(machine.name)


if __name__ == "__main__":
    mp.dps = 60
    main()
