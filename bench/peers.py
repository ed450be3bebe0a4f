#!/usr/bin/env python3
"""Peers, where they are installed: lines "peer<TAB>task<TAB>peer<TAB>time". None is needed."""
import importlib.util
import subprocess
import sys
import time


def found(name):
    return importlib.util.find_spec(name) is not None


def best(run, count, rounds=5):
    times = []
    for _ in range(rounds):
        start = time.process_time()
        run()
        times.append((time.process_time() - start) / count * 1e9)
    return sorted(times)[rounds // 2]


def quick_return():
    """The closed form in NumPy, in chunks that stay in cache."""
    import numpy as np
    n, chunks, w, al = 4096, 100, -0.5, 0.0
    t = np.linspace(0, np.pi, n)

    def pose():
        s1, c1 = np.sin(t), np.cos(t)
        x, y = 0.75 * c1, 0.75 * s1 + 1
        d3 = np.sqrt(x * x + y * y)
        c2, s2 = x / d3, y / d3
        s24 = (2 - 1.75 * s2) * 1.5
        c24 = np.sqrt((1 - s24) * (1 + s24))
        xd, yd = -0.75 * s1 * w, 0.75 * c1 * w
        xdd, ydd = -0.75 * (c1 * w * w + s1 * al), 0.75 * (c1 * al - s1 * w * w)
        d3d, t2d = c2 * xd + s2 * yd, (c2 * yd - s2 * xd) / d3
        d3dd, t2dd = c2 * xdd + s2 * ydd + d3 * t2d * t2d, (c2 * ydd - s2 * xdd - 2 * d3d * t2d) / d3
        w24 = -1.75 * c2 * t2d / (c24 / 1.5)
        a24 = (s24 / 1.5 * w24 * w24 - 1.75 * (c2 * t2dd - s2 * t2d * t2d)) / (c24 / 1.5)
        return (np.arctan2(y, x), d3, np.arcsin(s24), 1.75 * c2 + c24 / 1.5, t2d, d3d, w24,
                -1.75 * s2 * t2d - s24 / 1.5 * w24, t2dd, d3dd, a24,
                -1.75 * (s2 * t2dd + c2 * t2d * t2d) - (s24 * a24 + c24 * w24 * w24) / 1.5)

    def run():
        for _ in range(chunks):
            pose()
    run()
    print("peer\tquick-return, in batches, a pose\tNumPy %s, closed form by hand\t%.3g ns" % (np.__version__, best(run, n * chunks)))


def pendulum():
    """One evaluation of the double pendulum's dynamics by MuJoCo."""
    import mujoco
    xml = """<mujoco><option gravity="0 0 -9.81"/><worldbody><body><joint axis="0 1 0"/>
      <inertial pos="0 0 -0.35" mass="0.5" diaginertia="0.025 0.025 0.0001"/><body pos="0 0 -0.5"><joint axis="0 1 0"/>
      <inertial pos="0 0 -0.3" mass="0.4" diaginertia="0.02 0.02 0.0001"/></body></body></worldbody></mujoco>"""
    model = mujoco.MjModel.from_xml_string(xml)
    data = mujoco.MjData(model)

    def run():
        for _ in range(20000):
            mujoco.mj_forward(model, data)
    print("peer\tdouble pendulum, one right-hand side\tMuJoCo %s, mj_forward from Python\t%.3g ns" % (mujoco.__version__, best(run, 20000)))


def main():
    """Debian's python3 may have what the present one has not."""
    if not found("numpy") and sys.executable != "/usr/bin/python3":
        try:
            if subprocess.run(["/usr/bin/python3", "-c", "import numpy"], stderr=subprocess.DEVNULL, check=False).returncode == 0:
                sys.exit(subprocess.run(["/usr/bin/python3", __file__], check=False).returncode)
        except OSError:
            pass
    if found("numpy"):
        quick_return()
    if found("mujoco"):
        pendulum()


main()
