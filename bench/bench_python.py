"""Prints the figures of the Python package: its import, what a call adds, batches against C, many simulations.

    PYTHONPATH=build/release/python /usr/bin/python3 bench/bench_python.py
"""
from __future__ import annotations

import math
import os
import subprocess
import sys
import tempfile
import time
from pathlib import Path
from typing import Any, Callable

import numpy as np
import yoke
from yoke._native import ffi, lib

EXAMPLES = Path(__file__).resolve().parent.parent / "examples"


def best(work: Callable[[], object], rounds: int = 7) -> float:
    """Returns the shortest processor time of some rounds, s: other programs on the machine hardly disturb it."""
    times = []
    for _ in range(rounds):
        start = time.process_time()
        work()
        times.append(time.process_time() - start)
    return min(times)


def import_time() -> float:
    """Returns what `import yoke` takes after NumPy's import, s; the least of some fresh processes."""
    program = "import numpy, time; t = time.process_time(); import yoke; print(time.process_time() - t)"
    with tempfile.TemporaryDirectory() as cache:  # compiled once, as an installed package is
        environment = {k: v for k, v in os.environ.items() if k != "PYTHONDONTWRITEBYTECODE"}
        environment["PYTHONPYCACHEPREFIX"] = cache
        return min(float(subprocess.run([sys.executable, "-c", program], capture_output=True, text=True,
                                        env=environment).stdout) for _ in range(9))


def solve_cost() -> tuple[float, float]:
    """Returns what m.solve(theta=x) takes, and the library's part of it, s a call."""
    m = yoke.load(EXAMPLES / "slider-crank.yaml")
    angles = [1.05 + 1e-6 * k for k in range(2000)]

    def python() -> None:
        for x in angles:
            m.solve(theta=x)

    python()
    core = m._ready()
    plan = core.plan(["theta"])
    slot = plan.take()
    program = ffi.new("double[]", angles)

    def native() -> None:
        lib.yk_host_time_solve(slot.state, plan.entry, plan.holds, plan.move, program, len(angles))

    return best(python) / len(angles), best(native) / len(angles)


def step_cost() -> tuple[float, float]:
    """Returns what sim.step(h) takes, and the library's part of it, s a call."""
    m = yoke.load(EXAMPLES / "pendulum.yaml")
    count = 2000
    one, other = m.simulation(method="rk4", step=1e-3), m.simulation(method="rk4", step=1e-3)

    def python() -> None:
        step = one.step
        for _ in range(count):
            step(1e-3)

    return best(python) / count, best(lambda: lib.yk_host_time_steps(other._c, 1e-3, count)) / count


def batch_cost() -> tuple[float, float]:
    """Returns what a batch of 1e6 quick-return poses takes, and the library's call alone, s."""
    m = yoke.load(EXAMPLES / "quick-return.yaml")
    angles = np.linspace(0.6, 3.6, 1_000_000)
    names = ["d5", "d5.rate", "d5.accel"]
    out = np.zeros((3, len(angles)))
    plan = m._ready().plan(["theta1"], imposed=True)
    m.batch(names, theta1=angles, out=out)
    batch = plan.channels[("batch", *names)]  # type: ignore[index]
    inputs, outputs = ffi.new("double *[]", 3), ffi.new("double *[]", 3)
    inputs[0] = data = ffi.from_buffer("double[]", angles)
    rows = [ffi.from_buffer("double[]", row) for row in out]
    for c, row in enumerate(rows):
        outputs[c] = row
    status = np.zeros(len(angles), np.int8)
    flags = ffi.from_buffer("signed char[]", status)
    native = best(lambda: lib.yk_batch_run(batch, inputs, outputs, flags, len(angles)))
    del data
    return best(lambda: m.batch(names, theta1=angles, out=out)), native


def cart_pole(count: int, threads: Any = None) -> float:
    """Returns how many steps a second an environment of cart-poles takes."""
    m = yoke.load(EXAMPLES / "cart-pendulum.yaml")
    e = yoke.Environment(m, count, act=["x"], observe=["x", "theta", "x.rate", "theta.rate"], span=0.02, most=10**9,
                         start={"theta": (math.pi - 0.05, math.pi + 0.05)}, threads=threads)
    force = np.zeros((count, 1))
    return count * 20 / best(lambda: [e.step(force) for _ in range(20)], 3)


def numpy_cart_pole(count: int) -> float:
    """Returns the same for the textbook's two equations in NumPy, with the same Runge-Kutta steps."""
    mass, pole, half, g = 2.0, 0.5, 0.3, 9.81

    def rates(state: Any, force: Any) -> Any:
        x, q, v, w = state
        s, c = np.sin(q), np.cos(q)
        a11, a12, a22 = mass + pole, pole * half * c, pole * half * half * 4 / 3
        b1, b2 = force - 0.3 * v + pole * half * s * w * w, -pole * g * half * s
        d = a11 * a22 - a12 * a12
        return np.array([v, w, (b1 * a22 - b2 * a12) / d, (a11 * b2 - a12 * b1) / d])

    state, h = np.array([np.zeros(count), np.full(count, 3.1), np.zeros(count), np.zeros(count)]), 0.02

    def step() -> None:
        nonlocal state
        k1 = rates(state, 0.0)
        k2 = rates(state + h / 2 * k1, 0.0)
        k3 = rates(state + h / 2 * k2, 0.0)
        state = state + h / 6 * (k1 + 2 * k2 + 2 * k3 + rates(state + h * k3, 0.0))

    return count * 20 / best(lambda: [step() for _ in range(20)], 3)


def mujoco_cart_pole() -> "float | None":
    """Returns how many steps a second MuJoCo takes on one thread, where it is installed."""
    try:
        import mujoco  # type: ignore[import]
    except ImportError:
        return None
    model = mujoco.MjModel.from_xml_string("""<mujoco><option timestep="0.02" integrator="RK4"/><worldbody><body>
      <joint type="slide" axis="1 0 0"/><geom size=".1" mass="2"/><body><joint axis="0 1 0"/>
      <geom type="capsule" fromto="0 0 0 0 0 -.6" size=".02" mass=".5"/></body></body></worldbody></mujoco>""")
    data = mujoco.MjData(model)
    return 2000 / best(lambda: [mujoco.mj_step(model, data) for _ in range(2000)], 3)


def main() -> None:
    """Measures and prints."""
    print(f"import yoke, beyond NumPy       {1e3 * import_time():8.1f} ms    (asked: at most 80)")
    for name, (whole, core) in (("m.solve(theta=x)", solve_cost()), ("sim.step(1e-3)", step_cost())):
        print(f"{name:24s}        {1e6 * whole:8.2f} us    library {1e6 * core:.2f} us, "
              f"Python {1e6 * (whole - core):.2f} us (asked: at most 3)")
    whole, core = batch_cost()
    print(f"batch of 1e6 quick-return poses {1e3 * whole:8.1f} ms    C {1e3 * core:.1f} ms, "
          f"{whole / core:.3f} x (asked: 1.1)")
    print(f"4096 cart-poles, Yoke           {cart_pole(4096, 1):8.3g} steps/s on one thread")
    print(f"4096 cart-poles, NumPy          {numpy_cart_pole(4096):8.3g} steps/s")
    other = mujoco_cart_pole()
    print("cart-pole, MuJoCo               " + ("not installed" if other is None else f"{other:8.3g} steps/s"))


if __name__ == "__main__":
    main()
