"""The requests for the package, as they were first written down."""
import math

import numpy as np
import yoke
from conftest import example


def test_a_pose_in_one_line(crank_file):
    m = yoke.load(crank_file, r="60 mm")
    s = m.solve(theta="30 deg").coordinates["s"].position
    a = math.pi / 6
    assert math.isclose(s, 0.06 * math.cos(a) + math.sqrt(0.18**2 - (0.06 * math.sin(a)) ** 2), rel_tol=1e-14)
    assert "s" in m.solve(theta="30 deg").table("mm", "deg")


def test_a_sweep_is_a_structured_array_without_a_copy(crank_file):
    m = yoke.load(crank_file, r="60 mm")
    t = m.sweep(theta=(0, 360, "deg"), steps=360, of=["s", "s.rate", "A.force"])
    assert isinstance(t, np.ndarray) and t.dtype.names == ("theta", "s", "s.rate", "A.force")
    assert len(t) == 361 and t["theta"][-1] == 2 * math.pi
    assert t.base is not None and not t.flags.owndata
    a = t["theta"]
    assert np.allclose(t["s"], 0.06 * np.cos(a) + np.sqrt(0.18**2 - (0.06 * np.sin(a)) ** 2), rtol=1e-13)


def test_motion_and_a_study(crank_file):
    m = yoke.load(crank_file, r="60 mm")
    t = m.simulate(to="2 s", of=["theta", "energy"])
    assert np.ptp(t["energy"]) < 1e-7 * t["energy"][0] and t["t"][-1] == 2.0
    d = m.study(vary={"r": ("40 mm", "60 mm", 100)}, over={"theta": (0, 360, "deg")}, of=["s"])
    assert np.allclose(d["s.range"], 2 * d["r"], rtol=1e-12)


def test_equations_and_a_verdict():
    m = yoke.load(example("quick-return"))
    assert m.derive("loops").latex().startswith("\\documentclass")
    assert yoke.load(example("double-pendulum")).derive("lagrange").latex().count("\\ddot") > 3
    assert m.check("d3' = -l1*theta1'*sin(theta1 - theta2)").verdict == "true"
    assert not m.check("d3' = l1*theta1'*sin(theta1 - theta2)")


def test_configurations_report_and_code(crank_file, tmp_path):
    m = yoke.load(crank_file, r="60 mm")
    assert [p.label for p in m.configurations()] == ["B+", "B-"] and m.configurations().complete
    m.report(tmp_path / "crank.html")
    m.code(tmp_path / "crank.c")
    assert (tmp_path / "crank.html").read_text().startswith("<!DOCTYPE html>")
    assert "#include" in (tmp_path / "crank.c").read_text()
    assert sorted(p.name for p in tmp_path.iterdir()) == ["crank.c", "crank.html", "crank.yaml"]


def test_the_host_loop(crank_file):
    m = yoke.load(crank_file, r="60 mm")
    sim = m.simulation()
    sim.effort["theta"] = 2.0
    sim.step(1e-3)
    s = sim.save()
    first = [sim.step(1e-3) and sim["theta"] for _ in range(5)]
    sim.restore(s)
    assert [sim.step(1e-3) and sim["theta"] for _ in range(5)] == first
    many = m.simulations(64)
    assert many.step(1e-3).shape == (64, 4)
