"""What the command refuses is an exception with place and hint; mistakes in Python are reported as clearly."""
import math

import numpy as np
import pytest
import yoke
from conftest import ROOT, command, example


def load_bad(path):
    return yoke.load(path)


BAD = sorted((ROOT / "tests" / "bad").glob("E*.yaml"))


@pytest.mark.parametrize("path", BAD, ids=lambda p: p.stem)
@pytest.mark.filterwarnings("ignore::yoke.YokeWarning")
def test_every_bad_file_is_refused_in_the_words_of_the_command(path):
    run = command("check", path, "--quiet")
    try:
        machine = yoke.load(path)
    except yoke.ModelError as error:
        assert run.returncode == 2
        assert error.text.strip() in run.stderr
        for problem in error.problems:
            assert problem.message in run.stderr and (problem.hint or "") in run.stderr
            assert yoke.explain(problem.code)
    else:
        assert run.returncode != 2
        machine.close()


def test_an_error_has_its_place_and_hint():
    with pytest.raises(yoke.ModelError) as caught:
        yoke.parse("bodies:\n  crank: {points: {A: [0, 0]}}\njoints:\n  O: {pinn: [ground, crank]}\n", "m.yaml")
    problem = caught.value.problems[0]
    assert (problem.line, problem.column) == (4, 7) and problem.hint and problem.code.startswith("E0")
    assert "m.yaml:4:7: error:" in str(caught.value) and "^" in str(caught.value)


def refused(kind, call, *words):
    with pytest.raises(kind) as caught:
        call()
    assert isinstance(caught.value, yoke.Error)
    for word in words:
        assert word in str(caught.value)
    for problem in caught.value.problems:
        assert yoke.explain(problem.code)
    return caught.value


def test_wrong_names_are_refused_with_the_nearest(crank):
    refused(yoke.UnknownName, lambda: crank.solve(teta=1), "`teta`", "did you mean `theta`?")
    refused(yoke.UnknownName, lambda: crank.solve().coordinates["t"], "`t`")
    refused(yoke.UnknownName, lambda: crank.solve()["s.rat"])
    both = refused(yoke.UnknownName, lambda: crank.sweep(theta=(0, 1), of=["x", "y"]))
    assert len(both.problems) == 2
    refused(yoke.UnknownName, lambda: crank.study(vary={"q": (0, 1, 2)}, of=["s"]), "`q`")
    refused(yoke.UnknownName, lambda: crank.derive("poetry"), "poetry")
    assert issubclass(yoke.UnknownName, LookupError) and issubclass(yoke.RequestError, ValueError)


def test_wrong_values_are_refused(crank):
    for value in (math.nan, math.inf, None, True, "thirty", "30 kg", (1, 2), [1.0], np.array([1.0]), 1j, object()):
        refused(yoke.RequestError, lambda: crank.solve(theta=value))
    refused(yoke.RequestError, lambda: crank.solve(theta="1\0"))
    refused(yoke.RequestError, lambda: crank.solve(theta=1, s=0.1), "`s`")
    refused(yoke.RequestError, lambda: crank.solve(method="magic"))
    refused(yoke.RequestError, lambda: crank.sweep(theta=(0, 1), steps=0))
    refused(yoke.RequestError, lambda: crank.sweep(theta=(0, 1), steps=2.5))
    refused(yoke.RequestError, lambda: crank.sweep(theta=1.0))
    refused(yoke.RequestError, lambda: crank.sweep())
    refused(yoke.RequestError, lambda: crank.study(vary={}, over={"theta": 1}, of=["s"]), "E0812")
    refused(yoke.RequestError, lambda: crank.study(vary={}, over="theta", of=["s"]), "E0812")
    refused(yoke.RequestError, lambda: crank.sweep(theta=(0, math.nan)))
    refused(yoke.RequestError, lambda: crank.sweep(theta=(0, 1), of=["s", "s"]), "twice")
    refused(yoke.RequestError, lambda: crank.simulate(to=-1.0))
    refused(yoke.RequestError, lambda: crank.simulate(to=1.0, method="rk4", tolerance=1e-6))
    refused(yoke.RequestError, lambda: crank.code(prefix="1x"))
    refused(yoke.RequestError, lambda: crank.study(of=["s"]))
    refused(yoke.RequestError, lambda: crank.study(vary={"r": (1, 2)}, of=["s"]))
    refused(yoke.RequestError, lambda: crank.study(vary={"r": (0.04, 0.06, 10**8)}, of=["s"]))
    refused(yoke.RequestError, lambda: crank.study(sample={"r": yoke.normal(1, -1)}, of=["s"]))
    refused(yoke.RequestError, lambda: crank.check("s = "))
    refused(yoke.ModelError, lambda: crank.replace(nothing=1))


def test_numpy_scalars_are_numbers(crank):
    one = crank.solve(theta=1.0)["s"]
    assert all(crank.solve(theta=number)["s"] == one for number in (np.float64(1), np.float32(1), np.int32(1), 1))


def test_wrong_arrays_are_refused_and_others_copied(crank):
    good = np.linspace(0, 6, 50)
    want = crank.batch(["s"], theta=good)["s"]
    assert np.array_equal(crank.batch(["s"], theta=np.repeat(good, 2)[::2])["s"], want)  # not contiguous
    assert np.array_equal(crank.batch(["s"], theta=good[::-1])["s"], want[::-1])
    assert np.array_equal(crank.batch(["s"], theta=good.astype(">f8"))["s"], want)
    assert np.array_equal(crank.batch(["s"], theta=list(good))["s"], want)
    assert np.array_equal(crank.batch(["s"], theta=np.arange(3))["s"], crank.batch(["s"], theta=[0.0, 1.0, 2.0])["s"])
    for bad in (np.array(["a"]), np.array([1j]), np.array([None]), np.zeros((2, 2)), 1.0, np.array([True])):
        refused(yoke.RequestError, lambda: crank.batch(["s"], theta=bad))
    broken = good.copy()
    broken[17] = math.nan
    refused(yoke.RequestError, lambda: crank.batch(["s"], theta=broken), "[17]", "nan")
    refused(yoke.RequestError, lambda: crank.batch(["s"], theta=good, rate={"theta": np.zeros(7)}))
    for out in (np.zeros((1, 49)), np.zeros((1, 50), np.float32), np.zeros((1, 100))[:, ::2], good[None]):
        refused(yoke.RequestError, lambda: crank.batch(["s"], theta=good, out=out))
    frozen = np.zeros((1, 50))
    frozen.flags.writeable = False
    refused(yoke.RequestError, lambda: crank.batch(["s"], theta=good, out=frozen))
    assert len(crank.batch(["s"], theta=np.array([]))["s"]) == 0
    refused(yoke.RequestError, lambda: crank.study(designs={"r": [0.05, math.inf]}, of=["s"]))
    refused(yoke.RequestError, lambda: crank.study(designs={"r": [0.05], "l": [0.1, 0.2]}, of=["s"]))


def test_wrong_arrays_of_many_simulations_are_refused_and_nothing_moves(crank):
    many = crank.simulations(4, effort=["theta"], of=["theta", "theta.rate"])
    good = np.arange(4.0)
    for bad in (np.zeros(3), np.zeros((4, 2)), np.zeros((1, 4)), np.array(["a"] * 4), good + 1j, np.zeros(4, bool), [[1], [2, 3]]):
        refused(yoke.RequestError, lambda: many.step(0.01, bad))
    refused(yoke.RequestError, lambda: many.step(0.01, np.array([0, 1, math.nan, 3])), "[2, 0]", "nan")
    for span in (math.nan, math.inf, -0.01, "1 m", None):
        refused(yoke.RequestError, lambda: many.step(span))
    assert np.array_equal(many.time, np.zeros(4))
    for which in (np.zeros(3, bool), [4], [-1], [0.5], [[0], [1]], "all"):
        refused(yoke.RequestError, lambda: many.restart(which))
    other = crank.simulations(4, effort=["theta"], of=["theta", "theta.rate"])
    want = other.step(0.01, good)
    assert np.array_equal(many.step(0.01, np.repeat(good, 2)[::2]), want)  # not contiguous: copied
    assert np.array_equal(many.step(0.01, np.arange(4)), other.step(0.01, good[:, None]))  # integers, a column
    many.close()
    other.close()


def test_an_environment_refuses_what_its_machine_refuses(crank):
    def environment(**more):
        return yoke.Environment(crank, 3, **{"act": ["theta"], "observe": ["theta"], "span": 0.01, **more})

    refused(yoke.UnknownName, lambda: environment(act=["tetha"]), "did you mean")
    refused(yoke.UnknownName, lambda: environment(observe=["tetha"]))
    for more in ({"span": math.nan}, {"span": "1 m"}, {"method": "magic"}, {"threads": 0}, {"start": {"theta": (0, math.nan)}}):
        refused(yoke.RequestError, lambda: environment(**more))
    for answer in ([True], True, np.zeros((3, 1)), [[1], [2, 3]]):
        refused(yoke.RequestError, lambda: environment(ended=lambda seen: answer).step(np.zeros(3)), "ended")
        refused(yoke.RequestError, lambda: environment(reward=lambda seen, actions: answer).step(np.zeros(3)), "reward")
    closed = environment()
    closed.close()
    refused(yoke.ClosedError, lambda: closed.step(np.zeros(3)), "closed")
    refused(yoke.ClosedError, closed.reset, "closed")


def test_names_that_are_no_identifiers_go_through_dictionaries():
    text = """
parameters: {"crank-length": 1}
bodies: {ground: {points: {O: [0, 0]}}, "my body": {points: {O: [0, 0], P: [crank-length, 0]}}}
joints: {O: {pin: [ground, "my body"], angle: "the-angle"}}
start: {"the-angle": 0}
"""
    try:
        m = yoke.parse(text)
    except yoke.ModelError as error:
        assert error.problems[0].line > 0  # the format itself refuses such names
        text = text.replace("the-angle", "angle_").replace("crank-length", "class").replace("my body", "my_body")
        m = yoke.parse(text, parameters={"class": "2 m"})
    name = m.coordinates[0]
    assert m.solve(at={name: 0.5}).coordinates[name].position == 0.5


def test_forces_of_a_machine_without_masses_are_refused():
    m = yoke.load(example("four-bar"))
    refused(yoke.RequestError, lambda: m.sweep(theta2=(0, 1), of=["A.force"]), "E0819")
    refused(yoke.ModelError, lambda: m.simulate(to=1.0), "no body has mass")
    pose = m.solve()
    assert not pose.has_forces and pose.energy is None and math.isnan(pose["A.force"])
    refused(yoke.UnknownName, lambda: pose.reactions["A"])


def test_a_closed_object_is_refused(crank):
    pose, simulation, many = crank.solve(theta=1), crank.simulation(), crank.simulations(3)
    before = pose.coordinates["s"].position
    crank.close()
    for call in (crank.solve, lambda: crank.name, lambda: crank.text, lambda: crank.sweep(theta=(0, 1)), crank.svg,
                 lambda: crank.set("name", "x"), lambda: crank.simulate(to=1), lambda: crank.derive(), crank.report):
        refused(yoke.ClosedError, call, "closed")
    assert "closed" in repr(crank)
    assert pose.coordinates["s"].position == before and simulation.step(1e-3) > 0 and many.step(1e-3) is not None
    simulation.close()
    many.close()
    for call in (lambda: simulation.step(1), simulation.save, lambda: simulation["s"], simulation.reset,
                 lambda: simulation.effort.__setitem__("theta", 1.0), lambda: many.step(1e-3), many.restart):
        refused(yoke.ClosedError, call, "closed")
    with yoke.Machine() as other:
        pass
    refused(yoke.ClosedError, other.solve)


def test_a_loaded_machine_is_not_changed_by_calls(crank):
    refused(yoke.RequestError, lambda: crank.body("more"), "not changed by calls")


def test_a_file_that_is_not_there(tmp_path):
    with pytest.raises(FileNotFoundError):
        yoke.load(tmp_path / "nothing.yaml")


def test_output_appears_whole_or_not_at_all(crank, tmp_path):
    with pytest.raises(OSError):
        crank.report(tmp_path / "no" / "such" / "folder.html")
    with pytest.raises(OSError):
        crank.code(tmp_path)
    assert sorted(p.name for p in tmp_path.iterdir()) == ["crank.yaml"]


def test_a_warning_of_a_file_is_a_python_warning():
    text = "units: {length: mm}\ngravity: [0, -9.81]\nbodies: {b: {mass: 1}}\n"
    text += "joints: {J: {pin: [ground, b], angle: q}}\n"
    with pytest.warns(yoke.YokeWarning, match="W0431"):
        yoke.parse(text)


def test_a_limit_of_a_sweep_is_told_in_the_words_of_the_command():
    run = command("sweep", example("quick-return"), "--over", "theta1=30:-90deg", "--steps", "24", "--of", "d5")
    t = yoke.load(example("quick-return")).sweep(theta1=(30, -90, "deg"), steps=24, of=["d5"])
    assert t.status == "limit" and t.message in run.stderr and len(t) < 25 and t.events[-1].kind == "limit"


def test_what_the_machine_passed_on_its_way_is_noted():
    told = 0
    for name in ("parallelogram", "change-point-four-bar", "kite", "five-bar"):
        m = yoke.load(example(name))
        coordinate = m.inputs[0]
        value = m.solve()[coordinate] + 4.0
        run = command("solve", example(name), "--at", f"{coordinate}={value!r}rad")
        try:
            pose = m.solve(at={coordinate: value})
        except yoke.PoseError:
            assert run.returncode == 1
            continue
        for note in pose.notes:
            assert note.message in run.stderr and note.code in run.stderr
        told += len(pose.notes)
        assert ("N0610" in run.stderr) == any(note.code == "N0610" for note in pose.notes)
    assert told > 0


def test_a_pose_of_another_machine_has_no_place_in_equations(crank):
    refused(yoke.RequestError, lambda: crank.derive("loops", pose=yoke.load(example("four-bar")).solve()))
    assert "0.2" in str(crank.derive("loops", pose=crank.solve(theta=0.0)))


def test_what_is_said_twice_or_hidden_is_refused(crank):
    refused(yoke.RequestError, lambda: crank.solve(theta=1, at={"theta": 2}), "`theta` stands in `at` and beside it")
    refused(yoke.RequestError, lambda: crank.batch(["s"], theta=np.ma.array([1.0, 2.0], mask=[False, True])), "without masked entries")
    assert len(crank.batch(["s"], theta=np.ma.array([1.0, 2.0]))) > 0
    with crank.simulation() as sim:
        pass
    with pytest.raises(yoke.ClosedError):
        sim.effort["theta"]
