"""Batches, studies and sensitivities against single poses, closed forms and the command."""
import math
import sys

import numpy as np
import pytest
import yoke
from conftest import CRANK, command, example


def test_a_batch_has_the_bits_of_single_poses(crank):
    angles, speeds = np.linspace(0, 6, 40), np.linspace(-5, 5, 40)
    names = ["s", "s.rate", "rod.B.x.accel", "phi"]
    columns = crank.batch(names, theta=angles, rate={"theta": speeds}, accel={"theta": np.ones(40)})
    for k in range(40):
        pose = crank.solve(theta=float(angles[k]), rate={"theta": float(speeds[k])}, accel={"theta": 1.0})
        for name in names[:3]:
            assert columns[name][k] == pose[name]
        assert math.remainder(columns["phi"][k] - pose["phi"], 2 * math.pi) == pytest.approx(0, abs=1e-15)
    assert np.all(columns.status == 0) and columns.array.shape == (4, 40) and list(columns) == names


def test_a_crank_s_slider_is_where_geometry_says():
    m = yoke.parse(CRANK)
    angles = np.linspace(-20, 20, 200_000)  # more than a slice
    x = 0.05 * np.cos(angles) + np.sqrt(0.18**2 - (0.05 * np.sin(angles)) ** 2)
    assert np.allclose(m.batch(["s"], theta=angles)["s"], x, rtol=1e-14, atol=0)


def test_forces_of_a_batch_are_those_of_poses(crank):
    angles = np.linspace(0.1, 6, 25)
    columns = crank.batch(["A.force.x", "theta.effort", "energy"], theta=angles, rate={"theta": 10.0},
                          accel={"theta": 0.0})
    for k, angle in enumerate(angles):
        pose = crank.solve(theta=float(angle), rate={"theta": 10.0}, accel={"theta": 0.0})
        for name in columns:
            assert columns[name][k] == pytest.approx(pose[name], rel=1e-10, abs=1e-10)


def test_poses_out_of_reach_have_a_status():
    m = yoke.load(example("non-grashof"))
    columns = m.batch(["theta4"], at={m.inputs[0]: np.linspace(0, 2 * math.pi, 100)})
    assert (columns.status < 0).any() and (columns.status >= 0).any() and "not reached" in repr(columns)
    assert not np.isnan(columns.array).any()


def test_answers_go_where_they_are_told(crank):
    out = np.full((1, 10), 7.0)
    columns = crank.batch(["s"], theta=np.arange(10.0), out=out)
    assert np.shares_memory(columns["s"], out) and (out != 7).all()


def test_a_sample_has_the_bits_of_the_command(tmp_path, crank_file):
    tolerances = tmp_path / "t.yaml"
    tolerances.write_text("seed: 5\nparameters:\n  r: {normal: [50 mm, 0.1 mm], within: [49.8 mm, 50.2 mm]}\n"
                          "  l: {triangular: [179 mm, 180 mm, 182 mm]}\n")
    path = tmp_path / "a.npy"
    run = command("study", crank_file, "--sample", tolerances, "--designs", "200", "--of", "s,s.rate", "-o", path)
    assert run.returncode == 0, run.stderr
    theirs = np.load(path)
    m = yoke.load(crank_file)
    said = {"r": yoke.normal("50 mm", "0.1 mm", ("49.8 mm", "50.2 mm")),
            "l": yoke.triangular("179 mm", "180 mm", "182 mm")}
    for mine in (m.study(sample=tolerances, designs=200, of="s,s.rate"),
                 m.study(sample=said, seed=5, designs=200, of="s,s.rate")):
        assert mine.dtype.names == theirs.dtype.names
        for name in theirs.dtype.names:
            assert np.array_equal(mine[name].astype(float), theirs[name]), name


def test_a_study_of_every_pose_is_a_sweep_of_every_design():
    m = yoke.parse(CRANK)
    d = m.study(designs={"r": [0.04, 0.05]}, over={"theta": (60, 420, "deg")}, steps=12, of=["s", "s.rate"],
                every_pose=True)
    assert d["s"].shape == (2, 13) and np.all(d["poses"] == 13) and np.all(d["status"] == 0)
    for k, r in enumerate((0.04, 0.05)):
        t = yoke.parse(CRANK, r=r).sweep(theta=(60, 420, "deg"), steps=12, of=["s", "s.rate"])
        assert np.allclose(d["s"][k], t["s"], rtol=1e-14) and np.allclose(d["s.rate"][k], t["s.rate"], atol=1e-13)
    one = m.study(designs={"r": [0.04, 0.05]}, of=["s"])
    assert one.dtype.names == ("r", "status", "poses", "s") and one["s"][1] == m.solve()["s"]


def test_threads_do_not_change_a_bit():
    m = yoke.parse(CRANK)
    first, second = (m.study(vary={"r": (0.03, 0.06, 50), "l": (0.15, 0.2, 20)}, over={"theta": (0, 360, "deg")},
                             of=["s", "A.force"], threads=k) for k in (1, 3))
    assert np.array_equal(first, second) and len(first) == 1000 and first["l"][1] != first["l"][0]


def test_designs_that_cannot_be_built_are_told():
    d = yoke.parse(CRANK).study(designs={"r": [0.05, 0.2, -0.1]}, over={"theta": (0, 360, "deg")}, of=["s"])
    assert d["status"][0] == 0 and d["status"][1] < 0 and d["poses"][1] < 37
    assert np.all(np.isnan(d["s.min"][d["poses"] == 0]))


def test_sensitivities_are_differences_of_poses(crank):
    s = crank.sensitivities(["r", "l"], of=["s", "phi"], theta=(50, "deg"))
    assert np.allclose(s.by_derivative, s.by_difference, rtol=1e-7, atol=1e-9)
    h = 1e-6
    for k, name in enumerate(("r", "l")):
        value = crank.parameter_value(name)
        up, down = (crank.replace(**{name: value + x}).solve(theta=(50, "deg"))["s"] for x in (h, -h))
        assert s.by_derivative[0, k] == pytest.approx((up - down) / (2 * h), rel=1e-6)


def test_a_progress_bar_needs_tqdm_and_nothing_happens_without(crank, monkeypatch, capsys):
    ask = dict(vary={"r": (0.04, 0.06, 20_000)}, over={"theta": (0, 6)}, of=["s"], threads=1)
    crank.study(**ask, progress=True)
    monkeypatch.setitem(sys.modules, "tqdm.auto", None)
    crank.study(**ask, progress=True)
    assert "Error" not in capsys.readouterr().err
