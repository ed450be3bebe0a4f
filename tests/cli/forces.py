"""Shared by the tests of forces and motion: documents of expected answers, published cases, channels of an answer, sweeps of a simulation."""
import json
import os
import re

from harness import Case, ROOT

EXAMPLES = os.path.join(ROOT, "examples")
EXPECTED = os.path.join(EXAMPLES, "expected", "dynamics")


def documents():
    """The expected answers of dynamics, by file name."""
    for name in sorted(os.listdir(EXPECTED)):
        if name.endswith(".json"):
            with open(os.path.join(EXPECTED, name), encoding="utf-8") as file:
                yield json.load(file)


def published():
    """tests/validation/cases.json by id."""
    with open(os.path.join(ROOT, "tests", "validation", "cases.json"), encoding="utf-8") as file:
        return {case["id"]: case for case in json.load(file)["cases"]}


def example(name):
    return os.path.join(EXAMPLES, name + ".yaml")


def channels(configuration):
    """The answers of `solve --format json` under the names of channels."""
    values = dict(configuration.get("energy", {}))
    if values:
        values["energy"] = values["kinetic"] + values["potential"]
    for group, suffix in (("coordinates", ""), ("bodies", ".angle")):
        for name, motion in configuration[group].items():
            values[name + suffix] = motion.get("position", motion.get("angle"))
            values[name + suffix + ".rate"] = motion.get("velocity", motion.get("rate"))
            values[name + suffix + ".accel"] = motion["acceleration"]
    for name, motion in configuration["points"].items():
        for i, axis in enumerate((".x", ".y")):
            values[name + axis], values[name + axis + ".rate"], values[name + axis + ".accel"] = \
                motion["position"][i], motion["velocity"][i], motion["acceleration"][i]
    for name, reaction in configuration.get("reactions", {}).items():
        values[name + ".force.x"], values[name + ".force.y"] = reaction["force"]
        values[name + ".moment"] = reaction["moment"]
    for name, contact in configuration.get("contacts", {}).items():
        values[name + ".force.x"], values[name + ".force.y"] = contact["force"]
    for name, effort in configuration.get("efforts", {}).items():
        values[name + ".effort"] = effort
    return values


class Table:
    """Rows of a simulation: table.at(time)["theta"], and the numbers of the line on standard error that sums it up."""

    def __init__(self, run, to):
        self.head, self.rows = run.csv()
        self.times = [row[0] for row in self.rows]
        self.to = to
        self.summary = run.err.strip().split("\n")[-1] if run.err.strip() else ""

    def at(self, time):
        row = min(self.rows, key=lambda r: abs(r[0] - time))
        assert abs(row[0] - time) <= 1e-12 * max(1.0, self.to), "no row at t = %r" % time
        return dict(zip(self.head, row))

    def energy_error(self):
        return float(re.search(r"energy error ([0-9.e+-]+)", self.summary).group(1))

    def residual(self):
        return float(re.search(r"residual ([0-9.e+-]+)", self.summary).group(1))


class Machine(Case):
    """A test that asks for forces and motion, and compares them."""

    def near(self, got, want, tolerance, text=""):
        """Relative to max(1, |want|)."""
        self.assertIsInstance(got, (int, float), text)
        self.assertLessEqual(abs(got - want), tolerance * max(1.0, abs(want)), "%s is %r, expected %r" % (text, got, want))

    def solve(self, file, *words):
        answer = self.good("solve", file, *words, "--format", "json").json()
        self.assertEqual(len(answer["configurations"]), 1)
        return channels(answer["configurations"][0])

    def simulate(self, file, to, every, of, *words, tol=1e-12):
        run = self.good("simulate", file, "--to", "%rs" % to, "--every", "%rs" % every, "--tol", repr(tol), "--of", ",".join(of),
                        "--format", "csv", *words)
        table = Table(run, to)
        self.assertEqual(table.head, ["t", *of])
        self.assertEqual(len(table.rows), round(to / every) + 1)
        return table
