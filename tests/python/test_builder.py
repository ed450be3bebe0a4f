"""Machines made by calls are the machines of their files."""
import copy
import math
import pickle

import numpy as np
import pytest
import yoke
from conftest import CRANK, command, example


def four_bar():
    m = yoke.Machine("four-bar").units(length="mm", angle="deg").parameter("a", "40 mm")
    m.body("ground", {"O": (0, 0), "C": (100, 0)})
    m.body("crank", {"O": (0, 0), "A": ("a", 0)}, mass="0.2 kg", rod=("O", "A"))
    m.body("coupler", {"A": (0, 0), "B": (120, 0)}).body("rocker", {"C": (0, 0), "B": (80, 0)})
    m.pin("O", "ground", "crank", angle="theta").pin("A", "crank", "coupler", angle="phi").pin("B", "coupler", "rocker")
    return m.pin("C", "ground", "rocker", angle="psi").drive("theta", "60 deg + 30 rpm * t").start("psi", "100 deg")


def test_a_machine_from_nothing_solves_its_loop():
    m = four_bar()
    assert m.freedom == 1 and m.inputs == ("theta",) and len(m.bodies) == 4
    p = m.solve()
    b = np.array(p.points["coupler.B"].position)
    assert math.isclose(np.hypot(*(b - p.points["crank.A"].position)), 0.12, rel_tol=1e-14)
    assert math.isclose(np.hypot(*(b - [0.1, 0])), 0.08, rel_tol=1e-14)
    assert p.coordinates["theta"] == pytest.approx((math.pi / 3, math.pi, 0.0), rel=1e-15)


def test_its_text_is_a_file_with_the_same_bits(tmp_path):
    m = four_bar()
    path = m.write(tmp_path / "made.yaml")
    again = yoke.load(path)
    assert again.solve(theta=2.0)["psi"] == m.solve(theta=2.0)["psi"] and again.text == path.read_text()
    assert command("check", path).returncode == 0


def test_every_kind_of_part_can_be_said():
    m = yoke.Machine("all").gravity(0, -9.81)
    m.body("ground", {"O": (0, 0), "P": (1, 0), "Q": (0, 1)})
    m.body("arm", {"O": (0, 0), "E": (0.5, 0)}, mass=1, center=(0.2, 0), inertia=0.1)
    m.body("box", mass=2, inertia=0.2).body("plate", {"F": (0, 0)}, mass=1, inertia=1)
    m.body("pin", {"G": (0, 0)}, mass=1, inertia=1)
    m.body("tip", {"E": (0, 0)}, mass=0.1)
    m.pin("O", "ground", "arm", angle="theta").weld("E", "arm", "tip").slide("S", "ground", "box", "x", distance="d")
    m.free("F", "ground", "plate", x="px", y="py", angle="pa")
    m.slot("G", "ground", "pin", "30 deg", at="G", distance="g", angle="ga")
    m.effort("theta", "0.5").force("push", "box", "3 N", "1 N/s * t")
    m.spring("k", "ground.P", "arm.E", stiffness=100, length=0.2, damping=1)
    m.spring("c", "d", stiffness="50 N/m").stop("theta", "-170 deg", "170 deg").start("theta", 0.3)
    pose = m.solve()
    assert m.freedom == 7 and pose.has_forces and pose["d.accel"] == pytest.approx((3 - 50 * pose["d"]) / 2)
    gears = yoke.Machine("gears").body("one").body("two").body("ground", {"A": (0, 0), "B": (0.1, 0)})
    gears.pin("A", "ground", "one", angle="a").pin("B", "ground", "two", angle="b")
    gears.gear("mesh", "one", "two", (20, 40)).drive("a", "1 rad/s * t")
    assert gears.solve(time=1.0)["b.rate"] == -0.5


def test_a_mistake_names_the_body_and_the_joint():
    m = yoke.Machine("wrong").body("crank", {"A": (0, 0)}).pin("O", "ground", "crnk")
    with pytest.raises(yoke.ModelError) as caught:
        m.solve()
    problem = caught.value.problems[0]
    assert problem.where.startswith("joint `O`") and "crank" in (problem.hint or "")
    m.pin("O", "ground", "crank", at=None).body("ground", {"O": (0, 0)}).point("crank", "O", 0, 0)
    assert m.freedom == 1  # mended, it goes on


def test_changes_are_seen_and_can_be_taken_back():
    m = four_bar()
    before = m.solve(theta=1.0)["psi"]
    m.parameter("a", "30 mm")
    changed = m.solve(theta=1.0)["psi"]
    assert changed != before
    assert m.parameter("a", "40 mm").solve(theta=1.0)["psi"] == before
    m.effort("theta", 1).remove("efforts")
    assert "efforts" not in m.text


def test_numbers_keep_their_bits():
    value = 0.1 + 0.2
    m = yoke.Machine().body("ground", {"O": (0, 0)}).body("b", {"O": (0, 0), "P": (value, 1e-300)})
    assert m.pin("O", "ground", "b", angle="q").solve(q=0.0).points["b.P"].position == (value, 1e-300)


@pytest.mark.parametrize("word", ["nan", "inf"])
def test_numbers_that_are_none_are_refused(word):
    with pytest.raises(yoke.RequestError):
        yoke.Machine().body("b", mass=float(word))
    with pytest.raises(yoke.RequestError):
        yoke.Machine().body("b", {"P": (float(word), 0)})


def test_machines_poses_tables_and_simulations_can_be_pickled():
    for m in (four_bar(), yoke.load(example("toggle"), l1="0.11 m"), yoke.parse(CRANK, r=0.06)):
        again = pickle.loads(pickle.dumps(m))
        name = m.inputs[0]
        assert again.solve().label == m.solve().label and again.name == m.name
        pose = m.solve(at={name: 1.1}) if m.name != "Toggle linkage" else m.solve()
        other = pickle.loads(pickle.dumps(pose))
        assert list(other.coordinates.items()) == list(pose.coordinates.items()) and other.status == pose.status
        table = m.sweep(at={name: (1.0, 1.2)}, steps=4)
        back = pickle.loads(pickle.dumps(table))
        assert np.array_equal(back, table) and back.columns == table.columns and back.events == table.events
    sim = m.simulation()
    sim.effort["theta"] = 1.5
    sim.step(0.1)
    other = pickle.loads(pickle.dumps(sim))
    assert other.time == sim.time and other.effort["theta"] == 1.5
    assert other.step(0.1) == sim.step(0.1) and other["theta"] == sim["theta"]
    assert copy.deepcopy(m).solve(theta=1.0)["s"] == m.solve(theta=1.0)["s"]
    found = m.configurations(theta=1.0)
    assert [p["s"] for p in pickle.loads(pickle.dumps(found))] == [p["s"] for p in found]


def test_reprs_tell_something():
    m = four_bar()
    assert repr(m) == "<yoke.Machine 'four-bar': 3 bodies, 4 joints, freedom 1, inputs theta>"
    assert "theta=1" in repr(m.solve(theta=1.0)) and "not yet whole" in repr(yoke.Machine().pin("A", "b", "c"))
    assert "3 poses" in repr(m.batch(["psi"], theta=[0.1, 0.2, 0.3]))
    assert "true" in repr(m.check("psi = psi"))


def test_replace_keeps_the_configuration():
    m = yoke.load(example("four-bar"))
    other = m.replace(a="45 mm")
    assert other.solve().label == m.solve().label and other.parameter_value("a") == 0.045
    assert four_bar().replace(a="35 mm").parameter_value("a") == 0.035
