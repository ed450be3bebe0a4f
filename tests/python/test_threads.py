"""Threads, forks and Ctrl-C: a machine is used by one at a time, waits are short, and nothing is corrupted."""
import gc
import os
import signal
import subprocess
import sys
import threading
import weakref

import numpy as np
import pytest
import yoke
from conftest import CRANK, example


def in_threads(count, work):
    """Runs work(k) in threads; raises what any of them raised."""
    errors = []

    def run(k):
        try:
            work(k)
        except BaseException as error:
            errors.append(error)

    threads = [threading.Thread(target=run, args=(k,)) for k in range(count)]
    for one in threads:
        one.start()
    for one in threads:
        one.join()
    if errors:
        raise errors[0]


def test_two_machines_in_two_threads_have_their_own_bits():
    want = yoke.parse(CRANK).sweep(theta=(0, 6), steps=500, of=["s", "A.force"])
    found = {}

    def work(k):
        found[k] = yoke.parse(CRANK).sweep(theta=(0, 6), steps=500, of=["s", "A.force"])

    in_threads(4, work)
    assert all(np.array_equal(t, want) for t in found.values())


def test_one_machine_in_many_threads_is_never_corrupted(crank):
    angles = np.linspace(0, 6, 40)
    want = [crank.solve(theta=float(a))["s"] for a in angles]

    def work(k):
        for _ in range(10):
            assert [crank.solve(theta=float(a))["s"] for a in angles] == want
            assert len(crank.configurations(theta=1.0)) == 2

    in_threads(4, work)


def test_one_simulation_in_many_threads_goes_on_as_one(crank):
    alone, shared = crank.simulation(), crank.simulation()
    for _ in range(200):
        alone.step(1e-3)
    in_threads(4, lambda k: [shared.step(1e-3) for _ in range(50)])
    assert shared.time == alone.time and shared["theta"] == alone["theta"]


def test_other_threads_run_during_a_long_call():
    m = yoke.parse(CRANK)
    ran = threading.Event()

    def other():
        ran.set()

    def look(part):
        # the call asks on its own thread; the other one runs while it computes
        ran.wait(60)

    thread = threading.Thread(target=other)
    started = []

    def first(part):
        if not started:
            started.append(part)
            thread.start()
        look(part)

    m.study(vary={"r": (0.04, 0.06, 20_000)}, over={"theta": (0, 6)}, of=["s"], progress=first, threads=1)
    thread.join()
    assert started and ran.is_set()


def test_progress_goes_from_0_to_1_and_what_it_raises_ends_the_call(crank):
    seen = []
    crank.study(vary={"r": (0.04, 0.06, 20_000)}, over={"theta": (0, 6)}, of=["s"], progress=seen.append, threads=2)
    assert seen == sorted(seen) and all(0 <= part <= 1 for part in seen)

    class Mine(Exception):
        pass

    def stop(part):
        raise Mine

    with pytest.raises(Mine):
        crank.study(vary={"r": (0.04, 0.06, 100_000)}, over={"theta": (0, 6)}, of=["s"], progress=stop, threads=2)
    assert crank.solve(theta=1.0)["s"] > 0


LONG = {
    "study": 'm.study(vary={"r": (0.04, 0.06, 3_000_000)}, over={"theta": (0, 6)}, of=["s"])',
    "simulate": 'm.simulate(to=1e6, steps=3)',
    "sweep": 'm.sweep(theta=(0, 1e5), steps=9_000_000, of=["s"])',
    "many": 'for _ in range(10**6): many.step(0.01)',
    "check": 'for k in range(10**9): m.solve(theta=k * 1e-3)',
    "step": 'm.simulation().step(1e6)',
}


@pytest.mark.parametrize("name", LONG)
def test_ctrl_c_ends_a_long_call_and_the_machine_goes_on(name, tmp_path):
    # A job in the background may inherit that Ctrl-C is ignored.
    program = f"""
import signal, yoke
signal.signal(signal.SIGINT, signal.default_int_handler)
m = yoke.parse({CRANK!r})
want = m.solve(theta=1.0)["s"]
many = m.simulations(50)
try:
    print("ready", flush=True)
    {LONG[name]}
except KeyboardInterrupt:
    assert m.solve(theta=1.0)["s"] == want
    print("ended")
"""
    run = subprocess.Popen([sys.executable, "-c", program], stdout=subprocess.PIPE, text=True)
    try:
        assert run.stdout.readline() == "ready\n"
        try:
            run.wait(0.3)
        except subprocess.TimeoutExpired:
            pass
        run.send_signal(signal.SIGINT)
        out, _ = run.communicate(timeout=60)
        assert out == "ended\n" and run.returncode == 0
    finally:
        run.kill()  # nothing that goes on for ever is left behind


def test_a_fork_keeps_what_nobody_used_and_gives_up_the_rest():
    program = f"""
import os, threading, yoke
m, busy = yoke.parse({CRANK!r}), yoke.parse({CRANK!r})
want = m.solve(theta=1.0)["s"]
inside, go = threading.Event(), threading.Event()
def look(part):
    inside.set()
    go.wait(60)
thread = threading.Thread(target=lambda: busy.study(vary={{"r": (0.04, 0.06, 20_000)}}, over={{"theta": (0, 6)}},
                                                    of=["s"], progress=look, threads=1))
thread.start()
inside.wait(60)
child = os.fork()
if child == 0:
    code = 1
    try:
        assert m.solve(theta=1.0)["s"] == want
        sim = m.simulation()
        sim.step(0.01)
        try:
            busy.solve()
        except yoke.ClosedError as error:
            assert "forked" in str(error)
            code = 0
    finally:
        os._exit(code)
_, status = os.waitpid(child, 0)
go.set()
thread.join()
assert busy.solve(theta=1.0)["s"] == want
print(os.waitstatus_to_exitcode(status))
"""
    run = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, timeout=120)
    assert run.stdout == "0\n", run.stderr


def test_many_simulations_go_on_in_both_processes_after_a_fork():
    program = f"""
import os, signal, numpy, yoke
m = yoke.parse({CRANK!r})
many, alone = m.simulations(6, threads=3), m.simulations(6, threads=1)
want = [alone.step(0.01).copy() for _ in range(3)]
assert numpy.array_equal(many.step(0.01), want[0])
child = os.fork()
if child == 0:
    signal.alarm(60)  # without threads of its own it would wait for ever
    code = 1
    try:
        good = numpy.array_equal(many.step(0.01), want[1])
        many.close()
        code = 0 if good else 2
    finally:
        os._exit(code)
_, status = os.waitpid(child, 0)
assert numpy.array_equal(many.step(0.01), want[1]) and numpy.array_equal(many.step(0.01), want[2])
many.close()
print(os.waitstatus_to_exitcode(status))
"""
    run = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, timeout=120)
    assert run.stdout == "0\n", run.stderr


def test_memory_is_given_back(crank):
    def use():
        for k in range(200):
            p = crank.solve(theta=k * 0.01)
            p.coordinates, p.points["rod.B"], p.energy
            t = crank.sweep(theta=(0, 1), steps=50, of=["s"])
            column = t["s"]
            del t
            assert column[0] > 0.2
            crank.simulation().close()
        gc.collect()

    def pages():
        return int(open("/proc/self/statm").read().split()[1])

    use()
    before = pages()
    for _ in range(5):
        use()
    assert pages() - before < 2000  # 8 MB, where a leak of every simulation would be far more


def test_nothing_waits_for_the_collector_of_cycles(crank_file):
    gc.collect()
    gc.disable()
    try:
        m = yoke.load(crank_file, r="60 mm")
        pose, table = m.solve(theta=1.0), m.sweep(theta=(0, 1), steps=3, of=["s"])
        sim, many = m.simulation(effort={"theta": 0.0}), m.simulations(3)
        sim.control(0.1, lambda s, t: None)
        sim.effort["theta"] = 1.0
        sim.step(0.3)
        m.check("s = s"), m.derive("loops"), m.batch(["s"], theta=[1.0, 2.0]), m.configurations()
        alive = [weakref.ref(one) for one in (m._kept, m._kept.facts, m._kept.start, sim, many, pose, m)]
        del m, pose, table, sim, many
        assert [one() for one in alive] == [None] * len(alive)
    finally:
        gc.enable()


def test_answers_outlive_what_made_them():
    t = yoke.parse(CRANK).sweep(theta=(0, 6), steps=1000, of=["s"])
    column, part = t["s"], t[10:20]
    want = column.copy()
    del t
    p = yoke.parse(CRANK).solve(theta=1.0)
    coordinates, reactions = p.coordinates, p.reactions
    del p
    gc.collect()
    others = [yoke.parse(CRANK).sweep(theta=(0, 6), steps=1000, of=["s"]) for _ in range(20)]
    again = [yoke.parse(CRANK).solve(theta=2.0) for _ in range(20)]
    assert np.array_equal(column, want) and np.array_equal(part["s"], want[10:20])
    fresh = yoke.parse(CRANK).solve(theta=1.0)
    assert coordinates["s"] == fresh.coordinates["s"] and reactions["A"] == fresh.reactions["A"]
    del others, again


def test_poses_do_not_disturb_each_other(crank):
    poses = [crank.solve(theta=k * 0.1) for k in range(50)]
    values = [p["s"] for p in poses]
    del poses[::2]
    more = [crank.solve(theta=3 + k * 0.1) for k in range(50)]
    assert [p["s"] for p in poses] == values[1::2] and len({p["s"] for p in more}) == 50


@pytest.mark.skipif(not hasattr(os, "fork"), reason="needs fork")
def test_the_examples_work_after_a_plain_fork():
    m = yoke.load(example("four-bar"))
    child = os.fork()
    if child == 0:
        os._exit(0 if m.solve(theta2=1.0).status == "ok" else 1)
    assert os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]) == 0
