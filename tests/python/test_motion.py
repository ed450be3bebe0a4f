"""Simulations in the hands of a host: energy, acts, saving, controls, many at once."""
import math

import numpy as np
import pytest
import yoke
from conftest import example

PENDULUM = """\
gravity: [0, -9.81]
bodies: {ground: {points: {O: [0, 0]}}, rod: {points: {O: [0, 0], P: [0, -1]}, mass: 2, center: [0, -1]}}
joints: {O: {pin: [ground, rod], angle: q}}
start: {q: 0.3}
"""


def pendulum(**parameters):
    return yoke.parse(PENDULUM, **parameters)


def test_a_pendulum_keeps_its_energy_and_its_period():
    t = pendulum().simulate(to=10.0, steps=1000, of=["q", "q.rate", "energy"], tolerance=1e-12)
    assert np.ptp(t["energy"]) < 1e-9
    assert np.allclose(t["energy"], 2 * (0.5 * t["q.rate"] ** 2 - 9.81 * np.cos(t["q"])), rtol=1e-8)
    # the period of a pendulum, by the arithmetic-geometric mean (Gauss)
    a, b = 1.0, math.cos(0.15)
    for _ in range(6):
        a, b = (a + b) / 2, math.sqrt(a * b)
    period = 2 * math.pi * math.sqrt(1 / 9.81) / a
    crossings = pendulum().simulate(to=10.0, events={"q": 0.0}, tolerance=1e-12).events
    times = [e.at for e in crossings]
    assert np.allclose(np.diff(times), period / 2, atol=1e-7) and {e.kind for e in crossings} == {"crossing"}


def test_rows_come_at_the_times_that_are_asked():
    m = pendulum()
    assert np.array_equal(m.simulate(to=1.0, every=0.25)["t"], [0, 0.25, 0.5, 0.75, 1.0])
    assert np.array_equal(m.simulate(to=1.0, every=0.4)["t"], [0, 0.4, 0.8, 1.0])
    t = m.simulate(to="100 ms", every="20 ms", of="q,energy")
    assert t.dtype.names == ("t", "q", "energy") and len(t) == 6 and t.status == "ok"


def test_start_values_are_those_that_were_asked():
    m = pendulum()
    t = m.simulate(to=0.1, steps=1, of=["q", "q.rate"], q=(40, "deg"), rate={"q": -2.0})
    assert t["q"][0] == math.radians(40) and t["q.rate"][0] == -2.0


def test_an_effort_does_its_work():
    with pendulum().simulation(effort={"q": 0.0}, tolerance=1e-12) as sim:
        sim.effort["q"] = 3.0
        start, before = sim["q"], sim["energy"]
        sim.advance(0.2)
        first, sim.effort["q"] = sim["q"], -1.0
        sim.advance("400 ms")
        work = 3.0 * (first - start) - 1.0 * (sim["q"] - first)
        assert sim["energy"] - before == pytest.approx(work, abs=1e-10)
        assert sum(sim.work.values()) == pytest.approx(work, abs=1e-10)
        assert dict(sim.effort) == {"q": -1.0} and sim.time == 0.4


def test_saving_restoring_resetting_and_cloning_keep_the_bits():
    sim = yoke.load(example("double-pendulum")).simulation()
    start = [sim.step(0.01) and sim["theta1"] for _ in range(10)]
    saved = sim.save()
    other = sim.clone()
    next_ones = [sim.step(0.01) and sim["theta1"] for _ in range(10)]
    assert [other.step(0.01) and other["theta1"] for _ in range(10)] == next_ones
    sim.restore(saved)
    assert [sim.step(0.01) and sim["theta1"] for _ in range(10)] == next_ones
    sim.reset()
    assert [sim.step(0.01) and sim["theta1"] for _ in range(10)] == start
    with pytest.raises(yoke.Error):
        sim.restore(saved[:-1])
    with pytest.raises(yoke.Error):
        sim.restore(b"")
    with pytest.raises(yoke.Error):
        pendulum().simulation().restore(saved)


def test_a_control_is_called_at_its_samples_and_can_end_the_advance():
    sim = pendulum().simulation(effort={"q": 0.0})
    seen = []

    def control(s, time):
        seen.append(time)
        s.effort["q"] = -20 * s["q"] - 8 * s["q.rate"]
        return time < 2.95

    sim.control("100 ms", control)
    reached = sim.advance(10.0)
    assert np.allclose(seen, np.arange(31) * 0.1) and reached == seen[-1]
    assert abs(sim["q"]) < 0.01


def test_what_a_control_raises_comes_out():
    sim = pendulum().simulation(effort={"q": 0.0})

    def control(s, time):
        if time > 0.5:
            raise KeyError("mine")

    sim.control(0.1, control)
    with pytest.raises(KeyError, match="mine"):
        sim.advance(1.0)
    sim.control(0.1, None)
    assert sim.advance(1.0) == 1.0
    with pytest.raises(yoke.RequestError):
        sim.control(0.0, control)


def test_a_motion_that_ends_says_why():
    m = pendulum()
    sim = m.simulation()
    sim.advance(1.0)
    for bad in (0.5, math.inf, math.nan):
        with pytest.raises(yoke.RequestError):
            sim.advance(bad)
    with pytest.raises(yoke.RequestError):
        sim.effort["q"] = 1.0  # none was there when it began
    with pytest.raises(yoke.RequestError):
        m.simulate(to=1.0, rate={"nothing": 1.0})


def test_many_simulations_are_each_the_one():
    m = pendulum()
    starts = np.linspace(-1, 1, 33)
    many = m.simulations(33, of=["q", "q.rate"], effort=["q"], at={"q": starts}, threads=2)
    efforts = np.sin(np.arange(5 * 33)).reshape(5, 33)
    for row in efforts:
        values = many.step(0.02, row)
    alone = m.simulations(33, of=["q", "q.rate"], effort=["q"], at={"q": starts}, threads=1)
    for row in efforts:
        alone.step(0.02, row)
    assert np.array_equal(values, alone.values) and np.all(many.status == 0) and np.allclose(many.time, 0.1)
    for k in (0, 7, 32):
        one = m.simulation(effort={"q": 0.0}, at={"q": float(starts[k])})
        for row in efforts:
            one.effort["q"] = row[k]
            one.step(0.02)
        assert (one["q"], one["q.rate"]) == tuple(values[k])
    many.restart([3, 4], at={"q": [0.5, 0.6]})
    assert many.values[3, 0] == 0.5 and many.values[4, 0] == 0.6 and many.values[5, 0] == values[5, 0]
    assert many.time[3] == 0 and many.time[5] > 0
    for bad in (np.zeros(32), np.zeros((33, 2)), np.full(33, np.nan)):
        with pytest.raises(yoke.RequestError):
            many.step(0.02, bad)
    with pytest.raises(yoke.RequestError):
        many.restart([33])
    with pytest.raises(yoke.RequestError):
        many.restart(np.zeros(5, bool))
    with pytest.raises(yoke.RequestError):
        m.simulations(0)


def cart_pole(count, **more):
    m = yoke.load(example("cart-pendulum"))
    return yoke.Environment(m, count, act=["x"], observe=["x", "theta", "x.rate", "theta.rate"], span=0.02,
                            start={"theta": (math.pi - 0.05, math.pi + 0.05), "x": (-0.05, 0.05)},
                            ended=lambda o: abs(o[:, 1] - math.pi) > 0.2, **more)


def test_an_environment_gives_each_copy_its_own_numbers():
    few, many = cart_pole(3), cart_pole(8)
    a, _ = few.reset(seed=7)
    b, _ = many.reset(seed=7)
    assert np.array_equal(a, b[:3]) and len({x for x in b[:, 1]}) == 8
    assert np.all(abs(b[:, 1] - math.pi) <= 0.05) and not np.array_equal(many.reset(seed=8)[0], b)
    few.reset(seed=7)
    many.reset(seed=7)
    for _ in range(60):
        first, second = few.step(np.zeros(3)), many.step(np.zeros(8))
        assert np.array_equal(first[0], second[0][:3]) and np.array_equal(first[2], second[2][:3])


def test_an_environment_ends_cuts_off_and_restarts():
    e = cart_pole(4, most=30)
    e.reset(seed=1)
    ended = cut = 0
    for k in range(100):
        was_over = e._over.copy()
        o, reward, over, short, info = e.step(np.zeros((4, 1)))
        assert np.all(reward[was_over] == 0) and np.all(reward[~was_over] == 1) and not np.any(over & short)
        assert np.all(abs(o[was_over, 1] - math.pi) <= 0.05) and np.all(info["status"] == 0)
        ended, cut = ended + over.sum(), cut + short.sum()
    assert ended + cut >= 8


def test_a_linear_control_holds_the_pole_up():
    e = cart_pole(64, most=10_000)
    o, _ = e.reset(seed=3)
    for _ in range(400):
        o, _, over, _, _ = e.step(3 * o[:, 0] + 5 * o[:, 2] - 70 * (o[:, 1] - math.pi) - 15 * o[:, 3])
        assert not over.any()
    assert np.all(abs(o[:, 1] - math.pi) < 0.02)
