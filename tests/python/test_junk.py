"""Whatever is handed to a method, it answers or refuses in its own words; nothing crashes."""
import inspect
import random

import numpy as np
import pytest
import yoke
from conftest import CRANK

JUNK = [
    None, True, 0, -1, 3, 1.5, float("nan"), float("inf"), -1e-308, "", "theta", "s", "30 deg", "60 mm", "1\0", "é",
    "A.force", "energy", "t", "x" * 300, b"ab", (), (1,), (1, 2), (0, 360, "deg"), (30, "deg"), ("0 deg", "1 rad"),
    (1, 2, 3), (1, 2, 3, 4), [], ["s"], ["s", "phi"], [1], {}, {"theta": 1}, {"theta": (0, 1)}, {"r": (0.04, 0.06, 3)},
    {"r": [0.04, 0.05]}, {"s": "1 mm"}, {"t": (0, 1)}, {1: 2}, np.zeros(3), np.zeros((3, 1)), np.array(1.0),
    np.float32(2), np.array(["a"]), lambda *a: 1, object(), complex(1, 2), yoke.normal(0.05, 0.001),
    {"r": yoke.normal(0.05, 0.001)}, "nearest", "B+", 2, range(3),
]
QUESTIONS = ["solve", "configurations", "regions", "sweep", "batch", "study", "sensitivities", "simulate", "simulation",
             "simulations", "derive", "check", "code", "svg", "replace", "value", "parameter_value",
             "set", "body", "pin", "remove",
             "spring", "drive", "start", "units", "free", "gear", "stop"]
LONG = {"step", "advance", "rows", "close", "simulate"}  # with numbers that are too large they take long, rightly


def arguments(random_, method):
    args, more = [], {}
    for p in inspect.signature(method).parameters.values():
        if p.name == "path" or p.kind == p.VAR_POSITIONAL:
            continue
        if p.kind == p.VAR_KEYWORD:
            if random_.random() < 0.5:
                more[random_.choice(["theta", "s", "phi", "r", "zz", "t"])] = random_.choice(JUNK)
        elif p.kind == p.KEYWORD_ONLY:
            if random_.random() < 0.35 and p.name != "progress":
                more[p.name] = random_.choice(JUNK)
        elif p.default is p.empty or random_.random() < 0.3:
            args.append(random_.choice(JUNK))
    return args, more


@pytest.mark.filterwarnings("ignore")
@pytest.mark.parametrize("seed", range(4))
def test_junk_is_answered_or_refused(seed):
    random_ = random.Random(seed)
    m = yoke.parse(CRANK)
    simulation, many = m.simulation(), m.simulations(4, effort=["theta"])
    refused = 0
    for _ in range(500):
        target = random_.choice([m, m, m, yoke.Machine("b").body("ground", {"O": (0, 0)}), simulation, many])
        names = QUESTIONS if isinstance(target, yoke.Machine) else [
            n for n in dir(target) if not n.startswith("_") and n not in LONG and inspect.ismethod(getattr(target, n))]
        method = getattr(target, random_.choice(names))
        args, more = arguments(random_, method)
        try:
            method(*args, **more)
        except (yoke.Error, TypeError):
            refused += 1
    assert refused > 100 and m.solve(theta=1.0).status == "ok" and simulation.step(1e-3) > 0
