"""Many copies in SIMD lanes, against simulations of each alone."""
import math
import os
from pathlib import Path

import numpy as np
import pytest

import yoke

EXAMPLES = Path(os.environ["YOKE_ROOT"]) / "examples"
COLUMNS = ["x", "theta", "x.rate", "theta.rate"]


def cart():
    return yoke.load(EXAMPLES / "cart-pendulum.yaml")


def many_of(m, count, **more):
    return m.simulations(count, of=more.pop("of", COLUMNS), effort=["x"], method="rk4", step="10 ms",
                         at={"theta": np.linspace(-3, 3, count)}, rate={"x": (0.5, "m/s")}, **more)


def test_a_copy_in_lanes_is_the_simulation_alone():
    m, count = cart(), 70
    many, alone = many_of(m, count, threads=3), many_of(m, count, threads=1)
    apart = many_of(m, count, of=[*COLUMNS, "energy"])
    assert many.lanes and alone.lanes and not apart.lanes
    assert np.allclose(many.values, apart.values[:, :4], rtol=0, atol=1e-15)
    efforts = 5 * np.sin(np.arange(12 * count)).reshape(12, count)
    for row in efforts:
        values = many.step(0.025, row)  # two whole steps and a cut one
        assert np.array_equal(values, alone.step(0.025, row[:, None]))
        assert np.allclose(values, apart.step(0.025, row)[:, :4], rtol=0, atol=1e-11)
    assert np.allclose(many.time, apart.time, rtol=0, atol=1e-14) and not many.status.any()
    kept = many.values.copy()
    for one in (many, apart):
        one.restart([3, 40], at={"theta": [0.5, 0.6]}, rate={"x": [0.0, 1.0]})
        assert np.array_equal(one.time[[3, 40, 41]] > 0, [False, False, True])
    assert np.array_equal(many.values[[3, 40]], [[0, 0.5, 0, 0], [0, 0.6, 1, 0]])
    assert np.array_equal(np.delete(many.values, [3, 40], 0), np.delete(kept, [3, 40], 0))
    assert np.allclose(many.step(0.02), apart.step(0.02)[:, :4], rtol=0, atol=1e-11)  # efforts stay, or begin with 0


def test_what_lanes_cannot_do_is_done_one_by_one():
    m = cart()
    assert not m.simulations(3, of=["x"], effort=["x"]).lanes  # steps that adapt differ from copy to copy
    assert not m.simulations(3, of=["x"], method="rk4", step=0.01).lanes  # the file's effort depends on the time
    crank = yoke.load(EXAMPLES / "crank-press.yaml")
    assert not crank.simulations(2, of=["theta"], method="rk4", step=1e-4).lanes  # a loop
    many = many_of(m, 4)
    for bad in (np.zeros(3), np.full(4, np.nan)):
        with pytest.raises(yoke.RequestError):
            many.step(0.02, bad)
    for bad in (-1, 1e14):
        with pytest.raises(yoke.RequestError):
            many.step(bad)
    with pytest.raises(yoke.RequestError):
        many.restart([0], at={"theta": [math.nan]})
    many.close()
    with pytest.raises(yoke.ClosedError):
        many.step(0.02)


def test_a_copy_that_runs_away_stands_still():
    many = many_of(cart(), 40)
    efforts = np.zeros(40)
    efforts[7] = 1e306
    values = many.step(10.0, efforts)
    assert many.status[7] < 0 and many.time[7] < 10 and np.isfinite(values).all()
    assert not np.delete(many.status, 7).any() and many.time[8] == 10
    many.restart([7], at={"theta": [1.0]}, rate={"x": [0.0]})
    many.step(0.5)
    assert not many.status.any() and many.time[7] == 0.5


def test_an_environment_of_carts_runs_in_lanes():
    e = yoke.Environment(cart(), 3, act=["x"], observe=COLUMNS, span="20 ms", start={"theta": (3.1, 3.2)})
    assert e.simulations.lanes
