"""Every example gives the same bits in Python as by the command."""
import json
import math

import numpy as np
import pytest
import yoke
from conftest import answer, command, examples, example

def same(a, b):
    """Numbers with the same bits; null is NaN."""
    if b is None:
        return math.isnan(a)
    return a == b


def same_all(mine, theirs):
    assert len(mine) == len(theirs)
    for a, b in zip(mine, theirs):
        assert same(a, b), (mine, theirs)


def check_pose(pose, told):
    assert list(pose.coordinates) == list(told["coordinates"])
    for name, m in told["coordinates"].items():
        same_all(pose.coordinates[name], (m["position"], m["velocity"], m["acceleration"]))
    for name, m in told["bodies"].items():
        same_all(pose.bodies[name], (m["angle"], m["rate"], m["acceleration"]))
    for name, m in told["points"].items():
        for mine, theirs in zip(pose.points[name], (m["position"], m["velocity"], m["acceleration"])):
            same_all(mine, theirs)
    same_all(list(pose.transmission.values()), list(told["transmission"].values()))
    assert pose.has_forces == ("reactions" in told)
    for name, r in {**told.get("reactions", {}), **told.get("contacts", {})}.items():
        mine = pose.reactions[name]
        assert (mine.by, mine.on) == (r["by"], r["on"])
        same_all((*mine.force, mine.moment), (*r["force"], r["moment"]))
    for name, value in told.get("efforts", {}).items():
        if isinstance(value, (int, float)):
            assert pose.efforts[name].value == value
    if "energy" in told:
        assert tuple(pose.energy) == (told["energy"]["kinetic"], told["energy"]["potential"])


@pytest.mark.parametrize("path", examples(), ids=lambda p: p.stem)
@pytest.mark.filterwarnings("ignore::yoke.YokeWarning")
def test_a_pose_has_the_bits_of_the_command(path):
    told = answer("solve", path)
    try:
        pose = yoke.load(path).solve()
    except yoke.PoseError as error:
        assert told["configurations"] == [] and error.status == told["status"]
        return
    assert pose.status == told["status"]
    check_pose(pose, told["configurations"][0])


CASES = [("slider-crank", {"theta": "200 deg"}), ("four-bar", {"theta2": "130 deg"}),
         ("quick-return", {"theta1": "1 rad"}), ("toggle", {"theta1": "100 deg"}),
         ("cart-pendulum", {"theta": "-0.3 rad", "x": "20 cm"}),
         ("double-pendulum", {"theta2": "170 deg"}), ("watt-six-bar", {"theta2": "75 deg"})]


@pytest.mark.parametrize("name, at", CASES)
def test_a_moved_pose_has_the_bits_of_the_command(name, at):
    words = [w for n, v in at.items() for w in ("--at", f"{n}={v}")]
    run = command("solve", example(name), *words, "--format", "json")
    m = yoke.load(example(name))
    if run.returncode == 2:
        with pytest.raises(yoke.RequestError):
            m.solve(at=at)
        return
    told = json.loads(run.stdout)
    if not told["configurations"]:
        with pytest.raises(yoke.PoseError) as caught:
            m.solve(at=at)
        assert caught.value.status == told["status"]
        return
    check_pose(m.solve(at=at), told["configurations"][0])
    check_pose(m.solve(at=at), told["configurations"][0])  # from memory that was used before


def test_a_limit_is_told_in_the_words_of_the_command():
    run = command("solve", example("quick-return"), "--at", "theta1=-60deg")
    with pytest.raises(yoke.PoseError) as caught:
        yoke.load(example("quick-return")).solve(theta1="-60 deg")
    assert run.returncode == 1
    problem = caught.value.problems[0]
    assert problem.code in run.stderr and problem.message in run.stderr


def test_other_rates_efforts_and_times_have_the_bits_of_the_command():
    toggle, m = example("toggle"), yoke.load(example("toggle"))
    told = answer("solve", toggle, "--rate", "theta1=4rad/s", "--effort", "theta1=3N*m", "--param", "l1=11cm")
    check_pose(yoke.load(toggle, l1="11 cm").solve(rate={"theta1": "4 rad/s"}, effort={"theta1": 3.0}),
               told["configurations"][0])
    told = answer("solve", toggle, "--accel", "theta1=1rad/s^2")
    check_pose(m.solve(accel={"theta1": 1.0}), told["configurations"][0])
    told = answer("solve", example("quick-return"), "--time", "1s")
    check_pose(yoke.load(example("quick-return")).solve(time="1 s"), told["configurations"][0])


def test_all_configurations_are_those_of_the_command():
    for name, at in (("four-bar", "theta2=100deg"), ("quick-return", "theta1=40deg")):
        told = answer("solve", example(name), "--all", "--at", at)
        coordinate, value = at.split("=")
        found = yoke.load(example(name)).configurations(at={coordinate: value})
        assert len(found) == len(told["configurations"]) > 1 and found.complete == told["complete"]
        for mine, theirs in zip(found, told["configurations"]):
            check_pose(mine, theirs)
            assert mine.is_start == theirs["is_start"] and mine.label == theirs["label"]


SWEEPS = [("quick-return", "theta1", "30:390deg", (30, 390, "deg"), "d5,d5.rate,d5.accel,ram.C.x"),
          ("slider-crank", "theta", "0:360deg", (0, 360, "deg"), "x,x.rate,psi"),
          ("quick-return", "t", "0:4s", (0, 4, "s"), "d5,theta2.rate")]


@pytest.mark.parametrize("name, swept, words, over, of", SWEEPS)
def test_a_sweep_has_the_bits_of_the_command(name, swept, words, over, of):
    told = answer("sweep", example(name), "--over", f"{swept}={words}", "--steps", "48", "--of", of)
    t = yoke.load(example(name)).sweep(steps=48, of=of, **{swept: over})
    assert t.status == told["status"]
    rows = told["rows"]
    assert len(t) == len(rows)
    for mine, theirs in zip(t.tolist(), rows):
        same_all(mine, list(theirs.values()) if isinstance(theirs, dict) else theirs)
    assert len(t.events) == len(told["events"])


def test_motion_has_the_bits_of_the_command():
    told = answer("simulate", example("double-pendulum"), "--to", "1s", "--steps", "20", "--of", "theta1,theta2,energy")
    t = yoke.load(example("double-pendulum")).simulate(to="1 s", steps=20, of=["theta1", "theta2", "energy"])
    assert [list(row) for row in t.tolist()] == [list(r.values()) if isinstance(r, dict) else r for r in told["rows"]]


def test_a_study_has_the_bits_of_the_command(tmp_path):
    path = tmp_path / "answer.npy"
    run = command("study", example("four-bar"), "--vary", "a=35mm:45mm:7", "--vary", "b=100mm:120mm:5", "--over",
                  "theta2=0:360deg", "--steps", "24", "--of", "theta4,coupler.P.y", "-o", path)
    m = yoke.load(example("four-bar"))
    if run.returncode != 0:
        pytest.fail(run.stderr)
    theirs = np.load(path)
    mine = m.study(vary={"a": ("35 mm", "45 mm", 7), "b": ("100 mm", "120 mm", 5)}, over={"theta2": (0, 360, "deg")},
                   steps=24, of="theta4,coupler.P.y")
    theirs = theirs.view(np.float64).reshape(len(mine), -1) if theirs.dtype.names else theirs
    for k, name in enumerate(mine.dtype.names):
        assert np.array_equal(mine[name].astype(float), theirs[:, k], equal_nan=True), name


def test_parameters_in_si_are_read_back_to_the_last_bit(crank_file):
    for value in (0.0523, 0.1 / 3, 0.06):
        m = yoke.load(crank_file, r=value)
        assert m.parameter_value("r") == value
        assert m.solve(theta=0.0).coordinates["s"].position == pytest.approx(value + 0.18, rel=1e-15)
